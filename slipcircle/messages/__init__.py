"""Texts about a scene and its motion: equation, warnings, summary and error estimate."""

from slipcircle.core.integrator.neighbours import RUNS, perturbed_runs
from slipcircle.messages.accuracy import ROUNDED
from slipcircle.messages.choice import describe_integrator
from slipcircle.messages.summary import OUTSIDE, range_words, standing, swings_back
from slipcircle.messages.velocity import VelocityTimes

__all__ = [
    "OUTSIDE",
    "ROUNDED",
    "RUNS",
    "VelocityTimes",
    "describe_integrator",
    "perturbed_runs",
    "range_words",
    "standing",
    "swings_back",
]
