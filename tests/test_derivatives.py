"""Derivatives of motions by the numbers of their scenes, against differences of motions of 32 to 42 digits."""

import json
import math
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from flint import arb, ctx

from slipcircle import Arc, Scene, load, parameters, solve
from slipcircle.workbench.studies.ensemble import grid
from tests.support import accuracy, golden, oracle, references, taylor
from tests.support.motions import from_method

EXACT = ("peak_velocity", "run_out", "duration")  # outputs of which so many digits are known

# --- whole motions -------------------------------------------------------------------------------------------------


def outputs(scene: golden.Data, free: bool, digits: int) -> list[arb]:
    """Peak velocity, run-out and duration to so many digits."""
    found = taylor.solve(scene, digits=digits, problem=taylor.Released if free else taylor.Problem)
    return [arb(found[name]) for name in EXACT]


def shifted(scene: golden.Data, name: str, by: Fraction) -> golden.Data:
    """Return the scene with one number changed, exactly."""
    *path, last = name.split(".")
    changed: golden.Data = json.loads(json.dumps(scene))
    box = changed if last in changed else changed["arc"]
    if path:
        box = changed["friction"] if path[0] == "friction" else changed["effects"][path[0]]
    box[last] = Fraction(box[last]) + by
    return changed


def test_a_function_has_the_derivatives_of_the_law_that_it_is() -> None:
    """Derivatives of a function equal the derivatives of its law, also far beyond R/256, where its first table ends."""
    scene: Scene[Any] = load("vaiont")
    law = {"law": "exponential", "peak": 0.37, "residual": 0.17, "length": 3.0}
    free = solve(replace(scene, friction=lambda slip: 0.17 + 0.2 * np.exp(-slip / 3.0))).sensitivity()
    named = solve(replace(scene, friction=law)).sensitivity()
    for output in free.outputs:
        for name in free.parameters:
            error = free.error(output, name) + named.error(output, name)
            near = 1e-10 * abs(named.derivative(output, name)) + 1e-12  # of the table of the function
            assert abs(free.derivative(output, name) - named.derivative(output, name)) <= error + near


@pytest.mark.parametrize("accuracy", [1e-6, 1e-9, 1e-12])
def test_ensembles_of_a_function_have_the_digits_of_the_law_that_it_is(accuracy: float) -> None:
    """Pieces of its table are never as narrow as the rounding of their edges, and coefficients do not overflow."""
    vaiont: Scene[Any] = load("vaiont")
    scene = replace(vaiont, initial_velocity=np.array([0.0, 1e-9, 0.1]))
    law = {"law": "exponential", "peak": 0.37, "residual": 0.17, "length": 3.0}
    free = solve(replace(scene, friction=lambda slip: 0.17 + 0.2 * np.exp(-slip / 3.0)), accuracy)
    named = solve(replace(scene, friction=law), 1e-14)
    np.testing.assert_allclose(free.run_out, named.run_out, rtol=accuracy)
    assert np.all(free.error_estimate < accuracy)


def test_derivatives_where_a_pulse_ends() -> None:
    """Newmark's block under a rectangular pulse is fastest there, whatever the size of the circle."""
    motion = solve(load("newmark-pulse"))
    found, v = motion.sensitivity(), float(motion.peak.velocity)
    for number, expected in (("radius", 0.0), ("gravity", v / 9.81)):
        error = found.error("peak_velocity", number)
        assert abs(found.derivative("peak_velocity", number) - expected) <= error <= 1e-9 * v / found.at[number]


def test_derivatives_by_the_end_time_are_the_rates_there() -> None:
    cut = solve(replace(load("vaiont"), end_time=12.0))
    found = cut.sensitivity()
    for output, expected in {"duration": 1.0, "run_out": cut.end.velocity}.items():
        error = found.error(output, "end_time")
        assert abs(found.derivative(output, "end_time") - expected) <= error <= 1e-9 * max(expected, 1.0)


def test_a_kink_has_two_slopes() -> None:
    """Newmark's block speeds up evenly to the end of its pulse, and is not faster if it is followed longer."""
    scene: Scene[Any] = load("newmark-pulse")
    whole = solve(scene)
    start, end = scene.called["shaking"]["horizontal"].kinks.tolist()
    found = solve(replace(scene, end_time=end)).sensitivity()
    place = list(found.outputs).index("peak_velocity"), list(found.parameters).index("end_time")
    slopes, acceleration = found.slopes[place], float(whole.peak.velocity) / (end - start)
    assert found.kinds[place] == "kink"
    assert np.all(np.abs(slopes - [acceleration, 0.0]) <= found.slope_errors[place])
    assert np.all(found.slope_errors[place] <= 1e-9 * acceleration)
    assert found.values[place] == slopes.mean()


def test_a_circle_through_a_vertex_cuts_another_mass_off_beyond_it() -> None:
    """Raising the vertex: the derivative is that of lowering it, and the run-out is another at once."""
    scene: Scene[Any] = from_method(load("layered-slope"), "paper")
    found = solve(scene).sensitivity()
    place = list(found.outputs).index("run_out"), list(found.parameters).index("ground.1.y")
    step = 2.0**-10
    steps = np.array([-2.0, -1.0, 1.0, 2.0]) * step
    lowest, lower, higher, highest = grid(scene, {"ground.points_m.1.y": 25.0 + steps}).samples["run_out"]
    here = found.at["run_out"]
    assert found.kinds[place] == "jump"
    assert found.values[place] == pytest.approx((3 * here - 4 * lower + lowest) / (2 * step), rel=1e-5)
    assert found.jumps[place] == pytest.approx([0.0, 2 * higher - highest - here], rel=1e-4)
    assert abs(found.jumps[place][1]) > 0.2
    assert "unresolved" not in found.kinds


def check_motion(
    scene: golden.Data, which: Sequence[str] | slice, digits: int, cap: float = 1e-7, unknown: Sequence[str] = ()
) -> None:
    """Check derivatives with respect to some numbers within their error bounds, and that these are small.

    By exactly the numbers that are said to be `unknown` there are none.

    Beside differences of a step so short that one side is enough: half of the digits are the step's.
    """
    motion = solve(golden.built("", scene))
    found, free = motion.sensitivity(), parameters(motion.plan.scene)
    unresolved = {n for k, n in enumerate(found.parameters) if not np.all(np.isfinite(found.values[:3, k]))}
    assert unresolved == set(unknown), unresolved
    with ctx.workprec(130 + 3 * digits):
        released = not motion.arrested and scene["end_time"] is None
        here = outputs(scene, released, digits)
        for name in list(found.parameters)[which] if isinstance(which, slice) else which:
            if name in unknown:
                continue
            value = found.at[name]
            step = Fraction(value or 1.0) * Fraction(1, 10 ** (digits // 2 + 1))
            there = outputs(shifted(scene, name, step), released, digits)
            slopes = [(other - one) / oracle.exact(step) for one, other in zip(here, there, strict=True)]
            for output, slope in zip(EXACT, slopes, strict=True):
                exact, error = float(slope), found.error(output, name)
                off = abs(found.derivative(output, name) - exact)
                largest = max(abs(exact), abs(found.at[output]) / free[name].scale)
                seen = output, name, found.kind(output, name), found.derivative(output, name), exact, off, error
                assert off <= error <= cap * largest, seen


ROWS = [r["scene"] for r in json.loads(references.FILE.read_text("utf-8")) if r["group"] in ("frozen", "constant")]


LIFTED = range(len(ROWS) - references.LIFTED, len(ROWS))


@pytest.mark.parametrize("number", [*range(0, len(ROWS), 16), *LIFTED[::3]])
def test_random_scenes_against_differences(number: int) -> None:
    """Frozen and turning, all effects, swings, lift-off, next to the limit; every second number of each scene."""
    assert number not in LIFTED or solve(golden.built("", ROWS[number])).lift_off
    next_to_limit = accuracy.near_limit(number)
    check_motion(ROWS[number], slice(number // 16 % 2, None, 2), 42 if next_to_limit else 32)


@cache
def limit(opening: float, dip: float) -> float:
    middle = 1.5 * math.pi - dip
    arc = Arc(100.0, middle - opening / 2, middle + opening / 2, 2e4)
    return float(arc.dimensionless.limit_friction)


def hard(opening: float = 1.0, share: float = 0.5, dip: float = 0.4, **effects: dict[str, float]) -> dict[str, Any]:
    middle = 1.5 * math.pi - dip
    arc = {"radius": 100.0, "theta_1": middle - opening / 2, "theta_2": middle + opening / 2, "unit_weight": 2e4,
           "gravity": 9.81}  # fmt: skip
    return {"arc": arc, "friction": share * limit(opening, dip), "initial_velocity": 0.0, "end_time": None,
            "effects": {"rotation": {}, "centripetal": {}} | effects}  # fmt: skip


ALL = slice(None)
ENDS = ("friction", "theta_1", "theta_2")  # by which an 1e-9 from the limit no derivative is seen
HARD: dict[str, tuple[Any, ...]] = {
    "thin": (hard(1e-6), ALL, 32),
    "half disc": (hard(math.pi - 1e-9), ALL, 32, 2e-6),
    "limit-3": (hard(share=1.0 - 1e-3), ALL, 42),
    "limit-9": (hard(share=1.0 - 1e-9), ALL, 42, 5e-5, ENDS),
    "no friction": (hard(share=0.0), ALL, 32),
    "many swings": (hard(share=0.06), ("friction", "theta_1"), 32),
    "weak brake": (hard(drag={"xi": 1e9}), ALL, 32),
    "strong brake": (hard(drag={"xi": 0.1}), ("friction", "drag.xi"), 32),
    "strong brake at the limit": (hard(share=1.0 - 1e-6, drag={"xi": 10.0}), ALL, 42, 2e-6),
    "water": (hard(share=0.9, cohesion={"cohesion": 100.0}, pore_pressure={"ratio": 0.05, "pressure": 50.0}), ALL, 32),
}


@pytest.mark.parametrize("which", HARD)
def test_hard_scenes_against_differences(which: str) -> None:
    check_motion(*HARD[which])


def test_a_table_has_the_numbers_that_are_not_given_and_none_at_the_limit() -> None:
    found = solve(load("vaiont-as-printed")).sensitivity()
    assert list(found.parameters) == ["friction", "radius", "unit_weight", "gravity", "end_time"]
    assert "run-out (m)" in str(found)
    still = solve(replace(load("vaiont"), friction=0.6)).sensitivity()
    assert not still.values.any()
    assert np.isnan(still.elasticities).all()
    at_limit = replace(load("vaiont"), friction=float(load("vaiont").arc.dimensionless.limit_friction))
    with pytest.raises(ValueError, match="exactly at its limit"):
        solve(at_limit).sensitivity()


# --- the command ---------------------------------------------------------------------------------------------------

KEYS = {"friction.angle_deg": 24.0, "arc.theta_2_deg": 280.0, "arc.radius_m": 40.0, "arc.unit_weight_kN_m3": 20.0,
        "pore_pressure.ratio": 0.35, "cohesion.cohesion_kPa": 3.0}  # fmt: skip


def test_the_command_is_per_unit_of_the_keys(said: Any) -> None:
    """Per degree and per kPa: against differences of scenes that differ in that key of their file."""
    cells: dict[str, list[str]] = {}  # columns that do not fit follow below the others
    for line in said("sensitivity wet-slope").splitlines():
        if "." in line and line.split():
            key, *rest = line.split()
            cells.setdefault(key, [key]).extend(rest)
    for key, value in KEYS.items():
        step = 1e-4 * value
        samples = grid(load("wet-slope"), {key: [value - step, value + step]}).samples
        assert float(cells[key][1]) == value
        for k, output in enumerate(EXACT):
            slope, mean = np.diff(samples[output])[0] / (2 * step), np.mean(samples[output])
            assert float(cells[key][4 + 2 * k]) == pytest.approx(slope, rel=1e-3)
            assert float(cells[key][5 + 2 * k].strip("()")) == pytest.approx(slope * value / mean, rel=0.06)


def test_the_command_for_machines(said: Any, records: Any) -> None:
    (record,) = records("sensitivity vaiont")
    found = solve(load("vaiont")).sensitivity()
    assert record["parameters"]["theta_1"] == "rad"
    column, row = list(record["parameters"]).index("theta_1"), list(record["outputs"]).index("run_out")
    assert record["values"][row][column] == found.derivative("run_out", "theta_1")
    assert "friction.length_m" in said("sensitivity vaiont-softening")


def test_derivatives_print_the_table_of_the_command_and_draw_its_picture(said: Any, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    derivatives = solve(load("real-slope")).sensitivity()
    assert str(derivatives).splitlines() == said("sensitivity real-slope").rstrip("\n").splitlines()
    derivatives.plot(tmp_path / "tornado.png")
    assert (tmp_path / "tornado.png").stat().st_size > 10_000
