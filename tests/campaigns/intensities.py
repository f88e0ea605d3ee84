"""Intensity measures of real records beside published ones.

`python -m tests.campaigns.intensities [FOLDER]`: records are not distributed with `slipcircle`, so FOLDER has those of
pySLAMMER (`sample_ground_motions`; by default of the installed one) or is the folder `records` of SLAMMER's source,
whose table `eq.sql` has the published values of 2,133 records. Published is SLAMMER's table (Jibson, Rathje, Jibson and
Lee 2013, U.S. Geological Survey, Techniques and Methods 12-B1); peak velocities are also those of the PEER Strong
Motion Database, which processed the records on its own.

SLAMMER adds up the squares of samples where straight lines between them have less, so that its Arias intensities are
larger; the campaign also has them as SLAMMER adds them up.
"""

import math
import sys
from collections.abc import Mapping
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple

import numpy as np

from slipcircle import Series
from slipcircle.workbench.records.records import read_record
from slipcircle.workbench.suites.intensities import intensities


class Published(NamedTuple):
    """m/s, s, over gravity, cm/s and s, to the last digit printed."""

    arias: float
    duration: float
    pga: float
    pgv: float
    mean_period: float


DIGITS = Published(1e-3, 0.1, 1e-3, 0.1, 0.01)
PYSLAMMER = {
    "Cape_Mendocino_1992_PET-090": Published(3.822, 16.1, 0.662, 90.1, 0.68),
    "Chi-Chi_1999_TCU068-090": Published(3.303, 12.5, 0.566, 176.9, 1.5),
    "Coalinga_1983_PVB-045": Published(1.571, 8.1, 0.38, 32.4, 0.61),
    "Coyote_Lake_1979_G02-050": Published(0.287, 7.5, 0.211, 11.0, 0.37),
    "Duzce_1999_375-090": Published(2.037, 13.2, 0.514, 20.4, 0.29),
    "Imperial_Valley_1979_BCR-230": Published(5.99, 9.8, 0.775, 45.9, 0.47),
    "Kobe_1995_TAK-090": Published(8.134, 9.9, 0.616, 120.7, 0.99),
    "Kocaeli_1999_ATS-090": Published(1.24, 37.2, 0.185, 32.8, 0.98),
    "Landers_1992_LCN-345": Published(6.588, 13.9, 0.789, 32.5, 0.17),
    "Loma_Prieta_1989_HSP-000": Published(2.205, 16.4, 0.371, 62.3, 0.95),
    "Mammoth_Lakes-1_1980_CVK-090": Published(2.256, 9.2, 0.416, 23.2, 0.32),
    "Mammoth_Lakes-2_1980_CVK-090": Published(0.394, 6.8, 0.266, 19.0, 0.39),
    "Morgan_Hill_1984_CYC-285": Published(3.85, 3.2, 1.298, 80.8, 0.55),
    "N_Palm_Springs_1986_WWT-180": Published(1.768, 5.4, 0.492, 34.7, 0.35),
    "Nahanni_1985_NS1-280": Published(3.852, 8.1, 1.096, 46.1, 0.36),
    "Nisqually_2001_UNR-058": Published(1.458, 31.6, 0.274, 22.9, 0.69),
    "Northridge_1994_PAC-175": Published(0.936, 4.3, 0.415, 45.8, 0.47),
    "Northridge_1994_VSP-360": Published(6.987, 8.5, 0.934, 76.2, 0.46),
}
PEER_VELOCITIES = {
    "Cape_Mendocino_1992_PET-090": 89.7,
    "Kobe_1995_TAK-090": 120.7,
    "Imperial_Valley_1979_BCR-230": 45.9,
    "Loma_Prieta_1989_HSP-000": 62.4,
    "Morgan_Hill_1984_CYC-285": 80.8,
    "Chi-Chi_1999_TCU068-090": 176.6,
}


class Row(NamedTuple):
    """A record; summed is its Arias intensity by the squares of samples."""

    name: str
    computed: Published
    published: Published
    summed: float


def compared(name: str, record: Series, published: Published) -> Row:
    """The measures of a record in the published units."""
    measures = intensities(record)
    computed = Published(measures.arias, measures.duration, measures.pga, 100.0 * measures.pgv, measures.mean_period)
    step = float(record.time[1] - record.time[0])
    summed = math.pi / 2.0 * 9.81 * step * float(np.sum(record.values**2))
    return Row(name, computed, published, summed)


def of_tables(folder: Path, published: Mapping[str, Published]) -> tuple[list[Row], list[str]]:
    """Records in files of times and accelerations over gravity, and the names of those that are not there."""
    files = {name: folder / f"{name}.csv" for name in published}
    absent = [name for name, path in files.items() if not path.exists()]
    present = [name for name in files if name not in absent]
    rows = [compared(name, read_record(files[name], units="g", holds="driving"), published[name]) for name in present]
    return rows, absent


def of_slammer(folder: Path) -> tuple[list[Row], list[str]]:
    """Records in files of accelerations over gravity alone, with their steps and measures by a table."""
    rows, absent = [], []
    for line in (folder / "eq.sql").read_text("utf-8").splitlines():
        earthquake, name, step, _, *measures = line.split("\t")[:9]
        path = folder / earthquake / name
        if path.exists():
            record = read_record(path, units="g", step=float(step), holds="driving")
            rows.append(compared(f"{earthquake} {name}", record, Published(*map(float, measures))))
        else:
            absent.append(f"{earthquake} {name}")
    return rows, absent


def report(rows: list[Row], absent: list[str]) -> None:
    """Each of a few records; of all, how far the measures are from those published, beyond their last digit."""
    for row in rows if len(rows) <= len(PYSLAMMER) else []:
        pairs = zip(Published._fields, row.computed, row.published, strict=True)
        numbers = ", ".join(f"{name} {value:.4g} ({printed:g})" for name, value, printed in pairs)
        velocity = PEER_VELOCITIES.get(row.name, math.nan)
        print(f"{row.name}: {numbers}; PEER pgv {velocity:g}; summed arias {row.summed:.4g}")
    computed = np.array([[*row.computed, row.summed] for row in rows])
    published = np.array([[*row.published, row.published.arias] for row in rows])
    digits = np.array([*DIGITS, DIGITS.arias])
    beyond = np.abs(computed - published) - digits / 2.0
    relative = np.maximum(beyond, 0.0) / np.maximum(published, digits)
    for name, column in zip([*Published._fields, "summed arias"], relative.T, strict=True):
        median, high = np.quantile(column, [0.5, 0.95])
        worst = rows[int(np.argmax(column))].name
        print(f"{name}: {median:.2%} in the median, {high:.2%} in 95 of 100, {column.max():.2%} at most ({worst})")
    print(f"{len(rows)} records; {len(absent)} are not in the folder{': ' if absent else ''}{', '.join(absent[:20])}")


def main(folder: Path) -> None:
    """Compare what the folder has."""
    report(*(of_slammer(folder) if (folder / "eq.sql").exists() else of_tables(folder, PYSLAMMER)))


if __name__ == "__main__":
    module = find_spec("pyslammer")
    installed = Path(str(module.origin)).parent / "sample_ground_motions" if module else None
    given = Path(sys.argv[1]) if len(sys.argv) > 1 else installed
    if given is None:
        sys.exit("give a folder of records, or pip install pyslammer")
    main(given)
