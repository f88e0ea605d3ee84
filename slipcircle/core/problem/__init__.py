"""The problem of a scene: its numbers, tables and initial cells."""
