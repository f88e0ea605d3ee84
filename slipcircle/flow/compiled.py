"""The compiled walk: a program as integers, cached, and calls that come back often enough for Ctrl-C to be heard."""

import os
from collections.abc import Sequence
from functools import cache, lru_cache
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.flow import walk
from slipcircle.flow.program import Program
from slipcircle.flow.tables import Data

Floats = NDArray[np.float64]

# The C walk's numbers for operations, kinds of tables and roles (`generated/_flow.c`).
NUMBERS = ("set", "add", "sub", "mul", "div", "neg", "sin", "cos", "tan", "exp", "expm1", "log", "log1p", "sqrt", "pow",
           "abs", "min", "max", "less", "select")  # fmt: skip
SERIES = ("lin", "mul", "sqr", "tim", "turn", "exp", "rec", "log", "pow")
KINDS = ("slip", "speed", "time")
ROLES = ("x", "omega", "net", "normal", "upright", "cell_drive", "cell_drive_scale", "cell_normal0", "cell_f0",
         "cell_p0", "cell_ps0")  # fmt: skip
ROUNDS = 100_000  # steps of eight lanes between looks at the keyboard: about a tenth of a second


@cache
def module() -> Any:
    """The binary; None where there is none, or it is not wanted."""
    if os.environ.get("SLIPCIRCLE_COMPILED") == "0":
        return None
    try:
        return import_module("generated._flow")
    except ImportError:
        return None


@lru_cache(maxsize=256)
def flat(program: Program) -> bytes:
    """A program as the C walk reads it."""
    numbers = [[NUMBERS.index(op), d, *a, *[0] * (3 - len(a))] for op, d, *a in program.scalar]
    series: list[int] = []
    for op, *names in program.series:
        if op == "lin":
            d, constant, terms = names
            series += [SERIES.index(op), d, constant, len(terms), *(i for term in terms for i in term)]
        elif op != "ramp":  # its coefficients come with the table
            series += [SERIES.index(op), *names]
    tables = [(KINDS.index(t.kind), t.register, t.cells, t.degree) for t in program.tables]
    made = sorted({d for _, d, *_ in numbers}) or [len(program.cells)] * 2
    sizes = (
        len(program.cells),
        made[0],
        made[-1] + 1,
        len(program.registers),
        len(program.states),
        len(tables),
        len(numbers),
        len(series),
    )
    roles = [program.roles.get(name, -1) for name in ROLES]
    parts = [sizes, roles, *numbers, series, *program.states, *tables]
    return np.array([i for part in parts for i in part], dtype=np.int32).tobytes()


def run(program: Program, tables: Sequence[Data], cells: Floats, samples: walk.Samples | None = None,
        level: str | None = None) -> None:  # fmt: skip
    """Walk every lane until it rests, ends or fails, like `slipcircle.flow.walk.walk`.

    ``cells`` are C-contiguous float64, changed in place. Other threads run meanwhile. ``level`` is the kind of
    processor to run for, by default the best that this one is.
    """
    binary, count = module(), cells.shape[1]
    given = tuple(
        (t.breaks, np.ascontiguousarray(t.coefficients), t.jumps, t.coefficients.shape[1],
         count if t.coefficients.ndim == 3 else 0, t.sine, t.open)
        for t in tables
    )  # fmt: skip
    times, states = (_NONE, _NONE) if samples is None else (np.ascontiguousarray(samples.times), samples.states)
    code, order = flat(program), int(cells[walk.ORDER].max()) if count else 5
    number = binary.LEVELS[level] if level else min(binary.LEVELS.values())
    while binary.walk(code, given, cells, order, 0, count, ROUNDS, times, states, number):
        pass


_NONE = np.empty(0)
