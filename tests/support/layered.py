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
    """Return the slope of `MOTIONS` with the soils of one of its profiles."""
    rows, length = PROFILES[name]
    soils = []
    for k, (unit_weight, cohesion, peak, residual) in enumerate(rows):
        law = {"law": "exponential", "peak": tangent(peak), "residual": tangent(residual), "length": length}
        soils.append(Soil(1e3 * unit_weight, 1e3 * cohesion, law if length else tangent(peak), name=f"soil {k}"))
    level = LEVEL if "water" in name else None
    layers = list(zip(soils, TOPS, strict=True))
    return LayeredSection(GROUND, (30, 45), 48.0, level=level, layers=layers, strength=strength, **given)


LAWS: list[Any] = [
    {"law": "linear", "peak": 0.57, "residual": 0.45, "length": 0.3},
    {"law": "tabulated", "slip": [0.0, 0.5, 2.0, 6.0], "coefficient": [0.36, 0.32, 0.23, 0.21]},
    {"law": "rate_weakening", "peak": 0.16, "residual": 0.1, "velocity": 2.0},
    {"law": "hyperbolic", "peak": 0.44, "residual": 0.36, "length": 1.0},
]
BELOW_GROUND = [(-60, 12), (0, 9), (40, -1.4), (120, -1.8)]


def sloping(soils: Any, tops: Any = TOPS, **given: Any) -> LayeredSection:
    """Return the slope of `profile` with other soils."""
    return LayeredSection(GROUND, (30, 45), 48.0, layers=list(zip(soils, tops, strict=True)), **given)


def of_each_soil(**given: Any) -> LayeredSection:
    """Return a friction law of its own for each soil."""
    rows: Any = zip((18e3, 19e3, 17e3, 21e3), (3e3, 2e3, 1e3, 0.0), LAWS, "abcd", strict=True)
    return sloping([Soil(w, c, law, name=name) for w, c, law, name in rows], strength="mass", **given)


RICH = [
    Soil(18e3, 3e3, {"law": "exponential", "peak": 0.57, "residual": 0.45, "length": 0.8}, name="a"),
    Soil(19e3, 2e3, {"law": "exponential", "peak": 0.36, "residual": 0.26, "length": 0.8}, pore_ratio=0.1, name="b"),
    Soil(17e3, 1e3, {"law": "exponential", "peak": 0.16, "residual": 0.1, "length": 0.8}, 18.5e3, 300.0, 1.5, name="c"),
    Soil(21e3, 0.0, 0.42, name="d"),
]  # fmt: skip
GROWING = Soil(21e3, 1e3, 0.36, cohesion_gradient=200.0, name="d")
CRACKED = LayeredSection(
    [(-60, 22), (-2, 20), (40, 0), (120, 0)], (30, 45), 48.0, crack=4.0, surcharge=[(-3.0, 4.0, 2e4, 3e4)],
    layers=list(zip([*RICH[:2], GROWING], (None, 12.0, 3.0), strict=True)),
)  # fmt: skip
