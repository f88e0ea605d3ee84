"""The strength of a layered section as tables of the rotation, in the same pieces for all of its functions."""

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from slipcircle.core.flow.tables import TERMS, Data, between_kinks
from slipcircle.core.scene.layers import LayeredSection
from slipcircle.core.scene.strength import OfRotation

Floats = NDArray[np.float64]
FINEST = 1e-11  # accuracy of tables for single scenes; their last coefficients are a hundredth of it


def rotation_tables(
    section: LayeredSection, terms: Mapping[str, OfRotation], rotates: bool, upslope: bool, accuracy: float
) -> dict[str, Data]:
    """Tables of functions of the rotation, from the start until the weight presses no more.

    Parameters
    ----------
    section : LayeredSection
    terms : mapping
        Functions by the name of the parameter that they stand for.
    rotates : bool
        Whether the mass rotates; if not, they are the constants that they are at the start.
    upslope : bool
        Whether the mass may move up-slope beyond where it began.
    accuracy : float
        Relative error asked for.
    """
    circles = section.arc_strength.rotation_kinks.shape[1]
    lanes = max(function.coefficients.shape[1] for function in terms.values())

    def values(rotation: Floats) -> Floats:
        """Of all functions; of one circle their parts, which all lanes share."""
        if circles == 1:
            return np.concatenate([function.parts(rotation) for function in terms.values()])
        return np.stack([function(rotation) for function in terms.values()])

    if rotates:
        tolerance = (accuracy if lanes > 1 else FINEST) / 100
        breaks, coefficients = _in_pieces(section, values, lanes, upslope, tolerance)
    else:
        breaks = np.zeros((1, circles))
        constant = values(breaks)[:, 0]
        coefficients = np.zeros((1, TERMS, *constant.shape))
        coefficients[0, 0] = constant
    if circles == 1:
        tables = _combined(list(terms.values()), breaks[:, 0], coefficients[..., 0])
    else:
        tables = [(np.ascontiguousarray(breaks), np.ascontiguousarray(c)) for c in np.moveaxis(coefficients, 2, 0)]
    jumps = np.zeros(len(breaks))
    if lanes == 1:
        tables = [(starts.reshape(-1), values[..., 0]) for starts, values in tables]
    return {name: Data(*table, jumps) for name, table in zip(terms, tables, strict=True)}


def _in_pieces(
    section: LayeredSection, values: Callable[[Floats], Floats], lanes: int, upslope: bool, tolerance: float
) -> tuple[Floats, Floats]:
    """The functions between their kinks, until J_r cos(phi) - J_r' sin(phi) falls to 0."""
    kinks = section.arc_strength.rotation_kinks
    c = section.moment_coefficients
    upright = np.broadcast_to(np.arctan2(c.normal_load, c.normal_load_slope), (lanes,))
    last = upright.max(keepdims=True) if kinks.shape[1] == 1 else upright
    first = last - np.pi if upslope else np.zeros_like(last)
    return between_kinks(values, kinks, first, last, tolerance)


def _combined(functions: list[OfRotation], breaks: Floats, parts: Floats) -> list[tuple[Floats, Floats]]:
    """Breaks and coefficients (pieces, TERMS, lanes) of functions from those of their parts (pieces, TERMS, parts)."""
    tables = []
    first = 0
    for function in functions:
        count, lanes = function.coefficients.shape
        mine = parts[:, :, first : first + count]
        first += count
        table = mine.reshape(-1, count) @ function.coefficients
        tables.append((breaks, table.reshape(*mine.shape[:2], lanes)))
    return tables
