"""Many scenes at once: their fields are arrays, a lane is one scene, and no lane knows of another."""
