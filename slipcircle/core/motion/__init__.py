"""From a scene to its motion."""
