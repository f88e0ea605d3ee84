"""Shapes of the kernels' approximants, and the fits that fill them: near 0, near pi/2, and over the whole domain.

Near 0, in u = alpha**2: F = alpha u W(u), W a polynomial whose constant term is the limit of F/alpha**3. Near pi/2, in
b = pi/2 - alpha, where artanh(sin(alpha)) = -ln(tan(b/2)): F is a function of b that is odd but for its value at 0, or
even, plus such a one times ln(b). A straight line that is computed without rounding is taken off it, and what is left
is b**power (R(b**2) + b**(2 shift) Q(b**2) ln(b)). Of a form that is neither (lambda), one polynomial serves for all.

Seams, baselines and degrees are found by `derive.approximate.search` and recorded in ``records`` by definition.
"""

import json
from dataclasses import asdict, dataclass
from fractions import Fraction
from functools import cache
from pathlib import Path

import sympy as sp
from flint import arb, ctx, fmpq, fmpq_series

from derive.algebra.integrate import closed_forms
from derive.approximate.minimax import GUARD, Function, Samples, evaluate, horner, minimax, nearest, rounded, sample
from derive.approximate.minimax import value as at
from derive.check import truth
from derive.check.proof import ProofError
from derive.check.truth import number
from derive.declare.quantities import MOMENTS, QUOTIENTS, RESISTANCE
from derive.declare.symbols import alpha

HALF_PI = truth.TOP
RECORDS = Path(__file__).resolve().parent / "records" / "shapes.json"


@dataclass(frozen=True)
class Kernel:
    """A function of alpha: the closed form that SymPy derived, or two for a quotient, and what certificates call it."""

    name: str
    closed: tuple[sp.Expr, ...]
    definition: tuple[str, ...]


def kernels() -> list[Kernel]:
    """All that are certified: the base quantities and their quotients."""
    closed = closed_forms()
    definitions = {m.kernel[0]: m.definition for m in MOMENTS if m.certified} | {RESISTANCE.name: RESISTANCE.definition}
    found = [Kernel(name, (closed[name],), definition) for name, definition in definitions.items()]
    for q in QUOTIENTS:
        parts = (q.numerator, q.denominator)
        if all(part in definitions for part in parts):
            found.append(Kernel(q.name, tuple(closed[p] for p in parts), tuple(definitions[p][0] for p in parts)))
    return found


@cache
def at_zero(closed: sp.Expr) -> list[fmpq]:
    """Taylor coefficients at 0, exactly."""
    with truth.working(GUARD):
        series = evaluate(closed, fmpq_series([0, 1]))
        return [series[k] for k in range(truth.TERMS + 1)]


def limit(closed: sp.Expr) -> Fraction:
    """Of F/alpha**3 at 0."""
    first = at_zero(closed)[truth.CUBE]
    return Fraction(int(first.p), int(first.q))


def agree(kernel: Kernel) -> int:
    """How often the derived form was compared with the checker's definition, or `ProofError` where they differ.

    Taylor coefficients at 0 are compared exactly, values in balls.
    """
    for closed, statement in zip(kernel.closed, kernel.definition, strict=True):
        for k, (found, right) in enumerate(zip(at_zero(closed), truth.at_zero(statement), strict=True)):
            if found != right:
                raise ProofError(
                    f"{kernel.name}: coefficient of alpha^{k} in the checker's definition {statement}", found, right
                )
        for x in (0.25, 0.75, 1.25, HALF_PI):
            with truth.working(GUARD):
                here, there = arb(evaluate(closed, arb(x))), truth.value([statement], arb(x))
                if not abs(here / there - 1) < arb(2) ** -200:
                    raise ProofError(
                        f"{kernel.name}: value at {x} by the checker's definition {statement}",
                        here.str(20, radius=False),
                        there.str(20, radius=False),
                    )
    return len(kernel.closed) * (truth.TERMS + 5)


@dataclass(frozen=True)
class End:
    """What a closed form is in b = pi/2 - alpha: odd (but for its value at 0) or even, and where its logarithm starts.

    ``first`` is the coefficient of b or of b**2 without logarithm, ``log`` the power of b at ln(b), or 0 without one.
    """

    odd: bool
    first: float
    log: int
    serves: bool = True  # not if the form is neither odd nor even


@cache
def end(closed: sp.Expr) -> End:
    """Expand about pi/2."""
    b, h = sp.Dummy("b", real=True), sp.Dummy("h", real=True)
    form = sp.expand(sp.expand_trig(closed.subs(alpha, sp.pi / 2 - b).subs(sp.atanh(sp.cos(b)), h)))
    smooth, logs = form.coeff(h, 0), form.coeff(h, 1)
    smooth -= smooth.subs(b, 0)
    for odd, sign in ((True, 1), (False, -1)):
        if all(sp.expand(part + sign * part.subs(b, -b)) == 0 for part in (smooth, logs)):
            with truth.working(GUARD):
                x = fmpq_series([0, 1])
                first, series = evaluate(smooth, x)[1 if odd else 2], evaluate(logs, x) if logs != 0 else x
                log = next(k for k in range(truth.TERMS) if series[k] != 0) if logs != 0 else 0
                return End(odd, float(first), log)
    return End(False, 0.0, 0, serves=False)


@dataclass(frozen=True)
class Far:
    """Of the piece near pi/2: its baseline slope alpha + line, bend, the logarithm's scale, and the degree of R.

    The line is a multiple of 2**-52, as alpha >= 1 is, so that the sum makes no rounding error. Where F is even in b,
    b (slope - bend b) is taken off next; the logarithm is that of scale b.
    """

    slope: float
    line: float
    bend: float
    scale: float
    degree: int


@dataclass(frozen=True)
class Pieces:
    """Of a base quantity for the best tier: the seam, coefficients near 0, and what serves beyond it.

    Fused, the rounding errors of the ``kept`` leading sums near 0 are kept.
    """

    seam: float
    count: int
    kept: int = 2
    far: Far | None = None


@dataclass(frozen=True)
class Shape:
    """The pieces of a base quantity or of a quotient's two parts; for each other tier the degrees over and under."""

    best: tuple[Pieces, ...]
    cheap: tuple[tuple[str, int, int], ...]


@cache
def records() -> dict[tuple[str, ...], Shape]:
    """The shapes that were found before, by definition; what is found in this run joins them."""
    found = {}
    for key, known in json.loads(RECORDS.read_text(encoding="utf-8")).items():
        best = [Pieces(**p | {"far": p["far"] and Far(**p["far"])}) for p in known["best"]]
        found[tuple(key.split(" / "))] = Shape(tuple(best), tuple(map(tuple, known["cheap"])))
    return found


def text() -> str:
    """The file of records: one definition a line, none that nothing declares."""
    wanted = sorted({kernel.definition for kernel in kernels()})
    lines = [f"{json.dumps(' / '.join(d))}: {json.dumps(asdict(records()[d]))}" for d in wanted]
    return "{\n" + ",\n".join(lines) + "\n}\n"


def scaled(closed: sp.Expr, wanted: Fraction) -> Function:
    """F/alpha**3 as a function of alpha**2, times what makes `wanted` its limit at 0."""
    factor = number(wanted / limit(closed))
    return lambda u: factor * at(closed, u.sqrt()) / (u * u.sqrt())


def near_samples(closed: sp.Expr, seam: float, count: int, wanted: Fraction) -> Samples:
    """(W - limit)/u on [0, seam], for the least relative error."""
    with ctx.workprec(GUARD):
        return sample(scaled(closed, wanted), lambda u, f: 1 / f, number(seam) ** 2, count).without(number(wanted))


@cache
def near_fit(closed: sp.Expr, seam: float, count: int, wanted: Fraction) -> tuple[float, ...]:
    """c1, c2, ... of W = limit + u (c1 + u (c2 + ...)): F/alpha**3, or its multiple with that limit at 0."""
    return rounded(near_samples(closed, seam, count, wanted), count - 1, careful=min(3, count - 1))[0]


@cache
def logarithm_fit() -> tuple[float, tuple[float, ...]]:
    """ln 2, and P(z) = (2 artanh(q)/q - 2)/z in z = q**2, for q <= 1/5."""
    degree = 6
    with ctx.workprec(GUARD):
        upper = number(Fraction(1, 25))
        samples = sample(lambda z: (2 * z.sqrt().atanh() / z.sqrt() - 2) / z, lambda z, _: z * z.sqrt(), upper, degree)
        return nearest(arb(2).log()), rounded(samples, degree, careful=1)[0]


@cache
def cheap_fit(closed: sp.Expr, above: int, below: int) -> tuple[tuple[float, ...], tuple[float, ...], float]:
    """Numerator and denominator of F/alpha**3, and their relative error before rounding.

    In alpha**2, a rational in pi**2/4 - alpha**2.
    """
    function = scaled(closed, limit(closed))
    with ctx.workprec(GUARD):
        largest = (arb.pi() / 2) ** 2
        samples = sample(lambda z: function(largest - z if below else z), lambda z, f: 1 / f, largest, above + below, 2)
    over, under, error = minimax(samples, above, below)
    return tuple(map(nearest, over)), tuple(map(nearest, under)), error


def powers(closed: sp.Expr, far: Far) -> tuple[int, int]:
    """The power of b in front of what the baseline leaves, and half the power of b in front of Q."""
    about = end(closed)
    taken = about.first == -(far.slope if about.odd else far.bend)
    power = (1 if about.odd else 2) + 2 * (taken and (not about.log or about.log >= (3 if about.odd else 4)))
    return power, (about.log - power) // 2 if about.log else 0


@dataclass(frozen=True)
class FarFit:
    """F = (slope alpha + line) + (constant + tilt b + b (slope - bend b) + b**power (R + b**(2 shift) Q ln(scale b))).

    The product with slope and bend is there where F is even in b. R and Q in b**2, of b = fl(pi/2) - alpha as it is
    computed: pi/2 - fl(pi/2) is folded in, the tilt among it. ``error`` is relative, before rounding.
    """

    constant: float
    tilt: float
    power: int
    shift: int
    r: tuple[float, ...]
    q: tuple[float, ...]
    error: float


@cache
def far_fit(closed: sp.Expr, far: Far, seam: float) -> FarFit:
    """The piece beyond the seam: R and Q together; with Q rounded, R again."""
    about, (power, shift), degree = end(closed), powers(closed, far), far.degree
    with ctx.workprec(GUARD):
        there = at(closed, number(HALF_PI))
        constant = nearest(there - number(far.slope) * number(HALF_PI) - number(far.line))
        constant = constant if abs(constant) > 2.0**-80 else 0.0
        tilt = 0.0
        if not about.odd and about.log != 2:  # where ln(b) starts at b**2 there is no second derivative
            tilt = -nearest(at(sp.diff(closed, alpha), number(HALF_PI)))
        straight = number(far.slope) * number(HALF_PI) + number(far.line) + number(constant)
        slope, bend = (far.slope, 0.0) if about.odd else (0.0, -far.bend)
        known = [straight, number(tilt) - number(slope), number(bend)]

        def rest(w: arb) -> arb:
            b = w.sqrt()
            return (at(closed, number(HALF_PI) - b) - horner(known, b)) / b**power

        def weight(w: arb, left: arb) -> arb:
            b = w.sqrt()
            return b**power / (left * b**power + horner(known, b))

        samples = sample(rest, weight, number(HALF_PI - seam) ** 2, (2 if about.log else 1) * degree + 2, 2)
        logs = [w**shift * (number(far.scale) * w.sqrt()).log() for w in samples.points] if about.log else []
    if not about.log:
        r, error = rounded(samples, degree, careful=min(3, degree))
        return FarFit(constant, tilt, power, shift, r, (), error)
    _, found, error = minimax(samples, degree, logs=(logs, max(degree - shift, 0)))
    q = tuple(map(nearest, found))
    with ctx.workprec(GUARD):
        terms = zip(samples.points, samples.values, logs, strict=True)
        left = [(f - horner([number(c) for c in q], w) * l).mid() for w, f, l in terms]
    r, _ = rounded(Samples(samples.points, left, samples.weights), degree, careful=1)
    return FarFit(constant, tilt, power, shift, r, q, error)
