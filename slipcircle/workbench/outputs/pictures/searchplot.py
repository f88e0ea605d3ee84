"""Picture of a search: the critical circle in its slope, and a map of the least factor over centres."""

from functools import partial
from typing import Any

import numpy as np

from slipcircle.workbench.outputs.pictures.plotstyle import SCENERY, add_label, area, panel, to_scale
from slipcircle.workbench.outputs.pictures.sectionplot import factors_in_words, name_circle, scenery
from slipcircle.workbench.outputs.pictures.shapes import View, mass_of
from slipcircle.workbench.outputs.pictures.sheets import Drawing, heading, sheet
from slipcircle.workbench.stability.critical import Critical
from slipcircle.workbench.stability.factors import YIELD
from slipcircle.workbench.stability.stability import METHODS

_MARGIN = 0.12  # relative to the size of a view
_CONTOURS = 5
_RANGE = 0.4  # range of the colours of a map, relative to the least factor
_CELLS = 24  # number of cells across a map of factors
_VALLEY = 0.05  # range of factors inside the frame of a map, relative to the least factor
_TALL = 1.4  # greatest height over width


def critical_circle(critical: Critical, ax: Any) -> Any:
    """Draw the section with its circle, and contours of the least factor of the circles tried about each centre."""
    from matplotlib.patheffects import withStroke

    mass = mass_of(critical, critical.slope)
    outline = mass.outline()
    outcome = _outcome(critical)
    if outcome:
        words = f"critical circle by {_whose(critical)}: {outcome}"
    else:
        words = "given circle"
    panel(ax, words, notes=[factors_in_words(critical), "", ""])
    area(ax, outline, "start")
    view = View.around(outline, mass.centre)
    view = view.grown(2 * _MARGIN * view.size, _MARGIN * view.size)
    first, last = mass.ground[[0, -1], 0]
    view = view._replace(left=max(view.left, first), right=min(view.right, last))
    view = _map(critical, ax, scenery(ax, mass, critical.slope, view))
    add_label(ax, "mass", outline.mean(axis=0), "0.3", inside=True)
    name_circle(ax, mass, critical.slope)
    if view.holds(mass.centre):
        (cross,) = ax.plot(*mass.centre, **SCENERY["centre"])
        cross.set_path_effects([withStroke(linewidth=3.5, foreground="white")])  # visible on a dark map
        add_label(ax, f"centre{outcome and f', {outcome}'}", mass.centre)
    view.show(ax)
    to_scale(ax)
    ax.set_aspect("equal", adjustable="box")
    return ax


def search_overview(named: tuple[str, Critical]) -> Drawing:
    """Return a picture of a critical circle under the name of its slope, given as pair of name and circle."""
    name, critical = named
    return sheet([(7.0, [partial(critical_circle, critical)])], heading(name, ""))


def _outcome(critical: Critical) -> str:
    """Return the least factor of safety or yield coefficient as text; empty for a given circle."""
    if critical.method == YIELD:
        return f"$k_y$ = {critical.yield_coefficient:.3f}"
    if critical.method:
        return f"$F$ = {critical.factors_of_safety[critical.method]:.3f}"
    return ""


def _whose(critical: Critical) -> str:
    """Return the name of the method that was minimised."""
    return METHODS.get(critical.method, METHODS["paper"])[0]


def _map(critical: Critical, ax: Any, view: View) -> View:
    """Draw a map of the least factor of all circles with centres in a cell, darkest at the minimum; return the view.

    The view is extended to all centres with factors up to `_VALLEY` above the least, but is at most `_TALL` times as
    high as wide.
    """
    from matplotlib.ticker import ScalarFormatter

    is_valid = np.isfinite(critical.values)
    centres, values = critical.centres[is_valid], critical.values[is_valid]
    if values.size <= 10:
        return view
    least = float(values.min())
    bottom = view.bottom
    view = View.around(centres[values <= (1.0 + _VALLEY) * least], (view.left, bottom), (view.right, view.top))
    view = view._replace(top=min(view.top, bottom + _TALL * view.width))
    most = min(float(values.max()), least + max(_RANGE * abs(least), 0.05))
    drawn = view.holds(centres) & (values < most)
    cell = view.width / _CELLS
    view = view.grown(cell, cell)._replace(bottom=bottom)  # the outermost cells are complete
    cells = ax.hexbin(
        *centres[drawn].T,
        values[drawn],
        gridsize=_CELLS,
        reduce_C_function=np.min,
        extent=(view.left, view.right, view.bottom, view.top),
        vmin=least,
        vmax=most,
        cmap="viridis",
        lw=0.1,
        zorder=0,
    )
    _contours(ax, cells, least, most)
    if critical.method == YIELD:
        quantity = "yield coefficient"
    else:
        quantity = "factor of safety"
    words = f"least {quantity} of the circles tried about each centre, up to {most:.3g}, by {_whose(critical)}"
    ax.figure.colorbar(
        cells, ax=ax, location="bottom", shrink=0.8, aspect=40, label=words, format=ScalarFormatter(useOffset=False)
    )
    return view


def _contours(ax: Any, cells: Any, least: float, most: float) -> None:
    """Draw contours of round values between ``least`` and ``most`` over the cells of a map, with their values."""
    from matplotlib.artist import setp
    from matplotlib.patheffects import withStroke
    from matplotlib.ticker import MaxNLocator
    from matplotlib.tri import Triangulation

    x, y = np.asarray(cells.get_offsets()).T
    levels = [level for level in MaxNLocator(_CONTOURS).tick_values(least, most) if least < level < most]
    if len(x) > 3 and levels and np.ptp(x) and np.ptp(y):
        lines = ax.tricontour(Triangulation(x, y), cells.get_array(), levels, colors="white", linewidths=0.8)
        outline = withStroke(linewidth=2.0, foreground="0.2")  # legible beyond the cells
        setp(ax.clabel(lines, fontsize="small"), path_effects=[outline])
