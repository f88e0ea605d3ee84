"""Files that `run` writes: the report says what the JSON says, needs nothing else, and nothing is half written."""

import base64
import hashlib
import json
import os
import re
import shlex
from collections import Counter
from copy import copy
from dataclasses import replace
from functools import cache
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from scipy import stats

from slipcircle import Motion, Scene, Status, ensemble, load, solve
from slipcircle.workbench.common import files
from slipcircle.workbench.common.quantities import prefixed
from slipcircle.workbench.files.shipped import find
from slipcircle.workbench.outputs.info import facts
from slipcircle.workbench.outputs.json_records import record as record_of
from slipcircle.workbench.outputs.pictures import files as pictures
from slipcircle.workbench.outputs.provenance import scene_inputs, toml_comments
from slipcircle.workbench.outputs.report import _energy, report, study_report
from slipcircle.workbench.outputs.tables import cell_text, interval_text
from slipcircle.workbench.studies import export
from tests.support.outputs import printed, rows, tree, words_of

COMMAND = "slipcircle run wet-slope --report report.html"


@cache
def motion(name: str) -> Motion:
    return solve(load(name))


@cache
def page() -> str:
    return report([motion("wet-slope")], [find("wet-slope").read_bytes()], COMMAND)


# --- the page ------------------------------------------------------------------------------------------------------


def test_numbers_are_those_of_the_json() -> None:
    """The report's JSON is complete; its tables equal `run --verbose`, which `test_printed_motions` checks."""
    m, cells = motion("wet-slope"), rows(tree(page()))
    record = json.loads(json.dumps(record_of(m), allow_nan=False))
    assert {label: cells[label].text for label in printed(m)} == printed(m)
    for label, key in (("work of gravity", "work"), ("kinetic energy at the end", "kinetic_end")):
        number, unit = str(cells[label].text).split(" ")
        factor, known = prefixed(record["energy"][key], "J")
        assert float(number) == pytest.approx(factor * record["energy"][key], rel=1e-5)
        assert unit == f"{known}/m"
    folded = {d.find("summary").text: d.find("pre").text for d in tree(page()).iter("details")}
    folded_record = json.loads(folded["All numbers, as JSON in SI units and radians"])
    assert folded_record == {"format": "slipcircle-json-1"} | record
    assert folded["The scene's file"] == find("wet-slope").read_text("utf-8")


def test_every_energy_and_the_share_of_the_residual() -> None:
    """The residual is start + work - dissipation - end, also of a motion that loses energy."""
    energy = record_of(motion("wet-slope"))["energy"]
    for residual in (energy["residual"], -1e-3 * energy["work"]):
        known = energy | {"residual": residual}
        lossy = copy(motion("wet-slope"))
        lossy.__dict__["energy"] = SimpleNamespace(**known)
        part = _energy(lossy)
        order = ("kinetic_start", "work", "dissipation", "kinetic_end", "residual")
        for (_, text), name in zip(part.rows, order, strict=True):
            value, (number, unit) = known[name], text.split(" ")
            factor = {"J/m": 1.0, "kJ/m": 1e3, "MJ/m": 1e6, "GJ/m": 1e9, "TJ/m": 1e12}[unit]
            assert float(number) * factor == pytest.approx(value, rel=1e-5)
        largest = max(abs(value) for name, value in energy.items() if name != "residual")
        assert part.note == f"The residual is {abs(residual) / largest:.6g} of the largest of them."


@pytest.mark.usefixtures("unseen")
@pytest.mark.parametrize("method", ["monte-carlo", "sobol"])
def test_every_number_of_a_study_is_an_estimate_of_it(method: str) -> None:
    """Tables have the estimates of the study and its settings."""
    inputs = {"friction.angle_deg": stats.norm(10, 1), "arc.radius_m": stats.uniform(1400, 100)}
    study = ensemble(replace(load("vaiont"), uncertain=inputs), 512, 5, method=method, sensitivity=64)
    root = tree(study_report(study, b"[arc]\n", "slipcircle sweep scene.toml"))
    cells = ["".join(cell.itertext()) for cell in root.iter("td")]
    printed = Counter(cells)
    expected = Counter(
        cell_text(row.estimate.value) if row.table.startswith("linear") else interval_text(row.estimate)
        for row in export.estimates(study)
        if row.table != "exceedance"
    )
    assert expected <= printed
    facts = {"samples": f"512, {method}", "seed": "5", "samples of a block": str(study.size),
             "requested relative error of each solution": "1e-09",
             "friction.angle_deg": "scipy.stats.norm(10.0, 1.0)",
             "arc.radius_m": "scipy.stats.uniform(1400.0, 100.0)"}  # fmt: skip
    facts["samples by how they ended"] = ", ".join(f"{n} {Status(k).words}" for k, n in enumerate(study.counts) if n)
    rows_of_page = [["".join(cell.itertext()) for cell in row] for row in root.iter("tr")]
    assert [name for name, text in facts.items() if [name, text] not in rows_of_page] == []
    assert "slipcircle sweep scene.toml --seed 5" in [pre.text for pre in root.iter("pre")]


def test_it_says_what_is_assumed_and_how_to_repeat_it() -> None:
    root = tree(page())
    cells = {label: "".join(cell.itertext()) for label, cell in rows(root).items()}
    assumptions = " ".join(str(e.text) for e in root.iter("li"))
    assert "rigid" in assumptions
    assert "frozen" not in assumptions
    assert "Not included: drag, viscosity, shaking, thermal_pressurisation." in assumptions
    assert "Basic Geodynamics of Landslides: I. The Dynamic Slip Circle Method" in assumptions
    assert COMMAND in [pre.text for pre in root.iter("pre")]
    digest = hashlib.sha256(find("wet-slope").read_bytes()).hexdigest()
    expected = facts() | {"scene file of wet-slope": f"sha256 {digest}", "requested relative error": "1e-09"}
    assert cells | expected | {"method": motion("wet-slope").plan.method} == cells
    assert cells["arc.radius_m"] == "assumed"  # the source; number and unit before it
    assert cells["arc.unit_weight_kN_m3"] == "assumed, saturated clay"
    assert cells["arc.gravity_m_s2"] == "default"


def test_its_figures_are_whole_drawings() -> None:
    """Figures have alternative texts; the slide, the key numbers and the pictures precede the tables."""
    root = tree(page())
    images = {i.get("alt"): i.get("src").partition(",")[2] for i in root.iter("img")}
    assert list(images) == [f"{n} of wet-slope" for n in ("Section", "Histories", "Phase plane")]
    for source in images.values():
        drawing = ElementTree.fromstring(base64.b64decode(source, validate=True))
        assert len(list(drawing.iter("{http://www.w3.org/2000/svg}path"))) > 30
    order = [e.tag for e in root.find("body").iter() if e.tag in ("h1", "h2", "figure", "dl", "img", "table")]
    assert order[:4] == ["h1", "dl", "figure", "dl"]
    assert order.index("img") < order.index("table")


def test_inputs_of_a_file() -> None:
    """A law of speed that multiplies one of slip has its own keys; what is uncertain says how."""
    law = "law = 'linear'\npeak_deg = 15\nresidual_deg = 10\nlength_m = 2\n[friction.rate]\nlaw = 'rate_tabulated'\n"
    law += "speed_m_s = [0.1, 10]  # tests\ncoefficient = [1, 0.8]\n[shaking]\namplitude_g = 0.1"
    drawn = "radius_m = { distribution = 'normal', mean = 1490, std = 10 }  # the map"
    found = {i.path: i[1:] for i in scene_inputs(load("vaiont"), f"[arc]\n{drawn}\n[friction]\n{law}\n")}
    assert found["friction.rate.speed_m_s"] == ("0.1, 10.0", "m/s", "speeds of the table, increasing", "tests")
    assert found["friction.rate.coefficient"][2] == "friction coefficients at these speeds"
    assert found["friction.peak_deg"][1] == "deg"
    assert found["arc.radius_m"] == ("normal: mean 1490, std 10", "m", "radius of the slip circle", "the map")


@pytest.mark.usefixtures("unseen")
def test_uncertain_inputs_are_marked() -> None:
    drawn = {"friction.angle_deg": {"distribution": "normal", "mean": 10, "std": 1},
             "arc.radius_m": {"distribution": "uniform", "low": 1400, "high": 1500}}  # fmt: skip
    scene = replace(load("vaiont"), uncertain=drawn)
    file = "[arc]\nradius_m = 1492.6\n[friction]\nangle_deg = 10\n"
    shown = {i.path: i.value for i in scene_inputs(scene, file)}
    assert shown["friction.angle_deg"] == "uncertain, normal: mean 10, std 1"
    assert shown["arc.radius_m"] == "uncertain, uniform: low 1400, high 1500"
    text = report([solve(scene)], [file.encode()], COMMAND)
    assert "uncertain, normal" in text
    assert "at the median of friction.angle_deg" in text


@pytest.mark.usefixtures("unseen")
def test_the_date_of_a_report(monkeypatch: pytest.MonkeyPatch) -> None:
    """The day of 1e9 s, in UTC; what is no time is an error."""
    known = [motion("wet-slope")], [b"[report]\nproject = 'Dam 7'\n" + find("wet-slope").read_bytes()], COMMAND
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1000000000")
    assert "<dt>date</dt><dd>2001-09-09</dd></div><div><dt>project</dt><dd>Dam 7</dd>" in report(*known)
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "yesterday")
    with pytest.raises(ValueError, match="SOURCE_DATE_EPOCH: must be a time in seconds since 1970"):
        report(*known)


def test_comments_stand_beside_their_keys() -> None:
    found = toml_comments(
        'name = "a # b"  # the name\n[arc]  # Table 2-1\nradius_m = 40\ntheta_1_deg=210# one\n'
        'slip_m = [1, 2] # list\nnote = \'x # y\'\nwhat = "\\" # no" # yes\n[arc.given] # given\nlambda = 1 # two\n'
    )
    assert found == {
        "name": "the name", "arc": "Table 2-1", "arc.theta_1_deg": "one", "arc.slip_m": "list", "arc.what": "yes",
        "arc.given": "given", "arc.given.lambda": "two",
    }  # fmt: skip


# --- the command ---------------------------------------------------------------------------------------------------


def test_one_command_writes_everything(tmp_path: Path, asked: Any) -> None:
    written = {f"--{kind}": tmp_path / f"my {name}" for kind, name in
               {"plot": "motion.png", "report": "report.html", "csv": "motion.csv"}.items()}  # fmt: skip
    _, out, err = asked("run wet-slope", *(part for option in written.items() for part in option), "--json")
    (record,) = json.loads(out)
    assert sorted(err.splitlines()) == sorted(f"slipcircle: wrote {path}" for path in written.values())
    plot, page, table = written.values()
    assert plot.read_bytes().startswith(b"\x89PNG\r\n")
    root = tree(page.read_text("utf-8"))
    assert rows(root)["peak velocity"].text == printed(motion("wet-slope"))["peak velocity"]
    (command,) = (pre.text for pre in root.iter("pre") if pre.text.startswith("slipcircle run"))
    given = [str(part) for option in written.items() for part in option]
    assert shlex.split(command) == ["slipcircle", "run", "wet-slope", *given, "--json"]
    values = np.genfromtxt(table, delimiter=",", names=True)
    assert values["displacement_m"][-1] == record["run_out"]
    (tmp_path / "plain").write_text("")
    assert page.stat().st_mode == (tmp_path / "plain").stat().st_mode
    assert len(list(tmp_path.iterdir())) == 4


@pytest.mark.usefixtures("unseen")
def test_several_scenes_share_the_files(tmp_path: Path, said: Any) -> None:
    page, table, names = tmp_path / "r.html", tmp_path / "m.csv", ["vaiont-frozen", "vaiont"]
    said("run", *names, "--report", page, "--csv", table, "--plot", tmp_path / "m.svg")
    root = tree(page.read_text("utf-8"))
    assert [s.get("id") for s in root.iter("section")] == ["scene-1", "scene-2"]
    first = next(root.iter("table"))
    assert [a.get("href") for a in first.iter("a")] == ["#scene-1", "#scene-2"]
    row = next(r for r in first.iter("tr") if r[0].text == "run-out along the arc")
    assert [cell.text for cell in row][1:] == [printed(motion(n))["run-out along the arc"] for n in names]
    assert {line.partition(",")[0] for line in table.read_text("utf-8").splitlines()[1:]} == set(names)


def test_a_picture_of_several_scenes_holds_them_all() -> None:
    """One picture of a screen has the name of each scene and the same slope once."""
    still = solve(Scene(load("vaiont").arc, 0.9, ["rotation"], name="still"))
    picture = pictures.picture("motions", [motion("vaiont"), *[still] * 31], "png")
    assert int.from_bytes(picture[20:24]) < 2500
    words = words_of(picture)
    assert {"32 scenes, of which 1 move", "vaiont", "start"} <= {*words}
    assert any("8 more, each at most 0 m" in word for word in words)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("--csv {}/none/m.csv", "--csv {}/none/m.csv: there is no folder {}/none"),
        ("--csv {}", "--csv {}: is a folder"),
        ("--report {}/a --csv {}/./a", "--csv {}/./a: would overwrite --report"),
        ("--csv {}/own.toml", "--csv {}/own.toml: would overwrite the scene file"),
        ("--plot {}/m.docx", "--plot {}/m.docx: must end in one of .png, .svg, .pdf, .jpg"),
        ("--plot {}/none/m.png --report {}", "--report {}: is a folder"),
        ("{}/own.toml " * 20 + "--plot {}/m.gif", "a .gif animates a single scene; use .png for all 21"),
    ],
)
def test_paths_are_checked_before_the_work(
    tmp_path: Path, refused: Any, monkeypatch: pytest.MonkeyPatch, words: str, told: str
) -> None:
    monkeypatch.setattr("slipcircle.workbench.commands.run.solve", lambda scene: pytest.fail("solved"))
    own = tmp_path / "own.toml"
    own.write_text(find("vaiont").read_text("utf-8"), "utf-8")
    assert told.replace("{}", str(tmp_path)) in refused("run", own, words.replace("{}", str(tmp_path)))
    assert list(tmp_path.iterdir()) == [own]


# --- files are written whole ---------------------------------------------------------------------------------------


def test_a_file_is_replaced_whole(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.txt"
    files.write_file(str(path), b"old")

    def full(descriptor: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(ValueError, match=r"a\.txt: cannot be written: No space left on device"):
        files.write_file(str(path), b"new")
    assert path.read_bytes() == b"old"
    monkeypatch.undo()
    files.write_file(str(path), b"new")
    assert path.read_bytes() == b"new"
    assert list(tmp_path.iterdir()) == [path]


def test_nothing_is_written_where_one_file_fails(tmp_path: Path, refused: Any, monkeypatch: Any) -> None:
    def fails(*_: Any) -> bytes:
        raise ValueError("cannot be drawn")

    monkeypatch.setattr(pictures, "render", fails)
    assert "cannot be drawn" in refused("run vaiont --csv", tmp_path / "m.csv", "--plot", tmp_path / "m.png")
    assert not list(tmp_path.iterdir())


def test_no_user_setting_changes_a_picture() -> None:
    from matplotlib import rc_context

    plain = pictures.picture("section", motion("vaiont"), "svg")
    with rc_context({"font.size": 22, "lines.linewidth": 9, "text.color": "red", "svg.fonttype": "none"}):
        assert pictures.picture("section", motion("vaiont"), "svg") == plain
    assert not re.search(rb"<dc:date>", plain)
