"""Lanes at rest, in NumPy: where phases begin, whether a mass stays at a standstill, and until when."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from slipcircle.base.checks import EPS
from slipcircle.core.flow.columns import Columns
from slipcircle.core.flow.polynomials import divided, first_root

Floats = NDArray[np.float64]


class Resting(Columns):
    """Lanes between their phases."""

    def begin(self) -> None:
        """A phase of motion begins, in the direction that is set; what presses decides whether it is lifted."""
        c = self.c
        c[ix.STATUS], c[ix.PASSED], c[ix.LIFTED] = ix.MOVING, ix.NOTHING, 0.0
        self.base()
        normal = self.program.roles["normal"]
        presses = c[self.program.roles["cell_normal0"]] if normal < 0 else self._series(0)[0][normal, 0]
        c[ix.LIFTED] = presses < 0.0
        self.on(c[ix.LIFTED] > 0.0, "base")
        c[ix.PHASES] += 1.0
        c[ix.TURNS] += c[ix.LAST_WAY] * c[ix.DIRECTION] < 0.0
        c[ix.LAST_WAY] = c[ix.DIRECTION]
        self._note(ix.NOTE_BEGINS)
        self._lift_time(c[ix.LIFTED] > 0.0)
        self.look(self._series(0)[0][self.program.roles["net"], 0])

    def decide(self, stopped: bool = False) -> None:
        """At a standstill: the way in which the mass moves on, if any; else it rests, or waits for another time."""
        c = self.c
        c[ix.X] = c[ix.OMEGA] = 0.0
        best = np.zeros(c.shape[1])
        for side in (1.0, -1.0):
            net = self._margin(side, stopped)
            best = np.where((net > 0.0) & (best == 0.0), side, best)
        c[ix.DIRECTION] = best
        self.on(best != 0.0, "begin")
        still = best == 0.0
        self._lift_time(still & (c[ix.LIFTED] > 0.0))
        waits = still & self._changes()
        c[ix.STATUS, waits] = ix.RESTING
        c[ix.STATUS, still & ~waits] = ix.ARRESTED
        self.on(still & ~waits, "rest")

    def _margin(self, side: float, stopped: bool) -> Floats:
        """The drive less the resistance at rest, in one direction; minus infinity where it may not start that way."""
        c = self.c
        self._face(side)
        roles = self.program.roles
        net = c[roles["cell_drive"]]
        terms = np.abs(c[roles["cell_driving"]]) + c[roles["cell_resisting"]]
        scale = np.maximum(EPS * (terms + c[roles["cell_mu"]] * np.abs(c[roles["cell_normal0"]])), 1e-300)
        # What has just stopped does not go on the way it came: rounding must not say so.
        allowed = self.may_start(side) & ~(stopped & (c[ix.LAST_WAY] == side))
        c[ix.CLOSE] = np.where(allowed, np.minimum(c[ix.CLOSE], np.abs(net) / scale), c[ix.CLOSE])
        return np.where(allowed, net, -np.inf)

    def _face(self, side: float) -> None:
        """The numbers of a phase from rest in one direction."""
        c = self.c
        toggled, lifted = c[ix.PASSED] == ix.LIFT, c[ix.LIFTED].copy()  # just now, at rest
        c[ix.DIRECTION], c[ix.LIFTED] = side, 0.0
        self.base()
        c[ix.LIFTED] = np.where(toggled, lifted, c[self.program.roles["cell_normal0"]] <= 0.0)
        self.on(c[ix.LIFTED] > 0.0, "base")

    def rest(self) -> None:
        """A lane that stays where it is."""
        c = self.c
        c[ix.END_ROTATION], c[ix.END_OMEGA], c[ix.END_RATE] = c[ix.ROTATION], 0.0, 0.0
        over = c[ix.REST_SINCE] > c[ix.END_TIME]  # cannot be, but for rounding
        c[ix.REST_SINCE, over] = c[ix.END_TIME, over]
        self._read(c[ix.TIME], np.full(c.shape[1], np.inf), None)

    def wait(self) -> None:
        """One step of lanes at rest: to the next break of what changes with time, or to where the mass starts."""
        c, p = self.c, self.program
        net_of = p.roles["net"]
        begins, way, jumps = np.full(c.shape[1], np.inf), np.zeros(c.shape[1]), np.zeros(c.shape[1], dtype=bool)
        limit = self._break()
        h = np.where(np.isfinite(limit), limit - c[ix.TIME], 1.0)
        stretch = h.copy()
        margins = []
        for side in (1.0, -1.0):
            self._face(side)
            r, last = self._series(int(c[ix.ORDER].max()), frozen=True)
            stretch = np.minimum(stretch, self._length(r, last, [net_of]))
            touching = np.abs(r[net_of, 0]) <= 2 * c[p.roles["cell_drive_scale"]]
            margins.append((side, r[net_of].copy(), self.may_start(side) | np.zeros(c.shape[1], dtype=bool), touching))
        self._lift_time(c[ix.LIFTED] > 0.0)
        for side, net, allowed, touching in margins:
            now = allowed & (net[0] > 0.0) & ~touching
            series = divided(-net, touching)
            at = np.where(now, 0.0, first_root(series, stretch))
            at = np.where(touching & (series[0] < 0.0), 0.0, at)
            sooner = allowed & (at < begins)
            begins, way = np.where(sooner, at, begins), np.where(sooner, side, way)
            jumps = np.where(sooner, now, jumps)
        lifts = np.full(c.shape[1], np.inf)
        if (normal := p.roles["normal"]) >= 0:
            series = r[normal] * np.where(c[ix.LIFTED] > 0.0, -1.0, 1.0)
            lifts = first_root(divided(series, c[ix.PASSED] == ix.LIFT), stretch)
            lifts[lifts > begins * (1.0 + 1e-9)] = np.inf  # where both pass zero, it is lifted and does not start
            begins[np.isfinite(lifts)] = np.inf
            stretch = np.minimum(stretch, lifts)
        starts = np.isfinite(begins)
        until = np.where(starts, c[ix.TIME] + begins, np.where(stretch < h, c[ix.TIME] + stretch, limit))
        over = ~starts & ~np.isfinite(until)
        late = (until >= c[ix.END_TIME]) & ~over
        self._read(c[ix.TIME], np.minimum(until, c[ix.END_TIME]), None)
        c[ix.DIRECTION] = way
        lifted = np.isfinite(lifts) & ~starts & ~over
        c[ix.PASSED] = np.where(lifted, ix.LIFT, ix.NOTHING)
        c[ix.LIFTED] = np.where(lifted, 1.0 - c[ix.LIFTED], c[ix.LIFTED])
        c[ix.STATUS, over] = ix.ARRESTED
        c[ix.STATUS, late] = ix.PAUSED  # what happens after its end time decides nothing
        c[ix.TIME] = np.where(over, c[ix.TIME], np.minimum(until, c[ix.END_TIME]))
        self.on(over | late, "rest")
        self._lift_time(lifted & ~late & (c[ix.LIFTED] > 0.0))
        self._pass_breaks(~starts & ~over & (c[ix.TIME] >= limit))
        goes = starts & ~late
        self.on(goes, "start_again", jumps[goes])

    def start_again(self, jump: Any) -> None:
        """A phase from rest, where the margin passes zero: unless that leaps, what drives is zero and no more."""
        self.begin()
        self.c[self.program.roles["cell_drive"], ~jump] = 0.0
