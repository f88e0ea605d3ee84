"""Moments of the mass under any ground, against strips in ball arithmetic, exact rationals, limits and invariances."""

import math
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from flint import arb

from generated import kernels
from slipcircle.core.scene import circles
from slipcircle.core.scene.arc import Arc
from slipcircle.core.scene.circles import MEASURES
from slipcircle.core.scene.ground import circle_through, circle_touching, simple_slope
from slipcircle.core.scene.section import Section
from tests.support.grounds import Ground, bumpy, moments
from tests.support.strips import integrals

LENGTHS = {"radial_x": ("radial_x", "radial_y"), "radial_y": ("radial_x", "radial_y"),
           "moment_x": ("moment_x", "moment_y"), "moment_y": ("moment_x", "moment_y")}  # fmt: skip
BOUND = 1e-13  # of the moment; of weights, of their vector's length


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


@pytest.mark.parametrize("alpha", [1e-4, 0.03, 0.2, 0.26, 0.7, 1.2, 1.5])
@pytest.mark.parametrize("dip", [-0.3, 0.0, 0.25, 0.8])
def test_one_chord_gives_the_arc(alpha: float, dip: float) -> None:
    middle = 1.5 * math.pi - dip
    arc = Arc(50.0, middle - alpha, middle + alpha, 2e4)
    ends = [50.0 * np.array([math.cos(t), math.sin(t)]) for t in (middle - alpha, middle + alpha)]
    beyond = (ends[1] - ends[0]) / 4
    found = Section([ends[0] - beyond, ends[1] + beyond], (0.0, 0.0), 50.0, 2e4)
    loss = 1e-15 / alpha**2  # the ends are rounded, and the depth is of order alpha^2
    fall, press = arc.amplitudes_per_inertia
    way = -1.0 if dip < 0 else 1.0
    expected = (way * fall * math.sin(dip), fall * math.cos(dip), press * math.cos(dip), -way * press * math.sin(dip))
    assert found.moment_coefficients[:4] == pytest.approx(expected, rel=1e-13 + loss, abs=1e-13 * fall)
    assert found.moment_coefficients.polar_moment == pytest.approx(
        float(kernels.polar_moment_per_inertia(alpha)), rel=1e-13 + loss
    )
    lever = kernels.resistance_factor(alpha) / kernels.moment_of_inertia(alpha)
    assert found.moment_coefficients.resistance_factor == pytest.approx(float(lever), rel=1e-13 + 10 * loss)
    for name in ("depth", "reference_stress", "time_scale", "half_angle"):
        assert getattr(found, name) == pytest.approx(float(getattr(arc, name)), rel=1e-13 + 10 * loss), name
    assert found.depth == pytest.approx(found.sagitta, rel=1e-12 + loss)
    assert found.dip == pytest.approx(abs(dip), abs=1e-15 + 2e-16 / alpha)


def test_weights_of_the_turned_mass() -> None:
    ground, centre, radius = HARD["scarp"]
    found = Section(ground, centre, radius, 2e4)
    w, turn = found.moment_coefficients, 0.2
    cos, sin = math.cos(-turn), math.sin(-turn)  # facing right: counterclockwise

    def turned(p: tuple[float, float]) -> tuple[float, float]:
        x, y = p[0] - centre[0], p[1] - centre[1]
        return (centre[0] + x * cos + y * sin, centre[1] - x * sin + y * cos)

    assert found.facing == 1
    other = moments([turned(p) for p in ground], centre, radius)
    assert w.driving_moment * math.cos(turn) - w.driving_moment_slope * math.sin(turn) == pytest.approx(
        -other["moment_x"] / other["inertia"]
    )
    assert w.normal_load * math.cos(turn) - w.normal_load_slope * math.sin(turn) == pytest.approx(
        -other["radial_y"] / other["inertia"]
    )
    assert found.placed(found.centroid, turn) == pytest.approx(
        np.array([other["moment_x"], other["moment_y"]]) * radius / other["area"] + centre
    )


def test_area_and_centroid_with_rational_crossings() -> None:
    # Crossings (-3, -4) and (4, -3) of the circle of radius 5: polygon in exact rationals, and a segment of 90 deg.
    ground = [(-6.0, -4.5), (-3.0, -4.0), (-1.0, -2.5), (1.0, -2.75), (4.0, -3.0), (8.0, -2.0)]
    found = Section(ground, (0.0, 0.0), 5.0, 2e4)
    corners = [(Fraction(x), Fraction(y)) for x, y in ground[1:5]]
    twice = first_x = first_y = Fraction(0)
    for (x1, y1), (x2, y2) in zip(corners, corners[1:] + corners[:1], strict=True):
        cross = x2 * y1 - x1 * y2  # left to right above, back below: clockwise
        twice, first_x, first_y = twice + cross, first_x + (x1 + x2) * cross, first_y + (y1 + y2) * cross
    segment, lever = 25 * (math.pi / 2 - 1) / 2, 2 / 3 * 125 * math.sin(math.pi / 4) ** 3
    way = np.array([1.0, -7.0]) / math.sqrt(50.0)  # towards the middle of the arc
    area = float(twice / 2) + segment
    assert found.area == pytest.approx(area, rel=1e-14)
    assert found.centroid == pytest.approx(
        (np.array([float(first_x / 6), float(first_y / 6)]) + lever * way) / area, rel=1e-14
    )
    assert found.mass_per_metre == pytest.approx(area * 2e4 / 9.81)
    assert found.chord == pytest.approx(math.sqrt(50.0))
    assert found.entry == pytest.approx([4.0, -3.0])
    assert found.facing == -1


def test_invariances() -> None:
    rng = np.random.default_rng(3)
    for _ in range(20):
        ground, centre, radius = bumpy(rng, 6)
        base = moments(ground, centre, radius)
        split = [ground[0], *(p for a, b in pairwise(ground)
                              for p in (((a[0] + b[0]) / 2, (a[1] + b[1]) / 2), b))]  # fmt: skip
        changed = {
            "scaled": moments([(8 * x, 8 * y) for x, y in ground], (8 * centre[0], 8 * centre[1]), 8 * radius),
            "mirrored": moments([(-x, y) for x, y in ground[::-1]], (-centre[0], centre[1]), radius),
            "split": moments(split, centre, radius),
        }
        assert changed["scaled"] == base
        for name in ("radial_x", "moment_x"):
            changed["mirrored"][name] *= -1
        for other in changed.values():
            for name in MEASURES:
                size = math.hypot(*(base[k] for k in LENGTHS.get(name, (name,))))
                assert abs(other[name] - base[name]) < BOUND * size


def test_a_thousand_edges_of_a_smooth_curve() -> None:
    def fine(edges: int) -> dict[str, float]:
        x = np.linspace(-1.5, 1.5, edges + 1)
        return moments(list(zip(x.tolist(), (0.3 * np.sin(2 * x) - 0.4 * x).tolist(), strict=True)), (0.1, 1.0), 1.5)

    coarse, middle, finest = fine(250), fine(500), fine(1000)
    x = np.polynomial.legendre.leggauss(60)
    lower, upper = _ends_of_the_curve()
    at = (upper + lower) / 2 + (upper - lower) / 2 * x[0]
    top, floor = 0.3 * np.sin(2 * at) - 0.4 * at - 1.0, -np.sqrt(1.5**2 - (at - 0.1) ** 2)
    area = float((x[1] * (top - floor)).sum() * (upper - lower) / 2 / 1.5**2)
    first = float((x[1] * (at - 0.1) * (top - floor)).sum() * (upper - lower) / 2 / 1.5**3)
    for name, truth in (("area", area), ("moment_x", first)):
        assert (4 * finest[name] - middle[name]) / 3 == pytest.approx(truth, rel=1e-8)
        assert (coarse[name] - middle[name]) / (middle[name] - finest[name]) == pytest.approx(4.0, rel=0.05)


def _ends_of_the_curve() -> tuple[float, float]:
    """x of its crossings with the circle, by bisection."""

    def clear(x: float) -> float:
        return 1.5**2 - (x - 0.1) ** 2 - (0.3 * math.sin(2 * x) - 0.4 * x - 1.0) ** 2

    found = []
    for low, high in ((-1.5, 0.0), (1.5, 0.0)):
        for _ in range(100):
            middle = (low + high) / 2
            low, high = (low, middle) if clear(middle) > 0 else (middle, high)
        found.append(low)
    return found[0], found[1]


def test_lanes_are_single_sections() -> None:
    rng = np.random.default_rng(5)
    grounds, centres, radii = zip(*(bumpy(rng, 7) for _ in range(6)), strict=True)
    many = Section(np.array(grounds), np.array(centres), np.array(radii), 2e4)
    assert many.shape == (6,)
    for k in range(6):
        one = Section(grounds[k], centres[k], radii[k], 2e4)
        for name in ("area", "centroid", "entry", "exit", "half_angle", "depth", "facing", "mean_cover", "chord",
                     "dip"):  # fmt: skip
            assert np.array_equal(getattr(many, name)[k], getattr(one, name)), name
        assert [v[k] for v in many.moment_coefficients] == pytest.approx(list(one.moment_coefficients), rel=1e-15)
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


@pytest.mark.parametrize("mirror", [False, True])
def test_mean_pressure_against_quadrature(mirror: bool) -> None:
    way = -1 if mirror else 1
    ground = np.array([(-50.0, 10.0), (-20.0, 10.0), (0.0, 0.0), (50.0, 0.0)])
    level = np.array([(-45.0, 5.0), (-14.0, 4.0), (-3.0, -0.5), (60.0, -1.0)])
    if mirror:
        ground, level = ground[::-1] * [-1, 1], level[::-1] * [-1, 1]
    found = Section(ground, (way * -5.0, 20.0), 22.0, 2e4, level=level, water_unit_weight=9.81e3)
    assert found.facing == way
    first, last = (math.atan2(way * (x + way * 5.0), 20.0 - y) for x, y in (found.entry, found.exit))
    assert last - first == pytest.approx(2 * found.half_angle)
    turns = np.array([0.0, 0.05, 0.3, -0.1])
    beta = np.linspace(first, last, 200_001)
    beta = (beta[1:] + beta[:-1]) / 2
    for turn, mean in zip(turns, found.mean_pressure(turns), strict=True):
        x, y = way * (-5.0 + 22.0 * np.sin(beta + turn)), 20.0 - 22.0 * np.cos(beta + turn)
        assert mean == pytest.approx(9.81e3 * np.maximum(np.interp(x, *level.T) - y, 0.0).mean(), rel=1e-8)
    # Between kinks the mean is smooth: its fourth differences vanish as the step does.
    kinks = [k for k in found.pressure_kinks if -0.3 < k < 0.3]
    for low, high in pairwise(kinks):
        if high - low > 1e-3:
            values = found.mean_pressure(np.linspace(low, high, 9))
            assert abs(np.diff(values, 4)).max() < 10 * (high - low) ** 4 * values.max()


def test_mean_cover_is_the_mean_height_of_the_ground() -> None:
    found = Section(*HARD["scarp"], 2e4)
    (cx, cy), r = HARD["scarp"][1:]
    ends = sorted((found.entry[0], found.exit[0]))
    first, last = np.arcsin((np.array(ends) - cx) / r).tolist()
    beta = np.linspace(first, last, 400_001)
    beta = (beta[1:] + beta[:-1]) / 2
    x, y = cx + r * np.sin(beta), cy - r * np.cos(beta)
    ground = np.array(HARD["scarp"][0])
    assert found.mean_cover == pytest.approx((np.interp(x, *ground.T) - y).mean(), rel=1e-5)


def test_the_form_is_chosen_where_both_agree() -> None:
    # An edge just longer than REACH (r1 + r2), and one just shorter: the moments go on.
    values = []
    for x in (0.2582, 0.25821, 0.25822):
        ground, radius = np.array([[(-2.0, -1.0), (-x, -1.0), (x, -1.0), (2.0, -1.0)]]), 1.001 * math.hypot(x, 1.0)
        parts = circles.cut(ground, np.zeros((1, 2)), np.array([radius]))
        values.append(circles.moments(parts, parts.stretch == 0)["inertia"][0])
    assert np.diff(values, 2) == pytest.approx(0.0, abs=1e-9)
