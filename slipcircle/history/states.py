"""States of lanes during the motion, and the start of phases in these states."""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from generated import layout as ix
from slipcircle.base.kinds import ArrayPair, Floats
from slipcircle.core.integrator.compiled import OutputSamples, engine
from slipcircle.core.integrator.lanes import BLOCK, integrate_problem
from slipcircle.core.lazy import lazy_import
from slipcircle.core.problem.problem import Problem


class States(NamedTuple):
    """Dimensionless states of lanes: time, rotation, omega, slip, further states, and the index of the lane.

    The arrays have one element per state. `further` are arrays of the slip and of further states, or None to retain the
    initial ones.
    """

    time: Any
    rotation: Any
    omega: Any
    further: Any
    lane: Any

    def parts(self) -> Iterator["States"]:
        """Yield the states in blocks of at most `BLOCK` states."""
        for first in range(0, max(self.lane.size, 1), BLOCK):
            which = slice(first, first + BLOCK)
            further = None if self.further is None else [values[which] for values in self.further]
            yield States(self.time[which], self.rotation[which], self.omega[which], further, self.lane[which])


def begin(problem: Problem, states: States, side: Any) -> ArrayPair:
    """Return cells and registers of phases that begin in the given states with the given direction of travel.

    `side` is 1 down-slope or -1 up-slope, for all states or each. Both results have one column per state.
    """
    cells = problem.cells(states.lane)
    cells[ix.TIME] = states.time
    cells[ix.ROTATION] = states.rotation
    cells[ix.OMEGA] = abs(states.omega)
    cells[ix.DIRECTION] = side
    cells[ix.LIFTED] = 0.0
    if states.further is not None:
        slip, *others = states.further
        cells[ix.SLIP] = slip
        problem.reach_farther(states.rotation, states.lane)
        if problem.functions:
            lazy_import("functions").extend(problem, cells)
        for (cell, _, _), value in zip(problem.program.states[2:], others, strict=True):
            cells[cell] = value
    registers = engine().begin_phase(problem.program, problem.tables(states.lane), cells)
    return cells, registers


def read(problem: Problem, times: Floats) -> Floats:
    """Return rotation, omega, its rate, slip and further states at increasing dimensionless times.

    The times are (times, lanes), and the result is (rows, times, lanes).
    """
    rows = np.full((2 + len(problem.program.states), *times.shape), np.nan)
    integrate_problem(problem, samples=OutputSamples(np.ascontiguousarray(times), rows))
    return rows
