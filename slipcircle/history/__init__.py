"""What a motion is asked beyond its end: states along the way, forces, stresses and energy, and where it went."""

from slipcircle.history.forces import OUTPUTS, Forces, energy_unit, stress_unit, with_outputs
from slipcircle.history.history import of_means
from slipcircle.history.journey import Journey
from slipcircle.history.phases import Energy, Phase

__all__ = ["OUTPUTS", "Energy", "Forces", "Journey", "Phase", "energy_unit", "of_means", "stress_unit", "with_outputs"]
