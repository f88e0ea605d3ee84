"""The strength of a layered section as piecewise polynomials of the rotation, all with the same pieces."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import Floats, Parameters
from slipcircle.core.scene.piecewise import Data, continuous
from slipcircle.ground.water import first_rotation, upright
from slipcircle.layers.strength import OfRotation
from slipcircle.tables.interpolation import between_kinks

_SAMPLE = 256  # lanes whose reach is estimated
_SHARES = np.linspace(0.0, 1.0, 41)  # of the rotation to upright, at which the energy is estimated
_MARGIN = 1.2  # on the estimated reach


class RotationTables(NamedTuple):
    """Functions of the rotation as tables.

    Attributes
    ----------
    section : LayeredSection
    terms : mapping
        Terms of the balance that belong to the soils, by the names of its parameters.
    functions : mapping
        Those that are functions of the rotation, by the names of the program's tables.
    tolerance : float
        First neglected coefficient of a piece over the greatest one.
    upslope : bool
        Whether the mass may move up-slope beyond where it began.
    """

    section: Any
    terms: Parameters
    functions: Mapping[str, OfRotation]
    tolerance: float
    upslope: bool

    def laid_out(self, reach: float = np.inf) -> dict[str, Data]:
        """Tables up to a rotation, or until contact is lost; beyond, they are constants."""
        lanes = max(_lanes(function) for function in self.functions.values())
        contact_lost = upright(self.section)
        if self.share_geometry:
            farthest = contact_lost.max(keepdims=True)
        else:
            farthest = np.broadcast_to(contact_lost, (lanes,))
        last = np.minimum(farthest, reach)
        first = first_rotation(last, self.upslope)
        if not self.share_geometry:
            return self._of_each_circle(first, last)
        tables = self._of_shared_parts(first, last)
        if lanes == 1:
            return {name: _of_one(table) for name, table in tables.items()}
        return tables

    @property
    def share_geometry(self) -> bool:
        """Whether all lanes have one circle."""
        return self.circles == 1

    @property
    def circles(self) -> int:
        """How many circles the lanes have."""
        kinks = self.section.arc_strength.rotation_kinks
        return kinks.shape[1]

    @property
    def names(self) -> list[str]:
        """The parts of the geometry that the functions are sums of."""
        names = dict[str, None]()
        for function in self.functions.values():
            names |= dict.fromkeys(function.coefficients)
        return list(names)

    def _of_each_circle(self, first: Floats, last: Floats) -> dict[str, Data]:
        """Tables of lanes that differ in their circles."""
        strength = self.section.arc_strength
        functions = self.functions.values()
        names = self.names

        def values(rotation: Floats) -> Floats:
            parts = strength.parts(rotation, names)
            rows = [function.combined(parts) for function in functions]
            return np.stack(rows)

        kinks = strength.rotation_kinks
        breaks, coefficients = between_kinks(values, kinks, first, last, self.tolerance)
        by_function = np.moveaxis(coefficients, 2, 0)
        tables = {}
        for name, of_function in zip(self.functions, by_function, strict=True):
            in_order = np.ascontiguousarray(of_function)
            tables[name] = continuous(breaks, in_order)
        return tables

    def _of_shared_parts(self, first: Floats, last: Floats) -> dict[str, Data]:
        """Tables of lanes that share one geometry, from the tables of its parts."""
        strength = self.section.arc_strength
        names = self.names

        def values(rotation: Floats) -> Floats:
            parts = strength.parts(rotation, names)
            rows = [parts[name] for name in names]
            return np.concatenate(rows)

        kinks = strength.rotation_kinks
        breaks, coefficients = between_kinks(values, kinks, first, last, self.tolerance)
        by_part = np.moveaxis(coefficients, 2, 0)
        at_first = strength.parts(first[None], names)
        ends = np.cumsum([len(at_first[name]) for name in names])
        by_name = dict(zip(names, np.split(by_part, ends[:-1]), strict=True))
        functions = self.functions.items()
        return {name: continuous(breaks[:, 0], function.combined(by_name)) for name, function in functions}

    def likely_reach(self, friction: Parameters) -> float:
        """Estimated rotation of lanes that start from rest: the work of gravity is dissipated by the least strength.

        From a sample of many lanes, with a margin; lanes that move farther are integrated again with complete tables.
        """
        if self.upslope or "rate" in friction or "soils" in friction:
            return np.inf
        contact_lost = upright(self.section)
        farthest = float(contact_lost.max())
        rotation = _SHARES[:, None] * farthest
        net_moment = self._net_moment(rotation, friction)
        energy = np.cumsum(net_moment, axis=0)
        if np.any(energy[-1] >= 0.0):
            return np.inf
        stops = np.argmax(energy < 0.0, axis=0)
        last_stop = _SHARES[stops.max()]
        share = last_stop * _MARGIN + _SHARES[1]
        return float(share) * farthest

    def _net_moment(self, rotation: Floats, friction: Parameters) -> Floats:
        """Driving moment less the least strength, over Theta*, of a sample of lanes at rotations, (M, lanes)."""
        moments = self.section.moment_coefficients
        mean_peak = self.section.arc_strength.mean_peak
        count = max(np.size(moments.normal_load), np.size(mean_peak))
        step = 1 + count // _SAMPLE
        sample = slice(None, None, step)

        def of_sample(value: Any) -> Any:
            if np.ndim(value) == 0:
                return value
            return np.ravel(value)[sample]

        def term(name: str) -> Any:
            added = self.terms.get(name, 0.0)
            if isinstance(added, OfRotation):
                return self._of_sample(added, rotation, sample)
            return of_sample(added)

        drive = of_sample(moments.driving_moment)
        drive_slope = of_sample(moments.driving_moment_slope)
        load = of_sample(moments.normal_load)
        load_slope = of_sample(moments.normal_load_slope)
        turned_load = load + term("turning")
        turned_slope = load_slope + term("turning_slope")
        peak = friction.get("peak", friction.get("coefficient"))
        residual = friction.get("residual", peak)
        least = np.minimum(peak, residual)
        cosine = np.cos(rotation)
        sine = np.sin(rotation)
        normal = turned_load * cosine - turned_slope * sine
        effective = normal + term("normal") - term("lift")
        friction_moment = of_sample(least) * effective
        resisting = np.maximum(friction_moment, 0.0)
        driving = drive * cosine - drive_slope * sine
        net_moment = driving - resisting - term("strength")
        return np.asarray(net_moment)

    def _of_sample(self, function: OfRotation, rotation: Floats, sample: slice) -> Floats:
        """A function of a sample of lanes at rotations, (M, lanes)."""
        if self.share_geometry:
            coefficients = {name: values[:, sample] for name, values in function.coefficients.items()}
            of_lanes = OfRotation(function.strength, coefficients)
            return of_lanes(rotation)
        shape = (len(rotation), self.circles)
        of_every_lane = function(np.broadcast_to(rotation, shape))
        return of_every_lane[:, sample]


def _lanes(function: OfRotation) -> int:
    """Number of lanes in which a function differs."""
    return max(values.shape[1] for values in function.coefficients.values())


def _of_one(table: Data) -> Data:
    """The table of a single lane."""
    return table._replace(coefficients=table.coefficients[..., 0])
