"""Functions of time as polynomials on common segments, cut where one of them passes zero."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.checks import EPS
from slipcircle.inputs.series import Pieces
from slipcircle.methods.roots import root

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]


@dataclass(frozen=True)
class Shape:
    """A function on segments: coefficients by power of the time since a segment's start, and values at its end.

    The first coefficient and the end are exact where the segment was cut at a zero.
    """

    coefficients: Floats
    ends: Floats

    def middle(self, length: Floats) -> Floats:
        """Values in the middle of the segments, whose sign is that of the segment once it is cut at its zeros."""
        return np.asarray(horner(list(self.coefficients), length / 2))

    def largest(self) -> Floats:
        """Of the sizes at both ends."""
        return np.maximum(np.abs(self.coefficients[0]), np.abs(self.ends))

    def pick(self, index: Integers) -> "Shape":
        return Shape(self.coefficients[:, index], self.ends[index])


@dataclass(frozen=True)
class Segments:
    """Segments of time, dimensionless: where they start, how long they are, and functions on them by name."""

    start: Floats
    length: Floats
    shapes: dict[str, Shape]


def horner(coefficients: Sequence[Any], t: Any) -> Any:
    """A polynomial's value."""
    value = coefficients[-1]
    for c in coefficients[-2::-1]:
        value = value * t + c
    return value


def shifted(coefficients: Floats, by: Floats) -> Floats:
    """The coefficients about a point further on."""
    found = coefficients.copy()
    for j in range(len(found)):
        for i in range(len(found) - 2, j - 1, -1):
            found[i] += by * found[i + 1]
    return found


def merge(parts: Sequence[Pieces], last: float, scale: float) -> tuple[Floats, Floats, list[Shape]]:
    """Starts and lengths of common segments from 0 to ``last`` (s), over ``scale``, and the parts on them."""
    if len(parts) == 1 and parts[0].knots[0] == 0.0 and parts[0].knots[-1] == last:
        edges = parts[0].knots
    else:
        inner = np.concatenate([p.knots for p in parts])
        edges = np.unique(np.concatenate([[0.0], inner[(inner > 0.0) & (inner < last)], [last]]))
    length, rows = np.diff(edges), max(len(p.coefficients) for p in parts)
    shapes = [_on(p, edges, length, rows, scale) for p in parts]
    return edges[:-1] / scale, length / scale, shapes


def _on(part: Pieces, edges: Floats, length: Floats, rows: int, scale: float) -> Shape:
    left, count = edges[:-1], len(part.ends)
    piece = np.searchsorted(part.knots, left, side="right") - 1
    held = np.clip(piece, 0, count - 1)
    offset = left - part.knots[held]
    found = part.coefficients[:, held]
    if np.any(offset):
        found = shifted(found, offset)
    ends = np.where(edges[1:] == part.knots[held + 1], part.ends[held], horner(list(found), length))
    for outside, value in ((piece < 0, part.before), (piece >= count, part.after)):
        found[:, outside], ends[outside] = 0.0, value
        found[0, outside] = value
    padded = np.zeros((rows, len(left)))
    for k, row in enumerate(found):
        padded[k] = row * scale**k
    return Shape(padded, ends)


def combine(constant: float, weights: Sequence[float], shapes: Sequence[Shape]) -> Shape:
    """constant + sum of the weighted shapes."""
    found = Shape(weights[0] * shapes[0].coefficients, weights[0] * shapes[0].ends)
    for weight, shape in zip(weights[1:], shapes[1:], strict=True):
        found = Shape(found.coefficients + weight * shape.coefficients, found.ends + weight * shape.ends)
    found.coefficients[0] += constant
    return Shape(found.coefficients, found.ends + constant)


def divide(segments: Segments, parts: Integers) -> Segments:
    """Every segment cut into as many equal parts as said."""
    if parts.max(initial=1) == 1:
        return segments
    index = np.repeat(np.arange(len(parts)), parts)
    number = np.arange(len(index)) - (np.cumsum(parts) - parts)[index]
    short = (segments.length / parts)[index]
    offset = short * number
    last = number == parts[index] - 1
    shapes = {}
    for name, shape in segments.shapes.items():
        moved = shifted(shape.coefficients[:, index], offset)
        following = np.append(moved[0, 1:], 0.0)
        shapes[name] = Shape(moved, np.where(last, shape.ends[index], following))
    return Segments(segments.start[index] + offset, short, shapes)


def cut(segments: Segments, name: str) -> Segments:
    """Cut every segment where a shape passes zero, so that it has one sign on each; at the cuts it is exactly zero."""
    while True:
        index, offset, rest = _crossings(segments.shapes[name], segments.length)
        if not index.size:
            return segments
        twice = np.ones(len(segments.length), dtype=np.intp)
        twice[index] = 2
        row = np.repeat(np.arange(len(twice)), twice)
        second = np.append(False, row[1:] == row[:-1])
        first = np.append(second[1:], False)
        by = np.zeros(len(row))
        by[second] = offset
        length = segments.length[row]
        length[first], length[second] = offset, rest
        shapes = {}
        for key, shape in segments.shapes.items():
            moved = shape.coefficients[:, row]
            moved[:, second] = shifted(moved[:, second], by[second])
            if key == name:
                moved[0, second] = 0.0
            ends = shape.ends[row]
            ends[first] = moved[0, second]
            shapes[key] = Shape(moved, ends)
        segments = Segments(segments.start[row] + by, length, shapes)


def _crossings(shape: Shape, length: Floats) -> tuple[Integers, Floats, Floats]:
    """The first zero inside each segment that has one: segment, time since its start, and time to its end."""
    first, end = shape.coefficients[0], shape.ends
    if len(shape.coefficients) == 1:
        return np.array([], dtype=np.intp), first[:0], first[:0]
    if len(shape.coefficients) == 2:
        index = np.flatnonzero((first < 0.0) & (end > 0.0) | (first > 0.0) & (end < 0.0))
        a, b, h = first[index], end[index], length[index]
        return index, h * (a / (a - b)), h * (b / (b - a))
    reach = np.abs(shape.coefficients[1:]) * length ** np.arange(1, len(shape.coefficients))[:, None]
    perhaps = np.flatnonzero(np.abs(first) <= reach.sum(axis=0))
    found = []
    for k in perhaps:
        whole = float(length[k])
        zeros = _zeros(shape.coefficients[:, k].tolist(), whole, float(end[k]))
        if zeros:
            found.append((k, zeros[0], whole - zeros[0]))
    index = np.array([f[0] for f in found], dtype=np.intp)
    return index, np.array([f[1] for f in found]), np.array([f[2] for f in found])


def _zeros(coefficients: list[float], h: float, end: float) -> list[float]:
    """Where a polynomial passes zero between 0 and h, by the zeros of its derivatives; a mere touch is none."""
    if coefficients[0] == 0.0:
        coefficients, end = coefficients[1:], end / h
    sizes = [abs(c) * h**j for j, c in enumerate(coefficients)]
    noise = 4 * EPS * sum(sizes)
    while len(coefficients) > 1 and sizes[len(coefficients) - 1] < 1e-3 * noise:
        coefficients = coefficients[:-1]
    if len(coefficients) < 2 or coefficients[0] == 0.0:
        return []
    value: Callable[[float], float] = lambda t: float(horner(coefficients, t))  # noqa: E731
    slopes = [j * c for j, c in enumerate(coefficients)][1:]
    steady = abs(slopes[0]) > sum(abs(c) * h**j for j, c in enumerate(slopes[1:], 1))
    turns = [] if steady else _zeros(slopes, h, float(horner(slopes, h)))
    points = [0.0, *turns, h]
    values = [coefficients[0], *(v if abs(v) > noise else 0.0 for v in map(value, turns)), end]
    found = []
    for k in range(len(points) - 1):
        if values[k] * values[k + 1] < 0.0:
            found.append(root(value, points[k], points[k + 1], values[k], values[k + 1]))
    return [t for t in found if 0.0 < t < h]
