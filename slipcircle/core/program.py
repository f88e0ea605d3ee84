"""Programs of scenes, linked once per recipe."""

from collections.abc import Sequence
from functools import lru_cache

from generated.flow import FRAGMENTS, Fragment
from generated.program import OF_SOIL, Program, Recipe, build
from slipcircle.base.kinds import Names
from slipcircle.core.lazy import lazy_import


@lru_cache(maxsize=256)
def build_program(recipe: Recipe, outputs: Names = ()) -> Program:
    """Return the program of a scene.

    ``outputs`` are further outputs: registers such as ``mu``, ``pressing`` or ``friction``, and "energy" for the states
    ``work`` and ``dissipation``.
    """
    further = tuple(name for name in outputs if name in FRAGMENTS)
    registers = tuple(name for name in outputs if name not in FRAGMENTS)
    return build(recipe, _fragments, registers, further)


def _fragments(name: str, turns: bool) -> Sequence[Fragment]:
    """Return the fragments of an effect or a law. The package of layers creates the fragments of single soils."""
    if OF_SOIL not in name:
        return [FRAGMENTS[name]]
    of_soil: list[Fragment] = lazy_import("soils").fragments_of(name, turns)
    return of_soil
