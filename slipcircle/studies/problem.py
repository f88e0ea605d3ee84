"""What a back-analysis is asked: observations, fields and where these may lie, closer where motions change faster."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated.effects import EFFECTS
from slipcircle.base.checks import raise_all
from slipcircle.motion.plan import plan
from slipcircle.motion.solver import lanes_of
from slipcircle.scene.friction import law_depends
from slipcircle.scene.numbers import DIP, Number, lengths, number_in
from slipcircle.scene.scene import Scene
from slipcircle.scene.variation import scenes_with, value_in
from slipcircle.studies.inversion import MOST_SWINGS, Space

Floats = NDArray[np.float64]
Observed = float | tuple[float, float]
Observations = Mapping[str, tuple[float, float | None]]
Bounds = tuple[float, float]


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
        raise ValueError(f"backanalyse: field = {field!r}, bounds = {bounds!r}: must be a key or a list of keys, and a "
                         "pair of numbers or a mapping from keys to such")  # fmt: skip
    given = dict.fromkeys(paths[:1], bounds) if isinstance(bounds, tuple) else dict(bounds or {})
    try:
        fields = [number_in(scene, path) for path in paths]
        limits = {number_in(scene, path).key: b for path, b in given.items()}
    except ValueError as error:
        raise ValueError(f"backanalyse: field: {error}") from error
    names, keys, ends = [f.name for f in fields], [f.key for f in fields], {"theta_1", "theta_2"}
    twice = sorted({f.key for f in fields if names.count(f.name) > 1})
    other = [key for key in limits if key not in keys]
    raise_all("backanalyse", [said for wrong, said in (
        (twice, f"field: {', '.join(twice)} is named twice"),
        (DIP.name in names and ends & {*names},
         "field: arc.dip_deg turns theta_1 and theta_2 together; leave it or them out"),
        (scene.arc.given is not None and {DIP.name, *ends} & {*names},
         "field: the arc's coefficients are given, and do not follow its angles"),
        (len(fields) > len(observed),
         f"{len(fields)} fields from {len(observed)} of what is observed ({', '.join(observed)}): they cannot be told "
         "apart; give as many observations as fields, or fewer fields"),
        (isinstance(bounds, tuple) and len(fields) > 1,
         f"bounds = {bounds!r}: of several fields give a mapping, such as {{{keys[0]!r}: {bounds!r}}}"),
        (other, f"bounds: {', '.join(other)} is none of the fields"),
    ) if wrong])  # fmt: skip
    ranges = [_between(f.key, *limits[f.key]) if f.key in limits else _range(scene, f, len(fields) == 1)
              for f in fields]  # fmt: skip
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
    speed, own = 2 * math.sqrt(gravity * radius), value_in(scene, field)
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
    elif field.name.startswith("friction") and (field.tangent or not field.unit):
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
    still, _ = scenes_with(scene, {field.name: np.zeros(1)})
    limit = float(lanes_of(plan(still)).statics["limit_friction"][0])
    limit = limit if 1e-6 < limit < math.inf else 1.0
    shares = [np.geomspace(0.5 / MOST_SWINGS, 1.0, 129), np.linspace(0.5 / MOST_SWINGS, 1.0, 129),
              1.0 - 10.0 ** -np.arange(3.0, 13.0)]  # fmt: skip
    if field.name == "friction" and scene.end_time is None and not any(EFFECTS[e].turns for e in scene.called):
        shares = [np.ones(1)]  # with less it never rests
    creeps = "speed" in law_depends(scene.friction)  # with more it creeps, which takes long to follow
    if alone and not creeps and (float(np.asarray(scene.initial_velocity)) != 0.0 or field.name != "friction"):
        shares.append(np.geomspace(1.0, 1e3, 61))
    if "shaking" in scene.called or not alone:  # it moves what would stand
        shares.append(np.linspace(1.0, max(3.0 / limit, 2.0), 81))
    return limit * np.concatenate(shares)
