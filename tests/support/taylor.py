"""A scene's motion to as many digits as asked for, by Taylor series in time in ball arithmetic's midpoints.

Scenes are plain data, with every law and effect. They are solved from moments that are quadratures of their
definitions (`oracle`) and the equation of motion as it stands: nothing here knows a closed form, the phase plane or a
line of the package. That series of another length agree says how good they are.
"""

import math
from bisect import bisect_right
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from flint import arb, arb_series, ctx

from tests.support import oracle
from tests.support.pieces import Pieces, constant, law_of_slip, law_of_speed, lines, pulse
from tests.support.recorded import recorded

number = oracle.exact


class Unfit(Exception):
    """The scene turns over or never ends."""


class Problem:
    """A scene's equation of motion, all over Theta*, in dimensionless time; see (2.20), (3.11)."""

    def __init__(self, scene: Mapping[str, Any]) -> None:
        arc, effects, m = scene["arc"], scene["effects"], self.measured(scene["arc"])
        self.radius, gravity = number(arc["radius"]), number(arc["gravity"])
        self.scale, self.unit = (self.radius / gravity).sqrt(), (self.radius * gravity).sqrt()  # of time and speed
        self.dip, self.fall, self.press, self.level = m["dip"], m["fall"], m["press"], m["level"]
        self.lean, self.cover = m.get("lean", m["dip"]), m.get("cover", arb(1))  # of what presses; of r_u
        self.turns = "rotation" in effects
        self.polar = m["polar"] if "centripetal" in effects else arb(0)
        per, layer = 1 / m["reference_stress"], 2 * m["half_angle"] / m["inertia"]
        water = effects.get("pore_pressure", {})

        def course(name: str, factor: arb) -> Pieces:
            if "time" in water and name in water:
                return lines(water["time"], water[name], True, factor, self.scale)
            return constant(0 if "time" in water else number(water.get(name, 0.0)) * factor)

        self.ratio, self.water = course("ratio", arb(1)), course("pressure", per)
        self.cohesion = self.level * number(effects.get("cohesion", {}).get("cohesion", 0.0)) * per
        self.drag = layer * gravity / number(effects["drag"]["xi"]) if "drag" in effects else arb(0)
        self.viscosity = self.kappa = arb(0)
        if "viscosity" in effects:
            v, density = effects["viscosity"], number(arc["unit_weight"]) / gravity
            self.viscosity = layer * number(v["viscosity"]) / (density * number(v["thickness"]) * self.unit)
        self.heats = "thermal_pressurisation" in effects
        if self.heats:
            h = {k: number(v) for k, v in effects["thermal_pressurisation"].items()}
            self.kappa = h["pressurisation"] * self.radius / (h["heat_capacity"] * h["thickness"])
        shaking, self.shaken = effects.get("shaking", {}), "shaking" in effects
        self.two_way = not self.shaken or bool(shaking.get("two_way", False))
        self.k_h, self.k_v = (
            pulse(shaking, shaking[name], self.scale) if shaking.get(name)
            else lines(shaking["time"], shaking[record], False, arb(1), self.scale) if record in shaking
            else constant()
            for name, record in (("amplitude", "horizontal"), ("vertical_amplitude", "vertical"))
        )  # fmt: skip
        law = scene["friction"]
        self.slip, self.speed, self.time = constant(1), constant(1), constant(1)  # friction is their product
        if isinstance(law, Mapping) and law["law"].startswith("rate"):
            self.speed = law_of_speed(law, self.unit)
        elif isinstance(law, Mapping) and law["law"] == "prescribed":
            self.time = lines(law["time"], law["coefficient"], True, arb(1), self.scale)
        else:
            self.slip = law_of_slip(law, self.radius)
            if isinstance(law, Mapping) and "rate" in law:
                self.speed = law_of_speed(law["rate"], self.unit)
        self.free = self.free or (self.cohesion == 0 and law == 0.0)  # nothing brings it to rest
        self.omega = number(scene["initial_velocity"]) / self.unit
        self.end = None if scene["end_time"] is None else (number(scene["end_time"]) / self.scale).mid()
        courses = (self.k_h, self.k_v, self.water, self.ratio, self.time)
        self.kinks = sorted((b for c in courses for b in c.breaks), key=float)

    def measured(self, arc: Mapping[str, Any]) -> dict[str, arb]:
        """Return the moments of the mass that the balance requires."""
        return oracle.moments(arc)

    free = False  # of what brings it to rest
    borders: Sequence[arb] = ()  # rotations between which `under` is one formula

    def under(self, phi: arb_series, place: int) -> arb_series | int:
        """Mean pressure below a level that stays while the mass turns, over the reference stress."""
        return 0

    def mu(self, slip: arb_series, speed: arb_series, t: arb, piece: int, band: int) -> arb_series:
        """Friction around a time; slip over R."""
        return self.slip.functions[piece](slip) * self.time.on(t) * self.speed.functions[band](speed)

    def pressed(self, phi: arb_series, t: arb, side: int, place: int = 0) -> tuple[arb_series, arb_series]:
        """Around a time what drives in a direction, and what presses beside the water of its time."""
        turned = phi if self.turns else arb_series([0])
        sine, cosine = (self.dip - turned).sin_cos()
        across, along = (sine, cosine) if self.lean is self.dip else (self.lean - turned).sin_cos()
        ratio, water = self.ratio.on(t) * self.cover, self.water.on(t) + self.under(turned, place)
        fall, press = sine, along
        if self.shaken:
            k_h, k_v = self.k_h.on(t), self.k_v.on(t)
            fall, press = (1 - k_v) * sine + k_h * cosine, (1 - k_v) * along - k_h * across
        return fall * (self.fall * side), (press - along * ratio) * self.press - water * self.level


class Released(Problem):
    """A problem that is solved to its first standstill, as without friction."""

    free = True


def value(series: arb_series, h: arb) -> arb:
    found = arb(0)
    for k in range(series.length() - 1, -1, -1):
        found = found * h + series[k]
    return found.mid()


_AT = np.linspace(0.0, 1.0, 65)[1:]


def zero(series: arb_series, h: arb, passed: bool = False) -> arb | None:
    """Return the first zero in (0, h] of a series that is positive at first; None if it stays so.

    One that has just passed zero is divided by the time.
    """
    terms = [(series[k] * h**k).mid() for k in range(int(passed), series.length())]
    most = max(map(abs, terms), default=arb(0))
    scaled = [float(c / most) if most > 0 else 0.0 for c in terms]
    low = np.flatnonzero(np.polynomial.polynomial.polyval(_AT, scaled) <= 0.0)
    if not len(low) or not (terms[0] > 0 or np.polynomial.polynomial.polyval(1e-12, scaled) > 0.0):
        return None
    k = int(low[0])
    left, right = (float(_AT[k - 1]) if k else 0.0), float(_AT[k])
    for _ in range(50):
        middle = (left + right) / 2
        if np.polynomial.polynomial.polyval(middle, scaled) > 0.0:
            left = middle
        else:
            right = middle
    at, slope = (h * right).mid(), series.derivative()
    for _ in range(12):  # Newton
        step = (value(series, at) / value(slope, at)).mid()
        at = (at - step).mid()
        if abs(step) <= abs(at) * arb(2) ** (8 - ctx.prec):
            break
    return at


class Step(NamedTuple):
    """A Taylor series: from a time, over a length, in a direction; x since the start of the episode."""

    start: arb
    length: arb
    side: int
    begin: arb
    series: tuple[arb_series, ...]

    def state(self, t: arb) -> tuple[arb, arb]:
        """Rotation and angular velocity."""
        x, omega = (value(s, t - self.start) for s in self.series[:2])
        return self.begin + self.side * x, self.side * omega


class Solution:
    """The motion of a problem by series of a given length, each term neglected below a tolerance."""

    def __init__(self, problem: Problem, terms: int, digits: int, most: tuple[int, int] = (20_000, 4000)) -> None:
        self.p, self.terms, self.digits, self.most = problem, terms, digits, most  # steps and episodes
        self.place = sum(bool(b < 0) for b in problem.borders)
        self.steps: list[Step] = []
        self.lifts: list[arb] = []  # when it lifts off while it moves
        self.tops: list[tuple[arb, arb]] = []  # time and angular velocity where it may be fastest
        self.carried = self.arrested = False
        cap = ctx.cap
        try:
            self._solve()
        except (ZeroDivisionError, OverflowError, ValueError) as error:
            raise Unfit from error
        finally:
            ctx.cap = cap

    def _solve(self) -> None:
        p = self.p
        time, phi, slip, excess, omega, side = arb(0), arb(0), arb(0), arb(0), abs(p.omega), 1 if p.omega >= 0 else -1
        self.episodes, self.run_out = 0, arb(0)
        while p.end is None or time < p.end:
            if omega == 0:
                if p.free and p.end is None and self.steps:
                    break
                found = self._start(time, phi, slip, excess)
                if found is None or not (p.end is None or found[0] < p.end):  # later starts decide nothing
                    self.arrested = True
                    break
                time, side = found
            self.episodes += 1
            if self.episodes > self.most[1]:
                raise Unfit
            time, x, omega, excess = self._episode(time, phi, slip, excess, omega, side)
            phi, slip = (phi + side * x).mid(), (slip + x).mid()
            self.run_out = max(self.run_out, phi, key=abs)
        self.duration = time if self.arrested or p.end is None else p.end
        self.rotation = phi

    def _drive(self, time: arb, phi: arb, slip: arb, excess: arb, side: int) -> arb:
        """Return the drive less the resistance at rest."""
        ctx.cap = 1
        fall, press = self.p.pressed(arb_series([phi]), time, side, self.place)
        normal = press[0] - self.p.level * excess
        mu = self.p.mu(arb_series([slip]), arb_series([0]), time, self.p.slip.at(slip), 0)[0]
        return (fall[0] - self.p.cohesion - (mu * normal if normal > 0 else 0)).mid()

    def _start(self, time: arb, phi: arb, slip: arb, excess: arb) -> tuple[arb, int] | None:
        """When it starts, and which way: at once, or between two kinks of time where the drive passes zero."""
        p = self.p
        sides = (1, -1) if p.two_way else (1 if (p.dip - phi if p.turns else p.dip) > 0 else -1,)
        kinks = [k for k in p.kinks if k > time]
        if not kinks:
            return next(((time, s) for s in sides if self._drive(time, phi, slip, excess, s) > 0), None)
        for left, right in pairwise([time, *kinks, kinks[-1] + 1]):
            tiny, found = (right - left) * arb(2) ** -80, []
            grid = [(left + tiny + (right - left - 2 * tiny) * k / 200).mid() for k in range(201)]
            for side in sides:
                k = next((k for k, t in enumerate(grid) if self._drive(t, phi, slip, excess, side) > 0), None)
                if k is not None:
                    low, high = (left, left) if k == 0 else grid[k - 1 : k + 1]
                    for _ in range(4 * self.digits if k else 0):
                        middle = ((low + high) / 2).mid()
                        past = self._drive(middle, phi, slip, excess, side) > 0
                        low, high = (low, middle) if past else (middle, high)
                    found.append((high, side))
            if found:
                return min(found, key=lambda f: float(f[0]))
        return None

    def _episode(self, time: arb, phi: arb, slip: arb, excess: arb, omega: arb, side: int) -> tuple[arb, arb, arb, arb]:
        """Integrate to the next standstill or the end time; return time, distance, velocity and excess pressure."""
        p, x, piece, band = self.p, arb(0), self.p.slip.at(slip), self.p.speed.at(omega)
        lifted: bool | None = None
        last = "stands" if omega == 0 else ""
        while True:
            if len(self.steps) > self.most[0] or (p.turns and abs(p.lean - phi - side * x) > arb.pi() / 2):
                raise Unfit
            later = bisect_right(p.kinks, time * (1 + arb(2) ** -70) + arb(2) ** -90)
            limit = p.kinks[later] if later < len(p.kinks) else None
            if p.end is not None and (limit is None or limit > p.end):
                limit = p.end
            if lifted is None:
                ctx.cap = 1
                press = p.pressed(arb_series([phi + side * x]), time + arb(2) ** -60, side, self.place)[1][0]
                lifted = bool(press + p.polar * omega**2 - p.level * excess < 0)
            self.lifts += [time] if lifted and not self.carried else []
            self.carried = lifted
            reach = None if limit is None else limit - time
            y, normal = self._series(time, phi, slip, (x, omega, excess), side, piece, band, lifted, reach)
            h = self._length(y)
            if limit is not None and time + h >= limit:
                h = limit - time
            watched = {"stands": y[1]}
            if piece < len(p.slip.breaks):
                watched["slip"] = p.slip.breaks[piece] - slip - y[0]
            if band < len(p.speed.breaks):
                watched["faster"] = p.speed.breaks[band] - y[1]
            if band > 0:
                watched["slower"] = y[1] - p.speed.breaks[band - 1]
            beyond = self.place if side > 0 else self.place - 1
            if p.turns and 0 <= beyond < len(p.borders):
                watched["border"] = (p.borders[beyond] - phi) * side - y[0]
            # What has just been passed is zero at first.
            zeros = {name: zero(s, h, name == last) for name, s in watched.items()}
            event, h = min([("", h), *((n, t) for n, t in zeros.items() if t is not None)], key=lambda e: float(e[1]))
            # What presses may vary faster than the motion that the step is made for: beyond the border of a formula it
            # may pass zero twice between two of the places where `zero` looks.
            lifts = zero(-normal if lifted else normal, h, last == "lifts")
            event, h = (event, h) if lifts is None else ("lifts", lifts)
            self.steps.append(Step(time, h, side, phi, y))
            top = zero(y[1].derivative(), h) if y[1][1] > 0 else None
            self.tops += [((time + t).mid(), side * value(y[1], t)) for t in (arb(0), h, top) if t is not None]
            time, x, omega, excess = ((time + h).mid(), *(value(s, h) for s in y))
            last = {"faster": "slower", "slower": "faster", "lifts": "lifts"}.get(event, "")
            piece, band = piece + (event == "slip"), band + (event == "faster") - (event == "slower")
            self.place += side * (event == "border")
            if event == "slip":
                x = (p.slip.breaks[piece - 1] - slip).mid()
            if event == "stands":
                return time, x, arb(0), excess
            if event == "lifts":
                lifted = not lifted
            elif not event and limit is not None and time >= limit * (1 - arb(2) ** -70):
                time = limit
                if p.end is not None and not limit < p.end:
                    return time, x, omega, excess
                lifted = None if p.shaken else lifted  # what presses may jump

    def _series(self, time: arb, phi: arb, slip: arb, start: tuple[arb, arb, arb], side: int, piece: int, band: int,
                lifted: bool, reach: arb | None) -> tuple[tuple[arb_series, ...], arb_series]:  # fmt: skip
        """Return the series of x, omega and the excess pressure, and of the normal load.

        Coefficient n of a series is coefficient n - 1 of its slope over n. Within a short reach, coefficients without
        influence are left out.
        """
        p, known = self.p, [[s.mid()] for s in start]

        def pressing(x: arb_series, omega: arb_series, excess: arb_series) -> tuple[arb_series, arb_series]:
            fall, press = p.pressed(x * side + phi, time, side, self.place)
            return fall, press + omega * omega * p.polar - excess * p.level

        def slopes(x: arb_series, omega: arb_series, excess: arb_series) -> tuple[arb_series, ...]:
            fall, normal = pressing(x, omega, excess)
            rate, heat = fall - omega * p.viscosity - omega * omega * p.drag - p.cohesion, arb_series([0])
            if not lifted:
                friction = p.mu(x + slip, omega, time, piece, band) * normal
                rate = rate - friction
                heat = friction * omega * (p.kappa / p.level) if p.heats else heat
            return omega, rate, heat

        for n in range(1, self.terms):
            ctx.cap = n
            for of_one, slope in zip(known, slopes(*(arb_series(k) for k in known)), strict=True):
                of_one.append((slope[n - 1] / n).mid())
            if n > 9 and reach is not None and reach < 0.01 and not any(self._counts(k, reach) for k in known[:2]):
                break
        ctx.cap = self.terms
        y = tuple(arb_series(k) for k in known)
        return y, pressing(*y)[1]

    def _counts(self, known: list[arb], reach: arb) -> bool:
        """Whether one of the last three coefficients does, beside the first ones."""
        sizes = [abs(c) * reach**k for k, c in enumerate(known)]
        return bool(max(sizes[-3:]) > max(sizes[:5]) * arb(10) ** -self.digits)

    def _length(self, y: tuple[arb_series, ...]) -> arb:
        """Return the time at which the last terms fall below the tolerance, relative to the largest first term."""

        def size(c: arb) -> float:
            return float(abs(c).log()) if c != 0 else -math.inf

        far = 27.0
        for s in y[:2]:
            first = [(k, size(s[k])) for k in range(5)]
            for n in (self.terms - 2, self.terms - 1):
                if (last := size(s[n])) > -math.inf:
                    far = min(far, max((f - last - self.digits * math.log(10.0)) / (n - k) for k, f in first))
        return number(math.exp(far))

    # -- what is asked of it

    def state(self, t: arb) -> tuple[arb, arb]:
        """Rotation and angular velocity at a time."""
        begun = [s for s in self.steps if not s.start > t]
        if not begun:
            return arb(0), arb(0)
        last = begun[-1]
        if (t - last.start).mid() <= last.length * (1 + arb(2) ** -80):
            return last.state(t)
        return last.state(last.start + last.length)[0], arb(0)

    def peak(self) -> tuple[arb, arb]:
        """Time and angular velocity of the greatest speed."""
        return max(self.tops, key=lambda top: abs(top[1]), default=(arb(0), arb(0)))

    def record(self, times: Sequence[float] = (), digits: int = 30) -> dict[str, Any]:
        """Return the motion as numbers of so many digits, in SI units, with states at some times."""
        p, (top, fastest) = self.p, self.peak()
        states = [self.state(number(t) / p.scale) for t in times]

        def text(x: arb) -> str:
            return str(x.mid().str(digits, radius=False))

        return {
            "moves": bool(self.steps),
            "arrested": self.arrested,
            "phases": self.episodes,
            "lift_off": [float(t * p.scale) for t in self.lifts],
            "duration": text(self.duration * p.scale),
            "run_out": text(self.run_out * p.radius),
            "end_displacement": text(self.rotation * p.radius),
            "peak_velocity": text(fastest * p.unit),
            "peak_time": text(top * p.scale),
            "times": list(times),
            "displacement": [text(x * p.radius) for x, _ in states],
            "velocity": [text(v * p.unit) for _, v in states],
        }


@recorded
def solve(scene: Mapping[str, Any], shares: Sequence[float] = (), digits: int = 30, problem: type[Problem] = Problem,
          **limits: Any) -> dict[str, Any]:  # fmt: skip
    """Return the motion of a scene to so many digits, with states at these shares of its duration."""
    with ctx.workprec(120 + 5 * digits):
        found = Solution(problem(scene), digits + 12, digits + 8, **limits)
        duration = float(found.duration * found.p.scale)
        return found.record([duration * share for share in shares] if found.steps else [], digits)
