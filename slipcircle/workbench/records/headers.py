"""Headers of files without times (PEER's AT2, ESM, K-NET, COSMOS, CSMIP, SMC), and quantities that files hold."""

import re
from collections.abc import Mapping
from itertools import pairwise
from typing import NamedTuple

from slipcircle.base.checks import INFINITY

UNITS = {"g": 0.0, "m/s2": 1.0, "cm/s2": 1e-2, "mm/s2": 1e-3, "%g": 0.0}  # m/s^2; g is the scene's own gravity
_SAME = {
    "m/s/s": "m/s2",
    "cm/s/s": "cm/s2",
    "cm/sec2": "cm/s2",
    "cm/sec/sec": "cm/s2",
    "mm/s/s": "mm/s2",
    "m/sec2": "m/s2",
    "gal": "cm/s2",
    "gals": "cm/s2",
    "m_s2": "m/s2",
    "cm_s2": "cm/s2",
    "mm_s2": "mm/s2",
    "ms-2": "m/s2",
    "g's": "g",
    "gs": "g",
}


class Quantity(NamedTuple):
    """What a file may hold: its units and their other names in lower case, how columns say them, kinds of files."""

    name: str
    units: Mapping[str, float]
    same: Mapping[str, str]
    choice: str
    suffix: str  # of a column's name
    kinds: str


ACCELERATION = Quantity(
    "acceleration",
    UNITS,
    _SAME,
    f"{', '.join(UNITS)}, gal",
    "(?:[cm]?m_s2)|g|gal",
    "CSV, AT2, or the text of ESM, K-NET, COSMOS, CSMIP or SMC",
)
PORE_PRESSURE = Quantity(
    "pore pressure",
    {"Pa": 1.0, "kPa": 1e3, "MPa": 1e6, "ratio": 1.0},
    {"r_u": "ratio", "ru": "ratio", "-": "ratio"},
    "Pa, kPa, MPa, ratio",
    "[kKM]?Pa",
    "CSV",
)


def unit_of(text: str, quantity: Quantity = ACCELERATION) -> str | None:
    """The unit of a quantity that a text stands for, as its ``units`` have it; None if it is none."""
    plain = re.sub(r"\s|\^|\*\*", "", text.strip().lower()).replace("²", "2")
    plain = quantity.same.get(plain, plain)
    return next((u for u in quantity.units if u.lower() == plain), None)


class Header(NamedTuple):
    """What the header of a file without times says."""

    lines: int
    samples: int
    step: float  # s between them
    units: str
    scale: float = 1.0  # of the numbers in the file
    about_mean: bool = False  # whether the instrument's offset, the mean, is to be taken off
    width: int = 0  # of a column, where these are fixed


def _at2(name: str, first: list[str]) -> Header | None:
    """PEER: ``NPTS= 5590, DT= .0050 SEC``, formerly ``5590 .0050 NPTS, DT``."""
    head = next((k for k, line in enumerate(first[:10], 1) if "NPTS" in line.upper() and "DT" in line.upper()), 0)
    if not head:
        return None
    above = " ".join(first[:head]).upper()
    line = first[head - 1].upper()
    if "VELOCITY" in above or "DISPLACEMENT" in above:
        raise ValueError(f"{name}: its header says that it holds no acceleration; take the AT2 file of the record")
    number = r"([-+]?\d*\.?\d+(?:[ED][-+]?\d+)?)"
    new = re.search(rf"NPTS\s*=\s*{number}.*?DT\s*=\s*{number}", line)
    match = new or re.search(rf"^\s*{number}[\s,]+{number}[\s,]+NPTS", line)
    if match is None:
        raise ValueError(
            f"{name}, line {head}: {first[head - 1].strip()!r}: must give NPTS and DT, as in 'NPTS= 4000, DT= .0050 "
            "SEC'"
        )
    count, dt = (float(x.replace("D", "E")) for x in match.groups())
    units = re.search(r"UNITS OF\s+(\S+)", above)
    return Header(head, int(count), dt, units[1].rstrip(".,") if units else "g")


def _esm(name: str, first: list[str]) -> Header | None:
    """ESM and ITACA: 64 lines ``KEY: value``, then a value a line."""
    head = next((k for k, line in enumerate(first) if not re.match(r"#?\s*[A-Z][A-Z0-9_/()^-]*\s*:", line)), len(first))
    pairs = (line.lstrip("# ").partition(":") for line in first[:head])
    fields = {key.strip(): value.strip() for key, _, value in pairs}
    if "SAMPLING_INTERVAL_S" not in fields:
        return None
    kind = fields.get("DATA_TYPE", "ACCELERATION")
    if kind.upper() != "ACCELERATION":
        raise ValueError(f"{name}: DATA_TYPE = {kind!r}: must be ACCELERATION; take the record's file of accelerations")
    try:
        dt, count = float(fields["SAMPLING_INTERVAL_S"]), int(fields["NDATA"])
    except (KeyError, ValueError) as error:
        raise ValueError(
            f"{name}: SAMPLING_INTERVAL_S and NDATA in its header must be a step in s and a count"
        ) from error
    return Header(head, count, dt, fields.get("UNITS", ""))


def _knet(name: str, first: list[str]) -> Header | None:
    """K-NET and KiK-net: 17 lines of key and value, then counts, of which ``Scale Factor 3920(gal)/6182761`` is one.

    The instrument's offset is the mean of its counts, which "Max. Acc." in the header has been freed of.
    """
    keys = ("Sampling Freq(Hz)", "Duration Time(s)", "Scale Factor")
    text = {key: line[len(key) :].strip() for line in first[:30] for key in keys if line.startswith(key)}
    if "Scale Factor" not in text:
        return None
    head = next((k for k, line in enumerate(first, 1) if line.startswith("Memo")), 17)
    numbers = re.fullmatch(r"([\d.]+)\s*\(gal\)\s*/\s*([\d.]+)", text["Scale Factor"])
    frequency = re.match(r"[\d.]+", text.get(keys[0], ""))
    seconds = re.match(r"[\d.]+", text.get(keys[1], ""))
    if numbers is None or frequency is None or seconds is None:
        raise ValueError(
            f"{name}: its header must say Sampling Freq(Hz), Duration Time(s), and Scale Factor as in 3920(gal)/6182761"
        )
    rate = float(frequency[0])
    scale = float(numbers[1]) / float(numbers[2])
    samples = round(rate * float(seconds[0]))
    return Header(head, samples, 1.0 / rate, "cm/s2", scale, about_mean=True)


_COSMOS_DATA = re.compile(
    r"(?P<samples>\d+)\s+acceleration\s+(?:data\s+)?(?:pts|points)\b.*?approx\s+(?P<seconds>[\d.]+)\s+secs.*?"
    r"units\s*=\s*(?P<units>[^\s(),]+).*?Format\s*=\s*\(\s*\d*[A-Z]+(?P<width>\d+)",
    re.IGNORECASE,
)
_COSMOS_REALS = re.compile(
    r"(?P<count>\d+)\s+Real-header values.*?(?P<lines>\d+)\s+lines.*?\(\s*\d*F(?P<width>\d+)", re.IGNORECASE
)
_STEP_MS, _STEP_S = 62, 34  # places in COSMOS' real header: of the processed samples, ms; of the recorder, s


def _cosmos(name: str, first: list[str]) -> Header | None:
    """COSMOS 1.20: text, integers and reals, comments, then a line that describes the samples, in fixed columns.

    The step stands among the reals; the line of the samples has their whole seconds, by which it is checked.
    """
    described = next(((k, m) for k, line in enumerate(first, 1) if (m := _COSMOS_DATA.search(line))), None)
    if described is None:
        return None
    head, data = described
    samples = int(data["samples"])
    seconds = float(data["seconds"])
    reals = _cosmos_reals(first)
    steps = [reals.get(_STEP_MS, 0.0) / 1e3, reals.get(_STEP_S, 0.0)]
    fitting = [step for step in steps if step > 0.0 and abs(samples * step - seconds) <= 1.0 + 0.02 * seconds]
    if not fitting:
        raise ValueError(
            f"{name}, line {head}: {samples} samples in {seconds:g} s, but the real header has no such step (value "
            f"{_STEP_MS} in ms, or {_STEP_S} in s)"
        )
    return Header(head, samples, fitting[0], data["units"], width=int(data["width"]))


def _cosmos_reals(first: list[str]) -> dict[int, float]:
    """The numbers of the real header by their places, from 1."""
    for k, line in enumerate(first):
        if title := _COSMOS_REALS.search(line):
            rows = first[k + 1 : k + 1 + int(title["lines"])]
            texts = fixed_columns(rows, int(title["width"]))
            return {place: float(text) for place, text in enumerate(texts, 1) if re.fullmatch(r"[-+.\dE]+", text)}
    return {}


_CSMIP_DATA = re.compile(
    r"\s*(?P<samples>\d+)\s+points of accel data equally spaced at\s*(?P<step>[\d.]+)\s*sec[,.\s]*"
    r"(?:in\s+(?P<units>[^\s,(]+))?(?:.*\(\s*\d*f(?P<width>\d+))?",
    re.IGNORECASE,
)


def _csmip(name: str, first: list[str]) -> Header | None:
    """CSMIP volume 2 (Shakal and Huang 1985): text, integers and reals, then a line that describes the samples."""
    described = ((k, m) for k, line in enumerate(first, 1) if (m := _CSMIP_DATA.match(line)))
    head, data = next(described, (0, None))
    if data is None:
        return None
    units = (data["units"] or "cm/sec2").rstrip(".")
    return Header(head, int(data["samples"]), float(data["step"]), units, width=int(data["width"] or 10))


_SMC_TEXT, _SMC_INTEGERS, _SMC_REALS = 11, 6, 10  # lines
_SMC_COMMENTS, _SMC_SAMPLES, _SMC_RATE = 15, 16, 1  # places in the integers and reals, from 0


def _smc(name: str, first: list[str]) -> Header | None:
    """SMC of the U.S. Geological Survey: text, integers (8I10), reals (5E15.7), comments, samples in cm/s^2."""
    kind = re.match(r"\s*[1-6] (UNCORRECTED|CORRECTED|VELOCITY|DISPLACEMENT|RESPONSE|FOURIER)\b", first[0])
    if kind is None:
        return None
    if kind[1] != "CORRECTED":
        raise ValueError(f"{name}: holds {first[0].strip()!r}: must be 2 CORRECTED ACCELEROGRAM; take that file")
    reals_from = _SMC_TEXT + _SMC_INTEGERS
    samples_from = reals_from + _SMC_REALS
    integers = fixed_columns(first[_SMC_TEXT:reals_from], 10)
    reals = fixed_columns(first[reals_from:samples_from], 15)
    try:
        comments, samples = int(integers[_SMC_COMMENTS]), int(integers[_SMC_SAMPLES])
        rate = float(reals[_SMC_RATE])
    except (IndexError, ValueError) as error:
        counts = "the numbers of comments and samples, the 16th and 17th integer below line 11"
        raise ValueError(
            f"{name}: its header must have {counts}, and the samples a second, the second number of line 18"
        ) from error
    step = 1.0 / rate if rate else INFINITY
    return Header(samples_from + max(comments, 0), samples, step, "cm/s2", width=10)


def fixed_columns(rows: list[str], width: int) -> list[str]:
    """The fields of rows of fixed width, which need no blanks between them; a row ends with its last character."""
    plain = [row.rstrip() for row in rows]
    return [row[k : k + width].strip() for row in plain for k in range(0, len(row), width)]


def header_of(name: str, first: list[str]) -> tuple[str, Header] | None:
    """The kind of a file and its header, by its first lines; None of a table.

    Raises
    ------
    ValueError
        Where the header is damaged, or of what is no acceleration.
    """
    kinds = {
        "an AT2 file": _at2,
        "an ESM file": _esm,
        "a K-NET file": _knet,
        "a COSMOS file": _cosmos,
        "a CSMIP file": _csmip,
        "an SMC file": _smc,
    }
    for kind, read in kinds.items():
        header = read(name, first)
        if header is None:
            continue
        unit = unit_of(header.units) if header.units else ""
        if unit is None:
            choice = f"must be one of {ACCELERATION.choice}"
            raise ValueError(f"{name}: its header says the unit {header.units!r}: {choice}")
        is_step = 0.0 < header.step < INFINITY
        if header.samples < 1 or not is_step:
            told = f"{header.samples} samples with a step of {header.step:g} s"
            raise ValueError(f"{name}: its header says {told}: must be one at least, and a positive time")
        return kind, header._replace(units=unit)
    return None


_CHANNEL = re.compile(r"^[ \t]*corrected accel", re.IGNORECASE | re.MULTILINE)
_ORIENTATION = re.compile(r"\bchan\w*\s*\d+:\s*(\d+(?=\s*deg)|[a-z]\w*)", re.IGNORECASE)


def channels(text: str) -> list[tuple[str, str]]:
    """The channels of a file of COSMOS or CSMIP, each with its orientation or number; others are one channel."""
    starts = [start.start() for start in _CHANNEL.finditer(text)]
    if len(starts) < 2:
        return [("", text)]
    parts = [text[start:end] for start, end in pairwise([*starts, len(text)])]
    orientations = (_ORIENTATION.search(part[:2000]) for part in parts)
    names = [match[1].upper() if match else str(k) for k, match in enumerate(orientations, 1)]
    return list(zip(names, parts, strict=True))
