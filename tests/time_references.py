"""100 random scenes that depend on time or speed, solved to 20 digits: ``python tests/time_references.py`` writes them.

Scenes are plain data. They are solved by Taylor series in time, in ball arithmetic's midpoints, from moments that are
quadratures of their definitions: nothing here knows a line of the package. Each is solved twice, with series of
different length, and both have to agree.
"""

import json
import math
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import oracle
import references
from flint import arb, arb_series, ctx

FILE = Path(__file__).with_name("time_references.json")
SEED = 20240611
SHARES = (0.137, 0.391, 0.618, 0.874)  # of the duration, at which the state is compared
MOST_STEPS, MOST_EPISODES = 4000, 60
number = oracle.exact


Unfit = references.Unfit  # the scene turns over, never ends, or is no scene: it is drawn anew


# --- functions of time -----------------------------------------------------------------------------------------------


class Stretch(NamedTuple):
    """A function of time from one kink to the next: a polynomial in t - start, or an amplitude times a sine of it."""

    start: arb
    coefficients: tuple[arb, ...]
    rate: arb | None = None  # of the sine's argument

    def series(self, t: arb) -> arb_series:
        """Around a time."""
        past = arb_series([t - self.start, 1])
        if self.rate is not None:
            return (past * self.rate).sin() * self.coefficients[0]
        found = arb_series([0])
        for c in reversed(self.coefficients):
            found = found * past + arb_series([c])
        return found

    def at(self, t: arb) -> arb:
        return self.series(t)[0]


class Course(NamedTuple):
    """A function of time: kinks, and a stretch before each and after the last."""

    kinks: tuple[arb, ...]
    stretches: tuple[Stretch, ...]

    def on(self, t: arb) -> Stretch:
        """The stretch that begins at a time or holds there."""
        return self.stretches[sum(bool(k <= t) for k in self.kinks)]


def still(value: Any = 0) -> Stretch:
    return Stretch(arb(0), (arb(value),))


def lines(time: list[float], values: list[Any], outside: str, factor: arb, scale: arb) -> Course:
    """Straight lines between samples, dimensionless; beyond them the end values, or zero."""
    kinks = [(number(t) / scale).mid() for t in time]
    heights = [number(v) * factor for v in values]
    between = [Stretch(a, (u, (v - u) / (b - a))) for (a, b), (u, v) in zip(pairwise(kinks), pairwise(heights),
                                                                            strict=True)]  # fmt: skip
    ends = (still(heights[0]), still(heights[-1])) if outside == "held" else (still(), still())
    return Course(tuple(kinks), (ends[0], *between, ends[1]))


def pulse(given: Mapping[str, Any], amplitude: float, scale: arb) -> Course:
    start, end = ((number(given.get("start", 0.0)) / scale).mid(),
                  ((number(given.get("start", 0.0)) + number(given["duration"])) / scale).mid())  # fmt: skip
    top, length = number(amplitude), end - start
    match given["pulse"]:
        case "rectangular":
            return Course((start, end), (still(), Stretch(start, (top,)), still()))
        case "triangular":
            middle = (start + length / 2).mid()
            up, down = Stretch(start, (arb(0), 2 * top / length)), Stretch(middle, (top, -2 * top / length))
            return Course((start, middle, end), (still(), up, down, still()))
        case "half-sine":
            return Course((start, end), (still(), Stretch(start, (top,), arb.pi() / length), still()))
    rate = 2 * arb.pi() * number(given.get("cycles", 1.0)) / length
    return Course((start, end), (still(), Stretch(start, (top,), rate), still()))


# --- a scene in numbers ----------------------------------------------------------------------------------------------


class Table(NamedTuple):
    """Friction against the logarithm of the speed: cubics between speeds, the end values beyond."""

    speeds: list[arb]
    cubics: list[tuple[arb, ...]]

    def of(self, speed: arb_series, band: int) -> arb_series:
        if band in (0, len(self.speeds)):
            value = self.cubics[0][0] if band == 0 else sum(self.cubics[-1], arb(0))
            return arb_series([value])
        a, b = self.speeds[band - 1 : band + 1]
        z = (speed / a).log() / (b / a).log()
        found = arb_series([0])
        for c in reversed(self.cubics[band - 1]):
            found = found * z + c
        return found


def logarithmic(speed: list[float], values: list[float]) -> Table:
    """Monotone cubics in the logarithm, level at both ends; coefficients in the share of the interval."""
    x, y = [number(v).log() for v in speed], [number(v) for v in values]
    step = [b - a for a, b in pairwise(x)]
    secant = [(b - a) / h for (a, b), h in zip(pairwise(y), step, strict=True)]
    slope = [arb(0)] * len(x)
    for k in range(1, len(x) - 1):
        if secant[k - 1] * secant[k] > 0:
            one, two = 2 * step[k] + step[k - 1], step[k] + 2 * step[k - 1]
            slope[k] = (one + two) / (one / secant[k - 1] + two / secant[k])
    cubics = list[tuple[arb, ...]]()
    for k, h in enumerate(step):
        rise, a, b = y[k + 1] - y[k], h * slope[k], h * slope[k + 1]
        cubics.append((y[k], a, 3 * rise - 2 * a - b, a + b - 2 * rise))
    return Table([number(v) for v in speed], cubics)


class Problem:
    """The equation of motion of a scene, all over Theta*, in the dimensionless time."""

    def __init__(self, scene: Mapping[str, Any]) -> None:
        arc, effects, m = scene["arc"], scene["effects"], self.measured(scene["arc"])
        self.radius, gravity = number(arc["radius"]), number(arc["gravity"])
        self.scale = (self.radius / gravity).sqrt()
        self.dip, self.weight, self.radial, self.level = m["dip"], m["fall"], m["press"], m["level"]
        self.lean, self.cover = m.get("lean", m["dip"]), m.get("cover", arb(1))  # of what presses; of r_u
        self.turns = "rotation" in effects
        self.polar = m["polar"] if "centripetal" in effects else arb(0)
        water = effects.get("pore_pressure", {})
        per = 1 / m["reference_stress"]
        self.ratio = Course((), (still(number(water.get("ratio", 0.0)) if "time" not in water else 0),))
        self.water = Course((), (still(),))
        if "time" not in water:
            self.water = Course((), (still(number(water.get("pressure", 0.0)) * per),))
        elif "pressure" in water:
            self.water = lines(water["time"], water["pressure"], "held", per, self.scale)
        if "time" in water and "ratio" in water:
            self.ratio = lines(water["time"], water["ratio"], "held", arb(1), self.scale)
        self.cohesion = self.level * number(effects.get("cohesion", {}).get("cohesion", 0.0)) * per
        layer = 2 * m["half_angle"] / m["inertia"]
        self.drag = layer * gravity / number(effects["drag"]["xi"]) if "drag" in effects else arb(0)
        self.viscosity = arb(0)
        if "viscosity" in effects:
            v = effects["viscosity"]
            density = number(arc["unit_weight"]) / gravity
            root = (gravity * self.radius).sqrt()
            self.viscosity = layer * number(v["viscosity"]) / (density * number(v["thickness"]) * root)
        shaking = effects.get("shaking")
        quiet = Course((), (still(),))
        self.k_h = self.k_v = quiet
        self.shaken, self.two_way = shaking is not None, bool((shaking or {}).get("two_way", False))
        if shaking and "pulse" in shaking:
            self.k_h = pulse(shaking, shaking["amplitude"], self.scale)
            if shaking.get("vertical_amplitude"):
                self.k_v = pulse(shaking, shaking["vertical_amplitude"], self.scale)
        elif shaking:
            self.k_h = lines(shaking["time"], shaking["horizontal"], "zero", arb(1), self.scale)
            if "vertical" in shaking:
                self.k_v = lines(shaking["time"], shaking["vertical"], "zero", arb(1), self.scale)
        self.kappa = arb(0)
        self.heats = "thermal_pressurisation" in effects
        if self.heats:
            h = effects["thermal_pressurisation"]
            self.kappa = (
                number(h["pressurisation"]) * self.radius / (number(h["heat_capacity"]) * number(h["thickness"]))
            )
        self._friction(scene["friction"])
        self.omega = number(scene["initial_velocity"]) / (gravity * self.radius).sqrt()
        self.end = None if scene["end_time"] is None else (number(scene["end_time"]) / self.scale).mid()

    def measured(self, arc: Mapping[str, Any]) -> dict[str, arb]:
        """What the balance needs of the failed mass."""
        return references.moments(arc)

    borders: Sequence[arb] = ()  # rotations between which `under` is one formula

    def under(self, phi: arb_series, place: int) -> arb_series | int:
        """Mean pressure below a level that stays while the mass turns, over the reference stress."""
        return 0

    def _friction(self, law: Any) -> None:
        self.pieces = references.pieces(1.0, self.radius)
        self.table: Table | None = None
        self.weakening: tuple[arb, arb, arb] | None = None
        self.prescribed: Course | None = None
        rate = law if isinstance(law, Mapping) and law["law"].startswith("rate") else None
        if isinstance(law, Mapping) and "rate" in law:
            rate = law["rate"]
            law = {k: v for k, v in law.items() if k != "rate"}
        if rate is not None:
            unit = self.radius / self.scale
            if rate["law"] == "rate_tabulated":
                self.table = logarithmic(rate["speed"], rate["coefficient"])
                self.table = self.table._replace(speeds=[v / unit for v in self.table.speeds])
            else:
                self.weakening = (number(rate["peak"]), number(rate["residual"]), number(rate["velocity"]) / unit)
        if isinstance(law, Mapping) and law["law"] == "prescribed":
            self.prescribed = lines(law["time"], law["coefficient"], "held", arb(1), self.scale)
        elif rate is not law:
            self.pieces = references.pieces(law, self.radius)

    @property
    def kinks(self) -> list[arb]:
        every = [*self.k_h.kinks, *self.k_v.kinks, *self.water.kinks, *self.ratio.kinks]
        return sorted(every + list(self.prescribed.kinks if self.prescribed else ()), key=float)

    def mu(self, slip: arb_series, speed: arb_series, t: arb, piece: int, band: int) -> arb_series:
        """Friction around a time; slip over R."""
        p = self.pieces[piece]
        past = slip - p.start
        if p.shape == "exponential":
            found = (past * (-1 / p.length)).exp() * p.rise + p.level
        elif p.shape == "hyperbolic":
            found = arb_series([p.rise]) / (past / p.length + 1) + p.level
        else:
            found = arb_series([0])
            for c in reversed(p.cubic):
                found = found * past + c
        if self.prescribed:
            found = found * self.prescribed.on(t).series(t)
        if self.table:
            found = found * self.table.of(speed, band)
        if self.weakening:
            peak, residual, velocity = self.weakening
            found = found * (residual + arb_series([peak - residual]) / (speed / velocity + 1))
        return found

    def moments(self, phi: arb_series, t: arb, side: int, place: int = 0) -> tuple[arb_series, arb_series]:
        """Around a time: what drives in a direction, and what presses, with water."""
        turned = phi if self.turns else arb_series([0])
        angle, lean = self.dip - turned, self.lean - turned
        k_h, k_v = self.k_h.on(t).series(t), self.k_v.on(t).series(t)
        fall = ((1 - k_v) * angle.sin() + k_h * angle.cos()) * self.weight * side
        press = ((1 - k_v) * lean.cos() - k_h * lean.sin()) * self.radial
        pressure = self.water.on(t).series(t) + self.under(turned, place)
        water = lean.cos() * self.radial * self.cover * self.ratio.on(t).series(t) + pressure * self.level
        return fall, press - water


# --- the motion ------------------------------------------------------------------------------------------------------


class Step(NamedTuple):
    """A Taylor series: from a time, over a length, in a direction; x since the start of the episode."""

    start: arb
    length: arb
    side: int
    begin: arb
    series: tuple[arb_series, ...]

    def state(self, t: arb) -> tuple[arb, arb]:
        x, omega = (value(s, t - self.start) for s in self.series[:2])
        return self.begin + self.side * x, self.side * omega


def value(series: arb_series, h: arb) -> arb:
    found = arb(0)
    for k in range(series.length() - 1, -1, -1):
        found = found * h + series[k]
    return found.mid()


def derivative(series: arb_series, h: arb) -> arb:
    found = arb(0)
    for k in range(series.length() - 1, 0, -1):
        found = found * h + k * series[k]
    return found.mid()


class Solution:
    """A scene's motion by series of a given length, each term neglected below a tolerance."""

    def __init__(self, scene: Mapping[str, Any], terms: int, digits: int,
                 problem: Callable[[Mapping[str, Any]], Problem] = Problem) -> None:  # fmt: skip
        self.terms, self.digits = terms, digits
        self.p = problem(scene)
        self.place = sum(bool(b < 0) for b in self.p.borders)
        self.steps: list[Step] = []
        self.lifts: list[arb] = []  # when it lifts off while it moves
        self.carried = False
        self._solve()

    def _solve(self) -> None:
        p = self.p
        time, phi, slip, excess, omega, side = arb(0), arb(0), arb(0), arb(0), abs(p.omega), 1 if p.omega >= 0 else -1
        self.arrested, episodes = False, 0
        while p.end is None or time < p.end:
            if omega == 0:
                found = self._start(time, phi, slip, excess)
                if found is None:
                    self.arrested = True
                    break
                time, side = found
                if p.end is not None and not time < p.end:
                    break
            episodes += 1
            if episodes > MOST_EPISODES:
                raise Unfit
            time, x, omega, excess = self._episode(time, phi, slip, excess, omega, side)
            phi, slip = (phi + side * x).mid(), (slip + x).mid()
        self.duration = time if self.arrested or p.end is None else p.end
        self.run_out = phi

    def _drive(self, time: arb, phi: arb, slip: arb, excess: arb, side: int) -> arb:
        """The drive less the resistance at rest."""
        ctx.cap = 1
        fall, press = self.p.moments(arb_series([phi]), time, side, self.place)
        normal = press[0] - self.p.level * excess
        piece = self._piece(slip)
        mu = self.p.mu(arb_series([slip]), arb_series([0]), time, piece, 0)[0]
        return (fall[0] - self.p.cohesion - (mu * normal if normal > 0 else 0)).mid()

    def _piece(self, slip: arb) -> int:
        return next(k for k, q in enumerate(self.p.pieces) if q.end is None or slip < q.end)

    def _start(self, time: arb, phi: arb, slip: arb, excess: arb) -> tuple[arb, int] | None:
        p = self.p
        sides = (1, -1) if p.two_way or not p.shaken else (1 if (p.dip - phi if p.turns else p.dip) > 0 else -1,)
        kinks = [k for k in p.kinks if k > time]
        bounds = [time, *kinks, (kinks[-1] if kinks else time) + 1]
        for left, right in pairwise(bounds):
            tiny = (right - left) * arb(2) ** -80
            grid = [(left + tiny + (right - left - 2 * tiny) * k / 200).mid() for k in range(201)]
            found = []
            for side in sides:
                before = None
                for t in grid:
                    if self._drive(t, phi, slip, excess, side) > 0:
                        found.append((left if before is None else self._zero(before, t, phi, slip, excess, side), side))
                        break
                    before = t
            if found:
                return min(found, key=lambda f: float(f[0]))
        return None

    def _zero(self, low: arb, high: arb, phi: arb, slip: arb, excess: arb, side: int) -> arb:
        for _ in range(4 * self.digits):
            middle = ((low + high) / 2).mid()
            if self._drive(middle, phi, slip, excess, side) > 0:
                high = middle
            else:
                low = middle
        return high

    def _episode(self, time: arb, phi: arb, slip: arb, excess: arb, omega: arb, side: int) -> tuple[arb, arb, arb, arb]:
        """Until the mass stands still, or its time is over: when, how far, how fast, and the pressure."""
        p, x = self.p, arb(0)
        piece = self._piece(slip)
        band = sum(bool(v < omega) for v in p.table.speeds) if p.table else 0
        lifted: bool | None = None
        while True:
            if len(self.steps) > MOST_STEPS or (p.turns and abs(p.lean - phi - side * x) > arb.pi() / 2):
                raise Unfit
            limit = next((k for k in p.kinks if k > time * (1 + arb(2) ** -70) + arb(2) ** -90), None)
            if p.end is not None and (limit is None or limit > p.end):
                limit = p.end
            if lifted is None:
                later = time + arb(2) ** -60
                ctx.cap = 1
                press = p.moments(arb_series([phi + side * x]), later, side, self.place)[1][0]
                lifted = bool(press + p.polar * omega**2 - p.level * excess < 0)
            self.lifts += [time] if lifted and not self.carried else []
            self.carried = lifted
            y = self._series(time, phi, slip, (x, omega, excess), side, piece, band, lifted)
            h = self._length(y)
            if limit is not None and time + h >= limit:
                h = limit - time
            event, h = self._event(y, h, time, phi, slip, side, piece, band, lifted)
            self.steps.append(Step(time, h, side, phi, y))
            time, x, omega, excess = (time + h).mid(), value(y[0], h), value(y[1], h), value(y[2], h)
            if event == "stands":
                return time, x, arb(0), excess
            if event == "lifts":
                lifted = not lifted
            elif event == "border":
                self.place += side
            elif event == "slip":
                piece += 1
            elif event == "faster":
                band += 1
            elif event == "slower":
                band -= 1
            elif limit is not None and time >= limit * (1 - arb(2) ** -70):
                time = limit
                if p.end is not None and not limit < p.end:
                    return time, x, omega, excess
                if p.shaken:
                    lifted = None  # what presses may jump

    def _right(self, y: tuple[arb_series, ...], time: arb, phi: arb, slip: arb, side: int, piece: int, band: int,
               lifted: bool) -> tuple[arb_series, arb_series, arb_series]:  # fmt: skip
        """Slopes of x, omega and the excess pressure, and what presses instead of the first."""
        p = self.p
        x, omega, excess = y
        fall, press = p.moments(x * side + phi, time, side, self.place)
        normal = press + omega * omega * p.polar - excess * p.level
        resistance = omega * p.viscosity + omega * omega * p.drag + p.cohesion
        heat = arb_series([0])
        if not lifted:
            mu = p.mu(x + slip, omega, time, piece, band)
            resistance = resistance + mu * normal
            heat = mu * normal * omega * (p.kappa / p.level) if p.heats else heat
        return normal, fall - resistance, heat

    def _series(self, time: arb, phi: arb, slip: arb, start: tuple[arb, arb, arb], side: int, piece: int, band: int,
                lifted: bool) -> tuple[arb_series, ...]:  # fmt: skip
        """One more coefficient in each round."""
        known = [[s.mid()] for s in start]
        for n in range(1, self.terms):
            ctx.cap = n
            y = tuple(arb_series(k) for k in known)
            _, rate, heat = self._right(y, time, phi, slip, side, piece, band, lifted)
            for k, slope in zip(known, (y[1], rate, heat), strict=True):
                k.append((slope[n - 1] / n).mid())
        ctx.cap = self.terms
        return tuple(arb_series(k) for k in known)

    def _length(self, y: tuple[arb_series, ...]) -> arb:
        """Where the last terms are below the tolerance, relative to the first that count."""
        least = 1e3
        for s in y[:2]:
            size = max(float(abs(s[0])), 1e-300), max(float(abs(s[1])), 1e-300), max(float(abs(s[2])), 1e-300)
            for n in (self.terms - 1, self.terms - 2):
                c = float(abs(s[n]))
                if c == 0.0:
                    continue
                for k, first in enumerate(size):
                    if first > 1e-290:
                        least_here = math.exp((math.log(first) - math.log(c) - self.digits * math.log(10)) / (n - k))
                        least = min(least, least_here)
                        break
        return number(least)

    def _event(self, y: tuple[arb_series, ...], h: arb, *where: Any) -> tuple[str, arb]:
        """What happens first on a step, and when: looked for at 16 points, then by Newton's method."""
        time, phi, slip, side, piece, band, lifted = where
        p = self.p
        watched: dict[str, arb_series] = {"stands": y[1]}
        end = p.pieces[piece].end
        if end is not None:
            watched["slip"] = end - slip - y[0]
        beyond = self.place if side > 0 else self.place - 1
        if p.turns and 0 <= beyond < len(p.borders):
            watched["border"] = (p.borders[beyond] - phi) * side - y[0]
        if p.table and band < len(p.table.speeds):
            watched["faster"] = p.table.speeds[band] - y[1]
        if p.table and band > 0:
            watched["slower"] = y[1] - p.table.speeds[band - 1]
        if p.shaken or p.heats or p.borders or p.water.kinks or p.water.stretches[0].coefficients[0] != 0:
            normal = self._right(y, time, phi, slip, side, piece, band, lifted)[0]
            watched["lifts"] = -normal if lifted else normal
        first: tuple[str, arb] = ("", h)
        for name, series in watched.items():
            low = arb(0)
            for k in range(1, 17):
                high = h * k / 16
                if value(series, high) < 0:
                    if k == 1 and not value(series, h * arb(2) ** -40) > 0:
                        if name == "stands":
                            raise Unfit
                        break  # it begins there
                    t = self._root(series, low, high)
                    if t < first[1]:
                        first = name, t
                    break
                low = high
        return first

    def _root(self, series: arb_series, low: arb, high: arb) -> arb:
        for _ in range(20):
            middle = ((low + high) / 2).mid()
            if value(series, middle) < 0:
                high = middle
            else:
                low = middle
        t = high
        for _ in range(8):
            t = (t - value(series, t) / derivative(series, t)).mid()
        return t

    # -- what is asked of it

    def record(self, places: int = 24) -> dict[str, Any]:
        def text(x: arb) -> str:
            return str(x.mid().str(places, radius=False))

        p = self.p
        speed, length = p.radius / p.scale, p.radius
        times = [float(self.duration * number(s) * p.scale) for s in SHARES]
        states = [self.state(number(t) / p.scale) for t in times]
        return {
            "moves": bool(self.steps),
            "arrested": self.arrested,
            "lifted": bool(self.lifts),
            "peak": text(self.peak() * speed),
            "run_out": text(self.run_out * length),
            "duration": text(self.duration * p.scale),
            "times": times,
            "displacement": [text(x * length) for x, _ in states],
            "velocity": [text(v * speed) for _, v in states],
        }

    def state(self, t: arb) -> tuple[arb, arb]:
        last = arb(0)
        for s in self.steps:
            if t < s.start:
                break
            if t <= s.start + s.length:
                return s.state(t)
            last = s.state(s.start + s.length)[0]
        return last, arb(0)

    def peak(self) -> arb:
        best = arb(0)
        for s in self.steps:
            omega = s.series[1]
            ends = [value(omega, arb(0)), value(omega, s.length)]
            slopes = derivative(omega, arb(0)), derivative(omega, s.length)
            if slopes[0] > 0 and slopes[1] < 0:
                low, high = arb(0), s.length
                for _ in range(4 * self.digits):
                    middle = ((low + high) / 2).mid()
                    low, high = (middle, high) if derivative(omega, middle) > 0 else (low, middle)
                ends.append(value(omega, low))
            best = max([best, *ends], key=float)
        return best


def solve(scene: Mapping[str, Any], problem: Callable[[Mapping[str, Any]], Problem] = Problem,
          rounds: Sequence[tuple[int, int]] = ((26, 22), (34, 26))) -> dict[str, Any]:  # fmt: skip
    """The motion, by two series that agree."""
    records = []
    for terms, digits in rounds:
        before = ctx.prec
        ctx.prec = 200
        try:
            records.append(Solution(scene, terms, digits, problem).record(digits - 2))
        except (ZeroDivisionError, OverflowError, ValueError) as error:
            raise Unfit from error
        finally:
            ctx.prec, ctx.cap = before, 10
    one, two = records
    if one["moves"] != two["moves"] or one["arrested"] != two["arrested"] or not two["moves"]:
        raise Unfit
    for name in ("peak", "run_out", "duration"):
        if abs(float(arb(one[name]) / arb(two[name]) - 1)) > 10.0 ** (6 - rounds[0][1]):
            raise Unfit
    return two


# --- 100 scenes ------------------------------------------------------------------------------------------------------

GROUPS = {"viscous": 10, "pulse": 14, "series": 14, "rate": 12, "rate table": 8, "prescribed": 8, "product": 8,
          "heated": 10, "water": 6, "all": 10}  # fmt: skip


def drawn(group: str, rng: np.random.Generator) -> dict[str, Any]:
    """A random scene of a group, of an arc."""
    first = math.radians(rng.uniform(195, 235))
    arc = {"radius": float(10 ** rng.uniform(0.5, 3.3)), "theta_1": first,
           "theta_2": first + math.radians(rng.uniform(25, 95)), "unit_weight": float(rng.uniform(15e3, 25e3)),
           "gravity": 9.81}  # fmt: skip
    limit = float(references.moments(arc)["fall"] / references.moments(arc)["press"])
    limit *= math.tan(1.5 * math.pi - (arc["theta_1"] + arc["theta_2"]) / 2)
    if not 0.1 < limit < 1.5:
        raise Unfit
    depth = arc["radius"] * (1 - math.cos((arc["theta_2"] - arc["theta_1"]) / 2))
    return called(group, rng, arc, limit, depth)


def called(group: str, rng: np.random.Generator, arc: dict[str, Any], limit: float, depth: float) -> dict[str, Any]:
    """A random scene of a group, of a mass with a limit friction and a depth of its arc below the chord."""
    stress, pace = arc["unit_weight"] * depth, math.sqrt(arc["radius"] / arc["gravity"])
    speed = math.sqrt(arc["radius"] * arc["gravity"])
    low, high = limit * rng.uniform(0.3, 0.9), limit * rng.uniform(1.02, 1.6)
    effects: dict[str, Any] = {"rotation": {}}
    friction: Any = low
    if rng.random() < 0.6:
        effects["centripetal"] = {}
    if rng.random() < 0.25:
        effects["drag"] = {"xi": float(10 ** rng.uniform(2, 3.5))}
    if rng.random() < 0.2:
        effects["cohesion"] = {"cohesion": float(stress * rng.uniform(0.002, 0.02))}
    if rng.random() < 0.2:
        effects["pore_pressure"] = {"ratio": float(rng.uniform(0.02, 0.2))}

    def viscosity() -> dict[str, float]:
        e = 10 ** rng.uniform(-2, -0.3)
        return {"viscosity": float(e * arc["unit_weight"] / 9.81 * 0.02 * speed), "thickness": 0.5}

    def shaking(kind: str) -> dict[str, Any]:
        top, length = float(limit * rng.uniform(0.6, 2.0)), float(pace * rng.uniform(0.3, 4.0))
        if kind == "series":
            count = int(rng.integers(4, 25))
            time = np.concatenate([[0.0], np.cumsum(rng.uniform(0.3, 1.0, count))])
            given = {"time": (time / time[-1] * length).tolist(),
                     "horizontal": [0.0, *(top * rng.normal(size=count - 1)).tolist(), 0.0]}  # fmt: skip
            if rng.random() < 0.4:
                given["vertical"] = [0.0, *(0.3 * rng.normal(size=count - 1)).tolist(), 0.0]
        else:
            name = str(rng.choice(["rectangular", "half-sine", "triangular", "sine"]))
            given = {"pulse": name, "amplitude": top, "duration": length, "start": float(pace * rng.uniform(0, 1))}
            if name == "sine":
                given["cycles"] = float(rng.choice([1.0, 2.5, 6.0]))
            if rng.random() < 0.4:
                given["vertical_amplitude"] = float(rng.uniform(-0.5, 0.9))
        return given | ({"two_way": True} if rng.random() < 0.3 else {})

    def slip_law(peak: float, residual: float) -> dict[str, Any]:
        name = str(rng.choice(["exponential", "linear", "hyperbolic"]))
        return {
            "law": name,
            "peak": peak,
            "residual": residual,
            "length": float(arc["radius"] * 10 ** rng.uniform(-3, -1)),
        }

    def rate(peak: float, residual: float) -> dict[str, Any]:
        return {"law": "rate_weakening", "peak": peak, "residual": residual,
                "velocity": float(speed * 10 ** rng.uniform(-2.5, 0))}  # fmt: skip

    def table(peak: float, residual: float) -> dict[str, Any]:
        count = int(rng.integers(3, 6))
        values = np.linspace(peak, residual, count) * rng.uniform(0.97, 1.03, count)
        return {"law": "rate_tabulated", "speed": (speed * np.geomspace(1e-4, 0.3, count)).tolist(),
                "coefficient": values.tolist()}  # fmt: skip

    def heat() -> dict[str, float]:
        kappa = 10 ** rng.uniform(-1.0, 0.7)
        return {"pressurisation": float(kappa * 2.7e6 * 0.1 / arc["radius"]), "heat_capacity": 2.7e6, "thickness": 0.1}

    start = 0.0
    match group:
        case "viscous":
            effects["viscosity"] = viscosity()
            start = float(rng.choice([0.0, 0.1 * speed]))
        case "pulse" | "series":
            effects["shaking"] = shaking(group)
            friction = float(rng.choice([low, high, high]))
            if rng.random() < 0.3:
                friction = slip_law(high, low)
        case "rate":
            friction = rate(limit * float(rng.uniform(0.9, 0.99)), limit * float(rng.uniform(0.0, 0.7)))
            if rng.random() < 0.5:
                friction, start = friction | {"peak": high}, float(0.2 * speed)
        case "rate table":
            friction = table(limit * float(rng.uniform(0.8, 0.95)), low * 0.6)
        case "softening":
            friction = slip_law(limit * float(rng.uniform(0.8, 0.99)), low * 0.8)
        case "prescribed":
            time = np.cumsum(pace * rng.uniform(0.2, 1.0, 4))
            values = limit * rng.uniform([1.05, 0.5, 0.2, 0.9], [1.2, 0.8, 0.8, 1.4])
            friction = {"law": "prescribed", "time": [0.0, *time.tolist()], "coefficient": [high, *values.tolist()]}
        case "product":
            friction = slip_law(limit * 0.95, limit * 0.7) | {"rate": rate(1.0, float(rng.uniform(0.2, 0.9)))}
        case "heated":
            effects["thermal_pressurisation"] = heat()
            friction = low if rng.random() < 0.5 else slip_law(limit * 0.95, low)
        case "water":
            time = np.cumsum(pace * rng.uniform(0.3, 1.5, 3))
            top = float(rng.uniform(0.3, 0.9)) * stress
            effects["pore_pressure"] = {"time": [0.0, *time.tolist()], "pressure": [0.0, top, 0.5 * top, 0.0]}
            friction = float(rng.choice([low, high]))
        case "all":
            effects |= {"viscosity": viscosity(), "shaking": shaking(str(rng.choice(["pulse", "series"]))),
                        "thermal_pressurisation": heat()}  # fmt: skip
            friction = slip_law(high, low) | {"rate": rate(1.0, 0.5)}
    end = None
    if rng.random() < 0.15 and group != "all":
        effects.pop("rotation")
    if "rotation" not in effects or rng.random() < 0.15:
        end = float(pace * rng.uniform(1.0, 3.0))
    return {"arc": arc, "friction": friction, "effects": effects, "initial_velocity": start, "end_time": end}


def rows() -> Iterator[tuple[str, int]]:
    for group, count in GROUPS.items():
        yield from ((group, k) for k in range(count))


def row(which: tuple[str, int]) -> dict[str, Any]:
    """A scene of a group, drawn until it fits, and its motion."""
    group, index = which
    rng = np.random.default_rng([SEED, list(GROUPS).index(group), index])
    for _ in range(200):
        try:
            scene = drawn(group, rng)
            return {"group": group, "scene": scene, "reference": solve(scene)}
        except Unfit:
            continue
    raise RuntimeError(f"no scene of {group} fits")


def written(found: list[dict[str, Any]]) -> str:
    return "[\n" + ",\n".join(json.dumps(r) for r in found) + "\n]\n"


def main(make: Callable[..., Any] = ProcessPoolExecutor) -> None:
    with make(max_workers=2) as pool:
        found = []
        for r in pool.map(row, rows()):
            found.append(r)
            print(len(found), r["group"], r["reference"]["duration"], file=sys.stderr)
    FILE.write_text(written(found), encoding="utf-8")


if __name__ == "__main__":
    main()
