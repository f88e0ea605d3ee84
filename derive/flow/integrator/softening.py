"""E = omega^2 of a phase from rest under softening friction in closed form, and the duration of the phase.

For hyperbolic friction see `derive.flow.integrator.hyperbolic`. For exponential friction, with W = exp(-slope x), E' + (q + brake W) E = 2 (net moment + W load) without the parts that E causes. E is
exp(brake W/slope) times the sum over j of W^j E_j, where E_j is E under constant friction with q - j slope for q, and
t_j times the net moment plus t_(j-1) times the load, t_j = (-brake/slope)^j/j!. `derive.algebra.phase_plane` derives
this series. The parts of the terms j > 0 that decay like exp(-(q - j slope) x) make one multiple of exp(-q x):

    W^j E_j = constant_j (W^j - exp(-q x)) + W^j (vers_j (1 - cos(x)) - sine_j sin(x))

The duration has two parts, before and after the greatest speed, by Gauss's rule in a variable in which both ends are
regular. The last coefficients of Legendre's series of an integrand measure the error, which is about their square.

Series and rules are shorter than rounding requires: lanes of higher order than `FINEST` are integrated in time.
"""

from derive.flow.integrator.energy import FADING, LAST, energy, factors, functions, turned
from derive.flow.integrator.hyperbolic import (
    EXPONENT,
    hyperbolic_energy,
    hyperbolic_factors,
    hyperbolic_functions,
)
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
    down,
    expm1,
    log1p,
    new_series,
    number,
    sqrt,
    up,
    where,
)

FINEST = 18.0  # order of the series in time for a relative error of 1e-9
TERMS = 8  # of the series
GREATEST = 0.0625  # brake/slope, of which powers above the last term are below rounding
DRIVEN = 1024.0  # greatest load that friction loses over the drive, with which the digits lost by the sum increase
ALIKE = 2.0**-18  # last coefficients of an integrand up to which its integral is accurate
BENT = 1.3  # factor of the root of slope x in a rule with closer nodes where friction softens
CLOSER_AT_START = 12.0  # the same without the root where the variable of the rule is a logarithm
LEAST_EXPONENT = -0.5  # of hyperbolic friction
WIDEST = 2.0  # end of a phase from the pole of hyperbolic friction, for which its series is complete
# Places of further factors of E: brake/slope, and the factors of the terms from the first on.
SHIFT = 5
CONSTANT = 8
SINE = 16
VERS = 24


def softening_factors(s: Lanes, e: S) -> None:
    """Compute the factors of E."""
    drive = s.drive - s.net_loss
    sine = s.net_sine - s.net_loss_sine
    vers = s.net_vers - s.net_loss_vers
    q = 2.0 * (s.net_loss_square - s.net_square)
    factors(e, drive, sine, vers, q)
    if s.has.per_pole:
        hyperbolic_factors(s, e, drive, sine, vers)
        return
    e[SHIFT] = 2.0 * s.net_loss_square / s.loss_rate
    part = new_series()
    weight: V = 1.0
    for j in up(1, TERMS):
        before = weight
        weight = weight * e[SHIFT] / number(-j)
        of_sine = weight * sine + before * s.net_loss_sine
        of_vers = weight * vers + before * s.net_loss_vers
        factors(part, weight * drive + before * s.net_loss, of_sine, of_vers, q + number(j) * s.loss_rate)
        e[CONSTANT + j] = (part[0] + part[3]) / part[4]
        e[SINE + j] = part[3]
        e[VERS + j] = part[2]


def series_suffices(s: Lanes, e: S) -> M:
    """Return whether the series is as accurate as the order of a lane requires, and no term is in resonance."""
    fits = s.order <= FINEST and abs(s.net_loss) <= DRIVEN * s.drive
    if s.has.per_pole:
        return fits and e[EXPONENT] > LEAST_EXPONENT
    return fits and abs(e[SHIFT]) <= GREATEST and 2.0 * e[4] + s.loss_rate < 0.0


def softening_functions(s: Lanes, e: S, f: S, x: V) -> None:
    """Compute the functions of which E consists, the last one exp(-slope x) - 1."""
    functions(f, x, e[4])
    f[4] = expm1(s.loss_rate * x)


def softening_energy(e: S, f: S) -> V:
    """Return E from its factors and its functions."""
    left = 1.0 + f[4]
    above: V = 0.0
    constant: V = 0.0
    of_sine: V = 0.0
    of_vers: V = 0.0
    for j in down(TERMS, 1):
        above = above + e[CONSTANT + j]
        constant = constant * left + above
        of_sine = (of_sine + e[SINE + j]) * left
        of_vers = (of_vers + e[VERS + j]) * left
    terms = f[4] * constant + (of_vers * f[2] - of_sine * (f[0] - f[3]))
    shift = e[SHIFT] * left
    grown: V = 0.0
    for k in down(LAST, 0):
        grown = FADING[k] - grown * shift
    square = shift * shift
    grown = 1.0 + (shift + square * grown)
    faded_part = e[4] * above * (f[0] - e[4] * f[1])
    return grown * (energy(e, f) + (terms + faded_part))


def passed_to(s: Lanes, x: V) -> V:
    """Return the variable of the rules: the rotation, or the logarithm of its distance from the pole of friction."""
    if s.has.per_pole:
        return log1p(s.per_pole * x)
    return x


def energy_at(s: Lanes, e: S, f: S, x: V, passed: V) -> V:
    """Return E at a rotation, and compute the functions of which it consists."""
    if s.has.per_pole:
        hyperbolic_functions(e, f, x, passed)
        return hyperbolic_energy(e, f)
    softening_functions(s, e, f, x)
    return softening_energy(e, f)


def soften(s: Lanes, e: S, f: S, x: V) -> None:
    """Compute E and its first two derivatives behind the functions of which it consists."""
    passed = passed_to(s, x)
    at = energy_at(s, e, f, x, passed)
    rate = s.loss_rate * (1.0 + f[4])
    if s.has.per_pole:
        left = 1.0 / (1.0 + s.per_pole * x)
        lag, versine = turned(x)
        f[2] = versine
        f[3] = lag
        f[4] = s.loss_rate * x * left
        rate = s.loss_rate * (left * left)
    sine = f[0] - f[3]
    of_sine = s.net_sine + f[4] * s.net_loss_sine
    of_vers = s.net_vers + f[4] * s.net_loss_vers
    of_square = s.net_square + f[4] * s.net_loss_square
    lost = s.net_loss_vers * f[2] + s.net_loss_square * at
    loss = s.net_loss + (s.net_loss_sine * sine + lost)
    bent = of_vers * f[2] + of_square * at
    drive = s.drive + f[4] * s.net_loss
    slope = 2.0 * (drive + (of_sine * sine + bent))
    turns = of_sine * (1.0 - f[2]) + (of_vers * sine + of_square * slope)
    f[5] = at
    f[6] = slope
    f[7] = 2.0 * (turns + rate * loss)


def time_of_part(s: Lanes, e: S, end: V, unit: V, bend: V, part: N) -> V:
    """Return the time before the greatest speed, or with ``part`` 1 after it, infinite if it is uncertain.

    The variable v of the rule is 0 at rest and 1 at the peak: unit v^2/(1 + bend (1 - v))^2 is the ratio of the
    distances to both rests in `passed_to`. E rises from node to node.
    """
    total: V = 0.0
    last: V = 0.0
    last_but_one: V = 0.0
    lower: V = 0.0
    pole: V = 1.0
    if s.has.per_pole:
        pole = 1.0 / s.per_pole
    f = new_series()
    for k in up(TO_PEAK * part, TO_PEAK + FROM_PEAK * part - 1):
        here = unit * (NODES[k] * NODES[k])
        other = 1.0 + bend * (1.0 - NODES[k])
        share = 1.0 / (here + other * other)
        past = end * (here * share)
        passed: V = past if part == 0 else end - past
        x: V = 1.0 * passed
        per_passed: V = 1.0
        if s.has.per_pole:
            x = pole * expm1(passed)
            per_passed = pole + x
        at = energy_at(s, e, f, x, passed)
        slowness = share * share * (other * NODES[k]) * per_passed / sqrt(at)
        total = where(at > lower, total + SHARES[k] * slowness, INFINITY)
        lower = at
        last = last + LAST_SHARES[k] * slowness
        last_but_one = last_but_one + NEXT_SHARES[k] * slowness
    accurate = abs(last) + abs(last_but_one) <= ALIKE * total
    return where(accurate, end * unit * (1.0 + bend) * total, INFINITY)


def duration_of_softening(s: Lanes, e: S, end: V, peak: V) -> tuple[V, V]:
    """Return the times from rest to the greatest speed and to the end, infinite if they are uncertain.

    Error estimates change the step over the radius of convergence, and with it the rules, which they so compare.
    """
    to_peak = passed_to(s, peak)
    to_end = passed_to(s, end)
    unit = to_peak / (to_end - to_peak)
    softened = 1.0 - peak * s.loss_rate
    bend = s.factor * BENT * sqrt(softened)
    if s.has.per_pole:
        bend = s.factor * CLOSER_AT_START
    before = time_of_part(s, e, to_end, unit, bend, 0)
    if s.has.per_pole:
        complete = end + 1.0 / s.per_pole < WIDEST
        before = where(complete, before, INFINITY)
    after = time_of_part(s, e, to_end, 1.0 / unit, 4.0 * s.factor - 1.0, 1)
    return before, before + after
