"""Pictures and HTML of results: methods of `Motion` and `Study` call these functions by name."""

from typing import Any

from slipcircle.core import Motion
from slipcircle.workbench.common import files
from slipcircle.workbench.common.forms import html as table_of
from slipcircle.workbench.common.forms import to_dict, to_pandas, to_xarray
from slipcircle.workbench.outputs import film, live, pictures, plots, studyplots, suiteplots
from slipcircle.workbench.outputs.plotstyle import known, new_figure
from slipcircle.workbench.studies.study import Study
from slipcircle.workbench.studies.suitestudy import SuiteStudy

__all__ = ["animate", "html", "plot", "to_dict", "to_pandas", "to_xarray"]


def plot(result: Motion | Study | SuiteStudy, what: str, ax: Any) -> Any:
    """One panel of a result on an axis, or all panels on a new figure."""
    drawn_by: Any = studyplots if isinstance(result, Study) else suiteplots
    if isinstance(result, Motion):
        drawn_by = plots
    _one_lane(result)
    known("plot: what", what, ("overview", *drawn_by.PANELS))
    if what != "overview":
        return drawn_by.PANELS[what](result, ax=ax)
    if ax is not None:
        raise ValueError("plot: the overview has several panels: leave out ax, or name one of its pictures")
    drawing = drawn_by.overview(result)
    return drawing.draw(new_figure(drawing.size)).axes[0]


def html(motion: Motion) -> str:
    """Key results as a table; for a single motion below its live slide."""
    return table_of(motion) if motion.shape else live.framed(motion) + table_of(motion)


def animate(motion: Motion, path: str, seconds: float) -> Any:
    """The slide as an animation to play, or written into a file."""
    _one_lane(motion)
    if not path:
        return film.animate(motion, seconds=seconds)
    if not path.lower().endswith(".gif"):
        raise ValueError(f"animate: {path}: must end in .gif")
    return files.write(path, pictures.slide(motion, seconds))


def _one_lane(result: Motion | Study | SuiteStudy) -> None:
    """Reject an ensemble, which has no single picture."""
    if isinstance(result, Motion) and result.shape:
        raise ValueError(f"a motion of {len(result)} lanes is not one picture: take one of them, motion[0]")
