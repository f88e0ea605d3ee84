"""What is installed: versions, and the digests of the generated files."""

import hashlib
import platform
from importlib import metadata
from pathlib import Path

import generated
import slipcircle
from generated._compiled import LEVEL


def facts() -> dict[str, str]:
    """Versions of the package, Python and the libraries that it can use, what runs, digests of the generated text."""
    kernels = "NumPy, not compiled" if LEVEL == "numpy" else f"compiled, {LEVEL}"
    found = {"slipcircle": slipcircle.__version__, "python": platform.python_version(), "processor": processor(),
             "kernels": kernels}  # fmt: skip
    for library in ("numpy", "scipy", "matplotlib", "dask", "sympy", "mpmath", "python-flint"):
        try:
            found[library] = metadata.version(library)
        except metadata.PackageNotFoundError:
            found[library] = "not installed"
    for path in sorted(Path(str(generated.__file__)).parent.glob("*.py")):
        found[f"generated/{path.name}"] = "sha256 " + hashlib.sha256(path.read_bytes()).hexdigest()[:16]
    return found


def processor() -> str:
    """Its name, with what makes a difference here."""
    try:
        text = Path("/proc/cpuinfo").read_text("utf-8")
    except OSError:
        return platform.processor() or platform.machine()
    facts = {k.strip(): v.strip() for k, _, v in (line.partition(":") for line in text.splitlines())}
    flags = [f for f in ("avx512f", "avx2", "fma") if f in facts.get("flags", "").split()]
    return " ".join([facts.get("model name", platform.machine()), *([f"({', '.join(flags)})"] if flags else [])])


def machine() -> str:
    """Processor and versions, to stand beside times."""
    return ", ".join(f"{k} {v}" for k, v in facts().items() if "/" not in k and v != "not installed")
