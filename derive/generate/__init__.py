"""The files of `generated`: which functions they hold, and their text."""
