"""Pictures that compare several motions, or the run-outs of one scene as its effects are added.

The pictures show the farthest positions, velocity and displacement over time, and the run-outs.
"""

from collections.abc import Iterable, Sequence
from functools import partial
from typing import Any

import numpy as np

from slipcircle.core import Motion
from slipcircle.workbench.common.quantities import HISTORY
from slipcircle.workbench.common.trace import columns_of_picture
from slipcircle.workbench.cost.ladder import Rung
from slipcircle.workbench.outputs.pictures.plotstyle import (
    AREAS,
    LINES,
    REST,
    SERIES,
    add_label,
    anchors_along,
    area,
    curve,
    empty,
    ending,
    formatted_amount,
    formatted_number,
    name_rows,
    panel,
)
from slipcircle.workbench.outputs.pictures.sectionplot import surroundings
from slipcircle.workbench.outputs.pictures.shapes import mass_of
from slipcircle.workbench.outputs.pictures.sheets import Drawing, sheet

_MOST_BARS = 24  # greatest number; the other run-outs are summarised in text
STILL = "does not move"
_SECTION = 3.6  # heights in inches
_CURVES = 2.8
_BAR = 0.3
_RUN_OUT = "run-out along the arc", "m"


def comparison_overview(motions: Sequence[Motion]) -> Drawing:
    """Return a picture of several motions; the first eight that move have their own colours and labels."""
    first, *others = (mass_of(motion.plan.scene.arc).outline() for motion in motions)
    has_one_slope = all(other.shape == first.shape and np.allclose(other, first, rtol=1e-9) for other in others)
    sections = [(_SECTION, [partial(_sections, motions)])] * has_one_slope
    names = [motion.plan.scene.name for motion in motions]
    over_time = [partial(curves, motions, names, column) for column in ("velocity", "displacement")]
    height = 0.8 + _BAR * min(len(motions), _MOST_BARS)
    moving = sum(motion.moves for motion in motions)
    rows = [*sections, (_CURVES, over_time), (height, [partial(_run_outs, motions)])]
    return sheet(rows, f"{len(motions)} scenes, of which {moving} move", apart=True)


def _styles(motions: Sequence[Motion]) -> dict[int, tuple[str, Any, str]]:
    """Return colour, dashes and marker of the motions that move, by index in ``motions``; `REST` after the first."""
    moving = [k for k, motion in enumerate(motions) if motion.moves]
    return dict.fromkeys(moving, REST) | dict(zip(moving, SERIES, strict=False))


def _sections(motions: Sequence[Motion], ax: Any) -> Any:
    """Draw the mass at the start and at the run-out of each motion; return the axis."""
    soil = motions[0].plan.scene.arc
    mass = mass_of(soil)
    start = mass.outline()
    ends = {k: mass.outline(float(soil.facing * motions[k].farthest.rotation)) for k in _styles(motions)}
    panel(ax, "farthest positions")
    view = surroundings(ax, mass, soil, [start, *ends.values()])
    area(ax, start, "start")
    for (colour, dashes, _), outline in zip(_styles(motions).values(), ends.values(), strict=True):
        area(ax, outline, "end", edgecolor=colour, ls=dashes, lw=1.6, hatch="", zorder=3)
    add_label(ax, "start", start.mean(axis=0), "0.3", inside=True)
    view.show(ax)
    return ax


def curves(
    motions: Sequence[Motion], names: Sequence[str], column: str, ax: Any = None, notes: Iterable[str] = ()
) -> Any:
    """Draw a column of `HISTORY` over time as a curve for each motion that moves; return the axis.

    ``names`` are the labels of the motions, and ``notes`` lines of text beside the title.
    """
    ax = panel(ax, column, ("time $t$ (s)",), (HISTORY[column].label, HISTORY[column].unit), notes)
    styles = _styles(motions)
    if not styles:
        return empty(STILL, ax, "x", "y")
    for k, style in sorted(styles.items(), key=lambda item: item[1] != REST):
        colour, dashes, _ = style
        times = columns_of_picture(motions[k])["time"]
        values = columns_of_picture(motions[k])[column]
        curve(ax, motions[k], times, values, color=colour, ls=dashes, lw=0.8 if style == REST else 1.5)
        size = np.abs(values)
        is_high = size >= 0.6 * size.max()
        if style != REST and len(motions) > 1:
            add_label(ax, names[k], anchors_along(times[is_high], values[is_high]), colour, parse_math=False)
    ax.margins(y=0.12)
    return ax


def _run_outs(motions: Sequence[Motion], ax: Any) -> Any:
    """Draw run-outs as bars with peak velocities and durations, the greatest if there are many; return the axis."""
    order = sorted(range(len(motions)), key=lambda k: -abs(motions[k].run_out))
    shown = [motions[k] for k in sorted(order[:_MOST_BARS])]
    words = []
    for m in shown:
        speed = abs(float(m.peak.velocity))
        words.append(_words(m.run_out, speed, f"{ending(m)} after", m.settling_time) if m.moves else STILL)
    more = ""
    if hidden := order[_MOST_BARS:]:
        more = f"; {len(hidden)} more, each at most {formatted_amount(abs(motions[hidden[0]].run_out), 'm')}"
    panel(ax, "run-out", (*_RUN_OUT, more))
    _draw_run_outs(ax, [m.plan.scene.name for m in shown], shown, words)
    return ax


def _draw_run_outs(ax: Any, names: Sequence[str], results: Sequence[Motion | Rung], words: Sequence[str]) -> None:
    """Draw a bar for each run-out, styled by whether the mass is at rest, between a name and the outcome in words."""
    name_rows(ax, names)
    for place, result in enumerate(results):
        ax.barh(place, result.run_out, height=0.62, **AREAS["rests" if result.arrested else "moves on"])
    side = ax.secondary_yaxis("right")
    side.set_yticks(range(len(words)), words)
    side.tick_params(length=0, labelsize="small")


def _words(run_out: float, speed: float, end: str, duration: float) -> str:
    """Return text with run-out in m, peak speed in m/s, the description of the end, and duration in s, in order."""
    return (
        f"{formatted_amount(run_out, 'm')}, peak {formatted_amount(speed, 'm/s')}, {end} {formatted_number(duration)} s"
    )


def ladder(rungs: Sequence[Rung], ax: Any = None) -> Any:
    """Draw the run-outs of a ladder, which adds the effects of a scene one by one, as bars; return the axis.

    A dotted line marks the run-out with all effects. Without an axis, a new figure is created.
    """
    most = rungs[-1].run_out
    more = f"; dotted: with all effects, {formatted_amount(most, 'm')}"
    ax = panel(ax, "run-out as effects are added", (*_RUN_OUT, more), size=(9.0, 3.5))
    names = [f"+ {r.added.replace('_', ' ')}" if r.added else "no effect" for r in rungs]
    words = []
    for r in rungs:
        if r.arrested:
            end = "at rest after"
        else:
            end = "still moving at"
        words.append(_words(r.run_out, r.peak_velocity, end, r.duration) if r.peak_velocity else STILL)
    _draw_run_outs(ax, names, rungs, words)
    ax.axvline(most, **LINES["help"])
    return ax
