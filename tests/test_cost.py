"""The price list: references against quadrature in ball arithmetic; verdicts that follow from the rows. No timings."""

import csv
import io
import json
from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from types import SimpleNamespace
from typing import Any

import mpmath
import numpy as np
import oracle
import pytest
from mpmath import mpf

from generated import kernels
from slipcircle.cost import cost, costtext, reference, scenes, ways
from slipcircle.cost.cost import Row
from slipcircle.cost.ways import Way
from slipcircle.outputs import pictures, tables

SEEN = (1e-100, 1e-8, 1e-4, 0.3, 0.80, 1.55, float(np.nextafter(np.pi / 2, 0)), float(np.pi / 2))
MEASURED = "weight_moment_amplitude"
ANSWERS = json.loads(scenes.ANSWERS.read_text("utf-8"))
FORMS = {"fused": "fused", "plain": "plain C", "numpy": "NumPy"}
# Few elements and few turns: no test is about how long something takes.
QUICK: dict[str, Any] = {"SIZES": (1, 50, 400), "REPEATS": 2, "_TICK": 1e-7, "_PATIENCE": 0.0, "_PASS": 0.04}


@pytest.fixture(scope="module", autouse=True)
def _quick() -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patch:
        for name, value in QUICK.items():
            patch.setattr(cost, name, value)
        yield


@pytest.fixture(scope="module")
def rows(_quick: None) -> list[Row]:
    return cost.measure([MEASURED])


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
            unit = mpf(float(np.spacing(np.dtype(kind).type(found.nearest[at]))))
            value = mpf(found.nearest[at]) + mpf(found.rest[at]) * unit
            assert abs(value - exact) < unit * mpf(10) ** -12


@pytest.mark.parametrize("kind", ["float64", "float32"])
def test_the_set_is_dense_at_both_ends(kind: str) -> None:
    points = reference.inputs(kind)
    assert points.dtype == kind
    assert points[0] == 0.0
    assert points[-1] == points.dtype.type(np.pi / 2)
    assert np.all(np.diff(points) > 0)
    assert len(points) > 0.8 * reference.POINTS
    place = cost_axis(points.astype(float))
    decades = np.histogram(place, np.arange(-7 if kind == "float32" else -14, 7 if kind == "float32" else 14))[0]
    assert min(decades) > 20
    assert np.mean((points > 0.1) & (points < 1.5)) > 0.2
    np.testing.assert_array_equal(reference.inputs.__wrapped__(kind), points)  # drawn anew, the same


def cost_axis(alpha: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    from slipcircle.cost.costplot import both_ends

    return both_ends(alpha)


def test_errors_are_fractional_and_hold_among_denormal_numbers() -> None:
    found = reference.kernel("resistance_factor")
    some = np.linspace(1, found.points.shape[1] - 1, 60).astype(int)
    results = found.nearest[some] + 3 * found.unit[some]
    picked = reference.reference(found.points[:, some], [found.values[i] for i in some])
    ulp, relative = picked.errors(results)
    for result, ball, seen in zip(results, picked.values, ulp, strict=True):
        assert abs(seen) == pytest.approx(oracle.ulps(result, ball), rel=1e-9)
    with mpmath.workdps(60):
        for result, ball, seen in zip(results, picked.values, relative, strict=True):
            size = max(digits(ball), mpf(float(np.finfo(float).smallest_normal)))
            assert seen == pytest.approx(float(abs(mpf(float(result)) - digits(ball)) / size), rel=1e-9)
    results[3], results[5] = np.nan, -np.inf
    ulp, relative = picked.errors(results)
    assert ulp[3] == ulp[5] == relative[3] == relative[5] == np.inf


# --- tiers, by a stand-in that has the compiled kernels' interface -------------------------------------------------

TIERS = {"best": (3e-16, 2.0), "1e-10": (8e-11, None), "1e-6": (7e-7, None), "float32": (6e-8, 0.505)}


def stand_in(exact: Callable[..., Any], spoilt: str = "") -> SimpleNamespace:
    """A module like `generated._compiled`, whose tiers keep what they promise, all but the one that is spoilt."""

    asked: list[str] = []

    def kernel(name: str, texts: Any, level: str) -> Callable[..., Any]:
        asked.append(level)

        def call(alpha: Any, out: Any = None, where: Any = True, accuracy: float | None = None) -> Any:
            x = np.asarray(alpha)
            tier = {8e-11: "1e-10", 7e-7: "1e-6"}[accuracy] if accuracy else "best" if x.dtype == float else "float32"
            value = exact(np.minimum(x.astype(float), np.pi / 2)) * (1 + TIERS[tier][0] / 2 * (accuracy is not None))
            value = (value * (1 + 1e-6 * (tier == spoilt))).astype(x.dtype)
            if out is None:
                return value[()]
            np.copyto(out, value)
            return out

        return call

    loops: dict[str, dict[str, None]] = {tier: {MEASURED: None} for tier in ("best", "1e-10", "1e-6")}
    levels: Any = {"avx512": ("fused", loops), "avx2": ("fused", loops), "baseline": ("plain", loops)}
    levels["numpy"] = ("numpy", {})
    bounds = {tier: {"fused": bound, "plain": bound} for tier, bound in TIERS.items()}
    return SimpleNamespace(LEVELS=levels, BOUNDS={MEASURED: bounds}, kernel=kernel, asked=asked)


@pytest.fixture
def tiered(monkeypatch: pytest.MonkeyPatch) -> Callable[[str], list[Row]]:
    def measured(spoilt: str = "") -> list[Row]:
        module = stand_in(np.vectorize(exactly, otypes=[float]), spoilt)
        monkeypatch.setattr(ways, "_compiled", module)
        monkeypatch.setattr(ways, "tiers", module)
        monkeypatch.setattr(kernels, "TEXTS", {MEASURED: dict.fromkeys(TIERS)}, raising=False)
        monkeypatch.setattr(reference, "POINTS", 200)
        monkeypatch.setattr(ways, "INTEGRANDS", {})  # no quadrature
        for cached in (reference.inputs, reference.kernel, reference._balls):
            cached.cache_clear()
        found = cost.measure([MEASURED])
        for cached in (reference.inputs, reference.kernel, reference._balls):
            cached.cache_clear()
        return found

    return measured


def exactly(alpha: float) -> float:
    return float(oracle.kernel(MEASURED, alpha))


def test_tiers_stand_in_three_forms_with_what_is_proved_of_them(tiered: Callable[..., list[Row]]) -> None:
    rows = tiered()
    assert vars(ways)["_compiled"].asked == ["avx512", "baseline", "numpy"] * len(TIERS)  # the widest of each form
    ours = {r.way: r for r in rows if r.ours}
    assert list(ours) == [f"{tier}, {form}" for tier in TIERS for form in FORMS.values()]
    for way, row in ours.items():
        tier = way.partition(",")[0]
        assert (row.bound, row.bound_ulp) == TIERS[tier]
        assert row.kind == ("float32" if tier == "float32" else "float64")
        assert row.error <= TIERS[tier][0]
        assert row.ulp is not None
        assert row.ulp <= (TIERS[tier][1] or np.inf)
    assert 3e-11 < ours["1e-10, fused"].error < 5e-11
    assert 0.4 < float(ours["float32, fused"].ulp or 0) < 0.502
    assert "above what is proved" not in costtext.verdict(rows)
    head, cells = costtext.table(rows)
    proved = {c[head.index("way")]: c[head.index("proved")] for c in cells}
    assert (proved["best, fused"], proved["1e-10, NumPy"], proved["float32, plain C"]) == (
        "2 ulp",
        "8e-11",
        "0.505 ulp",
    )
    assert proved["printed, float64"] == proved["half-angle, NumPy"] == "sampled only"


@pytest.mark.parametrize("tier", ["best", "1e-10", "float32"])
def test_an_error_above_the_bound_is_said_first(tier: str, tiered: Callable[..., list[Row]]) -> None:
    said = " ".join(costtext.verdict(tiered(tier)).split())
    assert said.startswith("Seen above what is proved, so the proof or the build is wrong: ")
    assert said.partition(".")[0].count(f"{tier}, ") == 3


def test_where_results_underflow_another_bound_holds() -> None:
    points = np.array([3e-103, 1e-90])
    row = Row(MEASURED, "best, fused", 1e-16, (0.1,), 1.0, bound=2e-16, bound_ulp=0.65, ulp=0.94, ours=True)
    for ulp, said in ((np.array([0.94, 0.6]), False), (np.array([0.94, -0.7]), True)):
        measured = replace(row, profile=cost.Profile(points, ulp, ulp))
        assert ("above what is proved" in costtext.verdict([measured])) == said


# --- rows ----------------------------------------------------------------------------------------------------------


def test_measured_rows(rows: list[Row]) -> None:
    others = [r.way for r in rows if not r.ours]
    assert others == [
        "half-angle, NumPy", "printed, float64", *(f"Gauss, {n} points" for n in ways.GAUSS_POINTS),
        ways.FLOOR,
    ]  # fmt: skip
    assert {r.function for r in rows} == {MEASURED}
    *computed, floor = rows
    for r in computed:
        assert 0 < min(r.ns_1 or 0, r.ns_1e4 or 0, r.ns_1e6 or 0)
        assert 0 <= r.error < np.inf
        assert r.points > 100
        assert r.elements == cost.SIZES[-1]
    error = {r.way: r.error for r in computed}
    assert error["half-angle, NumPy"] < 5e-15
    assert error["printed, float64"] > 0.5  # a difference of O(alpha) that is O(alpha**3)
    gauss = [error[f"Gauss, {n} points"] for n in ways.GAUSS_POINTS]
    assert all(more <= max(1.5 * fewer, 1e-14) for fewer, more in pairwise(gauss))
    assert (floor.way, floor.verdict) == (ways.FLOOR, "floor")
    assert np.isnan(floor.error)


def test_the_worst_input_shows_the_error(rows: list[Row]) -> None:
    """An error can be seen again at the input that is printed with it, against ball arithmetic."""
    way = {w.name: w for w in ways.FUNCTIONS[MEASURED]().ways}
    for row in rows[:-1]:
        for (alpha,), seen, against in ((row.worst_input, row.error, None), (row.worst_input_ulp, row.ulp, "ulp")):
            value = np.asarray(way[row.way].function(np.array([alpha], row.kind)))[0]
            with mpmath.workdps(60):
                exact = digits(oracle.kernel(MEASURED, Fraction(alpha))) if alpha else mpf(0)
                kind = np.dtype(row.kind).type
                unit, least = np.spacing(kind(float(exact))), np.finfo(kind).smallest_normal
                size = mpf(float(unit)) if against else max(exact, mpf(float(least)))
                rest = value - value.dtype.type(float(value))  # what a longdouble has beyond a double
                found = float(abs(mpf(float(value)) + mpf(float(rest)) - exact) / size)
            assert seen == pytest.approx(found, rel=1e-3), (row.way, against)


def test_the_worst_is_the_largest_of_either_sign() -> None:
    exact = reference.kernel(MEASURED)
    results = exact.nearest + 2 * exact.unit
    results[700] -= 7 * exact.unit[700]
    row = cost._seen(Row("f", "w", 0.0, (), 1.0), Way("w", lambda x: results), exact)
    assert row.ulp == pytest.approx(5, abs=0.51)
    assert row.worst_input_ulp == (exact.points[0, 700],)
    assert row.points == len(results)


def test_everything_is_timed_in_turns() -> None:
    calls: list[str] = []
    samples = cost.interleaved([lambda: calls.append("a"), lambda: calls.append("b")])
    assert [len(s) for s in samples] == [2, 2]
    order = "".join(name for name, before in zip(calls, ["", *calls], strict=False) if name != before)
    assert order == "ababab"  # each once to warm up, then in turns


def test_slow_ways_get_few_elements(monkeypatch: pytest.MonkeyPatch) -> None:
    """No pass takes long: ten times as many elements only as long as the last pass says so."""
    monkeypatch.setattr(cost, "_timed", lambda work, loops: 5e-4 * np.size(work.args[0]))
    slow, subject = Way("slow", np.copy), ways.Subject("f", [], reference.kernel, ways.angles)
    for size, patience, count in ((400, 1.0, 10), (400, 20.0, 400), (400, 5.0, 100), (1, 1.0, 1)):
        assert cost._fitting(slow, replace(subject, patience=patience), size) == count


def test_progress_and_unknown_functions() -> None:
    said = io.StringIO()
    cost.measure(["dynamic_coefficient"], progress=said)
    assert said.getvalue() == "measuring dynamic_coefficient\n"
    known = r"^function 'polar' is unknown; known are kernels, flow, polar_moment, .*sections, .*record$"
    with pytest.raises(ValueError, match=known):
        cost.measure(["resistance_factor", "polar"])


# --- verdicts ------------------------------------------------------------------------------------------------------


def judged(*rows: tuple[str, float, float]) -> list[Row]:
    return cost.judged([Row("f", way, error, (), 0.5, ns, ns, ours=way.startswith("our")) for way, error, ns in rows])


def verdicts(*rows: tuple[str, float, float]) -> dict[str, str]:
    """Verdict of each way, from its error and its time."""
    return {r.way: r.verdict for r in judged(*rows)}


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


def test_the_frontier_and_who_is_beaten() -> None:
    assert verdicts(*RACE) == {
        "exact": "frontier",
        "our good": "frontier",
        "our rough": "frontier",
        "slow and good": "beaten: our good",
        "our slow and rough": "beaten: our rough",
        "slower than exact": "beaten: exact",
        "fails": "no digit",
        "wrong": "no digit",
        "copy": "floor",
    }


def test_losses_are_said_as_plainly_as_wins() -> None:
    said = " ".join(costtext.verdict(judged(*RACE)).split())
    assert said == (
        "Frontier: exact (1.0e-30, 1 us); our good (1.0e-15, 10 ns); our rough (1.0e-3, 1 ns). "
        "Of ours, these lose: our slow and rough to our rough (50 times slower). "
        "Faster than anything of ours: fails, 10 times at N=1e4, 10 times at N=1e6, with an error of inf."
    )
    assert "None of ours is beaten." in costtext.verdict(judged(*RACE[:4]))
    assert "Faster than" not in costtext.verdict(judged(*RACE[:4]))
    assert "ours" not in costtext.verdict(judged(*RACE[1:3]))  # nothing to compare with


def test_a_close_race_is_not_decided() -> None:
    """Under `BEATEN` times faster is noise; nobody beats itself, nor one that is more accurate."""
    assert cost.BEATEN == 1.2
    assert verdicts(("one", 1e-9, 10.0), ("two", 1e-9, 11.9)) == {"one": "frontier", "two": "frontier"}
    assert "one" in verdicts(("one", 1e-9, 10.0), ("two", 1e-9, 12.1))["two"]
    assert verdicts(("one", 1e-9, 10.0), ("two", 0.99e-9, 1e6)) == {"one": "frontier", "two": "frontier"}
    assert verdicts(("alone", float("inf"), 1.0)) == {"alone": "no digit"}


# --- as text, for machines, and drawn ------------------------------------------------------------------------------


def test_the_table_names_who_beats_by_number() -> None:
    head, cells = costtext.table(judged(*RACE))
    assert head == ["#", "way", "proved", "seen", "N=1", "N=1e4", "N=1e6", "verdict"]  # the others are empty
    verdict = {c[1]: c[-1] for c in cells}
    assert (verdict["our slow and rough"], verdict["exact"], verdict["fails"]) == ("beaten 3", "frontier", "no digit")
    assert [c[0] for c in cells] == [str(i) for i in range(1, len(RACE) + 1)]


def test_the_widest_rows_fit(capsys: pytest.CaptureFixture[str]) -> None:
    row = Row(
        "f", "printed, longdouble", 1.7e-291, (1.2e-103,), 123456.7, 54321.4, 54321.4, 40, None, None,
        7.4e306, (1.2e-103,), verdict="beaten: 2",
    )  # fmt: skip
    rows = [*([row] * 11), replace(row, way="2", bound=9.31e-11), replace(row, way="2", bound_ulp=0.981)]
    tables.show(*costtext.table(rows), title="f")
    lines = capsys.readouterr().out.splitlines()
    assert max(map(len, lines)) <= 100
    assert len(lines) == 4 + len(rows)  # none is broken


def test_records_and_csv_keep_every_digit(rows: list[Row]) -> None:
    failing = Row("f", "w", float("inf"), (0.1 + 0.2,), 1 / 3)
    text = json.dumps([costtext.record(r) for r in (*rows, failing)], allow_nan=False)
    back = json.loads(text)
    assert back[-1] | {"error": None, "worst_input": [0.1 + 0.2], "ns_1": 1 / 3} == back[-1]
    assert "profile" not in back[0]
    found = list(csv.DictReader(costtext.table_csv([*rows, failing]).decode().splitlines()))
    assert [r["way"] for r in found] == [r.way for r in (*rows, failing)]
    for line, row in zip(found, rows, strict=False):
        assert float(line["ns_1"]) == row.ns_1
        assert tuple(map(float, line["worst_input"].split())) == row.worst_input
        assert line["bound"] == ("" if row.bound is None else repr(row.bound))
        assert line["error"] == ("" if row.error != row.error else repr(row.error))


def test_the_picture(tiered: Callable[..., list[Row]]) -> None:
    pytest.importorskip("matplotlib")
    from slipcircle.cost import costplot

    rows = [*tiered(), *judged(*RACE[:3])]
    drawn = pictures.render(lambda figure: costplot.overview(rows, figure), costplot.size(rows), "svg").decode()
    for text in (MEASURED, "best, fused", "printed, float64", "ours, worst seen; a bar up to what is proved",
                 "time of an element at N = 1e4, ns", "alpha, rad", "our good"):  # fmt: skip
        assert f"<!-- {text} -->" in drawn, text


def test_the_axis_of_alpha_shows_both_ends() -> None:
    alpha = np.array([0.0, 1e-12, 1e-6, 0.1, np.pi / 4, np.pi / 2 - 1e-6, np.nextafter(np.pi / 2, 0), np.pi / 2, 1.571])
    place = cost_axis(alpha)
    assert place[0] == -np.inf
    assert np.all(np.diff(place[1:]) >= 0)
    assert place[4] == 0
    assert place[5] == pytest.approx(-place[2], abs=1e-9)  # as far from its end, as far from the middle
    assert place[7] == place[8] == pytest.approx(16.1, abs=0.1)  # pi/2 lies 6e-17 above its nearest double
