"""Linker: fragments of effects and laws -> definitions by name -> ordered operations -> a program with places.

Its modules are the source of `generated.program`, which links the programs of scenes at run time.
"""

import ast
import inspect
from collections.abc import Sequence
from importlib import import_module

from derive.code.emit import filled
from derive.declare.effects import EFFECTS, LAWS, Effect, Law
from derive.flow.fragments import fragments
from derive.flow.link.definitions import Lookup

PARTS = ("definitions", "linker", "program")


def lookup(effects: Sequence[Effect] = EFFECTS, laws: Sequence[Law] = LAWS) -> Lookup:
    """Return the function by which the linker looks up the fragments of these effects and laws."""
    known = fragments(effects, laws)
    return lambda name, _turns: [known[name]]


def text() -> str:
    """Return the module `generated.program`: the linker's modules, with the imports of the template."""
    return filled("_program.py.in", {"LINKER": "\n\n\n".join(map(_without_imports, PARTS))})


def _without_imports(part: str) -> str:
    source = inspect.getsource(import_module(f"{__name__}.{part}"))
    *_, last = (x for x in ast.parse(source).body if isinstance(x, ast.ImportFrom))
    body = source.splitlines()[last.end_lineno :]
    return "\n".join(body).strip("\n")
