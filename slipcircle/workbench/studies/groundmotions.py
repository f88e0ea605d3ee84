"""Ground motions of a study: records with their scales and polarities.

The samples of records are read where they are solved, so that the memory of a study does not grow with them.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from slipcircle.base.errors import raise_all
from slipcircle.base.kinds import ArrayDict, ArrayMap, Floats, Names, Shape, Values
from slipcircle.core import Scene
from slipcircle.tables import STRONGEST, LaneSeries, Pulse, Series
from slipcircle.workbench.files.keys import Key
from slipcircle.workbench.records.suite import Entry, Suite
from slipcircle.workbench.studies.statistics import THRESHOLDS

_LANES = 256  # motions in a block, for which several records are combined


@dataclass(frozen=True)
class GroundMotions:
    """Records with their polarities and scales, as plain data."""

    suite: Suite
    polarities: tuple[float, ...]  # 1 as recorded, -1 reversed
    scales: Floats  # factors, or peak accelerations over gravity
    to_pga: bool  # whether scales are peak accelerations
    shaking: Values  # other settings of the scene's shaking
    replaces: Names  # the scene's own functions of time that the records replace
    thresholds: Floats  # of the displacement, m, of exceedance and fragility

    @property
    def shape(self) -> tuple[int, int]:
        """Numbers of polarities and scales."""
        return len(self.polarities), self.scales.size

    def together(self, samples: int) -> int:
        """Return the number of records that are solved in one call with this number of samples each."""
        return max(1, _LANES // (len(self.polarities) * self.scales.size * samples))

    def part(self, first: int, end: int) -> "GroundMotions":
        """Return the ground motions with the records at indices from ``first`` to before ``end`` only."""
        return replace(self, suite=Suite(self.suite.entries[first:end]))

    def factors(self, entry: Entry) -> Floats:
        """Return the factors by which a record is multiplied, one for each scale, (scales,)."""
        return self.scales / entry.peak if self.to_pga else self.scales

    def shaken(self, scene: Scene, record: Series | LaneSeries | Pulse) -> Scene:
        """Return the scene shaken by a record, or by one record for each lane."""
        return replace(scene, effects=scene.checked_effects | {"shaking": {**self.shaking, "horizontal": record}})

    def lanes(self, scene: Scene, si: ArrayMap, samples: int) -> tuple[Scene, ArrayDict, Shape]:
        """Return the shaken scene, its numbers by lane and the shape (record, polarity, scale, sample) of the lanes.

        ``si`` are the drawn inputs by name in SI units, (samples,) each. A lane is one motion of an ensemble.
        """
        factors = np.stack([np.multiply.outer(self.polarities, self.factors(entry)) for entry in self.suite])
        shape = (*factors.shape, samples)
        record, *_ = np.indices(shape).reshape(len(shape), -1)
        series = LaneSeries(tuple(entry.record() for entry in self.suite), record)
        numbers = {"shaking.scale": factors[..., None], **si}
        flat = {name: np.broadcast_to(values, shape).ravel() for name, values in numbers.items()}
        return self.shaken(scene, series), flat, shape


def ground_motions(
    scene: Scene, inputs: Mapping[str, Key], records: Any, settings: Values
) -> tuple[Scene, GroundMotions]:
    """Return the scene without its shaking and uncertain parameters, and the ground motions that replace its shaking.

    ``inputs`` are the uncertain parameters by name, ``records`` and ``settings`` those of `ensemble`.

    Raises
    ------
    ValueError
        If records are invalid or do not fit the scene and the scales; the message lists them.
    """
    suite = Suite.of(records, strict=settings["strict"], gravity=float(np.ravel(scene.arc.gravity)[0]))
    shaking = scene.checked_effects.get("shaking", {})
    still = {effect: parameters for effect, parameters in scene.checked_effects.items() if effect != "shaking"}
    two_way = {key: parameters for key, parameters in shaking.items() if key == "two_way"}
    replaces = tuple(name for name in ("horizontal", "vertical") if name in shaking)
    polarities = (1.0, -1.0) if settings["polarities"] else (1.0,)
    pga = settings["scale_to_pga"]
    thresholds = settings["thresholds"]
    scales = pga if pga is not None else 1.0 if settings["scales"] is None else settings["scales"]
    thresholds = THRESHOLDS if thresholds is None else thresholds
    scales, thresholds = (np.atleast_1d(np.asarray(x, float)) for x in (scales, thresholds))
    motions = GroundMotions(suite, polarities, scales, pga is not None, two_way, replaces, thresholds)
    raise_all("ensemble", [*_input_mistakes(inputs), *_record_mistakes(motions)])
    return replace(scene, effects=still, uncertain={}), motions


def _input_mistakes(inputs: Mapping[str, Key]) -> Iterator[str]:
    """Yield a message for each parameter that cannot be uncertain under records."""
    for name, number in inputs.items():
        if name.startswith("shaking."):
            yield f"{number.key}: belongs to the scene's shaking, which the records replace; leave it out"
        elif name == "gravity":
            yield f"{number.key}: must be one number with records, which are read over gravity"


def _record_mistakes(motions: GroundMotions) -> Iterator[str]:
    """Yield a message for each record that cannot be scaled."""
    for entry in motions.suite:
        if motions.to_pga and entry.peak == 0.0:
            yield f"{entry.name}: is zero at all times, so that it has no peak to scale; leave it out"
            continue
        greatest = float(np.max(motions.factors(entry))) * entry.peak
        if greatest > STRONGEST:
            yield (
                f"{entry.name}: would reach {greatest:.4g} g, and no ground has shaken with more than "
                f"{STRONGEST:g} g; give smaller scales"
            )
