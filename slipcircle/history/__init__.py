"""What a motion is asked beyond its end: states along the way, forces, stresses and energy, and where it went."""

from slipcircle.history.forces import OUTPUTS, Forces
from slipcircle.history.journey import Journey
from slipcircle.history.phases import Energy, Phase

__all__ = ["OUTPUTS", "Energy", "Forces", "Journey", "Phase"]
