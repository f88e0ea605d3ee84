"""New random scenes and their motion to 20 and 30 digits, beside the package's: how good its error estimates are.

``python -m tests.campaigns.references COUNT --seed N [--sections]`` draws COUNT scenes, of arcs or of sections, solves
them by Taylor series and by the package, and prints by kind the worst error and the least estimate over error; the exit
status is 1 if an estimate is below its error, or a decision other than the reference's.
"""

import argparse
import math
import sys
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from typing import Any, NamedTuple

import numpy as np

import slipcircle
from tests.support import accuracy, combinations, references, section_references

LAWS = [law for law in combinations.LAWS if law != "callable"]


class Compared(NamedTuple):
    """A scene: its kind, whether it was decided alike, the true error and its estimate."""

    group: str
    alike: bool
    error: float
    estimate: float
    scene: Any


def row_of_arc(index: int, seed: int) -> dict[str, Any]:
    """A scene of each law in turn with any effects, and its motion."""
    rng, law = np.random.default_rng([seed, index]), LAWS[index % len(LAWS)]
    effects = combinations.ALL[rng.integers(len(combinations.ALL))]
    return {"group": law} | references.first_fit(
        lambda: combinations.drawn(effects, law, int(rng.integers(2**31))), 20, most=(4000, 60)
    )


def compared(index: int, seed: int, sections: bool) -> Compared:
    """A scene drawn, and solved both ways."""
    row = section_references.row(index, seed) if sections else row_of_arc(index, seed)
    scene = section_references.scene(row["scene"]) if sections else accuracy.scene(row)
    reference = row["reference"]
    try:
        motion = slipcircle.solve(scene)
    except ValueError:  # right where it never rests and no end is given
        return Compared(row["group"], not reference["arrested"] and scene.end_time is None, 0.0, 0.0, row["scene"])
    alike = (motion.moves, motion.arrested) == (reference["moves"], reference["arrested"])
    error = max(accuracy.true_error(motion, reference))
    return Compared(row["group"], alike, error, float(motion.error_estimate), row["scene"])


def main() -> int:
    parser = argparse.ArgumentParser(description=str(__doc__).partition("\n")[0])
    parser.add_argument("count", metavar="COUNT", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--sections", action="store_true")
    options = parser.parse_args()
    with ProcessPoolExecutor(2) as pool:
        work = partial(compared, seed=options.seed, sections=options.sections)
        rows = list(pool.map(work, range(options.count), chunksize=4))
    print(f"{'kind':22} scenes  worst error  least estimate/error")
    for group in sorted({row.group for row in rows}):
        of_group = [row for row in rows if row.group == group]
        least = min((row.estimate / row.error for row in of_group if row.error), default=math.inf)
        print(f"{group:22} {len(of_group):6}  {max(row.error for row in of_group):11.2g}  {least:20.3g}")
    bad = [row for row in rows if not row.alike or row.estimate < row.error]
    print(*bad, sep="\n")
    return int(bool(bad))


if __name__ == "__main__":
    sys.exit(main())
