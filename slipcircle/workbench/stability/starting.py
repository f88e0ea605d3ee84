"""Strength factors: by how much strength has to change for a motion to start from the result of another method.

The balance of a motion has the closure of the paper's method. With strength multiplied by F_method/F_paper it starts
from the factor of safety of the method. Under shaking the yield coefficients are to be equal, so that strength is
divided by the paper's factor under the yield coefficient of the method.

Strength is summed over a few points of each stretch in one soil, weighted with integrals of Lagrange's polynomials.
Scenes of an ensemble that share a circle share these points.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.polynomial import chebyshev

from generated import slopes
from slipcircle.base.kinds import Floats, Integers
from slipcircle.workbench.stability.columns import SlopeArrays, SoilArrays
from slipcircle.workbench.stability.factors import LEAST_LEVER, driven_slices
from slipcircle.workbench.stability.slices import Slices
from slipcircle.workbench.stability.stability import Circles, circles_of, each_lane, soil

OF_CLOSURE = "paper"  # the method whose factor of safety the balance of a motion has at the start
_PIECES = 3  # into which an arc is cut besides at kinks: then random factors are accurate to 1e-14
_LEAST_POINTS, _POINTS_PER_RADIAN = 6, 14  # of a stretch in one soil
_LANES = 4096  # at a time
_NEWTON_STEPS = 30
_CLOSE = 1e-9  # relative change of a converged root


class Points(NamedTuple):
    """Points of arcs at which strength is summed, in the order of the arcs.

    Attributes
    ----------
    sine, cosine : ndarray
        Of the base, positive down-slope.
    layer, arc, lane : ndarray
        Layer of each point, number of its arc among those that have points, and of its lane unless all share an arc.
    slices : Slices
        On which integrands are given, (nodes, intervals).
    shares : ndarray
        Weights of nodes in the sums, (nodes, intervals, points of a stretch).
    segments : ndarray
        First interval of each stretch of an arc in one soil.
    """

    sine: Floats
    cosine: Floats
    layer: Integers
    arc: Integers
    lane: Integers
    slices: Slices
    shares: Floats
    segments: Integers
    is_shared: bool

    def sums(self, integrands: Floats) -> Floats:
        """Return integrands (..., nodes, intervals) as weights of points, (..., points)."""
        by_interval = np.einsum("...ni,nip->...ip", integrands, self.shares)
        by_segment = np.add.reduceat(by_interval, self.segments, axis=-2)
        return by_segment.reshape(*by_segment.shape[:-2], -1)

    def of_lanes(self, values: Any) -> Floats:
        """Return a number of lanes, (1 or lanes), at points, (points or 1, lanes of an arc or 1)."""
        by_lane = np.atleast_1d(values)
        if self.is_shared or by_lane.size == 1:
            return by_lane[None]
        return by_lane[self.lane][:, None]

    def of_soils(self, rows: Floats) -> Floats:
        """Return a number of the soils, (layers, 1 or lanes), at points, (points, lanes of an arc or 1)."""
        if self.is_shared or rows.shape[1] == 1:
            return rows[self.layer]
        return rows[self.layer, self.lane][:, None]

    @property
    def first(self) -> Integers:
        """Return the first point of each arc."""
        return np.flatnonzero(np.diff(self.arc, prepend=-1))

    def over_arcs(self, values: Any) -> Floats:
        """Return sums over points, (arcs, lanes)."""
        if self.is_shared:
            return np.sum(values, axis=0, keepdims=True)
        total: Floats = np.add.reduceat(values, self.first, axis=0)
        return total


class Balance(NamedTuple):
    """Moments about the centre of arcs, (arcs, lanes), by a method and by the closure.

    With y = 1/F equilibrium by Bishop's method is y sum strength/(cosine + y grip) = drive.

    Attributes
    ----------
    points : Points
    strength, cosine, grip : ndarray
        Of points: strength, cosine and minus tan(phi) times the sine of the base.
    drive, shaking : ndarray
        Of gravity and of k_h = 1.
    cohesion, friction, tilt : ndarray
        Of the closure, and what k_h = 1 adds to its friction.
    loss : ndarray
        What k_h = 1 takes from strength.
    coefficients : ndarray
        Sum of tan(phi).
    """

    points: Points
    strength: Floats
    cosine: Floats
    grip: Floats
    drive: Floats
    shaking: Floats
    cohesion: Floats
    friction: Floats
    tilt: Floats
    loss: Floats
    coefficients: Floats

    def factor(self, shaken: bool) -> Floats:
        """Return strength factors, (arcs, lanes)."""
        k_h: Any = 0.0
        y = np.ones_like(self.drive)
        if not shaken:
            y = self._root()
        resistance = self._resistance(y)
        if shaken:
            k_h = (resistance - self.drive) / (self.shaking + self.loss)
            resistance = self.drive + k_h * self.shaking
        friction = self.friction + k_h * self.tilt
        of_closure = self.cohesion + np.maximum(friction, 0.0)
        factor = resistance / of_closure
        return np.where(self.coefficients > 0.0, factor, 1.0)

    def _resistance(self, y: Floats) -> Floats:
        """Return the resisting moment with a factor of safety of 1/y, NaN where m_alpha is too small."""
        lever = self.cosine + y[self.points.arc] * self.grip
        too_small = self.points.over_arcs(lever < LEAST_LEVER)
        strength = self.points.over_arcs(self.strength / lever)
        return np.where(too_small == 0, strength, np.nan)

    def _root(self) -> Floats:
        """Return 1/F by Newton's steps, each at most half of the way to where m_alpha is 0."""
        y = np.zeros_like(self.drive)
        for _ in range(_NEWTON_STEPS):
            lever = self.cosine + y[self.points.arc] * self.grip
            strength = self.strength / lever
            excess = y * self.points.over_arcs(strength) - self.drive
            growth = self.points.over_arcs(strength * self.cosine / lever)
            falls = self.grip < 0.0
            room = np.where(falls, -lever / self.grip, np.inf)
            most = np.minimum.reduceat(room, self.points.first, axis=0) / 2
            newton = -excess / growth
            step = np.minimum(newton, most)
            y = y + step
            change = np.abs(step)
            if not np.any(change > _CLOSE * y):
                break
        balanced = np.abs(excess) <= _CLOSE * self.drive
        return np.where(balanced, y, np.nan)


def strength_factor(scene: Any, method: str) -> Any:
    """Return the strength factor by which a scene on a ground starts from the result of a method.

    Parameters
    ----------
    scene : Scene
        With friction and pore pressure of time 0, and with "shaking" among its effects or not.
    method : str

    Returns
    -------
    float or ndarray
        In the shape of the scene. Exactly 1 without friction, and where nothing drives the mass; NaN where the method
        refuses the circle.
    """
    if method == OF_CLOSURE or not soil(scene.friction, scene.called):
        return 1.0
    shaken = "shaking" in scene.effects
    blocks = [_of_circles(*circles, method, shaken) for circles in circles_of(scene, _LANES)]
    every_lane = np.concatenate(blocks)
    factor = every_lane.reshape(scene.shape)
    return factor if scene.shape else float(factor)


def _of_circles(slope: SlopeArrays, circles: Circles, lanes: int, method: str, shaken: bool) -> Floats:
    """Return the strength factors of lanes."""
    is_shared = _is_shared(slope, circles)
    soils = slope.soils
    if is_shared:
        soils = SoilArrays(*(rows[:, :1] for rows in soils))
    else:
        circles = each_lane(circles, lanes)
    driven = driven_slices(replace(slope, soils=soils, pressure=0.0), *circles, _PIECES)
    factor = np.full(lanes, np.nan)
    slices = driven.slices
    if slices.arc.size:
        with np.errstate(divide="ignore", invalid="ignore"):
            balance = _balance(slope, _points(slices, is_shared), method)
            known = slice(None) if is_shared else np.unique(slices.arc)
            factor[known] = balance.factor(shaken).ravel()
    return np.where(driven.facing == 0.0, 1.0, factor)


def _is_shared(slope: SlopeArrays, circles: Circles) -> bool:
    """Return whether all lanes have the same ground, circle and loads."""
    lines = [slope.ground, *slope.tops, *circles]
    if slope.level is not None:
        lines.append(slope.level)
    for _, _, left, right in slope.surcharge:
        lines += [left, right]
    return all(len(line) == 1 for line in lines)


def _points(slices: Slices, is_shared: bool) -> Points:
    """Return the points of slices, those of each stretch of an arc in one soil, with both of its ends."""
    layers = slices.layer.max() + 1
    begins = np.diff(slices.arc * layers + slices.layer, prepend=-1) != 0
    segments = np.flatnonzero(begins)
    ends = slices.ends * slices.way
    low = np.minimum.reduceat(ends.min(axis=0), segments)
    high = np.maximum.reduceat(ends.max(axis=0), segments)
    middle = (low + high) / 2
    half = (high - low) / 2
    count = _LEAST_POINTS + int(_POINTS_PER_RADIAN * (high - low).max())
    places = np.cos(np.pi * (np.arange(count) + 0.5) / count)
    stretch = np.cumsum(begins) - 1
    shares = _shares(slices, places, middle[stretch], half[stretch])
    at_ends = np.concatenate([[-1.0], places, [1.0]])
    points = middle[:, None] + half[:, None] * at_ends
    points = points.ravel()
    arc_of_segment = slices.arc[segments]
    layer_of_segment = slices.layer[segments]
    _, arc = np.unique(arc_of_segment, return_inverse=True)
    each = at_ends.size
    return Points(
        sine=np.sin(points),
        cosine=np.cos(points),
        layer=np.repeat(layer_of_segment, each),
        arc=np.repeat(arc, each),
        lane=np.repeat(arc_of_segment, each),
        slices=slices,
        shares=shares,
        segments=segments,
        is_shared=is_shared,
    )


def _shares(slices: Slices, places: Floats, middle: Floats, half: Floats) -> Floats:
    """Return the integrals of Lagrange's polynomials of places at nodes, and nothing at both ends."""
    angle = np.arctan2(slices.sine, slices.cosine)
    place = (angle - middle) / half
    weight = slices.weight
    degree = places.size - 1
    to_lagrange = np.linalg.inv(chebyshev.chebvander(places, degree))
    polynomials = chebyshev.chebvander(place, degree) @ to_lagrange
    weighted = weight[..., None] * polynomials
    return np.pad(weighted, [(0, 0), (0, 0), (1, 1)])


def _integrands(slices: Slices, height: Floats, surface: Any) -> Floats:
    """Return the integrands of a material of unit weight between the arc and a surface, (7, nodes, intervals).

    Vertical stress, normal stresses of the closure and of the ordinary method, driving moment; the last three under
    k_h = 1, of the closure its increase alone.
    """
    sine, cosine = slices.sine, slices.cosine
    distance = slices.distance(surface)
    rows = [
        height,
        slopes.radial_weight(cosine, distance),
        slopes.ordinary_normal(sine, cosine, height, 0.0, 0.0),
        slopes.drive(sine, cosine, height, 0.0),
        slopes.radial_tilt(sine, cosine, height, distance),
        slopes.ordinary_normal(sine, cosine, height, 0.0, 1.0),
        slopes.drive(0.0, cosine, height, 1.0),
    ]
    stacked = np.stack(rows)
    return np.where(height > 0.0, stacked, 0.0)


def _integrands_of_load(slices: Slices) -> Floats:
    """Return the same of surcharges, which act on the ground."""
    sine, cosine = slices.sine, slices.cosine
    load = slices.at(slices.stresses.load)
    lever = -slices.surface(0) * cosine * load
    distance = slices.distance(0)
    ordinary = slopes.ordinary_normal(sine, cosine, load, 0.0, 0.0)
    shaken = slopes.ordinary_normal(sine, cosine, load, 0.0, 1.0)
    drive = slopes.drive(sine, cosine, load, 0.0)
    radial = lever / distance
    tilt = load * cosine * sine / distance
    return np.stack([load, radial, ordinary, drive, tilt, shaken, lever])


def _balance(slope: SlopeArrays, points: Points, method: str) -> Balance:
    """Return the balance of arcs with the soils of lanes, over R^3."""
    moments, soil_stress = _moments(slope, points)
    vertical, radial, ordinary, drive, tilt, ordinary_shaken, shaking = moments
    pressure, cohesion = _pressure_and_cohesion(slope, points, soil_stress)
    friction = points.of_soils(slope.soils.friction)
    lever = points.cosine[:, None]
    grip = -friction * points.sine[:, None]
    normal = vertical
    loss = np.zeros_like(friction)
    if method == "ordinary":
        normal = ordinary
        loss = friction * (ordinary - ordinary_shaken)
        lever = np.ones_like(lever)
        grip = np.zeros_like(grip)
    effective = normal - pressure
    strength = (cohesion + friction * effective) * lever
    of_friction = friction * (radial - pressure)
    every_lane = np.zeros_like(strength[points.first])
    sums = []
    for values in (drive, shaking, cohesion, of_friction, friction * tilt, loss, friction):
        of_arcs = points.over_arcs(values)
        sums.append(of_arcs + every_lane)
    return Balance(points, strength, lever, grip, *sums)


def _moments(slope: SlopeArrays, points: Points) -> tuple[Floats, Floats]:
    """Return the sums of `_integrands` of soils and surcharges, (7, points, 1 or lanes), and the stress of the soil."""
    slices = points.slices
    weights = slope.soils.unit_weight[0]
    if points.is_shared:
        weights = weights[:1]  # over which the stresses of slices are
    of_load = points.sums(_integrands_of_load(slices))[..., None]
    moments = of_load * points.of_lanes(weights)
    soil_stress: Any = 0.0
    for surface, step in _steps(slope):
        height = np.maximum(slices.surface(surface) + slices.cosine, 0.0)
        of_unit_weight = points.sums(_integrands(slices, height, surface))[..., None]
        of_step = of_unit_weight * points.of_lanes(step)
        vertical, *_ = of_step
        soil_stress = soil_stress + vertical
        moments = moments + of_step
    return moments, soil_stress


def _pressure_and_cohesion(slope: SlopeArrays, points: Points, soil_stress: Floats) -> tuple[Floats, Floats]:
    """Return pore pressure and cohesion at points, over R."""
    slices = points.slices
    soils = slope.soils
    radius = slices.arcs.radius[points.lane][:, None]
    length = points.sums(np.ones_like(slices.sine))[:, None]
    ratio = points.of_soils(soils.pore_ratio)
    uniform = points.of_lanes(slope.pressure) / radius
    pressure = ratio * soil_stress + uniform * length
    if slope.level is not None:
        level = len(slope.tops) + 1
        head = np.maximum(slices.surface(level) + slices.cosine, 0.0)
        of_head = points.sums(head)[:, None] * slope.water_unit_weight
        pressure = pressure + np.where(ratio > 0.0, 0.0, of_head)
    depth = points.sums(_below_datum(slices, soils))[:, None]
    growth = points.of_soils(soils.cohesion_gradient) * depth
    cohesion = points.of_soils(soils.cohesion) / radius
    return pressure, cohesion * length + growth


def _steps(slope: SlopeArrays) -> Iterator[tuple[int, Floats]]:
    """Yield the surfaces below which there is another unit weight, and by how much."""
    soils = slope.soils
    steps = np.diff(soils.unit_weight, axis=0, prepend=0.0)
    yield from enumerate(steps)
    if slope.saturates:
        gain = soils.saturated_unit_weight - soils.unit_weight
        wet_steps = np.diff(gain, axis=0, prepend=0.0)
        yield from enumerate(wet_steps, len(gain) + 1)


def _below_datum(slices: Slices, soils: SoilArrays) -> Floats:
    """Return the depth below the height from which the cohesion of the base grows, over R."""
    lane = slices.arc if soils.datum.shape[1] > 1 else 0
    datum = soils.datum[slices.layer, lane]
    centre = slices.arcs.centre[slices.arc, 1]
    radius = slices.arcs.radius[slices.arc]
    above_centre = (datum - centre) / radius
    depth: Floats = np.maximum(above_centre + slices.cosine, 0.0)
    return depth
