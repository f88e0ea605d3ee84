"""Style of all pictures: the palette, the format of numbers and units, and labels beside curves and areas."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from slipcircle.base.kinds import Pair, TextPair, Texts, Values
from slipcircle.base.optional import optional
from slipcircle.base.text import amount_text, number_text, output_unit
from slipcircle.core import Motion, Status
from slipcircle.messages import standing, swings_back
from slipcircle.workbench.common.trace import columns_of_picture
from slipcircle.workbench.files.keys import Key

FIRST = "first standstill"  # end of a motion that is computed to its first standstill
WIDTH = 8.6  # inches of a picture of several panels, about the width of a page, where texts have at least 8 points

# The palette by role: colours of Okabe and Ito, which the colour-blind distinguish, with dashes, markers or hatches,
# which remain distinct in grey.
LINES: Mapping[str, Values] = {
    "main": {"color": "#0072B2", "ls": "-", "lw": 2.0},
    "other": {"color": "#D55E00", "ls": (0, (5, 2)), "lw": 1.6},
    "total": {"color": "black", "ls": (0, (1, 1.2)), "lw": 1.8},
    "help": {"color": "0.45", "ls": (0, (1, 2)), "lw": 1.0, "zorder": 1},
}
MARKS: Mapping[str, Values] = {
    "start": {"marker": "o", "color": "black", "mfc": "white", "ms": 6},
    "peak": {"marker": "^", "color": "#D55E00", "mec": "black", "ms": 8},
    "farthest": {"marker": "D", "color": "#E69F00", "mec": "black", "ms": 6},
    "end": {"marker": "s", "color": "#0072B2", "mec": "black", "ms": 7},
}
AREAS: Mapping[str, Values] = {
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
# Styles for families of curves.
SERIES: Sequence[tuple[str, Any, str]] = (
    ("#0072B2", "-", "o"),
    ("#D55E00", (0, (5, 2)), "s"),
    ("black", (0, (1, 1.2)), "^"),
    ("#00805D", (0, (6, 1.5, 1, 1.5)), "D"),
    ("#A8487F", "-", "x"),
    ("#9C6F00", (0, (3, 1)), "v"),
    ("#3A8FC4", (0, (8, 2)), "P"),
    ("0.35", (0, (2, 2)), "*"),
)
MEASURED = "measured"  # `gid` of labels with measured values, which differ from run to run
REST: tuple[str, Any, str] = ("0.75", "-", ".")  # style of further curves
# Of soils, from the ground down: colours of the band and of the stretch of the arc.
SOILS: Sequence[TextPair] = (
    ("#F5E8C4", "#9C6F00"),
    ("#D3E6F4", "#0072B2"),
    ("#F8DCCB", "#D55E00"),
    ("#D3EEE3", "#00805D"),
    ("#F1DDE9", "#A8487F"),
    ("#E2E2E2", "#4D4D4D"),
)
SCENERY: Mapping[str, Values] = {
    "ground": {"color": "black", "lw": 1.4, "zorder": 3},
    "soil": {"color": "#EFE6D2", "lw": 0, "zorder": 1},
    "water": {"color": "#56B4E9", "lw": 1.6, "zorder": 3},
    "pond": {"color": "#56B4E9", "lw": 0, "alpha": 0.45, "zorder": 1.2},
    "beyond": {"color": "black", "lw": 1.0, "ls": (0, (4, 3)), "zorder": 3},
    "firm": {"color": "0.3", "lw": 2.5, "zorder": 3},
    "surcharge": {"color": "0.25", "lw": 1.0, "zorder": 3},
    "boundary": {"color": "0.55", "lw": 0.8, "zorder": 1.1},
    "centre": {"color": "black", "marker": "+", "ls": "", "ms": 9, "mew": 1.5, "zorder": 5},
}


_NO_WORDS = ("",)


def panel(
    ax: Any,
    words: str,
    across: Sequence[str] = _NO_WORDS,
    up: Sequence[str] = _NO_WORDS,
    notes: Iterable[str] = (),
    size: Pair = (7.0, 4.5),
) -> Any:
    """Return the given axis, or the axis of a new figure of a size in inches, with a title, notes and a grid.

    ``across`` and ``up`` are the arguments of `label_direction` for both directions.
    """
    ax = new_figure(size).add_subplot() if ax is None else ax
    title(ax, words, notes)
    ax.grid(alpha=0.3)
    label_direction(ax.xaxis, *across)
    label_direction(ax.yaxis, *up)
    return ax


def new_figure(size: Pair) -> Any:
    """Return an empty pyplot figure of a size in inches."""
    return optional("matplotlib.pyplot", "pictures").figure(figsize=size, layout="constrained")


def check_choice(what: str, name: str, choice: Iterable[str]) -> None:
    """Raise ValueError if a name is not among the choices; ``what`` names the argument in the message."""
    if name not in choice:
        raise ValueError(f"{what} = {name!r}: must be one of {', '.join(choice)}")


def formatted_number(value: float) -> str:
    """Return a number with four significant digits as text, with a power of ten as a formula."""
    mantissa, _, exponent = number_text(float(value)).partition("e")
    if exponent:
        return f"${mantissa}\\times10^{{{int(exponent)}}}$"
    return mantissa


def formatted_amount(value: float, unit: str) -> str:
    """Return a quantity in an SI unit as `formatted_number`, with its unit of output."""
    factor, name = output_unit(unit)
    return f"{formatted_number(factor * value)} {name}"


def label_direction(line: Any, words: str, unit: str | None = None, more: str = "") -> None:
    """Label an axis line of a plot; if its values have an SI unit, with numbers in the unit of output.

    ``more`` is text after the unit.
    """
    from matplotlib.ticker import AutoLocator, FuncFormatter, LogLocator

    factor, name = (1.0, "") if unit is None else output_unit(unit)
    line.set_label_text(words if unit is None else f"{words} ({name or '–'}){more}")
    if factor == 1.0:
        return

    is_log = line.get_scale() == "log"
    base: Any = LogLocator if is_log else AutoLocator

    class Scaled(base):
        """Round values in the unit of output."""

        def tick_values(self, low: float, high: float) -> Any:
            return np.divide(super().tick_values(factor * low, factor * high), factor)

    if is_log or line.get_scale() == "linear":
        line.set_major_locator(Scaled())
    line.set_major_formatter(FuncFormatter(lambda value, _: f"{factor * value:.6g}"))


def legend(ax: Any, columns: int = 2, **more: Any) -> Any:
    """Add the legend above the axis, to the right of the title, and return it."""
    return ax.legend(
        loc="lower right",
        bbox_to_anchor=(1.0, 1.0),
        ncols=columns,
        frameon=False,
        fontsize="small",
        borderaxespad=0.2,
        handlelength=2.6,
        columnspacing=1.4,
        labelspacing=0.3,
        **more,
    )


def add_label(ax: Any, words: str, anchors: Any, colour: str = "black", inside: bool = False, **more: Any) -> None:
    """Add a text beside the best of its anchors, which are points (n, 2), where it covers least.

    It is on the anchor if ``inside``; ``more`` are properties of matplotlib's text.
    """
    from slipcircle.workbench.outputs.pictures.labels import Label

    Label(ax, words, anchors, colour, inside, **more)


def anchors_along(x: Any, y: Any, count: int = 12) -> Any:
    """Return about ``count`` points of the curve y over x, (points, 2), as anchors of its label."""
    points = np.column_stack(np.broadcast_arrays(x, y))
    return points[:: max(1, len(points) // count)]


def add_note(ax: Any, words: Iterable[str]) -> None:
    """Write lines of text at the emptiest place of an axis."""
    inside = np.arange(1, 14) / 14
    (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
    places = np.meshgrid(left + inside * (right - left), bottom + inside * (top - bottom))
    add_label(ax, "\n".join(words), np.stack(places, axis=-1), "0.25", inside=True)


def quantity_words(quantity: Key) -> str:
    """Return the name of a number of a scene in words: ``friction.angle_deg`` is the friction angle."""
    *groups, last = quantity.name.replace("_", " ").split(".")
    if groups and groups[-1].isdigit():  # a point of a line, or a layer
        place = int(groups[-1])
        if last == "top":
            return f"top of layer {place}"
        return f"{last} of {groups[0]} point {place}"
    if groups[:1] == ["soils"]:
        _, soil, *rest = groups
        of_soil = replace(quantity, name=".".join([*rest, last]))
        return f"{soil}: {quantity_words(of_soil)}"
    if quantity.tangent:
        last = "angle" if last == "friction" else f"{last} angle"
        groups = groups or ["friction"]
    if groups == ["centre"]:
        return f"{last} of the centre"
    named = [group for group in groups if group not in last]
    adjective, _, noun = last.partition(" ")
    if adjective in ("peak", "residual"):  # the peak friction angle
        return " ".join(filter(None, [adjective, *named, noun]))
    return " ".join([*named, last])


def key_unit(quantity: Key) -> str:
    """Return the unit of a number's key as a picture shows it."""
    return (quantity.written or ("$g$" if quantity.key.endswith("_g") else "")).replace("m3", "m³").replace("^2", "²")


def axis_words(quantity: Key) -> str:
    """Return the name of an axis for a number of a scene: its words and its unit."""
    return f"{quantity_words(quantity)} ({key_unit(quantity) or '–'})"


def area(ax: Any, outline: Any, role: str, **more: Any) -> Any:
    """Add a polygon with vertices (n, 2), the ``outline``, in the style of a role in `AREAS`, and return it."""
    from matplotlib.patches import Polygon

    return ax.add_patch(Polygon(outline, closed=True, **{"zorder": 2, **AREAS[role], **more}))


def to_scale(ax: Any, origin: str = "") -> None:
    """Set equal scales on the whole axis, and the names of its directions."""
    label_direction(ax.xaxis, f"$x${origin}", "m")
    label_direction(ax.yaxis, f"$y${origin}", "m")
    ax.set_aspect("equal", adjustable="datalim")


def title(ax: Any, words: str, notes: Iterable[str] = ()) -> None:
    """Write the title of a panel, and notes on lines of their own to its right."""
    ax.set_title(words[:1].upper() + words[1:], loc="left", fontweight="bold", fontsize="medium")
    ax.set_title("\n".join(notes), loc="right", fontsize="small", color="0.25")


def letter(axes: Iterable[Any]) -> None:
    """Put a letter before the title of each panel of a figure with several panels."""
    panels = [*axes]
    for ax, name in zip(panels, "abcdefghijklmnopqrstuvwxyz" * (len(panels) > 1), strict=False):
        ax.set_title(f"{name}  {ax.get_title('left')}", loc="left", fontweight="bold", fontsize="medium")


def add_mark(ax: Any, x: Any, y: Any, role: str, words: str = "") -> None:
    """Draw the mark of a role in `MARKS` at the point x, y, also on the edge of the axis, with words beside it."""
    ax.plot(x, y, ls="", clip_on=False, zorder=5, **MARKS[role])
    if words:
        add_label(ax, words, (x, y), "black")


def name_rows(ax: Any, names: Sequence[str]) -> None:
    """Prepare an axis for one horizontal bar per name, at y = 0, 1, ... from the top down."""
    ax.set_yticks(range(len(names)), names, parse_math=False)
    ax.set_ylim(len(names) - 0.5, -0.5)
    ax.grid(visible=False, axis="y")


def empty(words: str, ax: Any, *sides: str) -> Any:
    """Write text in the middle of an empty axis, without ticks on the given sides ("x", "y"); return the axis."""
    ax.set(**{f"{side}ticks": [] for side in sides})
    ax.text(0.5, 0.5, words, ha="center", va="center", transform=ax.transAxes)
    return ax


def figure_texts(figure: Any) -> Texts:
    """Return the texts of titles, axes, legends and labels of a figure, except labels with measured values."""
    texts = [part.get_suptitle() for part in (figure, *figure.subfigs)]
    legends = [*figure.legends, *filter(None, (ax.get_legend() for ax in figure.axes))]
    for ax in figure.axes:
        texts += [ax.get_title(), ax.get_title("left"), ax.get_xlabel(), ax.get_ylabel()]
        labels = (text for text in ax.texts if hasattr(text, "anchors") and text.get_gid() != MEASURED)
        texts += [" ".join(text.get_text().split()) for text in labels]
    texts += [text.get_text() for legend in legends for text in legend.get_texts()]
    return [text for text in texts if text]


def curve(ax: Any, motion: Motion, x: Any, y: Any, **style: Any) -> None:
    """Draw y over x at the times of `columns_of_picture`, grey where the motion is outside the range of the method."""
    from matplotlib.collections import LineCollection

    ax.plot(x, y, **style)
    if motion.outside_range:
        outside = columns_of_picture(motion)["time"] >= motion.range_end.time
        points = np.transpose([x, y])[outside]
        ax.add_collection(LineCollection([points], colors="0.6", lw=2.4, zorder=2.1), autolim=False)


def ending(motion: Motion) -> str:
    """Return how a motion ends, in words."""
    if motion.arrested:
        return "at rest"
    if motion.status is Status.CREEPS:
        return "creeping, 99 % covered"
    if motion.plan.scene.end_time is None:
        return FIRST
    return "still moving"


def outcome_words(motion: Motion, digits: int = 3) -> str:
    """Return run-out, time and end of a motion in words, with numbers to some digits."""
    time = motion.settling_time
    end = ending(motion)
    if swings_back(motion):
        time, end = motion.farthest.time, f"swings back to {amount_text(motion.end.displacement, 'm', digits)}"
    return f"{amount_text(motion.run_out, 'm', digits)} in {number_text(time, digits)} s, {end}"


def pace(duration: float, seconds: float) -> str:
    """Return in words how fast a duration in s plays in ``seconds``, compared with real time."""
    ratio = f"{duration / seconds:.2g}" if duration else "1"
    if ratio == "1":
        return "in real time"
    return f"{ratio} times real speed"


def width(motion: Motion) -> tuple[str, str, float]:
    """Return the width that energies refer to in words, the end of their unit, and the factor to that width.

    The end is "/m" for one metre, otherwise empty.
    """
    metres = float(np.asarray(motion.plan.scene.arc.width))
    factor, name = output_unit("m")
    if metres != 1.0:
        return f"of {formatted_amount(metres, 'm')} of width", "", 1.0
    return f"per {'metre' if factor == 1.0 else name} of width", f"/{name}", 1.0 / factor


def work(motion: Motion) -> str:
    """Return the name of the work: of gravity, or of gravity and shaking."""
    if "shaking" in motion.plan.effects:
        return "work of gravity and shaking"
    return "work of gravity"


def still(motion: Motion, ax: Any) -> Any:
    """Draw the panel of a mass that does not move: the reason as text; return the axis."""
    return empty(standing(motion).replace(", ", "\n"), ax, "x", "y")
