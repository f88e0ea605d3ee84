"""Small record files in the layouts of networks and programs, written from one motion.

The layouts follow manuals and public files; the numbers are made up.
"""

import re
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from slipcircle.tables import Series
from slipcircle.workbench.common.units import PORE_PRESSURE
from slipcircle.workbench.records.recordfiles import Options
from slipcircle.workbench.records.records import pressure_of, read_record_samples

STEP, COUNT = 0.02, 60
TIME: Any = STEP * np.arange(COUNT)
_RAW = np.sin(23.0 * TIME) * np.exp(-3.0 * TIME)
_RAW -= np.mean(_RAW)  # as K-NET's counts are freed of theirs
NORTH: Any = 0.3 * _RAW / np.max(np.abs(_RAW))  # g; the other components are shares of it
EAST: Any = 0.5 * NORTH
UP: Any = 0.25 * NORTH
GAL = 981.0


def rows(*columns: Iterable[Any], form: str = "%.9g", separator: str = ",") -> str:
    """Lines of numbers."""
    return "".join(separator.join(form % x for x in row) + "\n" for row in zip(*columns, strict=True))


def packed(values: Sequence[float], form: str, per_line: int) -> str:
    """Lines of so many fields of fixed width."""
    fields = [form % value for value in values]
    return "".join("".join(fields[k : k + per_line]) + "\n" for k in range(0, len(fields), per_line))


def of_three(*factors: float) -> list[Any]:
    """Return the three components in another order or unit: by their shares of the first."""
    return [factor * NORTH for factor in factors]


def at2(component: str = "090", kind: str = "ACCELERATION", unit: str = "G", factor: float = 1.0) -> str:
    head = f"PEER NGA STRONG MOTION DATABASE RECORD\nNowhere, 1/1/1999, Station Zero, {component}\n"
    head += f"{kind} TIME SERIES IN UNITS OF {unit}\nNPTS=  {COUNT}, DT=   .0200 SEC,\n"
    return head + packed(factor * NORTH, "%15.7E", 5)


def smc(kind: str = "2 CORRECTED ACCELEROGRAM", component: str = "225", factor: float = 1.0) -> str:
    integers = [-32768] * 15 + [1, COUNT] + [-32768] * 31
    reals = [1.7e38, 50.0] + [1.7e38] * 48
    text = [kind, "*", "ABC", "1989", "Mw", f"station = Nowhere   component= {component}", *["*"] * 5]
    numbers = packed(integers, "%10d", 8) + packed(reals, "%15.7E", 5)
    return "\n".join(text) + "\n" + numbers + "|a comment\n" + packed(factor * GAL * NORTH, "%10.5f", 8)


def cosmos(
    units: str = "cm/sec2(04)", factor: float = GAL, title: str = "Corrected", channel: str = "1: 90 deg"
) -> str:
    head = [f"{title} acceleration  (Format v01.20 with 13 text lines)", *(f"text {k}" for k in range(2, 9))]
    head += [f"Sta Chan   {channel} (Rcrdr Chan  1) Location:", *(f"text {k}" for k in range(10, 14))]
    numbers = " 100 Integer-header values follow on  10 lines, Format= (10I8)\n" + packed([-999] * 100, "%8d", 10)
    numbers += " 100 Real-header values follow on  17 lines, Format= (6F13.6)\n"
    numbers += packed([-999.0] * 61 + [20.0] + [-999.0] * 38, "%13.6f", 6)
    data = f"   1 Comment line(s) follow, each starting with a |:\n| no\n   {COUNT} acceleration pts, approx   1 secs, "
    data += f"units={units},Format=(8F10.5)\n" + packed(factor * NORTH, "%10.5f", 8)
    return "\n".join(head) + "\n" + numbers + data + "End-of-data for Chan  1 acceleration\n"


def csmip(unit: str = "in cm/sec2. (8f10.5)", factor: float = 1.0) -> str:
    parts = []
    for k, (name, share) in enumerate((("90 Deg", 1.0), (" Up", 0.25), ("360 Deg", 0.5)), 1):
        head = f"Corrected accelerogram   12345-L1234-00000.00       Chan  {k}: {name}     from\n"
        head += "Uncorrected Accelerogram Data             Processed: 01/01/99\n" + packed([0] * 100, "%5d", 16)
        data = f" {COUNT} points of accel data equally spaced at  .020 sec, {unit}\n"
        data += packed(factor * share * GAL * NORTH, "%10.5f", 8)
        other = f" {COUNT} points of veloc data equally spaced at  .020 sec, in cm/sec.  (8f10.7)\n"
        parts.append(head + data + other + packed(NORTH, "%10.7f", 8) + f"/&  --- End of data for channel  {k} ---\n")
    return "".join(parts)


def geonet(title: str = "Corrected") -> str:
    parts = []
    for name, share in (("N10E", 1.0), ("N80W", 0.5), ("Up", 0.25)):
        head = [f"{title} accelerogram 20161113_110256_ABCD_20 GNS Science", *("text" for _ in range(11))]
        head += [f"Component {name}", "Acceleration:  peak   294.3 mm/s/s at  1.0 sec", "Velocity:", "Displacement:"]
        integers = [0] * 33 + [COUNT] * 3 + [0] * 4
        reals = [0.0] * 25 + [STEP] + [0.0] * 34
        numbers = packed(integers, "%8d", 10) + packed(reals, "%8.4f", 10)
        data = packed(share * 9810.0 * NORTH, "%8.1f", 10) + 2 * packed(NORTH, "%8.3f", 10)
        parts.append("\n".join(head) + "\n" + numbers + data)
    return "".join(parts)


def knet(direction: str = "N-S") -> str:
    head = "Origin Time       2018/01/24 19:51:00\nStation Code      ABC001\nSampling Freq(Hz) 50Hz\n"
    head += f"Duration Time(s)  1.2\nDir.              {direction}\nScale Factor      2000(gal)/8388608\nMemo.\n"
    return head + packed(np.round(GAL * NORTH * 8388608 / 2000 + 500).astype(int).tolist(), "%9d", 8)


def trace(kind: str = "SLIST", channel: str = "HNN", unit: str = "M/S**2") -> str:
    head = f"TIMESERIES NZ_ABC_20_{channel}_D, {COUNT} samples, 50 sps, 2020-01-01T00:00:00.000000, {kind}, FLOAT, "
    head += f"{unit}\n"
    values = 9.81 * NORTH
    if kind == "SLIST":
        return head + "\n".join("\t".join(f"{x:.9g}" for x in values[k : k + 6]) for k in range(0, COUNT, 6)) + "\n"
    return head + "".join(f"2020-01-01T00:00:{t:09.6f}  {x:.9g}\n" for t, x in zip(TIME, values, strict=True))


def esm(stream: str = "HNE", kind: str = "ACCELERATION") -> str:
    head = f"EVENT_NAME: NOWHERE\nSAMPLING_INTERVAL_S: 0.020000\nNDATA: {COUNT}\nSTREAM: {stream}\nUNITS: cm/s^2\n"
    return head + f"HEADER_FORMAT: DYNA 1.2\nDATA_TYPE: {kind}\nUSER5:\n" + rows(GAL * NORTH)


_AFAD = f"STRONG GROUND MOTION RECORDS OF TURKIYE\nNUMBER OF DATA          : {COUNT}\nSAMPLING INTERVAL (sec) : 0.02\n"
_AFAD += "RAW PGA VALUES (gal)    : (N-S) 290 (E-W) 150 (U-D) 70\n       N-S          E-W          U-D\n"
_JMA = "SITE CODE= ABC,37.5,137.2,16,7.6\n LAT.= 37.0\n SAMPLING RATE= 50Hz\n UNIT  = gal(cm/s/s)\n"
_JMA += "INITIAL TIME = 2024 01 01 16 10 00\nNS,EW,UD\n"
_CWA = (
    "#StationCode: ABC\n#SampleRate(Hz): 50\n#AmplitudeUnit:  gal. DCoffset(corr)\n#AmplitudeMAX. U:    1.1~   -1.0\n"
)
_CWA += "#DataSequence: Time U(+); N(+); E(+)\n#Data: 4F10.3\n"
_UNAM = "==\nARCHIVO ESTANDAR DE ACELERACION\nUNIDADES DE LOS DATOS : gal\n"
_UNAM += "INTERVALO DE MUESTREO, C1-C6 (s) : /0.02/0.02/0.02\n"
_UNAM += (
    f"NUM. TOTAL DE MUESTRAS, C1-C6 : /{COUNT}/{COUNT}/{COUNT}\nORIENTACION C1-C6 (rumbo;orientacion) : /N00E/+V/N90W\n"
)
_UNAM += " CANAL-1 CANAL-2 CANAL-3\n ------- -------\n"
_BLANKS: dict[str, str] = {"form": "%12.5f", "separator": " "}

_SHORT = re.sub(r"E([+-])0", r"E\1", packed(GAL * NORTH, "%11.4E", 8))

FILES: dict[str, tuple[str, dict[str, float]]] = {  # text, and peaks of the components in g, those of verticals below 0
    "AT2": (at2(), {"090": 0.3}),
    "AT2 up": (at2("UP"), {"UP": -0.3}),
    "SMC": (smc(), {"225": 0.3}),
    "SMC, short exponents": (smc().partition("|")[0] + "|a comment\n" + _SHORT, {"225": 0.3}),
    "SMC up": (smc(component="up"), {"UP": -0.3}),
    "COSMOS": (cosmos(), {"90": 0.3}),
    "COSMOS in g.": (cosmos("g.", 1.0), {"90": 0.3}),
    "COSMOS up": (cosmos(channel="3: Up"), {"UP": -0.3}),
    "CSMIP": (csmip(), {"90": 0.3, "UP": -0.075, "360": 0.15}),
    "CSMIP of 1983": (csmip("(UNITS: CM/SEC/SEC)"), {"90": 0.3, "UP": -0.075, "360": 0.15}),
    "GeoNet": (geonet(), {"N10E": 0.3, "N80W": 0.15, "UP": -0.075}),
    "K-NET": (knet(), {"NS": 0.3}),
    "KiK-net, up": (knet("6"), {"UD2": -0.3}),
    "SLIST": (trace(), {"HNN": 0.3}),
    "TSPAIR": (trace("TSPAIR", "HNZ"), {"HNZ": -0.3}),
    "ESM": (esm(), {"HNE": 0.3}),
    "ESM, vertical": (esm("HNZ"), {"HNZ": -0.3}),
    "AFAD": (_AFAD + rows(*of_three(GAL, GAL / 2, GAL / 4), **_BLANKS), {"N-S": 0.3, "E-W": 0.15, "U-D": -0.075}),
    "JMA": (_JMA + rows(*of_three(GAL, GAL / 2, GAL / 4)), {"NS": 0.3, "EW": 0.15, "UD": -0.075}),
    "CWA": (_CWA + rows(TIME, *of_three(GAL / 4, GAL, GAL / 2), form="%10.3f", separator=""),
            {"U": -0.075, "N": 0.3, "E": 0.15}),
    "UNAM": (_UNAM + rows(*of_three(GAL, GAL / 4, GAL / 2), **_BLANKS), {"N00E": 0.3, "+V": -0.075, "N90W": 0.15}),
}  # fmt: skip


def read_pore_pressure(path: Path, **options: Any) -> dict[str, Series]:
    """Return the pore pressures of a file as parameters of the effect, as a scene file reads them."""
    samples, _ = read_record_samples(PORE_PRESSURE, path, Options(**options))
    return pressure_of(samples, str(path))
