"""Histories of a solved motion: states, forces, stresses, energy and the path of the mass."""

from slipcircle.history.forces import OUTPUTS, Forces, energy_unit, stress_unit, with_outputs
from slipcircle.history.history import of_means
from slipcircle.history.journey import Journey
from slipcircle.history.phases import Energy, Phase

__all__ = ["OUTPUTS", "Energy", "Forces", "Journey", "Phase", "energy_unit", "of_means", "stress_unit", "with_outputs"]
