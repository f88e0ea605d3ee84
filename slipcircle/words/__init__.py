"""What is said of a scene and its motion: equation, warnings, summary, error estimate."""

from slipcircle.words.summary import standing

__all__ = ["standing"]
