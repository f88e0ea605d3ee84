"""Strength factors that make a motion start from the result of another method.

The balance of a motion has the closure of the paper's method. With strength multiplied by F_method/F_paper it starts
from the factor of safety of the method. Under shaking the yield coefficients are to be equal, so that strength is
divided by the paper's factor under the yield coefficient of the method.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from slipcircle.base.arrays import quiet
from slipcircle.base.kinds import Floats
from slipcircle.layers import LayeredSection
from slipcircle.workbench.stability.bases import Circles
from slipcircle.workbench.stability.columns import SlopeArrays
from slipcircle.workbench.stability.factors import YIELD, Driven, bishop_normal, driven_slices, factor_by, lever_range
from slipcircle.workbench.stability.slices import Rule
from slipcircle.workbench.stability.stability import circles_of, circles_of_lanes, soil

_TOUCHES = 1e-9  # over R: as deep below the water level, ground is not covered
_RULE = Rule(nodes=7, widest=0.26)  # random factors are accurate to 1e-14
OF_CLOSURE = "paper"  # the method whose factor of safety the balance of a motion has at the start


def strength_factor(scene: Any, method: str) -> Any:
    """Return the factor on strength by which a scene on a ground starts from the result of a method.

    Parameters
    ----------
    scene : Scene
        With friction and pore pressure of time 0, and with "shaking" among its effects or not.
    method : str

    Returns
    -------
    float or ndarray
        In the shape of the scene. Exactly 1 without friction or members, and where nothing drives the mass; NaN where
        the method refuses the circle.
    """
    if method == OF_CLOSURE:
        return 1.0
    shaken = "shaking" in scene.effects
    factor = _of_scene(scene, lambda driven: _of_circles(driven, method, shaken))
    return 1.0 if factor is None else factor


def _of_scene(scene: Any, result: Callable[[Driven], Floats], slipped: bool = False) -> Any:
    """Return the ``result`` of the slices of a scene's arcs in its shape; None if the strength is unknown or zero.

    The function ``result`` gives one number for each arc; with ``slipped``, strength is residual.
    """
    if 0 in scene.shape or not soil(scene.friction, scene.effects, slipped):
        return None
    blocks = []
    for driven, lanes in driven_blocks(scene, slipped):
        with quiet():
            results = result(driven)
        blocks.append(np.broadcast_to(results, lanes))
    values = np.concatenate(blocks).reshape(scene.shape)
    return values if scene.shape else float(values)


def driven_blocks(scene: Any, slipped: bool = False, rule: Rule = _RULE, **most: int) -> Iterator[tuple[Driven, int]]:
    """Yield the slices of the arcs of a scene and the number of lanes, in the blocks of `circles_of`.

    With ``slipped``, strength is residual; ``rule`` sets the points of the integrals, and ``most`` is the greatest
    number of lanes in a block.
    """
    for slope, circles, lanes in circles_of(scene, slipped, **most):
        if not _is_shared(slope, circles):
            circles = circles_of_lanes(circles, lanes)
        driven = driven_slices(slope, circles, rule)
        yield driven, lanes


def yield_by(scene: Any, method: str) -> Any:
    """Return the yield coefficient (k_h for F = 1) at the start by a method; None if no strength is known."""
    return _of_scene(scene, lambda driven: yield_coefficient(driven, method))


def factor_of(scene: Any, method: str, slipped: bool = False) -> Any:
    """Return the factor of safety of the original geometry by a method, at the start or with residual strength.

    The result is None if the strength is unknown, and NaN if the method refuses the circle.
    """
    return _of_scene(scene, lambda driven: factor_by(method, driven), slipped)


def at_rest_by(scene: Any, method: str, rotation: float, friction: float, kept: float) -> float | None:
    """Return the factor of safety by a method after a rotation in rad, with the remaining friction and cohesion.

    ``kept`` is the remaining share of cohesion. The result is None except for single masses of one soil whose water
    does not change with time or cover the turned ground.
    """
    section = scene.arc
    water = scene.called.get("pore_pressure", {})
    cohesion = scene.effects.get("cohesion", {})
    changes = [
        isinstance(section, LayeredSection),
        "thermal_pressurisation" in scene.effects,
        "datum" in cohesion,
        "record" in water,
        "time" in water,
        callable(water.get("ratio")),
        callable(water.get("pressure")),
    ]
    if any(changes):
        return None
    turns = rotation if "rotation" in scene.effects else 0.0
    turned = section.placed(section.surface, turns)
    width = np.diff(turned[:, 0])
    depth = section.drowned(turns)
    touches = _TOUCHES * section.radius
    if np.any(width < 0.0) or section.in_standing_water or depth > touches:
        return None
    ((slope, circles, _),) = circles_of(scene)
    centre, radius, *_ = circles
    left = turned[:1]
    right = turned[-1:]
    rest = np.full_like(slope.soils.friction, friction)
    soils = slope.soils
    cohesion = soils.cohesion * kept
    growth = soils.cohesion_gradient * kept
    soils = soils._replace(friction=rest, cohesion=cohesion, cohesion_gradient=growth)
    moved = replace(slope, ground=turned[None], soils=soils)
    driven = driven_slices(moved, (centre, radius, left, right), _RULE)
    with quiet():
        return float(factor_by(method, driven)[0])


def _is_shared(slope: SlopeArrays, circles: Circles) -> bool:
    """Return whether all lanes (members of an ensemble) have the same ground, circle and loads, and no free water."""
    lines = [slope.ground, *slope.tops, *circles]
    if slope.level is not None:
        lines.append(slope.level)
    for _, _, left, right in slope.surcharge:
        lines += [left, right]
    return slope.ponds is None and all(len(line) == 1 for line in lines)


def _of_circles(driven: Driven, method: str, shaken: bool) -> Floats:
    """Return the strength factors of arcs for a start by a method; if ``shaken``, from equal yield coefficients."""
    if shaken:
        k_h = yield_coefficient(driven, method)
        shaken_arcs = _under(k_h, driven)
        factor = 1.0 / factor_by(OF_CLOSURE, shaken_arcs)
    else:
        target = factor_by(method, driven)
        of_closure = factor_by(OF_CLOSURE, driven)
        factor = target / of_closure
    slices = driven.slices
    return np.where((slices.integral(slices.friction) > 0.0) & (driven.facing != 0.0), factor, 1.0)


def _under(k_h: Floats, driven: Driven) -> Driven:
    """Return arcs under a horizontal acceleration of k_h g, (arcs,), which acts on surcharges as well."""
    slices = driven.slices
    shaken = slices._replace(k_h=slices.of_arcs(k_h), shaken_load=1.0)
    return driven._replace(slices=shaken, driving=driven.gravity + k_h * shaken.shaking_moment())


def yield_coefficient(driven: Driven, method: str) -> Floats:
    """Return the k_h, (arcs,), for which the factor of safety by a method is 1, NaN if there is none."""
    if method == OF_CLOSURE:
        return factor_by(YIELD, driven)
    none = np.zeros_like(driven.gravity)
    unit = np.ones_like(driven.gravity)
    still = _under(none, driven)
    moved = _under(unit, driven)
    at_rest = _resistance(still, method)
    shaken = _resistance(moved, method)
    return (at_rest - driven.gravity) / (moved.driving - driven.gravity - shaken + at_rest)


def _resistance(driven: Driven, method: str) -> Floats:
    """Return the resisting moment over gamma R^3 by a method at F = 1, where Bishop's does not depend on k_h."""
    if method != "bishop":
        return factor_by(method, driven) * driven.driving
    slices = driven.slices
    lowest, highest = lever_range(slices)
    one = np.ones_like(lowest)
    friction = slices.friction * bishop_normal(slices, one)
    return np.where((lowest < 1.0) & (highest > 1.0), slices.integral(slices.cohesion() + friction), np.nan)
