"""Arc of a layered section by soils: length, weight above, stress and strength of each stretch at the start.

Stresses follow from the closure of `slipcircle.layers.layers`: a stretch carries the weights of (2.23) of the material
vertically above it.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from slipcircle.base.arrays import float_or_array
from slipcircle.base.kinds import Floats
from slipcircle.layers.layers import LayeredSection
from slipcircle.layers.profile import AREA, HEAD, RADIAL_Y
from slipcircle.layers.soils import Soil

_SHORT = 1e-9  # rad, length below which a stretch is rounding


class Stretch(NamedTuple):
    """Stretch of the arc in one soil, before the mass moves.

    Attributes
    ----------
    soil : Soil
    start, end : float
        Directions of its ends from the centre, rad from straight below, positive down-slope.
    length : float
        Length, m.
    weight_share : float
        Weight of the material vertically above it over the weight of the mass.
    normal_stress, pore_pressure : float
        Mean total normal stress and mean pore pressure, Pa.
    strength : float
        Mean of c + tan(phi) (sigma - u) with the peak friction, Pa.
    """

    soil: Soil
    start: float
    end: float
    length: float
    weight_share: float
    normal_stress: float
    pore_pressure: float
    strength: float


def stretches(section: LayeredSection) -> tuple[Stretch, ...]:
    """Return the stretches of a single section from the entry to the exit.

    Raises
    ------
    ValueError
        If the section has lanes.
    """
    _one_lane(section)
    layers, ends = soils_under(section)
    weight = _from_entry(section, AREA, ends)
    shares = np.diff(weight) / weight[-1]
    normal = mean_normal_stress(section, ends)
    vertical = _means(section, ends, _from_entry(section, HEAD, ends))
    growth = _means(section, ends, section.arc_strength.growth_up_to(ends[:, None])[..., 0])
    rows = []
    for k, layer in enumerate(layers):
        soil, _ = section.layers[layer]
        start = float(ends[k])
        end = float(ends[k + 1])
        ratio = float_or_array(soil.pore_ratio)
        pressure = ratio * vertical[k] if ratio else _head(section, start, end)
        cohesion = np.asarray(soil.peak_cohesion) + np.asarray(soil.cohesion_gradient) * growth[layer, k]
        stretch = Stretch(
            soil=soil,
            start=start,
            end=end,
            length=_radius(section) * (end - start),
            weight_share=float(shares[k]),
            normal_stress=float(normal[k]),
            pore_pressure=float(pressure),
            strength=float(cohesion + np.asarray(soil.peak) * (normal[k] - pressure)),
        )
        rows.append(stretch)
    return tuple(rows)


def mean_normal_stress(section: LayeredSection, directions: ArrayLike) -> Floats:
    """Return the mean total normal stress between neighbouring directions at the start, Pa, (M - 1,) from (M,).

    Directions increase and are measured as in `Stretch`.
    """
    _one_lane(section)
    ends = np.asarray(directions, float)
    return _means(section, ends, -_from_entry(section, RADIAL_Y, ends))


def _means(section: LayeredSection, ends: Floats, integral: Floats) -> Floats:
    """Return means between neighbouring directions of a cumulative integral divided by R, (..., M - 1).

    `ends` are the directions in rad, (M,), and `integral` its values there, (..., M).
    """
    return np.diff(integral, axis=-1) / np.diff(ends) * _radius(section)


def _one_lane(section: LayeredSection) -> None:
    if section.lanes_shape or section.shape:
        raise ValueError("stretches: of one section; this one has lanes")


def _radius(section: LayeredSection) -> float:
    return float_or_array(section.radius)


def soils_under(section: LayeredSection, rotation: float = 0.0) -> tuple[list[int], Floats]:
    """Return the indices of the soils along the mass of one section after a rotation, and directions of their ends.

    The rotation and the directions are in rad. N soils have N + 1 ends, from the entry to the exit.
    """
    strength = section.arc_strength
    *joints, last, first = strength.space(np.full((1, 1), rotation)).ravel().tolist()
    (after,) = strength.stretches.after
    every_soil = [*strength.stretches.first, *after]
    soils = list[int]()
    ends = [first]
    for soil, end in zip(every_soil, [*joints, last], strict=True):
        if end - ends[-1] < _SHORT:
            continue
        goes_on = soils[-1:] == [soil]
        if goes_on:
            ends.pop()
        else:
            soils.append(int(soil))
        ends.append(end)
    return soils, np.array(ends)


def _from_entry(section: LayeredSection, integral: int, directions: Floats) -> Floats:
    """Return an integral of the weights from the entry to directions, (M,).

    `integral` is its index in `slipcircle.layers.profile`. Directions are in rad, positive down-slope.
    """
    (facing,) = section._facing
    profile = section.profile
    up_to = profile.up_to(facing * directions[:, None], AREA + 1)[integral, ..., 0]
    if facing < 0.0:
        up_to = profile.whole[integral] - up_to
    _, weights = section._columns
    return (up_to * weights).sum(axis=0)


def _head(section: LayeredSection, start: float, end: float) -> float:
    """Return the mean pressure of the water level between two directions in rad, Pa; 0 without a level."""
    if section.level is None:
        return 0.0
    (facing,) = section._facing
    low, high = np.sort([[facing * start], [facing * end]], axis=0)
    (integral,) = section.heads_between(low, high)
    return float(integral / (high - low)[0]) * _radius(section) * float_or_array(section.water_unit_weight)
