"""The text of the integrator: faults in the functions that are written from it, and the grammar that it follows."""

import ast
from contextlib import suppress
from typing import Any

import numpy as np
import pytest

from derive.flow import restricted, restricted_c, restricted_numpy
from derive.flow.integrator import TEXT
from generated import integrator
from generated import layout as ix
from tests.support import lanes
from tests.support.problems import LANES, problem

RESULTS = (ix.TIME, ix.ROTATION, ix.SLIP, ix.PEAK_TIME, ix.PEAK_OMEGA, ix.REACH_ROTATION, ix.END_ROTATION)


def alike(one: Any, other: Any, within: float) -> bool:
    """Whether counts are the same, and results to rounding."""
    if any(one[row] != other[row] for row in lanes.COUNTED):
        return False
    return all(abs(float(one[row] - other[row])) <= within * max(abs(float(other[row])), 1e-3) for row in RESULTS)


# --- faults in the written text --------------------------------------------------------------------------------------

FAULTS = {
    "a mask is dropped": ("step", "reach_limit", "reaches and at < INFINITY", "reaches"),
    "branches are swapped": ("step", "make_step", "where(s.event == Event.LIMIT, limit, time)",
                             "where(s.event == Event.LIMIT, time, limit)"),
    "a bound is wrong": ("roots", "value_and_slope", "down(n - 1, 0)", "down(n - 1, 1)"),
    "a sign is wrong": ("phases", "advance_origin", "s.rotation + s.direction", "s.rotation - s.direction"),
    "a direction is kept": ("step", "on_standstill", "where(one_way, s.direction, -s.direction)", "1.0 * s.direction"),
    "others are decided, too": ("phases", "resolve_pending", "standstill(s, decides", "standstill(s, waits"),
    "a closed form ends too late": ("swing", "finish", "s.time + duration", "s.time + 2.0 * duration"),
    "an index is off by one": ("tables", "pass_break", "t.piece + 1.0", "t.piece + 0.0"),
}  # fmt: skip


def written(module: str, old: str, new: str) -> dict[str, Any]:
    """Return the functions in NumPy, written from the text with a fault in a module."""
    text = restricted.Text()
    for name in TEXT:
        source = (restricted.FOLDER / f"{name}.py").read_text("utf-8")
        if name == module:
            assert source.count(old) >= 1
            source = source.replace(old, new)
        text.read(source, f"{name}.py")
    scope = dict(vars(integrator))
    exec(restricted_numpy.numpy_functions(text), scope)
    return scope


def ends_as_written(monkeypatch: pytest.MonkeyPatch, module: str, old: str, new: str) -> bool:
    """Whether all scenes end as in the integrator, with NumPy's functions written from a changed text."""
    expected = {name: lanes.integrate(problem(name)) for name in ("constant", "pulse")}
    scope = written(module, old, new)
    for name in restricted.integrator().functions:
        monkeypatch.setattr(integrator, name, scope[name])
    monkeypatch.setattr(integrator, "ROUNDS", 200)
    for name, finals in expected.items():
        bound = problem(name)
        s = integrator.Lanes(bound.program, bound.tables(), bound.cells())
        with np.errstate(all="ignore"):
            integrator.load(s)
            for _ in range(200):
                integrator.advance(s, s.cells[ix.STATUS] <= ix.RESTING)
        if not all(alike(finals[:, k], s.cells[:, k], 1e-11) for k in range(LANES)):
            return False
    return True


def test_what_is_written_from_the_text_as_it_stands_is_the_integrator(monkeypatch: pytest.MonkeyPatch) -> None:
    assert ends_as_written(monkeypatch, "roots", "LAST_STEP = 2.0**-30", "LAST_STEP = 2.0**-30")


@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_in_the_written_text_is_seen(fault: str, monkeypatch: pytest.MonkeyPatch) -> None:
    module, function, old, new = FAULTS[fault]
    node = restricted.integrator().functions[function].node
    assert old.split("\n")[0] in ast.unparse(node)
    with suppress(IndexError, ValueError, OverflowError):  # which is seen, too
        assert not ends_as_written(monkeypatch, module, old, new)


# --- what is refused -------------------------------------------------------------------------------------------------

BAD = {
    "def f(x: V) -> V:\n    return x ** 2\n": "not in the grammar",
    "def f(x: V) -> V:\n    return y + x\n": "y has no value here",
    "def f(s: Lanes) -> V:\n    return s.velocity\n": "no entry velocity",
    "def f(n: N) -> N:\n    while n > 0:\n        break\n    return n\n": "not in the grammar",
    "def f(x: V) -> V:\n    return g(x)\n": "there is no function g",
    "def f(x) -> V:\n    return x\n": "one of the kinds",
    "def f(x: V) -> V:\n    y = 1.0\n    return x + y\n": "y needs an annotation",
    "def f(x: V) -> V:\n    if x > 0.0:\n        x = 1.0 * x\n    return x\n": "lanes decide by",
    "def f(x: V) -> V:\n    while x > 0.0:\n        x = 1.0 * x\n    return x\n": "lanes decide by",
    "def f(x: V, m: M, n: N) -> V:\n    return where(m and n > 0, x, 0.0)\n": "joined with masks only",
    "def f(x: V) -> V:\n    return x if x > 0.0 else 0.0\n": "a choice by lane is `where`",
    "x: int\n": "a module has",
    "X = 1\nX = 2\n": "one value",
}


def bad(source: str) -> restricted.Text:
    text = restricted.Text()
    text.read(source, "bad.py")
    return text


@pytest.mark.parametrize("source", BAD)
def test_what_is_outside_the_grammar_is_refused_with_its_file_and_line(source: str) -> None:
    for functions in (restricted_c.c_functions, restricted_numpy.numpy_functions):
        with pytest.raises(restricted.GrammarError, match=rf"^bad\.py, line \d+: .*{BAD[source]}"):
            functions(bad(source))
