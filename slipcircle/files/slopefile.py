"""What the ground, circle, water and search of a scene's file make: its section, and what is said of its stability."""

import re
from collections.abc import Callable, Mapping
from typing import Any

from slipcircle.scene.ground import circle_through, circle_touching, simple_slope
from slipcircle.scene.keys import SLOPING
from slipcircle.scene.search import Critical, at_circle, critical
from slipcircle.scene.section import Section
from slipcircle.scene.stability import Slope

_OF_SECTION = ("gravity", "width")


def section(
    given: Mapping[str, dict[str, Any]], soil: Mapping[str, float], tell: Callable[[str], None]
) -> tuple[Section, Critical | None]:
    """The section of the circle that is given, or of the critical one; and its stability, where the soil has any.

    Takes arguments by table, in SI units, and strength and pore pressure at the start, empty where nothing is known of
    them; a ValueError lists every mistake by its key. ``tell`` takes lines of progress.
    """
    try:
        circle, limits = dict(given["circle"]), dict(given["search"])
        own, k_h = {n: v for n, v in given["ground"].items() if n in _OF_SECTION}, limits.pop("k_h", 0.0)
        shared = _shared(given["ground"], given["water"])
        if "critical" in circle:
            if not soil:
                raise ValueError("critical: circle.critical: needs friction or cohesion, and a pore pressure that is "
                                 "no record")  # fmt: skip
            found = critical(Slope(**shared, k_h=k_h, **soil), circle["critical"], **limits, tell=tell)
            circle = {n: getattr(found, n) for n in ("centre", "radius", "between")}
            return Section(**shared, **circle, **own), found
        if len(circle.get("through", "12")) != 2:
            raise ValueError("circle_through: through: must be two points, [[x, y], [x, y]]")
        if "touching" in circle:
            centre, radius = circle_touching(circle["through"][0], circle["through"][1], circle["touching"])
        elif "through" in circle:
            centre, radius = circle_through(*circle["through"], radius=circle.get("radius"), depth=circle.get("depth"))
        else:
            centre, radius = circle["centre"], circle["radius"]
        body = Section(**shared, centre=centre, radius=radius, between=circle.get("between"), **own)
        # The circle is known to be above the base, which may lie higher than ground beside it.
        return body, at_circle(Slope(**shared | {"base": None}, k_h=k_h, **soil), body) if soil else None
    except ValueError as error:
        raise ValueError(_by_key(str(error))) from error


def _shared(ground: Mapping[str, Any], water: Mapping[str, Any]) -> dict[str, Any]:
    """What slope and section are both made of."""
    points = ground.get("ground")
    if points is None:
        points = simple_slope(ground["height"], angle=ground.get("angle"), run=ground.get("run"))
    more = {"water_unit_weight": water["unit_weight"]} if "unit_weight" in water else {}
    return {"ground": points, "unit_weight": ground["unit_weight"], "base": ground.get("base"),
            "level": water.get("level")} | more  # fmt: skip


def _by_key(said: str) -> str:
    """What a slope or a section says of its arguments, said of the keys that stand for them in a file."""
    of, _, rest = said.partition(": ")
    tables = ("search",) if of == "critical" else ("ground", "circle", "water")
    keys = {key.name: f"{t}.{k}" for t in tables for k, key in SLOPING[t].keys.items()}
    keys |= {"pore_ratio": "pore_pressure.ratio", "pressure": "pore_pressure.pressure_kPa"}
    rest = re.sub(rf"(^|; )({'|'.join(keys)})(?= =|:|\[)", lambda m: m[1] + keys[m[2]], rest)
    rest = rest.replace("choose one by between =", "choose one by circle.between_m =")
    return f"critical: {rest}" if of == "critical" else rest
