"""What all pictures share: the palette, numbers and units as they are shown, the legend above the axis."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from slipcircle.base.text import shown
from slipcircle.core import Motion

# The one palette, by role: colour (Okabe and Ito's, which the colour-blind tell apart) with dashes, a marker or a
# hatch, which greys leave apart.
LINES: Mapping[str, Mapping[str, Any]] = {
    "main": {"color": "#0072B2", "ls": "-", "lw": 2.0},
    "other": {"color": "#D55E00", "ls": (0, (5, 2)), "lw": 1.6},
    "total": {"color": "black", "ls": (0, (1, 1.2)), "lw": 1.8},
    "radius": {"color": "0.45", "ls": (0, (6, 1.5, 1, 1.5)), "lw": 0.8},
    "help": {"color": "0.45", "ls": (0, (1, 2)), "lw": 1.0},
}
MARKS: Mapping[str, Mapping[str, Any]] = {
    "start": {"marker": "o", "color": "black", "mfc": "white", "ms": 6},
    "peak": {"marker": "^", "color": "#D55E00", "mec": "black", "ms": 8},
    "reach": {"marker": "D", "color": "#E69F00", "mec": "black", "ms": 6},
    "end": {"marker": "s", "color": "#0072B2", "mec": "black", "ms": 7},
}
AREAS: Mapping[str, Mapping[str, Any]] = {
    "start": {"facecolor": "0.88", "edgecolor": "0.4", "lw": 1.0},
    "peak": {"facecolor": "none", "edgecolor": "#D55E00", "lw": 1.8, "ls": (0, (5, 2))},
    "end": {"facecolor": "none", "edgecolor": "#0072B2", "lw": 1.8, "hatch": "///"},
    "rests": {"facecolor": "#F6DCA0", "edgecolor": "0.25", "lw": 0.8},
    "moves on": {"facecolor": "#56B4E9", "edgecolor": "0.25", "lw": 0.8, "hatch": "///"},
    "moving": {"facecolor": "#E69F00", "edgecolor": "black", "lw": 1.2, "alpha": 0.7},
    "kinetic": {"facecolor": "#56B4E9", "edgecolor": "0.35", "lw": 0.6, "hatch": "\\\\"},
    "dissipation": {"facecolor": "#F6DCA0", "edgecolor": "0.25", "lw": 0.6},
    "band": {"facecolor": "0.82", "edgecolor": "0.55", "lw": 0.6},
}
SCENERY: Mapping[str, Mapping[str, Any]] = {
    "ground": {"color": "black", "lw": 1.4, "zorder": 3},
    "soil": {"color": "#EFE6D2", "lw": 0, "zorder": 1},
    "water": {"color": "#56B4E9", "lw": 1.6, "zorder": 3},
    "firm layer": {"color": "0.3", "lw": 2.5, "zorder": 3},
    "depth": {"color": "black", "lw": 1.0, "marker": "_", "zorder": 3},
    "centre": {"color": "black", "marker": "+", "ls": "", "ms": 9, "mew": 1.5, "zorder": 5},
}
FORCES: Mapping[str, str] = {"weight": "black", "normal": "#009E73", "tangential": "#CC79A7"}
HALO = 2.5  # points of white around a text that stands on lines


def axis(ax: Any = None, size: tuple[float, float] = (7.0, 4.5)) -> Any:
    """The axis that is given, or that of a new figure."""
    return new_figure(size).add_subplot() if ax is None else ax


def new_figure(size: tuple[float, float]) -> Any:
    """An empty figure of pyplot, which shows it, of a size in inches."""
    try:
        from matplotlib import pyplot
    except ImportError as error:
        raise missing() from error
    return pyplot.figure(figsize=size, layout="constrained")


def known(what: str, given: str, choice: Iterable[str]) -> None:
    """Refuse what is none of the things that can be drawn."""
    if given not in choice:
        raise ValueError(f"{what} = {given!r}: must be one of {', '.join(choice)}")


def missing() -> ImportError:
    """What to say without matplotlib."""
    return ImportError("pictures need matplotlib: pip install 'slipcircle[plot]'")


def number(value: float) -> str:
    """A number with four significant digits, as a picture shows it."""
    mantissa, _, exponent = shown(float(value)).partition("e")
    return f"${mantissa}\\times10^{{{int(exponent)}}}$" if exponent else mantissa


def legend(ax: Any, columns: int = 2, **more: Any) -> Any:
    """The legend, above the axis, where nothing is in its way."""
    return ax.legend(
        loc="lower left",
        bbox_to_anchor=(0.0, 1.0),
        ncols=columns,
        frameon=False,
        fontsize="small",
        borderaxespad=0.2,
        handlelength=2.6,
        columnspacing=1.4,
        labelspacing=0.3,
        **more,
    )


def finish(ax: Any, across: str, up: str) -> None:
    """Make a section of what is drawn: to scale, with a grid and the legend."""
    ax.set(xlabel=across, ylabel=up, aspect="equal")
    ax.grid(alpha=0.3)
    legend(ax)


def mark(ax: Any, x: Any, y: Any, role: str, label: str) -> None:
    """One of `MARKS` at a place, also on the edge."""
    ax.plot(x, y, ls="", clip_on=False, zorder=4, label=label, **MARKS[role])


def lines(ax: Any, names: Sequence[str]) -> None:
    """Make room for a bar of each name, from the top down."""
    ax.set_yticks(range(len(names)), names, parse_math=False)
    ax.set_ylim(len(names) - 0.5, -0.5)
    ax.grid(axis="x", alpha=0.3)


def empty(words: str, ax: Any, *sides: str) -> Any:
    """Words in the middle of an axis that has nothing else to show, without the ticks of its sides."""
    ax.set(**{f"{side}ticks": [] for side in sides})
    ax.text(0.5, 0.5, words, ha="center", va="center", transform=ax.transAxes)
    return ax


def described(figure: Any) -> list[str]:
    """What titles, axes and legends of a figure say; not the texts at points, which may hold measured times."""
    texts = [part.get_suptitle() for part in (figure, *figure.subfigs)]
    legends = list(figure.legends)
    for ax in figure.axes:
        texts += [ax.get_title(), ax.get_title("left"), ax.get_xlabel(), ax.get_ylabel()]
        legends += filter(None, [ax.get_legend()])
    for explained in legends:
        texts += [text.get_text() for text in explained.get_texts()]
    return [text for text in texts if text]


def ending(motion: Motion) -> str:
    """How a motion ends, in words."""
    if motion.arrested:
        return "at rest"
    return "first standstill" if motion.plan.scene.end_time is None else "still moving"


def width(motion: Motion) -> tuple[str, str]:
    """What energies are of, in words, and what follows their unit: a metre of width, unless the scene has a width."""
    metres = float(np.asarray(motion.plan.scene.arc.width))
    return ("per metre of width", "/m") if metres == 1.0 else (f"of {number(metres)} m of width", "")


def work(motion: Motion) -> str:
    """What does the work, in words."""
    return "work of gravity and shaking" if "shaking" in motion.plan.effects else "work of gravity"


def still(motion: Motion, ax: Any) -> Any:
    """The axis of a mass that does not move."""
    return empty(f"does not move\nfactor of safety {number(motion.factor_of_safety)}", ax, "x", "y")


def name_beside(ax: Any, words: str, at: Any, offset: Any, colour: str, **more: Any) -> None:
    """Words beside what they name, in its colour."""
    from matplotlib.patheffects import withStroke

    ax.annotate(
        words,
        at,
        offset,
        textcoords="offset points",
        color=colour,
        fontsize="small",
        zorder=6,
        path_effects=[withStroke(linewidth=HALO, foreground="white")],
        **more,
    )


def beside(ax: Any, words: str, at: Any, away: Any, **more: Any) -> None:
    """Words beside a point, in a direction from it."""
    offset = 12 * np.divide(away, np.hypot(*away))
    name_beside(ax, words, at, offset, "black", ha="center", va="center", **more)
