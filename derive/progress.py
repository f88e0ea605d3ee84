"""Progress of long tasks on stderr: a bar on a terminal with rich, otherwise occasional lines."""

import sys
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from importlib import import_module
from importlib.util import find_spec
from itertools import chain
from typing import TypeVar

T = TypeVar("T")
S = TypeVar("S")
FIRST = 5.0  # seconds until the first line; intervals then double


def say(line: str) -> None:
    """Print a line on stderr."""
    print(line, file=sys.stderr, flush=True)


def track(items: Iterable[T], task: str, total: int) -> Iterator[T]:
    """Yield the items while showing how many of the total are done; after a quarter also the time left."""
    if sys.stderr.isatty() and find_spec("rich"):
        console = import_module("rich.console").Console(stderr=True)
        bar = import_module("rich.progress").track
        yield from bar(items, task, total, console=console, transient=True)
        return
    start = time.monotonic()
    pause = FIRST
    for done, item in enumerate(items, 1):
        yield item
        elapsed = time.monotonic() - start
        if elapsed > pause and done < total:
            pause *= 2
            left = elapsed / done * (total - done)
            estimate = f", about {left:.0f} s left" if 4 * done > total else ""  # the first ones may take longest
            say(f"{task}: {done} of {total}{estimate}")


def parallel(function: Callable[[S], T], groups: Sequence[Sequence[S]], task: str) -> Iterator[T]:
    """Yield the results for all items of groups in order: of several groups from two processes, otherwise from here."""
    each = partial(_results, function)
    if len(groups) < 2:
        yield from chain.from_iterable(map(each, groups))
        return
    with ProcessPoolExecutor(2) as pool:
        yield from chain.from_iterable(track(pool.map(each, groups), task, len(groups)))


def _results(function: Callable[[S], T], items: Iterable[S]) -> list[T]:
    return list(map(function, items))
