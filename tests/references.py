"""300 random scenes and their motion to 30 digits: ``python tests/references.py`` writes them to references.json.

Scenes are plain data. They are solved here by Taylor series of the equation of motion in time, from moments that are
quadratures of their definitions: nothing here knows a closed form, the phase plane or a line of the package. Each is
solved twice, with series of different length at different precision, and both have to agree.
"""

import json
import math
import os
import sys
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import product
from operator import mul
from pathlib import Path
from typing import Any

import numpy as np
import oracle
from flint import arb, ctx

FILE = Path(__file__).with_name("references.json")
SEED = 20230917
DIGITS = 30
MOST_STEPS, LONGEST = 20_000, 1e6  # of a scene that never ends: it is drawn anew


class Unfit(Exception):
    """The scene turns over or never ends."""


# --- a scene in numbers ----------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Piece:
    """Friction from one slip to the next, over R: ``rise`` times a shape of the slip since ``start``, plus ``level``.

    The shapes: exp(-s/length), 1/(1 + s/length), or a cubic with the given coefficients, in which level is 0.
    """

    shape: str
    start: arb
    end: arb | None
    level: arb = field(default_factory=arb)
    rise: arb = field(default_factory=arb)
    length: arb = field(default_factory=arb)
    cubic: tuple[arb, ...] = ()


@dataclass(frozen=True)
class Problem:
    """A scene's equation of motion, all over Theta*; slips over R; see (2.20), (3.11)."""

    dip: arb
    fall: arb  # C_theta
    press: arb  # C_r (1 - r_u)
    water: arb  # lambda u*
    cohesion: arb  # lambda c*
    polar: arb  # I_p* = lambda A, if the mass presses by its speed
    drag: arb
    turns: bool
    pieces: tuple[Piece, ...]
    omega: arb
    end: arb | None
    radius: arb
    gravity: arb

    @property
    def frictionless(self) -> bool:
        """Whether nothing brings it to rest."""
        first = self.pieces[0]
        return first.shape == "cubic" and first.end is None and first.cubic[0] == 0 and self.cohesion == 0


def moments(arc: Mapping[str, float]) -> dict[str, arb]:
    """C_theta, C_r, I_p*, lambda over Theta*, Theta*, and the reference stress, of the exact doubles of the arc."""
    half = (Fraction(arc["theta_2"]) - Fraction(arc["theta_1"])) / 2
    middle = (Fraction(arc["theta_1"]) + Fraction(arc["theta_2"])) / 2
    inertia = oracle.kernel("moment_of_inertia", half)
    depth = oracle.exact(arc["radius"]) * 2 * (oracle.exact(half) / 2).sin() ** 2
    return {
        "fall": oracle.kernel("weight_moment_per_inertia", half),
        "press": oracle.kernel("radial_weight_per_inertia", half),
        "polar": oracle.kernel("polar_moment_per_inertia", half),
        "level": oracle.kernel("resistance_factor", half) / inertia,
        "inertia": inertia,
        "reference_stress": oracle.exact(arc["unit_weight"]) * depth,
        "dip": 3 * arb.pi() / 2 - oracle.exact(middle),
        "half_angle": oracle.exact(half),
    }


def problem(scene: Mapping[str, Any]) -> Problem:
    """The equation of motion of a scene, at the working precision."""
    arc, effects, m = scene["arc"], scene["effects"], moments(scene["arc"])
    number = oracle.exact
    radius, gravity = number(arc["radius"]), number(arc["gravity"])
    water = effects.get("pore_pressure", {})
    cohesion = effects.get("cohesion", {}).get("cohesion", 0.0)
    drag = 2 * m["half_angle"] * gravity / m["inertia"] / number(effects["drag"]["xi"]) if "drag" in effects else arb(0)
    return Problem(
        m["dip"],
        m["fall"],
        m["press"] * (1 - number(water.get("ratio", 0.0))),
        m["level"] * number(water.get("pressure", 0.0)) / m["reference_stress"],
        m["level"] * number(cohesion) / m["reference_stress"],
        m["polar"] if "centripetal" in effects else arb(0),
        drag,
        "rotation" in effects,
        pieces(scene["friction"], radius),
        number(scene["initial_velocity"]) / (gravity * radius).sqrt(),
        None if scene["end_time"] is None else number(scene["end_time"]) * (gravity / radius).sqrt(),
        radius,
        gravity,
    )


def pieces(law: float | Mapping[str, Any], radius: arb) -> tuple[Piece, ...]:
    """A friction law as smooth pieces."""
    number = oracle.exact
    if not isinstance(law, Mapping):
        return (Piece("cubic", arb(0), None, cubic=(number(law),)),)
    if law["law"] == "tabulated":
        return table([number(s) / radius for s in law["slip"]], [number(v) for v in law["coefficient"]])
    peak, residual, length = (number(law[n]) for n in ("peak", "residual", "length"))
    length = length / radius
    if law["law"] == "linear":
        falling = Piece("cubic", arb(0), length, cubic=(peak, (residual - peak) / length))
        return falling, Piece("cubic", length, None, cubic=(residual,))
    return (Piece(law["law"], arb(0), None, residual, peak - residual, length),)


def table(slip: list[arb], value: list[arb]) -> tuple[Piece, ...]:
    """Monotone cubics (Fritsch and Carlson 1980; slopes: weighted harmonic means, Fritsch and Butland 1984).

    The slope at the start is the parabola's through three points, limited; at the end it is zero.
    """
    step = [b - a for a, b in zip(slip, slip[1:], strict=False)]
    secant = [(b - a) / h for a, b, h in zip(value, value[1:], step, strict=False)]
    slope = [arb(0)] * len(slip)
    for k in range(1, len(slip) - 1):
        left, right = secant[k - 1], secant[k]
        if left * right > 0:
            one, two = 2 * step[k] + step[k - 1], step[k] + 2 * step[k - 1]
            slope[k] = (one + two) / (one / left + two / right)
    slope[0] = secant[0]
    if len(slip) > 2:
        slope[0] = ((2 * step[0] + step[1]) * secant[0] - step[0] * secant[1]) / (step[0] + step[1])
        if not slope[0] * secant[0] > 0:
            slope[0] = arb(0)
        elif secant[0] * secant[1] < 0 and abs(slope[0]) > 3 * abs(secant[0]):
            slope[0] = 3 * secant[0]
    found = []
    for k, h in enumerate(step):
        # Hermite's cubic in z = s - s_k: value and slope at both ends.
        second = (3 * secant[k] - 2 * slope[k] - slope[k + 1]) / h
        third = (slope[k] + slope[k + 1] - 2 * secant[k]) / h**2
        found.append(Piece("cubic", slip[k], slip[k + 1], cubic=(value[k], slope[k], second, third)))
    return *found, Piece("cubic", slip[-1], None, cubic=(value[-1],))


# --- Taylor series in time -------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Segment:
    """One series: from a time, in a direction, from a rotation; x and omega in the direction of travel."""

    start: arb
    length: arb
    direction: int
    rotation: arb
    x: list[arb]
    omega: list[arb]

    def state(self, t: arb) -> tuple[arb, arb]:
        """Rotation and angular velocity."""
        past = t - self.start
        return self.rotation + self.direction * horner(self.x, past), self.direction * horner(self.omega, past)


def horner(series: Sequence[arb], h: arb) -> arb:
    """A series' value."""
    value = arb(0)
    for c in reversed(series):
        value = value * h + c
    return value.mid()


def product_term(a: Sequence[arb], b: Sequence[arb], n: int) -> arb:
    """The nth coefficient of a product."""
    return sum(map(mul, a[: n + 1], b[n::-1]), arb(0))


def friction_series(piece: Piece, slip: arb, x: list[arb], omega: list[arb]) -> Iterator[arb]:
    """Coefficients of the friction along x(t), one after the other, while x and omega grow; x starts at 0."""
    past = slip - piece.start
    if piece.shape == "exponential":
        shape = [(-past / piece.length).exp()]
        yield piece.level + piece.rise * shape[0]
        while True:
            n = len(shape)
            shape.append(-product_term(omega, shape, n - 1) / (n * piece.length))
            yield piece.rise * shape[n]
    if piece.shape == "hyperbolic":
        shape = [1 / (1 + past / piece.length)]
        yield piece.level + piece.rise * shape[0]
        while True:
            n = len(shape)
            # x[0] = 0, so that the term with shape[n] itself drops out.
            whole = sum((x[k] * shape[n - k] for k in range(1, n + 1)), arb(0))
            shape.append(-shape[0] * whole / piece.length)
            yield piece.rise * shape[n]
    if len(piece.cubic) == 1:
        yield piece.cubic[0]
        while True:
            yield arb(0)
    z: list[arb] = []
    square: list[arb] = []
    coefficients = (*piece.cubic, arb(0), arb(0))[:4]
    while True:
        n = len(z)
        z.append(x[n] if n else past)
        square.append(product_term(z, z, n))
        value = coefficients[1] * z[n] + coefficients[2] * square[n]
        if coefficients[3] != 0:
            value += coefficients[3] * product_term(square, z, n)
        yield value + (coefficients[0] if n == 0 else 0)


def expand(p: Problem, piece: Piece, lifted: bool, dip: arb, slip: arb, omega: arb, order: int) -> list[list[arb]]:
    """Series of x, omega and the effective normal force from here: x' = omega, omega' = the balance of momentum."""
    x, w = [arb(0)], [omega]
    sine, cosine = [dip.sin()], [dip.cos()]
    energy: list[arb] = []
    normal: list[arb] = []
    mu: list[arb] = []
    friction = friction_series(piece, slip, x, w)
    for n in range(order):
        if n:
            # of dip - x: its derivative is -omega
            sine.append(-product_term(cosine, w, n - 1) / n if p.turns else arb(0))
            cosine.append(product_term(sine, w, n - 1) / n if p.turns else arb(0))
        energy.append(product_term(w, w, n))
        normal.append(p.press * cosine[n] + p.polar * energy[n] - (p.water if n == 0 else 0))
        mu.append(next(friction))
        rate = p.fall * sine[n] - p.drag * energy[n] - (p.cohesion if n == 0 else 0)
        if not lifted:
            rate -= product_term(mu, normal, n)
        w.append((rate / (n + 1)).mid())
        x.append(w[n] / (n + 1))
    return [x, w, normal]


def reach(series: Sequence[arb], digits: int) -> float:
    """How far the series goes: until its last terms are that many digits below its largest one."""
    size = [float(abs(c).log()) if c != 0 else -math.inf for c in series]
    last, far = len(series) - 1, math.inf
    for n in (last, last - 1):
        if size[n] > -math.inf:
            low = [(size[k] - size[n] - digits * math.log(10.0)) / (n - k) for k in range(5) if size[k] > -math.inf]
            far = min(far, max(low))
    return math.exp(min(far, 27.0))


_AT = np.linspace(0.0, 1.0, 65)[1:]


def crossing(series: Sequence[arb], h: arb) -> float | None:
    """The first share of h at which a series that is positive at first is not so any more."""
    power, scaled = arb(1), []
    for c in series:
        scaled.append(float(c * power))
        power *= h
    low = np.flatnonzero(np.polynomial.polynomial.polyval(_AT, scaled) <= 0.0)
    if not len(low):
        return None
    k = int(low[0])
    left, right = (float(_AT[k - 1]) if k else 0.0), float(_AT[k])
    for _ in range(60):
        middle = (left + right) / 2
        if np.polynomial.polynomial.polyval(middle, scaled) > 0.0:
            left = middle
        else:
            right = middle
    return left


def zero(series: Sequence[arb], h: arb) -> arb | None:
    """Its first zero in (0, h], by Newton's steps at full precision; None if it stays positive."""
    share = crossing(series, h)
    if share is None:
        return None
    at, slope = (h * share).mid(), derivative(series)
    for _ in range(12):
        step = (horner(series, at) / horner(slope, at)).mid()
        at = (at - step).mid()
        if abs(step) <= abs(at) * arb(2) ** (8 - ctx.prec):
            break
    return at


def derivative(series: Sequence[arb]) -> list[arb]:
    """Term by term."""
    return [k * c for k, c in enumerate(series)][1:]


@dataclass
class Solution:
    """Series one after the other, where the speed may be greatest, and how it ends."""

    segments: list[Segment] = field(default_factory=list)
    peaks: list[arb] = field(default_factory=list)
    phases: int = 0
    lifted: bool = False
    arrested: bool = False
    duration: arb = field(default_factory=arb)

    def state(self, t: arb) -> tuple[arb, arb]:
        """Rotation and angular velocity at a time, at rest after an arrest."""
        if not self.segments:
            return arb(0), arb(0)
        last = self.segments[-1]
        if t >= self.duration:
            rotation, omega = last.state(self.duration)
            return rotation, arb(0) if self.arrested else omega
        return next(s for s in reversed(self.segments) if s.start <= t).state(t)


def way(p: Problem, rotation: arb, mu: arb) -> int:
    """The direction in which a mass at rest moves, 0 if it stays."""
    dip = p.dip - rotation if p.turns else p.dip
    normal = p.press * dip.cos() - p.water
    held = p.cohesion + (mu * normal if normal > 0 else 0)
    return next((side for side in (1, -1) if side * p.fall * dip.sin() > held), 0)


def motion(p: Problem, order: int, digits: int) -> Solution:
    """Follow the mass until it rests, or until its end."""
    found = Solution()
    time, rotation, slip, omega = arb(0), arb(0), arb(0), abs(p.omega)
    direction = 0 if p.omega == 0 else 1 if p.omega > 0 else -1
    steps = 0
    while True:
        if omega == 0:
            piece = next(k for k in p.pieces if k.end is None or slip < k.end)
            direction = way(p, rotation, next(friction_series(piece, slip, [], [])))
            if direction == 0:
                found.arrested, found.duration = True, time
                return found
        found.phases += 1
        origin, x, fresh = rotation, arb(0), True
        dip = direction * (p.dip - rotation) if p.turns else direction * p.dip
        lifted = bool(p.press * dip.cos() + p.polar * omega**2 < p.water)
        while True:  # over series, until a standstill
            steps += 1
            if steps > MOST_STEPS or time > LONGEST:
                raise Unfit
            found.lifted |= lifted
            if omega > 0 or fresh:
                found.peaks.append(time)
            piece = next(k for k in p.pieces if k.end is None or slip < k.end)
            xs, ws, normal = expand(p, piece, lifted, dip - x if p.turns else dip, slip, omega, order)
            h = arb(reach(ws, digits))
            last = "step"
            if p.end is not None and time + h >= p.end:
                h, last = p.end - time, "end"
            # whichever comes first ends the series
            if piece.end is not None:
                far = zero([piece.end - slip, *(-c for c in xs[1:])], h)
                if far is not None:
                    h, last = far, "kink"
            if p.water != 0:
                sign = 1 if lifted else -1
                # just after a change the force is zero, and grows away from it
                far = zero([-sign * c for c in (arb(0), *normal[1:])] if last_change(found, time) else
                           [-sign * c for c in normal], h)  # fmt: skip
                if far is not None:
                    h, last = far, "change"
            far = zero(ws if omega > 0 else ws[1:], h)
            if far is not None:
                h, last = far, "stop"
            rates = derivative(ws)
            if horner(rates, arb(0)) > 0:
                top = zero(rates, h)
                if top is not None:
                    found.peaks.append(time + top)
            found.segments.append(Segment(time, h, direction, origin + direction * x, xs, ws))
            more, omega = horner(xs, h), horner(ws, h)
            x, time, fresh = (x + more).mid(), (time + h).mid(), False
            slip = piece.end if last == "kink" and piece.end is not None else (slip + more).mid()
            if p.turns and dip - x < -arb.pi() / 2:
                raise Unfit
            if last == "end":
                assert p.end is not None
                found.duration = p.end
                return found
            if last == "change":
                lifted = not lifted
                found.changes.append(time)
            if last == "stop":
                break
        rotation, omega = (origin + direction * x).mid(), arb(0)
        if p.end is None and p.frictionless:
            found.duration = time
            return found
