"""The design of a study: the scenes that it solves, sampled or on a grid, in independent blocks.

`Design.run_block` is a pure function of the design and the block's index: where and when it runs does not matter, nor
how often. Blocks of samples come first, then those for the sensitivity indices.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.kinds import Floats
from slipcircle.core import ANSWERED, Motion, Scene, Status
from slipcircle.workbench.common.distributions import special
from slipcircle.workbench.common.quantities import OUTCOMES, factors
from slipcircle.workbench.files.numbers import Number, Uncertain
from slipcircle.workbench.studies.motions import factors_at_start, motions
from slipcircle.workbench.studies.sampling import monte_carlo, sobol
from slipcircle.workbench.studies.searched import searched_factors
from slipcircle.workbench.studies.statistics import sums
from slipcircle.workbench.studies.tally import counted

Result = dict[str, NDArray[Any]]
# Of a sample that slides, but not to a known end: it moves, and exceeds every threshold.
NO_RESULT = tuple(s for s in Status if s not in ANSWERED and s < Status.INVALID)
METHODS = ("monte-carlo", "sobol")
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
    search_each: bool = False  # whether factors of safety are also those of the circle searched for each sample

    @property
    def correlations(self) -> list[dict[str, Any]]:
        """Correlated inputs by their keys, with the correlation of their normal scores; for JSON."""
        keys = [number.key for number in self.inputs.values()]
        places = np.argwhere(np.triu(self.correlation, 1)).tolist()
        return [{"key": keys[i], "with": keys[j], "value": float(self.correlation[i, j])} for i, j in places]

    @property
    def correlations_text(self) -> str:
        """The same in words; empty where there are none."""
        pairs = [f"{pair['key']} with {pair['with']} {pair['value']:g}" for pair in self.correlations]
        return f"correlation of {' and of '.join(pairs)}" if pairs else ""

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
        batches = min(BATCHES, self.base)
        batch = index - self.sample_blocks
        if batch >= 0:
            whole, rest = divmod(self.base, batches)
            return (2, batch), 0, whole + (batch < rest)
        turn, replicate = divmod(index, self.replicates)
        start = turn * self.size
        left = max(0, self.share(replicate) - start)
        stream = (1, replicate) if self.method == "sobol" else (0,)
        return stream, start, min(self.size, left)

    def scenes(self, index: int) -> int:
        """How many scenes a block solves."""
        _, _, length = self.piece(index)
        is_sample = index < self.sample_blocks
        return length if is_sample else length * (len(self.inputs) + 2)

    def points(self, index: int, dimensions: int) -> Floats:
        """Points of the unit cube that a block draws, (dimensions, count)."""
        stream, start, length = self.piece(index)
        draw = sobol if self.method == "sobol" else monte_carlo
        return draw(self.seed, stream, start, length, dimensions)

    def task(self, index: int) -> tuple[Callable[[int], Result], int]:
        """What computes a block."""
        return self.run_block, index

    def values(self, index: int) -> list[Floats]:
        """Values of each input at the samples of a block, in its key's unit."""
        if self.method == "grid":
            return _on_grid(self, index)
        return _drawn(self, self.points(index, len(self.inputs)))

    def run_block(self, index: int) -> Result:
        """Compute a block.

        Returns
        -------
        dict of ndarray
            Counts by ``status`` and of what is ``outside_range``; of each output the bins that are not empty, their
            counts, and of its finite values the extremes and the `moments`; where `with_factors`, the numbers of
            `at_start`; the samples where they are kept. For sensitivity indices instead the `sums` of each outcome.
        """
        if index >= self.sample_blocks:
            return {"sums": _sums(self, index)}
        values = self.values(index)
        solved = _solve(self, values)
        valid, status = ~np.isnan(solved.moves), solved.motion.status
        outside = np.count_nonzero(solved.motion.outside_range)
        result: Result = {"status": np.bincount(status, minlength=len(Status)), "outside_range": np.array(outside)}
        for name, outcome in solved.outcomes.items():
            result |= {f"{name}.{part}": value for part, value in counted(outcome[valid]).items()}
        by_method: dict[str, Floats] = {}
        if self.with_factors:
            by_method = factors(solved.motion.plan.scene, solved.motion.factor_of_safety)
        if self.search_each:
            by_method |= searched_factors(self.scene, solved.si, valid)
        result |= _counted_factors(by_method, valid)
        if self.keep:
            for number, value in zip(self.inputs.values(), values, strict=True):
                result[f"sample.{number.key}"] = value
            for name, outcome in solved.outcomes.items():
                result[f"sample.{name}"] = np.where(np.isinf(outcome), np.nan, outcome)
            for method, factor in by_method.items() if self.method == "grid" else ():
                result[f"sample.factor of safety, {method}"] = np.where(np.isinf(factor), np.nan, factor)
            result["sample.status"] = status
        return result

    @property
    def with_factors(self) -> bool:
        """Whether factors of safety come with the motions: a grid lists them, and a search for each is long work."""
        return self.search_each or self.method == "grid"

    def at_start(self, index: int) -> Result:
        """Of each factor of safety of a block of samples the same as of outputs, and how many are below 1, unknown."""
        by_method, valid = factors_at_start(self.scene, _si(self, self.values(index)), self.accuracy)
        return _counted_factors(by_method, valid)


def _drawn(design: Design, points: Any) -> list[Floats]:
    """Values of each input, in its key's unit, at points of the unit cube, (inputs, ...)."""
    is_correlated = np.any(design.correlation != np.eye(len(points)))
    if is_correlated:  # a Gaussian copula: normal scores are mixed
        mixing = np.linalg.cholesky(design.correlation)
        scores = np.tensordot(mixing, special().ndtri(points), 1)
        points = np.clip(special().ndtr(scores), 2.0**-54, 1.0 - 2.0**-53)
    values = []
    for uncertain, of_input in zip(design.drawn.values(), points, strict=True):
        flat = of_input.reshape(-1)
        values.append(np.asarray(uncertain.drawn(flat)))
    return values


def _on_grid(design: Design, index: int) -> list[Floats]:
    """The same of a block of a grid."""
    _, start, length = design.piece(index)
    shape = [len(level) for level in design.levels]
    places = np.unravel_index(np.arange(start, start + length), shape)
    return [level[place] for level, place in zip(design.levels, places, strict=True)]


class _Solved(NamedTuple):
    """What blocks count of their scenes."""

    motion: Motion
    moves: Floats  # 1 or 0, NaN of what is no scene
    si: dict[str, Floats]  # values of the inputs in SI units
    outcomes: dict[str, Floats]  # magnitudes; 0 of what does not move, infinite of what slides without a result


def _si(design: Design, values: list[Floats]) -> dict[str, Floats]:
    """Values of the inputs in SI units, by name."""
    with np.errstate(all="ignore"):
        return {name: design.inputs[name].to_si(x) for name, x in zip(design.inputs, values, strict=True)}


def _solve(design: Design, values: list[Floats]) -> _Solved:
    si = _si(design, values)
    motion = motions(design.scene, si, design.accuracy)
    no_result = np.isin(motion.status, NO_RESULT)
    is_invalid = motion.status >= Status.INVALID
    moves = np.where(is_invalid, np.nan, motion.moves | no_result)
    outcomes = {}
    for name in OUTCOMES:
        magnitude = np.abs(motion.outcomes[name])
        outcomes[name] = np.where(no_result, np.inf, magnitude)
    return _Solved(motion, moves, si, outcomes)


def _counted_factors(by_method: Mapping[str, Floats], valid: Any) -> Result:
    """By method, of what is valid: how many are below 1 and how many are not known, and the bins of the others."""
    result: Result = {}
    for method, values in by_method.items():
        factor = values[valid]
        unknown = np.isnan(factor)
        result[f"factor.{method}"] = np.array([np.sum(factor < 1.0), np.sum(unknown)])
        for part, value in counted(factor[~unknown]).items():
            result[f"factor bins.{method}.{part}"] = value
    return result


def _sums(design: Design, index: int) -> Floats:
    """`sums` of moving and of each outcome for a batch of base points A, B, and A with one column of B for each input.

    Of the base points whose scenes are all valid.
    """
    d = len(design.inputs)
    points = design.points(index, 2 * d)
    count = points.shape[1]
    matrices = np.tile(points[:d, None, :], (1, d + 2, 1))
    matrices[:, 1] = points[d:]
    for k in range(d):
        matrices[k, 2 + k] = points[d + k]
    solved = _solve(design, _drawn(design, matrices))
    outputs = np.stack([solved.moves, *solved.outcomes.values()])
    outputs = outputs.reshape(-1, d + 2, count)
    valid = ~np.isnan(outputs[0]).any(axis=0)
    return np.stack([sums(y) for y in outputs[:, :, valid]])
