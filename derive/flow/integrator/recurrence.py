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


def expand_energy(s: Lanes, top: N) -> None:
    """Compute the series of all registers that events use from E at the beginning of the phase."""
    e = s.series.omega
    net = s.series.net
    weight = new_series()
    e[0] = s.omega
    expand_force(s, net, s.drive, s.net_sine, s.net_vers, top)
    expand_force(s, weight, s.net_loss, s.net_loss_sine, s.net_loss_vers, top)
    for n in up(0, top - 1):
        weight[n] = weight[n] + s.net_loss_square * e[n]
        whole = net[n] + s.net_square * e[n]
        for t in s.tables:
            most: N = minimum(t.degree, n)
            for k in up(1, most):
                whole = whole + t.coefficients[k - 1] * weight[n - k]
        net[n] = whole
        e[n + 1] = 2.0 * whole * s.inverse[n + 1]
    if s.has.normal:
        normal = s.series.normal
        expand_force(s, normal, s.normal0, s.normal_sine, s.normal_vers, top)
        for n in up(0, top - 1):
            normal[n] = normal[n] + s.normal_square * e[n]
    if s.has.upright:
        expand_force(s, s.series.upright, s.normal_load, s.upright_sine, s.upright_vers, top)


def keep_significant(s: Lanes, which: M, top: N) -> N:
    """Remove the last terms of each lane's series if they are negligible in the step, and return the highest order."""
    e = s.series.omega
    power = s.step * s.step * s.step
    last: V = 3.0
    for n in up(4, top):
        power = power * s.step
        term = abs(e[n]) * power
        counts = not is_negligible(s, term, s.largest_omega)
        s.largest_omega = maximum(term, s.largest_omega)
        last = where(counts, number(n), last)
    order = where(last < s.order - 1.0, last, s.order)
    order = where(which, order, 3.0)
    highest: N = greatest(order)
    cut(s, order, highest)
    s.series_order = order
    return highest


def expand_by_recurrence(s: Lanes, room: V, which: M) -> N:
    """Compute the series of a step up to ``room``, or the estimated end of motion, and return their highest order."""
    top: N = greatest(where(which, s.order, 3.0))
    expand_energy(s, top)
    s.step = look_for_end(s, room)
    return keep_significant(s, which, top)
