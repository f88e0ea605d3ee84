"""The design of a study: which scenes it solves, drawn or on a grid, cut into blocks that anybody may compute.

`run_block` is a pure function of the design and the block's index: where and when it runs does not matter, nor how
often. Blocks of samples come first, then those for the sensitivity indices.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.core.motion.states import ANSWERED, Status
from slipcircle.core.scene.scene import Scene
from slipcircle.workbench.common.distributions import statistics
from slipcircle.workbench.common.quantities import OUTCOMES
from slipcircle.workbench.files.numbers import Number, Uncertain
from slipcircle.workbench.studies.motions import motions
from slipcircle.workbench.studies.sampling import latin, monte_carlo, sobol
from slipcircle.workbench.studies.statistics import bins, moments, sums

Floats = NDArray[np.float64]
Result = dict[str, NDArray[Any]]
METHODS = ("monte-carlo", "sobol", "latin-hypercube")
REPLICATES = 16  # independent scramblings of a Sobol sequence, whose spread is the error
BATCHES = 32  # of the base points of sensitivity indices, whose spread is the error


@dataclass(frozen=True)
class Design:
    """What is computed, as plain data."""

    scene: Scene  # its own values hold where no input has others
    accuracy: float
    inputs: Mapping[str, Number]  # that vary, by name
    drawn: Mapping[str, Uncertain]  # how those vary that are drawn, by name
    levels: tuple[Floats, ...]  # values of each input, in its key's unit: a grid, the last input fastest
    method: str  # one of `METHODS`, or "grid"
    n: int  # samples
    base: int  # base points of the sensitivity indices, each of which takes the number of inputs and two more scenes
    keep: bool  # whether blocks return their samples too
    correlation: Floats  # of the inputs' normal scores, (inputs, inputs)
    seed: int
    size: int  # samples of a block, a power of two, 4 at least

    @property
    def replicates(self) -> int:
        """How many independent sequences the samples are from."""
        return min(REPLICATES, self.n) if self.method == "sobol" else 1

    def share(self, replicate: int) -> int:
        """How many samples a replicate has."""
        return self.n // self.replicates + (replicate < self.n % self.replicates)

    @property
    def sample_blocks(self) -> int:
        """How many blocks of samples there are; the replicates take turns."""
        return self.replicates * -(-self.share(0) // self.size)

    @property
    def blocks(self) -> int:
        """How many blocks there are."""
        return self.sample_blocks + min(BATCHES, self.base)

    def piece(self, index: int) -> tuple[tuple[int, ...], int, int]:
        """Stream, start and length of a block of samples, of a replicate's last maybe 0, or of one of base points."""
        batches, batch = min(BATCHES, self.base), index - self.sample_blocks
        if batch >= 0:
            return (2, batch), 0, self.base // batches + (batch < self.base % batches)
        turn, replicate = divmod(index, self.replicates)
        start = turn * self.size
        length = max(0, min(self.size, self.share(replicate) - start))
        return (1, replicate) if self.method == "sobol" else (0,), start, length

    def scenes(self, index: int) -> int:
        """How many scenes a block solves."""
        return self.piece(index)[2] * (1 if index < self.sample_blocks else len(self.inputs) + 2)

    def points(self, index: int, dimensions: int) -> Floats:
        """Points of the unit cube that a block draws, (dimensions, count)."""
        stream, start, length = self.piece(index)
        if self.method == "latin-hypercube" and index < self.sample_blocks:
            return latin(self.seed, self.n, dimensions)[:, start : start + length]
        return (sobol if self.method == "sobol" else monte_carlo)(self.seed, stream, start, length, dimensions)


def _drawn(design: Design, points: Any) -> list[Floats]:
    if np.any(design.correlation != np.eye(len(points))):  # a Gaussian copula: normal scores are mixed
        normal = statistics().norm
        mixed = np.tensordot(np.linalg.cholesky(design.correlation), normal.ppf(points), 1)
        points = np.clip(normal.cdf(mixed), 2.0**-54, 1.0 - 2.0**-53)
    return [np.asarray(u.drawn(p.reshape(-1))) for u, p in zip(design.drawn.values(), points, strict=True)]


def _solve(design: Design, values: list[Floats]) -> tuple[NDArray[np.int8], dict[str, Floats]]:
    """Status and outcomes of scenes, magnitudes; what does not move has moved by 0."""
    with np.errstate(all="ignore"):
        given = {n: number.to_si(x) for (n, number), x in zip(design.inputs.items(), values, strict=True)}
    motion = motions(design.scene, given, design.accuracy)
    moves = np.where(np.isin(motion.status, ANSWERED), motion.moves, np.nan)
    return motion.status, {"moves": moves} | {n: np.abs(motion.outcomes[n]) for n in OUTCOMES}


def run_block(design: Design, index: int) -> Result:
    """Compute a block.

    Returns
    -------
    dict of ndarray
        ``status`` counts; of each output the bins that are not empty, their counts, the extremes and the `moments`; the
        samples where they are kept. For sensitivity indices instead the `sums` of each outcome.
    """
    if index >= design.sample_blocks:
        return {"sums": _sums(design, index)}
    if design.method == "grid":
        _, start, length = design.piece(index)
        at = np.unravel_index(np.arange(start, start + length), [len(x) for x in design.levels])
        drawn = [x[k] for x, k in zip(design.levels, at, strict=True)]
    else:
        drawn = _drawn(design, design.points(index, len(design.inputs)))
    status, outputs = _solve(design, drawn)
    result: Result = {"status": np.bincount(status, minlength=len(Status))}
    answered = ~np.isnan(outputs["moves"])
    for name in OUTCOMES:
        values = outputs[name][answered]
        result[f"{name}.bins"], result[f"{name}.counts"] = np.unique(bins(values), return_counts=True)
        result[f"{name}.moments"] = moments(values)
        result[f"{name}.ends"] = np.array([values.min(), values.max()]) if values.size else np.array([np.inf, -np.inf])
    if design.keep:
        result |= {f"sample.{u.key}": x for u, x in zip(design.inputs.values(), drawn, strict=True)}
        result |= {f"sample.{n}": outputs[n] for n in OUTCOMES} | {"sample.status": status}
    return result


def _sums(design: Design, index: int) -> Floats:
    """`sums` of each output for a batch of base points A, B, and A with one column of B for each input."""
    d = len(design.inputs)
    points = design.points(index, 2 * d)
    count = points.shape[1]
    laid = np.tile(points[:d, None, :], (1, d + 2, 1))
    laid[:, 1] = points[d:]
    for k in range(d):
        laid[k, 2 + k] = points[d + k]
    _, outputs = _solve(design, _drawn(design, laid))
    answered = np.all(~np.isnan(outputs["moves"].reshape(d + 2, count)), axis=0)
    return np.stack([sums(y.reshape(d + 2, count)[:, answered]) for y in outputs.values()])
