"""Linear propagation of uncertainty, for comparison with samples: derivatives at the means and standard deviations.

To first order, the mean of an output is its value at the means of the inputs. For independent inputs its variance is
the sum of their variances times the squared derivatives (JCGM 100:2008, equation 10); correlated inputs add twice the
covariance terms (equation 13). The correlations of the normal scores are used.
"""

import math
from typing import Any, NamedTuple

import numpy as np

from slipcircle.core import solve
from slipcircle.derivatives import free_parameters, neighbour_derivatives, with_parameters
from slipcircle.workbench.common.quantities import OUTCOMES, spelt_out
from slipcircle.workbench.studies.design import Design
from slipcircle.workbench.studies.statistics import Spread

# Tolerances of the comparison, as shares of the samples' standard deviation and in standard errors. Second-order terms
# shift the mean first, which matters less, so that its tolerance is wider.
_MEAN = 0.25
_STD = 0.1
_ERRORS = 3.0


class Linear(NamedTuple):
    """Mean and standard deviation of an output's magnitude, to first order."""

    mean: float
    std: float


def propagated(design: Design) -> dict[str, Linear]:
    """Return the mean and standard deviation of each outcome to first order.

    Raises
    ------
    ValueError
        If the design does not draw inputs, or if the motion or a derivative at the means does not exist.
    """
    if not design.drawn:
        raise ValueError("values on a grid do not have a distribution")
    keys = {n: number.key for n, number in design.inputs.items()}
    means = {}  # SI
    stds = []
    for name, uncertain in design.drawn.items():
        mean, std = uncertain.moments
        if not math.isfinite(mean + std):
            raise ValueError(f"{keys[name]}: does not have a finite mean and standard deviation")
        number = design.inputs[name]
        means[name] = float(number.to_si(mean))
        stds.append(number.slope(mean) * std)
    at_means = with_parameters(design.scene, means)
    motion = solve(at_means, design.accuracy)
    slopes = neighbour_derivatives(at_means, _outcomes, free_parameters(at_means, means)).values
    is_known = np.all(np.isfinite(slopes), axis=0).tolist()
    unknown = [keys[name] for name, is_finite in zip(means, is_known, strict=True) if not is_finite]
    if unknown:
        raise ValueError(f"{', '.join(unknown)}: the motion at the means is not differentiable with respect to it")
    changes = slopes * np.array(stds)
    variances = np.einsum("oi,ij,oj->o", changes, design.correlation, changes)
    linear = map(Linear, np.abs(_outcomes(motion)).tolist(), np.sqrt(np.maximum(variances, 0.0)).tolist())
    return dict(zip(OUTCOMES, linear, strict=True))


def _outcomes(motion: Any) -> Any:
    """Return the signed outcomes of a motion in SI units, in the order of `OUTCOMES`."""
    return np.array([motion.outcomes[name] for name in OUTCOMES])


def disagreement(output: str, linear: Linear, sampled: Spread, accuracy: float) -> str:
    """Return a warning if linear and sampled estimates differ beyond tolerance and chance; otherwise empty text.

    ``accuracy`` is the relative error of each solution.
    """
    differences = []
    unit = OUTCOMES[output].unit
    for name, one, other, error, share in (
        ("mean", linear.mean, sampled.mean, sampled.mean_error, _MEAN),
        ("standard deviation", linear.std, sampled.std, sampled.std_error, _STD),
    ):
        if abs(one - other) > max(share * sampled.std, _ERRORS * error, accuracy * abs(sampled.mean)):
            differences.append(f"a {name} of {one:.4g} {unit}, the samples {other:.4g} +- {error:.2g}")
    if not differences:
        return ""
    return f"{spelt_out(output)}: linear propagation gives {' and '.join(differences)}: use the samples"
