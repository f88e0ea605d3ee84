"""Where blocks are computed: here, in threads, in processes or on a Dask cluster; and what keeps them.

Blocks may finish in any order and are handed on by their index, so that every engine gives the same bits on machines of
one class. With a folder each is kept when it is finished, under its name only when it is whole on the disk, and a
later run with the same folder computes what is missing.

On many machines, with s seconds a block and worker, w workers, and the scheduler and this process taking c seconds a
block one after the other (sending it off, taking its result back and adding it up), b blocks take about
``max(b s / w, b c)``: more workers than s/c gain nothing, see `forecast`. Larger blocks move that limit up.
Dask's workers want MALLOC_TRIM_THRESHOLD_=268435456 in their environment: with Dask's own 65536 a block's temporaries
are given back to the system and faulted in again, which takes half as long again or more.
"""

import json
import logging
import os
import signal
import sys
import time
import zipfile
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Executor, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from pathlib import Path
from threading import Event
from typing import IO, Any

import numpy as np

from slipcircle.workbench.common.files import replacing, write
from slipcircle.workbench.studies.design import Design, Result, run_block

ENGINES = ("serial", "threads", "processes", "dask")
_PRESSED = Event()  # Ctrl-C, while Dask computes
_AHEAD = 512  # blocks that may be under way beyond the first unfinished one: more than a cluster's workers


def forecast(blocks: int, seconds: float, overhead: float, workers: int) -> float:
    """Seconds that blocks take on workers: seconds a block each, and overhead a block that nobody shares.

    Examples
    --------
    A regional study of 1e9 scenes in blocks of 2**18, 0.16 s each at 0.6 microseconds a scene, with 3 ms for each that
    nobody shares (`python tests/scale_ensemble.py` measures both): from about 50 workers on that is what it takes.

    >>> [round(forecast(3815, 0.16, 0.003, workers)) for workers in (1, 10, 50, 100)]
    [610, 61, 12, 11]
    """
    return max(-(-blocks // workers) * seconds, blocks * overhead)


@contextmanager
def engine(name: str, workers: int | None = None, scheduler: str | None = None) -> Iterator[Executor | None]:
    """An executor by the engine's name, one of `ENGINES`; none for "serial".

    With so many workers, by default one for each processor, or those of the Dask scheduler at an address, such as
    tcp://10.0.0.1:8786.
    """
    if workers is not None and workers < 1:
        raise ValueError(f"--workers {workers}: must be 1 at least; leave it out for one for each processor")
    workers = workers or os.cpu_count() or 1
    if (name == "dask") != (scheduler is not None):
        raise ValueError("--engine dask and --scheduler ADDRESS belong together: the address of a running scheduler")
    if name == "threads":
        with _stopping(ThreadPoolExecutor(workers)) as pool:
            yield pool
    elif name == "processes":
        from concurrent.futures import ProcessPoolExecutor  # only here, as it loads much
        from multiprocessing import get_context

        deaf = signal.SIGINT, signal.SIG_IGN
        with _stopping(ProcessPoolExecutor(workers, get_context("spawn"), signal.signal, deaf)) as pool:
            with _uninterrupted():  # workers inherit it: this process ends them, and they print no traceback
                for _ in range(workers):
                    pool.submit(int)
            yield pool
    elif name == "dask":
        try:
            from distributed import Client
        except ImportError as error:
            raise ImportError("--engine dask needs Dask: pip install 'slipcircle[dask]'") from error
        try:
            client = Client(scheduler, timeout="10s")
        except OSError as error:
            raise ValueError(f"--scheduler {scheduler}: no Dask scheduler answers there: {error}") from error
        cluster = client.get_executor()
        log = logging.getLogger("tornado.application")  # would print a traceback for a future that is cancelled
        with _heeding():
            try:
                yield cluster
            finally:
                log.disabled = True
                cluster.shutdown(wait=False)  # one message for all that are left; future by future takes seconds
                client.close()
                log.disabled = False
    else:
        yield None


@contextmanager
def _stopping(pool: Executor) -> Iterator[Executor]:
    """A pool that waits for no block when it is interrupted: processes are ended, threads go with this one."""
    try:
        yield pool
    except BaseException:
        from multiprocessing import active_children

        ended = active_children()
        for child in ended:
            child.terminate()
        pool.shutdown(wait=bool(ended), cancel_futures=True)
        raise
    pool.shutdown(cancel_futures=True)


@contextmanager
def _uninterrupted() -> Iterator[None]:
    """Without Ctrl-C, where signals can be held back."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


@contextmanager
def _heeding() -> Iterator[None]:
    """A Ctrl-C that `_first` raises: raised at once inside one of Dask's own callbacks it would be swallowed there."""
    try:
        before = signal.signal(signal.SIGINT, lambda *_: _PRESSED.set())
    except ValueError:  # outside the main thread, which alone hears signals
        yield
        return
    try:
        yield
    finally:
        _PRESSED.clear()
        signal.signal(signal.SIGINT, before)


def _first(running: Iterable[Future[Result]]) -> set[Future[Result]]:
    """Those that are done, when there are some."""
    while True:
        done = wait(running, timeout=0.1, return_when=FIRST_COMPLETED).done
        if _PRESSED.is_set():
            raise KeyboardInterrupt
        if done:
            return done


class Folder:
    """Finished blocks on the disk, for one study, seed and size."""

    def __init__(self, path: str | os.PathLike[str], description: dict[str, Any]) -> None:
        self.path = Path(path)
        try:
            self.path.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise ValueError(f"{self.path}: can be no folder for blocks: {error.strerror}") from error
        held = stored(self.path)
        if held is None:
            write(self.path / "study.json", json.dumps(description, indent=2).encode())
        elif other := [k for k in description | held if description.get(k) != held.get(k)]:
            raise ValueError(
                f"{self.path}: holds blocks of another study: {', '.join(other)} differ; give an empty folder"
            )

    def _file(self, index: int) -> Path:
        return self.path / f"block-{index:08d}.npz"

    def load(self, index: int) -> Result | None:
        """A finished block; none if it is not there, or was damaged since."""
        try:
            with open(self._file(index), "rb") as whole, np.load(whole, allow_pickle=False) as file:
                return {k: file[k] for k in file.files}
        except (OSError, ValueError, EOFError, zipfile.BadZipFile):
            return None

    def save(self, index: int, result: Result) -> None:
        """Keep a finished block."""
        with replacing(self._file(index)) as file:
            np.savez(file, **result)  # type: ignore[arg-type]


def stored(folder: str | os.PathLike[str]) -> dict[str, Any] | None:
    """The description of the study whose blocks a folder holds."""
    path = Path(folder) / "study.json"
    if not path.exists():
        return None
    try:
        found = json.loads(path.read_text("utf-8"))
    except ValueError as error:
        raise ValueError(f"{path}: is damaged: {error}; give an empty folder") from error
    if not isinstance(found, dict):
        raise ValueError(f"{path}: is no study; give an empty folder")
    return found


def computed(
    design: Design,
    executor: Executor | None = None,
    folder: Folder | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> Iterator[Result]:
    """Results of all blocks of a design, in their order; `Progress` hears of each that is finished."""
    blocks, ahead, begun = design.blocks, _AHEAD if executor else 1, 0
    finished: dict[int, Result] = {}
    running: dict[Future[Result], int] = {}

    def done(index: int, result: Result, fresh: bool = True) -> None:
        finished[index] = result
        if folder and fresh:
            folder.save(index, result)
        if progress:
            scenes = design.scenes(index)
            progress(scenes, 0 if fresh else scenes)

    try:
        for index in range(blocks):
            until = min(index + ahead, blocks)
            for k in range(begun, until):
                kept = folder.load(k) if folder else None
                if kept is not None:
                    done(k, kept, fresh=False)
                elif executor:
                    running[executor.submit(run_block, design, k)] = k
                else:
                    done(k, run_block(design, k))
            begun = until
            while index not in finished:
                for future in _first(running):
                    done(running.pop(future), future.result())
            yield finished.pop(index)
    finally:
        for future in running:  # what was finished meanwhile is kept as well
            if folder and future.done() and not future.cancelled() and future.exception() is None:
                folder.save(running[future], future.result())


class Progress:
    """Scenes solved, the rate and the time left, on a stream: one line on a terminal, else one every ten seconds."""

    def __init__(self, scenes: int, stream: IO[str] = sys.stderr) -> None:
        self.scenes, self.stream = scenes, stream
        self.done = self.kept = 0
        self.began = self.said = time.monotonic()

    def __call__(self, scenes: int, kept: int) -> None:
        self.done, self.kept = self.done + scenes, self.kept + kept
        now, terminal = time.monotonic(), self.stream.isatty()
        if self.done < self.scenes and now - self.said < (0.2 if terminal else 10.0):
            return
        self.said = now
        rate = (self.done - self.kept) / max(now - self.began, 1e-9)
        left = f"{(self.scenes - self.done) / rate:.0f} s left" if rate else "all there already"
        if rate and self.done >= self.scenes:
            left = f"in {now - self.began:.3g} s"
        kept_too = f", {self.kept} from before" if self.kept else ""
        text = f"{self.done} of {self.scenes} scenes{kept_too}, {rate:.3g} a second, {left}"
        end = "\n" if self.done >= self.scenes or not terminal else ""
        print(("\r\x1b[K" if terminal else "") + text, end=end, file=self.stream, flush=True)
