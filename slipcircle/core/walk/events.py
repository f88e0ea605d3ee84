"""Events that end a step: a register reaches a bound."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from slipcircle.base.kinds import Floats
from slipcircle.core.walk.polynomials import divided_by_time, first_root

Kinds = NDArray[np.intp]  # of events, one of each lane


class Event(NamedTuple):
    """A register reaches a bound, from above, or with a negative sign from below."""

    kind: int
    register: int
    sign: Any = 1.0
    bound: Any = 0.0
    passed: Any = False  # where the phase has begun with this event

    def margin(self, registers: Floats) -> Floats:
        """How far each lane is from the event; positive before it."""
        beyond_bound = registers[self.register] - self.bound
        return np.asarray(self.sign * beyond_bound)

    def time(self, series: Floats, h: Floats) -> Floats:
        """Time of the event within a step, except at its start; infinity without one."""
        margin = self.sign * series[self.register]
        margin[0] -= self.sign * self.bound
        ahead = divided_by_time(margin, self.passed)
        return first_root(ahead, h)


class FirstEvent:
    """The first event of a step in each lane: each event is searched in what the events before leave of the step."""

    def __init__(self, h: Floats) -> None:
        self.time = h
        self.kind = np.full(h.shape, ix.EVENT_NONE)

    def consider(self, kind: int, time: Floats) -> None:
        """An event at some time, infinite where there is none."""
        is_first = time <= self.time
        self.kind = np.where(is_first, kind, self.kind)
        self.time = np.minimum(self.time, time)
