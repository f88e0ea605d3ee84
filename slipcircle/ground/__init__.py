"""Masses cut off by a circle from a polygonal ground: geometry, moments and water."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from slipcircle.ground.ground import continued, points_errors, present, slope_errors

if TYPE_CHECKING:
    from slipcircle.ground.construction import circle_through, circle_touching, outside_between, simple_slope
    from slipcircle.ground.heights import edge_below
    from slipcircle.ground.plane import sine_and_cosine
    from slipcircle.ground.ponds import Ponds, ends_above, free_water, water_faults
    from slipcircle.ground.section import Section

__all__ = [
    "Ponds",
    "Section",
    "circle_through",
    "circle_touching",
    "continued",
    "edge_below",
    "ends_above",
    "free_water",
    "outside_between",
    "points_errors",
    "present",
    "simple_slope",
    "sine_and_cosine",
    "slope_errors",
    "water_faults",
]
_MODULES = {
    **dict.fromkeys(("circle_through", "circle_touching", "outside_between", "simple_slope"), "construction"),
    "Section": "section",
    "edge_below": "heights",
    "sine_and_cosine": "plane",
}


def __getattr__(name: str) -> Any:
    """Import a name at its first use, since an arc needs only the bounds of this package."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"slipcircle.ground.{_MODULES.get(name, 'ponds')}"), name)
