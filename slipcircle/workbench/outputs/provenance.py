"""Inputs of a scene for a reviewer, each with its unit, its meaning and the comment beside it."""

import re
import tomllib
from collections import Counter
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import TextDict, TextMap, Values
from slipcircle.core import Scene
from slipcircle.workbench.common.units import published
from slipcircle.workbench.files.keys import Key
from slipcircle.workbench.files.layout import layout_of
from slipcircle.workbench.files.numbers import uncertain_numbers
from slipcircle.workbench.outputs.tables import ResultTable
from slipcircle.workbench.studies.design import Design

# A table's head or a key with its value, and a comment.
_LINE = r"""\s*(?:\[{1,2}([^\[\]]+)\]{1,2}|([\w-]+)\s*=\s*(?:[^"'#]|"(?:[^"\\]|\\.)*"|'[^']*')*)\s*(?:#(.*))?$"""


class Input(NamedTuple):
    """Input of a scene: path, value and unit as in the file, meaning, and source."""

    path: str
    value: str
    unit: str = ""
    meaning: str = ""
    source: str = ""


def scene_inputs(scene: Scene, file: str) -> list[Input]:
    """Return the inputs of a scene as in the text of its file, with its comments; uncertain inputs are marked."""
    layout = layout_of(tomllib.loads(file))
    inputs = list(_of_table(layout.tables, toml_comments(file), "", layout.content))
    uncertain = {unknown.key: unknown.record for unknown in uncertain_numbers(scene).values()}
    for place, one in enumerate(inputs):
        if one.path in uncertain:
            inputs[place] = one._replace(value=f"uncertain, {_shown(uncertain[one.path])}")
    return inputs


def _of_table(tables: Values, sources: TextMap, path: str, content: Values) -> Iterator[Input]:
    """Yield the inputs of the table at a path of a file and of its subtables.

    ``tables`` are the declared tables by path, ``sources`` the comments by path, and ``content`` is the content of the
    table.
    """
    keys, prefix = tables[path].keys, f"{path}." if path else ""
    for name, value in content.items():
        where = f"{prefix}{name}"
        if where in ("report", "output"):
            continue
        if where in tables:
            if not value:
                yield Input(where, "yes", "", tables[where].title, sources.get(where, ""))
            yield from _of_table(tables, sources, where, value)
        elif published(name)[0] not in keys:
            yield Input(where, _shown(value), "", "file of points, or its unit", sources.get(where, ""))
        elif where not in ("name", "note"):
            key = keys[published(name)[0]].spelt(name)
            source = sources.get(where) or sources.get(path, "")
            of_gravity = "g" if name.endswith("_g") else ""
            yield Input(where, _shown(value), _unit(key) or of_gravity, key.help, source)
    spelt = {published(name)[0] for name in content}
    for name, key in keys.items():
        title, _, default = key.help.partition(", by default ")
        if default and name not in spelt and name != "name":
            yield Input(f"{prefix}{name}", default, _unit(key), title, "default")


def _unit(key: Key) -> str:
    """Return the unit in the description of a key, or an empty text."""
    unit = re.search(r"\(([^()]*)\)$", key.allowed)
    if unit:
        return unit[1]
    return ""


def toml_comments(file: str) -> TextDict:
    """Return the comments at the ends of lines of a TOML text, by the path of the key or table in the line.

    Tables of a list are numbered from 1; quotes of names are dropped.
    """
    comments = {}
    table = ""
    counts: Counter[str] = Counter()
    for line in file.splitlines():
        what = re.match(_LINE, line)
        if what is None:
            continue
        table = (what[1] or table).replace('"', "").strip()
        if what[1] and line.strip().startswith("[["):
            counts[table] += 1
            table = f"{table}.{counts[table]}"
        path = table if what[1] else f"{table}.{what[2]}".lstrip(".")
        if what[3]:
            comments[path] = what[3].strip()
    return comments


def _shown(value: Any) -> str:
    """Return a value in full as text; for a long list its ends, for a distribution its name and parameters."""
    if isinstance(value, Mapping):
        parameters = dict(value)
        name = parameters.pop("distribution")
        words = ", ".join(f"{key} {number}" for key, number in parameters.items() if key != "key")
        if words:
            return f"{name}: {words}"
        return str(name)
    if isinstance(value, str):
        return value
    if isinstance(value, bool):
        return str(value).lower()
    texts = [repr(x) for x in np.ravel(value).tolist()]
    count = len(texts)
    if count > 12:
        texts = [*texts[:3], "...", *texts[-3:], f"({count} numbers)"]
    return ", ".join(texts)


def uncertain_part(design: Design) -> Iterator[ResultTable]:
    """Yield a table of the distributions of uncertain inputs with their correlations; nothing if none are."""
    rows = [[unknown.key, _shown(unknown.record)] for unknown in design.drawn.values()]
    note = f"{design.correlations_text}; all others are independent" if design.correlations else "all are independent"
    if rows:
        yield ResultTable(["input", "distribution"], rows, "What is uncertain", note)
