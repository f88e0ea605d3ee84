"""Lognormal fragility curves: the probability that the displacement exceeds a threshold, by the peak acceleration.

With records as clusters: polarities, scales and samples of one record are not independent draws.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from slipcircle.base.kinds import Floats, ValueDict
from slipcircle.base.text import shown
from slipcircle.workbench.common.distributions import special
from slipcircle.workbench.studies.statistics import NOT_GIVEN, Estimate

_CONFIDENCE = 0.95  # of intervals
_FEWEST = 4  # records of a curve
_FEWEST_OF_INTERVAL = 12  # of an interval that covers the true value as often as it should
_SAME = 1e-9  # relative difference of equal peak accelerations, which scaling rounds
_UNKNOWN = np.full((2, 2), np.nan)


def interval_note(records: int) -> str:
    """Return whether fragility curves from so many records have intervals, in words."""
    if records >= _FEWEST_OF_INTERVAL:
        return "95 % intervals of records as independent draws"
    return f"no intervals: {records} records, fewer than {_FEWEST_OF_INTERVAL}"


class FragilityCurve(NamedTuple):
    """The probability Phi(ln(PGA/median)/dispersion) that the displacement exceeds a threshold.

    Attributes
    ----------
    threshold : float
        Of the displacement, m.
    reason : str
        Why there is no curve; empty where there is one.
    median, dispersion : Estimate
        Peak acceleration over gravity at which the probability is one half, and standard deviation of the logarithm of
        the peak acceleration at which a motion exceeds the threshold; NaN where the motions do not identify them.
    coefficients, covariance : ndarray
        a and b of Phi(a + b ln PGA), and their covariance.
    quantile : float
        Of Student's distribution: half the width of an interval in standard errors.
    """

    threshold: float
    reason: str = ""
    median: Estimate = NOT_GIVEN
    dispersion: Estimate = NOT_GIVEN
    coefficients: Floats = _UNKNOWN[0]
    covariance: Floats = _UNKNOWN
    quantile: float = math.nan

    def probability(self, pga: ArrayLike) -> Floats:
        """Return the probability of exceedance at peak accelerations over gravity, and its interval, (3, ...)."""
        log_pga = np.log(np.asarray(pga, dtype=np.float64))
        intercept, slope = self.coefficients
        (of_intercept, joint), (_, of_slope) = self.covariance
        middle = intercept + slope * log_pga
        variance = of_intercept + 2.0 * joint * log_pga + of_slope * log_pga**2
        half = self.quantile * np.sqrt(np.maximum(variance, 0.0))
        bounds = np.stack([middle, middle - half, middle + half])
        return np.asarray(special().ndtr(bounds))

    def to_dict(self) -> ValueDict:
        """Return the curve for JSON."""
        fitted = {"median_pga_g": self.median._asdict(), "dispersion": self.dispersion._asdict()}
        return {"threshold_m": self.threshold} | fitted | {"reason": self.reason}


def fragility_curve(share: Floats, pga: Floats, threshold: float) -> FragilityCurve:
    """Fit the lognormal fragility curve of greatest likelihood.

    The likelihood is that of Baker (2015), of motions by record and scale, whether all records have the same peak
    acceleration at a scale (stripes) or each its own (a cloud). In a and b of Phi(a + b ln PGA), with b = 1/dispersion
    and a = -b ln median, its logarithm is concave.

    Both polarities of a record, and their samples, count as one share of exceedance, and all scales of a record as one
    draw: pooling them does not bias the curve, but intervals that took them for independent would be too short. The
    intervals are those of a jackknife over records, with Student's distribution of as many degrees of freedom as there
    are records less the two fitted numbers; fewer than 12 records have none. `python -m tests.campaigns.coverage`
    measures how often they contain the true values. Samples of the soil are the same for every record: their error is
    not in the intervals, and falls with their number.

    Parameters
    ----------
    share : ndarray
        Of the motions of a record at a scale, those that exceed the threshold, (record, scale); NaN if there are none.
    pga : ndarray
        Peak accelerations over gravity, of the same shape; what has none exceeds nothing, and is not counted.
    threshold : float

    Returns
    -------
    FragilityCurve
        Without numbers, and with the reason, where the likelihood has no maximum, or would have none without one of
        the records.

    References
    ----------
    J. W. Baker, Efficient analytical fragility function fitting using dynamic structural analysis, Earthquake Spectra
    31(1), 2015, pp. 579-599.
    """
    counts = np.isfinite(share) & (pga > 0.0)
    record, _ = np.nonzero(counts)
    shares, log_pga = share[counts], np.log(pga[counts])
    if reason := _not_identified(shares, log_pga, record):
        return FragilityCurve(threshold, reason)
    centre = log_pga.mean()
    width = log_pga.std()
    scaled = (log_pga - centre) / width
    terms = np.stack([np.ones_like(scaled), scaled], axis=1)
    fitted = _most_likely(terms, shares)
    fitted_covariance = _jackknife(terms, shares, record)
    unscale = np.array([[1.0, -centre / width], [0.0, 1.0 / width]])
    coefficients = unscale @ fitted
    covariance = unscale @ fitted_covariance @ unscale.T
    records = np.unique(record).size
    freedom = records - coefficients.size
    quantile = special().stdtrit(freedom, (1.0 + _CONFIDENCE) / 2.0) if records >= _FEWEST_OF_INTERVAL else math.nan
    return _curve(threshold, coefficients, covariance, float(quantile))


def _curve(threshold: float, coefficients: Floats, covariance: Floats, quantile: float) -> FragilityCurve:
    """Return the curve of a and b, with intervals from derivatives of ln median = -a/b and ln dispersion = -ln b."""
    intercept, slope = coefficients.tolist()
    log_median = -intercept / slope
    log_dispersion = -math.log(slope)
    of_median = np.array([-1.0, -log_median]) / slope
    of_dispersion = np.array([0.0, -1.0 / slope])
    median = _lognormal(log_median, of_median, covariance, quantile)
    dispersion = _lognormal(log_dispersion, of_dispersion, covariance, quantile)
    return FragilityCurve(threshold, "", median, dispersion, coefficients, covariance, quantile)


def _not_identified(share: Floats, log_pga: Floats, record: NDArray[np.int64]) -> str:
    """Return the reason for no curve; empty if there is one, and one without each of the records.

    Where one record makes the difference, the dispersion would be small and its interval too narrow.
    """
    if reason := _without_maximum(share, log_pga):
        return reason
    records = np.unique(record)
    if records.size < _FEWEST:
        return f"needs {_FEWEST} records at least"
    for left_out in records:
        others = record != left_out
        if reason := _without_maximum(share[others], log_pga[others]):
            return f"rests on one record, without which {reason}"
    return ""


def _without_maximum(share: Floats, log_pga: Floats) -> str:
    """Return the reason why the likelihood has no maximum at a finite median and dispersion, or nothing.

    It has none where a peak acceleration separates what exceeds from what does not (Albert and Anderson 1984).
    """
    exceeds, stays = share > 0.0, share < 1.0
    if not np.any(exceeds):
        return "no motion exceeds it; give larger scales"
    if not np.any(stays):
        return "every motion exceeds it; give smaller scales"
    if np.ptp(log_pga) <= _SAME:
        return "all motions have one peak acceleration; give several scales"
    off_share = share - share.mean()
    off_pga = log_pga - log_pga.mean()
    if off_share @ off_pga <= 0.0:
        return "it is not exceeded more often at larger peak accelerations"
    lowest = log_pga[exceeds].min()
    highest = log_pga[stays].max()
    if lowest < highest - _SAME:
        return ""
    first = shown(math.exp(lowest))
    last = shown(math.exp(highest))
    if lowest <= highest + _SAME:
        return f"no motion exceeds it below a peak of {first} g and every one above; give scales next to it"
    return f"no motion exceeds it up to a peak of {last} g and every one does from {first} g; give scales between"


def _most_likely(terms: Floats, share: Floats) -> Floats:
    """Return the coefficients of greatest likelihood."""
    from scipy.optimize import minimize

    def negative(coefficients: Floats) -> tuple[float, Floats]:
        likelihood, score, _ = _likelihood(terms @ coefficients, share)
        return -float(likelihood.sum()), -score @ terms

    start = np.array([0.0, 1.0])
    found = minimize(negative, start, jac=True, method="BFGS", options={"gtol": 1e-9})
    return found.x


def _jackknife(terms: Floats, share: Floats, record: NDArray[np.int64]) -> Floats:
    """Return the covariance of the coefficients from fits without each record."""
    without = np.array([_most_likely(terms[record != one], share[record != one]) for one in np.unique(record)])
    count = len(without)
    return (count - 1) ** 2 / count * np.cov(without.T)


def _likelihood(argument: Floats, share: Floats) -> tuple[Floats, Floats, Floats]:
    """Return log-likelihoods of shares at arguments of Phi, their derivatives and negative expected second ones."""
    log_above = special().log_ndtr(argument)
    log_below = special().log_ndtr(-argument)
    log_density = -(argument**2 + math.log(2.0 * math.pi)) / 2.0
    above = np.exp(log_density - log_above)
    below = np.exp(log_density - log_below)
    rest = 1.0 - share
    likelihood = share * log_above + rest * log_below
    score = share * above - rest * below
    return likelihood, score, above * below


def _lognormal(log_value: float, derivative: Floats, covariance: Floats, quantile: float) -> Estimate:
    """Return a positive number and its interval from the standard error of its logarithm."""
    variance = np.maximum(derivative @ covariance @ derivative, 0.0)  # not below it by rounding
    half = quantile * math.sqrt(variance)
    value = math.exp(log_value)
    with np.errstate(over="ignore"):  # to an interval without an end
        factor = float(np.exp(half))
    return Estimate(value, value / factor, value * factor)
