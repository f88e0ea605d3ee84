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
from slipcircle.workbench.studies.statistics import BEYOND, BIN_ERROR, Estimate

QUANTILES = (0.01, 0.05, 0.25, 0.5, 0.75, 0.9, 0.95, 0.99)
HEAD = ("table", "output", "input", "at", "value", "low", "high")


class Row(NamedTuple):
    """One estimate: which statistic of which output, by which input, at which value."""

    table: str
    output: str
    input: str
    at: float
    estimate: Estimate


def estimates(study: Any) -> Iterator[Row]:
    """Every estimate of a study."""
    yield Row("probability of moving", "moves", "", math.nan, study.moving)
    for method, failure in study.failure.items():
        yield Row("probability of failure", "factor_of_safety", method, math.nan, failure)
    for name in OUTCOMES:
        yield Row("mean", name, "", math.nan, study.mean(name))
        yield Row("std", name, "", math.nan, study.std(name))
        for statistic, value in study.linear[name]._asdict().items() if name in study.linear else ():
            yield Row(f"linear {statistic}", name, "", math.nan, Estimate(value, math.nan, math.nan))
        for p in QUANTILES:
            yield Row("quantile", name, "", p, study.quantile(name, p))
        for at, *probability in np.stack(study.exceedance(name), axis=1).tolist():
            yield Row("exceedance", name, "", at, Estimate(*probability))
    keys = [u.key for u in study.design.inputs.values()]
    for output, indices in study.sensitivity.items():
        for kind, by_input in (("first-order index", indices.first), ("total index", indices.total)):
            for key, estimate in zip(keys, by_input, strict=True):
                yield Row(kind, output, key, math.nan, estimate)
    for c in study.convergence:
        yield Row("moving after n", "moves", "", c.n, c.moving)
        yield Row("median after n", "reach", "", c.n, c.median)
        yield Row("95 % quantile after n", "reach", "", c.n, c.upper)


def _grouped(study: Any) -> dict[tuple[str, str], list[Row]]:
    """The same by table and output; a pair that there is none of is not among them."""
    found = dict[tuple[str, str], list[Row]]()
    for row in estimates(study):
        found.setdefault((row.table, row.output), []).append(row)
    return found


def rows(study: Any) -> list[list[Any]]:
    """The same as rows of one CSV file, under `HEAD`."""
    return [[table, output, key, _cell(at), *map(_cell, e)] for table, output, key, at, e in estimates(study)]


def record(study: Any) -> dict[str, Any]:
    """As JSON holds it: SI units but for inputs."""
    design, groups = study.design, _grouped(study)
    outputs = {}
    for name, quantity in OUTCOMES.items():
        outputs[name] = {
            "unit": quantity.unit,
            "mean": _record(groups["mean", name][0]),
            "std": _record(groups["std", name][0]),
            "linear": study.linear[name]._asdict() if name in study.linear else None,
            "quantiles": [{"p": row.at} | _record(row) for row in groups["quantile", name]],
            "exceedance": [_record(row, "at", "probability") for row in groups.get(("exceedance", name), ())],
        }
    indices = [
        {"output": output, "input": first.input, "first": _record(first), "total": _record(total)}
        for output in study.sensitivity
        for first, total in zip(groups["first-order index", output], groups["total index", output], strict=True)
    ]
    after = [groups.get(group, []) for group in _CONVERGENCE.values()]
    convergence = [
        {"n": row[0].at} | {name: _record(r) for name, r in zip(_CONVERGENCE, row, strict=True)}
        for row in zip(*after, strict=True)
    ]
    return {
        "scene": study.scene.name,
        "inputs": [u.record for u in design.drawn.values()],
        "method": design.method,
        "samples": design.n,
        "valid_samples": study.n,
        "samples_without_result": study.without_result,
        "seed": study.seed,
        "block": study.size,
        "accuracy": design.accuracy,
        "confidence": study.confidence,
        "bin_error": 0.0 if study.samples else BIN_ERROR,
        "status": {s.name: int(study.counts[s]) for s in Status},
        "moving": _record(groups["probability of moving", "moves"][0]),
        "probability_of_failure": {
            row.input: _record(row) for row in groups.get(("probability of failure", "factor_of_safety"), ())
        },
        "outputs": outputs,
        "no_linear": study.no_linear or None,
        "sensitivity_base": design.base,
        "sensitivity": indices,
        "convergence": convergence,
        "warnings": study.warnings,
    }


_CONVERGENCE = {  # the key in JSON of each table over the number of samples
    "moving": ("moving after n", "moves"),
    "reach_median": ("median after n", "reach"),
    "reach_95": ("95 % quantile after n", "reach"),
}


def arrays(study: Any) -> dict[str, NDArray[Any]]:
    """Everything as arrays by name: quantiles and curves as rows of (at, value, low, high), bins, samples.

    Means, standard deviations and probabilities as (value, low, high), the linear ones as (mean, standard deviation).
    """
    groups = _grouped(study)
    named: dict[str, NDArray[Any]] = {"status_counts": study.counts, "moving": np.array(study.moving)}
    named |= {f"failure_{method}": np.array(estimate) for method, estimate in study.failure.items()}
    for name in OUTCOMES:
        for statistic in ("mean", "std"):
            named[f"{name}_{statistic}"] = np.array(groups[statistic, name][0].estimate)
        if name in study.linear:
            named[f"{name}_linear"] = np.array(study.linear[name])
        named[f"{name}_quantiles"] = _curve(groups["quantile", name])
        named[f"{name}_exceedance"] = _curve(groups.get(("exceedance", name), []))
        named[f"{name}_bins"] = study.bins(name)
    for output, indices in study.sensitivity.items():
        named[f"{output}_first_order"], named[f"{output}_total"] = np.array(indices.first), np.array(indices.total)
    named["inputs"] = np.array([u.key for u in study.design.inputs.values()])
    named["convergence"] = np.array([(c.n, *c.moving, *c.median, *c.upper) for c in study.convergence])
    return named | {f"sample_{k}": v for k, v in study.samples.items()}


def _curve(rows: list[Row]) -> NDArray[np.float64]:
    return np.array([(row.at, *row.estimate) for row in rows]).reshape(-1, 4)


def _record(row: Row, at: str = "", value: str = "value") -> dict[str, Any]:
    """An estimate as JSON holds it, with the place that it is of where that has a name."""
    place = {at: row.at} if at else {}
    return place | dict(zip((value, "low", "high"), map(_cell, row.estimate), strict=True))


def _cell(value: float) -> float | str | None:
    """A number of a file: none where it is not given."""
    if math.isnan(value):
        return None
    return value if math.isfinite(value) else BEYOND
