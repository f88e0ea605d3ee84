"""`slipcircle sensitivity`: derivatives of a motion, printed, drawn or as JSON."""

import argparse
from functools import partial

from slipcircle.core import solve
from slipcircle.workbench.commands.common import add_files, add_scene, add_units
from slipcircle.workbench.files.numbers import by_name
from slipcircle.workbench.files.scenefile import load
from slipcircle.workbench.outputs.influence import important_standstills, sensitivity_part
from slipcircle.workbench.outputs.pictures.files import picture
from slipcircle.workbench.outputs.tables import Answer


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to a parser."""
    add_units(parser)
    add_files(parser, "the effect of a change in each parameter")
    add_scene(parser)


def run(options: argparse.Namespace) -> Answer:
    """Run the command and return its answer."""
    motion = solve(load(options.scene))
    derivatives, name = motion.sensitivity(), motion.plan.scene.name
    keys_by_name = by_name(motion.plan.scene)
    keys = {parameter: keys_by_name[parameter].key for parameter in derivatives.parameters}
    stops = important_standstills(derivatives)
    further = {"keys": keys, "elasticities": derivatives.elasticities, "standstills": stops}
    record = vars(derivatives) | {"scene": name} | further
    warnings = [f"{name}: {warning}" for warning in derivatives.warnings]
    drawn = {"plot": partial(picture, "sensitivity", derivatives)}
    return Answer(lambda: [record], [sensitivity_part(derivatives, stops)], warnings, drawn)
