"""Dimensionless numbers and tables of a scene, by the declarations of effects and laws in `generated.effects`."""

import math
from collections.abc import Callable
from functools import cached_property
from typing import Any

import numpy as np

from generated.effects import ALL_EFFECTS, LAWS
from generated.flow import FRAGMENTS, INPUTS
from slipcircle.base.checks import plain
from slipcircle.base.kinds import Effects, Parameters
from slipcircle.core.doors import room
from slipcircle.core.scene.effects import symbols_of, without_soil
from slipcircle.core.scene.mass import Farther, Mass
from slipcircle.core.scene.piecewise import Data

STEP = math.exp(-2.0)  # of the radius of convergence, so that a series of order n leaves exp(-2 n)
FIRST_SLIP = 1 / 256  # over the radius, to which a Python function of slip is sampled at first


class Numbers:
    """Dimensionless numbers and tables of a scene, by their names in its program.

    Parameters
    ----------
    arc : Mass
    """

    function: Callable[[Any], Any]  # the friction law, where that is a Python function
    farther: Farther | None = None

    def __init__(self, arc: Mass) -> None:
        self.arc = arc
        self.time_scale = plain(arc.time_scale)
        self.radius = plain(arc.radius)
        self.tables: dict[str, Data] = {}
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

    def add_table(self, name: str, data: Data, scale: Any = 1.0, factor: Any = 1.0) -> None:
        """Add a piecewise function with the scale of its argument and the factor of its values."""
        self.tables[name] = data
        self.inputs[f"{name}.SCALE"] = scale
        self.inputs[f"{name}.SCALED_BY"] = factor

    # --- effects -----------------------------------------------------------------------------------------------------

    def add_effect(self, effect: str, parameters: Parameters) -> None:
        """Add the parameters of an effect: numbers by their symbols, functions of time as tables."""
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
            if not p.symbol:
                continue
            symbol = symbols[p.name]
            if not callable(value):
                self.inputs[symbol] = p.dimensionless(value, scales)
            elif p.kind != "series":  # a function of the rotation, which the mass lays out
                self.inputs[f"{symbol}.SCALED_BY"] = p.dimensionless(1.0, scales)
            else:
                factor = room("forcing").factor(effect, parameters, p.name)
                scaled = p.dimensionless(factor, scales)
                self.add_table(symbol, room("tables").of_time(value), self.time_scale, scaled)

    def add_rotations(self, called: Effects, friction: Any, upslope: bool, tolerance: float) -> None:
        """Add the functions of the rotation that belong to the mass."""
        tables, self.farther = self.arc.tables(called, friction, upslope, tolerance)
        for name, table in tables.items():
            self.add_table(name, table, factor=self.inputs[f"{name}.SCALED_BY"])

    # --- friction laws -----------------------------------------------------------------------------------------------

    def add_law(self, name: str, parameters: Parameters) -> None:
        """Add a friction law: a table, or dimensionless numbers by its name."""
        law = without_soil(name)
        units = {"m": self.radius, "m/s": self.speed, "s": self.time_scale, "": 1.0}
        if law == "callable":
            self.function = parameters["function"]
            first_slip = FIRST_SLIP * float(np.max(np.real(self.radius)))
            table = room("functions").sampled(self.function, first_slip)
            self.add_table(name, table, self.radius)
        elif FRAGMENTS[law].tables:
            table, scale, unit = room("tables").of_law(law, parameters)
            self.add_table(name, table, units[unit] / scale)
        else:
            for p in LAWS[law].parameters:
                value = parameters[p.name]
                self.inputs[f"{name}.{p.name}"] = value / units[p.unit]

    @property
    def speed(self) -> Any:
        """sqrt(R g), m/s for one of the dimensionless speed."""
        return self.radius / self.time_scale


def scales_of(arc: Mass) -> dict[str, Any]:
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
