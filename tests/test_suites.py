"""Suites of records: folders read in mixed formats, and a scene shaken by every record, polarity and scale."""

import csv
import json
import math
import re
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from matplotlib import pyplot
from scipy.integrate import cumulative_trapezoid

from slipcircle import Arc, Scene, Series, ensemble, solve
from slipcircle.core import Status
from slipcircle.workbench.records.records import read_record
from slipcircle.workbench.records.suite import Suite, place_of, read_suite
from slipcircle.workbench.studies.suitedesign import LANE_RESULTS
from slipcircle.workbench.studies.suitestudy import SuiteStudy
from slipcircle.workbench.suites.intensities import spectral_acceleration
from tests.campaigns.intensities import Published, of_slammer, of_tables
from tests.support.blocks import exactly, quake
from tests.support.outputs import tree

GRAVITY = 9.81
ARC = Arc(60.0, math.radians(220.0), math.radians(290.0), 19e3)
FROZEN = Scene(ARC, math.tan(math.radians(20.0)), name="frozen")
SOFTENING = Scene(
    ARC,
    {"law": "exponential", "peak": 0.37, "residual": 0.3, "length": 0.4},
    ["rotation", "centripetal"],
    uncertain={"friction.peak": {"distribution": "uniform", "low": 0.36, "high": 0.4}},
    name="softening",
)


def at2(record: Series) -> str:
    values = "\n".join(f"{value:.12E}" for value in record.values.tolist())
    count, step = record.time.size, record.time[1]
    return f"PEER\nSomewhere\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= {count}, DT= {step:.4f} SEC\n{values}\n"


def packed(values: Any, field: str, per_line: int) -> list[str]:
    """Lines of so many fields, without blanks between them."""
    fields = [format(value, field) for value in values]
    return ["".join(fields[k : k + per_line]) for k in range(0, len(fields), per_line)]


def cosmos(record: Series) -> str:
    """In cm/s^2 and ten columns without blanks; of 100 real values the 62nd is the step in ms."""
    reals = [-999.0] * 61 + [1e3 * float(record.time[1])] + [-999.0] * 38
    lines = ["Corrected acceleration   (Format v01.20 with 13 text lines)", *12 * ["text"]]
    lines += ["  10 Integer-header values follow on   1 lines, Format=(10I8)", "".join(10 * ["    -999"])]
    lines += [" 100 Real-header values follow on  17 lines, Format= (6F13.6)", *packed(reals, "13.6f", 6)]
    lines += ['   1 Comment line(s) follow, each starting with a "|":', "| 1 2 3"]
    lines += [f"{record.time.size} acceleration pts, approx 5 secs, units=cm/s^2 (4),Format=(8F12.6)"]
    return "\n".join([*lines, *packed(981.0 * record.values, "12.6f", 8), "End-of-data for Chan  1 acceleration", ""])


def csmip(record: Series) -> str:
    """Volume 2: for each channel 25 lines of text, 100 integers, 100 reals, acceleration, velocity, displacement."""
    lines, step = [], f"{record.time[1]:.3f}".lstrip("0")
    for channel, orientation in enumerate(("360 Deg", " Up", " 90 Deg"), 1):
        lines += [f"Corrected accelerogram   89146-L2500       Chan  {channel}: {orientation}     from"]
        lines += ["Uncorrected Accelerogram Data             Processed: 02/13/12, CGS  146be002"]
        lines += ["text"] * 23 + packed([1] * 100, "5d", 16) + packed([2.5] * 100, "10.7f", 8)
        for kind, unit in (("accel", "cm/sec2"), ("veloc", "cm/sec"), ("displ", "cm")):
            lines += [f"{record.time.size:6d} points of {kind} data equally spaced at  {step} sec, in {unit}. (8f12.6)"]
            lines += packed(981.0 * channel * record.values, "12.6f", 8)
        lines += [f"/&  ---------- End of data for channel  {channel} ----------"]
    return "\n".join([*lines, ""])


def smc(record: Series) -> str:
    """11 lines of text, 48 integers, 50 reals, comments, samples in cm/s^2 in ten columns without blanks."""
    integers = [-32768] * 15 + [2, record.time.size] + [-32768] * 31
    reals = [1.7e38, 1.0 / float(record.time[1])] + [1.7e38] * 48
    samples = [re.sub(r"E([+-])0(\d)", r"E\1\2", line) for line in packed(981.0 * record.values, "11.4E", 8)]
    head = ["2 CORRECTED ACCELEROGRAM", *10 * ["*"], *packed(integers, "10d", 8), *packed(reals, "15.7E", 5)]
    return "\n".join([*head, "| 1 2 3", "|", *samples, ""])


def two_columns(record: Series) -> str:
    pairs = zip(record.time.tolist(), record.values.tolist(), strict=True)
    return "time (s),acceleration (g)\n" + "".join(f"{time!r},{value!r}\n" for time, value in pairs)


def one_column(record: Series) -> str:
    return "".join(f"{value!r}\n" for value in record.values.tolist())


def three_components(record: Series) -> str:
    values = record.values
    rows = np.stack([record.time, values, -values, 2 * values], axis=1).tolist()
    return "t (s),NS (g),EW (g),disp (cm)\n" + "".join(f"{','.join(map(repr, row))}\n" for row in rows)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Six files of one record, in five formats, in two folders."""
    (tmp_path / "more").mkdir()
    record = quake(1)
    for name, write in {
        "RSN6_ELC180.AT2": at2,
        "RSN6_ELC270.AT2": at2,
        "RSN6_ELC-UP.AT2": at2,
        "more/CE.1.HNE.V2c": cosmos,
        "more/slammer": one_column,
        "more/table.csv": three_components,
        "site.txt": two_columns,
    }.items():
        (tmp_path / name).write_text(write(record), "utf-8")
    (tmp_path / ".hidden").write_text("no record")
    return tmp_path


# --- what is read ----------------------------------------------------------------------------------------------------


def test_a_folder_of_mixed_formats_is_one_suite(folder: Path) -> None:
    suite, expected = read_suite([folder], holds="driving", step=0.01, units="g"), quake(1)
    components = {"RSN6_ELC180.AT2": "180", "RSN6_ELC270.AT2": "270", "CE.1.HNE.V2c": "E", "slammer": "",
                  "table.csv NS": "NS", "table.csv EW": "EW", "site.txt": ""}  # fmt: skip
    assert {entry.name: entry.component for entry in suite} == components
    assert [entry.name for entry in suite.verticals] == ["RSN6_ELC-UP.AT2"]
    assert not suite.unread
    assert [[entry.component for entry in pair] for pair in suite.pairs] == [["180", "270"], ["NS", "EW"]]
    for entry in suite:
        record, sign = entry.record(), -1.0 if entry.component == "EW" else 1.0
        assert record.values == pytest.approx(sign * expected.values, abs=1e-9)
        assert record.time == pytest.approx(expected.time, abs=1e-12)
        assert (entry.samples, entry.step, entry.peak) == pytest.approx((500, 0.01, 0.35), rel=1e-9)
    assert suite.entries[2].unit == "cm/s2"


@pytest.mark.parametrize(
    ("name", "station", "component", "vertical"),
    [
        ("RSN1_HELENA.A_A-HMC180.AT2", "RSN1_HELENA.A_A-HMC", "180", False),
        ("CHY101-V.AT2", "CHY101", "V", True),
        ("IT.ACC..HNZ.D.20161030.ASC", "IT.ACC.D.20161030", "Z", True),
        ("MYG0131103111446.EW", "MYG0131103111446", "EW", False),
        ("IBRH111103111446.UD2", "IBRH1111031114462", "UD", True),
        ("Kobe1995.txt", "Kobe1995", "", False),
    ],
)
def test_components_by_the_names_of_files(name: str, station: str, component: str, vertical: bool) -> None:
    place = place_of(name)
    assert (*place, place.is_vertical) == (station, component, vertical)


BAD: dict[str, tuple[str, str]] = {
    "corrupt.AT2": (at2(quake(1))[:900], "but its header says 500; is the file cut short"),
    "nan.csv": ("t (s),a (g)\n0,0.1\n0.1,nan\n", "line 3: value = nan: must be a finite number"),
    "still.AT2": ("PEER\nNPTS= 4, DT= .0000 SEC\n1 2 3 4\n", "must give NPTS and DT"),
    "unit.csv": ("t (s),a\n0,0.1\n0.1,0.2\n", "units are missing"),
    "notes.txt": ("nothing here\n", "has no line of numbers"),
    "counts.V2c": (cosmos(quake(1)).replace("cm/s^2", "counts"), "units=counts: must be one of g"),
    "short.V2": (csmip(quake(1))[:6000], "values, but its header says 500"),
    "raw.smc": (smc(quake(1)).replace("2 C", "1 UNC"), "must be 2 CORRECTED ACCELEROGRAM"),
    "rate.smc": (smc(quake(1)).replace("1.0000000E+02", "0.0000000E+00"), "line 18: sampling rate = 0.0"),
    "step.V2c": (cosmos(quake(1)).replace("10.000000", "99.000000"), "the real header has no such step"),
}


def test_what_is_no_record_is_listed_and_the_rest_goes_on(folder: Path) -> None:
    for name, (text, _) in BAD.items():
        (folder / name).write_text(text, "utf-8")
    suite = read_suite([folder], step=0.01)
    unread = {Path(file).name: reason for file, reason in suite.unread}
    assert {*unread} == {*BAD, "slammer"}  # which has no units
    assert all(reason in unread[name] for name, (_, reason) in BAD.items())
    assert len(suite) == 6
    empty = folder / "empty"
    empty.mkdir()
    (empty / "a.csv").write_text("nothing")
    refused: list[tuple[Path, dict[str, Any], str]] = [
        (folder, {"strict": True}, r"(?s)corrupt.AT2.*nan.csv.*unit.csv"),
        (folder, {"units": "furlong"}, "units = 'furlong': must be one of g, m/s2"),
        (folder, {"step": 0.0}, r"step = 0.0: must be a positive time in s"),
        (empty, {}, r"empty: holds no horizontal record; .*a.csv: has no line of numbers"),
    ]
    for path, more, message in refused:
        with pytest.raises(ValueError, match=message):
            read_suite([path], **more)


def test_a_record_in_a_file_has_the_intensity_measures_of_their_definitions(tmp_path: Path) -> None:
    """A exp(-b t) sin(w t) as the campaign reads records: integrals of the function itself, and its spectrum."""
    name, b, w = "Cape_Mendocino_1992_PET-090", 0.8, 11.0

    def decaying(time: Any) -> Any:
        return 0.3 * np.exp(-b * time) * np.sin(w * time)

    fine, sampled = np.linspace(0.0, 12.0, 600_001), np.asarray(0.002 * np.arange(6000), dtype=np.float64)
    squares = cumulative_trapezoid(decaying(fine) ** 2, fine, initial=0.0)
    first, last = np.interp([0.05, 0.95], squares / squares[-1], fine)
    frequencies = 0.05 * np.arange(5, 401)  # 0.25 to 20 Hz, by the definition at steps of 0.05 Hz
    angular = 2.0 * np.pi * frequencies
    power = 1.0 / ((b * b + w * w - angular**2) ** 2 + (2.0 * b * angular) ** 2)
    published = Published(
        arias=math.pi / 2.0 * GRAVITY * squares[-1],
        duration=last - first,
        pga=np.max(decaying(fine)),
        pgv=100.0 * GRAVITY * np.max(cumulative_trapezoid(decaying(fine), fine)),
        mean_period=np.average(1.0 / frequencies, weights=power),
    )
    record = Series(sampled, decaying(sampled), held=False)
    (tmp_path / f"{name}.csv").write_text(two_columns(record), "utf-8")
    (row,), absent = of_tables(tmp_path, {name: published, "Kobe_1995_TAK-090": published})
    assert absent == ["Kobe_1995_TAK-090"]
    assert [*row.computed] == pytest.approx([*row.published], rel=3e-4)
    (tmp_path / "Somewhere 1900").mkdir()
    (tmp_path / "Somewhere 1900" / "ABC-000").write_text(one_column(record), "utf-8")
    (tmp_path / "eq.sql").write_text("Somewhere 1900\tABC-000\t0.002\t7.0\t1\t2\t3\t4\t5\t10.4\n", "utf-8")
    (other,), absent = of_slammer(tmp_path)
    assert (other.name, other.computed, absent) == ("Somewhere 1900 ABC-000", row.computed, [])


def test_each_channel_of_a_file_is_a_record(tmp_path: Path) -> None:
    """CSMIP's volume 2 with two horizontal channels and a vertical one, and SMC."""
    expected, csmip_file = quake(1), tmp_path / "CE89146.V2"
    csmip_file.write_text(csmip(expected), "utf-8")
    (tmp_path / "0111a.smc").write_text(smc(expected), "utf-8")
    suite = read_suite([tmp_path], holds="driving")
    factors = {"0111a.smc": 1.0, "CE89146.V2 360": 1.0, "CE89146.V2 90": 3.0, "CE89146.V2 UP": 2.0}
    assert [entry.name for entry in (*suite, *suite.verticals)] == [*factors]
    assert [[entry.component for entry in pair] for pair in suite.pairs] == [["360", "90"]]
    for entry in (*suite, *suite.verticals):
        assert entry.record().values == pytest.approx(factors[entry.name] * expected.values, abs=2e-5)
        assert entry.record().time == pytest.approx(expected.time, abs=1e-12)
    assert read_record(csmip_file, column="up", holds="driving").greatest == pytest.approx(0.7, abs=2e-5)
    with pytest.raises(ValueError, match=r"several columns of acceleration; give column, one of 1 \(360\), 2 \(UP\)"):
        read_record(csmip_file, holds="driving")


# --- what is solved --------------------------------------------------------------------------------------------------


def test_frozen_slopes_slide_as_the_exact_block() -> None:
    """Gamma times Newmark's block, in both polarities and at each scale; none moves that does not reach k_y."""
    k_y = float(solve(replace(FROZEN, end_time=1e-9)).yield_coefficient)
    records = {"one": quake(1, 300), "other": quake(2, 200, 0.02)}
    study = ensemble(FROZEN, records=records, polarities=True, scale_to_pga=[0.9 * k_y, 0.3, 0.9])
    drive, normal = (float(x) for x in ARC.amplitudes_per_inertia)
    psi, mu = abs(float(ARC.dip)), math.tan(math.radians(20.0))
    gamma = drive * math.cos(psi) + mu * normal * math.sin(psi)
    assert (study.yield_coefficient, study.block_factor) == pytest.approx((k_y, gamma), rel=1e-9)
    assert study.displacement.shape == (2, 2, 3, 1)
    assert np.all(study.displacement[:, :, 0] == 0.0)
    assert np.all(study.values["status"][:, :, 0] == Status.STAYS)
    unit = gamma * GRAVITY
    for r, p, s in np.ndindex(2, 2, 2):
        record = [*records.values()][r]
        scaled = record.scaled((1.0, -1.0)[p] * (0.3, 0.9)[s] / record.greatest)
        with mp.workdps(25):
            places, _, _ = exactly(scaled.time, [unit * (mp.mpf(k) - k_y) for k in scaled.values.tolist()], -unit * k_y)
        assert study.displacement[r, p, s + 1, 0] == pytest.approx(float(places[-1]), rel=1e-11)
        single = solve(replace(FROZEN, effects={"shaking": {"horizontal": scaled}}))
        assert study.values["slips"][r, p, s + 1, 0] == len(single.phases)


def test_a_flexible_mass_has_the_published_displacement_of_its_spectral_acceleration() -> None:
    """Dam of Bray and Travasarou (2007): k_y = 0.14, T_s = 0.33 s, S_a(1.5 T_s) = 1.07 g, M 6.9: ln D (cm) = 3.77."""
    drive, normal = (float(x) for x in ARC.amplitudes_per_inertia)
    sine, cosine = math.sin(abs(float(ARC.dip))), math.cos(float(ARC.dip))
    mu = drive * (sine + 0.14 * cosine) / (normal * (cosine - 0.14 * sine))
    half = [record.scaled(0.535 / spectral_acceleration(record, 0.495)) for record in (quake(1), quake(2))]
    study = ensemble(Scene(ARC, mu), records=half, scales=[1.0, 2.0])
    row = study.regressions(1, 6.9, 0.33)[-1]
    assert (row.name, row.records, row.of) == ("Bray and Travasarou (2007)", 2, 2)
    assert math.log(100.0 * row.predicted) == pytest.approx(3.77, abs=0.005)
    blocks = study.displacement[:, 0, 1, 0] / study.block_factor
    assert row.mean == pytest.approx(np.log(blocks / row.predicted).mean(), rel=1e-9)


def test_every_record_sees_the_same_samples_and_every_executor_gives_the_same_bits(tmp_path: Path) -> None:
    records, folder = [quake(1), quake(2), quake(3)], tmp_path / "blocks"

    def run(records: list[Series] = records, **more: Any) -> SuiteStudy:
        study: SuiteStudy = ensemble(
            SOFTENING, 40, 7, records=records, polarities=True, scales=[1.0, 2.0], size=16, **more
        )
        return study

    whole = run(folder=folder)
    assert whole.values["reach"].shape == (3, 2, 2, 40)
    for path in sorted(folder.glob("block-*.npz"))[::2]:
        path.unlink()
    with ThreadPoolExecutor(1) as pool:
        for other in (run(executor=pool), run(folder=folder)):
            for name in (*LANE_RESULTS, "status"):
                np.testing.assert_array_equal(other.values[name], whole.values[name])
    with pytest.raises(ValueError, match="holds blocks of another study: records differ"):
        run(records[:2], folder=folder)
    assert isinstance(SOFTENING.friction, dict)
    friction = SOFTENING.friction | {"peak": float(whole.samples["friction.peak"][31])}
    effects = {"rotation": {}, "centripetal": {}, "shaking": {"horizontal": records[2].scaled(-2.0)}}
    lane = solve(replace(SOFTENING, friction=friction, effects=effects, uncertain={}))
    assert whole.values["run_out"][2, 1, 1, 31] == pytest.approx(lane.run_out, rel=1e-8)
    assert whole.values["rotation"][2, 1, 1, 31] == pytest.approx(lane.end.rotation, rel=1e-8)


def test_tables_have_the_record_as_a_dimension() -> None:
    study = ensemble(SOFTENING, 3, 1, records={"a": quake(1), "b": quake(2)}, polarities=True, scales=[1.0, 2.0])
    data, frame, value = study.to_xarray(), study.to_pandas(), study.values["run_out"][1, 1, 0, 2]
    assert data["run_out"].dims == ("record", "polarity", "scale", "sample")
    assert float(data["run_out"].sel(record="b", polarity=-1.0, scale=1.0).isel(sample=2)) == value
    row = frame.loc["b", -1.0, 1.0, 2]
    assert (row["run_out"], row["friction.peak"]) == (value, study.samples["friction.peak"][2])
    assert json.loads(json.dumps(study.to_dict()))["run_out"][1][1][0][2] == value
    rows, medians = study.by_record(1), np.median(study.displacement[:, :, 1], axis=-1)
    assert rows["mean_m"] == pytest.approx(medians.mean(axis=1), rel=1e-15)
    assert rows["pga_g"] == pytest.approx([0.7, 0.7], rel=1e-12)


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"scales": [1.0], "scale_to_pga": 0.3}, "exclude each other"),
        ({"scales": [0.0, 1.0]}, r"scales = \[0.0, 1.0\]: must be one or more positive numbers"),
        ({"scales": 20.0}, "1: would reach 7 g, and no ground has shaken with more than 5 g"),
        ({"search_each": True}, "search_each and sensitivity do not go with records"),
    ],
)
def test_what_cannot_be_is_refused(settings: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        ensemble(FROZEN, records=[quake(1)], **settings)


def test_a_suite_that_moves_nothing_has_pictures_and_counts() -> None:
    """Records that do not reach k_y, and one of zeros, which cannot be scaled."""
    zeros = Series(np.arange(3.0), np.zeros(3), held=False)
    with pytest.raises(ValueError, match="1: is zero at all times"):
        ensemble(FROZEN, records=Suite.of([zeros]), scale_to_pga=0.3)
    study = ensemble(FROZEN, records={"zeros": zeros, "weak": quake(1).scaled(0.01)}, scales=[1.0, 2.0])
    assert study.displacement.tolist() == [[[[0.0], [0.0]]], [[[0.0], [0.0]]]]
    figure = study.plot().figure
    words = [text.get_text() for ax in figure.axes for text in ax.texts]
    assert words.count("does not move") == 3
    pyplot.close(figure)


def test_the_command(folder: Path, asked: Any, said: Any, refused: Any) -> None:
    """The same numbers in its table, CSV and JSON; a warning for each file that is no record, unless strict."""
    (folder / "corrupt.AT2").write_text(BAD["corrupt.AT2"][0], "utf-8")
    table, curves = folder / "all.csv", folder / "fragility.csv"
    line = f"sweep newmark-pulse --records {folder} --polarities --scale-to-pga 0.2,0.4 --units g --step 0.01"
    line += " --magnitude 7 --period 0.2 --thresholds 0.02,0.5"
    status, out, err = asked(f"{line} --csv {table} --fragility {curves}")
    assert (status, err.count("corrupt.AT2: holds ")) == (0, 1)
    assert "RSN6_ELC-UP.AT2: is a vertical component by its name; not used" in err
    held = json.loads(said(f"{line} --json"))
    run_out = np.array(held["run_out"])
    assert (run_out.shape, held["scale_is"], held["scale"]) == ((7, 2, 2, 1), "pga_g", [0.2, 0.4])
    rows = np.genfromtxt(table, delimiter=",", names=True, dtype=None, encoding="utf-8")
    assert sorted(rows["run_out"]) == sorted(run_out.ravel())
    one, other = (f"{abs(value):.4g}" for value in run_out[0, :, 1, 0])
    assert any(row.split()[:4] == ["RSN6_ELC180.AT2", "0.4", one, other] for row in out.splitlines())
    *_, point, _, none = csv.DictReader(curves.read_text().splitlines())
    assert float(point["share"]) == np.mean(np.abs(run_out[:, :, 1]) > 0.02)
    assert [*none.values()][-1] == "no motion exceeds it; give larger scales"
    low, high = held["fragility"]
    assert low["reason"].endswith("give scales next to it") or low["median_pga_g"]["value"] > 0.0
    assert (high["threshold_m"], high["reason"]) == (0.5, "no motion exceeds it; give larger scales")
    assert {*high["median_pga_g"].values(), *high["dispersion"].values()} == {None}
    assert "no motion exceeds it; give larger scales" in out
    assert "no displacement (at most 1 cm) for" in " ".join(out.split())
    for words, message in {
        f"{line} --strict": "corrupt.AT2: holds",
        "sweep newmark-pulse --samples 3 --magnitude 7 --period 0.2": "--magnitude, --period: of records",
        f"{line} --period -1": "--period -1: must be a time in s, at least 0",
        f"{line} --samples 3": "--samples: no number is uncertain",
    }.items():
        assert message in asked(words)[2]
    assert asked("sweep newmark-pulse --polarities")[0] != 0


def test_synthetic_records_written_to_a_folder_give_the_same_bits(tmp_path: Path, asked: Any, said: Any) -> None:
    """As those made within the sweep; nothing else comes into the folder."""
    made, suite, table = "--synthetic 3:1.5:4 --seed 2", tmp_path / "suite", tmp_path / "records.csv"
    out = said(f"records {made} --out {suite} --csv {table}")
    measures = [row.partition(",")[0] for row in table.read_text().splitlines()[1:]]
    assert measures == ["synthetic 1", "synthetic 2", "synthetic 3"]
    assert sorted(path.name for path in suite.iterdir()) == [f"synthetic-000{k}.csv" for k in (1, 2, 3)]
    one, other = (
        json.loads(said(f"sweep newmark-pulse {records} --polarities --json"))
        for records in (made, f"--records {suite}")
    )
    for name in ("run_out", "peak_velocity", "duration", "pga_g", "pairs"):
        assert one[name] == other[name]
    read = said(f"records {suite}").splitlines()
    assert [row.split()[1:] for row in read[3:6]] == [row.split()[2:] for row in out.splitlines()[3:6]]
    refusals = {
        f"{made} --out {suite}": "exists, and is not an empty folder",
        f"{made} --out {tmp_path / 'no' / 'suite'}": "there is no folder",
        f"{suite} --out {tmp_path / 'other'}": "writes synthetic records",
        f"{suite} {made}": "give either files and folders of records, or --synthetic",
    }
    for words, message in refusals.items():
        status, _, err = asked(f"records {words}")
        assert (status, message in err) == (1, True), err


def test_the_command_matches_a_spectrum_and_says_what_remains(tmp_path: Path, asked: Any) -> None:
    target = tmp_path / "target.csv"
    target.write_text("period (s),Sa (g)\n0.05,0.5\n0.15,0.75\n0.5,0.75\n2,0.19\n")
    status, out, err = asked(f"records --synthetic 2:4 --spectrum {target}")
    assert (status, err) == (0, "")
    *_, first, second = (line for line in out.splitlines() if line.startswith("synthetic"))
    assert all(0.0 < float(row.split()[-2]) < 10.0 for row in (first, second))
    target.write_text("period (s),Sa (g)\n0,0.5\n0.15,0.75\n")
    refusals = {
        f"--synthetic 2:4 --spectrum {target}": "periods and accelerations of a spectrum must be above 0",
        f"--synthetic 2:1:4 --spectrum {target}": "COUNT:DURATION with --spectrum FILE",
        "--synthetic 2:4": "give COUNT:ARIAS:DURATION, or",
    }
    for words, message in refusals.items():
        status, _, err = asked(f"records {words}")
        assert (status, message in err) == (1, True), err


def test_a_report_of_a_suite_is_written_again_to_the_byte(tmp_path: Path, said: Any) -> None:
    line, pages = "sweep newmark-pulse --synthetic 3:1.5:12 --seed 2 --polarities", []
    for name in ("one.html", "two.html"):
        said(f"{line} --report {tmp_path / name}")
        pages.append((tmp_path / name).read_text("utf-8").replace(name, ""))
    assert pages[0] == pages[1]
    words = " ".join(" ".join(tree(pages[0]).itertext()).split())
    run_out = np.array(json.loads(said(f"{line} --json"))["run_out"])
    assert f"median displacements {np.median(np.abs(run_out[:, :, 0, 0])):.4g} m" in words
    assert "synthetic 3" in words


def test_a_picture_has_every_record_in_order() -> None:
    records = {name: quake(seed) for name, seed in (("a", 1), ("b", 2), ("c", 3))}
    study = ensemble(FROZEN, records=records, polarities=True, scale_to_pga=[0.2, 0.4])
    figure, table = study.plot().figure, study.by_record(study.own_scale)
    displacements, incremental, fragility, velocity, displacement = figure.axes
    order = np.argsort(table["mean_m"])
    names = [table["record"][k] for k in order]
    assert [text.get_text() for text in displacements.get_yticklabels()] == names
    assert list(displacements.lines[0].get_xdata()) == [table["displacement_m"][k] for k in order]
    median = np.quantile(study.displacement, 0.5, axis=(0, 1, 3), method="inverted_cdf")
    assert incremental.lines[-1].get_ydata() == pytest.approx(median)
    points = np.array(fragility.containers[1].lines[0].get_data())
    assert points == pytest.approx(np.array([[0.2, 0.4], np.mean(study.displacement > 0.05, axis=(0, 1, 3))]))
    for panel, name in ((velocity, "peak_velocity"), (displacement, "run_out")):
        assert panel.get_title(loc="right") == f"median: {names[1]}"
        ends = [np.max(np.abs(line.get_ydata())) for line in panel.lines[:2]]
        assert ends == pytest.approx(np.abs(study.values[name][order[1], :, study.own_scale, 0]), rel=1e-6)
    pyplot.close(figure)
