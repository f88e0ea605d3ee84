"""Selection of the tables that a scene file may have: arc or slope, one soil or layers, and the chosen laws.

Tables in lists, [[layers]], [[surcharge]] and [[pond]], are read as tables named by their number, as in
``layers.2.top_m``.
"""

from difflib import get_close_matches
from typing import Any, NamedTuple

from slipcircle.base.kinds import TextDict, Texts, ValueDict, Values
from slipcircle.workbench.common.units import published
from slipcircle.workbench.files.keys import WITH_ARC, KeyTable, fitted
from slipcircle.workbench.files.slopekeys import NOT_WITH_LAYERS, WITH_LAYERS, WITH_ONE_SOIL

_BY_SOILS = "is given by the soils beside [[layers]]"
_IN_SOILS = {
    "friction": "[soils.NAME.friction]",
    "cohesion": "cohesion_kPa in [soils.NAME], or [soils.NAME.cohesion]",
    "pore_pressure": "pore_pressure_ratio in [soils.NAME], or by [water]",
}
_POND = (
    "[pond] is not a table any more: level_m of [water] describes free water too; where its pore pressure is given "
    "otherwise, write [[pond]] with from_m, to_m and level_m"
)


class Layout(NamedTuple):
    """Tables that a file may have, and its content arranged for them.

    In ``content``, tables in lists are named by their numbers. Tables excluded by other tables are left out of it, and
    reported in ``mistakes``.
    """

    tables: dict[str, KeyTable]
    content: ValueDict
    mistakes: Texts
    on_slope: bool
    layered: bool


def layout_of(content: Values) -> Layout:
    """Return the tables that a file may have, and its content arranged for them. `content` is the parsed TOML."""
    layered = any(get_close_matches(name, ("soils", "layers"), 1, 0.8) for name in content)
    on_slope = layered or "ground" in content
    whole = WITH_LAYERS if layered else WITH_ONE_SOIL if on_slope else WITH_ARC
    excluded = _excluded(on_slope, layered)
    if isinstance(content.get("pond"), dict):
        excluded["pond"] = _POND
    if "cohesion" in content and not layered:  # alone it means phi = 0
        whole = whole._replace(tables={**whole.tables, "friction": whole.tables["friction"]._replace(required=False)})
    mistakes = [f"{name}: {why}" for name, why in excluded.items() if name in content]
    content_read = {}
    for name, value in content.items():
        if name not in excluded:
            listed = name in whole.tables and whole.tables[name].repeats == "numbered"
            content_read[name] = _numbered(value) if listed else value
    ground = content_read.get("ground")
    whole_ground = ground if layered and isinstance(ground, dict) else {}
    for k in whole_ground:
        if published(k)[0] == "unit_weight_kN_m3":
            content_read["ground"] = {name: value for name, value in whole_ground.items() if name != k}
            mistakes.append(f"ground.{k}: {_BY_SOILS}: {k} in [soils.NAME]; leave it out")
    return Layout(fitted(whole, content_read), content_read, mistakes, on_slope, layered)


def _excluded(on_slope: bool, layered: bool) -> TextDict:
    """Return the names of the tables that other tables exclude, each with the reason as the end of a message.

    The file has a ground if `on_slope`, and soils or layers if `layered`.
    """
    of_arc = {"arc": "and ground exclude each other; remove one"} if on_slope else {}
    of_soils = {name: f"{_BY_SOILS}: {_IN_SOILS[name]}; leave it out" for name in NOT_WITH_LAYERS}
    return of_arc | (of_soils if layered else {})


def _numbered(value: Any) -> Any:
    """Return the tables of a list by their numbers from 1; other values are left as they are and reported later."""
    if isinstance(value, list) and all(isinstance(one, dict) for one in value):
        return {str(k): one for k, one in enumerate(value, 1)}
    return [value] if isinstance(value, dict) else value
