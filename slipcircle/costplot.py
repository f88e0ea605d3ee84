"""The price list as a picture: error against time, error over alpha, and how the errors are distributed."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from slipcircle.cost import FRONTIER, Row
from slipcircle.reference import HALF_PI, Floats

_BEST, _NONE = 1e-19, 10.0  # the axis of errors ends here; what lies beyond is drawn at its ends
_ENDS = 16.5  # decades of the axis of alpha at both ends
_BINS = 90
# Okabe and Ito's colours, told apart by the colour-blind, in an order in which their greys differ too.
_COLOURS = ("#0072B2", "#D55E00", "#000000", "#E69F00", "#CC79A7", "#009E73", "#56B4E9", "#999999")
_DASHES = ("-", (0, (5, 1.5)), (0, (1, 1)), (0, (6, 1, 1, 1)), (0, (3, 1, 1, 1, 1, 1)), (0, (8, 3)), "-", (0, (2, 2)))
_LOCAL = ("printed, float64", "printed, longdouble", "half-angle, NumPy", "Gauss, 16 points", "Gauss, 64 points")


def plot(rows: Sequence[Row], path: str) -> None:
    """Draw rows of any functions, one line of panels each; the file's type follows from its name.

    Raises
    ------
    ImportError
        Without matplotlib.
    """
    try:
        from matplotlib.figure import Figure
    except ImportError as error:
        raise ImportError("pictures need matplotlib: pip install 'slipcircle[plot]'") from error
    names = list(dict.fromkeys(row.function for row in rows))
    figure = Figure(figsize=(19, 6 * len(names)), layout="constrained")
    for axes, name in zip(figure.subplots(len(names), 3, squeeze=False, width_ratios=(4, 4, 3)), names, strict=True):
        ours = [row for row in rows if row.function == name]
        _price(axes[0], ours)
        known = [r for r in ours if r.profile is not None and len(r.worst_input) == 1 and r.points > 100]
        if known:
            _over_alpha(axes[1], [r for r in known if _drawn(r, known)])
            _distribution(axes[2], [r for r in known if r.ours])
        else:
            axes[1].remove()
            axes[2].remove()
    figure.savefig(path, dpi=100)


def _drawn(row: Row, rows: Sequence[Row]) -> bool:
    """Whether the error over alpha shows this row: of a tier's forms, the first."""
    tier = row.way.partition(",")[0]
    return row.way in _LOCAL or (row.bound is not None and next(r for r in rows if r.way.startswith(tier)) is row)


def _clipped(error: float) -> float:
    return float(np.clip(error, _BEST, _NONE))


# --- error against time --------------------------------------------------------------------------------------------


def _price(axes: Any, rows: Sequence[Row]) -> None:
    floor = next((r for r in rows if r.error != r.error), None)
    rows = [r for r in rows if r.error == r.error]
    unit = "an element" if rows[0].ns_1e4 else "a solution"
    front = sorted((r for r in rows if r.verdict == FRONTIER), key=lambda r: r.price)
    axes.set(xscale="log", yscale="log", xlabel=f"time of {unit}, ns", ylabel="worst relative error")
    axes.set_title(rows[0].function, loc="left", fontweight="bold")
    axes.step([r.price for r in front], [_clipped(r.error) for r in front], where="post", color="0.6", lw=4, zorder=1,
              solid_capstyle="round", label="frontier")  # fmt: skip
    for r in rows:
        colour, y = "#0072B2" if r.ours else "#D55E00", _clipped(r.error)
        shape = "v" if r.error < _BEST else "^" if r.error > _NONE else "o" if r.ours else "s"
        axes.plot(r.price, y, shape, color=colour, ms=7 if r.ours else 6, mfc=colour if r.ours else "white", zorder=4)
        if r.bound is not None:
            axes.plot([r.price, r.price], [y, r.bound], "-", color=colour, lw=1, zorder=3)
            axes.plot(r.price, r.bound, "_", color=colour, ms=13, mew=2.5, zorder=3)
    for style, label in (
        ({"marker": "o", "color": "#0072B2"}, "this package: worst seen"),
        ({"marker": "_", "color": "#0072B2", "ms": 13, "mew": 2.5}, "this package: proved bound"),
        ({"marker": "s", "color": "#D55E00", "mfc": "white"}, "other ways: worst seen (arrow: beyond the axis)"),
    ):
        axes.plot([], [], ls="", label=label, **style)
    if floor:
        axes.axvline(floor.price, color="0.3", ls=":", lw=1.2, label="copying (np.copyto)")
    low, high = min(r.price for r in rows), max(r.price for r in rows)
    axes.set(xlim=(min(low, floor.price if floor else low) / 2, high * 30), ylim=(_BEST / 10, _NONE * 10))
    axes.grid(alpha=0.3)
    axes.legend(loc="upper right", fontsize=8.5, framealpha=0.9)
    _name(axes, [(r.way, r.price, _clipped(r.error), r.verdict == FRONTIER) for r in rows])


def _name(axes: Any, points: Sequence[tuple[str, float, float, bool]]) -> None:
    """Write names beside points, the frontier's first, each at the first place where nothing is in its way."""
    figure = axes.figure
    figure.draw_without_rendering()
    renderer = figure.canvas.get_renderer()
    taken = [axes.get_legend().get_window_extent(renderer).padded(2)]
    for _, x, y, _ in points:
        px, py = axes.transData.transform((x, y))
        taken.append(type(taken[0]).from_extents(px - 6, py - 6, px + 6, py + 6))
    for name, x, y, front in sorted(points, key=lambda p: not p[3]):
        text = None
        for dx, dy, across, up in _places():
            text = axes.annotate(name, (x, y), (dx, dy), textcoords="offset points", ha=across, va=up, fontsize=8.5,
                                 fontweight="bold" if front else "normal", color="black" if front else "0.35",
                                 arrowprops={"arrowstyle": "-", "color": "0.6", "lw": 0.6, "shrinkB": 4}
                                 if abs(dx) + abs(dy) > 20 else None, zorder=5)  # fmt: skip
            box = text.get_window_extent(renderer)
            inside = axes.get_window_extent(renderer)
            if not any(box.overlaps(b) for b in taken) and inside.x0 < box.x0 and box.x1 < inside.x1:
                taken.append(box)
                break
            text.remove()


def _places() -> Sequence[tuple[float, float, str, str]]:
    """Offsets in points, the nearest first."""
    near = [(8, 0, "left", "center"), (-8, 0, "right", "center"), (0, 8, "center", "bottom"), (0, -8, "center", "top")]
    far = [
        (sx * 10 * k, sy * 10 * k, "left" if sx > 0 else "right", "bottom" if sy > 0 else "top")
        for k in range(1, 9)
        for sx in (1, -1)
        for sy in (1, -1)
    ]
    return near + far


# --- error over alpha ----------------------------------------------------------------------------------------------


def both_ends(alpha: Floats) -> Floats:
    """A coordinate that is logarithmic at 0 and at pi/2: log10 of the distance to the nearer end, 0 at pi/4."""
    rest = (HALF_PI[0] - alpha) + HALF_PI[1]
    with np.errstate(divide="ignore"):
        return np.where(alpha < HALF_PI[0] / 2, np.log10(alpha / (HALF_PI[0] / 2)), -np.log10(rest / (HALF_PI[0] / 2)))


def _over_alpha(axes: Any, rows: Sequence[Row]) -> None:
    edges = np.linspace(-_ENDS, _ENDS, _BINS + 1)
    middle = (edges[1:] + edges[:-1]) / 2
    for i, row in enumerate(rows):
        assert row.profile is not None
        place = np.digitize(both_ends(row.profile.points), edges) - 1
        worst = np.array([np.max(row.profile.relative[place == k], initial=0.0) for k in range(_BINS)])
        seen = worst > 0
        style = {"color": _COLOURS[i % 8], "ls": _DASHES[i % 8]}
        axes.plot(middle[seen], np.clip(worst[seen], _BEST, _NONE), lw=1.8, label=row.way, **style)
        if row.bound is not None:
            axes.axhline(row.bound, color=_COLOURS[i % 8], lw=0.8)
    ticks = [10.0**-k for k in (16, 12, 8, 4, 1)]
    at = [np.log10(t / (HALF_PI[0] / 2)) for t in ticks]
    words = [f"$10^{{{round(np.log10(t))}}}$" for t in ticks]
    axes.set_xticks([*at, 0, *(-x for x in reversed(at))],
                    [*words, "$\\pi/4$", *(f"$\\frac{{\\pi}}{{2}}-${w}" for w in reversed(words))])  # fmt: skip
    axes.set(yscale="log", xlim=(-_ENDS, _ENDS), ylim=(_BEST, _NONE * 2), ylabel="relative error, worst in each bin",
             xlabel="alpha, rad (logarithmic towards 0 and towards pi/2)")  # fmt: skip
    axes.grid(alpha=0.3)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, 1.13), fontsize=8.5, ncols=4, frameon=False, handlelength=3.5)


# --- distribution --------------------------------------------------------------------------------------------------


def _distribution(axes: Any, rows: Sequence[Row]) -> None:
    for i, row in enumerate(rows):
        assert row.profile is not None
        size = np.abs(row.profile.ulp[np.isfinite(row.profile.ulp) & (row.profile.points > 1e-8)])
        edges = np.geomspace(1e-3, 1e12, 76)
        share, _ = np.histogram(np.clip(size, edges[0], edges[-1]), edges)
        axes.stairs(100 * share / size.size, edges, color=_COLOURS[i % 8], ls=_DASHES[i % 8], lw=1.8,
                    label=f"{row.way} ({row.kind} ulp)")  # fmt: skip
        if row.bound_ulp is not None:
            axes.axvline(row.bound_ulp, color=_COLOURS[i % 8], ls=_DASHES[i % 8], lw=0.8)
    axes.set(xscale="log", xlabel="size of the error, ulp of the row's format (thin lines: proved bounds)",
             ylabel="share of the inputs, %")  # fmt: skip
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8.5)
