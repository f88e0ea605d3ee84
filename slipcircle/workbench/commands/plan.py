"""`slipcircle plan`: how a scene will be solved and what that costs, without solving it."""

import argparse
from dataclasses import asdict
from functools import partial

from slipcircle.core import plan
from slipcircle.workbench.commands.common import SCENE, add_files, with_scene_context
from slipcircle.workbench.files.scenefile import load
from slipcircle.workbench.outputs import pictures, tables
from slipcircle.workbench.outputs.tables import Answer

HELP = "how a scene will be solved, and what that costs"
FIELDS = ("effects", "left_out", "law", "method", "why", "fragments", "operations", "cost", "accuracy")  # in JSON


def options(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    subject = parser.add_mutually_exclusive_group(required=True)
    subject.add_argument("scene", nargs="?", metavar="SCENE", help=SCENE)
    subject.add_argument("--all", action="store_true", help="operation counts of every combination of effects")
    parser.add_argument("--ladder", action="store_true", help="solve with the effects added one by one")
    add_files(parser, "the ladder")


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    if options.all:
        table = tables.combinations_part()
        return Answer(lambda: [dict(zip(table.head, row, strict=True)) for row in table.rows], [table])
    if options.plot and not options.ladder:
        raise ValueError("plan: --plot: draws the ladder; give --ladder as well")
    chosen = plan(load(options.scene))
    equation = chosen.equation
    record = {"scene": chosen.scene.name, **{name: getattr(chosen, name) for name in FIELDS}}
    record["equation"] = equation.to_dict()
    if not options.ladder:
        return Answer(lambda: [record], [tables.plan_part(chosen), f"\n{equation}"])
    from slipcircle.workbench.studies.ladder import ladder

    rungs = with_scene_context(chosen.scene, ladder)
    record["ladder"] = [asdict(rung) for rung in rungs]
    drawn = {"plot": partial(pictures.picture, "ladder", rungs)}
    return Answer(lambda: [record], [tables.ladder_part(rungs, chosen.scene.name)], (), drawn)
