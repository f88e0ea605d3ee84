"""Simple slopes, circles through two points of a ground, and a check of the mass that they cut off."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from generated.effects import Parameter
from slipcircle.base.errors import Fault, mistakes, raise_all
from slipcircle.base.kinds import Floats, Texts, ValueDict
from slipcircle.ground.errors import x_of_ends
from slipcircle.ground.ground import AS_PRINTED
from slipcircle.ground.plane import Vectors


def simple_slope(height: float, *, angle: float | None = None, run: float | None = None) -> Floats:
    """Return the points, (4, 2) in m, of a straight slope that falls to the right from level ground to the origin.

    The level ground on either side has the length of four heights plus the run.

    Parameters
    ----------
    height : float
        Height of the slope, m.
    angle, run : float
        Inclination of the slope in rad, at most pi/2, or its horizontal length in m. Exactly one is required.
    """
    allowed = {"height": Parameter("", "m", 0.0, allowed="a positive length in m")}
    if run is not None:
        allowed["run"] = Parameter("", "m", -5e-324, allowed="a length of at least 0 in m")
    if angle is not None:
        allowed["angle"] = Parameter("", "rad", 0.0, 1.5707963267948968, allowed="above 0 and at most pi/2 (rad)")
    fields: ValueDict = {"height": height, "run": run, "angle": angle}
    errors = mistakes(fields, allowed)
    if (run is None) == (angle is None):
        errors.append("{angle} or {run}: give one of them")
    raise_all("simple_slope", errors)
    if angle is not None:
        is_upright = angle > 1.5707963
        slope = float(np.tan(angle))
        run = 0.0 if is_upright else height / slope
    assert run is not None
    flat = 4 * height + run
    left = -run - flat
    x = [left, -run, 0.0, flat]
    y = [height, height, 0.0, 0.0]
    return np.stack([x, y], axis=1)


def _from_left(first: ArrayLike, second: ArrayLike) -> tuple[Vectors, Vectors]:
    """Return two points, or the points of many pairs, ordered from left to right.

    Points are (..., 2) and are returned as vectors.
    """
    p = np.asarray(first, float)
    q = np.asarray(second, float)
    p_x = p[..., :1]
    q_x = q[..., :1]
    left = np.where(p_x > q_x, q, p)
    right = np.where(p_x > q_x, p, q)
    return Vectors.of(left), Vectors.of(right)


def circle_through(
    first: ArrayLike, second: ArrayLike, *, radius: ArrayLike | None = None, depth: ArrayLike | None = None
) -> tuple[Any, Any]:
    """Return centre (..., 2) and radius of the circle through two points, in m, by its radius or its depth.

    ``first`` and ``second`` are points (..., 2). ``depth`` is the depth of the arc below its chord. Exactly one of
    radius and depth is required.

    Raises
    ------
    ValueError
        If one point is above the other, if the radius is less than half their distance, or if the depth exceeds it
        (more than a half disc).
    """
    p, q = _from_left(first, second)
    chord = q - p
    half = chord.length / 2
    raise_all("circle_through", _through_errors(chord, half, radius, depth))
    if depth is not None:
        below = np.asarray(depth)
        sum_of_squares = half**2 + np.square(below)
        radius = sum_of_squares / (2 * below)
    size = np.asarray(radius)
    square = (size - half) * (size + half)
    above_chord = np.sqrt(square)
    length = 2 * half
    upwards = Vectors(-chord.y, chord.x)
    normal = Vectors(upwards.x / length, upwards.y / length)
    middle = (p + q) * 0.5
    centre = middle + normal * above_chord
    return centre.points, size[()]


def _through_errors(chord: Vectors, half: Floats, radius: Any, depth: Any) -> Texts:
    """Return messages about a circle through two points.

    ``chord`` joins the points, and ``half`` is half its length, in m. The radius or the depth below the chord is None.
    """
    errors = []
    if (radius is None) == (depth is None):
        errors.append("{radius} or {depth}: give one of them")
    if np.any(chord.x == 0.0):
        errors.append("the two points have the same x; a slip circle connects two sides")
    elif radius is not None and np.any(np.less(radius, half)):
        least = f"at least half the distance of the points, {np.max(half):.10g}"
        smallest = np.min(radius)
        errors.append(f"{{radius}} = {smallest:.10g}: must be {least}")
    elif depth is not None and np.any(np.less_equal(depth, 0.0) | np.greater(depth, half)):
        most = f"at most half the distance of the points, {np.min(half):.10g}"
        greatest = np.max(depth)
        errors.append(f"{{depth}} = {greatest:.10g}: must be above 0 and {most}")
    return errors


def circle_touching(first: ArrayLike, second: ArrayLike, level: ArrayLike) -> tuple[Any, Any]:
    """Return centre and radius of the circle through two points that touches a level between them from above.

    Points are (..., 2) and the level is a height y, in m.

    Raises
    ------
    ValueError
        If the level is above one of the points, or at the height of both.

    Notes
    -----
    With heights h >= l of the points above the level and their horizontal distance run, it touches at a distance
    u = h (run^2 - l (h - l))/(h run + sqrt(h l (run^2 + (h - l)^2))) from the higher point, towards the lower one.
    """
    p, q = _from_left(first, second)
    base = np.asarray(level, float)
    run = q.x - p.x
    left_height = p.y - base
    right_height = q.y - base
    high = np.maximum(left_height, right_height)
    low = np.minimum(left_height, right_height)
    too_high = (low < 0.0) | (high <= 0.0)
    is_upright = run == 0.0
    if np.any(too_high | is_upright):
        raise ValueError(
            f"circle_touching: level = {np.max(base):.10g}: must lie below both points or touch the lower one, "
            "and the points must differ in x"
        )
    rise = high - low
    square = run**2 + rise**2
    product = high * low
    root = np.sqrt(product * square)
    difference = run**2 - low * rise
    numerator = high * difference
    denominator = high * run + root
    away = numerator / denominator
    sum_of_squares = away**2 + high**2
    radius = sum_of_squares / (2 * high)
    left_is_higher = left_height >= right_height
    from_left = p.x + away
    from_right = q.x - away
    x = np.where(left_is_higher, from_left, from_right)
    centre = Vectors(x, base + radius)
    return centre.points, radius[()]


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

    def sentence(k: int) -> str:
        return f"{interval}: does not contain the mass from x = {left[k]:.6g} to {right[k]:.6g}"

    is_outside = begins_before | ends_after
    return is_outside, sentence
