"""A study: a scene with uncertain numbers, or on a grid, cut into blocks that anybody may compute.

`run_block` is a pure function of the study, the block's index, the seed and the blocks' size: where and when it runs
does not matter, nor how often. Blocks of samples come first, then those for the sensitivity indices.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.arrays.lanes import solve_block
from slipcircle.base.distributions import Uncertain
from slipcircle.motion.motion import Status
from slipcircle.studies.sampling import directions, latin, monte_carlo, sobol

Floats = NDArray[np.float64]
Result = dict[str, NDArray[Any]]
METHODS = ("monte-carlo", "sobol", "latin-hypercube")
OUTPUTS = {"run_out": "m", "peak_velocity": "m/s", "duration": "s"}
REPLICATES = 16  # independent scramblings of a Sobol sequence, whose spread is the error
BATCHES = 32  # of the base points of sensitivity indices, whose spread is the error

# Bins of a histogram: of equal relative width 2**-10 from 2**-30 to 2**30, one below (zero too) and one above.
_PARTS = 10
_LOWEST = (1023 - 30) << _PARTS
BINS = (60 << _PARTS) + 2
BIN_ERROR = 2.0**-_PARTS


def bins(values: Floats) -> NDArray[np.int64]:
    """The bin of each magnitude: the exponent and the first bits of the significand of a float64 are its number."""
    return np.clip((values.view(np.int64) >> (52 - _PARTS)) - _LOWEST + 1, 0, BINS - 1)


def edges() -> Floats:
    """Lower edges of the bins, and infinity."""
    inner = (np.arange(BINS - 1, dtype=np.int64) + _LOWEST) << (52 - _PARTS)
    return np.concatenate([[0.0], inner.view(np.float64), [np.inf]])


def moments(values: Floats) -> Floats:
    """Number and mean of values, and sums of the second to fourth powers of what they differ from it."""
    if not values.size:
        return np.zeros(5)
    mean = float(np.mean(values))
    off = values - mean
    squares = off * off
    return np.array([values.size, mean, np.sum(squares), np.sum(squares * off), np.sum(squares * squares)])


class Piece(NamedTuple):
    """A stretch of a sequence of points."""

    replicate: int
    start: int
    length: int


@dataclass(frozen=True)
class Study:
    """What is computed, as plain data.

    Attributes
    ----------
    effects, values, law, fixed, accuracy
        As `slipcircle.arrays.lanes.solve_block` takes them.
    inputs : mapping
        What varies, by its name among the values.
    levels : tuple of ndarray
        Values of each input, in its key's unit: a grid, the last input fastest. Empty where inputs are drawn.
    method : str
        One of `METHODS`, or "grid".
    n : int
        How many samples.
    base : int
        Base points of the sensitivity indices, each of which takes the number of inputs and two more scenes.
    keep : bool
        Whether blocks return their samples too.
    tables : tuple of ndarray
        Directions of the replicates' Sobol sequences.
    """

    effects: tuple[str, ...]
    values: Mapping[str, Any]
    law: Any
    fixed: Mapping[str, Mapping[str, Any]]
    accuracy: float
    inputs: Mapping[str, Uncertain]
    levels: tuple[Floats, ...]
    method: str
    n: int
    base: int
    keep: bool
    tables: tuple[NDArray[np.uint32], ...] = ()

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
        return self.sample_blocks(size) + (min(BATCHES, self.base) if self.inputs else 0)

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


def sobol_tables(seed: int, n: int, dimensions: int) -> tuple[NDArray[np.uint32], ...]:
    """Directions of each replicate's sequence of n samples in all."""
    count = min(REPLICATES, n)
    return tuple(directions(seed, (1, r), -(-n // count), dimensions) for r in range(count))


def _points(study: Study, piece: Piece, seed: int) -> Floats:
    dimensions = len(study.inputs)
    if study.method == "sobol":
        return sobol(study.tables[piece.replicate], piece.start, piece.length)
    if study.method == "latin-hypercube":
        return latin(seed, study.n, dimensions)[:, piece.start : piece.start + piece.length]
    return monte_carlo(seed, (0,), piece.start, piece.length, dimensions)


def _solve(study: Study, drawn: list[Floats], count: int) -> tuple[NDArray[np.int8], dict[str, Floats]]:
    """Status and outputs of scenes, magnitudes; what does not move has moved by 0."""
    with np.errstate(all="ignore"):  # what is no scene has a status, and nothing to complain about
        given = {n: u.to_si(x) for (n, u), x in zip(study.inputs.items(), drawn, strict=True)}
        values = dict(study.values) | given
        block = solve_block(study.effects, values, study.accuracy, study.law, count, study.fixed)
        radius = np.asarray(values["radius"])
        found = {"run_out": np.abs(radius * block.rotation),
                 "peak_velocity": np.abs(radius * block.peak_angular_velocity), "duration": block.duration}  # fmt: skip
    answered = (block.status != Status.FAILED) & (block.status != Status.INVALID)
    return block.status, {"moves": np.where(answered, block.moves, np.nan)} | found


def run_block(study: Study, index: int, seed: int, size: int) -> Result:
    """Compute a block.

    Parameters
    ----------
    study : Study
    index : int
        From 0 to ``study.blocks(size)``.
    seed, size : int
        The study's seed, and how many samples its blocks have; a power of two, 4 at least.

    Returns
    -------
    dict of ndarray
        ``status`` counts; of each output the bins that are not empty, their counts, the extremes and the `moments`; the
        samples where they are kept. For sensitivity indices instead the sums of `slipcircle.studies.estimates.indices`.
    """
    first = study.sample_blocks(size)
    if index >= first:
        return {"sums": _sums(study, index - first, seed)}
    piece = study.piece(index, size)
    if study.method == "grid":
        at = np.unravel_index(np.arange(piece.start, piece.start + piece.length), [len(x) for x in study.levels])
        drawn = [x[k] for x, k in zip(study.levels, at, strict=True)]
    else:
        points = _points(study, piece, seed)
        drawn = [np.asarray(u.drawn(p)) for u, p in zip(study.inputs.values(), points, strict=True)]
    status, outputs = _solve(study, drawn, piece.length)
    result: Result = {"status": np.bincount(status, minlength=len(Status))}
    answered = ~np.isnan(outputs["moves"])
    result["moving"] = np.array([np.count_nonzero(outputs["moves"] == 1.0)])
    for name in OUTPUTS:
        values = outputs[name][answered]
        result[f"{name}.bins"], result[f"{name}.counts"] = _filled(bins(values))
        result[f"{name}.moments"] = moments(values)
        result[f"{name}.ends"] = np.array([values.min(), values.max()]) if values.size else np.array([np.inf, -np.inf])
    if study.keep:
        result |= {f"sample.{u.key}": x for u, x in zip(study.inputs.values(), drawn, strict=True)}
        result |= {f"sample.{n}": outputs[n] for n in OUTPUTS} | {"sample.status": status}
    return result


def _filled(found: NDArray[np.int64]) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
    """Bins that are not empty, and their counts."""
    some = found[found > 0]  # without what does not move, the rest mostly lies close together
    least = int(some.min()) if some.size else 0
    counts = np.bincount(some - least)
    filled = np.flatnonzero(counts)
    none = [0] if some.size < found.size else []
    return (np.concatenate([none, filled + least]).astype(np.int32),
            np.concatenate([[found.size - some.size] * len(none), counts[filled]]).astype(np.int32))  # fmt: skip


def _sums(study: Study, batch: int, seed: int) -> Floats:
    """`sums` of each output for a batch of base points A, B, and A with one column of B for each input."""
    count, d = study._batch(batch), len(study.inputs)
    if study.method == "sobol":
        points = sobol(directions(seed, (2, batch), count, 2 * d), 0, count)
    else:
        points = monte_carlo(seed, (2, batch), 0, count, 2 * d)
    laid = np.tile(points[:d, None, :], (1, d + 2, 1))
    laid[:, 1] = points[d:]
    for k in range(d):
        laid[k, 2 + k] = points[d + k]
    drawn = [np.asarray(u.drawn(p.reshape(-1))) for u, p in zip(study.inputs.values(), laid, strict=True)]
    _, outputs = _solve(study, drawn, (d + 2) * count)
    answered = np.all(~np.isnan(outputs["moves"].reshape(d + 2, count)), axis=0)
    return np.stack([sums(y.reshape(d + 2, count)[:, answered]) for y in outputs.values()])


def sums(y: Floats) -> Floats:
    """What `slipcircle.studies.estimates.indices` needs of one output, from yA, yB and then yAB of each input, by rows.

    The number of points, sums of yA + yB and yA**2 + yB**2; for each input of (yAB - yA)**2, yB (yAB - yA), yAB - yA.
    """
    a, b = y[0], y[1]
    found = [np.array([len(a), np.sum(a + b), np.sum(a * a + b * b)])]
    for mixed in y[2:]:
        step = mixed - a
        found.append(np.array([np.sum(step * step), np.sum(b * step), np.sum(step)]))
    return np.concatenate(found)
