"""Inputs of the programs of a live page as functions of the numbers with sliders.

An input is a polynomial in these numbers in SI units: a Chebyshev interpolant on Lobatto points, in the numbers on
which it depends. PageInputs that are linear in them, as in all numbers of friction, are exact. In layered ground inputs
are quotients of polynomials by the friction that the mass loses with slip.
"""

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.polynomial import chebyshev

from generated import layout as ix
from slipcircle.base.kinds import Floats, Names, Shape, ValueDict
from slipcircle.base.text import drawn_unit
from slipcircle.core import Motion, Scene, plan, problem_of
from slipcircle.derivatives import parameter_value, with_parameter_arrays, with_parameters
from slipcircle.history import OUTPUTS, energy_unit, stress_unit, with_outputs
from slipcircle.layers import LayeredSection
from slipcircle.workbench.files.keys import Key
from slipcircle.workbench.outputs.page.start import NoFit, StartSeries, start_of
from slipcircle.workbench.outputs.pictures.plotstyle import quantity_words

DEGREE = 16  # greatest degree of an interpolant in one number
ROUNDING = 4e-15  # relative to the greatest value; smaller coefficients are dropped
TRIALS = 64  # number of random places for the comparison of interpolants with exact inputs
ACCURACY = 1e-12  # of an ensemble, so that its functions of the rotation are as close as for a scene
SMOOTH = 1e-12  # greatest error of inputs of a default slider, relative to their greatest values
_STEEP = 2  # degree of rows in sliders of strength; of a greater degree are quotients by the friction lost with slip
_LEAST_LOST = 0.1  # least friction lost with slip, over the greatest one between the ends of sliders


class Slider(NamedTuple):
    """Number of a scene with its range in the unit of its key."""

    number: Key
    low: float
    high: float

    @property
    def ends(self) -> Floats:
        """Ends of the range in SI units, an array of shape (2,)."""
        return np.asarray(self.number.to_si(np.array([self.low, self.high])), dtype=np.float64)

    def present(self, scene: Scene) -> float:
        """Return the scene's own value in the unit of the key."""
        return float(self.number.from_si(parameter_value(scene, self.number.name) or 0.0))

    def described(self, scene: Scene) -> ValueDict:
        """Return key, label, unit, range and present value of the slider as JSON data for the page."""
        number = self.number
        return {
            "key": number.key,
            "name": number.name,
            "label": quantity_words(number),
            "unit": number.written or "g" * number.key.endswith("_g"),
            "low": self.low,
            "high": self.high,
            "value": self.present(scene),
            "si": self.ends.tolist(),
            "tangent": number.tangent,
            "per_unit": number.per_unit,
        }


class PageInputs:
    """PageInputs of a scene's programs as rows of numbers: cells by name, tables, and other numbers of the page."""

    def __init__(self, scene: Scene, sliders: Sequence[Slider], accuracy: float) -> None:
        self.scene, self.sliders = scene, sliders
        self.start: StartSeries | None = None
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
        self.divided: list[int] = []  # rows that fits describe times the friction lost with slip
        friction = [row for row, name in enumerate(self.names) if name.endswith((".peak", ".residual"))]
        is_quotient = isinstance(scene.arc, LayeredSection) and len(friction) == 2
        self.friction = sorted(friction, key=lambda row: self.names[row]) if is_quotient else []
        self.base = self._rows(self.motion, 1)[:, 0]

    def at(self, shares: Floats) -> Floats:
        """Return the rows, (rows, places), at places of the sliders, (sliders, places), from -1 to 1.

        A row is one number that the page needs, as a function of the sliders.
        """
        scene = self.scene_at(shares)
        alike = self._rows(_at_start(scene, ACCURACY), shares.shape[1])
        if len(alike) != self.base.size:
            raise NoFit
        alike[self.names.index("ORDER")] = self.problem.start["ORDER"]
        return self.multiplied(alike)

    def multiplied(self, rows: Floats) -> Floats:
        """Return rows, those in `divided` multiplied by the friction that the mass loses with slip."""
        if self.divided:
            rows[self.divided] *= self.lost(rows)
        return rows

    def lost(self, rows: Floats) -> Floats:
        """Return the mean peak friction minus the mean residual friction in rows, (rows, places), as (places,)."""
        peak, residual = rows[self.friction]
        return np.asarray(peak - residual)

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
        """Return the greatest absolute value of each row, (rows,), from values (rows, places).

        For tables it is the greatest over all pieces at each power.
        """
        magnitudes = np.abs(values)
        sizes = magnitudes.max(axis=1)
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
        """Return the rows of a motion at its start, (rows, count), for its ``count`` lanes."""
        problem = motion.problem
        start = with_outputs(problem, (*OUTPUTS, "energy")).start
        rows = [np.broadcast_to(start[name], (1, count)) for name in self.names]
        for table in problem.tables():
            for values, axes in ((table.breaks, 1), (table.coefficients, 2)):
                lanes = count if values.ndim > axes else 1
                flat = values.reshape(-1, lanes)
                rows.append(np.broadcast_to(flat, (len(flat), count)))
        rows += [np.broadcast_to(np.ravel(value), (1, count)) for value in _others(motion).values()]
        if self.start:
            rows[-1] = np.ones((1, count))  # factor of safety, which the page solves for
            rows.append(self.start.rows(motion.plan.scene))
        return np.concatenate(rows)


def _at_start(scene: Scene, accuracy: float) -> Motion:
    """Return a scene before its integration, with its functions of the rotation tabulated to the end."""
    chosen = plan(scene, accuracy)
    problem = problem_of(chosen)
    problem.reach_farther(np.full(problem.lanes, np.inf))
    return Motion(chosen, np.zeros((ix.RESULTS, *scene.shape)), False, problem)


def _others(motion: Motion) -> ValueDict:
    """Return units of dimensionless numbers, in units of output, by SI unit, and the factor of safety at the start."""
    arc = motion.plan.scene.arc
    radius = np.asarray(arc.radius)
    second = np.asarray(arc.time_scale)
    units = {"rad": 1.0, "s": second, "m": radius, "m/s": radius / second, "m/s^2": radius / second**2}
    units |= {"Pa": stress_unit(arc), "J": energy_unit(arc)}
    units = {unit: drawn_unit(unit)[0] * size for unit, size in units.items()}
    return units | {"factor_of_safety": motion.factor_of_safety}


class Interpolant(NamedTuple):
    """Interpolants of some rows in some of the sliders, as weights of a few functions of these.

    Weights have the shape (rows, functions), Chebyshev coefficients (functions, product of the degrees + 1).
    """

    of: Shape
    degrees: Shape
    rows: list[int]
    weights: Floats
    coefficients: Floats

    def at(self, shares: Floats) -> Floats:
        """Return the values of the rows, (rows, places), at places of the sliders, (sliders, places)."""
        powers = [chebyshev.chebvander(shares[k], d) for k, d in zip(self.of, self.degrees, strict=True)]
        product = powers[0]
        for power in powers[1:]:
            product = (product[:, :, None] * power[:, None, :]).reshape(len(product), -1)
        return self.weights @ (self.coefficients @ product.T)


def _lobatto(degree: int) -> Floats:
    """Return the Chebyshev-Lobatto points from 1 to -1, (degree + 1,)."""
    return np.cos(np.pi * np.arange(degree + 1) / degree)


def fits_of(inputs: PageInputs, most: float = math.inf) -> list[Interpolant]:
    """Return interpolants of all rows that vary; raise `NoFit` if they need more than ``most`` numbers."""
    present = np.array([[_share(s, inputs.scene)] for s in inputs.sliders])
    degrees = _degrees(inputs, present)
    steep = {row for of_slider in degrees for row, degree in of_slider.items() if degree > _STEEP}
    if steep and inputs.friction:
        inputs.divided = sorted(steep)
        degrees = _degrees(inputs, present)
    groups: dict[tuple[tuple[int, int], ...], list[int]] = {}
    for row in sorted({row for of_slider in degrees for row in of_slider}):
        key = tuple((k, of_slider[row]) for k, of_slider in enumerate(degrees) if row in of_slider)
        groups.setdefault(key, []).append(row)
    if any(math.prod(degree + 1 for _, degree in key) > most for key in groups):
        raise NoFit
    grids = [_grid(present, *zip(*key, strict=True)) for key in groups]
    values = _at_each(inputs, grids)
    fits = [_fit(inputs, of_group, key, rows) for of_group, (key, rows) in zip(values, groups.items(), strict=True)]
    if sum(fit.weights.size + fit.coefficients.size for fit in fits) > most:
        raise NoFit
    return fits


def _at_each(inputs: PageInputs, grids: Sequence[Floats]) -> list[Floats]:
    """Return the rows at each of several grids of places, (sliders, places), of which one ensemble is laid out."""
    if not grids:
        return []
    values = inputs.at(np.concatenate(grids, axis=1))
    counts = [grid.shape[1] for grid in grids]
    return np.split(values, np.cumsum(counts)[:-1], axis=1)


def _grid(present: Floats, of: Shape, degrees: Shape) -> Floats:
    """Return the places, (sliders, places), of Lobatto points in some sliders, by their indices and degrees.

    ``present`` are the places of the scene's own values, (sliders, 1), at which the other sliders remain.
    """
    axes = np.meshgrid(*map(_lobatto, degrees), indexing="ij")
    places = np.repeat(present, axes[0].size, axis=1)
    places[list(of)] = [axis.ravel() for axis in axes]
    return places


def _degrees(inputs: PageInputs, present: Floats) -> list[dict[int, int]]:
    """Return for each slider the degree of each row that varies with it, by the index of the row.

    ``present`` is as in `_grid`.
    """
    inverse = np.linalg.inv(chebyshev.chebvander(_lobatto(DEGREE), DEGREE)).T
    of_sliders = []
    grids = [_grid(present, (k,), (DEGREE,)) for k in range(len(present))]
    for values in _at_each(inputs, grids):
        finite = np.where(np.isfinite(values), values, 0.0)
        counted = np.abs(finite @ inverse) > ROUNDING * inputs.sizes(finite)[:, None]
        degrees = DEGREE - np.argmax(counted[:, ::-1], axis=1)
        (varied,) = np.nonzero(np.any(counted[:, 1:], axis=1))
        of_sliders.append(dict(zip(varied.tolist(), degrees[varied].tolist(), strict=True)))
    return of_sliders


def _fit(inputs: PageInputs, values: Floats, key: tuple[tuple[int, int], ...], rows: list[int]) -> Interpolant:
    """Return the interpolant of rows of the same degrees, by a singular value decomposition of its coefficients.

    ``values`` are all rows at the `_grid` of ``key``, pairs of slider index and degree; ``rows`` are row indices.
    """
    of, degrees = zip(*key, strict=True)
    sizes = inputs.sizes(values)[rows, None]
    coefficients = (values[rows] / sizes).reshape(len(rows), *(degree + 1 for degree in degrees))
    for axis, degree in enumerate(degrees, 1):
        inverse = np.linalg.inv(chebyshev.chebvander(_lobatto(degree), degree))
        coefficients = np.moveaxis(np.tensordot(inverse, coefficients, (1, axis)), 0, axis)
    left, size, right = np.linalg.svd(coefficients.reshape(len(rows), -1), full_matrices=False)
    counted = size > ROUNDING * size[0]
    weights = sizes * left[:, counted] * size[counted]
    # Rounded to 15 digits, which make pages smaller.
    return Interpolant(of, degrees, rows, np.vectorize(lambda weight: float(f"{weight:.15g}"))(weights), right[counted])


def _share(slider: Slider, scene: Scene) -> float:
    """Return the place of the scene's own value in the range of a slider, from -1 to 1."""
    low, high = slider.ends.tolist()
    value = float(parameter_value(scene, slider.number.name) or 0.0)
    return min(max((2 * value - low - high) / (high - low), -1.0), 1.0)


def greatest_error(inputs: PageInputs, fits: Sequence[Interpolant]) -> float:
    """Return the greatest error of interpolated inputs at random places, relative to their greatest values."""
    if not fits:
        return 0.0
    shares = np.random.default_rng(7).uniform(-1.0, 1.0, (len(inputs.sliders), TRIALS))
    exact = inputs.at(shares)
    if inputs.divided:
        lost = inputs.lost(exact)
        if lost.min() < _LEAST_LOST * lost.max():
            return math.inf
    sizes = inputs.sizes(exact)
    errors = [np.abs(fit.at(shares) - exact[fit.rows]).max(axis=1) / sizes[fit.rows] for fit in fits]
    return float(np.max(np.concatenate(errors)))
