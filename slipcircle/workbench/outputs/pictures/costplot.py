"""Picture of the cost of accuracy: error against time."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from slipcircle.workbench.cost.rows import BEATEN, RECOMMENDED, CostRow
from slipcircle.workbench.outputs.pictures.plotstyle import MARKS, MEASURED, SERIES, add_label, legend, panel

SIZE = (8.6, 5.0)  # inches
_LEAST, _NONE = 1e-17, 1.0  # ends of the axis of errors; errors beyond are drawn there


def frontier(rows: Sequence[CostRow], ax: Any = None) -> Any:
    """Draw error against time by group, with the name of each way; return the axis.

    A line connects the ways on the frontier, and a bar extends from each error to its bound.
    """
    axes = panel(ax, "", ("processor time of one (s)",), ("largest relative error; bar: up to the bound",), size=SIZE)
    axes.set(xscale="log", yscale="log")
    for group, style in zip(dict.fromkeys(row.group for row in rows), SERIES, strict=False):
        _group([row for row in rows if row.group == group], style, axes)
    axes.margins(x=0.2, y=0.1)
    legend(axes, 3)
    return axes


def _group(rows: Sequence[CostRow], style: tuple[str, Any, str], axes: Any) -> None:
    """Draw the ways of a group, given as rows; ``style`` has colour, dashes and marker."""
    colour, dashes, marker = style
    for row in rows:
        ends = [row.error, row.error if row.bound is None else row.bound]
        height, bound = np.clip(ends, _LEAST, _NONE)
        beaten = row.verdict.startswith(BEATEN)
        axes.plot(row.seconds, height, marker, color=colour, mfc="white" if beaten else colour, zorder=4)
        if row.bound is not None:
            axes.plot([row.seconds, row.seconds], [height, bound], "-_", color=colour, lw=0.8)
        if row.verdict == RECOMMENDED:
            axes.plot(row.seconds, height, "o", ms=16, mfc="none", mec=MARKS["peak"]["color"], mew=2, label=RECOMMENDED)
        add_label(axes, row.way, (row.seconds, height), colour, gid=MEASURED)
    front = sorted((row.seconds, row.error) for row in rows if not row.verdict.startswith(BEATEN))
    seconds, errors = np.transpose(front)
    name = f"{rows[0].group}, filled on the frontier"
    heights = np.clip(errors, _LEAST, _NONE)
    axes.plot(seconds, heights, color=colour, ls=dashes, lw=1.2, label=name, marker=marker)
