"""Scenes of arrays: what moves, shapes, and results against references; `test_lanes` has lanes beside their scenes."""

import json
from collections import defaultdict
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from slipcircle import Arc, Motion, Scene, load, solve
from slipcircle.derivatives import with_parameter_arrays
from tests.support import accuracy, golden
from tests.support.ensembles import together


def arcs(count: int) -> dict[str, Any]:
    """Thin ones, half discs and all between, dips of both signs up to upright."""
    rng = np.random.default_rng(3)
    alpha = np.minimum(10 ** rng.uniform(-5, 0.25, count), np.pi / 2)
    middle = 1.5 * np.pi - rng.uniform(-1.5, 1.5, count)
    return {"radius": 10 ** rng.uniform(0, 3.5, count), "theta_1": middle - alpha, "theta_2": middle + alpha,
            "unit_weight": rng.uniform(15e3, 27e3, count)}  # fmt: skip


@pytest.mark.parametrize("effects", [golden.TURNING, {"rotation": {}, "pore_pressure": {"ratio": 0.4}},
                                     {"cohesion": {"cohesion": 1e3}}, {}], ids=str)  # fmt: skip
def test_at_the_limit_and_one_ulp_to_either_side(effects: dict[str, Any]) -> None:
    """Whether a lane moves is decided by the limit friction that the scene itself shows, to the last bit."""
    given = arcs(40)
    alone = (dict(zip(given, arc, strict=True)) for arc in zip(*(v.tolist() for v in given.values()), strict=True))
    limits = np.array([solve(Scene(Arc(**arc), 9.0, effects, end_time=1.0)).limit_friction for arc in alone])
    mu = np.maximum(np.array([np.nextafter(limits, -9), limits, np.nextafter(limits, 9), limits * (1 - 1e-9)]), 0.0)
    np.testing.assert_array_equal(solve(Scene(Arc(**given), mu, effects, end_time=1.0)).moves, mu < limits)


def test_results_have_the_shape_of_the_scene() -> None:
    """Fields of any shapes that fit together, arrays without a dimension or without a lane; every status."""
    vaiont: Scene = load("vaiont")
    mu, radius = np.array([0.1, 0.2, 0.3, 0.9]), np.array([[300.0], [400.0], [500.0]])
    found = solve(replace(vaiont, arc=replace(vaiont.arc, radius=radius), friction=mu), 1e-14)
    for values in (found.status, found.moves, found.run_out, found.peak.velocity, found.error_estimate):
        assert np.shape(values) == (3, 4)
    alone = solve(replace(vaiont, arc=replace(vaiont.arc, radius=400.0), friction=0.2))
    assert [found.duration[1, 1], found.run_out[1, 1]] == pytest.approx([alone.duration, alone.run_out], rel=1e-13)
    assert found.count() == {"RESTS": 6, "STAYS": 3, "TURNED": 3}
    assert isinstance(solve(replace(vaiont, friction=np.array(0.2))), Motion)
    none = solve(replace(vaiont, friction=np.zeros((0, 3))))
    assert (none.duration.shape, none.count()) == ((0, 3), {})
    mixed = solve(replace(vaiont, friction=np.array([0.3, 0.0]), initial_velocity=np.array([1e6, 0.0])))
    assert mixed.count() == {"MOVING": 1, "UPRIGHT": 1}
    np.testing.assert_array_equal(np.isfinite(mixed.duration), [False, True])


def test_errors_are_below_the_requested_accuracy() -> None:
    """Times are off by less than it, also of swings through the half circle."""
    middle = 1.5 * np.pi - np.radians(np.linspace(5, 80, 20))
    friction = np.tan(np.radians(np.linspace(0.5, 30, 15)))[:, None]
    scene = Scene(Arc(100.0, middle - 0.6, middle + 0.6, 2e4), friction, golden.TURNING, end_time=1e4)
    exact = solve(scene, 1e-14)
    for asked in (0.9, 1e-2, 1e-3, 1e-5, 1e-9, 1e-12):
        found = solve(scene, asked)
        well = exact.moves & (exact.error_estimate < max(asked / 10, 4e-13))
        assert np.count_nonzero(well) > 120
        for name, value in exact.outcomes.items():
            np.testing.assert_allclose(found.outcomes[name][well], value[well], rtol=asked + 1e-12)


def test_references_together() -> None:
    """The 300 references, one ensemble for each combination of effects and law."""
    groups: dict[str, list[Any]] = defaultdict(list)
    for record in accuracy.ROWS[:300]:
        given = record["scene"]
        law = given["friction"]["law"] if isinstance(given["friction"], dict) else "constant"
        table = given["friction"] if law == "tabulated" else law  # tables are no axis
        names = [(e, *sorted(p)) for e, p in sorted(given["effects"].items())]
        groups[json.dumps([names, table, given["end_time"] is None])].append(record)
    seen = 0
    for members in groups.values():
        first = members[0]["scene"]
        beside = first | {"initial_velocity": first["initial_velocity"] + 1.0}  # one alone is no ensemble
        found = together([*(r["scene"] for r in members), beside], 1e-11)
        for k, wanted in enumerate(r["reference"] for r in members):
            bound = 1e-14 + float(found.error_estimate[k])
            assert (found.moves[k], found.arrested[k]) == (wanted["moves"], wanted["arrested"])
            for name in ("duration", "run_out"):
                assert getattr(found, name)[k] == pytest.approx(float(wanted[name]), rel=bound)
            assert found.peak.velocity[k] == pytest.approx(float(wanted["peak_velocity"]), rel=bound)
            seen += bound < 1e-11
    assert seen > 160


@pytest.mark.parametrize(
    "friction",
    [{"law": "linear", "peak": np.array([0.2]), "residual": 0.1, "length": 2.0},
     {"law": "linear", "peak": 0.2, "residual": np.array([0.1]), "length": 2.0},
     {"law": "exponential", "peak": np.array([0.2]), "residual": 0.1, "length": 2.0}],
    ids=["peak", "residual", "exponential"],
)  # fmt: skip
def test_an_ensemble_of_one_scene_has_its_results_and_an_estimate(friction: dict[str, Any]) -> None:
    """The runs of an estimate share the table of the only lane."""
    arc = load("vaiont").arc
    alone = solve(Scene(arc, {name: x if isinstance(x, str) else float(np.ravel(x)[0]) for name, x in friction.items()},
                        golden.TURNING))  # fmt: skip
    found = solve(Scene(arc, friction, golden.TURNING))
    assert found.run_out == pytest.approx([alone.run_out], rel=1e-9)
    assert found.error_estimate.shape == (1,)
    assert abs(found.run_out[0] / alone.run_out - 1) <= found.error_estimate[0] < 1e-9


@pytest.mark.parametrize("name", ["layered-slope", "valley-side"])
def test_an_ensemble_of_one_section_has_an_estimate(name: str) -> None:
    scene = load(name)
    scenes, invalid = with_parameter_arrays(scene, {"radius": np.atleast_1d(scene.numbers["radius"])})
    found = solve(scenes, invalid=invalid)
    assert found.run_out == pytest.approx([solve(scene).run_out], rel=1e-9)
    assert 0.0 <= found.error_estimate[0] < 1e-9
