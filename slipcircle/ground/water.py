"""Tables of functions of the rotation: of the water of a section, which stays in place, and of depths."""

from typing import Any

import numpy as np

from slipcircle.base.kinds import Floats, Function
from slipcircle.core.scene.mass import Mass
from slipcircle.core.scene.piecewise import Data
from slipcircle.tables.interpolation import TERMS, between_kinks, continuous


def upright(mass: Mass) -> Floats:
    """Return the rotation in rad at which the normal load J_r cos(phi) - J_r' sin(phi) falls to 0, (lanes,)."""
    load = mass.moment_coefficients.normal_load
    slope = mass.moment_coefficients.normal_load_slope
    rotation = np.arctan2(load, slope)
    return np.ravel(rotation)


def first_rotation(last: Floats, upslope: bool) -> Floats:
    """Return the first rotation of tables: 0, or half a turn before the last rotation if the mass may move up-slope.

    Rotations are in rad, (lanes,), and ``last`` is the end of the tables.
    """
    if upslope:
        return last - np.pi
    return np.zeros_like(last)


def table_of_rotation(section: Any, function: Function, rotates: bool, upslope: bool, tolerance: float) -> Data:
    """Return a function of the rotation of a section as a table, up to loss of contact.

    Without ``rotates`` it is constant. ``upslope`` is true if the mass may move up-slope, and ``tolerance`` is the
    relative error.
    """

    def pressure(rotation: Any) -> Any:
        *axes, _ = rotation.shape
        places = rotation.reshape(*axes, *section.shape)
        values = function(places)
        return values.reshape(1, *rotation.shape)

    last = upright(section)
    if rotates:
        first = first_rotation(last, upslope)
        kinks = getattr(function, "kinks", section.pressure_kinks)
        *_, count = kinks.shape
        kinks = kinks.reshape(last.size, count)
        breaks, coefficients = between_kinks(pressure, kinks.T, first, last, tolerance)
        coefficients = np.ascontiguousarray(coefficients[:, :, 0])
    else:
        breaks = np.zeros((1, last.size))
        coefficients = np.zeros((1, TERMS, last.size))
        coefficients[0, 0] = pressure(breaks)[0, 0]
    if section.shape:
        return continuous(breaks, coefficients)
    return continuous(breaks[:, 0], coefficients[..., 0])
