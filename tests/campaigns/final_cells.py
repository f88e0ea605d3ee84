"""Final cells of many lanes, for a change that must not move a bit: ``python -m tests.campaigns.final_cells FILE``.

The first run writes the file; the next ones compare with it, in ulp, each kind of processor and NumPy apart.
"""

import sys
from collections.abc import Iterator
from functools import partial
from importlib import resources
from pathlib import Path
from typing import Any
from unittest.mock import patch

import numpy as np

import slipcircle
from generated import layout as ix
from slipcircle.base.kinds import Floats
from slipcircle.core.integrator import compiled
from slipcircle.core.integrator.lanes import integrate_problem
from slipcircle.core.problem.problem import Problem
from slipcircle.tables import Series
from tests.support.lanes import posed

TURNING: dict[str, Any] = {"rotation": {}, "centripetal": {}}


def problems(share: int) -> Iterator[tuple[str, Problem]]:
    """Ensembles of one arc, each of so many lanes over ``share``, and a lane of every scene that ships."""
    arc = slipcircle.load("vaiont").arc
    rng = np.random.default_rng(39)
    waves = np.convolve(rng.normal(size=1020), np.exp(-np.arange(21) / 5.0), "valid") * 0.08
    record = Series(np.linspace(0.0, 20.0, 1000), waves, held=False)
    for name, lanes in (("constant", 20_000), ("exponential", 20_000), ("record", 2_000), ("up-slope", 20_000)):
        count = lanes // share
        friction: Any = np.tan(np.radians(rng.uniform(4.0, 31.0, count)))
        called, velocity = TURNING, np.zeros(count)
        if name == "exponential":
            friction = {"law": name, "peak": friction, "residual": 0.7 * friction, "length": rng.uniform(1, 99, count)}
        elif name == "record":
            called = TURNING | {"shaking": {"horizontal": record}}
        elif name == "up-slope":
            velocity = -rng.uniform(0.1, 9.0, count)
        yield name, posed(slipcircle.Scene(arc, friction, called, velocity), 1e-9)
    for path in sorted(resources.files("slipcircle").joinpath("scenes").iterdir(), key=str):
        scene = Path(str(path)).stem
        yield scene, posed(slipcircle.load(scene), 1e-9)


def ulps(one: Floats, other: Floats) -> str:
    """Lanes whose cells differ, and by how much at most."""
    same = (one == other) | (np.isnan(one) & np.isnan(other))
    with np.errstate(all="ignore"):
        apart = np.abs(one - other) / np.spacing(np.maximum(np.abs(one), np.abs(other)))
    worst = np.where(same, 0.0, np.where(np.isnan(apart), np.inf, apart))
    rows = {name: float(x) for name, x in zip(ix.CELLS, worst.max(axis=1), strict=True) if x}
    return f"{np.count_nonzero(worst.any(axis=0))} of {one.shape[1]} lanes differ {rows or ''}"


def main(file: str) -> None:
    cells = {}
    binary = compiled.module()
    for level in (*(binary.LEVELS if binary else ()), None):
        for name, problem in problems(1 if level else 20):
            if level:
                with patch.object(compiled, "widest", partial(binary.LEVELS.get, level)):
                    final = integrate_problem(problem)
            else:
                with compiled.numpy_only():
                    final = integrate_problem(problem)
            cells[f"{level or 'NumPy'} {name}"] = final[: ix.OMEGA + 1]
    if not Path(file).exists():
        np.savez_compressed(file, allow_pickle=False, **cells)
        return
    with np.load(file) as before:
        for name, final in cells.items():
            print(f"{name:<28}{ulps(before[name], final)}")


if __name__ == "__main__":
    main(*sys.argv[1:])
