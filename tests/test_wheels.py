"""Wheels: what `python -m derive.wheels` makes for others, and the pure one, which needs nothing but NumPy."""

import json
import os
import re
import subprocess
import sys
import venv
import zipfile
from importlib import metadata
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest
from packaging.tags import parse_tag

from derive import wheels
from generated import polar_moment
from slipcircle import load, solve
from tests.support.outputs import blocks

ROOT = Path(__file__).parents[1]


def wheel_with(binaries: Path) -> Path:
    """Return the wheel of the platform of this name, beside the folder."""
    command = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(binaries.parent)]
    environ = os.environ | {"SLIPCIRCLE_BINARIES": str(binaries)}
    subprocess.run(command, cwd=ROOT, env=environ, capture_output=True, check=True)
    (wheel,) = binaries.parent.glob(f"*-{binaries.name}.whl")
    return wheel


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the pure wheel."""
    folder = tmp_path_factory.mktemp("pure") / "any"
    folder.mkdir()
    return wheel_with(folder)


@pytest.fixture(scope="module")
def pure(wheel: Path) -> Path:
    """Return the pure wheel, unpacked."""
    folder = wheel.parent / "installed"
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(folder)
    return folder


@pytest.mark.skipif(not find_spec("pip"), reason="this environment has no pip")
def test_pip_installs_it_in_a_new_environment(wheel: Path, tmp_path: Path) -> None:
    """The command runs and a kernel is imported with this pip and NumPy, without a clone, a compiler or a home."""
    venv.create(tmp_path / "new")
    scripts = tmp_path / "new" / "bin"
    (packages,) = (tmp_path / "new" / "lib").glob("python*/site-packages")
    for name in ("pip", "numpy", "numpy.libs"):
        (packages / name).symlink_to(Path(np.__file__).parents[1] / name)
    environ = {"HOME": "/nowhere", "PATH": "/nowhere"}

    def printed(*command: object) -> str:
        words = [str(word) for word in command]
        done = subprocess.run(words, env=environ, cwd=tmp_path, capture_output=True, text=True, check=False)
        assert not done.returncode, done.stderr
        return done.stdout

    pip = ("-m", "pip", "install", "-q", "--no-index", "--no-deps", "--no-compile", "--disable-pip-version-check")
    printed(scripts / "python", *pip, wheel)
    (said,) = json.loads(printed(scripts / "slipcircle", "run", "vaiont", "--json"))
    assert said["run_out"] == pytest.approx(float(solve(load("vaiont")).run_out), rel=1e-12)
    code = "from generated import polar_moment; print(polar_moment(0.5))"
    assert float(printed(scripts / "python", "-c", code)) == pytest.approx(polar_moment(0.5), rel=1e-15)


# What a browser's Python has none of: an attempt is an error. NumPy itself may do as it likes while it is imported.
BROWSER = """
import sys, numpy
sys.path.insert(0, sys.argv[1])

def refuse(event, args):
    writes = event == "open" and isinstance(args[1], str) and set(args[1]) & set("wax+")
    assert not writes and event not in FORBIDDEN, (event, args)

FORBIDDEN = {"_thread.start_new_thread", "subprocess.Popen", "os.fork", "os.forkpty", "os.posix_spawn", "os.system",
             "os.mkdir", "os.rename", "socket.connect", "ctypes.dlopen"}
sys.addaudithook(refuse)
import slipcircle
from slipcircle import Arc, Scene, load, solve
from generated import _compiled
assert slipcircle.__file__.startswith(sys.argv[1]), slipcircle.__file__
assert _compiled.LEVEL == "numpy"
for name in sys.argv[2:]:
    print(float(solve(load(name)).run_out).hex())
ensemble = Scene(Arc(1492.6, 3.756, 4.833, 20e3), numpy.linspace(0.16, 0.2, 5), ["rotation", "centripetal"])
print(*(float(x).hex() for x in solve(ensemble).run_out))
"""
README = "\n".join(blocks((ROOT / "README.md").read_text("utf-8"), "python"))


def test_the_pure_wheel_needs_no_thread_process_or_file_to_write(pure: Path) -> None:
    """The wheel solves Vaiont, a section and an ensemble without threads, processes or files, as in a browser."""
    names = ["vaiont", "real-slope"]
    environ = {key: value for key, value in os.environ.items() if not key.startswith(("PYTHON", "SLIPCIRCLE"))}
    environ |= {"HOME": "/nowhere", "PATH": "/nowhere", "PYTHONDONTWRITEBYTECODE": "1"}
    command = [sys.executable, "-P", "-c", BROWSER + README, str(pure), *names]
    done = subprocess.run(command, env=environ, cwd=pure, capture_output=True, text=True, check=False)
    assert not done.returncode, done.stderr
    *single, several = done.stdout.splitlines()[: len(names) + 1]
    for name, value in zip(names, single, strict=True):
        assert float.fromhex(value) == pytest.approx(float(solve(load(name)).run_out), rel=1e-12)
    run_outs = [float.fromhex(value) for value in several.split()]
    assert run_outs == sorted(run_outs, reverse=True)  # with more friction it stops sooner
    assert 0 < run_outs[-1] < run_outs[0]
    shown = re.findall(r"^# (.*)", README, re.MULTILINE)
    told = done.stdout.splitlines()[len(names) + 1 :]
    assert [line.partition("error")[0] for line in told] == [line.partition("error")[0] for line in shown]


def test_a_wheel_serves_from_its_zip_file_and_without_docstrings(wheel: Path, tmp_path: Path) -> None:
    environ = os.environ | {"PYTHONPATH": str(wheel), "SLIPCIRCLE_COMPILED": "0"}
    code = "import runpy, sys; from slipcircle.__main__ import main; "
    code += "main('run vaiont-frozen --live slide.html'.split()); "
    code += "sys.argv = ['slipcircle', '--help']; runpy.run_module('slipcircle', run_name='__main__')"
    command = [sys.executable, "-P", "-OO", "-c", code]
    done = subprocess.run(command, env=environ, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert not done.returncode, done.stderr
    printed = done.stdout
    assert "slip circle" in printed.partition("options:")[0].partition("usage:")[2]
    assert "None" not in printed
    assert "slide-engine" in (tmp_path / "slide.html").read_text("utf-8")


def test_a_wheel_of_a_platform_has_binaries_in_place_of_their_source(pure: Path, tmp_path: Path) -> None:
    folder = tmp_path / "win_amd64"
    folder.mkdir()
    (folder / "_kernels.pyd").write_bytes(b"")
    with zipfile.ZipFile(wheel_with(folder)) as archive:
        held = {name for name in archive.namelist() if name.startswith("generated/")}
    without = {path.relative_to(pure).as_posix() for path in pure.glob("generated/**/*") if path.is_file()}
    assert held - without == {"generated/_kernels.pyd"}
    assert without - held == {"generated/_flow.c", "generated/_kernels.c"}


def test_metadata_of_a_wheel(pure: Path) -> None:
    """Metadata contain the texts of a package index, and every extra that a message names."""
    (folder,) = pure.glob("*.dist-info")
    found = metadata.PathDistribution(folder).metadata
    assert found["License-Expression"] == "BSD-3-Clause"
    assert found["Requires-Python"] == ">=3.11"
    assert {"scenes", "plot", "derive", "dask"} <= set(found.get_all("Provides-Extra", []))
    assert (folder / "licenses" / "LICENSE").is_file()
    assert found["Keywords"]
    assert "Programming Language :: Python :: 3.11" in found.get_all("Classifier", [])
    for package in ("derive", "generated", "slipcircle"):
        assert (pure / package / "py.typed").is_file()
    assert "\n# slipcircle\n" in (folder / "METADATA").read_text("utf-8")  # the README


def test_platforms_are_tagged_as_installers_know_them() -> None:
    """Tags are valid for `packaging`, and name the 64-bit processor in Zig's name."""
    for platform, triple in wheels.TARGETS.items():
        tags = parse_tag(f"cp311-abi3-{platform}")
        assert {tag.abi for tag in tags} == {"abi3"}
        machine = triple.partition("-")[0]
        known = {"x86_64": ("x86_64", "amd64"), "aarch64": ("aarch64", "arm64"), "": ("any",)}[machine]
        assert all(tag.platform.endswith(known) for tag in tags)


@pytest.mark.skipif(bool(find_spec("ziglang")), reason="Zig is here")
def test_without_zig_one_line_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    assert wheels.main() == 2
    assert "pip install ziglang" in capsys.readouterr().err
