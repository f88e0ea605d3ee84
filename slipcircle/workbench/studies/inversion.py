"""Back-analysis as a search: what is asked, over which ranges, and how it is met, all candidates at once.

Roots along one number for one observation; least squares over several numbers for several.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated.effects import EFFECTS
from slipcircle.base.checks import EPS, raise_all
from slipcircle.core.motion.plan import plan
from slipcircle.core.motion.solver import lanes_of
from slipcircle.core.motion.states import ANSWERED, Status
from slipcircle.core.scene.friction import law_depends
from slipcircle.core.scene.parameters import DIP, parameter_value, with_parameter_arrays
from slipcircle.core.scene.scene import Scene
from slipcircle.workbench.files.numbers import Number, lengths, number_in
from slipcircle.workbench.studies.motions import motions

Floats = NDArray[np.float64]
Kinds = NDArray[Any]  # of what kind each motion is
Observed = float | tuple[float, float]
Observations = Mapping[str, tuple[float, float | None]]
Bounds = tuple[float, float]
MOST_SWINGS = 12  # of a motion in a search: below, run-out hardly depends on friction, and has ever more solutions
PATIENCE = 100.0  # times sqrt(R/g), until which a motion without an end is followed: what creeps on takes too long
FINE = 1e-13  # accuracy of motions in a search
PARTS = 16  # of a stretch that is looked into: each round gains four bits
ROUNDS = 16
STEEP = 30.0  # per cent that an outcome may change with a per cent of the number, where the motion changes its kind
MET = 1e-9  # relative: a jump over what was observed misses it by more
STARTS, APART = 48, 0.03  # of fits, and shares of the ranges between them
STEPS = 80  # of a fit
SMALL = 1e-6  # step of differences, of a range


class Space:
    """What is looked for and where: fields of a scene over their ranges, and what was observed.

    As shares from 0 to 1 of the ranges, whose values are closer where motions change faster.
    """

    def __init__(
        self, scene: Scene, fields: Sequence[Number], ranges: Sequence[Floats], observed: Observations
    ) -> None:
        self.scene, self.fields, self.ranges, self.observed = scene, fields, ranges, observed
        self.weighed = all(sigma is not None for _, sigma in observed.values())  # all standard errors, or none
        self.seen, self.sizes = np.array([(seen, sigma or abs(seen)) for seen, sigma in observed.values()]).T

    @property
    def free(self) -> int:
        """Degrees of freedom."""
        return len(self.observed) - len(self.fields)

    def sampled(self, values: Floats) -> tuple[Floats, Kinds]:
        """What would be observed at values (fields, count) in the fields' units, and of what kind the motions are.

        NaN where they do not count: those do that move, and rest or end before long.
        """
        scene = self.scene
        until = PATIENCE * float(scene.arc.time_scale)
        followed = scene if scene.end_time is not None else replace(scene, end_time=until, uncertain={})
        motion = motions(followed, {f.name: f.to_si(v) for f, v in zip(self.fields, values, strict=True)}, FINE)
        counts = np.isin(motion.status, ANSWERED) & motion.moves & (motion.turnings <= MOST_SWINGS)
        if scene.end_time is None:
            counts &= motion.status != Status.MOVING
        kind = np.where(counts, 10 * motion.turnings + motion.status, -1)
        return np.where(counts, np.stack([motion.outcomes[n] for n in self.observed]), np.nan), kind

    def at(self, shares: Floats) -> Floats:
        """Values of shares, (fields, count)."""
        pairs = zip(shares, self.ranges, strict=True)
        return np.stack([np.interp(share, np.linspace(0.0, 1.0, len(r)), r) for share, r in pairs])

    def residuals(self, shares: Floats) -> Floats:
        """Computed less observed, in standard errors or as shares of what was observed, (observations, count)."""
        found, _ = self.sampled(self.at(shares))
        return (found - self.seen[:, None]) / self.sizes[:, None]

    def changes(self, shares: Floats) -> tuple[Floats, Floats]:
        """Residuals, and their derivatives by the shares, (observations, fields, count): to the side that is known."""
        k, count = shares.shape
        moved = np.repeat(shares[:, None, :], 1 + 2 * k, axis=1)
        for f in range(k):
            moved[f, 1 + 2 * f] = np.minimum(shares[f] + SMALL, 1.0)
            moved[f, 2 + 2 * f] = np.maximum(shares[f] - SMALL, 0.0)
        r = self.residuals(moved.reshape(k, -1)).reshape(-1, 1 + 2 * k, count)
        known = ~np.isnan(r).any(axis=0)
        r, moved = np.where(known, r, r[:, :1]), np.where(known, moved, shares[:, None])
        width = np.stack([moved[f, 1 + 2 * f] - moved[f, 2 + 2 * f] for f in range(k)])
        return r[:, 0], (r[:, 1::2] - r[:, 2::2]) / np.maximum(width, 1e-300)


# --- what is asked ---------------------------------------------------------------------------------------------------


def observations(given: Mapping[str, Observed | None]) -> dict[str, tuple[float, float | None]]:
    """Values and standard errors of what is observed."""
    found, wrong = {}, []
    for name, value in given.items():
        if value is None:
            continue
        try:
            seen, sigma = map(float, value) if isinstance(value, (tuple, list)) else (float(value), None)
        except (TypeError, ValueError):
            seen, sigma = math.nan, None
        positive = sigma is None or 0.0 < sigma < math.inf
        if not positive or not math.isfinite(seen) or seen == 0.0 or (name == "duration" and seen < 0.0):
            least = "a positive number" if name == "duration" else "a number other than 0"
            wrong.append(f"{name} = {value!r}: must be {least}, or it and its positive standard error")
        else:
            found[name] = (seen, sigma)
    if not found and not wrong:
        wrong.append(f"nothing observed: give one of {', '.join(given)}")
    if len({sigma is None for _, sigma in found.values()}) > 1:
        wrong.append("standard errors: give them for all observations, or for none")
    raise_all("backanalyse", wrong)
    return found


def search_space(scene: Scene, field: Any, bounds: Any, observed: Observations) -> Space:
    """The fields over their ranges, in their units."""
    paths = [field] if isinstance(field, str) else list(field) if isinstance(field, Sequence) else []
    if not paths or not isinstance(bounds, tuple | Mapping | None):
        raise ValueError(
            f"backanalyse: field = {field!r}, bounds = {bounds!r}: must be a key or a list of keys, and a "
            "pair of numbers or a mapping from keys to such"
        )
    given = dict.fromkeys(paths[:1], bounds) if isinstance(bounds, tuple) else dict(bounds or {})
    try:
        fields = [number_in(scene, path) for path in paths]
        limits = {number_in(scene, path).key: b for path, b in given.items()}
    except ValueError as error:
        raise ValueError(f"backanalyse: field: {error}") from error
    names, keys, ends = [f.name for f in fields], [f.key for f in fields], {"theta_1", "theta_2"}
    twice = sorted({f.key for f in fields if names.count(f.name) > 1})
    other = [key for key in limits if key not in keys]
    raise_all(
        "backanalyse",
        [
            said
            for wrong, said in (
                (twice, f"field: {', '.join(twice)} is named twice"),
                (
                    DIP.name in names and ends & {*names},
                    "field: arc.dip_deg turns theta_1 and theta_2 together; leave it or them out",
                ),
                (
                    scene.arc.given is not None and {DIP.name, *ends} & {*names},
                    "field: the arc's coefficients are given, and do not follow its angles",
                ),
                (
                    len(fields) > len(observed),
                    f"{len(fields)} fields from {len(observed)} of what is observed ({', '.join(observed)}): they "
                    "cannot be told apart; give as many observations as fields, or fewer fields",
                ),
                (
                    isinstance(bounds, tuple) and len(fields) > 1,
                    f"bounds = {bounds!r}: of several fields give a mapping, such as {{{keys[0]!r}: {bounds!r}}}",
                ),
                (other, f"bounds: {', '.join(other)} is none of the fields"),
            )
            if wrong
        ],
    )
    ranges = [
        _between(f.key, *limits[f.key]) if f.key in limits else _range(scene, f, len(fields) == 1) for f in fields
    ]
    return Space(scene, fields, ranges, observed)


def _between(name: str, low: float, high: float) -> Floats:
    if not (math.isfinite(low) and math.isfinite(high) and low < high):
        raise ValueError(
            f"backanalyse: bounds of {name} = ({low!r}, {high!r}): must be two numbers, the lower one first"
        )
    return np.geomspace(low, high, 401) if 0.0 < 100 * low < high else np.linspace(low, high, 401)


def _range(scene: Scene, field: Number, alone: bool) -> Floats:
    """From the least to the greatest value where no bounds are given; farther where other fields change as well."""
    arc = scene.arc
    stress, radius, gravity = (float(np.asarray(v)) for v in (arc.static_normal_stress, arc.radius, arc.gravity))
    speed, own = 2 * math.sqrt(gravity * radius), parameter_value(scene, field.name)
    near = np.concatenate([np.linspace(0.0, 1.0, 81)[:-1], 1.0 - 10.0 ** -np.arange(2.0, 13.0, 2.0)])
    theta_1, theta_2 = (float(np.asarray(scene.numbers.get(n, 0.0))) for n in ("theta_1", "theta_2"))
    ranges: Mapping[str, Floats] = {
        "initial_velocity": np.linspace(-speed, speed, 241),
        "dip": np.pi / 2 * np.concatenate([-near[:0:-1], near]),
        "theta_1": theta_2 - np.pi * near[1:],
        "theta_2": theta_1 + np.pi * near[1:],
        "cohesion.cohesion": np.concatenate([[0.0], stress * np.geomspace(1e-6, 100.0, 161)]),
        "pore_pressure.ratio": near,
        "pore_pressure.pressure": stress * near,
        "drag.xi": gravity * np.geomspace(1e-3, 1e9, 193),
        "friction.length": radius * np.geomspace(1e-9, 10.0, 161),
    }
    if field.name in ranges:
        values = ranges[field.name]
    elif field.name.startswith("friction") and ".rate." not in field.name and (field.tangent or not field.unit):
        values = _frictions(scene, field, alone)
    elif own is None:
        raise ValueError(f"backanalyse: field = {field.key!r}: give bounds, as the scene has no value of it")
    elif field.name in lengths(arc):
        values = own + radius * np.linspace(-1.0, 1.0, 401)  # in place of it
    else:
        values = (abs(own) or 1.0) * np.geomspace(1e-3, 1e3, 121)
    return np.unique(field.from_si(values))


def _frictions(scene: Scene, field: Number, alone: bool) -> Floats:
    """From so little that the mass swings to the limit, beyond which nothing moves from rest."""
    still, _ = with_parameter_arrays(scene, {field.name: np.zeros(1)})
    limit = float(lanes_of(plan(still)).statics["limit_friction"][0])
    limit = limit if 1e-6 < limit < math.inf else 1.0
    shares = [
        np.geomspace(0.5 / MOST_SWINGS, 1.0, 129),
        np.linspace(0.5 / MOST_SWINGS, 1.0, 129),
        1.0 - 10.0 ** -np.arange(3.0, 13.0),
    ]
    if field.name == "friction" and scene.end_time is None and not any(EFFECTS[e].turns for e in scene.called):
        shares = [np.ones(1)]  # with less it never rests
    creeps = "speed" in law_depends(scene.friction)  # with more it creeps, which takes long to follow
    if alone and not creeps and (float(np.asarray(scene.initial_velocity)) != 0.0 or field.name != "friction"):
        shares.append(np.geomspace(1.0, 1e3, 61))
    if "shaking" in scene.called or not alone:  # it moves what would stand
        shares.append(np.linspace(1.0, max(3.0 / limit, 2.0), 81))
    return limit * np.concatenate(shares)


# --- one number, one observation -------------------------------------------------------------------------------------


def roots(space: Space) -> list[float]:
    """All values at which an outcome is as wanted: every stretch that may hold one is divided, all of them at once.

    That is where the outcome passes it, where the motion changes its kind near it, and where the outcome turns back
    next to it.
    """
    rows, found, wanted = space.ranges[0][None, :], list[float](), float(space.seen[0])
    for _ in range(ROUNDS):
        y, kind = (a.reshape(rows.shape) for a in space.sampled(rows.reshape(1, -1)))
        left, right = _worth_a_look(rows, y - wanted, kind, abs(wanted))
        fine = right - left <= 4 * EPS * np.maximum(np.abs(left), np.abs(right))
        found += left[fine].tolist() + right[fine].tolist()
        left, right = left[~fine], right[~fine]
        if not left.size:
            break
        rows = left[:, None] + (right - left)[:, None] * np.linspace(0.0, 1.0, PARTS + 1)
        rows[:, -1] = right
    ends = np.unique(found)
    miss = np.abs(space.sampled(ends[None])[0][0] - wanted) if found else ends
    ends, miss = ends[miss <= MET * abs(wanted)], miss[miss <= MET * abs(wanted)]
    apart = np.flatnonzero(np.diff(ends) > MET * np.abs(ends[1:])) + 1
    both = zip(np.split(ends, apart), np.split(miss, apart), strict=True)
    return [float(near[np.argmin(off)]) for near, off in both if near.size]


def _worth_a_look(x: Floats, miss: Floats, kind: Kinds, wanted: float) -> tuple[Floats, Floats]:
    """Both ends of the stretches within rows that may hold a root."""
    a, b, left, right = miss[:, :-1], miss[:, 1:], x[:, :-1], x[:, 1:]
    share = (right - left) / np.maximum(np.maximum(np.abs(left), np.abs(right)), 1e-300)
    with np.errstate(invalid="ignore"):
        near = np.fmin(np.abs(a), np.abs(b)) <= STEEP * np.minimum(share, 1.0) * wanted
        passes = (a * b <= 0.0) | ((kind[:, :-1] != kind[:, 1:]) & near)
        size = np.abs(miss)
        before, here, after = size[:, :-2], size[:, 1:-1], size[:, 2:]
        turns = (here <= np.fmin(before, after)) & (2 * here <= np.fmax(before, after))
        turns &= (a[:, :-1] * b[:, :-1] > 0.0) & (a[:, 1:] * b[:, 1:] > 0.0)
    return (np.concatenate([left[passes], x[:, :-2][turns]]), np.concatenate([right[passes], x[:, 2:][turns]]))


def extreme(space: Space, sign: float) -> float:
    """Where the greatest (sign 1) or least (sign -1) outcome is found; NaN where no motion counts."""
    best, values = (-math.inf, math.nan), space.ranges[0]
    for _ in range(ROUNDS):
        y = np.nan_to_num(sign * space.sampled(values[None])[0][0], nan=-math.inf)
        k = int(np.argmax(y))
        best = max(best, (float(y[k]), float(values[k])))
        values = np.linspace(values[max(k - 1, 0)], values[min(k + 1, len(values) - 1)], 2 * PARTS + 1)
    return best[1]


# --- least squares ---------------------------------------------------------------------------------------------------


class Fit(NamedTuple):
    """Where the observations are best met: shares of the ranges, sum of squares, whether no step makes it smaller."""

    shares: Floats
    chi_square: float
    settled: bool


def fits(space: Space, shares: Floats) -> list[Fit]:
    """All different minima that are reached from the best of these shares, (fields, count), the best first."""
    r = space.residuals(shares)
    chosen = list[int]()
    for k in np.argsort(np.sum(r**2, axis=0)):  # NaN comes last
        if len(chosen) == STARTS or np.isnan(r[0, k]):
            break
        if all(np.max(np.abs(shares[:, k] - shares[:, o])) > APART for o in chosen):
            chosen.append(int(k))
    if not chosen:
        return []
    s, r, slopes, settled = _descended(space, shares[:, chosen])
    found: list[Fit] = []
    told = 1.0 if space.weighed else 1e-3  # apart, in standard errors or shares
    for k in np.argsort(np.sum(r**2, axis=0)):
        fit = Fit(s[:, k], float(np.sum(r[:, k] ** 2)), bool(settled[k]))
        off = [s[:, k] - other.shares for other in found]
        if not any(np.max(np.abs(o)) < 1e-5 or np.max(np.abs(slopes[:, :, k] @ o)) < told for o in off):
            found.append(fit)
    return [f for f in found if f.settled] or found


def _descended(space: Space, s: Floats) -> tuple[Floats, Floats, Floats, NDArray[np.bool_]]:
    """Levenberg and Marquardt's steps from all starts at once; a field at the end of its range is left there."""
    damping = np.full(s.shape[1], 1e-3)
    r, slopes = space.changes(s)
    for _ in range(STEPS):
        matrix, push = np.einsum("ofn,ogn->nfg", slopes, slopes), -np.einsum("ofn,on->nf", slopes, r)
        held = (((s <= 0.0) & (push.T < 0.0)) | ((s >= 1.0) & (push.T > 0.0))).T
        size = np.einsum("nff->nf", matrix)
        matrix = matrix * ~(held[:, :, None] | held[:, None, :])
        diagonal = np.where(held, 1.0, size * (1.0 + damping[:, None]) + 1e-30)
        np.einsum("nff->nf", matrix)[...] = diagonal
        step = np.linalg.solve(matrix, np.where(held, 0.0, push)[..., None])[..., 0].T
        trial = np.clip(s + np.clip(step, -0.25, 0.25), 0.0, 1.0)
        new, new_slopes = space.changes(trial)
        better = np.sum(new**2, axis=0) < np.sum(r**2, axis=0)  # not where nothing moves
        s, r, slopes = np.where(better, trial, s), np.where(better, new, r), np.where(better, new_slopes, slopes)
        damping = np.clip(np.where(better, damping / 8, damping * 4), 1e-15, 1e12)
        if np.all(~better & (damping > 1e8)) or np.max(np.abs(step)) < 1e-14:
            break
    length = np.linalg.norm(slopes, axis=0) * np.linalg.norm(r, axis=0)
    push = -np.einsum("ofn,on->fn", slopes, r) / np.where(length > 0.0, length, 1.0)
    still = (np.abs(push) < 1e-3) | ((s <= 0.0) & (push < 0.0)) | ((s >= 1.0) & (push > 0.0))
    return s, r, slopes, np.all(still, axis=0) | (np.linalg.norm(r, axis=0) < 1e-7)
