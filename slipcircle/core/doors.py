"""Table of the modules outside the core that only some scenes or results need, imported at their first use."""

from functools import cache
from importlib import import_module
from typing import Any, NamedTuple


class Door(NamedTuple):
    """Condition under which a module is imported, and the name of the module."""

    condition: str
    module: str


DOORS = {
    "given": Door("tabulated coefficients replace the computed ones", "slipcircle.given"),
    "arc": Door("an arc is invalid", "slipcircle.words.arc"),
    "history": Door("states, forces, stresses or energy are requested", "slipcircle.history.history"),
    "journey": Door("the displacement of toe or centroid is requested", "slipcircle.history.journey"),
    "validity": Door("the range of validity is requested", "slipcircle.history.validity"),
    "toe": Door("the range of validity of a section is requested", "slipcircle.ground.toe"),
    "forcing": Door("shaking, or pore pressure that changes with time", "slipcircle.tables.forcing"),
    "tables": Door("a function of time, or a piecewise or tabulated law", "slipcircle.tables.tables"),
    "functions": Door("friction is a Python function of slip", "slipcircle.tables.functions"),
    "soils": Door("soils have friction laws of their own", "slipcircle.layers.fragments"),
    "water": Door("a section has a water level", "slipcircle.ground.water"),
    "standing": Door("free water covers the exit of a section", "slipcircle.layers.standing"),
    "creep": Door("a viscous layer without end time, or the slow run-out is requested", "slipcircle.stiff.creep"),
    "stiff": Door("explicit steps are too many", "slipcircle.stiff.implicit"),
    "plan": Door("the description of a plan is requested", "slipcircle.words.choice"),
    "equation": Door("the equation of motion is requested", "slipcircle.words.equation"),
    "estimate": Door("the error estimate is requested", "slipcircle.words.accuracy"),
    "warnings": Door("warnings are requested", "slipcircle.words.warnings"),
    "plausible": Door("a scene has an unusual number", "slipcircle.words.plausible"),
    "summary": Door("the one-line summary is requested", "slipcircle.words.summary"),
    "refusal": Door("a single scene has no result", "slipcircle.words.refusal"),
    "velocity": Door("velocity classes are requested", "slipcircle.words.velocity"),
    "parameters": Door("lanes of an ensemble are selected", "slipcircle.derivatives.parameters"),
    "sensitivity": Door("derivatives are requested", "slipcircle.derivatives.sensitivity"),
}


@cache
def room(name: str) -> Any:
    """Return a lazily imported module by its name in `DOORS`."""
    return import_module(DOORS[name].module)
