"""Piecewise polynomials of slip, speed, time or rotation, as a program takes them; `slipcircle.tables` makes them."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import Floats


class Data(NamedTuple):
    """A piecewise polynomial: piece k begins at ``breaks[k]``, with ``coefficients[k]`` in powers of what is beyond.

    The first piece extends below its break, the last one to infinity. ``jumps`` are the discontinuities of a function
    of time at the start of each piece. The coefficients of a ``sine`` are amplitude, rate and phase. Beyond the last
    break of an ``open`` table, that of a Python function, nothing has been sampled yet. Functions of time of which each
    lane has one follow each other: with its ``first`` piece a lane begins, and where its function ends the next piece
    begins at infinity.
    """

    breaks: Floats  # (pieces,), or of functions of the rotation (pieces, lanes)
    coefficients: Floats  # (pieces, terms), or (pieces, terms, lanes)
    jumps: Floats
    sine: bool = False
    open: bool = False
    first: Any = 0.0  # a number, or one of each lane

    def lanes(self, which: Any) -> "Data":
        """The table of some of the lanes."""
        if self.coefficients.ndim < 3:
            return self
        breaks = self.breaks
        if breaks.ndim == 2:
            breaks = np.ascontiguousarray(breaks[:, which])
        of_lanes = self.coefficients[..., which]
        return self._replace(breaks=breaks, coefficients=np.ascontiguousarray(of_lanes))


Tables = Mapping[str, Data]  # by name
