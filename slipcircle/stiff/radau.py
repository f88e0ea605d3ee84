"""Collocation method Radau IIA of order 23, and zeros of functions within a step.

A step of length h is the polynomial through the initial states y whose slope equals the rate f at the times c_i h,
where c_i are the Radau points up to c_s = 1 (Hairer and Wanner, Solving Ordinary Differential Equations II, section
IV.5). The states Y_i at these times solve

    residual_i = Y_i - y - h sum_j a_ij f(Y_j) = 0,
    a_ij = integral from 0 to c_i of the polynomial that is 1 at c_j and 0 at the other points.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre

from slipcircle.base.arrays import EPS
from slipcircle.base.kinds import ArrayTriple, Floats, Pair

POINTS = 12
LEAST_SIZE = 1e-300  # divisor in place of 0
TOLERANCE = 1e-13  # relative size of the last coefficients of a step's polynomial
SAFETY = 0.9  # ratio of a step to the step whose error would equal the tolerance


def _radau(count: int) -> ArrayTriple:
    """Return the points c_i in (0, 1], a_ij, and the matrix from values at 0 and c_i to Legendre coefficients.

    `count` is the number s of points.
    """
    difference = np.zeros(count + 1)
    difference[-2:] = -1.0, 1.0  # P_s - P_(s-1), 1 among its roots
    points = legendre.legroots(difference).real  # complex since NumPy 2.5
    points[-1] = 1.0
    polynomials = np.eye(count)  # P_0 to P_(s-1)
    integrals = legendre.legint(polynomials, lbnd=-1, axis=1)
    at_points = legendre.legval(points, integrals.T).T
    weights = at_points @ np.linalg.inv(legendre.legvander(points, count - 1))
    with_start = np.array([-1.0, *points])
    values_with_start = legendre.legvander(with_start, count)
    to_legendre = np.linalg.inv(values_with_start)
    return (points + 1) / 2, weights / 2, to_legendre


AT, WEIGHTS, TO_LEGENDRE = _radau(POINTS)


class Present(NamedTuple):
    """Time, with the states (states, 1) and all registers (registers, 1) at this time."""

    time: float
    states: Floats
    registers: Floats


class ImplicitStep(NamedTuple):
    """Implicit step: Legendre coefficients of its states, times and registers at its points, and its relative error.

    `legendre` is (coefficients, states) in ascending order, and `registers` is (registers, points).
    """

    length: float
    legendre: Floats
    times: Floats
    registers: Floats
    error: float

    def states(self, since: Floats) -> Floats:
        """Return the states, (states, times), at dimensionless times since the step began."""
        place = 2 * since / self.length - 1
        return np.asarray(legendre.legval(place, self.legendre))


def step_through(
    start: Present, h: float, points: Floats, registers: Floats, rates: Floats, rounding: Floats
) -> ImplicitStep:
    """Return the step through states at the points, (points, states), and its error.

    `h` is the length of the step, and `rates` are the derivatives of the states at the points. The error is the
    relative size of the last coefficients, without rounding. The rounding of the time changes every state in proportion
    to its rate, and `rounding` is the rounding of the states themselves.
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
    return ImplicitStep(h, coefficients, start.time + AT * h, registers, float(error))


def step_factor(error: float) -> float:
    """Return the ratio of the next step to this step for which the error equals the tolerance.

    The error is `ImplicitStep.error`.
    """
    return float(SAFETY * (TOLERANCE / max(error, LEAST_SIZE)) ** (1 / POINTS))


def newton_correction(jacobian: Floats, h: float, residual: Floats, size: Floats) -> Floats | None:
    """Return (I - h a x df/dy)^-1 residual in units of `size`, or None if the matrix is singular.

    The Jacobian df_j/dy_i is given as (i, points, j), and `residual` and `size` as (points, states).
    """
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


def falling_zero(function: Callable[[float], float], low: Pair, high: Pair) -> float:
    """Return the time at which a function falls through zero, by false position and every third time bisection.

    Both ends are pairs of a time and a value, positive at the end `low` and at most 0 at the later end `high`.
    """
    begin, at_begin = low
    end, at_end = high
    least = 2 * EPS * abs(end)
    evaluations = 0
    while end - begin > 2 * least:
        bisects = evaluations % 3 == 2
        share = 0.5 if bisects else at_begin / (at_begin - at_end)
        middle = begin + share * (end - begin)
        middle = max(middle, begin + least)  # otherwise only one end would move
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
