"""Shapes of the kernels' approximants, and their fits near 0, near pi/2, and on the whole domain.

Near 0, in u = alpha**2: F = alpha u W(u), W a polynomial whose constant term is the limit of F/alpha**3. Near pi/2, in
b = pi/2 - alpha, where artanh(sin(alpha)) = -ln(tan(b/2)): F is a function of b that is odd but for its value at 0, or
even, plus such a one times ln(b). A straight line that is computed without rounding is subtracted; the remainder is
b**power (R(b**2) + b**(2 shift) Q(b**2) ln(b)). Of a form that is neither (lambda), one polynomial serves for all.

Seams, baselines and degrees are stated in ``shapes.json`` by definition, for every weight that a moment may have and
for the declared quotients. They were chosen among many by the proved bound of the fused program and its number of
operations; whatever is stated there, the certificates prove what it achieves.
"""

import json
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from pathlib import Path

from flint import arb, arb_poly, ctx, fmpq, fmpq_series
from sympy import Expr, diff

from derive.algebra.integrate import closed_forms
from derive.approximate.minimax import GUARD, Function, Samples, evaluate, minimax, nearest, rounded, sample, value_at
from derive.check import truth
from derive.check.proof import ProofError
from derive.check.truth import as_ball
from derive.declare.quantities import MOMENTS, QUOTIENTS, RESISTANCE
from derive.declare.symbols import alpha
from derive.kinds import Coefficients, Names, Pair

HALF_PI = truth.TOP
SHAPES = Path(__file__).with_name("shapes.json")


@dataclass(frozen=True)
class Kernel:
    """Function of alpha: the derived closed form, or two for a quotient, and the definition in certificates."""

    name: str
    closed: tuple[Expr, ...]
    definition: Names


def kernels() -> list[Kernel]:
    """Return all certified functions: the base quantities and their quotients."""
    closed = closed_forms()
    definitions = {m.kernel[0]: m.definition for m in MOMENTS}
    definitions[RESISTANCE.name] = RESISTANCE.definition
    certified = []
    for name, definition in definitions.items():
        certified.append(Kernel(name, (closed[name],), definition))
    for q in QUOTIENTS:
        parts = (q.numerator, q.denominator)
        forms = tuple(closed[part] for part in parts)
        certified.append(Kernel(q.name, forms, tuple(definitions[part][0] for part in parts)))
    return certified


@cache
def at_zero(closed: Expr) -> list[fmpq]:
    """Return the exact Taylor coefficients of a closed form in alpha at 0, lowest first."""
    with truth.working(GUARD):
        series = evaluate(closed, fmpq_series([0, 1]))
        return [series[k] for k in range(truth.TERMS + 1)]


def limit(closed: Expr) -> Fraction:
    """Return the limit of F/alpha**3 at 0 of a closed form F."""
    first = at_zero(closed)[truth.CUBE]
    return Fraction(int(first.p), int(first.q))


def agree(kernel: Kernel) -> int:
    """Compare the derived form with the checker's definition, and return the number of comparisons.

    Taylor coefficients at 0 are compared exactly, values in balls.
    """
    for closed, statement in zip(kernel.closed, kernel.definition, strict=True):
        definition = f"the checker's definition {statement}"
        coefficients = zip(at_zero(closed), truth.taylor_at_zero(statement), strict=True)
        for k, (derived, defined) in enumerate(coefficients):
            if derived != defined:
                raise ProofError(f"{kernel.name}: coefficient of alpha^{k} in {definition}", derived, defined)
        for x in (0.25, 0.75, 1.25, HALF_PI):
            with truth.working(GUARD):
                value = arb(evaluate(closed, arb(x)))
                exact = truth.enclosure([statement], arb(x))
                if not abs(value / exact - 1) < arb(2) ** -200:
                    digits = (number.str(20, radius=False) for number in (value, exact))
                    raise ProofError(f"{kernel.name}: value at {x} by {definition}", *digits)
    return len(kernel.closed) * (truth.TERMS + 5)


@dataclass(frozen=True)
class Far:
    """Shape of the piece near pi/2: F = (slope alpha + line) + the terms of `FarFit`.

    The line is a multiple of 2**-52, as alpha >= 1 is, so that the sum makes no rounding error. An odd F has an odd
    ``power``. Where F is even in b, b (slope - bend b) is taken off next. ``degree`` is the degree of R, and ``shift``
    half the power of b**2 in front of Q, or None without logarithm, which is a logarithm of scale b.
    """

    slope: float
    line: float
    bend: float
    scale: float
    degree: int
    power: int
    shift: int | None

    @property
    def odd(self) -> bool:
        """Whether F is odd in b, except for its value at 0; otherwise it is even."""
        return self.power % 2 == 1


@dataclass(frozen=True)
class Pieces:
    """Shape of a base quantity in the best tier: the seam, coefficients near 0, and the shape beyond the seam."""

    seam: float
    count: int
    far: Far | None = None


@dataclass(frozen=True)
class Shape:
    """Pieces of a base quantity or of a quotient's two parts, and for each other tier the degrees above and below."""

    best: tuple[Pieces, ...]
    cheap: tuple[tuple[str, int, int], ...]


def stated_shape(kernel: Kernel) -> Shape:
    """Return the shape that is stated for the definition of a kernel."""
    definition = " / ".join(kernel.definition)
    stated = json.loads(SHAPES.read_text(encoding="utf-8"))
    if definition not in stated:
        raise ProofError(f"{kernel.name}: shape of {definition}", "none", f"a line in {SHAPES.name}")
    best = []
    for piece in stated[definition]["best"]:
        far = piece["far"]
        best.append(Pieces(piece["seam"], piece["count"], far and Far(**far)))
    return Shape(tuple(best), tuple(map(tuple, stated[definition]["cheap"])))


def scaled(closed: Expr, limit_at_0: Fraction) -> Function:
    """Return F/alpha**3 as a function of alpha**2, times a constant so that its limit at 0 is ``limit_at_0``."""
    factor = as_ball(limit_at_0 / limit(closed))

    def function(u: arb) -> arb:
        x = u.sqrt()
        return factor * value_at(closed, x) / (u * x)

    return function


@cache
def near_fit(closed: Expr, seam: float, count: int, limit_at_0: Fraction) -> Coefficients:
    """Return c1, c2, ..., ``count`` numbers, of W = limit + u (c1 + u (c2 + ...)), fitted to F/alpha**3 on [0, seam].

    W is F/alpha**3 times the constant that makes its limit at 0 ``limit_at_0``. The relative error is least.
    """
    with ctx.workprec(GUARD):
        upper = as_ball(seam) ** 2
        samples = sample(scaled(closed, limit_at_0), lambda u, f: 1 / f, upper, count)
        rest = samples.without(as_ball(limit_at_0))
    return rounded(rest, count - 1, careful=min(3, count - 1))


@cache
def logarithm_fit() -> tuple[float, Coefficients]:
    """Return ln 2, and P(z) = (2 artanh(q)/q - 2)/z in z = q**2, q <= 1/5, by its coefficients, lowest first."""

    def rest(z: arb) -> arb:
        q = z.sqrt()
        return (2 * q.atanh() / q - 2) / z

    degree = 6
    with ctx.workprec(GUARD):
        largest = as_ball(Fraction(1, 25))
        samples = sample(rest, lambda z, _: z * z.sqrt(), largest, degree)
        return nearest(arb(2).log()), rounded(samples, degree, careful=1)


@cache
def cheap_fit(closed: Expr, above: int, below: int) -> tuple[Coefficients, Coefficients]:
    """Return numerator and denominator of F/alpha**3, of degrees ``above`` and ``below``, for the least relative error.

    Without denominator it is a polynomial in alpha**2, otherwise a rational in pi**2/4 - alpha**2. Coefficients are
    listed lowest first.
    """
    function = scaled(closed, limit(closed))
    with ctx.workprec(GUARD):
        largest = (arb.pi() / 2) ** 2
        reflected = (lambda z: function(largest - z)) if below else function
        samples = sample(reflected, lambda z, f: 1 / f, largest, above + below, 2)
    over, under = minimax(samples, above, below)
    return tuple(map(nearest, over)), tuple(map(nearest, under))


@cache
def rounding_fit(closed: Expr, above: int, below: int) -> tuple[Coefficients, Coefficients]:
    """Return numerator and denominator of (W - W(0))/u, for the least relative error of F = alpha u W.

    Their degrees are ``above`` and ``below``. Without denominator it is a polynomial in u = alpha**2, otherwise a
    rational in fl(pi/2)**2 - u, of a multiple of F with W(0) = 1. Coefficients are listed lowest first.
    """
    limit_at_0 = Fraction(1) if below else limit(closed)
    function = scaled(closed, limit_at_0)
    with ctx.workprec(GUARD):
        largest = as_ball(HALF_PI) ** 2
        first = as_ball(limit_at_0)

        def square(z: arb) -> arb:
            return largest - z if below else z

        def rest(z: arb) -> arb:
            u = square(z)
            return (function(u) - first) / u

        def weight(z: arb, value: arb) -> arb:
            u = square(z)
            return u / (first + u * value)

        samples = sample(rest, weight, largest, above + below, 2)
    over, under = minimax(samples, above, below, rounds=40)
    return tuple(map(nearest, over)), tuple(map(nearest, under))


@dataclass(frozen=True)
class FarFit:
    """F = (slope alpha + line) + (constant + tilt b + b (slope - bend b) + b**power (R + b**(2 shift) Q ln(scale b))).

    The product with slope and bend is there where F is even in b. R and Q in b**2, of b = fl(pi/2) - alpha as it is
    computed: pi/2 - fl(pi/2) is folded in, the tilt among it.
    """

    constant: float
    tilt: float
    r: Coefficients
    q: Coefficients


@cache
def far_fit(closed: Expr, far: Far, seam: float) -> FarFit:
    """Return the piece beyond the seam, with R and Q fitted together, and R again after rounding Q."""
    degree = far.degree
    constant, tilt = _constant_and_tilt(closed, far)
    samples = _far_samples(closed, far, constant, tilt, seam)
    if far.shift is None:
        return FarFit(constant, tilt, rounded(samples, degree, careful=min(3, degree)), ())
    with ctx.workprec(GUARD):
        scale = as_ball(far.scale)
        logs = [w**far.shift * (scale * w.sqrt()).log() for w in samples.points]
    _, coefficients = minimax(samples, degree, logs=(logs, max(degree - far.shift, 0)))
    q = tuple(map(nearest, coefficients))
    values = []
    with ctx.workprec(GUARD):
        subtracted = arb_poly([as_ball(c) for c in q])
        for w, value, log in zip(samples.points, samples.values, logs, strict=True):
            values.append((value - subtracted(w) * log).mid())
    without_logs = Samples(samples.points, values, samples.weights)
    return FarFit(constant, tilt, rounded(without_logs, degree, careful=1), q)


def _constant_and_tilt(closed: Expr, far: Far) -> Pair:
    """Return the excess of F over the baseline at fl(pi/2), and its slope by b if F is even in b."""
    with ctx.workprec(GUARD):
        at_end = as_ball(HALF_PI)
        excess = value_at(closed, at_end) - as_ball(far.slope) * at_end - as_ball(far.line)
        constant = nearest(excess)
        if abs(constant) <= 2.0**-80:
            constant = 0.0
        tilt = 0.0
        if not far.odd and far.shift != 0:  # where ln(b) starts at b**2 there is no second derivative
            tilt = -nearest(value_at(diff(closed, alpha), at_end))
    return constant, tilt


def _far_samples(closed: Expr, far: Far, constant: float, tilt: float, seam: float) -> Samples:
    """Return samples for R and Q, (F - the rest of `FarFit`)/b**power at w = b**2, for the least relative error."""
    power = far.power
    unknowns = (1 if far.shift is None else 2) * far.degree + 2
    with ctx.workprec(GUARD):
        at_end = as_ball(HALF_PI)
        straight = as_ball(far.slope) * at_end + as_ball(far.line) + as_ball(constant)
        if far.odd:
            known = arb_poly([straight, as_ball(tilt) - as_ball(far.slope)])
        else:
            known = arb_poly([straight, as_ball(tilt), -as_ball(far.bend)])

        def rest(w: arb) -> arb:
            b = w.sqrt()
            return (value_at(closed, at_end - b) - known(b)) / b**power

        def weight(w: arb, left: arb) -> arb:
            b = w.sqrt()
            return b**power / (left * b**power + known(b))

        return sample(rest, weight, as_ball(HALF_PI - seam) ** 2, unknowns, 2)
