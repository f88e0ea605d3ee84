"""Masses that creep to their equilibrium through a viscous layer and never rest.

At rest the net moment N(phi) falls to zero at the equilibrium phi_e. Let y = phi_e - phi be the remaining rotation and
d the slope of the viscous moment, where N and d are divided by Theta*. Brakes other than viscosity only strengthen
the inequality

    domega*/dt* <= N - d omega*,    dy/dt* = -omega*

If d^2 > 4 N/y up to the equilibrium, the line omega* = y d/2 is never crossed from below, because domega*/dy is at
least d/2 on it. A mass below the line, beyond its kinks, is overdamped. It approaches its equilibrium without ever
reaching it, that is, it creeps. A mass that passes the equilibrium comes to rest behind it in finite time. With
K = N/y at the equilibrium and d^2 = 4 K (1 - e) the overshoot is exp(-pi/sqrt(e)) of the remaining rotation. If this
is less than rounding, the mass counts as creeping, too.
"""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from generated import layout as ix
from slipcircle.base.arrays import EPS, quiet
from slipcircle.base.kinds import ArrayPair, Flags, Floats, Integers
from slipcircle.base.sections import first_section
from slipcircle.core.integrator import compiled
from slipcircle.core.integrator.compiled import OutputSamples
from slipcircle.core.lazy import lazy_import
from slipcircle.core.problem.problem import Problem
from slipcircle.core.scene.laws import depends_on

Integrate = Callable[[Floats, OutputSamples | None], Floats]  # final cells from initial cells

CRITICAL = 4.0 / (1.0 + (math.pi / math.log(EPS)) ** 2)  # d^2 over K above which a mass creeps
LEFT = 0.01  # remaining fraction of the run-out at arrival
POSITIONS = 64  # positions up to the equilibrium at which the net moment is evaluated
# Fractions of half a turn at which it is evaluated: equidistant, and finer for laws with a short slip length.
EVEN = np.linspace(0.0, 1.0, 65)
FINE = np.geomspace(1e-6, 1.0, 193)
AHEAD = np.union1d(EVEN, FINE)
MARGIN = 1.25  # ratio of the first end time to the estimated arrival
SAMPLES = (64, 2048)  # least and greatest number of times per round in the search for the arrival
SECTIONS = np.linspace(0.0, 1.0, 17)  # relative positions at which the interval of the root is divided
COLUMNS = 20_000  # lanes evaluated in one call
SLOW = 1e-8  # omega* at which the slope of the viscous moment is taken
NEXT = 1e-6  # remaining rotation, relative, at which the stiffness is taken; relative tolerance of the arrival
LONGEST = 2.0**200  # dimensionless time
STEPS = 0.145  # number of explicit steps of a creeping mass over d t, as stability bounds their length
COMPILED = ix.MOST_STEPS / ix.STIFF_STEP  # explicit steps that take as long as the implicit solution
IN_NUMPY = 200.0


class Now(NamedTuple):
    """Some lanes of a problem by their indices, with their current cells or the cells of all lanes.

    The cells are variables of the program, one column per lane.
    """

    problem: Problem
    lanes: Integers
    cells: Floats


class Ahead(NamedTuple):
    """Equilibrium ahead of lanes: remaining rotation, infinite without an equilibrium, and coefficients near it."""

    left: Floats
    damping: Floats  # d
    stiffness: Floats  # N/y next to it
    greatest: Floats  # greatest N/y from here on


def may_creep(problem: Problem) -> bool:
    """Return whether a mass may approach its equilibrium for ever.

    It does if it is viscous and its other forces depend on position only.
    """
    return "viscosity" in problem.recipe.effects and not other_than_position(problem)


def other_than_position(problem: Problem) -> str:
    """Return a variable other than position and slip on which the net moment at rest depends, or an empty text."""
    recipe = problem.recipe
    if any(table.kind == "time" and table.name in recipe.moving for table in problem.program.tables):
        return "what changes in time"
    if "thermal_pressurisation" in recipe.effects:
        return "frictional heat"
    others = set(depends_on(recipe.laws)) - {"slip"}
    if others:
        return f"a friction law of {min(others)}"
    return ""


def integrate_creeping(
    problem: Problem, begin: Floats, samples: OutputSamples | None, integrate_lanes: Integrate
) -> Floats:
    """Return final cells of lanes, where creeping lanes end at an infinite time in their equilibrium.

    `ix.REST_SINCE` of a creeping lane is its arrival, when all but `LEFT` of its run-out is covered.

    Parameters
    ----------
    problem : Problem
    begin : ndarray
        Initial cells of the lanes.
    samples : Samples, optional
    integrate_lanes : callable
        Function that integrates all lanes to their end.
    """
    if not may_creep(problem):
        return integrate_lanes(begin, samples)
    which, end_time, damping = _candidates(problem, begin)
    if not which.size:
        return integrate_lanes(begin, samples)
    begin = begin.copy()
    begin[ix.STEPS, which] = _first_steps(STEPS * damping * end_time)
    creeping = np.zeros(which.size, bool)
    undecided = ~creeping
    while undecided.any() and end_time.max() < LONGEST:
        cells = integrate_lanes(_until(begin, which, end_time), None)
        final = cells[:, which]
        moving = final[ix.STATUS] == ix.ENDED
        caught, equilibrium = _caught(problem, which, final)
        creeping = moving & caught
        undecided = moving & ~caught
        end_time = np.where(undecided, 2.0 * end_time, end_time)
    lanes = which[creeping]
    rotation = equilibrium[creeping]
    arrival = _arrival(Now(problem, lanes, begin), rotation, end_time[creeping], integrate_lanes)
    if samples is not None:
        integrate_lanes(_until(begin, which, np.maximum(end_time, samples.times[-1].max())), samples)
    _settle(cells, lanes, rotation, arrival)
    cells[ix.END_TIME, which] = np.inf
    cells[ix.STATUS, which[undecided]] = ix.TOO_LONG
    return cells


def slow_rotation(problem: Problem) -> Floats:
    """Return the rotation at which a mass comes to rest if it moves quasi-statically, NaN without an equilibrium.

    It is the first root of the net moment at rest, and 0 for a mass in equilibrium at the start.
    """
    if other_than_position(problem):
        return np.full(problem.lanes, np.nan)
    lanes = np.arange(problem.lanes)
    cells = problem.cells()
    direction = _direction(cells[problem.program.places["driving_moment"]])
    cells[ix.DIRECTION] = direction
    now = Now(problem, lanes, cells)
    (net,) = _net(now, np.zeros((1, lanes.size)))
    stands = net <= 0.0
    ahead = _ahead(now)
    left = np.where(stands, 0.0, ahead.left)
    rotation = direction * left
    return np.where(np.isinf(left), np.nan, rotation)


def _first_steps(explicit_steps: Floats) -> Floats:
    """Return the initial step count of lanes, the maximum where implicit steps are faster than explicit steps.

    `explicit_steps` is the estimated number of explicit steps of each lane. Implicit steps then begin after the first
    explicit step.
    """
    most = IN_NUMPY
    if compiled.engine() is compiled:
        most = COMPILED
    return np.where(explicit_steps > most, ix.MOST_STEPS, 0.0)


def _settle(cells: Floats, lanes: Integers, rotation: Floats, arrival: Floats) -> None:
    """Set the final cells of creeping lanes to their equilibrium at an infinite time.

    `lanes` are indices, `rotation` is the equilibrium in rad, and `arrival` the dimensionless time of arrival.
    """
    cells[ix.TIME, lanes] = np.inf
    cells[ix.REST_SINCE, lanes] = arrival
    cells[ix.END_ROTATION, lanes] = rotation
    cells[ix.END_OMEGA, lanes] = 0.0
    cells[ix.END_RATE, lanes] = 0.0
    reach = np.abs(cells[ix.REACH_ROTATION, lanes])
    farthest_at_end = reach < np.abs(rotation)
    farther = lanes[farthest_at_end]
    cells[ix.REACH_ROTATION, farther] = rotation[farthest_at_end]
    cells[ix.REACH_TIME, farther] = np.inf


def _until(begin: Floats, which: Integers, end_time: Floats) -> Floats:
    """Return a copy of the cells with other end times, dimensionless, for the lanes with the indices `which`."""
    cells = begin.copy()
    cells[ix.END_TIME, which] = end_time
    return cells


def _candidates(problem: Problem, cells: Floats) -> tuple[Integers, Floats, Floats]:
    """Return the lanes without end time that are overdamped at the equilibrium ahead, their first end time, and d.

    The lanes are indices, and the end times are dimensionless.
    """
    begins = cells[ix.STATUS] == ix.START
    endless = cells[ix.END_TIME] == np.inf
    (which,) = np.nonzero(begins & endless)
    begun = cells[:, which].copy()
    place = problem.program.places["driving_moment"]
    begun[ix.DIRECTION] = _direction(begun[place])
    ahead = _ahead(Now(problem, which, begun))
    creeps = ahead.damping**2 > CRITICAL * ahead.stiffness
    damping = ahead.damping[creeps]
    stiffness = ahead.stiffness[creeps]
    discriminant = damping**2 - 4.0 * stiffness
    root = np.sqrt(np.maximum(discriminant, 0.0))
    return which[creeps], MARGIN * (np.log(1.0 / LEFT) / (2.0 * stiffness / (damping + root))), damping


def _direction(towards: Floats) -> Floats:
    """Return 1 where `towards` is at least 0 and -1 where it is negative."""
    return np.where(towards < 0.0, -1.0, 1.0)


def _caught(problem: Problem, which: Integers, final: Floats) -> tuple[Any, Floats]:
    """Return whether lanes have almost arrived and can no longer pass their equilibrium, and its rotation in rad.

    `final` are the final cells of the lanes with the indices `which`.
    """
    cells = final.copy()
    rotation = final[ix.END_ROTATION]
    omega = final[ix.END_OMEGA]
    direction = _direction(omega)
    cells[ix.DIRECTION] = direction
    cells[ix.ROTATION] = rotation
    cells[ix.SLIP] += final[ix.X]
    ahead = _ahead(Now(problem, which, cells))
    equilibrium = rotation + direction * ahead.left
    arrived = ahead.left <= LEFT * np.abs(equilibrium)
    left = np.where(arrived, ahead.left, 0.0)
    line = 0.5 * ahead.damping * left
    below_line = np.abs(omega) <= line
    stays_below = ahead.damping**2 > CRITICAL * ahead.greatest
    return arrived & below_line & stays_below, equilibrium


def _ahead(now: Now) -> Ahead:
    """Return the first equilibrium in the direction of travel of each lane, as rotation from its present position."""
    count = now.lanes.size
    low = np.zeros(count)
    high = np.full(count, np.pi)

    def stops(distance: Floats) -> Flags:
        return _net(now, distance) <= 0.0

    low, high, falls = first_section(stops, low, high, AHEAD)
    high = np.where(falls, high, low)
    while np.any(high - low > np.spacing(high)):
        low, high, _ = first_section(stops, low, high, SECTIONS)
    shares = np.linspace(0.0, 1.0, POSITIONS + 1)
    shares[0] = NEXT
    left = shares[:, None] * low
    net = _net(now, low - left)
    with quiet():
        stiffness = np.where(falls, net / left, np.inf)
    return Ahead(
        left=np.where(falls, low, np.inf),
        damping=-_net(now, low[None], SLOW)[0] / SLOW,
        stiffness=stiffness[0],
        greatest=np.fmax.reduce(stiffness),
    )


def _net(now: Now, distance: Floats, omega: float = 0.0) -> Floats:
    """Return the net moment over Theta* at distances ahead, (distances, lanes), at rest or at a given speed.

    Distances are rotations in rad in the direction of travel, and the speed omega is dimensionless.
    """
    net = np.empty_like(distance)
    together = max(1, COLUMNS // max(1, now.lanes.size))
    for first in range(0, len(distance), together):
        some = slice(first, first + together)
        net[some] = _net_at_once(now, distance[some], omega)
    return net


def _net_at_once(now: Now, distance: Floats, omega: float) -> Floats:
    """Return `_net` for all distances in one call."""
    problem = now.problem
    repeats = len(distance)
    lanes = np.tile(now.lanes, repeats)
    cells = np.tile(now.cells, repeats)
    farther = distance.ravel()
    cells[ix.ROTATION] += cells[ix.DIRECTION] * farther
    cells[ix.SLIP] += farther
    later = ix.LEAST_SIZE * farther
    cells[ix.TIME] += later  # as the limit friction is that of the start until a time above 0
    cells[ix.OMEGA] = omega
    cells[ix.X] = 0.0
    cells[ix.LIFTED] = 0.0
    problem.reach_farther(cells[ix.ROTATION], lanes)
    if problem.functions:
        lazy_import("functions").extend(problem, cells)
    registers = compiled.engine().begin_phase(problem.program, problem.tables(lanes), cells)
    return np.reshape(registers[problem.program.roles["net"]], distance.shape)


def _arrival(now: Now, equilibrium: Floats, end: Floats, integrate_lanes: Integrate) -> Floats:
    """Return the time from which lanes are within `LEFT` of their run-out from their equilibrium, before `end`.

    Times are dimensionless, and the equilibrium is a rotation in rad for each lane.
    """
    lanes = now.lanes
    low = np.zeros(lanes.size)
    high = end
    if not lanes.size:
        return low
    count = COLUMNS // lanes.size
    count = np.clip(count, *SAMPLES)
    shares = np.linspace(0.0, 1.0, count + 1)
    within = LEFT * np.abs(equilibrium)
    every = np.arange(lanes.size)
    long_enough = now._replace(cells=_until(now.cells, lanes, 2.0 * end))
    while np.any(high - low > NEXT * high):
        width = high - low
        times = low + shares[:, None] * width
        rotation, omega = _read(long_enough, times, integrate_lanes)
        left = np.abs(rotation - equilibrium)
        outside = left > within
        after_last_outside = outside[::-1].argmax(axis=0)
        place = len(shares) - after_last_outside
        low = times[place - 1, every]
        high = times[place, every]
    return high - (within - left[place, every]) / np.abs(omega[place, every])


def _read(now: Now, times: Floats, integrate_lanes: Integrate) -> ArrayPair:
    """Return rotation and omega of lanes at dimensionless times, (times, lanes), which may differ between lanes.

    `integrate_lanes` integrates all lanes of the problem.
    """
    all_times = np.zeros((len(times), now.cells.shape[1]))
    all_times[:, now.lanes] = times
    outputs = 2 + len(now.problem.program.states)
    states = np.zeros((outputs, *all_times.shape))
    integrate_lanes(now.cells, OutputSamples(all_times, states))
    rotation, omega, *_ = states[:, :, now.lanes]
    return rotation, omega
