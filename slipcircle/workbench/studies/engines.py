"""Executors that compute blocks, and storage of the results.

Blocks may finish in any order, on any executor of `concurrent.futures`. Each is stored in its place in arrays, so that
every executor gives the same bits on machines of one class. Large studies, and studies with a folder, store their
arrays in memory-mapped files of NumPy, with a digest of the inputs and results of each finished block. A later run with
the same folder computes the blocks whose digest is missing or wrong.

Workers of Dask should run with MALLOC_TRIM_THRESHOLD_=268435456 in their environment. With Dask's default of 65536, the
temporary arrays of a block are returned to the system and requested again, and a run takes at least 1.5 times as long.
"""

import hashlib
import json
import logging
import math
import os
import signal
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor, wait
from contextlib import contextmanager
from multiprocessing import get_context
from pathlib import Path
from tempfile import TemporaryFile, gettempdir
from threading import Event
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.kinds import Columns, PathName, Shape, ValueDict, Values
from slipcircle.base.optional import optional
from slipcircle.workbench.common.files import write_file
from slipcircle.workbench.studies.design import Design

ENGINES = ("threads", "processes")
_AHEAD = 512  # blocks under way at once: more than the workers of a cluster
_IN_MEMORY = 10**7  # scenes up to which arrays without a folder are in memory
_DIGEST = 32  # bytes
_FORMAT = "arrays"  # of a folder


@contextmanager
def open_executor(
    name: str = "threads", workers: int | None = None, scheduler: str | None = None
) -> Iterator[Executor]:
    """Open an executor with "threads" or "processes" (by default one for each processor), or of a Dask scheduler.

    ``workers`` is their number, and ``scheduler`` an address, whose workers exist already.
    """
    if workers is not None and workers < 1:
        raise ValueError(f"--workers {workers}: must be at least 1; leave it out for one worker for each processor")
    if scheduler is not None and workers is not None:
        raise ValueError("--scheduler: has its own workers: leave out --workers")
    client = None if scheduler is None else _client(scheduler)
    count = workers or os.cpu_count() or 1
    if client is not None:
        pool = as_executor(client)
    elif name == "processes":  # the workers leave Ctrl-C to this process
        pool = ProcessPoolExecutor(count, get_context("spawn"), signal.signal, (signal.SIGINT, signal.SIG_IGN))
    else:
        pool = ThreadPoolExecutor(count)
    try:
        yield pool
    finally:
        pool.shutdown(wait=isinstance(pool, ProcessPoolExecutor))  # other pools end by themselves
        if client is not None:
            client.close()


def _client(scheduler: str) -> Any:
    """Return a Dask client for the scheduler at an address; ValueError if none answers."""
    for name in ("tornado.application", "distributed.client"):  # they print tracebacks of cancelled futures
        logging.getLogger(name).disabled = True
    try:
        return optional("distributed", "--scheduler").Client(scheduler, timeout="10s")
    except OSError as error:
        raise ValueError(f"--scheduler {scheduler}: no Dask scheduler answers there: {error}") from error


def as_executor(executor: Any) -> Executor:
    """Return an executor of `concurrent.futures`, or the executor of a Dask client."""
    if hasattr(executor, "get_executor"):
        return executor.get_executor(pure=False)  # keys by content would cost more than the blocks
    if not hasattr(executor, "submit"):
        raise ValueError(f"executor = {executor!r}: must be an executor of concurrent.futures or a Dask client")
    return executor


class Store:
    """Arrays of the results of a study, in memory or in files.

    Attributes
    ----------
    values : mapping of str to ndarray
        Results by name, of the design's shape.
    damaged : int
        Number of finished blocks whose files have changed since they were written.
    """

    def __init__(self, design: Design, described: Callable[[], Values], folder: Any = None) -> None:
        self.design = design
        self.damaged = 0
        self._study = b""
        path = None if folder is None else _path(folder)
        if path is not None:
            # Create or open the folder of a study and return its digest; ValueError if it holds another study.
            description = {"format": _FORMAT, **described()}
            held = stored(path)
            text = json.dumps(description, indent=2).encode()
            try:
                path.mkdir(parents=True, exist_ok=True)
            except OSError as error:
                raise ValueError(f"{path}: cannot be used as a folder for blocks: {error.strerror}") from error
            if held is None:
                write_file(path / "study.json", text)
            elif other := [k for k in description | held if description.get(k) != held.get(k)]:
                raise ValueError(
                    f"{path}: holds blocks of another study: {', '.join(other)} differ; give an empty folder"
                )
            self._study = hashlib.sha256(text).digest()
            self._digests = _mapped(path, "digests", np.dtype(np.uint8), (design.blocks, _DIGEST))
        in_memory = path is None and math.prod(design.shape) <= _IN_MEMORY
        self.values = {
            name: np.zeros(design.shape, kind) if in_memory else _mapped(path, name, kind, design.shape)
            for name, kind in design.outputs.items()
        }

    def has(self, index: int) -> bool:
        """Return whether the block with an index is stored and its digest is correct.

        A wrong digest is counted in ``damaged``.
        """
        if not self._study or not self._digests[index].any():
            return False
        is_whole = self._digests[index].tobytes() == self._digest(index)
        self.damaged += not is_whole
        return is_whole

    def save(self, index: int, result: Columns) -> None:
        """Store the result of the block with an index, arrays by name of output."""
        for name, values in self.values.items():
            values[self.design.place(index)] = result[name]
        if self._study:
            self._digests[index] = np.frombuffer(self._digest(index), np.uint8)

    def _digest(self, index: int) -> bytes:
        """Return a digest of the study, the index of a block and its stored results, as 32 bytes."""
        digest = hashlib.sha256(self._study + index.to_bytes(8))
        place = self.design.place(index)
        for values in self.values.values():
            digest.update(np.ascontiguousarray(values[place]).data)
        return digest.digest()


def _mapped(folder: Path | None, name: str, kind: np.dtype[Any], shape: Shape) -> NDArray[Any]:
    """Return an array in a file of a folder, or in a temporary file, created with this type and shape if necessary.

    ``kind`` is the NumPy type of its elements; the file is named after ``name``.

    Disk space is allocated in advance if the system supports it; otherwise a full disk would end the process later.
    """
    path = (folder or Path(gettempdir())) / f"{name}.npy"
    size = math.prod(shape) * kind.itemsize
    try:
        with open(os.open(path, os.O_RDWR | os.O_CREAT, 0o666), "r+b") if folder else TemporaryFile() as file:
            np.lib.format.write_array_header_1_0(file, {"descr": kind.str, "fortran_order": False, "shape": shape})
            start = file.tell()
            file.truncate(start + size)
            if hasattr(os, "posix_fallocate"):
                os.posix_fallocate(file.fileno(), 0, start + size)
            return np.asarray(np.memmap(file, kind, "r+", start, shape))
    except OSError as error:
        remedy = f"free {size / 1e6:.3g} MB and run the study again; finished blocks are kept"
        raise ValueError(f"{path}: cannot be written: {error.strerror}; {remedy}") from error


def _path(folder: PathName) -> Path:
    """Return the path of a folder; ValueError for another type."""
    if not isinstance(folder, str | os.PathLike):
        raise ValueError(f"folder = {folder!r}: must be a path")
    return Path(folder)


def stored(folder: PathName) -> ValueDict | None:
    """Return the description of the study whose blocks are in a folder, as in its study.json; None without a study."""
    path = _path(folder) / "study.json"
    if not path.exists():
        return None
    try:
        description = json.loads(path.read_text("utf-8"))
    except ValueError as error:
        raise ValueError(f"{path}: is damaged: {error}; give an empty folder") from error
    if not isinstance(description, dict):
        raise ValueError(f"{path}: is not a study; give an empty folder")
    if description.get("format") != _FORMAT:
        raise ValueError(f"{folder}: holds blocks in the format of another version; give an empty folder")
    return description


def compute(
    design: Design, executor: Executor, store: Store, progress: Callable[[int, int], None] = lambda *_: None
) -> None:
    """Compute and store the blocks that are not stored yet; ``progress(scenes, stored scenes)`` is called for each.

    A block that fails is computed once more, since a cluster may lose a result together with its worker.
    """
    under_way: dict[Future[Columns], int] = {}
    repeated = set[int]()

    def start(index: int) -> None:
        work, argument = design.task(index)
        under_way[executor.submit(work, argument)] = index

    def save(futures: Iterable[Future[Columns]]) -> None:
        for future in futures:
            index = under_way.pop(future)
            if not future.cancelled() and future.exception() is not None and index not in repeated:
                repeated.add(index)
                start(index)
                continue
            store.save(index, future.result())
            progress(design.scenes(index), 0)

    with _deferred_interrupt() as interrupted:

        def save_until(left: int) -> None:
            while len(under_way) > left and not interrupted.is_set():
                save(wait(under_way, 0.1, FIRST_COMPLETED).done)
            if interrupted.is_set():
                raise KeyboardInterrupt

        try:
            for index in range(design.blocks):
                save_until(_AHEAD)
                if store.has(index):
                    progress(design.scenes(index), design.scenes(index))
                    continue
                start(index)
            save_until(0)
        finally:  # after an error or Ctrl-C, finished blocks are stored as well
            for future in [*under_way]:
                future.cancel()
            # Those that were computed without an error and not cancelled.
            done = (future for future in [*under_way] if future.done() and not future.cancelled())
            save(future for future in done if future.exception() is None)


@contextmanager
def _deferred_interrupt() -> Iterator[Event]:
    """Yield an event that Ctrl-C sets, because a KeyboardInterrupt could be lost in a callback of Dask."""
    interrupted = Event()
    try:
        before = signal.signal(signal.SIGINT, lambda *_: interrupted.set())
    except ValueError:  # outside the main thread, which alone receives signals
        yield interrupted
        return
    try:
        yield interrupted
    finally:
        signal.signal(signal.SIGINT, before)
