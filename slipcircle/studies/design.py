"""The design of a study: which scenes it solves, drawn or on a grid, cut into blocks that anybody may compute.

`run_block` is a pure function of the design, the block's index, the seed and the blocks' size: where and when it runs
does not matter, nor how often. Blocks of samples come first, then those for the sensitivity indices.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.distributions import statistics
from slipcircle.motion.quantities import OUTCOMES
from slipcircle.motion.states import ANSWERED, Status
from slipcircle.scene.numbers import Number, Uncertain
from slipcircle.scene.scene import Scene
from slipcircle.studies.motions import motions
from slipcircle.studies.sampling import latin, monte_carlo, sobol
from slipcircle.studies.statistics import bins, moments, sums

Floats = NDArray[np.float64]
Result = dict[str, NDArray[Any]]
METHODS = ("monte-carlo", "sobol", "latin-hypercube")
REPLICATES = 16  # independent scramblings of a Sobol sequence, whose spread is the error
BATCHES = 32  # of the base points of sensitivity indices, whose spread is the error


class Piece(NamedTuple):
    """A stretch of a sequence of points."""

    replicate: int
    start: int
    length: int


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

    @property
    def replicates(self) -> int:
        """How many independent sequences the samples are from."""
        return min(REPLICATES, self.n) if self.method == "sobol" else 1

    def share(self, replicate: int) -> int:
        """How many samples a replicate has."""
        return self.n // self.replicates + (replicate < self.n % self.replicates)

    def sample_blocks(self, size: int) -> int:
        """How many blocks of samples there are; the replicates take turns."""
        return self.replicates * -(-self.share(0) // size)

    def blocks(self, size: int) -> int:
        """How many blocks there are."""
        return self.sample_blocks(size) + (min(BATCHES, self.base) if self.drawn else 0)

    def piece(self, index: int, size: int) -> Piece:
        """The stretch of a block of samples; a replicate's last one may be empty."""
        turn, replicate = divmod(index, self.replicates)
        start = turn * size
        return Piece(replicate, start, max(0, min(size, self.share(replicate) - start)))

    def scenes(self, index: int, size: int) -> int:
        """How many scenes a block solves."""
        first = self.sample_blocks(size)
        return self.piece(index, size).length if index < first else self._batch(index - first) * (len(self.inputs) + 2)

    def _batch(self, batch: int) -> int:
        batches = min(BATCHES, self.base)
        return self.base // batches + (batch < self.base % batches)


def _points(design: Design, seed: int, stream: tuple[int, ...], start: int, count: int, dimensions: int) -> Floats:
    sequence = sobol if design.method == "sobol" else monte_carlo
    return sequence(seed, stream, start, count, dimensions)


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
    found = {n: np.abs(v) for n, v in motion.outcomes.items()}
    moves = np.where(np.isin(motion.status, ANSWERED), motion.moves, np.nan)
    return motion.status, {"moves": moves} | {n: found[n] for n in OUTCOMES}


def run_block(design: Design, index: int, seed: int, size: int) -> Result:
    """Compute a block of a study with a seed, whose blocks have a size: a power of two, 4 at least.

    Returns
    -------
    dict of ndarray
        ``status`` counts; of each output the bins that are not empty, their counts, the extremes and the `moments`; the
        samples where they are kept. For sensitivity indices instead the `sums` of each outcome.
    """
    first = design.sample_blocks(size)
    if index >= first:
        return {"sums": _sums(design, index - first, seed)}
    piece = design.piece(index, size)
    if design.method == "grid":
        at = np.unravel_index(np.arange(piece.start, piece.start + piece.length), [len(x) for x in design.levels])
        drawn = [x[k] for x, k in zip(design.levels, at, strict=True)]
    elif design.method == "latin-hypercube":
        points = latin(seed, design.n, len(design.inputs))
        drawn = _drawn(design, points[:, piece.start : piece.start + piece.length])
    else:
        stream = (1, piece.replicate) if design.method == "sobol" else (0,)
        drawn = _drawn(design, _points(design, seed, stream, piece.start, piece.length, len(design.inputs)))
    status, outputs = _solve(design, drawn)
    result: Result = {"status": np.bincount(status, minlength=len(Status))}
    answered = ~np.isnan(outputs["moves"])
    result["moving"] = np.array([np.count_nonzero(outputs["moves"] == 1.0)])
    for name in OUTCOMES:
        values = outputs[name][answered]
        result[f"{name}.bins"], result[f"{name}.counts"] = np.unique(bins(values), return_counts=True)
        result[f"{name}.moments"] = moments(values)
        result[f"{name}.ends"] = np.array([values.min(), values.max()]) if values.size else np.array([np.inf, -np.inf])
    if design.keep:
        result |= {f"sample.{u.key}": x for u, x in zip(design.inputs.values(), drawn, strict=True)}
        result |= {f"sample.{n}": outputs[n] for n in OUTCOMES} | {"sample.status": status}
    return result


def _sums(design: Design, batch: int, seed: int) -> Floats:
    """`sums` of each output for a batch of base points A, B, and A with one column of B for each input."""
    count, d = design._batch(batch), len(design.inputs)
    points = _points(design, seed, (2, batch), 0, count, 2 * d)
    laid = np.tile(points[:d, None, :], (1, d + 2, 1))
    laid[:, 1] = points[d:]
    for k in range(d):
        laid[k, 2 + k] = points[d + k]
    _, outputs = _solve(design, _drawn(design, laid))
    answered = np.all(~np.isnan(outputs["moves"].reshape(d + 2, count)), axis=0)
    return np.stack([sums(y.reshape(d + 2, count)[:, answered]) for y in outputs.values()])
