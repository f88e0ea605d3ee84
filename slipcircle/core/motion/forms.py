"""What a `Motion` turns into for other tools. The core computes; a package above it says here who makes the forms."""

from importlib import import_module
from typing import Any

from numpy.typing import ArrayLike

_modules: list[str] = []


def use_forms(module: str) -> None:
    """Name the module with the functions `to_dict`, `to_pandas`, `to_xarray`, `html`; imported when one is called."""
    _modules[:] = [module]


class Forms:
    """The methods of `Motion` that other tools call."""

    def to_dict(self, times: ArrayLike | None = None) -> dict[str, Any]:
        """Results by name in SI units; of many lanes arrays, with the numbers that vary before them.

        Parameters
        ----------
        times : array_like, optional
            s; then the histories, ``shape + times.shape``, in place of the results.
        """
        return self._form("to_dict", times)

    def to_pandas(self, times: ArrayLike | None = None) -> Any:
        """`to_dict` as a pandas.DataFrame: a row for each lane, or for each lane and time; units in ``attrs``."""
        return self._form("to_pandas", times)

    def to_xarray(self, times: ArrayLike | None = None) -> Any:
        """`to_dict` as an xarray.Dataset, with the dimensions that inputs had; numbers that vary are its coordinates.

        Raises
        ------
        ValueError
            If inputs name one dimension in two ways: NumPy has paired them element by element.
        """
        return self._form("to_xarray", times)

    def _repr_html_(self) -> str:
        return self._form("html")

    def _form(self, name: str, *arguments: Any) -> Any:
        (module,) = _modules
        return getattr(import_module(module), name)(self, *arguments)
