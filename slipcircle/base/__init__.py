"""What the core and the workbench share: checks of input, functions of time, numbers as text, progress."""

VERSION = "0.1.0"
# Of what files and programs hold, raised where a key is removed or changes its meaning.
SCENE_FORMAT = "slipcircle-scene-1"
JSON_FORMAT = "slipcircle-json-1"
