"""Picture of a search: the critical circle in its slope, and a map of the least factor over centres."""

from typing import Any

import numpy as np

from slipcircle.workbench.outputs.plotstyle import SCENERY, area, label, note, to_scale
from slipcircle.workbench.outputs.sectionplot import factors_in_words, name_circle, scenery
from slipcircle.workbench.outputs.shapes import View, mass_of
from slipcircle.workbench.stability.critical import Critical
from slipcircle.workbench.stability.factors import YIELD
from slipcircle.workbench.stability.stability import METHODS

_CELLS = 30  # of the map of factors, across
_VALLEY = 0.05  # factors in the frame of a map, relative to the least one
_TALL = 1.4  # greatest height over width


def critical_circle(critical: Critical, ax: Any) -> Any:
    """The section with the circle, and the least factor of all circles about each centre."""
    from matplotlib.patheffects import withStroke

    mass = mass_of(critical, critical.slope)
    outline = mass.outline()
    area(ax, outline, "start")
    width = float(np.ptp(outline[:, 0]))
    height = float(np.ptp(mass.ground[:, 1]))
    reach = max(width, 1.2 * height)
    view = View.around(outline, mass.centre).grown(0.8 * reach, 0.4 * reach)
    first, last = mass.ground[[0, -1], 0]
    view = view._replace(left=max(view.left, first), right=min(view.right, last))
    view = scenery(ax, mass, critical.slope, view, [outline])
    view = _map(critical, ax, view)
    label(ax, "mass", outline.mean(axis=0), "0.3", inside=True)
    name_circle(ax, mass, critical.slope)
    if view.holds(mass.centre):
        (cross,) = ax.plot(*mass.centre, **SCENERY["centre"])
        cross.set_path_effects([withStroke(linewidth=3.5, foreground="white")])  # visible on a dark map
        label(ax, "centre", mass.centre)
    view.show(ax)
    note(ax, [factors_in_words(critical)])
    to_scale(ax, "$x$ (m)", "$y$ (m)")
    ax.set_aspect("equal", adjustable="box")
    return ax


def _map(critical: Critical, ax: Any, view: View) -> View:
    """Map of the least factor of all circles with centres in a cell, darkest at the minimum.

    The frame is extended to all centres with factors up to `_VALLEY` above the least, but is at most `_TALL` times as
    high as wide, and is returned; the scale ends at the least factor of a centre outside.
    """
    from matplotlib.ticker import ScalarFormatter

    known = np.isfinite(critical.values)
    centres, values = critical.centres[known], critical.values[known]
    if values.size <= 10:
        return view
    least = float(values.min())
    bottom = view.bottom
    valley = centres[values <= (1.0 + _VALLEY) * least]
    view = View.around(valley, (view.left, bottom), (view.right, view.top))
    highest = bottom + _TALL * (view.right - view.left)
    view = view._replace(top=min(view.top, highest))
    inside = view.holds(centres)
    most = min(float(values[~inside].min(initial=np.inf)), least + max(0.5 * abs(least), 0.05))
    drawn = inside & (values < most)
    cell = (view.right - view.left) / _CELLS
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
    words = _scale_label(critical.method, most)
    ax.figure.colorbar(
        cells, ax=ax, location="bottom", shrink=0.8, aspect=40, label=words, format=ScalarFormatter(useOffset=False)
    )
    return view


def _scale_label(method: str, most: float) -> str:
    quantity = "yield coefficient" if method == YIELD else "factor of safety"
    whose = METHODS.get(method, METHODS["paper"])[0]
    return f"least {quantity} of the circles about each centre, up to {most:.3g}, by {whose}"
