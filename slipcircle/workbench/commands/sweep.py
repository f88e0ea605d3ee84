"""`slipcircle sweep`: solve a scene on a grid, for samples or under earthquake records."""

import argparse
import math
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import BrokenExecutor, CancelledError
from dataclasses import replace
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import NumberDict, ValueDict, Values
from slipcircle.base.text import number_text, output_unit
from slipcircle.core import Scene, Status
from slipcircle.workbench.commands import suite
from slipcircle.workbench.commands import values as read
from slipcircle.workbench.commands.common import REPORT, add_files, add_scene
from slipcircle.workbench.common import files
from slipcircle.workbench.common.distributions import DISTRIBUTIONS
from slipcircle.workbench.common.quantities import OUTCOMES, spelt_out
from slipcircle.workbench.common.starting import method_of
from slipcircle.workbench.files.numbers import uncertain_numbers
from slipcircle.workbench.files.scenefile import load
from slipcircle.workbench.files.shipped import find
from slipcircle.workbench.outputs.pictures import studyplots
from slipcircle.workbench.outputs.pictures.files import picture
from slipcircle.workbench.outputs.report import study_report
from slipcircle.workbench.outputs.studytables import study_tables
from slipcircle.workbench.outputs.tables import Answer, Files, ResultTable, unit_table
from slipcircle.workbench.studies import export
from slipcircle.workbench.studies.design import FACTOR, METHODS
from slipcircle.workbench.studies.engines import ENGINES, open_executor
from slipcircle.workbench.studies.ensemble import ensemble, grid
from slipcircle.workbench.studies.study import Study

_MOST_ROWS, _MOST_COLUMNS = 60, 25  # of a printed grid
_GRID_QUANTILES = (0.05, 0.5, 0.95)


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to a parser."""
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--samples", type=read.count, metavar="N", help="draw the scene's uncertain numbers N times: 1e6")
    what.add_argument(
        "--grid",
        action="append",
        metavar="KEY=FROM:TO:COUNT",
        help="solve at these values: friction.angle_deg=8:12:41; or KEY=A,B,C; if repeated, solve all combinations; "
        "coordinates of a point, counted from 0: ground.points_m.3.y=20:30:5",
    )
    parser.add_argument(
        "--uncertain",
        action="append",
        default=[],
        metavar="KEY=NAME:A:B",
        help="distribution that replaces the value in the file: friction.angle_deg=normal:10:1",
    )
    parser.add_argument(
        "--correlation",
        action="append",
        default=[],
        metavar="KEY,KEY=R",
        help="correlation of two uncertain parameters: friction.angle_deg,cohesion.cohesion_kPa=-0.5",
    )
    everything = "print also other methods, linear propagation, convergence and the intensities of earthquake records"
    parser.add_argument("--verbose", action="store_true", help=everything)
    parser.add_argument("--seed", type=int, help="reproduces a run exactly; default: random, and printed")
    parser.add_argument("--method", choices=METHODS, default=METHODS[0], help="sampling method; default %(default)s")
    each = "also search the critical circle of every sample, for its factors of safety; 10 to 40 samples a second"
    parser.add_argument("--search-each", action="store_true", help=each)
    parser.add_argument("--sensitivity", type=int, metavar="N", help="base points of the sensitivity indices")
    parser.add_argument(
        "--block",
        type=int,
        metavar="N",
        help="samples in a block, a power of two; large blocks, such as "
        "262144, reduce the load of the scheduler when many workers are used",
    )
    parser.add_argument(
        "--engine", choices=ENGINES, default=ENGINES[0], help="engine of the computation; default %(default)s"
    )
    parser.add_argument("--workers", type=int, metavar="N", help="number of workers; default: one for each processor")
    parser.add_argument(
        "--scheduler",
        metavar="ADDRESS",
        help="compute on a running Dask cluster instead of this machine, such as tcp://10.0.0.1:8786",
    )
    parser.add_argument(
        "--resume",
        metavar="FOLDER",
        help="store finished blocks in this folder, and continue from blocks already stored",
    )
    picture = "exceedance curves and sensitivity indices, a grid of one or two parameters, or displacements by record"
    arrays = "all results as NumPy arrays, including samples if they are kept"
    suite.options(parser)
    add_files(parser, picture, report=REPORT, csv="one table of all results", npz=arrays)
    add_scene(parser)


def run(options: argparse.Namespace) -> Answer:
    """Run the study that the options select and return its answer."""
    _check_options(options)
    scene = _with_distributions(load(options.scene), options.uncertain)
    form = "KEY=FROM:TO:COUNT or KEY=A,B,C, each key once, such as friction.angle_deg=8:12:41"
    levels = read.values_by_key("grid", options.grid or [], form, read.levels)
    if options.plot and levels:
        studyplots.check_grid([len(values) for values in levels.values()])
    content = find(options.scene).read_bytes()
    try:
        study = _compute(scene, levels, options)
    except (BrokenExecutor, CancelledError) as error:
        remedy = (
            "run the command again to continue" if options.resume else "give --resume FOLDER to keep finished blocks"
        )
        raise ValueError(f"sweep: a worker or the scheduler died; {remedy}") from error
    if study.design.records is not None:
        tables = _of_records(study, options)
    else:
        tables = _of_grid(study) if levels else _of_samples(study)
    kind = "study" if study.design.records is None else "suite"
    contents: Files = {
        "plot": partial(picture, kind, study),
        "report": lambda _: study_report(study, content, options.line, tables.parts(True), tables.record()).encode(),
        "csv": lambda _: files.csv_table(tables.head, tables.rows()),
        "npz": lambda _: files.npz_content(export.arrays(study)),
        "fragility": lambda _: _table(study.fragility_columns()),
    }
    warnings = [f"{scene.name}: {warning}" for warning in study.warnings]
    record = tables.record if kind == "suite" else lambda: [tables.record()]
    return Answer(record, tables.parts(options.verbose), warnings, contents)


def _check_options(options: argparse.Namespace) -> None:
    """Raise ValueError for missing options and for options that cannot be combined."""
    under_records = options.records or options.synthetic
    if not (options.samples or options.grid or under_records):
        raise ValueError("sweep: give --samples N, --grid KEY=FROM:TO:COUNT, or --records FOLDER")
    if options.report and options.grid:
        raise ValueError("sweep: --report: is available for samples, not for a grid; give --plot, --csv or --npz")
    if options.search_each and options.grid:
        raise ValueError("sweep: --search-each: is available for samples, not for a grid; leave it out")
    if under_records and options.grid:
        raise ValueError("sweep: --records and --grid exclude each other; give --uncertain and --samples")
    of_records = ("polarities", "scale", "scale_to_pga", "thresholds", "fragility", "magnitude", "period")
    absent = (None, False)
    used = [name for name in of_records if not any(getattr(options, name) is value for value in absent)]
    if used and not under_records:
        names = ", ".join(f"--{name.replace('_', '-')}" for name in used)
        raise ValueError(f"sweep: {names}: for earthquake records only; give --records FOLDER as well")
    if options.units and not under_records:
        raise ValueError(f"sweep: --units {options.units}: must be SI or US; other units are those of --records")
    if options.period is not None and not 0.0 <= options.period < math.inf:
        raise ValueError(f"sweep: --period {options.period:g}: must be a time in s, at least 0")


def _table(columns: Mapping[str, Sequence[Any]]) -> bytes:
    """Return columns by head as the bytes of a CSV file."""
    return files.csv_table(columns, zip(*columns.values(), strict=True))


def _with_distributions(scene: Scene, texts: Sequence[str]) -> Scene:
    """Return the scene with the distributions of ``--uncertain``, texts ``KEY=NAME:A:B`` that precede the file's."""
    if not texts:
        return scene
    forms = (":".join((name, *d.parameters)) for name, d in DISTRIBUTIONS.items())
    form = f"KEY=, each key once, and one of {', '.join(forms)}"
    drawn = read.values_by_key("uncertain", texts, form, read.distribution_parameters)
    others = {name: u for name, u in uncertain_numbers(scene).items() if u.key not in drawn}
    return replace(scene, uncertain=others | drawn)


def _compute(scene: Scene, levels: Values, options: argparse.Namespace) -> Study:
    """Return the study of a scene on a grid of levels by key, if there are any, under records or for samples."""
    with open_executor(options.engine, options.workers, options.scheduler) as executor:
        if levels:
            return grid(scene, levels, executor, folder=options.resume, progress=sys.stderr)
        form = "KEY,KEY=R, each pair once, such as friction.angle_deg,cohesion.cohesion_kPa=-0.5"
        pairs = read.values_by_key("correlation", options.correlation, form, float)
        settings: ValueDict = {
            "rng": options.seed,
            "executor": executor,
            "method": options.method,
            "sensitivity": options.sensitivity,
            "size": options.block,
            "folder": options.resume,
            "progress": sys.stderr,
            "search_each": options.search_each,
            "correlation": {tuple(keys.split(",")): r for keys, r in pairs.items()},
        }
        if options.records or options.synthetic:
            return suite.study(scene, options, **settings)
        return ensemble(scene, options.samples, **settings)


class _Tables(NamedTuple):
    """Results of a study: head and rows of the CSV file, JSON record, and tables, verbose or brief."""

    head: Sequence[str]
    rows: Callable[[], Iterable[Sequence[Any]]]
    record: Callable[[], Any]
    parts: Callable[[bool], Sequence[ResultTable | str]]


def _of_records(study: Study, options: argparse.Namespace) -> _Tables:
    """Return the results of a study over records: displacements, their statistics, fragility and regressions."""
    magnitude = math.nan if options.magnitude is None else options.magnitude
    compared = study.regressions(study.own_scale, magnitude, options.period or 0.0)
    record = study.to_dict() | {"regressions": [c._asdict() for c in compared]}
    columns = {name: column.tolist() for name, column in study.columns().items()}
    tables = [*suite.suite_tables(study, compared)]

    def parts(verbose: bool) -> Sequence[ResultTable | str]:
        return tables if verbose else tables[1:]  # `slipcircle records` prints the first

    return _Tables([*columns], lambda: zip(*columns.values(), strict=True), lambda: record, parts)


def _of_grid(study: Study) -> _Tables:
    """Return one row for each scene of a grid: inputs in their keys' units, outputs, status and reason of a failure."""
    keys = study.design.keys
    factors = [name for name in study.samples if name.startswith(FACTOR)]
    head = [*keys, *(f"{n} ({q.unit})" for n, q in OUTCOMES.items()), *factors, "status", "reason"]
    *columns, statuses = (study.samples[name].tolist() for name in (*keys, *OUTCOMES, *factors, "status"))
    rows = [[*row, Status(s).name, Status(s).reason] for *row, s in zip(*columns, statuses, strict=True)]

    def record() -> Any:
        scenes = [dict(zip(head, row, strict=True)) for row in rows]
        shared = {"factors_of_safety": _factors_of_grid(study), "outside_range": study.outside_range}
        return {"scene": study.scene.name, "rows": scenes} | shared

    return _Tables(head, lambda: rows, record, lambda _: [_grid_part(study, keys, statuses)])


def _grid_part(study: Study, keys: Sequence[str], statuses: Sequence[int]) -> ResultTable | str:
    """Return a table of the outcomes on a grid, run-outs for two inputs; for a large grid, the counts by status.

    ``keys`` are those of the inputs; ``statuses`` has the integer of `Status` of each scene.
    """
    ends = [Status(s).reason or Status(s).words for s in statuses]
    counts = ", ".join(f"{Status(s).words}: {count}" for s, count in enumerate(study.counts) if count)
    part = _run_outs(study, keys, ends, counts) if len(keys) == 2 else _outcomes(study, keys, ends)
    if len(part.rows) <= _MOST_ROWS and len(part.head) <= _MOST_COLUMNS:
        return part
    return f"{len(statuses)} scenes; {counts}; give --csv FILE, --npz FILE or --json for the results"


def _run_outs(study: Study, keys: Sequence[str], ends: Sequence[str], note: str) -> ResultTable:
    """Return a table of the run-outs on a grid of two inputs; cells without a run-out show the status.

    ``keys`` are those of the inputs, ``ends`` the statuses of all scenes as text.
    """
    down, along = (level.tolist() for level in study.design.levels)
    run_outs = study.samples["run_out"].tolist()
    factor, _ = output_unit(OUTCOMES["run_out"].unit)
    cells = [w if math.isnan(r) else factor * r for r, w in zip(run_outs, ends, strict=True)]
    rows = [[at, *cells[k * len(along) : (k + 1) * len(along)]] for k, at in enumerate(down)]
    title = f"{study.scene.name}: {OUTCOMES['run_out'].heading} by {keys[0]} (rows) and {keys[1]} (columns)"
    return ResultTable([keys[0], *map(number_text, along)], rows, title, note)


def _outcomes(study: Study, keys: Sequence[str], ends: Sequence[str]) -> ResultTable:
    """Return a table with one row for each scene of a grid: inputs, outcomes, starting factor of safety, status.

    ``keys`` are those of the inputs, ``ends`` the statuses of all scenes as text.
    """
    method = method_of(study.scene)
    heads = {key: (key, "") for key in keys} | {name: (spelt_out(name), q.unit) for name, q in OUTCOMES.items()}
    heads[f"{FACTOR}{method}"] = f"F, {method}", ""
    names = [name for name in heads if name in study.samples]
    units = dict(heads[name] for name in names) | {"status": ""}
    columns = [study.samples[name].tolist() for name in names]
    return unit_table(units, zip(*columns, ends, strict=True), study.scene.name)


def _factors_of_grid(study: Study) -> dict[str, NumberDict]:
    """Return the share of combinations with a factor of safety below 1, and quantiles of the factor, by method.

    Combinations without a factor of safety are left out.
    """
    shares = {}
    for name, values in study.samples.items():
        finite = values[~np.isnan(values)]
        if name.startswith(FACTOR) and finite.size:
            quantiles = np.quantile(finite, _GRID_QUANTILES, method="inverted_cdf").tolist()
            named = {f"quantile_{p}": value for p, value in zip(_GRID_QUANTILES, quantiles, strict=True)}
            shares[name.removeprefix(FACTOR)] = {"below_1": float(np.mean(finite < 1.0)), **named}
    return shares


def _of_samples(study: Study) -> _Tables:
    """Return all estimates of a study with their intervals."""
    design = study.design
    drawn = [f"{design.n} samples", design.method, f"seed {study.seed}", *filter(None, [design.correlations_text])]
    title = f"{study.scene.name}: {', '.join(drawn)}\n"
    return _Tables(
        export.HEAD, lambda: export.rows(study), study.to_dict, lambda verbose: [title, *study_tables(study, verbose)]
    )
