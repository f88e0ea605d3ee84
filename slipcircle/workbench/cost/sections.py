"""What sections cost: this package beside Gauss quadrature of the definition and shapely, judged by 24 digits.

A million circles through one ground of ten edges, in blocks, so that memory is bounded. Shapely gives area and centroid
of polygons, and is judged by these alone; quadrature is given where the circle enters and leaves.
"""

import json
from collections.abc import Callable
from decimal import Decimal
from functools import partial
from pathlib import Path

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.ground import Section
from slipcircle.workbench.cost.reference import reference
from slipcircle.workbench.cost.ways import Subject, Way

# Area, integrals of r and r^2, of the unit vector (x, y)/r and of (x, y) over the mass, from the centre and over powers
# of the radius, of the sections of `drawn(COUNT)`, to 24 digits; ``tests.campaigns.exact_scenes`` writes them.
ANSWERS = Path(__file__).with_name("sections.json")
COUNT = 12
MEASURES = 7
PATIENCE = 80.0  # of a pass, as of `Subject`: a million sections of ours take less
_X = np.linspace(-60.0, 60.0, 11)
GROUND = np.stack([_X, 10.0 - _X / 5 + 1.5 * np.sin(_X / 9)], axis=1)
_BLOCK = 1 << 13
_GAUSS = (4, 8, 16)  # points in each direction
_SEGMENTS = (8, 64, 512)  # chords of a quarter of the circle
_BASE = -1e3  # m, below every circle


def drawn(count: int) -> Floats:
    """Circles that enter near one end of the ground and leave near the other: x, y, radius, and x of both ends."""
    rng = np.random.default_rng(16)
    left, right = rng.uniform([[-59], [50]], [[-50], [59]], (2, count))
    bottom, top = np.interp([left, right], *GROUND.T)
    width = right - left
    height = top - bottom
    chord = np.hypot(width, height)
    depth = rng.uniform(0.1, 0.3, count) * chord
    half_chord = chord / 2
    radius = half_chord**2 / (2 * depth) + depth / 2
    above = (radius - depth) / chord  # of the centre over the chord, in chords
    middle_x = left + width / 2
    middle_y = bottom + height / 2
    x = middle_x - above * height
    y = middle_y + above * width
    return np.stack([x, y, radius, left, right])


# --- ways ------------------------------------------------------------------------------------------------------------


def blocks(compute: Callable[..., Floats], *circles: Floats) -> Floats:
    """The measures of sections, a block of circles at a time, (7, n)."""
    columns = np.stack([np.atleast_1d(values) for values in circles])
    count = columns.shape[1]
    results = np.empty((MEASURES, count))
    for first in range(0, count, _BLOCK):
        block = slice(first, first + _BLOCK)
        results[:, block] = compute(*columns[:, block])
    return results


def section(x: Floats, y: Floats, radius: Floats, *_: Floats) -> Floats:
    """By a `Section`, which checks its input."""
    centre = np.stack([x, y], axis=1)
    mass = Section(GROUND, centre, radius, 2e4)
    moments, facing = mass.moments, mass.facing
    measures = [
        mass.area / radius**2,
        moments["polar_moment"],
        moments["moment_of_inertia"],
        facing * moments["radial_weight_slope"],
        -moments["radial_weight"],
        -facing * moments["weight_moment"],
        -moments["weight_moment_slope"],
    ]
    return np.array(measures)


def gauss(points: int, x: Floats, y: Floats, radius: Floats, left: Floats, right: Floats) -> Floats:
    """The double integrals of the definitions over vertical strips under each edge, by Gauss-Legendre both ways."""
    nodes, weights = np.polynomial.legendre.leggauss(points)
    shares = (1 + nodes) / 2
    halves = weights / 2
    rule = list(zip(shares, halves, strict=True))
    columns = np.array([x, y, radius, left, right])
    x, y, radius, left, right = columns[:, :, None]
    corners = np.clip(GROUND[:, 0], left, right)
    starts = corners[:, :-1]
    edges = np.diff(corners, axis=1)
    total = np.zeros((MEASURES, len(radius)))
    for share, weight in rule:
        across = starts + share * edges
        ground = np.interp(across, *GROUND.T)
        horizontal = (across - x) / radius
        bottom = -np.sqrt(1.0 - horizontal**2)
        top = (ground - y) / radius
        height = top - bottom
        width = weight * edges / radius
        strip = width * height
        for inner, inner_weight in rule:
            vertical = bottom + inner * height
            share_of_area = inner_weight * strip
            integrals = share_of_area * _measures(horizontal, vertical)
            total += integrals.sum(axis=2)
    return total


def _measures(across: Floats, up: Floats) -> Floats:
    """The integrands at places from the centre, over the radius: 1, r, r^2, the unit vector, and the place."""
    r = np.hypot(across, up)
    one = np.ones_like(r)
    return np.stack([one, r, r * r, across / r, up / r, across, up])


def polygons(segments: int, x: Floats, y: Floats, radius: Floats, *_: Floats) -> Floats:
    """Area and centroid by shapely, of a circle of four times so many chords."""
    import shapely  # type: ignore[import-not-found, import-untyped, unused-ignore]

    base = [(_X[-1], _BASE), (_X[0], _BASE)]
    soil = shapely.Polygon([*GROUND, *base])
    centres = shapely.points(x, y)
    discs = shapely.buffer(centres, radius, quad_segs=segments)
    masses = shapely.intersection(discs, soil)
    centroid = shapely.centroid(masses)
    area = shapely.area(masses) / radius**2
    results = np.full((MEASURES, len(radius)), np.nan)
    results[0] = area
    to_right = (shapely.get_x(centroid) - x) / radius
    upwards = (shapely.get_y(centroid) - y) / radius
    results[5] = area * to_right
    results[6] = area * upwards
    return results


def subject() -> Subject:
    """Ways to the moments of sections."""
    ways = [Way("slipcircle", partial(blocks, section), ours=True)]
    for points in _GAUSS:
        quadrature = partial(blocks, partial(gauss, points))
        ways.append(Way(f"Gauss, {points} x {points} points", quadrature))
    for segments in _SEGMENTS:
        cut = partial(blocks, partial(polygons, segments))
        ways.append(Way(f"shapely, {4 * segments} chords", cut, needs="shapely"))
    digits = json.loads(ANSWERS.read_text("utf-8"))
    known = [[*map(Decimal, row)] for row in digits]
    values = np.array(known, dtype=np.float64)
    size = np.abs(values)
    for pair in ([3, 4], [5, 6]):  # components of a vector: relative to its length
        size[pair] = np.hypot(*size[pair])
    exact = reference(drawn(COUNT), known, size=size)
    return Subject("sections", ways, lambda kind: exact, drawn, patience=PATIENCE, weighed=True)
