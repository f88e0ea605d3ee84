"""Tornado diagrams: changes of an output with each number of a scene, the largest on top."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from slipcircle.workbench.common.quantities import OUTCOMES
from slipcircle.workbench.files.keys import Key
from slipcircle.workbench.files.numbers import by_name, lengths, uncertain_numbers
from slipcircle.workbench.outputs.pictures.plotstyle import (
    AREAS,
    amount,
    axis,
    empty,
    known,
    legend,
    lines,
    measure,
    number,
    quantity_words,
    title,
    unit_of,
)
from slipcircle.workbench.outputs.pictures.sheets import Drawing, sheet

if TYPE_CHECKING:
    from slipcircle.derivatives import Sensitivity

_MOST_BARS = 10  # greatest number; smaller changes are summarised in text
Bar = tuple[float, str, str]  # a change, its step in words, and the name of the number
_SHARE = 0.01  # relative change of each number if the scene has no uncertain numbers


def tornado(
    table: "Sensitivity",
    output: str = "run_out",
    changes: Mapping[str, float] | None = None,
    ax: Any = None,
    named: bool = True,
) -> Any:
    """Draw the change of an output, to first order, with each number of a scene, largest on top; return the axis.

    ``changes`` are the changes of numbers in the units of their keys, ``{"friction.angle_deg": 2.0}``; only these are
    drawn. By default the uncertain numbers of the scene change by one standard deviation; without any, all numbers but
    gravity change by 1 %, ends of the arc by 1 % of its half angle and points of a section by 1 % of its depth. Of the
    coordinates of a line of points, only the most influential is drawn. ``named`` adds a legend.
    """
    known("tornado: output", output, table.outputs)
    steps, how = _steps(table, changes)
    bars = _changes(table, output, steps)
    if changes is None:
        bars = [*_largest_of_lines(bars)]
    shown, hidden = bars[:_MOST_BARS], bars[_MOST_BARS:]
    ax = axis(ax, (7.0, 1.6 + 0.4 * max(2, len(shown))))
    unit, at = table.outputs[output], table.at[output]
    more = ""
    if hidden:
        more = f"\n{len(hidden)} more numbers change it by at most {amount(abs(hidden[0][0]), unit)} each"
    measure(ax.xaxis, f"change of {OUTCOMES[output].label} from {amount(at, unit)}{how}", unit, more)
    title(ax, f"influence on {OUTCOMES[output].label}")
    if not at or not shown:
        return empty("nothing changes it" if at else "does not move", ax, "x", "y")
    _two_sided_bars(ax, shown)
    if named:
        legend(ax)
    return ax


def _changes(table: "Sensitivity", output: str, steps: Mapping[str, tuple[Key, float]]) -> list[Bar]:
    """Return the changes of an output with each step, the largest first, with the steps in words."""
    bars = []
    for name, (key, step) in steps.items():
        value = float(key.from_si(table.at[name]))
        per_si = table.derivative(output, name)
        change = per_si * key.slope(value) * step
        quantity = quantity_words(key)
        unit = unit_of(key)
        words = f"{quantity} {number(value)} ± {step:.3g} {unit}"
        if np.isfinite(change):
            bars.append((change, words.rstrip(), name))
    return sorted(bars, key=lambda bar: -abs(bar[0]))


def _largest_of_lines(bars: Iterable[Bar]) -> Iterator[Bar]:
    """Yield the bars with a change; for each line of points only the bar of the coordinate of largest change."""
    drawn = set()
    for bar in bars:
        line = re.sub(r"\.\d+\..*", "", bar[-1])
        if bar[0] and line not in drawn:
            drawn.add(line)
            yield bar


def _two_sided_bars(ax: Any, bars: Sequence[Bar]) -> None:
    """Draw a bar to both sides for each change, with its label, the largest first."""
    changes = np.array([change for change, *_ in bars])
    lines(ax, [text for _, text, _ in bars])
    places = np.arange(len(bars))
    ax.barh(places, changes, height=0.62, label="larger", **AREAS["kinetic"])
    ax.barh(places, -changes, height=0.62, label="smaller", **AREAS["rests"])
    widest = 1.08 * abs(changes[0])
    ax.set_xlim(-widest, widest)
    ax.axvline(0.0, color="0.25", lw=0.8)


def _steps(table: "Sensitivity", changes: Mapping[str, float] | None) -> tuple[dict[str, tuple[Key, float]], str]:
    """Return the step of each number in the unit of its key, and the rule for the steps in words."""
    by_names = by_name(table.scene)
    keys = {name: by_names[name] for name in table.parameters}
    if changes is not None:
        choice = [key.key for key in keys.values()]
        for changed in changes:
            known("tornado: changes", changed, choice)
        return {name: (key, changes[key.key]) for name, key in keys.items() if changes.get(key.key)}, ""
    deviations = {}
    for name, uncertain in uncertain_numbers(table.scene).items():
        if name in keys:
            _, deviation = uncertain.moments
            deviations[name] = uncertain.number, deviation
    if deviations:
        return deviations, ", by a standard deviation of each"
    relative = {name: (key, _relative_step(table, name, key)) for name, key in keys.items() if name != "gravity"}
    return relative, f", by {100 * _SHARE:g} % of each"


def _relative_step(table: "Sensitivity", name: str, key: Key) -> float:
    """Return the step of a number as a share of its size, in the unit of its key.

    The size of places on a section is its depth, and the size of ends of an arc is half its angle.
    """
    arc: Any = table.scene.arc
    value = table.at[name]
    size = abs(value) or 1.0
    if name in lengths(arc):
        size = float(arc.depth)
    elif name.startswith("theta_"):
        size = float(arc.half_angle)
    return float(_SHARE * size / key.slope(float(key.from_si(value))))


def panels(table: "Sensitivity") -> Drawing:
    """Return a picture of a tornado for each output, the run-out on top."""
    height = 1.5 + 0.3 * min(_MOST_BARS, len(table.parameters))
    outputs = sorted(table.outputs, key=[*OUTCOMES].index)
    return sheet([(height, [partial(tornado, table, output, named=output == outputs[0])]) for output in outputs])
