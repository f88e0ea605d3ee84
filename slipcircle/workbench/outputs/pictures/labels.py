"""Labels that matplotlib places, when it draws, where they cover least.

Candidate places lie at several distances and in several directions from each anchor of a label. The cost of a place
adds the ink of lines, marks and outlines that the label would cover, its overlap with other labels and with the edge of
the axis, and the distance. Labels are placed in the order of their creation, so that pictures are reproducible.
"""

import math
from functools import lru_cache
from itertools import chain, takewhile
from typing import Any

import numpy as np
from matplotlib.backends.backend_agg import RendererAgg
from matplotlib.patheffects import withStroke
from matplotlib.text import Annotation, Text

from slipcircle.base.kinds import ArrayPair, Floats, ValueDict

_DISTANCES = (6.0, 14.0, 26.0, 42.0, 62.0, 86.0, 115.0)  # distances of a label from an anchor, in points
_NEAR = 15.0  # points, greatest distance of a label without a leader
_DIRECTIONS = np.linspace(0.0, 2 * math.pi, 16, endpoint=False)
_GAP = 2.0  # free space around labels, in pixels
_CONTRAST, _DARK = 24.0, 200.0  # least difference of grey, of 255, at an edge; grey of thick lines
# Costs: an edge pixel, a pixel outside the axis, an overlap with a label, a pixel of distance.
_COVERED, _OUTSIDE, _WORDS, _FAR = 0.2, 200.0, 400.0, 0.25
BACK = 1.5  # `zorder` below which artists may be covered
_HALO = 2.5  # width of the white outline of a label, in points


class Label(Annotation):
    """Label beside the best of its anchors, which are points in data coordinates; if ``inside``, on it."""

    def __init__(self, ax: Any, words: str, anchors: Any, colour: str, inside: bool = False, **more: Any) -> None:
        self.anchors = np.reshape(np.asarray(anchors, dtype=np.float64), (-1, 2))
        self.inside, self._placed_for = inside, b""
        self.parent: Any = ax
        line = {"arrowstyle": "-", "lw": 0.8, "color": colour, "shrinkA": 0.0, "shrinkB": 1.0}
        style: ValueDict = {"color": colour, "fontsize": "small", "ha": "center", "va": "center", "zorder": 6}
        style |= {"textcoords": "offset pixels", "arrowprops": line, **more}
        super().__init__(words, tuple(self.anchors[0]), (0, 0), **style)
        self.set_path_effects([withStroke(linewidth=_HALO, foreground="white")])
        self.leader: Any = self.arrow_patch
        self.set_in_layout(False)
        ax.add_artist(self)

    def update_positions(self, renderer: Any) -> None:
        """Place the label when matplotlib is about to draw it."""
        limits = np.column_stack([self.parent.get_xlim(), self.parent.get_ylim()])
        where = np.concatenate([limits, self.parent.transData.transform(limits)]).tobytes()
        if where != self._placed_for:
            self._placed_for = where
            self._place(renderer)
        super().update_positions(renderer)

    def _place(self, renderer: Any) -> None:
        """Move the label to the anchor and the offset of least cost."""
        pixels = renderer.points_to_pixels(1.0)
        self.leader.set_visible(False)
        half = np.array(Text.get_window_extent(self, renderer).size) / 2
        distances, offsets = self._offsets(half, pixels)
        anchors = self.parent.transData.transform(self.anchors)
        centres = anchors[:, None] + offsets
        half = half + _GAP
        edges = _summed_edges(self.parent, renderer.get_canvas_width_height(), self._placed_for)
        cost = _FAR * distances + _cost(edges, self.parent.bbox, centres, half)
        before = (takewhile(lambda text: text is not self, ax.texts) for ax in _beside(self.parent))
        for text in filter(Text.get_text, chain.from_iterable(before)):
            box = Text.get_window_extent(text, renderer)
            overlaps = np.all((centres - half < box.max) & (centres + half > box.min), axis=-1)
            cost += _WORDS * (overlaps + _crosses(anchors, centres, box) / 4)
        anchor, place = np.unravel_index(np.argmin(cost), cost.shape)
        self.xy = tuple(self.anchors[anchor])
        self.set_position(tuple(offsets[place]))
        self.leader.set_visible(distances[place] > _NEAR * pixels)

    def _offsets(self, half: Floats, pixels: float) -> ArrayPair:
        """Return distances from an anchor, (places,), and offsets of the centre of a label, (places, 2), in pixels.

        ``half`` is half the size of the label in pixels, and ``pixels`` the length of a point in pixels.
        """
        if self.inside:
            return np.zeros(1), np.zeros((1, 2))
        away = np.stack([np.cos(_DIRECTIONS), np.sin(_DIRECTIONS)], axis=1)
        distances = np.repeat(_DISTANCES, len(away)) * pixels
        directions = np.tile(away, (len(_DISTANCES), 1))
        return distances, (distances[:, None] + half) * directions


def _crosses(anchors: Floats, centres: Floats, box: Any) -> Any:
    """Return whether lines from anchors (n, 2) to centres (n, places, 2) cross a box, (n, places), all in pixels."""
    share = np.linspace(0.1, 0.9, 9)[:, None, None, None]
    points = anchors[:, None] + share * (centres - anchors[:, None])
    return np.any(np.all((points > box.min) & (points < box.max), axis=-1), axis=0)


def _beside(ax: Any) -> list[Any]:
    """Return an axis and its twins."""
    return [other for other in ax.figure.axes if other.bbox.bounds == ax.bbox.bounds]


def _cost(sums: Any, frame: Any, centres: Floats, half: Floats) -> Any:
    """Return the costs of edge pixels and of the frame that a label of a half size covers at centres, (..., 2).

    ``sums`` is the result of `_summed_edges`, and ``frame`` the box of the axis; lengths are in pixels.
    """
    low = centres - half - frame.min
    high = centres + half - frame.min
    outside = np.maximum(-low, 0.0) + np.maximum(high - frame.size, 0.0)
    corners = np.clip([low, high], 0, np.subtract(sums.shape[::-1], 1)).astype(int)
    (x_0, x_1), (y_0, y_1) = np.moveaxis(corners, -1, 0)
    covered = sums[y_1, x_1] - sums[y_0, x_1] - sums[y_1, x_0] + sums[y_0, x_0]
    return _OUTSIDE * outside.sum(axis=-1) + _COVERED * covered


@lru_cache(maxsize=8)
def _summed_edges(axes: Any, size: Any, _: bytes) -> Any:
    """Return the numbers of edge pixels below and to the left of each pixel of an axis, (rows, columns).

    These are edges of lines, marks, outlines and hatches on the axis and its twins, on a canvas of a size in pixels.
    """
    across, up = map(math.ceil, size)
    image: Any = RendererAgg(across, up, axes.figure.dpi)  # type: ignore[no-untyped-call]
    for ax in _beside(axes):
        for artist in (*ax.patches, *ax.lines):
            if artist.get_zorder() >= BACK:
                artist.draw(image)
    left, bottom, right, top = np.round(axes.bbox.extents).astype(int)
    pixels = np.asarray(image.buffer_rgba())[::-1][bottom:top, left:right].astype(np.float64)
    grey = 255.0 + (pixels[..., :3].mean(axis=-1) - 255.0) * pixels[..., 3] / 255.0
    along_rows = np.abs(np.diff(grey, axis=1, append=grey[:, -1:]))
    along_columns = np.abs(np.diff(grey, axis=0, append=grey[-1:]))
    edges = (np.maximum(along_rows, along_columns) > _CONTRAST) | (grey < _DARK)
    return np.pad(edges.cumsum(0).cumsum(1), ((1, 0), (1, 0)))
