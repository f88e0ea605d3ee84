"""Several observations and several fields: least squares from many starts, and what the observations can tell."""

import math
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.checks import EPS
from slipcircle.motion.motion import Motion
from slipcircle.motion.plan import INTEGRATION, plan
from slipcircle.scene.scene import Scene
from slipcircle.studies.fields import OBSERVED, ROUGH, Field, attempt, exact, outputs_of, slopes

Floats = NDArray[np.float64]
Observations = Mapping[str, tuple[float, float | None]]
_STEP = 1e-10  # relative, after which a fit ends: near a minimum the next one is far smaller
_FAR = 1e8  # residual of what is no motion: the steps turn away from it
_APART = 0.1  # of the range, in one field at least, between two starts
_SAME = 1e-5  # relative, of two solutions
_STILL = 1e-4  # cosine between the residuals and what a field changes, at a minimum


class Fit(NamedTuple):
    """Where the observations are best met: values of the fields, sum of squares, whether no step makes it smaller."""

    values: Floats
    chi_square: float
    settled: bool


def scene_with(scene: Scene, fields: Sequence[Field], values: Sequence[float]) -> Scene:
    """The scene with a value of each field."""
    for field, value in zip(fields, values, strict=True):
        scene = field.put(scene, float(value))
    return scene


def residuals(motion: Motion, observed: Observations) -> Floats:
    """Computed less observed, in standard errors, or as shares of the observed values where those are unknown."""
    found = outputs_of(motion, [OBSERVED[n] for n in observed])
    return np.array([(found[OBSERVED[n]] - seen) / (sigma or abs(seen)) for n, (seen, sigma) in observed.items()])


def changes(fields: Sequence[Field], motion: Motion, observed: Observations) -> Floats:
    """Derivatives of the residuals by the fields, (observations, fields)."""
    sizes = np.array([sigma or abs(seen) for seen, sigma in observed.values()])
    return slopes(fields, motion, [OBSERVED[n] for n in observed]) / sizes[:, None]


def refined(
    scene: Scene, fields: Sequence[Field], observed: Observations, start: Floats, low: Floats, high: Floats,
    accuracy: float | None = None,
) -> Fit | None:  # fmt: skip
    """The minimum that a start leads to (SciPy's trust region reflective), with the exact Jacobian where there is one.

    None where no motion is found there.
    """
    try:
        from scipy.optimize import least_squares
    except ImportError as error:
        raise ImportError("several observations need SciPy: pip install 'slipcircle[scenes]'") from error
    wide = (low > 0.0) & (high > 1e3 * low)  # these are searched by their logarithm
    ratio, span = np.where(wide, high / np.where(wide, low, 1.0), 1.0), high - low
    latest: list[tuple[Any, Motion | None]] = [(None, None)]

    def at(share: Any) -> Any:
        return np.where(wide, low * ratio**share, low + span * share)

    def motion_at(share: Any) -> Motion | None:
        if latest[0][0] is None or not np.array_equal(latest[0][0], share):
            try:
                latest[0] = np.array(share), attempt(scene_with(scene, fields, at(share)), accuracy)
            except ValueError:
                latest[0] = np.array(share), None
        found = latest[0][1]
        return found if found is not None and found.moves else None

    def missed(share: Any) -> Any:
        motion = motion_at(share)
        return np.full(len(observed), _FAR) if motion is None else residuals(motion, observed)

    def jacobian(share: Any) -> Any:
        motion = motion_at(share)
        assert motion is not None
        return np.nan_to_num(changes(fields, motion, observed)) * np.where(wide, at(share) * np.log(ratio), span)

    share = (start - low) / span
    share[wide] = np.log(start[wide] / low[wide]) / np.log(ratio[wide])
    inside = np.clip(share, 1e-9, 1.0 - 1e-9)
    if motion_at(inside) is None:
        return None
    found = least_squares(missed, inside, jacobian, bounds=(0.0, 1.0), x_scale="jac", max_nfev=60,
                          xtol=_STEP, ftol=1e-15, gtol=1e-15)  # fmt: skip
    size = np.linalg.norm(found.fun)
    steep = np.linalg.norm(found.jac, axis=0) * size
    push = -(found.jac.T @ found.fun) / np.where(steep > 0.0, steep, 1.0)  # the way in which it would shrink
    outward = np.where(push > 0.0, found.x > 1.0 - 1e-7, found.x < 1e-7)
    settled = bool(size < 1e-7 or np.all((np.abs(push) < _STILL) | outward))
    return Fit(at(found.x), 2 * float(found.cost), settled)


def search(
    scene: Scene, fields: Sequence[Field], observed: Observations, ranges: Sequence[Sequence[float]]
) -> list[Fit]:
    """All different minima that are found from starts all over the ranges, the best first."""
    costly = plan(scene_with(scene, fields, [r[len(r) // 2] for r in ranges])).method == INTEGRATION
    count, most, rough = (24 * len(fields), 6, ROUGH) if costly else (256 * len(fields), 16, None)
    tried = []
    for share in _spread(count, len(fields)):
        values = np.array([np.interp(s, np.linspace(0, 1, len(r)), r) for s, r in zip(share, ranges, strict=True)])
        try:
            motion = attempt(scene_with(scene, fields, values.tolist()), rough)
        except ValueError:
            continue
        if motion is not None and motion.moves:
            tried.append((float(np.sum(residuals(motion, observed) ** 2)), share, values))
    starts: list[Floats] = []
    for _, share, _ in sorted(tried, key=lambda t: t[0]):
        if len(starts) < most and all(np.max(np.abs(share - other)) > _APART for other in starts):
            starts.append(share)
    low, high = np.array([r[0] for r in ranges]), np.array([r[-1] for r in ranges])
    found: list[Fit] = []
    for _, share, values in tried:
        if not any(share is s for s in starts):
            continue
        fit = refined(scene, fields, observed, values, low, high, rough)
        if fit is not None and not any(_same(f.values, fit.values, high - low) for f in found):
            found.append(fit)
    return sorted([f for f in found if f.settled] or found, key=lambda f: f.chi_square)


def _same(one: Floats, two: Floats, span: Floats) -> bool:
    return bool(np.all(np.abs(one - two) <= _SAME * (np.abs(one) + 1e-6 * span)))


def _spread(count: int, dimensions: int) -> Floats:
    """Points that fill the unit cube evenly, the same each time: multiples of powers of a generalised golden ratio.

    M. Roberts, The unreasonable effectiveness of quasirandom sequences, 2018.
    """
    ratio = 2.0
    for _ in range(60):
        ratio = (1.0 + ratio) ** (1.0 / (dimensions + 1))
    return np.asarray((0.5 + np.outer(np.arange(count), ratio ** -np.arange(1.0, dimensions + 1))) % 1.0)


def covariance(
    fields: Sequence[Field], values: Floats, motion: Motion, observed: Observations, scaled: Floats
) -> Floats | None:
    """Covariance of the fields to first order, from the standard errors, or else from the misfit that is left.

    It takes the `changes` there. Without either, as where one value without an error is met exactly, there is none.

    Raises
    ------
    ValueError
        If the observations do not tell the fields apart.
    """
    unit = np.where(values == 0.0, 1.0, np.abs(values))
    noise = 1e-10 if exact(motion) else 1e-3
    relative = scaled * unit  # residuals by relative changes
    size = np.linalg.norm(relative, axis=0)
    names = ", ".join(observed)
    if idle := [f.name for f, s in zip(fields, size, strict=True) if not s > noise * np.max(size)]:
        raise ValueError(f"backanalyse: {', '.join(idle)}: changes nothing of {names}, and cannot be found from it")
    _, singular, rows = np.linalg.svd(relative / size)
    if singular[-1] <= noise * singular[0]:
        way = rows[-1] / size
        way = way / np.max(np.abs(way))
        steps = " and ".join(f"{f.name} by {100 * w:+.3g} %" for f, w in zip(fields, way, strict=True))
        raise ValueError(f"backanalyse: changing {steps} changes nothing of {names}: they cannot be told apart by it")
    known = all(sigma is not None for _, sigma in observed.values())
    free = len(observed) - len(fields)
    if not known and not free:
        return None
    inverse = np.linalg.pinv(relative) * unit[:, None]
    return np.asarray(inverse @ inverse.T * (1.0 if known else np.sum(residuals(motion, observed) ** 2) / free))


def numerical_error(values: Floats, motion: Motion, observed: Observations, scaled: Floats) -> float:
    """What the motion's own error makes of the values, relative, by the `changes`; infinite where that is unknown."""
    relative = scaled * np.abs(values)
    if not np.all(np.isfinite(relative)) or not np.all(np.any(relative != 0.0, axis=0)):
        return math.inf
    outputs = outputs_of(motion, [OBSERVED[n] for n in observed])
    off = [motion.error_estimate * abs(outputs[OBSERVED[n]]) / (sigma or abs(seen))
           for n, (seen, sigma) in observed.items()]  # fmt: skip
    return float(max(np.max(np.abs(np.linalg.pinv(relative)) @ off), EPS))
