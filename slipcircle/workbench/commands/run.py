"""`slipcircle run`: solve scenes, print their motions side by side and write files."""

import argparse
from collections.abc import Iterator, Sequence
from functools import partial

from slipcircle.base.progress import tracked
from slipcircle.core import Motion, solve
from slipcircle.messages import OUTSIDE
from slipcircle.workbench.commands import values
from slipcircle.workbench.commands.common import REPORT, SCENE, add_files, add_units, with_scene_context
from slipcircle.workbench.common.trace import csv
from slipcircle.workbench.files.loaded import warnings_of
from slipcircle.workbench.files.numbers import uncertain_numbers
from slipcircle.workbench.files.scenefile import load
from slipcircle.workbench.files.shipped import find
from slipcircle.workbench.outputs import tables
from slipcircle.workbench.outputs.json_records import record
from slipcircle.workbench.outputs.pictures.files import picture
from slipcircle.workbench.outputs.tables import Answer, Files


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to a parser."""
    parser.add_argument("scenes", nargs="+", metavar="SCENE", help=SCENE)
    parser.add_argument("--verbose", action="store_true", help="all results, other methods and errors")
    picture = "section, motion and energy, and the slide itself as .gif; may be given more than once"
    table = "the motion over time, in SI units and full precision"
    slide = "a self-contained HTML page on which the slide can be dragged"
    add_units(parser)
    add_files(parser, picture, report=REPORT, csv=table, live=slide)
    varied = "parameter and range of the first slider of --live: friction.residual_deg=8:18"
    parser.add_argument("--vary", metavar="KEY=FROM:TO", help=varied)
    times = "times of --csv in s: 0:60:1; default: 401 evenly spaced times"
    parser.add_argument("--times", type=values.output_times, metavar="FROM:TO:STEP", help=times)


def run(options: argparse.Namespace) -> Answer:
    """Run the command and return its answer."""
    _check_options(options)
    scenes = [load(name) for name in options.scenes]
    sources = [find(name).read_bytes() for name in options.scenes] if options.report else []
    motions = [with_scene_context(scene, solve) for scene in tracked(scenes, "scenes solved")]
    contents: Files = {
        "csv": lambda _: csv(motions, options.times),
        "plot": partial(picture, "motions", motions),
        "live": lambda _: _live(motions[0], options.vary).encode(),
        "report": lambda _: _report(motions, sources, options.line).encode(),
    }
    parts = tables.motion_parts(motions, options.verbose)
    return Answer(lambda: [*map(record, motions)], parts, _warnings(motions), contents)


def _check_options(options: argparse.Namespace) -> None:
    """Raise ValueError for options that cannot be combined."""
    if options.times is not None and not options.csv:
        raise ValueError("run: --times: sets the rows of a CSV file; give --csv FILE as well")
    if options.vary and not options.live:
        raise ValueError("run: --vary: adds a slider to a page; give --live FILE as well")
    if options.live and len(options.scenes) > 1:
        raise ValueError("run: --live: shows one scene; use --report for several")


def _report(motions: Sequence[Motion], sources: Sequence[bytes], line: str) -> str:
    """Return the HTML report on motions, with the contents of their scene files and the typed command line."""
    from slipcircle.workbench.outputs.report import report

    return report(motions, sources, line)


def _live(motion: Motion, varied: str | None) -> str:
    """Return the HTML page of a motion; the parameter of ``--vary``, if given, has the first slider."""
    from slipcircle.workbench.outputs.page import live

    if not varied:
        return live.page(motion)
    form = "KEY=FROM:TO, such as friction.residual_deg=8:18"
    ((key, (low, high)),) = values.values_by_key("vary", [varied], form, values.low_and_high).items()
    return live.page(motion, with_scene_context(motion.plan.scene, lambda scene: live.slider(scene, key, low, high)))


def _warnings(motions: Sequence[Motion]) -> Iterator[str]:
    """Yield the warnings of all motions, each with the name of the scene."""
    for motion in motions:
        scene = motion.plan.scene
        for warning in warnings_of(motion):
            if not warning.startswith(OUTSIDE):  # the range of validity is printed
                yield f"{scene.name}: {warning}"
        if scene.uncertain:
            keys = ", ".join(uncertain.key for uncertain in uncertain_numbers(scene).values())
            yield f"{scene.name}: solved at the median of {keys}; sweep draws them"
