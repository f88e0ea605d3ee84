"""Lanes on their way, phase after phase, until each rests or its time is over; no lane knows of another."""

from collections.abc import Mapping
from dataclasses import dataclass, fields
from enum import IntEnum
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated import balance as functions
from generated.effects import ARGUMENTS
from slipcircle.arrays.following import UNIT, Followed, doubt, frozen, pick, turning
from slipcircle.balance import Balance
from slipcircle.scene import bounds

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]
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


@dataclass
class Going:
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

    def keep(self, mask: Mask, direction: Floats, rotation: Floats, time: Floats) -> "Going":
        """The lanes that turn back, at the standstill."""
        lanes = np.flatnonzero(mask) if isinstance(self.lanes, slice) else self.lanes[mask]
        shift, late, place, speed = (x[mask] for x in (self.shift, self.late, self.place, self.speed))
        at = time[mask], rotation[mask], direction[mask], np.zeros(len(lanes)), self.best[:, mask]
        return Going(lanes, *at, shift, late, place, speed, self.phases + 1)


def _seen(at: Mapping[str, Any], direction: Any) -> dict[str, Any]:
    """A position in the direction of travel: a mirror, where it is negative."""
    return dict(at) | {n: direction * at[n] for n in ("fall", "static_limit", "press_slope", "dip")}


class Lanes:
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
            direction = np.where(energy == 0.0, self._way(everything, self.at(everything, None))[0], direction)
        energy, direction = np.broadcast_to(energy, (n,)), np.broadcast_to(direction, (n,))
        stays, moves = valid & (direction == 0.0), valid & (direction != 0.0)
        if np.any(stays):
            self._stay(stays)
        lanes = everything if np.all(moves) else np.flatnonzero(moves)
        energy, direction = energy[lanes], direction[lanes]
        zero = np.zeros_like(energy)
        going = Going(lanes, zero, zero, direction, energy, np.zeros((4, energy.size)), zero, zero, zero, zero)
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

    def at(self, lanes: Any, rotation: Any) -> dict[str, Any]:
        """`Balance.position` of arrays in the mass's own sense, at the start for no rotation."""
        b = self.balance
        dip, fall, press = pick(b.dip, lanes), pick(b.fall, lanes), pick(b.press, lanes)
        limit = pick(b.static_limit, lanes)
        slope, rise = pick(b.weight, lanes) * np.cos(dip), pick(b.radial, lanes) * np.sin(dip)
        if b.turns and rotation is not None:
            half = np.tan(rotation / 2)
            square = half * half
            cos, sin, tan = (1.0 - square) / (1.0 + square), 2 * half / (1.0 + square), 2 * half / (1.0 - square)
            limit = (limit - slope / press * tan) / (1.0 + rise / press * tan)
            fall, slope = fall * cos - slope * sin, slope * cos + fall * sin
            press, rise, dip = press * cos + rise * sin, rise * cos - press * sin, dip - rotation
        return {"fall": fall, "press": press, "static_limit": limit, "fall_slope": slope, "press_slope": -rise,
                "dip": dip}  # fmt: skip

    def get(self, what: str, lanes: Any, /, **local: Any) -> Any:
        """`Balance.get` for some lanes."""
        name = self.balance.names.get(what)
        if name is None:
            return 0.0
        values = self.balance.values
        given = [local[a] if a in local else pick(values[a], lanes) for a in ARGUMENTS[name]]
        return getattr(functions, name)(*given)

    def _way(self, lanes: Any, at: Mapping[str, Any]) -> tuple[Floats, Floats]:
        """`solver._way` of arrays, and by how much it was decided."""
        mu, way, margin = pick(self.mu, lanes), np.asarray(0.0), np.asarray(np.inf)
        lifted, held = self.get("normal", lanes, **at) <= 0.0, self.get("constant", lanes, mu=0.0)
        carried = np.any(lifted)
        for side in (-1.0, 1.0):
            seen = _seen(at, side)
            limit = self.get("limit_friction", lanes, **seen)
            moving, near = limit > mu, np.abs(limit - mu) / (np.abs(limit) + mu)
            if carried:
                moving, near = np.where(lifted, seen["fall"] > held, moving), np.where(lifted, 0.0, near)
            way, margin = np.where(moving, side, way), np.fmin(margin, near)
        return way, margin

    def drive(self, lanes: Any, at: Mapping[str, Any], mu: Any) -> Any:
        """`Balance.drive` of arrays."""
        normal = self.get("normal", lanes, **at)
        limit = self.get("limit_friction", lanes, **at)
        drive = self.get("drive", lanes, **at, mu=mu, limit_friction=limit)
        if not self.water:
            return drive
        carried = at["fall"] - self.get("constant", lanes, mu=0.0) - mu * normal
        return np.where(normal <= 1e-6 * at["press"], carried, drive)

    # -- a phase

    def _stay(self, stays: Mask) -> None:
        """Lanes that do not move: undecided where the drive is the resistance, to rounding."""
        out, b, mu = self.out, self.balance, self.mu
        at = _seen(self.at(slice(None), None), np.where(np.less(b.fall, 0.0), -1.0, 1.0))
        held = self.get("resistance", slice(None), **at, mu=mu, omega_2=0.0)
        noise = UNIT * (at["fall"] + mu * at["press"] + held)
        error = np.broadcast_to(np.where(np.abs(at["fall"] - held) < noise, 1.0, 0.0), (self.size,))[stays]
        for name in NUMBERS:
            getattr(out, name)[stays] = 0.0
        out.arrested[stays], out.error_estimate[stays] = True, error
        out.status[stays] = np.where(error > self.accuracy, Status.ILL_CONDITIONED, Status.STAYS)

    def _phase(self, g: Going) -> Going:
        """Follow lanes to their next standstill or their end time; which turn back from there."""
        lanes, b = g.lanes, self.balance
        at = _seen(self.at(lanes, g.rotation if g.phases else None), g.direction)
        mu, until = pick(self.mu, lanes), pick(self.until, lanes)
        f = (turning if b.turns else frozen)(self, lanes, at, mu, g, until)
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
        doubt(self, lanes, at, mu, g, f, stop)
        rotation = g.rotation + g.direction * (np.where(f.cut, f.x, f.end) if cut else f.end)
        way, margin = self._way(lanes, self.at(lanes, rotation if b.turns else None))
        still = (mu == 0.0) & np.isinf(until) & b.turns
        if np.any(still):
            still &= pick(b.get("constant", mu=0.0), lanes) == 0.0
        moving = f.cut | still  # at its end time, or without anything that brings it to rest
        alone = ~(f.good & (moving | (margin >= 1e-9)))
        rests = ~(moving | alone)
        turns = rests & (way != 0.0)
        self.alone[lanes] |= alone | (turns & (g.phases >= _MOST_PHASES))
        done = ~(alone | turns) & np.isfinite(stop)
        if np.any(done):
            self._finish(g, f, done, rests, rotation, stop)
        return g.keep(turns & (g.phases < _MOST_PHASES), np.broadcast_to(way, stop.shape), rotation, stop)

    def _finish(self, g: Going, f: Followed, done: Mask, rests: Mask, rotation: Floats, stop: Floats) -> None:
        """Write the lanes that are done."""
        out, scale = self.out, pick(self.scale, g.lanes)
        best, omega, rate, duration = g.best, np.asarray(0.0), np.asarray(0.0), stop * scale
        if np.any(f.cut):
            omega, rate = np.where(f.cut, g.direction * [np.sqrt(f.energy), f.rate], 0.0)
            best = np.where(np.abs(best[2]) > np.abs(omega), best, [stop, rotation, omega, rate])
            duration = np.where(f.cut, pick(np.asarray(self.values["end_time"]), g.lanes), duration)
        error = np.maximum(g.place / np.abs(rotation), g.speed / np.abs(best[2]))
        error = np.fmin(np.maximum(error, g.late / stop) + UNIT, 1.0)
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
