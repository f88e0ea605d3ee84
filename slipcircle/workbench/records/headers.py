"""Headers of record formats, each described by a regular expression: AT2, K-NET, COSMOS, CSMIP, GeoNet, SMC, traces."""

import re
from collections import defaultdict
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

from slipcircle.base.arrays import INFINITY
from slipcircle.base.kinds import TextDict
from slipcircle.workbench.records.columns import is_direction


class Header(NamedTuple):
    """Contents of a header. ``fields`` contains further statements of the format."""

    lines: int
    samples: int
    step: float  # s between them
    units: str
    component: str
    scale: float  # acceleration per count about the mean, or 0
    fields: TextDict


class Format(NamedTuple):
    """Record format: expressions that recognise and read its header, the required statements, and the default unit."""

    mark: str
    header: str
    needs: str
    units: str = "cm/s2"


_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[ED][-+]?\d+)?"
_ANY = r"[\s\S]*?"
_CHANNEL = rf"(?:{_ANY}\bchan\w*\s*\d+:\s*(?P<component>\d+(?=\s*deg)|[a-z]\w*))?"
_FORMATS = {
    # PEER: "NPTS= 5590, DT= .0050 SEC", formerly "5590 .0050 NPTS, DT"; the component ends the first line of text
    "an AT2 file": Format(
        r"NPTS.*\bDT\b",
        rf"(?:.*\n){{0,9}}?(?:(?!.*NPTS).*,\s*(?P<component>[^,(\n]*?)\s*(?:\(.*)?\n)?"
        r"(?:.*UNITS OF\s+(?P<units>[^\s,]+).*\n)?"
        rf"(?=.*NPTS)(?:.*NPTS\s*=)?\s*(?P<samples>{_NUMBER})[\s,]+(?:DT\s*=)?\s*(?P<step>{_NUMBER}).*\n",
        "NPTS and DT, as in 'NPTS= 4000, DT= .0050 SEC'",
        "g",
    ),
    # K-NET and KiK-net: keys and values, then counts about the instrument's offset, their mean
    "a K-NET file": Format(
        r"^Scale Factor",
        rf"{_ANY}Sampling Freq\(Hz\)\s*(?P<rate>{_NUMBER}){_ANY}Duration Time\(s\)\s*(?P<seconds>{_NUMBER}){_ANY}"
        rf"(?:Dir\.\s*(?P<component>\S+){_ANY})?Scale Factor\s*(?P<gal>{_NUMBER})\s*\(gal\)\s*/\s*"
        rf"(?P<counts>{_NUMBER}){_ANY}\nMemo.*\n",
        "Sampling Freq(Hz), Duration Time(s), Scale Factor as in 3920(gal)/6182761, and Memo.",
    ),
    # COSMOS 1.20: the step is the 62nd real in ms (the recorder's is the 34th in s), checked by the whole seconds
    "a COSMOS file": Format(
        r"\d\s+acceleration\s+(?:data\s+)?(?:pts|points)\b",
        rf"{_CHANNEL}{_ANY}Real-header values.*\n\s*(?:\S+\s+){{33}}(?P<step>\S+)\s+(?:\S+\s+){{27}}(?P<ms>\S+)"
        rf"(?:{_ANY}<SCNL>[^.\n]*\.(?P<seed>\w+))?{_ANY}(?P<samples>\d+)\s+acceleration\s+(?:data\s+)?(?:pts|points)\b"
        r".*?approx\s+(?P<seconds>[\d.]+)\s+secs.*?units\s*=\s*(?P<units>[^\s(),]+).*?Format\s*=\s*\(\s*\d*[A-Z]+"
        r"(?P<width>\d+).*\n",
        "samples, seconds, units and Format, and their step as the 62nd real, in ms, or the 34th, in s",
    ),
    # CSMIP volume 2 (Shakal and Huang 1985)
    "a CSMIP file": Format(
        r"points of accel data equally spaced",
        rf"{_CHANNEL}{_ANY}\n\s*(?P<samples>\d+)\s+points of accel data equally spaced at\s*"
        r"(?P<step>[\d.]+)\s*sec[,.\s]*"
        r"(?:\(units:|in)?\s*(?P<units>[^\s,()]+)?(?:.*\(\s*\d*f(?P<width>\d+))?.*\n",
        "'points of accel data equally spaced at'",
    ),
    # GeoNet volume 2: 16 lines of text, 4 of integers, 6 of reals; acceleration, velocity and displacement
    "a GeoNet file": Format(
        r"\A\s*corrected accelerogram.*GNS",
        r"\s*.*\n(?:.*\n){11}Component\s+(?P<component>\w+).*\n(?:.*\n){6}.{24}(?P<samples>.{8}).*\n(?:.*\n){2}.{40}"
        r"(?P<step>.{8}).*\n(?:.*\n){3}(?P<block>)",
        "the number of samples as the 4th of line 20, and their step as the 6th of line 23",
        "mm/s2",
    ),
    # SMC of the U.S. Geological Survey: text, integers (8I10), reals (5E15.7), comments, samples
    "an SMC file": Format(
        r"\A\s*[1-6] CORRECTED\b",
        r"\s*.*\n(?:(?:.*component\s*=\s*(?P<component>[\w-]+).*|.*)\n){10}.*\n.{70}(?P<comments>.{10}).*\n"
        r"(?P<samples>.{10}).*\n(?:.*\n){3}.{15}(?P<rate>.{15}).*\n(?:.*\n){9}(?P<width>)",
        "the numbers of comments and samples, the 16th and 17th integer below line 11, and the samples a second",
    ),
    # SLIST and TSPAIR, to which miniSEED is converted
    "a trace": Format(
        r"\ATIMESERIES ",
        r"TIMESERIES (?:\S*_)?(?P<component>[A-Z]{2}\w)(?:_\w*)?, (?P<samples>\d+) samples, (?P<rate>[\d.]+) sps, "
        r".*(?:SLIST|(?P<pair>TSPAIR)), \w+, (?P<units>.*)\n",
        "samples, samples a second, SLIST or TSPAIR, and the unit",
    ),
}
_CORRECTED = "take the file of corrected accelerations (volume 2)"
_REFUSED = {  # by the first lines
    r"\A\W*raw accel": f"holds raw counts (volume 0): {_CORRECTED}",
    r"\A\W*(?:\d )?(?:.* of )?uncorrected accel|\A\* ?vol1": f"holds uncorrected motion (volume 1): {_CORRECTED}",
    r"\A\W*\d? ?(?:corrected (?:veloc|displ)|(?:velocity|displacement) *\n)": f"holds no acceleration: {_CORRECTED}",
    r"(?:veloc|displ)\w* time (?:series|hist)": f"holds no acceleration: {_CORRECTED}",
    r"^DATA_TYPE\s*:(?!\s*ACCELERATION\s*$).*": "holds no acceleration: take the record's file of accelerations",
    r"\A\W*(?:\d )?(?:response|fourier)\b|\A[^,;\t\n]*\bspectr(?:um|a)\b": "holds a spectrum: take the accelerations",
}
_KIK_NET = dict(zip("123456", ("NS1", "EW1", "UD1", "NS2", "EW2", "UD2"), strict=True))


def header_of(name: str, text: str) -> Header | None:
    """Return the header at the beginning of a file in a known format; None for a table.

    `name` is the name of the file for messages, and `text` its content.

    Raises
    ------
    ValueError
        If the header is damaged, or the file contains anything but corrected accelerations.
    """
    head = text[:20000]
    for words, reason in _REFUSED.items():
        if refused := re.search(words, head[:4000].lstrip(), re.IGNORECASE | re.MULTILINE):
            raise ValueError(f"{name}: {refused[0].strip()!r}: {reason}")
    for kind, form in _FORMATS.items():
        if re.search(form.mark, head, re.IGNORECASE | re.MULTILINE):
            header = _header(re.match(form.header, head, re.IGNORECASE), form.units)
            if header is None:
                raise ValueError(f"{name}: the header of {kind} must have {form.needs}")
            return header
    return None


def _header(match: re.Match[str] | None, units: str) -> Header | None:
    """Return the header of a format from the fields of its expression, or None without samples and step.

    `match` is the match of the expression, and `units` the default unit.
    """
    fields = {key: text.strip() for key, text in match.groupdict("").items()} if match else {}
    numbers = defaultdict(float)
    for key, text in fields.items():
        if re.fullmatch(_NUMBER, text, re.IGNORECASE):
            numbers[key] = float(text.upper().replace("D", "E"))
    seconds = numbers["seconds"]
    samples = round(min(numbers["samples"] or numbers["rate"] * seconds, 1e9))
    steps = numbers["ms"] / 1e3, numbers["step"], 1.0 / (numbers["rate"] or INFINITY)
    fitting = (
        s for s in steps if 0.0 < s < 1e9 and (not seconds or abs(samples * s - seconds) <= 1.0 + 0.02 * seconds)
    )
    step = next(fitting, 0.0)
    if match is None or samples < 1 or not step:
        return None
    components = (fields.get(key, "").upper().replace("-", "") for key in ("component", "seed"))
    component = next((_KIK_NET.get(text, text) for text in components if text and is_direction(text)), "")
    lines = match[0].count("\n") + max(round(numbers["comments"]), 0)
    scale = numbers["gal"] / (numbers["counts"] or INFINITY)
    return Header(lines, samples, step, fields.get("units") or units, component, scale, fields)


def channels(text: str) -> Iterator[str]:
    """Yield the texts of the channels of a file of COSMOS, CSMIP, GeoNet or traces.

    Any other file is a single channel.
    """
    title = r"^(?:[ \t]*(?:corrected|uncorrected|raw) (?:accel|veloc|displ)|TIMESERIES )"
    starts = [start.start() for start in re.finditer(title, text, re.IGNORECASE | re.MULTILINE)]
    starts = [k for last, k in pairwise([-1, *starts]) if last < 0 or text.count("\n", last, k) > 1]
    if not starts or text[: starts[0]].strip():
        starts = [0]
    ends = [*starts, len(text)]
    return (text[start:end] for start, end in pairwise(ends))
