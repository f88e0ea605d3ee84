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
from flint import arb, ctx, fmpq_series

from derive.algebra.integrate import closed_forms
from derive.approximate.minimax import (
    GUARD,
    Function,
    Samples,
    evaluate,
    grid,
    horner,
    minimax,
    nearest,
    rounded,
    sample,
)
from derive.approximate.minimax import value as at
from derive.check import truth
from derive.check.proof import ProofError
from derive.check.truth import number
from derive.declare.quantities import MOMENTS, QUOTIENTS, RESISTANCE
from derive.declare.symbols import alpha

HALF_PI = truth.TOP
RECORDS = Path(__file__).resolve().parent / "records" / "shapes.json"


# --- what is fitted ------------------------------------------------------------------------------------------------


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
def start(closed: sp.Expr) -> tuple[Fraction, ...]:
    """Taylor coefficients at 0, exactly."""
    with truth.working(GUARD):
        series = evaluate(closed, fmpq_series([0, 1]))
        return tuple(Fraction(int(c.p), int(c.q)) for c in (series[k] for k in range(truth.TERMS + 1)))


def limit(closed: sp.Expr) -> Fraction:
    """Of F/alpha**3 at 0."""
    return start(closed)[truth.CUBE]


def agree(kernel: Kernel) -> int:
    """Compare the derived form with the checker's definition: Taylor coefficients at 0 exactly, values in balls.

    Returns
    -------
    int
        The number of comparisons.

    Raises
    ------
    ProofError
        If they differ.
    """
    for closed, statement in zip(kernel.closed, kernel.definition, strict=True):
        wanted = [Fraction(int(c.p), int(c.q)) for c in truth.at_zero(statement)]
        for k, (found, right) in enumerate(zip(start(closed), wanted, strict=True)):
            if found != right:
                raise ProofError(f"{kernel.name}: coefficient of alpha^{k} in the checker's definition {statement}",
                                 found, right)  # fmt: skip
        for x in (0.25, 0.75, 1.25, HALF_PI):
            with truth.working(GUARD):
                here, there = arb(evaluate(closed, arb(x))), truth.value([statement], arb(x))
                if not abs(here / there - 1) < arb(2) ** -200:
                    raise ProofError(f"{kernel.name}: value at {x} by the checker's definition {statement}",
                                     here.str(20, radius=False), there.str(20, radius=False))  # fmt: skip
    return len(kernel.closed) * (truth.TERMS + 5)


@dataclass(frozen=True)
class End:
    """What a closed form is in b = pi/2 - alpha: odd (but for its value at 0) or even, and where its logarithm starts.

    ``first`` is the coefficient of b or of b**2 without logarithm, ``log`` the power of b at ln(b), or 0 without one.
    """

    odd: bool
    first: Fraction
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
                first = evaluate(smooth, x)[1 if odd else 2]
                series = evaluate(logs, x) if logs != 0 else x
                log = next(k for k in range(truth.TERMS) if series[k] != 0) if logs != 0 else 0
                return End(odd, Fraction(int(first.p), int(first.q)), log)
    return End(False, Fraction(0), 0, serves=False)


# --- shapes --------------------------------------------------------------------------------------------------------


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


# --- fits ----------------------------------------------------------------------------------------------------------


def scaled(closed: sp.Expr, wanted: Fraction) -> Function:
    """F/alpha**3 as a function of alpha**2, times what makes `wanted` its limit at 0."""
    factor = number(wanted / limit(closed))
    return lambda u: factor * at(closed, u.sqrt()) / (u * u.sqrt())


def near_samples(closed: sp.Expr, seam: float, count: int, wanted: Fraction) -> Samples:
    """(W - limit)/u on [0, seam], for the least relative error."""
    with ctx.workprec(GUARD):
        points = grid(arb(0), number(seam) ** 2, count)
        return sample(scaled(closed, wanted), lambda u, f: 1 / f, points).without(number(wanted))


@cache
def near_fit(closed: sp.Expr, seam: float, count: int, wanted: Fraction) -> tuple[float, ...]:
    """c1, c2, ... of W = limit + u (c1 + u (c2 + ...)): F/alpha**3, or its multiple with that limit at 0."""
    return rounded(near_samples(closed, seam, count, wanted), count - 1, careful=min(3, count - 1))


@cache
def logarithm_fit(degree: int) -> tuple[float, tuple[float, ...]]:
    """ln 2, and P(z) = (2 artanh(q)/q - 2)/z in z = q**2, for q <= 1/5."""
    with ctx.workprec(GUARD):
        points = grid(arb(0), number(Fraction(1, 25)), degree)
        samples = sample(lambda z: (2 * z.sqrt().atanh() / z.sqrt() - 2) / z, lambda z, _: z * z.sqrt(), points)
        return nearest(arb(2).log()), rounded(samples, degree, careful=1)


def cheap_samples(closed: sp.Expr, above: int, below: int) -> Samples:
    """F/alpha**3 in alpha**2, or for a rational in pi**2/4 - alpha**2."""
    function = scaled(closed, limit(closed))
    with ctx.workprec(GUARD):
        largest = (arb.pi() / 2) ** 2
        place: Function = (lambda w: largest - w) if below else (lambda u: u)
        points = grid(arb(0), largest, above + below, 2)
        return sample(lambda z: function(place(z)), lambda z, f: 1 / f, points)


@cache
def cheap_fit(closed: sp.Expr, above: int, below: int) -> tuple[tuple[float, ...], tuple[float, ...], float]:
    """Numerator and denominator of F/alpha**3, and their relative error before rounding."""
    over, under, error = minimax(cheap_samples(closed, above, below), above, below)
    return tuple(map(nearest, over)), tuple(map(nearest, under)), error


@dataclass(frozen=True)
class FarFit:
    """F = (slope alpha + line) + (constant + tilt b + b (slope - bend b) + b**power (R + b**(2 shift) Q ln(scale b))).

    The product with slope and bend is there where F is even in b. R and Q in b**2, of b = fl(pi/2) - alpha as it is
    computed: pi/2 - fl(pi/2) is folded in, the tilt among it.
    """

    constant: float
    tilt: float
    power: int
    shift: int
    r: tuple[float, ...]
    q: tuple[float, ...]


def powers(closed: sp.Expr, far: Far) -> tuple[int, int]:
    """The power of b in front of what the baseline leaves, and half the power of b in front of Q."""
    shape = end(closed)
    taken = shape.first == -Fraction(far.slope) if shape.odd else shape.first == -Fraction(far.bend)
    power = (1 if shape.odd else 2) + 2 * (taken and (not shape.log or shape.log >= (3 if shape.odd else 4)))
    return power, (shape.log - power) // 2 if shape.log else 0


def far_samples(closed: sp.Expr, far: Far, seam: float) -> tuple[Samples, float, float]:
    """What the baseline leaves over b**power as a function of b**2, for the least relative error; constant and tilt."""
    shape, (power, _) = end(closed), powers(closed, far)
    with ctx.workprec(GUARD):
        there = at(closed, number(HALF_PI))
        constant = nearest(there - number(far.slope) * number(HALF_PI) - number(far.line))
        constant = constant if abs(constant) > 2.0**-80 else 0.0
        tilt = 0.0
        if not shape.odd and shape.log != 2:  # where ln(b) starts at b**2 there is no second derivative
            tilt = -nearest(at(sp.diff(closed, alpha), number(HALF_PI)))
        straight = number(far.slope) * number(HALF_PI) + number(far.line) + number(constant)
        slope, bend = (far.slope, 0.0) if shape.odd else (0.0, -far.bend)
        known = [straight, number(tilt) - number(slope), number(bend)]

        def rest(w: arb) -> arb:
            b = w.sqrt()
            return (at(closed, number(HALF_PI) - b) - horner(known, b)) / b**power

        def weight(w: arb, left: arb) -> arb:
            b = w.sqrt()
            return b**power / (left * b**power + horner(known, b))

        points = grid(arb(0), number(HALF_PI - seam) ** 2, (2 if shape.log else 1) * far.degree + 2, 2)
        return sample(rest, weight, points), constant, tilt


def far_minimax(closed: sp.Expr, far: Far, samples: Samples) -> tuple[list[arb], list[arb], float, list[arb]]:
    """R and Q as they are fitted together, their error, and b**(2 shift) ln(scale b) at the points."""
    _, shift = powers(closed, far)
    if not end(closed).log:
        over, _, error = minimax(samples, far.degree)
        return over, [], error, []
    with ctx.workprec(GUARD):
        logs = [w**shift * (number(far.scale) * w.sqrt()).log() for w in samples.points]
    r, q, error = minimax(samples, far.degree, logs=(logs, max(far.degree - shift, 0)))
    return r, q, error, logs


@cache
def far_fit(closed: sp.Expr, far: Far, seam: float) -> FarFit:
    """The piece beyond the seam; with Q rounded, R is fitted again."""
    samples, constant, tilt = far_samples(closed, far, seam)
    _, found, _, logs = far_minimax(closed, far, samples)
    q = tuple(map(nearest, found))
    if q:
        with ctx.workprec(GUARD):
            terms = zip(samples.points, samples.values, logs, strict=True)
            left = [(f - horner([number(c) for c in q], w) * l).mid() for w, f, l in terms]
            samples = Samples(samples.points, left, samples.weights)
    power, shift = powers(closed, far)
    return FarFit(constant, tilt, power, shift, rounded(samples, far.degree, careful=1 if q else min(3, far.degree)), q)
