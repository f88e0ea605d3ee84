"""Conversion of expressions to programs, their evaluation with IEEE rounding, and their text."""
