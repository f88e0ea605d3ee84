"""The compiled walk: a program as integers, and calls that come back often enough for Ctrl-C to be heard."""

import os
import warnings
from collections.abc import Sequence
from functools import cache, lru_cache
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated.series import SCALAR, SERIES
from slipcircle.flow import walk
from slipcircle.flow.program import Program
from slipcircle.flow.tables import Data

Floats = NDArray[np.float64]

# What the C walk knows by number, beside the operations: kinds of tables, and roles.
KINDS = ("slip", "speed", "time")
ROLES = ("x", "omega", "net", "normal", "upright", "cell_drive", "cell_drive_scale", "cell_normal0", "cell_f0",
         "cell_p0", "cell_ps0", "cell_driving", "cell_resisting", "cell_mu")  # fmt: skip
ROUNDS = 50_000  # steps of some lanes between looks at the keyboard: a tenth of a second at most
NOTES = 4096  # events that one call may note
_NOTHING = np.empty(0)


@cache
def module() -> Any:
    """The binary; None where there is none, or where it is not wanted."""
    if os.environ.get("SLIPCIRCLE_COMPILED") == "0":
        return None
    try:
        return import_module("generated._flow")
    except ModuleNotFoundError:
        return None
    except ImportError as error:
        warnings.warn(f"the compiled walk cannot be loaded ({error}), NumPy serves", RuntimeWarning, stacklevel=2)
        return None


@lru_cache(maxsize=256)
def flat(program: Program) -> bytes:
    """A program as the C walk reads it: sizes, roles, operations, states and tables."""
    series: list[int] = []
    for op, *names in program.series:
        if op == "lin":
            d, constant, terms = names
            names = [d, constant, len(terms), *(i for term in terms for i in term)]
        series += [SERIES[op], *names]
    scalar = [i for op, *names in program.scalar for i in (SCALAR[op], *names)]
    # A lane at its start has no use for the cells from the first that the prologue makes on, but for constants.
    made = min(d for _, d, *_ in program.scalar)
    sizes = (len(program.cells), made, len(program.registers), len(program.states), len(program.tables), len(scalar),
             len(series))  # fmt: skip
    roles = [program.roles.get(name, -1) for name in ROLES]
    tables = [(KINDS.index(t.kind), t.register, t.cells, t.degree) for t in program.tables]
    parts = (sizes, roles, scalar, series, *program.states, *tables)
    return np.array([i for part in parts for i in part], dtype=np.int32).tobytes()


def run(program: Program, tables: Sequence[Data], cells: Floats, samples: walk.Samples | None = None,
        log: walk.Log | None = None, level: str | None = None) -> None:  # fmt: skip
    """Walk every lane until it rests, ends or fails, as `slipcircle.flow.walk.walk` does; other threads run meanwhile.

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
    pieces = tuple(
        (t.breaks, t.coefficients, t.jumps, t.coefficients.shape[1], count if t.coefficients.ndim == 3 else 0, t.sine,
         t.open)
        for t in tables
    )  # fmt: skip
    times, states = (_NOTHING, _NOTHING) if samples is None else (samples.times, samples.states)
    notes = _NOTHING if log is None else np.empty((NOTES, 4))
    code, order, left = flat(program), int(cells[walk.ORDER].max()), 1
    while left:
        left, noted = binary.walk(code, pieces, cells, order, 0, count, ROUNDS, times, states, notes, number)
        if log is not None:
            log += [(int(kind), *at) for kind, *at in notes[:noted].tolist()]
