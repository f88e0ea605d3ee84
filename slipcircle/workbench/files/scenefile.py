"""Construction of scenes from TOML files, with all mistakes reported at once."""

import json
import os
import re
import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import replace
from os import PathLike
from pathlib import Path
from typing import Any, NamedTuple

from generated.effects import EFFECTS
from slipcircle.base.arrays import float_or_array
from slipcircle.base.inputerror import InputError, Message
from slipcircle.base.kinds import Rename, Tell, TextMap, Texts, ValueDict, Values
from slipcircle.core import Arc, Scene
from slipcircle.ground import Section
from slipcircle.layers import law_mistakes
from slipcircle.workbench.common.units import SYSTEMS
from slipcircle.workbench.files.document import Document
from slipcircle.workbench.files.keys import KeyTable
from slipcircle.workbench.files.layout import layout_of
from slipcircle.workbench.files.numbers import uncertain_numbers
from slipcircle.workbench.files.points import with_points
from slipcircle.workbench.files.profile import Arguments, idle_loads, profile, surcharges
from slipcircle.workbench.files.shipped import find
from slipcircle.workbench.files.slope import SlopeInput, motion_mistakes
from slipcircle.workbench.files.slopekeys import LOADS, SLOPING
from slipcircle.workbench.records.forcing import with_records
from slipcircle.workbench.stability.critical import Critical, SlopeScene
from slipcircle.workbench.stability.stability import soil

_MOST_BYTES = 10**7
_DEEPEST = 64


def load(name: str | PathLike[str]) -> Scene[float]:
    """Load a scene that ships, by its name, or a scene from a TOML file, by its path.

    Raises
    ------
    ValueError
        If it cannot be read; lists every mistake with its path in the file, its value and the allowed values.
    """
    source = find(name)
    file = str(source)
    parts, keys = _parts(_content(source), file)
    stability = parts.pop("stability")
    remarks = parts.pop("remarks")
    try:
        gravity = float_or_array(parts["arc"].gravity)
        parts["effects"], of_records = with_records(parts["effects"], gravity, parts["uncertain"])
        remarks = (*remarks, *of_records)
        scene: Any
        if of_records and "start" not in parts:
            parts["set_by_start"] = None  # an arc starts as it is
        if "start" in parts or of_records:
            scene = SlopeScene(**parts, stability=stability and stability.without_map(), remarks=remarks)
        else:
            scene = Scene(**parts)
        return replace(scene, uncertain=uncertain_numbers(scene)) if scene.uncertain else scene
    except InputError as error:
        raise ValueError(error.worded(keys, file)) from error


def critical_of_file(name: str | PathLike[str], method: str | None, tell: Tell) -> tuple[str, str, Critical, Texts]:
    """Return the name, note, critical circle and warnings of the slope in a file.

    A file without [circle] is searched with Bishop's method. If a circle is given, its factors of safety are returned.

    Parameters
    ----------
    name : str or path
        Scene that ships, or path of a scene file.
    method : str, optional
        Method of the search in place of the file's.
    tell : callable
        Called with lines of progress.
    """
    source = find(name)
    file = str(source)
    content = _content(source)
    if "arc" in content and "ground" not in content:
        raise ValueError(f"{file}: arc: does not describe the ground; replace [arc] by [ground] for a search")
    circle = content.setdefault("circle", {"critical": "bishop"})
    if method and isinstance(circle, dict) and "critical" in circle:
        circle["critical"] = method
    stem = Path(file).stem
    parts, _ = _parts(content, file, lambda line: tell(f"{content.get('name', stem)}: {line}"), moving=False)
    if parts["stability"] is None:
        raise ValueError(
            f"{file}: circle: has no factors of safety: the soil has no strength, or a pore pressure from a record"
        )
    warnings = [*parts["remarks"], *filter(None, [parts["stability"].warning])]
    if parts["uncertain"]:
        warnings.append(f"at the median of {', '.join(parts['uncertain'])}")
    return parts["name"], parts.get("note", ""), parts["stability"], warnings


_MOVING = ("rotation", "centripetal", "shaking", "drag", "viscosity", "heating", "end_time_s", "initial_velocity_m_s")
_ELSEWHERE = r"(?:^[ \t]*(?:#[^\n]*)?\n)*^[ \t]*\[[^,\n]*\][ \t]*(?:#[^\n]*)?$"
_CIRCLE = re.compile(rf"^[ \t]*\[[ \t]*circle[ \t]*\].*?(?={_ELSEWHERE}|\Z)", re.MULTILINE | re.DOTALL)


def with_circle(name: str | PathLike[str], searched: Critical, path: str) -> str:
    """Return the text of a scene file with its circle replaced by a circle found by `critical_of_file`.

    Tables for rotation and centripetal stress are added to a slope without a motion.

    Raises
    ------
    ValueError
        If the circle is not a table of its own, if a table is not allowed in a motion, or if the file refers to files
        in its folder and ``path``, where the scene will be written, is in another folder.
    """
    source = find(name)
    file = str(source)
    content = _content(source)
    circle = {"centre_m": [*searched.centre], "radius_m": searched.radius, "between_m": [*searched.between]}
    added = () if any(key in content for key in _MOVING) else _MOVING[:2]
    tables = {"circle": circle | {"start": searched.start}} | {name: {} for name in added}
    text = _with_tables(source.read_text("utf-8-sig"), tables)
    try:
        is_replaced = tomllib.loads(text) == content | tables
    except tomllib.TOMLDecodeError:
        is_replaced = False
    if not is_replaced:
        raise ValueError(f"{file}: circle: cannot be replaced in the text; make it a table of its own, [circle]")
    _parts(content | tables, file)
    here = Path(file).parent
    near = [text for text in re.findall(r"""["']([^"'#\n]+)""", text) if os.path.isfile(here / text)]
    if near and here.resolve() != Path(path).parent.resolve():
        raise ValueError(f"{path}: is in another folder than {file}, which refers to {near[0]}; write it beside it")
    return text


def _with_tables(text: str, tables: Mapping[str, Values]) -> str:
    """Return the text of a file with its [circle] replaced by the first of the tables, and the others appended.

    `tables` maps the name of each table to its values. Without a [circle] all tables are appended.
    """
    texts = []
    for name, values in tables.items():
        texts.append("".join([f"[{name}]\n", *(f"{key} = {json.dumps(value)}\n" for key, value in values.items())]))
    replaced, count = _CIRCLE.subn(lambda _: texts[0], text, 1)
    return "\n".join([replaced, *texts[count:]])


def units_of_files(names: Iterable[str]) -> set[str]:
    """Return the systems of units of output that scene files choose, in capitals."""
    tables = (_content(source).get("output") for source in map(find, names))
    return {str(table.get("units", "")).upper() for table in tables if isinstance(table, dict)} & {*SYSTEMS}


_ADVICE = (
    "; `slipcircle new slope.toml` writes a scene: put the name of a profile (.csv, .dxf) into points_file of "
    "[ground], the name of an earthquake record into record of [shaking]"
)


def _content(source: Any) -> ValueDict:
    """Return the content of a TOML file; raise an error with one sentence if it cannot be read.

    `source` is a path or a packaged resource.
    """
    file = str(source)
    advice = "" if file.endswith(".toml") else _ADVICE
    try:
        with source.open("rb") as opened:
            text = opened.read(_MOST_BYTES + 1)
        if len(text) > _MOST_BYTES:
            most = f"must be at most {_MOST_BYTES / 1e6:g} MB; records belong in files of their own"
            raise ValueError(f"{file}: is too large: {most}")
        content = tomllib.loads(text.decode("utf-8-sig"))
        # Reject tables and lists nested more deeply than in any scene, on which recursive functions would fail.
        inside: list[Any] = [content]
        for _ in range(_DEEPEST):
            inside = [
                v for i in inside for v in (i.values() if isinstance(i, dict) else i if isinstance(i, list) else ())
            ]
        if inside:
            raise ValueError(
                f"{file}: is nested too deeply: must be at most {_DEEPEST} tables and lists in one another"
            )
        return content
    except OSError as error:
        raise ValueError(f"{file}: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise ValueError(f"{file}: is not UTF-8 text: {error.reason} at byte {error.start}{advice}") from error
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise ValueError(f"{file}: is not TOML: {error}{advice}") from error


class _Input(NamedTuple):
    """Content of a file: arc or slope, friction, keys of arguments, and mistakes."""

    document: Document
    keys: Rename
    arc: Arc | None
    slope: SlopeInput | None
    friction: ValueDict | None
    mistakes: Texts


def _read(content: Values, moving: bool) -> _Input:
    """Return the content of a file with its mistakes; unless ``moving``, tables for statics alone are allowed."""
    layout = layout_of(content)
    document = Document(layout.content, layout.tables)
    values = document.arguments
    keys = _keys(layout.tables, document.typed)
    arc = None
    slope = None
    wrong: Texts = []
    if layout.on_slope:
        # The slope of a file, without the strength of a single soil, and the mistakes across tables.
        mistakes = motion_mistakes(values, layout.layered) if moving else []
        layers = None
        if layout.layered:
            layers = profile(values, keys, values.get("slip.rate"), not {"soils", "layers", "slip"} & {*document.wrong})
            mistakes += layers.mistakes
        loads, of_loads = surcharges(values)
        slope = SlopeInput(values, {}, layers, loads)
        wrong = mistakes + of_loads
    elif "arc" not in document.wrong:
        arc, wrong = _arc(values, keys)
    friction = None if layout.layered else _friction(values)
    of_law = [] if friction is None or "friction" in document.wrong else law_mistakes(friction)
    wrong += [Message.of(mistake).worded(keys) for mistake in of_law]
    return _Input(document, keys, arc, slope, friction, [*layout.mistakes, *document.mistakes, *wrong])


def _parts(content: ValueDict, file: str, tell: Tell = lambda _: None, moving: bool = True) -> tuple[ValueDict, Rename]:
    """Return the fields of a scene with its stability, and a function from arguments to keys; list all mistakes.

    `file` is the path of the scene file, and `tell` is called with lines of progress. Unless `moving`, tables that only
    factors of safety use are allowed, and the arc of a slope is None.
    """
    try:
        content = with_points(content, Path(file).parent)
    except InputError as error:
        raise ValueError(error.worded(str, file)) from error
    document, keys, arc, slope, friction, mistakes = _read(content, moving)
    if mistakes:
        raise ValueError("\n".join(f"{file}: {mistake}" for mistake in mistakes))
    effects = _effects(document.arguments, Path(file).parent)
    parts: ValueDict = {
        "arc": arc,
        "friction": friction,
        "effects": effects,
        "uncertain": document.uncertain,
        "observed": document.arguments.get("observed", {}),
        "stability": None,
        "remarks": (),
        "name": Path(file).stem,
    }
    if friction is not None and friction["law"] == "constant" and "rate" not in friction:
        parts["friction"] = friction["coefficient"]
    if slope is not None:
        strength = {} if friction is None else soil(friction, effects)
        parts["arc"], parts["stability"] = _along_slope(replace(slope, strength=strength), keys, tell, file, moving)
        parts["start"] = slope.start
        remarks = slope.profile.remarks if slope.profile else []
        parts["remarks"] = (*remarks, *(idle_loads(slope.surcharge, parts["stability"]) if parts["stability"] else ()))
    document.arguments[""].pop("format", None)  # valid here, as it is not among the mistakes
    return parts | document.arguments[""], keys


def _along_slope(
    slope: SlopeInput, keys: Rename, tell: Tell, file: str, moving: bool
) -> tuple[Section | None, Critical | None]:
    """Return the section of a slope and its stability; an error names the keys of the file.

    The section is None unless `moving`, and the stability is None without strength. `tell` is called with lines of
    progress.
    """
    try:
        circle, stability = slope.stability(tell)
        return slope.section(circle) if moving else None, stability
    except InputError as error:
        # The message of an error in a slope, a section or a search, with the keys of its file.
        tables = {**SLOPING, **LOADS}
        about = ("search",) if error.what == "critical" else ("ground", "circle", "water", "tension_crack")
        of_slope = {key.name: f"{t}.{k}" for t in about for k, key in tables[t].keys.items()}
        of_slope |= {"pore_ratio": "pore_pressure.ratio", "pressure": "pore_pressure.pressure_kPa"}
        of_slope |= {"friction": "friction.coefficient", "cohesion": "cohesion.cohesion_kPa"}
        of_slope["ponds"] = "[[pond]]"
        what = f"{file}: critical" if error.what == "critical" else file
        raise ValueError(error.worded(lambda name: of_slope.get(name, keys(name)), what)) from error


def _arc(arguments: Arguments, keys: Rename) -> tuple[Arc | None, Texts]:
    """Return the arc of a file and no mistakes, or None and its mistakes.

    `arguments` are the arguments by path of the table, and `keys` maps names of arguments to keys of the file.
    """
    try:
        return Arc(**arguments["arc"], given=arguments.get("arc.given")), []
    except InputError as error:
        return None, [message.within("arc").worded(keys) for message in error.messages]


def _friction(arguments: Arguments) -> ValueDict:
    """Return the law of slip of a file, with the law of speed that multiplies it.

    `arguments` are the arguments by path of the table.
    """
    rate = {"rate": arguments["friction.rate"]} if "friction.rate" in arguments else {}
    return {"law": "constant"} | arguments.get("friction", {"coefficient": 0.0}) | rate


def _keys(tables: Mapping[str, KeyTable], typed: TextMap) -> Rename:
    """Return a function from names of arguments (`effects.shaking.step`) to keys in the file (`shaking.step_s`).

    `typed` has the keys that the file contains, by argument.
    """
    keys = {"arc.level": "water.level_m", "end_time": "end_time_s", "initial_velocity": "initial_velocity_m_s"}
    for path, table in tables.items():
        keys |= {f"{path}.{key.name}": f"{path}.{k}" for k, key in table.keys.items()}
    keys |= typed
    return lambda name: keys.get(name.removeprefix("effects."), name.removeprefix("effects."))


def _effects(arguments: Arguments, folder: Path) -> dict[str, ValueDict]:
    """Return the effects among the tables, by name; paths of records are relative to the scene file.

    `arguments` are the arguments by path of the table, and `folder` is the folder of the scene file.
    """
    effects = {name: dict(arguments[name]) for name in EFFECTS if name in arguments}
    if effects.get("cohesion", {}).get("law") == "constant":
        del effects["cohesion"]["law"]
    for parameters in effects.values():
        parameters |= {name: str(folder / file) for name, file in parameters.items() if name.endswith("record")}
    return effects
