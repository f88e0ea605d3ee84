"""The price list in words: a table and a verdict for people, records and CSV for machines."""

import math
import textwrap
from collections.abc import Iterator, Mapping, Sequence
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
MANY_ULP = 1e3  # from which errors are not said in ulp
RECORDED = tuple(field.name for field in fields(Row) if field.name != "profile")


def parts(rows: Sequence[Row], machine: str) -> Iterator[Part | str]:
    """The table and the verdict of each function, and what the columns mean."""
    for name in dict.fromkeys(row.function for row in rows):
        of_function = [row for row in rows if row.function == name]
        yield Part(*table(of_function), name)
        yield verdict(of_function) + "\n"
    yield _wrapped([*NOTES, f"{machine}."])


def _wrapped(lines: Sequence[str]) -> str:
    """Lines, folded to the width of the tables."""
    return "\n".join(textwrap.fill(line, WIDTH, subsequent_indent="  ") for line in lines)


# --- verdicts ------------------------------------------------------------------------------------------------------


def verdict(rows: Sequence[Row]) -> str:
    """Sentences about the rows of one function, wins and losses alike."""
    rows = [row for row in rows if not math.isnan(row.error)]
    ours = [row for row in rows if row.ours]
    others = [row for row in rows if not row.ours]
    broken = [row.way for row in rows if _above_bound(row)]
    frontier = [row for row in rows if row.verdict == FRONTIER]
    frontier.sort(key=lambda row: row.error)
    best = [f"{row.way} ({row.error:.1e}, {time_text(row.price)})" for row in frontier]
    lines = []
    if broken:
        names = ", ".join(broken)
        lines.append(f"Seen above what is proved, so the proof or the build is wrong: {names}.")
    lines.append(f"Frontier: {'; '.join(best)}.")
    if ours and others:
        lines += [_losses(ours, rows), *_faster(ours, others)]
    return _wrapped(lines)


def _above_bound(row: Row) -> bool:
    """Whether a row is less accurate than what is proved of it."""
    ulp = row.ulp or 0.0
    if row.profile is not None:
        proved_there = row.profile.points >= UNDERFLOW
        errors = np.abs(row.profile.ulp[proved_there])
        ulp = float(np.max(errors, initial=0.0))
    bound = row.bound or math.inf
    bound_ulp = row.bound_ulp or math.inf
    return row.error > bound or ulp > bound_ulp


def _losses(ours: Sequence[Row], rows: Sequence[Row]) -> str:
    """Which of ours is beaten, and by whom."""
    by_name = {row.way: row for row in rows}
    losses = []
    for row in ours:
        if row.verdict.startswith(LOST):
            winner = by_name[row.verdict.removeprefix(LOST)]
            ratio = shown(row.price / winner.price, 2)
            losses.append(f"{row.way} to {winner.way} ({ratio} times slower)")
    if not losses:
        return "None of ours is beaten."
    return f"Of ours, these lose: {'; '.join(losses)}."


def _faster(ours: Sequence[Row], others: Sequence[Row]) -> Iterator[str]:
    """Which other way is faster than anything of ours, however wrong, and at which sizes."""
    gains: dict[Row, list[str]] = {}
    for label, size in zip(COLUMNS[6:9], TIMES, strict=True):
        our_best = min(_time(row, size) for row in ours)
        fastest = min(others, key=lambda row: _time(row, size))
        gain = our_best / _time(fastest, size)
        if gain > BEATEN:
            words = f"{shown(gain, 2)} times at {label}"
            gains.setdefault(fastest, []).append(words)
    for row, sizes in gains.items():
        where = ", ".join(sizes)
        yield f"Faster than anything of ours: {row.way}, {where}, with an error of {row.error:.1e}."


def _time(row: Row, size: str) -> float:
    """The time at a size, infinite where it was not measured."""
    return getattr(row, size) or math.inf


# --- tables --------------------------------------------------------------------------------------------------------


def table(rows: Sequence[Row]) -> tuple[list[str], list[list[str]]]:
    """Head and rows of one function as text, without empty columns; whoever beats a row is named by number."""
    numbers = {row.way: str(number) for number, row in enumerate(rows, 1)}
    texts = [_cells(row, numbers) for row in rows]
    filled = [any(column) for column in zip(*texts, strict=True)]
    head = list(compress(COLUMNS, filled))
    body = [list(compress(cells, filled)) for cells in texts]
    return head, body


def _cells(row: Row, numbers: Mapping[str, str]) -> list[str]:
    """A cell for each of `COLUMNS`."""
    other = row.verdict.removeprefix(LOST)
    winner = numbers.get(other)
    verdict = f"beaten {winner}" if winner else row.verdict
    seen = "" if math.isnan(row.error) else f"{row.error:.1e}"
    place = ", ".join(map(_place, row.worst_input_ulp))
    errors = [_proved(row), seen, _ulp(row), place]
    memory = "" if row.memory is None else f"{row.memory / 1e6:.3g} MB"
    return [numbers[row.way], row.way, *errors, *_times(row), memory, verdict]


def _ulp(row: Row) -> str:
    """The worst error in ulp, where it is known."""
    if row.ulp is None:
        return ""
    if row.ulp < MANY_ULP:
        return shown(row.ulp, 3)
    return f"{row.ulp:.0e}".replace("+", "")


def _place(value: float) -> str:
    """An argument, in few digits."""
    is_tiny = 0 < value < 1e-4
    return f"{value:.0e}" if is_tiny else f"{value:.2g}"


def _proved(row: Row) -> str:
    """The proved bound, in ulp where that is said in few."""
    if math.isnan(row.error):
        return ""
    if row.bound_ulp is not None and row.bound_ulp < MANY_ULP:
        return f"{row.bound_ulp:.3g} ulp"
    return "sampled only" if row.bound is None else f"{row.bound:.3g}"


def _times(row: Row) -> list[str]:
    """Times at each size; the last one is marked where it was measured on fewer elements."""
    times = [getattr(row, key) for key in TIMES]
    texts = ["" if time is None else time_text(time) for time in times]
    last = max(k for k, text in enumerate(texts) if text)
    if row.elements < SIZES[last]:
        texts[last] = f"~{texts[last]}"
    return texts


# --- for machines --------------------------------------------------------------------------------------------------


def record(row: Row) -> dict[str, Any]:
    """A row for JSON and CSV, in full precision; None for what is infinite, unknown, or was not measured."""
    return {name: plain(getattr(row, name)) for name in RECORDED}


def table_csv(rows: Sequence[Row]) -> bytes:
    """All rows as a table for machines."""
    lines = []
    for row in rows:
        values = record(row).values()
        lines.append([" ".join(map(repr, value)) if isinstance(value, list) else value for value in values])
    return files.table(RECORDED, lines)
