"""Pictures of a suite of records: displacements by record, against the scale, and their exceedance probabilities."""

from typing import TYPE_CHECKING, Any

import numpy as np

from slipcircle.workbench.outputs.plotstyle import (
    AREAS,
    LINES,
    SERIES,
    WIDTH,
    axis,
    label,
    legend,
    letter,
    note,
    points_of,
)
from slipcircle.workbench.suites.statistics import THRESHOLDS, distribution, fragility

if TYPE_CHECKING:
    from slipcircle.workbench.studies.suitestudy import SuiteStudy

_NAMED = 60  # records up to which each has its name
_LEAST = 1e-3  # of the greatest displacement, which a logarithmic axis begins with


def displacements(study: "SuiteStudy", ax: Any = None) -> Any:
    """Displacements of the records in order, in each polarity, at the scale next to their own; medians of samples."""
    ax, scale = axis(ax), study.own_scale
    values = np.median(study.displacement[:, :, scale], axis=-1)
    order = np.argsort(values.mean(axis=1))
    ranks = np.arange(order.size)
    in_order = values[order]
    ax.hlines(ranks, in_order.min(axis=1), in_order.max(axis=1), color="0.7", lw=1.0, zorder=1)
    for name, column, (colour, _, marker) in zip(("as recorded", "reversed"), in_order.T, SERIES, strict=False):
        ax.plot(column, ranks, marker, color=colour, ms=4, label=name)
    ax.set(xlabel=f"displacement at {study.scale_text(scale)} (m)", ylim=(-0.6, order.size - 0.4))
    if order.size <= _NAMED:
        ax.set_yticks(ranks, [study.suite.entries[k].name for k in order], fontsize=8, parse_math=False)
    else:
        ax.set_ylabel("record, in order")
    ax.grid(axis="x", alpha=0.3)
    if values.shape[1] > 1:
        legend(ax)
    return ax


def incremental(study: "SuiteStudy", ax: Any = None) -> Any:
    """Displacement against the scale: each record (mean of polarities), the median of all, and 16 to 84 %."""
    ax = axis(ax)
    values = np.median(study.displacement, axis=-1).mean(axis=1)
    found = [distribution(study.displacement, k) for k in range(study.scales.size)]
    low = [level.p16 for level in found]
    middle = [level.median for level in found]
    high = [level.p84 for level in found]
    ax.plot(study.scales, values.T, color="0.75", lw=0.6, zorder=1)
    ax.fill_between(study.scales, low, high, **AREAS["band"], alpha=0.6)
    ax.plot(study.scales, middle, **LINES["main"])
    label(ax, "median", points_of(study.scales, middle), LINES["main"]["color"])
    ax.set(xlabel=_scale_words(study), ylabel="displacement (m)", yscale="log")
    greatest = float(np.max(values, initial=_LEAST, where=np.isfinite(values)))
    ax.set_ylim(_LEAST * greatest, 1.5 * greatest)
    note(ax, ["grey: records; band: 16 to 84 %"])
    return ax


def exceedance(study: "SuiteStudy", ax: Any = None) -> Any:
    """Probabilities that the displacement exceeds thresholds, against the scale, with their 95 % intervals."""
    ax = axis(ax)
    estimates = np.array(fragility(study.displacement, THRESHOLDS))
    for k, threshold in enumerate(THRESHOLDS.tolist()):
        colour, dashes, marker = SERIES[k]
        value, low, high = estimates[:, k].T
        ax.fill_between(study.scales, low, high, color=colour, alpha=0.12, lw=0)
        ax.plot(study.scales, value, color=colour, ls=dashes, marker=marker, ms=4)
        label(ax, f"D > {threshold:g} m", points_of(study.scales, value), colour)
    ax.set(xlabel=_scale_words(study), ylabel="exceedance probability (–)", ylim=(-0.02, 1.02))
    ax.grid(alpha=0.3)
    return ax


def _scale_words(study: "SuiteStudy") -> str:
    return "peak acceleration of each record (g)" if study.design.to_pga else "factor on the records (–)"


PANELS = {"displacements": displacements, "incremental": incremental, "exceedance": exceedance}


def overview(study: "SuiteStudy", figure: Any) -> Any:
    """Displacements by record, and where there are several scales, curves against them."""
    rows = 1 + (study.scales.size > 1)
    grid = figure.add_gridspec(rows, 2, height_ratios=_heights(study))
    displacements(study, figure.add_subplot(grid[0, :]))
    if rows > 1:
        incremental(study, figure.add_subplot(grid[1, 0]))
        exceedance(study, figure.add_subplot(grid[1, 1]))
        letter(figure.axes)
    name = study.scene.name
    figure.suptitle(f"{name[:1].upper()}{name[1:]}: {len(study.suite)} records", parse_math=False, fontweight="bold")
    return figure


def size(study: "SuiteStudy") -> tuple[float, float]:
    """Size of the overview in inches."""
    return WIDTH, sum(_heights(study)) + 0.4


def _heights(study: "SuiteStudy") -> list[float]:
    records = 1.2 + 0.15 * min(len(study.suite), _NAMED)
    return [records, 3.4] if study.scales.size > 1 else [records]
