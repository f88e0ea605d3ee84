"""Masses cut off from a polygonal ground: geometry, moments, water."""

from typing import TYPE_CHECKING, Any

from slipcircle.ground.ground import circle_through, circle_touching, continued, pond_errors, simple_slope, slope_errors

if TYPE_CHECKING:
    from slipcircle.ground.section import Section

__all__ = ["Section", "circle_through", "circle_touching", "continued", "pond_errors", "simple_slope", "slope_errors"]


def __getattr__(name: str) -> Any:
    """The section, loaded when it is asked for: an arc's plausibility needs bounds of the ground alone."""
    if name != "Section":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from slipcircle.ground.section import Section

    return Section
