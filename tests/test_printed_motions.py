"""Printed and written numbers of motions, which `test_golden` compares with the definitions."""

import json
import math
import re
from dataclasses import asdict, replace
from typing import Any

import numpy as np
import pytest

from slipcircle import Arc, Motion, Scene, solve
from slipcircle.workbench.common.trace import csv, telling_times
from slipcircle.workbench.outputs.json_records import record
from tests.support import golden
from tests.support.outputs import printed

SCENES = (
    "constant, rising water", "exponential, cohesion", "rate, turning, mirrored", "rests in between, turning",
    "lifts off and lands, pushed up", "lifted from the start, mirrored", "stays", "swings back twice", "vaiont-heated",
)  # fmt: skip
EACH = pytest.mark.parametrize("name", SCENES)
COEFFICIENTS = {"Theta*": "moment_of_inertia", "J_theta": "weight_moment", "J_r": "radial_weight",
                "lambda": "resistance_factor", "A": "dynamic_coefficient"}  # fmt: skip


@EACH
def test_a_record_holds_every_number_in_si_units_and_radians(name: str) -> None:
    m = golden.solved(name)
    found = json.loads(json.dumps(record(m), allow_nan=False))
    wanted: dict[str, Any] = {part: asdict(getattr(m, part)) for part in ("farthest", "peak", "end")}
    wanted["energy"] = asdict(m.energy) | {"residual": m.energy.residual}
    wanted["dimensionless"] = asdict(m.plan.scene.arc.dimensionless)
    for key in ("moves", "arrested", "run_out", "duration", "error_estimate", "factor_of_safety", "friction"):
        wanted[key] = getattr(m, key)
    for key in ("limit_friction", "yield_coefficient"):
        wanted[key] = getattr(m, key) if math.isfinite(getattr(m, key)) else None
    assert {key: found[key] for key in wanted} == wanted
    assert (found["effects"], found["left_out"]) == (list(m.plan.effects), list(m.plan.left_out))
    assert sum("lift-off" in w for w in found["warnings"]) == (len(m.lift_off) > 0)
    law = m.plan.scene.friction
    assert found["law"] == (law if isinstance(law, dict) else {"law": "constant"})


def law(m: Motion, path: float, speed: float) -> float:
    """Friction after a slip at a speed, by the laws of these scenes."""
    given = m.plan.scene.friction
    if not isinstance(given, dict):
        return float(np.asarray(given))
    passed = path / given["length"] if given["law"] == "exponential" else math.log1p(speed / given["velocity"])
    return float(given["residual"] + (given["peak"] - given["residual"]) * math.exp(-passed))


def holding(m: Motion, rotation: float, pressure: float) -> float:
    """Return the friction at which the mass, turned that far, would just stay: the limit friction of the turned arc."""
    scene = m.plan.scene
    assert isinstance(scene.arc, Arc)
    turn = float(scene.arc.facing) * rotation
    arc = replace(scene.arc, theta_1=scene.arc.theta_1 + turn, theta_2=scene.arc.theta_2 + turn)
    effects = {name: scene.called[name] for name in ("cohesion",) if name in scene.called}
    turned = Scene(arc, 9.0, effects | {"pore_pressure": {"pressure": max(pressure, 0.0)}}, end_time=1e-9)
    return max(float(solve(turned).limit_friction), 0.0)


@EACH
def test_every_column_of_the_csv(name: str) -> None:
    """Columns equal the motion's numbers, with rows at the times at which it starts and stops."""
    m = golden.solved(name)
    columns = np.genfromtxt(csv([m], telling_times(m)).decode().splitlines(), delimiter=",", names=True)
    columns = np.atleast_1d(columns)
    times = columns["time_s"]
    assert np.all(np.diff(times) > 0.0)
    assert {0.0, m.duration, *(float(t) for phase in m.phases for t in (phase.start, phase.end))} <= {*times}
    state, energy = m.at(times), m.energy_at(times)
    wanted = {
        "rotation_rad": state.rotation, "displacement_m": state.displacement, "velocity_m_s": state.velocity,
        "angular_velocity_rad_s": state.angular_velocity, "acceleration_m_s2": state.acceleration,
        "normal_stress_Pa": state.normal_stress, "kinetic_energy_J": energy.kinetic_end,
        "work_of_gravity_and_shaking_J": energy.work, "dissipation_J": energy.dissipation,
    }  # fmt: skip
    for head, values in wanted.items():
        np.testing.assert_array_equal(columns[head], values, head)
    path = np.cumsum(np.abs(np.diff(state.displacement, prepend=0.0)))
    np.testing.assert_allclose(columns["path_m"], path, rtol=1e-9, atol=1e-15)
    pressure = m.pore_pressure_at(times)
    stress = float(np.max(np.abs(state.normal_stress)))
    left = state.normal_stress - pressure
    np.testing.assert_allclose(columns["effective_stress_Pa"], np.maximum(left, 0.0), atol=1e-9 * stress)
    for k in np.flatnonzero(np.abs(left) > 1e-6 * stress)[::20]:
        slides = law(m, float(path[k]), abs(float(state.velocity[k]))) if left[k] > 0.0 else 0.0
        assert columns["friction"][k] == pytest.approx(slides, rel=1e-9), times[k]
        if not {"shaking", "thermal_pressurisation"} & {*m.plan.effects}:
            needed = holding(m, float(state.rotation[k]), float(pressure[k])) if left[k] > 0.0 else math.nan
            assert columns["holding_friction"][k] == pytest.approx(needed, rel=1e-9, abs=1e-9, nan_ok=True), times[k]
    assert len(csv([m]).splitlines()) == (402 if m.moves else 2)  # by default at even times
    if "shaking" in m.plan.effects:  # it starts where friction falls to what holds it, and stands where that is less
        rests = (state.velocity == 0.0) & (times > 0.0)
        assert np.all(columns["holding_friction"][rests] <= columns["friction"][rests] * (1.0 + 1e-6))
        for phase in m.phases:
            at = int(np.flatnonzero(times == phase.start)[0])
            assert columns["holding_friction"][at] == pytest.approx(columns["friction"][at], rel=1e-6)


@EACH
def test_the_table_of_a_motion(name: str) -> None:
    """Numbers to four digits, dimensionless coefficients to five decimals."""
    m = golden.solved(name)
    cells, found = printed(m), record(m)
    wanted: dict[str, float] = {
        "factor of safety by the paper's method": m.factor_of_safety, "yield coefficient k_y": m.yield_coefficient,
        "limit friction angle": math.degrees(math.atan(m.limit_friction)), "velocity at the end": m.end.velocity,
        "friction angle": math.degrees(math.atan(found["friction"])), "run-out along the arc": m.run_out,
        "mean normal stress at the start": m.plan.scene.arc.static_normal_stress, "duration": m.duration,
        "rotation at the end": math.degrees(m.end.rotation), "peak velocity": m.peak.velocity,
        "mean normal stress at the end": m.end.normal_stress,
    }  # fmt: skip
    if not m.moves:
        assert (cells["comes to rest"], cells["duration"]) == ("does not move", "does not move")
        del wanted["duration"]
    for label, value in wanted.items():
        parts = re.fullmatch(r"(?:.* at )?([-\d.e]+) ?(\S*?)(?:, .*)?", cells[label])
        assert parts, cells[label]
        shown = float(parts[1]) * {"kPa": 1e3, "MPa": 1e6}.get(parts[2], 1.0)
        assert shown == pytest.approx(value, rel=5.1e-4, abs=1e-12), label
    for label, field in COEFFICIENTS.items():
        assert cells[label] == f"{found['dimensionless'][field]:.5f}"
    assert cells["moves"] == ("yes" if m.moves else "no")
    assert not m.moves or cells["comes to rest"].partition(",")[0] == ("yes" if m.arrested else "no")
    assert ("still moving at" in cells["duration"]) == (m.moves and not m.arrested)
    assert cells["effects"] == ", ".join(m.plan.effects)
    assert float(cells["estimated error"]) == pytest.approx(m.error_estimate, rel=0.1)
