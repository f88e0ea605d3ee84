"""Numbers of a scene that may vary, by their keys and units in scene files.

A grid, an uncertain number, a back-analysis and a derivative name a number in the same way: by its key
(``friction.angle_deg``), or in SI units by its name in `Scene.numbers` (``friction``). The key of a coordinate consists
of the key of its list, the number of its point from 0, and x or y: ``ground.points_m.3.y``, in SI units ``ground.3.y``.
"""

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from difflib import get_close_matches
from functools import cached_property
from typing import Any

import numpy as np

from generated.effects import EFFECTS
from slipcircle.base.checks import raise_all
from slipcircle.base.kinds import Pair, ValueDict
from slipcircle.base.text import printed
from slipcircle.core import Scene, law_names
from slipcircle.derivatives import possible_parameters
from slipcircle.layers import LayeredSection
from slipcircle.workbench.common.distributions import (
    Gaussian,
    Triangle,
    distribution_mistakes,
    distribution_of,
    distribution_record,
)
from slipcircle.workbench.common.units import published, suffix
from slipcircle.workbench.files.keys import ARC_TABLE, VARYING, WITH_ARC, Table, fitted
from slipcircle.workbench.files.keys import Number as Number
from slipcircle.workbench.files.slopekeys import WITH_LAYERS


def numbers(tables: Mapping[str, Table]) -> dict[str, Number]:
    """Return the declarations of the numbers that tables of a scene file have, by key."""
    found = {}
    for path, table in tables.items():
        for k, key in table.keys.items():
            if key.kind in VARYING:
                constant = path.endswith("friction") and key.name == "coefficient"
                constant |= path.endswith(".cohesion") and key.name == "cohesion"  # of a soil
                within = path.removeprefix("slip.")
                of_scene = path in ("", "arc", "tension_crack")
                name = key.name if of_scene else path if constant else f"{within}.{key.name}"
                shown = f"{path}.{k}".lstrip(".")
                found[shown] = replace(key.number, key=shown, name=name)
    return found


DIP = Number("arc.dip_deg", "dip", "deg", 0.0, 90.0, True, np.pi / 180, si="rad")  # down-slope; turns both ends
_POINTS = {"centre": "circle.centre_m", "ground": "ground.points_m", "level": "water.level_m"}  # where files have them
_RULE = "a point's coordinate by its number from 0, such as ground.points_m.3.y"


def lengths(arc: Any) -> set[str]:
    """Return the names of coordinates and radii of a section; empty for an arc without a position.

    Their size depends on the distance from the origin, or on the flatness of the circle.
    """
    if "ground" not in arc.quantities:
        return set()
    return {name for name in arc.numbers_by_name() if name.partition(".")[0] in ("radius", *_POINTS)}


def _tables(scene: Any) -> dict[str, Table]:
    """Return the tables, by path, that a file of the scene may have with its laws."""
    arc = scene.arc
    if not isinstance(arc, LayeredSection):
        law, *rate = law_names(scene.friction)
        named = {} if law == "callable" else {"law": law}
        given: ValueDict = {"friction": named | ({"rate": {"law": rate[0]}} if rate else {})}
        return fitted(WITH_ARC, given | {"cohesion": scene.effects.get("cohesion", {})})
    soils = ValueDict()
    for soil in arc.soils:
        soils[soil.name] = {"friction": {"law": law_names(soil.friction)[0]}, "cohesion": soil.cohesion}
    given = {"soils": soils, "slip": {"rate": arc.rate or {}}, "layers": _some(arc.layers)}
    return {"arc": ARC_TABLE} | fitted(WITH_LAYERS, given | {"surcharge": _some(arc.surcharge)})


def _some(these: Collection[Any]) -> ValueDict:
    """Return empty tables named by the numbers 1 to n of n items."""
    return {f"{k}": {} for k in range(1, len(these) + 1)}


def by_key(scene: Any) -> dict[str, Number]:
    """Return the declarations of the numbers that a scene with its friction and arc may have, by key."""
    arc = scene.arc
    law = "constant" if isinstance(arc, LayeredSection) else law_names(scene.friction)[0]
    known = numbers(_tables(scene))
    if law == "callable":
        known = {k: n for k, n in known.items() if not n.name.startswith("friction")}
    if "ground" not in arc.quantities:
        return known | {DIP.key: DIP}
    found = {}
    for k, n in known.items():  # the file of a slope has the numbers of an arc in other tables
        if n.name in arc.quantities:
            k = k.replace("arc.", "circle." if n.name == "radius" else "ground.")
        if not k.startswith("arc."):
            found[k] = replace(n, key=k)
    coordinates = [p for p in possible_parameters(scene).values() if p.name.partition(".")[0] in _POINTS]
    for p in coordinates:
        field, _, place = p.name.partition(".")
        key = f"{_POINTS[field]}.{place}"
        found[key] = Number(key, p.name, p.unit, p.lower, p.upper, si=p.unit)
    return found


def in_output_unit(number: Number) -> Number:
    """Return a number with its key in the unit of output, such as ``cohesion.cohesion_psf``."""
    factor, unit = printed(number.si)
    if factor == 1.0:
        return number
    key = number.key.removesuffix(suffix(number.unit)) + suffix(unit)
    return number.in_unit(key, unit, 1.0 / (factor * number.per_unit))


def by_name(scene: Any) -> dict[str, Number]:
    """Return the declarations of a scene's numbers by name, with friction in degrees and rate factors as numbers."""
    found = reversed(by_key(scene).values())
    return {n.name: n for n in found if not (n.tangent and n.name.startswith(("friction.rate.", "rate.")))}


def number_in(scene: Any, path: str) -> Number:
    """Return the declaration of a number of a scene by its key or name, also of a number without a value."""
    known = by_key(scene)
    path = str(path)
    only = [k for k in known if path in EFFECTS and k.startswith(f"{path}.")]
    path = only[0] if len(only) == 1 else path  # of an effect with one number
    if path in known:
        return known[path]
    parts = path.split(".")
    for k, part in enumerate(parts):
        key, unit, ratio = published(part)
        spelling = ".".join([*parts[:k], key, *parts[k + 1 :]])
        if spelling in known:
            return known[spelling].in_unit(path, unit, ratio)
    for n in known.values():
        if n.name == path and not n.tangent:  # a friction has two keys, its angle and itself
            return n.plain
    near = get_close_matches(path, known, 1)
    asked = "".join(f"; did you mean {n}?" + f" {_RULE}" * n.startswith((*_POINTS.values(),)) for n in near)
    raise ValueError(f"{path}: is not a parameter of this scene{asked or '; known are ' + listed(known)}")


def listed(keys: Collection[str]) -> str:
    """Return keys as a comma-separated text, with all coordinates of points replaced by one rule."""
    plain = [k for k in keys if not k.startswith((*_POINTS.values(),))]
    return ", ".join([*plain, *([_RULE] if len(plain) < len(keys) else [])])


@dataclass(frozen=True)
class Uncertain:
    """Uncertain number: its declaration and distribution, as in a scene file or frozen by SciPy, in the key's unit."""

    number: Number
    given: Any

    @property
    def key(self) -> str:
        """Key of the number in the scene file."""
        return self.number.key

    @cached_property
    def distribution(self) -> Any:
        """Distribution as an object with the methods of SciPy's distributions."""
        return distribution_of(self.given) if isinstance(self.given, Mapping) else self.given

    def drawn(self, p: Any) -> Any:
        """Return the quantiles at probabilities ``p``, in the number's unit."""
        found = self.distribution
        return (found.ppf if hasattr(found, "ppf") else found.icdf)(p)

    @property
    def moments(self) -> Pair:
        """Mean and standard deviation in the number's unit."""
        found = self.distribution
        if isinstance(found, Gaussian | Triangle):
            return found.moments
        return float(found.mean()), float((found.std if hasattr(found, "std") else found.standard_deviation)())

    @property
    def record(self) -> ValueDict:
        """Key and distribution as values of JSON."""
        given = dict(self.given) if isinstance(self.given, Mapping) else distribution_record(self.given)
        return {"key": self.key} | given


def uncertain_numbers(scene: Scene) -> dict[str, Uncertain]:
    """Return the uncertain numbers of a scene by their names in `Scene.numbers`.

    Raises
    ------
    ValueError
        Lists every key that is not a number of the scene, and every invalid distribution.
    """
    found: dict[str, Uncertain] = {}
    said = []
    for path, value in scene.uncertain.items():
        if isinstance(value, Uncertain):
            found[path] = value
            continue
        try:
            number = number_in(scene, path)
        except ValueError as error:
            said.append(f"uncertain.{error}")
            continue
        if isinstance(value, Mapping):
            said += [f"uncertain.{path}: {m}" for m in distribution_mistakes(value, (number.low, number.high))]
        elif not hasattr(value, "ppf") and not hasattr(value, "icdf"):
            said.append(
                f"uncertain.{path} = {value!r}: must be a distribution: of scipy.stats, or a mapping such as "
                "{'distribution': 'normal', 'mean': 10, 'std': 1}"
            )
        elif np.shape(median := Uncertain(number, value).drawn(0.5)) or not np.isfinite(median):
            said.append(f"uncertain.{path} has the median {median}: must be the distribution of one number")
        if number.name in found:
            said.append(f"uncertain.{path}: {found[number.name].key} says the same; remove one")
        found[number.name] = Uncertain(number, dict(value) if isinstance(value, Mapping) else value)
    values = scene.numbers
    said += [f"uncertain.{u.key}: the scene has no value of it to vary" for n, u in found.items() if n not in values]
    raise_all(f"Scene {scene.name}".rstrip(), said)
    return found
