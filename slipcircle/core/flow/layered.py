"""The strength of a layered section as piecewise polynomials of the rotation, all with the same pieces."""

from collections.abc import Mapping
from functools import reduce
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.kinds import Parameters
from slipcircle.core.flow.interpolation import between_kinks
from slipcircle.core.flow.tables import Data
from slipcircle.core.scene.layers import LayeredSection
from slipcircle.core.scene.section import Section
from slipcircle.core.scene.strength import OfRotation

Floats = NDArray[np.float64]
FINEST = 1e-14  # the first coefficients left out of tables for single scenes, over their greatest
_SAMPLE = 256  # lanes whose reach is estimated
_SHARES = np.linspace(0.0, 1.0, 41)  # of the rotation to upright, at which the energy is estimated
_MARGIN = 1.2  # on the estimated reach


def upright(section: Section) -> Floats:
    """The rotation at which the normal load J_r cos(phi) - J_r' sin(phi) of the weight falls to 0, (lanes,)."""
    weight = section.moment_coefficients
    rotation = np.arctan2(weight.normal_load, weight.normal_load_slope)
    return np.ravel(rotation)


def first_rotation(last: Floats, upslope: bool) -> Floats:
    """The rotation from which tables to the last one begin: 0, or half a turn before the last one."""
    return last - np.pi if upslope else np.zeros_like(last)


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

    section: LayeredSection
    terms: Parameters
    functions: Mapping[str, OfRotation]
    tolerance: float
    upslope: bool

    def laid_out(self, reach: float = np.inf) -> dict[str, Data]:
        """Tables up to a rotation, or until contact is lost; beyond, they are constants."""
        strength = self.section.arc_strength
        functions = self.functions
        sizes = [values.shape[1] for f in functions.values() for values in f.coefficients.values()]
        lanes = max(sizes)
        last = np.broadcast_to(upright(self.section), (lanes,))
        share_geometry = strength.rotation_kinks.shape[1] == 1
        if share_geometry:
            last = last.max(keepdims=True)
        last = np.minimum(last, reach)
        first = first_rotation(last, self.upslope)
        if share_geometry:
            tables = self._of_shared_parts(first, last)
            if lanes == 1:
                tables = {name: _of_one(table) for name, table in tables.items()}
            return tables

        def values(rotation: Floats) -> Floats:
            parts = strength.parts(rotation, self.names)
            return np.stack([function.combined(parts) for function in functions.values()])

        breaks, coefficients = between_kinks(values, strength.rotation_kinks, first, last, self.tolerance)
        jumps = np.zeros(len(breaks))
        tables = {}
        for name, of_function in zip(functions, np.moveaxis(coefficients, 2, 0), strict=True):
            tables[name] = Data(breaks, np.ascontiguousarray(of_function), jumps)
        return tables

    @property
    def names(self) -> list[str]:
        """The parts of the geometry that the functions are sums of."""
        every = [name for function in self.functions.values() for name in function.coefficients]
        return list(dict.fromkeys(every))

    def _of_shared_parts(self, first: Floats, last: Floats) -> dict[str, Data]:
        """Tables of lanes that share one geometry, from the tables of its parts."""
        strength = self.section.arc_strength
        names = self.names

        def values(rotation: Floats) -> Floats:
            parts = strength.parts(rotation, names)
            return np.concatenate([parts[name] for name in names])

        breaks, coefficients = between_kinks(values, strength.rotation_kinks, first, last, self.tolerance)
        known = strength.parts(first[None], names)
        counts = [len(known[name]) for name in names]
        rows = dict(zip(names, np.cumsum([0, *counts]), strict=False))
        jumps = np.zeros(len(breaks))
        tables = {}
        for name, function in self.functions.items():
            combined = _combined(function, rows, coefficients[..., 0])
            tables[name] = Data(breaks[:, 0], combined, jumps)
        return tables

    def likely_reach(self, friction: Parameters) -> float:
        """Estimated rotation of lanes that start from rest: the work of gravity is dissipated by the least strength.

        From a sample of many lanes, with a margin; lanes that move farther are integrated again with complete tables.
        """
        if self.upslope or "rate" in friction or "soils" in friction:
            return np.inf
        farthest = float(upright(self.section).max())
        rotation = _SHARES[:, None] * farthest
        net_moment = self._net_moment(rotation, friction)
        energy = np.cumsum(net_moment, axis=0)
        if np.any(energy[-1] >= 0.0):
            return np.inf
        stops = np.argmax(energy < 0.0, axis=0)
        share = _SHARES[stops.max()] * _MARGIN + _SHARES[1]
        return float(share) * farthest

    def _net_moment(self, rotation: Floats, friction: Parameters) -> Floats:
        """Driving moment less the least strength, over Theta*, of a sample of lanes at rotations, (M, lanes)."""
        moments = self.section.moment_coefficients
        count = max(np.size(moments.normal_load), np.size(self.section.arc_strength.mean_peak))
        sample = slice(None, None, 1 + count // _SAMPLE)

        def of_sample(value: Any) -> Any:
            return value if np.ndim(value) == 0 else value[sample]

        def term(name: str) -> Any:
            return self._term_of_sample(name, rotation, sample)

        drive, drive_slope, load, load_slope = map(of_sample, moments[:4])
        peak = friction.get("peak", friction.get("coefficient"))
        least = np.minimum(peak, friction.get("residual", peak))
        cosine = np.cos(rotation)
        sine = np.sin(rotation)
        normal = (load + term("turning")) * cosine - (load_slope + term("turning_slope")) * sine
        effective = normal + term("normal") - term("lift")
        friction_moment = np.maximum(of_sample(least) * effective, 0.0)
        driving = drive * cosine - drive_slope * sine
        return np.asarray(driving - friction_moment - term("strength"))

    def _term_of_sample(self, name: str, rotation: Floats, sample: slice) -> Any:
        """A term of a sample of lanes at rotations: a number, or (M, lanes)."""
        term = self.terms.get(name, 0.0)
        if not isinstance(term, OfRotation):
            return term if np.ndim(term) == 0 else term[sample]
        strength = self.section.arc_strength
        circles = strength.rotation_kinks.shape[1]
        if circles > 1:
            every = np.broadcast_to(rotation, (len(rotation), circles))
            return term(every)[:, sample]
        coefficients = {part: values[:, sample] for part, values in term.coefficients.items()}
        return OfRotation(term.strength, coefficients)(rotation)


def _of_one(table: Data) -> Data:
    """The table of a single lane."""
    return table._replace(coefficients=table.coefficients[..., 0])


def _combined(function: OfRotation, rows: Mapping[str, int], parts: Floats) -> Floats:
    """Coefficients (pieces, TERMS, lanes) of a function from those of its parts (pieces, TERMS, parts)."""
    pieces, terms, _ = parts.shape
    products = list[Floats]()
    for name, coefficients in function.coefficients.items():
        first = rows[name]
        last = first + len(coefficients)
        part = parts[:, :, first:last].reshape(pieces * terms, -1)
        products.append(part @ coefficients)
    total = reduce(np.add, products)  # of one part no copy
    return total.reshape(pieces, terms, -1)
