"""Many circles through grounds of straight edges: where they cross, what lies between, and its moments. Arrays only.

A *stretch* is the part of the ground between two neighbouring crossings that lies inside the circle; the mass hangs
between it and the arc below. Everything is over R and from the centre; n circles stand before E edges.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import slopes
from slipcircle.base.checks import EPS, two_sum

Floats = NDArray[np.float64]
_GAUSS = [((1.0 + x) / 2, w / 2) for x, w in zip(*np.polynomial.legendre.leggauss(slopes.NODES), strict=True)]
MEASURES = ("area", "polar", "inertia", "radial_x", "radial_y", "moment_x", "moment_y")
_BLOCK = 1 << 14  # edges at a time: their arrays stay in the cache
DoubleDouble = tuple[Any, Any]  # a number as the sum of two doubles (Dekker 1971), about 32 digits


def _halves(a: Any) -> DoubleDouble:
    high = 134217729.0 * a
    high = high - (high - a)
    return high, a - high


def _product(a: Any, b: Any) -> DoubleDouble:
    value, (a1, a2), (b1, b2) = a * b, _halves(a), _halves(b)
    return value, ((a1 * b1 - value) + a1 * b2 + a2 * b1) + a2 * b2


def _plus(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble:
    high, low = two_sum(a[0], b[0])
    return two_sum(high, low + (a[1] + b[1]))


def _times(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble:
    high, low = _product(a[0], b[0])
    return two_sum(high, low + (a[0] * b[1] + a[1] * b[0]))


def _clearance(x: DoubleDouble, y: DoubleDouble, radius: Any) -> DoubleDouble:
    """R^2 - x^2 - y^2, which is small for points near the circle."""
    squares = _plus(_times(x, x), _times(y, y))
    return _plus(_product(radius, radius), (-squares[0], -squares[1]))


class Cut(NamedTuple):
    """The parts of a ground's edges that lie inside circles, each from left to right, (n, E)."""

    x: Floats  # first end
    y: Floats
    e_x: Floats  # from the first end to the second; 0 where the edge is outside
    e_y: Floats
    first: Floats  # 1 - rho^2 at both ends, 0 on the circle
    second: Floats
    stretch: NDArray[np.int64]  # number of the stretch that the part belongs to, from 0; -1 before the first crossing
    enters: NDArray[np.bool_]  # whether the ground enters or leaves the circle here
    leaves: NDArray[np.bool_]

    def only(self, lanes: Any) -> "Cut":
        """The same of some circles."""
        return Cut(*(part[lanes] for part in self))


def cut(points: Floats, centre: Floats, radius: Floats) -> Cut:
    """Cut grounds (n or 1, V, 2) by circles (n, 2), (n,).

    A vertex as near to a circle as rounding of its coordinates goes lies on it, and parts two stretches.
    """
    r = radius[:, None]
    x, y = (points[..., k] - centre[:, k, None] for k in (0, 1))
    clear = r * r - x * x - y * y
    near = np.nonzero(np.abs(clear) < 0.1 * r * r)  # where a difference of near equals takes two doubles
    some, about = np.broadcast_to(points, (*clear.shape, 2))[near].T, -centre[near[0]].T
    clear[near] = _clearance(two_sum(some[0], about[0]), two_sum(some[1], about[1]), radius[near[0]])[0]
    blur = 32 * EPS * r * (r + np.abs(points).max(axis=2) + np.abs(centre).max(axis=1)[:, None])
    inside = clear > blur
    in_1, in_2 = inside[:, :-1], inside[:, 1:]
    edge = np.diff(points, axis=1)
    u, v = (np.broadcast_to(edge[..., k], in_1.shape) for k in (0, 1))
    g1, g2 = np.where(inside, clear, 0.0)[:, :-1], np.where(inside, clear, 0.0)[:, 1:]
    x1, y1 = x[:, :-1], y[:, :-1]
    start, share = np.zeros(in_1.shape), (in_1 & in_2).astype(np.float64)
    # One end inside: the positive root of D s^2 + 2 b s = g, from the end that is inside.
    lanes = np.nonzero(in_1 != in_2)
    back = in_2[lanes]
    sign, k = np.where(back, -1.0, 1.0), (lanes[0], lanes[1] + back)
    b = sign * (x[k] * u[lanes] + y[k] * v[lanes])
    d, g = u[lanes] ** 2 + v[lanes] ** 2, clear[k]
    root = np.sqrt(b * b + d * g)
    s = np.minimum(np.where(b > 0.0, g / (b + root), (root - b) / d), 1.0)
    share[lanes], start[lanes] = s, np.where(back, 1.0 - s, 0.0)
    # Both outside, the foot of the perpendicular between them: the discriminant may be small, and takes two doubles.
    dot = x1 * u + y1 * v
    lanes = np.nonzero(~in_1 & ~in_2 & (dot < 0.0) & (dot + u * u + v * v > 0.0))
    if lanes[0].size:
        row = np.broadcast_to(points, (len(radius), *points.shape[1:]))[lanes[0]]
        p, q = row[np.arange(len(row)), lanes[1]], row[np.arange(len(row)), lanes[1] + 1]
        e = [two_sum(q[:, k], -p[:, k]) for k in (0, 1)]
        at = [two_sum(p[:, k], -centre[lanes[0], k]) for k in (0, 1)]
        b2 = _plus(_times(at[0], e[0]), _times(at[1], e[1]))
        d2 = _plus(_times(e[0], e[0]), _times(e[1], e[1]))
        disc = _plus(_times(b2, b2), _times(d2, _clearance(at[0], at[1], radius[lanes[0]])))[0]
        root, d = np.sqrt(np.maximum(disc, 0.0)), d2[0]
        s = np.maximum((-b2[0] - root) / d, 0.0)
        share[lanes], start[lanes] = np.minimum(2 * root / d, 1.0 - s), s
    through = ~in_1 & ~in_2 & (share > 0.0)
    enters, leaves = (~in_1 & in_2) | through, (in_1 & ~in_2) | through
    stretch = np.cumsum(enters, axis=1) - 1
    per_r, per_r2 = 1.0 / r, 1.0 / (r * r)
    return Cut(
        (x1 + start * u) * per_r,
        (y1 + start * v) * per_r,
        share * u * per_r,
        share * v * per_r,
        g1 * per_r2,
        g2 * per_r2,
        stretch,
        enters,
        leaves,
    )


def stretches(parts: Cut) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.bool_]]:
    """Circle and number of every whole stretch; and which circles hold an end of the ground."""
    count = parts.leaves.sum(axis=1) - (parts.leaves & (parts.stretch < 0)).any(axis=1)
    lanes = np.repeat(np.arange(len(count)), count)
    number = np.arange(len(lanes)) - np.repeat(np.cumsum(count) - count, count)
    open_ended = (parts.leaves & (parts.stretch < 0)).any(axis=1) | (parts.enters.sum(axis=1) > count)
    none = (parts.first[:, 0] > 0.0) & (parts.second[:, -1] > 0.0) & ~parts.leaves.any(axis=1)
    return lanes, number, open_ended | none


def ends(parts: Cut, number: Any) -> tuple[Floats, Floats]:
    """The left and the right crossing of one stretch for each circle, (2, n) each."""
    mine, each = parts.stretch == np.asarray(number)[:, None], np.arange(len(parts.x))
    i, j = (each, np.argmax(parts.enters & mine, axis=1)), (each, np.argmax(parts.leaves & mine, axis=1))
    return np.stack([parts.x[i], parts.y[i]]), np.stack([parts.x[j] + parts.e_x[j], parts.y[j] + parts.e_y[j]])


def moments(parts: Cut, mine: NDArray[np.bool_]) -> dict[str, Floats]:
    """Integrals of ``MEASURES`` over the mass under the parts that are meant, (n, E), for each circle.

    Source: `generated.slopes`; about 1e-15 of each, of radial and moment: of the vector's length.
    """
    n, count = mine.shape
    out = np.zeros((len(MEASURES), n))
    rows = max(1, _BLOCK // max(count, 1))
    for k in range(0, n, rows):
        some = slice(k, k + rows)
        out[:, some] = _moments(parts.only(some), mine[some])
    return dict(zip(MEASURES, out, strict=True))


def _moments(parts: Cut, mine: NDArray[np.bool_]) -> Floats:
    """The same of one block."""
    x, y = parts.x, parts.y
    u, v = np.where(mine, parts.e_x, 0.0), np.where(mine, parts.e_y, 0.0)
    d2 = u * u + v * v
    far = np.hypot(x, y) + np.hypot(x + u, y + v)
    long = d2 > (slopes.REACH * far) ** 2
    cross = np.where(long, 0.0, x * v - y * u)
    near = np.where(long, 0.0, 1.0)
    first, second, bulge = parts.first * near, parts.second * near, d2 * near
    sums = [np.zeros(x.shape) for _ in range(7)]
    for s, w in _GAUSS:
        values = slopes.rings((1.0 - s) * first + s * second + (s * (1.0 - s)) * bulge)
        for total, value in zip(sums, (*values, s * values[3], s * values[4]), strict=True):
            total += w * value
    area, polar, inertia, radial, moment, radial_s, moment_s = sums
    by_edge = np.array(
        [
            area,
            polar,
            inertia,
            radial * x + radial_s * u,
            radial * y + radial_s * v,
            moment * x + moment_s * u,
            moment * y + moment_s * v,
        ]
    )
    total = (by_edge * cross).sum(axis=2)
    lanes = np.nonzero(long)
    if lanes[0].size:
        a, b, c, d = x[lanes], y[lanes], u[lanes], v[lanes]
        angle = np.arctan2(a * d - b * c, a * (a + c) + b * (b + d))
        for into, value in zip(total, slopes.closed(a, b, c, d, angle), strict=True):
            into += np.bincount(lanes[0], value, len(into))
    return total


def thickness(parts: Cut, mine: NDArray[np.bool_]) -> Floats:
    """The greatest distance from the arc to the ground towards the centre, for each circle."""
    d2 = parts.e_x**2 + parts.e_y**2
    along = -(parts.x * parts.e_x + parts.y * parts.e_y)
    with np.errstate(divide="ignore", invalid="ignore"):
        s = np.where((along > 0.0) & (along < d2), along / d2, 0.0)  # foot of the perpendicular
    inner = (1.0 - s) * parts.first + s * parts.second + s * (1.0 - s) * d2
    g = np.minimum(np.where(mine, np.maximum(np.maximum(parts.first, parts.second), inner), 0.0).max(axis=1), 1.0)
    return g / (1.0 + np.sqrt(1.0 - g))


def below_ground(parts: Cut, mine: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Which circles have their centre below the ground of the stretch."""
    over: NDArray[np.bool_] = (
        (parts.x <= 0.0) & (parts.x + parts.e_x >= 0.0) & (parts.x * parts.e_y <= parts.y * parts.e_x)
    )
    return np.any(mine & over & (parts.e_x > 0.0), axis=1)
