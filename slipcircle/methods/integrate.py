"""One phase of a motion that depends on time or speed, integrated in time by SciPy, with its events located.

The equation is smooth between kinks: of the records, of the friction law in slip and speed, lift-off and standstill.
Steps never cross a kink in time. What else ends a phase or bends its equation is looked for in every step that the
ends of the step do not clear of it.
"""

import math
import warnings
from bisect import bisect_right
from collections.abc import Callable
from functools import cached_property, partial
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import LSODA, ode

from slipcircle.balance import Balance
from slipcircle.friction import Friction
from slipcircle.methods.equation import EPS, Equation, Stretch
from slipcircle.methods.roots import highest, root

if TYPE_CHECKING:
    from slipcircle.motion import Start

Floats = NDArray[np.float64]

_STIFF_STEPS = 300  # explicit steps between two kinks, ten times what is usual, after which LSODA takes over
_MOST_STEPS = 100_000  # of one phase, between two kinks
_FURTHEST = 1e4  # rotation of a frozen slide after which it will never rest, rad
_GAUSS = (np.polynomial.legendre.leggauss(10)[0] + 1) / 2, np.polynomial.legendre.leggauss(10)[1] / 2
_SHARES = (0.25, 0.5, 0.75)  # of a step, where its events are looked for
_FEW = 16  # times up to which each is reached alone
_ENDS = ("stands", "presses", "over")  # of a phase


class Point(NamedTuple):
    """A local time, x, omega and, where it is heated, the excess pressure; d(omega)/dt, and the effective stress."""

    time: float
    state: list[float]
    rate: float
    pressing: float


class Step(NamedTuple):
    """One step, on a stretch between two kinks in time; and its interpolant where it is implicit."""

    start: Point
    end: Point
    stretch: Stretch
    dense: Callable[[Any], Any] | None = None


class Integrated:
    """A phase in one direction; the same faces as `slipcircle.methods.phaseplane.Course`.

    Attributes
    ----------
    duration : float
        Time from its start to its end, infinite where the longest time is over before.
    end : float
        Rotation there.
    stops : bool
        Whether it stands still there.
    change : tuple of float, or None
        Time, rotation and E at which the mass lifts off or lands.
    excess : float
        Excess pore pressure over sigma_ref at its end.
    """

    def __init__(
        self, balance: Balance, law: Friction, start: "Start", longest: float, time: float, tolerance: float
    ) -> None:
        self.balance, self.start, self.longest, self.time = balance, start, longest, time
        self.equation = Equation(balance, law, start, time)
        self.furthest = self.equation.at["dip"] + np.pi / 2 if balance.turns else _FURTHEST
        self.stops = False
        self.change: tuple[float, float, float] | None = None
        self.steps: list[Step] = []
        self._tolerance, self._top, self._count = tolerance, math.sqrt(start.energy), 0
        self._slips = [(k - start.slip) / balance.radius for k in law.kinks if k > start.slip]
        self._speeds = [v / self.equation.speed_unit for v in law.speeds]
        self._band = 0  # which piece of a table of speeds holds
        self._sign = -1.0 if start.lifted else 1.0  # what presses passes zero upwards, or downwards
        self._doubtful: Step | None = None  # a step in which something may happen
        with np.errstate(all="ignore"), warnings.catch_warnings():
            warnings.simplefilter("ignore")  # a failure shows in what comes back
            self._integrate()

    # -- following it

    def _integrate(self) -> None:
        equation, ending, guess = self.equation, "", 0.0
        state = [0.0, math.sqrt(self.start.energy), self.start.excess][: 2 + equation.heats]
        for stretch in equation.stretches(self.longest):
            equation.here, self._count = stretch, 0
            self._last = self._point(stretch.start, state)
            self._band = self._band_at(self._last)
            while self._last.time < stretch.end and not ending:
                guess = self._explicit(guess) if self._count <= _STIFF_STEPS else self._implicit()
                self._check()
                if self._doubtful is not None:
                    happened = self._settled(self._doubtful)
                    self._doubtful = None
                    ending, guess = happened if happened in _ENDS else "", 0.0 if happened else guess
            state = self._last.state
            if ending:
                break
        self.reached, self.end, self.speed = self._last.time, *state[:2]
        self.excess, self.stops = state[2] if equation.heats else self.start.excess, ending == "stands"
        over = self.stops or ending == "presses" or (ending == "over" and self.balance.turns)
        self.duration = self.reached if over else math.inf
        if ending == "presses":
            self.change = self.reached, self.end, self.speed**2

    def _explicit(self, guess: float) -> float:
        """Steps by SciPy's compiled DOP853 until something may happen, to the next kink at most; a good next step."""
        equation, before = self.equation, self._last
        end, done = equation.here.end, self._count
        self._atol = self._floor(before.time)
        if end - before.time < 32 * EPS * end:  # no step for SciPy
            self._accepted(end, equation.reach(equation.here, before.time, before.state, end))
            return guess
        longest = 0.0

        def accepted(t: float, y: Any) -> int:
            nonlocal longest
            try:
                longest = max(longest, t - self._last.time)
                return -1 if self._accepted(t, y.tolist()) else 0
            except BaseException as error:
                equation.failure = error
                return -1

        first = min(guess, end - before.time)
        solver = ode(equation.rate).set_integrator(
            "dop853", rtol=self._tolerance, atol=self._atol, nsteps=_MOST_STEPS, first_step=first, beta=0.02
        )
        solver.set_solout(accepted)
        solver.set_initial_value(before.state, before.time).integrate(end)
        equation.check()
        if solver.get_return_code() == -2:
            self._count = _MOST_STEPS + 1
        elif not solver.successful():
            raise OverflowError
        return max(guess, 2 * longest) if self._count == done + 1 else longest

    def _implicit(self) -> float:
        """Steps by LSODA until something may happen, to the next kink at most."""
        equation, last = self.equation, self._last
        atol = self._floor(last.time)
        solver = LSODA(equation.rate, last.time, last.state, equation.here.end, rtol=self._tolerance, atol=atol)
        while solver.status == "running":
            solver.step()
            equation.check()
            if solver.status == "failed":
                raise OverflowError
            if self._accepted(float(solver.t), solver.y.tolist(), solver.dense_output()):
                break
        return 0.0

    def _accepted(self, t: float, state: list[float], dense: Callable[[Any], Any] | None = None) -> bool:
        """Take note of a step that was made; whether what follows must be thought over."""
        before = self._last
        if t <= before.time:
            return False
        if not math.isfinite(state[0] + state[1]):
            raise OverflowError
        self._last = now = self._point(t, state)
        self._count += 1
        step = Step(before, now, self.equation.here, dense)
        if self._doubts(before, now):
            self._doubtful = step
            return True
        self._keep(step)
        if self._count > _STIFF_STEPS and (dense is None or self._count > _MOST_STEPS):
            return True
        if self._creeps():
            return True
        floor = self._floor(t)
        return dense is None and floor > 4 * self._atol and floor > 0.25 * self._tolerance * state[1]

    def _keep(self, step: Step) -> None:
        self.steps.append(step)
        self._top = max(self._top, step.end.state[1])

    def _check(self) -> None:
        """Refuse what takes for ever."""
        if self._count > _MOST_STEPS:
            raise ValueError(
                f"end_time: more than {_MOST_STEPS} steps after {self.time * self.balance.time_scale:.6g} s; "
                "give an earlier end in s, or a smoother law"
            )
        if self._creeps():
            raise ValueError(
                "end_time: this mass creeps to its rest, ever more slowly as what resists falls with "
                "the speed, and never quite reaches it; give end_time in s"
            )

    def _creeps(self) -> bool:
        """Whether it is all but at rest, for ever, and slows down in proportion to its speed."""
        omega = self._last.state[1]
        slow = omega < 1e-9 * self._top and 0.0 < -1e-3 * self._last.rate < omega
        return slow and math.isinf(self.equation.here.end)

    def _floor(self, t: float) -> float:
        """Absolute tolerance: what a rounded drive adds since the start, and of the greatest speed a share."""
        since = min(max(t, 1e-4), 1.0, 1.0 / max(float(self.balance.get("damping")), 1.0))
        return max(0.1 * self._tolerance * self._top, 16 * EPS * self._terms * since)

    @cached_property
    def _terms(self) -> float:
        """The size of the terms of which the drive is a difference."""
        at, given = self.equation.at, self.balance.given(self.time + 1e-9, self.start.direction)
        tilted = abs(given.get("k_h", 0.0)) * abs(at["fall_slope"])
        return abs(at["fall"]) + abs(at["press"]) + float(tilted)

    def _point(self, t: float, state: list[float]) -> Point:
        excess = state[2] if self.equation.heats else self.start.excess
        rate = self.equation.slope(t, state[0], state[1], excess)
        return Point(t, state, rate, self._sign * self.equation.pressing() if self._may_lift else math.inf)

    @cached_property
    def _may_lift(self) -> bool:
        forced = {"k_h", "k_v", "pore_pressure"} & set(self.balance.forcing)
        return bool(forced) or self.equation.heats or self.balance.get("normal", press=0.0) != 0.0

    # -- what happens within a step

    def _doubts(self, one: Point, two: Point) -> bool:
        """Whether something may happen in a step: beyond a bound at its end, or perhaps in between."""
        width, low, high = two.time - one.time, two.state[1], two.state[1]
        if one.rate * two.rate < 0.0:  # the speed has an extreme, and that not beyond where its tangents meet
            rise = two.state[1] - one.state[1]
            meet = one.state[1] + one.rate * (rise - two.rate * width) / (one.rate - two.rate)
            low, high = min(low, meet), max(high, meet)
        if low < self._slowest or high > self._fastest or two.state[0] > self._limit:
            return True
        if not self._may_lift:
            return False
        pressing = [one.pressing, two.pressing]
        if self.equation.here.curves:
            pressing.append(self._point(*_halfway(one, two)).pressing)
        return min(pressing) < 0.5 * (max(pressing) - min(pressing))

    @property
    def _slowest(self) -> float:
        return self._speeds[self._band - 1] if self._band else 0.0

    @property
    def _fastest(self) -> float:
        return self._speeds[self._band] if self._band < len(self._speeds) else math.inf

    @property
    def _limit(self) -> float:
        return min(self.furthest, self._slips[0]) if self._slips else self.furthest

    def _band_at(self, point: Point) -> int:
        """Which piece of a table of speeds holds from here on."""
        omega = point.state[1]
        if omega in self._speeds:
            return self._speeds.index(omega) + (point.rate > 0.0)
        return bisect_right(self._speeds, omega)

    def _settled(self, step: Step) -> str:
        """Follow a step until something happens in it, if anything does: its name."""
        found = self._first(step)
        if found is None:
            self._keep(step)
            return ""
        name, point = found
        self._keep(step._replace(end=point))
        state = [*point.state]
        if name == "slip":
            state[0] = self._slips.pop(0)
        elif name in ("stands", "slower"):
            state[1] = self._slowest
        elif name == "faster":
            state[1] = self._fastest
        self._last = self._point(point.time, state)
        self._band = self._band_at(self._last)
        return name

    def _first(self, step: Step) -> tuple[str, Point] | None:
        """What happens first in a step, and where; below zero only by more than rounding, where it begins there."""
        watched: dict[str, Callable[[Point], float]] = {
            "slower" if self._band else "stands": lambda p: p.state[1] - self._slowest,
            "faster": lambda p: self._fastest - p.state[1],
            "presses": lambda p: p.pressing,
            "slip" if self._limit < self.furthest else "over": lambda p: self._limit - p.state[0],
        }
        points, noise, at = self._points(step), self._noise(), partial(self._within, step)
        found: tuple[str, Point] | None = None
        for name, watch in watched.items():
            least = 0.0 if watch(points[0]) > 0.0 else -noise.get(name, 0.0)
            k = next((k for k, p in enumerate(points) if watch(p) < least), None)
            if k is None:
                continue
            before, after = points[max(k - 1, 0)], points[k]
            if watch(before) > 0.0:
                ends = before.time, after.time, watch(before), watch(after)
                before = at(root(lambda t, watch=watch: watch(at(t)), *ends))  # type: ignore[misc]
            if found is None or before.time < found[1].time:
                found = name, before
        return found

    def _points(self, step: Step) -> list[Point]:
        """Where a step is looked at: its ends, some places inside, and the extremes of the speed and of what presses."""
        one, two, at = step.start, step.end, partial(self._within, step)
        points = [one, *(at(one.time + share * (two.time - one.time)) for share in _SHARES), two]
        found = [
            at(root(lambda t: at(t).rate, a.time, b.time, a.rate, b.rate))
            for a, b in pairwise(points)
            if a.rate * b.rate < 0.0
        ]
        for a, b, c in zip(points, points[1:], points[2:], strict=False):
            if 0.0 < b.pressing < a.pressing and b.pressing <= c.pressing < math.inf:
                found.append(at(highest(lambda t: -at(t).pressing, a.time, c.time)))
        return sorted(points + found)

    def _within(self, step: Step, t: float) -> Point:
        """A point of a step."""
        if step.dense is None:
            state = self.equation.reach(step.stretch, step.start.time, step.start.state, t)
        else:
            self.equation.here, state = step.stretch, step.dense(t).tolist()
        return self._point(t, state)

    def _noise(self) -> dict[str, float]:
        """How far below zero rounding alone may put what is watched where it begins at zero."""
        values, top = self.balance.values, self._top
        pressing = 64 * EPS * (self._terms + values["polar"] * top * top) / values["level"]
        return {"stands": 16 * EPS * min(self._terms, 1.0) * max(top, 1e-6), "presses": pressing}

    # -- what it is at given times

    @cached_property
    def _starts(self) -> Floats:
        return np.array([s.start.time for s in self.steps])

    @cached_property
    def _ends(self) -> Floats:
        return np.array([s.end.time for s in self.steps])

    @cached_property
    def _windows(self) -> Floats:
        return np.array([(s.stretch.early, s.stretch.late) for s in self.steps]).T

    @cached_property
    def _states(self) -> Floats:
        return np.array([s.start.state for s in self.steps]).T

    def _which(self, t: Floats) -> NDArray[np.intp]:
        """The steps in which times lie."""
        return np.clip(np.searchsorted(self._starts, t, side="right") - 1, 0, len(self.steps) - 1)

    def states(self, t: Floats) -> Floats:
        """x, omega and, where it is heated, the excess pressure, at local times."""
        which = self._which(t)
        t = np.minimum(t, self._ends[which])
        found = np.empty((2 + self.equation.heats, t.size))
        if t.size <= _FEW:
            for k, (n, time) in enumerate(zip(which.tolist(), t.tolist(), strict=True)):
                found[:, k] = self._within(self.steps[n], time).state
        else:
            found = self.equation.steps(self._starts[which], self._states[:, which], t, *self._windows[:, which])
            for n in np.unique(which).tolist():
                dense = self.steps[n].dense
                if dense is not None:
                    found[:, which == n] = dense(t[which == n])
        found[:2] = np.maximum(found[:2], 0.0)
        return found

    @property
    def lifts(self) -> tuple[float, ...]:
        """Times within the phase at which the mass lifts off; where it does, the phase ends."""
        return ()

    def excess_when(self, t: Floats) -> Floats:
        """Excess pore pressure over sigma_ref at times since the start of the phase."""
        return self.states(t)[2] if self.equation.heats else np.full_like(t, self.start.excess)

    def _at(self, t: Floats) -> dict[str, Any]:
        """The terms of the balance at local times."""
        return self.equation.terms(t, self.states(t), *self._windows[:, self._which(t)])

    def when(self, t: Floats) -> tuple[Floats, Floats, Floats]:
        """x, omega and d(omega)/dt at times since the start of the phase."""
        t = np.asarray(t, dtype=np.float64)
        y = self.states(t)
        terms = self.equation.terms(t, y, *self._windows[:, self._which(t)])
        return y[0], y[1], self.equation.fall(terms) - self.balance.get("resistance", **terms)

    def state(self, t: float) -> tuple[float, float, float]:
        """x, omega and d(omega)/dt at one time."""
        step = self.steps[int(self._which(np.array(t)))]
        point = self._within(step, min(t, step.end.time))
        return max(point.state[0], 0.0), max(point.state[1], 0.0), point.rate

    def fastest(self) -> tuple[float, float, float, float]:
        """Time, x, omega and d(omega)/dt at the greatest speed: at the end of a step, or where the rate turns."""
        best = max((p for s in self.steps for p in (s.start, s.end)), key=lambda p: p.state[1])
        for step in self.steps:
            one, two = step.start, step.end
            if one.rate > 0.0 > two.rate and one.state[1] + one.rate * (two.time - one.time) > best.state[1]:
                at = partial(self._within, step)
                top = at(root(lambda t, at=at: at(t).rate, one.time, two.time, one.rate, two.rate))  # type: ignore[misc]
                best = max(best, top, key=lambda p: p.state[1])
        return best.time, best.state[0], best.state[1], best.rate

    # -- energy

    def worked(self, t: Floats) -> Floats:
        """Work of gravity and shaking over Theta*, by quadrature, from the start of the phase."""
        return self._summed(t)[0]

    def dissipated(self, t: Floats) -> Floats:
        """Energy over Theta* that the resistance has taken since the start, by quadrature of its own."""
        return self._summed(t)[1]

    @cached_property
    def _totals(self) -> Floats:
        """What drives and what resists have added up to, until each step begins and until the end."""
        sums = self._between(self._starts, self._ends)
        return np.concatenate([np.zeros((2, 1)), np.cumsum(sums, axis=1)], axis=1)

    def _between(self, first: Floats, last: Floats) -> Floats:
        """What drives and what resists add up to between two times of one step each."""
        nodes = (first[:, None] + (last - first)[:, None] * _GAUSS[0]).ravel()
        terms = self._at(nodes)
        forces = np.array([self.equation.fall(terms) + 0.0 * nodes, self.balance.get("resistance", **terms)])
        powers = (forces * terms["omega"]).reshape(2, len(first), -1)
        return np.asarray((last - first) * (powers @ _GAUSS[1]))

    def _summed(self, t: Floats) -> Floats:
        which = self._which(t)
        return self._totals[:, which] + self._between(self._starts[which], np.minimum(t, self.reached))


def _halfway(one: Point, two: Point) -> tuple[float, list[float]]:
    """About the middle of a step: by cubics through both ends."""
    width = two.time - one.time
    x, omega, *excess = ((a + b) / 2 for a, b in zip(one.state, two.state, strict=True))
    x += width / 8 * (one.state[1] - two.state[1])
    return one.time + width / 2, [x, omega + width / 8 * (one.rate - two.rate), *excess]
