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
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.integrate import LSODA, ode

from slipcircle.balance import Balance
from slipcircle.checks import EPS
from slipcircle.friction import Friction
from slipcircle.methods.equation import Equation
from slipcircle.methods.roots import highest, root
from slipcircle.methods.steps import Point, Step, Steps

if TYPE_CHECKING:
    from slipcircle.motion import Start

_STIFF_STEPS = 300  # explicit steps between two kinks, ten times what is usual, after which LSODA takes over
_WHOLE = 0.01  # of the tolerance, for a step from one kink in time to the next
_FURTHEST = 1e4  # rotation of a frozen slide after which it will never rest, rad
_SHARES = (1e-3, 0.25, 0.5, 0.75, 1.0 - 1e-3)  # of a step, where its events are looked for
_ENDS = ("stands", "presses", "over")  # of a phase


class Integrated(Steps):
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
        self, balance: Balance, law: Friction, start: "Start", longest: float, time: float, tolerance: float, most: int
    ) -> None:
        self.balance, self.start, self.longest, self.time = balance, start, longest, time
        self.equation = equation = Equation(balance, law, start, time)
        self.at, self.steps = equation.at, []
        self.change: tuple[float, float, float] | None = None
        self._slips = [(k - start.slip) / balance.radius for k in law.kinks if k > start.slip]
        self._speeds = [v / equation.speed_unit for v in law.speeds]
        self._furthest = equation.at["dip"] + np.pi / 2 if balance.turns else _FURTHEST
        self._tolerance, self._most, self._top = tolerance, most, math.sqrt(start.energy)
        self._memory = min(1.0, 1.0 / max(float(balance.get("damping")), 1.0))
        self._doubtful: Step | None = None  # a step in which something may happen
        self._made: tuple[float, float, Any] | None = None  # a solver, its first step and its absolute tolerance
        self._atol = 0.0
        with np.errstate(all="ignore"), warnings.catch_warnings():
            warnings.simplefilter("ignore")  # a failure shows in what comes back
            self._integrate()

    # -- following it

    def _integrate(self) -> None:
        equation, ending, guess = self.equation, "", 0.0
        state = [0.0, math.sqrt(self.start.energy), self.start.excess][: 2 + equation.heats]
        for stretch in equation.stretches(self.longest):
            equation.here, self._count = stretch, 0
            self._last = self.point(stretch.start, state)
            self._bound()
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
        self.reached, self.end, self.stops = self._last.time, state[0], ending == "stands"
        self.excess = state[2] if equation.heats else self.start.excess
        over = self.stops or ending == "presses" or (ending == "over" and self.balance.turns)
        self.duration = self.reached if over else math.inf
        if ending == "presses":
            self.change = self.reached, self.end, state[1] ** 2

    def _explicit(self, guess: float) -> float:
        """Steps by SciPy's compiled DOP853 until something may happen, to the next kink at most; a good next step."""
        equation, before, done = self.equation, self._last, self._count
        left = equation.here.end - before.time
        if left < 32 * EPS * equation.here.end:  # no step for SciPy
            self._accepted(
                equation.here.end, equation.reach(equation.here, before.time, before.state, equation.here.end)
            )
            return guess
        self._longest = 0.0
        solver = self._solver(guess if 2 * guess < left else math.inf)
        solver.set_initial_value(before.state, before.time).integrate(equation.here.end)
        equation.check()
        if solver.get_return_code() == -2:
            self._count = self._most + 1
        elif not solver.successful():
            raise OverflowError
        return max(guess, self._longest) if self._count == done + 1 else self._longest  # a kink may have cut it short

    def _solver(self, first: float) -> Any:
        """SciPy's compiled loop, which tries the first step first; its own choice where that is 0.

        A step from kink to kink is one that an integration to another tolerance makes too, and a comparison of both
        would not see its error: so that has to be small.
        """
        share = 1.0 if first < math.inf else _WHOLE
        floor = self._floor(self._last.time, share)
        if self._made is None or self._made[0] != first or floor > 4 * self._made[1]:
            solver = ode(self.equation.rate).set_integrator(
                "dop853",
                rtol=max(share * self._tolerance, 1e-14),
                atol=floor,
                nsteps=self._most,
                first_step=min(first, 1e300),
                beta=0.02,
            )
            solver.set_solout(self._stepped)
            self._made = first, floor, solver
        self._atol = self._made[1] / share
        return self._made[2]

    def _stepped(self, t: float, y: Any) -> int:
        """What SciPy's compiled loop calls after each step, and stops for -1; it would lose what is raised."""
        try:
            self._longest = max(self._longest, t - self._last.time)
            return -1 if self._accepted(t, y.tolist()) else 0
        except BaseException as error:
            self.equation.failure = error
            return -1

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
        self._last = now = self.point(t, state)
        self._count += 1
        step = Step(before, now, self.equation.here, dense)
        if self._doubts(before, now):
            self._doubtful = step
            return True
        self._keep(step)
        if self._creeps() or self._count > (_STIFF_STEPS if dense is None else self._most):
            return True
        floor = self._floor(t)
        return dense is None and floor > 4 * self._atol and floor > 0.25 * self._tolerance * state[1]

    def _keep(self, step: Step) -> None:
        self.steps.append(step)
        self._top = max(self._top, step.end.state[1])

    def _check(self) -> None:
        """Refuse what takes for ever."""
        if self._count > self._most:
            raise ValueError(
                f"end_time: more than {self._most} steps after {self.time * self.balance.time_scale:.6g} s; "
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
        return omega < 1e-9 * self._top and 0.0 < -1e-3 * self._last.rate < omega and self.equation.here.end == math.inf

    def _floor(self, t: float, share: float = 1.0) -> float:
        """Absolute tolerance: what a rounded drive adds since the start, and of the greatest speed a share."""
        return max(0.1 * share * self._tolerance * self._top, 4 * EPS * self._terms * min(max(t, 1e-4), self._memory))

    @cached_property
    def _terms(self) -> float:
        """The size of the terms of which the drive is a difference."""
        at, given = self.equation.at, self.balance.given(self.time + 1e-9, self.start.direction)
        tilted = abs(given.get("k_h", 0.0)) * abs(at["fall_slope"])
        return abs(at["fall"]) + abs(at["press"]) + float(tilted)

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
        return self._hollow(one, two)

    def _hollow(self, one: Point, two: Point) -> bool:
        """Whether what presses may pass zero within a step: where it changes by more than twice what is left."""
        if not self.may_lift:
            return False
        pressing = [one.pressing, two.pressing]
        if self.equation.here.curves:
            pressing.append(self.point(*_halfway(one, two)).pressing)
        return min(pressing) < 0.5 * (max(pressing) - min(pressing))

    def _bound(self) -> None:
        """Between which speeds and up to which rotation the equation holds from here on."""
        omega, speeds = self._last.state[1], self._speeds
        band = speeds.index(omega) + (self._last.rate > 0.0) if omega in speeds else bisect_right(speeds, omega)
        self._slowest, self._fastest = speeds[band - 1] if band else 0.0, [*speeds, math.inf][band]
        self._limit = min([self._furthest, *self._slips[:1]])

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
        self._last = self.point(point.time, state)
        self._bound()
        return name

    def _first(self, step: Step) -> tuple[str, Point] | None:
        """What happens first in a step, and where; below zero only by more than rounding, where it begins there."""
        watched: dict[str, Callable[[Point], float]] = {
            "slower" if self._slowest else "stands": lambda p: p.state[1] - self._slowest,
            "faster": lambda p: self._fastest - p.state[1],
            "presses": lambda p: p.pressing,
            "slip" if self._limit < self._furthest else "over": lambda p: self._limit - p.state[0],
        }
        points, noise, at = self._points(step), self._noise(step), partial(self.within, step)
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
        """Where a step is looked at: its ends, places inside, and the extremes of the speed and of what presses."""
        one, two, at = step.start, step.end, partial(self.within, step)
        if one.rate * two.rate >= 0.0 and not self._hollow(one, two):
            return [one, two]
        points = [one, *(at(one.time + share * (two.time - one.time)) for share in _SHARES), two]
        found = [
            at(root(lambda t: at(t).rate, a.time, b.time, a.rate, b.rate))
            for a, b in pairwise(points)
            if a.rate * b.rate < 0.0
        ]
        for a, b, c in zip(points, points[1:], points[2:], strict=False):
            if (
                b.pressing < a.pressing
                and b.pressing <= c.pressing
                and 0.0 < b.pressing < max(a.pressing, c.pressing) / 2
            ):
                found.append(at(highest(lambda t: -at(t).pressing, a.time, c.time)))
        return sorted(points + found)

    def _noise(self, step: Step) -> dict[str, float]:
        """How far below zero rounding alone may put what is watched where it begins at zero.

        What is given is known to the rounding of the time since the scene began, in which what presses may change fast.
        """
        values, top, one = self.balance.values, self._top, step.start
        pressing = 64 * EPS * (self._terms + values["polar"] * top * top) / values["level"]
        later = one.time + 1e-3 * min(step.stretch.end - one.time, 1.0)
        if self.time > 0.0 and later > one.time:
            pace = abs(self.point(later, [*one.state]).pressing - one.pressing) / (later - one.time)
            pressing += 16 * EPS * (self.time + one.time) * pace
        return {"stands": 16 * EPS * min(self._terms, 1.0) * max(top, 1e-6), "presses": pressing}


def _halfway(one: Point, two: Point) -> tuple[float, list[float]]:
    """About the middle of a step: by cubics through both ends."""
    width = two.time - one.time
    x, omega, *excess = ((a + b) / 2 for a, b in zip(one.state, two.state, strict=True))
    x += width / 8 * (one.state[1] - two.state[1])
    return one.time + width / 2, [x, omega + width / 8 * (one.rate - two.rate), *excess]
