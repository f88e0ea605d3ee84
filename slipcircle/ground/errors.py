"""Errors of sections, each kind for all lanes at once.

Each error is a pair: a mask of invalid lanes, and a function that returns the message for a lane. A kind is checked
only if all earlier kinds are absent, since it may rely on them.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np

import slipcircle.ground.circles as circles
from slipcircle.base.errors import Fault
from slipcircle.core.lazy import lazy_import, lazy_message
from slipcircle.ground.ground import AS_PRINTED


def geometry_errors(section: Any) -> Iterator[Fault]:
    """Yield the errors of lanes whose geometry is not a section.

    An error is a mask of lanes and a function from the index of a lane to its message.
    """
    if section.has_water:
        yield from lazy_import("ponds").water_faults(*section.water)
    yield _not_one_stretch(section)
    first, last = section._angles
    is_below = circles.below_ground(section._cut, section._mine)  # the ground may pass over it outside the circle
    is_swapped = last <= first
    yield is_below | is_swapped, lazy_message("section", "centre_below", section)
    yield _one_point(section)
    if section.level is not None:
        yield lazy_import("ponds").ends_above(section._level, *x_of_ends(section))
    if section.base is not None:
        yield _below_base(section)


def _not_one_stretch(section: Any) -> Fault:
    """Return the error of circles that cut off no mass or several masses, or that contain an end of the ground.

    It is a mask of lanes and a function from the index of a lane to its message.
    """
    lane, *_, held = section._candidates
    count = np.bincount(lane, minlength=len(held))
    has_not_one = (count != 1) | held
    return has_not_one, lazy_message("section", "not_one_stretch", section)


def x_of_ends(section: Any) -> Any:
    """Return x of the left and of the right end of arcs in m, (2, lanes)."""
    _, centre, radius = section._circle
    left, right = section._ends
    from_centre = radius * [left.x, right.x]
    return centre[:, 0] + from_centre


def _one_point(section: Any) -> Fault:
    """Return the error of circles that touch the ground, so that entry and exit coincide to rounding.

    It is a mask of lanes and a function from the index of a lane to its message.
    """
    _, centre, radius = section._circle
    left, right = section._ends
    between = right - left
    chord = radius * np.hypot(between.x, between.y)
    coordinates = np.abs(centre).max(axis=1) + radius
    only_touches = chord <= 2e-16 * coordinates
    return only_touches, lazy_message("section", "one_point", section)


def _below_base(section: Any) -> Fault:
    """Return the error of arcs whose lowest point is below the firm layer.

    It is a mask of lanes and a function from the index of a lane to its message.
    """
    _, _, radius = section._circle
    is_below = lowest_point(section) < section.base - AS_PRINTED * radius
    return is_below, lazy_message("section", "below_base", section)


def lowest_point(section: Any) -> Any:
    """Return the height of the lowest point of arcs in m, (lanes,)."""
    _, centre, radius = section._circle
    left, right = section._ends
    holds_lowest = (left.x < 0.0) & (right.x > 0.0)
    lowest_end = np.minimum(left.y, right.y)
    over_radius = np.where(holds_lowest, -1.0, lowest_end)
    return centre[:, 1] + radius * over_radius


def motion_errors(section: Any) -> Iterator[Fault]:
    """Yield the errors of lanes to which the method does not apply: long arcs, other free water, no normal load.

    An error is a mask of lanes and a function from the index of a lane to its message.
    """
    half_angle = np.ravel(section.half_angle)
    half_circle = np.pi / 2 * (1 + 8e-16)
    yield half_angle > half_circle, lazy_message("section", "too_long", section)
    if section.has_water:
        yield lazy_import("ponds").other_water(section, *x_of_ends(section))
    normal_load = np.ravel(section.moment_coefficients.normal_load)
    yield normal_load <= 0.0, lazy_message("section", "without_normal_load", section)
