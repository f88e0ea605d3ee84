"""Permanent displacements of a frozen slip circle beside those of SLAMMER's rigid block, under 18 real records.

`python -m tests.campaigns.slammer FOLDER`: records are not distributed with `slipcircle`, so FOLDER is a checkout of
pySLAMMER/pySLAMMER, which has the records, scaled to peaks of 0.2 to 0.5 g, and SLAMMER 1.1's displacements of blocks
that yield at 0.05 to 0.3 g, in both polarities. A frozen circle moves as the block does, times Gamma. SLAMMER steps
through the samples, where straight lines between them are integrated exactly here; the last row steps as it does.
"""

import gzip
import json
import sys
from collections import defaultdict
from pathlib import Path

import numpy as np

from slipcircle import Scene, Series, ensemble, load

LEAST = 0.5  # cm, below which SLAMMER's steps decide


def stepped(record: Series, k_y: float) -> float:
    """Displacement of a block that may turn round only at samples, by the trapezoidal rule, cm."""
    step = record.time[1] - record.time[0]
    displacement = speed = rate = 0.0
    for shaking in record.values.tolist():
        before, beyond = speed, 980.665 * (shaking - k_y) if speed > 0.0 or shaking > k_y else 0.0
        speed = max(0.0, speed + step / 2.0 * (rate + beyond))
        displacement += step / 2.0 * (before + speed)
        rate = beyond
    return displacement


def main(folder: Path) -> None:
    """Print how far the displacements are from SLAMMER's: relative, and those of small ones in cm."""
    results = folder / "tests/verification_data/results/slammer_results.json.gz"
    published: dict[tuple[float, float], dict[str, list[float]]] = defaultdict(dict)
    for analysis in json.loads(gzip.decompress(results.read_bytes()))["analyses"]:
        if analysis["analysis"]["method"] == "rigid":
            motion, displacements = analysis["ground_motion_parameters"], analysis["results"]
            block = analysis["site_parameters"]["ky_g"], motion["target_pga_g"]
            both = [displacements[f"{way}_displacement_cm"] for way in ("normal", "inverse")]
            published[block][motion["ground_motion_file"]] = both
    records = {}
    for path in (folder / "src/pyslammer/sample_ground_motions").glob("*.csv"):
        records[path.name] = Series(*np.loadtxt(path, delimiter=",", encoding="utf-8-sig").T)
    arc = load("newmark-pulse").arc
    pairs = []
    for (k_y, peak), by_record in published.items():
        # k_y = tan(angle - dip) where the limit friction belongs to the dip
        friction = arc.dimensionless.limit_friction * np.tan(arc.dip + np.arctan(k_y)) / np.tan(arc.dip)
        shaken = {name: records[name] for name in by_record}
        study = ensemble(Scene(arc, friction=friction), records=shaken, polarities=True, scale_to_pga=[peak])
        ours = 100.0 * study.displacement[:, :, 0, 0] / study.block_factor
        scaled = [record.scaled(peak / np.abs(record.values).max()) for record in shaken.values()]
        steps = [[stepped(record.scaled(sign), k_y) for sign in (1.0, -1.0)] for record in scaled]
        pairs.append(np.stack([list(by_record.values()), ours, steps]))
    theirs, *both = np.concatenate(pairs, axis=1)
    large = theirs > LEAST
    for name, ours in zip(("exact", "stepped"), both, strict=True):
        off = np.quantile(np.abs(ours[large] / theirs[large] - 1.0), [0.5, 0.95, 1.0])
        print(f"{name}: {large.sum()} above {LEAST} cm", *(f"{share:.2%}" for share in off))
        print(f"{name}: {(~large).sum()} others, {np.abs(ours - theirs)[~large].max():.3f} cm at most")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
