"""One phase of a motion that depends on time or speed, integrated in time by SciPy, with its events located.

The equation is smooth between kinks: of the records, of the friction law in slip and speed, lift-off and standstill.
Steps never cross a kink in time, and what else ends a phase or bends its equation is found on a step's interpolant.
"""

import math
from bisect import bisect_right
from collections.abc import Callable
from functools import cached_property, partial
from itertools import chain
from operator import itemgetter
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import DOP853, LSODA

from generated import balance as functions
from generated.effects import ARGUMENTS
from slipcircle.balance import Balance
from slipcircle.friction import Friction
from slipcircle.methods.rest import kinks_of
from slipcircle.methods.roots import root, scalar

if TYPE_CHECKING:
    from slipcircle.motion import Start

Floats = NDArray[np.float64]

EPS = 2.0**-52
_STIFF_STEPS = 300  # explicit steps between two kinks, ten times what is usual, after which LSODA takes over
_MOST_STEPS = 100_000  # of one phase, between two kinks
_FURTHEST = 1e4  # rotation of a frozen slide after which it will never rest, rad
_GAUSS = (np.polynomial.legendre.leggauss(10)[0] + 1) / 2, np.polynomial.legendre.leggauss(10)[1] / 2
_INSIDE = np.array([0.0, 0.25, 0.5, 0.75, 1.0])  # of a step, where its events are looked for
Watch = Callable[[Any, Any], Any]


class Piece(NamedTuple):
    """One step: its ends in local time, and its interpolant."""

    start: float
    end: float
    dense: Callable[[Any], Any]


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
        self.balance, self.law, self.start, self.longest, self.time = balance, law, start, longest, time
        self.at = balance.position(start.rotation, start.direction)
        self.furthest = self.at["dip"] + np.pi / 2 if balance.turns else _FURTHEST
        self.heats = balance.has("pressurisation")
        self.speed_unit = balance.radius / balance.time_scale  # m/s for each unit of omega
        self.stops = False
        self.change: tuple[float, float, float] | None = None
        self.pieces: list[Piece] = []
        self._window = (-math.inf, math.inf)  # between two kinks, while it is integrated
        with np.errstate(all="ignore"):
            self._integrate(tolerance)
        self._window = (-math.inf, math.inf)

    # -- the equation

    def _equation(self, left: float, right: float) -> Callable[[float, Any], list[float]]:
        """d(x, omega, excess)/dt between two kinks, over plain floats."""
        balance, law, at, start = self.balance, self.law, self.at, self.start
        fall_0, press_0, slope_0, rise_0 = (at[n] for n in ("fall", "press", "fall_slope", "press_slope"))
        turns, heats, lifted = balance.turns, self.heats, start.lifted
        slip_0, radius, unit, clock, scale = start.slip, balance.radius, self.speed_unit, self.time, balance.time_scale
        local: dict[str, float] = {**balance.values, **at, "excess": start.excess, "mu": 0.0}
        given = self._given(left, right)
        resist, heat, fall = (_function(balance, what) for what in ("resistance", "pressurisation", "fall"))
        coefficient, by_time = law.coefficient, "time" in law.depends_on
        early, late = _between(left, right)

        def rate(t: float, y: Any) -> list[float]:
            x, omega = float(y[0]), float(y[1])
            if turns:
                sine, cosine = math.sin(x), math.cos(x)
                local["fall"], local["fall_slope"] = fall_0 * cosine - slope_0 * sine, slope_0 * cosine + fall_0 * sine
                local["press"], local["press_slope"] = (
                    press_0 * cosine - rise_0 * sine,
                    rise_0 * cosine + press_0 * sine,
                )
            for name, function in given:
                local[name] = function(t)
            local["omega"], local["omega_2"] = omega, omega * omega
            if heats:
                local["excess"] = float(y[2])
            if not lifted:
                moment = min(max(clock + t, early), late) * scale if by_time else 0.0
                local["mu"] = float(coefficient(slip_0 + radius * max(x, 0.0), unit * max(omega, 0.0), moment))
            speeding = (fall(local) if fall else local["fall"]) - resist(local)  # type: ignore[misc]
            return [omega, speeding, heat(local) * omega] if heat else [omega, speeding]

        return rate

    def _given(self, left: float, right: float) -> list[tuple[str, Callable[[float], float]]]:
        """What changes with time, as functions of local time between two kinks."""
        found = []
        early, late = _between(left, right)
        for name, (function, factor) in self.balance.forcing.items():
            if name == "k_h":
                factor *= self.start.direction
            found.append((name, _piece_of(function, factor, self.balance.time_scale, self.time, early, late)))
        return found

    def _kinks(self) -> Floats:
        """Times from the start of the scene at which something given is not smooth, while this phase may last."""
        every = kinks_of(self.balance, self.law)
        now = self.time * (1.0 + 4 * EPS)  # what it began at is no kink ahead
        first, last = np.searchsorted(every, now, side="right"), np.searchsorted(every, self.time + self.longest)
        return every[first:last]

    # -- following it

    def _integrate(self, tolerance: float) -> None:
        start = self.start
        t, y = 0.0, np.array([0.0, math.sqrt(start.energy), start.excess][: 2 + self.heats])
        slips = [(k - start.slip) / self.balance.radius for k in self.law.kinks if k > start.slip]
        speeds = [v / self.speed_unit for v in self.law.speeds]
        left, steps, which, top = self.time, 0, "", float(y[1])

        def begin(method: Any, rate: Any, right: float, t: float, y: Floats, top: float) -> Any:
            """A solver from here to the next kink; it finds its steps anew, as what it follows bends there."""
            return method(rate, t, y, right - self.time, rtol=tolerance, atol=self._floor(tolerance, t, top))

        for right in map(float, chain(self._kinks(), [self.time + self.longest])):
            rate, self._window = self._equation(left, right), _between(left, right)
            band = self._band(rate, t, y, speeds)
            since, solver = steps, begin(DOP853, rate, right, t, y, top)
            while solver.status == "running":
                solver.step()
                if solver.status == "failed" or not np.all(np.isfinite(solver.y)):
                    raise OverflowError
                steps += 1
                if steps - since > _MOST_STEPS:
                    raise ValueError(
                        f"end_time: more than {_MOST_STEPS} steps after {self.time * self.balance.time_scale:.6g} s; "
                        "give an earlier end in s, or a smoother law"
                    )
                dense, before, now = solver.dense_output(), float(solver.t_old), float(solver.t)
                found = _first(self._watched(slips, speeds, band), self._noise(top), dense, before, now)
                if found is None:
                    self.pieces.append(Piece(before, now, dense))
                    t, y, top = now, solver.y, max(top, float(solver.y[1]))
                    if math.isinf(right) and _creeps(rate, t, y, top):
                        raise ValueError(
                            "end_time: this mass creeps to its rest, ever more slowly as what resists falls with "
                            "the speed, and never quite reaches it; give end_time in s"
                        )
                    solver.atol = self._floor(tolerance, t, top)
                    if isinstance(solver, DOP853) and steps - since > _STIFF_STEPS:
                        solver = begin(LSODA, rate, right, t, y, top)
                    continue
                which, t = found
                y = np.array(dense(t))
                self.pieces.append(Piece(before, t, dense))
                if which == "stands":
                    y[1], self.stops = 0.0, True
                if which in ("stands", "presses", "over"):
                    break
                if which == "slip":
                    y[0] = slips.pop(0)
                else:
                    y[1] = speeds[band if which == "faster" else band - 1]
                    band = self._band(rate, t, y, speeds)
                since, solver = steps, begin(type(solver), rate, right, t, y, top)
            if which in ("stands", "presses", "over"):
                break
            left = right
        self.end, self.speed, self.reached = float(y[0]), float(y[1]), t
        self.excess = float(y[2]) if self.heats else start.excess
        self.duration = t if which in ("stands", "presses") or (which == "over" and self.balance.turns) else math.inf
        if which == "presses":
            self.change = t, self.end, self.speed**2

    def _floor(self, tolerance: float, t: float, top: float) -> list[float]:
        """Absolute tolerances: what a rounded drive adds since the start, and of the speed a share of the greatest."""
        since = min(max(t, 1e-4), 1.0, 1.0 / max(float(self.balance.get("damping")), 1.0))
        noise = 16 * EPS * self._terms * since
        return [noise * since, max(0.1 * tolerance * top, noise), max(tolerance * abs(self.start.excess), noise)][
            : 2 + self.heats
        ]

    def _noise(self, top: float) -> dict[str, float]:
        """How far below zero rounding alone may put what is watched where it begins at zero."""
        pressing = 64 * EPS * (self._terms + self.balance.values["polar"] * top * top) / self.balance.values["level"]
        return {"stands": 16 * EPS * min(self._terms, 1.0) * max(top, 1e-6), "presses": pressing}

    @cached_property
    def _terms(self) -> float:
        """The size of the terms of which the drive is a difference."""
        given = self.balance.given(self.time + 1e-9, self.start.direction)
        tilted = abs(given.get("k_h", 0.0)) * abs(self.at["fall_slope"])
        return abs(self.at["fall"]) + abs(self.at["press"]) + float(tilted)

    def _band(self, rate: Callable[[float, Any], list[float]], t: float, y: Floats, speeds: list[float]) -> int:
        """Which piece of a table of speeds holds from here on."""
        omega = float(y[1])
        if omega in speeds:
            return speeds.index(omega) + (rate(t, y)[1] > 0.0)
        return bisect_right(speeds, omega)

    def _watched(self, slips: list[float], speeds: list[float], band: int) -> dict[str, Watch]:
        """What ends a step where it falls below zero, as functions of times and states."""
        found: dict[str, Watch] = {"stands": lambda t, y: y[1], "over": lambda t, y: self.furthest - y[0]}
        if self._may_lift:
            sign = -1.0 if self.start.lifted else 1.0
            found["presses"] = lambda t, y: sign * self.balance.get("effective_stress", **self._local(t, y))
        if slips:
            found["slip"] = lambda t, y: slips[0] - y[0]
        if band < len(speeds):
            found["faster"] = lambda t, y: speeds[band] - y[1]
        if band > 0:
            found["slower"] = lambda t, y: y[1] - speeds[band - 1]
        return found

    @cached_property
    def _may_lift(self) -> bool:
        forced = {"k_h", "k_v", "pore_pressure"} & set(self.balance.forcing)
        return bool(forced) or self.heats or self.balance.get("normal", press=0.0) != 0.0

    # -- what it is at given times

    def _local(self, t: Any, y: Any) -> dict[str, Any]:
        """What the balance needs, at local times and states."""
        now = np.clip(self.time + t, *self._window)
        found = self.balance.given(now, self.start.direction)
        found |= self.at if not self.balance.turns else _turned(self.at, y[0])
        found |= {"omega": y[1], "omega_2": y[1] * y[1]}
        if self.heats:
            found["excess"] = y[2]
        found["mu"] = 0.0
        if not self.start.lifted:
            slip = self.start.slip + self.balance.radius * y[0]
            speed = self.speed_unit * np.maximum(y[1], 0.0)
            found["mu"] = self.law.coefficient(slip, speed, now * self.balance.time_scale)
        return found

    def states(self, t: Floats) -> Floats:
        """x, omega and, where it is heated, the excess pressure, at local times."""
        found = np.empty((2 + self.heats, *t.shape))
        piece = np.clip(np.searchsorted(self._starts, t, side="right") - 1, 0, len(self.pieces) - 1)
        for k in np.unique(piece):
            inside = piece == k
            found[:, inside] = self.pieces[k].dense(np.minimum(t[inside], self.pieces[k].end))
        found[:2] = np.maximum(found[:2], 0.0)
        return found

    @property
    def lifts(self) -> tuple[float, ...]:
        """Times within the phase at which the mass lifts off; where it does, the phase ends."""
        return ()

    def excess_when(self, t: Floats) -> Floats:
        """Excess pore pressure over sigma_ref at times since the start of the phase."""
        return self.states(t)[2] if self.heats else np.full_like(t, self.start.excess)

    @cached_property
    def _starts(self) -> Floats:
        return np.array([p.start for p in self.pieces])

    def when(self, t: Floats) -> tuple[Floats, Floats, Floats]:
        """x, omega and d(omega)/dt at times since the start of the phase."""
        y = self.states(np.asarray(t, dtype=np.float64))
        local = self._local(t, y)
        return y[0], y[1], self._falls(local) - self.balance.get("resistance", **local)

    def _falls(self, local: dict[str, Any]) -> Any:
        return self.balance.get("fall", **local) if self.balance.has("fall") else local["fall"]

    def state(self, t: float) -> tuple[float, float, float]:
        """x, omega and d(omega)/dt at one time."""
        x, omega, rate = self.when(np.array([t]))
        return float(x[0]), float(omega[0]), float(rate[0])

    def fastest(self) -> tuple[float, float, float, float]:
        """Time, x, omega and d(omega)/dt at the greatest speed: at the end of a step, or where the rate turns."""
        starts, ends = self._starts, np.append(self._starts[1:], self.reached)
        inside = np.nextafter(starts, np.inf), np.nextafter(ends, -np.inf)
        _, first, rising = self.when(inside[0])
        _, last, falling = self.when(inside[1])
        k = int(np.argmax(np.maximum(first, last)))
        best, time = max((first[k], starts[k]), (last[k], ends[k]))
        bound = np.minimum(first + rising * (ends - starts), last - falling * (ends - starts))
        for k in np.flatnonzero((rising > 0.0) & (falling < 0.0) & (bound > best)).tolist():
            low, high = float(inside[0][k]), float(inside[1][k])
            t = root(lambda t: self.state(t)[2], low, high, float(rising[k]), float(falling[k]))
            if self.state(t)[1] > best:
                best, time = self.state(t)[1], t
        return (float(time), *self.state(float(time)))

    # -- energy

    def worked(self, t: Floats) -> Floats:
        """Work of gravity and shaking over Theta*, by quadrature, from the start of the phase."""
        return self._summed(self._works, t, lambda local: self._falls(local) * local["omega"])

    def dissipated(self, t: Floats) -> Floats:
        """Energy over Theta* that the resistance has taken since the start, by quadrature of its own."""
        return self._summed(self._losses, t, lambda local: self.balance.get("resistance", **local) * local["omega"])

    @cached_property
    def _works(self) -> Floats:
        return self._totals(lambda local: self._falls(local) * local["omega"])

    @cached_property
    def _losses(self) -> Floats:
        return self._totals(lambda local: self.balance.get("resistance", **local) * local["omega"])

    def _totals(self, power: Callable[[dict[str, Any]], Any]) -> Floats:
        """What a power adds up to, until each piece begins and until the end."""
        ends = np.array([p.end for p in self.pieces])
        width = ends - self._starts
        nodes = self._starts[:, None] + width[:, None] * _GAUSS[0]
        return np.append(0.0, np.cumsum(width * (power(self._local(nodes, self.states(nodes))) @ _GAUSS[1])))

    def _summed(self, totals: Floats, t: Floats, power: Callable[[dict[str, Any]], Any]) -> Floats:
        piece = np.clip(np.searchsorted(self._starts, t, side="right") - 1, 0, len(self.pieces) - 1)
        width = np.minimum(t, self.reached) - self._starts[piece]
        nodes = self._starts[piece][:, None] + width[:, None] * _GAUSS[0]
        return np.asarray(totals[piece] + width * (power(self._local(nodes, self.states(nodes))) @ _GAUSS[1]))


def _creeps(rate: Callable[[float, Any], list[float]], t: float, y: Floats, top: float) -> bool:
    """Whether it is all but at rest, and slows down in proportion to its speed."""
    omega = float(y[1])
    return omega < 1e-9 * top and 0.0 < -1e-3 * rate(t, y)[1] < omega


def _turned(at: dict[str, float], x: Any) -> dict[str, Any]:
    """A position after a rotation x in the direction of travel."""
    sine, cosine = np.sin(x), np.cos(x)
    return at | {
        "fall": at["fall"] * cosine - at["fall_slope"] * sine,
        "press": at["press"] * cosine - at["press_slope"] * sine,
        "fall_slope": at["fall_slope"] * cosine + at["fall"] * sine,
        "press_slope": at["press_slope"] * cosine + at["press"] * sine,
    }


def _function(balance: Balance, what: str) -> Callable[[dict[str, float]], float] | None:
    """A function of the balance over plain floats, of a mapping of all its arguments; None if it is not there."""
    name = balance.names.get(what)
    if name is None:
        return None
    plain, names = scalar(getattr(functions, name)), ARGUMENTS[name]
    if len(names) == 1:
        return lambda local: float(plain(local[names[0]]))
    pick = itemgetter(*names)
    return lambda local: float(plain(*pick(local)))


def _between(left: float, right: float) -> tuple[float, float]:
    """Just inside two kinks, in s too, where a function that jumps there has the value that it has between them."""
    return left * (1.0 + 4 * EPS), right * (1.0 - 4 * EPS)


def _piece_of(
    function: Any, factor: float, scale: float, clock: float, early: float, late: float
) -> Callable[[float], float]:
    """A function of time between two kinks, of local time: constant or straight where it is a series."""
    if math.isinf(late):
        value = factor * float(function((2 * early + 1.0) * scale))
        return lambda t: value
    if hasattr(function, "values"):
        one, two = (factor * float(function(t * scale)) for t in (early, late))
        slope = (two - one) / max(late - early, 1e-300)
        return lambda t: one + slope * (clock + t - early)
    return lambda t: factor * float(function(min(max(clock + t, early), late) * scale))


def _at(watch: Watch, dense: Callable[[Any], Any], t: float) -> float:
    return float(watch(t, dense(t)))


def _first(
    watched: dict[str, Watch], noise: dict[str, float], dense: Callable[[Any], Any], before: float, now: float
) -> tuple[str, float] | None:
    """Which watched function falls below zero first in a step, and when; just after zero, below what rounding does."""
    times = before + (now - before) * _INSIDE
    states = dense(times)
    found: tuple[str, float] | None = None
    for name, watch in watched.items():
        values = np.asarray(watch(times, states)) + 0.0 * times
        below = np.flatnonzero(values < (0.0 if values[0] > 0.0 else -noise.get(name, 0.0)))
        if not len(below):
            continue
        k = int(below[0])
        low, high = float(times[max(k - 1, 0)]), float(times[k])
        t = low
        if values[max(k - 1, 0)] > 0.0:
            t = root(partial(_at, watch, dense), low, high, float(values[k - 1]), float(values[k]))
        if found is None or t < found[1]:
            found = name, t
    return found
