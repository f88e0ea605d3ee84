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
from generated.effects import EFFECTS, LAWS
from generated.flow import PIECES
from generated.growth import arc_growth
from slipcircle.base.series import Pulse
from slipcircle.core.flow.lanes import Lanes
from slipcircle.core.flow.problem import rotates, scales_of, under_water
from slipcircle.core.flow.tables import Data, of_law
from slipcircle.core.flow.tangents import InputGrowth, TableGrowth
from slipcircle.core.scene.arc import Arc
from slipcircle.core.scene.forcing import factor
from slipcircle.core.scene.friction import law_parts
from slipcircle.core.scene.section import Section
from slipcircle.core.scene.transport import section_derivatives

Floats = NDArray[np.float64]
_COMPONENTS = ("fall", "press", "fall_slope", "press_slope")
# What is given, alpha, and relatively Theta* and the cover.
_Geometry = tuple[dict[str, Floats], Floats, Floats, Floats]


class InputDerivatives:
    """How the numbers of a program change with each parameter of the scene."""

    def __init__(self, lanes: Lanes, names: Sequence[str]) -> None:
        self.lanes, self.names = lanes, names
        arc = lanes.arc
        radius, gravity = self.relative("radius", arc.radius), self.relative("gravity", arc.gravity)
        unit_weight = self.relative("unit_weight", arc.unit_weight)
        self.time_growth, self.speed_growth, self.radius_growth = (radius - gravity) / 2, (radius + gravity) / 2, radius
        c, at = lanes.problem.cells[:, 0], {n: k for k, n in enumerate(lanes.problem.program.cells)}
        held = {n: float(c[at[n]]) for n in (*_COMPONENTS, "polar", "level")}
        found = self._arc(arc, held) if isinstance(arc, Arc) else self._section(arc, held)
        self.inputs, alpha, inertia, cover = found
        # (2.13): sigma_ref = unit weight * R (1 - cos alpha)
        self.growths = {
            "half_angle": alpha / float(arc.half_angle),
            "gravity": gravity,
            "Theta": inertia,
            "radius": radius,
            "reference_stress": unit_weight + radius + alpha / math.tan(float(arc.half_angle) / 2),
            "density": unit_weight - gravity,
            "cover": cover,
        }
        self.tables: dict[str, TableGrowth] = {}
        self._effects()
        self._laws(c, at)
        self.growth = InputGrowth(self.time_growth, self.one("end_time") / float(lanes.time_scale), self.tables)
        self.omega = c[ix.OMEGA] * (self.relative("initial_velocity", lanes.velocity) - self.speed_growth)

    def _arc(self, arc: Arc, held: Mapping[str, float]) -> "_Geometry":
        alpha = float(arc.half_angle)
        opened = (self.one("theta_2") - self.one("theta_1")) / 2
        dipped = -arc.facing * (self.one("theta_1") + self.one("theta_2")) / 2
        weight, radial, polar, level, inertia = (float(g) for g in arc_growth(alpha))
        inputs = {
            "fall": held["fall"] * weight * opened + held["fall_slope"] * dipped,
            "fall_slope": held["fall_slope"] * weight * opened - held["fall"] * dipped,
            "press": held["press"] * radial * opened + held["press_slope"] * dipped,
            "press_slope": held["press_slope"] * radial * opened - held["press"] * dipped,
            "polar": held["polar"] * polar * opened,
            "level": held["level"] * level * opened,
        }
        return inputs, opened, inertia / alpha * opened, 0.0 * opened

    def _section(self, section: Section, held: Mapping[str, float]) -> "_Geometry":
        grown = section_derivatives(section, self.names)
        m, own, way = grown.moments, section.moments, section.facing
        theta, alpha = own["moment_of_inertia"], float(section.half_angle)
        opened, inertia = (grown.ends[1] - grown.ends[0]) / 2, m["inertia"] / theta
        changes = {
            "fall": -way * m["moment_x"],
            "fall_slope": -m["moment_y"],
            "press": -m["radial_y"],
            "press_slope": way * m["radial_x"],
            "polar": m["polar"],
        }
        inputs = {n: change / theta - held[n] * inertia for n, change in changes.items()}
        # (3.14): lambda = 2 alpha (1 - cos alpha), by which the mean normal stress and so the mean cover are divided
        inputs["level"] = held["level"] * (opened / alpha + opened / math.tan(alpha / 2) - inertia)
        heights = 2 * alpha * float(section.mean_cover / section.radius)
        self.pressure = under_water(section, rotates(self.lanes.called), grown.pressure, len(self.names))
        return inputs, opened, inertia, grown.heights / heights + m["radial_y"] / own["radial_weight"]

    def one(self, name: str) -> Floats:
        return np.array([float(n == name) for n in self.names])

    def relative(self, name: str, at: Any) -> Floats:
        return self.one(name) / float(at) if float(at) else self.one(name) * 0.0

    def _effects(self) -> None:
        scales = {name: float(value) for name, value in scales_of(self.lanes.arc).items()}
        for effect, given in self.lanes.called.items():
            own = {p.name: given.get(p.name, 0.0) for p in EFFECTS[effect].parameters if p.kind == "number"}
            numbers = {n: float(v) for n, v in own.items() if not callable(v)}
            growths = self.growths | {n: self.relative(f"{effect}.{n}", v) for n, v in numbers.items()}
            for p in EFFECTS[effect].parameters:
                if not p.symbol:
                    continue
                # What makes a parameter dimensionless is a product of powers: each is told by doubling what it is of.
                growth = 0.0 * self.time_growth
                unit = p.dimensionless(1.0, scales | numbers)
                for name, amount in (scales | numbers).items():
                    if name == p.name or not amount:
                        continue
                    doubled = p.dimensionless(1.0, scales | numbers | {name: 2 * amount})
                    growth = growth + round(2 * math.log2(doubled / unit)) / 2 * growths[name]
                amount = given.get(p.name, 0.0)
                if callable(amount) and p.kind == "rotation":
                    data = [self.pressure.lanes(k) for k in range(len(self.names))]
                    self.tables[p.symbol] = TableGrowth(0.0 * growth, growth, data)
                    continue
                if callable(amount):
                    self.tables[p.symbol] = TableGrowth(
                        self.time_growth, growth + self._factor(effect, given, p.name), None
                    )
                    continue
                power = 1.0 if not amount else round(2 * math.log2(p.dimensionless(2.0, scales | numbers) / unit)) / 2
                value_dot = growth * p.dimensionless(amount, scales | numbers) if amount else 0.0 * growth
                whole = p.dimensionless(amount, scales | numbers) if amount else unit
                self.inputs[p.symbol] = value_dot + whole * power / (amount or 1.0) * self.one(f"{effect}.{p.name}")

    def _factor(self, effect: str, given: Mapping[str, Any], name: str) -> Floats:
        """Relative growth of what a function of time is multiplied by: shaking's amplitude, scale or peak."""
        amount, shaken = float(factor(effect, given, name)), given[name]
        if isinstance(shaken, Pulse):
            return self.relative(f"{effect}.{'vertical_amplitude' if name == 'vertical' else 'amplitude'}", amount)
        greatest = given["horizontal"].greatest if effect == "shaking" else 1.0
        return self.relative(f"{effect}.scale", amount) + self.relative(f"{effect}.peak", amount * greatest)

    def _laws(self, c: Floats, at: Mapping[str, int]) -> None:
        for path, (name, given) in zip(("friction", "friction.rate"), law_parts(self.lanes.friction), strict=False):
            if name == "callable":
                self.tables[name] = TableGrowth(self.radius_growth, 0.0 * self.time_growth, None)
                continue
            law = LAWS[name]
            growth = {"m": self.radius_growth, "m/s": self.speed_growth, "": 0.0 * self.time_growth}
            if name in PIECES:
                over = PIECES[name][0]
                length = self.radius_growth - self.relative(f"{path}.{over}", given[over])
                plain = [n.removeprefix(f"{path}.") for n in self.names]
                data = [_changed(name, given, n if n in given and n != over else "") for n in plain]
                self.tables[name] = TableGrowth(length, 0.0 * length, data)
            elif law.parameters[0].kind == "list":
                scale = {"slip": self.radius_growth, "speed": self.speed_growth, "time": self.time_growth}
                self.tables[name] = TableGrowth(scale[law.depends_on[0]], 0.0 * self.time_growth, None)
            else:
                for p in law.parameters:
                    cell = c[at[f"{name}.{p.name}"]] if f"{name}.{p.name}" in at else 0.0
                    own = self.one("friction" if name == "constant" else f"{path}.{p.name}")
                    per = cell / float(given[p.name]) if float(given[p.name]) else 1.0
                    self.inputs[f"{name}.{p.name}"] = own * per - cell * growth[p.unit]


def _changed(name: str, given: Mapping[str, Any], parameter: str) -> Data:
    """How the pieces of a law change with a coefficient, in which they are linear."""
    numbers = {n: float(v) for n, v in given.items()}
    up, down = (of_law(name, numbers | ({parameter: numbers[parameter] + by} if parameter else {})) for by in (1, -1))
    return up._replace(coefficients=(up.coefficients - down.coefficients) / 2)
