"""Messages for impossible arcs, by the names of `Arc.geometry_errors`."""

import numpy as np

from slipcircle.core import Arc


def swapped(arc: Arc, lane: int) -> str:
    """Return the message for a second end that is not above the first.

    ``lane`` is the index in the flattened arrays of the arc, 0 for a single arc.
    """
    one, two = _degrees(arc, lane)
    return f"{{theta_2}} = {two:.10g} deg: must be above {{theta_1}} = {one:.10g} deg; swap them?"


def too_wide(arc: Arc, lane: int) -> str:
    """Return the message for an arc of more than a half circle.

    ``lane`` is the index in the flattened arrays of the arc, 0 for a single arc.
    """
    one, two = _degrees(arc, lane)
    return f"{{theta_2}} - {{theta_1}} = {two - one:.10g} deg: must be at most 180 deg{_were_degrees(arc)}"


def without_load(arc: Arc, lane: int) -> str:
    """Return the message for an arc on which the weight does not press.

    ``lane`` is the index in the flattened arrays of the arc, 0 for a single arc.
    """
    one, two = _degrees(arc, lane)
    return (
        f"{{theta_1}} = {one:.10g} deg, {{theta_2}} = {two:.10g} deg: there is no normal load; the middle of "
        f"the arc must lie between 180 and 360 deg, below its centre{_were_degrees(arc)}"
    )


def _degrees(arc: Arc, lane: int) -> list[float]:
    """Return the polar angles of both ends of a lane, an index in the flattened arrays, in degrees."""
    ends = np.broadcast_arrays(arc.theta_1, arc.theta_2)
    of_lane = [end.flat[lane] for end in ends]
    return np.degrees(of_lane).tolist()


def _were_degrees(arc: Arc) -> str:
    """Return a question about units if an end exceeds two turns, otherwise an empty text.

    Degrees passed for radians do so.
    """
    is_beyond = np.abs(arc.theta_1) > 4 * np.pi
    if np.any(is_beyond):
        return "; theta_1 and theta_2 are in rad: were they in degrees?"
    return ""
