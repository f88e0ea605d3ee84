"""Alternative ways to compute the same result: error and time of each, measured here, and a verdict.

Ratios within one run are meaningful; absolute times belong to the machine that the output names.
"""

import math
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from statistics import median
from timeit import timeit

import numpy as np

ULP = 2.0**-52  # relative errors that differ by at most this are equal
MARGIN = 1.2  # times and errors whose ratio is smaller are equal
REPEATS = 9
FRONTIER = "frontier"
RECOMMENDED = "recommended"
BEATEN = "beaten by "
_TICK = 5e-4  # s, shortest timed work
_PATIENCE = 2.0  # s, after which the turns end


@dataclass(frozen=True)
class CostRow:
    """Error and time of one way to compute a result.

    Attributes
    ----------
    group, way : str
        Name of the result, and of the method.
    count : int
        Number of elements or scenes that were computed at once.
    error : float
        Largest observed relative error.
    bound : float or None
        Proved or estimated bound of the error.
    seconds : float
        Processor time of one element or scene, the median of several turns.
    verdict : str
        "frontier", "recommended", or "beaten by " and the name of the way that is better in one respect and at least
        equal in the other.
    accuracy : float or None
        Required relative error.
    """

    group: str
    way: str
    count: int
    error: float
    bound: float | None
    seconds: float
    verdict: str = ""
    accuracy: float | None = None

    @property
    def misses(self) -> bool:
        """Whether the error is above the required accuracy, or above a proved bound."""
        return self.accuracy is not None and not self.error <= self.accuracy


def interleaved(works: Sequence[Callable[[], object]]) -> list[list[float]]:
    """Return the processor seconds of one call of each piece of work, measured up to 9 times.

    All pieces run in turns, so that disturbances affect them alike.
    """
    # Until a large array has been allocated and freed, glibc returns the top of the heap to the system and faults its
    # pages again, and NumPy expressions take up to three times longer. Most programs are past that state.
    np.ones(4_000_000)
    loops = []
    for work in works:
        work()  # a slow first run shall not be taken for long work
        count = 1
        while count * _timed(work, count) < _TICK:  # a coarse clock may measure 0 for one loop
            count *= 2
        loops.append(count)
    samples: list[list[float]] = [[] for _ in works]
    start = time.monotonic()
    for turn in range(REPEATS):
        if turn and time.monotonic() - start > _PATIENCE:
            break
        for work, count, sample in zip(works, loops, samples, strict=True):
            if count > 1:  # the preceding work has changed the caches
                work()
            sample.append(_timed(work, count))
    return samples


def medians(works: Sequence[Callable[[], object]]) -> list[float]:
    """Return the median processor seconds of one call of each piece of work."""
    return [median(sample) for sample in interleaved(works)]


def _timed(work: Callable[[], object], loops: int) -> float:
    """Return the mean processor seconds of one call of ``work`` over a number of loops."""
    return max(timeit(work, timer=time.process_time, number=loops) / loops, 1e-9)


def with_verdicts(rows: Iterable[CostRow]) -> list[CostRow]:
    """Return the rows of a group with verdicts: beaten by the fastest of the better ways, or on the frontier."""
    rows = list(rows)
    judged_rows = []
    for row in rows:
        better = [other for other in rows if _beats(other, row)]
        verdict = FRONTIER
        if better:
            verdict = BEATEN + min(better, key=lambda other: other.seconds).way
        judged_rows.append(replace(row, verdict=verdict))
    return judged_rows


def _beats(one: CostRow, other: CostRow) -> bool:
    """Return whether row ``one`` is faster or more accurate than ``other`` by more than a tie, and else not worse."""
    if one.seconds > other.seconds or one.error > other.error + ULP:
        return False
    return one.seconds * MARGIN < other.seconds or one.error * MARGIN + ULP < other.error


def recommended(rows: Sequence[CostRow], accuracy: float | None = None, budget: float | None = None) -> list[CostRow]:
    """Return the rows with the recommended way marked, if there is one.

    This is the most accurate way within a ``budget`` in s; without a budget, the fastest way whose error and bound are
    at most ``accuracy``.
    """
    if budget is not None:
        meeting = [row for row in rows if row.seconds <= budget]
        best = min(meeting, key=lambda row: (row.error, row.seconds), default=None)
    else:
        required = accuracy or 0.0
        meeting = [row for row in rows if max(row.error, row.bound or 0.0) <= required]
        best = min(meeting, key=lambda row: row.seconds, default=None)
    marked = list(rows)
    if best is not None:
        marked[marked.index(best)] = replace(best, verdict=RECOMMENDED)
    return marked


def price_of_a_digit(rows: Sequence[CostRow]) -> float:
    """Return the factor in time for one more digit, between least and most accurate way; NaN if undefined."""
    finite = [row for row in rows if 0.0 < row.error < 1.0]
    if len(finite) < 2:
        return math.nan
    least = max(finite, key=lambda row: row.error)
    most = min(finite, key=lambda row: row.error)
    digits = math.log10(least.error / most.error)
    if digits < 1.0:
        return math.nan
    return (most.seconds / least.seconds) ** (1.0 / digits)
