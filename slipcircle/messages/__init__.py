"""Texts about a scene and its motion: equation, warnings and summary."""

from slipcircle.messages.choice import describe_integrator
from slipcircle.messages.summary import OUTSIDE, range_words, standing, swings_back
from slipcircle.messages.velocity import VelocityTimes

__all__ = ["OUTSIDE", "VelocityTimes", "describe_integrator", "range_words", "standing", "swings_back"]
