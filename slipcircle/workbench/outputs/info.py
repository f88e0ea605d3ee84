"""Installed versions and digests of the generated files."""

import hashlib
import platform
import re
from importlib import metadata
from importlib.util import find_spec
from pathlib import Path

import generated
from generated._compiled import FREE_THREADED, LEVEL, is_free_threaded
from slipcircle.base import VERSION
from slipcircle.base.kinds import TextDict
from slipcircle.base.optional import EXTRAS, install
from slipcircle.messages import describe_integrator


def facts() -> TextDict:
    """Return versions, the processor, the kernels in use, and digests of the generated files, as texts by name."""
    remedy = FREE_THREADED if is_free_threaded() else "`python -m derive.build` compiles them"
    kernels = f"NumPy, not compiled: {remedy}" if LEVEL == "numpy" else f"compiled, {LEVEL}"
    versions = {"slipcircle": VERSION, "python": platform.python_version(), "processor": processor()}
    versions |= {"kernels": kernels, "integrator": describe_integrator()}
    for library in ("numpy", *EXTRAS):
        try:
            versions[library] = metadata.version(library)
        except metadata.PackageNotFoundError:
            versions[library] = f"not installed: {install(library)}"
    ours = Path(str(generated.__file__)).parent
    derive = find_spec("derive")
    if derive is not None and derive.origin != str(ours.parent / "derive" / "__init__.py"):
        versions["derive"] = f"in the way is {derive.origin}: rename it, or start in another folder"
    for path in sorted(ours.glob("*.py")):
        versions[f"generated/{path.name}"] = "sha256 " + hashlib.sha256(path.read_bytes()).hexdigest()[:16]
    return versions


def processor() -> str:
    """Return the name of the processor."""
    try:
        named = re.search(r"^model name\s*: (.+)$", Path("/proc/cpuinfo").read_text("utf-8"), re.MULTILINE)
    except OSError:
        named = None
    if named:
        return named[1]
    return platform.processor() or platform.machine()


def machine() -> str:
    """Return the processor and the installed versions as text, to be printed with measured times."""
    return ", ".join(f"{k} {v}" for k, v in facts().items() if "/" not in k and not v.startswith("not "))
