"""`slipcircle records`: records of files and folders with their intensity measures, or synthetic ones to be written."""

import argparse
from collections.abc import Sequence
from itertools import zip_longest
from pathlib import Path
from typing import Any

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.base.text import shown
from slipcircle.workbench.common import files
from slipcircle.workbench.outputs.tables import Answer, Part
from slipcircle.workbench.records.headers import ACCELERATION, UNITS
from slipcircle.workbench.records.recordfiles import parse
from slipcircle.workbench.records.records import checked_samples
from slipcircle.workbench.records.suite import Suite, read_suite
from slipcircle.workbench.suites.spectra import misfit
from slipcircle.workbench.suites.synthetic import synthetic_records, write_records

HELP = "earthquake records of files and folders with their intensity measures, or synthetic ones for a folder"
FORMATS = "files and folders of records: AT2, ESM, K-NET, COSMOS, CSMIP, SMC, and tables of numbers, mixed"


def options(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("records", nargs="*", metavar="PATH", help=FORMATS)
    add_reading(parser)
    add_synthetic(parser)
    parser.add_argument("--seed", type=int, default=0, help="of synthetic records; default %(default)s")
    out = "write synthetic records into a new folder, which sweep --records reads, as accelerations of the ground"
    parser.add_argument("--out", metavar="FOLDER", help=out)
    parser.add_argument("--csv", metavar="FILE", help="write a table of the records")


def add_reading(parser: Any) -> None:
    """Options of what files do not say."""
    ground = "what the records hold, positive down-slope; default %(default)s, whose opposite drives the mass"
    parser.add_argument("--strict", action="store_true", help="stop if a file is no record, and do not go on without")
    parser.add_argument("--holds", choices=("ground", "driving"), default="ground", help=ground)
    parser.add_argument("--units", help="unit of files that do not name theirs: g, m/s2, cm/s2, gal, mm/s2")
    parser.add_argument("--step", type=float, metavar="S", help="time between samples of files without times, s")


def add_synthetic(parser: Any) -> None:
    """The option of synthetic records."""
    made = "synthetic ones in their place, of an Arias intensity in m/s and a duration (5 to 95 %%) in s: 20:1.5:12"
    parser.add_argument("--synthetic", type=_synthetic, metavar="COUNT:ARIAS:DURATION", help=made)
    target = "period in s and acceleration in g at 5 %% damping by lines: --synthetic 20:12 (COUNT:DURATION) matches it"
    parser.add_argument("--spectrum", metavar="FILE", help=f"target spectrum, {target}; the table has what remains")


def _synthetic(text: str) -> tuple[int, float | None, float]:
    """COUNT:ARIAS:DURATION or COUNT:DURATION."""
    try:
        count, *arias, duration = text.split(":")
        (intensity,) = map(float, arias) if arias else (None,)
        return int(count), intensity, float(duration)
    except ValueError:
        form = "COUNT:ARIAS:DURATION, such as 20:1.5:12, or with --spectrum COUNT:DURATION"
        raise argparse.ArgumentTypeError(f"{text}: must be {form}") from None


def suite_of(options: argparse.Namespace, gravity: float) -> Suite:
    """The suite that the options ask for."""
    if bool(options.records) == bool(options.synthetic):
        raise ValueError(f"{options.command}: give either files and folders of records, or --synthetic")
    if not options.synthetic:
        reading = {name: getattr(options, name) for name in ("strict", "holds", "units", "step")}
        return read_suite(options.records, gravity=gravity, **reading)
    count, arias, duration = options.synthetic
    if (arias is None) != bool(options.spectrum):
        raise ValueError(
            f"{options.command}: --synthetic: give COUNT:ARIAS:DURATION, or COUNT:DURATION with --spectrum FILE, which "
            "has the intensity"
        )
    spectrum = target_spectrum(options)
    return Suite.of(synthetic_records(count, arias, duration, options.seed or 0, gravity, spectrum))


def target_spectrum(options: argparse.Namespace) -> tuple[Floats, Floats] | None:
    """Periods and accelerations of the file, if there is one."""
    if not options.spectrum:
        return None
    try:
        parsed = parse(ACCELERATION, options.spectrum, Path(options.spectrum), None, None)
        in_g = parsed._replace(units=parsed.units or "g")
        found = checked_samples(ACCELERATION, options.spectrum, in_g, None, None, "linear")
    except ValueError as error:
        form = "a spectrum has increasing periods in s in its first column and accelerations in g in its second"
        raise ValueError(f"--spectrum {error}; {form}") from error
    unit = {"g": 1.0, "%g": 0.01}.get(found.units, UNITS[found.units] / 9.81)
    if found.time[0] <= 0.0 or np.any(found.values <= 0.0):
        raise ValueError(f"--spectrum {options.spectrum}: periods and accelerations of a spectrum must be above 0")
    return found.time, found.values * unit


def run(options: argparse.Namespace) -> Answer:
    """Read or make the records, and write what is to be written."""
    if options.out:
        _check_folder(options)
    suite = suite_of(options, 9.81)
    misfits = spectrum_misfits(suite, options)
    record = suite.to_dict()
    for row, remaining in zip(record["records"], misfits, strict=False):
        row["spectrum_misfit"] = remaining
    if options.out:
        write_records({entry.name: entry.record() for entry in suite}, options.out)
    if options.csv:
        rows = record["records"]
        files.write(options.csv, files.table(rows[0], [row.values() for row in rows]))
    return Answer(lambda: record, [records_part(suite, misfits)], suite.not_used)


def _check_folder(options: argparse.Namespace) -> None:
    """Reject a folder that cannot be written, or whose other files would become part of the suite."""
    folder = Path(options.out)
    if not options.synthetic:
        raise ValueError("records: --out: writes synthetic records; give --synthetic COUNT:ARIAS:DURATION as well")
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise ValueError(f"records: --out {folder}: exists, and is not an empty folder; give a new one")
    if not folder.absolute().parent.is_dir():
        raise ValueError(f"records: --out {folder}: there is no folder {folder.parent}")


def spectrum_misfits(suite: Suite, options: argparse.Namespace) -> list[float]:
    """How far the spectrum of each record is from the target, if there is one."""
    target = target_spectrum(options)
    return [] if target is None else [misfit(entry.record(), target) for entry in suite]


def records_part(suite: Suite, misfits: Sequence[float] = ()) -> Part:
    """The records with their intensity measures, and how far their spectra are from a target."""
    with_components = any(entry.component for entry in suite)
    head = ["record", *["component"] * with_components, "samples", "step (s)", "unit", "PGA (g)", "PGV (m/s)"]
    head += ["I_A (m/s)", "D5-95 (s)", "T_m (s)", *["misfit"] * bool(misfits)]
    rows = []
    for entry, remaining in zip_longest(suite, misfits):
        component = [entry.component or "-"] if with_components else []
        samples = [str(entry.samples), shown(entry.step), entry.unit]
        measures = map(shown, entry.intensities)
        of_spectrum = [f"{100.0 * remaining:.2g} %"] if misfits else []
        rows.append([entry.name, *component, *samples, *measures, *of_spectrum])
    note = "I_A: Arias intensity; D5-95: significant duration; T_m: mean period"
    note += "; misfit: root mean square of ln(S_a/target)" if misfits else ""
    pairs = f", {_counted(len(suite.pairs), 'pair')} of components" if suite.pairs else ""
    return Part(head, rows, f"{_counted(len(suite), 'record')}{pairs}", note)


def _counted(count: int, noun: str) -> str:
    return f"{count} {noun}{'s' * (count > 1)}"
