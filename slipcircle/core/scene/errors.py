"""What keeps lanes of sections from being any, or from moving: a kind of mistake at a time, of all lanes at once."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from slipcircle.base.checks import Fault
from slipcircle.core.scene import circles
from slipcircle.core.scene.ground import ponds


def geometry_errors(section: Any) -> Iterator[Fault]:
    """Lanes that are no sections, a kind of mistake at a time; a kind is looked for where the ones before are not."""
    ground, centre, radius = section._circle
    if section.level is not None:
        yield ponds(ground, section._level)
    lane, _, left, right, held = section._candidates
    count = np.bincount(lane, minlength=len(radius))

    def no_stretch(k: int) -> str:
        (x, y), line = centre[k].tolist(), ground[k % len(ground)]
        which = f"{{centre}} = [{x:.10g}, {y:.10g}], {{radius}} = {radius[k]:.10g}"
        if count[k] > 1 or (count[k] == 1 and held[k]):
            ends = zip(left[lane == k], right[lane == k], strict=True)
            shown = ", ".join(f"[{a:.6g}, {b:.6g}]" for a, b in ends)
            more = " besides one that an end of the ground cuts short" if held[k] else ""
            return f"{which}: cuts off several stretches of the ground; choose one by {{between}} = {shown}{more}"
        if held[k]:
            return (
                f"{which}: an end of the ground lies inside the circle; the ground must go on beyond "
                f"x = {x - radius[k]:.6g} or {x + radius[k]:.6g}"
            )
        if section.between is not None and circles.stretches(section._cut.only([k]))[0].size:
            return f"{{between}} = {section.between!r}: no stretch of the ground inside the circle lies there"
        return (
            f"{which}: misses the ground, which reaches from [{line[0, 0]:.6g}, {line[0, 1]:.6g}] to "
            f"[{line[-1, 0]:.6g}, {line[-1, 1]:.6g}]"
        )

    yield (count != 1) | held, no_stretch
    (x1, y1), (x2, y2) = section._ends
    reversed_ = section._angles[1] <= section._angles[0]  # the ground passes over the centre, outside the circle
    yield (
        circles.below_ground(section._cut, section._mine) | reversed_,
        lambda k: f"{{centre}} = {centre[k].tolist()}: lies below the ground; a slip circle's lies above it",
    )
    if section.base is not None:
        base, lowest = section.base, centre[:, 1] + radius * np.where((x1 < 0.0) & (x2 > 0.0), -1.0, np.minimum(y1, y2))
        yield (
            lowest < base - 1e-9 * radius,
            lambda k: (
                f"{{radius}} = {radius[k]:.10g}: the circle goes down to y = {lowest[k]:.6g}, below {{base}} = "
                f"{base:.10g}"
            ),
        )


def motion_errors(section: Any) -> Iterator[Fault]:
    """Lanes to which the method gives no motion."""
    yield (
        np.ravel(section.half_angle) > np.pi / 2 * (1 + 8e-16),
        lambda _: (
            "the arc is longer than half a circle: parts of it carry negative normal stress, and the mean normal "
            "stress of the method (2.9) loses its sense"
        ),
    )
    yield (
        np.ravel(section.moment_coefficients.normal_load) <= 0.0,
        lambda _: "the mass presses on nothing: its weight has no component towards the arc",
    )
