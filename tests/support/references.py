"""Random scenes and their motion to 20 and 30 digits: 400 are kept, ``tests.campaigns.references`` draws more.

Scenes are plain data, 300 of position and speed and 100 that depend on time, on rates or on heat; they are solved by
`taylor`. Each was solved twice, with series of different length at different precision, and both had to agree;
`test_accuracy` solves six of them again; ``python -m tests.support.references`` solves all, and stores the answers.
"""

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from flint import arb, ctx

from tests.support import golden, taylor
from tests.support.combinations import friction as friction_law
from tests.support.taylor import Unfit

FILE = Path(__file__).with_name("references.json")
STEADY = {"frozen": 60, "constant": 100, "exponential": 50, "linear": 28, "hyperbolic": 28, "tabulated": 34}
TIMED = {"viscous": 10, "pulse": 14, "series": 14, "rate": 12, "rate table": 8, "prescribed": 8, "product": 8,
         "heated": 10, "water": 6, "all": 10}  # fmt: skip
NEAR = {"frozen": 4, "constant": 10, "exponential": 4, "tabulated": 2}  # the first of each, next to the limit
LIFTED = 6  # the last with constant friction: pushed up-slope, so that water carries them for a while
SHARES = (0.137, 0.391, 0.618, 0.874)  # of the duration, at which scenes of time are compared


def digits(group: str) -> int:
    """Return the number of known digits of a group's motions."""
    return 30 if group in STEADY else 20


def agree(one: Any, two: Any, digits: int) -> bool:
    """Whether two answers are the same to within their last digits; places and speeds beside the greatest."""
    with ctx.workprec(256):

        def near(a: str, b: str, size: str) -> bool:
            return bool(abs(arb(a) - arb(b)) <= abs(arb(size)) * arb(10) ** (2 - digits))

        sizes = {"displacement": one["run_out"], "velocity": one["peak_velocity"]}
        return one.keys() == two.keys() and all(
            near(one[k], two[k], one[k]) if isinstance(one[k], str)
            else all(near(a, b, sizes[k]) for a, b in zip(one[k], two[k], strict=True)) if k in sizes
            else one[k] == two[k]
            for k in one if k != "peak_time"
        )  # fmt: skip


def first_fit(draw: Callable[[], dict[str, Any]], digits: int, *problem: Any, **limits: Any) -> dict[str, Any]:
    """Return the first random scene that moves and comes to an end, and its motion, which longer series confirm."""
    for _ in range(1000):
        try:
            scene = draw()
            found, longer = (taylor.solve(scene, SHARES, d, *problem, **limits) for d in (digits, digits + 4))
        except Unfit:
            continue
        if found["moves"] and agree(found, longer, digits):
            return {"scene": scene, "reference": found}
    raise RuntimeError("no scene fits")


# --- random scenes ---------------------------------------------------------------------------------------------------


def called(group: str, rng: np.random.Generator, arc: dict[str, Any], limit: float, depth: float) -> dict[str, Any]:
    """Return a random scene of a group, of a mass with a limit friction and a depth of its arc below the chord."""
    stress, pace = arc["unit_weight"] * depth, math.sqrt(arc["radius"] / arc["gravity"])
    speed = math.sqrt(arc["radius"] * arc["gravity"])
    low, high = limit * rng.uniform(0.3, 0.9), limit * rng.uniform(1.02, 1.6)
    effects: dict[str, Any] = {"rotation": {}}
    friction: Any = low
    if rng.random() < 0.6:
        effects["centripetal"] = {}
    if rng.random() < 0.25:
        effects["drag"] = {"xi": float(10 ** rng.uniform(2, 3.5))}
    if rng.random() < 0.2:
        effects["cohesion"] = {"cohesion": float(stress * rng.uniform(0.002, 0.02))}
    if rng.random() < 0.2:
        effects["pore_pressure"] = {"ratio": float(rng.uniform(0.02, 0.2))}

    def viscosity() -> dict[str, float]:
        e = 10 ** rng.uniform(-2, -0.3)
        return {"viscosity": float(e * arc["unit_weight"] / 9.81 * 0.02 * speed), "thickness": 0.5}

    def shaking(kind: str) -> dict[str, Any]:
        top, length = float(limit * rng.uniform(0.6, 2.0)), float(pace * rng.uniform(0.3, 4.0))
        if kind == "series":
            count = int(rng.integers(4, 25))
            time = np.concatenate([[0.0], np.cumsum(rng.uniform(0.3, 1.0, count))])
            given = {"time": (time / time[-1] * length).tolist(),
                     "horizontal": [0.0, *(top * rng.normal(size=count - 1)).tolist(), 0.0]}  # fmt: skip
            if rng.random() < 0.4:
                given["vertical"] = [0.0, *(0.3 * rng.normal(size=count - 1)).tolist(), 0.0]
        else:
            name = str(rng.choice(["rectangular", "half-sine", "triangular", "sine"]))
            given = {"pulse": name, "amplitude": top, "duration": length, "start": float(pace * rng.uniform(0, 1))}
            if name == "sine":
                given["cycles"] = float(rng.choice([1.0, 2.5, 6.0]))
            if rng.random() < 0.4:
                given["vertical_amplitude"] = float(rng.uniform(-0.5, 0.9))
        return given | ({"two_way": True} if rng.random() < 0.3 else {})

    def law(name: str, peak: float, residual: float) -> Any:
        """Return a friction law of a random length and speed; without a name one of slip."""
        name = name or str(rng.choice(["exponential", "linear", "hyperbolic"]))
        share = float(10 ** rng.uniform(-3, -1))
        return friction_law(name, residual, peak, share * arc["radius"], 30 * share * speed, pace)

    def heat() -> dict[str, float]:
        kappa = 10 ** rng.uniform(-1.0, 0.7)
        return {"pressurisation": float(kappa * 2.7e6 * 0.1 / arc["radius"]), "heat_capacity": 2.7e6, "thickness": 0.1}

    start = 0.0
    match group:
        case "viscous":
            effects["viscosity"] = viscosity()
            start = float(rng.choice([0.0, 0.1 * speed]))
        case "pulse" | "series":
            effects["shaking"] = shaking(group)
            friction = float(rng.choice([low, high, high]))
            if rng.random() < 0.3:
                friction = law("", high, low)
        case "rate":
            start = float(rng.choice([0.0, 0.2 * speed]))
            peak = high if start else limit * float(rng.uniform(0.9, 0.99))
            friction = law(group, peak, limit * float(rng.uniform(0.0, 0.7)))
        case "rate table":
            friction = law(group, limit * float(rng.uniform(0.8, 0.95)), low * 0.6)
        case "softening":
            friction = law("", limit * float(rng.uniform(0.8, 0.99)), low * 0.8)
        case "prescribed":
            friction = law(group, high, low)
        case "product":
            friction = law("", limit * 0.95, limit * 0.7) | {"rate": law("rate", 1.0, float(rng.uniform(0.2, 0.9)))}
        case "heated":
            effects["thermal_pressurisation"] = heat()
            friction = low if rng.random() < 0.5 else law("", limit * 0.95, low)
        case "water":
            time = np.cumsum(pace * rng.uniform(0.3, 1.5, 3))
            top = float(rng.uniform(0.3, 0.9)) * stress
            effects["pore_pressure"] = {"time": [0.0, *time.tolist()], "pressure": [0.0, top, 0.5 * top, 0.0]}
            friction = float(rng.choice([low, high]))
        case "all":
            effects |= {"viscosity": viscosity(), "shaking": shaking(str(rng.choice(["pulse", "series"]))),
                        "thermal_pressurisation": heat()}  # fmt: skip
            friction = law("", high, low) | {"rate": law("rate", 1.0, 0.5)}
    end = None
    if rng.random() < 0.15 and group != "all":
        effects.pop("rotation", None)
    if "rotation" not in effects or rng.random() < 0.15:
        end = float(pace * rng.uniform(1.0, 3.0))
    return {"arc": arc, "friction": friction, "effects": effects, "initial_velocity": start, "end_time": end}


def main() -> None:
    golden.write(FILE, (row | {"reference": taylor.solve(row["scene"], row["shares"], digits(row["group"]))}
                        for row in golden.read(FILE)))  # fmt: skip


if __name__ == "__main__":
    main()
