"""The paper's closed form in time (3.20), (4.3): frozen geometry, constant friction, nothing of time or speed alone.

Each phase has d(omega)/dt = a - b omega^2 with a the drive of its prologue and b what its program takes from omega^2.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated import cells as its
from generated import motion as formulas
from slipcircle.core.flow.columns import Columns
from slipcircle.core.flow.program import Log, Program, Samples
from slipcircle.core.flow.tables import Data
from slipcircle.core.flow.walk import Walker

Floats = NDArray[np.float64]
STATES = ("rotation", "angular_velocity", "angular_acceleration")


def walk(
    program: Program, tables: Sequence[Data], cells: Floats, samples: Samples | None = None, log: Log | None = None
) -> None:
    """As `walk.walk`, for lanes that friction presses on throughout; others it leaves as they are."""
    lanes = _Closed(program, tables, cells.copy(), samples, np.arange(cells.shape[1]), log)
    with np.errstate(all="ignore"):
        lanes.on(lanes.c[its.STATUS] == its.START, "start")
        pressed = (lanes.c[program.roles["cell_normal0"]] > 0.0) & np.isfinite(lanes.c[its.OMEGA])
        while np.any(moving := (lanes.c[its.STATUS] == its.MOVING) & pressed):
            lanes.on(moving, "step")
    cells[:, pressed] = lanes.c[:, pressed]


def brake(lanes: Columns) -> Floats:
    """b: what a unit of omega^2 takes from the rate, by the program itself."""
    part = Columns(lanes.program, lanes.tables, lanes.c.copy(), None, lanes.which)
    part.c[lanes.program.roles["cell_drive"]], part.c[its.OMEGA], part.c[its.X] = 0.0, 1.0, 0.0
    return np.asarray(-part._series(0)[0][lanes.program.roles["net"], 0])


class _Closed(Walker):
    """Lanes of which a step is a phase, up to its standstill or its end."""

    def step(self) -> None:
        c, p = self.c, self.program
        c[its.STEPS] += 1.0
        of = (c[p.roles["cell_drive"]].copy(), brake(self), c[its.OMEGA].copy())

        def state(name: str, *at: Any) -> Any:
            return np.asarray(getattr(formulas, f"frozen_{name}")(*of, *at))

        gone = until = c[its.END_TIME] - c[its.TIME]
        stops = of[0] < 0.0
        if np.any(stops):
            stop, gone = state("arrest_time"), state("arrest_rotation")
            stops &= stop < until
            until = np.where(stops, stop, until)
        endless = np.isinf(until)
        c[its.STATUS, endless] = its.TOO_LONG
        until = np.where(endless, 0.0, until)
        x, speed, rate = (state(name, until) for name in STATES)
        # At the start, by the same formula.
        fastest = (c[its.PEAK_TIME] == c[its.TIME]) & (np.abs(c[its.PEAK_OMEGA]) == of[2])
        first = c[its.DIRECTION] * state(STATES[2], np.zeros_like(until))
        c[its.PEAK_RATE] = np.where(fastest, first, c[its.PEAK_RATE])
        if self.samples is not None:
            self._write(until, stops, state)
        c[its.X], c[its.OMEGA] = np.where(stops, gone, x), np.where(stops, 0.0, speed)
        c[its.TIME] = np.where(stops, c[its.TIME] + until, c[its.END_TIME])
        ends = ~stops & ~endless
        self.on(ends, "look", rate[ends])
        self.on(stops, "stand")
        self.on(ends, "end", rate[ends])

    def _write(self, until: Floats, stops: Any, state: Any) -> None:
        """States at sample times within the phase."""
        c, s = self.c, self.samples
        assert s is not None
        begin, times = c[its.TIME], s.times[:, self.which]
        end = np.where(stops, begin + until, c[its.END_TIME])
        now = (times >= begin) & ((times < end) | (~stops & (times == end)))
        x, omega, rate = (state(name, np.where(now, times - begin, 0.0)) for name in STATES)
        side = c[its.DIRECTION]
        for row, value in enumerate((c[its.ROTATION] + side * x, side * omega, side * rate, c[its.SLIP] + x)):
            s.states[row][:, self.which] = np.where(now, value, s.states[row][:, self.which])
