"""Records of the compiler's stages: a stage whose inputs are unchanged is not run again.

The inputs of a stage are the text of its module and of every module of `derive` that this one imports, the files that
these read, the declarations that the stage is given, and the versions of the libraries. A record has their digest and
the outcome; the outcome of a stage that writes files is the digest of each file, so that an edited file is no match.
"""

import ast
import hashlib
import json
import time
from collections.abc import Callable, Iterable
from dataclasses import fields, is_dataclass
from functools import cache, lru_cache
from importlib import import_module
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any, TypeVar

from derive.progress import say

T = TypeVar("T")
ROOT = Path(__file__).resolve().parent.parent
RECORDS = ROOT / "generated" / "stages.json"
LIBRARIES = {"sympy": "SymPy", "mpmath": "mpmath", "python-flint": "python-flint"}
DECLARED = {"MOMENTS", "LAWS", "EFFECTS", "SECTION_EFFECTS"}
READERS = ("read_text", "inspect.")  # a module with one of these may read any file in its folder


def versions() -> dict[str, str]:
    """Return the versions of the libraries that derive and prove; without those that are not installed."""
    found = {}
    for library in LIBRARIES:
        try:
            found[library] = version(library)
        except PackageNotFoundError:
            continue
    return found


def digest_of(text: str) -> str:
    """Return the sha256 of a text."""
    return hashlib.sha256(text.encode()).hexdigest()


def _module(name: str) -> Path | None:
    """Return the file of a module of `derive`."""
    path = ROOT.joinpath(*name.split("."))
    for file in (path.with_suffix(".py"), path / "__init__.py"):
        if name.startswith("derive") and file.is_file():
            return file
    return None


@cache
def _parsed(path: Path, text: str) -> ast.Module:
    return ast.parse(text, str(path))


@cache
def _imported(path: Path, text: str) -> frozenset[str]:
    """Return the names of all modules, and of their members, that the text of a module imports."""
    names = set[str]()
    for node in ast.walk(_parsed(path, text)):
        if isinstance(node, ast.Import):
            names.update(x.name for x in node.names)
        if isinstance(node, ast.ImportFrom):
            package = str(node.module)
            names.add(package)
            names.update(f"{package}.{x.name}" for x in node.names)
    return frozenset(names)


@cache
def _needs(path: Path) -> frozenset[Path]:
    """Return the files that a module imports from `derive` or may read."""
    text = path.read_text("utf-8")
    names = {".".join(path.relative_to(ROOT).parent.parts), *_imported(path, text)}
    needed = {_module(name) for name in names} - {None}
    if path.name != Path(__file__).name and any(reader in text for reader in READERS):
        needed.update(path.parent.rglob("*.*"))
    return frozenset(x for x in needed if x and "__pycache__" not in x.parts)


@cache
def sources(module: str) -> frozenset[Path]:
    """Return the files on which a module of `derive` depends."""
    reached: set[Path] = set()
    waiting = {_module(module)}
    while waiting:
        path = waiting.pop()
        if path is None or path in reached:
            continue
        reached.add(path)
        if path.suffix == ".py":
            waiting |= _needs(path)
    return frozenset(reached)


@cache
def _text(path: Path, without_declarations: bool) -> str:
    """Return the text of a file, without the tuples of declarations if the stage is given those that it uses."""
    text = path.read_text("utf-8")
    if not without_declarations or path.parent.name != "declare":
        return text
    lines = text.splitlines()
    for node in reversed(_parsed(path, text).body):
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) in DECLARED:
            del lines[node.lineno - 1 : node.end_lineno]
    return "\n".join(lines)


def _described(argument: Any) -> Any:
    """Return a declaration as plain data; symbols have their assumptions."""
    if isinstance(argument, str | dict):
        return argument
    if isinstance(argument, tuple | list):
        return [_described(x) for x in argument]
    if is_dataclass(argument):
        return [_described(getattr(argument, f.name)) for f in fields(argument)]
    return _symbolic(argument)


@lru_cache(maxsize=None, typed=True)
def _symbolic(argument: Any) -> str:
    """Return a formula, a number or a truth value as SymPy writes it."""
    return str(import_module("sympy").srepr(argument))


@cache
def _own() -> str:
    return digest_of(Path(__file__).read_text("utf-8") + json.dumps(versions()))


def inputs(module: str, name: str, arguments: Iterable[object] = ()) -> str:
    """Return the digest of everything on which the outcome of a function depends."""
    described = _described(list(arguments))
    has_declarations = bool(described)
    texts = {}
    for path in sorted(sources(module)):
        place = str(path.relative_to(ROOT))
        texts[place] = _text(path, has_declarations)
    return digest_of(json.dumps([_own(), name, described, texts]))


def report_stage(title: str, stage: str, time_taken: str, outcome: str) -> None:
    """Print the line of a stage."""
    say(f"{title:<32} {stage:<11} {time_taken:<8}  {outcome}")


class Stages:
    """Stages of one run, with the records of earlier runs and of this run."""

    def __init__(self, again: bool = False) -> None:
        """Read the records, or with ``again`` run every stage."""
        try:
            recorded = json.loads(RECORDS.read_text("utf-8"))
        except (OSError, ValueError):  # missing, or with marks of a merge
            recorded = {}
        self.written_with: dict[str, str] = recorded.get("versions", {})
        self.known: dict[str, Any] = {} if again else recorded.get("stages", {})
        self.records: dict[str, Any] = {}

    def other_versions(self) -> list[str]:
        """Return a line for each library whose version is not the one that wrote `generated`."""
        lines = []
        for library, found in versions().items():
            written = self.written_with.get(library, found)
            if written != found:
                name = LIBRARIES[library]
                remedy = f"pip install {library}=={written}"
                lines.append(f"{name} {found} is installed, but {name} {written} wrote generated/: {remedy}")
        return lines

    def run(self, title: str, stage: str, work: str, *arguments: object, shown: str = "{}") -> Any:
        """Return the outcome of ``module:function`` for these arguments, recorded or computed, and print a line."""
        module, name = work.split(":")
        key = f"{title}, {stage}"
        record = {"inputs": inputs(module, name, arguments)}
        start = time.perf_counter()
        known = self.known.get(key, {})
        is_recorded = known.get("inputs") == record["inputs"]
        if is_recorded:
            outcome = known["outcome"]
        else:
            function = getattr(import_module(module), name)
            outcome = function(*arguments)
        self.records[key] = record | {"outcome": outcome}
        if shown:
            seconds = time.perf_counter() - start
            counted = f"{len(outcome)} claims proved" if isinstance(outcome, list) else outcome
            report_stage(title, stage, "recorded" if is_recorded else f"{seconds:6.2f} s", shown.format(counted))
        return outcome

    def line(self, title: str, stage: str, work: Callable[[], T], shown: str) -> T:
        """Run a stage that has records of its own or none, and print its time and outcome."""
        start = time.perf_counter()
        outcome = work()
        seconds = time.perf_counter() - start
        report_stage(title, stage, f"{seconds:6.2f} s", shown.format(outcome))
        return outcome

    def files(self, title: str, work: str, present: dict[str, str], *declared: object) -> dict[str, str]:
        """Return the texts that ``module:function`` writes, by file; the present ones where the records match them.

        The function receives these stages. ``declared`` are the declarations that it uses, by default all of them.
        """
        module, name = work.split(":")
        key = f"{title}, files"
        digest = inputs(module, name, declared)
        known = self.known.get(key, {})
        if known.get("inputs") == digest:
            recorded: dict[str, str] = known["outcome"]
            texts = {x: present.get(x, "") for x in recorded}
            if recorded == {x: digest_of(text) for x, text in texts.items()}:
                self.records |= {part: self.known[part] for part in known["parts"]}
                self.records[key] = known
                report_stage(title, "files", "recorded", f"{len(texts)} as they are")
                return texts
        before = set(self.records)
        function = getattr(import_module(module), name)
        texts = function(self)
        parts = sorted(set(self.records) - before)
        digests = {x: digest_of(text) for x, text in texts.items()}
        self.records[key] = {"inputs": digest, "outcome": digests, "parts": parts}
        return texts

    def save(self, keep: bool = False) -> None:
        """Write the records of this run; with ``keep`` also the records of stages that did not run."""
        kept = (self.known if keep else {}) | self.records
        rows = [f"  {json.dumps(key)}: {json.dumps(kept[key])}" for key in sorted(kept)]
        stages = ",\n".join(rows)
        text = f'{{\n "versions": {json.dumps(versions())},\n "stages": {{\n{stages}\n }}\n}}\n'
        RECORDS.write_text(text, "utf-8", newline="\n")
