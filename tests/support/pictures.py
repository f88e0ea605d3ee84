"""Figures that are rendered in memory, and what can be read from them."""

import itertools
from collections.abc import Iterator
from functools import cache
from typing import Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text

from slipcircle import Arc, Motion, Scene, load, solve
from slipcircle.tables import Pulse


def canvas(size: tuple[float, float] = (7.0, 5.0), dpi: float = 100) -> Figure:
    """Return an empty figure that can be rendered."""
    figure = Figure(figsize=size, dpi=dpi, layout="constrained")
    FigureCanvasAgg(figure)
    return figure


def drawn(size: tuple[float, float] = (7.0, 5.0)) -> Any:
    """Return an empty axis that can be rendered."""
    return canvas(size).add_subplot()


def legend(ax: Any) -> list[str]:
    """Return the texts beside curves of an axis and its twins, in legends and in notes above the axis."""
    said = [words for words in [ax.get_title("right")] if words]
    for one in ax.figure.axes:
        if one.bbox.bounds == ax.bbox.bounds:
            explained = one.get_legend().get_texts() if one.get_legend() else []
            said += [" ".join(t.get_text().split()) for t in (*one.texts, *explained)]
    return said


def texts(figure: Any) -> Iterator[tuple[str, Any]]:
    """Return every visible text and its box in pixels."""
    figure.draw_without_rendering()
    renderer = figure.canvas.get_renderer()
    hidden = set()
    for ax in figure.findobj(lambda a: hasattr(a, "get_xaxis")):
        for axis, (low, high) in ((ax.xaxis, ax.get_xlim()), (ax.yaxis, ax.get_ylim())):
            slack = 1e-9 * abs(high - low)
            for tick in (*axis.get_major_ticks(), *axis.get_minor_ticks()):
                if not min(low, high) - slack <= tick.get_loc() <= max(low, high) + slack:
                    hidden |= {tick.label1, tick.label2}
    for text in figure.findobj(Text):
        if text.get_text().strip() and text.get_visible() and text not in hidden:
            yield text.get_text(), Text.get_window_extent(text, renderer)  # without a line to what it names


def clashes(figure: Any) -> list[str]:
    """Pairs of texts that overlap, and texts that leave the figure."""
    found = list(texts(figure))
    width, height = figure.canvas.get_width_height()
    bad = [
        f"{a!r} on {b!r}"
        for (a, p), (b, q) in itertools.combinations(found, 2)
        if min(p.x1, q.x1) - max(p.x0, q.x0) > 1 and min(p.y1, q.y1) - max(p.y0, q.y0) > 1
    ]
    return bad + [f"{a!r} leaves" for a, p in found if p.x0 < 0 or p.y0 < 0 or p.x1 > width or p.y1 > height]


def scene(first: float, second: float, friction: Any, effects: Any, radius: float = 50.0, **more: Any) -> Scene:
    return Scene(Arc(radius, float(np.deg2rad(first)), float(np.deg2rad(second)), 19e3), friction, effects, **more)


BOTH = ["rotation", "centripetal"]
CALMING = {"law": "prescribed", "time": [0.0, 2.0, 5.0], "coefficient": [0.45, 0.2, 0.35]}
SHIPPED = ("vaiont", "vaiont-frozen", "vaiont-heated", "vaiont-shaken", "newmark-pulse", "wet-slope")
SCENES = {name: load(name) for name in SHIPPED} | {
    "by time": scene(215, 280, CALMING, ["rotation"], end_time=8.0),
    "shaken still": scene(215, 260, 0.9, {"shaking": {"horizontal": Pulse("triangular", 0.1, 0.0, 1.0)}}),
    "swings": scene(215, 280, 0.0, BOTH, end_time=60.0, name="swings, a name with $ and <"),
    "first stop": scene(215, 280, 0.0, ["rotation"]),
    "damped": scene(215, 280, 0.02, BOTH),
    "still": scene(215, 280, 0.9, ["rotation"], name="still"),
    "tiny": scene(245, 245.2, 0.36, BOTH, radius=100.0),
    "half disc": scene(160, 340, 0.1, BOTH, radius=20.0),
    "to the left": scene(260, 325, 0.15, BOTH),
    "lifted": scene(215, 280, 0.2, {"rotation": {}, "pore_pressure": {"pressure": 2e5}}, end_time=6.0),
    "pushed up": scene(215, 280, 0.3, BOTH, initial_velocity=-8.0),
}


@cache
def motion(name: str) -> Motion:
    return solve(SCENES[name])
