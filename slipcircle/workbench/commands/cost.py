"""`slipcircle cost`: what accuracy costs in time, for a scene or a kernel, measured on this machine."""

import argparse
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from functools import partial
from typing import TYPE_CHECKING

from slipcircle.workbench.commands.common import SCENE, add_files, with_scene_context
from slipcircle.workbench.common.quantities import plain, time_text
from slipcircle.workbench.files.scenefile import load
from slipcircle.workbench.files.shipped import find
from slipcircle.workbench.outputs import pictures
from slipcircle.workbench.outputs.tables import Answer, Part

if TYPE_CHECKING:
    from slipcircle.workbench.cost.rows import Row

NOTE = (
    "error: largest relative error seen; bound: proved of a kernel, estimated of a scene; time: of the processor, for "
    "one of N elements or scenes, median. frontier: no other way is faster and as accurate, or as fast and more so."
)


def options(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    names = f"{SCENE}; or a kernel, such as polar_moment. Default: %(default)s"
    parser.add_argument("name", nargs="?", metavar="NAME", default="vaiont", help=names)
    add_files(parser, "error against time")


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    from slipcircle.workbench.cost import kernels, scenes
    from slipcircle.workbench.outputs.info import machine

    if options.name in kernels.KERNELS:
        rows = kernels.of_kernel(options.name)
        title = options.name
    else:
        try:
            find(options.name)
        except ValueError as error:
            raise ValueError(f"{error}; kernels are {', '.join(kernels.KERNELS)}") from error
        scene = load(options.name)
        rows = with_scene_context(scene, scenes.of_scene)
        title = scene.name
    measured_on = machine()
    record = {"name": title, "machine": measured_on, "rows": [plain(asdict(row)) for row in rows]}
    drawn = {"plot": partial(pictures.picture, "cost", rows)}
    return Answer(lambda: record, _parts(title, rows, measured_on), (), drawn)


def _parts(title: str, rows: Sequence["Row"], machine: str) -> Iterator[Part]:
    """The table, and below it what follows from it."""
    cells = []
    for row in rows:
        error = "no digit" if row.error >= 1.0 else _error(row.error)
        bound = "" if row.bound is None else _error(row.bound)
        cells.append([row.group, row.way, f"{row.count}", error, bound, time_text(1e9 * row.seconds), row.verdict])
    yield Part(["", "way", "N", "error", "bound", "time", "verdict"], cells, title, " ".join(_notes(rows, machine)))


def _error(error: float) -> str:
    return f"{error:.1e}" if error else "0"


def _notes(rows: Sequence["Row"], machine: str) -> Iterator[str]:
    from slipcircle.workbench.cost.rows import RECOMMENDED
    from slipcircle.workbench.cost.scenes import ALONE

    if rows[0].group == ALONE:
        yield "A single scene is solved to rounding, whatever accuracy is requested; in ensembles accuracy saves time."
    for row in rows:
        if row.bound is not None and row.error > row.bound:
            yield f"The error of {row.way} ({row.group}) is above its bound: a bug, please report it."
        if row.verdict == RECOMMENDED:
            fastest = min((other for other in rows if other.group == row.group), key=lambda other: other.seconds)
            taken, least = (f"{one.way} ({time_text(1e9 * one.seconds)} a scene)" for one in (row, fastest))
            yield f"Recommended for ensembles: accuracy {taken}; the fastest is {least}."
    yield from (NOTE, f"{machine}.")
