"""Frozen geometry and constant friction under shaking: exact steps from one kink of the record to the next.

Between kinks d(omega)/dt = a(t) - e omega - b omega**2, where a is linear in time (a polynomial for a pulse of sines).
Segments are cut where a, or what presses on the slip surface, passes zero: then a mass at rest starts at the start of a
segment and nowhere else, and a sliding mass can stop only where a is negative, where its numerator (`riccati`) falls
steadily. Without brakes omega is a quadratic and phi a cubic: this is Newmark's sliding block (1965).
"""

import math
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.balance import Balance
from slipcircle.motion import Start
from slipcircle.riccati import REACH, Step, advance, step
from slipcircle.roots import root
from slipcircle.segments import EPS, Segments, Shape, combine, cut, divide, horner, merge, shifted
from slipcircle.series import Shaking

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]
PRESSING, LIFTED, EITHER = 0, 1, 2  # on a segment: friction acts, nothing presses, or the speed decides
_MOST_STEPS = 50_000  # more than there are segments
_CHUNK = 1 << 16
_ROUNDING = 4.0  # units in which a term of the drive is uncertain


class Row(NamedTuple):
    """A part of a segment that is not taken as a whole: where it starts and how long it is, what happens on it."""

    segment: int
    offset: float
    length: float
    omega: float
    side: int
    lifted: bool


class Table(NamedTuple):
    """For each segment the push, whether a mass at rest starts, the speed up to which one stops, and the step.

    Lean and swing (`riccati`) are times b h.
    """

    a: list[list[float]]
    starts: list[bool]
    low: list[float]
    thrust: list[float]
    lean: list[float]
    swing: list[float]
    change: list[float]


class Rows(NamedTuple):
    """All parts in their order: segments as a whole and parts of them."""

    start: Floats
    length: Floats
    omega: Floats
    side: Floats
    lifted: NDArray[np.bool_]
    brake: Floats
    a: Floats
    segment: Integers
    offset: Floats


class Stepped:
    """The motion under shaking from the start to its end: sliding episodes, and rests in between.

    Seen in the ``direction`` in which gravity pulls. From rest the mass slides in that direction only, unless
    ``two_way``. All is dimensionless, as in `slipcircle.frozen`.

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
        self.balance, self.mu, self.longest, self.viscosity = balance, mu, longest, viscosity
        self.direction = -1 if balance.fall < 0.0 else 1
        self.two_way = two_way
        self.at = balance.position(0.0, self.direction)
        self.drag = float(balance.get("brake", mu=0.0))
        self.polar = balance.values["polar"] if float(balance.get("brake", mu=1.0)) > self.drag else 0.0
        self.braked = bool(self.polar * mu + self.drag or viscosity)
        self.normal = float(balance.get("normal", **self.at))
        self.cohesion = float(balance.get("constant", mu=0.0))
        self.start = Start(0.0, self.direction, omega_0 * omega_0, 0.0, self.normal + self.polar * omega_0**2 < 0.0)
        self._first = (abs(omega_0), int(np.sign(omega_0)) * self.direction)
        self._sides = (1, -1) if two_way or self._first[1] < 0 else (1,)
        self.segments = self._segments(shaking, scale)
        self.regime = self._regimes()
        self.rows = self._rows(*self._walk())
        self.rotation = self._rotation()
        moving = np.flatnonzero(self.rows.side)
        self.moves = bool(moving.size)
        self.stops = self.side == 0 and not self._slides_alone()
        last = int(moving[-1]) if moving.size and self.stops else len(self.rows.start) - 1
        self.duration = float(self.rows.start[last] + self.rows.length[last]) if self.moves or not self.stops else 0.0
        self.end = float(self.rotation[last + 1])

    # -- segments

    def _push(self, side: int, shapes: list[Shape], lifted: bool) -> Shape:
        """The drive less the resistance at rest in a direction, made of k_h less k_y, so that both decide alike."""
        at = self.balance.position(0.0, side * self.direction)
        mu = 0.0 if lifted else self.mu
        still = at["fall"] - self.cohesion if lifted else self.balance.drive(at, mu)
        tilt = at["fall_slope"] - mu * at["press_slope"]
        weights = [tilt * (side * self.direction), -(at["fall"] - mu * at["press"])][: len(shapes)]
        if tilt <= 0.0:
            return combine(still, weights, shapes)
        k_y = -still / tilt * (side * self.direction)
        excess = combine(-k_y, [1.0], shapes[:1])
        return combine(0.0, weights, [excess, *shapes[1:]])

    def _segments(self, shaking: Shaking, scale: float) -> Segments:
        last = min(shaking.end, self.longest * scale)
        start, length, shapes = merge([p.pieces for p in shaking.parts], last, scale)
        turn, lift = self.direction * self.at["fall_slope"], self.direction * self.at["press_slope"]
        made = {
            "fall": combine(self.at["fall"], [turn, -self.at["fall"]][: len(shapes)], shapes),
            "normal": combine(self.normal, [lift, -self.at["press"]][: len(shapes)], shapes),
        }
        for side in self._sides:
            made[f"pressing {side}"] = self._push(side, shapes, lifted=False)
            made[f"lifted {side}"] = self._push(side, shapes, lifted=True)
        segments = Segments(start, length, made)
        if self.braked:
            segments = divide(segments, self._parts(segments, max(float(s.largest().max()) for s in shapes)))
        normal = made["normal"]
        if len(normal.coefficients) > 2 or min(normal.coefficients[0].min(), normal.ends.min()) < 0.0:
            segments = cut(segments, "normal")
        pressing = segments.shapes["normal"].middle(segments.length) >= 0.0
        for side in self._sides:
            one, other = segments.shapes[f"pressing {side}"], segments.shapes.pop(f"lifted {side}")
            push = Shape(
                np.where(pressing, one.coefficients, other.coefficients), np.where(pressing, one.ends, other.ends)
            )
            segments.shapes[f"push {side}"] = push
            segments = cut(segments, f"push {side}")
            pressing = segments.shapes["normal"].middle(segments.length) >= 0.0
        return segments

    def _parts(self, segments: Segments, peak: float) -> Integers:
        """Into how many steps each segment must be divided."""
        largest = np.max([s.largest() for n, s in segments.shapes.items() if n not in ("fall", "normal")], axis=0)
        stiff = np.sqrt((self.polar * self.mu + self.drag) * largest / REACH) * segments.length
        parts = np.ceil(np.maximum(np.maximum(stiff, self.viscosity * segments.length / REACH), 1.0))
        if not parts.sum() < len(parts) + _MOST_STEPS:
            raise ValueError(
                f"shaking: with a peak of {peak:.4g} g the brakes of this scene take {float(parts.sum()):.3g} steps, "
                f"more than {_MOST_STEPS} beyond the samples; give a weaker or shorter one"
            )
        return parts.astype(np.intp)

    def _regimes(self) -> NDArray[np.int8]:
        negative = self.segments.shapes["normal"].middle(self.segments.length) < 0.0
        return np.where(negative, EITHER if self.polar > 0.0 and self.mu > 0.0 else LIFTED, PRESSING).astype(np.int8)

    def _brakes(self, lifted: Any) -> Any:
        return np.where(lifted, self.drag, self.polar * self.mu + self.drag)

    def _slides_alone(self) -> bool:
        """Whether, without shaking, a mass at rest moves."""
        mu = self.mu if self.normal > 0.0 else 0.0
        sides = (1, -1)
        return any(self.balance.drive(self.balance.position(0.0, s), mu) > 0.0 for s in sides)

    # -- along the segments

    def _table(self, side: int) -> "Table":
        shape, h = self.segments.shapes[f"push {side}"], self.segments.length
        starts = shape.middle(h) > 0.0
        brake = self._brakes(self.regime == LIFTED)
        if not self.braked:
            thrust, _ = advance(list(shape.coefficients), 0.0, 0.0, 0.0, h, False)
            made, low = Step(thrust, None, None, None), -thrust
        else:
            parts = []
            for k in range(0, len(h), _CHUNK):
                here = slice(k, k + _CHUNK)
                parts.append(step(list(shape.coefficients[:, here]), brake[here], self.viscosity, h[here]))
            made, bh = Step(*(np.concatenate(x) for x in zip(*parts, strict=True))), brake * h
            made = made._replace(lean=bh * made.lean, swing=bh * made.swing)
            low = -made.thrust / (1.0 + made.lean + made.change)
        low = np.where(starts, -1.0, low)
        low[self.regime == EITHER] = np.inf
        lists = ([] if x is None else x.tolist() for x in (low, *made))
        return Table(shape.coefficients.tolist(), starts.tolist(), *lists)

    def _walk(self) -> tuple[list[tuple[int, int, int]], list[float], list[Row]]:
        """Runs of whole segments (from, to, side), the speeds at their starts, and the parts of segments between."""
        count = len(self.segments.length)
        self.tables = tables = {s: self._table(s) for s in self._sides}
        ways = [s for s in self._sides if s == 1 or self.two_way]
        following = [_next(tables[s].starts) for s in ways]
        either = np.flatnonzero(self.regime == EITHER).tolist()
        unsure, lifted = set(either), (self.regime == LIFTED).tolist()
        (omega, side), k = self._first, 0
        runs: list[tuple[int, int, int]] = []
        speeds: list[float] = []
        rows: list[Row] = []
        while k < count:
            if side == 0:
                k = min(f[k] for f in following)
                if k == count:
                    break
                side, omega = (1 if tables[1].starts[k] else -1), 0.0
            first = k
            k, omega = _run(k, omega, tables[side], speeds)
            if k > first:
                runs.append((first, k, side))
            if k < count:
                found = self._irregular(k, omega, side) if k in unsure else self._stop(k, omega, side, lifted[k])
                rows += found
                last = found[-1]
                side, omega = last.side, 0.0
                if side:
                    omega = self._advance(last, self._push_on(last), last.length)
                k += 1
        self.side, self.speed = side, max(omega, 0.0) if side else 0.0
        return runs, speeds, rows

    def _push_on(self, row: Row) -> list[float]:
        """The coefficients of the push on a part of a segment."""
        found = [c[row.segment] for c in self.tables[row.side or 1].a]
        if not row.lifted and self.regime[row.segment] == EITHER:
            normal = self.segments.shapes["normal"].coefficients[:, row.segment].tolist()
            found = [a - self.mu * n for a, n in zip(found, normal, strict=True)]
        if row.offset and len(found) == 2:
            return [found[0] + row.offset * found[1], found[1]]
        if row.offset:
            found = shifted(np.array(found)[:, None], np.array([row.offset]))[:, 0].tolist()
        return found

    def _advance(self, row: Row, a: list[float], t: float) -> float:
        """The speed on a part of a segment."""
        brake = self.drag if row.lifted else self.polar * self.mu + self.drag
        return float(advance(a, brake, self.viscosity, row.omega, t, self.braked)[0])

    def _starts(self, k: int, side: int) -> bool:
        """Whether a mass at rest on this segment starts in this direction."""
        return (side == 1 or self.two_way) and self.tables[side].starts[k]

    def _stop(self, k: int, omega: float, side: int, lifted: bool) -> list[Row]:
        """A segment on which the mass stops, and perhaps turns back."""
        length = float(self.segments.length[k])
        row = Row(k, 0.0, length, max(omega, 0.0), side, lifted)
        t = self._standstill(row)
        back = -side if self._starts(k, -side) else 0
        return [row._replace(length=t), Row(k, t, length - t, 0.0, back, lifted)]

    def _standstill(self, row: Row) -> float:
        """The time at which the mass stands still, where its speed falls steadily to zero."""
        a, omega, h = self._push_on(row), row.omega, row.length
        if omega == 0.0:
            return 0.0
        bend = a[1] if len(a) > 1 else 0.0
        t = min(2 * omega / (-a[0] + math.sqrt(max(a[0] * a[0] - 2 * bend * omega, 0.0)) or 1e-300), h)
        if len(a) <= 2 and not self.braked:
            return t
        brake = self.drag if row.lifted else self.polar * self.mu + self.drag
        low, high = 0.0, h
        for _ in range(6):  # Newton from the quadratic's root, inside the bracket
            value = self._advance(row, a, t)
            low, high = (t, high) if value > 0.0 else (low, t)
            rate = horner(a, t) - value * (self.viscosity + brake * value)
            following = t - value / rate if rate < 0.0 else math.inf
            if abs(following - t) <= 2 * EPS * t:
                return min(max(following, low), high)
            if not low < following < high:
                break
            t = following
        at_low, at_high = self._advance(row, a, low), self._advance(row, a, high)
        if not at_low > 0.0 > at_high:
            return low if at_low <= 0.0 else high
        return root(lambda t: self._advance(row, a, t), low, high, at_low, at_high)

    def _irregular(self, k: int, omega: float, side: int) -> list[Row]:
        """A segment on which the speed decides whether the mass presses: part after part."""
        length, found = float(self.segments.length[k]), list[Row]()
        normal = self.segments.shapes["normal"].coefficients[:, k].tolist()
        t, omega = 0.0, max(omega, 0.0)
        lifted = normal[0] + self.polar * omega * omega < 0.0
        while length - t > 0.0:
            if omega == 0.0:
                side = next((s for s in (side, -side) if s and self._starts(k, s)), 0)
                lifted = True
            row = Row(k, t, length - t, omega, side, lifted)
            end, lifted, omega = (length, True, 0.0) if side == 0 else self._change(row, normal)
            found.append(row._replace(length=end - t))
            t = end
        return found

    def _change(self, row: Row, normal: list[float]) -> tuple[float, bool, float]:
        """When the mass stops, lifts off or lands on a part of a segment, and whether it is lifted then; its speed."""
        a = self._push_on(row)

        def speed(t: float) -> float:
            return self._advance(row, a, t)

        def over(t: float) -> float:
            value = float(horner(normal, row.offset + t)) + self.polar * speed(t) ** 2
            return value if row.lifted else -value

        grid = row.length * np.sin(np.linspace(0.0, np.pi / 2, 33)[1:]) ** 2
        brake = self.drag if row.lifted else self.polar * self.mu + self.drag
        speeds, _ = advance(a, brake, self.viscosity, row.omega, grid, self.braked)
        sign = 1.0 if row.lifted else -1.0
        overs = sign * (horner(normal, row.offset + grid) + self.polar * speeds**2)
        before = (0.0, row.omega, min(over(0.0), 0.0))
        for j, now in enumerate(zip(grid.tolist(), speeds.tolist(), overs.tolist(), strict=True)):
            t = now[0]
            if now[1] <= 0.0:
                stop = root(speed, before[0], t, before[1], now[1]) if before[1] > 0.0 > now[1] else t
                return row.offset + stop, True, 0.0
            if now[2] > 0.0 and before[2] < 0.0:
                change = root(over, before[0], t, before[2], now[2])
                if change > 1e-14 * row.length:
                    return row.offset + change, not row.lifted, speed(change)
            elif now[2] > 0.0 and j:
                return row.offset + before[0], not row.lifted, before[1]
            before = now
        return row.offset + row.length, row.lifted, before[1]

    # -- the parts in their order

    def _rows(self, runs: list[tuple[int, int, int]], speeds: list[float], rows: list[Row]) -> Rows:
        count = len(self.segments.length)
        mark = np.zeros(count + 1)
        for first, last, way in runs:
            mark[first] += way
            mark[last] -= way
        side = np.round(np.cumsum(mark)[:count])
        omega = np.zeros(count)
        omega[side != 0.0] = speeds
        whole = np.ones(count, dtype=bool)
        whole[[r.segment for r in rows]] = False
        index = np.flatnonzero(whole)
        columns = list(zip(*rows, strict=True)) if rows else [()] * len(Row._fields)
        segment = np.concatenate([index, np.array(columns[0], dtype=np.intp)])
        offset = np.concatenate([np.zeros(len(index)), np.array(columns[1], dtype=float)])
        order = np.lexsort((offset, segment))
        segment, offset = segment[order], offset[order]

        def joined(of: Any, column: int, kind: Any) -> Any:
            return np.concatenate([of[index], np.array(columns[column], dtype=kind)])[order]

        length, omega = joined(self.segments.length, 2, float), joined(omega, 3, float)
        side, lifted = joined(side, 4, float), joined(self.regime != PRESSING, 5, bool)
        a = self.segments.shapes["push 1"].coefficients[:, segment]
        if np.any(back := side < 0.0):
            a[:, back] = self.segments.shapes["push -1"].coefficients[:, segment[back]]
        if np.any(odd := (self.regime[segment] == EITHER) & ~lifted):
            a[:, odd] -= self.mu * self.segments.shapes["normal"].coefficients[:, segment[odd]]
        if np.any(inner := offset > 0.0):
            a[:, inner] = shifted(a[:, inner], offset[inner])
        start = self.segments.start[segment] + offset
        return Rows(start, length, omega, side, lifted, self._brakes(lifted), a, segment, offset)

    def _rotation(self) -> Floats:
        """The rotation at the start of each part, and at the end: sums of blocks, so that rounding does not add up."""
        turn = np.zeros(len(self.rows.start))
        for here in self._chunks(np.flatnonzero(self.rows.side)):
            turn[here] = self.rows.side[here] * self._followed(here, self.rows.length[here])[1]
        return _summed(turn)

    @staticmethod
    def _chunks(index: Integers) -> list[Integers]:
        return [index[k : k + _CHUNK] for k in range(0, len(index), _CHUNK)]

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

    def _on_segments(self, name: str, row: Integers, since: Any) -> Floats:
        """A function of time, on parts of segments."""
        coefficients = self.segments.shapes[name].coefficients[:, self.rows.segment[row]]
        return np.asarray(horner(list(coefficients), self.rows.offset[row] + since))

    def pressing_at(self, t: Floats) -> Floats:
        """The effective mean normal stress over sigma_ref, shaking included; negative where the mass is lifted."""
        row, since = self._located(np.asarray(t, dtype=np.float64))
        omega, _ = self._followed(row, since)
        omega = np.where(self.rows.side[row] != 0.0, omega, 0.0)
        level = self.balance.values["level"]
        return np.asarray((self._on_segments("normal", row, since) + self.polar * omega**2) / level)

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
            if float(np.maximum(r.a[0, episode], horner(list(r.a[:, episode]), r.length[episode])).max()) <= noise:
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


def _next(starts: list[bool]) -> list[int]:
    """For each segment the first one from there on on which the mass starts; their number if there is none."""
    count = len(starts)
    index = np.where(np.array(starts, dtype=bool), np.arange(count), count)
    found: list[int] = np.append(np.minimum.accumulate(index[::-1])[::-1], count).tolist()
    return found


def _run(first: int, omega: float, table: Table, speeds: list[float]) -> tuple[int, float]:
    """Whole segments from the first until the mass stops on one: that one, and the speed there, by compensated sums."""
    low, thrust, lost = table.low, table.thrust, 0.0
    if not table.lean:
        for k in range(first, len(low)):
            if omega <= low[k]:
                return k, omega
            speeds.append(omega)
            more = thrust[k] - lost
            after = omega + more
            lost = (after - omega) - more
            omega = after
        return len(low), omega
    lean, swing, change = table.lean, table.swing, table.change
    for k in range(first, len(low)):
        if omega <= low[k]:
            return k, omega
        speeds.append(omega)
        drawn = omega * swing[k]
        more = (thrust[k] + omega * (change[k] - drawn)) / (1.0 + lean[k] + drawn) - lost
        after = omega + more
        lost = (after - omega) - more
        omega = after
    return len(low), omega
