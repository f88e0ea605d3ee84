"""The price list as a picture: error against time, and error over alpha."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.workbench.cost.cost import FRONTIER, Profile, Row
from slipcircle.workbench.cost.reference import HALF_PI
from slipcircle.workbench.outputs.plotstyle import LINES, MEASURED, REST, SERIES, WIDTH, axis, label

_BEST = 1e-19  # ends of the axis of errors; errors beyond are drawn there
_NONE = 10.0
_DECADES = 16.5  # of alpha, towards each end
_BINS = 90
_OURS = {"marker": "o", "color": LINES["main"]["color"]}
_OTHERS = {"marker": "s", "color": LINES["other"]["color"], "mfc": "white"}


def overview(rows: Sequence[Row], figure: Any) -> None:
    """Rows of any functions on an empty figure of `size`, of each its frontier above its errors."""
    names = list(dict.fromkeys(row.function for row in rows))
    panels = figure.subplots(2 * len(names), 1)
    for name, above, below in zip(names, panels[::2], panels[1::2], strict=True):
        of_function = [row for row in rows if row.function == name]
        frontier(of_function, above)
        over_alpha(of_function, below)


def size(rows: Sequence[Row]) -> tuple[float, float]:
    """Inches of the overview."""
    return WIDTH, 9.5 * len({row.function for row in rows})


def frontier(rows: Sequence[Row], ax: Any = None) -> Any:
    """Error against time, with the frontier drawn; ways bear their number in the table, those on it names."""
    axes = axis(ax, (9.0, 5.5))
    front = [row for row in rows if row.verdict == FRONTIER]
    front.sort(key=lambda row: row.price)
    prices = [row.price for row in front]
    heights = [_height(row) for row in front]
    least_errors = np.minimum.accumulate(heights)  # ways that take about as long are on it too
    broad: dict[str, Any] = {"color": "0.75", "lw": 5, "zorder": 1, "solid_capstyle": "round"}
    axes.step(prices, least_errors, where="post", label="frontier", **broad)
    for number, row in enumerate(rows, 1):
        _mark(axes, row, number)
    axes.plot([], [], ls="", label="ours, worst seen; a bar up to what is proved", **_OURS)
    axes.plot([], [], ls="", label="others, worst seen", **_OTHERS)
    per = "an element at N = 1e4" if rows[0].ns_1e4 else "a solution"
    axes.set(xscale="log", yscale="log", ylim=(None, _NONE * 2))
    axes.set(xlabel=f"time of {per}, ns", ylabel="worst relative error")
    axes.margins(x=0.2)
    axes.grid(alpha=0.3)
    axes.set_title(rows[0].function, loc="left", fontweight="bold")
    axes.legend(fontsize="small", loc="lower right")
    return axes


def _mark(axes: Any, row: Row, number: int) -> None:
    """A way at its time and error, by its name where it is on the frontier; one without an error at its time."""
    if np.isnan(row.error):
        axes.axvline(row.price, color="0.3", ls=":", lw=1.2, label=row.way)
        return
    height = _height(row)
    marker = _OURS if row.ours else _OTHERS
    axes.plot(row.price, height, ls="", **marker)
    name = row.way if row.verdict == FRONTIER else str(number)
    label(axes, name, (row.price, height), gid=MEASURED)
    if row.bound is not None:
        prices = [row.price, row.price]
        errors = [height, row.bound]
        axes.plot(prices, errors, "-_", color=_OURS["color"], lw=1)


def _height(row: Row) -> float:
    return float(np.clip(row.error, _BEST, _NONE))


def both_ends(alpha: Floats) -> Floats:
    """A coordinate that is logarithmic at 0 and at pi/2: decades of the distance to the nearer end, 0 at pi/4."""
    half_pi, remainder = HALF_PI
    middle = half_pi / 2
    to_right_angle = np.maximum((half_pi - alpha) + remainder, remainder)
    nearer = np.minimum(alpha, to_right_angle) / middle
    with np.errstate(divide="ignore"):
        decades = np.log10(nearer)
    return np.copysign(decades, alpha - middle)


def _worst_in_bins(profile: Profile) -> tuple[Floats, Floats]:
    """Middles of bins of `both_ends` and the worst error in each, where there is one."""
    edges = np.linspace(-_DECADES, _DECADES, _BINS + 1)
    places = both_ends(profile.points)
    bins = np.digitize(places, edges) - 1
    is_inside = (bins >= 0) & (bins < _BINS)
    filled = bins[is_inside]
    errors_inside = profile.relative[is_inside]
    worst = np.zeros(_BINS)
    np.maximum.at(worst, filled, errors_inside)
    has_points = worst > 0.0
    middles = (edges[1:] + edges[:-1]) / 2
    errors = np.clip(worst, _BEST, _NONE)
    return middles[has_points], errors[has_points]


def over_alpha(rows: Sequence[Row], ax: Any = None) -> Any:
    """Relative error over alpha, logarithmic towards both ends, with what is proved as a thin line; off if unknown.

    Eight ways have a colour, the printed one and ours first; the others are grey.
    """
    axes = axis(ax, (9.0, 5.5))
    known = [row for row in rows if row.profile is not None]
    if not known:
        axes.set_axis_off()
        return axes
    # Times do not choose them: another run has the same colours.
    known.sort(key=lambda row: (not row.way.startswith("printed"), not row.ours, "fused" not in row.way))
    others = known[len(SERIES) :]
    for row in others:
        _draw_profile(axes, row, REST)
    if others:
        axes.plot([], [], color=REST[0], label=f"{len(others)} others")
    for row, style in zip(known, SERIES, strict=False):
        _draw_profile(axes, row, style, row.way)
    _tick_both_ends(axes)
    axes.set(yscale="log", xlim=(-_DECADES, _DECADES), ylim=(_BEST, _NONE * 2))
    axes.set(xlabel="alpha, rad", ylabel="relative error, worst in each bin (thin: proved)")
    axes.grid(alpha=0.3)
    axes.legend(fontsize="small", ncols=2, loc="upper right")
    return axes


def _tick_both_ends(axes: Any) -> None:
    """Ticks at powers of ten from both ends, and in the middle."""
    places, words = [0.0], ["$\\pi/4$"]
    for power in (16, 12, 8, 4):
        place = float(both_ends(np.array(10.0**-power)))
        distance = f"$10^{{-{power}}}$"
        places += [place, -place]
        words += [distance, f"$\\pi/2 -$\n{distance}"]
    axes.set_xticks(places, words)


def _draw_profile(axes: Any, row: Row, style: tuple[str, Any, str], label: str | None = None) -> None:
    """The errors of a way over alpha, and the bound that is proved where it has a colour."""
    colour, dashes, _ = style
    if row.profile is not None:
        middles, worst = _worst_in_bins(row.profile)
        width = 2 if row.ours else 1
        axes.plot(middles, worst, color=colour, ls=dashes, lw=width, label=label)
    if label and row.bound is not None:
        axes.axhline(row.bound, color=colour, lw=0.8)
