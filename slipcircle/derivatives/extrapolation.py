"""Values for h = 0 of what is known at steps h, h/2, h/4, ..., with their errors: Richardson's extrapolation.

The last axis of every array is that of the steps, the longest first; NaN where nothing is known. A tableau removes one
power of h after the other (Ridders, Adv. Eng. Softw. 4, 75, 1982); its best entry is the one with the smallest error.
"""

import numpy as np

from slipcircle.base.kinds import Floats

COLUMNS = 7  # of a tableau
CAUTION = 3.0  # error over the last change in a tableau: of a half power of h, the worst, it is 2.4
NOISY = 4.0  # times its noise, by which values at shorter steps may differ
SMOOTH = 8  # shortest steps over which values are a cubic but for their noise


def extrapolated(column: Floats, noise: Floats, first_power: int) -> tuple[Floats, Floats]:
    """Values for h = 0 in powers of h^first_power, and their errors: three times the last change, and the noise.

    Changes are those from both neighbours in the column before and to the next in the same one, which agree by chance
    rarely; and no value at shorter steps may differ by more than its noise.
    """
    shape = column.shape[:-1]
    best = np.full(shape, np.nan)
    least = np.full(shape, np.inf)
    last_power = first_power * COLUMNS
    for power in range(first_power, last_power + 1, first_power):
        following = _combined(column, power, -1.0)
        noise = _combined(noise, power, 1.0)
        change = _last_change(following, column)
        error = CAUTION * change + noise
        error = np.maximum(error, _unlike_shorter(following, noise))
        is_unknown = np.isnan(error)
        error = np.where(is_unknown, np.inf, error)
        place = np.argmin(error, axis=-1, keepdims=True)
        value = np.take_along_axis(following, place, -1)[..., 0]
        surest = np.take_along_axis(error, place, -1)[..., 0]
        is_better = surest < least
        best = np.where(is_better, value, best)
        least = np.where(is_better, surest, least)
        column = following
    return best, least


def _combined(column: Floats, power: int, sign: float) -> Floats:
    """The next column of a tableau, without this power of h; with a positive sign the noise of it."""
    factor = 2.0**power
    longer = column[..., :-1]
    shorter = column[..., 1:]
    combined = factor * shorter + sign * longer
    weight = factor - 1
    return np.asarray(combined / weight)


def _last_change(following: Floats, column: Floats) -> Floats:
    """The greatest change to an entry from both neighbours in the column before, or to the next in its own."""
    longer = column[..., :-1]
    shorter = column[..., 1:]
    after = following[..., 1:]
    before_last = following[..., -2:-1]
    next_one = np.concatenate([after, before_last], axis=-1)
    changes = [np.abs(following - other) for other in (longer, shorter, next_one)]
    return np.max(changes, axis=0)


def _unlike_shorter(following: Floats, noise: Floats) -> Floats:
    """By how much values at shorter steps are others, beyond their noise."""
    one = following[..., :, None]
    other = following[..., None, :]
    differences = np.abs(one - other)
    allowed = NOISY * noise
    unlike = differences - allowed[..., None, :]
    return np.triu(unlike).max(axis=-1)


def noise_of(values: Floats) -> Floats:
    """How much values scatter at the shortest steps: the greatest of what a cubic leaves, of all steps."""
    column = values[..., -SMOOTH:]
    for power in (1, 2, 3):
        column = _combined(column, power, -1.0)
    changes = np.abs(np.diff(column))
    known = np.nan_to_num(changes)
    return np.asarray(np.max(known, axis=-1, keepdims=True))
