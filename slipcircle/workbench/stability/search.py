"""The critical circle of a slope: a coarse family of all circles at once, then the best of its valleys refined."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Any

import numpy as np

from slipcircle.base.checks import InputError, raise_all
from slipcircle.base.series import Floats
from slipcircle.core import Section, circle_through, circle_touching
from slipcircle.workbench.stability.slices import circle_factors
from slipcircle.workbench.stability.stability import METHODS, Slope

_PLACES = 40
_LEAST = 7
_EDGES = 12  # of the ground; on each edge, where there are few edges
_VERTICES = 48  # beyond, those nearest to even places
_SHARES = np.array([0.04, 0.08, 0.13, 0.19, 0.26, 0.34, 0.43, 0.53, 0.64, 0.76, 0.88, 1.0])
_VALLEYS = 12
_APART = 2.5  # that are followed, and spacings of the coarse family between them
_ROUNDS = 150
_SHRINK = 0.6
_FINE = 1e-5  # a valley is done at this step over its first
_HOPE = 1.2
_AGAIN = 3  # far above the best, a circle is left; the best of all are followed twice
_SENSE = 0.2
_PIECES = 50  # of an arc that may be under negative stress, without a warning; in which it is found
_SIZE = 1 << 13  # ground vertices times circles at a time: what fits into the caches
_OFFSETS = np.stack(np.meshgrid(*[[-1.0, 0.0, 1.0]] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
Range = tuple[float, float]


@dataclass(frozen=True)
class Critical:
    """A circle with its factors of safety, and what it took to find it.

    Attributes
    ----------
    slope : Slope
    factor_of_safety : dict
        By method, with the slope's k_h; None where a method refuses the circle.
    factor_of_safety_without_k_h : dict or None
        The same without, from which a motion starts; None where the slope has no k_h.
    centre, radius : tuple of float, float
        m.
    entry, exit : tuple of float
        Upper and lower end of the slip surface, m.
    facing : int
        1 where the mass slides to the right, -1 to the left, 0 where nothing drives it.
    negative : float
        Share of the arc under negative effective normal stress, by the ordinary method or by Bishop's, if greater.
    warning : str
        That a fifth of the arc and more is under negative stress, or that the circle reaches an end of the ground or a
        limit of the search, beyond which a lesser factor may lie.
    method, limits : str, mapping
        Whose factor is the least, and what limited the search; empty for a circle that was given.
    tried, refused : int
        Circles, and those of them without a factor: off the ground, too shallow, overhanging, or with m_alpha below
        0.05.
    centres, values : ndarray
        Of every circle that was tried: its centre, (tried, 2), and its factor or NaN; for a map.
    """

    slope: Slope = field(repr=False, compare=False)
    factor_of_safety: dict[str, float | None]
    centre: tuple[float, float]
    radius: float
    entry: tuple[float, float]
    exit: tuple[float, float]
    facing: int
    negative: float
    warning: str
    factor_of_safety_without_k_h: dict[str, float | None] | None = None
    method: str = ""
    tried: int = 1
    refused: int = 0
    centres: Floats = field(default_factory=lambda: np.empty((0, 2)), repr=False, compare=False)
    values: Floats = field(default_factory=lambda: np.empty(0), repr=False, compare=False)
    limits: Mapping[str, Any] = field(default_factory=dict, repr=False, compare=False)

    @property
    def between(self) -> tuple[float, float]:
        """x of both ends, from left to right: which of the circle's stretches it is."""
        return min(self.entry[0], self.exit[0]), max(self.entry[0], self.exit[0])

    def without_map(self) -> "Critical":
        """The same without the circles that were tried, which are many."""
        return replace(self, centres=self.centres[:0], values=self.values[:0])

    def record(self) -> dict[str, Any]:
        """For JSON, in SI units."""
        without = self.factor_of_safety_without_k_h
        return {
            "factor_of_safety": self.factor_of_safety,
            **({"factor_of_safety_without_k_h": without} if without else {}),
            "circle": {"centre": list(self.centre), "radius": self.radius},
            "entry": list(self.entry),
            "exit": list(self.exit),
            "tried": self.tried,
            "refused": self.refused,
        }


def critical(
    slope: Slope,
    method: str = "bishop",
    *,
    entry: Range | None = None,
    exit: Range | None = None,
    depth: float = 0.0,
    tell: Callable[[str], None] = lambda _: None,
) -> Critical:
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
    tell : callable, optional
        Takes a line of progress.

    Raises
    ------
    ValueError
        If the slope has no critical circle (level ground, c = 0 without a least depth, phi = 0 without a base where
        deeper is ever worse), or no circle is left by what is asked for.

    Notes
    -----
    Each circle leads from one point of the ground to another, and is judged by what it cuts off between them: ground
    vertices are always among these points (of a ground of more than 48, evenly chosen ones), and circles open up to
    the one that is upright at an end or touches the base. The best valleys of this coarse family are followed to 1e-5
    of its spacing. Deterministic.
    """
    raise_all("critical", _mistakes(slope, method, {"entry": entry, "exit": exit}, depth))
    search = Search(slope, method, entry, exit, depth)
    at, step = search.coarse(tell)
    for share in (1.0, 0.2):  # begun again from where they stopped, where a bent valley has held them up
        at, step = search.refined(at, share * step)
    found = search.result(at[:1])
    least = found.factor_of_safety[method] or np.inf
    deep = _bottomless(slope)
    if slope.friction == 0.0 and slope.base is None and entry is None and exit is None and least > deep:
        deepest = f"the critical circle runs infinitely deep, where the factor tends to {deep:.4g}"
        advice = "give the base of the soil, or where the circle comes out (exit)"
        raise InputError("critical", [f"{{friction}} = 0 without a base: {deepest}; {advice}"])
    tell(f"least factor {least:.6g} by {method}")
    return found


def at_circle(slope: Slope, section: Section) -> Critical:
    """The factors of a circle that is given: of a section of this slope."""
    ends = np.array(sorted([tuple(section.entry), tuple(section.exit)]))[:, None]
    found = _described(slope, np.array([section.centre]), np.array([section.radius]), *ends)
    return replace(found, refused=int(None in found.factor_of_safety.values()))


def _described(slope: Slope, centre: Floats, radius: Floats, left: Floats, right: Floats) -> Critical:
    """One circle, by arrays of one."""
    found = _numbers(circle_factors(slope.arrays(), centre, radius, left, right, pieces=_PIECES))
    still = slope.arrays()._replace(k_h=0.0)
    without = _by_method(_numbers(circle_factors(still, centre, radius, left, right))) if slope.k_h else None
    middle, first, second = ((float(p[0, 0]), float(p[0, 1])) for p in (centre, left, right))
    entry, exit = (first, second) if found["facing"] >= 0.0 else (second, first)
    facing = int(found["facing"])
    negative = found["negative"]
    words = (
        f"{100 * negative:.0f} % of the arc is under negative effective normal stress, where factors depend on the "
        "method more than on the soil"
    )
    warning = words if slope.friction and negative > _SENSE else ""
    size = float(radius[0])
    return Critical(slope, _by_method(found), middle, size, entry, exit, facing, negative, warning, without)


def _numbers(arrays: Mapping[str, Floats]) -> dict[str, float]:
    return {name: float(values[0]) for name, values in arrays.items()}


def _by_method(found: Mapping[str, float]) -> dict[str, float | None]:
    return {m: found[m] if np.isfinite(found[m]) else None for m in METHODS}


def _mistakes(slope: Any, method: Any, limits: Mapping[str, Any], depth: Any) -> list[str]:
    if not isinstance(slope, Slope):
        return [f"{{slope}} = {slope!r}: must be a Slope; search finds that of a file"]
    ground = np.asarray(slope.ground)
    found = [] if method in [*METHODS] else [f"{{method}} = {method!r}: must be one of {', '.join(METHODS)}"]
    if not isinstance(depth, int | float) or not 0.0 <= depth < float(np.ptp(ground)):
        found.append(f"{{depth}} = {depth!r}: must be at least 0 and below the size of the ground, in m")
    for name, pair in limits.items():
        try:
            low, high = (-np.inf, np.inf) if pair is None else map(float, pair)
        except (TypeError, ValueError):
            found.append(f"{{{name}}} = {pair!r}: must be two numbers, the least and the greatest x")
            continue
        shown = f"{{{name}}} = [{low:.10g}, {high:.10g}]"
        if not low <= high:
            found.append(f"{shown}: must be the least and the greatest x, in this order")
        elif high < ground[0, 0] or low > ground[-1, 0]:
            reach = f"from {ground[0, 0]:.10g} to {ground[-1, 0]:.10g}"
            found.append(f"{shown}: lies beside the ground, which reaches {reach}")
    if np.ptp(ground[:, 1]) <= 1e-9 * np.ptp(ground[:, 0]):
        found.append("{ground}: is level; nothing drives a slide")
    elif not depth and slope.cohesion == 0.0:
        steepest = float(np.max(np.abs(np.diff(ground[:, 1])) / np.maximum(np.diff(ground[:, 0]), 1e-300)))
        skin = f", tan(phi)/tan(slope) = {slope.friction / steepest:.4g} if dry" if steepest < 1e6 else ""
        found.append(f"{{cohesion}} = 0: the least factor is that of an ever thinner skin{skin}; give a least depth")
    elif not depth and slope.friction and slope.pressure:
        found.append(
            "{pressure}: is the same along every circle, and lifts the thin ones; give a water level or a pore "
            "pressure ratio, or a least depth"
        )
    return found


def _bottomless(slope: Slope) -> float:
    """The factor of ever deeper circles without friction: that of a step between level grounds, beside which all else
    is small. F = 4 a c/(gamma H sin(a)^2) of circles about it with half the opening a, least where tan(a) = 2 a.
    """
    ground = np.asarray(slope.ground)
    step = abs(float(ground[-1, 1] - ground[0, 1])) * slope.unit_weight
    return 0.0 if slope.k_h > 0.0 else 5.5199 * slope.cohesion / step if step and not slope.k_h else np.inf


class Search:
    """What is kept of a search: the ground by its length, the limits, and every circle tried.

    Circles are (n, 3): two lengths along the ground, and the opening as a share of the greatest.
    """

    def __init__(self, slope: Slope, method: str, entry: Any, exit: Any, depth: float) -> None:
        self.slope = slope
        self.method = method
        self.depth = depth
        self.ends = {"entry": entry, "exit": exit}
        self.ground = np.asarray(slope.ground)
        self.arrays = slope.arrays()
        self.along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(self.ground, axis=0).T))])
        self.blur = 1e-9 * float(self.along[-1])
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
        between = (left[:, 0] <= centre[:, 0] + self.blur) & (centre[:, 0] - self.blur <= right[:, 0])
        a, b = (np.arctan2(np.abs(p[:, 0] - centre[:, 0]), centre[:, 1] - p[:, 1]) for p in (left, right))
        return np.where(between, np.minimum(upright, (a + b) / 2 * (1 - 1e-12)), upright)

    def laid(self, q: Floats) -> tuple[Floats, Floats, Floats, Floats]:
        """Centres, radii, left and right ends of circles."""
        left = self.points(q[:, 0])
        right = self.points(q[:, 1])
        half = np.hypot(*(right - left).T) / 2
        return *circle_through(left, right, radius=half / np.sin(q[:, 2] * self.greatest(left, right))), left, right

    def judged(self, q: Floats) -> Floats:
        """The factor of each circle, NaN where there is none, or none that is wanted."""
        values = np.full(len(q), np.nan)
        left = self.points(q[:, 0])
        right = self.points(q[:, 1])
        apart = right[:, 0] - left[:, 0] > self.blur
        if self.slope.base is not None:  # between points on the base there is no circle above it
            apart &= np.maximum(left[:, 1], right[:, 1]) - self.slope.base > self.blur
        every = np.nonzero(apart)[0]
        for lanes in np.array_split(every, -(-len(every) * len(self.ground) // _SIZE) or 1):
            circle = self.laid(q[lanes])
            k = np.nonzero(self._thickness(q[lanes], *circle[:2]) >= self.depth)[0]
            centre, radius, left, right = (part[k] for part in circle)
            found = circle_factors(self.arrays, centre, radius, left, right, (self.method,))
            good = found[self.method] > 0.0
            for limit, way in zip(self.ends.values(), (1.0, -1.0), strict=True):
                if limit is not None:
                    x = np.where(found["facing"] == way, left[:, 0], right[:, 0])
                    good &= (x >= limit[0] - self.blur) & (x <= limit[1] + self.blur)
            values[lanes[k]] = np.where(good, found[self.method], np.nan)
            self.centres.append(circle[0])
            self.values.append(values[lanes])
        return values

    def _thickness(self, q: Floats, centre: Floats, radius: Floats) -> Floats:
        """Greatest distance from arc to ground along the radius; -1 where the ground leaves the circle in between."""
        line = self.points(np.clip(self.along, q[:, :1], q[:, 1:2])) - centre[:, None]  # repeats its ends beyond them
        inside = np.all(np.hypot(line[..., 0], line[..., 1]) <= (1 + 1e-12) * radius[:, None], axis=1)
        if not self.depth:
            return np.where(inside, 0.0, -1.0)
        start = line[:, :-1]
        edge = np.diff(line, axis=1)
        square = np.sum(edge**2, axis=2)
        share = np.clip(-np.sum(start * edge, axis=2) / np.where(square > 0.0, square, 1.0), 0.0, 1.0)
        nearest = np.sqrt(np.sum((start + share[..., None] * edge) ** 2, axis=2).min(axis=1))
        return np.where(inside, radius - nearest, -1.0)

    def places(self) -> Floats:
        """Lengths along the ground of the coarse family."""
        vertices = self.along
        total = self.along[-1]
        if len(vertices) > _VERTICES:
            vertices = vertices[np.unique(np.searchsorted(vertices, np.linspace(0.0, total, _VERTICES)))]
        given = [vertices]
        least = _LEAST if len(vertices) <= _EDGES else 1  # on short edges too: the slope between wide level parts
        for low, high in pairwise(vertices.tolist()):
            given.append(np.linspace(low, high, max(least, round(_PLACES * (high - low) / total)) + 1)[1:-1])
        for limit in filter(None, self.ends.values()):
            first, last = np.interp(limit, self.ground[:, 0], self.along)
            given.append(np.linspace(first, last, _LEAST + 1))
        return np.unique(np.concatenate(given))

    def coarse(self, tell: Callable[[str], None]) -> tuple[Floats, Floats]:
        """The best circles of the coarse family that are no neighbours of a better one, and their steps."""
        places = self.places()
        number = np.indices((len(places), len(places), len(_SHARES))).reshape(3, -1)
        i, j, k = number[:, number[0] < number[1]]
        grids = (places, _SHARES), (np.gradient(places), np.gradient(_SHARES))
        q, wide = (np.column_stack([ends[i], ends[j], opening[k]]) for ends, opening in grids)
        values = self.judged(q)
        order = np.argsort(values, kind="stable")[: np.count_nonzero(np.isfinite(values))]
        if not order.size:
            left = "no circle is left that slides within the limits given; widen entry, exit, depth or base"
            raise InputError("critical", [left])
        chosen: list[int] = []
        while len(chosen) < _VALLEYS and order.size:
            chosen.append(best := order[0])
            order = order[np.any(np.abs(q[order] - q[best]) > _APART * wide[best], axis=1)]
        tell(f"{len(values)} circles; following {len(chosen)}, from {values[chosen[0]]:.4g}")
        return q[chosen], wide[chosen]

    def refined(self, at: Floats, step: Floats) -> tuple[Floats, Floats]:
        """The best circles, in order, after all were followed to better neighbours on grids that shrink."""
        at, now, best = at.copy(), step.copy(), np.full(len(at), np.inf)
        for _ in range(_ROUNDS):
            live = np.nonzero(np.any(now > _FINE * step, axis=1))[0]
            if not live.size:
                break
            near = at[live, None] + _OFFSETS * now[live, None]
            near = np.clip(near, [0.0, 0.0, 0.005], [self.along[-1], self.along[-1], 1.0])
            values = np.nan_to_num(self.judged(near.reshape(-1, 3)), nan=np.inf).reshape(len(live), -1)
            k = np.argmin(values, axis=1)
            rows = np.arange(len(live))
            better = values[rows, k] < best[live] * (1.0 - 1e-13)
            at[live[better]], best[live[better]] = near[rows, k][better], values[rows, k][better]
            now[live[~better | np.all(_OFFSETS[k] == 0.0, axis=1)]] *= _SHRINK
            now[best > _HOPE * best.min()] = 0.0
        order = np.argsort(best, kind="stable")[:_AGAIN]
        return at[order], step[order]

    def result(self, q: Floats) -> Critical:
        """All that is said of the best circle."""
        found = _described(self.slope, *self.laid(q))
        values = np.concatenate(self.values)
        warnings = [found.warning] if found.warning else []
        for x in self.ground[[0, -1], 0]:
            if min(abs(found.entry[0] - x), abs(found.exit[0] - x)) < 1e3 * self.blur:
                warnings.append(f"the circle reaches the end of the ground at x = {x:.6g}; a longer one may give less")
        warnings += self._reached_limits(q, found)
        return replace(
            found,
            method=self.method,
            limits=self.ends | {"depth": self.depth},
            warning="; ".join(warnings),
            tried=len(values),
            refused=int(np.isnan(values).sum()),
            values=values,
            centres=np.concatenate(self.centres),
        )

    def _reached_limits(self, q: Floats, found: Critical) -> list[str]:
        """A sentence for each limit of the search that the best circle stands on."""
        near = 1e-4 * float(self.along[-1])
        sentences = []
        for name, limit in self.ends.items():
            x = getattr(found, name)[0]
            if limit is not None and limit[1] > limit[0] and min(abs(x - limit[0]), abs(x - limit[1])) < near:
                sentences.append(f"the {name} stands on a limit of the search, x = {x:.6g}; a wider one may give less")
        if self.depth and self._thickness(q, *self.laid(q)[:2])[0] < self.depth + near:
            sentences.append(
                f"the mass is as thin as the search allows, {self.depth:.6g} m; a thinner one may give less"
            )
        return sentences
