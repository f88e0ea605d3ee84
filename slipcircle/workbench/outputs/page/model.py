"""Model of a live page: the programs of a scene, and their inputs as functions of the numbers with sliders.

The motion itself is not interpolated: the page integrates it with the compiled text of `generated/_flow.c`.
"""

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from generated import layout as ix
from generated.program import integers_of
from slipcircle.base.kinds import Names, ValueDict
from slipcircle.core import ROUNDED, RUNS, STATUS_OF_END, Motion, Problem, Scene, Status, perturbed_runs, plan, solve
from slipcircle.derivatives import parameter_value, parameters, with_parameter_arrays
from slipcircle.history import OUTPUTS, of_means
from slipcircle.stiff import may_creep
from slipcircle.workbench.common.quantities import HISTORY
from slipcircle.workbench.files.numbers import Key, by_name, in_output_unit
from slipcircle.workbench.outputs.page.inputs import SMOOTH, PageInputs, Slider, fits_of, greatest_error
from slipcircle.workbench.outputs.page.start import NoFit, StartSeries
from slipcircle.workbench.outputs.pictures.plotstyle import FIRST

SHARES = (0.5, 0.3, 0.2)  # default ranges of a slider to both sides of the value, relative to it
CODES = ("ENDED", "STOPPED", "TOO_LONG", "MOST_TURNS")  # for the page
# Numbers with sliders by default, of the shape for an arc alone, which is cheap to lay out.
_STRENGTH = ("friction", "soils", "cohesion", "pore_pressure", "shaking")
_SHAPE = ("radius", "dip")
_MOST_OF_SHAPE = 0.1  # relative range of these
_NOT_STRENGTH = ("unit_weight", "saturated_unit_weight", "crack", "start", "duration", "frequency")
MOST_SLIDERS = 8
MOST_COEFFICIENTS = 1660  # greatest number of numbers of interpolants, for a page below 130 kB
MOST_NUMBERS = 60_000  # greatest number of values in tables


def default_sliders(scene: Scene) -> list[Slider]:
    """Return sliders for strength, load and the shape of an arc, by decreasing influence on the run-out."""
    keys = by_name(scene)
    names = []
    for name in parameters(scene):
        parts = name.split(".")
        if parts[0] in _STRENGTH and parts[-1] not in _NOT_STRENGTH:
            names.append(name)
    if "ground" not in scene.arc.quantities:
        names += _SHAPE
    ranges = {name: [*_ranges(scene, in_output_unit(keys[name]))] for name in names}
    influences = {name: _influence(scene, sliders[0]) for name, sliders in ranges.items() if sliders}
    chosen = list[Slider]()
    for name in sorted(influences, key=lambda name: -influences[name]):
        if influences[name] or name.endswith("residual"):  # also of a mass that does not move
            more = ([*chosen, slider] for slider in ranges[name])
            fitting = (sliders for sliders in more if interpolates(scene, sliders, SMOOTH, MOST_COEFFICIENTS))
            chosen = next(fitting, chosen)
    return chosen[:MOST_SLIDERS]


def _influence(scene: Scene, slider: Slider) -> float:
    """Return the greatest change of the run-out in m over both ends and the present value of a slider."""
    values = np.array([*slider.ends, parameter_value(scene, slider.number.name)])
    cases, _ = with_parameter_arrays(scene, {slider.number.name: values})
    return float(np.ptp(np.nan_to_num(solve(cases).run_out)))


def interpolates(scene: Scene, sliders: Sequence[Slider], error: float, most: float = math.inf) -> bool:
    """Return whether interpolants over the sliders reach a relative error with at most ``most`` coefficients."""
    try:
        inputs = PageInputs(scene, sliders, plan(scene).accuracy)
        return greatest_error(inputs, fits_of(inputs, most)) < error
    except NoFit:
        return False


def _ranges(scene: Scene, number: Key) -> Iterator[Slider]:
    """Yield sliders around the scene's value with valid ends, from the widest to the narrowest."""
    value = float(number.from_si(parameter_value(scene, number.name)))
    for share in SHARES if value else ():
        low, high = sorted(float(f"{value * (1 + side * share):.3g}") for side in (-1, 1))
        slider = Slider(number, low, high)
        _, invalid = with_parameter_arrays(scene, {number.name: slider.ends})
        if not np.any(invalid) and (share <= _MOST_OF_SHAPE or number.name not in _SHAPE):
            yield slider


def unsolvable(motion: Motion) -> str:
    """Return the reason why a page cannot solve a scene, as text; empty if it can."""
    scene, problem = motion.plan.scene, motion.problem
    if problem.functions:
        return "its friction or cohesion is a function in Python"
    if may_creep(problem) and scene.end_time is None:
        return "it creeps, and the page cannot take implicit steps"
    size = sum(data.breaks.size + data.coefficients.size for data in problem.tables())
    if size > MOST_NUMBERS:
        return f"its records have {size} numbers, more than a page holds ({MOST_NUMBERS})"
    return ""


def page_model(scene: Scene, sliders: Sequence[Slider]) -> ValueDict:
    """Return JSON data for the page to solve the scene with any values of its sliders."""
    inputs = PageInputs(scene, sliders, plan(scene).accuracy)
    fits = fits_of(inputs)
    base = inputs.multiplied(inputs.base.copy())
    base[[row for fit in fits for row in fit.rows]] = 0.0
    end = {Status.MOVING: FIRST} if scene.end_time is None else {}
    places = {name: k for k, name in enumerate(ix.CELLS)}
    return {
        "names": inputs.names,
        "others": [*inputs.others],
        "entries": places,
        "base": _plain(base),
        "divided": inputs.divided,
        "divisor": inputs.friction,
        "fits": [[fit.of, fit.degrees, fit.rows, _plain(fit.weights), _plain(fit.coefficients)] for fit in fits],
        "tables": [_table(inputs.problem.data[table.name]) for table in inputs.problem.program.tables],
        "programs": [_program(problem, inputs.names) for problem in (inputs.problem, inputs.forces)],
        "runs": _runs(inputs),
        "start": inputs.start and _start(inputs, inputs.start),
        "rounded": ROUNDED,
        "stresses": of_means(scene) is scene and not scene.arc.in_standing_water,
        "input_error": greatest_error(inputs, fits),
        "statuses": [[status.name, end.get(status, status.words), status.reason] for status in Status],
        "of_end": STATUS_OF_END.tolist(),
        "codes": {name: getattr(ix, name) for name in CODES},
        "labels": {name: quantity.label for name, quantity in HISTORY.items()},
    }


def _start(inputs: PageInputs, start: StartSeries) -> ValueDict:
    """Return bounds and degree of the series of a start, and the rows that follow from them, as JSON data."""
    at = inputs.base.size - len(start.rows(inputs.scene))
    return {
        "at": at,
        "low": start.low.tolist(),
        "high": start.high.tolist(),
        "degree": start.degree,
        "scaled": inputs.scaled(),
        "factor": at - 1,
    }


def _table(data: Any) -> ValueDict:
    """Return a table (piecewise function) as JSON data: counts, jumps and flags.

    Its breaks and coefficients are rows of `PageInputs` instead.
    """
    pieces, terms = data.coefficients.shape[:2]
    return {"pieces": pieces, "terms": terms, "jumps": _plain(data.jumps), "sine": data.sine, "open": data.open}


def _program(problem: Problem, names: Names) -> ValueDict:
    """Return a program as integers, and the places of its inputs, outputs and additional states."""
    program = problem.program
    return {
        "code": integers_of(program),
        "cells": len(program.cells),
        "registers": len(program.registers),
        "places": [program.places.get(name, -1) for name in names],
        "outputs": {name: program.roles[name] for name in OUTPUTS if name in program.roles},
        "states": {program.cells[cell]: cell for cell, _, _ in program.states[2:]},
    }


def _runs(inputs: PageInputs) -> ValueDict:
    """Return the number of the perturbed runs that estimate the error, and by row the factors of its number in each."""
    cells = inputs.problem.cells()
    runs = perturbed_runs(inputs.problem)
    program = inputs.problem.program
    factors: dict[int, Any] = {}
    for row, name in enumerate(inputs.names):
        place = program.places.get(name, -1)
        start = cells[place, 0]
        if place < 0 or not math.isfinite(start):
            continue
        of_runs = runs[place]
        if np.ptp(of_runs) > 0.0:
            factors[row] = (of_runs / start).tolist()
    return {"count": RUNS, "factors": factors}


def _plain(values: Any) -> list[Any]:
    """Return numbers as a flat list for JSON; infinite numbers become the text "Infinity", as in JavaScript."""
    return [x if math.isfinite(x) else str(x).replace("inf", "Infinity") for x in np.ravel(values).tolist()]
