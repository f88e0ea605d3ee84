"""`slipcircle cost`: computing time against accuracy of a scene or a kernel, measured on this machine."""

import argparse
import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from functools import partial
from typing import TYPE_CHECKING

from slipcircle.base.kinds import NumberDict, NumberMap, TextPair
from slipcircle.workbench.commands import values
from slipcircle.workbench.commands.common import SCENE, add_files, with_scene_context
from slipcircle.workbench.common.quantities import json_values, time_text
from slipcircle.workbench.files.scenefile import load
from slipcircle.workbench.files.shipped import find
from slipcircle.workbench.outputs.pictures.files import picture
from slipcircle.workbench.outputs.tables import Answer, ResultTable

if TYPE_CHECKING:
    from slipcircle.workbench.cost.rows import CostRow

NOTE = (
    "error: largest relative error over the inputs; bound: proved for a kernel, estimated for a scene; time: processor "
    "time of one element or scene, median; relative: over the fastest row of its group. frontier: no other row is both "
    "faster and at least as accurate. Times and errors within 20 % are ties."
)
BUDGETS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}


def budget(text: str) -> float:
    """Return a time in s, parsed from a number and a unit (ns, us, ms or s) such as ``1us``."""
    number, unit = re.fullmatch(r"([\d.e+-]+?) ?(ns|us|ms|s)", text).groups()  # type: ignore[union-attr]
    return float(number) * BUDGETS[unit]


def accuracy(text: str) -> float:
    """Return a relative error between 0 and 1, parsed from text such as ``1e-6``; otherwise raise ValueError."""
    value = float(text)
    if not 0.0 < value < 1.0:
        raise ValueError
    return value


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to a parser."""
    names = f"{SCENE}; or a kernel, such as polar_moment. Default: %(default)s"
    parser.add_argument("name", nargs="?", metavar="NAME", default="vaiont", help=names)
    choice = parser.add_mutually_exclusive_group()
    for option, example, words in (
        ("accuracy", "1e-6", "name the fastest row with this relative error"),
        ("budget", "1us", "name the most accurate row within this time for one element or scene"),
    ):
        choice.add_argument(f"--{option}", metavar=option.upper(), help=f"{words}, such as {example}")
    ranges = "range of an input over which errors are taken, such as friction.angle_deg=6:20; repeatable"
    parser.add_argument("--vary", action="append", default=[], metavar="KEY=FROM:TO", help=ranges)
    add_files(parser, "error against time")


def _wanted(options: argparse.Namespace) -> NumberDict:
    """Return the requested accuracy (relative error) or budget (s) by the option's name; empty if neither is given."""
    for name, read, allowed in (
        ("accuracy", accuracy, "a relative error between 0 and 1, such as 1e-6"),
        ("budget", budget, "a time in ns, us, ms or s, such as 1us"),
    ):
        if text := getattr(options, name):
            try:
                return {name: read(text)}
            except (ValueError, AttributeError):
                raise ValueError(f"cost: --{name} {text}: must be {allowed}") from None
    return {}


def run(options: argparse.Namespace) -> Answer:
    """Run the command and return its answer."""
    from slipcircle.workbench.cost import kernels, scenes
    from slipcircle.workbench.cost.rows import recommended, with_verdicts
    from slipcircle.workbench.outputs.info import machine

    target = _wanted(options)
    form = "KEY=FROM:TO, each key once, such as friction.angle_deg=6:20"
    vary = values.values_by_key("vary", options.vary, form, values.low_and_high)
    if options.name in kernels.KERNELS:
        if vary:
            raise ValueError(
                f"cost: --vary: {options.name} is a kernel, measured on its whole domain; leave --vary out"
            )
        rows = kernels.of_kernel(options.name)
        title = options.name
    else:
        try:
            find(options.name)
        except ValueError as error:
            raise ValueError(f"{error}; kernels are {', '.join(kernels.KERNELS)}") from error
        scene = load(options.name)
        rows = with_scene_context(scene, lambda scene: scenes.of_scene(scene, vary))
        title = scene.name
    if target:
        chosen = [row for row in rows if row.group != scenes.ALONE]
        rows = [row for row in rows if row.group == scenes.ALONE] + recommended(with_verdicts(chosen), **target)
    measured_on = machine()
    record = {"name": title, "machine": measured_on, "rows": [json_values(asdict(row)) for row in rows]}
    drawn = {"plot": partial(picture, "cost", rows)}
    return Answer(lambda: record, _parts(title, rows, measured_on, target), (), drawn)


def _parts(title: str, rows: Sequence["CostRow"], machine: str, target: NumberMap) -> Iterator[ResultTable]:
    """Yield the table of measured rows, with notes below it.

    ``machine`` describes the computer, and ``target`` is the requested accuracy or budget by name.
    """
    fastest = {row.group: min(x.seconds for x in rows if x.group == row.group) for row in rows}
    cells = []
    for row in rows:
        error = "no digit" if row.error >= 1.0 else _error(row.error)
        bound = "" if row.bound is None else _error(row.bound)
        relative = f"{row.seconds / fastest[row.group]:.2f}"
        verdict = f"misses its accuracy, {row.verdict}" if row.misses else row.verdict
        taken = time_text(1e9 * row.seconds)
        cells.append([row.group, row.way, f"{row.count}", error, bound, taken, relative, verdict])
    heads = ["", "way", "N", "error", "bound", "time", "relative", "verdict"]
    yield ResultTable(heads, cells, title, " ".join(_notes(rows, machine, target)))


def _error(error: float) -> str:
    """Return a relative error as text."""
    return f"{error:.1e}" if error else "0"


def _notes(rows: Sequence["CostRow"], machine: str, target: NumberMap) -> Iterator[str]:
    """Yield the sentences below the table of measured rows; the arguments are those of `_parts`."""
    from slipcircle.workbench.cost.rows import RECOMMENDED, price_of_a_digit
    from slipcircle.workbench.cost.scenes import ALONE

    several = [row for row in rows if row.group != ALONE]
    if len(several) < len(rows):
        yield "A single scene is solved to rounding, whatever accuracy is requested; in ensembles accuracy saves time."
    tiers = [row for row in several if re.fullmatch(r"1e-\d+|best", row.way)]
    price = price_of_a_digit(tiers)
    if not math.isnan(price):
        first, *_, last = sorted(tiers, key=lambda row: -row.error)
        yield f"From {first.way} to {last.way} each digit costs {100 * (price - 1):.0f} %."
    for row in rows:
        if row.bound is not None and row.error > row.bound:
            yield f"The error of {row.way} ({row.group}) is above its bound: a bug, please report it."
    limit = "".join(f" for {name} {text}" for name, text in _shown(target))
    chosen = [row for row in rows if row.verdict == RECOMMENDED]
    yield from (f"Recommended{limit}: {_measured(row)}." for row in chosen)
    if limit and not chosen:
        fastest = min(several, key=lambda row: row.seconds)
        closest = min(several, key=lambda row: row.error)
        yield f"No row{limit}; the fastest is {_measured(fastest)}, the most accurate {_measured(closest)}."
    yield from (NOTE, f"{machine}.")


def _measured(row: "CostRow") -> str:
    """Return the name, time, error and bound of a row as text."""
    bound = "" if row.bound is None else f", bound {_error(row.bound)}"
    return f"{row.way} ({time_text(1e9 * row.seconds)}, error {_error(row.error)}{bound})"


def _shown(target: NumberMap) -> Iterator[TextPair]:
    """Yield the name and the text of the requested accuracy or budget."""
    for name, value in target.items():
        yield name, time_text(1e9 * value) if name == "budget" else f"{value:g}"
