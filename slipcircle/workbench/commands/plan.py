"""`slipcircle plan`: the equation of motion of a scene and the method that would solve it."""

import argparse
from dataclasses import asdict
from functools import partial

from slipcircle.core import plan
from slipcircle.workbench.commands.common import add_files, add_scene, with_scene_context
from slipcircle.workbench.files.scenefile import load
from slipcircle.workbench.outputs import tables
from slipcircle.workbench.outputs.pictures.files import picture
from slipcircle.workbench.outputs.tables import Answer

FIELDS = ("effects", "left_out", "law", "method", "why", "accuracy")  # in JSON


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to a parser."""
    add_scene(parser)
    parser.add_argument("--ladder", action="store_true", help="solve repeatedly, with one more effect each time")
    add_files(parser, "the ladder")


def run(options: argparse.Namespace) -> Answer:
    """Run the command and return its answer."""
    if options.plot and not options.ladder:
        raise ValueError("plan: --plot: draws the ladder; give --ladder as well")
    chosen = plan(load(options.scene))
    equation = chosen.equation
    record = {"scene": chosen.scene.name, **{name: getattr(chosen, name) for name in FIELDS}}
    record["equation"] = equation.to_dict()
    if not options.ladder:
        return Answer(lambda: [record], [tables.plan_part(chosen), f"\n{equation}"])
    from slipcircle.workbench.cost.ladder import effect_ladder

    rungs = with_scene_context(chosen.scene, effect_ladder)
    record["ladder"] = [asdict(rung) for rung in rungs]
    drawn = {"plot": partial(picture, "ladder", rungs)}
    return Answer(lambda: [record], [tables.ladder_part(rungs, chosen.scene.name)], (), drawn)
