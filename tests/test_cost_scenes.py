"""The price list of scenes: its answers against Taylor series and the paper's closed form; ours beside peers."""

import io
import json
from typing import Any

import exact_scenes
import flint
import mpmath
import numpy as np
import pytest
import taylor
from mpmath import mpf
from test_cost import QUICK, digits

from slipcircle.cost import cost, scenes, sections

ANSWERS = json.loads(scenes.ANSWERS.read_text("utf-8"))


@pytest.fixture(autouse=True)
def _quick(monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in QUICK.items():
        monkeypatch.setattr(cost, name, value)


# --- scenes --------------------------------------------------------------------------------------------------------


def test_the_answers_are_made_again() -> None:
    """To their last digit; frictions are those of the ensemble's lanes."""
    assert scenes.ANSWERS.read_text("utf-8") == exact_scenes.written()
    assert sections.ANSWERS.read_text("utf-8") == exact_scenes.measures()
    for one, *lanes in (map(float, of) for of in ANSWERS.values()):
        assert one == pytest.approx(float(scenes.frictions(1)[0]), rel=1e-15)
        assert lanes == pytest.approx(scenes.frictions(len(scenes.ANGLES)).tolist(), rel=1e-15)


@pytest.mark.parametrize("name", [n for n in scenes.CASES if n != "closed form"])
def test_the_references_of_scenes_are_the_motion(name: str) -> None:
    """By extrapolation, against Taylor series of the equation of motion from quadratures of the definitions."""
    case, mu = scenes.CASES[name], float(next(iter(ANSWERS[name])))
    arc = {n: float(getattr(case.scene(mu).arc, n)) for n in ("radius", "theta_1", "theta_2", "unit_weight", "gravity")}
    law: Any = mu
    if case.softens:
        law = {"law": "exponential", "peak": mu, "residual": scenes.RESIDUAL, "length": scenes.LENGTH}
    if case.weakens:
        law = {"law": "rate_weakening", "peak": mu, "residual": scenes.RESIDUAL, "velocity": scenes.SPEED}
    effects: dict[str, Any] = {"rotation": {}, "centripetal": {}}
    if case.heats:
        effects["thermal_pressurisation"] = scenes.LAYER
    if case.shears:
        effects["viscosity"] = scenes.SHEARED
    made = ANSWERS[name][repr(mu)]
    if case.shakes:
        with pytest.MonkeyPatch.context() as patch:  # few samples: series through all of them take minutes
            patch.setattr(scenes, "SAMPLES", 40)
            scenes.record.cache_clear()
            time, k_h = scenes.record()
            made = exact_scenes.texts(case, mu)
        scenes.record.cache_clear()
        effects["shaking"] = {"time": time.tolist(), "horizontal": k_h.tolist()}
    scene = {"arc": arc, "friction": law, "effects": effects, "initial_velocity": 0.0, "end_time": None}
    with flint.ctx.workprec(200):
        found = taylor.solve(scene, digits=24)
        for name, kept in zip(("run_out", "peak_velocity", "duration"), made, strict=True):
            assert abs(float(flint.arb(found[name]) / flint.arb(kept) - 1)) < 1e-20


def test_the_reference_of_the_closed_form_is_the_papers() -> None:
    """(4.3), (4.5) corrected, at 40 digits."""
    mu, known = next(iter(ANSWERS["closed form"].items()))
    with flint.ctx.workprec(200), mpmath.workdps(40):
        of = exact_scenes.Exactly(scenes.CASES["closed form"])
        a, b, t = (
            digits(x) for x in (of.rate(flint.arb(float(mu)), of.start())[1], of.polar * flint.arb(float(mu)), of.end)
        )
        root, radius, scale = mpmath.sqrt(a * b), digits(of.radius), digits(of.scale)
        exact = (radius * mpmath.log(mpmath.cosh(root * t)) / b,
                 radius * mpmath.sqrt(a / b) * mpmath.tanh(root * t) / scale, t * scale)  # fmt: skip
        for value, text in zip(exact, known, strict=True):
            assert abs(value / mpf(text) - 1) < 1e-22


@pytest.mark.parametrize("name", ["closed form", "constant friction", "heat"])
@pytest.mark.parametrize("many", [False, True])
def test_rows_of_scenes(name: str, many: bool) -> None:
    """Ours keep to the accuracy, by either walk; a peer's error falls with its tolerance."""
    rows = {r.way: r for r in cost.measured(scenes.subject(name, many))}
    for way, row in rows.items():
        asked = float(way.rpartition(" ")[2])
        assert row.points == (3 if many else 1)
        assert 0 < row.price < np.inf
        if row.ours:
            assert row.error < max(asked, 2e-14), way
    for peer in ("DOP853, rtol", "heyoka, tol"):
        errors = [r.error for way, r in rows.items() if way.startswith(peer)]
        assert not errors or errors[-1] < min(1e-9, errors[0])


def test_what_is_not_installed_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cost, "find_spec", lambda name: None)
    said = io.StringIO()
    assert all(r.ours for r in cost.measured(scenes.subject("constant friction", False), said))
    assert said.getvalue() == "".join(
        f"constant friction: {name} is missing, and left out\n" for name in ("scipy", "heyoka")
    )


def test_rows_of_sections() -> None:
    """Ours to their last digits, quadrature better with more points, polygons with more chords; blocks bound memory."""
    rows = {r.way: r for r in cost.measure(["sections"])}
    assert all(r.error < 2e-14 for r in rows.values() if r.ours)
    for peer, least in (("Gauss", 1e-6), ("shapely", 1e-4)):
        errors = [r.error for way, r in rows.items() if way.startswith(peer)]
        assert not errors or (errors == sorted(errors, reverse=True) and errors[-1] < least)
    subject = sections.subject()
    small, large = (cost._peak(cost._work(subject.ways[0], subject.bulk(n), n)) for n in (20_000, 60_000))
    assert large - small < 1.5 * 40_000 * 8 * (7 + 3)  # arguments and results
