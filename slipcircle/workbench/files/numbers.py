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
from slipcircle.base.errors import raise_all
from slipcircle.base.kinds import Pair, ValueDict
from slipcircle.base.text import output_unit
from slipcircle.core import Scene
from slipcircle.tree import leaves, path_of_part
from slipcircle.workbench.common.distributions import (
    Gaussian,
    Triangle,
    distribution_mistakes,
    distribution_of,
    distribution_record,
)
from slipcircle.workbench.common.units import published, suffix
from slipcircle.workbench.files.keys import Key as Key
from slipcircle.workbench.files.keys import keys_of

_POINTS = ("circle.centre_m", "ground.points_m", "water.level_m")
_RULE = "a point's coordinate by its number from 0, such as ground.points_m.3.y"


def lengths(arc: Any) -> set[str]:
    """Return the names of coordinates and radii of a section; empty for an arc without a position.

    Their size depends on the distance from the origin, or on the flatness of the circle.
    """
    if "ground" not in arc.quantities:
        return set()
    return {"radius", *(leaf.path for leaf in leaves(arc) if leaf.number.key in ("x", "y"))}


def by_key(scene: Any) -> dict[str, Key]:
    """Return the declarations of the numbers that a scene with its friction and mass may have, by key."""
    keys = dict[str, Key]()
    for path, full, p, _ in leaves(scene):
        for name, key in keys_of(p).items():
            spelt = path_of_part(full.rpartition(".")[0], name)
            spelt = f"slip.{spelt}" if spelt.startswith("rate.") else spelt
            beside_law = spelt.replace(".cohesion.cohesion_kPa", ".cohesion_kPa")  # of a soil, which may have a law
            keys |= {one: replace(key, key=one, name=path) for one in (beside_law, spelt)}
    return keys


def in_output_unit(number: Key) -> Key:
    """Return a number with its key in the unit chosen for output, such as `cohesion.cohesion_psf`."""
    factor, unit = output_unit(number.unit)
    if factor == 1.0:
        return number
    key = number.key.removesuffix(suffix(number.written)) + suffix(unit)
    return number.in_unit(key, unit, 1.0 / (factor * number.per_unit))


def by_name(scene: Any) -> dict[str, Key]:
    """Return the declarations of a scene's numbers by name, with friction in degrees and rate factors as numbers."""
    declarations = reversed(by_key(scene).values())
    return {n.name: n for n in declarations if not (n.tangent and n.name.startswith(("friction.rate.", "rate.")))}


def number_in(scene: Any, path: str) -> Key:
    """Return the declaration of a number of a scene by its key or name, also of a number without a value.

    `path` is a key such as "friction.angle_deg" or a name such as "friction".
    """
    keys = by_key(scene)
    path = str(path)
    only = [k for k in keys if path in EFFECTS and k.startswith(f"{path}.")]
    path = only[0] if len(only) == 1 else path  # of an effect with one number
    if path in keys:
        return keys[path]
    parts = path.split(".")
    for k, part in enumerate(parts):
        key, unit, ratio = published(part)
        spelling = ".".join([*parts[:k], key, *parts[k + 1 :]])
        if spelling in keys:
            return keys[spelling].in_unit(path, unit, ratio)
    for n in keys.values():
        if n.name == path and not n.tangent:  # a friction has two keys, its angle and itself
            return n.plain
    near = get_close_matches(path, keys, 1)
    suggestion = "".join(f"; did you mean {n}?" + f" {_RULE}" * n.startswith(_POINTS) for n in near)
    raise ValueError(f"{path}: is not a parameter of this scene{suggestion or '; known are ' + listed(keys)}")


def listed(keys: Collection[str]) -> str:
    """Return keys of a scene file as a comma-separated text, with all coordinates of points replaced by one rule."""
    plain = [k for k in keys if not k.startswith(_POINTS)]
    return ", ".join([*plain, *([_RULE] if len(plain) < len(keys) else [])])


@dataclass(frozen=True)
class Uncertain:
    """Uncertain number: its declaration and distribution, as in a scene file or frozen by SciPy, in the key's unit."""

    number: Key
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
        """Return the quantiles at probabilities `p` between 0 and 1, in the number's unit and the shape of `p`."""
        distribution = self.distribution
        return (distribution.ppf if hasattr(distribution, "ppf") else distribution.icdf)(p)

    @property
    def moments(self) -> Pair:
        """Mean and standard deviation in the number's unit."""
        distribution = self.distribution
        if isinstance(distribution, Gaussian | Triangle):
            return distribution.moments
        deviation = distribution.std if hasattr(distribution, "std") else distribution.standard_deviation
        return float(distribution.mean()), float(deviation())

    @property
    def record(self) -> ValueDict:
        """Key and distribution as values of JSON."""
        parameters = dict(self.given) if isinstance(self.given, Mapping) else distribution_record(self.given)
        return {"key": self.key} | parameters


def uncertain_numbers(scene: Scene) -> dict[str, Uncertain]:
    """Return the uncertain numbers of a scene by their names in `Scene.numbers`.

    Raises
    ------
    ValueError
        Lists every key that is not a number of the scene, and every invalid distribution.
    """
    uncertain: dict[str, Uncertain] = {}
    said = []
    for path, value in scene.uncertain.items():
        if isinstance(value, Uncertain):
            uncertain[path] = value
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
        if number.name in uncertain:
            said.append(f"uncertain.{path}: {uncertain[number.name].key} says the same; remove one")
        uncertain[number.name] = Uncertain(number, dict(value) if isinstance(value, Mapping) else value)
    values = scene.numbers
    said += [
        f"uncertain.{u.key}: the scene has no value of it to vary" for n, u in uncertain.items() if n not in values
    ]
    raise_all(f"Scene {scene.name}".rstrip(), said)
    return uncertain
