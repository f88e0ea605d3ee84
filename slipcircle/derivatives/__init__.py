"""Derivatives of a motion by the numbers of its scene."""
