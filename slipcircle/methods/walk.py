"""The walk along a record: on which segments a frozen mass slides, where it starts and stops, lifts off and lands.

Between kinks d(omega)/dt = a(t) - e omega - b omega**2, where a is linear in time (a polynomial for a pulse of sines).
Segments are cut where a, or what presses on the slip surface, passes zero: then a mass at rest starts at the start of a
segment and nowhere else, and a sliding mass can stop only where a is negative, where its numerator (`riccati`) falls
steadily. Without brakes omega is a quadratic and phi a cubic: this is Newmark's sliding block (1965).
"""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.balance import Balance
from slipcircle.checks import EPS
from slipcircle.inputs.series import Shaking
from slipcircle.methods.riccati import REACH, Step, advance, step
from slipcircle.methods.roots import root
from slipcircle.methods.segments import Segments, Shape, combine, cut, divide, horner, merge, shifted
from slipcircle.motion import Start

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]
PRESSING, LIFTED, EITHER = 0, 1, 2  # on a segment: friction acts, nothing presses, or the speed decides
CHUNK = 1 << 16  # parts at a time
_MOST_STEPS = 50_000  # more than there are segments


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


class Walk:
    """The walk of a mass, seen in the ``direction`` in which gravity pulls; dimensionless.

    From rest the mass slides in that direction only, unless ``two_way``.

    Attributes
    ----------
    segments : Segments
    regime : ndarray
        What happens on each segment.
    rows : Rows
        What is walked, part by part.
    side, speed : int, float
        Direction of motion and speed at the end.
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

    # -- along the segments

    def _table(self, side: int) -> "Table":
        shape, h = self.segments.shapes[f"push {side}"], self.segments.length
        # Where k_v passes 1, push and pressure vanish together: no mass starts between their two zeros, rounded.
        short = h <= 4 * EPS * self.segments.start
        pressed = np.pad(self.regime == PRESSING, 1, constant_values=True)
        starts = (shape.middle(h) > 0.0) & ~(short & ~(pressed[:-2] & pressed[1:-1] & pressed[2:]))
        brake = self._brakes(self.regime == LIFTED)
        if not self.braked:
            thrust, _ = advance(list(shape.coefficients), 0.0, 0.0, 0.0, h, False)
            made, low = Step(thrust, None, None, None), -thrust
        else:
            parts = []
            for k in range(0, len(h), CHUNK):
                here = slice(k, k + CHUNK)
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
