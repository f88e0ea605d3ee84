"""What is said of a scene and its motion: equation, warnings, summary, error estimate."""

from slipcircle.words.accuracy import ROUNDED, RUNS, perturbed_runs
from slipcircle.words.choice import integrator
from slipcircle.words.summary import standing, swings_back
from slipcircle.words.velocity import VelocityTimes

__all__ = ["ROUNDED", "RUNS", "VelocityTimes", "integrator", "perturbed_runs", "standing", "swings_back"]
