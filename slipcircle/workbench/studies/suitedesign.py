"""Designs of studies over records: what shakes a scene, at which scales and in which polarities, block by block.

A block is some records with the lanes of a block of samples, which are the same for every record: so the variance can
be split into that of records and that of the soil. It reads the records itself and returns a few numbers a lane; the
memory of a study does not grow with the records' samples.
"""

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.core import Scene
from slipcircle.tables import STRONGEST, LaneSeries, Pulse, Series
from slipcircle.workbench.common.quantities import OUTCOMES
from slipcircle.workbench.files.numbers import Number
from slipcircle.workbench.records.suite import Entry, Suite
from slipcircle.workbench.studies.design import Design, Result
from slipcircle.workbench.studies.motions import motions
from slipcircle.workbench.studies.suitestatistics import THRESHOLDS

LANES = 256  # motions of a block, where a record alone has less
# Of each lane, with its unit: signed, NaN without a result, 0 of what does not move.
LANE_RESULTS: Mapping[str, str] = {
    **{name: q.unit for name, q in OUTCOMES.items()},
    "end_displacement": "m",
    "rotation": "rad",
    "slips": "",
    "outside_range": "",
}


@dataclass(frozen=True)
class SuiteDesign:
    """What is computed, as plain data."""

    sampling: Design  # of the scene without shaking, whose samples every record sees
    shaking: Mapping[str, Any]  # what the scene says of its shaking beside the record
    suite: Suite
    polarities: tuple[float, ...]  # 1 as recorded, -1 reversed
    scales: Floats  # factors, or peak accelerations over gravity
    to_pga: bool  # whether scales are peak accelerations
    replaces: tuple[str, ...]  # the scene's functions of time, in place of which the records come
    thresholds: Floats  # of the displacement, m, of exceedance and fragility

    @property
    def together(self) -> int:
        """How many records a block has: so many that their motions fill the lanes."""
        motions = len(self.polarities) * self.scales.size * self.sampling.scenes(0)
        return max(1, LANES // motions)

    @property
    def blocks(self) -> int:
        """How many blocks there are: of the first records those of their samples, and so on."""
        return math.ceil(len(self.suite) / self.together) * self.sampling.sample_blocks

    def _records(self, index: int) -> tuple[Entry, ...]:
        """The records of a block."""
        first = index // self.sampling.sample_blocks * self.together
        return self.suite.entries[first : first + self.together]

    def scenes(self, index: int) -> int:
        """How many scenes a block solves."""
        samples = self.sampling.scenes(index % self.sampling.sample_blocks)
        return len(self._records(index)) * len(self.polarities) * self.scales.size * samples

    def factors(self, entry: Entry) -> Floats:
        """What a record is multiplied by at each scale."""
        return self.scales / entry.peak if self.to_pga else self.scales

    def shaken(self, record: Series | LaneSeries | Pulse) -> Scene:
        """The scene that a record shakes, or of each lane one."""
        scene = self.sampling.scene
        assert isinstance(scene.effects, dict)
        return replace(scene, effects=scene.effects | {"shaking": {**self.shaking, "horizontal": record}})

    def task(self, index: int) -> tuple[Callable[[int], Result], int]:
        """What computes a block: the design of its records alone."""
        block = index % self.sampling.sample_blocks
        return replace(self, suite=Suite(self._records(index))).run_block, block

    def run_block(self, block: int) -> Result:
        """Compute a block of the samples of all records.

        Returns
        -------
        dict of ndarray
            `LANE_RESULTS` and ``status``, (records, polarities, scales, samples), and the samples' inputs.
        """
        inputs = self.sampling.inputs
        values = self.sampling.values(block)
        factors = np.stack([np.multiply.outer(self.polarities, self.factors(entry)) for entry in self.suite])
        shape = (*factors.shape, self.sampling.scenes(block))
        record, *_ = np.indices(shape).reshape(len(shape), -1)
        records = LaneSeries(tuple(entry.record() for entry in self.suite), record)
        lanes = {"shaking.scale": np.broadcast_to(factors[..., None], shape).ravel()}
        for (name, number), value in zip(inputs.items(), values, strict=True):
            lanes[name] = np.broadcast_to(number.to_si(value), shape).ravel()
        motion = motions(self.shaken(records), lanes, self.sampling.accuracy)
        end = motion.end
        further = {"end_displacement": end.displacement, "rotation": end.rotation, "slips": motion.slips}
        solved = {**motion.outcomes, **further, "outside_range": motion.outside_range, "status": motion.status}
        result = {name: np.reshape(lane_values, shape) for name, lane_values in solved.items()}
        samples = {f"sample.{number.key}": value for number, value in zip(inputs.values(), values, strict=True)}
        return result | samples


class OfRecords(NamedTuple):
    """How records shake a scene.

    Attributes
    ----------
    polarities : bool
        Whether each record also shakes the scene reversed.
    scales, scale_to_pga : float or array_like
        Factors on the records; or peak accelerations over gravity to which each is scaled.
    thresholds : array_like
        Displacements, m, whose exceedance and fragility are given.
    strict : bool
        Whether a file that is no record is an error; otherwise it is a warning of the study.
    """

    polarities: bool = False
    scales: Any = None
    scale_to_pga: Any = None
    thresholds: Any = None
    strict: bool = False


def suite_design(sampling: Design, records: Any, shaken: OfRecords) -> SuiteDesign:
    """The design of a study over records.

    Raises
    ------
    ValueError
        Lists what is wrong with the scene, the scales and the records.
    """
    scene = sampling.scene
    scales, to_pga = _scales(shaken)
    gravity = float(np.ravel(scene.arc.gravity)[0])
    suite = Suite.of(records, strict=shaken.strict, gravity=gravity)
    assert isinstance(scene.effects, dict)
    shaking = scene.effects.get("shaking", {})
    still = {effect: given for effect, given in scene.effects.items() if effect != "shaking"}
    sampling = replace(sampling, scene=replace(scene, effects=still, uncertain={}))
    two_way = {key: given for key, given in shaking.items() if key == "two_way"}
    replaces = tuple(name for name in ("horizontal", "vertical") if name in shaking)
    polarities = (1.0, -1.0) if shaken.polarities else (1.0,)
    thresholds = THRESHOLDS if shaken.thresholds is None else _positive("thresholds", shaken.thresholds)
    design = SuiteDesign(sampling, two_way, suite, polarities, scales, to_pga, replaces, thresholds)
    mistakes = [*_input_mistakes(sampling.inputs), *_record_mistakes(design)]
    if mistakes:
        lines = [f"ensemble: {mistake}" for mistake in mistakes]
        raise ValueError("\n".join(lines))
    return design


def _scales(shaken: OfRecords) -> tuple[Floats, bool]:
    """The scales, and whether they are peak accelerations."""
    factors = shaken.scales
    if shaken.scale_to_pga is None:
        return _positive("scales", 1.0 if factors is None else factors), False
    if factors is not None:
        raise ValueError("ensemble: scales and scale_to_pga exclude each other; leave one out")
    return _positive("scale_to_pga", shaken.scale_to_pga), True


def _positive(name: str, values: Any) -> Floats:
    """One or more positive numbers."""
    numbers = np.atleast_1d(np.asarray(values, dtype=np.float64))
    is_list = numbers.ndim == 1 and numbers.size > 0
    if not is_list or not np.all((numbers > 0.0) & (numbers < np.inf)):
        raise ValueError(f"ensemble: {name} = {numbers.tolist()!r}: must be one or more positive numbers")
    return numbers


def _input_mistakes(inputs: Mapping[str, Number]) -> Iterator[str]:
    """Numbers that cannot be uncertain where there are records."""
    for name, number in inputs.items():
        if name.startswith("shaking."):
            yield f"{number.key}: belongs to the scene's shaking, which the records replace; leave it out"
        elif name == "gravity":
            yield f"{number.key}: must be one number with records, which are read over gravity"


def _record_mistakes(design: SuiteDesign) -> Iterator[str]:
    """Records that cannot be scaled as they are to be."""
    for entry in design.suite:
        if design.to_pga and entry.peak == 0.0:
            yield f"{entry.name}: is zero at all times, so that it has no peak to scale; leave it out"
            continue
        greatest = float(np.max(design.factors(entry))) * entry.peak
        if greatest > STRONGEST:
            yield (
                f"{entry.name}: would reach {greatest:.4g} g, and no ground has shaken with more than "
                f"{STRONGEST:g} g; give smaller scales"
            )
