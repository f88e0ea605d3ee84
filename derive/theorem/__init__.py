"""Theorems on motions: rest, run-out, peak velocity and duration of a slide, enclosed in ball arithmetic."""
