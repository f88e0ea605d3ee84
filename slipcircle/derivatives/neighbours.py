"""Derivatives of the outcomes of a motion by the numbers of its scene, from ensembles of neighbouring scenes.

Each number is moved down and up by a ladder of steps h, h/2, h/4, ... Along a ladder an outcome is a + b h + c h^2 +
... as far as the motion is smooth, so that differences are extrapolated to h = 0: on each side its value a and its
slope b, both without the motion itself, and between both sides the central difference, in even powers. Values unlike
the motion's own are a jump, unlike slopes a kink. What one ladder leaves open gets the next, which begins where it
ends.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import Flags, Floats
from slipcircle.core.motion.solver import solve
from slipcircle.core.scene.scene import Scene
from slipcircle.derivatives.extrapolation import CAUTION, extrapolated, noise_of
from slipcircle.derivatives.parameters import Free, with_parameter_arrays

RUNGS = 11  # of a ladder
FIRST = 2.0**-5  # the longest step, over the scale of its number
LADDERS = 3  # so that steps go down to 2^-37 = 7e-12 of the scale
ACCURACY = 1e-13  # of the neighbours; a smaller jump is none
ROUNDING = 4e-16  # that an outcome has at least, relative
GOAL = 1e-9  # error times scale, over the most that any number does, below which no other ladder is needed
KNOWN = 1e-3  # the same, above which nothing is known
TOGETHER = 6  # numbers of a section's shape in one ensemble: each of its lanes has a section, which takes time
SHAPE = ("ground.", "centre.", "layers.", "level.", "radius", "crack")
SMOOTH, KINK, JUMP, ONE_SIDE, UNRESOLVED = "smooth", "kink", "jump", "one side", "unresolved"
SIDES = np.array([[-1.0], [1.0]])
Outcomes = Callable[[Any], Sequence[Any] | Floats]


class Derivatives(NamedTuple):
    """Derivatives of outcomes by numbers, (outcomes, numbers), or one of them; below and above a number's value, (2,).

    ``kinds`` are "smooth", "kink" (both slopes differ), "jump" (the outcome is another at once on a side), "one side"
    (there is no scene beyond) or "unresolved".
    """

    kinds: Any
    values: Any  # of a jump on the side that goes on from the motion, of a kink the mean of both slopes
    errors: Any  # that values are off at most
    slopes: Floats
    slope_errors: Floats  # infinite where a slope is not known
    jumps: Floats  # by how much the outcome is another at once; 0 where it is continuous


def neighbour_derivatives(
    scene: Scene[float], outcomes: Outcomes, free: Mapping[str, Free], error: float = 0.0
) -> Derivatives:
    """Derivatives of outcomes of a single scene by numbers that may vary alone.

    ``outcomes`` reads them off a motion, or off an ensemble, in rows. ``error`` is the relative error that those of the
    motion and of its neighbours have alike.
    """
    found: dict[str, list[Derivatives]] = {}  # of every outcome, by number
    remaining = list(free.values())
    for ladder in range(LADDERS):
        scales = np.array([[[number.scale]] for number in remaining])
        rungs = RUNGS * ladder + np.arange(RUNGS)
        steps = FIRST * scales * 2.0**-rungs
        here, beside = _solved(scene, outcomes, remaining, steps)
        every, near = _judged(here, beside, steps, scales, CAUTION * max(ACCURACY, error))
        are_open = []
        for k, number in enumerate(remaining):
            by_number = [row[k] for row in every]
            limits = near[:, k].tolist()
            known = found.get(number.name, by_number)
            found[number.name] = [_nearer(*pair) for pair in zip(known, by_number, strict=True)]
            if any(new.kinds == JUMP or not new.errors <= most for new, most in zip(by_number, limits, strict=True)):
                are_open.append(number)
        remaining = are_open
        if not remaining:
            break
    rows = [*zip(*found.values(), strict=True)]  # by outcome
    return Derivatives(*(np.array([[one[k] for one in row] for row in rows]) for k in range(len(Derivatives._fields))))


# --- ensembles -------------------------------------------------------------------------------------------------------


def _solved(scene: Scene[float], outcomes: Outcomes, numbers: Sequence[Free], steps: Floats) -> tuple[Floats, Floats]:
    """Outcomes of the motion, (outcomes, numbers, 1), and of its neighbours, (outcomes, numbers, sides, rungs), or NaN.

    Of the numbers of a section's shape only some are in one ensemble.
    """
    is_section = "ground" in scene.arc.quantities
    places = range(len(numbers))
    of_shape = [k for k in places if is_section and numbers[k].name.startswith(SHAPE)]
    parts = [[k for k in places if k not in of_shape]]
    parts += [of_shape[first : first + TOGETHER] for first in range(0, len(of_shape), TOGETHER)]
    here: list[Any] = [None] * len(numbers)
    beside: list[Any] = [None] * len(numbers)
    for part in filter(None, parts):
        offsets = steps[part] * SIDES
        values = _neighbours(scene, outcomes, [numbers[k] for k in part], offsets)
        of_others = values[:, 1:].reshape(-1, *offsets.shape)
        for place, k in enumerate(part):
            here[k] = values[:, :1]
            beside[k] = of_others[:, place]
    return np.stack(here, axis=1), np.stack(beside, axis=1)


def _neighbours(scene: Scene[float], outcomes: Outcomes, numbers: Sequence[Free], offsets: Floats) -> Floats:
    """Outcomes of the scene, and of it with each number by its offsets another, in rows."""
    arrays = {}
    for k, number in enumerate(numbers):
        change = np.zeros_like(offsets)
        change[k] = offsets[k]
        arrays[number.name] = number.value + np.append(0.0, change)
    changed, invalid = with_parameter_arrays(scene, arrays)
    accurate = replace(changed, accuracy=ACCURACY)
    with np.errstate(all="ignore"):
        motion = solve(accurate, invalid=invalid)
    return np.array(outcomes(motion))


# --- what differences say --------------------------------------------------------------------------------------------


def _judged(
    here: Floats, beside: Floats, steps: Floats, scales: Floats, off: float
) -> tuple[list[list[Derivatives]], Floats]:
    """Derivatives by one ladder, and the errors below which they need no other; outcomes are ``off`` alike."""
    largest = _largest(here, beside)
    scatter = noise_of(beside) + ROUNDING * largest[..., None]
    noise = np.broadcast_to(scatter, beside.shape)
    jumps = _jumps(here, beside, noise, ACCURACY * largest)
    slopes, slope_errors = _slopes(beside, noise, steps)
    steepness = np.abs(slopes)
    slope_errors = slope_errors + off * steepness
    is_sure = (slope_errors < KNOWN * steepness) & (jumps == 0.0)
    changes = np.where(is_sure, steepness, 0.0) * scales[..., 0]
    most_by_any = changes.max(axis=(1, 2), keepdims=True, initial=0.0)
    size = np.maximum(largest, most_by_any) / scales[..., 0]  # the most that any number does, by each one's scale
    slope_errors = np.where(slope_errors <= KNOWN * size, slope_errors, np.inf)
    central, of_central = _central(beside, noise, steps)
    of_central = of_central + off * np.abs(central)
    is_end = np.isnan(beside[..., -1])
    shortest = np.broadcast_to(steps[:, 0, -1], central.shape)
    columns = slopes, slope_errors, jumps, central, of_central, is_end, shortest
    every = [[_of_one(*one) for one in zip(*row, strict=True)] for row in zip(*columns, strict=True)]
    return every, GOAL * size[..., 0]


def _largest(here: Floats, beside: Floats) -> Floats:
    """The size of each outcome, (outcomes, 1, 1); of one that is 0, that of its neighbours."""
    largest = np.abs(here).max(axis=(1, 2), keepdims=True, initial=0.0)
    largest_beside = np.nanmax(np.abs(beside), axis=(1, 2, 3), initial=0.0)
    return np.where(largest, largest, largest_beside[:, None, None])


def _jumps(here: Floats, beside: Floats, noise: Floats, unseen: Floats) -> Floats:
    """Of outcomes on each side; 0 where they are continuous or not known."""
    limits, errors = extrapolated(beside, noise, 1)
    gaps = limits - here
    return np.where(np.abs(gaps) > np.maximum(errors, unseen), gaps, 0.0)


def _slopes(beside: Floats, noise: Floats, steps: Floats) -> tuple[Floats, Floats]:
    """Of each side by itself."""
    shorter = steps[..., 1:]
    rise = SIDES * (beside[..., :-1] - beside[..., 1:])
    of_rise = 2 * noise[..., 1:]
    return extrapolated(rise / shorter, of_rise / shorter, 1)


def _central(beside: Floats, noise: Floats, steps: Floats) -> tuple[Floats, Floats]:
    """Between both sides."""
    shares = steps[:, 0]
    rise = beside[:, :, 1] - beside[:, :, 0]
    return extrapolated(rise / (2 * shares), noise.max(axis=2) / shares, 2)


def _of_one(
    slopes: Floats, errors: Floats, jumps: Floats, central: float, of_central: float, is_end: Flags, shortest: float
) -> Derivatives:
    """The derivative of one outcome by one number; ``is_end`` says on which side there is no scene.

    A jump that a kink nearer than the longer steps would feign is left open.
    """
    is_known = np.isfinite(errors)
    joined = is_known & (jumps == 0.0)
    surest = int(np.argmin(np.where(joined, errors, np.inf)))
    steepest = np.max(np.abs(slopes), where=is_known, initial=0.0)
    has_jump = jumps != 0.0
    is_feigned = has_jump & (np.abs(jumps) < RUNGS * shortest * steepest)
    kind, value, error = UNRESOLVED, slopes[surest], errors[surest]
    if np.any(is_feigned):
        pass
    elif np.all(joined) and abs(slopes[1] - slopes[0]) > errors.sum():
        kind, value, error = KINK, slopes.mean(), errors.max()
    elif np.all(joined):
        kind = SMOOTH
        if of_central < error:
            value, error = central, of_central
    elif joined[surest] and is_end[1 - surest]:
        kind = ONE_SIDE
    elif np.any(has_jump):
        kind = JUMP
    if kind == UNRESOLVED or not np.any(joined):
        value, error = np.nan, np.inf
    return Derivatives(kind, value, error, slopes, errors, jumps)


def _nearer(before: Derivatives, new: Derivatives) -> Derivatives:
    """What two ladders say; nothing where they contradict each other, as where rounding makes stairs of an outcome."""
    if before.kinds == UNRESOLVED:
        return new
    surer = before if before.errors <= new.errors else new
    is_farther = before.kinds == JUMP and new.kinds == SMOOTH  # than the shortest steps, the jump
    chosen = new._replace(values=surer.values, errors=surer.errors) if is_farther else surer
    if abs(new.values - before.values) > new.errors + before.errors:
        return chosen._replace(kinds=UNRESOLVED, values=np.nan, errors=np.inf)
    return chosen
