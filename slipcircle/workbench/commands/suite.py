"""`slipcircle sweep --records`: options and tables of a scene shaken by each record of a suite."""

import argparse
import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from slipcircle.base.text import amount_text, number_text
from slipcircle.core import Scene
from slipcircle.workbench.commands import values
from slipcircle.workbench.commands.records import FORMATS, add_reading, add_synthetic, records_part, suite_of
from slipcircle.workbench.outputs.tables import ResultTable, unit_table
from slipcircle.workbench.studies.ensemble import ensemble
from slipcircle.workbench.studies.fragility import interval_note
from slipcircle.workbench.studies.statistics import distribution, exceedance_probabilities, variance_shares
from slipcircle.workbench.studies.study import Study
from slipcircle.workbench.suites.regressions import Comparison

_HEADS = {  # of columns of `Study.by_record`, with SI units
    "record": ("record", ""),
    "pga_g": ("PGA (g)", ""),
    "displacement_m": ("recorded", "m"),
    "reversed_m": ("reversed", "m"),
    "mean_m": ("mean", "m"),
    "peak_velocity_m_s": ("v", "m/s"),
    "slips": ("slips", ""),
    "rotation_rad": ("phi (deg)", ""),
}


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options of a study over records to a parser."""
    group = parser.add_argument_group("earthquake records", "the records replace the scene's own shaking")
    group.add_argument("--records", nargs="+", metavar="PATH", help=FORMATS)
    add_synthetic(group)
    group.add_argument("--polarities", action="store_true", help="use each record with both signs")
    scale = group.add_mutually_exclusive_group()
    scale.add_argument(
        "--scale", type=values.levels, metavar="FROM:TO:COUNT", help="scale factors of the records: 0.5:2:7, or 1,2"
    )
    pga = "scale each record to these peak accelerations in g: 0.1:0.5:5, or 0.35"
    scale.add_argument("--scale-to-pga", type=values.levels, metavar="FROM:TO:COUNT", help=pga)
    thresholds = "displacements in m for exceedance and fragility; default 0.01,0.05,0.15,1"
    group.add_argument("--thresholds", type=values.levels, metavar="A,B,C", help=thresholds)
    points = "write exceedance and fragility curves at every threshold and scale as a table, CSV"
    group.add_argument("--fragility", metavar="FILE", help=points)
    group.add_argument(
        "--magnitude", type=float, metavar="M", help="magnitude of the earthquakes, for regressions that need it"
    )
    period = "fundamental period of the sliding mass, s, for Bray and Travasarou (2007); default 0, a rigid mass"
    group.add_argument("--period", type=float, metavar="S", help=period)
    add_reading(group)


def study(scene: Scene, options: argparse.Namespace, **sampling: Any) -> Study:
    """Return the study of a scene under the records that the options select; ``sampling`` is passed to `ensemble`."""
    suite = suite_of(options, float(np.ravel(scene.arc.gravity)[0]))
    scales = {"scales": options.scale, "scale_to_pga": options.scale_to_pga, "thresholds": options.thresholds}
    of_records = {"records": suite, "polarities": options.polarities} | scales
    if not options.samples:
        scene = replace(scene, uncertain={})
    elif not scene.uncertain:
        raise ValueError(
            "sweep: --samples: the scene has no uncertain parameter; give --uncertain, or leave --samples out"
        )
    return ensemble(scene, options.samples or 1, **sampling, **of_records)


def suite_tables(study: Study, compared: Sequence[Comparison]) -> Iterator[ResultTable]:
    """Yield the tables of a study over records: records, displacements, statistics, fragility and regressions."""
    yield records_part(study.suite)
    scale = study.own_scale
    yield _by_record_part(study, scale)
    yield _statistics_part(study)
    yield _exceedance_part(study)
    yield _fragility_part(study)
    if compared:
        yield _regressions_part(study, compared, scale)
    shares = variance_shares(study.displacement, scale)
    if shares.records == shares.records and study.values["status"].shape[-1] > 1:
        rows = [[name, f"{100 * share:.3g} %"] for name, share in shares._asdict().items()]
        yield ResultTable(["source alone", "share of the variance"], rows, f"displacement at {study.scale_text(scale)}")


def _by_record_part(study: Study, scale: int) -> ResultTable:
    """Return a table of the displacement, peak velocity, slips and rotation for each record at a scale's index."""
    columns = study.by_record(scale)
    columns["rotation_rad"] = np.rad2deg(columns["rotation_rad"]).tolist()
    samples = study.values["status"].shape[-1]
    of_samples = f"; medians of {samples} samples" if samples > 1 else ""
    others = f", one of {study.scales.size} (--csv has all)" if study.scales.size > 1 else ""
    title = f"{study.scene.name}: displacement along the arc at {study.scale_text(scale)}{others}{of_samples}"
    note = "v: peak velocity; slips: how often it begins to slide; phi: rotation at the end"
    note += "; the greater of both polarities" if len(study.polarities) > 1 else ""
    return unit_table(dict(_HEADS[name] for name in columns), zip(*columns.values(), strict=True), title, note)


def _statistics_part(study: Study) -> ResultTable:
    """Return a table of the distribution of displacements at each scale."""
    lengths = dict.fromkeys(("mean", "16 %", "median", "84 %", "geometric"), "m")
    units = {"": "", "moving": "", **lengths, "std of ln D": ""}
    rows = []
    for k in range(study.scales.size):
        moving, mean, median, p16, p84, geometric, std_ln = distribution(study.displacement, k)
        rows.append([study.scale_text(k), f"{100 * moving:.3g} %", mean, p16, median, p84, geometric, std_ln])
    note = "geometric mean, and standard deviation of ln D, of those that move"
    return unit_table(units, rows, "distribution of the displacement D", note)


def _regressions_part(study: Study, compared: Sequence[Comparison], scale: int) -> ResultTable:
    """Return a table of published regressions and the displacements at a scale, with notes on their ranges.

    ``compared`` are the comparisons at this scale, given by its index.
    """
    units = {"regression": "", "in range": "", "predicted": "m", "ln ratio": "", "std": "", "published std": ""}
    factor = number_text(study.block_factor)
    divided = f"displacements are divided by {factor}, the ratio of the displacement on the arc to that of a block"
    notes = [divided, "ln ratio: mean over the records"]
    rows = []
    for c in compared:
        rows.append([c.name, f"{c.records} of {c.of}", c.predicted, c.mean, c.std, c.std_ln])
        if not c.records:
            notes.append(f"{c.name} applies to {c.valid}")
        if not math.isnan(c.negligible):
            shares = f"{100 * c.negligible:.1f} % of the records, computed {100 * c.negligible_computed:.1f} %"
            notes.append(f"{c.name} counts displacements above 1 cm only; at most 1 cm for {shares}")
    k_y = number_text(study.yield_coefficient)
    title = f"displacement at {study.scale_text(scale)} over that of a rigid block with k_y = {k_y} by regressions"
    return unit_table(units, rows, title, "; ".join(notes))


def _exceedance_part(study: Study) -> ResultTable:
    """Return a table of exceedance probabilities at each scale."""
    thresholds = study.records.thresholds
    levels = exceedance_probabilities(study.displacement, thresholds)
    pga = [] if study.records.to_pga else np.median(study.pga, axis=0)[:, None].tolist()
    head = ["", *["PGA (g)"] * bool(pga), *(f"D > {amount_text(d, 'm')}" for d in thresholds.tolist())]
    rows = [[study.scale_text(k), *(pga[k] if pga else []), *levels[k]] for k in range(len(levels))]
    median = "" if study.records.to_pga else "PGA: median of the records; "
    note = f"{median}95 % intervals, of as many draws as there are records"
    return ResultTable(head, rows, "probability that D exceeds a threshold", note)


def _fragility_part(study: Study) -> ResultTable:
    """Return a table of lognormal fragility curves, with the reason where a curve is missing."""
    head = ["", "median PGA (g)", "dispersion", "no curve"]
    curves = study.fragility()
    rows = [[f"D > {amount_text(c.threshold, 'm')}", c.median, c.dispersion, c.reason or "-"] for c in curves]
    if not any(curve.reason for curve in curves):
        head, rows = head[:-1], [row[:-1] for row in rows]
    title = "lognormal fragility: probability Phi(ln(PGA/median)/dispersion) that D exceeds a threshold"
    return ResultTable(head, rows, title, f"greatest likelihood; {interval_note(len(study.suite))}")
