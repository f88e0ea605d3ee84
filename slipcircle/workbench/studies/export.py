"""Conversions of a study: estimates as JSON and as one table for CSV, results as arrays, tables and datasets.

An unknown value is null in JSON, empty in CSV and NaN in NPZ. A quantile among samples that slide without a known end
is "beyond" in JSON and CSV and infinite in NPZ.
"""

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.kinds import Columns, Names, ValueDict
from slipcircle.base.optional import optional
from slipcircle.core import Status
from slipcircle.workbench.common.quantities import OUTCOMES, json_values
from slipcircle.workbench.studies.design import RESULTS
from slipcircle.workbench.studies.statistics import BEYOND, Estimate, distribution

QUANTILES = (0.01, 0.05, 0.25, 0.5, 0.75, 0.9, 0.95, 0.99)
_Variables = dict[str, tuple[Names, NDArray[Any]]]  # arrays by name, each with the names of its axes
HEAD = ("table", "output", "input", "at", "value", "low", "high")


class ExportRow(NamedTuple):
    """One estimate: statistic, output, input (or method), value of the output or probability, and estimate."""

    table: str
    output: str
    input: str
    at: float
    estimate: Estimate


def estimates(study: Any) -> Iterator[ExportRow]:
    """Yield all estimates of a study, one row each."""
    yield ExportRow("probability of moving", "moves", "", math.nan, study.moving)
    for method, failure in study.failure.items():
        yield ExportRow("probability of failure", "factor_of_safety", method, math.nan, failure)
        for p in QUANTILES:
            yield ExportRow("quantile of the factor", "factor_of_safety", method, p, study.factor_quantile(method, p))
    for name in OUTCOMES:
        yield from _of_output(study, name)
    for output, indices in study.sensitivity.items():
        for key, first, total in zip(study.design.keys, *indices, strict=True):
            yield ExportRow("first-order index", output, key, math.nan, first)
            yield ExportRow("total index", output, key, math.nan, total)
    for c in study.convergence:
        yield ExportRow("moving after n", "moves", "", c.n, c.moving)
        yield ExportRow("median after n", "run_out", "", c.n, c.median)
        yield ExportRow("quantile 0.95 after n", "run_out", "", c.n, c.upper)


def _of_output(study: Any, name: str) -> Iterator[ExportRow]:
    """Yield the mean, standard deviation, quantiles and exceedance curve of an output, named as in `OUTCOMES`."""
    yield ExportRow("mean", name, "", math.nan, study.mean(name))
    yield ExportRow("std", name, "", math.nan, study.std(name))
    if name in study.linear:
        mean, std = (Estimate(moment, math.nan, math.nan) for moment in study.linear[name])
        yield ExportRow("linear mean", name, "", math.nan, mean)
        yield ExportRow("linear std", name, "", math.nan, std)
    for p in QUANTILES:
        yield ExportRow("quantile", name, "", p, study.quantile(name, p))
    for at, probability in _curve(study, name):
        yield ExportRow("exceedance", name, "", at, probability)


def _curve(study: Any, name: str) -> Iterator[tuple[float, Estimate]]:
    """Yield values of an output, each with the probability of exceeding it."""
    for at, *probability in np.stack(study.exceedance(name), axis=1).tolist():
        yield at, Estimate(*probability)


def rows(study: Any) -> list[list[Any]]:
    """Return the estimates as rows of one CSV file, under `HEAD`."""
    return [[table, output, key, _cell(at), *map(_cell, e)] for table, output, key, at, e in estimates(study)]


def study_record(study: Any) -> ValueDict:
    """Return a study as a mapping for JSON, in SI units except for inputs."""
    design = study.design
    common = {
        "scene": study.scene.name,
        "inputs": [uncertain.record for uncertain in design.drawn.values()],
        "correlation": design.correlations,
        "method": design.method,
        "seed": design.seed,
        "accuracy": design.accuracy,
        "warnings": study.warnings,
    }
    return common | (_of_samples(study) if design.records is None else _under_records(study))


def _of_samples(study: Any) -> ValueDict:
    """Return the counts, estimates and curves of independent samples for JSON."""
    design = study.design
    return {
        "samples": design.n,
        "valid_samples": study.n,
        "samples_without_result": study.without_result,
        "samples_outside_range": study.outside_range,
        "block": study.size,
        "confidence": study.confidence,
        "status": {s.name: int(study.counts[s]) for s in Status},
        "moving": _record(study.moving),
        "probability_of_failure": {method: _record(estimate) for method, estimate in study.failure.items()},
        "outputs": {name: _output(study, name) for name in OUTCOMES},
        "no_linear": study.no_linear or None,
        "sensitivity_base": design.base,
        "sensitivity": [
            {"output": output, "input": key, "first": _record(first), "total": _record(total)}
            for output, indices in study.sensitivity.items()
            for key, first, total in zip(design.keys, *indices, strict=True)
        ],
        "convergence": [
            {"n": c.n, "moving": _record(c.moving), "run_out_median": _record(c.median), "run_out_95": _record(c.upper)}
            for c in study.convergence
        ],
    }


def _output(study: Any, name: str) -> ValueDict:
    """Return the statistics of one output for JSON."""
    return {
        "unit": OUTCOMES[name].unit,
        "mean": _record(study.mean(name)),
        "std": _record(study.std(name)),
        "linear": study.linear[name]._asdict() if name in study.linear else None,
        "quantiles": [{"p": p} | _record(study.quantile(name, p)) for p in QUANTILES],
        "exceedance": [{"at": at} | _record(estimate, "probability") for at, estimate in _curve(study, name)],
    }


def _under_records(study: Any) -> ValueDict:
    """Return records, axes, results (record, polarity, scale, sample) and statistics for JSON, in SI units."""
    records = study.records
    displacement = study.displacement
    described = {
        **study.suite.to_dict(),
        "polarities": records.polarities,
        "scale_is": "pga_g" if records.to_pga else "factor",
        "yield_coefficient": study.yield_coefficient,
        "block_factor": study.block_factor,
        "distribution": [
            {"scale": scale} | distribution(displacement, k)._asdict() for k, scale in enumerate(study.scales.tolist())
        ],
        "fragility": [curve.to_dict() for curve in study.fragility()],
        "exceedance": study.fragility_columns(),
        "median_record": study.suite.entries[study.median_record(study.own_scale)].name,
    }
    results = {name: values for name, values in arrays(study).items() if name not in ("record", "polarity", "sample")}
    return dict(json_values(described | results))


# --- results ---------------------------------------------------------------------------------------------------------


def study_axes(study: Any) -> Columns:
    """Return the axes of the results by name: keys of a grid, or samples, preceded by the axes of records if any."""
    design = study.design
    if design.method == "grid":
        return dict(zip(design.keys, design.levels, strict=True))
    samples = {"sample": np.arange(design.n)}
    if design.records is None:
        return samples
    names = np.array([entry.name for entry in study.suite])
    return {"record": names, "polarity": study.polarities, "scale": study.scales} | samples


def _variables(study: Any) -> _Variables:
    """Return axes, factors of records, inputs of samples, and results by name, each with the names of its axes."""
    levels = study_axes(study)
    shape = [len(values) for values in levels.values()]
    variables: _Variables = {name: ((name,), values) for name, values in levels.items()}
    if study.design.records is not None:
        variables |= {name: (("record", "scale"), x) for name, x in (("factor", study.factors), ("pga_g", study.pga))}
    if study.design.method != "grid":
        variables |= {key: (("sample",), values) for key, values in study.inputs.items()}
    return variables | {name: (tuple(levels), values.reshape(shape)) for name, values in study.values.items()}


def arrays(study: Any) -> Columns:
    """Return axes, inputs (as ``sample_`` followed by the key) and results as arrays by name."""
    sampled = () if study.design.method == "grid" else study.inputs
    variables = _variables(study).items()
    return {f"sample_{name}" if name in sampled else name: values for name, (_, values) in variables}


def study_columns(study: Any) -> Columns:
    """Return all scenes as columns by name, one element for each scene; without records, outcomes are magnitudes."""
    variables = _variables(study)
    _, status = variables.pop("status")
    columns = {}
    for name, (dims, values) in variables.items():
        place = tuple(slice(None) if axis in dims else None for axis in study_axes(study))
        columns[name] = np.broadcast_to(values[place], status.shape).ravel()
    columns |= {name: study.samples.get(name, values).ravel() for name, values in study.values.items()}
    words = {"status": [s.name for s in Status], "reason": [s.reason for s in Status]}
    return columns | {name: np.array(of_status)[status.ravel()] for name, of_status in words.items()}


def frame(study: Any) -> Any:
    """Return the `study_columns` as a pandas.DataFrame, with units in ``attrs``."""
    table = optional("pandas", "to_pandas").DataFrame(study_columns(study))
    if study.design.method != "grid":
        table = table.set_index([*study_axes(study)])
    table.attrs["units"] = {**RESULTS, **{number.key: number.written for number in study.design.inputs.values()}}
    return table


def dataset(study: Any) -> Any:
    """Return the results as an xarray.Dataset with units; ``status`` has the integers of `Status`."""
    coordinates = _variables(study)
    results = {name: (*coordinates.pop(name), {"units": RESULTS.get(name, "")}) for name in study.values}
    return optional("xarray", "to_xarray").Dataset(results, coordinates)


def _record(estimate: Estimate, value: str = "value") -> ValueDict:
    """Return an estimate as a mapping for JSON; its value has the given key."""
    return dict(zip((value, "low", "high"), map(_cell, estimate), strict=True))


def _cell(value: float) -> float | str | None:
    """Return a number for a file: None for NaN, the text `BEYOND` for infinity."""
    if math.isnan(value):
        return None
    return value if math.isfinite(value) else BEYOND
