"""Layered ground: soils, stretches of the arc, strips and cracks."""

from slipcircle.core.scene.laws import RATE_LAWS, depends_on, is_law, law_mistakes, may_have_rate
from slipcircle.layers.at_rest import cohesion_at_rest, friction_at_rest, growth_at_rest
from slipcircle.layers.cracks import crack_place
from slipcircle.layers.layered_numbers import PRESSURE
from slipcircle.layers.layers import LayeredSection
from slipcircle.layers.soils import STRESS, TOP, Soil, layer_mistakes
from slipcircle.layers.soils_along import mean_normal_stress, soils_under, stretches
from slipcircle.layers.strips import meets_circle

__all__ = [
    "PRESSURE",
    "RATE_LAWS",
    "STRESS",
    "TOP",
    "LayeredSection",
    "Soil",
    "cohesion_at_rest",
    "crack_place",
    "depends_on",
    "friction_at_rest",
    "growth_at_rest",
    "is_law",
    "law_mistakes",
    "layer_mistakes",
    "may_have_rate",
    "mean_normal_stress",
    "meets_circle",
    "soils_under",
    "stretches",
]
