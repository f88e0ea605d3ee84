"""A lane is its scene: circles, grounds, levels, soils, loads and cracks as arrays, beside each scene by itself."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from slipcircle import Scene, Section, solve
from slipcircle import load as load_scene
from slipcircle.core.integrator.lanes import BLOCK
from slipcircle.derivatives.parameters import with_parameter_arrays, with_parameters
from slipcircle.layers import LayeredSection, Soil
from slipcircle.tables.interpolation import between_kinks
from slipcircle.workbench.stability.stability import factors_of_safety
from tests.campaigns import lanes as campaign
from tests.support.ensembles import SCENES
from tests.support.layered import CRACKED, TURNING

FIELDS = ("time", "displacement", "velocity", "acceleration", "normal_stress")
NUMBERS = ("run_out", "duration", "factor_of_safety", "toe_x", "toe_y", "travel_angle", "exit_x", "area")


def factors_of(scene: Scene) -> dict[str, Any]:
    return factors_of_safety(scene) if isinstance(scene.arc, Section) else {}


@pytest.mark.parametrize("name", SCENES)
def test_lanes_are_their_scenes(name: str) -> None:
    """Results, factors of safety and states at any time, at the end and where fastest equal the single scene's."""
    many = solve(SCENES[name], accuracy=1e-14)
    table, factors = many.to_dict(), factors_of(many.plan.scene)
    time = 0.4 * float(np.min(many.duration))
    assert np.any(many.moves)
    for at in np.ndindex(many.shape):
        alone = many[at].plan.scene
        one = solve(alone)
        assert (many.status[at], many.moves[at], many.arrested[at]) == (one.status, one.moves, one.arrested)
        pairs = [(table[number], one.to_dict()[number]) for number in NUMBERS if number in table]
        pairs += [(factors[method], factor) for method, factor in factors_of(alone).items()]
        for state, other in ((many.at(time), one.at(time)), (many.end, one.end), (many.peak, one.peak)):
            pairs += [(getattr(state, field), getattr(other, field)) for field in FIELDS]
        for found, expected in pairs:
            assert np.broadcast_to(found, many.shape)[at] == pytest.approx(expected, rel=1e-12, abs=1e-13)


@pytest.mark.parametrize(
    ("load", "line"),
    [
        ([(2e4, 3e4), (6e4, 1e4), (0.0, 2e4)], [(12.0, 12.0, 8.0)] * 3),
        ([(2e4, 3e4)] * 3, [(12.0, 12.0, 8.0), (13.0, 11.0, 9.0), (12.0, 11.5, 9.0)]),
    ],
)
def test_lanes_of_loads_and_lines_are_taken(load: Any, line: Any) -> None:
    """Lanes may differ also in lines and loads that have no named number."""
    (upper, _), (middle, _), lower = CRACKED.layers

    def section(k: Any) -> LayeredSection:
        places = np.broadcast_to([-80.0, 0.0, 80.0], np.shape(np.array(line)[k]))
        points = np.stack([places, np.array(line)[k]], axis=-1)
        loads = [(-3.0, 4.0, *np.array(load)[k].T)]
        return replace(CRACKED, surcharge=loads, layers=[(upper, None), (middle, points), lower])

    lanes = solve(Scene(section(slice(None)), effects=TURNING))
    alone = [solve(Scene(section(k), effects=TURNING)).run_out for k in range(3)]
    assert lanes.run_out == pytest.approx(alone, rel=1e-9)
    assert [lanes[k].run_out for k in range(3)] == alone
    assert lanes[1:].run_out.tolist() == lanes.run_out[1:].tolist()
    assert solve(lanes[1:].plan.scene).run_out == pytest.approx(alone[1:], rel=1e-9)


@pytest.mark.parametrize("name", campaign.SCENES)
def test_lanes_of_scenes_that_ship_are_scenes(name: str) -> None:
    """60 values of every number: ``python -m tests.campaigns.lanes``."""
    differences = dict(campaign.of_scene(name, 1, np.random.default_rng(3)))
    assert len(differences) > 4
    assert max(differences.values()) < campaign.BOUND, differences


def test_lanes_of_profiles_whose_boundaries_meet_are_scenes() -> None:
    """Boundaries coincide, touch the circle or each other; the campaign draws 200."""
    differences = dict(campaign.of_profiles(20, np.random.default_rng(5)))
    assert max(differences.values()) < campaign.BOUND, differences


@pytest.mark.parametrize("facing", [1, -1])
@pytest.mark.parametrize("at_toe", [0.0, -1e-13, 1e-13])
def test_of_boundaries_that_coincide_at_the_exit_the_lowest_soil_goes_on(facing: int, at_toe: float) -> None:
    """Boundaries leave the ground at the toe, as does the circle, which is flatter there."""
    ground = np.array([[-30.0, 10.0], [0.0, 10.0], [20.0, 0.0], [60.0, 0.0]])
    lines = [ground, [[-30.0, 4.0], [0.0, 4.0], [20.0, 0.0], [60.0, 0.0]], [[-30.0, 2.0], [20.0, 0.0], [60.0, 0.0]]]
    tops = [np.asarray(line)[::facing] * [facing, 1] for line in lines]
    soils = [Soil(19e3, 0.0, friction, name=name) for name, friction in {"a": 0.1, "b": 0.12, "c": 0.4}.items()]
    layers = list(zip(soils, [None, *tops[1:]], strict=True))
    centre = np.array([8.0 * facing, 15.0])
    radius = float(np.hypot(12.0, 15.0))
    section = LayeredSection(tops[0], centre, radius, layers=layers)
    scene = Scene(section, effects=TURNING)
    values = np.array([radius * (1.0 + at_toe), radius * 0.99, radius * 1.01])
    lanes, _ = with_parameter_arrays(scene, {"radius": values})
    for arc in (lanes.arc, with_parameters(scene, {"radius": float(values[0])}).arc):
        assert isinstance(arc, LayeredSection)
        assert arc.soils[arc.arc_strength.stretches.last[0]].name == "c"
    named = LayeredSection(tops[0], centre, float(values[0]), layers=layers, foreland=soils[2])
    assert solve(lanes).run_out[0] == pytest.approx(solve(Scene(named, effects=TURNING)).run_out, rel=1e-9)


def test_tables_begin_where_the_motion_does() -> None:
    """Kinks within rounding of the start, of one circle or of several that differ there, are no place to begin at."""
    kinks = np.array([[4e-16, 0.0], [5e-14, 0.0], [1.3e-13, 4e-16], [2e-13, 0.2], [0.3, 0.3]])

    def function(rotation: Any) -> Any:
        return np.exp(rotation)[None]

    breaks, coefficients = between_kinks(function, kinks, np.zeros(2), np.ones(2), 1e-14)
    np.testing.assert_array_equal(breaks[0], 0.0)
    for lane in (0, 1):
        widths = np.diff(breaks[:, lane])
        powers = widths[:, None] ** np.arange(coefficients.shape[1])
        ends = (coefficients[:-1, :, 0, lane] * powers).sum(axis=1)
        np.testing.assert_allclose(ends, np.exp(breaks[1:, lane]), rtol=3e-13)
        assert np.abs(coefficients[:, 1, 0, lane]).max() < 3.0


def test_statics_of_many_lanes_are_those_of_each() -> None:
    """They are computed block by block: the lanes where one ends and the next begins."""
    friction: Any = np.linspace(0.1, 0.5, 2 * BLOCK + 3)
    vaiont = load_scene("vaiont")
    many = solve(replace(vaiont, friction=friction), 1e-3)
    for lane in (0, BLOCK - 1, BLOCK, 2 * BLOCK, 2 * BLOCK + 2):
        one = solve(replace(vaiont, friction=float(friction[lane])))
        for name in ("factor_of_safety", "yield_coefficient", "limit_friction", "friction"):
            assert getattr(many, name)[lane] == pytest.approx(getattr(one, name), rel=1e-14), (name, lane)


def test_the_last_lane_of_many_is_solved_like_all_others() -> None:
    """It would be alone in its block, and lanes alone are solved to rounding."""
    peak: Any = np.linspace(0.1, 0.3, BLOCK + 1)
    law: dict[str, Any] = {"law": "rate_weakening", "residual": 0.1, "velocity": 1.0}
    vaiont = load_scene("vaiont")
    many, few = (
        np.asarray(solve(replace(vaiont, friction={**law, "peak": x}), 1e-3).run_out) for x in (peak, peak[-3:])
    )
    assert np.array_equal(many[-3:], few)
