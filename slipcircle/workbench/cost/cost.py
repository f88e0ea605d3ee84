"""What accuracy costs in time: each way to compute a function, its proved and its worst seen error, its time, here.

Ratios within one run mean something; absolute times belong to the machine that the report names. All ways to compute
one function are timed in turns, so that what disturbs the machine disturbs all alike.
"""

import math
import time
import tracemalloc
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from importlib.util import find_spec
from statistics import median
from timeit import timeit
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.base.progress import track
from slipcircle.workbench.cost import scenes, sections
from slipcircle.workbench.cost.ways import FLOOR, FUNCTIONS, Subject, Way

SIZES = (1, 10_000, 1_000_000)  # a call, an array that stays in cache, one that does not
TIMES = ("ns_1", "ns_1e4", "ns_1e6")  # of a `Row`, of these sizes
BEATEN = 1.2  # a way is beaten by one at least as accurate and more than this many times faster
REPEATS = 9
_TICK = 5e-4  # s, the shortest work that is timed
_PATIENCE = 0.08  # s, all repeats of one
_PASS = 0.1  # s that a pass may take, as a rule
_LONG = 1.0  # s above which one pass is enough
FRONTIER = "frontier"
LOST = "beaten: "
SUBJECTS: dict[str, Sequence[Callable[[], Subject]]] = {
    **{name: [made] for name, made in FUNCTIONS.items()},
    "sections": [sections.subject],
    **{name: [partial(scenes.subject, name, many) for many in (False, True)] for name in scenes.CASES},
}
NAMES = [*SUBJECTS]
GROUPS = {"kernels": [*FUNCTIONS], "flow": [*scenes.CASES]}


class Profile(NamedTuple):
    """Errors of a way over its inputs."""

    points: Floats
    ulp: Floats  # signed
    relative: Floats


@dataclass(frozen=True)
class Row:
    """One way to compute one function."""

    function: str
    way: str
    error: float  # the worst relative one seen, on so many `points`; NaN for the floor, which computes nothing
    worst_input: tuple[float, ...]  # where
    ns_1: float | None = None  # of an element, with N elements in a call: the median of several turns
    ns_1e4: float | None = None
    ns_1e6: float | None = None
    elements: int = 1  # how many the last of them was measured on; fewer than N for slow ways
    bound: float | None = None  # proved, of the relative error; None: sampled only
    bound_ulp: float | None = None  # proved, of the error in ulp of `kind`
    ulp: float | None = None  # the worst seen
    worst_input_ulp: tuple[float, ...] = ()
    points: int = 1
    kind: str = "float64"
    memory: int | None = None  # most that a call on so many took beside its arguments, bytes of Python and NumPy
    ours: bool = False
    verdict: str = ""  # "frontier"; "beaten: " and by which way; "no digit" where returning 0 is as accurate
    profile: Profile | None = field(default=None, repr=False, compare=False)

    @property
    def price(self) -> float:
        """The time that verdicts compare, ns: in an array that stays in cache, or of one call."""
        return float(self.ns_1e4 or self.ns_1 or "nan")


def measure(names: Sequence[str], report: Callable[[str], object] = lambda message: None) -> list[Row]:
    """Measure every way to compute the functions, keys of `SUBJECTS` or a group of them; report what is missing."""
    names = [name for group in names for name in GROUPS.get(group, [group])]
    unknown = [name for name in names if name not in NAMES]
    if unknown:
        known = ", ".join([*GROUPS, *NAMES])
        raise ValueError(f"function {unknown[0]!r} is unknown; known are {known}")
    if find_spec("flint") is None:
        raise ImportError("the reference needs python-flint: pip install 'slipcircle[derive]'")
    rows = []
    for name in track(names, "functions measured"):
        for make_subject in SUBJECTS[name]:
            rows += judged(measured(make_subject(), report))
    return rows


def measured(subject: Subject, report: Callable[[str], object] = lambda message: None) -> list[Row]:
    """Errors and times of all ways that are installed."""
    missing = [n for n in dict.fromkeys(way.needs for way in subject.ways) if n and find_spec(n) is None]
    for name in missing:
        report(f"{subject.name}: {name} is missing, and not included")
    ways = [way for way in subject.ways if way.needs not in missing]
    times: list[dict[str, Any]] = [{} for _ in ways]
    for k in subject.sizes:
        counts = [_fitting(way, subject, SIZES[k]) for way in ways]
        arguments = {n: subject.bulk(n) for n in counts}
        works = [_work(way, arguments[n], n) for way, n in zip(ways, counts, strict=True)]
        for row, work, n, seconds in zip(times, works, counts, interleaved(works), strict=True):
            row |= {"elements": n, TIMES[k]: median(seconds) / n * 1e9}
            if subject.weighed:
                row["memory"] = _peak(work)
    return [
        Row(
            subject.name,
            way.name,
            **row,
            **_seen(way, subject),
            bound=way.bound,
            bound_ulp=way.bound_ulp,
            kind=way.kind,
            ours=way.ours,
        )
        for way, row in zip(ways, times, strict=True)
    ]


def _seen(way: Way, subject: Subject) -> dict[str, Any]:
    """The worst errors of a way, and where."""
    if way.name == FLOOR:
        return {"error": float("nan"), "worst_input": ()}
    exact = subject.reference(way.kind)
    ulp, relative = exact.errors(way.function(*exact.points.astype(way.kind)))
    points = exact.points.T
    at = int(np.argmax(relative))
    seen = {"error": float(relative[at]), "worst_input": tuple(points[at].tolist()), "points": len(points)}
    if ulp is None:
        return seen
    at = int(np.argmax(np.abs(ulp)))
    return seen | {
        "ulp": float(abs(ulp[at])),
        "worst_input_ulp": tuple(points[at].tolist()),
        "profile": Profile(exact.points[0], ulp, relative),
    }


# --- times ---------------------------------------------------------------------------------------------------------


def _fitting(way: Way, subject: Subject, size: int) -> int:
    """How many elements a pass has time for: ten times as many, as long as that would take no longer."""
    count = min(10, size)
    _work(way, subject.bulk(count), count)()  # what is imported at first only shall not pass for long work
    while count < size and 10 * _timed(_work(way, subject.bulk(count), count), 1) < _PASS * subject.patience:
        count = min(10 * count, size)
    return count


def _peak(work: Callable[[], object]) -> int:
    """Bytes that work takes at most, of Python and NumPy."""
    tracemalloc.start()
    try:
        work()
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


def _work(way: Way, arguments: Floats, count: int) -> Callable[[], object]:
    """One pass over so many elements: a call on numbers, or on an array."""
    if count == 1:
        numbers = arguments[:, 0].tolist()
        if way.kind != "float64":
            numbers = list(map(np.dtype(way.kind).type, numbers))
        return partial(way.function, *numbers)
    rows = arguments[:, :count].astype(way.kind, copy=False)
    if way.into is None:
        return partial(way.function, *rows)
    result = np.empty_like(rows[0])
    return partial(way.into, *rows, result)


def interleaved(works: Sequence[Callable[[], object]]) -> list[list[float]]:
    """Seconds that each piece of work took, several times, all of them in turns."""
    # glibc gives the heap's top back to the system, and faults every page again, until a large array came and went:
    # NumPy's expressions take up to three times longer before. Most programs are past that, so this one shall be.
    np.ones(4_000_000)
    plans = []
    for work in works:
        took = _timed(work, 1)
        if took < _LONG:  # what is slow at first only shall not pass for long work
            took = min(_timed(work, 1), _timed(work, 1))
        loops = max(1, int(_TICK / took))
        least = 3 if took < _LONG else 1
        affordable = int(_PATIENCE / (took * loops))
        repeats = min(REPEATS, max(least, affordable))
        plans.append((loops, repeats))
    samples: list[list[float]] = [[] for _ in works]
    for turn in range(REPEATS):
        for work, (loops, repeats), sample in zip(works, plans, samples, strict=True):
            if turn < repeats:
                if loops > 1:  # short work finds the caches as the one before left them
                    work()
                sample.append(_timed(work, loops))
    return samples


def _timed(work: Callable[[], object], loops: int) -> float:
    """Seconds of the processor, a loop: what else it does in the meantime is not ours."""
    return max(timeit(work, timer=time.process_time, number=loops) / loops, 1e-9)


# --- verdicts ------------------------------------------------------------------------------------------------------


def judged(rows: Sequence[Row]) -> list[Row]:
    """Mark the frontier: a way that another beats in time by more than `BEATEN` at no larger error names the winner."""
    judged_rows = []
    for row in rows:
        better = [other for other in rows if other.error <= row.error and other.price * BEATEN < row.price]
        verdict = FRONTIER
        if math.isnan(row.error):
            verdict = "floor"
        elif row.error >= 1:
            verdict = "no digit"
        elif better:
            verdict = LOST + min(better, key=lambda other: other.price).way
        judged_rows.append(replace(row, verdict=verdict))
    return judged_rows
