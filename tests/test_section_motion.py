"""Motions of real sections: an arc's where the ground is its chord, energy, factors of safety, from file to picture."""

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

from slipcircle import Arc, Scene, Section, load, solve
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
    with pytest.raises(AttributeError, match="needs a Section"):
        solve(Scene(Arc(60.0, 4.0, 5.0, 2e4), 0.9)).journey  # noqa: B018


def test_a_travel_angle_is_that_of_the_centroids_way() -> None:
    """Of a mass that does not move the limit; the slope falls to the left."""
    section = body()
    for rotation in (-0.2, 0.3):
        way = section.placed(section.centroid, rotation) - section.centroid
        assert section.journey(rotation).travel_angle == pytest.approx(math.atan2(-way[1], -way[0]), rel=1e-12)
    assert section.journey(0.0).travel_angle == pytest.approx(section.journey(1e-9).travel_angle, rel=1e-8)


def test_the_motion_of_a_file_slides_along_the_circle_of_its_search(records: Any) -> None:
    (record,) = records("run real-slope")
    (circle,) = records("search real-slope")
    assert record["factor_of_safety"] == pytest.approx(circle["factor_of_safety"]["paper"], rel=1e-9)
    assert record["toe_x"] == pytest.approx(circle["exit"][0] - record["toe_run_out"], rel=1e-9)


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
