"""Limits of the method: a rotation of 30 degrees, or a toe high above the original ground."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from slipcircle import Arc, Scene, Section, Series, ensemble, load, solve
from slipcircle.workbench.outputs.pictures import plots
from slipcircle.workbench.studies.ensemble import grid
from tests.support.along_the_arc import of_scene, under_chord
from tests.support.outputs import columns

VAIONT: Scene[Any] = load("vaiont")
CUT = np.array(
    [[-40.0, 0.0], [0.0, 0.0], [24.0, 12.0], [30.0, 12.0], [44.0, 19.0], [90.0, 19.0]]
)  # m, falls to the left


def cut(radius: Any = 45.0, ground: Any = CUT, friction: Any = 0.12, **more: Any) -> Scene[Any]:
    """Return the slide of a cutting on a circle through its foot."""
    section = Section(ground, [24.0, 36.0], radius, 20e3)
    return Scene(section, friction, {"rotation": {}, "centripetal": {}}, **more)


def height(section: Any, rotation: float) -> float:
    """Return the height of the turned toe above the original ground below it, m; the ground goes on level."""
    centre, toe = np.asarray(section.centre), np.asarray(section.exit)
    turn = rotation * float(section.facing)
    x, y = toe - centre
    turned = centre + [x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn)]
    return float(turned[1] - np.interp(turned[0], *np.transpose(section.ground)))


def sections(seed: int) -> list[Any]:
    """Return random slopes that face either way, some of which end shortly beyond the toe."""
    rng = np.random.default_rng(seed)
    found: list[Any] = []
    while len(found) < 24:
        x = np.cumsum(rng.uniform(2.0, 25.0, 7))
        ground = np.stack(
            [x, np.sort(rng.uniform(0.0, rng.choice([25.0, 60.0]), 7))[::-1] + rng.uniform(-2.0, 2.0, 7)], axis=-1
        )
        if rng.random() < 0.5:
            ground = ground[::-1] * [-1.0, 1.0]
        middle = ground[rng.integers(2, 5)] + [0.0, rng.uniform(10.0, 60.0)]
        try:
            found.append(Section(ground, middle, rng.uniform(1.05, 1.6) * (middle[1] - ground[3, 1]), 20e3))
        except ValueError:
            continue
    return found


def test_the_toe_may_rise_by_a_quarter_of_the_height_of_the_arc() -> None:
    """Against a scan of the heights in steps of 1e-3 rad; at 30 degrees it ends in any case."""
    steps = np.arange(0.0, math.radians(30.0), 1e-3)
    narrower = 0
    for section in sections(58):
        upslope, downslope = section.rotation_range
        rise = abs(section.entry[1] - section.exit[1]) / 4
        assert upslope == -math.radians(30.0)
        beyond = [phi for phi in steps if height(section, phi) > rise]
        first = min(beyond, default=math.radians(30.0))
        assert first - 1e-3 <= downslope <= first
        if beyond:
            narrower += 1
            assert height(section, downslope) == pytest.approx(rise, abs=1e-9)
    assert narrower == 24
    steep = Section([[-50.0, 40.0], [0.0, 40.0], [10.0, 0.0], [60.0, 0.0]], [12.0, 45.0], 45.2, 20e3)
    assert max(height(steep, phi) for phi in steps) < 10.0
    assert steep.rotation_range == (-math.radians(30.0), math.radians(30.0))


def test_beyond_a_scarp_the_ground_is_lower() -> None:
    """The toe passes the edge of a quarry 20 m deep; an ensemble of circles has the range of each."""
    quarry = np.array([[-40.0, -20.0], [-6.0, -20.0], [-6.0, 0.0], *CUT[1:]])
    section: Any = cut(ground=quarry).arc
    x, y = section.exit - [24.0, 36.0]
    edge = math.atan2(x, -y) - math.atan2(-30.0, math.sqrt(45.0**2 - 30.0**2))
    assert section.rotation_range[1] == pytest.approx(edge, rel=1e-12)
    radii = np.array([44.0, 45.0, 47.0])
    lanes: Any = cut(radii).arc
    alone = [cut(float(r)).arc.rotation_range[1] for r in radii]
    assert lanes.rotation_range[1] == pytest.approx(alone, rel=1e-12)


@pytest.mark.parametrize("degrees", [5.0, 8.0])
def test_an_arc_leaves_the_range_at_30_degrees(degrees: float) -> None:
    motion = solve(replace(VAIONT, friction=math.tan(math.radians(degrees))))
    end: Any = motion.range_end
    leaves = of_scene(replace(motion.plan.scene, arc=under_chord(VAIONT.arc))).motion(end=math.pi / 6).time
    assert (motion.outside_range, end.time) == (True, pytest.approx(leaves, rel=1e-9))
    assert end.displacement == pytest.approx(1492.6 * math.pi / 6, rel=1e-12)
    assert motion.warnings == (f"outside the range of the method after {end.time:.3g} s, 782 m",)
    inside = solve(VAIONT)
    assert (inside.outside_range, inside.range_end, inside.warnings) == (False, None, ())


def test_a_mass_thrown_upslope_leaves_it_there() -> None:
    arc = Arc(60.0, math.radians(220.0), math.radians(290.0), 19e3)
    velocities = np.array([-26.0, -5.0])
    lanes = solve(Scene(arc, 0.35, {"rotation": {}}, velocities))
    motion = solve(Scene(arc, 0.35, {"rotation": {}}, -26.0))
    assert lanes.outside_range.tolist() == [True, False]
    end: Any = motion.range_end
    assert end.displacement == pytest.approx(-60.0 * math.pi / 6, rel=1e-12)


def test_the_toe_counts_where_the_mass_was_farther_upslope() -> None:
    """Thrown up-slope, it slides back past its start by less, and leaves the range of the toe there."""
    scene = replace(cut(friction=0.3, initial_velocity=-18.0), effects={"rotation": {}})
    low, high = scene.arc.rotation_range
    motion = solve(scene)
    assert low < motion.farthest.rotation < -high
    assert motion.end.rotation > high
    end: Any = motion.range_end
    assert end.rotation == pytest.approx(high, rel=1e-12)
    assert motion.outside_range
    lanes = solve(replace(scene, initial_velocity=np.array([-18.0, -10.0])))
    assert lanes.outside_range.tolist() == [True, False]


def test_it_is_printed_and_counted_and_no_number_is_left_out(said: Any, records: Any, tmp_path: Any) -> None:
    motion = solve(cut())
    end: Any = motion.range_end
    words = f"after {end.time:.3g} s, {end.displacement:.3g} m"
    file = tmp_path / "cut.toml"
    file.write_text(
        f"[ground]\npoints_m = {CUT.tolist()}\nunit_weight_kN_m3 = 20\n[circle]\n"
        'start = "paper"\ncentre_m = [24, 36]\nradius_m = 45\n'
        "[friction]\ncoefficient = 0.12\n[rotation]\n[centripetal]\n",
        "utf-8",
    )
    cells = columns(said(f"run {file}"))
    assert cells["range of validity"] == [f"left {words}"]
    assert cells["run-out along the arc"] == [f"{motion.run_out:.4g} m"]
    (record,) = records(f"run {file}")
    assert (record["outside_range"], record["range_end"]["time"]) == (True, pytest.approx(end.time, rel=1e-9))
    (record,) = records("run vaiont")
    assert (record["outside_range"], record["range_end"]) == (False, None)
    study = grid(VAIONT, {"friction.angle_deg": np.arange(4.0, 11.0)})
    assert study.outside_range == 5
    assert "5 of 7 scenes move outside the range of the method" in study.warnings
    assert study.to_dict()["samples_outside_range"] == 5
    quakes = ensemble(cut(), records={"one": Series(np.arange(5.0), np.array([0.0, 0.1, -0.1, 0.1, 0.0]), held=False)})
    assert quakes.values["outside_range"].all()
    assert any("1 of 1 motions move outside the range of the method" in w for w in quakes.warnings)


def test_curves_are_grey_from_there() -> None:
    motion = solve(cut())
    ax = plots.history(motion, "displacement")
    (covering,) = ax.collections
    (grey,) = covering.get_segments()
    end: Any = motion.range_end
    assert grey[0] == pytest.approx([end.time, end.displacement], rel=1e-9)
    assert grey[-1] == pytest.approx([motion.duration, motion.run_out], rel=1e-9)
    assert covering.get_edgecolor()[0] == pytest.approx([0.6, 0.6, 0.6, 1.0])
    assert covering.get_zorder() > ax.lines[0].get_zorder()
    assert not plots.history(solve(VAIONT), "displacement").collections
