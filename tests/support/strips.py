"""Integrals over the mass under a ground by vertical strips in ball arithmetic: no polar coordinate, no closed form.

Each edge of the ground carries the strip between it and the arc below, signed by its run, so overhangs take away what
they hang over. Coordinates are floats, taken as the exact numbers that they are.
"""

from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise

from flint import acb, arb, ctx

from slipcircle.ground.circles import MEASURES
from tests.support.oracle import exact

BITS = 220
Point = tuple[float, float]


def inside(p: tuple[arb, arb], q: tuple[arb, arb], radius: arb) -> tuple[arb, arb] | None:
    """Return the part of an edge inside the circle about the origin, as shares of it."""
    e = (q[0] - p[0], q[1] - p[1])
    a, b = e[0] ** 2 + e[1] ** 2, p[0] * e[0] + p[1] * e[1]
    disc = b * b - a * (p[0] ** 2 + p[1] ** 2 - radius**2)
    if not disc > 0:
        return None
    first, last = (-b - disc.sqrt()) / a, (-b + disc.sqrt()) / a
    low, high = (first if first > 0 else arb(0)), (last if last < 1 else arb(1))
    return (low, high) if low < high else None


def integrals(ground: Sequence[Point], centre: Point, radius: float, names: Iterable[str] = MEASURES) -> dict[str, arb]:
    """Return all of `MEASURES`, or some, of the mass inside the circle, over powers of R."""
    with ctx.workprec(BITS):
        cx, cy, r = exact(centre[0]), exact(centre[1]), exact(radius)
        points = [(exact(x) - cx, exact(y) - cy) for x, y in ground]
        total = dict.fromkeys(names, arb(0))
        for p, q in pairwise(points):
            part = inside(p, q, r)
            if part is None or (q[0] - p[0]).contains(0):
                continue
            for name in total:
                total[name] += strip(name, p, q, part, r)
        powers = {"area": 2, "radial_x": 2, "radial_y": 2, "inertia": 4}
        return {name: value / r ** powers.get(name, 3) for name, value in total.items()}


def strip(name: str, p: tuple[arb, arb], q: tuple[arb, arb], part: tuple[arb, arb], r: arb) -> arb:
    """Return the integral over the strip below one edge: elementary over y, and by quadrature over x."""
    inner = INNER[name]

    def column(s: acb, analytic: bool) -> acb:
        x, y = p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])
        floor = -((r * r - x * x).sqrt(analytic=analytic))
        top, low = ((x * x + y * y).sqrt(analytic=analytic), y), (acb(r), floor)
        grown = ((low[0] - floor) / (top[0] - y)).log(analytic=analytic)
        return (inner(x, y, top[0], grown) - inner(x, floor, acb(r), acb(0))) * (q[0] - p[0])

    value = acb.integral(column, part[0], part[1], rel_tol=arb(2) ** -170, abs_tol=arb(2) ** -200 * r**4).real
    return value


# Antiderivatives over y at x; the last argument is the integral of 1/r from the arc.
INNER: dict[str, Callable[[acb, acb, acb, acb], acb]] = {
    "area": lambda x, y, r, log: y,
    "polar": lambda x, y, r, log: (y * r + x * x * log) / 2,
    "inertia": lambda x, y, r, log: x * x * y + y**3 / 3,
    "radial_x": lambda x, y, r, log: x * log,
    "radial_y": lambda x, y, r, log: r,
    "moment_x": lambda x, y, r, log: x * y,
    "moment_y": lambda x, y, r, log: y * y / 2,
}
