"""What is printed and written of a motion, number by number, against motions solved in ball arithmetic.

The numbers come from the same scenes by quadrature of the definitions and Taylor series (`taylor`).
"""

import math
import re
from functools import cache
from typing import Any

import numpy as np
import pytest
from flint import arb, arb_series, ctx

from slipcircle import Motion, solve
from slipcircle.workbench.common.quantities import record
from slipcircle.workbench.outputs.tables import motion_column
from slipcircle.workbench.outputs.trace import csv, telling_times
from tests.support import golden, oracle, taylor

WAVES = {"pulse": "sine", "amplitude": 0.28, "duration": 4.0, "cycles": 3.0, "vertical_amplitude": 0.1}
WET = {"cohesion": {"cohesion": 3e3}, "drag": {"xi": 300.0}, "pore_pressure": {"ratio": 0.15}}
RISING = {"time": [0.0, 2.0, 6.0], "pressure": [1e4, 6e4, 1e4]}
SCENES: dict[str, golden.Data] = {
    "softens": golden.mirrored(golden.scene(golden.LAWS["exponential"], golden.TURNING | WET, 2.5)),
    "rests": golden.scene(0.36, golden.TURNING | {"shaking": WAVES}, 0.0, 7.0),
    "rests-mirrored": golden.mirrored(golden.scene(0.36, golden.TURNING | {"shaking": WAVES}, 0.0, 7.0)),
    "lifts": golden.rows()["lifts off and lands, pushed up"] or {},
    "starts-lifted": golden.rows()["lifted from the start"] or {},
    "stays": golden.scene(0.3, golden.TURNING | {"cohesion": {"cohesion": 5e3}}),
    "swings": golden.mirrored(golden.scene(0.04, golden.TURNING)),
    "slides": golden.mirrored(golden.scene(0.14, golden.TURNING, 1.0)),
    "far": golden.mirrored(golden.scene(0.1, {"rotation": {}}, 6.0)),
    "flows": golden.scene(golden.LAWS["rate"], {"rotation": {}, "viscosity": golden.CREEP}, -1.0, 5.0),
    "heats": golden.scene(0.22, golden.TURNING | {"thermal_pressurisation": golden.HEAT, "pore_pressure": RISING}),
}  # fmt: skip
EACH = pytest.mark.parametrize("name", SCENES)


class Exact:
    """A scene's numbers from the definitions, in SI units."""

    def __init__(self, given: golden.Data) -> None:
        ctx.prec = 160
        given = golden.to_the_right(given)
        self.effects = given["effects"]
        self.motion = taylor.Solution(taylor.Problem(given), 26, 22)
        dry = {name: effect for name, effect in self.effects.items() if name != "pore_pressure"}
        self.p, self.dry = self.motion.p, taylor.Problem(given | {"effects": dry})
        self.m = {k: float(v) for k, v in oracle.moments(given["arc"]).items()}
        self.scale, self.radius = float(self.p.scale), given["arc"]["radius"]
        self.duration = float(self.motion.duration * self.p.scale)
        self.run_out = float(self.motion.run_out) * self.radius
        self.peak = abs(float(self.motion.peak()[1])) * self.radius / self.scale
        self.unit = self.m["reference_stress"] / self.m["level"]
        weight = given["arc"]["unit_weight"] * self.radius**3 * self.m["inertia"]
        self.inertia, self.weight = weight * self.scale**2, weight * self.m["fall"]
        self.held = self.effects.get("cohesion", {}).get("cohesion", 0.0) / self.unit

    def state(self, t: float) -> tuple[float, float]:
        """Rotation and angular velocity, 1/s."""
        at, last = taylor.number(t) / self.p.scale, self.motion.duration
        if not self.motion.arrested and at > last * (1 - 1e-12):
            at = last * (1 - arb(2) ** -90)  # the end itself is a rest to the other side
        x, omega = self.motion.state(at)
        return float(x), float(omega) / self.scale

    def friction(self, slip: float, speed: float) -> float:
        p, x, v = self.p, arb(slip / self.radius), arb(speed) / self.p.unit
        return float(p.mu(arb_series([x]), arb_series([v]), arb(0), p.slip.at(x), p.speed.at(v))[0])

    def forces(self, t: float, rotation: float, omega: float = 0.0) -> tuple[float, float, float]:
        """Drive down-slope over the weight's moment; normal stress, and what water leaves of it, Pa."""
        at = taylor.number(t) / self.p.scale
        (fall, press), (_, left) = (p.pressed(arb_series([rotation]), at, 1) for p in (self.dry, self.p))
        polar = float(self.p.polar) * (omega * self.scale) ** 2
        return float(fall[0]), (float(press[0]) + polar) * self.unit, (float(left[0]) + polar) * self.unit

    def start(self) -> tuple[float, float, float, float]:
        """Limit friction, factor of safety, yield coefficient and normal stress, before the shaking."""
        (fall, stress, left), m, mu = self.forces(-1.0, 0.0), self.m, self.friction(0.0, 0.0)
        pressed = max(left, 0.0) / self.unit
        limit = (abs(fall) - self.held) / pressed if pressed else math.inf
        along, across = m["fall"] * math.cos(m["dip"]), -m["press"] * abs(math.sin(m["dip"]))
        resisting = self.held + mu * pressed
        yields = (resisting - abs(fall)) / (along - mu * bool(pressed) * across)
        return limit, resisting / abs(fall), yields, stress

    def coefficients(self) -> tuple[float, ...]:
        """Theta*, J_theta, J_r, lambda and A of the arc."""
        m = self.m
        turned = (m["fall"] * math.sin(m["dip"]), m["press"] * math.cos(m["dip"]), m["level"])
        return m["inertia"], *(m["inertia"] * x for x in turned), m["polar"] / m["level"]

    def holding(self, fall: float, left: float, rotation: float) -> float:
        """The friction at which it would just stay; one way where shaking may start it down-slope only."""
        if left <= 0.0:
            return math.nan
        drive = math.copysign(fall, fall * (self.m["dip"] - rotation)) if "shaking" in self.effects else abs(fall)
        return max(drive - self.held, 0.0) * self.unit / left

    def energies(self, t: float) -> tuple[float, float]:
        """Kinetic, and of gravity, J."""
        (rotation, omega), dip = self.state(t), self.m["dip"]
        return self.inertia * omega**2 / 2, self.weight * (math.cos(dip - rotation) - math.cos(dip))


@cache
def exact(name: str) -> Exact:
    return Exact(SCENES[name])


@cache
def solved(name: str) -> Motion:
    motion = solve(golden.built(name, SCENES[name]))
    assert isinstance(motion, Motion)
    return motion


# --- for machines ----------------------------------------------------------------------------------------------------


def differences(found: Any, wanted: dict[str, tuple[float, float, float]]) -> list[str]:
    """Names of the numbers that differ by more than a share of the wanted one and a least difference."""
    return [
        f"{name}: {found[name]}, not {value}"
        for name, (value, rel, least) in wanted.items()
        if found[name] != pytest.approx(value, rel=rel, abs=least, nan_ok=True)
    ]


@EACH
def test_records_hold_every_number_in_si_units_and_radians(name: str) -> None:
    """What ``run --json`` prints (`test_cli`)."""
    found, e, given = record(solved(name)), exact(name), SCENES[name]
    assert (found["scene"], found["moves"], found["arrested"]) == (name, bool(e.motion.steps), e.motion.arrested)
    assert set(found["effects"]) == set(e.effects)
    assert not set(found["left_out"]) & set(e.effects)
    assert abs(found["peak"]["velocity"]) == pytest.approx(e.peak, rel=1e-9)
    for state in (found["peak"], found["end"]):
        rotation, omega = e.state(state["time"])
        _, stress, _ = e.forces(state["time"], rotation, omega)
        assert not differences(state, {
            "rotation": (rotation, 1e-9, 0.0), "displacement": (e.radius * rotation, 1e-9, 0.0),
            "angular_velocity": (omega, 1e-9, 1e-9 * e.peak / e.radius),
            "velocity": (e.radius * omega, 1e-9, 1e-9 * e.peak), "normal_stress": (stress, 1e-8, 0.0),
        })  # fmt: skip
    limit, safety, yields, _ = e.start()
    kinetic, gravity = e.energies(e.duration)
    start = e.inertia * (given["initial_velocity"] / e.radius) ** 2 / 2
    energy, total = found["energy"], start + abs(gravity)
    wanted = {
        "duration": (e.duration, 1e-9, 0.0), "run_out": (e.run_out, 1e-9, 0.0),
        "factor_of_safety": (safety, 1e-12, 0.0), "friction": (e.friction(0.0, 0.0), 1e-12, 0.0),
        "kinetic_start": (start, 1e-12, 0.0), "kinetic_end": (kinetic, 1e-8, 1e-12 * total),
        "residual": (0.0, 0.0, 1e-9 * total),
    }  # fmt: skip
    if limit < math.inf:
        wanted |= {"limit_friction": (limit, 1e-12, 0.0), "yield_coefficient": (yields, 1e-12, 0.0)}
    else:
        assert found["limit_friction"] is None
    if "shaking" not in e.effects:
        wanted |= {"work": (gravity, 1e-8, 0.0), "dissipation": (gravity + start - kinetic, 1e-8, 1e-12 * total)}
    assert not differences(found | energy, wanted)
    spent = energy["work"] + energy["kinetic_start"] - energy["kinetic_end"] - energy["dissipation"]
    assert spent == pytest.approx(energy["residual"], abs=1e-12 * total)
    names = ("moment_of_inertia", "weight_moment", "radial_weight", "resistance_factor", "dynamic_coefficient")
    assert [found["dimensionless"][name] for name in names] == pytest.approx(e.coefficients(), rel=1e-12)
    assert (0.0 if name == "stays" else 2e-16) <= found["error_estimate"] <= 1e-9
    assert sum("lift-off" in w for w in found["warnings"]) == (name in ("lifts", "starts-lifted"))
    assert not isinstance(given["friction"], dict) or found["law"] == given["friction"]


@EACH
def test_every_column_of_the_csv(name: str) -> None:
    """At every tenth time, and with rows where it starts and stands."""
    motion, e = solved(name), exact(name)
    head, *lines = csv([motion], telling_times(motion)).decode().splitlines()
    rows = [dict(zip(head.split(","), map(float, line.split(",")), strict=True)) for line in lines]
    times = np.array([r["time_s"] for r in rows])
    assert np.all(np.diff(times) > 0.0)
    starts = np.array([float(step.start) * e.scale for step in e.motion.steps])
    ends = np.array([float(step.start + step.length) * e.scale for step in e.motion.steps])
    rests = starts[1:] - ends[:-1] > 1e-6 * e.scale
    for change in (0.0, e.duration, *starts[:1], *ends[:-1][rests], *starts[1:][rests], *ends[-1:]):
        assert np.min(np.abs(times - change)) <= 1e-8 * e.duration
    assert name != "rests" or np.count_nonzero(rests) >= 2
    path = np.cumsum(np.abs(np.diff([r["displacement_m"] for r in rows], prepend=0.0)))
    assert [r["path_m"] for r in rows] == pytest.approx(path.tolist(), rel=1e-12, abs=1e-15)
    energy = max(abs(r["work_of_gravity_and_shaking_J"]) + r["kinetic_energy_J"] for r in rows) + 1e-300
    for k, r in enumerate(rows):
        end = k in (0, len(rows) - 1)
        edge = "shaking" in e.effects and k > 0 and min(times[k], abs(times[k] - 4.0)) < 1e-9  # of the waves
        if not edge and (end or not k % 10):
            assert not differences(r, expected(e, r, energy, rows[0]["kinetic_energy_J"], end)), times[k]
    assert max(abs(r["velocity_m_s"]) for r in rows) == pytest.approx(e.peak, rel=1e-9)


def expected(e: Exact, r: dict[str, float], energy: float, start: float, end: bool) -> dict[str, Any]:
    """What a row of the CSV must hold at its time: value, share of it and least difference allowed."""
    rotation, omega = e.state(r["time_s"])
    fall, stress, left = e.forces(r["time_s"], rotation, omega)
    heats, unit = "thermal_pressurisation" in e.effects, e.m["reference_stress"]
    left = r["effective_stress_Pa"] if heats else left
    law, pressed = e.friction(r["path_m"], abs(e.radius * omega)), max(left, 0.0)
    kinetic, gravity = e.energies(r["time_s"])
    spent = r["work_of_gravity_and_shaking_J"] - r["kinetic_energy_J"] + start
    wanted = {
        "rotation_rad": (rotation, 1e-8, 1e-9 * abs(e.run_out) / e.radius),
        "displacement_m": (e.radius * rotation, 1e-8, 1e-9 * abs(e.run_out)),
        "angular_velocity_rad_s": (omega, 1e-7, 1e-8 * e.peak / e.radius + 1e-300),
        "velocity_m_s": (e.radius * omega, 1e-7, 1e-8 * e.peak + 1e-300), "normal_stress_Pa": (stress, 1e-7, 0.0),
        "effective_stress_Pa": (pressed, 1e-7, 1e-7 * unit), "kinetic_energy_J": (kinetic, 1e-6, 1e-8 * energy),
        "dissipation_J": (spent, 1e-6, 1e-8 * energy),
    }  # fmt: skip
    if abs(left) > 1e-6 * unit:
        wanted["friction"] = (law if left > 0.0 else 0.0, 1e-6, 0.0)
        if not heats:
            fall_at_rest, _, left_at_rest = e.forces(r["time_s"], rotation)
            wanted["holding_friction"] = (e.holding(fall_at_rest, left_at_rest, rotation), 1e-6, 1e-8)
    if "shaking" not in e.effects:
        wanted["work_of_gravity_and_shaking_J"] = (gravity, 1e-6, 1e-8 * energy)
    if not end and abs(omega) > 1e-6 * e.peak / e.radius:
        way, brakes = math.copysign(1.0, omega), float(e.p.drag) * (omega * e.scale) ** 2
        rate = fall - way * (law * pressed / e.unit + e.held + brakes) - float(e.p.viscosity) * omega * e.scale
        wanted["acceleration_m_s2"] = (rate * e.radius / e.scale**2, 1e-5, 1e-5)
    return wanted


# --- for people ------------------------------------------------------------------------------------------------------


@EACH
def test_the_table_of_a_motion(name: str) -> None:
    """Numbers of its record to four digits, dimensionless coefficients to five decimals."""
    cells, found = motion_column(solved(name)), record(solved(name))
    _, _, _, stress = exact(name).start()
    wanted: dict[str, float] = {
        "factor of safety": found["factor_of_safety"], "yield coefficient k_y": found["yield_coefficient"],
        "limit friction angle": math.degrees(math.atan(found["limit_friction"] or math.inf)),
        "friction angle": math.degrees(math.atan(found["friction"])), "mean normal stress at the start": stress,
        "run-out along the arc": found["run_out"], "rotation at the end": math.degrees(found["end"]["rotation"]),
        "velocity at the end": found["end"]["velocity"], "peak velocity": found["peak"]["velocity"],
        "mean normal stress at the end": found["end"]["normal_stress"], "duration": found["duration"],
    }  # fmt: skip
    if not found["moves"]:
        assert (cells["comes to rest"], cells["duration"]) == ("does not move", "-")
        del wanted["duration"]
    for label, value in wanted.items():
        number, unit = re.fullmatch(r"(?:.* at )?([-\d.e]+) ?(\S*?)(?:, .*)?", cells[label]).groups()  # type: ignore[union-attr]
        factor = {"kPa": 1e3, "MPa": 1e6}.get(unit, 1.0)
        assert factor * float(number) == pytest.approx(value, rel=5.1e-4, abs=1e-12), label
    names = ("moment_of_inertia", "weight_moment", "radial_weight", "resistance_factor", "dynamic_coefficient")
    shown = [f"{found['dimensionless'][of]:.5f}" for of in names]
    assert [cells[label] for label in ("Theta*", "J_theta", "J_r", "lambda", "A")] == shown
    assert cells["moves"] == ("yes" if found["moves"] else "no")
    assert not found["moves"] or cells["comes to rest"].partition(",")[0] == ("yes" if found["arrested"] else "no")
    assert ("still moving at" in cells["duration"]) == (found["moves"] and not found["arrested"])
    assert set(cells["effects"].split(", ")) == set(found["effects"])
    assert float(cells["estimated error"]) == pytest.approx(found["error_estimate"], rel=0.1)
