"""Flow programs beside the plain equation of motion: ``python -m tests.campaigns.flow_oracle [PROGRAMS]``.

At random points, in balls of 100 digits; all 134,400 programs (an hour), or so many of them, drawn at random. One side
runs the program that a scene's fragments are joined to by a generic interpreter of the table of operations. The other
is typed from the equation itself, in absolute terms, and solved by Picard's iteration in series arithmetic: it knows
neither increments nor recurrences nor fragments.
"""

import random
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import chain, combinations
from typing import Any

import sympy as sp
from flint import arb, arb_series, ctx

from derive.flow.operations import OPERATIONS, n
from slipcircle.core.flow.build import build_program
from slipcircle.core.flow.program import Program

ORDER = 7
PRECISION = 360  # bits
FUNCTIONS: dict[str, Callable[[arb], arb]] = {
    "sin": arb.sin, "cos": arb.cos, "tan": arb.tan, "exp": arb.exp, "log": arb.log, "sqrt": arb.sqrt,
    "expm1": arb.expm1, "log1p": arb.log1p, "abs": abs,
}  # fmt: skip
PROLOGUE: dict[str, Callable[..., arb]] = {
    "add": lambda a, b: a + b, "sub": lambda a, b: a - b, "mul": lambda a, b: a * b, "div": lambda a, b: a / b,
    "neg": lambda a: -a, "min": arb.min, "max": arb.max, "less": lambda a, b: arb(int(a < b)),
    "select": lambda a, b, e: b if a > 0 else e, **FUNCTIONS,
}  # fmt: skip


# --- the program, in balls ---------------------------------------------------------------------------------------


def number(e: sp.Expr, known: Mapping[sp.Expr, Any]) -> Any:
    """The value of an expression of the table of operations."""
    if e in known:
        return known[e]
    if isinstance(e, sp.Indexed):
        return known[e.base][int(e.indices[0])]
    if isinstance(e, sp.Sum):
        ((k, first, last),) = e.limits
        return sum((number(e.function.subs(k, i), known) for i in range(int(first), int(last) + 1)), arb(0))
    if isinstance(e, sp.Rational):
        return arb(int(e.p)) / int(e.q)
    if isinstance(e, sp.Pow):
        return number(e.base, known) ** int(e.exp)
    parts = [number(x, known) for x in e.args]
    if isinstance(e, sp.Add):
        return sum(parts, arb(0))
    if isinstance(e, sp.Mul):
        found = arb(1)
        for x in parts:
            found = found * x
        return found
    return FUNCTIONS[type(e).__name__.lower()](*parts)


def prologue(program: Program, cells: dict[str, arb]) -> list[arb]:
    """All cells where a phase begins."""
    c = [cells.get(name, arb(0)) for name in program.cells]
    for name, value in program.constants.items():
        c[program.cells.index(name)] = arb(value)
    for op, d, *arguments in program.scalar:
        c[d] = PROLOGUE[op](*(c[i] for i in arguments))
    return c


def run(program: Program, c: Sequence[arb], tables: Mapping[int, Sequence[arb]], order: int) -> list[list[arb]]:
    """All registers to an order; ``tables`` are the series of the tables of time, by register."""
    r: list[list[arb]] = [[] for _ in program.registers]
    for register, series in tables.items():
        r[register] = [*series, *[arb(0)] * order][: order + 1]
    for cell, register, _ in program.states:
        r[register] = [c[cell]]
    for i in range(order + 1):
        for name, *names in program.series:
            if name == "lin":
                d, constant, terms = names
                total = sum((c[cell] * r[register][i] for cell, register in terms), arb(0))
                r[d].append(total + c[constant] if i == 0 and constant >= 0 else total)
            elif name != "ramp":
                o = OPERATIONS[name]
                series = names[: len(o.results) + len(o.arguments)]
                known: dict[sp.Expr, Any] = {x: r[at] for x, at in zip((*o.results, *o.arguments), series, strict=True)}
                known |= {x: c[at] for x, at in zip(o.numbers, names[len(series) :], strict=True)}
                for at, start, step in zip(series, o.start, o.step, strict=False):
                    r[at].append(number(start if i == 0 else step.subs(n, i), known))
        for _, register, rate in program.states:
            r[register].append(r[rate][i] / (i + 1))
    return r


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
    """A friction law at a rotation since the phase began and a speed."""

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


def point(rng: random.Random, case: Case) -> dict[str, Any]:
    """Random numbers for all that a scene may have, and for a moment of its motion."""
    _, laws, moving, absent = case

    def some(low: float, high: float) -> arb:
        return arb(low) + (arb(high) - arb(low)) * rng.randrange(1, 10**40) / 10**40

    p: dict[str, Any] = {x: some(0.1, 1.0) for x in ("C_theta", "C_r", "lambda", "I_p", "Theta", "cohesion", "drag",
                                                     "viscosity", "kappa")}  # fmt: skip
    p |= {"psi": some(-1.2, 1.2), "DIRECTION": arb(rng.choice((1, -1))), "LIFTED": arb(int(rng.random() < 0.15))}
    first = rng.random() < 0.3  # the start of the motion, where the limit friction is given
    p |= {"TIME": arb(0) if first else some(1, 2), "ROTATION": arb(0) if first else some(-0.5, 0.5)}
    p |= {"SLIP": arb(0) if first else some(0, 1), "omega": some(0.1, 1.0), "excess": some(0, 0.2)}
    p |= {"now.x": some(0, 0.3), "now.omega": some(0.1, 1.0), "now.excess": some(0, 0.3)}
    for symbol in ("k_h", "k_v", "pore_ratio", "pore_pressure"):
        series = [some(-0.3, 0.3) for _ in range(3 if symbol in moving else 1)]
        p[f"{symbol}.VALUE"] = some(0.0, 0.3)  # where the phase began; since then it has changed by the first term
        p[symbol] = arb_series(
            [p[f"{symbol}.VALUE"] + (series[0] if symbol in moving else 0), *series[1:]], prec=ORDER + 1
        )
        p[f"{symbol}.series"] = series
        if symbol in absent:
            p[symbol] = arb_series([arb(0)], prec=ORDER + 1)
    for law in laws:
        names = ("coefficient", "peak", "residual", "length", "velocity", "VALUE", "PIECE")
        p |= {f"{law}.{x}": some(0.1, 1.0) for x in names}
        degree = {"linear": 1, "callable": 7, "tabulated": 3, "rate_tabulated": 3}.get(law, 0)
        inside = law != "rate_tabulated" or rng.random() < 0.7
        p[f"{law}.PIECE"] = arb(int(inside))
        p |= {f"{law}.Q{i}": some(-0.3, 0.3) * int(inside) for i in range(1, degree + 1)}
    if "prescribed" in laws:
        p["prescribed.series"] = [some(-0.1, 0.1), some(-0.1, 0.1)]
        first_, slope = p["prescribed.series"]
        p["prescribed"] = arb_series([p["prescribed.VALUE"] + first_, slope], prec=ORDER + 1)
    return p


def numbers(case: Case, p: Mapping[str, Any]) -> tuple[dict[str, arb], dict[str, arb], dict[str, list[arb]]]:
    """The cells of a point where its phase begins, its states at the moment, and its series of time."""
    theta, moving = p["Theta"], case[2]
    cells = {k: v for k, v in p.items() if isinstance(v, arb)} | {
        "driving_moment": p["C_theta"] * p["psi"].sin() / theta,
        "driving_moment_slope": p["C_theta"] * p["psi"].cos() / theta,
        "normal_load": p["C_r"] * p["psi"].cos() / theta, "normal_load_slope": -p["C_r"] * p["psi"].sin() / theta,
        "polar_moment": p["I_p"] / theta, "resistance_factor": p["lambda"] / theta,
    }  # fmt: skip
    cells |= {x: p[x][0] for x in ("k_h", "k_v", "pore_ratio", "pore_pressure") if x not in moving}
    now = {name.removeprefix("now."): v for name, v in p.items() if name.startswith("now.")}
    series = {name.removesuffix(".series"): v for name, v in p.items() if name.endswith(".series")}
    return cells, now, series


def registers(program: Program, cells: dict[str, arb], now: Mapping[str, arb], series: Mapping[str, Sequence[arb]]
              ) -> list[list[arb]]:  # fmt: skip
    """All registers of a program at a moment of a phase."""
    c = prologue(program, cells)
    # The limit friction is an input: what the balance at the start says, so that the drive is the same number.
    at = program.roles
    limit = (c[at["cell_driving"]] - c[at["cell_resisting"]]) / c[at["cell_normal0"]]
    c = prologue(program, cells | {"LIMIT": limit})
    for cell, _, _ in program.states:
        c[cell] = now.get(program.cells[cell], arb(0))
    ramps = {t.register: series[t.name] for t in program.tables if t.kind == "time"}
    for tangent in program.tangents:
        ramps |= {
            tangent.registers[t.register]: series[f"{t.name}'0"]
            for t in program.tables if t.kind == "time" and t.register in tangent.registers
        }  # fmt: skip
    return run(program, c, ramps, ORDER)


def at_a_point(case: Case, seed: int, asked: tuple[str, ...]) -> tuple[Program, list[list[arb]], dict[str, Any]]:
    """The program of a case, its registers at a random moment, and the numbers of that moment."""
    ctx.prec, ctx.cap = PRECISION, ORDER + 1
    program = build_program(*case, asked)
    p = point(random.Random(f"{case} {seed}"), case)
    return program, registers(program, *numbers(case, p)), p


def register(program: Program, name: str) -> int:
    """Where a program has a quantity; -1 where it has none."""
    return program.roles.get(name, program.registers.index(name) if name in program.registers else -1)


def tangent_difference(case: Case, seed: int) -> float:
    """The worst difference of a program's derivative in a random direction from a quotient of differences."""
    ctx.prec, ctx.cap = 4 * PRECISION, ORDER + 1
    rng = random.Random(f"{case} {seed}")
    program, both = build_program(*case), build_program(*case, (), 1)
    cells, now, series = numbers(case, point(rng, case))
    step, change = arb(2) ** -500, {}
    for cell in both.tangents[0].cells:
        if both.cells[cell] != "drive":
            change[both.cells[cell]] = arb(rng.uniform(-1, 1))
    moves = {x: arb(rng.uniform(-1, 1)) for x in now}
    ramps = {x: [arb(rng.uniform(-1, 1)) for _ in v] for x, v in series.items()}
    first = registers(program, cells, now, series)
    moved = registers(
        program,
        cells | {x: cells.get(x, arb(0)) + step * d for x, d in change.items()},
        {x: v + step * moves[x] for x, v in now.items()},
        {x: [a + step * b for a, b in zip(v, ramps[x], strict=True)] for x, v in series.items()},
    )
    r = registers(
        both,
        cells | {f"{x}'0": d for x, d in change.items()},
        dict(now) | {f"{x}'0": d for x, d in moves.items()},
        dict(series) | {f"{x}'0": d for x, d in ramps.items()},
    )
    worst = 0.0
    for name in ("x", "omega", "net", "normal", "upright", "excess"):
        if (place := register(program, name)) < 0:
            continue
        tangent = both.tangents[0].registers.get(register(both, name), -1)
        for i in range(ORDER):
            quotient = (moved[place][i] - first[place][i]) / step
            found = r[tangent][i] if tangent >= 0 else arb(0)
            far = float(abs(found - quotient).upper()) / max(1.0, float(abs(quotient).mid()))
            worst = far if not far < worst else worst
    return worst


def difference(case: Case, seed: int) -> float:
    """The worst relative difference of a coefficient of any register that both sides have."""
    effects, laws, *_ = case
    program, found, p = at_a_point(case, seed, ("mu",))

    def mu(x: Any, w: Any) -> Any:
        found = coefficient(laws[0], p, x, w)
        return found * coefficient(laws[1], p, x, w) if len(laws) > 1 else found

    plain = motion(p, effects, mu, ORDER)
    worst = 0.0
    for name in ("x", "omega", "net", "normal", "mu", "upright", "excess"):
        if (place := register(program, name)) < 0:
            continue
        series = plain[name].coeffs()
        series += [arb(0)] * (ORDER - len(series))
        size = max(float(abs(x).mid()) for x in series[:ORDER])
        for i in range(ORDER):
            far = float(abs(found[place][i] - series[i]).upper()) / size
            worst = far if not far < worst else worst  # what is no number stays
    return worst


BOUND = 1e-30


def main() -> int:
    """All programs, or as many as are asked for; 1 where one differs."""
    chosen, worst = list(cases()), 0.0
    if len(sys.argv) > 1:
        chosen = random.Random(1).sample(chosen, int(sys.argv[1]))
    for count, case in enumerate(chosen, 1):
        found = difference(case, 0)
        if not found < BOUND:
            print(f"differs by {found:.1e}: {case}")
            return 1
        worst = max(worst, found)
        if count % 1000 == 0:
            print(f"{count} programs, worst difference {worst:.1e}", file=sys.stderr, flush=True)
    print(f"{len(chosen)} programs agree with the plain equation of motion to {worst:.1e}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
