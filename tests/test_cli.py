"""The command line as a user meets it: what it prints where, its exit status, and what it loads."""

import hashlib
import json
import os
import re
import subprocess
import sys
from dataclasses import asdict, fields
from pathlib import Path
from typing import Any

import numpy as np
import oracle
import pytest

import generated
import slipcircle
from slipcircle import Motion, State, load, solve
from slipcircle.__main__ import main
from slipcircle.cost import cost
from slipcircle.files.scenefile import find, shipped
from slipcircle.motion.quantities import digits_left, shown

ROOT = Path(__file__).parents[1]
NAMES = ["vaiont-as-printed", "vaiont-frozen"]
COLOUR = re.compile(r"\x1b\[[0-9;]*\b(3[0-9]|4[0-9]|9[0-7]|10[0-7])\b[0-9;]*m")
MAIN = "from slipcircle.__main__ import main; status = main(sys.argv[1:])"


def environment(**changes: str) -> dict[str, str]:
    """This one without what would change the tables' look."""
    look = ("COLUMNS", "LINES", "NO_COLOR", "FORCE_COLOR", "TTY_COMPATIBLE", "TTY_INTERACTIVE", "CLICOLOR")
    return {k: v for k, v in os.environ.items() if k not in look} | changes


def command(*argv: str, **changes: str) -> subprocess.CompletedProcess[str]:
    """Run `python -m slipcircle` in a fresh interpreter in which every warning is an error."""
    return subprocess.run(
        [sys.executable, "-W", "error", "-m", "slipcircle", *argv], cwd=ROOT, env=environment(**changes),
        capture_output=True, text=True, encoding="utf-8", stdin=subprocess.DEVNULL, check=False,
    )  # fmt: skip


def python(code: str, *argv: str) -> subprocess.CompletedProcess[str]:
    """Run code in a fresh interpreter, with `sys` imported."""
    return subprocess.run(
        [sys.executable, "-W", "error", "-c", f"import sys; {code}", *argv], cwd=ROOT, env=environment(),
        capture_output=True, text=True, encoding="utf-8", stdin=subprocess.DEVNULL, check=False,
    )  # fmt: skip


def strict(text: str) -> Any:
    """JSON as its standard has it: no NaN, no Infinity."""

    def refuse(constant: str) -> None:
        raise ValueError(constant)

    return json.loads(text, parse_constant=refuse)


# --- run -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("names", [NAMES[:1], NAMES[1:], NAMES], ids="-and-".join)
def test_run_prints_a_table(names: list[str]) -> None:
    done = command("run", *names)
    assert (done.returncode, done.stderr) == (0, "")
    assert "\x1b" not in done.stdout
    lines = done.stdout.splitlines()
    assert max(map(len, lines)) <= 100
    assert lines[0].split() == names
    text = " ".join(done.stdout.split())
    cells = columns(done.stdout)
    for k, name in enumerate(names):
        motion = solve(load(name))
        assert f"{name}: {motion.plan.scene.note}" in text
        assert cells["peak velocity"][k] == f"{motion.peak.velocity:.2f} m/s"
        assert cells["run-out along the arc"][k] == f"{motion.run_out:.4g} m"
    assert [*cells][:2] == ["moves", "comes to rest"]  # what matters most comes first
    assert "Theta*" not in cells


def columns(table: str) -> dict[str, list[str]]:
    """The cells of a table by the label of their row."""
    found = (re.split(r"  +", line) for line in table.splitlines() if "  " in line.strip())
    return {label: cells for label, *cells in found if label}


def test_the_table_shows_the_papers_numbers(capsys: pytest.CaptureFixture[str]) -> None:
    """Printed and right coefficients side by side, each in its column."""
    assert main(["run", "--verbose", *NAMES]) == 0
    cells = columns(capsys.readouterr().out)
    theta_1, theta_2 = float(np.deg2rad(215.2)), float(np.deg2rad(276.9))
    half = (theta_2 - theta_1) / 2
    right = {
        "Theta*": oracle.kernel("moment_of_inertia", half), "A": oracle.kernel("dynamic_coefficient", half),
        "J_r": oracle.whole("radial_weight", theta_1, theta_2)[0], "lambda": oracle.kernel("resistance_factor", half),
        "J_theta": oracle.whole("weight_moment", theta_1, theta_2)[0],
    }  # fmt: skip
    printed = {"Theta*": "0.43760", "A": "0.46800", "J_r": "0.08700", "lambda": "0.15230", "J_theta": "0.03870"}
    for label, value in right.items():
        assert cells[label] == [printed[label], f"{float(value):.5f}"]
    assert cells["limit friction angle"] == ["23.98 deg", "22.74 deg"]
    assert cells["friction angle"] == ["10 deg", "10 deg"]
    assert cells["mean normal stress at the start"] == ["2.413 MPa", "2.413 MPa"]
    assert cells["effects"] == ["centripetal", "centripetal"]


def check_record(record: dict[str, Any], motion: Motion) -> None:
    """Full precision, SI units and radians: the very numbers of `solve`."""
    scene = motion.plan.scene
    assert record["scene"] == scene.name
    assert record["effects"] == ["centripetal"]
    assert record["friction"] == pytest.approx(float(np.tan(np.deg2rad(10.0))), rel=1e-15)
    assert record["limit_friction"] == scene.arc.dimensionless.limit_friction
    assert record["dimensionless"] == asdict(scene.arc.dimensionless)
    assert (record["moves"], record["arrested"]) == (True, False)
    assert record["duration"] == motion.duration == 30.0
    assert record["run_out"] == motion.run_out
    for moment in ("reach", "peak", "end"):
        assert record[moment] == asdict(getattr(motion, moment))
        assert list(record[moment]) == [f.name for f in fields(State)]
        assert record[moment]["displacement"] == 1492.6 * record[moment]["rotation"]  # m and rad
    energy = motion.energy
    assert record["energy"] == asdict(energy) | {"residual": energy.residual}


def test_json_is_a_list_whatever_the_number_of_scenes(capsys: pytest.CaptureFixture[str]) -> None:
    for names in (NAMES[:1], NAMES):
        assert main(["run", "--json", *names]) == 0
        records = strict(capsys.readouterr().out)
        assert len(records) == len(names)
        for record, name in zip(records, names, strict=True):
            check_record(record, solve(load(name)))
    for argv in (["plan", "vaiont"], ["plan", "--all"]):
        assert main([*argv, "--json"]) == 0
        assert isinstance(strict(capsys.readouterr().out), list)


def test_a_scene_at_rest_prints_too(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    vaiont = (Path(slipcircle.__file__).parent / "scenes" / "vaiont-frozen.toml").read_text("utf-8")
    still = tmp_path / "still.toml"
    still.write_text(vaiont.replace("angle_deg = 10", "coefficient = 0.9"), "utf-8")
    assert main(["run", str(still), "--json"]) == 0
    (record,) = strict(capsys.readouterr().out)
    assert (record["moves"], record["arrested"], record["duration"], record["run_out"]) == (False, True, 0.0, 0.0)
    assert main(["run", str(still)]) == 0
    shown = capsys.readouterr().out
    assert re.search(r"moves +no\b", shown)
    assert re.search(r"comes to rest +yes\b", shown)


def test_where_it_swings_back_the_table_and_a_warning_say_so(capsys: pytest.CaptureFixture[str]) -> None:
    """The slide of Vaiont with a friction that falls with the speed turns back at 953 m and rests at 574 m."""
    assert main(["run", "vaiont-rate"]) == 0
    out, err = capsys.readouterr()
    assert columns(out)["greatest displacement"] == ["953 m"]
    assert columns(out)["run-out along the arc"] == ["573.8 m"]
    assert "swings back: it reaches 953 m after 38.44 s, farther than its run-out of 573.8 m" in err
    assert main(["run", "vaiont"]) == 0
    assert "swings back" not in capsys.readouterr().err


def test_times_of_the_rows(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table = tmp_path / "m.csv"

    def times(*more: str) -> list[float]:
        assert main(["run", "wet-slope", "--json", "--csv", str(table), *more]) == 0
        return [float(line.partition(",")[0]) for line in table.read_text("utf-8").splitlines()[1:]]

    assert times("--times", "0:60:0.5") == [0.5 * k for k in range(121)]
    even = times()
    assert np.allclose(np.diff(even), even[-1] / 400)
    capsys.readouterr()
    for wrong in ("0:60", "60:0:1", "0:60:0", "0:60:1e-9", "a:b:c", "-1:5:1"):
        with pytest.raises(SystemExit, match="2"):
            main(["run", "wet-slope", "--csv", str(table), f"--times={wrong}"])
        assert "must be FROM:TO:STEP in s" in capsys.readouterr().err
    assert main(["run", "wet-slope", "--times", "0:1:1"]) == 1
    assert "give --csv FILE as well" in capsys.readouterr().err


def test_names_are_whole_however_many_scenes(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text, names = find("vaiont-frozen").read_text("utf-8"), []
    for k in range(6):
        names.append(f"the-north-slope-of-the-reservoir-{k}")
        (tmp_path / f"{k}.toml").write_text(text.replace("vaiont-frozen", names[-1]), "utf-8")
    assert main(["run", *(str(tmp_path / f"{k}.toml") for k in range(6))]) == 0
    out = capsys.readouterr().out
    assert max(map(len, out.splitlines())) <= 100
    table, _, captions = out.rpartition("\n\n")
    assert all(name in table and f"{name}: " in " ".join(captions.split()) for name in names)


def test_a_table_has_no_more_digits_than_the_error_leaves() -> None:
    assert [digits_left(x) for x in (0.0, 1e-9, 4e-4, 6e-4, 0.004, 0.04, 0.4, 1.0)] == [4, 4, 3, 2, 2, 1, 1, 1]
    assert [shown(x) for x in (0.43284, 12345.6, 1e-7, 0.0, -0.0, 1020.35, 1.5e9)] == [
        "0.4328", "12350", "1e-07", "0", "0", "1020", "1.5e+09"]  # fmt: skip
    assert [shown(27.9721, n) for n in (1, 2, 3)] == ["30", "28", "28"]
    assert shown(float("inf")) == "infinite"


def test_version(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit, match="0"):
        main(["--version"])
    assert capsys.readouterr().out == f"slipcircle {slipcircle.__version__}\n"


# --- terminals -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("colour", [{}, {"NO_COLOR": "1"}], ids=["colour", "NO_COLOR"])
@pytest.mark.parametrize("width", [80, 160])
def test_in_a_terminal(width: int, colour: dict[str, str]) -> None:
    """As wide as the terminal, up to 100 columns; no colour where none is wanted."""
    pty = pytest.importorskip("pty")
    reader, writer = pty.openpty()
    with os.fdopen(reader, "rb", buffering=0) as terminal:
        done = subprocess.run(
            [sys.executable, "-m", "slipcircle", "run", "vaiont-frozen"],
            cwd=ROOT,
            env=environment(TERM="xterm-256color", COLUMNS=str(width), **colour),
            stdin=subprocess.DEVNULL,
            stdout=writer,
            stderr=subprocess.PIPE,
            check=False,
        )
        os.close(writer)
        shown = b""
        try:
            while block := terminal.read(65536):
                shown += block
        except OSError:  # how Linux says that the other side is closed
            pass
    assert (done.returncode, done.stderr) == (0, b"")
    text = shown.decode()
    if colour:
        assert not COLOUR.search(text)
    plain = re.sub(r"\x1b\[[0-9;]*m", "", text)
    assert "vaiont-frozen" in plain
    assert max(len(line.rstrip("\r")) for line in plain.split("\n")) <= min(width, 100)


def test_no_environment_variable_makes_a_pipe_wide_or_narrow() -> None:
    plain = command("run", *NAMES).stdout
    for changes in ({"COLUMNS": "40"}, {"COLUMNS": "400"}, {"NO_COLOR": "1"}, {"TERM": "dumb"}):
        assert command("run", *NAMES, **changes).stdout == plain


# --- errors --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("argv", "status", "said"),
    [
        (["run", "viaont"], 1, "scene 'viaont' is unknown; known are newmark-pulse, real-slope, vaiont"),
        (["run", "vaiont-frozen", "viaont"], 1, "scene 'viaont' is unknown"),
        (["run", "viaont", "--json"], 1, "scene 'viaont' is unknown"),
        (["backanalyse", "vaiont"], 1, "give one of --reach-m, --run-out-m, --peak-velocity-m-s, --duration-s"),
        (["cost", "polar"], 1, "function 'polar' is unknown; known are kernels, flow, polar_moment, moment_of_inertia"),
        ([], 2, "required: COMMAND"),
        (["run"], 2, "required: SCENE"),
        (["ruin"], 2, "'ruin'"),
        (["run", "vaiont-frozen", "--jsno"], 2, "--jsno"),
        (["info", "all"], 2, "all"),
    ],
)
def test_errors(argv: list[str], status: int, said: str, capsys: pytest.CaptureFixture[str]) -> None:
    """Status 1 for input that is refused, 2 for a wrong call; stdout stays empty, there is no traceback."""
    try:
        found = main(argv)
    except SystemExit as leaving:
        found = int(str(leaving.code))
    assert found == status
    out, err = capsys.readouterr()
    assert out == ""
    assert said in err
    if status == 1:
        assert err.startswith("slipcircle: ")
        assert err.count("\n") == 1


def test_a_name_is_anybodys_text(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene = tmp_path / "a.toml"
    text = find("vaiont").read_text("utf-8").replace('name = "vaiont"', 'name = "[/b] [red]:warning: \\u001b[31m"')
    scene.write_text(text, "utf-8")
    assert main(["run", str(scene)]) == 0
    out, _ = capsys.readouterr()
    assert "[/b] [red]:warning: \N{REPLACEMENT CHARACTER}[31m" in out
    assert "\x1b" not in out
    scene.write_text(text.replace("radius_m = 1492.6", "radius_m = -1"), "utf-8")
    assert main(["run", str(scene)]) == 1
    assert "\x1b" not in capsys.readouterr().err
    scene.write_text("a = " + 99999 * "[", "utf-8")
    assert main(["run", str(scene)]) == 1
    assert main(["run", str(tmp_path)]) == 1
    assert "is a folder" in capsys.readouterr().err


@pytest.mark.parametrize(("reads", "said"), [("| true", ""), ("> /dev/full", "No space left on device")])
@pytest.mark.parametrize("what", ["schema", "run vaiont", "run vaiont --json", "plan --all"])
def test_a_reader_that_stops_reading(what: str, reads: str, said: str) -> None:
    line = f"{sys.executable} -m slipcircle {what} {reads}; exit ${{PIPESTATUS[0]}}"
    done = subprocess.run(["bash", "-c", line], cwd=ROOT, capture_output=True, text=True, check=False, timeout=60)
    assert (done.returncode, done.stdout) == (1, "")
    assert said in done.stderr
    assert done.stderr.count("\n") == (said != "")


def test_help_says_what_there_is_and_how_it_ends(capsys: pytest.CaptureFixture[str]) -> None:
    """Every command has its own help and a sentence; scenes and exit status stand in the first; within 100 columns."""
    said = {}
    for name in ("", "run", "plan", "sweep", "backanalyse", "sensitivity", "search", "schema", "cost", "info"):
        with pytest.raises(SystemExit, match="0"):
            main([*name.split(), "--help"])
        said[name] = capsys.readouterr().out
        assert max(map(len, said[name].splitlines())) <= 100
        assert re.search(r"\n\n[A-Z][^\n]*(\n[^\n]+)*\.\n", said[name]), name
    assert "0 done, 1 the input was refused, 2 a wrong call, 130 interrupted" in said[""]
    assert all(name in said[""] for name in (*shipped(), *said))


def test_a_scene_without_an_end_is_named_with_the_key_to_write(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = (Path(slipcircle.__file__).parent / "scenes" / "vaiont-frozen.toml").read_text("utf-8")
    path = tmp_path / "endless.toml"
    path.write_text(text.replace("end_time_s = 30", "").replace("vaiont-frozen", "endless"), "utf-8")
    for argv in (["run", "vaiont", str(path)], ["plan", "--ladder", str(path)]):
        assert main(argv) == 1
        said = capsys.readouterr().err
        assert said.startswith("slipcircle: endless: end_time_s: this slide never rests")
        assert "give end_time_s" in said


def test_the_exit_status_reaches_the_shell() -> None:
    for argv, status in ((("run", "viaont"), 1), (("run",), 2), (("info", "--json"), 0), (("--help",), 0)):
        done = command(*argv)
        assert done.returncode == status
        assert (done.stdout == "") == (status != 0)
        assert (done.stderr == "") == (status == 0)
        assert "Traceback" not in done.stderr


def test_tables_need_numpy_alone() -> None:
    """What an extra would be needed for is not touched by a table of a scene that ships."""
    hidden = "".join(f"sys.modules[{x!r}] = None; " for x in ("rich", "scipy", "pydantic", "matplotlib"))
    for argv in (["run", "vaiont-frozen"], ["plan", "vaiont"], ["info"]):
        done = python(f"{hidden}{MAIN}; sys.exit(status)", *argv)
        assert (done.returncode, done.stderr) == (0, "")
        assert len(done.stdout.splitlines()) > 5


def test_without_flint_cost_says_what_to_type() -> None:
    done = python(f"sys.modules['flint'] = None; {MAIN}; sys.exit(status)", "cost", "--json")
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == "slipcircle: the reference needs python-flint: pip install 'slipcircle[derive]'\n"


# --- what is loaded ------------------------------------------------------------------------------------------------


def loaded(code: str, *argv: str) -> set[str]:
    """Top-level modules that are loaded after the code."""
    done = python(f"{code}; print(*sys.modules, file=sys.stderr)", *argv)
    assert done.returncode == 0, done.stderr
    return {name.partition(".")[0] for name in done.stderr.split()} - sys.stdlib_module_names


def test_solving_a_frozen_scene_loads_numpy_alone() -> None:
    ours = {"slipcircle", "generated", "__main__"}
    bare = loaded("import numpy")
    assert loaded(MAIN, "run", "vaiont-frozen", "--json") <= bare | ours
    solving = "from slipcircle import load, solve; m = solve(load('vaiont-frozen')); m.at([0, 1]); m.energy"
    assert loaded(solving) <= bare | ours
    assert loaded(MAIN, "info", "--json") <= bare | ours
    assert loaded(MAIN, "run", "vaiont-frozen", "--verbose") <= bare | ours
    assert "matplotlib" in loaded("import matplotlib")  # this test would see it


# --- info and cost -------------------------------------------------------------------------------------------------


def test_info() -> None:
    done = command("info", "--json")
    facts = strict(done.stdout)
    assert facts["slipcircle"] == slipcircle.__version__
    assert facts["numpy"] == np.__version__
    assert facts["python"] == sys.version.split()[0]
    for path in Path(generated.__path__[0]).glob("*.py"):
        digest = hashlib.sha256(path.read_bytes()).hexdigest()
        assert facts[f"generated/{path.name}"].startswith("sha256 ")
        assert digest.startswith(facts[f"generated/{path.name}"].removeprefix("sha256 "))
        assert len(facts[f"generated/{path.name}"]) >= 23
    table = command("info")
    assert table.returncode == 0
    assert max(map(len, table.stdout.splitlines())) <= 100
    for key, value in facts.items():
        assert re.search(rf"{re.escape(key)} +{re.escape(value)}", table.stdout)


@pytest.fixture
def _quick(monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in {"SIZES": (1, 50, 400), "REPEATS": 1, "_TICK": 1e-7, "_PATIENCE": 0.0}.items():
        monkeypatch.setattr(cost, name, value)


def test_cost_of_a_way_that_fails_is_json_too(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    fails = cost.Row("f", "printed form", float("inf"), (1.5,), 3.0)
    monkeypatch.setattr(cost, "measure", lambda names, progress: [fails])
    assert main(["cost", "--json"]) == 0
    assert strict(capsys.readouterr().out)["rows"][0]["error"] is None


@pytest.mark.usefixtures("_quick")
def test_cost(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    table, picture = tmp_path / "cost.csv", tmp_path / "cost.png"
    assert main(["cost", "resistance_factor", "--json", "--csv", str(table), "--plot", str(picture)]) == 0
    out, err = capsys.readouterr()
    assert err == "measuring resistance_factor\n"
    found = strict(out)
    assert np.__version__ in found["machine"]
    ways = [row["way"] for row in found["rows"]]
    assert {"printed, float64", "half-angle, NumPy", "np.copyto (floor)"} <= set(ways)
    assert {row["function"] for row in found["rows"]} == {"resistance_factor"}
    assert table.read_text("utf-8").count("\nresistance_factor,") == len(ways)
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert main(["cost", "resistance_factor"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert max(map(len, lines)) <= 100
    for number, way in enumerate(ways, 1):
        assert any(re.match(rf"{number} +{re.escape(way)} ", line) for line in lines), way
    assert any(line.startswith("Frontier: ") for line in lines)


def test_without_matplotlib_cost_says_what_to_type() -> None:
    hidden = "sys.modules['matplotlib'] = None; from slipcircle.cost import cost; cost.measure = lambda *a, **k: []"
    done = python(f"{hidden}; {MAIN}; sys.exit(status)", "cost", "--plot", "cost.png")
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == "slipcircle: pictures need matplotlib: pip install 'slipcircle[plot]'\n"
