"""Studies: how far and how fast a scene gets where its numbers are uncertain, or take the values of a grid."""

import hashlib
import math
import os
from collections.abc import Iterable, Mapping
from concurrent.futures import Executor
from dataclasses import dataclass, field
from functools import cached_property, reduce
from typing import IO, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.series import Series
from slipcircle.motion.motion import ANSWERED, Status
from slipcircle.motion.plan import plan
from slipcircle.motion.quantities import OUTCOMES
from slipcircle.scene.numbers import Number
from slipcircle.scene.scene import Scene
from slipcircle.scene.varied import number_in, value_in
from slipcircle.studies.design import METHODS, Design, Result
from slipcircle.studies.engines import Folder, Progress, computed, stored
from slipcircle.studies.propagation import Linear, Sampled, disagreement, propagated
from slipcircle.studies.sampling import MOST_LATIN
from slipcircle.studies.statistics import (
    BINS,
    Estimate,
    Indices,
    edges,
    histogram_quantile,
    indices,
    pooled,
    proportion,
    ranks,
    spread,
    student,
    width,
)

Floats = NDArray[np.float64]
_KEEP = 2**20  # samples up to which they are kept by default
_BASE = 2**14
_MOST_GRID = 2**26


class Curve(NamedTuple):
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


@dataclass(repr=False)
class Study:
    """What a study found; intervals hold with the confidence at each place, not everywhere at once.

    Attributes
    ----------
    design : Design
    seed, size : int
        With which the same numbers come again.
    confidence : float
    counts : ndarray
        Lanes of each `slipcircle.motion.motion.Status`.
    sensitivity : mapping
        `Indices` of each output, and of whether the mass moves, where there is more than one input.
    convergence : list of Convergence
        Of the reach: its median and its 95 % quantile.
    samples : mapping
        Inputs by key, in the key's unit, outputs and status, where they were kept.
    """

    design: Design
    seed: int
    size: int
    confidence: float
    counts: NDArray[np.int64] = field(init=False)
    sensitivity: Mapping[str, Indices] = field(init=False)
    convergence: list[Convergence] = field(init=False, default_factory=list)
    samples: Mapping[str, NDArray[Any]] = field(init=False, default_factory=dict)

    @property
    def scene(self) -> Scene:
        """Whose numbers vary."""
        return self.design.scene

    def __repr__(self) -> str:
        counted = ", ".join(f"{int(c)} {s.name.lower()}" for s, c in zip(Status, self.counts, strict=True) if c)
        return f"<Study {self.scene.name}: {self.design.n} scenes, {self.design.method}; {counted}>"

    def __post_init__(self) -> None:
        replicates = self.design.replicates
        self.counts = np.zeros(len(Status), np.int64)
        self.sensitivity = {}
        self._answered = np.zeros(replicates, np.int64)
        self._moving = np.zeros(replicates, np.int64)
        self._histograms = {n: np.zeros((replicates, BINS), np.int64) for n in OUTCOMES}
        self._moments = {n: np.zeros((replicates, 5)) for n in OUTCOMES}
        self._ends = dict.fromkeys(OUTCOMES, (math.inf, -math.inf))

    @property
    def n(self) -> int:
        """Samples with an answer: the others are no scenes, or failed, and are left out of what follows."""
        return int(self._answered.sum())

    @property
    def moving(self) -> Estimate:
        """Probability that the mass moves."""
        curve = self._probability(self._moving[:, None])
        return Estimate(*(float(x[0]) for x in curve))

    def quantile(self, output: str, p: float) -> Estimate:
        """A quantile of an output; its value is a sample's where they were kept, else within `BIN_ERROR` of it."""
        counts, ends = self._histograms[output], self._ends[output]
        if not self.n:
            return Estimate(math.nan, math.nan, math.nan)
        if output in self.samples:
            values = self._ordered(output)
            value = float(values[max(0, math.ceil(p * self.n) - 1)])
        else:
            value = float(histogram_quantile(counts.sum(axis=0), p, ends))
        if self.design.replicates > 1:
            each = np.array([histogram_quantile(c, p, ends) for c in counts if c.any()])
            half = float(student(each, self.confidence))
            return Estimate(value, max(0.0, value - half), value + half)
        low, high = ranks(p, self.n, self.confidence)

        def at(rank: int) -> float:
            if not 1 <= rank <= self.n:
                return math.nan
            if output in self.samples:
                return float(values[rank - 1])
            return float(histogram_quantile(counts.sum(axis=0), rank / self.n, ends))

        return Estimate(value, at(low), at(high))

    def mean(self, output: str) -> Estimate:
        """Mean of an output; what does not move counts as 0."""
        mean, error, _, _ = self._sampled(output)
        return self._interval(mean, error)

    def std(self, output: str) -> Estimate:
        """Standard deviation of an output; what does not move counts as 0."""
        _, _, std, error = self._sampled(output)
        return self._interval(std, error)

    def _sampled(self, output: str) -> Sampled:
        each = self._moments[output]
        found = Sampled(*spread(reduce(pooled, each)))
        filled = each[each[:, 0] > 1]
        if self.design.replicates == 1 or len(filled) < 2:
            return found
        spreads = np.array([spread(m) for m in filled])[:, [0, 2]]
        errors = np.std(spreads, axis=0, ddof=1) / math.sqrt(len(filled))
        return found._replace(mean_error=float(errors[0]), std_error=float(errors[1]))

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
        if self.design.method == "grid":
            return {}, "values on a grid have no distribution"
        try:
            return propagated(self.design), ""
        except ValueError as error:
            return {}, str(error)

    def exceedance(self, output: str, points: int = 101) -> Curve:
        """Probability that an output is at least so large, at edges of bins, where it has no bin error."""
        high = self._ends[output][1]
        if not self.n:
            return Curve(*np.empty((4, 0)))
        wanted = np.linspace(0.0, high, points)
        places = np.unique(np.searchsorted(edges(), wanted, side="right") - 1)
        places = places[places > 0]  # at the first edge the probability is 1
        above = np.cumsum(self._histograms[output][:, ::-1], axis=1)[:, ::-1][:, places]
        return Curve(edges()[places], *self._probability(above))

    def bins(self, output: str) -> Floats:
        """The histogram of an output: from, to and how many, in rows; only bins that hold any."""
        counts = self._histograms[output].sum(axis=0)
        filled = np.flatnonzero(counts)
        return np.stack([edges()[filled], edges()[filled + 1], counts[filled]], axis=1)

    def _ordered(self, output: str) -> Floats:
        answered = np.isin(self.samples["status"], ANSWERED)
        return np.sort(self.samples[output][answered])

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
            low, high = (
                np.where(sure, low, np.maximum(value - half, 0)),
                np.where(sure, high, np.minimum(value + half, 1)),
            )
        return value, low, high

    # -- merging

    def _merge(self, results: Iterable[Result]) -> None:
        """Add blocks up, in their order."""
        design, samples = self.design, self.design.sample_blocks(self.size)
        kept: dict[str, list[NDArray[Any]]] = {}
        sums = []
        for index, result in enumerate(results):
            if index >= samples:
                sums.append(result["sums"])
                continue
            replicate = index % design.replicates
            self.counts += result["status"]
            self._answered[replicate] += result["duration.counts"].sum()
            self._moving[replicate] += result["moving"][0]
            for name in OUTCOMES:
                self._histograms[name][replicate, result[f"{name}.bins"]] += result[f"{name}.counts"]
                self._moments[name][replicate] = pooled(self._moments[name][replicate], result[f"{name}.moments"])
                ends, (low, high) = self._ends[name], result[f"{name}.ends"].tolist()
                self._ends[name] = min(ends[0], low), max(ends[1], high)
            for name, values in result.items():
                if name.startswith("sample."):
                    kept.setdefault(name.removeprefix("sample."), []).append(values)
            turns, rest = divmod(index + 1, design.replicates)
            if design.method != "grid" and not rest and (turns & (turns - 1) == 0 or index + 1 == samples):
                upper = self.quantile("reach", 0.95)
                self.convergence.append(Convergence(self.n, self.moving, self.quantile("reach", 0.5), upper))
        self.samples = {name: np.concatenate(values) for name, values in kept.items()}
        if sums:
            every = np.stack(sums)
            names = ("moves", *OUTCOMES)
            self.sensitivity = {n: indices(every[:, k], self.confidence) for k, n in enumerate(names)}

    # -- what to know

    @property
    def warnings(self) -> list[str]:
        """What to know before the numbers are used."""
        found = []
        total = int(self.counts.sum())
        for status, text in (
            (Status.INVALID, "are no scenes, such as an angle below its bound, and are left out"),
            (Status.UPRIGHT, "have no answer, as the mass would hang over, and are left out"),
            (Status.ENDLESS, "have no answer, as they never rest, and are left out"),
            (Status.FAILED, "have no answer, as their numbers overflow, and are left out"),
            (Status.MOVING, "still move at their end: run-out and duration are those until then"),
        ):
            if count := int(self.counts[status]):
                found.append(f"{count} of {total} samples {text}")
        for name, linear in self.linear.items():
            if said := disagreement(name, linear, self._sampled(name), self.design.accuracy):
                found.append(said)
        return found


def _known(given: Any) -> Any:
    """A law, or what else is no number, as a folder remembers it and as JSON holds it."""
    if isinstance(given, Mapping):
        return {k: _known(v) for k, v in given.items()}
    if isinstance(given, Series):
        samples = hashlib.sha256(given.time.tobytes() + given.values.tobytes()).hexdigest()
        return {"samples": samples, "held": given.held}
    if isinstance(given, list | tuple | np.ndarray | np.generic):
        return np.asarray(given).tolist()
    if isinstance(given, str | float | int) or given is None:
        return given
    if not hasattr(given, "__qualname__"):
        return repr(given)
    if "<" in given.__qualname__:  # another one has the same name
        raise ValueError(
            "folder: a friction function that a later run is to know again needs a name of its own: define it with def "
            "in a module, or give a table"
        )
    return f"{given.__module__}.{given.__qualname__}"


def _seed(rng: Any, folder: Any) -> int:
    """A seed from whatever NumPy takes as one; that of the folder's study where there is none."""
    if isinstance(rng, int | np.integer) and not isinstance(rng, bool):
        if rng < 0:
            raise ValueError(f"rng = {rng!r}: a seed must be at least 0")
        return int(rng)
    if rng is None and folder is not None and (held := stored(folder)):
        return int(held["seed"])
    return int(np.random.default_rng(rng).integers(2**53))


def ensemble(
    scene: Scene, n: int, rng: Any = None, executor: Executor | None = None, *, method: str = "monte-carlo",
    sensitivity: int | None = None, keep: bool | None = None, size: int | None = None, confidence: float = 0.95,
    accuracy: float | None = None, folder: str | os.PathLike[str] | None = None, progress: IO[str] | None = None,
) -> Study:  # fmt: skip
    """Study a scene: solve it for samples of its uncertain numbers.

    Parameters
    ----------
    scene : Scene
        With ``uncertain`` numbers, of which the others are none; independent of each other.
    n : int
        How many samples.
    rng : int, SeedSequence or Generator, optional
        The seed, or what one is drawn from; the same seed gives the same bits with any executor.
    executor : concurrent.futures.Executor, optional
        Where blocks are computed: threads, processes, or ``client.get_executor()`` of Dask; by default here.
    method : str, optional
        "monte-carlo"; "sobol": 16 independently scrambled sequences, whose spread gives the intervals, best for n of 16
        times a power of two; or "latin-hypercube", in memory, whose intervals are those of Monte Carlo: too wide.
    sensitivity : int, optional
        Base points of the sensitivity indices, each of which takes the number of inputs and 2 more scenes; by default
        16384, n if that is fewer, and 0 where there is one input.
    keep : bool, optional
        Whether to keep the samples, by default up to 2**20 of them. Otherwise they are counted in bins of a relative
        width of 1/1024, and a million or a hundred million take the same memory.
    size : int, optional
        Samples of a block, a power of two; by default so that there are eight blocks at least, which show how the
        results converge, and up to 16384, 65536 beyond 2**22 samples, and 262144 beyond 2**28, where many machines may
        work and each block costs the scheduler some milliseconds. Few where each scene costs as much.
    confidence : float, optional
        Of all intervals.
    accuracy : float, optional
        Relative error asked for of each solution; by default the scene's own, or 1e-9.
    folder : path, optional
        Where finished blocks are kept, and found by a later call that continues.
    progress : stream, optional
        Where to tell the rate and the time left.

    Raises
    ------
    ValueError
        If no number is uncertain, if the scene is of arrays, or for a folder that holds another study.

    Examples
    --------
    >>> from slipcircle import Scene, ensemble
    >>> from dataclasses import replace
    >>> angle = {"distribution": "normal", "mean": 10, "std": 1}
    >>> found = ensemble(replace(Scene.load("vaiont"), uncertain={"friction.angle_deg": angle}), 1000, rng=1)
    >>> found.moving.value
    1.0
    """
    said = []
    if scene.shape:
        said.append("a scene of arrays is solved as it is: use solve")
    if not scene.uncertain:
        said.append("no number is uncertain: give Scene(uncertain=...), --uncertain, or a distribution in its file")
    if isinstance(n, bool) or not isinstance(n, int | np.integer) or n < 1:
        said.append(f"n = {n!r}: must be a whole number, 1 at least")
    elif method == "latin-hypercube" and n > MOST_LATIN:
        said.append(f"n = {n}: a Latin hypercube is held in memory, so {MOST_LATIN} at most; take method='sobol'")
    if method not in METHODS:
        said.append(f"method = {method!r}: must be one of {', '.join(METHODS)}")
    if not 0.0 < confidence < 1.0:
        said.append(f"confidence = {confidence!r}: must be between 0 and 1")
    if size is not None and (size < 4 or size & (size - 1)):
        said.append(f"size = {size!r}: must be a power of two, 4 at least")
    if sensitivity is not None and (isinstance(sensitivity, bool) or not 0 <= sensitivity <= 2**22 or sensitivity == 1):
        said.append(f"sensitivity = {sensitivity!r}: must be 0, or 2 to {2**22} base points")
    if said:
        raise ValueError("ensemble: " + "; ".join(said))
    seed, n, drawn = _seed(rng, folder), int(n), dict(scene.uncertain)
    base = (min(_BASE, n) if len(drawn) > 1 and n > 1 else 0) if sensitivity is None else sensitivity
    design = Design(scene, plan(scene, accuracy).accuracy, {k: u.number for k, u in drawn.items()}, drawn, (), method,
                    n, base, n <= _KEEP if keep is None else keep)  # fmt: skip
    return conduct(design, seed, size or _size(n // design.replicates), executor, confidence, folder, progress)


def _size(n: int) -> int:
    """Samples of a block, of n in a sequence."""
    return min(max(2 ** max(n // 8, 1).bit_length() // 2, 256), 2**14 if n <= 2**22 else 2**16 if n <= 2**28 else 2**18)


def grid(
    scene: Scene, levels: Mapping[str, Any], executor: Executor | None = None, *, accuracy: float | None = None,
    folder: str | os.PathLike[str] | None = None, progress: IO[str] | None = None,
) -> Study:  # fmt: skip
    """Solve a scene at every combination of given values; ``samples`` has them, the last key's fastest.

    Parameters
    ----------
    scene : Scene
    levels : mapping
        Values by key, ``{"friction.angle_deg": [8, 10, 12]}``, in the key's unit.
    executor, accuracy, folder, progress
        As of `ensemble`.
    """
    inputs: dict[str, Number] = {}
    said: list[str] = []
    for path, values in levels.items():
        try:
            number = number_in(scene, path)
        except ValueError as error:
            said.append(str(error))
            continue
        if value_in(scene, number) is None:
            said.append(f"{path}: the scene has no {number.name} to vary")
        elif number.name in inputs:
            said.append(f"{path}: {inputs[number.name].key} says the same")
        elif np.ndim(values) != 1 or not np.size(values) or not np.all(np.isfinite(values)):
            said.append(f"{path}: must be a list of numbers")
        inputs[number.name] = number
    said += ["a scene of arrays is solved as it is: use solve"] if scene.shape else []
    n = math.prod(np.size(x) for x in levels.values())
    if n > _MOST_GRID:
        said.append(f"{n} combinations: they are held in memory, so {_MOST_GRID} at most; draw samples instead")
    if said or not levels:
        raise ValueError("grid: " + ("; ".join(said) or "no values are given"))
    axes = tuple(np.asarray(v, dtype=np.float64) for v in levels.values())
    design = Design(scene, plan(scene, accuracy).accuracy, inputs, {}, axes, "grid", n, 0, True)
    return conduct(design, 0, _size(n), executor, 0.95, folder, progress)


def conduct(
    design: Design, seed: int, size: int, executor: Executor | None, confidence: float,
    folder: str | os.PathLike[str] | None, progress: IO[str] | None,
) -> Study:  # fmt: skip
    """Compute a design's blocks and add them up."""
    kept = Folder(folder, _described(design, seed, size)) if folder is not None else None
    found = Study(design, seed, size, confidence)
    told = Progress(sum(design.scenes(k, size) for k in range(design.blocks(size))), progress) if progress else None
    found._merge(computed(design, seed, size, executor, kept, told or (lambda scenes, old: None)))
    return found


def _described(design: Design, seed: int, size: int) -> dict[str, Any]:
    """What tells one study from another, as a folder remembers it."""
    from slipcircle import __version__

    scene = design.scene
    return {
        "slipcircle": __version__, "outcomes": list(OUTCOMES), "accuracy": design.accuracy,
        "numbers": {n: _known(v) for n, v in sorted(scene.numbers.items())}, "given": _known(scene.arc.given or {}),
        "friction": _known(scene.friction), "effects": _known(scene.called),
        "inputs": [u.key for u in design.inputs.values()], "drawn": [u.record for u in design.drawn.values()],
        "levels": [x.tolist() for x in design.levels], "method": design.method, "samples": design.n,
        "sensitivity_base": design.base, "keep": design.keep, "seed": seed, "block": size,
    }  # fmt: skip
