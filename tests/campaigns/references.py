"""New random scenes and their motion to 20 and 30 digits, beside the package's: how good its error estimates are.

``python -m tests.campaigns.references COUNT --seed N [--sections]`` draws COUNT scenes, of arcs or of sections, solves
them by Taylor series and by the package, and prints of each its kind, its error and the estimate; the exit status is 1
if an estimate is below its error, or a decision other than the reference's.
"""

import math
import sys
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from typing import Any

import numpy as np

import slipcircle
from tests.campaigns import options
from tests.support import accuracy, combinations, references, section_references

LAWS = [law for law in combinations.LAWS if law != "callable"]


def row_of_arc(index: int, seed: int) -> dict[str, Any]:
    """Return a scene of each law in turn with any effects, and its motion."""
    rng, law = np.random.default_rng([seed, index]), LAWS[index % len(LAWS)]
    effects = combinations.ALL[rng.integers(len(combinations.ALL))]
    return {"group": law} | references.first_fit(
        lambda: combinations.drawn(effects, law, int(rng.integers(2**31))), 20, most=(4000, 60)
    )


def compared(index: int, seed: int, sections: bool) -> tuple[str, float, float]:
    """Return the kind of a scene, its error, infinite where it is decided otherwise, and the estimate."""
    row = section_references.row(index, seed) if sections else row_of_arc(index, seed)
    scene = section_references.scene(row["scene"]) if sections else accuracy.scene(row)
    reference = row["reference"]
    try:
        motion = slipcircle.solve(scene)
    except ValueError:  # right where it never rests and no end is given
        return row["group"], math.inf if reference["arrested"] or scene.end_time is not None else 0.0, 0.0
    alike = (motion.moves, motion.arrested) == (reference["moves"], reference["arrested"])
    error = max(accuracy.true_error(motion, reference)) if alike else math.inf
    return row["group"], error, float(motion.error_estimate)


def main() -> int:
    chosen = options(__doc__, 1000, "--sections")
    work, below = partial(compared, seed=chosen.seed, sections=chosen.sections), 0
    with ProcessPoolExecutor(2) as pool:
        for index, (kind, error, estimate) in enumerate(pool.map(work, range(chosen.count))):
            print(f"{index:5} {kind:22} error {error:9.2g}  estimate {estimate:9.2g}")
            below += estimate < error
    return int(below > 0)


if __name__ == "__main__":
    sys.exit(main())
