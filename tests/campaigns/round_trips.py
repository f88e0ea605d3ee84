"""Back-analysis of each number of each shipped scene from the motion that it gives.

``python -m tests.campaigns.round_trips`` solves a scene, observes its run-out, peak velocity and duration, and has
`backanalyse` find each number of the scene from each of these alone, without the number's present value. It ends with
status 1 unless one of the solutions is the number to 1e-6. A number that does not affect what is observed, and a number
that is 0, which the ranges of back-analysis need not contain, is counted instead. ``--scenes A B`` takes some scenes
only.
"""

import argparse
import sys
from collections import Counter
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

from slipcircle import Scene, backanalyse, load, parameters, solve
from slipcircle.workbench.files.shipped import shipped

OBSERVED = ("run_out", "peak_velocity", "duration")
CLOSE = 1e-6  # relative to the number
KNOWN = ("found", "without effect", "is 0")


def outcome(scene: Scene, name: str, observed: str, value: float) -> str:
    """Return "found", "without effect", or how the number differs."""
    number = parameters(scene)[name].value
    try:
        asked: dict[str, Any] = {observed: value}
        solutions = backanalyse(scene, field=name, **asked).solutions
    except ValueError as error:
        return "without effect" if "does not affect" in str(error) else f"{type(error).__name__}: {error}"
    nearest = min((abs(solution.values[name] / number - 1.0) for solution in solutions), default=np.inf)
    return "found" if nearest <= CLOSE else f"the nearest of {len(solutions)} differs by {nearest:.1e}"


def round_trips(names: Iterable[str]) -> Iterator[tuple[str, str, str, str]]:
    """Yield each scene, number and observation with their outcome."""
    for scene_name in names:
        scene = load(scene_name)
        motion = solve(scene)
        if not motion.moves:
            continue
        for name, number in parameters(scene).items():
            for observed in OBSERVED:
                how = outcome(scene, name, observed, float(motion.outcomes[observed])) if number.value else "is 0"
                yield scene_name, name, observed, how


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--scenes", nargs="+", default=shipped(), metavar="NAME")
    counts = Counter[str]()
    for scene, number, observed, how in round_trips(parser.parse_args().scenes):
        is_known = how in KNOWN
        counts[how if is_known else "not found"] += 1
        if not is_known:
            print(f"{scene}: {number} from {observed}: {how}", flush=True)
    print(", ".join(f"{count} {how}" for how, count in counts.items()))
    return 1 if counts["not found"] else 0


if __name__ == "__main__":
    sys.exit(main())
