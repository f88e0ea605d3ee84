"""Engines: the same bits from every one, a worker killed in the middle, runs that continue, files that are whole."""

import errno
import io
import itertools
import json
import os
import re
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import BrokenExecutor, CancelledError, Future, ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import nullcontext
from dataclasses import replace
from functools import lru_cache, partial
from multiprocessing import get_context
from pathlib import Path
from types import SimpleNamespace
from typing import Any, NamedTuple
from unittest.mock import Mock

import numpy as np
import pytest
from scipy import interpolate, stats

from slipcircle import Arc, ensemble, load
from slipcircle.base import progress as progress_module
from slipcircle.base.progress import Progress
from slipcircle.tables import Series
from slipcircle.workbench.common.files import write_file
from slipcircle.workbench.common.identity import content_digest
from slipcircle.workbench.files.loaded import stability_of
from slipcircle.workbench.stability.critical import SlopeScene
from slipcircle.workbench.studies import engines, export
from slipcircle.workbench.studies.design import Design
from slipcircle.workbench.studies.engines import open_executor, stored
from slipcircle.workbench.studies.ensemble import grid
from slipcircle.workbench.studies.study import Study
from tests.support.blocks import quake

ROOT = Path(__file__).parents[1]
ANGLE = {"distribution": "normal", "mean": 10, "std": 1}
RADIUS = {"distribution": "lognormal", "mean": 1492.6, "std": 50}
VAIONT = load("vaiont")
SCENE = replace(VAIONT, uncertain={"friction.angle_deg": ANGLE, "arc.radius_m": RADIUS})
VALLEY = load("valley-side")
MANY: dict[str, Any] = {"n": 1500, "rng": 7, "size": 128, "sensitivity": 160}


def same(one: Study, two: Study) -> None:
    """Compare all arrays and sensitivity indices bit for bit."""
    assert repr(one.sensitivity) == repr(two.sensitivity)
    a, b = export.arrays(one), export.arrays(two)
    assert a.keys() == b.keys()
    for name in a:
        np.testing.assert_array_equal(a[name].view(np.uint8), b[name].view(np.uint8), err_msg=name)


def test_every_executor_gives_the_same_bits() -> None:
    """Threads, and another process; of circles, grounds and water levels too."""
    serial = ensemble(SCENE, **MANY)
    with ThreadPoolExecutor(3) as pool:
        same(serial, ensemble(SCENE, executor=pool, **MANY))
    levels = {"circle.centre_m.x": [212.9, 213.1], "water.level_m.3.y": [66.0, 70.0, 72.0]}
    with ProcessPoolExecutor(1, get_context("spawn")) as other:
        same(serial, ensemble(SCENE, executor=other, **MANY))
        same(grid(VALLEY, levels), grid(VALLEY, levels, other))


def test_what_is_no_executor_is_refused() -> None:
    with pytest.raises(
        ValueError, match=r"executor = 'threads': must be an executor of concurrent.futures or a Dask client"
    ):
        ensemble(SCENE, 10, executor="threads")
    with pytest.raises(ValueError, match="leave out --workers"), open_executor("threads", 2, "tcp://127.0.0.1:1"):
        pass


@pytest.fixture
def told_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Return a clock that advances by a second at each look, so that progress is shown from the first block on."""
    seconds = itertools.count()
    monkeypatch.setattr(progress_module, "time", SimpleNamespace(monotonic=lambda: float(next(seconds))))


class Cluster(NamedTuple):
    """A scheduler of Dask and its workers."""

    address: str
    scheduler: subprocess.Popen[bytes]
    workers: list[subprocess.Popen[bytes]]


@pytest.fixture(scope="module")
def cluster() -> Iterator[Cluster]:
    """Two workers on loopback, each process by its own command."""
    pytest.importorskip("distributed")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        address = f"tcp://127.0.0.1:{free.getsockname()[1]}"
    worker = ["dask_worker", address, "--nthreads", "1", "--no-dashboard", "--no-nanny"]
    commands = [["dask_scheduler", "--host", address, "--no-dashboard"], worker, worker]
    started = [
        subprocess.Popen([sys.executable, "-m", f"distributed.cli.{name}", *rest], stderr=subprocess.DEVNULL)
        for name, *rest in commands
    ]
    try:
        yield Cluster(address, started[0], started[1:])
    finally:
        for process in started:
            process.kill()
            process.wait()


LINE = "sweep vaiont-rate --uncertain friction.peak_deg=normal:24:1 --samples 1e6 --block 256"


def started(folder: Path) -> bool:
    """Whether a study has stored a block in its folder."""
    digests = folder / "digests.npy"
    return digests.exists() and any(digests.read_bytes()[128:])  # the header may not be complete yet


@pytest.mark.parametrize("where", [*engines.ENGINES, "scheduler"])
def test_ctrl_c_ends_every_engine(where: str, tmp_path: Path, request: pytest.FixtureRequest) -> None:
    """The signal goes to all processes, as from a terminal, after the first block; what is stored is a study's."""
    given = [*LINE.split(), "--workers", "1", "--engine", where]
    if where == "scheduler":
        given = [*LINE.split(), "--scheduler", request.getfixturevalue("cluster").address]
    process = subprocess.Popen(
        [sys.executable, "-m", "slipcircle", *given, "--resume", str(tmp_path)], cwd=ROOT,
        start_new_session=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),  # where the tests run in the background
    )  # fmt: skip
    try:
        while not started(tmp_path) and process.poll() is None:
            time.sleep(0.1)
        assert process.poll() is None, process.communicate()
        os.killpg(process.pid, signal.SIGINT)
        out, err = process.communicate(timeout=60)  # a guard; it takes a tenth of a second
    finally:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
    assert (process.returncode, out) == (130, "")
    assert "interrupted; finished blocks are in" in err
    assert "Traceback" not in err


STUDY: dict[str, Any] = {"n": 30_000, "rng": 7, "size": 256, "sensitivity": 0}


def test_a_dask_client_is_an_executor(cluster: Cluster) -> None:
    from distributed import Client

    with Client(cluster.address) as client:
        suite: dict[str, Any] = {"records": [quake(1), quake(2)], "polarities": True, "scales": [1.0, 2.0]}
        there, here = (ensemble(SCENE, 8, 1, executor, **suite) for executor in (client, None))
        assert all(np.array_equal(there.values[name], here.values[name]) for name in here.values)


def test_blocks_of_a_killed_dask_worker_go_to_another(cluster: Cluster, tmp_path: Path) -> None:
    with open_executor(scheduler=cluster.address) as pool, ThreadPoolExecutor(1) as killer:
        done = killer.submit(_kill_once_started, cluster.workers[0], tmp_path)
        found = ensemble(SCENE, executor=pool, folder=tmp_path, **STUDY)
        done.result()
    same(ensemble(SCENE, **STUDY), found)


@pytest.mark.parametrize("times", [1, 2])
def test_a_block_whose_result_is_lost_is_computed_once_more(times: int) -> None:
    """Dask's executor may fail to unpack the result of a worker that has died since."""
    losses = iter([ValueError("lost")] * times)

    class Losing(ThreadPoolExecutor):
        def submit(self, work: Any, /, *given: Any, **named: Any) -> Any:
            future = super().submit(work, *given, **named)
            loss = next(losses, None) if given[0] == 0 else None
            if loss is None:
                return future
            lost: Future[Any] = Future()
            lost.set_exception(loss)
            return lost

    with Losing(2) as pool:
        if times == 1:
            same(ensemble(SCENE, **STUDY), ensemble(SCENE, executor=pool, **STUDY))
        else:
            with pytest.raises(ValueError, match="lost"):
                ensemble(SCENE, executor=pool, **STUDY)


def test_a_killed_dask_scheduler_loses_no_stored_block(cluster: Cluster, tmp_path: Path) -> None:
    with open_executor(scheduler=cluster.address) as pool, ThreadPoolExecutor(1) as killer:
        killer.submit(_kill_once_started, cluster.scheduler, tmp_path)
        with pytest.raises(CancelledError):
            ensemble(SCENE, executor=pool, folder=tmp_path, **STUDY)
    kept = np.load(tmp_path / "digests.npy").any(axis=1)
    assert 0 < kept.sum() < kept.size
    progress = io.StringIO()
    same(ensemble(SCENE, **STUDY), ensemble(SCENE, folder=tmp_path, progress=progress, **STUDY))
    assert f"{256 * kept.sum()} from before" in progress.getvalue()


def _kill_once_started(process: subprocess.Popen[bytes], folder: Path) -> None:
    while not started(folder):
        time.sleep(0.01)
    process.kill()


def test_a_run_continues(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A run continues from blocks that are missing, damaged, cut off or of another study, with the seed of before.

    Blocks that are whole are not computed again, and the study says how many were damaged.
    """
    ensemble(SCENE, folder=tmp_path / "other", **MANY | {"rng": 8})
    folder = tmp_path / "blocks"
    whole = ensemble(SCENE, folder=folder, **MANY)
    lanes = np.load(folder / "run_out.npy", mmap_mode="r+")
    digests = np.load(folder / "digests.npy", mmap_mode="r+")
    places = [whole.design.place(block) for block in range(whole.design.blocks)]
    digests[3] = 0
    lanes[places[5][0].start + 7] = np.nextafter(lanes[places[5][0].start + 7], 0.0)
    for path in folder.glob("*.npy"):
        place = 20 if path.stem == "digests" else places[20]
        np.load(path, mmap_mode="r+")[place] = np.load(tmp_path / "other" / path.name)[place]
    digests[7, 31] ^= 1
    del lanes
    again = ensemble(SCENE, folder=folder, **(MANY | {"rng": None}))
    same(whole, again)
    assert (whole.damaged, again.damaged) == (0, 3)
    assert "3 blocks of the folder were damaged and computed again" in again.warnings
    with open(folder / "run_out.npy", "r+b") as file:  # the header is lost, and all but 1,000 samples
        file.write(b"nothing")
        file.truncate(128 + 8 * 1000)
    computed = []
    run = Design.run_block

    def noted(design: Design, index: int) -> Any:
        computed.append(index)
        return run(design, index)

    monkeypatch.setattr(Design, "run_block", noted)
    same(whole, ensemble(SCENE, folder=folder, **MANY))
    assert sorted(computed) == [*range(1000 // 128, whole.design.blocks)]


def test_a_full_disk_is_said_and_loses_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A full disk is reported before the first missing block is computed."""
    whole = ensemble(SCENE, folder=tmp_path, **MANY)
    (tmp_path / "slips.npy").unlink()
    with monkeypatch.context() as full:
        full.setattr(os, "posix_fallocate", Mock(side_effect=OSError(errno.ENOSPC, "No space left on device")))
        with pytest.raises(
            ValueError, match=r"npy: cannot be written: No space left on device; free .* MB and run the study"
        ):
            ensemble(SCENE, folder=tmp_path, **MANY)
    again = ensemble(SCENE, folder=tmp_path, **MANY)
    same(whole, again)
    assert again.damaged == whole.design.blocks


def test_large_studies_are_in_memory_mapped_files(monkeypatch: pytest.MonkeyPatch) -> None:
    in_memory = ensemble(SCENE, **MANY)
    monkeypatch.setattr(engines, "_IN_MEMORY", 1000)
    in_file = ensemble(SCENE, **MANY)
    whole: Any = in_file.values["run_out"].base
    assert isinstance(whole.base, np.memmap)
    same(in_memory, in_file)


def test_another_study_is_refused(tmp_path: Path) -> None:
    """Studies are told apart by every setting, also in blocks of an older version."""
    ensemble(SCENE, 100, 1, folder=tmp_path)
    held = json.loads((tmp_path / "study.json").read_text("utf-8"))
    assert (held["seed"], stored(tmp_path)) == (1, held)
    del held["correlation"]  # as it was before there were any
    old = tmp_path / "old"
    old.mkdir()
    (old / "study.json").write_text(json.dumps(held))
    fewer = replace(SCENE, uncertain={"friction.angle_deg": ANGLE})
    for scene, n, seed, folder, word in (
        (SCENE, 200, 1, tmp_path, "samples"),
        (SCENE, 100, 2, tmp_path, "seed"),
        (replace(SCENE, initial_velocity=1.0), 100, 1, tmp_path, "numbers"),
        (fewer, 100, 1, tmp_path, "drawn"),
        (SCENE, 100, 1, old, "correlation"),
    ):
        with pytest.raises(ValueError, match=f"another study: .*{word}"):
            ensemble(scene, n, seed, folder=folder)


def test_another_record_or_law_is_refused(tmp_path: Path) -> None:
    """Records and laws that are not numbers tell studies apart, too."""
    for amplitude, same in (
        (0.5, nullcontext()),
        (0.5, nullcontext()),
        (0.4, pytest.raises(ValueError, match="effects d")),
    ):
        record = Series(np.arange(3.0), np.array([0.0, amplitude, 0.0]), held=False)
        scene = replace(VAIONT, effects={"rotation": {}, "shaking": {"horizontal": record}}, friction=0.6)
        with same:
            grid(scene, {"friction": [0.4]}, folder=tmp_path)


MU = 0.2  # which `law` reads


def law(slip: Any) -> Any:
    return MU + 0.0 * slip


class Law:
    """A law whose numbers are those of an instance."""

    def __init__(self, mu: float) -> None:
        self.mu = mu

    def __call__(self, slip: Any) -> Any:
        return self.mu + 0.0 * slip

    def coefficient(self, slip: Any) -> Any:
        return self(slip)


def drawn_from(mean: float) -> Any:
    return stats.rv_histogram(np.histogram([8.0, 9.0, 9.0, mean, mean + 2.0], bins=5))


KNOWN: dict[str, Callable[[float], Any]] = {
    "closure": lambda mu: lambda slip: mu + 0.0 * slip,
    "default": lambda mu: lambda slip, mu=mu: mu + 0.0 * slip,
    "constant": lambda mu: eval(f"lambda slip: {mu!r} + 0.0 * slip"),
    "nested": lambda mu: lambda slip: (lambda: np.sin(mu))() + 0.0 * slip,
    "partial": lambda mu: partial(np.interp, xp=[0.0, 1.0], fp=[mu, 0.1]),
    "interpolator": lambda mu: interpolate.PchipInterpolator([0.0, 1.0], [mu, 0.1]),
    "vectorized": lambda mu: np.vectorize(lambda slip: mu),
    "frozen": lambda mu: stats.norm(mu, 1.0),
    "histogram": lambda mu: drawn_from(10.0 + mu),
    "frozen histogram": lambda mu: drawn_from(10.0 + mu)(),
    "random variable": lambda mu: stats.truncate(stats.Normal(mu=mu, sigma=1.0), lb=0.0),
    "record": lambda mu: Series(np.arange(3.0), np.array([0.0, mu, 0.0]), held=False),
    "circle": lambda mu: Arc(1e3 + mu, 3.8, 4.8, 20e3),
}
UNKNOWN: dict[str, Callable[[float], Any]] = {
    "bound method": lambda mu: Law(mu).coefficient,
    "instance": Law,
    "closure over an instance": lambda mu: partial(lambda law, slip: law(slip), Law(mu)),
    "stored results": lambda mu: lru_cache(law),
    "ufunc": lambda mu: np.frompyfunc(Law(mu), 1, 1),
    "generator": lambda mu: (mu for _ in range(3)),
    "bound method of a list": lambda mu: [mu].index,
    "imported": lambda mu: exec_import,
}


def exec_import(slip: Any) -> Any:
    import tests.support.blocks as own

    return own.quake(1) + slip


@pytest.mark.parametrize("kind", KNOWN)
def test_objects_are_recognised_by_their_content(kind: str) -> None:
    """Objects are recognised by their content, also after use."""
    same = KNOWN[kind](0.2)
    first = content_digest(same)
    for use in ("mean", "std", "standard_deviation", "median", "support"):
        getattr(same, use, lambda: None)()
    assert content_digest(same) == first == content_digest(KNOWN[kind](0.2)) != content_digest(KNOWN[kind](0.3))


@pytest.mark.parametrize("kind", UNKNOWN)
def test_objects_without_accessible_content_are_refused(kind: str) -> None:
    with pytest.raises(
        ValueError, match=r"a later run could not recognise its content .*; give numbers, a table, or a"
    ):
        content_digest(UNKNOWN[kind](0.2))


def test_folders_of_other_objects_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A law whose global changes, a law with another state, another histogram, another kind of mass."""

    def study(folder: str, **changed: Any) -> Any:
        return ensemble(replace(SCENE, **changed), 8, 1, folder=tmp_path / folder, sensitivity=0)

    inputs = {"arc.radius_m": RADIUS}
    first = study("law", friction=law, uncertain=inputs)
    assert study("law", friction=law, uncertain=inputs).mean("run_out") == first.mean("run_out")
    monkeypatch.setitem(globals(), "MU", 0.3)
    with pytest.raises(ValueError, match="another study: friction differ"):
        study("law", friction=law, uncertain=inputs)
    with pytest.raises(ValueError, match=r"folder: Law.coefficient: a later run could not recognise"):
        study("method", friction=Law(0.2).coefficient, uncertain=inputs)
    study("histogram", uncertain={"friction.angle_deg": drawn_from(10.0)()})
    with pytest.raises(ValueError, match=r"another study: .*distributions"):
        study("histogram", uncertain={"friction.angle_deg": drawn_from(10.3)()})

    class OtherArc(Arc):
        pass

    with pytest.raises(ValueError, match="OtherArc is not part of an installed package"):
        study("mass", arc=OtherArc(1492.6, 3.756, 4.833, 20e3))


@pytest.mark.parametrize("changed", ["entry", "depth"])
def test_a_folder_of_searches_is_that_of_their_limits(changed: str, tmp_path: Path) -> None:
    """Folders of searches are told apart by their limits, also if the circle of the means is the same."""
    slope = load("real-slope")
    stability = stability_of(slope)
    assert isinstance(slope, SlopeScene)
    assert stability is not None
    angle = float(np.degrees(np.arctan(slope.numbers["friction.peak"])))
    spread = {"distribution": "uniform", "low": angle - 0.5, "high": angle + 0.5}
    scene = replace(slope, uncertain={"friction.peak_deg": spread})
    ensemble(scene, 2, 1, folder=tmp_path, search_each=True, sensitivity=0)
    limits = {**stability.limits, changed: {"entry": (-500.0, 500.0), "depth": 0.01}[changed]}
    other = replace(scene, stability=replace(stability, limits=limits))
    with pytest.raises(ValueError, match="another study: search differ"):
        ensemble(other, 2, 1, folder=tmp_path, search_each=True, sensitivity=0)


@pytest.mark.parametrize(
    ("content", "fault"),
    [
        ("not json", "is damaged"),
        ("[1, 2]", "is not a study"),
        ('{"seed": 1, "outcomes": [], "keep": true}', "holds blocks in the format of another version"),
    ],
)
def test_a_folder_that_is_none(tmp_path: Path, content: str, fault: str) -> None:
    (tmp_path / "study.json").write_text(content, "utf-8")
    with pytest.raises(ValueError, match=f"^[^\n]*{fault}[^\n]*; give an empty folder$"):
        ensemble(SCENE, 10, 1, folder=tmp_path)
    with pytest.raises(ValueError, match=r"study\.json: cannot be used as a folder"):
        ensemble(SCENE, 10, 1, folder=tmp_path / "study.json")


def test_links_and_pipes_stay_what_they_are(tmp_path: Path) -> None:
    """A file is replaced whole (`test_report`), but not what is none."""
    link, pipe = tmp_path / "link", tmp_path / "pipe"
    link.symlink_to("target")
    write_file(link, b"through it")
    assert (link.is_symlink(), link.read_bytes()) == (True, b"through it")
    os.mkfifo(pipe)
    with ThreadPoolExecutor(1) as reader:
        read = reader.submit(pipe.read_bytes)
        write_file(pipe, b"once")
        assert read.result(10) == b"once"


@pytest.mark.parametrize("gone", [BrokenExecutor, CancelledError])
def test_workers_that_are_gone(gone: type[Exception], monkeypatch: pytest.MonkeyPatch, refused: Any) -> None:
    """Lost workers of processes and of Dask are replaced; any other failure of a block is an error."""

    def lost(*_: Any) -> Any:
        raise gone

    monkeypatch.setattr("slipcircle.workbench.commands.sweep._compute", lost)
    told = refused("sweep vaiont --grid friction.angle_deg=8,10")
    assert "died; give --resume FOLDER to keep finished blocks" in told
    monkeypatch.setattr(Design, "run_block", lost)
    with ThreadPoolExecutor(2) as pool, pytest.raises(gone):
        ensemble(SCENE, 100, 1, pool)


def test_progress_is_printed_at_growing_intervals(capsys: pytest.CaptureFixture[str], told_at_once: None) -> None:
    """Progress in a pipe is printed at growing intervals, and not at all inside other counted work."""
    with Progress(100, "scenes") as progress:
        for _ in range(10):
            progress(10)
            with Progress(3, "steps") as inner:
                inner(3)
    lines = capsys.readouterr().err.splitlines()
    assert 2 <= len(lines) <= 4
    assert re.fullmatch(r"\d+0 of 100 scenes, \S+ a second, \d+ s left", lines[0])
    assert re.fullmatch(r"100 of 100 scenes, \S+ a second, in \S+ s", progress.text())


@pytest.mark.parametrize(
    ("command", "counted"),
    [("search real-slope", "valleys followed to their least factor"), ("search real-slope", "circles evaluated"),
     ("backanalyse vaiont --run-out-m 400", "scenes solved"),
     ("backanalyse vaiont --run-out-m 677+-5 --peak-velocity-m-s 28+-1", "starts followed to the best fit")],
)  # fmt: skip
def test_commands_tell_what_is_done_how_much_of_it_and_the_time_left(
    command: str, counted: str, asked: Any, told_at_once: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(progress_module, "_SOON", (0.0, 0.0))
    monkeypatch.setattr(progress_module, "_SELDOM", 0.0)
    status, _, err = asked(*command.split())
    assert status == 0
    shares = re.findall(rf"(\d+) of (\d+) {counted}, \S+ a second, (?:\d+ s left|in \S+ s)", err)
    assert shares
    assert all(0 < int(done) <= int(total) for done, total in shares)


def test_progress_on_a_terminal_leaves_an_empty_line(told_at_once: None, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("rich")
    terminal = io.StringIO()
    monkeypatch.setattr(terminal, "isatty", lambda: True)
    with Progress(4, "scenes", terminal) as told:
        for _ in range(4):
            told()
    assert "3 of 4 scenes, " in terminal.getvalue()
    assert terminal.getvalue().rpartition("scenes")[2].rstrip("\n").endswith("\x1b[2K")
