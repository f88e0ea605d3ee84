"""Suites of records: the accelerations in files and folders, in formats mixed as they come, one record after another.

Interface between the parts of a study over records (the package `slipcircle.workbench.suites` takes plain arrays):

* a `Suite` has `Entry` s (file, component, samples, step, unit, peak over gravity; `Entry.record()` reads the samples),
  pairs of components by name, vertical components, which shake nothing, and a line for each file that is no record;
* a `SuiteStudy` has arrays over ``(record, polarity, scale, sample)`` of every outcome and of the status, the scales,
  factors and peak accelerations of the scaled records.

The samples of the first records are kept, up to 32 MB; those of others are read again where they are solved, so that
the memory does not grow with the number of records.
"""

import hashlib
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from os import PathLike
from pathlib import Path
from typing import Any, Literal, NamedTuple

from slipcircle.base.checks import raise_all
from slipcircle.base.progress import track
from slipcircle.tables import Series
from slipcircle.workbench.records.headers import ACCELERATION, unit_of
from slipcircle.workbench.records.recordfiles import Component, Samples, components, parse
from slipcircle.workbench.records.records import checked_samples, shaking_of
from slipcircle.workbench.suites.intensities import Intensities, intensities

_KEPT = 2**21  # samples of a suite that stay in memory
_SHOWN = 5  # reasons in the error of a suite without a record
# Components at the end of a file's name, as PEER, K-NET, ESM and COSMOS write them: azimuths, axes, channel codes.
_NAMED = re.compile(
    r"(?P<station>.*?)(?:(?<!\d)(?P<azimuth>[0-2]\d\d|3[0-5]\d|360)"
    r"|[-_. ]?(?P<axis>NS|EW|UD|UP|DWN|DOWN|VERT?|VRT|FN|FP|H1|H2)(?P<level>[12]?)"
    r"|[-_. ](?P<letter>[NEWSVZXYLT])|[._-]?[HBE][NGHL](?P<channel>[NEZ123])(?P<rest>[._-].*)?)",
    re.IGNORECASE,
)
_VERTICAL = {"UD", "UP", "DWN", "DOWN", "VER", "VERT", "VRT", "V", "Z"}


class Place(NamedTuple):
    """What the name of a file says: the station (or whatever precedes the component), and the component."""

    station: str
    component: str

    @property
    def is_vertical(self) -> bool:
        return self.component.upper().rstrip("12") in _VERTICAL


def place_of(name: str, component: str = "") -> Place:
    """Station and component by the name of a file without its folder, or by the column of a table."""
    stem, dot, suffix = name.rpartition(".")
    is_axis = suffix.upper().rstrip("12") in {"NS", "EW", "UD"}  # K-NET names components by the suffix
    plain = name if is_axis or not dot else stem
    if component:
        return Place(plain, component)
    named = _NAMED.fullmatch(plain)
    if named is None:
        return Place(plain, "")
    parts = named.groupdict(default="")
    component = parts["azimuth"] or parts["axis"] or parts["letter"] or parts["channel"]
    station = parts["station"].rstrip("-_. ") + parts["level"] + parts["rest"]
    return Place(station, component.upper())


@dataclass(frozen=True)
class Entry:
    """One record of a suite.

    Attributes
    ----------
    name : str
        Names the record in tables: the file's name, with the column where it has several.
    file : str
        Empty for a record given as an array.
    station, component : str
        By the file's name; the component is empty where it says none.
    samples : int
    step : float
        Mean time between samples, s.
    unit : str
        Of the values in the file.
    intensities : Intensities
    digest : str
        Of times and values, by which a study that is continued knows the record.
    """

    name: str
    file: str
    place: Place
    samples: int
    step: float
    unit: str
    intensities: Intensities
    digest: str
    kept: Series | None = field(default=None, repr=False)  # the record itself, of arrays and small suites
    reading: Mapping[str, Any] = field(default_factory=dict, repr=False)

    @property
    def peak(self) -> float:
        """Greatest absolute acceleration over gravity."""
        return self.intensities.pga

    @property
    def station(self) -> str:
        return self.place.station

    @property
    def component(self) -> str:
        return self.place.component

    def record(self) -> Series:
        """Driving acceleration over gravity, zero before and after; from a file it starts at 0 s."""
        return self.kept if self.kept is not None else _read(self.file, **self.reading)


class Unread(NamedTuple):
    """A file that is no record, and why."""

    file: str
    reason: str

    def __str__(self) -> str:
        return f"{self.file}: {self.reason}"


@dataclass(frozen=True)
class Suite:
    """Records that shake a scene one after another; samples are read when they are needed.

    Attributes
    ----------
    entries : tuple of Entry
        Horizontal components, in the order of their files.
    verticals : tuple of Entry
        Vertical components by their names, which are not used.
    unread : tuple of Unread
    """

    entries: tuple[Entry, ...]
    verticals: tuple[Entry, ...] = ()
    unread: tuple[Unread, ...] = ()

    def __len__(self) -> int:
        return len(self.entries)

    def __iter__(self) -> Iterator[Entry]:
        return iter(self.entries)

    @property
    def pairs(self) -> list[tuple[Entry, Entry]]:
        """The two horizontal components of each station that has two, by the names of their files."""
        by_station: dict[tuple[str, str], list[Entry]] = {}
        for entry in self.entries:
            if entry.component:
                by_station.setdefault((str(Path(entry.file).parent), entry.station), []).append(entry)
        return [(same[0], same[1]) for same in by_station.values() if len(same) == 2]

    @property
    def reasons(self) -> list[str]:
        """A line for each file without a record and each vertical component."""
        verticals = [f"{entry.name}: is a vertical component by its name" for entry in self.verticals]
        return [*map(str, self.unread), *verticals]

    @property
    def not_used(self) -> list[str]:
        """The same as warnings."""
        return [f"{line}; not used" for line in self.reasons]

    def to_dict(self) -> dict[str, Any]:
        """The records with their intensity measures, and what is not used, for JSON."""
        known = ("name", "file", "station", "component", "samples", "step", "unit")
        plain = [{name: getattr(entry, name) for name in known} for entry in self.entries]
        return {
            "records": [row | entry.intensities._asdict() for row, entry in zip(plain, self.entries, strict=True)],
            "verticals": [entry.name for entry in self.verticals],
            "pairs": [[entry.name for entry in pair] for pair in self.pairs],
            "not_read": [unread._asdict() for unread in self.unread],
        }

    @classmethod
    def of(cls, records: Any, strict: bool = False, gravity: float = 9.81) -> "Suite":
        """A suite as it is, of paths as `read_suite` takes them, or of `Series` (a sequence, or a mapping by name)."""
        if isinstance(records, Suite):
            return records
        if isinstance(records, str | PathLike):
            records = [records]
        named = records if isinstance(records, Mapping) else dict(enumerate(records, 1))
        series = {str(name): value for name, value in named.items() if isinstance(value, Series)}
        if len(series) == len(named) > 0:
            return cls(tuple(_entry(name, "", Place(name, ""), value, "g") for name, value in series.items()))
        return read_suite(records, strict=strict, gravity=gravity)


def read_suite(
    paths: Iterable[str | PathLike[str]],
    *,
    strict: bool = False,
    holds: Literal["ground", "driving"] = "ground",
    units: str | None = None,
    step: float | None = None,
    gravity: float = 9.81,
    gaps: Literal["refuse", "linear"] = "refuse",
) -> Suite:
    """Read the records of acceleration in files and folders: formats as `read_record` has them, mixed as they come.

    Parameters
    ----------
    paths : iterable of path
        Files, and folders, of which all files but hidden ones are read, those of folders within them too.
    strict : bool, optional
        Whether a file that is no record is an error; otherwise it is listed in `Suite.unread`.
    holds : {"ground", "driving"}, optional
        As of `read_record`, of all files.
    units, step : str and float, optional
        Unit of files that do not name theirs; time between samples, s, of files without times.
    gravity, gaps : float and str, optional
        As of `read_record`.

    Raises
    ------
    ValueError
        If there is no record, or, if strict, any file is none.
    """
    _check_reading(units, step)
    entries, unread = list[Entry](), list[Unread]()
    reading = {"holds": holds, "units": units and unit_of(units), "gravity": gravity, "gaps": gaps}
    files = _files(paths)
    remaining = _KEPT
    for file in track(files, "records read"):
        try:
            for entry in _entries(file, step, reading):
                remaining -= entry.samples
                entries.append(entry if remaining >= 0 else replace(entry, kept=None))
        except ValueError as error:
            unread.append(Unread(str(file), str(error).removeprefix(str(file)).lstrip(":, ")))
    if unread and strict:
        raise_all("records", [*map(str, unread)])
    horizontal = tuple(entry for entry in entries if not entry.place.is_vertical)
    verticals = tuple(entry for entry in entries if entry.place.is_vertical)
    suite = Suite(horizontal, verticals, tuple(unread))
    if not horizontal:
        raise ValueError(_nothing_read(paths, suite.reasons))
    return suite


def _check_reading(units: str | None, step: float | None) -> None:
    """Reject a unit or a step that is wrong for every file."""
    if units is not None and unit_of(units) is None:
        raise ValueError(f"records: units = {units!r}: must be one of {ACCELERATION.choice}")
    if step is not None and not step > 0.0:
        raise ValueError(f"records: step = {step!r}: must be a positive time in s")


def _nothing_read(paths: Iterable[Any], reasons: Sequence[str]) -> str:
    """Why there is no horizontal record."""
    shown = "".join(f"; {reason}" for reason in reasons[:_SHOWN])
    more = f"; and {len(reasons) - _SHOWN} more" if len(reasons) > _SHOWN else ""
    where = ", ".join(map(str, paths))
    return f"records: {where}: holds no horizontal record{shown}{more}"


def _files(paths: Iterable[str | PathLike[str]]) -> Sequence[Path]:
    """The files, those of folders in the order of their names, each once."""
    files: dict[Path, None] = {}
    for path in map(Path, paths):
        inside = sorted(path.rglob("*")) if path.is_dir() else [path]
        hidden = [any(part.startswith(".") for part in file.relative_to(path).parts) for file in inside]
        files |= dict.fromkeys(file for file, is_hidden in zip(inside, hidden, strict=True) if not is_hidden)
    return [path for path in files if not path.is_dir()]


def _entries(file: Path, step: float | None, reading: Mapping[str, Any]) -> list[Entry]:
    """The records of a file."""
    entries = []
    for component, parsed in components(str(file), file, step):
        series, unit = _as_shaking(str(file), parsed, **reading)
        name = f"{file.name} {component.name}".rstrip()
        known = {**reading, "component": component}
        entries.append(_entry(name, str(file), place_of(file.name, component.name), series, unit, known))
    return entries


def _read(file: str, component: Component, **reading: Any) -> Series:
    """A record, read again."""
    parsed = parse(ACCELERATION, file, Path(file), component.column, component.step)
    series, _ = _as_shaking(file, parsed, **reading)
    return series


def _as_shaking(
    file: str, parsed: Samples, holds: str, units: str | None, gravity: float, gaps: str
) -> tuple[Series, str]:
    """A record from 0 s, and the unit of its file, or the given one where the file says none."""
    with_unit = parsed._replace(units=parsed.units or units or "")
    samples = checked_samples(ACCELERATION, file, with_unit, None, 0.0, gaps)
    return shaking_of(samples, file, holds, gravity), samples.units


def _entry(
    name: str, file: str, place: Place, series: Series, unit: str, reading: Mapping[str, Any] | None = None
) -> Entry:
    digest = hashlib.sha256(series.time.tobytes() + series.values.tobytes()).hexdigest()
    step = float(series.time[-1] - series.time[0]) / (series.time.size - 1)
    reading = reading or {}
    measures = intensities(series, float(reading.get("gravity", 9.81)))
    return Entry(name, file, place, series.time.size, step, unit, measures, digest, series, reading)
