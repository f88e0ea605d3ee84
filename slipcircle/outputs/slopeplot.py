"""The true section to scale: ground, circle, water, soil; and the least factors of safety over centres."""

from typing import Any

import numpy as np

from slipcircle.motion.motion import Motion
from slipcircle.outputs.plotstyle import AREAS, LINES, axis, ending, finish, number
from slipcircle.scene.search import Critical
from slipcircle.scene.section import Section

_CELLS = 32  # of the map, across
_ON_ARC = 200  # points of an outline


def critical_circle(found: Critical, figure: Any) -> Any:
    """The section with the circle, and the least factor that any circle about each centre has, on an empty figure."""
    from matplotlib.patches import Polygon

    ax, slope, mass = figure.add_subplot(), found.slope, outline(found.slope, found)
    ground, low, high = np.asarray(slope.ground), mass.min(axis=0), np.maximum(mass.max(axis=0), found.centre)
    reach = max(float(np.ptp(mass[:, 0])), 1.2 * float(np.ptp(ground[:, 1]))) * np.array([0.8, 0.4])
    low, high = np.maximum(low - reach, [ground[0, 0], -np.inf]), np.minimum(high + reach, [ground[-1, 0], np.inf])
    ax.add_patch(Polygon(mass, closed=True, label="mass", zorder=2, **AREAS["start"]))
    _scenery(ax, slope, found, 0.4 * float(np.ptp(_angles(found))), f"centre{factors(found)}", low, high)
    _map(ax, found)
    return figure


def slide(motion: Motion, body: Section, ax: Any = None) -> Any:
    """The true section to scale: ground, circle, and the mass at the start, at its peak velocity and at the end.

    Beyond the toe the circle's continuation is assumed: the method turns the mass rigidly about its centre.
    """
    from matplotlib.patches import Polygon

    ax, mass = axis(ax, (9.0, 5.0)), outline(body, body)
    shown = places(motion, f"toe {number(motion.journey.run_out)} m further" if motion.moves else "", " along the arc")
    turned = [body.placed(mass, rotation) for _, rotation, _ in shown]
    low, high = np.min(turned, axis=(0, 1)), np.max(turned, axis=(0, 1))
    for (role, _, words), corners in zip(shown, turned, strict=True):
        ax.add_patch(Polygon(corners, closed=True, label=words, zorder=2, **AREAS[role]))
    words = f"centre; radius {number(float(np.asarray(body.radius)))} m{factors(motion.plan.scene.stability)}"
    margin = 0.25 * float(max(high - low))
    _scenery(ax, body, body, float(motion.end.rotation) if motion.moves else 0.0, words, low - margin, high + margin)
    return ax


def places(motion: Motion, ended: str, along: str = "") -> list[tuple[str, float, str]]:
    """Where the mass is shown, at the start, the end and its peak velocity: role, rotation, and words of a legend."""
    found = [("start", 0.0, "start")]
    if motion.moves:
        peak, end = motion.peak, motion.end
        found.append(("end", float(end.rotation), f"{ending(motion)}: {ended}"))
        if peak.rotation not in (0.0, end.rotation):
            found.append(("peak", float(peak.rotation), f"peak velocity: {number(peak.displacement)} m{along}"))
    return found


def factors(found: Critical | None) -> str:
    """Factors of safety, in the words of a legend."""
    by_method = found.factor_of_safety if found else {}
    known = [f"{method} {v:.3f}" for method, v in by_method.items() if v is not None]
    return "\nfactor of safety: " + ",\n".join(filter(None, [known[0], ", ".join(known[1:])])) if known else ""


def outline(soil: Any, circle: Any) -> Any:
    """The mass of a section or a critical circle: points along its arc, left to right, and back along the ground."""
    first, last = _angles(circle)
    arc = _points(circle, np.linspace(first, last, _ON_ARC))
    ground, (left, right) = np.asarray(soil.ground, dtype=np.float64), sorted((circle.entry[0], circle.exit[0]))
    within = np.hypot(*(ground - circle.centre).T) < (1 - 1e-9) * float(circle.radius)  # also on a scarp
    inner = ground[(ground[:, 0] >= left) & (ground[:, 0] <= right) & within]
    return np.concatenate([arc, inner[::-1]])


def _angles(circle: Any) -> list[float]:
    """Of both ends from straight below the centre, left to right."""
    (cx, cy), ends = circle.centre, (circle.entry, circle.exit)
    return sorted(float(np.arctan2(x - cx, cy - y)) for x, y in ends)


def _points(circle: Any, beta: Any) -> Any:
    turned = np.stack([np.sin(beta), -np.cos(beta)], axis=-1)
    return np.asarray(circle.centre, dtype=np.float64) + float(circle.radius) * turned


def _scenery(ax: Any, soil: Any, circle: Any, turn: float, words: str, low: Any, high: Any) -> None:
    """Ground, soil, water, firm layer, and the circle with its continuation beyond the toe, between two corners."""
    ground, (first, last) = np.asarray(soil.ground, dtype=np.float64), _angles(circle)
    if soil.base is not None:
        low = np.minimum(low, [np.inf, soil.base - 0.05 * float(np.max(high - low))])
        ax.axhline(soil.base, color="0.3", lw=2.5, zorder=3, label="firm layer")
    ax.fill_between(ground[:, 0], ground[:, 1], low[1], color="#EFE6D2", lw=0, zorder=1)
    ax.plot(*ground.T, color="black", lw=1.4, zorder=3, label="ground")
    ax.plot(*_points(circle, np.linspace(first, last, _ON_ARC)).T, zorder=4, label="slip circle", **LINES["main"])
    if turn:
        beyond = last + np.linspace(0.0, turn, 60) if circle.facing >= 0 else first - np.linspace(0.0, turn, 60)
        label = "its continuation beyond the toe, assumed"
        ax.plot(*_points(circle, beyond).T, zorder=4, label=label, **LINES["help"])
    if soil.level is not None:
        level = np.asarray(soil.level, dtype=np.float64)
        x = np.concatenate([[min(low[0], level[0, 0])], level[:, 0], [max(high[0], level[-1, 0])]])
        ax.plot(x, level[[0, *range(len(level)), -1], 1], color="#56B4E9", lw=1.6, zorder=3, label="water level")
    seen = np.all((circle.centre >= low) & (circle.centre <= high))
    ax.plot(*(circle.centre if seen else ([], [])), "k+", ms=9, mew=1.5, zorder=5, ls="", label=words)
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    finish(ax, "$x$ (m)", "$y$ (m)")


def _map(ax: Any, found: Critical) -> None:
    """The least factor of the circles about each centre and its neighbours, up to half more than the least of all."""
    low, high = (np.array(pair) for pair in zip(ax.get_xlim(), ax.get_ylim(), strict=True))
    size = (high[0] - low[0]) / _CELLS
    shape = np.ceil((high - low) / size).astype(int) + 3  # one cell more on every side, and one for what is outside
    cells = np.clip(np.floor((found.centres - low) / size).astype(int) + 1, 0, shape)
    least = np.full(shape + 1, np.inf)
    np.fmin.at(least, tuple(cells.T), found.values)
    least = np.lib.stride_tricks.sliding_window_view(least[1:-1, 1:-1], (3, 3)).min(axis=(2, 3))
    if np.count_nonzero(np.isfinite(least)) < 10:
        return
    x, y = (start + (np.arange(n) + 1.5) * size for start, n in zip(low, least.shape, strict=True))
    levels = float(np.nanmin(found.values)) * np.linspace(1.0, 1.5, 11)
    picture = ax.contourf(
        x, y, np.minimum(least, 9 * levels[-1]).T, levels=levels, cmap="viridis_r", alpha=0.75, zorder=0
    )
    words = f"least factor of safety of circles about a centre ({found.method})"
    ax.figure.colorbar(picture, ax=ax, location="bottom", shrink=0.8, aspect=40, label=words, format="%.2f")
