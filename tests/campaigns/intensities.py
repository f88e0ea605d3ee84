"""Intensity measures of 2,133 real records beside SLAMMER's published table.

`python -m tests.campaigns.intensities FOLDER`: records are not distributed with `slipcircle`, so FOLDER is the folder
`records` of SLAMMER's source with its table `eq.sql` (Jibson, Rathje, Jibson and Lee 2013, U.S. Geological Survey,
Techniques and Methods 12-B1). SLAMMER adds up the squares of samples where straight lines between them have less, so
that its Arias intensities are larger; the last row has them as SLAMMER adds them up.
"""

import sys
from pathlib import Path

import numpy as np

from slipcircle.workbench.records.records import read_record
from slipcircle.workbench.suites.intensities import intensities

# m/s, s, over gravity, cm/s and s, with the last digit printed
DIGITS = {"arias": 1e-3, "duration": 0.1, "pga": 1e-3, "pgv": 0.1, "mean period": 0.01, "summed arias": 1e-3}


def main(folder: Path) -> None:
    """Print how far the measures are from those published, beyond their last digit."""
    rows = []
    for line in (folder / "eq.sql").read_text("utf-8").splitlines():
        earthquake, name, step, _, *measures = line.split("\t")[:9]
        record = read_record(folder / earthquake / name, units="g", step=float(step), holds="driving")
        ours = intensities(record)
        summed = np.pi / 2.0 * 9.81 * float(step) * np.sum(record.values**2)
        computed = [ours.arias, ours.duration, ours.pga, 100.0 * ours.pgv, ours.mean_period, summed]
        rows.append((computed, [*map(float, measures), float(measures[0])]))
    computed, published = np.moveaxis(np.array(rows), 1, 0)
    digits = np.array([*DIGITS.values()])
    beyond = np.maximum(np.abs(computed - published) - digits / 2.0, 0.0) / np.maximum(published, digits)
    for name, column in zip(DIGITS, beyond.T, strict=True):
        print(name, *(f"{value:.2%}" for value in np.quantile(column, [0.5, 0.95, 1.0])))


if __name__ == "__main__":
    main(Path(sys.argv[1]))
