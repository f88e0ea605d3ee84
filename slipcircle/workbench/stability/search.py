"""Search for the critical circle of a slope: a coarse family of circles, then refinement in the best valleys."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from slipcircle.base.errors import raise_all
from slipcircle.base.inputerror import InputError
from slipcircle.base.kinds import Floats, Pair, Tell, Texts, Values
from slipcircle.base.text import amount_text
from slipcircle.workbench.stability.condensed import least
from slipcircle.workbench.stability.critical import Critical, circle_of
from slipcircle.workbench.stability.factors import YIELD
from slipcircle.workbench.stability.family import Search
from slipcircle.workbench.stability.stability import METHODS, Slope, least_of


def critical(
    slope: Slope,
    method: str = "bishop",
    *,
    entry: Pair | None = None,
    exit: Pair | None = None,
    depth: float = 0.0,
    tell: Tell = lambda _: None,
) -> Critical:
    """Return the circle with the least factor of safety, or with the least yield coefficient.

    Parameters
    ----------
    slope : Slope
    method : str
        paper, ordinary or bishop; k_y for the circle of least yield coefficient, which does not depend on the k_h of
        the slope.
    entry, exit : pair of float, optional
        Least and greatest x of the upper and of the lower end, m; they may be equal.
    depth : float
        Least thickness of the mass along a radius, m, which excludes shallow slips.
    tell : callable, optional
        Called with lines of progress.

    Raises
    ------
    ValueError
        If the slope has no critical circle (level ground; c = 0 without a least depth; phi = 0 without a base, where
        deeper circles are always more critical), or no circle satisfies the limits.

    Notes
    -----
    Each circle connects two points of the ground and is evaluated for the mass between them. Ground vertices are always
    among these points (evenly chosen ones if there are more than 48), and circles deepen up to the one that is vertical
    at an end or touches the base. The best valleys of this coarse family are refined to 1e-4 of its spacing.
    """
    raise_all("critical", _mistakes(slope, method, {"entry": entry, "exit": exit}, depth))
    search = Search(slope, method, entry, exit, depth)
    best = least(search, tell)
    circle = circle_of(slope, *search.circles(best[:1]))
    factor = circle.yield_coefficient if method == YIELD else circle.factors_of_safety[method]
    factor = np.inf if factor is None else factor
    if entry is None and exit is None:
        _refuse_bottomless(slope, factor, shaken=method == YIELD or slope.k_h > 0.0)
    _refuse_skin(slope, circle)
    tell(f"{least_of(method)}: {factor:.6g}")
    warnings = [circle.warning, *_reached_ends(search, circle), *_reached_limits(search, best[:1], circle)]
    values = np.concatenate(search.values)
    return replace(
        circle,
        method=method,
        start=method if method in METHODS else circle.start,
        limits=search.limits | {"depth": depth},
        warning="; ".join(filter(None, warnings)),
        tried=len(values),
        refused=int(np.isnan(values).sum()),
        values=values,
        centres=np.concatenate(search.centres),
    )


def _reached_ends(search: Search, circle: Critical) -> Texts:
    """Return a message for each end of the ground that the circle reaches."""
    return [
        f"the circle reaches the end of the ground at x = {x:.6g}; the factor may be lower beyond"
        for x in search.ground[[0, -1], 0]
        if min(abs(circle.entry[0] - x), abs(circle.exit[0] - x)) < 1e3 * search.rounding
    ]


def _reached_limits(search: Search, q: Floats, circle: Critical) -> Texts:
    """Return a message for each limit of the search that the circle, ``q`` of `family`, (1, 4), reaches."""
    near = 1e-4 * float(search.along[-1])
    sentences = []
    for name, limit in search.limits.items():
        x = getattr(circle, name)[0]
        if limit is not None and limit[1] > limit[0] and min(abs(x - limit[0]), abs(x - limit[1])) < near:
            sentences.append(f"the {name} is at a limit of the search, x = {x:.6g}; the factor may be lower beyond")
    centre, radius, _, _ = search.circles(q)
    if search.depth and search.thickness(q, centre, radius)[0] < search.depth + near:
        sentences.append(
            f"the mass is as thin as the search allows, {amount_text(search.depth, 'm', 6)}; thinner ones may be worse"
        )
    return sentences


def _mistakes(slope: Any, method: Any, limits: Values, depth: Any) -> Texts:
    """Return a message for each mistake in the arguments of `critical`; ``limits`` are entry and exit by name."""
    if not isinstance(slope, Slope):
        return [f"{{slope}} = {slope!r}: must be a Slope; the command search reads a file"]
    ground = np.asarray(slope.ground)
    allowed = [*METHODS, YIELD]
    mistakes = [] if method in allowed else [f"{{method}} = {method!r}: must be one of {', '.join(allowed)}"]
    if not isinstance(depth, int | float) or not 0.0 <= depth < slope.size:
        mistakes.append(f"{{depth}} = {depth!r}: must be at least 0 and below the size of the ground, in m")
    for name, pair in limits.items():
        mistakes += _limit_mistakes(name, pair, ground)
    if np.ptp(ground[:, 1]) <= 1e-9 * np.ptp(ground[:, 0]):
        mistakes.append("{ground}: is level; nothing drives a mass")
    elif not depth and not any(soil.peak_cohesion or soil.cohesion_gradient for soil, _ in slope.soils):
        mistakes.append(
            f"{{cohesion}} = 0: the factor decreases towards ever thinner masses{_skin(slope)}; give a least depth"
        )
    elif not depth and slope.has_friction and slope.pressure:
        mistakes.append(
            "{pressure}: is uniform along every circle, and lifts thin masses; give a water level or a pore "
            "pressure ratio, or a least depth"
        )
    return mistakes


def _limit_mistakes(name: str, pair: Any, ground: Floats) -> Texts:
    """Return a message, in a list, if a limit is not two ordered numbers or lies beside the ground; else [].

    ``name`` is "entry" or "exit", and ``pair`` its value, least and greatest x in m or None; the ground is (V, 2).
    """
    try:
        low, high = (-np.inf, np.inf) if pair is None else map(float, pair)
    except (TypeError, ValueError):
        return [f"{{{name}}} = {pair!r}: must be two numbers, the least and the greatest x"]
    interval = f"{{{name}}} = [{low:.10g}, {high:.10g}]"
    if not low <= high:
        return [f"{interval}: must be the least and the greatest x, in this order"]
    if high < ground[0, 0] or low > ground[-1, 0]:
        reach = f"from {ground[0, 0]:.10g} to {ground[-1, 0]:.10g}"
        return [f"{interval}: lies beside the ground, which extends {reach}"]
    return []


def _skin(slope: Slope) -> str:
    """Return the factor of safety of a dry skin, ignoring scarps, as the end of a message; empty for layers."""
    run, rise = np.diff(np.asarray(slope.ground), axis=0).T
    steepest = float(np.max(np.abs(rise) / np.maximum(run, 1e-300)))
    if slope.layers or steepest >= 1e6:
        return ""
    return f", tan(phi)/tan(slope) = {slope.soils[0][0].peak / steepest:.4g} if dry"


def _refuse_skin(slope: Slope, circle: Critical) -> None:
    """Raise a ValueError if the search leads to ever thinner masses, in a layer without cohesion at the ground."""
    if math.dist(circle.entry, circle.exit) < 1e-4 * slope.size:
        words = f"the factor decreases towards ever thinner masses near x = {circle.entry[0]:.4g}"
        raise InputError("critical", [f"{{layers}}: {words}, where the soil has no cohesion; give a least depth"])


def _refuse_bottomless(slope: Slope, least: float, shaken: bool) -> None:
    """Raise a ValueError if, without friction and base, deeper circles are always more critical.

    ``least`` is the least factor of the search, ``shaken`` whether a horizontal acceleration acts.

    Beside their size all is small but the step H between level grounds: F = 4 a c/(gamma H sin(a)^2) of circles about
    it with half the opening a, least where tan(a) = 2 a.
    """
    if slope.layers or slope.has_friction or slope.base is not None:
        return
    assert slope.unit_weight is not None
    ground = np.asarray(slope.ground)
    step = abs(float(ground[-1, 1] - ground[0, 1])) * slope.unit_weight
    deepest = 5.5199 * slope.soils[0][0].peak_cohesion / step if step and not slope.k_h else np.inf
    if shaken:
        deepest = 0.0
    if least > deepest:
        words = f"the critical circle is infinitely deep, where the factor tends to {deepest:.4g}"
        advice = "give the base of the soil, or where the circle comes out (exit)"
        raise InputError("critical", [f"{{friction}} = 0 without a base: {words}; {advice}"])
