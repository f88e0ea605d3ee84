"""Names that are promised: of Python, of commands, of scene files and of what is written for machines.

`python -m tests.support.promises` brings ``promises.txt`` up to date: it adds what is new, and drops a name only if
CHANGELOG.md announces it, in backticks and as it stands there, under "Removed".
"""

import contextlib
import csv
import inspect
import io
import json
import os
import re
import tempfile
import tomllib
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from enum import EnumType
from pathlib import Path
from typing import Any

import generated
import slipcircle
from slipcircle import __main__ as line
from slipcircle.workbench.commands import COMMANDS
from slipcircle.workbench.files.schema import schema
from slipcircle.workbench.files.shipped import shipped

ROOT = Path(__file__).parents[2]
FILE = Path(__file__).with_suffix(".txt")
# Classes that users make; of others the constructor is not promised.
MADE = ("Arc", "Interval", "LayeredSection", "Pulse", "Record", "Scene", "Section", "Series", "Slope", "Soil")
QUAKE = "time_s,k_h_g\n0,0\n0.5,0.3\n1,-0.3\n1.5,0\n"
DRAWN = "--uncertain friction.angle_deg=normal:10:1"
# Commands whose JSON has all the keys that there are; `cost` and `info` say what was measured and installed here.
ANSWERED = (
    "new slope.toml",
    "run vaiont vaiont-shaken real-slope layered-slope",
    "plan vaiont --ladder",
    "plan layered-slope",
    "search real-slope",
    "sensitivity vaiont",
    "backanalyse vaiont --run-out-m 400",
    "backanalyse vaiont --run-out-m 400+-20 --duration-s 40+-5 --field friction.angle_deg",
    "sweep vaiont --grid friction.angle_deg=8,10",
    f"sweep vaiont --samples 16 {DRAWN}",
    "sweep newmark-pulse --records quake.csv",
    "records quake.csv",
)


def promises() -> set[str]:
    """Return all promises, one text each."""
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]["optional-dependencies"]
    return {
        *_of_module(generated),
        *_of_module(slipcircle),
        *_of_commands(),
        *(f"scene {name}" for name in shipped()),
        *_of_schema(schema(), "[scene file]"),
        *_of_answers(),
        *(f"extra {name}" for name in extras),
    }


def unannounced(missing: Iterable[str], changelog: str) -> set[str]:
    """Return the missing promises that are not listed under "Removed", nor belong to a listed name."""
    parts = re.findall(r"^### Removed\n(.*?)(?=^##|\Z)", changelog, re.MULTILINE | re.DOTALL)
    said = {text for part in parts for text in re.findall(r"`([^`]+)`", part)}
    return {name for name in missing if not said & {name, *(name[: m.start()] for m in re.finditer(r"[.( ]", name))}}


def _of_module(module: Any) -> Iterator[str]:
    for name in module.__all__:
        value, path = getattr(module, name), f"{module.__name__}.{name}"
        yield path
        if not inspect.isclass(value):
            yield from _parameters(value, path)
            continue
        if name in MADE:
            yield from _parameters(value, path)
        yield from _of_class(value, path)


def _of_class(kind: Any, path: str) -> Iterator[str]:
    """Public attributes that are the package's own, and the parameters of methods."""
    members = [*kind.__members__, *inspect.get_annotations(kind)] if isinstance(kind, EnumType) else []
    own = [field.name for field in fields(kind)] if is_dataclass(kind) else [*getattr(kind, "_fields", ())]
    for base in kind.__mro__:
        if base.__module__.startswith("slipcircle"):
            own += vars(base)
    for name in {*members, *own}:
        if not name.startswith("_"):
            yield f"{path}.{name}"
            value = inspect.getattr_static(kind, name, None)
            method = value.__func__ if isinstance(value, classmethod | staticmethod) else value
            if inspect.isfunction(method):
                yield from _parameters(method, f"{path}.{name}")


def _parameters(called: Callable[..., Any], path: str) -> Iterator[str]:
    """Return the parameters that may be given by name."""
    by_name = (inspect.Parameter.POSITIONAL_OR_KEYWORD, inspect.Parameter.KEYWORD_ONLY)
    for name, parameter in inspect.signature(called).parameters.items():
        if parameter.kind in by_name and name not in ("self", "cls") and not name.startswith("_"):
            yield f"{path}({name})"


def _of_commands() -> Iterator[str]:
    for name in COMMANDS:
        (commands,) = (action.choices for action in line._parser(name)._actions if isinstance(action.choices, dict))
        for action in commands[name]._actions:
            for option in action.option_strings or [str(action.metavar)]:
                yield f"slipcircle {name} {option}"


def _of_schema(node: Any, path: str) -> Iterator[str]:
    """Keys of scene files, and the words that they allow."""
    if not isinstance(node, dict):
        return
    for name, inner in (node.get("properties", {}) | node.get("$defs", {})).items():
        inside = f"[{name}]" if name in node.get("$defs", {}) else f"{path}.{name}"
        yield inside
        yield from _of_schema(inner, inside)
    yield from (f"{path} = {word}" for word in (*node.get("enum", ()), *([node["const"]] if "const" in node else [])))
    for inner in (*node.get("anyOf", ()), node.get("items"), node.get("additionalProperties")):
        yield from _of_schema(inner, path)


def _of_answers() -> Iterator[str]:
    """Keys of JSON, and heads of the table of a motion."""
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        Path("quake.csv").write_text(QUAKE, "utf-8")
        for words in ANSWERED:
            with contextlib.redirect_stdout(io.StringIO()) as out, contextlib.redirect_stderr(io.StringIO()) as err:
                status = line.main([*words.split(), "--json"])
            assert status == 0, err.getvalue()
            yield from _keys(json.loads(out.getvalue()), f"{words.split()[0]} --json")
        with contextlib.redirect_stdout(io.StringIO()):
            line.main(["run", "vaiont", "--csv", "motion.csv"])
        yield from (
            f"run --csv {head}" for head in next(csv.reader(io.StringIO(Path("motion.csv").read_text("utf-8"))))
        )


def _keys(value: Any, path: str) -> Iterator[str]:
    for inner in value if isinstance(value, list) else ():
        yield from _keys(inner, path)
    for key, inner in value.items() if isinstance(value, Mapping) else ():
        yield f"{path} {key}" if path.endswith("--json") else f"{path}.{key}"
        yield from _keys(inner, f"{path} {key}" if path.endswith("--json") else f"{path}.{key}")


def main() -> None:
    """Bring the list up to date."""
    stored, now = {*FILE.read_text("utf-8").splitlines()} if FILE.exists() else set[str](), promises()
    kept = unannounced(stored - now, (ROOT / "CHANGELOG.md").read_text("utf-8"))
    for name in sorted(kept):
        print(f"{name}: is gone, and CHANGELOG.md does not say so under Removed")
    FILE.write_text("".join(f"{name}\n" for name in sorted(kept | now)), "utf-8")
    print(f"{len(now - stored)} new, {len(stored - now - kept)} announced and dropped, {len(kept)} not announced")


if __name__ == "__main__":
    os.environ.setdefault("COLUMNS", "100")
    main()
