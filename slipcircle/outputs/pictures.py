"""Pictures as bytes, for files: drawn without a display, and the same whatever the user's settings of matplotlib."""

import io
import warnings
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from slipcircle.motion import Motion
from slipcircle.outputs import plots
from slipcircle.outputs.plotstyle import missing, work

_KINDS = ("png", "svg", "pdf", "jpg")
_MOST = 20  # scenes in one picture


def check(path: str = "", scenes: int = 1) -> None:
    """See that pictures can be drawn, and one of this file's type and of so many scenes.

    Raises
    ------
    ImportError
        Without matplotlib.
    ValueError
        If not.
    """
    try:
        import matplotlib  # noqa: F401
    except ImportError as error:
        raise missing() from error
    if path and Path(path).suffix[1:].lower() not in _KINDS:
        raise ValueError(f"run: --plot {path}: must end in one of .{', .'.join(_KINDS)}")
    if path and scenes > _MOST:
        raise ValueError(f"run: --plot {path}: shows at most {_MOST} scenes; --report has room for all {scenes}")


def render(draw: Callable[[Any], Any], size: tuple[float, float], kind: str) -> bytes:
    """What a function draws on an empty figure of a size in inches, as a file of a kind such as png."""
    from matplotlib import rc_context, style
    from matplotlib.figure import Figure

    # Also the names within an SVG, and its metadata, are to be the same every time.
    with style.context("default"), rc_context({"svg.hashsalt": "slipcircle"}):
        figure = Figure(figsize=size, dpi=120, layout="constrained")
        draw(figure)
        held = io.BytesIO()
        dated = {"svg": {"Date": None}, "pdf": {"CreationDate": None}}
        with warnings.catch_warnings():  # a name may hold letters that the font does not have
            warnings.filterwarnings("ignore", "Glyph .* missing from font", UserWarning)
            figure.savefig(held, format=kind, metadata=dated.get(kind))
    return held.getvalue()


def overview(motions: Sequence[Motion], kind: str) -> bytes:
    """The overviews of motions, one above the other, as a file of a kind such as png."""

    def draw(figure: Any) -> None:
        parts = figure.subfigures(len(motions), 1, squeeze=False)[:, 0]
        for motion, part in zip(motions, parts, strict=True):
            plots.overview(motion, part)

    return render(draw, (14.0, 10.0 * len(motions)), kind)


def of(motion: Motion) -> list[tuple[str, str, Callable[[str], bytes]]]:
    """The pictures of a report: name, caption, and a function from a kind of file to its bytes."""

    def histories(figure: Any) -> None:
        axes = figure.subplots(2, 2)
        for what, ax in zip(plots.OVERVIEW, axes.flat, strict=True):
            plots.history(motion, what, ax)

    found: list[tuple[str, str, Callable[[Any], Any], tuple[float, float]]] = [
        ("Section", "The section: forces at the start; the mass at the start, at its peak velocity and at the end.",
         lambda figure: plots.section(motion, figure.add_subplot()), (8.0, 6.0)),
    ]  # fmt: skip
    if motion.moves:
        found += [
            ("Histories", "The motion over time. Where the mobilised friction is below the friction needed to stand "
             "still the mass tends to speed up, elsewhere to slow down.", histories, (11.0, 6.5)),
            ("Phase plane", "Speed against displacement, and the energy: what is dissipated and what is kinetic make "
             f"up the {work(motion)}.", lambda figure: plots.phase_plane(motion, figure.add_subplot()), (8.0, 5.0)),
        ]  # fmt: skip
    return [(name, caption, partial(render, draw, size)) for name, caption, draw, size in found]
