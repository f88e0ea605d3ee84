"""The price list in words: a table and a verdict for people, records and CSV for machines."""

import textwrap
from collections.abc import Iterator, Sequence
from dataclasses import fields
from itertools import compress
from typing import Any

import numpy as np

from slipcircle.base.text import shown
from slipcircle.workbench.common import files
from slipcircle.workbench.common.quantities import plain, time_text
from slipcircle.workbench.cost.cost import BEATEN, FRONTIER, LOST, REPEATS, SIZES, TIMES, Row
from slipcircle.workbench.outputs.tables import WIDTH, Part

NOTES = (
    "proved: bound over the whole domain, rounding included. seen: worst relative error; ulp: worst error in units of "
    "the last place of the row's format; at: where.",
    f"N=: processor time of an element or a scene, the median of up to {REPEATS} turns, into a given array where the "
    "way can; ~ on fewer elements. What heyoka takes to compile is left out.",
    "memory: the most that the last of these took of Python and NumPy, its result included; shapely's own is not seen.",
    f"beaten: by the way of that number, at least as accurate and over {BEATEN} times faster at N=1e4.",
    "no digit: an error of 1 or more somewhere; returning 0 is as accurate.",
)
UNDERFLOW = 2.0**-320  # below it results underflow, and another bound holds (`bound_underflow` of the certificates)
COLUMNS = ("#", "way", "proved", "seen", "ulp", "at", "N=1", "N=1e4", "N=1e6", "memory", "verdict")


def _ulp(row: Row) -> float:
    """The worst error in ulp seen where the bound speaks of it."""
    if row.profile is None:
        return row.ulp or 0.0
    return float(np.max(np.abs(row.profile.ulp[row.profile.points >= UNDERFLOW]), initial=0.0))


def parts(rows: Sequence[Row], machine: str) -> Iterator[Part | str]:
    """The table and the verdict of each function, and what the columns mean."""
    for name in dict.fromkeys(row.function for row in rows):
        of = [row for row in rows if row.function == name]
        yield Part(*table(of), name)
        yield verdict(of) + "\n"
    yield _wrapped([*NOTES, f"{machine}."])


def verdict(rows: Sequence[Row]) -> str:
    """What the rows of one function say, wins and losses alike."""
    rows = [r for r in rows if r.error == r.error]
    ours, others = [r for r in rows if r.ours], [r for r in rows if not r.ours]
    front = sorted((r for r in rows if r.verdict == FRONTIER), key=lambda r: r.error)
    by = {r.way: r for r in rows}
    broken = [r.way for r in rows if r.error > (r.bound or np.inf) or _ulp(r) > (r.bound_ulp or np.inf)]
    lines = [f"Seen above what is proved, so the proof or the build is wrong: {', '.join(broken)}."] if broken else []
    lines.append("Frontier: " + "; ".join(f"{r.way} ({short(r.error)}, {time_text(r.price)})" for r in front) + ".")
    if ours and others:
        beaten = [(r, by[r.verdict.removeprefix(LOST)]) for r in ours if r.verdict.startswith(LOST)]
        lost = [f"{r.way} to {winner.way} ({shown(r.price / winner.price, 2)} times slower)" for r, winner in beaten]
        lines.append(f"Of ours, these lose: {'; '.join(lost)}." if lost else "None of ours is beaten.")
        lines += _faster(ours, others)
    return _wrapped(lines)


def _faster(ours: Sequence[Row], others: Sequence[Row]) -> Iterator[str]:
    """Which other way is faster than anything of ours, however wrong, and at which sizes."""
    gains: dict[str, list[str]] = {}
    for label, key in zip(COLUMNS[6:9], TIMES, strict=True):
        (mine, _), (theirs, way) = (min((getattr(r, key) or np.inf, r.way) for r in some) for some in (ours, others))
        if theirs * BEATEN < mine:
            gains.setdefault(way, []).append(f"{shown(mine / theirs, 2)} times at {label}")
    error = {r.way: short(r.error) for r in others}
    for way, sizes in gains.items():
        yield f"Faster than anything of ours: {way}, {', '.join(sizes)}, with an error of {error[way]}."


def _wrapped(lines: Sequence[str]) -> str:
    """Lines, folded to the width of the tables."""
    return "\n".join(textwrap.fill(line, WIDTH, subsequent_indent="  ") for line in lines)


def short(x: float, digits: int = 2) -> str:
    """A few digits, in as few characters as they take: 7.7e-17."""
    mantissa, _, exponent = f"{x:.{digits - 1}e}".partition("e")
    return f"{mantissa}e{int(exponent)}" if int(exponent or 0) else mantissa


def _at(values: Sequence[float]) -> str:
    """An input: two digits of each number, one where the exponent takes three."""
    return ", ".join(f"{x:.2g}" if x == 0 or 1e-4 < x < 100 else short(x, 1 if x < 1e-99 else 2) for x in values)


def _proved(row: Row) -> str:
    if row.error != row.error:
        return ""
    if row.bound_ulp is not None and row.bound_ulp < 1e3:
        return f"{row.bound_ulp:.3g} ulp"
    return "sampled only" if row.bound is None else f"{row.bound:.3g}"


def table(rows: Sequence[Row]) -> tuple[list[str], list[list[str]]]:
    """Head and rows of one function as text, without empty columns; whoever beats a row is named by number."""
    place = {row.way: str(i) for i, row in enumerate(rows, 1)}
    found = []
    for row in rows:
        times = [getattr(row, key) for key in TIMES]
        cells = ["" if time is None else time_text(time) for time in times]
        last = max(k for k, time in enumerate(times) if time is not None)
        cells[last] = "~" * (row.elements < SIZES[last]) + cells[last]
        ulp = "" if row.ulp is None else shown(row.ulp, 3) if row.ulp < 1e3 else short(row.ulp, 1)
        winner = place.get(row.verdict.removeprefix(LOST))
        found.append(
            [
                place[row.way],
                row.way,
                _proved(row),
                short(row.error) if row.error == row.error else "",
                ulp,
                _at(row.worst_input_ulp),
                *cells,
                "" if row.memory is None else f"{row.memory / 1e6:.3g} MB",
                f"beaten {winner}" if winner else row.verdict,
            ]
        )
    filled = [any(column) for column in zip(*found, strict=True)]
    return list(compress(COLUMNS, filled)), [list(compress(texts, filled)) for texts in found]


def record(row: Row) -> dict[str, Any]:
    """A row for JSON and CSV, in full precision; None for what is infinite, unknown, or was not measured."""
    return {f.name: plain(getattr(row, f.name)) for f in fields(row) if f.name != "profile"}


def table_csv(rows: Sequence[Row]) -> bytes:
    """All rows as a table for machines."""
    records = [record(row) for row in rows]
    cells = ([" ".join(map(repr, v)) if isinstance(v, list) else v for v in r.values()] for r in records)
    return files.table([f.name for f in fields(Row) if f.name != "profile"], cells)
