"""Ensembles of one slide that between them take every way through the integrator."""

import math
from typing import Any

import numpy as np

from slipcircle import Scene, load
from slipcircle.tables import Pulse, Series
from tests.support.lanes import Problem, posed

TURNING: dict[str, Any] = {"rotation": {}, "centripetal": {}}
LANES = 37
MU = np.tan(np.radians(np.linspace(12.0, 31.0, LANES)))
_RNG = np.random.default_rng(20240229)
PUSHED = np.where(np.arange(LANES) % 3 == 0, _RNG.normal(size=LANES) * 3.0, 0.0)


def _record(size: float) -> Series:
    values = np.convolve(_RNG.normal(size=100), np.exp(-np.arange(21) / 5.0), "valid") * size
    return Series(np.linspace(0.0, 3.95, 80), values, held=False)


SHAKEN = {"horizontal": _record(0.08), "vertical": _record(0.2)}
PULSE = Pulse("sine", 0.3, 0.5, 12.0, 6.0)
SCENES: dict[str, tuple[dict[str, Any], Any, float]] = {
    "constant": (TURNING, MU, math.inf),
    "softening": (TURNING, {"law": "exponential", "peak": MU, "residual": 0.7 * MU, "length": 20.0}, math.inf),
    "hyperbolic": (TURNING, {"law": "hyperbolic", "peak": MU, "residual": 0.7 * MU, "length": 20.0}, math.inf),
    "kinks": (TURNING, {"law": "tabulated", "slip": [0.0, 10.0, 30.0], "coefficient": [0.3, 0.2, 0.15]}, math.inf),
    "rates": (TURNING, {"law": "rate_tabulated", "speed": [1e-3, 0.1, 1.0], "coefficient": [0.2, 0.18, 0.15]}, 60.0),
    "water": (TURNING | {"pore_pressure": {"pressure": Series(np.array([0.0, 30, 60]), np.array([0.0, 2e6, 1e5]))}},
              MU, 200.0),
    "record": (TURNING | {"shaking": SHAKEN}, MU, math.inf),
    "two ways": (TURNING | {"shaking": SHAKEN | {"two_way": True}}, MU + 0.2, 15.0),
    "pulse": (TURNING | {"shaking": {"horizontal": PULSE}}, MU, math.inf),
    "pulse and record": (TURNING | {"shaking": SHAKEN | {"horizontal": PULSE}}, MU, math.inf),
    "heat": (TURNING | {"thermal_pressurisation": {"pressurisation": 1e3, "heat_capacity": 2.7e6, "thickness": 0.1}},
             MU, 200.0),
}  # fmt: skip


def problem(name: str) -> Problem:
    called, friction, end = SCENES[name]
    until = None if math.isinf(end) else end
    return posed(Scene(load("vaiont").arc, friction, called, PUSHED, until), 1e-11)
