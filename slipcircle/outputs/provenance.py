"""What went into a scene, for a reviewer: every input with its unit, its meaning and the comment beside it."""

import re
import tomllib
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from generated.effects import EFFECTS, LAWS
from slipcircle.base.series import Pulse, Series
from slipcircle.scene.arc import QUANTITIES
from slipcircle.scene.friction import RATE_LAWS
from slipcircle.scene.keys import SLOPING, Key, tables_of
from slipcircle.scene.scene import Scene

_SI = dict(zip((*QUANTITIES, "ground", "centre", "level"), ("m", "rad", "rad", "N/m^3", "m/s^2", *"mmmm"), strict=True))


class Input(NamedTuple):
    """One input: its path in the scene, its value and unit as given, what it is, and where it comes from."""

    path: str
    value: str
    unit: str = ""
    meaning: str = ""
    source: str = ""


def inputs(scene: Scene, file: str | None = None) -> list[Input]:
    """The inputs of a scene: as the text of its file has them, with its comments; without that, in SI units.

    What is uncertain says so.
    """
    drawn = {path: u for u in scene.uncertain.values() for path in (u.key, u.number.name, f"arc.{u.number.name}")}

    def marked(found: Input) -> Input:
        if found.path not in drawn:
            return found
        said = _shown({k: v for k, v in drawn[found.path].record.items() if k != "key"})
        return found._replace(value=f"uncertain, {said}" + (f"; here {found.value}" if file is None else ""))

    return [marked(i) for i in (_of_scene(scene) if file is None else _of_file(file))]


def _of_file(file: str) -> Iterator[Input]:
    document, said = tomllib.loads(file), comments(file)
    law = document.get("friction", {})
    tables = tables_of(law.get("law", "constant"), law.get("rate", {}).get("law", RATE_LAWS[0])) | dict(SLOPING)

    def rows(path: str, given: Mapping[str, Any]) -> Iterator[Input]:
        known, dot = tables[path].keys, f"{path}." if path else ""
        for name, value in given.items():
            where = f"{dot}{name}"
            if where in tables:
                if not value:
                    yield Input(where, "yes", "", tables[where].title, said.get(where, ""))
                yield from rows(where, value)
            elif where not in ("name", "note"):
                key, source = known[name], said.get(where) or said.get(path, "")
                yield Input(where, _shown(value), _unit(key) or "g" * name.endswith("_g"), key.title, source)
        for name, key in known.items():
            title, _, default = key.title.partition(", by default ")
            if default and name not in given and name != "name":
                yield Input(f"{dot}{name}", default, _unit(key), title, "default")

    yield from rows("", document)


def _unit(key: Key) -> str:
    """The unit that a key says it has."""
    found = re.search(r"\(([^()]*)\)$", key.allowed)
    return found[1] if found else ""


def comments(file: str) -> dict[str, str]:
    """The comments at the ends of a TOML file's lines, by the path of the key or table that stands there."""
    found, table = {}, ""
    for line in file.splitlines():
        what = re.match(
            r"""\s*(?:\[([^\[\]]+)\]|([\w-]+)\s*=\s*(?:[^"'#]|"(?:[^"\\]|\\.)*"|'[^']*')*)\s*(?:#(.*))?$""", line
        )
        if what is None:
            continue
        table = (what[1] or table).strip()
        path = table if what[1] else f"{table}.{what[2]}".lstrip(".")
        if what[3]:
            found[path] = what[3].strip()
    return found


def _of_scene(scene: Scene) -> Iterator[Input]:
    for name in [n for n in scene.arc.quantities if getattr(scene.arc, n) is not None]:
        yield Input(f"arc.{name}", _shown(getattr(scene.arc, name)), _SI[name])
    for name, coefficient in (scene.arc.given or {}).items():
        yield Input(f"arc.given.{name}", _shown(coefficient), "", "coefficient of the equation of motion, as given")
    if callable(scene.friction):
        yield Input("friction", "a Python function of slip", "", "friction coefficient")
    elif isinstance(scene.friction, Mapping):
        for path, given in (("friction", scene.friction), ("friction.rate", scene.friction.get("rate", {}))):
            if given:
                law = LAWS[given["law"]]
                yield Input(f"{path}.law", given["law"], "", law.help)
                yield from _parameters(path, law, given)
    else:
        yield Input("friction", _shown(scene.friction), "", "friction coefficient, tan(phi)")
    for name, given in scene.called.items():
        yield Input(name, "yes", "", EFFECTS[name].help)
        yield from _parameters(name, EFFECTS[name], given)
    yield Input("initial_velocity", _shown(scene.initial_velocity), "m/s", "velocity along the arc at the start")
    end = ("when the mass rests", "") if scene.end_time is None else (_shown(scene.end_time), "s")
    yield Input("end_time", *end, "time of the end")


def _parameters(path: str, declared: Any, given: Mapping[str, Any]) -> Iterator[Input]:
    for p in declared.parameters:
        if p.name in given:
            value = "of the section's water level" if p.kind == "rotation" else _shown(given[p.name])
            yield Input(f"{path}.{p.name}", value, p.unit, p.help)


def _shown(value: Any) -> str:
    """A value in full; of a long list its ends, of a distribution its name and numbers."""
    if isinstance(value, Mapping):
        return f"{value['distribution']}: " + ", ".join(f"{k} {v}" for k, v in value.items() if k != "distribution")
    if isinstance(value, str):
        return value
    if isinstance(value, Series):
        return f"{len(value.time)} samples from {value.time[0]:g} to {value.time[-1]:g} s"
    if isinstance(value, Pulse):
        return f"{value.name} pulse of at most {value.amplitude:g}, from {value.start:g} to {value.end:g} s"
    if callable(value):
        return repr(value)
    if isinstance(value, bool):
        return str(value).lower()
    texts = [repr(x) for x in np.ravel(value).tolist()]
    return ", ".join(texts if len(texts) <= 12 else [*texts[:3], "...", *texts[-3:], f"({len(texts)} numbers)"])
