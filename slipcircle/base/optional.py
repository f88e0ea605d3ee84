"""Packages that only some results need: imported where they are used, or one line says how to install them."""

from importlib import import_module
from typing import Any

EXTRAS = {
    "scipy": ("SciPy", "'slipcircle[scenes]'"),
    "rich": ("rich", "'slipcircle[scenes]'"),
    "matplotlib": ("matplotlib", "'slipcircle[plot]'"),
    "dask": ("Dask", "'slipcircle[dask]'"),
    "distributed": ("Dask's distributed", "'slipcircle[dask]'"),
    "sympy": ("SymPy", "'slipcircle[derive]'"),
    "mpmath": ("mpmath", "'slipcircle[derive]'"),
    "flint": ("python-flint", "'slipcircle[derive]'"),
}


def install(package: str) -> str:
    """The command that installs an optional package."""
    _, requirement = EXTRAS.get(package, ("", package))
    return f"pip install {requirement}"


def optional(module: str, purpose: str) -> Any:
    """A module of an optional package.

    Raises
    ------
    ImportError
        Without the package: what needs it, and the command that installs it.
    """
    try:
        return import_module(module)
    except ImportError as error:
        package = module.partition(".")[0]
        name, _ = EXTRAS.get(package, (package, ""))
        raise ImportError(f"{name} is needed for {purpose}: {install(package)}") from error
