"""Machines and installations that users reach: ``python -m tests.campaigns.matrix [CASE ...]`` runs tests in each.

Without a compiled binary, with the loops of the least processors in ours or in NumPy, with a home that cannot be
written, without a locale, in a path with spaces, with the oldest allowed version of every dependency, with the newest
versions on every Python here that the package allows, with every GCC and Clang here, and with the sanitizers of GCC.
Cases with versions make environments of their own in a temporary folder, from the package index.

Settings of the machine run the tests that own the values of scenes, what the command line prints, and scene files;
where only the processor differs, also those of the documents. Other versions and compilers run the complete suite, or
with ``--short`` the tests of the compiled code, of the numerics and of the types, in a few minutes. The sanitizers run
those of the compiled code. The line of each case gives the outcome. Pythons and compilers that the machine's own
packages lack can be installed in a newer Debian, in a folder made by `debootstrap` with this checkout mounted in it,
where the same command finds them.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Mapping, Sequence
from datetime import date
from pathlib import Path

import numpy as np

ROOT = Path(__file__).parents[2]
TESTED = ("accuracy", "ensemble_states", "scenefile", "cli", "records")
PRINTED = ("golden", "notebooks", "readme")  # the same digits on every processor
TESTS, DOCUMENTS = ([f"tests/test_{name}.py" for name in names] for names in (TESTED, PRINTED))
SANITIZED = [f"tests/test_{name}.py" for name in ("flow_compiled", "compiled")]
NUMERICS = ("flow_programs", "integrator_source", "kernels", "golden", "creep", "accuracy", "ensemble_states")
SHORT = [*SANITIZED, *(f"tests/test_{name}.py" for name in NUMERICS)]
TYPES = "tests/test_architecture.py::test_mypy_is_silent"
COMPLETE = ["--numprocesses=logical", "--maxprocesses=8", "--dist=worksteal"]  # as `./run test`
NOT_COPIED = ("__pycache__", "*.so", ".git", ".venv", ".*_cache", "build", "dist")
_UMATH = getattr(np, "_core")._multiarray_umath  # noqa: B009 (private, and without a type)
_WIDE = [name for name in _UMATH.__cpu_dispatch__ if _UMATH.__cpu_features__[name]]
PROCESSORS: dict[str, dict[str, str]] = {
    "wide loops off": {"NPY_DISABLE_CPU_FEATURES": " ".join(_WIDE)},
    "our C at its baseline": {"SLIPCIRCLE_COMPILED": "baseline"},
}
SETTINGS: dict[str, dict[str, str]] = {
    "no binary": {"SLIPCIRCLE_COMPILED": "0"},
    **PROCESSORS,
    "read-only home": {"HOME": "/dev/null", "XDG_CACHE_HOME": "", "XDG_CONFIG_HOME": "", "MPLCONFIGDIR": ""},
    "no locale": {"LC_ALL": "C", "LANG": "", "LC_CTYPE": "", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"},
}
OLDEST = "oldest versions"
OF_THEIR_TIME = "pyparsing<3.3"  # which deprecates what matplotlib 3.9 calls when it is imported
SPACES = "path with spaces"
SANITIZERS = "sanitizers"
EXTRAS = ("derive", "scenes", "plot", "dask", "dxf", "test", "book")
# The integrator under the sanitizers, without optimisation and at the baseline: one text makes all levels, but checked
# wide vectors take more than ten minutes to compile.
SANITIZE = """
from pathlib import Path
from derive import build
for kind in ("avx512", "avx2"):
    build.KINDS[kind] += ("-fno-sanitize=all",)
for name in build.MODULES:
    build.build(Path("generated").resolve(), ("-O0", *build.FLAGS[1:]), name)
"""


def pythons() -> dict[str, Path]:
    """Interpreters of this machine that the package allows, by version, on the path and of pyenv."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    oldest = int(project["requires-python"].removeprefix(">=3."))
    found: dict[str, Path] = {}
    for minor in range(oldest, oldest + 10):
        name = f"python3.{minor}"
        installed = sorted(Path.home().glob(f".pyenv/versions/3.{minor}.*/bin/{name}"))
        if on_path := shutil.which(name):
            installed.append(Path(on_path))
        working = [path for path in installed if subprocess.run([path, "-c", ""], capture_output=True).returncode == 0]
        if working:
            found[name] = working[-1]
    return found


def compilers() -> list[str]:
    """GCC and Clang of this machine, by the names of their versions."""
    numbers = range(9, 30)
    names = [f"gcc-{k}" for k in numbers] + [f"clang-{k}" for k in numbers]
    return [name for name in names if shutil.which(name)]


def oldest_versions() -> list[str]:
    """Return the lower bounds of all dependencies as pins, without the tools of the tests and of the book."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    optional = project["optional-dependencies"]
    every = [*project["dependencies"], *(x for name in EXTRAS if name not in ("test", "book") for x in optional[name])]
    return sorted({x.replace(">=", "==") for x in every if ">=" in x})


def tested(folder: Path, python: Path | str, settings: Mapping[str, str], tests: Sequence[str]) -> tuple[bool, str]:
    """Whether tests of a checkout pass, and pytest's last line."""
    environment = {name: value for name, value in (os.environ | settings).items() if value}
    command: list[str | Path] = [python, "-m", "pytest", "-q", "-p", "no:cacheprovider", *tests]
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, encoding="utf-8")
    lines = (done.stdout + done.stderr).strip().splitlines() or ["no output"]
    failed = [line for line in lines if re.match("(FAILED|ERROR|SUMMARY:) ", line)]
    return done.returncode == 0, "\n    ".join([lines[-1], *failed])


def copied(folder: Path) -> Path:
    """Return a checkout without what is built."""
    return shutil.copytree(ROOT, folder, ignore=shutil.ignore_patterns(*NOT_COPIED))


def environment(folder: Path, python: Path, pins: Sequence[str] = ()) -> Path:
    """Return the interpreter of a new environment with the checkout, pinned versions and otherwise the newest ones."""
    constraints = folder / "pins.txt"
    constraints.write_text("\n".join(pins), "utf-8")
    subprocess.run([python, "-m", "venv", folder / ".venv"], check=True)
    inside = folder / ".venv" / "bin" / "python"
    install: list[str | Path] = [inside, "-m", "pip", "install", "-q", "--disable-pip-version-check", "-c", constraints]
    subprocess.run([*install, "-e", f".[{','.join(EXTRAS)}]"], cwd=folder, check=True)
    return inside


def compiled_by(folder: Path, compiler: str, tests: Sequence[str]) -> tuple[bool, str]:
    """Whether tests pass with a compiler, and whose binaries they ran."""
    checkout = copied(folder / "checkout")
    settings = {"CC": compiler, "PYTHONPATH": str(checkout)}
    version = "from slipcircle.core.integrator import compiled; print(compiled.module().COMPILER)"
    for command in (["-m", "derive.build"], ["-c", version]):
        done = subprocess.run([sys.executable, *command], cwd=checkout, env=os.environ | settings, capture_output=True,
                              text=True)  # fmt: skip
        if done.returncode or "NumPy serves" in done.stdout:
            return False, (done.stderr or done.stdout).strip()
    passed, line = tested(checkout, sys.executable, settings, tests)
    return passed, f"{line}; {done.stdout.strip()}"


def sanitized(folder: Path) -> tuple[bool, str]:
    """Whether the tests of the compiled code pass with memory and arithmetic checked."""
    checkout = copied(folder / "checkout")
    libraries = [
        subprocess.run(["gcc", f"-print-file-name=lib{name}.so"], capture_output=True, text=True).stdout.strip()
        for name in ("asan", "ubsan")
    ]
    settings = {
        "CC": "env LD_PRELOAD= gcc -fsanitize=address,undefined -fno-sanitize-recover=undefined",
        "LD_PRELOAD": " ".join(libraries),
        "ASAN_OPTIONS": "detect_leaks=0",
        "PYTHONPATH": str(checkout),
        "SLIPCIRCLE_COMPILED": "baseline",
    }
    subprocess.run([sys.executable, "-c", SANITIZE], cwd=checkout, env=os.environ | settings, check=True)
    return tested(checkout, sys.executable, settings, ["--capture=no", *SANITIZED])  # reports of what ends Python


def case(name: str, folder: Path, short: bool = False) -> tuple[bool, str]:
    """One case, in a temporary folder, with the complete suite or a selection where versions or compilers differ."""
    selected = SHORT if short else COMPLETE
    if name in SETTINGS:
        tests = TESTS + DOCUMENTS if name in PROCESSORS else TESTS
        return tested(ROOT, sys.executable, SETTINGS[name], tests)
    if name == SANITIZERS:
        return sanitized(folder)
    if name in compilers():
        return compiled_by(folder, name, selected)
    if name == SPACES:
        checkout = copied(folder / "a path with späces")
        compiling = subprocess.run([sys.executable, "-m", "derive.build"], cwd=checkout, capture_output=True, text=True)
        passed, line = tested(checkout, sys.executable, {"PYTHONPATH": str(checkout)}, TESTS)
        return passed, f"{line}; {compiling.stdout.strip()}"
    checkout = copied(folder / "checkout")
    interpreters = pythons()
    pins = [*oldest_versions(), OF_THEIR_TIME] if name == OLDEST else ()
    inside = environment(checkout, interpreters.get(name, next(iter(interpreters.values()))), pins)
    settings = {"PATH": f"{inside.parent}{os.pathsep}{os.environ['PATH']}"}  # as of `./run`
    return tested(checkout, inside, settings, [*SHORT, TYPES] if short and not pins else selected)


def main() -> int:
    names = [*SETTINGS, SPACES, OLDEST, *pythons(), *compilers(), SANITIZERS]
    parser = argparse.ArgumentParser(description=str(__doc__).partition("\n")[0])
    parser.add_argument("cases", nargs="*", metavar="CASE", help=f"of {', '.join(names)}; default: all")
    parser.add_argument("--short", action="store_true", help="versions and compilers: a selection of the tests")
    arguments = parser.parse_args()
    chosen = arguments.cases or names
    if unknown := [name for name in chosen if name not in names]:
        parser.error(f"no case {', '.join(unknown)}; there are {', '.join(names)}")
    failed = 0
    for name in chosen:
        with tempfile.TemporaryDirectory() as folder:
            try:
                passed, line = case(name, Path(folder), arguments.short)
            except subprocess.CalledProcessError as error:
                passed, line = False, str(error)
        failed += not passed
        outcome = "passed" if passed else "FAILED"
        print(f"{date.today()} {name}: {outcome}: {line}", flush=True)
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
