"""A mass at rest: whether and which way it starts, now or, where something changes with time, later."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.balance import Balance
from slipcircle.checks import EPS
from slipcircle.friction import Friction
from slipcircle.methods.roots import highest, root

if TYPE_CHECKING:
    from slipcircle.motion import Phase

Floats = NDArray[np.float64]
_CHUNK = 64  # stretches between two kinks that are looked at together, at first
_SAMPLES = 33  # of a stretch, where what is given is curved


class Rest(NamedTuple):
    """Where the mass rests: rotation, accumulated slip in m, excess pore pressure over sigma_ref."""

    rotation: float
    slip: float
    excess: float = 0.0


def way(balance: Balance, law: Friction, rest: Rest) -> int:
    """The direction in which a mass at rest moves, 0 if it stays: by the limit friction, of which the drive is made."""
    for side in (1, -1):
        at = balance.position(rest.rotation, side) | {"excess": rest.excess}
        if balance.get("normal", **at) <= 0.0:
            moving = at["fall"] > balance.get("constant", **at, mu=0.0)
        else:
            moving = balance.get("limit_friction", **at) > float(law.coefficient(rest.slip))
        if moving:
            return side
    return 0


def next_start(
    balance: Balance, law: Friction, rest: Rest, time: float, end: float, two_way: bool
) -> tuple[float, int] | None:
    """When the mass starts, from a time on, and which way; None if it stays until the end.

    One-way, it starts only down-slope: the way in which gravity alone pulls it where it lies.
    """
    if not balance.forcing and not len(law.times):  # nothing changes while it rests
        side = way(balance, law, rest)
        return (time, side) if side else None
    kinks = kinks_of(balance, law)
    sides = (1, -1) if two_way or "k_h" not in balance.forcing else (down_slope(balance, rest.rotation),)
    found = [(t, side) for side in sides if (t := _start(balance, law, rest, time, end, side, kinks)) is not None]
    return min(found) if found else None


def kinks_of(balance: Balance, law: Friction) -> Floats:
    """Dimensionless times at which what changes with time is not smooth; none where nothing does."""
    if not len(law.times):
        return np.asarray(balance.kinks)
    return np.unique(np.concatenate([balance.kinks, np.asarray(law.times) / balance.time_scale]))


def down_slope(balance: Balance, rotation: float) -> int:
    """The direction in which gravity pulls."""
    return -1 if balance.position(rotation, 1)["fall"] < 0.0 else 1


def _start(
    balance: Balance, law: Friction, rest: Rest, time: float, end: float, side: int, kinks: Floats
) -> float | None:
    return _first(balance, _excess_of_drive(balance, law, rest, side), time, end, kinks)


def lift_at_rest(balance: Balance, law: Friction, rest: Rest, time: float, end: float) -> float | None:
    """When shaking or water first carries a mass that rests between two times; None if something presses throughout."""
    at = balance.position(rest.rotation, 1) | {"excess": rest.excess}
    if not balance.forcing:
        return time if float(balance.get("normal", **at)) < 0.0 else None
    return _first(balance, lambda t: -balance.get("normal", **at | balance.given(t)), time, end, kinks_of(balance, law))


def _first(balance: Balance, excess: Callable[[Any], Any], time: float, end: float, kinks: Floats) -> float | None:
    """The first time, from one to another, at which a function of what is given is above zero."""
    ahead = slice(np.searchsorted(kinks, time, side="right"), np.searchsorted(kinks, end))
    bounds = np.concatenate([[time], kinks[ahead], [end]])
    straight = all(getattr(f, "straight", False) for f, _ in balance.forcing.values())
    share = np.linspace(0.0, 1.0, 3 if straight else _SAMPLES)
    first, chunk = 0, _CHUNK
    while first < len(bounds) - 1:
        left = bounds[first : min(first + chunk, len(bounds) - 1)]
        right = bounds[first + 1 : first + len(left) + 1]
        right = np.where(np.isinf(right), 2 * left + 1.0, right)  # nothing changes any more
        early, late = np.nextafter(left, np.inf), np.nextafter(right, -np.inf)
        times = np.clip(left[:, None] + (right - left)[:, None] * share, early[:, None], late[:, None])
        values = excess(times)
        inner = values[:, 1:-1]
        hump = (inner > values[:, :-2]) & (inner >= values[:, 2:]) & (inner <= 0.0)
        hump &= -inner < inner - np.minimum(values[:, :-2], values[:, 2:])  # it may pass zero in between
        above = np.any(values > 0.0, axis=1) | np.any(hump, axis=1)
        for k in np.flatnonzero(above):
            t = _within(excess, times[k], values[k], left[k])
            if t is not None:
                return t
        first, chunk = first + len(left), min(2 * chunk, 64 * _CHUNK)
    return None


def _within(excess: Callable[[Any], Any], times: Floats, values: Floats, left: float) -> float | None:
    """The first time at which a function that is smooth here passes zero upwards."""
    for j in range(len(times)):
        low, high, at_high = float(times[max(j - 1, 0)]), float(times[j]), float(values[j])
        if at_high <= 0.0 and 0 < j < len(times) - 1 and values[j - 1] < at_high >= values[j + 1]:
            high = highest(lambda t: float(excess(t)), low, float(times[j + 1]))
            at_high = float(excess(high))
        if at_high > 0.0:
            if j == 0:
                return float(left)
            return root(lambda t: float(excess(t)), low, high, float(values[j - 1]), at_high)
    return None


def _excess_of_drive(balance: Balance, law: Friction, rest: Rest, side: int) -> Callable[[Any], Any]:
    """The drive less the resistance at rest, at dimensionless times."""
    at: dict[str, Any] = {**balance.position(rest.rotation, side), "excess": rest.excess, "omega": 0.0, "omega_2": 0.0}

    def excess(t: Any) -> Any:
        local = at | balance.given(t, side)
        mu = law.coefficient(rest.slip, 0.0, t * balance.time_scale)
        local["mu"] = np.where(balance.get("normal", **local) > 0.0, mu, 0.0)
        fall = balance.get("fall", **local) if balance.has("fall") else local["fall"]
        return fall - balance.get("resistance", **local)

    return excess


def never_rests(balance: Balance, law: Friction, excess: float) -> bool:
    """No strength without friction, and no friction, or water that carries the mass even where it would press most.

    Heat takes strength ever more slowly, and never all: what is left after a hundredth does not count.
    """
    if balance.get("constant", mu=0.0) > 0.0:
        return False
    most = balance.radial if balance.turns else balance.press
    frictionless = law.constant and float(law.coefficient(0.0)) == 0.0
    left = 0.01 * most if excess > 0.0 else 0.0
    return frictionless or balance.get("normal", press=most, excess=excess) <= left


def swings_left(balance: Balance, law: Friction, phases: "list[Phase]") -> float:
    """About how many swings it takes until friction holds the mass, if each takes as much as the last two did.

    Zero where that is not known: before three swings from rest to rest, where water carries the mass as it stands, or
    where something but the speed changes the friction.
    """
    swings = phases[-3:]
    known = set(law.depends_on) <= {"speed"} and not balance.forcing and not balance.has("pressurisation")
    if not known or len(swings) < 3 or any(p.solved.start.energy for p in swings):
        return 0.0
    first, last = (balance.position(p.rotation, p.direction) for p in swings[::2])
    if min(balance.get("normal", **first), balance.get("normal", **last)) <= 0.0:
        return 0.0
    before, now = (float(balance.get("limit_friction", **at)) for at in (first, last))
    return 2 * (now - float(law.coefficient(0.0))) / max(before - now, EPS * abs(now))
