"""Positive is down-slope, whatever the facing: arcs, sections and their mirror images do the same in every field."""

import json
import math
from typing import Any

import numpy as np
import pytest

from slipcircle import Arc, Record, Scene, Section, ensemble, solve
from slipcircle.tables import Pulse, Series
from slipcircle.workbench.common.quantities import HISTORY, RESULTS

RIGHT = Arc(60.0, math.radians(220.0), math.radians(290.0), 19e3)
LEFT = Arc(60.0, math.radians(250.0), math.radians(320.0), 19e3)
GROUND = np.array([[0.0, 35.0], [40.0, 35.0], [52.0, 30.0], [60.0, 25.0], [90.0, 25.0]])
LEVEL = np.array([[0.0, 32.0], [45.0, 32.0], [60.0, 25.0], [90.0, 25.0]])
FALLING = Section(GROUND, [57.0, 56.0], 28.0, 20e3, level=LEVEL)
RISING = Section(GROUND[::-1] * [-1, 1], [-57.0, 56.0], 28.0, 20e3, level=LEVEL[::-1] * [-1, 1])
RECORD = Series(np.arange(0.0, 3.1, 0.25), np.array([0, 3, -2, 4, -3, 1, 5, -4, 2, 0, 1, -1, 0]) / 10.0, held=False)
ASKED: dict[str, tuple[Any, Any, float]] = {
    "pushed down": ({"rotation": {}, "centripetal": {}}, 0.35, 2.0),
    "pushed up": ({"rotation": {}, "cohesion": {"cohesion": 4e3}}, 0.2, -2.0),
    "swings": ({"rotation": {}}, 0.02, 0.0),
    "pulse": ({"rotation": {}, "shaking": {"horizontal": Pulse("sine", 0.3, 0.0, 2.0)}}, 0.4, 0.0),
    "record": ({"rotation": {}, "shaking": {"horizontal": RECORD, "two_way": True}}, 0.4, 0.0),
    "softens": ({"rotation": {}}, {"law": "exponential", "peak": 0.22, "residual": 0.15, "length": 1.0}, 0.0),
}


@pytest.mark.parametrize(("one", "other"), [(RIGHT, LEFT), (FALLING, RISING)], ids=["arc", "section"])
@pytest.mark.parametrize("asked", ASKED)
def test_a_mirror_changes_no_number(one: Any, other: Any, asked: str) -> None:
    effects, friction, velocity = ASKED[asked]
    a, b = (solve(Scene(arc, friction, effects, velocity)) for arc in (one, other))
    assert (a.plan.scene.arc.facing, b.plan.scene.arc.facing) == (1, -1)
    assert a.farthest.displacement > 0.0 or asked == "pushed up"
    times = np.linspace(0.0, a.duration * 0.999, 23)
    for q in RESULTS:
        assert q.read(b) == pytest.approx(q.read(a), rel=1e-9, abs=1e-9), q.name
    for name, q in HISTORY.items():
        first, second = q.at(a, times), q.at(b, times)
        np.testing.assert_allclose(second, first, rtol=0, atol=1e-8 * max(1e-9, np.nanmax(np.abs(first))), err_msg=name)
    if one is FALLING:
        assert b.journey.run_out == pytest.approx(a.journey.run_out, rel=1e-11)
        assert b.journey.toe_x == pytest.approx(-a.journey.toe_x, rel=1e-11)
    assert json.dumps([w.split()[:4] for w in a.warnings]) == json.dumps([w.split()[:4] for w in b.warnings])


@pytest.mark.parametrize("arc", [RIGHT, LEFT], ids=["right", "left"])
def test_a_positive_record_drives_down_slope_whatever_the_facing(arc: Any) -> None:
    push = np.array([0.0, 0.5, 0.5, 0.0])
    driving, ground = (Record(push, dt=0.5, holds=holds) for holds in ("driving", "ground"))
    pushed, held = (solve(Scene(arc, 0.6, {"rotation": {}, "shaking": {"horizontal": r}})) for r in (driving, ground))
    assert pushed.run_out > 0.0
    assert held.run_out == 0.0


def test_studies_of_a_mirrored_arc() -> None:
    drawn = {"friction": {"distribution": "uniform", "low": 0.1, "high": 0.3}}
    many = [ensemble(Scene(arc, 0.2, ["rotation"], uncertain=drawn), 64, 3) for arc in (RIGHT, LEFT)]
    assert many[1].mean("run_out").value == pytest.approx(many[0].mean("run_out").value, rel=1e-9)
