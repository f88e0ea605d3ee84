"""Linker: fragments of effects and laws -> definitions by name -> ordered operations -> a program with places.

Its modules are the source of `generated.program`, which links the programs of scenes at run time.
"""

from collections.abc import Sequence

from derive.declare.effects import EFFECTS, LAWS, Effect, Law
from derive.flow.fragments import fragments
from derive.flow.link.definitions import Lookup
from derive.flow.link.soils import fragments_of


def lookup(effects: Sequence[Effect] = EFFECTS, laws: Sequence[Law] = LAWS) -> Lookup:
    """Return the function by which the linker looks up the fragments of these effects and laws."""
    known = fragments(effects, laws)
    return lambda name, turns: fragments_of(known, name, turns)
