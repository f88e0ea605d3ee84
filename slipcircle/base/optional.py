"""Imports of optional packages, with a one-line error that says how to install a missing package."""

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
    """Return the command that installs an optional package."""
    return f"pip install 'slipcircle[{EXTRAS[package]}]'" if package in EXTRAS else f"pip install {package}"


def optional(module: str, purpose: str, package: str = "") -> Any:
    """Return a module of an optional package.

    ``purpose`` is the feature that needs it, for the message. ``package`` is needed only if its name differs from the
    module's.

    Raises
    ------
    ImportError
        If the package is missing. The message names the feature that needs it and the command that installs it.
    """
    try:
        return import_module(module)
    except ImportError as error:
        package = package or module.partition(".")[0]
        raise ImportError(f"{package} is needed for {purpose}: {install(package)}") from error
