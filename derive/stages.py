"""Stages of the compiler, and the record of its last run, which is not repeated for the same sources and libraries."""

import hashlib
import json
import time
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path
from typing import TypeVar

from derive.kinds import TextDict, TextMap, Texts, ValueDict
from derive.progress import say

T = TypeVar("T")
ROOT = Path(__file__).resolve().parent.parent
RECORD = ROOT / "generated" / "stages.json"
LIBRARIES = {"sympy": "SymPy", "mpmath": "mpmath", "python-flint": "python-flint"}


def versions() -> TextDict:
    """Return the versions of the libraries that derive and prove."""
    return {library: version(library) for library in LIBRARIES}


def digest_of(text: str) -> str:
    """Return the sha256 of a text."""
    return hashlib.sha256(text.encode()).hexdigest()


def stage(title: str, name: str, work: Callable[[], T], shown: str = "{}") -> T:
    """Return the outcome of a stage, and print its time and its outcome in the format ``shown``."""
    start = time.perf_counter()
    outcome = work()
    seconds = time.perf_counter() - start
    counted = f"{len(outcome)} claims proved" if isinstance(outcome, list) else outcome
    say(f"{title:<32} {name:<11} {seconds:6.2f} s  {shown.format(counted)}")
    return outcome


def recorded() -> ValueDict:
    """Return the record of the last run, empty if it is missing or has marks of a merge."""
    try:
        return dict(json.loads(RECORD.read_text("utf-8")))
    except (OSError, ValueError):
        return {}


def record(texts: TextMap) -> ValueDict:
    """Return the record of a run that writes these files: versions of libraries, digests of sources and of files."""
    paths = (path for path in sorted((ROOT / "derive").rglob("*.*")) if "__pycache__" not in path.parts)
    sources = {str(path.relative_to(ROOT)): path.read_text("utf-8") for path in paths}
    return {
        "versions": versions(),
        "sources": digest_of(json.dumps(sources)),
        "files": digest_of(json.dumps(dict(texts), sort_keys=True)),
    }


def save(texts: TextMap) -> None:
    """Write the record of a run that wrote these files."""
    RECORD.write_text(json.dumps(record(texts), indent=1) + "\n", "utf-8", newline="\n")


def other_versions() -> Texts:
    """Return a line for each library whose version is not the one that wrote `generated`."""
    written_with = recorded().get("versions", {})
    lines = []
    for library, found in versions().items():
        written = written_with.get(library, found)
        if written != found:
            name = LIBRARIES[library]
            remedy = f"pip install {library}=={written}"
            lines.append(f"{name} {found} is installed, but {name} {written} wrote generated/: {remedy}")
    return lines
