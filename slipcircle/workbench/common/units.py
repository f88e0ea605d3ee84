"""Units: sizes, suffixes of keys in scene files, and spellings in record files."""

import re
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from slipcircle.base.kinds import Floats, NumberMap, TextMap
from slipcircle.tables import STRONGEST

# The international foot is 0.3048 m and the pound 0.45359237 kg (yard and pound agreement of 1959), standard gravity
# 9.80665 m/s^2 (CGPM 1901); the US survey foot is 1200/3937 m (Mendenhall order of 1893).
_FOOT = 0.3048
_POUND_MASS = 0.45359237  # kg
_POUND = _POUND_MASS * 9.80665  # N, of force
_PSF = _POUND / _FOOT**2
LENGTHS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "ft": _FOOT, "in": 0.0254, "us_ft": 1200 / 3937}
STRESSES = {"kPa": 1e3, "Pa": 1.0, "MPa": 1e6, "psf": _PSF, "ksf": 1e3 * _PSF, "psi": 144 * _PSF}
UNITS_OF_KEYS: Mapping[str, NumberMap] = {  # by SI unit; published keys have the first unit
    "m": LENGTHS,
    "m/s": {f"{length}/s": size for length, size in LENGTHS.items()},
    "m/s^2": {f"{length}/s2": size for length, size in LENGTHS.items()},
    "Pa": STRESSES,
    "N/m^3": {"kN/m3": 1e3, "pcf": _POUND / _FOOT**3},
    "Pa/m": {f"{s}/{d}": size / depth for d, depth in LENGTHS.items() for s, size in STRESSES.items()},
}
SYSTEMS: Mapping[str, Mapping[str, tuple[str, float]]] = {  # units of output by SI unit, with their sizes
    "SI": {},
    "US": {
        "m": ("ft", _FOOT),
        "m/s": ("ft/s", _FOOT),
        "m/s^2": ("ft/s^2", _FOOT),
        "m^2": ("ft^2", _FOOT**2),
        "Pa": ("psf", _PSF),
        "Pa/m": ("psf/ft", _PSF / _FOOT),
        "N/m^3": ("pcf", _POUND / _FOOT**3),
        "kg/m": ("lb/ft", _POUND_MASS / _FOOT),
        "J": ("kip-ft", 1e3 * _POUND * _FOOT),
    },
}
GRAVITIES = {"g": 1.0, "%g": 1e-2, "mg": 1e-3}  # units that follow the scene's own gravity
UNITS = {  # m/s^2
    "g": 9.81,
    "%g": 0.0981,
    "mg": 9.81e-3,
    **{unit: UNITS_OF_KEYS["m/s^2"][unit] for unit in ("m/s2", "cm/s2", "mm/s2", "ft/s2", "in/s2")},
    "mgal": 1e-5,
}
_PER_S2 = r"(?:/s/s|/\(?s[.*]?s\)?|/\(?s2\)?|[._]?s-2|_s_?2)"


class RecordedQuantity(NamedTuple):
    """Quantity in record files: sizes of its units, expressions for their spellings, and formats of its files."""

    name: str
    units: NumberMap
    spellings: TextMap
    choice: str
    role: str = ""  # of a column, as the option ``columns`` names it
    kinds: str = "CSV"


ACCELERATION = RecordedQuantity(
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
PORE_PRESSURE = RecordedQuantity(
    "pore pressure",
    STRESSES | {"ratio": 1.0},
    {"Pa": "pa", "kPa": "kpa|kn/m2", "MPa": "mpa", "psf": "psf", "ksf": "ksf", "psi": "psi", "ratio": "ratio|r_?u|-"},
    "Pa, kPa, MPa, psf, ksf, psi, ratio",
    "pressure",
)
TIME = RecordedQuantity(
    "time", {"s": 1.0, "ms": 1e-3, "us": 1e-6}, {"s": "s", "ms": "m(?:illi)?s", "us": "(?:u|µ|μ|micro)s"}, "s, ms, us"
)
LENGTH = RecordedQuantity(
    "length",
    LENGTHS,
    {
        "m": "m|met(?:er|re)s?",
        "cm": "cm|centimet(?:er|re)s?",
        "mm": "mm|millimet(?:er|re)s?",
        "ft": "ft|feet|foot|internationalfeet",
        "in": "in|inch(?:es)?",
        "us_ft": "(?:us(?:survey)?|survey)[-_]?(?:ft|feet|foot)|ftus",
    },
    ", ".join(LENGTHS),
    "x",
)
_TYPED = str.maketrans({"²": "2", "⁻": "-", "−": "-", "–": "-", "·": ".", "⋅": ".", "’": "'", "′": "'"})


def suffix(unit: str) -> str:
    """Return the ending of a key for a unit: ``per_m_kPa`` for kPa/m, ``ft_s2`` for ft/s2."""
    of, _, per = unit.partition("/")
    return f"per_{per}_{of}" if per in LENGTHS else unit.replace("/", "_")


_PUBLISHED = {  # by suffix, the longest first: the unit, the published suffix, and the ratio of both units
    suffix(unit): (unit, suffix(next(iter(units))), size / next(iter(units.values())))
    for units in UNITS_OF_KEYS.values()
    for unit, size in units.items()
}
_SUFFIX = re.compile(f"_({'|'.join(sorted(_PUBLISHED, key=len, reverse=True))})$")


def published(key: str) -> tuple[str, str, float]:
    """Return the published spelling of a key, the unit of the key, and the ratio of this unit to the published unit.

    The key ``height_ft`` gives ("height_m", "ft", 0.3048).
    """
    ending = _SUFFIX.search(key)
    if ending is None:
        return key, "", 1.0
    unit, end, ratio = _PUBLISHED[ending[1]]
    return key[: ending.start() + 1] + end, unit, ratio


def spelt_like(typed: str, key: str) -> str:
    """Return a published key rewritten in the unit of a typed key, if both have the same quantity.

    ``spelt_like("width_ft", "height_m")`` is "height_ft".
    """
    spelling, unit, _ = published(typed)
    end = suffix(unit)
    of_published = spelling[len(typed) - len(end) :]
    return key.removesuffix(of_published) + end if unit and key.endswith(f"_{of_published}") else key


def unit_of(text: str, quantity: RecordedQuantity = ACCELERATION) -> str | None:
    """Return the unit in ``quantity.units`` that a text spells; None if it is not a unit of the quantity."""
    plain = re.sub(r"\bper\b", "/", text.strip().lower().translate(_TYPED))
    plain = re.sub(r"sec(?:ond)?s?(?![a-z])", "s", plain).replace("squared", "2")
    plain = re.sub(r"\s|\^|\*\*", "", plain)
    for candidate in (plain, re.split(r"[(\[]", plain)[0]):
        for unit, spelling in quantity.spellings.items():
            if re.fullmatch(spelling, candidate.strip("()[]{}.,;:")):
                return unit
    return None


def seconds_of(unit: str, text: str, default: str = "s") -> float:
    """Return a time in s from a text such as "0.02 sec"; 0 if it is not a time.

    ``unit`` replaces the unit in the text if it is not empty, and ``default`` applies without any. With Hz or sps the
    text is a rate.
    """
    amount = re.match(r"(\d+\.?\d*(?:e[-+]?\d+)?|\.\d+)\s*([^\d\s/,;]*)", text, re.IGNORECASE)
    if amount is None or not 0.0 < float(amount[1]) < 1e9:
        return 0.0
    word = unit or amount[2] or default
    if word.lower() in ("hz", "sps"):
        return 1.0 / float(amount[1])
    return float(amount[1]) * TIME.units.get(unit_of(word, TIME) or "", 0.0)


def over_gravity(values: Floats, units: str, holds: str, gravity: float) -> Floats:
    """Return accelerations in units of gravity, positive if they drive the mass down-slope.

    ``units`` is a key of `UNITS`, and ``gravity`` is in m/s^2. Accelerations of the ground, with ``holds`` equal to
    "ground", change their sign.
    """
    factor = GRAVITIES.get(units, UNITS[units] / gravity)
    return values * (-factor if holds == "ground" else factor) + 0.0


def check_strength(name: str, values: Floats, units: str) -> None:
    """Reject accelerations, in a unit of `UNITS`, beyond any recorded ground motion, and suggest a plausible unit.

    ``name`` is the file, for the message of a ValueError.
    """
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
