"""The price list: references against ball arithmetic and Taylor series; verdicts that follow. No timings."""

import csv
import json
import re
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from generated._compiled import LEVELS
from generated.tiers import BOUNDS
from slipcircle.workbench.cost import cost, costplot, costtext, reference, scenes, sections, ways
from slipcircle.workbench.cost.cost import Row
from slipcircle.workbench.outputs import pictures
from tests.campaigns import exact_scenes
from tests.support import oracle
from tests.support.outputs import QUICK
from tests.support.pictures import canvas

SEEN = (1e-100, 1e-8, 1e-4, 0.3, 0.80, 1.55, float(np.nextafter(np.pi / 2, 0)), float(np.pi / 2))
MEASURED = "weight_moment_amplitude"


@pytest.fixture(scope="module", autouse=True)
def _quick() -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patch:
        for name, value in QUICK.items():
            patch.setattr(cost, name, value)
        yield


@pytest.fixture(scope="module")
def rows(_quick: None) -> list[Row]:
    return cost.measure([MEASURED])


def answers() -> dict[str, dict[str, list[str]]]:
    """References of the scenes, by case and friction."""
    return dict(json.loads(scenes.ANSWERS.read_text("utf-8")))


def digits(ball: Any) -> mpf:
    with mpmath.workdps(70):
        return mpf(ball.str(60, radius=False))


# --- what everything is compared with ------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", ["float64", "float32"])
@pytest.mark.parametrize("name", ways.KERNELS)
def test_references_are_the_definitions(name: str, kind: str) -> None:
    """Exact values by quadrature of the double integral; of each format the ends and some points between."""
    found = reference.kernel(name, kind)
    points = found.points[0]
    chosen = {int(np.searchsorted(points, x)) for x in SEEN if points[0] <= x <= points[-1]} | {1, len(points) - 1}
    with mpmath.workdps(90):
        for at in chosen:
            exact = digits(oracle.kernel(name, Fraction(points[at])))
            assert abs(digits(found.values[at]) / exact - 1) < mpf(10) ** -45, points[at]


@pytest.mark.parametrize("kind", ["float64", "float32"])
def test_inputs_go_from_end_to_end(kind: str) -> None:
    points = reference.inputs(kind)
    assert points.dtype == kind
    assert [points[0], points[-1]] == [0.0, points.dtype.type(np.pi / 2)]
    assert np.all(np.diff(points) > 0)
    np.testing.assert_array_equal(reference.inputs.__wrapped__(kind), points)  # drawn anew, the same


def test_errors_are_fractional_and_hold_among_denormal_numbers() -> None:
    found = reference.kernel("resistance_factor")
    some = np.linspace(1, found.points.shape[1] - 1, 60).astype(int)
    results = found.nearest[some] + 3 * found.unit[some]
    results[3], results[5] = np.nan, -np.inf
    picked = reference.reference(found.points[:, some], [found.values[i] for i in some])
    with mpmath.workdps(60):
        for result, ball, ulp, relative in zip(results, picked.values, *picked.errors(results), strict=True):
            assert abs(ulp) == pytest.approx(oracle.ulps(result, ball), rel=1e-9)
            size = max(digits(ball), mpf(float(np.finfo(float).smallest_normal)))
            share = float(abs(mpf(float(result)) - digits(ball)) / size) if np.isfinite(result) else np.inf
            assert relative == pytest.approx(share, rel=1e-9)


# --- rows ----------------------------------------------------------------------------------------------------------


def test_measured_rows(rows: list[Row]) -> None:
    """Tiers in the forms that run here with what is proved of them; the printed form and quadrature beside."""
    others = ["half-angle, NumPy", "printed, float64", *(f"Gauss, {n} points" for n in ways.GAUSS_POINTS), ways.FLOOR]
    assert [r.way for r in rows if not r.ours] == others
    for r in rows:
        assert 0 < min(r.ns_1 or 0, r.ns_1e4 or 0, r.ns_1e6 or 0)
        assert (r.function, r.elements) == (MEASURED, cost.SIZES[-1])
    error = {r.way: r.error for r in rows}
    assert rows[-1].verdict == "floor"
    assert np.isnan(error[ways.FLOOR])
    assert error["half-angle, NumPy"] < 5e-15
    assert error["printed, float64"] > 0.5  # a difference of O(alpha) that is O(alpha**3)
    gauss = [error[f"Gauss, {n} points"] for n in ways.GAUSS_POINTS]
    assert all(more <= max(1.5 * fewer, 1e-14) for fewer, more in pairwise(gauss))
    forms = {form for form, _ in LEVELS.values()}
    words = [word for form, word in (("fused", "fused"), ("plain", "plain C"), ("numpy", "NumPy")) if form in forms]
    ours = {r.way: r for r in rows if r.ours}
    assert list(ours) == [f"{tier}, {word}" for tier in BOUNDS[MEASURED] for word in words]
    assert "above what is proved" not in costtext.verdict(rows)
    head, cells = costtext.table(rows)
    proved = {cell[head.index("way")]: cell[head.index("proved")] for cell in cells}
    assert proved["printed, float64"] == proved["half-angle, NumPy"] == "sampled only"
    for way, row in ours.items():
        assert proved[way] == (f"{row.bound_ulp:.3g} ulp" if row.bound_ulp else f"{row.bound:.3g}")
        tier, _, word = way.partition(", ")
        assert (row.bound, row.bound_ulp) == BOUNDS[MEASURED][tier]["fused" if word == "fused" else "plain"]
        assert row.error <= (row.bound or 0.0)
        assert (row.ulp or 0.0) <= (row.bound_ulp or np.inf)


def test_what_is_above_its_bound_is_said() -> None:
    row = Row(MEASURED, "best, fused", 1e-16, (0.1,), 1.0, bound=2e-16, bound_ulp=0.65, ulp=0.94, ours=True)
    for second, above_it in ((0.6, False), (-0.7, True)):  # where results underflow another bound holds
        ulp = np.array([0.94, second])
        measured = replace(row, profile=cost.Profile(np.array([3e-103, 1e-90]), ulp, ulp))
        assert ("above what is proved" in costtext.verdict([measured])) == above_it


def test_the_worst_input_shows_the_error(rows: list[Row]) -> None:
    """An error can be seen again at the input that is printed with it, against ball arithmetic."""
    functions = {way.name: way.function for way in ways.FUNCTIONS[MEASURED]().ways}
    for row in rows[:-1]:
        (alpha,) = row.worst_input
        value = float(np.asarray(functions[row.way](np.array([alpha], row.kind)))[0])
        with mpmath.workdps(60):
            exact = digits(oracle.kernel(MEASURED, Fraction(alpha)))
            error = abs(mpf(value) - exact) / max(exact, mpf(float(np.finfo(row.kind).smallest_normal)))
        assert row.error == pytest.approx(float(error), rel=1e-3), row.way


def test_everything_is_timed_in_turns(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cost, "_LONG", 1.0)
    calls: list[str] = []
    samples = cost.interleaved([lambda: calls.append("a"), lambda: calls.append("b")])
    assert [len(s) for s in samples] == [2, 2]
    order = "".join(name for name, before in zip(calls, ["", *calls], strict=False) if name != before)
    assert order == "ababab"  # each once to warm up, then in turns


# --- verdicts ------------------------------------------------------------------------------------------------------


def judged(*rows: tuple[str, float, float]) -> list[Row]:
    return cost.judged([Row("f", way, error, (), 0.5, ns, ns, ours=way.startswith("our")) for way, error, ns in rows])


RACE = (
    ("exact", 1e-30, 1000.0),
    ("our good", 1e-15, 10.0),
    ("our rough", 1e-3, 1.0),
    ("slow and good", 1e-15, 13.0),  # as accurate as "good", and 1.3 times slower
    ("our slow and rough", 1e-2, 50.0),  # beaten by two; the faster is named
    ("slower than exact", 1e-29, 5000.0),
    ("fails", float("inf"), 0.1),
    ("wrong", 1.0, 2.0),
    ("copy", float("nan"), 0.05),
)


def test_verdicts_of_a_race() -> None:
    """The frontier, who is beaten and by whom; losses are said as plainly as wins."""
    found = judged(*RACE)
    assert [r.verdict for r in found] == [
        "frontier", "frontier", "frontier", "beaten: our good", "beaten: our rough", "beaten: exact", "no digit",
        "no digit", "floor",
    ]  # fmt: skip
    assert " ".join(costtext.verdict(found).split()) == (
        "Frontier: exact (1.0e-30, 1 us); our good (1.0e-15, 10 ns); our rough (1.0e-03, 1 ns). "
        "Of ours, these lose: our slow and rough to our rough (50 times slower). "
        "Faster than anything of ours: fails, 10 times at N=1e4, 10 times at N=1e6, with an error of inf."
    )
    won = costtext.verdict(judged(*RACE[:4]))
    assert "None of ours is beaten." in won
    assert "Faster than" not in won
    assert "ours" not in costtext.verdict(judged(*RACE[1:3]))  # nothing to compare with
    head, cells = costtext.table(found)
    assert head == ["#", "way", "proved", "seen", "N=1", "N=1e4", "N=1e6", "verdict"]  # the others are empty
    assert [c[-1] for c in cells][4:7] == ["beaten 3", "beaten 1", "no digit"]


def test_a_close_race_is_not_decided() -> None:
    """Under `BEATEN` times faster is noise; nobody beats itself, nor one that is more accurate."""
    assert cost.BEATEN == 1.2
    for error, ns, verdict in ((1e-9, 11.9, "frontier"), (1e-9, 12.1, "beaten: one"), (0.99e-9, 1e6, "frontier")):
        assert [r.verdict for r in judged(("one", 1e-9, 10.0), ("two", error, ns))] == ["frontier", verdict]
    assert judged(("alone", float("inf"), 1.0))[0].verdict == "no digit"


# --- as text, for machines, and drawn ------------------------------------------------------------------------------


def test_records_and_csv_keep_every_digit(rows: list[Row]) -> None:
    failing = Row("f", "w", float("inf"), (0.1 + 0.2,), 1 / 3)
    *_, last = json.loads(json.dumps([costtext.record(r) for r in (*rows, failing)], allow_nan=False))
    assert last | {"error": None, "worst_input": [0.1 + 0.2], "ns_1": 1 / 3} == last
    *_, line = csv.DictReader(costtext.table_csv([*rows, failing]).decode().splitlines())
    assert (line["way"], line["worst_input"], line["ns_1"]) == ("w", repr(0.1 + 0.2), repr(1 / 3))
    assert (line["error"], line["bound"]) == ("", "")


def test_the_command(asked: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    table, picture = tmp_path / "cost.csv", tmp_path / "cost.png"
    _, out, err = asked("cost resistance_factor --json --csv", table, "--plot", picture)
    assert re.fullmatch(r"(1 of 1 functions measured.*\n)?", err)  # where it takes longer than a moment
    found = json.loads(out, parse_constant=pytest.fail)
    assert np.__version__ in found["machine"]
    names = [row["way"] for row in found["rows"]]
    assert {"printed, float64", "half-angle, NumPy", "np.copyto (floor)"} <= set(names)
    assert table.read_text("utf-8").count("\nresistance_factor,") == len(names)
    assert picture.read_bytes().startswith(b"\x89PNG")
    fails = Row("f", "printed, longdouble", float("inf"), (1.2e-103,), 123456.7, 54321.4, 54321.4, 40)
    monkeypatch.setattr(cost, "measure", lambda names, report: [fails])
    assert json.loads(asked("cost --json")[1], parse_constant=pytest.fail)["rows"][0]["error"] is None
    lines = asked("cost")[1].splitlines()
    assert max(map(len, lines)) <= 100
    assert any(re.match(r"1 +printed, longdouble ", line) for line in lines)


def test_the_picture(rows: list[Row]) -> None:
    both = [*rows, *judged(*RACE[:3])]
    drawn = pictures.render(lambda figure: costplot.overview(both, figure), costplot.size(both), "svg").decode()
    for text in (MEASURED, "best, NumPy", "ours, worst seen; a bar up to what is proved", "alpha, rad"):
        assert f"<!-- {text} -->" in drawn, text
    assert "our good" in [text.get_text() for text in costplot.frontier(both[-3:], canvas().subplots()).texts]


# --- scenes --------------------------------------------------------------------------------------------------------


def test_the_answers_are_made_again() -> None:
    """The first of every sixth case, to its last digit; frictions are those of the ensemble's lanes."""
    first = {name: dict([next(iter(of.items()))]) for name, of in [*answers().items()][::6]}
    assert json.dumps(first, indent=1) + "\n" == exact_scenes.written(first)
    assert sections.ANSWERS.read_text("utf-8") == exact_scenes.measures()
    for one, *lanes in (map(float, of) for of in answers().values()):
        assert one == pytest.approx(float(scenes.frictions(1)[0]), rel=1e-15)
        assert lanes == pytest.approx(scenes.frictions(len(scenes.ANGLES)).tolist(), rel=1e-15)


@pytest.mark.parametrize(("name", "many"), [("frozen geometry", True), ("constant friction", False), ("heat", False)])
def test_rows_of_scenes(name: str, many: bool) -> None:
    """Ours keep to the accuracy, by either walk; a peer's error falls with its tolerance."""
    rows = {r.way: r for r in cost.measured(scenes.subject(name, many))}
    for way, row in rows.items():
        asked = 0.0 if way == scenes.CLOSED_FORM else float(way.rpartition(" ")[2])
        assert row.points == (3 if many else 1)
        assert 0 < row.price < np.inf
        if row.ours:
            assert row.error < max(asked, 2e-14), way
    for peer in ("DOP853, rtol", "heyoka, tol"):
        errors = [r.error for way, r in rows.items() if way.startswith(peer)]
        assert not errors or errors[-1] < min(1e-9, errors[0])


def test_what_is_not_installed_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cost, "find_spec", lambda name: None)
    said: list[str] = []
    assert all(r.ours for r in cost.measured(scenes.subject("constant friction", False), said.append))
    assert said == [f"constant friction: {name} is missing, and not included" for name in ("scipy", "heyoka")]


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
