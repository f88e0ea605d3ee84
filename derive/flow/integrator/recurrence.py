"""Series of E = omega^2 in the rotation, by a recurrence without products of series.

While a mass turns under constant friction, or in one piece of a table of slip, the net moment is

    net = drive + sine sin(x) + vers (1 - cos(x)) + square E + loss(x) weight,
    weight = load + load_sine sin(x) + load_vers (1 - cos(x)) + load_square E

where x is the rotation since the phase began, and loss a polynomial of x. With dE/dx = 2 net each coefficient of E
therefore follows from the coefficients before, as many as the polynomial has. E has no singularity, so that a step may
be as long as the piece.
"""

from derive.flow.integrator.energy import stays_in_contact, turned
from derive.flow.integrator.one_lane import (
    Kind,
    Lanes,
    M,
    N,
    S,
    V,
    all_lanes,
    any_lane,
    down,
    greatest,
    least,
    maximum,
    minimum,
    new_series,
    number,
    up,
    where,
)
from derive.flow.integrator.series import is_negligible, look_for_end


def find_loss(s: Lanes, loss: S) -> N:
    """Compute the change of friction since the phase began, a polynomial of the path ahead, and return its degree."""
    degree: N = 0
    loss[0] = 0.0
    for t in s.tables:
        degree = t.degree
        for k in up(1, degree):
            loss[k] = t.coefficients[k - 1]
    if any_lane(s.x > 0.0):
        for first in up(0, degree - 1):
            for k in down(degree - 1, first):
                loss[k] = loss[k] + s.x * loss[k + 1]
    return degree


def find_series(s: Lanes, top: N) -> None:
    """Compute the series of net moment and E from E at the beginning of a step."""
    e = s.series.omega
    net = s.series.net
    weight = new_series()
    loss = new_series()
    degree: N = find_loss(s, loss)
    lag, versine = turned(s.x)
    sine = s.net_sine + loss[0] * s.net_loss_sine
    vers = s.net_vers + loss[0] * s.net_loss_vers
    square = s.net_square + loss[0] * s.net_loss_square
    constant = s.drive + loss[0] * s.net_loss
    load = 1.0 * s.net_loss
    # Coefficients of sin(x), cos(x) and 1 - cos(x).
    odd = s.x - lag
    even = 1.0 - versine
    for n in up(0, top - 1):
        turned_part = sine * odd + vers * versine
        whole = constant + turned_part + square * e[n]
        if degree > 0:
            turned_load = s.net_loss_sine * odd + s.net_loss_vers * versine
            weight[n] = load + turned_load + s.net_loss_square * e[n]
        most: N = minimum(degree, n)
        for k in up(1, most):
            whole = whole + loss[k] * weight[n - k]
        net[n] = whole
        e[n + 1] = 2.0 * whole * s.inverse[n + 1]
        odd_before = odd
        odd = even * s.inverse[n + 1]
        even = -odd_before * s.inverse[n + 1]
        versine = -even
        constant = 0.0
        load = 0.0


def keep_significant(s: Lanes, which: M, top: N) -> None:
    """Set the order of each lane's series, without last terms that are negligible within the step."""
    e = s.series.omega
    power = s.step * s.step
    power = power * s.step
    last: V = 3.0
    for n in up(4, top):
        power = power * s.step
        term = abs(e[n]) * power
        counts = not is_negligible(s, term, s.largest_omega)
        s.largest_omega = maximum(term, s.largest_omega)
        last = where(counts, number(n), last)
    converges = last < s.order - 1.0
    last = where(converges, last, s.order)
    s.series_order = where(which, last, 3.0)


def truncate(s: Lanes, top: N) -> N:
    """Set the coefficients beyond each lane's order to zero, and return the highest order."""
    order = s.series_order
    highest: N = greatest(order)
    if not all_lanes(order == number(highest)):
        for n in up(least(order), highest - 1):
            within = order > number(n)
            s.series.net[n] = where(within, s.series.net[n], 0.0)
            s.series.omega[n + 1] = where(within, s.series.omega[n + 1], 0.0)
    return highest


def has_recurrence(s: Lanes) -> N:
    """Return whether friction is constant or a table of slip, and no force but weight depends on the rotation."""
    return s.has.net_sine and not s.has.loss_rate


def expand_by_recurrence(s: Lanes, room: V, which: M) -> N:
    """Compute the series of a step up to ``room``, or the estimated end of motion, and return their highest order."""
    s.series.omega[0] = s.omega
    order = where(which, s.order, 3.0)
    top: N = greatest(order)
    find_series(s, top)
    s.step = look_for_end(s, room)
    keep_significant(s, which, top)
    return truncate(s, top)


def expand_contact(s: Lanes, top: N) -> None:
    """Compute the series of the normal force and of the dip, whose roots are lift-off and an upright chord."""
    e = s.series.omega
    lag, versine = turned(s.x)
    odd = s.x - lag
    even = 1.0 - versine
    force = 1.0 * s.normal0
    dip = 1.0 * s.normal_load
    for n in up(0, top - 1):
        turned_force = s.normal_sine * odd + s.normal_vers * versine
        if s.has.normal:
            s.series.normal[n] = force + turned_force + s.normal_square * e[n]
        if s.has.upright:
            s.series.upright[n] = dip + (s.upright_sine * odd + s.upright_vers * versine)
        odd_before = odd
        odd = even * s.inverse[n + 1]
        even = -odd_before * s.inverse[n + 1]
        versine = -even
        force = 0.0
        dip = 0.0


def may_lose_contact(s: Lanes, here: M, top: N) -> M:
    """Return lanes that may lift off or whose chord may become upright in a step, after computing these series."""
    lag, versine = turned(s.x + s.step)
    f = new_series()
    f[0] = s.x + s.step
    f[2] = versine
    f[3] = lag
    unsure = here and not (s.lifted == 0.0 and stays_in_contact(s, f))
    if any_lane(unsure):
        expand_contact(s, top)
    return unsure
