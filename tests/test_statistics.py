"""Distributions, points and estimates of ensembles, against SciPy and closed forms."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy import stats

from slipcircle import ensemble, load
from slipcircle.workbench.common.distributions import DISTRIBUTIONS, distribution_of, distribution_record
from slipcircle.workbench.files.numbers import Uncertain, number_in
from slipcircle.workbench.studies.sampling import monte_carlo, sobol
from slipcircle.workbench.studies.statistics import Ordered, proportion, ranks, sensitivity_indices, sums
from tests.campaigns import coverage

_LOG = math.log1p(0.3**2)

SCIPY: list[tuple[str, dict[str, float], Any]] = [
    ("normal", {"mean": 10.0, "std": 2.0}, stats.norm(10, 2)),
    ("lognormal", {"mean": 5.0, "std": 1.5}, stats.lognorm(math.sqrt(_LOG), scale=5 / math.exp(_LOG / 2))),
    ("uniform", {"low": -1.0, "high": 3.0}, stats.uniform(-1, 4)),
    ("triangular", {"low": 1.0, "mode": 2.0, "high": 5.0}, stats.triang(0.25, 1, 4)),
    ("triangular", {"low": 1.0, "mode": 1.0, "high": 5.0}, stats.triang(0.0, 1, 4)),
    ("truncated_normal", {"mean": 0.0, "std": 1.0, "low": 9.0, "high": 12.0}, stats.truncnorm(9, 12)),
    ("truncated_normal", {"mean": 3.0, "std": 2.0, "low": -22.0, "high": -19.0}, stats.truncnorm(-12.5, -11, 3, 2)),
]


@pytest.mark.parametrize(("name", "given", "wanted"), SCIPY, ids=lambda x: x if isinstance(x, str) else "")
def test_quantiles_are_scipys(name: str, given: dict[str, float], wanted: Any) -> None:
    p = np.concatenate([[1e-12, 1e-6], np.linspace(0.001, 0.999, 97), [1 - 1e-6]])
    found = distribution_of({"distribution": name} | given)
    quantiles = wanted.ppf(p)
    np.testing.assert_allclose(found.ppf(p), quantiles, rtol=1e-9)
    assert [found.cdf(x) for x in quantiles.tolist()] == pytest.approx(p.tolist(), rel=1e-9, abs=1e-13)
    assert [found.cdf(x) for x in (-30.0, 30.0)] == pytest.approx([wanted.cdf(x) for x in (-30.0, 30.0)])
    assert found.support() == wanted.support()
    number = number_in(load("vaiont"), "friction.angle_deg")
    assert Uncertain(number, {"distribution": name} | given).moments == pytest.approx(
        (wanted.mean(), wanted.std()), rel=1e-9, abs=1e-12
    )
    assert {n for n, _, _ in SCIPY} == set(DISTRIBUTIONS)


def test_distributions_are_described() -> None:
    """Distributions are described by SciPy's expression, or by moments and quantiles."""
    assert distribution_record(stats.gamma(a=2, scale=3)) == {"distribution": "scipy.stats.gamma(a=2.0, scale=3.0)"}
    histogram = stats.rv_histogram((np.array([5, 5]), np.array([1.0, 2.0, 3.0])))
    for given in (histogram, histogram()):
        found = distribution_record(given)
        assert found.pop("distribution") == "rv_histogram"
        assert (found["mean"], found["std"]) == pytest.approx((2.0, math.sqrt(4.0 / 12.0)))
        assert {p: found[f"quantile_{p}"] for p in (0.05, 0.5, 0.99)} == pytest.approx(
            {0.05: 1.1, 0.5: 2.0, 0.99: 2.98}
        )


@pytest.mark.parametrize("given", [stats.norm([10.0, 11.0], 1.0), stats.norm(math.nan, 1.0)])
def test_a_distribution_of_several_numbers_or_of_none_is_refused(given: Any) -> None:
    scene = replace(load("vaiont"), uncertain={"friction.angle_deg": given})
    with pytest.raises(ValueError, match=r"has the median .*: must be the distribution of one number"):
        ensemble(scene, 2, 1)


def test_sobol_points_are_scipys() -> None:
    """Any stretch is that of the whole sequence."""
    seed = np.random.SeedSequence(5, spawn_key=(1, 2))
    scipys = stats.qmc.Sobol(3, rng=np.random.default_rng(seed)).random(4096).T
    for start, count in ((0, 4096), (512, 512), (1024, 1000), (7, 1), (0, 1)):
        np.testing.assert_array_equal(sobol(5, (1, 2), start, count, 3), scipys[:, start : start + count])


def test_proportion_and_ranks_cover() -> None:
    """SciPy's exact interval; ranks from the binomial distribution itself."""
    for hits, n in ((0, 50), (3, 50), (50, 50), (499_000, 1_000_000)):
        wanted = stats.binomtest(hits, n).proportion_ci(0.95)
        assert proportion(hits, n, 0.95) == pytest.approx((wanted.low, wanted.high), abs=1e-12)
    for p, n in ((0.95, 1000), (0.3, 10**8), (0.5, 3), (1e-4, 50)):
        low, high = ranks(p, n, 0.95)
        below = stats.binom(n, p)
        assert below.cdf(low - 1) < 0.025 <= below.cdf(low)
        assert high == n + 1 or below.cdf(high - 2) < 0.975 <= below.cdf(high - 1)


@pytest.mark.parametrize("replicates", [1, 16])
def test_quantiles_and_moments_are_numpys_and_scipys(replicates: int) -> None:
    """Exactly, whatever rounding does to the share; infinite values lie above every other, and have no moments."""
    rng = np.random.default_rng(2)
    sample = rng.gamma(2.0, 3.0, 4801)
    ordered = Ordered([*np.array_split(sample, replicates), np.empty(0)])
    for p in [*rng.uniform(size=200), *np.linspace(0.0, 1.0, 101)]:
        value, low, high = ordered.quantile(p, 0.95)
        assert value == np.quantile(sample, p, method="inverted_cdf")
        assert value == stats.quantile(sample, p, method="inverted_cdf")
        assert not low > value
        assert not high < value
    mean, error, std, _ = ordered.spread()
    assert (mean, std) == pytest.approx((sample.mean(), sample.std(ddof=1)), rel=1e-13)
    parts = [part.mean() for part in np.array_split(sample, replicates)]
    assert error == pytest.approx(stats.sem(parts if replicates > 1 else sample), rel=1e-12)
    beyond = Ordered([np.append(sample, np.inf)])
    assert beyond.spread() == Ordered([sample]).spread()
    assert (beyond.at_share(1.0), beyond.at_share(1.0 - 1.0 / 4802)) == (np.inf, sample.max())


WEIGHTS = np.array([[0.0], [1.0], [9.0]])


def product(u: Any) -> Any:
    """Return the g-function: of three numbers that matter ever less, and together more than alone."""
    return np.prod((np.abs(4 * u - 2) + WEIGHTS) / (1 + WEIGHTS), axis=0)


def batches(seed: int) -> Any:
    sets = []
    for k in range(32):
        a, b = monte_carlo(seed, (2, k), 0, 100, 6).reshape(2, 3, 100)
        mixed = [np.where((np.arange(3) == i)[:, None], b, a) for i in range(3)]
        sets.append(sums(np.stack([product(x) for x in (a, b, *mixed)])))
    return np.stack(sets)


def test_indices_and_their_intervals() -> None:
    """Sobol indices that are known in closed form (Saltelli and Sobol 1995), fifty times over."""
    alone = 1 / (3 * (1 + WEIGHTS.ravel()) ** 2)
    whole = np.prod(1 + alone)
    exact = np.concatenate([alone, alone * whole / (1 + alone)]) / (whole - 1)
    inside = []
    for seed in range(50):
        value, low, high = np.transpose([e for part in sensitivity_indices(batches(seed), 0.95) for e in part])
        assert value == pytest.approx(exact, abs=0.15)
        inside.append((low <= exact) & (exact <= high))
    assert 0.91 < np.mean(inside) < 0.98


@pytest.mark.parametrize("part", ["samples", "indices", "suites"])
def test_the_campaign_of_coverage(part: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """A sample of it: with so few repetitions far from the true value only a faulty interval is noticed."""
    monkeypatch.setattr(coverage, "SIZES", (100, 256))
    monkeypatch.setattr(coverage, "RECORDS", (12,))
    rows = [row for row in coverage.PARTS[part](12) if row.given]
    assert len(rows) > 5
    assert min(row.coverage for row in rows) > 0.5
