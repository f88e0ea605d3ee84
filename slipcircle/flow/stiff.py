"""Lanes that explicit steps are too short for, such as creep through a viscous layer: LSODA on the same program.

The walk, its phases and its events stay; a step goes to the next break or event and is one run of SciPy's stepper.
"""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any
from warnings import catch_warnings, simplefilter

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.checks import EPS
from slipcircle.flow import cells as its
from slipcircle.flow.program import Program
from slipcircle.flow.tables import Data
from slipcircle.flow.walk import Walker

Floats = NDArray[np.float64]
TOLERANCE = 1e-12
CREEP = 1e-12  # of its greatest speed, with which a mass without an end is taken to creep for ever
MOST_STEPS = 3_000  # of the stepper, for one lane


def walk(program: Program, tables: Sequence[Data], cells: Floats, samples: its.Samples | None = None,
         log: its.Log | None = None, which: Any = ()) -> None:  # fmt: skip
    """As `slipcircle.flow.walk.walk`, for some lanes, one after the other, from where they are."""
    for lane in which:
        one = _Implicit(program, [t.lanes([lane]) for t in tables], cells[:, [lane]], samples, np.array([lane]), log)
        one.c[its.STATUS], one.c[its.STEPS] = its.MOVING, 0.0
        with np.errstate(all="ignore"):
            one.rebase()
            while one.c[its.STATUS, 0] <= its.RESTING:
                one.round()
        cells[:, lane] = one.c[:, 0]


class _Implicit(Walker):
    """One lane, a step of which is an implicit integration."""

    left = MOST_STEPS

    def _registers(self, t: float, y: Floats) -> Floats:
        """What the program gives at a time, in states."""
        c = self.c
        c[its.TIME, 0], c[[cell for cell, _, _ in self.program.states], 0] = t, y
        for cell, k, first, before in self.course:
            c[cell, 0] = before + self._local(self.program.tables[k], self.tables[k])[0, 0] - first
        return np.asarray(self._series(0)[0][:, 0, 0])

    def _watched(self) -> list[tuple[int, Callable[[float, Floats], float]]]:
        """Events by their numbers, with what is above zero before them."""
        roles, sign = self.program.roles, -1.0 if self.c[its.LIFTED, 0] > 0.0 else 1.0
        found: list[tuple[int, Callable[[float, Floats], float]]] = [(0, lambda t, y: float(y[1]))]
        if roles["normal"] >= 0:
            found.append((1, lambda t, y: sign * float(self._registers(t, y)[roles["normal"]])))
        if roles["upright"] >= 0:
            found.append((99, lambda t, y: float(self._registers(t, y)[roles["upright"]])))
        for k, slot in enumerate(self.program.tables):
            upper, lower = (float(self.c[slot.cells + x, 0]) for x in (its.UPPER, its.LOWER))
            at = {"slip": 0, "rotation": 0, "speed": 1}.get(slot.kind)
            if at is not None and np.isfinite(upper):
                found.append((2 + 2 * k, partial(_short_of, at, upper, 1.0)))
            if slot.kind == "speed" and lower:
                found.append((3 + 2 * k, partial(_short_of, 1, lower, -1.0)))
        return found

    def step(self) -> None:
        try:
            from scipy.integrate import LSODA  # only here
        except ImportError as error:
            raise ImportError("this scene is integrated by SciPy: pip install 'slipcircle[scenes]'") from error

        c, p = self.c, self.program
        begin, limit = float(c[its.TIME, 0]), float(min(self._break()[0], c[its.END_TIME, 0]))
        timed = [(k, p.tables[k]) for k in self.timed]
        self.course = [(slot.cells + its.INC, k, self._local(slot, self.tables[k])[0, 0], c[slot.cells + its.INC, 0])
                       for k, slot in timed]  # fmt: skip
        y0, states, net = c[[cell for cell, _, _ in p.states], 0].copy(), p.states, p.roles["net"]
        fastest = max(abs(c[its.PEAK_OMEGA, 0]), 1e-9)
        size = np.maximum(np.abs(y0), 1e-12 * np.array([1.0, fastest, *y0[2:] * 0.0 + 1.0]))

        def rates(t: float, y: Floats) -> list[float]:
            r = self._registers(t, y)
            return [float(r[rate]) for _, _, rate in states]

        watched = self._watched()
        stepper = LSODA(rates, begin, y0, limit, rtol=TOLERANCE, atol=TOLERANCE * size)
        before = [f(begin, y0) for _, f in watched]
        hit, end, y, rate = -1, begin, y0, float(self._registers(begin, y0)[net])
        while stepper.status == "running" and self.left:
            self.left -= 1
            with catch_warnings():  # that it failed is said by its status
                simplefilter("ignore")
                stepper.step()
            if stepper.status == "failed":
                break
            dense, t0 = stepper.dense_output(), end
            after = [f(stepper.t, stepper.y) for _, f in watched]
            end, hit = stepper.t, -1
            for (kind, f), a, b in zip(watched, before, after, strict=True):
                if a > 0.0 >= b and (t := _root(f, dense, t0, end)) <= end:
                    end, hit = t, kind
            y = dense(end)
            falls = float(self._registers(end, y)[net])
            if rate > 0.0 >= falls:
                top = _root(lambda t, y: float(self._registers(t, y)[net]), dense, t0, end)
                at = dense(top)
                rotation = c[its.ROTATION] + c[its.DIRECTION] * at[0]
                self._fastest(np.array([at[1]]), np.array([top]), rotation, np.zeros(1))
            self._write(t0, end, dense)
            rate, before = falls, after
            creeps = np.isinf(limit) and abs(y[1]) < CREEP * abs(c[its.PEAK_OMEGA, 0])
            if hit >= 0 or creeps:
                break
        if hit < 0 and (stepper.status != "finished" or np.isinf(limit)):
            c[its.STATUS, 0] = its.TOO_LONG
            return
        self._registers(end if hit >= 0 else limit, y)
        self.settle(np.array([hit]), np.array([rate]), np.array([hit < 0]))

    def _write(self, begin: float, end: float, states: Any) -> None:
        """Read the states off at sample times from one time up to another."""
        if self.samples is None:
            return
        c, column = self.c[:, 0], int(self.which[0])
        times, into = self.samples.times[:, column], self.samples.states
        first, last = np.searchsorted(times, begin), np.searchsorted(times, end, side="right")
        for row in range(first, last):
            y = states(times[row])
            side = c[its.DIRECTION]
            rate = self._registers(times[row], y)[self.program.roles["net"]]
            into[:4, row, column] = c[its.ROTATION] + side * y[0], side * y[1], side * rate, c[its.SLIP] + y[0]
            into[4:, row, column] = y[2:]


def _short_of(at: int, bound: float, sign: float, t: float, y: Floats) -> float:
    """How far a state is below a bound, or above it."""
    return sign * (bound - float(y[at]))


def _root(f: Callable[[float, Floats], float], states: Callable[[float], Floats], low: float, high: float) -> float:
    """Where a function of states that is above zero at first passes it."""
    from scipy.optimize import brentq  # only here

    def at(time: float) -> float:
        return f(time, states(time))

    if at(low) <= 0.0 or at(high) > 0.0:  # as rounding has it
        return low if at(low) <= 0.0 else high
    return float(brentq(at, low, high, xtol=1e-300, rtol=4 * EPS))
