"""Model of a live page: the programs of a scene, and their inputs as functions of the numbers with sliders.

An input is a polynomial in these numbers in SI units: a Chebyshev interpolant on Lobatto points, in the numbers on
which it depends. Inputs that are linear in them, as in all numbers of friction, are exact. The motion itself is not
interpolated: the page integrates it with the compiled text of `generated/_flow.c`.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.polynomial import chebyshev

from generated import layout as ix
from slipcircle.base.kinds import Floats, Names, Shape, ValueDict
from slipcircle.core import STATUS_OF_END, Motion, Problem, Scene, Status, plan, problem_of, program_integers, solve
from slipcircle.derivatives import parameter_value, parameters, with_parameter_arrays, with_parameters
from slipcircle.history import OUTPUTS, energy_unit, of_means, stress_unit, with_outputs
from slipcircle.messages import ROUNDED, RUNS, perturbed_runs
from slipcircle.stiff import may_creep
from slipcircle.workbench.common.quantities import HISTORY
from slipcircle.workbench.files.numbers import Number, by_name
from slipcircle.workbench.outputs.page.start import NoFit, Start, start_of
from slipcircle.workbench.outputs.pictures.plotstyle import FIRST, quantity_words

DEGREE = 16  # greatest degree of an interpolant in one number
ROUNDING = 4e-15  # relative to the greatest value; smaller coefficients are dropped
TRIALS = 64  # number of random places for the comparison of interpolants with exact inputs
ACCURACY = 1e-12  # of an ensemble, so that its functions of the rotation are as close as for a scene
SHARE = 0.5  # default range of a slider to both sides of the value, relative to it
CODES = ("ENDED", "STOPPED", "TOO_LONG", "MOST_TURNS")  # for the page
# Numbers with sliders by default; those that shape a section are cheap to lay out for an arc alone.
_STRENGTH = ("friction", "soils", "cohesion", "pore_pressure", "shaking")
_SHAPE = ("radius", "dip")
_NOT_STRENGTH = ("unit_weight", "saturated_unit_weight", "crack", "start", "duration", "frequency")
MOST_SLIDERS = 8
SMOOTH = 1e-12  # greatest error of inputs of a default slider, relative to their greatest values
MOST_COEFFICIENTS = 1300  # greatest number of coefficients of interpolants, for a page below 130 kB
MOST_NUMBERS = 60_000  # greatest number of values in tables


class Slider(NamedTuple):
    """Number of a scene with its range in the unit of its key."""

    number: Number
    low: float
    high: float

    @property
    def ends(self) -> Floats:
        """Ends of the range in SI units, an array of shape (2,)."""
        return np.asarray(self.number.to_si(np.array([self.low, self.high])), dtype=np.float64)

    def described(self, scene: Scene) -> ValueDict:
        """Return key, label, unit, range and present value of the slider as JSON data for the page."""
        number = self.number
        return {
            "key": number.key,
            "name": number.name,
            "label": quantity_words(number),
            "unit": number.unit or "g" * number.key.endswith("_g"),
            "low": self.low,
            "high": self.high,
            "value": float(number.from_si(parameter_value(scene, number.name))),
            "si": self.ends.tolist(),
            "tangent": number.tangent,
            "per_unit": number.per_unit,
        }


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
    sliders = [slider for name in names if (slider := _around(scene, keys[name]))]
    influences = {slider: _influence(scene, slider) for slider in sliders}
    chosen = list[Slider]()
    for slider in sorted(sliders, key=lambda slider: -influences[slider]):
        more = [*chosen, slider]
        is_full = len(chosen) == MOST_SLIDERS
        matters = influences[slider] or slider.number.name.endswith("residual")  # also of a mass that does not move
        if matters and not is_full and interpolates(scene, more, SMOOTH, MOST_COEFFICIENTS):
            chosen = more
    return chosen


def _influence(scene: Scene, slider: Slider) -> float:
    """Return the greatest change of the run-out in m over both ends and the present value of a slider."""
    values = np.array([*slider.ends, parameter_value(scene, slider.number.name)])
    cases, _ = with_parameter_arrays(scene, {slider.number.name: values})
    return float(np.ptp(np.nan_to_num(solve(cases).run_out)))


def interpolates(scene: Scene, sliders: Sequence[Slider], error: float, most: float = math.inf) -> bool:
    """Return whether interpolants reach a relative error with at most ``most`` coefficients."""
    try:
        inputs = _Inputs(scene, sliders, plan(scene).accuracy)
        return _greatest_error(inputs, _fits(inputs, most)) < error
    except NoFit:
        return False


def _around(scene: Scene, number: Number) -> Slider | None:
    """Return a slider around the scene's value, narrowed until both ends are valid, or None if it gets too narrow."""
    value = float(number.from_si(parameter_value(scene, number.name)))
    share = 0.1 if number.name in _SHAPE else SHARE
    while value and share > 0.01:
        low, high = sorted(float(f"{value * (1 + side * share):.3g}") for side in (-1, 1))
        slider = Slider(number, low, high)
        _, invalid = with_parameter_arrays(scene, {number.name: slider.ends})
        if not np.any(invalid):
            return slider
        share /= 2
    return None


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


class _Inputs:
    """Inputs of a scene's programs as rows of numbers: cells by name, tables, and other numbers of the page."""

    def __init__(self, scene: Scene, sliders: Sequence[Slider], accuracy: float) -> None:
        self.scene, self.sliders = scene, sliders
        self.start: Start | None = None
        if sliders:
            shares = np.random.default_rng(3).uniform(-1.0, 1.0, (len(sliders), TRIALS))
            self.start = start_of(scene, self.scene_at(shares))
        if self.start:  # the page multiplies strength by the factor that it solves for
            self.scene = replace(scene, strength_factor=1.0)
        self.motion = _at_start(self.scene, accuracy)
        self.problem = self.motion.problem
        self.forces = with_outputs(self.problem, (*OUTPUTS, "energy"))
        self.names: Names = tuple(self.forces.start)
        self.others = _others(self.motion)
        self.base = self._rows(self.motion, 1)[:, 0]

    def at(self, shares: Floats) -> Floats:
        """Return the rows, (rows, places), at places of the sliders, (sliders, places), from -1 to 1."""
        scene = self.scene_at(shares)
        alike = self._rows(_at_start(scene, ACCURACY), shares.shape[1])
        if len(alike) != self.base.size:
            raise NoFit
        alike[self.names.index("ORDER")] = self.problem.start["ORDER"]
        return alike

    def scene_at(self, shares: Floats) -> Scene[Any]:
        """Return the ensemble of scenes at places of the sliders, (sliders, places), from -1 to 1."""
        ends = [slider.ends for slider in self.sliders]
        of_places = zip(self.sliders, ends, shares, strict=True)
        values = {s.number.name: (low + high) / 2 + (high - low) / 2 * x for s, (low, high), x in of_places}
        scene, invalid = with_parameter_arrays(self.scene, values)
        if np.any(invalid):
            worst = int(np.argmax(invalid))
            with_parameters(self.scene, {name: float(value[worst]) for name, value in values.items()})  # raises
        return scene

    def scaled(self) -> list[int]:
        """Return the indices of the rows that are proportional to the strength factor."""
        twice = _at_start(replace(self.scene, strength_factor=2.0), ACCURACY)
        doubled = np.isclose(self._rows(twice, 1)[:, 0], 2.0 * self.base, rtol=SMOOTH, atol=0.0)
        rows: list[int] = np.flatnonzero(doubled & np.isfinite(self.base) & (self.base != 0.0)).tolist()
        return rows

    def sizes(self, values: Floats) -> Floats:
        """Return the greatest absolute value of each row, (rows,); for tables, over all pieces at each power."""
        sizes = np.abs(values).max(axis=1)
        at = len(self.names)
        for table in self.problem.tables():
            pieces, terms = table.coefficients.shape[:2]
            first = at + pieces
            at = first + pieces * terms
            of_powers = sizes[first:at].reshape(pieces, terms)
            of_powers[:] = of_powers.max(axis=0)
        if self.start:
            of_series = sizes[len(sizes) - self.start.terms :]
            of_series[:] = of_series.max()
        return np.maximum(sizes, np.finfo(np.float64).tiny)

    def _rows(self, motion: Motion, count: int) -> Floats:
        problem = motion.problem
        start = with_outputs(problem, (*OUTPUTS, "energy")).start
        rows = [np.broadcast_to(start[name], (1, count)) for name in self.names]
        for table in problem.tables():
            for values in (table.breaks, table.coefficients):
                shared = values.ndim < (2 if values is table.breaks else 3)
                flat = values.reshape(-1, 1) if shared else values.reshape(-1, count)
                rows.append(np.broadcast_to(flat, (flat.shape[0], count)))
        rows += [np.broadcast_to(np.ravel(value), (1, count)) for value in _others(motion).values()]
        if self.start:
            rows.append(self.start.rows(motion.plan.scene))
        return np.concatenate(rows)


def _at_start(scene: Scene, accuracy: float) -> Motion:
    """Return a scene before its integration, with its functions of the rotation tabulated to the end."""
    chosen = plan(scene, accuracy)
    problem = problem_of(chosen)
    problem.reach_farther(np.full(problem.lanes, np.inf))
    return Motion(chosen, np.zeros((len(ix.CELLS), *scene.shape)), False, problem)


def _others(motion: Motion) -> ValueDict:
    """Return units of the dimensionless numbers in SI units, and the factor of safety at the start, by name."""
    arc = motion.plan.scene.arc
    radius = np.asarray(arc.radius)
    second = np.asarray(arc.time_scale)
    units = {"rad": 1.0, "s": second, "m": radius, "m/s": radius / second, "m/s^2": radius / second**2}
    units |= {"Pa": stress_unit(arc), "J": energy_unit(arc)}
    return units | {"factor_of_safety": motion.factor_of_safety}


class Fit(NamedTuple):
    """Interpolants of some rows in some of the sliders; the coefficients have shape (rows, *(degrees + 1))."""

    of: Shape
    degrees: Shape
    rows: list[int]
    coefficients: Floats

    def at(self, shares: Floats) -> Floats:
        """Return the values of the rows, (rows, places), at places of the sliders, (sliders, places)."""
        powers = [chebyshev.chebvander(shares[k], d) for k, d in zip(self.of, self.degrees, strict=True)]
        product = powers[0]
        for power in powers[1:]:
            product = (product[:, :, None] * power[:, None, :]).reshape(len(product), -1)
        return self.coefficients.reshape(len(self.rows), -1) @ product.T


def _lobatto(degree: int) -> Floats:
    return np.cos(np.pi * np.arange(degree + 1) / degree)


def _fits(inputs: _Inputs, most: float = math.inf) -> list[Fit]:
    """Return interpolants of all rows that vary, or raise `NoFit` above ``most`` coefficients."""
    present = np.array([[_share(s, inputs.scene)] for s in inputs.sliders])
    of_rows: dict[int, dict[int, int]] = {}  # degrees by slider
    alone: dict[int, Floats] = {}  # coefficients in the last slider
    for k in range(len(inputs.sliders)):
        for row, degree, coefficients in _along(inputs, present, k):
            of_rows.setdefault(row, {})[k] = degree
            alone[row] = coefficients
    groups: dict[tuple[tuple[int, int], ...], list[int]] = {}
    for row, degrees in of_rows.items():
        groups.setdefault(tuple(degrees.items()), []).append(row)
    if sum(len(rows) * math.prod(degree + 1 for _, degree in key) for key, rows in groups.items()) > most:
        raise NoFit
    return [_fit(inputs, present, key, rows, alone) for key, rows in groups.items()]


def _along(inputs: _Inputs, present: Floats, k: int) -> Iterator[tuple[int, int, Floats]]:
    """Yield index, degree and coefficients of each row that varies with slider ``k``."""
    places = np.repeat(present, DEGREE + 1, axis=1)
    places[k] = _lobatto(DEGREE)
    values = inputs.at(places)
    sizes = inputs.sizes(values)
    with np.errstate(invalid="ignore"):
        (varied,) = np.nonzero(values.max(axis=1) - values.min(axis=1) > ROUNDING * sizes)
    coefficients = np.linalg.solve(chebyshev.chebvander(places[k], DEGREE), values[varied].T).T
    for row, of_row in zip(varied.tolist(), coefficients, strict=True):
        counted = np.flatnonzero(np.abs(of_row) > ROUNDING * sizes[row])
        if counted.size and counted[-1]:
            yield row, int(counted[-1]), of_row


def _fit(
    inputs: _Inputs, present: Floats, key: tuple[tuple[int, int], ...], rows: list[int], alone: dict[int, Floats]
) -> Fit:
    """Return the interpolant of rows of the same degrees; for one slider the coefficients are known."""
    of, degrees = zip(*key, strict=True)
    if len(of) == 1:
        return Fit(of, degrees, rows, np.stack([alone[row][: degrees[0] + 1] for row in rows]))
    axes = np.meshgrid(*(_lobatto(degree) for degree in degrees), indexing="ij")
    places = np.repeat(present, axes[0].size, axis=1)
    places[list(of)] = [axis.ravel() for axis in axes]
    values = inputs.at(places)[rows].reshape(len(rows), *axes[0].shape)
    for axis, degree in enumerate(degrees, 1):
        inverse = np.linalg.inv(chebyshev.chebvander(_lobatto(degree), degree))
        values = np.moveaxis(np.tensordot(inverse, values, (1, axis)), 0, axis)
    return Fit(of, degrees, rows, values)


def _share(slider: Slider, scene: Scene) -> float:
    """Return the place of the scene's own value in the range of a slider, from -1 to 1."""
    low, high = slider.ends.tolist()
    value = float(parameter_value(scene, slider.number.name) or 0.0)
    share = (2 * value - low - high) / (high - low)
    return min(max(share, -1.0), 1.0)


def _greatest_error(inputs: _Inputs, fits: Sequence[Fit]) -> float:
    """Return the greatest error of all inputs at random places, relative to their greatest values."""
    if not fits:
        return 0.0
    shares = np.random.default_rng(7).uniform(-1.0, 1.0, (len(inputs.sliders), TRIALS))
    wanted = inputs.at(shares)
    sizes = inputs.sizes(wanted)
    errors = [np.abs(fit.at(shares) - wanted[fit.rows]).max(axis=1) / sizes[fit.rows] for fit in fits]
    return float(np.max(np.concatenate(errors)))


def model(scene: Scene, sliders: Sequence[Slider]) -> ValueDict:
    """Return JSON data for the page to solve the scene with any values of its sliders."""
    inputs = _Inputs(scene, sliders, plan(scene).accuracy)
    fits = _fits(inputs)
    end = {Status.MOVING: FIRST} if scene.end_time is None else {}
    places = {name: k for k, name in enumerate(ix.CELLS)}
    return {
        "names": inputs.names,
        "others": [*inputs.others],
        "entries": places,
        "base": _plain(inputs.base),
        "fits": [[fit.of, fit.degrees, fit.rows, _plain(fit.coefficients)] for fit in fits],
        "tables": [_table(name, inputs.problem) for name in _table_names(inputs.problem)],
        "programs": [_program(problem, inputs.names) for problem in (inputs.problem, inputs.forces)],
        "runs": _runs(inputs),
        "start": inputs.start and _start(inputs, inputs.start),
        "rounded": ROUNDED,
        "stresses": of_means(scene) is scene,
        "input_error": _greatest_error(inputs, fits),
        "statuses": [[status.name, end.get(status, status.words), status.reason] for status in Status],
        "of_end": STATUS_OF_END.tolist(),
        "codes": {name: getattr(ix, name) for name in CODES},
        "labels": {name: quantity.label for name, quantity in HISTORY.items()},
    }


def _start(inputs: _Inputs, start: Start) -> ValueDict:
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


def _table_names(problem: Problem) -> list[str]:
    return [table.name for table in problem.program.tables]


def _table(name: str, problem: Problem) -> ValueDict:
    """Return a table as JSON data without its breaks and coefficients, which are rows."""
    data = problem.data[name]
    pieces, terms = data.coefficients.shape[:2]
    return {"pieces": pieces, "terms": terms, "jumps": _plain(data.jumps), "sine": data.sine, "open": data.open}


def _program(problem: Problem, names: Names) -> ValueDict:
    """Return a program as integers, and the places of its inputs, outputs and additional states."""
    program = problem.program
    return {
        "code": program_integers(program),
        "cells": len(program.cells),
        "registers": len(program.registers),
        "places": [program.places.get(name, -1) for name in names],
        "outputs": {name: program.roles[name] for name in OUTPUTS if name in program.roles},
        "states": {program.cells[cell]: cell for cell, _, _ in program.states[2:]},
    }


def _runs(inputs: _Inputs) -> ValueDict:
    """Return number and input factors, by row, of the perturbed runs that estimate the error."""
    rounding = inputs.scene.arc.rounding
    cells = inputs.problem.cells()
    runs = perturbed_runs(inputs.problem, slice(None), rounding)
    program = inputs.problem.program
    factors: dict[int, Any] = {}
    for row, name in enumerate(inputs.names):
        place = program.places.get(name, -1)
        moved = place >= 0 and math.isfinite(cells[place, 0]) and np.ptp(runs[place]) > 0.0
        if moved:
            factors[row] = (runs[place] / cells[place]).tolist()
    return {"count": RUNS, "factors": factors}


def _plain(values: Any) -> list[Any]:
    """Return numbers as a flat list for JSON; infinite numbers become the text "Infinity", as in JavaScript."""
    return [x if math.isfinite(x) else str(x).replace("inf", "Infinity") for x in np.ravel(values).tolist()]
