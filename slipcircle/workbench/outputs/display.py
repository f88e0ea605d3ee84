"""Pictures and HTML of results. The methods of `Motion` and `Study` call these functions by name."""

import os
from collections.abc import Mapping
from typing import Any

from slipcircle.base.kinds import Function, PathName, Values
from slipcircle.core import Motion
from slipcircle.derivatives import Sensitivity
from slipcircle.workbench.common import files
from slipcircle.workbench.common.conversions import motion_table as table_of
from slipcircle.workbench.common.conversions import to_dict, to_pandas, to_xarray
from slipcircle.workbench.common.quantities import factors_of as factors_of_safety
from slipcircle.workbench.outputs.influence import important_standstills, sensitivity_part
from slipcircle.workbench.outputs.page import live
from slipcircle.workbench.outputs.pictures import files as pictures
from slipcircle.workbench.outputs.pictures import film, plots, studyplots, suiteplots
from slipcircle.workbench.outputs.pictures.plotstyle import new_figure
from slipcircle.workbench.outputs.tables import table_lines
from slipcircle.workbench.stability.critical import Critical
from slipcircle.workbench.studies.groundmotions import GroundMotions
from slipcircle.workbench.studies.study import Study

__all__ = ["animate", "factors_of_safety", "html", "plot", "text", "to_dict", "to_pandas", "to_xarray"]


# By type of the result, or of the records of a study: kind of the overview, function that gives its data, and panels.
_DRAWN: Mapping[type, tuple[str, Function, Values]] = {
    Critical: ("search", lambda critical: ("", critical), {}),
    Motion: ("motions", lambda motion: [motion], plots.PANELS),
    Study: ("study", lambda study: study, studyplots.PANELS),
    GroundMotions: ("suite", lambda study: study, suiteplots.PANELS),
    Sensitivity: ("sensitivity", lambda table: table, {}),
}


def plot(result: Any, what: PathName, ax: Any) -> Any:
    """Draw one panel of a result on an axis, or all panels on a new figure or into a file; return the axis or None.

    ``what`` is "overview", the name of a panel, or a path that ends in the name of an image format.
    """
    records = result.design.records if isinstance(result, Study) else None
    overview, drawn, panels = _DRAWN[type(records or result)]
    _one_lane(result)
    name = os.fspath(what)
    if name in panels:
        return panels[name](result, ax=ax)
    ends = [f".{kind}" for kind in (*pictures.KINDS, *["gif"] * isinstance(result, Motion))]
    is_path = name.lower().endswith((*ends,))
    if name != "overview" and not is_path:
        names = ", ".join(["overview", *panels])
        raise ValueError(f"plot: what = {name!r}: must be one of {names}, or end in {', '.join(ends)}")
    if ax is not None:
        raise ValueError("plot: the overview has several panels: leave out ax, or name one of its pictures")
    if is_path:
        return files.write_file(name, pictures.picture(overview, drawn(result), name))
    drawing = pictures.drawing(overview, drawn(result))
    return drawing.draw(new_figure(drawing.size)).axes[0]


def text(table: Sensitivity) -> str:
    """Return the most important derivatives of a motion as a table of text."""
    return "\n".join(table_lines(*sensitivity_part(table, important_standstills(table))))


def html(motion: Motion) -> str:
    """Return key results as an HTML table, for a single motion below its live page."""
    if motion.shape:
        return table_of(motion)
    return live.framed(motion) + table_of(motion)


def animate(motion: Motion, path: str, seconds: float) -> Any:
    """Return the animation of a slide of some duration in s, or write it into a .gif file if there is a path."""
    _one_lane(motion)
    if not path:
        return film.slide_animation(motion, seconds=seconds)
    if not path.lower().endswith(".gif"):
        raise ValueError(f"animate: {path}: must end in .gif")
    return files.write_file(path, pictures.slide_gif(motion, seconds))


def _one_lane(result: Any) -> None:
    """Raise ValueError for an ensemble of motions, which cannot be drawn as one picture."""
    if isinstance(result, Motion) and result.shape:
        raise ValueError(f"an ensemble of {len(result)} lanes cannot be drawn; select a lane, such as motion[0]")
