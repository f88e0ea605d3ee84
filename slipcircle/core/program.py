"""Programs of scenes, linked once per recipe."""

from functools import lru_cache, partial

from generated.flow import FRAGMENTS
from generated.program import Program, Recipe, build, fragments_of
from slipcircle.base.kinds import Names


@lru_cache(maxsize=256)
def build_program(recipe: Recipe, outputs: Names = ()) -> Program:
    """Return the program of a scene, linked from the effects and laws that its ``recipe`` names.

    ``outputs`` are further outputs: registers such as ``mu``, ``pressing`` or ``friction``, and "energy" for the states
    ``work`` and ``dissipation``.
    """
    further = tuple(name for name in outputs if name in FRAGMENTS)
    registers = tuple(name for name in outputs if name not in FRAGMENTS)
    return build(recipe, partial(fragments_of, FRAGMENTS), registers, further)
