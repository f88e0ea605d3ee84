"""Studies over records: a scene shaken by each record of a suite, in both polarities, at several scales.

A block is one record with the lanes of a block of samples, which are the same for every record: so the variance can be
split into that of records and that of the soil. It reads the record itself and returns a few numbers a lane; the memory
of a study does not grow with the records' samples.
"""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, TypedDict

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.series import Pulse, Series
from slipcircle.base.text import shown
from slipcircle.core import STRONGEST, Pictured, Scene, Status, solve
from slipcircle.workbench.common.forms import library
from slipcircle.workbench.common.quantities import OUTCOMES, plain
from slipcircle.workbench.files.numbers import Number
from slipcircle.workbench.records.suite import Entry, Suite
from slipcircle.workbench.studies.design import NO_RESULT, Design, Result
from slipcircle.workbench.studies.motions import motions
from slipcircle.workbench.suites.regressions import Comparison, Shaking, comparisons
from slipcircle.workbench.suites.statistics import distribution

Floats = NDArray[np.float64]
DIMENSIONS = ("record", "polarity", "scale", "sample")
# Of each lane, with its unit: signed, NaN without a result, 0 of what does not move.
LANE_RESULTS: Mapping[str, str] = {name: q.unit for name, q in OUTCOMES.items()} | {"rotation": "rad", "slips": ""}


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

    @property
    def blocks(self) -> int:
        """How many blocks there are: of each record those of its samples."""
        return len(self.suite) * self.sampling.sample_blocks

    def scenes(self, index: int) -> int:
        """How many scenes a block solves."""
        samples = self.sampling.scenes(index % self.sampling.sample_blocks)
        return len(self.polarities) * self.scales.size * samples

    def factors(self, entry: Entry) -> Floats:
        """What a record is multiplied by at each scale."""
        return self.scales / entry.peak if self.to_pga else self.scales

    def shaken(self, record: Series) -> Scene:
        """The scene that a record shakes."""
        scene = self.sampling.scene
        assert isinstance(scene.effects, dict)
        return replace(scene, effects=scene.effects | {"shaking": {**self.shaking, "horizontal": record}})

    def task(self, index: int) -> tuple[Callable[[int], Result], int]:
        """What computes a block: the design of its record alone."""
        record, block = divmod(index, self.sampling.sample_blocks)
        return replace(self, suite=Suite(self.suite.entries[record : record + 1])).run_block, block

    def run_block(self, block: int) -> Result:
        """Compute a block of the samples of the first record.

        Returns
        -------
        dict of ndarray
            `LANE_RESULTS` and ``status``, (polarities, scales, samples), and the samples' inputs.
        """
        entry, inputs = self.suite.entries[0], self.sampling.inputs
        values = self.sampling.values(block)
        factors = np.multiply.outer(self.polarities, self.factors(entry))[..., None]
        shape = (*factors.shape[:2], self.sampling.scenes(block))
        lanes = {"shaking.scale": np.broadcast_to(factors, shape).ravel()}
        for (name, number), value in zip(inputs.items(), values, strict=True):
            lanes[name] = np.broadcast_to(number.to_si(value), shape).ravel()
        motion = motions(self.shaken(entry.record()), lanes, self.sampling.accuracy)
        solved = {**motion.outcomes, "rotation": motion.end.rotation, "slips": motion.slips, "status": motion.status}
        result = {name: np.reshape(lane_values, shape) for name, lane_values in solved.items()}
        return result | {f"sample.{n.key}": v for n, v in zip(inputs.values(), values, strict=True)}


class OfRecords(TypedDict, total=False):
    """How records shake a scene.

    Attributes
    ----------
    polarities : bool
        Whether each record also shakes the scene reversed.
    scales, scale_to_pga : float or array_like
        Factors on the records; or peak accelerations over gravity to which each is scaled.
    strict : bool
        Whether a file that is no record is an error; otherwise it is a warning of the study.
    """

    polarities: bool
    scales: Any
    scale_to_pga: Any
    strict: bool


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
    suite = Suite.of(records, strict=shaken.get("strict", False), gravity=gravity)
    assert isinstance(scene.effects, dict)
    shaking = scene.effects.get("shaking", {})
    still = {effect: given for effect, given in scene.effects.items() if effect != "shaking"}
    sampling = replace(sampling, scene=replace(scene, effects=still, uncertain={}))
    two_way = {key: given for key, given in shaking.items() if key == "two_way"}
    replaces = tuple(name for name in ("horizontal", "vertical") if name in shaking)
    polarities = (1.0, -1.0) if shaken.get("polarities") else (1.0,)
    design = SuiteDesign(sampling, two_way, suite, polarities, scales, to_pga, replaces)
    if mistakes := [*_input_mistakes(sampling.inputs), *_record_mistakes(design)]:
        raise ValueError("\n".join(f"ensemble: {mistake}" for mistake in mistakes))
    return design


def _scales(shaken: OfRecords) -> tuple[Floats, bool]:
    """The scales, and whether they are peak accelerations."""
    given = {name: shaken.get(name) for name in ("scales", "scale_to_pga") if shaken.get(name) is not None}
    if len(given) > 1:
        raise ValueError("ensemble: scales and scale_to_pga exclude each other; leave one out")
    name, values = next(iter(given.items()), ("scales", 1.0))
    scales = np.atleast_1d(np.asarray(values, dtype=np.float64))
    if scales.ndim != 1 or not scales.size or not np.all((scales > 0.0) & (scales < np.inf)):
        raise ValueError(f"ensemble: {name} = {scales.tolist()!r}: must be one or more positive numbers")
    return scales, name == "scale_to_pga"


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
            yield f"{entry.name}: is zero at all times, so that it has no peak to scale"
        elif (peak := float(np.max(design.factors(entry))) * entry.peak) > STRONGEST:
            yield (
                f"{entry.name}: would reach {peak:.4g} g, and no ground has shaken with more than {STRONGEST:g} g; "
                "give smaller scales"
            )


class SuiteStudy(Pictured):
    """Motions of a scene under each record of a suite.

    Attributes
    ----------
    design : SuiteDesign
    suite : Suite
    polarities, scales : ndarray
        1 as recorded and -1 reversed; factors, or peak accelerations over gravity (`design.to_pga`).
    values : mapping of str to ndarray
        ``reach``, ``run_out``, ``peak_velocity``, ``duration``, ``rotation`` (of the end, rad), ``slips`` (how often it
        begins to slide) and ``status`` (`Status`), each (record, polarity, scale, sample), SI; signed, 0 of what does
        not move, NaN without a result.
    samples : mapping of str to ndarray
        Values of the uncertain numbers by key, in its unit; the same for every record.
    """

    def __init__(self, design: SuiteDesign, results: Iterable[Result]) -> None:
        self.design, self.suite = design, design.suite
        self.polarities, self.scales = np.array(design.polarities), design.scales
        per_record = design.sampling.sample_blocks
        rows: list[dict[str, NDArray[Any]]] = []
        blocks: list[Result] = []
        for result in results:
            blocks.append(result)
            if len(blocks) == per_record:
                rows.append({name: np.concatenate([block[name] for block in blocks], axis=-1) for name in result})
                blocks = []
        self.values = {name: np.stack([row[name] for row in rows]) for name in (*LANE_RESULTS, "status")}
        self.samples = {number.key: rows[0][f"sample.{number.key}"] for number in design.sampling.inputs.values()}

    @property
    def scene(self) -> Scene:
        """The scene without shaking."""
        return self.design.sampling.scene

    @property
    def displacement(self) -> Floats:
        """Permanent displacement along the arc, m, (record, polarity, scale, sample); infinite without a result."""
        without_result = np.isin(self.values["status"], NO_RESULT)
        return np.where(without_result, np.inf, np.abs(self.values["run_out"]))

    @property
    def factors(self) -> Floats:
        """What each record is multiplied by, (record, scale)."""
        return np.stack([self.design.factors(entry) for entry in self.suite])

    @property
    def pga(self) -> Floats:
        """Peak accelerations of the scaled records over gravity, (record, scale)."""
        return self.factors * np.array([[entry.peak] for entry in self.suite])

    @cached_property
    def yield_coefficient(self) -> float:
        """k_y of the scene at the medians of its uncertain numbers."""
        return float(solve(self.scene).yield_coefficient)

    @cached_property
    def block_factor(self) -> float:
        """Gamma, the acceleration along the arc over that of a rigid block with the same k_y; NaN if k_y is negative.

        From the velocity after a millisecond at 0.1 g beyond k_y, in which nothing else changes.
        """
        if not 0.0 < self.yield_coefficient < math.inf:
            return math.nan
        pulse = Pulse("rectangular", self.yield_coefficient + 0.1, 0.0, 1e-3)
        assert isinstance(self.scene.effects, dict)
        shaken = replace(self.scene, effects=self.scene.effects | {"shaking": {"horizontal": pulse}})
        gravity = float(np.ravel(self.scene.arc.gravity)[0])
        return float(solve(shaken).outcomes["peak_velocity"]) / (0.1 * gravity * 1e-3)

    def regressions(self, scale: int, magnitude: float = math.nan) -> list[Comparison]:
        """Displacements at a scale beside published regressions of rigid blocks.

        Of each record the mean of polarities and the median of samples, over `block_factor`.
        """
        if math.isnan(self.block_factor):
            return []
        by_record = np.median(self.displacement[:, :, scale], axis=-1).mean(axis=1)
        factors = self.factors[:, scale]
        pgv, arias = np.array([(e.intensities.pgv, e.intensities.arias) for e in self.suite]).T
        shaking = Shaking(self.yield_coefficient, self.pga[:, scale], factors * pgv, factors**2 * arias, magnitude)
        return comparisons(by_record / self.block_factor, shaking)

    @property
    def own_scale(self) -> int:
        """The place of the scale at which the records are next to as they are."""
        return int(np.argmin(np.abs(self.factors - 1.0).max(axis=0)))

    def scale_text(self, scale: int) -> str:
        """A scale, by its place, in words."""
        value = shown(float(self.scales[scale]))
        return f"a peak of {value} g" if self.design.to_pga else f"scale {value}"

    @property
    def warnings(self) -> list[str]:
        """Warnings about files and results."""
        found = [f"the records replace the scene's own {name} shaking" for name in self.design.replaces]
        found += [f"{unread}; not used" for unread in self.suite.unread]
        found += [f"{entry.name}: is a vertical component by its name; not used" for entry in self.suite.verticals]
        if bool(np.any(motions(self.scene, {}, self.design.sampling.accuracy).moves)):
            found.append("the mass moves without shaking too: displacements are not those of the records alone")
        counts, total = np.bincount(self.values["status"].ravel(), minlength=len(Status)), self.values["status"].size
        for status in (s for s in Status if counts[s]):
            if status.reason:
                found.append(f"{counts[status]} of {total} motions have no result: {status.reason}")
            elif status is Status.MOVING:
                found.append(f"{counts[status]} of {total} still move at their end: displacements are those until then")
        return found

    def __repr__(self) -> str:
        sizes = ", ".join(f"{name}: {n}" for name, n in zip(DIMENSIONS, self.values["status"].shape, strict=True))
        return f"<SuiteStudy {self.scene.name}: {sizes}>"

    # -- tables -------------------------------------------------------------------------------------------------------

    def by_record(self, scale: int = 0) -> dict[str, list[Any]]:
        """A table of the records at one of the scales: columns by their heads, medians over the samples.

        Displacement of each polarity and their mean, m; of both the greatest peak velocity, m/s, and rotation, rad,
        and the most slips.
        """
        columns: dict[str, list[Any]] = {"record": [entry.name for entry in self.suite]}
        columns["pga_g"] = self.pga[:, scale].tolist()
        medians = {n: np.median(np.abs(self.values[n][:, :, scale]), axis=-1) for n in LANE_RESULTS}
        both = medians["run_out"]
        for place, polarity in enumerate(self.design.polarities):
            columns["displacement_m" if polarity > 0.0 else "reversed_m"] = both[:, place].tolist()
        if len(self.design.polarities) > 1:
            columns["mean_m"] = both.mean(axis=1).tolist()
        for name, head in (("peak_velocity", "peak_velocity_m_s"), ("slips", "slips"), ("rotation", "rotation_rad")):
            columns[head] = medians[name].max(axis=1).tolist()
        return columns

    def columns(self) -> dict[str, NDArray[Any]]:
        """Every motion as one row of columns by name: its record, polarity, scale, sample, inputs, results, status."""
        shape = self.values["status"].shape
        record, polarity, scale, sample = (places.ravel() for places in np.indices(shape))
        columns = {
            "record": np.array([entry.name for entry in self.suite])[record],
            "polarity": self.polarities[polarity],
            "scale": self.scales[scale],
            "sample": sample,
            "factor": self.factors[record, scale],
            "pga_g": self.pga[record, scale],
        }
        columns |= {key: values[sample] for key, values in self.samples.items()}
        columns |= {name: self.values[name].ravel() for name in LANE_RESULTS}
        return columns | {"status": np.array([s.name for s in Status])[self.values["status"].ravel()]}

    def to_pandas(self) -> Any:
        """Every motion as a row of a pandas.DataFrame, indexed by record, polarity, scale and sample."""
        return library("pandas").DataFrame(self.columns()).set_index([*DIMENSIONS])

    def to_xarray(self) -> Any:
        """An xarray.Dataset over record, polarity, scale and sample, with units."""
        along = {name: (DIMENSIONS, self.values[name], {"units": unit}) for name, unit in LANE_RESULTS.items()}
        coordinates: dict[str, Any] = {
            "record": [entry.name for entry in self.suite],
            "polarity": self.polarities,
            "scale": self.scales,
            "factor": (("record", "scale"), self.factors),
            "pga_g": (("record", "scale"), self.pga),
        }
        coordinates |= {key: ("sample", values) for key, values in self.samples.items()}
        return library("xarray").Dataset(along | {"status": (DIMENSIONS, self.values["status"])}, coordinates)

    def arrays(self) -> dict[str, NDArray[Any]]:
        """The same as plain arrays by name, for NPZ."""
        named = {f"sample_{key}": values for key, values in self.samples.items()}
        names = np.array([entry.name for entry in self.suite])
        axes = {"record": names, "polarity": self.polarities, "scale": self.scales}
        return axes | {"factor": self.factors, "pga_g": self.pga} | self.values | named

    def to_dict(self) -> dict[str, Any]:
        """The study for JSON: its records, axes and results, (record, polarity, scale, sample), in SI units."""
        known = ("name", "file", "station", "component", "samples", "step", "unit")
        sampling = self.design.sampling
        described = {
            "scene": self.scene.name,
            "records": [
                {name: getattr(entry, name) for name in known} | entry.intensities._asdict() for entry in self.suite
            ],
            "verticals": [entry.name for entry in self.suite.verticals],
            "pairs": [[entry.name for entry in pair] for pair in self.suite.pairs],
            "not_read": [unread._asdict() for unread in self.suite.unread],
            "polarities": self.design.polarities,
            "scale_is": "pga_g" if self.design.to_pga else "factor",
            "yield_coefficient": self.yield_coefficient,
            "block_factor": self.block_factor,
            "seed": sampling.seed,
            "method": sampling.method,
            "accuracy": sampling.accuracy,
            "inputs": [uncertain.record for uncertain in sampling.drawn.values()],
            "distribution": [
                {"scale": scale} | distribution(self.displacement, k)._asdict()
                for k, scale in enumerate(self.scales.tolist())
            ],
            "warnings": self.warnings,
        }
        results = {name: values for name, values in self.arrays().items() if name not in ("record", "polarity")}
        return dict(plain(described | results))
