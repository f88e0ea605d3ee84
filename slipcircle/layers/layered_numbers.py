"""Numbers of a layered section that may vary, by name: soils, tops of layers, surcharges, crack and law of speed.

Names are ``soils.NAME.cohesion``, ``soils.NAME.friction.peak``, ..., ``layers.2.top`` (for a line the height of its
first point), ``surcharge.1.pressure`` (the greater pressure of both ends), ``crack`` and ``rate.peak``, ...
"""

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from generated import effects as declared
from generated.effects import COHESION_LAWS, LAWS
from slipcircle.base.kinds import ValueDict, Values
from slipcircle.core.scene.effects import Law
from slipcircle.ground.coordinates import replace_unchecked
from slipcircle.layers.soils import SOIL_NUMBERS, Soil, share_one_law

Load = tuple[float, float, Any, Any]  # surcharge: x1, x2, and the pressures at these ends


class LayeredNumbers:
    """Mixin for the numbers of layers in a section, and for fields with other values of them."""

    layers: Sequence[tuple[Soil, Any]]
    foreland: Soil | None
    surcharge: Sequence[Load]
    rate: Values | None
    crack: Any

    @cached_property
    def soils(self) -> tuple[Soil, ...]:
        """Soils of the layers and of the foreland."""
        of_layers = tuple(soil for soil, _ in self.layers)
        if self.foreland is None:
            return of_layers
        return (*of_layers, self.foreland)

    def cohesion_laws(self: Any, cohesion: Values) -> tuple[Law, ...]:
        """Return the laws by which the cohesion of the soils changes with slip."""
        laws: tuple[Law, ...] = self.arc_strength.cohesion_laws
        return laws

    def other_numbers(self) -> ValueDict:
        """Return the numbers of layers by name."""
        numbers: ValueDict = {}
        for soil in self.soils:
            numbers |= _numbers_of_soil(soil)
        for k, (_, top) in enumerate(self.layers, 1):
            if top is not None:
                numbers[f"layers.{k}.top"] = _height(top)
        if self.rate:
            numbers |= _numbers_of_law("rate", self.rate)
        for k, (_, _, left, right) in enumerate(self.surcharge, 1):
            numbers[f"surcharge.{k}.pressure"] = np.maximum(left, right)
        if np.any(self.crack):
            numbers["crack"] = self.crack
        return numbers

    def numbers_without_effect(self: Any) -> list[str]:
        """Return lengths determined by the first soil's length, and growths of cohesion that are 0."""
        left_out: list[str] = []
        for strength in ("friction", "cohesion"):
            if share_one_law(self.soils, strength):
                lengths = [name for name in self.other_numbers() if name.endswith(f".{strength}.length")]
                left_out += lengths[1:]
        for soil in self.soils:
            if soil.datum is None and not np.any(soil.cohesion_gradient):
                left_out.append(f"soils.{soil.name}.cohesion_gradient")
        return left_out

    def fields_with(self, values: Values) -> ValueDict:
        """Return the fields that contain these numbers, with other values."""
        known = self.other_numbers()
        changed = {name: value for name, value in values.items() if value is not known[name]}
        if not changed:
            return {}
        for strength in ("friction", "cohesion"):
            if share_one_law(self.soils, strength):
                _share_length(f".{strength}.length", changed, known)
        soils = {id(soil): _soil_with(soil, changed) for soil in self.soils}
        other = {name: value for name, value in changed.items() if not np.array_equal(value, known[name])}
        layers = []
        for k, (soil, top) in enumerate(self.layers, 1):
            name = f"layers.{k}.top"
            layers.append((soils[id(soil)], _moved(top, other[name]) if name in other else top))
        loads = []
        for k, load in enumerate(self.surcharge, 1):
            name = f"surcharge.{k}.pressure"
            loads.append(_scaled(load, other[name]) if name in other else load)
        rate = _within("rate.", changed)
        return {
            "layers": tuple(layers),
            "foreland": self.foreland and soils[id(self.foreland)],
            "rate": {**self.rate, **rate} if self.rate else None,
            "surcharge": tuple(loads),
            "crack": changed.get("crack", self.crack),
        }

    def with_lanes(self, of_lanes: Callable[..., Any]) -> Any:
        """Return the section with selected lanes of surcharges and of lines below the ground."""
        loads = [(first, last, of_lanes(left), of_lanes(right)) for first, last, left, right in self.surcharge]
        layers = [(soil, of_lanes(top, 2) if np.ndim(top) > 2 else top) for soil, top in self.layers]
        return replace_unchecked(self, {"surcharge": loads, "layers": layers})


def _numbers_of_soil(soil: Soil) -> ValueDict:
    """Return the numbers of a soil by name."""
    start = f"soils.{soil.name}"
    numbers = ValueDict()
    for name in SOIL_NUMBERS:
        value = getattr(soil, name)
        if isinstance(value, Mapping):
            numbers |= _numbers_of_law(f"{start}.{name}", value, COHESION_LAWS)
        elif value is not None and not callable(value):
            numbers[f"{start}.{name}"] = value
    if isinstance(soil.friction, Mapping):
        return numbers | _numbers_of_law(f"{start}.friction", soil.friction)
    numbers[f"{start}.friction"] = soil.friction
    return numbers


def _numbers_of_law(start: str, law: Values, laws: Mapping[str, declared.Law] = LAWS) -> ValueDict:
    """Return the numbers of a law by name. A table has none."""
    return {f"{start}.{p.name}": law[p.name] for p in laws[law["law"]].parameters if p.kind != "list"}


def _height(top: Any) -> Any:
    """Return the height of the top of a layer, for a line the height of its first point."""
    if np.ndim(top) < 2:
        return top
    heights = np.asarray(top)[..., 1]
    return heights[..., 0]


def _share_length(end: str, changed: ValueDict, known: Values) -> None:
    """Set the slip lengths of all soils to one length, since they share a law."""
    lengths = [name for name in known if name.endswith(end)]
    given = [changed[name] for name in changed if name in lengths]
    if given:
        for name in lengths:
            changed.setdefault(name, given[0])


def _within(start: str, values: Values) -> ValueDict:
    """Return the values whose names have a prefix, by the rest of their names."""
    return {name.removeprefix(start): value for name, value in values.items() if name.startswith(start)}


def _soil_with(soil: Soil, values: Values) -> Soil:
    """Return a soil with other values of its numbers, by their names in the section."""
    changed = _within(f"soils.{soil.name}.", values)
    for strength in ("friction", "cohesion"):
        law = _within(f"{strength}.", changed)
        for name in law:
            del changed[f"{strength}.{name}"]
        if law:
            changed[strength] = {**getattr(soil, strength), **law}
    return replace_unchecked(soil, changed)


def _scaled(load: Load, greatest: Any) -> Load:
    """Return a surcharge with another pressure at its greater end, and proportional pressure at the other end."""
    first, last, left, right = load
    known = np.maximum(left, right)
    is_none = known == 0.0
    unit = np.where(is_none, 1.0, known)
    left_share = np.where(is_none, 1.0, left / unit)
    right_share = np.where(is_none, 1.0, right / unit)
    new_left = greatest * left_share
    new_right = greatest * right_share
    return first, last, new_left, new_right


def _moved(top: Any, height: Any) -> Any:
    """Return the top of a layer at another height. A line moves as a whole, so that its first point has this height."""
    if np.ndim(top) < 2:
        return height
    line = np.asarray(top)
    rise = np.asarray(height - _height(line))[..., None]
    shift = np.broadcast_arrays(0.0, rise)
    return line + np.stack(shift, axis=-1)
