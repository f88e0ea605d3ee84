"""Motions of real sections: an arc's where the ground is its chord, energy, factors of safety, from file to picture."""

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

from slipcircle import Arc, Scene, Section, load, solve
from tests.support.along_the_arc import under_chord
from tests.support.grounds import GROUND

CENTRE, RADIUS = [29.5, 53.6], 28.6


def body(**more: Any) -> Section:
    return Section(GROUND, CENTRE, RADIUS, 20e3, between=(29.0, 60.0), **more)


def test_cohesion_alone_stops_it_where_energy_says() -> None:
    """Weight times the fall of the centroid is what cohesion takes along the arc: c (2 alpha R) R phi."""
    section, cohesion = body(), 8e3
    motion = solve(Scene(section, 0.0, {"rotation": {}, "cohesion": {"cohesion": cohesion}}))
    radius, (x, y) = RADIUS, (np.array(section.centroid) - CENTRE)
    weight, arc = section.mass_per_metre * 9.81, 2 * math.asin(section.chord / 2 / radius) * radius

    def left(phi: float) -> float:  # it slides to the left
        turned = -x * math.sin(phi) + y * math.cos(phi)
        return float(weight * (y - turned) - cohesion * arc * radius * phi)

    rest = brentq(left, 0.05, 2.0, xtol=1e-14)
    assert motion.end.rotation == pytest.approx(rest, rel=1e-10)
    assert motion.journey.fall == pytest.approx(cohesion * arc * radius * rest / weight, rel=1e-10)
    assert abs(motion.energy.residual) < 1e-12 * motion.energy.work


def test_what_is_not_solved_is_told() -> None:
    deep = Section([[-10, 10], [0, 0], [10, 10]], [0.2, 2.0], 4.0, 20e3)
    with pytest.raises(ValueError, match="half a circle"):
        Scene(deep, 0.3)


def test_a_travel_angle_is_that_of_the_centroids_way() -> None:
    """The angle of a mass that does not move is the limit for small rotations; the slope faces left."""
    section = body()
    for rotation in (-0.2, 0.3):
        way = section.placed(section.centroid, rotation) - section.centroid
        assert section.journey(rotation).travel_angle == pytest.approx(math.atan2(-way[1], -way[0]), rel=1e-12)
    assert section.journey(0.0).travel_angle == pytest.approx(section.journey(1e-9).travel_angle, rel=1e-8)


@pytest.mark.parametrize("ends", [(3.7, 5.1), (3 * math.pi - 5.1, 3 * math.pi - 3.7)])
def test_an_arc_travels_like_the_section_under_its_chord(ends: tuple[float, float]) -> None:
    """The section's centroid is that of a polygon and a segment; both ways a slope may face, forth and back."""
    arc = Arc(50.0, *ends, 2e4)
    for rotation in (-0.2, 0.0, 0.3):
        for one, other in zip(arc.journey(rotation), under_chord(arc).journey(rotation), strict=True):
            assert one == pytest.approx(other, rel=1e-10, abs=1e-11)
    lanes = Arc(50.0, np.array([ends[0]] * 2), ends[1], 2e4).journey(np.array([0.3, 0.1]))
    assert lanes.rise[1] == pytest.approx(arc.journey(0.1).rise, rel=1e-14)


def test_velocity_classes_of_a_mass_that_slows_down_evenly() -> None:
    """Frozen, with constant friction: v = v_0 - a t, so that the time in a class is its range of speeds over a."""
    scene = Scene(Arc(50.0, 3.7, 5.1, 2e4), 1.5, initial_velocity=8.0)
    motion = solve(scene)
    rate = 8.0 / motion.duration
    limits = [0.0, 16e-3 / 31556952, 1.6 / 31556952, 13.0 / 2629746, 1.8 / 3600, 3.0 / 60, 5.0, 8.0]
    assert [*motion.velocity_times][3:] == pytest.approx(np.diff(limits)[3:] / rate, rel=2e-2)  # limits are rounded
    assert motion.velocity_times.extremely_rapid == pytest.approx(3.0 / rate, rel=1e-12)
    assert motion.velocity_times.rapid == pytest.approx((0.05 - 5e-4) / rate, rel=1e-11)
    assert sum(motion.velocity_times) == pytest.approx(motion.duration, rel=1e-12)
    for velocity, name in ((4.9, "very rapid"), (0.04, "rapid"), (4e-4, "moderate"), (4e-9, "very slow"), (0.0, "")):
        assert solve(replace(scene, initial_velocity=velocity)).velocity_class == name


def test_velocity_times_of_swings_leave_out_standstills() -> None:
    """Against the share of fine even samples; phases of both directions count."""
    motion = solve(load("vaiont-shaken"))
    speeds = np.abs(motion.at(np.linspace(0.0, motion.duration, 200_001)).velocity)
    assert motion.velocity_times.extremely_rapid == pytest.approx(np.mean(speeds > 5.0) * motion.duration, abs=1e-3)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("[circle]", "[search]\n", "circle: is missing"),
        ("[rotation]", "[arc]\nradius_m = 3\n[rotation]", "exclude each other"),
    ],
)
def test_mistakes_of_a_scene_with_a_ground(tmp_path: Path, old: str, new: str, words: str) -> None:
    """Others are in `test_odd_files`."""
    text = Path("slipcircle/scenes/real-slope.toml").read_text("utf-8")
    assert old in text
    path = tmp_path / "slope.toml"
    path.write_text(text.replace(old, new), "utf-8")
    with pytest.raises(ValueError, match=words):
        load(path)
