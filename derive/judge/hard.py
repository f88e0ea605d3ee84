"""Hard cases, declared as data: where the printed form of a quantity loses digits, and the error of ours there.

`report` runs the programs of both and compares them with the closed form at hundreds of digits. The
tests run through the same list with quadrature of the definitions instead.
"""

import json
import math
import shutil
import textwrap
from collections.abc import Iterator, Mapping, Sequence
from functools import cache, partial
from typing import Any, Literal, NamedTuple

import mpmath
import numpy as np
import sympy as sp
from sympy import Expr, atan, atanh, cos, cosh, lambdify, log, pi, sin, sinh, sqrt, tanh

from derive.algebra.integrate import PSI, closed_forms, derive
from derive.algebra.prove import trig_normal
from derive.approximate.programs import variants, variants_of_ends
from derive.code.program import Program, program
from derive.declare.quantities import MOMENTS, QUOTIENTS
from derive.declare.symbols import a, alpha, b, omega_0, t, theta_1, theta_2, theta_m
from derive.flow.fragments import balance
from derive.flow.recurrences import numbers
from derive.generate import functions
from derive.progress import track


class HardCase(NamedTuple):
    """Arguments of one case, and why it is hard."""

    function: str
    arguments: tuple[float, ...]
    why: str


class Form(NamedTuple):
    """The form of a function that fails: its name in the paper, its program, and what it is in exact arithmetic."""

    words: str
    program: Program
    exact: Expr


class Result(NamedTuple):
    """Measured errors of a hard case: relative, and ours also in ulp; NaN if a form has no value."""

    function: str
    arguments: tuple[float, ...]
    why: str
    naive: str
    naive_error: float
    our_error: float
    our_ulp: float


def _motion() -> dict[str, tuple[str, Expr]]:
    """Textbook forms of the motion by name, and where they come from."""
    k = sqrt(a * b)
    y = cosh(k * t) + b * omega_0 * sinh(k * t) / k
    tangent = tanh(k * t) / k
    brake = sqrt(-a * b)
    return {
        "angular_velocity": ("(3.20) from motion", (omega_0 + a * tangent) / (1 + b * omega_0 * tangent)),
        "rotation": ("(4.3) from motion", log(y) / b),
        "angular_acceleration": ("(3.16) from motion", (a - b * omega_0**2) / y**2),
        "arrest_time": ("omega = 0 in (3.20)", atan(b * omega_0 / brake) / brake),
        "arrest_rotation": ("(4.3) at the arrest", log(1 - b * omega_0**2 / a) / (2 * b)),
    }


@cache
def forms() -> dict[str, Form]:
    """The naive form of every function: as the paper prints it, or integrated term by term."""
    c = cos(alpha)  # with which squares of the sine are written
    terms = {name: trig_normal(form + c) - c for name, form in closed_forms().items()}
    naive = _of_alpha(terms) | _of_ends(terms)
    for name, (words, form) in _motion().items():
        inputs = ("a", "b", "omega_0") if "arrest" in name else ("a", "b", "omega_0", "t")
        naive[f"frozen_{name}"] = Form(words, program(name, inputs, form), form)
    drive = _NORMAL_LOAD * _LIMIT - _NORMAL_LOAD * _MU
    naive["drive"] = Form("driving - mu normal", program("drive", ("normal_load", "mu", "limit"), drive), drive)
    return naive


def _of_alpha(terms: Mapping[str, Expr]) -> dict[str, Form]:
    """Base quantities and quotients: the printed program where there is one, else that of the integral's terms."""
    printed = {p.name: (words, p) for p, words in functions.printed()}
    naive: dict[str, Form] = {}

    def add(name: str, words: str, form: Expr) -> None:
        words, naive_program = printed.get(name) or (words, program(name, ("alpha",), form))
        naive[name] = Form(words, naive_program, form)

    for name, form in terms.items():
        add(name, "its integral, term by term", form)
    for q in QUOTIENTS:
        words = f"{naive[q.numerator].words} over {naive[q.denominator].words}"
        add(q.name, words, terms[q.numerator] / terms[q.denominator])
    return naive


def _of_ends(terms: Mapping[str, Expr]) -> dict[str, Form]:
    """Functions of the ends of an arc, whose half angle and middle are rounded."""
    printed = _of_alpha(terms)
    turned: dict[str, tuple[str, Expr]] = {}
    for moment in MOMENTS:
        if moment.amplitude:
            kernel = moment.kernel[0]
            direction = derive(moment).direction.subs(PSI, 3 * pi / 2 - theta_m)
            turned[moment.name] = printed[kernel].words, direction * terms[kernel]
    limit_friction = turned["weight_moment"][1] / turned["radial_weight"][1]
    turned["limit_friction"] = "(3.13) over Appendix I", limit_friction
    ends = {alpha: (theta_2 - theta_1) / 2, theta_m: (theta_1 + theta_2) / 2}
    naive = {}
    for name, (words, form) in turned.items():
        rounded = program(name, ("theta_1", "theta_2"), form, let=ends)
        naive[name] = Form(f"{words}, angles rounded", rounded, form.subs(ends))
    return naive


_NORMAL_LOAD, _MU, _LIMIT = sp.symbols("normal_load mu limit", real=True)


def drive(rows: Sequence[Sequence[str]], normal_load: Any, mu: Any, limit: Any) -> Any:
    """The net moment at the start, by the balance's operations on cells, given the limit friction; all else is 0."""
    cells = {x: np.float64(x[1:] if x[0] == "=" else 0) for _, _, *operands in rows for x in operands}
    cells |= {"pressing_0": normal_load, "normal_load_0": normal_load, "mu_0": mu, "LIMIT": limit}
    return numbers(rows, cells | dict.fromkeys(("driving_0", "driving_moment_0"), normal_load * limit))["drive"]


HALF_PI = math.pi / 2
CUBE = "parts of size alpha leave a difference of size alpha**3"
UNDER = "so thin that alpha**3 underflows, but not the quotient"
DENORMAL = "the result is denormal"
TOP = "half disc: artanh(sin alpha) is infinite, and its factor 0"
THIN = "thin arc: alpha, and its cube, from a difference of two angles"
REST = "omega_0 cancels the limit velocity -sqrt(a/b): the growing part of y is small, and wins"
STILL = "b = 0, no centripetal stress: the general form is 0/0"


def _kernels() -> Iterator[HardCase]:
    """Of each function of alpha: thin, so thin that it underflows, and where artanh is infinite."""
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


CASES = (
    *_kernels(),
    HardCase("radial_weight", (0.1, 0.2), "alpha is not a double: its rounding error times the slope counts"),
    HardCase("weight_moment", (4.0, 5.42477796076938), "level: cos(theta_m), of an exact theta_m that is no double"),
    HardCase("limit_friction", (4.0, 4.0 + 1e-10), THIN),
    HardCase("limit_friction", (math.pi, 2 * math.pi), TOP),
    HardCase("limit_friction", (2.9, 2.9 + 0.8), "a dip of 81 deg: small weight towards the arc"),
    HardCase("limit_friction", (5.3, 5.3 + 1e-6), "an arc of 1e-6 rad, of negative dip"),
    HardCase("frozen_angular_velocity", (2.0, 0.0, 0.5, 1.5), STILL),
    HardCase("frozen_rotation", (2.0, 0.0, 0.5, 1.5), STILL),
    HardCase("frozen_angular_acceleration", (2.0, 0.0, 0.5, 1.5), STILL),
    HardCase("frozen_arrest_time", (-2.0, 0.0, 0.5), STILL),
    HardCase("frozen_arrest_rotation", (-2.0, 0.0, 0.5), STILL),
    HardCase("frozen_angular_velocity", (1e200, 1e200, 0.0, 1.0), "a b overflows, its root does not"),
    HardCase("frozen_angular_velocity", (-0.1, 0.3, 0.2, 0.7), "a b < 0: sqrt(a b) is not real"),
    HardCase("frozen_angular_velocity", (0.75, 3.25, -0.4803, 8.5), REST),
    HardCase("frozen_rotation", (0.1, 1e-18, 0.0, 2.0), "b -> 0: the logarithm of nearly 1, over b"),
    HardCase("frozen_rotation", (0.1, 0.3, 0.0, 1e-7), "t -> 0: the logarithm of nearly 1"),
    HardCase("frozen_rotation", (0.1, 0.3, 0.0, 1.4e-10), "an end after 1e-9 s"),
    HardCase("frozen_rotation", (2.0, 0.5, 0.0, 1.4e8), "an end after 1e9 s: cosh(kt) overflows"),
    HardCase("frozen_angular_acceleration", (1e30, 1e-30, 0.0, 360.0), "exp(-2kt) underflows, a exp(-2kt) does not"),
    HardCase(
        "frozen_angular_acceleration",
        (2.0, 0.7, -1.690308502489062, 8.451542547285166),
        "thrown up-slope, turning at t: its start near -sqrt(a/b) hardly matters",
    ),
    HardCase("frozen_arrest_time", (-0.1, 0.0, 0.2), "b = 0: arctan(0)/0"),
    HardCase("frozen_arrest_rotation", (-0.1, 0.3, 1e-8), "arrest within the first microsecond"),
    HardCase("frozen_arrest_time", (-1e-200, 1e-200, 1.0), "a b underflows, its root does not"),
    HardCase("frozen_arrest_rotation", (-0.1, 1e-17, 0.2), "b -> 0: the logarithm of nearly 1, over b"),
    HardCase("drive", (1.2, 0.41919999999999996, 0.4192), "friction an ulp below its limit"),
    HardCase("drive", (1.2, 0.4192 * (1 - 1e-12), 0.4192), "friction just below its limit"),
    HardCase("drive", (1.2, 0.41920000000000007, 0.4192), "friction an ulp above its limit"),
)


def measured() -> list[Result]:
    """Run both forms of every case and compare them with the exact one."""
    programs = [v.program for v in (*variants(), *variants_of_ends()) if v.tier == "best" and v.form != "fused"]
    ours = {p.name: p.run for p in (*programs, *(f.program for f in functions.motion()))}
    ours["drive"] = partial(drive, balance().scalar)
    results = []
    for case in track(CASES, "hard cases measured", len(CASES)):
        form = forms()[case.function]
        arrays = [np.array(x) for x in case.arguments]
        with np.errstate(all="ignore"):
            naive = float(form.program.run(*arrays))
            computed = float(ours[case.function](*arrays))
        exact = _exact(form, case.arguments)
        with mpmath.workdps(_DIGITS):
            size = abs(exact)
            ulp = float(np.spacing(float(size)))
            naive_error = abs(naive)
            if math.isfinite(naive):
                naive_error = float(abs(naive - exact) / size)
            error = abs(computed - exact)
            results.append(Result(*case, form.words, naive_error, float(error / size), float(error / ulp)))
    return results


_DIGITS = 1600  # more bits than cancel


def _exact(form: Form, arguments: tuple[float, ...]) -> mpmath.mpf:
    """The exact form at these arguments, with zeros replaced by tiny numbers."""
    symbols = sp.symbols(form.program.inputs, real=True)
    with mpmath.workdps(_DIGITS):
        numbers = [mpmath.mpf(x) or mpmath.mpf(10) ** -400 for x in arguments]
        return mpmath.re(lambdify(symbols, form.exact, "mpmath")(*numbers))


def report(form: Literal["text", "json"]) -> str:
    """The hard cases, each with the error of the printed form beside ours."""
    results = measured()
    if form == "json":
        rows = [x._asdict() for x in results]
        for row in rows:
            if not math.isfinite(row["naive_error"]):  # JSON has no inf and no NaN
                row["naive_error"] = _short(row["naive_error"])
        return json.dumps(rows, indent=2)
    lines = [
        "Relative error of the printed form, and of ours (also in units of the last place).",
        "",
        f"{'printed':>9} {'ours':>8} {'ulp':>6}   input",
    ]
    width = min(shutil.get_terminal_size((96, 24)).columns, 96)
    indent = " " * 28
    for name in dict.fromkeys(x.function for x in results):
        lines += ["", name]
        for x in results:
            if x.function != name:
                continue
            arguments = ", ".join(map(repr, x.arguments))
            lines.append(f"{_short(x.naive_error):>9} {x.our_error:8.0e} {x.our_ulp:6.1f}   ({arguments})")
            lines += textwrap.wrap(f"{x.why}; {x.naive}", width, initial_indent=indent, subsequent_indent=indent)
    return "\n".join(lines)


def _short(error: float) -> str:
    return f"{error:.0e}".replace("nan", "NaN")
