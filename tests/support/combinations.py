"""Scenes of every combination of effects with every kind of friction law, parameters drawn at random."""

import math
from dataclasses import replace
from itertools import chain, combinations
from typing import Any

import numpy as np

from generated.effects import EFFECTS
from slipcircle import Scene
from tests.support import golden, oracle, vaiont

ARCS: dict[str, tuple[float, float, float, float]] = {  # radius, angles in degrees, gravity
    "vaiont": (vaiont.RADIUS, *vaiont.ENDS_DEG, 9.81),
    "leans back": (vaiont.RADIUS, 263.1, 324.8, 9.81),
    "steep, wide": (80.0, 194.3, 306.1, 3.7),
    "thin": (5000.0, 240.64, 240.646, 9.81),
    "half disc": (12.0, 190.0, 370.0, 9.81),
    "nearly level": (40.0, 229.0, 309.0, 9.81),
}
ALL = list(chain.from_iterable(combinations(EFFECTS, n) for n in range(len(EFFECTS) + 1)))
SLIP_LAWS = ("constant", "exponential", "linear", "hyperbolic", "tabulated", "callable")
STEADY = [c for c in ALL if {"viscosity", "shaking", "thermal_pressurisation"}.isdisjoint(c)]  # of position and speed
LAWS = (*SLIP_LAWS, "rate", "rate table", "prescribed", "product")


def arc(name: str) -> dict[str, float]:
    radius, first, second, gravity = ARCS[name]
    return {"radius": radius, "theta_1": math.radians(first), "theta_2": math.radians(second),
            "unit_weight": 15e3 + 2e3 * list(ARCS).index(name), "gravity": gravity}  # fmt: skip


def friction(law: str, low: float, high: float, length: float, speed: float, pace: float, of: Any = ()) -> Any:
    """Return the law of this name, or a product of two, falling from high to low over a length, a speed or a time."""
    falls = {"law": "exponential" if law == "callable" else law, "peak": high, "residual": low}
    match law:
        case "constant":
            return low
        case "tabulated":
            return {"law": law, "slip": [0.0, 0.3 * length, length, 2.5 * length],
                    "coefficient": [high, low + 0.8 * (high - low), low + 0.3 * (high - low), low]}  # fmt: skip
        case "rate":
            return falls | {"law": "rate_weakening", "velocity": 0.1 * speed}
        case "rate table":
            return {"law": "rate_tabulated", "speed": [0.001 * speed, 0.02 * speed, 0.3 * speed],
                    "coefficient": [high, 0.7 * high + 0.3 * low, low]}  # fmt: skip
        case "prescribed":
            return {"law": law, "time": [0.0, 0.7 * pace, 2 * pace], "coefficient": [high, low, (low + high) / 2]}
        case "product":
            slip, rate = friction(of[0], low, high, length, speed, pace), friction(of[1], 0.7, 1.0, length, speed, pace)
            return (slip if isinstance(slip, dict) else {"law": of[0], "coefficient": slip}) | {"rate": rate}
    return falls | {"length": length}


def drawn(effects: tuple[str, ...], law: str, seed: int, mass: tuple[Any, Any] | None = None) -> golden.Data:
    """Return a scene with a start and parameters drawn so that every effect matters.

    ``mass`` is the data of an arc or a section with its moments; by default an arc is drawn.
    """
    rng = np.random.default_rng([seed, LAWS.index(law), ALL.index(effects)])
    given, moments = mass or (arc(str(rng.choice(list(ARCS)))), None)
    m = {k: float(v) for k, v in (moments or oracle.moments(given)).items()}
    load = m["press"] * math.cos(m.get("lean", m["dip"]))  # normal
    limit = m["fall"] * abs(math.sin(m["dip"])) / load
    stress = load / m["level"] * m["reference_stress"]
    speed, pace = math.sqrt(given["radius"] * given["gravity"]), math.sqrt(given["radius"] / given["gravity"])
    layer = 2 * m["half_angle"] / m["inertia"]
    called: dict[str, Any] = {e: {} for e in effects}
    carried = float(rng.choice([0.2, 0.6, 1.1]))  # of what presses at rest; above 1 water carries the mass
    if "pore_pressure" in called:
        ratio = float(rng.choice([0.0, 0.15]))
        called["pore_pressure"] = {"ratio": ratio, "pressure": (carried - ratio) * stress}
        if rng.random() < 0.4:
            called["pore_pressure"] = {"time": [0.0, pace, 3 * pace], "ratio": [0.0, ratio, 0.1],
                                       "pressure": [0.0, (carried - ratio) * stress, 0.1 * stress]}  # fmt: skip
    if "cohesion" in called:
        called["cohesion"] = {"cohesion": float(rng.uniform(0.05, 0.3)) * limit * stress}
    if "drag" in called:
        called["drag"] = {"xi": layer * given["gravity"] / float(rng.uniform(0.1, 3.0))}
    if "viscosity" in called:
        size = float(10 ** rng.uniform(-2, -0.3)) * given["unit_weight"] / given["gravity"] * speed
        called["viscosity"] = {"viscosity": size * 0.5 / layer, "thickness": 0.5}
    if "shaking" in called:
        called["shaking"] = {"pulse": str(rng.choice(golden.KINDS)), "amplitude": limit * float(rng.uniform(0.2, 1.5)),
                             "vertical_amplitude": float(rng.choice([0.0, 0.3, -0.4])), "duration": 2.2 * pace,
                             "start": float(rng.choice([0.0, 0.4])) * pace}  # fmt: skip
        called["shaking"] |= {"two_way": True} if rng.random() < 0.3 else {}
    if "thermal_pressurisation" in called:
        kappa = float(10 ** rng.uniform(-1.5, 0.5))
        called["thermal_pressurisation"] = {"pressurisation": kappa * 2.7e5 / given["radius"], "heat_capacity": 2.7e6,
                                            "thickness": 0.1}  # fmt: skip
    low, high = limit * float(rng.uniform(0.15, 0.5)), limit * float(rng.uniform(0.6, 0.9))
    length = given["radius"] * float(10 ** rng.uniform(-2.5, -0.5))
    of = [str(rng.choice(laws)) for laws in (SLIP_LAWS[:-1], LAWS[6:8])] if law == "product" else ()
    return {"arc": given, "friction": friction(law, low, high, length, speed, pace, of), "effects": called,
            "initial_velocity": float(rng.choice([0.0, 0.4, -0.4])) * speed,
            "end_time": float(rng.uniform(2.0, 6.0)) * pace}  # fmt: skip


def built(given: golden.Data, law: str = "") -> Scene:
    """Return the scene; its law as a Python function where that is asked for."""
    scene = golden.built(law, given)
    if law != "callable":
        return scene
    peak, residual, length = (given["friction"][k] for k in ("peak", "residual", "length"))
    return replace(scene, friction=lambda slip: residual + (peak - residual) * np.exp(-slip / length))


def softening(law: str, peak: float, residual: float, length: float) -> dict[str, Any]:
    return {"law": law, "peak": peak, "residual": residual, "length": length}
