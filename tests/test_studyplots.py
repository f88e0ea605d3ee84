"""Pictures and reports of uncertain scenes: what is drawn is the samples, and no text lies on another."""

import json
import re
import shlex
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from slipcircle import Study, backanalyse, ensemble, load, solve
from slipcircle.workbench.outputs import plots, studyplots, tornado
from slipcircle.workbench.outputs.report import study_report
from slipcircle.workbench.studies.ensemble import grid
from tests.support.outputs import rows, tree
from tests.support.pictures import canvas, clashes, drawn, legend, motion

ANGLE = {"friction.angle_deg": {"distribution": "normal", "mean": 24, "std": 2}}
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


@pytest.mark.parametrize("name", ["three, Sobol", "few", "none moves"])
def test_no_text_lies_on_another(name: str) -> None:
    figure = canvas(studyplots.size(found(name)), 60)
    assert studyplots.overview(found(name), figure) is figure
    assert clashes(figure) == []
    assert all(re.search(r"\((m|m/s|–)\)$", ax.get_xlabel()) for ax in figure.axes)


@pytest.mark.parametrize("output", ["run_out", "peak_velocity", "duration"])
def test_exceedance_counts_the_samples(output: str) -> None:
    e, ax = found("two"), drawn()
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
    few = found("few move")
    assert 0.0 < few.moving.value < 0.5
    said = legend(studyplots.exceedance(few, ax=drawn()))
    assert not any(s.startswith("median") for s in said)
    figure = canvas(studyplots.size(e))
    studyplots.overview(e, figure)
    assert [ax.get_yscale() for ax in figure.axes] == ["linear", "log", "linear", "linear", "log", "linear"]


def test_a_backanalysis_is_drawn_over_its_fields() -> None:
    """Curves that are single motions'; the observed line meets them at the solution, and its error is a band."""
    scene = load("vaiont")
    back = backanalyse(scene, run_out=(400.0, 20.0), duration=(40.0, 5.0), field=["friction.angle_deg", "arc.radius_m"])
    figure = canvas((11, 7), 60)
    studyplots.explained(back, figure)
    assert clashes(figure) == []
    assert [ax.get_xlabel() for ax in figure.axes] == ["", "", "friction angle (deg)", "radius (m)"]
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
    assert len(studyplots.explained(one, canvas()).axes) == 1


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
    keys = ticks(ax)
    of = {"friction angle": 0, "pore pressure ratio": 1, "radius": 2}
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
    """Beside differences of solutions, which are the motion's own; a coordinate changes by metres."""
    small = {"friction.angle_deg": 1e-3, "arc.radius_m": 2e-3, "pore_pressure.ratio": 1e-5}
    at = {"friction.angle_deg": 24.001, "arc.radius_m": 40.002, "pore_pressure.ratio": 0.35001}
    words = {
        "friction.angle_deg": "friction angle",
        "arc.radius_m": "radius",
        "pore_pressure.ratio": "pore pressure ratio",
    }
    m = motion("wet-slope")
    found = m.sensitivity()
    ax = tornado.tornado(found, "run_out", small, drawn())
    bars = dict(
        zip([re.sub(r" [\d.]+ ±.*", "", x) for x in ticks(ax)], [p.get_width() for p in ax.patches], strict=False)
    )
    for key, value in at.items():
        (other,) = grid(m.plan.scene, {key: [value]}, accuracy=1e-14).samples["run_out"]
        assert bars[words[key]] == pytest.approx(other - m.run_out, rel=1e-3)
    assert [*map(abs, bars.values())] == sorted(map(abs, bars.values()), reverse=True)
    assert "cohesion 3 ± 0.03 kPa" in ticks(tornado.tornado(found, ax=drawn()))
    with pytest.raises(ValueError, match=r"changes = 'friction': must be one of friction\.angle_deg"):
        tornado.tornado(found, "run_out", {"friction": 0.1})
    with pytest.raises(ValueError, match="output = 'speed': must be one of peak_velocity, run_out, duration, reach"):
        tornado.tornado(found, "speed")
    assert "does not move" in tornado.tornado(motion("still").sensitivity(), ax=drawn()).texts[0].get_text()
    ax = tornado.tornado(solve(load("real-slope")).sensitivity(), ax=drawn())
    names = ticks(ax)
    assert len(names) == 10
    assert "3 more numbers change it by at most" in ax.get_xlabel()
    assert {"y of ground point 2 35 ± 0.0282 m", "radius 28.64 ± 0.0282 m"} <= {*names}


def test_tornado_compares_equals() -> None:
    """Standard deviations of what the scene says is uncertain, and nothing else; without them 1 % of each number."""
    scene = replace(load("wet-slope"), uncertain=ANGLE | RADIUS)
    ax = tornado.tornado(solve(scene).sensitivity(), ax=drawn())
    assert {*ticks(ax)} == {"friction angle 24 ± 2 deg", "radius 40 ± 5.77 m"}
    assert "by a standard deviation of each" in ax.get_xlabel()
    table = motion("vaiont").sensitivity()
    ax = tornado.tornado(table, ax=drawn())
    bars = dict(
        zip([re.sub(r" [\d.]+ ±.*", "", x) for x in ticks(ax)], [abs(p.get_width()) for p in ax.patches], strict=False)
    )
    mu = table.at["friction"]
    angle = 0.01 * np.arctan(mu) * (1 + mu**2)
    assert bars["friction angle"] == pytest.approx(abs(table.derivative("run_out", "friction")) * angle)
    assert bars["radius"] == pytest.approx(0.01 * abs(table.derivative("run_out", "radius")) * table.at["radius"])
    assert "theta 1 215.2 ± 0.308 deg" in ticks(ax)


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


def test_a_grid_is_drawn_as_curves() -> None:
    """A curve for each radius, each scene of it solved on its own."""
    scene, angles, radii = load("vaiont"), [9.0, 12.0, 15.0], [1000.0, 1492.6]
    e = grid(scene, {"friction.angle_deg": angles, "arc.radius_m": radii})
    figure = canvas(studyplots.size(e), 60)
    studyplots.overview(e, figure)
    assert clashes(figure) == []
    assert [ax.get_ylabel() for ax in figure.axes] == ["greatest displacement (m)", "peak velocity (m/s)"]
    for radius, *lines in zip(radii, *(ax.lines for ax in figure.axes), strict=True):
        drawn_at = [np.asarray(line.get_ydata()).tolist() for line in lines]
        for angle, reach, velocity in zip(angles, *drawn_at, strict=True):
            slide = replace(scene, arc=replace(scene.arc, radius=radius), friction=float(np.tan(np.deg2rad(angle))))
            m = solve(slide)
            assert [reach, velocity] == pytest.approx([m.reach.displacement, float(m.peak.velocity)], rel=1e-9)
    assert all(set(legend(ax)) == {f"radius {r:.4g} m" for r in radii} for ax in figure.axes)
    with pytest.raises(ValueError, match="not samples"):
        studyplots.response(found("two"))


def test_a_grid_of_any_size_is_a_map() -> None:
    """Each cell where its numbers are, darkest where the output is greatest; of few values curves, whichever way."""
    angles, radii = np.linspace(12.0, 8.0, 9), np.linspace(1e3, 2e3, 10)
    study = grid(load("vaiont"), {"friction.angle_deg": angles, "arc.radius_m": radii})
    ax = studyplots.response(study, "run_out", drawn())
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("friction angle (deg)", "radius (m)")
    cells = ax.collections[0]
    assert np.array_equal(cells.get_array(), study.samples["run_out"].reshape(9, 10).T[:, ::-1])
    low, high = (sum(cells.get_cmap()(x)[:3]) for x in (0.0, 1.0))
    assert high < 0.5 * low
    few = grid(load("vaiont"), {"friction.angle_deg": [10.0, 12.0], "arc.radius_m": radii})
    ax = studyplots.response(few, "run_out", drawn())
    assert ax.get_xlabel() == "radius (m)"
    assert set(legend(ax)) == {"friction angle 10 deg", "friction angle 12 deg"}


def test_one_command_writes_everything(tmp_path: Path, records: Any) -> None:
    plot, page = tmp_path / "s.png", tmp_path / "s.html"
    line = ("sweep wet-slope --samples 300 --uncertain friction.angle_deg=normal:24:2 --uncertain "
            "pore_pressure.ratio=uniform:0.1:0.4 --sensitivity 64")  # fmt: skip
    (record,) = records(line, "--plot", plot, "--report", page)
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
    # The printed command repeats it to the last bit; its files are the same, and not asked for again.
    line = command.replace(f"--plot {plot}", "").replace(f"--report {page}", "")
    assert records(line.removeprefix("slipcircle ").replace("--json", "")) == [record]
    assert page.read_text("utf-8").count("distribution") > 1
    assert all(i.get("src").startswith("data:image/svg+xml") for i in root.iter("img"))


@each_case
@pytest.mark.usefixtures("unseen")
def test_every_study_has_a_report(name: str) -> None:
    text = study_report(found(name))
    assert tree(text) is not None
    assert ("Sensitivity indices" in text) == (len(CASES[name][0]) > 1)


@pytest.mark.parametrize(
    ("more", "told"),
    [("--grid friction.angle_deg=8:12:3 --report {}/a.html", "--report: of samples, not of a grid"),
     ("--grid friction.angle_deg=8:12:3 --grid arc.radius_m=1e3:2e3:7 --grid end_time_s=1:2:2 --plot {}/a.png",
      "not 3 x 7 x 2")],
)  # fmt: skip
def test_what_cannot_be_written_is_said_before_the_work(
    more: str, told: str, tmp_path: Path, refused: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("slipcircle.workbench.commands.sweep._compute", lambda *_: pytest.fail("computed"))
    assert told in refused("sweep vaiont", more.replace("{}", str(tmp_path)))
    assert not list(tmp_path.iterdir())
