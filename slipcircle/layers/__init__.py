"""Layered ground: soils, stretches of the arc, strips, cracks."""
