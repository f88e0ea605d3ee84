"""Numbers of a layered section: soils by name, tops of layers, surcharges, crack and law of speed.

Paths are ``soils.NAME.cohesion``, ``soils.NAME.friction.peak``, ..., ``layers.2.top`` (for a line the height of its
first point), ``surcharge.1.pressure`` (the greater pressure of both ends), ``crack`` and ``rate.peak``, ...
"""

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from generated.effects import Parameter
from slipcircle.base.kinds import Values
from slipcircle.core.scene.declarations import STORED, Parts
from slipcircle.core.scene.effects import Law
from slipcircle.layers.cracks import CrackedSection
from slipcircle.layers.soils import TOP, Soil, share_one_law
from slipcircle.tree import numbers

Load = tuple[float, float, Any, Any]  # surcharge: x1, x2, and the pressures at these ends
PRESSURE = Parameter(
    "pressure",
    "Pa",
    -5e-324,
    1e12,
    "the uniform pressure, or those at both ends; studies vary the greater one and scale the other with it",
    "pressure_kPa",
    1e3,
    kind="lens",
)
_TOP_OF_LINE = replace(TOP, kind="lens")
_LINE = replace(STORED, axes=2)


class LayeredNumbers(CrackedSection):
    """Section with the numbers of layers."""

    layers: Sequence[tuple[Soil, Any]]
    foreland: Soil | None
    surcharge: Sequence[Load]
    arc_strength: Any

    @cached_property
    def soils(self) -> tuple[Soil, ...]:
        """Soils of the layers and of the foreland."""
        of_layers = tuple(soil for soil, _ in self.layers)
        return of_layers if self.foreland is None else (*of_layers, self.foreland)

    @cached_property
    def soils_by_name(self) -> dict[str, Soil]:
        """Soils of the layers and of the foreland by name."""
        return {soil.name: soil for soil in self.soils}

    def cohesion_laws(self, cohesion: Values) -> tuple[Law, ...]:
        """Return the laws by which the cohesion of the soils changes with slip.

        The argument, the cohesion of a scene, is not used.
        """
        return self.arc_strength.cohesion_laws

    def parts(self) -> Parts:
        """Return the numbers of the geometry, soils by name, tops of layers and surcharges, with their declarations."""
        by_name = super().parts()
        rate = by_name.pop("rate")
        crack, depth = by_name.pop("crack")
        by_name["soils"] = self.soils_by_name, None
        for k, top in enumerate(self.tops, 2):
            by_name[f"layers.{k}.top"] = top, TOP
            if np.ndim(top) > 1:
                by_name[f"layers.{k}.top"] = np.asarray(top)[..., 0, 1], _TOP_OF_LINE
                by_name[f"line.{k}"] = top, _LINE
        by_name["rate"] = rate
        for k, (_, _, left, right) in enumerate(self.surcharge, 1):
            by_name[f"surcharge.{k}.pressure"] = np.maximum(left, right), PRESSURE
            by_name |= {f"left.{k}": (left, STORED), f"right.{k}": (right, STORED)}
        return by_name | {"crack": (crack if np.any(crack) else None, depth)}

    def with_parts(self, changed: Values) -> Any:
        """Return the section with other parts, `changed` by the names of `parts`. Nothing is checked."""
        fields = {name: changed[name] for name in changed if "." not in name}
        soils = fields.pop("soils", self.soils_by_name)
        layers = []
        for k, (soil, top) in enumerate(self.layers, 1):
            line = changed.get(f"line.{k}", top)
            layers.append((soils[soil.name], _moved(line, changed.get(f"layers.{k}.top"))))
        loads = []
        for k, (first, last, left, right) in enumerate(self.surcharge, 1):
            load = first, last, changed.get(f"left.{k}", left), changed.get(f"right.{k}", right)
            loads.append(_scaled(load, changed.get(f"surcharge.{k}.pressure")))
        fields |= {"layers": tuple(layers), "surcharge": tuple(loads)}
        return super().with_parts(fields | {"foreland": self.foreland and soils[self.foreland.name]})

    @property
    def _shared_lengths(self) -> list[list[str]]:
        """Names of the slip lengths that soils share, a list each for friction and cohesion with one law."""
        shared = [strength for strength in ("friction", "cohesion") if share_one_law(self.soils, strength)]
        return [[name for name in numbers(self) if name.endswith(f".{strength}.length")] for strength in shared]

    def together(self, values: Values) -> Values:
        """Return values of numbers by name, in which a slip length that soils share is set for all of them."""
        for lengths in self._shared_lengths:
            lengths_set = [values[name] for name in lengths if name in values]
            values = dict.fromkeys(lengths if lengths_set else (), *lengths_set[:1]) | dict(values)
        return values

    def numbers_without_effect(self) -> list[str]:
        """Return the names of lengths determined by the first soil's length, and of growths of cohesion that are 0."""
        left_out = [name for lengths in self._shared_lengths for name in lengths[1:]]
        for soil in self.soils:
            if soil.datum is None and not np.any(soil.cohesion_gradient):
                left_out.append(f"soils.{soil.name}.cohesion_gradient")
        return left_out

    @property
    def tops(self) -> tuple[Any, ...]:
        """Tops of the layers below the first, whose top is the ground."""
        return tuple(top for _, top in self.layers[1:])


def _moved(top: Any, height: Any) -> Any:
    """Return the top of a layer at another height in m.

    A line moves as a whole, so that its first point has this height. The top is None, a height or points (..., V, 2),
    and without a height it is unchanged.
    """
    if height is None or np.ndim(top) < 2:
        return top if height is None else height
    line = np.asarray(top)
    shift = np.broadcast_arrays(0.0, np.asarray(height - line[..., 0, 1])[..., None])
    return line + np.stack(shift, axis=-1)


def _scaled(load: Load, greatest: Any) -> Load:
    """Return a surcharge with another pressure at its greater end, and proportional pressure at the other end.

    The greatest pressure is in Pa, and None leaves the surcharge unchanged.
    """
    if greatest is None:
        return load
    first, last, left, right = load
    pressure = np.maximum(left, right)
    is_none = pressure == 0.0
    unit = np.where(is_none, 1.0, pressure)
    new_left, new_right = (greatest * np.where(is_none, 1.0, end / unit) for end in (left, right))
    return first, last, new_left, new_right
