"""Complete phases of motion from rest under exponentially softening friction, by a series of closed forms.

With W = exp(-slope x) and loads that friction loses with it, the equation of motion is E' + (q + brake W) E = 2 (net
moment + W load). Its solution is E = exp(brake W/slope) times the sum over j of W^j E_j, where E_j is E under constant
friction, with q - j slope for q and t_j times the net moment plus t_(j-1) times the load, t_j = (-brake/slope)^j/j!.
`derive.algebra.phase_plane` derives the series. All decaying parts of the terms j > 0 are multiples of exp(-q x), so
that each of them consists of

    constant_j (W^j - exp(-q x)) + W^j (sine_j sin(x) + vers_j (1 - cos(x)))

The duration has two parts, before and after the greatest speed, by Gauss's rule in variables in which both are regular.
The first part is x = peak s^2, s = sinh(scale v)/sinh(scale), since softening may be much shorter than the phase. The
last coefficients of Legendre's series of the integrand measure the error, which is about their square.

Series and rule are shorter than rounding requires. Lanes of higher order than `FINEST` are integrated in time.
"""

from math import factorial

from derive.flow.integrator.one_lane import (
    FROM_PEAK,
    INFINITY,
    LAST_SHARES,
    NEXT_SHARES,
    NODES,
    SHARES,
    TO_PEAK,
    Lanes,
    M,
    N,
    S,
    V,
    any_lane,
    down,
    expm1,
    minimum,
    new_series,
    number,
    sqrt,
    up,
    where,
)
from derive.flow.integrator.roots import LAST_STEP, inside_or_middle
from derive.flow.integrator.swing import (
    FADED,
    FARTHEST,
    LAST_OF_HALLEY,
    MOST_CORRECTIONS,
    end_of_swing,
    energy,
    factors,
    finish,
    functions,
    stays_positive,
)

FINEST = 18.0  # order of the series in time for a relative error of 1e-9
TERMS = 8  # of the series
GREATEST = 0.0625  # brake/slope, of which powers above the last term are below rounding
DRIVEN = 1024.0  # most that friction loses by softening over the drive, with which the digits lost by the sum increase
ALIKE = 2.0**-18  # last coefficients of an integrand up to which its integral is accurate to their square
GROWTH = tuple(1 / factorial(k) for k in range(10))
BENT = 0.33
# Places of numbers in the factors of E, after the five factors under constant friction: slope, brake/slope, the three
# factors of the terms, those of the constant summed from the last, and the factors of the net moment.
SLOPE = 5
SHIFT = 6
CONSTANT = 8
SINE = 16
VERS = 24
NET = 32
LOAD = 36


def term(part: S, drive: V, sine: V, vers: V, decay: V) -> None:
    """Compute the factors of 1 - exp(-decay x), sin(x) and 1 - cos(x) in E under constant friction."""
    share = 2.0 / (1.0 + decay * decay)
    part[1] = share * (decay * sine - vers)
    part[2] = share * (sine + decay * vers)
    part[0] = (2.0 * drive - part[1]) / decay


def softening_factors(e: S, slope: V) -> None:
    """Compute the factors of E from the factors of the net moment, which are stored from `NET` and from `LOAD` on.

    Both are factors of 1, sin(x), 1 - cos(x) and omega^2, the second ones with exp(-slope x) - 1.
    """
    drive = e[NET] - e[LOAD]
    sine = e[NET + 1] - e[LOAD + 1]
    vers = e[NET + 2] - e[LOAD + 2]
    q = 2.0 * (e[LOAD + 3] - e[NET + 3])
    shift = -2.0 * e[LOAD + 3] / slope
    factors(e, drive, sine, vers, q)
    e[SLOPE] = slope
    e[SHIFT] = shift
    part = new_series()
    weight: V = 1.0
    for j in up(1, TERMS):
        before = weight
        weight = weight * shift / number(-j)
        of_drive = weight * drive + before * e[LOAD]
        of_sine = weight * sine + before * e[LOAD + 1]
        of_vers = weight * vers + before * e[LOAD + 2]
        term(part, of_drive, of_sine, of_vers, q - number(j) * slope)
        e[CONSTANT + j - 1] = part[0]
        e[SINE + j - 1] = part[1]
        e[VERS + j - 1] = part[2]
    for j in down(TERMS - 2, 0):
        e[CONSTANT + j] = e[CONSTANT + j] + e[CONSTANT + j + 1]


def softening_functions(f: S, x: V, e: S) -> None:
    """Compute the functions of which E is the sum, the last one exp(-slope x) - 1."""
    functions(f, x, e[4])
    f[4] = expm1(-e[SLOPE] * x)


def softening_energy(e: S, f: S) -> V:
    """Return E from its factors and its functions."""
    left = 1.0 + f[4]
    constant = e[CONSTANT + TERMS - 1]
    of_sine = e[SINE + TERMS - 1]
    of_vers = e[VERS + TERMS - 1]
    for j in down(TERMS - 2, 0):
        constant = constant * left + e[CONSTANT + j]
        of_sine = of_sine * left + e[SINE + j]
        of_vers = of_vers * left + e[VERS + j]
    lost = f[0] - e[4] * f[1]
    terms = f[4] * constant + left * (of_sine * (f[0] - f[3]) + of_vers * f[2])
    terms = terms + e[4] * e[CONSTANT] * lost
    shift = e[SHIFT] * left
    grown: V = GROWTH[9]
    for k in down(8, 0):
        grown = grown * shift + GROWTH[k]
    return grown * (energy(e, f) + terms)


def slope_and_bend(e: S, f: S, energy: V) -> tuple[V, V]:
    """Return the first two derivatives of E from the equation of motion."""
    sine = f[0] - f[3]
    cosine = 1.0 - f[2]
    load = e[LOAD] + (e[LOAD + 1] * sine + (e[LOAD + 2] * f[2] + e[LOAD + 3] * energy))
    net = e[NET] + (e[NET + 1] * sine + (e[NET + 2] * f[2] + e[NET + 3] * energy))
    slope = 2.0 * (net + f[4] * load)
    load_slope = e[LOAD + 1] * cosine + (e[LOAD + 2] * sine + e[LOAD + 3] * slope)
    net_slope = e[NET + 1] * cosine + (e[NET + 2] * sine + e[NET + 3] * slope)
    bend = 2.0 * (net_slope + (f[4] * load_slope - e[SLOPE] * (1.0 + f[4]) * load))
    return slope, bend


def end_of_softening(e: S, which: M) -> V:
    """Return a zero of E, by Halley's method from the zero under residual friction, or a rotation beyond the farthest.

    It is the first zero if E rises to a single peak and falls to the zero.
    """
    x = end_of_swing(e, e[NET + 1] - e[LOAD + 1], which)
    f = new_series()
    count: N = 0
    while any_lane(which) and count < MOST_CORRECTIONS:
        inside = x > 0.0 and x < FARTHEST
        x = where(inside, x, FARTHEST)
        softening_functions(f, x, e)
        at = softening_energy(e, f)
        slope, bend = slope_and_bend(e, f, at)
        change = 2.0 * at * slope / (2.0 * slope * slope - at * bend)
        x = where(which, x - change, x)
        which = which and abs(change) > LAST_OF_HALLEY * x
        count = count + 1
    return where(which, 2.0 * FARTHEST, x)


def peak_of_softening(e: S, end: V, which: M) -> V:
    """Return the rotation of the greatest speed, by Newton's method on the derivative of E between rest and rest."""
    x = 0.5 * end
    f = new_series()
    low: V = 0.0
    high = end
    count: N = 0
    while any_lane(which) and count < 2 * MOST_CORRECTIONS:
        softening_functions(f, x, e)
        slope, bend = slope_and_bend(e, f, softening_energy(e, f))
        low = where(slope > 0.0, x, low)
        high = where(slope > 0.0, high, x)
        following = inside_or_middle(x - slope / bend, low, high)
        change = abs(following - x)
        x = where(which, following, x)
        which = which and change > LAST_STEP * x
        count = count + 1
    return x


def part_of_duration(e: S, start: V, end: V, unit: V, bend: V, first: N, last: N) -> tuple[V, V]:
    """Return the time between rest at ``start`` and the greatest speed, and the last coefficients of its integrand.

    The variable v of the rule is 0 at rest and 1 at the peak: y = unit v^2/(1 + bend (1 - v))^2 is the ratio of the
    distances to both rests. Coefficients are infinite if E does not rise from node to node. ``first`` and ``last`` are
    the numbers of the nodes.
    """
    way = where(start > 0.0, -end, end)
    total: V = 0.0
    of_last: V = 0.0
    of_next: V = 0.0
    before: V = 0.0
    rises = unit > 0.0
    f = new_series()
    for k in up(first, last):
        here = unit * (NODES[k] * NODES[k])
        other = 1.0 + bend * (1.0 - NODES[k])
        share = 1.0 / (here + other * other)
        softening_functions(f, start + way * (here * share), e)
        at = softening_energy(e, f)
        rises = rises and at > before
        before = at
        slowness = share * share * (other * NODES[k]) / sqrt(at)
        total = total + SHARES[k] * slowness
        of_last = of_last + LAST_SHARES[k] * slowness
        of_next = of_next + NEXT_SHARES[k] * slowness
    size = where(rises, (abs(of_last) + abs(of_next)) / total, INFINITY)
    return 2.0 * end * unit * (1.0 + bend) * total, size


def soften(s: Lanes, which: M) -> M:
    """Complete the phases that begin at rest and in contact, where the series suffices, and return these lanes."""
    rests = s.x == 0.0 and s.omega == 0.0
    fits = which and rests and s.drive > 0.0 and s.lifted == 0.0
    fits = fits and s.order <= FINEST and s.soften_rate < 0.0
    fits = fits and abs(s.soften_drive) <= DRIVEN * s.drive
    if not any_lane(fits):
        return fits
    e = new_series()
    e[NET] = s.drive
    e[NET + 1] = s.net_sine
    e[NET + 2] = s.net_vers
    e[NET + 3] = s.net_square
    e[LOAD] = s.soften_drive
    e[LOAD + 1] = s.soften_sine
    e[LOAD + 2] = s.soften_vers
    e[LOAD + 3] = s.soften_square
    softening_factors(e, -s.soften_rate)
    fits = fits and e[4] >= 0.0 and 2.0 * e[4] <= e[SLOPE] and abs(e[SHIFT]) <= GREATEST
    if not any_lane(fits):
        return fits
    end = end_of_softening(e, fits)
    f = new_series()
    functions(f, minimum(end, FARTHEST), e[4])
    fits = fits and end < FARTHEST and e[4] * end < FADED and s.normal_square >= 0.0
    fits = fits and stays_positive(s.normal_load, s.upright_sine, s.upright_vers, f)
    fits = fits and stays_positive(s.normal0, s.normal_sine, s.normal_vers, f)
    if any_lane(fits):
        peak = peak_of_softening(e, end, fits)
        none: V = 0.0
        past = end - peak
        ratio = 4.0 * s.factor  # 1 in ensembles; error estimates change it and compare different rules
        bend = ratio * BENT * sqrt(1.0 + peak * e[SLOPE])
        before, first = part_of_duration(e, none, end, peak / past, bend, 0, TO_PEAK - 1)
        after, second = part_of_duration(e, end, end, past / peak, ratio - 1.0, TO_PEAK, TO_PEAK + FROM_PEAK - 1)
        fits = fits and first <= ALIKE and second <= ALIKE and s.time + (before + after) < s.end_time
        if any_lane(fits):
            softening_functions(f, peak, e)
            at = softening_energy(e, f)
            slope, bend = slope_and_bend(e, f, at)
            finish(s, fits, end, before + after, peak, before, sqrt(at), 0.5 * slope)
    return fits
