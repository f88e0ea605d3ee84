"""A scene of a real slope together with the factors of safety of its circle."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from slipcircle.base.checks import InputError
from slipcircle.base.kinds import Numbers, cached_property
from slipcircle.core import AS_ENTERED, Motion, Scene, lazy_import
from slipcircle.ground import Section
from slipcircle.layers import LayeredSection
from slipcircle.workbench.files.numbers import by_name
from slipcircle.workbench.stability.stability import METHODS
from slipcircle.workbench.stability.starting import OF_CLOSURE, at_rest_by, residual_by, strength_factor, yield_by

if TYPE_CHECKING:
    from slipcircle.workbench.stability.search import Critical

_NO_START = (
    "circle.start: by {} this circle has no factor of safety to start from; give another circle, or another method in "
    '[circle], such as start = "ordinary" or "paper"'
)


@dataclass(frozen=True)
class SlopeScene(Scene[Numbers]):
    """A scene with the factors of safety of its circle, as returned by `load`.

    Attributes
    ----------
    stability : Critical, optional
        Factors of safety of the section's circle, and how it was found.
    remarks : tuple of str
        Interpretations of the file that may not be intended.
    start : str
        Method from whose factor of safety the motion starts. It sets `strength_factor`, and again in every scene that
        is derived from this one, unless that has another strength factor explicitly.
    set_by_start : float or array
        The strength factor that ``start`` has set.
    """

    stability: Critical | None = None
    remarks: tuple[str, ...] = ()
    start: str = OF_CLOSURE
    set_by_start: Any = AS_ENTERED

    @classmethod
    def of(cls, found: Critical, effects: Mapping[str, Any], friction: Any = None, **fields: Any) -> SlopeScene[Any]:
        """Return the motion along a circle of `critical`, which starts from the factor by the method of the search.

        Ground, water, soils, cohesion and pore pressure are those of the slope, and so is friction unless it is given.
        """
        slope = found.slope
        names = ("ground", "level", "water_unit_weight", "base", "confined", "ponds")
        common: dict[str, Any] = {name: getattr(slope, name) for name in names}
        common |= {"centre": found.centre, "radius": found.radius, "between": found.between}
        start = found.method if found.method in METHODS else "bishop"
        fields |= {"start": start, "stability": found.without_map()}
        if slope.layers:
            arc: Section = LayeredSection(**common, layers=slope.layers, surcharge=slope.surcharge, crack=slope.crack)
            return cls(arc, effects=effects, **fields)
        water = {"ratio": slope.pore_ratio, "pressure": slope.pressure}
        given = {name: value for name, value in water.items() if value}
        growth = {"gradient": slope.cohesion_gradient, "datum": slope.datum}
        cohesion = {"cohesion": slope.cohesion} | {name: value for name, value in growth.items() if value}
        own = {"cohesion": cohesion} if any(cohesion.values()) else {}
        own |= {"pore_pressure": given} if given else {}
        arc = Section(**common, unit_weight=float(slope.unit_weight or 0.0))
        law = slope.friction if friction is None else friction
        return cls(arc, law, own | dict(effects), **fields)

    def __post_init__(self) -> None:
        if self.strength_factor is self.set_by_start:
            self._start_with(AS_ENTERED)  # until all fields are known to be valid
        super().__post_init__()
        self.start_anew()
        if not self.shape and self.strength_factor != self.strength_factor:
            raise InputError("", [_NO_START.format(self.start)])

    def start_anew(self) -> None:
        if self.strength_factor is self.set_by_start:
            self._start_with(strength_factor(self, self.start))

    def _start_with(self, factor: Any) -> None:
        """Set the strength factor."""
        for name in ("strength_factor", "set_by_start"):
            object.__setattr__(self, name, factor)

    def by_start(self, quantity: str, motion: Motion) -> Any:
        if self.start == OF_CLOSURE or self.strength_factor is not self.set_by_start:
            return None
        if quantity == "yield_coefficient":  # under shaking the strength factor has made it that of the closure
            found = None if "shaking" in self.called else yield_by(self, self.start)
        elif quantity == "residual":
            found = residual_by(self, self.start)
        elif self.shape or not motion.arrested:
            return None
        else:
            friction = float(motion.friction_at(motion.settling_time))
            found = at_rest_by(self, self.start, motion.end.rotation, friction)
        return None if found is None or np.all(np.isnan(found)) else (found, self.start)

    def __getstate__(self) -> dict[str, Any]:
        """Return the fields, and whether the start sets the strength factor: a copy has another number object."""
        return vars(self) | {"set_by_start": self.strength_factor is self.set_by_start}

    def __setstate__(self, state: dict[str, Any]) -> None:
        factor = state["strength_factor"] if state["set_by_start"] else None
        vars(self).update(state | {"set_by_start": factor})

    @cached_property
    def numbers(self) -> Mapping[str, ArrayLike]:
        """All numbers that may be arrays; the strength factor follows from the others unless it is explicit."""
        numbers = super().numbers
        if self.strength_factor is not self.set_by_start:
            return numbers
        return {name: value for name, value in numbers.items() if name != "strength_factor"}


def stability_of(scene: Scene) -> Critical | None:
    """The factors of safety of a scene's circle, or None."""
    return scene.stability if isinstance(scene, SlopeScene) else None


def warnings_of(motion: Motion) -> tuple[str, ...]:
    """Warnings about a single motion, whose numbers have the keys and units of files, and about its circle."""
    scene = motion.plan.scene

    def written(name: str, value: float) -> str:
        number = by_name(scene)[name]
        return f"{number.key} = {float(number.from_si(value)):.6g} {number.unit}".rstrip()

    stability = stability_of(scene)
    of_circle = [stability.warning] if stability and stability.warning else []
    of_file = scene.remarks if isinstance(scene, SlopeScene) else ()
    return (*of_file, *of_circle, *lazy_import("warnings").collect_warnings(motion, written))
