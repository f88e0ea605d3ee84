"""Masses that creep to their equilibrium through a viscous layer and never rest.

At rest the net moment N(phi) falls to zero at the equilibrium phi_e. With y = phi_e - phi, the rotation left, and d the
slope of the viscous moment, both over Theta*, what brakes beside viscosity only helps:

    domega*/dt* <= N - d omega*,    dy/dt* = -omega*

Where d^2 > 4 N/y all the way to the equilibrium, the line omega* = y d/2 is never crossed from below: on it domega*/dy
is at least d/2. A mass below the line (beyond its kinks, overdamped) approaches its equilibrium without ever reaching
it: it creeps. One that passes the equilibrium comes to rest behind it in finite time. With K = N/y at the equilibrium
and d^2 = 4 K (1 - e) it passes it by exp(-pi/sqrt(e)) of what was left: where that is rounding, it creeps, too.
"""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from slipcircle.base.checks import EPS
from slipcircle.base.kinds import Floats
from slipcircle.core.problem.problem import Problem
from slipcircle.core.program.program import Samples
from slipcircle.core.walk.compiled import engine

Lanes = NDArray[np.intp]
Integrate = Callable[[Problem, Samples | None], Floats]  # final cells

CRITICAL = 4.0 / (1.0 + (math.pi / math.log(EPS)) ** 2)  # d^2 over K from which on a mass creeps
LEFT = 0.01  # of the run-out, when the mass is said to have arrived
POSITIONS = 64  # over half a turn at which the net moment is looked at, and up to the equilibrium
MARGIN = 1.25  # of the time that is tried first
SAMPLES = (64, 2048)  # at least and at most, between which the time of arrival is narrowed down
SECTIONS = 16  # into which the interval of its root is divided, again and again
COLUMNS = 20_000  # evaluated at once
SLOW = 1e-8  # omega* at which the viscous moment is compared with that at rest
NEXT = 1e-6  # of the rotation left, where the stiffness at the equilibrium is taken; of a time that is to be improved
LONGEST = 2.0**200  # dimensionless time


class Ahead(NamedTuple):
    """The equilibrium that lanes move towards: the rotation left, infinite without one, and rates close to it."""

    left: Floats
    damping: Floats  # d
    stiffness: Floats  # N/y next to it
    greatest: Floats  # N/y from here on, at most


def integrate(problem: Problem, samples: Samples | None, integrate_lanes: Integrate) -> Floats:
    """Final cells of lanes, some of which may creep: these end at an infinite time, at their equilibrium.

    `ix.REST_SINCE` of such a lane is the time by which all but `LEFT` of its run-out is covered.

    Parameters
    ----------
    problem : Problem
    samples : Samples, optional
    integrate_lanes : callable
        Integrates all lanes of a problem to their end.
    """
    which, trial_time = _candidates(problem)
    if not which.size:
        return integrate_lanes(problem, samples)
    creeping = np.zeros(which.size, dtype=bool)
    undecided = ~creeping
    equilibrium = np.zeros(which.size)
    end_time = trial_time
    while undecided.any() and end_time.max() < LONGEST:
        cells = integrate_lanes(_until(problem, which, end_time), None)
        final = cells[:, which]
        moving = final[ix.STATUS] == ix.ENDED
        caught, there = _caught(problem, which, final)
        creeping |= undecided & moving & caught
        equilibrium = np.where(creeping, there, equilibrium)
        undecided &= moving & ~caught
        end_time = np.where(undecided, 2.0 * end_time, end_time)
    lanes, there = which[creeping], equilibrium[creeping]
    cells[ix.REST_SINCE, lanes] = _arrival(problem, lanes, there, end_time[creeping], integrate_lanes)
    if samples is not None:
        last = np.maximum(end_time, _of_lanes(samples.times, which)[-1])
        integrate_lanes(_until(problem, which, last), samples)
    cells[ix.STATUS, which[undecided]] = ix.TOO_LONG
    cells[ix.END_TIME, which] = np.inf
    cells[ix.TIME, lanes] = np.inf
    cells[ix.END_ROTATION, lanes] = there
    short = np.abs(cells[ix.REACH_ROTATION, lanes]) < np.abs(there)
    cells[ix.REACH_ROTATION, lanes[short]] = there[short]
    cells[ix.REACH_TIME, lanes[short]] = np.inf
    cells[ix.END_OMEGA, lanes] = 0.0
    cells[ix.END_RATE, lanes] = 0.0
    return cells


def _until(problem: Problem, which: Lanes, end_time: Floats) -> Problem:
    """The same problem with other ends of some lanes."""
    cells = problem.initial_cells()
    cells[ix.END_TIME, which] = end_time
    return problem._replace(cells=cells)


def _candidates(problem: Problem) -> tuple[Lanes, Floats]:
    """Lanes without an end that are overdamped at the equilibrium ahead, and the time that their approach takes."""
    cells = problem.cells
    (which,) = np.nonzero((cells[ix.END_TIME] == np.inf) & (cells[ix.STATUS] == ix.START))
    begun = cells[:, which].copy()
    pull = begun[problem.program.places["driving_moment"]]
    begun[ix.DIRECTION] = np.where(pull < 0.0, -1.0, 1.0)
    ahead = _ahead(problem, which, begun)
    creeps = ahead.damping**2 > CRITICAL * ahead.stiffness
    chosen = which[creeps]
    damping, stiffness = ahead.damping[creeps], ahead.stiffness[creeps]
    root = np.sqrt(np.maximum(damping**2 - 4.0 * stiffness, 0.0))
    slow_rate = 2.0 * stiffness / (damping + root)
    return chosen, MARGIN * np.log(1.0 / LEFT) / slow_rate


def _caught(problem: Problem, which: Lanes, final: Floats) -> tuple[Any, Floats]:
    """Lanes that have all but arrived and can no longer pass their equilibrium, and where that is."""
    now = final.copy()
    now[ix.DIRECTION] = np.where(final[ix.END_OMEGA] < 0.0, -1.0, 1.0)
    now[ix.ROTATION] = final[ix.END_ROTATION]
    now[ix.SLIP] = final[ix.SLIP] + final[ix.X]
    ahead = _ahead(problem, which, now)
    equilibrium = now[ix.ROTATION] + now[ix.DIRECTION] * ahead.left
    speed = np.abs(final[ix.END_OMEGA])
    left = np.where(ahead.left <= LEFT * np.abs(equilibrium), ahead.left, 0.0)
    below_line = (left > 0.0) & (speed <= 0.5 * ahead.damping * left)
    stays_below = ahead.damping**2 > CRITICAL * ahead.greatest
    return below_line & stays_below, equilibrium


def _ahead(problem: Problem, which: Lanes, now: Floats) -> Ahead:
    """The first equilibrium in the direction of travel of lanes in some states."""
    low, high = np.zeros(which.size), np.full(which.size, np.pi)
    sections = POSITIONS
    stops: NDArray[np.bool_] = np.zeros(which.size, dtype=bool)
    while sections == POSITIONS or np.any(high - low > np.spacing(high)):
        edges = low + np.linspace(0.0, 1.0, sections + 1)[:, None] * (high - low)
        net = _net(problem, which, now, edges)
        falls = (net[:-1] > 0.0) & (net[1:] <= 0.0)
        if sections == POSITIONS:
            stops = np.asarray(falls.any(axis=0))
        place = falls.argmax(axis=0)[None]
        low, high = (np.take_along_axis(edges, place + k, axis=0)[0] for k in (0, 1))
        high = np.where(stops, high, low)
        sections = SECTIONS
    shares = np.append(np.linspace(0.0, 1.0, POSITIONS + 1)[1:], NEXT)
    left = shares[:, None] * low
    with np.errstate(all="ignore"):
        stiffness = _net(problem, which, now, low - left) / left
    damping = -_net(problem, which, now, low[None], SLOW)[0] / SLOW
    left_at_all = np.where(stops, low, np.inf)
    stiffness = np.where(stops, stiffness, np.inf)
    return Ahead(left_at_all, damping, stiffness[-1], np.fmax.reduce(stiffness))


def _net(problem: Problem, which: Lanes, now: Floats, distance: Floats, omega: float = 0.0) -> Floats:
    """The net moment over Theta* on lanes farther on, (distances, lanes), at rest or at a speed."""
    net = np.empty_like(distance)
    together = max(1, COLUMNS // which.size)
    for first in range(0, len(distance), together):
        rows = distance[first : first + together]
        lanes = np.tile(which, len(rows))
        cells = np.tile(now, len(rows))
        cells[ix.ROTATION] += cells[ix.DIRECTION] * rows.ravel()
        cells[ix.SLIP] += rows.ravel()
        cells[ix.OMEGA] = omega
        cells[ix.X] = 0.0
        cells[ix.LIFTED] = 0.0
        problem.extend_rotations(cells[ix.ROTATION], lanes)
        problem.extend_tables(cells)
        tables = [table.lanes(lanes) for table in problem.tables]
        registers = engine().begin_phase(problem.program, tables, cells)
        net[first : first + together] = registers[problem.program.roles["net"]].reshape(rows.shape)
    return net


def _arrival(problem: Problem, lanes: Lanes, equilibrium: Floats, end: Floats, integrate_lanes: Integrate) -> Floats:
    """The time from which lanes are within `LEFT` of their run-out from their equilibrium, before some end."""
    low, high = np.zeros(lanes.size), end
    if not lanes.size:
        return low
    count = np.clip(COLUMNS // max(1, lanes.size), *SAMPLES)
    shares = np.linspace(0.0, 1.0, count + 1)[:, None]
    within = LEFT * np.abs(equilibrium)
    every = np.arange(lanes.size)
    while np.any(high - low > NEXT * high):
        times = low + shares * (high - low)
        all_times = np.zeros((len(shares), problem.cells.shape[1]))
        all_times[:, lanes] = times
        rows = np.zeros((2 + len(problem.program.states), *all_times.shape))
        integrate_lanes(_until(problem, lanes, 2.0 * end), Samples(all_times, rows))
        left = np.abs(rows[0][:, lanes] - equilibrium)
        outside = left > within
        place = len(shares) - outside[::-1].argmax(axis=0)  # behind the last one outside
        low, high = times[place - 1, every], times[place, every]
    speed = np.abs(rows[1][place, lanes])
    return high - (within - left[place, every]) / speed


def _of_lanes(times: Floats, which: Lanes) -> Floats:
    """Columns of lanes of times that may be the same for all."""
    return times[:, which] if times.shape[1] > 1 else np.repeat(times, which.size, axis=1)
