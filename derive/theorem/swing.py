"""One swing of a slide, from rest to the next standstill: omega*^2 as Taylor models whose remainders are bounded.

While friction depends on the slip alone, E = omega*^2 obeys a linear equation in the rotation x since the swing began,

    E' + q E = r,   E(0) = 0,   q >= 0,   so that   E = exp(-Q) (E(c) + int_c exp(Q) r),   Q = int_c q,

of which `Swing.taylor` gives the series about any c. Two facts make its standstill a theorem. Where r > 0, E cannot
return to 0. Where r < 0 and E >= 0, E falls. So if r changes its sign once, from + to -, E has one zero after 0.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

from flint import arb, arb_poly, arb_series, ctx

from derive.check.truth import TERMS, Model, ball, coefficients, working

FIRST_STEP = arb(0.5)
SPLITS = 60  # halvings of an interval after which a claim counts as undecided
Function = Callable[[arb], list[arb]]  # a function and its derivative on a ball


class Undecided(ArithmeticError):
    """The balls are too wide for a decision: more digits, or narrower inputs, are needed."""


class Swing(NamedTuple):
    """The coefficients of q and r, with the dip psi = dip - x of the chord after a rotation x:

    mu = residual + drop exp(-decay x),  q = polar mu,  r = weight sin psi - mu press cos psi - cohesion
    """

    dip: arb
    weight: arb
    press: arb
    polar: arb
    cohesion: arb
    residual: arb
    drop: arb
    decay: arb

    def friction(self, x: Any) -> Any:
        """mu after a rotation: a ball or a series."""
        return (-self.decay * x).exp() * self.drop + self.residual

    def net(self, x: Any) -> Any:
        """r after a rotation."""
        sin, cos = (self.dip - x).sin_cos()
        return self.weight * sin - self.friction(x) * self.press * cos - self.cohesion

    def taylor(self, centre: arb, energy: arb) -> arb_series:
        """Of E, from its value at the centre."""
        x = arb_series([centre, 1])
        brake = (self.friction(x) * self.polar).integral()
        growing = brake.exp()
        driven = (growing * self.net(x)).integral()
        return (driven + energy) / growing

    def net_and_slope(self, x: arb) -> list[arb]:
        """r and its derivative."""
        return list(self.net(arb_series([x, 1])))[:2]

    def model(self, start: arb, energy: arb, step: arb) -> Model:
        """E on [start, start + step] and 1 % beyond, from its value at the start."""
        box = start + step * arb(0.5, 0.51)
        deviation = box - start
        width = deviation.abs_upper()
        brake = self.friction(box) * self.polar
        # Of D = E - E(start) the equation D' = (r - q E(start)) - q D has this bound, by Gronwall's lemma.
        forcing = self.net(box) - brake * energy
        exponent = brake.abs_upper() * width
        growth = forcing.abs_upper() * exponent.exp()
        inside = energy + deviation * growth * arb(0, 1)
        fat = coefficients(self.taylor(box, inside))
        thin = coefficients(self.taylor(start, energy))
        return Model(arb_poly(thin[:TERMS]), fat[TERMS], TERMS)

    def reversed(self, rest: arb) -> "Swing":
        """The swing that begins where this one ends, in the other direction; friction does not heal."""
        drop = (-self.decay * rest).exp() * self.drop
        return self._replace(dip=rest - self.dip, drop=drop)


class Energy(NamedTuple):
    """E of a swing from its start until E is below 0, by pieces."""

    swing: Swing
    pieces: list[tuple[arb, arb, Model]]

    def __call__(self, x: arb) -> arb:
        """E on a ball, as far as it lies within the pieces."""
        union = arb.nan()
        for lower, upper, model in self.pieces:
            piece = ball(lower, upper)
            if piece.overlaps(x):
                value = model(x.intersection(piece) - lower)
                union = value.union(union) if union.is_finite() else value
        return union

    def slopes(self, x: arb) -> list[arb]:
        """E, E' and E''."""
        with working(ctx.prec, 3):
            value, slope, half_curvature = self.swing.taylor(x, self(x))
        return [value, slope, 2 * half_curvature]


def integrate(swing: Swing, tolerance: arb) -> Energy:
    """E from rest until it is below 0, by steps whose remainders are within the tolerance, relative."""
    pieces: list[tuple[arb, arb, Model]] = []
    start, energy, step = arb(0), arb(0), FIRST_STEP
    farthest = (swing.dip + arb.pi() / 2).upper()
    while not energy < 0:
        model = swing.model(start, energy, step)
        sizes = [a.abs_upper() * step**k for k, a in enumerate(model.main.coeffs())]
        remainder = model.last.abs_upper() * step**TERMS
        if not remainder < max(sizes) * tolerance:
            step /= 2
            if step < arb(2) ** -SPLITS:
                raise Undecided("the series of omega*^2 do not converge")
            continue
        end = (start + step).mid()
        energy = model(end - start)
        pieces.append((start, end, model))
        start, step = end, min(2 * step, FIRST_STEP)
        if start > farthest:
            raise Undecided("the mass has turned past the top without a standstill")
    return Energy(swing, pieces)


def edge(function: Function, sign: int, inside: arb, outside: arb, tolerance: arb) -> arb:
    """The last point found from ``inside`` towards ``outside`` where a function is proved to have this sign."""
    for _ in range(ctx.prec):
        if abs(outside - inside) < tolerance * inside:
            break
        middle = ((inside + outside) / 2).mid()
        if sign * function(middle)[0] > 0:
            inside = middle
        else:
            outside = middle
    return inside


def prove_sign(function: Function, sign: int, low: arb, high: arb, splits: int = SPLITS) -> None:
    """Prove the sign of a function on [low, high]: it has it at both ends, and, in parts, is monotone or has it."""
    at_low, *_ = function(low)
    at_high, *_ = function(high)
    if not (sign * at_low > 0 and sign * at_high > 0) or not splits:
        raise Undecided("a sign between two points is not certain")
    value, slope, *_ = function(ball(low, high))
    if not (sign * value > 0 or slope > 0 or slope < 0):
        middle = ((low + high) / 2).mid()
        prove_sign(function, sign, low, middle, splits - 1)
        prove_sign(function, sign, middle, high, splits - 1)


def crossing(function: Function, low: arb, high: arb, tolerance: arb) -> arb:
    """The ball that holds the only zero of a function on [low, high], proved to go from above 0 to below it there."""
    before = edge(function, 1, low, high, tolerance)
    after = edge(function, -1, high, before, tolerance)
    prove_sign(function, 1, low, before)
    prove_sign(function, -1, after, high)
    return ball(before, after)


class Standstill(NamedTuple):
    """The end of a swing: rotation, time (over sqrt(R/g)), rotation and omega*^2 at the peak; where r changes sign."""

    rest: arb
    time: arb
    peak_at: arb
    peak: arb
    turn: arb


def standstill(swing: Swing, tolerance: arb) -> Standstill:
    """Enclose the next standstill, for a swing that starts (r(0) > 0), as closely as exact inputs allow."""
    energy = integrate(swing, tolerance)
    end = energy.pieces[-1][1]
    turn = crossing(swing.net_and_slope, arb(0), end, tolerance)
    if not energy(turn) > 0:
        raise Undecided("whether the mass still moves where the net moment changes sign is not certain")
    after = turn.upper()
    # On [after, end] r < 0: E falls there until it is 0, and cannot rise above 0 again.
    before = edge(energy.slopes, 1, after, end, tolerance)
    rest = ball(before, edge(energy.slopes, -1, end, before, tolerance))
    falling = ((after + before) / 2).mid()
    peak_at = crossing(lambda x: energy.slopes(x)[1:], arb(0), falling, tolerance)
    return Standstill(rest, duration(energy, rest, tolerance), peak_at, energy(peak_at), turn)


def duration(energy: Energy, rest: arb, tolerance: arb) -> arb:
    """t* = int_0^rest dx / sqrt(E): at both ends E = t F(t), of which F is expanded, and the root of t is exact."""

    def share(low: arb, high: arb, splits: int = SPLITS) -> arb:
        time, remainder = _share(energy, low, high, high is rest)
        if remainder < time * tolerance or remainder < time.rad():
            return time + remainder * arb(0, 1)
        if not splits or not high - low > 8 * high.rad():
            raise Undecided("the time of a part of the motion is not bounded")
        middle = ((low + high) / 2).mid()
        return share(middle, high, splits - 1) + share(low, middle, splits - 1)

    return share((rest / 2).mid(), rest) + share(arb(0), (rest / 2).mid())


def _share(energy: Energy, low: arb, high: arb, falls: bool) -> tuple[arb, arb]:
    """The time between two rotations by a series about one of them, and the bound of its remainder."""
    root = int(falls or low == 0)
    last = TERMS - root
    centre = high if falls else low
    at_centre = arb(0) if root else energy(centre)
    thin = _rates(energy.swing.taylor(centre, at_centre), root, falls)
    box = ball(low, high.upper())
    fat = _rates(energy.swing.taylor(box, energy(box)), root, falls)
    exponents = [k + 1 - arb(root) / 2 for k in range(last + 1)]
    *powers, power = [(high - low) ** n / n for n in exponents]
    time = sum(map(arb.__mul__, thin, powers), arb(0))
    return time, fat[last].abs_upper() * power


def _rates(series: arb_series, root: int, falls: bool) -> list[arb]:
    """Coefficients of 1/sqrt(E), or of 1/sqrt(F) with E = t F.

    That F has derivatives within those of E' over the same box: F(t) = int_0^1 E'(s t) ds.
    """
    sign = -1 if falls else 1
    terms = [series[k] * sign**k for k in range(root, TERMS + 1)]
    return list(arb_series(terms).rsqrt())
