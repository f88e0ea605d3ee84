"""Intensity measures of records, and statistics of displacements, against closed forms and SciPy."""

import math

import numpy as np
import pytest
from scipy import integrate, stats

from slipcircle import Series
from slipcircle.workbench.suites.fragility import fragility_curve
from slipcircle.workbench.suites.intensities import intensities
from slipcircle.workbench.suites.regressions import REGRESSIONS, Shaking, comparisons
from slipcircle.workbench.suites.spectra import misfit, response_spectrum
from slipcircle.workbench.suites.statistics import distribution, exceedance, exceedance_shares, variance_shares
from slipcircle.workbench.suites.synthetic import synthetic_records

GRAVITY = 9.81


def test_intensities_of_a_sine() -> None:
    """A g sin: velocity A g T/pi, Arias intensity pi g A^2 t/4, of which 90 % take 90 % of the time; mean period T."""
    amplitude, period, cycles = 0.3, 0.5, 40
    time = np.linspace(0.0, period * cycles, 40 * cycles * 25 + 1)
    record = Series(time, amplitude * np.sin(2 * np.pi * time / period), held=False)
    measures = intensities(record, GRAVITY)
    assert measures.pga == pytest.approx(amplitude, rel=1e-5)
    assert measures.pgv == pytest.approx(amplitude * GRAVITY * period / math.pi, rel=1e-5)
    assert measures.arias == pytest.approx(math.pi * GRAVITY * amplitude**2 * period * cycles / 4, rel=1e-5)
    assert measures.duration == pytest.approx(0.9 * period * cycles, rel=1e-3)
    assert measures.mean_period == pytest.approx(period, rel=1e-2)


def test_intensities_of_coarse_straight_lines() -> None:
    """A triangle up and one down of other times: the integrals of straight lines, which pass zero between samples."""
    record = Series(np.array([0.0, 1.0, 3.0, 4.0]), np.array([0.0, 0.2, -0.2, 0.0]), held=False)
    measures = intensities(record, 10.0)
    assert measures.pgv == pytest.approx(10.0 * (0.1 + 0.1), rel=1e-15)
    assert measures.arias == pytest.approx(math.pi / 20.0 * 100.0 * (4.0 * 0.2**2 / 3.0), rel=1e-15)
    still = intensities(Series(np.arange(3.0), np.zeros(3), held=False))
    assert still[:4] == (0.0, 0.0, 0.0, 0.0)


def test_distribution_and_exceedance_of_lognormal_displacements() -> None:
    """Of 4,000 lognormal displacements, a quarter of which is 0 instead."""
    drawn = stats.lognorm(0.8, scale=0.2).ppf((np.arange(3000) + 0.5) / 3000)
    values = np.concatenate([np.zeros(1000), drawn]).reshape(1000, 4, 1, 1)
    found = distribution(values, 0)
    assert found.moving == 0.75
    assert found.mean == pytest.approx(0.75 * 0.2 * math.exp(0.32), rel=2e-3)
    assert (found.geometric_mean, found.std_ln) == pytest.approx((0.2, 0.8), rel=2e-3)
    quantiles = stats.lognorm(0.8, scale=0.2).ppf([(0.5 - 0.25) / 0.75, (0.84 - 0.25) / 0.75])
    assert (found.p16, found.median, found.p84) == pytest.approx((0.0, *quantiles), rel=1e-2)
    ((estimate,),) = exceedance(values, np.array([0.2]))
    interval = stats.binomtest(375, 1000).proportion_ci(0.95, "exact")
    assert estimate == pytest.approx((0.375, interval.low, interval.high), rel=1e-9)


def test_motions_without_a_result_exceed_every_threshold() -> None:
    values = np.array([0.0, 0.1, np.inf, np.nan]).reshape(4, 1, 1, 1)
    ((estimate,),) = exceedance(values, np.array([50.0]))
    assert estimate.value == pytest.approx(1 / 3)
    assert math.isinf(distribution(values, 0).mean)
    assert math.isnan(variance_shares(values, 0).records)


def test_a_fragility_curve_has_the_greatest_likelihood_of_a_grid() -> None:
    """Of a known fragility, with two polarities of a record that correlate: the likelihood itself, on a fine grid."""
    rng = np.random.default_rng(3)
    common, each = rng.normal(size=(60, 1)), rng.normal(size=(60, 2))
    capacity = 0.3 * np.exp(0.4 * (math.sqrt(0.6) * common + math.sqrt(0.4) * each))
    pga = 0.3 * np.exp(0.2 * rng.normal(size=(60, 1))) * np.linspace(0.5, 2.0, 5)
    displacement = np.where(pga[:, None] > capacity[:, :, None], 0.2, 0.0)[..., None]
    share = exceedance_shares(displacement, 0.1)
    curve = fragility_curve(share, pga, 0.1)
    medians, dispersions = np.linspace(0.25, 0.35, 51), np.linspace(0.3, 0.5, 51)
    argument = np.log(pga[:, :, None, None] / medians[:, None]) / dispersions
    above, below = stats.norm.logcdf(argument), stats.norm.logcdf(-argument)
    likelihood = np.einsum("rs,rsmd->md", share, above) + np.einsum("rs,rsmd->md", 1.0 - share, below)
    m, d = np.unravel_index(np.argmax(likelihood), likelihood.shape)
    assert (curve.median.value, curve.dispersion.value) == pytest.approx((medians[m], dispersions[d]), abs=2.1e-3)
    assert curve.median.low < 0.3 < curve.median.high
    assert curve.dispersion.low < 0.4 < curve.dispersion.high


def test_a_fragility_curve_of_two_levels_by_hand_and_by_leaving_out_each_record() -> None:
    """Two shares lie on the curve: z = (ln PGA - ln median)/dispersion at both. Standard errors by the jackknife."""
    rng = np.random.default_rng(5)
    drawn = np.sort(rng.choice([0.0, 0.5, 1.0], (60, 2), p=[0.4, 0.2, 0.4]), axis=1)
    levels = np.array([0.2, 0.4])

    def logarithms(share: np.ndarray) -> np.ndarray:
        low, high = stats.norm.ppf(share.mean(axis=0))
        dispersion = math.log(2.0) / (high - low)
        return np.array([math.log(0.2) - low * dispersion, math.log(dispersion)])

    curve = fragility_curve(drawn, np.broadcast_to(levels, drawn.shape), 1.0)
    values = np.log([curve.median.value, curve.dispersion.value])
    assert values == pytest.approx(logarithms(drawn), abs=1e-7)
    assert curve.probability(levels)[0] == pytest.approx(drawn.mean(axis=0), abs=1e-7)
    without = np.array([logarithms(np.delete(drawn, r, axis=0)) for r in range(60)])
    errors = np.sqrt(59.0 * without.var(axis=0))
    widths = np.log([curve.median.high / curve.median.low, curve.dispersion.high / curve.dispersion.low])
    assert widths == pytest.approx(2.0 * stats.t(58).ppf(0.975) * errors, rel=0.03)
    low, high = curve.probability(levels)[1:]
    assert np.all((low < drawn.mean(axis=0)) & (drawn.mean(axis=0) < high))


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
    numbers = [*curve.median, *curve.dispersion, *curve.probability(0.2)]
    assert np.all(np.isnan(numbers))
    one = fragility_curve(shares + 0.1 * (1.0 - shares), np.full(shares.shape, 0.3), 0.1)
    assert one.reason.startswith(("all motions have one peak acceleration", "every motion exceeds it"))


def test_a_fragility_that_rests_on_one_record_has_no_number() -> None:
    """All exceed between 0.1 and 0.2 g, but for one motion; what has no peak acceleration does not count."""
    shares, pga = np.tile([0.0, 1.0, 1.0], (6, 1)), np.tile([0.1, 0.2, 0.4], (6, 1))
    shares[2, 1] = 0.5
    pga[2] *= 1.1
    pga[5], shares[5] = 0.0, 0.0
    curve = fragility_curve(shares, pga, 0.1)
    assert "rests on one record, without which no motion exceeds it up to a peak of 0.1 g and every" in curve.reason
    shares[3], pga[3] = shares[2], pga[2]
    assert fragility_curve(shares, pga, 0.1).reason == ""
    assert fragility_curve(shares[2:5], pga[2:5], 0.1).reason == "needs 4 records at least"


def test_shares_of_the_variance_of_a_sum() -> None:
    """D = a_record + b_polarity + c_sample: shares in the ratio of the variances, which add up to one."""
    rng = np.random.default_rng(4)
    parts = rng.normal(size=30), rng.normal(size=2), rng.normal(size=50)
    sums = parts[0][:, None, None] + parts[1][:, None] + parts[2]
    shares = variance_shares(sums[:, :, None], 0)
    variances = np.array([np.var(part) for part in parts])
    assert shares == pytest.approx(variances / variances.sum(), rel=1e-12)


def test_regressions_by_hand() -> None:
    """D in cm at r = 0.5, PGA 0.3 g, PGV 0.3 m/s, Arias intensity 1 m/s, magnitude 7, with a pocket calculator."""
    shaking = Shaking(0.15, np.array([0.3]), np.array([0.3]), np.array([1.0]), 7.0)
    found = {regression.name.split()[0]: math.exp(regression.ln_cm(shaking)[0]) for regression in REGRESSIONS[::-1]}
    assert found["Ambraseys"] == pytest.approx(2.928, rel=1e-3)
    assert found["Jibson"] == pytest.approx(0.877, rel=1e-3)
    assert found["Saygili"] == pytest.approx(1.954, rel=1e-3)
    softer = Shaking(0.1, shaking.pga, shaking.pgv, shaking.arias, 7.0)
    assert math.exp(REGRESSIONS[-1].ln_cm(softer)[0]) == pytest.approx(8.05, rel=1e-3)
    assert math.exp(REGRESSIONS[2].ln_cm(shaking)[0]) == pytest.approx(10 ** (-1.474 + 3.833 * 0.30103), rel=1e-5)


def test_regressions_on_magnitude_and_arias_intensity_by_hand() -> None:
    """As above, with an Arias intensity of 2 m/s: D in cm and the standard deviation of ln D."""
    pga, pgv, arias = np.array([[0.3], [0.3], [2.0]])
    shaking = Shaking(0.15, pga, pgv, arias, 7.0)
    expected = {
        "Jibson (2007), r and magnitude": (1.0000, 1.0454),
        "Jibson (2007), Arias intensity and k_y": (2.2951, 1.5105),
        "Saygili and Rathje (2008), PGA, PGV and Arias intensity": (2.6394, 0.595),
        "Rathje and Saygili (2009), PGA and magnitude": (2.9246, 0.99175),
    }
    found = {r.name: (math.exp(r.ln_cm(shaking)[0]), r.std_ln(shaking)[0]) for r in REGRESSIONS}
    for name, values in expected.items():
        assert found[name] == pytest.approx(values, rel=1e-4)


def test_regressions_say_nothing_outside_their_range_or_without_a_magnitude() -> None:
    pga = np.array([0.2, 0.3, 0.101, 5.0])
    shaking = Shaking(0.1, pga, pga, pga)
    found = comparisons(np.array([0.01, 0.02, 0.03, 0.04]), shaking)
    assert [(c.name.split()[0], c.records) for c in found] == [
        ("Ambraseys", 2),
        ("Jibson", 2),
        ("Jibson", 2),
        ("Jibson", 2),
        ("Saygili", 2),
        ("Saygili", 2),
    ]
    menu = REGRESSIONS[0]
    residuals = np.log([1.0, 2.0]) - menu.ln_cm(shaking)[:2]
    assert (found[0].mean, found[0].std) == pytest.approx((residuals.mean(), residuals.std(ddof=1)), rel=1e-12)
    assert found[0].std_ln == pytest.approx(0.3 * math.log(10.0))


def test_response_spectra_are_those_of_oscillators_integrated_as_differential_equations() -> None:
    record = synthetic_records(1, 1.0, 4.0, seed=5)["synthetic 1"]
    periods = np.array([0.1, 0.4, 2.0])
    peaks = []
    for omega in (2.0 * math.pi / periods).tolist():

        def oscillator(time: float, state: np.ndarray, omega: float = omega) -> list[float]:
            return [state[1], float(record(time)) - 0.1 * omega * state[1] - omega**2 * state[0]]

        end = record.time[-1] + 4.0 * math.pi / omega
        found = integrate.solve_ivp(oscillator, (0.0, end), [0.0, 0.0], max_step=0.02, rtol=1e-6, atol=1e-9)
        peaks.append(omega**2 * np.max(np.abs(found.y[0])))
    assert response_spectrum(record, periods) == pytest.approx(peaks, rel=5e-3)


def test_synthetic_records_match_a_target_spectrum() -> None:
    """A plateau and what falls with the period; between the periods of the iteration, too."""
    target = [0.05, 0.15, 0.5, 2.0], [0.5, 0.75, 0.75, 0.19]
    records = synthetic_records(3, duration=6.0, seed=1, spectrum=target)
    periods = np.geomspace(0.06, 1.9, 23)
    expected = np.exp(np.interp(np.log(periods), *np.log(target)))
    for record in records.values():
        assert misfit(record, target) < 0.1
        assert np.std(np.log(response_spectrum(record, periods) / expected)) < 0.15
    assert np.mean([intensities(record).duration for record in records.values()]) == pytest.approx(6.0, rel=0.15)
    assert misfit(synthetic_records(1)["synthetic 1"], target) > 0.3
    with pytest.raises(ValueError, match="arias and spectrum exclude each other"):
        synthetic_records(1, 1.0, spectrum=target)


def test_synthetic_records_have_the_intensity_and_duration_asked_for() -> None:
    records = synthetic_records(24, 2.0, 8.0, seed=3)
    measures = [intensities(record) for record in records.values()]
    assert [m.arias for m in measures] == pytest.approx([2.0] * 24, rel=1e-12)
    assert np.mean([m.duration for m in measures]) == pytest.approx(8.0, rel=0.05)
    periods = np.array([m.mean_period for m in measures])
    assert np.all((periods > 0.2) & (periods < 0.8))
    fewer = synthetic_records(2, 2.0, 8.0, seed=3)
    assert all(np.array_equal(record.values, records[name].values) for name, record in fewer.items())
    assert not np.array_equal(synthetic_records(1, 2.0, 8.0)["synthetic 1"].values, records["synthetic 1"].values)
    with pytest.raises(
        ValueError, match="arias = -1: must be a positive number in m/s; duration = 2000: must be a time in s"
    ):
        synthetic_records(2, -1.0, 2000.0)
