"""Best approximation: weighted minimax polynomials and rationals of given functions, in flint's arithmetic.

Everything runs in balls whose radii are dropped (`mid`), so the result is a function of the definition alone, the same
on every machine; only then are coefficients rounded to doubles. Nothing here proves anything: the proof is another
program's, of the rounded coefficients.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction

from flint import arb, arb_mat, ctx, fmpq

BITS = 240  # of the fit; the functions themselves are evaluated with more
_GUARD = 400
_POINTS = 16  # of the grid for each unknown coefficient
_ROUNDS = 12

Function = Callable[[arb], arb]


def exact(x: float | Fraction) -> arb:
    """The number itself."""
    ratio = Fraction(x)
    return arb(fmpq(ratio.numerator, ratio.denominator))


def nearest(x: arb) -> float:
    """The double nearest to it."""
    man, exp = x.mid().man_exp()
    return float(Fraction(int(man)) * Fraction(2) ** int(exp))


# --- the functions -------------------------------------------------------------------------------------------------

REDUCED: dict[str, Function] = {
    # Closed forms of (2.17), (3.12), (2.23), (3.13), (3.14), as derived in derive.integrate, over alpha**3.
    "polar_moment": lambda a: (2 * a - a.sin() * a.cos() - a.cos() ** 3 * a.sin().atanh()) / 3,
    "moment_of_inertia": lambda a: a / 2 - (2 * a).sin() / 6 - (4 * a).sin() / 24,
    "radial_weight_amplitude": lambda a: a.sin() - a.cos() ** 2 * a.sin().atanh(),
    "weight_moment_amplitude": lambda a: 2 * a.sin() ** 3 / 3,
    "resistance_factor": lambda a: 2 * a * (1 - a.cos()),
}


def value(name: str, a: arb) -> arb:
    """A base quantity at alpha, by its closed form with bits to spare for what cancels."""
    with ctx.workprec(_GUARD):
        return REDUCED[name](a).mid()


# --- minimax -------------------------------------------------------------------------------------------------------


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


def grid(lower: arb, upper: arb, unknowns: int, cluster: int = 1) -> list[arb]:
    """Chebyshev points, at `cluster` > 1 crowded further towards the lower end, where a logarithm ends."""
    count = _POINTS * (unknowns + 1)
    with ctx.workprec(BITS):
        middle = [(1 - (arb(2 * k + 1) / (2 * count)).cos_pi()) / 2 for k in range(count)]
        return [(lower + (upper - lower) * x**cluster).mid() for x in middle]


def sample(function: Function, weight: Function, points: Sequence[arb]) -> Samples:
    """A function and a weight on a grid."""
    with ctx.workprec(_GUARD):
        return Samples(list(points), [function(x).mid() for x in points], [weight(x).mid() for x in points])


def horner(coefficients: Sequence[arb], x: arb) -> arb:
    """The polynomial at x."""
    total = arb(0)
    for c in reversed(coefficients):
        total = total * x + c
    return total


def minimax(
    samples: Samples, above: int, below: int = 0, logs: tuple[Sequence[arb], int] | None = None
) -> tuple[list[arb], list[arb], float]:
    """The numerator of degree `above` and the denominator 1 + ... of degree `below` with the least largest error.

    With ``logs = (l, degree)`` a polynomial of that degree times l, a number for each point, is added, and returned
    in the denominator's place. Exchange of reference points after Remez. For a rational the levelled system is solved
    with the last denominator in the error's place, which makes it linear.

    Returns
    -------
    numerator, denominator : list of arb
    error : float
        The largest on the grid, in the weight's measure.
    """
    with ctx.workprec(BITS):
        most = max(above, below, logs[1] if logs else 0)
        powers = [[arb(1)] for _ in samples.points]
        for row, x in zip(powers, samples.points, strict=True):
            while len(row) <= most:
                row.append((row[-1] * x).mid())
        basis = [row[: above + 1] for row in powers]
        if logs:
            basis = [row + [(l * p).mid() for p in row[: logs[1] + 1]] for row, l in zip(basis, logs[0], strict=True)]
        elif below:
            basis = [row + [(-f * p).mid() for p in all_[1 : below + 1]]
                     for row, f, all_ in zip(basis, samples.values, powers, strict=True)]  # fmt: skip
        count, unknowns = len(samples.points), len(basis[0]) + 1
        chosen = [min(count - 1, (2 * k + 1) * count // (2 * unknowns)) for k in range(unknowns)]
        under = [arb(1)] * count
        best: tuple[float, list[arb]] | None = None
        for _ in range(_ROUNDS):
            for _ in range(6 if below else 1):
                found, level = _levelled(samples, chosen, basis, under)
                if below:
                    under = [horner([arb(1), *found[above + 1 :]], x).mid() for x in samples.points]
            errors = [
                (w * (sum((c * p for c, p in zip(found, row, strict=True)), arb(0)) - f) / u).mid()
                for row, f, w, u in zip(basis, samples.values, samples.weights, under, strict=True)
            ]
            worst = max(abs(float(e)) for e in errors)
            if best is None or worst < best[0]:
                best = (worst, found)
            if worst <= 1.02 * abs(float(level)):
                break
            chosen = _exchange(errors, unknowns, chosen)
        assert best is not None
        worst, found = best
        second = found[above + 1 :]
        return found[: above + 1], second if logs else [arb(1), *second], worst


def _levelled(
    samples: Samples, chosen: Sequence[int], basis: Sequence[Sequence[arb]], under: Sequence[arb]
) -> tuple[list[arb], arb]:
    """The approximant whose errors at the chosen points are equal and alternate."""
    rows = [[*basis[i], (-1) ** sign * (under[i] / samples.weights[i]).mid()] for sign, i in enumerate(chosen)]
    right = arb_mat([[samples.values[i]] for i in chosen])
    solved = arb_mat(rows).solve(right, algorithm="approx")
    found = [solved[k, 0].mid() for k in range(len(rows))]
    return found[:-1], found[-1]


def _exchange(errors: list[arb], wanted: int, chosen: list[int]) -> list[int]:
    """The largest error of every run of one sign; of too many, those at the ends go, smaller first."""
    runs: list[int] = []
    for i, e in enumerate(errors):
        if runs and (e > 0) == (errors[runs[-1]] > 0):
            if abs(e) > abs(errors[runs[-1]]):
                runs[-1] = i
        else:
            runs.append(i)
    while len(runs) > wanted:
        runs.pop(0 if abs(errors[runs[0]]) < abs(errors[runs[-1]]) else -1)
    return runs if len(runs) == wanted else chosen


def rounded(samples: Samples, degree: int, careful: int | None = None) -> tuple[list[float], float]:
    """Minimax coefficients as doubles: round the lowest, fit the others again, and so on.

    Returns
    -------
    coefficients : list of float
        Lowest first; the last ones, after `careful` rounds, are rounded together.
    error : float
        Of the last fit, before that last rounding.
    """
    found: list[float] = []
    error = 0.0
    rest = samples
    for k in range(degree + 1):
        last = careful is not None and k >= careful
        coefficients, _, error = minimax(rest, degree - k)
        if last:
            return found + [nearest(c) for c in coefficients], error
        found.append(nearest(coefficients[0]))
        with ctx.workprec(BITS):
            rest = rest.without(exact(found[-1]))
    return found, error
