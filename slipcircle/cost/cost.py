"""What accuracy costs in time: each way to compute a function, its proved and its worst seen error, its time, here.

Ratios within one run mean something; absolute times belong to the machine that the report names. All ways to compute
one function are timed in turns, so that what disturbs the machine disturbs all alike.
"""

import time
import tracemalloc
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from statistics import median
from typing import TextIO

import numpy as np

from slipcircle.cost import scenes, sections
from slipcircle.cost.reference import Floats, Reference
from slipcircle.cost.ways import FLOOR, FUNCTIONS, Subject, Way, multiprecision

SIZES = (1, 10_000, 1_000_000)  # a call, an array that stays in cache, one that does not
BEATEN = 1.2  # a way is beaten by one at least as accurate and more than this many times faster
REPEATS = 9
_TICK, _PATIENCE = 5e-4, 0.08  # seconds: shortest thing timed, all repeats of one
_LONG = 1.0  # seconds of a pass, above which one is enough
_QUICK = 0.02  # seconds for scenes, after which ten times as many are not asked for
FRONTIER, LOST = "frontier", "beaten: "
SUBJECTS = {**FUNCTIONS, sections.NAME: sections.subject}
NAMES = [*SUBJECTS, *scenes.CASES]
GROUPS = {"kernels": [*FUNCTIONS], "flow": [*scenes.CASES]}


@dataclass(frozen=True)
class Profile:
    """Errors of a way over its inputs."""

    points: Floats
    ulp: Floats  # signed
    relative: Floats


@dataclass(frozen=True)
class Row:
    """One way to compute one function.

    Attributes
    ----------
    bound, bound_ulp
        Proved bounds of the relative error and of the error in ulp of `kind`; None: sampled only.
    error, ulp
        The worst seen, on so many `points`; NaN for the floor, which computes nothing.
    worst_input, worst_input_ulp
        Where.
    ns_1, ns_1e4, ns_1e6
        Time of an element, ns, with N elements in a call: the median of several turns.
    elements
        How many elements the last of them was measured on; fewer than N for slow ways.
    memory
        Most that a call on so many took beside its arguments, bytes of Python and NumPy; None: not measured.
    verdict
        "frontier"; "beaten: " and by which way; "no digit" where returning 0 is as accurate.
    """

    function: str
    way: str
    error: float
    worst_input: tuple[float, ...]
    ns_1: float
    ns_1e4: float | None = None
    ns_1e6: float | None = None
    elements: int = 1
    bound: float | None = None
    bound_ulp: float | None = None
    ulp: float | None = None
    worst_input_ulp: tuple[float, ...] = ()
    points: int = 1
    kind: str = "float64"
    memory: int | None = None
    ours: bool = False
    verdict: str = ""
    profile: Profile | None = field(default=None, repr=False, compare=False)

    @property
    def price(self) -> float:
        """The time that verdicts compare, ns: in an array that stays in cache, or of one call."""
        return self.ns_1 if self.ns_1e4 is None else self.ns_1e4


def measure(names: Sequence[str], progress: TextIO | None = None) -> list[Row]:
    """Measure every way to compute the named functions.

    Parameters
    ----------
    names : sequence of str
        Keys of `ways.FUNCTIONS` or `scenes.CASES`, or a group of them.
    progress : text file, optional
        Where to say what is being measured.

    Raises
    ------
    ValueError
        For an unknown function.
    ImportError
        Without mpmath and python-flint, which give the reference.
    """
    names = [name for given in names for name in GROUPS.get(given, [given])]
    unknown = [n for n in names if n not in NAMES]
    if unknown:
        raise ValueError(f"function {unknown[0]!r} is unknown; known are {', '.join([*GROUPS, *NAMES])}")
    multiprecision(30)
    found = []
    for name in names:
        if progress:
            print(f"measuring {name}", file=progress, flush=True)
        if name in scenes.CASES:
            found += [row for many in (False, True) for row in judged(_scenes(name, many, progress))]
        else:
            found += judged(_functions(name, SUBJECTS[name]()))
    return found


def _functions(name: str, subject: Subject) -> list[Row]:
    rows = []
    for way, times in zip(subject.ways, _times(subject), strict=True):
        one, many, most = (ns for ns, _ in times)
        count = times[-1][1]
        memory = _peak(_work(way, subject.bulk(count), count)) if subject.weighed else None
        row = Row(name, way.name, float("nan"), (), one, many, most, count, way.bound, way.bound_ulp,
                  kind=way.kind, memory=memory, ours=way.ours)  # fmt: skip
        rows.append(row if way.name == FLOOR else _seen(row, way, subject.reference(way.kind)))
    return rows


def _scenes(name: str, many: bool, progress: TextIO | None) -> list[Row]:
    """Rows of one scene, or of ten thousand."""
    count = SIZES[1] if many else 1
    some, near, rest = scenes.exactly(name, many)
    found = scenes.ways(name, many, progress)
    counts = [count if way.startswith("slipcircle") else _enough(call, count) for way, call in found.items()]
    works = [partial(way, scenes.frictions(n)) for way, n in zip(found.values(), counts, strict=True)]
    rows = []
    for (way, call), n, seconds in zip(found.items(), counts, interleaved(works), strict=True):
        error = float(np.nanmax(np.abs((call(some) - near) - rest) / near))
        took = median(seconds) / n * 1e9
        ours = way.startswith("slipcircle")
        rows.append(Row(
            f"{name}, {count} scenes" if many else name, way, error, (), took, took if many else None, elements=n,
            points=some.size, ours=ours,
        ))  # fmt: skip
    return rows


def _enough(way: Callable[[Floats], Floats], most: int) -> int:
    """How many scenes a pass has time for: ten times as many, while that is quick."""
    count = min(10, most)
    way(scenes.frictions(count))  # what is imported at first only shall not pass for long work
    while count < most and _timed(partial(way, scenes.frictions(count)), 1) < _QUICK:
        count = min(10 * count, most)
    return count


# --- errors --------------------------------------------------------------------------------------------------------


def _seen(row: Row, way: Way, exact: Reference) -> Row:
    """The row with the worst errors of its way."""
    ulp, relative = exact.errors(way.function(*exact.points.astype(way.kind)))
    at, at_ulp = int(np.argmax(relative)), int(np.argmax(np.abs(ulp)))
    points = exact.points.T
    return replace(
        row, error=float(relative[at]), ulp=float(abs(ulp[at_ulp])), points=len(points),
        worst_input=tuple(points[at].tolist()), worst_input_ulp=tuple(points[at_ulp].tolist()),
        profile=Profile(exact.points[0], ulp, relative),
    )  # fmt: skip


# --- times ---------------------------------------------------------------------------------------------------------


def _times(subject: Subject) -> list[list[tuple[float, int]]]:
    """For each way and each of `SIZES`: ns an element, and on how many elements."""
    found: list[list[tuple[float, int]]] = [[] for _ in subject.ways]
    for size in SIZES:
        arguments = subject.bulk(size)
        counts = [_fitting(size, sofar, subject.longest) for sofar in found]
        works = [_work(w, arguments, n) for w, n in zip(subject.ways, counts, strict=True)]
        for sofar, count, seconds in zip(found, counts, interleaved(works), strict=True):
            sofar.append((median(seconds) / count * 1e9, count))
    return found


def _fitting(size: int, sofar: list[tuple[float, int]], longest: float) -> int:
    """How many elements a pass has time for, in seconds."""
    while sofar and size > SIZES[1] and size * sofar[-1][0] * 1e-9 > longest:
        size //= 10
    return size


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
        return partial(way.function, *(numbers if way.kind == "float64" else map(np.dtype(way.kind).type, numbers)))
    rows = arguments[:, :count].astype(way.kind, copy=False)
    return partial(way.into, *rows, np.empty_like(rows[0])) if way.into else partial(way.function, *rows)


def interleaved(works: Sequence[Callable[[], object]]) -> list[list[float]]:
    """Seconds that each piece of work took, several times, all of them in turns."""
    # glibc gives the heap's top back to the system, and faults every page again, until a large array came and went:
    # NumPy's expressions take up to three times longer before. Most programs are past that, so this one shall be.
    np.ones(4_000_000)
    plans = []
    for work in works:
        took = _timed(work, 1)
        if took < _LONG:
            took = _timed(work, 1)
        if took < _PATIENCE:  # what is slow at first only shall not pass for long work
            took = min(took, _timed(work, 1), _timed(work, 1))
        loops = max(1, int(_TICK / took))
        plans.append((loops, min(REPEATS, max(3 if took < _LONG else 1, int(_PATIENCE / (took * loops))))))
    samples: list[list[float]] = [[] for _ in works]
    for turn in range(REPEATS):
        for work, (loops, repeats), sample in zip(works, plans, samples, strict=True):
            if turn < repeats:
                if loops > 1:  # short work finds the caches as the one before left them
                    work()
                sample.append(_timed(work, loops))
    return samples


def _timed(work: Callable[[], object], loops: int) -> float:
    start = time.process_time()  # of the processor: what else it does in the meantime is not ours
    for _ in range(loops):
        work()
    return max((time.process_time() - start) / loops, 1e-9)


# --- verdicts ------------------------------------------------------------------------------------------------------


def judged(rows: Sequence[Row]) -> list[Row]:
    """Mark the frontier: a way that another beats in time by more than `BEATEN` at no larger error names the winner."""
    found = []
    for row in rows:
        better = [r for r in rows if r.error <= row.error and r.price * BEATEN < row.price]
        best = min(better, key=lambda r: r.price, default=None)
        if row.error != row.error:
            said = "floor"
        elif row.error >= 1:
            said = "no digit"
        else:
            said = LOST + best.way if best else FRONTIER
        found.append(replace(row, verdict=said))
    return found
