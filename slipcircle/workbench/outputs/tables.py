"""What commands say: tables of motions, slopes, plans, ladders and derivatives, on the screen without any library."""

import math
import shutil
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict
from itertools import chain, combinations, zip_longest
from textwrap import wrap
from typing import TYPE_CHECKING, Any, NamedTuple

from generated.effects import EFFECTS
from slipcircle.base.text import shown
from slipcircle.core import Motion, Plan, step_operations
from slipcircle.workbench.common.quantities import JOURNEY, OUTCOMES, results, time_text, to_error, words
from slipcircle.workbench.files.loaded import stability_of
from slipcircle.workbench.files.numbers import by_name
from slipcircle.workbench.outputs.trace import toe_words
from slipcircle.workbench.stability.search import Critical
from slipcircle.workbench.stability.stability import METHODS
from slipcircle.workbench.studies.ladder import Rung
from slipcircle.workbench.studies.statistics import BEYOND, Estimate

if TYPE_CHECKING:
    from slipcircle.core import Sensitivity

WIDTH, _LEAST, _GAP = 100, 22, 2  # of a table, of a column of long cells, between columns
Rows = Iterable[Sequence[Any]]


class Part(NamedTuple):
    """A table, with what stands above and below it."""

    head: Sequence[str]
    rows: Rows
    title: str = ""
    note: str = ""


class Answer(NamedTuple):
    """What a command found: as JSON, where that is asked for; else its tables and texts, and what to know of them."""

    record: Callable[[], Any]
    parts: Iterable[Part | str]
    warnings: Iterable[str] = ()


# --- motions ---------------------------------------------------------------------------------------------------------

COEFFICIENTS = {
    "Theta*": "moment_of_inertia",
    "J_r": "radial_weight",
    "J_theta": "weight_moment",
    "lambda": "resistance_factor",
    "A": "dynamic_coefficient",
}


def motion_column(motion: Motion, verbose: bool = False) -> dict[str, str]:
    """The table of one motion: each value by its label, key results first."""
    chosen = [q for q in results(motion) if verbose or q.key or (q in JOURNEY and motion.moves)]
    found = {q.label: q.text(motion) for q in chosen} | end_words(motion)
    if words_of_toe := toe_words(motion):
        found["toe at the end"] = f"{words_of_toe}: the method continues the circle there"
    if (circle := stability_of(motion.plan.scene)) is not None:
        if (circle.factor_of_safety_without_k_h or circle.factor_of_safety)["paper"] is not None:
            del found["factor of safety"]  # the paper's, which stands among these
        told = ("entry", "exit")  # as ends of the slip surface
        found |= {label: value for label, value in stability_column(circle).items() if label not in told}
    if motion.plan.law != "constant":
        found["friction angle"] += f", {motion.plan.law}"
    found |= {
        "effects": ", ".join(motion.plan.effects) or "none",
        "left out": ", ".join(motion.plan.left_out) or "none",
        "method": motion.plan.method,
        "estimated error": f"{motion.error_estimate:.1e}",
    }
    if verbose:
        d = asdict(motion.plan.scene.arc.dimensionless)
        found |= {symbol: f"{float(d[name]):z.5f}" for symbol, name in COEFFICIENTS.items()}
    return found


def end_words(motion: Motion) -> dict[str, str]:
    """What stands for the end and its time, by label, where a motion does not come to rest."""
    if not motion.moves:
        return {"comes to rest": "does not move", "duration": "-"}
    if motion.arrested:
        return {}
    time = OUTCOMES["duration"].text(motion)
    if motion.plan.scene.end_time is None:
        return {"comes to rest": "no, nothing holds it", "duration": f"first standstill at {time}"}
    return {"comes to rest": "no", "duration": f"still moving at {time}"}


def beside(columns: Sequence[Mapping[str, str]]) -> Rows:
    """Columns by label as rows of one table; a cell is empty where a column has no such label."""
    return [[label, *(c.get(label, "") for c in columns)] for label in dict.fromkeys(chain.from_iterable(columns))]


# --- slopes ----------------------------------------------------------------------------------------------------------


def stability_column(found: Critical) -> dict[str, str]:
    """What is said of a slip circle of a slope: each value by its label."""

    def point(xy: Sequence[float]) -> str:
        return ", ".join(map(shown, xy)) + " m"

    def factors(by_method: Mapping[str, float | None], words: str) -> dict[str, str]:
        return {
            f"factor of safety by {METHODS[m][0]}{words}": "refused" if v is None else f"{v:.4f}"
            for m, v in by_method.items()
        }

    rows = factors(found.factor_of_safety, f", k_h = {shown(found.slope.k_h)}" if found.slope.k_h else "")
    if found.factor_of_safety_without_k_h:
        rows |= factors(found.factor_of_safety_without_k_h, ", without k_h")
        rows["motion starts from"] = "that without k_h by the paper's method"
    sense = (
        {}
        if math.isnan(found.negative)
        else {  # as of a circle that overhangs
            "slides to the": {1: "right", -1: "left"}.get(found.facing, "neither side: nothing drives it"),
            "arc under negative normal stress": f"{100 * found.negative:.1f} %",
        }
    )
    return (
        rows
        | {
            "circle": f"least factor by {found.method}" if found.method else "as given",
            "centre": point(found.centre),
            "radius": f"{shown(found.radius)} m",
            "entry": point(found.entry),
            "exit": point(found.exit),
            "circles tried, refused": f"{found.tried}, {found.refused}",
        }
        | sense
    )


# --- plans and ladders -----------------------------------------------------------------------------------------------


def plan_part(plan: Plan) -> Part:
    """A plan as a table."""
    rows = [
        ("effects", ", ".join(plan.effects) or "none"),
        ("left out", ", ".join(plan.left_out) or "none"),
        ("friction law", plan.law),
        ("method", plan.method),
        *([("because", plan.why)] if plan.why else []),
        ("program of", ", ".join(plan.fragments)),
        ("a step's operations", plan.operations),
        ("expected cost", f"about {plan.cost} floating-point operations"),
        ("error asked for", f"{plan.accuracy:.1e}"),
    ]
    return Part(["", plan.scene.name], rows)


def combinations_part() -> Part:
    """Operations of every combination of effects, with a constant friction."""
    every = chain.from_iterable(combinations(EFFECTS, n) for n in range(len(EFFECTS) + 1))
    shaken = tuple(p.symbol for p in EFFECTS["shaking"].parameters if p.kind == "series")
    rows = []
    for effects in every:
        moving = shaken if "shaking" in effects else ()
        rows.append([", ".join(effects) or "none", step_operations(effects, ("constant",), moving)])
    return Part(["effects", "operations on series of one step"], rows)


def ladder_part(rungs: Sequence[Rung], name: str) -> Part:
    """A ladder as a table; how far each rung differs from the fullest."""
    told = [q for q in OUTCOMES.values() if q.name in Rung.__dataclass_fields__]
    rows = [
        [
            f"+ {r.added}" if r.added else "none",
            time_text(1e9 * r.seconds),
            f"{r.cost}",
            *(f"{shown(getattr(r, q.name))} {q.unit}" for q in told),
            "moving" if not r.arrested else "yes" if r.peak_velocity else "does not move",
            f"{100 * r.difference:.3g} %",
        ]
        for r in rungs
    ]
    head = ["effect added", "time", "operations", *(words(q.name) for q in told), "rests", "differs"]
    return Part(head, rows, name)


# --- derivatives -----------------------------------------------------------------------------------------------------


def sensitivity_part(found: "Sensitivity", name: str) -> Part:
    """Derivatives as a table, per unit of the key that a scene file has for each parameter."""
    rows, keys = [["", "", *(shown(found.at[n]) for n in found.distinct)]], by_name(found.scene)
    for parameter in found.parameters:
        of = keys[parameter]
        value = of.from_si(found.at[parameter])
        cells = []
        for output in found.distinct:
            at, slope = found.at[output], found.derivative(output, parameter) * of.slope(value)
            per_cent = f" ({slope * value / at:+.2g})" if at and slope * value else ""
            cells.append(f"{shown(float(slope))}{per_cent}")
        rows.append([of.key, shown(value, 6), *cells])
    head = ["by", "value", *(words(n, unit) for n, unit in found.distinct.items())]
    return Part(head, rows, name, "change per unit of the key, and in brackets in per cent per per cent of it")


# --- the screen ------------------------------------------------------------------------------------------------------


def say(message: str) -> None:
    """Tell something on stderr."""
    print(f"slipcircle: {clean(message)}", file=sys.stderr)


def show(head: Sequence[str], rows: Rows, title: str = "", note: str = "") -> None:
    """Print a table on stdout, as wide as the terminal and at most `WIDTH` columns.

    Long cells are wrapped; columns for which there is no room follow below the others.
    """
    width = min(shutil.get_terminal_size().columns, WIDTH) if sys.stdout.isatty() else WIDTH
    for line in _layout(head, rows, title, note, width):
        print(line)


def _layout(head: Sequence[str], rows: Rows, title: str, note: str, width: int) -> Iterator[str]:
    columns = zip(*([head] if head else []), *rows, strict=True)
    first, *rest = ([clean(interval(c) if isinstance(c, Estimate) else c) for c in column] for column in columns)
    yield from wrap(clean(title), width)
    lead = _widths([first], max(width * 6 // 10, _LEAST))[0]
    while rest:
        room, shown = width - lead, 1
        while shown < len(rest) and sum(_widths(rest[: shown + 1], _LEAST)) + _GAP * (shown + 1) <= room:
            shown += 1
        part, rest = rest[:shown], rest[shown:]
        most = next((m for m in range(width, _LEAST, -1) if sum(_widths(part, m)) + _GAP * shown <= room), _LEAST)
        yield from _lines([first, *part], [lead, *_widths(part, most)], bool(head))
        yield ""
    yield from wrap(clean(note), width, break_on_hyphens=False)


def interval(e: Estimate) -> str:
    """A value and its interval, to two digits of the interval's width; bounds alone where only they are known."""
    if all(map(math.isnan, e)):
        return "-"
    if e.low == math.inf:
        return BEYOND
    error = e.high - e.low if e.high < math.inf else max(e.value - e.low, 0.0)
    error = error if error < math.inf else 0.0
    value, low, high = ("?" if math.isnan(x) else BEYOND if x == math.inf else to_error(x, error) for x in e)
    return f"{low} to {high}" if math.isnan(e.value) else f"{value} [{low}, {high}]"


def _widths(columns: Sequence[Sequence[str]], most: int) -> list[int]:
    """Widths of columns whose cells are wrapped at some width, but with every word whole."""
    longest = (max(len(word) for cell in column for word in (*cell.split(), "")) for column in columns)
    return [min(max(map(len, c)), max(most, word)) for c, word in zip(columns, longest, strict=True)]


def _lines(columns: Sequence[Sequence[str]], widths: Sequence[int], headed: bool) -> Iterator[str]:
    for number, row in enumerate(zip(*columns, strict=True)):
        if not any(row[1:]) and len(row) > 1 and row[0]:
            continue  # which only columns above or below have
        cells = (wrap(c, w, break_on_hyphens=False) for c, w in zip(row, widths, strict=True))
        for parts in zip_longest(*(c or [""] for c in cells), fillvalue=""):
            yield "  ".join(p.ljust(w) for p, w in zip(parts, widths, strict=True)).rstrip()
        if not number and headed:
            yield "-" * (sum(widths) + _GAP * (len(widths) - 1))


def clean(text: str) -> str:
    """Anybody's text without what a terminal would obey."""
    return "".join(c if c.isprintable() else " " if c.isspace() else "\N{REPLACEMENT CHARACTER}" for c in text)
