"""How to add a law, an effect and a moment, as `derive` says it: followed to the letter in a copy, and used there."""

import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from scipy.integrate import dblquad, solve_ivp

ROOT = Path(__file__).resolve().parent.parent
# ``At the end of ``LAWS`` in ``derive/declare/effects.py``::``, and what stands indented below.
STEP = re.compile(r"[Aa]t the end of\s+``(\w+)`` in\s+``(\S+)``::\n\n((?: {4}.*\n)+)")
SLOPE = {"radius_m": 100.0, "theta_1_deg": 205.0, "theta_2_deg": 285.0, "unit_weight_kN_m3": 19.0}
SOFTENING = {"peak": 0.35, "residual": 0.2, "length": 1.5}
SUCTION = 12e3


def follow(root: Path) -> list[str]:
    """Do what the docstring of `derive` says to a copy of the repository; the names that were added to."""
    steps = STEP.findall((root / "derive" / "__init__.py").read_text("utf-8"))
    for name, file, code in steps:
        lines = (root / file).read_text("utf-8").splitlines(keepends=True)
        start = next(k for k, line in enumerate(lines) if re.match(rf"(def )?{name}\b", line))
        end = next(k for k in range(start + 1, len(lines)) if re.match(r" *[)}]( |$)", lines[k]))
        (root / file).write_text("".join([*lines[:end], code, *lines[end:]]), "utf-8")
    return [name for name, _, _ in steps]


def run(root: Path, *command: str) -> str:
    """The output of Python in the copy, which sees no other."""
    done = subprocess.run(
        [sys.executable, *command], cwd=root, env=os.environ | {"PYTHONPATH": str(root)}, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def extended(tmp_path_factory: pytest.TempPathFactory) -> Path:
    root = tmp_path_factory.mktemp("extended")
    for package in ("derive", "generated", "slipcircle"):
        shutil.copytree(ROOT / package, root / package, ignore=shutil.ignore_patterns("__pycache__"))
    assert follow(root) == ["LAWS", "EFFECTS", "MOMENTS"]
    run(root, "-m", "derive")
    return root


def raw(weight: Callable[[float, float], float], alpha: float) -> float:
    """A double integral of the definitions over the mass, u from the bisector."""
    return float(dblquad(weight, -alpha, alpha, lambda u: np.cos(alpha) / np.cos(u), lambda u: 1.0, epsrel=1e-12)[0])


def reference(mu: Callable[[float], float], centripetal: bool) -> tuple[float, float]:
    """Peak velocity and run-out by the equation of motion (3.11) with suction, from raw integrals, turning."""
    first, second = np.deg2rad(SLOPE["theta_1_deg"]), np.deg2rad(SLOPE["theta_2_deg"])
    alpha, dip, radius = (second - first) / 2, 1.5 * np.pi - (first + second) / 2, SLOPE["radius_m"]
    inertia, polar = raw(lambda r, u: r**3, alpha), raw(lambda r, u: r**2, alpha)
    radial, weight = raw(lambda r, u: r * np.cos(u), alpha), raw(lambda r, u: r**2 * np.cos(u), alpha)
    stress = SUCTION / (SLOPE["unit_weight_kN_m3"] * 1e3 * radius * (1 - np.cos(alpha)))  # over (2.13)
    level = 2 * alpha * (1 - np.cos(alpha))

    def rate(t: float, y: Any) -> list[float]:
        presses = radial * np.cos(dip - y[0]) + level * stress + centripetal * polar * y[1] ** 2
        return [y[1], (weight * np.sin(dip - y[0]) - mu(radius * y[0]) * presses) / inertia]

    def stands(t: float, y: Any) -> float:
        return float(y[1])

    def fastest(t: float, y: Any) -> float:
        return rate(t, y)[1]

    stands.terminal, stands.direction = True, -1  # type: ignore[attr-defined]
    found = solve_ivp(rate, (0, 100), [0.0, 0.0], "DOP853", events=[stands, fastest], rtol=1e-12, atol=1e-13)
    peak = max(y[1] for y in found.y_events[1]) * np.sqrt(9.81 * radius)
    return peak, found.y_events[0][-1][0] * radius


def inverse_square(slip: float) -> float:
    return SOFTENING["residual"] + (SOFTENING["peak"] - SOFTENING["residual"]) / (1 + slip / SOFTENING["length"]) ** 2


def exponential(slip: float) -> float:
    return SOFTENING["residual"] + (SOFTENING["peak"] - SOFTENING["residual"]) * np.exp(-slip / SOFTENING["length"])


@pytest.mark.parametrize(
    ("law", "mu", "centripetal"),
    [("inverse_square", inverse_square, True), ("exponential", exponential, False)],
)
def test_a_scene_uses_the_new_law_and_the_new_effect(
    extended: Path, law: str, mu: Callable[[float], float], centripetal: bool
) -> None:
    lines = ["[arc]", *(f"{k} = {v}" for k, v in SLOPE.items()), "[friction]", f'law = "{law}"']
    lines += [*(f"{k}{'_m' * (k == 'length')} = {v}" for k, v in SOFTENING.items()), "[rotation]"]
    lines += ["[centripetal]"] * centripetal + ["[suction]", f"suction_kPa = {SUCTION / 1e3}"]
    (extended / "new.toml").write_text("\n".join(lines), "utf-8")
    (planned,) = json.loads(run(extended, "-m", "slipcircle", "plan", "new.toml", "--json"))
    assert planned["law"] == law
    assert {law, "suction"} <= set(planned["fragments"])
    assert planned["effects"][-1] == "suction"
    (motion,) = json.loads(run(extended, "-m", "slipcircle", "run", "new.toml", "--json"))
    found = motion["peak"]["velocity"], motion["run_out"]
    assert np.allclose(found, reference(mu, centripetal), rtol=1e-8)


def test_what_is_new_is_checked_and_described(extended: Path) -> None:
    schema = json.loads(run(extended, "-m", "slipcircle", "schema"))
    assert schema["$defs"]["suction"]["required"] == ["suction_kPa"]
    assert "friction_inverse_square" in schema["$defs"]
    guide = run(extended, "-m", "slipcircle", "schema", "--text")
    assert "adds -suction* to u" in guide
    assert "suction* = suction/sigma_ref" in guide
    assert 'law = "inverse_square"' in guide


def test_the_new_moment_is_a_function(extended: Path) -> None:
    """The area of a circle's segment, of thin masses and of the half disc, within 5 ulp; certified and priced."""
    alpha = [0.0, 1e-300, 1e-100, 1e-5, 0.1, 0.5385, 1.0, np.pi / 2]
    code = f"from generated import area; print(*(float(x).hex() for x in area({alpha})))"
    found = [float.fromhex(x) for x in run(extended, "-W", "error", "-c", code).split()]
    with mpmath.workdps(650):
        exact = [mpmath.mpf(a) - mpmath.sin(2 * mpmath.mpf(a)) / 2 for a in alpha]
        assert all(abs(x - e) <= 5 * float(np.spacing(x)) for x, e in zip(found, exact, strict=True))
    records = json.loads((extended / "generated" / "certificates" / "area.json").read_text("utf-8"))["certificates"]
    assert {(r["tier"], r["form"]) for r in records} == {
        (tier, form) for tier in ("best", "1e-10", "1e-6", "float32") for form in ("fused", "plain")
    }
    assert all(r["definition"] == ["r^1"] for r in records)
    assert max(r["bound"] for r in records if (r["tier"], r["form"]) == ("best", "fused")) <= 1
    code = "from slipcircle.cost import ways; from derive.judge.hard import CASES; "
    code += "print('area' in ways.FUNCTIONS, [c.why for c in CASES if c.function == 'area'] != [])"
    assert run(extended, "-c", code).split() == ["True", "True"]
