"""Suites of records: the accelerations in files and folders, in formats mixed as they come, one record after another.

Studies over records use two classes (the package `slipcircle.workbench.suites` works on plain arrays):

* a `Suite` has entries (file, component, samples, step, unit, peak over gravity; `Entry.record()` reads the samples),
  pairs of components by name, unused vertical components, and a line for each file that is not a record;
* a `Study` has arrays over ``(record, polarity, scale, sample)`` of every outcome and of the status, the scales,
  factors and peak accelerations of the scaled records.

The samples of the first records are stored, up to 32 MB. Other records are read again when they are solved, so that the
memory does not grow with the number of records.
"""

import hashlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fnmatch import fnmatch
from functools import cached_property
from os import PathLike
from pathlib import Path
from typing import Any, Literal, NamedTuple

from slipcircle.base.errors import raise_all
from slipcircle.base.inputerror import InputError
from slipcircle.base.kinds import PathName, TextPair, Texts, ValueDict, Values
from slipcircle.base.progress import tracked
from slipcircle.tables import Series
from slipcircle.workbench.common.files import files_in
from slipcircle.workbench.common.units import ACCELERATION, unit_of
from slipcircle.workbench.records.columns import is_direction
from slipcircle.workbench.records.recordfiles import Channel, Options, contents
from slipcircle.workbench.records.records import checked_samples, shaking_of
from slipcircle.workbench.records.stations import Place, place_of
from slipcircle.workbench.suites.intensities import Intensities, drift_warning, intensities
from slipcircle.workbench.suites.repeated import repeated

_KEPT = 2**21  # number of samples of a suite that remain in memory
_SHOWN = 5  # number of reasons in the error for a suite without a record


class Measures(NamedTuple):
    """Intensity measures of a record, the warning about its velocity at the end, and a digest of its samples."""

    intensities: Intensities
    drift: str
    digest: str


@dataclass(frozen=True)
class Entry:
    """Record of a suite.

    Attributes
    ----------
    name : str
        Name of the record in tables: the file's name, and the column if the file has several.
    file : str
        Name of the file, empty for a record given as an array.
    place : Place
        Station and component from the header, the column or the file's name. The component may be empty.
    samples : int
    step : float
        Mean time between samples, s.
    unit : str
        Unit of the values in the file.
    peak : float
        Greatest absolute acceleration over gravity.
    is_vertical : bool
    kept : Series or None
        Samples of arrays and of small suites.
    computed : Measures or None
        Value of `measures` if the samples of a file do not remain in memory.
    """

    name: str
    file: str
    place: Place
    samples: int
    step: float
    unit: str
    peak: float
    is_vertical: bool = False
    kept: Series | None = field(default=None, repr=False)
    reading: Values = field(default_factory=dict, repr=False)
    computed: Measures | None = field(default=None, repr=False)

    @cached_property
    def measures(self) -> Measures:
        """Intensity measures, drift warning and digest, computed when they are first requested."""
        if self.computed:
            return self.computed
        record = self.record()
        gravity = float(self.reading.get("gravity", 9.81))
        digest = hashlib.sha256(record.time.tobytes() + record.values.tobytes()).hexdigest()
        return Measures(intensities(record, gravity), drift_warning(record, gravity), digest)

    @property
    def intensities(self) -> Intensities:
        """Intensity measures of the record."""
        return self.measures.intensities

    def record(self) -> Series:
        """Return driving acceleration over gravity, zero before and after. A record from a file starts at 0 s."""
        return self.kept or _read(self.file, **self.reading)


class Unread(NamedTuple):
    """File or column that is not used, and the reason."""

    file: str
    reason: str

    def __str__(self) -> str:
        """Return the file with the reason why it is not used."""
        return f"{self.file}: {self.reason}"


@dataclass(frozen=True)
class Suite:
    """Records that shake a scene one after another. Samples are read when they are needed.

    Attributes
    ----------
    entries : tuple of Entry
        Horizontal components, in the order of their files.
    verticals : tuple of Entry
        Vertical components, which are not used.
    unread : tuple of Unread
        Files and columns that are not used.
    """

    entries: tuple[Entry, ...]
    verticals: tuple[Entry, ...] = ()
    unread: tuple[Unread, ...] = ()

    def __len__(self) -> int:
        """Return the number of horizontal components."""
        return len(self.entries)

    def __iter__(self) -> Iterator[Entry]:
        """Return an iterator over the horizontal components."""
        return iter(self.entries)

    @property
    def pairs(self) -> list[tuple[Entry, Entry]]:
        """The two horizontal components of each station that has two, by the names of their files."""
        by_station: dict[TextPair, list[Entry]] = {}
        for entry in self.entries:
            if entry.place.component:
                by_station.setdefault((str(Path(entry.file).parent), entry.place.station), []).append(entry)
        return [(same[0], same[1]) for same in by_station.values() if len(same) == 2]

    @property
    def reasons(self) -> Texts:
        """Line for each file, column and vertical component that is not used."""
        return [*map(str, self.unread), *(f"{entry.name}: is a vertical component" for entry in self.verticals)]

    @property
    def not_used(self) -> Texts:
        """Unused files, columns and components as warnings."""
        return [f"{line}; not used" for line in self.reasons]

    @property
    def warnings(self) -> Texts:
        """Warnings about unused files and columns, and about each record whose velocity does not end near 0."""
        drifts = [(entry.name, entry.measures.drift) for entry in self.entries]
        return self.not_used + [f"{name}: {drift}" for name, drift in drifts if drift]

    def to_dict(self) -> ValueDict:
        """Return records with their intensity measures, vertical components, pairs and unused files, for JSON."""
        records = []
        for entry in self.entries:
            record = {name: getattr(entry, name) for name in ("name", "file", "samples", "step", "unit")}
            records.append(record | entry.place._asdict() | entry.intensities._asdict())
        return {
            "records": records,
            "verticals": [entry.name for entry in self.verticals],
            "pairs": [[entry.name for entry in pair] for pair in self.pairs],
            "not_read": [unread._asdict() for unread in self.unread],
        }

    @classmethod
    def without_repeated(cls, entries: Sequence[Entry]) -> "Suite":
        """Return the suite of distinct records. Records with identical samples are listed as unread."""
        measures = [(entry.samples, entry.step, entry.peak) for entry in entries]
        same = repeated(measures, lambda k: entries[k].record().values)
        unread = []
        for k, first in same.items():
            name = str(Path(entries[k].file).parent / entries[k].name)
            unread.append(Unread(name, f"has the samples of {entries[first].name}, which counts once"))
        return cls(tuple(entry for k, entry in enumerate(entries) if k not in same), unread=tuple(unread))

    @classmethod
    def of(cls, records: Any, strict: bool = False, gravity: float = 9.81) -> "Suite":
        """Return a suite from a suite, from paths as for `read_suite`, or from `Series` (a sequence or mapping).

        The names of `Series` are the keys of the mapping or numbers from 1. `strict` and `gravity`, in m/s^2, apply to
        files.
        """
        if isinstance(records, Suite):
            return records
        if isinstance(records, str | PathLike):
            records = [records]
        named = records if isinstance(records, Mapping) else dict(enumerate(records, 1))
        series = {str(name): value for name, value in named.items() if isinstance(value, Series)}
        if len(series) == len(named) > 0:
            return cls.without_repeated([_entry(n, "", Place(n, ""), value, "g") for n, value in series.items()])
        return read_suite(records, strict=strict, gravity=gravity)


def read_suite(
    paths: Iterable[PathName],
    *,
    strict: bool = False,
    holds: Literal["ground", "driving"] = "ground",
    units: str | None = None,
    columns: str | Sequence[str] = (),
    step: float | None = None,
    vertical: str | None = None,
    gravity: float = 9.81,
    gaps: Literal["refuse", "linear"] = "refuse",
) -> Suite:
    """Read the acceleration records in files and folders, in all formats of `read_record`.

    Parameters
    ----------
    paths : iterable of path
        Files, and folders, whose files are read including subfolders, except for hidden files.
    strict : bool, optional
        Whether an unused file or column is an error. Otherwise it is listed in `Suite.unread`.
    holds : {"ground", "driving"}, optional
        Content of all files, see `read_record`.
    units, step : str and float, optional
        Unit of files that do not state it, and time between samples, s, of files without times.
    columns : str or sequence of str, optional
        Roles of columns in tables with this number of columns, see `read_record`.
    vertical : str, optional
        Pattern such as ``*_Z`` for the names of vertical components, instead of headers and names.
    gravity, gaps : float and str, optional
        Arguments of `read_record`.

    Raises
    ------
    ValueError
        If there are no records or, if strict, unused files or columns.
    """
    if units is not None and unit_of(units) is None:
        raise ValueError(f"records: units = {units!r}: must be one of {ACCELERATION.choice}")
    if step is not None and not step > 0.0:
        raise ValueError(f"records: step = {step!r}: must be a positive time in s")
    options = Options(columns, None, step, units, 0.0, gaps, of_all=False)
    options.roles(ACCELERATION)
    entries, unread = _read_all(files_in(paths), vertical, {"options": options, "holds": holds, "gravity": gravity})
    suite = Suite.without_repeated([entry for entry in entries if not entry.is_vertical])
    verticals = tuple(entry for entry in entries if entry.is_vertical)
    suite = replace(suite, verticals=verticals, unread=(*unread, *suite.unread))
    if strict:
        declared = vertical is not None or bool(columns)
        raise_all("records", replace(suite, verticals=() if declared else verticals).reasons)
    if not len(suite):
        raise ValueError(_nothing_read(paths, suite.reasons))
    _check_needed(entries, units and unit_of(units), step)
    return suite


def _read_all(files: Sequence[Path], vertical: str | None, reading: Values) -> tuple[list[Entry], list[Unread]]:
    """Return the records of files, the first of which remain in memory, and the unused files and columns.

    `vertical` is the pattern of `read_suite`, and `reading` are the arguments of `_shaking` for every file.
    """
    entries = []
    unread = []
    remaining = _KEPT
    for file in tracked(files, "records read"):
        try:
            for entry in _entries(file, vertical, reading):
                if isinstance(entry, Unread):
                    unread.append(entry)
                    continue
                remaining -= entry.samples
                entries.append(entry if remaining >= 0 else replace(entry, kept=None, computed=entry.measures))
        except ValueError as error:
            said = error.worded(lambda name: f"--{name}") if isinstance(error, InputError) else str(error)
            unread.append(Unread(str(file), said.removeprefix(str(file)).lstrip(":, ")))
    return entries, unread


def _check_needed(entries: Sequence[Entry], unit: str | None, step: float | None) -> None:
    """Raise an error if all files contradict a given unit or step. The step is in s."""
    units = [entry.unit for entry in entries]
    steps = [f"{entry.step:.3g}" for entry in entries]
    for name, option, stated in (("units", unit, units), ("step", step and f"{step:.3g}", steps)):
        if option and option not in stated:
            raise ValueError(f"records: {name} = {option}, but {entries[0].name} states {stated[0]}; leave {name} out")


def _nothing_read(paths: Iterable[Any], reasons: Sequence[str]) -> str:
    """Return the message that `paths` contain no horizontal record, with the first of the reasons."""
    shown = "".join(f"; {reason}" for reason in reasons[:_SHOWN])
    more = f"; and {len(reasons) - _SHOWN} more" if len(reasons) > _SHOWN else ""
    where = ", ".join(map(str, paths))
    return f"records: {where}: holds no horizontal record{shown}{more}"


def _entries(file: Path, vertical: str | None, reading: Values) -> Iterator[Entry | Unread]:
    """Yield the records of a file, and its unused columns.

    `vertical` is the pattern of `read_suite`, and `reading` are the arguments of `_shaking`.
    """
    channels = contents(ACCELERATION, str(file), file, reading["options"])
    several = len([channel for channel in channels if channel.samples]) > 1
    for k, channel in enumerate(channels):
        if channel.samples is None:
            yield Unread(str(file), str(channel))
            continue
        label = channel.name or str(channel.place)
        name = f"{file.name} {label}" if several else file.name
        place = place_of(file.name, label if several or is_direction(channel.name) else "")
        upright = channel.role == "vertical" or (not channel.role and place.is_vertical)
        if vertical is not None:
            names = (name, file.name, place.component)
            pattern = vertical.lower()
            upright = any(fnmatch(text.lower(), pattern) for text in names)
        series, unit = _shaking(str(file), channel, **reading)
        yield _entry(name, str(file), place, series, unit, {**reading, "channel": k}, upright)


def _read(file: str, channel: int, **reading: Any) -> Series:
    """Return the samples of a record, read again.

    `channel` is its index in the file, from 0, and `reading` the arguments of `_shaking`.
    """
    return _shaking(file, contents(ACCELERATION, file, Path(file), reading["options"])[channel], **reading)[0]


def _shaking(file: str, channel: Channel, options: Options, holds: str, gravity: float) -> tuple[Series, str]:
    """Return a record from 0 s, and the unit stated by its file or given by the user.

    The arguments are those of `read_record`.
    """
    stated = channel.samples.units if channel.samples else ""
    samples = checked_samples(ACCELERATION, file, channel.samples, options._replace(units=stated or options.units))
    return shaking_of(samples, file, holds, gravity), samples.units


def _entry(
    name: str,
    file: str,
    place: Place,
    series: Series,
    unit: str,
    reading: Values | None = None,
    is_vertical: bool = False,
) -> Entry:
    """Return the entry of a record. `unit` is the unit in its file."""
    step = float(series.time[-1] - series.time[0]) / (series.time.size - 1)
    return Entry(name, file, place, series.time.size, step, unit, series.greatest, is_vertical, series, reading or {})
