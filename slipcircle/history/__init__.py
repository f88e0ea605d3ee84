"""What a motion is asked beyond its end: states along the way, forces, stresses and energy, and where it went."""

from slipcircle.history.forces import OUTPUTS, Forces
from slipcircle.history.journey import Journey

__all__ = ["OUTPUTS", "Forces", "Journey"]
