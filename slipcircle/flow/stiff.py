"""Lanes that explicit steps are too short for, such as creep through a viscous layer: LSODA on the same program.

The walk, its phases and its events stay; a step goes to the next break or event and is one call of SciPy.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.flow import walk as w
from slipcircle.flow.program import Program
from slipcircle.flow.tables import Data

Floats = NDArray[np.float64]
TOLERANCE = 1e-12


def walk(program: Program, tables: Sequence[Data], cells: Floats, samples: w.Samples | None = None,
         log: w.Log | None = None, which: Any = ()) -> None:  # fmt: skip
    """As `slipcircle.flow.walk.walk`, for some lanes, one after the other, from where they are."""
    for lane in which:
        one = _Implicit(program, [t.lanes([lane]) for t in tables], cells[:, [lane]], samples, np.array([lane]), log)
        one.c[w.STATUS], one.c[w.STEPS] = w.MOVING, 0.0
        with np.errstate(all="ignore"):
            one.rebase()
            while one.c[w.STATUS, 0] <= w.RESTING:
                one.round()
        cells[:, lane] = one.c[:, 0]


class _Implicit(w.Lanes):
    """One lane, a step of which is an implicit integration."""

    def step(self) -> None:
        from scipy.integrate import solve_ivp  # only here

        c, p = self.c, self.program
        begin, limit = c[w.TIME, 0], min(self._break()[0], c[w.END_TIME, 0])
        kept, increments = c.copy(), [slot.cells + w.INC for slot in p.tables]
        states = [cell for cell, _, _ in p.states]
        names = [n for n in ("normal", "upright") if p.roles[n] >= 0]

        def at(t: float, y: Floats) -> Floats:
            c[:] = kept
            c[w.TIME, 0], c[states, 0] = t, y
            for slot, cell in zip(p.tables, increments, strict=True):
                if slot.kind == "time":
                    now = self._local(slot, self.tables[p.tables.index(slot)])[0, 0]
                    c[cell, 0] = kept[cell, 0] + now - self._first[cell]
            return np.asarray(self._series(0)[0][:, 0, 0])

        self._first = {slot.cells + w.INC: self._local(slot, self.tables[k])[0, 0]
                       for k, slot in enumerate(p.tables) if slot.kind == "time"}  # fmt: skip

        def rates(t: float, y: Floats) -> list[float]:
            r = at(t, y)
            return [r[rate] for _, _, rate in p.states]

        def event(of: Any) -> Any:
            of.terminal, of.direction = True, -1.0
            return of

        sign = -1.0 if c[w.LIFTED, 0] > 0.0 else 1.0
        found = [event(lambda t, y: y[1])]
        kinds = [0]
        for name in names:
            found.append(event(lambda t, y, n=name: (sign if n == "normal" else 1.0) * at(t, y)[p.roles[n]]))
            kinds.append(1 if name == "normal" else 99)
        for k, slot in enumerate(p.tables):
            upper, lower = kept[slot.cells + w.UPPER, 0], kept[slot.cells + w.LOWER, 0]
            if slot.kind == "slip" and np.isfinite(upper):
                found.append(event(lambda t, y, u=upper: u - y[0]))
                kinds.append(2 + 2 * k)
            if slot.kind == "speed":
                found += [event(lambda t, y, u=upper: u - y[1]), event(lambda t, y, b=lower: y[1] - b if b else 1.0)]
                kinds += [2 + 2 * k, 3 + 2 * k]
        top = event(lambda t, y: at(t, y)[p.roles["net"]])
        top.terminal = False
        y0 = kept[states, 0]
        size = np.maximum(np.abs(y0), [1e-12, 1e-12 * max(y0[1], abs(c[w.PEAK_OMEGA, 0]), 1e-9)] + [1e-12] * len(y0[2:]))
        wanted = self._wanted(begin, limit)
        done = solve_ivp(rates, (begin, limit), y0, "LSODA", rtol=TOLERANCE, atol=TOLERANCE * size,
                         events=[*found, top], dense_output=bool(len(wanted)))  # fmt: skip
        for t, y in zip(done.t_events[-1], done.y_events[-1], strict=True):
            c[:] = kept
            self._fastest(np.array([y[1]]), np.array([t]), c[w.ROTATION] + c[w.DIRECTION] * y[0], np.zeros(1))
            kept[w.PEAK_TIME : w.PEAK_RATE + 1] = c[w.PEAK_TIME : w.PEAK_RATE + 1]
        hit = [k for k, t in zip(kinds, done.t_events, strict=False) if len(t)]
        end, y = done.t[-1], done.y[:, -1]
        rate = at(end, y)[p.roles["net"]]
        if len(wanted) and done.sol is not None:
            self._write(wanted[wanted <= end], done.sol, kept)
        c[w.PASSED, 0] = w.NOTHING
        if done.status < 0:
            c[w.STATUS, 0] = w.TOO_LONG
            return
        c[w.TIME, 0] = end if hit else limit
        self.settle(np.array([hit[0] if hit else -1]), np.array([rate]), np.array([not hit]))

    def _wanted(self, begin: float, end: float) -> Floats:
        """Sample times in a stretch."""
        if self.samples is None:
            return np.zeros(0)
        times = self.samples.times[:, self.which[0]]
        return np.asarray(times[(times >= begin) & (times <= end)])

    def _write(self, wanted: Floats, solution: Any, kept: Floats) -> None:
        """Read the states off at sample times."""
        assert self.samples is not None
        times, into = self.samples.times[:, self.which[0]], self.samples.states
        side = kept[w.DIRECTION, 0]
        for t in wanted:
            y = solution(t)
            row = int(np.searchsorted(times, t))
            into[:4, row, self.which[0]] = kept[w.ROTATION, 0] + side * y[0], side * y[1], 0.0, kept[w.SLIP, 0] + y[0]
            into[4:, row, self.which[0]] = y[2:]
