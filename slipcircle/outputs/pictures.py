"""Pictures as bytes, for files: drawn without a display, and the same whatever the user's settings of matplotlib."""

import io
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from slipcircle.base import files
from slipcircle.motion.motion import Motion
from slipcircle.outputs import plots, slopeplot, studyplots
from slipcircle.outputs.plotstyle import missing, work

_Picture = tuple[str, str, Callable[[Any], Any], tuple[float, float]]  # name, caption, what draws it, inches
_KINDS = ("png", "svg", "pdf", "jpg")
_MOST = 20  # scenes in one picture
_FRAMES, _SECONDS = 40, 5  # of an animation


def check(command: str, path: str = "", scenes: int = 1) -> None:
    """See that pictures can be drawn, and one of this file's type and of so many scenes; one scene may be animated."""
    try:
        import matplotlib  # noqa: F401
    except ImportError as error:
        raise missing() from error
    kind, known = Path(path).suffix[1:].lower(), (*_KINDS, *["gif"] * (command == "run"))
    if path and kind not in known:
        raise ValueError(f"{command}: --plot {path}: must end in one of .{', .'.join(known)}")
    if path and scenes > (1 if kind == "gif" else _MOST):
        most = "moves one scene" if kind == "gif" else f"shows at most {_MOST} scenes"
        raise ValueError(f"{command}: --plot {path}: {most}; --report has room for all {scenes}")


def render(draw: Callable[[Any], Any], size: tuple[float, float], path: str) -> bytes:
    """What a function draws on an empty figure of a size in inches, as a file whose name ends in .png, .svg, ..."""
    from matplotlib import rc_context, style
    from matplotlib.figure import Figure

    kind = path.rpartition(".")[2].lower()
    # Also the names within an SVG, and its metadata, are to be the same every time.
    with style.context("default"), rc_context({"svg.hashsalt": "slipcircle"}):
        figure = Figure(figsize=size, dpi=70 if kind == "gif" else 120, layout="constrained")
        drawn = draw(figure)
        held = io.BytesIO()
        dated = {"svg": {"Date": None}, "pdf": {"CreationDate": None}}
        with warnings.catch_warnings():  # a name may hold letters that the font does not have
            warnings.filterwarnings("ignore", "Glyph .* missing from font", UserWarning)
            if kind == "gif":
                figure.draw_without_rendering()
                figure.set_layout_engine("none")  # which would lay out every frame anew
                return _played(drawn)
            figure.savefig(held, format=kind, metadata=dated.get(kind))
    return held.getvalue()


def _played(animation: Any) -> bytes:
    """An animation as a GIF."""
    from matplotlib.animation import PillowWriter

    with TemporaryDirectory() as folder:
        path = Path(folder) / "slide.gif"
        animation.save(path, PillowWriter(fps=_FRAMES // _SECONDS))
        return path.read_bytes()


def overview(motions: Sequence[Motion], path: str) -> bytes:
    """The overviews of motions, one above the other, as a file by its name; of a gif, the slide itself."""
    if path.lower().endswith("gif"):
        return render(lambda figure: plots.animate(motions[0], figure, _FRAMES), (7.0, 5.5), path)

    sizes = [plots.size(m) for m in motions]
    heights = [height for _, height in sizes]

    def draw(figure: Any) -> None:
        parts = figure.subfigures(len(motions), 1, squeeze=False, height_ratios=heights)[:, 0]
        for motion, part in zip(motions, parts, strict=True):
            plots.overview(motion, part)

    return render(draw, (sizes[0][0], sum(heights)), path)


def of(motion: Motion) -> list[tuple[str, str, Callable[[str], bytes]]]:
    """The pictures of a report: name, caption, and a function from a kind of file to its bytes."""

    found: list[_Picture] = [
        ("Section", "The section: forces at the start; the mass at the start, at its peak velocity and at the end.",
         lambda figure: plots.section(motion, figure.add_subplot()), (8.0, 6.0)),
    ]  # fmt: skip
    if motion.moves:
        found += [
            ("Histories", "The motion over time. Where the mobilised friction is below the friction needed to stand "
             "still the mass tends to speed up, elsewhere to slow down.",
             lambda figure: plots.histories(motion, figure.add_gridspec(2, 2), figure, 2, 2), (11.0, 6.5)),
            ("Phase plane", "Speed against displacement, and the energy: what is dissipated and what is kinetic make "
             f"up the {work(motion)}.", lambda figure: plots.phase_plane(motion, figure.add_subplot()), (8.0, 5.0)),
        ]  # fmt: skip
    if "shaking" in motion.plan.effects:
        found.append(
            ("Shaking", "What shakes the scene, over gravity; at the start it would move as soon as k_h passes k_y.",
             lambda figure: plots.shaking(motion, figure.add_subplot()), (8.0, 3.0))
        )  # fmt: skip
    return [(name, caption, partial(render, draw, size)) for name, caption, draw, size in found]


# What commands draw of what they found, and on how many inches.
_DRAWN: Mapping[str, tuple[Callable[[Any, Any], Any], Callable[[Any], tuple[float, float]]]] = {
    "study": (studyplots.overview, studyplots.size),
    "sensitivity": (studyplots.tornados, lambda x: (8.0, len(x.distinct) * (1.6 + 0.3 * len(x.parameters)))),
    "backanalysis": (studyplots.explained, lambda x: (2.0 + 4.5 * len(x.units), 0.6 + 3.4 * len(x.observed))),
    "search": (slopeplot.critical_circle, lambda _: (9.0, 6.0)),
    "ladder": (lambda x, figure: plots.ladder(x, figure.add_subplot()), lambda x: (9.0, 1.5 + 0.5 * len(x))),
}


def picture(what: str, found: Any, path: str) -> bytes:
    """What a command found, as a file by its name: one of `_DRAWN`."""
    draw, size = _DRAWN[what]
    return render(partial(draw, found), size(found), path)


def write(paths: Iterable[str], what: str, found: Any) -> None:
    """The same into files."""
    for path in paths:
        files.write(path, picture(what, found, path))
