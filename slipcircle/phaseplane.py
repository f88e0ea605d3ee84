"""One phase of motion in the phase plane: E = omega**2 against the rotation x, then the time by quadrature.

E obeys E' = 2 (drive - brake E), linear (design of the paper's (3.11)): in closed form with constant friction, or
exponential softening without brake, on a turning mass; otherwise by collocation on panels.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from types import FunctionType, SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated import balance as functions
from generated.effects import ARGUMENTS
from slipcircle.balance import Balance
from slipcircle.chebyshev import NODES, Piecewise, accumulate, resolve
from slipcircle.friction import Friction

Floats = NDArray[np.float64]
EPS = 2.0**-52
ROUNDING = 8.0  # units in which a term of E is uncertain: kernels, products and sums

# Collocation on [0, 1]: nodes, node values -> series, and node values of f -> the mean of f on [0, z] at the nodes z
# and at 1. Means, not integrals, so that E grows from zero without losing digits.
_Z = (np.cos(np.pi * (np.arange(NODES) + 0.5) / NODES) + 1) / 2
_GAUSS = (np.polynomial.legendre.leggauss(12)[0] + 1) / 2, np.polynomial.legendre.leggauss(12)[1] / 2
_BACK = np.linalg.inv(np.polynomial.chebyshev.chebvander(2 * _Z - 1, NODES - 1))


def _mean(z: Floats) -> Floats:
    inside = np.polynomial.chebyshev.chebvander(2 * z[:, None] * _GAUSS[0] - 1, NODES - 1) @ _BACK
    return np.einsum("zgn,g->zn", inside, _GAUSS[1])


_MEAN, _MEAN_TO_END = _mean(_Z), _mean(np.ones(1))[0]


@dataclass(frozen=True)
class Start:
    """Where a phase begins: in the direction of travel, dimensionless; slip in m."""

    rotation: float  # of the mass, in its own sense
    direction: int
    energy: float  # E = omega**2
    slip: float
    lifted: bool  # nothing presses on the slip surface


# The generated text computes on plain floats too, with the standard library in NumPy's place: 20 times faster there.
_MATH = SimpleNamespace(
    sin=math.sin, cos=math.cos, exp=math.exp, expm1=math.expm1, abs=abs, minimum=min, maximum=max,
    where=lambda condition, yes, no: yes if condition else no,
)  # fmt: skip


def scalar(function: Any) -> Callable[..., float]:
    """A generated function over plain floats."""
    return FunctionType(function.__code__, {"np": _MATH}, function.__name__)


def root(function: Callable[[float], float], low: float, high: float, at_low: float, at_high: float) -> float:
    """A zero in a bracket with a sign change (Chandrupatla 1997: inverse quadratic steps where safe, else bisection)."""
    a, b, c, fa, fb, fc = high, low, high, at_high, at_low, at_high
    share = 0.5
    for _ in range(200):
        x = a + share * (b - a)
        fx = function(x)
        if (fx > 0.0) == (fa > 0.0):
            c, fc = a, fa
        else:
            b, c, fb, fc = a, b, fa, fb
        a, fa = x, fx
        best, fbest = (a, fa) if abs(fa) < abs(fb) else (b, fb)
        limit = 2.0**-53 * abs(best) / max(abs(b - a), 1e-320)
        if fbest == 0.0 or limit > 0.5:
            return best
        xi, phi = (a - b) / (c - b), (fa - fb) / (fc - fb)
        share = 0.5
        if 1.0 - math.sqrt(1.0 - xi) < phi < math.sqrt(xi):
            share = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
        share = min(max(share, limit), 1.0 - limit)
    return best


def _energy(edges: Floats, values: Floats, means: Floats) -> Callable[[Any], Any]:
    """E(x) from its values at the panels' left edges and the series of its mean slope from there."""

    def energy(x: Any) -> Any:
        at = np.asarray(x, dtype=np.float64)
        k = np.clip(np.searchsorted(edges, at, side="right") - 1, 0, len(edges) - 2)
        past = at - edges[k]
        z = 2 * past / (edges[k + 1] - edges[k]) - 1
        return values[k] + past * np.polynomial.chebyshev.chebval(z, means[:, k], tensor=False)

    return energy


class Course:
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

    def __init__(self, balance: Balance, law: Friction, radius: float, start: Start, longest: float) -> None:
        self.balance, self.law, self.radius, self.start, self.longest = balance, law, radius, start, longest
        self.at = balance.position(start.rotation, start.direction)
        self.mu = 0.0 if start.lifted else float(law.coefficient(start.slip))
        get = balance.get
        self.constant = float(get("constant", mu=self.mu))
        if start.lifted:
            self.drive = self.at["fall"] - self.constant
        else:
            self.drive = float(get("drive", **self.at, mu=self.mu, limit_friction=get("limit_friction", **self.at)))
        self.tilt = float(get("tilt", **self.at, mu=self.mu))
        self.brake = float(get("brake", mu=self.mu))
        self.steady = law.constant or start.lifted
        self.furthest = self.at["dip"] + np.pi / 2 if balance.turns else math.inf  # beyond, the mass would hang over
        closed = balance.turns and (self.steady or (law.law == "exponential" and not balance.has("brake")))
        self.unresolved = 0.0
        if closed:
            self.energy, self._scalar = self._closed_form()
            self.end, self.stops = self._first_zero()
        else:
            self.energy, self.end, self.stops = self._collocate(longest)
            self._scalar = lambda x: float(self.energy(np.array([x]))[0])
        self.peak = self._peak()

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

    def friction(self, x: Any) -> Any:
        """The friction coefficient at x."""
        return self.mu - self.drop(x)

    def driving(self, x: Any) -> Any:
        """The drive at x: the one at the start, and what turning and softening change, so that no digit is lost."""
        driving = self.drive + 0.0 * x
        if self.balance.turns:
            driving = self.drive * np.cos(x) - self.tilt * np.sin(x) - 2 * self.constant * np.sin(x / 2) ** 2
        if self.steady:
            return driving
        return driving + self.drop(x) * self.balance.get("normal", press=self.press(x))

    def braking(self, x: Any) -> Any:
        """The brake at x."""
        return self.brake + 0.0 * x if self.steady else self.balance.get("brake", mu=self.friction(x)) + 0.0 * x

    def resistance(self, x: Any, energy: Any) -> Any:
        """The moment over Theta* of all that opposes the motion."""
        return self.balance.get("resistance", mu=self.friction(x), press=self.press(x), omega_2=energy) + 0.0 * x

    def work(self, x: Any) -> Any:
        """Work of gravity over Theta*, from the start of the phase."""
        if not self.balance.turns:
            return self.at["fall"] * x
        return self.at["fall"] * np.sin(x) - self.at["fall_slope"] * 2 * np.sin(x / 2) ** 2

    def slope(self, x: Any, energy: Any) -> Any:
        """E' = 2 (drive - brake E)."""
        return 2 * (self.driving(x) - self.braking(x) * energy)

    # -- E in closed form

    def _closed_form(self) -> tuple[Callable[[Any], Any], Callable[[float], float]]:
        name = self.balance.names["energy" if self.steady else "energy_softening"]
        known = {"start": self.start.energy, "drive": self.drive, "tilt": self.tilt, "constant": self.constant,
                 "brake": self.brake}  # fmt: skip
        if not self.steady:
            share = 1.0 - self.balance.values.get("pore_ratio", 0.0)
            known |= {
                "drop": float(self.law.drop(self.start.slip, math.inf)),
                "decay": self.radius / self.law.scale,
                "press": self.at["press"] * share,
                "press_rise": -self.at["press_slope"] * share,
                "water": self.balance.values["level"] * self.balance.values.get("pore_pressure", 0.0),
            }
        rest = [known[a] for a in ARGUMENTS[name][1:]]
        function = getattr(functions, name)
        plain = scalar(function)
        return (lambda x: function(x, *rest)), (lambda x: plain(x, *rest))

    def _first_zero(self) -> tuple[float, bool]:
        """The first x > 0 with E = 0.

        With constant friction E rises at most once and falls at most once before it (E'' < 0 wherever E' = 0), so
        any point with E > 0 and the end of the path bracket it. Softening may bring E near zero more than once, so
        there the path is searched.
        """
        E, far = self._scalar, self.furthest
        if self.steady:
            # Near the end of the parabola 2 drive x - tilt x**2 + start; a bracket within a factor keeps tiny ends exact.
            tilt = max(self.tilt, 1e-300)
            guess = self.drive / tilt + math.sqrt((self.drive / tilt) ** 2 + self.start.energy / tilt)
            if self.drive < 0.0:
                guess = max(guess, self.start.energy / (-2 * self.drive) / 4)
            low = high = min(max(guess / 2, 1e-300), far)
            at_low = at_high = E(low)
            while at_high > 0.0 and high < far:
                low, at_low, high = high, at_high, min(2 * high, far)
                at_high = E(high)
            while at_low <= 0.0:
                high, at_high, low = low, at_low, low / 2
                at_low = E(low)
            return (far, False) if at_high > 0.0 else (root(E, low, high, at_low, at_high), True)
        grid = np.concatenate([np.geomspace(min(1e-20, far * 1e-6), far * 0.01, 200), np.linspace(far * 0.01, far, 300)[1:]])
        values = self.energy(grid)
        below = np.flatnonzero(values <= 0.0)
        inner = values[1:-1]
        dips = np.flatnonzero((inner < values[:-2]) & (inner <= values[2:])) + 1
        for k in dips:  # between the samples E may fall below zero and rise again
            if len(below) and k > below[0]:
                break
            rate = lambda x: float(self.slope(x, E(x)))  # noqa: E731
            left, right = float(grid[k - 1]), float(grid[k + 1])
            if rate(left) < 0.0 < rate(right):
                lowest = root(rate, left, right, rate(left), rate(right))
                if E(lowest) <= 0.0:
                    return root(E, left, lowest, E(left), E(lowest)), True
        if not len(below):
            return far, False
        k = int(below[0])
        left = float(grid[k - 1]) if k else 0.0
        return root(E, left, float(grid[k]), E(left) if k else 1.0, float(values[k])), True

    def _peak(self) -> float:
        """Where E is greatest on [0, end]."""
        rate = lambda x: float(self.slope(x, self._scalar(x)))  # noqa: E731
        if self.steady:
            if self.drive <= self.brake * self.start.energy:
                return 0.0
            at_end = rate(self.end)
            return self.end if at_end >= 0.0 else root(rate, 0.0, self.end, self.drive, at_end)
        grid = self.end * np.sin(np.linspace(0.0, np.pi / 2, 400)) ** 2
        values = self.energy(grid)
        k = int(np.argmax(values))
        if k in (0, len(grid) - 1):
            return float(grid[k])
        left, right = float(grid[k - 1]), float(grid[k + 1])
        at_left, at_right = rate(left), rate(right)
        return root(rate, left, right, at_left, at_right) if at_left > 0.0 > at_right else float(grid[k])

    # -- E by collocation, panel by panel

    def _collocate(self, longest: float) -> tuple[Callable[[Any], Any], float, bool]:
        """E on panels, until it is zero, or the path ends, or more than the longest time has passed."""
        scale = min(self.law.scale / self.radius, 1.0, self.furthest)
        if self.drive > 0.0:
            scale = min(scale, self.drive)
        kinks = sorted((k - self.start.slip) / self.radius for k in self.law.kinks if k > self.start.slip)
        left, width, value, least = 0.0, scale / 16, self.start.energy, 0.0
        edges, values, means = [0.0], [value], []
        while True:
            right = min([left + width, self.furthest, *(k for k in kinks if k > left)])
            half = right - left
            drive, brake = 2 * self.driving(left + half * _Z), 2 * self.braking(left + half * _Z)
            # E = value + (x - left) mean(E') and E' = drive - brake E, at the nodes: a linear system for E'.
            matrix = brake[:, None] * (half * _Z[:, None] * _MEAN)
            matrix[np.diag_indices(NODES)] += 1.0
            rate = np.linalg.solve(matrix, drive - brake * value)
            mean = _BACK @ (_MEAN @ rate)
            tail = np.abs((_BACK @ rate)[-2:]).sum()
            if tail > 4e-15 * np.abs(rate).max() and half > 1e-13 * right:
                width = half / 2
                continue
            self.unresolved = max(self.unresolved, tail / max(np.abs(rate).max(), 1e-300))
            following = value + half * float(_MEAN_TO_END @ rate)
            edges.append(right)
            values.append(following)
            means.append(mean)
            energy = value + half * _Z * (_MEAN @ rate)
            ended = energy.min() <= 0.0 or following <= 0.0
            least += half / math.sqrt(max(float(energy.max()), value, following, 1e-300))
            if not (ended or right >= self.furthest or least > longest or right > 1e7):
                left, value, width = right, following, 2 * half
                continue
            found = _energy(np.array(edges), np.array(values), np.array(means).T)
            if not ended:
                return found, right, False
            inside = lambda z: float(found(np.array([z]))[0])  # noqa: E731
            grid = np.append((left + half * _Z)[::-1], right)
            below = int(np.argmax(np.append(energy[::-1], following) <= 0.0))
            low, high = (float(grid[below - 1]) if below else left), float(grid[below])
            return found, root(inside, low, high, max(inside(low), 1e-300), min(inside(high), -1e-300)), True

    # -- time

    def _place(self, s: Any) -> tuple[Any, Any]:
        """x and the distance to the end, for a variable s in which the time is smooth: square roots at both ends."""
        if self.stops:
            return self.end * np.sin(s) ** 2, self.end * np.cos(s) ** 2
        return self.end * s**2, self.end * (1.0 - s**2)

    def speed_squared(self, s: Any) -> Any:
        """E, relatively accurate also next to the standstill, where it is integrated from the end."""
        x, left = self._place(np.asarray(s, dtype=np.float64))
        found = np.asarray(self.energy(x))
        if self.stops:
            near = left < 0.05 * self.end
            if np.any(near):
                y = left[near][:, None] * _GAUSS[0]
                back = self.end - y
                rate = self.slope(back, np.maximum(self.energy(back), 0.0))
                found = found.copy()
                found[near] = -(rate @ _GAUSS[1]) * left[near]
        return np.maximum(found, 0.0)

    @cached_property
    def pace(self) -> Piecewise:
        """dt/ds."""
        last = np.pi / 2 if self.stops else 1.0
        inner = [k for k in ((q - self.start.slip) / self.radius for q in self.law.kinks) if 0.0 < k < self.end]
        places = [math.asin(math.sqrt(k / self.end)) if self.stops else math.sqrt(k / self.end) for k in inner]
        scale = self.law.scale / self.radius / self.end
        first = [math.sqrt(scale) * 2.0**k for k in range(0, 60, 2) if scale < 0.01 and math.sqrt(scale) * 2.0**k < last / 2]

        def rate(s: Floats) -> Floats:
            stretch = np.sin(s) * np.cos(s) if self.stops else s
            return np.asarray(2 * self.end * stretch / np.sqrt(self.speed_squared(s)))

        return resolve(rate, np.array(sorted({0.0, *places, *first, last})), 4e-15)

    @cached_property
    def clock(self) -> Piecewise:
        """t(s)."""
        return self.pace.integral()

    @property
    def duration(self) -> float:
        """Time from the start of the phase to its end."""
        return self.clock.end

    def peak_time(self) -> float:
        """When the speed is greatest, since the start of the phase."""
        return self.time_to(self.peak)

    @property
    def uncertainty(self) -> float:
        """Estimated relative error of the run-out, the peak velocity and the duration.

        Rounding of E's terms, as large as their sum without signs, moves its zero and its peak; what the series leave
        out is added. A start near the limit makes the drive a small difference, which this shows.
        """
        at, x = self.at, self.end
        normal = abs(self.balance.get("normal", **at))
        terms = abs(at["fall"]) + abs(self.constant) + self.mu * normal
        sizes = 2 * terms * x + self.tilt * x * min(x, 1.0) + self.start.energy
        noise = ROUNDING * EPS * sizes
        slope = abs(float(self.slope(x, 0.0))) if self.stops else math.inf
        top = self._scalar(self.peak) or math.inf
        at_peak = ROUNDING * EPS * (2 * terms * self.peak + self.tilt * self.peak**2 + self.start.energy)
        return max(noise / (slope * x), at_peak / top / 2, ROUNDING * EPS) + self.clock.tail / self.duration + self.unresolved

    def time_to(self, x: float) -> float:
        """Time from the start of the phase to x."""
        share = math.sqrt(min(max(x / self.end, 0.0), 1.0))
        return max(float(self.clock(np.array([math.asin(share) if self.stops else share]))[0]), 0.0)

    def _loss(self, s: Floats) -> Floats:
        x = self._place(s)[0]
        stretch = self.end * (np.sin(2 * s) if self.stops else 2 * s)
        return np.asarray(self.resistance(x, self.speed_squared(s)) * stretch)

    @cached_property
    def _losses(self) -> Piecewise:
        return resolve(self._loss, self.clock.edges, 4e-15).integral()

    def dissipated(self, t: Floats) -> Floats:
        """Energy over Theta* that the resistance has taken since the start, by quadrature of its own."""
        return accumulate(self._loss, self._losses, self.clock.inverse(t, self.pace))

    def when(self, t: Floats) -> tuple[Floats, Floats, Floats]:
        """x, omega and d(omega)/dt at times since the start of the phase."""
        s = self.clock.inverse(t, self.pace)
        x = self._place(s)[0]
        energy = self.speed_squared(s)
        return x, np.sqrt(energy), self.slope(x, energy) / 2
