"""Series of E = omega^2 in the rotation x since a phase began, by a recurrence without products of series.

Under constant friction, or in one piece of a table of slip, the net moment over Theta* is

    net = drive + sine sin(x) + vers (1 - cos(x)) + square E + loss(x) weight,
    weight = load + load_sine sin(x) + load_vers (1 - cos(x)) + load_square E

where loss is a polynomial. With dE/dx = 2 net each coefficient of E follows from as many coefficients before it as the
polynomial has. E has no singularity, so that a step may be as long as the piece. If another step follows, a phase begins
with it.
"""

from derive.flow.integrator.one_lane import (
    Lanes,
    M,
    N,
    S,
    V,
    greatest,
    maximum,
    minimum,
    new_series,
    number,
    up,
    where,
)
from derive.flow.integrator.series import cut, is_negligible, look_for_end


def has_recurrence(s: Lanes) -> N:
    """Return whether the net moment has this form."""
    return s.has.net_sine and not s.has.loss_rate


def expand_force(s: Lanes, p: S, start: V, sine: V, vers: V, top: N) -> None:
    """Compute the series of start + sine sin(x) + vers (1 - cos(x))."""
    p[0] = start
    p[1] = sine
    p[2] = 0.5 * vers
    for n in up(3, top):
        p[n] = -p[n - 2] * (s.inverse[n] * s.inverse[n - 1])


def expand_energy(s: Lanes, weight: S, n: N) -> None:
    """Compute coefficient n of the net moment and n + 1 of E. ``weight`` is the series of the weight."""
    e = s.series.omega
    whole = 1.0 * s.series.net[n]
    for t in s.tables:
        most: N = minimum(t.degree, n)
        for k in up(1, most):
            whole = whole + t.coefficients[k - 1] * weight[n - k]
    whole = whole + s.net_square * e[n]
    weight[n] = weight[n] + s.net_loss_square * e[n]
    s.series.net[n] = whole
    e[n + 1] = whole * (2.0 * s.inverse[n + 1])


def expand_contact(s: Lanes, top: N) -> None:
    """Compute the series of the normal force and of the dip, from E, up to the order of each lane."""
    if s.has.normal:
        normal = s.series.normal
        expand_force(s, normal, s.normal0, s.normal_sine, s.normal_vers, top)
        for n in up(0, top - 1):
            normal[n] = normal[n] + s.normal_square * s.series.omega[n]
    if s.has.upright:
        expand_force(s, s.series.upright, s.normal_load, s.upright_sine, s.upright_vers, top)
    cut(s, s.series_order, top)


def expand_by_recurrence(s: Lanes, room: V, which: M) -> N:
    """Compute the series of a step up to ``room``, or the estimated end of motion, and return their highest order.

    The series of a lane ends as soon as two consecutive terms are negligible.
    """
    e = s.series.omega
    weight = new_series()
    e[0] = s.omega
    order = where(which, s.order, 3.0)
    top: N = greatest(order)
    expand_force(s, s.series.net, s.drive, s.net_sine, s.net_vers, top)
    expand_force(s, weight, s.net_loss, s.net_loss_sine, s.net_loss_vers, top)
    for n in up(0, 2):
        expand_energy(s, weight, n)
    s.step = look_for_end(s, room)
    power = s.step * s.step * s.step
    last: V = 3.0
    m: N = 3
    goes_on = order > 3.0
    while any_lane(goes_on) and m < top:
        expand_energy(s, weight, m)
        m = m + 1
        power = power * s.step
        term = abs(e[m]) * power
        counts = goes_on and not is_negligible(s, term, s.largest_omega)
        s.largest_omega = maximum(term, s.largest_omega)
        last = where(counts, number(m), last)
        goes_on = goes_on and last > number(m - 2)
    order = where(last < order - 1.0, last, order)
    s.series_order = order
    top = greatest(order)
    expand_contact(s, top)
    return top
