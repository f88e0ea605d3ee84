"""Factors of safety and yield coefficients of many slip circles at once, by the balance of slices above each arc."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from generated import slopes
from slipcircle.base.arrays import quiet
from slipcircle.base.kinds import ArrayDict, ArrayPair, Floats
from slipcircle.ground import sine_and_cosine
from slipcircle.layers import crack_place
from slipcircle.workbench.stability.bases import Arcs, Circles, angle_from_below
from slipcircle.workbench.stability.columns import SlopeArrays
from slipcircle.workbench.stability.freewater import at_shores, level_at_exit, submerged
from slipcircle.workbench.stability.slices import EXACT, Rule, Slices, slices_above

YIELD = "k_y"  # least yield coefficient, in the place of a method
LEAST_LEVER = 0.05  # of m_alpha: below, Bishop's normal stress is meaningless
_LEAST_FACTOR = 5e-3  # by Bishop's method
_TO_FACE = Rule(nodes=2)  # enough to determine the direction in which a mass slides
_NEWTON_STEPS = 20
_CLOSE = 1e-9  # relative change of a converged factor


class Driven(NamedTuple):
    """Slices with angles positive down-slope, and driving moments about the centre over gamma R^3."""

    slices: Slices
    facing: Floats  # 1 where the mass slides to the right, -1 to the left, 0 where nothing drives it
    gravity: Floats  # its moment, NaN where nothing slides
    driving: Floats  # with k_h


def circle_factors(slope: SlopeArrays, circles: Circles, rule: Rule = EXACT) -> ArrayDict:
    """Return factors of safety of the masses between circles and the ground, with ends at two points of the ground.

    Parameters
    ----------
    slope : SlopeArrays
        One slope, or one for each circle.
    circles : tuple of ndarray
        Centres, (n, 2), and radii, (n,), in m, and left and right ends of the arcs, (n, 2), in m, between which the
        ground lies inside the circle.
    rule : Rule
        Points of the integrals. More pieces resolve ``negative``.

    Returns
    -------
    dict of ndarray
        Factors by method, NaN where it refuses the circle. ``facing``: 1 if the mass slides to the right, -1 if to the
        left, 0 if nothing drives it. ``negative``: share of the arc under negative effective normal stress, by the
        ordinary method or by Bishop's, if greater. ``k_y``: the k_h, in the place of the slope's, by which the paper's
        factor is 1; negative where the mass slides without; NaN where none is.

    Notes
    -----
    Water: the ordinary method takes N' = W cos(a) - u l, which reproduces published factors (Fredlund and Krahn 1977);
    its other convention, (W - u b) cos(a), gives greater ones. Bishop's method refuses a circle where m_alpha falls
    below 0.05; all methods refuse one that overhangs at an end, or whose centre lies below the ground.
    """
    driven = driven_slices(slope, circles, rule)
    slices = driven.slices
    with quiet():
        factors = {method: value(driven) for method, value in _VALUES.items()}
    ordinary = slices.integral(slices.ordinary_normal() < 0.0)
    bishop = slices.integral(bishop_normal(slices, factors["bishop"]) < 0.0)
    with quiet():
        negative = np.maximum(ordinary, bishop) / slices.integral(1.0)
    return factors | {"facing": driven.facing, "negative": negative}


def factors_by(slope: SlopeArrays, circles: Circles, method: str, rule: Rule = EXACT) -> ArrayPair:
    """Return factors of safety (or yield coefficients) by a method, (n,), and the direction in which each mass slides.

    The direction is 1 to the right, -1 to the left, 0 without drive. Circles are given as for `circle_factors`.
    """
    every_surface = method in ("paper", YIELD) or np.any(slope.k_h)
    driven = driven_slices(slope, circles, rule, bool(every_surface))
    with quiet():
        return factor_by(method, driven), driven.facing


def factor_by(method: str, driven: Driven) -> Floats:
    """Return the factors of safety of arcs, (n,), by "paper", "ordinary" or "bishop", or yield coefficients ("k_y")."""
    return _VALUES[method](driven)


# --- what drives -----------------------------------------------------------------------------------------------------


def driven_slices(slope: SlopeArrays, circles: Circles, rule: Rule = EXACT, every_surface: bool = True) -> Driven:
    """Return the slices of arcs and their driving moments; circles are given as for `circle_factors`.

    With ``every_surface``, slices contain all surfaces at which the unit weight changes, otherwise the ground alone.
    """
    arcs = _arcs(slope, circles)
    cracked = bool(np.any(slope.crack))
    slices = slices_above(slope, arcs, _TO_FACE if cracked else rule, every_surface)
    moment, weight = slices.driving_moment()
    gravity = moment + at_shores(slope, arcs)
    negligible = 1e-9 * weight
    facing = np.where(np.abs(gravity) > negligible, np.sign(gravity), 0.0)
    if cracked:
        arcs = _cracked(slope, arcs, facing)
        slices = slices_above(slope, arcs, rule, every_surface)
        gravity = slices.driving_moment()[0] + at_shores(slope, arcs)
    slices = slices.facing(facing)
    if slope.ponds is not None:
        slices = submerged(slices, level_at_exit(slope.ponds, arcs, facing))
    gravity = facing * gravity + _crack_water(slope, arcs.radius, np.where(facing > 0.0, arcs.first, arcs.last))
    driving = gravity
    if np.any(slope.k_h):
        driving = gravity + slope.k_h * slices.shaking_moment()
    slides = arcs.valid & (facing != 0.0)
    gravity = np.where(slides, gravity, np.nan)
    driving = np.where(slides & (driving > negligible), driving, np.nan)
    return Driven(slices, facing, gravity, driving)


def _arcs(slope: SlopeArrays, circles: Circles) -> Arcs:
    """Return the arcs of circles; invalid are those somewhere vertical or with the centre below the ground."""
    centre, radius, left, right = circles
    first = angle_from_below(centre, left)
    last = angle_from_below(centre, right)
    overhangs = (first < -np.pi / 2) | (last > np.pi / 2)
    lies_below_centre = (first < 0.0) & (last > 0.0)
    x, y = centre.T
    buried = lies_below_centre & (slope.ground_height(x) >= y)
    return Arcs(centre, radius, first, last, (first < last) & ~overhangs & ~buried)


def _cracked(slope: SlopeArrays, arcs: Arcs, facing: Floats) -> Arcs:
    """Return arcs that begin at the bottom of a tension crack, where the ground is the crack's depth above them.

    ``facing`` is the direction of sliding as in `Driven`. Arcs without such a point become invalid.
    """
    depth = np.reshape(slope.crack, (-1, 1))
    lowered_ground = slope.lines[0] - np.stack([np.zeros_like(depth), depth], axis=-1)
    sine = crack_place(arcs.from_centre(lowered_ground), np.sin(arcs.first), np.sin(arcs.last), facing)
    place = np.where(facing == 0.0, 0.0, np.arcsin(sine))
    first = np.where(facing > 0.0, place, arcs.first)
    last = np.where(facing < 0.0, place, arcs.last)
    deep_enough = np.isfinite(place) & (first < last)
    return arcs._replace(
        first=np.where(deep_enough, first, 0.0), last=np.where(deep_enough, last, 0.0), valid=arcs.valid & deep_enough
    )


def _crack_water(slope: SlopeArrays, radius: Floats, bottom: Floats) -> Any:
    """Return the moment over gamma R^3 of water in the crack at the upper end: gamma_w h^2/2 at a third of its height.

    ``bottom`` is the angle of the bottom of the crack from straight below the centre, rad, (n,).
    """
    height = slope.crack_water / radius
    unit_weight = slope.water_unit_weight / slope.soils.unit_weight[0]
    return unit_weight * height**2 / 2 * (np.cos(bottom) - height / 3)


# --- what resists ----------------------------------------------------------------------------------------------------


def _paper(driven: Driven) -> Floats:
    """Return factors from the mean normal stress. The sum of friction over the arc is included where it is positive."""
    slices = driven.slices
    normal = slices.radial_normal()
    if np.any(slices.k_h):
        normal = normal + slices.k_h * slices.radial_tilt()
    friction = slices.integral(slices.friction * normal)
    return (slices.integral(slices.cohesion()) + np.maximum(friction, 0.0)) / driven.driving


def _ordinary(driven: Driven) -> Floats:
    """Return factors from the stress normal to the base of each slice, without forces between slices."""
    slices = driven.slices
    return slices.integral(slices.cohesion() + slices.friction * slices.ordinary_normal()) / driven.driving


def _yield_coefficient(driven: Driven) -> Floats:
    """Return k_h at which the driving moment G + k_h S equals the paper's resistance C + P + k_h T.

    G of gravity, S of shaking, C of cohesion, and P + k_h T of friction, which does not act where it is negative.
    Surcharges are shaken as well, as in a motion.
    """
    slices = driven.slices._replace(shaken_load=1.0)
    shaking = slices.shaking_moment()
    friction = slices.integral(slices.friction * slices.radial_normal())
    tilt = slices.integral(slices.friction * slices.radial_tilt())
    missing = slices.integral(slices.cohesion()) - driven.gravity  # of friction to be in balance
    with_friction = (missing + friction) / (shaking - tilt)
    lifted = friction + with_friction * tilt < 0.0
    grows = shaking > np.where(lifted, 0.0, tilt)
    return np.where(grows, np.where(lifted, missing / shaking, with_friction), np.nan)


def _bishop(driven: Driven) -> Floats:
    """Return Bishop's factor F = 1/y, from the balance of moments in y.

    y times the integral of strength/m_alpha(y), which grows with y, equals the driving moment. The strength is Bishop's
    (1955), [c + mu (W/b - u)] cos a/m_alpha. Newton steps are taken for all arcs at once, within the range of y in
    which m_alpha = cos a - y mu sin a is at least ``LEAST_LEVER`` at all ends of intervals (m_alpha has no minimum
    between them).
    """
    slices = driven.slices
    friction = slices.friction
    tangent = slices.sine / slices.cosine
    lowest, highest = lever_range(slices)
    by_breadth = slopes.bishop_strength(1.0, slices.vertical(), 0.0, slices.cohesion(), friction)
    strength = slices.weight * by_breadth
    driving = driven.driving
    start = slices.sums(strength * slices.cosine) / driving
    start = np.maximum(start, _LEAST_FACTOR)
    y = np.clip(1.0 / start, lowest, highest)
    y = np.where(lowest < highest, y, np.nan)
    for _ in range(_NEWTON_STEPS):
        factor = 1.0 / y
        lever = slopes.bishop_lever(tangent, 1.0, friction, slices.of_arcs(factor))  # over cos a
        shear = strength / lever
        excess = y * slices.sums(shear) - driving
        shear /= lever
        growth = slices.sums(shear)  # d(y/m_alpha)/dy = cos/m_alpha^2
        y = np.clip(y - excess / growth, lowest, highest)
        change = np.abs(y * factor - 1.0)
        if not np.any(change > _CLOSE):
            break
    balanced = np.abs(excess) <= _CLOSE * driving
    return np.where(balanced, 1.0 / y, np.nan)


def bishop_normal(slices: Slices, factor: Floats) -> Any:
    """Return the effective normal stress of Bishop's simplified method over gamma R at the points of the slices.

    ``factor`` is the factor of safety of each arc.
    """
    sine = slices.sine
    cosine = slices.cosine
    effective = slices.vertical()
    of_arc = slices.of_arcs(factor)
    return slopes.bishop_normal(sine, cosine, effective, 0.0, slices.cohesion(), slices.friction, of_arc)


def lever_range(slices: Slices) -> ArrayPair:
    """Return the least and greatest 1/F, each (n,), for which m_alpha remains above `LEAST_LEVER` on an arc."""
    greatest = 1.0 / _LEAST_FACTOR
    friction = slices.friction * slices.way
    ends = slices.ends.reshape(2, *(1,) * (friction.ndim - 1), -1)
    of_ends, cosine = sine_and_cosine(ends)
    sine = friction * of_ends
    room = cosine - LEAST_LEVER
    above = np.where(sine > 0.0, np.maximum(room, 0.0) / sine, greatest)
    above = above.min(axis=0)
    below = np.where((sine < 0.0) & (room < 0.0), room / sine, 0.0)
    below = below.max(axis=0)
    if below.ndim > 1:
        lowest = below.max(axis=-1, initial=0.0)
        highest = above.min(axis=-1, initial=greatest)
        return lowest, highest
    count = len(slices.arcs.radius)
    lowest = np.zeros(count)
    highest = np.full(count, greatest)
    if len(slices.arc):
        begins = np.flatnonzero(np.diff(slices.arc, prepend=-1))
        arcs = slices.arc[begins]
        lowest[arcs] = np.maximum.reduceat(below, begins)
        highest[arcs] = np.minimum.reduceat(above, begins)
    return lowest, highest


_VALUES = {"paper": _paper, "ordinary": _ordinary, "bishop": _bishop, YIELD: _yield_coefficient}
