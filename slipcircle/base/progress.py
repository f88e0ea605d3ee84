"""Progress of long computations on stderr: a bar on a terminal with rich, otherwise a line now and then."""

import sys
import time
from collections.abc import Collection, Iterator
from importlib import import_module
from importlib.util import find_spec
from threading import Timer
from typing import IO, Any, ClassVar, Self, TypeVar

from slipcircle.base.text import clean

T = TypeVar("T")
_SOON = 1.0, 10.0  # s before the first output of `counted` as a bar, and as a line
_OFTEN, _SELDOM = 0.2, 2.0  # s between updates of a bar; between lines initially, doubled after each line


def is_terminal(stream: Any) -> bool:
    """Return whether an output stream is a terminal. Streams that are closed or that cannot tell are not."""
    return bool(getattr(stream, "isatty", bool)())


class Progress:
    """Progress report with the finished and the total number of items, the rate and the time left.

    Nested reports are silent.

    Parameters
    ----------
    total : int
    things : str
        Name of the items in the plural.
    stream : text stream, optional
        Output, by default stderr.
    """

    running: ClassVar[int] = 0
    is_shown: ClassVar[bool] = False

    def __init__(self, total: int, things: str, stream: IO[str] | None = None) -> None:
        self.total, self.things, self.stream = total, things, stream or sys.stderr
        self.done = self.kept = 0
        self.start = self.shown = time.monotonic()
        self.has_bar = is_terminal(self.stream) and find_spec("rich") is not None
        self.pause = _OFTEN if self.has_bar else _SELDOM
        self.bar: Any = None

    def __enter__(self) -> Self:
        """Start the display, unless another one is running."""
        Progress.running += 1
        self.is_silent = Progress.running > 1 or self.stream is None
        return self

    def __exit__(self, *_: object) -> None:
        """Remove the display."""
        Progress.running -= 1
        Progress.is_shown &= Progress.running > 0
        if self.bar is not None:
            self.bar.stop()

    def __call__(self, count: int = 1, kept: int = 0) -> None:
        """Add finished items to the count, ``kept`` of them from an earlier run."""
        self.done += count
        self.kept += kept
        now = time.monotonic()
        if self.is_silent or now - self.shown < self.pause:
            return
        self.shown = now
        Progress.is_shown = True
        if not self.has_bar:
            self.pause *= 2
            print(self.text(), file=self.stream, flush=True)
            return
        if self.bar is None:
            rich = import_module("rich.progress")
            console = import_module("rich.console").Console(file=self.stream)
            columns = rich.BarColumn(), rich.TextColumn("{task.description}", markup=False)
            bar = rich.Progress(*columns, console=console, auto_refresh=False, transient=True)
            bar.add_task("", total=self.total)
            bar.start()
            self.bar = bar  # which can be stopped now
        (task,) = self.bar.task_ids
        self.bar.update(task, completed=self.done, description=self.text(), refresh=True)

    def text(self) -> str:
        """Return the progress, the rate and the time left as text."""
        seconds = time.monotonic() - self.start
        rate = (self.done - self.kept) / max(seconds, 1e-9)
        if not rate:
            left = "all there already"
        elif self.done >= self.total:
            left = f"in {seconds:.3g} s"
        else:
            left = f"{(self.total - self.done) / rate:.0f} s left"
        kept = f", {self.kept} from before" if self.kept else ""
        return f"{self.done} of {self.total} {self.things}{kept}, {rate:.3g} a second, {left}"


def counted(total: int, things: str) -> Progress:
    """Return a progress report that stays silent if the work finishes soon.

    ``total`` is the number of items, and ``things`` names them in the plural.
    """
    progress = Progress(total, things)
    progress.shown += _SOON[not progress.has_bar]
    return progress


def tracked(items: Collection[T], things: str) -> Iterator[T]:
    """Yield the items and report progress. ``things`` names them in the plural. A single item reports its own parts."""
    if len(items) < 2:
        yield from items
        return
    with counted(len(items), things) as progress:
        for item in items:
            yield item
            progress()


def announce(message: str, before: str = "") -> None:
    """Print a message on stderr, if it is open; each line begins with the name of the program.

    ``before`` is printed ahead of the name.
    """
    for text in message.splitlines() if sys.stderr else ():
        print(f"{before}slipcircle: {clean(text)}", file=sys.stderr, flush=True)


def say_later(seconds: float) -> Timer:
    """Start a timer that announces a computation without progress report after some seconds.

    The caller may cancel the returned timer.
    """
    timer = Timer(seconds, _say_computing)
    timer.daemon = True
    timer.start()
    return timer


def _say_computing() -> None:
    """Announce that a computation runs, unless a progress report is shown."""
    if not Progress.is_shown:
        announce("computing; Ctrl-C stops it")
