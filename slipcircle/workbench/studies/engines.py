"""Where blocks are computed: in threads, on a Dask cluster, or by any executor; and the folder that keeps them.

Blocks may finish in any order and are handed on by their index, so that every executor gives the same bits on machines
of one class. With a folder each is kept when it is finished, under its name only when it is whole on the disk, and a
later run with the same folder computes what is missing.

On many machines, with s seconds a block and worker, w workers, and the scheduler and this process taking c seconds a
block one after the other (sending it off, taking its result back and adding it up), b blocks take about
``max(b s / w, b c)``: more workers than s/c gain nothing, see `forecast`. Larger blocks move that limit up.
Dask's workers want MALLOC_TRIM_THRESHOLD_=268435456 in their environment: with Dask's own 65536 a block's temporaries
are given back to the system and faulted in again, which takes half as long again or more.
"""

import hashlib
import json
import logging
import os
import signal
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from pathlib import Path
from threading import Event
from typing import Any, Protocol

import numpy as np

from slipcircle.base.optional import optional
from slipcircle.workbench.common.files import replacing, write
from slipcircle.workbench.studies.design import Result

ENGINES = ("threads", "dask")
_INTERRUPTED = Event()  # Ctrl-C, while Dask computes
_AHEAD = 512  # blocks that may be under way beyond the first unfinished one: more than a cluster's workers


def forecast(blocks: int, seconds: float, overhead: float, workers: int) -> float:
    """Seconds that blocks take on workers: seconds a block each, and overhead a block that nobody shares.

    Examples
    --------
    A regional study of 1e9 scenes in blocks of 2**18, 0.16 s each at 0.6 microseconds a scene, with 3 ms for each that
    nobody shares (`python -m tests.campaigns.scale_ensemble` measures both): from about 50 workers on that is what it
    takes.

    >>> [round(forecast(3815, 0.16, 0.003, workers)) for workers in (1, 10, 50, 100)]
    [610, 61, 12, 11]
    """
    return max(-(-blocks // workers) * seconds, blocks * overhead)


@contextmanager
def engine(name: str = "threads", workers: int | None = None, scheduler: str | None = None) -> Iterator[Executor]:
    """An executor by the engine's name, one of `ENGINES`, with so many workers: by default one for each processor.

    Dask's are those of a scheduler at an address, such as tcp://10.0.0.1:8786; without one, processes on this machine.
    """
    if workers is not None and workers < 1:
        raise ValueError(f"--workers {workers}: must be 1 at least; leave it out for one for each processor")
    if scheduler is not None and (name != "dask" or workers is not None):
        raise ValueError("--scheduler: is of --engine dask, and has its own workers: leave out --workers")
    workers = workers or os.cpu_count() or 1
    if name == "dask":
        client = _dask_client(workers, scheduler)
        executor = client.get_executor()
        # They would print tracebacks for futures that are cancelled, and for messages to a client that has gone.
        logs = [logging.getLogger(name) for name in ("tornado.application", "distributed.scheduler")]
        with _deferred_interrupt():
            try:
                yield executor
            finally:
                for log in logs:
                    log.disabled = True
                executor.shutdown(wait=False)  # one message for all that are left; future by future takes seconds
                client.close()
                if client.cluster is not None:
                    client.cluster.close()
                for log in logs:
                    log.disabled = False
    else:
        pool = ThreadPoolExecutor(workers)
        try:
            yield pool
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)  # interrupted it waits for no block
            raise
        pool.shutdown(cancel_futures=True)


def _dask_client(workers: int, scheduler: str | None) -> Any:
    distributed = optional("distributed", "--engine dask")
    if scheduler is None:
        with _blocked_interrupt():  # its processes inherit it: this one ends them, and they print no traceback
            return distributed.Client(
                distributed.LocalCluster(
                    n_workers=workers, threads_per_worker=1, host="127.0.0.1", dashboard_address=None, silence_logs=50
                )
            )
    try:
        return distributed.Client(scheduler, timeout="10s")
    except OSError as error:
        raise ValueError(f"--scheduler {scheduler}: no Dask scheduler answers there: {error}") from error


def as_executor(given: Any) -> Executor:
    """An executor of `concurrent.futures`, or that of a Dask client."""
    if hasattr(given, "get_executor"):
        return given.get_executor()
    if not hasattr(given, "submit"):
        raise ValueError(f"executor = {given!r}: must be one of concurrent.futures, or a Dask client")
    return given


@contextmanager
def _blocked_interrupt() -> Iterator[None]:
    """Without Ctrl-C, where signals can be held back."""
    from multiprocessing import resource_tracker

    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    resource_tracker.ensure_running()  # starting, it would let them through again
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


@contextmanager
def _deferred_interrupt() -> Iterator[None]:
    """A Ctrl-C that `_result` raises: raised at once in one of Dask's own callbacks it would be swallowed there."""
    try:
        before = signal.signal(signal.SIGINT, lambda *_: _INTERRUPTED.set())
    except ValueError:  # outside the main thread, which alone hears signals
        yield
        return
    try:
        yield
    finally:
        _INTERRUPTED.clear()
        signal.signal(signal.SIGINT, before)


def _result(future: Future[Result]) -> Result:
    """The result of a block, waited for so that Ctrl-C is heard meanwhile."""
    while not wait([future], timeout=0.1).done and not _INTERRUPTED.is_set():
        pass
    if _INTERRUPTED.is_set():
        raise KeyboardInterrupt
    return future.result()


class Folder:
    """Finished blocks on the disk, for one study, seed and size; each says which block of which study it is."""

    def __init__(self, path: str | os.PathLike[str], description: dict[str, Any]) -> None:
        held = stored(path)
        self.path, text = Path(path), json.dumps(description, indent=2).encode()
        self._study = hashlib.sha256(text).hexdigest()
        try:
            self.path.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise ValueError(f"{self.path}: can be no folder for blocks: {error.strerror}") from error
        if held is None:
            write(self.path / "study.json", text)
        elif other := [k for k in description | held if description.get(k) != held.get(k)]:
            raise ValueError(
                f"{self.path}: holds blocks of another study: {', '.join(other)} differ; give an empty folder"
            )

    def _file(self, index: int) -> Path:
        return self.path / f"block-{index:08d}.npz"

    def _label(self, index: int, result: Result) -> str:
        """Return the name of a block with those of its arrays, their types and shapes."""
        arrays = ", ".join(f"{name} {array.dtype.str} {array.shape}" for name, array in result.items())
        return f"block {index} of study {self._study}: {arrays}"

    def load(self, index: int) -> Result | None:
        """Return a finished block, or None if it is missing, damaged or another block under this name."""
        try:
            with open(self._file(index), "rb") as whole, np.load(whole, allow_pickle=False) as file:
                result = {name: file[name] for name in file.files}
            label = result.pop("label").tobytes().decode()
        except Exception:  # whatever a damaged file leads to, the block is computed again
            return None
        return result if label == self._label(index, result) else None

    def save(self, index: int, result: Result) -> None:
        """Store a finished block."""
        label = np.frombuffer(self._label(index, result).encode(), np.uint8)
        with replacing(self._file(index)) as file:
            np.savez(file, label=label, **result)  # type: ignore[arg-type]


def stored(folder: str | os.PathLike[str]) -> dict[str, Any] | None:
    """The description of the study whose blocks a folder holds."""
    if not isinstance(folder, str | os.PathLike):
        raise ValueError(f"folder = {folder!r}: must be a path")
    path = Path(folder) / "study.json"
    if not path.exists():
        return None
    try:
        description = json.loads(path.read_text("utf-8"))
    except ValueError as error:
        raise ValueError(f"{path}: is damaged: {error}; give an empty folder") from error
    if not isinstance(description, dict):
        raise ValueError(f"{path}: is no study; give an empty folder")
    return description


class Blocks(Protocol):
    """A study in independent blocks; a task is a function and its argument, which go to a worker."""

    @property
    def blocks(self) -> int: ...

    def scenes(self, index: int) -> int: ...

    def task(self, index: int) -> tuple[Callable[[int], Result], int]: ...


def run_blocks(
    design: Blocks, executor: Executor, folder: Folder | None = None, progress: Callable[[int, int], None] | None = None
) -> Iterator[Result]:
    """Results of all blocks of a design, in their order; `Progress` is called with each."""
    under_way: dict[int, Result | Future[Result]] = {}
    begun = 0
    try:
        for index in range(design.blocks):
            while begun < min(index + _AHEAD, design.blocks):
                kept = folder.load(begun) if folder else None
                work, argument = design.task(begun)
                under_way[begun] = executor.submit(work, argument) if kept is None else kept
                begun += 1
            found = under_way.pop(index)
            is_new = isinstance(found, Future)
            result = _result(found) if isinstance(found, Future) else found
            if folder and is_new:
                folder.save(index, result)
            if progress:
                scenes = design.scenes(index)
                progress(scenes, 0 if is_new else scenes)
            yield result
    finally:
        ended = {index: found for index, found in under_way.items() if isinstance(found, Future) and found.done()}
        for index, future in ended.items():  # what was finished meanwhile is kept as well
            if folder and not future.cancelled() and future.exception() is None:
                folder.save(index, future.result())
