"""Errors of sections, each kind for all lanes at once.

Each error is a pair: a mask of invalid lanes, and a function that returns the message for a lane. A kind is checked
only if all earlier kinds are absent, since it may rely on them.
"""

from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

import slipcircle.ground.circles as circles
from slipcircle.base.errors import Fault
from slipcircle.base.kinds import Texts
from slipcircle.core.lazy import lazy_import
from slipcircle.ground.ground import AS_PRINTED


def geometry_errors(section: Any) -> Iterator[Fault]:
    """Yield the errors of lanes whose geometry is not a section.

    An error is a mask of lanes and a function from the index of a lane to its message.
    """
    if section.has_water:
        yield lazy_import("ponds").water_fault(*section.water)
    yield _not_one_stretch(section)
    _, centre, _ = section._circle
    first, last = section._angles
    is_below = circles.below_ground(section._cut, section._mine)  # the ground may pass over it outside the circle
    yield (
        is_below | (last <= first),
        lambda k: f"{{centre}} = {centre[k].tolist()}: lies below the ground; a slip circle's lies above it",
    )
    yield _one_point(section)
    if section.level is not None:
        yield lazy_import("ponds").ends_above(section._level, *x_of_ends(section))
    if section.base is not None:
        yield _below_base(section)


def _not_one_stretch(section: Any) -> Fault:
    """Return the error of circles that cut off no mass or several masses, or that contain an end of the ground.

    It is a mask of lanes and a function from the index of a lane to its message.
    """
    ground, centre, radius = section._circle
    lane, _, left, right, held = section._candidates
    count = np.bincount(lane, minlength=len(radius))

    def sentence(k: int) -> str:
        x, y = centre[k].tolist()
        r = radius[k]
        line = ground[k % len(ground)]
        which = f"{{centre}} = [{x:.10g}, {y:.10g}], {{radius}} = {r:.10g}"
        mine = lane == k
        one_besides_an_end = count[k] == 1 and held[k]
        if count[k] > 1 or one_besides_an_end:
            ends = zip(left[mine], right[mine], strict=True)
            stretches = ", ".join(_pairs(ends))
            short = ""
            if held[k]:
                short = " besides one that an end of the ground cuts short"
            return f"{which}: cuts off several masses; choose one by {{between}} = {stretches}{short}"
        if held[k]:
            beyond = f"x = {x - r:.6g} or {x + r:.6g}"
            return f"{which}: an end of the ground lies inside the circle; the ground must continue beyond {beyond}"
        cut = section._cut.only([k])
        of_circle, _, _ = circles.complete_stretches(cut)
        if section.between is not None and of_circle.size:
            return f"{{between}} = {section.between!r}: the circle cuts off no mass there"
        first, *_, last = _pairs(line)
        return f"{which}: misses the ground, which reaches from {first} to {last}"

    return (count != 1) | held, sentence


def x_of_ends(section: Any) -> Any:
    """Return x of the left and of the right end of arcs in m, (2, lanes)."""
    _, centre, radius = section._circle
    left, right = section._ends
    return centre[:, 0] + radius * [left.x, right.x]


def outside_between(section: Any) -> Fault:
    """Return the error of masses that exceed the range of x that selects them, ``between``.

    It is a mask of lanes and a function from the index of a lane to its message.
    """
    left, right = x_of_ends(section)
    low, high = section.between or (-np.inf, np.inf)
    rounding = AS_PRINTED * (right - left)
    interval = f"{{between}} = [{low:.6g}, {high:.6g}]"
    begins_before = left < low - rounding
    ends_after = right > high + rounding
    return (
        begins_before | ends_after,
        lambda k: f"{interval}: does not contain the mass from x = {left[k]:.6g} to {right[k]:.6g}",
    )


def _pairs(numbers: Iterable[Any]) -> Texts:
    """Return pairs of numbers as text in brackets, such as "[1.5, 20]"."""
    return [f"[{first:.6g}, {second:.6g}]" for first, second in numbers]


def _one_point(section: Any) -> Fault:
    """Return the error of circles that touch the ground, so that entry and exit coincide to rounding.

    It is a mask of lanes and a function from the index of a lane to its message.
    """
    _, centre, radius = section._circle
    left, right = section._ends
    between = right - left
    chord = radius * np.hypot(between.x, between.y)
    coordinates = np.abs(centre).max(axis=1) + radius

    def sentence(k: int) -> str:
        from_centre = radius[k] * left.points[k]
        x, y = centre[k] + from_centre
        return (
            f"{{radius}} = {radius[k]:.10g}: the circle only touches the ground, at [{x:.6g}, {y:.6g}]; to cut off a "
            "mass it must be greater, or {centre} closer"
        )

    return chord <= 2e-16 * coordinates, sentence


def _below_base(section: Any) -> Fault:
    """Return the error of arcs whose lowest point is below the firm layer.

    It is a mask of lanes and a function from the index of a lane to its message.
    """
    _, centre, radius = section._circle
    left, right = section._ends
    holds_lowest = (left.x < 0.0) & (right.x > 0.0)
    lowest_end = np.minimum(left.y, right.y)
    over_radius = np.where(holds_lowest, -1.0, lowest_end)
    lowest = centre[:, 1] + radius * over_radius
    base = section.base

    def sentence(k: int) -> str:
        which = f"{{radius}} = {radius[k]:.10g}"
        return f"{which}: the circle goes down to y = {lowest[k]:.6g}, below {{base}} = {base:.10g}"

    return lowest < base - AS_PRINTED * radius, sentence


def motion_errors(section: Any) -> Iterator[Fault]:
    """Yield the errors of lanes to which the method does not apply: long arcs, other free water, no normal load.

    An error is a mask of lanes and a function from the index of a lane to its message.
    """
    half_angle = np.ravel(section.half_angle)
    half_circle = np.pi / 2 * (1 + 8e-16)
    yield (
        half_angle > half_circle,
        lambda _: (
            "the arc is longer than half a circle: parts of it carry negative normal stress, and the mean normal "
            "stress of the method (2.9) loses its sense"
        ),
    )
    if section.has_water:
        yield lazy_import("ponds").other_water(section, *x_of_ends(section))
    normal_load = np.ravel(section.moment_coefficients.normal_load)
    yield (
        normal_load <= 0.0,
        lambda _: "there is no normal load: the weight of the mass has no component towards the arc",
    )
