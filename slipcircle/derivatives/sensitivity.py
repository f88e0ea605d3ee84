"""Derivatives of a motion's outputs with respect to every number of its scene, with error bounds."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from slipcircle.base.kinds import TextMap, Texts
from slipcircle.core import Motion
from slipcircle.derivatives.derivatives import Sensitivity
from slipcircle.derivatives.neighbours import JUMP, SMOOTH, UNRESOLVED, Derivatives, neighbour_derivatives
from slipcircle.derivatives.parameters import Free, parameters

OUTPUTS: TextMap = {"peak_velocity": "m/s", "run_out": "m", "duration": "s"}
SIDES = ("below", "above")


def sensitivity(motion: Motion) -> Sensitivity:
    """Return derivatives of a single motion's outputs with respect to every number of its scene, and warnings.

    Notes
    -----
    If nothing brings the mass to rest, the outputs are those at its first standstill. Coordinates of a section without
    influence, such as the ground beside the mass, are omitted.
    """
    if motion.shape:
        raise ValueError("sensitivity: takes a single scene; solve one case of the ensemble")
    if not motion.moves and motion.limit_friction == motion.friction:
        raise ValueError("friction: the scene is exactly at its limit, where the motion has no derivative")
    scene = motion.plan.scene
    outputs = dict.fromkeys(motion.outcomes, 0.0)
    if motion.moves:
        outputs |= {name: float(value) for name, value in motion.outcomes.items()}
    free = parameters(scene)
    warnings = []
    if any(outputs.values()):
        derivatives = neighbour_derivatives(scene, _outcomes, free, motion.error_estimate)
        kept = list(_mattering(derivatives, free))
        derivatives = Derivatives(*(array[:, kept] for array in derivatives))
        names = [*free]
        free = {names[k]: free[names[k]] for k in kept}
        warnings += _warnings(derivatives, free)
    else:
        shape = len(OUTPUTS), len(free)
        none = np.zeros(shape)
        both = np.zeros((*shape, 2))
        derivatives = Derivatives(np.full(shape, SMOOTH), none, none, both, both, both)
        warnings.append("does not move, so that small changes have no effect")
    units = {name: number.unit for name, number in free.items()}
    values = {name: number.value for name, number in free.items()}
    return Sensitivity(OUTPUTS, units, outputs | values, *derivatives, scene=scene, warnings=tuple(warnings))


def _outcomes(motion: Any) -> list[Any]:
    """Return the outcomes of a motion in the order of `OUTPUTS`, in SI units."""
    return [motion.outcomes[name] for name in OUTPUTS]


def _mattering(derivatives: Derivatives, free: Mapping[str, Free]) -> Iterator[int]:
    """Yield the indices of numbers, without points of the ground and water level that have no influence.

    `free` are the numbers by name in the order of the columns of `derivatives`.
    """
    by_slope: Any = derivatives.slopes.any(axis=(0, 2))
    by_jump: Any = derivatives.jumps.any(axis=(0, 2))
    is_other: Any = derivatives.kinds != SMOOTH
    by_kind = is_other.any(axis=0)
    for k, name in enumerate(free):
        is_place = name.startswith(("ground.", "level."))
        if not is_place or by_slope[k] or by_jump[k] or by_kind[k]:
            yield k


def _warnings(derivatives: Derivatives, free: Mapping[str, Free]) -> Texts:
    """Return warnings about the largest jump of each output by a number, and about unknown derivatives.

    `free` are the numbers by name in the order of the columns of `derivatives`.
    """
    warnings = []
    for k, name in enumerate(free):
        jumps = []
        unresolved = []
        for row, (output, unit) in enumerate(OUTPUTS.items()):
            kind = derivatives.kinds[row, k]
            if kind == JUMP:
                by_side = derivatives.jumps[row, k]
                side = int(np.argmax(np.abs(by_side)))
                size = by_side[side]
                jumps.append(f"{output} {size:+.3g} {unit} {SIDES[side]}")
            elif kind == UNRESOLVED:
                unresolved.append(output)
        if jumps:
            listed = ", ".join(jumps)
            warnings.append(f"{name}: outcomes jump at this value ({listed}); derivatives are those of the other side")
        if unresolved:
            listed = ", ".join(unresolved)
            warnings.append(f"{name}: {listed}: no derivative is known, as neighbouring motions do not converge")
    return warnings
