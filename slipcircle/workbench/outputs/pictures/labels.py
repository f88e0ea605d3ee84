"""Labels that matplotlib places, when it draws, where they cover least.

Candidate places lie at several distances and in several directions from each anchor of a label. The cost of a place
adds the points of lines, marks and outlines that the label would cover, its overlap with other labels and with the edge
of the axis, and the distance. Labels are placed in the order of their creation, so that pictures are reproducible.
"""

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.patheffects import withStroke
from matplotlib.text import Annotation, Text

from slipcircle.base.kinds import ArrayPair, Floats, ValueDict

_DISTANCES = (6.0, 14.0, 26.0, 42.0, 62.0, 86.0, 115.0)  # distances of a label from an anchor, in points
_NEAR = 15.0  # points, greatest distance of a label without a leader
_DIRECTIONS = np.linspace(0.0, 2 * math.pi, 16, endpoint=False)
_SPACING, _MOST = 4.0, 1000  # spacing of the sample points of a line, in pixels; their greatest number
_GAP = 2.0  # free space around labels, in pixels
# Costs: a covered point, a pixel outside the axis, an overlap with a label, a pixel of distance.
_COVERED, _OUTSIDE, _WORDS, _FAR = 2.0, 200.0, 400.0, 0.25
BACK = 1.5  # `zorder` below which artists may be covered
_HALO = 2.5  # width of the white outline of a label, in points


class Label(Annotation):
    """Label beside the best of its anchors, which are points in data coordinates; if ``inside``, on it."""

    def __init__(self, ax: Any, words: str, anchors: Any, colour: str, inside: bool = False, **more: Any) -> None:
        self.anchors = np.reshape(np.asarray(anchors, dtype=np.float64), (-1, 2))
        self.inside, self._placed_for = inside, b""
        line = {"arrowstyle": "-", "lw": 0.8, "color": colour, "shrinkA": 0.0, "shrinkB": 1.0}
        style: ValueDict = {"color": colour, "fontsize": "small", "ha": "center", "va": "center", "zorder": 6} | more
        self.parent: Any = ax
        super().__init__(words, tuple(self.anchors[0]), (0, 0), textcoords="offset pixels", arrowprops=line, **style)
        self.set_path_effects([withStroke(linewidth=_HALO, foreground="white")])
        self.leader: Any = self.arrow_patch
        self.set_in_layout(False)
        ax.add_artist(self)

    def update_positions(self, renderer: Any) -> None:
        """Place the label when matplotlib is about to draw it."""
        limits = np.column_stack([self.parent.get_xlim(), self.parent.get_ylim()])
        in_pixels = self.parent.transData.transform(limits)
        where = np.concatenate([limits, in_pixels]).tobytes()
        if where != self._placed_for:
            self._placed_for = where
            self._place(renderer)
        super().update_positions(renderer)

    def _place(self, renderer: Any) -> None:
        """Move the label to the anchor and the offset of least cost."""
        pixels = renderer.points_to_pixels(1.0)
        self.leader.set_visible(False)
        box = Text.get_window_extent(self, renderer)
        half = np.array([box.width, box.height]) / 2
        distances, offsets = self._offsets(half, pixels)
        anchors = self.parent.transData.transform(self.anchors)
        centres = anchors[:, None] + offsets
        cost = _FAR * distances + self._cost(centres, half + _GAP)
        for words in self._other_words(renderer):
            cost += _WORDS * (_overlaps(centres, half + _GAP, words) + _crosses(anchors, centres, words) / 4)
        anchor, place = np.unravel_index(np.argmin(cost), cost.shape)
        self.xy = tuple(self.anchors[anchor])
        self.set_position(tuple(offsets[place]))
        self.leader.set_visible(distances[place] > _NEAR * pixels)

    def _offsets(self, half: Floats, pixels: float) -> ArrayPair:
        """Return distances from an anchor, (places,), and offsets of the centre of a label, (places, 2), in pixels."""
        if self.inside:
            return np.zeros(1), np.zeros((1, 2))
        away = np.stack([np.cos(_DIRECTIONS), np.sin(_DIRECTIONS)], axis=1)
        distances = np.repeat(_DISTANCES, len(away)) * pixels
        directions = np.tile(away, (len(_DISTANCES), 1))
        return distances, (distances[:, None] + half) * directions

    def _cost(self, centres: Floats, half: Floats) -> Floats:
        """Return the costs of a label with a half size at centres, (anchors, places, 2), all in pixels."""
        frame = self.parent.bbox
        too_low = np.maximum(frame.min - centres + half, 0.0)
        too_high = np.maximum(centres + half - frame.max, 0.0)
        cost = _OUTSIDE * (too_low + too_high).sum(axis=-1)
        x, y = np.concatenate([np.empty((0, 2)), *_obstacles(self.parent)]).T
        for of_anchor, at in zip(cost, centres, strict=True):
            beside = np.abs(x[:, None] - at[:, 0]) < half[0]
            above = np.abs(y[:, None] - at[:, 1]) < half[1]
            of_anchor += _COVERED * np.count_nonzero(beside & above, axis=0)
        return cost

    def _placed(self) -> Iterator[Any]:
        """Yield the labels that have been placed, and all other texts."""
        for ax in _beside(self.parent):
            is_later = False
            for text in ax.texts:
                is_later |= text is self
                if text.get_text() and text.get_visible() and not (is_later and isinstance(text, Label)):
                    yield text

    def _other_words(self, renderer: Any) -> Iterator[Any]:
        """Yield the boxes of the texts that have been placed."""
        for text in self._placed():
            yield Text.get_window_extent(text, renderer)


def _overlaps(centres: Floats, half: Floats, box: Any) -> Any:
    """Return whether a label of a half size overlaps a box, for centres (..., 2)."""
    return np.all((centres - half < box.max) & (centres + half > box.min), axis=-1)


def _crosses(anchors: Floats, centres: Floats, box: Any) -> Any:
    """Return whether lines from anchors (n, 2) to centres (n, places, 2) cross a box."""
    share = np.linspace(0.1, 0.9, 9)[:, None, None, None]
    points = anchors[:, None] + share * (centres - anchors[:, None])
    return np.any(np.all((points > box.min) & (points < box.max), axis=-1), axis=0)


def _beside(ax: Any) -> list[Any]:
    """Return an axis and its twins."""
    return [other for other in ax.figure.axes if other.bbox.bounds == ax.bbox.bounds]


def _obstacles(axes: Any) -> Iterator[Floats]:
    """Yield points (n, 2), in pixels, on the lines, marks and outlines of an axis and its twins."""
    frame = axes.bbox
    for ax in _beside(axes):
        for artist in ax.get_children():
            if not artist.get_visible() or artist is ax.patch or artist.get_zorder() < BACK:
                continue
            if not isinstance(artist, Line2D | Patch):
                continue
            path = artist.get_path().transformed(artist.get_transform())
            if isinstance(artist, Line2D) and artist.get_marker() not in ("None", "", None):
                yield _about(np.asarray(path.vertices), artist.get_markersize() * axes.figure.dpi / 72)
            if artist.get_linestyle() != "None":
                for line in path.to_polygons(closed_only=isinstance(artist, Patch)):
                    yield _along(np.asarray(line, dtype=np.float64), frame)
            if isinstance(artist, Patch) and artist.get_hatch():
                yield _inside(path, frame)


def _about(points: Floats, size: float) -> Floats:
    """Return points around the centres of marks of a size in pixels."""
    shares = (-0.5, 0.0, 0.5)
    offsets = size * np.array([(across, up) for across in shares for up in shares])
    around = points[:, None] + offsets
    return np.repeat(around.reshape(-1, 2), 5, axis=0)


def _along(points: Floats, frame: Any) -> Floats:
    """Return equidistant points along a line, clipped to a margin around the frame."""
    is_finite = np.all(np.isfinite(points), axis=1)
    points = points[is_finite]
    if len(points) < 2:
        return points
    points = np.clip(points, frame.min - 50.0, frame.max + 50.0)
    steps = np.diff(points, axis=0)
    lengths = np.hypot(*steps.T)
    along = np.concatenate([[0.0], np.cumsum(lengths)])
    at = np.arange(0.0, along[-1], max(_SPACING, along[-1] / _MOST))
    x, y = points.T
    x_at = np.interp(at, along, x)
    y_at = np.interp(at, along, y)
    return np.column_stack([x_at, y_at])


def _inside(path: Any, frame: Any) -> Floats:
    """Return grid points inside a hatched area."""
    extents = path.get_extents()
    left, bottom = np.maximum(extents.min, frame.min)
    right, top = np.minimum(extents.max, frame.max)
    spacing = 2.0 * _SPACING
    x = np.arange(left, right, spacing)
    y = np.arange(bottom, top, spacing)
    points = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    if not len(points):
        return points
    return points[path.contains_points(points)]
