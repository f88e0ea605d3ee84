"""What is written of an ensemble: as JSON, as one table for CSV, and as arrays for NPZ."""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.core.motion.states import Status
from slipcircle.workbench.common.quantities import OUTCOMES
from slipcircle.workbench.studies.statistics import BIN_ERROR, Estimate

QUANTILES = (0.01, 0.05, 0.25, 0.5, 0.75, 0.9, 0.95, 0.99)


def record(found: Any) -> dict[str, Any]:
    """As JSON holds it: SI units but for inputs, null for what cannot be said."""
    outputs = {}
    for name, quantity in OUTCOMES.items():
        curve = found.exceedance(name)
        outputs[name] = {
            "unit": quantity.unit,
            "mean": _estimate(found.mean(name)),
            "std": _estimate(found.std(name)),
            "linear": found.linear[name]._asdict() if name in found.linear else None,
            "quantiles": [{"p": p} | _estimate(found.quantile(name, p)) for p in QUANTILES],
            "exceedance": [dict(zip(curve._fields, row, strict=True)) for row in np.stack(curve, axis=1).tolist()],
        }
    return {
        "scene": found.scene.name,
        "inputs": [u.record for u in found.design.drawn.values()],
        "method": found.design.method,
        "samples": found.design.n,
        "seed": found.seed,
        "block": found.size,
        "accuracy": found.design.accuracy,
        "confidence": found.confidence,
        "bin_error": 0.0 if found.samples else BIN_ERROR,
        "status": {s.name: int(found.counts[s]) for s in Status},
        "moving": _estimate(found.moving),
        "outputs": outputs,
        "no_linear": found.no_linear or None,
        "sensitivity_base": found.design.base,
        "sensitivity": [
            {"output": output, "input": u.key, "first": _estimate(first), "total": _estimate(total)}
            for output, indices in found.sensitivity.items()
            for u, first, total in zip(found.design.inputs.values(), *indices, strict=True)
        ],
        "convergence": [
            {
                "n": c.n,
                "moving": _estimate(c.moving),
                "reach_median": _estimate(c.median),
                "reach_95": _estimate(c.upper),
            }
            for c in found.convergence
        ],
        "warnings": found.warnings,
    }


def rows(found: Any) -> list[tuple[str, str, str, float, float, float, float]]:
    """One table of everything: what, output, input, at which value, and the estimate with its interval."""
    table: list[tuple[str, str, str, float, float, float, float]] = []
    table.append(("probability of moving", "moves", "", math.nan, *found.moving))
    for name in OUTCOMES:
        table += [("mean", name, "", math.nan, *found.mean(name)), ("std", name, "", math.nan, *found.std(name))]
        for what, value in found.linear[name]._asdict().items() if name in found.linear else ():
            table.append((f"linear {what}", name, "", math.nan, value, math.nan, math.nan))
        table += [("quantile", name, "", p, *found.quantile(name, p)) for p in QUANTILES]
        table += [("exceedance", name, "", *row) for row in np.stack(found.exceedance(name), axis=1).tolist()]
    for output, indices in found.sensitivity.items():
        for kind, estimates in zip(("first-order index", "total index"), indices, strict=True):
            keys = (u.key for u in found.design.inputs.values())
            table += [(kind, output, key, math.nan, *e) for key, e in zip(keys, estimates, strict=True)]
    for c in found.convergence:
        table.append(("moving after n", "moves", "", c.n, *c.moving))
        table.append(("median after n", "reach", "", c.n, *c.median))
        table.append(("95 % quantile after n", "reach", "", c.n, *c.upper))
    return table


def arrays(found: Any) -> dict[str, NDArray[Any]]:
    """Everything as arrays by name: quantiles and curves as rows of (at, value, low, high), bins, samples.

    Means and standard deviations as (value, low, high), the linear ones as (mean, standard deviation).
    """
    named: dict[str, NDArray[Any]] = {"status_counts": found.counts, "moving": np.array(found.moving)}
    for name in OUTCOMES:
        named[f"{name}_mean"], named[f"{name}_std"] = np.array(found.mean(name)), np.array(found.std(name))
        if name in found.linear:
            named[f"{name}_linear"] = np.array(found.linear[name])
        named[f"{name}_quantiles"] = np.array([(p, *found.quantile(name, p)) for p in QUANTILES])
        named[f"{name}_exceedance"] = np.stack(found.exceedance(name), axis=1)
        named[f"{name}_bins"] = found.bins(name)
    for output, indices in found.sensitivity.items():
        named[f"{output}_first_order"], named[f"{output}_total"] = np.array(indices.first), np.array(indices.total)
    named["inputs"] = np.array([u.key for u in found.design.inputs.values()])
    named["convergence"] = np.array([(c.n, *c.moving, *c.median, *c.upper) for c in found.convergence])
    return named | {f"sample_{k}": v for k, v in found.samples.items()}


def _estimate(e: Estimate) -> dict[str, Any]:
    return {k: v if math.isfinite(v) else None for k, v in zip(e._fields, map(float, e), strict=True)}
