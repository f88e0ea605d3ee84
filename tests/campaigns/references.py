"""New random scenes and their motion to 20 and 30 digits, beside the package's: how good its error estimates are.

``python -m tests.campaigns.references --fresh COUNT --seed N [--sections]`` draws COUNT scenes that nobody has seen, of
arcs or of sections, solves them by Taylor series and by the package, and prints by kind the worst error and the least
estimate over error; the exit status is 1 if an estimate is below its error, or a decision other than the reference's.
Without ``--fresh`` it writes the scenes of the tests anew, 400 of arcs or those of sections, into `tests/support`.
"""

import argparse
import json
import math
import os
import sys
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from typing import Any, NamedTuple

import slipcircle
from tests.support import accuracy, section_references
from tests.support.references import FILE, STEADY, TIMED, make, names


class Found(NamedTuple):
    """Of one new scene: its kind, whether it was decided alike, the true error and its estimate, and the scene."""

    group: str
    alike: bool
    error: float
    estimate: float
    scene: Any


def judged(which: Any, seed: int) -> Found:
    """A scene drawn, and solved both ways; of a section, where it has a number alone."""
    section_references.SEED = seed
    of_arc = isinstance(which, tuple)
    row = make(which, seed) if of_arc else section_references.row(which)
    scene = accuracy.scene(row) if of_arc else section_references.scene(row["scene"])
    kept = row["reference"]
    try:
        motion = slipcircle.solve(scene)
    except ValueError:  # right where it never rests and no end is given
        return Found(row["group"], not kept["arrested"] and scene.end_time is None, 0.0, 0.0, row["scene"])
    alike = (motion.moves, motion.arrested) == (kept["moves"], kept["arrested"])
    error = max(accuracy.true_error(motion, kept))
    return Found(row["group"], alike, error, float(motion.error_estimate), row["scene"])


def fresh(count: int, seed: int, sections: bool) -> int:
    """Kinds by turns, three in four of position and speed; or sections of any ground."""
    asked: list[Any] = [*range(count)]
    if not sections:
        parts = ((STEADY, 3), (TIMED, 1))
        asked = [(list(of)[k % len(of)], k // len(of)) for of, share in parts for k in range(share * count // 4)]
    found = list[Found]()
    with ProcessPoolExecutor(2) as pool:
        for one in pool.map(partial(judged, seed=seed), asked, chunksize=4):
            found.append(one)
            print(f"\r{len(found)} of {len(asked)} scenes", end="", file=sys.stderr, flush=True)
    print(f"{'kind':22} scenes  worst error  least estimate/error")
    for group in dict.fromkeys(f.group for f in found):
        own = [f for f in found if f.group == group]
        least = min((f.estimate / f.error for f in own if f.error), default=math.inf)
        print(f"{group:22} {len(own):6}  {max(f.error for f in own):11.2g}  {least:20.3g}")
    bad = [f for f in found if not f.alike or f.estimate < f.error]
    for f in bad:
        said = "alike" if f.alike else "otherwise"
        print(f"{f.group}: error {f.error:.3g}, estimate {f.estimate:.3g}, decided {said}: {f.scene}")
    return int(bool(bad))


def main() -> int:
    parser = argparse.ArgumentParser(description=str(__doc__).partition("\n")[0])
    parser.add_argument("--fresh", metavar="COUNT", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--sections", action="store_true")
    given = parser.parse_args()
    if given.fresh:
        return fresh(given.fresh, given.seed, given.sections)
    draw: Any = make
    which: Any = names()
    path = FILE
    if given.sections:
        draw, which, path = section_references.row, section_references.KEPT, section_references.FILE
    rows = []
    with ProcessPoolExecutor() as pool:
        for row in pool.map(draw, which):
            rows.append(json.dumps(row))
            print(f"\r{len(rows)} of {len(which)} scenes", end="", file=sys.stderr, flush=True)
    temporary = path.with_suffix(".tmp")
    temporary.write_text("[\n" + ",\n".join(rows) + "\n]\n", encoding="utf-8")
    os.replace(temporary, path)
    return 0


if __name__ == "__main__":
    sys.exit(main())
