"""The numbers of a layered section that vary, by name: of soils, tops of layers, surcharges, crack and factor of speed.

Names are ``soils.NAME.cohesion``, ``soils.NAME.friction.peak``, ...; ``layers.2.top``, of a line the height of its
first point; ``surcharge.1.pressure``, the greater one of both ends; ``crack``; ``rate.peak``, ...
"""

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from generated.effects import LAWS
from slipcircle.core.scene.coordinates import replace_unchecked
from slipcircle.core.scene.soils import SOIL_NUMBERS, Soil, share_one_law


class LayeredNumbers:
    """Numbers of a section with layers beside those of ground, circle and water, and its fields with other values."""

    layers: Sequence[tuple[Soil, Any]]
    foreland: Soil | None
    surcharge: Sequence[tuple[float, float, Any, Any]]
    rate: Mapping[str, Any] | None
    crack: Any

    @cached_property
    def soils(self) -> tuple[Soil, ...]:
        """The soils of the layers, and that of the foreland."""
        return (*(soil for soil, _ in self.layers), *([self.foreland] if self.foreland else []))

    def other_numbers(self) -> dict[str, Any]:
        """Numbers by name."""
        numbers = {name: value for soil in self.soils for name, value in _numbers_of(soil)}
        for k, (_, top) in enumerate(self.layers, 1):
            if top is not None:
                numbers[f"layers.{k}.top"] = np.asarray(top)[..., 0, 1][()] if np.ndim(top) > 1 else top
        if self.rate and LAWS[self.rate["law"]].parameters[0].kind != "list":
            numbers |= {f"rate.{name}": value for name, value in self.rate.items() if name != "law"}
        for k, (_, _, left, right) in enumerate(self.surcharge, 1):
            numbers[f"surcharge.{k}.pressure"] = np.maximum(left, right)
        if np.any(self.crack):
            numbers["crack"] = self.crack
        return numbers

    def fields_with(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """The fields that these numbers are of, with other values."""
        known = self.other_numbers()
        changed = {name: value for name, value in values.items() if value is not known[name]}
        if not changed:
            return {}
        lengths = [value for name, value in changed.items() if name.endswith(".friction.length")]
        if lengths and share_one_law(self.soils):
            of_soils = {name for name in known if name.endswith(".friction.length")}
            changed = {**dict.fromkeys(of_soils, lengths[0]), **changed}
        soils = {id(soil): _soil_with(soil, changed) for soil in self.soils}
        layers = []
        for k, (soil, top) in enumerate(self.layers, 1):
            name = f"layers.{k}.top"
            if name in changed and not np.array_equal(changed[name], known[name]):
                top = _moved(top, changed[name])
            layers.append((soils[id(soil)], top))
        rate = _within("rate.", changed)
        loads = [_scaled(load, changed.get(f"surcharge.{k}.pressure")) for k, load in enumerate(self.surcharge, 1)]
        return {
            "layers": tuple(layers),
            "foreland": self.foreland and soils[id(self.foreland)],
            "rate": {**self.rate, **rate} if self.rate and rate else self.rate,
            "surcharge": tuple(loads),
            "crack": changed.get("crack", self.crack),
        }


def _numbers_of(soil: Soil) -> Iterator[tuple[str, Any]]:
    """The numbers of a soil by name."""
    start = f"soils.{soil.name}"
    for name in SOIL_NUMBERS:
        value = getattr(soil, name)
        if value is not None:
            yield f"{start}.{name}", value
    if not isinstance(soil.friction, Mapping):
        yield f"{start}.friction", soil.friction
        return
    for p in LAWS[soil.friction["law"]].parameters:
        if p.kind != "list":
            yield f"{start}.friction.{p.name}", soil.friction[p.name]


def _within(start: str, values: Mapping[str, Any]) -> dict[str, Any]:
    """The values whose names begin so, by the rest of their names."""
    return {name.removeprefix(start): value for name, value in values.items() if name.startswith(start)}


def _soil_with(soil: Soil, values: Mapping[str, Any]) -> Soil:
    """A soil with other values of its numbers, by their names in the section."""
    changed = _within(f"soils.{soil.name}.", values)
    law = _within("friction.", changed)
    if law:
        changed = {name: value for name, value in changed.items() if not name.startswith("friction.")}
        changed["friction"] = {**soil.friction, **law}
    return replace_unchecked(soil, changed)


def _scaled(load: tuple[float, float, Any, Any], greatest: Any) -> tuple[float, float, Any, Any]:
    """A surcharge with another pressure at the end where it is greater; that at the other end is in proportion."""
    if greatest is None:
        return load
    first, last, left, right = load
    known = np.maximum(left, right)
    is_none = known == 0.0
    unit = np.where(is_none, 1.0, known)
    shares = [np.where(is_none, 1.0, pressure / unit) for pressure in (left, right)]
    return first, last, greatest * shares[0], greatest * shares[1]


def _moved(top: Any, height: Any) -> Any:
    """The top of a layer at another height; a line moves as a whole, and its first point has that height."""
    if np.ndim(top) < 2:
        return height
    line = np.asarray(top)
    if line.ndim > 2:  # lanes of one line
        line = line.reshape(-1, *line.shape[-2:])[0]
    rise = np.asarray(height - line[0, 1])[..., None]
    return line + np.stack(np.broadcast_arrays(0.0, rise), axis=-1)
