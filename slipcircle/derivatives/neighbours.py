"""Derivatives of the outcomes of a motion from ensembles of neighbouring scenes.

Each number is decreased and increased by a ladder of steps h, h/2, h/4, ... If the motion is smooth, an outcome is a +
b h + c h^2 + ... along the ladder, so that differences can be extrapolated to h = 0. This yields the value a and the
slope b on each side without the motion itself, and from both sides the central difference in even powers. A value that
differs from the motion's is a jump, and slopes that differ are a kink. Unresolved derivatives use the next ladder,
which begins where the first one ends.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.arrays import quiet
from slipcircle.base.kinds import ArrayPair, Flags, Floats
from slipcircle.core.motion.solver import solve
from slipcircle.core.scene.scene import Scene
from slipcircle.derivatives.extrapolation import CAUTION, extrapolated, noise_of
from slipcircle.derivatives.parameters import Free, with_parameter_arrays

RUNGS = 11  # steps of a ladder
FIRST = 2.0**-5  # longest step over the scale of its number
LADDERS = 3  # number of ladders; the shortest step is 2^-37 = 7e-12 of the scale
OF_SHAPE = 2  # number of ladders for a section's shape, whose points coincide within 1e-9 of the radius
ACCURACY = 1e-13  # accuracy of neighbouring motions, and least jump
ROUNDING = 4e-16  # least relative rounding error of an outcome
GOAL = 1e-9  # error times scale, over the greatest effect of any number, at which no further ladder is needed
KNOWN = 1e-3  # error times scale, over the greatest effect of any number, above which a derivative is unknown
SHAPE = ("ground.", "centre.", "layers.", "level.", "radius", "crack")
SMOOTH = "smooth"
KINK = "kink"
JUMP = "jump"
ONE_SIDE = "one side"
UNRESOLVED = "unresolved"
SIDES = np.array([[-1.0], [1.0]])
Outcomes = Callable[[Any], Sequence[Any] | Floats]


class Derivatives(NamedTuple):
    """Derivatives of outcomes with respect to numbers, (outcomes, numbers), or a single derivative.

    One-sided data have an additional axis of length 2, below and above the number's value.

    ``kinds`` are "smooth", "kink" (the slopes of both sides differ), "jump" (the outcome is discontinuous), "one side"
    (there is no scene on the other side) or "unresolved".
    """

    kinds: Any
    values: Any  # at a jump the slope on the continuous side, at a kink the mean of both slopes
    errors: Any  # error bounds
    slopes: Floats
    slope_errors: Floats  # infinite if a slope is unknown
    jumps: Floats  # discontinuities of the outcome, 0 where it is continuous


def neighbour_derivatives(
    scene: Scene[float], outcomes: Outcomes, free: Mapping[str, Free], error: float = 0.0
) -> Derivatives:
    """Return derivatives of outcomes of a single scene with respect to numbers that may vary alone.

    ``outcomes`` returns the outcomes of a motion, or of an ensemble as rows. ``error`` is the relative error common to
    the motion and its neighbours.
    """
    nearest: dict[str, list[Derivatives]] = {}  # derivatives of every outcome, by number
    remaining = list(free.values())
    for ladder in range(LADDERS):
        scales = np.array([[[number.scale]] for number in remaining])
        first = RUNGS * ladder
        steps = FIRST * scales * 2.0 ** -np.arange(first, first + RUNGS)
        here, beside = _solved(scene, outcomes, remaining, steps)
        off = CAUTION * max(ACCURACY, error)
        every, goals = _judged(here, beside, steps, scales, off)
        are_open = []
        for number, by_number, goal in zip(remaining, every, goals, strict=True):
            earlier = nearest.get(number.name, by_number)
            pairs = zip(earlier, by_number, strict=True)
            nearest[number.name] = [_nearer(*pair) for pair in pairs]
            ladders = OF_SHAPE if _is_shape(scene, number) else LADDERS
            is_last = ladder + 1 == ladders
            if not is_last and _is_open(by_number, goal):
                are_open.append(number)
        remaining = are_open
        if not remaining:
            break
    columns = []
    for name in Derivatives._fields:
        rows = [[getattr(one, name) for one in by_outcome] for by_outcome in nearest.values()]
        columns.append(np.array(rows).swapaxes(0, 1))
    return Derivatives(*columns)


def _is_open(errors: Sequence[Derivatives], goal: Sequence[float]) -> bool:
    """Return whether the derivative of some outcome with respect to a number needs another ladder.

    `errors` has the derivative of each outcome, and `goal` the error at which each needs no further ladder.
    """
    return not all(one.errors <= most and one.kinds != JUMP for one, most in zip(errors, goal, strict=True))


# --- ensembles -------------------------------------------------------------------------------------------------------


def _solved(scene: Scene[float], outcomes: Outcomes, numbers: Sequence[Free], steps: Floats) -> ArrayPair:
    """Return outcomes of the motion, (outcomes, numbers, 1), and of neighbours, (outcomes, numbers, sides, rungs).

    `steps` are the changes of the numbers in SI units, (numbers, 1, rungs), and the sides are below and above. Numbers
    of a section's shape have a separate ensemble, since each of its lanes needs a section.
    """
    is_shape = np.array([_is_shape(scene, number) for number in numbers])
    parts = [np.flatnonzero(is_shape), np.flatnonzero(~is_shape)]
    here = []
    beside = []
    for part in filter(np.size, parts):
        offsets = steps[part] * SIDES
        some = [numbers[k] for k in part.tolist()]
        values = _neighbours(scene, outcomes, some, offsets)
        of_scene = values[:, :1]
        of_neighbours = values[:, 1:]
        here.append(np.repeat(of_scene, len(part), axis=1))
        beside.append(of_neighbours.reshape(-1, *offsets.shape))
    in_order = np.argsort(np.concatenate(parts))
    all_here = np.concatenate(here, axis=1)
    all_beside = np.concatenate(beside, axis=1)
    return all_here[:, in_order, None], all_beside[:, in_order]


def _is_shape(scene: Scene[float], number: Free) -> bool:
    """Return whether a number belongs to a section's shape, such as a coordinate of the ground or the radius."""
    is_section = "ground" in scene.arc.quantities
    return is_section and number.name.startswith(SHAPE)


def _neighbours(scene: Scene[float], outcomes: Outcomes, numbers: Sequence[Free], offsets: Floats) -> Floats:
    """Return outcomes of the scene and of its neighbours, in which each number has other values, as rows.

    `offsets` are the changes of each number in SI units, (numbers, sides, rungs). The first column belongs to the scene
    itself.
    """
    arrays = {}
    for k, number in enumerate(numbers):
        change = np.zeros_like(offsets)
        change[k] = offsets[k]
        with_scene = np.append(0.0, change)
        arrays[number.name] = number.value + with_scene
    changed, invalid = with_parameter_arrays(scene, arrays)
    accurate = replace(changed, accuracy=ACCURACY)
    with quiet():
        motion = solve(accurate, invalid=invalid)
    return np.array(outcomes(motion))


# --- what differences say --------------------------------------------------------------------------------------------


def _judged(
    here: Floats, beside: Floats, steps: Floats, scales: Floats, off: float
) -> tuple[list[list[Derivatives]], list[list[float]]]:
    """Return derivatives by one ladder, (numbers, outcomes), and the errors at which they need no further ladder.

    `here` and `beside` are the outcomes of `_solved`. The steps are (numbers, 1, rungs) and the scales (numbers, 1, 1).
    `off` is the relative error common to all outcomes.
    """
    largest = _largest(here, beside)
    scatter = noise_of(beside) + ROUNDING * largest[..., None]
    noise = np.broadcast_to(scatter, beside.shape)
    jumps = _jumps(here, beside, noise, largest)
    slopes, errors = _slopes(beside, noise, steps)
    steepness = np.abs(slopes)
    errors = errors + off * steepness
    is_sure = errors < KNOWN * steepness
    sure = np.where(is_sure & (jumps == 0.0), steepness, 0.0)
    size = _greatest(sure, scales, largest)
    is_known = errors <= KNOWN * size
    errors = np.where(is_known, errors, np.inf)
    central, of_central = _central(beside, noise, steps)
    of_central = of_central + off * np.abs(central)
    is_end = np.isnan(beside[..., -1])
    shortest = np.broadcast_to(steps[:, 0, -1], central.shape)
    by_outcome = slopes, errors, jumps, central, of_central, is_end, shortest
    by_number = [column.swapaxes(0, 1) for column in by_outcome]
    every = []
    for of_number in zip(*by_number, strict=True):
        outcomes = zip(*of_number, strict=True)
        every.append([_of_one(*one) for one in outcomes])
    return every, _goals(size, largest, steps)


def _goals(size: Floats, largest: Floats, steps: Floats) -> list[list[float]]:
    """Return the errors at which derivatives need no further ladder, (numbers, outcomes), at least their rounding.

    `size` are the greatest effects of `_greatest`, and `largest` the sizes of outcomes of `_largest`.
    """
    longest = steps[..., 0]
    longest_of_next = longest * 2.0**-RUNGS
    from_rounding = ROUNDING * largest / longest_of_next
    goals = np.maximum(GOAL * size, from_rounding)
    return goals[..., 0].T.tolist()


def _largest(here: Floats, beside: Floats) -> Floats:
    """Return the size of each outcome, (outcomes, 1, 1), or the size of its neighbours if it is 0.

    `here` and `beside` are the outcomes of `_solved`.
    """
    sizes = np.abs(here)
    sizes_beside = np.abs(beside)
    largest = sizes.max(axis=(1, 2), keepdims=True, initial=0.0)
    largest_beside = np.nanmax(sizes_beside, axis=(1, 2, 3), initial=0.0)
    return np.where(largest, largest, largest_beside[:, None, None])


def _greatest(steepness: Floats, scales: Floats, largest: Floats) -> Floats:
    """Return the greatest effect of changing any number by its scale on an outcome, over the scale of each number.

    `steepness` are the sizes of known slopes, (outcomes, numbers, sides). `largest` are the sizes of the outcomes, the
    least values of the effect.
    """
    scale = scales[..., 0]
    changes = steepness * scale
    most_by_any = changes.max(axis=(1, 2), keepdims=True, initial=0.0)
    return np.asarray(np.maximum(largest, most_by_any) / scale)


def _jumps(here: Floats, beside: Floats, noise: Floats, largest: Floats) -> Floats:
    """Return the jumps of outcomes on each side, (outcomes, numbers, sides), 0 where they are continuous or unknown.

    `beside` and its noise have a last axis of steps, and `largest` are the sizes of the outcomes.
    """
    limits, errors = extrapolated(beside, noise, 1)
    gaps = limits - here
    smallest = np.maximum(errors, ACCURACY * largest)
    is_gap = np.abs(gaps) > smallest
    return np.where(is_gap, gaps, 0.0)


def _slopes(beside: Floats, noise: Floats, steps: Floats) -> ArrayPair:
    """Return one-sided derivatives and their errors, each (outcomes, numbers, sides).

    `beside` and its noise have a last axis of steps.
    """
    shorter = steps[..., 1:]
    farther = beside[..., :-1]
    nearer = beside[..., 1:]
    rise = SIDES * (farther - nearer)
    of_rise = 2 * noise[..., 1:]
    return extrapolated(rise / shorter, of_rise / shorter, 1)


def _central(beside: Floats, noise: Floats, steps: Floats) -> ArrayPair:
    """Return central differences and their errors, each (outcomes, numbers).

    `beside` and its noise are (outcomes, numbers, sides, rungs).
    """
    step = steps[:, 0]
    below, above = np.moveaxis(beside, 2, 0)
    rise = above - below
    of_rise = noise.max(axis=2)
    return extrapolated(rise / (2 * step), of_rise / step, 2)


def _of_one(
    slopes: Floats, errors: Floats, jumps: Floats, central: float, of_central: float, is_end: Flags, shortest: float
) -> Derivatives:
    """Return the derivative of one outcome with respect to one number.

    Slopes, their errors and jumps are pairs for the sides below and above. `central` and `of_central` are the central
    difference and its error. `is_end` marks sides without a scene, and `shortest` is the shortest step. A jump that
    could be a kink within the longer steps remains unresolved.
    """
    is_known = np.isfinite(errors)
    has_jump = jumps != 0.0
    joined = is_known & ~has_jump
    errors_of_joined = np.where(joined, errors, np.inf)
    surest = int(np.argmin(errors_of_joined))
    steepness = np.abs(slopes)
    steepest = np.max(steepness, where=is_known, initial=0.0)
    feigned = RUNGS * shortest * steepest
    is_feigned = has_jump & (np.abs(jumps) < feigned)
    below, above = slopes
    kind = UNRESOLVED
    value = slopes[surest]
    error = errors[surest]
    if np.any(is_feigned):
        pass
    elif np.all(joined) and abs(above - below) > errors.sum():
        kind = KINK
        value = slopes.mean()
        error = errors.max()
    elif np.all(joined):
        kind = SMOOTH
        if of_central < error:
            value = central
            error = of_central
    elif joined[surest] and is_end[1 - surest]:
        kind = ONE_SIDE
    elif np.any(has_jump):
        kind = JUMP
    if kind == UNRESOLVED or not np.any(joined):
        value = np.nan
        error = np.inf
    return Derivatives(kind, value, error, slopes, errors, jumps)


def _nearer(before: Derivatives, new: Derivatives) -> Derivatives:
    """Return the combination of two ladders, unresolved if they contradict each other, as with stairs of rounding.

    Both are derivatives of the same outcome, `new` from the shorter steps.
    """
    if before.kinds == UNRESOLVED:
        return new
    surer = before if before.errors <= new.errors else new
    is_farther = before.kinds == JUMP and new.kinds == SMOOTH  # the jump is beyond the shorter steps
    chosen = surer
    if is_farther:
        chosen = new._replace(values=surer.values, errors=surer.errors)
    difference = abs(new.values - before.values)
    if difference > new.errors + before.errors:
        return chosen._replace(kinds=UNRESOLVED, values=np.nan, errors=np.inf)
    return chosen
