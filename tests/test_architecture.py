"""House rules: what may import what, what a wheel holds, and that the linters are silent."""

import ast
import io
import os
import subprocess
import sys
import sysconfig
import tokenize
import tomllib
import zipfile
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import replace
from graphlib import TopologicalSorter
from importlib import import_module
from pathlib import Path
from typing import Any
from unittest.mock import Mock

import pytest

from derive import build
from slipcircle import Motion, Section, load, solve
from slipcircle.core import lazy
from slipcircle.core.problem.plan import build_program
from tests.support.layered import of_each_soil
from tests.support.sources import parsed

ROOT = Path(__file__).parents[1]
PACKAGES = ("derive", "generated", "slipcircle")
HEAVY = {"sympy", "scipy", "mpmath", "flint", "matplotlib", "dask", "distributed", "pydantic", "rich"}


def succeed(*command: str | Path, cwd: Path = ROOT) -> str:
    """Return the output of a command that must succeed; what it says is the failure's text."""
    done = subprocess.run(command, cwd=cwd, capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False)
    if done.returncode:
        pytest.fail(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}", pytrace=False)
    return done.stdout


def python(code: str, *argv: str | Path, cwd: Path = ROOT) -> str:
    """Run code in a fresh interpreter that sees what is installed, and no more (-I: not even where it starts)."""
    return succeed(sys.executable, "-I", "-c", code, *argv, cwd=cwd)


def sources(package: str) -> list[Path]:
    """Return the modules of a package; templates are parts of `generated` and are checked there."""
    return sorted(path for path in (ROOT / package).rglob("*.py") if "templates" not in path.parts)


# --- linters -------------------------------------------------------------------------------------------------------


def test_ruff_is_silent() -> None:
    succeed(sys.executable, "-m", "ruff", "check", *PACKAGES, "tests")


# Garbage collections take a fourth of mypy's time. Its cache makes the next run a hundred times as fast.
MYPY = """
import gc
gc.set_threshold = lambda *_: None
gc.enable = gc.disable
gc.disable()
from mypy.__main__ import console_entry
console_entry()
"""


def test_mypy_is_silent() -> None:
    succeed(sys.executable, "-c", MYPY, *PACKAGES, "tests")


def test_no_test_module_imports_another() -> None:
    """Shared parts of test modules are in `tests.support`."""
    modules = {path.stem for path in (ROOT / "tests").glob("*.py")} - {"__init__"}
    for path in (ROOT / "tests").rglob("*.py"):
        for node in parsed(path)[1]:
            imported = [alias.name for alias in node.names] if isinstance(node, ast.Import | ast.ImportFrom) else []
            imported += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            assert not modules & {part for name in imported for part in name.split(".")}, path


@pytest.mark.parametrize("script", ["run", ".ci/run"])
def test_scripts_are_posix_shell_and_executable(script: str) -> None:
    succeed("sh", "-n", script)
    assert os.access(ROOT / script, os.X_OK)


# --- imports -------------------------------------------------------------------------------------------------------


def imported(path: Path) -> Iterator[tuple[str, set[str]]]:
    """Return all modules that a file imports anywhere, and the names from each, with relative imports resolved."""
    for node in parsed(path)[1]:
        match node:
            case ast.Import(names=names):
                yield from ((alias.name, set()) for alias in names)
            case ast.ImportFrom(module=str(module), names=names, level=0):
                yield module, {alias.name for alias in names}


def called(path: Path) -> Iterator[str]:
    """Modules that it imports by a call."""
    for node in parsed(path)[1]:
        if isinstance(node, ast.Call) and node.args and isinstance(node.args[0], ast.Constant):
            name = getattr(node.func, "attr", getattr(node.func, "id", ""))
            if name in ("import_module", "__import__", "run_module"):
                yield str(node.args[0].value)


FORBIDDEN = {"derive": {"generated", "slipcircle"}, "slipcircle": {"derive"}, "generated": {"derive", "slipcircle"}}


@pytest.mark.parametrize("package", PACKAGES)
def test_imports_go_one_way(package: str) -> None:
    assert sources(package)
    for path in sources(package):
        names = {name.partition(".")[0] for name in (*(module for module, _ in imported(path)), *called(path))}
        assert not names & FORBIDDEN[package], path
        if path.parent.name in ("check", "theorem"):  # a proof leans on nothing that is proved
            sums = {"numpy"} if path.name == "midpoints.py" else set()  # of a third of a billion polynomials
            assert names <= {"derive", "flint", *sums, *sys.stdlib_module_names}, path
        assert package != "generated" or names <= {"generated", "numpy", *sys.stdlib_module_names}, path


# Packages that only some scenes need. Each may import the packages before it.
LAZY = ("tree", "tabulated", "history", "tables", "ground", "layers", "stiff", "derivatives", "messages")
_FOLDERS = ("stability", "common", "suites", "records", "files", "studies", "cost", "outputs.pictures", "outputs.page")
WORKBENCH = ("workbench", *(f"workbench.{folder}" for folder in (*_FOLDERS, "outputs", "commands")))
# Folders and modules of each package, from what needs nothing of it to what nothing in it needs.
LAYERS = {
    "derive": (
        *(
            "__init__",
            "kinds",
            "progress",
            "stages",
            "check",
            "theorem",
            "declare",
            "algebra",
            "code",
            "approximate",
            "flow",
            "generate",
        ),
        *("judge", "build", "build_hook", "wheels", "guards", "__main__"),
    ),
    "generated": (
        *("definitions", "effects", "flow", "layout", "series", "program", "integrator", "tiers", "_evaluate"),
        *("_compiled", "kernels", "printed", "slopes", "__init__"),
    ),
    "slipcircle": ("kernels", "base", "core", *LAZY, *WORKBENCH, "__init__", "__main__"),
}


def graph(package: str) -> dict[str, set[str]]:
    """Return the imports of each module within its package; a folder's own modules are its contents."""
    names = (".".join(path.relative_to(ROOT).with_suffix("").parts) for path in sources(package))
    paths = dict(zip((name.removesuffix(".__init__") for name in names), sources(package), strict=True))
    found: dict[str, set[str]] = {}
    for name, path in paths.items():
        for module, names_of in imported(path):
            of = {f"{module}.{x}" for x in names_of}
            found.setdefault(name, set()).update(of if of and of <= set(paths) else of | {module})
    return {name: found.get(name, set()) & set(paths) - {name} for name in paths}


def layer(name: str) -> int:
    """Return the index of a module in the layers of its package."""
    package, _, rest = name.partition(".")
    parts = rest.split(".") if rest else ["__init__"]
    folders = (".".join(parts[:end]) for end in range(len(parts), 0, -1))
    return LAYERS[package].index(next(folder for folder in folders if folder in LAYERS[package]))


@pytest.mark.parametrize("package", LAYERS)
def test_imports_go_down_the_layers_without_a_circle(package: str) -> None:
    """Lazy and typing imports included."""
    found = graph(package)
    assert not {(name, x) for name, of in found.items() for x in of if layer(x) > layer(name)}
    TopologicalSorter(found).prepare()  # CycleError names a circle


def test_the_workbench_uses_public_names_of_the_core_and_its_rooms_alone() -> None:
    public = {f"slipcircle.{part}": vars(import_module(f"slipcircle.{part}")) for part in ("core", *LAZY)}
    for path in (*(ROOT / "slipcircle/workbench").rglob("*.py"), ROOT / "slipcircle/__main__.py"):
        for module, names in imported(path):
            inside = next((part for part in public if module.startswith(part)), None)
            assert inside in (None, module), f"{path}: {module} is internal to {inside}"
            assert inside is None or names <= {*public[inside]["__all__"]}, path


IN_WATER = Section([(-60, 20), (0, 20), (40, 0), (120, 0)], (30, 45), 48.0, 19e3, level=[(-60, 5), (120, 5)])
GROWS = {"cohesion": 5e3, "gradient": 200.0}
CREEP = {"rotation": {}, "viscosity": {"viscosity": 1e9, "thickness": 0.5}}
# A shipped scene with changed fields, and a result of its motion, that import each lazy module.
USES: dict[str, tuple[str, dict[str, Any], Callable[[Motion], object]]] = {
    "tabulated": ("vaiont-as-printed", {}, bool),
    "tree": ("vaiont", {}, lambda motion: motion.plan.scene.numbers),
    "laws": ("vaiont-softening", {}, bool),
    "arc": ("vaiont", {}, lambda motion: replace(motion.plan.scene.arc, theta_2=0.0)),
    "section": ("real-slope", {}, lambda motion: replace(motion.plan.scene.arc, radius=1e-3)),
    "dimensionless": ("vaiont", {}, lambda motion: motion.plan.scene.arc.polar_moment),
    "limits": ("vaiont", {"friction": 0.419}, bool),
    "forcing": ("vaiont-shaken", {}, bool),
    "tables": ("newmark-pulse", {}, bool),
    "functions": ("vaiont", {"friction": lambda slip: 0.17 + 0.1 / (1.0 + slip)}, bool),
    "soils": ("layered-slope", {"arc": of_each_soil()}, bool),
    **dict.fromkeys(("ponds", "heights", "water"), ("valley-side", {}, bool)),
    "depths": ("real-slope", {"effects": {"rotation": {}, "cohesion": GROWS}}, bool),
    "standing": ("valley-side", {"arc": IN_WATER}, bool),
    "creep": ("vaiont", {"effects": CREEP}, bool),
    "beyond": ("vaiont", {"effects": CREEP, "end_time": 1e6}, bool),
    "stiff": ("vaiont", {"effects": CREEP, "end_time": 1e6}, bool),
    "plan": ("vaiont", {}, lambda motion: motion.plan.why),
    "equation": ("vaiont", {}, lambda motion: motion.plan.equation),
    "estimate": ("vaiont", {}, lambda motion: motion.error_estimate),
    "warnings": ("vaiont", {}, lambda motion: motion.warnings),
    "summary": ("vaiont", {}, repr),
    "velocity": ("vaiont", {}, lambda motion: motion.velocity_class),
    "ends": ("vaiont", {}, lambda motion: motion.peak),
    "history": ("vaiont", {}, lambda motion: motion.factor_of_safety),
    "journey": ("vaiont", {}, lambda motion: motion.journey),
    "validity": ("vaiont", {}, lambda motion: motion.outside_range),
    "toe": ("real-slope", {}, lambda motion: motion.plan.scene.arc.rotation_range),
    "refusal": ("vaiont-frozen", {"end_time": None}, bool),
    "parameters": ("vaiont", {"friction": [0.1, 0.2]}, lambda motion: motion[0]),
    "sensitivity": ("vaiont", {}, lambda motion: motion.sensitivity()),
    "plausible": ("vaiont", {"friction": 15.0}, lambda motion: motion),
}


@pytest.mark.parametrize("name", lazy.MODULES)
def test_each_lazy_module_is_imported_by_a_scene(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    scene, fields, question = USES[name]
    imports = Mock(wraps=import_module)
    monkeypatch.setattr(lazy, "import_module", imports)
    build_program.cache_clear()
    lazy.lazy_import.cache_clear()
    with suppress(ValueError):
        question(solve(replace(load(scene), **fields)))
    imports.assert_any_call(lazy.MODULES[name])


def loaded(scene: str, question: str = "") -> set[str]:
    """Return the folders of `slipcircle` that solving a scene and a question about its motion load."""
    code = f"""
import sys
import numpy as np
import slipcircle as s
arc = s.Arc(100.0, 3.7, 4.8, 20e3)
ground = [[-100, 20], [0, 20], [40, 0], [100, 0]]
s.solve(s.Scene({scene})){question}
print(*(name.split(".")[1] for name in sys.modules if name.startswith("slipcircle.")))
"""
    return {*python(code).split()} - {"base", "core", "kernels"}


def test_a_plain_scene_loads_no_lazy_package_and_a_plain_section_only_the_ground() -> None:
    assert loaded('arc, 0.1, ["rotation", "centripetal"]') == set()
    softening = {"law": "exponential", "peak": 0.3, "residual": 0.1, "length": 1.0}
    effects = {"rotation": {}, "drag": {"xi": 500.0}, "pore_pressure": {"ratio": 0.1}}
    assert loaded(f"arc, {softening}, {effects}, np.array([0.0, 1.0])") == set()
    assert loaded(f"arc, {softening} | {{'peak': np.array([0.3, 0.4])}}, {effects}") == {"tree"}
    section = "s.Section(ground, centre=[22, 38], radius=38.0, unit_weight=20e3)"
    assert loaded(f'{section}, 0.2, ["rotation"]') == {"ground"}
    assert loaded('arc, 0.1, ["rotation"]', ".error_estimate") == set()


def test_import_of_the_core_loads_no_workbench() -> None:
    """Check derivatives too, and that the core imports other packages only through `lazy_import`."""
    code = """
import sys
import slipcircle.core as core
arc = core.Arc(100.0, 3.7, 4.8, 20e3)
core.solve(core.Scene(arc, 0.1, ["rotation"])).sensitivity()
print(*(name for name in sys.modules if name.startswith("slipcircle.workbench")))
"""
    assert python(code) == "\n"
    for path in sources("slipcircle"):
        if "slipcircle/core/" in path.as_posix():
            assert all(name.startswith("generated.") for name in called(path)), f"{path} imports another package lazily"


@pytest.mark.parametrize("package", ["generated", "slipcircle"])
def test_import_loads_numpy_and_nothing_heavier(package: str) -> None:
    code = """
import sys, numpy
before = set(sys.modules)
__import__(sys.argv[1])
print(*{name.partition(".")[0] for name in set(sys.modules) - before} - sys.stdlib_module_names)
print(*{name.partition(".")[0] for name in sys.modules})
"""
    new, loaded = (set(line.split()) for line in python(code, package).splitlines())
    assert package in new
    assert new <= {"generated", "slipcircle", "numpy"}
    assert not loaded & HEAVY


def test_wheel_holds_the_three_packages_and_works_away_from_here(tmp_path: Path) -> None:
    succeed(sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", tmp_path)
    (wheel,) = tmp_path.glob("slipcircle-*.whl")
    unpacked = tmp_path / "unpacked"
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(unpacked)
        every = {n for n in archive.namelist() if ".dist-info/" not in n}
    names = {n for n in every if not n.endswith(".so")}
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    pure = wheel.name.endswith("-py3-none-any.whl")
    assert every - names == (set() if pure else {f"generated/{name}{suffix}" for name in build.MODULES})
    # Every file and no other, so that no pattern of .gitignore quietly takes one out.
    here = (path for package in PACKAGES for path in (ROOT / package).rglob("*") if path.is_file())
    built = {"__pycache__", ".ipynb_checkpoints"}
    excluded = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]["hatch"]["build"]["targets"][
        "wheel"
    ]["exclude"]
    assert names == {
        path.relative_to(ROOT).as_posix() for path in here if path.suffix != ".so" and not built & set(path.parts)
    } - {*excluded}
    code = """
import sys
from importlib import import_module
sys.path.insert(0, sys.argv[1])
print(*(import_module(name).__file__ for name in sys.argv[2:]), sep="\\n")
"""
    files = python(code, unpacked, *PACKAGES, cwd=tmp_path).splitlines()
    assert files == [str(unpacked / package / "__init__.py") for package in PACKAGES]


# --- plainness -------------------------------------------------------------------------------------------------------

# Syntax nodes a line of code, docstrings and comments apart: what holds today, a little rounded up; it only falls. The
# aims are 10.5 for the core and 12 for the rest.
DENSITY = {
    "derive": 11.2,  # since the linker, 12.0, came from the core, which was 10.3
    "slipcircle/base": 10.1,
    "slipcircle/core": 9.6,
    **{f"slipcircle/{room}": 10.9 for room in LAZY},
    "slipcircle/stiff": 11.4,
    "slipcircle/history": 11.5,  # from the core, of which it is the arithmetic
    **{f"slipcircle/{folder.replace('.', '/')}": 12.0 for folder in WORKBENCH if folder.count(".") == 1},
}


def code_lines(path: Path) -> int:
    """Lines that hold code and no docstring or comment."""
    docstrings: set[int] = set()
    text, nodes = parsed(path)
    for node in nodes:
        documented = ast.Module | ast.ClassDef | ast.FunctionDef
        if isinstance(node, documented) and ast.get_docstring(node, False) is not None:
            docstrings |= set(range(node.body[0].lineno, (node.body[0].end_lineno or 0) + 1))
    names = ("COMMENT", "NL", "NEWLINE", "INDENT", "DEDENT", "ENDMARKER")
    skipped = {getattr(tokenize, name) for name in names}
    tokens = tokenize.generate_tokens(io.StringIO(text).readline)
    code = {line for t in tokens if t.type not in skipped for line in range(t.start[0], t.end[0] + 1)}
    return len(code - docstrings)


def test_functions_and_files_fit_into_one_view() -> None:
    for package in ("derive", "slipcircle"):
        for path in sources(package):
            text, every = parsed(path)
            assert len(text.splitlines()) <= 400, path
            for node in every:
                assert not isinstance(node, ast.Module) or ast.get_docstring(node), f"{path} says not what it holds"
                if isinstance(node, ast.FunctionDef):
                    nodes, lines = sum(1 for _ in ast.walk(node)), (node.end_lineno or 0) - node.lineno + 1
                    assert nodes <= 400, f"{path}: {node.name} has {nodes} syntax nodes; split it at its thoughts"
                    assert lines <= 60, f"{path}: {node.name} has {lines} lines"


@pytest.mark.parametrize("folder", DENSITY)
def test_lines_are_no_denser_than_they_were(folder: str) -> None:
    paths = sorted((ROOT / folder).rglob("*.py"))
    assert sum(len(parsed(path)[1]) for path in paths) / sum(map(code_lines, paths)) <= DENSITY[folder]
