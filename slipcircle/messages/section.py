"""Messages for impossible sections, by the names of `slipcircle.ground.errors`.

``lane`` is the index in the flattened arrays of the section, 0 for a single section.
"""

from collections.abc import Iterable
from typing import Any

import numpy as np

import slipcircle.ground.circles as circles
from slipcircle.base.kinds import Texts
from slipcircle.ground import Section
from slipcircle.ground.errors import lowest_point


def centre_below(section: Section, lane: int) -> str:
    """Return the message for a centre below the ground."""
    _, centre, _ = section._circle
    return f"{{centre}} = {centre[lane].tolist()}: lies below the ground; a slip circle's lies above it"


def not_one_stretch(section: Section, lane: int) -> str:
    """Return the message for a circle that cuts off no mass or several masses, or contains an end of the ground."""
    ground, centre, radius = section._circle
    lanes, _, left, right, held = section._candidates
    x, y = centre[lane].tolist()
    r = radius[lane]
    line = ground[lane % len(ground)]
    which = f"{{centre}} = [{x:.10g}, {y:.10g}], {{radius}} = {r:.10g}"
    mine = lanes == lane
    count = np.count_nonzero(mine)
    one_besides_an_end = count == 1 and held[lane]
    if count > 1 or one_besides_an_end:
        ends = zip(left[mine], right[mine], strict=True)
        stretches = ", ".join(_pairs(ends))
        short = ""
        if held[lane]:
            short = " besides one that an end of the ground cuts short"
        return f"{which}: cuts off several masses; choose one by {{between}} = {stretches}{short}"
    if held[lane]:
        beyond = f"x = {x - r:.6g} or {x + r:.6g}"
        return f"{which}: an end of the ground lies inside the circle; the ground must continue beyond {beyond}"
    cut = section._cut.only([lane])
    of_circle, _, _ = circles.complete_stretches(cut)
    if section.between is not None and of_circle.size:
        return f"{{between}} = {section.between!r}: the circle cuts off no mass there"
    first, *_, last = _pairs(line)
    return f"{which}: misses the ground, which reaches from {first} to {last}"


def _pairs(numbers: Iterable[Any]) -> Texts:
    """Return pairs of numbers as text in brackets, such as "[1.5, 20]"."""
    return [f"[{first:.6g}, {second:.6g}]" for first, second in numbers]


def one_point(section: Section, lane: int) -> str:
    """Return the message for a circle that touches the ground, so that entry and exit coincide to rounding."""
    _, centre, radius = section._circle
    left, _ = section._ends
    from_centre = radius[lane] * left.points[lane]
    x, y = centre[lane] + from_centre
    return (
        f"{{radius}} = {radius[lane]:.10g}: the circle only touches the ground, at [{x:.6g}, {y:.6g}]; to cut off a "
        "mass it must be greater, or {centre} closer"
    )


def below_base(section: Section, lane: int) -> str:
    """Return the message for an arc whose lowest point is below the firm layer."""
    _, _, radius = section._circle
    lowest = lowest_point(section)[lane]
    which = f"{{radius}} = {radius[lane]:.10g}"
    return f"{which}: the circle goes down to y = {lowest:.6g}, below {{base}} = {section.base:.10g}"


def too_long(*_: Any) -> str:
    """Return the message for an arc longer than half a circle."""
    return (
        "the arc is longer than half a circle: parts of it carry negative normal stress, and the mean normal "
        "stress of the method (2.9) loses its sense"
    )


def without_normal_load(*_: Any) -> str:
    """Return the message for an arc on which the weight does not press."""
    return "there is no normal load: the weight of the mass has no component towards the arc"
