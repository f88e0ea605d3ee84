"""The strength of a layered section as tables of the rotation, in the same pieces for all of its functions."""

from collections.abc import Mapping

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
    kinks = section.arc_strength.rotation_kinks
    circles = kinks.shape[1]
    lanes = max(function.coefficients.shape[1] for function in terms.values())

    def values(rotation: Floats) -> Floats:
        """Of all functions; of one circle their parts, which all lanes share."""
        if circles == 1:
            return np.concatenate([function.parts(rotation) for function in terms.values()])
        return np.stack([function(rotation) for function in terms.values()])

    start = np.zeros(circles)
    if rotates:
        c = section.moment_coefficients
        upright = np.broadcast_to(np.arctan2(c.normal_load, c.normal_load_slope), (lanes,))
        last = upright.max(keepdims=True) if circles == 1 else upright
        first = last - np.pi if upslope else start
        tolerance = accuracy / 100 if lanes > 1 else FINEST / 100
        breaks, coefficients = between_kinks(values, kinks, first, last, tolerance)
    else:
        constant = values(start[None])[:, 0]
        breaks, coefficients = start[None], np.zeros((1, TERMS, *constant.shape))
        coefficients[0, 0] = constant
    ends = np.cumsum([len(function.coefficients) for function in terms.values()])
    tables = {}
    for k, (name, function) in enumerate(terms.items()):
        if circles == 1:
            parts = coefficients[:, :, ends[k] - len(function.coefficients) : ends[k], 0]
            table = (parts.reshape(-1, parts.shape[-1]) @ function.coefficients).reshape(*parts.shape[:2], -1)
            starts = breaks[:, 0]
        else:
            table, starts = np.ascontiguousarray(coefficients[:, :, k]), np.ascontiguousarray(breaks)
        tables[name] = Data(starts, table[..., 0] if lanes == 1 else table, np.zeros(len(breaks)))
    return tables
