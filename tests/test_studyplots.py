"""Pictures and reports of uncertain scenes: what is drawn is the samples, and no text lies on another."""

import json
import re
import shlex
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from test_plots import clashes, drawn, motion
from test_report import rows, tree

from slipcircle import Study, backanalyse, ensemble, load, solve
from slipcircle.__main__ import main
from slipcircle.outputs import plots, studyplots
from slipcircle.outputs.studyreport import study_report
from slipcircle.studies.conduct import grid

matplotlib.use("agg")

ANGLE = {"friction.angle_deg": {"distribution": "normal", "mean": 24, "std": 2}}
WATER = {"pore_pressure.ratio": {"distribution": "triangular", "low": 0, "mode": 0.3, "high": 0.5}}
RADIUS = {"arc.radius_m": {"distribution": "uniform", "low": 30, "high": 50}}
CASES: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "two": (ANGLE | WATER, {}),
    "three, Sobol": (ANGLE | WATER | RADIUS, {"method": "sobol"}),
    "one": (ANGLE, {}),
    "few": (ANGLE | WATER, {"n": 20, "sensitivity": 8}),
    "none moves": ({k: v | {"mean": 50} for k, v in ANGLE.items()} | RADIUS, {}),
}
each_case = pytest.mark.parametrize("name", CASES)


@cache
def found(name: str) -> Study:
    uncertain, more = CASES[name]
    return ensemble(replace(load("wet-slope"), uncertain=uncertain), rng=1, **({"n": 2000} | more))


@each_case
def test_no_text_lies_on_another(name: str) -> None:
    figure = Figure(figsize=studyplots.size(found(name)), dpi=60, layout="constrained")
    FigureCanvasAgg(figure)
    assert studyplots.overview(found(name), figure) is figure
    assert clashes(figure) == []
    assert all(re.search(r"\((m|m/s|–)\)$", ax.get_xlabel()) for ax in figure.axes)


@pytest.mark.parametrize("output", ["run_out", "peak_velocity", "duration"])
@pytest.mark.parametrize("name", ["two", "three, Sobol"])
def test_exceedance_counts_the_samples(name: str, output: str) -> None:
    e, ax = found(name), drawn()
    assert studyplots.exceedance(e, output, ax) is ax
    at, probability = ax.lines[0].get_data()
    assert at[0] == 0.0
    assert probability[0] == np.mean(e.samples[output] > 0.0)
    counted = [np.mean(e.samples[output] >= x) for x in at[1:]]
    assert np.allclose(probability[1:], counted, rtol=0.0, atol=1e-12)
    band = ax.collections[0].get_paths()[0].vertices
    assert band[:, 1].min() < probability.min() + 0.01
    assert 0.005 < band[:, 1].max() - probability.max() < 0.05  # of 2000 samples
    median, rare = (line for line in ax.lines[1:3])
    assert float(median.get_xdata()[0]) == np.sort(e.samples[output])[999]
    assert float(rare.get_xdata()[0]) == np.sort(e.samples[output])[1899]


def test_what_is_rare_shows_on_a_logarithmic_axis() -> None:
    """Beside the linear one, with the same curve."""
    e, linear, log = found("two"), drawn(), drawn()
    studyplots.exceedance(e, "reach", linear)
    studyplots.exceedance(e, "reach", log, rare=True)
    assert (linear.get_yscale(), log.get_yscale()) == ("linear", "log")
    np.testing.assert_array_equal(linear.lines[0].get_ydata(), log.lines[0].get_ydata())
    assert log.get_ylim()[0] < 1 / e.n
    figure = Figure(figsize=studyplots.size(e), layout="constrained")
    studyplots.overview(e, figure)
    assert [ax.get_yscale() for ax in figure.axes] == ["linear", "log", "linear", "linear", "log", "linear"]


def test_a_backanalysis_is_drawn_over_its_fields() -> None:
    """Curves that are single motions'; the observed line meets them at the solution, and its error is a band."""
    scene = load("vaiont")
    back = backanalyse(scene, run_out=(400.0, 20.0), duration=(40.0, 5.0), field=["friction.angle_deg", "arc.radius_m"])
    figure = Figure(figsize=(11, 7), dpi=60, layout="constrained")
    FigureCanvasAgg(figure)
    studyplots.explained(back, figure)
    assert clashes(figure) == []
    assert [ax.get_xlabel() for ax in figure.axes] == ["", "", "friction.angle_deg", "arc.radius_m"]
    run_out, by_radius = figure.axes[:2]
    at, values = (np.asarray(v) for v in run_out.lines[0].get_data())
    radius = back.solutions[0].values["arc.radius_m"]
    for k in (0, 100, 300):
        slide = replace(scene, arc=replace(scene.arc, radius=radius), friction=float(np.tan(np.deg2rad(at[k]))))
        assert values[k] == pytest.approx(solve(slide).run_out, rel=1e-9)
    radii, reached = (np.asarray(v) for v in by_radius.lines[0].get_data())
    assert np.interp(radius, radii, reached) == pytest.approx(400.0, abs=0.1)
    assert set(np.asarray(run_out.lines[1].get_ydata())) == {400.0}
    one = backanalyse(scene, run_out=400.0)
    assert len(studyplots.explained(one, Figure(layout="constrained")).axes) == 1


@pytest.mark.parametrize(
    "command",
    [["plan", "vaiont", "--ladder"], ["sensitivity", "vaiont"], ["backanalyse", "vaiont", "--run-out-m", "400"]],
    ids=lambda c: c[0],
)
def test_a_command_draws_what_it_found(command: list[str], tmp_path: Path) -> None:
    assert main([*command, "--plot", str(tmp_path / "a.svg")]) == 0
    assert (tmp_path / "a.svg").read_bytes().count(b"<path") > 20
    assert main([*command, "--plot", str(tmp_path / "none" / "a.svg")]) == 1


def test_several_pictures_of_one_command(tmp_path: Path) -> None:
    names = [str(tmp_path / f"a.{kind}") for kind in ("png", "svg")]
    plots_asked = [word for name in names for word in ("--plot", name)]
    assert main(["run", "newmark-pulse", *plots_asked]) == 0
    assert main(["sweep", "vaiont", "--grid", "friction.angle_deg=8:12:3", *plots_asked]) == 0
    assert [Path(n).read_bytes()[1:4] for n in names] == [b"PNG", b"?xm"]
    assert main(["run", "newmark-pulse", "--plot", names[0], "--plot", names[0]]) == 1


def test_what_does_not_move_has_no_median() -> None:
    e = ensemble(replace(load("wet-slope"), uncertain={k: v | {"mean": 33} for k, v in ANGLE.items()}), 500, 1)
    assert 0.0 < e.moving.value < 0.5
    said = [t.get_text() for t in studyplots.exceedance(e, ax=drawn()).get_legend().get_texts()]
    assert not any(s.startswith("median") for s in said)


def test_indices_are_bars_with_errors() -> None:
    e = found("three, Sobol")
    ax = studyplots.indices(e, "run_out", drawn())
    keys = [t.get_text() for t in ax.get_yticklabels()]
    of = {u.key: k for k, u in enumerate(e.design.inputs.values())}
    assert set(keys) == set(of)
    first, total = e.sensitivity["run_out"]
    widths = [bar.get_width() for bar in ax.patches]
    assert widths[:3] == pytest.approx([max(first[of[k]].value, 0.0) for k in keys])
    assert widths[3:] == pytest.approx([total[of[k]].value for k in keys])
    assert widths[3:] == sorted(widths[3:], reverse=True)
    ends = [seg[:, 0] for c in ax.collections for seg in c.get_segments()]
    assert np.allclose(sorted(x[1] - x[0] for x in ends), sorted(i.high - i.low for i in (*first, *total)))
    with pytest.raises(ValueError, match="two uncertain numbers"):
        studyplots.indices(found("one"))


def test_tornado_is_what_a_small_change_does() -> None:
    """Beside differences of solutions, which are the motion's own."""
    m, small = motion("wet-slope"), {"friction.angle_deg": 1e-3, "arc.radius_m": 2e-3, "pore_pressure.ratio": 1e-5}
    ax = studyplots.tornado(m.sensitivity(), "run_out", small, drawn())
    bars = {
        t.get_text().partition(" = ")[0]: p.get_width() for t, p in zip(ax.get_yticklabels(), ax.patches, strict=False)
    }
    scene = m.plan.scene
    angle = solve(replace(scene, friction=float(np.tan(np.deg2rad(24.001)))))
    radius = solve(replace(scene, arc=replace(scene.arc, radius=40.002)))
    water = solve(replace(scene, effects={**scene.called, "pore_pressure": {"ratio": 0.35001}}))
    for key, other in zip(small, (angle, radius, water), strict=True):
        assert bars[key] == pytest.approx(other.run_out - m.run_out, rel=1e-3)
    assert [abs(b) for b in bars.values()] == sorted((abs(b) for b in bars.values()), reverse=True)
    assert "cohesion.cohesion_kPa = 3 ± 1 %" in [
        t.get_text() for t in studyplots.tornado(m.sensitivity(), ax=drawn()).get_yticklabels()
    ]
    with pytest.raises(ValueError, match=r"changes = 'friction': must be one of friction\.angle_deg"):
        studyplots.tornado(m.sensitivity(), "run_out", {"friction": 0.1})
    assert "does not move" in studyplots.tornado(motion("still").sensitivity(), ax=drawn()).texts[0].get_text()


def test_a_coordinate_changes_by_metres_wherever_its_origin_is() -> None:
    ax = studyplots.tornado(solve(load("real-slope")).sensitivity(), ax=drawn())
    words = [label.get_text() for label in ax.get_yticklabels()]
    assert "ground.points_m.2.y = 35 ± 0.1" in words
    assert "circle.radius_m = 28.64 ± 1 %" in words


def test_shaking_is_drawn_as_given() -> None:
    ax = plots.shaking(motion("vaiont-shaken"), drawn())
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("time $t$ (s)", "shaking over $g$ (–)")
    for line, amplitude in zip(ax.lines, (0.15, 0.05), strict=False):
        t, k = line.get_data()
        assert np.allclose(k, np.where(t < 10.0, amplitude * np.sin(2 * np.pi * t), 0.0), atol=1e-12)
        assert np.max(k) == pytest.approx(amplitude)  # every crest is there
    still = plots.shaking(motion("shaken still"), drawn())
    assert np.max(still.lines[0].get_ydata()) == 0.1 < still.lines[1].get_ydata()[0]
    assert "not shaken" in plots.shaking(motion("vaiont"), drawn()).texts[0].get_text()


def test_a_grid_has_no_probability() -> None:
    e = grid(load("vaiont"), {"friction.angle_deg": [10.0, 12.0]})
    for draw in (studyplots.exceedance, studyplots.indices):
        with pytest.raises(ValueError, match="values on a grid have no probability"):
            draw(e)
    with pytest.raises(ValueError, match="output = 'speed': must be one of reach, run_out, peak_velocity, duration"):
        studyplots.exceedance(found("two"), "speed")


def test_a_grid_is_drawn_as_curves() -> None:
    """A curve for each radius, each scene of it solved on its own."""
    scene, angles, radii = load("vaiont"), [9.0, 12.0, 15.0], [1000.0, 1492.6]
    e = grid(scene, {"friction.angle_deg": angles, "arc.radius_m": radii})
    figure = Figure(figsize=studyplots.size(e), dpi=60, layout="constrained")
    FigureCanvasAgg(figure)
    studyplots.overview(e, figure)
    assert clashes(figure) == []
    assert [ax.get_ylabel() for ax in figure.axes] == ["greatest displacement (m)", "peak velocity (m/s)"]
    for radius, *lines in zip(radii, *(ax.lines for ax in figure.axes), strict=True):
        drawn_at = [np.asarray(line.get_ydata()).tolist() for line in lines]
        for angle, reach, velocity in zip(angles, *drawn_at, strict=True):
            slide = replace(scene, arc=replace(scene.arc, radius=radius), friction=float(np.tan(np.deg2rad(angle))))
            m = solve(slide)
            assert [reach, velocity] == pytest.approx([m.reach.displacement, float(m.peak.velocity)], rel=1e-9)
    (names,) = {tuple(t.get_text() for t in ax.get_legend().get_texts()) for ax in figure.axes}  # type: ignore[union-attr]
    assert list(names) == [f"arc.radius_m = {r:.4g}" for r in radii]
    with pytest.raises(ValueError, match="with at most 6 values of the second, not 1 x 7"):
        studyplots.response(grid(scene, {"friction.angle_deg": [10.0], "arc.radius_m": np.linspace(1e3, 2e3, 7)}))
    with pytest.raises(ValueError, match="not samples"):
        studyplots.response(found("two"))


# --- reports and the command ---------------------------------------------------------------------------------------


def test_one_command_writes_everything(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plot, page = tmp_path / "s.png", tmp_path / "s.html"
    line = ["sweep", "wet-slope", "--samples", "300", "--uncertain", "friction.angle_deg=normal:24:2", "--uncertain",
            "pore_pressure.ratio=uniform:0.1:0.4", "--sensitivity", "64", "--plot", str(plot)]  # fmt: skip
    assert main([*line, "--report", str(page), "--json"]) == 0
    (record,) = json.loads(capsys.readouterr().out)
    assert plot.read_bytes().startswith(b"\x89PNG\r\n")
    root = tree(page.read_text("utf-8"))
    cells = rows(root)
    assert float(cells["probability of moving"][0].get("value")) == record["moving"]["value"]
    assert cells["seed"].text == str(record["seed"])
    values = {e["p"]: e["value"] for e in record["outputs"]["duration"]["quantiles"]}
    assert float(cells["0.05"][0].get("value")) == values[0.95]
    folded = {d.find("summary").text: d.find("pre").text for d in root.iter("details")}
    assert json.loads(folded["All numbers, as JSON"]) == record
    (command,) = (pre.text for pre in root.iter("pre") if pre.text.startswith("slipcircle sweep"))
    assert shlex.split(command)[-2:] == ["--seed", str(record["seed"])]
    # The printed command repeats it to the last bit.
    assert main(shlex.split(command)[1:]) == 0
    assert json.loads(capsys.readouterr().out) == [record]
    assert page.read_text("utf-8").count("distribution") > 1
    assert all(i.get("src").startswith("data:image/svg+xml") for i in root.iter("img"))


@each_case
def test_every_study_has_a_report(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("slipcircle.outputs.pictures.render", lambda *_: b"<svg xmlns='http://www.w3.org/2000/svg'/>")
    text = study_report(found(name))
    assert tree(text) is not None
    assert ("Which unknown matters" in text) == (len(CASES[name][0]) > 1)


@pytest.mark.parametrize(
    ("more", "said"),
    [(["--grid", "friction.angle_deg=8:12:3", "--report", "{}/a.html"], "--report: of samples, not of a grid"),
     (["--grid", "friction.angle_deg=8:12:3", "--grid", "arc.radius_m=1000:2000:7", "--plot", "{}/a.png"], "not 3 x 7"),
     (["--samples", "9", "--plot", "{}/a.gif"], "must end in one of .png, .svg, .pdf, .jpg"),
     (["--samples", "9", "--report", "{}/none/a.html"], "--report {}/none/a.html: there is no folder {}/none")],
)  # fmt: skip
def test_what_cannot_be_written_is_said_before_the_work(
    more: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("slipcircle.outputs.sweep._compute", lambda *_: pytest.fail("computed"))
    assert main(["sweep", "vaiont", *(m.replace("{}", str(tmp_path)) for m in more)]) == 1
    assert said.replace("{}", str(tmp_path)) in capsys.readouterr().err
    assert not list(tmp_path.iterdir())
