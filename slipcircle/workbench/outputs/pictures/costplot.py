"""Picture of the cost of accuracy: error against time."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from slipcircle.workbench.cost.rows import BEATEN, RECOMMENDED, Row
from slipcircle.workbench.outputs.pictures.plotstyle import MARKS, MEASURED, SERIES, axis, label, legend

SIZE = (8.6, 5.0)  # inches
_LEAST, _NONE = 1e-17, 1.0  # ends of the axis of errors; errors beyond are drawn there


def frontier(rows: Sequence[Row], ax: Any = None) -> Any:
    """Draw error against time by group, with the name of each way; return the axis.

    A line connects the ways on the frontier, and a bar extends from each error to its bound.
    """
    axes = axis(ax, SIZE)
    for group, style in zip(dict.fromkeys(row.group for row in rows), SERIES, strict=False):
        _group([row for row in rows if row.group == group], style, axes)
    axes.set(
        xscale="log",
        yscale="log",
        xlabel="processor time of one (s)",
        ylabel="largest relative error; bar: up to the bound",
    )
    axes.margins(x=0.2, y=0.1)
    axes.grid(alpha=0.3)
    legend(axes, 3)
    return axes


def _group(rows: Sequence[Row], style: tuple[str, Any, str], axes: Any) -> None:
    """Draw the ways of a group."""
    colour, dashes, marker = style
    for row in rows:
        height = _height(row.error)
        beaten = row.verdict.startswith(BEATEN)
        axes.plot(row.seconds, height, marker, color=colour, mfc="white" if beaten else colour, zorder=4)
        if row.bound is not None:
            axes.plot([row.seconds, row.seconds], [height, _height(row.bound)], "-_", color=colour, lw=0.8)
        if row.verdict == RECOMMENDED:
            axes.plot(row.seconds, height, "o", ms=16, mfc="none", mec=MARKS["peak"]["color"], mew=2, label=RECOMMENDED)
        label(axes, row.way, (row.seconds, height), colour, gid=MEASURED)
    front = [row for row in rows if not row.verdict.startswith(BEATEN)]
    front.sort(key=lambda row: row.seconds)
    heights = [_height(row.error) for row in front]
    name = f"{rows[0].group}, filled on the frontier"
    axes.plot([row.seconds for row in front], heights, color=colour, ls=dashes, lw=1.2, label=name, marker=marker)


def _height(error: float) -> float:
    return float(np.clip(error, _LEAST, _NONE))
