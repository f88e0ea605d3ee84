"""Units of accelerations, pressures and times, and their spellings in files."""

import re
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.tables import STRONGEST

GRAVITIES = {"g": 1.0, "%g": 1e-2, "mg": 1e-3}  # units that follow the scene's own gravity
UNITS = {  # m/s^2
    "g": 9.81,
    "m/s2": 1.0,
    "cm/s2": 1e-2,
    "mm/s2": 1e-3,
    "ft/s2": 0.3048,
    "in/s2": 0.0254,
    "%g": 0.0981,
    "mg": 9.81e-3,
    "mgal": 1e-5,
}
_PER_S2 = r"(?:/s/s|/\(?s[.*]?s\)?|/\(?s2\)?|[._]?s-2|_s_?2)"


class Quantity(NamedTuple):
    """A quantity in record files: sizes of its units, expressions for their spellings, and formats of its files."""

    name: str
    units: Mapping[str, float]
    spellings: Mapping[str, str]
    choice: str
    role: str = ""  # of a column, as the option ``columns`` names it
    kinds: str = "CSV"


ACCELERATION = Quantity(
    "acceleration",
    UNITS,
    {
        "g": "g'?s?",
        "%g": "(?:%|percent|pct)g'?s?",
        "mg": "m(?:illi)?-?g'?s?",
        "mgal": "m(?:illi)?gals?",
        "cm/s2": f"(?:cm|centimet(?:er|re)s?){_PER_S2}|gal(?:e?s)?",
        "m/s2": f"(?:m|met(?:er|re)s?){_PER_S2}",
        "mm/s2": f"(?:mm|millimet(?:er|re)s?){_PER_S2}",
        "ft/s2": f"(?:ft|feet|foot){_PER_S2}",
        "in/s2": f"(?:in|inch(?:es)?){_PER_S2}",
    },
    f"{', '.join(UNITS)}, gal",
    "acceleration",
    "CSV, AT2, or the text of ESM, K-NET, COSMOS, CSMIP, SMC or GeoNet",
)
PORE_PRESSURE = Quantity(
    "pore pressure",
    {"Pa": 1.0, "kPa": 1e3, "MPa": 1e6, "ratio": 1.0},
    {"Pa": "pa", "kPa": "kpa|kn/m2", "MPa": "mpa", "ratio": "ratio|r_?u|-"},
    "Pa, kPa, MPa, ratio",
    "pressure",
)
TIME = Quantity(
    "time", {"s": 1.0, "ms": 1e-3, "us": 1e-6}, {"s": "s", "ms": "m(?:illi)?s", "us": "(?:u|µ|μ|micro)s"}, "s, ms, us"
)
_TYPED = str.maketrans({"²": "2", "⁻": "-", "−": "-", "–": "-", "·": ".", "⋅": ".", "’": "'", "′": "'"})


def unit_of(text: str, quantity: Quantity = ACCELERATION) -> str | None:
    """Return the unit that a text spells, by its key in ``units``; None if it is not a unit of the quantity."""
    plain = re.sub(r"\bper\b", "/", text.strip().lower().translate(_TYPED))
    plain = re.sub(r"sec(?:ond)?s?(?![a-z])", "s", plain).replace("squared", "2")
    plain = re.sub(r"\s|\^|\*\*", "", plain)
    for candidate in (plain, re.split(r"[(\[]", plain)[0]):
        for unit, spelling in quantity.spellings.items():
            if re.fullmatch(spelling, candidate.strip("()[]{}.,;:")):
                return unit
    return None


def seconds_of(unit: str, text: str, default: str = "s") -> float:
    """Return a time in s from a text such as "0.02 sec", whose unit may be known apart; 0 if it is not a time."""
    found = re.match(r"(\d+\.?\d*(?:e[-+]?\d+)?|\.\d+)\s*([^\d\s/,;]*)", text, re.IGNORECASE)
    if found is None or not 0.0 < float(found[1]) < 1e9:
        return 0.0
    word = unit or found[2] or default
    if word.lower() in ("hz", "sps"):
        return 1.0 / float(found[1])
    return float(found[1]) * TIME.units.get(unit_of(word, TIME) or "", 0.0)


def period_of(unit: str, text: str) -> float:
    """Return the period in s of a rate such as "50Hz" or "200"; 0 if the text is not one."""
    return seconds_of(unit, text, "Hz")


def over_gravity(values: Floats, units: str, holds: str, gravity: float) -> Floats:
    """Accelerations as driving ones over gravity."""
    factor = GRAVITIES.get(units, UNITS[units] / gravity)
    return values * (-factor if holds == "ground" else factor) + 0.0


def check_strength(name: str, values: Floats, units: str) -> None:
    """Reject accelerations beyond any recorded ground motion, and name the unit in which they would be plausible."""
    most = float(np.max(np.abs(values), initial=0.0))
    peak = most * UNITS[units] / 9.81
    if peak <= STRONGEST:
        return
    below = [
        unit for unit, size in UNITS.items() if unit[0] in "cm" and "g" not in unit and most * size / 9.81 <= STRONGEST
    ]
    meant = f"; was it in {max(below, key=lambda unit: UNITS[unit])}" if below else "; is it unscaled"
    raise ValueError(
        f"{name}: its greatest value is {most:.6g} {units}, {peak:.4g} g, and no ground has shaken with more than "
        f"{STRONGEST:g} g{meant}? Give units, or scale it"
    )
