"""Wheels for other machines, and the source distribution: `python -m derive.wheels`.

One machine makes all of them: Zig, of the package index, compiles for each. The binaries ask for Python's stable ABI
and find the processor's level themselves. Two builds of one source are the same bytes.
"""

import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import zlib
from concurrent.futures import ThreadPoolExecutor
from importlib.util import find_spec
from pathlib import Path

from derive.build import FLAGS, FOLDER, MODULES, NoBinaryError, make, object_flags

ROOT = FOLDER.parent
HERE = Path(__file__).parent
# Tags of platforms, and their names for Zig; `any` has no binary.
TARGETS = {
    "manylinux_2_17_x86_64.manylinux2014_x86_64": "x86_64-linux-gnu.2.17",
    "manylinux_2_17_aarch64.manylinux2014_aarch64": "aarch64-linux-gnu.2.17",
    "musllinux_1_2_x86_64": "x86_64-linux-musl",
    "win_amd64": "x86_64-windows-gnu",
    "macosx_11_0_x86_64": "x86_64-macos.11.0",
    "macosx_11_0_arm64": "aarch64-macos.11.0",
    "any": "",
}
ZIG = (sys.executable, "-m", "ziglang")
# Its unrolled loops are a sixth larger, vectors for the remainder of a loop a hundredth, and neither is faster.
ZIG_FLAGS = {"_kernels": ("-fno-unroll-loops", "-mllvm", "-enable-epilogue-vectorization=false"), "_flow": ()}
# The library that Zig adds to a binary for Windows has 30 kB, of which two functions are needed; Windows has the other.
WINDOWS = ("-nostdlib", "-lc", str(HERE / "stack.s"))
WINDOWS_NAMES = ("-D__isnan=_isnan", "-fno-builtin-cos")  # or a sine beside a cosine becomes `sincos`, which it lacks
LARGEST = 1.3e6  # bytes of a wheel; larger wheels are reported
STABLE = ("-DPy_LIMITED_API=0x030b0000", "-DNDEBUG", "-g0")
# NumPy's headers contain the sizes of this machine; of the sizes in our source only these differ elsewhere.
SIZES = """
#undef NPY_HAVE_ENDIAN_H
#ifdef _WIN32
#undef NPY_SIZEOF_LONG
#define NPY_SIZEOF_LONG 4
#undef NPY_SIZEOF_LONGDOUBLE
#define NPY_SIZEOF_LONGDOUBLE 8
#undef NPY_SIZEOF_WCHAR_T
#define NPY_SIZEOF_WCHAR_T 2
#endif
"""


def headers(folder: Path) -> Path:
    """Fill a folder with the headers of Python and NumPy for all platforms and Windows' import library; return it."""
    import numpy as np

    shutil.copytree(sysconfig.get_path("include"), folder)
    shutil.copytree(np.get_include(), folder, dirs_exist_ok=True)
    shutil.copy(HERE / "pyconfig.h", folder)
    with (folder / "numpy" / "_numpyconfig.h").open("a", encoding="utf-8") as sizes:
        sizes.write(SIZES)
    texts = (path.read_text("utf-8") for path in sorted(folder.glob("*.h")))
    names = {name for text in texts for name in re.findall(r"\b_?Py\w+", text)}
    exports = folder / "python3.def"
    exports.write_text("\n".join(["LIBRARY python3.dll", "EXPORTS", *sorted(names)]), "utf-8")
    subprocess.run((*ZIG, "dlltool", "-m", "i386:x86-64", "-d", exports, "-l", folder / "libpython3.a"), check=True)
    return folder


def binaries(folder: Path) -> None:
    """Compile the modules for all platforms, each into a subfolder of the folder with the platform's name."""
    common = headers(folder / "headers")
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        jobs = []
        for platform, triple in TARGETS.items():
            (folder / platform).mkdir()
            jobs += [pool.submit(compile_for, triple, name, folder / platform, common) for name in MODULES if triple]
        for job in jobs:
            job.result()


def compile_for(triple: str, name: str, folder: Path, headers: Path) -> Path:
    """Compile the module ``name`` for one platform into a folder, and return the path of the binary.

    ``triple`` is the platform's name for Zig, and ``headers`` the folder that `headers` returns.
    """
    target = folder / f"{name}{'.pyd' if 'windows' in triple else '.abi3.so'}"
    compiler = [*ZIG, "cc", "-target", triple, "-mcpu=baseline", *FLAGS, *ZIG_FLAGS[name], *STABLE, f"-I{headers}"]
    link = ["-shared", "-s"]
    if "macos" in triple:
        link += ["-Wl,-undefined,dynamic_lookup", f"-Wl,-install_name,{target.name}"]  # or the path is in the bytes
    if "windows" in triple:
        compiler += WINDOWS_NAMES
        link += [f"-L{headers}", "-lpython3", "-Os", *WINDOWS]  # -Os is for what Zig adds from its libraries
    make(FOLDER / f"{name}.c", target, compiler, object_flags(name, triple.partition("-")[0]), link)
    return target


def distributions(folder: Path) -> list[Path]:
    """Return the paths of the wheel of each platform and of the source distribution, written into a folder.

    The folder contains the binaries, as `binaries` leaves them.
    """
    from hatchling.builders.sdist import SdistBuilder
    from hatchling.builders.wheel import WheelBuilder

    made: list[str] = []
    vars(zlib)["Z_DEFAULT_COMPRESSION"] = zlib.Z_BEST_COMPRESSION  # hatchling has no word for it; half a percent
    for platform in TARGETS:
        os.environ["SLIPCIRCLE_BINARIES"] = str(folder / platform)
        made += WheelBuilder(str(ROOT)).build(directory=str(folder), versions=["standard"])
    made += SdistBuilder(str(ROOT)).build(directory=str(folder))
    return [Path(path) for path in made]


def main() -> int:
    """Write all distributions into `dist`, replacing existing files at the end."""
    if not find_spec("ziglang"):
        print("derive.wheels needs Zig: pip install ziglang", file=sys.stderr)
        return 2
    dist = ROOT / "dist"
    dist.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory(dir=dist, prefix=".") as folder:
        scratch = Path(folder)
        try:
            binaries(scratch)
        except NoBinaryError as error:
            print(f"derive.wheels: {error}", file=sys.stderr)
            return 1
        made = distributions(scratch)
        for path in made:
            print(f"{path.stat().st_size / 1e6:6.3f} MB  dist/{path.name}")
        large = [path.name for path in made if path.suffix == ".whl" and path.stat().st_size > LARGEST]
        if large:
            print(f"derive.wheels: over {LARGEST / 1e6} MB: {', '.join(large)}", file=sys.stderr)
        for path in made:
            os.replace(path, dist / path.name)
    return 0


if __name__ == "__main__":
    sys.exit(main())
