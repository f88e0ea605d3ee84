"""`slipcircle records`: intensity measures of earthquake records, read from files or generated."""

import argparse
from pathlib import Path
from typing import Any

from slipcircle.workbench.common import files
from slipcircle.workbench.common.units import ACCELERATION
from slipcircle.workbench.outputs.tables import Answer, ResultTable, unit_table
from slipcircle.workbench.records.suite import Suite, read_suite
from slipcircle.workbench.suites.synthetic import synthetic_records, write_records

FORMATS = (
    "files and folders of records, in mixed formats: AT2, ESM, K-NET, COSMOS, CSMIP, GeoNet, SMC, AFAD, JMA, CWA, "
    "UNAM, and tables of numbers"
)

_READING = ("strict", "holds", "columns", "vertical", "units", "step")


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to a parser."""
    parser.add_argument("records", nargs="*", metavar="PATH", help=FORMATS)
    add_reading(parser)
    add_synthetic(parser)
    parser.add_argument("--seed", type=int, default=0, help="seed of synthetic records; default %(default)s")
    out = "write synthetic records, as ground accelerations, into a new folder for sweep --records"
    parser.add_argument("--out", metavar="FOLDER", help=out)
    parser.add_argument("--csv", metavar="FILE", help="write a table of the records")


def add_reading(parser: Any) -> None:
    """Add the options for reading records whose files leave something open, such as units or the time step."""
    ground = "recorded quantity: ground acceleration, positive down-slope, or its opposite; default %(default)s"
    strict = "fail if any file or column is not used"
    roles = "role of each column of tables, overriding headers: time,acceleration,vertical,skip; or wrapped, if "
    roles += "each line continues one series"
    vertical = "names of vertical components, such as '*_Z'; overrides headers and file names"
    units = f"unit of files that do not state theirs: {ACCELERATION.choice}".replace("%", "%%")
    parser.add_argument("--strict", action="store_true", help=strict)
    parser.add_argument("--holds", choices=("ground", "driving"), default="ground", help=ground)
    parser.add_argument("--columns", metavar="ROLES", default=(), help=roles)
    parser.add_argument("--vertical", metavar="PATTERN", help=vertical)
    parser.add_argument("--units", help=f"{units}; of sweep also US or SI, units of output")
    parser.add_argument("--step", type=float, metavar="S", help="time between samples of files without times, s")


def add_synthetic(parser: Any) -> None:
    """Add the option ``--synthetic`` to a parser."""
    made = "synthetic records instead, with this Arias intensity in m/s and duration (5 to 95 %%) in s: 20:1.5:12"
    parser.add_argument("--synthetic", type=_synthetic, metavar="COUNT:ARIAS:DURATION", help=made)


def _synthetic(text: str) -> tuple[int, float, float]:
    """Return number, Arias intensity in m/s and duration in s of synthetic records from ``COUNT:ARIAS:DURATION``."""
    try:
        count, arias, duration = text.split(":")
        return int(count), float(arias), float(duration)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text}: must be COUNT:ARIAS:DURATION, such as 20:1.5:12") from None


def suite_of(options: argparse.Namespace, gravity: float) -> Suite:
    """Return the suite of records that the options select or define; ``gravity`` in m/s^2."""
    if bool(options.records) == bool(options.synthetic):
        raise ValueError(f"{options.command}: give either files or folders of records, or --synthetic")
    if not options.synthetic:
        return read_suite(options.records, gravity=gravity, **{name: getattr(options, name) for name in _READING})
    count, arias, duration = options.synthetic
    return Suite.of(synthetic_records(count, arias, duration, options.seed or 0, gravity))


def run(options: argparse.Namespace) -> Answer:
    """Read or generate the records, write the requested files and return the answer."""
    if options.out:
        _check_folder(options)
    suite = suite_of(options, 9.81)
    record = suite.to_dict()
    if options.out:
        write_records({entry.name: entry.record() for entry in suite}, options.out)
    rows = record["records"]
    written = {"csv": lambda _: files.csv_table(rows[0], [row.values() for row in rows])}
    return Answer(lambda: record, [records_part(suite)], suite.warnings, written)


def _check_folder(options: argparse.Namespace) -> None:
    """Raise ValueError if ``--out`` is not a new or empty folder that can be written."""
    folder = Path(options.out)
    if not options.synthetic:
        raise ValueError("records: --out: writes synthetic records; give --synthetic COUNT:ARIAS:DURATION as well")
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise ValueError(f"records: --out {folder}: exists and is not an empty folder; give a new folder")
    if not folder.absolute().parent.is_dir():
        raise ValueError(f"records: --out {folder}: there is no folder {folder.parent}")


def records_part(suite: Suite) -> ResultTable:
    """Return a table of the records and their intensity measures."""
    with_components = any(entry.place.component for entry in suite)
    names = ["record", *["component"] * with_components, "samples", "step (s)", "unit", "PGA (g)"]
    units = dict.fromkeys(names, "") | {"PGV": "m/s", "I_A": "m/s", "D5-95 (s)": "", "T_m (s)": ""}
    rows = []
    for entry in suite:
        component = [entry.place.component or "-"] if with_components else []
        rows.append([entry.name, *component, entry.samples, entry.step, entry.unit, *entry.intensities])
    note = "I_A: Arias intensity; D5-95: significant duration; T_m: mean period"
    pairs = f", {_counted(len(suite.pairs), 'pair')} of components" if suite.pairs else ""
    return unit_table(units, rows, f"{_counted(len(suite), 'record')}{pairs}", note)


def _counted(count: int, noun: str) -> str:
    """Return a count with a noun in singular or plural."""
    return f"{count} {noun}{'s' * (count > 1)}"
