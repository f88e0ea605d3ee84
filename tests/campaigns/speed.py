"""How long motions take, in ensembles and alone, beside other integrators, for every width of vectors.

``python -m tests.campaigns.speed [PICTURE]`` prints the table of the page on accuracy, and draws error against time.
Needs heyoka, and for records Numba: pip install heyoka numba. A kind of processor that our binary has runs in a process
of its own: AVX-512 in both, or vectors of 256 bits in both; heyoka knows the processor, though, and keeps its further
registers and instructions.
"""

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import replace
from functools import partial
from importlib import import_module
from importlib.util import find_spec
from multiprocessing import get_context
from pathlib import Path
from statistics import median
from typing import Any, NamedTuple

import heyoka as hy  # type: ignore[import-not-found, import-untyped, unused-ignore]
import numpy as np
from numpy.typing import NDArray
from scipy.special import erf

from generated import polar_moment
from slipcircle import Scene, ensemble, load, solve, synthetic_records
from slipcircle.derivatives import with_parameter_arrays
from slipcircle.workbench.cost.rows import medians as median_seconds
from slipcircle.workbench.outputs.info import machine
from slipcircle.workbench.outputs.pictures.files import render
from slipcircle.workbench.outputs.pictures.plotstyle import SERIES
from tests.support import blocks, oracle, taylor
from tests.support.lanes import BINARY
from tests.support.peers_of_motion import ARC, LAWS, VAIONT, alone, by_scipy, friction, in_batches, one_by_one

Floats = NDArray[np.float64]
ACCURACY = 1e-9
COUNT, MANY = 8_000, 1_000_000  # scenes
SCALES = 64  # of a record
AGAIN = 50  # times that one scene is solved between looks at the clock
AT_HAND = 4_000  # scenes built in advance
GEOMETRIES = 2_000
LAYERED: Scene[Any] = load("layered-slope")
BATCHES = (4, 8, 16, 32)
WIDE = ("avx512", "avx2")
LEVEL = os.environ.get("SLIPCIRCLE_COMPILED", "")
ONE = np.tan(np.radians([14.0]))
DRAWN, TOLERANCES, CHECKED = "exponential", (1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13), 12  # in the picture
LEAST = 1e-17  # error that is drawn


class Row(NamedTuple):
    """Time of ours and of what stands beside it, in seconds of one scene, or of one sample of a record."""

    measure: str
    peer: str
    ours: float
    theirs: float


def frictions(count: int) -> Floats:
    """Friction coefficients of an ensemble."""
    return np.tan(np.radians(np.linspace(10.0, 19.5, count)))


def together(law: str, accuracy: float, mu: Floats) -> Floats:
    """Return an ensemble by this package: rotations and times at rest, dimensionless; peak velocities come along."""
    motion = solve(replace(VAIONT, friction=friction(law, mu)), accuracy)
    return np.array([motion.run_out / ARC.radius, motion.duration / ARC.time_scale])


def one_scene(law: str) -> Callable[[float], tuple[float, float]]:
    """Return a solver of one scene, to rounding and with its error, that takes another scene at hand in each call.

    Its argument is the friction of all of them; peak velocities come along.
    """
    scenes = iter([Scene(ARC, friction(law, mu), VAIONT.effects) for mu in np.repeat(ONE, AT_HAND).tolist()])

    def solver(mu: float) -> tuple[float, float]:
        motion = solve(next(scenes))
        assert motion.error_estimate < ACCURACY
        return motion.run_out / ARC.radius, motion.duration / ARC.time_scale

    return solver


def medians(works: Sequence[Callable[[], object]], count: int = 1) -> list[float]:
    """Median seconds of one of so many, of each piece of work, in turns."""
    return [seconds / count for seconds in median_seconds(works)]


def ensembles() -> Iterator[Row]:
    """Ensembles of frictions on one core, beside heyoka's fastest batch."""
    mu = frictions(COUNT)
    for law in LAWS:
        ways: list[Callable[[Floats], Floats]] = [partial(together, law, ACCURACY)]
        ways += (in_batches(law, ACCURACY, lanes) for lanes in BATCHES)
        ours, *theirs = medians([partial(way, mu) for way in ways], COUNT)
        fastest = int(np.argmin(theirs))
        yield Row(f"{COUNT} scenes, {law}", f"heyoka, batches of {BATCHES[fastest]}", ours, theirs[fastest])


def single_scenes() -> Iterator[Row]:
    """One scene at hand with peak velocity and error estimate, beside a call of heyoka, each time and again."""
    mu = np.repeat(ONE, AGAIN)
    for law in LAWS:
        ways = partial(one_by_one, one_scene(law)), alone(law, ACCURACY)
        ours, theirs = medians([partial(way, mu) for way in ways], AGAIN)
        yield Row(f"one scene, {law}", "heyoka", ours, theirs)


def samples() -> Iterator[Row]:
    """`ensemble` on one thread, beside `solve` of as many frictions."""
    uncertain = replace(VAIONT, uncertain={"friction.angle_deg": {"distribution": "normal", "mean": 14, "std": 1}})
    angles = np.random.default_rng(1).normal(14, 1, MANY)
    with ThreadPoolExecutor(1) as pool:
        study = partial(ensemble, uncertain, MANY, 1, pool, accuracy=ACCURACY)
        solved = partial(together, "constant", ACCURACY, np.tan(np.radians(angles)))
        yield Row("a million samples by `ensemble`", "`solve` of as many", *medians([study, solved], MANY))


def block(values: Floats, step: float, yields: float, scales: Floats) -> Floats:
    """Displacements and peak velocities of a rigid block on a record at some scales, by one trapezium a sample."""
    results = np.zeros((2, scales.size))
    for k, scale in enumerate(scales):
        displacement, speed, peak = 0.0, 0.0, 0.0
        for value in values:
            rate = scale * value - yields
            if speed > 0.0 or rate > 0.0:
                after = max(speed + step * rate, 0.0)
                displacement += 0.5 * step * (speed + after)
                speed = after
                peak = max(peak, speed)
        results[:, k] = displacement, peak
    return results


def records() -> Iterator[Row]:
    """Yield a frozen arc under a record at many scales, beside Numba's loop for the rigid block: of one sample."""
    if find_spec("numba") is None:
        print("records: not measured, as Numba is not installed", file=sys.stderr)
        return
    numba: Any = import_module("numba")

    (record,) = synthetic_records(1, arias=1.5, duration=12.0, seed=1).values()
    scales = np.linspace(0.5, 3.0, SCALES)
    shaken = Scene(blocks.ARC, blocks.MU, {"shaking": {"horizontal": record, "scale": scales}})
    loop = partial(numba.njit(block), record.values, record.time[1], blocks.factor()[1], scales)
    works: list[Callable[[], object]] = [lambda: solve(shaken, ACCURACY).outcomes["peak_velocity"], loop]
    yield Row("a sample of a record", "Numba, rigid block", *medians(works, SCALES * record.time.size))


def threads() -> Iterator[Row]:
    """Yield a million scenes by threads on all cores, beside one thread: by the clock, not by the processor's time."""
    cores = os.cpu_count() or 1
    parts = np.array_split(frictions(MANY), 64)

    def seconds(workers: int) -> float:
        start = time.perf_counter()
        with ThreadPoolExecutor(workers) as pool:
            list(pool.map(partial(together, "constant", ACCURACY), parts))
        return (time.perf_counter() - start) / MANY

    turns = [(seconds(cores), seconds(1)) for _ in range(5)]
    yield Row(f"a million on {cores} cores", "one thread", *map(median, zip(*turns, strict=True)))


def layered(name: str) -> object:
    """Return an ensemble of layered ground over one number, with what it takes to lay it out."""
    values = np.asarray(LAYERED.numbers[name]) * np.linspace(0.998, 1.002, GEOMETRIES)
    scenes, invalid = with_parameter_arrays(LAYERED, {name: values})
    return solve(scenes, ACCURACY, invalid=invalid).outcomes["run_out"]


def layers() -> Iterator[Row]:
    """Yield a layered ensemble over its geometry, beside one over a soil's cohesion, which has one geometry."""
    works = [partial(layered, name) for name in ("radius", "soils.clay.cohesion")]
    yield Row("layered, over geometry", "over cohesion", *medians(works, GEOMETRIES))


def kernel_calls() -> Iterator[Row]:
    """Yield a kernel called with one float, beside SciPy's erf, each time and again."""

    def again(function: Any) -> None:
        for _ in range(AGAIN):
            function(0.5)

    yield Row(
        "a kernel of one float",
        "`scipy.special.erf`",
        *medians([partial(again, f) for f in (polar_moment, erf)], AGAIN),
    )


MEASURES: Sequence[Callable[[], Iterator[Row]]] = (
    ensembles,
    single_scenes,
    samples,
    records,
    layers,
    kernel_calls,
    threads,
)


def most_memory() -> float:
    """Gigabytes that solving a million scenes takes at most, with all that is imported."""
    import resource  # not on Windows

    together("constant", ACCURACY, frictions(MANY))
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024**2


def page(levels: Mapping[str, Sequence[Row]], memory: float) -> Iterator[str]:
    """Lines of Markdown: a table with a measure in each line, and all processors."""
    yield "| us a scene | " + " | ".join(f"{level}: ours | beside | ratio" for level in levels) + " |"
    yield "|---" * (1 + 3 * len(levels)) + "|"
    for rows in zip(*levels.values(), strict=True):
        cells = [f"{1e6 * r.ours:.3g} | {r.peer} {1e6 * r.theirs:.3g} | {r.ours / r.theirs:.2f}" for r in rows]
        yield f"| {rows[0].measure} | {' | '.join(cells)} |"
    yield f"\nA million scenes take {memory:.2f} GB of memory. {machine()}, heyoka {hy.__version__}."


def exact_run_outs(mu: Floats) -> Floats:
    """Rotations at rest by Taylor series in ball arithmetic."""
    given = {"arc": oracle.plain(ARC), "effects": dict(VAIONT.called), "initial_velocity": 0.0, "end_time": None}
    solved = [taylor.solve(given | {"friction": friction(DRAWN, x)}, digits=24) for x in mu.tolist()]
    return np.array([float(found["run_out"]) / float(ARC.radius) for found in solved])


def curve(ways: Iterable[Callable[[Floats], Floats]], mu: Floats, checked: int) -> list[tuple[float, float]]:
    """Seconds of one scene by each way, and the largest relative error of the run-out of so many of them."""
    lanes = np.unique(np.linspace(0, mu.size - 1, checked).astype(int))
    exact = exact_run_outs(mu[lanes])
    errors = [float(np.max(np.abs(way(mu)[0, lanes] / exact - 1))) for way in ways]
    return list(zip(medians([partial(way, mu) for way in ways], mu.size), errors, strict=True))


def panels() -> Iterator[tuple[str, dict[str, list[tuple[float, float]]]]]:
    """Title, and points by name of the way, each for all tolerances; ours alone is always solved to rounding."""
    others = {
        "heyoka, one by one": partial(alone, DRAWN),
        "DOP853 (SciPy)": partial(by_scipy, "DOP853", DRAWN),
        "LSODA (SciPy)": partial(by_scipy, "LSODA", DRAWN),
    }
    mu = frictions(COUNT)
    yield (
        f"one of {COUNT:,} scenes",
        {
            "slipcircle": curve([partial(together, DRAWN, x) for x in TOLERANCES], mu, CHECKED),
            f"heyoka, batches of {BATCHES[-1]}": curve(
                [in_batches(DRAWN, x, BATCHES[-1]) for x in TOLERANCES], mu, CHECKED
            ),
            **{name: curve([way(x) for x in TOLERANCES], frictions(CHECKED), CHECKED) for name, way in others.items()},
        },
    )
    yield (
        "one scene; ours with peak and error estimate",
        {
            "slipcircle": curve([partial(one_by_one, one_scene(DRAWN))], ONE, 1),
            **{name: curve([way(x) for x in TOLERANCES], ONE, 1) for name, way in others.items()},
        },
    )


def picture(path: Path) -> None:
    """Error against time, for an ensemble and for one scene."""

    def draw(figure: Any) -> None:
        styles: dict[str, Any] = {}
        for axes, (title, ways) in zip(figure.subplots(1, 2, sharey=True), panels(), strict=True):
            for name, points in ways.items():
                colour, dashes, marker = styles.setdefault(name, SERIES[len(styles)])
                seconds, errors = np.transpose(points)
                axes.plot(seconds, np.maximum(errors, LEAST), color=colour, ls=dashes, marker=marker, label=name)
            axes.set(title=title, xscale="log", yscale="log", xlabel="processor time (s)")
            axes.grid(alpha=0.3)
        figure.suptitle(f"{DRAWN} softening")
        figure.axes[0].set_ylabel("largest relative error of the run-out")
        figure.legend(*figure.axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=5, fontsize=9)

    path.write_bytes(render(draw, (9.0, 4.4), str(path)))


def measured(level: str) -> list[Row]:
    """Return the rows by the binary of a level."""
    environment = {**os.environ, "SLIPCIRCLE_COMPILED": level}
    command = [sys.executable, "-m", "tests.campaigns.speed"]
    done = subprocess.run(command, env=environment, check=True, stdout=subprocess.PIPE, text=True)
    return [Row(*row) for row in json.loads(done.stdout)]


def main() -> None:
    """Print the page, or what one level measures."""
    if LEVEL in WIDE:
        rows: list[Row] = []
        for measure in MEASURES:
            print(f"{LEVEL}: {measure.__name__}", file=sys.stderr)
            rows += measure()
        print(json.dumps(rows))
        return
    levels = {level: measured(level) for level in WIDE if level in BINARY.LEVELS}
    with ProcessPoolExecutor(1, get_context("spawn")) as pool:
        memory = pool.submit(most_memory).result()
    print("\n".join(page(levels, memory)))
    if len(sys.argv) > 1:
        picture(Path(sys.argv[1]))


if __name__ == "__main__":
    main()
