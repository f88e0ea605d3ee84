"""Declarations of quantities, effects and laws as data."""
