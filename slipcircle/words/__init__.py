"""What is said of a scene and its motion: equation, warnings, summary, error estimate."""
