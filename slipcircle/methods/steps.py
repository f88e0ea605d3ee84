"""What the steps of an integration in time say of its states and energies, at any times."""

import math
from collections.abc import Callable
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.balance import Balance
from slipcircle.methods.chebyshev import gauss
from slipcircle.methods.equation import Equation, Stretch
from slipcircle.methods.roots import root

if TYPE_CHECKING:
    from slipcircle.motion import Start

Floats = NDArray[np.float64]

_GAUSS = gauss(10)
_FEW = 16  # times up to which each is reached alone


class Point(NamedTuple):
    """A local time, x, omega and, where it is heated, the excess pressure; d(omega)/dt, and what presses.

    What presses is the effective stress, or what it is below zero while the mass is lifted; infinite where nothing can
    lift it.
    """

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


class Steps:
    """The steps of a phase, each from a point that is known: from there any time within it is one step away."""

    balance: Balance
    start: "Start"
    equation: Equation
    steps: list[Step]
    reached: float  # the end of the last one

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

    @cached_property
    def may_lift(self) -> bool:
        """Whether water, heat or shaking might carry the mass."""
        return bool(self.balance.forcing) or self.equation.heats or self.balance.get("normal", press=0.0) != 0.0

    def point(self, t: float, state: list[float]) -> Point:
        """A point of the motion, by its time and state."""
        equation = self.equation
        rate = equation.slope(t, state[0], state[1], state[2] if equation.heats else self.start.excess)
        if not self.may_lift:
            return Point(t, state, rate, math.inf)
        pressing = equation.pressing()
        return Point(t, state, rate, -pressing if self.start.lifted else pressing)

    def within(self, step: Step, t: float) -> Point:
        """A point of a step."""
        if step.dense is None:
            state = self.equation.reach(step.stretch, step.start.time, step.start.state, t)
        else:
            self.equation.here, state = step.stretch, step.dense(t).tolist()
        return self.point(t, state)

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
                found[:, k] = self.within(self.steps[n], time).state
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

    def _at(self, t: Floats) -> tuple[Floats, dict[str, Any]]:
        """The states at local times, and the terms of the balance there."""
        y = self.states(t)
        return y, self.equation.terms(t, y, *self._windows[:, self._which(t)])

    def when(self, t: Floats) -> tuple[Floats, Floats, Floats]:
        """x, omega and d(omega)/dt at times since the start of the phase."""
        y, terms = self._at(np.asarray(t, dtype=np.float64))
        return y[0], y[1], self.equation.fall(terms) - self.balance.get("resistance", **terms)

    def state(self, t: float) -> tuple[float, float, float]:
        """x, omega and d(omega)/dt at one time."""
        step = self.steps[int(self._which(np.array(t)))]
        point = self.within(step, min(t, step.end.time))
        return max(point.state[0], 0.0), max(point.state[1], 0.0), point.rate

    def fastest(self) -> tuple[float, float, float, float]:
        """Time, x, omega and d(omega)/dt at the greatest speed: at the end of a step, or where the rate turns."""
        best = max((p for s in self.steps for p in (s.start, s.end)), key=lambda p: p.state[1])
        for step in self.steps:
            one, two = step.start, step.end
            if one.rate > 0.0 > two.rate and one.state[1] + one.rate * (two.time - one.time) > best.state[1]:
                at = partial(self.within, step)
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
        _, terms = self._at(nodes)
        forces = np.array([self.equation.fall(terms) + 0.0 * nodes, self.balance.get("resistance", **terms)])
        powers = (forces * terms["omega"]).reshape(2, len(first), -1)
        return np.asarray((last - first) * (powers @ _GAUSS[1]))

    def _summed(self, t: Floats) -> Floats:
        if np.all(t >= self.reached):
            return np.repeat(self._totals[:, -1:], t.size, axis=1)
        which = self._which(t)
        return self._totals[:, which] + self._between(self._starts[which], np.minimum(t, self.reached))
