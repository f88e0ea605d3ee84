"""A mass that turns through a water level: random sections against 30 digits, energy and lanes, both integrators."""

import dataclasses
import json
from inspect import unwrap
from typing import Any

import numpy as np
import pytest

from slipcircle import Scene, Section, solve
from tests.campaigns import section_heights
from tests.support import accuracy, references, section_references, taylor
from tests.support.grounds import GROUND, LEVEL
from tests.support.lanes import backend

GAMMA = 20e3


ROWS: list[dict[str, Any]] = json.loads(section_references.FILE.read_text("utf-8"))


@pytest.mark.parametrize("row", ROWS, ids=[f"{k} {row['group']}" for k, row in enumerate(ROWS)])
def test_random_sections_against_thirty_digits(row: dict[str, Any]) -> None:
    """Among them steep edges under water, and masses that water or shaking carries for a while."""
    motion, reference = solve(section_references.scene(row["scene"])), row["reference"]
    assert (motion.moves, motion.arrested) == (reference["moves"], reference["arrested"])
    assert max(accuracy.true_error(motion, reference)) <= motion.error_estimate < 1e-10


@pytest.mark.parametrize("index", [0, 2])
def test_references_of_sections_are_derived_again(index: int) -> None:
    """``python -m tests.campaigns.references 130 --sections`` draws others."""
    reference = ROWS[index]["reference"]
    again = unwrap(taylor.solve)(ROWS[index]["scene"], references.SHARES, 28, section_references.Section)
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
    with backend("NumPy"):
        assert solve(motion.plan.scene).run_out == pytest.approx(motion.run_out, rel=1e-10)


def test_heights_of_any_arc_against_thirty_digits() -> None:
    """A sample of ``python -m tests.campaigns.section_heights``."""
    every = [section_heights.compared(24, k) for k in range(60)]
    assert sum(c.overhangs for c in every) >= 5
    for c in every:
        bound = 4e-15 * (1.0 + 1.0 / float(c.section.half_angle))
        assert max(c.pressure, c.cover) < bound, c


def test_pressure_on_an_overhanging_arc_is_that_of_a_turn_later() -> None:
    ground, level = [[-100, 20], [0, 20], [20, 0], [100, 0]], [[-100, 19], [0, 19], [19, 0], [100, 0]]
    section = Section(ground, [12.0, 15.0], 13.0, GAMMA, level=level)
    assert section.mean_pressure(0.5 + 2 * np.pi) == pytest.approx(section.mean_pressure(0.5), rel=1e-14)


def body(level: Any = LEVEL, **more: Any) -> Section:
    return Section(GROUND, [33.0, 56.0], 28.0, GAMMA, level=level, **more)


def test_a_level_of_the_section_is_an_effect_of_its_own() -> None:
    section = body()
    motion = solve(Scene(section, 0.3, ["rotation"]))
    assert motion.plan.effects == ("rotation", "pore_pressure")
    end = motion.end.rotation
    pressures = motion.pore_pressure_at(np.array([0.0, motion.duration]))
    assert pressures == pytest.approx(section.mean_pressure([0.0, end]), rel=1e-11)
    dry, low = (
        solve(Scene(dataclasses.replace(section, level=level), 0.3, ["rotation"])).run_out
        for level in (None, [[0.0, 20.0], [90.0, 21.0]])
    )
    assert low == pytest.approx(dry, rel=1e-14)
    assert dry < 0.9 * motion.run_out
    with pytest.raises(ValueError, match=r"effects\.pore_pressure: 'level' is unknown"):
        Scene(section, 0.3, {"pore_pressure": {"level": section.mean_pressure}})


def test_ground_that_turns_below_the_level_is_told() -> None:
    filled = body([[0.0, 25.0], [30.0, 25.0], [38.0, 30.0], [50.0, 35.0], [90.0, 35.0]])
    motion = solve(Scene(filled, 0.3, ["rotation"]))
    edges = np.linspace(filled.surface[:-1], filled.surface[1:], 2001).reshape(-1, 2)
    x, y = filled.placed(edges, motion.end.rotation).T
    depth = float((np.interp(x, *np.array(filled.level).T) - y).max())
    assert filled.drowned(motion.end.rotation) == pytest.approx(depth, rel=1e-3)
    words = f"turning brings ground down to {depth:.3g} m below the water level; the weight of the"
    assert any(warning.startswith(words) for warning in motion.warnings)
