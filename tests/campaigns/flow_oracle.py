"""Flow programs beside the plain equation of motion: ``python -m tests.campaigns.flow_oracle [PROGRAMS]``.

All 134,400 programs (15 minutes), or so many of them, drawn at random, each at a random point. One side runs the
program that a scene's fragments are joined to, as the integrator in NumPy does. The other is typed from the equation
itself, in absolute terms, and solved by Picard's iteration in series of balls: it knows neither increments nor
recurrences nor fragments.
"""

import math
import random
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import chain, combinations
from typing import Any

import numpy as np
from flint import arb, arb_series, ctx

from generated.series import scalar_ops, series_ops
from slipcircle.base.kinds import Floats
from tests.support.lanes import Program, Recipe, build_program

ORDER = 7
Point = dict[str, Any]  # numbers and short series of a scene and of a moment of its motion


# --- the program -------------------------------------------------------------------------------------------------


def cells_at(program: Program, given: Mapping[str, float]) -> Floats:
    """Return all cells where a phase begins."""
    cells = np.zeros((len(program.cells), 1))
    known = {**program.constants, **given}
    for name in known.keys() & program.places.keys():
        cells[program.places[name]] = known[name]
    scalar_ops(program.scalar, cells)
    return cells


def series_at(program: Program, given: Mapping[str, float], states: Mapping[str, float], p: Point) -> Floats:
    """Return the series of all registers from a moment of a phase, (registers, orders)."""
    start, at = cells_at(program, given)[:, 0], program.roles
    # The limit friction is an input: what the balance at the start says, so that the drive is the same number.
    limit = (start[at["cell_driving"]] - start[at["cell_resisting"]]) / start[at["cell_normal0"]]
    cells = cells_at(program, {**given, "LIMIT": limit})
    registers = np.zeros((len(program.registers), ORDER + 1, 1))
    for cell, register, _ in program.states:
        registers[register, 0] = states[program.cells[cell]]
    for table in program.tables:
        if table.kind == "time":
            terms = p[f"{table.name}.series"]
            registers[table.register, : len(terms), 0] = terms
    for n in range(ORDER):
        series_ops(program.series, registers, cells, n)
        for _, register, rate in program.states:
            registers[register, n + 1] = registers[rate, n] / (n + 1)
    return registers[:, :, 0]


# --- the equation ------------------------------------------------------------------------------------------------


def motion(p: Mapping[str, Any], effects: Sequence[str], mu: Callable[[Any, Any], Any], order: int) -> dict[str, Any]:
    """Series of rotation, speed and excess pressure along a phase: the equation of motion as it stands."""
    start = {x: arb_series([p[f"now.{x}"]], prec=order + 1) for x in ("x", "omega", "excess")}
    x, w, excess = start.values()
    sign, zero = p["DIRECTION"], arb_series([arb(0)], prec=order + 1)
    found: dict[str, Any] = {}
    for _ in range(order + 1):
        psi = p["psi"] - (p["ROTATION"] + sign * x if "rotation" in effects else zero)
        k_h, k_v = (p[k] if "shaking" in effects else zero for k in ("k_h", "k_v"))
        j_theta = p["C_theta"] * ((1 - k_v) * psi.sin() + k_h * psi.cos())
        j_r = p["C_r"] * ((1 - k_v) * psi.cos() - k_h * psi.sin())
        sigma = j_r / p["lambda"]
        if "centripetal" in effects:
            sigma = sigma + p["I_p"] / p["lambda"] * w * w
        u = zero
        if "pore_pressure" in effects:
            u = p["pore_ratio"] * p["C_r"] * psi.cos() / p["lambda"] + p["pore_pressure"]
        if "thermal_pressurisation" in effects:
            u = u + excess
        friction = mu(x, w) * (sigma - u) * (0 if p["LIFTED"] == 1 else 1)
        net = sign * j_theta - p["lambda"] * friction
        if "cohesion" in effects:
            net = net - p["lambda"] * p["cohesion"]
        net = net / p["Theta"]
        if "drag" in effects:
            net = net - p["drag"] * w * w
        if "viscosity" in effects:
            net = net - p["viscosity"] * w
        heating = p["kappa"] * friction * w
        found = {"x": x, "omega": w, "excess": excess, "net": net, "normal": (sigma - u) * p["lambda"] / p["Theta"],
                 "mu": mu(x, w), "upright": p["C_r"] * psi.cos() / p["Theta"]}  # fmt: skip
        x, w, excess = (start[k] + rate.integral() for k, rate in (("x", w), ("omega", net), ("excess", heating)))
    return found


def coefficient(law: str, p: Mapping[str, Any], x: Any, w: Any) -> Any:
    """Return a friction law at a rotation since the phase began and a speed."""

    def get(name: str) -> Any:
        return p[f"{law}.{name}"]

    slip = p["SLIP"] + x
    match law:
        case "constant":
            return get("coefficient") + 0 * x
        case "exponential":
            return get("residual") + (get("peak") - get("residual")) * (-slip / get("length")).exp()
        case "hyperbolic":
            return get("residual") + (get("peak") - get("residual")) / (1 + slip / get("length"))
        case "rate_weakening":
            return get("residual") + (get("peak") - get("residual")) / (1 + w / get("velocity"))
        case "prescribed":
            return p["prescribed"] + 0 * x
        case "rate_tabulated":
            argument = (w / p["omega"]).log() if p["rate_tabulated.PIECE"] > 0 else 0 * x
        case _:
            argument = x
    return get("VALUE") + sum((get(f"Q{i}") * argument**i for i in range(1, 8) if f"{law}.Q{i}" in p), 0 * x)


# --- what is compared --------------------------------------------------------------------------------------------

EFFECTS = ("rotation", "centripetal", "pore_pressure", "cohesion", "drag", "viscosity", "shaking",
           "thermal_pressurisation")  # fmt: skip
SINGLE = (("constant",), ("exponential",), ("linear",), ("hyperbolic",), ("tabulated",), ("callable",),
          ("rate_weakening",), ("rate_tabulated",), ("prescribed",))  # fmt: skip
LAWS = (*SINGLE, *((slip[0], rate) for slip in SINGLE[:6] for rate in ("rate_weakening", "rate_tabulated")))
SERIES = {"pore_pressure": ("pore_ratio", "pore_pressure"), "shaking": ("k_h", "k_v")}
Case = tuple[tuple[str, ...], tuple[str, ...], tuple[str, ...], tuple[str, ...]]


def subsets(names: Sequence[str]) -> Iterator[tuple[str, ...]]:
    return chain.from_iterable(combinations(names, i) for i in range(len(names) + 1))


def cases() -> Iterator[Case]:
    """Effects, laws, what is a function of time, and what is not given, in every combination."""
    for effects in subsets(EFFECTS):
        symbols = [x for e in effects for x in SERIES.get(e, ())]
        for laws in LAWS:
            for moving in subsets(symbols):
                for absent in subsets([x for x in symbols if x not in moving]):
                    yield effects, laws, moving, absent


def point(rng: random.Random, case: Case) -> Point:
    """Random numbers for all that a scene may have, and for a moment of its motion."""
    _, laws, moving, absent = case
    positive = ("C_theta", "C_r", "lambda", "I_p", "Theta", "cohesion", "drag", "viscosity", "kappa", "omega")
    p: Point = {x: rng.uniform(0.1, 1.0) for x in positive}
    p |= {"psi": rng.uniform(-1.2, 1.2), "DIRECTION": rng.choice((1.0, -1.0)), "LIFTED": float(rng.random() < 0.15)}
    later = float(rng.random() < 0.7)  # otherwise the start of the motion, where the limit friction is given
    p |= {"TIME": later * rng.uniform(1, 2), "ROTATION": later * rng.uniform(-0.5, 0.5), "SLIP": later * rng.random()}
    p |= {"excess": rng.uniform(0, 0.2), "now.x": rng.uniform(0, 0.3)}
    p |= {"now.omega": rng.uniform(0.1, 1.0), "now.excess": rng.uniform(0, 0.3)}
    for symbol in ("k_h", "k_v", "pore_ratio", "pore_pressure"):
        # Where the phase began; since then it has changed by the first term.
        value = p[f"{symbol}.VALUE"] = 0.0 if symbol in absent else rng.uniform(0.0, 0.3)
        p[f"{symbol}.series"] = [rng.uniform(-0.3, 0.3) for _ in range(3)] if symbol in moving else [0.0]
        p[symbol] = value
    for law in laws:
        names = ("coefficient", "peak", "residual", "length", "velocity", "VALUE")
        p |= {f"{law}.{x}": rng.uniform(0.1, 1.0) for x in names}
        degree = {"linear": 1, "callable": 7, "tabulated": 3, "rate_tabulated": 3}.get(law, 0)
        inside = p[f"{law}.PIECE"] = float(law != "rate_tabulated" or rng.random() < 0.7)
        p |= {f"{law}.Q{i}": inside * rng.uniform(-0.3, 0.3) for i in range(1, degree + 1)}
    p["prescribed.series"] = [rng.uniform(-0.1, 0.1), rng.uniform(-0.1, 0.1)]
    return p


def absolute(p: Point) -> dict[str, Any]:
    """Return the numbers of a point in balls; functions of time as series from the moment."""
    balls: dict[str, Any] = {name: arb(value) for name, value in p.items() if isinstance(value, float)}
    for name, terms in p.items():
        symbol = name.removesuffix(".series")
        if symbol != name:
            since = [arb(x) for x in terms]
            balls[symbol] = balls.get(f"{symbol}.VALUE", arb(0)) + arb_series(since, prec=ORDER + 1)
    return balls


def numbers(p: Point) -> tuple[dict[str, float], dict[str, float]]:
    """Return the cells of a point where its phase begins, and its states at the moment."""
    theta, sine, cosine = p["Theta"], np.sin(p["psi"]), np.cos(p["psi"])
    cells = {name: value for name, value in p.items() if isinstance(value, float)} | {
        "driving_moment": p["C_theta"] * sine / theta, "driving_moment_slope": p["C_theta"] * cosine / theta,
        "normal_load": p["C_r"] * cosine / theta, "normal_load_slope": -p["C_r"] * sine / theta,
        "polar_moment": p["I_p"] / theta, "resistance_factor": p["lambda"] / theta,
    }  # fmt: skip
    return cells, {name.removeprefix("now."): value for name, value in p.items() if name.startswith("now.")}


def at_a_point(case: Case, seed: int, asked: tuple[str, ...]) -> tuple[Program, Floats, Point]:
    """Return the program of a case, the series of its registers at a random moment, and the numbers of that moment."""
    program, p = build_program(Recipe(*case), asked), point(random.Random(f"{case} {seed}"), case)
    return program, series_at(program, *numbers(p), p), p


def difference(case: Case, seed: int) -> float:
    """Return the largest error of a coefficient, in registers of both sides, relative to the largest coefficient."""
    effects, laws, *_ = case
    program, registers, p = at_a_point(case, seed, ("mu",))
    ctx.prec, ctx.cap = 128, ORDER + 1
    balls = absolute(p)

    def mu(x: Any, w: Any) -> Any:
        return math.prod(coefficient(law, balls, x, w) for law in laws)

    plain, differences = motion(balls, effects, mu, ORDER), [0.0]
    for name in ("x", "omega", "net", "normal", "mu", "upright", "excess"):
        register = program.roles.get(name, program.registers.index(name) if name in program.registers else -1)
        if register >= 0:
            terms = [float(x) for x in plain[name].coeffs()[:ORDER]]
            exact = np.array(terms + [0.0] * (ORDER - len(terms)))
            differences.append(np.max(np.abs(registers[register, :ORDER] - exact)) / np.max(np.abs(exact)))
    return float(np.max(differences))  # what is no number stays


BOUND = 1e-12


def main() -> int:
    """Compare all programs, or as many as requested, with the equation of motion; return 1 where one differs."""
    chosen = list(cases())
    if len(sys.argv) > 1:
        chosen = random.Random(1).sample(chosen, int(sys.argv[1]))
    largest = max(difference(case, 0) for case in chosen)
    print(f"{len(chosen)} programs agree with the plain equation of motion to {largest:.1e}")
    return int(not largest < BOUND)


if __name__ == "__main__":
    sys.exit(main())
