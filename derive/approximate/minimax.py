"""Best approximation: weighted minimax polynomials and rational functions of derived forms, in ball arithmetic.

Everything runs in balls whose radii are dropped (`mid`), so the result is a function of the definition alone, the same
on every machine; only then are coefficients rounded to doubles. Nothing here proves anything: the proof is another
program's, of the rounded coefficients.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from flint import arb, arb_mat, arb_poly, ctx, fmpq
from sympy import Expr, pi

from derive.check.truth import Balls, as_ball, fraction
from derive.kinds import Coefficients

BITS = 240  # of the fit; the functions themselves are evaluated with more
GUARD = 400
_POINTS = 16  # of the grid for each unknown coefficient
_ROUNDS = 12  # most exchanges of reference points

Function = Callable[[arb], arb]


def nearest(x: arb) -> float:
    """Return the double nearest to the middle of a ball."""
    return float(fraction(x.mid()))


def evaluate(expression: Expr, x: Any) -> Any:
    """Return an expression in one symbol at x, a ball, a power series, or any type with addition, product and sine."""
    if expression.is_Symbol:
        return x
    if expression.is_Rational:
        return fmpq(int(expression.p), int(expression.q))
    if expression is pi:
        return arb.pi()
    first, *others = (evaluate(part, x) for part in expression.args)
    if expression.is_Add:
        return sum(others, first)
    if expression.is_Mul:
        return math.prod(others, start=first)
    if expression.is_Pow:
        return first ** int(expression.exp)
    return getattr(first, type(expression).__name__)()  # sin, cos, atanh


def value_at(closed: Expr, a: arb) -> arb:
    """Return a closed form at alpha, the ball ``a`` in rad, with additional bits for cancellation."""
    with ctx.workprec(GUARD):
        return arb(evaluate(closed, a)).mid()


@dataclass
class Samples:
    """Function and weight of its error on a grid, with ``error = weight (approximant - function)``."""

    points: Balls
    values: Balls
    weights: Balls

    def without(self, coefficient: arb) -> "Samples":
        """Return (function - coefficient)/point, the function to fit once the lowest coefficient is fixed."""
        values = []
        weights = []
        for x, value, weight in zip(self.points, self.values, self.weights, strict=True):
            values.append(((value - coefficient) / x).mid())
            weights.append((weight * x).mid())
        return Samples(self.points, values, weights)


def sample(
    function: Function, weight: Callable[[arb, arb], arb], upper: arb, unknowns: int, cluster: int = 1
) -> Samples:
    """Return samples of a function on Chebyshev points of [0, upper], with the weight of its error.

    ``weight`` is a function of the point and of the value there. ``unknowns`` is the number of coefficients to fit, to
    which the number of points is proportional.

    With ``cluster`` > 1 the points are crowded further towards 0, where a logarithm is singular.
    """
    count = _POINTS * (unknowns + 1)
    points = []
    with ctx.workprec(BITS):
        for k in range(count):
            angle = arb(2 * k + 1) / (2 * count)
            chebyshev = (1 - angle.cos_pi()) / 2
            points.append((upper * chebyshev**cluster).mid())
    values = []
    weights = []
    with ctx.workprec(GUARD):
        for x in points:
            value = function(x).mid()
            values.append(value)
            weights.append(weight(x, value).mid())
    return Samples(points, values, weights)


def minimax(
    samples: Samples, above: int, below: int = 0, logs: tuple[Sequence[arb], int] | None = None, rounds: int = _ROUNDS
) -> tuple[Balls, Balls]:
    """Return the numerator of degree `above` and the denominator 1 + ... of degree `below` of the least maximal error.

    With ``logs = (l, degree)`` a polynomial of that degree times l, a number for each point, is added, and returned
    in the denominator's place. Exchange of reference points after Remez: at the references the errors of the levelled
    approximant are equal in size and alternate in sign.
    """
    with ctx.workprec(BITS):
        basis = _basis(samples, above, below, logs)
        matrix = arb_mat(basis)
        count = len(basis)
        unknowns = len(basis[0]) + 1  # the coefficients and the level
        evenly = ((2 * k + 1) * count // (2 * unknowns) for k in range(unknowns))
        references = [min(count - 1, i) for i in evenly]
        denominators = [arb(1)] * count
        least = math.inf
        best: Balls = []
        for _ in range(rounds):
            coefficients, level, denominators = _levelled(samples, basis, references, denominators, above, below)
            numerators = (matrix * arb_mat([[c] for c in coefficients])).entries()
            errors = _errors(samples, numerators, denominators)
            worst = max(abs(float(e)) for e in errors)
            if worst < least:
                least = worst
                best = coefficients
            if worst <= 1.02 * abs(float(level)):
                break
            references = _exchange(errors, references)
        second = best[above + 1 :]
        return best[: above + 1], second if logs else [arb(1), *second]


def _basis(samples: Samples, above: int, below: int, logs: tuple[Sequence[arb], int] | None) -> list[Balls]:
    """Return the basis functions at each point: 1, x, x**2, ..., followed by -f x, -f x**2, ... or l, l x, ...

    The degrees ``above`` and ``below`` and the factors ``logs`` are those of `minimax`.
    """
    if logs:
        factors, last = logs
        first = 0
    else:
        factors = [-f for f in samples.values]
        first = 1
        last = below
    rows = []
    for x, factor in zip(samples.points, factors, strict=True):
        powers = [arb(1)]
        for _ in range(max(above, last)):
            powers.append(powers[-1] * x)
        rows.append(powers[: above + 1] + [factor * power for power in powers[first : last + 1]])
    return rows


def _levelled(
    samples: Samples, basis: list[Balls], references: list[int], denominators: Balls, above: int, below: int
) -> tuple[Balls, arb, Balls]:
    """Return coefficients whose weighted errors alternate with equal size at the references, with the error.

    The third result are the denominators at all points. ``references`` are indices of points, and ``denominators``
    those of the last call.

    A rational is levelled with the last denominator in the error's place, which makes the system linear, and again.
    """
    values = arb_mat([[samples.values[i]] for i in references])
    there = [denominators[i] for i in references]
    for _ in range(6 if below else 1):
        rows = []
        sign = 1
        for i, denominator in zip(references, there, strict=True):
            level = (denominator / samples.weights[i]).mid()
            rows.append([*basis[i], sign * level])
            sign = -sign
        solution = arb_mat(rows).solve(values, algorithm="approx")
        *coefficients, level = (x.mid() for x in solution.entries())
        if below:
            denominator_of = arb_poly([arb(1), *coefficients[above + 1 :]])
            there = [denominator_of(samples.points[i]).mid() for i in references]
    if below:
        denominators = [denominator_of(x).mid() for x in samples.points]
    return coefficients, level, denominators


def _errors(samples: Samples, numerators: Balls, denominators: Balls) -> Balls:
    """Return the weighted errors of the approximant at all points.

    For a rational function p/q, ``numerators`` are the values of p - f (q - 1), from the linear system, and
    ``denominators`` the values of q.
    """
    terms = zip(numerators, samples.values, samples.weights, denominators, strict=True)
    return [(weight * (p - f) / q).mid() for p, f, weight, q in terms]


def _exchange(errors: Balls, references: list[int]) -> list[int]:
    """Return the index of the largest error of every run of one sign, or the present references if runs are missing.

    Surplus runs at the ends are omitted, the smaller first. ``errors`` are those at all points.
    """
    largest = [0]
    for i, error in enumerate(errors):
        last = errors[largest[-1]]
        if (error > 0) != (last > 0):
            largest.append(i)
        elif abs(error) > abs(last):
            largest[-1] = i
    while len(largest) > len(references):
        first = abs(errors[largest[0]])
        last = abs(errors[largest[-1]])
        largest.pop(0 if first < last else -1)
    return largest if len(largest) == len(references) else references


def rounded(samples: Samples, degree: int, careful: int) -> Coefficients:
    """Return minimax coefficients of this degree as doubles, lowest first.

    Each of the first `careful` ones is rounded and the others fitted again; the rest are rounded together.
    """
    fitted, _ = minimax(samples, degree)
    fixed: list[float] = []
    for k in range(careful):
        fixed.append(nearest(fitted[0]))
        with ctx.workprec(BITS):
            samples = samples.without(as_ball(fixed[-1]))
        fitted, _ = minimax(samples, degree - k - 1)
    return (*fixed, *map(nearest, fitted))
