"""Errors, verdicts and recommendations of the command `cost`, without timings."""

import json
import math
import re
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from generated._compiled import LEVEL, LEVELS
from generated.tiers import BOUNDS
from slipcircle import Scene, load, solve
from slipcircle.tables import Series
from slipcircle.workbench.cost import kernels, rows, scenes
from slipcircle.workbench.cost.rows import CostRow
from slipcircle.workbench.files.shipped import shipped
from tests.support import oracle, taylor
from tests.support.outputs import QUICK, words_of

SEEN = (1e-90, 1e-8, 1e-4, 0.3, 0.80, 1.55, float(np.nextafter(np.pi / 2, 0)), float(np.pi / 2))
MEASURED = "weight_moment_amplitude"


@pytest.fixture(scope="module", autouse=True)
def _quick() -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patch:
        for name, value in QUICK.items():
            patch.setattr(rows, name, value)
        patch.setattr(scenes, "MOST", 10)
        yield


# --- kernels ---------------------------------------------------------------------------------------------------------


def digits(name: str, point: float) -> Any:
    """Return the exact value by quadrature of the double integral."""
    with mpmath.workdps(70):
        return mpf(oracle.kernel(name, Fraction(point)).str(60, radius=False))


@pytest.mark.parametrize("kind", ["float64", "float32"])
@pytest.mark.parametrize("name", kernels.KERNELS)
def test_references_are_the_definitions(name: str, kind: str) -> None:
    """References at both ends of each format and between are exact; two doubles are 100 bits."""
    exact = kernels.exact_values(name, kind)
    chosen = {int(np.searchsorted(exact.points, x)) for x in SEEN if exact.points[0] <= x <= exact.points[-1]}
    with mpmath.workdps(90):
        for at in chosen | {len(exact.points) - 1}:
            value = digits(name, float(exact.points[at]))
            assert abs((mpf(exact.nearest[at]) + mpf(exact.rest[at])) / value - 1) < mpf(10) ** -30, exact.points[at]


@pytest.mark.parametrize("kind", ["float64", "float32"])
def test_inputs_go_from_end_to_end(kind: str) -> None:
    points = kernels.kernel_inputs(kind)
    assert points.dtype == kind
    assert [points[0], points[-1]] == [0.0, points.dtype.type(np.pi / 2)]
    assert np.all(np.diff(points) > 0)
    assert np.pi / 2 - points[-2] < 1e-6
    np.testing.assert_array_equal(kernels.kernel_inputs.__wrapped__(kind), points)  # drawn anew, the same


def test_rows_of_a_kernel() -> None:
    """Tiers as they run here with what is proved of them, and the printed form; errors are seen again."""
    measured = {row.way: row for row in kernels.of_kernel(MEASURED)}
    names = [f"{tier}{of}" for of in dict.fromkeys(["" if LEVEL != "numpy" else ", NumPy", ", NumPy"])
             for tier in BOUNDS[MEASURED]]  # fmt: skip
    assert list(measured) == [*names, "printed"]
    for way, row in measured.items():
        tier, _, numpy = way.partition(", ")
        form = "fused" if LEVELS[LEVEL][0] == "fused" and not numpy else "plain"
        assert row.bound == (BOUNDS[MEASURED][tier][form][0] if tier != "printed" else None)
        assert row.bound is None or 0.2 * row.bound < row.error <= row.bound
        assert (row.group, row.count) == (MEASURED, kernels.SIZE)
        assert row.seconds > 0.0
    assert measured["printed"].error > 0.5  # a difference of O(alpha) that is O(alpha**3)


def test_errors_of_a_kernel_are_fractional() -> None:
    """Against the unrounded value, and infinite for what is not finite."""
    exact = kernels.exact_values("resistance_factor")
    some = np.linspace(9, len(exact.points) - 1, 60).astype(int)
    picked = kernels.Exact(exact.points[some], exact.nearest[some], exact.rest[some], exact.least)
    results = picked.nearest + 3 * np.spacing(picked.nearest)
    results[3] = np.nan
    for point, result, error in zip(picked.points, results, picked.errors(results), strict=True):
        value = digits("resistance_factor", float(point))
        with mpmath.workdps(60):
            expected = float(abs(mpf(float(result)) / value - 1)) if np.isfinite(result) else np.inf
        assert error == pytest.approx(expected, rel=1e-9)


# --- verdicts --------------------------------------------------------------------------------------------------------


def judged(*ways: tuple[str, float, float]) -> list[CostRow]:
    return rows.with_verdicts([CostRow("f", way, 1, error, None, seconds) for way, error, seconds in ways])


def test_verdicts_of_a_race() -> None:
    """The frontier, and of each other way the fastest that beats it."""
    found = judged(
        ("exact", 1e-16, 1000.0),
        ("good", 1e-15, 10.0),
        ("rough", 1e-3, 1.0),
        ("slow and good", 1e-15, 13.0),
        ("slow and rough", 1e-2, 50.0),  # beaten by two; the faster is named
        ("slower than exact", 1e-15, 5000.0),
        ("as fast as rough, and worse", 2e-3, 1.0),
    )
    assert [row.verdict for row in found] == [
        "frontier", "frontier", "frontier", "beaten by good", "beaten by rough", "beaten by good",
        "beaten by rough",
    ]  # fmt: skip
    for accuracy, best in ((1e-9, "good"), (1e-2, "rough"), (1e-40, None)):
        marked = [row.way for row in rows.recommended(found, accuracy) if row.verdict == "recommended"]
        assert marked == ([best] if best else [])


@pytest.mark.parametrize(("error", "seconds", "verdict"), [
    (1e-15, 11.9, "frontier"), (1e-15, 12.1, "beaten by one"), (1.2e-15, 11.0, "frontier"),
    (1e-15 + 2.3e-16, 10.0, "frontier"), (1.1e-15, 12.1, "beaten by one"), (3e-15, 10.0, "beaten by one"),
    (3e-15, 9.9, "frontier"), (3e-15, 8.3, "frontier"),
])  # fmt: skip
def test_a_close_race_is_a_tie(error: float, seconds: float, verdict: str) -> None:
    """One ulp more or less is equal, and so is a time within `MARGIN`; no way is beaten by a slower one."""
    assert rows.MARGIN == 1.2
    assert [row.verdict for row in judged(("one", 1e-15, 10.0), ("two", error, seconds))][1] == verdict


def test_everything_is_timed_in_turns() -> None:
    calls: list[str] = []
    samples = rows.interleaved([lambda: calls.append("a"), lambda: calls.append("b")])
    assert [len(s) for s in samples] == [rows.REPEATS] * 2
    order = "".join(name for name, before in zip(calls, ["", *calls], strict=False) if name != before)
    assert order == "ab" + "ab" * rows.REPEATS  # each to warm up, then in turns


# --- scenes ----------------------------------------------------------------------------------------------------------


def test_errors_of_an_ensemble_are_true_errors() -> None:
    """Errors of an ensemble equal the differences from Taylor series of 24 digits."""
    scene: Scene[Any] = load("vaiont")
    frictions = float(np.tan(np.radians(10.0))) * np.linspace(0.8, 1.2, 10)
    given = {"arc": oracle.plain(scene.arc), "effects": dict(scene.called), "initial_velocity": 0.0, "end_time": None}
    exact = [taylor.solve(given | {"friction": mu}, digits=24) for mu in frictions.tolist()]
    by_way = {row.way: row for row in scenes.of_scene(scene) if row.group == scenes.ENSEMBLE}
    for way in ("1e-3", "1e-6", "1e-9"):
        outcomes = solve(replace(scene, friction=frictions), float(way)).outcomes
        error = max(
            abs(float(outcomes[name][lane]) / float(case[name]) - 1)
            for lane, case in enumerate(exact)
            for name in ("run_out", "peak_velocity", "duration")
        )
        assert by_way[way].error == pytest.approx(error, rel=1e-3, abs=1e-15)
        assert by_way[way].error <= (by_way[way].bound or 0.0)


def odd_scenes() -> dict[str, Scene]:
    """Return a record, a law in Python, and arrays in a scene."""
    vaiont: Scene[Any] = load("vaiont")
    time = np.linspace(0.0, 20.0, 400)
    record = Series(time, 0.05 * np.sin(7 * time))
    return {
        "record": replace(vaiont, effects={**vaiont.called, "shaking": {"horizontal": record}}),
        "law in Python": replace(vaiont, friction=lambda slip: 0.15 + 0.1 * np.exp(-slip / 3)),
        "arrays": replace(vaiont, friction=np.array([0.2, 0.9])),
    }


@pytest.mark.parametrize("name", [*sorted(shipped())[::3], "record", "law in Python", "arrays"])
def test_rows_of_scenes(name: str) -> None:
    """A single scene is accurate to rounding, and cases keep to the accuracy, where they are accurate enough."""
    scene = load(name) if name in shipped() else odd_scenes()[name]
    alone, *ensemble = scenes.of_scene(scene)
    if scene.shape:
        ensemble = [alone, *ensemble]
    else:
        assert (alone.group, alone.way, alone.count, alone.verdict) == (scenes.ALONE, scenes.ANY, 1, "frontier")
        assert alone.error < 5e-14
    assert tuple(row.way for row in ensemble) == scenes.ACCURACIES
    assert {row.count for row in ensemble} == {2 if scene.shape else 10}
    assert [row.verdict for row in ensemble].count("recommended") == 1
    rounding = 5e-13 if name == "shaken-slope" else 1e-13  # one of its cases hardly moves
    for row in ensemble:
        assert row.misses == (row.error > float(row.way))
        assert row.error < max(float(row.way), rounding)
        assert row.error <= (row.bound or 0.0)
        assert row.seconds > 0.0


# --- the command -----------------------------------------------------------------------------------------------------


def test_the_command(asked: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    picture = tmp_path / "cost.png"
    _, out, err = asked("cost --json --plot", picture)
    progress = r"(5 of 5 accuracies solved.*\n)?"  # where it takes longer than a moment
    assert re.fullmatch(rf"{progress}slipcircle: wrote {re.escape(str(picture))}\n", err)
    found = json.loads(out, parse_constant=pytest.fail)
    assert (found["name"], np.__version__ in found["machine"]) == ("vaiont", True)  # the slide of the paper
    assert [row["way"] for row in found["rows"]] == [scenes.ANY, *scenes.ACCURACIES]
    assert {"alone, filled on the frontier", "ensemble, filled on the frontier"} <= set(words_of(picture.read_bytes()))
    wrong = CostRow(MEASURED, "best", 1, 3e-16, 2e-16, 1e-9)
    fails = replace(wrong, way="printed", error=np.inf, bound=None)
    monkeypatch.setattr(kernels, "of_kernel", lambda name: [wrong, fails])
    printed = json.loads(asked("cost polar_moment --json")[1], parse_constant=pytest.fail)
    assert printed["rows"][1]["error"] is None
    text = asked("cost polar_moment")[1]
    assert max(map(len, text.splitlines())) <= 100
    assert f"The error of best ({MEASURED}) is above its bound" in " ".join(text.split())
    assert re.search(r"printed +1 +no digit", text)


def test_a_file_of_ones_own(said: Any, tmp_path: Path) -> None:
    """An accuracy in the file is what is recommended for."""
    path = tmp_path / "my-slope.toml"
    path.write_text("accuracy = 1e-5\n[ground]\nheight_m = 10\nangle_deg = 40\nunit_weight_kN_m3 = 20\n[friction]\n"
                    "angle_deg = 20\n[cohesion]\ncohesion_kPa = 3\n[circle]\ncritical = 'bishop'\n[rotation]\n",
                    "utf-8")  # fmt: skip
    found = json.loads(said("cost", path, "--json"))
    ensemble = [row for row in found["rows"] if row["group"] == scenes.ENSEMBLE]
    meeting = [row for row in ensemble if max(row["error"], row["bound"]) <= 1e-5]
    fastest = min(meeting, key=lambda row: float(row["seconds"]))
    assert (found["name"], fastest["verdict"]) == ("my-slope", "recommended")


@pytest.mark.parametrize(("wanted", "best"), [
    ("--accuracy 1e-7", "good"), ("--accuracy 1e-2", "rough"), ("--budget 5ns", "rough"), ("--budget 1us", "good"),
    ("--accuracy 1e-20", None), ("--budget 0.5ns", None),
])  # fmt: skip
def test_one_row_meets_what_is_wanted(
    wanted: str, best: str | None, asked: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The fastest accurate row or the most accurate fast row; a proved bound counts, not only the error seen."""
    ways = {"good": (1e-8, 2e-8, 10e-9), "lucky": (1e-9, 1e-3, 5e-9), "rough": (1e-4, 1e-4, 1e-9)}
    if best == "rough" and "budget" in wanted:
        del ways["lucky"]
    found = [CostRow("f", way, 1, error, bound, time, accuracy=bound) for way, (error, bound, time) in ways.items()]
    if "1us" in wanted:
        found = [row for row in found if row.way != "lucky"]
    monkeypatch.setattr(kernels, "of_kernel", lambda name: rows.with_verdicts(found))
    text = " ".join(asked(f"cost polar_moment {wanted}")[1].split())
    name, _, value = wanted.removeprefix("--").partition(" ")
    said = {"1e-7": "1e-07", "1e-2": "0.01"}.get(value, value.replace("ns", " ns").replace("us", " us"))
    assert f"Recommended for {name} {said}: {best} (" in text if best else f"No row for {name}" in text


def test_a_row_that_misses_its_accuracy_and_the_price_of_a_digit() -> None:
    exact = [CostRow("f", f"1e-{n}", 1, 10.0**-n, None, 1.1**n, accuracy=10.0**-n) for n in (3, 6, 9)]
    assert rows.price_of_a_digit(exact) == pytest.approx(1.1)
    assert math.isnan(rows.price_of_a_digit(exact[:1]))
    assert [row.misses for row in (*exact, replace(exact[0], error=2e-3), replace(exact[0], error=math.nan))] == [
        False, False, False, True, True,
    ]  # fmt: skip


def test_ranges_are_those_of_the_options_the_distributions_or_the_strength() -> None:
    scene: Scene[Any] = load("vaiont")
    given, together = scenes._ranges(scene, {"friction.angle_deg": (6.0, 20.0)})
    assert given == {"friction": pytest.approx(tuple(np.tan(np.radians([6.0, 20.0]))))}
    assert not together
    normal = {"distribution": "normal", "mean": 1500.0, "std": 10.0}
    drawn, _ = scenes._ranges(replace(scene, uncertain={"arc.radius_m": normal}), {})
    assert drawn == {"radius": pytest.approx((1500 - 23.263479, 1500 + 23.263479))}
    default, together = scenes._ranges(scene, {})
    friction = float(np.asarray(scene.friction))
    assert default == {"friction": pytest.approx((0.8 * friction, 1.2 * friction))}
    assert together


def test_what_is_unknown_is_said(refused: Any, tmp_path: Path) -> None:
    told = refused("cost polar")
    assert "scene 'polar' is unknown; known are layered-slope, " in told
    assert "; kernels are polar_moment, " in told
    assert "nothing.toml: there is no such file" in refused("cost", tmp_path / "nothing.toml")
    assert "--accuracy 2: must be a relative error between 0 and 1" in refused("cost --accuracy 2")
    assert "--budget 1h: must be a time in ns, us, ms or s" in refused("cost --budget 1h")
    assert "--vary friction=1: must be KEY=FROM:TO" in refused("cost --vary friction=1")
    assert "polar_moment is a kernel" in refused("cost polar_moment --vary friction.angle_deg=6:20")
    endless = tmp_path / "endless.toml"
    endless.write_text("[arc]\nradius_m = 100\ntheta_1_deg = 215\ntheta_2_deg = 270\nunit_weight_kN_m3 = 20\n"
                       "[friction]\nangle_deg = 5\n", "utf-8")  # fmt: skip
    assert "endless: end_time_s: this slide never rests" in refused("cost", endless)
