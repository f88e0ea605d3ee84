"""Conversions of results for other tools. The core computes results; a package above it converts and draws them."""

from importlib import import_module
from typing import Any, ClassVar

from numpy.typing import ArrayLike

from slipcircle.base.kinds import PathName, ValueDict, Values


class Pictured:
    """Mixin with the method that draws a result."""

    _conversions: ClassVar[str] = ""  # module that implements the methods, imported when one of them is called

    def plot(self, what: PathName = "overview", ax: Any = None) -> Any:
        """Draw the result with matplotlib, on axes or into a file.

        Parameters
        ----------
        what : str or path
            Name of the picture, or path of a file to write with the overview, ``"slide.png"`` (or .svg, .pdf, .jpg; a
            .gif of a motion is an animation). ``"overview"`` has several panels. A motion also has ``"section"``,
            ``"energy"`` and ``"shaking"``, a motion through layers ``"stress_along_arc"``, and histories
            ``"velocity"``, ``"displacement"``, ``"rotation"``, ``"friction"`` and ``"normal_stress"``. A study also has
            ``"run_out"``, ``"peak_velocity"`` and ``"duration"``. A suite of records has ``"displacements"``,
            ``"incremental"`` and ``"fragility"``, and ``"velocity"`` and ``"displacement"`` of its median record.
        ax : matplotlib axis, optional
            Axis to draw on. The overview creates its own figure.

        Returns
        -------
        matplotlib.axes.Axes or None
            Axis of the picture, or the first panel of the overview. Its ``figure`` has the method ``savefig``. None
            for a file.

        Raises
        ------
        ValueError
            If the name is unknown, or if the motion is an ensemble.
        ImportError
            If matplotlib is not installed.
        """
        return self._convert("plot", what, ax)

    def _convert(self, name: str, *arguments: Any) -> Any:
        """Return the result of a function of the module for conversions.

        ``name`` is the function, and ``arguments`` follow this object.
        """
        return getattr(import_module(self._conversions), name)(self, *arguments)


class Conversions(Pictured):
    """Mixin with the conversions of a `Motion`."""

    @property
    def factors_of_safety(self) -> Values:
        """Factors of safety at the start by method; an `Arc` has only the factor of the paper's method."""
        factors = self._convert("factors_of_safety")
        return factors

    def animate(self, path: str = "", seconds: float = 5.0) -> Any:
        """Animate the slide in its section.

        Parameters
        ----------
        path : str, optional
            Name of a ``.gif`` file to write.
        seconds : float
            Duration of the animation, s.

        Returns
        -------
        matplotlib.animation.FuncAnimation
            Animation, which must be referenced while it plays; None if a path is given.
        """
        return self._convert("animate", path, seconds)

    def to_dict(self, times: ArrayLike | None = None) -> ValueDict:
        """Return results by name in SI units. For an ensemble they are arrays, preceded by the inputs that vary.

        Parameters
        ----------
        times : array_like, optional
            Times in s. If they are given, histories of shape ``shape + times.shape`` replace the results.
        """
        return self._convert("to_dict", times)

    def to_pandas(self, times: ArrayLike | None = None) -> Any:
        """Return `to_dict` as a pandas.DataFrame with one row per case of an ensemble, or per case and time.

        Units are in ``attrs``.
        """
        return self._convert("to_pandas", times)

    def to_xarray(self, times: ArrayLike | None = None) -> Any:
        """Return `to_dict` as an xarray.Dataset with the dimensions of the inputs. Inputs that vary become coordinates.

        Raises
        ------
        ValueError
            If two inputs give different names to the same dimension, since NumPy pairs them element by element.
        """
        return self._convert("to_xarray", times)

    def _repr_html_(self) -> str:
        return self._convert("html")
