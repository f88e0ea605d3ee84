"""The compiled kernels: loops that are wide, a build that is safe, and wheels with and without a compiler."""

import contextlib
import os
import platform
import re
import shutil
import subprocess
import sys
import sysconfig
import zipfile
from collections.abc import Callable, Iterator
from importlib.machinery import ModuleSpec
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from derive import build
from derive.approximate.programs import variants, variants_of_ends
from derive.generate import emit_c, write
from derive.stages import digest_of
from generated import _compiled
from slipcircle.workbench.outputs import info
from tests.campaigns import matrix
from tests.support.golden import SHIPPED
from tests.support.kernels import COMPILED, LEVELS, needs_binary
from tests.support.lanes import BINARY

ROOT = Path(__file__).parents[1]
QUICKLY = ("-O0", *build.FLAGS[1:])  # to compile, where it does not matter how fast loops are


def compiler() -> list[str]:
    """Return the machine's, or that of the package index."""
    with contextlib.suppress(build.NoBinaryError):
        return build.c_compiler()
    return []


needs_compiler = pytest.mark.skipif(not compiler(), reason="no C compiler here")


def loops_in(binary: Path) -> Iterator[tuple[str, list[str]]]:
    """Instructions of every loop, by its name."""
    text = subprocess.run(["objdump", "-d", "--no-show-raw-insn", binary], capture_output=True, text=True, check=True)
    for block in text.stdout.split("\n\n"):
        if head := re.match(r"[0-9a-f]+ <(\w+_(?:avx512|avx2|baseline)_(?:double|float))>:", block):
            yield head[1], [line.split("\t", 1)[1] for line in block.splitlines()[1:] if "\t" in line]


@needs_binary
@pytest.mark.skipif(not shutil.which("objdump"), reason="objdump is missing")
def test_loops_are_wide_and_call_nothing() -> None:
    """Loops are vector loops of their width without a call into a library; plain loops contain no fma."""
    binary = build.build()
    found = dict(loops_in(binary))
    if "avx2" in LEVELS:
        every = (*variants(), *variants_of_ends())
        doubles = {(v.kernel, v.tier) for v in every if v.tier != "float32"}
        assert len(found) == 3 * (len(doubles) + len({kernel for kernel, _ in doubles}))
    for name, code in found.items():
        assert not [x for x in code if x.startswith("call")], f"{name} calls something"
        level = name.split("_")[-2]
        wide = {"avx512": r"vfn?m(add|sub)\w*pd .*zmm", "avx2": r"vfn?m(add|sub)\w*pd .*ymm", "baseline": "mulpd"}[
            level
        ]
        assert sum(bool(re.match(wide, x)) for x in code) >= 3, f"{name} is not a vector loop"
        if level == "baseline":
            assert not [x for x in code if re.match(r"v|.*[yz]mm", x)], f"{name} needs more than a baseline processor"


def small(folder: Path, change: Callable[[str], str] = str) -> Path:
    """Return the package with one kernel to compile, of a source that may be changed."""
    if not folder.exists():
        shutil.copytree(ROOT / "generated", folder, ignore=shutil.ignore_patterns("*.so", "__pycache__", "*.c"))
    text = change(emit_c.source([v for v in variants() if v.kernel == "resistance_factor"]))
    (folder / "_kernels.c").write_text(write.header("_kernels.c", text) + text, "utf-8")
    known = re.sub('DIGEST = ".*"', f'DIGEST = "{digest_of(text)}"', (folder / "tiers.py").read_text("utf-8"))
    (folder / "tiers.py").write_text(known, "utf-8")
    return folder


def served(place: Path, **environment: str) -> tuple[str, list[str]]:
    """Return the engine and the warnings of a fresh interpreter with this package; its numbers must be correct."""
    code = """
import sys, warnings
sys.path.insert(0, sys.argv[1])
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    import generated
    from generated import _compiled
    value = generated.resistance_factor([0.5, 1.0])
assert abs(value[0] - 0.12241743810962728) < 1e-15, value
assert _compiled.__file__.startswith(sys.argv[1]), _compiled.__file__
print(_compiled.LEVEL, *(str(w.message) for w in caught), sep="\\n")
"""
    environ = {k: v for k, v in os.environ.items() if k not in ("PYTHONPATH", "SLIPCIRCLE_COMPILED")} | environment
    environ["PYTHONDONTWRITEBYTECODE"] = "1"  # two sources of one second and one size share their byte code
    command = [sys.executable, "-P", "-c", code, str(place)]
    done = subprocess.run(command, capture_output=True, text=True, env=environ, cwd=place, check=False)
    assert not done.returncode, done.stderr
    level, *warned = done.stdout.splitlines()
    return level, warned


@needs_compiler
def test_a_binary_of_another_source_is_refused(tmp_path: Path) -> None:
    """One warning names the remedy, and NumPy is used; silently if NumPy was requested."""
    folder = small(tmp_path / "generated")
    binary = build.build(folder, QUICKLY)
    level, warned = served(tmp_path)
    assert (level, warned) == (COMPILED[0], [])
    assert served(tmp_path, SLIPCIRCLE_COMPILED="0") == ("numpy", [])
    stamp = binary.stat().st_mtime_ns
    assert build.build(folder, QUICKLY).stat().st_mtime_ns == stamp  # made of this source: left alone
    small(folder, lambda text: text + "/* later */\n")
    level, (warning,) = served(tmp_path)
    assert level == "numpy"
    assert "another source" in warning
    assert "python -m derive" in warning
    build.build(folder, QUICKLY)
    assert served(tmp_path) == (COMPILED[0], [])
    whole = binary.read_bytes()
    for broken in (b"no binary", whole[:-1]):
        binary.unlink()
        binary.write_bytes(broken)
        level, (warning,) = served(tmp_path)
        assert level == "numpy"
        assert "cannot be loaded" in warning


def test_a_binary_that_cannot_be_read_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """An unreadable binary, such as one for another machine, causes one warning, and NumPy is used."""

    def refuse(*_: Any) -> None:
        raise PermissionError(13, "Permission denied", "_kernels.so")

    monkeypatch.setattr(_compiled, "open", refuse, raising=False)
    monkeypatch.setattr(_compiled, "find_spec", lambda _: ModuleSpec("_kernels", None, origin="_kernels.so"))
    with pytest.warns(RuntimeWarning, match=r"NumPy serves: it cannot be loaded \(.*Permission denied") as caught:
        assert _compiled.binary("_kernels", "") is None
    assert len(caught) == 1


def test_free_threaded_python_is_recognised(monkeypatch: pytest.MonkeyPatch) -> None:
    """Free-threaded Python is recognised by its version text; sysconfig would take a tenth of the time of an import."""
    assert _compiled.is_free_threaded() == bool(sysconfig.get_config_var("Py_GIL_DISABLED"))
    monkeypatch.setattr(sys, "version", "3.14.0 free-threading build (main, Oct  7 2025) [GCC 14.2.0]")
    assert _compiled.is_free_threaded()


def test_free_threaded_python_without_a_binary_says_so_once(monkeypatch: pytest.MonkeyPatch) -> None:
    _compiled._report_free_threads.cache_clear()
    monkeypatch.setattr(_compiled, "is_free_threaded", lambda: True)
    with pytest.warns(RuntimeWarning, match="no binary for free-threaded Python; pip install --no-binary") as caught:
        assert [_compiled.binary(name, "") for name in ("_none", "_neither")] == [None, None]
    assert len(caught) == 1
    monkeypatch.setenv("SLIPCIRCLE_COMPILED", "0")
    _compiled._report_free_threads.cache_clear()
    assert _compiled.binary("_none", "") is None  # silent: NumPy is asked for


@pytest.mark.parametrize(("free", "remedy"), [(False, "`python -m derive.build`"), (True, "pip install --no-binary")])
def test_info_names_the_remedy_where_nothing_is_compiled(free: bool, remedy: str, monkeypatch: Any) -> None:
    monkeypatch.setattr(info, "LEVEL", "numpy")
    monkeypatch.setattr(info, "is_free_threaded", lambda: free)
    kernels = info.facts()["kernels"]
    assert kernels.startswith("NumPy, not compiled: ")
    assert remedy in kernels


UNSAFE = {
    "-fassociative-math -fno-signed-zeros": "sums are reordered",
    "-ffp-contract=fast": "products and sums are contracted",
    "-freciprocal-math": "divisions are multiplications",
}


@needs_compiler
@pytest.mark.parametrize("flags", UNSAFE)
def test_unsafe_float_flags_are_refused(tmp_path: Path, flags: str) -> None:
    """A check with a name finds them when the binary is loaded."""
    build.build(small(tmp_path / "generated"), (*build.FLAGS, "-O2", *flags.split()))
    level, (warning,) = served(tmp_path)
    assert level == "numpy"
    assert f"unsafe float flags ({UNSAFE[flags]}" in warning


@needs_compiler
@pytest.mark.parametrize("flag", ["-ffast-math", "-ffinite-math-only"])
def test_unsafe_float_flags_do_not_compile(tmp_path: Path, flag: str) -> None:
    with pytest.raises(build.NoBinaryError, match="unsafe float flags"):
        build.build(small(tmp_path / "generated"), (*build.FLAGS, flag))
    assert served(tmp_path) == ("numpy", [])


@needs_compiler
def test_flags_of_the_environment_stay_out(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CC", f"{' '.join(compiler())} -ffast-math")
    monkeypatch.setenv("CFLAGS", "-Ofast -march=native")
    build.build(small(tmp_path / "generated"))
    assert served(tmp_path) == (COMPILED[0], [])


@needs_compiler
@pytest.mark.parametrize(("fma", "level"), [("0", "baseline"), ("1", "fma")])
def test_other_processors_compile_one_program_plainly(tmp_path: Path, fma: str, level: str) -> None:
    """Not x86-64: the fused program where the target has a fused multiply-add, else the plain one."""
    flags = ("-march=haswell",) if fma == "1" and platform.machine() == "x86_64" else ()

    def elsewhere(text: str) -> str:
        for known, value in (("defined(__x86_64__)", "0"), ("(defined(__FP_FAST_FMA) || defined(__aarch64__))", fma)):
            assert known in text
            text = text.replace(known, value)
        return text

    build.build(small(tmp_path / "generated", elsewhere), (*QUICKLY, *flags))
    assert served(tmp_path) == (level, [])


GARBAGE = 'while [ $# -gt 0 ]; do [ "$1" = -o ] && echo garbage >"$2"; shift; done'
COMPILERS = {  # what they do as programs of a shell, and what is said of them
    "exit 3": "fails: nothing is written, status 3",
    "exit 0": "fails: nothing is written, status 0",
    "kill -9 $$": "fails: nothing is written, status -9",
    "echo 'no room: error' >&2; exit 1": "fails: no room: error",
    GARBAGE: "does not load: ImportError",
    "": "Exec format error",
}


@pytest.mark.skipif(os.name != "posix", reason="needs a POSIX shell")
@pytest.mark.parametrize("does", COMPILERS)
def test_a_compiler_that_fails_leaves_numpy_and_one_line(does: str, tmp_path: Path, monkeypatch: Any) -> None:
    """Whatever it fails at, nothing is raised, and no binary is left to be refused later."""
    (script := tmp_path / "compiler").write_text(f"#!/bin/sh\n{does}\n" if does else "no program", "utf-8")
    script.chmod(0o755)
    monkeypatch.setenv("CC", str(script))
    monkeypatch.setattr(build, "MODULES", ["_kernels"])
    folder = small(tmp_path / "generated")
    binaries, outcome = build.build_all(folder)
    assert not binaries
    assert outcome.startswith("NumPy serves, `slipcircle info` says how fast: ")
    assert COMPILERS[does] in outcome
    assert "\n" not in outcome
    assert not list(folder.glob(".*"))
    assert served(tmp_path) == ("numpy", [])


@pytest.mark.parametrize("command", ["no-such-compiler", "'cc"])
def test_a_compiler_that_is_none_is_named_once(command: str, tmp_path: Path, monkeypatch: Any) -> None:
    for name in build.MODULES:
        (tmp_path / f"{name}.c").write_text('"no digest"', "utf-8")
    monkeypatch.setenv("CC", command)
    binaries, outcome = build.build_all(tmp_path)
    assert not binaries
    assert outcome.count("NumPy serves") == outcome.count(command) == 1


def test_without_a_compiler_of_the_machine_that_of_the_package_index_serves(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setattr(shutil, "which", lambda name: None)
    monkeypatch.setattr("importlib.util.find_spec", lambda name: name == "ziglang")
    assert build.c_compiler()[:4] == [sys.executable, "-m", "ziglang", "cc"]
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    with pytest.raises(build.NoBinaryError, match="pip install ziglang"):
        build.c_compiler()


@needs_binary
@pytest.mark.skipif("NPY_DISABLE_CPU_FEATURES" in os.environ, reason="NumPy is told otherwise")
def test_kernels_and_integrator_use_what_the_processor_has() -> None:
    """NumPy asks the processor too; a compiler's library may know none of it, and all takes 2.6 times as long."""
    has = getattr(np, "_core")._multiarray_umath.__cpu_features__  # noqa: B009 (private, and without a type)
    widest = "avx512" if has["AVX512_SKX"] else "avx2" if has["AVX2"] and has["FMA3"] else COMPILED[-1]
    assert COMPILED[0] == widest
    assert next(iter(BINARY.LEVELS)) == widest


@pytest.mark.parametrize("name", matrix.PROCESSORS)
def test_every_processor_shows_the_same_digits(name: str) -> None:
    """A sample of what `python -m tests.campaigns.matrix` runs with NumPy's wide loops off, or ours."""
    tests = [f"tests/test_golden.py::test_numbers_are_those_kept[{name}]" for name in SHIPPED]
    passed, line = matrix.tested(ROOT, sys.executable, matrix.PROCESSORS[name], tests)
    assert passed, line


@needs_compiler
def test_a_binary_stands_for_its_source(tmp_path: Path) -> None:
    """A binary in a wheel of a platform is not compiled again, and only the text of its source is compared."""
    folder = small(tmp_path / "generated")
    binary = build.build(folder, QUICKLY)
    source = folder / "_kernels.c"
    text = source.read_text("utf-8")
    assert not build.has_binary_alone(source.name, text, folder)
    source.unlink()
    assert build.build(folder) == binary
    assert build.has_binary_alone(source.name, text, folder)
    assert not build.has_binary_alone(source.name, text.replace('DIGEST "', 'DIGEST "0'), folder)
    assert not build.has_binary_alone("tiers.py", text, folder)
    binary.unlink()
    with pytest.raises(build.NoBinaryError, match=r"_kernels\.c is missing: `python -m derive` writes it"):
        build.build(folder)


def test_without_a_compiler_the_wheel_is_pure_and_works(tmp_path: Path) -> None:
    """The wheel of a copy with one kernel and no integrator is pure; `test_architecture` builds the complete wheel."""
    checkout, nothing = tmp_path / "checkout", tmp_path / "nothing"
    nothing.mkdir()
    small(checkout / "generated")
    for name in ("derive", "slipcircle"):
        shutil.copytree(ROOT / name, checkout / name, ignore=shutil.ignore_patterns("*.so", "__pycache__"))
    for name in ("pyproject.toml", "README.md", "LICENSE", ".gitignore"):
        shutil.copy(ROOT / name, checkout / name)
    command = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(tmp_path)]
    environ = os.environ | {"PATH": str(nothing), "CC": "absent"}
    subprocess.run(command, cwd=checkout, env=environ, capture_output=True, text=True, check=True)
    (made,) = tmp_path.glob("*-py3-none-any.whl")
    with zipfile.ZipFile(made) as archive:
        archive.extractall(tmp_path / "installed")
        names = archive.namelist()
    assert "generated/_kernels.c" in names
    assert not [n for n in names if n.endswith(".so")]
    assert served(tmp_path / "installed") == ("numpy", [])
