"""Pictures as bytes for files, drawn without a display and independent of the user's matplotlib settings."""

import io
import warnings
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from slipcircle.base.kinds import Function, Pair
from slipcircle.base.optional import optional
from slipcircle.base.progress import tracked
from slipcircle.core import Motion
from slipcircle.workbench.outputs.pictures.plotstyle import figure_texts

if TYPE_CHECKING:
    from slipcircle.workbench.outputs.pictures.film import Film
    from slipcircle.workbench.outputs.pictures.sheets import Drawing

KINDS = ("png", "svg", "pdf", "jpg")
_FRAMES = 12  # frames per second
_HOLD = 2000  # milliseconds, duration of the last frame of a GIF
_COLOURS = 64  # number of colours of each frame


def check_picture(command: str, path: str = "", scenes: int = 1) -> None:
    """Raise an error if a command cannot draw a picture in the format of a path for this number of scenes.

    Requires matplotlib. Only ``run`` can write a .gif, and only for one scene.
    """
    optional("matplotlib", "pictures")
    kind = Path(path).suffix[1:].lower()
    kinds = (*KINDS, *["gif"] * (command == "run"))
    if path and kind not in kinds:
        raise ValueError(f"{command}: --plot {path}: must end in one of .{', .'.join(kinds)}")
    if kind == "gif" and scenes > 1:
        raise ValueError(f"{command}: --plot {path}: a .gif animates a single scene; use .png for all {scenes}")


def render(draw: Function, size: Pair, path: str) -> bytes:
    """Return a picture as the content of a file, in the format of the suffix of ``path``.

    ``draw`` draws on an empty figure, whose size is in inches; for .gif it returns a `Film`.
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
            "png": {"Description": "\n".join(figure_texts(figure))},  # for tests and screen readers
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
    """Return a film as a GIF that pauses at its last frame; the background is drawn once."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from PIL import Image

    figure = film.figure
    canvas: Any = FigureCanvasAgg(figure)
    for artist in film.moving:
        artist.set_animated(True)  # excludes them from the background
    canvas.draw()
    figure.set_layout_engine("none")  # otherwise every frame would be laid out again
    background = canvas.copy_from_bbox(figure.bbox)
    size = canvas.get_width_height()
    images = []
    for frame in tracked(range(len(film.times)), "frames drawn"):
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


def drawing(what: str, result: Any) -> "Drawing":
    """Return the drawing of a result by the kind of picture, ``what``; modules are loaded on first use.

    The result is of the type that this picture needs, such as a list of motions for "motions".
    """
    from slipcircle.workbench.outputs.pictures import (
        comparison,
        costplot,
        layerplot,
        plots,
        searchplot,
        sectionplot,
        studyplots,
        suiteplots,
        tornado,
    )
    from slipcircle.workbench.outputs.pictures.sheets import sheet

    of_one_panel: Mapping[str, tuple[Function, float]] = {  # with the height in inches
        "section": (plots.section, 5.0),
        "phase plane": (plots.phase_plane, 4.0),
        "shaking": (plots.shaking, 3.0),
        "stress along the arc": (layerplot.stress_along, 3.0),
        "slope": (sectionplot.slope, 5.0),
        "cost": (costplot.frontier, 5.0),
    }
    if what in of_one_panel:
        draw, height = of_one_panel[what]
        return sheet([(height, [partial(draw, result)])])
    if what == "ladder":
        return sheet([(1.2 + 0.4 * len(result), [partial(plots.ladder, result)])])
    if what == "motions" and len(result) == 1:
        return plots.motion_overview(*result)
    of_several: Mapping[str, Callable[[Any], Drawing]] = {
        "motions": comparison.comparison_overview,
        "histories": plots.histories,
        "suite": suiteplots.suite_overview,
        "study": studyplots.study_overview,
        "sensitivity": tornado.panels,
        "backanalysis": studyplots.explained,
        "search": searchplot.search_overview,
    }
    return of_several[what](result)


def picture(what: str, result: Any, path: str) -> bytes:
    """Return a picture of a result as bytes in the format of a file name; a GIF animates the first motion.

    ``what`` is a kind of picture of `drawing`, and ``path`` is a file name or only its suffix.
    """
    if path.lower().endswith("gif"):
        return slide_gif(result[0])
    return render(*drawing(what, result), path)


def slide_gif(motion: Motion, seconds: float = 5.0) -> bytes:
    """Return a GIF that plays a motion in ``seconds``."""
    from slipcircle.workbench.outputs.pictures.film import film

    return render(lambda figure: film(motion, figure, max(2, round(_FRAMES * seconds)), seconds), (7.0, 4.6), ".gif")
