"""One phase of many lanes: in the phase plane where the mass turns, in closed form where not; and its doubts."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import balance as functions
from generated import motion as formulas
from slipcircle.arrays.courses import Courses, Start
from slipcircle.arrays.paths import Paths
from slipcircle.arrays.swings import Swings
from slipcircle.checks import EPS
from slipcircle.uncertainty import ROUNDING

if TYPE_CHECKING:
    from slipcircle.arrays.block import Going, Lanes

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]
UNIT = ROUNDING * EPS
_COURSES = 256  # lanes at once there, where every lane has many points


def pick(value: Any, lanes: Any) -> Any:
    return value[lanes] if np.ndim(value) else value


class Followed(NamedTuple):
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
    mu: Any  # at its end
    doubt: Any = None  # of `Paths`


def turning(block: "Lanes", lanes: Any, at: Mapping[str, Any], mu: Any, g: "Going", until: Any) -> Followed:
    """A phase in the phase plane."""
    get, m = block.get, g.time.size
    arrays = (
        g.energy, block.drive(lanes, at, mu), get("tilt", lanes, **at, mu=mu), get("constant", lanes, mu=mu),
        get("brake", lanes, mu=mu), at["dip"] + np.pi / 2,
    )  # fmt: skip
    begin = Start(*(np.ascontiguousarray(np.broadcast_to(x, (m,))) for x in arrays))
    found = np.full((8, m), np.nan)
    good, cut, (x, energy) = np.zeros(m, bool), np.zeros(m, bool), np.zeros((2, m))
    left = np.broadcast_to(until - g.time, (m,))
    s = Swings(begin, block.accuracy, block.work)
    good[:] = s.good
    found[:] = s.end, s.duration, s.peak, s.top, s.peak_time, s.steep, s.missing, s.good
    early = np.flatnonzero(s.good & ~(s.duration < left))
    if len(early):
        x[early], energy[early], good[early] = s.reach(early, left[early])
        cut[early], found[6, early] = True, 1e-14
    needed = np.flatnonzero(~good)
    for k in range(0, len(needed), _COURSES):
        some = needed[k : k + _COURSES]
        c = Courses(block.balance.names["energy"], begin.some(some))
        found[:, some] = c.end, c.duration, c.peak, c.top, c.peak_time, c.steep, c.missing, c.good
        good[some], cut[some] = c.good, c.good & ~(c.duration < left[some])
        if np.any(cut[some]):
            x[some], energy[some] = c.reach(np.where(cut[some], left[some], c.duration / 2))
    rate = np.zeros(m)
    if np.any(cut):
        turned = begin.drive * np.cos(x) - begin.tilt * np.sin(x) - 2 * begin.constant * np.sin(x / 2) ** 2
        rate = turned - begin.brake * energy
    if block.water:
        good &= _pressing(block, lanes, at, g, found[0])
    first = begin.drive - begin.brake * g.energy
    end, duration, peak, top, peak_time, steep, missing, _ = found
    return Followed(end, duration, peak, top, peak_time, missing, good, cut, x, energy, rate, first, steep, mu)


def _pressing(block: "Lanes", lanes: Any, at: Mapping[str, Any], g: "Going", end: Floats) -> Mask:
    """Where the mass presses on the slip surface at both ends of a phase, and so in between."""
    last = block.at(lanes, g.rotation + g.direction * end)["press"] if block.balance.turns else at["press"]
    return np.asarray(
        (block.get("normal", lanes, press=at["press"]) > 0.0) & (block.get("normal", lanes, press=last) > 0.0)
    )


def softening(block: "Lanes", lanes: Any, at: Mapping[str, Any], mu: Any, g: "Going", until: Any) -> Followed:
    """A phase in which friction changes with slip."""
    get, b, m = block.get, block.balance, g.time.size
    water, brake = -get("normal", lanes, press=0.0), get("brake", lanes, mu=0.0)
    drive = np.broadcast_to(block.drive(lanes, at, mu), (m,))
    given = {
        "start": g.energy, "drive": drive, "mu": mu, "slip": g.slip, "left": until - g.time,
        "constant": get("constant", lanes, mu=0.0), "brake": brake, "brake_rise": get("brake", lanes, mu=1.0) - brake,
        "share": get("normal", lanes, press=1.0) + water, "water": water, "radius": pick(block.radius, lanes),
        "furthest": np.maximum(at["dip"] + np.pi / 2, 1e-20) if b.turns else np.inf,
    } | {n: at[n] for n in ("fall", "fall_slope", "press", "press_slope")}  # fmt: skip
    of = np.arange(block.size)[lanes]
    p = Paths(given, lambda k: block.friction(of[k]), b.turns, "brake" in b.names, block.accuracy)
    if block.water:
        p.good &= _pressing(block, lanes, at, g, p.end)
    first = drive - get("brake", lanes, mu=mu) * g.energy
    return Followed(p.end, p.duration, p.peak, p.top, p.peak_time, p.missing, p.good, p.cut, p.end, p.energy, p.rate,
                    first, np.abs(2 * p.rate), p.mu, p.doubt)  # fmt: skip


def frozen(block: "Lanes", lanes: Any, at: Mapping[str, Any], mu: Any, g: "Going", until: Any) -> Followed:
    """A phase with d(omega)/dt = a - b omega**2, as in `slipcircle.methods.frozen`."""
    m, names = g.time.size, block.balance.names
    a, b, omega = np.broadcast_arrays(block.drive(lanes, at, mu), block.get("brake", lanes, mu=mu), np.sqrt(g.energy))
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
    if block.water:
        good &= block.get("normal", lanes, press=at["press"]) > 0.0
    zero = np.zeros(m)
    return Followed(end, duration, zero, zero, zero, zero, good, cut, x, speed * speed, rate, a - b * g.energy, -a, mu)


def doubt(block: "Lanes", lanes: Any, at: Mapping[str, Any], mu: Any, g: "Going", f: Followed, stop: Floats) -> None:
    """Carry the doubts through a phase: `uncertainty` with bounds in the place of its sums over the path."""
    b = block.balance
    mu, least = np.maximum(mu, f.mu), np.minimum(mu, f.mu)
    fall, constant = np.abs(at["fall"]), np.abs(block.get("constant", lanes, mu=mu))
    drive = np.abs(f.first_rate)
    terms = UNIT * (fall + constant + mu * np.abs(block.get("normal", lanes, **at)))
    brake = block.get("brake", lanes, mu=least)
    if not b.turns and f.doubt is None:
        growth = UNIT + terms / np.maximum(np.abs(f.steep), 1e-300)
        x, elapsed = np.where(f.cut, f.x, f.end), np.where(f.cut, pick(block.until, lanes) - g.time, f.duration)
        memory = np.where(drive * brake > 0.0, np.minimum(elapsed, 1.0 / np.sqrt(drive * brake)), elapsed)
        top = np.sqrt(np.maximum(g.energy, f.energy))
        speed = np.where(f.cut, UNIT * (top + drive * elapsed) + terms * memory, growth * (top + drive * elapsed))
        g.place = np.maximum(g.place, np.where(f.cut, speed * elapsed + UNIT * x, growth * (x + top * elapsed)))
        g.place, g.speed = g.place + top * g.late, np.maximum(g.speed, speed + drive * g.late)
        g.late = g.late + np.where(f.cut, 0.0, growth * elapsed)
        return
    tilt = np.abs(block.get("tilt", lanes, **at, mu=mu))
    cut = bool(np.any(f.cut))
    x, elapsed = (np.where(f.cut, f.x, f.end), stop - g.time) if cut else (f.end, f.duration)
    shift = g.shift + 4 * EPS if g.phases else g.shift
    moved = terms + shift * (pick(b.weight, lanes) + mu * pick(b.radial, lanes))
    # A brake forgets what is further back than this.
    past: Any = 0.5 / brake if "brake" in b.names else np.inf
    bent, back = UNIT * tilt * np.minimum(x, 1.0), np.minimum(x, past)
    noise = (2 * moved + bent) * back
    own = ((2 * terms + bent) * back + UNIT * g.energy) / f.steep + UNIT * x
    # E grows from the start at least as twice the drive at first; from its end as it is steep there, where the
    # noise falls with it, and which the motion reaches as the root of what is left.
    rises = np.maximum(2 * drive, g.energy / x) if np.any(g.energy) else 2 * drive
    falls = np.sqrt((2 * moved + 2 * UNIT * tilt) * noise / x) / f.steep
    top, change = np.sqrt(f.top), np.maximum(drive, f.steep)
    if cut:
        own, falls = np.where(f.cut, 0.0, own), np.where(f.cut, np.fmin(falls, noise / f.energy), falls)
        top = np.where(f.cut, np.sqrt(np.maximum(g.energy, np.where(f.peak < x, f.top, f.energy))), top)
    spread = noise / x / rises if f.doubt is None else (moved + 0.5 * bent) * f.doubt / elapsed
    late = elapsed * (spread + falls + f.missing + UNIT)
    high = noise / np.maximum(top, 1e-300) + UNIT * top
    g.place = np.maximum(g.place, own + shift + top * (late + g.late))
    g.speed = np.maximum(g.speed, high + change * (late + g.late))
    g.shift, g.late = shift * 2 * drive * np.exp(-2 * brake * f.end) / f.steep + own, g.late + late
