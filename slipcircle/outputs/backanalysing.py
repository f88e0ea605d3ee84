"""`slipcircle backanalyse`: the numbers of a scene that explain an observed motion, each with its error."""

import argparse
from itertools import combinations
from typing import Any

from slipcircle.files.scenefile import load
from slipcircle.motion import quantities
from slipcircle.motion.quantities import OUTCOMES, digits_left, known, plain, shown, words
from slipcircle.outputs import tables
from slipcircle.studies.backanalysis import FITTED, BackAnalysis, backanalyse

# The options by outcome; each ends in its unit.
OPTIONS = {n: f"--{n}-{q.unit}".replace("_", "-").replace("/", "-") for n, q in OUTCOMES.items()}


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    for name, option in OPTIONS.items():
        parser.add_argument(option, type=_observed, dest=name, metavar="X[+-S]",
                            help=f"observed {OUTCOMES[name].label}, and its standard error: 400+-20")  # fmt: skip
    parser.add_argument("--field", action="append", metavar="KEY[=LOW:HIGH]", help="what is looked for, a scene "
                        "file's key, by default friction.angle_deg, and between which values; several for several "
                        "observations; a point's coordinate by its number from 0: ground.points_m.3.y")  # fmt: skip


def _observed(text: str) -> float | tuple[float, float]:
    """400, or 400+-20."""
    value, *error = text.replace("\N{PLUS-MINUS SIGN}", "+-").split("+-")
    try:
        return (float(value), float(error[0])) if len(error) == 1 else float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text}: must be a number, or one with its error: 400+-20") from None


def run(options: argparse.Namespace) -> BackAnalysis:
    """What the options ask for."""
    fields, bounds = [], {}
    for text in options.field or ["friction.angle_deg"]:
        name, given, between = text.partition("=")
        fields.append(name)
        if given:
            try:
                low, high = map(float, between.split(":"))
            except ValueError:
                raise ValueError(f"--field {text}: must be KEY or KEY=LOW:HIGH: friction.angle_deg=5:15") from None
            bounds[name] = low, high
    seen = {name: getattr(options, name) for name in OUTCOMES}
    if all(value is None for value in seen.values()):
        raise ValueError(f"backanalyse: nothing observed: give one of {', '.join(OPTIONS.values())}")
    return backanalyse(load(options.scene), field=fields, bounds=bounds, **seen)


def show(found: BackAnalysis) -> None:
    """Print the table."""
    numbers = [f"solution {k}" for k in range(1, len(found.solutions) + 1)]
    heads = numbers if len(numbers) > 1 else [found.motion.plan.scene.name]
    tables.show(["", *heads], rows(found), caption=f"by {found.method}")


def record(found: BackAnalysis) -> dict[str, Any]:
    """A back-analysis as JSON holds it: null for what is not known; matrices by fields in their order."""
    derived = ("standard_errors", "correlation")
    solutions = [
        vars(s) | {n: getattr(s, n) for n in derived} | {"motion": quantities.record(s.motion)} for s in found.solutions
    ]
    return plain({"scene": found.motion.plan.scene.name} | vars(found) | {"solutions": solutions})


def rows(found: BackAnalysis) -> tables.Rows:
    """A back-analysis as rows of a table, a column for each solution."""
    columns = []
    for s in found.solutions:
        cells, errors = {}, s.standard_errors or {}
        for name, value in s.values.items():
            error = errors.get(name, 0.0)
            said = f"{known(value, error)} +- {known(error, error)}" if error > 0.0 else ""
            cells[name] = said or shown(value, digits_left(s.error_estimate))
        if s.correlation is not None:
            names = list(s.values)
            for i, j in combinations(range(len(names)), 2):
                cells[f"correlation of {names[i]} and {names[j]}"] = f"{s.correlation[i, j]:+z.3f}"
        for name in OUTCOMES:
            seen, sigma = found.observed.get(name, (None, None))
            of = "" if seen is None else f" (observed {shown(seen, 6)}" + (f" +- {sigma:.2g})" if sigma else ")")
            value = float(OUTCOMES[name].read(s.motion))
            cells[words(name, OUTCOMES[name].unit)] = shown(value, digits_left(s.motion.error_estimate)) + of
        if found.method == FITTED:
            weighed = all(sigma for _, sigma in found.observed.values())
            free = found.degrees_of_freedom
            cells[f"chi-square, degrees of freedom {free}" if weighed else "misfit"] = f"{s.chi_square:.3g}"
        columns.append(cells | {"swings": f"{len(s.motion.phases) - 1}", "numerical error": f"{s.error_estimate:.1e}"})
    return tables.beside(columns)
