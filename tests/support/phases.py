"""Random ensembles of turning arcs, and the same lanes integrated in time."""

from dataclasses import replace
from typing import Any

import numpy as np

from slipcircle import Arc, Scene
from tests.support import lanes

TURNING: dict[str, Any] = {"rotation": {}, "centripetal": {}}
COUNT = 40
_RNG = np.random.default_rng(64)
EFFECTS: dict[str, dict[str, Any]] = {
    "plain": {},
    "drag": {"drag": {"xi": 300.0}},
    "water": {"pore_pressure": {"ratio": _RNG.uniform(0.0, 0.6, COUNT)}},
    "lift": {"pore_pressure": {"pressure": _RNG.uniform(0.0, 3e6, COUNT)}},
    "cohesion": {"cohesion": {"cohesion": _RNG.uniform(0.0, 4e5, COUNT)}},
}


def in_time(problem: lanes.Problem) -> lanes.Problem:
    """Return the same lanes without closed form and series in the rotation, so that they are integrated in time."""
    roles = {role: place for role, place in problem.program.roles.items() if "cell_net_" not in role}
    return replace(problem, program=replace(problem.program, roles=roles, by_rotation=0))


def random_scene(effects: dict[str, Any], end: float | None, softens: str = "") -> Scene[Any]:
    """Return random arcs and frictions as an ensemble, of which a third are pushed, in both directions."""
    rng = np.random.default_rng(64)  # the same in every order of tests
    middle, half = 1.5 * np.pi + rng.uniform(-1.2, 1.2, COUNT), rng.uniform(0.05, 1.5, COUNT)
    arc: Any = Arc(rng.uniform(100.0, 2000.0, COUNT), middle - half, middle + half, 20e3)
    pushed = np.where(rng.random(COUNT) < 0.3, rng.normal(size=COUNT) * 5.0, 0.0)
    friction: Any = rng.uniform(0.0, 0.6, COUNT)
    if softens:
        residual, length = friction * rng.uniform(0.0, 1.1, COUNT), 10.0 ** rng.uniform(-1.0, 3.0, COUNT)
        friction = {"law": softens, "peak": friction, "residual": residual, "length": length}
    return Scene(arc, friction, TURNING | effects, pushed, end)
