"""Linear propagation of uncertainty, to stand beside the samples: derivatives at the means, and standard deviations.

To first order the mean of an output is its value at the means of the inputs, and its variance the sum of their
variances times the squared derivatives where the inputs are independent (JCGM 100:2008, equation 10), with twice
their covariances where they are not (13); correlations are taken to be those of the normal scores.
"""

import math
from typing import Any, NamedTuple

import numpy as np

from slipcircle.core import solve
from slipcircle.derivatives import free_parameters, neighbour_derivatives, with_parameters
from slipcircle.workbench.common.quantities import OUTCOMES, words
from slipcircle.workbench.studies.design import Design
from slipcircle.workbench.studies.statistics import Spread

# Shares of the samples' standard deviation, and standard errors of theirs, up to which there is no warning. What is of
# second order moves the mean first, and little to what the mean is used for.
_MEAN, _STD, _ERRORS = 0.25, 0.1, 3.0


class Linear(NamedTuple):
    """Mean and standard deviation of an output, to first order; of its magnitude, as in samples."""

    mean: float
    std: float


def propagated(design: Design) -> dict[str, Linear]:
    """Return mean and standard deviation of each outcome to first order.

    Raises
    ------
    ValueError
        If nothing is drawn, there is no motion at the means, or no derivative by one of the inputs.
    """
    if not design.drawn:
        raise ValueError("values on a grid have no distribution")
    keys = {n: number.key for n, number in design.inputs.items()}
    means = dict[str, float]()  # SI
    stds = []
    for name, uncertain in design.drawn.items():
        mean, std = uncertain.moments
        if not math.isfinite(mean + std):
            raise ValueError(f"{keys[name]}: has no finite mean and standard deviation")
        number = design.inputs[name]
        means[name] = float(number.to_si(mean))
        stds.append(number.slope(mean) * std)
    at_means = with_parameters(design.scene, means)
    motion = solve(at_means, design.accuracy)
    slopes = neighbour_derivatives(at_means, _outcomes, free_parameters(at_means, means)).values
    is_known = np.all(np.isfinite(slopes), axis=0).tolist()
    unknown = [keys[name] for name, known in zip(means, is_known, strict=True) if not known]
    if unknown:
        raise ValueError(f"{', '.join(unknown)}: the motion at the means has no derivative by it")
    changes = slopes * np.array(stds)
    variances = np.einsum("oi,ij,oj->o", changes, design.correlation, changes)
    means_of = np.abs(_outcomes(motion)).tolist()
    stds_of = np.sqrt(np.maximum(variances, 0.0)).tolist()
    linear = map(Linear, means_of, stds_of)
    return dict(zip(OUTCOMES, linear, strict=True))


def _outcomes(motion: Any) -> Any:
    return np.array([motion.outcomes[name] for name in OUTCOMES])


def disagreement(output: str, linear: Linear, sampled: Spread, accuracy: float) -> str:
    """Return a warning if both differ by more than a share of the spread and by more than chance."""
    differences = []
    unit = OUTCOMES[output].unit
    for name, one, other, error, share in (
        ("mean", linear.mean, sampled.mean, sampled.mean_error, _MEAN),
        ("standard deviation", linear.std, sampled.std, sampled.std_error, _STD),
    ):
        numerical = accuracy * abs(sampled.mean)
        if abs(one - other) > max(share * sampled.std, _ERRORS * error, numerical):
            differences.append(f"a {name} of {one:.4g} {unit}, the samples {other:.4g} +- {error:.2g}")
    if not differences:
        return ""
    return f"{words(output)}: linear propagation gives {' and '.join(differences)}: use the samples"
