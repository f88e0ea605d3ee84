"""Richardson extrapolation to h = 0 from values at steps h, h/2, h/4, ..., with error estimates.

The last axis of every array contains the steps, the longest first, with NaN for unknown values. A tableau removes one
power of h after the other (Ridders, Adv. Eng. Softw. 4, 75, 1982). Its best entry has the smallest error.
"""

import numpy as np

from slipcircle.base.kinds import ArrayPair, Floats

COLUMNS = 7  # number of columns of a tableau
CAUTION = 3.0  # error over the last change in a tableau; 2.4 for a half power of h, the worst case
NOISY = 4.0  # allowed difference of values at shorter steps, over their noise
SMOOTH = 8  # number of shortest steps over which values are a cubic plus noise


def extrapolated(column: Floats, noise: Floats, first_power: int) -> ArrayPair:
    """Return values for h = 0 in powers of h^first_power, and their errors: three times the last change, plus noise.

    The column contains values at the steps h, h/2, h/4, ... along its last axis, and `noise` their absolute errors.

    The last change is the greatest difference from both neighbours in the preceding column and from the next entry in
    the same column, which rarely agree by chance. No value at shorter steps may differ by more than its noise.
    """
    shape = column.shape[:-1]
    best = np.full(shape, np.nan)
    least = np.full(shape, np.inf)
    for power in range(first_power, first_power * COLUMNS + 1, first_power):
        following = _combined(column, power, -1.0)
        noise = _combined(noise, power, 1.0)
        # The greatest difference of each entry from its neighbours in the preceding column and in its own.
        longer = column[..., :-1]
        shorter = column[..., 1:]
        last_but_one = following[..., -2:-1]
        next_one = np.concatenate([following[..., 1:], last_but_one], axis=-1)
        changes = [np.abs(following - other) for other in (longer, shorter, next_one)]
        error = CAUTION * np.max(changes, axis=0) + noise
        error = np.maximum(error, _unlike_shorter(following, noise))
        error = np.where(np.isnan(error), np.inf, error)
        place = np.argmin(error, axis=-1, keepdims=True)
        value = np.take_along_axis(following, place, -1)[..., 0]
        surest = np.take_along_axis(error, place, -1)[..., 0]
        is_better = surest < least
        best = np.where(is_better, value, best)
        least = np.where(is_better, surest, least)
        column = following
    return best, least


def _combined(column: Floats, power: int, sign: float) -> Floats:
    """Return the next column of a tableau without a power of h, or its noise if `sign` is positive.

    `power` is the exponent of h. The result has one entry fewer along the last axis.
    """
    factor = 2.0**power
    longer = column[..., :-1]
    shorter = factor * column[..., 1:]
    combined = shorter + sign * longer
    return np.asarray(combined / (factor - 1))


def _unlike_shorter(following: Floats, noise: Floats) -> Floats:
    """Return by how much entries of a column differ from entries at shorter steps beyond their noise.

    The result has the shape of the column. It is the greatest excess for each entry.
    """
    rows = following[..., :, None]
    columns = following[..., None, :]
    differences = np.abs(rows - columns)
    of_noise = NOISY * noise
    return np.triu(differences - of_noise[..., None, :]).max(axis=-1)


def noise_of(values: Floats) -> Floats:
    """Return the scatter of values at the shortest steps, the greatest residual of a cubic, (..., 1).

    The values, (..., steps), are at the steps h, h/2, h/4, ...
    """
    column = values[..., -SMOOTH:]
    for power in (1, 2, 3):
        column = _combined(column, power, -1.0)
    differences = np.abs(np.diff(column))
    return np.asarray(np.max(np.nan_to_num(differences), axis=-1, keepdims=True))
