"""Suites of records: folders read in mixed formats, and a scene shaken by every record, polarity and scale."""

import csv
import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any
from unittest.mock import Mock

import numpy as np
import pytest
from matplotlib import pyplot

from slipcircle import Arc, Scene, Series, ensemble, load, solve
from slipcircle.core import Status
from slipcircle.workbench.files.loaded import stability_of
from slipcircle.workbench.files.shipped import find
from slipcircle.workbench.records import recordfiles
from slipcircle.workbench.records import suite as suites
from slipcircle.workbench.records.records import read_record
from slipcircle.workbench.records.stations import place_of
from slipcircle.workbench.records.suite import read_suite
from slipcircle.workbench.suites.intensities import intensities, spectral_acceleration
from slipcircle.workbench.suites.regressions import Shaking, comparisons
from slipcircle.workbench.suites.synthetic import write_records
from tests.support.blocks import quake
from tests.support.outputs import tree
from tests.support.recordfiles import COUNT, GAL, NORTH, STEP, TIME, at2, cosmos, csmip, rows, smc

ARC = Arc(60.0, math.radians(220.0), math.radians(290.0), 19e3)
FROZEN = Scene(ARC, math.tan(math.radians(20.0)), name="frozen")
SOFTENING = Scene(
    ARC,
    {"law": "exponential", "peak": 0.37, "residual": 0.3, "length": 0.4},
    ["rotation", "centripetal"],
    uncertain={"friction.peak": {"distribution": "uniform", "low": 0.36, "high": 0.4}},
    name="softening",
)


# One record in every format, each times another factor, so that no two are the same.
FACTORS = {"RSN6_ELC180.AT2": 1.0, "RSN6_ELC270.AT2": 0.95, "RSN6_ELC-UP.AT2": 1.0, "0111a.smc": 0.9, "slammer": 0.8,
           "CE.1.HNE.V2c": 0.85, "CE89146.V2 90": 1.1, "CE89146.V2 UP": 0.275, "CE89146.V2 360": 0.55, "site.txt": 0.7,
           "table.csv NS": 0.75, "table.csv EW": -0.75}  # fmt: skip
RECORD = Series(TIME, NORTH, held=False)
FILES = {
    "RSN6_ELC180.AT2": at2(""),
    "RSN6_ELC270.AT2": at2("", factor=0.95),
    "RSN6_ELC-UP.AT2": at2(""),
    "more/0111a.smc": smc(factor=0.9),
    "more/CE.1.HNE.V2c": cosmos(factor=0.85 * GAL),
    "more/CE89146.V2": csmip(factor=1.1),
    "more/slammer": rows(0.8 * NORTH, form="%.17g"),
    "more/table.csv": "time (s),NS (g),EW (g),disp (cm)\n" + rows(TIME, 0.75 * NORTH, -0.75 * NORTH, NORTH),
    "site.txt": "time (s),acceleration (g),velocity (cm/s),disp (cm)\n" + rows(TIME, *3 * [0.7 * NORTH]),
    ".hidden": "no record",
}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "more").mkdir()
    for name, text in FILES.items():
        (tmp_path / name).write_text(text, "utf-8")
    return tmp_path


# --- what is read ----------------------------------------------------------------------------------------------------


def test_a_folder_of_mixed_formats_is_one_suite(folder: Path) -> None:
    """Channels and columns of acceleration are records; horizontal records of a station are pairs."""
    suite = read_suite([folder], holds="driving", step=STEP, units="g")
    components = {"RSN6_ELC180.AT2": "180", "RSN6_ELC270.AT2": "270", "0111a.smc": "225", "CE.1.HNE.V2c": "90",
                  "CE89146.V2 360": "360", "CE89146.V2 90": "90", "slammer": "", "table.csv NS": "NS",
                  "table.csv EW": "EW", "site.txt": ""}  # fmt: skip
    assert {entry.name: entry.place.component for entry in suite} == components
    assert [entry.name for entry in suite.verticals] == ["RSN6_ELC-UP.AT2", "CE89146.V2 UP"]
    assert {Path(unread.file).name for unread in suite.unread} == {"table.csv", "site.txt"}
    assert [unread.reason.split(":")[0] for unread in suite.unread] == [
        "column 4 (disp)", "column 3 (velocity)", "column 4 (disp)"]  # fmt: skip
    assert [[e.place.component for e in pair] for pair in suite.pairs] == [["180", "270"], ["90", "360"], ["NS", "EW"]]
    for entry in (*suite, *suite.verticals):
        record = entry.record()
        assert record.values == pytest.approx(FACTORS[entry.name] * NORTH, abs=2e-5)
        assert record.time == pytest.approx(RECORD.time, abs=1e-12)
        assert (entry.samples, entry.step) == pytest.approx((COUNT, STEP), rel=1e-9)
        assert entry.peak == record.greatest
    channels = folder / "more" / "CE89146.V2"
    assert read_record(channels, column="up", holds="driving").greatest == pytest.approx(0.0825, abs=2e-5)
    with pytest.raises(ValueError, match=r"several columns of acceleration; give column, one of 1 \(90\), 2 \(UP\)"):
        read_record(channels, holds="driving")


def test_records_beyond_the_memory_are_read_again_for_their_samples_alone(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    stored, *_ = read_suite([folder / "more" / "0111a.smc"], holds="driving")
    monkeypatch.setattr(suites, "_KEPT", 0)
    entry, *_ = read_suite([folder / "more" / "0111a.smc"], holds="driving")
    assert np.array_equal(entry.record().values, stored.record().values)
    Path(entry.file).unlink()
    assert entry.intensities == stored.intensities == intensities(stored.record(), 9.81)
    assert entry.measures.drift == stored.measures.drift
    with pytest.raises(ValueError, match="No such file"):
        entry.record()


@pytest.mark.parametrize(
    ("name", "station", "component", "vertical"),
    [
        ("RSN1_HELENA.A_A-HMC180.AT2", "RSN1_HELENA.A_A-HMC", "180", False),
        ("CHY101-V.AT2", "CHY101", "V", True),
        ("IT.ACC..HNZ.D.20161030.ASC", "IT.ACC.D.20161030", "Z", True),
        ("MYG0131103111446.EW", "MYG0131103111446", "EW", False),
        ("IBRH111103111446.UD2", "IBRH1111031114462", "UD", True),
        ("Station.up", "Station", "UP", True),
        ("Kobe1995.txt", "Kobe1995", "", False),
    ],
)
def test_components_by_the_names_of_files(name: str, station: str, component: str, vertical: bool) -> None:
    place = place_of(name)
    assert (*place, place.is_vertical) == (station, component, vertical)


BAD = {
    "corrupt.AT2": (at2()[:900], "but its header says 60; is the file cut short"),
    "nan.csv": ("t (s),a (g)\n0,0.1\n0.1,nan\n", "line 3: value = nan: must be a finite number"),
    "slammer": ("0.1\n0.2\n", "units are missing"),
}


def test_what_is_no_record_is_listed_and_the_rest_goes_on(tmp_path: Path) -> None:
    for name, (text, _) in BAD.items():
        (tmp_path / name).write_text(text, "utf-8")
    with pytest.raises(ValueError, match=r"holds no horizontal record; .*corrupt.AT2: holds"):
        read_suite([tmp_path], step=STEP)
    (tmp_path / "good.AT2").write_text(at2(), "utf-8")
    suite = read_suite([tmp_path], step=STEP)
    unread = {Path(file).name: reason for file, reason in suite.unread}
    assert [entry.name for entry in suite] == ["good.AT2"]
    assert {*unread} == {*BAD}
    assert all(reason in unread[name] for name, (_, reason) in BAD.items())
    refused: list[tuple[dict[str, Any], str]] = [
        ({"strict": True}, r"(?s)corrupt.AT2.*nan.csv.*slammer"),
        ({"units": "furlong"}, "units = 'furlong': must be one of g, %g, mg, m/s2"),
        ({"step": 0.0}, r"step = 0.0: must be a positive time in s"),
        ({"holds": "both"}, "holds = 'both': must be"),
        ({"gaps": "mend"}, "gaps = 'mend': must be"),
    ]
    for more, message in refused:
        with pytest.raises(ValueError, match=message):
            read_suite([tmp_path], **more)


def test_a_file_of_several_records_is_read_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    samples = [f"{0.01 * k:.2f},{k % 3 / 10},{k % 5 / 10},{k % 7 / 10}" for k in range(20)]
    (tmp_path / "three.csv").write_text("t (s),x (g),y (g),w (g)\n" + "\n".join(samples), "utf-8")
    calls = {name: Mock(side_effect=getattr(recordfiles, name)) for name in ("text_of", "fields_below")}
    for name, call in calls.items():
        monkeypatch.setattr(recordfiles, name, call)
    suite = read_suite([tmp_path], holds="driving")
    assert [call.call_count for call in calls.values()] == [1, 1]
    assert [entry.place.component for entry in suite] == ["x", "y", "w"]
    assert suite.entries[2].record().values == pytest.approx([k % 7 / 10 for k in range(20)])
    assert [replace(entry, kept=None).record().values[6] for entry in suite] == [0.0, 0.1, 0.6]


# --- what is solved --------------------------------------------------------------------------------------------------


def test_frozen_slopes_slide_as_single_scenes_do() -> None:
    """Both polarities and each scale agree with single motions; records below k_y move nothing."""
    drive, normal = (float(x) for x in ARC.amplitudes_per_inertia)
    psi, mu = abs(float(ARC.dip)), math.tan(math.radians(20.0))
    gamma = drive * math.cos(psi) + mu * normal * math.sin(psi)
    k_y = (mu * normal * math.cos(psi) - drive * math.sin(psi)) / gamma
    records = {"one": quake(1, 300), "other": quake(2, 200, 0.02)}
    study = ensemble(FROZEN, records=records, polarities=True, scale_to_pga=[0.9 * k_y, 0.3, 0.9])
    assert (study.yield_coefficient, study.block_factor) == pytest.approx((k_y, gamma), rel=1e-9)
    assert study.displacement.shape == (2, 2, 3, 1)
    assert np.all(study.values["status"][:, :, 0] == Status.STAYS)
    for r, p, s in np.ndindex(2, 2, 3):
        scaled = [*records.values()][r].scaled(float(study.polarities[p] * study.scales[s]) / 0.35)
        single = solve(replace(FROZEN, effects={"shaking": {"horizontal": scaled}}))
        assert study.displacement[r, p, s, 0] == pytest.approx(single.end.displacement, rel=1e-11)
        assert study.values["slips"][r, p, s, 0] == (len(single.phases) if s else 0)


def test_regressions_are_those_of_the_scaled_records() -> None:
    """Rigid-block displacements agree; Bray and Travasarou (2007) use the spectrum at 1.5 of the period."""
    records = [quake(1), quake(2)]
    study = ensemble(FROZEN, records=records, scales=[1.0, 2.0])
    scaled = [record.scaled(2.0) for record in records]
    pga, pgv, arias = np.array([intensities(record)[:3] for record in scaled]).T
    response = np.array([spectral_acceleration(record, 0.495) for record in scaled])
    shaking = Shaking(study.yield_coefficient, pga, pgv, arias, 6.9, 0.33, response)
    expected = comparisons(study.displacement[:, 0, 1, 0] / study.block_factor, shaking)
    for row, other in zip(study.regressions(1, 6.9, 0.33), expected, strict=True):
        assert row[:5] == other[:5]
        assert row[5:] == pytest.approx(other[5:], rel=1e-9, nan_ok=True)


def test_every_record_sees_the_same_samples_and_a_study_continues(tmp_path: Path) -> None:
    records = [quake(1), quake(2), quake(3)]
    more: dict[str, Any] = {"polarities": True, "scales": [1.0, 2.0], "folder": tmp_path}
    whole = ensemble(SOFTENING, 40, 7, records=records, **more)
    again = ensemble(SOFTENING, 40, 7, records=records, **more)
    assert again.values["run_out"].tolist() == whole.values["run_out"].tolist()
    with pytest.raises(ValueError, match="holds blocks of another study: records differ"):
        ensemble(SOFTENING, 40, 7, records=records[:2], **more)
    assert isinstance(SOFTENING.friction, dict)
    friction = SOFTENING.friction | {"peak": float(whole.samples["friction.peak"][31])}
    effects = {"rotation": {}, "centripetal": {}, "shaking": {"horizontal": records[2].scaled(-2.0)}}
    lane = solve(replace(SOFTENING, friction=friction, effects=effects, uncertain={}))
    values = [whole.values[name][2, 1, 1, 31] for name in ("run_out", "end_displacement", "rotation")]
    assert values == pytest.approx([lane.run_out, lane.end.displacement, lane.end.rotation], rel=1e-8)


def test_tables_have_the_record_as_a_dimension() -> None:
    study = ensemble(SOFTENING, 3, 1, records={"a": quake(1), "b": quake(2)}, polarities=True, scales=[1.0, 2.0])
    value = study.values["run_out"][1, 1, 0, 2]
    assert float(study.to_xarray()["run_out"].sel(record="b", polarity=-1.0, scale=1.0).isel(sample=2)) == value
    row = study.to_pandas().loc["b", -1.0, 1.0, 2]
    assert (row["run_out"], row["friction.peak"]) == (value, study.samples["friction.peak"][2])
    assert study.columns()["run_out"].tolist() == study.values["run_out"].ravel().tolist()
    assert "comes to rest" in study._repr_html_()
    for ask in (lambda: study.quantile("run_out", 0.5), lambda: study[0], lambda: study.convergence):
        with pytest.raises(ValueError, match="has records, and not samples alone; use by_record"):
            ask()
    by_record, medians = study.by_record(1), np.median(study.displacement[:, :, 1], axis=-1)
    assert by_record["mean_m"] == pytest.approx(medians.mean(axis=1), rel=1e-15)
    assert by_record["pga_g"] == pytest.approx([0.7, 0.7], rel=1e-12)


ZEROS = Series(np.arange(3.0), np.zeros(3), held=False)


@pytest.mark.parametrize(
    ("record", "settings", "message"),
    [
        (RECORD, {"scales": [1.0], "scale_to_pga": 0.3}, "exclude each other"),
        (RECORD, {"scales": [0.0, 1.0]}, r"scales = \[0.0, 1.0\]: must be one or more positive numbers"),
        (RECORD, {"scales": 20.0}, "1: would reach 6 g, and no ground has shaken with more than 5 g"),
        (RECORD, {"search_each": True}, "search_each and sensitivity cannot be combined with records"),
        (ZEROS, {"scale_to_pga": 0.3}, "1: is zero at all times"),
    ],
)
def test_what_cannot_be_is_refused(record: Series, settings: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        ensemble(FROZEN, records=[record], **settings)


def test_records_that_move_nothing_have_a_picture() -> None:
    study = ensemble(FROZEN, records={"zeros": ZEROS, "weak": RECORD.scaled(0.01)}, scales=[1.0, 2.0])
    assert not study.displacement.any()
    figure = study.plot().figure
    assert [text.get_text() for ax in figure.axes for text in ax.texts].count("does not move") == 3
    pyplot.close(figure)


# --- what is printed and drawn ---------------------------------------------------------------------------------------


def test_the_command_has_the_numbers_of_the_study(folder: Path, asked: Any, said: Any) -> None:
    """Table, CSV and JSON have the same numbers, and each invalid file has a warning."""
    (folder / "corrupt.AT2").write_text(at2()[:900], "utf-8")
    table, curves = folder / "all.csv", folder / "fragility.csv"
    line = f"sweep newmark-pulse --records {folder} --polarities --scale-to-pga 0.3,0.45 --units g --step 0.02"
    line += " --magnitude 7 --period 0.2 --thresholds 0.02,0.5"
    status, out, err = asked(f"{line} --csv {table} --fragility {curves}")
    assert (status, err.count("corrupt.AT2: holds ")) == (0, 1)
    assert "RSN6_ELC-UP.AT2: is a vertical component; not used" in err
    suite = read_suite([folder], units="g", step=STEP)
    settings: dict[str, Any] = {"polarities": True, "scale_to_pga": [0.3, 0.45], "thresholds": [0.02, 0.5]}
    study = ensemble(load("newmark-pulse"), records=suite, **settings)
    assert json.loads(said(f"{line} --json"))["run_out"] == study.values["run_out"].tolist()
    written = np.genfromtxt(table, delimiter=",", names=True, dtype=None, encoding="utf-8")
    assert written["run_out"].tolist() == study.columns()["run_out"].tolist()
    one, other = (f"{value:.4g}" for value in study.displacement[0, :, 0, 0])
    assert any(row.split()[:4] == ["RSN6_ELC180.AT2", "0.3", one, other] for row in out.splitlines())
    *_, point, _, none = csv.DictReader(curves.read_text().splitlines())
    assert float(point["share"]) == np.mean(study.displacement[:, :, 1] > 0.02)
    assert none["reason"] == study.fragility()[1].to_dict()["reason"] == "no motion exceeds it; give larger scales"
    assert none["reason"] in out
    assert "counts displacements above 1 cm only; at most 1 cm for" in " ".join(out.split())


def test_synthetic_records_written_to_a_folder_give_the_same_bits(tmp_path: Path, said: Any) -> None:
    """Written records give the results of records made within the sweep, and nothing else is in the folder."""
    made, suite, table = "--synthetic 3:1.5:4 --seed 2", tmp_path / "suite", tmp_path / "records.csv"
    said(f"records {made} --out {suite} --csv {table}")
    assert [row[:11] for row in table.read_text().splitlines()[1:]] == ["synthetic 1", "synthetic 2", "synthetic 3"]
    assert sorted(path.name for path in suite.iterdir()) == [f"synthetic-000{k}.csv" for k in (1, 2, 3)]
    sweeps = [json.loads(said(f"sweep newmark-pulse {x} --polarities --json")) for x in (made, f"--records {suite}")]
    for name in ("run_out", "peak_velocity", "duration", "pga_g", "pairs"):
        assert sweeps[0][name] == sweeps[1][name]


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("records --synthetic 3:1.5:4 --out .", "exists and is not an empty folder"),
        ("records --synthetic 3:1.5:4 --out no/suite", "there is no folder"),
        ("records more --out other", "writes synthetic records"),
        ("records more --synthetic 3:1.5:4", "give either files or folders of records, or --synthetic"),
        ("records --synthetic 2:4", "2:4: must be COUNT:ARIAS:DURATION, such as 20:1.5:12"),
        ("sweep newmark-pulse --records . --strict --step 1", "slammer: units are missing"),
        ("sweep newmark-pulse --samples 3 --magnitude 7 --period 0.2", "--magnitude, --period: for earthquake records"),
        ("sweep newmark-pulse --records site.txt --period -1", "--period -1: must be a time in s, at least 0"),
        ("sweep newmark-pulse --records site.txt --samples 3", "--samples: the scene has no uncertain parameter"),
        ("sweep newmark-pulse --polarities", "or --records FOLDER"),
    ],
)
def test_what_commands_refuse(
    line: str, message: str, folder: Path, asked: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(folder)
    status, _, err = asked(line)
    assert status
    assert message in err


HEADED = """
[report]
title = "Slope 4 & its berm"
project = "Dam 7"
author = "A. Author"
checker = "C. Checker"
"""


def test_a_report_of_a_suite_shows_its_slope_and_numbers(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, said: Any
) -> None:
    """The report has each record's solution, NumPy's statistics and the search's circle, with the same bytes again."""
    scene, page = tmp_path / "slope.toml", tmp_path / "page.html"
    scene.write_text(find("shaken-slope").read_text("utf-8") + HEADED, "utf-8")
    records = {f"q{seed}": quake(seed).scaled(2.0) for seed in (1, 2, 3)}
    write_records(records, tmp_path / "records")
    monkeypatch.setenv("SOURCE_DATE_EPOCH", str(86400 * 365))
    line = f"sweep {scene} --records {tmp_path / 'records'} --polarities --seed 2 --report {page} --json"
    said(line)
    text = page.read_text("utf-8")
    said(line)
    assert page.read_text("utf-8") == text
    root = tree(text)
    words = " ".join(" ".join(root.itertext()).split())
    assert root.find(".//h1").text == "Slope 4 & its berm"
    assert "date 1971-01-01 project Dam 7 author A. Author checker C. Checker" in words
    assert [image.get("alt") for image in root.iter("img")] == ["Suite of shaken-slope", "Slope of shaken-slope"]
    every_row = [[cell.text for cell in row] for row in root.iter("tr")]
    cells = {row[0]: row[1:] for row in every_row}
    still = load(scene)
    solved = []
    for number, record in enumerate(records.values(), 1):
        shaken = [{**still.called, "shaking": {"horizontal": record.scaled(sign)}} for sign in (1.0, -1.0)]
        both = [solve(replace(still, effects=effects)) for effects in shaken]
        moved = [abs(motion.end.displacement) for motion in both]
        speed = max(abs(motion.outcomes["peak_velocity"]) for motion in both)
        found = [float(cell) for cell in cells[f"synthetic-{number:04d}.csv"][1:5]]
        assert found == pytest.approx([*moved, sum(moved) / 2, speed], rel=2e-3)
        solved += moved
    assert len(solved) == 6
    at_scale = [[float(cell.split(" ")[0]) for cell in row[1:]] for row in every_row if row[0] == "scale 1"]
    share, mean, p16, median, p84 = at_scale[0][:5]
    assert share == pytest.approx(100.0 * np.mean(np.array(solved) > 0.0), abs=0.1)
    assert mean == pytest.approx(np.mean(solved), rel=2e-3)
    wanted = np.quantile(solved, [0.16, 0.5, 0.84], method="inverted_cdf")
    assert [p16, median, p84] == pytest.approx(wanted, rel=2e-3)
    assert at_scale[1][1:] == pytest.approx([np.mean(np.array(solved) > d) for d in (0.01, 0.05, 0.15, 1.0)], abs=0.005)
    assert f"median displacements {median:.4g} m" in words
    stability = stability_of(still)
    assert stability is not None
    for method, name in (("paper", "the paper's method"), ("bishop", "Bishop's method")):
        assert cells[f"factor of safety by {name}"] == [f"{stability.factors_of_safety[method]:.4g}"]
    assert cells["radius"] == [f"{stability.radius:.4g} m"]
    assert [float(x) for x in cells["centre"][0].removesuffix(" m").split(",")] == pytest.approx(
        list(stability.centre), abs=0.01
    )
    assert max(len(list(group)) for group in root.iter("tbody")) == 10


def test_a_picture_has_every_record_in_order() -> None:
    records = {name: quake(seed) for name, seed in (("a", 1), ("b", 2), ("c", 3))}
    study = ensemble(FROZEN, records=records, polarities=True, scale_to_pga=[0.2, 0.4])
    figure, table = study.plot().figure, study.by_record(study.own_scale)
    displacements, incremental, fragility, *histories = figure.axes
    order = np.argsort(table["mean_m"])
    names = [table["record"][k] for k in order]
    assert [text.get_text() for text in displacements.get_yticklabels()] == names
    assert list(displacements.lines[0].get_xdata()) == [table["displacement_m"][k] for k in order]
    median = np.quantile(study.displacement, 0.5, axis=(0, 1, 3), method="inverted_cdf")
    assert incremental.lines[-1].get_ydata() == pytest.approx(median)
    shares = np.mean(study.displacement > 0.05, axis=(0, 1, 3))
    assert fragility.containers[1].lines[0].get_ydata() == pytest.approx(shares)
    for panel, name in zip(histories, ("peak_velocity", "run_out"), strict=True):
        assert panel.get_title(loc="right") == f"median: {names[1]}"
        ends = [np.max(np.abs(line.get_ydata())) for line in panel.lines[:2]]
        assert ends == pytest.approx(np.abs(study.values[name][order[1], :, study.own_scale, 0]), rel=1e-6)
    pyplot.close(figure)
