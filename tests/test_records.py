"""Series, pulses and record files: exact values and integrals, the common formats, a clear error for each mistake."""

import math
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from slipcircle import Record, Scene, load, solve
from slipcircle.tables import Pulse, Series
from slipcircle.workbench.records import recordfiles
from slipcircle.workbench.records.records import read_record
from tests.support.recordfiles import NORTH, TIME, at2, cosmos, csmip, esm, knet, read_pore_pressure, smc


def write(folder: Path, text: str, name: str = "record.txt") -> Path:
    path = folder / name
    path.write_text(text, "utf-8")
    return path


# --- files that are good -------------------------------------------------------------------------------------------


SIZES = "NPTS=  60, DT=   .0200 SEC,"


@pytest.mark.parametrize("line", [SIZES, "    60    0.0200    NPTS, DT", "NPTS=60, DT= 2.0E-2"])
def test_at2(tmp_path: Path, line: str) -> None:
    series = read_record(write(tmp_path, at2().replace(SIZES, line), "x.AT2"), holds="driving")
    assert series.values == pytest.approx(NORTH, rel=1e-7)
    assert series.time == pytest.approx(TIME, rel=1e-15)
    assert not series.held


TABLES = {
    "time (s),acc (m/s^2)\n0,1\n0.5,-2\n": {},
    "time [s];acc [m/s2]\n0;1\n0.5;-2\n\n": {},
    "# site 7\n# t a\n0 1\n0.5 -2": {"units": "m/s2"},
    "0,1\r\n0.5,-2\r\n": {"units": "m/s2", "columns": "time,acceleration"},
    "t\ta (mm/s2)\n0\t1000\n0.5\t-2000\n": {},
    "time (s),a (M/S**2)\n0,1\n0.5,-2\n": {},
    "time (s),a (cm/s²)\n0,100\n0.5,-200\n": {},
    "time_s,acceleration_m_s2\n0,1.0D+00\n0.5,-2d0\n": {},
    "time (s),NS (cm/s2),EW (cm/s2)\n0,7,100\n0.5,8,-200\n": {"column": "EW"},
    "time (s),NS (gal),EW (gal)\n0,7,100\n0.5,8,-200\n": {"column": 3},
    "a (m/s2)\n1\n-2\n": {"step": 0.5},
    "1\n-2\n": {"step": 0.5, "units": "m/s2"},
    "a (m/s2), time (s)\n1,3\n-2,3.5\n": {"start": 0.0},
    "\ufefftime (s),acc (m/s2)\n0,1\n0.5,-2\n": {},
    "Time (s),Acceleration (g's)\n0,0.1\n0.5,-0.2\n": {},
    "Time (s),Acceleration (%g)\n0,10\n0.5,-20\n": {},
    "# Kobe, 1995\ntime_s,acc_g\n0,0.1\n0.5,-0.2\n": {},
    "# Kobe, 1995\n0,0.1\n0.5,-0.2\n": {"units": "g", "columns": ["time", "acceleration"]},
    "1995,1,17\n0,0.1\n0.5,-0.2\n": {"units": "g", "columns": "time,acceleration"},
    "time_s,acc_g\n0,0.1\n# lost\n% x, 3\n0.5,-0.2\n": {},
    "time_s,acc_g,\n0,0.1,\n0.5,-0.2,\n": {},
    '"time_s","acc_g"\n"0","0.1"\n"0.5","-0.2"\n': {},
    "0.1 -0.2\n": {"units": "g", "step": 0.5, "columns": "wrapped"},
    "Kobe 1995\n! several a line\n0.1 -0.2 0.3 0.1\n0.2\n": {"units": "g", "step": 0.5, "columns": "wrapped"},
}


@pytest.mark.parametrize(("text", "more"), TABLES.items(), ids=range(len(TABLES)))
def test_tables_of_every_kind(tmp_path: Path, text: str, more: dict[str, Any]) -> None:
    series = read_record(write(tmp_path, text), holds="driving", gravity=10.0, **more)
    assert series.values[:2] == pytest.approx([0.1, -0.2], rel=1e-15)
    assert series.time[:2].tolist() == [0.0, 0.5]
    assert len(series.time) == (5 if "several" in text else 2)


def test_ground_and_driving_are_opposite_and_g_is_the_scene_s(tmp_path: Path) -> None:
    path = write(tmp_path, "time (s),acc (g)\n0,0.25\n1,0\n")
    ground, driving = (read_record(path, holds=h, gravity=9.0) for h in ("ground", "driving"))
    assert driving.values.tolist() == [0.25, 0.0]
    assert ground.values.tolist() == [-0.25, 0.0]


HEAD = "time (s),acc (g)\n"
MISTAKES: dict[str, tuple[str, dict[str, Any], str]] = {
    "empty": (" \n", {}, "is empty"),
    "no numbers": ("hello\n", {}, "has no line of numbers"),
    "one sample": (HEAD + "0,1\n", {}, "holds 1 sample:"),
    "nan": (HEAD + "0,1\n0.1,nan\n", {}, "line 3: value = nan: must be a finite number"),
    "nan below comments": (HEAD + "# a, 1\n0,0.1\n# b\n0.1,nan\n0.2,0.3\n", {}, "line 5: value = nan"),
    "repeated": (HEAD + "0,1\n0.1,2\n0.1,3\n", {}, "line 4: time = 0.1 s repeats that of the sample before, 0.1 s"),
    "decreasing": (HEAD + "0,1\n0.2,2\n0.1,3\n", {}, "line 4: time = 0.1 s comes before that of the sample before"),
    "text": (HEAD + "0,1\n0.1,oops\n", {}, "line 3: 'oops': must be a number"),
    "empty field": (HEAD + "0,1\n0.1,\n", {}, "line 3: '': must be a number"),
    "short line": (HEAD + "0,1\n0.1\n", {}, "line 3: has 1 field, where the first row has 2"),
    "decimal commas": ("t;a\n0,0;1,5\n0,1;2,5\n", {}, "line 2: '0,0;1,5': decimal commas; write points"),
    "no units": ("0,1\n0.1,-2\n", {}, "units are missing"),
    "other units": (HEAD + "0,1\n1,2\n", {"units": "gal"}, "units = 'gal', but its header says g"),
    "choice": ("t (s),a (g),b (g)\n0,1,2\n1,2,3\n", {}, "give column, one of 2 (a), 3 (b)"),
    "no such column": (HEAD + "0,1\n1,2\n", {"column": "up"}, "column = 'up': must be one of 2 (acc)"),
    "time as column": (HEAD + "0,1\n1,2\n", {"column": 1}, "column = 1: must be one of 2 (acc)"),
    "no step": ("1\n2\n", {"units": "g"}, "has one column and no times; give step"),
    "minutes": ("time (min),acc (g)\n0,1\n1,2\n", {}, "column 1 (time): its unit 'min' is not one of s, ms, us"),
    "step and times": (HEAD + "0,1\n1,2\n", {"step": 0.1}, "step = 0.1, but the file has steps of 1 s; leave it out"),
    "bad step": ("1\n2\n", {"units": "g", "step": 0.0}, "step = 0: must be a positive time in s"),
    "early": (HEAD + "-1,1\n1,2\n", {}, "line 2: time = -1.0 s: must not be before 0"),
    "gap": (HEAD + "".join(f"{t / 10},1\n" for t in range(30) if t not in (20, 21)), {},
            "line 22: time = 2.2 s comes 0.3 s after the sample before, where the step is 0.1 s: samples are missing"),
    "binary": ("a\0b", {}, "is not text"),
    "AT2 cut short": (at2().replace("=  60", "=  62"), {}, "holds 60 values, but its header says 62"),
    "AT2 without DT": (at2().replace(SIZES, "NPTS= x, DT= y"), {}, "an AT2 file must have NPTS and DT, as in 'NPTS"),
    "AT2 that stands still": (at2().replace(".0200", ".0000"), {}, "an AT2 file must have NPTS and DT"),
    "AT2 with a nan": (re.sub(r" \S+$", " NaN", at2().rstrip()), {}, "line 16: value = nan"),
    "AT2 with step": (at2(), {"step": 2.0}, "step = 2.0, but the file has steps of 0.02 s"),
    "ESM of velocity": (esm(kind="VELOCITY"), {}, "'DATA_TYPE: VELOCITY': holds no acceleration: take"),
    "ESM units": (esm().replace("cm/s^2", "count"), {}, "says the unit 'count': must be one of"),
    "ESM count": (esm().replace("NDATA: 60", "NDATA: 61"), {}, "holds 60 values, but its header says 61"),
    "K-NET without scale": (knet().replace("2000(gal)/", ""), {}, "Scale Factor as in 3920"),
    "K-NET count": (knet() + "1\n", {}, "its header says 60"),
    "CSMIP cut short": (csmip()[:1100], {}, "values, but its header says 60"),
    "SMC without a rate": (smc().replace("5.0000000E+01", "0.0000000E+00"), {}, "an SMC file must have the numbers of"),
    "COSMOS without a step": (cosmos().replace("20.000000", "99.000000"), {}, "their step as the 62nd real, in ms"),
}  # fmt: skip


# --- pore pressure -------------------------------------------------------------------------------------------------

WET = "time (s),u (kPa)\n"
WATER: dict[str, tuple[str, dict[str, Any], str, list[float]]] = {
    "kPa": (WET + "0,20\n10,30.5\n", {}, "pressure", [20e3, 30.5e3]),
    "kPa in the name": ("t;u_kPa;depth_m\n0;20;1\n10;30.5;1\n", {"column": "u"}, "pressure", [20e3, 30.5e3]),
    "Pa": ("# a piezometer\n0 2000\n10 0\n", {"units": "Pa"}, "pressure", [2000.0, 0.0]),
    "MPa": ("time,u [MPa]\n0,0.02\n10,1\n", {}, "pressure", [2e4, 1e6]),
    "a ratio": ("time,water\n0,0.25\n10,0\n", {"units": "ratio"}, "ratio", [0.25, 0.0]),
    "a ratio in the header": ("time s;level (m);water (r_u)\n0;1;0.25\n10;1;0\n", {"column": 3}, "ratio", [0.25, 0.0]),
    "a step": ("20\n30.5\n", {"units": "kPa", "step": 10.0}, "pressure", [20e3, 30.5e3]),
    "later": (WET + "-5,20\n5,30.5\n", {"start": 0.0}, "pressure", [20e3, 30.5e3]),
}


@pytest.mark.parametrize(("text", "more", "kind", "values"), WATER.values(), ids=WATER)
def test_records_of_water(tmp_path: Path, text: str, more: dict[str, Any], kind: str, values: list[float]) -> None:
    ((found, series),) = read_pore_pressure(write(tmp_path, text), **more).items()
    assert found == kind
    np.testing.assert_array_equal(series.time, [0.0, 10.0])
    np.testing.assert_allclose(series.values, values, rtol=1e-15)
    assert series(-1.0) == series(0.0)  # what it was first and last holds beyond
    assert series(1e9) == series(10.0)


NO_WATER: dict[str, tuple[str, dict[str, Any], str]] = {
    "suction": (WET + "0,20\n10,-3\n", {}, "line 3: value = -3.0: must be a pressure of at least 0; mend the value"),
    "floats": ("time,water (ratio)\n0,0.2\n10,1\n", {}, "line 3: value = 1.0: must be a ratio of at least 0 and b"),
    "no units": ("time,water\n0,1\n1,2\n", {}, "units are missing: its header names none; give units, one of Pa"),
    "other units": (WET + "0,1\n1,2\n", {"units": "Pa"}, "units = 'Pa', but its header says kPa"),
    "days": ("time_d,u (kPa)\n0,1\n1,2\n", {}, "column 1 (time): its unit 'd' is not one of s, ms, us; give"),
    "choice": ("t,P1 (kPa),P2 (kPa)\n0,1,2\n1,2,3\n", {}, "several columns of pore pressure; give column, one of 2 (P"),
    "words": (WET, {}, "a record has a line of time and pore pressure for each sample"),
    "gap": (WET + "".join(f"{t},1\n" for t in range(30) if t != 20), {}, "line 22: time = 21.0 s comes 2 s after"),
    "an earthquake": (at2(), {"units": "kPa"}, "holds 12 values, but its header says 60"),
    "binary": ("a\0b", {}, "is not text; save the record as CSV"),
}  # fmt: skip


ALL: dict[str, Any] = {
    name: (read_record, (text, more | {"holds": "driving"}, said)) for name, (text, more, said) in MISTAKES.items()
}
ALL |= {f"water, {name}": (read_pore_pressure, row) for name, row in NO_WATER.items()}


@pytest.mark.parametrize(("read", "row"), ALL.values(), ids=ALL)
def test_one_clear_error(tmp_path: Path, read: Any, row: tuple[str, dict[str, Any], str]) -> None:
    text, more, said = row
    path = write(tmp_path, text)
    with pytest.raises(ValueError) as caught:  # noqa: PT011
        read(path, **more)
    assert said in str(caught.value)
    assert str(caught.value).startswith(str(path))
    assert "\n" not in str(caught.value)


def test_missing_and_huge_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = write(tmp_path, HEAD + "0,1\n1,2\n")
    with pytest.raises(ValueError, match=r"none\.csv: No such file"):
        read_record(tmp_path / "none.csv", holds="driving")
    with pytest.raises(ValueError, match="holds = 'both': must be"):
        read_record(path, holds="both")  # type: ignore[arg-type]
    monkeypatch.setattr(recordfiles, "MOST_BYTES", 10)
    with pytest.raises(ValueError, match="must be at most 0 MB"):
        read_record(path, holds="driving")


def test_a_gap_may_be_bridged_and_uneven_samples_have_none(tmp_path: Path) -> None:
    series = read_record(write(tmp_path, MISTAKES["gap"][0]), holds="driving", gaps="linear")
    assert series(2.05) == 1.0
    assert read_pore_pressure(write(tmp_path, NO_WATER["gap"][0]), gaps="linear")["pressure"](20.0) == 1e3
    uneven = HEAD + "".join(f"{t**2},1\n" for t in range(30))
    assert read_record(write(tmp_path, uneven), holds="driving").time.size == 30


# --- in scenes -----------------------------------------------------------------------------------------------------

ARC: Any = load("vaiont").arc
TURNING: dict[str, Any] = {"rotation": {}, "centripetal": {}}


SLOPE = "[arc]\nradius_m = 60\ntheta_1_deg = 215\ntheta_2_deg = 280\nunit_weight_kN_m3 = 19\n{}[friction]\n"


def test_a_record_of_water_in_a_file_beside_the_scene(tmp_path: Path) -> None:
    (tmp_path / "data").mkdir()
    water = write(tmp_path / "data", "time (s),upper (kPa),lower (kPa)\n0,0,0\n50,1000,2000\n100,0,0\n", "water.csv")
    head = "[arc]\nradius_m = 1492.6\ntheta_1_deg = 215.2\ntheta_2_deg = 276.9\nunit_weight_kN_m3 = 20\n"
    head += "[friction]\ncoefficient = 0.6\n[rotation]\n[centripetal]\n[pore_pressure]\n"
    scene = load(write(tmp_path, head + "record = 'data/water.csv'\ncolumn = 'lower'\n", "scene.toml"))
    arrays = {"time": [0, 50, 100], "pressure": [0, 2e6, 0]}
    motions = [
        solve(replace(scene, effects=TURNING | {"pore_pressure": pressure}))
        for pressure in (scene.called["pore_pressure"], arrays, read_pore_pressure(water, column="lower"))
    ]
    assert len({(m.run_out, m.duration) for m in motions}) == 1
    for more, words in {
        "record = 'data/water.csv'\n": "give pore_pressure.column, one of 2 (upper), 3 (lower)",
        "record = 'data/water.csv'\ncolumn = 'lower'\npressure_kPa = 1\n": "pressure_kPa and record exclude",
        "column = 'lower'\nratio = 0.1\n": "pore_pressure.column: applies to a record; remove it, or give record",
        "column = 'lower'\n": "ratio or pressure_kPa or record is missing",
        "record = 1\n": "pore_pressure.record = 1: must be text",
    }.items():
        with pytest.raises(ValueError, match=re.escape(words)):
            load(write(tmp_path, head + more, "scene.toml"))


@pytest.mark.parametrize(
    ("arc", "shaking", "words"),
    [
        ("gravity_m_s2 = { distribution = 'uniform', low = 1, high = 9 }\n", "holds = 'ground'", "arc.gravity_m_s2: m"),
        ("", "", 'must say whether it holds "ground" or "driving"'),
        ("", "holds = 'ground'\npulse = 'sine'", "exclude each other"),
        ("", "holds = 'ground'\ncycles = 2", "shaking.cycles: does not belong to a record"),
        ("", "holds = 'ground'\nvertical_record = 'nowhere.csv'", "nowhere.csv"),
        ("", "holds = 'ground'\nrecord = 'one.csv'", "has one column and no times; give shaking.step_s, the time"),
    ],
)
def test_a_file_says_what_its_record_is(tmp_path: Path, arc: str, shaking: str, words: str) -> None:
    write(tmp_path, "time s,acc m/s2\n0,0\n1,-1.962\n2,0\n", "r.csv")
    write(tmp_path, "0\n1\n", "one.csv")
    shaking += "" if "one.csv" in shaking else "\nrecord = 'r.csv'"
    text = f"{SLOPE.format(arc)}angle_deg = 30\n[shaking]\nunits = 'm/s2'\n{shaking}\n"
    with pytest.raises(ValueError, match=re.escape(words)):
        load(write(tmp_path, text, "s.toml"))


T, A = np.arange(0.0, 2.0, 0.5), np.array([0.0, 0.1, -0.2, 0.0])


def test_records_of_arrays() -> None:
    for record in (Record(T, A), Record(981 * A, dt=0.5, units="gal"), Record(-A, dt=0.5, holds="ground"),
                   Record(A * 3.7, dt=0.5, units="m/s2", gravity=3.7)):  # fmt: skip
        assert (record.time.tolist(), record.held) == (T.tolist(), False)
        assert record.values == pytest.approx(A, rel=1e-15)


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: Record(A), "give Record(t, a), or Record(a, dt=0.01)"),
        (lambda: Record(T, A, dt=0.5), "give Record(t, a), or Record(a, dt=0.01)"),
        (lambda: Record(T, A, units="ft/s"), "units = 'ft/s': must be one of g"),
        (lambda: Record(T, 2800 * A), "560 g, and no ground has shaken with more than 5 g; was it in cm/s2"),
        (
            lambda: Record(T, 28e6 * A, units="gal"),
            "5708 g, and no ground has shaken with more than 5 g; is it unscaled",
        ),
        (lambda: Scene(ARC, 0.5, {"shaking": {"horizontal": Series(T, 2800 * A)}}), "horizontal reaches 560 g"),
        (lambda: Scene(ARC, 0.5, {"shaking": {"horizontal": (np.zeros(9999), np.ones(9999))}}), "such as Record(t, a)"),
        (lambda: Scene(ARC, 0.5, {"shaking": {"horizontal": {"t": [0.0] * 999}}}), "must be a function of time"),
    ],
)
def test_a_record_that_cannot_be_is_one_sentence(make: Any, said: str) -> None:
    with pytest.raises(ValueError, match=re.escape(said)) as caught:
        make()
    assert len(str(caught.value)) < 300
    assert "\n" not in str(caught.value)


def test_a_peak_scales_a_record_of_any_size() -> None:
    shaking = {"horizontal": Series(T, 2800 * A, held=False), "peak": 0.4}
    assert Scene(ARC, 0.5, {"shaking": shaking}).numbers["shaking.peak"] == pytest.approx(0.4)


def test_lanes_may_have_one_gravity() -> None:
    assert Scene(replace(ARC, gravity=np.empty(0)), 0.5, TURNING).shape == (0,)


def test_series_is_straight_between_samples_and_held_or_zero_outside() -> None:
    held, zero = (Series([1.0, 2.0, 4.0], [3.0, 5.0, -1.0], h) for h in (True, False))  # type: ignore[arg-type]
    assert held([0.0, 1.5, 3.0, 9.0]).tolist() == [3.0, 4.0, 2.0, -1.0]
    assert zero([0.0, 1.5, 3.0, 9.0]).tolist() == [0.0, 4.0, 2.0, 0.0]
    assert zero.kinks.tolist() == [1.0, 2.0, 4.0]


@pytest.mark.parametrize(
    ("kind", "given", "said"),
    [
        (Series, ([0.0], [1.0]), "1 times and 1 values: must have equal numbers of both, two at least"),
        (Series, ([[0.0, 1.0]], [[1.0, 2.0]]), "must be a plain list of numbers"),
        (Series, ([0.0, 1.0, 1.0], [1.0, 2.0, 3.0]), "sample 3: time = 1.0 s repeats"),
        (Series, ([0.0, 1.0], [1.0, math.nan]), "sample 2: value = nan"),
        (Pulse, ("sine", 1.0, -1.0, 1.0), "start = -1: must be a time in s, not before 0"),
        (Pulse, ("sine", 1.0, 0.0, 1.0, 0.0), "cycles = 0: must be a number of waves above 0"),
        (Pulse, ("half-sine", 1.0, 0.0, 1.0, 2.0), "cycles = 2.0: applies to a sine only"),
        (Pulse, ("sine", [1.0, 2.0], 0.0, 1.0), "amplitude = [1.0, 2.0]: must be one number"),
    ],
)
def test_series_and_pulses_refuse(kind: Any, given: Any, said: str) -> None:
    with pytest.raises(ValueError, match=r"^(Series|Pulse): ") as caught:
        kind(*given)
    assert said in str(caught.value)
