"""A mass that turns through a water level: random sections against 30 digits, energy, both walks, ensembles, words."""

import dataclasses
import json
from typing import Any

import numpy as np
import pytest

from generated import layout as ix
from slipcircle import Motion, Scene, Section, solve
from slipcircle.core.flow import compiled, integrate
from slipcircle.core.scene import transport
from slipcircle.core.scene.coordinates import arc_numbers, changed_fields
from tests.campaigns import section_heights
from tests.support import accuracy, references, section_references, taylor
from tests.support.grounds import GROUND, LEVEL

GAMMA = 20e3


ROWS: list[dict[str, Any]] = json.loads(section_references.FILE.read_text("utf-8"))


@pytest.mark.parametrize("row", ROWS, ids=map(str, section_references.KEPT))
def test_random_sections_against_thirty_digits(row: dict[str, Any]) -> None:
    """Among them steep edges under water, and masses that water or shaking carries for a while."""
    motion, reference = solve(section_references.scene(row["scene"])), row["reference"]
    assert (motion.moves, motion.arrested) == (reference["moves"], reference["arrested"])
    assert max(accuracy.true_error(motion, reference)) <= motion.error_estimate < 1e-10


@pytest.mark.parametrize("index", [0, 2])
def test_references_of_sections_are_derived_again(index: int) -> None:
    """All by ``python -m tests.campaigns.references --sections``."""
    reference = ROWS[index]["reference"]
    again = taylor.solve(ROWS[index]["scene"], references.SHARES, 28, section_references.Section)
    assert references.agree(again, reference, 28)


@pytest.mark.parametrize(("wide", "friction"), [(60, 0.4113), (600, 0.3291)])
def test_a_thin_mass_lands_where_it_leaves_the_water(wide: float, friction: float) -> None:
    """0.55 mm deep on 26 km: it crosses the water of its bowl and lands on the far shore.

    What presses there varies a thousand times faster than the motion by which a step is chosen: its zero was missed
    (run-out 2 % too great, an estimate of 5e-11), or found or missed with the length of the step (an estimate of 0.02).
    """
    radius, depth, dip = 26e3, 0.55e-3, 0.4
    half = np.sqrt(2 * depth * radius)
    ground = [[s * half * np.cos(dip), -s * half * np.sin(dip)] for s in (-wide, -1.5, 1.5, wide)]
    centre = [(radius - depth) * np.sin(dip), (radius - depth) * np.cos(dip)]
    arc = {"ground": ground, "centre": centre, "radius": radius, "unit_weight": GAMMA, "gravity": 9.81}
    given = section_references.plain(arc | {"level": [[x, y - depth / 2] for x, y in ground]}, friction)
    given["effects"] = {"rotation": {}}
    reference = taylor.solve(given, references.SHARES, 28, section_references.Section)
    motion = solve(section_references.scene(given))
    assert (motion.arrested, len(motion.lift_off)) == (reference["arrested"], 1)
    assert max(accuracy.true_error(motion, reference)) < 1e-10
    assert motion.error_estimate < 1e-11
    bound = motion._lanes.problem
    cells = bound.cells.copy()
    integrate.integrate(bound.program, bound.tables, cells)
    assert cells[ix.END_ROTATION] == pytest.approx(motion.end.rotation, rel=1e-10)


def test_heights_of_any_arc_against_thirty_digits() -> None:
    """A sample of ``python -m tests.campaigns.section_heights``."""
    every = [section_heights.compared(24, k) for k in range(60)]
    assert sum(c.overhangs for c in every) >= 5
    for c in every:
        bound = 4e-15 * (1.0 + 1.0 / float(c.section.half_angle))
        assert max(c.pressure[1], c.cover[1]) < bound, c


def test_water_and_ground_above_an_overhanging_arc_count() -> None:
    # By a sum over 400,000 points of the arc of what lies above each.
    ground, level = [[-100, 20], [0, 20], [20, 0], [100, 0]], [[-100, 19], [0, 19], [19, 0], [100, 0]]
    section = Section(ground, [12.0, 15.0], 13.0, GAMMA, level=level)
    assert section.mean_pressure([0.0, 0.1, 0.3, 0.5]) == pytest.approx(
        [60940.42, 60932.10, 59695.33, 56314.25], rel=1e-7
    )
    assert section.mean_pressure(0.5 + 2 * np.pi) == pytest.approx(section.mean_pressure(0.5), rel=1e-14)
    assert section.mean_cover == pytest.approx(7.18204154, rel=1e-8)
    steps = {f"ground.{k}.{axis}" for k in (0, 1, 2) for axis in "xy"}
    assert steps <= {*transport.active_parameters(section)}
    names = ["ground.1.y", "ground.2.x", "centre.y", "radius"]
    found = transport.section_derivatives(section, names).heights
    for name, derivative in zip(names, found, strict=True):
        other = [
            dataclasses.replace(section, **changed_fields(section, {name: arc_numbers(section)[name] + h}))
            for h in (1e-5, -1e-5)
        ]
        slope = np.diff([2 * s.half_angle * s.mean_cover / s.radius for s in other])[0] / -2e-5
        assert derivative == pytest.approx(slope, rel=1e-6)


def body(level: Any = LEVEL, **more: Any) -> Section:
    return Section(GROUND, [33.0, 56.0], 28.0, GAMMA, level=level, **more)


@pytest.mark.parametrize("velocity", [0.0, 1.5, -2.0])
@pytest.mark.parametrize("effects", [{"rotation": {}}, {"centripetal": {}}, {"rotation": {}, "drag": {"xi": 400.0}}])
def test_energy_is_kept_and_both_walks_agree(velocity: float, effects: Any) -> None:
    motion = solve(Scene(body(), 0.3, effects, velocity, None if "rotation" in effects else 1.0))
    assert abs(motion.energy.residual) < 1e-11 * motion.energy.work
    if compiled.module() is None:
        return
    bound = motion._lanes.problem
    one, other = bound.cells.copy(), bound.cells.copy()
    integrate.integrate(bound.program, bound.tables, one)
    compiled.integrate(bound.program, bound.tables, other)
    for cell in (ix.STATUS, ix.PHASES, ix.TIME, ix.PEAK_OMEGA, ix.END_ROTATION, ix.REST_SINCE):
        assert one[cell] == pytest.approx(other[cell], rel=1e-12, nan_ok=True)


def test_a_level_of_the_section_is_an_effect_of_its_own() -> None:
    section = body()
    motion = solve(Scene(section, 0.3, ["rotation"]))
    assert motion.plan.effects == ("rotation", "pore_pressure")
    assert motion.pore_pressure_at(0.0) == pytest.approx(section.mean_pressure(), rel=1e-12)
    end = motion.end.rotation
    assert motion.pore_pressure_at(motion.duration) == pytest.approx(section.mean_pressure(end), rel=1e-11)
    assert section.mean_pressure(end) < 0.9 * section.mean_pressure()
    frozen = solve(Scene(section, 0.3, end_time=2.0))
    assert frozen.pore_pressure_at(2.0) == pytest.approx(section.mean_pressure(), rel=1e-12)
    dry = solve(Scene(dataclasses.replace(section, level=None), 0.3, ["rotation"]))
    assert dry.run_out < 0.9 * motion.run_out
    low = dataclasses.replace(section, level=[[0.0, 20.0], [90.0, 21.0]])
    assert solve(Scene(low, 0.3, ["rotation"])).run_out == pytest.approx(dry.run_out, rel=1e-14)
    with pytest.raises(ValueError, match=r"effects\.pore_pressure: 'level' is unknown"):
        Scene(section, 0.3, {"pore_pressure": {"level": section.mean_pressure}})


def test_ground_that_turns_below_the_level_is_told() -> None:
    def said(motion: Motion) -> list[str]:
        return [words for words in motion.warnings if "below the water level" in words]

    filled = body([[0.0, 25.0], [30.0, 25.0], [38.0, 30.0], [50.0, 35.0], [90.0, 35.0]])
    motion = solve(Scene(filled, 0.3, ["rotation"]))
    points = filled.placed(
        np.linspace(filled.surface[:-1], filled.surface[1:], 2001).reshape(-1, 2), motion.end.rotation
    )
    depth = float((np.interp(points[:, 0], *np.array(filled.level).T) - points[:, 1]).max())
    assert filled.drowned(motion.end.rotation) == pytest.approx(depth, rel=1e-3)
    (words,) = said(motion)
    assert words.startswith(f"turning brings ground down to {depth:.3g} m below the water level; the weight of the")
    assert not said(solve(Scene(body([[0.0, 20.0], [90.0, 21.0]]), 0.3, ["rotation"])))
