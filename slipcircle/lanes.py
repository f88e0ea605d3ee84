"""A block of scenes as plain arrays, solved at once: one lane a scene, and no lane knows of another.

Lanes of a turning mass go through `slipcircle.swings`, what that does not take through `slipcircle.courses`, frozen
ones through their closed form in time; the few that lift off, or that need more, through the scalar solver.
"""

from collections.abc import Mapping
from dataclasses import dataclass, fields
from enum import IntEnum
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import balance as functions
from generated import motion as formulas
from generated.effects import ARGUMENTS, EFFECTS
from slipcircle.arc import QUANTITIES, Arc
from slipcircle.balance import Balance, bind_lanes
from slipcircle.courses import Courses, Start
from slipcircle.phaseplane import EPS
from slipcircle.plan import plan
from slipcircle.scene import Scene, bounds
from slipcircle.solver import solve_one
from slipcircle.swings import Swings, workspace
from slipcircle.uncertainty import ROUNDING

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]
LANES = 4096  # at once, so that what they need stays in the cache
_COURSES = 256  # lanes at once there, where every lane has many points
_UNIT = ROUNDING * EPS
_MOST_PHASES = 2000


class Status(IntEnum):
    """What became of a lane."""

    RESTS = 0  #: it moved, and came to rest without turning back
    STAYS = 1  #: it does not move
    MOVING = 2  #: it still moves at its end time, or nothing ever brings it to rest: then to its first standstill
    TURNED = 3  #: it turned back at least once, and came to rest
    ILL_CONDITIONED = 4  #: the estimated error is above the accuracy asked for
    FAILED = 5  #: no answer, as `solve` of this scene says: NaN
    INVALID = 6  #: its numbers are no scene: NaN


@dataclass(frozen=True)
class Block:
    """What became of the lanes of a block: arrays of one length; SI units; signs as in `slipcircle.motion.State`."""

    status: NDArray[np.int8]
    moves: Mask
    arrested: Mask
    duration: Floats
    rotation: Floats
    angular_velocity: Floats
    angular_acceleration: Floats
    peak_time: Floats
    peak_rotation: Floats
    peak_angular_velocity: Floats
    peak_angular_acceleration: Floats
    error_estimate: Floats


NAMES = tuple(f.name for f in fields(Block))
NUMBERS = NAMES[3:]


def solve_block(
    effects: tuple[str, ...], values: Mapping[str, Any], accuracy: float, law: Any = None, lanes: int | None = None
) -> Block:
    """Solve a block of scenes: a pure function of plain arrays.

    Parameters
    ----------
    effects : tuple of str
        In the order of `generated.effects.EFFECTS`.
    values : mapping
        Arrays of one length, or numbers: the arc's by name, ``friction``, ``initial_velocity``, ``end_time`` (infinite
        where there is none), and the effects' parameters as ``effect.parameter``, all of them; ``given`` as `Arc` takes
        it. They need not be valid: what is no scene has the status INVALID.
    accuracy : float
        Relative error asked for.
    law : mapping or callable, optional
        Friction that is not constant, as `Scene` takes it; ``values`` has its numbers as ``friction.name``, and they
        win. Such lanes go through the scalar solver, one by one.
    lanes : int, optional
        How many there are, where no value is an array.
    """
    size = max((len(v) for v in values.values() if np.ndim(v)), default=1) if lanes is None else lanes
    numbers = (np.full(size, np.nan) for _ in NUMBERS)
    out = Block(np.full(size, Status.FAILED, np.int8), np.zeros(size, bool), np.zeros(size, bool), *numbers)
    if law is not None:
        for k in range(size):
            _alone(out, k, effects, values, accuracy, law)
        return out
    work, shared = workspace(min(size, LANES)), None
    if not any(np.ndim(v) for n, v in values.items() if n not in ("friction", "initial_velocity", "end_time")):
        with np.errstate(all="ignore"):
            shared = _bind(effects, values)  # one for all lanes
    for first in range(0, size, LANES):
        part = slice(first, min(first + LANES, size))
        here = {n: v[part] if np.ndim(v) else v for n, v in values.items()}
        view = Block(*(getattr(out, n)[part] for n in NAMES))
        with np.errstate(all="ignore"):
            left = _Lanes(here, shared or _bind(effects, here), accuracy, view, work).solve()
        for lane in np.flatnonzero(left):
            _alone(out, first + int(lane), effects, values, accuracy, None)
    return out


def scene_of(effects: tuple[str, ...], values: Mapping[str, Any], k: int, law: Any = None) -> Scene:
    """One lane of `solve_block` as a scene of plain numbers."""
    at = {n: float(v[k] if np.ndim(v) else v) for n, v in values.items() if n != "given"}
    sizes: dict[str, Any] = {n: at[n] for n in QUANTITIES if n in at}
    arc = Arc(**sizes, given=values.get("given"))
    if isinstance(law, Mapping):
        law = {n: at.get(f"friction.{n}", value) for n, value in law.items()}
    called = {e: {p.name: at[f"{e}.{p.name}"] for p in EFFECTS[e].parameters} for e in effects}
    end = None if at["end_time"] == np.inf else at["end_time"]
    return Scene(arc, at["friction"] if law is None else law, called, at["initial_velocity"], end)


def _bind(effects: tuple[str, ...], values: Mapping[str, Any]) -> tuple[Balance, Any]:
    """The balance, and the scale of time."""
    arc = Arc.unchecked(**{n: values[n] for n in (*QUANTITIES, "given") if n in values})
    return bind_lanes(effects, arc, values), arc.time_scale


def _alone(out: Block, k: int, effects: tuple[str, ...], values: Mapping[str, Any], accuracy: float, law: Any) -> None:
    """Solve a lane by the scalar solver."""
    try:
        scene = scene_of(effects, values, k, law)
    except ValueError:
        out.status[k] = Status.INVALID
        return
    try:
        with np.errstate(under="ignore"):
            motion = solve_one(plan(scene, accuracy))
            end, peak, error = motion.end, motion.peak, motion.error_estimate
    except ValueError:
        return
    arc = motion.plan.scene.arc
    found = {
        "moves": motion.moves, "arrested": motion.arrested, "duration": motion.duration,
        "rotation": end.rotation, "angular_velocity": end.angular_velocity,
        "angular_acceleration": end.acceleration / arc.radius, "peak_time": peak.time, "peak_rotation": peak.rotation,
        "peak_angular_velocity": peak.angular_velocity, "peak_angular_acceleration": peak.acceleration / arc.radius,
        "error_estimate": error,
    }  # fmt: skip
    for name, value in found.items():
        getattr(out, name)[k] = value
    turned = len({p.direction for p in motion.phases}) > 1
    status = Status.STAYS if not motion.moves else Status.MOVING if not motion.arrested else Status.RESTS
    status = Status.TURNED if status == Status.RESTS and turned else status
    out.status[k] = Status.ILL_CONDITIONED if error > accuracy else status


def _pick(value: Any, lanes: Any) -> Any:
    return value[lanes] if np.ndim(value) else value


@dataclass
class _Going:
    """Lanes on their way, where a phase begins: which, and all dimensionless, with the doubts of `uncertainty`."""

    lanes: Any  # their indices, or all
    time: Floats
    rotation: Floats
    direction: Floats
    energy: Floats
    best: Floats  # time, rotation, omega and its rate where the speed was greatest so far
    shift: Floats  # error of the rotation, of the time, and the greatest ones of place and speed at a given time
    late: Floats
    place: Floats
    speed: Floats
    phases: int = 0

    def keep(self, mask: Mask, direction: Floats, rotation: Floats, time: Floats) -> "_Going":
        """The lanes that turn back, at the standstill."""
        lanes = np.flatnonzero(mask) if isinstance(self.lanes, slice) else self.lanes[mask]
        shift, late, place, speed = (x[mask] for x in (self.shift, self.late, self.place, self.speed))
        at = time[mask], rotation[mask], direction[mask], np.zeros(len(lanes)), self.best[:, mask]
        return _Going(lanes, *at, shift, late, place, speed, self.phases + 1)


class _Followed(NamedTuple):
    """A phase of each lane, dimensionless: up to its standstill, and the state where its time is over before."""

    end: Floats
    duration: Floats
    peak: Floats
    top: Floats
    peak_time: Floats
    missing: Floats
    good: Mask
    cut: Mask
    x: Floats
    energy: Floats
    rate: Floats
    first_rate: Floats
    steep: Floats


def _seen(at: Mapping[str, Any], direction: Any) -> dict[str, Any]:
    """A position in the direction of travel: a mirror, where it is negative."""
    return dict(at) | {n: direction * at[n] for n in ("fall", "static_limit", "press_slope", "dip")}


class _Lanes:
    """The lanes of a block while they are solved, phase after phase."""

    def __init__(
        self, values: Mapping[str, Any], bound: tuple[Balance, Any], accuracy: float, out: Block, work: Floats
    ) -> None:
        self.values, self.accuracy, self.out, self.work = values, accuracy, out, work
        (self.balance, self.scale), self.size, self.radius = bound, len(out.status), np.asarray(values["radius"])
        self.mu = np.asarray(values["friction"], dtype=np.float64)
        self.omega = values["initial_velocity"] / self.radius * self.scale
        self.until = np.asarray(values["end_time"] / self.scale)
        self.water = bool(np.any(np.asarray(values.get("pore_pressure.pressure", 0.0)) > 0.0))
        self.alone = np.zeros(self.size, bool)

    def solve(self) -> Mask:
        """Fill the block, and tell which lanes are left to the scalar solver."""
        n, out, everything = self.size, self.out, slice(None)
        valid = self._valid()
        out.status[~valid] = Status.INVALID
        energy, direction = self.omega * self.omega, np.sign(self.omega)
        if np.any(energy == 0.0):
            direction = np.where(energy == 0.0, self._way(everything, self._at(everything, None))[0], direction)
        energy, direction = np.broadcast_to(energy, (n,)), np.broadcast_to(direction, (n,))
        stays, moves = valid & (direction == 0.0), valid & (direction != 0.0)
        if np.any(stays):
            self._stay(stays)
        lanes = everything if np.all(moves) else np.flatnonzero(moves)
        energy, direction = energy[lanes], direction[lanes]
        zero = np.zeros_like(energy)
        going = _Going(lanes, zero, zero, direction, energy, np.zeros((4, energy.size)), zero, zero, zero, zero)
        while going.time.size:
            going = self._phase(going)
        return self.alone

    def _valid(self) -> Mask:
        """Lanes whose numbers are a scene; what makes NaN of the coefficients is none either."""
        good = np.greater(self.values["theta_2"], self.values["theta_1"]) & (self.balance.press > 0.0)
        good = good & np.isfinite(self.balance.fall)
        for name, (lower, upper) in bounds(self.values).items():
            good = good & (np.asarray(self.values[name]) > lower) & (np.asarray(self.values[name]) < upper)
        return np.broadcast_to(good & (self.until > 0.0), (self.size,))

    # -- the balance

    def _at(self, lanes: Any, rotation: Any) -> dict[str, Any]:
        """`Balance.position` of arrays in the mass's own sense, at the start for no rotation."""
        b = self.balance
        dip, fall, press = _pick(b.dip, lanes), _pick(b.fall, lanes), _pick(b.press, lanes)
        limit = _pick(b.static_limit, lanes)
        slope, rise = _pick(b.weight, lanes) * np.cos(dip), _pick(b.radial, lanes) * np.sin(dip)
        if b.turns and rotation is not None:
            half = np.tan(rotation / 2)
            square = half * half
            cos, sin, tan = (1.0 - square) / (1.0 + square), 2 * half / (1.0 + square), 2 * half / (1.0 - square)
            limit = (limit - slope / press * tan) / (1.0 + rise / press * tan)
            fall, slope = fall * cos - slope * sin, slope * cos + fall * sin
            press, rise, dip = press * cos + rise * sin, rise * cos - press * sin, dip - rotation
        return {"fall": fall, "press": press, "static_limit": limit, "fall_slope": slope, "press_slope": -rise,
                "dip": dip}  # fmt: skip

    def _get(self, what: str, lanes: Any, /, **local: Any) -> Any:
        """`Balance.get` for some lanes."""
        name = self.balance.names.get(what)
        if name is None:
            return 0.0
        values = self.balance.values
        given = [local[a] if a in local else _pick(values[a], lanes) for a in ARGUMENTS[name]]
        return getattr(functions, name)(*given)

    def _way(self, lanes: Any, at: Mapping[str, Any]) -> tuple[Floats, Floats]:
        """`solver._way` of arrays, and by how much it was decided."""
        mu, way, margin = _pick(self.mu, lanes), np.asarray(0.0), np.asarray(np.inf)
        lifted, held = self._get("normal", lanes, **at) <= 0.0, self._get("constant", lanes, mu=0.0)
        carried = np.any(lifted)
        for side in (-1.0, 1.0):
            seen = _seen(at, side)
            limit = self._get("limit_friction", lanes, **seen)
            moving, near = limit > mu, np.abs(limit - mu) / (np.abs(limit) + mu)
            if carried:
                moving, near = np.where(lifted, seen["fall"] > held, moving), np.where(lifted, 0.0, near)
            way, margin = np.where(moving, side, way), np.fmin(margin, near)
        return way, margin

    def _drive(self, lanes: Any, at: Mapping[str, Any], mu: Any) -> Any:
        """`Balance.drive` of arrays."""
        normal = self._get("normal", lanes, **at)
        limit = self._get("limit_friction", lanes, **at)
        drive = self._get("drive", lanes, **at, mu=mu, limit_friction=limit)
        if not self.water:
            return drive
        carried = at["fall"] - self._get("constant", lanes, mu=0.0) - mu * normal
        return np.where(normal <= 1e-6 * at["press"], carried, drive)

    # -- a phase

    def _stay(self, stays: Mask) -> None:
        """Lanes that do not move: undecided where the drive is the resistance, to rounding."""
        out, b, mu = self.out, self.balance, self.mu
        at = _seen(self._at(slice(None), None), np.where(np.less(b.fall, 0.0), -1.0, 1.0))
        held = self._get("resistance", slice(None), **at, mu=mu, omega_2=0.0)
        noise = _UNIT * (at["fall"] + mu * at["press"] + held)
        error = np.broadcast_to(np.where(np.abs(at["fall"] - held) < noise, 1.0, 0.0), (self.size,))[stays]
        for name in NUMBERS:
            getattr(out, name)[stays] = 0.0
        out.arrested[stays], out.error_estimate[stays] = True, error
        out.status[stays] = np.where(error > self.accuracy, Status.ILL_CONDITIONED, Status.STAYS)

    def _phase(self, g: _Going) -> _Going:
        """Follow lanes to their next standstill or their end time; which turn back from there."""
        lanes, b = g.lanes, self.balance
        at = _seen(self._at(lanes, g.rotation if g.phases else None), g.direction)
        mu, until = _pick(self.mu, lanes), _pick(self.until, lanes)
        f = (self._turning if b.turns else self._frozen)(lanes, at, mu, g, until)
        if not g.phases and np.any(g.energy):
            zero, omega = np.zeros_like(g.time), np.sqrt(g.energy)
            g.best = np.stack([zero, zero, g.direction * omega, g.direction * f.first_rate])
        stop, speed, when = g.time + f.duration, np.sqrt(f.top), g.time + f.peak_time
        summit = when, g.rotation + g.direction * f.peak, g.direction * speed, 0.0 * speed
        cut = bool(np.any(f.cut))
        if cut:
            stop = np.where(f.cut, until, stop)
        if g.best.any() or cut:
            g.best = np.where((speed > np.abs(g.best[2])) & (when <= stop), summit, g.best)
        else:
            g.best = np.stack(summit)
        self._doubt(lanes, at, mu, g, f, stop)
        rotation = g.rotation + g.direction * (np.where(f.cut, f.x, f.end) if cut else f.end)
        way, margin = self._way(lanes, self._at(lanes, rotation if b.turns else None))
        still = (mu == 0.0) & (_pick(b.values.get("cohesion", 0.0), lanes) == 0.0) & np.isinf(until) & b.turns
        moving = f.cut | still  # at its end time, or without anything that brings it to rest
        alone = ~(f.good & (moving | (margin >= 1e-9)))
        rests = ~(moving | alone)
        turns = rests & (way != 0.0)
        self.alone[lanes] |= alone | (turns & (g.phases >= _MOST_PHASES))
        done = ~(alone | turns) & np.isfinite(stop)
        if np.any(done):
            self._finish(g, f, done, rests, rotation, stop)
        return g.keep(turns & (g.phases < _MOST_PHASES), np.broadcast_to(way, stop.shape), rotation, stop)

    def _finish(self, g: _Going, f: _Followed, done: Mask, rests: Mask, rotation: Floats, stop: Floats) -> None:
        """Write the lanes that are done."""
        out, scale = self.out, _pick(self.scale, g.lanes)
        best, omega, rate, duration = g.best, np.asarray(0.0), np.asarray(0.0), stop * scale
        if np.any(f.cut):
            omega, rate = np.where(f.cut, g.direction * [np.sqrt(f.energy), f.rate], 0.0)
            best = np.where(np.abs(best[2]) > np.abs(omega), best, [stop, rotation, omega, rate])
            duration = np.where(f.cut, _pick(np.asarray(self.values["end_time"]), g.lanes), duration)
        error = np.maximum(g.place / np.abs(rotation), g.speed / np.abs(best[2]))
        error = np.fmin(np.maximum(error, g.late / stop) + _UNIT, 1.0)
        status = np.where(rests, np.int8(Status.TURNED if g.phases else Status.RESTS), np.int8(Status.MOVING))
        found = {
            "status": np.where(error > self.accuracy, np.int8(Status.ILL_CONDITIONED), status),
            "moves": np.asarray(True), "arrested": rests, "duration": duration, "rotation": rotation,
            "angular_velocity": omega / scale, "angular_acceleration": rate / scale**2,
            "peak_time": np.minimum(best[0] * scale, duration), "peak_rotation": best[1],
            "peak_angular_velocity": best[2] / scale, "peak_angular_acceleration": best[3] / scale**2,
            "error_estimate": error,
        }  # fmt: skip
        lanes: Any = g.lanes
        chosen: Any = slice(None)
        if not np.all(done):
            lanes, chosen = np.flatnonzero(done) if isinstance(lanes, slice) else lanes[done], done
        for name, value in found.items():
            getattr(out, name)[lanes] = value[chosen] if value.ndim else value

    def _turning(self, lanes: Any, at: Mapping[str, Any], mu: Any, g: _Going, until: Any) -> _Followed:
        """A phase in the phase plane."""
        get, m = self._get, g.time.size
        arrays = (
            g.energy, self._drive(lanes, at, mu), get("tilt", lanes, **at, mu=mu), get("constant", lanes, mu=mu),
            get("brake", lanes, mu=mu), at["dip"] + np.pi / 2,
        )  # fmt: skip
        begin = Start(*(np.ascontiguousarray(np.broadcast_to(x, (m,))) for x in arrays))
        found = np.full((8, m), np.nan)
        good, cut, (x, energy) = np.zeros(m, bool), np.zeros(m, bool), np.zeros((2, m))
        left = np.broadcast_to(until - g.time, (m,))
        s = Swings(begin, self.accuracy, self.work)
        good[:] = s.good
        found[:] = s.end, s.duration, s.peak, s.top, s.peak_time, s.steep, s.missing, s.good
        early = np.flatnonzero(s.good & ~(s.duration < left))
        if len(early):
            x[early], energy[early], good[early] = s.reach(early, left[early])
            cut[early], found[6, early] = True, 1e-14
        needed = np.flatnonzero(~good)
        for k in range(0, len(needed), _COURSES):
            some = needed[k : k + _COURSES]
            c = Courses(self.balance.names["energy"], begin.some(some))
            found[:, some] = c.end, c.duration, c.peak, c.top, c.peak_time, c.steep, c.missing, c.good
            good[some], cut[some] = c.good, c.good & ~(c.duration < left[some])
            if np.any(cut[some]):
                x[some], energy[some] = c.reach(np.where(cut[some], left[some], c.duration / 2))
        rate = np.zeros(m)
        if np.any(cut):
            turned = begin.drive * np.cos(x) - begin.tilt * np.sin(x) - 2 * begin.constant * np.sin(x / 2) ** 2
            rate = turned - begin.brake * energy
        if self.water:
            last = begin.drive * 0.0 + self._at(lanes, g.rotation + g.direction * found[0])["press"]
            good &= (get("normal", lanes, press=at["press"]) > 0.0) & (get("normal", lanes, press=last) > 0.0)
        first = begin.drive - begin.brake * g.energy
        end, duration, peak, top, peak_time, steep, missing, _ = found
        return _Followed(end, duration, peak, top, peak_time, missing, good, cut, x, energy, rate, first, steep)

    def _frozen(self, lanes: Any, at: Mapping[str, Any], mu: Any, g: _Going, until: Any) -> _Followed:
        """A phase with d(omega)/dt = a - b omega**2, as in `slipcircle.frozen`."""
        m, names = g.time.size, self.balance.names
        a, b, omega = np.broadcast_arrays(
            self._drive(lanes, at, mu), self._get("brake", lanes, mu=mu), np.sqrt(g.energy)
        )
        braked = "brake" in names
        known = (a, b, omega) if braked else (a, omega)
        stops = a < 0.0
        safe = (np.where(stops, a, -1.0), *known[1:])
        time, way = (
            getattr(formulas, f"_frozen{'_centripetal' if braked else ''}_arrest_{n}") for n in ("time", "rotation")
        )
        duration, end = np.where(stops, time(*safe), np.inf), np.where(stops, way(*safe), np.inf)
        left = np.broadcast_to(until - g.time, (m,))
        cut = g.time + duration >= until
        state = getattr(functions, f"frozen{'_braked' if braked else ''}_state")
        x, speed, rate = np.broadcast_arrays(*state(*known, np.where(cut, left, 0.0)), left)[:3]
        good = np.isinf(left) | (np.isfinite(x) & np.isfinite(speed))  # never rests, or overflows
        if self.water:
            good &= self._get("normal", lanes, press=at["press"]) > 0.0
        zero = np.zeros(m)
        return _Followed(end, duration, zero, zero, zero, zero, good, cut, x, speed * speed, rate, a - b * g.energy, -a)

    def _doubt(self, lanes: Any, at: Mapping[str, Any], mu: Any, g: _Going, f: _Followed, stop: Floats) -> None:
        """Carry the doubts through a phase: `uncertainty` with bounds in the place of its sums over the path."""
        b = self.balance
        fall, constant = np.abs(at["fall"]), np.abs(self._get("constant", lanes, mu=mu))
        drive = np.abs(f.first_rate)
        terms = _UNIT * (fall + constant + mu * np.abs(self._get("normal", lanes, **at)))
        brake = self._get("brake", lanes, mu=mu)
        if not b.turns:
            growth = _UNIT + terms / np.maximum(np.abs(f.steep), 1e-300)
            x, elapsed = np.where(f.cut, f.x, f.end), np.where(f.cut, _pick(self.until, lanes) - g.time, f.duration)
            memory = np.where(drive * brake > 0.0, np.minimum(elapsed, 1.0 / np.sqrt(drive * brake)), elapsed)
            top = np.sqrt(np.maximum(g.energy, f.energy))
            speed = np.where(f.cut, _UNIT * (top + drive * elapsed) + terms * memory, growth * (top + drive * elapsed))
            g.place = np.maximum(g.place, np.where(f.cut, speed * elapsed + _UNIT * x, growth * (x + top * elapsed)))
            g.place, g.speed = g.place + top * g.late, np.maximum(g.speed, speed + drive * g.late)
            g.late = g.late + np.where(f.cut, 0.0, growth * elapsed)
            return
        tilt = np.abs(self._get("tilt", lanes, **at, mu=mu))
        cut = bool(np.any(f.cut))
        x, elapsed = (np.where(f.cut, f.x, f.end), stop - g.time) if cut else (f.end, f.duration)
        shift = g.shift + 4 * EPS if g.phases else g.shift
        moved = terms + shift * (_pick(b.weight, lanes) + mu * _pick(b.radial, lanes))
        # A brake forgets what is further back than this.
        memory = 0.5 / brake if "brake" in b.names else np.inf
        bent, back = _UNIT * tilt * np.minimum(x, 1.0), np.minimum(x, memory)
        noise = (2 * moved + bent) * back
        own = ((2 * terms + bent) * back + _UNIT * g.energy) / f.steep + _UNIT * x
        # E grows from the start at least as twice the drive at first; from its end as it is steep there, where the
        # noise falls with it, and which the motion reaches as the root of what is left.
        rises = np.maximum(2 * drive, g.energy / x) if np.any(g.energy) else 2 * drive
        falls = np.sqrt((2 * moved + 2 * _UNIT * tilt) * noise / x) / f.steep
        top, change = np.sqrt(f.top), np.maximum(drive, f.steep)
        if cut:
            own, falls = np.where(f.cut, 0.0, own), np.where(f.cut, np.fmin(falls, noise / f.energy), falls)
            top = np.where(f.cut, np.sqrt(np.maximum(g.energy, np.where(f.peak < x, f.top, f.energy))), top)
        late = elapsed * (noise / x / rises + falls + f.missing + _UNIT)
        high = noise / np.maximum(top, 1e-300) + _UNIT * top
        g.place = np.maximum(g.place, own + shift + top * (late + g.late))
        g.speed = np.maximum(g.speed, high + change * (late + g.late))
        g.shift, g.late = shift * 2 * drive * np.exp(-2 * brake * f.end) / f.steep + own, g.late + late
