"""Pictures as bytes for files, drawn without a display and independent of the user's settings of matplotlib."""

import io
import warnings
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from slipcircle.base.optional import optional
from slipcircle.base.progress import track
from slipcircle.core import Motion
from slipcircle.workbench.outputs.plotstyle import described

if TYPE_CHECKING:
    from slipcircle.workbench.outputs.film import Film

_KINDS = ("png", "svg", "pdf", "jpg")
_FRAMES = 12  # of an animation in a second
_HOLD = 2000  # milliseconds that its last frame is held
_COLOURS = 64  # of each frame


def check(command: str, path: str = "", scenes: int = 1) -> None:
    """Check that pictures of this type can be drawn for this number of scenes; one scene may be animated."""
    optional("matplotlib", "pictures")
    kind, known = Path(path).suffix[1:].lower(), (*_KINDS, *["gif"] * (command == "run"))
    if path and kind not in known:
        raise ValueError(f"{command}: --plot {path}: must end in one of .{', .'.join(known)}")
    if kind == "gif" and scenes > 1:
        raise ValueError(f"{command}: --plot {path}: moves one scene; .png shows all {scenes}")


def render(draw: Callable[[Any], Any], size: tuple[float, float], path: str) -> bytes:
    """Draw a function's picture on an empty figure of a size in inches, as the content of a .png, .svg, ... file.

    For .gif the function gives the `Film` that it has drawn.
    """
    from matplotlib import rc_context, style
    from matplotlib.figure import Figure

    kind = path.rpartition(".")[2].lower()
    # Names and metadata within an SVG are reproducible, too.
    with style.context("default"), rc_context({"svg.hashsalt": "slipcircle"}):
        figure = Figure(figsize=size, dpi=90 if kind == "gif" else 150, layout="constrained")
        film = draw(figure)
        content = io.BytesIO()
        metadata = {
            "png": {"Description": "\n".join(described(figure))},  # for tests and screen readers
            "svg": {"Date": None},
            "pdf": {"CreationDate": None},
        }
        with warnings.catch_warnings():  # a name may have letters that the font lacks
            warnings.filterwarnings("ignore", "Glyph .* missing from font", UserWarning)
            if kind == "gif":
                return _played(film)
            figure.savefig(content, format=kind, metadata=metadata.get(kind))
    return content.getvalue()


def _played(film: "Film") -> bytes:
    """A film as a GIF that holds its last frame; the background is drawn once."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from PIL import Image

    figure = film.figure
    canvas: Any = FigureCanvasAgg(figure)
    for artist in film.moving:
        artist.set_animated(True)  # and so not part of the background
    canvas.draw()
    figure.set_layout_engine("none")  # it would lay out every frame again
    background, size = canvas.copy_from_bbox(figure.bbox), canvas.get_width_height()
    images = []
    for frame in track(range(len(film.times)), "frames drawn"):
        canvas.restore_region(background)
        for artist in film.draw(frame):
            figure.draw_artist(artist)
        pixels = Image.frombuffer("RGBA", size, canvas.buffer_rgba(), "raw", "RGBA", 0, 1)
        images.append(pixels.convert("RGB").quantize(_COLOURS, dither=Image.Dither.NONE))
    first, *others = images
    durations = [round(1e3 * film.seconds / len(film.times))] * len(others) + [_HOLD]
    content = io.BytesIO()
    first.save(content, "GIF", save_all=True, append_images=others, duration=durations, loop=0)
    return content.getvalue()


def _motions(motions: Sequence[Motion], figure: Any) -> Any:
    """The overview of a motion, or several motions side by side."""
    from slipcircle.workbench.outputs import comparison, plots

    return plots.overview(motions[0], figure) if len(motions) == 1 else comparison.overview(motions, figure)


def _motions_size(motions: Sequence[Motion]) -> tuple[float, float]:
    from slipcircle.workbench.outputs import comparison, plots

    return plots.size(motions[0]) if len(motions) == 1 else comparison.size(motions)


def _on_axis(draw: Callable[..., Any]) -> Callable[[Any, Any], Any]:
    """Turn a function that draws on an axis into one that draws on a figure."""
    return lambda result, figure: draw(result, figure.add_subplot())


def _drawings() -> Mapping[str, tuple[Callable[[Any, Any], Any], Callable[[Any], tuple[float, float]]]]:
    """Functions that draw a result on an empty figure, and its inches, by the kind of picture; loaded on first use."""
    from slipcircle.workbench.outputs import layerplot, plots, searchplot, studyplots, suiteplots, tornado

    return {
        "motions": (_motions, _motions_size),
        "section": (_on_axis(plots.section), lambda _: (8.6, 5.0)),
        "histories": (
            lambda motion, figure: plots.histories(motion, figure.subplots(2, 2).T.flat),
            lambda _: (8.6, 5.2),
        ),
        "phase plane": (_on_axis(plots.phase_plane), lambda _: (8.6, 4.0)),
        "shaking": (_on_axis(plots.shaking), lambda _: (8.6, 3.0)),
        "stress along the arc": (_on_axis(layerplot.stress_along), lambda _: (8.6, 3.0)),
        "suite": (suiteplots.overview, suiteplots.size),
        "study": (studyplots.overview, studyplots.size),
        "sensitivity": (tornado.panels, tornado.size),
        "backanalysis": (studyplots.explained, studyplots.explained_size),
        "search": (searchplot.critical_circle, lambda _: (8.6, 7.0)),
        "ladder": (_on_axis(plots.ladder), lambda rungs: (8.6, 1.2 + 0.4 * len(rungs))),
    }


def picture(what: str, result: Any, path: str) -> bytes:
    """One of `_drawings` of a result, in the format of a file name; a GIF animates the first motion."""
    if path.lower().endswith("gif"):
        return slide(result[0])
    draw, size = _drawings()[what]
    return render(partial(draw, result), size(result), path)


def slide(motion: Motion, seconds: float = 5.0) -> bytes:
    """A GIF that plays a motion in so many seconds."""
    from slipcircle.workbench.outputs.film import film

    return render(lambda figure: film(motion, figure, max(2, round(_FRAMES * seconds)), seconds), (7.0, 4.6), ".gif")
