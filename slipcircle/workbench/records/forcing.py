"""Effects of a scene file with records, which are read and replaced by functions of time."""

from collections.abc import Mapping

from slipcircle.base.inputerror import InputError, Message
from slipcircle.base.kinds import Texts, ValueDict, Values
from slipcircle.workbench.common.units import ACCELERATION, PORE_PRESSURE, RecordedQuantity
from slipcircle.workbench.records.recordfiles import Options, RecordSamples
from slipcircle.workbench.records.records import pressure_of, read_record_samples, shaking_of
from slipcircle.workbench.suites.intensities import drift_warning

_BESIDE_RECORDS = ("two_way", "scale", "peak")


def with_records(effects: Mapping[str, Values], gravity: float, uncertain: Values) -> tuple[dict[str, Values], Texts]:
    """Return effects with the series of their records instead of file names, and remarks about the records.

    Gravity is in m/s^2, and must not be among the uncertain keys.

    Raises
    ------
    ValueError
        If a file cannot be read as described. The message names the effect.
    """
    remarks: Texts = []
    readers = {
        "shaking": lambda settings: _shaking(settings, gravity, remarks),
        "pore_pressure": lambda settings: _pore_pressure(settings, remarks),
    }
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
    return read, remarks


def _samples(quantity: RecordedQuantity, file: str, settings: Values, remarks: Texts) -> RecordSamples:
    """Return the samples of a record with the settings of an effect, and add remarks about unused columns.

    `settings` are the keys of the effect in the scene file. The remarks are appended to the list.
    """
    options = Options(**{key: settings[key] for key in Options._fields if key in settings})
    samples, unused = read_record_samples(quantity, file, options)
    remarks += unused
    return samples


def _pore_pressure(settings: Values, remarks: Texts) -> ValueDict:
    """Return the parameters of the effect with a pore pressure ratio or a pressure in Pa from a record.

    `settings` are the keys of the effect in the scene file. Remarks are appended to the list.
    """
    file = settings["record"]
    series = pressure_of(_samples(PORE_PRESSURE, file, settings, remarks), file)
    other = next((k for k in ("time", *series) if k in settings), None)
    if other is not None:
        raise InputError("", [f"{{{other}}} and {{record}} exclude each other; remove one"])
    of_record = {"record", *Options._fields}
    return {k: v for k, v in settings.items() if k not in of_record} | series


def _shaking(settings: Values, gravity: float, remarks: Texts) -> ValueDict:
    """Return the parameters of shaking with k_h(t) and k_v(t) from a record, divided by gravity.

    `settings` are the keys of the effect in the scene file. Remarks are appended to the list.
    """
    for way in ("horizontal", "pulse"):
        if way in settings:
            raise InputError("", [f"{{{way}}} and {{record}} exclude each other; remove one"])
    allowed = {"record", "holds", "vertical_record", "vertical_column", *Options._fields, *_BESIDE_RECORDS}
    if strange := [k for k in settings if k not in allowed]:
        raise InputError("", [f"{{{strange[0]}}}: does not belong to a record; leave it out"])
    if "holds" not in settings:
        missing = '{holds}: is missing: a record must say whether it holds "ground" or "driving" acceleration'
        raise InputError("", [missing])
    scaled = "scale" in settings or "peak" in settings
    chosen = {"horizontal": settings}
    if "vertical_record" in settings or "vertical_column" in settings:
        of_vertical = {"record": settings.get("vertical_record", settings["record"])}
        chosen["vertical"] = {**settings, **of_vertical, "column": settings.get("vertical_column")}
    series = {}
    for name, of_record in chosen.items():
        file = of_record["record"]
        samples = _samples(ACCELERATION, file, of_record, remarks)
        series[name] = shaking_of(samples, file, settings["holds"], gravity, scaled)
        if drift := drift_warning(series[name], gravity):
            remarks.append(f"{file}: {drift}")
    factor = {} if "peak" in settings else {"scale": 1.0}
    return series | factor | {k: settings[k] for k in _BESIDE_RECORDS if k in settings}
