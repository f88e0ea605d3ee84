"""What is observed as a function of one field, followed over its range in smooth pieces, with its solutions."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from slipcircle.base.checks import EPS
from slipcircle.methods.roots import highest, root
from slipcircle.motion.plan import INTEGRATION, plan
from slipcircle.studies.fields import OBSERVED, ROUGH, Field, attempt, outputs_of
from slipcircle.studies.fit import refined

_MET = 1e-12  # relative: below the error of an integrated motion, so that no more of them are needed
_FINE = 0.02  # share by which samples are near
_STEEP = 3.0  # per cent that an output may change with a per cent of the field


@dataclass(frozen=True)
class Sample:
    """One value of the field, what comes of it, and of what kind the motion is: between two kinds it has a kink."""

    value: float
    outputs: dict[str, float]
    kind: tuple[Any, ...]


class Curve:
    """What is observed as a function of the field, in smooth pieces."""

    def __init__(self, field: Field, observed: Mapping[str, tuple[float, float | None]], values: list[float]) -> None:
        self.field, self.observed, self.span = field, observed, values[-1] - values[0]
        self.outputs = [OBSERVED[n] for n in observed]
        self.costly = plan(field.scene).method == INTEGRATION  # its kinks are found roughly, and where they matter
        values = [*values[:-1:3], values[-1]] if self.costly else values
        self.rough = ROUGH if self.costly else None
        samples = [s for v in values if (s := self.at(v, self.rough)) is not None]
        self.pieces: list[list[Sample]] = []
        for sample in samples:
            if self.pieces and self.pieces[-1][-1].kind == sample.kind:
                self.pieces[-1].append(sample)
            elif self.pieces:
                self._cut(self.pieces[-1][-1], sample)
            else:
                self.pieces.append([sample])

    @property
    def samples(self) -> Iterable[Sample]:
        """Of motions, in order."""
        return (s for piece in self.pieces for s in piece if s.kind[0])

    def at(self, value: float, accuracy: float | None = None) -> Sample | None:
        """None where there is no such scene, it never rests, or swings too long."""
        try:
            scene = self.field.scene_with(value)
        except ValueError:
            return None
        if (motion := attempt(scene, accuracy)) is None:
            return None
        kind = (motion.moves, motion.arrested, *((p.direction, p.solved.start.lifted) for p in motion.phases))
        return Sample(value, outputs_of(motion, self.outputs), kind)

    def _cut(self, low: Sample, high: Sample) -> None:
        """Halve between two samples of different kinds until neighbours are all that is left of them."""
        stack = [high]
        while stack:
            high = stack[-1]
            low = self.pieces[-1][-1]
            middle = (low.value + high.value) / 2
            sample = None
            if low.kind != high.kind and low.value < middle < high.value and not self._near(low, high):
                sample = self.at(middle, self.rough)
            if sample is None:
                stack.pop()
                if low.kind == high.kind:
                    self.pieces[-1].append(high)
                else:
                    self.pieces.append([high])
            elif sample.kind == low.kind:
                self.pieces[-1].append(sample)
            else:
                stack.append(sample)

    def _near(self, low: Sample, high: Sample) -> bool:
        """Whether they are so near that no solution hides between them."""
        gap, size = high.value - low.value, max(abs(low.value), abs(high.value), 1e-12 * self.span)
        if gap <= 4 * EPS * size:
            return True
        if self.costly:
            return gap <= 1e-4 * size or not any(self._between(low, high, gap / size, name) for name in self.observed)
        if gap > 1e-6 * size:
            return False
        return all(
            min(abs(s.outputs[OBSERVED[n]] - value) for s in (low, high)) > 1e-3 * abs(value)
            for n, (value, _) in self.observed.items()
        )

    def _between(self, low: Sample, high: Sample, share: float, name: str) -> bool:
        """Whether an observation may lie between two samples of different kinds, which differ by a share of the field.

        Near ones may have a jump between them: then a solution can only be what one of the sides still reaches.
        """
        wanted = self.observed[name][0]
        ends = [s.outputs[OBSERVED[name]] for s in (low, high)]
        if share > _FINE and min(ends) <= wanted <= max(ends):
            return True
        return any(abs(end - wanted) <= _STEEP * share * abs(end) for end in ends)

    def roots(self) -> list[float]:
        """All values with the one observation."""
        ((name, (wanted, _)),) = self.observed.items()
        output = OBSERVED[name]

        @cache
        def miss(value: float) -> float:
            sample = self.at(value)
            off = math.nan if sample is None else sample.outputs[output] - wanted
            return 0.0 if self.costly and abs(off) <= _MET * abs(wanted) else off

        found: list[float] = []

        def bracket(low: float, high: float, at_low: float, at_high: float) -> None:
            value = root(miss, low, high, at_low, at_high)
            if abs(miss(value)) <= 1e-9 * abs(wanted):  # no jump
                found.append(value)

        for piece in self.pieces:
            if not piece[0].kind[0]:
                continue
            misses = [s.outputs[output] - wanted for s in piece]
            values = [s.value for s in piece]
            found += [v for v, m in zip(values, misses, strict=True) if m == 0.0]
            for k in range(1, len(piece)):
                if misses[k - 1] * misses[k] < 0.0:
                    bracket(values[k - 1], values[k], misses[k - 1], misses[k])
            for k in range(1, len(piece) - 1):  # a hump that reaches over the observation between two samples
                sign = -1.0 if misses[k] > 0.0 else 1.0
                before, here, after = (sign * m for m in misses[k - 1 : k + 2])
                if before <= here >= after and here < 0.0 <= 2 * here - min(before, after):
                    top = highest(lambda v, sign=sign: sign * miss(v), values[k - 1], values[k + 1])  # type: ignore[misc]
                    if sign * miss(top) > 0.0:
                        bracket(values[k - 1], top, misses[k - 1], miss(top))
                        bracket(top, values[k + 1], miss(top), misses[k + 1])
        return sorted(found)

    def minima(self) -> list[float]:
        """Where the observations are best met, in the sense of least squares, in each smooth piece."""
        found = []
        sizes = np.array([sigma or abs(value) for value, sigma in self.observed.values()])
        wanted = np.array([value for value, _ in self.observed.values()])
        for piece in self.pieces:
            if not piece[0].kind[0]:
                continue
            rows = (np.array([s.outputs[o] for o in self.outputs]) for s in piece)
            misfit = [float(np.sum(((row - wanted) / sizes) ** 2)) for row in rows]
            for k, value in enumerate(misfit):
                low, high = max(k - 1, 0), min(k + 1, len(piece) - 1)
                if value > min(misfit[low], misfit[high]):
                    continue
                start, left, right = (np.array([piece[i].value]) for i in (k, low, high))
                fitted = None
                if left < right:
                    fitted = refined(self.field.scene, [self.field], self.observed, start, left, right, self.rough)
                found.append(float(start[0] if fitted is None else fitted.values[0]))
        return found
