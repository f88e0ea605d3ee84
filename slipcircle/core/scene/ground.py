"""Grounds and circles as people give them, and what is wrong with them."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from slipcircle.base.checks import INFINITY, Bounds, Fault, InputError, complaint, mistakes, raise_all, shape_mistakes

FAR = 1e9  # m; coordinates are smaller
Floats = NDArray[np.float64]


def line_faults(name: str, lines: Floats) -> Iterator[Fault]:
    """Which of many lines (n, V, 2) do not lead from left to right."""
    with np.errstate(invalid="ignore"):
        step = np.diff(lines, axis=1, prepend=lines[:, :1] - 1.0)

    def at(bad: Any, words: str) -> Fault:
        places = np.argmax(bad, axis=1)
        return bad.any(axis=1), lambda k: f"{{{name}}}[{places[k]}] = {lines[k, places[k]].tolist()}: {words}"

    yield at(~(np.abs(lines) < FAR).all(axis=2), "must be two finite numbers within 1e9 m")
    yield at(~step.any(axis=2), "is the point before it; leave one out")
    yield at(step[..., 0] < 0.0, "lies left of the point before it; order them by x")
    yield (
        lines[:, -1, 0] == lines[:, 0, 0],
        lambda _: f"{{{name}}}: all points lie above each other; it must reach from left to right",
    )


def line_mistakes(name: str, given: Any, many: bool) -> Sequence[str]:
    """What is wrong with points that should make a line from left to right, or with the first of many that is."""
    try:
        points = np.asarray(given)
    except (ValueError, RuntimeError):  # ragged, or nested too deep
        points = np.asarray(None)
    axes, shape = range(2, 16 if many else 3), points.shape
    if points.dtype.kind not in "iuf" or points.ndim not in axes or shape[-1] != 2 or shape[-2] < 2:
        return [f"{{{name}}}: must be a list of at least two points [x, y] in m, from left to right"]
    return complaint(line_faults(name, points.reshape(-1, *shape[-2:]).astype(np.float64)), shape[:-2])


def _upper(lines: Floats, x: Floats) -> Floats:
    """Heights of lines (n, V, 2) at x (n, M), the upper one on a scarp; -inf beyond their ends."""
    (x1, y1), (x2, y2) = (np.moveaxis(ends[:, None], -1, 0) for ends in (lines[:, :-1], lines[:, 1:]))
    at = x[..., None]
    with np.errstate(divide="ignore", invalid="ignore"):
        share = np.where(x2 > x1, (at - x1) / (x2 - x1), y2 > y1)
    return np.asarray(np.where((x1 <= at) & (at <= x2), y1 + share * (y2 - y1), -np.inf).max(axis=-1))


def ponds(grounds: Floats, levels: Floats) -> Fault:
    """Where water levels (n or 1, W, 2) stand above grounds (n or 1, V, 2), or beside them; and what to say of one."""
    n = max(len(grounds), len(levels))
    x = np.concatenate([np.broadcast_to(line[..., 0], (n, line.shape[1])) for line in (grounds, levels)], axis=1)
    ground, level = _upper(grounds, x), _upper(levels, x)
    both = np.isfinite(ground) & np.isfinite(level)
    over = np.where(both, level, -np.inf) - np.where(both, ground, 0.0)

    def said(k: int) -> str:
        at = int(np.argmax(over[k]))
        if not both[k].any():
            return "{level}: lies beside the ground; it must reach over it"
        return (
            f"{{level}}: stands {over[k, at]:.4g} m above the ground at x = {x[k, at]:.10g}; ponds are not yet possible"
        )

    return ~both.any(axis=1) | (over.max(axis=1) > 1e-9 * np.ptp(grounds, axis=(1, 2))), said


_WEIGHT, _STRESS = "a positive unit weight in N/m^3", "a stress of at least 0 in Pa"
_BOUNDS: Mapping[str, Bounds] = {
    "radius": (0.0, FAR, "a positive length below 1e9 m"),
    "unit_weight": (0.0, 1e6, _WEIGHT),
    "width": (0.0, INFINITY, "a positive length in m"),
    "gravity": (0.0, INFINITY, "a positive acceleration in m/s^2"),
    "water_unit_weight": (0.0, 1e6, _WEIGHT),
    "centre": (-FAR, FAR, "two finite numbers [x, y] within 1e9 m"),
    "base": (-FAR, FAR, "one finite number in m"),
    "between": (-FAR, FAR, "two x in m, from left to right"),
    "cohesion": (-5e-324, INFINITY, _STRESS),
    "pressure": (-5e-324, INFINITY, _STRESS),
    "friction": (-5e-324, 5.0, "a friction coefficient tan(phi) from 0 to 5; an angle is its arctangent"),
    "pore_ratio": (-5e-324, 1.0, "at least 0 and below 1"),
    "k_h": (-1.0, 1.0, "between -1 and 1"),
}


def field_mistakes(given: Mapping[str, Any], axes: Mapping[str, int] | None = None) -> list[str]:
    """What is wrong with the fields of a slope; or of sections, also as shapes in front of the axes of one."""
    bounds = {n: b for n, b in _BOUNDS.items() if n in given and (given[n] is not None or n not in ("base", "between"))}
    found: list[str] = [*mistakes(given, bounds, one=("base", "water_unit_weight") if axes else bounds)]
    if not found and axes:  # all of them are numbers
        pair, odd = given["between"], [] if np.shape(given["centre"])[-1:] == (2,) else ["centre"]
        if pair is not None and not (np.shape(pair) == (2,) and pair[0] < pair[1]):
            odd.append("between")
        found = [f"{{{n}}} = {given[n]!r}: must be {bounds[n][2]}" for n in odd]
    lines = [n for n in ("ground", "level") if n == "ground" or given[n] is not None]
    found += [m for n in lines for m in line_mistakes(n, given[n], bool(axes))]
    if axes and not found:
        held = {n: np.shape(given[n]) for n in axes if given[n] is not None}
        shaped = {n: np.empty(shape[: len(shape) - axes[n]]) for n, shape in held.items()}
        found += shape_mistakes(shaped) or [f"{{{n}}}: is empty" for n, v in shaped.items() if not np.size(v)]
    return found


def simple_slope(height: float, *, angle: float | None = None, run: float | None = None) -> Floats:
    """Points of a straight slope that falls to the right between level ground, its toe at the origin, m.

    The level ground on either side is four heights and the run long.

    Parameters
    ----------
    height : float
        m.
    angle, run : float
        Of the slope in rad, up to upright, or its horizontal length in m; one of them.
    """
    bounds = {
        "height": (0.0, INFINITY, "a positive length in m"),
        "run": (-5e-324, INFINITY, "a length of at least 0 in m"),
        "angle": (0.0, 1.5707963267948968, "above 0 and at most pi/2 (rad)"),
    }
    given = {n: v for n, v in {"height": height, "run": run, "angle": angle}.items() if v is not None}
    found = [] if len(given) == 2 else ["{angle} or {run}: give one of them"]
    raise_all("simple_slope", mistakes(given, {n: bounds[n] for n in given}) + found)
    if angle is not None:
        run = 0.0 if angle > 1.5707963 else height / float(np.tan(angle))
    assert run is not None
    flat = 4 * height + run
    return np.array([[-run - flat, height], [-run, height], [0.0, 0.0], [flat, 0.0]])


def _from_left(first: ArrayLike, second: ArrayLike) -> tuple[Floats, Floats]:
    """Two points, or many pairs of them, each from left to right."""
    p, q = np.asarray(first, dtype=np.float64), np.asarray(second, dtype=np.float64)
    swap = p[..., :1] > q[..., :1]
    return np.where(swap, q, p), np.where(swap, p, q)


def circle_through(
    first: ArrayLike, second: ArrayLike, *, radius: ArrayLike | None = None, depth: ArrayLike | None = None
) -> tuple[Any, Any]:
    """Centre and radius of the circle through two points, its centre above, by its radius or its depth below the chord.

    Raises
    ------
    ValueError
        For points above each other, a radius below half their distance, or a depth above it (beyond a half disc).
    """
    p, q = _from_left(first, second)
    half = np.hypot(*np.moveaxis(q - p, -1, 0)) / 2
    found = ["{radius} or {depth}: give one of them"] if (radius is None) == (depth is None) else []
    if np.any(p[..., 0] == q[..., 0]):
        found.append("the two points lie above each other; a slip circle leads from one side to the other")
    elif radius is not None and np.any(np.asarray(radius) < half):
        found.append(
            f"{{radius}} = {np.min(radius):.10g}: must be at least half the distance of the points, {np.max(half):.10g}"
        )
    elif depth is not None and np.any((np.asarray(depth) <= 0.0) | (np.asarray(depth) > half)):
        found.append(
            f"{{depth}} = {np.max(depth):.10g}: must be above 0 and at most half the distance of the points, "
            f"{np.min(half):.10g}"
        )
    raise_all("circle_through", found)
    if depth is not None:
        radius = (half**2 + np.square(depth)) / (2 * np.asarray(depth))
    rise = np.sqrt((np.asarray(radius) - half) * (np.asarray(radius) + half))
    up = np.stack([-(q - p)[..., 1], (q - p)[..., 0]], axis=-1) / (2 * half)[..., None]
    return (p + q) / 2 + up * rise[..., None], np.asarray(radius)[()]


def circle_touching(first: ArrayLike, second: ArrayLike, level: ArrayLike) -> tuple[Any, Any]:
    """Centre and radius of the circle through two points (entry and exit) that touches a level between them from above.

    Raises
    ------
    ValueError
        For a level that is above a point, or at the height of both.

    Notes
    -----
    At heights h >= l of the points above the level, and a run between them, the circle touches the level at a distance
    u = h (run^2 - l (h - l))/(h run + sqrt(h l (run^2 + (h - l)^2))) from the higher point, towards the lower one.
    """
    (p, q), base = _from_left(first, second), np.asarray(level, dtype=np.float64)
    from_left, from_right, run = p[..., 1] - base, q[..., 1] - base, (q - p)[..., 0]
    high, low = np.maximum(from_left, from_right), np.minimum(from_left, from_right)
    if np.any((low < 0.0) | (high <= 0.0)) or np.any(run == 0.0):
        said = f"{{level}} = {np.max(base):.10g}: must lie below both points or touch the lower one, and the points "
        raise InputError("circle_touching", [f"{said}must not lie above each other"])
    between = np.sqrt(high * low * (run**2 + (high - low) ** 2))
    away = high * (run**2 - low * (high - low)) / (high * run + between)
    radius = (away**2 + high**2) / (2 * high)
    x = np.where(from_left >= from_right, p[..., 0] + away, q[..., 0] - away)
    return np.stack([x, base + radius], axis=-1), radius[()]
