"""Designs of studies: the scenes to solve, divided into independent blocks.

`Design.run_block` is a pure function of the design and the index of a block. Blocks of samples, or of a grid, come
first, blocks for the sensitivity indices follow. With records, a block combines some records with the lanes of a block
of samples. The samples are the same for every record, so that the variance can be split between records and soil.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from slipcircle.base.arrays import quiet
from slipcircle.base.kinds import ArrayDict, Columns, Floats, Shape, TextMap, Texts, ValueDict
from slipcircle.core import ANSWERED, Scene, Status
from slipcircle.workbench.common.distributions import special
from slipcircle.workbench.common.quantities import OUTCOMES, factors_by_method
from slipcircle.workbench.files.keys import Key
from slipcircle.workbench.files.numbers import Uncertain
from slipcircle.workbench.stability.stability import METHODS as STABILITY_METHODS
from slipcircle.workbench.studies.groundmotions import GroundMotions
from slipcircle.workbench.studies.motions import factors_at_start, motions
from slipcircle.workbench.studies.sampling import monte_carlo, sobol
from slipcircle.workbench.studies.searched import SEARCHED, searched_factors

# Statuses of samples that slide without a known end: they move and exceed every threshold.
NO_RESULT = tuple(s for s in Status if s not in ANSWERED and s < Status.INVALID)
METHODS = ("monte-carlo", "sobol")
REPLICATES = 16  # independent scramblings of a Sobol sequence, whose spread is the error
BATCHES = 32  # of the base points of sensitivity indices, whose spread is the error
FACTOR = "factor of safety, "  # before the method in the name of a result
# Results of every motion with their units: signed, NaN without a result, 0 for a mass at rest.
RESULTS: TextMap = {
    **{name: quantity.unit for name, quantity in OUTCOMES.items()},
    "end_displacement": "m",
    "rotation": "rad",
    "slips": "",
    "outside_range": "",
}
_TYPES = {"slips": np.int32, "outside_range": np.bool_, "status": np.int8}  # others are float64


@dataclass(frozen=True)
class Design:
    """Definition of a study as plain data."""

    scene: Scene  # its values apply unless an input varies them
    accuracy: float
    inputs: Mapping[str, Key]  # that vary, by name
    drawn: Mapping[str, Uncertain]  # distributions of the drawn inputs, by name
    levels: tuple[Floats, ...]  # values of each input, in its key's unit: a grid, the last input fastest
    method: str  # one of `METHODS`, or "grid"
    n: int  # samples
    base: int  # base points of the sensitivity indices; each needs (inputs + 2) scenes
    correlation: Floats  # of the inputs' normal scores, (inputs, inputs)
    seed: int
    size: int  # samples of a block, a power of two, 4 at least
    search_each: bool = False  # whether the critical circle is also searched for each sample
    records: GroundMotions | None = None  # replace the scene's own shaking

    @property
    def keys(self) -> Texts:
        """Keys of the inputs."""
        return [number.key for number in self.inputs.values()]

    @property
    def correlations(self) -> list[ValueDict]:
        """Correlated pairs of inputs by their keys, with the correlation of their normal scores; for JSON."""
        places = np.argwhere(np.triu(self.correlation, 1)).tolist()
        return [{"key": self.keys[i], "with": self.keys[j], "value": float(self.correlation[i, j])} for i, j in places]

    @property
    def correlations_text(self) -> str:
        """Correlated pairs in words; empty without correlation."""
        pairs = [f"{pair['key']} with {pair['with']} {pair['value']:g}" for pair in self.correlations]
        return f"correlation of {' and of '.join(pairs)}" if pairs else ""

    @property
    def replicates(self) -> int:
        """Number of independent sequences from which the samples are drawn."""
        return min(REPLICATES, self.n) if self.method == "sobol" else 1

    def share(self, replicate: int) -> int:
        """Return the number of samples of a replicate, given by its index among the independent sequences."""
        return self.n // self.replicates + (replicate < self.n % self.replicates)

    @property
    def sample_blocks(self) -> int:
        """Number of blocks of samples; the replicates alternate."""
        return self.replicates * -(-self.share(0) // self.size)

    @property
    def base_scenes(self) -> int:
        """Number of scenes for each base point of the sensitivity indices."""
        return len(self.inputs) + 2

    @property
    def blocks(self) -> int:
        """Number of blocks."""
        if self.records is not None:
            return math.ceil(len(self.records.suite) / self._together) * self.sample_blocks
        return self.sample_blocks + min(BATCHES, self.base)

    @property
    def _together(self) -> int:
        """Number of records in a block, chosen so that their motions fill its lanes."""
        assert self.records is not None
        return self.records.together(self.piece(0)[2])

    @property
    def shape(self) -> Shape:
        """Shape of the results: (samples + scenes of base points,), or (record, polarity, scale, sample)."""
        if self.records is not None:
            return (len(self.records.suite), *self.records.shape, self.n)
        return (self.n + self.base * self.base_scenes,)

    @property
    def outputs(self) -> ValueDict:
        """NumPy type of each result by its name."""
        names = [*RESULTS]
        if self.with_factors:
            names += [f"{FACTOR}{method}" for method in factors_by_method(self.scene, math.nan)]
        if self.search_each:
            names += [f"{FACTOR}{SEARCHED}{method}" for method in STABILITY_METHODS]
        return {name: np.dtype(_TYPES.get(name, np.float64)) for name in (*names, "status")}

    def piece(self, index: int) -> tuple[Shape, int, int]:
        """Return stream, start and length of a block of samples or base points; a last block may be empty.

        The stream is a spawn key of the random numbers, and the start a position in it.
        """
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

    def place(self, index: int) -> tuple[slice, ...]:
        """Return the slices of a block's results in arrays of `shape`."""
        group, block = divmod(index, self.sample_blocks) if self.records is not None else (0, index)
        turn, replicate = divmod(block, self.replicates)
        length = self.piece(block)[2]
        if block < self.sample_blocks:
            earlier = (self.piece(block - k)[2] for k in range(1, replicate + 1))
            start = turn * self.size * self.replicates + sum(earlier)
        else:
            start = self.n + sum(self.piece(k)[2] for k in range(self.sample_blocks, block)) * self.base_scenes
            length *= self.base_scenes
        lanes = slice(start, start + length)
        if self.records is None:
            return (lanes,)
        first = group * self._together
        return slice(first, first + self._together), slice(None), slice(None), lanes

    def scenes(self, index: int) -> int:
        """Return the number of scenes that a block solves."""
        return math.prod(len(range(*part.indices(n))) for part, n in zip(self.place(index), self.shape, strict=True))

    def points(self, index: int, dimensions: int) -> Floats:
        """Draw the points of the block with an index in the unit cube, (dimensions, count)."""
        stream, start, length = self.piece(index)
        return (sobol if self.method == "sobol" else monte_carlo)(self.seed, stream, start, length, dimensions)

    def task(self, index: int) -> tuple[Callable[[int], Columns], int]:
        """Return the function that computes a block and its argument, with the records of the block alone."""
        if self.records is None:
            return self.run_block, index
        group, block = divmod(index, self.sample_blocks)
        first = group * self._together
        return replace(self, records=self.records.part(first, first + self._together)).run_block, block

    def values(self, index: int) -> list[Floats]:
        """Return the values of each input in the scenes of a block, in the units of their keys, (scenes,) each."""
        if self.method == "grid":
            # The values of each input in the scenes of a block of a grid, in the units of their keys.
            _, start, length = self.piece(index)
            places = np.unravel_index(np.arange(start, start + length), [len(level) for level in self.levels])
            return [level[place] for level, place in zip(self.levels, places, strict=True)]
        d = len(self.inputs)
        if index < self.sample_blocks:
            return _drawn(self, self.points(index, d))
        points = self.points(index, 2 * d)  # A and B; the scenes are A, B, and A with one column of B for each input
        matrices = np.tile(points[:d, None, :], (1, d + 2, 1))
        matrices[:, 1] = points[d:]
        for k in range(d):
            matrices[k, 2 + k] = points[d + k]
        return _drawn(self, matrices)

    def samples(self) -> ArrayDict:
        """Return the values of each input at all samples by key, in the unit of the key."""
        blocks = [self.values(block) for block in range(self.sample_blocks)]
        of_inputs = zip(self.inputs.values(), zip(*blocks, strict=True), strict=True)
        return {number.key: np.concatenate(of_input) for number, of_input in of_inputs}

    def _si(self, index: int) -> ArrayDict:
        """Return the values of the inputs in the scenes of a block by name, in SI units, (scenes,) each."""
        with quiet():
            return {
                name: number.to_si(x) for (name, number), x in zip(self.inputs.items(), self.values(index), strict=True)
            }

    def run_block(self, index: int) -> Columns:
        """Compute a block and return its results by the names of `outputs`."""
        si = self._si(index)
        scene = self.scene
        shape: Shape = (-1,)
        if self.records is not None:
            scene, si, shape = self.records.lanes(scene, si, self.piece(index)[2])
        motion = motions(scene, si, self.accuracy)
        end = motion.end
        result: ValueDict = {
            **motion.outcomes,
            "end_displacement": end.displacement,
            "rotation": end.rotation,
            "slips": motion.slips,
            "outside_range": motion.outside_range,
            "status": motion.status,
        }
        del motion.end  # refers to its motion; without this only the garbage collector would free both
        by_method: ArrayDict = {}
        if self.with_factors:
            by_method = factors_by_method(motion.plan.scene, motion.factor_of_safety)
        if self.search_each:
            is_searched = (motion.status < Status.INVALID) & (index < self.sample_blocks)
            by_method |= searched_factors(self.scene, si, is_searched)
        result |= {f"{FACTOR}{method}": factor for method, factor in by_method.items()}
        return {name: np.reshape(result[name], shape).astype(kind) for name, kind in self.outputs.items()}

    @property
    def with_factors(self) -> bool:
        """Whether factors of safety are stored with the motions, as for grids and searches of every sample."""
        return self.search_each or self.method == "grid"

    def at_start(self, index: int) -> Columns:
        """Return the factors of safety of the samples of a block by method, (samples,) each, without integration."""
        return factors_at_start(self.scene, self._si(index), self.accuracy)


def _drawn(design: Design, points: Any) -> list[Floats]:
    """Return the values of each input in the unit of its key, flat, for points of the unit cube, (inputs, ...)."""
    is_correlated = np.any(design.correlation != np.eye(len(points)))
    if is_correlated:  # a Gaussian copula: normal scores are mixed
        scores = np.tensordot(np.linalg.cholesky(design.correlation), special().ndtri(points), 1)
        points = np.clip(special().ndtr(scores), 2.0**-54, 1.0 - 2.0**-53)
    by_input = zip(design.drawn.values(), points, strict=True)
    return [np.asarray(uncertain.drawn(of_input.ravel())) for uncertain, of_input in by_input]
