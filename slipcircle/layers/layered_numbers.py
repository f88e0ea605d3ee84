"""Numbers of a layered section: soils by name, tops of layers, surcharges, crack and law of speed.

Paths are ``soils.NAME.cohesion``, ``soils.NAME.friction.peak``, ..., ``layers.2.top`` (for a line the height of its
first point), ``surcharge.1.pressure`` (the greater pressure of both ends), ``crack`` and ``rate.peak``, ...
"""

import operator
from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from generated.effects import Parameter
from slipcircle.base.kinds import ValueDict, Values
from slipcircle.core.scene.effects import Law
from slipcircle.core.scene.tree import STORED, Parts, numbers
from slipcircle.layers.cracks import CrackedSection
from slipcircle.layers.soils import TOP, Soil, share_one_law

Load = tuple[float, float, Any, Any]  # surcharge: x1, x2, and the pressures at these ends
PRESSURE = Parameter(
    "pressure",
    "Pa",
    -5e-324,
    1e12,
    "the pressure, or at both ends, which varies by the greater one",
    "pressure_kPa",
    1e3,
    kind="lens",
)
_TOP_OF_LINE = replace(TOP, kind="lens")
_LINES = Parameter("tops", axes=2, kind="stored")


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
        """Return the laws by which the cohesion of the soils changes with slip."""
        laws: tuple[Law, ...] = self.arc_strength.cohesion_laws
        return laws

    def parts(self) -> Parts:
        """Return the numbers of the geometry, soils by name, tops of layers and surcharges, with their declarations."""
        found = super().parts()
        rate = found.pop("rate")
        crack, depth = found.pop("crack")
        found["soils"] = self.soils_by_name, None
        found["tops"] = self.tops, _LINES
        for name, top in self._tops_by_name.items():
            found[name] = (np.asarray(top)[..., 0, 1], _TOP_OF_LINE) if np.ndim(top) > 1 else (top, TOP)
        found |= {"rate": rate, "surcharge": (self.surcharge, STORED)}
        for k, (_, _, left, right) in enumerate(self.surcharge, 1):
            found[f"surcharge.{k}.pressure"] = np.maximum(left, right), PRESSURE
        return found | {"crack": (crack if np.any(crack) else None, depth)}

    def with_parts(self, changed: Values) -> Any:
        """Return the section with other parts. Nothing is checked."""
        fields = {name: changed[name] for name in changed if "." not in name}
        soils = fields.pop("soils", self.soils_by_name)
        tops = [None, *fields.pop("tops", self.tops)]
        for k, name in enumerate(self._tops_by_name, 1):
            tops[k] = _moved(tops[k], changed[name]) if name in changed else tops[k]
        if soils is not self.soils_by_name or any(map(operator.is_not, tops[1:], self.tops)):
            pairs = zip(self.layers, tops, strict=True)
            fields["layers"] = tuple((soils[soil.name], top) for (soil, _), top in pairs)
            fields["foreland"] = self.foreland and soils[self.foreland.name]
        loads = fields.pop("surcharge", self.surcharge)
        scaled = {k: f"surcharge.{k}.pressure" for k in range(1, len(loads) + 1)}
        greatest = {k: changed[name] for k, name in scaled.items() if name in changed}
        fields["surcharge"] = tuple(
            _scaled(load, greatest[k]) if k in greatest else load for k, load in enumerate(loads, 1)
        )
        return super().with_parts(fields)

    @property
    def _tops_by_name(self) -> ValueDict:
        """Tops of the layers below the first by the names of their heights."""
        return {f"layers.{k}.top": top for k, top in enumerate(self.tops, 2)}

    def together(self, values: Values) -> Values:
        """Return other values of numbers with the slip length that soils share."""
        for strength in ("friction", "cohesion"):
            lengths = [name for name in numbers(self) if name.endswith(f".{strength}.length")]
            given = [values[name] for name in lengths if name in values]
            if given and share_one_law(self.soils, strength):
                values = dict.fromkeys(lengths, given[0]) | dict(values)
        return values

    def numbers_without_effect(self) -> list[str]:
        """Return lengths determined by the first soil's length, and growths of cohesion that are 0."""
        left_out: list[str] = []
        for strength in ("friction", "cohesion"):
            if share_one_law(self.soils, strength):
                left_out += [name for name in numbers(self) if name.endswith(f".{strength}.length")][1:]
        for soil in self.soils:
            if soil.datum is None and not np.any(soil.cohesion_gradient):
                left_out.append(f"soils.{soil.name}.cohesion_gradient")
        return left_out

    @property
    def tops(self) -> tuple[Any, ...]:
        """Tops of the layers below the first, whose top is the ground."""
        return tuple(top for _, top in self.layers[1:])


def _moved(top: Any, height: Any) -> Any:
    """Return the top of a layer at another height. A line moves as a whole, so that its first point has this height."""
    if np.ndim(top) < 2:
        return height
    line = np.asarray(top)
    rise = np.asarray(height - line[..., 0, 1])[..., None]
    shift = np.broadcast_arrays(0.0, rise)
    return line + np.stack(shift, axis=-1)


def _scaled(load: Load, greatest: Any) -> Load:
    """Return a surcharge with another pressure at its greater end, and proportional pressure at the other end."""
    first, last, left, right = load
    known = np.maximum(left, right)
    is_none = known == 0.0
    unit = np.where(is_none, 1.0, known)
    new_left, new_right = (greatest * np.where(is_none, 1.0, end / unit) for end in (left, right))
    return first, last, new_left, new_right
