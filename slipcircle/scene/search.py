"""The critical circle of a slope: a coarse family of all circles at once, then the best of its valleys refined."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from slipcircle.base.checks import raise_all
from slipcircle.scene import circles
from slipcircle.scene.circles import Floats
from slipcircle.scene.ground import circle_through, circle_touching
from slipcircle.scene.section import Section
from slipcircle.scene.stability import METHODS, Slope, factors

_PLACES = 36  # along the ground, besides its vertices
_VERTICES = 40  # of the ground in the coarse family; beyond, those nearest to even places
_SHARES = np.array([0.04, 0.08, 0.13, 0.19, 0.26, 0.34, 0.43, 0.53, 0.64, 0.76, 0.88, 1.0])
_VALLEYS = 12
_ROUNDS, _SHRINK = 150, 0.6
_EDGES = 1 << 17  # of the ground times circles, at a time
_HOPE, _AGAIN = 1.2, 3  # far above the best, a circle is left; the best of all are followed twice
_FINE = 1e-5  # step at which a valley is done, over its first
_APART = 2.5  # spacings of the coarse family between circles that are followed
_OFFSETS = np.stack(np.meshgrid(*[[-1.0, 0.0, 1.0]] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
Range = tuple[float, float]


@dataclass(frozen=True)
class Critical:
    """The critical circle and what it took to find it.

    Attributes
    ----------
    method : str
        Whose factor is the least.
    factor_of_safety : dict
        By method, of this circle; None where a method refuses it.
    centre, radius : tuple of float, float
        m.
    entry, exit : tuple of float
        Upper and lower end of the slip surface, m.
    facing : int
        1 where the mass slides to the right, -1 to the left.
    tried, refused : int
        Circles, and those of them without a factor: off the ground, too shallow, below the base, lifted, overhanging,
        or with m_alpha below 0.05.
    negative : float
        Share of the arc under negative effective normal stress by the ordinary method.
    centres, values : ndarray
        Of every circle that was tried: its centre, (tried, 2), and its least factor or NaN; for a map.
    warning : str
        That the circle reaches an end of the ground, beyond which a lesser factor may lie.
    """

    method: str
    factor_of_safety: dict[str, float | None]
    centre: tuple[float, float]
    radius: float
    entry: tuple[float, float]
    exit: tuple[float, float]
    facing: int
    tried: int
    refused: int
    negative: float
    centres: Floats = field(repr=False, compare=False)
    values: Floats = field(repr=False, compare=False)
    warning: str = ""

    @property
    def between(self) -> tuple[float, float]:
        """x of both ends, from left to right: which of the circle's stretches it is."""
        left, right = sorted((self.entry[0], self.exit[0]))
        return left, right

    def record(self) -> dict[str, Any]:
        """For JSON, in SI units."""
        return {
            "factor_of_safety": self.factor_of_safety,
            "circle": {"centre": list(self.centre), "radius": self.radius},
            "entry": list(self.entry), "exit": list(self.exit), "method": self.method,
            "tried": self.tried, "refused": self.refused, "negative_normal_stress": self.negative,
            "warning": self.warning,
        }  # fmt: skip


def critical(
    slope: Slope, method: str = "bishop", *, entry: Range | None = None, exit: Range | None = None,
    depth: float = 0.0, told: Callable[[str], None] = lambda _: None,
) -> Critical:  # fmt: skip
    """The circle of the least factor of safety.

    Parameters
    ----------
    slope : Slope
    method : str
        paper, ordinary or bishop.
    entry, exit : pair of float, optional
        Least and greatest x of the upper and the lower end, m; both may be equal.
    depth : float
        Least thickness of the mass, along the radius, m: keeps skins out.
    told : callable, optional
        Takes a line of progress.

    Raises
    ------
    ValueError
        If the slope has no critical circle (level ground, c = 0 without a least depth, phi = 0 without a base), or no
        circle is left by what is asked for.

    Notes
    -----
    Circles are laid through two points of the ground, up to the one that is upright at an end or touches the base;
    ground vertices are always among the points, and each stretch that a circle cuts off is judged. The best
    valleys of the coarse family are followed to 1e-5 of its spacing. Deterministic.
    """
    raise_all("critical", _mistakes(slope, method, entry, exit, depth))
    search = Search(slope, method, entry, exit, depth)
    at, step = search.coarse(told)
    for share in (1.0, 0.2):  # begun again from where they stopped, where a bent valley has held them up
        at, step = search.refined(at, share * step)
    told(f"least factor {np.nanmin(search.values[-1]):.6g} by {method}")
    return search.result(at[0])


def _mistakes(slope: Slope, method: str, entry: Any, exit: Any, depth: float) -> list[str]:
    ground = np.asarray(slope.ground)
    found = [] if method in METHODS else [f"method = {method!r}: must be one of {', '.join(METHODS)}"]
    for name, pair in (("entry", entry), ("exit", exit)):
        if pair is None:
            continue
        low, high = pair
        if not low <= high:
            found.append(f"{name} = [{low:.10g}, {high:.10g}]: must be the least and the greatest x, in this order")
        elif high < ground[0, 0] or low > ground[-1, 0]:
            found.append(f"{name} = [{low:.10g}, {high:.10g}]: lies beside the ground, which reaches from "
                         f"{ground[0, 0]:.10g} to {ground[-1, 0]:.10g}")  # fmt: skip
    if not 0.0 <= depth < float(np.ptp(ground)):
        found.append(f"depth = {depth!r}: must be at least 0 and below the size of the ground, in m")
    if np.ptp(ground[:, 1]) <= 1e-9 * np.ptp(ground[:, 0]):
        found.append("ground: is level; nothing drives a slide")
    elif slope.cohesion == 0.0 and not depth:
        steepest = float(np.max(np.abs(np.diff(ground[:, 1])) / np.maximum(np.diff(ground[:, 0]), 1e-300)))
        found.append(
            "cohesion = 0: the least factor is that of an ever thinner skin"
            + (f", tan(phi)/tan(slope) = {slope.friction / steepest:.4g} if dry" if steepest < 1e6 else "")
            + "; give a least depth"
        )
    elif slope.friction == 0.0 and slope.base is None and exit is None:
        found.append("friction = 0 without a base: the critical circle runs infinitely deep in flat slopes; give the "
                     "base of the soil, or where the circle comes out (exit)")  # fmt: skip
    return found


class Search:
    """What is kept of a search: the ground by its length, the limits, and every circle tried."""

    def __init__(self, slope: Slope, method: str, entry: Any, exit: Any, depth: float) -> None:
        self.slope, self.method, self.entry, self.exit, self.depth = slope, method, entry, exit, depth
        self.ground = np.asarray(slope.ground)
        self.along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(self.ground, axis=0).T))])
        self.centres: list[Floats] = []
        self.values: list[Floats] = []

    def points(self, q: Floats) -> Floats:
        """Points of the ground at lengths along it."""
        return np.stack([np.interp(q, self.along, self.ground[:, k]) for k in (0, 1)], axis=-1)

    def greatest(self, left: Floats, right: Floats) -> Floats:
        """Half the opening angle at which the circle through two points is upright at an end, or touches the base."""
        upright = np.arctan2(right[:, 0] - left[:, 0], np.abs(right[:, 1] - left[:, 1])) * (1 - 1e-12)
        if self.slope.base is None:
            return upright
        centre, _ = circle_touching(left, right, self.slope.base)
        between = (left[:, 0] < centre[:, 0]) & (centre[:, 0] < right[:, 0])
        a, b = (np.arctan2(np.abs(p[:, 0] - centre[:, 0]), centre[:, 1] - p[:, 1]) for p in (left, right))
        return np.where(between, np.minimum(upright, (a + b) / 2 * (1 - 1e-12)), upright)

    def laid(self, q: Floats) -> tuple[Floats, Floats]:
        """Centres and radii of circles, (n, 3): two lengths along the ground, share of the greatest opening."""
        left, right = self.points(q[:, 0]), self.points(q[:, 1])
        return circle_through(
            left, right, radius=np.hypot(*(right - left).T) / 2 / np.sin(q[:, 2] * self.greatest(left, right))
        )

    def judged(self, q: Floats) -> tuple[Floats, Floats]:
        """The least factor of each circle's stretches, NaN where there is none; and that stretch as (n, 3)."""
        rows = max(64, _EDGES // len(self.ground))
        if len(q) > rows:  # what does not fit into the caches
            found = [self.judged(q[k : k + rows]) for k in range(0, len(q), rows)]
            return np.concatenate([f for f, _ in found]), np.concatenate([w for _, w in found])
        return self._judged(q)

    def _judged(self, q: Floats) -> tuple[Floats, Floats]:
        """The same of one block."""
        found, where = np.full(len(q), np.nan), q.copy()
        sound = np.nonzero(np.subtract(*self.points(q[:, 1::-1]).T[0]) > 1e-9 * self.along[-1])[0]
        centre, radius = self.laid(q[sound])
        parts = circles.cut(self.ground[None], centre, radius)
        lane, number, _ = circles.stretches(parts)
        if lane.size:
            mine = parts.only(lane)
            values = self.allowed(centre[lane], radius[lane], mine, number)
            np.fmin.at(found, sound[lane], values)
            k = np.nonzero(values == found[sound[lane]])[0]
            where[sound[lane[k]]] = self.lengths(centre[lane[k]], radius[lane[k]], mine.only(k), number[k])
        self.centres.append(centre)
        self.values.append(found[sound])
        return found, where

    def lengths(self, centre: Floats, radius: Floats, parts: circles.Cut, number: Any) -> Floats:
        """Both ends of stretches by their lengths along the ground, vertices exactly; share of the greatest opening."""
        both, out = circles.ends(parts, number), []
        opening = np.arctan2(both[1][0], -both[1][1]) - np.arctan2(both[0][0], -both[0][1])
        for end, edge in zip(both, circles.edges(parts, number), strict=True):
            away = np.hypot(*(centre.T + radius * end - self.ground[edge].T))
            q = self.along[edge] + away
            near = self.along[np.clip(np.searchsorted(self.along, q - 1e-9 * self.along[-1]), 0, len(self.along) - 1)]
            out.append(np.where(np.abs(near - q) <= 1e-9 * self.along[-1], near, q))
        share = opening / 2 / self.greatest(*(self.points(q) for q in out))
        return np.stack([*out, np.where(share > 1 - 1e-9, 1.0, share)], axis=1)

    def allowed(self, centre: Floats, radius: Floats, parts: circles.Cut, number: Any) -> Floats:
        """The factors of stretches by the method; NaN of those that are not wanted."""
        found = factors(self.slope, centre, radius, parts, number, (self.method,))
        values = getattr(found, self.method)
        (x1, _), (x2, _) = circles.ends(parts, number)
        left, right = centre[:, 0] + radius * x1, centre[:, 0] + radius * x2
        upper, lower = np.where(found.facing > 0, left, right), np.where(found.facing > 0, right, left)
        blur = 1e-9 * float(np.ptp(self.ground[:, 0]))
        good = values > 0.0
        for x, limits in ((upper, self.entry), (lower, self.exit)):
            if limits is not None:
                good &= (x >= limits[0] - blur) & (x <= limits[1] + blur)
        if self.slope.base is not None:
            over = (x1 > 0.0) | (x2 < 0.0) | (centre[:, 1] - radius >= self.slope.base - blur)
            good &= over
        if self.depth:
            mine = parts.stretch == np.asarray(number)[:, None]
            good &= radius * circles.thickness(parts, mine) >= self.depth
        return np.where(good, values, np.nan)

    def places(self) -> Floats:
        """Lengths along the ground of the coarse family."""
        total = self.along[-1]
        even = np.linspace(0.0, total, _PLACES + 2)[1:-1]
        vertices = self.along
        if len(vertices) > _VERTICES:
            vertices = vertices[np.unique(np.searchsorted(vertices, np.linspace(0.0, total, _VERTICES)))]
        given = [even, vertices]
        # As many on short edges, such as the slope between wide level parts, and between given limits.
        for low, high in zip(self.along[:-1], self.along[1:], strict=True) if len(self.along) <= 12 else ():
            given.append(np.linspace(low, high, 8)[1:-1])
        for limits in (self.entry, self.exit):
            if limits is not None:
                x = np.linspace(max(limits[0], self.ground[0, 0]), min(limits[1], self.ground[-1, 0]), 8)
                given.append(np.interp(x, self.ground[:, 0], self.along))
        return np.unique(np.concatenate(given))

    def coarse(self, told: Callable[[str], None]) -> tuple[Floats, Floats]:
        """The best circles of the coarse family that are no neighbours of a better one, and their steps."""
        places = self.places()
        i, j = np.triu_indices(len(places), 1)
        q = np.empty((len(i), len(_SHARES), 3))
        q[..., 0], q[..., 1], q[..., 2] = places[i][:, None], places[j][:, None], _SHARES
        values, where = self.judged(q.reshape(-1, 3))
        order = np.argsort(values, kind="stable")[: np.count_nonzero(np.isfinite(values))]
        if not order.size:
            raise ValueError("critical: no circle is left by the limits given; widen entry, exit, depth or base")
        where = where[order]
        spacing = np.gradient(places)
        wide = np.stack([np.interp(where[:, 0], places, spacing), np.interp(where[:, 1], places, spacing),
                         np.interp(where[:, 2], _SHARES, np.gradient(_SHARES))], axis=1)  # fmt: skip
        chosen: list[int] = []
        left = np.ones(len(order), dtype=bool)
        while len(chosen) < _VALLEYS and left.any():
            k = int(np.argmax(left))
            chosen.append(k)
            left &= np.any(np.abs(where - where[k]) > _APART * wide[k], axis=1)
        told(f"{len(values)} circles; following {len(chosen)}, from {values[order[0]]:.4g}")
        return where[chosen], wide[chosen]

    def refined(self, at: Floats, step: Floats) -> tuple[Floats, Floats]:
        """The best circles, in order, after all were followed to better neighbours on grids that shrink."""
        at, now, best = at.copy(), step.copy(), np.full(len(at), np.inf)
        for _ in range(_ROUNDS):
            live = np.nonzero(np.any(now > _FINE * step, axis=1))[0]
            if not live.size:
                break
            near = at[live, None] + _OFFSETS * now[live, None]
            near[..., :2] = np.clip(near[..., :2], 0.0, self.along[-1])
            near[..., 2] = np.clip(near[..., 2], 0.005, 1.0)
            values, where = self.judged(near.reshape(-1, 3))
            values, where = np.nan_to_num(values, nan=np.inf).reshape(len(live), -1), where.reshape(near.shape)
            k, rows = np.argmin(values, axis=1), np.arange(len(live))
            better = values[rows, k] < best[live] * (1.0 - 1e-13)
            at[live[better]], best[live[better]] = where[rows, k][better], values[rows, k][better]
            now[live[~better | np.all(_OFFSETS[k] == 0.0, axis=1)]] *= _SHRINK
            now[best > _HOPE * best.min()] = 0.0
        order = np.argsort(best, kind="stable")[:_AGAIN]
        return at[order], step[order]

    def result(self, q: Floats) -> Critical:
        """All that is said of the best circle."""
        centre, radius = self.laid(q[None])
        parts = circles.cut(self.ground[None], centre, radius)
        lane, number, _ = circles.stretches(parts)
        k = [int(np.nanargmin(self.allowed(centre[lane], radius[lane], parts.only(lane), number)))]
        tried = np.concatenate(self.centres), np.concatenate(self.values)
        found = _described(self.slope, self.method, centre, radius, parts, number[k], *tried)
        ends = [
            x for x in self.ground[[0, -1], 0] if np.min(np.abs(np.subtract(found.between, x))) < 1e-6 * self.along[-1]
        ]
        said = (
            f"the circle reaches the end of the ground at x = {ends[0]:.6g}; a longer one may give less" if ends else ""
        )
        return replace(found, warning=said)


def at_circle(slope: Slope, section: Section, method: str = "bishop") -> Critical:
    """The factors of a circle that is given: of a section of this slope."""
    centre, radius = np.array([section.centre], dtype=np.float64), np.array([section.radius], dtype=np.float64)
    parts = circles.cut(np.asarray(slope.ground)[None], centre, radius)
    lane, number, _ = circles.stretches(parts)
    left = centre[0, 0] + radius[0] * circles.ends(parts.only(lane), number)[0][0]
    k = [int(np.argmin(np.abs(left - min(section.entry[0], section.exit[0]))))]
    found = _described(slope, method, centre, radius, parts, number[k], centre, np.array([np.nan]))
    values = np.array([found.factor_of_safety[method] or np.nan])
    return replace(found, values=values, refused=int(np.isnan(values[0])))


def _described(
    slope: Slope, method: str, centre: Floats, radius: Floats, parts: circles.Cut, number: Any, centres: Floats,
    values: Floats,
) -> Critical:  # fmt: skip
    """One circle and one stretch, with the circles that were tried."""
    found = factors(slope, centre, radius, parts, number)
    (cx, cy), r = (float(v) for v in centre[0]), float(radius[0])
    left, right = ((cx + r * float(x[0]), cy + r * float(y[0])) for x, y in circles.ends(parts, number))
    facing = int(found.facing[0])
    by_method = {m: float(getattr(found, m)[0]) for m in METHODS}
    return Critical(
        method, {m: v if np.isfinite(v) else None for m, v in by_method.items()}, (cx, cy), r,
        left if facing >= 0 else right, right if facing >= 0 else left, facing,
        len(values), int(np.isnan(values).sum()),
        float(found.negative[0]), centres, values,
    )  # fmt: skip
