"""Masses cut off from a polygonal ground: geometry, moments, water."""

from slipcircle.ground.ground import circle_through, circle_touching, continued, pond_errors, simple_slope, slope_errors
from slipcircle.ground.section import Section

__all__ = ["Section", "circle_through", "circle_touching", "continued", "pond_errors", "simple_slope", "slope_errors"]
