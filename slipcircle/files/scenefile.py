"""Scenes read from TOML files, every mistake listed at once, and the scenes that ship."""

import json
import math
import os
import re
import tomllib
from collections.abc import Mapping
from difflib import get_close_matches
from importlib import resources
from os import PathLike
from pathlib import Path
from typing import Any

from generated.effects import EFFECTS, LAWS
from slipcircle.base.distributions import distribution_mistakes, made
from slipcircle.files import slopefile
from slipcircle.files.scenekeys import model_of
from slipcircle.files.slopekeys import GEOMETRY
from slipcircle.scene.arc import Arc
from slipcircle.scene.friction import RATE_LAWS, law_mistakes
from slipcircle.scene.keys import Key, Table, tables_of
from slipcircle.scene.numbers import numbers
from slipcircle.scene.scene import Scene
from slipcircle.scene.section import Section

_NO_ARC = {"radius_m": 1.0, "theta_1_deg": 225.0, "theta_2_deg": 315.0, "unit_weight_kN_m3": 20.0}  # never solved
_FOLDER = resources.files("slipcircle") / "scenes"


def shipped() -> tuple[str, ...]:
    """Names of the scenes that ship."""
    return tuple(sorted(f.name.removesuffix(".toml") for f in _FOLDER.iterdir() if f.name.endswith(".toml")))


def load(name: str | PathLike[str]) -> Scene:
    """A scene that ships, by name, or one's own, by the path of its file; see `Scene.load`."""
    if name in shipped():
        return _scene(find(name), f"{name}.toml", check=False)
    return read(find(name))


def find(name: str | PathLike[str]) -> Any:
    """The file of a scene that ships, by name; or one's own, by its path."""
    if name in (names := shipped()):
        return _FOLDER / f"{name}.toml"
    path = Path(name)
    if os.path.exists(path) and not os.path.isdir(path):  # no error for names that no file can have
        return path
    near = get_close_matches(path.stem, names, 1)
    is_path = path.suffix == ".toml" or len(path.parts) > 1 or not isinstance(name, str)
    if is_path and os.path.isdir(path):
        raise ValueError(f"{path}: is a folder; give a scene's file")
    said = f"{path}: there is no such file" if is_path else f"scene {str(name)!r} is unknown"
    raise ValueError(f"{said}; known are {', '.join(names)}" + "".join(f"; did you mean {n}?" for n in near))


def read(path: str | PathLike[str]) -> Scene:
    """The scene that a TOML file describes.

    Parameters
    ----------
    path : str or path-like

    Raises
    ------
    ValueError
        If it cannot be read; lists every mistake, each with its path in the file, its value and what is allowed.
    ImportError
        If pydantic is missing.
    """
    return _scene(Path(path), str(path), check=True)


def _scene(source: Any, file: str, check: bool) -> Scene:
    """The scene of a file; those that ship are checked by the tests, so that they need NumPy alone."""
    try:
        document = tomllib.loads(source.read_bytes().decode("utf-8-sig"))
    except OSError as error:
        raise ValueError(f"{file}: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise ValueError(f"{file}: is not UTF-8 text: {error.reason} at byte {error.start}") from error
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise ValueError(f"{file}: is not TOML: {error}") from error
    friction: Any = document.get("friction")
    wanted = friction.get("law", "constant") if isinstance(friction, dict) else "constant"
    law = "".join(get_close_matches(str(wanted), LAWS, 1))  # itself, where it is known
    by_rate: Any = friction.get("rate") if isinstance(friction, dict) else None
    asked = by_rate.get("law", "") if isinstance(by_rate, dict) else ""
    rate = "".join(get_close_matches(str(asked), RATE_LAWS, 1)) or RATE_LAWS[0]
    sloping = "ground" in document
    tables, stability, whole = tables_of(law or "constant", rate), None, document
    document, uncertain, found, wrong = _drawn(whole, tables)
    if check:
        # Of a law that is anybody's guess nothing else can be judged.
        judged = document if law else document | {"friction": {"law": wanted, "coefficient": 0.0}}
        if sloping:
            judged = {k: v for k, v in judged.items() if k not in GEOMETRY} | {"arc": _NO_ARC}
        more, also = _mistakes(judged, tables, model_of(law or "constant", rates=(rate,)))
        found, wrong = found + more, wrong | also
    if sloping and "arc" in document:
        found.append("arc: and ground exclude each other; leave one out")
    if not sloping and "arc" not in wrong:
        given = _arguments(document["arc"].get("given", {}), tables["arc.given"])
        try:
            arc: Arc | Section = Arc(**_arguments(document["arc"], tables["arc"]), given=given or None)
        except ValueError as error:
            found.append(str(error).replace("Arc: ", "arc."))
    if "friction" not in wrong:
        friction = {"law": law} | _arguments(document["friction"], tables["friction"])
        if by_rate is not None:
            friction["rate"] = {"law": rate} | _arguments(by_rate, tables["friction.rate"])
        found += law_mistakes(friction)
    if sloping and not found:
        try:
            arc, stability = slopefile.section_of(whole)
        except ValueError as error:
            found += str(error).splitlines()
    if found:
        raise ValueError("\n".join(f"{file}: {m}" for m in found))
    effects = {name: _arguments(document[name], tables[name]) for name in EFFECTS if name in document}
    for given in effects.values():  # records lie where the scene's file lies
        given |= {k: str(Path(file).parent / v) for k, v in given.items() if k.endswith("record")}
    known = {"name": Path(file).stem} | _arguments(document, tables[""])
    try:
        mu = friction["coefficient"] if law == "constant" and by_rate is None else friction
        return Scene(arc, mu, effects, **known, uncertain=uncertain, stability=stability)
    except ValueError as error:
        said = str(error).removeprefix(f"Scene {known['name']}: ")
        raise ValueError(f"{file}: {_by_key(said.replace('arc.level', 'water.level_m'), tables)}") from error


def _by_key(said: str, tables: Mapping[str, Table]) -> str:
    """What an effect says of an argument, said of the key that stands for it in a file."""

    def named(found: re.Match[str]) -> str:
        effect, name, other = found.groups()
        key = next((k for k, key in tables[effect].keys.items() if key.name == name), None)
        return f"{effect}: {key or name}{other}" if other or not key else f"{effect}.{key}:"

    return re.sub(r"effects\.(\w+): (\w+)((?: and \w+)?)", named, said)


def _drawn(
    document: dict[str, Any], tables: Mapping[str, Table]
) -> tuple[dict[str, Any], dict[str, Any], list[str], set[str]]:
    """The document with a number for each distribution in it, its median; these, their mistakes, tables with any."""
    out = {k: dict(v) if isinstance(v, dict) else v for k, v in document.items()}
    uncertain: dict[str, Any] = {}
    found: list[str] = []
    wrong: set[str] = set()
    for number in numbers(tables).values():
        path, _, k = number.key.rpartition(".")
        held = out.get(path) if path else out
        given = held.get(k) if isinstance(held, dict) else None
        if not isinstance(held, dict) or not isinstance(given, dict):
            continue
        shown, low, high = number.key, number.low, number.high
        said = distribution_mistakes(given, (low, high))
        if not said:
            uncertain[shown] = given
            held[k] = float(made(given).median())
            continue
        found += [f"{shown}: {m}" for m in said]
        wrong.add(path or k)
        # Any number that is allowed, so that nothing more is said about it.
        held[k] = low + 1.0 if high == math.inf else (max(low, -high) + high) / 2
        held[k] = held[k] if math.isfinite(held[k]) else 0.0
    return out, uncertain, found, wrong


def _arguments(given: Mapping[str, Any], table: Table) -> dict[str, Any]:
    """A table as arguments in SI units, without the tables in it."""
    return {table.keys[k].name: table.keys[k].convert(v) for k, v in given.items() if k in table.keys}


def _mistakes(document: Mapping[str, Any], tables: Mapping[str, Table], model: Any) -> tuple[list[str], set[str]]:
    """A sentence for each mistake, with its path, its value and what is allowed; and the tables that have one."""
    from pydantic import ValidationError

    try:
        errors = model.model_validate(document) and []
    except ValidationError as error:
        errors = error.errors()
    found, meant = [], set()
    many = {str(e["loc"][:2]) for e in errors if any(isinstance(x, int) for x in e["loc"])}
    for e in sorted(errors, key=lambda e: e["type"] == "missing"):  # what is misspelt is not missing as well
        *parents, last = (x for x in e["loc"] if isinstance(x, str))
        kinds = ".".join(parents) not in tables  # a number or a list: each of them has been tried, and is named
        if kinds:
            *parents, last = parents
        table, path = ".".join(parents), ".".join((*parents, last))
        index = [x for x in e["loc"] if isinstance(x, int)]
        if kinds and not index and (str(e["loc"][:2]) in many or e["type"] == "list_type"):
            continue
        shown = path + "".join(f"[{x}]" for x in index) + f" = {_shown(e['input'])}"
        if e["type"] == "extra_forbidden":
            near, advice = _advice(table, last, tables)
            meant.add(near)
            found.append(f"{shown}: is unknown; {advice}")
            continue
        key = Key("", tables[path].title, f"a table [{path}]") if path in tables else tables[table].keys[last]
        if e["type"] != "missing":
            guess = get_close_matches(str(e["input"]), LAWS, 1) if path == "friction.law" else []
            asked = "".join(f"; did you mean {g}?" for g in guess)
            found.append(f"{shown}: must be {key.allowed}: {key.title}{asked}")
        elif path not in meant:
            found.append(f"{path}: is missing: {key.title}, {key.allowed}")
    wrong = {str(e["loc"][0]) for e in errors}
    for path, t in tables.items():
        held: Any = document.get(path)
        for choice in filter(None, (*t.one_of, t.any_of)) if isinstance(held, dict) else ():
            given = [k for k in choice if k in held]
            if choice in t.one_of and len(given) > 1:
                found.append(f"{path}: {' and '.join(given)} exclude each other; leave one out")
            elif not given and not meant & {f"{path}.{k}" for k in choice}:
                found.append(f"{path}: {' or '.join(choice)} is missing: {t.keys[choice[-1]].title}")
            wrong |= set() if given else {path}
    return found, wrong


def _advice(table: str, unknown: str, tables: Mapping[str, Table]) -> tuple[str, str]:
    """The path of the key that an unknown one in a table may stand for, and what to say about it."""
    within = {t: list(tables[t].keys) for t in tables}
    for path in filter(None, tables):
        parent, _, key = path.rpartition(".")
        within[parent].append(key)
    for t in (table, *tables):
        for key in get_close_matches(unknown, within[t], 1):
            place = "" if t == table else f" in [{t}]" if t else " above the first table"
            return f"{t}.{key}".lstrip("."), f"did you mean {key}{place}?"
    return "", f"known are {', '.join(within[table])}" if within[table] else "this table has no keys"


def _shown(value: Any) -> str:
    """A value as the file has it."""
    text = str(value).lower() if isinstance(value, bool | float) else json.dumps(value, default=str, ensure_ascii=False)
    return text if len(text) <= 60 else f"{text[:57]}..."
