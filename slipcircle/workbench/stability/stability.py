"""Three factors of safety of a homogeneous slope on any circles: the paper's, the ordinary method's and Bishop's.

They are integrals along the arc of the integrands in `generated.slopes`, by Gauss' rule between the kinks of ground and
water, so they are converged values and not those of a number of slices.
"""

from __future__ import annotations  # so that a signature says ArrayLike

import math
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from generated import slopes
from slipcircle.base.checks import raise_all
from slipcircle.core.scene import circles
from slipcircle.core.scene.circles import Floats
from slipcircle.core.scene.friction import law_parts
from slipcircle.core.scene.ground import field_mistakes, ponds

# By name: whose it is, and the strength that it gives the base of a slice: weight W, breadth b, length l, dip a.
METHODS: Mapping[str, tuple[str, str]] = {
    "paper": (
        "the paper's method (mean normal stress)",
        "c + mu max(0, s), s the mean of the effective normal stress "
        "over the arc, to which every point of the mass gives its weight times the cosine of its own direction "
        "from the centre (2.23)",
    ),
    "ordinary": (
        "the ordinary method (Fellenius)",
        "c + mu (W cos a - k_h W sin a - u l)/l: the cosine is that of the "
        "base below the point, which is the larger one",
    ),
    "bishop": (
        "Bishop's simplified method",
        "[c + mu (W/b - u)] cos a/m_alpha, m_alpha = cos a + sin a mu/F: slices "
        "push each other horizontally, which presses steep bases more",
    ),
}
COMPARED = """\
The factor is the moment of that strength about the centre over that of the weight, and of k_h times the weight at \
half the slices' height. The three agree where mu = 0, and nearly where the arc hardly turns below the mass. On the \
circle of real-slope they are 0.942, 0.950 and 0.985; with r_u = 0.5 and its own circle 0.431, 0.443 and 0.499: the \
paper's is the least, by 4 % and by 14 % of Bishop's, as water takes from steep bases what is added there. It is what \
the motion starts from, so that a slope may stand by Bishop's factor and slide by the paper's. Below a water \
level the paper's is least on circles that open up to half discs, where Bishop's is twice and three times that: look \
for Bishop's, or give a base. An [arc] has the paper's alone, as nothing is known of the ground beside its chord. A \
pressure in kPa is the same along the arc.

Near the top of steep slopes, and where much water presses, Bishop's slices and Fellenius' hang on the base: their \
effective normal stress is negative, and friction works against the slope. The share of such arc is told, and warned \
of from a fifth on. Beside Taylor's friction circles Bishop's least factor is right to 1 % below a share of 14 %, and \
2 % too small at 25 %, 5 % at 34 % and 9 % at 48 %, on vertical cuts with friction; with those stresses set to 0 it \
would be 4 to 23 % too great there. With mu = 0 the share is without meaning."""
LEAST_LEVER = 0.05  # of m_alpha: below, Bishop's normal stress is without sense
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(10)
_ROUNDS, _LEAST = 20, 5e-3  # steps towards Bishop's factor, and the least that is looked for


@dataclass(frozen=True)
class Slope:
    """A homogeneous slope in plane strain.

    Parameters
    ----------
    ground : array_like
        Points of the surface from left to right, (V, 2), x and y in m; equal x is a vertical scarp.
    cohesion : float
        c', Pa.
    friction : float
        Friction coefficient, tan(phi').
    unit_weight : float
        gamma, N/m^3.
    level : array_like, optional
        Points of the water level from left to right, (W, 2), m; beyond its ends it goes on horizontally.
    water_unit_weight : float
        N/m^3.
    pore_ratio : float
        r_u, pore pressure over gamma h, h the height of the ground above the arc; not with a level.
    pressure : float
        Pore pressure all along the arc, Pa, beside that of level or ratio.
    k_h : float
        Horizontal acceleration over g, positive down-slope.
    base : float, optional
        y of a firm layer, m: no circle goes below.

    Raises
    ------
    ValueError
        Lists every mistake, one sentence each.
    """

    ground: ArrayLike
    cohesion: float
    friction: float
    unit_weight: float
    level: ArrayLike | None = None
    water_unit_weight: float = 9810.0
    pore_ratio: float = 0.0
    pressure: float = 0.0
    k_h: float = 0.0
    base: float | None = None

    def __post_init__(self) -> None:
        found = field_mistakes(vars(self))
        if self.level is not None and self.pore_ratio != 0.0:
            found.append(f"pore_ratio = {self.pore_ratio!r}: and level exclude each other; leave one out")
        if not found:
            ground = np.array(self.ground, dtype=np.float64)
            object.__setattr__(self, "ground", ground)
            if self.level is not None:
                object.__setattr__(self, "level", np.array(self.level, dtype=np.float64))
                (pond,), said = ponds(ground[None], np.asarray(self.level)[None])
                found += [said(0)] if pond else []
            if self.cohesion == 0.0 and self.friction == 0.0:
                found.append("cohesion and friction are both 0: the slope has no strength")
            lowest = float(ground[:, 1].min())
            if self.base is not None and self.base >= lowest:
                found.append(f"base = {self.base:.10g}: must lie below the ground, whose lowest point is {lowest:.10g}")
        raise_all("Slope", found)


def _edge(line: Floats, above: Floats, x: Floats) -> tuple[Floats, Floats]:
    """Of the edge of a line above a point, continued where the line ends: its height at x, and its slope."""
    k = np.clip(np.searchsorted(line[:, 0], above) - 1, 0, len(line) - 2)
    run, rise = np.diff(line, axis=0).T
    slope = np.divide(rise, run, out=np.zeros(len(run)), where=run > 0.0)
    return line[k, 1] + slope[k] * (x - line[k, 0]), slope[k]


def factors(
    slope: Slope,
    centre: Floats,
    radius: Floats,
    left: Floats,
    right: Floats,
    methods: Collection[str] = METHODS,
    pieces: int = 1,
) -> dict[str, Floats]:
    """Factors of safety of the masses between circles and the ground, from one point of the ground to another.

    Of circles (n, 2) and (n,), and the ends of their arcs, (n, 2), m, between which the ground lies inside the circle;
    by the methods that are asked for, the others are NaN. Cut into pieces, besides at kinks, an arc is counted at 10
    points of each for the sake of ``negative``.

    Returns
    -------
    dict of ndarray
        Factors by method, NaN where it refuses the circle. ``facing``: 1 where the mass slides to the right, -1 to the
        left, 0 where nothing drives it. ``negative``: share of the arc under negative effective normal stress, by the
        ordinary method or by Bishop's, if greater.

    Notes
    -----
    Water: the ordinary method takes N' = W cos(a) - u l, which reproduces published factors (Fredlund and Krahn 1977);
    its other convention, (W - u b) cos(a), gives greater ones. Bishop's method refuses a circle where m_alpha falls
    below 0.05; all methods refuse one that overhangs at an end, or whose centre lies below the ground.
    """
    ground, n, (cx, cy) = np.asarray(slope.ground), len(radius), centre.T
    first, last = (np.arctan2(p[:, 0] - cx, cy - p[:, 1]) for p in (left, right))
    sound = (first >= -np.pi / 2) & (last <= np.pi / 2) & (first < last)
    sound &= (first > 0.0) | (last < 0.0) | (_edge(ground, cx, cx)[0] < cy)
    vertices = np.arcsin(np.clip((ground[1:-1, 0] - cx[:, None]) / radius[:, None], -1, 1))
    kinks, level = [np.linspace(first, last, pieces + 1, axis=1), vertices], None
    if slope.level is not None and n:
        level, _, wet_kinks = circles.wet(np.asarray(slope.level), centre, radius)
        kinks.append(wet_kinks)
    at = np.sort(np.clip(np.concatenate(kinks, axis=1), first[:, None], last[:, None]), axis=1)
    row, k = np.nonzero((np.diff(at, axis=1) > 0.0) & sound[:, None])
    low, half = at[row, k], (at[row, k + 1] - at[row, k]) / 2
    middle, r = low + half, radius[row]
    beta = middle + half * _NODES[:, None]  # nodes first: sums over them are sums of rows
    sine, cosine, weight = np.sin(beta), np.cos(beta), half * _WEIGHTS[:, None]

    def above(line: Floats) -> Floats:
        """Height of a line above the centre, over R."""
        height, rise = _edge(line, cx[row] + r * np.sin(middle), cx[row])
        return (height - cy[row]) / r + rise * sine

    def total(values: Floats) -> Floats:
        return np.bincount(row, values.sum(axis=0), n).astype(np.float64)

    top = above(ground)
    height = np.maximum(top + cosine, 0.0)
    if level is None:
        pressure = slope.pore_ratio * height
    else:
        pressure = (slope.water_unit_weight / slope.unit_weight) * np.maximum(above(level) + cosine, 0.0)
    pressure = pressure + slope.pressure / (slope.unit_weight * r)
    drive = total(weight * slopes.drive(sine, cosine, height, 0.0))
    still = 1e-9 * total(weight * cosine * height)
    facing = np.where(np.abs(drive) > still, np.sign(drive), 0.0)
    sine = sine * facing[row]  # from here on down-slope is positive
    k_h, mu = slope.k_h, slope.friction
    drive = total(weight * slopes.drive(sine, cosine, height, k_h)) if k_h else np.abs(drive)
    drive = np.where(sound & (facing != 0.0) & (drive > still), drive, np.nan)
    cohesion, arc = slope.cohesion / (slope.unit_weight * radius), np.where(sound, last - first, np.nan)
    normal = slopes.ordinary_normal(sine, cosine, height, pressure, k_h)
    ordinary = (cohesion * arc + mu * total(normal * weight)) / drive
    negative = total(np.where(normal < 0.0, weight, 0.0)) / arc
    paper = bishop = np.full(n, np.nan)
    if "paper" in methods:
        distance = np.hypot(sine, top)
        stress = slopes.radial_weight(cosine, distance) - pressure
        if k_h:
            stress += k_h * slopes.radial_tilt(sine, cosine, height, distance)
        paper = (cohesion * arc + mu * np.maximum(total(weight * stress), 0.0)) / drive
    if "bishop" in methods:
        strength = slopes.bishop_strength(cosine, height, pressure, cohesion[row], mu) * weight
        ends = np.array([first, last]) * facing
        bishop = ordinary if mu == 0.0 else _bishop(strength, sine, cosine, row, mu, drive, ends, ordinary)
        normal = slopes.bishop_normal(sine, cosine, height, pressure, cohesion[row], mu, bishop[row])
        negative = np.maximum(negative, total(np.where(normal < 0.0, weight, 0.0)) / arc)
    return {"paper": paper, "ordinary": ordinary, "bishop": bishop, "facing": facing, "negative": negative}


def soil(friction: Any, effects: Mapping[str, Mapping[str, Any]]) -> dict[str, float]:
    """Strength and pore pressure of a slope, as a scene's friction and effects have them at the start.

    Empty where nothing is known of a pressure that a record holds, or where there is no strength.
    """

    def first(value: Any) -> float:
        return float(np.ravel(value(0.0) if callable(value) else value)[0])

    given, water = effects.get("cohesion", {}), effects.get("pore_pressure", {})
    laws = [[of[n] for n in ("peak", "coefficient", "function") if n in of] for _, of in law_parts(friction)]
    strength = {"friction": math.prod(first(of[0]) for of in laws), "cohesion": first(given.get("cohesion", 0.0))}
    if "record" in water or not any(strength.values()):
        return {}
    return strength | {"pore_ratio": first(water.get("ratio", 0.0)), "pressure": first(water.get("pressure", 0.0))}


def _bishop(
    strength: Floats,
    sine: Floats,
    cosine: Floats,
    row: NDArray[np.int64],
    mu: float,
    drive: Floats,
    ends: Floats,
    start: Floats,
) -> Floats:
    """F of y = 1/F where y times the integral of strength/m_alpha(y) is the drive, which grows with y.

    By Newton's steps, all circles at once. m_alpha = cos - y mu sin has its least value at an end of the arc: that
    makes the range of y.
    """
    s, c, n = mu * np.sin(ends), np.cos(ends) - LEAST_LEVER, len(drive)
    with np.errstate(divide="ignore", invalid="ignore"):
        high = np.min(np.where(s > 0.0, np.maximum(c, 0.0) / s, 1.0 / _LEAST), axis=0).clip(max=1.0 / _LEAST)
        low = np.max(np.where((s < 0.0) & (c < 0.0), c / s, 0.0), axis=0)
        y = np.where(low < high, np.clip(1.0 / np.maximum(start, _LEAST), low, high), np.nan)
        for _ in range(_ROUNDS):
            factor = 1.0 / y
            lever = slopes.bishop_lever(sine, cosine, mu, factor[row])
            shear = strength / lever
            excess = y * np.bincount(row, shear.sum(axis=0), n) - drive
            y = np.clip(y - excess / np.bincount(row, (shear * cosine / lever).sum(axis=0), n), low, high)
            if not np.any(np.abs(y * factor - 1.0) > 1e-9):
                break
        return np.where(np.abs(excess) <= 1e-9 * drive, factor, np.nan)
