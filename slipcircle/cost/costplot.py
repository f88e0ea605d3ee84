"""The price list as a picture: error against time, error over alpha, and how the errors of each tier are spread."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from slipcircle.cost.cost import FRONTIER, Row
from slipcircle.cost.reference import HALF_PI, Floats
from slipcircle.outputs.plotstyle import axis

_BEST, _NONE = 1e-19, 10.0  # the axis of errors ends here; what lies beyond is drawn at its ends
_DECADES = 16.5  # of alpha, towards each end
_BINS = 90
_OURS, _OTHERS = "#0072B2", "#D55E00"
# Colour (Okabe and Ito's, which the colour-blind tell apart), dashes (which greys leave apart) and width of lines.
_LINES: dict[str, tuple[str, Any, float]] = {
    "best": ("#0072B2", "-", 2.6),
    "1e-10": ("#009E73", (0, (6, 1.5)), 2.2),
    "1e-6": ("#D55E00", (0, (3, 1)), 2.2),
    "float32": ("#CC79A7", (0, (6, 1, 1, 1)), 2.2),
    "half-angle, NumPy": ("#000000", "-", 0.9),
    "printed, float64": ("0.35", (0, (1, 1)), 2.0),
    "printed, longdouble": ("0.35", (0, (1, 3)), 2.0),
    "Gauss, 16 points": ("#E69F00", (0, (8, 3)), 1.2),
    "Gauss, 64 points": ("#E69F00", "-", 1.2),
}
_FORMS = {"fused": ("#0072B2", "-"), "plain C": ("#D55E00", (0, (4, 1.5))), "NumPy": ("#000000", (0, (1, 1)))}


def plot(rows: Sequence[Row], path: str) -> None:
    """Draw rows of any functions; the file's type follows from its name.

    Raises
    ------
    ImportError
        Without matplotlib.
    """
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ImportError as error:
        raise ImportError("pictures need matplotlib: pip install 'slipcircle[plot]'") from error
    functions = [[r for r in rows if r.function == name] for name in dict.fromkeys(row.function for row in rows)]
    kernels = [rows for rows in functions if _sampled(rows)]
    others = [rows for rows in functions if not _sampled(rows)]
    lines = len(kernels) + (len(others) + 2) // 3
    height = 5.6 * lines  # in
    figure = Figure(figsize=(19, height), dpi=100)
    FigureCanvasAgg(figure)  # which knows how large a text will be
    grid = figure.add_gridspec(
        lines, 3, width_ratios=(1.15, 1.15, 1), left=0.045, right=0.99, wspace=0.17, hspace=0.42,
        bottom=0.65 / height, top=1 - 0.85 / height,
    )  # fmt: skip
    prices = []
    for line, rows in enumerate(kernels):
        prices.append((figure.add_subplot(grid[line, 0]), rows))
        over_alpha(rows, figure.add_subplot(grid[line, 1]))
        _spread(figure, grid[line, 2], _sampled(rows))
    for k, rows in enumerate(others):
        prices.append((figure.add_subplot(grid[len(kernels) + k // 3, k % 3]), rows))
    for axes, rows in prices:
        _price(axes, rows)
    figure.draw_without_rendering()  # so that names find their places
    for axes, rows in prices:
        _name(axes, [r for r in rows if r.error == r.error])
    figure.savefig(path)


def frontier(rows: Sequence[Row], ax: Any = None) -> Any:
    """Error against time, with the frontier drawn and as many ways named as find a place.

    Parameters
    ----------
    rows : sequence of Row
        Of one function or solver, from `cost.measure`.
    ax : matplotlib axis, optional

    Returns
    -------
    matplotlib axis
    """
    ax = axis(ax, (9.0, 5.5))
    _price(ax, rows)
    ax.figure.draw_without_rendering()  # so that names find their places
    _name(ax, [r for r in rows if r.error == r.error])
    return ax


def _sampled(rows: Sequence[Row]) -> list[Row]:
    """Those of one argument whose errors are known at many points."""
    return [r for r in rows if r.profile is not None and len(r.worst_input) == 1 and r.points > 100]


def _height(row: Row) -> float:
    return float(np.clip(row.error, _BEST, _NONE))


# --- error against time --------------------------------------------------------------------------------------------


def _price(axes: Any, rows: Sequence[Row]) -> None:
    floor = next((r for r in rows if r.error != r.error), None)
    rows = [r for r in rows if r.error == r.error]
    front = sorted((r for r in rows if r.verdict == FRONTIER), key=lambda r: r.price)
    axes.step([r.price for r in front], [_height(r) for r in front], where="post", color="0.75", lw=5, zorder=1,
              solid_capstyle="round", label="frontier")  # fmt: skip
    for r in rows:
        colour = _OURS if r.ours else _OTHERS
        shape = "v" if r.error < _BEST else "^" if r.error > _NONE else "o" if r.ours else "s"
        axes.plot(r.price, _height(r), shape, color=colour, ms=7, mfc=colour if r.ours else "white", zorder=4)
        if r.bound is not None:
            axes.plot([r.price] * 2, [_height(r), r.bound], "-", color=colour, lw=1, zorder=3)
            axes.plot(r.price, r.bound, "_", color=colour, ms=13, mew=2.5, zorder=3)
    styles: list[tuple[str, dict[str, Any]]] = [
        ("ours, worst seen", {"marker": "o", "color": _OURS, "ms": 7}),
        ("others, worst seen", {"marker": "s", "color": _OTHERS, "mfc": "white", "ms": 7}),
    ]
    if any(r.bound is not None for r in rows):
        styles.append(("ours, proved bound", {"marker": "_", "color": _OURS, "ms": 13, "mew": 2.5}))
    for label, style in styles:
        axes.plot([], [], ls="", label=label, **style)
    left = min(r.price for r in rows)
    if floor:
        axes.axvline(floor.price, color="0.3", ls=":", lw=1.2, label="np.copyto")
        left = min(left, floor.price)
    axes.set(xscale="log", yscale="log", xlim=(left / 3, max(r.price for r in rows) * 30),
             ylabel="worst relative error (arrows: off the axis)",
             ylim=(max(_BEST, min(map(_height, rows)) / 50) / 20, _NONE * 20),
             xlabel=f"time of {'an element at N = 1e4' if rows[0].ns_1e4 else 'a solution'}, ns")  # fmt: skip
    axes.set_yticks([10.0**k for k in range(-18, 1, 3)])
    axes.grid(alpha=0.3)
    axes.set_title(rows[0].function, loc="left", fontweight="bold", pad=36)
    axes.legend(loc="lower left", bbox_to_anchor=(-0.02, 1.0), fontsize=9, ncols=3, frameon=False, borderaxespad=0.1)


def _name(axes: Any, rows: Sequence[Row]) -> None:
    """Write names beside points, the frontier's first, each at the first place where nothing is in its way."""
    from matplotlib.transforms import Bbox

    renderer, inside = axes.figure.canvas.get_renderer(), axes.get_window_extent()
    taken = []
    for row in rows:
        for y in {_height(row), row.bound or _height(row)}:
            px, py = axes.transData.transform((row.price, y))
            taken.append(Bbox.from_extents(px - 7, py - 5, px + 7, py + 5))
    for row in sorted(rows, key=lambda r: (r.verdict != FRONTIER, r.price)):
        front = row.verdict == FRONTIER
        for dx, dy, across, up in _places():
            text = axes.annotate(
                row.way, (row.price, _height(row)), (dx, dy), textcoords="offset points", ha=across, va=up,
                fontsize=9, fontweight="bold" if front else "normal", color="black" if front else "0.3", zorder=5,
                arrowprops={"arrowstyle": "-", "color": "0.5", "lw": 0.6, "shrinkB": 3} if abs(dx) > 12 else None,
            )  # fmt: skip
            box = text.get_window_extent(renderer)
            within = inside.x0 < box.x0 and box.x1 < inside.x1 and inside.y0 < box.y0 and box.y1 < inside.y1
            if within and not any(box.overlaps(b) for b in taken):
                taken.append(box)
                break
            text.remove()


def _places() -> list[tuple[float, float, str, str]]:
    """Offsets in points, the nearest first."""
    near = [
        (10, 0, "left", "center"),
        (-10, 0, "right", "center"),
        (0, 9, "center", "bottom"),
        (0, -9, "center", "top"),
    ]
    return near + [
        (right * 9.0 * k, up * 12.0 * k, "left" if right > 0 else "right", "bottom" if up > 0 else "top")
        for k in range(1, 9)
        for right in (1, -1)
        for up in (1, -1)
    ]


# --- error over alpha ----------------------------------------------------------------------------------------------


def both_ends(alpha: Floats) -> Floats:
    """A coordinate that is logarithmic at 0 and at pi/2: decades of the distance to the nearer end, 0 at pi/4."""
    rest = np.maximum((HALF_PI[0] - alpha) + HALF_PI[1], HALF_PI[1])
    nearer = np.minimum(alpha, rest) / (HALF_PI[0] / 2)
    with np.errstate(divide="ignore"):
        return np.copysign(np.log10(nearer), alpha - HALF_PI[0] / 2)


def over_alpha(rows: Sequence[Row], ax: Any = None) -> Any:
    """Relative error over alpha, logarithmic towards both ends, with what is proved.

    Parameters
    ----------
    rows : sequence of Row
        Of one kernel, from `cost.measure`.
    ax : matplotlib axis, optional

    Returns
    -------
    matplotlib axis
    """
    axes = axis(ax, (9.0, 5.5))
    rows = _sampled(rows)
    edges = np.linspace(-_DECADES, _DECADES, _BINS + 1)
    for name, (colour, dashes, width) in _LINES.items():
        row = next((r for r in rows if r.way.partition(", ")[0] == name or r.way == name), None)
        if row is None or row.profile is None:
            continue
        place = np.digitize(both_ends(row.profile.points), edges) - 1
        worst = np.array([np.max(row.profile.relative[place == k], initial=0.0) for k in range(_BINS)])
        axes.plot((edges[1:] + edges[:-1])[worst > 0] / 2, np.clip(worst[worst > 0], _BEST, _NONE), color=colour,
                  ls=dashes, lw=width, label=row.way)  # fmt: skip
        if row.bound is not None:
            axes.axhline(row.bound, color=colour, lw=0.8)
    ticks = [10.0**-k for k in (16, 12, 8, 4)]
    words = [f"$10^{{-{k}}}$" for k in (16, 12, 8, 4)]
    places = np.log10(np.array(ticks) / (HALF_PI[0] / 2)).tolist()
    axes.set_xticks([*places, 0, *(-x for x in reversed(places))],
                    [*words, "$\\pi/4$", *(f"$\\pi/2 -$\n{w}" for w in reversed(words))])  # fmt: skip
    axes.set(yscale="log", xlim=(-_DECADES, _DECADES), ylim=(_BEST, _NONE * 2), xlabel="alpha, rad",
             ylabel="relative error, worst in each bin (thin: proved)")  # fmt: skip
    axes.grid(alpha=0.3)
    axes.legend(loc="lower left", bbox_to_anchor=(-0.02, 1.0), fontsize=9, ncols=3, frameon=False, handlelength=3.6,
                borderaxespad=0.1)  # fmt: skip
    return axes


# --- spread --------------------------------------------------------------------------------------------------------


def _spread(figure: Any, place: Any, rows: Sequence[Row]) -> None:
    """A histogram of signed errors for each tier, in ulp, its forms one over the other."""
    tiers = list(dict.fromkeys(r.way.partition(", ")[0] for r in rows if r.ours))
    if not tiers:
        return
    for axes, tier in zip(
        place.subgridspec(len(tiers), 1, hspace=0.55).subplots(squeeze=False)[:, 0], tiers, strict=True
    ):
        ours = [r for r in rows if r.ours and r.way.partition(", ")[0] == tier]
        reach = 1.05 * max(r.ulp or 0.0 for r in ours)
        for row in ours:
            assert row.profile is not None
            form = row.way.partition(", ")[2]
            colour, dashes = _FORMS[form]
            inner = np.abs(both_ends(row.profile.points)) < 8  # nearer to an end all have one coefficient's error
            share, edges = np.histogram(row.profile.ulp[inner], 81, (-reach, reach))
            axes.stairs(100 * share / inner.sum(), edges, color=colour, ls=dashes, lw=1.4, label=form)
            for sign in (-1, 1):
                if row.bound_ulp is not None and row.bound_ulp < reach:
                    axes.axvline(sign * row.bound_ulp, color=colour, ls=dashes, lw=0.8)
        axes.text(0.01, 0.93, f"{tier}, ulp of {ours[0].kind}", transform=axes.transAxes, va="top", fontweight="bold",
                  bbox={"color": "white", "alpha": 0.8, "pad": 1})  # fmt: skip
        axes.set(ylabel="inputs, %", xlim=(-reach, reach), ylim=(0, 1.4 * axes.get_ylim()[1]))
        axes.grid(alpha=0.3)
        axes.locator_params(axis="x", nbins=7)
        axes.ticklabel_format(axis="x", style="sci", scilimits=(-3, 4))
        if axes.get_subplotspec().is_first_row():
            axes.legend(fontsize=9, loc="lower right", bbox_to_anchor=(1.02, 1.0), ncols=3, frameon=False,
                        borderaxespad=0.1)  # fmt: skip
