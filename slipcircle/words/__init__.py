"""Texts about a scene and its motion: equation, warnings, summary and error estimate."""

from slipcircle.words.accuracy import ROUNDED, RUNS, perturbed_runs
from slipcircle.words.choice import integrator
from slipcircle.words.summary import OUTSIDE, range_words, standing, swings_back
from slipcircle.words.velocity import VelocityTimes

__all__ = [
    "OUTSIDE",
    "ROUNDED",
    "RUNS",
    "VelocityTimes",
    "integrator",
    "perturbed_runs",
    "range_words",
    "standing",
    "swings_back",
]
