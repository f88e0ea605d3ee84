"""Packages that only some results need: imported where they are used, or one line says how to install them."""

from importlib import import_module
from typing import Any

EXTRAS = {
    "scipy": "scenes",
    "rich": "scenes",
    "matplotlib": "plot",
    "ezdxf": "dxf",
    "dask": "dask",
    "distributed": "dask",
    "sympy": "derive",
    "mpmath": "derive",
    "python-flint": "derive",
}


def install(package: str) -> str:
    """The command that installs an optional package."""
    return f"pip install 'slipcircle[{EXTRAS[package]}]'" if package in EXTRAS else f"pip install {package}"


def optional(module: str, purpose: str, package: str = "") -> Any:
    """A module of an optional package, whose name is the module's unless it is given.

    Raises
    ------
    ImportError
        Without the package: what needs it, and the command that installs it.
    """
    try:
        return import_module(module)
    except ImportError as error:
        package = package or module.partition(".")[0]
        raise ImportError(f"{package} is needed for {purpose}: {install(package)}") from error
