"""One phase of motion in the phase plane: E = omega**2 against the rotation x, then the time by quadrature.

E obeys E' = 2 (drive - brake E), linear (design of the paper's (3.11)): in closed form with constant friction, or
exponential softening without brake, on a turning mass; otherwise by collocation on panels.
"""

import math
from collections.abc import Callable
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from generated import balance as functions
from generated.effects import ARGUMENTS
from slipcircle.balance import Balance
from slipcircle.friction import Friction
from slipcircle.methods.chebyshev import Piecewise, accumulate, quadrature, resolve
from slipcircle.methods.collocation import (
    BACK,
    MEAN,
    RESOLVED,
    Panels,
    Z,
    joined,
    over_panels,
    propose,
    series_at,
    solved,
)
from slipcircle.methods.liftoff import EndsAtLiftOff
from slipcircle.methods.roots import halley, root, scalar

if TYPE_CHECKING:
    from slipcircle.motion import Start

Floats = NDArray[np.float64]
# Panels on which E in closed form is searched for its greatest value, over its end.
_SHARES = np.concatenate([[0.0], np.geomspace(1e-18, 0.1, 50), np.linspace(0.1, 1.0, 50)[1:]])
MOST_PANELS = 4000  # of the collocation, halvings counted
_MOST_AHEAD = 12  # that are looked at together


class Course(EndsAtLiftOff):
    """E(x) of one phase, from its start to its standstill.

    Attributes
    ----------
    end : float
        Rotation x at which the mass stands still, or to which it is followed.
    stops : bool
        Whether it stands still there.
    peak : float
        Rotation at which the speed is greatest.
    """

    def __init__(self, balance: Balance, law: Friction, start: "Start", longest: float) -> None:
        self.balance, self.law, self.start, self.longest = balance, law, start, longest
        self.radius = balance.radius
        self.at = balance.position(start.rotation, start.direction) | {"excess": start.excess}
        self.mu = 0.0 if start.lifted else float(law.coefficient(start.slip))
        get = balance.get
        self.constant = float(get("constant", mu=self.mu, excess=start.excess))
        self.drive = balance.drive(self.at, self.mu)
        self.tilt = float(get("tilt", **self.at, mu=self.mu))
        self.brake = float(get("brake", mu=self.mu))
        self.steady = start.slip >= law.settled or start.lifted
        # Beyond, the mass would hang over; above zero, for a chord that stands upright to rounding.
        self.furthest = max(self.at["dip"] + np.pi / 2, 1e-20) if balance.turns else math.inf
        alone = balance.turns and not balance.has("pressurisation")  # E follows from the rotation alone
        self.closed = alone and (self.steady or (law.law == "exponential" and not balance.has("brake")))
        self.unresolved, self.breaks = 0.0, list[float]()  # rotations between which all is smooth, where known
        if self.closed:
            self.energy, self._scalar = self._closed_form()
            self._slope_at: Callable[[float], float] = lambda x: float(self.slope(x, self._scalar(x)))
            self.end, self.stops = self._first_zero()
            if self.steady and self.stops:
                self._both_ways = self._from_both_ends()
        else:
            self.end, self.stops = self._collocate(longest)
        self.peak = self._peak(self.end)

    # -- the balance along the path

    def press(self, x: Any) -> Any:
        """J_r/Theta* at x; press_slope is its derivative by the dip, which falls as x grows."""
        if not self.balance.turns:
            return self.at["press"] + 0.0 * x
        return self.at["press"] * np.cos(x) - self.at["press_slope"] * np.sin(x)

    def fall(self, x: Any) -> Any:
        """J_theta/Theta* at x."""
        if not self.balance.turns:
            return self.at["fall"] + 0.0 * x
        return self.at["fall"] * np.cos(x) - self.at["fall_slope"] * np.sin(x)

    def pressing(self, x: Any, energy: Any) -> Any:
        """The effective mean normal stress over sigma_ref; the mass lifts off where it is negative."""
        return self.balance.get("effective_stress", press=self.press(x), omega_2=energy)

    def drop(self, x: Any) -> Any:
        """How far friction has fallen since the start of the phase."""
        return 0.0 * x if self.steady else self.law.drop(self.start.slip, self.radius * x)

    def along(self, x: Any) -> tuple[Any, Any]:
        """Drive and friction coefficient at x.

        The drive is the one at the start, and what turning and softening change, so that no digit is lost.
        """
        driving = self.drive + 0.0 * x
        if self.balance.turns:
            driving = self.drive * np.cos(x) - self.tilt * np.sin(x)
            if self.constant:
                driving = driving - 2 * self.constant * np.sin(x / 2) ** 2
        if self.steady:
            return driving, self.mu
        fallen, normal = self.drop(x), self.balance.get("normal", press=self.press(x), excess=self.start.excess)
        driving, mu, gone = driving + fallen * normal, self.mu - fallen, fallen > self.mu / 2
        if np.any(gone):  # where most of it is gone, what is left of it has more digits than the difference
            mu = np.where(gone, self.law.coefficient(self.start.slip + self.radius * x), mu)
            driving = np.where(gone, self.fall(x) - self.balance.get("constant", mu=0.0) - mu * normal, driving)
        return driving, mu

    def friction(self, x: Any) -> Any:
        """The friction coefficient at x."""
        return self.along(x)[1]

    def driving(self, x: Any) -> Any:
        """The drive at x."""
        return self.along(x)[0]

    def braking(self, x: Any) -> Any:
        """The brake at x."""
        return self._brake(self.friction(x)) + 0.0 * x

    def _brake(self, mu: Any) -> Any:
        return self.brake if self.steady else self.balance.get("brake", mu=mu)

    def resistance(self, x: Any, energy: Any) -> Any:
        """The moment over Theta* of all that opposes the motion."""
        return self.balance.get("resistance", mu=self.friction(x), press=self.press(x), omega_2=energy) + 0.0 * x

    def worked(self, t: Floats) -> Floats:
        """Work of gravity over Theta* at times since the start of the phase."""
        return np.asarray(self.work(self.when(t)[0]))

    def work(self, x: Any) -> Any:
        """Work of gravity over Theta*, from the start of the phase."""
        if not self.balance.turns:
            return self.at["fall"] * x
        return self.at["fall"] * np.sin(x) - self.at["fall_slope"] * 2 * np.sin(x / 2) ** 2

    def slope(self, x: Any, energy: Any) -> Any:
        """E' = 2 (drive - brake E)."""
        driving, mu = self.along(x)
        return 2 * (driving - self._brake(mu) * energy)

    # -- E in closed form

    def _closed_form(self) -> tuple[Callable[[Any], Any], Callable[[float], float]]:
        name = self.balance.names["energy" if self.steady else "energy_softening"]
        known = {"start": self.start.energy, "drive": self.drive, "tilt": self.tilt, "constant": self.constant,
                 "brake": self.brake}  # fmt: skip
        if not self.steady:
            known |= {
                "drop": float(self.law.drop(self.start.slip, math.inf)),
                "decay": self.radius / self.law.scale,
                "press": self.balance.get("normal", press=self.at["press"], level=0.0),
                "press_rise": self.balance.get("normal", press=-self.at["press_slope"], level=0.0),
                "water": -self.balance.get("normal", press=0.0),
            }
        rest = [known[a] for a in ARGUMENTS[name][1:]]
        function = getattr(functions, name)
        plain = scalar(function)
        return (lambda x: function(x, *rest)), (lambda x: plain(x, *rest))

    def _from_both_ends(self) -> Callable[[Any, Any], Any]:
        """E by the same closed form, from the start in the first half and back from the standstill in the second.

        With y = end - x the equation keeps its form: drive, constant and brake change their signs.
        """
        drive = float(self.driving(self.end))
        tilt = (self.drive + self.constant) * math.sin(self.end) + self.tilt * math.cos(self.end)
        pairs = {"start": (self.start.energy, 0.0), "drive": (self.drive, -drive), "tilt": (self.tilt, tilt),
                 "constant": (self.constant, -self.constant), "brake": (self.brake, -self.brake)}  # fmt: skip
        name = self.balance.names["energy"]
        function, either = getattr(functions, name), np.array([pairs[a] for a in ARGUMENTS[name][1:]])

        def energy(x: Any, left: Any) -> Any:
            # Backwards a brake lets errors grow, by exp(2 brake left).
            back = (left < x) & (2 * self.brake * left < 1.0)
            return function(np.where(back, left, x), *either[:, back.view(np.int8)])

        return energy

    def _first_zero(self) -> tuple[float, bool]:
        """The first x > 0 with E = 0.

        With constant friction E rises at most once and falls at most once before it (E'' < 0 wherever E' = 0), so
        any point with E > 0 and the end of the path bracket it. Softening, or water that would carry the mass further
        on, may bring E near zero more than once, so there the path is searched.
        """
        E, far = self._scalar, self.furthest
        if self.steady and not (self.constant < 0.0 and (E(far) > 0.0 or self.drive < 0.0)):
            # The end of the parabola with E's slope and curvature at the start; where nothing but the drive moves the
            # mass, E falls to zero before the end of the path, and just after the start it is positive.
            curvature = max(self.tilt + 2 * self.brake * self.drive, 1e-300)
            if self.start.energy == 0.0:
                return halley(self._energy_and_rates, min(2 * self.drive / curvature, far / 2), 0.0, far), True
            slope = self.drive - self.brake * self.start.energy
            root_of = math.sqrt(max(slope * slope + curvature * self.start.energy, 0.0))
            if slope < 0.0:
                guess = self.start.energy / (root_of - slope)
            else:
                guess = (slope + root_of) / curvature if curvature * far > slope else far
            low, high = 0.0, min(max(guess, 1e-300), far)
            while E(high) > 0.0 and high < far:
                low, high = high, min(2 * high, far)
            if E(high) > 0.0:
                return far, False
            return halley(self._energy_and_rates, min(max(guess, low), high), low, high), True
        grid = np.concatenate(
            [np.geomspace(min(1e-20, far * 1e-6), far * 0.01, 200), np.linspace(far * 0.01, far, 300)[1:]]
        )
        values = self.energy(grid)
        below = np.flatnonzero(values <= 0.0)
        inner = values[1:-1]
        dips = np.flatnonzero((inner < values[:-2]) & (inner <= values[2:])) + 1
        for k in dips:  # between the samples E may fall below zero and rise again
            if len(below) and k > below[0]:
                break
            left, right = float(grid[k - 1]), float(grid[k + 1])
            if self._slope_at(left) < 0.0 < self._slope_at(right):
                lowest = root(self._slope_at, left, right, self._slope_at(left), self._slope_at(right))
                if E(lowest) <= 0.0:
                    return root(E, left, lowest, E(left), E(lowest)), True
        if not len(below):
            return far, False
        first = int(below[0])
        left = float(grid[first - 1]) if first else 0.0
        return root(E, left, float(grid[first]), E(left) if first else 1.0, float(values[first])), True

    def _energy_and_rates(self, x: float) -> tuple[float, float, float]:
        """E and its first two derivatives at x, with constant friction on a turning mass."""
        energy, sine, cosine = self._scalar(x), math.sin(x), math.cos(x)
        turned = self.drive * cosine - self.tilt * sine - 2 * self.constant * math.sin(x / 2) ** 2
        rate = 2 * (turned - self.brake * energy)
        return energy, rate, -2 * ((self.drive + self.constant) * sine + self.tilt * cosine + self.brake * rate)

    def _rates(self, x: float) -> tuple[float, float, float]:
        """The first three derivatives of E at x."""
        _, rate, change = self._energy_and_rates(x)
        turned = (self.drive + self.constant) * math.cos(x) - self.tilt * math.sin(x)
        return rate, change, -2 * (turned + self.brake * change)

    def _peak(self, last: float) -> float:
        """Where E is greatest on [0, last]."""
        rate = self._slope_at
        if self.closed and self.steady and self.constant >= 0.0:
            if self.drive <= self.brake * self.start.energy:
                return 0.0
            if not self.stops and rate(self.end) >= 0.0:
                return self.end
            # A strong brake soon holds the drive, and E' is rounded from then on.
            held, top = 20.0 / max(self.brake, 1e-300), halley(self._rates, self.end / 2, 0.0, self.end)
            return top if held >= self.end else max(top, held, key=self._scalar)
        grid, values = self._sampled
        inside = grid < last
        grid, values = np.append(grid[inside], last), np.append(values[inside], self._scalar(last))
        k = int(np.argmax(values))
        left, right = float(grid[max(k - 1, 0)]), float(grid[min(k + 1, len(grid) - 1)])
        at_left, at_right = rate(left), rate(right)
        return root(rate, left, right, at_left, at_right) if at_left > 0.0 > at_right else float(grid[k])

    @cached_property
    def _sampled(self) -> tuple[Floats, Floats]:
        """Places along the path, and E there."""
        edges = self.end * _SHARES
        grid = (edges[:-1, None] + np.diff(edges)[:, None] * np.linspace(0.0, 1.0, 8, endpoint=False)).ravel()
        return grid, self.energy(grid)

    # -- E by collocation, panel by panel

    def _equation(self, x: Floats) -> tuple[Floats, Floats]:
        """Right side and matrix of E' = 2 drive - 2 brake E, for collocation."""
        driving, mu = self.along(x)
        return 2 * driving[None], np.broadcast_to(2 * self._brake(mu), (1, 1, *x.shape))

    def _begin(self) -> Floats:
        return np.array([self.start.energy])

    def _keep(self, found: Panels) -> None:
        """E and E' as functions."""
        edges, starts = found.edges, found.values[:, 0].tolist()
        mean, rate = series_at(edges, found.means[:, 0]), series_at(edges, found.rates[:, 0])

        def at(x: float) -> float:
            k, past, slope = mean(x)
            return float(starts[k] + past * slope)

        self.energy, self._scalar = over_panels(edges, found.values[:-1, 0], found.means[:, 0].T), at
        self._slope_at = lambda x: rate(x)[2]
        self.breaks = edges[1:-1].tolist()

    def _collocate(self, longest: float) -> tuple[float, bool]:
        """E on panels, until it is zero, or the path ends, or more than the longest time has passed."""
        scale = min(self.law.scale / self.radius, 1.0, self.furthest)
        if self.drive > 0.0:
            scale = min(scale, self.drive)
        elif self.drive < 0.0:  # the way to a standstill
            scale = min(scale, self.start.energy / -self.drive)
        kinks = sorted((k - self.start.slip) / self.radius for k in self.law.kinks if k > self.start.slip)
        never = 1e7 * max(1.0, self.law.scale / self.radius if math.isfinite(self.law.scale) else 0.0)
        width, elapsed, blur, parts = scale / 2, 0.0, self.radius / self.law.scale, list[Panels]()
        left, state, many, tried = 0.0, self._begin(), _MOST_AHEAD, 0
        while tried < MOST_PANELS:
            edges = [left]
            while len(edges) <= many and edges[-1] < self.furthest:  # as many as may be good, each twice the last
                last = edges[-1]
                edges.append(min([last + width, self.furthest, *(k for k in kinks if k > last)]))
                width *= 2
            ahead = solved(*propose(self._equation, np.array(edges), self.balance.weight, blur), state)
            half, right = np.diff(ahead.edges), ahead.edges[1:]
            bad = (ahead.missing > RESOLVED) & (half > 1e-13 * right)
            good = int(np.argmax(bad)) if bad.any() else len(half)
            width, many = (half[good] / 2, good + 1) if good < len(half) else (2 * float(half.max()), 2 * many)
            many, tried = min(many, _MOST_AHEAD), tried + good + 1
            energy = ahead.states[:good, 0]
            highest = np.maximum(np.maximum(energy.max(axis=1), ahead.values[:good, 0]), 1e-300)
            passed = elapsed + np.cumsum(half[:good] / np.sqrt(highest))
            ended = energy.min(axis=1) <= 0.0
            enough = ended | (right[:good] >= self.furthest) | (passed > longest)
            if math.isinf(longest):
                enough |= right[:good] > never
            count, done, stop = good, bool(enough.any()), math.inf
            if done:
                count = int(np.argmax(enough)) + 1
                if ended[count - 1]:
                    stop, begin, whole = self._standstill(ahead.first(count)), ahead.edges[count - 1], half[count - 1]
                    if (
                        stop - begin < 0.1 * whole and whole > 1e-13 * stop
                    ):  # what is behind must not set the scale there: once more, shorter
                        width, count, done = max(4 * (stop - begin), 0.01 * whole), count - 1, False
            if count:
                parts.append(ahead.first(count))
                left, state, elapsed = float(ahead.edges[count]), ahead.values[count], float(passed[count - 1])
            if not done:
                continue
            panels = joined(parts)
            self._keep(panels)
            self._sampled = panels.nodes[:, ::-1].ravel(), panels.states[:, 0, ::-1].ravel()
            self.unresolved = float(panels.missing.max())
            if math.isinf(stop):
                return left, False
            stops = float(self.slope(stop, 0.0)) < 0.0
            return stop if stops else float(panels.edges[-2]), stops  # or E has only become too small for a number
        raise ValueError(
            f"friction: changes too sharply for {MOST_PANELS} panels of the energy equation, near a slip of "
            f"{self.start.slip + self.radius * left:.6g} m; give a smoother law"
        )

    def _standstill(self, panels: Panels) -> float:
        """Where E falls to zero on the last panel."""
        mean = series_at(panels.edges[-2:], panels.means[-1:, 0])
        start = float(panels.values[-2, 0])

        def energy(x: float) -> float:
            _, past, slope = mean(x)
            return start + past * slope

        grid = panels.nodes[-1, ::-1]
        below = int(np.argmax(panels.states[-1, 0, ::-1] <= 0.0))
        low, high = float(grid[below - 1] if below else panels.edges[-2]), float(grid[below])
        # The series are rounded otherwise than the values at the nodes that the bracket comes from.
        return root(energy, low, high, max(energy(low), 1e-300), min(energy(high), -1e-300))

    # -- time

    def _place(self, s: Any) -> tuple[Any, Any, Any]:
        """x, the distance to the end and dx/ds, for a variable s in which the time is smooth: roots at both ends."""
        if self.stops:
            sine, cosine = np.sin(s), np.cos(s)
            return self.end * sine * sine, self.end * cosine * cosine, (2 * self.end) * sine * cosine
        return self.end * s * s, self.end * (1.0 - s * s), (2 * self.end) * s

    def speed_squared(self, x: Any, left: Any) -> Any:
        """E at x, relatively accurate also next to the standstill, where it is integrated from the end."""
        if self.stops and self.steady and self.closed:
            return np.maximum(self._both_ways(x, left), 0.0)
        found = np.asarray(self.energy(x))
        if self.stops:
            reach, before = self._before_standstill
            near = left < reach
            found[near] = before(left[near])
        return np.maximum(found, 0.0)

    @cached_property
    def _before_standstill(self) -> tuple[float, Callable[[Any], Any]]:
        """E by the distance to the standstill, from which it is integrated, and up to where.

        From the end a brake lets errors grow, by exp(2 brake left), and further on E is what the brake makes of it.
        """
        reach = min(0.05 * self.end, 0.5 / max(abs(float(self.braking(self.end))), 1e-300))
        edges = np.array([0.0, *(d for b in reversed(self.breaks) if 0.0 < (d := self.end - b) < reach), reach])
        width = np.diff(edges)
        x = self.end - (edges[:-1] + width * Z[:, None])
        means = MEAN @ -self.slope(x, np.maximum(self.energy(x), 0.0))
        values = np.concatenate([[0.0], np.cumsum(means[0] * width)])
        return reach, over_panels(edges, values, BACK @ means)

    @cached_property
    def pace(self) -> Piecewise:
        """dt/ds."""
        last = np.pi / 2 if self.stops else 1.0
        places = [self._variable(k) for k in self.breaks if k < self.end]
        # Over what E first changes: a slow start and, where no panels of its own show it, softening, a strong brake.
        # Panels grow from there.
        paces = [self.start.energy / max(abs(self.drive), 1e-300)]
        if self.closed:
            paces += [1.0 / max(2 * self.brake, 1e-300), math.inf if self.steady else self.law.scale / self.radius]
        scales = [p / self.end for p in paces if 0.0 < p < 0.01 * self.end]
        first = [math.sqrt(p) * 2.0**k for p in scales for k in range(0, 600, 2) if math.sqrt(p) * 2.0**k < last / 2]

        return resolve(self._rate, np.array(sorted({0.0, *places, *first, last})), 4e-15)

    @cached_property
    def clock(self) -> Piecewise:
        """t(s)."""
        return self.pace.integral()

    def _rate(self, s: Floats) -> Floats:
        x, left, stretch = self._place(s)
        return np.asarray(stretch / np.sqrt(self.speed_squared(x, left)))

    def _variable(self, x: float) -> float:
        """The variable s at x."""
        share = math.sqrt(min(max(x / self.end, 0.0), 1.0))
        return math.asin(share) if self.stops else share

    @cached_property
    def _times(self) -> tuple[float, float, float]:
        """Times to the end and to the peak, and what is estimated to be missing from them.

        By quadrature; where that does not resolve the rate, or would pass over a start that a strong brake soon ends,
        by the series on refined panels.
        """
        last, top = (np.pi / 2 if self.stops else 1.0), self._variable(self.peak)
        edges = np.array(sorted({0.0, top, *(self._variable(b) for b in self.breaks if b < self.end), last}))
        smooth = not self.closed or (self.steady and self.brake * self.end < 100.0)
        if smooth and self.start.energy == 0.0:
            whole, part, missing = quadrature(self._rate, edges, top)
            if missing <= 4e-14 * whole:
                return whole, part, missing
        at_top = max(float(self.clock(np.array([top]))[0]), 0.0) if top < last else self.clock.end
        return self.clock.end, at_top, self.clock.tail

    @property
    def duration(self) -> float:
        """Time from the start of the phase to its end."""
        return self._times[0]

    def fastest(self) -> tuple[float, float, float, float]:
        """Time, x, omega and d(omega)/dt at the greatest speed."""
        time, peak, last = self._times[1], self.peak, self.end
        if time > self.longest and not (
            self.closed and self.steady and self.constant >= 0.0
        ):  # E may have risen and fallen before
            last = self.state(self.longest)[0]
            peak = self._peak(last)
            time = float(self.clock(np.array([self._variable(peak)]))[0])
        energy = max(self._scalar(peak), 0.0)
        rate = 0.0 if 0.0 < peak < last else float(self.slope(peak, energy)) / 2
        return time, peak, math.sqrt(energy), rate

    def state(self, t: float) -> tuple[float, float, float]:
        """x, omega and d(omega)/dt at one time."""
        x, omega, rate = self.when(np.array([t]))
        return float(x[0]), float(omega[0]), float(rate[0])

    def _loss(self, s: Floats) -> Floats:
        x, left, stretch = self._place(s)
        return np.asarray(self.resistance(x, self.speed_squared(x, left)) * stretch)

    @cached_property
    def _losses(self) -> Piecewise:
        return resolve(self._loss, self.clock.edges, 4e-15).integral()

    def dissipated(self, t: Floats) -> Floats:
        """Energy over Theta* that the resistance has taken since the start, by quadrature of its own."""
        return accumulate(self._loss, self._losses, self._reached(t))

    def _reached(self, t: Floats) -> Floats:
        """The variable s at times since the start of the phase, with all its digits also just after it."""
        s = self.clock.inverse(t, self.pace)
        early = (t > 0.0) & (s < self.clock.edges[1])
        if not np.any(early):
            return s
        at = t[early]
        x = math.sqrt(self.start.energy) * at + max(self.drive, 0.0) / 2 * at**2
        z = np.where(at < 1e-6 * self.clock.end, np.sqrt(np.minimum(x / self.end, 1.0)), s[early])
        for _ in range(4):  # Newton's method; the series' error is relative to the whole time, a new integral's is not
            with np.errstate(divide="ignore"):  # next to a standstill E may underflow: no step from there
                following = z - (accumulate(self._rate, self.clock, z) - at) / self._rate(z)
            z = np.where(following > 0.0, following, z / 2)
        s = s.copy()
        s[early] = z
        return s

    # -- along the variable s

    @property
    def last(self) -> float:
        """Where the phase ends, or the longest time."""
        if self.duration <= self.longest:
            return np.pi / 2 if self.stops else 1.0
        return float(self._reached(np.array([self.longest]))[0])

    def passing(self, s: Floats) -> tuple[Floats, Floats]:
        """x and E."""
        x, left, _ = self._place(s)
        return x, self.speed_squared(x, left)

    def passed(self, s: Floats) -> Floats:
        """The time since the start of the phase."""
        return accumulate(self._rate, self.clock, s)

    # -- at any time

    def when(self, t: Floats) -> tuple[Floats, Floats, Floats]:
        """x, omega and d(omega)/dt at times since the start of the phase."""
        x, left, _ = self._place(self._reached(t))
        energy = self.speed_squared(x, left)
        return x, np.sqrt(energy), self.slope(x, energy) / 2
