"""Implicit steps of the same program, for lanes that explicit ones are too short for: creep through a viscous layer.

A step of length h finds the polynomial through the states where it begins whose slope is what the program gives at
c_i h, c_i the Radau points up to c_s = 1 (Radau IIA; Hairer and Wanner, Solving Ordinary Differential Equations II,
section IV.5): of the states Y_i there

    Y_i = y + h sum_j a_ij f(Y_j),   a_ij the integral from 0 to c_i of what is 1 at c_j and 0 at the other points,

by Newton's iteration. What decays at once is gone after one step, however long, and the end is right to order 2 s - 1.
The step is as long as the polynomial, by its last Legendre coefficients, is the motion to rounding: then events and
samples are read off it.

The walk, its phases and its events stay.
"""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from generated import layout as ix
from slipcircle.base.checks import EPS
from slipcircle.core.flow.columns import Columns
from slipcircle.core.flow.compiled import engine
from slipcircle.core.flow.program import Log, Program, Samples
from slipcircle.core.flow.tables import Data
from slipcircle.core.flow.walk import Walker

Floats = NDArray[np.float64]
Watched = Callable[[Floats, Floats], Any]  # of states and registers, one number of each or one a time
POINTS = 12
TOLERANCE = 1e-13  # of the last coefficients of a step's polynomial, relative
CREEP = 1e-12  # of its greatest speed, with which a mass without an end is taken to creep for ever
ENDLESS = 1e12  # dimensionless time, thirty thousand years and more, after which a motion has no end
# Of one lane, breaks of what changes with time left out. A step no longer than some explicit ones counts for ten: then
# the motion is not stiff, but trembles or swings for long.
MOST_STEPS, EXPLICIT = 2_000, 8.0


def _radau(count: int) -> tuple[Floats, Floats, Floats]:
    """Points c_i in (0, 1], a_ij, and what gives Legendre coefficients of values at 0 and the points."""
    c = legendre.legroots([0.0] * (count - 1) + [-1.0, 1.0])  # P_s - P_(s-1), 1 among its roots
    c[-1] = 1.0
    integrals = np.array([legendre.legval(c, legendre.legint(unit, lbnd=-1)) for unit in np.eye(count)]).T
    weights = integrals @ np.linalg.inv(legendre.legvander(c, count - 1))
    return (c + 1) / 2, weights / 2, np.linalg.inv(legendre.legvander(np.array([-1.0, *c]), count))


AT, WEIGHTS, TO_LEGENDRE = _radau(POINTS)


def walk(
    program: Program,
    tables: Sequence[Data],
    cells: Floats,
    samples: Samples | None = None,
    log: Log | None = None,
    which: Any = (),
) -> None:
    """As `slipcircle.core.flow.walk.walk`, for some lanes, one after the other, from where they are."""
    for lane in which:
        one = _Implicit(program, [t.lanes([lane]) for t in tables], cells[:, [lane]], samples, np.array([lane]), log)
        one.c[ix.STATUS], one.c[ix.STEPS] = ix.MOVING, 0.0
        with np.errstate(all="ignore"):
            one.rebase()
            while one.c[ix.STATUS, 0] <= ix.RESTING:
                one.round()
        cells[:, lane] = one.c[:, 0]


class _Implicit(Walker):
    """One lane, a step of which goes to the next event or break in as many implicit steps as that takes."""

    left = MOST_STEPS

    def step(self) -> None:
        c, p = self.c, self.program
        limit = float(min(self._break()[0], c[ix.END_TIME, 0]))
        self.given_in_time = [
            (p.tables[k], k, self._local(p.tables[k], self.tables[k])[0, 0], c[p.tables[k].cells + ix.INC, 0])
            for k in self.timed
        ]
        self.cells = [cell for cell, _, _ in p.states]
        self.rates = [rate for _, _, rate in p.states]
        watched, net = self._watched(), p.roles["net"]
        r, last = self._series(int(c[ix.ORDER].max()))
        explicit = float(np.minimum(self._length(r, last, [register for _, register, _ in p.states]), 1e3)[0])
        h = 4.0 * explicit
        first, hit, creeps = float(c[ix.TIME, 0]), ix.EVENT_NONE, False
        time, y = first, c[self.cells, 0]
        now = self._registers(np.array([time]), y[:, None])[:, 0]
        while hit < 0 and time < limit and not creeps:
            h, whole = min(h, limit - time), h >= limit - time
            end = limit if whole else time + h
            self.left -= 0 if whole else 1 if h > EXPLICIT * explicit else 10
            if self.left <= 0 or end == time or (time - first > ENDLESS and np.isinf(limit)):
                break
            found = self._polynomial(time, h, y, now)
            if found is None or not found.error <= TOLERANCE:
                self.left -= whole
                h *= max(0.1, 0.9 * (TOLERANCE / found.error) ** (1 / POINTS)) if found else 0.25
                continue
            for kind, f in watched:
                at = self._first_zero(f, found, time, y, now)
                if at <= end:
                    end, hit = at, kind
            top = self._first_zero(lambda y, r: r[net], found, time, y, now)
            if top <= end:
                at_top = found.states(top)[:, 0]
                rotation = c[ix.ROTATION] + c[ix.DIRECTION] * at_top[0]
                self._fastest(at_top[1:2], np.array([top]), rotation, np.zeros(1))
            self._write(time, end, found)
            time, y = end, found.states(end)[:, 0]
            now = self._registers(np.array([time]), y[:, None])[:, 0]
            creeps = np.isinf(limit) and abs(y[1]) < CREEP * abs(c[ix.PEAK_OMEGA, 0])
            h *= min(4.0, 0.9 * (TOLERANCE / max(found.error, 1e-300)) ** (1 / POINTS))
        c[:] = self._at(np.array([time]), y[:, None])
        if hit < 0 and time < limit:
            c[ix.STATUS, 0] = ix.TOO_LONG
            return
        self.settle(np.array([hit]), now[[net]], np.array([hit < 0]))

    def _watched(self) -> list[tuple[int, Watched]]:
        """Events by their numbers, with what of states and registers is above zero before them."""
        roles, sign = self.program.roles, -1.0 if self.c[ix.LIFTED, 0] > 0.0 else 1.0
        found: list[tuple[int, Watched]] = [(ix.EVENT_STANDSTILL, lambda y, r: y[1])]
        if roles["normal"] >= 0:
            found.append((ix.EVENT_LIFT_OFF, lambda y, r: sign * r[roles["normal"]]))
        if roles["upright"] >= 0:
            found.append((ix.EVENT_CHORD_UPRIGHT, lambda y, r: r[roles["upright"]]))
        for k, slot in enumerate(self.program.tables):
            upper, lower = (float(self.c[slot.cells + x, 0]) for x in (ix.UPPER, ix.LOWER))
            at = {"slip": 0, "rotation": 0, "speed": 1}.get(slot.kind)
            if at is not None and np.isfinite(upper):
                found.append((ix.EVENT_BREAKPOINT + 2 * k, partial(_short_of, at, upper, 1.0)))
            if slot.kind == "speed" and lower:
                found.append((ix.EVENT_BREAKPOINT + 2 * k + 1, partial(_short_of, 1, lower, -1.0)))
        return found

    # --- one step -----------------------------------------------------------------------------------------------------

    def _tables(self, count: int) -> list[Data]:
        return [t.lanes(np.zeros(count, dtype=np.intp)) for t in self.tables]

    def _at(self, times: Floats, states: Floats) -> Floats:
        """Cells of this lane at some times in some states, (states, times)."""
        c = np.repeat(self.c, times.size, axis=1)
        c[ix.TIME], c[self.cells] = times, states
        for slot, k, first, before in self.given_in_time:
            now = Columns(self.program, (), c, None, self.which)._local(slot, self._tables(times.size)[k])
            c[slot.cells + ix.INC] = before + now[0] - first
        return c

    def _registers(self, times: Floats, states: Floats) -> Floats:
        """What the program gives there, (registers, times)."""
        return engine().registers(self.program, self._tables(times.size), self._at(times, states))

    def _polynomial(self, time: float, h: float, y: Floats, now: Floats) -> "_Step | None":
        """A step from a time, states and registers there; none where Newton's iteration does not converge."""
        count, whole = len(y), len(y) * POINTS
        rate = h * now[self.rates]
        found = y + AT[:, None] * rate
        aside = 1e-8 * np.concatenate([np.zeros((1, count)), np.eye(count)])[:, None]
        times, before = np.tile(time + AT * h, 1 + count), np.inf
        for _ in range(12):
            size = np.maximum(np.maximum(np.abs(found), np.abs(y)), np.maximum(np.abs(rate), 1e-300))
            points = found + aside * size
            read = self._registers(times, points.reshape(-1, count).T)
            rates = read[self.rates].T.reshape(1 + count, POINTS, count)
            slopes = (rates[1:] - rates[0]) / np.einsum("kik->ki", points[1:] - found)[..., None]
            off = found - y - h * WEIGHTS @ rates[0]
            system = np.eye(whole) - h * np.einsum("ij,kjl->iljk", WEIGHTS, slopes).reshape(whole, whole)
            scaled = system * (size.ravel() / size.ravel()[:, None])
            try:
                move = np.linalg.solve(scaled, (off / size).ravel())
            except np.linalg.LinAlgError:
                break
            found = found - move.reshape(POINTS, count) * size
            most = np.abs(move).max()
            if most <= 4 * EPS or 1e-12 > most > before / 4:
                values = np.concatenate([y[None], found])
                terms = TO_LEGENDRE @ values
                # Beside rounding, of which that of the time moves every state by as much as its rate.
                known = np.maximum(np.abs(values).max(axis=0), 1e-300)
                known += 8 * EPS / TOLERANCE * time * np.abs(rates[0]).max(axis=0)
                tail = np.abs(terms[-2:]).max(axis=0) / known
                return _Step(time, h, terms, times[:POINTS], found.T, read[:, :POINTS], float(tail.max()))
            if not most < before:
                break
            before = most
        return None

    def _first_zero(self, f: Watched, step: "_Step", time: float, y: Floats, now: Floats) -> float:
        """The time at which a function that is above zero has first passed it; by false position and halves."""

        def at(time: float) -> float:
            states = step.states(time)
            return float(f(states[:, 0], self._registers(np.array([time]), states)[:, 0]))

        values = np.array([f(y, now), *f(step.found, step.registers)])
        passes = np.flatnonzero((values[:-1] > 0.0) & (values[1:] <= 0.0))
        if not passes.size:
            return np.inf
        k = passes[0]
        low, high = (time, *step.times)[k : k + 2]
        at_low, at_high = values[k : k + 2]
        least, turn = 2 * EPS * abs(high), 0
        while high - low > 2 * least:
            share = 0.5 if turn % 3 == 2 else at_low / (at_low - at_high)
            middle = min(max(low + share * (high - low), low + least), high - least)  # or only one end would move
            found, turn = at(middle), turn + 1
            if found > 0.0:
                low, at_low = middle, found
            else:
                high, at_high = middle, found
        return float(high)

    def _write(self, begin: float, end: float, step: "_Step") -> None:
        """Read the states off at sample times from one time up to another."""
        if self.samples is None:
            return
        c, column, side = self.c[:, 0], int(self.which[0]), self.c[ix.DIRECTION, 0]
        times, into = self.samples.times[:, column], self.samples.states
        rows = slice(np.searchsorted(times, begin), np.searchsorted(times, end, side="right"))
        if not times[rows].size:
            return
        y = step.states(times[rows])
        net = self._registers(times[rows], y)[self.program.roles["net"]]
        into[:3, rows, column] = c[ix.ROTATION] + side * y[0], side * y[1], side * net
        into[3, rows, column], into[4:, rows, column] = c[ix.SLIP] + y[0], y[2:]


class _Step(NamedTuple):
    """A step: Legendre coefficients of its states; times, states and registers at its points; its error, relative."""

    begin: float
    length: float
    terms: Floats
    times: Floats
    found: Floats
    registers: Floats
    error: float

    def states(self, times: Any) -> Floats:
        """(states, times)."""
        return np.asarray(legendre.legval(np.atleast_1d(2 * (times - self.begin) / self.length - 1), self.terms))


def _short_of(at: int, bound: float, sign: float, y: Floats, r: Floats) -> Any:
    """How far a state is below a bound, or above it."""
    return sign * (bound - y[at])
