"""The one table of what the core may reach beyond itself: rooms, loaded when a scene or a question asks for them."""

from functools import cache
from importlib import import_module
from typing import Any, NamedTuple


class Door(NamedTuple):
    """When a room is entered, and the module that answers there."""

    condition: str
    module: str


DOORS = {
    "given": Door("coefficients are given in place of computed ones", "slipcircle.given"),
    "arc": Door("an arc is no mass that can slide", "slipcircle.words.arc"),
    "history": Door("states, forces, stresses or energy are asked for", "slipcircle.history.history"),
    "journey": Door("where a rotation brings the mass is asked for", "slipcircle.history.journey"),
    "validity": Door("whether the method applies is asked for", "slipcircle.history.validity"),
    "toe": Door("how far the toe of a section may rise is asked for", "slipcircle.ground.toe"),
    "forcing": Door("shaking, or water that changes with time", "slipcircle.tables.forcing"),
    "tables": Door("a function of time, or a law in pieces or by a list", "slipcircle.tables.tables"),
    "functions": Door("friction as a function of slip in Python", "slipcircle.tables.functions"),
    "soils": Door("soils have friction laws of their own", "slipcircle.layers.fragments"),
    "water": Door("a section has a water level", "slipcircle.ground.water"),
    "depths": Door("cohesion of one soil grows with depth", "slipcircle.layers.depths"),
    "standing": Door("free water covers the exit of a section", "slipcircle.layers.standing"),
    "creep": Door("a viscous layer and no end time, or the slow run-out is asked for", "slipcircle.stiff.creep"),
    "stiff": Door("explicit steps were too many", "slipcircle.stiff.implicit"),
    "plan": Door("a plan is asked for its words", "slipcircle.words.choice"),
    "equation": Door("the equation of a scene is asked for", "slipcircle.words.equation"),
    "estimate": Door("the error of a motion is asked for", "slipcircle.words.accuracy"),
    "warnings": Door("the warnings of a motion are asked for", "slipcircle.words.warnings"),
    "plausible": Door("a scene has an unusual number", "slipcircle.words.plausible"),
    "summary": Door("a motion in one line is asked for", "slipcircle.words.summary"),
    "refusal": Door("a single scene has no result", "slipcircle.words.refusal"),
    "velocity": Door("velocity classes are asked for", "slipcircle.words.velocity"),
    "parameters": Door("lanes of an ensemble are chosen", "slipcircle.derivatives.parameters"),
    "sensitivity": Door("derivatives are asked for", "slipcircle.derivatives.sensitivity"),
}


@cache
def room(name: str) -> Any:
    """The module behind a door, imported on its first use."""
    return import_module(DOORS[name].module)
