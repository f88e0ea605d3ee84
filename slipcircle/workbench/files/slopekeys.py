"""Declarations of the tables of a scene file with a slope: ground, circle, water, soils, layers and loads."""

import math
from collections.abc import Mapping
from dataclasses import replace

from generated.effects import INFINITY, LIMITS, Parameter
from slipcircle.derivatives import SOIL_BOUNDS
from slipcircle.workbench.files.keys import (
    ARC,
    COHESION,
    EFFECT_TABLES,
    FRICTION,
    FURTHER,
    LENGTH,
    OF_SOIL,
    RATE_OF_SOILS,
    TOP,
    Key,
    Table,
    declare,
    table_of,
)
from slipcircle.workbench.stability.factors import YIELD
from slipcircle.workbench.stability.stability import METHODS

NOT_WITH_LAYERS = ("friction", "cohesion", "pore_pressure")
_MOST_COHESION = 1e5  # kPa, of the soil of a homogeneous slope; larger values are in Pa by mistake


def _length(name: str, help: str, lower: float = 0.0) -> Parameter:
    return declare(name, f"{name}_m", "m", help, lower, LIMITS["m"][1], 1.0, True, "fixed")


def _weight(help: str, optional: bool = False) -> Parameter:
    return declare("unit_weight", "unit_weight_kN_m3", "N/m^3", help, 0.0, 1e5, 1e3, optional, "fixed")


def _points(name: str, title: str) -> dict[str, Key]:
    key = "points_m" if name == "ground" else f"{name}_m"
    words = "a list of two points or more, [[x, y], [x, y], ...] (m)"
    return {key: Key(name, title, words, kind="points", number=LENGTH)}


def _pair(name: str, title: str, form: str = "[least, greatest]") -> dict[str, Key]:
    return {f"{name}_m": Key(name, title, f"two numbers, {form} (m)", kind="pair", number=LENGTH)}


def _place(name: str, help: str) -> Parameter:
    return replace(_length(name, help, -INFINITY), optional=False)


def _of_soil(name: str, key: str, help: str, per_unit: float = 1.0, optional: bool = True) -> Parameter:
    """Return the declaration of a number of a soil by its field of `Soil`."""
    return declare(name, key, SOIL_BOUNDS[name][0], help, *SOIL_BOUNDS[name][1:], per_unit, optional)


_PRESSURE = declare(
    "pressure",
    "pressure_kPa",
    "Pa",
    "the pressure, or at both ends, which varies by the greater one",
    -5e-324,
    1e12,
    1e3,
    False,
    "load",
)

_UPRIGHT = declare(
    "angle",
    "angle_deg",
    "rad",
    "its angle, 90 for a scarp",
    0.0,
    math.nextafter(math.pi / 2, 2.0),
    math.pi / 180,
    True,
    "fixed",
)
SLOPING: Mapping[str, Table] = {  # in place of an arc
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
            "critical": Key(
                "critical",
                "method of the search for the critical circle",
                f"one of {', '.join(METHODS)}, or {YIELD}: least yield coefficient",
                kind="|".join((*METHODS, YIELD)),
            ),
            "start": Key(
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
            "confined": Key(
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
            declare(
                "k_h",
                "k_h",
                "",
                "horizontal acceleration as a share of g, positive down-slope",
                -1.0,
                1.0,
                1.0,
                True,
                "fixed",
            ),
        ],
        _pair("entry", "x of the upper end")
        | _pair("exit", "x of the lower end")
        | {
            "k_h_on_surcharge": Key(
                "k_h_on_surcharge", "whether k_h acts on surcharges, by default false", "true or false", kind="flag"
            )
        },
    ),
}

LOADS: Mapping[str, Table] = {  # in addition to them
    "tension_crack": table_of(
        "a tension crack at the upper end of the slip surface",
        [
            replace(_length("depth", "its depth"), name="crack", optional=False, kind="number"),
            replace(_length("water", "height of the water in it, by default 0", -5e-324), name="crack_water"),
        ],
    ),
    "surcharge": table_of(
        "a pressure on the ground, linear from one x to the other",
        [_place("from", "x of its left end"), _place("to", "x of its right end"), _PRESSURE],
    )._replace(repeats="numbered"),
    "pond": table_of(
        "free water whose pore pressure is given otherwise, by r_u or by a lower or a confined level of [water]",
        [_place("from", "x of its left shore"), _place("to", "x of its right shore"), _place("level", "its level")],
    )._replace(repeats="numbered"),
}

# --- soils and layers ------------------------------------------------------------------------------------------------

_SOIL = table_of(
    "the soils, each by its name",
    [
        _of_soil("unit_weight", "unit_weight_kN_m3", "unit weight", 1e3, optional=False),
        _of_soil("saturated_unit_weight", "saturated_unit_weight_kN_m3", "unit weight below the water level", 1e3),
        _of_soil("cohesion", "cohesion_kPa", "cohesion, by default 0", 1e3),
        _of_soil(
            "cohesion_gradient",
            "cohesion_per_m_kPa",
            "growth of the cohesion per metre below datum_m, by default 0",
            1e3,
        ),
        _length("datum", "y below which the cohesion grows, by default the top of the layer", -INFINITY),
        _of_soil("pore_ratio", "pore_pressure_ratio", "r_u, in place of the water level, by default 0"),
    ],
)._replace(
    required=True,
    repeats="named",
    tables={"friction": OF_SOIL, "cohesion": COHESION._replace(title="cohesion of the soil")},
)
_LAYER = table_of(
    "the soils from the ground down, each by its name and its top",
    [
        replace(
            _of_soil("top", "top_m", "its top, of the first layer the ground; a line varies by its first height"),
            kind="line",
        )
    ],
    {"soil": Key("soil", "name of the soil", required=True)},
)._replace(required=True, repeats="numbered")
_SLIP = table_of(
    "strength along the slip surface as the mass slides",
    [],
    {
        "strength": Key(
            "strength",
            "base (default): strength of the ground below; mass: strength carried along with the mass",
            "one of base, mass",
            kind="base|mass",
        ),
        "foreland": Key("foreland", "name of the soil below the arc beyond its exit, by default the soil at the exit"),
    },
)._replace(tables={"rate": RATE_OF_SOILS})


def _plausible(table: Table) -> Table:
    """Return a table of cohesion with the bounds that apply to soils."""
    keys = {
        name: key._replace(number=replace(key.number, high=_MOST_COHESION)) if name.endswith("_kPa") else key
        for name, key in table.keys.items()
    }
    return table._replace(keys=keys)


_COHESION = EFFECT_TABLES["cohesion"]
_OF_EFFECTS = EFFECT_TABLES | {
    "cohesion": _COHESION._replace(laws={name: _plausible(table) for name, table in _COHESION.laws.items()})
}
WITH_ONE_SOIL = TOP._replace(tables={"friction": FRICTION, **_OF_EFFECTS, **SLOPING, **LOADS, **FURTHER})
_GROUND = SLOPING["ground"]
_OF_LAYERS = {name: table for name, table in WITH_ONE_SOIL.tables.items() if name not in NOT_WITH_LAYERS} | {
    "ground": _GROUND._replace(keys={k: key for k, key in _GROUND.keys.items() if key.name != "unit_weight"})
}
WITH_LAYERS = TOP._replace(tables={**_OF_LAYERS, "slip": _SLIP, "soils": _SOIL, "layers": _LAYER})
