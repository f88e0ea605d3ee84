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
from itertools import pairwise, product
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
        "dip": abs(3 * arb.pi() / 2 - oracle.exact(middle)),  # positive is down-slope, for either facing
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
    step = [b - a for a, b in pairwise(slip)]
    secant = [(b - a) / h for (a, b), h in zip(pairwise(value), step, strict=True)]
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

    def size(n: int) -> float:
        return float(abs(series[n]).log()) if series[n] != 0 else -math.inf

    far = 27.0
    first = [(k, size(k)) for k in range(5)]
    for n in (len(series) - 2, len(series) - 1):
        last = size(n)
        if last > -math.inf:
            far = min(far, max((s - last - digits * math.log(10.0)) / (n - k) for k, s in first))
    return math.exp(far)


_AT = np.linspace(0.0, 1.0, 65)[1:]


def zero(series: Sequence[arb], h: arb) -> arb | None:
    """The first zero in (0, h] of a series that is positive at first; None if it stays so."""
    power, scaled = arb(1), []
    for c in series:
        scaled.append(float(c * power))
        power *= h
    low = np.flatnonzero(np.polynomial.polynomial.polyval(_AT, scaled) <= 0.0)
    if not len(low):
        return None
    k = int(low[0])
    left, right = (float(_AT[k - 1]) if k else 0.0), float(_AT[k])
    for _ in range(50):
        middle = (left + right) / 2
        if np.polynomial.polynomial.polyval(middle, scaled) > 0.0:
            left = middle
        else:
            right = middle
    at, slope = (h * right).mid(), derivative(series)
    for _ in range(12):  # Newton
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
    phases: int = 0
    lifted: bool = False
    arrested: bool = False
    duration: arb = field(default_factory=arb)
    tops: list[arb] = field(default_factory=list)

    def state(self, t: arb) -> tuple[arb, arb]:
        """Rotation and angular velocity at a time, at rest after an arrest."""
        if not self.segments:
            return arb(0), arb(0)
        if t >= self.duration:
            rotation, omega = self.segments[-1].state(self.duration)
            return rotation, arb(0) if self.arrested else omega
        return next(s for s in reversed(self.segments) if s.start <= t).state(t)

    def peak(self) -> tuple[arb, arb]:
        """Time and angular velocity of the greatest speed."""
        times = [*(s.start for s in self.segments), *self.tops, self.duration]
        time = max(times, key=lambda t: abs(self.state(t)[1]))
        return time, self.state(time)[1]


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
    direction = 1 if p.omega > 0 else -1
    while True:  # over phases of one direction
        if omega == 0:
            direction = way(p, rotation, next(friction_series(piece_at(p, slip), slip, [], [])))
            if direction == 0:
                found.arrested, found.duration = True, time
                return found
        found.phases += 1
        dip = direction * (p.dip - rotation) if p.turns else direction * p.dip
        lifted = bool(p.press * dip.cos() + p.polar * omega**2 < p.water)
        last = "start"
        while last != "stop":  # over series
            if len(found.segments) > MOST_STEPS or time > LONGEST:
                raise Unfit
            found.lifted |= lifted
            piece = piece_at(p, slip)
            x, w, normal = expand(p, piece, lifted, dip, slip, omega, order)
            h = arb(reach(w, digits))
            events: dict[str, arb | None] = {"step": h}
            if p.end is not None:
                events["end"] = p.end - time
            if piece.end is not None:
                events["kink"] = zero([piece.end - slip, *(-c for c in x[1:])], h)
            if p.water != 0:
                # What is zero at first is divided by the time.
                gap = [-c if lifted else c for c in normal]
                events["change"] = zero(gap[1:] if last == "change" else gap, h)
            events["stop"] = zero(w if omega > 0 else w[1:], h)
            last, h = min(((e, t) for e, t in events.items() if t is not None), key=lambda event: float(event[1]))
            rate = derivative(w)
            top = zero(rate, h) if rate[0] > 0 else None
            if top is not None:
                found.tops.append(time + top)
            found.segments.append(Segment(time, direction, rotation, x, w))
            more, omega = horner(x, h), horner(w, h)
            rotation, time, slip = (rotation + direction * more).mid(), (time + h).mid(), (slip + more).mid()
            if p.turns:
                dip = (dip - more).mid()
                if dip < -arb.pi() / 2:
                    raise Unfit
            if last == "end":
                found.duration = time
                return found
            if last == "kink" and piece.end is not None:
                slip = piece.end
            if last == "change":
                lifted = not lifted
        omega = arb(0)
        if p.end is None and p.frictionless:
            found.duration = time
            return found


def piece_at(p: Problem, slip: arb) -> Piece:
    """The piece of friction that begins at this slip, or holds it."""
    return next(k for k in p.pieces if k.end is None or slip < k.end)


# --- the answer ------------------------------------------------------------------------------------------------------


def text(value: arb) -> str:
    """30 digits."""
    return value.mid().str(DIGITS, radius=False)


def answer(scene: Mapping[str, Any], shares: Sequence[float], bits: int, order: int, digits: int) -> dict[str, Any]:
    """The motion of a scene: full texts to 30 digits, and the times, at these shares of the duration, as doubles."""
    with ctx.workprec(bits):
        p = problem(scene)
        found = motion(p, order, digits)
        second, speed = (p.radius / p.gravity).sqrt(), (p.radius * p.gravity).sqrt()
        top, fastest = found.peak()
        duration = float(found.duration * second)
        times = [duration * share for share in shares] if found.segments else []
        states = [found.state(oracle.exact(t) / second) for t in times]
        return {
            "moves": bool(found.segments),
            "arrested": found.arrested,
            "phases": found.phases,
            "lifted": found.lifted,
            "duration": text(found.duration * second),
            "run_out": text(found.state(found.duration)[0] * p.radius),
            "peak_velocity": text(fastest * speed),
            "peak_time": text(top * second),
            "times": times,
            "displacement": [text(s[0] * p.radius) for s in states],
            "velocity": [text(s[1] * speed) for s in states],
        }


PLAIN = {"bits": 256, "order": 48, "digits": 42}
LONGER = {"bits": 320, "order": 60, "digits": 50}


def solve(scene: Mapping[str, Any], shares: Sequence[float]) -> dict[str, Any]:
    """The motion of a scene to 30 digits."""
    return answer(scene, shares, **PLAIN)


def agree(one: Any, two: Any) -> bool:
    """Whether two answers are the same to within their last digit."""
    if isinstance(one, dict):
        return one.keys() == two.keys() and all(agree(one[k], two[k]) for k in one)
    if isinstance(one, list):
        return len(one) == len(two) and all(map(agree, one, two))
    if isinstance(one, str):
        with ctx.workprec(256):
            return bool(abs(arb(one) - arb(two)) <= abs(arb(one)) * arb(10) ** (2 - DIGITS))
    return bool(one == two)


# --- the scenes ------------------------------------------------------------------------------------------------------

EFFECTS = list(product((False, True), ("", "ratio", "pressure"), (False, True), (False, True)))
GROUPS = {"frozen": 60, "constant": 100, "exponential": 50, "linear": 28, "hyperbolic": 28, "tabulated": 34}
NEAR = {"frozen": 4, "constant": 10, "exponential": 4, "tabulated": 2}  # the first of each, next to the limit
LIFTED = 6  # the last with constant friction: pushed up-slope, so that water carries them for a while


def names() -> list[tuple[str, int]]:
    """Each scene's group and number in it."""
    return [(group, k) for group, count in GROUPS.items() for k in range(count)]


def draw(group: str, number: int, rng: np.random.Generator) -> dict[str, Any]:
    """A random scene of a group, whose effects go through all combinations."""
    near, lifted = number < NEAR.get(group, 0), group == "constant" and number >= GROUPS[group] - LIFTED
    arc = _arc(rng)
    backwards = arc["theta_1"] + arc["theta_2"] > 3 * math.pi  # random signs of speeds have the sense of the angles
    m = {k: float(v) for k, v in moments(arc).items()}
    centripetal, water, cohesive, dragged = EFFECTS[number % len(EFFECTS)]
    turns = group != "frozen" and (group in ("constant", "exponential") or rng.random() < 0.8)
    if lifted:
        water = "pressure"
    if group == "exponential" and number % 2:
        centripetal = dragged = False
    fall, press = m["fall"] * abs(math.sin(m["dip"])), m["press"] * math.cos(m["dip"])
    effects: dict[str, dict[str, float]] = {}
    if turns:
        effects["rotation"] = {}
    if centripetal:
        effects["centripetal"] = {}
    held = 1.0
    if water == "ratio":
        effects["pore_pressure"] = {"ratio": rng.uniform(0.02, 0.7)}
        held -= effects["pore_pressure"]["ratio"]
    if water == "pressure":
        share = rng.uniform(0.95, 0.998) if lifted else rng.uniform(0.02, 0.7)
        effects["pore_pressure"] = {"pressure": share * press / m["level"] * m["reference_stress"]}
        held -= share
    strength = 0.0
    if cohesive:
        strength = rng.uniform(0.02, 0.5)
        effects["cohesion"] = {"cohesion": strength * fall / m["level"] * m["reference_stress"]}
    if dragged:
        size = 2 * m["half_angle"] * arc["gravity"] / m["inertia"]
        effects["drag"] = {"xi": size / 10 ** rng.uniform(-2.0, 2.0)}
    limit = fall * (1 - strength) / (press * held)

    speed = math.sqrt(arc["radius"] * arc["gravity"]) * 10 ** rng.uniform(-2.0, -0.2)
    start = rng.choice([0.0, speed, -speed], p=[0.8, 0.1, 0.1] if near else [0.55, 0.25, 0.2])
    if lifted:
        start = speed if backwards else -speed  # up-slope
    if near:
        friction = limit * (1 - 10 ** rng.uniform(-6.0, -3.0))
    elif start == 0.0:
        friction = limit * rng.choice(
            [rng.uniform(0.0, 0.98), rng.uniform(0.0, 0.3), 0.0, 1.2], p=[0.7, 0.2, 0.05, 0.05]
        )
    else:
        friction = limit * rng.choice([rng.uniform(0.0, 2.0), 0.0], p=[0.95, 0.05])
    period = math.sqrt(arc["radius"] / arc["gravity"])
    ends = rng.random() < (0.35 if turns else 0.8)
    return {
        "arc": arc,
        "friction": _law(group, friction, arc["radius"], rng),
        "effects": effects,
        "initial_velocity": -float(start) if backwards and start else float(start),
        "end_time": period * 10 ** rng.uniform(-1.0, 1.0) if ends else None,
    }


def _arc(rng: np.random.Generator) -> dict[str, float]:
    opening = 10 ** rng.uniform(-3.0, 0.0) if rng.random() < 0.3 else rng.uniform(0.2, 3.13)
    dip = math.radians(rng.uniform(3.0, 85.0)) * (-1.0 if rng.random() < 0.2 else 1.0)
    middle = 1.5 * math.pi - dip
    return {
        "radius": 10 ** rng.uniform(0.7, 3.5),
        "theta_1": middle - opening / 2,
        "theta_2": middle + opening / 2,
        "unit_weight": rng.uniform(15e3, 27e3),
        "gravity": 9.81 if rng.random() < 0.7 else rng.uniform(1.6, 25.0),
    }


def _law(group: str, friction: float, radius: float, rng: np.random.Generator) -> Any:
    """Friction that starts at this number and mostly falls with slip."""
    if group in ("frozen", "constant"):
        return float(friction)
    if group == "tabulated":
        count = int(rng.integers(2, 8))
        slip = np.cumsum([0.0, *(radius * 10 ** rng.uniform(-2.5, -0.5, count - 1))])
        values = friction * np.array([1.0, *rng.uniform(0.3, 1.0, count - 1)])
        if rng.random() < 0.6:
            values = np.sort(values)[::-1]
        return {"law": group, "slip": slip.tolist(), "coefficient": values.tolist()}
    change = rng.uniform(0.1, 0.95) if rng.random() < 0.85 else rng.uniform(1.0, 1.6)
    length = radius * 10 ** rng.uniform(-3.0, -0.3)
    return {"law": group, "peak": float(friction), "residual": float(friction * change), "length": float(length)}


def make(name: tuple[str, int]) -> dict[str, Any]:
    """The first scene of this name that comes to an end, its motion, and a check with longer series."""
    group, number = name
    for attempt in range(1000):
        rng = np.random.default_rng([SEED, list(GROUPS).index(group), number, attempt])
        scene = draw(group, number, rng)
        shares = rng.uniform(0.0, 1.0, 3).tolist()
        try:
            found = solve(scene, shares)
        except Unfit:
            continue
        if group == "constant" and number >= GROUPS[group] - LIFTED and not found["lifted"]:
            continue
        if not agree(found, answer(scene, shares, **LONGER)):
            raise ArithmeticError(f"{name}: no {DIGITS} digits")
        return {"group": group, "scene": scene, "shares": shares, "reference": found}
    raise ArithmeticError(f"{name}: no scene that ends")


def main() -> int:
    """Write the file."""
    rows = []
    with ProcessPoolExecutor() as pool:
        for row in pool.map(make, names()):
            rows.append(json.dumps(row))
            print(f"\r{len(rows)} of {len(names())} scenes", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    temporary = FILE.with_suffix(".tmp")
    temporary.write_text("[\n" + ",\n".join(rows) + "\n]\n", encoding="utf-8")
    os.replace(temporary, FILE)
    return 0


if __name__ == "__main__":
    sys.exit(main())
