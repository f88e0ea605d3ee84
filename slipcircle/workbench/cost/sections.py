"""What sections cost: this package beside Gauss quadrature of the definition and shapely, judged by 24 digits.

A million circles through one ground of ten edges, in blocks, so that memory is bounded. Shapely gives area and centroid
of polygons, and is judged by these alone.
"""

import json
from collections.abc import Callable
from decimal import Decimal
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from slipcircle.core.scene import circles
from slipcircle.core.scene.circles import MEASURES
from slipcircle.core.scene.ground import circle_through
from slipcircle.core.scene.section import Section
from slipcircle.workbench.cost.reference import Floats, reference
from slipcircle.workbench.cost.ways import Subject, Way

# `MEASURES` of the sections of `drawn(COUNT)`, to 24 digits; ``python tests/exact_scenes.py`` writes them.
ANSWERS, COUNT = Path(__file__).with_name("sections.json"), 12
PATIENCE = 80.0  # of a pass, as of `Subject`: a million sections of ours take less
_X = np.linspace(-60.0, 60.0, 11)
GROUND = np.stack([_X, 10.0 - _X / 5 + 1.5 * np.sin(_X / 9)], axis=1)
_BLOCK, _GAUSS, _SEGMENTS = 1 << 13, (4, 8, 16), (8, 64, 512)


def drawn(count: int) -> Floats:
    """Centres and radii of circles that enter near one end of the ground and leave near the other, (3, n)."""
    rng = np.random.default_rng(16)
    x = rng.uniform([[-59], [50]], [[-50], [59]], (2, count))
    p, q = np.stack([x, np.interp(x, *GROUND.T)], axis=2)
    centre, radius = circle_through(p, q, depth=rng.uniform(0.1, 0.3, count) * np.hypot(*(q - p).T))
    return np.stack([*centre.T, radius])


# --- ways ------------------------------------------------------------------------------------------------------------


def blocks(one: Callable[[Floats, Floats], Floats], x: Any, y: Any, radius: Any) -> Floats:
    """`MEASURES` of sections, a block of circles at a time, (7, n)."""
    circle = np.stack([np.atleast_1d(v) for v in (x, y, radius)])
    found = np.empty((len(MEASURES), circle.shape[1]))
    for k in range(0, circle.shape[1], _BLOCK):
        some = circle[:, k : k + _BLOCK]
        found[:, k : k + _BLOCK] = one(some[:2].T, some[2])
    return found


def bare(centre: Floats, radius: Floats) -> Floats:
    """By the functions over arrays: where the circles cut, and the moments."""
    parts = circles.cut(GROUND[None], centre, radius)
    return np.array(list(circles.moments(parts, parts.stretch == 0).values()))


def whole(centre: Floats, radius: Floats) -> Floats:
    """By a `Section`, which checks what it is given."""
    m = (found := Section(GROUND, centre, radius, 2e4)).moments
    return np.array(
        [
            found.area / radius**2,
            m["polar_moment"],
            m["moment_of_inertia"],
            found.facing * m["radial_weight_slope"],
            -m["radial_weight"],
            -found.facing * m["weight_moment"],
            -m["weight_moment_slope"],
        ]
    )


def gauss(points: int, centre: Floats, radius: Floats) -> Floats:
    """The double integrals of the definitions over vertical strips under each edge, by Gauss-Legendre both ways."""
    parts = circles.cut(GROUND[None], centre, radius)
    nodes, weights = np.polynomial.legendre.leggauss(points)
    found = np.zeros((len(MEASURES), len(radius)))
    for s, w in zip((1 + nodes) / 2, weights / 2, strict=True):
        x, top = parts.x + s * parts.e_x, parts.y + s * parts.e_y
        floor = -np.sqrt(1.0 - x * x)
        for t, v in zip((1 + nodes) / 2, weights / 2, strict=True):
            y = floor + t * (top - floor)
            r, share = np.hypot(x, y), w * v * parts.e_x * (top - floor)
            found += [(share * f).sum(axis=1) for f in (1.0, r, r * r, x / r, y / r, x, y)]
    return found


def polygons(segments: int, centre: Floats, radius: Floats) -> Floats:
    """Area and centroid by shapely, of a circle of four times so many chords."""
    import shapely  # type: ignore[import-not-found, import-untyped, unused-ignore]

    soil = shapely.Polygon([*GROUND, (GROUND[-1, 0], -1e3), (GROUND[0, 0], -1e3)])
    cut = shapely.intersection(shapely.buffer(shapely.points(centre), radius, quad_segs=segments), soil)
    middle, area = shapely.centroid(cut), shapely.area(cut) / radius**2
    found = np.full((len(MEASURES), len(radius)), np.nan)
    found[0] = area
    for row, of, x in ((5, shapely.get_x, centre[:, 0]), (6, shapely.get_y, centre[:, 1])):
        found[row] = area * (of(middle) - x) / radius
    return found


def subject() -> Subject:
    """Ways to the moments of sections."""
    found = [
        Way("slipcircle, arrays", partial(blocks, bare), ours=True),
        Way("slipcircle, Section", partial(blocks, whole), ours=True),
        *(Way(f"Gauss, {n} x {n} points", partial(blocks, partial(gauss, n))) for n in _GAUSS),
        *(Way(f"shapely, {4 * n} chords", partial(blocks, partial(polygons, n)), needs="shapely") for n in _SEGMENTS),
    ]
    known = [[*map(Decimal, row)] for row in json.loads(ANSWERS.read_text("utf-8"))]
    size = np.abs(np.array(known, dtype=np.float64))
    for pair in ([3, 4], [5, 6]):  # radial and moment: of their length as vectors
        size[pair] = np.hypot(*size[pair])
    exact = reference(drawn(COUNT), known, size=size)
    return Subject("sections", found, lambda kind: exact, drawn, patience=PATIENCE, weighed=True)
