"""Machines and installations that users reach: ``python -m tests.campaigns.matrix [CASE ...]`` runs tests in each.

Without a compiled binary, with the loops of the least processors in ours or in NumPy, with a home that cannot be
written, without a locale, in a path with spaces, with NumPy's oldest allowed version, and with every Python here that
the package allows. The last two make environments of their own in a temporary folder, from the package index. Each case
runs the tests that own the values of scenes, what the command line prints, and scene files, and those of the documents
where only the processor differs; its line says what came of them.
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
from pathlib import Path

import numpy as np

ROOT = Path(__file__).parents[2]
TESTED = ("accuracy", "ensemble_states", "scenefile", "cli", "records")
PRINTED = ("golden", "notebooks", "readme")  # the same digits on every processor
TESTS, DOCUMENTS = ([f"tests/test_{name}.py" for name in names] for names in (TESTED, PRINTED))
COPIED = ("derive", "generated", "slipcircle", "tests", "notebooks")
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
OLDEST_NUMPY = "oldest NumPy"
SPACES = "path with spaces"


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


def tested(folder: Path, python: Path | str, settings: Mapping[str, str], tests: Sequence[str]) -> tuple[bool, str]:
    """Whether tests of a checkout pass, and pytest's last line."""
    environment = {name: value for name, value in (os.environ | settings).items() if value}
    command: list[str | Path] = [python, "-m", "pytest", "-q", "-p", "no:cacheprovider", *tests]
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, encoding="utf-8")
    lines = (done.stdout + done.stderr).strip().splitlines() or ["no output"]
    failed = [line for line in lines if re.match("(FAILED|ERROR) ", line)]
    return done.returncode == 0, "\n    ".join([lines[-1], *failed])


def copied(folder: Path) -> Path:
    """A checkout without what is built."""
    for name in COPIED:
        shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__", ".*", "*.so"))
    for path in ROOT.iterdir():
        if path.is_file():
            shutil.copy(path, folder)
    return folder


def environment(folder: Path, python: Path, numpy: str = "") -> Path:
    """The interpreter of a new environment with the checkout in it, by pinned versions; NumPy's if one is named."""
    constraints = folder / "constraints.txt"
    if numpy:
        pinned = constraints.read_text("utf-8").splitlines(keepends=True)
        constraints.write_text("".join(x for x in pinned if not x.startswith("numpy==")) + f"numpy=={numpy}\n", "utf-8")
    subprocess.run([python, "-m", "venv", folder / ".venv"], check=True)
    inside = folder / ".venv" / "bin" / "python"
    install: list[str | Path] = [inside, "-m", "pip", "install", "-q", "--disable-pip-version-check", "-c", constraints]
    subprocess.run([*install, "-e", ".[derive,scenes,plot,dask,test]"], cwd=folder, check=True)
    return inside


def case(name: str, folder: Path) -> tuple[bool, str]:
    """One case, in a temporary folder."""
    if name in SETTINGS:
        tests = TESTS + DOCUMENTS if name in PROCESSORS else TESTS
        return tested(ROOT, sys.executable, SETTINGS[name], tests)
    if name == SPACES:
        checkout = copied(folder / "a path with späces")
        compiling = subprocess.run([sys.executable, "-m", "derive.build"], cwd=checkout, capture_output=True, text=True)
        passed, line = tested(checkout, sys.executable, {"PYTHONPATH": str(checkout)}, TESTS)
        return passed, f"{line}; {compiling.stdout.strip()}"
    checkout = copied(folder / "checkout")
    interpreters = pythons()
    if name == OLDEST_NUMPY:
        project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
        numpy = project["dependencies"][0].removeprefix("numpy>=") + ".*"
        return tested(checkout, environment(checkout, next(iter(interpreters.values())), numpy), {}, TESTS)
    return tested(checkout, environment(checkout, interpreters[name]), {}, TESTS)


def main() -> int:
    names = [*SETTINGS, SPACES, OLDEST_NUMPY, *pythons()]
    parser = argparse.ArgumentParser(description=str(__doc__).partition("\n")[0])
    parser.add_argument("cases", nargs="*", metavar="CASE", help=f"of {', '.join(names)}; default: all")
    chosen = parser.parse_args().cases or names
    if unknown := [name for name in chosen if name not in names]:
        parser.error(f"no case {', '.join(unknown)}; there are {', '.join(names)}")
    failed = 0
    for name in chosen:
        with tempfile.TemporaryDirectory() as folder:
            try:
                passed, line = case(name, Path(folder))
            except subprocess.CalledProcessError as error:
                passed, line = False, str(error)
        failed += not passed
        print(f"{name}: {'passed' if passed else 'FAILED'}: {line}", flush=True)
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
