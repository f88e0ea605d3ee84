"""Masses cut off from a polygonal ground: geometry, moments, water."""
