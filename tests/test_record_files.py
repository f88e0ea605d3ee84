"""Record files of networks and spreadsheets: columns by header, format or option, and what is refused or listed."""

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from slipcircle import Suite, load, read_suite
from slipcircle.tables import Series
from slipcircle.workbench.common.units import ACCELERATION, TIME, UNITS, unit_of
from slipcircle.workbench.records.records import read_record
from slipcircle.workbench.suites.intensities import drift_warning
from tests.campaigns import fuzz_records
from tests.support.recordfiles import COUNT, EAST, FILES, GAL, NORTH, STEP, UP, at2, geonet, rows, smc, trace
from tests.support.recordfiles import TIME as TIMES


def write(folder: Path, files: dict[str, str]) -> Path:
    for name, text in files.items():
        (folder / name).write_text(text, "utf-8")
    return folder


def described(suite: Suite) -> dict[str, float]:
    """Peaks of the records by component or name, those of verticals below 0."""
    signed = [(entry, 1.0) for entry in suite] + [(entry, -1.0) for entry in suite.verticals]
    return {entry.place.component or entry.name: sign * entry.peak for entry, sign in signed}


@pytest.mark.parametrize(("text", "peaks"), FILES.values(), ids=FILES)
def test_formats_of_networks(tmp_path: Path, text: str, peaks: dict[str, float]) -> None:
    """Components have their directions and scales; verticals are recognised by their headers."""
    suite = read_suite([write(tmp_path, {"a file": text, "other.csv": "time (s),acc (g)\n0,0\n9,2\n"})])
    assert described(suite) == pytest.approx(peaks | {"other.csv": 2.0}, abs=2e-5)
    for entry in (*suite, *suite.verticals)[:-1]:
        if entry.name != "other.csv":
            values = entry.record().values
            assert values == pytest.approx(-NORTH * (entry.peak / 0.3), abs=1e-4)  # of the ground
            assert (entry.samples, entry.step) == pytest.approx((COUNT, STEP), rel=1e-9)
    assert not suite.unread


OF_TWO = rows(TIMES, NORTH)
SPELLED = {
    "g": "g|G|g's|Gs|(g)|g.",
    "%g": "%g|% g|percent g",
    "mg": "mg|milli-g|millig",
    "m/s2": "m/s2|m/s/s|m/s^2|M/S**2|m/sec2|m/s²|m s-2|m s⁻²|m·s⁻²|m s^-2|m_s2|m/(s^2)|meters per second squared",
    "cm/s2": "cm/s2|gal|Gals|Gales|cm/s/s|cm/sec^2|cm/sec/sec|cm s-2|gal(cm/s/s)|cm/sec2(04)",
    "mm/s2": "mm/s/s|millimetres/sec/sec",
    "ft/s2": "ft/s2|ft/sec^2|feet/s/s",
    "in/s2": "in/s2|in/s^2|inch/s2",
    "mgal": "mGal",
}


def test_units_and_their_spellings(tmp_path: Path) -> None:
    """Units have their sizes by definition (1 ft = 0.3048 m, 1 in = 0.0254 m, 1 gal = 1 cm/s^2); others are named."""
    sizes = {"ft/s2": 0.3048, "in/s2": 0.0254, "mg": 9.81e-3, "mgal": 1e-5, "cm/s2": 0.01}
    assert sizes.items() <= UNITS.items()
    for unit, spellings in SPELLED.items():
        for text in spellings.split("|"):
            assert unit_of(text) == unit, text
        file = write(tmp_path, {"one.csv": f"time (s),acc ({unit})\n" + rows(TIMES, NORTH * 9.81 / UNITS[unit])})
        assert read_suite([file]).entries[0].peak == pytest.approx(0.3, rel=1e-8)
    for text in ("furlong/s2", "m/s", "cm", "counts", "g/10", "", "s"):
        assert unit_of(text) is None
    spelled = {"s": "s sec seconds", "ms": "ms msec milliseconds", "us": "us µs μs microseconds usec"}
    assert all(unit_of(text, TIME) == unit for unit, texts in spelled.items() for text in texts.split())
    assert unit_of("min", TIME) is None
    assert unit_of("r_u", ACCELERATION) is None


HEAD = "time (s),acc (g)\n"
READ: dict[str, tuple[str, dict[str, Any], dict[str, float]]] = {
    "milliseconds": ("Time (msec),acc (g)\n" + rows(1e3 * TIMES, NORTH), {}, {"a file": 0.3}),
    "microseconds": ("t [µs];a [g]\n" + rows(1e6 * TIMES, NORTH, separator=";"), {}, {"a file": 0.3}),
    "a counter": (",acc (g)\n" + rows(range(COUNT), NORTH), {"step": STEP}, {"a file": 0.3}),
    "a named counter": ("sample,acc (g)\n" + rows(range(COUNT), NORTH), {"step": STEP}, {"a file": 0.3}),
    "pandas": (",time,acc_g\n" + rows(range(COUNT), TIMES, NORTH), {}, {"a file": 0.3}),
    "axes": ("time (s),acc_N (g),acc_E (g),acc_Z (g)\n" + rows(TIMES, NORTH, EAST, UP), {},
             {"acc_N": 0.3, "acc_E": 0.15, "acc_Z": -0.075}),
    "codes": ("time (s),HNE (g),HNN (g),HNZ (g)\n" + rows(TIMES, EAST, NORTH, UP), {},
              {"HNN": 0.3, "HNE": 0.15, "HNZ": -0.075}),
    "words": ("time (s),Ax (g),Ay (g),Vertical (g)\n" + rows(TIMES, NORTH, EAST, UP), {},
              {"Ax": 0.3, "Ay": 0.15, "Vertical": -0.075}),
    "directions": ("t\tN-S [cm/s²]\tU-D [cm/s²]\n" + rows(TIMES, GAL * NORTH, GAL * UP, separator="\t"), {},
                   {"a file": 0.3, "U-D": -0.075}),
    "units in a row": ("Time,NS,UD\n(s),(gal),(gal)\n" + rows(TIMES, GAL * NORTH, GAL * UP), {},
                       {"NS": 0.3, "UD": -0.075}),
    "statements": ("dt=0.02\nacc: m/s2\n" + rows(9.81 * NORTH), {}, {"a file": 0.3}),
    "no times": ("NS EW UD\n" + rows(NORTH, EAST, UP, separator=" "), {"units": "g", "step": STEP},
                 {"NS": 0.3, "EW": 0.15, "UD": -0.075}),
    "by convention": (rows(TIMES, NORTH, separator="  "), {"units": "g"}, {"a file": 0.3}),
    "roles": (rows(TIMES, NORTH, UP, separator=" "), {"units": "g", "columns": "time,acceleration,vertical"},
              {"2": 0.3, "3": -0.075}),
    "times of day": ("time,acc (g)\n" + "".join(f"2023-02-06T01:17:{t:06.3f},{a}\n"
                                             for t, a in zip(TIMES, NORTH, strict=True)),
                     {"columns": "skip,acceleration", "step": STEP}, {"a file": 0.3}),
    "a number of samples": ("60 0.02\n" + rows(NORTH), {"units": "g", "step": STEP}, {"a file": 0.3}),
    "a number of samples above times": ("60, .02\n" + OF_TWO, {"units": "g", "columns": "time,acceleration"},
                                        {"a file": 0.3}),
    "an empty first column": ("".join(f",{line}\n" for line in (HEAD + OF_TWO).splitlines()), {}, {"a file": 0.3}),
    "wrapped": ("x\n" + rows(NORTH[:30], NORTH[30:], separator=" "), {"units": "g", "step": STEP, "columns": "wrapped"},
                {"a file": 0.3}),
    "a pattern": ("t,A (g),B (g)\n" + rows(TIMES, NORTH, UP), {"vertical": "*B"}, {"A": 0.3, "B": -0.075}),
    "no pattern": ("t,N (g),Z (g)\n" + rows(TIMES, NORTH, UP), {"vertical": "none"}, {"N": 0.3, "Z": 0.075}),
}  # fmt: skip


@pytest.mark.parametrize("head", ["time [ns]", "time_ns", "Time (NS)", "time ticks", "t/min", "elapsed time (h)"])
def test_times_in_other_units_are_refused(tmp_path: Path, head: str) -> None:
    """Units that resemble the names of directions are refused, too."""
    file = write(tmp_path, {"a.csv": f"{head},acc (g)\n" + rows(TIMES, NORTH)})
    with pytest.raises(ValueError, match=r"column 1 .*: its unit '\w+' is not one of s, ms, us; give --step"):
        read_suite([file])


@pytest.mark.parametrize(
    "head", ["Elapsed Time_s", "elapsed time", "zeit in s", "T (s)", "t/s", "Time:s", "Times [SEC]"]
)
def test_names_of_times_in_seconds(tmp_path: Path, head: str) -> None:
    file = write(tmp_path, {"a.csv": f"{head};acc (g)\n" + rows(TIMES, NORTH, separator=";")})
    assert read_suite([file]).entries[0].step == pytest.approx(STEP)


@pytest.mark.parametrize(("text", "options", "peaks"), READ.values(), ids=READ)
def test_tables_say_what_their_columns_are(
    tmp_path: Path, text: str, options: dict[str, Any], peaks: dict[str, float]
) -> None:
    suite = read_suite([write(tmp_path, {"a file": text})], **options)
    found = {(e.name.removeprefix("a file ")): s * e.peak for es, s in ((suite, 1), (suite.verticals, -1)) for e in es}
    if "a file" in peaks and suite.verticals:
        found["a file"] = found.pop("N-S")
    assert found == pytest.approx(peaks, rel=1e-6)
    assert [entry.step for entry in suite] == pytest.approx([STEP] * len(suite), rel=1e-6)


def test_utf_16_of_spreadsheets(tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_bytes((HEAD.replace(",", "\t") + rows(TIMES, NORTH, separator="\t")).encode("utf-16"))
    assert read_suite([tmp_path]).entries[0].peak == pytest.approx(0.3, rel=1e-8)


PERIODS = 0.01 * 1.02 ** np.arange(COUNT)
REFUSED: dict[str, tuple[str, dict[str, Any], str]] = {
    "a response spectrum": ("Frequency (Hz),Response (cm/s/s)\n" + rows(PERIODS, 100 + TIMES), {},
                            "column 1 (Frequency): is the abscissa of a spectrum"),
    "a target spectrum": ("Period (s),SA (g)\n" + rows(PERIODS, 1 + TIMES), {"step": STEP}, "1 (Period): is the"),
    "a spectrum without names": (rows(PERIODS, 1 + TIMES), {"units": "g", "step": STEP}, "resembles the abscissae of"),
    "minutes": ("time (min),acc (g)\n" + OF_TWO, {}, "column 1 (time): its unit 'min' is not one of s, ms, us"),
    "minutes by option": ("time (min),acc (g)\n" + OF_TWO, {"columns": "time,acceleration"}, "times are in 'min'"),
    "an unknown unit": ("time (s),acc (furlong/s2)\n" + OF_TWO, {}, "column 2 (acc): its unit 'furlong/s2' is not one"),
    "units against it": ("time (s),acc (furlong/s2)\n" + OF_TWO, {"units": "g"}, "its unit 'furlong/s2' is not one of"),
    "other units": (HEAD + OF_TWO, {"units": "gal"}, "units = cm/s2, but a file states g; leave units out"),
    "another step": (HEAD + OF_TWO, {"step": 0.05}, "step = 0.05, but a file states 0.02; leave step out"),
    "a counter": (",acc (g)\n" + rows(range(COUNT), NORTH), {}, "column 1: counts the samples; give --step"),
    "an unnamed counter": (rows(range(COUNT), NORTH), {"units": "g"}, "counts the samples; give --columns skip,acc"),
    "four columns": (rows(TIMES, NORTH, EAST, UP, separator=" "), {"units": "gal", "step": STEP},
                     "does not name its 4 columns; give --columns time,acceleration,acceleration,acceleration: one of"),
    "along lines": (rows(*NORTH.reshape(10, 6)), {"units": "g", "step": STEP}, "or wrapped if each line has several"),
    "uncorrected": ("UNCORRECTED ACCELEROGRAM DATA\n 1 2\n", {}, "uncorrected motion (volume 1): take the file of"),
    "Iranian": ("* VOL1DS FILE: 1/01\n1 2\n", {}, "uncorrected motion (volume 1)"),
    "of USC": ("FILE 1 OF UNCORRECTED ACCELEROGRAM DATA OF X\n", {}, "uncorrected motion (volume 1)"),
    "counts": ("Raw acceleration counts  (Format v01.20 with 13 text lines)\n", {}, "holds raw counts (volume 0)"),
    "GeoNet, V1A": (geonet("Uncorrected"), {}, "uncorrected motion (volume 1)"),
    "SMC, uncorrected": (smc("1 UNCORRECTED ACCELEROGRAM"), {}, "uncorrected motion (volume 1)"),
    "SMC, a spectrum": (smc("5 RESPONSE SPECTRA"), {}, "holds a spectrum"),
    "AT2 of velocity": (at2(kind="VELOCITY", unit="CM/S"), {}, "holds no acceleration"),
    "a trace of counts": (trace(unit="COUNTS"), {}, "says the unit 'COUNTS': must be one of g"),
    "commas and tabs": ("Zeit (s)\tBeschl (g)\n0,00\t0,000000\n0,02\t0,000043\n", {}, "decimal commas; write points"),
    "commas and blanks": ("0,00  1,5\n0,02 2,5\n", {}, "decimal commas; write points instead"),
    "commas alone": ("0,000000\n0,000043\n", {}, "decimal commas; write points instead"),
    "times of day": ("time,acc (g)\n01:17:00.00,0\n01:17:00.02,1\n", {}, "has times of day or dates; give --step"),
    "npts dt": ("test\n60 0.02\n" + rows(NORTH), {"units": "g"}, "below '60 0.02', which resembles a number of"),
    "npts dt and times": ("60 0.02\n" + OF_TWO, {"units": "g"}, "column 1: is below '60 0.02', which resembles a"),
    "radians a second": ("ω (rad/s),acc (g)\n" + rows(PERIODS, NORTH), {"step": STEP}, "column 1 (ω): is the abscissa"),
    "two units": ("# units: m/s2\n" + HEAD + OF_TWO, {}, "column 2 (acc): its unit is g, and 'm/s2' in the header"),
    "cut short": ("\n".join(FILES["AFAD"][0].split("\n")[:-9]), {}, "but its header says 60; is the file cut short"),
    "percent": (HEAD + "0,0.1\n0.02,3.0%\n", {}, "line 3: '3.0%': must be a number; mend or remove the line"),
    "underscore": (HEAD + "0,0\n0.1,0_1\n0.2,0\n", {}, "line 3: '0_1': must be a number"),
    "Arabic digits": (HEAD + "0,0\n0.1,\u0661\n", {}, "line 3: '\u0661': must be a number"),
    "a role": (OF_TWO, {"columns": "time,velocity"}, "must be time, acceleration, vertical, skip for each column"),
    "too many roles": (rows(PERIODS, NORTH), {"columns": "time,skip,acceleration"}, "not name its 2 columns; give"),
}  # fmt: skip


@pytest.mark.parametrize(("text", "options", "said"), REFUSED.values(), ids=REFUSED)
def test_what_is_not_a_record_is_refused_by_name(tmp_path: Path, text: str, options: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=re.escape(said)) as caught:
        read_suite([write(tmp_path, {"a file": text})], **options)
    assert "\n" not in str(caught.value)


def test_every_column_that_is_not_used_is_listed_and_strict_makes_it_an_error(tmp_path: Path) -> None:
    head = "time (s),acc (g),vel (cm/s),Temp,,\n"
    text = head + rows(TIMES, NORTH, EAST, UP).replace("\n", ",,\n")
    write(
        tmp_path, {"a.csv": text, "b.csv": HEAD + OF_TWO.replace("0.02,", "0.020,"), "c_UP.csv": HEAD + rows(TIMES, UP)}
    )
    suite = read_suite([tmp_path])
    assert [entry.name for entry in suite] == ["a.csv"]
    lines = [line.removeprefix(f"{tmp_path}/") for line in suite.reasons]
    for line, said in zip(lines, ("a.csv: column 3 (vel): its unit 'cm/s'", "a.csv: column 4 (Temp): neither its name",
                                  "a.csv: column 5: is empty", "a.csv: column 6: is empty",
                                  "b.csv: has the samples of a.csv, which counts once",
                                  "c_UP.csv: is a vertical component"), strict=True):  # fmt: skip
        assert line.startswith(said)
    with pytest.raises(ValueError, match=r"(?s)column 3 .*column 4 .*samples of a.csv.*vertical component"):
        read_suite([tmp_path], strict=True)
    roles = "time,acceleration,skip,skip,skip,skip"
    assert len(read_suite([tmp_path / "a.csv", tmp_path / "c_UP.csv"], strict=True, columns=roles)) == 1


def test_places_are_not_vertical_and_the_same_samples_count_once(tmp_path: Path) -> None:
    """Repeated samples are found in another unit or resolution; a record times 1 + 1e-5 is another record."""
    names = ("Bregenz", "Denver", "Vancouver", "backup", "group2", "Northridge_090")
    suite = read_suite(
        [write(tmp_path, {f"{n}.csv": HEAD + rows(TIMES, NORTH * (1 + k)) for k, n in enumerate(names)})]
    )
    assert (len(suite), len(suite.verticals)) == (6, 0)
    write(
        tmp_path,
        {"same.csv": "t,a (gal)\n" + rows(TIMES, GAL * NORTH), "other.csv": HEAD + rows(TIMES, NORTH * 1.00001)},
    )
    suite = read_suite([tmp_path])
    assert [unread.file for unread in suite.unread] == [str(tmp_path / "same.csv")]
    assert len(suite) == 7
    same = Suite.of({"a": Series(TIMES, NORTH, held=False), "b": Series(TIMES, NORTH, held=False)})
    assert (len(same), same.reasons) == (1, ["b: has the samples of a, which counts once"])


SLOPE = "[arc]\nradius_m = 60\ntheta_1_deg = 215\ntheta_2_deg = 280\nunit_weight_kN_m3 = 19\n[friction]\n"
SLOPE += "angle_deg = 30\n"


def test_a_record_that_drifts_is_named(tmp_path: Path, asked: Any) -> None:
    """An offset of 0.03 g for 30 s alone is 0.03 * 9.81 * 30 = 8.829 m/s at the end."""
    time: Any = np.linspace(0.0, 30.0, 301)
    constant = Series(time, np.full(301, 0.03), held=False)
    assert "its velocity at the end is 8.83 m/s, 100 % of its peak" in drift_warning(constant)

    def back_at(end: float) -> Series:  # 10.025 s g at most, and 19.4 - 10.075 s g less at 19.4 s: 6.98 % are left
        return Series(np.array([0.0, 10.0, 10.1, end]), np.array([1.0, 1.0, -1.0, -1.0]), held=False)

    assert not drift_warning(back_at(20.0))
    assert ", 6.98 % of" in drift_warning(back_at(19.4))
    write(tmp_path, {"drifts.csv": HEAD + rows(time, np.full(301, 0.03)), "none.csv": HEAD + rows(TIMES, NORTH)})
    status, _, err = asked(f"records {tmp_path}")
    assert (status, err.count("drifts"), err.count("8.83 m/s")) == (0, 2, 1)
    slope = SLOPE + "[shaking]\nrecord = 'drifts.csv'\nholds = 'ground'\n"
    assert "8.83 m/s" in " ".join(
        json.loads(asked(f"run {write(tmp_path, {'s.toml': slope}) / 's.toml'} --json")[1])[0]["warnings"]
    )


def test_columns_of_scenes_by_number_and_role(tmp_path: Path) -> None:
    slope = SLOPE + "[shaking]\nrecord = 'r.csv'\nholds = 'driving'\n"
    write(tmp_path, {"r.csv": "t (s),a (g),b (g),c (g)\n" + rows(TIMES, NORTH, EAST, UP)})
    for more, peaks in {"column = 2": [0.3], "column = '3'": [0.15], "column = 'c'": [0.075],
                        "column = 2\nvertical_column = 4": [0.3, 0.075],
                        "columns = 'time,skip,skip,acceleration'": [0.075]}.items():  # fmt: skip
        effects = load(write(tmp_path, {"s.toml": slope + more}) / "s.toml").called["shaking"]
        assert [effects[name].greatest for name in ("horizontal", "vertical")[: len(peaks)]] == pytest.approx(peaks)
    for more, said in {
        "column = 1": "shaking.column = 1: must be one of 2 (a), 3 (b), 4 (c)",
        "column = 2.5": "must be text or",
        "columns = 'time,acceleration'": "shaking.columns = 'time,acceleration': the file has 4 columns",
    }.items():
        with pytest.raises(ValueError, match=re.escape(said)):
            load(write(tmp_path, {"s.toml": slope + more}) / "s.toml")
    with pytest.raises(ValueError, match=re.escape("give column, one of 2 (a), 3 (b), 4 (c)")):
        read_record(tmp_path / "r.csv", holds="driving")


def test_damaged_files_are_read_or_refused(tmp_path: Path) -> None:
    """A hundred and fifty; `python -m tests.campaigns.fuzz_records 20000` draws others."""
    assert not fuzz_records.faults(range(150), 5, tmp_path)
