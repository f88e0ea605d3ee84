"""What is written of an ensemble: as JSON, as one table for CSV, and as arrays for NPZ, all from one list of estimates.

A value that cannot be given is null in JSON, empty in CSV and NaN in NPZ; a quantile among samples that slide to no
known end is "beyond", "beyond" and infinite.
"""

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.core import Status
from slipcircle.workbench.common.quantities import OUTCOMES
from slipcircle.workbench.studies.statistics import BEYOND, Estimate

QUANTILES = (0.01, 0.05, 0.25, 0.5, 0.75, 0.9, 0.95, 0.99)
HEAD = ("table", "output", "input", "at", "value", "low", "high")


class Row(NamedTuple):
    """One estimate: which statistic of which output, by which input, at which value."""

    table: str
    output: str
    input: str
    at: float
    estimate: Estimate


_Groups = dict[tuple[str, str], list[Row]]


def estimates(study: Any) -> Iterator[Row]:
    """Every estimate of a study."""
    yield Row("probability of moving", "moves", "", math.nan, study.moving)
    for method, failure in study.failure.items():
        yield Row("probability of failure", "factor_of_safety", method, math.nan, failure)
        for p in QUANTILES:
            yield Row("quantile of the factor", "factor_of_safety", method, p, study.factor_quantile(method, p))
    for name in OUTCOMES:
        yield from _of_output(study, name)
    keys = [u.key for u in study.design.inputs.values()]
    for output, indices in study.sensitivity.items():
        for key, first, total in zip(keys, *indices, strict=True):
            yield Row("first-order index", output, key, math.nan, first)
            yield Row("total index", output, key, math.nan, total)
    for c in study.convergence:
        yield Row("moving after n", "moves", "", c.n, c.moving)
        yield Row("median after n", "run_out", "", c.n, c.median)
        yield Row("quantile 0.95 after n", "run_out", "", c.n, c.upper)


def _of_output(study: Any, name: str) -> Iterator[Row]:
    """Mean and standard deviation, quantiles and the exceedance curve of an output."""
    yield Row("mean", name, "", math.nan, study.mean(name))
    yield Row("std", name, "", math.nan, study.std(name))
    if name in study.linear:
        mean, std = (Estimate(moment, math.nan, math.nan) for moment in study.linear[name])
        yield Row("linear mean", name, "", math.nan, mean)
        yield Row("linear std", name, "", math.nan, std)
    for p in QUANTILES:
        yield Row("quantile", name, "", p, study.quantile(name, p))
    curve = np.stack(study.exceedance(name), axis=1)
    for at, *probability in curve.tolist():
        yield Row("exceedance", name, "", at, Estimate(*probability))


def _grouped(study: Any) -> _Groups:
    """The same by table and output; a pair that there is none of is not among them."""
    groups: _Groups = {}
    for row in estimates(study):
        groups.setdefault((row.table, row.output), []).append(row)
    return groups


def rows(study: Any) -> list[list[Any]]:
    """The same as rows of one CSV file, under `HEAD`."""
    return [[table, output, key, _cell(at), *map(_cell, e)] for table, output, key, at, e in estimates(study)]


def record(study: Any) -> dict[str, Any]:
    """As JSON holds it: SI units but for inputs."""
    design, groups = study.design, _grouped(study)
    failure = groups.get(("probability of failure", "factor_of_safety"), ())
    return {
        "scene": study.scene.name,
        "inputs": [u.record for u in design.drawn.values()],
        "correlation": design.correlations,
        "method": design.method,
        "samples": design.n,
        "valid_samples": study.n,
        "samples_without_result": study.without_result,
        "samples_outside_range": study.outside_range,
        "seed": study.seed,
        "block": study.size,
        "accuracy": design.accuracy,
        "confidence": study.confidence,
        "status": {s.name: int(study.counts[s]) for s in Status},
        "moving": _record(study.moving),
        "probability_of_failure": {row.input: _record(row.estimate) for row in failure},
        "outputs": {name: _output(study, groups, name) for name in OUTCOMES},
        "no_linear": study.no_linear or None,
        "sensitivity_base": design.base,
        "sensitivity": [
            {"output": output, "input": first.input, "first": _record(first.estimate), "total": _record(total.estimate)}
            for output in study.sensitivity
            for first, total in zip(groups["first-order index", output], groups["total index", output], strict=True)
        ],
        "convergence": [
            {"n": c.n, "moving": _record(c.moving), "run_out_median": _record(c.median), "run_out_95": _record(c.upper)}
            for c in study.convergence
        ],
        "warnings": study.warnings,
    }


def _output(study: Any, groups: _Groups, name: str) -> dict[str, Any]:
    """The statistics of one output, as JSON holds them."""
    exceedance = groups.get(("exceedance", name), ())
    return {
        "unit": OUTCOMES[name].unit,
        "mean": _record(groups["mean", name][0].estimate),
        "std": _record(groups["std", name][0].estimate),
        "linear": study.linear[name]._asdict() if name in study.linear else None,
        "quantiles": [{"p": row.at} | _record(row.estimate) for row in groups["quantile", name]],
        "exceedance": [{"at": row.at} | _record(row.estimate, "probability") for row in exceedance],
    }


def arrays(study: Any) -> dict[str, NDArray[Any]]:
    """Return the samples as arrays by name: inputs by key, results and status."""
    return {f"sample_{name}": values for name, values in study.samples.items()}


def _record(estimate: Estimate, value: str = "value") -> dict[str, Any]:
    """An estimate as JSON holds it."""
    return dict(zip((value, "low", "high"), map(_cell, estimate), strict=True))


def _cell(value: float) -> float | str | None:
    """A number of a file: none where it is not given."""
    if math.isnan(value):
        return None
    return value if math.isfinite(value) else BEYOND
