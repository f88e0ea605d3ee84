"""Studies: how far and how fast a scene gets where its numbers are uncertain, or take the values of a grid.

Samples that are no scene are counted apart, and statistics are of the others. Samples that slide to no known end move,
and exceed every threshold: quantiles among them are infinite, and statistics that they could change are not given.
"""

import math
from collections.abc import Iterable, Mapping
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.forms import Pictured
from slipcircle.base.kinds import Floats
from slipcircle.base.optional import optional
from slipcircle.core import ANSWERED, Motion, Scene, Status
from slipcircle.words import OUTSIDE
from slipcircle.workbench.common.markup import Raw, table, tag
from slipcircle.workbench.common.quantities import OUTCOMES, words
from slipcircle.workbench.files.loaded import stability_of
from slipcircle.workbench.stability.stability import least_of
from slipcircle.workbench.studies import export
from slipcircle.workbench.studies.design import NO_RESULT, Design, Result
from slipcircle.workbench.studies.factors import Factors, factors_of
from slipcircle.workbench.studies.motions import motions
from slipcircle.workbench.studies.propagation import Linear, disagreement, propagated
from slipcircle.workbench.studies.searched import effect_of_searching
from slipcircle.workbench.studies.statistics import (
    NOT_GIVEN,
    Estimate,
    Indices,
    Spread,
    indices,
    probability,
    value_text,
    width,
)
from slipcircle.workbench.studies.tally import COUNTED, Tally


class Exceedance(NamedTuple):
    """Probabilities that values are exceeded, with their intervals."""

    at: Floats
    probability: Floats
    low: Floats
    high: Floats


class Convergence(NamedTuple):
    """What was known after the first n samples."""

    n: int
    moving: Estimate
    median: Estimate
    upper: Estimate


class Study(Pictured):
    """Statistics of solved samples; the confidence of intervals is pointwise, not simultaneous.

    Attributes
    ----------
    design : Design
    seed, size : int
        Repeat the same samples.
    confidence : float
    outside_range : int
        Number of samples that leave the range of validity, `Motion.outside_range`; statistics include them.
    sensitivity : mapping
        `Indices` of each output, and of whether the mass moves, if there is more than one input.
    convergence : list of Convergence
        Convergence of the median and of the 95 % quantile of the run-out.
    samples : mapping
        Inputs by key, in the unit of the key, outputs and status, if they were kept.
    """

    def __init__(self, design: Design, confidence: float, results: Iterable[Result]) -> None:
        self.design = design
        self.seed = design.seed
        self.size = design.size
        self.confidence = confidence
        self.sensitivity: Mapping[str, Indices] = {}
        self.convergence: list[Convergence] = []
        self.samples: Mapping[str, NDArray[Any]] = {}
        replicates = design.replicates
        self._counts = np.zeros((replicates, len(Status)), np.int64)
        self.outside_range = 0
        self._tallies = {name: Tally(replicates) for name in OUTCOMES}
        self._with_motions = Factors(replicates)
        self._add_all(results)

    def _add_all(self, results: Iterable[Result]) -> None:
        """Add all blocks up, those of samples first."""
        samples = dict[str, list[NDArray[Any]]]()
        sums = list[Floats]()
        for index, result in enumerate(results):
            if index >= self.design.sample_blocks:
                sums.append(result["sums"])
                continue
            self._add(index % self.design.replicates, result)
            for name, values in result.items():
                if name.startswith("sample."):
                    samples.setdefault(name.removeprefix("sample."), []).append(values)
            if self._is_checkpoint(index + 1):
                median = self.quantile("run_out", 0.5)
                upper = self.quantile("run_out", 0.95)
                self.convergence.append(Convergence(self.n, self.moving, median, upper))
        self.samples = {name: np.concatenate(values) for name, values in samples.items()}
        self._indices_from(np.stack(sums) if sums else None)

    def _add(self, replicate: int, result: Result) -> None:
        """Add a block up."""
        self._counts[replicate] += result["status"]
        self.outside_range += int(result["outside_range"])
        for name, tally in self._tallies.items():
            tally.add(replicate, {part: result[f"{name}.{part}"] for part in COUNTED})
        self._with_motions.add(replicate, result)

    @cached_property
    def _factors(self) -> Factors:
        return self._with_motions if self.design.with_factors else factors_of(self.design)

    def _is_checkpoint(self, blocks: int) -> bool:
        """Whether the convergence is looked at after so many blocks: whole turns of all replicates, powers of two."""
        turns, rest = divmod(blocks, self.design.replicates)
        is_power = turns & (turns - 1) == 0
        return self.design.method != "grid" and not rest and (is_power or blocks == self.design.sample_blocks)

    def _indices_from(self, sums: Floats | None) -> None:
        """The sensitivity indices from the sums of batches of base points, (batches, 1 + outcomes, ...)."""
        self._invalid_points = 0
        if sums is not None:
            self._invalid_points = self.design.base - int(sums[:, 0, 0].sum())
            named = enumerate(("moves", *OUTCOMES))
            self.sensitivity = {n: indices(sums[:, k], self.confidence) for k, n in named}

    @property
    def scene(self) -> Scene:
        """The scene whose numbers vary."""
        return self.design.scene

    # -- tables -------------------------------------------------------------------------------------------------------

    def __repr__(self) -> str:
        size = f"{self.design.n} scenes, {self.design.method}"
        counted = ", ".join(f"{end}: {count}" for end, count in self._counted())
        summary = [" ".join(words) for words in self._summary()]
        parts = "; ".join([size, counted, *summary])
        return f"<Study {self.scene.name}: {parts}>"

    def _repr_html_(self) -> str:
        return Raw(tag("b", f"{self.scene.name}: {self.design.method}") + table([*self._counted(), *self._summary()]))

    def _counted(self) -> list[list[str]]:
        return [[s.words, str(int(n))] for s, n in zip(Status, self.counts, strict=True) if n]

    def _summary(self) -> list[list[str]]:
        rows = []
        for name, quantity in OUTCOMES.items():
            low, median, high = (value_text(self.quantile(name, p).value) for p in (0.05, 0.5, 0.95))
            rows.append([words(name), f"{median} ({low} to {high}) {quantity.unit}"])
        return rows

    def __len__(self) -> int:
        return self.design.n

    def __bool__(self) -> bool:
        return True

    def __getitem__(self, index: int) -> Motion:
        """The motion of one sample, solved again; a ValueError says why where it is no scene."""
        si = {n: u.to_si(self._kept[u.key][[index]]) for n, u in self.design.inputs.items()}
        return motions(self.scene, si, self.design.accuracy)[0]

    @property
    def _kept(self) -> Mapping[str, NDArray[Any]]:
        if not self.samples:
            raise ValueError("Study: its samples were only counted; draw at most 2**20 of them, or ask for keep=True")
        return self.samples

    def to_dict(self) -> dict[str, Any]:
        """Statistics, curves and indices for JSON, in SI units except for inputs. None if undefined, "beyond" for a
        quantile among samples that move without a result.
        """
        return export.record(self)

    def to_pandas(self) -> Any:
        """The samples as a pandas.DataFrame: inputs by key, outcomes in SI units, the name of the status, the reason.

        Raises
        ------
        ValueError
            If they were not kept.
        """
        statuses = [Status(s) for s in self._kept["status"].tolist()]
        named = {"status": [s.name for s in statuses], "reason": [s.reason for s in statuses]}
        frame = optional("pandas", "to_pandas").DataFrame({**self.samples, **named})
        units = {name: quantity.unit for name, quantity in OUTCOMES.items()}
        units |= {number.key: number.unit for number in self.design.inputs.values()}
        frame.attrs["units"] = units
        return frame

    def to_xarray(self) -> Any:
        """The same as an xarray.Dataset: over the keys of a grid, or over samples with inputs as coordinates."""
        frame, keys = self.to_pandas(), [u.key for u in self.design.inputs.values()]
        if self.design.method == "grid":
            return frame.set_index(keys).to_xarray()
        return frame.rename_axis("sample").to_xarray().set_coords(keys)

    # -- counts and probabilities -------------------------------------------------------------------------------------

    @property
    def counts(self) -> NDArray[np.int64]:
        """Samples of each `Status`."""
        return self._counts.sum(axis=0)

    @property
    def n(self) -> int:
        """Number of valid samples, to which all statistics refer."""
        return int(self._valid.sum())

    @property
    def _valid(self) -> NDArray[np.int64]:
        """The same of each replicate."""
        return self._counts[:, : Status.INVALID].sum(axis=1)

    @property
    def without_result(self) -> int:
        """Samples that move but have no result; they count as exceeding every threshold."""
        return int(self.counts[[*NO_RESULT]].sum())

    @property
    def moving(self) -> Estimate:
        """Probability that the mass moves."""
        moving = self._valid - self._counts[:, Status.STAYS]
        return self._single_probability(moving)

    @property
    def failure(self) -> Mapping[str, Estimate]:
        """Probability that the factor of safety at the start is below 1, by method; computed when it is read.

        If some samples have no such factor the value is NaN, and the interval covers all possibilities.
        """
        found = {}
        for method, counts in self._factors.counts.items():
            failing, unknown = counts.T
            estimate = self._single_probability(failing)
            if unknown.any():
                at_most = self._single_probability(failing + unknown)
                estimate = Estimate(math.nan, estimate.low, at_most.high)
            found[method] = estimate
        return found

    def factor_quantile(self, method: str, p: float) -> Estimate:
        """A quantile of the factor of safety at the start, by method as in `failure`, within `BIN_ERROR` of it.

        Of the samples that have such a factor.
        """
        tally = self._factors.tallies[method]
        if not tally.histograms.any():
            return NOT_GIVEN
        shares = (p, *tally.share_interval(p, self.confidence))
        return Estimate(*(tally.quantile(share) if 0.0 <= share <= 1.0 else math.nan for share in shares))

    def _single_probability(self, hits: NDArray[np.int64]) -> Estimate:
        return Estimate(*(float(x[0]) for x in probability(hits[:, None], self._valid, self.confidence)))

    # -- statistics of outputs ----------------------------------------------------------------------------------------

    def quantile(self, output: str, p: float) -> Estimate:
        """A quantile of an output; the value of a sample if they were kept, otherwise within `BIN_ERROR` of it.

        Infinite if it lies among the samples that move without a result.
        """
        if not self.n:
            return NOT_GIVEN
        shares = (p, *self._tallies[output].share_interval(p, self.confidence))
        return Estimate(*(self._at_share(output, share) for share in shares))

    def _at_share(self, output: str, share: float) -> float:
        """The value that such a share of the samples does not exceed; NaN beyond all of them."""
        if not 0.0 <= share <= 1.0:
            return math.nan
        if output not in self.samples:
            return self._tallies[output].quantile(share)
        rank = max(0, math.ceil(share * self.n) - 1)
        in_order = self._in_order(output)
        return float(in_order[rank]) if rank < len(in_order) else math.inf

    def _in_order(self, output: str) -> Floats:
        """The kept samples that have a result, in order."""
        status = self.samples["status"]
        return np.sort(self.samples[output][np.isin(status, ANSWERED)])

    def mean(self, output: str) -> Estimate:
        """Mean of an output; samples that do not move count as 0. None if some samples move without a result."""
        value, error, *_ = self._sampled(output)
        half = error * width(self.confidence, self.design.replicates)
        return Estimate(value, value - half, value + half)

    def std(self, output: str) -> Estimate:
        """Standard deviation of an output; samples that do not move count as 0.

        Without an interval: few samples are in the tail on which its error depends.
        """
        return Estimate(self._sampled(output).std, math.nan, math.nan)

    def _sampled(self, output: str) -> Spread:
        if self.without_result:
            return Spread(math.nan, math.nan, math.nan, math.nan)
        return self._tallies[output].spread()

    @property
    def linear(self) -> Mapping[str, Linear]:
        """Mean and standard deviation of each output by linear propagation; empty if there is no derivative."""
        return self._linear[0]

    @property
    def no_linear(self) -> str:
        """Why `linear` is empty."""
        return self._linear[1]

    @cached_property
    def _linear(self) -> tuple[Mapping[str, Linear], str]:
        if self.without_result and self.design.drawn:
            return {}, f"{self.without_result} samples move without a result"
        try:
            return propagated(self.design), ""
        except ValueError as error:
            return {}, str(error)

    def exceedance(self, output: str, points: int = 101) -> Exceedance:
        """Exceedance probability of an output at the edges of bins, where there is no bin error."""
        if not self.n:
            return Exceedance(*np.empty((4, 0)))
        at, counts = self._tallies[output].exceeding(points)
        return Exceedance(at, *probability(counts, self._valid, self.confidence))

    def bins(self, output: str) -> Floats:
        """Histogram of an output: rows of from, to and count, for bins that are not empty; the last may be infinite."""
        return self._tallies[output].table()

    # -- what to know -------------------------------------------------------------------------------------------------

    @property
    def warnings(self) -> list[str]:
        """Warnings about the results."""
        found = self._circle_warnings()
        is_grid, total = self.design.method == "grid", int(self.counts.sum())
        scenes = "scenes" if is_grid else "samples"
        counted = "" if is_grid else "; they count as moving and as exceeding every threshold"
        for status in (s for s in Status if self.counts[s]):
            share = f"{int(self.counts[status])} of {total} {scenes}"
            if status in NO_RESULT:
                found.append(f"{share} move without a result: {status.reason}{counted}")
            elif status >= Status.INVALID:
                found.append(f"{share} are not valid scenes and not counted: {status.reason}")
            elif status is Status.MOVING:
                found.append(f"{share} still move at their end: run-out and duration are those until then")
        if self.without_result and not is_grid:
            found.append("means, standard deviations and indices of outputs are not given: samples without a result")
        if self.outside_range:
            found.append(f"{self.outside_range} of {total} {scenes} move {OUTSIDE}")
        if self._invalid_points:
            found.append(f"{self._invalid_points} of {self.design.base} base points are invalid and not in the indices")
        for name, linear in self.linear.items():
            if difference := disagreement(name, linear, self._sampled(name), self.design.accuracy):
                found.append(difference)
        return found

    def _circle_warnings(self) -> list[str]:
        stability = stability_of(self.scene)
        if stability is None or not stability.method:
            return []
        whose = "scene as it is given" if self.design.method == "grid" else "means"
        found = [
            f"all of them slide along the critical circle of the {whose}, of the "
            f"{least_of(stability.method)}; it is searched once, and kept"
        ]
        return found + ([effect_of_searching(self, stability.method)] if self.design.search_each else [])
