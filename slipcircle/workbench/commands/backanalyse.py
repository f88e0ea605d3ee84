"""`slipcircle backanalyse`: the numbers of a scene that explain an observed motion, each with its error."""

import argparse
from itertools import combinations
from typing import Any

from slipcircle.base.text import digits_left, shown
from slipcircle.workbench.commands import values as read
from slipcircle.workbench.commands.common import add_files, add_scene
from slipcircle.workbench.common import quantities
from slipcircle.workbench.common.quantities import OUTCOMES, to_error
from slipcircle.workbench.files.scenefile import load
from slipcircle.workbench.outputs import pictures
from slipcircle.workbench.outputs.tables import Answer, Part, beside
from slipcircle.workbench.studies.backanalysis import FITTED, BackAnalysis, Solution, backanalyse

HELP = "the friction, or another number, that explains an observed motion"
# The options by outcome; each ends in its unit.
OPTIONS = {n: f"--{n}-{q.unit}".replace("_", "-").replace("/", "-") for n, q in OUTCOMES.items()}


def options(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    for name, option in OPTIONS.items():
        parser.add_argument(
            option,
            type=read.observed,
            dest=name,
            metavar="X[+-S]",
            help=f"observed {OUTCOMES[name].label}, and its standard error: 400+-20",
        )
    parser.add_argument(
        "--field",
        action="append",
        metavar="KEY[=LOW:HIGH]",
        help="parameter to fit, a scene "
        "file's key, by default friction.angle_deg, and between which values; several for several "
        "observations; a point's coordinate by its number from 0: ground.points_m.3.y",
    )
    add_files(parser, "what was observed over the fields")
    add_scene(parser)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    form = "KEY or KEY=LOW:HIGH: friction.angle_deg=5:15"
    fields = read.by_key("field", options.field or [], form, read.bounds)
    seen = {name: getattr(options, name) for name in OUTCOMES}
    if all(value is None for value in seen.values()):
        raise ValueError(f"backanalyse: nothing observed: give one of {', '.join(OPTIONS.values())}")
    bounds = {key: ends for key, ends in fields.items() if ends}
    found = backanalyse(load(options.scene), field=list(fields) or None, bounds=bounds, **seen)
    pictures.write(options.plot, "backanalysis", found)
    name = found.motion.plan.scene.name
    columns = [_column(found, s) for s in found.solutions]
    heads = [name]
    if len(columns) > 1:
        heads = [f"solution {k}" for k in range(1, len(columns) + 1)]
    table = Part(["", *heads], beside(columns), note=f"by {found.method}")
    warnings = [f"{name}: {warning}" for warning in found.warnings]
    return Answer(lambda: [_record(found)], [table], warnings)


def _record(found: BackAnalysis) -> dict[str, Any]:
    """As JSON holds it: null for what is not known; matrices by fields in their order."""
    derived = ("standard_errors", "correlation")
    solutions = [
        vars(s) | {n: getattr(s, n) for n in derived} | {"motion": quantities.record(s.motion)} for s in found.solutions
    ]
    return {"scene": found.motion.plan.scene.name} | vars(found) | {"solutions": solutions}


def _column(found: BackAnalysis, s: Solution) -> dict[str, str]:
    """A solution by labels: its values, their correlations, outcomes, how well they fit."""
    errors = s.standard_errors or {}
    cells = {name: _value_text(value, errors.get(name, 0.0), s.error_estimate) for name, value in s.values.items()}
    if s.correlation is not None:
        for (i, one), (j, other) in combinations(enumerate(s.values), 2):
            cells[f"correlation of {one} and {other}"] = f"{s.correlation[i, j]:+z.3f}"
    digits = digits_left(s.motion.error_estimate)
    for name, quantity in OUTCOMES.items():
        outcome = float(quantity.read(s.motion))
        cells[quantity.heading] = shown(outcome, digits) + _observed_text(found, name)
    if found.method == FITTED:
        is_weighted = all(sigma for _, sigma in found.observed.values())
        label = f"chi-square, degrees of freedom {found.degrees_of_freedom}" if is_weighted else "misfit"
        cells[label] = f"{s.chi_square:.3g}"
    cells["swings"] = f"{len(s.motion.phases) - 1}"
    cells["numerical error"] = f"{s.error_estimate:.1e}"
    return cells


def _value_text(value: float, standard_error: float, error_estimate: float) -> str:
    if standard_error > 0.0:
        return f"{to_error(value, standard_error)} +- {to_error(standard_error, standard_error)}"
    return shown(value, digits_left(error_estimate))


def _observed_text(found: BackAnalysis, name: str) -> str:
    """What stands behind an outcome: its observation with the standard error."""
    if name not in found.observed:
        return ""
    seen, sigma = found.observed[name]
    error = f" +- {sigma:.2g}" if sigma else ""
    return f" (observed {shown(seen, 6)}{error})"
