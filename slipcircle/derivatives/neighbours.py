"""Derivatives of the outcomes of a motion by the numbers of its scene, from ensembles of neighbouring scenes.

Each number is moved down and up by a ladder of steps h, h/2, h/4, ... Along a ladder an outcome is a + b h + c h^2 +
... as far as the motion is smooth, so that differences are extrapolated to h = 0: on each side its value a and its
slope b, both without the motion itself, and between both sides the central difference, in even powers. Values unlike
the motion's own are a jump, unlike slopes a kink. What one ladder leaves open gets the next, which begins where it
ends.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import groupby
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
_Known = tuple[Floats, Floats]  # values and errors
Outcomes = Callable[[Any], Sequence[Any] | Floats]


class Derivatives(NamedTuple):
    """Derivatives of outcomes by numbers, (outcomes, numbers); below and above a number's value (..., 2).

    ``kinds`` are "smooth", "kink" (both slopes differ), "jump" (the outcome is another at once on a side), "one side"
    (there is no scene beyond) or "unresolved".
    """

    kinds: Any
    values: Any  # of a jump on the side that goes on from the motion, of a kink the mean of both slopes
    errors: Any  # that values are off at most
    slopes: Floats
    slope_errors: Floats  # infinite where a slope is not known
    jumps: Floats  # by how much the outcome is another at once; 0 where it is continuous

    def at(self, numbers: Any) -> "Derivatives":
        """Those by some of the numbers."""
        return Derivatives(*(array[:, numbers] for array in self))


class _Values(NamedTuple):
    """Outcomes of the motion, (outcomes, numbers), and of its neighbours, (outcomes, numbers, sides, rungs), or NaN."""

    here: Floats
    beside: Floats


def neighbour_derivatives(
    scene: Scene[float], outcomes: Outcomes, free: Mapping[str, Free], error: float = 0.0
) -> Derivatives:
    """Derivatives of outcomes of a single scene by numbers that may vary alone.

    ``outcomes`` reads them off a motion, or off an ensemble, in rows. ``error`` is the relative error that those of the
    motion and of its neighbours have alike.
    """
    every = list(free.values())
    scales = np.array([number.scale for number in every])
    remaining = np.arange(len(every))
    found: Any = None
    for ladder in range(LADDERS):
        first = RUNGS * ladder
        rungs = np.arange(first, first + RUNGS)
        scale = scales[remaining]
        longest = scale[:, None] * FIRST
        shares = 2.0**-rungs
        steps = longest * shares
        numbers = [every[k] for k in remaining]
        values = _solved(scene, outcomes, numbers, steps)
        new, is_open = _judged(values, steps, scale, CAUTION * max(ACCURACY, error))
        if found is None:
            found = new
        else:
            before = found.at(remaining)
            nearer = _nearer(before, new)
            for known, array in zip(found, nearer, strict=True):
                known[:, remaining] = array
        any_open = is_open.any(axis=0)
        remaining = remaining[any_open]
        if not remaining.size:
            break
    return Derivatives(*found)


# --- ensembles -------------------------------------------------------------------------------------------------------


def _solved(scene: Scene[float], outcomes: Outcomes, numbers: Sequence[Free], steps: Floats) -> _Values:
    parts = list[_Values]()
    for part in _parts(scene, numbers):
        values = _neighbours(scene, outcomes, numbers[part], steps[part])
        parts.append(values)
    here, beside = zip(*parts, strict=True)
    return _Values(here=np.concatenate(here, axis=1), beside=np.concatenate(beside, axis=1))


def _parts(scene: Scene[float], numbers: Sequence[Free]) -> Iterator[slice]:
    """Those of the numbers that go into one ensemble: some of a section's shape, or as many others as follow."""
    is_section = "ground" in scene.arc.quantities
    first = 0
    for of_shape, group in groupby(numbers, lambda number: is_section and number.name.startswith(SHAPE)):
        end = first + len(list(group))
        most = TOGETHER if of_shape else end
        while first < end:
            last = min(first + most, end)
            yield slice(first, last)
            first = last


def _neighbours(scene: Scene[float], outcomes: Outcomes, numbers: Sequence[Free], steps: Floats) -> _Values:
    """One ensemble of the scene and its neighbours."""
    each_side = steps[:, None, :]
    offsets = each_side * SIDES
    arrays = {}
    for k, number in enumerate(numbers):
        change = np.zeros_like(offsets)
        change[k] = offsets[k]
        every_change = np.append(0.0, change)
        arrays[number.name] = number.value + every_change
    changed, invalid = with_parameter_arrays(scene, arrays)
    accurate = replace(changed, accuracy=ACCURACY)
    with np.errstate(all="ignore"):
        motion = solve(accurate, invalid=invalid)
    values = np.array(outcomes(motion))
    of_scene = values[:, :1]
    of_others = values[:, 1:]
    here = np.repeat(of_scene, len(numbers), axis=1)
    beside = of_others.reshape(-1, *offsets.shape)
    return _Values(here, beside)


# --- what differences say --------------------------------------------------------------------------------------------


def _judged(values: _Values, steps: Floats, scales: Floats, off: float) -> tuple[Derivatives, Flags]:
    """Derivatives by one ladder, and which of them need another; outcomes are ``off`` alike, relative."""
    beside = values.beside
    largest = _largest(values)
    rounding = ROUNDING * largest
    every_rounding = rounding[:, None, None, None]
    scatter = noise_of(beside) + every_rounding
    noise = np.broadcast_to(scatter, beside.shape)
    jumps = _jumps(values, noise, largest)
    slopes, slope_errors = _slopes(beside, noise, steps)
    steepness = np.abs(slopes)
    slope_errors = slope_errors + off * steepness
    is_sure = slope_errors < KNOWN * steepness
    is_sure &= jumps == 0.0
    sure = np.where(is_sure, steepness, 0.0)
    size = _greatest(sure, scales, largest)
    by_side = size[..., None]
    is_known = slope_errors <= KNOWN * by_side
    slope_errors = np.where(is_known, slope_errors, np.inf)
    sides = Derivatives("", 0.0, 0.0, slopes, slope_errors, jumps)
    value, error = _central(beside, noise, steps)
    central = value, error + off * np.abs(value)
    nothing = np.isnan(beside[..., -1])
    found = _kinds(sides, central, nothing, steps[:, -1])
    is_near = found.errors <= GOAL * size
    has_jump = found.kinds == JUMP
    return found, ~is_near | has_jump


def _largest(values: _Values) -> Floats:
    """The size of each outcome; of one that is 0, that of its neighbours."""
    sizes = np.abs(values.here)
    sizes_beside = np.abs(values.beside)
    largest = sizes.max(axis=1, initial=0.0)
    largest_beside = np.nanmax(sizes_beside, axis=(1, 2, 3), initial=0.0)
    return np.where(largest, largest, largest_beside)


def _greatest(steepness: Floats, scales: Floats, largest: Floats) -> Floats:
    """The most that a change of any number by its scale does to an outcome, over the scale of each number."""
    changes = steepness * scales[:, None]
    most_by_any = changes.max(axis=(1, 2), initial=0.0)
    most = np.maximum(largest, most_by_any)
    each_number = most[:, None]
    return np.asarray(each_number / scales)


def _slopes(beside: Floats, noise: Floats, steps: Floats) -> _Known:
    """Of each side by itself."""
    shorter = steps[:, None, 1:]
    farther = beside[..., :-1]
    nearer = beside[..., 1:]
    rise = SIDES * (farther - nearer)
    of_rise = 2 * noise[..., 1:]
    return extrapolated(rise / shorter, of_rise / shorter, 1)


def _central(beside: Floats, noise: Floats, steps: Floats) -> _Known:
    """Between both sides."""
    below, above = np.moveaxis(beside, 2, 0)
    rise = above - below
    of_rise = noise.max(axis=2)
    apart = 2 * steps
    return extrapolated(rise / apart, of_rise / steps, 2)


def _jumps(values: _Values, noise: Floats, largest: Floats) -> Floats:
    """Of outcomes on each side; 0 where they are continuous or not known."""
    limits, errors = extrapolated(values.beside, noise, 1)
    here = values.here[..., None]
    gaps = limits - here
    unseen = ACCURACY * largest
    unseen_by_side = unseen[:, None, None]
    smallest = np.maximum(errors, unseen_by_side)
    is_gap = np.abs(gaps) > smallest
    return np.where(is_gap, gaps, 0.0)


def _kinds(sides: Derivatives, central: _Known, nothing: Flags, shortest: Floats) -> Derivatives:
    """Derivatives of each kind, from those of both sides; ``nothing`` says on which there is no scene."""
    _, _, _, slopes, errors, jumps = sides
    is_known = np.isfinite(errors)
    goes_on = jumps == 0.0
    joined = is_known & goes_on
    errors_of_joined = np.where(joined, errors, np.inf)
    surest = np.argmin(errors_of_joined, axis=-1)
    best = surest[..., None]
    value = np.take_along_axis(slopes, best, -1)
    error = np.take_along_axis(errors, best, -1)
    beyond = np.take_along_axis(nothing, 1 - best, -1)
    kinds = _named(sides, joined, beyond[..., 0], shortest)
    of_side = value[..., 0], error[..., 0]
    is_smooth = kinds == SMOOTH
    values, of_values = _surer(of_side, central, is_smooth)
    is_kink = kinds == KINK
    mean = slopes.mean(axis=-1)
    largest_error = errors.max(axis=-1)
    values = np.where(is_kink, mean, values)
    of_values = np.where(is_kink, largest_error, of_values)
    unknown = kinds == UNRESOLVED
    unknown |= ~joined.any(axis=-1)
    values = np.where(unknown, np.nan, values)
    of_values = np.where(unknown, np.inf, of_values)
    return Derivatives(kinds, values, of_values, slopes, errors, jumps)


def _named(sides: Derivatives, joined: Flags, beyond: Flags, shortest: Floats) -> Any:
    """The kind of each derivative. A jump that a kink nearer than the longer steps would feign is left open."""
    _, _, _, slopes, errors, jumps = sides
    has_jump = jumps != 0.0
    is_known = np.isfinite(errors)
    steepness = np.abs(slopes)
    steepest = np.max(steepness, axis=-1, where=is_known, initial=0.0)
    feigned = RUNGS * shortest * steepest
    by_side = feigned[..., None]
    is_feigned = has_jump & (np.abs(jumps) < by_side)
    both = joined.all(axis=-1)
    one = joined.any(axis=-1)
    below = slopes[..., 0]
    above = slopes[..., 1]
    difference = np.abs(above - below)
    allowed = errors.sum(axis=-1)
    conditions = {
        UNRESOLVED: is_feigned.any(axis=-1),
        KINK: both & (difference > allowed),
        SMOOTH: both,
        ONE_SIDE: one & beyond,
        JUMP: has_jump.any(axis=-1),
    }
    return np.select([*conditions.values()], [*conditions], UNRESOLVED)


def _surer(one: _Known, other: _Known, where: Any = True) -> _Known:
    """Values and errors of the second where they are allowed and surer."""
    value, error = one
    other_value, other_error = other
    better = where & (other_error < error)
    values = np.where(better, other_value, value)
    errors = np.where(better, other_error, error)
    return values, errors


def _nearer(before: Derivatives, new: Derivatives) -> Derivatives:
    """What two ladders say; nothing where they contradict each other, as where rounding makes stairs of an outcome."""
    was_known = before.kinds != UNRESOLVED
    surer_before = was_known & (before.errors <= new.errors)
    difference = np.abs(new.values - before.values)
    allowed = new.errors + before.errors
    contradict = was_known & (difference > allowed)
    jumped = before.kinds == JUMP
    goes_on = new.kinds == SMOOTH
    is_farther = jumped & goes_on  # than the shortest steps, the jump
    keeps = surer_before & ~is_farther
    kinds = np.where(keeps, before.kinds, new.kinds)
    kinds = np.where(contradict, UNRESOLVED, kinds)
    values = np.where(surer_before, before.values, new.values)
    values = np.where(contradict, np.nan, values)
    errors = np.where(surer_before, before.errors, new.errors)
    errors = np.where(contradict, np.inf, errors)
    each_side = keeps[..., None]
    slopes = np.where(each_side, before.slopes, new.slopes)
    slope_errors = np.where(each_side, before.slope_errors, new.slope_errors)
    jumps = np.where(each_side, before.jumps, new.jumps)
    return Derivatives(kinds, values, errors, slopes, slope_errors, jumps)
