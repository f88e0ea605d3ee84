"""Scenes read from TOML files, every mistake listed at once, and the scenes that ship."""

import os
import tomllib
from collections.abc import Callable, Mapping
from dataclasses import replace
from difflib import get_close_matches
from importlib import resources
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from generated.effects import EFFECTS, LAWS
from slipcircle.base.checks import InputError, Message
from slipcircle.core import RATE_LAWS, Arc, Scene, Section, circle_through, circle_touching, law_mistakes, simple_slope
from slipcircle.workbench.files.document import Document
from slipcircle.workbench.files.keys import SLOPING, Table, tables_of
from slipcircle.workbench.files.loaded import SlopeScene
from slipcircle.workbench.files.numbers import uncertain_numbers
from slipcircle.workbench.records.forcing import with_records
from slipcircle.workbench.stability.search import Critical, at_circle, critical
from slipcircle.workbench.stability.stability import Slope, require_drive, soil

_MOST_COHESION = 1e5  # kPa, of any soil: more was in Pa
_FOLDER = resources.files("slipcircle") / "scenes"


def shipped() -> tuple[str, ...]:
    """Names of the scenes that ship."""
    return tuple(sorted(f.name.removesuffix(".toml") for f in _FOLDER.iterdir() if f.name.endswith(".toml")))


def load(name: str | PathLike[str]) -> Scene[float]:
    """Load a scene that ships, by name, or one from a TOML file, by its path.

    Raises
    ------
    ValueError
        If it cannot be read; lists every mistake, with its path in the file, its value and what is allowed.
    """
    source = find(name)
    file = str(source)
    parts, keys = _parts(_content(source, file), file)
    stability = parts.pop("stability")
    try:
        gravity = float(np.asarray(parts["arc"].gravity))
        parts["effects"] = with_records(parts["effects"], gravity, parts["uncertain"])
        if stability:
            scene: Scene[float] = SlopeScene(**parts, stability=stability.without_map())
        else:
            scene = Scene(**parts)
        return replace(scene, uncertain=uncertain_numbers(scene)) if scene.uncertain else scene
    except InputError as error:
        raise ValueError(f"{file}: {error.worded(keys)}") from error


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
    content = _content(source, file)
    if "ground" not in content:
        raise ValueError(f"{file}: arc: says nothing of the ground beside it; a search needs [ground] in its place")
    circle = content.setdefault("circle", {"critical": "bishop"})
    if method and isinstance(circle, dict) and "critical" in circle:
        circle["critical"] = method
    stem = Path(file).stem
    parts, _ = _parts(content, file, lambda line: tell(f"{content.get('name', stem)}: {line}"))
    if parts["stability"] is None:
        raise ValueError(
            f"{file}: circle: has no factors of safety: the soil has no strength, or a pore pressure from a record"
        )
    if parts["uncertain"]:
        tell(f"{parts['name']}: at the median of {', '.join(parts['uncertain'])}")
    return parts["name"], parts.get("note", ""), parts["stability"]


def _content(source: Any, file: str) -> dict[str, Any]:
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
    content: dict[str, Any], file: str, tell: Callable[[str], None] = lambda _: None
) -> tuple[dict[str, Any], Callable[[str], str]]:
    """The fields of a scene and its stability, and what its file calls an argument; every mistake listed."""
    law, rate = _laws(content.get("friction"))
    on_slope = "ground" in content
    tables = _tables(law or "constant", rate or RATE_LAWS[0], on_slope)
    document = _document(content, tables, law)
    given, keys = document.arguments, _keys(tables, document.typed)
    mistakes = document.mistakes
    arc: Arc | Section | None = None
    stability = None
    if not on_slope and "arc" not in document.wrong:
        arc, wrong = _arc(given, keys)
        mistakes += wrong
    friction = _friction(given, law, rate)
    if "friction" not in document.wrong:
        mistakes += [Message.of(mistake).worded(keys) for mistake in law_mistakes(friction)]
    effects = {} if mistakes else _effects(given, Path(file).parent)
    if on_slope and not mistakes:
        arc, stability = _along_slope(given, soil(friction, effects), tell, file)
    if mistakes:
        raise ValueError("\n".join(f"{file}: {mistake}" for mistake in mistakes))
    plain_friction = friction["coefficient"] if law == "constant" and not rate else friction
    parts = {"arc": arc, "friction": plain_friction, "effects": effects, "uncertain": document.uncertain}
    return {**parts, "stability": stability, "name": Path(file).stem, **given[""]}, keys


def _along_slope(
    given: Mapping[str, dict[str, Any]], strength: Mapping[str, float], tell: Callable[[str], None], file: str
) -> tuple[Section, Critical | None]:
    """The section of a slope and its stability; an error names the keys of the file."""
    try:
        return _section(given, strength, tell)
    except InputError as error:
        raise ValueError(f"{file}: {_slope_message(error)}") from error


def _document(content: Mapping[str, Any], tables: Mapping[str, Table], law: str) -> Document:
    """What a file says, but for an arc beside a ground, and for the parameters of a law that is anybody's guess."""
    known = {table: value for table, value in content.items() if table != "arc" or "ground" not in content}
    if not law:
        known["friction"] = {"law": content["friction"]["law"], "coefficient": 0.0}
    document = Document(known, tables)
    if len(known) < len(content):
        document.mistakes.insert(0, "arc: and ground exclude each other; remove one")
    return document


def _arc(given: Mapping[str, dict[str, Any]], keys: Callable[[str], str]) -> tuple[Arc | None, list[str]]:
    """The arc of a file, or what is wrong with it."""
    try:
        return Arc(**given["arc"], given=given.get("arc.given")), []
    except InputError as error:
        return None, ["; ".join(message.within("arc").worded(keys) for message in error.messages)]


def _friction(given: Mapping[str, dict[str, Any]], law: str, rate: str) -> dict[str, Any]:
    """The law of slip of a file, with that of speed which multiplies it."""
    friction: dict[str, Any] = {"law": law} | given.get("friction", {})
    if rate:
        friction["rate"] = {"law": rate} | given.get("friction.rate", {})
    return friction


def _laws(friction: Any) -> tuple[str, str]:
    """The law of slip that a table of friction asks for, and that of speed beside it; "" for none like any."""
    if not isinstance(friction, dict):
        return "constant", ""
    law = "".join(get_close_matches(str(friction.get("law", "constant")), LAWS, 1))  # itself, where it is known
    if "rate" not in friction:
        return law, ""
    rate = friction["rate"].get("law", "") if isinstance(friction["rate"], dict) else ""
    return law, "".join(get_close_matches(str(rate), RATE_LAWS, 1)) or RATE_LAWS[0]


def _tables(law: str, rate: str, on_slope: bool) -> dict[str, Table]:
    """The tables that a file may have: on a slope those of the ground in place of the arc's."""
    tables = tables_of(law, rate)
    if not on_slope:
        return tables
    tables = {path: table for path, table in tables.items() if not path.startswith("arc")} | dict(SLOPING)
    cohesion = tables["cohesion"].keys["cohesion_kPa"]
    plausible = cohesion._replace(number=replace(cohesion.number, high=_MOST_COHESION))
    tables["cohesion"] = tables["cohesion"]._replace(keys={"cohesion_kPa": plausible})
    return tables


def _keys(tables: Mapping[str, Table], typed: Mapping[str, str]) -> Callable[[str], str]:
    """What a file calls an argument: ``effects.shaking.step`` is ``shaking.step_s``; of two keys the one it has."""
    keys = {"arc.level": "water.level_m", "end_time": "end_time_s", "initial_velocity": "initial_velocity_m_s"}
    for path, table in tables.items():
        keys |= {f"{path}.{key.name}": f"{path}.{k}" for k, key in table.keys.items()}
    keys |= typed
    return lambda name: keys.get(name.removeprefix("effects."), name.removeprefix("effects."))


def _effects(given: Mapping[str, dict[str, Any]], folder: Path) -> dict[str, dict[str, Any]]:
    """The effects among the tables; records lie where the scene's file lies."""
    effects = {name: dict(given[name]) for name in EFFECTS if name in given}
    for parameters in effects.values():
        parameters |= {name: str(folder / file) for name, file in parameters.items() if name.endswith("record")}
    return effects


def _slope_message(error: InputError) -> str:
    """What is wrong with a slope, a section or a search, by the keys of its file."""
    tables = ("search",) if error.what == "critical" else ("ground", "circle", "water")
    keys = {key.name: f"{table}.{k}" for table in tables for k, key in SLOPING[table].keys.items()}
    keys |= {"pore_ratio": "pore_pressure.ratio", "pressure": "pore_pressure.pressure_kPa"}
    keys |= {"friction": "friction.coefficient", "cohesion": "cohesion.cohesion_kPa"}
    text = error.worded(lambda name: keys.get(name, name))
    return f"critical: {text}" if error.what == "critical" else text


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
            needs = "circle.critical: needs friction or cohesion, and a pore pressure that is no record"
            raise InputError("critical", [needs])
        found = critical(Slope(**of_slope), circle["critical"], **limits, tell=tell)
        return Section(**ground, centre=found.centre, radius=found.radius, between=found.between), found
    body = Section(**ground, **_circle(circle))
    if "shaking" not in given and not given[""].get("initial_velocity"):
        require_drive(body)
    # The circle is known to be above the base, which may lie higher than ground beside it.
    return body, at_circle(Slope(**of_slope | {"base": None}), body) if strength else None


def _circle(circle: dict[str, Any]) -> dict[str, Any]:
    """Centre, radius and stretch of a circle, however it is given."""
    if "through" not in circle:
        return circle
    points = circle.pop("through")
    if len(points) != 2:
        raise InputError("circle_through", ["{through}: must be two points, [[x, y], [x, y]]"])
    between = circle.pop("between", None)
    if "touching" in circle:
        centre, radius = circle_touching(points[0], points[1], circle["touching"])
    else:
        centre, radius = circle_through(*points, **circle)
    return {"centre": centre, "radius": radius, "between": between}
