"""Compilation of the extension modules of `generated` in place: `python -m derive.build`, and at install time.

The compiler is the machine's, or else that of the package index (``pip install ziglang``). Flags of the environment are
ignored: the proofs of the kernels hold for the operations as they are written.
"""

import importlib.util
import os
import platform
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tempfile
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path

FOLDER = Path(__file__).resolve().parent.parent / "generated"
# Vector loops need no errno from sqrt and pieces that are not used may raise a flag (cleared later).
FLAGS = ("-O3", "-fPIC", "-fno-fast-math", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math")
# Flags for compilers that know them. GCC turns comparisons into branches, which prevent vector loops; its scheduling
# saves a tenth of the time, as there are many chains of operations side by side. From version 13 on it splits chains of
# fused multiply-adds for x86 in some functions and not in others, so that one formula would have two results.
OPTIONAL = (("-fno-thread-jumps", "-fschedule-insns", "-fsched-pressure"), ("--param=avoid-fma-max-bits=0",))
# The integrator is compiled once for every kind of processor, and once for the module. It proves nothing bit by bit: a
# product and a sum may be one operation.
INTEGRATOR = ("-ffp-contract=fast", "-fvisibility=hidden", "-Wno-psabi")
BASELINE = ("-DWIDE=128",)
KINDS = {
    "avx512": ("-DWIDE=512", "-mavx512f", "-mavx512dq", "-mavx512vl", "-mfma", "-mprefer-vector-width=512"),
    "avx2": ("-DWIDE=256", "-mavx2", "-mfma"),
    "baseline": (*BASELINE, "-Os"),  # few processors need it, and wheels shall be small
}
MODULES = ("_kernels", "_flow")
Parts = tuple[tuple[str, ...], ...]  # flags of each object of a module
SUFFIX = sysconfig.get_config_var("EXT_SUFFIX")  # asked once: of two threads at once, one gets nothing
IMPORT = "import sys, importlib; sys.path.insert(0, sys.argv[1]); importlib.import_module(sys.argv[2])"
SHARED = ("-bundle", "-undefined", "dynamic_lookup") if sys.platform == "darwin" else ("-shared",)


class NoBinaryError(Exception):
    """Reason for a missing binary in one line. NumPy is used instead."""


def build(folder: Path = FOLDER, flags: tuple[str, ...] = FLAGS, name: str = "_kernels") -> Path:
    """Compile the C source of a module beside it, unless its binary is up to date, and return the binary's path."""
    source = folder / f"{name}.c"
    if os.environ.get("SLIPCIRCLE_COMPILED") == "0":
        raise NoBinaryError("SLIPCIRCLE_COMPILED is 0")
    imported = imported_binary(folder, name)
    if imported.is_file() and (not source.is_file() or is_made_of(imported, source.read_text("utf-8"))):
        return imported
    if not source.is_file():
        raise NoBinaryError(f"{source.name} is missing: `python -m derive` writes it")
    compiler = c_compiler()
    for group in OPTIONAL:
        if _accepts(compiler, group):
            flags = (*flags, *group)
    try:
        import numpy as np
    except ImportError as error:
        raise NoBinaryError(f"no NumPy to compile with ({error})") from None
    includes = (f"-I{sysconfig.get_path('include')}", f"-I{np.get_include()}")
    binary = folder / f"{name}{SUFFIX}"
    with tempfile.TemporaryDirectory(dir=folder, prefix=".") as made:
        target = Path(made) / binary.name
        make(source, target, [*compiler, *flags, *includes], object_flags(name, platform.machine()), SHARED)
        done = subprocess.run([sys.executable, "-c", IMPORT, made, name], capture_output=True, text=True, check=False)
        if done.returncode:
            raise NoBinaryError(
                f"what {' '.join(compiler[:3])} makes does not load: {_fault(done)}".replace(f"{made}/", "")
            )
        os.replace(target, binary)
    return binary


def imported_binary(folder: Path, name: str) -> Path:
    """Return the path of the binary that an import of the module uses, or of the binary to be compiled."""
    candidates = (folder / f"{name}{suffix}" for suffix in EXTENSION_SUFFIXES)
    return next((path for path in candidates if path.is_file()), folder / f"{name}{SUFFIX}")


def is_made_of(binary: Path, source: str) -> bool:
    """Return whether a binary was compiled from the C text ``source``, by the digest in the text's header."""
    return source.split('"', 2)[1].encode() in binary.read_bytes()


def has_binary_alone(name: str, source: str, folder: Path = FOLDER) -> bool:
    """Return whether a binary of the C text ``source`` exists without that text's file, as in a wheel."""
    binary = imported_binary(folder, name.removesuffix(".c"))
    missing = name.endswith(".c") and not (folder / name).is_file()
    return missing and binary.is_file() and is_made_of(binary, source)


def object_flags(name: str, machine: str) -> Parts:
    """Return the flags of every object of a module on a kind of machine, such as x86_64.

    The integrator has one object per kind of processor.
    """
    if name == "_kernels":
        return ((),)
    kinds = KINDS if machine in ("x86_64", "AMD64") else {"baseline": BASELINE}
    return (*((*INTEGRATOR, f"-DLEVEL={kind}", *flags) for kind, flags in kinds.items()), INTEGRATOR)


def make(source: Path, target: Path, compiler: list[str], parts: Parts, link: Sequence[str]) -> None:
    """Compile the objects of a module, link them, and delete other files that the linker leaves.

    ``parts`` has the flags of each object, ``compiler`` is a command with common flags, and ``link`` has the flags of
    the linker.
    """
    with tempfile.TemporaryDirectory() as folder:
        objects = [str(Path(folder) / f"{k}.o") for k in range(len(parts))]
        linked = Path(folder) / target.name
        commands = [[*flags, "-c", str(source), "-o", made] for flags, made in zip(parts, objects, strict=True)]
        for command in (*commands, [*objects, *link, "-lm", "-o", str(linked)]):
            done = subprocess.run([*compiler, *command], capture_output=True, text=True, check=False)
            if done.returncode or not Path(command[-1]).is_file():
                raise NoBinaryError(f"{' '.join(compiler[:3])} fails: {_fault(done)}")
        shutil.move(linked, target)


def _fault(done: subprocess.CompletedProcess[str]) -> str:
    """Return the first error that a command printed, or its first line, or its status."""
    lines = done.stderr.splitlines()
    errors = [line for line in lines if "rror" in line]
    return next(iter(errors or lines), f"nothing is written, status {done.returncode}")


def c_compiler() -> list[str]:
    """Return ``CC`` of the environment, or the compiler of Python, of the machine, or of the package index."""
    try:
        asked = shlex.split(os.environ.get("CC", ""))
    except ValueError as error:
        raise NoBinaryError(f"CC={os.environ['CC']}: {error}") from None
    if asked:
        candidates = [asked]
    else:
        candidates = [shlex.split(sysconfig.get_config_var("CC") or ""), ["cc"], ["gcc"], ["clang"]]
    for command in candidates:
        if command and shutil.which(command[0]):
            return command
    if not asked and importlib.util.find_spec("ziglang"):
        return [sys.executable, "-m", "ziglang", "cc", "-mcpu=baseline"]
    raise NoBinaryError(f"no C compiler {asked[0]}" if asked else "no C compiler; `pip install ziglang` brings one")


def _accepts(compiler: list[str], flags: tuple[str, ...]) -> bool:
    """Return whether a compiler accepts flags without a warning."""
    command = [*compiler, "-Werror", *flags, "-fsyntax-only", "-x", "c", os.devnull]
    return not subprocess.run(command, capture_output=True, check=False).returncode


def build_all(folder: Path = FOLDER) -> tuple[list[Path], str]:
    """Compile modules with outdated binaries in parallel, and return the binaries and a line of status."""
    with ThreadPoolExecutor() as pool:
        builds = [pool.submit(build, folder, name=name) for name in MODULES]
    binaries, outcome = [], []
    for made in builds:
        try:
            binaries.append(made.result())
            outcome.append(binaries[-1].name)
        except (NoBinaryError, OSError) as error:
            outcome.append(f"NumPy serves, `slipcircle info` says how fast: {error}")
    return binaries, ", ".join(dict.fromkeys(outcome))


if __name__ == "__main__":
    print(build_all()[1])
