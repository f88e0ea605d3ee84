"""Water of a section, which stays in place, as functions of the rotation, and tables of such functions."""

import math
from typing import Any

import numpy as np

from slipcircle.base.kinds import Effects, Floats, Function, Integers, Shape
from slipcircle.core.lazy import lazy_import
from slipcircle.core.scene.effects import rotates as lets_rotate
from slipcircle.core.scene.effects import symbols_of
from slipcircle.core.scene.mass import Mass
from slipcircle.core.scene.piecewise import Data, Tables
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
    shape = section.lanes_shape

    def pressure(rotation: Any) -> Any:
        *axes, _ = rotation.shape
        places = rotation.reshape(*axes, *shape)
        values = function(places)
        return values.reshape(1, *rotation.shape)

    lanes = _lanes_of(section.shape, shape)
    of_section = upright(section)
    last = of_section[lanes]
    if rotates:
        first = first_rotation(last, upslope)
        kinks = getattr(function, "kinks", section.pressure_kinks)
        *_, count = kinks.shape
        kinks = kinks.reshape(of_section.size, count)[lanes]
        breaks, coefficients = between_kinks(pressure, kinks.T, first, last, tolerance)
        coefficients = np.ascontiguousarray(coefficients[:, :, 0])
    else:
        breaks = np.zeros((1, last.size))
        coefficients = np.zeros((1, TERMS, last.size))
        at_rest = pressure(breaks)
        coefficients[0, 0] = at_rest[0, 0]
    if shape:
        return continuous(breaks, coefficients)
    return continuous(breaks[:, 0], coefficients[..., 0])


def tables_of(section: Any, effects: Effects, upslope: bool, tolerance: float, shape: Shape) -> Tables:
    """Return the functions of the rotation among the parameters of effects as tables by symbol.

    The arguments: see `slipcircle.core.scene.mass.Mass.tables`.
    """
    turns = lets_rotate(effects)
    tables = {}
    for effect, parameters in effects.items():
        symbols = symbols_of(effect)
        for name in ("level", "standing", "depth"):
            if name in parameters:
                function = parameters[name]
                symbol = symbols[name]
                tables[symbol] = table_of_rotation(section, function, turns, upslope, tolerance)
    return for_lanes(section, tables, shape)


def for_lanes(section: Any, tables: Tables, shape: Shape) -> Tables:
    """Return tables for the lanes of a scene of this shape from tables for the lanes of the section."""
    shape_of_lanes = section.lanes_shape
    if shape_of_lanes in ((), shape):
        return tables
    lanes = _lanes_of(shape_of_lanes, shape)
    return {name: table.lanes(lanes) for name, table in tables.items()}


def _lanes_of(own: Shape, shape: Shape) -> Integers:
    """Return the index of the lane of a shape ``own`` for each lane of the shape to which it broadcasts, (lanes,)."""
    indices = np.arange(math.prod(own)).reshape(own)
    return np.broadcast_to(indices, shape).ravel()


def turned_by(section: Any, rotation: Any) -> tuple[Shape, Floats]:
    """Return the shape of results after rotations in rad, and the rotations by lane, (rotations, lanes).

    ``rotation`` broadcasts with the section's shape as its last axes.
    """
    turn = np.asarray(rotation, float)
    shape = np.broadcast_shapes(turn.shape, section.shape)
    axes = len(section.shape)
    rotations = math.prod(shape[: len(shape) - axes])
    lanes = len(section._facing)
    by_shape = np.broadcast_to(turn, shape)
    return shape, by_shape.reshape(rotations, lanes)


def mean_pressure(section: Any, rotation: Any) -> Any:
    """Return the mean pore pressure on the arc below the mass after rotations. See `Section.mean_pressure`."""
    if section.level is None:
        return 0.0 * np.add(rotation, np.zeros(section.shape))
    shape, by_lane = turned_by(section, rotation)
    turned = by_lane * section._facing
    first, last = section._angles
    integral = section._water.integral(first + turned, last + turned)
    opening = last - first
    mean_height = (integral / opening).reshape(shape)
    pressure = mean_height * np.multiply(section.radius, section.water_unit_weight)
    return pressure[()]


def mean_lift(section: Any, rotation: Any) -> Any:
    """Return the mean pressure that reduces the normal stress of the weight. See `Section.mean_lift`."""
    pressure = mean_pressure(section, rotation)
    if not section.in_standing_water:
        return pressure
    height = lazy_import("standing").displaced_height(section, rotation)
    return pressure + height * np.multiply(section.radius, section.water_unit_weight)


def pressure_kinks(section: Any) -> Any:
    """Return the rotations at which the mean pressure is not smooth, rad, sorted, (..., kinks)."""
    kinks = [np.empty((len(section._facing), 0))]
    if section.level is not None:
        water_kinks = section._water.kinks
        until_kink = [water_kinks - end[:, None] for end in section._angles]
        turns = np.concatenate(until_kink, axis=1)
        facing = section._facing[:, None]
        kinks.append(turns * facing)
    if section.in_standing_water:
        kinks.append(lazy_import("standing").vertex_kinks(section))
    every = np.concatenate(kinks, axis=1)
    every.sort(axis=1)
    return section._shaped(every)
