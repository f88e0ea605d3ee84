"""Derivatives of the numbers and tables of a program by each number of a scene.

Those of the geometry: `slipcircle.core.motion.geometry_derivatives`; of an effect or a law by the powers that make it
dimensionless.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from generated.effects import EFFECTS, LAWS, Parameter
from generated.flow import INPUTS, PIECES
from slipcircle.base.kinds import Parameters
from slipcircle.base.series import Pulse
from slipcircle.core.flow.interpolation import in_pieces
from slipcircle.core.flow.lanes import Lanes
from slipcircle.core.flow.numbers import scales_of, symbols_of
from slipcircle.core.flow.tables import Data, continuous, of_law
from slipcircle.core.flow.tangents import InputGrowth, TableGrowth
from slipcircle.core.motion.geometry_derivatives import Directions, Floats, Geometry, arc_geometry, section_geometry
from slipcircle.core.scene.arc import Arc
from slipcircle.core.scene.complex_step import derivative, with_derivatives
from slipcircle.core.scene.forcing import factor
from slipcircle.core.scene.friction import law_parts, law_paths, without_soil
from slipcircle.core.scene.layers import LayeredSection
from slipcircle.core.scene.strength import OfRotation


class InputDerivatives(Directions):
    """How the numbers of a program change with each parameter of the scene.

    Attributes
    ----------
    inputs : dict of ndarray
        By name of a cell, its derivatives.
    omega : ndarray
        Derivatives of omega* at the start.
    time_growth, speed_growth, radius_growth : ndarray
        Relative derivatives of the units sqrt(R/g), sqrt(R g) and R.
    growths : dict of ndarray
        Relative derivatives of the scales that make parameters dimensionless.
    tables : dict of TableGrowth
        How each table of the program changes.
    growth : InputGrowth
        What the integrator needs to know on the way.
    """

    def __init__(self, lanes: Lanes, names: Sequence[str]) -> None:
        super().__init__(names)
        self.lanes = lanes
        self.problem = lanes.problem
        self.tables: dict[str, TableGrowth] = {}
        arc = lanes.arc
        radius = self.relative("radius", arc.radius)
        gravity = self.relative("gravity", arc.gravity)
        self.time_growth = (radius - gravity) / 2
        self.speed_growth = (radius + gravity) / 2
        self.radius_growth = radius
        if isinstance(arc, LayeredSection):
            self.with_derivatives = with_derivatives(arc, names)
        self.geometry = self._geometry()
        self.inputs = self.geometry.coefficients
        self.growths = self._growths_of_scales(gravity)
        self._add_effects()
        self._add_laws()
        unit_of_time = float(lanes.time_scale)
        end_dot = self.one("end_time") / unit_of_time
        self.growth = InputGrowth(self.time_growth, end_dot, self.tables)
        velocity_growth = self.relative("initial_velocity", lanes.velocity)
        omega = self._input("omega")
        self.omega = omega * (velocity_growth - self.speed_growth)

    def _input(self, cell: str) -> float:
        """The value of an input of the program."""
        place = self.problem.program.places[cell]
        return float(self.problem.cells[place, 0])

    # --- geometry ----------------------------------------------------------------------------------------------------

    def _geometry(self) -> Geometry:
        """Derivatives of the arc's coefficients and angle, and of its moment of inertia and cover."""
        arc = self.lanes.arc
        if isinstance(arc, LayeredSection):
            return self._layered(arc)
        coefficients = {name: self._input(name) for name in INPUTS}
        if isinstance(arc, Arc):
            return arc_geometry(arc, coefficients, self)
        return section_geometry(arc, coefficients, self.names)

    def _growths_of_scales(self, gravity: Floats) -> dict[str, Floats]:
        """Relative derivatives of what parameters are made dimensionless by."""
        arc = self.lanes.arc
        if isinstance(arc, LayeredSection):
            unit_weight_dot = derivative(self.with_derivatives.mean_unit_weight)
            unit_weight = unit_weight_dot / float(arc.mean_unit_weight)
        else:
            unit_weight = self.relative("unit_weight", arc.unit_weight)
        radius = self.radius_growth
        half_angle = float(arc.half_angle)
        half_angle_dot = self.geometry.half_angle
        return {
            "half_angle": half_angle_dot / half_angle,
            "gravity": gravity,
            "radius": radius,
            # (2.13): sigma_ref = unit weight * R (1 - cos alpha)
            "reference_stress": unit_weight + radius + half_angle_dot / math.tan(half_angle / 2),
            "density": unit_weight - gravity,
            "Theta": self.geometry.inertia_growth,
            "cover": self.geometry.cover_growth,
        }

    def _layered(self, section: LayeredSection) -> Geometry:
        """Of a layered section all that its soils give: numbers, tables, and the numbers of their mean friction."""
        other = self.with_derivatives
        inputs = dict[str, Floats]()
        for name, value in other.moment_coefficients._asdict().items():
            inputs[name] = derivative(value)
        self._add_mean_friction(other.friction)
        functions = dict[str, OfRotation]()
        for symbol, term in self._terms_of_soils().items():
            if isinstance(term, OfRotation):
                functions[symbol] = term
            else:
                inputs[symbol] = derivative(term)
        self._add_rotations(functions)
        inertia = float(section.moments["moment_of_inertia"])
        inertia_dot = derivative(other.moments["moment_of_inertia"])
        half_angle_dot = derivative(other.half_angle)
        return Geometry(inputs, half_angle_dot, inertia_dot / inertia, self.none)

    def _add_mean_friction(self, mean_friction: Parameters) -> None:
        """Derivatives of the numbers of the mean friction of the soils."""
        friction = dict(mean_friction)
        rate = friction.pop("rate", {})
        friction.pop("soils", None)  # whose laws have numbers of their own
        numbers = {f"friction.{name}": value for name, value in friction.items()}
        for name, value in rate.items():
            numbers[f"friction.rate.{name}"] = value
        for name, value in numbers.items():
            if not isinstance(value, str):
                self.of_friction[name] = derivative(value) + self.none
        coefficient = self.of_friction.get("friction.coefficient")
        if coefficient is not None:
            self.of_friction["friction"] = coefficient

    def _terms_of_soils(self) -> dict[str, Any]:
        """What the soils add to the balance, with derivatives, by symbols of the program."""
        called = {}
        for effect, parameters in self.lanes.called.items():
            if effect in EFFECTS:
                called[effect] = parameters
        complete = self.with_derivatives.section_effects(called, complete=True)
        terms = {}
        for effect, added in complete.items():
            if effect in EFFECTS:
                continue
            symbols = symbols_of(effect)
            for name, term in added.items():
                symbol = symbols[name]
                terms[symbol] = term
        return terms

    def _add_rotations(self, functions: Mapping[str, OfRotation]) -> None:
        """Derivatives of functions of the rotation, in the pieces of their tables."""
        if not functions:
            return
        strength = self.with_derivatives.arc_strength
        count = len(self.names)
        parts_of_functions = set[str]()
        for function in functions.values():
            parts_of_functions.update(function.coefficients)

        def values(rotation: Floats) -> Floats:
            shape = (len(rotation), count)
            every_lane = np.broadcast_to(rotation, shape)
            parts = strength.parts(every_lane, parts_of_functions)
            rows = []
            for function in functions.values():
                slopes = derivative(function.combined(parts))
                rows.append(slopes.T[..., None])
            return np.concatenate(rows)

        first_table = next(iter(functions))
        every = self._in_pieces_of(first_table, values)
        for k, name in enumerate(functions):
            first = k * count
            by_parameter = every[first : first + count]
            self._add_table(name, self.none, self.none, by_parameter)

    # --- tables ------------------------------------------------------------------------------------------------------

    def _add_table(
        self, name: str, argument_growth: Floats, factor_growth: Floats, by_parameter: list[Data] | None = None
    ) -> None:
        """The growth of a table's argument and factor, and the derivatives of its values by each parameter."""
        self.tables[name] = TableGrowth(argument_growth, factor_growth, by_parameter)

    def _in_pieces_of(self, name: str, functions: Callable[[Floats], Floats]) -> list[Data]:
        """Functions of the rotation, (functions, M, 1) of (M, 1), as tables in the pieces of one that there is."""
        names = [table.name for table in self.problem.program.tables]
        place = names.index(name)
        breaks = self.problem.tables[place].breaks
        coefficients = in_pieces(functions, breaks)
        tables = list[Data]()
        for of_function in np.moveaxis(coefficients, -1, 0):
            in_order = np.ascontiguousarray(of_function)
            tables.append(continuous(breaks, in_order))
        return tables

    # --- effects -----------------------------------------------------------------------------------------------------

    def _add_effects(self) -> None:
        """Derivatives of the numbers of all effects."""
        scales = dict[str, float]()
        for name, value in scales_of(self.lanes.arc).items():
            scales[name] = float(value)
        for effect, parameters in self.lanes.called.items():
            if effect in EFFECTS:
                self._add_effect(effect, parameters, scales)

    def _add_effect(self, effect: str, parameters: Parameters, scales: Mapping[str, float]) -> None:
        """Of an effect's parameters, each made dimensionless by powers of the arc's scales and of other numbers."""
        declared = EFFECTS[effect].parameters
        of_scene = dict(scales)
        growths = dict(self.growths)
        for p in declared:
            amount = parameters.get(p.name, 0.0)
            parameter = f"{effect}.{p.name}"
            if p.kind == "number" and not callable(amount):
                of_scene[p.name] = float(amount)
                growths[p.name] = self.relative(parameter, amount)
        for p in declared:
            if not p.symbol:
                continue
            growth = self.none
            for name, power in p.powers:
                if name != "value":
                    growth = growth + power * growths[name]
            amount = parameters.get(p.name, 0.0)
            if not callable(amount):
                self._add_number(effect, p, amount, of_scene, growth)
            elif p.kind == "rotation":
                by_parameter = self._in_pieces_of(p.symbol, self._pressures)
                self._add_table(p.symbol, self.none, growth, by_parameter)
            else:
                factor_growth = growth + self._factor(effect, parameters, p.name)
                self._add_table(p.symbol, self.time_growth, factor_growth)

    def _add_number(
        self, effect: str, p: Parameter, amount: float, scales: Mapping[str, float], growth: Floats
    ) -> None:
        """Of one parameter that is a number; ``growth`` is the relative derivative of its unit."""
        parameter = f"{effect}.{p.name}"
        by_itself = self.one(parameter)
        if not amount:
            unit = p.dimensionless(1.0, scales)
            self.inputs[p.symbol] = unit * by_itself
            return
        scaled = p.dimensionless(amount, scales)
        power = dict(p.powers)["value"]
        slope = power * scaled / amount
        by_unit = scaled * growth
        self.inputs[p.symbol] = by_unit + slope * by_itself

    def _pressures(self, rotation: Floats) -> Floats:
        """Derivatives of a section's mean water pressure by each parameter, (parameters, M, 1) at rotations (M, 1)."""
        assert self.geometry.pressure is not None
        shape = (len(rotation), len(self.names))
        every_parameter = np.broadcast_to(rotation, shape)
        slopes = np.asarray(self.geometry.pressure(every_parameter))
        return slopes.T[..., None]

    def _factor(self, effect: str, parameters: Parameters, name: str) -> Floats:
        """Relative growth of what a function of time is multiplied by: shaking's amplitude, scale or peak."""
        amount = float(factor(effect, parameters, name))
        if isinstance(parameters[name], Pulse):
            amplitude = "vertical_amplitude" if name == "vertical" else "amplitude"
            return self.relative(f"{effect}.{amplitude}", amount)
        greatest = 1.0
        if effect == "shaking":
            greatest = parameters["horizontal"].greatest
        by_scale = self.relative(f"{effect}.scale", amount)
        by_peak = self.relative(f"{effect}.peak", amount * greatest)
        return by_scale + by_peak

    # --- friction laws -----------------------------------------------------------------------------------------------

    def _add_laws(self) -> None:
        """Derivatives of the numbers and tables of all laws of friction."""
        friction = self.lanes.friction
        paths = law_paths(friction)
        laws = law_parts(friction)
        for path, (law, parameters) in zip(paths, laws, strict=True):
            self._add_law(path, law, parameters)

    def _add_law(self, path: str, table: str, parameters: Parameters) -> None:
        """Of a friction law: numbers, or a table, whose argument has another unit."""
        name = without_soil(table)
        if name == "callable":
            self._add_table(name, self.radius_growth, self.none)
        elif name in PIECES:
            self._add_pieces(path, table, parameters)
        elif LAWS[name].parameters[0].kind == "list":
            growths = {"slip": self.radius_growth, "speed": self.speed_growth, "time": self.time_growth}
            (argument,) = LAWS[name].depends_on
            self._add_table(table, growths[argument], self.none)
        else:
            self._add_law_numbers(path, table, parameters)

    def _add_pieces(self, path: str, table: str, parameters: Parameters) -> None:
        """Of a law of slip in pieces: its length scales the argument, and the pieces are linear in its coefficients."""
        law = without_soil(table)
        length, _, _ = PIECES[law]
        numbers = {name: float(value) for name, value in parameters.items()}
        pieces = of_law(law, numbers)
        shape = (len(self.names), *pieces.coefficients.shape)
        changes = np.zeros(shape)
        for name in numbers:
            if name == length:
                continue
            unit_change = _by_coefficient(law, numbers, name)
            dots = self.one(f"{path}.{name}")
            changes += np.multiply.outer(dots, unit_change)
        by_parameter = [pieces._replace(coefficients=change) for change in changes]
        length_growth = self.relative(f"{path}.{length}", parameters[length])
        argument_growth = self.radius_growth - length_growth
        self._add_table(table, argument_growth, self.none, by_parameter)

    def _add_law_numbers(self, path: str, law: str, parameters: Parameters) -> None:
        """Of a law that is a formula of its numbers."""
        growths = {"m": self.radius_growth, "m/s": self.speed_growth, "": self.none}
        name = without_soil(law)
        for p in LAWS[name].parameters:
            cell = f"{law}.{p.name}"
            scaled = self._input(cell)
            value = float(parameters[p.name])
            by_value = scaled / value if value else 1.0
            parameter = path if name == "constant" else f"{path}.{p.name}"
            by_itself = by_value * self.one(parameter)
            by_unit = scaled * growths[p.unit]
            self.inputs[cell] = by_itself - by_unit


def _by_coefficient(law: str, numbers: Mapping[str, float], changed: str) -> Floats:
    """The derivative of the coefficients of a law's pieces by a number in which they are linear."""
    above = dict(numbers)
    below = dict(numbers)
    above[changed] += 1.0
    below[changed] -= 1.0
    upper = of_law(law, above)
    lower = of_law(law, below)
    return (upper.coefficients - lower.coefficients) / 2
