"""The mathematics of implicit steps: the collocation method Radau IIA of order 23, and zeros of functions along a step.

A step of length h is the polynomial through the states y where it begins whose slope is the rate f at c_i h, c_i the
Radau points up to c_s = 1 (Hairer and Wanner, Solving Ordinary Differential Equations II, section IV.5). The states
Y_i there solve

    residual_i = Y_i - y - h sum_j a_ij f(Y_j) = 0,
    a_ij the integral from 0 to c_i of the polynomial that is 1 at c_j and 0 at the other points.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre

from slipcircle.base.checks import EPS
from slipcircle.base.kinds import Floats

TimeAndValue = tuple[float, float]
POINTS = 12
LEAST_SIZE = 1e-300  # by which what is 0 is divided
TOLERANCE = 1e-13  # of the last coefficients of a step's polynomial, relative
SAFETY = 0.9  # of the length of a step, over that for which its error is the tolerance


def _radau(count: int) -> tuple[Floats, Floats, Floats]:
    """Points c_i in (0, 1], a_ij, and the matrix from values at 0 and at the points to Legendre coefficients."""
    difference = np.zeros(count + 1)
    difference[-2:] = -1.0, 1.0  # P_s - P_(s-1), 1 among its roots
    points = legendre.legroots(difference).real  # complex since NumPy 2.5
    points[-1] = 1.0
    polynomials = np.eye(count)  # P_0 to P_(s-1)
    integrals = legendre.legint(polynomials, lbnd=-1, axis=1)
    at_points = legendre.legval(points, integrals.T).T
    values = legendre.legvander(points, count - 1)
    weights = at_points @ np.linalg.inv(values)
    with_start = np.array([-1.0, *points])
    values_with_start = legendre.legvander(with_start, count)
    to_legendre = np.linalg.inv(values_with_start)
    return (points + 1) / 2, weights / 2, to_legendre


AT, WEIGHTS, TO_LEGENDRE = _radau(POINTS)


class Present(NamedTuple):
    """A time, with the states and all registers there, (states, 1) and (registers, 1)."""

    time: float
    states: Floats
    registers: Floats


class Step(NamedTuple):
    """A step: Legendre coefficients of its states; times and registers at its points; its error, relative."""

    length: float
    legendre: Floats
    times: Floats
    registers: Floats
    error: float

    def states(self, since: Floats) -> Floats:
        """States at times since the step began, (states, times)."""
        place = 2 * since / self.length - 1
        return np.asarray(legendre.legval(place, self.legendre))


def step_through(start: Present, h: float, points: Floats, registers: Floats, rates: Floats, rounding: Floats) -> Step:
    """The step through states at the points, (points, states), with its error; ``rounding`` is that of the states.

    This is the size of its last coefficients, beside rounding, of which that of the time moves every state by as much
    as its rate.
    """
    values = np.vstack([start.states.T, points])
    coefficients = TO_LEGENDRE @ values
    largest_state = np.abs(values).max(axis=0)
    largest_rate = np.abs(rates).max(axis=0)
    rounding_of_time = 8 * EPS / TOLERANCE * start.time
    size = np.maximum(largest_state, LEAST_SIZE)
    size += rounding_of_time * largest_rate + rounding / TOLERANCE
    tail = np.abs(coefficients[-2:]).max(axis=0)
    error = np.max(tail / size)
    times = start.time + AT * h
    return Step(h, coefficients, times, registers, float(error))


def step_factor(error: float) -> float:
    """Ratio of the next step to this one for which its error is the tolerance."""
    ratio = TOLERANCE / max(error, LEAST_SIZE)
    return float(SAFETY * ratio ** (1 / POINTS))


def newton_correction(jacobian: Floats, h: float, residual: Floats, size: Floats) -> Floats | None:
    """(I - h a x df/dy)^-1 residual, all in units of ``size``; none where that is singular."""
    unknowns = residual.size
    coupling = np.einsum("ij,kjl->iljk", WEIGHTS, jacobian)
    coupling = coupling.reshape(unknowns, unknowns)
    matrix = np.eye(unknowns) - h * coupling
    sizes = size.ravel()
    relative_matrix = matrix * (sizes / sizes[:, None])
    relative_residual = residual / size
    try:
        correction = np.linalg.solve(relative_matrix, relative_residual.ravel())
    except np.linalg.LinAlgError:
        return None
    return np.asarray(correction.reshape(residual.shape))


def falling_zero(function: Callable[[float], float], low: TimeAndValue, high: TimeAndValue) -> float:
    """Where a function falls through zero between two times, by false position and, each third time, bisection."""
    begin, at_begin = low
    end, at_end = high
    least = 2 * EPS * abs(end)
    evaluations = 0
    while end - begin > 2 * least:
        bisects = evaluations % 3 == 2
        share = 0.5 if bisects else at_begin / (at_begin - at_end)
        middle = begin + share * (end - begin)
        middle = max(middle, begin + least)  # or only one end would move
        middle = min(middle, end - least)
        value = function(middle)
        evaluations += 1
        if value > 0.0:
            begin = middle
            at_begin = value
        else:
            end = middle
            at_end = value
    return float(end)
