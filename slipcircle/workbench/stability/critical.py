"""Slip circle of a slope with its factors of safety, and the scene of the motion along it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from slipcircle.base.conversions import Pictured
from slipcircle.base.errors import complaint, raise_all
from slipcircle.base.inputerror import InputError
from slipcircle.base.kinds import ArrayMap, Floats, Names, Numbers, Pair, ValueDict, Values, cached_property
from slipcircle.core import AS_ENTERED, STORED, Motion, Parts, Scene
from slipcircle.ground import Section, ends_above
from slipcircle.layers import LayeredSection
from slipcircle.workbench.stability.factors import YIELD, circle_factors
from slipcircle.workbench.stability.slices import Rule
from slipcircle.workbench.stability.stability import METHODS, Slope, one_layer
from slipcircle.workbench.stability.starting import OF_CLOSURE, at_rest_by, factor_of, strength_factor, yield_by

_PULLED = 0.2  # share of an arc that may be under negative stress without a warning
_PIECES = Rule(pieces=50)  # that resolve it
_CRACK_EMPTIES = "a crack opens and empties as soon as the mass moves; leave it out"
_BY_START = ("factor_of_safety", "yield_coefficient", "residual", "at_rest")
_NO_START = (
    "circle.start: by {} this circle has no factor of safety to start from; give another circle, or another method in "
    '[circle], such as start = "ordinary" or "paper"'
)


@dataclass(frozen=True)
class Critical(Pictured):
    """Circle with its factors of safety, and data of the search.

    Attributes
    ----------
    slope : Slope
    factors_of_safety : dict
        By method, with the k_h of the slope; None where a method does not apply to the circle.
    factors_of_safety_without_k_h : dict or None
        Without k_h, from which a motion starts; None if the slope has no k_h.
    start : str
        Method from whose factor of safety a motion starts: the method of the search, or Bishop's.
    factor_of_safety : float or None
        Factor of safety by the starting method, with the k_h of the slope.
    section : Section
        Mass above the circle, layered if the slope has layers, a surcharge or a tension crack.
    yield_coefficient : float or None
        k_y, the k_h for which the factor by the paper's method is 1, as of a motion: surcharges are shaken as well. It
        is negative if the mass slides without shaking, and None if the factor is 1 for no k_h.
    centre, radius : tuple of float, float
        m.
    entry, exit : tuple of float
        Upper and lower end of the slip surface, m.
    facing : int
        1 if the mass slides to the right, -1 if to the left, 0 if nothing drives it.
    negative : float
        Share of the arc under negative effective normal stress, by the ordinary method or by Bishop's, if greater.
    warning : str
        If a fifth of the arc or more is under negative stress, or the circle reaches an end of the ground or a limit of
        the search, beyond which the factor may be lower.
    method, limits : str, mapping
        Method that was minimised, and limits of the search; empty for a given circle.
    tried, refused : int
        Number of circles evaluated, and of those without a factor: off the ground, too shallow, overhanging, or with
        m_alpha below 0.05.
    centres, values : ndarray
        Centre of every circle evaluated, (tried, 2), and its factor or NaN, for a map.
    """

    slope: Slope = field(repr=False, compare=False)
    factors_of_safety: dict[str, float | None]
    centre: Pair
    radius: float
    entry: Pair
    exit: Pair
    facing: int
    negative: float
    warning: str
    factors_of_safety_without_k_h: dict[str, float | None] | None = None
    yield_coefficient: float | None = None
    method: str = ""
    start: str = "bishop"
    tried: int = 1
    refused: int = 0
    centres: Floats = field(default_factory=lambda: np.empty((0, 2)), repr=False, compare=False)
    values: Floats = field(default_factory=lambda: np.empty(0), repr=False, compare=False)
    limits: Values = field(default_factory=dict, repr=False, compare=False)

    @property
    def factor_of_safety(self) -> float | None:
        """Factor of safety by the method from which a motion starts; None if it does not exist."""
        return self.factors_of_safety[self.start]

    @property
    def between(self) -> Pair:
        """Range of x of both ends, which selects one of the masses that the circle cuts off."""
        left, right = sorted([self.entry[0], self.exit[0]])
        return left, right

    def without_map(self) -> Critical:
        """Return a copy without the evaluated circles."""
        return replace(self, centres=self.centres[:0], values=self.values[:0])

    def record(self) -> ValueDict:
        """Return the circle for JSON, in SI units."""
        further: ValueDict = {}
        if self.factors_of_safety_without_k_h:
            further["factors_of_safety_without_k_h"] = self.factors_of_safety_without_k_h
        if self.method == YIELD:
            further["yield_coefficient"] = self.yield_coefficient
        if ponds := self.slope.free_water.of_one:
            further["free_water"] = ponds
        return further | {
            "method": self.method,
            "facing": self.facing,
            "factor_of_safety": self.factor_of_safety,
            "factor_of_safety_method": self.start,
            "factors_of_safety": self.factors_of_safety,
            "circle": {"centre": list(self.centre), "radius": self.radius},
            "entry": list(self.entry),
            "exit": list(self.exit),
            "tried": self.tried,
            "refused": self.refused,
        }

    # --- the motion along it -----------------------------------------------------------------------------------------

    @cached_property
    def section(self) -> Section:
        """Section of the mass above the circle, with the water and loads of the slope."""
        slope = self.slope
        names = ("ground", "level", "water_unit_weight", "base", "confined", "ponds")
        common: ValueDict = {name: getattr(slope, name) for name in names}
        common |= {"centre": self.centre, "radius": self.radius, "between": self.between}
        if slope.layers or slope.surcharge or slope.crack:
            loads: ValueDict = {"surcharge": slope.surcharge, "crack": slope.crack}
            return LayeredSection(**common, **loads, layers=slope.layers or one_layer(vars(slope)))
        return Section(**common, unit_weight=float(slope.unit_weight or 0.0))

    def scene(self, effects: Values | Iterable[str] = (), **given: Any) -> SlopeScene[Any]:
        """Return the scene of the motion along the circle, which starts from `factor_of_safety` without k_h.

        Parameters
        ----------
        effects : mapping or iterable of str
            As for a `Scene`, in addition to the cohesion and the pore pressure of the slope.
        **given
            Further fields of the `Scene`, such as ``end_time``, and ``start``, another starting method.

        Raises
        ------
        ValueError
            For water in a tension crack, which a motion does not have, a circle without a result by the starting
            method, and mistakes in the fields.
        """
        if self.slope.crack_water:
            raise InputError("scene", [f"{{crack_water}} = {self.slope.crack_water!r}: {_CRACK_EMPTIES}"])
        fields = {"start": self.start, "stability": self.without_map(), **given}
        if not isinstance(self.section, LayeredSection):
            fields["friction"] = self.slope.friction
        named = effects if isinstance(effects, Mapping) else {name: {} for name in effects}
        return SlopeScene(self.section, effects=self._own_effects() | dict(named), **fields)

    def _own_effects(self) -> ValueDict:
        """Return the pore pressure of the slope as an effect, and the cohesion of a single soil."""
        slope = self.slope
        effects = ValueDict()
        water = {"pressure": slope.pressure}
        if not isinstance(self.section, LayeredSection):
            water["ratio"] = slope.pore_ratio
            cohesion = slope.cohesion
            strength = dict(cohesion) if isinstance(cohesion, Mapping) else {"cohesion": cohesion}
            if slope.cohesion_gradient:
                strength["gradient"] = slope.cohesion_gradient
            if slope.datum is not None:
                strength["datum"] = slope.datum
            if cohesion or slope.cohesion_gradient:
                effects["cohesion"] = strength
        if any(water.values()):
            effects["pore_pressure"] = {name: value for name, value in water.items() if value}
        return effects


@dataclass(frozen=True)
class SlopeScene(Scene[Numbers]):
    """Scene with the factors of safety of its circle, as returned by `load` and `Critical.scene`.

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
    remarks: Names = ()
    start: str = OF_CLOSURE
    set_by_start: Any = AS_ENTERED

    def __post_init__(self) -> None:
        """Check the fields, and set the strength factor by the starting method."""
        if self.starts_by_method:
            self._start_with(AS_ENTERED)  # until all fields are known to be valid
        super().__post_init__()
        self.start_anew()
        if not self.shape and self.strength_factor != self.strength_factor:
            raise InputError("", [_NO_START.format(self.start)])

    def start_anew(self) -> None:
        """Set the strength factor again by the starting method, if that method has set it before."""
        if self.starts_by_method:
            self._start_with(strength_factor(self, self.start))

    @property
    def starts_by_method(self) -> bool:
        """Whether the starting method has set the strength factor."""
        factor = np.asarray(self.strength_factor)
        return factor.dtype.kind == "f" and np.array_equal(factor, np.asarray(self.set_by_start, float), equal_nan=True)

    def _start_with(self, factor: Any) -> None:
        """Set the strength factor, a number or an array in the shape of the scene, and mark it as set by the start."""
        for name in ("strength_factor", "set_by_start"):
            object.__setattr__(self, name, factor)

    def by_start(self, quantity: str, motion: Motion, kept: float = 1.0) -> Any:
        """Return a factor of safety or yield coefficient and the starting method; None if the closure's applies.

        ``quantity`` is one of "factor_of_safety", "yield_coefficient", "residual" and "at_rest"; ``kept`` is the share
        of the cohesion that remains at rest.
        """
        if quantity not in _BY_START or self.start == OF_CLOSURE or not self.starts_by_method:
            return None
        if quantity == "yield_coefficient":  # under shaking, the strength factor has made it the closure's value
            by_method = None if "shaking" in self.called else yield_by(self, self.start)
        elif quantity == "factor_of_safety":  # without shaking, it has made this factor equal to the closure's factor
            by_method = factor_of(self, self.start) if "shaking" in self.called else None
        elif quantity == "residual":
            by_method = factor_of(self, self.start, slipped=True)
        elif self.shape or not motion.arrested:
            return None
        else:
            friction = float(motion.friction_at(motion.settling_time))
            by_method = at_rest_by(self, self.start, motion.end.rotation, friction, kept)
        return None if by_method is None or np.all(np.isnan(by_method)) else (by_method, self.start)

    def parts(self) -> Parts:
        """Return the parts of the scene. The strength factor follows from the others unless it is explicit."""
        by_name = super().parts() | {"set_by_start": (self.set_by_start, STORED)}
        if self.starts_by_method:
            _, declaration = by_name["strength_factor"]
            by_name["strength_factor"] = self.strength_factor, replace(declaration, kind="set")
        return by_name


def at_circle(slope: Slope, section: Section) -> Critical:
    """Return the circle of a section, which lies on a slope, with its factors of safety."""
    left, right = np.array(sorted([tuple(section.entry), tuple(section.exit)]))[:, None]
    circle = circle_of(slope, np.array([section.centre]), np.array([section.radius]), left, right)
    return replace(circle, refused=int(None in circle.factors_of_safety.values()))


def circle_of(slope: Slope, centre: Floats, radius: Floats, left: Floats, right: Floats) -> Critical:
    """Return one circle with its factors of safety; its centre and ends of arc are (1, 2), its radius (1,), in m."""
    if slope.level is not None:
        fault = ends_above(np.asarray(slope.level)[None], left[:, 0], right[:, 0])
        raise_all("Slope", complaint([fault], ()))
    circle = centre, radius, left, right
    factors = circle_factors(slope.arrays(), circle, _PIECES)
    without_k_h = None
    if slope.k_h:
        without_k_h = _by_method(circle_factors(replace(slope.arrays(), k_h=0.0), circle))
    facing = int(factors["facing"][0])
    negative = float(factors["negative"][0])
    first = _point(left)
    second = _point(right)
    entry, exit = (first, second) if facing >= 0 else (second, first)
    warning = ""
    if slope.has_friction and negative > _PULLED:
        warning = (
            f"{100 * negative:.0f} % of the arc is under negative effective normal stress, where factors depend on the "
            "method more than on the soil"
        )
    return Critical(
        slope=slope,
        factors_of_safety=_by_method(factors),
        centre=_point(centre),
        radius=float(radius[0]),
        entry=entry,
        exit=exit,
        facing=facing,
        negative=negative,
        warning=warning,
        factors_of_safety_without_k_h=without_k_h,
        yield_coefficient=_known(factors[YIELD]),
    )


def _point(points: Floats) -> Pair:
    """Return the point of an array (1, 2) as a tuple x, y."""
    x, y = points[0].tolist()
    return x, y


def _by_method(factors: ArrayMap) -> dict[str, float | None]:
    """Return the factors of one circle by method, None for a method without a result, from arrays (1,)."""
    return {method: _known(factors[method]) for method in METHODS}


def _known(values: Floats) -> float | None:
    """Return the number in an array (1,), or None if it is NaN."""
    return float(values[0]) if np.isfinite(values[0]) else None
