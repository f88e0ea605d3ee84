"""Solution of a scene, and its motion."""
