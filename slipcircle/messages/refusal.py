"""Errors of single scenes without a result."""

import math
from typing import Any

from generated.layout import MOST_TURNS, TIME
from slipcircle.base.arrays import float_or_array
from slipcircle.base.inputerror import InputError
from slipcircle.core import Status
from slipcircle.core.scene.effects import rotates

STRONGEST = 1e7  # greatest q = 2 (lambda A mu + d)/Theta* that the solver follows

_REMEDIES = {"friction": "less friction", "drag": "a greater xi", "viscosity": "a lower viscosity"}


def refusal(motion: Any) -> InputError:
    """Return the error that explains why a single scene has no result and how to change the scene."""
    scene = motion.plan.scene
    speed = float_or_array(scene.initial_velocity)
    status = motion.status
    turns = rotates(motion.plan.recipe.effects)
    stands = "shaking" in motion.plan.effects and not motion.factor_of_safety < 1.0  # but for what shakes it
    overflows = status == Status.FAILED and not stands and scene.end_time is None and speed * speed < math.inf
    velocity, end_time = (f"{{{n}}} = {getattr(scene, n)!r}" for n in ("initial_velocity", "end_time"))
    stopped_at = motion._final[TIME] * scene.arc.time_scale
    few_turnings = status == Status.ENDLESS and motion.turnings < 20
    if status == Status.UPRIGHT:
        why = (
            f"{velocity}, friction: the chord is vertical after {stopped_at:.6g} s and the mass would hang "
            "over, which this method cannot follow; give an earlier {end_time} or a lower velocity"
        )
    elif status == Status.DROWNED:
        why = f"{{level}}: {status.reason}; give a level that always covers a part of it, or an earlier {{end_time}}"
    elif not turns and (status == Status.ENDLESS or overflows):
        why = "{end_time}: this slide never rests, as its geometry is frozen; add rotation, or give {end_time} in s"
    elif few_turnings and motion.brake > STRONGEST:
        why = _too_strong(motion)
    elif few_turnings:
        why = (
            "{end_time}: this mass creeps to its rest, ever more slowly as what resists falls with the speed, or "
            f"trembles on: it has not rested after {stopped_at:.3g} s; give {{end_time}} in s"
        )
    elif status == Status.ENDLESS:
        times = min(motion.turnings, MOST_TURNS)
        why = f"{end_time}: this mass turns back {times} times or more without coming to rest; give an earlier end in s"
    else:
        growing = "the motion or a state of its effects" if len(motion.plan.program.states) > 2 else "the motion"
        lower = "a lower velocity or " if speed else ""
        why = f"{velocity}, {end_time}: {growing} overflows; give {lower}an earlier end"
    return InputError("", [why])


def _too_strong(motion: Any) -> str:
    """Return the message for a resistance that grows too strongly with the speed, with its causes and remedies."""
    brakes = [name for name in _REMEDIES if name in ("friction", *motion.plan.recipe.effects)]
    remedies = " or ".join(_REMEDIES[name] for name in brakes)
    return (
        f"{', '.join(brakes)}: too strong a brake to be followed: the speed falls by e in 1/q of a radian, q = "
        f"{motion.brake:.2g}, at most {STRONGEST:.0e} can be; give {remedies}"
    )
