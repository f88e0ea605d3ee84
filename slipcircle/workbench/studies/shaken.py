"""Statistics of studies under records: displacements, regressions, fragility, and tables by record."""

import math
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from slipcircle.base.kinds import Columns, Floats, Texts
from slipcircle.base.text import number_text
from slipcircle.core import Motion, Scene, solve
from slipcircle.tables import Pulse
from slipcircle.workbench.records.suite import Suite
from slipcircle.workbench.studies.design import NO_RESULT, RESULTS, Design
from slipcircle.workbench.studies.fragility import FragilityCurve, fragility_curve
from slipcircle.workbench.studies.groundmotions import GroundMotions
from slipcircle.workbench.studies.motions import motions
from slipcircle.workbench.studies.statistics import exceedance_probabilities, exceedance_shares
from slipcircle.workbench.suites.intensities import spectral_acceleration
from slipcircle.workbench.suites.regressions import RIGID, Comparison, Shaking, comparisons


class Shaken:
    """Part of a study that concerns its records."""

    design: Design
    values: Columns

    @property
    def scene(self) -> Scene:
        """Scene whose parameters vary; with records, without its own shaking."""
        return self.design.scene

    @property
    def records(self) -> GroundMotions:
        """Ground motions; a ValueError if the study does not have any."""
        if self.design.records is None:
            raise ValueError("Study: it does not have records; give ensemble(..., records=...)")
        return self.design.records

    @property
    def suite(self) -> Suite:
        """Suite of the records."""
        return self.records.suite

    @property
    def polarities(self) -> Floats:
        """Polarities: 1 for records as they are, -1 for reversed records."""
        return np.array(self.records.polarities)

    @property
    def scales(self) -> Floats:
        """Scale factors of the records, or peak accelerations over gravity if ``records.to_pga``."""
        return self.records.scales

    @property
    def displacement(self) -> Floats:
        """Permanent displacement along the arc, m, (record, polarity, scale, sample); infinite without a result."""
        return np.where(np.isin(self.values["status"], NO_RESULT), np.inf, np.abs(self.values["end_displacement"]))

    @property
    def factors(self) -> Floats:
        """Factors by which records are multiplied, (record, scale)."""
        return np.stack([self.records.factors(entry) for entry in self.suite])

    @property
    def pga(self) -> Floats:
        """Peak accelerations of the scaled records over gravity, (record, scale)."""
        return self.factors * np.array([[entry.peak] for entry in self.suite])

    @cached_property
    def yield_coefficient(self) -> float:
        """Yield coefficient k_y of the shaken scene at the medians of its uncertain parameters."""
        return float(solve(self.records.shaken(self.scene, Pulse("rectangular", 0.0, 0.0, 1.0))).yield_coefficient)

    @cached_property
    def block_factor(self) -> float:
        """Gamma, the acceleration along the arc over that of a rigid block of equal k_y; NaN if k_y is negative.

        It is computed from the velocity after 1 ms of an acceleration 0.1 g above k_y.
        """
        if not 0.0 < self.yield_coefficient < math.inf:
            return math.nan
        pulse = Pulse("rectangular", self.yield_coefficient + 0.1, 0.0, 1e-3)
        shaken = replace(self.scene, effects=self.scene.checked_effects | {"shaking": {"horizontal": pulse}})
        gravity = float(np.ravel(self.scene.arc.gravity)[0])
        return float(solve(shaken).outcomes["peak_velocity"]) / (0.1 * gravity * 1e-3)

    def regressions(self, scale: int, magnitude: float = math.nan, period: float = 0.0) -> list[Comparison]:
        """Return comparisons of the displacements at a scale with published regressions of sliding blocks.

        The displacement of a record is the mean over polarities of the median over samples, divided by `block_factor`.

        Parameters
        ----------
        scale : int
            Place of the scale in `scales`.
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
        """Return the displacement of each record in m at the scale with an index, (records,).

        It is the mean over polarities of the median over samples.
        """
        return np.median(self.displacement[:, :, scale], axis=-1).mean(axis=1)

    def fragility(self) -> list[FragilityCurve]:
        """Return lognormal fragility curves over the peak acceleration, one for each threshold of the displacement."""
        thresholds = self.records.thresholds.tolist()
        displacement = self.displacement
        pga = self.pga
        return [fragility_curve(exceedance_shares(displacement, t), pga, t) for t in thresholds]

    def fragility_columns(self) -> dict[str, list[Any]]:
        """Return the shares of exceedance and fragility curves as columns, a row for each threshold and scale.

        Both have 95 % intervals. The curve is evaluated at the median peak acceleration of the scale; the column
        ``reason`` explains a missing curve.
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
        shares = np.array(exceedance_probabilities(self.displacement, self.records.thresholds))
        blocks = []
        for k, curve in enumerate(curves):
            threshold = np.full(levels.size, curve.threshold)
            blocks.append(np.stack([threshold, self.scales, levels, *shares[:, k].T, *curve.probability(levels)]))
        rows = np.concatenate(blocks, axis=1).tolist()
        columns = {
            name: [None if math.isnan(value) else value for value in row] for name, row in zip(names, rows, strict=True)
        }
        return columns | {"reason": np.repeat([curve.reason for curve in curves], levels.size).tolist()}

    def median_record(self, scale: int) -> int:
        """Return the index of the record with the median displacement at the scale with an index.

        Of two middle records it is the lower one.
        """
        order = np.argsort(self._by_record(scale), kind="stable")
        return int(order[(order.size - 1) // 2])

    def motions_of(self, record: int, scale: int) -> list[Motion]:
        """Return the motions under a record at a scale, both given by index: one for each polarity.

        Uncertain parameters have their medians.
        """
        unscaled = self.suite.entries[record].record()
        factors = (self.factors[record, scale] * self.polarities).tolist()
        shaken = [self.records.shaken(self.scene, unscaled.scaled(factor)) for factor in factors]
        return [solve(scene, self.design.accuracy) for scene in shaken]

    @property
    def own_scale(self) -> int:
        """Index of the scale at which the records are nearest to unscaled."""
        return int(np.argmin(np.abs(self.factors - 1.0).max(axis=0)))

    def scale_text(self, scale: int) -> str:
        """Return a scale, given by its place, in words."""
        value = number_text(float(self.scales[scale]))
        return f"a peak of {value} g" if self.records.to_pga else f"scale {value}"

    def _record_warnings(self) -> Texts:
        """Return warnings about the record files and about motion without shaking."""
        messages = [f"the records replace the scene's own {name} shaking" for name in self.records.replaces]
        messages += self.suite.warnings
        if bool(np.any(motions(self.scene, {}, self.design.accuracy).moves)):
            messages.append("the mass also moves without shaking: displacements are not due to the records alone")
        return messages

    def by_record(self, scale: int = 0) -> dict[str, list[Any]]:
        """Return a table of the records at a scale as columns by name, with medians over the samples.

        Columns are the displacement for each polarity and their mean, m, and, as the greater of both polarities, the
        peak velocity, m/s, the number of slips and the rotation, rad.
        """
        columns = {"record": [entry.name for entry in self.suite], "pga_g": self.pga[:, scale].tolist()}
        medians = {n: np.median(np.abs(self.values[n][:, :, scale]), axis=-1) for n in RESULTS}
        both = medians["end_displacement"]
        for place, polarity in enumerate(self.records.polarities):
            columns["displacement_m" if polarity > 0.0 else "reversed_m"] = both[:, place].tolist()
        if len(self.records.polarities) > 1:
            columns["mean_m"] = both.mean(axis=1).tolist()
        for name, head in (("peak_velocity", "peak_velocity_m_s"), ("slips", "slips"), ("rotation", "rotation_rad")):
            columns[head] = medians[name].max(axis=1).tolist()
        return columns
