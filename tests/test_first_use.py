"""First use, in an empty folder and with packages missing or in the way: each time one line says what to do."""

import io
import math
import os
import re
import subprocess
import sys
import tomllib
from operator import attrgetter
from pathlib import Path
from typing import Any

import pytest
from scipy.optimize import brentq

from derive import __main__ as derive_line
from slipcircle import Arc, Scene, Slope, critical, load, solve
from slipcircle.base.optional import EXTRAS
from slipcircle.base.progress import Progress
from slipcircle.workbench.files.shipped import find, shipped
from tests.support.outputs import COMPUTING, blocks

ROOT = Path(__file__).parents[1]
EXTRA_OF = {
    table: tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]["optional-dependencies"][table]
    for table in ("scenes", "plot", "dask", "derive", "dxf")
}


def alone(folder: Path, code: str, *hidden: str, module: str = "slipcircle") -> subprocess.CompletedProcess[str]:
    """Return the output of code or of a command in a folder, with some packages that cannot be imported."""
    line = f"import sys; sys.modules.update(dict.fromkeys({list(hidden)}))\n"
    if not code.startswith("import"):
        code = (
            f"import runpy; sys.argv = {['slipcircle', *code.split()]}; runpy.run_module('{module}', None, '__main__')"
        )
    kept = os.environ | {"PYTHONPATH": str(ROOT), "SLIPCIRCLE_COMPILED": ""}
    return subprocess.run(
        [sys.executable, "-W", "error", "-c", line + code],
        cwd=folder,
        env=kept,
        capture_output=True,
        text=True,
        check=False,
    )


def test_from_nothing_to_a_page(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, said: Any, refused: Any) -> None:
    """The three things to try, typed as they are printed."""
    monkeypatch.chdir(tmp_path)
    lines = re.findall(r"^  (slipcircle .*?)  ", said(), re.MULTILINE)
    assert len(lines) == 3
    for line in lines:
        assert said(line.removeprefix("slipcircle "))
    page = Path("slope.html").read_text("utf-8")
    assert page.startswith("<!DOCTYPE html>")
    assert "slope" in page
    before = Path("slope.toml").read_bytes()
    assert "is there already; give another name, or remove it first" in refused("new slope.toml")
    assert Path("slope.toml").read_bytes() == before
    assert "; did you mean slope?" in refused("run slop.toml")
    assert "FILE no/slope.toml: there is no folder no" in refused("new no/slope.toml")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["slope.html", "slope.toml"]


@pytest.mark.parametrize("name", shipped())
def test_every_scene_that_ships_is_one_to_start_from(name: str, tmp_path: Path, said: Any) -> None:
    """Shipped scenes can be copied with its comments; the copy moves as the scene does, under its own name."""
    path = tmp_path / "my.toml"
    said("new", path, "--like", name)
    scene = load(path)
    assert scene.name == "my"
    assert solve(scene).run_out == solve(load(name)).run_out
    comments = [line for line in find(name).read_text("utf-8").splitlines() if "#" in line]
    assert {*comments} <= {*path.read_text("utf-8").splitlines()}


def test_the_tables_in_comments_of_a_new_scene_are_right(tmp_path: Path, said: Any) -> None:
    """Tables in comments of a new scene are valid without their marks, and each has its effect."""
    path = tmp_path / "my.toml"
    said("new", path)
    bare, text, tables = path.read_text("utf-8").partition("# [water]")
    path.write_text(bare + re.sub("^# ", "", text + tables, flags=re.MULTILINE), "utf-8")
    motion = solve(load(path))
    assert {"pore_pressure", "shaking", "drag"} <= {*motion.plan.effects}
    assert motion.factor_of_safety < solve(load("real-slope")).factor_of_safety


def test_a_newer_scene_file_is_refused(tmp_path: Path, said: Any, refused: Any) -> None:
    path = tmp_path / "my.toml"
    said("new", path)
    path.write_text(path.read_text("utf-8").replace("scene-1", "scene-2"), "utf-8")
    assert 'format = "slipcircle-scene-2": must be slipcircle-scene-1' in refused("run", path)


def test_deriving_without_a_package(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Missing packages are named, and no others; the proofs of the bounds need flint alone."""
    every = ("sympy", "mpmath", "flint")
    sentence = "python -m derive needs {}: pip install 'slipcircle[derive]'\n"
    done = alone(tmp_path, "verify", *every, module="derive")
    assert (done.returncode, done.stdout, done.stderr) == (2, "", sentence.format("sympy and mpmath and flint"))
    for words, hidden, missing in (
        ("", ("sympy", "flint"), "sympy and flint"),
        ("prove", every, "flint"),
        *(("verify", (package,), package) for package in every),
    ):
        with monkeypatch.context() as without:
            for package in hidden:
                without.setitem(sys.modules, package, None)
            assert derive_line.main(words.split()) == 2
        assert capsys.readouterr() == ("", sentence.format(missing))


def test_info_says_how_each_missing_package_is_installed(tmp_path: Path) -> None:
    """Missing packages belong to the extra that its command names."""
    code = "import importlib.metadata as m; real = m.version; "
    code += "m.version = lambda name: real(name) if name == 'numpy' else m.distribution('no-' + name); "
    code += "from slipcircle.__main__ import main; main(['info'])"
    done = alone(tmp_path, code)
    told = dict(re.findall(r"^(\S+) +not installed: pip install 'slipcircle\[(\w+)\]'$", done.stdout, re.MULTILINE))
    assert len(told) == len(EXTRAS) > 7, done.stderr
    for package, extra in told.items():
        assert any(re.match(rf"{package}\b", requirement) for requirement in EXTRA_OF[extra]), package


def test_without_rich_the_progress_is_a_line(monkeypatch: pytest.MonkeyPatch) -> None:
    """A bar is no result: nothing is said of its package, and the line is on the terminal."""
    terminal = io.StringIO()
    monkeypatch.setattr(terminal, "isatty", lambda: True)
    monkeypatch.setitem(sys.modules, "rich", None)
    with Progress(4, "scenes solved", terminal) as count:
        count.pause = 0
        count(2)
    assert "2 of 4 scenes solved" in terminal.getvalue()


def test_without_numpy(tmp_path: Path) -> None:
    done = alone(tmp_path, "run vaiont", "numpy")
    assert (done.returncode, done.stdout) == (1, "")
    *_, last = done.stderr.splitlines()
    assert last == "ImportError: slipcircle needs NumPy: pip install numpy"


@pytest.mark.parametrize(
    ("changes", "message"),
    [("import sys; sys.version_info = (3, 10, 2)", "Python 3.11 or later, and this is 3.10"),
     ("import sys; sys.version_info = (3, 8, 18); sys.modules['numpy'] = sys.modules['generated'] = None",
      "Python 3.11 or later, and this is 3.8"),
     ("import numpy; numpy.__version__ = '2.0.3'", "NumPy 2.1 or later, and this is 2.0.3"),
     ("import sys, numpy; numpy.__version__ = '1.26.4'; sys.modules['generated'] = None",
      "NumPy 2.1 or later, and this is 1.26.4")],
)  # fmt: skip
def test_unsupported_versions_are_named(changes: str, message: str, tmp_path: Path) -> None:
    """The least versions are those of the project's metadata."""
    name, least, *_ = message.split()
    declared = {"Python": 'requires-python = ">=', "NumPy": 'dependencies = ["numpy>='}[name]
    assert f'\n{declared}{least}"' in (ROOT / "pyproject.toml").read_text("utf-8")
    done = alone(tmp_path, f"{changes}; import slipcircle")
    assert done.returncode == 1
    assert done.stderr.splitlines()[-1] == f"ImportError: slipcircle needs {message}"


@pytest.mark.parametrize("text", ["", "__project__ = 'another'\n", "import no_such_module\n", "1 +\n"])
def test_another_package_called_generated(text: str, tmp_path: Path) -> None:
    """The message names the package in the way, its place and the remedy."""
    foreign = tmp_path / "generated" / "__init__.py"
    foreign.parent.mkdir()
    foreign.write_text(text, "utf-8")
    done = alone(tmp_path, f"import sys; sys.path.insert(0, {str(tmp_path)!r}); import slipcircle")
    *_, last = done.stderr.splitlines()
    assert last.startswith(f"ImportError: slipcircle needs its package 'generated', and Python finds {foreign}: "), last
    assert last.endswith("rename that one or start in another folder; or install slipcircle again")


def test_the_program_is_not_in_the_way_of_a_folder(tmp_path: Path) -> None:
    """Folders of these names where one happens to be: the program runs, and `info` tells of a foreign `derive`."""
    for name in ("generated", "derive"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "__init__.py").write_text("", "utf-8")
    program = Path(sys.executable).with_name("slipcircle")
    kept = os.environ | {"PYTHONPATH": ""}
    run = subprocess.run(
        [program, "run", "vaiont"], cwd=tmp_path, env=kept, capture_output=True, text=True, check=False
    )
    assert (run.returncode, run.stderr.replace(COMPUTING, "")) == (0, "")
    (tmp_path / "generated" / "__init__.py").unlink()
    (tmp_path / "generated").rmdir()
    done = alone(tmp_path, f"import sys; sys.path.insert(0, {str(tmp_path)!r}); import slipcircle.__main__ as m; "
                 "m.main(['run', 'vaiont']); m.main(['info'])")  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert "run-out along the arc" in done.stdout
    told = " ".join(done.stdout.split())
    assert f"in the way is {tmp_path}/derive/__init__.py: rename it, or start in another folder" in told


# --- a law of the user's own -----------------------------------------------------------------------------------------

(OWN,) = blocks((ROOT / "notebooks/extending.md").read_text("utf-8"), "python")


def test_a_law_declared_outside_of_the_package(tmp_path: Path) -> None:
    """The page's program, run as it is in another folder, with the compiled integrator and with NumPy alone."""
    assert len([line for line in OWN.splitlines() if line.strip()]) < 25
    (tmp_path / "my_law.py").write_text(OWN, "utf-8")
    (shown,) = re.findall(r"^# (.*)", OWN, re.MULTILINE)
    for compiled in ("", "0"):
        kept = os.environ | {"SLIPCIRCLE_COMPILED": compiled, "PYTHONPATH": ""}
        done = subprocess.run([sys.executable, "my_law.py"], cwd=tmp_path, env=kept, capture_output=True, text=True,
                              check=False)  # fmt: skip
        assert (done.returncode, done.stdout, done.stderr) == (0, f"{shown}\n", "")
    assert [path.name for path in tmp_path.iterdir()] == ["my_law.py"]


def test_a_law_of_ones_own_stops_where_its_work_says() -> None:
    """A frozen mass rests where its mean friction is the limit friction, an integral in closed form."""
    names: dict[str, Any] = {"__name__": "my_law"}
    exec(OWN.partition("\nlaw = ")[0], names)
    law = names["HardeningSoftening"](start=0.30, residual=0.45, rise=0.10, length=40.0)
    arc = Arc(radius=1492.6, theta_1=math.radians(215.2), theta_2=math.radians(276.9), unit_weight=20e3)

    def surplus(slip: float) -> float:
        x, over = slip / law.length, law.start - law.residual
        work = law.residual * x + (over + law.rise) - (over + law.rise + law.rise * x) * math.exp(-x)
        return x * math.tan(arc.limit_friction_angle) - work

    slips = [slip for slip in range(1, 400) if surplus(slip) * surplus(slip + 1) < 0.0]
    motion = solve(Scene(arc, law, []))
    assert motion.run_out == pytest.approx(brentq(surplus, slips[0], slips[0] + 1, xtol=1e-13), rel=1e-12)


def test_a_built_in_law_declared_so_is_as_accurate() -> None:
    """The exponential law by name, whose numbers other tests hold against 30 digits."""
    arc, effects = load("vaiont").arc, ["rotation", "centripetal"]
    named = solve(Scene(arc, {"law": "exponential", "peak": 0.35, "residual": 0.1, "length": 20.0}, effects))
    own = solve(Scene(arc, lambda slip: 0.1 + 0.25 * math.e ** (-slip / 20.0), effects))
    for name in ("run_out", "duration", "end.displacement", "peak.velocity"):
        assert attrgetter(name)(own) == pytest.approx(attrgetter(name)(named), rel=2e-14), name


PROFILE = "Station (ft),Elevation (ft)\n0,60\n60,60\n140,20\n180,20\n"
IN_FEET = """
[ground]
points_file = "section.csv"
unit_weight_pcf = 120
[circle]
critical = "bishop"
[friction]
angle_deg = 17
[cohesion]
cohesion_psf = 60
[rotation]
[centripetal]
"""
IN_PYTHON = """\
import numpy as np
from pint import UnitRegistry
from slipcircle import Slope, critical, solve
unit = UnitRegistry()
ground = np.loadtxt("section.csv", delimiter=",", skiprows=1) * unit.ft
soil = {"unit_weight": unit("120 lbf/ft^3"), "friction": np.tan(np.radians(17)), "cohesion": unit("60 lbf/ft^2")}
motion = solve(critical(Slope(ground, **soil)).scene(["rotation", "centripetal"]))
motion.plot("slide.png")
"""


def test_from_a_profile_in_feet_to_a_run_out_a_report_and_a_page(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, records: Any, request: pytest.FixtureRequest
) -> None:
    """Three commands and five keys, or eight lines of Python; the same slope in metres moves as far."""
    monkeypatch.chdir(tmp_path)
    Path("section.csv").write_text(PROFILE, "utf-8")
    Path("slope.toml").write_text(IN_FEET, "utf-8")
    assert sum("=" in line for line in IN_FEET.splitlines()) == 5
    foot, pound = 0.3048, 4.4482216152605  # exact, by definition
    points = [[float(number) * foot for number in line.split(",")] for line in PROFILE.splitlines()[1:]]
    soil: dict[str, Any] = {"unit_weight": 120.0 * pound / foot**3, "cohesion": 60.0 * pound / foot**2}
    circle = critical(Slope(points, friction=math.tan(math.radians(17.0)), **soil))
    wanted = solve(circle.scene(["rotation", "centripetal"]))
    assert wanted.moves
    assert len(IN_PYTHON.splitlines()) <= 8
    names: dict[str, Any] = {}
    exec(IN_PYTHON, names)
    assert names["motion"].run_out == pytest.approx(wanted.run_out, rel=1e-7)
    assert Path("slide.png").read_bytes().startswith(b"\x89PNG")
    request.getfixturevalue("unseen")
    (found,) = records("search slope.toml")
    assert found["factor_of_safety"] == pytest.approx(circle.factor_of_safety, rel=1e-9)
    (found,) = records("run slope.toml --report report.html --live page.html")
    assert found["run_out"] == pytest.approx(wanted.run_out, rel=1e-7)
    for page in ("report.html", "page.html"):
        assert Path(page).read_text("utf-8").startswith("<!DOCTYPE html>")
