"""Pictures and reports of uncertain scenes: what is drawn is the samples, and no text lies on another."""

import json
import re
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from slipcircle import Study, backanalyse, ensemble, load, solve
from slipcircle.base.text import PRINTED
from slipcircle.workbench.common.units import SYSTEMS
from slipcircle.workbench.outputs.pictures import plots, studyplots, tornado
from slipcircle.workbench.outputs.report import study_report
from slipcircle.workbench.outputs.tables import interval_text
from slipcircle.workbench.studies.ensemble import grid
from slipcircle.workbench.studies.statistics import Estimate
from tests.support.outputs import rows, tree
from tests.support.pictures import canvas, clashes, drawn, legend, motion

DEGREES = "friction.angle_deg"
ANGLE = {DEGREES: {"distribution": "normal", "mean": 24, "std": 2}}
WATER = {"pore_pressure.ratio": {"distribution": "triangular", "low": 0, "mode": 0.3, "high": 0.5}}
RADIUS = {"arc.radius_m": {"distribution": "uniform", "low": 30, "high": 50}}
CASES: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "two": (ANGLE | WATER, {"sensitivity": 64}),
    "three, Sobol": (ANGLE | WATER | RADIUS, {"method": "sobol", "n": 256, "sensitivity": 256}),
    "one": (ANGLE, {"n": 100}),
    "few": (ANGLE | WATER, {"n": 20, "sensitivity": 8}),
    "none moves": ({k: v | {"mean": 50} for k, v in ANGLE.items()} | RADIUS, {"n": 100, "sensitivity": 32}),
    "few move": ({k: v | {"mean": 33} for k, v in ANGLE.items()}, {"n": 500}),
}
each_case = pytest.mark.parametrize("name", CASES)


@cache
def found(name: str) -> Study:
    uncertain, more = CASES[name]
    return ensemble(replace(load("wet-slope"), uncertain=uncertain), rng=1, **({"n": 2000} | more))


def ticks(ax: Any) -> list[str]:
    return [t.get_text() for t in ax.get_yticklabels()]


WORDS = ("friction angle", "radius", "pore pressure ratio")


@pytest.mark.parametrize("name", ["three, Sobol", "few", "none moves"])
def test_no_text_lies_on_another(name: str) -> None:
    drawing = studyplots.study_overview(found(name))
    figure = drawing.draw(canvas(drawing.size, 60))
    assert clashes(figure) == []
    assert all(re.search(r"\((m|m/s|–)\)$", ax.get_xlabel()) for ax in figure.axes)


@pytest.mark.parametrize("output", ["run_out", "duration"])
def test_exceedance_counts_the_samples(output: str) -> None:
    e = found("two")
    ax, samples = studyplots.exceedance(e, output, drawn()), np.sort(e.samples[output])
    at, probability = ax.lines[0].get_data()
    assert (at[0], probability[0]) == (0.0, np.mean(samples > 0.0))
    assert np.allclose(probability[1:], np.mean(samples >= at[1:, None], axis=1), rtol=0.0, atol=1e-12)
    band = ax.collections[0].get_paths()[0].vertices
    assert 0.005 < band[:, 1].max() - probability.max() < 0.05  # of 2000 samples
    assert [float(line.get_xdata()[0]) for line in ax.lines[1:3]] == [samples[999], samples[1899]]


def test_what_is_rare_shows_on_a_logarithmic_axis() -> None:
    """The logarithmic axis shows the curve of the linear axis beside it."""
    figure = studyplots.study_overview(found("two")).draw(canvas())
    assert [ax.get_yscale() for ax in figure.axes] == [*["linear", "log"] * 2, "linear", "linear"]
    linear, log, *_ = figure.axes
    np.testing.assert_array_equal(linear.lines[0].get_ydata(), log.lines[0].get_ydata())
    assert log.get_ylim()[0] < 1 / 2000


def test_a_backanalysis_is_drawn_over_its_fields() -> None:
    """Curves that are single motions'; the observed line meets them at the solution."""
    back = backanalyse(load("vaiont"), run_out=(400.0, 20.0), duration=(40.0, 5.0), field=[DEGREES, "arc.radius_m"])
    figure = studyplots.explained(back).draw(canvas((11, 7), 60))
    assert clashes(figure) == []
    assert [ax.get_xlabel() for ax in figure.axes] == ["", "", "friction angle (deg)", "radius (m)"]
    for ax, field in zip(figure.axes, (DEGREES, "arc.radius_m"), strict=False):
        at, run_outs = (np.asarray(v) for v in ax.lines[0].get_data())
        others = {key: [value] for key, value in back.solutions[0].values.items()}
        study = grid(load("vaiont"), others | {field: [at[100]]})
        assert study.samples["run_out"] == pytest.approx([run_outs[100]], rel=1e-9)
        assert set(np.asarray(ax.lines[1].get_ydata())) == {400.0}


@pytest.mark.parametrize("command", ["plan vaiont --ladder", "sensitivity vaiont", "backanalyse vaiont --run-out-m 400",
                                     "sweep vaiont --grid friction.angle_deg=8:12:3"])  # fmt: skip
def test_a_command_draws_what_it_found(command: str, tmp_path: Path, said: Any, refused: Any) -> None:
    """Several times, if it is asked for that."""
    png, svg = tmp_path / "a.png", tmp_path / "a.svg"
    said(command, "--plot", svg, *(("--plot", png) if "plan" in command else ()))
    assert svg.read_bytes().count(b"<path") > 20
    assert "plan" not in command or png.read_bytes().startswith(b"\x89PNG")
    assert refused(command, "--plot", tmp_path / "none" / "a.svg")
    assert refused(command, "--plot", png, "--plot", png)


def test_indices_are_bars_with_errors() -> None:
    e = found("three, Sobol")
    ax = studyplots.indices(e, "run_out", drawn())
    order = [("friction angle", "pore pressure ratio", "radius").index(key.replace("\n", " ")) for key in ticks(ax)]
    first, total = ([each[k] for k in order] for each in e.sensitivity["run_out"])
    widths = [bar.get_width() for bar in ax.patches]
    assert widths == pytest.approx([*(max(i.value, 0.0) for i in first), *(i.value for i in total)])
    assert widths[3:] == sorted(widths[3:], reverse=True)
    errors = [np.ptp(seg[:, 0]) for c in ax.collections for seg in c.get_segments()]
    assert sorted(errors) == pytest.approx(sorted(i.high - i.low for i in (*first, *total)))


def bars(ax: Any) -> dict[str, float]:
    """Lengths of the bars by what is varied."""
    names = [re.sub(r" [\d.]+ ±.*", "", text) for text in ticks(ax)]
    return dict(zip(names, [patch.get_width() for patch in ax.patches], strict=False))


def test_tornado_is_what_a_small_change_does() -> None:
    """Bars equal differences of solutions; the largest bar is on top."""
    changes = {DEGREES: (24, 1e-3), "arc.radius_m": (40, 2e-3), "pore_pressure.ratio": (0.35, 1e-5)}
    m = motion("wet-slope")
    steps = {key: change for key, (_, change) in changes.items()}
    widths = bars(tornado.tornado(m.sensitivity(), "run_out", steps, drawn()))
    for (key, (at, change)), width in zip(changes.items(), map(widths.get, WORDS), strict=True):
        (other,) = grid(m.plan.scene, {key: [at + change]}, accuracy=1e-14).samples["run_out"]
        assert width == pytest.approx(other - m.run_out, rel=1e-3)
    assert [*map(abs, widths.values())] == sorted(map(abs, widths.values()), reverse=True)
    assert "does not move" in tornado.tornado(motion("still").sensitivity(), ax=drawn()).texts[0].get_text()
    ax = tornado.tornado(solve(load("real-slope")).sensitivity(), ax=drawn((9.0, 5.0)))
    assert len(ticks(ax)) == 9  # one of all points of the ground; gravity is not uncertain
    assert {"y of ground point 2 35 ± 0.0282 m", "radius 28.64 ± 0.0282 m"} <= {*ticks(ax)}
    assert not any("gravity" in text for text in ticks(ax))
    assert clashes(ax.figure) == []  # the legend beside the title
    token = PRINTED.set(SYSTEMS["US"])
    try:
        ax = tornado.tornado(solve(load("real-slope")).sensitivity(), ax=drawn())
    finally:
        PRINTED.reset(token)
    assert "cohesion 62.66 ± 0.627 psf" in ticks(ax)
    assert any(re.fullmatch(r"y of ground point 2 114\.8 ± 0\.092\d* ft", text) for text in ticks(ax))


def test_tornado_compares_equals() -> None:
    """Standard deviations of what the scene says is uncertain, and nothing else."""
    ax = tornado.tornado(solve(replace(load("wet-slope"), uncertain=ANGLE | RADIUS)).sensitivity(), ax=drawn())
    assert {*ticks(ax)} == {"friction angle 24 ± 2 deg", "radius 40 ± 5.77 m"}
    assert "by a standard deviation of each" in ax.get_xlabel()


def test_what_cannot_be_drawn_is_refused() -> None:
    table, curves = motion("wet-slope").sensitivity(), grid(load("vaiont"), {DEGREES: [10.0, 12.0]})
    with pytest.raises(ValueError, match=r"changes = 'friction': must be one of friction\.angle_deg"):
        tornado.tornado(table, "run_out", {"friction": 0.1})
    with pytest.raises(ValueError, match="output = 'speed': must be one of peak_velocity, run_out, duration"):
        tornado.tornado(table, "speed")
    with pytest.raises(ValueError, match="probabilities need samples of uncertain numbers"):
        studyplots.exceedance(curves)
    with pytest.raises(ValueError, match="two uncertain numbers"):
        studyplots.indices(found("one"))
    with pytest.raises(ValueError, match="not samples"):
        studyplots.response(found("two"))


def test_shaking_is_drawn_as_given() -> None:
    ax = plots.shaking(motion("vaiont-shaken"), drawn())
    for line, amplitude in zip(ax.lines, (0.15, 0.05), strict=False):
        t, k = line.get_data()
        assert np.allclose(k, np.where(t < 10.0, amplitude * np.sin(2 * np.pi * t), 0.0), atol=1e-12)
        assert np.max(k) == pytest.approx(amplitude)  # every crest is there
    assert "not shaken" in plots.shaking(motion("vaiont"), drawn()).texts[0].get_text()


def test_a_grid_is_drawn_as_curves() -> None:
    """A curve of the study's results for each radius."""
    radii = [1000.0, 1492.6]
    e = grid(load("vaiont"), {DEGREES: [9.0, 12.0, 15.0], "arc.radius_m": radii})
    drawing = studyplots.study_overview(e)
    figure = drawing.draw(canvas(drawing.size, 60))
    assert clashes(figure) == []
    assert [ax.get_ylabel() for ax in figure.axes] == ["run-out along the arc (m)", "peak velocity (m/s)"]
    for ax, output in zip(figure.axes, ("run_out", "peak_velocity"), strict=True):
        curves = [np.asarray(line.get_ydata()) for line in ax.lines]
        np.testing.assert_array_equal(np.transpose(curves), e.samples[output].reshape(3, 2))
        assert set(legend(ax)) == {f"radius {r:.4g} m" for r in radii}


def test_a_grid_of_any_size_is_a_map() -> None:
    """Cells are at their numbers, darkest at the greatest output; few values give curves."""
    angles, radii = np.linspace(12.0, 8.0, 9), np.linspace(1e3, 2e3, 10)
    study = grid(load("vaiont"), {DEGREES: angles, "arc.radius_m": radii})
    ax = studyplots.response(study, "run_out", drawn())
    cells = ax.collections[0]
    assert np.array_equal(cells.get_array(), study.samples["run_out"].reshape(9, 10).T[:, ::-1])
    low, high = (sum(cells.get_cmap()(x)[:3]) for x in (0.0, 1.0))
    assert high < 0.5 * low
    ax = studyplots.response(grid(load("vaiont"), {DEGREES: [10.0, 12.0], "arc.radius_m": radii}), ax=drawn())
    assert set(legend(ax)) == {"friction angle 10 deg", "friction angle 12 deg"}


@pytest.mark.usefixtures("unseen")
def test_one_command_writes_everything(tmp_path: Path, records: Any) -> None:
    """The printed command repeats it to the last bit."""
    page = tmp_path / "s.html"
    line = ("sweep wet-slope --samples 300 --uncertain friction.angle_deg=normal:24:2 --uncertain "
            "pore_pressure.ratio=uniform:0.1:0.4 --sensitivity 64")  # fmt: skip
    (record,) = records(line, "--report", page)
    root = tree(page.read_text("utf-8"))
    cells, quantiles = rows(root), {e["p"]: e for e in record["outputs"]["duration"]["quantiles"]}
    for name, e in (("probability of moving", record["moving"]), ("0.05", quantiles[0.95])):
        assert cells[name].text == interval_text(Estimate(e["value"], e["low"], e["high"]))
    folded = {d.find("summary").text: d.find("pre").text for d in root.iter("details")}
    assert json.loads(folded["All numbers, as JSON"]) == record
    (command,) = (pre.text for pre in root.iter("pre") if pre.text.startswith("slipcircle sweep"))
    assert records(command.removeprefix("slipcircle ").replace("--json", "")) == [record]


@each_case
@pytest.mark.usefixtures("unseen")
def test_every_study_has_a_report(name: str) -> None:
    text = study_report(found(name), b"", "slipcircle sweep")
    assert tree(text) is not None
    assert ("Sensitivity indices" in text) == (len(CASES[name][0]) > 1)


@pytest.mark.parametrize(
    ("more", "told"),
    [("--grid friction.angle_deg=8:12:3 --report {}/a.html", "--report: is available for samples, not for a grid"),
     ("--grid friction.angle_deg=8:12:3 --grid arc.radius_m=1e3:2e3:7 --grid end_time_s=1:2:2 --plot {}/a.png",
      "not 3 x 7 x 2")],
)  # fmt: skip
def test_what_cannot_be_written_is_said_before_the_work(
    more: str, told: str, tmp_path: Path, refused: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("slipcircle.workbench.commands.sweep._compute", lambda *_: pytest.fail("computed"))
    assert told in refused("sweep vaiont", more.replace("{}", str(tmp_path)))
    assert not list(tmp_path.iterdir())
