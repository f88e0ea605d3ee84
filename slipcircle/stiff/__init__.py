"""Implicit steps, for brakes that explicit steps cannot follow."""

from slipcircle.stiff.creep import may_creep

__all__ = ["may_creep"]
