"""Input of grounds and circles, and their errors."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from generated.effects import Parameter
from slipcircle.base.checks import (
    INFINITY,
    Bounds,
    Fault,
    array_of,
    complaint,
    mistakes,
    quiet,
    raise_all,
    shape_mistakes,
)
from slipcircle.base.kinds import Floats, Shape, Texts, ValueDict, Values
from slipcircle.ground.plane import Vectors

FAR = 1e9  # bound of coordinates, m
AS_PRINTED = 1e-3  # tolerance relative to the radius or the width of a mass, for circles rounded to printed digits


WEIGHT = (0.0, 1e6, "a positive unit weight in N/m^3")


def leading_shape(value: Any, axes: int) -> Shape:
    """Return the shape of an array of lanes without the last axes, which belong to one section."""
    shape = np.shape(value)
    return shape[: len(shape) - axes]


def line_errors(name: str, lines: Floats) -> Iterator[Fault]:
    """Yield the errors of lines (n, V, 2) that do not run from left to right."""
    with quiet():
        before_first = lines[:, :1] - 1.0
        step = np.diff(lines, axis=1, prepend=before_first)

    def at(bad: Any, words: str) -> Fault:
        places = np.argmax(bad, axis=1)

        def sentence(k: int) -> str:
            place = places[k]
            point = lines[k, place].tolist()
            return f"{{{name}}}[{place}] = {point}: {words}"

        return bad.any(axis=1), sentence

    is_near = np.abs(lines) < FAR
    yield at(~is_near.all(axis=2), "must be two finite numbers within 1e9 m")
    yield at(~step.any(axis=2), "is equal to the point before it; remove one")
    yield at(step[..., 0] < 0.0, "lies left of the point before it; order them by x")
    x = lines[..., 0]
    first_x = x[:, 0]
    is_upright = x[:, -1] == first_x
    yield is_upright, lambda _: f"{{{name}}}: all points have the same x; it must extend from left to right"


def points_errors(name: str, given: Any, many: bool) -> Texts:
    """Return messages about points that should form a line from left to right, or about the first invalid line."""
    points = array_of(given)
    most_axes = 15 if many else 2
    shape = points.shape
    are_numbers = points.dtype.kind in "iuf"
    has_axes = 2 <= points.ndim <= most_axes
    are_points = has_axes and shape[-1] == 2
    if not are_numbers or not are_points or shape[-2] < 2:
        return [f"{{{name}}}: must be a list of at least two points [x, y] in m, from left to right"]
    *lanes, count, _ = shape
    one_axis = points.reshape(-1, count, 2)
    lines = one_axis.astype(float)
    faults = line_errors(name, lines)
    return complaint(faults, tuple(lanes))


def continued(lines: Floats, left: Any, right: Any) -> Floats:
    """Return lines (n, V, 2) extended by horizontal edges at least to given x at both ends, (n, V + 2, 2)."""
    first = lines[:, :1]
    last = lines[:, -1:]
    longer = np.concatenate([first, lines, last], axis=1)
    x = longer[..., 0].T
    x[0] = np.minimum(left, x[0] - 1.0)
    x[-1] = np.maximum(right, x[-1] + 1.0)
    return longer


def slope_errors(given: Values, bounds: Mapping[str, Bounds]) -> Texts:
    """Return messages about the fields of one slope, which are numbers except for its lines."""
    own = {}
    for name, limits in bounds.items():
        _, _, allowed = limits
        if allowed and name in given and not _is_absent(name, given):
            own[name] = limits
    numbers = mistakes(given, own, one=own)
    return numbers + _lines_errors(given, many=False)


def _is_absent(name: str, given: Values) -> bool:
    """Return whether an optional field is None."""
    return name in ("base", "between", "datum") and given[name] is None


def section_errors(given: Values, quantities: Mapping[str, Parameter], bounds: Mapping[str, Bounds]) -> Texts:
    """Return messages about the fields of sections, which may have axes of lanes before those of one section."""
    own = {}
    for name, p in quantities.items():
        if p.allowed and not _is_absent(name, given):
            own[name] = bounds[name]
    errors = mistakes(given, own, one=("base", "water_unit_weight"))
    if not errors:  # all of them are numbers
        errors = _pair_errors(given, bounds)
    errors += _lines_errors(given, many=True)
    if errors:
        return errors
    of_lanes = {}
    for name, p in quantities.items():
        value = given[name]
        if p.kind == "number" and value is not None:
            shape = leading_shape(value, p.axes)
            of_lanes[name] = np.empty(shape)
            if 0 in shape:
                errors.append(f"{{{name}}}: is empty")
    return shape_mistakes(of_lanes) or errors


def _pair_errors(given: Values, bounds: Mapping[str, Bounds]) -> Texts:
    """Return messages about the centre, a pair of numbers, and the range of x, an increasing pair."""
    wrong = []
    *_, coordinates = np.atleast_1d(given["centre"]).shape
    if coordinates != 2:
        wrong.append("centre")
    pair = given["between"]
    if pair is not None:
        are_two = np.shape(pair) == (2,)
        if not are_two or pair[0] >= pair[1]:
            wrong.append("between")
    messages = []
    for name in wrong:
        *_, allowed = bounds[name]
        messages.append(f"{{{name}}} = {given[name]!r}: must be {allowed}")
    return messages


def _lines_errors(given: Values, many: bool) -> Texts:
    """Return messages about the ground, the water level and ponds."""
    errors = points_errors("ground", given["ground"], many)
    if given["level"] is not None:
        errors += points_errors("level", given["level"], many)
    confined = given["confined"]
    if not isinstance(confined, bool):
        errors.append(f"{{confined}} = {confined!r}: must be True or False")
    elif confined and given["level"] is None:
        errors.append("{confined}: has no {level}; give the level, or leave {confined} out")
    for k, pond in enumerate(given["ponds"], 1):
        errors += _pond_errors(k, pond)
    return errors


def _pond_errors(k: int, pond: Any) -> Texts:
    """Return a message if a pond, counted from 1, does not consist of three numbers."""
    numbers = np.asarray(pond)
    if numbers.shape == (3,) and numbers.dtype.kind in "iuf" and np.all(np.abs(numbers) < FAR):
        first, last, _ = numbers
        if first < last:
            return []
    return [f"{{pond.{k}}} = {pond!r}: must be x of its left and of its right end, and its level, in m"]


def simple_slope(height: float, *, angle: float | None = None, run: float | None = None) -> Floats:
    """Return the points of a straight slope that falls to the right from level ground to a toe at the origin, m.

    The level ground on either side has the length of four heights plus the run.

    Parameters
    ----------
    height : float
        Height of the slope, m.
    angle, run : float
        Inclination of the slope in rad, at most pi/2, or its horizontal length in m. Exactly one is required.
    """
    bounds = {"height": (0.0, INFINITY, "a positive length in m")}
    if run is not None:
        bounds["run"] = (-5e-324, INFINITY, "a length of at least 0 in m")
    if angle is not None:
        bounds["angle"] = (0.0, 1.5707963267948968, "above 0 and at most pi/2 (rad)")
    fields: ValueDict = {"height": height, "run": run, "angle": angle}
    errors = mistakes(fields, bounds)
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
    """Return two points, or many pairs of points, ordered from left to right."""
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
    """Return centre and radius of the circle through two points, by its radius or its depth below the chord.

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
