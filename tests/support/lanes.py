"""Lanes and the integrators behind `solve`, in C and in NumPy: where the tests meet what is private to the core."""

from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from typing import Any
from unittest.mock import patch

import pytest

from generated import integrator as in_numpy
from generated import layout as ix
from generated.program import Program, Recipe
from slipcircle import Motion, Scene, plan
from slipcircle.base.kinds import Floats
from slipcircle.core.integrator import compiled
from slipcircle.core.integrator.compiled import OutputSamples
from slipcircle.core.problem.plan import build_program
from slipcircle.core.problem.problem import Problem, problem_of
from slipcircle.layers.layered import RotationTables

__all__ = ["Problem", "Program", "Recipe", "RotationTables", "OutputSamples", "build_program", "compiled"]

BINARY: Any = compiled.module()  # None where there is none
BACKENDS = ("C", "NumPy") if BINARY else ("NumPy",)
needs_binary = pytest.mark.skipif(BINARY is None, reason="no compiled integrator here")
COUNTED = (ix.STATUS, ix.STEPS, ix.PHASES, ix.TURNS, ix.DIRECTION, ix.LAST_WAY, ix.LIFTED, ix.PASSED)
RESULTS = slice(0, ix.OMEGA + 1)  # cells that say how a lane ended


@contextmanager
def backend(name: str) -> Iterator[None]:
    """Solve with one of `BACKENDS`."""
    with compiled.numpy_only() if name == "NumPy" else nullcontext():
        yield


def posed(scene: Scene, accuracy: float | None = None) -> Problem:
    """Return the problem of a scene."""
    return problem_of(plan(scene, accuracy))


def integrate(problem: Problem, which: Any = slice(None), name: str = BACKENDS[0], **options: Any) -> Floats:
    """How some of the lanes end: `RESULTS` of their cells."""
    cells = problem.cells(which)
    module = in_numpy if name == "NumPy" else compiled
    module.integrate(problem.program, problem.tables(which), cells, **options)
    return cells[RESULTS]


def work(motion: Motion) -> tuple[int, int]:
    """Return the steps of a single scene in C, called for one at a time, and the operations on series in them."""
    problem = motion.problem
    one_step = patch.object(compiled, "ROUNDS", 1)
    counting = patch.object(BINARY, "integrate", wraps=BINARY.integrate)
    with one_step, counting as calls:
        integrate(problem)
    steps = calls.call_count
    return steps, steps * len(problem.program.series)
