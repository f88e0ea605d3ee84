"""The true section to scale: ground, circle, water, soil; and the least factors of safety over centres."""

from typing import Any

import numpy as np

from slipcircle.outputs.plotstyle import AREAS, LINES, axis, legend, sheet
from slipcircle.scene.stability import METHODS, Slope
from slipcircle.studies.search import Critical

_CELLS = 48  # of the map, across


def searched(slope: Slope, found: Critical, figure: Any = None) -> Any:
    """The section with the circle, and the least factor that any circle about each centre has.

    Returns
    -------
    matplotlib figure
    """
    figure = sheet(figure, (9.0, 6.0))
    ax = section(slope, found, figure.add_subplot())
    x, y = found.centres.T
    good = np.isfinite(found.values)
    low, high = np.array(ax.get_xlim()), np.array(ax.get_ylim())
    near = good & (x >= low[0]) & (x <= low[1]) & (y >= high[0]) & (y <= high[1])
    if np.count_nonzero(near) > 10:
        size = (low[1] - low[0]) / _CELLS
        rows = max(2, int((high[1] - high[0]) / size))
        column = np.minimum(((x[near] - low[0]) / size).astype(int), _CELLS - 1)
        row = np.minimum(((y[near] - high[0]) / size).astype(int), rows - 1)
        least = np.full((rows, _CELLS), np.inf)
        np.minimum.at(least, (row, column), found.values[near])
        bottom = float(np.nanmin(found.values))
        shown = np.ma.masked_greater(least, 2.0 * bottom)
        picture = ax.imshow(shown, origin="lower", extent=(*low, high[0], high[0] + rows * size), cmap="viridis_r",
                            alpha=0.75, zorder=0, interpolation="nearest")  # fmt: skip
        figure.colorbar(picture, ax=ax, label=f"least factor of safety of circles about a centre ({found.method})")
        ax.set(xlim=low, ylim=high)
    return figure


def section(slope: Slope, found: Critical, ax: Any = None) -> Any:
    """Ground, soil, water, the circle with its continuation beyond the toe, and the mass.

    Returns
    -------
    matplotlib axis
        In metres, to scale.
    """
    ax = axis(ax, (9.0, 5.0))
    ground = np.asarray(slope.ground)
    (cx, cy), r = found.centre, found.radius
    (left, low), (right, high) = sorted((found.entry, found.exit))
    first, last = np.arctan2(left - cx, cy - low), np.arctan2(right - cx, cy - high)
    beta = np.linspace(first, last, 200)
    arc = np.stack([cx + r * np.sin(beta), cy - r * np.cos(beta)], axis=1)
    reach = max(right - left, 1.2 * float(np.ptp(ground[:, 1])))
    view = max(ground[0, 0], left - reach / 2), min(ground[-1, 0], right + reach / 2)
    floor = min(arc[:, 1].min(), ground[:, 1].min()) - 0.25 * reach
    floor = floor if slope.base is None else min(floor, slope.base - 0.05 * reach)
    ax.fill_between(ground[:, 0], ground[:, 1], floor, color="#EFE6D2", lw=0, zorder=1)
    inner = ground[(ground[:, 0] > left) & (ground[:, 0] < right)]
    ax.fill(*np.concatenate([arc, [arc[-1]], inner[::-1]]).T, zorder=2, label="mass", **AREAS["start"])
    ax.plot(*ground.T, color="black", lw=1.4, zorder=3, label="ground")
    ax.plot(*arc.T, zorder=4, label="slip circle", **LINES["main"])
    ahead = (last, last + 0.4 * (last - first)) if found.facing >= 0 else (first, first - 0.4 * (last - first))
    beyond = np.linspace(*ahead, 60)
    ax.plot(
        cx + r * np.sin(beyond), cy - r * np.cos(beyond), zorder=4, label="its continuation, assumed", **LINES["help"]
    )
    if slope.level is not None:
        level = np.asarray(slope.level)
        wide = np.concatenate([[[view[0], level[0, 1]]], level, [[view[1], level[-1, 1]]]])
        wide = wide[np.argsort(wide[:, 0], kind="stable")] if level[0, 0] > view[0] or level[-1, 0] < view[1] else level
        ax.plot(*wide.T, color="#56B4E9", lw=1.6, zorder=3, label="water level")
    if slope.base is not None:
        ax.axhline(slope.base, color="0.3", lw=2.5, zorder=3, label="firm layer")
    words = ", ".join(f"{m} {v:.3f}" for m in METHODS if (v := found.factor_of_safety[m]) is not None)
    ax.plot(cx, cy, "k+", ms=9, mew=1.5, zorder=5, ls="", label=f"centre; factor of safety: {words}")
    ax.set(
        xlim=view, ylim=(floor, max(cy + 0.3 * r, ground[:, 1].max() + 0.1 * reach)), xlabel="$x$ (m)", ylabel="$y$ (m)"
    )
    ax.set_aspect("equal")
    legend(ax)
    return ax
