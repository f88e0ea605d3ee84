"""Intensity measures of records, and statistics of displacements, against closed forms and SciPy."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy import optimize, signal, stats

from slipcircle import Series
from slipcircle.base.kinds import Floats
from slipcircle.workbench.studies.fragility import fragility_curve
from slipcircle.workbench.studies.statistics import (
    distribution,
    exceedance_probabilities,
    exceedance_shares,
    variance_shares,
)
from slipcircle.workbench.suites.intensities import intensities, spectral_acceleration
from slipcircle.workbench.suites.regressions import REGRESSIONS, Shaking, comparisons
from slipcircle.workbench.suites.synthetic import synthetic_records


def test_intensities_of_sines_by_their_definitions() -> None:
    """Periods are whole in 20 s; frequencies below 0.25 and above 20 Hz are excluded from the mean period."""
    time = np.linspace(0.0, 20.0, 20_001)
    slow, one, two, fast = np.sin(2.0 * np.pi * np.outer([0.2, 1.0, 2.0, 25.0], time))
    measures = intensities(Series(time, 0.3 * one + 0.1 * two, held=False), 10.0)
    cosine = (math.sqrt(41.0) - 3.0) / 8.0  # where 3 cos x + 2 cos 2x = 0
    peak = (0.3 + 0.2 * cosine) * math.sqrt(1.0 - cosine**2)
    assert measures == pytest.approx((peak, 3.0 / math.pi, 5.0 * math.pi, 18.0, 0.95), rel=1e-4)
    with_others = Series(time, 0.3 * one + 0.1 * (two + slow + fast), held=False)
    assert intensities(with_others).mean_period == pytest.approx(0.95, rel=1e-3)


def test_intensities_of_coarse_straight_lines() -> None:
    """A triangle up and one down: integrals of straight lines, which pass zero between samples; and no shaking."""
    measures = intensities(Series(np.array([0.0, 1.0, 3.0, 4.0]), np.array([0.0, 0.2, -0.2, 0.0]), held=False), 10.0)
    assert (measures.pgv, measures.arias) == pytest.approx((2.0, math.pi / 2.0 * 10.0 * 4.0 * 0.2**2 / 3.0), rel=1e-15)
    assert intensities(Series(np.arange(3.0), np.zeros(3), held=False))[:4] == (0.0, 0.0, 0.0, 0.0)


def test_distribution_and_exceedance_of_lognormal_displacements() -> None:
    """A quarter of 4,000 lognormal displacements is replaced by 0."""
    drawn = stats.lognorm(0.8, scale=0.2).ppf((np.arange(3000) + 0.5) / 3000)
    values = np.concatenate([np.zeros(1000), drawn]).reshape(1000, 4, 1, 1)
    found = distribution(values, 0)
    assert found.moving == 0.75
    assert found.mean == pytest.approx(0.75 * 0.2 * math.exp(0.32), rel=2e-3)
    assert (found.geometric_mean, found.std_ln) == pytest.approx((0.2, 0.8), rel=2e-3)
    quantiles = stats.lognorm(0.8, scale=0.2).ppf([(0.5 - 0.25) / 0.75, (0.84 - 0.25) / 0.75])
    assert (found.p16, found.median, found.p84) == pytest.approx((0.0, *quantiles), rel=1e-2)
    ((estimate,),) = exceedance_probabilities(values, np.array([0.2]))
    interval = stats.binomtest(375, 1000).proportion_ci(0.95, "exact")
    assert estimate == pytest.approx((0.375, interval.low, interval.high), rel=1e-9)


def test_motions_without_a_result_exceed_every_threshold() -> None:
    values = np.array([0.0, 0.1, np.inf, np.nan]).reshape(4, 1, 1, 1)
    ((estimate,),) = exceedance_probabilities(values, np.array([50.0]))
    assert estimate.value == pytest.approx(1 / 3)
    assert math.isinf(distribution(values, 0).mean)
    assert math.isnan(variance_shares(values, 0).records)


def test_a_fragility_curve_has_the_greatest_likelihood() -> None:
    """Derivatives of the likelihood of a known fragility, with correlated polarities, are zero at the estimate.

    Standard errors are those of fits without each of the records.
    """
    rng = np.random.default_rng(3)
    common, each = rng.normal(size=(60, 1)), rng.normal(size=(60, 2))
    capacity = 0.3 * np.exp(0.4 * (math.sqrt(0.6) * common + math.sqrt(0.4) * each))
    pga = 0.3 * np.exp(0.2 * rng.normal(size=(60, 1))) * np.linspace(0.5, 2.0, 5)
    share = exceedance_shares(np.where(pga[:, None] > capacity[:, :, None], 0.2, 0.1)[..., None], 0.1)

    curve = fragility_curve(share, pga, 0.1)
    value, low, high = np.transpose([curve.median, curve.dispersion])

    def slopes(logs: Floats, records: Any) -> Floats:
        """Return derivatives of the likelihood of some records with respect to log median and log dispersion."""
        log_pga = (np.log(pga[records]) - logs[0]) / np.exp(logs[1])
        likely = stats.norm.cdf(log_pga)
        of_log_pga = stats.norm.pdf(log_pga) * (share[records] - likely) / (likely * (1.0 - likely))
        return np.array([of_log_pga.sum(), (of_log_pga * log_pga).sum()])

    assert slopes(np.log(value), slice(None)) == pytest.approx([0.0, 0.0], abs=1e-6)
    without = [optimize.root(slopes, np.log(value), np.arange(60) != r, tol=1e-9).x for r in range(60)]
    errors = np.sqrt(59.0 * np.var(without, axis=0))
    assert np.log(high / low) == pytest.approx(2.0 * stats.t(58).ppf(0.975) * errors, rel=0.03)
    assert np.diag(curve.probability([value[0], high[0], low[0]])) == pytest.approx([0.5] * 3, abs=0.02)


@pytest.mark.parametrize(
    ("share", "reason"),
    [
        ([0.0, 0.0, 0.0], "no motion exceeds it"),
        ([1.0, 1.0, 1.0], "every motion exceeds it"),
        ([0.0, 0.0, 1.0], "up to a peak of 0.2 g and every one does from 0.4 g"),
        ([0.0, 0.5, 1.0], "below a peak of 0.2 g and every one above"),
        ([0.7, 0.5, 0.4], "not exceeded more often at larger peak accelerations"),
    ],
)
def test_a_fragility_that_motions_do_not_identify_has_a_reason_and_no_number(share: list[float], reason: str) -> None:
    shares = np.tile(share, (4, 1))
    rounded = np.array([[1.0 + 3e-16], [1.0], [1.0 - 2e-16], [1.0 + 5e-16]])
    curve = fragility_curve(shares, rounded * np.array([0.1, 0.2, 0.4]), 0.1)
    assert reason in curve.reason
    assert np.all(np.isnan([*curve.median, *curve.dispersion, *curve.probability(0.2)]))


def test_a_fragility_needs_several_records_and_peaks() -> None:
    """Motions except one exceed between 0.1 and 0.2 g; records without a peak acceleration are excluded."""
    shares, pga = np.tile([0.0, 1.0, 1.0], (6, 1)), np.tile([0.1, 0.2, 0.4], (6, 1))
    shares[2, 1] = 0.5
    pga[2] *= 1.1
    pga[5], shares[5] = 0.0, 0.0
    reasons = [fragility_curve(shares, pga, 0.1).reason, fragility_curve(shares, np.full(pga.shape, 0.3), 0.1).reason]
    shares[3], pga[3] = shares[2], pga[2]
    reasons += [fragility_curve(shares[rows], pga[rows], 0.1).reason for rows in (slice(6), slice(2, 5))]
    assert "rests on one record, without which no motion exceeds it up to a peak of 0.1 g and every" in reasons[0]
    assert reasons[1].startswith("all motions have one peak acceleration")
    assert reasons[2:] == ["", "needs 4 records at least"]


def test_shares_of_the_variance_of_a_sum() -> None:
    """D = a_record + b_polarity + c_sample: shares in the ratio of the variances, which add up to one."""
    rng = np.random.default_rng(4)
    parts = rng.normal(size=30), rng.normal(size=2), rng.normal(size=50)
    sums = parts[0][:, None, None] + parts[1][:, None] + parts[2]
    shares = variance_shares(sums[:, :, None], 0)
    variances = np.array([np.var(part) for part in parts])
    assert shares == pytest.approx(variances / variances.sum(), rel=1e-12)


RM, SR_PGV, RS = (
    "Jibson (2007), r and M",
    "Saygili and Rathje (2008), PGA and PGV",
    "Rathje and Saygili (2009), PGA and M",
)


@pytest.mark.parametrize(
    ("name", "k_y", "pga", "pgv", "arias", "magnitude", "low", "high"),
    [
        # At r = 0.5 and 0.3 g, by a calculator from the printed equations
        ("Ambraseys and Menu (1988)", 0.15, 0.3, 0.3, 1.0, 7.0, 2.925, 2.931),
        ("Jibson (2007), I_A and r", 0.15, 0.3, 0.3, 1.0, 7.0, 0.4780, 0.4786),
        ("Jibson (2007), I_A and k_y", 0.15, 0.3, 0.3, 2.0, 7.0, 2.2949, 2.2953),
        ("Saygili and Rathje (2008), PGA", 0.15, 0.3, 0.3, 1.0, 7.0, 2.3861, 2.3909),
        ("Saygili and Rathje (2008), PGA and I_A", 0.15, 0.3, 0.3, 1.0, 7.0, 1.4645, 1.4675),
        ("Saygili and Rathje (2008), PGA, PGV and I_A", 0.15, 0.3, 0.3, 2.0, 7.0, 2.6391, 2.6397),
        # Kramer and Stewart (2nd ed.), example 10.4: 0.18 cm, and ln D = -1.287
        (RM, 0.067, 0.1, math.nan, math.nan, 6.7, 0.175, 0.190),
        (RS, 0.067, 0.1, math.nan, math.nan, 6.7, 0.2759, 0.2763),
        # Rathje and Saygili (2009), figure 7: 2.25 and 2.5 cm
        (RS, 0.2, 0.33, math.nan, math.nan, 7.5, 2.24, 2.26),
        (SR_PGV, 0.15, 0.33, 0.30, math.nan, math.nan, 2.45, 2.55),
        # Jibson (2007), figure 2: 10 cm
        ("Jibson (2007), r", 0.2, 1.0, math.nan, math.nan, math.nan, 9.77, 10.23),
        # Rathje and others (2014): 81 cm, of rounded intensities: within 2 cm
        (SR_PGV, 0.1, 0.88, 0.71, math.nan, 6.75, 79.0, 83.0),
    ],
)
def test_regressions_of_rigid_blocks_reproduce_published_examples(
    name: str, k_y: float, pga: float, pgv: float, arias: float, magnitude: float, low: float, high: float
) -> None:
    (regression,) = (r for r in REGRESSIONS if r.name == name)
    shaking = Shaking(k_y, np.array([pga]), np.array([pgv]), np.array([arias]), magnitude)
    assert low < math.exp(regression.ln_cm(shaking)[0]) < high


def test_standard_deviations_of_regressions() -> None:
    """Deviations are printed constants, or depend on r = k_y/PGA = 0.5; base-10 logarithms are converted."""
    shaking = Shaking(0.15, np.array([0.3]), np.array([0.3]), np.array([2.0]), 7.0)
    printed = [0.3 * 2.302585, 0.510 * 2.302585, 0.454 * 2.302585, 0.616 * 2.302585, 0.656 * 2.302585, 1.13,
               0.41 + 0.52 / 2, 0.46 + 0.56 / 2, 0.20 + 0.79 / 2, 0.732 + 0.789 / 2 - 0.539 / 4, 0.66]  # fmt: skip
    assert sorted(r.std_ln(shaking)[0] for r in REGRESSIONS) == pytest.approx(sorted(printed), rel=1e-6)


@pytest.mark.parametrize(
    ("k_y", "period", "spectral", "magnitude", "none", "centimetres", "error"),
    [
        (0.14, 0.4, 0.48, 7.2, 0.01, 9.9, 0.01),  # Bray (2007), worked example: ln D = 2.29, P(D = 0) = 0.01
        # Bray and Travasarou (2007), table 1, a rigid dam in the earthquake of Loma Prieta: 16 to 84 % from 4 to 15 cm
        (0.08, 0.0, 0.24, 6.9, 0.1, math.sqrt(60.0), 0.15),
        (0.14, 0.33, 1.07, 6.9, 0.0, math.exp(3.77), 0.005),  # their example of a dam: ln D = 3.77
    ],
)
def test_bray_and_travasarou_reproduce_their_examples(
    k_y: float, period: float, spectral: float, magnitude: float, none: float, centimetres: float, error: float
) -> None:
    response = np.array([spectral])
    shaking = Shaking(k_y, response, response, response, magnitude, period, response)
    assert REGRESSIONS[-1].negligible(shaking)[0] == pytest.approx(none, abs=0.02)
    assert math.exp(REGRESSIONS[-1].ln_cm(shaking)[0]) == pytest.approx(centimetres, rel=error)


def test_regressions_say_nothing_outside_their_range_or_without_a_magnitude() -> None:
    pga, displacement = np.array([0.2, 0.3, 0.099, 5.0]), np.array([0.01, 0.02, 0.03, 0.04])
    shaking = Shaking(0.1, pga, pga, pga)
    compared = comparisons(displacement, shaking)
    assert [c.records for c in compared] == [2] + [3] * 7
    residuals = np.log(100.0 * displacement[:2]) - REGRESSIONS[0].ln_cm(shaking)[:2]
    expected = residuals.mean(), residuals.std(ddof=1), 0.3 * math.log(10.0)
    assert (compared[0].mean, compared[0].std, compared[0].std_ln) == pytest.approx(expected, rel=1e-12)
    outside = comparisons(displacement, Shaking(0.6, pga, pga, pga, 9.5))
    assert [(c.records, math.isnan(c.mean)) for c in outside] == [(0, True)] * len(REGRESSIONS)


def test_what_moves_less_than_a_centimetre_counts_as_no_displacement() -> None:
    """Bray and Travasarou (2007) predict the share of records without a displacement, and others' displacement."""
    pga, displacement = np.full(4, 0.3), np.array([0.009, 0.0, 0.08, 0.09])
    shaking = Shaking(0.1, pga, pga, pga, 7.0)
    rigid = replace(shaking, period=0.049, spectral=9.0 * pga)
    compared, as_rigid = (comparisons(displacement, each)[-1] for each in (shaking, rigid))
    assert compared == as_rigid
    assert (compared.records, compared.negligible_computed) == (2, 0.5)
    flexible = comparisons(displacement, replace(shaking, period=0.5, spectral=pga))[-1]
    # 1 - Phi(-1.76 + 7.4143 - 4.2380), and with 0.5572 of the period
    assert (compared.negligible, flexible.negligible) == pytest.approx((0.0783, 0.0242), abs=1e-4)


@pytest.mark.parametrize("period", [0.08, 0.5, 3.0])
def test_a_response_is_that_of_the_oscillator_s_equation(period: float) -> None:
    """Responses solve u'' + 2 zeta omega u' + omega^2 u = -a, by SciPy's linear simulation between all samples."""
    record = Series(np.linspace(0.0, 1.95, 40), np.random.default_rng(8).normal(size=40))
    frequency = 2.0 * math.pi / period
    times = np.linspace(0.0, record.time[-1] + 1.5 * period, 20_001)
    ground = np.interp(times, record.time, record.values, right=0.0)
    _, response, _ = signal.lsim(([-1.0], [1.0, 2 * 0.05 * frequency, frequency**2]), ground, times)
    assert spectral_acceleration(record, period) == pytest.approx(frequency**2 * np.abs(response).max(), rel=2e-3)


def test_synthetic_records_have_the_intensity_and_duration_asked_for() -> None:
    records = synthetic_records(24, 2.0, 8.0, seed=3)
    measures = [intensities(record) for record in records.values()]
    assert [m.arias for m in measures] == pytest.approx([2.0] * 24, rel=1e-12)
    assert np.mean([m.duration for m in measures]) == pytest.approx(8.0, rel=0.05)
    assert all(0.2 < m.mean_period < 0.8 for m in measures)
    first = records["synthetic 1"].values
    assert np.array_equal(synthetic_records(1, 2.0, 8.0, seed=3)["synthetic 1"].values, first)
    assert not np.array_equal(synthetic_records(1, 2.0, 8.0)["synthetic 1"].values, first)
    refused = "arias = -1: must be a positive number in m/s\nsynthetic records: duration = 2000: must be a time in s"
    with pytest.raises(ValueError, match=refused):
        synthetic_records(2, -1.0, 2000.0, -3)
