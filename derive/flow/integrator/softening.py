"""E = omega^2 of a phase from rest under softening friction in closed form, and the duration of the phase.

`derive.flow.integrator.hyperbolic` has E under hyperbolic friction. Under exponential friction, with W = exp(-slope x),
E' + (q + brake W) E = 2 (net moment + W load) without the parts that E causes. E is exp(brake W/slope) times
the sum over j of W^j E_j, where E_j is E under constant friction with q - j slope for q, and t_j times the net moment
plus t_(j-1) times the load, t_j = (-brake/slope)^j/j!. `derive.algebra.phase_plane` derives this series. The parts of
the terms j > 0 that decay like exp(-(q - j slope) x) make one multiple of exp(-q x):

    W^j E_j = constant_j (W^j - exp(-q x)) + W^j (vers_j (1 - cos(x)) - sine_j sin(x))

The duration has two parts, before and after the greatest speed, by Gauss's rule in a variable in which both ends are
regular. In the second part E is a function of the distance from the end, where W begins with W_0 instead of 1, and
W_0^j exp(-q x) is in place of exp(-q x). The last coefficients of Legendre's series of an integrand measure the error,
which is about their square. Rules have twice as many nodes if a series in time would have an order above `FINEST`, or
if the duration is uncertain otherwise.
"""

from derive.flow.integrator.energy import FADING, LAST, energy, factors, force_at, functions, look_back, reverse
from derive.flow.integrator.hyperbolic import FIRST, LOAD, NET, POLE, SHIFT, hyperbolic_energy, hyperbolic_factors
from derive.flow.integrator.one_lane import (
    INFINITY,
    LAST_SHARES,
    NEXT_SHARES,
    NODES,
    RATIO,
    RATIO_TO_ROUNDING,
    SHARES,
    SHORTEST,
    Lanes,
    M,
    N,
    S,
    V,
    down,
    expm1,
    log1p,
    new_series,
    number,
    sqrt,
    up,
    where,
)
from derive.flow.integrator.rotation import CLOSER, FINEST

TERMS = 8  # of the series
GREATEST = 0.0625  # brake/slope, of which powers above the last term are below rounding
DRIVEN = 1024.0  # greatest load that friction loses over the drive, with which the digits lost by the sum increase
ALIKE = 2.0**-18  # last coefficients of an integrand up to which its integral is accurate, `CLOSER` beyond `FINEST`
BETWEEN = 0.24  # factors of lanes that are solved to rounding are smaller, all others greater
BENT = 0.325  # factor of the root of slope x in a rule with closer nodes where friction softens
CLOSER_TO_POLE = 3.0  # of nodes in the logarithm of the distance from the pole
LEAST_EXPONENT = -0.5  # p of hyperbolic friction
COMPLETE = 6.0  # square of the distance of the end from this pole, times 1 + q^2, up to which the series suffices
# Places of the factors of the terms from the first on, beside those for hyperbolic friction: `SHIFT` has brake/slope,
# `FIRST` W at the beginning.
CONSTANT = 8
SINE = 16
VERS = 24


def factors_of_terms(e: S, q: V, rate: V) -> None:
    """Compute the factors of all terms from the numbers of the net moment without the load, and of the load."""
    factors(e, e[NET], e[NET + 1], e[NET + 2], q)
    part = new_series()
    weight: V = 1.0
    for j in up(1, TERMS):
        before = weight
        weight = weight * e[SHIFT] / number(-j)
        drive = weight * e[NET] + before * e[LOAD]
        sine = weight * e[NET + 1] + before * e[LOAD + 1]
        vers = weight * e[NET + 2] + before * e[LOAD + 2]
        faster = q + number(j) * rate
        factors(part, drive, sine, vers, faster)
        e[CONSTANT + j] = (part[0] + part[3]) / part[4]
        e[SINE + j] = part[3]
        e[VERS + j] = part[2]


def factors_of_law(s: Lanes, e: S, q: V, rate: V, drive: V) -> None:
    """Compute the factors of E from the numbers of the net moment and of the load. ``drive`` is their sum."""
    if s.has.per_pole:
        hyperbolic_factors(s, e, q, drive)
        return
    factors_of_terms(e, q, rate)


def softening_factors(s: Lanes, e: S) -> None:
    """Compute the factors of E."""
    e[SHIFT] = 2.0 * s.net_loss_square / s.loss_rate
    e[FIRST] = 1.0
    e[LOAD] = s.net_loss
    e[LOAD + 1] = s.net_loss_sine
    e[LOAD + 2] = s.net_loss_vers
    e[NET] = s.drive - s.net_loss
    e[NET + 1] = s.net_sine - s.net_loss_sine
    e[NET + 2] = s.net_vers - s.net_loss_vers
    e[POLE] = -1.0 / s.loss_rate
    q = 2.0 * (s.net_loss_square - s.net_square)
    factors_of_law(s, e, q, s.loss_rate, s.drive)


def factors_about_end(s: Lanes, back: S, e: S, f: S) -> None:
    """Compute the factors of E as a function of the distance from the end of a phase, from the functions there.

    Near the end E is small, and without a rounding error of the terms of which it is the sum.
    """
    back[SHIFT] = e[SHIFT]
    back[FIRST] = 1.0 + f[4]
    look_back(back, LOAD, e[LOAD], e[LOAD + 1], e[LOAD + 2], f)
    look_back(back, NET, e[NET], e[NET + 1], e[NET + 2], f)
    back[POLE] = -e[POLE] - f[0]
    drive = back[NET] + back[FIRST] * back[LOAD]
    factors_of_law(s, back, -e[4], -s.loss_rate, drive)


def series_suffices(s: Lanes, e: S) -> M:
    """Return whether the series is as accurate as the order of a lane requires, and no term is in resonance."""
    driven = abs(s.net_loss) <= DRIVEN * s.drive
    if s.has.per_pole:
        return driven and e[SHIFT] > LEAST_EXPONENT
    converges = abs(e[SHIFT]) <= GREATEST
    resonates = 2.0 * e[4] + s.loss_rate >= 0.0
    return driven and converges and not resonates


def softening_functions(s: Lanes, e: S, f: S, x: V) -> None:
    """Compute the functions of which E consists, the last one what friction has lost, such as exp(-slope x) - 1."""
    functions(f, x, abs(e[4]))
    if s.has.per_pole:
        change = s.loss_rate * x
        f[4] = change / (1.0 - change)
        return
    f[4] = expm1(s.loss_rate * x)


def count_from_end(s: Lanes, back: S, f: S, x: V) -> None:
    """Change the functions of a distance from the end of a phase to those of E there, at the rotation ``x``."""
    reverse(f, -back[4])
    f[4] = -f[4] * (1.0 + expm1(s.loss_rate * x))


def softening_energy(e: S, f: S) -> V:
    """Return E from its factors and its functions."""
    first = e[FIRST]
    left = first + f[4]
    above: V = 0.0
    constant: V = 0.0
    of_sine: V = 0.0
    of_vers: V = 0.0
    for j in down(TERMS, 1):
        above = above * first + e[CONSTANT + j]
        constant = constant * left + above
        of_sine = of_sine * left + e[SINE + j]
        of_vers = of_vers * left + e[VERS + j]
    sine = f[0] - f[3]
    turned_part = left * (of_vers * f[2] - of_sine * sine)
    terms = f[4] * constant + turned_part
    shift = e[SHIFT] * left
    grown: V = 0.0
    for k in down(LAST, 0):
        grown = FADING[k] - grown * shift
    square = shift * shift
    grown = 1.0 + (shift + square * grown)
    lost = f[0] - e[4] * f[1]
    faded_part = e[4] * (above * first) * lost
    return grown * (energy(e, f) + (terms + faded_part))


def passed_to(s: Lanes, x: V) -> V:
    """Return the variable of the rules: the rotation, or under hyperbolic friction the logarithm from its pole."""
    if s.has.per_pole:
        return log1p(s.per_pole * x)
    return x


def energy_at(s: Lanes, e: S, f: S, x: V) -> V:
    """Compute the functions of which E consists, and return E."""
    if s.has.loss_rate:
        softening_functions(s, e, f, x)
        return hyperbolic_energy(e, f, passed_to(s, x)) if s.has.per_pole else softening_energy(e, f)
    functions(f, x, e[4])
    return energy(e, f)


def evaluate_at(s: Lanes, e: S, f: S, x: V) -> None:
    """Compute the functions of which E consists, and from place 5 on E and its first three derivatives.

    The derivatives follow from the equation of motion, in which friction softens or is constant. The third one leaves
    out that friction softens further.
    """
    drive = 1.0 * s.drive
    of_sine = 1.0 * s.net_sine
    of_vers = 1.0 * s.net_vers
    of_square = 1.0 * s.net_square
    by_loss: V = 0.0
    f[5] = energy_at(s, e, f, x)
    if s.has.loss_rate:
        left = 1.0 + f[4]
        rate = s.loss_rate * left
        if s.has.per_pole:
            rate = rate * left
        weight = force_at(s.net_loss, s.net_loss_sine, s.net_loss_vers, f)
        by_loss = rate * (weight + s.net_loss_square * f[5])
        drive = drive + f[4] * s.net_loss
        of_sine = of_sine + f[4] * s.net_loss_sine
        of_vers = of_vers + f[4] * s.net_loss_vers
        of_square = of_square + f[4] * s.net_loss_square
    sine = f[0] - f[3]
    cosine = 1.0 - f[2]
    twice = 2.0 * of_square
    f[6] = 2.0 * force_at(drive, of_sine, of_vers, f) + twice * f[5]
    f[7] = 2.0 * (of_sine * cosine + of_vers * sine + by_loss) + twice * f[6]
    f[8] = 2.0 * (of_vers * cosine - of_sine * sine) + twice * f[7]


def energy_past(s: Lanes, e: S, f: S, past: V, end: V, part: N) -> V:
    """Return E at a distance from rest in the variable of the rules, and compute dx by this variable in place 5."""
    f[5] = 1.0
    if s.has.per_pole:
        at = hyperbolic_energy(e, f, -past if part else past)
        f[5] = abs(e[POLE] + f[0])
        return at
    softening_functions(s, e, f, past)
    if part:
        count_from_end(s, e, f, end - past)
    return softening_energy(e, f)


def at_node(s: Lanes, e: S, end: V, unit: V, bend: V, node: V, part: N) -> tuple[V, V]:
    """Return E and the integrand at a node of `time_of_part`, with its arguments."""
    here = unit * (node * node)
    other = 1.0 + bend * (1.0 - node)
    share = 1.0 / (here + other * other)
    past = end * (here * share)
    f = new_series()
    energy_there = energy_past(s, e, f, past, end, part)
    return energy_there, share * share * (other * node) * f[5] / sqrt(energy_there)


def time_of_part(s: Lanes, e: S, end: V, unit: V, bend: V, part: N, closer: N) -> V:
    """Return the time before the greatest speed, or with ``part`` 1 after it, infinite if it is uncertain.

    The variable v of the rule is 0 at rest and 1 at the peak: unit v^2/(1 + bend (1 - v))^2 is the ratio of the
    distances to both rests, under hyperbolic friction of their logarithms from its pole. E rises from node to node.
    There are twice as many nodes if they are to be ``closer``.
    """
    total: V = 0.0
    last: V = 0.0
    last_but_one: V = 0.0
    lower: V = 0.0
    longest: N = closer and part == 0
    k_first: N = 7 * SHORTEST if longest else (3 * SHORTEST if closer == part else SHORTEST)
    for k in up(k_first, 2 * k_first + SHORTEST - 1):
        at, slowness = at_node(s, e, end, unit, bend, NODES[k], part)
        total = where(at > lower, total + SHARES[k] * slowness, INFINITY)
        lower = at
        last = last + LAST_SHARES[k] * slowness
        last_but_one = last_but_one + NEXT_SHARES[k] * slowness
    most: V = CLOSER if s.highest > FINEST else ALIKE
    uneven = abs(last) + abs(last_but_one)
    accurate = uneven <= most * total
    time = end * unit * (1.0 + bend) * total
    return where(accurate, time, INFINITY)


def duration_of_softening(s: Lanes, e: S, f: S, end: V, peak: V, closer: N) -> tuple[V, V]:
    """Return the times from rest to the greatest speed and to the end, infinite if they are uncertain.

    ``f`` has the functions of E at the end.
    Error estimates change the factor of a lane, and with it the rules, which they so compare.
    """
    to_peak = passed_to(s, peak)
    to_end = passed_to(s, end)
    unit = to_peak / (to_end - to_peak)
    softened = 1.0 - peak * s.loss_rate
    usual = where(s.factor < BETWEEN, RATIO_TO_ROUNDING, RATIO)
    change = s.factor / usual
    bend = change * BENT * sqrt(softened)
    if s.has.per_pole:
        bend = change * CLOSER_TO_POLE
        reach = end + e[POLE]
        complete = (1.0 + e[4] * e[4]) * (reach * reach) < COMPLETE
        to_end = where(complete, to_end, INFINITY)
    before = time_of_part(s, e, to_end, unit, bend, 0, closer)
    back = new_series()
    factors_about_end(s, back, e, f)
    after = time_of_part(s, back, to_end, 1.0 / unit, change - 1.0, 1, closer)
    return before, before + after
