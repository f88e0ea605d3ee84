"""Best approximation: weighted minimax polynomials and rationals of what SymPy derived, in flint's arithmetic.

Everything runs in balls whose radii are dropped (`mid`), so the result is a function of the definition alone, the same
on every machine; only then are coefficients rounded to doubles. Nothing here proves anything: the proof is another
program's, of the rounded coefficients.
"""

import math
import operator
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import reduce
from itertools import accumulate
from typing import Any

from flint import arb, arb_mat, ctx, fmpq
from sympy import Add, Expr, Mul, Pow, Rational, Symbol, pi

from derive.check.truth import fraction, number

BITS = 240  # of the fit; the functions themselves are evaluated with more
GUARD = 400
_POINTS = 16  # of the grid for each unknown coefficient
_ROUNDS = 12  # exchanges of reference points at most

Function = Callable[[arb], arb]


def nearest(x: arb) -> float:
    """The double nearest to it."""
    return float(fraction(x.mid()))


def evaluate(expression: Expr, x: Any) -> Any:
    """An expression in one symbol at x, which is a ball or a power series: whatever adds, multiplies and has a sine."""
    if isinstance(expression, Symbol):
        return x
    if isinstance(expression, Rational):
        return fmpq(int(expression.p), int(expression.q))
    if expression is pi:
        return arb.pi()
    parts = [evaluate(part, x) for part in expression.args]
    if isinstance(expression, (Add, Mul)):
        return reduce(operator.add if expression.is_Add else operator.mul, parts)
    if isinstance(expression, Pow):
        return parts[0] ** int(expression.exp)
    return getattr(parts[0], type(expression).__name__)()  # sin, cos, atanh


def value(closed: Expr, a: arb) -> arb:
    """A closed form at alpha, with bits to spare for what cancels."""
    with ctx.workprec(GUARD):
        return arb(evaluate(closed, a)).mid()


def horner(coefficients: Sequence[arb], x: arb) -> arb:
    """The polynomial with these coefficients, lowest first, at x."""
    return reduce(lambda total, c: total * x + c, reversed(coefficients), arb(0))


@dataclass
class Samples:
    """A function and the weight of its error on a grid; ``error = weight (approximant - function)``."""

    points: list[arb]
    values: list[arb]
    weights: list[arb]

    def without(self, coefficient: arb) -> "Samples":
        """(function - coefficient)/point: what is left to fit once the lowest coefficient is fixed."""
        values = [((f - coefficient) / x).mid() for x, f in zip(self.points, self.values, strict=True)]
        weights = [(w * x).mid() for x, w in zip(self.points, self.weights, strict=True)]
        return Samples(self.points, values, weights)


def sample(
    function: Function, weight: Callable[[arb, arb], arb], upper: arb, unknowns: int, cluster: int = 1
) -> Samples:
    """A function on Chebyshev points of [0, upper], and the weight of its error at a point and a value.

    With ``cluster`` > 1 the points are crowded further towards 0, where a logarithm is singular.
    """
    count = _POINTS * (unknowns + 1)
    with ctx.workprec(BITS):
        chebyshev = [(1 - (arb(2 * k + 1) / (2 * count)).cos_pi()) / 2 for k in range(count)]
        points = [(upper * x**cluster).mid() for x in chebyshev]
    with ctx.workprec(GUARD):
        values = [function(x).mid() for x in points]
        weights = [weight(x, f).mid() for x, f in zip(points, values, strict=True)]
    return Samples(points, values, weights)


def minimax(
    samples: Samples, above: int, below: int = 0, logs: tuple[Sequence[arb], int] | None = None
) -> tuple[list[arb], list[arb], float]:
    """The numerator of degree `above`, the denominator 1 + ... of degree `below`, and their least largest error.

    With ``logs = (l, degree)`` a polynomial of that degree times l, a number for each point, is added, and returned
    in the denominator's place. Exchange of reference points after Remez: at the references the errors of the levelled
    approximant are equal in size and alternate in sign.
    """
    with ctx.workprec(BITS):
        basis = _basis(samples, above, below, logs)
        matrix = arb_mat(basis)
        count = len(basis)
        unknowns = len(basis[0]) + 1  # the coefficients and the level
        references = [min(count - 1, (2 * k + 1) * count // (2 * unknowns)) for k in range(unknowns)]
        denominators = [arb(1)] * count
        least = math.inf
        best: list[arb] = []
        for _ in range(_ROUNDS):
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
        return best[: above + 1], second if logs else [arb(1), *second], least


def _basis(samples: Samples, above: int, below: int, logs: tuple[Sequence[arb], int] | None) -> list[list[arb]]:
    """What the coefficients multiply at each point: 1, x, x**2, ..., then -f x, -f x**2, ... or l, l x, ..."""
    if logs:
        factors, last = logs
        first = 0
    else:
        factors = [-f for f in samples.values]
        first, last = 1, below
    rows = []
    for x, factor in zip(samples.points, factors, strict=True):
        powers = [*accumulate([x] * max(above, last), operator.mul, initial=arb(1))]
        rows.append([*powers[: above + 1], *(factor * power for power in powers[first : last + 1])])
    return rows


def _levelled(
    samples: Samples, basis: list[list[arb]], references: list[int], denominators: list[arb], above: int, below: int
) -> tuple[list[arb], arb, list[arb]]:
    """Coefficients whose weighted errors at the references are equal and alternate, this error, and the denominators.

    A rational is levelled with the last denominator in the error's place, which makes the system linear, and again.
    """
    values = arb_mat([[samples.values[i]] for i in references])
    for _ in range(6 if below else 1):
        rows = []
        for k, i in enumerate(references):
            level = (denominators[i] / samples.weights[i]).mid()
            rows.append([*basis[i], (-1) ** k * level])
        *coefficients, level = (x.mid() for x in arb_mat(rows).solve(values, algorithm="approx").entries())
        if below:
            denominator = [arb(1), *coefficients[above + 1 :]]
            denominators = [horner(denominator, x).mid() for x in samples.points]
    return coefficients, level, denominators


def _errors(samples: Samples, numerators: list[arb], denominators: list[arb]) -> list[arb]:
    """Weighted errors at all points; of a rational, of the linear system divided by its denominator."""
    terms = zip(numerators, samples.values, samples.weights, denominators, strict=True)
    return [(weight * (p - f) / q).mid() for p, f, weight, q in terms]


def _exchange(errors: list[arb], references: list[int]) -> list[int]:
    """The largest error of every run of one sign; of too many, those at the ends go, smaller first."""
    largest: list[int] = []
    for i, error in enumerate(errors):
        if not largest or (error > 0) != (errors[largest[-1]] > 0):
            largest.append(i)
        elif abs(error) > abs(errors[largest[-1]]):
            largest[-1] = i
    while len(largest) > len(references):
        first_is_smaller = abs(errors[largest[0]]) < abs(errors[largest[-1]])
        largest.pop(0 if first_is_smaller else -1)
    return largest if len(largest) == len(references) else references


def rounded(samples: Samples, degree: int, careful: int) -> tuple[tuple[float, ...], float]:
    """Minimax coefficients as doubles, lowest first, and the error before they are rounded.

    Each of the first `careful` ones is rounded and the others fitted again; the rest are rounded together.
    """
    fitted, _, error = minimax(samples, degree)
    fixed: list[float] = []
    for k in range(careful):
        fixed.append(nearest(fitted[0]))
        with ctx.workprec(BITS):
            samples = samples.without(number(fixed[-1]))
        fitted, _, _ = minimax(samples, degree - k - 1)
    return (*fixed, *map(nearest, fitted)), error
