"""How one phase of one motion is solved: closed forms, panels in the phase plane, steps along a record, SciPy."""
