"""Slopes read from TOML files: ground, soil, water, a circle or how to look for it; every mistake listed at once."""

import math
import os
import re
import tomllib
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path
from typing import Any

import numpy as np

from slipcircle.base.distributions import distribution_mistakes, made
from slipcircle.files.slopekeys import AT_START, GEOMETRY, INF, OF_MOTION, OF_SOIL, TABLES, TINY, WHOLE, Key
from slipcircle.scene.ground import circle_through, circle_touching, simple_slope
from slipcircle.scene.search import Critical, at_circle, critical
from slipcircle.scene.section import Section
from slipcircle.scene.stability import Slope


@dataclass(frozen=True)
class SlopeFile:
    """What a slope's file says.

    Attributes
    ----------
    name, note : str
    slope : Slope
    section : Section or None
        Of the circle that the file gives.
    method : str
        By which the critical circle is looked for where it gives none.
    limits : dict
        ``entry``, ``exit`` and ``depth`` of the search.
    """

    name: str
    note: str
    slope: Slope
    section: Section | None
    method: str
    limits: dict[str, Any]


def read(path: str | os.PathLike[str]) -> SlopeFile:
    """The slope that a TOML file describes.

    Raises
    ------
    ValueError
        If it cannot be read; lists every mistake, one a line, with its key, its value, what is allowed and the fix.
    """
    file = str(path)
    document = document_of(Path(path), file)
    if "arc" in document:
        raise ValueError(f"{file}: arc: says nothing of the ground beside it; a search needs [ground] in its place")
    given, found = _read(document)
    if not found:
        try:
            return _made({"name": Path(path).stem} | given.pop(""), given)
        except ValueError as error:
            found = [_by_key(str(error))]
    raise ValueError("\n".join(f"{file}: {m}" for m in found))


def document_of(source: Any, file: str) -> dict[str, Any]:
    """What stands in a TOML file, or one sentence why it cannot be read."""
    try:
        return tomllib.loads(source.read_bytes().decode("utf-8-sig"))
    except OSError as error:
        raise ValueError(f"{file}: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise ValueError(f"{file}: is not UTF-8 text: {error.reason} at byte {error.start}") from error
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise ValueError(f"{file}: is not TOML: {error}") from error


def _read(document: Mapping[str, Any]) -> tuple[dict[str, dict[str, Any]], list[str]]:
    """The values in SI units by table and key, of a scene at its start; and a sentence for each mistake."""
    document = {k: _at_start(v) if k in OF_SOIL else v for k, v in document.items()}
    if isinstance(soil := document.get("friction"), dict) and "rate" in soil:
        document["friction.rate"] = soil.pop("rate")
    found: list[str] = []
    given: dict[str, dict[str, Any]] = {table: {} for table in TABLES}
    meant: set[str] = set()
    for name, value in document.items():
        if name in TABLES[""]:
            given[""][name] = _value(name, TABLES[""][name], value, found)
        elif name in OF_MOTION:
            continue
        elif name not in TABLES:
            meant.add(_unknown("", name, value, found))
        elif not isinstance(value, dict):
            meant |= {name, f"{name}."}  # no key of it is missing
            found.append(f"{name} = {value!r}: must be a table, [{name}]")
        else:
            for key, entry in value.items():
                if key in TABLES[name]:
                    given[name][key] = _value(f"{name}.{key}", TABLES[name][key], entry, found)
                else:
                    meant.add(_unknown(name, key, entry, found))
    for table, sets in WHOLE.items():
        asked = {k for s in sets for k in s}
        have = asked & set(given[table])
        if have in [set(s) for s in sets] or any(m.startswith(f"{table}.") for m in meant) or (
            table not in document and (table in meant or table not in ("ground", "friction"))
        ):  # fmt: skip
            continue
        wanted = ", or ".join(" with ".join(s) for s in sets)
        said = f"{' and '.join(sorted(have))} do not go together" if len(have) > 1 else "something is missing"
        found.append(f"{table}: {said}; give {wanted}")
    if "unit_weight_kN_m3" not in given["ground"] and not {"ground", "ground.unit_weight_kN_m3"} & meant:
        found.append(f"ground.unit_weight_kN_m3: is missing: {TABLES['ground']['unit_weight_kN_m3'].words}")
    return given, found


def _value(path: str, key: Key, value: Any, found: list[str]) -> Any:
    """One value in SI units; what is wrong with it goes to the list."""
    shown = f"{path} = {value!r}"
    if isinstance(value, dict) and path.partition(".")[0] in OF_SOIL:
        if said := distribution_mistakes(value, (key.low, key.high)):
            found += [f"{path}: {m}" for m in said]
            return math.nan
        value = float(made(value).mean())
    if key.kind == "number":
        if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
            found.append(f"{shown}: must be a number: {key.words}")
        elif not key.low <= value <= key.high:
            least = "above 0" if key.low == TINY else f"at least {key.low:g}" if key.low > -INF else ""
            bounds = " and ".join(filter(None, [least, f"at most {key.high:g}" if key.high < INF else ""]))
            asked = f"; {key.beyond}" if key.beyond and value > key.high else ""
            found.append(f"{shown}: must be {bounds}: {key.words}{asked}")
        else:
            return value * key.factor
        return math.nan
    if key.kind in ("points", "pair"):
        try:
            points = np.array(value, dtype=np.float64)
        except (ValueError, TypeError):
            points = np.array(np.nan)
        wanted = (2,) if key.kind == "pair" else (len(points), 2) if points.ndim else (2, 2)
        if points.shape != wanted or not np.isfinite(points).all():
            form = "two numbers, [a, b]" if key.kind == "pair" else "a list of points, [[x, y], [x, y], ...]"
            odd = [k for k, p in enumerate(points) if not np.isfinite(p).all()] if points.shape == wanted else []
            place = f"[{odd[0]}] = {value[odd[0]]!r}" if odd and key.kind == "points" else f" = {value!r}"
            found.append(f"{path}{place}: must be {form}: {key.words}")
        return points
    if not isinstance(value, str) or (key.kind != "text" and value not in key.kind.split("|")):
        near = get_close_matches(str(value), key.kind.split("|"), 1)
        asked = "".join(f"; did you mean {n}?" for n in near)
        found.append(
            f"{shown}: must be {'text' if key.kind == 'text' else 'one of ' + key.kind.replace('|', ', ')}{asked}"
        )
    return value


def _unknown(table: str, name: str, value: Any, found: list[str]) -> str:
    """Say that a key is unknown; returns what it may have meant."""
    shown = f"{table}.{name}".lstrip(".") + ("" if isinstance(value, dict | list) else f" = {value!r}")
    known = [*TABLES[table], *(filter(None, TABLES) if not table else ())]
    for t in (table, *TABLES):
        for near in get_close_matches(name, [*TABLES[t], *(filter(None, TABLES) if not t else ())], 1):
            place = "" if t == table else f" in [{t}]" if t else " as a table"
            found.append(f"{shown}: is unknown; did you mean {near}{place}?")
            return f"{t}.{near}".lstrip(".")
    found.append(f"{shown}: is unknown; known are {', '.join(known)}")
    return ""


def section_of(document: Mapping[str, Any]) -> tuple[Section, Critical | None]:
    """The section of a scene's file with a ground, of the circle that it gives or the critical one; and its stability.

    Uncertain numbers count by their means, what changes with slip or time by its start. A circle that is given needs
    no soil; without a strength, or with a pore pressure that is no ratio, nothing is said of its stability.

    Raises
    ------
    ValueError
        Lists every mistake by its key, one a line.
    """
    given, found = _read({k: v for k, v in document.items() if k in (*GEOMETRY, *OF_SOIL)})
    if "circle" not in document:
        found.append("circle: is missing; give " + ", or ".join(" with ".join(s) for s in WHOLE["circle"]))
    if "critical" not in given["circle"]:
        poor = [m for m in found if m.startswith(OF_SOIL)]
        found = [m for m in found if m not in poor]
    if found:
        raise ValueError("\n".join(found))
    try:
        if "critical" not in given["circle"]:
            section = _section(given)
            return section, None if poor else _stability(given, section)
        least = judged(_made({"name": ""}, given))
        circle = {"centre_m": least.centre, "radius_m": least.radius, "between_m": least.between}
        return _section(given | {"circle": circle}), least.without_map()
    except ValueError as error:
        raise ValueError(_by_key(str(error))) from error


def _stability(given: dict[str, dict[str, Any]], section: Section) -> Critical | None:
    """Of a circle that is given, in a soil that has any strength."""
    try:
        return at_circle(_slope(given), section)
    except ValueError:
        return None


def judged(file: SlopeFile, method: str | None = None, told: Callable[[str], None] = lambda _: None) -> Critical:
    """The critical circle of a slope's file; where it gives a circle, the factors of that one."""
    if file.section is not None:
        return at_circle(file.slope, file.section)
    try:
        return critical(file.slope, method or file.method, **file.limits, told=told)
    except ValueError as error:
        raise ValueError(re.sub(r"\b(entry|exit|depth) = ", r"search.\1_m = ", str(error))) from error


def _at_start(table: Any) -> Any:
    """A table of a scene's soil as it is at the start: of a law its peak, of a list its first value."""
    if not isinstance(table, dict):
        return table
    now = {AT_START.get(k, k): v[0] if isinstance(v, list) and v else v for k, v in table.items() if k != "time_s"}
    if "rate" in now:
        now["rate"] = _at_start(now["rate"])
    return {k: v for k, v in now.items() if k in ("rate", *TABLES["friction"])} if "law" in now else now


def _made(texts: dict[str, str], given: dict[str, dict[str, Any]]) -> SlopeFile:
    """The slope, and its section where a circle is given."""
    circle = given["circle"]
    section = _section(given) if circle and "critical" not in circle else None
    method = circle.get("critical", "bishop")
    return SlopeFile(texts["name"], texts.get("note", ""), _slope(given), section, method, _limits(given))


def _shared(given: dict[str, dict[str, Any]]) -> dict[str, Any]:
    """What slope and section are both made of."""
    ground, water = given["ground"], given["water"]
    points = ground.get("points_m")
    if points is None:
        points = simple_slope(ground["height_m"], angle=ground.get("angle_deg"), run=ground.get("run_m"))
    return {"ground": points, "unit_weight": ground["unit_weight_kN_m3"], "level": water.get("level_m"),
            "water_unit_weight": water.get("unit_weight_kN_m3", 9810.0), "base": ground.get("base_m")}  # fmt: skip


def _slope(given: dict[str, dict[str, Any]]) -> Slope:
    laws = [given["friction"], given["friction.rate"] or {"coefficient": 1.0}]
    return Slope(
        cohesion=given["cohesion"].get("cohesion_kPa", 0.0),
        friction=math.prod(t["coefficient"] if "coefficient" in t else math.tan(t["angle_deg"]) for t in laws),
        pore_ratio=given["pore_pressure"].get("ratio", 0.0), k_h=given["search"].get("k_h", 0.0), **_shared(given),
    )  # fmt: skip


def _limits(given: dict[str, dict[str, Any]]) -> dict[str, Any]:
    """Of the search."""
    pairs = {k.removesuffix("_m"): v for k, v in given["search"].items() if k != "k_h"}
    return {k: v if k == "depth" else (float(v[0]), float(v[1])) for k, v in pairs.items()}


def _section(given: dict[str, dict[str, Any]]) -> Section:
    """Of the circle that is given."""
    ground, circle, between = given["ground"], given["circle"], given["circle"].get("between_m")
    if "centre_m" in circle:
        centre, radius = circle["centre_m"], circle["radius_m"]
    elif "touching_m" in circle:
        centre, radius = circle_touching(circle["through_m"][0], circle["through_m"][1], circle["touching_m"])
    else:
        centre, radius = circle_through(
            *circle["through_m"], radius=circle.get("radius_m"), depth=circle.get("depth_m")
        )
    return Section(
        centre=centre, radius=radius, gravity=ground.get("gravity_m_s2", 9.81), width=ground.get("width_m", 1.0),
        between=None if between is None else (float(between[0]), float(between[1])), **_shared(given),
    )  # fmt: skip


def _by_key(said: str) -> str:
    """What a slope or a section says of its arguments, said of the keys that stand for them in a file."""
    keys = {"between": "circle.between_m", "centre": "circle.centre_m", "radius": "circle.radius_m",
            "depth": "circle.depth_m", "base": "ground.base_m", "ground": "ground.points_m", "level": "water.level_m",
            "pore_ratio": "pore_pressure.ratio"}  # fmt: skip
    if said.startswith("critical: "):
        return said
    _, _, rest = said.partition(": ")
    for name, key in keys.items():
        if rest.startswith(name) and not rest[len(name) :][:1].isalpha():
            rest = key + rest[len(name) :]
            break
    return rest.replace("choose one by between =", "choose one by circle.between_m =")
