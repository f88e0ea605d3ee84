"""Conversions of a `Motion` to a dictionary, pandas, xarray and HTML, called by its methods.

Names and units of columns are declared in `quantities`.
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from slipcircle.base.kinds import TextDict, Texts, ValueDict
from slipcircle.base.optional import optional
from slipcircle.base.text import number_text
from slipcircle.core import Motion, Status
from slipcircle.workbench.common.markup import Raw, html_table, tag
from slipcircle.workbench.common.quantities import HISTORY, OUTCOMES, factors_of, results, spelt_out
from slipcircle.workbench.common.summary import key_results


def motion_table(motion: Motion) -> str:
    """Return an HTML table of the key results; for an ensemble, the count of each status and ranges of outcomes."""
    rows = key_results(motion) if not motion.shape else {}
    if motion.shape:
        for name, count in motion.count().items():
            rows[Status[name].words] = str(count)
        for name, quantity in OUTCOMES.items():
            rows[spelt_out(name)] = _span(motion.outcomes[name], quantity.unit)
    return Raw(tag("b", motion.plan.scene.name or "motion") + html_table([*rows.items()]))


def _span(values: Any, unit: str) -> str:
    """Return the least and the greatest of the values that are not NaN, as text in the given unit; "-" without any."""
    finite = values[~np.isnan(values)]
    return f"{number_text(finite.min())} to {number_text(finite.max())} {unit}" if finite.size else "-"


def to_dict(motion: Motion, times: ArrayLike | None) -> ValueDict:
    """Return results by name in SI units, preceded by the varying numbers; or histories at ``times`` in s."""
    if times is not None:
        motion.at(times)  # raises an error for times outside the motion
        time = np.asarray(times, float)
        return {name: q.at(motion, time) for name, q in HISTORY.items()}
    columns: ValueDict = {name: value for name, value in motion.plan.scene.numbers.items() if np.ndim(value)}
    for quantity in results(motion):
        columns |= quantity.columns(motion)
    columns["factors_of_safety"] = factors_of(motion)
    if not motion.shape:
        return columns | {"status": motion.status.name, "reason": motion.reason}
    names = np.array([status.name for status in Status])
    columns |= {"status": names[motion.status], "reason": motion.reason}
    by_method = columns.pop("factors_of_safety")
    lanes = {name: np.broadcast_to(value, motion.shape) for name, value in columns.items()}
    return lanes | {"factors_of_safety": by_method}


def to_pandas(motion: Motion, times: ArrayLike | None) -> Any:
    """Return `to_dict` as a pandas.DataFrame with a row per lane, or per lane and time, and units in ``attrs``."""
    pandas = optional("pandas", "to_pandas")
    axes, columns = _axes_and_columns(motion, times)
    frame = pandas.DataFrame({name: np.ravel(values) for name, values in columns.items()})
    if len(axes) > 1:
        frame.index = pandas.MultiIndex.from_product(axes.values(), names=[*axes])
    elif axes:
        frame.index = pandas.Index(*axes.values(), name=next(iter(axes)))
    frame.attrs["units"] = _units(motion)
    return frame


def to_xarray(motion: Motion, times: ArrayLike | None) -> Any:
    """Return `to_dict` as an xarray.Dataset with the dimensions of the inputs; varying numbers are coordinates."""
    xarray = optional("xarray", "to_xarray")
    axes, columns = _axes_and_columns(motion, times)
    lane_dims = _dimensions(motion)
    units = _units(motion)
    coordinates: ValueDict = {}
    if times is not None:
        coordinates["time"] = ("time", axes["time"], {"units": "s"})
    for name, value in motion.plan.scene.numbers.items():
        if not np.ndim(value):
            continue
        columns.pop(name, None)
        dims = lane_dims[len(lane_dims) - np.ndim(value) :]
        varying = [dim for dim, size in zip(dims, np.shape(value), strict=True) if size > 1]
        coordinates[name] = (varying, np.squeeze(np.asarray(value)))
    variables = {n: ([*axes], np.asarray(values), {"units": units.get(n, "")}) for n, values in columns.items()}
    return xarray.Dataset(variables, coordinates, {"scene": motion.plan.scene.name})


def _axes_and_columns(motion: Motion, times: ArrayLike | None) -> tuple[ValueDict, ValueDict]:
    """Return coordinates by axis, and columns by name over all axes.

    The axes are those of the ensemble, followed by time in s if ``times`` are given.
    """
    axes = {}
    for name, size in zip(_dimensions(motion), motion.shape, strict=True):
        axes[name] = np.arange(size)
    if times is None:
        columns = to_dict(motion, None)
        by_method = columns.pop("factors_of_safety")
        return axes, columns | {f"factors_of_safety.{method}": factor for method, factor in by_method.items()}
    axes["time"] = np.ravel(np.asarray(times, float))
    columns = to_dict(motion, axes["time"])
    del columns["time"]
    return axes, columns


def _units(motion: Motion) -> TextDict:
    """Return the SI unit of each result and each quantity over time by name."""
    return {q.name: q.unit for q in (*results(motion), *HISTORY.values())}


def _dimensions(motion: Motion) -> Texts:
    """Return the names of the axes of an ensemble: dimensions of its inputs, else lane, or lane_0, lane_1, ..."""
    count = len(motion.shape)
    named: dict[int, str] = {}
    for name, value in motion.plan.scene.numbers.items():
        dims = [str(dim) for dim in getattr(value, "dims", ())]
        for axis, dim in enumerate(dims, count - len(dims)):
            if named.setdefault(axis, dim) != dim:
                raise ValueError(
                    f"{name}: its dimension {dim!r} is on the axis of {named[axis]!r}, and NumPy pairs them element by "
                    "element; use xarray.broadcast before"
                )
    default = ["lane"] if count == 1 else [f"lane_{axis}" for axis in range(count)]
    return [named.get(axis, default[axis]) for axis in range(count)]
