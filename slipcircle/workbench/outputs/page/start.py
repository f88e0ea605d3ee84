"""Factor of safety from which a motion starts, for a live page: the root of an equation between Chebyshev series.

By Bishop's method F D = sum of R_k(mu_k/F), where D is the driving moment, mu_k the friction of a soil and R_k the
integral of the strength of that soil over m_alpha. As a Chebyshev series in mu_k/F, R_k has coefficients that are
polynomials in the strengths and in the pore pressure, which a page interpolates exactly. By the ordinary method R_k is
constant.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.polynomial import chebyshev

from generated import slopes
from slipcircle.base.kinds import Floats
from slipcircle.core import Scene
from slipcircle.workbench.stability.critical import SlopeScene
from slipcircle.workbench.stability.factors import Driven, factor_by
from slipcircle.workbench.stability.slices import Rule, Slices
from slipcircle.workbench.stability.starting import OF_CLOSURE, driven_blocks

_RULE = Rule(pieces=3)  # with as many pieces of every arc
_DEGREE = 32  # greatest degree of a series
_ROUNDING = 1e-15  # relative to the greatest coefficient; smaller terms are dropped
_STEPS = 100
_ERROR = 1e-13  # relative tolerance of strength factors


class NoFit(Exception):
    """Error for too many coefficients, or for pieces or intervals that change within the range of a slider."""


class StartSeries(NamedTuple):
    """Series of the resistance of each soil along an arc in the mobilised friction.

    Its bounds are ``low`` and ``high``, (soils,) each.
    """

    method: str
    soils: Any  # number of the soil of each interval of the arc
    low: Floats
    high: Floats
    degree: int

    @property
    def terms(self) -> int:
        """Number of coefficients, which are the last rows."""
        return len(self.low) * (self.degree + 1)

    def shortened(self, scene: Scene) -> StartSeries:
        """Return the series without terms that are rounding error in every lane of a scene."""
        last = np.abs(self.rows(scene)[-self.terms :]).reshape(len(self.low), self.degree + 1, -1)
        greatest = last.max(axis=(0, 2))
        (counted,) = np.nonzero(greatest > _ROUNDING * greatest.max())
        return self._replace(degree=int(counted[-1]))

    def rows(self, scene: Scene) -> Floats:
        """Return driving moment, resistance of the closure, frictions and coefficients, (rows, lanes)."""
        driven = _driven(scene)
        resistance = factor_by(OF_CLOSURE, driven) * driven.driving
        friction = _by_lane(driven.slices, driven.slices.friction).T
        if len(friction) != len(self.soils):
            raise NoFit
        frictions = [friction[np.argmax(self.soils == soil)] for soil in range(len(self.low))]
        rows = [driven.driving, resistance, *frictions, *self._series(driven)]
        return np.stack([np.broadcast_to(row, math.prod(scene.shape)) for row in rows])

    def _series(self, driven: Driven) -> Floats:
        """Return the Chebyshev coefficients of the resistance of each soil over gamma R^3, (terms, lanes).

        They are ordered soil by soil, in increasing degree; ``driven`` are the slices of all lanes.
        """
        places = chebyshev.chebpts1(self.degree + 1)
        middle = (self.low + self.high) / 2
        half = (self.high - self.low) / 2
        shear = np.stack([self._shear(driven, (middle + half * x)[self.soils]) for x in places])
        of_soils = shear @ np.eye(len(self.low))[self.soils]
        polynomials = chebyshev.chebvander(places, self.degree)
        coefficients = np.tensordot(np.linalg.inv(polynomials), of_soils, 1)
        return np.moveaxis(coefficients, -1, 0).reshape(self.terms, -1)

    def _shear(self, driven: Driven, mobilised: Floats) -> Floats:
        """Return the integrals of the strength over its lever, m_alpha, on each interval, (lanes, intervals).

        ``mobilised`` is the friction over F of each interval.
        """
        slices = driven.slices
        cohesion, friction = slices.cohesion(), slices.friction
        mobilised = np.resize(mobilised, friction.shape[-1:])  # of every lane where lanes have arcs of their own
        if self.method == "ordinary":
            shear = cohesion + friction * slices.ordinary_normal()
        else:
            strength = slopes.bishop_strength(slices.cosine, slices.vertical(), 0.0, cohesion, friction)
            shear = strength / slopes.bishop_lever(slices.sine, slices.cosine, mobilised, 1.0)
        return _by_lane(slices, (slices.weight * shear).sum(axis=0))

    def strength_factors(self, rows: Floats) -> Floats:
        """Return strength factors, (lanes,), from `rows`, as the page does."""
        driving, closure = rows[:2]
        count = len(self.low)
        friction = rows[2 : 2 + count]
        series = rows[2 + count :].reshape(count, self.degree + 1, -1)
        half = (self.high - self.low)[:, None] / 2
        factor = np.ones_like(driving)
        for _ in range(_STEPS):
            places = (friction / factor - self.low[:, None]) / half - 1.0
            shares = [chebyshev.chebval(x, c, tensor=False) for x, c in zip(places, series, strict=True)]
            factor = sum(shares) / driving
        return factor * driving / closure


def start_of(scene: Scene, probe: Scene) -> StartSeries | None:
    """Return the series for the start of a scene, or None if series cannot represent the start.

    ``probe`` is an ensemble of the scene over the ranges of the sliders. It determines the bounds of the series and
    checks them.
    """
    if not isinstance(scene, SlopeScene) or scene.strength_factor is not scene.set_by_start:
        return None
    if scene.start == OF_CLOSURE or "shaking" in scene.called:
        return None
    slices = _driven(probe).slices
    counts = np.bincount(np.append(slices.arc, _driven(scene).slices.arc + len(slices.arcs.radius)))
    if not np.any(slices.friction) or np.ptp(counts):  # intervals that appear or vanish
        return None
    friction = _by_lane(slices, slices.friction)
    with np.errstate(divide="ignore", invalid="ignore"):
        factor = factor_by(scene.start, _driven(probe))
    if np.any(np.isnan(factor)):
        return None
    of_soils, soils = np.unique(friction, axis=1, return_inverse=True)
    mobilised = of_soils / factor[:, None]
    margin = 0.1 * mobilised.max(axis=0)
    low = np.maximum(mobilised.min(axis=0) - margin, 0.0)
    high = mobilised.max(axis=0) + margin + 1e-3
    start = StartSeries(scene.start, soils.ravel(), low, high, 0 if scene.start == "ordinary" else _DEGREE)
    start = start.shortened(probe)
    strength = start.strength_factors(start.rows(probe))
    if np.allclose(strength, probe.strength_factor, rtol=_ERROR, atol=0.0):
        return start
    return None


def _by_lane(slices: Slices, values: Any) -> Floats:
    """Return values of intervals as (lanes, intervals); lanes share an arc or have equally many intervals."""
    if slices.sine.ndim > 2:
        return np.atleast_2d(values)
    return values.reshape(len(slices.arcs.radius), -1)


def _driven(scene: Scene) -> Driven:
    """Return the slices of all lanes of a scene with their driving moments."""
    ((driven, _),) = driven_blocks(scene, rule=_RULE, most=1 << 30)
    return driven
