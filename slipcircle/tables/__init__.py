"""Functions given by pieces: records, friction in pieces or by lists, Python functions."""
