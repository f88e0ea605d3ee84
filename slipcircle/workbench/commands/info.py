"""`slipcircle info`: what is installed, for a report of a problem."""

import argparse
from dataclasses import replace
from functools import partial
from time import process_time
from timeit import repeat
from typing import Any

import numpy as np

from slipcircle.base.text import shown
from slipcircle.core import Scene, numpy_only, solve
from slipcircle.workbench.files.scenefile import load
from slipcircle.workbench.outputs.info import facts
from slipcircle.workbench.outputs.tables import Answer, Part


def options(_: argparse.ArgumentParser) -> None:
    """Declare no options."""


def run(_: argparse.Namespace) -> Answer:
    """Run the command."""
    rows = facts() | {"speed": _speed()}
    return Answer(lambda: rows, [Part([], list(rows.items()))])


def _speed() -> str:
    """What a scene of an ensemble takes, and how many times as long NumPy takes, measured now."""
    scene: Scene[Any] = load("vaiont")
    work = partial(solve, replace(scene, friction=np.linspace(0.1, 0.2, 2_000)))
    timed = partial(repeat, work, process_time, number=1, repeat=3)
    here = min(timed())
    with numpy_only():
        in_numpy = min(timed())
    return f"{shown(here / 2_000 * 1e6, 2)} us a scene of 2,000; NumPy takes {shown(in_numpy / here, 2)} times as long"
