"""How to add a law, an effect and a moment, as `derive` says it: followed to the letter in a copy, and used there.

Three weights are declared there too (`python tests/all_weights.py`: all 15)."""

import json
import random
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import all_weights
import mpmath
import numpy as np
from all_weights import run
from scipy.integrate import dblquad, solve_ivp

Seen = dict[str, dict[str, tuple[float, float]]]
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


def extended(root: Path) -> Seen:
    """Make the copy: what is seen and proved of three weights that were declared there as well, drawn at random.

    The search judges fewer shapes than it may, as it takes its time.
    """
    all_weights.copy(root)
    assert follow(root) == ["LAWS", "EFFECTS", "MOMENTS"]
    drawn = random.SystemRandom().sample(all_weights.WEIGHTS[1:], 3)  # the first is the moment that was followed
    return all_weights.follow(root, drawn, "--trials", "14")


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


def check_scene(root: Path, law: str, mu: Callable[[float], float], centripetal: bool) -> None:
    """It uses the new law and the new effect."""
    lines = ["[arc]", *(f"{k} = {v}" for k, v in SLOPE.items()), "[friction]", f'law = "{law}"']
    lines += [*(f"{k}{'_m' * (k == 'length')} = {v}" for k, v in SOFTENING.items()), "[rotation]"]
    lines += ["[centripetal]"] * centripetal + ["[suction]", f"suction_kPa = {SUCTION / 1e3}"]
    (root / "new.toml").write_text("\n".join(lines), "utf-8")
    (planned,) = json.loads(run(root, "-m", "slipcircle", "plan", "new.toml", "--json"))
    assert planned["law"] == law
    assert {law, "suction"} <= set(planned["fragments"])
    assert planned["effects"][-1] == "suction"
    (motion,) = json.loads(run(root, "-m", "slipcircle", "run", "new.toml", "--json"))
    found = motion["peak"]["velocity"], motion["run_out"]
    assert np.allclose(found, reference(mu, centripetal), rtol=1e-8)


def check_schema(root: Path) -> None:
    """What is new is checked and described."""
    schema = json.loads(run(root, "-m", "slipcircle", "schema"))
    assert schema["$defs"]["suction"]["required"] == ["suction_kPa"]
    assert "friction_inverse_square" in schema["$defs"]
    guide = run(root, "-m", "slipcircle", "schema", "--text")
    assert "adds -suction* to u" in guide
    assert "suction* = suction/sigma_ref" in guide
    assert 'law = "inverse_square"' in guide


def check_weights(root: Path, found: Seen) -> None:
    """Closed form, certificates within the goals, and no error beside quadrature that is more than proved."""
    assert len(found) == 3
    assert not all_weights.faults(found), found
    for name in found:
        path = root / "generated" / "certificates" / f"{name}.json"
        bounds = {(r["tier"], r["form"]): r["bound"] for r in json.loads(path.read_text("utf-8"))["certificates"]}
        assert bounds["best", "fused"] <= 1, name


def test_a_changed_weight_changes_the_kernel(tmp_path: Path) -> None:
    """r**2 in the place of r**3: another closed form, another program, another certificate."""
    all_weights.copy(tmp_path)
    path = tmp_path / "derive" / "declare" / "quantities.py"
    path.write_text(path.read_text("utf-8").replace('"3.12", r**3', '"3.12", r**2'), "utf-8")
    code = (
        "from derive.approximate import programs, shapes; from derive.approximate.programs import variants; "
        "shapes.records().setdefault(('r^2', 'r^2'), shapes.records()['r^2 cos u', 'r^3']); "
        "shapes.records().setdefault(('r^2 cos u', 'r^2'), shapes.records()['r^2 cos u', 'r^3']); "
        "shapes.records().setdefault(('r^1 cos u', 'r^2'), shapes.records()['r^1 cos u', 'r^3']); "
        "found = {v.kernel: v for v in variants() if (v.tier, v.form) == ('best', 'fused')}; "
        "print(found['moment_of_inertia'].program.ops == found['polar_moment'].program.ops, "
        "*found['moment_of_inertia'].definition)"
    )
    assert run(tmp_path, "-c", code).split() == ["True", "r^2"]


def check_moment(root: Path) -> None:
    """The area of a circle's segment, of thin masses and of the half disc, within 5 ulp; certified and priced."""
    alpha = [0.0, 1e-300, 1e-100, 1e-5, 0.1, 0.5385, 1.0, np.pi / 2]
    code = f"from generated import area; print(*(float(x).hex() for x in area({alpha})))"
    found = [float.fromhex(x) for x in run(root, "-W", "error", "-c", code).split()]
    with mpmath.workdps(650):
        exact = [mpmath.mpf(a) - mpmath.sin(2 * mpmath.mpf(a)) / 2 for a in alpha]
        assert all(abs(x - e) <= 5 * float(np.spacing(x)) for x, e in zip(found, exact, strict=True))
    records = json.loads((root / "generated" / "certificates" / "area.json").read_text("utf-8"))["certificates"]
    assert {(r["tier"], r["form"]) for r in records} == {
        (tier, form) for tier in ("best", "1e-10", "1e-6", "float32") for form in ("fused", "plain")
    }
    assert all(r["definition"] == ["r^1"] for r in records)
    assert max(r["bound"] for r in records if (r["tier"], r["form"]) == ("best", "fused")) <= 1
    code = "from slipcircle.cost import ways; from derive.judge.hard import CASES; "
    code += "print('area' in ways.FUNCTIONS, [c.why for c in CASES if c.function == 'area'] != [])"
    assert run(root, "-c", code).split() == ["True", "True"]


def test_what_is_added_is_everywhere(tmp_path: Path) -> None:
    """In one test, as the copy takes its time."""
    found = extended(tmp_path)
    check_scene(tmp_path, "inverse_square", inverse_square, True)
    check_scene(tmp_path, "exponential", exponential, False)
    check_schema(tmp_path)
    check_moment(tmp_path)
    check_weights(tmp_path, found)
