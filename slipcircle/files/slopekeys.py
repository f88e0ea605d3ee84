"""The keys of a slope's file, and of a scene's that has a ground in place of an arc."""

import math
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from generated.effects import EFFECTS
from slipcircle.scene.stability import METHODS

INF = math.inf


class Key(NamedTuple):
    """A key of a slope's file: what it is, its kind, its closed bounds in the file's unit, and the factor to SI units.

    ``beyond`` says what was probably meant by a number above the bounds.
    """

    words: str
    kind: str = "number"
    low: float = -INF
    high: float = INF
    factor: float = 1.0
    beyond: str = ""


TINY = 5e-324


def _weight(words: str) -> Key:
    return Key(words, "number", TINY, 100.0, 1e3, "is that in N/m3? 1 kN/m3 is 1000 N/m3")


_FRICTION = {
    "angle_deg": Key("friction angle, deg", low=0.0, high=75.0, factor=math.pi / 180),
    "coefficient": Key("friction coefficient, tan(phi)", high=4.0, low=0.0, beyond="an angle? say angle_deg"),
}
TABLES: Mapping[str, Mapping[str, Key]] = {
    "": {"name": Key("name of the slope, by default the file's", "text"), "note": Key("source of the numbers", "text")},
    "ground": {
        "points_m": Key("points of the surface from left to right, m", "points"),
        "height_m": Key("height of a simple slope between level ground, m", low=TINY),
        "angle_deg": Key("its angle, deg", low=TINY, high=90.0, factor=math.pi / 180),
        "run_m": Key("its horizontal length, m", low=0.0),
        "unit_weight_kN_m3": _weight("unit weight of the soil, kN/m3"),
        "gravity_m_s2": Key("gravity, by default 9.81 m/s2", low=TINY, high=100.0),
        "width_m": Key("length across the section, by default 1 m", low=TINY),
        "base_m": Key("y of a firm layer below which no circle goes, m"),
    },
    "friction": _FRICTION,
    "friction.rate": _FRICTION,
    "cohesion": {"cohesion_kPa": Key("strength without normal stress, kPa", low=0.0, high=1e5, factor=1e3,
                                     beyond="is that in Pa? 1 kPa is 1000 Pa")},
    "water": {
        "level_m": Key("points of the water level from left to right, m", "points"),
        "unit_weight_kN_m3": _weight("unit weight of water, by default 9.81 kN/m3"),
    },
    "pore_pressure": {"ratio": Key("r_u, pore pressure over the weight of the soil above", low=0.0, high=0.99)},
    "circle": {
        "centre_m": Key("centre of the circle, m", "pair"),
        "radius_m": Key("radius, m", low=TINY),
        "through_m": Key("two points of the circle, m", "points"),
        "depth_m": Key("depth of the circle below the chord of these points, m", low=TINY),
        "touching_m": Key("y of the level that the circle through these points touches, m"),
        "between_m": Key("x between which the stretch of ground lies that is meant, m", "pair"),
        "critical": Key("method by which the critical circle is looked for", "|".join(METHODS)),
    },
    "search": {
        "entry_m": Key("least and greatest x of the upper end, m", "pair"),
        "exit_m": Key("least and greatest x of the lower end, m", "pair"),
        "depth_m": Key("least thickness of the mass, against skins, m", low=0.0),
        "k_h": Key("horizontal acceleration over g, positive down-slope", low=-0.99, high=0.99,
                   beyond="is that in m/s2? k_h is a share of g"),
    },
}  # fmt: skip
GEOMETRY = ("ground", "circle", "water", "search")  # what a scene's file may have in place of an arc
TITLES = ("a real slope, in place of [arc]", "its slip circle, given or looked for", "its water level, in place of r_u",
          "what limits the search for the critical circle")  # fmt: skip
OF_SOIL = ("friction", "cohesion", "pore_pressure")  # of a scene at its start
OF_MOTION = {*EFFECTS, "initial_velocity_m_s", "end_time_s", "accuracy"} - {*TABLES}  # not asked by a search
AT_START = {"peak_deg": "angle_deg", "peak": "coefficient"}
# What makes a table whole: one of these sets of keys.
WHOLE = {
    "ground": (("points_m",), ("height_m", "angle_deg"), ("height_m", "run_m")),
    "friction": (("angle_deg",), ("coefficient",)),
    "pore_pressure": (("ratio",),),
    "circle": (("centre_m", "radius_m"), ("through_m", "radius_m"), ("through_m", "depth_m"),
               ("through_m", "touching_m"), ("critical",)),
}  # fmt: skip


def schemas() -> dict[str, Any]:
    """JSON Schemas of the tables that stand in place of an arc."""
    point: dict[str, Any] = {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2}
    kinds: dict[str, dict[str, Any]] = {
        "number": {"type": "number"},
        "pair": point,
        "points": {"type": "array", "items": point, "minItems": 2},
    }
    found = {}
    for table in GEOMETRY:
        own = TABLES[table].items()
        keys = {k: kinds.get(key.kind, {"enum": key.kind.split("|")}) | _bounds(key) for k, key in own}
        choice = {"oneOf": [{"required": list(s)} for s in WHOLE[table]]} if table in WHOLE else {}
        needed = [k for k in keys if (table, k) == ("ground", "unit_weight_kN_m3")]
        more = {"additionalProperties": False, "required": needed} | choice
        found[table] = {"type": "object", "properties": keys, **more}
    return found


def _bounds(key: Key) -> dict[str, Any]:
    low = {"exclusiveMinimum": 0.0} if key.low == TINY else {"minimum": key.low} if key.low > -INF else {}
    return {"title": key.words} | low | ({"maximum": key.high} if key.high < INF else {})


def guide() -> Iterator[tuple[str, str, list[tuple[str, str]]]]:
    """Tables with what stands in place of an arc: what each is, and its keys with their words."""
    for table, title in zip(GEOMETRY, TITLES, strict=True):
        needed = "; needed: " + ", or ".join(" with ".join(s) for s in WHOLE[table]) if table in WHOLE else ""
        kinds = {k: f": {key.kind.replace('|', ', ')}" if "|" in key.kind else "" for k, key in TABLES[table].items()}
        yield table, title + needed, [(k, key.words + kinds[k]) for k, key in TABLES[table].items()]
