"""Series of a step in powers of the rotation x since a phase began, with E = omega^2 in place of omega.

Under constant friction, or in one piece of a table of slip, the net moment over Theta* is

    net = drive + sine sin(x) + vers (1 - cos(x)) + square E + loss(x) weight,
    weight = load + load_sine sin(x) + load_vers (1 - cos(x)) + load_square E

where loss is a polynomial. With dE/dx = 2 net each coefficient of E follows from as many coefficients before it as the
polynomial has, without the operations on series of other programs. E has no singularity, so that a step may be as long
as the piece. If another step follows, a phase begins with it.
"""

from derive.flow.integrator.one_lane import (
    Kind,
    Lanes,
    M,
    N,
    S,
    V,
    any_lane,
    greatest,
    maximum,
    minimum,
    new_series,
    number,
    operate,
    operate_later,
    sqrt,
    up,
    where,
)
from derive.flow.integrator.series import begin_series, cut, next_term_counts

BEYOND = 1.125  # longest step in rotation over the path to the estimated end of the motion


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


def complete_net(s: Lanes, weight: S, n: N) -> None:
    """Add the parts that E and its weight cause to coefficient n of net moment and weight."""
    e = s.series.omega
    net = 1.0 * s.series.net[n]
    for t in s.tables:
        most: N = minimum(t.degree, n)
        for k in up(1, most):
            net = net + t.coefficients[k - 1] * weight[n - k]
    s.series.net[n] = net + s.net_square * e[n]
    weight[n] = weight[n] + s.net_loss_square * e[n]


def expand_contact(s: Lanes, top: N) -> None:
    """Compute the series of the normal force and of the dip of the chord."""
    if s.has.normal:
        normal = s.series.normal
        expand_force(s, normal, s.normal0, s.normal_sine, s.normal_vers, top)
        for n in up(0, top - 1):
            normal[n] = normal[n] + s.normal_square * s.series.omega[n]
    if s.has.upright:
        expand_force(s, s.series.upright, s.normal_load, s.upright_sine, s.upright_vers, top)


def look_for_end(s: Lanes, room: V) -> V:
    """Return the path beyond which a step in rotation is useless, as the mass rests, and store the size of terms.

    The end is estimated by a parabola. If it is too near, another step follows.
    """
    e = s.series.omega
    product = e[0] * e[2]
    square = e[1] * e[1] - 4.0 * product
    root = sqrt(maximum(square, 0.0))
    end = (e[1] + root) / (-2.0 * e[2])
    nearer = minimum(BEYOND * end, room)
    path = where(e[2] < 0.0, nearer, room)
    largest = maximum(abs(e[2]), path * abs(e[3]))
    largest = maximum(abs(e[1]), path * largest)
    s.largest_omega = maximum(abs(e[0]), path * largest)
    return path


def integrate_in_rotation(s: Lanes, weight: S, n: N) -> None:
    """Compute coefficient n of the net moment and n + 1 of the states."""
    e = s.series.omega
    if has_recurrence(s):
        complete_net(s, weight, n)
    if not has_recurrence(s):
        if s.has.square:
            s.series.square[n] = e[n]
        operate(s, n, n + 1, True, False)
        s.series.x[n + 1] = 1.0 if n == 0 else 0.0
    e[n + 1] = s.series.net[n] * (2.0 * s.inverse[n + 1])


def expand_in_rotation(s: Lanes, room: V, which: M) -> N:
    """Compute the series of a step up to ``room``, or the estimated end of motion, and return their highest order.

    A series ends as soon as two consecutive terms are negligible, unless water or loads are functions of the rotation,
    which may change faster than the motion.
    """
    early: N = True
    for t in s.tables:
        early = early and t.kind != Kind.ROTATION
    order = where(which, s.order, 3.0)
    top: N = greatest(order)
    weight = new_series()
    recurs: N = has_recurrence(s)
    begin_series(s)
    if recurs:
        expand_force(s, s.series.net, s.drive, s.net_sine, s.net_vers, top)
        expand_force(s, weight, s.net_loss, s.net_loss_sine, s.net_loss_vers, top)
    last: V = 0.0
    power: V = 0.0
    goes_on = which
    n: N = 0
    while n < top and any_lane(goes_on):
        integrate_in_rotation(s, weight, n)
        n = n + 1
        power = power * s.step
        counts = which
        if early and n > 3:
            counts = next_term_counts(s, n, power, False)
        if n == 3:
            s.step = look_for_end(s, room)
            power = s.step * s.step * s.step
        last = where(counts, number(n), last)
        goes_on = goes_on and last > number(n - 2)
    order = where(last < order - 1.0, maximum(last, 3.0), order)
    top = greatest(order)
    if recurs:
        expand_contact(s, top)
    if not recurs:
        operate_later(s, top)
    cut(s, order, top)
    s.series_order = order
    return top
