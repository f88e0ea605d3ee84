"""Linear propagation of uncertainty, to stand beside the samples: derivatives at the means, and standard deviations.

To first order the mean of an output is its value at the means of the inputs, and its variance the sum of their
variances times the squared derivatives, as the inputs are independent (JCGM 100:2008, equation 10).
"""

import math
from typing import NamedTuple

from slipcircle.arrays.lanes import scene_of
from slipcircle.motion.solver import solve
from slipcircle.motion.quantities import words
from slipcircle.studies.study import OUTPUTS, Study

# Shares of the samples' standard deviation, and standard errors of theirs, up to which a difference is not told. What
# is of second order moves the mean first, and little to what the mean is used for.
_MEAN, _STD, _ERRORS = 0.25, 0.1, 3.0


class Linear(NamedTuple):
    """Mean and standard deviation of an output, to first order; of its magnitude, as in samples."""

    mean: float
    std: float


class Sampled(NamedTuple):
    """Mean and standard deviation of samples, each with its standard error."""

    mean: float
    mean_error: float
    std: float
    std_error: float


def propagated(study: Study) -> dict[str, Linear]:
    """Mean and standard deviation of each output.

    Raises
    ------
    ValueError
        If there is no motion at the means, or it has no derivative by one of the inputs.
    """
    known = {n: u.moments for n, u in study.inputs.items()}
    if wrong := [study.inputs[n].key for n, (mean, std) in known.items() if not math.isfinite(mean + std)]:
        raise ValueError(f"{', '.join(wrong)}: has no finite mean and standard deviation")
    means = {n: float(u.to_si(known[n][0])) for n, u in study.inputs.items()}
    motion = solve(scene_of(study.effects, {**study.values, **means}, 0, study.law, study.fixed), study.accuracy)
    table = motion.sensitivity()
    idle = {"width", *(["end_time"] if motion.arrested else [])}
    if wrong := [u.key for n, u in study.inputs.items() if n not in idle and n not in table.parameters]:
        raise ValueError(f"{', '.join(wrong)}: the motion at the means has no derivative by it")
    found = {}
    for output in OUTPUTS:
        slopes = (table.derivative(output, n) * u.slope(known[n][0]) * known[n][1]
                  for n, u in study.inputs.items() if n not in idle)  # fmt: skip
        found[output] = Linear(abs(table.at[output]), math.hypot(*slopes))
    return found


def disagreement(output: str, linear: Linear, sampled: Sampled, accuracy: float) -> str:
    """What to say where they differ by more than a share of the spread and by more than chance; empty elsewhere."""
    said, unit, few = [], OUTPUTS[output], accuracy * abs(sampled.mean)
    pairs = (("mean", linear.mean, sampled.mean, sampled.mean_error, _MEAN),
             ("standard deviation", linear.std, sampled.std, sampled.std_error, _STD))  # fmt: skip
    for what, here, there, error, share in pairs:
        if abs(here - there) > max(share * sampled.std, _ERRORS * error, few):
            said.append(f"a {what} of {here:.4g} {unit}, the samples {there:.4g} +- {error:.2g}")
    return f"{words(output)}: linear propagation gives {' and '.join(said)}: trust the samples" if said else ""
