"""What the command line prints and writes, number by number, against motions solved in ball arithmetic.

Scene files are written here in the units of their keys; the numbers beside which the outputs are laid come from the
same scenes in SI units, by quadrature of the definitions and Taylor series (`taylor`).
"""

import math
import re
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from flint import arb, arb_series, ctx

from slipcircle import load, solve
from slipcircle.workbench.outputs.trace import csv, telling_times
from tests.campaigns import fuzz_scenes
from tests.support import golden, oracle, taylor
from tests.support.outputs import columns

KEYS: dict[str, tuple[str, Callable[[float], Any]]] = {  # of a scene file, and its unit's number from the SI one
    "pressure": ("pressure_kPa", lambda x: x / 1e3), "cohesion": ("cohesion_kPa", lambda x: x / 1e3),
    "xi": ("xi_m_s2", float), "viscosity": ("viscosity_Pa_s", float), "thickness": ("thickness_m", float),
    "amplitude": ("amplitude_g", float), "vertical_amplitude": ("vertical_amplitude_g", float),
    "duration": ("duration_s", float), "start": ("start_s", float), "length": ("length_m", float),
    "velocity": ("velocity_m_s", float), "pressurisation": ("pressurisation_MPa_K", lambda x: x / 1e6),
    "heat_capacity": ("heat_capacity_MJ_m3_K", lambda x: x / 1e6),
    "peak": ("peak_deg", lambda mu: math.degrees(math.atan(mu))),
    "angle": ("angle_deg", lambda mu: math.degrees(math.atan(mu))),
}  # fmt: skip
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


def toml(name: str, given: golden.Data) -> str:
    """A scene as its file."""
    arc, law = given["arc"], given["friction"]

    def keyed(values: Mapping[str, Any]) -> dict[str, Any]:
        if "time" in values:
            return {"time_s": values["time"], "pressure_kPa": [p / 1e3 for p in values["pressure"]]}
        found = ((*KEYS.get(name, (name, float)), value) for name, value in values.items())
        return {key: value if isinstance(value, str | bool) else of(value) for key, of, value in found}

    document = {"name": name, "initial_velocity_m_s": given["initial_velocity"]}
    document |= {} if given["end_time"] is None else {"end_time_s": given["end_time"]}
    document["arc"] = {"radius_m": arc["radius"], "unit_weight_kN_m3": arc["unit_weight"] / 1e3}
    document["arc"] |= {f"theta_{k}_deg": math.degrees(arc[f"theta_{k}"]) for k in (1, 2)}
    document["friction"] = keyed(law if isinstance(law, dict) else {"angle": law})
    return fuzz_scenes.toml(document | {effect: keyed(values) for effect, values in given["effects"].items()})


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


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    folder = tmp_path_factory.mktemp("scenes")
    for name, given in SCENES.items():
        (folder / f"{name}.toml").write_text(toml(name, given), "utf-8")
    return {name: folder / f"{name}.toml" for name in SCENES}


# --- for machines ----------------------------------------------------------------------------------------------------


def same(found: Any, wanted: dict[str, tuple[float, float, float]]) -> None:
    """Each wanted number within a share of it, or a least difference."""
    for name, (value, rel, least) in wanted.items():
        assert found[name] == pytest.approx(value, rel=rel, abs=least, nan_ok=True), name


@EACH
def test_json(name: str, files: dict[str, Path], records: Any) -> None:
    """Every number, in SI units and radians."""
    (record,) = records("run", files[name])
    e, given = exact(name), SCENES[name]
    assert (record["scene"], record["moves"], record["arrested"]) == (name, bool(e.motion.steps), e.motion.arrested)
    assert set(record["effects"]) == set(e.effects)
    assert not set(record["left_out"]) & set(e.effects)
    assert abs(record["peak"]["velocity"]) == pytest.approx(e.peak, rel=1e-9)
    for state in (record["peak"], record["end"]):
        rotation, omega = e.state(state["time"])
        same(state, {
            "rotation": (rotation, 1e-9, 0.0), "displacement": (e.radius * rotation, 1e-9, 0.0),
            "angular_velocity": (omega, 1e-9, 1e-9 * e.peak / e.radius),
            "velocity": (e.radius * omega, 1e-9, 1e-9 * e.peak),
            "normal_stress": (e.forces(state["time"], rotation, omega)[1], 1e-8, 0.0),
        })  # fmt: skip
    limit, safety, yields, _ = e.start()
    wanted = {"duration": (e.duration, 1e-9, 0.0), "run_out": (e.run_out, 1e-9, 0.0),
              "factor_of_safety": (safety, 1e-12, 0.0), "friction": (e.friction(0.0, 0.0), 1e-12, 0.0)}  # fmt: skip
    if limit < math.inf:
        wanted |= {"limit_friction": (limit, 1e-12, 0.0), "yield_coefficient": (yields, 1e-12, 0.0)}
    else:
        assert record["limit_friction"] is None
    same(record, wanted)
    kinetic, gravity = e.energies(e.duration)
    start = e.inertia * (given["initial_velocity"] / e.radius) ** 2 / 2
    energy, total = record["energy"], start + abs(gravity)
    spent = energy["work"] + energy["kinetic_start"] - energy["kinetic_end"] - energy["dissipation"]
    wanted = {"kinetic_start": (start, 1e-12, 0.0), "kinetic_end": (kinetic, 1e-8, 1e-12 * total),
              "residual": (spent, 0.0, 1e-12 * total)}  # fmt: skip
    if "shaking" not in e.effects:
        wanted |= {"work": (gravity, 1e-8, 0.0), "dissipation": (gravity + start - kinetic, 1e-8, 1e-12 * total)}
    same(energy, wanted)
    assert abs(energy["residual"]) <= 1e-9 * total
    names = ("moment_of_inertia", "weight_moment", "radial_weight", "resistance_factor", "dynamic_coefficient")
    found = [record["dimensionless"][name] for name in names]
    assert found == pytest.approx(e.coefficients(), rel=1e-12)
    assert (0.0 if name == "stays" else 2e-16) <= record["error_estimate"] <= 1e-9
    assert sum("lift-off" in w for w in record["warnings"]) == (name in ("lifts", "starts-lifted"))
    if isinstance(given["friction"], dict):
        numbers = {k: (v, 1e-15, 0.0) for k, v in given["friction"].items() if k != "law"}
        assert record["law"]["law"] == given["friction"]["law"]
        same(record["law"], numbers)


@EACH
def test_csv(name: str, files: dict[str, Path], tmp_path: Path, said: Any) -> None:
    """Every column at every tenth time, and the times at which it starts and stands; by default at even times."""
    motion, e = solve(load(files[name])), exact(name)
    said("run", files[name], "--csv", tmp_path / "motion.csv")
    assert (tmp_path / "motion.csv").read_bytes() == csv([motion])
    found = [float(line.split(",")[0]) for line in csv([motion]).decode().splitlines()[1:]]
    assert found == pytest.approx(np.linspace(0.0, e.duration, 401 if e.motion.steps else 1), rel=1e-9)
    head, *lines = csv([motion], telling_times(motion)).decode().splitlines()
    rows = [dict(zip(head.split(","), map(float, line.split(",")), strict=True)) for line in lines]
    times = [r["time_s"] for r in rows]
    assert times == sorted(set(times))
    assert [times[0], times[-1]] == pytest.approx([0.0, e.duration], rel=1e-9)
    assert all(min(abs(time - t) for t in times) <= 1e-8 * e.duration for time in episodes(e))
    assert name != "rests" or len(episodes(e)) >= 6
    path, before, unit = 0.0, 0.0, e.m["reference_stress"]
    energy = max(abs(r["work_of_gravity_and_shaking_J"]) + r["kinetic_energy_J"] for r in rows) + 1e-300
    for k, r in enumerate(rows):
        path += abs(r["displacement_m"] - before)
        before = r["displacement_m"]
        assert r["path_m"] == pytest.approx(path, rel=1e-12, abs=1e-15)
        t, end = r["time_s"], k in (0, len(rows) - 1)
        edge = "shaking" in e.effects and k > 0 and min(t, abs(t - 4.0)) < 1e-9  # where the waves begin and end
        if edge or (k % 10 and not end):
            continue
        rotation, omega = e.state(t)
        fall, stress, left = e.forces(t, rotation, omega)
        heats = "thermal_pressurisation" in e.effects
        left = r["effective_stress_Pa"] if heats else left
        law, pressed = e.friction(path, abs(e.radius * omega)), max(left, 0.0)
        kinetic, gravity = e.energies(t)
        spent = r["work_of_gravity_and_shaking_J"] - r["kinetic_energy_J"] + rows[0]["kinetic_energy_J"]
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
                held = e.forces(t, rotation)
                wanted["holding_friction"] = (e.holding(held[0], held[2], rotation), 1e-6, 1e-8)
        if "shaking" not in e.effects:
            wanted["work_of_gravity_and_shaking_J"] = (gravity, 1e-6, 1e-8 * energy)
        if not end and abs(omega) > 1e-6 * e.peak / e.radius:
            way, brakes = math.copysign(1.0, omega), float(e.p.drag) * (omega * e.scale) ** 2
            rate = fall - way * (law * pressed / e.unit + e.held + brakes) - float(e.p.viscosity) * omega * e.scale
            wanted["acceleration_m_s2"] = (rate * e.radius / e.scale**2, 1e-5, 1e-5)
        same(r, wanted)
    assert max(abs(r["velocity_m_s"]) for r in rows) == pytest.approx(e.peak, rel=1e-9)


def episodes(e: Exact) -> list[float]:
    """When it starts to slide and when it stands, s."""
    found, last = [], None
    for step in e.motion.steps:
        start, end = (float(t) * e.scale for t in (step.start, step.start + step.length))
        if last is None or start - last > 1e-6 * e.scale:
            found += [start] if last is None else [last, start]
        last = end
    return found + [last] if last else []


# --- for people ------------------------------------------------------------------------------------------------------


PREFIXES = {"k": 1e3, "M": 1e6, "G": 1e9}


def near(cell: str, value: float, unit: str = "", decimals: int | None = None) -> bool:
    """Whether a cell shows this value, rounded as it should be: to four significant digits, or to decimals."""
    found = re.fullmatch(r"(-?[\d.]+(?:e[-+]\d+)?)" + (f" ([kMG]?){re.escape(unit)}" if unit else "()"), cell)
    if not found:
        return False
    value /= PREFIXES.get(found[2], 1.0)
    if decimals is None:
        decimals = 3 - math.floor(math.log10(abs(value))) if abs(value) > 1e-12 else 12
    half = 0.5 * 10.0**-decimals
    return abs(float(found[1]) - value) <= half * (1 + 1e-6) + 1e-9 * abs(value) and not re.match(
        r"-0(\.0*)?$", found[1]
    )


KEY_RESULTS = [
    "comes to rest",
    "run-out along the arc",
    "peak velocity",
    "duration",
    "factor of safety",
    "estimated error",
]


def table(text: str) -> dict[str, str]:
    """The cells of a printed table by their labels, wrapped ones joined."""
    found: dict[str, str] = {}
    for line in text.splitlines()[2:]:
        label, _, cell = line.partition("  ")
        if label:
            found[label] = cell.strip()
        elif cell:
            last = next(reversed(found))
            found[last] += f" {cell.strip()}"
    return found


@EACH
def test_table(name: str, files: dict[str, Path], said: Any) -> None:
    """Every row, each shown value beside its own."""
    few, cells = (table(said("run", files[name], *more)) for more in ((), ("--verbose",)))
    assert few.items() < cells.items()
    assert list(few) == KEY_RESULTS
    e = exact(name)
    degrees, (limit, safety, yields, stress) = math.degrees, e.start()
    rotation, omega = e.state(e.duration)
    wanted: dict[str, tuple[float, str]] = {
        "factor of safety": (safety, ""), "yield coefficient k_y": (yields, ""),
        "limit friction angle": (degrees(math.atan(limit)), "deg"),
        "mean normal stress at the start": (stress, "Pa"), "run-out along the arc": (e.run_out, "m"),
        "rotation at the end": (degrees(rotation), "deg"), "velocity at the end": (e.radius * omega, "m/s"),
        "mean normal stress at the end": (e.forces(e.duration, rotation, omega)[1], "Pa"),
    }  # fmt: skip
    coefficients = dict(zip(("Theta*", "J_theta", "J_r", "lambda", "A"), e.coefficients(), strict=True))
    for label, (value, unit_of) in wanted.items():
        assert near(cells[label], value, unit_of), f"{label}: {cells[label]}, {value}"
    for label, value in coefficients.items():
        assert near(cells[label], value, "", 5), f"{label}: {cells[label]}, {value}"
        assert label not in few
    assert not e.motion.steps or near(cells["duration"].rpartition(" at ")[2], e.duration, "s")
    assert near(cells["peak velocity"].lstrip("-"), e.peak, "m/s")
    assert near(cells["friction angle"].partition(",")[0], degrees(math.atan(e.friction(0.0, 0.0))), "deg")
    assert cells["moves"] == ("yes" if e.motion.steps else "no")
    if e.motion.steps:
        assert cells["comes to rest"].partition(",")[0] == ("yes" if e.motion.arrested else "no")
        assert ("still moving at" in cells["duration"]) == (not e.motion.arrested)
    else:
        assert (cells["comes to rest"], cells["duration"]) == ("does not move", "-")
    assert set(cells["effects"].split(", ")) == set(e.effects)
    assert re.fullmatch(r"[\d.]+e-\d\d" if e.motion.steps else r"[\d.]+e[-+]\d\d", cells["estimated error"])
    assert name == "stays" or 2e-16 < float(cells["estimated error"]) < 1e-9


@pytest.mark.usefixtures("unseen")
def test_the_report_says_the_same(files: dict[str, Path], tmp_path: Path, said: Any) -> None:
    """Its JSON is that of `run --json`, also where numbers are infinite."""
    said("run", files["starts-lifted"], "--report", tmp_path / "r.html")
    text, e = (tmp_path / "r.html").read_text("utf-8"), exact("starts-lifted")
    assert "Infinity" not in text
    assert "NaN" not in text
    cells = dict(re.findall(r'<tr><td>([^<]*)</td><td><data value="([^"]*)">', text))
    for label, value in (("run-out along the arc", e.run_out), ("duration", e.duration), ("peak velocity", e.peak),
                         ("factor of safety", 0.0)):  # fmt: skip
        assert float(cells[label]) == pytest.approx(value, rel=1e-9), label


def test_backanalysis_finds_what_was_there(files: dict[str, Path], said: Any, records: Any) -> None:
    """Mirrored, and with a standard error, which `test_backanalysis` holds."""
    e = exact("slides")
    argv = ("backanalyse", files["slides"], f"--run-out-m={e.run_out!r}+-0.25", "--field friction=0.12:0.2")
    (found,) = records(*argv)[0]["solutions"]
    assert found["values"]["friction"] == pytest.approx(0.14, rel=1e-9)
    assert found["motion"]["duration"] == pytest.approx(e.duration, rel=1e-9)
    cells = columns(said(*argv))
    error = found["standard_errors"]["friction"]
    one, other = map(float, re.findall(r"[\d.]+", cells["friction"][0]))
    assert one == pytest.approx(0.14, abs=error / 10)
    assert other == pytest.approx(error, rel=0.06)
    assert cells["run-out (m)"] == [f"{e.run_out:.4g} (observed {e.run_out:.6g} +- 0.25)"]
    assert cells["peak velocity (m/s)"] == [f"{math.copysign(e.peak, e.run_out):.4g}"]
    assert (cells["duration (s)"], cells["swings"]) == ([f"{e.duration:.4g}"], ["0"])
