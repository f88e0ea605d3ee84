"""A slope of four layers, with soils of three kinds, of which tests know the motions."""

from typing import Any

import numpy as np

from slipcircle.layers import LayeredSection, Soil

TURNING = ["rotation", "centripetal"]
GROUND = [(-60, 20), (0, 20), (40, 0), (120, 0)]
LEVEL = [(-60, 10), (0, 9), (40, 0), (120, 0)]
TOPS = (None, 18.5, 2.0, -1.0)

# Unit weight in kN/m^3, cohesion in kPa, angles of friction at first and after much slip; length in m.
PROFILES: dict[str, tuple[Any, float]] = {
    "one soil in four layers, under water": ([(19, 4, 15, 15)] * 4, 0.0),
    "constant friction": ([(18, 0, 30, 30), (19, 0, 18, 18), (17, 0, 8, 8), (21, 0, 22, 22)], 0.0),
    "softening": ([(18, 3, 30, 24), (19, 2, 20, 15), (17, 1, 9, 6), (21, 0, 23, 20)], 0.8),
}


def tangent(degrees: Any) -> Any:
    return np.tan(np.deg2rad(degrees))


def profile(name: str, strength: str = "base", **given: Any) -> LayeredSection:
    """The slope of `MOTIONS` with the soils of one of its profiles."""
    rows, length = PROFILES[name]
    soils = []
    for k, (unit_weight, cohesion, peak, residual) in enumerate(rows):
        law = {"law": "exponential", "peak": tangent(peak), "residual": tangent(residual), "length": length}
        soils.append(Soil(1e3 * unit_weight, 1e3 * cohesion, law if length else tangent(peak), name=f"soil {k}"))
    level = LEVEL if "water" in name else None
    layers = list(zip(soils, TOPS, strict=True))
    return LayeredSection(GROUND, (30, 45), 48.0, level=level, layers=layers, strength=strength, **given)
