"""What the core and the workbench share: checks of input, functions of time, numbers as text, progress."""

VERSION = "0.1.0"
