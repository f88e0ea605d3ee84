"""What a motion gives to people and to their tools: a line, a table, a dictionary, pandas, xarray, lane by lane."""

from collections.abc import Mapping
from dataclasses import replace
from importlib import import_module
from math import prod
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from slipcircle.core.flow.lanes import Lanes
from slipcircle.core.motion.plan import Plan
from slipcircle.core.motion.quantities import HISTORY, OUTCOMES, results, shown, words
from slipcircle.core.motion.states import Status
from slipcircle.core.scene.section import Section
from slipcircle.workbench.common.markup import Raw, table, tag
from slipcircle.workbench.files.variation import scene_with


def library(name: str) -> Any:
    """A library that only what gives its objects needs, or what to type where it is missing."""
    try:
        return import_module(name)
    except ImportError as error:
        raise ImportError(f"to_{name} needs {name}: pip install {name}") from error


_SURE = 1e-11  # an estimated error below which only the format limits what is known
BALANCED = 1e-12  # of all energy on the way, to which it is balanced at least, or a warning says so


class Results:
    """What `Motion` and its lanes are shown as and turned into; columns are named and in units as `quantities` say."""

    plan: Plan
    _lanes: Lanes
    _cells: Mapping[int, NDArray[np.float64]]
    shape: Any
    status: Any
    outcomes: Any
    count: Any
    _times: Any

    def __repr__(self) -> str:
        name = f"{self.plan.scene.name}: " if self.plan.scene.name else ""
        said = "; ".join(" ".join(row) for row in self._summary())
        if not self.shape:
            return f"<Motion {name}{said}>"
        counted = ", ".join(f"{n} {words(status)}" for status, n in self.count().items())
        return f"<{prod(self.shape)} motions {name}{counted}; {said}>"

    def _repr_html_(self) -> str:
        if self.shape:
            rows = [*([words(status), str(n)] for status, n in self.count().items()), *self._summary()]
        else:
            rows = [[q.label, q.text(self)] for q in results(self) if q.key]
        return Raw(tag("b", self.plan.scene.name or "motion") + table(rows))

    def _summary(self) -> list[list[str]]:
        """What repr says: of many lanes each outcome's least and greatest value."""
        if not self.shape:
            key = {q.name: q.text(self) for q in results(self) if q.key}
            if key["moves"] == "no":
                return [["does not move,", f"factor of safety {key['factor_of_safety']}"]]
            end = "rests after" if key["arrested"] == "yes" else "still moves after"
            return [[key["peak_velocity"], "at most"], ["run-out", key["run_out"]], [end, key["duration"]]]
        found = []
        for name, q in OUTCOMES.items():
            values = np.asarray(self.outcomes[name])[~np.isnan(self.outcomes[name])]
            low, high = (shown(float(f(values))) if values.size else "-" for f in (np.min, np.max))
            found.append([words(name), f"{low} to {high} {q.unit}"])
        return found

    @property
    def reason(self) -> Any:
        """Why there is no answer, of each lane; empty where there is one."""
        return self._named("reason")

    def _named(self, what: str) -> Any:
        if not self.shape:
            return getattr(self.status, what)
        return np.array([getattr(s, what) for s in Status])[self.status]

    def __len__(self) -> int:
        if not self.shape:
            raise TypeError("a single motion has no len(): it is not of a scene of arrays")
        return int(self.shape[0])

    def __bool__(self) -> bool:
        return True

    def __getitem__(self, index: Any) -> Self:
        """The motion of one lane, or of some, by NumPy's indices of the scene's shape."""
        if not self.shape:
            raise TypeError("a single motion has no lanes: it is not of a scene of arrays")
        scene = self.plan.scene
        which = np.arange(prod(self.shape)).reshape(self.shape)[index]
        varied = {n: np.broadcast_to(v, self.shape)[index] for n, v in scene.numbers.items() if np.ndim(v)}
        plan = replace(self.plan, scene=scene_with(scene, varied))
        lanes = self._lanes.taken(np.ravel(which))
        made: Any = type(self)
        if np.ndim(which):
            return made(plan, lanes, {k: v[np.ravel(which)] for k, v in self._cells.items()}, [])
        log: list[Any] = []  # which many lanes do not keep
        last = lanes.solve(log)[[*self._cells], 0].tolist()
        return made(plan, lanes, dict(zip(self._cells, last, strict=True)), log)

    @property
    def warnings(self) -> tuple[str, ...]:
        return cautions(self)

    # --- tables ------------------------------------------------------------------------------------------------------

    def to_dict(self, times: ArrayLike | None = None) -> dict[str, Any]:
        """Results by name in SI units; of many lanes arrays, with the numbers that vary before them.

        Parameters
        ----------
        times : array_like, optional
            s; then the histories, ``shape + times.shape``, in place of the results.
        """
        if times is not None:
            at = self._times(times)
            return {name: q.at(self, at) for name, q in HISTORY.items()}
        found = {n: self._full(v) for n, v in self.plan.scene.numbers.items() if np.ndim(v)}
        found |= {n: self._full(v) for q in results(self) for n, v in q.columns(self).items()}
        return found | {"status": self._named("name"), "reason": self.reason}

    def _full(self, value: Any) -> Any:
        return np.broadcast_to(value, self.shape) if self.shape else value

    def _wide(self, times: ArrayLike | None) -> tuple[dict[str, Any], dict[str, Any]]:
        """Axes by name, the last of them time where there are any, and columns over all of them."""
        axes: dict[str, Any] = {name: np.arange(n) for name, n in zip(self._dims, self.shape, strict=True)}
        if times is None:
            return axes, self.to_dict()
        axes["time"] = np.ravel(np.asarray(times, dtype=np.float64))
        return axes, {n: v for n, v in self.to_dict(axes["time"]).items() if n != "time"}

    def to_pandas(self, times: ArrayLike | None = None) -> Any:
        """`to_dict` as a pandas.DataFrame: a row for each lane, or for each lane and time; units in ``attrs``."""
        pandas = library("pandas")
        axes, columns = self._wide(times)
        frame = pandas.DataFrame({n: np.ravel(v) for n, v in columns.items()})
        if len(axes) > 1:
            frame.index = pandas.MultiIndex.from_product(axes.values(), names=[*axes])
        elif axes:
            frame.index = pandas.Index(*axes.values(), name=next(iter(axes)))
        frame.attrs["units"] = self._units
        return frame

    def to_xarray(self, times: ArrayLike | None = None) -> Any:
        """`to_dict` as an xarray.Dataset, with the dimensions that inputs had; numbers that vary are its coordinates.

        Raises
        ------
        ValueError
            If inputs name one dimension in two ways: NumPy has paired them element by element.
        """
        xarray = library("xarray")
        axes, columns = self._wide(times)
        dims, units = self._dims, self._units
        coords: dict[str, Any] = {"time": ("time", axes["time"], {"units": "s"})} if "time" in axes else {}
        for name, value in self.plan.scene.numbers.items():
            sizes = np.shape(value)
            own = [(d, n) for d, n in zip(dims[len(dims) - len(sizes) :], sizes, strict=True) if n > 1]
            if sizes:
                columns.pop(name, None)
                coords[name] = ([d for d, _ in own], np.reshape(np.asarray(value), [n for _, n in own]))
        variables = {n: ([*axes], np.asarray(v), {"units": units.get(n, "")}) for n, v in columns.items()}
        return xarray.Dataset(variables, coords, {"scene": self.plan.scene.name})

    @property
    def _units(self) -> dict[str, str]:
        return {q.name: q.unit for q in (*results(self), *HISTORY.values())}

    @property
    def _dims(self) -> list[str]:
        """Names of the shape's axes: those of inputs that have some, else lane, or lane_0, lane_1, ..."""
        count, found = len(self.shape), dict[int, str]()
        for name, value in self.plan.scene.numbers.items():
            own = tuple(getattr(value, "dims", ()))
            for axis, dim in enumerate(own, count - len(own)):
                if found.setdefault(axis, str(dim)) != str(dim):
                    raise ValueError(
                        f"{name}: its dimension {dim!r} stands where {found[axis]!r} does, and NumPy pairs them "
                        "element by element; use xarray.broadcast before"
                    )
        return [found.get(k, "lane" if count == 1 else f"lane_{k}") for k in range(count)]


def cautions(motion: Any) -> tuple[str, ...]:
    """What a user should know of a single motion; empty where all is well."""
    stability = motion.plan.scene.stability
    found = [stability.warning] if stability and stability.warning else list[str]()
    times = motion.lift_off
    if times:
        more = f", and {len(times) - 1} times more until {times[-1]:.6g} s" if len(times) > 3 else ""
        said = times[:1] if more else times
        found += [f"nothing presses on the slip surface from {t:.6g} s{more} (lift-off)" for t in said]
    if motion.error_estimate > motion.plan.accuracy:
        cause = "its numbers lie far apart"
        if motion.error_estimate < _SURE:
            cause = "no result in float64 is sure to less"
        elif len(motion.phases) > 100:
            cause = "the mass turns back many times"
        elif abs(motion.friction - motion.limit_friction) < 1e-3 * abs(motion.limit_friction):
            cause = "the friction is next to its limit"
        found.append(
            f"ill-conditioned: the estimated error {motion.error_estimate:.1e} is above the accuracy asked for, "
            f"{motion.plan.accuracy:.1e}; {cause}"
        )
    elif motion.moves and motion.energy_error_estimate > BALANCED:
        found.append(
            f"ill-conditioned: the energy is balanced to {motion.energy_error_estimate:.1e} only, as what drives and "
            "what resists are all but equal"
        )
    section = motion.plan.scene.arc
    depth = section.drowned(motion.reach.rotation, motion.end.rotation) if isinstance(section, Section) else 0.0
    if depth > 1e-6 * motion._lanes.radius:
        found.append(
            f"turning brings ground down to {depth:.3g} m below the water level; the weight of the water "
            "above it is left out"
        )
    if motion.swings_back:
        found.append(
            f"the mass swings back: it reaches {abs(motion.reach.displacement):.4g} m after {motion.reach.time:.4g} s, "
            f"farther than its run-out of {abs(motion.run_out):.4g} m at the end"
        )
    return tuple(found)
