"""Best approximation: weighted minimax polynomials and rationals, in flint's arithmetic, and those the kernels need.

Everything runs in balls whose radii are dropped (`mid`), so the result is a function of the definition alone, the same
on every machine; only then are coefficients rounded to doubles. Nothing here proves anything: the proof is another
program's, of the rounded coefficients.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache

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

CLOSED: dict[str, Function] = {  # of (2.17), (3.12), (2.23), (3.13), (3.14), as derive.algebra.integrate finds them
    "polar_moment": lambda a: (2 * a - a.sin() * a.cos() - a.cos() ** 3 * a.sin().atanh()) / 3,
    "moment_of_inertia": lambda a: a / 2 - (2 * a).sin() / 6 - (4 * a).sin() / 24,
    "radial_weight_amplitude": lambda a: a.sin() - a.cos() ** 2 * a.sin().atanh(),
    "weight_moment_amplitude": lambda a: 2 * a.sin() ** 3 / 3,
    "resistance_factor": lambda a: 2 * a * (1 - a.cos()),
}


def value(name: str, a: arb) -> arb:
    """A base quantity at alpha, by its closed form with bits to spare for what cancels."""
    with ctx.workprec(_GUARD):
        return CLOSED[name](a).mid()


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


def rounded(samples: Samples, degree: int, careful: int) -> tuple[float, ...]:
    """Minimax coefficients as doubles, lowest first.

    Each of the first `careful` ones is rounded and the others fitted again; the rest are rounded together.
    """
    found: list[float] = []
    for k in range(careful):
        found.append(nearest(minimax(samples, degree - k)[0][0]))
        with ctx.workprec(BITS):
            samples = samples.without(exact(found[-1]))
    return (*found, *map(nearest, minimax(samples, degree - careful)[0]))


# --- what the programs need ----------------------------------------------------------------------------------------

HALF_PI = float.fromhex("0x1.921fb54442d18p+0")  # the double nearest to pi/2, below it
LIMIT = dict.fromkeys(CLOSED, Fraction(2, 3)) | {"resistance_factor": Fraction(1)}  # of F/alpha**3 at 0


def scaled(name: str, limit: Fraction) -> Function:
    """F/alpha**3 as a function of alpha**2, times what makes `limit` its limit at 0."""
    factor = limit / LIMIT[name]
    return lambda u: exact(factor) * value(name, u.sqrt()) / (u * u.sqrt())


@cache
def near_fit(name: str, seam: float, count: int, limit: Fraction) -> tuple[float, ...]:
    """c1, c2, ... of W = limit + u (c1 + u (c2 + ...)), u = alpha**2: F/alpha**3, or its multiple with that limit at 0.

    For the least relative error up to the seam.
    """
    with ctx.workprec(_GUARD):
        function = scaled(name, limit)
        points = grid(arb(0), exact(seam) ** 2, count)
        samples = sample(function, lambda u: 1 / function(u), points).without(exact(limit))
    return rounded(samples, count - 1, careful=3)


@cache
def logarithm_fit(degree: int) -> tuple[float, tuple[float, ...]]:
    """ln 2, and P(z) = (2 artanh(q)/q - 2)/z in z = q**2, for q <= 1/5."""
    with ctx.workprec(_GUARD):
        points = grid(arb(0), exact(Fraction(1, 25)), degree)
        samples = sample(lambda z: (2 * z.sqrt().atanh() / z.sqrt() - 2) / z, lambda z: z * z.sqrt(), points)
        return nearest(arb(2).log()), rounded(samples, degree, careful=1)


@cache
def cheap_fit(name: str, above: int, below: int) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Numerator and denominator of F/alpha**3: a polynomial in alpha**2, or a rational in pi**2/4 - alpha**2."""
    function = scaled(name, LIMIT[name])
    with ctx.workprec(_GUARD):
        largest = (arb.pi() / 2) ** 2
        at: Function = (lambda w: largest - w) if below else (lambda u: u)
        points = grid(arb(0), largest, above + below, 2)
        samples = sample(lambda z: function(at(z)), lambda z: 1 / function(at(z)), points)
    over, under, _ = minimax(samples, above, below)
    return tuple(map(nearest, over)), tuple(map(nearest, under))


# Far from 0 everything is a function of b = fl(pi/2) - alpha as it is computed: pi/2 - fl(pi/2) is folded in.


def _far(name: str, rest: Callable[[arb, arb], arb], power: int, seam: float, count: int) -> Samples:
    """rest(b, F) as a function of b**2; it is to be multiplied by b**power."""
    at: Function = lambda w: value(name, exact(HALF_PI) - w.sqrt())  # noqa: E731
    with ctx.workprec(_GUARD):
        points = grid(arb(0), exact(HALF_PI - seam) ** 2, count + 2, 2)
        return sample(lambda w: rest(w.sqrt(), at(w)), lambda w: w.sqrt() ** power / at(w), points)


def _line(name: str, slope: Fraction, line: float | None = None) -> tuple[float, float, arb]:
    """The line slope alpha + `line`; what F at the end has beyond it; and the two together at the end.

    `line` is a multiple of 2**-52, as alpha >= 1 is, so that the sum makes no rounding error.
    """
    end = exact(slope) * exact(HALF_PI)
    beyond = value(name, exact(HALF_PI)) - end
    line = nearest((beyond * 2**52 + exact(0.5)).floor()) / 2**52 if line is None else line
    constant = nearest(beyond - exact(line))
    return line, constant, (end + exact(line) + exact(constant)).mid()


def _logarithmic(
    name: str, rest: Callable[[arb, arb], arb], power: int, seam: float, degree: int, scale: float
) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """R and Q of b**power (R(b**2) + Q(b**2) ln(scale b)), fitted together; with Q rounded, R again."""
    samples = _far(name, rest, power, seam, 2 * degree)
    with ctx.workprec(_GUARD):
        logs = [(exact(scale) * w.sqrt()).log() for w in samples.points]
        q = tuple(map(nearest, minimax(samples, degree, logs=(logs, degree))[1]))
        terms = zip(samples.points, samples.values, logs, strict=True)
        left = [(f - horner([exact(c) for c in q], w) * l).mid() for w, f, l in terms]
    return rounded(Samples(samples.points, left, samples.weights), degree, careful=1), q


@cache
def polar_fit(seam: float, degree: int) -> tuple[float, float, tuple[float, ...], tuple[float, ...]]:
    """I_p* = (alpha + line) + (constant + b**3 (R + Q ln b))."""
    with ctx.workprec(_GUARD):
        line, constant, straight = _line("polar_moment", Fraction(1))
    return line, constant, *_logarithmic(
        "polar_moment", lambda b, f: (f - straight + b) / b**3, 3, seam, degree, 1.0
    )  # fmt: skip


@cache
def radial_fit(seam: float, degree: int) -> tuple[float, tuple[float, ...], tuple[float, ...]]:
    """C_r = (1 - b) + (b (1 - bend b) + b**2 (R + Q ln 2 b)), with a bend that leaves little where C_r is a half."""
    bend = 1.875
    return bend, *_logarithmic(
        "radial_weight_amplitude", lambda b, f: (f - 1) / b**2 + exact(bend), 2, seam, degree, 2.0
    )  # fmt: skip


@cache
def inertia_fit(seam: float, degree: int) -> tuple[float, float, tuple[float, ...]]:
    """Theta* = (alpha/2 + line) + (constant + b E(b**2)), with a line that leaves little where Theta* is below 1/2."""
    with ctx.workprec(_GUARD):
        line, constant, straight = _line("moment_of_inertia", Fraction(1, 2), -15 / 128)
    samples = _far("moment_of_inertia", lambda b, f: (f - straight + b / 2) / b, 1, seam, degree)
    return line, constant, rounded(samples, degree, careful=3)


@cache
def weight_fit(seam: float, degree: int) -> tuple[float, float, float, tuple[float, ...]]:
    """C_theta = (alpha/2 + line) + (constant + tilt b + b (1/2 - b) + b**4 E(b**2)), tilt = -2 (pi/2 - fl(pi/2))."""
    name = "weight_moment_amplitude"
    with ctx.workprec(_GUARD):
        line, constant, straight = _line(name, Fraction(1, 2))
        tilt = nearest(2 * exact(HALF_PI) - arb.pi())
    samples = _far(name, lambda b, f: (f - straight - exact(tilt) * b + b * b) / b**4, 4, seam, degree)
    return line, constant, tilt, rounded(samples, degree, careful=2)


@cache
def weight_even_fit(seam: float, degree: int) -> tuple[float, ...]:
    """C_theta in b**2."""
    return rounded(_far("weight_moment_amplitude", lambda b, f: f, 0, seam, degree), degree, careful=2)
