"""The true section to scale: ground, circle, water, soil; and the least factors of safety over centres."""

from typing import Any

import numpy as np

from slipcircle.motion.motion import Motion
from slipcircle.outputs.plotstyle import AREAS, LINES, axis, ending, legend, number, sheet
from slipcircle.scene.search import Critical
from slipcircle.scene.section import Section
from slipcircle.scene.stability import METHODS, Slope

_CELLS = 48  # of the map, across
_ON_ARC = 200  # points of an outline


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


def slide(motion: Motion, body: Section, ax: Any = None) -> Any:
    """The true section to scale: ground, circle, and the mass at the start, at its peak velocity and at the end.

    Beyond the toe the circle's continuation is assumed: the method turns the mass rigidly about its centre.
    """
    from matplotlib.patches import Polygon

    ax = axis(ax, (9.0, 5.0))
    ground, mass = np.asarray(body.ground, dtype=np.float64), outline(body)
    places = [("start", 0.0, "start")]
    if motion.moves:
        peak, end = motion.peak, motion.end
        places.append(("end", float(end.rotation), f"{ending(motion)}: toe {number(motion.journey.run_out)} m further"))
        if peak.rotation not in (0.0, end.rotation):
            places.append(("peak", float(peak.rotation), f"peak velocity: {number(peak.displacement)} m along the arc"))
    turned = {role: body.placed(mass, rotation) for role, rotation, _ in places}
    corners = np.concatenate(list(turned.values()))
    low, high = corners.min(axis=0), corners.max(axis=0)
    margin = 0.25 * float(max(high - low))
    ax.fill_between(ground[:, 0], ground[:, 1], low[1] - 2 * margin, color="#EFE6D2", lw=0, zorder=1)
    for role, _, words in places:
        ax.add_patch(Polygon(turned[role], closed=True, label=words, zorder=2, **AREAS[role]))
    ax.plot(*ground.T, color="black", lw=1.4, zorder=3, label="ground")
    if body.level is not None:
        _water(ax, body.level, (ground[0, 0], ground[-1, 0]))
    toe, (cx, cy) = np.asarray(body.exit), np.asarray(body.centre, dtype=np.float64)
    ax.plot(*mass[:_ON_ARC].T, zorder=4, label="slip circle", **LINES["main"])
    if motion.moves:
        on = np.stack([body.placed(toe, turn) for turn in np.linspace(0.0, float(end.rotation), 60)])
        ax.plot(*on.T, zorder=4, label="its continuation beyond the toe, assumed", **LINES["help"])
    if cy <= high[1] + margin:
        words = f"centre; radius {number(float(np.asarray(body.radius)))} m"
        ax.plot(cx, cy, "k+", ms=9, mew=1.5, zorder=5, ls="", label=words)
    ax.set(xlim=(low[0] - margin, high[0] + margin), ylim=(low[1] - margin, high[1] + margin))
    ax.set(xlabel="$x$ (m)", ylabel="$y$ (m)")
    ax.set_aspect("equal")
    ax.grid(alpha=0.3)
    legend(ax)
    return ax


def outline(body: Section) -> Any:
    """The mass of a section at the start: points along its arc, left to right, and back along the ground."""
    (left, right), centre = sorted([tuple(body.entry), tuple(body.exit)]), np.asarray(body.centre, dtype=np.float64)
    first, last = (np.arctan2(x - centre[0], centre[1] - y) for x, y in (left, right))
    beta = np.linspace(first, last, _ON_ARC)
    arc = centre + float(np.asarray(body.radius)) * np.stack([np.sin(beta), -np.cos(beta)], axis=1)
    return np.concatenate([arc, body.surface[-2:0:-1]])


def _water(ax: Any, level: Any, view: tuple[float, float]) -> None:
    """A water level, which goes on horizontally beyond its ends."""
    x, y = np.asarray(level, dtype=np.float64).T
    x = np.concatenate([[min(view[0], x[0])], x, [max(view[1], x[-1])]])
    ax.plot(x, np.concatenate([y[:1], y, y[-1:]]), color="#56B4E9", lw=1.6, zorder=3, label="water level")


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
        _water(ax, slope.level, view)
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
