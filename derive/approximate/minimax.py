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

import sympy as sp
from flint import arb, arb_mat, ctx, fmpq

from derive.check.truth import fraction, number

BITS = 240  # of the fit; the functions themselves are evaluated with more
GUARD = 400
_POINTS = 16  # of the grid for each unknown coefficient
_ROUNDS = 12

Function = Callable[[arb], arb]


def nearest(x: arb) -> float:
    """The double nearest to it."""
    return float(fraction(x.mid()))


def evaluate(expression: sp.Expr, x: Any) -> Any:
    """An expression in one symbol at x, which is a ball or a power series: whatever adds, multiplies and has a sine."""
    if isinstance(expression, sp.Symbol):
        return x
    if isinstance(expression, sp.Rational):
        return fmpq(int(expression.p), int(expression.q))
    if expression is sp.pi:
        return arb.pi()
    parts = [evaluate(part, x) for part in expression.args]
    if isinstance(expression, (sp.Add, sp.Mul)):
        return reduce(operator.add if expression.is_Add else operator.mul, parts)
    if isinstance(expression, sp.Pow):
        return parts[0] ** int(expression.exp)
    return getattr(parts[0], type(expression).__name__)()  # sin, cos, atanh


def value(closed: sp.Expr, a: arb) -> arb:
    """A closed form at alpha, with bits to spare for what cancels."""
    with ctx.workprec(GUARD):
        return arb(evaluate(closed, a)).mid()


def horner(coefficients: Sequence[arb], x: arb) -> arb:
    return reduce(lambda total, c: total * x + c, reversed(coefficients), arb(0))


@dataclass
class Samples:
    """A function and the weight of its error on a grid; ``error = weight (approximant - function)``."""

    points: list[arb]
    values: list[arb]
    weights: list[arb]

    def without(self, coefficient: arb) -> "Samples":
        """(function - coefficient)/point: what is left to fit once the lowest coefficient stands."""
        pairs = zip(self.points, self.values, strict=True)
        values = [((f - coefficient) / x).mid() for x, f in pairs]
        return Samples(self.points, values, [(w * x).mid() for x, w in zip(self.points, self.weights, strict=True)])


def sample(
    function: Function, weight: Callable[[arb, arb], arb], upper: arb, unknowns: int, cluster: int = 1
) -> Samples:
    """A function on Chebyshev points of [0, upper], and the weight of its error at a point and a value.

    At `cluster` > 1 they are crowded further towards 0, where a logarithm ends.
    """
    count = _POINTS * (unknowns + 1)
    with ctx.workprec(BITS):
        middle = [(1 - (arb(2 * k + 1) / (2 * count)).cos_pi()) / 2 for k in range(count)]
        points = [(upper * x**cluster).mid() for x in middle]
    with ctx.workprec(GUARD):
        values = [function(x).mid() for x in points]
        return Samples(points, values, [weight(x, f).mid() for x, f in zip(points, values, strict=True)])


def minimax(
    samples: Samples, above: int, below: int = 0, logs: tuple[Sequence[arb], int] | None = None
) -> tuple[list[arb], list[arb], float]:
    """The numerator of degree `above`, the denominator 1 + ... of degree `below`, and their least largest error.

    With ``logs = (l, degree)`` a polynomial of that degree times l, a number for each point, is added, and returned
    in the denominator's place. Exchange of reference points after Remez. For a rational the levelled system is solved
    with the last denominator in the error's place, which makes it linear.
    """
    with ctx.workprec(BITS):
        start, last, times = (0, logs[1], logs[0]) if logs else (1, below, [-f for f in samples.values])
        powers = [[*accumulate([x] * max(above, last), operator.mul, initial=arb(1))] for x in samples.points]
        basis = [
            [*row[: above + 1], *(t * p for p in row[start : last + 1])] for row, t in zip(powers, times, strict=True)
        ]
        count, unknowns, matrix = len(samples.points), len(basis[0]) + 1, arb_mat(basis)
        chosen = [min(count - 1, (2 * k + 1) * count // (2 * unknowns)) for k in range(unknowns)]
        under = [arb(1)] * count
        best: tuple[float, list[arb]] = math.inf, []
        for _ in range(_ROUNDS):
            for _ in range(6 if below else 1):
                # The approximant whose errors at the chosen points are equal and alternate.
                rows = [[*basis[i], (-1) ** k * (under[i] / samples.weights[i]).mid()] for k, i in enumerate(chosen)]
                right = arb_mat([[samples.values[i]] for i in chosen])
                *found, level = (x.mid() for x in arb_mat(rows).solve(right, algorithm="approx").entries())
                if below:
                    under = [horner([arb(1), *found[above + 1 :]], x).mid() for x in samples.points]
            fitted = (matrix * arb_mat([[c] for c in found])).entries()
            errors = [
                (w * (p - f) / u).mid()
                for p, f, w, u in zip(fitted, samples.values, samples.weights, under, strict=True)
            ]
            worst = max(abs(float(e)) for e in errors)
            best = min(best, (worst, found), key=operator.itemgetter(0))
            if worst <= 1.02 * abs(float(level)):
                break
            chosen = _exchange(errors, chosen)
        worst, found = best
        second = found[above + 1 :]
        return found[: above + 1], second if logs else [arb(1), *second], worst


def _exchange(errors: list[arb], chosen: list[int]) -> list[int]:
    """The largest error of every run of one sign; of too many, those at the ends go, smaller first."""
    runs: list[int] = []
    for i, e in enumerate(errors):
        if not runs or (e > 0) != (errors[runs[-1]] > 0):
            runs.append(i)
        elif abs(e) > abs(errors[runs[-1]]):
            runs[-1] = i
    while len(runs) > len(chosen):
        runs.pop(0 if abs(errors[runs[0]]) < abs(errors[runs[-1]]) else -1)
    return runs if len(runs) == len(chosen) else chosen


def rounded(samples: Samples, degree: int, careful: int) -> tuple[tuple[float, ...], float]:
    """Minimax coefficients as doubles, lowest first, and the error before they are rounded.

    Each of the first `careful` ones is rounded and the others fitted again; the rest are rounded together.
    """
    fitted, _, error = minimax(samples, degree)
    found: list[float] = []
    for k in range(careful):
        found.append(nearest(fitted[0]))
        with ctx.workprec(BITS):
            samples = samples.without(number(found[-1]))
        fitted, _, _ = minimax(samples, degree - k - 1)
    return (*found, *map(nearest, fitted)), error
