"""Scenes that nobody has seen, against their motion to 20 and 30 digits: is the estimate at or above the true error?

    python tests/fresh_references.py [COUNT] [--seed N] [--sections]

draws COUNT scenes of every kind that `references` and `time_references` know, three in four of the former, or those of
`section_references` on random grounds, solves each there and here, and prints by kind the worst error and the least
estimate over error. The exit status is 1 if an estimate is below its error, or a decision other than the reference's.
"""

import argparse
import sys
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from typing import Any, NamedTuple

import references
import section_references
import test_accuracy
import test_time_scenes
import time_references

import slipcircle


class Found(NamedTuple):
    """Of one scene: its kind, whether it was decided alike, the true error and its estimate, and the scene."""

    group: str
    alike: bool
    error: float
    estimate: float
    scene: Any


def asked(count: int, sections: bool) -> Iterator[tuple[bool, Any]]:
    """Whether a scene is one of time, and its name: the kinds by turns, in numbers beyond those of the files."""
    for k in range(count):
        if sections:
            yield True, k
            continue
        of_time = k % 4 == 3
        groups = time_references.GROUPS if of_time else references.GROUPS
        which = k // 4 if of_time else k - k // 4
        yield of_time, (list(groups)[which % len(groups)], which // len(groups))


def judged(which: tuple[bool, Any, int]) -> Found:
    """A scene drawn, and solved both ways."""
    of_time, name, seed = which
    references.SEED = time_references.SEED = section_references.SEED = seed
    of_section = isinstance(name, int)
    row = (section_references if of_section else time_references).row(name) if of_time else references.make(name)
    kept = row["reference"]
    built = (section_references if of_section else test_time_scenes).scene
    scene = built(row["scene"]) if of_time else test_accuracy.scene(row)
    motion = slipcircle.solve(scene)
    error = test_time_scenes.true_error(motion, kept) if of_time else max(test_accuracy.true_error(motion, kept))
    alike = (motion.moves, motion.arrested) == (kept["moves"], kept["arrested"])
    return Found(row["group"], alike, error, float(motion.error_estimate), row["scene"])


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("count", nargs="?", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--sections", action="store_true")
    given = parser.parse_args()
    found = list[Found]()
    with ProcessPoolExecutor(2) as pool:
        for one in pool.map(
            judged, [(*which, given.seed) for which in asked(given.count, given.sections)], chunksize=4
        ):
            found.append(one)
            print(f"\r{len(found)} of {given.count}", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    print(f"{'kind':22} scenes  worst error  least estimate/error")
    for group in dict.fromkeys(f.group for f in found):
        own = [f for f in found if f.group == group]
        least = min((f.estimate / f.error for f in own if f.error), default=float("inf"))
        print(f"{group:22} {len(own):6}  {max(f.error for f in own):11.2g}  {least:20.3g}")
    bad = [f for f in found if not f.alike or f.estimate < f.error]
    for f in bad:
        said = "alike" if f.alike else "otherwise"
        print(f"{f.group}: error {f.error:.3g}, estimate {f.estimate:.3g}, decided {said}: {f.scene}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
