"""Effects of a scene file with records, which are read and replaced by functions of time."""

from collections.abc import Mapping
from typing import Any

from slipcircle.base.checks import InputError, Message
from slipcircle.workbench.records.records import read_pore_pressure, read_record

_OF_WATER = ("units", "column", "step", "start", "gaps")
_OF_RECORDS = ("holds", "units", "step", "start", "gaps")
_BESIDE_RECORDS = ("two_way", "scale", "peak")


def with_records(
    effects: Mapping[str, Mapping[str, Any]], gravity: float, uncertain: Mapping[str, Any]
) -> dict[str, Mapping[str, Any]]:
    """Effects with the series of their records instead of file names; gravity in m/s^2.

    Gravity must not be among the uncertain keys.

    Raises
    ------
    ValueError
        If a file cannot be read as it is described; names the effect.
    """
    readers = {"shaking": lambda settings: _shaking(settings, gravity), "pore_pressure": _pore_pressure}
    read = dict(effects)
    for name in readers:
        if "record" in effects.get(name, {}):
            try:
                read[name] = readers[name](effects[name])
            except InputError as error:
                where = f"{error.what}: " if error.what else ""
                templates = [Message(where + message.template) for message in error.messages]
                raise InputError("", [template.within(f"effects.{name}") for template in templates]) from error
            except (ValueError, OSError) as error:
                is_vertical = str(effects[name].get("vertical_record")) in str(error)
                record = "vertical_record" if is_vertical else "record"
                raise InputError("", [f"{{effects.{name}.{record}}}: {error}"]) from error
    gravities = [key for key in ("arc.gravity_m_s2", "ground.gravity_m_s2") if key in uncertain]
    if gravities and "record" in effects.get("shaking", {}):
        raise InputError("", [f"{gravities[0]}: must be one number with a record, which is read over gravity"])
    return read


def _pore_pressure(settings: Mapping[str, Any]) -> dict[str, Any]:
    """A ratio or a pressure from a record."""
    reading = {k: settings[k] for k in _OF_WATER if k in settings}
    series = read_pore_pressure(settings["record"], **reading)
    other = next((k for k in ("time", *series) if k in settings), None)
    if other is not None:
        raise InputError("", [f"{{{other}}} and {{record}} exclude each other; remove one"])
    of_record = {"record", *_OF_WATER}
    others = {k: v for k, v in settings.items() if k not in of_record}
    return others | series


def _shaking(settings: Mapping[str, Any], gravity: float) -> dict[str, Any]:
    """k_h(t) and k_v(t) from a record, over gravity."""
    for way in ("horizontal", "pulse"):
        if way in settings:
            raise InputError("", [f"{{{way}}} and {{record}} exclude each other; remove one"])
    known = {"record", "column", "vertical_record", "vertical_column", *_OF_RECORDS, *_BESIDE_RECORDS}
    if strange := [k for k in settings if k not in known]:
        raise InputError("", [f"{{{strange[0]}}}: does not belong to a record; leave it out"])
    if "holds" not in settings:
        missing = '{holds}: is missing: a record must say whether it holds "ground" or "driving" acceleration'
        raise InputError("", [missing])
    scaled = "scale" in settings or "peak" in settings
    common = {k: settings[k] for k in _OF_RECORDS if k in settings}
    common |= {"gravity": gravity, "scaled": scaled}
    horizontal = read_record(settings["record"], column=settings.get("column"), **common)
    series: dict[str, Any] = {"horizontal": horizontal}
    if "vertical_record" in settings or "vertical_column" in settings:
        path = settings.get("vertical_record", settings["record"])
        series["vertical"] = read_record(path, column=settings.get("vertical_column"), **common)
    factor = {} if "peak" in settings else {"scale": 1.0}
    return series | factor | {k: settings[k] for k in _BESIDE_RECORDS if k in settings}
