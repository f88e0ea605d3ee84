"""Implicit integration for brakes that are too stiff for explicit steps."""

from slipcircle.stiff.creep import may_creep

__all__ = ["may_creep"]
