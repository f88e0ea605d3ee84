"""Linear propagation of uncertainty, to stand beside the samples: derivatives at the means, and standard deviations.

To first order the mean of an output is its value at the means of the inputs, and its variance the sum of their
variances times the squared derivatives where the inputs are independent (JCGM 100:2008, equation 10), with twice
their covariances where they are not (13); correlations are taken to be those of the normal scores.
"""

import math
from typing import NamedTuple

import numpy as np

from slipcircle.core import with_parameters
from slipcircle.workbench.common.quantities import OUTCOMES, words
from slipcircle.workbench.studies.design import Design
from slipcircle.workbench.studies.motions import derivatives
from slipcircle.workbench.studies.statistics import Spread

# Shares of the samples' standard deviation, and standard errors of theirs, up to which a difference is not told. What
# is of second order moves the mean first, and little to what the mean is used for.
_MEAN, _STD, _ERRORS = 0.25, 0.1, 3.0


class Linear(NamedTuple):
    """Mean and standard deviation of an output, to first order; of its magnitude, as in samples."""

    mean: float
    std: float


def propagated(design: Design) -> dict[str, Linear]:
    """Mean and standard deviation of each outcome.

    Raises
    ------
    ValueError
        If nothing is drawn, there is no motion at the means, or no derivative by one of the inputs.
    """
    if not design.drawn:
        raise ValueError("values on a grid have no distribution")
    known = {n: u.moments for n, u in design.drawn.items()}
    if wrong := [design.inputs[n].key for n, (mean, std) in known.items() if not math.isfinite(mean + std)]:
        raise ValueError(f"{', '.join(wrong)}: has no finite mean and standard deviation")
    means = {n: float(design.inputs[n].to_si(mean)) for n, (mean, _) in known.items()}
    at, slopes = derivatives(with_parameters(design.scene, means), means, design.accuracy)
    if wrong := [design.inputs[n].key for n in means if not all(math.isfinite(s[n]) for s in slopes.values())]:
        raise ValueError(f"{', '.join(wrong)}: the motion at the means has no derivative by it")
    steps = {n: design.inputs[n].slope(mean) * std for n, (mean, std) in known.items()}  # of a standard deviation, SI
    found = {}
    for outcome, by in slopes.items():
        shares = np.array([by[n] * step for n, step in steps.items()])
        variance = float(shares @ design.correlation @ shares)
        found[outcome] = Linear(abs(at[outcome]), math.sqrt(max(variance, 0.0)))
    return found


def disagreement(output: str, linear: Linear, sampled: Spread, accuracy: float) -> str:
    """What to say where they differ by more than a share of the spread and by more than chance; empty elsewhere."""
    said, unit, few = [], OUTCOMES[output].unit, accuracy * abs(sampled.mean)
    pairs = (
        ("mean", linear.mean, sampled.mean, sampled.mean_error, _MEAN),
        ("standard deviation", linear.std, sampled.std, sampled.std_error, _STD),
    )
    for what, here, there, error, share in pairs:
        if abs(here - there) > max(share * sampled.std, _ERRORS * error, few):
            said.append(f"a {what} of {here:.4g} {unit}, the samples {there:.4g} +- {error:.2g}")
    return f"{words(output)}: linear propagation gives {' and '.join(said)}: trust the samples" if said else ""
