"""Digests of Python objects by content, so that a later run recognises inputs that a text file cannot contain."""

import dis
import hashlib
import os
import pickle
import sys
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from importlib import import_module
from io import BytesIO
from types import CodeType, FunctionType, ModuleType
from typing import Any

_PASSING = ("_cache", "_methods", "_random_state")  # endings of attributes that change when a distribution is used


def content_digest(value: Any) -> str:
    """Return a hexadecimal digest that differs if the data or the code of two objects differ.

    Raises
    ------
    ValueError
        If the content is not accessible, as in an instance of a user's class.
    """
    stream = BytesIO()
    content = _Content(stream)
    content.fast = True  # equal objects are written alike, whether they are one object or several
    try:
        content.dump(value)
    except Exception as error:  # any object may raise any while it is read
        raise ValueError(
            f"{_name(value)}: a later run could not recognise its content ({error}); give numbers, a table, or a "
            "function that reads only numbers and arrays"
        ) from error
    return hashlib.sha256(stream.getvalue()).hexdigest()


class _Content(pickle.Pickler):
    """Pickler that writes data by value, installed packages by name, and functions by code and globals read."""

    def reducer_override(self, value: Any) -> Any:
        """Return the parts of an object to write, or `NotImplemented` if pickle's own parts are used."""
        if isinstance(value, CodeType):
            names = value.co_names, value.co_varnames, value.co_freevars, value.co_flags, value.co_argcount
            return str, (), (value.co_code, value.co_exceptiontable, names, value.co_consts)
        named = value if hasattr(value, "__qualname__") or isinstance(value, ModuleType) else type(value)
        if isinstance(value, FunctionType) and not _is_installed(value):
            cells = [cell.cell_contents for cell in value.__closure__ or ()]
            scope = value.__globals__
            read = {name: scope[name] for name in sorted({*_globals(value.__code__)}) if name in scope}
            return str, (), (value.__code__, value.__defaults__, value.__kwdefaults__, cells, read)
        if not _is_installed(named):
            raise ValueError(f"{_name(named)} is not part of an installed package")
        if isinstance(value, ModuleType):
            return str, (value.__name__,)
        if is_dataclass(value) and not isinstance(value, type):
            return type(value), tuple(getattr(value, field.name) for field in fields(value))
        if named is type(value) and named.__module__.startswith("scipy.stats"):
            maker, arguments, state = value.__reduce_ex__(4)[:3]
            return maker, arguments, {name: state[name] for name in state if not name.endswith(_PASSING)}
        return NotImplemented


def _name(value: Any) -> str:
    """Return the name of an object, or of its type, for messages."""
    return str(getattr(value, "__qualname__", getattr(value, "__name__", type(value).__qualname__)))


def _globals(code: CodeType) -> Iterator[str]:
    """Yield the names of the global variables read by code and by the functions within it."""
    for instruction in dis.get_instructions(code):
        if instruction.opname == "LOAD_GLOBAL":
            yield instruction.argval
        elif instruction.opname == "IMPORT_NAME" and not _is_installed(import_module(instruction.argval)):
            raise ValueError(f"it imports {instruction.argval}")
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _globals(constant)


def _is_installed(value: Any) -> bool:
    """Return whether a module, or a class or function at the top level of one, belongs to an installed package."""
    module = value.__name__ if isinstance(value, ModuleType) else value.__module__ or ""
    top = module.partition(".")[0]
    file = getattr(sys.modules.get(top), "__file__", None)
    if "<" in getattr(value, "__qualname__", ""):
        return False
    if file is None:
        return top in sys.builtin_module_names
    is_package = not {"site-packages", "dist-packages"}.isdisjoint(file.split(os.sep))
    return is_package or top in ("slipcircle", "generated") or file.startswith(os.path.dirname(os.__file__) + os.sep)
