"""Scenes read from TOML files, every mistake listed at once, and the scenes that ship."""

import json
import math
import os
import re
import tomllib
from collections.abc import Callable, Mapping
from dataclasses import replace
from difflib import get_close_matches
from importlib import resources
from os import PathLike
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from generated.effects import EFFECTS, LAWS
from slipcircle.core import RATE_LAWS, Arc, Scene, Section, circle_through, circle_touching, law_mistakes, simple_slope
from slipcircle.workbench.common.distributions import distribution_mistakes, distribution_of
from slipcircle.workbench.files.keys import SLOPING, Key, Table, law_table, tables_of
from slipcircle.workbench.files.loaded import SlopeScene
from slipcircle.workbench.files.numbers import numbers, uncertain_numbers
from slipcircle.workbench.records.forcing import with_records
from slipcircle.workbench.stability.search import Critical, at_circle, critical
from slipcircle.workbench.stability.stability import Slope, require_drive, soil

_MOST_COHESION = 1e5  # kPa, of any soil: more was in Pa
_FOLDER = resources.files("slipcircle") / "scenes"


def shipped() -> tuple[str, ...]:
    """Names of the scenes that ship."""
    return tuple(sorted(f.name.removesuffix(".toml") for f in _FOLDER.iterdir() if f.name.endswith(".toml")))


def load(name: str | PathLike[str]) -> Scene[float]:
    """A scene that ships, by name, or one's own, by the path of its TOML file.

    Raises
    ------
    ValueError
        If it cannot be read; lists every mistake, each with its path in the file, its value and what is allowed.
    """
    source = find(name)
    file = str(source)
    parts, tables = _parts(_document(source, file), file)
    if parts["stability"]:
        parts["stability"] = parts["stability"].without_map()
    try:
        _check_gravity(parts)
        parts["effects"] = with_records(parts["effects"], float(np.asarray(parts["arc"].gravity)))
        stability = parts.pop("stability")
        scene: Scene[float] = SlopeScene(**parts, stability=stability) if stability else Scene(**parts)
        return replace(scene, uncertain=uncertain_numbers(scene)) if scene.uncertain else scene
    except ValueError as error:
        said = str(error).removeprefix(f"Scene {parts['name']}: ")
        raise ValueError(f"{file}: {_by_key(said.replace('arc.level', 'water.level_m'), tables)}") from error


def _check_gravity(parts: Mapping[str, Any]) -> None:
    """A record is read over gravity, which cannot be uncertain then."""
    recorded = "record" in parts["effects"].get("shaking", {})
    for key in ("arc.gravity_m_s2", "ground.gravity_m_s2"):
        if recorded and key in parts["uncertain"]:
            raise ValueError(f"{key}: must be one number with a record, which is read over gravity")


def find(name: str | PathLike[str]) -> Any:
    """The file of a scene that ships, by name; or one's own, by its path."""
    if not isinstance(name, str | PathLike):
        raise ValueError(f"scene {name!r}: must be the name of one that ships, or the path of its file")
    if name in (names := shipped()):
        return _FOLDER / f"{name}.toml"
    path = Path(name)
    for candidate in (path, Path(f"{name}.toml")):
        if os.path.exists(candidate) and not os.path.isdir(candidate):  # no error for names that no file can have
            return candidate
    if str(name) and os.path.isdir(path):
        raise ValueError(f"{path}: is a folder; give a scene's file")
    near = get_close_matches(path.stem, names, 1)
    is_path = path.suffix == ".toml" or len(path.parts) > 1 or not isinstance(name, str)
    said = f"{path}: there is no such file" if is_path else f"scene {str(name)!r} is unknown"
    raise ValueError(f"{said}; known are {', '.join(names)}" + "".join(f"; did you mean {n}?" for n in near))


def critical_of_file(
    name: str | PathLike[str], method: str | None, tell: Callable[[str], None]
) -> tuple[str, str, Critical]:
    """Name, note and critical circle of the slope in a file, by default as it says, or by Bishop's method.

    Where it gives a circle, the factors of this one. ``tell`` takes lines of progress.
    """
    source = find(name)
    file = str(source)
    document = _document(source, file)
    if "ground" not in document:
        raise ValueError(f"{file}: arc: says nothing of the ground beside it; a search needs [ground] in its place")
    circle = document.setdefault("circle", {"critical": "bishop"})
    if method and isinstance(circle, dict) and "critical" in circle:
        circle["critical"] = method
    stem = Path(file).stem
    parts, _ = _parts(document, file, lambda line: tell(f"{document.get('name', stem)}: {line}"))
    if parts["stability"] is None:
        raise ValueError(
            f"{file}: circle: has no factors of safety: the soil has no strength, or a pore pressure from a record"
        )
    if parts["uncertain"]:
        tell(f"{parts['name']}: at the median of {', '.join(parts['uncertain'])}")
    return parts["name"], parts.get("note", ""), parts["stability"]


def _document(source: Any, file: str) -> dict[str, Any]:
    """What stands in a TOML file, or one sentence why it cannot be read."""
    try:
        return tomllib.loads(source.read_bytes().decode("utf-8-sig"))
    except OSError as error:
        raise ValueError(f"{file}: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise ValueError(f"{file}: is not UTF-8 text: {error.reason} at byte {error.start}") from error
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise ValueError(f"{file}: is not TOML: {error}") from error


def _parts(
    document: dict[str, Any], file: str, tell: Callable[[str], None] = lambda _: None
) -> tuple[dict[str, Any], dict[str, Table]]:
    """What a scene is made of, and the tables of its file; every mistake listed."""
    friction: Any = document.get("friction")
    wanted = friction.get("law", "constant") if isinstance(friction, dict) else "constant"
    law = "".join(get_close_matches(str(wanted), LAWS, 1))  # itself, where it is known
    by_rate: Any = friction.get("rate") if isinstance(friction, dict) else None
    asked = by_rate.get("law", "") if isinstance(by_rate, dict) else ""
    rate = "".join(get_close_matches(str(asked), RATE_LAWS, 1)) or RATE_LAWS[0]
    tables, on_slope = tables_of(law or "constant", rate), "ground" in document
    found = ["arc: and ground exclude each other; leave one out"] if on_slope and "arc" in document else []
    if on_slope:
        tables = {path: table for path, table in tables.items() if not path.startswith("arc")} | dict(SLOPING)
        cohesion = tables["cohesion"].keys["cohesion_kPa"]
        plausible = {"cohesion_kPa": cohesion._replace(number=replace(cohesion.number, high=_MOST_COHESION))}
        tables["cohesion"] = tables["cohesion"]._replace(keys=plausible)
        document = {k: v for k, v in document.items() if k != "arc"}
    if not law:  # of one that is anybody's guess nothing else can be judged
        document = document | {"friction": {"law": wanted, "coefficient": 0.0}}
    said = _said(document, tables)
    found, given = found + said.mistakes, said.arguments
    if not on_slope and "arc" not in said.wrong:
        try:
            arc: Arc | Section = Arc(**given["arc"], given=given.get("arc.given"))
        except ValueError as error:
            found.append(str(error).replace("Arc: ", "arc."))
    if "friction" not in said.wrong:
        friction = {"law": law} | given["friction"]
        if by_rate is not None:
            friction["rate"] = {"law": rate} | given["friction.rate"]
        found += law_mistakes(friction)
    stability = None
    if not found:
        effects = {name: given[name] for name in EFFECTS if name in given}
        for own in effects.values():  # records lie where the scene's file lies
            own |= {k: str(Path(file).parent / v) for k, v in own.items() if k.endswith("record")}
        if on_slope:
            try:
                arc, stability = _section(given, soil(friction, effects), tell)
            except ValueError as error:
                found = [_by_sloping_key(str(error))]
    if found:
        raise ValueError("\n".join(f"{file}: {m}" for m in found))
    parts = {"arc": arc, "friction": friction, "effects": effects, "uncertain": said.uncertain, "stability": stability}
    if law == "constant" and by_rate is None:
        parts["friction"] = friction["coefficient"]
    return parts | {"name": Path(file).stem} | given[""], tables


def _section(
    given: Mapping[str, dict[str, Any]], strength: Mapping[str, float], tell: Callable[[str], None]
) -> tuple[Section, Critical | None]:
    """The section of the circle that is given, or of the critical one; and its stability, where the soil has any."""
    ground, circle, water, limits = (dict(given.get(table, {})) for table in SLOPING)
    if simple := {n: ground.pop(n) for n in ("height", "angle", "run") if n in ground}:
        ground["ground"] = simple_slope(**simple)
    ground |= {n if n == "level" else "water_unit_weight": v for n, v in water.items()}
    of_slope = {n: v for n, v in ground.items() if n not in ("gravity", "width")}
    of_slope |= {"k_h": limits.pop("k_h", 0.0), **strength}
    if "critical" in circle:
        if not strength:
            raise ValueError(
                "critical: circle.critical: needs friction or cohesion, and a pore pressure that is no record"
            )
        found = critical(Slope(**of_slope), circle["critical"], **limits, tell=tell)
        return Section(**ground, centre=found.centre, radius=found.radius, between=found.between), found
    if (points := circle.pop("through", None)) is not None:
        if len(points) != 2:
            raise ValueError("circle_through: through: must be two points, [[x, y], [x, y]]")
        between, touching = circle.pop("between", None), circle.get("touching")
        laid = (
            circle_through(*points, **circle) if touching is None else circle_touching(points[0], points[1], touching)
        )
        circle = {"centre": laid[0], "radius": laid[1], "between": between}
    body = Section(**ground, **circle)
    if "shaking" not in given and not given[""].get("initial_velocity"):
        require_drive(body)
    # The circle is known to be above the base, which may lie higher than ground beside it.
    return body, at_circle(Slope(**of_slope | {"base": None}), body) if strength else None


def _by_sloping_key(said: str) -> str:
    """What a slope or a section says of its arguments, said of the keys that stand for them in a file."""
    of, _, rest = said.partition(": ")
    tables = ("search",) if of == "critical" else ("ground", "circle", "water")
    keys = {key.name: f"{t}.{k}" for t in tables for k, key in SLOPING[t].keys.items()}
    keys |= {"pore_ratio": "pore_pressure.ratio", "pressure": "pore_pressure.pressure_kPa"}
    keys["friction"] = "friction.coefficient"
    rest = re.sub(rf"(^|; |choose one by )({'|'.join(keys)})(?= =|:|\[)", lambda m: m[1] + keys[m[2]], rest)
    return f"critical: {rest}" if of == "critical" else rest


def _by_key(said: str, tables: Mapping[str, Table]) -> str:
    """What an effect says of an argument, said of the key that stands for it in a file."""

    def named(found: re.Match[str]) -> str:
        effect, name, other = found.groups()
        key = next((k for k, key in tables[effect].keys.items() if key.name == name), None)
        return f"{effect}: {key or name}{other}" if other or not key else f"{effect}.{key}:"

    return re.sub(r"effects\.(\w+): (\w+)((?: and \w+)?)", named, said)


class _Said(NamedTuple):
    """What a document says: arguments by table, uncertain numbers, mistakes, and the tables that have one."""

    arguments: dict[str, dict[str, Any]]
    uncertain: dict[str, Any]
    mistakes: list[str]
    wrong: set[str]


def _said(document: Mapping[str, Any], tables: Mapping[str, Table]) -> _Said:
    """Its tables in SI units, of each distribution the median; a sentence for each mistake, with path and value."""
    out = _Said({}, {}, [], set())
    odd: dict[str, list[str]] = {}  # distributions
    missing: dict[str, str] = {}
    meant: set[str] = set()  # what is misspelt is not missing as well

    def say(path: str, *sentences: str) -> None:
        out.mistakes.extend(sentences)
        out.wrong.add(path.partition(".")[0])

    def value_of(full: str, key: Key, value: Any, held: Mapping[str, Any], table: Table) -> Any:
        if isinstance(value, dict) and key.kind in ("number", "series"):
            if found := distribution_mistakes(value, (key.number.low, key.number.high)):
                odd[full] = [f"{full}: {m}" for m in found]
                return say(full)
            out.uncertain[full] = value
            value = float(distribution_of(value).median())
        found = [
            f"{full}{place} = {_shown(given)}: must be {key.allowed}{_asked(key, given, table)}"
            for place, given in key.wrong(value)
        ]
        if key.kind == "series" and isinstance(value, list) and "time_s" not in held:
            found.append(
                f"{full} = {_shown(value)}: is a list, which needs its times beside it, time_s; or give one number"
            )
        return say(full, *found) if found else key.convert(value)

    def look(path: str, held: Mapping[str, Any]) -> None:
        table, dot, own = tables[path], f"{path}." if path else "", out.arguments.setdefault(path, {})
        inner = {t.removeprefix(dot): t for t in tables if t and t.rpartition(".")[0] == path}
        for k, value in held.items():
            full, shown = f"{dot}{k}", f"{dot}{k} = {_shown(value)}"
            if k in inner and isinstance(value, dict):
                look(full, value)
            elif k in inner:
                say(full, f"{shown}: must be a table [{full}]: {tables[full].title}")
            elif k not in table.keys:
                near, advice = _advice(path, k, tables)
                meant.add(near)
                say(full, f"{shown}: is unknown; {advice}")
            else:
                own[table.keys[k].name] = value_of(full, table.keys[k], value, held, table)
        missing.update(
            {
                f"{dot}{k}": f"{key.title}, {key.allowed}"
                for k, key in table.keys.items()
                if key.required and k not in held
            }
        )
        missing.update(
            {t: f"{tables[t].title}, a table [{t}]" for k, t in inner.items() if tables[t].required and k not in held}
        )
        have = {k for keys in table.sets for k in keys if k in held}
        if table.sets and have not in map(set, table.sets) and not any(m.startswith(dot) for m in meant):
            at_fault = f"{' and '.join(sorted(have))} do not go together" if have else "something is missing"
            say(path, f"{path}: {at_fault}; give {', or '.join(' with '.join(keys) for keys in table.sets)}")
        for choice in filter(None, (*table.one_of, table.any_of)):
            given = [k for k in choice if k in held]
            if choice in table.one_of and len(given) > 1:
                say(path, f"{path}: {' and '.join(given)} exclude each other; leave one out")
            elif not given:
                misspelt = meant & {f"{path}.{k}" for k in choice}
                words = f"{path}: {' or '.join(choice)} is missing: {table.keys[choice[-1]].title}"
                say(path, *([] if misspelt else [words]))

    look("", document)
    for path, words in missing.items():
        say(path, *([] if path in meant else [f"{path}: is missing: {words}"]))
    known = numbers(tables)  # their order is that of samples
    drawn = {k: out.uncertain[k] for k in known if k in out.uncertain}
    return out._replace(uncertain=drawn, mistakes=[m for k in known for m in odd.get(k, [])] + out.mistakes)


def _asked(key: Key, given: Any, table: Table) -> str:
    """What else to say of a wrong value: the key's title, a word that may be meant, bounds that nobody expects."""
    if "|" in key.kind or key.name == "law":
        guess = get_close_matches(str(given), LAWS if key.name == "law" else key.kind.split("|"), 1)
        return f": {key.title}" + "".join(f"; did you mean {g}?" for g in guess)
    of, number = key.number, isinstance(given, int | float) and not isinstance(given, bool) and abs(given) < math.inf
    low, high = of.limits.get("gt", 0.0), of.high
    angle = next((k for k, other in table.keys.items() if other.number.tangent and other.name == key.name), "")
    if number and given > high and of.per_unit == 1e3:
        return f": {key.title}; is that in {of.si}? 1 {of.unit} is 1000 {of.si}".replace("^", "")
    if number and given >= high and angle and not of.tangent:
        return f": {key.title}; an angle? say {angle}"
    far = number and (0.0 < given <= low or abs(given) >= high) and f"{high:g}" not in key.allowed
    return f": {key.title}" + (f"; between {low:g} and {high:g}: is that another unit?" if far else "")


def _advice(table: str, unknown: str, tables: Mapping[str, Table]) -> tuple[str, str]:
    """The path of the key that an unknown one in a table may stand for, and what to say about it.

    In the same table what is like it, or alone has its unit; elsewhere only what is as good as the same.
    """
    within = {t: list(tables[t].keys) for t in tables}
    for path in filter(None, tables):
        parent, _, key = path.rpartition(".")
        within[parent].append(key)
    own = within[table]
    if laws := [law for law in LAWS if unknown in law_table(law).keys] if table == "friction" else []:
        law = tables[table].keys["law"].kind
        return f"{table}.{own[-1]}", f"it belongs to law = {' or '.join(laws)}, and the law is {law}; give law"
    unit = next((u for u in ("_deg", "_kPa", "_m_s2", "_m_s", "_s", "_m") if unknown.endswith(u)), "_")
    alike = [k for k in own if k.endswith(unit)]
    for key in get_close_matches(unknown, own, 1) or (alike if len(alike) == 1 else []):
        return f"{table}.{key}".lstrip("."), f"did you mean {key}?"
    for t in tables:
        for key in get_close_matches(unknown, within[t], 1, 0.9):
            place = f" in [{t}]" if t else " above the first table"
            return f"{t}.{key}".lstrip("."), f"did you mean {key}{place}?"
    return "", f"known are {', '.join(own)}" if own else "this table has no keys"


def _shown(value: Any) -> str:
    """A value as the file has it."""
    text = str(value).lower() if isinstance(value, bool | float) else json.dumps(value, default=str, ensure_ascii=False)
    return text if len(text) <= 60 else f"{text[:57]}..."
