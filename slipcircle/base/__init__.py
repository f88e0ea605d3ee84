"""Shared foundations of the core and the workbench: input checks, number formatting, and progress."""

VERSION = "0.1.0"
# Versions of the scene file and JSON formats, raised when a key is removed or changes its meaning.
SCENE_FORMAT = "slipcircle-scene-1"
JSON_FORMAT = "slipcircle-json-1"
