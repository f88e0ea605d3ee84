"""Tables that a scene file may have, depending on its content: an arc or a slope, one soil or layers, which laws.

Tables in lists, [[layers]] and [[surcharge]], are read as tables with numbers for names: ``layers.2.top_m``.
"""

from collections.abc import Collection, Mapping
from dataclasses import replace
from difflib import get_close_matches
from typing import Any, NamedTuple

from generated.effects import LAWS
from slipcircle.core import RATE_LAWS
from slipcircle.workbench.files.keys import Table, tables_of
from slipcircle.workbench.files.slopekeys import LOADS, NOT_WITH_LAYERS, SLOPING, SOIL_LAWS, layered_tables

_MOST_COHESION = 1e5  # kPa, of the soil of a homogeneous slope: more was in Pa
_LISTS = ("layers", "surcharge")
_BY_SOILS = "is given by the soils beside [[layers]]"
_IN_SOILS = {
    "friction": "[soils.NAME.friction]",
    "cohesion": "cohesion_kPa in [soils.NAME]",
    "pore_pressure": "pore_pressure_ratio in [soils.NAME], or by [water] or [pond]",
}


class Layout(NamedTuple):
    """How a file is read.

    ``content`` has tables in lists by their numbers, and nothing of what excludes something else, which is among the
    ``mistakes``. ``law`` and ``rate`` are those of [friction] or of [slip]; "" where the file names none that is known.
    """

    tables: dict[str, Table]
    content: dict[str, Any]
    mistakes: list[str]
    on_slope: bool
    layered: bool
    law: str
    rate: str


def layout_of(content: Mapping[str, Any]) -> Layout:
    """The tables that a file may have, and its content arranged accordingly."""
    layered = any(get_close_matches(name, ("soils", "layers"), 1, 0.8) for name in content)
    on_slope = layered or "ground" in content
    excluded = _excluded(on_slope, layered)
    mistakes = [f"{name}: {why}" for name, why in excluded.items() if name in content]
    known = {}
    for name, value in content.items():
        if name not in excluded:
            known[name] = _numbered(value) if name in _LISTS else value
    if layered and "unit_weight_kN_m3" in _table(known, "ground"):
        known["ground"] = {k: value for k, value in known["ground"].items() if k != "unit_weight_kN_m3"}
        mistakes.append(f"ground.unit_weight_kN_m3: {_BY_SOILS}: unit_weight_kN_m3 in [soils.NAME]; leave it out")
    slip = known.get("slip", {}) if layered else known.get("friction")
    law, rate = laws_of(slip)
    if not law:
        known["friction"] = _unknown_law(known["friction"])
    tables = tables_of(law or "constant", rate or RATE_LAWS[0])
    if on_slope:
        tables = _on_slope(tables, known)
    if layered:
        laws = _soil_laws(known)
        known |= _without_unknown_laws(known, laws)
        tables = _with_layers(tables, laws, len(_tables_in(known, "layers")), rate)
    return Layout(tables, known, mistakes, on_slope, layered, law, rate)


def _soil_laws(content: Mapping[str, Any]) -> dict[str, str]:
    """The friction law of each soil by its name; "" for an unknown law."""
    return {name: laws_of(soil.get("friction"), SOIL_LAWS)[0] for name, soil in _tables_in(content, "soils").items()}


def _without_unknown_laws(content: Mapping[str, Any], laws: Mapping[str, str]) -> dict[str, Any]:
    """The soils of a file, those of unknown laws without parameters, which cannot be checked."""
    soils = _tables_in(content, "soils")
    for name in (name for name, law in laws.items() if not law):
        soils[name] = soils[name] | {"friction": _unknown_law(soils[name]["friction"])}
    return {"soils": content["soils"] | soils} if soils else {}


def laws_of(friction: Any, known: Collection[str] = tuple(LAWS)) -> tuple[str, str]:
    """The laws of slip and of speed in a table of friction; "" for an unknown law."""
    if not isinstance(friction, dict):
        return "constant", ""
    law = "".join(get_close_matches(str(friction.get("law", "constant")), known, 1))  # itself, where it is known
    if "rate" not in friction:
        return law, ""
    rate = friction["rate"].get("law", "") if isinstance(friction["rate"], dict) else ""
    return law, "".join(get_close_matches(str(rate), RATE_LAWS, 1)) or RATE_LAWS[0]


def _excluded(on_slope: bool, layered: bool) -> dict[str, str]:
    """Tables excluded by others, and the reason."""
    of_arc = {"arc": "and ground exclude each other; remove one"} if on_slope else {}
    of_soils = {name: f"{_BY_SOILS}: {_IN_SOILS[name]}; leave it out" for name in NOT_WITH_LAYERS}
    return of_arc | (of_soils if layered else {})


def _numbered(value: Any) -> Any:
    """Tables of a list by their numbers from 1; other values are kept and reported later."""
    if isinstance(value, list) and all(isinstance(one, dict) for one in value):
        return {str(k): one for k, one in enumerate(value, 1)}
    return [value] if isinstance(value, dict) else value


def _tables_in(content: Mapping[str, Any], name: str) -> dict[str, dict[str, Any]]:
    """The tables inside a table of a file."""
    return {k: one for k, one in _table(content, name).items() if isinstance(one, dict)}


def _table(content: Mapping[str, Any], name: str) -> dict[str, Any]:
    """A table of a file, empty where there is none."""
    table = content.get(name)
    return table if isinstance(table, dict) else {}


def _unknown_law(friction: Mapping[str, Any]) -> dict[str, Any]:
    """Friction of an unknown law, without its parameters, which cannot be checked."""
    return {"law": friction["law"], "coefficient": 0.0}


def _on_slope(tables: Mapping[str, Table], content: Mapping[str, Any]) -> dict[str, Table]:
    """Tables with those of a slope and its loads instead of those of an arc."""
    of_slope = {path: table for path, table in tables.items() if not path.startswith("arc")}
    of_slope |= SLOPING
    cohesion = of_slope["cohesion"].keys["cohesion_kPa"]
    bounded = replace(cohesion.number, high=_MOST_COHESION)
    plausible = cohesion._replace(number=bounded)
    of_slope["cohesion"] = of_slope["cohesion"]._replace(keys={"cohesion_kPa": plausible})
    of_slope |= LOADS
    surcharge = LOADS["surcharge"]
    of_slope["surcharge"] = surcharge._replace(keys={})
    for number in _tables_in(content, "surcharge"):
        of_slope[f"surcharge.{number}"] = surcharge._replace(repeats="")
    return of_slope


def _with_layers(tables: Mapping[str, Table], laws: Mapping[str, str], count: int, rate: str) -> dict[str, Table]:
    """Tables with those of soils and layers instead of those of one soil."""
    layered = {}
    for path, table in tables.items():
        first, _, _ = path.partition(".")
        if first not in NOT_WITH_LAYERS:
            layered[path] = table
    ground = layered["ground"]
    keys = {k: key for k, key in ground.keys.items() if key.name != "unit_weight"}
    layered["ground"] = ground._replace(keys=keys)
    known_laws = {name: law or "constant" for name, law in laws.items()}
    known_rate = rate or RATE_LAWS[0]
    return layered | layered_tables(known_laws, count, known_rate)
