"""Soils of a layered ground, and messages about soils, layers and surcharges."""

from __future__ import annotations  # so that a signature says ArrayLike

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from generated.effects import COHESION_LAWS, LAWS, Parameter
from slipcircle.base.arrays import array_of, freeze
from slipcircle.base.bounds import abridged
from slipcircle.base.errors import mistakes, raise_all
from slipcircle.base.kinds import Texts
from slipcircle.base.units import take_units
from slipcircle.core.scene.declarations import Parts, declared, number
from slipcircle.core.scene.effects import cohesion_law
from slipcircle.core.scene.laws import law_mistakes
from slipcircle.ground.ground import FAR, WEIGHT, points_errors, present
from slipcircle.layers.at_rest import cohesion_at_rest, friction_at_rest, least_friction
from slipcircle.tree import parts_of_fields

STRESS = Parameter(
    "cohesion",
    "Pa",
    -5e-324,
    1e12,
    "cohesion, by default 0",
    "cohesion_kPa",
    1e3,
    optional=True,
    allowed="a stress of at least 0 in Pa",
)
TOP = Parameter(
    "top",
    "m",
    -FAR,
    FAR,
    "its top, of the first layer the ground; a line varies by its first height",
    "top_m",
    optional=True,
    allowed="a height in m, or points from left to right",
)


@dataclass(frozen=True)
class Soil:
    """Soil of layered ground.

    Parameters
    ----------
    unit_weight : float or array_like
        Unit weight gamma, N/m^3.
    cohesion : float, array_like, mapping or callable
        Cohesion c, Pa, with a gradient its value at and above the datum; or a law of slip, ``{"law": "exponential",
        "peak": 30e3, "residual": 5e3, "length": 0.2}``, which also multiplies the increase with depth.
    friction : float, array_like or mapping
        Friction coefficient tan(phi), or a law, ``{"law": "linear", "peak": 0.4, "residual": 0.2, "length": 0.5}``.
        All soils along an arc share a law of slip and its length, unless strength moves with the mass.
    saturated_unit_weight : float or array_like, optional
        Unit weight below the water level, N/m^3.
    cohesion_gradient : float or array_like
        Increase of c per metre below the datum, Pa/m.
    datum : float, optional
        Height y below which c increases, m. By default c increases vertically below the top of the layer, a height, a
        line or the ground, in its position before the slide.
    pore_ratio : float or array_like
        Pore pressure ratio r_u, pore pressure over the vertical stress of the layers above at the start, instead of a
        water level.
    name : str
    """

    unit_weight: ArrayLike = field(
        metadata=number("N/m^3", *WEIGHT, help="unit weight", key="unit_weight_kN_m3", per_unit=1e3)
    )
    cohesion: Any = field(default=0.0, metadata={"laws": COHESION_LAWS, "number": STRESS})
    friction: Any = field(default=0.0, metadata={"laws": LAWS})
    saturated_unit_weight: ArrayLike | None = field(
        default=None,
        metadata=number(
            "N/m^3",
            *WEIGHT,
            help="unit weight below the water level",
            key="saturated_unit_weight_kN_m3",
            per_unit=1e3,
            optional=True,
        ),
    )
    cohesion_gradient: ArrayLike = field(
        default=0.0,
        metadata=number(
            "Pa/m",
            -5e-324,
            1e12,
            "a growth of at least 0 in Pa/m",
            help="growth of the cohesion per metre below datum_m, by default 0",
            key="cohesion_per_m_kPa",
            per_unit=1e3,
            optional=True,
        ),
    )
    datum: float | None = None
    pore_ratio: ArrayLike = field(
        default=0.0,
        metadata=number(
            "",
            -5e-324,
            1.0,
            "at least 0 and below 1",
            help="r_u, in place of the water level, by default 0",
            key="pore_pressure_ratio",
            optional=True,
        ),
    )
    name: str = ""

    def __post_init__(self) -> None:
        """Check the numbers, convert their units and freeze them."""
        fields = (*declared(Soil), "friction", "datum")
        take_units(self, fields)
        freeze(self, fields)
        raise_all(f"Soil {self.name}".rstrip(), soil_mistakes(self))

    def parts(self) -> Parts:
        """Return the numbers and the laws of the soil by name, with friction as the last one."""
        by_name = parts_of_fields(self)
        friction = by_name.pop("friction")
        return {**by_name, "friction": friction}

    @property
    def weight_below_water(self) -> ArrayLike:
        """Unit weight below the water level, N/m^3."""
        if self.saturated_unit_weight is None:
            return self.unit_weight
        return self.saturated_unit_weight

    @property
    def peak(self) -> Any:
        """Friction coefficient tan(phi) at the start."""
        return friction_at_rest(self.friction)

    @property
    def peak_cohesion(self) -> Any:
        """Cohesion at the start, Pa."""
        return cohesion_at_rest(self.cohesion)

    @property
    def residual_cohesion(self) -> Any:
        """Cohesion after much slip, Pa, for a table or a function its initial value."""
        law = cohesion_law(self.cohesion)
        if law is None:
            return self.peak_cohesion
        return law[1].get("residual", self.peak_cohesion)

    @property
    def residual(self) -> Any:
        """Friction coefficient tan(phi) after much slip."""
        return friction_at_rest(self.friction, slipped=True)


Layers = Sequence[tuple[Soil, Any]]  # soil and top of each layer


def soil_mistakes(soil: Soil) -> Texts:
    """Return a message for each invalid number of a soil."""
    softens = callable(soil.cohesion) or isinstance(soil.cohesion, Mapping)
    numbers = present(soil, declared(Soil))
    if softens:
        del numbers["cohesion"]
    messages = mistakes(vars(soil), numbers)
    messages += law_mistakes(soil.cohesion, "cohesion", COHESION_LAWS) if softens else []
    if softens and not messages and np.any(soil.cohesion_gradient) and not np.all(soil.peak_cohesion):
        messages.append("cohesion.peak = 0: must be positive, as the law multiplies the increase with depth")
    of_friction = law_mistakes(soil.friction)
    messages += of_friction
    if callable(soil.friction) and not of_friction:
        messages.append("friction: must be a number or a law by name")
    if isinstance(soil.friction, Mapping) and "rate" in soil.friction:
        messages.append(
            "friction.rate: is given to the section, LayeredSection(..., rate=...), for all soils along an arc"
        )
    return messages


def layer_mistakes(layers: Any, surcharge: Any, strength: str = "", foreland: Any = None) -> Texts:
    """Return a message for each mistake in the layers of a section, its foreland and its surcharges.

    Without ``strength`` the section does not move.
    """
    pairs = list(layers) if isinstance(layers, Sequence) else []
    if not pairs or not all(map(_is_layer, pairs)):
        return ["layers: must be pairs of a Soil and its top, from the ground down; the top of the first is None"]
    messages = []
    for k, (_, top) in enumerate(pairs):
        messages += _top_mistakes(k, top)
    if strength not in ("", "base", "mass"):
        messages.append(f"strength = {abridged(strength)}: must be 'base' or 'mass'")
    if foreland is not None and not isinstance(foreland, Soil):
        messages.append(f"foreland = {abridged(foreland)}: must be a Soil")
    elif foreland is not None and strength == "mass":
        messages.append(
            "{foreland}: cannot be combined with {strength} = 'mass', by which the sole of the mass keeps its own"
        )
    used = [soil for soil, _ in pairs]
    if isinstance(foreland, Soil):
        used.append(foreland)
    messages += _together_mistakes(used, strength)
    if not messages:
        messages += datum_mistakes(foreland, pairs)
    if not isinstance(surcharge, Sequence):
        messages.append(f"surcharge = {abridged(surcharge)}: must be a list of x1, x2 in m and pressures there in Pa")
        return messages
    for k, load in enumerate(surcharge):
        messages += _load_mistakes(k, load)
    return messages


def _is_layer(pair: Any) -> bool:
    """Return whether a value is a pair of a soil and its top."""
    is_pair = isinstance(pair, tuple | list) and len(pair) == 2
    return is_pair and isinstance(pair[0], Soil)


def _tops(soil: Soil, layers: Layers) -> list[Any]:
    """Return the tops of the layers of one soil: None, heights in m, or points of a line."""
    return [top for other, top in layers if other.name == soil.name]


def top_of(foreland: Soil, layers: Layers) -> Any:
    """Return the top of the first layer of the soil of the foreland, None for the ground or without a layer."""
    return next(iter(_tops(foreland, layers)), None)


def datum_mistakes(foreland: Soil | None, layers: Layers) -> Texts:
    """Return a message if the cohesion of the foreland grows with depth below an ambiguous or missing top.

    The top of the foreland's soil is known if all layers of this soil have the same top.
    """
    if foreland is None or foreland.datum is not None or not np.any(foreland.cohesion_gradient):
        return []
    tops = _tops(foreland, layers)
    if tops and all(top is tops[0] or np.array_equal(top, tops[0]) for top in tops):
        return []
    why = "is missing: y below which the cohesion grows beyond the exit, as the soil is not that of one layer"
    return [f"soils.{foreland.name}.datum: {why}"]


def _load_mistakes(k: int, load: Any) -> Texts:
    """Return messages about a surcharge (x1, x2, q1, q2) in m and Pa. `k` is its index, counted from 0."""
    words = f"surcharge[{k}] = {abridged(load)}: must be x1 < x2 in m and pressures there of at least 0 in Pa"
    if not isinstance(load, Sequence) or len(load) != 4:
        return [words]
    values = [array_of(value) for value in load]
    if not all(value.dtype.kind in "iuf" and np.all(np.isfinite(value)) for value in values):
        return [words]
    first, last, left, right = values
    in_order = first.ndim == last.ndim == 0 and first < last
    pulls = np.any(left < 0.0) or np.any(right < 0.0)
    if in_order and not pulls:
        return []
    return [words]


def _top_mistakes(k: int, top: Any) -> Texts:
    """Return messages about the top of a layer. `k` is the index of the layer, counted from 0 at the ground."""
    if k == 0:
        words = f"layers[0]: top = {abridged(top)}: must be None, as its top is the ground"
        if top is None:
            return []
        return [words]
    if top is None:
        return [f"layers[{k}]: top is missing: a height in m, or points from left to right"]
    if array_of(top).ndim > 1:
        return points_errors(f"layers.{k + 1}.top", top, True)
    name = f"layers.{k + 1}.top"
    return mistakes({name: top}, {name: TOP})


def share_one_law(soils: Iterable[Soil], strength: str = "friction") -> bool:
    """Return whether soils share a law of slip and its length, or have constant friction or cohesion.

    `strength` is "friction" or "cohesion".
    """
    laws = set()
    for soil in soils:
        law = getattr(soil, strength)
        if callable(law):
            return False
        if not isinstance(law, Mapping) or ("cohesion" in law and law["law"] == "constant"):
            continue
        if not {"peak", "residual", "length"} <= {*law}:
            return False
        shared = dict(law)
        del shared["peak"], shared["residual"]
        laws.add(repr(sorted(shared.items())))
    return len(laws) <= 1


def _together_mistakes(soils: list[Soil], strength: str) -> Texts:
    """Return messages about soils that cannot lie along one arc: equal names, and incompatible friction laws.

    `strength` is "base" or "mass", or empty for a section that does not move.
    """
    by_name = {soil.name: soil for soil in soils}
    twice = sorted({soil.name for soil in soils if soil is not by_name[soil.name]})
    messages = [f"layers: {name!r} is the name of two soils; give each its own" for name in twice]
    if not strength:
        return messages
    if strength == "base" and not share_one_law(soils, "cohesion"):
        messages.append(
            "layers: the cohesion of soils along an arc follows one law of slip with one length, as base that the mass "
            "reaches has slipped less than the sole; with {strength} = 'mass' each soil may have a law of its own"
        )
    if share_one_law(soils):
        return messages
    if strength == "base":
        others = ", ".join(name for name, soil in by_name.items() if isinstance(soil.friction, Mapping))
        messages.append(
            f"layers: the soils along an arc share one law of slip with one length, and not {others}, as base that the "
            "mass reaches has slipped less than the sole; with {strength} = 'mass' each may have a law of its own"
        )
    elif all(least_friction(soil.friction) == 0.0 for soil in soils):
        messages.append("layers: with a friction law of its own for each soil, one of them must keep some friction")
    return messages
