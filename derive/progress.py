"""How much of a long task is done, on stderr: a bar on a terminal with rich, else lines now and then."""

import sys
import time
from collections.abc import Iterable, Iterator
from importlib import import_module
from importlib.util import find_spec
from typing import TypeVar

T = TypeVar("T")
FIRST = 5.0  # seconds until the first line; the next come ever more rarely


def say(line: str) -> None:
    """A line on stderr."""
    print(line, file=sys.stderr, flush=True)


def track(items: Iterable[T], task: str, total: int) -> Iterator[T]:
    """The items, while the progress of the task is shown: how many of the total are done, and the time left."""
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
        left = elapsed / done * (total - done)
        if elapsed > pause and left > 1.0:
            pause *= 2
            say(f"{task}: {done} of {total}, about {left:.0f} s left")
