"""`slipcircle sweep`: a scene on a grid of values, or for samples of its uncertain numbers."""

import argparse
import csv
import io
import sys
from concurrent.futures import BrokenExecutor
from dataclasses import replace
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from slipcircle import Scene
from slipcircle.arrays.block import Status
from slipcircle.outputs import tables
from slipcircle.studies.distributions import DISTRIBUTIONS
from slipcircle.studies.engines import ENGINES, engine, replacing, write
from slipcircle.studies.ensembles import QUANTILES, Ensemble, ensemble, grid
from slipcircle.studies.estimates import Estimate
from slipcircle.studies.study import BIN_ERROR, METHODS, OUTPUTS

_MOST_ROWS = 60  # of a grid, on the screen


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--samples", type=int, metavar="N", help="draw the scene's uncertain numbers N times")
    what.add_argument("--grid", action="append", metavar="KEY=FROM:TO:COUNT", help="solve at these values, or at "
                      "KEY=A,B,C; all combinations where given more than once: friction.angle_deg=8:12:41")  # fmt: skip
    parser.add_argument("--uncertain", action="append", default=[], metavar="KEY=NAME:A:B", help="a distribution in "
                        "place of the file's number: friction.angle_deg=normal:10:1")  # fmt: skip
    parser.add_argument("--seed", type=int, help="repeats a run bit by bit; by default a new one, which is told")
    parser.add_argument("--method", choices=METHODS, default=METHODS[0], help="how to draw; default %(default)s")
    parser.add_argument("--sensitivity", type=int, metavar="N", help="base points of the sensitivity indices")
    parser.add_argument("--block", type=int, metavar="N", help="samples of a block, a power of two; larger ones, such "
                        "as 262144, keep more workers busy than a scheduler can otherwise serve")  # fmt: skip
    parser.add_argument("--engine", choices=ENGINES, default=ENGINES[0], help="where to compute; default %(default)s")
    parser.add_argument("--workers", type=int, metavar="N", help="threads or processes; by default all processors")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="of a running Dask cluster: tcp://10.0.0.1:8786")
    parser.add_argument("--resume", metavar="FOLDER", help="keep finished blocks here, and continue from those there")
    parser.add_argument("--csv", metavar="FILE", help="write one table of all results")
    parser.add_argument("--npz", metavar="FILE", help="write all results as NumPy arrays, the samples where kept")


def run(options: argparse.Namespace) -> Ensemble:
    """Compute what the options ask for, and write the files."""
    scene = Scene.load(options.scene)
    if options.uncertain:
        drawn = _drawn(options.uncertain)
        others = {name: u for name, u in scene.uncertain.items() if u.key not in drawn}
        scene = replace(scene, uncertain=others | drawn)
    for path in filter(None, (options.csv, options.npz)):
        if not Path(path).parent.is_dir():  # said before the work, not after it
            raise ValueError(f"{path}: there is no folder {Path(path).parent}")
    try:
        found = _compute(scene, options)
    except BrokenExecutor as error:
        kept = "the same command continues" if options.resume else "with --resume FOLDER it could continue"
        raise ValueError(f"--engine {options.engine}: a worker died; {kept}") from error
    if options.csv:
        write(options.csv, _csv(found).encode())
    if options.npz:
        with replacing(options.npz) as file:
            _savez(file, found.arrays())
    return found


def _compute(scene: Scene, options: argparse.Namespace) -> Ensemble:
    with engine(options.engine, options.workers, options.scheduler) as executor:
        if options.grid:
            return grid(scene, _levels(options.grid), executor, folder=options.resume, progress=sys.stderr)
        return ensemble(
            scene, options.samples, options.seed, executor, method=options.method, sensitivity=options.sensitivity,
            size=options.block, folder=options.resume, progress=sys.stderr,
        )  # fmt: skip


def _savez(file: IO[bytes], arrays: dict[str, NDArray[Any]]) -> None:
    np.savez(file, **arrays)  # type: ignore[arg-type]


def _drawn(given: list[str]) -> dict[str, dict[str, Any]]:
    """Distributions by key from the command line, as a scene file has them."""
    found: dict[str, dict[str, Any]] = {}
    said = []
    for text in given:
        key, _, value = text.partition("=")
        name, *numbers = value.split(":")
        wanted = DISTRIBUTIONS[name].parameters if name in DISTRIBUTIONS else ()
        try:
            if key in found:
                raise ValueError
            found[key] = {"distribution": name} | dict(zip(wanted, map(float, numbers), strict=True))
        except ValueError:
            forms = ", ".join(":".join((n, *d.parameters)) for n, d in DISTRIBUTIONS.items())
            said.append(f"--uncertain {text}: must be KEY=, each key once, and one of {forms}")
    if said:
        raise ValueError("; ".join(said))
    return found


def _levels(given: list[str]) -> dict[str, NDArray[np.float64]]:
    """Values by key from the command line."""
    found: dict[str, NDArray[np.float64]] = {}
    said = []
    for text in given:
        key, _, values = text.partition("=")
        try:
            if key in found:
                raise ValueError
            if values.count(":") == 2:
                first, last, count = values.split(":")
                found[key] = np.linspace(float(first), float(last), int(count))
            else:
                found[key] = np.array([float(v) for v in values.split(",")])
        except ValueError:
            said.append(f"--grid {text}: must be KEY=FROM:TO:COUNT or KEY=A,B,C, each key once, such as "
                        "friction.angle_deg=8:12:41")  # fmt: skip
    if said:
        raise ValueError("; ".join(said))
    return found


def _csv(found: Ensemble) -> str:
    text = io.StringIO()
    out = csv.writer(text, lineterminator="\n")
    if found.study.method == "grid":
        head, rows = grid_rows(found)
        out.writerow(head)
        out.writerows(rows)
        return text.getvalue()
    out.writerow(["table", "output", "input", "at", "value", "low", "high"])
    out.writerows(["" if isinstance(x, float) and np.isnan(x) else x for x in row] for row in found.rows())
    return text.getvalue()


def grid_rows(found: Ensemble) -> tuple[list[str], list[list[Any]]]:
    """One row a scene: inputs in their keys' units, outputs, status."""
    head = [*(u.key for u in found.study.inputs.values()), *(f"{n} ({unit})" for n, unit in OUTPUTS.items()), "status"]
    columns = [values.tolist() for name, values in found.samples.items() if name != "status"]
    names = [Status(s).name for s in found.samples["status"].tolist()]
    return head, [list(row) for row in zip(*columns, names, strict=True)]


def record(found: Ensemble) -> Any:
    """As JSON holds it."""
    if found.study.method != "grid":
        return found.record()
    head, rows = grid_rows(found)
    cells = ([None if isinstance(x, float) and np.isnan(x) else x for x in row] for row in rows)
    return {"scene": found.scene.name, "rows": [dict(zip(head, row, strict=True)) for row in cells]}


def _pm(e: Estimate, digits: str = ".4g") -> str:
    ends = ", ".join("?" if np.isnan(x) else f"{x:{digits}}" for x in (e.low, e.high))
    return f"{e.value:{digits}} [{ends}]" if not np.isnan(e.value) else "-"


def show(found: Ensemble) -> None:
    """Print tables."""
    study = found.study
    if study.method == "grid":
        head, rows = grid_rows(found)
        if len(rows) > _MOST_ROWS:
            said = ", ".join(f"{count} {Status(s).name}" for s, count in enumerate(found.counts) if count)
            print(f"{len(rows)} scenes: {said}; for every one of them give --csv FILE, --npz FILE or --json")
            return
        tables.show(head, [[f"{x:.6g}" if isinstance(x, float) else x for x in row] for row in rows], found.scene.name)
        return
    percent = f"{100 * found.confidence:g} %"
    tables.show(
        ["quantile", *(f"{n.replace('_', ' ')}, {unit}" for n, unit in OUTPUTS.items())],
        [[f"{p:g}", *(_pm(found.quantile(n, p), ".5g") for n in OUTPUTS)] for p in QUANTILES],
        f"{found.scene.name}: {study.n} samples, {study.method}, seed {found.seed}",
        f"probability of moving {_pm(found.moving, '.6g')}; {percent} intervals"
        + ("" if found.samples else f"; from bins of a relative width of {BIN_ERROR:.1e}, by which values may be off"),
    )
    chosen = (0.5, 0.1, 0.01)
    curve = {n: found.exceedance(n) for n in ("run_out", "peak_velocity")}
    tables.show(
        ["exceeded with probability", *(f"{n.replace('_', ' ')}, {OUTPUTS[n]}" for n in curve)],
        [[f"{p:g}", *(f"{found.quantile(n, 1 - p).value:.5g}" for n in curve)] for p in chosen],
        "Exceedance", "the curves are in --csv, --npz and --json",
    )  # fmt: skip
    if found.sensitivity:
        rows = []
        for output, of in found.sensitivity.items():
            for u, first, total in zip(study.inputs.values(), *of, strict=True):
                rows.append([output.replace("_", " "), u.key, _pm(first, ".3f"), _pm(total, ".3f")])
        tables.show(["output", "input", "first-order index", "total index"], rows, "Which unknown matters",
                    f"from {study.base} base points")  # fmt: skip
    tables.show(
        ["samples", "probability of moving", "median run-out, m", "95 % quantile, m"],
        [[str(c.n), _pm(c.moving), _pm(c.median, ".5g"), _pm(c.upper, ".5g")] for c in found.convergence],
        "Convergence",
    )
