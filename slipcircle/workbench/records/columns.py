"""Roles of the columns of a table, from their names and units."""

import re
from typing import NamedTuple

from slipcircle.base.kinds import TextPair, Texts
from slipcircle.workbench.common.units import ACCELERATION, TIME, RecordedQuantity, unit_of

_SEED = "[bcehs][nlgh]"  # band and instrument of a channel code, followed by its orientation
_VERTICAL = rf"[zvu]|(?:ud|up|du|dn|dwn|down|vert?|vrt)\d?|verti[ck]al\w*|updown|a(?:cc|ccel)?[zv]|{_SEED}z(?:\d\d)?"
_HORIZONTAL = (
    r"[newsxylt]|(?:ns|ew|sn|we|h|fn|fp)\d?|north\w*|east\w*|south|west|long\w*|trans?\w*|rad(?:ial)?|horiz\w*|"
    rf"[ns]\d{{1,2}}[ew]|[0-2]\d\d|3[0-5]\d|360|\d{{1,3}}deg|{_SEED}[ne123rt](?:\d\d)?"
)
_NAMED = r"acc(?:el\w*)?|acel\w*|beschl\w*|ivme|a[xyhn]?|ae"
_TIME = r"t|times?|timestamp|zeit|temps|tiempo|tempo|zaman|elapsed|s|secs?|seconds?"
_COUNTER = r"index|idx|samples?(?:no|number|index)?|n|no|nr|num|number|i|k|row|points?|npts?|unnamed0"
_SPECTRAL = r"freq\w*|frequenz|fréquence|frec\w*|f|hz|per[ií]od\w*|tn|omega|ω"
_OTHER = r"p?s[adv]|spectr\w*|response|fourier|amplitude|arias|vel\w*|dis\w*|geschw\w*|temperature|depth"
_OTHER_UNIT = r"(?:[mck]?m|in|ft|feet)(?:[/_ ]?s(?:ec)?|s-1)?|hz|k?pa|deg|counts?|v|mv|°c?"


class Column(NamedTuple):
    """Column of a table: name and unit as written, its role, and the reason if it has no role."""

    name: str
    unit: str = ""
    role: str = ""
    reason: str = ""


def _words(text: str) -> Texts:
    """Return the words of a name in lower case, and the words joined, as the last element.

    Words are separated as in `acc_Z`, `accZ` and `U-D`.
    """
    words = re.findall(r"[^\W_]+", re.sub(r"(?<=[a-z])(?=[A-Z])", " ", text).lower())
    return [*words, "".join(words)]


def _says(text: str, words: str) -> bool:
    """Return whether any word of a text matches a regular expression completely."""
    return any(re.fullmatch(words, word) for word in _words(text))


def is_vertical(component: str) -> bool:
    """Return whether the name of a component or column, such as "UD" or "acc_Z", marks it as vertical."""
    return _says(component, _VERTICAL)


def is_direction(text: str) -> bool:
    """Return whether a text is just the name of a component."""
    return re.fullmatch(rf"{_VERTICAL}|{_HORIZONTAL}|\d\d?", _words(text)[-1]) is not None


def _is_time(name: str) -> bool:
    """Return whether the first word of a name marks a column of times."""
    first, *_ = _words(name)
    return re.fullmatch(_TIME, first) is not None


def _with_unit(field: str, quantity: RecordedQuantity) -> TextPair:
    """Return name and unit of a field such as `acc (g)`, `a [m/s2]`, `time_s` or `acc cm/s^2`.

    The unit is empty if the field has none. `quantity` is acceleration or pore pressure.
    """
    bracketed = re.fullmatch(r"(.*?)\s*[(\[{]([^()\[\]{}]+)[)\]}]?\s*", field)
    is_unit = bracketed and (unit_of(bracketed[2], TIME) or _is_time(bracketed[1]) or not is_direction(bracketed[2]))
    if bracketed and is_unit:
        return bracketed[1].strip(" _-,:"), bracketed[2].strip()
    for place in re.finditer(r"[\s_,/:-]+", field):
        name = field[: place.start()]
        tail = field[place.end() :]
        if is_direction(tail) and not _is_time(name):
            break
        times = _is_time(name) and not _is_time(tail)
        if times or unit_of(tail, quantity) or re.fullmatch(_OTHER_UNIT, tail.lower()):
            return name, tail.removeprefix("in ")
    return field, ""


def column_of(field: str, quantity: RecordedQuantity) -> Column:
    """Return the column for a header field, with the role that its unit or name states.

    `quantity` is acceleration or pore pressure, and the role is empty for a column that is neither time nor this
    quantity.
    """
    name, unit = _with_unit(field, quantity)
    vertical = quantity is ACCELERATION and is_vertical(name)
    value = "vertical" if vertical else quantity.role
    is_other = quantity is ACCELERATION and _says(name, _OTHER)
    if is_other and (unit_of(unit, quantity) or not unit):
        return Column(name, unit, "", f"is not {quantity.name} by its name")
    if unit_of(unit, quantity):
        return Column(name, unit, value)
    if _says(name, _SPECTRAL) or unit.lower() == "hz":
        return Column(name, unit, "spectrum", "is the abscissa of a spectrum")
    is_time = _is_time(name)
    if unit_of(unit or "s" * is_time, TIME) and not _says(name, _NAMED):
        return Column(name, unit, "time")
    if unit:
        return Column(name, unit, "", f"its unit {unit!r} is not one of {(TIME if is_time else quantity).choice}")
    if re.fullmatch(_COUNTER, _words(name)[-1]) and name != "N":  # north
        return Column(name, unit, "counter", "counts the samples")
    if (quantity is not ACCELERATION and name) or vertical or _says(name, f"{_NAMED}|{_HORIZONTAL}"):
        return Column(name, unit, value)
    return Column(name, unit, "", f"neither its name nor a unit says {quantity.name}")
