"""Printed output of commands: tables of motions, slopes, plans, ladders and derivatives, without other libraries."""

import math
import os
import shutil
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import chain, zip_longest
from textwrap import wrap
from types import MappingProxyType
from typing import Any, NamedTuple

from slipcircle.base.kinds import TextDict, TextMap
from slipcircle.base.progress import is_terminal
from slipcircle.base.text import DIGITS, amount_text, clean, drawn_unit, number_text, output_unit
from slipcircle.core import Motion, Plan
from slipcircle.ground import Section
from slipcircle.messages import VelocityTimes
from slipcircle.workbench.common.quantities import (
    OUTCOMES,
    factor_label,
    factor_text,
    factors_of,
    results,
    spelt_out,
    time_text,
    to_error,
)
from slipcircle.workbench.common.starting import starts
from slipcircle.workbench.common.summary import end_words, key_results
from slipcircle.workbench.common.trace import toe_words
from slipcircle.workbench.cost.ladder import Rung
from slipcircle.workbench.files.loaded import stability_of
from slipcircle.workbench.outputs.json_records import foreland_words, stretch_records
from slipcircle.workbench.stability.critical import Critical
from slipcircle.workbench.stability.stability import Slope, least_of
from slipcircle.workbench.studies.statistics import BEYOND, Estimate, value_text

WIDTH = 100  # columns of a table in files and pipes
WIDEST = 120  # greatest number of columns of a table in a terminal
_LEAST = 22  # least width of a column of long cells
_GAP = 2  # between columns
BOLD = "\x1b[1;36m"  # head of a table in a terminal
PLAIN = "\x1b[0m"
Rows = Sequence[Sequence[Any]]  # not an iterator: a table may be shown more than once


class ResultTable(NamedTuple):
    """Table with its title and its note."""

    head: Sequence[str]
    rows: Rows
    title: str = ""
    note: str = ""


Files = Mapping[str, Callable[[str], bytes]]  # by option: function of a path that returns its content


class Answer(NamedTuple):
    """Result of a command: as JSON on request, otherwise as tables and texts, with warnings and files by options."""

    record: Callable[[], Any]
    parts: Iterable[ResultTable | str]
    warnings: Iterable[str] = ()
    files: Files = MappingProxyType({})


# --- motions ---------------------------------------------------------------------------------------------------------

COEFFICIENTS = {
    "Theta*": "moment_of_inertia",
    "J_r": "radial_weight",
    "J_theta": "weight_moment",
    "lambda": "resistance_factor",
    "A": "dynamic_coefficient",
}


# Titles of results after the key results; results that are not listed are of the toe and the centroid.
_GROUPS = {
    "Motion": "moves arrested slow_run_out run_out_time peak_time peak_displacement "
    "end_displacement end_rotation end_velocity",
    "Velocity": " ".join(["velocity_class", *(f"time_{name}" for name in VelocityTimes._fields)]),
    "Factors of safety": "residual_factor_of_safety final_factor_of_safety",
    "Strength and stress": "yield_coefficient friction limit_friction start_stress peak_stress end_stress",
    "Section": "area mass_per_metre chord depth entry exit centroid",
}
_TITLES = {name: title for title, names in _GROUPS.items() for name in names.split()}


def motion_groups(motion: Motion) -> dict[str, TextDict]:
    """Return all results of a motion as texts by label, in titled groups of at most ten, key results first."""
    plan, first = motion.plan, key_results(motion)
    groups: dict[str, TextDict] = {title: {} for title in _GROUPS}
    groups["Factors of safety"] = _factors_at_start(motion)
    for quantity in results(motion):
        title = _TITLES.get(quantity.name, "Toe and centroid")
        groups.setdefault(title, {})[quantity.label] = quantity.text(motion)
    groups["Motion"] |= end_words(motion)
    if plan.law != "constant":
        groups["Strength and stress"]["friction angle"] += f", {plan.law}"
    if height := toe_words(motion):
        groups["Toe and centroid"]["toe at the run-out"] = f"{height}: the method continues the circle there"
    if (critical := stability_of(plan.scene)) is not None:
        groups["Slip circle"] = _circle(critical)
        if critical.slope.surcharge and "shaking" in plan.scene.called:
            loads = "as in the motion, also for k_y: surcharges are shaken with the mass"
            groups["Strength and stress"]["loads at the start"] = loads
    groups["Section"] |= pond_row(plan.scene.arc)
    groups["Method"] = _method_rows(motion)
    others = {}
    for title, group in groups.items():
        if rest := {label: text for label, text in group.items() if text and label not in first}:
            others[title] = rest
    return {"": first} | others


def _method_rows(motion: Motion) -> TextDict:
    """Return effects, method of solution, numerical error and coefficients of the arc by label."""
    plan = motion.plan
    coefficients = plan.scene.arc.dimensionless
    return {
        "effects": ", ".join(plan.effects) or "none",
        "not included": ", ".join(plan.left_out) or "none",
        "method": plan.method,
        "estimated error": f"{motion.error_estimate:.1e}",
        **{symbol: f"{float(getattr(coefficients, name)):z.5f}" for symbol, name in COEFFICIENTS.items()},
    }


def _factors_at_start(motion: Motion) -> TextDict:
    """Return the factors of safety by every method, also under the k_h of a search, and the strength factor."""
    scene = motion.plan.scene
    critical = stability_of(scene)
    column = _factors(factors_of(motion))
    if critical is not None and critical.slope.k_h:
        column |= _factors(critical.factors_of_safety, critical.slope.k_h)
    if starts(motion):
        column["strength factor"] = number_text(float(scene.strength_factor))
    return column


def motion_parts(motions: Sequence[Motion], verbose: bool) -> Iterator[ResultTable]:
    """Yield tables of motions side by side: key results; if verbose, all results and the soils of each arc."""
    scenes = [motion.plan.scene for motion in motions]
    tabulated = [motion_groups(motion) if verbose else {"": key_results(motion)} for motion in motions]
    notes = [f"{scene.name}: {scene.note}" for scene in scenes if verbose and scene.note]
    for title in dict.fromkeys(chain.from_iterable(tabulated)):
        rows = beside([groups.get(title, {}) for groups in tabulated])
        ordered = sorted(rows, key=lambda row: not row[0].startswith("factor of safety by"))
        yield ResultTable([title, *(scene.name for scene in scenes)], ordered, note="" if title else "; ".join(notes))
    if verbose:
        yield from filter(None, map(stretches_part, motions))


def stretches_part(motion: Motion) -> ResultTable | None:
    """Return a table of the soils along a layered arc from its upper end, or None for other arcs.

    The columns are length, share of the weight above, mean stresses and strength at the start.
    """
    records = stretch_records(motion)
    if not records:
        return None
    length = sum(record["length"] for record in records)
    stresses = ("normal_stress", "pore_pressure", "strength")
    whole = {"soil": "whole arc", "length": length, "weight_share": 1.0}
    for name in stresses:
        whole[name] = sum(record["length"] * record[name] for record in records) / length
    rows = []
    (of_length, length_unit), (of_stress, unit) = output_unit("m"), drawn_unit("Pa")
    for record in (*records, whole):
        in_unit = [of_stress * record[name] for name in stresses]
        rows.append([record["soil"], of_length * record["length"], f"{100 * record['weight_share']:.1f}", *in_unit])
    head = ["soil", spelt_out("length", length_unit), "weight (%)", *(spelt_out(name, unit) for name in stresses)]
    note = "From the upper end down: the share of the weight above each stretch, and means along it at the start."
    if beyond := foreland_words(motion.plan.scene.arc):
        note += f" Beyond the exit: {beyond}."
    return ResultTable(head, rows, f"{motion.plan.scene.name}: soils along the slip surface", note)


def beside(columns: Sequence[TextMap]) -> Rows:
    """Return columns of texts by label as rows: the label and a cell of each column, empty without this label."""
    return [[label, *(c.get(label, "") for c in columns)] for label in dict.fromkeys(chain.from_iterable(columns))]


# --- slopes ----------------------------------------------------------------------------------------------------------


def stability_columns(critical: Critical) -> tuple[TextDict, TextDict]:
    """Return the factors of safety of a slip circle, and its geometry with free water, as texts by label."""
    factors = _factors(critical.factors_of_safety, critical.slope.k_h)
    without = critical.factors_of_safety_without_k_h or {}
    factors |= {f"{label}, without k_h": text for label, text in _factors(without).items()}
    if critical.yield_coefficient is not None:
        factors["yield coefficient k_y"] = f"{critical.yield_coefficient:.4f}, by the paper's method"
    size = critical.radius
    entry_and_exit = {"entry": _point(critical.entry, size), "exit": _point(critical.exit, size)}
    return factors, pond_row(critical.slope) | entry_and_exit | _circle(critical)


def pond_row(soil: Any) -> TextDict:
    """Return the free water on a slope or on the ground of a single section as text by label; empty without it."""
    ponds = soil.free_water.of_one if isinstance(soil, Slope | Section) else []
    factor, unit = output_unit("m")
    numbers = [[f"{factor * x:.8g}" for x in pond] for pond in ponds]
    texts = [f"x = {first} to {last} {unit}, level {level} {unit}" for first, last, level in numbers]
    if texts:
        return {"free water": "; ".join(texts)}
    return {}


def _circle(critical: Critical) -> TextDict:
    """Return a slip circle of a slope, and how it was determined, as texts by label."""
    column = {
        "circle": least_of(critical.method) if critical.method else "as given",
        "centre": _point(critical.centre, critical.radius),
        "radius": amount_text(critical.radius, "m"),
        "circles evaluated, invalid": f"{critical.tried}, {critical.refused}",
    }
    if not math.isnan(critical.negative):  # NaN for an overhanging circle
        sides = {1: "right", -1: "left"}
        column["slides to the"] = sides.get(critical.facing, "neither side: nothing drives it")
        column["arc under negative normal stress"] = f"{100 * critical.negative:.1f} %"
    return column


def _factors(by_method: Mapping[str, float | None], k_h: float = 0.0) -> TextDict:
    """Return factors of safety as texts by labels that name the method, and k_h unless it is 0."""
    condition = f", k_h = {number_text(k_h)}" if k_h else ""
    return {f"{factor_label(method)}{condition}": factor_text(factor) for method, factor in by_method.items()}


def _point(xy: Sequence[float], radius: float) -> str:
    """Return x and y in m as text in the unit of output, to the last place of the printed radius, also in m."""
    factor, unit = output_unit("m")
    places = DIGITS - 1 - math.floor(math.log10(factor * radius))
    return ", ".join(f"{round(factor * value, places) + 0.0:.12g}" for value in xy) + f" {unit}"


# --- plans and ladders -----------------------------------------------------------------------------------------------


def plan_part(plan: Plan) -> ResultTable:
    """Return a plan as a table."""
    rows = {
        "effects": ", ".join(plan.effects) or "none",
        "not included": ", ".join(plan.left_out) or "none",
        "friction law": plan.law,
        "method": plan.method,
        "because": plan.why,
        "foreland": foreland_words(plan.scene.arc),
        "requested accuracy": f"{plan.accuracy:.1e}" + ("" if plan.scene.shape else "; a single scene: to rounding"),
    }
    return ResultTable(["", plan.scene.name], [row for row in rows.items() if row[1]])


def ladder_part(rungs: Sequence[Rung], name: str) -> ResultTable:
    """Return a ladder as a table under a name, with the difference of each rung from the last in per cent."""
    outcomes = [q for q in OUTCOMES.values() if q.name in Rung.__dataclass_fields__]
    rows = []
    for rung in rungs:
        values = [amount_text(getattr(rung, q.name), q.unit) for q in outcomes]
        end = "yes" if rung.peak_velocity else "does not move"
        rows.append(
            [
                f"+ {rung.added}" if rung.added else "none",
                time_text(1e9 * rung.seconds),
                *values,
                end if rung.arrested else "moving",
                f"{100 * rung.difference:.3g} %",
            ]
        )
    head = ["effect added", "time", *(spelt_out(q.name) for q in outcomes), "rests", "differs"]
    return ResultTable(head, rows, name)


# --- the screen ------------------------------------------------------------------------------------------------------


def show(head: Sequence[str], rows: Rows, title: str = "", note: str = "") -> None:
    """Print a table on stdout.

    In a terminal the table has the width of the terminal, at most `WIDEST`, and a coloured head. Long cells are
    wrapped; columns that do not fit follow below the others. ``NO_COLOR`` and dumb terminals disable colour.
    """
    terminal = is_terminal(sys.stdout)
    width = min(shutil.get_terminal_size().columns, WIDEST) if terminal else WIDTH
    lines = [*table_lines(head, rows, title, note, width)]
    coloured = terminal and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"
    for line, after in zip(lines, [*lines[1:], ""], strict=True):
        headed = coloured and after.startswith("--")
        print(f"{BOLD}{line}{PLAIN}" if headed else line)


def table_lines(head: Sequence[str], rows: Rows, title: str, note: str, width: int = WIDTH) -> Iterator[str]:
    """Yield the lines of a table of at most ``width`` characters, in blocks of the first and as many columns as fit."""
    every_row = [head, *rows] if head else rows
    first, *rest = ([*map(cell_text, column)] for column in zip(*every_row, strict=True))
    yield from wrap(clean(title), width)
    widest_lead = max(width * 6 // 10, _LEAST)
    (lead,) = _widths([first], widest_lead)
    room = width - lead
    while rest:
        counts = range(len(rest), 1, -1)
        count = next((n for n in counts if _total(rest[:n], _LEAST) <= room), 1)
        beside = rest[:count]
        rest = rest[count:]
        wraps = range(width, _LEAST, -1)
        most = next((most for most in wraps if _total(beside, most) <= room), _LEAST)
        yield from _lines([first, *beside], [lead, *_widths(beside, most)], bool(head))
        yield ""
    yield from wrap(clean(note), width, break_on_hyphens=False)


def cell_text(cell: Any) -> str:
    """Return a cell as printable text: an `Estimate` with its interval, or a number with four digits."""
    if isinstance(cell, Estimate):
        return interval_text(cell)
    if isinstance(cell, float):
        return value_text(cell)
    return clean(str(cell))


def _total(columns: Sequence[Sequence[str]], most: int) -> int:
    """Return the total width in characters of columns wrapped at ``most`` characters, with the gaps before them."""
    return sum(_widths(columns, most)) + _GAP * len(columns)


def in_unit(cell: Any, unit: str) -> Any:
    """Return an outcome in an SI unit, or an `Estimate` of one, converted to the unit of output."""
    factor, _ = output_unit(unit)
    if isinstance(cell, Estimate):
        return Estimate(*(factor * x for x in cell))
    return factor * cell


def unit_table(units: TextMap, rows: Iterable[Iterable[Any]], title: str = "", note: str = "") -> ResultTable:
    """Return a table in units of output, from rows of cells in SI units and the unit of each column by its name.

    Cells of columns without a unit remain as they are.
    """
    heads = [f"{name} ({output_unit(unit)[1]})" if unit else name for name, unit in units.items()]
    cells = []
    for row in rows:
        by_unit = zip(row, units.values(), strict=True)
        cells.append([in_unit(cell, unit) if unit else cell for cell, unit in by_unit])
    return ResultTable(heads, cells, title, note)


def interval_text(e: Estimate) -> str:
    """Return a value and its interval as text, to two digits of the width; unknown parts are omitted."""
    if math.isnan(e.low) and math.isnan(e.high):
        return value_text(e.value)
    if e.low == math.inf:
        return BEYOND
    width = e.high - e.low if e.high < math.inf else max(e.value - e.low, 0.0)
    error = width if width < math.inf else 0.0

    def text(x: float) -> str:
        if math.isnan(x):
            return "?"
        return to_error(x, error) if x < math.inf else BEYOND

    value, low, high = map(text, e)
    if math.isnan(e.value):
        return f"{low} to {high}"
    return f"{value} [{low}, {high}]"


def _widths(columns: Sequence[Sequence[str]], most: int) -> list[int]:
    """Return the widths of columns in characters, wrapped at ``most`` characters without breaking words."""
    widths = []
    for column in columns:
        words = " ".join(column).split()
        longest_word = max(map(len, words), default=0)
        widths.append(min(max(map(len, column)), max(most, longest_word)))
    return widths


def _lines(columns: Sequence[Sequence[str]], widths: Sequence[int], headed: bool) -> Iterator[str]:
    """Yield the lines of columns side by side, with cells wrapped to ``widths`` in characters, without empty rows."""
    gap = _GAP * " "
    for number, row in enumerate(zip(*columns, strict=True)):
        if row[0] and not any(row[1:]):
            continue
        cells = [wrap(cell, width, break_on_hyphens=False) or [""] for cell, width in zip(row, widths, strict=True)]
        for parts in zip_longest(*cells, fillvalue=""):
            yield gap.join(map(str.ljust, parts, widths)).rstrip()
        if headed and number == 0:
            gaps = _GAP * (len(widths) - 1)
            yield "-" * (sum(widths) + gaps)
