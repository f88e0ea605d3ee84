"""Studies: how far and how fast a scene gets where its numbers are uncertain, or take the values of a grid."""

import math
from collections.abc import Iterable, Mapping
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.text import shown
from slipcircle.core.motion.motion import Motion
from slipcircle.core.motion.states import ANSWERED, Status
from slipcircle.core.scene.scene import Scene
from slipcircle.workbench.common.forms import library
from slipcircle.workbench.common.markup import Raw, table, tag
from slipcircle.workbench.common.quantities import OUTCOMES, words
from slipcircle.workbench.files.loaded import stability_of
from slipcircle.workbench.studies import export
from slipcircle.workbench.studies.design import Design, Result
from slipcircle.workbench.studies.motions import motions
from slipcircle.workbench.studies.propagation import Linear, disagreement, propagated
from slipcircle.workbench.studies.statistics import (
    BINS,
    Estimate,
    Indices,
    Spread,
    edges,
    histogram_quantile,
    indices,
    pooled,
    proportion,
    ranks,
    spread,
    standard_error,
    student,
    width,
)

Floats = NDArray[np.float64]


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


class Study:
    """What a study found; intervals hold with the confidence at each place, not everywhere at once.

    Attributes
    ----------
    design : Design
    seed, size : int
        With which the same numbers come again.
    confidence : float
    sensitivity : mapping
        `Indices` of each output, and of whether the mass moves, where there is more than one input.
    convergence : list of Convergence
        Of the reach: its median and its 95 % quantile.
    samples : mapping
        Inputs by key, in the key's unit, outputs and status, where they were kept.
    """

    def __init__(self, design: Design, confidence: float, results: Iterable[Result]) -> None:
        self.design, self.seed, self.size, self.confidence = design, design.seed, design.size, confidence
        self.sensitivity: Mapping[str, Indices] = {}
        self.convergence: list[Convergence] = []
        self.samples: Mapping[str, NDArray[Any]] = {}
        replicates = design.replicates
        self._counts = np.zeros((replicates, len(Status)), np.int64)
        self._histograms = {n: np.zeros((replicates, BINS), np.int64) for n in OUTCOMES}
        self._moments = {n: np.zeros((replicates, 5)) for n in OUTCOMES}
        self._ends = dict.fromkeys(OUTCOMES, (math.inf, -math.inf))
        kept, sums = dict[str, list[NDArray[Any]]](), list[Floats]()
        for index, result in enumerate(results):
            if "sums" in result:
                sums.append(result["sums"])
                continue
            self._add(index % replicates, result)
            for name, values in result.items():
                if name.startswith("sample."):
                    kept.setdefault(name.removeprefix("sample."), []).append(values)
            turns, rest = divmod(index + 1, replicates)
            last = index + 1 == design.sample_blocks
            if design.method != "grid" and not rest and (turns & (turns - 1) == 0 or last):
                median, upper = (self.quantile("reach", p) for p in (0.5, 0.95))
                self.convergence.append(Convergence(self.n, self.moving, median, upper))
        self.samples = {name: np.concatenate(values) for name, values in kept.items()}
        if sums:
            names = ("moves", *OUTCOMES)
            self.sensitivity = {n: indices(np.stack(sums)[:, k], confidence) for k, n in enumerate(names)}

    def _add(self, replicate: int, result: Result) -> None:
        """Add a block up."""
        self._counts[replicate] += result["status"]
        for name in OUTCOMES:
            self._histograms[name][replicate, result[f"{name}.bins"]] += result[f"{name}.counts"]
            both = np.stack([self._moments[name][replicate], result[f"{name}.moments"]])
            self._moments[name][replicate] = pooled(both)
            ends, (low, high) = self._ends[name], result[f"{name}.ends"].tolist()
            self._ends[name] = min(ends[0], low), max(ends[1], high)

    @property
    def scene(self) -> Scene:
        """Whose numbers vary."""
        return self.design.scene

    # -- what people take from it

    def __repr__(self) -> str:
        of = [f"{self.design.n} scenes, {self.design.method}", ", ".join(f"{n} {name}" for name, n in self._counted())]
        return f"<Study {self.scene.name}: {'; '.join([*of, *(' '.join(row) for row in self._summary())])}>"

    def _repr_html_(self) -> str:
        return Raw(tag("b", f"{self.scene.name}: {self.design.method}") + table([*self._counted(), *self._summary()]))

    def _counted(self) -> list[list[str]]:
        return [[words(s.name), str(int(n))] for s, n in zip(Status, self.counts, strict=True) if n]

    def _summary(self) -> list[list[str]]:
        rows = []
        for name, of in OUTCOMES.items():
            low, middle, high = (shown(self.quantile(name, p).value) for p in (0.05, 0.5, 0.95))
            rows.append([words(name), f"{middle} ({low} to {high}) {of.unit}"])
        return rows

    def __len__(self) -> int:
        return self.design.n

    def __bool__(self) -> bool:
        return True

    def __getitem__(self, index: int) -> Motion:
        """The motion of one sample, solved again; a ValueError says why where it is no scene."""
        given = {n: u.to_si(self._kept[u.key][[index]]) for n, u in self.design.inputs.items()}
        return motions(self.scene, given, self.design.accuracy)[0]

    @property
    def _kept(self) -> Mapping[str, NDArray[Any]]:
        if not self.samples:
            raise ValueError("Study: its samples were only counted; draw at most 2**20 of them, or ask for keep=True")
        return self.samples

    def to_dict(self) -> dict[str, Any]:
        """What JSON holds of it: statistics, curves, indices; SI units but for inputs, None for what cannot be said."""
        return export.record(self)

    def to_pandas(self) -> Any:
        """The samples as a pandas.DataFrame: inputs by key, outcomes in SI units, the name of the status, the reason.

        Raises
        ------
        ValueError
            If they were not kept.
        """
        kinds = [Status(s) for s in self._kept["status"].tolist()]
        more = {"status": [s.name for s in kinds], "reason": [s.reason for s in kinds]}
        frame = library("pandas").DataFrame({**self.samples, **more})
        frame.attrs["units"] = {n: q.unit for n, q in OUTCOMES.items()} | {
            u.key: u.unit for u in self.design.inputs.values()
        }
        return frame

    def to_xarray(self) -> Any:
        """The same as an xarray.Dataset: over the keys of a grid, or over samples with inputs as coordinates."""
        frame, keys = self.to_pandas(), [u.key for u in self.design.inputs.values()]
        if self.design.method == "grid":
            return frame.set_index(keys).to_xarray()
        return frame.rename_axis("sample").to_xarray().set_coords(keys)

    @property
    def counts(self) -> NDArray[np.int64]:
        """Samples of each `Status`."""
        return np.asarray(self._counts.sum(axis=0))

    @property
    def n(self) -> int:
        """Samples with an answer: the others are no scenes, or failed, and are left out of what follows."""
        return int(self._answered.sum())

    @property
    def _answered(self) -> NDArray[np.int64]:
        return np.asarray(self._counts[:, ANSWERED].sum(axis=1))

    @property
    def moving(self) -> Estimate:
        """Probability that the mass moves."""
        moving = self._answered - self._counts[:, Status.STAYS]
        return Estimate(*(float(x[0]) for x in self._probability(moving[:, None])))

    def quantile(self, output: str, p: float) -> Estimate:
        """A quantile of an output; its value is a sample's where they were kept, else within `BIN_ERROR` of it."""
        if not self.n:
            return Estimate(math.nan, math.nan, math.nan)
        counts, ends = self._histograms[output], self._ends[output]
        if output in self.samples:
            values = np.sort(self.samples[output][np.isin(self.samples["status"], ANSWERED)])

        def at(share: float) -> float:
            if not 0.0 <= share <= 1.0:
                return math.nan
            if output in self.samples:
                return float(values[max(0, math.ceil(share * self.n) - 1)])
            return float(histogram_quantile(counts.sum(axis=0), share, ends))

        if self.design.replicates > 1:
            each = np.array([histogram_quantile(c, p, ends) for c in counts if c.any()])
            half = float(student(each, self.confidence))
            return Estimate(at(p), max(0.0, at(p) - half), at(p) + half)
        low, high = ranks(p, self.n, self.confidence)
        return Estimate(at(p), at((low - 0.5) / self.n), at((high - 0.5) / self.n))

    def mean(self, output: str) -> Estimate:
        """Mean of an output; what does not move counts as 0."""
        return self._interval(*self._sampled(output)[:2])

    def std(self, output: str) -> Estimate:
        """Standard deviation of an output; what does not move counts as 0."""
        return self._interval(*self._sampled(output)[2:])

    def _sampled(self, output: str) -> Spread:
        each = self._moments[output]
        found, filled = spread(pooled(each)), each[each[:, 0] > 1]
        if len(filled) < 2:
            return found
        errors = standard_error(np.array([spread(m) for m in filled])).tolist()
        return found._replace(mean_error=errors[0], std_error=errors[2])

    def _interval(self, value: float, error: float) -> Estimate:
        half = error * width(self.confidence, self.design.replicates)
        return Estimate(value, value - half, value + half)

    @property
    def linear(self) -> Mapping[str, Linear]:
        """Mean and standard deviation of each output by linear propagation; empty where there is no derivative."""
        return self._linear[0]

    @property
    def no_linear(self) -> str:
        """Why `linear` is empty."""
        return self._linear[1]

    @cached_property
    def _linear(self) -> tuple[Mapping[str, Linear], str]:
        try:
            return propagated(self.design), ""
        except ValueError as error:
            return {}, str(error)

    def exceedance(self, output: str, points: int = 101) -> Exceedance:
        """Probability that an output is at least so large, at edges of bins, where it has no bin error."""
        high = self._ends[output][1]
        if not self.n:
            return Exceedance(*np.empty((4, 0)))
        wanted = np.linspace(0.0, high, points)
        places = np.unique(np.searchsorted(edges(), wanted, side="right") - 1)
        places = places[places > 0]  # at the first edge the probability is 1
        above = np.cumsum(self._histograms[output][:, ::-1], axis=1)[:, ::-1][:, places]
        return Exceedance(edges()[places], *self._probability(above))

    def bins(self, output: str) -> Floats:
        """The histogram of an output: from, to and how many, in rows; only bins that hold any."""
        counts = self._histograms[output].sum(axis=0)
        filled = np.flatnonzero(counts)
        return np.stack([edges()[filled], edges()[filled + 1], counts[filled]], axis=1)

    def _probability(self, hits: NDArray[np.int64]) -> tuple[Floats, Floats, Floats]:
        """Probabilities and their intervals from how often, (replicates, ...)."""
        n, total = self.n, hits.sum(axis=0)
        if not n:
            return tuple(np.full((3, *total.shape), np.nan))
        value = total / n
        low, high = proportion(total, n, self.confidence)
        if self.design.replicates > 1:
            filled = self._answered > 0
            half = student(hits[filled] / self._answered[filled, None], self.confidence)
            sure = (total == 0) | (total == n)  # the replicates agree, and cannot tell how surely
            low = np.where(sure, low, np.maximum(value - half, 0))
            high = np.where(sure, high, np.minimum(value + half, 1))
        return value, low, high

    # -- what to know

    @property
    def warnings(self) -> list[str]:
        """What to know before the numbers are used."""
        found, stability = [], stability_of(self.scene)
        if stability is not None and stability.method:
            of = "scene as it is given" if self.design.method == "grid" else "means"
            found.append(
                f"all of them slide along the critical circle of the {of}, of the least factor by "
                f"{stability.method}; it is looked for once, and kept"
            )
        total = int(self.counts.sum())
        for status, text in (
            *((s, f"have no answer and are left out: {s.reason}") for s in Status if s.reason),
            (Status.MOVING, "still move at their end: run-out and duration are those until then"),
        ):
            if count := int(self.counts[status]):
                found.append(f"{count} of {total} samples {text}")
        for name, linear in self.linear.items():
            if said := disagreement(name, linear, self._sampled(name), self.design.accuracy):
                found.append(said)
        return found
