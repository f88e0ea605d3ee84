"""Pictures as rows of panels below each other. Under a title the panels are lettered."""

from collections.abc import Callable, Sequence
from functools import partial
from textwrap import shorten
from typing import Any, NamedTuple

from slipcircle.base.kinds import Function, Pair
from slipcircle.workbench.outputs.pictures.plotstyle import WIDTH, letter

_TITLE = 0.4  # inches
_COLUMNS = 2
Row = tuple[float, Sequence[Callable[..., Any]]]  # height in inches; one panel or two, functions that draw on ``ax``


class Drawing(NamedTuple):
    """Function that draws a picture on an empty figure and returns the figure, and the size of the figure in inches."""

    draw: Function
    size: Pair


def sheet(rows: Sequence[Row], title: str = "", apart: bool = False) -> Drawing:
    """Return a picture of rows of panels; if ``apart``, labels beside one row do not narrow the other rows."""
    heights = [height for height, _ in rows]
    return Drawing(partial(_draw, rows, title, apart), (WIDTH, sum(heights) + _TITLE * bool(title)))


def _draw(rows: Sequence[Row], title: str, apart: bool, figure: Any) -> Any:
    """Draw rows of panels on an empty figure and return the figure; the arguments are those of `sheet`."""
    grid = figure.add_gridspec(len(rows), _COLUMNS, height_ratios=[height for height, _ in rows])
    axes = []
    for row, (_, panels) in enumerate(rows):
        host = figure
        cells = grid
        place = row
        if apart:
            host = figure.add_subfigure(grid[row, :])
            cells = host.add_gridspec(1, _COLUMNS)
            place = 0
        for column, draw in enumerate(panels):
            spec = cells[place, column if len(panels) > 1 else slice(None)]
            axes.append(draw(ax=host.add_subplot(spec)))
    if title:
        letter(axes)
        figure.suptitle(title, parse_math=False, fontweight="bold")
    return figure


def heading(name: str, outcome: str) -> str:
    """Return a scene's name and its outcome as the title of a picture."""
    name = shorten(name, 80)
    return ": ".join(filter(None, (name[:1].upper() + name[1:], outcome)))
