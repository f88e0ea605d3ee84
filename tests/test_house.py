"""House rules: what may import what, what a wheel holds, and that the linters are silent."""

import ast
import os
import subprocess
import sys
import zipfile
from collections.abc import Collection, Iterator
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

import generated

ROOT = Path(__file__).parents[1]
PACKAGES = ("derive", "generated", "slipcircle")
HEAVY = {"sympy", "scipy", "mpmath", "flint", "matplotlib", "dask", "distributed", "pydantic", "rich"}


def succeed(*command: str | Path, cwd: Path = ROOT) -> str:
    """The output of a command that must succeed; what it says is the failure's text."""
    done = subprocess.run(command, cwd=cwd, capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False)
    if done.returncode:
        pytest.fail(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}", pytrace=False)
    return done.stdout


def python(code: str, *argv: str | Path, cwd: Path = ROOT) -> str:
    """Run code in a fresh interpreter that sees what is installed, and no more (-I: not even where it starts)."""
    return succeed(sys.executable, "-I", "-c", code, *argv, cwd=cwd)


def sources(package: str) -> list[Path]:
    """Its modules; the texts among the templates are those of `generated`, and judged there."""
    return sorted(path for path in (ROOT / package).rglob("*.py") if "templates" not in path.parts)


# --- linters -------------------------------------------------------------------------------------------------------


def test_ruff_is_silent() -> None:
    succeed(sys.executable, "-m", "ruff", "check", *PACKAGES, "tests")


def test_mypy_is_silent() -> None:
    succeed(sys.executable, "-m", "mypy", *PACKAGES, "tests")


@pytest.mark.parametrize("script", ["run", ".ci/run"])
def test_scripts_are_posix_shell_and_executable(script: str) -> None:
    succeed("sh", "-n", script)
    assert os.access(ROOT / script, os.X_OK)


# --- imports -------------------------------------------------------------------------------------------------------


def imported(source: str) -> Iterator[str]:
    """Top-level names of all that a source imports, anywhere in it; relative imports stay at home and do not count."""
    for node in ast.walk(ast.parse(source)):
        match node:
            case ast.Import(names=names):
                modules = [alias.name for alias in names]
            case ast.ImportFrom(module=str(module), level=0):
                modules = [module]
            case ast.Call(
                func=ast.Name(id="import_module" | "__import__" | "run_module")
                | ast.Attribute(attr="import_module" | "__import__" | "run_module"),
                args=[ast.Constant(value=str(module)), *_],
            ):
                modules = [module]
            case _:
                continue
        yield from (module.partition(".")[0] for module in modules if not module.startswith("."))


def forbidden(package: str, source: str) -> set[str]:
    """What a source of this package imports and must not."""
    names = set(imported(source))
    match package:
        case "derive":
            return names & {"generated", "slipcircle"}
        case "slipcircle":
            return names & {"derive"}
        case "generated":
            return names - {"generated", "numpy"} - sys.stdlib_module_names
        case _:
            raise ValueError(package)


@pytest.mark.parametrize("package", PACKAGES)
def test_imports_go_one_way(package: str) -> None:
    assert sources(package)
    offenders = {
        str(path.relative_to(ROOT)): names
        for path in sources(package)
        if (names := forbidden(package, path.read_text("utf-8")))
    }
    assert not offenders


@pytest.mark.parametrize(
    ("package", "source", "names"),
    [
        ("derive", "def late():\n    from generated.arc import polar_moment", {"generated"}),
        ("derive", "import numpy, slipcircle.scene.scene as scene", {"slipcircle"}),
        ("derive", "importlib.import_module('generated')", {"generated"}),
        ("derive", "import sympy\nfrom . import generated\nimport_module('.slipcircle', __name__)", set()),
        ("slipcircle", "if TYPE_CHECKING:\n    import derive.code.program", {"derive"}),
        ("slipcircle", "__import__('derive.code.program')", {"derive"}),
        ("slipcircle", "import generated, scipy\nprint('python -m derive')", set()),
        ("generated", "import scipy.special, slipcircle", {"scipy", "slipcircle"}),
        ("generated", "import math, numpy as np\nfrom .arc import polar_moment\nfrom generated import arc", set()),
    ],
)
def test_the_import_rule_sees(package: str, source: str, names: set[str]) -> None:
    assert forbidden(package, source) == names


# Folders and modules of each package, from what needs nothing of it to what nothing in it needs.
LAYERS = {
    "derive": (
        *("__init__", "check", "declare", "algebra", "code", "approximate", "flow", "generate", "judge"),
        *("build", "build_hook", "__main__"),
    ),
    "generated": (
        *("definitions", "effects", "flow", "laws", "series", "tiers", "_evaluate", "_compiled"),
        *("growth", "kernels", "motion", "printed", "slopes", "stable", "__init__"),
    ),
    "slipcircle": (
        *("kernels", "base", "records", "scene", "flow", "motion", "files", "studies", "__init__", "outputs", "cost"),
        "__main__",
    ),
}


def inner(name: str, source: str, known: Collection[str]) -> set[str]:
    """The modules among the known ones that a module imports, wherever in its text; a folder's own are its contents."""
    found = set()
    for node in ast.walk(ast.parse(source)):
        match node:
            case ast.Import(names=names):
                found |= {alias.name for alias in names}
            case ast.ImportFrom(module=str(module), names=names, level=0):
                of = {f"{module}.{alias.name}" for alias in names}
                found |= of & set(known) if of <= set(known) else of | {module}
    return found & set(known) - {name}


def graph(package: str) -> dict[str, set[str]]:
    """What each module of a package imports of it."""
    text = {}
    for path in sources(package):
        name = ".".join(path.relative_to(ROOT).with_suffix("").parts)
        text[name.removesuffix(".__init__")] = path.read_text("utf-8")
    return {name: inner(name, source, text) for name, source in text.items()}


def layer(name: str) -> int:
    """The place of a module in its package's layers."""
    package, _, rest = name.partition(".")
    return LAYERS[package].index(rest.partition(".")[0] or "__init__")


@pytest.mark.parametrize("package", LAYERS)
def test_imports_go_down_the_layers_without_a_circle(package: str) -> None:
    """Lazy and typing imports included."""
    found = graph(package)
    assert not [f"{name} imports {x}" for name, of in found.items() for x in of if layer(x) > layer(name)]
    TopologicalSorter(found).prepare()  # CycleError names a circle


@pytest.mark.parametrize(
    ("source", "wanted"),
    [
        ("def late():\n    from derive.judge import verify", {"derive.judge.verify"}),
        ("if TYPE_CHECKING:\n    from derive.judge.verify import report", {"derive.judge.verify"}),
        ("import derive.code.emit, numpy", {"derive.code.emit"}),
        ("from derive.code.emit import TEMPLATES as verify", {"derive.code.emit"}),
        ("from derive.judge import verify, words", {"derive.judge", "derive.judge.verify"}),
    ],
)
def test_the_layers_see(source: str, wanted: set[str]) -> None:
    known = {"derive", "derive.judge", "derive.judge.verify", "derive.code.emit", "derive.code.write"}
    assert inner("derive.code.write", source, known) == wanted


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


def test_generated_names_its_project() -> None:
    assert generated.__project__ == "slipcircle"


@pytest.mark.parametrize("text", ["", "__project__ = 'another'\n"])
def test_a_foreign_package_called_generated_is_named(tmp_path: Path, text: str) -> None:
    foreign = tmp_path / "generated"
    foreign.mkdir()
    (foreign / "__init__.py").write_text(text, "utf-8")
    code = """
import sys
sys.path.insert(0, sys.argv[1])
try:
    import slipcircle
except ImportError as error:
    print(error)
"""
    assert str(foreign) in python(code, tmp_path)


# --- the wheel -----------------------------------------------------------------------------------------------------


def test_wheel_holds_the_three_packages_and_works_away_from_here(tmp_path: Path) -> None:
    succeed(sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", tmp_path)
    (wheel,) = tmp_path.glob("slipcircle-*.whl")
    unpacked = tmp_path / "unpacked"
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(unpacked)
        names = {n for n in archive.namelist() if ".dist-info/" not in n and not n.endswith(".so")}
    # Every file and no other, so that no pattern of .gitignore quietly takes one out.
    here = (path for package in PACKAGES for path in (ROOT / package).rglob("*") if path.is_file())
    built = {"__pycache__", ".ipynb_checkpoints"}
    assert names == {
        path.relative_to(ROOT).as_posix() for path in here if path.suffix != ".so" and not built & set(path.parts)
    }
    code = """
import sys
from importlib import import_module
sys.path.insert(0, sys.argv[1])
print(*(import_module(name).__file__ for name in sys.argv[2:]), sep="\\n")
"""
    files = python(code, unpacked, *PACKAGES, cwd=tmp_path).splitlines()
    assert files == [str(unpacked / package / "__init__.py") for package in PACKAGES]
