"""Moments of the mass under any ground, against strips in ball arithmetic, exact rationals, limits and invariances."""

import math

import numpy as np
import pytest
from flint import arb
from strips import integrals

from slipcircle.scene import circles
from slipcircle.scene.circles import MEASURES
from slipcircle.scene.ground import circle_through, circle_touching, simple_slope
from slipcircle.scene.section import Section

LENGTHS = {"radial_x": ("radial_x", "radial_y"), "radial_y": ("radial_x", "radial_y"),
           "moment_x": ("moment_x", "moment_y"), "moment_y": ("moment_x", "moment_y")}  # fmt: skip
BOUND = 1e-13  # of the moment; of weights, of their vector's length
Ground = list[tuple[float, float]]


def moments(ground: Ground, centre: tuple[float, float], radius: float) -> dict[str, float]:
    """As the run time computes them, of all that lies inside the circle."""
    parts = circles.cut(np.array([ground]), np.array([centre]), np.array([radius]))
    return {k: float(v[0]) for k, v in circles.moments(parts, parts.stretch >= 0).items()}


def worst(ground: Ground, centre: tuple[float, float], radius: float) -> float:
    """The greatest error of all measures."""
    ours, truth = moments(ground, centre, radius), integrals(ground, centre, radius)
    found = 0.0
    for name in MEASURES:
        size = math.hypot(*(float(truth[k].mid()) for k in LENGTHS.get(name, (name,))))
        error = abs(arb(ours[name]) - truth[name])
        assert error.rad() < 1e-16 * size, name  # the reference is good enough to judge
        found = max(found, float(error.mid()) / size)
    return found


def bumpy(rng: np.random.Generator, edges: int) -> tuple[Ground, tuple[float, float], float]:
    """A random profile and a circle that cuts it once."""
    while True:
        x = np.sort(rng.uniform(-1.5, 1.5, edges + 1))
        y = rng.uniform(-0.6, 0.6) * x + rng.uniform(0, 0.25) * rng.standard_normal(edges + 1)
        ground = list(zip(x.tolist(), y.tolist(), strict=True))
        centre, radius = (float(rng.uniform(-0.4, 0.4)), float(rng.uniform(0.3, 2.0))), float(rng.uniform(0.8, 2.5))
        parts = circles.cut(np.array([ground]), np.array([centre]), np.array([radius]))
        lanes, _, held = circles.stretches(parts)
        above = np.interp(centre[0], x, y) < centre[1] and all(y < 0 for _, (y,) in circles.ends(parts, [0]))
        if len(lanes) == 1 and not held[0] and above and moments(ground, centre, radius)["area"] > 1e-3:
            return ground, centre, radius


def thin(depth: float, bend: float) -> tuple[Ground, tuple[float, float], float]:
    """A skin of a depth over R, its ground bent by shares of the depth."""
    half = math.sqrt(2 * depth)
    ground = [(-2 * half, 0.0), (-half / 3, bend * depth), (half / 5, -bend * depth / 2), (2 * half, 0.0)]
    return ground, (0.3 * half, 1.0 - depth), 1.0


HARD = {
    "scarp": ([(-2.0, 0.5), (-0.3, 0.5), (-0.3, -0.4), (2.0, -0.4)], (0.1, 1.0), 1.7),
    "overhang": ([(-2.0, 0.5), (-0.1, 0.55), (-0.5, 0.1), (0.2, -0.3), (2.0, -0.3)], (0.2, 1.0), 1.8),
    "edge of 1e-9 R": ([(-2.0, 0.4), (-0.2, 0.3), (-0.2 + 1e-9, 0.3 - 0.7e-9), (2.0, -0.6)], (0.1, 1.0), 1.9),
    "edge of 1e-9 R, upright": ([(-2.0, 0.4), (-0.2, 0.3), (-0.2, 0.3 - 1e-9), (2.0, -0.6)], (0.1, 1.0), 1.9),
    "near-radial": ([(-2.0, -0.1), (0.18, -0.18), (0.7, -0.7005), (2.0, -0.8)], (0.0, 0.0), 1.25),
    "radial": ([(-2.0, -0.1), (0.25, -0.25), (0.75, -0.75), (2.0, -0.8)], (0.0, 0.0), 1.5),
    "centre next to an edge": ([(-2.0, -0.3), (-0.5, -0.2), (0.5, 0.2 - 1e-9), (0.9, -0.3), (2.0, -0.4)],
                               (0.0, 0.0), 1.3),
    "centre next to an edge's line": ([(-2.0, -0.1), (1e-3, -1e-3 - 1e-12), (0.5, -0.5), (2.0, -0.5)], (0.0, 0.0), 1.3),
    "half disc": ([(-2.0, 0.0), (2.0, 0.0)], (0.0, 1e-7), 1.25),
    "far from the origin": ([(4.5e6, 1200.5), (4.5e6 + 40, 1200.0), (4.5e6 + 70, 1180.0), (4.5e6 + 150, 1179.0)],
                            (4.5e6 + 75.25, 1230.0), 52.0),
}  # fmt: skip


@pytest.mark.parametrize("name", HARD)
def test_moments_of_hard_sections(name: str) -> None:
    assert worst(*HARD[name]) < BOUND


def test_beyond_a_half_disc_the_rest_of_the_disc_is_missing() -> None:
    ground = [(-2.0, 0.3), (0.0, -0.25), (2.0, 0.5)]
    names = ("area", "inertia", "radial_y", "moment_x", "moment_y")  # the others have a logarithm at the centre
    ours = moments(ground, (0.0, 0.0), 1.25)
    rest = integrals([(x, -y) for x, y in ground], (0.0, 0.0), 1.25, names)
    whole = {"area": math.pi, "polar": 2 * math.pi / 3, "inertia": math.pi / 2}
    for name in names:
        sign = 1 if name.endswith("_y") else -1
        assert ours[name] == pytest.approx(whole.get(name, 0.0) + sign * float(rest[name].mid()), abs=1e-14)


def test_moments_of_random_sections() -> None:
    rng = np.random.default_rng(16)
    assert max(worst(*bumpy(rng, int(rng.integers(2, 12)))) for _ in range(25)) < BOUND


@pytest.mark.parametrize("depth", [1e-1, 1e-2, 1e-4, 1e-6, 1e-8])
@pytest.mark.parametrize("bend", [0.0, 0.4])
def test_moments_of_thin_masses(depth: float, bend: float) -> None:
    ground, centre, radius = thin(depth, bend)
    assert worst(ground, centre, radius) < BOUND
    found = Section(ground, centre, radius, 2e4)
    assert found.depth == pytest.approx(radius * depth * (1.0 + 0.4 * bend), rel=0.5)


def test_lanes_are_single_sections() -> None:
    rng = np.random.default_rng(5)
    grounds, centres, radii = zip(*(bumpy(rng, 7) for _ in range(6)), strict=True)
    many = Section(np.array(grounds), np.array(centres), np.array(radii), 2e4)
    assert many.shape == (6,)
    for k in range(6):
        one = Section(grounds[k], centres[k], radii[k], 2e4)
        for name in (
            "area",
            "centroid",
            "entry",
            "exit",
            "half_angle",
            "depth",
            "facing",
            "mean_cover",
            "chord",
            "dip",
        ):
            assert np.array_equal(getattr(many, name)[k], getattr(one, name)), name
        assert [v[k] for v in many.weights] == pytest.approx(list(one.weights), rel=1e-15)
    common = Section(simple_slope(10.0, run=20.0), np.array([[[0.0, 20.0], [0.5, 20.0]], [[0.0, 21.0], [-1.0, 22.0]]]),
                     np.array([[20.0], [23.0]]), 2e4)  # fmt: skip
    assert common.area.shape == (2, 2)
    assert common.centroid.shape == (2, 2, 2)


def test_circles_as_people_give_them() -> None:
    p, q = (3.0, 12.0), (25.0, 2.0)
    for centre, radius in (
        circle_through(p, q, radius=15.0),
        circle_through(q, p, depth=4.0),
        circle_touching(p, q, 0.5),
    ):
        assert np.hypot(*(centre - p)) == pytest.approx(radius)
        assert np.hypot(*(centre - q)) == pytest.approx(radius)
    middle = np.array([14.0, 7.0])
    centre, radius = circle_through(p, q, depth=4.0)
    assert radius - np.hypot(*(centre - middle)) == pytest.approx(4.0)
    centre, radius = circle_touching(p, q, 0.5)
    assert centre[1] - radius == pytest.approx(0.5)
    assert p[0] < centre[0] < q[0]
    for wrong in ({"radius": 5.0}, {"depth": 30.0}, {}, {"depth": 1.0, "radius": 20.0}):
        with pytest.raises(ValueError, match=r"radius|depth"):
            circle_through(p, q, **wrong)
    assert simple_slope(10.0, angle=math.pi / 4)[1] == pytest.approx([-10.0, 10.0])
    assert simple_slope(10.0, run=5.0)[1] == pytest.approx([-5.0, 10.0])
