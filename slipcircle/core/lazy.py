"""Modules outside the core that only some scenes or results need, imported at their first use."""

from collections.abc import Callable
from functools import cache, partial
from importlib import import_module
from typing import Any

MODULES = {
    "tree": "slipcircle.tree",  # numbers are listed, varied, or arrays
    "tabulated": "slipcircle.tabulated",  # tabulated coefficients replace the computed ones
    "arc": "slipcircle.messages.arc",  # an arc is invalid
    "section": "slipcircle.messages.section",  # a section is invalid
    "dimensionless": "slipcircle.core.scene.dimensionless",  # printed coefficients are requested
    "limits": "slipcircle.core.problem.limits",  # the friction of an arc is close to its limit
    "history": "slipcircle.history.history",  # states, forces, stresses or energy are requested
    "ends": "slipcircle.history.ends",  # states at the end, the farthest position or the peak are requested
    "journey": "slipcircle.history.journey",  # the displacement of toe or centroid is requested
    "validity": "slipcircle.history.validity",  # the range of validity is requested
    "toe": "slipcircle.ground.toe",  # the range of validity of a section is requested
    "laws": "slipcircle.core.scene.laws",  # friction is not a plain number, or an effect has parameters
    "forcing": "slipcircle.tables.forcing",  # shaking, or pore pressure that changes with time
    "tables": "slipcircle.tables.tables",  # a function of time, or a piecewise or tabulated law
    "functions": "slipcircle.tables.functions",  # friction is a Python function of slip
    "ponds": "slipcircle.ground.ponds",  # a section has a water level or ponds
    "heights": "slipcircle.ground.heights",  # a section has a water level, or its arc overhangs
    "water": "slipcircle.ground.water",  # a section has water, or tables of the rotation
    "depths": "slipcircle.layers.depths",  # cohesion of one soil grows with depth
    "standing": "slipcircle.layers.standing",  # free water covers the exit of a section
    "creep": "slipcircle.stiff.creep",  # a viscous layer without end time, or the slow run-out is requested
    "beyond": "slipcircle.stiff.beyond",  # explicit steps are too many, or a mass swings without end
    "stiff": "slipcircle.stiff.implicit",  # explicit steps are too many
    "plan": "slipcircle.messages.choice",  # the description of a plan is requested
    "equation": "slipcircle.messages.equation",  # the equation of motion is requested
    "estimate": "slipcircle.core.integrator.estimate",  # the error estimate is requested
    "warnings": "slipcircle.messages.warnings",  # warnings are requested
    "plausible": "slipcircle.messages.plausible",  # a scene has an unusual number
    "summary": "slipcircle.messages.summary",  # the one-line summary is requested
    "refusal": "slipcircle.messages.refusal",  # a single scene has no result
    "velocity": "slipcircle.messages.velocity",  # velocity classes are requested
    "parameters": "slipcircle.derivatives.parameters",  # lanes of an ensemble are selected
    "sensitivity": "slipcircle.derivatives.sensitivity",  # derivatives are requested
}


@cache
def lazy_import(name: str) -> Any:
    """Return a module outside the core, imported at its first use. ``name`` is a key of `MODULES`, not a path."""
    return import_module(MODULES[name])


def lazy_message(module: str, fault: str, mass: Any) -> Callable[[int], str]:
    """Return the function from the index of a lane to the message about a fault of its mass.

    ``fault`` is the name of a function of a ``module`` of messages, a key of `MODULES`.
    """
    return partial(_message, module, fault, mass)


def _message(module: str, fault: str, mass: Any, lane: int) -> str:
    text: str = getattr(lazy_import(module), fault)(mass, lane)
    return text
