"""The extension module `generated._kernels`, compiled in place: `python -m derive.build`, and at install time.

Flags of the environment are left out: the proofs are about the operations as they are written.
"""

import os
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tempfile
from pathlib import Path

FOLDER = Path(__file__).resolve().parent.parent / "generated"
# Vector loops need three of them: no errno from sqrt, pieces that are not used may raise a flag (cleared later), and no
# branches made of comparisons. The last two are worth a tenth of the time: many chains of operations side by side.
FLAGS = ("-O3", "-fPIC", "-fno-fast-math", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math",
         "-fno-thread-jumps", "-fschedule-insns", "-fsched-pressure")  # fmt: skip
SHARED = ("-bundle", "-undefined", "dynamic_lookup") if sys.platform == "darwin" else ("-shared",)


class NoBinaryError(Exception):
    """Why there is no binary, in one line; NumPy serves without one."""


def build(folder: Path = FOLDER, flags: tuple[str, ...] = FLAGS) -> Path:
    """Compile `_kernels.c` beside itself, unless the binary there was made of it.

    Raises
    ------
    NoBinaryError
        If a C compiler, the headers of Python or NumPy, or the wish for it are missing, or if it does not compile.
    """
    source, binary = folder / "_kernels.c", folder / f"_kernels{sysconfig.get_config_var('EXT_SUFFIX')}"
    if os.environ.get("SLIPCIRCLE_COMPILED") == "0":
        raise NoBinaryError("SLIPCIRCLE_COMPILED is 0")
    digest = source.read_text("utf-8").split('"', 2)[1]  # of the header's #define
    if binary.is_file() and digest.encode() in binary.read_bytes():
        return binary
    compiler = shlex.split(os.environ.get("CC") or sysconfig.get_config_var("CC") or "")
    if not compiler or not shutil.which(compiler[0]):
        raise NoBinaryError(f"no C compiler ({' '.join(compiler) or 'CC is not set'})")
    try:
        import numpy as np
    except ImportError as error:
        raise NoBinaryError(f"no NumPy to compile with ({error})") from None
    includes = (f"-I{sysconfig.get_path('include')}", f"-I{np.get_include()}")
    with tempfile.TemporaryDirectory(dir=folder, prefix=".") as made:
        target = Path(made) / binary.name
        command = [*compiler, *flags, *SHARED, *includes, str(source), "-o", str(target), "-lm"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode:
            raise NoBinaryError(f"{compiler[0]} fails: {done.stderr.strip().splitlines()[:1]}")
        os.replace(target, binary)
    return binary


if __name__ == "__main__":
    try:
        print(build())
    except NoBinaryError as error:
        print(f"NumPy serves: {error}")
