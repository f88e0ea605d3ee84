"""Pictures that compare several motions, or the run-outs of one scene as its effects are added.

The pictures show the farthest positions, velocity and displacement over time, and the run-outs.
"""

from collections.abc import Iterable, Sequence
from functools import partial
from typing import Any

import numpy as np

from slipcircle.core import Motion
from slipcircle.workbench.common.quantities import HISTORY
from slipcircle.workbench.common.trace import drawn
from slipcircle.workbench.cost.ladder import Rung
from slipcircle.workbench.outputs.pictures.plotstyle import (
    AREAS,
    LINES,
    REST,
    SERIES,
    amount,
    area,
    axis,
    curve,
    ending,
    label,
    lines,
    measure,
    note,
    number,
    points_of,
    title,
)
from slipcircle.workbench.outputs.pictures.sectionplot import surroundings
from slipcircle.workbench.outputs.pictures.shapes import mass_of
from slipcircle.workbench.outputs.pictures.sheets import Drawing, sheet

_MOST_BARS = 24  # greatest number; the other run-outs are summarised in text
STILL = "does not move"
_SECTION = 3.6  # heights in inches
_CURVES = 2.8
_BAR = 0.3


def overview(motions: Sequence[Motion]) -> Drawing:
    """Return a picture of several motions; the first eight that move have their own colours and labels."""
    sections = [(_SECTION, [partial(_sections, motions)])] if _same_slope(motions) else []
    velocity = partial(_curves, motions, "velocity", "velocity $v$")
    displacement = partial(_curves, motions, "displacement", "displacement $s$")
    bars = 0.8 + _BAR * min(len(motions), _MOST_BARS)
    moving = sum(motion.moves for motion in motions)
    rows = [*sections, (_CURVES, [velocity, displacement]), (bars, [partial(_bars, motions)])]
    return sheet(rows, f"{len(motions)} scenes, of which {moving} move", apart=True)


def _same_slope(motions: Sequence[Motion]) -> bool:
    """Return whether all masses have the same outline at the start."""
    outlines = []
    for motion in motions:
        soil = motion.plan.scene.arc
        outlines.append(mass_of(soil, soil).outline())
    first, *others = outlines
    return all(other.shape == first.shape and np.allclose(other, first, rtol=1e-9) for other in others)


def _named(motions: Sequence[Motion]) -> dict[int, tuple[str, Any, str]]:
    """Return colour, dashes and marker of the first motions that move, by index in ``motions``."""
    moving = [k for k, motion in enumerate(motions) if motion.moves]
    return dict(zip(moving, SERIES, strict=False))


def _sections(motions: Sequence[Motion], ax: Any) -> Any:
    """Draw the mass at the start and at the run-out of each motion; return the axis."""
    soil = motions[0].plan.scene.arc
    facing = float(soil.facing)
    mass = mass_of(soil, soil)
    styles = _named(motions)
    start = mass.outline()
    ends = {}
    for k, motion in enumerate(motions):
        if motion.moves:
            turn = facing * float(motion.farthest.rotation)
            ends[k] = mass.outline(turn)
    view = surroundings(ax, mass, soil, [start, *ends.values()])
    area(ax, start, "start")
    for k, outline in ends.items():
        colour, dashes, _ = styles.get(k, REST)
        area(ax, outline, "end", edgecolor=colour, ls=dashes, lw=1.6, hatch="", zorder=3)
    label(ax, "start", start.mean(axis=0), "0.3", inside=True)
    view.show(ax)
    title(ax, "farthest positions")
    return ax


def _curves(motions: Sequence[Motion], column: str, words: str, ax: Any) -> Any:
    """Draw a column of `HISTORY` over time as a labelled curve for each motion; return the axis."""
    styles = _named(motions)
    for k, motion in enumerate(motions):
        if motion.moves and k not in styles:
            colour, dashes, _ = REST
            columns = drawn(motion)
            curve(ax, motion, columns["time"], columns[column], color=colour, ls=dashes, lw=0.8)
    for k, (colour, dashes, _) in styles.items():
        columns = drawn(motions[k])
        times = columns["time"]
        values = columns[column]
        curve(ax, motions[k], times, values, color=colour, ls=dashes, lw=1.8)
        later = slice(len(times) // 8, None)
        name = motions[k].plan.scene.name
        label(ax, name, points_of(times[later], values[later]), colour, parse_math=False)
    if not styles:
        note(ax, ["none moves"])
    ax.set(xlabel="time $t$ (s)")
    measure(ax.yaxis, words, HISTORY[column].unit)
    title(ax, column)
    ax.margins(y=0.12)
    ax.grid(alpha=0.3)
    return ax


def _bars(motions: Sequence[Motion], ax: Any) -> Any:
    """Draw run-outs as bars with peak velocities and durations, the greatest if there are many; return the axis."""
    order = sorted(range(len(motions)), key=lambda k: -abs(motions[k].run_out))
    shown = [motions[k] for k in sorted(order[:_MOST_BARS])]
    words = []
    for m in shown:
        speed = abs(float(m.peak.velocity))
        words.append(_words(m.run_out, speed, f"{ending(m)} after", m.settling_time) if m.moves else STILL)
    names = [motion.plan.scene.name for motion in shown]
    _draw_bars(ax, names, [(motion.run_out, motion.arrested) for motion in shown], words)
    more = ""
    hidden = order[_MOST_BARS:]
    if hidden:
        farthest = abs(motions[hidden[0]].run_out)
        more = f"; {len(hidden)} more, each at most {amount(farthest, 'm')}"
    measure(ax.xaxis, "run-out along the arc", "m", more)
    title(ax, "run-out")
    return ax


def _draw_bars(ax: Any, names: Sequence[str], outcomes: Sequence[tuple[float, bool]], words: Sequence[str]) -> None:
    """Draw a bar for each run-out in m, styled by whether the mass is at rest, between a name and its outcome."""
    lines(ax, names)
    for place, (run_out, arrested) in enumerate(outcomes):
        ax.barh(place, run_out, height=0.62, **AREAS["rests" if arrested else "moves on"])
    side = ax.secondary_yaxis("right")
    side.set_yticks(range(len(words)), words)
    side.tick_params(length=0, labelsize="small")


def _words(run_out: float, speed: float, end: str, duration: float) -> str:
    return f"{amount(run_out, 'm')}, peak {amount(speed, 'm/s')}, {end} {number(duration)} s"


def ladder(rungs: Iterable[Rung], ax: Any = None) -> Any:
    """Draw the run-outs of a ladder, which adds the effects of a scene one by one, as bars; return the axis.

    A dotted line marks the run-out with all effects. Without an axis, a new figure is created.
    """
    ax = axis(ax, (9.0, 3.5))
    rungs = list(rungs)
    names = [f"+ {r.added.replace('_', ' ')}" if r.added else "no effect" for r in rungs]
    words = []
    for r in rungs:
        end = "at rest after" if r.arrested else "still moving at"
        words.append(_words(r.run_out, r.peak_velocity, end, r.duration) if r.peak_velocity else STILL)
    _draw_bars(ax, names, [(r.run_out, r.arrested) for r in rungs], words)
    ax.axvline(rungs[-1].run_out, **LINES["help"])
    title(ax, "run-out as effects are added")
    most = amount(rungs[-1].run_out, "m")
    measure(ax.xaxis, "run-out along the arc", "m", f"; dotted: with all effects, {most}")
    return ax
