"""What a motion is asked beyond its end: states along the way, forces, stresses and energy, and where it went."""

from slipcircle.history.forces import OUTPUTS, Forces, with_outputs
from slipcircle.history.journey import Journey
from slipcircle.history.phases import Energy, Phase

__all__ = ["OUTPUTS", "Energy", "Forces", "Journey", "Phase", "with_outputs"]
