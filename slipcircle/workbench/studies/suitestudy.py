"""Results of studies over records: a scene shaken by each record of a suite, in both polarities, at several scales."""

import math
from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.forms import Pictured
from slipcircle.base.kinds import Floats
from slipcircle.base.optional import optional
from slipcircle.base.text import shown
from slipcircle.core import Motion, Scene, Status, solve
from slipcircle.tables import Pulse
from slipcircle.words import OUTSIDE
from slipcircle.workbench.common.quantities import plain
from slipcircle.workbench.studies.design import NO_RESULT, RESULTS, Design
from slipcircle.workbench.studies.fragility import FragilityCurve, fragility_curve
from slipcircle.workbench.studies.motions import motions
from slipcircle.workbench.studies.statistics import distribution, exceedance, exceedance_shares
from slipcircle.workbench.suites.intensities import spectral_acceleration
from slipcircle.workbench.suites.regressions import RIGID, Comparison, Shaking, comparisons

DIMENSIONS = ("record", "polarity", "scale", "sample")


class SuiteStudy(Pictured):
    """Motions of a scene under each record of a suite.

    Attributes
    ----------
    design : Design
    suite : Suite
    polarities, scales : ndarray
        1 as recorded and -1 reversed; factors, or peak accelerations over gravity (`design.to_pga`).
    values : mapping of str to ndarray
        ``run_out``, ``peak_velocity``, ``duration``, ``end_displacement`` (permanent), ``rotation`` (at the end, rad),
        ``slips`` (how often it begins to slide), ``outside_range`` and ``status`` (`Status`), each (record, polarity,
        scale, sample), SI; signed, 0 of what does not move, NaN without a result.
    samples : mapping of str to ndarray
        Values of the uncertain numbers by key, in its unit; the same for every record.
    """

    def __init__(self, design: Design, values: Mapping[str, NDArray[Any]], damaged: int = 0) -> None:
        assert design.records is not None
        self.design, self.records, self.suite = design, design.records, design.records.suite
        self.polarities, self.scales = np.array(self.records.polarities), self.records.scales
        self.values, self.damaged = values, damaged
        self.samples = design.samples()

    @property
    def scene(self) -> Scene:
        """The scene without shaking."""
        return self.design.scene

    @property
    def displacement(self) -> Floats:
        """Permanent displacement along the arc, m, (record, polarity, scale, sample); infinite without a result."""
        without_result = np.isin(self.values["status"], NO_RESULT)
        permanent = np.abs(self.values["end_displacement"])
        return np.where(without_result, np.inf, permanent)

    @property
    def factors(self) -> Floats:
        """What each record is multiplied by, (record, scale)."""
        return np.stack([self.records.factors(entry) for entry in self.suite])

    @property
    def pga(self) -> Floats:
        """Peak accelerations of the scaled records over gravity, (record, scale)."""
        return self.factors * np.array([[entry.peak] for entry in self.suite])

    @cached_property
    def yield_coefficient(self) -> float:
        """Return k_y of the shaken scene at the medians of its uncertain numbers."""
        return float(solve(self.records.shaken(self.scene, Pulse("rectangular", 0.0, 0.0, 1.0))).yield_coefficient)

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

    def regressions(self, scale: int, magnitude: float = math.nan, period: float = 0.0) -> list[Comparison]:
        """Displacements at a scale beside published regressions of sliding blocks.

        Of each record the mean of polarities and the median of samples, over `block_factor`.

        Parameters
        ----------
        scale : int
        magnitude : float
            Moment magnitude of the earthquakes; without it the regressions that need it are left out.
        period : float
            Initial fundamental period of the sliding mass, s, for Bray and Travasarou (2007); below 0.05 s it is rigid.
        """
        if not 0.0 <= period < math.inf:
            raise ValueError(f"period = {period!r}: must be at least 0 s and finite")
        if math.isnan(self.block_factor):
            return []
        by_record = self._by_record(scale)
        factors = self.factors[:, scale]
        pgv, arias = np.array([(e.intensities.pgv, e.intensities.arias) for e in self.suite]).T
        spectral = None
        if period >= RIGID:
            spectral = factors * [spectral_acceleration(entry.record(), 1.5 * period) for entry in self.suite]
        measures = self.pga[:, scale], factors * pgv, factors**2 * arias
        shaking = Shaking(self.yield_coefficient, *measures, magnitude, period, spectral)
        return comparisons(by_record / self.block_factor, shaking)

    def _by_record(self, scale: int) -> Floats:
        """Displacement of each record at a scale, m: mean of polarities, median of samples."""
        return np.median(self.displacement[:, :, scale], axis=-1).mean(axis=1)

    def fragility(self) -> list[FragilityCurve]:
        """Lognormal fragility curves of the thresholds over the peak acceleration, by `fragility_curve`."""
        thresholds = self.records.thresholds.tolist()
        displacement, pga = self.displacement, self.pga
        return [fragility_curve(exceedance_shares(displacement, t), pga, t) for t in thresholds]

    def fragility_columns(self) -> dict[str, list[Any]]:
        """Exceedance at every threshold and scale, in columns: of the motions, and of the fragility curve.

        Each with its interval of 95 %, the curve at the median peak acceleration of the scale; or why there is none.
        """
        names = [
            "threshold_m",
            "scale",
            "median_pga_g",
            "share",
            "share_low",
            "share_high",
            "curve",
            "curve_low",
            "curve_high",
        ]
        levels = np.median(self.pga, axis=0)
        curves = self.fragility()
        shares = np.array(exceedance(self.displacement, self.records.thresholds))
        blocks = []
        for k, curve in enumerate(curves):
            threshold = np.full(levels.size, curve.threshold)
            fitted = curve.probability(levels)
            blocks.append(np.stack([threshold, self.scales, levels, *shares[:, k].T, *fitted]))
        rows = np.concatenate(blocks, axis=1).tolist()
        columns: dict[str, list[Any]] = {
            name: [None if math.isnan(value) else value for value in row] for name, row in zip(names, rows, strict=True)
        }
        reasons = np.repeat([curve.reason for curve in curves], levels.size)
        return columns | {"reason": reasons.tolist()}

    def median_record(self, scale: int) -> int:
        """The place of the record with the median displacement at a scale, the lower one of two."""
        order = np.argsort(self._by_record(scale), kind="stable")
        return int(order[(order.size - 1) // 2])

    def motions_of(self, record: int, scale: int) -> list[Motion]:
        """The motions under a record at a scale, by their places, one a polarity, at medians of uncertain numbers."""
        unscaled = self.suite.entries[record].record()
        motions = []
        for factor in (self.factors[record, scale] * self.polarities).tolist():
            shaken = self.records.shaken(self.scene, unscaled.scaled(factor))
            motions.append(solve(shaken, self.design.accuracy))
        return motions

    @property
    def own_scale(self) -> int:
        """The place of the scale at which the records are next to as they are."""
        return int(np.argmin(np.abs(self.factors - 1.0).max(axis=0)))

    def scale_text(self, scale: int) -> str:
        """A scale, by its place, in words."""
        value = shown(float(self.scales[scale]))
        return f"a peak of {value} g" if self.records.to_pga else f"scale {value}"

    @property
    def warnings(self) -> list[str]:
        """Warnings about files and results."""
        found = [f"the records replace the scene's own {name} shaking" for name in self.records.replaces]
        found += self.suite.warnings
        if bool(np.any(motions(self.scene, {}, self.design.accuracy).moves)):
            found.append("the mass moves without shaking too: displacements are not those of the records alone")
        statuses = self.values["status"].ravel()
        for status, count in zip(Status, np.bincount(statuses, minlength=len(Status)), strict=True):
            share = f"{count} of {statuses.size}"
            if count and status.reason:
                found.append(f"{share} motions have no result: {status.reason}")
            elif count and status is Status.MOVING:
                found.append(f"{share} still move at their end: displacements are those until then")
        if count := np.count_nonzero(self.values["outside_range"]):
            found.append(f"{count} of {statuses.size} motions move {OUTSIDE}")
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
        columns: dict[str, list[Any]] = {
            "record": [entry.name for entry in self.suite],
            "pga_g": self.pga[:, scale].tolist(),
        }
        medians = {n: np.median(np.abs(self.values[n][:, :, scale]), axis=-1) for n in RESULTS}
        both = medians["end_displacement"]
        for place, polarity in enumerate(self.records.polarities):
            columns["displacement_m" if polarity > 0.0 else "reversed_m"] = both[:, place].tolist()
        if len(self.records.polarities) > 1:
            columns["mean_m"] = both.mean(axis=1).tolist()
        for name, head in (("peak_velocity", "peak_velocity_m_s"), ("slips", "slips"), ("rotation", "rotation_rad")):
            columns[head] = medians[name].max(axis=1).tolist()
        return columns

    def columns(self) -> dict[str, NDArray[Any]]:
        """Every motion as one row of columns by name: its record, polarity, scale, sample, inputs, results, status."""
        statuses = self.values["status"]
        record, polarity, scale, sample = np.indices(statuses.shape).reshape(len(DIMENSIONS), -1)
        records = np.array([entry.name for entry in self.suite])
        words = np.array([status.name for status in Status])
        columns = {
            "record": records[record],
            "polarity": self.polarities[polarity],
            "scale": self.scales[scale],
            "sample": sample,
            "factor": self.factors[record, scale],
            "pga_g": self.pga[record, scale],
        }
        columns |= {key: values[sample] for key, values in self.samples.items()}
        columns |= {name: self.values[name].ravel() for name in RESULTS}
        return columns | {"status": words[statuses.ravel()]}

    def to_pandas(self) -> Any:
        """Every motion as a row of a pandas.DataFrame, indexed by record, polarity, scale and sample."""
        return optional("pandas", "to_pandas").DataFrame(self.columns()).set_index([*DIMENSIONS])

    def to_xarray(self) -> Any:
        """An xarray.Dataset over record, polarity, scale and sample, with units."""
        along = {name: (DIMENSIONS, self.values[name], {"units": unit}) for name, unit in RESULTS.items()}
        status = {"status": (DIMENSIONS, self.values["status"])}
        coordinates: dict[str, Any] = {
            "record": [entry.name for entry in self.suite],
            "polarity": self.polarities,
            "scale": self.scales,
            "factor": (("record", "scale"), self.factors),
            "pga_g": (("record", "scale"), self.pga),
        }
        coordinates |= {key: ("sample", values) for key, values in self.samples.items()}
        return optional("xarray", "to_xarray").Dataset(along | status, coordinates)

    def arrays(self) -> dict[str, NDArray[Any]]:
        """The same as plain arrays by name, for NPZ."""
        named = {f"sample_{key}": values for key, values in self.samples.items()}
        names = np.array([entry.name for entry in self.suite])
        axes = {"record": names, "polarity": self.polarities, "scale": self.scales}
        return axes | {"factor": self.factors, "pga_g": self.pga, **self.values, **named}

    def to_dict(self) -> dict[str, Any]:
        """The study for JSON: its records, axes and results, (record, polarity, scale, sample), in SI units."""
        sampling = self.design
        described = {
            "scene": self.scene.name,
            **self.suite.to_dict(),
            "polarities": self.records.polarities,
            "scale_is": "pga_g" if self.records.to_pga else "factor",
            "yield_coefficient": self.yield_coefficient,
            "block_factor": self.block_factor,
            "seed": sampling.seed,
            "method": sampling.method,
            "accuracy": sampling.accuracy,
            "inputs": [uncertain.record for uncertain in sampling.drawn.values()],
            "correlation": sampling.correlations,
            "distribution": [
                {"scale": scale} | distribution(self.displacement, k)._asdict()
                for k, scale in enumerate(self.scales.tolist())
            ],
            "fragility": [curve.to_dict() for curve in self.fragility()],
            "exceedance": self.fragility_columns(),
            "median_record": self.suite.entries[self.median_record(self.own_scale)].name,
            "warnings": self.warnings,
        }
        results = {name: values for name, values in self.arrays().items() if name not in ("record", "polarity")}
        return dict(plain(described | results))
