"""Slices above many arcs at once: weights, loads, pore pressures and strengths, and integrals over the arcs.

Sums over slices are integrals along the arc, by Gauss' rule between its kinks: below vertices and crossings of lines,
where it crosses a line, and where cohesion begins to grow with depth. So factors are converged values and not those of
a number of slices. Between kinks every line is straight, so that each stress is linear in the sine and the cosine of
the angle: three numbers for each interval.
"""

from __future__ import annotations

from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import slopes
from slipcircle.base.kinds import ArrayPair, Flags, Floats
from slipcircle.ground import sine_and_cosine
from slipcircle.layers import meets_circle
from slipcircle.workbench.stability.bases import Arcs, Bases, BaseStresses
from slipcircle.workbench.stability.columns import SlopeArrays

_GROUND = np.zeros(1, dtype=np.int64)  # number of the ground among the surfaces
_INSIDE = 0.45  # of an interval, where its soil is looked up: not its middle, at which arcs touch level boundaries


class Rule(NamedTuple):
    """Gauss' rule on the pieces of arcs.

    Attributes
    ----------
    nodes : int
        Number of points in each interval.
    pieces : int
        Number of equal pieces of each arc.
    at_kinks : bool
        Whether pieces are divided at the kinks of the integrands.
    widest : float
        Greatest angle of an interval in rad; wider ones are divided.
    """

    nodes: int = 10
    pieces: int = 1
    at_kinks: bool = True
    widest: float = 4.0  # wider than every arc


EXACT = Rule()


class Slices(NamedTuple):
    """Slices above the points of Gauss' rule, (points, intervals), with lengths over R and stresses over gamma R.

    An interval is the part of one arc between two kinks. Where slopes share one arc, what differs has an axis of slopes
    before the axis of the intervals. Angles are from straight below the centre. Weights are sums
    over surfaces: the tops of layers, each with the step of the unit weight there, and of their wet parts; and the part
    of the ground below a pond, with minus the water's.
    """

    arcs: Arcs
    arc: NDArray[np.int64]  # number of the arc of each interval
    ends: Floats  # angles of both ends of each interval, (2, intervals)
    weight: Floats  # of a point in the integral over the angle
    sine: Floats
    cosine: Floats
    way: Any  # -1 where angles are counted to the left, by interval
    stresses: BaseStresses
    friction: Floats  # of each interval
    k_h: Floats
    shaken_load: Any  # share of the surcharge on which k_h acts
    water: Floats  # unit weight over gamma
    steps: Floats  # of the unit weight below each surface, 0 where it is not above the arc, (surfaces, intervals)
    constant: Floats  # height of a surface above the centre is constant + gradient sine
    gradient: Floats
    shaken: Flags  # surfaces of soil, not of water

    def at(self, linear: Any) -> Any:
        """Return the value at each point from coefficients of 1, sine and cosine, (3, intervals)."""
        constant, of_sine, of_cosine = linear
        return constant + of_sine * self.sine + of_cosine * self.cosine

    def integral(self, values: Any) -> Floats:
        """Return the integral over each arc, (arcs,), or for each slope that shares the arc.

        The values are a number, or given at the points, (points, intervals).
        """
        return self.sums(self.weight * values)

    def sums(self, weighted: Any) -> Floats:
        """Return `integral` of values that are times the weights of the points already."""
        by_interval = weighted.sum(axis=0)
        if by_interval.ndim > 1:
            return np.asarray(by_interval.sum(axis=-1))
        return np.bincount(self.arc, by_interval, len(self.arcs.radius)).astype(np.float64)

    def of_arcs(self, values: Floats) -> Floats:
        """Return a number of each arc, (arcs,), by interval, or of each slope that shares the only arc as a column."""
        return values[:, None] if self.sine.ndim > 2 else values[self.arc]

    def facing(self, way: Floats) -> Slices:
        """Return the slices with angles positive down-slope, for arcs that slide to the right (1) or left (-1)."""
        sense = way[self.arc]
        return self._replace(
            sine=self.sine * sense, gradient=self.gradient * sense, stresses=self.stresses.turned(sense), way=sense
        )

    def driving_moment(self) -> ArrayPair:
        """Return the moment of gravity and displaced water about the centre of each arc, over gamma R^3, and its scale.

        The moment is positive if it drives the mass to the right. Its scale is the integral of the weight.
        """
        stresses = self.stresses
        vertical = self.at(stresses.soil + stresses.displaced + stresses.load)
        weighted = self.weight * vertical
        weight = self.cosine * weighted
        moment = slopes.drive(self.sine, self.cosine, weighted, 0.0)
        return self.sums(moment), self.sums(weight)

    def shaking_moment(self) -> Floats:
        """Return the moment of k_h = 1 over gamma R^3, on soil at half its height and on surcharges at the ground."""
        load = self.at(self.stresses.load) * self.cosine
        moment = load * -self.surface(0) * self.shaken_load
        for k in np.flatnonzero(self.shaken):
            height = self.surface(k) + self.cosine
            of_unit_weight = slopes.drive(0.0, self.cosine, height, 1.0)
            moment = moment + self.steps[k] * of_unit_weight
        return self.integral(moment)

    def surface(self, k: Any) -> Floats:
        """Return the height of the surface with index ``k`` above the centre, over R, at the points."""
        return self.constant[k] + self.gradient[k] * self.sine

    def distance(self, k: Any) -> Floats:
        """Return the distance of the surface with index ``k`` from the centre, over R, at the points."""
        square = self.sine**2 + self.surface(k) ** 2
        return np.sqrt(square)

    def uplift(self) -> Floats:
        """Return the pore pressure in excess of water at rest with the level at the exit, over gamma R, at the points.

        The pressure of this water is taken at the height of each point. It is 0 above its level, or if the exit is dry.
        """
        stresses = self.stresses
        return self.at(stresses.pressure - stresses.relieved)

    def ordinary_normal(self) -> Floats:
        """Return the effective normal stress of the ordinary method (Fellenius 1936) over gamma R at the points."""
        sine, cosine = self.sine, self.cosine
        stresses = self.stresses
        not_shaken = self.at(stresses.buoyancy + stresses.load)
        loads = slopes.ordinary_normal(sine, cosine, not_shaken, 0.0, 0.0)
        if np.any(self.k_h * self.shaken_load):
            load = self.at(stresses.load)
            shaken = self.k_h * sine * cosine * load
            loads = loads + shaken * self.shaken_load
        weight = self.at(stresses.soil)
        uplift = self.uplift()
        soil = slopes.ordinary_normal(sine, cosine, weight, uplift, self.k_h)
        across = self.gradient[0] * sine + cosine
        pressure = self.at(stresses.excess) * cosine
        return soil + loads + pressure * across

    def radial_normal(self) -> Floats:
        """Return the effective normal stress of the paper's method by strips, with the weights of (2.23) above."""
        normal = -self.uplift()
        for k in np.flatnonzero(_any_of_each(self.steps)):
            of_unit_weight = slopes.radial_weight(self.cosine, self.distance(k))
            normal = normal + self.steps[k] * of_unit_weight
        if np.any(self.stresses.load):
            load = self.at(self.stresses.load) * self.cosine
            normal = normal + load * -self.surface(0) / self.distance(0)
        if np.any(self.stresses.excess):
            pressure = self.at(self.stresses.excess) * self.cosine
            across = self.gradient[0] * self.sine - self.surface(0)
            normal = normal + pressure * across / self.distance(0)
        return normal

    def radial_tilt(self) -> Floats:
        """Return the change of the paper's normal stress by k_h = 1, over gamma R, at the points."""
        load = self.at(self.stresses.load) * self.cosine
        tilt = load * self.sine / self.distance(0)
        tilt = tilt * self.shaken_load
        for k in np.flatnonzero(self.shaken):
            height = self.surface(k) + self.cosine
            distance = self.distance(k)
            of_unit_weight = slopes.radial_tilt(self.sine, self.cosine, height, distance)
            tilt = tilt + self.steps[k] * of_unit_weight
        return tilt

    def vertical(self) -> Floats:
        """Return the effective vertical stress on the arc over gamma R at the points, for Bishop's method.

        On a thin mass it is a small difference, whose terms must not be rounded before they are added.
        """
        stresses = self.stresses
        return self.at(stresses.soil + stresses.load + stresses.pond - stresses.pressure)

    def cohesion(self) -> Floats:
        """Return the cohesion on the arc over gamma R at the points."""
        return self.at(self.stresses.cohesion)


def _any_of_each(rows: Floats) -> Flags:
    """Return for each row, along the first axis, whether it has a number other than 0, (rows,)."""
    return np.any(rows.reshape(len(rows), -1), axis=1)


@cache
def _gauss(nodes: int) -> ArrayPair:
    """Return the points and the weights of Gauss' rule on [-1, 1], (nodes,) each."""
    return np.polynomial.legendre.leggauss(nodes)


def slices_above(slope: SlopeArrays, arcs: Arcs, rule: Rule = EXACT, every_surface: bool = True) -> Slices:
    """Return the slices above valid arcs; ``rule`` sets the points of the integrals.

    With ``every_surface``, they contain all surfaces at which the unit weight changes, otherwise the ground alone.
    """
    arc, ends = _intervals(slope, arcs, rule)
    first, last = ends
    half = (last - first) / 2
    middle = (first + last) / 2
    inside = first + _INSIDE * (last - first)
    base = Bases(slope, arcs, arc, inside)
    nodes_at, weights = _gauss(rule.nodes)
    angle = middle + half * nodes_at[:, None]
    weight = half * weights[:, None]
    if base.is_shared:
        angle = angle[:, None]
        weight = weight[:, None]
    changes = np.flatnonzero(np.any(slope.steps, axis=1)) if every_surface else _GROUND
    steps, constant, gradient = base.loads(changes)
    sine, cosine = sine_and_cosine(angle)
    return Slices(
        arcs=arcs,
        arc=arc,
        ends=ends,
        weight=weight,
        sine=sine,
        cosine=cosine,
        way=1.0,
        stresses=base.stresses(),
        friction=base.soil.friction,
        k_h=base.of_slope(slope.k_h),
        shaken_load=base.of_slope(slope.k_h_on_surcharge),
        water=base.water,
        steps=steps,
        constant=constant,
        gradient=gradient,
        shaken=_any_of_each(steps),
    )


def _intervals(slope: SlopeArrays, arcs: Arcs, rule: Rule) -> tuple[NDArray[np.int64], Floats]:
    """Return the index of the arc, (intervals,), and the angles of both ends in rad, (2, intervals), of intervals."""
    angles = np.linspace(arcs.first, arcs.last, rule.pieces + 1, axis=1)
    if rule.at_kinks:
        first = arcs.first[:, None]
        last = arcs.last[:, None]
        kinks = np.clip(_kinks(slope, arcs), first, last)
        angles = np.concatenate([angles, kinks], axis=1)
        angles.sort(axis=1)
    first = angles[:, :-1]
    last = angles[:, 1:]
    width = np.fmax.reduce(last - first, axis=None, initial=0.0)
    places = np.arange(0.0, width, rule.widest)
    first = first[..., None] + places
    last = np.minimum(first + rule.widest, last[..., None])
    is_interval = (last > first) & arcs.valid[:, None, None]
    ends = np.stack([first[is_interval], last[is_interval]])
    return np.nonzero(is_interval)[0], ends


def _kinks(slope: SlopeArrays, arcs: Arcs) -> Floats:
    """Return angles in rad at which an integrand may not be smooth, (n, any); some of them are outside the arcs."""
    bounds = (slope.columns.bounds - arcs.centre[:, :1]) / arcs.radius[:, None]
    cuts = meets_circle(arcs.from_centre(slope.lines_cut_by_arcs))
    sines = np.concatenate([bounds, cuts], axis=1)
    after_first = sines > np.sin(arcs.first)[:, None]
    before_last = sines < np.sin(arcs.last)[:, None]
    of_any_arc = np.any(after_first & before_last, axis=0)
    within_circle = np.clip(sines[:, of_any_arc], -1.0, 1.0)
    return np.arcsin(within_circle)
