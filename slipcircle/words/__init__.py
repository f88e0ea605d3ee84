"""What is said of a scene and its motion: equation, warnings, summary, error estimate."""

from slipcircle.words.summary import standing
from slipcircle.words.warnings import collect_warnings

__all__ = ["collect_warnings", "standing"]
