"""Strength of a layered section as piecewise polynomials of the rotation, all with the same pieces."""

from collections.abc import Mapping
from itertools import islice
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import ArrayDict, Floats, Parameters, Shape, Texts
from slipcircle.core.scene.piecewise import Data, Tables
from slipcircle.ground.water import first_rotation, for_lanes, upright
from slipcircle.layers.profile import ROUGH
from slipcircle.layers.strength import OfRotation
from slipcircle.tables.interpolation import between_kinks, continuous

_SAMPLE = 256  # number of lanes for which the reach is estimated
_STEPS = 20  # of the rotation to upright, at which the balance is estimated
_PARTS = 8  # of a step, in which it is linear
_IN_STEP = (np.arange(_PARTS)[:, None] + 0.5) / _PARTS
_MARGIN = 1.05  # factor of the estimated reach


class RotationTables(NamedTuple):
    """Functions of the rotation as tables.

    Attributes
    ----------
    section : LayeredSection
    terms : mapping
        Terms of the soils in the balance, by the names of its parameters.
    functions : mapping
        Functions of the rotation among the terms, by the names of the program's tables.
    tolerance : float
        First neglected coefficient of a piece over the greatest one.
    upslope : bool
        Whether the mass may move above its initial position.
    shape : tuple of int
        Shape of the scene's lanes.
    """

    section: Any
    terms: Parameters
    functions: Mapping[str, OfRotation]
    tolerance: float
    upslope: bool
    shape: Shape

    def laid_out(self, reach: float = np.inf) -> Tables:
        """Return tables up to a rotation in rad, or up to loss of contact. Beyond, the functions are constant."""
        lanes = max(_lanes(function) for function in self.functions.values())
        contact_lost = upright(self.section)
        if self.share_geometry:
            farthest = contact_lost.max(keepdims=True)
        else:
            farthest = np.broadcast_to(contact_lost, (lanes,))
        last = np.minimum(farthest, reach)
        return for_lanes(self.section, self._between(first_rotation(last, self.upslope), last), self.shape)

    def reach_farther(self, data: dict[str, Data], rotation: Floats, lane: Any) -> bool:
        """Extend tables to their full range if a lane exceeds them, and return whether one does.

        `data` are the tables by name, and `lane` is the index of the lane of each rotation in rad.
        """
        if not any(_is_exceeded(data[name], rotation, lane) for name in self.functions):
            return False
        data.update(self.laid_out())
        return True

    @property
    def share_geometry(self) -> bool:
        """Whether all lanes share one circle."""
        return self.circles == 1

    @property
    def circles(self) -> int:
        """Number of circles: 1 for all lanes (members of an ensemble), or one per lane."""
        return self.section.arc_strength.rotation_kinks.shape[1]

    @property
    def names(self) -> Texts:
        """Names of the geometric parts from which the functions are summed, without repetition."""
        names = dict[str, None]()
        for function in self.functions.values():
            names |= dict.fromkeys(function.coefficients)
        return list(names)

    def _between(self, first: Floats, last: Floats) -> dict[str, Data]:
        """Return tables between rotations in rad, `first` and `last` of each circle.

        Lanes with one geometry use tables of its parts.
        """
        strength = self.section.arc_strength
        functions = self.functions
        names = self.names

        def values(rotation: Floats) -> Floats:
            parts = strength.parts(rotation, names)
            if self.share_geometry:
                return np.concatenate([parts[name] for name in names])
            return np.stack([function.combined(parts) for function in functions.values()])

        breaks, coefficients = between_kinks(values, strength.rotation_kinks, first, last, self.tolerance)
        rows = [*np.moveaxis(coefficients, 2, 0)]
        if self.share_geometry:
            breaks = breaks[:, 0]
            at_first = strength.parts(first[None], names)
            remaining = iter(rows)
            parts = {name: np.stack([*islice(remaining, len(at_first[name]))]) for name in names}
            rows = [function.combined(parts) for function in functions.values()]
            if all(row.shape[-1] == 1 for row in rows):  # a single lane
                rows = [row[..., 0] for row in rows]
        in_order = map(np.ascontiguousarray, rows)
        return {name: continuous(breaks, row) for name, row in zip(functions, in_order, strict=True)}

    def likely_reach(self, friction: Parameters) -> float:
        """Return the estimated rotation of lanes from rest, at which the least strength dissipates the work of gravity.

        The estimate, in rad, uses a sample of the lanes and a margin. `friction` are the parameters of the law. Lanes
        that move farther are integrated again with complete tables.
        """
        if self.upslope or "rate" in friction or "soils" in friction:
            return np.inf
        step = float(upright(self.section).max()) / _STEPS
        for count in _STEPS // 4, _STEPS:  # most masses rest in the first quarter
            rotation = step * np.arange(count + 1.0)
            steps = _standstill(self._net_moment(rotation[:, None], friction))
            if steps < np.inf:
                return _MARGIN * steps * step
        return np.inf

    def _net_moment(self, rotation: Floats, friction: Parameters) -> Floats:
        """Return driving moment minus least strength, over Theta*, for a sample of lanes at rotations in rad.

        Rotations and result are (M, lanes). `friction` are the parameters of the mean friction law.
        """
        moments = self.section.moment_coefficients
        count = max(np.size(moments.normal_load), np.size(self.section.arc_strength.mean_peak))
        step = 1 + count // _SAMPLE

        def of_sample(value: Any) -> Floats:
            return np.ravel(value)[::step]

        terms = self._terms_of_sample(rotation, step)
        drive = of_sample(moments.driving_moment)
        drive_slope = of_sample(moments.driving_moment_slope)
        load = of_sample(moments.normal_load)
        load_slope = of_sample(moments.normal_load_slope)
        turned_load = load + terms.get("turning", 0.0)
        turned_slope = load_slope + terms.get("turning_slope", 0.0)
        peak = friction.get("peak", friction.get("coefficient"))
        least = np.minimum(peak, friction.get("residual", peak))
        cosine = np.cos(rotation)
        sine = np.sin(rotation)
        normal = turned_load * cosine - turned_slope * sine
        beyond_mean = terms.get("normal", 0.0)
        effective = normal + beyond_mean - terms.get("lift", 0.0)
        friction_moment = of_sample(least) * effective
        resisting = np.maximum(friction_moment, 0.0)
        return drive * cosine - drive_slope * sine - resisting - terms.get("strength", 0.0)

    def _terms_of_sample(self, rotation: Floats, step: int) -> ArrayDict:
        """Return the terms of every ``step``-th lane at rotations, (M, lanes) or (lanes,)."""
        strength = self.section.arc_strength
        of_circles = np.broadcast_to(rotation, (len(rotation), self.circles))
        every_part = strength.parts(of_circles, self.names, ROUGH)
        parts = {name: part[..., ::step] for name, part in every_part.items()}
        terms = {}
        for name, term in self.terms.items():
            if isinstance(term, OfRotation):
                every_lane = term.coefficients.items()
                some = {part: values[:, ::step] for part, values in every_lane}
                terms[name] = term._replace(coefficients=some).combined(parts)
            else:
                terms[name] = np.ravel(term)[::step]
        return terms


def _standstill(moment: Floats) -> float:
    """Return the number of steps in which the work of moments from rest is used up in all lanes, infinite if it is not.

    The moments, (steps + 1, lanes), are linear in each step.
    """
    growth = np.diff(moment, axis=0)
    in_parts = moment[:-1, None] + growth[:, None] * _IN_STEP
    work = np.cumsum(in_parts.reshape(_PARTS * len(growth), -1), axis=0)
    is_used_up = work < 0.0
    if not np.all(is_used_up[-1]):
        return np.inf
    return float(1 + is_used_up.argmax(axis=0).max()) / _PARTS


def _lanes(function: OfRotation) -> int:
    """Return the number of lanes in which a function differs, 1 for a function that all lanes share."""
    return max(values.shape[1] for values in function.coefficients.values())


def _is_exceeded(table: Data, places: Floats, lane: Any) -> bool:
    """Return whether a place lies beyond the table of its lane.

    Places are arguments of the tabulated function, and `lane` is the index of the lane of each.
    """
    last = table.breaks[-1]
    if table.breaks.ndim == 2:  # each lane has other breaks
        last = last[lane]
    return bool(np.any(places > last + 1e-9))
