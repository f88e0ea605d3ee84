"""Scenes along the critical circle of the mean values of their uncertain numbers."""

from dataclasses import replace
from typing import Any

import numpy as np

from slipcircle.base.arrays import float_or_array
from slipcircle.base.kinds import ValueDict
from slipcircle.core import Scene
from slipcircle.derivatives import with_parameters
from slipcircle.ground import Section
from slipcircle.layers import LayeredSection
from slipcircle.workbench.files.numbers import uncertain_numbers
from slipcircle.workbench.stability.critical import SlopeScene
from slipcircle.workbench.stability.search import critical
from slipcircle.workbench.stability.stability import Slope, soil


def along_means(scene: Scene) -> Scene:
    """Return a scene along the critical circle of the means of its uncertain numbers; other scenes unchanged."""
    if not isinstance(scene, SlopeScene) or scene.stability is None or not scene.stability.method:
        return scene
    searched = scene.stability
    means = {n: float(u.number.to_si(u.moments[0])) for n, u in uncertain_numbers(scene).items()}
    medians: list[Any] = [scene.numbers[n] for n in means]
    if np.allclose(medians, [*means.values()], rtol=1e-12, atol=0.0):
        return scene
    assert isinstance(scene.arc, Section)
    searched = critical(varied_slope(with_parameters(scene, means), searched.slope), searched.method, **searched.limits)
    section = replace(scene.arc, centre=searched.centre, radius=searched.radius, between=searched.between)
    return replace(scene, arc=section, stability=searched.without_map())


def varied_slope(scene: Scene, like: Slope) -> Slope:
    """Return a slope with the ground, level, soils, surcharge and crack of a scene, otherwise equal to `like`.

    The arc of the scene must be a `Section`.
    """
    arc = scene.arc
    assert isinstance(arc, Section)
    if isinstance(arc, LayeredSection):
        soils: ValueDict = {"layers": arc.layers, "surcharge": arc.surcharge, "crack": float(arc.crack)}
    else:
        soils = soil(scene.friction, scene.effects) | {"unit_weight": float_or_array(arc.unit_weight)}
    return replace(like, ground=arc.ground, level=arc.level, **soils)
