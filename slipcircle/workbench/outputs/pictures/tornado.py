"""Tornado diagrams: changes of an output with each number of a scene, the largest on top."""

import re
from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import NumberMap
from slipcircle.workbench.common.quantities import OUTCOMES
from slipcircle.workbench.files.keys import Key
from slipcircle.workbench.files.numbers import by_name, in_output_unit, lengths, uncertain_numbers
from slipcircle.workbench.outputs.pictures.plotstyle import (
    AREAS,
    check_choice,
    empty,
    formatted_amount,
    formatted_number,
    key_unit,
    name_rows,
    panel,
    quantity_words,
)
from slipcircle.workbench.outputs.pictures.sheets import Drawing, sheet

if TYPE_CHECKING:
    from slipcircle.derivatives import Sensitivity

_MOST_BARS = 10  # greatest number; smaller changes are summarised in text
_SHARE = 0.01  # relative change of each number if the scene has no uncertain numbers


class Bar(NamedTuple):
    """Change of an output, the step of a number that causes it in words, and the line of points of the number."""

    change: float
    words: str
    line: str


def tornado(
    table: "Sensitivity", output: str = "run_out", changes: NumberMap | None = None, ax: Any = None, named: bool = True
) -> Any:
    """Draw the change of an output, to first order, with each number of a scene, largest on top; return the axis.

    ``changes`` are the changes of numbers in the units of their keys, ``{"friction.angle_deg": 2.0}``; only these are
    drawn. By default the uncertain numbers of the scene change by one standard deviation; without any, all numbers but
    gravity change by 1 %, ends of the arc by 1 % of its half angle and points of a section by 1 % of its depth. Of the
    coordinates of a line of points, only the most influential is drawn. ``named`` adds a legend.
    """
    check_choice("tornado: output", output, table.outputs)
    steps, how = _steps(table, changes)
    bars = sorted((_bar(table, output, name, *step) for name, step in steps.items()), key=lambda bar: -abs(bar.change))
    bars = [bar for bar in bars if np.isfinite(bar.change)]
    if changes is None:
        largest = {bar.line: bar for bar in reversed(bars)}
        bars = [bar for bar in bars if bar.change and largest[bar.line] is bar]
    shown = bars[:_MOST_BARS]
    hidden = bars[_MOST_BARS:]
    unit, at, words = table.outputs[output], table.at[output], OUTCOMES[output].label
    more = ""
    if hidden:
        more = f"\n{len(hidden)} more numbers change it by at most {formatted_amount(abs(hidden[0].change), unit)} each"
    across = f"change of {words} from {formatted_amount(at, unit)}{how}", unit, more
    ax = panel(ax, f"influence on {words}", across, size=(7.0, 1.6 + 0.4 * max(2, len(shown))))
    if not at or not shown:
        return empty("nothing changes it" if at else "does not move", ax, "x", "y")
    _draw_bars(ax, shown)
    if named:
        ax.legend(loc="lower left", fontsize="small")  # beside the shortest bars: the title may be as wide as the axis
    return ax


def _draw_bars(ax: Any, bars: Sequence[Bar]) -> None:
    """Draw a bar to both sides for each change, the largest first."""
    changes = np.array([bar.change for bar in bars])
    name_rows(ax, [bar.words for bar in bars])
    ax.barh(range(len(bars)), changes, height=0.62, label="larger", **AREAS["kinetic"])
    ax.barh(range(len(bars)), -changes, height=0.62, label="smaller", **AREAS["rests"])
    widest = 1.08 * abs(changes[0])
    ax.set_xlim(-widest, widest)
    ax.axvline(0.0, color="0.25", lw=0.8)


def _bar(table: "Sensitivity", output: str, name: str, key: Key, step: float) -> Bar:
    """Return the bar of an output for a ``step`` of the number ``name``, in the unit of its key."""
    value = float(key.from_si(table.at[name]))
    change = table.derivative(output, name) * key.slope(value) * step
    drawn = in_output_unit(key)
    value = float(drawn.from_si(table.at[name]))
    drawn_step = step * key.per_unit / drawn.per_unit
    words = f"{quantity_words(key)} {formatted_number(value)} ± {drawn_step:.3g} {key_unit(drawn)}"
    return Bar(change, words.rstrip(), re.sub(r"\.\d+\..*", "", name))


def _steps(table: "Sensitivity", changes: NumberMap | None) -> tuple[dict[str, tuple[Key, float]], str]:
    """Return key and step of each number by name, in the unit of the key, and the rule for the steps in words.

    ``changes`` are given steps by key, or None.
    """
    by_names = by_name(table.scene)
    keys = {name: by_names[name] for name in table.parameters}
    if changes is not None:
        for changed in changes:
            check_choice("tornado: changes", changed, [key.key for key in keys.values()])
        return {name: (key, changes[key.key]) for name, key in keys.items() if changes.get(key.key)}, ""
    uncertain = {name: each for name, each in uncertain_numbers(table.scene).items() if name in keys}
    if uncertain:
        deviations = {name: (each.number, each.moments[1]) for name, each in uncertain.items()}
        return deviations, ", by a standard deviation of each"
    relative = {}
    for name, key in keys.items():
        if name != "gravity":
            relative[name] = key, float(_SHARE * size_of(table, name) / key.slope(float(key.from_si(table.at[name]))))
    return relative, ", by the changes on the left"


def size_of(table: "Sensitivity", name: str) -> float:
    """Return the size of a number in SI units: its value, of a place the depth, of an end of the arc its half angle."""
    arc: Any = table.scene.arc
    if name in lengths(arc):
        return float(arc.depth)
    if name.startswith("theta_"):
        return float(arc.half_angle)
    return abs(table.at[name]) or 1.0


def panels(table: "Sensitivity") -> Drawing:
    """Return a picture of a tornado for each output, the run-out on top."""
    height = 1.5 + 0.3 * min(_MOST_BARS, len(table.parameters))
    outputs = sorted(table.outputs, key=[*OUTCOMES].index)
    return sheet([(height, [partial(tornado, table, output, named=output == outputs[0])]) for output in outputs])
