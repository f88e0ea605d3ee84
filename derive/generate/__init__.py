"""Files of `generated`: their functions, and their text."""
