"""What accuracy costs in time: every way to compute a function or solve a scene, measured here."""
