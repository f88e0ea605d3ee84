"""`slipcircle sweep`: an ensemble or a grid of one scene, its table and files."""

import argparse
import sys
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import BrokenExecutor, CancelledError
from dataclasses import replace
from typing import Any, cast

import numpy as np

from slipcircle.base.text import shown
from slipcircle.core import Scene, Status
from slipcircle.workbench.commands import values
from slipcircle.workbench.commands.common import REPORT, add_files, add_scene
from slipcircle.workbench.common import files
from slipcircle.workbench.common.distributions import DISTRIBUTIONS
from slipcircle.workbench.common.quantities import OUTCOMES
from slipcircle.workbench.files.numbers import uncertain_numbers
from slipcircle.workbench.files.scenefile import find, load
from slipcircle.workbench.outputs import pictures, studyplots
from slipcircle.workbench.outputs.report import parts, study_report
from slipcircle.workbench.outputs.tables import Answer, Part
from slipcircle.workbench.studies import export
from slipcircle.workbench.studies.design import METHODS
from slipcircle.workbench.studies.engines import ENGINES, engine
from slipcircle.workbench.studies.ensemble import ensemble, grid
from slipcircle.workbench.studies.study import Study

HELP = "a scene on a grid of values, or for samples of its uncertain numbers"
_MOST_ROWS = 60  # of a grid, on the screen


def options(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument(
        "--samples", type=values.count, metavar="N", help="draw the scene's uncertain numbers N times: 1e6"
    )
    what.add_argument(
        "--grid",
        action="append",
        metavar="KEY=FROM:TO:COUNT",
        help="solve at these values, or at "
        "KEY=A,B,C; all combinations where given more than once: friction.angle_deg=8:12:41; a point's "
        "coordinate by its number from 0: ground.points_m.3.y=20:30:5",
    )
    parser.add_argument(
        "--uncertain",
        action="append",
        default=[],
        metavar="KEY=NAME:A:B",
        help="a distribution in place of the file's number: friction.angle_deg=normal:10:1",
    )
    parser.add_argument(
        "--correlation",
        action="append",
        default=[],
        metavar="KEY,KEY=R",
        help="of two uncertain numbers: friction.angle_deg,cohesion.cohesion_kPa=-0.5",
    )
    parser.add_argument("--seed", type=int, help="repeats a run bit by bit; by default random; printed")
    parser.add_argument("--method", choices=METHODS, default=METHODS[0], help="how to draw; default %(default)s")
    parser.add_argument("--sensitivity", type=int, metavar="N", help="base points of the sensitivity indices")
    parser.add_argument(
        "--block",
        type=int,
        metavar="N",
        help="samples of a block, a power of two; larger ones, such "
        "as 262144, keep more workers busy than a scheduler can otherwise serve",
    )
    parser.add_argument("--engine", choices=ENGINES, default=ENGINES[0], help="where to compute; default %(default)s")
    parser.add_argument("--workers", type=int, metavar="N", help="how many at once; by default one a processor")
    parser.add_argument(
        "--scheduler",
        metavar="ADDRESS",
        help="of a running Dask cluster, tcp://10.0.0.1:8786; without it --engine dask starts one on this machine",
    )
    parser.add_argument("--resume", metavar="FOLDER", help="keep finished blocks here, and continue from those there")
    picture = "exceedance curves and which unknown matters, or a grid of one or two numbers"
    arrays = "all results as NumPy arrays, the samples where kept"
    add_files(parser, picture, report=REPORT, csv="one table of all results", npz=arrays)
    add_scene(parser)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    if options.report and options.grid:
        raise ValueError("sweep: --report: of samples, not of a grid; give --plot, --csv or --npz")
    scene = _with_uncertain(load(options.scene), options.uncertain)
    form = "KEY=FROM:TO:COUNT or KEY=A,B,C, each key once, such as friction.angle_deg=8:12:41"
    levels = values.by_key("grid", options.grid or [], form, values.levels)
    if options.plot and levels:
        studyplots.check_grid([len(level) for level in levels.values()])
    source = find(options.scene).read_bytes()
    try:
        study = _compute(scene, levels, options)
    except (BrokenExecutor, CancelledError) as error:
        kept = "the same command continues" if options.resume else "with --resume FOLDER it could continue"
        raise ValueError(f"--engine {options.engine}: a worker died; {kept}") from error
    head, rows, record, parts = _grid_tables(study) if levels else _sample_tables(study)
    pictures.write(options.plot, "study", study)
    if options.report:
        files.write(options.report, study_report(study, source, options.line).encode())
    if options.csv:
        files.write(options.csv, files.table(head, rows))
    if options.npz:
        with files.replacing(options.npz) as file:
            np.savez(file, **cast(dict[str, Any], export.arrays(study)))
    return Answer(record, parts, [f"{scene.name}: {warning}" for warning in study.warnings])


def _with_uncertain(scene: Scene, texts: list[str]) -> Scene:
    """The scene with distributions of `--uncertain` in place of the file's."""
    if not texts:
        return scene
    forms = [":".join((name, *kind.parameters)) for name, kind in DISTRIBUTIONS.items()]
    form = f"KEY=, each key once, and one of {', '.join(forms)}"
    drawn = values.by_key("uncertain", texts, form, values.distribution)
    of_file = uncertain_numbers(scene)
    others = {name: number for name, number in of_file.items() if number.key not in drawn}
    return replace(scene, uncertain=others | drawn)


def _compute(scene: Scene, levels: Mapping[str, Any], options: argparse.Namespace) -> Study:
    with engine(options.engine, options.workers, options.scheduler) as executor:
        if levels:
            return grid(scene, levels, executor, folder=options.resume, progress=sys.stderr)
        form = "KEY,KEY=R, each pair once, such as friction.angle_deg,cohesion.cohesion_kPa=-0.5"
        pairs = values.by_key("correlation", options.correlation, form, float)
        return ensemble(
            scene,
            options.samples,
            options.seed,
            executor,
            method=options.method,
            sensitivity=options.sensitivity,
            size=options.block,
            folder=options.resume,
            progress=sys.stderr,
            correlation=cast(Any, {tuple(keys.split(",")): r for keys, r in pairs.items()}),
        )


_Tables = tuple[Iterable[str], Iterable[Any], Callable[[], Any], Iterable[Part | str]]  # CSV's head, rows; JSON; text


def _grid_tables(study: Study) -> _Tables:
    """A row a scene: inputs in their keys' units, outputs, status, and why there is no result."""
    keys, name = [number.key for number in study.design.inputs.values()], study.scene.name
    head = [*keys, *(f"{outcome} ({q.unit})" for outcome, q in OUTCOMES.items()), "status", "reason"]
    *columns, ends = (column.tolist() for column in study.samples.values())
    rows = [[*row, Status(end).name, Status(end).reason] for *row, end in zip(*columns, ends, strict=True)]
    record = [{"scene": name, "rows": [dict(zip(head, row, strict=True)) for row in rows]}]
    if len(rows) > _MOST_ROWS:
        counts = ", ".join(f"{Status(end).words}: {count}" for end, count in enumerate(study.counts) if count)
        text = f"{len(rows)} scenes; {counts}; for every one of them give --csv FILE, --npz FILE or --json"
        return head, rows, lambda: record, [text]
    cells = [[*map(shown, numbers), reason or Status[end].words] for *numbers, end, reason in rows]
    table = Part([*keys, *(q.heading for q in OUTCOMES.values()), "status"], cells, name)
    return head, rows, lambda: record, [table]


def _sample_tables(study: Study) -> _Tables:
    """Every estimate of a study with its interval."""
    title = f"{study.scene.name}: {study.design.n} samples, {study.design.method}, seed {study.seed}\n"
    return export.HEAD, export.rows(study), lambda: [export.record(study)], [title, *parts(study)]
