"""What is said of a scene and its motion: equation, warnings, summary, error estimate."""

from slipcircle.words.choice import step_operations

__all__ = ["step_operations"]
