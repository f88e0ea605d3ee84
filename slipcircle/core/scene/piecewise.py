"""Piecewise polynomials of slip, speed, time or rotation in the form that programs use."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import Floats


class Data(NamedTuple):
    """Piecewise polynomial whose piece k has ``coefficients[k]`` in powers of the distance from ``breaks[k]``.

    The first piece extends below its break, the last piece to infinity. ``jumps`` are the discontinuities of a function
    of time at the start of each piece. The coefficients of a ``sine`` are amplitude, rate and phase. An ``open`` table
    samples a Python function up to its last break. If each lane has its own function of time, the functions are stored
    one after the other. A lane begins with its ``first`` piece, and the piece after its function begins at infinity.
    """

    breaks: Floats  # (pieces,), or (pieces, lanes) for functions of the rotation
    coefficients: Floats  # (pieces, terms), or (pieces, terms, lanes)
    jumps: Floats
    sine: bool = False
    open: bool = False
    first: Any = 0.0  # a number, or an array over lanes

    def lanes(self, which: Any) -> "Data":
        """Return the table of selected lanes.

        ``which`` is an index of lanes; a table without an axis of lanes is unchanged.
        """
        if self.coefficients.ndim < 3:
            return self
        breaks = self.breaks
        if breaks.ndim == 2:
            breaks = np.ascontiguousarray(breaks[:, which])
        of_lanes = self.coefficients[..., which]
        return self._replace(breaks=breaks, coefficients=np.ascontiguousarray(of_lanes))


Tables = Mapping[str, Data]  # by name
