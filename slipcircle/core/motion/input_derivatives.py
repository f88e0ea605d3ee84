"""How the numbers that a program is given change with each number of a scene.

Those of an arc by its derived growth; those of a section by the transport of its integrals; of an effect or a law by
the powers that make it dimensionless.
"""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from generated.effects import EFFECTS, LAWS, Parameter
from generated.flow import INPUTS, PIECES
from generated.growth import arc_growth
from slipcircle.base.series import Pulse
from slipcircle.core.flow.interpolation import in_pieces
from slipcircle.core.flow.lanes import Lanes
from slipcircle.core.flow.numbers import scales_of, symbols_of
from slipcircle.core.flow.tables import Data, of_law
from slipcircle.core.flow.tangents import InputGrowth, TableGrowth
from slipcircle.core.scene.arc import Arc
from slipcircle.core.scene.complex_step import derivative, with_derivatives
from slipcircle.core.scene.forcing import factor
from slipcircle.core.scene.friction import law_parts, law_paths, without_soil
from slipcircle.core.scene.layers import LayeredSection
from slipcircle.core.scene.section import Section
from slipcircle.core.scene.strength import OfRotation
from slipcircle.core.scene.transport import section_derivatives

Floats = NDArray[np.float64]
# What is given, alpha, and relatively Theta* and the cover.
_Geometry = tuple[dict[str, Floats], Floats, Floats, Floats]


class InputDerivatives:
    """How the numbers of a program change with each parameter of the scene.

    Attributes
    ----------
    inputs : dict of ndarray
        By name of a cell, its derivatives.
    omega : ndarray
        Derivatives of omega* at the start.
    time_growth, speed_growth, radius_growth : ndarray
        Relative derivatives of the units sqrt(R/g), sqrt(R g) and R.
    growth : InputGrowth
        What the integrator needs to know on the way.
    """

    def __init__(self, lanes: Lanes, names: Sequence[str]) -> None:
        self.lanes = lanes
        self.names = names
        self.none = np.zeros(len(names))
        self.tables: dict[str, TableGrowth] = {}
        self.of_friction: dict[str, Floats] = {}  # of the numbers of a law that the soils make up
        arc = lanes.arc
        radius = self.relative("radius", arc.radius)
        gravity = self.relative("gravity", arc.gravity)
        self.time_growth = (radius - gravity) / 2
        self.speed_growth = (radius + gravity) / 2
        self.radius_growth = radius
        if isinstance(arc, LayeredSection):
            self.with_derivatives = with_derivatives(arc, names)
        self.inputs, alpha, inertia, cover = self._geometry()
        self.growths = self._growths_of_scales(radius, gravity, alpha)
        self.growths |= {"Theta": inertia, "cover": cover}
        self._add_effects()
        self._add_laws()
        unit_of_time = float(lanes.time_scale)
        end_dot = self.one("end_time") / unit_of_time
        self.growth = InputGrowth(self.time_growth, end_dot, self.tables)
        velocity_growth = self.relative("initial_velocity", lanes.velocity) - self.speed_growth
        omega = lanes.problem.cells[ix.OMEGA, 0]
        self.omega = omega * velocity_growth

    def _add_effects(self) -> None:
        """Derivatives of the numbers of all effects."""
        scales = {name: float(value) for name, value in scales_of(self.lanes.arc).items()}
        for effect, given in self.lanes.called.items():
            if effect in EFFECTS:
                self._add_effect(effect, given, scales)

    def _add_laws(self) -> None:
        """Derivatives of the numbers and tables of all laws of friction."""
        friction = self.lanes.friction
        for path, (law, given) in zip(law_paths(friction), law_parts(friction), strict=True):
            self._add_law(path, law, given)

    def _growths_of_scales(self, radius: Floats, gravity: Floats, alpha: Floats) -> dict[str, Floats]:
        """Relative derivatives of what parameters are made dimensionless by; alpha's own is absolute."""
        arc = self.lanes.arc
        if isinstance(arc, LayeredSection):
            unit_weight = derivative(self.with_derivatives.mean_unit_weight) / float(arc.mean_unit_weight)
        else:
            unit_weight = self.relative("unit_weight", arc.unit_weight)
        half_angle = float(arc.half_angle)
        return {
            "half_angle": alpha / half_angle,
            "gravity": gravity,
            "radius": radius,
            # (2.13): sigma_ref = unit weight * R (1 - cos alpha)
            "reference_stress": unit_weight + radius + alpha / math.tan(half_angle / 2),
            "density": unit_weight - gravity,
        }

    def _geometry(self) -> "_Geometry":
        """Derivatives of the arc's coefficients and angle, and of its moment of inertia and cover."""
        arc = self.lanes.arc
        problem = self.lanes.problem
        places = problem.program.places
        coefficients = {name: float(problem.cells[places[name], 0]) for name in INPUTS}
        if isinstance(arc, LayeredSection):
            return self._layered(arc)
        if isinstance(arc, Arc):
            return self._arc(arc, coefficients)
        return self._section(arc, coefficients)

    def _layered(self, section: LayeredSection) -> "_Geometry":
        """Of a layered section all that its soils give: numbers, tables, and the numbers of their mean friction."""
        other = self.with_derivatives
        coefficients = other.moment_coefficients._asdict()
        inputs = {name: derivative(value) for name, value in coefficients.items()}
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
        return inputs, derivative(other.half_angle), inertia_dot / inertia, self.none

    def _add_mean_friction(self, mean_friction: Mapping[str, Any]) -> None:
        """Derivatives of the numbers of the mean friction of the soils."""
        friction = dict(mean_friction)
        rate = friction.pop("rate", {})
        friction.pop("soils", None)  # whose laws are by their own numbers
        numbers = {f"friction.{name}": value for name, value in friction.items()}
        numbers |= {f"friction.rate.{name}": value for name, value in rate.items()}
        for name, value in numbers.items():
            if not isinstance(value, str):
                self.of_friction[name] = derivative(value) + self.none
        if "friction.coefficient" in self.of_friction:
            self.of_friction["friction"] = self.of_friction["friction.coefficient"]

    def _terms_of_soils(self) -> dict[str, Any]:
        """What the soils add to the balance, with derivatives, by symbols of the program."""
        called = {name: given for name, given in self.lanes.called.items() if name in EFFECTS}
        terms = {}
        for effect, added in self.with_derivatives.section_effects(called, complete=True).items():
            if effect in EFFECTS:
                continue
            symbols = symbols_of(effect)
            for name, term in added.items():
                terms[symbols[name]] = term
        return terms

    def _add_rotations(self, functions: Mapping[str, OfRotation]) -> None:
        """Derivatives of functions of the rotation, in the pieces of their tables."""
        if not functions:
            return
        count = len(self.names)
        names = {name for function in functions.values() for name in function.coefficients}

        def values(rotation: Floats) -> Floats:
            every_lane = np.broadcast_to(rotation, (len(rotation), count))
            parts = self.with_derivatives.arc_strength.parts(every_lane, names)
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
            self.tables[name] = TableGrowth(self.none, self.none, by_parameter)

    def _in_pieces_of(self, name: str, functions: Any) -> list[Data]:
        """Functions of the rotation, (functions, M, 1) of (M, 1), as tables in the pieces of one that there is."""
        problem = self.lanes.problem
        table_names = [table.name for table in problem.program.tables]
        breaks = problem.tables[table_names.index(name)].breaks
        coefficients = in_pieces(functions, breaks)
        by_function = np.moveaxis(coefficients, -1, 0)
        jumps = np.zeros(len(breaks))
        return [Data(breaks, np.ascontiguousarray(column), jumps) for column in by_function]

    def _arc(self, arc: Arc, coefficients: Mapping[str, float]) -> "_Geometry":
        """A change of the half angle scales the coefficients; one of the dip turns them into their slopes."""
        theta_1 = self.one("theta_1")
        theta_2 = self.one("theta_2")
        alpha_dot = (theta_2 - theta_1) / 2
        dip_dot = -arc.facing * (theta_1 + theta_2) / 2
        alpha = float(arc.half_angle)
        weight, radial, polar, resistance, inertia = (float(growth) for growth in arc_growth(alpha))
        polar_moment = coefficients["polar_moment"]
        resistance_factor = coefficients["resistance_factor"]
        inputs = {
            "polar_moment": polar_moment * polar * alpha_dot,
            "resistance_factor": resistance_factor * resistance * alpha_dot,
        }
        for name, growth in (("driving_moment", weight), ("normal_load", radial)):
            name_of_slope = f"{name}_slope"
            size = coefficients[name]
            slope = coefficients[name_of_slope]
            inputs[name] = size * growth * alpha_dot + slope * dip_dot
            inputs[name_of_slope] = slope * growth * alpha_dot - size * dip_dot
        inertia_growth = inertia / alpha * alpha_dot
        cover_growth = 0.0 * alpha_dot
        return inputs, alpha_dot, inertia_growth, cover_growth

    def _section(self, section: Section, coefficients: Mapping[str, float]) -> "_Geometry":
        """By the derivatives of the section's integrals, and of its ends."""
        section_dot = section_derivatives(section, self.names)
        integrals_dot = section_dot.moments
        integrals = section.moments
        theta = integrals["moment_of_inertia"]
        inertia_growth = integrals_dot["inertia"] / theta
        facing = section.facing
        changes = {
            "driving_moment": -facing * integrals_dot["moment_x"],
            "driving_moment_slope": -integrals_dot["moment_y"],
            "normal_load": -integrals_dot["radial_y"],
            "normal_load_slope": facing * integrals_dot["radial_x"],
            "polar_moment": integrals_dot["polar"],
        }
        inputs = {name: change / theta - coefficients[name] * inertia_growth for name, change in changes.items()}
        first_end, last_end = section_dot.ends
        alpha_dot = (last_end - first_end) / 2
        alpha = float(section.half_angle)
        # (3.14): lambda = 2 alpha (1 - cos alpha), by which the mean normal stress and so the mean cover are divided
        lambda_growth = alpha_dot / alpha + alpha_dot / math.tan(alpha / 2)
        inputs["resistance_factor"] = coefficients["resistance_factor"] * (lambda_growth - inertia_growth)
        heights = 2 * alpha * float(section.mean_cover / section.radius)
        cover_growth = section_dot.heights / heights + integrals_dot["radial_y"] / integrals["radial_weight"]
        self.pressure = section_dot.pressure
        return inputs, alpha_dot, inertia_growth, cover_growth

    def one(self, name: str) -> Floats:
        """Derivatives of a parameter itself: 1 by it, 0 by all others; of a friction that soils make up, by theirs."""
        if name in self.of_friction:
            return self.of_friction[name]
        return np.array([float(other == name) for other in self.names])

    def relative(self, name: str, at: Any) -> Floats:
        """Relative derivatives of a parameter that has a value; 0 where that is 0."""
        value = float(at)
        return self.one(name) / value if value else self.none

    def _add_effect(self, effect: str, given: Mapping[str, Any], scales: Mapping[str, float]) -> None:
        """Of an effect's parameters, each made dimensionless by powers of the arc's scales and of other numbers."""
        declared = EFFECTS[effect].parameters
        numbers = dict[str, float]()
        growths = dict(self.growths)
        for p in declared:
            amount = given.get(p.name, 0.0)
            if p.kind == "number" and not callable(amount):
                numbers[p.name] = float(amount)
                growths[p.name] = self.relative(f"{effect}.{p.name}", amount)
        of_scene = {**scales, **numbers}
        for p in declared:
            if p.symbol:
                powers = [power * growths[name] for name, power in p.powers if name != "value"]
                growth = sum(powers, start=self.none)
                self._add_parameter(effect, p, given, of_scene, growth)

    def _add_parameter(
        self, effect: str, p: Parameter, given: Mapping[str, Any], scales: Mapping[str, float], growth: Floats
    ) -> None:
        """Of one parameter, a number or a function; ``growth`` is the relative derivative of its unit."""
        amount = given.get(p.name, 0.0)
        if callable(amount) and p.kind == "rotation":

            def pressures(rotation: Floats) -> Floats:
                every_parameter = np.broadcast_to(rotation, (len(rotation), len(self.names)))
                slopes = np.asarray(self.pressure(every_parameter))
                return slopes.T[..., None]

            by_parameter = self._in_pieces_of(p.symbol, pressures)
            self.tables[p.symbol] = TableGrowth(self.none, growth, by_parameter)
            return
        if callable(amount):
            factor_growth = growth + self._factor(effect, given, p.name)
            self.tables[p.symbol] = TableGrowth(self.time_growth, factor_growth, None)
            return
        by_itself = self.one(f"{effect}.{p.name}")
        if amount:
            scaled = p.dimensionless(amount, scales)
            power = dict(p.powers)["value"]
            self.inputs[p.symbol] = scaled * growth + power * scaled / amount * by_itself
        else:
            self.inputs[p.symbol] = p.dimensionless(1.0, scales) * by_itself

    def _factor(self, effect: str, given: Mapping[str, Any], name: str) -> Floats:
        """Relative growth of what a function of time is multiplied by: shaking's amplitude, scale or peak."""
        amount = float(factor(effect, given, name))
        if isinstance(given[name], Pulse):
            amplitude = "vertical_amplitude" if name == "vertical" else "amplitude"
            return self.relative(f"{effect}.{amplitude}", amount)
        greatest = given["horizontal"].greatest if effect == "shaking" else 1.0
        by_scale = self.relative(f"{effect}.scale", amount)
        by_peak = self.relative(f"{effect}.peak", amount * greatest)
        return by_scale + by_peak

    def _add_law(self, path: str, table: str, given: Mapping[str, Any]) -> None:
        """Of a friction law: numbers, or a table, whose argument has a unit of its own."""
        name = without_soil(table)
        if name == "callable":
            self.tables[name] = TableGrowth(self.radius_growth, self.none, None)
        elif name in PIECES:
            self._add_pieces(path, table, given)
        elif LAWS[name].parameters[0].kind == "list":
            growths = {"slip": self.radius_growth, "speed": self.speed_growth, "time": self.time_growth}
            argument = LAWS[name].depends_on[0]
            self.tables[table] = TableGrowth(growths[argument], self.none, None)
        else:
            self._add_law_numbers(path, table, given)

    def _add_pieces(self, path: str, table: str, given: Mapping[str, Any]) -> None:
        """Of a law of slip in pieces: its length scales the argument, and the pieces are linear in its coefficients."""
        name = without_soil(table)
        length, _, _ = PIECES[name]
        coefficients = {key: float(value) for key, value in given.items()}
        names = [n for n in coefficients if n != length]
        by_coefficient = [_by_coefficient(name, coefficients, n) for n in names]
        dots = np.array([self.one(f"{path}.{n}") for n in names])
        slopes = np.array([data.coefficients for data in by_coefficient])
        by_parameter = list[Data]()
        for of_parameter in dots.T:
            changes = sum(dot * slope for dot, slope in zip(of_parameter, slopes, strict=True))
            by_parameter.append(by_coefficient[0]._replace(coefficients=changes))
        length_growth = self.relative(f"{path}.{length}", given[length])
        argument_growth = self.radius_growth - length_growth
        self.tables[table] = TableGrowth(argument_growth, self.none, by_parameter)

    def _add_law_numbers(self, path: str, law: str, given: Mapping[str, Any]) -> None:
        growths = {"m": self.radius_growth, "m/s": self.speed_growth, "": self.none}
        problem = self.lanes.problem
        places = problem.program.places
        name = without_soil(law)
        for p in LAWS[name].parameters:
            cell = f"{law}.{p.name}"
            scaled = float(problem.cells[places[cell], 0]) if cell in places else 0.0
            value = float(given[p.name])
            by_value = scaled / value if value else 1.0
            parameter = path if name == "constant" else f"{path}.{p.name}"
            by_itself = by_value * self.one(parameter)
            by_unit = scaled * growths[p.unit]
            self.inputs[cell] = by_itself - by_unit


def _by_coefficient(name: str, coefficients: Mapping[str, float], changed: str) -> Data:
    """The derivative of a law's pieces by a coefficient, in which they are linear; zero for what is none of its own."""
    above = dict(coefficients)
    below = dict(coefficients)
    if changed in coefficients:
        above[changed] += 1.0
        below[changed] -= 1.0
    upper = of_law(name, above)
    lower = of_law(name, below)
    slope = (upper.coefficients - lower.coefficients) / 2
    return upper._replace(coefficients=slope)
