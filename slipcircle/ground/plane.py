"""Vectors in the plane."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from slipcircle.base.kinds import ArrayPair, Floats


def each_lane(lines: Floats, lanes: int) -> Floats:
    """Return lines with an axis of lanes, (lanes, V, 2), from lines (lanes or 1, V, 2) of V points, without a copy."""
    _, *of_one = lines.shape
    return np.broadcast_to(lines, (lanes, *of_one))


def sine_and_cosine(angle: Floats) -> ArrayPair:
    """Return sine and cosine of angles in rad from the tangent of the half angle, a third of the time of both."""
    tangent = np.tan(angle / 2)
    square = tangent * tangent
    divisor = 1.0 + square
    sine = 2.0 * tangent / divisor
    cosine = (1.0 - square) / divisor
    return sine, cosine


@dataclass(slots=True)
class Vectors:
    """Arrays of plane vectors by their components, which are numbers or `DoubleDouble`."""

    x: Any
    y: Any

    @classmethod
    def of(cls, points: Any) -> "Vectors":
        """Return vectors from an array of points, (..., 2), x and y."""
        return cls(points[..., 0], points[..., 1])

    @property
    def points(self) -> Any:
        """Vectors as an array (..., 2)."""
        return np.stack([self.x, self.y], axis=-1)

    def __iter__(self) -> Iterator[Any]:
        """Return an iterator over the two components."""
        yield self.x
        yield self.y

    def __getitem__(self, index: Any) -> "Vectors":
        """Return the vectors at an index."""
        return Vectors(self.x[index], self.y[index])

    def __neg__(self) -> "Vectors":
        """Return the opposite vectors."""
        return Vectors(-self.x, -self.y)

    def __add__(self, other: "Vectors") -> "Vectors":
        """Return the sum."""
        return Vectors(self.x + other.x, self.y + other.y)

    def __sub__(self, other: "Vectors") -> "Vectors":
        """Return the difference."""
        return Vectors(self.x - other.x, self.y - other.y)

    def __mul__(self, factor: Any) -> "Vectors":
        """Return the vectors times a factor."""
        return Vectors(self.x * factor, self.y * factor)

    def dot(self, other: "Vectors") -> Any:
        """Return scalar products."""
        return self.x * other.x + self.y * other.y

    def cross(self, other: "Vectors") -> Any:
        """Return cross products, positive if the other vector points to the left of this one."""
        return self.x * other.y - self.y * other.x

    @property
    def square(self) -> Any:
        """Squares of the lengths."""
        return self.dot(self)

    @property
    def length(self) -> Any:
        """Lengths of the vectors."""
        return np.hypot(self.x, self.y)

    @property
    def largest(self) -> Any:
        """Greater absolute value of the two components of each vector."""
        x = np.abs(self.x)
        y = np.abs(self.y)
        return np.maximum(x, y)

    @property
    def is_nonzero(self) -> Any:
        """Mask of vectors with a component other than 0."""
        return (self.x != 0.0) | (self.y != 0.0)

    def where(self, mask: Any) -> "Vectors":
        """Return the vectors where a mask is true, and 0 elsewhere."""
        x = np.where(mask, self.x, 0.0)
        y = np.where(mask, self.y, 0.0)
        return Vectors(x, y)

    @property
    def starts(self) -> "Vectors":
        """Points of lines along the last axis, without the last point."""
        return self[..., :-1]

    @property
    def ends(self) -> "Vectors":
        """Points of lines along the last axis, without the first point."""
        return self[..., 1:]

    @property
    def edges(self) -> "Vectors":
        """Vectors from each point to the next."""
        return self.ends - self.starts
