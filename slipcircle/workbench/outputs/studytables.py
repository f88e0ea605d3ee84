"""Tables of studies of samples, on the screen and in reports."""

from collections.abc import Iterator, Sequence
from typing import Any

from slipcircle.workbench.common.quantities import OUTCOMES, spelt_out
from slipcircle.workbench.common.starting import method_of
from slipcircle.workbench.outputs.tables import ResultTable, unit_table
from slipcircle.workbench.stability.stability import METHODS
from slipcircle.workbench.studies import export
from slipcircle.workbench.studies.searched import SEARCHED
from slipcircle.workbench.studies.statistics import BEYOND
from slipcircle.workbench.studies.study import Study

_UNITS = {spelt_out(name): quantity.unit for name, quantity in OUTCOMES.items()}  # of columns of outcomes
NO_INTERVAL = (
    "Sobol sequences: no interval in the tails, for fewer than 256 samples, and where the sequences differ by less "
    "than a sample; use monte-carlo for intervals everywhere"
)


def study_tables(study: Study, verbose: bool = True) -> Iterator[ResultTable]:
    """Yield tables of a study of samples; if verbose, also for every method and estimate."""
    start = method_of(study.scene)
    methods = [name for name in study.failure if verbose or name.removeprefix(SEARCHED) == start]
    yield _probabilities(study, methods)
    of_methods = [f"factor of safety, {_method_words(method)}" for method in methods]
    quantiles: list[list[Any]] = []
    for p in export.QUANTILES:
        factors = [study.factor_quantile(method, p) for method in methods]
        quantiles.append([f"{1 - p:.2g}", *factors, *(study.quantile(name, p) for name in OUTCOMES)])
    units = dict.fromkeys(["exceedance probability", *of_methods], "") | _UNITS
    yield unit_table(units, quantiles, "How safe, how far and how fast", "; ".join(_quantile_notes(study)))
    yield _moments(study, verbose)
    if study.sensitivity:
        yield _indices(study)
    if verbose:
        units = {"samples": "", "probability of moving": "", "median run-out": "m", "95 % quantile": "m"}
        yield unit_table(units, study.convergence, "Convergence")


def _probabilities(study: Study, methods: Sequence[str]) -> ResultTable:
    """Return a table of the probabilities of moving and of a factor of safety below 1."""
    rows = [["probability of moving", study.moving]]
    rows += [[f"probability of F < 1, {_method_words(method)}", study.failure[method]] for method in methods]
    invalid = study.design.n - study.n
    of_all = f" of {study.design.n}, as {invalid} are not valid scenes" if invalid else ""
    confidence = f"in brackets: {100 * study.confidence:g} % confidence intervals for this number of samples"
    return ResultTable([], rows, "Whether it moves", f"{study.n} samples{of_all}; {confidence}")


def _method_words(method: str) -> str:
    """Return the name of a method of stability, and whether the circle was searched for every sample."""
    name = METHODS[method.removeprefix(SEARCHED)][0]
    if method.startswith(SEARCHED):
        return f"{name}, circle of each sample"
    return name


def _moments(study: Study, verbose: bool) -> ResultTable:
    """Return a table of the mean and standard deviation of each outcome, if verbose also by linear propagation."""
    rows: list[list[Any]] = []
    notes = ["intervals of standard deviations are omitted, as they depend on few samples in the tails"]
    for moment, (name, estimate) in enumerate((("mean", study.mean), ("std", study.std))):
        rows.append([name, *map(estimate, OUTCOMES)])
        if study.linear and verbose:
            rows.append([f"linear {name}", *(study.linear[outcome][moment] for outcome in OUTCOMES)])
    if verbose:
        reason = f"no linear propagation: {study.no_linear}"
        notes.insert(0, reason if study.no_linear else "linear: derivatives at the means")
    return unit_table({"": ""} | _UNITS, rows, "Mean and standard deviation", "; ".join(notes))


def _indices(study: Study) -> ResultTable:
    """Return a table of the sensitivity indices of each outcome."""
    rows = []
    for output, (first, total) in study.sensitivity.items():
        for unknown, alone, together in zip(study.design.inputs.values(), first, total, strict=True):
            rows.append([spelt_out(output), unknown.key, alone, together])
    return ResultTable(
        ["output", "input", "first-order index", "total index"],
        rows,
        "Sensitivity indices",
        "shares of the variance that each input explains, on its own and together with the other inputs; from "
        f"{study.design.base} base points",
    )


def _quantile_notes(study: Study) -> Iterator[str]:
    """Yield notes below the table of quantiles: why intervals are missing, and what "beyond" means."""
    if study.design.replicates > 1:
        yield NO_INTERVAL
    if study.without_result:
        yield f"{BEYOND}: among the {study.without_result} samples that move without a result, so beyond any value"
