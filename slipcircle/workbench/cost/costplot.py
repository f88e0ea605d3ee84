"""The price list as a picture: error against time, and error over alpha."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from slipcircle.workbench.cost.cost import FRONTIER, Profile, Row
from slipcircle.workbench.cost.reference import HALF_PI, Floats
from slipcircle.workbench.outputs.plotstyle import LINES, axis

_BEST, _NONE = 1e-19, 10.0  # the axis of errors ends here; what lies beyond is drawn at its ends
_DECADES, _BINS = 16.5, 90  # of alpha, towards each end
_OURS = {"marker": "o", "color": LINES["main"]["color"]}
_OTHERS = {"marker": "s", "color": LINES["other"]["color"], "mfc": "white"}


def overview(rows: Sequence[Row], figure: Any) -> None:
    """Rows of any functions on an empty figure of `size`."""
    functions = [[r for r in rows if r.function == name] for name in dict.fromkeys(row.function for row in rows)]
    lines = figure.subplots(len(functions), 2, squeeze=False)
    for (left, right), of_function in zip(lines, functions, strict=True):
        frontier(of_function, left)
        over_alpha(of_function, right)


def size(rows: Sequence[Row]) -> tuple[float, float]:
    """Inches of the overview."""
    return 19.0, 6.0 * len({row.function for row in rows})


def frontier(rows: Sequence[Row], ax: Any = None) -> Any:
    """Error against time, with the frontier drawn; ways bear their number in the table, those on it names."""
    axes = axis(ax, (9.0, 5.5))
    front = sorted((r for r in rows if r.verdict == FRONTIER), key=lambda r: r.price)
    axes.step(
        [r.price for r in front],
        [_height(r) for r in front],
        where="post",
        color="0.75",
        lw=5,
        zorder=1,
        solid_capstyle="round",
        label="frontier",
    )
    for number, r in enumerate(rows, 1):
        if r.error != r.error:
            axes.axvline(r.price, color="0.3", ls=":", lw=1.2, label=r.way)
            continue
        axes.plot(r.price, _height(r), ls="", **(_OURS if r.ours else _OTHERS))
        name = r.way if r.verdict == FRONTIER else str(number)
        axes.annotate(name, (r.price, _height(r)), (6, 4), textcoords="offset points", fontsize=8)
        if r.bound is not None:
            axes.plot([r.price] * 2, [_height(r), r.bound], "-_", color=_OURS["color"], lw=1)
    axes.plot([], [], ls="", label="ours, worst seen; a bar up to what is proved", **_OURS)
    axes.plot([], [], ls="", label="others, worst seen", **_OTHERS)
    axes.set(
        xscale="log",
        yscale="log",
        ylabel="worst relative error",
        ylim=(None, _NONE * 2),
        xlabel=f"time of {'an element at N = 1e4' if rows[0].ns_1e4 else 'a solution'}, ns",
    )
    axes.margins(x=0.2)
    axes.grid(alpha=0.3)
    axes.set_title(rows[0].function, loc="left", fontweight="bold")
    axes.legend(fontsize=8)
    return axes


def _height(row: Row) -> float:
    return float(np.clip(row.error, _BEST, _NONE))


def both_ends(alpha: Floats) -> Floats:
    """A coordinate that is logarithmic at 0 and at pi/2: decades of the distance to the nearer end, 0 at pi/4."""
    rest = np.maximum((HALF_PI[0] - alpha) + HALF_PI[1], HALF_PI[1])
    nearer = np.minimum(alpha, rest) / (HALF_PI[0] / 2)
    with np.errstate(divide="ignore"):
        return np.copysign(np.log10(nearer), alpha - HALF_PI[0] / 2)


def _worst_in_bins(profile: Profile) -> tuple[Floats, Floats]:
    """Middles of bins of `both_ends` and the worst error in each, where there is one."""
    edges = np.linspace(-_DECADES, _DECADES, _BINS + 1)
    places = np.digitize(both_ends(profile.points), edges) - 1
    worst = np.array([np.max(profile.relative[places == k], initial=0.0) for k in range(_BINS)])
    middles = (edges[1:] + edges[:-1]) / 2
    return middles[worst > 0], np.clip(worst[worst > 0], _BEST, _NONE)


def over_alpha(rows: Sequence[Row], ax: Any = None) -> Any:
    """Relative error over alpha, logarithmic towards both ends, with what is proved as a thin line; off if unknown."""
    axes = axis(ax, (9.0, 5.5))
    known = [(row, row.profile) for row in rows if row.profile is not None]
    if not known:
        axes.set_axis_off()
        return axes
    for k, (row, profile) in enumerate(known):
        style = ("-", "--", ":", "-.")[k // 10 % 4]
        (line,) = axes.plot(*_worst_in_bins(profile), ls=style, lw=2 if row.ours else 1, label=row.way)
        if row.bound is not None:
            axes.axhline(row.bound, color=line.get_color(), lw=0.8)
    near = {f"$10^{{-{k}}}$": float(both_ends(np.array(10.0**-k))) for k in (16, 12, 8, 4)}
    axes.set_xticks(
        [*near.values(), 0, *(-x for x in near.values())],
        [*near, "$\\pi/4$", *(f"$\\pi/2 -$\n{word}" for word in near)],
    )
    axes.set(
        yscale="log",
        xlim=(-_DECADES, _DECADES),
        ylim=(_BEST, _NONE * 2),
        xlabel="alpha, rad",
        ylabel="relative error, worst in each bin (thin: proved)",
    )
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8, ncols=2)
    return axes
