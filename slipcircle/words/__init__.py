"""What is said of a scene and its motion: equation, warnings, summary, error estimate."""

from slipcircle.words.accuracy import ROUNDED, RUNS, perturbed_runs
from slipcircle.words.choice import integrator
from slipcircle.words.summary import standing
from slipcircle.words.velocity import VelocityTimes
from slipcircle.words.warnings import collect_warnings, swings_back

__all__ = [
    "ROUNDED",
    "RUNS",
    "VelocityTimes",
    "collect_warnings",
    "integrator",
    "perturbed_runs",
    "standing",
    "swings_back",
]
