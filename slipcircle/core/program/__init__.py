"""Flow programs: fragments of effects and laws, joined into one program for the recipe of a scene."""
