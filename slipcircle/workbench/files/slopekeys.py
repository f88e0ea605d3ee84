"""Declarations of the tables of a scene file with a slope: ground, circle, water, soils, layers and loads."""

import math
from collections.abc import Mapping
from dataclasses import replace

from generated.effects import INFINITY, LIMITS, Parameter
from slipcircle.core import declared
from slipcircle.layers import PRESSURE, TOP, Soil
from slipcircle.workbench.files.keys import (
    ARC,
    COHESION,
    EFFECT_TABLES,
    FRICTION,
    FURTHER,
    OF_SOIL,
    RATE_OF_SOILS,
    Key,
    KeyTable,
    table_of,
    worded,
)
from slipcircle.workbench.files.keys import TOP as TOP_LEVEL
from slipcircle.workbench.stability.factors import YIELD
from slipcircle.workbench.stability.stability import METHODS

NOT_WITH_LAYERS = ("friction", "cohesion", "pore_pressure")
_MOST_COHESION = 1e8  # Pa, of the soil of a homogeneous slope; larger values are in Pa by mistake


def _length(name: str, help: str, lower: float = 0.0) -> Parameter:
    """Return the declaration of an optional length in m, for the key NAME_m. `lower` is its open lower bound."""
    return Parameter(name, "m", lower, LIMITS["m"][1], help, f"{name}_m", optional=True, kind="fixed")


def _weight(help: str, optional: bool = False) -> Parameter:
    """Return the declaration of a unit weight in N/m^3, for the key unit_weight_kN_m3."""
    return Parameter("unit_weight", "N/m^3", 0.0, 1e5, help, "unit_weight_kN_m3", 1e3, optional=optional, kind="fixed")


def _points(name: str, title: str) -> dict[str, Key]:
    """Return the declaration of a list of points in m by its key, points_m for the ground and NAME_m otherwise."""
    key = "points_m" if name == "ground" else f"{name}_m"
    return _of_points(name, key, title, "a list of two points or more, [[x, y], [x, y], ...] (m)", "points")


def _pair(name: str, title: str, form: str = "[least, greatest]") -> dict[str, Key]:
    """Return the declaration of two numbers in m by its key NAME_m. `form` describes them for messages."""
    return _of_points(name, f"{name}_m", title, f"two numbers, {form} (m)", "pair")


def _of_points(name: str, key: str, help: str, allowed: str, kind: str) -> dict[str, Key]:
    """Return the declaration of an optional key with coordinates in m, by the key.

    `name` is the name of its argument.
    """
    return {key: Key(name, "m", help=help, key=key, optional=True, kind=kind, allowed=allowed, written="m")}


def _place(name: str, help: str) -> Parameter:
    """Return the declaration of a required coordinate in m, for the key NAME_m."""
    return replace(_length(name, help, -INFINITY), optional=False)


_UPRIGHT = Parameter(
    "angle",
    "rad",
    0.0,
    math.nextafter(math.pi / 2, 2.0),
    "its angle, 90 for a scarp",
    "angle_deg",
    math.pi / 180,
    optional=True,
    kind="fixed",
)
SLOPING: Mapping[str, KeyTable] = {  # in place of an arc
    "ground": table_of(
        "a real slope, in place of [arc]",
        [
            _length(
                "height",
                "height of a simple slope between level ground; it falls to the right to its toe at x = 0, y = 0",
            ),
            _UPRIGHT,
            _length("run", "its horizontal length", -5e-324),
            _weight("unit weight of the soil"),
            *(replace(p, kind="fixed") for p in ARC[-2:]),
            _length("base", "y of a firm layer below which no circle goes", -INFINITY),
        ],
        _points("ground", "points of the surface from left to right"),
    )._replace(required=True, sets=(("points_m",), ("height_m", "angle_deg"), ("height_m", "run_m"))),
    "circle": table_of(
        'its slip circle: given, or searched with critical = "bishop"',
        [
            _length("radius", "radius"),
            _length("depth", "depth of the circle below the chord of these points"),
            _length("touching", "y of the level that the circle through these points touches", -INFINITY),
        ],
        _pair("centre", "centre of the circle", "[x, y]")
        | _points("through", "two points of the circle")
        | _pair("between", "range of x that contains the intended mass, if the circle cuts off several")
        | {
            "critical": worded(
                "critical",
                "method of the search for the critical circle",
                f"one of {', '.join(METHODS)}, or {YIELD}: least yield coefficient",
                kind="|".join((*METHODS, YIELD)),
            ),
            "start": worded(
                "start",
                "method from whose factor of safety the motion starts, by default the method of critical, or bishop",
                f"one of {', '.join(METHODS)}",
                kind="|".join(METHODS),
            ),
        },
    )._replace(
        required=True,
        sets=(
            ("centre_m", "radius_m"),
            ("through_m", "radius_m"),
            ("through_m", "depth_m"),
            ("through_m", "touching_m"),
            ("critical",),
        ),
    ),
    "water": table_of(
        "its water level, in place of r_u: pore pressure below it, and free water where it is above the ground",
        [_weight("unit weight of water, of ponds and cracks too, by default 9.81", True)],
        _points("level", "points of the level from left to right, over the whole mass; horizontal above the ground")
        | {
            "confined": worded(
                "confined",
                "whether the water is confined: a level above the ground is then artesian pressure without free water",
                "true or false",
                kind="flag",
            )
        },
    ),
    "search": table_of(
        "limits of the search for the critical circle",
        [
            _length("depth", "least thickness of the mass, against skins", -5e-324),
            Parameter(
                "k_h",
                "",
                -1.0,
                1.0,
                "horizontal acceleration as a share of g, positive down-slope",
                "k_h",
                optional=True,
                kind="fixed",
            ),
        ],
        _pair("entry", "x of the upper end")
        | _pair("exit", "x of the lower end")
        | {
            "k_h_on_surcharge": worded(
                "k_h_on_surcharge", "whether k_h acts on surcharges, by default false", "true or false", kind="flag"
            )
        },
    ),
}

LOADS: Mapping[str, KeyTable] = {  # in addition to them
    "tension_crack": table_of(
        "a tension crack at the upper end of the slip surface",
        [
            replace(_length("depth", "its depth"), name="crack", optional=False, kind="number"),
            replace(_length("water", "height of the water in it, by default 0", -5e-324), name="crack_water"),
        ],
    ),
    "surcharge": table_of(
        "a pressure on the ground, linear from one x to the other",
        [_place("from", "x of its left end"), _place("to", "x of its right end"), replace(PRESSURE, kind="load")],
    )._replace(repeats="numbered"),
    "pond": table_of(
        "free water whose pore pressure is given otherwise, by r_u or by a lower or a confined level of [water]",
        [_place("from", "x of its left shore"), _place("to", "x of its right shore"), _place("level", "its level")],
    )._replace(repeats="numbered"),
}

# --- soils and layers ------------------------------------------------------------------------------------------------

_OF_SOIL = declared(Soil)
_SOIL = table_of(
    "the soils, each by its name",
    [
        *(_OF_SOIL[name] for name in ("unit_weight", "saturated_unit_weight", "cohesion", "cohesion_gradient")),
        _length("datum", "y below which the cohesion grows, by default the top of the layer", -INFINITY),
        _OF_SOIL["pore_ratio"],
    ],
)._replace(
    required=True,
    repeats="named",
    tables={"friction": OF_SOIL, "cohesion": COHESION._replace(title="cohesion of the soil")},
)
_LAYER = table_of(
    "the soils from the ground down, each by its name and its top",
    [replace(TOP, kind="line")],
    {"soil": worded("soil", "name of the soil", optional=False)},
)._replace(required=True, repeats="numbered")
_SLIP = table_of(
    "strength along the slip surface as the mass slides",
    [],
    {
        "strength": worded(
            "strength",
            "base (default): strength of the ground below; mass: strength carried along with the mass",
            "one of base, mass",
            kind="base|mass",
        ),
        "foreland": worded(
            "foreland", "name of the soil below the arc beyond its exit, by default the soil at the exit"
        ),
    },
)._replace(tables={"rate": RATE_OF_SOILS})


def _plausible(table: KeyTable) -> KeyTable:
    """Return a table of cohesion with the upper bound of a soil's cohesion for its keys in kPa."""
    keys = {
        name: replace(key, upper=_MOST_COHESION) if name.endswith("_kPa") else key for name, key in table.keys.items()
    }
    return table._replace(keys=keys)


_COHESION = EFFECT_TABLES["cohesion"]
_OF_EFFECTS = EFFECT_TABLES | {
    "cohesion": _COHESION._replace(laws={name: _plausible(table) for name, table in _COHESION.laws.items()})
}
WITH_ONE_SOIL = TOP_LEVEL._replace(tables={"friction": FRICTION, **_OF_EFFECTS, **SLOPING, **LOADS, **FURTHER})
_GROUND = SLOPING["ground"]
_OF_LAYERS = {name: table for name, table in WITH_ONE_SOIL.tables.items() if name not in NOT_WITH_LAYERS} | {
    "ground": _GROUND._replace(keys={k: key for k, key in _GROUND.keys.items() if key.name != "unit_weight"})
}
WITH_LAYERS = TOP_LEVEL._replace(tables={**_OF_LAYERS, "slip": _SLIP, "soils": _SOIL, "layers": _LAYER})
