"""Representations of motions, ensembles and studies: lines, tables, dictionaries, pandas, xarray."""

import math
import pickle
import sys
from contextlib import nullcontext
from dataclasses import replace
from typing import Any, assert_type
from xml.etree import ElementTree

import numpy as np
import pytest

import generated
import slipcircle
from slipcircle import Arc, Motion, Scene, Status, Study, ensemble, kernels, load, solve
from slipcircle.base.kinds import Array
from slipcircle.base.text import digits_left, number_text
from slipcircle.core import ANSWERED
from slipcircle.core.integrator.compiled import numpy_only
from slipcircle.workbench.common.quantities import HISTORY, JOURNEY, OUTCOMES, RESULTS, SINGLE, to_error
from slipcircle.workbench.studies.ensemble import grid

VAIONT = load("vaiont")
MANY_OF: Scene = VAIONT  # which may hold arrays
ANGLES = np.array([8.0, 10.0, 40.0])
TIMES = np.array([0.0, 1.0, 5.0])
ASKED = 1e-13  # accuracy, where lanes are compared with single scenes


def many(**more: Any) -> Motion:
    friction, velocity = np.tan(np.deg2rad(ANGLES)), np.array([[0.0], [1.0]])
    return solve(replace(VAIONT, **{"friction": friction, "initial_velocity": velocity} | more), ASKED)


def single(angle: float, velocity: float) -> Motion:
    return solve(replace(VAIONT, friction=math.tan(math.radians(angle)), initial_velocity=velocity))


def overturned(friction: Any = 0.0) -> Motion:
    """Two lanes, of which the pushed one carries its chord past the upright."""
    return solve(replace(MANY_OF, friction=friction, initial_velocity=np.array([0.0, -400.0])))


@pytest.fixture(scope="module")
def study() -> Study:
    uncertain = {"friction.angle_deg": {"distribution": "normal", "mean": 24, "std": 2}}
    return ensemble(replace(load("wet-slope"), uncertain=uncertain), 200, 1, sensitivity=0, accuracy=ASKED)


# --- shown -----------------------------------------------------------------------------------------------------------


def test_repr_has_the_key_results(study: Study) -> None:
    assert repr(solve(VAIONT)) == "<Motion vaiont: 27.97 m/s at most; run-out 677.3 m; comes to rest after 38.08 s>"
    still = solve(replace(VAIONT, friction=0.9))
    factor = f"factor of safety {still.factor_of_safety:.3f} by the paper's method"
    assert repr(still) == f"<Motion vaiont: does not move, {factor}>"
    assert repr(solve(replace(VAIONT, end_time=10.0))).endswith("still moving at 10 s>")
    said = repr(many(initial_velocity=0.0))
    assert said.startswith("<3 motions vaiont: comes to rest: 2, does not move: 1; ")
    assert "run-out 0 to 786 m" in said
    assert f"run-out {study.quantile('run_out', 0.5).value:.4g} (" in repr(study)


def test_html_is_a_table_and_no_more(study: Study) -> None:
    hostile = solve(replace(VAIONT, name="<script>&"))
    for found in (hostile, many(), study, overturned()):
        root = ElementTree.fromstring(f"<div>{found._repr_html_()}</div>")
        assert not list(root.iter("script"))
        assert len(list(root.iter("tr"))) > 3
    cells = {r[0].text: r[1].text for r in ElementTree.fromstring(f"<d>{hostile._repr_html_()}</d>").iter("tr")}
    assert cells["run-out along the arc"] == "677.3 m, outside the observed 300 to 450 m"


def test_every_public_name_exists() -> None:
    assert all(hasattr(slipcircle, name) for name in {*slipcircle.__all__, *dir(slipcircle)})
    assert all(getattr(kernels, name) is getattr(generated, name) for name in {*kernels.__all__, *generated.__all__})


def test_a_table_has_no_more_digits_than_the_error_leaves_and_no_fewer_than_wanted() -> None:
    """Four significant digits, 0.4328 m and not 0.4 m; of a coarse solution only those that it has."""
    (run_out,) = (q for q in RESULTS if q.name == "run_out")
    assert run_out.text(solve(load("newmark-pulse"))) == "0.4328 m"
    errors = {0.0: 4, 4.9e-5: 4, 4e-4: 3, 6e-4: 2, 0.004: 2, 0.04: 1, 1.0: 1}
    assert {error: digits_left(error) for error in errors} == errors
    texts = {0.43284: "0.4328", 12345.6: "12350", 1e-7: "1e-07", -0.0: "0", 1.5e9: "1.5e+09", math.inf: "infinite"}
    assert {value: number_text(value) for value in texts} == texts
    assert number_text(677.3078, 2) == "680"
    to_errors = {(-0.001, 0.3): "0.00", (12.3456, 0.012): "12.346", (1234.5, 96.0): "1234",
                 (5.6123e-10, 3.1e-11): "5.61e-10", (-1e-13, 1e-10): "0", (5.0, 0.0): "5"}  # fmt: skip
    assert {pair: to_error(*pair) for pair in to_errors} == to_errors


# --- lanes -----------------------------------------------------------------------------------------------------------


def test_lanes_are_indexed_like_arrays() -> None:
    motion = many()
    assert (motion.shape, len(motion), bool(motion)) == ((2, 3), 2, True)
    for at in np.ndindex(2, 3):
        lane = motion[at]
        assert lane.run_out == pytest.approx(motion.run_out[at], rel=1e-12)
        assert (lane.shape, lane.plan.scene.initial_velocity) == ((), float(at[0]))
        assert bool(lane.phases) == motion.moves[at]
    np.testing.assert_array_equal(motion[1, 1:].run_out, motion.run_out[1, 1:])
    np.testing.assert_allclose(motion[1, 1:].at(TIMES).velocity, motion.at(TIMES).velocity[1, 1:], rtol=1e-12)
    assert motion[0].shape == (3,)
    with pytest.raises(IndexError):
        motion[2]
    with pytest.raises(TypeError, match="its scene has no arrays"):
        len(solve(VAIONT))
    with pytest.raises(TypeError, match="cannot be indexed"):
        solve(VAIONT)[0]


def test_a_failure_has_a_name_and_a_reason() -> None:
    failed = overturned()
    assert failed.to_dict()["status"].tolist() == ["MOVING", "UPRIGHT"]
    assert failed.reason.tolist() == ["", "the chord is vertical, and the mass would overhang"]
    assert np.isnan(failed.run_out[1])
    assert [s for s in Status if not s.reason] == [*ANSWERED]


@pytest.mark.parametrize("engine", [nullcontext, numpy_only])
def test_a_lane_without_a_result_has_states_until_it_ends(engine: Any) -> None:
    alone = solve(replace(VAIONT, friction=0.0, initial_velocity=-400.0, end_time=3.0))
    with engine():
        failed = overturned()
        state, energy = failed.at([1.0, 3.0, 5.0, 30.0]), failed.energy
    assert state.rotation[1, :2] == pytest.approx(alone.at([1.0, 3.0]).rotation, rel=1e-12)
    np.testing.assert_array_equal(np.isnan(state.velocity), [[False] * 4, [False, False, True, True]])
    np.testing.assert_array_equal(np.isnan([energy.work, energy.dissipation, energy.kinetic_end]), [[False, True]] * 3)


def test_friction_that_depends_on_the_slip_is_unknown_without_a_state() -> None:
    softens = {"law": "exponential", "peak": 0.02, "residual": 0.01, "length": 5.0}
    friction = overturned(softens).friction_at([3.0, 5.0])
    assert 0.0 < friction[1, 0] < 0.02
    np.testing.assert_array_equal(np.isnan(friction), [[False, False], [False, True]])


def test_each_lane_has_its_energy_at_its_own_end() -> None:
    motion = many()
    assert motion.energy.work.shape == (2, 3)
    for (row, column), work in np.ndenumerate(motion.energy.work):
        alone = single(float(ANGLES[column]), float(row)).energy
        assert work == pytest.approx(alone.work, rel=1e-12)
        assert motion.energy.dissipation[row, column] == pytest.approx(alone.dissipation, rel=1e-12)
    assert np.all(motion.energy.kinetic_end == 0.0)
    assert np.max(np.abs(motion.energy.residual)) < 1e-11 * np.max(motion.energy.work)


def test_a_sample_of_a_study_is_its_motion(study: Study) -> None:
    assert len(study) == study.to_dict()["samples"] == 200
    assert study.to_dict()["outputs"]["run_out"]["mean"]["value"] == study.mean("run_out").value
    for k in (0, 7, -1):
        assert study[k].run_out == pytest.approx(study.samples["run_out"][k], rel=1e-12)


def test_pickled_it_is_the_same(study: Study) -> None:
    for motion in (solve(VAIONT), many()):
        again = pickle.loads(pickle.dumps(motion))
        np.testing.assert_array_equal(again.run_out, motion.run_out)
        np.testing.assert_array_equal(again.at(TIMES).velocity, motion.at(TIMES).velocity)
    assert repr(pickle.loads(pickle.dumps(study))) == repr(study)


# --- tables ----------------------------------------------------------------------------------------------------------


def test_a_dictionary_has_every_result() -> None:
    motion, lanes = solve(VAIONT), many()
    found = motion.to_dict()
    assert [*found] == [*(q.name for q in (*RESULTS, *SINGLE, *JOURNEY)), "factors_of_safety", "status", "reason"]
    assert (found["run_out"], found["peak_velocity"]) == (motion.run_out, motion.peak.velocity)
    assert (found["status"], found["reason"]) == ("RESTS", "")
    of_lanes = lanes.to_dict()
    columns = [*of_lanes.pop("factors_of_safety").values(), *of_lanes.values()]
    assert {np.shape(v) for v in columns} == {(2, 3)}
    np.testing.assert_array_equal(lanes.to_dict()["initial_velocity"][:, 2], [0.0, 1.0])
    history = lanes.to_dict(TIMES)
    assert [*history] == [*HISTORY]
    np.testing.assert_array_equal(history["velocity"], lanes.at(TIMES).velocity)


@pytest.mark.parametrize("name", ["pandas", "xarray"])
def test_a_missing_library_is_one_sentence(name: str, study: Study, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, name, None)
    for found in (solve(VAIONT), many(), study) if name == "pandas" else (many(),):
        with pytest.raises(ImportError, match=f"^{name} is needed for to_{name}: pip install {name}$"):
            getattr(found, f"to_{name}")()


def test_pandas(study: Study) -> None:
    pytest.importorskip("pandas")
    motion = many()
    frame, history = motion.to_pandas(), motion.to_pandas(TIMES)
    assert frame.index.names == ["lane_0", "lane_1"]
    assert frame.loc[(1, 2), "status"] == motion[1, 2].status.name
    assert frame.loc[(1, 1), "run_out"] == motion.run_out[1, 1]
    assert frame.attrs["units"]["peak_velocity"] == "m/s"
    assert history.index.names == ["lane_0", "lane_1", "time"]
    assert history.loc[(0, 1, 5.0), "velocity"] == motion.at(5.0).velocity[0, 1]
    assert solve(VAIONT).to_pandas(TIMES).index.tolist() == TIMES.tolist()
    samples = study.to_pandas()
    np.testing.assert_array_equal(samples["run_out"], study.samples["run_out"])
    assert set(samples["status"]) == {"RESTS"}
    units = {**{n: q.unit for n, q in OUTCOMES.items()}, "friction.angle_deg": "deg", "rotation": "rad"}
    assert samples.attrs["units"].items() >= units.items()


def test_xarray_keeps_dimensions(study: Study) -> None:
    xarray = pytest.importorskip("xarray")
    friction = xarray.DataArray(np.tan(np.deg2rad(ANGLES)), dims=("angle",))
    found = many(friction=friction, initial_velocity=0.0).to_xarray(TIMES)
    assert found["velocity"].dims == ("angle", "time")
    assert found["displacement"].attrs["units"] == "m"
    results = many().to_xarray()
    assert results["run_out"].dims == ("lane_0", "lane_1")
    assert [results.coords[name].dims for name in ("friction", "initial_velocity")] == [("lane_1",), ("lane_0",)]
    other = xarray.DataArray(np.array([0.0, 1.0, 2.0]), dims=("push",))
    with pytest.raises(ValueError, match="initial_velocity: its dimension 'push' is on the axis of 'angle'"):
        many(friction=friction, initial_velocity=other).to_xarray()
    assert study.to_xarray()["run_out"].dims == ("sample",)
    table = grid(
        VAIONT, {"friction.angle_deg": [8.0, 10.0], "arc.radius_m": [1000.0, 1200.0, 1400.0]}, accuracy=ASKED
    ).to_xarray()
    at = table.sel({"friction.angle_deg": 10.0, "arc.radius_m": 1200.0})
    slide = solve(replace(single(10.0, 0.0).plan.scene, arc=replace(VAIONT.arc, radius=1200.0)))
    assert float(at["run_out"]) == pytest.approx(slide.run_out, rel=1e-12)


def test_a_type_checker_tells_one_motion_from_many() -> None:
    """Types that mypy infers are those of the results."""
    arc, mu = Arc(60.0, 3.8, 4.9, 2e4), np.array([0.1, 0.2])
    one = solve(Scene(arc, 0.2, {"rotation": {}, "pore_pressure": {"ratio": 0.1}}))
    assert_type(one, Motion[float])
    assert_type(solve(replace(VAIONT, friction=0.2)), Motion[float])
    assert isinstance(assert_type(one.run_out, float), float)
    lanes = solve(Scene(arc, mu, ["rotation"]))
    wide = solve(Scene(Arc(np.array([60.0, 70.0]), 3.8, 4.9, 2e4), 0.2, ["rotation"]))
    assert_type(lanes, Motion[Array])
    assert_type(wide, Motion[Array])
    assert assert_type(lanes.run_out, Array).shape == wide.run_out.shape == (2,)
    assert_type(solve(replace(MANY_OF, friction=mu)), Motion[Any])
    with pytest.raises(ValueError, match="shapes do not fit together"):
        replace(VAIONT, friction=mu, initial_velocity=np.zeros(3))  # type: ignore[arg-type]
