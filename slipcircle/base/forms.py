"""What results turn into for other tools and for the eye. The core computes; a package above makes the forms."""

from collections.abc import Mapping
from importlib import import_module
from os import PathLike
from typing import Any

from numpy.typing import ArrayLike

_modules: list[str] = []


def use_forms(module: str) -> None:
    """Name the module with a function for each method below, `html` in notebooks; imported when one is called."""
    _modules[:] = [module]


class Pictured:
    """The method that draws a result."""

    def plot(self, what: str | PathLike[str] = "overview", ax: Any = None) -> Any:
        """Draw it with matplotlib, on axes or into a file.

        Parameters
        ----------
        what : str or path
            ``"overview"``, which is several panels, or the path of a file to write with these, ``"slide.png"`` (.svg,
            .pdf, .jpg; .gif of a motion is an animation). Of a motion also ``"section"``, ``"energy"``, ``"shaking"``,
            of one through layers ``"stress_along_arc"``, and over time ``"velocity"``, ``"displacement"``,
            ``"rotation"``, ``"friction"``, ``"normal_stress"``; of a study also ``"run_out"``, ``"peak_velocity"``,
            ``"duration"``; of a suite of records ``"displacements"``, ``"incremental"``, ``"fragility"``, and of its
            median record ``"velocity"``, ``"displacement"``.
        ax : matplotlib axis, optional
            To draw on, but not of the overview, which makes its figure.

        Returns
        -------
        matplotlib.axes.Axes or None
            Of the overview its first panel; ``.figure`` is the whole, with ``savefig``. None where a path is given.

        Raises
        ------
        ValueError
            If there is no such picture, or a motion has many lanes.
        ImportError
            Without matplotlib.
        """
        return self._form("plot", what, ax)

    def _form(self, name: str, *arguments: Any) -> Any:
        (module,) = _modules
        return getattr(import_module(module), name)(self, *arguments)


class Forms(Pictured):
    """The methods of `Motion` that other tools call."""

    @property
    def factors_of_safety(self) -> Mapping[str, Any]:
        """Factors of safety at the start by each method that the mass allows; of an `Arc`, by the paper's alone."""
        factors: Mapping[str, Any] = self._form("factors_of_safety")
        return factors

    def animate(self, path: str = "", seconds: float = 5.0) -> Any:
        """The slide as a moving section.

        Parameters
        ----------
        path : str, optional
            Of a file ``.gif`` to write.
        seconds : float
            That the motion is shown in.

        Returns
        -------
        matplotlib.animation.FuncAnimation
            To keep while it plays, or to save otherwise; None where a path was given.
        """
        return self._form("animate", path, seconds)

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
