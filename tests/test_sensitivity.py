"""Exact sensitivities: proofs, generated slopes in many digits, and whole motions against 40-digit differences."""

import json
import math
import re
from dataclasses import replace
from fractions import Fraction
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

import mpmath
import numpy as np
import oracle
import pytest
import references
from flint import ctx
from mpmath import mpf

import slipcircle
from derive.algebra import integrate
from derive.algebra import sensitivity as derived
from generated import sensitivity as slopes
from slipcircle import Arc, Motion, Scene, solve
from slipcircle.__main__ import main

ULP = 2.0**-52

# --- what is generated ---------------------------------------------------------------------------------------------


def test_every_slope_is_proved() -> None:
    assert len(derived.prove_energy_slopes()) == 10
    assert len(derived.prove_frozen_slopes()) == 13
    assert len(derived.prove_energy_growth()) == 3
    closed = integrate.closed_forms()
    assert len(derived.prove_arc_growth(closed)) == len(closed)


def energy(*at: Any) -> Any:
    """E at x, textbook form."""
    x, start, drive, tilt, constant, brake = at
    q = 2 * brake
    fade = mpmath.exp(-q * x)
    with_cos = (q * mpmath.cos(x) + mpmath.sin(x) - q * fade) / (1 + q * q)
    with_sin = (q * mpmath.sin(x) - mpmath.cos(x) + fade) / (1 + q * q)
    return start * fade + 2 * (drive * with_cos - tilt * with_sin - constant * ((1 - fade) / q - with_cos))


def velocity(*at: Any) -> tuple[Any, Any]:
    """Rotation and angular velocity of the frozen slide, textbook form."""
    a, b, omega_0, t = at
    k = mpmath.sqrt(mpmath.mpc(a * b))
    y = mpmath.re(mpmath.cosh(k * t) + b * omega_0 * mpmath.sinh(k * t) / k)
    return mpmath.log(y) / b, mpmath.re(omega_0 * mpmath.cosh(k * t) + a * mpmath.sinh(k * t) / k) / y


def central(function: Any, x: float) -> Any:
    """A derivative to some 50 digits."""
    step = mpf(10) ** -30 * (abs(mpf(x)) or 1)
    return (function(mpf(x) + step) - function(mpf(x) - step)) / (2 * step)


def check_energy(module: ModuleType) -> None:
    """Each derivative of E relatively, from the shortest motions to half a turn, and for any brake."""
    rng = np.random.default_rng(5)
    with mpmath.workdps(130):
        for _ in range(250):
            x, brake = 10 ** rng.uniform(-9.0, 0.49), 10 ** rng.uniform(-8.0, 5.0)
            if rng.random() < 0.2:  # backwards from a standstill
                brake = -min(brake, 0.5 / x)
            for k in range(1, 4):
                only = [0.0] * 4
                only[k] = 1.0
                found = module.energy_slopes(x, *only, brake)
                exact = energy(mpf(x), *only, mpf(brake))
                assert abs(found[k] - exact) <= 128 * ULP * abs(exact), (k, x, brake)
                exact = central(lambda b, x=x, only=only: energy(mpf(x), *only, b), brake)
                assert abs(found[4] - exact) <= 512 * ULP * abs(exact), (k, x, brake)


def check_frozen(module: ModuleType) -> None:
    """Derivatives of rotation and angular velocity by a, b and omega_0, up to the standstill."""
    rng = np.random.default_rng(6)
    with mpmath.workdps(110):
        for _ in range(300):
            a, b, omega_0 = 10 ** rng.uniform(-6.0, 3.0), 10 ** rng.uniform(-6.0, 3.0), 10 ** rng.uniform(-4.0, 2.0)
            t = 10 ** rng.uniform(-5.0, 3.0)
            if rng.random() < 0.4:
                t = min(t, math.atan(omega_0 * math.sqrt(b / a)) / math.sqrt(a * b))
                a = -a
            at = tuple(map(mpf, (a, b, omega_0, t)))
            found = module.frozen_slopes(a, b, omega_0, t)
            for k in range(3):
                for way in range(2):
                    if not (k == 2 and way == 1 and math.sqrt(abs(a * b)) * t > 60.0):  # exp(-2kt)
                        exact = central(lambda v, k=k, at=at, way=way: velocity(*at[:k], v, *at[k + 1 :])[way], at[k])
                        assert abs(found[3 * way + k] - exact) <= 128 * ULP * abs(exact), (k, way, at)


def test_energy_slopes() -> None:
    check_energy(slopes)


def test_frozen_slopes() -> None:
    check_frozen(slopes)


def test_arc_growth() -> None:
    def quotients(alpha: Any) -> list[Any]:
        sine, cosine = mpmath.sin(alpha), mpmath.cos(alpha)
        radial = sine - cosine**2 * mpmath.atanh(sine)
        turn = 2 * alpha - mpmath.sin(2 * alpha)
        inertia = turn / 4 + sine**3 * cosine / 3
        forms = [2 * sine**3 / 3, radial, turn / 3 + cosine * radial / 3, 2 * alpha * (1 - cosine)]
        return [*(mpmath.log(f / inertia) for f in forms), mpmath.log(inertia)]

    rng = np.random.default_rng(7)
    with mpmath.workdps(150):
        for _ in range(120):
            alpha = (
                10 ** rng.uniform(-8.0, 0.19) if rng.random() < 0.6 else math.pi / 2 - 10 ** rng.uniform(-12.0, -1.0)
            )
            found = slopes.arc_growth(alpha)
            for k in range(5):
                exact = central(lambda v, k=k: quotients(v)[k], alpha) * (alpha if k == 4 else 1)
                # C_r/Theta* is greatest at 1.34, where its slope is zero.
                assert abs(found[k] - exact) <= 64 * ULP * max(abs(exact), 0.01 * min(alpha, 1.0)), (k, alpha)
    assert np.all(np.isfinite([slopes.arc_growth(x) for x in (0.0, 1e-200, math.pi / 2, math.pi / 2 * (1 + ULP))]))


@pytest.mark.parametrize(
    ("pattern", "replacement", "check"),
    [
        (r"\(0\.3333333333333333,", "(0.3333333333333,", check_frozen),  # (cosh k - sinh(k)/k)/k**2 at 0
        (r"-0\.75,", "-0.7500000001,", check_frozen),  # the slope of log(1 + x)/x
        (r"-0\.016666666666666666,", "-0.0166666667,", check_energy),  # a remainder of exp(-x)
        (r"(t\d+) < 1\.0$", r"\1 < 0.0", check_energy),  # a seam out of place
    ],
)
def test_a_planted_bug_turns_a_check_red(pattern: str, replacement: str, check: Any) -> None:
    source = Path(str(slopes.__file__)).read_text("utf-8")
    start = source.index(f"def {check.__name__.removeprefix('check_')}_slopes(")
    end = (source + "\n\n\ndef ").index("\n\n\ndef ", start)
    text, count = re.subn(pattern, replacement, source[start:end], flags=re.M)
    assert count
    bugged = ModuleType("bugged")
    exec(source[:start] + text + source[end:], bugged.__dict__)
    with pytest.raises(AssertionError):
        check(bugged)


# --- whole motions -------------------------------------------------------------------------------------------------


class Free(references.Problem):
    """Followed to its first standstill, as if without friction."""

    @property
    def frictionless(self) -> bool:
        return True


def outputs(scene: dict[str, Any], free: bool) -> list[Any]:
    """Peak velocity, run-out and duration to some 40 digits."""
    p = references.problem(scene)
    if free:
        p = Free(**{n: getattr(p, n) for n in references.Problem.__dataclass_fields__})
    found = references.motion(p, references.PLAIN["order"], references.PLAIN["digits"])
    second = (p.radius / p.gravity).sqrt()
    speed = found.peak()[1] * p.radius / second
    return [speed, found.state(found.duration)[0] * p.radius, found.duration * second]


def shifted(scene: dict[str, Any], name: str, by: Fraction) -> dict[str, Any]:
    """The scene with one number changed, exactly."""
    changed = json.loads(json.dumps(scene))
    path = name.split(".") if "." in name else [name]
    box = changed["effects"][path[0]] if len(path) == 2 else changed if name in changed else changed["arc"]
    box[path[-1]] = Fraction(box[path[-1]]) + by
    return dict(changed)


def differences(scene: dict[str, Any], motion: Motion, name: str, value: float) -> list[float]:
    step = Fraction(value or 1.0) * Fraction(1, 10**13)
    free = not motion.arrested and scene["end_time"] is None
    with ctx.workprec(references.PLAIN["bits"]):
        up, down = (outputs(shifted(scene, name, by), free) for by in (step, -step))
        return [float((u - d) / (2 * oracle.exact(step))) for u, d in zip(up, down, strict=True)]


def build(scene: dict[str, Any]) -> Scene:
    rest = {n: scene[n] for n in ("friction", "effects", "initial_velocity", "end_time")}
    return Scene(arc=Arc(**scene["arc"]), **rest)


def check_motion(scene: dict[str, Any]) -> None:
    """All derivatives, relative to themselves, or to a tenth of the output per relative change."""
    motion = solve(build(scene))
    found = motion.sensitivity()
    assert np.all(np.isfinite(found.values))
    bound = 1e-12 + 128 * motion.error_estimate
    for name in found.parameters:
        value = found.at[name]
        for output, exact in zip(found.outputs, differences(scene, motion, name, value), strict=True):
            size = max(abs(exact), 0.1 * abs(found.at[output] / value) if value else 0.0)
            error = abs(found.derivative(output, name) - exact)
            assert error <= bound * size, (output, name, found.derivative(output, name), exact, error / size, bound)


ROWS = [r["scene"] for r in json.loads(references.FILE.read_text("utf-8")) if r["group"] in ("frozen", "constant")]


@pytest.mark.parametrize("start", range(8))
def test_random_scenes_against_differences(start: int) -> None:
    """Frozen and turning, all effects, swings, lift-off, next to the limit."""
    for scene in ROWS[start::32]:
        check_motion(scene)


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


@pytest.mark.parametrize(
    "scene",
    [
        *(hard(opening) for opening in (1e-6, 1e-3, math.pi - 1e-9)),
        *(hard(share=1.0 - e) for e in (1e-3, 1e-6, 1e-9)),
        hard(share=0.0),
        hard(share=0.06),  # many swings
        hard(drag={"xi": 1e9}),
        hard(drag={"xi": 0.1}),
        hard(share=1.0 - 1e-6, drag={"xi": 10.0}),
        hard(share=0.9, cohesion={"cohesion": 100.0}, pore_pressure={"ratio": 0.05, "pressure": 50.0}),
    ],
    ids=["thin", "thinner", "half disc", "limit-3", "limit-6", "limit-9", "no friction", "many swings", "weak brake",
         "strong brake", "strong brake at the limit", "water"],
)  # fmt: skip
def test_hard_scenes_against_differences(scene: dict[str, Any]) -> None:
    check_motion(scene)


def test_dimensions() -> None:
    """Without a pressure the motion scales: run-out by R, speed by sqrt(g R), duration by sqrt(R/g)."""
    found = solve(Scene.load("vaiont")).sensitivity()
    wanted = {"radius": (0.5, 1.0, 0.5), "gravity": (0.5, 0.0, -0.5), "unit_weight": (0.0, 0.0, 0.0)}
    for name, elasticities in wanted.items():
        column = found.elasticities[:, list(found.parameters).index(name)]
        np.testing.assert_allclose(column, elasticities, atol=1e-13)


def test_table_and_what_is_left_out() -> None:
    scene = Scene.load("vaiont-as-printed")
    found = solve(scene).sensitivity()
    assert list(found.parameters) == ["friction", "radius", "unit_weight", "gravity"]  # its coefficients are given
    assert "friction" in str(found)
    assert "run_out [m]" in str(found)
    still = solve(replace(Scene.load("vaiont"), friction=0.6)).sensitivity()
    assert not still.values.any()
    assert np.isnan(still.elasticities).all()


def test_where_there_is_no_derivative() -> None:
    with pytest.raises(ValueError, match="constant coefficient"):
        solve(Scene.load("vaiont-softening")).sensitivity()
    scene = Scene.load("vaiont")
    at_limit = replace(scene, friction=float(scene.arc.dimensionless.limit_friction))
    with pytest.raises(ValueError, match="exactly at its limit"):
        solve(at_limit).sensitivity()


# --- the command ---------------------------------------------------------------------------------------------------

KEYS = {"friction.angle_deg": 24.0, "arc.theta_2_deg": 280.0, "arc.radius_m": 40.0, "arc.unit_weight_kN_m3": 20.0,
        "pore_pressure.ratio": 0.35, "cohesion.cohesion_kPa": 3.0}  # fmt: skip


def test_the_command_is_per_unit_of_the_keys(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Per degree and per kPa: against differences of motions whose files differ in that key."""
    text = (Path(str(slipcircle.__file__)).parent / "scenes" / "wet-slope.toml").read_text("utf-8")
    assert main(["sensitivity", "wet-slope"]) == 0
    cells = {line.split()[0]: line.split() for line in capsys.readouterr().out.splitlines() if "." in line}
    for path, value in KEYS.items():
        key, step = path.rpartition(".")[2], 1e-4 * value
        ends = []
        for x in (value - step, value + step):
            (tmp_path / "s.toml").write_text(re.sub(rf"^{key} = [0-9.]+", f"{key} = {x!r}", text, flags=re.M), "utf-8")
            motion = solve(Scene.load(str(tmp_path / "s.toml")))
            ends.append((float(motion.peak.velocity), motion.run_out, motion.duration))
        found = cells[path]
        assert float(found[1]) == value
        for k in range(3):
            slope = (ends[1][k] - ends[0][k]) / (2 * step)
            assert float(found[2 + 2 * k]) == pytest.approx(slope, rel=1e-3)
            elasticity = slope * value / ((ends[0][k] + ends[1][k]) / 2)
            assert float(found[3 + 2 * k].strip("()")) == pytest.approx(elasticity, rel=0.06)


def test_the_command_for_machines(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["sensitivity", "vaiont", "--json"]) == 0
    record = json.loads(capsys.readouterr().out)
    found = solve(Scene.load("vaiont")).sensitivity()
    by = {p["name"]: p for p in record["parameters"]}
    assert by["theta_1"]["unit"] == "rad"
    assert by["theta_1"]["derivatives"]["run_out"] == found.derivative("run_out", "theta_1")
    assert by["radius"]["elasticities"]["run_out"] == pytest.approx(1.0, abs=1e-12)
    assert main(["sensitivity", "vaiont-rate"]) == 1
    assert "need a closed form" in capsys.readouterr().err
