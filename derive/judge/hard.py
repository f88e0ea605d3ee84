"""Hard cases declared as data: arguments at which printed forms lose digits, with errors of the kernels and of `solve`.

`hard_case_report` runs the programs and compares them with the closed form at hundreds of digits. The tests compare the
same list with quadrature of the definitions.
"""

import math
import shutil
import subprocess
import sys
import textwrap
from collections.abc import Iterator
from functools import cache
from typing import NamedTuple

import mpmath
import numpy as np
import sympy as sp
from sympy import Expr, atanh, cos, lambdify, pi, sin, sqrt

from derive.algebra.integrate import PSI, closed_forms, derive
from derive.algebra.prove import trig_normal
from derive.approximate.programs import variants, variants_of_ends
from derive.code.program import Program, program
from derive.declare.quantities import MOMENTS, QUOTIENTS
from derive.declare.symbols import Forms, alpha, theta_1, theta_2, theta_m
from derive.generate import functions
from derive.kinds import TextMap
from derive.progress import track


class HardCase(NamedTuple):
    """Arguments of one case, and the reason for its difficulty."""

    function: str
    arguments: tuple[float, ...]
    why: str


class Form(NamedTuple):
    """Form of a function that fails: its name in the paper, its program, and its exact value."""

    words: str
    program: Program
    exact: Expr


class Result(NamedTuple):
    """Measured relative errors of a hard case, for the kernel also in ulp; NaN without a value."""

    function: str
    arguments: tuple[float, ...]
    why: str
    naive: str
    naive_error: float
    our_error: float
    our_ulp: float
    solve_error: float


@cache
def forms() -> dict[str, Form]:
    """Return the naive form of every function by name, as printed in the paper or integrated term by term."""
    c = cos(alpha)  # with which squares of the sine are written
    terms = {name: trig_normal(form + c) - c for name, form in closed_forms().items()}
    printed = functions.printed()
    words = dict.fromkeys(terms, "its integral, term by term") | {p.name: source for p, source in printed}
    exact = dict(terms)
    for q in QUOTIENTS:
        words.setdefault(q.name, f"{words[q.numerator]} over {words[q.denominator]}")
        exact[q.name] = terms[q.numerator] / terms[q.denominator]
    programs = {name: program(name, ("alpha",), form) for name, form in exact.items()}
    programs |= {p.name: p for p, _ in printed}
    of_alpha = {name: Form(words[name], programs[name], form) for name, form in exact.items()}
    return of_alpha | _of_ends(terms, words)


def _of_ends(terms: Forms, words: TextMap) -> dict[str, Form]:
    """Return forms of functions of the ends of an arc by name; half angle and middle are rounded.

    ``terms`` are the closed forms in alpha by name, written term by term, and ``words`` their names in the paper.
    """
    turned: dict[str, tuple[str, Expr]] = {}
    for moment in MOMENTS:
        if moment.amplitude:
            kernel = moment.kernel[0]
            direction = derive(moment).direction.subs(PSI, 3 * pi / 2 - theta_m)
            turned[moment.name] = words[kernel], direction * terms[kernel]
    moment, radial = (turned[x][1] for x in ("weight_moment", "radial_weight"))
    turned["limit_friction"] = "(3.13) over Appendix I", moment / radial
    size = sqrt(terms["weight_moment_amplitude"] ** 2 + (_MU * terms["radial_weight_amplitude"]) ** 2)
    turned["sine_of_half_run_out"] = "(J_theta - mu J_r) over its amplitude", (moment - _MU * radial) / size
    ends = {alpha: (theta_2 - theta_1) / 2, theta_m: (theta_1 + theta_2) / 2}
    naive = {}
    for name, (source, form) in turned.items():
        rounded = program(name, ("theta_1", "theta_2", *(("mu",) if form.has(_MU) else ())), form, let=ends)
        naive[name] = Form(f"{source}, angles rounded", rounded, form.subs(ends))
    return naive


_MU = sp.Symbol("mu", real=True)
HALF_PI = math.pi / 2
CUBE = "parts of size alpha leave a difference of size alpha**3"
UNDER = "so thin that alpha**3 underflows, but not the quotient"
DENORMAL = "the result is denormal"
TOP = "half disc: artanh(sin alpha) is infinite, and its factor 0"
THIN = "thin arc: alpha, and its cube, from a difference of two angles"


def _kernels() -> Iterator[HardCase]:
    """Yield cases of each function of alpha and of both ends: thin arcs, underflowing arcs, and infinite artanh."""
    of_base = ((1e-8, CUBE), (1e-4, CUBE), (1e-103, DENORMAL))
    of_quotient = ((1e-200, UNDER), (5e-324, UNDER), (1e-6, CUBE))
    points = dict.fromkeys(closed_forms(), of_base) | dict.fromkeys((q.name for q in QUOTIENTS), of_quotient)
    for name, cases in points.items():
        for x, why in cases:
            yield HardCase(name, (x,), why)
        if "arctanh" in forms()[name].program.operations():
            yield HardCase(name, (HALF_PI,), TOP)
    for m in MOMENTS:
        if m.amplitude:
            yield HardCase(m.name, (4.0, 4.0 + 1e-10), THIN)
            if forms()[m.name].exact.has(atanh) and m.weight.has(sin):  # else the direction is 0 there
                yield HardCase(m.name, (math.pi, 2 * math.pi), TOP)


_OF_ENDS = (
    HardCase("radial_weight", (0.1, 0.2), "alpha is not a double: its rounding error times the slope counts"),
    HardCase("weight_moment", (4.0, 5.42477796076938), "level: cos(theta_m), of an exact theta_m that is no double"),
    HardCase("limit_friction", (4.0, 4.0 + 1e-10), THIN),
    HardCase("limit_friction", (math.pi, 2 * math.pi), TOP),
    HardCase("limit_friction", (2.9, 2.9 + 0.8), "a dip of 81 deg: small weight towards the arc"),
    HardCase("limit_friction", (5.3, 5.3 + 1e-6), "an arc of 1e-6 rad, of negative dip"),
    HardCase("sine_of_half_run_out", (4.0, 5.0, 0.2051426220987608), "friction an ulp below its limit"),
    HardCase("sine_of_half_run_out", (4.0, 5.0, 0.20514262209876086 * (1 - 1e-12)), "friction just below its limit"),
    HardCase("sine_of_half_run_out", (4.0, 5.0, 0.20514262209876086 * (1 - 1e-6)), "friction a little below its limit"),
)


@cache
def hard_cases() -> tuple[HardCase, ...]:
    """Return cases of functions of alpha derived from their forms, and declared cases."""
    return *_kernels(), *_OF_ENDS


_OF_SOLVE = ("limit_friction", "sine_of_half_run_out")
# The limit friction of a motion along each arc of the input, without the sign of the direction, or with a friction
# coefficient the sine of half its rotation at rest, which is 2 (psi - delta).
_SOLVE = """
import sys
from dataclasses import replace
from math import sin
from slipcircle import load, solve
scene = load("vaiont")
for line in sys.stdin:
    first, last, *friction = map(float, line.split())
    case = replace(scene, arc=replace(scene.arc, theta_1=first, theta_2=last))
    for mu in friction:
        case = replace(case, friction=mu, effects=("rotation",))
    motion = solve(case)
    print(sin(motion.end.rotation / 2) if friction else float(motion.limit_friction))
"""


def _solved() -> dict[HardCase, float]:
    """Return the results of `solve` by hard case, from a separate process, as nothing here imports slipcircle."""
    arcs = [case for case in hard_cases() if case.function in _OF_SOLVE]
    lines = [" ".join(map(repr, case.arguments)) for case in arcs]
    run = [sys.executable, "-c", _SOLVE]
    done = subprocess.run(run, input="\n".join(lines), capture_output=True, text=True, check=True)
    return dict(zip(arcs, map(float, done.stdout.split()), strict=True))


_DIGITS = 1600  # more bits than cancel


def measured() -> list[Result]:
    """Run all forms of every case and return their errors relative to the exact form."""
    solved = _solved()
    every = (*variants(), *variants_of_ends())
    ours = {v.program.name: v.program.run for v in every if v.tier == "best" and v.form != "fused"}
    results = []
    for case in track(hard_cases(), "hard cases measured", len(hard_cases())):
        form = forms()[case.function]
        arrays = [np.array(x) for x in case.arguments]
        with np.errstate(all="ignore"):
            naive = float(form.program.run(*arrays))
            computed = float(ours[case.function](*arrays)) if case.function in ours else math.nan
        symbols = sp.symbols(form.program.inputs, real=True)
        with mpmath.workdps(_DIGITS):
            exact = lambdify(symbols, form.exact, "mpmath")(*map(mpmath.mpf, case.arguments))
            size = abs(exact)
            ulp = float(np.spacing(float(size)))
            error = abs(computed - exact)
            of_solve = abs(solved.get(case, math.nan) - size)
            errors = (abs(naive - exact) / size, error / size, error / ulp, of_solve / size)
            results.append(Result(*case, form.words, *map(float, errors)))
    return results


def hard_case_report() -> str:
    """Return the hard cases with the errors of the printed form, of the kernel and of `solve`."""
    results = measured()
    lines = [
        "Relative error of the printed form, of the kernel (also in units of the last place), and of solve.",
        "Of a motion the limit friction is compared, and with constant friction the rotation at rest.",
        "",
        f"{'printed':>9} {'kernel':>8} {'ulp':>6} {'solve':>8}   input",
    ]
    width = min(shutil.get_terminal_size((96, 24)).columns, 96)
    indent = " " * 37
    for name in dict.fromkeys(x.function for x in results):
        lines += ["", name]
        for x in results:
            if x.function != name:
                continue
            arguments = ", ".join(map(repr, x.arguments))
            cells = (f"{x.naive_error:9.0e}", f"{x.our_error:8.0e}", f"{x.our_ulp:6.1f}", f"{x.solve_error:8.0e}")
            lines.append(f"{' '.join(cells).replace('nan ', '  - ')}   ({arguments})")
            lines += textwrap.wrap(f"{x.why}; {x.naive}", width, initial_indent=indent, subsequent_indent=indent)
    return "\n".join(lines)
