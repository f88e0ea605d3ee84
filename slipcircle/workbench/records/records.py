"""Records read from files: ground accelerations and pore pressures.

Signs: positive is down-slope, whichever way the slope faces. A scene's ``k_h`` is the *driving* acceleration over
gravity. In the frame of the ground the inertial force on the mass is opposite to the acceleration of the ground. Ground
that accelerates down-slope, which is positive in a record too, therefore drives the mass up-slope: driving = -ground.
Likewise ``k_v``, which reduces the effective weight, is minus the upward acceleration of the ground. A record file must
therefore be declared as one or the other. `Record` treats arrays as driving by default.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from slipcircle.base.arrays import EPS, INFINITY, array_of, frozen
from slipcircle.base.errors import mistakes, one_number, raise_all
from slipcircle.base.inputerror import InputError
from slipcircle.base.kinds import Floats, PathName, Texts
from slipcircle.tables import Series, bad_sample
from slipcircle.workbench.common.units import (
    ACCELERATION,
    PORE_PRESSURE,
    RecordedQuantity,
    check_strength,
    over_gravity,
    unit_of,
)
from slipcircle.workbench.records.recordfiles import Options, RecordSamples, choice, contents

_GAP = 1.5  # least gap over the step of an evenly sampled record


def read_record(
    path: PathName,
    *,
    holds: Literal["ground", "driving"],
    units: str | None = None,
    column: int | str | None = None,
    columns: str | Sequence[str] = (),
    step: float | None = None,
    start: float | None = None,
    gravity: float = 9.81,
    gaps: Literal["refuse", "linear"] = "refuse",
    scaled: bool = False,
) -> Series:
    """Read an acceleration record as shaking: driving acceleration over gravity, zero before and after the record.

    Known formats are PEER's AT2, K-NET and KiK-net (the mean of the counts is subtracted), COSMOS 1.20, CSMIP's and
    GeoNet's volume 2, corrected SMC of the U.S. Geological Survey, and SLIST and TSPAIR. ``column`` selects one of
    several channels by its number from 1 or its orientation. Other files are tables of numbers, separated by commas,
    semicolons, tabs or blanks, whose headers name the columns and state step and unit, as in files of ESM, AFAD, JMA,
    CWA and UNAM. Two columns without names are time and acceleration if the first increases evenly by less than 0.5 s.
    Lines that begin with #, % or ! are comments.

    Parameters
    ----------
    path : str or path-like
    holds : {"ground", "driving"}
        Content of the file. Positive is down-slope, whichever way the slope faces, and upwards for a vertical record.
        The acceleration of the ground acts on the mass with the opposite sign, so that the values change their sign.
    units : {"g", "mg", "%g", "m/s2", "cm/s2", "gal", "mm/s2", "ft/s2", "in/s2"}, optional
        Required if the file does not state it.
    column : int or str, optional
        Column of the acceleration: its name in the header, or its number, from 1. Required if there are several.
    columns : str or sequence of str, optional
        Roles of all columns of a table, instead of its header: "time,acceleration,skip". A role is "time",
        "acceleration", "vertical" or "skip". "wrapped" alone means that each line contains several values of one
        series.
    step : float, optional
        Time between samples, s, for a file without times.
    start : float, optional
        Time of the first sample, s, by default the file's, or 0.
    gravity : float, optional
        Divisor of accelerations in units other than g, m/s^2.
    gaps : {"refuse", "linear"}, optional
        Treatment of samples missing from an evenly sampled record: an error, or linear interpolation.
    scaled : bool, optional
        Whether the values are scaled later, so that they may be of any size; otherwise they must be below 5 g.

    Returns
    -------
    Series

    Raises
    ------
    ValueError
        If the file cannot be read. The message gives the file, the line, the value, the allowed values, and the remedy.
    """
    raise_all(str(path), mistakes({"gravity": gravity}, {"gravity": _GRAVITY}))
    samples, _ = read_record_samples(ACCELERATION, path, Options(columns, column, step, units, start, gaps))
    return shaking_of(samples, str(path), holds, gravity, scaled)


def shaking_of(samples: RecordSamples, name: str, holds: str, gravity: float, scaled: bool = False) -> Series:
    """Return the accelerations of a file as shaking.

    `name` is the name of the file, and the other arguments are those of `read_record`.
    """
    if holds not in ("ground", "driving"):
        choice = '"ground" (acceleration of the ground) or "driving" (its opposite)'
        raise ValueError(f"holds = {holds!r}: must be {choice}")
    if not scaled:
        check_strength(name, samples.values, samples.units)
    return Series(samples.time, over_gravity(samples.values, samples.units, holds, gravity), held=False)


class Record(Series):
    """Measured acceleration from arrays or a file as shaking: over gravity, zero before and after the record.

    ``Record(t, a)`` accepts times, ``Record(a, dt=0.01)`` a constant step from 0. An example of its use is
    ``{"shaking": {"horizontal": Record(t, a)}}``.

    Parameters
    ----------
    samples : array_like
        Times in s and accelerations, or accelerations alone.
    dt : float, optional
        Time between samples, s, instead of times.
    units : {"g", "mg", "%g", "m/s2", "cm/s2", "gal", "mm/s2", "ft/s2", "in/s2"}, optional
    holds : {"driving", "ground"}, optional
        Positive is down-slope, whichever way the slope faces. "driving" is the acceleration that acts on the mass,
        "ground" the acceleration of the ground, which acts on the mass with the opposite sign.
    gravity : float, optional
        Divisor of accelerations in units other than g, m/s^2.

    Raises
    ------
    ValueError
        If a sample or argument is invalid. For values beyond 5 g the message suggests a unit.
    """

    def __init__(
        self,
        *samples: ArrayLike,
        dt: float | None = None,
        units: str = "g",
        holds: Literal["driving", "ground"] = "driving",
        gravity: float = 9.81,
    ) -> None:
        if len(samples) != (2 if dt is None else 1):
            raise ValueError(f"Record: has {len(samples)} arrays: give Record(t, a), or Record(a, dt=0.01)")
        if holds not in ("ground", "driving"):
            raise ValueError(f'Record: holds = {holds!r}: must be "driving" or "ground"')
        unit = unit_of(str(units))
        if unit is None:
            raise ValueError(f"Record: units = {units!r}: must be one of {ACCELERATION.choice}")
        numbers = {"gravity": _GRAVITY} if dt is None else {"gravity": _GRAVITY, "dt": _STEP}
        raise_all("Record", mistakes({"gravity": gravity, "dt": dt}, numbers))
        time = samples[0]
        values = array_of(samples[-1])
        if dt is not None:
            time = dt * np.arange(float(values.size))
        super().__init__(array_of(time), values, held=False)
        check_strength("Record", self.values, unit)
        object.__setattr__(self, "values", frozen(over_gravity(self.values, unit, holds, gravity)))

    read = staticmethod(read_record)


def pressure_of(samples: RecordSamples, name: str) -> dict[str, Series]:
    """Return the pore pressures of a file as parameters of the effect, "ratio" or "pressure" in Pa.

    `name` is the name of the file, for messages.
    """
    is_ratio = samples.units == "ratio"
    bad = np.flatnonzero((samples.values < 0.0) | (is_ratio & (samples.values >= 1.0)))
    if bad.size:
        k = int(bad[0])
        value = float(samples.values[k])
        allowed = "a ratio of at least 0 and below 1" if is_ratio else "a pressure of at least 0"
        rule = f"must be {allowed}; mend the value, or check the units and the column"
        raise ValueError(f"{name}, line {samples.lines[k]}: value = {value!r}: {rule}")
    return {
        "ratio" if is_ratio else "pressure": Series(samples.time, samples.values * PORE_PRESSURE.units[samples.units])
    }


_GRAVITY = one_number(0.0, INFINITY, "a positive number in m/s^2")
_STEP = one_number(0.0, INFINITY, "a positive time in s")
_START = one_number(-5e-324, INFINITY, "a time in s, not before 0")


def read_record_samples(quantity: RecordedQuantity, path: PathName, options: Options) -> tuple[RecordSamples, Texts]:
    """Return checked samples of the single record in a file, and a line for each unused column.

    The values have the unit of the file. `quantity` is acceleration or pore pressure.
    """
    name = str(path)
    times = {"step": _STEP, "start": _START}
    raise_all(name, mistakes(options._asdict(), {n: p for n, p in times.items() if getattr(options, n) is not None}))
    channels = contents(quantity, name, Path(path), options)
    read = [channel for channel in channels if channel.samples]
    if len(read) > 1:
        shown = choice((channel.place, channel.name) for channel in read)
        raise InputError("", [f"{name}: has several columns of {quantity.name}; give {{column}}, one of {shown}"])
    samples = checked_samples(quantity, name, read[0].samples, options)
    step = float(np.mean(np.diff(samples.time)))
    if options.step and abs(step - options.step) > 0.01 * step:
        rule = f"but the file has steps of {step:.6g} s; leave it out"
        raise InputError("", [f"{name}: {{step}} = {options.step!r}, {rule}"])
    return samples, [f"{name}: {channel}; not used" for channel in channels if channel.reason]


def checked_samples(
    quantity: RecordedQuantity, name: str, samples: RecordSamples | None, options: Options
) -> RecordSamples:
    """Return samples of a file with checked times in s, and with their unit.

    `name` is the name of the file, for messages.
    """
    requested = "" if options.units is None else unit_of(options.units, quantity)
    if requested is None or samples is None:
        raise ValueError(f"{name}: units = {options.units!r}: must be one of {quantity.choice}")
    if samples.units and requested and samples.units != requested:
        rule = f"but its header says {samples.units}; leave units out, or correct the header"
        raise ValueError(f"{name}: units = {options.units!r}, {rule}")
    unit = samples.units or requested
    if not unit:
        raise ValueError(f"{name}: units are missing: its header names none; give units, one of {quantity.choice}")
    return samples._replace(time=_checked_times(name, samples, options.start, options.gaps), units=unit)


def _checked_times(name: str, samples: RecordSamples, start: float | None, gaps: str) -> Floats:
    """Return the times of samples after checks: finite, increasing, not before 0, and without rejected gaps.

    `name` is the name of the file, and `start` the time of the first sample in s. `gaps` is "refuse" or "linear".
    """
    if gaps not in ("refuse", "linear"):
        raise ValueError(f'gaps = {gaps!r}: must be "refuse" or "linear"')
    wrong = bad_sample(samples.time, samples.values)
    if wrong is None and gaps == "refuse":
        wrong = _gap(samples.time)
    if wrong is not None:
        raise ValueError(f"{name}, line {samples.lines[wrong[0]]}: {wrong[1]}")
    time = samples.time if start is None else samples.time - samples.time[0] + start
    if time[0] < 0.0:
        first = f"{name}, line {samples.lines[0]}: time = {float(time[0])!r} s"
        rule = "must not be before 0, when the scene starts; give {start}, the time of the first sample in s"
        raise InputError("", [f"{first}: {rule}"])
    return time


def _gap(time: Floats) -> tuple[int, str] | None:
    """Return the index of the first sample after a gap, and a message; None without a gap.

    The times, in s, must otherwise be evenly spaced.
    """
    steps = np.diff(time)
    usual = float(np.median(steps))
    even = np.abs(steps - usual) <= 0.01 * usual + 8 * EPS * time[-1]
    wide = np.flatnonzero(steps > _GAP * usual)
    if steps.size < 8 or not wide.size or np.count_nonzero(even) < 0.9 * steps.size:
        return None
    k = int(wide[0]) + 1
    return k, (
        f"time = {float(time[k])!r} s comes {float(steps[k - 1]):.6g} s after the sample before, where the step is "
        f'{usual:.6g} s: samples are missing; fill them in, or give gaps = "linear" for a straight line'
    )
