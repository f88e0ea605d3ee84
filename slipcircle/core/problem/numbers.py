"""Dimensionless numbers and tables of a scene, by the declarations of effects and laws in `generated.effects`."""

import math
from collections.abc import Callable, Iterable, Mapping
from functools import cached_property, lru_cache
from typing import Any, NamedTuple

import numpy as np

from generated.effects import ALL_EFFECTS, LAWS, Law
from generated.flow import INPUTS, PIECES
from slipcircle.base.checks import plain
from slipcircle.base.kinds import Parameters
from slipcircle.core.scene.arc import Arc
from slipcircle.core.scene.friction import soil_number, without_soil
from slipcircle.ground.section import Section
from slipcircle.layers.layered import RotationTables, first_rotation, upright
from slipcircle.layers.layers import LayeredSection
from slipcircle.layers.strength import OfRotation
from slipcircle.tables import tables
from slipcircle.tables.forcing import factor as factor_of
from slipcircle.tables.interpolation import TERMS, between_kinks, sampled
from slipcircle.tables.tables import Data

STEP = math.exp(-2.0)  # of the radius of convergence, so that a series of order n leaves exp(-2 n)
FIRST_SLIP = 1 / 256  # over the radius, to which a Python function of slip is sampled at first


class ScaledTable(NamedTuple):
    """A piecewise function with the scale of its argument and the factor of its values."""

    data: Data
    scale: Any = 1.0
    factor: Any = 1.0


class Numbers:
    """Dimensionless numbers and tables of a scene, by their names in its program.

    Parameters
    ----------
    arc : Arc or Section
    upslope : bool
        Whether the mass may move beyond where it began.
    tolerance : float
        Relative error of tables of the rotation.
    """

    function: Callable[[Any], Any]  # the friction law, where that is a Python function
    rotations: RotationTables | None = None

    def __init__(self, arc: Arc | Section, upslope: bool, tolerance: float) -> None:
        self.arc = arc
        self.upslope = upslope
        self.tolerance = tolerance
        self.time_scale = plain(arc.time_scale)
        self.radius = plain(arc.radius)
        self.tables: dict[str, ScaledTable] = {}
        self.inputs: dict[str, Any] = {}
        coefficients = arc.moment_coefficients
        for name in INPUTS:
            self.inputs[name] = getattr(coefficients, name)

    @cached_property
    def scales(self) -> dict[str, Any]:
        """Scales of the arc by which parameters of effects are made dimensionless."""
        return scales_of(self.arc)

    def add_start(self, velocity: Any, end_time: Any) -> None:
        """Add the initial velocity, the end time, and initial values of the integrator's records."""
        inputs = self.inputs
        with np.errstate(over="ignore"):  # an overflow is refused where the result is read
            inputs["omega"] = velocity / self.radius * self.time_scale
            inputs["END_TIME"] = end_time / self.time_scale
        limit = self.arc.moment_coefficients.limit_friction
        inputs["LIMIT"] = abs(limit)
        inputs["FACTOR"] = STEP
        inputs["CLOSE"] = np.inf
        inputs["LIFT_TIME"] = np.nan

    # --- effects -----------------------------------------------------------------------------------------------------

    def add_effect(self, effect: str, parameters: Parameters, rotating: bool) -> None:
        """Add the parameters of an effect: numbers by their symbols, functions of time or of the rotation as tables."""
        symbols = symbols_of(effect)
        if not symbols:
            return
        declared = ALL_EFFECTS[without_soil(effect)].parameters
        scales = dict(self.scales)
        for p in declared:
            if p.kind == "number":
                scales[p.name] = parameters.get(p.name, 0.0)
        for p in declared:
            value = parameters.get(p.name, 0.0)
            if not p.symbol or isinstance(value, OfRotation):
                continue  # `add_layers` lays out all functions of layers together
            if not callable(value):
                symbol = symbols[p.name]
                self.inputs[symbol] = p.dimensionless(value, scales)
            elif p.kind == "rotation":
                unit = p.dimensionless(1.0, scales)
                self.tables[p.symbol] = ScaledTable(self._under_water(rotating), factor=unit)
            else:
                factor = factor_of(effect, parameters, p.name)
                scaled = p.dimensionless(factor, scales)
                self.tables[p.symbol] = ScaledTable(tables.of_time(value), self.time_scale, scaled)

    def _under_water(self, rotating: bool) -> Data:
        """Mean pore pressure below a section's water level, Pa, as a function of the rotation until contact is lost."""
        section = self.arc
        assert isinstance(section, Section)

        def pressure(rotation: Any) -> Any:
            places = rotation if section.shape else rotation[:, 0]
            values = section.mean_pressure(places)
            return values.reshape(1, *rotation.shape)

        last = upright(section)
        if rotating:
            first = first_rotation(last, self.upslope)
            kinks = np.atleast_2d(section.pressure_kinks)
            breaks, coefficients = between_kinks(pressure, kinks.T, first, last, self.tolerance)
            coefficients = np.ascontiguousarray(coefficients[:, :, 0])
        else:
            breaks = np.zeros((1, last.size))
            coefficients = np.zeros((1, TERMS, last.size))
            coefficients[0, 0] = pressure(breaks)[0, 0]
        if section.shape:
            return tables.continuous(breaks, coefficients)
        return tables.continuous(breaks[:, 0], coefficients[..., 0])

    def add_layers(self, called: Mapping[str, Parameters], friction: Any) -> None:
        """Add the functions of the rotation that belong to the soils of a layered section."""
        assert isinstance(self.arc, LayeredSection)
        functions = dict[str, OfRotation]()
        for effect, terms in called.items():
            for name, term in terms.items():
                if isinstance(term, OfRotation):
                    symbol = symbols_of(effect)[name]
                    functions[symbol] = term
        if not functions:
            return
        terms = called["layered_strength"]
        self.rotations = RotationTables(self.arc, terms, functions, self.tolerance, self.upslope)
        reach = self.rotations.likely_reach(friction)
        for name, table in self.rotations.laid_out(reach).items():
            self.tables[name] = ScaledTable(table)

    # --- friction laws -----------------------------------------------------------------------------------------------

    def add_law(self, name: str, parameters: Parameters) -> None:
        """Add a friction law: a table, or dimensionless numbers by its name."""
        law = without_soil(name)
        if law == "callable":
            self.function = parameters["function"]
            first_slip = FIRST_SLIP * float(np.max(np.real(self.radius)))
            table = sampled(self.function, first_slip)
            self.tables[name] = ScaledTable(table, self.radius)
        elif law in PIECES:
            length, _, _ = PIECES[law]
            table = tables.of_law(law, parameters)
            self.tables[name] = ScaledTable(table, self.radius / parameters[length])
        elif LAWS[law].parameters[0].kind == "list":
            self.tables[name] = self._listed(LAWS[law], parameters)
        else:
            units = {"m": self.radius, "m/s": self.speed, "": 1.0}
            for p in LAWS[law].parameters:
                value = parameters[p.name]
                self.inputs[f"{name}.{p.name}"] = value / units[p.unit]

    def _listed(self, law: Law, parameters: Parameters) -> ScaledTable:
        """A law that lists coefficients at slips, speeds or times."""
        (argument,) = law.depends_on
        places, coefficients = law.parameters
        x = np.asarray(parameters[places.name], dtype=np.float64)
        y = np.asarray(parameters[coefficients.name], dtype=np.float64)
        table = tables.of_list(argument, x, y)
        scales = {"slip": self.radius, "speed": self.speed, "time": self.time_scale}
        return ScaledTable(table, scales[argument])

    @property
    def speed(self) -> Any:
        """sqrt(R g), m/s for one of the dimensionless speed."""
        return self.radius / self.time_scale


@lru_cache(maxsize=256)
def symbols_of(effect: str) -> dict[str, str]:
    """Symbols of an effect's parameters in the balance, by their names; of one soil with its number."""
    number = soil_number(effect)
    declared = ALL_EFFECTS[without_soil(effect)].parameters
    return {p.name: p.symbol + number for p in declared if p.symbol}


def scales_of(arc: Arc | Section) -> dict[str, Any]:
    """Scales of an arc by which parameters of effects are made dimensionless, SI."""
    unit_weight = plain(arc.mean_unit_weight)
    return {
        "half_angle": arc.half_angle,
        "gravity": arc.gravity,
        "reference_stress": arc.reference_stress,
        "Theta": arc.dimensionless.moment_of_inertia,
        "radius": plain(arc.radius),
        "density": unit_weight / plain(arc.gravity),
        "cover": arc.moment_coefficients.cover,
    }


def rotates(effects: Iterable[str]) -> bool:
    """Whether an effect lets the mass rotate."""
    return any(ALL_EFFECTS[without_soil(effect)].turns for effect in effects)
