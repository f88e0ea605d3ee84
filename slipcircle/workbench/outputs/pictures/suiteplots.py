"""Pictures of a suite of records: displacements by record and scale, fragility, histories of the median record."""

from functools import partial
from itertools import cycle
from typing import TYPE_CHECKING, Any

import numpy as np

from slipcircle.workbench.outputs.pictures.comparison import STILL, curves
from slipcircle.workbench.outputs.pictures.plotstyle import (
    AREAS,
    LINES,
    SERIES,
    add_label,
    add_note,
    anchors_along,
    empty,
    formatted_amount,
    label_direction,
    legend,
    panel,
)
from slipcircle.workbench.outputs.pictures.sheets import Drawing, Row, heading, sheet
from slipcircle.workbench.studies.fragility import interval_note
from slipcircle.workbench.studies.statistics import distribution, exceedance_probabilities

if TYPE_CHECKING:
    from slipcircle.workbench.studies.study import Study

_NAMED = 60  # greatest number of records with names
_LEAST = 1e-3  # start of a logarithmic axis, relative to the greatest displacement
_POLARITIES = ("as recorded", "reversed")
_LONGEST = 44  # greatest number of letters above a panel
_SKEW = 10.0  # ratio of greatest to median displacement above which the axis spreads small displacements
_PANEL = 3.4  # height of a row of curves, inches


def displacements(study: "Study", ax: Any = None) -> Any:
    """Draw the displacement of each record, in order and in each polarity; return the axis.

    The records have the scale next to their own; for samples the displacement is the median.
    """
    scale = study.own_scale
    values = np.median(study.displacement[:, :, scale], axis=-1)
    order = np.argsort(values.mean(axis=1))
    ranks = np.arange(order.size)
    in_order = values[order]
    ax = panel(ax, "displacement by record")
    ax.hlines(ranks, in_order.min(axis=1), in_order.max(axis=1), color="0.7", lw=1.0, zorder=1)
    for name, column, (colour, _, marker) in zip(_POLARITIES, in_order.T, SERIES, strict=False):
        ax.plot(column, ranks, marker, color=colour, ms=4, label=name, clip_on=False)
    ax.set(ylim=(-0.6, order.size - 0.4), ylabel="record, in order")
    if order.size <= _NAMED:
        ax.set_ylabel("")
        ax.set_yticks(ranks, [study.suite.entries[k].name for k in order], fontsize=8, parse_math=False)
    finite = in_order[np.isfinite(in_order)]
    if finite.size and finite.max() > _SKEW * np.median(finite):
        ax.set_xscale("symlog", linthresh=finite.max() / _SKEW**2)
    ax.set_xlim(left=0.0)
    label_direction(ax.xaxis, f"displacement at {study.scale_text(scale)}", "m")
    if values.shape[1] > 1:
        legend(ax)
    return ax


def incremental(study: "Study", ax: Any = None) -> Any:
    """Draw displacement against scale: each record (mean of polarities), median, 16 to 84 %; return the axis."""
    if study.records.to_pga:
        across = "peak acceleration of each record (g)"
    else:
        across = "factor on the records (–)"
    ax = panel(ax, "displacement by scale", (across,))
    values = np.median(study.displacement, axis=-1).mean(axis=1)
    levels = [distribution(study.displacement, k) for k in range(study.scales.size)]
    greatest = float(np.max(values, initial=0.0, where=np.isfinite(values)))
    if greatest == 0.0:
        return empty(STILL, ax, "x", "y")
    least = _LEAST * greatest
    below = 0.1 * least  # below the view, in place of zeros
    shares = np.array([(level.p16, level.median, level.p84) for level in levels])
    low, middle, high = np.maximum(shares.T, below)
    ax.plot(study.scales, np.maximum(values, below).T, color="0.75", lw=0.6, zorder=1)
    ax.fill_between(study.scales, low, high, **AREAS["band"], alpha=0.6)
    ax.plot(study.scales, middle, **LINES["main"])
    in_view = (middle > least) & (middle < np.inf)
    if np.any(in_view):
        add_label(ax, "median", anchors_along(study.scales[in_view], middle[in_view]), LINES["main"]["color"])
    ax.set(yscale="log", ylim=(least, 1.5 * greatest))
    label_direction(ax.yaxis, "displacement", "m")
    add_note(ax, ["grey: records; band: 16 to 84 %"])
    return ax


def fragility(study: "Study", ax: Any = None) -> Any:
    """Draw the probabilities that the displacement exceeds thresholds; return the axis.

    Lognormal curves have their intervals of 95 %. Points are the shares at each scale, at the median peak acceleration
    of the records, joined where a curve is missing; they have intervals where some motions exceed the threshold and
    some do not.
    """
    across = f"peak acceleration (g)\n{interval_note(len(study.suite))}"
    ax = panel(ax, "fragility", (across,), ("exceedance probability (–)",))
    levels = np.median(study.pga, axis=0)
    pga = np.linspace(0.0, 1.05 * (levels if levels.size > 1 else study.pga).max(), 201)[1:]
    estimates = np.array(exceedance_probabilities(study.displacement, study.records.thresholds))
    for curve, shares, style in zip(study.fragility(), np.swapaxes(estimates, 0, 1), cycle(SERIES), strict=False):
        colour, dashes, marker = style
        _shares(ax, levels, *shares.T, color=colour, marker=marker)
        anchors = levels, shares[:, 0]
        if curve.reason:
            ax.plot(*anchors, color=colour, ls=dashes, lw=0.6)
        else:
            probability, lower, upper = curve.probability(pga)
            ax.fill_between(pga, lower, upper, color=colour, alpha=0.15, lw=0)
            ax.plot(pga, probability, color=colour, ls=dashes)
            off = np.abs(probability - 0.6)
            steep = off <= max(0.3, off.min())
            anchors = (pga[steep], probability[steep])
        add_label(ax, f"D > {formatted_amount(curve.threshold, 'm')}", anchors_along(*anchors), colour)
    ax.set(xlim=(0.0, pga[-1]), ylim=(-0.02, 1.02))
    return ax


def _shares(ax: Any, levels: Any, value: Any, low: Any, high: Any, **style: Any) -> None:
    """Draw shares of the motions over levels (PGA over gravity), with intervals where they are neither 0 nor 1.

    ``value``, ``low`` and ``high`` are the shares and the ends of their intervals, (levels,).
    """
    errors = np.where((value > 0.0) & (value < 1.0), [value - low, high - value], 0.0)
    ax.errorbar(levels, value, errors, ls="", ms=4, elinewidth=0.7, alpha=0.8, **style)


def _history(study: "Study", what: str, ax: Any = None) -> Any:
    """Draw a quantity of `HISTORY` over time, in each polarity, under the record of median displacement.

    The scale is the one nearest to the records' own.
    """
    scale = study.own_scale
    record = study.median_record(scale)
    words = f"median: {study.suite.entries[record].name}"
    if len(words) > _LONGEST:
        words = f"{words[: _LONGEST - 1]}…"
    return curves(study.motions_of(record, scale), _POLARITIES, what, ax, [words])


PANELS = {
    "displacements": displacements,
    "incremental": incremental,
    "fragility": fragility,
    "velocity": partial(_history, what="velocity"),
    "displacement": partial(_history, what="displacement"),
}


def suite_overview(study: "Study") -> Drawing:
    """Return the picture of a suite: displacements by record, curves by scale, histories of the median record."""
    if len(study.suite) <= _NAMED:
        records = 1.2 + 0.15 * len(study.suite)
    else:
        records = 1.2 * _PANEL
    rows: list[Row] = [(records, [partial(displacements, study)])]
    if study.scales.size > 1:
        rows.append((_PANEL, [partial(incremental, study), partial(fragility, study)]))
    elif not all(curve.reason for curve in study.fragility()):  # the records have different peak accelerations
        rows.append((_PANEL, [partial(fragility, study)]))
    rows.append((0.8 * _PANEL, [partial(_history, study, what=what) for what in ("velocity", "displacement")]))
    return sheet(rows, heading(study.scene.name, f"{len(study.suite)} records"))
