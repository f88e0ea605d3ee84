"""Integrator for a browser: `_flow.c` compiled to WebAssembly, compressed, and encoded as text for a page.

The file is under version control, as few machines have a compiler for it (``pip install ziglang``). It contains the
digest of its source, the flags and the version of the compiler, and is compiled again if one of these has changed.
"""

import base64
import gzip
import hashlib
import subprocess
import sys
import tempfile
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path

from derive.check.proof import ProofError

NAME = "flow.wasm.txt"
COMPILER = "0.17.1"  # version of ziglang, also in `constraints.txt`, which wheels do not contain
# Calls of small functions take a tenth of the time; written in place they would take an eighth of the module.
FLAGS = (
    *(
        "-target",
        "wasm32-wasi",
        "-mexec-model=reactor",
        "-msimd128",
        "-Os",
        "-fno-inline",
        "-DLEVEL=wasm",
        "-DWIDE=128",
    ),
    *("-ffp-contract=off", "-fno-math-errno", "-Wl,--strip-all"),
)


def source_digest(source: str) -> str:
    """Return the digest of the source, the flags and the version of the compiler."""
    return hashlib.sha256("\n".join([source, *FLAGS, COMPILER]).encode()).hexdigest()


def browser_text(source: str, present: Path) -> str:
    """Return the digest and the compressed module in base64, from the present file if it is valid.

    ``source`` is the text of `_flow.c`.

    Raises
    ------
    ProofError
        If the module must be compiled and the compiler is missing or has another version.
    """
    expected = source_digest(source)
    held = present.read_text("utf-8") if present.is_file() else ""
    if held.startswith(expected):
        return held
    compressed = gzip.compress(compiled(source), mtime=0)
    return f"{expected}\n{base64.b64encode(compressed).decode()}\n"


def compiled(source: str) -> bytes:
    """Return the WebAssembly module compiled from the text of `_flow.c`."""
    if find_spec("ziglang") is None or version("ziglang") != COMPILER:
        make = f"`pip install ziglang=={COMPILER}`, to make it anew"
        raise ProofError(f"generated/{NAME}", "older than _flow.c", make)
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "ziglang", "cc", *FLAGS, "-o", "flow.wasm", "_flow.c"]
        Path(folder, "_flow.c").write_text(source, "utf-8")
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
        if done.returncode:
            raise ProofError(f"generated/{NAME}: ziglang", done.stderr.strip()[:200], "a module of WebAssembly")
        return Path(folder, "flow.wasm").read_bytes()
