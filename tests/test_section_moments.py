"""Moments of the mass under any ground, against strips in ball arithmetic, exact rationals, limits and invariances."""

import json
import math
from pathlib import Path

import numpy as np
import pytest
from flint import arb

from generated import kernels
from slipcircle.core.scene.arc import Arc
from slipcircle.ground.circles import MEASURES
from slipcircle.ground.construction import circle_through, circle_touching, simple_slope
from slipcircle.ground.section import Section
from tests.support.along_the_arc import under_chord
from tests.support.grounds import Ground, bumpy, moments
from tests.support.strips import integrals

LENGTHS = {"radial_x": ("radial_x", "radial_y"), "radial_y": ("radial_x", "radial_y"),
           "moment_x": ("moment_x", "moment_y"), "moment_y": ("moment_x", "moment_y")}  # fmt: skip
BOUND = 1e-13  # of the moment; of weights, of their vector's length


def worst(ground: Ground, centre: tuple[float, float], radius: float) -> float:
    """Return the greatest error of all measures."""
    ours, truth = moments(ground, centre, radius), integrals(ground, centre, radius)
    found = 0.0
    for name in MEASURES:
        size = math.hypot(*(float(truth[k].mid()) for k in LENGTHS.get(name, (name,))))
        error = abs(arb(ours[name]) - truth[name])
        assert error.rad() < 1e-16 * size, name  # the reference is good enough to judge
        found = max(found, float(error.mid()) / size)
    return found


def thin(depth: float, bend: float) -> tuple[Ground, tuple[float, float], float]:
    """Return a skin of a depth over R, its ground bent by shares of the depth."""
    half = math.sqrt(2 * depth)
    ground = [(-2 * half, 0.0), (-half / 3, bend * depth), (half / 5, -bend * depth / 2), (2 * half, 0.0)]
    return ground, (0.3 * half, 1.0 - depth), 1.0


HARD = json.loads(Path(__file__).with_name("support").joinpath("hard_sections.json").read_text("utf-8"))


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


@pytest.mark.parametrize("alpha", [1e-4, 0.03, 0.26, 0.7, 1.5])
@pytest.mark.parametrize("dip", [-0.3, 0.0, 0.8])
def test_one_chord_gives_the_arc(alpha: float, dip: float) -> None:
    middle = 1.5 * math.pi - dip
    arc = Arc(50.0, middle - alpha, middle + alpha, 2e4)
    found = under_chord(arc)
    loss = 1e-13 + 1e-14 / alpha**2  # the ends are rounded, and the depth is of order alpha^2
    amplitudes, cosine, sine = np.array(arc.amplitudes_per_inertia), math.cos(dip), math.sin(abs(dip))
    w = found.moment_coefficients
    assert [w.driving_moment_slope, w.normal_load] == pytest.approx(amplitudes * cosine, rel=loss)
    assert [w.driving_moment, -w.normal_load_slope] == pytest.approx(
        amplitudes * sine, rel=loss, abs=1e-13 * amplitudes[0]
    )
    polar = kernels.polar_moment_per_inertia(alpha)
    resistance = kernels.resistance_factor(alpha) / kernels.moment_of_inertia(alpha)
    assert [w.polar_moment, w.resistance_factor] == pytest.approx([polar, resistance], rel=loss)
    for name in ("depth", "reference_stress", "time_scale", "half_angle"):
        assert getattr(found, name) == pytest.approx(float(getattr(arc, name)), rel=loss), name
    assert found.depth == pytest.approx(found.sagitta, rel=10 * loss)
    assert found.dip == pytest.approx(abs(dip), abs=1e-15 + 2e-16 / alpha)


def test_a_section_has_area_centroid_and_ends_in_metres() -> None:
    """The circle of radius 5 crosses the ground at (-3, -4) and (4, -3)."""
    ground: Ground = [(-6.0, -4.5), (-3.0, -4.0), (-1.0, -2.5), (1.0, -2.75), (4.0, -3.0), (8.0, -2.0)]
    found, truth = Section(ground, (0.0, 0.0), 5.0, 2e4), integrals(ground, (0.0, 0.0), 5.0)
    area, moment_x, moment_y = (float(truth[name].mid()) for name in ("area", "moment_x", "moment_y"))
    assert found.area == pytest.approx(25.0 * area, rel=1e-14)
    assert found.centroid == pytest.approx([5.0 * moment_x / area, 5.0 * moment_y / area], rel=1e-14)
    assert found.mass_per_metre == pytest.approx(25.0 * area * 2e4 / 9.81)
    assert found.chord == pytest.approx(math.sqrt(50.0))
    assert (*found.entry, found.facing) == pytest.approx((4.0, -3.0, -1))
    x, y = found.centroid
    assert found.placed(found.centroid, math.pi / 2) == pytest.approx([y, -x])  # clockwise, as it faces left


def test_circles_through_two_points() -> None:
    p, q, middle = (3.0, 12.0), (25.0, 2.0), (14.0, 7.0)
    by_radius, by_depth = circle_through(p, q, radius=15.0), circle_through(q, p, depth=4.0)
    touching = circle_touching(p, q, 0.5)
    for centre, radius in (by_radius, by_depth, touching):
        assert np.hypot(*(centre - np.array([p, q])).T) == pytest.approx([radius, radius])
    assert by_radius[1] == 15.0
    assert by_depth[1] - np.hypot(*(by_depth[0] - middle)) == pytest.approx(4.0)
    assert touching[0][1] - touching[1] == pytest.approx(0.5)
    assert p[0] < touching[0][0] < q[0]
    for wrong in ({"radius": 5.0}, {"depth": 30.0}, {}, {"depth": 1.0, "radius": 20.0}):
        with pytest.raises(ValueError, match=r"radius|depth"):
            circle_through(p, q, **wrong)
    assert simple_slope(10.0, angle=math.pi / 4)[1] == pytest.approx([-10.0, 10.0])
    assert simple_slope(10.0, run=5.0)[1] == pytest.approx([-5.0, 10.0])
