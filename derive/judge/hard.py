"""Hard cases, declared as data: where the printed form of a quantity loses its digits, and what ours loses there.

`report` executes the text that is emitted for both and compares it with the closed form at hundreds of digits. The
tests run through the same list with quadrature of the definitions instead.
"""

import json
import math
import textwrap
from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Literal

import mpmath
import numpy as np
import sympy as sp

from derive.algebra.integrate import PSI, closed_forms, derive
from derive.code import measure
from derive.code.program import Program, program
from derive.declare.quantities import MOMENTS, QUOTIENTS
from derive.declare.symbols import a, alpha, b, omega_0, t, theta_1, theta_2, theta_m
from derive.generate import functions


@dataclass(frozen=True)
class HardCase:
    """One value, why it is hard, and the form that fails there."""

    function: str
    arguments: tuple[float, ...]
    why: str
    naive: str


@dataclass(frozen=True)
class Result:
    """A hard case, measured: relative errors, and ours also in ulp. No number where a form gives none."""

    case: HardCase
    naive_error: float
    our_error: float
    our_ulp: float


HALF_PI = math.pi / 2
CUBE = "parts of size alpha leave a difference of size alpha**3"
UNDER = "so thin that alpha**3 underflows, but not the quotient"
DENORMAL = "the result is denormal"
TERMS = "its integral, term by term"
TOP = "half disc: artanh(sin alpha) is infinite, and its factor 0"
THIN = "thin arc: alpha, and its cube, from a difference of two angles"
REST = "omega_0 cancels the limit velocity -sqrt(a/b): the growing part of y is small, and wins"
ONE_LINE = "Appendix I in one line, angles rounded"
STILL = "b = 0, no centripetal stress: the general form is 0/0"


def _kernels() -> list[HardCase]:
    """Of each function of alpha: thin, so thin that it underflows, and where artanh is infinite."""
    words = {p.name: says for p, says in functions.printed()}
    printed = {p.name: "arctanh" in p.operations() for p, _ in functions.printed()}
    closed, found = closed_forms(), []
    for name, form in closed.items():
        naive = words.get(name, TERMS)
        found += [HardCase(name, (x,), why, naive) for x, why in ((1e-8, CUBE), (1e-4, CUBE), (1e-103, DENORMAL))]
        found += [HardCase(name, (HALF_PI,), TOP, naive)] * printed.get(name, form.has(sp.atanh))
    for q in QUOTIENTS:
        parts = (q.numerator, q.denominator)
        naive = words.get(q.name) or " over ".join(words.get(part, TERMS) for part in parts)
        found += [HardCase(q.name, (x,), why, naive) for x, why in ((1e-200, UNDER), (5e-324, UNDER), (1e-6, CUBE))]
        infinite = printed.get(q.name, any(closed[part].has(sp.atanh) for part in parts))
        found += [HardCase(q.name, (HALF_PI,), TOP, naive)] * infinite
    for m in MOMENTS:
        if m.amplitude:
            naive = f"{words.get(m.amplitude[0], TERMS)}, angles rounded"
            found.append(HardCase(m.name, (4.0, 4.0 + 1e-10), THIN, naive))
            if closed[m.amplitude[0]].has(sp.atanh) and m.weight.has(sp.sin):  # else the direction is 0 there
                found.append(HardCase(m.name, (math.pi, 2 * math.pi), TOP, naive))
    return found


CASES = (
    *_kernels(),
    HardCase("radial_weight", (0.1, 0.2), "alpha is not a double: its rounding error times the slope counts", ONE_LINE),
    HardCase("weight_moment", (4.0, 5.42477796076938), "level: cos(theta_m), of an exact theta_m that is no double",
             "(3.13), integrated, angles rounded"),
    HardCase("limit_friction", (4.0, 4.0 + 1e-10), THIN, "(3.13) over Appendix I, angles rounded"),
    HardCase("limit_friction", (math.pi, 2 * math.pi), TOP, "(3.13) over Appendix I, angles rounded"),
    HardCase("limit_friction", (2.9, 2.9 + 0.8), "a dip of 81 deg: small weight towards the arc",
             "(3.13) over Appendix I, angles rounded"),
    HardCase("limit_friction", (5.3, 5.3 + 1e-6), "an arc of 1e-6 rad, of negative dip",
             "(3.13) over Appendix I, angles rounded"),
    HardCase("frozen_angular_velocity", (2.0, 0.5, 1.5), STILL, "(3.20) from motion"),
    HardCase("frozen_rotation", (2.0, 0.5, 1.5), STILL, "(4.3) from motion"),
    HardCase("frozen_angular_acceleration", (2.0, 0.5, 1.5), STILL, "(3.16) from motion"),
    HardCase("frozen_arrest_time", (-2.0, 0.5), STILL, "omega = 0 in (3.20)"),
    HardCase("frozen_arrest_rotation", (-2.0, 0.5), STILL, "(4.3) at the arrest"),
    HardCase("frozen_centripetal_angular_velocity", (1e200, 1e200, 0.0, 1.0), "a b overflows, its root does not",
             "(3.20) from motion"),
    HardCase("frozen_centripetal_angular_velocity", (-0.1, 0.3, 0.2, 0.7), "a b < 0: sqrt(a b) is not real",
             "(3.20) from motion"),
    HardCase("frozen_centripetal_angular_velocity", (0.75, 3.25, -0.4803, 8.5), REST, "(3.20) from motion"),
    HardCase("frozen_centripetal_rotation", (0.1, 1e-18, 0.0, 2.0), "b -> 0: the logarithm of nearly 1, over b",
             "(4.3) from motion"),
    HardCase("frozen_centripetal_rotation", (0.1, 0.3, 0.0, 1e-7), "t -> 0: the logarithm of nearly 1",
             "(4.3) from motion"),
    HardCase("frozen_centripetal_rotation", (0.1, 0.3, 0.0, 1.4e-10), "an end after 1e-9 s", "(4.3) from motion"),
    HardCase("frozen_centripetal_rotation", (2.0, 0.5, 0.0, 1.4e8), "an end after 1e9 s: cosh(kt) overflows",
             "(4.3) from motion"),
    HardCase("frozen_centripetal_angular_acceleration", (1e30, 1e-30, 0.0, 360.0), "exp(-2kt) underflows, a exp(-2kt) "
             "does not", "(3.16) from motion"),
    HardCase("frozen_centripetal_angular_acceleration", (2.0, 0.7, -1.690308502489062, 8.451542547285166),
             "thrown up-slope, turning at t: its start near -sqrt(a/b) hardly matters", "(3.16) from motion"),
    HardCase("frozen_centripetal_arrest_time", (-0.1, 0.0, 0.2), "b = 0: arctan(0)/0", "omega = 0 in (3.20)"),
    HardCase("frozen_centripetal_arrest_rotation", (-0.1, 0.3, 1e-8), "arrest within the first microsecond",
             "(4.3) at the arrest"),
    HardCase("frozen_centripetal_arrest_time", (-1e-200, 1e-200, 1.0), "a b underflows, its root does not",
             "omega = 0 in (3.20)"),
    HardCase("frozen_centripetal_arrest_rotation", (-0.1, 1e-17, 0.2), "b -> 0: the logarithm of nearly 1, over b",
             "(4.3) at the arrest"),
    HardCase("drop_exponential", (0.0, 1e-9, 0.41, 0.18, 1.0), "the first nanometre of slip",
             "mu(slip) - mu(slip + more)"),
)  # fmt: skip


@dataclass(frozen=True)
class Forms:
    """What a case needs: the program that is generated, the naive one, and the exact form."""

    ours: Program
    naive: Program
    exact: sp.Expr


def _forms() -> dict[str, Forms]:
    derivations = [derive(m) for m in MOMENTS]
    ours = {f.program.name: f.program for f in (*functions.kernels(), *functions.motion())}
    printed, closed = {p.name: p for p, _ in functions.printed()}, closed_forms()
    terms = {name: _terms(form) for name, form in closed.items()}
    found = {}
    for name, form in closed.items():
        found[name] = Forms(ours[name], printed.get(name) or program(name, ("alpha",), terms[name]), form)
    for q in QUOTIENTS:
        naive, exact = (forms[q.numerator] / forms[q.denominator] for forms in (terms, closed))
        found[q.name] = Forms(ours[q.name], printed.get(q.name) or program(q.name, ("alpha",), naive), exact)
    ends = {alpha: (theta_2 - theta_1) / 2, theta_m: (theta_1 + theta_2) / 2}
    turned = {d.moment.name: (d.direction.subs(PSI, 3 * sp.pi / 2 - theta_m), d.moment.kernel[0]) for d in derivations}
    naive, exact = ({name: way * forms[kernel] for name, (way, kernel) in turned.items()} for forms in (terms, closed))
    for forms in (naive, exact):
        forms["limit_friction"] = forms["weight_moment"] / forms["radial_weight"]
    for name in [d.moment.name for d in derivations if d.moment.amplitude] + ["limit_friction"]:
        plain = program(name, ("theta_1", "theta_2"), naive[name], let=ends)
        found[name] = Forms(ours[name], plain, exact[name].subs(ends))
    for name, (form, without) in _motion().items():
        for full, exact in ((f"frozen_centripetal_{name}", form), (f"frozen_{name}", without)):
            inputs = ours[full].inputs
            naive = program(full, inputs, form, let={} if "b" in inputs else {b: sp.Integer(0)})
            found[full] = Forms(ours[full], naive, exact)
    slip, more, peak, residual, length = sp.symbols("slip more peak residual length", real=True)
    law = residual + (peak - residual) * sp.exp(-slip / length)
    drop = next(p for p, _ in functions.laws() if p.name == "drop_exponential")
    fallen = law - law.subs(slip, slip + more)
    found[drop.name] = Forms(drop, program(drop.name, drop.inputs, fallen), fallen)
    return found


def _terms(closed: sp.Expr) -> sp.Expr:
    """A closed form as the sum of its terms in alpha, artanh(sin alpha), and sin(alpha) times powers of cos(alpha)."""
    s, c, h = sp.symbols("s c h", real=True)
    form = sp.expand_trig(closed).subs(sp.atanh(sp.sin(alpha)), h).subs({sp.sin(alpha): s, sp.cos(alpha): c})
    form = sp.expand(sp.rem(sp.expand(form), s**2 + c**2 - 1, s))
    return form.subs({h: sp.atanh(sp.sin(alpha)), s: sp.sin(alpha), c: sp.cos(alpha)})


def _motion() -> dict[str, tuple[sp.Expr, sp.Expr]]:
    """Textbook forms of the motion by name, with centripetal stress and without."""
    k = sp.sqrt(a * b)
    y = sp.cosh(k * t) + b * omega_0 * sp.sinh(k * t) / k
    tangent, brake = sp.tanh(k * t) / k, sp.sqrt(-a * b)
    return {
        "angular_velocity": ((omega_0 + a * tangent) / (1 + b * omega_0 * tangent), omega_0 + a * t),
        "rotation": (sp.log(y) / b, omega_0 * t + a * t**2 / 2),
        "angular_acceleration": ((a - b * omega_0**2) / y**2, a),
        "arrest_time": (sp.atan(b * omega_0 / brake) / brake, -omega_0 / a),
        "arrest_rotation": (sp.log(1 - b * omega_0**2 / a) / (2 * b), -(omega_0**2) / (2 * a)),
    }


def measured(cases: tuple[HardCase, ...] = CASES) -> list[Result]:
    """Run both forms of every case and compare them with the exact one."""
    forms = _forms()
    return [_measure(case, forms[case.function]) for case in cases]


def _measure(case: HardCase, forms: Forms) -> Result:
    exact = _exactly(forms.exact, forms.ours.inputs, case.arguments)
    arrays = [np.array(x) for x in case.arguments]
    with np.errstate(all="ignore"):
        naive, ours = (float(measure.run(p, *arrays)) for p in (forms.naive, forms.ours))
    with mpmath.workdps(60):
        unit = mpmath.mpf(float(np.spacing(abs(float(exact)))))
        error = abs(mpmath.mpf(ours) - exact)
        wrong = float(abs(mpmath.mpf(naive) - exact) / abs(exact)) if math.isfinite(naive) else abs(naive)
        return Result(case, wrong, float(error / abs(exact)), float(error / unit))


def _exactly(form: sp.Expr, inputs: tuple[str, ...], arguments: tuple[float, ...]) -> mpmath.mpf:
    """A closed form at exact arguments, zeros a little off zero, with digits enough for what cancels."""
    lost = sum(abs(math.log10(abs(x))) for x in arguments if x)
    with mpmath.workdps(60 + int(4 * lost) + 1200 * (0.0 in arguments)):
        symbols = [sp.Symbol(x, real=True) for x in inputs]
        function: Callable[..., mpmath.mpf] = sp.lambdify(symbols, form, "mpmath")
        return mpmath.re(function(*(mpmath.mpf(x) or mpmath.mpf(10) ** -400 for x in arguments)))


def report(form: Literal["table", "json"]) -> str:
    """The hard cases, each with the error of the printed form beside ours."""
    results = measured()
    if form == "json":
        rows = [asdict(x.case) | {"naive_error": _number(x.naive_error), "our_error": x.our_error, "our_ulp": x.our_ulp}
                for x in results]  # fmt: skip
        return json.dumps(rows, indent=2)
    lines = ["Relative error of the printed form, and of ours (also in units of the last place).", "",
             f"{'printed':>9} {'ours':>8} {'ulp':>6}   input"]  # fmt: skip
    name = ""
    for x in results:
        if x.case.function != name:
            name = x.case.function
            lines += ["", name]
        ours = f"{x.our_error:8.0e} {x.our_ulp:6.1f}"
        given = ", ".join(map(repr, x.case.arguments))
        lines += [f"{_short(x.naive_error):>9} {ours}   ({given})"]
        lines += textwrap.wrap(f"{x.case.why}; {x.case.naive}", 96, initial_indent=" " * 28, subsequent_indent=" " * 28)
    return "\n".join(lines)


def _short(error: float) -> str:
    return f"{error:.0e}" if math.isfinite(error) else "NaN" if math.isnan(error) else "inf"


def _number(error: float) -> float | str:
    """JSON has no inf and no NaN."""
    return error if math.isfinite(error) else _short(error)
