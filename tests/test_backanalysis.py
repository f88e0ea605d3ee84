"""Back-analysis against round trips, the tilted pendulum, and simulated observations."""

import math
import re
from dataclasses import replace
from itertools import count
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy.optimize import least_squares, minimize_scalar

from slipcircle import Interval, Scene, Unattainable, backanalyse, grid, load, solve
from slipcircle.derivatives import with_parameters
from slipcircle.workbench.common.summary import key_results
from slipcircle.workbench.files.shipped import find
from slipcircle.workbench.outputs.json_records import record
from slipcircle.workbench.stability.critical import at_circle
from slipcircle.workbench.studies.backanalysis import FITTED, ROOT
from slipcircle.workbench.studies.roots import bracket_candidates, solve_exact
from slipcircle.workbench.studies.standstill import standstills
from tests.campaigns.round_trips import outcome

VAIONT = load("vaiont")
WET = load("wet-slope")
PENDULUM = replace(VAIONT, effects=["rotation"])
DIP, RADIUS = float(VAIONT.arc.dip), float(np.asarray(VAIONT.arc.radius))


@pytest.mark.parametrize(
    ("name", "output", "field", "value"),
    [("vaiont", "run_out", "friction", 0.21), ("vaiont", "duration", "friction", 0.19),
     ("vaiont-frozen", "peak_velocity", "friction", 0.25), ("newmark-pulse", "run_out", "friction", 0.5),
     ("newmark-pulse", "peak_velocity", "friction.angle_deg", 28.0)]
    + [("wet-slope", "peak_velocity", field, value) for field, value in (
        ("friction", 0.4), ("cohesion.cohesion", 5e3), ("pore_pressure.ratio", 0.3), ("radius", 55.0), ("theta_1", 3.7),
        ("theta_2", 4.9), ("unit_weight", 2.3e4), ("initial_velocity", 1.5), ("gravity", 9.0))],
)  # fmt: skip
def test_what_moved_the_mass_is_found_again(name: str, output: str, field: str, value: float) -> None:
    """Newmark's block would stand: its friction is above the limit at rest."""
    observed: dict[str, Any] = {output: float(grid(load(name), {field: [value]}).samples[output][0])}
    study = backanalyse(load(name), **observed, field=field)
    assert study.method == ROOT
    assert min(abs(s.value / value - 1) for s in study.solutions) < (1e-10 if output != "duration" else 1e-9)


@pytest.mark.parametrize(
    ("scene", "number", "observed", "how"),
    [("layered-slope", "soils.clay.cohesion", "run_out", "found"),
     ("layered-slope", "layers.2.top", "duration", "found"),
     ("layered-slope", "ground.3.x", "run_out", "without effect"), ("vaiont", "gravity", "run_out", "without effect"),
     ("vaiont", "radius", "peak_velocity", "found")],
)  # fmt: skip
def test_a_motion_gives_back_the_numbers_of_its_scene(scene: str, number: str, observed: str, how: str) -> None:
    """Numbers are found from their motions; a sample of `tests.campaigns.round_trips`."""
    shipped = load(scene)
    assert outcome(shipped, number, observed, float(solve(shipped).outcomes[observed])) == how


def test_an_effect_that_the_scene_lacks_is_fitted() -> None:
    truth = solve(replace(VAIONT, effects={**VAIONT.called, "drag": {"xi": 800.0}}))
    assert backanalyse(VAIONT, run_out=truth.run_out, field="drag").value == pytest.approx(800.0, rel=1e-9)


# --- the tilted pendulum -------------------------------------------------------------------------------------------


PER_TAN = float(VAIONT.arc.dimensionless.limit_friction) / math.tan(DIP)


def pendulum(rest: float) -> list[float]:
    """Return the frictions with a place of rest, the fewest swings first.

    It swings about delta = arctan(mu C_r/C_theta), down-slope and back in turn, so that the dip falls by 2 delta each
    time, and rests where it is at most delta: after n swings psi_0 - s/R = (-1)**n (psi_0 - 2 n delta).
    """
    turn, found = rest / RADIUS, []
    for n in range(1, 14):
        tilt = (2 * DIP - turn if n % 2 else turn) / (2 * n)
        if 0.0 < tilt < DIP and abs(DIP - turn) <= tilt:
            found.append(PER_TAN * math.tan(tilt))
    return found


@pytest.mark.parametrize(("share", "count"), [(0.3, 1), (1.1, 4), (0.93, 7), (1.3, 2)])
def test_several_solutions_and_none_is_missed(share: float, count: int) -> None:
    """Weak friction lets the mass swing back: the search finds every friction of the closed form, of a run-out one.

    The run-out is 2 R (psi_0 - delta). Standard errors are linear: sigma over |d run-out/d friction|.
    """
    displacement = share * DIP * RADIUS
    closed = pendulum(displacement)
    assert len(closed) == count
    for bounds in (None, (1e-3, 0.42)):
        found = backanalyse(PENDULUM, end_displacement=(displacement, 5.0), field="friction", bounds=bounds)
        np.testing.assert_allclose([s.value for s in found.solutions], closed, rtol=1e-11)
        swings = [len(s.motion.phases) for s in found.solutions]
        assert swings == sorted(swings)
        found = backanalyse(PENDULUM, run_out=(displacement, 5.0), field="friction", bounds=bounds)
        tangent = math.tan(DIP - displacement / (2 * RADIUS))
        assert [s.value for s in found.solutions] == pytest.approx([PER_TAN * tangent], rel=1e-11)
        assert found.standard_error == pytest.approx(5.0 * PER_TAN * (1 + tangent**2) / (2 * RADIUS), rel=1e-9)


@pytest.mark.parametrize("scene", [VAIONT, PENDULUM], ids=["vaiont", "pendulum"])
def test_an_unattainable_observation_names_the_attainable_range(scene: Scene) -> None:
    """The farthest rest is after the first swing, where the mass just stays; the pendulum's is 4/3 psi_0."""
    with pytest.raises(Unattainable, match=r"no value of friction gives it; attainable: .* to .* = ") as caught:
        backanalyse(scene, end_displacement=3000.0, field="friction")
    (least, _), (most, at) = caught.value.attainable["end_displacement"]
    assert 0.0 < least < 1e-3
    assert solve(replace(scene, friction=at)).end.displacement == most
    assert scene is VAIONT or most == pytest.approx(4 / 3 * DIP * RADIUS, rel=1e-6)
    with pytest.raises(Unattainable, match="for all values"):
        backanalyse(scene, run_out=400.0, field="unit_weight")


# --- several fields ------------------------------------------------------------------------------------------------


OBSERVED: dict[str, tuple[float, float]] = {"run_out": (430.0, 12.0), "peak_velocity": (16.6, 0.4),
                                            "duration": (36.9, 0.5)}  # fmt: skip


def independent(x: Any) -> Any:
    """Residuals of OBSERVED by friction and radius, through the scalar solver."""
    motion = solve(replace(VAIONT, friction=float(x[0]), arc=replace(VAIONT.arc, radius=1e3 * float(x[1]))))
    return np.array([(motion.outcomes[n] - seen) / sigma for n, (seen, sigma) in OBSERVED.items()])


def test_covariance_of_several_fields() -> None:
    """Against SciPy's fit of residuals of single motions, and its Jacobian by differences."""
    study = backanalyse(VAIONT, **OBSERVED, field=["friction", "radius"])
    first = study.solutions[0]
    fit = least_squares(independent, [0.3, 1.4], jac="3-point", xtol=1e-15, ftol=1e-15, gtol=1e-12)
    covariance = np.linalg.inv(fit.jac.T @ fit.jac) * np.outer([1.0, 1e3], [1.0, 1e3])
    errors = np.sqrt(np.diag(covariance))
    assert [*first.values.values()] == pytest.approx(fit.x * [1.0, 1e3], rel=1e-6)
    assert (first.chi_square, study.degrees_of_freedom) == pytest.approx((2.0 * fit.cost, 1), rel=1e-9)
    np.testing.assert_allclose(np.asarray(first.covariance), covariance, rtol=1e-4)
    assert [*(first.standard_errors or {}).values()] == pytest.approx(errors, rel=1e-4)
    np.testing.assert_allclose(np.asarray(first.correlation), covariance / np.outer(errors, errors), rtol=1e-4)
    # Errors that nobody gave are in proportion to what was observed, as the misfit has it
    unknown: dict[str, Any] = {n: seen for n, (seen, _) in OBSERVED.items()}
    alike: dict[str, Any] = {n: (seen, seen) for n, (seen, _) in OBSERVED.items()}
    free, scaled = (backanalyse(VAIONT, **x, field=["friction", "radius"]).solutions[0] for x in (unknown, alike))
    np.testing.assert_allclose(
        np.asarray(free.covariance), np.asarray(scaled.covariance) * scaled.chi_square, rtol=1e-6
    )


def test_every_minimum_of_a_fit_is_found() -> None:
    """Friction and dip that give place of rest and peak velocity: with one swing and with two, each as observed."""
    observed: dict[str, Any] = {"end_displacement": (400.0, 20.0), "peak_velocity": (17.0, 1.0)}
    found = backanalyse(VAIONT, **observed, field=("friction", "dip"))
    assert [len(s.motion.phases) for s in found.solutions] == [1, 2]
    for s in found.solutions:
        moved = s.motion.end.displacement, s.motion.peak.velocity, s.motion.plan.scene.arc.dip
        assert moved == pytest.approx((400.0, 17.0, s.values["dip"]), rel=1e-7)
    assert "poorly determined" in found.warnings[0]
    assert found.solutions[0].covariance is not None
    narrow = {"dip": (0.1, 0.3), "friction": (0.01, 0.1)}
    inside = backanalyse(VAIONT, **observed, field=["friction", "dip"], bounds=narrow)
    assert [len(s.motion.phases) for s in inside.solutions] == [2]


def test_a_misfit_is_told() -> None:
    """More than the standard errors explain; or, where all could be met and nothing is said of them, no answer."""
    found = backanalyse(VAIONT, run_out=(400.0, 1.0), peak_velocity=(30.0, 0.1), duration=(20.0, 0.1),
                        field=["friction", "radius"])  # fmt: skip
    assert any("larger than the standard errors explain" in w for w in found.warnings)
    with pytest.raises(Unattainable, match="the nearest is"):
        backanalyse(VAIONT, run_out=400.0, peak_velocity=170.0, field=["friction", "dip"])
    with pytest.raises(Unattainable, match="move and come to rest"):
        backanalyse(VAIONT, run_out=400.0, duration=40.0, field=["friction", "radius"], bounds={"friction": (0.8, 0.9)})


def test_what_scipy_integrates() -> None:
    """Four solutions are found, the weakest friction with five swings back; creeping frictions cost no time."""
    scene = load("vaiont-rate")
    found = backanalyse(scene, end_displacement=400.0, field="friction.residual")
    assert [len(s.motion.phases) for s in found.solutions] == [1, 2, 4, 6]
    for s in found.solutions:
        assert s.motion.end.displacement == pytest.approx(400.0, rel=1e-9)


def observed_of_vaiont(motion: Any) -> dict[str, float]:
    """Return the outcomes, and the rise of the second end of the arc from its rotation."""
    second, turned = math.radians(276.9), motion.run_out / 1492.6
    return {**motion.outcomes, "toe_rise": 1492.6 * (math.sin(second + turned) - math.sin(second))}


def test_intervals_count_as_uniform_distributions() -> None:
    """Vaiont as it was reported: against SciPy's minimum of chi-square with the moments of even samples."""
    intervals: Any = VAIONT.observed
    samples = {n: np.linspace(ends.low, ends.high, 100_001) for n, ends in intervals.items()}

    def chi_square(degrees: float) -> float:
        outcomes = observed_of_vaiont(solve(replace(VAIONT, friction=math.tan(math.radians(degrees)))))
        return sum(((outcomes[n] - x.mean()) / x.std()) ** 2 for n, x in samples.items())

    best = minimize_scalar(chi_square, bounds=(10.0, 18.0), method="bounded", options={"xatol": 1e-9})
    found = backanalyse(VAIONT)
    assert found.solutions[0].values == backanalyse(replace(VAIONT, observed={}), **intervals).solutions[0].values
    assert found.value == pytest.approx(best.x, rel=1e-5)
    assert found.solutions[0].chi_square == pytest.approx(best.fun, rel=1e-4)
    step = 1e-2
    curvature = (chi_square(best.x + step) - 2 * best.fun + chi_square(best.x - step)) / step**2
    assert found.standard_error == pytest.approx(math.sqrt(2 / curvature), rel=0.05)  # linear, as the errors are
    assert found.intervals == intervals


@pytest.mark.parametrize(
    ("degrees", "missed"), [(10.0, {"run_out", "toe_rise"}), (13.6, set[str]()), (14.0, set[str]())]
)
def test_what_one_friction_angle_meets_of_vaiont(degrees: float, missed: set[str]) -> None:
    """Reported ranges that a friction angle misses by more than a tenth."""
    outcomes = observed_of_vaiont(solve(replace(VAIONT, friction=math.tan(math.radians(degrees)))))
    outside = {n for n, (low, high) in VAIONT.observed.items() if not 0.9 * low <= outcomes[n] <= 1.1 * high}
    assert outside == missed


def test_tables_and_json_show_what_was_observed_beside_the_motion() -> None:
    """Intervals with a verdict, a number with its error without one."""
    seen = {"run_out": Interval(600.0, 700.0), "peak_velocity": Interval(20.0, 25.0), "duration": (40.0, 5.0)}
    motion = solve(replace(VAIONT, observed=seen))
    assert {label: text for label, text in key_results(motion).items() if "observed" in text} == {
        "run-out along the arc": "677.3 m, inside the observed 600 to 700 m",
        "peak velocity": "27.97 m/s, outside the observed 20 to 25 m/s",
        "duration": "38.08 s, observed 40 +- 5 s",
    }
    assert record(motion)["observed"] == {"run_out": [600.0, 700.0], "peak_velocity": [20.0, 25.0], "duration": [40, 5]}
    assert "observed" not in record(solve(replace(VAIONT, observed={})))


def test_a_climb_is_met_exactly() -> None:
    found = backanalyse(VAIONT, toe_rise=140.0)
    assert observed_of_vaiont(found.motion)["toe_rise"] == pytest.approx(140.0, rel=1e-9)


def test_one_interval_is_met_in_its_middle() -> None:
    found = backanalyse(VAIONT, run_out=Interval(350.0, 450.0))
    assert found.motion.run_out == pytest.approx(400.0, rel=1e-9)
    assert found.standard_error == pytest.approx(
        backanalyse(VAIONT, run_out=(400.0, 100.0 / math.sqrt(12))).standard_error, rel=1e-12
    )


# --- targets and limits --------------------------------------------------------------------------------------------

SLOPE: Any = load("real-slope")
RESIDUAL = "friction.residual_deg"
TARGETS = ("toe_x", "crest_drop", "centroid_travel")


@pytest.mark.parametrize("target", TARGETS)
def test_the_strength_with_which_a_motion_was_computed_is_found_from_its_places(target: str) -> None:
    """Places are those of points that turn about the centre of the circle."""
    motion = solve(SLOPE)
    arc = SLOPE.arc
    turn = np.exp(1j * arc.facing * motion.run_out / arc.radius)
    centre = complex(*arc.centre)
    crest, toe, centroid = (centre + (complex(*p) - centre) * turn for p in (arc.entry, arc.exit, arc.centroid))
    places = {"toe_x": toe.real, "crest_drop": arc.entry[1] - crest.imag}
    places["centroid_travel"] = arc.facing * (centroid.real - arc.centroid[0])
    residual = SLOPE.friction["residual"]
    found = backanalyse(SLOPE, field="friction.residual", **{target: places[target]})
    assert found.value == pytest.approx(residual, rel=1e-9)
    assert (
        backanalyse(replace(SLOPE, observed={target: places[target]}), field="friction.residual").value == found.value
    )


def test_warnings_about_the_motion_found_are_warnings_of_the_fit() -> None:
    found = backanalyse(SLOPE, run_out=0.01, field="friction.residual")
    assert found.value > SLOPE.friction["peak"]
    assert [warning for warning in found.warnings if "were they exchanged" in warning]


@pytest.mark.parametrize(("method", "factor"), [("bishop", 1.0), ("paper", 1.0), ("ordinary", 0.9)])
def test_a_factor_of_safety_by_a_method_is_met_by_strengths_as_entered(method: str, factor: float) -> None:
    """The slices of statics have it with the strength that is found; no motion is needed."""
    scene = replace(SLOPE, start=method)
    found = backanalyse(scene, factor_of_safety=factor, field="cohesion.cohesion")
    slope = replace(SLOPE.stability.slope, cohesion=found.value)
    assert at_circle(slope, SLOPE.arc).factors_of_safety[method] == pytest.approx(factor, rel=1e-12)
    assert found.solutions[0].error_estimate < 1e-13
    search_again, *others = found.warnings
    assert "search again" in search_again
    assert [warning.partition(":")[0] for warning in others] == ["ill-conditioned"] * (factor == 1.0)
    arc: Any = VAIONT.arc
    assert backanalyse(VAIONT, factor_of_safety=1.0, field="friction").value == pytest.approx(
        arc.dimensionless.limit_friction, rel=1e-12
    )


def test_a_limit_is_met_by_the_least_friction_beyond_which_it_always_is() -> None:
    """A limit is met at the root of a continuous outcome; at a jump, at the friction of limit equilibrium."""
    known = SLOPE.friction["residual"]
    toe = solve(SLOPE).journey.toe_x  # it slides to the left
    found = backanalyse(SLOPE, toe_x=Interval(toe, math.inf), field="friction.residual")
    assert found.value == pytest.approx(known, rel=1e-9)
    for value, side in ((found.value * (1 - 1e-6), False), (found.value * (1 + 1e-6), True), (2 * found.value, True)):
        assert (solve(with_parameters(SLOPE, {"friction.residual": value})).journey.toe_x > toe) == side
    reached = backanalyse(VAIONT, run_out=Interval(400.0, math.inf))  # the greatest friction with this run-out
    assert reached.value == pytest.approx(backanalyse(VAIONT, run_out=400.0).value, rel=1e-12)
    softens = load("vaiont-softening")
    arc: Any = softens.arc
    stops = backanalyse(softens, run_out=Interval(-math.inf, 50.0), field="friction.peak")
    assert stops.value == pytest.approx(arc.dimensionless.limit_friction, rel=1e-12)
    assert not stops.motion.moves
    assert solve(with_parameters(softens, {"friction.peak": stops.value * (1 - 1e-9)})).run_out > 300.0


def test_numbers_at_which_a_mass_would_stay_have_a_factor_of_one(said: Any) -> None:
    """Limits are an arc's closed form and the slices of statics on the circle; shaken or pushed masses have none."""
    arc: Any = VAIONT.arc
    stops = standstills(VAIONT, {"friction": 0.2, "gravity": 9.81}.items())
    assert stops == {"friction": pytest.approx(arc.dimensionless.limit_friction, rel=1e-7)}
    stops = standstills(SLOPE, {"cohesion.cohesion": 3e3, "friction.residual": 0.2}.items())
    assert [*stops] == ["cohesion.cohesion"]
    slope = replace(SLOPE.stability.slope, cohesion=stops["cohesion.cohesion"])
    assert at_circle(slope, SLOPE.arc).factor_of_safety == pytest.approx(1.0, rel=1e-7)
    assert standstills(load("shaken-slope"), {"cohesion.cohesion": 3e3}.items()) == {}
    assert standstills(replace(VAIONT, initial_velocity=1.0), {"friction": 0.2}.items()) == {}
    table = " ".join(said("sensitivity layered-slope").split())
    assert "soils.clay.cohesion_kPa 2 4.229 +2.2" in table
    assert re.search(r"ground.points_m.1.y, of 8 coordinates 25 25.5\d \+0.5", table)
    assert table.count("points_m") == 2  # of two blocks of columns
    assert "jump: a change to one side changes the outcome at once" in table
    assert "10 most important of 24 numbers" in table


# --- mistakes and the command line ---------------------------------------------------------------------------------


SOFTENING = load("vaiont-softening").friction
TWO: dict[str, Any] = {"run_out": 400.0, "duration": 38.0}


WET_PENDULUM = {"effects": {"rotation": {}, "pore_pressure": {"ratio": 0.1}}}


@pytest.mark.parametrize(
    ("asked", "words"),
    [
        ({"observed": {}}, "no observation: give one of run_out, end_displacement, peak_velocity"),
        ({"observed": {"climb": 140.0}}, "observed.climb: is not an outcome; known are run_out, end_displacement"),
        ({"observed": {"reach": 400.0}}, "observed.reach: is not an outcome; known are run_out"),
        ({"run_out": 0.0}, "other than 0"),
        ({"run_out": (400.0, 0.0)}, "standard error"),
        ({"run_out": Interval(450.0, 300.0)}, r"run_out = Interval\(low=450.0, .* in m, the lower end first"),
        ({"duration": Interval(-45.0, -20.0)}, r"duration = Interval\(low=-45.0.* positive number"),
        ({"duration": "30 to 45 s"}, "duration = '30 to 45 s': must be"),
        ({"run_out": (400.0, 1.0), "duration": 30.0}, "for all observations, or for none"),
        ({"run_out": 400.0, "field": "nose"}, "nose: is not a parameter of this scene"),
        ({"run_out": 400.0, "bounds": (1.0, 0.0)}, "the lower one first"),
        ({"run_out": 400.0, "friction": SOFTENING}, "has no single angle; give one of friction.peak_deg, "),
        ({"run_out": (400.0, 5.0), "field": ["friction", "dip"]}, r"2 fields from 1 .*cannot be distinguished"),
        ({"toe_x": 60.0}, "toe_x: an arc has no position; give toe_rise or centroid_travel"),
        ({"factor_of_safety": -1.0}, "factor_of_safety = -1.0: must be a positive number"),
        ({"run_out": Interval(-math.inf, 400.0), "duration": 30.0}, "at most 400: a limit is for one field alone"),
        ({"run_out": Interval(-math.inf, 4e3)}, "4000 m: every value of friction.angle_deg gives it; attainable: 0 m"),
        ({"run_out": Interval(3e3, math.inf)}, "3000 m: no value of friction.angle_deg gives it; attainable: 0 m"),
        ({"factor_of_safety": 50.0}, "factor_of_safety = 50 : no value of friction.angle_deg gives it; attainable: 0"),
        (TWO | {"field": ["friction", "unit_weight"]}, "unit_weight: does not affect"),
        ({"run_out": (2.0, 1.0), "peak_velocity": (0.5, 0.1), "field": ["friction", "friction"]}, "named twice"),
        (TWO | {"field": ["dip", "theta_1"]}, "turns theta_1 and theta_2"),
        (TWO | {"field": ["friction", "drag"], "bounds": {"radius": (1, 2)}}, "not one of the fields"),
        (TWO | {"field": ["friction", "dip"], "bounds": (0.1, 0.2)}, "give a mapping"),
        # Water of r_u leaves 1 - r_u of the friction, where nothing else presses.
        (TWO | WET_PENDULUM | {"field": ["friction", "pore_pressure.ratio"]},
         r"changing friction by .* and pore_pressure.ratio by .* does not change"),
    ],
)  # fmt: skip
def test_mistakes_of_observations_and_fields_are_named(asked: dict[str, Any], words: str) -> None:
    changed = {key: asked[key] for key in ("friction", "effects", "observed") if key in asked}
    with pytest.raises(ValueError, match=words):
        backanalyse(replace(VAIONT, **changed), **{key: asked[key] for key in asked if key not in changed})


def test_a_value_at_the_end_of_its_range_says_so() -> None:
    """A warning names a value at the end of its range, of an exact root and of a fit."""
    root = backanalyse(VAIONT, run_out=400.0).value
    at_end = backanalyse(VAIONT, run_out=400.0, bounds=(root - 1e-6, 20.0))
    fitted = backanalyse(VAIONT, run_out=(400.0, 5.0), duration=(38.0, 1.0), bounds=(17.0, 20.0))
    assert [study.method for study in (at_end, fitted)] == [ROOT, FITTED]
    for found in (at_end, fitted):
        assert any("lies at the end of the searched range" in w for w in found.warnings)


def test_the_command_prints_the_fit_and_its_errors(said: Any, records: Any, refused: Any) -> None:
    assert "attainable" in refused("backanalyse vaiont --run-out-m 3000")
    assert "must be KEY or KEY=LOW:HIGH" in refused("backanalyse vaiont --run-out-m 400 --field friction=1")
    argv = ("backanalyse vaiont --run-out-m 400+-20 --peak-velocity-m-s 17+-0.5 --duration-s 37.5+-0.4 "
            "--field friction=0.2:0.4 --field radius")  # fmt: skip
    study = backanalyse(VAIONT, run_out=(400.0, 20.0), peak_velocity=(17.0, 0.5), duration=(37.5, 0.4),
                        field=["friction", "radius"], bounds={"friction": (0.2, 0.4)})  # fmt: skip
    first, (record,) = study.solutions[0], records(argv)
    covariance, errors = np.asarray(first.covariance).tolist(), first.standard_errors or {}
    kept = [record["solutions"][0][name] for name in ("values", "covariance", "standard_errors")]
    assert kept == [first.values, covariance, errors]
    out = " ".join(said(argv).split())
    assert f"radius {first.values['radius']:.0f}" in out
    assert f" +- {errors['radius']:.2g}" in out
    assert "correlation of friction and radius" in out
    assert "(observed 400 +- 20)" in out


def test_targets_and_limits_on_the_command_line_and_in_a_file(tmp_path: Path, said: Any, refused: Any) -> None:
    at_most = " ".join(said("backanalyse real-slope --toe-x-m >20 --field", RESIDUAL).split())
    assert "toe x (m) 20 (limit: at least 20)" in at_most
    assert "by bisection to the limit" in at_most
    path = tmp_path / "scene.toml"
    path.write_text(find("real-slope").read_text("utf-8") + '\n[observed]\ntoe_x_m = ">20"\n', "utf-8")
    assert " ".join(said("backanalyse", path, "--field", RESIDUAL, "--plot", tmp_path / "a.png").split()) == at_most
    for method, value in (("bishop", "3.239"), ("paper", "3.928")):
        argv = "backanalyse real-slope --factor-of-safety 1 --field cohesion.cohesion_kPa --method"
        assert f"cohesion.cohesion_kPa {value}" in " ".join(said(argv, method).split())
    assert "the paper's factor alone" in refused("backanalyse vaiont --run-out-m 400 --method bishop")
    path.write_text(path.read_text("utf-8").replace('">20"', '"=20"'), "utf-8")
    assert 'observed.toe_x_m = "=20": must be a number, or an interval' in refused("run", path)


def test_the_command_says_which_intervals_are_met(said: Any, records: Any) -> None:
    argv = "backanalyse vaiont --run-out-m 300:450 --peak-velocity-m-s 20:30 --duration-s 0:45"
    out = " ".join(said(argv).split())
    for text in ("436.8 (inside 300 to 450)", "18.23 (outside 20 to 30)", "37.64 (inside 0 to 45)"):
        assert text in out
    (record,) = records(argv)
    assert record["intervals"] == {"run_out": [300.0, 450.0], "peak_velocity": [20.0, 30.0], "duration": [0.0, 45.0]}


@pytest.mark.parametrize("noise", [0.0, 1e-12])
@pytest.mark.parametrize("first", [0.0, 1.0])
def test_roots_of_outcomes_with_rounding(noise: float, first: float) -> None:
    """Outcomes that fall through 1 at x = 1, or from it at an end of the range, and change with the lanes beside."""
    calls = count()

    def outcomes(values: Any) -> Any:
        error = noise * (-1.0) ** next(calls) if first == 0.0 else -1e-15
        return 2.0 - values + error, np.zeros(values.shape[1], dtype=int)

    problem: Any = SimpleNamespace(targets=[1.0], ranges=[np.linspace(first, 2.0, 8)], outcomes=outcomes)
    (root,) = solve_exact(problem)
    assert root == pytest.approx(1.0, abs=2e-12)


def test_brackets_of_roots_span_one_section_at_a_passage_and_two_at_an_extremum() -> None:
    x = np.arange(6.0)[None]
    misfit = np.array([[4.0, 1.0, 4.0, 9.0, -1.0, -9.0]])  # a minimum at 1, a passage from 3 to 4
    (row, first), (_, last) = bracket_candidates(x, misfit, np.zeros(x.shape), 1.0)
    assert {*zip(row.tolist(), first.tolist(), last.tolist(), strict=True)} == {(0, 3, 4), (0, 0, 2)}
