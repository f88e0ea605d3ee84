"""Coverage of every printed 95 % interval: how often it contains the true value.

Run `python -m tests.campaigns.coverage [COUNT]` with the number of repetitions, by default 2,000. Samples are drawn and
counted by the code of ensembles, but their values are functions with known statistics, in place of solved motions. The
exit status is 1 if an interval covers less than 92 % or more than 98 %, exact intervals of counts excepted, which are
never too short and may cover more.
"""

import math
import sys
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np
from scipy import stats

from slipcircle import Arc, Scene, backanalyse, load, solve
from slipcircle.workbench.studies.design import Design
from slipcircle.workbench.studies.fragility import fragility_curve
from slipcircle.workbench.studies.statistics import (
    Ordered,
    exceedance_probabilities,
    exceedance_shares,
    interval_width,
    probability,
    sensitivity_indices,
    sums,
)
from tests.campaigns import options

LOW, HIGH = 0.92, 0.98  # accepted coverage
WEIGHTS = np.array([0.5, 0.4, 0.3])  # of three normal inputs in the logarithm of the output
SCALE = float(np.hypot.reduce(WEIGHTS))
SIZES = (100, 256, 1024, 4096)  # of samples; of base points every second one
RECORDS = (12, 30)
QUANTILES = (0.05, 0.25, 0.5, 0.75, 0.95, 0.99)


class Row(NamedTuple):
    """Coverage of one interval: of so many repetitions the share with an interval, and of these the share covered."""

    interval: str
    sample: str
    given: float
    coverage: float
    exact: bool = False

    @property
    def is_accepted(self) -> bool:
        return self.given == 0.0 or (self.coverage >= LOW and (self.exact or self.coverage <= HIGH))


class Coverage:
    """Count how often intervals contain the true value."""

    def __init__(self, sample: str) -> None:
        self.sample = sample
        self.counts: dict[str, list[int]] = {}

    def add(self, name: str, estimate: Any, true: float) -> None:
        """Count an interval; one without ends is absent, one without one end is open there."""
        _, low, high = estimate
        count = self.counts.setdefault(name, [0, 0, 0])
        count[0] += 1
        if not (math.isnan(low) and math.isnan(high)):
            count[1] += 1
            count[2] += not (true < low or true > high)

    def rows(self, exact: bool = False) -> Iterator[Row]:
        """Yield the results."""
        for name, (count, given, covered) in self.counts.items():
            yield Row(name, self.sample, given / count, covered / max(given, 1), exact)


def design(method: str, n: int, base: int, seed: int) -> Design:
    """Draw samples or base points of an ensemble; the scene is not solved."""
    scene = Scene(Arc(100.0, 4.0, 4.8, 20e3), 0.1)
    return Design(scene, 1e-9, {}, {}, (), method, n, base, np.eye(0), seed, 4096)


def lognormal(points: Any) -> Any:
    """Lognormal by three inputs."""
    return np.exp(WEIGHTS @ stats.norm.ppf(points))


def of_samples(count: int) -> Iterator[Row]:
    """Quantiles, probabilities of exceedance, and the mean of lognormal outputs."""
    mean = math.exp(SCALE**2 / 2)
    at = np.exp(SCALE * stats.norm.ppf(QUANTILES))
    for method in ("monte-carlo", "sobol"):
        for n in SIZES:
            counts, moments = (Coverage(f"{method}, {n} samples") for _ in range(2))
            for seed in range(count):
                drawn = design(method, n, 0, seed)
                values = [lognormal(drawn.points(block, 3)) for block in range(drawn.sample_blocks)]
                in_order = Ordered(values)
                for p, true in zip(QUANTILES, at, strict=True):
                    counts.add(f"quantile {p}", in_order.quantile(p, 0.95), true)
                hits = np.array([np.sum(output[:, None] > at, axis=0) for output in values])
                shares = zip(QUANTILES, *probability(hits, np.array([*map(len, values)]), 0.95), strict=True)
                for p, *estimate in shares:
                    if method == "monte-carlo" or 0 < estimate[0] < 1:
                        counts.add(f"probability {1 - p:.2f}", estimate, 1 - p)
                value, error, *_ = in_order.spread()
                half = error * interval_width(0.95, drawn.replicates)
                moments.add("mean", (value, value - half, value + half), mean)
            yield from counts.rows(method == "monte-carlo")
            yield from moments.rows()


def of_indices(count: int) -> Iterator[Row]:
    """Sensitivity indices of the g-function (Saltelli and Sobol 1995)."""
    weights = np.array([[0.0], [1.0], [9.0]])
    alone = 1 / (3 * (1 + weights.ravel()) ** 2)
    whole = np.prod(1 + alone)
    first, total = alone / (whole - 1), alone * whole / (1 + alone) / (whole - 1)
    for method in ("monte-carlo", "sobol"):
        for base in SIZES[1::2]:
            coverage = Coverage(f"{method}, {base} base points")
            for seed in range(count):
                drawn = design(method, 1, base, seed)
                batches = []
                for index in range(drawn.sample_blocks, drawn.blocks):
                    a, b = drawn.points(index, 6).reshape(2, 3, -1)
                    mixed = [np.where((np.arange(3) == i)[:, None], b, a) for i in range(3)]
                    outputs = [np.prod((np.abs(4 * u - 2) + weights) / (1 + weights), axis=0) for u in (a, b, *mixed)]
                    batches.append(sums(np.stack(outputs)))
                found = sensitivity_indices(np.stack(batches), 0.95)
                for k in range(3):
                    coverage.add(f"first-order index {first[k]:.2f}", found.first[k], first[k])
                    coverage.add(f"total index {total[k]:.2f}", found.total[k], total[k])
            yield from coverage.rows()


def of_suites(count: int) -> Iterator[Row]:
    """Fragility and shares of exceedance of records whose polarities correlate."""
    median, dispersion, scales = 0.3, 0.4, np.linspace(0.5, 2.0, 5)
    for records in RECORDS:
        for polarities in (1, 2):
            coverage, shares = (Coverage(f"{records} records, polarities: {polarities}") for _ in range(2))
            for seed in range(count):
                rng = np.random.default_rng([seed, records])
                common, each = rng.normal(size=(records, 1)), rng.normal(size=(records, polarities))
                capacity = median * np.exp(dispersion * (math.sqrt(0.6) * common + math.sqrt(0.4) * each))
                pga = median * np.exp(0.2 * rng.normal(size=(records, 1))) * scales
                displacement = np.where(pga[:, None] > capacity[:, :, None], 0.2, 0.05)[..., None]
                curve = fragility_curve(exceedance_shares(displacement, 0.1), pga, 0.1)
                coverage.add("fragility, median", curve.median, median)
                coverage.add("fragility, dispersion", curve.dispersion, dispersion)
                for at in (0.15, 0.3, 0.5):
                    likely = stats.norm.cdf(math.log(at / median) / dispersion)
                    coverage.add(f"fragility, probability at {at} g", curve.probability(at), likely)
                both = math.hypot(0.2, dispersion)
                estimates = exceedance_probabilities(displacement, np.array([0.1]))
                for k in (1, 2):
                    likely = stats.norm.cdf(math.log(scales[k]) / both)
                    shares.add(f"share of motions {likely:.2f}", estimates[k][0], likely)
            yield from coverage.rows()
            yield from shares.rows(True)


def of_back_analyses(count: int) -> Iterator[Row]:
    """Yield the friction angle of a slide within 1.96 standard errors, from a run-out with a standard error of 3 %."""
    scene, true = load("vaiont"), 10.0
    run_out = float(solve(scene).run_out)
    coverage = Coverage("standard error of the run-out 3 %")
    for seed in range(count):
        observed = run_out * (1.0 + 0.03 * np.random.default_rng(seed).normal())
        (solution,) = backanalyse(scene, run_out=(observed, 0.03 * run_out)).solutions
        assert solution.standard_error is not None
        half = stats.norm.ppf(0.975) * solution.standard_error
        coverage.add("back-analysis", (0.0, solution.value - half, solution.value + half), true)
    yield from coverage.rows()


PARTS: dict[str, Callable[[int], Iterator[Row]]] = {
    "samples": of_samples,
    "indices": of_indices,
    "suites": of_suites,
    "back-analyses": of_back_analyses,
}


def main() -> int:
    """Measure, print a table and return the exit status."""
    chosen = options(__doc__, 2000, part={"choices": PARTS, "help": "only these intervals"})
    status = 0
    for name, part in PARTS.items():
        for row in part(chosen.count) if chosen.part in (None, name) else ():
            mark = "" if row.is_accepted else "  <--"
            print(
                f"{row.interval:32} {row.sample:32} given {row.given:5.3f}  coverage {row.coverage:5.3f}{mark}",
                flush=True,
            )
            status |= not row.is_accepted
    return status


if __name__ == "__main__":
    sys.exit(main())
