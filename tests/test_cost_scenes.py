"""The price list of scenes: its answers, one of them against the paper's closed form; ours beside peers."""

import io
import json
from typing import Any

import exact_scenes
import mpmath
import numpy as np
import oracle
import pytest
from mpmath import mpf
from test_cost import QUICK

from slipcircle.cost import cost, scenes, sections

ANSWERS = json.loads(scenes.ANSWERS.read_text("utf-8"))


@pytest.fixture(autouse=True)
def _quick(monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in QUICK.items():
        monkeypatch.setattr(cost, name, value)


# --- scenes --------------------------------------------------------------------------------------------------------


def test_the_answers_are_made_again() -> None:
    """The first of each case, to its last digit; frictions are those of the ensemble's lanes."""
    first = {name: dict([next(iter(of.items()))]) for name, of in ANSWERS.items()}
    assert json.dumps(first, indent=1) + "\n" == exact_scenes.written(first)
    assert sections.ANSWERS.read_text("utf-8") == exact_scenes.measures()
    for one, *lanes in (map(float, of) for of in ANSWERS.values()):
        assert one == pytest.approx(float(scenes.frictions(1)[0]), rel=1e-15)
        assert lanes == pytest.approx(scenes.frictions(len(scenes.ANGLES)).tolist(), rel=1e-15)


def test_the_reference_of_the_closed_form_is_the_papers() -> None:
    """(4.3), (4.5) corrected, at 40 digits."""
    mu, known = next(iter(ANSWERS["closed form"].items()))
    scene: Any = scenes.CASES["closed form"].scene(float(mu))
    m = oracle.numbers(scene.arc)
    with mpmath.workdps(40):
        a = m["fall"] * mpmath.sin(m["dip"]) - mpf(float(mu)) * m["press"] * mpmath.cos(m["dip"])
        b, t = mpf(float(mu)) * m["polar"], scene.end_time / m["scale"]
        root = mpmath.sqrt(a * b)
        exact = (m["radius"] * mpmath.log(mpmath.cosh(root * t)) / b,
                 m["radius"] * mpmath.sqrt(a / b) * mpmath.tanh(root * t) / m["scale"], scene.end_time)  # fmt: skip
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
