"""Studies: results and statistics of a scene solved for samples, on a grid or under records.

Invalid samples are counted separately and left out of the statistics. Samples that slide without a known end move and
exceed every threshold: quantiles among them are infinite, and statistics that depend on them are not given.
"""

import math
from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.conversions import Pictured
from slipcircle.base.kinds import ArrayDict, Columns, Flags, Floats, Integers, Texts, ValueDict
from slipcircle.core import Motion, Status, plan
from slipcircle.derivatives import with_parameters
from slipcircle.messages import OUTSIDE
from slipcircle.workbench.common.markup import Raw, html_table, tag
from slipcircle.workbench.common.quantities import OUTCOMES, spelt_out
from slipcircle.workbench.files.loaded import stability_of
from slipcircle.workbench.stability.stability import least_of
from slipcircle.workbench.studies import export
from slipcircle.workbench.studies.design import FACTOR, NO_RESULT, Design
from slipcircle.workbench.studies.engines import open_executor
from slipcircle.workbench.studies.propagation import Linear, disagreement, propagated
from slipcircle.workbench.studies.searched import effect_of_searching
from slipcircle.workbench.studies.shaken import Shaken
from slipcircle.workbench.studies.statistics import (
    Convergence,
    Estimate,
    Exceedance,
    Indices,
    Ordered,
    Spread,
    interval_width,
    probability,
    sensitivity_indices,
    sums,
    value_text,
)

_VARYING = ("moves", *OUTCOMES)  # outputs with sensitivity indices


class Study(Shaken, Pictured):
    """Statistics of solved samples; the confidence of intervals is pointwise, not simultaneous.

    Attributes
    ----------
    design : Design
        Definition of the study.
    seed, size : int
        Seed and block size, which reproduce the samples.
    confidence : float
        Confidence of all intervals.
    values : mapping of str to ndarray
        Results by name in SI units, of each sample or (record, polarity, scale, sample): ``run_out``,
        ``peak_velocity``, ``duration``, ``end_displacement`` (permanent), ``rotation`` (at the end), ``slips`` (number
        of times that sliding begins), ``outside_range`` and ``status`` (`Status`); for a grid also factors of safety.
        They are signed, 0 for a mass that does not move, and NaN without a result.
    damaged : int
        Number of blocks of the folder that were damaged and computed again.
    """

    def __init__(self, design: Design, confidence: float, values: Mapping[str, NDArray[Any]], damaged: int = 0) -> None:
        self.design = design
        self.seed = design.seed
        self.size = design.size
        self.confidence = confidence
        self.damaged = damaged
        self.values = {name: array[..., : design.n] for name, array in values.items()}
        self._base_values = {name: array[..., design.n :] for name, array in values.items()}
        self._ordered: dict[str, Ordered] = {}

    @cached_property
    def inputs(self) -> ArrayDict:
        """Values of the varied parameters at all samples by key, in the units of the keys."""
        return self.design.samples()

    @cached_property
    def samples(self) -> Columns:
        """Inputs and, without records, results by name; outcomes are magnitudes, NaN if infinite."""
        columns = {**self.inputs}
        for name, values in self.values.items() if self.design.records is None else ():
            magnitude = np.abs(values) if name in OUTCOMES else values
            is_real = values.dtype == np.float64
            columns[name] = np.where(np.isinf(values), np.nan, magnitude) if is_real else values
        return columns

    @cached_property
    def sensitivity(self) -> Mapping[str, Indices]:
        """`Indices` of each output and of ``moves``; empty for a single input."""
        by_output = zip(*self._batches, strict=True)
        of_outputs = (sensitivity_indices(np.stack(batches), self.confidence) for batches in by_output)
        return dict(zip(_VARYING, of_outputs, strict=False))

    @cached_property
    def _batches(self) -> list[list[Floats]]:
        """Sums for `sensitivity_indices`, one list for each batch of base points, by output."""
        return [self._sums(block) for block in range(self.design.sample_blocks, self.design.blocks)]

    def _sums(self, block: int) -> list[Floats]:
        """Return the `sums` of a batch, given by its block's index, for each output, from valid base points only."""
        (lanes,) = self.design.place(block)
        first = lanes.start - self.design.n
        values = {name: array[first : lanes.stop - self.design.n] for name, array in self._base_values.items()}
        status = values["status"]
        moves = np.where(status < Status.INVALID, status != Status.STAYS, np.nan)
        outputs = np.stack([moves, *(_magnitudes(values, name) for name in OUTCOMES)])
        outputs = outputs.reshape(len(_VARYING), self.design.base_scenes, -1)
        return [sums(y) for y in outputs[:, :, ~np.isnan(outputs[0]).any(axis=0)]]

    @cached_property
    def convergence(self) -> list[Convergence]:
        """Estimates from increasing numbers of samples: after 1, 2, 4, ... blocks of every replicate."""
        estimates = []
        design = self._sampling
        blocks, turn = design.sample_blocks, design.replicates
        while turn < 2 * blocks and design.method != "grid":
            (lanes,) = design.place(min(turn, blocks) - 1)
            first = Study(replace(design, n=lanes.stop, base=0), self.confidence, self.values)
            median, upper = (first.quantile("run_out", p) for p in (0.5, 0.95))
            estimates.append(Convergence(first.n, first.moving, median, upper))
            turn *= 2
        return estimates

    def __repr__(self) -> str:
        """Return the design and a summary of the results in one line."""
        sizes = ", ".join(f"{name}: {len(values)}" for name, values in export.study_axes(self).items())
        parts = [" ".join(row) for row in self._summary()]
        return f"<Study {self.scene.name}: {'; '.join([sizes, *parts])}>"

    def _repr_html_(self) -> str:
        return Raw(tag("b", f"{self.scene.name}: {self.design.method}") + html_table(self._summary()))

    def _summary(self) -> list[Texts]:
        rows = [[s.words, str(int(n))] for s, n in zip(Status, self.counts, strict=True) if n]
        for name, quantity in OUTCOMES.items() if self.design.records is None else ():
            low, median, high = (value_text(self.quantile(name, p).value) for p in (0.05, 0.5, 0.95))
            rows.append([spelt_out(name), f"{median} ({low} to {high}) {quantity.unit}"])
        return rows

    def __len__(self) -> int:
        """Return the number of samples."""
        return self.design.n

    def __bool__(self) -> bool:
        """Return True, also for studies without samples."""
        return True

    def __getitem__(self, index: int) -> Motion:
        """Return the motion of one sample, solved again; ValueError with the reason if the sample is invalid."""
        numbers = self._sampling.inputs.items()
        si = {name: float(number.to_si(self.inputs[number.key][index])) for name, number in numbers}
        return Motion.of_single(plan(with_parameters(self.scene, si), self.design.accuracy))

    def to_dict(self) -> ValueDict:
        """Return statistics, curves and indices as a mapping for JSON, in SI units except for inputs.

        An undefined value is None; a quantile among samples that move without a result is "beyond".
        """
        return export.study_record(self)

    def columns(self) -> Columns:
        """Return all scenes as columns by name: axes, inputs, results in SI units, status and reason."""
        return export.study_columns(self)

    def arrays(self) -> Columns:
        """Return axes, inputs and results as arrays by name."""
        return export.arrays(self)

    def to_pandas(self) -> Any:
        """Return `columns` as a pandas.DataFrame, indexed by sample and, with records, record, polarity and scale."""
        return export.frame(self)

    def to_xarray(self) -> Any:
        """Return the results as an xarray.Dataset over samples, keys of a grid, or record, polarity, scale, sample."""
        return export.dataset(self)

    @property
    def _sampling(self) -> Design:
        """Design of independent samples; ValueError with records, whose motions are not independent."""
        if self.design.records is not None:
            raise ValueError("Study: has records, and not samples alone; use by_record, fragility or motions_of")
        return self.design

    @cached_property
    def _replicate(self) -> NDArray[np.int8]:
        """Index of the replicate (independent sequence) of each sample, (samples,)."""
        design = self._sampling
        lengths = [design.piece(block)[2] for block in range(design.sample_blocks)]
        return np.repeat((np.arange(design.sample_blocks) % design.replicates).astype(np.int8), lengths)

    def _by_replicate(self, selected: Flags) -> Integers:
        """Return the number of selected samples in each replicate, (replicates,), from a mask of samples."""
        return np.bincount(self._replicate[selected], minlength=self.design.replicates)

    def _in_order(self, name: str, values: Floats) -> Ordered:
        """Return the known values of valid samples in increasing order, stored under ``name``."""
        if name not in self._ordered:
            is_known = self._is_valid & ~np.isnan(values)
            replicates = [is_known & (self._replicate == k) for k in range(self.design.replicates)]
            self._ordered[name] = Ordered([values[k] for k in replicates])
        return self._ordered[name]

    @cached_property
    def counts(self) -> Integers:
        """Number of samples by `Status`."""
        return np.bincount(self.values["status"].ravel(), minlength=len(Status))

    @property
    def n(self) -> int:
        """Number of valid samples, the basis of all statistics."""
        return int(self._valid.sum())

    @cached_property
    def _valid(self) -> Integers:
        """Number of valid samples in each replicate."""
        return self._by_replicate(self._is_valid)

    @cached_property
    def _is_valid(self) -> Flags:
        """Whether each sample is a valid scene."""
        return self.values["status"] < Status.INVALID

    @property
    def outside_range(self) -> int:
        """Number of samples that leave the range of validity (`Motion.outside_range`); statistics include them."""
        return int(np.count_nonzero(self.values["outside_range"]))

    @property
    def without_result(self) -> int:
        """Number of samples that move without a result; they exceed every threshold."""
        return int(self.counts[[*NO_RESULT]].sum())

    @property
    def moving(self) -> Estimate:
        """Probability that the mass moves."""
        return self._single_probability(self._is_valid & (self.values["status"] != Status.STAYS))

    @cached_property
    def _factors(self) -> ArrayDict:
        """Factors of safety at the start of each sample by method, stored or computed in threads."""
        if self.design.with_factors:
            return {n.removeprefix(FACTOR): values for n, values in self.values.items() if n.startswith(FACTOR)}
        with open_executor() as workers:
            blocks = [*workers.map(self.design.at_start, range(self.design.sample_blocks))]
        return {method: np.concatenate([block[method] for block in blocks]) for method in blocks[0]}

    @property
    def failure(self) -> Mapping[str, Estimate]:
        """Probability that the factor of safety at the start is below 1, by method; computed on access.

        If the factor is unknown for some samples, the value is NaN and the interval covers all possibilities.
        """
        probabilities = {}
        for method, factor in self._factors.items():
            failing = self._is_valid & (factor < 1.0)
            unknown = self._is_valid & np.isnan(factor)
            estimate = self._single_probability(failing)
            if unknown.any():
                estimate = Estimate(math.nan, estimate.low, self._single_probability(failing | unknown).high)
            probabilities[method] = estimate
        return probabilities

    def factor_quantile(self, method: str, p: float) -> Estimate:
        """Return the p-quantile of the factor of safety at the start, with its interval, by a method of `failure`.

        Samples with an unknown factor are left out.
        """
        return self._in_order(f"{FACTOR}{method}", self._factors[method]).quantile(p, self.confidence)

    def _single_probability(self, selected: Flags) -> Estimate:
        """Return the probability of being among the samples of a mask, with its interval."""
        hits = self._by_replicate(selected)
        return Estimate(*(float(x[0]) for x in probability(hits[:, None], self._valid, self.confidence)))

    def _of_output(self, output: str) -> Ordered:
        """Return the magnitudes of an output in increasing order."""
        return self._in_order(output, _magnitudes(self.values, output))

    def quantile(self, output: str, p: float) -> Estimate:
        """Return the p-quantile of an output, a value of a sample, with its interval.

        It is infinite among samples that move without a result.
        """
        return self._of_output(output).quantile(p, self.confidence)

    def mean(self, output: str) -> Estimate:
        """Return the mean of an output with its interval; 0 for samples at rest, NaN if samples lack a result."""
        value, error, *_ = self._sampled(output)
        half = error * interval_width(self.confidence, self.design.replicates)
        return Estimate(value, value - half, value + half)

    def std(self, output: str) -> Estimate:
        """Return the standard deviation of an output, which is 0 for samples at rest.

        The interval is unknown, because its error depends on the few samples in the tail.
        """
        return Estimate(self._sampled(output).std, math.nan, math.nan)

    def _sampled(self, output: str) -> Spread:
        if self.without_result:
            return Spread(math.nan, math.nan, math.nan, math.nan)
        return self._of_output(output).spread()

    @property
    def linear(self) -> Mapping[str, Linear]:
        """Mean and standard deviation of each output by linear propagation; empty if it is not possible."""
        return self._linear[0]

    @property
    def no_linear(self) -> str:
        """Reason why `linear` is empty; otherwise an empty text."""
        return self._linear[1]

    @cached_property
    def _linear(self) -> tuple[Mapping[str, Linear], str]:
        if self.without_result and self.design.drawn:
            return {}, f"{self.without_result} samples move without a result"
        try:
            return propagated(self._sampling), ""
        except ValueError as error:
            return {}, str(error)

    def exceedance(self, output: str, points: int = 101) -> Exceedance:
        """Return the probabilities that an output reaches ``points`` - 1 equidistant values up to its greatest."""
        if not self.n:
            return Exceedance(*np.empty((4, 0)))
        in_order = self._of_output(output)
        at = np.unique(np.linspace(0.0, float(in_order.finite[-1:].sum()), points))[1:]
        hits = np.array([x.size - np.searchsorted(x, at) for x in in_order.replicates])
        return Exceedance(at, *probability(hits, self._valid[self._valid > 0], self.confidence))

    @property
    def warnings(self) -> Texts:
        """Warnings about the results."""
        is_shaken = self.design.records is not None
        is_grid = self.design.method == "grid"
        messages = self._record_warnings() if is_shaken else self._circle_warnings()
        if self.damaged:
            messages.append(f"{self.damaged} blocks of the folder were damaged and computed again")
        total = int(self.counts.sum())
        scenes = "motions" if is_shaken else "scenes" if is_grid else "samples"
        counted = "" if is_grid else "; they count as moving and as exceeding every threshold"
        until = "displacements" if is_shaken else "run-out and duration"
        for status in (s for s in Status if self.counts[s]):
            share = f"{int(self.counts[status])} of {total} {scenes}"
            if status in NO_RESULT:
                messages.append(f"{share} move without a result: {status.reason}{counted}")
            elif status >= Status.INVALID:
                messages.append(f"{share} are not valid scenes and not counted: {self._why(status)}")
            elif status is Status.MOVING:
                messages.append(f"{share} still move at their end: {until} are measured up to then")
        if self.outside_range:
            messages.append(f"{self.outside_range} of {total} {scenes} move {OUTSIDE}")
        return messages + ([] if is_shaken else self._statistics_warnings())

    def _why(self, status: Status) -> str:
        """Return why the first sample with this status has no motion."""
        found = int((self.values["status"] == status).argmax())
        try:
            return str(self[found % len(self)].reason)
        except ValueError as error:
            return str(error)

    def _statistics_warnings(self) -> Texts:
        """Return warnings about the statistics of samples."""
        messages = []
        if self.without_result and self.design.method != "grid":
            messages.append("means, standard deviations and indices are not given, because samples lack a result")
        if invalid := self.design.base - int(sum(moves[0] for moves, *_ in self._batches)):
            messages.append(f"{invalid} of {self.design.base} base points are invalid and not in the indices")
        for name, linear in self.linear.items():
            if difference := disagreement(name, linear, self._sampled(name), self.design.accuracy):
                messages.append(difference)
        return messages

    def _circle_warnings(self) -> Texts:
        stability = stability_of(self.scene)
        if stability is None or not stability.method:
            return []
        is_grid = self.design.method == "grid"
        circle = f"critical circle of the {'scene as given' if is_grid else 'means'} ({least_of(stability.method)})"
        messages = [f"all {'scenes' if is_grid else 'samples'} use the {circle}, which is searched once"]
        return messages + ([effect_of_searching(self, stability.method)] if self.design.search_each else [])


def _magnitudes(values: Mapping[str, NDArray[Any]], output: str) -> Floats:
    """Return the magnitudes of an output, infinite for samples that slide without a result, NaN for invalid scenes."""
    return np.where(np.isin(values["status"], NO_RESULT), np.inf, np.abs(values[output]))


SuiteStudy = Study  # name for studies with records
