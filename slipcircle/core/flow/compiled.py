"""The compiled walk: a program as integers, and calls that come back often enough for Ctrl-C to be heard."""

import os
import sys
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache, lru_cache
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from generated.series import DIGEST, SCALAR, SERIES
from slipcircle.core.flow import integrate as in_numpy
from slipcircle.core.flow.link import RESULTS
from slipcircle.core.flow.program import Log, Program, Samples
from slipcircle.core.flow.tables import Data

Floats = NDArray[np.float64]

STRIDE = 42  # coefficients from one register to the next: the highest order that the C walk takes, and two
ROUNDS = 50_000  # steps of some lanes between looks at the keyboard: a tenth of a second at most
NOTES = 4096  # events that one call may note
_NOTHING = np.empty(0)


@cache
def module() -> Any:
    """The binary; None where there is none, or where it is not wanted."""
    if os.environ.get("SLIPCIRCLE_COMPILED") == "0":
        return None
    try:
        binary = import_module("generated._flow")
    except ModuleNotFoundError:
        return None
    except ImportError as error:
        fault = f"it cannot be loaded ({error})"
    else:
        if binary.DIGEST == DIGEST:
            return binary
        fault = "it was built from another source"
    warnings.warn(
        f"the compiled walk is refused, NumPy serves: {fault}; run `python -m derive.build` or install again",
        RuntimeWarning,
        stacklevel=2,
    )
    return None


_numpy_only: list[bool] = []  # one entry for each `numpy_only` that is open


@contextmanager
def numpy_only() -> Iterator[bool]:
    """Integrate in NumPy although there is a binary; for comparisons. Says whether there is one."""
    _numpy_only.append(True)
    try:
        yield module() is not None
    finally:
        _numpy_only.pop()


def engine() -> Any:
    """The module whose `integrate`, `begin_phase` and `registers` are the faster ones here."""
    return sys.modules[__name__] if module() and not _numpy_only else in_numpy


@lru_cache(maxsize=256)
def flat(program: Program) -> bytes:
    """A program as the C walk reads it: sizes, roles, operations, states and tables; registers by where they begin."""
    at = [k * STRIDE for k in range(len(program.registers))] + [-1]
    ready = {r: place for place, (op, *names) in enumerate(program.series) for r in names[: RESULTS.get(op, 1)]}

    def coded(op: str, names: Sequence[Any]) -> list[int]:
        if op == "lin":
            d, constant, terms = names
            terms = sorted(terms, key=lambda term: ready.get(term[1], -1))  # a sum waits for its last term only
            return [SERIES[op], at[d], constant, len(terms), *(i for cell, r in terms for i in (cell, at[r]))]
        last = names[-1:] if op in ("pow", "ramp") else ()  # a cell or a table
        return [SERIES[op], *(at[r] for r in names[: len(names) - len(last)]), *last]

    # What no rate needs is computed when the series of the states are complete.
    needed = {rate for _, _, rate in program.states}
    inner, outer = list[list[int]](), list[list[int]]()
    for op, *names in reversed(program.series):
        made = {*names[: RESULTS.get(op, 1)]}
        if needed & made:
            needed |= {r for _, r in names[2]} if op == "lin" else {*names}
            inner.insert(0, coded(op, names))
        else:
            outer.insert(0, coded(op, names))
    series, later = ([i for code in part for i in code] for part in (inner, outer))
    scalar = [i for op, *names in program.scalar for i in (SCALAR[op], *names)]
    # A lane at its start has no use for the cells beyond those given, but for constants.
    sizes = (
        len(program.cells),
        program.given,
        len(program.registers),
        len(program.states),
        len(program.tables),
        len(scalar),
        len(series),
        len(later),
        int(program.autonomous),
    )
    roles = [program.roles.get(name, -1) for name in ix.ROLES]
    roles = [role if name.startswith("cell_") else at[role] for name, role in zip(ix.ROLES, roles, strict=True)]
    states = [(cell, at[r], at[rate]) for cell, r, rate in program.states]
    tables = [(ix.KINDS.index(t.kind), at[t.register], t.cells, t.degree) for t in program.tables]
    parts = (sizes, roles, scalar, series, later, *states, *tables)
    return np.array([i for part in parts for i in part], dtype=np.int32).tobytes()


def integrate(
    program: Program,
    tables: Sequence[Data],
    cells: Floats,
    samples: Samples | None = None,
    log: Log | None = None,
    level: str | None = None,
) -> None:
    """Integrate every lane until it rests, ends or fails, as `integrate.integrate` does; other threads run meanwhile.

    Parameters
    ----------
    program, tables, cells, samples, log
        As there; ``cells`` and the samples' arrays are C-contiguous.
    level : str, optional
        The kind of processor to run for, one of those that the binary names in ``LEVELS``; by default the best.
    """
    binary, count = module(), cells.shape[1]
    if not count:
        return
    number = binary.LEVELS[level] if level else min(binary.LEVELS.values())
    pieces = _pieces(tables, count)
    times, states = (_NOTHING, _NOTHING) if samples is None else (samples.times, samples.states)
    notes = _NOTHING if log is None else np.empty((NOTES, 4))
    code, order, left = flat(program), int(cells[ix.ORDER].max()), 1
    while left:
        left, noted = binary.walk(code, pieces, cells, order, 0, count, ROUNDS, times, states, notes, number)
        if log is not None:
            log += [(int(kind), *at) for kind, *at in notes[:noted].tolist()]


def begin_phase(program: Program, tables: Sequence[Data], cells: Floats) -> Floats:
    """As `slipcircle.core.flow.integrate.begin_phase`: phases that begin where lanes are, and registers there."""
    return registers(program, tables, cells, 1)


def registers(program: Program, tables: Sequence[Data], cells: Floats, begins: int = 0) -> Floats:
    """As `slipcircle.core.flow.integrate.registers`: where lanes are within their phases."""
    binary, count = module(), cells.shape[1]
    found = np.zeros((len(program.registers), count))
    if count:
        binary.walk(
            flat(program),
            _pieces(tables, count),
            cells,
            5,
            0,
            count,
            begins,
            _NOTHING,
            found,
            _NOTHING,
            min(binary.LEVELS.values()),
        )
    return found


def _pieces(tables: Sequence[Data], count: int) -> tuple[Any, ...]:
    """Tables as the C walk takes them."""
    return tuple(
        (
            t.breaks,
            t.coefficients,
            t.jumps,
            t.coefficients.shape[1],
            count if t.coefficients.ndim == 3 else 0,
            t.sine,
            t.open,
        )
        for t in tables
    )
