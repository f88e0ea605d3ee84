"""Numbers, tables and initial cells of a scene's program."""
