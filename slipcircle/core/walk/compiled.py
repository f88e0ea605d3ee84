"""The compiled integrator: a program as integers, and calls short enough for Ctrl-C to interrupt."""

import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache, lru_cache
from importlib import import_module
from typing import Any, NamedTuple

import numpy as np

from generated import _compiled
from generated import layout as ix
from generated.flow import RESULTS
from generated.layout import STRIDE
from generated.program import Program
from generated.series import DIGEST, SCALAR, SERIES
from slipcircle.base.kinds import Floats
from slipcircle.core.scene.piecewise import Data

ROUNDS = 50_000  # steps of some lanes between looks at the keyboard: a tenth of a second at most
NOTES = 256  # events that one call may note
Log = list[tuple[int, float, float, float]]  # events: kind, time, rotation, direction
_NOTHING = np.empty(0)


class Samples(NamedTuple):
    """States at sample times, filled during the integration: (states, times, lanes)."""

    times: Floats  # dimensionless, increasing, (times, lanes)
    states: Floats  # rotation, angular velocity, its rate, slip, then the further states


@cache
def module() -> Any:
    """The compiled module; None if there is none, or if it is disabled."""
    return _compiled.binary("_flow", DIGEST)


@cache
def level() -> str:
    """The kind of processor whose integrator runs: the widest here, or the one asked for; empty where NumPy's does."""
    if module() is None:
        return ""
    levels = module().LEVELS
    asked = os.environ.get("SLIPCIRCLE_COMPILED", "")
    return asked if asked in levels else next(iter(levels))


@cache
def widest() -> Any:
    """Its number."""
    return module().LEVELS[level()]


_numpy_only: list[bool] = []  # one entry for each `numpy_only` that is open


@contextmanager
def numpy_only() -> Iterator[bool]:
    """Integrate in NumPy although the compiled module is installed, for comparisons; yields whether it is."""
    _numpy_only.append(True)
    try:
        yield module() is not None
    finally:
        _numpy_only.pop()


def engine() -> Any:
    """The faster module for `integrate`, `begin_phase` and `registers` on this machine."""
    name = __name__ if module() and not _numpy_only else "generated.walk"
    return sys.modules.get(name) or import_module(name)  # NumPy's takes long to load


@lru_cache(maxsize=256)
def encoded(program: Program) -> bytes:
    """A program as the C integrator reads it, 32-bit integers."""
    return np.array(program_integers(program), dtype=np.int32).tobytes()


def program_integers(program: Program) -> list[int]:
    """Sizes, roles, operations, states and tables of a program."""
    rates, others = program.split
    series = _encoded_series(program, rates)
    later = _encoded_series(program, others)
    scalar = list[int]()
    for kind, *names in program.scalar:
        scalar += [SCALAR[kind], *names]
    sizes = [
        len(program.cells),
        program.given,  # at the start a lane needs no cells beyond its inputs, except constants
        len(program.registers),
        len(program.states),
        len(program.tables),
        len(scalar),
        len(series),
        len(later),
        int(program.autonomous),
    ]
    roles = []
    for name in ix.ROLES:
        place = program.roles.get(name, -1)
        roles.append(place if name.startswith("cell_") else _begin(place))
    integers = [*sizes, *roles, *scalar, *series, *later]
    for cell, register, rate in program.states:
        integers += [cell, _begin(register), _begin(rate)]
    for table in program.tables:
        integers += [ix.KINDS.index(table.kind), _begin(table.register), table.cells, table.degree]
    return integers


def _begin(register: int) -> int:
    """Where the coefficients of a register begin; -1 for none."""
    return -1 if register < 0 else register * STRIDE


def _results(kind: str, names: Sequence[Any]) -> Sequence[int]:
    return names[: RESULTS.get(kind, 1)]


def _encoded_series(program: Program, chosen: Sequence[int]) -> list[int]:
    """Operations on series, in the order of the program."""
    code = list[int]()
    for k in chosen:
        kind, *names = program.series[k]
        code.append(SERIES[kind])
        if kind == "lin":
            result, constant, terms = names
            code += [_begin(result), constant, len(terms)]
            for cell, register in terms:
                code += [cell, _begin(register)]
        elif kind in ("pow", "ramp"):  # the last one is a cell or a table
            code += [*map(_begin, names[:-1]), names[-1]]
        else:
            code += map(_begin, names)
    return code


def integrate(
    program: Program,
    tables: Sequence[Data],
    cells: Floats,
    samples: Samples | None = None,
    log: Log | None = None,
    level: str | None = None,
) -> None:
    """Integrate every lane until it rests, ends or fails, as `generated.walk.integrate` does; threads run meanwhile.

    Parameters
    ----------
    program, tables, cells, samples, log
        As there; ``cells`` and the samples' arrays are C-contiguous.
    level : str, optional
        The kind of processor to run for, one of those that the binary names in ``LEVELS``; by default the best.
    """
    binary = module()
    count = cells.shape[1]
    if not count:
        return
    number = binary.LEVELS[level] if level else widest()
    pieces = _pieces(tables, count)
    times, states = (_NOTHING, _NOTHING) if samples is None else (samples.times, samples.states)
    notes = _NOTHING if log is None else np.empty((NOTES, 4))
    code = encoded(program)
    left = 1
    while left:
        left, noted = binary.integrate(code, pieces, cells, 0, count, ROUNDS, times, states, notes, number)
        if log is not None:
            log += [(int(kind), *at) for kind, *at in notes[:noted].tolist()]


def begin_phase(program: Program, tables: Sequence[Data], cells: Floats) -> Floats:
    """As `generated.walk.begin_phase`: phases that begin where lanes are, and registers there."""
    return registers(program, tables, cells, 1)


def registers(program: Program, tables: Sequence[Data], cells: Floats, begins: int = 0) -> Floats:
    """As `generated.walk.registers`: where lanes are within their phases."""
    binary = module()
    count = cells.shape[1]
    values = np.zeros((len(program.registers), count))
    if count:
        code = encoded(program)
        pieces = _pieces(tables, count)
        binary.integrate(code, pieces, cells, 0, count, begins, _NOTHING, values, _NOTHING, widest())
    return values


def _pieces(tables: Sequence[Data], count: int) -> tuple[Any, ...]:
    """Tables as the C integrator takes them."""
    rows = []
    for t in tables:
        across = count if t.coefficients.ndim == 3 else 0
        rows.append((t.breaks, t.coefficients, t.jumps, t.coefficients.shape[1], across, t.sine, t.open))
    return tuple(rows)
