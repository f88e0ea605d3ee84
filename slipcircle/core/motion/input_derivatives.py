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
from generated.effects import ALL_EFFECTS, EFFECTS, LAWS, Parameter
from generated.flow import INPUTS, PIECES
from generated.growth import arc_growth
from slipcircle.base.series import Pulse
from slipcircle.core.flow.lanes import Lanes
from slipcircle.core.flow.problem import scales_of
from slipcircle.core.flow.tables import Data, in_pieces, of_law
from slipcircle.core.flow.tangents import InputGrowth, TableGrowth
from slipcircle.core.scene.arc import Arc
from slipcircle.core.scene.complex_step import derivative, with_derivatives
from slipcircle.core.scene.forcing import factor
from slipcircle.core.scene.friction import law_parts
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
        self.growths = self._growths_of_scales(radius, gravity, alpha) | {"Theta": inertia, "cover": cover}
        scales = {name: float(value) for name, value in scales_of(arc).items()}
        for effect, given in lanes.called.items():
            if effect in EFFECTS:
                self._add_effect(effect, given, scales)
        for path, (law, given) in zip(("friction", "friction.rate"), law_parts(lanes.friction), strict=False):
            self._add_law(path, law, given)
        end_dot = self.one("end_time") / float(lanes.time_scale)
        self.growth = InputGrowth(self.time_growth, end_dot, self.tables)
        velocity_growth = self.relative("initial_velocity", lanes.velocity) - self.speed_growth
        self.omega = lanes.problem.cells[ix.OMEGA, 0] * velocity_growth

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
        coefficients = {n: float(problem.cells[problem.program.places[n], 0]) for n in INPUTS}
        if isinstance(arc, LayeredSection):
            return self._layered(arc)
        return self._arc(arc, coefficients) if isinstance(arc, Arc) else self._section(arc, coefficients)

    def _layered(self, section: LayeredSection) -> "_Geometry":
        """Of a layered section all that its soils give: numbers, tables, and the numbers of their mean friction."""
        other = self.with_derivatives
        inputs = {n: derivative(value) for n, value in other.moment_coefficients._asdict().items()}
        friction = dict(other.friction)
        rate = friction.pop("rate", {})
        numbers = {f"friction.{n}": x for n, x in friction.items()} | {f"friction.rate.{n}": x for n, x in rate.items()}
        self.of_friction = {n: derivative(x) + self.none for n, x in numbers.items() if not isinstance(x, str)}
        if "friction.coefficient" in self.of_friction:
            self.of_friction["friction"] = self.of_friction["friction.coefficient"]
        effects = {name: given for name, given in self.lanes.called.items() if name in EFFECTS}
        terms = other.section_effects(effects, complete=True)["layered_strength"]
        symbols = {p.name: p.symbol for p in ALL_EFFECTS["layered_strength"].parameters}
        inputs |= {symbols[n]: derivative(term) for n, term in terms.items() if not isinstance(term, OfRotation)}
        self._add_rotations({symbols[n]: term for n, term in terms.items() if isinstance(term, OfRotation)})
        inertia = derivative(other.moments["moment_of_inertia"]) / float(section.moments["moment_of_inertia"])
        return inputs, derivative(other.half_angle), inertia, self.none

    def _add_rotations(self, functions: Mapping[str, OfRotation]) -> None:
        """Derivatives of functions of the rotation, in the pieces of their tables."""
        count = len(self.names)
        names = {name for function in functions.values() for name in function.coefficients}

        def values(rotation: Floats) -> Floats:
            parts = self.with_derivatives.arc_strength.parts(np.broadcast_to(rotation, (len(rotation), count)), names)
            return np.concatenate([derivative(f.combined(parts)).T[..., None] for f in functions.values()])

        if functions:
            every = self._in_pieces_of(next(iter(functions)), values)
            for k, name in enumerate(functions):
                self.tables[name] = TableGrowth(self.none, self.none, every[k * count : (k + 1) * count])

    def _in_pieces_of(self, name: str, functions: Any) -> list[Data]:
        """Functions of the rotation, (functions, M, 1) of (M, 1), as tables in the pieces of one that there is."""
        problem = self.lanes.problem
        (place,) = (k for k, table in enumerate(problem.program.tables) if table.name == name)
        breaks = problem.tables[place].breaks
        coefficients = in_pieces(functions, breaks)
        jumps = np.zeros(len(breaks))
        return [Data(breaks, np.ascontiguousarray(column), jumps) for column in np.moveaxis(coefficients, -1, 0)]

    def _arc(self, arc: Arc, coefficients: Mapping[str, float]) -> "_Geometry":
        alpha = float(arc.half_angle)
        opened = (self.one("theta_2") - self.one("theta_1")) / 2
        dipped = -arc.facing * (self.one("theta_1") + self.one("theta_2")) / 2
        weight, radial, polar, level, inertia = (float(g) for g in arc_growth(alpha))
        inputs = {
            "driving_moment": coefficients["driving_moment"] * weight * opened
            + coefficients["driving_moment_slope"] * dipped,
            "driving_moment_slope": coefficients["driving_moment_slope"] * weight * opened
            - coefficients["driving_moment"] * dipped,
            "normal_load": coefficients["normal_load"] * radial * opened + coefficients["normal_load_slope"] * dipped,
            "normal_load_slope": coefficients["normal_load_slope"] * radial * opened
            - coefficients["normal_load"] * dipped,
            "polar_moment": coefficients["polar_moment"] * polar * opened,
            "resistance_factor": coefficients["resistance_factor"] * level * opened,
        }
        return inputs, opened, inertia / alpha * opened, 0.0 * opened

    def _section(self, section: Section, coefficients: Mapping[str, float]) -> "_Geometry":
        grown = section_derivatives(section, self.names)
        m = grown.moments
        own = section.moments
        way = section.facing
        theta = own["moment_of_inertia"]
        alpha = float(section.half_angle)
        opened = (grown.ends[1] - grown.ends[0]) / 2
        inertia = m["inertia"] / theta
        changes = {
            "driving_moment": -way * m["moment_x"],
            "driving_moment_slope": -m["moment_y"],
            "normal_load": -m["radial_y"],
            "normal_load_slope": way * m["radial_x"],
            "polar_moment": m["polar"],
        }
        inputs = {n: change / theta - coefficients[n] * inertia for n, change in changes.items()}
        # (3.14): lambda = 2 alpha (1 - cos alpha), by which the mean normal stress and so the mean cover are divided
        inputs["resistance_factor"] = coefficients["resistance_factor"] * (
            opened / alpha + opened / math.tan(alpha / 2) - inertia
        )
        heights = 2 * alpha * float(section.mean_cover / section.radius)
        self.pressure = grown.pressure
        return inputs, opened, inertia, grown.heights / heights + m["radial_y"] / own["radial_weight"]

    def one(self, name: str) -> Floats:
        """Derivatives of a parameter itself: 1 by it, 0 by all others; of a friction that soils make up, by theirs."""
        if name in self.of_friction:
            return self.of_friction[name]
        return np.array([float(n == name) for n in self.names])

    def relative(self, name: str, at: Any) -> Floats:
        """Relative derivatives of a parameter that has a value; 0 where that is 0."""
        return self.one(name) / float(at) if float(at) else self.none

    def _add_effect(self, effect: str, given: Mapping[str, Any], scales: Mapping[str, float]) -> None:
        """Of an effect's parameters, each made dimensionless by powers of the arc's scales and of other numbers."""
        declared = EFFECTS[effect].parameters
        amounts = {p.name: given.get(p.name, 0.0) for p in declared if p.kind == "number"}
        numbers = {name: float(amount) for name, amount in amounts.items() if not callable(amount)}
        growths = self.growths | {name: self.relative(f"{effect}.{name}", x) for name, x in numbers.items()}
        for p in declared:
            if p.symbol:
                growth = self.none
                for name, power in p.powers:
                    if name != "value":
                        growth = growth + power * growths[name]
                self._add_parameter(effect, p, given, {**scales, **numbers}, growth)

    def _add_parameter(
        self, effect: str, p: Parameter, given: Mapping[str, Any], scales: Mapping[str, float], growth: Floats
    ) -> None:
        """Of one parameter, a number or a function; ``growth`` is the relative derivative of its unit."""
        amount = given.get(p.name, 0.0)
        if callable(amount) and p.kind == "rotation":

            def pressures(rotation: Floats) -> Floats:
                return np.asarray(self.pressure(np.broadcast_to(rotation, (len(rotation), len(self.names))))).T[
                    ..., None
                ]

            by_parameter = self._in_pieces_of(p.symbol, pressures)
            self.tables[p.symbol] = TableGrowth(self.none, growth, by_parameter)
        elif callable(amount):
            self.tables[p.symbol] = TableGrowth(self.time_growth, growth + self._factor(effect, given, p.name), None)
        else:
            by_value = (
                dict(p.powers)["value"] * p.dimensionless(amount, scales) / amount
                if amount
                else p.dimensionless(1.0, scales)
            )
            by_unit = p.dimensionless(amount, scales) * growth if amount else self.none
            self.inputs[p.symbol] = by_unit + by_value * self.one(f"{effect}.{p.name}")

    def _factor(self, effect: str, given: Mapping[str, Any], name: str) -> Floats:
        """Relative growth of what a function of time is multiplied by: shaking's amplitude, scale or peak."""
        amount = float(factor(effect, given, name))
        shaken = given[name]
        if isinstance(shaken, Pulse):
            return self.relative(f"{effect}.{'vertical_amplitude' if name == 'vertical' else 'amplitude'}", amount)
        greatest = given["horizontal"].greatest if effect == "shaking" else 1.0
        return self.relative(f"{effect}.scale", amount) + self.relative(f"{effect}.peak", amount * greatest)

    def _add_law(self, path: str, name: str, given: Mapping[str, Any]) -> None:
        """Of a friction law: numbers, or a table, whose argument has a unit of its own."""
        if name == "callable":
            self.tables[name] = TableGrowth(self.radius_growth, self.none, None)
        elif name in PIECES:
            self._add_pieces(path, name, given)
        elif LAWS[name].parameters[0].kind == "list":
            growths = {"slip": self.radius_growth, "speed": self.speed_growth, "time": self.time_growth}
            self.tables[name] = TableGrowth(growths[LAWS[name].depends_on[0]], self.none, None)
        else:
            self._add_law_numbers(path, name, given)

    def _add_pieces(self, path: str, name: str, given: Mapping[str, Any]) -> None:
        """Of a law of slip in pieces: its length scales the argument, and the pieces are linear in its coefficients."""
        length = PIECES[name][0]
        by_coefficient = [(self.one(f"{path}.{n}"), _by_coefficient(name, given, n)) for n in given if n != length]
        by_parameter = list[Data]()
        for k in range(len(self.names)):
            changes = sum(dots[k] * data.coefficients for dots, data in by_coefficient)
            by_parameter.append(by_coefficient[0][1]._replace(coefficients=changes))
        scale = self.radius_growth - self.relative(f"{path}.{length}", given[length])
        self.tables[name] = TableGrowth(scale, self.none, by_parameter)

    def _add_law_numbers(self, path: str, name: str, given: Mapping[str, Any]) -> None:
        growths = {"m": self.radius_growth, "m/s": self.speed_growth, "": self.none}
        problem = self.lanes.problem
        for p in LAWS[name].parameters:
            cell = f"{name}.{p.name}"
            places = problem.program.places
            value = float(given[p.name])
            scaled = float(problem.cells[places[cell], 0]) if cell in places else 0.0
            by_value = scaled / value if value else 1.0
            parameter = "friction" if name == "constant" else f"{path}.{p.name}"
            self.inputs[cell] = by_value * self.one(parameter) - scaled * growths[p.unit]


def _by_coefficient(name: str, given: Mapping[str, Any], coefficient: str) -> Data:
    """The derivative of a law's pieces by a coefficient, in which they are linear; zero for what is none of its own."""
    numbers = {key: float(value) for key, value in given.items()}
    up = dict(numbers)
    down = dict(numbers)
    if coefficient in numbers:
        up[coefficient] += 1.0
        down[coefficient] -= 1.0
    above = of_law(name, up)
    below = of_law(name, down)
    return above._replace(coefficients=(above.coefficients - below.coefficients) / 2)
