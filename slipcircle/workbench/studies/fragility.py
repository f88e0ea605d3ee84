"""Lognormal fragility curves: the probability that the displacement exceeds a threshold, by the peak acceleration.

Records are clusters: polarities, scales and samples of one record are not independent draws.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from slipcircle.base.kinds import ArrayPair, Floats, Integers, ValueDict
from slipcircle.base.text import number_text
from slipcircle.workbench.common.distributions import special
from slipcircle.workbench.studies.statistics import NOT_GIVEN, Estimate

_CONFIDENCE = 0.95  # of intervals
_FEWEST = 4  # records of a curve
_FEWEST_OF_INTERVAL = 12  # of an interval that covers the true value as often as it should
_SAME = 1e-9  # relative difference of equal peak accelerations, which scaling rounds
_UNKNOWN = np.full((2, 2), np.nan)


def interval_note(records: int) -> str:
    """Return a note on whether fragility curves from this number of records have intervals."""
    if records >= _FEWEST_OF_INTERVAL:
        return "95 % intervals of records as independent draws"
    return f"no intervals: {records} records, fewer than {_FEWEST_OF_INTERVAL}"


class FragilityCurve(NamedTuple):
    """Lognormal fragility curve: the probability Phi(ln(PGA/median)/dispersion) of exceeding a displacement.

    Attributes
    ----------
    threshold : float
        Threshold of the displacement, m.
    reason : str
        Reason for a missing curve; otherwise empty.
    median, dispersion : Estimate
        Peak acceleration over gravity at which the probability is one half, and standard deviation of the logarithm of
        the peak acceleration at which a motion exceeds the threshold; NaN where the motions do not identify them.
    coefficients, covariance : ndarray
        a and b of Phi(a + b ln PGA), and their covariance.
    quantile : float
        Quantile of Student's distribution: half the width of an interval in standard errors.
    """

    threshold: float
    reason: str = ""
    median: Estimate = NOT_GIVEN
    dispersion: Estimate = NOT_GIVEN
    coefficients: Floats = _UNKNOWN[0]
    covariance: Floats = _UNKNOWN
    quantile: float = math.nan

    def probability(self, pga: ArrayLike) -> Floats:
        """Return probabilities of exceedance and their intervals at peak accelerations over gravity, (3, ...)."""
        log_pga = np.log(np.asarray(pga, float))
        intercept, slope = self.coefficients
        (of_intercept, joint), (_, of_slope) = self.covariance
        middle = intercept + slope * log_pga
        variance = of_intercept + 2.0 * joint * log_pga + of_slope * log_pga**2
        half = self.quantile * np.sqrt(np.maximum(variance, 0.0))
        return np.asarray(special().ndtr(np.stack([middle, middle - half, middle + half])))

    def to_dict(self) -> ValueDict:
        """Return the curve as a mapping for JSON."""
        fitted = {"median_pga_g": self.median._asdict(), "dispersion": self.dispersion._asdict()}
        return {"threshold_m": self.threshold} | fitted | {"reason": self.reason}


def fragility_curve(share: Floats, pga: Floats, threshold: float) -> FragilityCurve:
    """Return the lognormal fragility curve of greatest likelihood for a threshold of the displacement.

    The likelihood of Baker (2015) is used for motions by record and scale. At one scale the records may have the same
    peak acceleration (stripes) or different ones (a cloud). In terms of a and b of Phi(a + b ln PGA), with
    b = 1/dispersion and a = -b ln median, its logarithm is concave.

    Both polarities of a record and all samples are pooled into one share of exceedance, and all scales of a record are
    one draw. Pooling does not bias the curve, but intervals for independent motions would be too short. The intervals
    are therefore from a jackknife over records, with Student's distribution and two degrees of freedom fewer than
    records. For fewer than 12 records intervals are not given. `python -m tests.campaigns.coverage` measures how often
    they contain the true values. Samples of the soil are the same for every record; their error is not in the
    intervals, and decreases with their number.

    Parameters
    ----------
    share : ndarray
        Share of the motions of a record at a scale that exceed the threshold, (record, scale); NaN without motions.
    pga : ndarray
        Peak accelerations over gravity, of the same shape; records with a zero peak are left out.
    threshold : float
        Displacement, m.

    Returns
    -------
    FragilityCurve
        Fitted curve. If the likelihood does not have a maximum, or would not without one of the records, its values
        are NaN and ``reason`` is set.

    References
    ----------
    J. W. Baker, Efficient analytical fragility function fitting using dynamic structural analysis, Earthquake Spectra
    31(1), 2015, pp. 579-599.
    """
    counts = np.isfinite(share) & (pga > 0.0)
    record, _ = np.nonzero(counts)
    shares = share[counts]
    log_pga = np.log(pga[counts])
    if reason := _not_identified(shares, log_pga, record):
        return FragilityCurve(threshold, reason)
    centre = log_pga.mean()
    width = log_pga.std()
    scaled = (log_pga - centre) / width
    terms = np.stack([np.ones_like(scaled), scaled], axis=1)
    fitted = _most_likely(terms, shares)
    # The covariance of the coefficients from fits that leave out one record each.
    without = np.array([_most_likely(terms[record != one], shares[record != one]) for one in np.unique(record)])
    count = len(without)
    fitted_covariance = (count - 1) ** 2 / count * np.cov(without.T)
    unscale = np.array([[1.0, -centre / width], [0.0, 1.0 / width]])
    coefficients = unscale @ fitted
    covariance = unscale @ fitted_covariance @ unscale.T
    records = np.unique(record).size
    freedom = records - coefficients.size
    quantile = special().stdtrit(freedom, (1.0 + _CONFIDENCE) / 2.0) if records >= _FEWEST_OF_INTERVAL else math.nan
    return _curve(threshold, coefficients, covariance, float(quantile))


def _curve(threshold: float, coefficients: Floats, covariance: Floats, quantile: float) -> FragilityCurve:
    """Return the curve with coefficients a and b, with intervals for ln median = -a/b and ln dispersion = -ln b.

    The covariance is that of a and b, (2, 2), and ``quantile`` is half an interval over its standard error.
    """
    intercept, slope = coefficients.tolist()
    log_median = -intercept / slope
    log_dispersion = -math.log(slope)
    of_median = np.array([-1.0, -log_median]) / slope
    of_dispersion = np.array([0.0, -1.0 / slope])
    median = _lognormal(log_median, of_median, covariance, quantile)
    dispersion = _lognormal(log_dispersion, of_dispersion, covariance, quantile)
    return FragilityCurve(threshold, "", median, dispersion, coefficients, covariance, quantile)


def _not_identified(share: Floats, log_pga: Floats, record: Integers) -> str:
    """Return the reason why the motions do not identify a curve, also without each of the records; else empty.

    The arrays have the share of exceedance, ln PGA (over gravity) and index of the record of each point of the curve.
    If a curve depends on one record alone, its dispersion would be small and the interval too narrow.
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
    """Return the reason why the likelihood lacks a maximum at finite median and dispersion; else empty.

    The arrays have the share of exceedance and ln PGA (over gravity) of each point.

    This happens if a peak acceleration separates motions that exceed the threshold from the other motions (Albert and
    Anderson 1984).
    """
    exceeds = share > 0.0
    stays = share < 1.0
    if not np.any(exceeds):
        return "no motion exceeds it; give larger scales"
    if not np.any(stays):
        return "every motion exceeds it; give smaller scales"
    if np.ptp(log_pga) <= _SAME:
        return "all motions have one peak acceleration; give several scales"
    if (share - share.mean()) @ (log_pga - log_pga.mean()) <= 0.0:
        return "it is not exceeded more often at larger peak accelerations"
    lowest = log_pga[exceeds].min()
    highest = log_pga[stays].max()
    if lowest < highest - _SAME:
        return ""
    first = number_text(math.exp(lowest))
    last = number_text(math.exp(highest))
    if lowest <= highest + _SAME:
        return f"no motion exceeds it below a peak of {first} g and every one above; give scales next to it"
    return f"no motion exceeds it up to a peak of {last} g and every one does from {first} g; give scales between"


def _most_likely(terms: Floats, share: Floats) -> Floats:
    """Return the coefficients of greatest likelihood, (2,), for terms (points, 2) and shares of exceedance."""
    from scipy.optimize import minimize

    def negative(coefficients: Floats) -> tuple[float, Floats]:
        likelihood, score = _likelihood(terms @ coefficients, share)
        return -float(likelihood.sum()), -score @ terms

    return minimize(negative, np.array([0.0, 1.0]), jac=True, method="BFGS", options={"gtol": 1e-9}).x


def _likelihood(argument: Floats, share: Floats) -> ArrayPair:
    """Return log-likelihoods of shares of exceedance at arguments of Phi, and their derivatives, all (points,)."""
    log_above = special().log_ndtr(argument)
    log_below = special().log_ndtr(-argument)
    log_density = -(argument**2 + math.log(2.0 * math.pi)) / 2.0
    above = np.exp(log_density - log_above)
    below = np.exp(log_density - log_below)
    rest = 1.0 - share
    return share * log_above + rest * log_below, share * above - rest * below


def _lognormal(log_value: float, derivative: Floats, covariance: Floats, quantile: float) -> Estimate:
    """Return a positive value and its interval from the standard error of its logarithm.

    ``derivative`` is the gradient of the logarithm by the coefficients, (2,), ``covariance`` theirs, and ``quantile``
    half the interval in standard errors.
    """
    half = quantile * math.sqrt(np.maximum(derivative @ covariance @ derivative, 0.0))  # not below it by rounding
    value = math.exp(log_value)
    with np.errstate(over="ignore"):  # to an interval without an end
        factor = float(np.exp(half))
    return Estimate(value, value / factor, value * factor)
