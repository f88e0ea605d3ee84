"""The equation of a phase that depends on time or speed: over plain floats between two kinks in time, and over arrays.

And single steps of SciPy's DOP853 from known states: compiled to one time, or to many times at once, as one system.
"""

import math
from collections.abc import Callable, Iterator
from operator import itemgetter
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import DOP853, ode

from generated import balance as functions
from generated.effects import ARGUMENTS
from slipcircle.balance import Balance
from slipcircle.checks import EPS
from slipcircle.friction import Friction
from slipcircle.methods.rest import kinks_of
from slipcircle.methods.roots import scalar

if TYPE_CHECKING:
    from slipcircle.motion import Start

Floats = NDArray[np.float64]

_FEW, _MANY = 16, 4096  # stretches that are prepared together, at first and at most


Line: TypeAlias = tuple[str, float, float]  # name, value at the start, slope
Given: TypeAlias = tuple[str, Callable[[Any], Any], float]  # name, function of time in s, factor


class Stretch(NamedTuple):
    """Between two kinks in time: its local ends, the times just inside them, and what is given there."""

    start: float
    end: float
    early: float
    late: float
    lines: tuple[Line, ...]
    curves: tuple[Given, ...]


class Equation:
    """d(x, omega, excess)/dt of one phase, in local time: since the phase began.

    Attributes
    ----------
    here : Stretch
        Where the equation is taken; it bends at both ends.
    heats : bool
        Whether the excess pressure is a part of it.
    failure : BaseException, or None
        What was raised while SciPy's compiled loop, which would lose it, went on with NaN.
    """

    here: Stretch

    def __init__(self, balance: Balance, law: Friction, start: "Start", time: float) -> None:
        self.balance, self.law, self.start, self.time = balance, law, start, time
        self.at = balance.position(start.rotation, start.direction)
        self.heats = balance.has("pressurisation")
        self.speed_unit = balance.radius / balance.time_scale  # m/s for each unit of omega
        self.failure: BaseException | None = None
        self._local: dict[str, float] = {**balance.values, **self.at, "excess": start.excess, "mu": 0.0}
        self._pressing = self._plain("effective_stress")
        self._heating = self._plain("pressurisation") if self.heats else None
        self.slope = self._slope()
        self._one = ode(self.rate).set_integrator("dop853", rtol=1.0, atol=1e300, first_step=1e300)  # takes any step

    # -- over plain floats

    def _plain(self, what: str) -> Callable[[], float]:
        """A function of the balance at the state of which the slope was asked for last."""
        name, local = self.balance.names[what], self._local
        plain, names = scalar(getattr(functions, name)), ARGUMENTS[name]
        if len(names) == 1:
            return lambda: plain(local[names[0]])
        pick = itemgetter(*names)
        return lambda: plain(*pick(local))

    def _slope(self) -> Callable[[float, float, float, float], float]:
        """d(omega)/dt at a local time and state."""
        balance, law, at, start, local = self.balance, self.law, self.at, self.start, self._local
        fall_0, press_0, slope_0, rise_0 = (at[n] for n in ("fall", "press", "fall_slope", "press_slope"))
        turns, tilts = balance.turns, "k_h" in balance.forcing
        slip_0, radius, unit, clock, scale = start.slip, balance.radius, self.speed_unit, self.time, balance.time_scale
        rubs = not start.lifted and not self._by_time
        if rubs and law.constant:
            local["mu"], rubs = float(law.coefficient(0.0)), False
        resistance, coefficient, sin, cos = self._plain("resistance"), law.coefficient, math.sin, math.cos
        fall = self._plain("fall") if balance.has("fall") else None

        def slope(t: float, x: float, omega: float, excess: float) -> float:
            begin, _, early, late, lines, curves = self.here
            if turns:
                sine, cosine = sin(x), cos(x)
                local["fall"] = fall_0 * cosine - slope_0 * sine
                local["press"] = press_0 * cosine - rise_0 * sine
                if tilts:
                    local["fall_slope"] = slope_0 * cosine + fall_0 * sine
                    local["press_slope"] = rise_0 * cosine + press_0 * sine
            for name, value, rise in lines:
                local[name] = value + rise * (t - begin)
            for name, function, factor in curves:
                local[name] = factor * float(function(min(max(clock + t, early), late) * scale))
            local["omega"], local["omega_2"], local["excess"] = omega, omega * omega, excess
            if rubs:
                slip = slip_0 + radius * x if x > 0.0 else slip_0
                local["mu"] = float(coefficient(slip, unit * omega if omega > 0.0 else 0.0))
            return (fall() if fall else local["fall"]) - resistance()

        return slope

    def rate(self, t: float, y: Any) -> list[float]:
        """All of it as SciPy wants it."""
        try:
            if self._heating is None:
                x, omega = y.tolist()
                return [omega, self.slope(t, x, omega, self.start.excess)]
            x, omega, excess = y.tolist()
            return [omega, self.slope(t, x, omega, excess), self._heating() * omega]
        except BaseException as error:
            self.failure = self.failure or error
            return [math.nan] * (2 + self.heats)

    def pressing(self) -> float:
        """The effective stress at the state of which the slope was asked for last."""
        return self._pressing()

    def check(self) -> None:
        """Raise what was raised while SciPy integrated."""
        if self.failure is not None:
            raise self.failure

    def reach(self, stretch: Stretch, t_0: float, state: list[float], t: float) -> list[float]:
        """The state at a time, by one step from a known one."""
        self.here = stretch
        if t - t_0 < 32 * EPS * abs(t):  # no step for SciPy
            change = self.rate(t_0, np.array(state))
            return [y + (t - t_0) * rate for y, rate in zip(state, change, strict=True)]
        found = self._one.set_initial_value(state, t_0).integrate(t).tolist()
        self.check()
        return found

    # -- between kinks in time

    @property
    def _by_time(self) -> bool:
        return "time" in self.law.depends_on and not self.start.lifted

    def stretches(self, longest: float) -> Iterator[Stretch]:
        """What lies between the kinks in time, until the longest time of the phase."""
        straight, curves = self._given()
        every, last, scale = kinks_of(self.balance, self.law), self.time + longest, self.balance.time_scale
        # What it began at is no kink ahead.
        ahead = every[np.searchsorted(every, self.time * (1.0 + 4 * EPS), side="right") : np.searchsorted(every, last)]
        left, first, count = self.time, 0, _FEW
        while True:
            ends = ahead[first : first + count]
            over = first + count >= len(ahead)
            edges = np.concatenate([[left], ends, [last] if over else []])
            early, late = edges[:-1] * (1.0 + 4 * EPS), edges[1:] * (1.0 - 4 * EPS)  # inside in s, too
            endless = over and math.isinf(last)
            late[-1] = 2 * early[-1] + 1.0 if endless else late[-1]  # there nothing changes any more
            lines = [_lines(given, edges, early, late, scale) for given in straight]
            kept = [*zip(*lines, strict=True)] if lines else [()] * len(early)
            local = (edges - self.time).tolist()
            places = [*zip(local, local[1:], early.tolist(), late.tolist(), strict=False)]
            for place, found in zip(places[:-1], kept, strict=False):
                yield Stretch(*place, found, curves)
            if endless:
                still = [_lines(given, edges[-2:], early[-1:], late[-1:], scale)[0] for given in curves]
                yield Stretch(*places[-1], (*kept[-1], *still), ())
            else:
                yield Stretch(*places[-1], kept[-1], curves)
            if over:
                return
            left, first, count = float(edges[-1]), first + count, min(2 * count, _MANY)

    def _given(self) -> tuple[list[Given], tuple[Given, ...]]:
        """What changes with time: what runs straight between its kinks, and the rest."""
        straight, curves = list[Given](), list[Given]()
        for name, (function, factor) in self.balance.forcing.items():
            signed = factor * self.start.direction if name == "k_h" else factor
            (straight if getattr(function, "straight", False) else curves).append((name, function, signed))
        if self._by_time:
            straight.append(("mu", lambda t: self.law.coefficient(0.0, 0.0, t), 1.0))
        return straight, tuple(curves)

    # -- over arrays

    def terms(self, t: Floats, y: Floats, early: Any, late: Any) -> dict[str, Any]:
        """What the balance needs, at local times and states, each between two kinks in time."""
        now, x, omega = np.clip(self.time + t, early, late), y[0], y[1]
        found = self.at | self.balance.given(now, self.start.direction)
        if self.balance.turns:
            sine, cosine = np.sin(x), np.cos(x)
            for name, slope in (("fall", "fall_slope"), ("press", "press_slope")):
                found[name] = self.at[name] * cosine - self.at[slope] * sine
                found[slope] = self.at[slope] * cosine + self.at[name] * sine
        found |= {"omega": omega, "omega_2": omega * omega, "excess": y[2] if self.heats else self.start.excess}
        found["mu"] = 0.0
        if not self.start.lifted:
            slip = self.start.slip + self.balance.radius * np.maximum(x, 0.0)
            speed = self.speed_unit * np.maximum(omega, 0.0)
            found["mu"] = self.law.coefficient(slip, speed, now * self.balance.time_scale)
        return found

    def fall(self, terms: dict[str, Any]) -> Any:
        """What drives the mass."""
        return self.balance.get("fall", **terms) if self.balance.has("fall") else terms["fall"]

    def steps(self, t_0: Floats, states: Floats, t: Floats, early: Floats, late: Floats) -> Floats:
        """States at many times, each by one step from a known one, all at once."""
        width = t - t_0

        def rate(share: float, flat: Floats) -> Any:
            y = flat.reshape(states.shape)
            terms = self.terms(t_0 + share * width, y, early, late)
            found = np.empty_like(y)
            found[0], found[1] = y[1], self.fall(terms) - self.balance.get("resistance", **terms)
            if self.heats:
                found[2] = self.balance.get("pressurisation", **terms) * y[1]
            return (found * width).ravel()

        with np.errstate(all="ignore"):
            one = DOP853(rate, 0.0, states.ravel(), 1.0, rtol=1.0, atol=1e300, first_step=1.0)  # takes any step
            one.step()
        return np.asarray(one.y).reshape(states.shape)


def _lines(given: Given, edges: Floats, early: Floats, late: Floats, scale: float) -> list[Line]:
    """What runs straight between two kinks: values just inside them tell where."""
    name, function, factor = given
    one, two = factor * function(early * scale), factor * function(late * scale)
    slopes = np.where(late > early, (two - one) / (late - early), 0.0)
    values = one - slopes * (early - edges[:-1])
    return [(name, *pair) for pair in zip(values.tolist(), slopes.tolist(), strict=True)]
