"""`slipcircle sweep`: a scene on a grid of values, or for samples of its uncertain numbers."""

import argparse
import sys
from collections.abc import Callable
from concurrent.futures import BrokenExecutor, CancelledError
from dataclasses import replace
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.base import files
from slipcircle.base.distributions import DISTRIBUTIONS
from slipcircle.files.scenefile import find, load
from slipcircle.motion.quantities import OUTCOMES, shown, words
from slipcircle.motion.states import Status
from slipcircle.outputs import pictures, studyplots, tables
from slipcircle.outputs.studyreport import interval, parts, study_report
from slipcircle.scene.scene import Scene
from slipcircle.studies import written
from slipcircle.studies.conduct import ensemble, grid
from slipcircle.studies.design import METHODS
from slipcircle.studies.engines import ENGINES, engine
from slipcircle.studies.statistics import Estimate
from slipcircle.studies.study import Study

UNITS = {n: q.unit for n, q in OUTCOMES.items()}
_MOST_ROWS = 60  # of a grid, on the screen


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--samples", type=_count, metavar="N", help="draw the scene's uncertain numbers N times: 1e6")
    what.add_argument("--grid", action="append", metavar="KEY=FROM:TO:COUNT", help="solve at these values, or at "
                      "KEY=A,B,C; all combinations where given more than once: friction.angle_deg=8:12:41; a point's "
                      "coordinate by its number from 0: ground.points_m.3.y=20:30:5")  # fmt: skip
    parser.add_argument("--uncertain", action="append", default=[], metavar="KEY=NAME:A:B", help="a distribution in "
                        "place of the file's number: friction.angle_deg=normal:10:1")  # fmt: skip
    parser.add_argument("--correlation", action="append", default=[], metavar="KEY,KEY=R", help="of two uncertain "
                        "numbers: friction.angle_deg,cohesion.cohesion_kPa=-0.5")  # fmt: skip
    parser.add_argument("--seed", type=int, help="repeats a run bit by bit; by default a new one, which is told")
    parser.add_argument("--method", choices=METHODS, default=METHODS[0], help="how to draw; default %(default)s")
    parser.add_argument("--sensitivity", type=int, metavar="N", help="base points of the sensitivity indices")
    parser.add_argument("--block", type=int, metavar="N", help="samples of a block, a power of two; larger ones, such "
                        "as 262144, keep more workers busy than a scheduler can otherwise serve")  # fmt: skip
    parser.add_argument("--engine", choices=ENGINES, default=ENGINES[0], help="where to compute; default %(default)s")
    parser.add_argument("--workers", type=int, metavar="N", help="threads or processes; by default all processors")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="of a running Dask cluster: tcp://10.0.0.1:8786")
    parser.add_argument("--resume", metavar="FOLDER", help="keep finished blocks here, and continue from those there")
    parser.add_argument("--plot", metavar="FILE", action="append", default=[], help="draw exceedance curves and "
                        "which unknown matters, or a grid of one or two numbers; .png, .svg, .pdf or .jpg")  # fmt: skip
    parser.add_argument("--report", metavar="FILE", help="write a report for a reviewer, one HTML file")
    parser.add_argument("--csv", metavar="FILE", help="write one table of all results")
    parser.add_argument("--npz", metavar="FILE", help="write all results as NumPy arrays, the samples where kept")


def _count(text: str) -> int:
    """1000000, or 1e6."""
    value = float(text)
    if value != int(value):
        raise ValueError
    return int(value)


def run(options: argparse.Namespace) -> Study:
    """Compute what the options ask for, and write the files."""
    scene = load(options.scene)
    if options.uncertain:
        drawn = _drawn(options.uncertain)
        others = {name: u for name, u in scene.uncertain.items() if u.key not in drawn}
        scene = replace(scene, uncertain=others | drawn)
    if options.report and options.grid:
        raise ValueError("sweep: --report: of samples, not of a grid; give --plot, --csv or --npz")
    if options.plot and options.grid:
        studyplots.check_grid([len(x) for x in _levels(options.grid).values()])
    content = find(options.scene).read_bytes()
    try:
        found = _compute(scene, options)
    except (BrokenExecutor, CancelledError) as error:  # processes, Dask
        kept = "the same command continues" if options.resume else "with --resume FOLDER it could continue"
        raise ValueError(f"--engine {options.engine}: a worker died; {kept}") from error
    for path in options.plot:
        files.write(path, pictures.study(found, path))
    if options.report:
        files.write(options.report, study_report(found, content, options.line).encode())
    if options.csv:
        files.write(options.csv, _csv(found))
    if options.npz:
        with files.replacing(options.npz) as file:
            _savez(file, written.arrays(found))
    return found


def _compute(scene: Scene, options: argparse.Namespace) -> Study:
    with engine(options.engine, options.workers, options.scheduler) as executor:
        if options.grid:
            return grid(scene, _levels(options.grid), executor, folder=options.resume, progress=sys.stderr)
        return ensemble(
            scene, options.samples, options.seed, executor, method=options.method, sensitivity=options.sensitivity,
            size=options.block, folder=options.resume, progress=sys.stderr, correlation=_pairs(options.correlation),
        )  # fmt: skip


def _savez(file: IO[bytes], arrays: dict[str, NDArray[Any]]) -> None:
    np.savez(file, **arrays)  # type: ignore[arg-type]


def _parsed(option: str, given: list[str], form: str, read: Callable[[str, str], Any]) -> dict[str, Any]:
    """What stands in KEY=VALUE of the command line, by key; each key once."""
    found: dict[str, Any] = {}
    said = []
    for text in given:
        key, _, value = text.partition("=")
        try:
            if key in found:
                raise ValueError
            found[key] = read(key, value)
        except ValueError:
            said.append(f"--{option} {text}: must be {form}")
    if said:
        raise ValueError("; ".join(said))
    return found


def _drawn(given: list[str]) -> dict[str, dict[str, Any]]:
    """Distributions by key, as a scene file has them."""

    def read(_: str, value: str) -> dict[str, Any]:
        name, *numbers = value.split(":")
        wanted = DISTRIBUTIONS[name].parameters if name in DISTRIBUTIONS else ()
        return {"distribution": name} | dict(zip(wanted, map(float, numbers), strict=True))

    forms = ", ".join(":".join((n, *d.parameters)) for n, d in DISTRIBUTIONS.items())
    return _parsed("uncertain", given, f"KEY=, each key once, and one of {forms}", read)


def _pairs(given: list[str]) -> dict[tuple[str, str], float]:
    """Correlations by their keys."""

    def read(keys: str, value: str) -> float:
        _, _ = keys.split(",")
        return float(value)

    form = "KEY,KEY=R, each pair once, such as friction.angle_deg,cohesion.cohesion_kPa=-0.5"
    found = _parsed("correlation", given, form, read)
    return {(one, other): r for keys, r in found.items() for one, other in [keys.split(",")]}


def _levels(given: list[str]) -> dict[str, NDArray[np.float64]]:
    """Values by key."""

    def read(_: str, values: str) -> NDArray[np.float64]:
        if values.count(":") == 2:
            first, last, count = values.split(":")
            return np.linspace(float(first), float(last), int(count))
        return np.array([float(v) for v in values.split(",")])

    form = "KEY=FROM:TO:COUNT or KEY=A,B,C, each key once, such as friction.angle_deg=8:12:41"
    return _parsed("grid", given, form, read)


def _csv(found: Study) -> bytes:
    if found.design.method == "grid":
        return files.table(*grid_rows(found))
    rows = ([None if x != x else x for x in row] for row in written.rows(found))
    return files.table(("table", "output", "input", "at", "value", "low", "high"), rows)


def grid_rows(found: Study) -> tuple[list[str], list[list[Any]]]:
    """One row a scene: inputs in their keys' units, outputs, status, and why there is no answer."""
    units = (f"{n} ({unit})" for n, unit in UNITS.items())
    head = [*(u.key for u in found.design.inputs.values()), *units, "status", "reason"]
    columns = [values.tolist() for name, values in found.samples.items() if name != "status"]
    kinds = [Status(s) for s in found.samples["status"].tolist()]
    return head, [[*row, s.name, s.reason] for *row, s in zip(*columns, kinds, strict=True)]


def record(found: Study) -> Any:
    """As JSON holds it."""
    if found.design.method != "grid":
        return written.record(found)
    head, rows = grid_rows(found)
    cells = ([None if isinstance(x, float) and np.isnan(x) else x for x in row] for row in rows)
    return {"scene": found.scene.name, "rows": [dict(zip(head, row, strict=True)) for row in cells]}


def show(found: Study) -> None:
    """Print tables."""
    study, head = found.design, [words(n, unit) for n, unit in UNITS.items()]
    if study.method == "grid":
        _, rows = grid_rows(found)
        if len(rows) > _MOST_ROWS:
            said = ", ".join(f"{count} {words(Status(s).name)}" for s, count in enumerate(found.counts) if count)
            print(f"{len(rows)} scenes: {said}; for every one of them give --csv FILE, --npz FILE or --json")
            return
        cells = [[*map(shown, numbers), words(status) + (f": {why}" if why else "")] for *numbers, status, why in rows]
        tables.show([*(u.key for u in study.inputs.values()), *head, "status"], cells, found.scene.name)
        return
    print(f"{found.scene.name}: {study.n} samples, {study.method}, seed {found.seed}\n")
    for part in parts(found):
        cells = [[interval(c) if isinstance(c, Estimate) else c for c in row] for row in part.rows]
        tables.show(part.head or [""] * len(cells[0]), cells, part.title, part.note)
