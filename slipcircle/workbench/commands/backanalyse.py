"""`slipcircle backanalyse`: parameters of a scene that explain an observed motion, with standard errors."""

import argparse
from dataclasses import replace
from functools import partial
from itertools import combinations

from slipcircle.base.kinds import TextDict, ValueDict
from slipcircle.base.text import digits_left, number_text, output_unit
from slipcircle.workbench.commands import values
from slipcircle.workbench.commands.common import add_files, add_scene, add_units
from slipcircle.workbench.common.quantities import OBSERVABLE, to_error
from slipcircle.workbench.common.units import UNITS_OF_KEYS, suffix
from slipcircle.workbench.files.scenefile import load
from slipcircle.workbench.outputs import json_records as records
from slipcircle.workbench.outputs.pictures.files import picture
from slipcircle.workbench.outputs.tables import Answer, ResultTable, beside
from slipcircle.workbench.stability.critical import SlopeScene
from slipcircle.workbench.stability.stability import METHODS
from slipcircle.workbench.studies.backanalysis import FITTED, BackAnalysis, Solution, backanalyse

# Option names by outcome; each name ends with the unit.
OPTIONS = {name: f"--{q.head}".replace("_", "-") for name, q in OBSERVABLE.items()}
_OTHER = "; or in another unit, such as -ft"


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to a parser."""
    forms = "and its standard error: 400+-20; an interval: 300:450; or a limit: '<60'"
    for name, option in OPTIONS.items():
        units = UNITS_OF_KEYS.get(OBSERVABLE[name].unit, {"": 1.0})
        stem = option.removesuffix(suffix(next(iter(units))).replace("_", "-"))
        either = parser.add_mutually_exclusive_group()
        for number, (unit, size) in enumerate(units.items()):
            either.add_argument(
                option if number == 0 else stem + suffix(unit).replace("_", "-"),
                type=partial(values.observed, size=size),
                dest=name,
                metavar="X[+-S]|LOW:HIGH|<X|>X",
                help=argparse.SUPPRESS
                if number
                else f"observed {OBSERVABLE[name].label}, {forms}{_OTHER * (len(units) > 1)}",
            )
    parser.add_argument("--reach-m", type=values.removed, help=argparse.SUPPRESS)
    parser.add_argument(
        "--field",
        action="append",
        metavar="KEY[=LOW:HIGH]",
        help="key of a parameter to fit (default friction.angle_deg) and optional bounds; repeatable, with one "
        "observation for each parameter; coordinates of a point: ground.points_m.3.y, counted from 0",
    )
    method = "method of the factor of safety, which also starts the motion; default: the scene's method"
    parser.add_argument("--method", choices=METHODS, help=method)
    add_units(parser)
    add_files(parser, "the observed quantities against the fitted parameters")
    add_scene(parser)


def run(options: argparse.Namespace) -> Answer:
    """Run the command and return its answer."""
    form = "KEY or KEY=LOW:HIGH: friction.angle_deg=5:15"
    fields = values.values_by_key("field", options.field or [], form, values.low_and_high)
    observed = {name: getattr(options, name) for name in OBSERVABLE}
    scene = load(options.scene)
    if options.method:
        if not isinstance(scene, SlopeScene):
            raise ValueError(
                f"backanalyse: --method {options.method}: an [arc] has the paper's factor alone; leave it out"
            )
        scene = replace(scene, start=options.method)
    if not scene.observed and all(value is None for value in observed.values()):
        choices = ", ".join(OPTIONS.values())
        raise ValueError(f"backanalyse: no observation: give one of {choices}, or [observed] in the scene file")
    bounds = {key: ends for key, ends in fields.items() if ends}
    fit = backanalyse(scene, field=list(fields) or None, bounds=bounds, **observed)
    name = fit.motion.plan.scene.name
    columns = [_column(fit, solution) for solution in fit.solutions]
    heads = [name] if len(columns) == 1 else [f"solution {k}" for k in range(1, len(columns) + 1)]
    table = ResultTable(["", *heads], beside(columns), note=f"by {fit.method}")
    drawn = {"plot": partial(picture, "backanalysis", fit)}
    return Answer(lambda: [_record(fit)], [table], [f"{name}: {warning}" for warning in fit.warnings], drawn)


def _record(fit: BackAnalysis) -> ValueDict:
    """Return a back-analysis as a mapping for JSON, with null for unknown values."""
    solutions = []
    for solution in fit.solutions:
        derived = {"standard_errors": solution.standard_errors, "correlation": solution.correlation}
        solutions.append(vars(solution) | derived | {"motion": records.record(solution.motion)})
    return {"scene": fit.motion.plan.scene.name} | vars(fit) | {"solutions": solutions}


def _column(fit: BackAnalysis, solution: Solution) -> TextDict:
    """Return the cells of a solution as text by label: fitted values, outcomes with observations, and the misfit."""
    cells, errors = {}, solution.standard_errors or {}
    for name, value in solution.values.items():
        error = errors.get(name, 0.0)
        cells[name] = number_text(value, digits_left(solution.error_estimate))
        if error > 0.0:
            cells[name] = f"{to_error(value, error)} +- {to_error(error, error)}"
    if solution.correlation is not None:
        for (i, one), (j, other) in combinations(enumerate(solution.values), 2):
            cells[f"correlation of {one} and {other}"] = f"{solution.correlation[i, j]:+z.3f}"
    motion = solution.motion
    for name, quantity in OBSERVABLE.items():
        if not (name in fit.observed or quantity.where(motion)):
            continue
        value = float(quantity.read(motion))
        cells[quantity.heading] = number_text(output_unit(quantity.unit)[0] * value, digits_left(motion.error_estimate))
        cells[quantity.heading] += _observation(fit, name, value)
    if fit.method == FITTED:
        weighted = all(sigma for _, sigma in fit.observed.values())
        label = f"chi-square, degrees of freedom {fit.degrees_of_freedom}" if weighted else "misfit"
        cells[label] = f"{solution.chi_square:.3g}"
    return cells | {"swings": f"{max(motion.turnings, 0)}", "numerical error": f"{solution.error_estimate:.1e}"}


def _observation(fit: BackAnalysis, name: str, computed: float) -> str:
    """Return an observation in brackets: its interval, or its value with its standard error; "" if not observed.

    ``name`` is that of the outcome, and ``computed`` its value in SI units.
    """
    if name not in fit.observed:
        return ""
    factor, _ = output_unit(OBSERVABLE[name].unit)
    if name in fit.intervals:
        interval = fit.intervals[name]
        side = "inside" if interval.low <= computed <= interval.high else "outside"
        return f" ({side if interval.limit is None else 'limit:'} {interval.times(factor)})"
    value, sigma = fit.observed[name]
    error = f" +- {factor * sigma:.2g}" if sigma else ""
    return f" (observed {number_text(factor * value, 6)}{error})"
