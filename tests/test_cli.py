"""The command line as a user meets it: what it prints where, its exit status, and what it loads."""

import contextlib
import hashlib
import json
import os
import re
import subprocess
import sys
import time
from dataclasses import asdict, fields
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import generated
import slipcircle
from derive import __main__ as derive_line
from slipcircle import State, load, solve
from slipcircle import __main__ as line
from slipcircle.base.optional import EXTRAS
from slipcircle.workbench.commands import COMMANDS
from slipcircle.workbench.files.shipped import find, shipped
from slipcircle.workbench.outputs.json_records import record
from slipcircle.workbench.stability.stability import factors_of_safety
from tests.support.lanes import BINARY, compiled
from tests.support.outputs import COMPUTING, columns

ROOT = Path(__file__).parents[1]
NAMES = ["vaiont-as-printed", "vaiont-frozen"]
KEYS = ["factor of safety by the paper's method", "run-out along the arc", "peak velocity", "duration",
        "range of validity"]  # fmt: skip
COLOUR = re.compile(r"\x1b\[(\d+;)*(3\d|4\d|9[0-7]|10[0-7])(;\d+)*m")
LOOK = ("COLUMNS", "LINES", "NO_COLOR", "FORCE_COLOR", "TTY_COMPATIBLE", "TTY_INTERACTIVE", "CLICOLOR")
VAIONT = find("vaiont-frozen").read_text("utf-8")
SLOPE = "[arc]\nradius_m = 60\ntheta_1_deg = 215\ntheta_2_deg = 280\nunit_weight_kN_m3 = 19\n[friction]\nangle_deg = 12"


def fresh(*argv: str, **changes: Any) -> subprocess.CompletedProcess[str]:
    """Return a fresh interpreter in which every warning is an error, without what would change the tables' look."""
    kept = {k: v for k, v in os.environ.items() if k not in LOOK}
    given: dict[str, Any] = {"env": kept, "stdout": subprocess.PIPE} | changes
    done = subprocess.run([sys.executable, "-W", "error", *argv], cwd=ROOT, stdin=subprocess.DEVNULL, text=True,
                          encoding="utf-8", check=False, stderr=subprocess.PIPE, **given)  # fmt: skip
    done.stderr = done.stderr.replace(COMPUTING, "")  # on a busy machine
    return done


# --- run -----------------------------------------------------------------------------------------------------------


def test_run_prints_a_table(said: Any) -> None:
    """Printed and right coefficients side by side; what matters most comes first."""
    out = said("run", *NAMES)
    assert max(map(len, out.splitlines())) <= 100
    assert out.split()[:2] == NAMES
    cells = columns(out)
    assert [*cells] == KEYS
    text = said("run --verbose", *NAMES)
    verbose = columns(text)
    for k, name in enumerate(NAMES):
        motion = solve(load(name))
        assert f"{name}: {motion.plan.scene.note}" in " ".join(text.split())
        assert cells["run-out along the arc"][k] == f"{motion.run_out:.4g} m"
    printed = {"Theta*": "0.43760", "A": "0.46800", "J_r": "0.08700", "lambda": "0.15230", "J_theta": "0.03870"}
    assert {label: verbose[label][0] for label in printed} == printed
    assert not {*printed} & {*cells}
    assert verbose["limit friction angle"] == ["23.98 deg", "22.74 deg"]


OBSERVED = """
[observed]
run_out_m = [300, 450]
end_displacement_m = 300
peak_velocity_m_s = 20
duration_s = [0, 45]
toe_rise_m = [126, 154]
"""


@pytest.mark.parametrize("name", ["vaiont", "vaiont-rate", "real-slope", "shaken-slope", "layered-slope"])
def test_a_motion_is_printed_on_twelve_lines(name: str, tmp_path: Path, said: Any) -> None:
    """Twelve lines suffice with every observation, for a swing, a searched circle and a slide that leaves the range."""
    scene = tmp_path / "a.toml"
    text = find(name).read_text("utf-8").partition("[observed]")[0]
    for more in ("", OBSERVED):
        scene.write_text(text + more, "utf-8")
        out = said("run", scene)
        assert len(out.rstrip().splitlines()) <= 12
        cells, motion = columns(out), solve(load(scene))
        factors = factors_of_safety(motion.plan.scene) if "ground" in text else {"paper": motion.factor_of_safety}
        label = "factor of safety by " + ("Bishop's method" if "ground" in text else "the paper's method")
        assert next(iter(cells.items())) == (label, [f"{factors.get('bishop', factors['paper']):.4g}"])
        assert cells["range of validity"] == [
            f"left after {motion.range_end.time:.3g} s, {motion.range_end.displacement:.3g} m"
            if motion.range_end
            else "kept throughout"
        ]
        assert len([text for (text,) in cells.values() if "observed" in text]) == 5 * bool(more)


def test_json_has_full_precision(records: Any) -> None:
    """The very numbers of the motion's record, which `test_printed_motions` holds."""
    for found, name in zip(records("run", *NAMES), NAMES, strict=True):
        motion = solve(load(name))
        assert found == {"format": "slipcircle-json-1"} | json.loads(json.dumps(record(motion)))
        assert list(found["end"]) == [f.name for f in fields(State)]
        assert found["dimensionless"] == asdict(motion.plan.scene.arc.dimensionless)


@pytest.mark.parametrize("asked_for", ["plan vaiont", "sensitivity vaiont", "search real-slope",
                                       "sweep vaiont --grid friction.angle_deg=8,10"])  # fmt: skip
def test_json_is_a_list_in_every_command(asked_for: str, records: Any) -> None:
    assert [next(iter(record)) for record in records(asked_for)] == ["format"]


def test_times_of_the_rows(tmp_path: Path, said: Any, refused: Any, asked: Any) -> None:
    table = tmp_path / "m.csv"
    said("run wet-slope --times 0:60:0.5 --csv", table)
    assert np.loadtxt(table, delimiter=",", skiprows=1)[:, 0].tolist() == [0.5 * k for k in range(121)]
    said("run wet-slope --csv", table)
    even = np.loadtxt(table, delimiter=",", skiprows=1)[:, 0]
    assert np.allclose(even, np.linspace(0.0, solve(load("wet-slope")).duration, 401))
    for wrong in ("0:60", "60:0:1", "0:60:0", "0:60:1e-9", "a:b:c", "-1:5:1"):
        status, _, err = asked("run wet-slope --csv", table, f"--times={wrong}")
        assert status == 2
        assert "must be FROM:TO:STEP in s" in err
    assert "give --csv FILE as well" in refused("run wet-slope --times 0:1:1")


def test_slopes_at_the_limits_of_the_method(tmp_path: Path, said: Any, asked: Any) -> None:
    """An accuracy beyond float64's, a level arc, friction above the limit, uplift."""
    path = tmp_path / "slope.toml"

    def slope(before: str = "", more: str = "", **changed: object) -> Path:
        text = f"{before}{SLOPE}\n[rotation]\n{more}"
        for key, value in changed.items():
            text = re.sub(rf"{key} = .*", f"{key} = {value}", text)
        path.write_text(text, "utf-8")
        return path

    warning = asked("run", slope("accuracy = 1e-30\n"))[2]
    assert "float64 does not allow a smaller error" in warning
    assert "friction is next" not in warning
    assert columns(said("run", slope(theta_1_deg=260)))["factor of safety by the paper's method"] == ["infinite"]
    assert "after 0 s" not in "".join(asked("run", slope(angle_deg=42))[1:])
    status, out, _ = asked("run", slope(more="[pore_pressure]\npressure_kPa = 500\n"))
    assert status == 1 or "still moving" not in out


def test_names_are_whole_however_many_scenes(tmp_path: Path, said: Any) -> None:
    paths = [tmp_path / f"the-north-slope-of-the-reservoir-{k}.toml" for k in range(6)]
    for path in paths:
        path.write_text(VAIONT.replace("vaiont-frozen", path.stem), "utf-8")
    out = said("run", *paths)
    assert max(map(len, out.splitlines())) <= 100
    assert all(path.stem in out for path in paths)


def test_a_name_is_anybodys_text(tmp_path: Path, said: Any, refused: Any) -> None:
    scene = tmp_path / "a.toml"
    text = VAIONT.replace('name = "vaiont-frozen"', 'name = "[/b] [red]:warning: \\u001b[31m"')
    scene.write_text(text, "utf-8")
    out = said("run", scene)
    assert "[/b] [red]:warning: \N{REPLACEMENT CHARACTER}[31m" in out
    assert "\x1b" not in out
    scene.write_text(text.replace("radius_m = 1492.6", "radius_m = -1"), "utf-8")
    assert "\x1b" not in refused("run", scene)
    scene.write_text("a = " + 99999 * "[", "utf-8")
    assert refused("run", scene)
    assert "is a folder" in refused("run", tmp_path)


NOTHING = re.compile(r"(?<![\w.])-0(?:\.0*)?(?:e[-+]?\d+)?(?![.\d])")  # a negative zero
MANY_DIGITS = re.compile(r"\d\.\d{9}|\.0{7}")  # that nobody reads


@pytest.mark.parametrize("name", shipped())
@pytest.mark.usefixtures("unseen")
def test_no_command_prints_a_negative_zero(name: str, tmp_path: Path, asked: Any) -> None:
    """Tables, CSV, JSON and reports; tables without more digits than people read."""
    key = "friction.angle_deg" if isinstance(load(name).friction, float) else "friction.peak_deg"
    drawn = f"--uncertain {key}=normal:22:1 --uncertain initial_velocity_m_s=normal:0:0.01"
    drawn += " --samples 32 --seed 1 --sensitivity 8"
    report = f"--csv {tmp_path}/a.csv --report {tmp_path}/a.html"
    lines = [f"run {name} --verbose {report}", f"run {name} --json"]
    if name in ("newmark-pulse", "wet-slope"):
        lines += [f"sweep {name} --grid {key}=5,20,44 --csv {tmp_path}/b.csv", f"sweep {name} {drawn} {report}",
                  f"backanalyse {name} --field {key} --run-out-m 20+-1", f"plan {name} --ladder"]  # fmt: skip
    if name == "wet-slope":
        lines += ["search real-slope", "sensitivity real-slope"]
    for words in lines:
        _, out, err = asked(words)
        assert "--json" in words or not MANY_DIGITS.search(out), words
        made = [p.read_text("utf-8") for p in tmp_path.iterdir()]
        for text in (out, err, *made):
            assert not NOTHING.search(text), (words, NOTHING.search(text))


# --- terminals -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("width", "more"), [(80, {}), (160, {"NO_COLOR": "1"})], ids=["colour", "NO_COLOR"])
def test_in_a_terminal(width: int, more: dict[str, str]) -> None:
    """Output is as wide as the terminal, up to 120 columns, and coloured unless NO_COLOR is set."""
    reader, writer = pytest.importorskip("pty").openpty()
    look = {k: v for k, v in os.environ.items() if k not in LOOK} | {"TERM": "xterm-256color", "COLUMNS": str(width)}
    shown = b""
    with os.fdopen(reader, "rb", buffering=0) as terminal:
        done = fresh("-m", "slipcircle", "run", "vaiont", stdout=writer, env=look | more)
        os.close(writer)
        with contextlib.suppress(OSError):  # how Linux says that the other side is closed
            while block := terminal.read(65536):
                shown += block
    assert (done.returncode, done.stderr) == (0, "")
    assert bool(COLOUR.search(shown.decode())) == (not more)
    plain = re.sub(r"\x1b\[[0-9;]*m", "", shown.decode())
    assert "vaiont" in plain
    assert max(len(row.rstrip("\r")) for row in plain.split("\n")) <= min(width, 120)


def test_no_environment_variable_makes_a_pipe_wide_or_narrow(monkeypatch: pytest.MonkeyPatch, said: Any) -> None:
    for name in LOOK:
        monkeypatch.delenv(name, raising=False)
    plain = said("run", *NAMES)
    assert "\x1b" not in plain
    for width in ("40", "400"):
        monkeypatch.setenv("COLUMNS", width)
        assert said("run", *NAMES) == plain


def test_no_command_is_silent(monkeypatch: pytest.MonkeyPatch, capsys: Any) -> None:
    """Whatever it computes; and a quick one prints nothing."""
    assert line.SILENT <= 2.0
    for silent, seconds, expected in ((0.01, 0.5, COMPUTING), (3600.0, 0.0, ""), (0.2, 0.0, "")):
        monkeypatch.setattr(line, "main", lambda seconds=seconds: time.sleep(seconds))
        monkeypatch.setattr(line, "SILENT", silent)
        with pytest.raises(SystemExit):
            line.command()
        time.sleep(0.3 if silent == 0.2 else 0.0)  # it is not said of what is done
        assert capsys.readouterr().err == expected


# --- errors --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("words", "status", "told"),
    [
        (
            "run vaiont-frozen viaont",
            1,
            "scene 'viaont' is unknown; known are layered-slope, newmark-pulse, real-slope",
        ),
        ("run viaont --json", 1, "scene 'viaont' is unknown"),
        (
            "backanalyse wet-slope",
            1,
            "give one of --run-out-m, --end-displacement-m, --peak-velocity-m-s, --duration-s",
        ),
        ("backanalyse vaiont --duration-s -5", 1, "duration = -5.0: must be a positive number"),
        ("backanalyse vaiont --run-out-m abc", 2, "abc: must be a number (400), a number with its error"),
        ("backanalyse vaiont --run-out-m 0.3:0.45km", 2, "--run-out-m: 0.3:0.45km: must be a number (400), a number"),
        ("backanalyse vaiont --reach-m 450", 2, "--reach-m: was removed; use --run-out-m"),
        ("backanalyse vaiont --run-out-m 450:300", 1, "run_out = Interval(low=450.0, high=300.0): must be a"),
        ("cost polar", 1, "scene 'polar' is unknown; known are layered-slope"),
        ("run", 2, "required: SCENE"),
        ("ruin", 2, "'ruin'"),
        ("run vaiont-frozen --jsno", 2, "--jsno"),
        ("info all", 2, "all"),
    ],
)
def test_wrong_input_and_wrong_calls_have_their_exit_status(
    words: str, status: int, told: str, asked: Any, refused: Any
) -> None:
    """Status 1 for input that is refused, in one line, 2 for a wrong call; stdout stays empty."""
    found, out, err = asked(words)
    assert (found, out) == (status, "")
    assert told in (refused(words) if status == 1 else err)


@pytest.mark.parametrize(("words", "reads", "told"), [
    ("schema", "| true", ""), ("run vaiont --json", "> /dev/full", "No space left"),
])  # fmt: skip
def test_a_reader_that_stops_reading(words: str, reads: str, told: str) -> None:
    command = f"{sys.executable} -m slipcircle {words} {reads}; exit ${{PIPESTATUS[0]}}"
    done = subprocess.run(["bash", "-c", command], cwd=ROOT, capture_output=True, text=True, check=False, timeout=60)
    assert (done.returncode, done.stdout) == (1, "")
    assert told in done.stderr
    assert done.stderr.replace(COMPUTING, "").count("\n") == (told != "")


@pytest.mark.parametrize(("words", "status"), [
    ("run vaiont >&-", 0), ("run vaiont 2>&-", 0), ("run viaont 2>&-", 1), ("--help >&- 2>&-", 0), ("ruin >&- 2>&-", 2),
])  # fmt: skip
def test_closed_streams(words: str, status: int) -> None:
    """Output to a closed stream is lost, and nothing of it goes to the other stream."""
    command = f"{sys.executable} -m slipcircle {words}"
    done = subprocess.run(["bash", "-c", command], cwd=ROOT, capture_output=True, text=True, check=False, timeout=60)
    assert (done.returncode, done.stderr.replace(COMPUTING, "")) == (status, "")
    assert bool(done.stdout) == (words == "run vaiont 2>&-")


@pytest.mark.parametrize("stream", [None, SimpleNamespace(write=lambda text: None, flush=lambda: None)])
def test_streams_that_are_absent_or_know_no_terminal(stream: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """Commands run without streams or with plain ones, as in windowed programs and some editors."""
    monkeypatch.setattr(sys, "stdout", stream)
    monkeypatch.setattr(sys, "stderr", stream)
    for words in ("run vaiont", "sweep vaiont --grid friction.angle_deg=8,10", "run viaont"):
        assert line.main(words.split()) == ("viaont" in words)


LOADING = """
import builtins, os, runpy, signal, sys
original = builtins.__import__
def interrupted(name, *rest, **named):
    if name == {0!r}:
        os.kill(os.getpid(), signal.SIGINT)
    return original(name, *rest, **named)
builtins.__import__ = interrupted
signal.signal(signal.SIGINT, signal.default_int_handler)
sys.argv = ["slipcircle", "run", "vaiont"]
from slipcircle.__main__ import command
command()
"""


@pytest.mark.parametrize("module", ["numpy", "argparse", "slipcircle.workbench.common.trace"])
def test_ctrl_c_while_modules_load(module: str) -> None:
    """Ctrl-C ends imports of the package, of the program and of the command with one line."""
    done = fresh("-c", LOADING.format(module))
    assert (done.returncode, done.stdout, done.stderr.strip()) == (130, "", "slipcircle: interrupted")


def test_help_says_what_there_is_and_how_it_ends(said: Any) -> None:
    """Commands have their own help with a sentence; the first help lists scenes and exit status, in 100 columns."""
    assert {*COMMANDS} >= {"new", "run", "plan", "sweep", "records", "backanalyse", "sensitivity", "search", "info"}
    for name in ("", *COMMANDS):
        text = said(name, "--help")
        assert text.startswith(f"usage: slipcircle {name}".rstrip())
        assert max(map(len, text.splitlines())) <= 100
        assert re.search(r"\n\n[A-Z][^\n]*(\n[^\n]+)*\.\n", text), name
    text = said("--help")
    assert "0 success, 1 invalid input, 2 invalid call, 130 interrupted" in text
    assert all(name in text for name in (*shipped(), *COMMANDS))
    assert said("--version") == f"slipcircle {slipcircle.__version__}\n"


LOADED = """
import sys
from contextlib import suppress
from slipcircle.__main__ import main
def commands():
    return sorted(n.rpartition(".")[2] for n in sys.modules if n.startswith("slipcircle.workbench.commands."))
for words in ("--help", "records --help"):
    with suppress(SystemExit):
        main(words.split())
    print(commands(), [n for n in ("slipcircle.workbench.files.scenefile", "scipy") if n in sys.modules])
drawn = {"theta_1_deg": "normal:215:1", "theta_2_deg": "triangular:276:277:278", "radius_m": "lognormal:1490:9"}
drawn = [f"--uncertain=arc.{key}={value}" for key, value in drawn.items()]
drawn += ["--uncertain=friction.angle_deg=uniform:9:10", "--correlation=arc.radius_m,friction.angle_deg=0.5"]
main(["sweep", "vaiont", "--samples", "64", *drawn])
print("scipy.stats" in sys.modules)
"""


def test_a_command_loads_its_own_module_and_a_study_no_distributions_of_scipy() -> None:
    """Help is to take less time than a run, and the import of scipy.stats takes longer than a small study."""
    done = fresh("-c", LOADED)
    lines = [line for line in done.stdout.splitlines() if line.startswith(("[", "True", "False"))]
    assert lines == ["[] []", "['records'] []", "False"], done.stderr


def test_a_scene_without_an_end_is_named_with_the_key_to_write(tmp_path: Path, refused: Any) -> None:
    path = tmp_path / "endless.toml"
    path.write_text(VAIONT.replace("end_time_s = 30", "").replace("vaiont-frozen", "endless"), "utf-8")
    for words in ("run vaiont", "plan --ladder"):
        told = refused(words, path)
        assert told.startswith("slipcircle: endless: end_time_s: this slide never rests")
        assert "give end_time_s" in told


ALONE = """
import contextlib, io, json, sys
import numpy
bare = set(sys.modules)
hidden = "scipy matplotlib rich dask distributed pydantic mpmath sympy flint".split()
sys.modules.update(dict.fromkeys(hidden))
from slipcircle.__main__ import main
def told(line):
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        return line, main(line.split()), out.getvalue(), err.getvalue()
works, needs = (text.split("\\n") for text in sys.argv[1:])
done = [told(line) for line in works]
from slipcircle import load, solve
for name in ("newmark-pulse", "vaiont-heated", "vaiont-rate", "vaiont-frozen", "wet-slope"):
    m = solve(load(name)); m.at([0, 1]); m.energy; m.error_estimate
loaded = {name.partition(".")[0] for name in set(sys.modules) - bare - set(hidden)} - sys.stdlib_module_names
assert "slipcircle.workbench.outputs.pictures.plots" not in sys.modules  # nothing was drawn
from slipcircle.core.motion import solver
solver.motion_of = None  # so that nothing can be computed
try:
    m.plot()
except ImportError as error:
    drawn = str(error)
print(json.dumps([done, sorted(loaded), [told(line) for line in needs], drawn]))
"""
CREEP = f"end_time_s = 1e6\n{SLOPE}\n[rotation]\n[viscosity]\nviscosity_Pa_s = 1e10\nthickness_m = 0.1\n"


def test_on_numpy_alone(tmp_path: Path) -> None:
    """Tables, JSON and CSV load nothing else, of a creep too; what needs an extra says which before it computes."""
    (tmp_path / "creep.toml").write_text(CREEP, "utf-8")
    works = [f"run {tmp_path}/creep.toml --csv {tmp_path}/creep.csv", "run vaiont --verbose", "info", "schema",
             "run vaiont --json", "plan vaiont", "info --json"]  # fmt: skip
    (tmp_path / "q.csv").write_text(
        "time_s,a_m_s2\n" + "".join(f"{0.01 * k},{k % 7 - 3}\n" for k in range(500)), "utf-8"
    )
    missing = {
        f"run vaiont --plot {tmp_path}/a.png": "matplotlib plot",
        f"run vaiont --report {tmp_path}/a.html": "matplotlib plot",
        "sweep vaiont --samples 9 --uncertain friction.angle_deg=normal:10:1": "scipy scenes",
        f"sweep newmark-pulse --records {tmp_path}/q.csv": "scipy scenes",
        "backanalyse vaiont --run-out-m 400+-20 --duration-s 40+-5 --field friction.angle_deg=5:20": "scipy scenes",
        "sweep vaiont --grid friction.angle_deg=8,10 --scheduler tcp://127.0.0.1:1": "distributed dask",
        "cost polar_moment --json": "python-flint derive", f"cost --plot {tmp_path}/a.png": "matplotlib plot",
    }  # fmt: skip
    done = fresh("-c", ALONE, "\n".join(works), "\n".join(missing))
    assert (done.returncode, done.stderr) == (0, "")
    worked, loaded, needed, drawn = json.loads(done.stdout)
    for words, status, out, err in worked:
        assert (status, out.count("\n") > 5) == (0, True), words
        # Where it takes longer than a moment, and what it has written.
        assert re.fullmatch(r"(1 of 1 scenes solved.*\n)?(slipcircle: wrote .*\n)?", err), words
    assert (tmp_path / "creep.csv").exists()
    assert {*loaded} <= {"numpy", "slipcircle", "generated"}
    for words, status, out, err in needed:
        assert (status, out) == (1, "")
        package, extra = missing[words].split()
        assert re.fullmatch(rf"slipcircle: {package} is needed for .+: pip install 'slipcircle\[{extra}\]'\n", err), err
        assert EXTRAS[package] == extra
    assert re.fullmatch(r"matplotlib is needed for .+: pip install 'slipcircle\[plot\]'", drawn)
    assert [p.name for p in tmp_path.glob("a.*")] == []


def test_info_lists_versions_speed_and_digests(said: Any) -> None:
    facts = json.loads(said("info --json"))
    assert facts.pop("format") == "slipcircle-json-1"
    scene, factor = map(float, re.findall(r"([\d.]+) us a scene .* ([\d.]+) times", facts.pop("speed"))[0])
    assert scene > 0
    assert factor > 2 if BINARY else 0.3 < factor < 3
    lanes = re.search(r"^compiled \((?:GCC|Clang) [\d.]+(?:, shipped)?\), \w+, (\d) lanes, ", facts["integrator"])
    assert (lanes and int(lanes[1])) == (BINARY and {"avx512": 8, "avx2": 4, "baseline": 2}[compiled.level()])
    assert (facts["slipcircle"], facts["numpy"]) == (slipcircle.__version__, np.__version__)
    assert facts["python"] == sys.version.split()[0]
    for path in Path(generated.__path__[0]).glob("*.py"):
        digest = f"sha256 {hashlib.sha256(path.read_bytes()).hexdigest()}"
        assert digest[:23] == facts[f"generated/{path.name}"][:23]
    text = said("info")
    assert all(re.search(rf"{re.escape(key)} +{re.escape(value)}", text) for key, value in facts.items())


@pytest.mark.parametrize(
    ("option", "ending"), [("--csv x.xlsx", ".csv"), ("--npz x.csv", ".npz"), ("--report x.pdf", ".html")]
)
def test_files_in_formats_that_are_not_written(option: str, ending: str, tmp_path: Path, refused: Any) -> None:
    flag, name = option.split()
    command = "sweep vaiont --samples 2 --uncertain friction.angle_deg=normal:10:1"
    told = refused(f"{command} {flag}", tmp_path / name)
    assert told.endswith(f"{name}: cannot be written in this format; give a name that ends in {ending}\n")
    assert not [*tmp_path.iterdir()]


def test_every_file_that_is_written_is_named(tmp_path: Path, asked: Any) -> None:
    table, page = tmp_path / "a.csv", tmp_path / "a.html"
    status, _, err = asked("run vaiont --csv", table, "--live", page)
    assert (status, err.splitlines()) == (0, [f"slipcircle: wrote {table}", f"slipcircle: wrote {page}"])
    assert asked("run vaiont --csv /dev/null")[2] == ""


@pytest.mark.parametrize("name", ["", *derive_line.COMMANDS])
def test_every_command_of_derive_has_help(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit, match="0"):
        derive_line.main([*filter(None, [name]), "--help"])
    assert capsys.readouterr().out.startswith(f"usage: python -m derive {name}".rstrip())
