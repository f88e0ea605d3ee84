"""The strength of a layered section as tables of the rotation, in the same pieces for all of its functions."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.core.flow.tables import Data, between_kinks
from slipcircle.core.scene.layers import LayeredSection
from slipcircle.core.scene.strength import OfRotation

Floats = NDArray[np.float64]
FINEST = 1e-14  # the first coefficients left out of tables for single scenes, over their greatest
_SOME = 256  # lanes of which it is
_TRIED = np.linspace(0.0, 1.0, 41)  # shares of the rotation at which the energy is estimated


class RotationTables(NamedTuple):
    """Functions of the rotation as tables.

    Attributes
    ----------
    section : LayeredSection
    terms : mapping
        What the soils add to the balance, by the names of its parameters.
    functions : mapping
        Those that are functions of the rotation, by the names of the program's tables.
    tolerance : float
        The last coefficients of a piece over the greatest one.
    upslope : bool
        Whether the mass may move up-slope beyond where it began.
    """

    section: LayeredSection
    terms: Mapping[str, Any]
    functions: Mapping[str, OfRotation]
    tolerance: float
    upslope: bool

    @property
    def upright(self) -> Floats:
        """The rotation at which J_r cos(phi) - J_r' sin(phi) falls to 0, (lanes,)."""
        c = self.section.moment_coefficients
        return np.ravel(np.arctan2(c.normal_load, c.normal_load_slope))

    def laid_out(self, reach: float = np.inf) -> dict[str, Data]:
        """Tables as far as a rotation, or until the weight presses no more; beyond, they are constants."""
        strength = self.section.arc_strength
        functions = self.functions
        shared = strength.rotation_kinks.shape[1] == 1
        lanes = max(values.shape[1] for f in functions.values() for values in f.coefficients.values())
        last = np.broadcast_to(self.upright, (lanes,))
        last = np.minimum(last.max(keepdims=True) if shared else last, reach)
        first = last - np.pi if self.upslope else np.zeros_like(last)
        if shared:
            tables = self._of_shared_parts(first, last)
            return tables if lanes > 1 else {name: _of_one(table) for name, table in tables.items()}

        def values(rotation: Floats) -> Floats:
            parts = strength.parts(rotation, self.names)
            return np.stack([function.combined(parts) for function in functions.values()])

        breaks, coefficients = between_kinks(values, strength.rotation_kinks, first, last, self.tolerance)
        by_function = np.moveaxis(coefficients, 2, 0)
        return {
            name: Data(breaks, np.ascontiguousarray(table), np.zeros(len(breaks)))
            for name, table in zip(functions, by_function, strict=True)
        }

    @property
    def names(self) -> list[str]:
        """The parts that the functions are made of."""
        return list(dict.fromkeys(name for function in self.functions.values() for name in function.coefficients))

    def _of_shared_parts(self, first: Floats, last: Floats) -> dict[str, Data]:
        """Tables of lanes that have one geometry in common: of its parts first."""
        strength = self.section.arc_strength
        names = self.names

        def values(rotation: Floats) -> Floats:
            parts = strength.parts(rotation, names)
            return np.concatenate([parts[name] for name in names])

        breaks, coefficients = between_kinks(values, strength.rotation_kinks, first, last, self.tolerance)
        known = strength.parts(first[None], names)
        starts = dict(zip(names, np.cumsum([0, *(len(known[name]) for name in names)]), strict=False))
        jumps = np.zeros(len(breaks))
        return {
            name: Data(breaks[:, 0], _combined(function, starts, coefficients[..., 0]), jumps)
            for name, function in self.functions.items()
        }

    def likely_reach(self, friction: Mapping[str, Any]) -> float:
        """How far lanes get that start from rest, by the energy that gravity gives and their least strength takes.

        Of some of many lanes, and with a margin: what moves farther is integrated again with all of the tables.
        """
        if self.upslope or "rate" in friction or "soils" in friction:
            return np.inf
        upright = float(self.upright.max())
        rotation = _TRIED[:, None] * upright
        energy = np.cumsum(self._net_moment(rotation, friction), axis=0)
        stops = np.argmax(energy < 0.0, axis=0)
        if np.any(energy[-1] >= 0.0):
            return np.inf
        return float(_TRIED[stops.max()] * 1.2 + _TRIED[1]) * upright

    def _net_moment(self, rotation: Floats, friction: Mapping[str, Any]) -> Floats:
        """What gravity drives with less the least strength, over Theta*, of some lanes at rotations, (M, lanes)."""
        c = self.section.moment_coefficients
        count = max(np.size(c.normal_load), np.size(self.section.arc_strength.mean_peak))
        some = slice(None, None, 1 + count // _SOME)

        def of_some(value: Any) -> Any:
            return value if np.ndim(value) == 0 else value[some]

        def term(name: str) -> Any:
            term = self.terms.get(name, 0.0)
            if not isinstance(term, OfRotation):
                return of_some(term)
            circles = self.section.arc_strength.rotation_kinks.shape[1]
            if circles > 1:
                return term(np.broadcast_to(rotation, (len(rotation), circles)))[:, some]
            coefficients = {n: values[:, some] for n, values in term.coefficients.items()}
            return OfRotation(term.strength, coefficients)(rotation)

        fall, fall_slope, press, press_slope = map(of_some, c[:4])
        peak = friction.get("peak", friction.get("coefficient"))
        mu = of_some(np.minimum(peak, friction.get("residual", peak)))
        cosine, sine = np.cos(rotation), np.sin(rotation)
        normal = (press + term("turning")) * cosine - (press_slope + term("turning_slope")) * sine
        friction_moment = np.maximum(mu * (normal + term("normal") - term("lift")), 0.0)
        return np.asarray(fall * cosine - fall_slope * sine - friction_moment - term("strength"))


def _of_one(table: Data) -> Data:
    """The table of a single lane."""
    return table._replace(coefficients=table.coefficients[..., 0])


def _combined(function: OfRotation, starts: Mapping[str, int], parts: Floats) -> Floats:
    """Coefficients (pieces, TERMS, lanes) of a function from those of its parts (pieces, TERMS, parts)."""
    table: Any = 0.0
    for name, coefficients in function.coefficients.items():
        some = parts[:, :, starts[name] : starts[name] + len(coefficients)]
        rows = some.reshape(-1, len(coefficients)) @ coefficients
        table = table + rows.reshape(*some.shape[:2], -1)
    return np.asarray(table)
