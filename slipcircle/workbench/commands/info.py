"""`slipcircle info`: versions of the installed packages, for bug reports."""

import argparse
from dataclasses import replace
from functools import partial
from time import process_time
from timeit import repeat
from typing import Any

import numpy as np

from slipcircle.base.text import number_text
from slipcircle.core import Scene, numpy_only, solve
from slipcircle.workbench.files.scenefile import load
from slipcircle.workbench.outputs.info import facts
from slipcircle.workbench.outputs.tables import Answer, ResultTable


def options(_: argparse.ArgumentParser) -> None:
    """Add nothing to the parser; `slipcircle info` does not take options."""


def run(_: argparse.Namespace) -> Answer:
    """Run the command and return its answer."""
    rows = facts() | {"speed": _speed()}
    return Answer(lambda: rows, [ResultTable([], list(rows.items()))])


def _speed() -> str:
    """Return the measured time for each scene of an ensemble, in us, and its ratio to the time with NumPy, as text."""
    scene: Scene[Any] = load("vaiont")
    work = partial(solve, replace(scene, friction=np.linspace(0.1, 0.2, 2_000)))
    timed = partial(repeat, work, process_time, number=1, repeat=3)
    here = min(timed())
    with numpy_only():
        in_numpy = min(timed())
    each, factor = (number_text(x, 2) for x in (here / 2_000 * 1e6, in_numpy / here))
    return f"{each} us a scene of 2,000; NumPy takes {factor} times as long"
