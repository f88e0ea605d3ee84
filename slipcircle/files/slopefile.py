"""Slopes read from TOML files: ground, soil, water, a circle or how to look for it; every mistake listed at once."""

import math
import os
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from slipcircle.scene.ground import circle_through, circle_touching, simple_slope
from slipcircle.scene.section import Section
from slipcircle.scene.stability import METHODS, Slope

_INF = math.inf


class Key(NamedTuple):
    """A key of a slope's file: what it is, its kind, its closed bounds in the file's unit, and the factor to SI units.

    ``beyond`` says what was probably meant by a number above the bounds.
    """

    words: str
    kind: str = "number"
    low: float = -_INF
    high: float = _INF
    factor: float = 1.0
    beyond: str = ""


_TINY = 5e-324


def _weight(words: str) -> Key:
    return Key(words, "number", _TINY, 100.0, 1e3, "is that in N/m3? 1 kN/m3 is 1000 N/m3")


TABLES: Mapping[str, Mapping[str, Key]] = {
    "": {"name": Key("name of the slope, by default the file's", "text"), "note": Key("source of the numbers", "text")},
    "ground": {
        "points_m": Key("points of the surface from left to right, m", "points"),
        "height_m": Key("height of a simple slope between level ground, m", low=_TINY),
        "angle_deg": Key("its angle, deg", low=_TINY, high=90.0, factor=math.pi / 180),
        "run_m": Key("its horizontal length, m", low=0.0),
        "unit_weight_kN_m3": _weight("unit weight of the soil, kN/m3"),
        "gravity_m_s2": Key("gravity, by default 9.81 m/s2", low=_TINY, high=100.0),
        "width_m": Key("length across the section, by default 1 m", low=_TINY),
        "base_m": Key("y of a firm layer below which no circle goes, m"),
    },
    "friction": {
        "angle_deg": Key("friction angle, deg", low=0.0, high=75.0, factor=math.pi / 180),
        "coefficient": Key("friction coefficient, tan(phi)", high=4.0, low=0.0, beyond="an angle? say angle_deg"),
    },
    "cohesion": {"cohesion_kPa": Key("strength without normal stress, kPa", low=0.0, high=1e5, factor=1e3,
                                     beyond="is that in Pa? 1 kPa is 1000 Pa")},
    "water": {
        "level_m": Key("points of the water level from left to right, m", "points"),
        "unit_weight_kN_m3": _weight("unit weight of water, by default 9.81 kN/m3"),
    },
    "pore_pressure": {"ratio": Key("r_u, pore pressure over the weight of the soil above", low=0.0, high=0.99)},
    "circle": {
        "centre_m": Key("centre of the circle, m", "pair"),
        "radius_m": Key("radius, m", low=_TINY),
        "through_m": Key("two points of the circle, m", "points"),
        "depth_m": Key("depth of the circle below the chord of these points, m", low=_TINY),
        "touching_m": Key("y of the level that the circle through these points touches, m"),
        "between_m": Key("x between which the stretch of ground lies that is meant, m", "pair"),
        "critical": Key("method by which the critical circle is looked for", "|".join(METHODS)),
    },
    "search": {
        "entry_m": Key("least and greatest x of the upper end, m", "pair"),
        "exit_m": Key("least and greatest x of the lower end, m", "pair"),
        "depth_m": Key("least thickness of the mass, m", low=0.0),
        "k_h": Key("horizontal acceleration over g, positive down-slope", low=-0.99, high=0.99,
                   beyond="is that in m/s2? k_h is a share of g"),
    },
}  # fmt: skip
# What makes a table whole: one of these sets of keys.
_WHOLE = {
    "ground": (("points_m",), ("height_m", "angle_deg"), ("height_m", "run_m")),
    "friction": (("angle_deg",), ("coefficient",)),
    "circle": (("centre_m", "radius_m"), ("through_m", "radius_m"), ("through_m", "depth_m"),
               ("through_m", "touching_m"), ("critical",)),
}  # fmt: skip


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
    try:
        document = tomllib.loads(Path(path).read_bytes().decode("utf-8-sig"))
    except OSError as error:
        raise ValueError(f"{file}: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise ValueError(f"{file}: is not UTF-8 text: {error.reason} at byte {error.start}") from error
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise ValueError(f"{file}: is not TOML: {error}") from error
    given, found = _read(document)
    if not found:
        try:
            return _made({"name": Path(path).stem} | given.pop(""), given)
        except ValueError as error:
            found = [_by_key(str(error))]
    raise ValueError("\n".join(f"{file}: {m}" for m in found))


def _read(document: Mapping[str, Any]) -> tuple[dict[str, dict[str, Any]], list[str]]:
    """The values in SI units by table and key, and a sentence for each mistake."""
    found: list[str] = []
    given: dict[str, dict[str, Any]] = {table: {} for table in TABLES}
    meant: set[str] = set()
    for name, value in document.items():
        if name in TABLES[""]:
            given[""][name] = _value(name, TABLES[""][name], value, found)
        elif not isinstance(value, dict) or name not in TABLES:
            meant.add(_unknown("", name, value, found))
        else:
            for key, entry in value.items():
                if key in TABLES[name]:
                    given[name][key] = _value(f"{name}.{key}", TABLES[name][key], entry, found)
                else:
                    meant.add(_unknown(name, key, entry, found))
    for table, sets in _WHOLE.items():
        asked = {k for s in sets for k in s}
        have = asked & set(given[table])
        if have in [set(s) for s in sets] or any(m.startswith(f"{table}.") for m in meant) or (
            table not in document and (table in meant or table == "circle")
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
    if key.kind == "number":
        if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
            found.append(f"{shown}: must be a number: {key.words}")
        elif not key.low <= value <= key.high:
            least = "above 0" if key.low == _TINY else f"at least {key.low:g}" if key.low > -_INF else ""
            bounds = " and ".join(filter(None, [least, f"at most {key.high:g}" if key.high < _INF else ""]))
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
            found.append(f"{path}: must be {form}: {key.words}")
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


def _made(texts: dict[str, str], given: dict[str, dict[str, Any]]) -> SlopeFile:
    """The slope, and its section where a circle is given."""
    ground, soil, water, circle = (given[t] for t in ("ground", "friction", "water", "circle"))
    points = ground.get("points_m")
    if points is None:
        points = simple_slope(ground["height_m"], angle=ground.get("angle_deg"), run=ground.get("run_m"))
    search = dict(given["search"])
    shared = {"level": water.get("level_m"), "water_unit_weight": water.get("unit_weight_kN_m3", 9810.0),
              "base": ground.get("base_m")}  # fmt: skip
    slope = Slope(
        points, given["cohesion"].get("cohesion_kPa", 0.0),
        soil["coefficient"] if "coefficient" in soil else math.tan(soil["angle_deg"]),
        ground["unit_weight_kN_m3"], pore_ratio=given["pore_pressure"].get("ratio", 0.0), k_h=search.pop("k_h", 0.0),
        **shared,
    )  # fmt: skip
    section = None
    if "critical" not in circle and circle:
        if "centre_m" in circle:
            centre, radius = circle["centre_m"], circle["radius_m"]
        elif "touching_m" in circle:
            centre, radius = circle_touching(circle["through_m"][0], circle["through_m"][1], circle["touching_m"])
        else:
            centre, radius = circle_through(
                *circle["through_m"], radius=circle.get("radius_m"), depth=circle.get("depth_m")
            )
        between = circle.get("between_m")
        section = Section(
            points, centre, radius, ground["unit_weight_kN_m3"], ground.get("gravity_m_s2", 9.81),
            ground.get("width_m", 1.0), None if between is None else (float(between[0]), float(between[1])), **shared,
        )  # fmt: skip
    limits = {k.removesuffix("_m"): v if k == "depth_m" else (float(v[0]), float(v[1])) for k, v in search.items()}
    return SlopeFile(texts["name"], texts.get("note", ""), slope, section, circle.get("critical", "bishop"), limits)


def _by_key(said: str) -> str:
    """What a slope or a section says of its arguments, said of the keys that stand for them in a file."""
    keys = {"between": "circle.between_m", "centre": "circle.centre_m", "radius": "circle.radius_m",
            "depth": "circle.depth_m", "base": "ground.base_m", "ground": "ground.points_m", "level": "water.level_m",
            "pore_ratio": "pore_pressure.ratio"}  # fmt: skip
    _, _, rest = said.partition(": ")
    for name, key in keys.items():
        if rest.startswith(name) and not rest[len(name) :][:1].isalpha():
            rest = key + rest[len(name) :]
            break
    return rest.replace("choose one by between =", "choose one by circle.between_m =")
