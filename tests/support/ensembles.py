"""Scenes that differ by lane, alone and as one scene of arrays."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from slipcircle import Arc, Scene, solve
from tests.support import golden

LAWS = ("constant", "exponential", "linear", "hyperbolic", "strengthening", "tabulated", "rate", "product")
EFFECTS = ("frozen", "centripetal", "rotation", "turning", "ratio", "pressure", "cohesion", "drag", "viscosity",
           "pulse", "heat")  # fmt: skip
LANES = 8
TABLE = {"tabulated", "product"}


def lanes(law: str, effects: str) -> list[golden.Data]:
    """A scene and others like it: larger, thinner, weaker, pushed both ways, mirrored, cut short, standing."""
    rng = np.random.default_rng([20261121, LAWS.index(law), EFFECTS.index(effects)])
    found = []
    for k in range(LANES):
        share = rng.uniform(0.8, 1.02) if k != 5 else 2.5
        friction, called = golden.LAWS[law], golden.EFFECTS[effects]
        if isinstance(friction, float):
            friction *= share
        elif law not in TABLE:
            friction = friction | {"peak": friction["peak"] * share, "residual": friction["residual"] * share}
        for effect in called:
            for name, value in called[effect].items():
                if isinstance(value, float) and effect != "shaking":
                    called = called | {effect: called[effect] | {name: value * rng.uniform(0.7, 1.2)}}
        second = math.radians(rng.uniform(284.0, 291.0))
        turning = "rotation" in called
        given = golden.scene(friction, called, (0.0, 2.0, -2.5, 0.0, -1.0, 0.0, 6.0, 0.0)[k],
                             20.0 if turning else rng.uniform(2.0, 5.0), radius=rng.uniform(40.0, 90.0),
                             theta_2=second)  # fmt: skip
        if k == 3:
            given["end_time"] = 0.8
        if k in (6, 7) and "shaking" not in called:
            given = golden.mirrored(given)
        found.append(given)
    return found


def stacked(values: Sequence[Any]) -> Any:
    """What differs from lane to lane as an array."""
    first = values[0]
    if isinstance(first, dict):
        return {k: stacked([v[k] for v in values]) for k in first}
    return first if all(v == first for v in values) else np.array(values)


def together(rows: Sequence[golden.Data]) -> Any:
    """The ensemble of these scenes, solved."""
    given = stacked(rows)
    return solve(Scene(Arc(**given["arc"]), given["friction"], given["effects"], given["initial_velocity"],
                       given["end_time"]))  # fmt: skip
