"""Interface of the compiled integrator: programs encoded as integers, and calls short enough for Ctrl-C."""

import os
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import cache, lru_cache
from importlib import import_module
from typing import Any, NamedTuple

import numpy as np

from generated import _compiled
from generated.program import Program, integers_of
from generated.series import DIGEST
from slipcircle.base.kinds import Floats
from slipcircle.core.scene.piecewise import Data

ROUNDS = 50_000  # steps per call, at most a tenth of a second, so that Ctrl-C is handled
NOTES = 256  # greatest number of events logged per call
Log = list[tuple[int, float, float, float]]  # events: kind, time, rotation, direction
NOTHING = np.empty(0)


class OutputSamples(NamedTuple):
    """States at sample times, (states, times, lanes), filled during the integration."""

    times: Floats  # dimensionless, increasing, (times, lanes)
    states: Floats  # rotation, angular velocity, its rate, slip, then the further states


@cache
def module() -> Any:
    """Return the compiled module, or None if it is absent or disabled."""
    return _compiled.binary("_flow", DIGEST)


@cache
def level() -> str:
    """Return the name of the vector level (width of SIMD instructions) of the compiled integrator; empty for NumPy.

    The level named by the variable SLIPCIRCLE_COMPILED takes precedence if it is available, otherwise the widest is
    used.
    """
    if module() is None:
        return ""
    levels = module().LEVELS
    selected = os.environ.get("SLIPCIRCLE_COMPILED", "")
    return selected if selected in levels else next(iter(levels))


@cache
def widest() -> Any:
    """Return the number by which the compiled module identifies the vector level named by `level`."""
    return module().LEVELS[level()]


_numpy_only: list[bool] = []  # one entry per active `numpy_only`


@contextmanager
def numpy_only() -> Iterator[bool]:
    """Integrate in NumPy even if the compiled module is installed, for comparisons; yield whether it is."""
    _numpy_only.append(True)
    try:
        yield module() is not None
    finally:
        _numpy_only.pop()


def engine() -> Any:
    """Return the faster module for `integrate`, `begin_phase` and `registers` on this machine."""
    name = __name__ if module() and not _numpy_only else "generated.integrator"
    return sys.modules.get(name) or import_module(name)  # the NumPy module is slow to import


@lru_cache(maxsize=256)
def encoded(program: Program) -> bytes:
    """Return a program as 32-bit integers for the C integrator."""
    return np.array(integers_of(program), dtype=np.int32).tobytes()


def integrate(
    program: Program,
    tables: Sequence[Data],
    cells: Floats,
    samples: OutputSamples | None = None,
    log: Log | None = None,
    shared: Floats = NOTHING,
    level: str | None = None,
) -> None:
    """Integrate every lane until it rests, ends or fails, as `generated.integrator.integrate` does, without the GIL.

    Parameters
    ----------
    program, tables, cells, samples, log, shared
        Arguments of `generated.integrator.integrate`. ``cells`` and the arrays of samples must be C-contiguous.
    level : str, optional
        Vector level, one of the ``LEVELS`` of the binary, by default the widest.
    """
    binary = module()
    count = cells.shape[1]
    if not count:
        return
    number = binary.LEVELS[level] if level else widest()
    pieces = _pieces(tables, count)
    times, states = (NOTHING, NOTHING) if samples is None else (samples.times, samples.states)
    notes = NOTHING if log is None else np.empty((NOTES, 4))
    code = encoded(program)
    left = 1
    while left:
        left, noted = binary.integrate(code, pieces, cells, 0, count, ROUNDS, times, states, notes, number, shared)
        if log is not None:
            log += [(int(kind), *at) for kind, *at in notes[:noted].tolist()]


def integrate_runs(program: Program, tables: Sequence[Data], start: Mapping[str, float], moves: Floats) -> Any:
    """Integrate runs of one motion, as `generated.integrator.integrate_runs` does."""
    pieces = _pieces(tables, moves.shape[-1]) if tables else ()
    return module().integrate_runs(encoded(program), pieces, start, program.places, moves, ROUNDS, widest())


def spreads(cells: Floats) -> Any:
    """Return relative differences of runs, as `generated.integrator.spreads` does."""
    return module().spreads(np.ascontiguousarray(cells), cells.shape[1])


def begin_phase(program: Program, tables: Sequence[Data], cells: Floats) -> Floats:
    """Begin phases in the states of lanes and return their registers, (registers, lanes).

    A phase is a motion between two standstills. ``cells`` (cells, lanes) are changed in place, as by
    `generated.integrator.begin_phase`.
    """
    return registers(program, tables, cells, 1)


def registers(program: Program, tables: Sequence[Data], cells: Floats, begins: int = 0) -> Floats:
    """Return the values of registers of lanes within their phases, (registers, lanes).

    ``tables`` are the functions of the program, ``cells`` are (cells, lanes), and ``begins`` is 1 to begin a phase
    first and otherwise 0. See `generated.integrator.registers`.
    """
    binary = module()
    count = cells.shape[1]
    values = np.zeros((len(program.registers), count))
    if count:
        code = encoded(program)
        pieces = _pieces(tables, count)
        binary.integrate(code, pieces, cells, 0, count, begins, NOTHING, values, NOTHING, widest(), NOTHING)
    return values


def _pieces(tables: Sequence[Data], count: int) -> tuple[Any, ...]:
    """Return tables as tuples for the C integrator. ``count`` is the number of lanes."""
    rows = []
    for t in tables:
        across = count if t.coefficients.ndim == 3 else 0
        rows.append((t.breaks, t.coefficients, t.jumps, t.coefficients.shape[1], across, t.sine, t.open))
    return tuple(rows)
