"""How a scene will be solved. A plan depends on which effects and which law a scene has, never on their values."""

from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np

from generated.effects import COMBINATIONS, EFFECTS
from slipcircle.checks import EPS, mistakes, raise_all
from slipcircle.friction import friction, law_depends, law_name
from slipcircle.scene import ACCURACY, Scene

if TYPE_CHECKING:
    from slipcircle.ladder import Rung

DEFAULT_ACCURACY = 1e-9
CLOSED_IN_TIME = "closed form in time"
CLOSED_IN_PHASE_PLANE = "closed form in the phase plane, time by quadrature"
ENERGY_EQUATION = "quadrature of the linear energy equation"
LINEAR_SYSTEM = "linear system of energy and pore pressure in the phase plane by collocation, time by quadrature"
INTEGRATION = "integration in time by SciPy (DOP853, LSODA where stiff), events located"
STEPPING = "exact steps along the record"
# Evaluations of the specialised functions that a solution typically takes.
EVALUATIONS = {
    CLOSED_IN_TIME: 3,
    CLOSED_IN_PHASE_PLANE: 150,
    ENERGY_EQUATION: 850,
    LINEAR_SYSTEM: 2500,
    INTEGRATION: 3000,
    STEPPING: 1000,
}


@dataclass(frozen=True)
class Plan:
    """The way to a scene's motion.

    Attributes
    ----------
    scene : Scene
    effects, left_out : tuple of str
        Effects used, and known effects that the scene does not call for.
    law : str
        The friction law.
    method, why : str
        What is done, in words, and what asks for it; "" where nothing depends on time or speed but by its square.
    functions : tuple of str
        The specialised functions, in `generated.balance` and `generated.motion`.
    operations : str
        What one evaluation of the specialised functions takes.
    cost : int
        Floating-point operations that a solution typically takes.
    accuracy : float
        Relative error that was asked for.
    """

    scene: Scene
    effects: tuple[str, ...]
    left_out: tuple[str, ...]
    law: str
    method: str
    why: str
    functions: tuple[str, ...]
    operations: str
    cost: int
    accuracy: float

    @property
    def tolerance(self) -> float:
        """Relative tolerance of the steps of an integration that meets the accuracy."""
        return max(self.accuracy * 1e-3, 3e-14)

    @property
    def error_estimate(self) -> float:
        """Relative error to expect before solving: rounding, times how close the friction is to its limit; steps."""
        from slipcircle.balance import bind

        balance = bind(self.scene)
        at = balance.position(0.0, -1 if balance.fall < 0.0 else 1)
        limit, mu = balance.get("limit_friction", **at), float(friction(self.scene.friction).coefficient(0.0))
        moving = float(np.asarray(self.scene.initial_velocity)) != 0.0
        rounding = 32 * EPS * (1.0 if moving or limit == mu else 1.0 + (abs(limit) + mu) / abs(limit - mu))
        return max(rounding, 100 * self.tolerance) if self.method == INTEGRATION else rounding

    def ladder(self) -> "list[Rung]":
        """The scene solved with its effects added one by one: see `slipcircle.ladder.ladder`."""
        from slipcircle.ladder import ladder

        return ladder(self.scene)


def plan(scene: Scene, accuracy: float | None = None) -> Plan:
    """Choose the cheapest method that is exact for the scene's combination of effects.

    Parameters
    ----------
    scene : Scene
    accuracy : float, optional
        Relative error asked for; by default the scene's own, or 1e-9.

    Returns
    -------
    Plan

    Raises
    ------
    ValueError
        If the accuracy is not between 0 and 1.
    """
    wanted = accuracy if accuracy is not None else scene.accuracy if scene.accuracy is not None else DEFAULT_ACCURACY
    if accuracy is not None and not (isinstance(accuracy, float) and 0.0 < accuracy < 1.0):
        raise_all("plan", mistakes({"accuracy": accuracy}, {"accuracy": ACCURACY}))
    called = scene.called
    series = tuple(e for e, given in called.items() if any(map(callable, given.values())))
    choice = _choice(tuple(called), law_name(scene.friction), law_depends(scene.friction), series)
    return Plan(scene, **choice, accuracy=wanted)


@cache
def _choice(called: tuple[str, ...], law: str, by: tuple[str, ...], series: tuple[str, ...]) -> dict[str, Any]:
    """What a plan is made of but for the scene's values, so that it is chosen once."""
    effects = tuple(e for e in EFFECTS if e in called)
    chosen = COMBINATIONS[effects]
    turns, braked = any(EFFECTS[e].turns for e in effects), "brake" in chosen.functions
    reasons = [f"{e} depends on the speed" for e in effects if "speed" in EFFECTS[e].depends_on]
    reasons += [f"{e} depends on time" for e in effects if e in series]
    reasons += [f"friction depends on {'the speed' if x == 'speed' else x}" for x in by if x != "slip"]
    heats = "pressurisation" in chosen.functions
    if law == "constant" and not turns and not heats and reasons == ["shaking depends on time"]:
        method = STEPPING
    elif reasons:
        method = INTEGRATION
    elif heats:
        method = LINEAR_SYSTEM
    elif law == "constant":
        method = CLOSED_IN_PHASE_PLANE if turns else CLOSED_IN_TIME
    else:
        elementary = turns and law == "exponential" and not braked
        method = CLOSED_IN_PHASE_PLANE if elementary else ENERGY_EQUATION
    used = dict(chosen.functions)
    if method != CLOSED_IN_PHASE_PLANE:
        used = {what: name for what, name in used.items() if not what.startswith("energy")}
    elif law == "constant":
        used.pop("energy_softening", None)
    else:
        used.pop("energy", None)
    names = [f"balance.{n}" for n in dict.fromkeys(used.values())]
    if method == CLOSED_IN_TIME:
        names.append(f"balance.frozen{'_braked' if braked else ''}_state")
    left_out = tuple(e for e in EFFECTS if e not in effects)
    return {
        "effects": effects,
        "left_out": left_out,
        "law": law,
        "method": method,
        "why": "; ".join(reasons),
        "functions": tuple(names),
        "operations": chosen.operations,
        "cost": chosen.count * EVALUATIONS[method],
    }
