"""Values and roots of polynomials p[0] to p[n] in the time of a step."""

from derive.flow.integrator.one_lane import (
    EPS,
    INFINITY,
    M,
    N,
    S,
    V,
    any_lane,
    down,
    new_series,
    number,
    tail,
    up,
    where,
)

LAST_STEP = 2.0**-30  # relative step of Newton's method after which the next one would be below rounding
MOST_ITERATIONS = 200


def value(p: S, n: N, t: V) -> V:
    """Return the value at time t of the polynomial with coefficients p[0] to p[n], by Horner's scheme."""
    total = p[n]
    for k in down(n - 1, 0):
        total = total * t + p[k]
    return total


def increment(p: S, n: N, t: V) -> V:
    """Return the value minus the constant term, without cancellation."""
    return t * value(tail(p), n - 1, t) if n > 0 else 0.0


def value_and_slope(p: S, n: N, t: V) -> tuple[V, V]:
    """Return the value and the derivative at a time."""
    total = p[n]
    slope: V = 0.0
    for k in down(n - 1, 0):
        slope = slope * t + total
        total = total * t + p[k]
    return total, slope


def differentiate(rates: S, p: S, n: N) -> None:
    """Compute the coefficients of the derivative."""
    for k in up(1, n):
        rates[k - 1] = p[k] * number(k)


def shift(p: S, n: N, by: V) -> None:
    """Shift a polynomial to another origin: Taylor's shift by Horner's scheme."""
    for first in up(0, n - 1):
        for j in down(n - 1, first):
            p[j] = p[j] + by * p[j + 1]


def inside_or_middle(at: V, low: V, high: V) -> V:
    """Return a place if it lies between two bounds, otherwise their middle."""
    return where(at >= low and at <= high, at, 0.5 * (low + high))


def bracketed_root(p: S, n: N, low: V, at_low: V, high: V, at_high: V, which: M) -> V:
    """Return a root between bounds at which values have opposite signs.

    Newton's method starts where the chord crosses zero, and bisects if a step leaves the bounds.
    """
    falls = at_low > 0.0
    share = at_low / (at_low - at_high)
    chord = low + (high - low) * share
    at = inside_or_middle(chord, low, high)
    count: N = 0
    while any_lane(which) and count < MOST_ITERATIONS:
        residual, slope = value_and_slope(p, n, at)
        beyond = (residual > 0.0) != falls
        low = where(beyond, low, at)
        high = where(beyond, at, high)
        following = inside_or_middle(at - residual / slope, low, high)
        following = where(residual == 0.0, at, following)
        change = abs(following - at)
        at = where(which, following, at)
        which = which and change > LAST_STEP * abs(following)
        count = count + 1
    return at


def first_root(p: S, n: N, h: V, which: M) -> V:
    """Return the first zero in (0, h] of initially positive polynomials, infinity without a zero.

    Within a step the terms decrease like 0.2^k. A polynomial that has the same sign at h, and does not fall at first
    and rise at the end, therefore has no root. If it falls and rises, its least value decides. A polynomial that only
    touches zero does not cross it, and the zero polynomial has no root.
    """
    high = h
    last, slope = value_and_slope(p, n, h)
    crosses = which and (last < 0.0 or (last == 0.0 and p[0] > 0.0))
    dips = which and not crosses and p[1] < 0.0 and slope > 0.0
    if any_lane(dips):
        rates = new_series()
        differentiate(rates, p, n)
        lowest = bracketed_root(rates, n - 1, 0.0, rates[0], h, slope, dips)
        least = value(p, n, lowest)
        terms = abs(p[n])
        for k in down(n - 1, 0):
            terms = terms * h + abs(p[k])
        below = dips and least < -4.0 * EPS * terms
        high = where(below, lowest, high)
        last = where(below, least, last)
        crosses = crosses or below
    root: V = INFINITY
    if any_lane(crosses):
        root = where(crosses, bracketed_root(p, n, 0.0, p[0], high, last, crosses), root)
    return root


def margin_of(e: S, p: S, n: N, sign: V, constant: V, divided: M) -> None:
    """Compute the coefficients of sign p + constant, divided by the time if its root at 0 is to be removed."""
    for k in up(0, n):
        e[k] = sign * p[k]
    e[0] = e[0] + constant
    if any_lane(divided):
        for k in up(0, n - 1):
            e[k] = where(divided, e[k + 1], e[k])
        e[n] = where(divided, 0.0, e[n])


def crossing(p: S, n: N, t: V, sign: V, constant: V, divided: M, here: M) -> V:
    """Return the first time in (0, t] at which sign p + constant falls through zero, infinity without a zero.

    A root at 0 is removed where it is to be ``divided`` out.
    """
    last, slope = value_and_slope(p, n, t)
    falls_and_rises = sign * p[1] < 0.0 and sign * slope > 0.0
    asked = here and (sign * last + constant <= 0.0 or falls_and_rises or divided)
    at: V = INFINITY
    if any_lane(asked):
        e = new_series()
        margin_of(e, p, n, sign, constant, divided)
        at = first_root(e, n, t, asked)
    return at


def falling_root(p: S, n: N, t: V, last: V, slope: V, here: M) -> V:
    """Return the zero in (0, t] at which polynomials become negative, possibly beyond a maximum, otherwise infinity.

    ``last`` and ``slope`` are the value and the derivative at t.
    """
    touches = p[0] == 0.0
    positive = p[0] > 0.0 or (touches and p[1] > 0.0)
    dips = p[1] < 0.0 and slope > 0.0
    falls = here and positive and (last < 0.0 or dips)
    e = new_series()
    root: V = INFINITY
    if any_lane(falls):
        margin_of(e, p, n, 1.0, 0.0, touches)
        root = first_root(e, n, t, falls)
    rises = p[0] < 0.0 and p[1] > 0.0
    hump = here and rises and last < 0.0 and slope < 0.0
    if any_lane(hump):
        differentiate(e, p, n)
        top = bracketed_root(e, n - 1, 0.0, e[0], t, slope, hump)
        most = value(p, n, top)
        hump = hump and most > 0.0
        if any_lane(hump):
            root = where(hump, bracketed_root(p, n, top, most, t, last, hump), root)
    return root
