"""Frozen geometry and constant friction under shaking: the motion of a walk along the record, read off at any time."""

import math
from functools import cached_property
from typing import Any

import numpy as np

from slipcircle.balance import Balance
from slipcircle.checks import EPS
from slipcircle.inputs.series import Shaking
from slipcircle.methods.riccati import advance
from slipcircle.methods.roots import root
from slipcircle.methods.segments import horner
from slipcircle.methods.walk import CHUNK, Floats, Integers, Walk

_ROUNDING = 4.0  # units in which a term of the drive is uncertain


class Stepped(Walk):
    """The motion under shaking from the start to its end: sliding episodes, and rests in between.

    Seen in the ``direction`` in which gravity pulls. From rest the mass slides in that direction only, unless
    ``two_way``. All is dimensionless, as in `slipcircle.methods.frozen`.

    Attributes
    ----------
    direction : int
        1, or -1 where gravity turns the mass clockwise.
    moves, stops : bool
        Whether it moves at all, and whether it is at rest at the end.
    duration : float
        Time of the last stop, or the end of the shaking if it slides then, or would slide on its own.
    end, speed, side : float, float, int
        Rotation, speed and direction of motion (0 at rest) at that time.
    """

    def __init__(
        self, balance: Balance, mu: float, omega_0: float, longest: float, shaking: Shaking, scale: float,
        two_way: bool = False, viscosity: float = 0.0,
    ) -> None:  # fmt: skip
        super().__init__(balance, mu, omega_0, longest, shaking, scale, two_way, viscosity)
        self.rotation = self._rotation()
        moving = np.flatnonzero(self.rows.side)
        self.moves = bool(moving.size)
        self.stops = self.side == 0 and not self._slides_alone()
        last = int(moving[-1]) if moving.size and self.stops else len(self.rows.start) - 1
        self.duration = float(self.rows.start[last] + self.rows.length[last]) if self.moves or not self.stops else 0.0
        self.end = float(self.rotation[last + 1])

    def _slides_alone(self) -> bool:
        """Whether, without shaking, a mass at rest moves."""
        mu = self.mu if self.normal > 0.0 else 0.0
        sides = (1, -1)
        return any(self.balance.drive(self.balance.position(0.0, s), mu) > 0.0 for s in sides)

    def _rotation(self) -> Floats:
        """The rotation at the start of each part, and at the end: sums of blocks, so that rounding does not add up."""
        turn = np.zeros(len(self.rows.start))
        for here in self._chunks(np.flatnonzero(self.rows.side)):
            turn[here] = self.rows.side[here] * self._followed(here, self.rows.length[here])[1]
        return _summed(turn)

    @staticmethod
    def _chunks(index: Integers) -> list[Integers]:
        return [index[k : k + CHUNK] for k in range(0, len(index), CHUNK)]

    def _followed(self, row: Integers, t: Any) -> tuple[Floats, Floats]:
        """Speed and rotation since the start of each of these parts, in the direction of motion."""
        r = self.rows
        omega, turn = advance(list(r.a[:, row]), r.brake[row], self.viscosity, r.omega[row], t, self.braked)
        return np.maximum(omega, 0.0), turn

    # -- read off

    @property
    def _last(self) -> float:
        return float(self.rows.start[-1] + self.rows.length[-1])

    def _located(self, t: Floats) -> tuple[Integers, Floats]:
        """The part that a time falls into, and the time since its start."""
        row = np.clip(np.searchsorted(self.rows.start, t, side="right") - 1, 0, len(self.rows.start) - 1)
        return row, np.clip(t - self.rows.start[row], 0.0, self.rows.length[row])

    def when(self, t: Floats) -> tuple[Floats, Floats, Floats]:
        """Rotation, omega and d(omega)/dt at times since the start; negative omega is up-slope."""
        shape, t = np.shape(t), np.atleast_1d(np.asarray(t, dtype=np.float64)).ravel()
        row, since = self._located(t)
        side, brake = self.rows.side[row], self.rows.brake[row]
        omega, turn = self._followed(row, since)
        rate = horner(list(self.rows.a[:, row]), since) - omega * (self.viscosity + brake * omega)
        moving = side != 0.0
        x = self.rotation[row] + side * np.where(moving, turn, 0.0)
        found = x, side * omega, side * rate
        return tuple(f.reshape(shape) for f in found)  # type: ignore[return-value]

    def state(self, t: float) -> tuple[float, float, float]:
        """Rotation, omega and d(omega)/dt at one time."""
        x, omega, rate = self.when(np.array([t]))
        return float(x[0]), float(omega[0]), float(rate[0])

    def fastest(self) -> tuple[float, float, float, float] | None:
        """Time, rotation, omega and d(omega)/dt at the greatest speed; None if it is at the end, or at rest."""
        moving = np.flatnonzero(self.rows.side)
        if not moving.size:
            return None
        r = self.rows
        best = int(moving[np.argmax(r.omega[moving])])
        time, speed = float(r.start[best]), float(r.omega[best])
        if self.braked:  # brakes: between kinks, where the drive has fallen to what they take
            brake, h = r.brake[moving], r.length[moving]
            first = r.a[0, moving] - r.omega[moving] * (self.viscosity + brake * r.omega[moving])
            for k in moving[(first > 0.0) & (r.omega[moving] + first * h > speed)].tolist():
                summit = self._summit(k)
                if summit is not None and summit[1] > speed:
                    time, speed = float(r.start[k]) + summit[0], summit[1]
        if self.speed >= speed:
            return None
        return time, *self.state(time)

    def _summit(self, k: int) -> tuple[float, float] | None:
        """The time in a part at which its speed is greatest, and the speed."""
        a, brake, h, omega = self.rows.a[:, k].tolist(), float(self.rows.brake[k]), float(self.rows.length[k]), 0.0

        def rate(t: float) -> float:
            nonlocal omega
            omega = float(advance(a, brake, self.viscosity, float(self.rows.omega[k]), t, self.braked)[0])
            return float(horner(a, t)) - omega * (self.viscosity + brake * omega)

        at_start, at_end = rate(0.0), rate(h)
        if not at_start > 0.0 > at_end:
            return None
        t = root(rate, 0.0, h, at_start, at_end)
        rate(t)
        return t, omega

    @cached_property
    def episodes(self) -> Floats:
        """Start and end of each stretch of motion in one direction, and the rotation over it."""
        side = self.rows.side
        change = np.flatnonzero(np.diff(side, prepend=0.0, append=0.0) != 0.0)
        edges = np.append(self.rows.start, self._last)[change]
        kept = side[change[:-1]] != 0.0
        turned = np.diff(self.rotation[change])
        return np.column_stack([edges[:-1][kept], edges[1:][kept], turned[kept]])

    @property
    def lifts(self) -> Floats:
        """Times from which nothing presses on the slip surface."""
        lifted = self.rows.lifted
        return self.rows.start[lifted & ~np.append(False, lifted[:-1])]

    def excess_when(self, t: Floats) -> Floats:
        """Excess pore pressure over sigma_ref, of heat: none."""
        return np.zeros_like(t)

    def _on_segments(self, name: str, row: Integers, since: Any) -> Floats:
        """A function of time, on parts of segments."""
        coefficients = self.segments.shapes[name].coefficients[:, self.rows.segment[row]]
        return np.asarray(horner(list(coefficients), self.rows.offset[row] + since))

    # -- energy

    def _powers(self, row: Integers, since: Floats) -> tuple[Floats, Floats]:
        """What gravity and shaking do, and what the resistance takes, per time."""
        omega, _ = self._followed(row, since)
        normal = self._on_segments("normal", row, since) + self.polar * omega**2
        friction = np.where(self.rows.lifted[row], 0.0, self.mu * normal)
        lost = (self.cohesion + friction + omega * (self.viscosity + self.drag * omega)) * omega
        return self._on_segments("fall", row, since) * self.rows.side[row] * omega, lost

    def _gauss(self, row: Integers, t: Floats) -> Floats:
        """Work and loss on the first t of these parts, by Gauss points: exact without brakes."""
        nodes, weights = np.polynomial.legendre.leggauss(self._points)
        total = np.zeros((2, len(row)))
        for node, weight in zip(nodes.tolist(), weights.tolist(), strict=True):
            total += weight / 2 * t * np.array(self._powers(row, t * (node + 1) / 2))
        return total

    @cached_property
    def _points(self) -> int:
        """Gauss points a part: as many as a polynomial needs; with brakes omega has a pole 1/(b omega) before it."""
        size, r = len(self.rows.a), self.rows
        if not self.braked:
            return size
        fall = float(np.max(r.brake * r.omega * r.length))
        wide = 1.0 + 2.0 / max(fall, 1e-3)
        return min(size + 6 + math.ceil(9.0 / math.log10(wide + math.sqrt(wide * wide - 1.0))), 64)

    @cached_property
    def _work(self) -> tuple[Floats, Floats]:
        """Work and loss up to the start of each part, and to the end."""
        found = np.zeros((2, len(self.rows.start)))
        for here in self._chunks(np.flatnonzero(self.rows.side)):
            found[:, here] = self._gauss(here, self.rows.length[here])
        return _summed(found[0]), _summed(found[1])

    def _energy(self, t: Floats, which: int) -> Floats:
        row, since = self._located(np.asarray(t, dtype=np.float64))
        part = np.where(
            self.rows.side[row] != 0.0, self._gauss(row.ravel(), since.ravel())[which].reshape(row.shape), 0.0
        )
        return np.asarray(self._work[which][row] + part)

    def worked(self, t: Floats) -> Floats:
        """Work of gravity and shaking over Theta* since the start, at times."""
        return self._energy(t, 0)

    def dissipated(self, t: Floats) -> Floats:
        """Energy over Theta* that the resistance has taken since the start, at times."""
        return self._energy(t, 1)

    # -- errors

    @cached_property
    def noise(self) -> float:
        """What the drive at rest is uncertain by."""
        at = self.at
        terms = abs(at["fall"]) + self.cohesion + self.mu * abs(self.normal)
        return _ROUNDING * EPS * terms

    def errors(self) -> tuple[float, float, float]:
        """Bounds of the rounding in rotation, speed and time of the last stop, absolute."""
        r = self.rows
        moving = r.side != 0.0
        rates = np.abs(r.a[0]) + np.abs(horner(list(r.a), r.length))
        drive = np.where(moving, self.noise + _ROUNDING * EPS * rates, 0.0)
        gained = np.append(0.0, np.cumsum(drive * r.length))
        turns = r.side != np.append(0.0, r.side[:-1])
        first = np.maximum.accumulate(np.where(turns, np.arange(len(moving)), 0))
        shift = EPS * self._last * float(rates[moving].max(initial=0.0))  # a time, rounded
        speed = np.where(moving, gained[1:] - gained[first], 0.0)
        top = float(np.maximum(r.omega, 0.0).max(initial=0.0))
        turned = float(np.sum(speed * r.length)) + _ROUNDING * EPS * abs(self.end) + EPS * self._last * top
        time = EPS * self._last
        if self.stops and self.moves:
            last = int(np.flatnonzero(moving)[-1])
            late = float(speed[last]) + _ROUNDING * EPS * top
            brake = abs(float(horner(list(r.a[:, last]), r.length[last])))
            bend = abs(float(r.a[1, last])) if len(r.a) > 1 else 0.0
            at_most = math.sqrt(2 * late / bend) if bend else math.inf
            time += min(late / brake if brake else math.inf, at_most, float(r.length[last]))
        return turned, float(speed.max(initial=0.0)) + shift + _ROUNDING * EPS * top, time

    @property
    def undecided(self) -> bool:
        """Whether rounding decides if the mass starts (again) after its last stop, or whether it moved at all."""
        r, noise = self.rows, self.noise
        moving = np.flatnonzero(r.side)
        if not self.stops:
            return False
        if moving.size:
            last = int(moving[-1])
            first = last
            while first > 0 and r.side[first - 1] != 0.0:
                first -= 1
            episode = np.arange(first, last + 1)
            drive = np.maximum(r.a[0, episode], horner(list(r.a[:, episode]), r.length[episode]))
            if r.omega[first] == 0.0 and float(drive.max()) <= noise:  # what was pushed moves in any case
                return True
            after = np.arange(last + 2, len(r.start))
        else:
            after = np.arange(len(r.start))
        for side in self._sides if self.two_way else (1,):
            shape = self.segments.shapes[f"push {side}"].pick(np.unique(r.segment[after]))
            if np.any(np.maximum(shape.coefficients[0], shape.ends) >= -noise):
                return True
        return False


def _summed(values: Floats) -> Floats:
    """Sums up to each value, and of all: block by block, so that rounding grows with the number of blocks only."""
    count = len(values)
    rows = max(1, math.isqrt(count))
    padded = np.zeros(-(-count // rows) * rows)
    padded[:count] = values
    inner = np.cumsum(padded.reshape(-1, rows), axis=1)
    before = np.append(0.0, np.cumsum(inner[:, -1])[:-1])
    return np.append(0.0, (inner + before[:, None]).ravel()[:count])
