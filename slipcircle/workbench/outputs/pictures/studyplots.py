"""Pictures of studies: exceedance curves, sensitivity indices, grids, and back-analyses.

Every function of a single outcome draws on the given matplotlib axis, or on a new axis, and returns the axis.
"""

from collections.abc import Iterable, Sequence
from functools import partial
from textwrap import fill
from typing import TYPE_CHECKING, Any

import numpy as np

from slipcircle.base.kinds import Pair, Texts
from slipcircle.base.text import output_unit
from slipcircle.workbench.common.quantities import OBSERVABLE, OUTCOMES, Interval, Quantity, observable
from slipcircle.workbench.files.keys import Key
from slipcircle.workbench.files.numbers import number_in
from slipcircle.workbench.outputs.pictures.plotstyle import (
    AREAS,
    LINES,
    SERIES,
    WIDTH,
    add_label,
    add_mark,
    add_note,
    anchors_along,
    axis_words,
    check_choice,
    empty,
    formatted_amount,
    formatted_number,
    key_unit,
    label_direction,
    name_rows,
    panel,
    quantity_words,
    title,
)
from slipcircle.workbench.outputs.pictures.sheets import Drawing, Row, heading, sheet
from slipcircle.workbench.studies.motions import motions
from slipcircle.workbench.studies.statistics import BEYOND

if TYPE_CHECKING:
    from slipcircle.workbench.studies.backanalysis import BackAnalysis
    from slipcircle.workbench.studies.study import Study

DRAWN = ("run_out", "peak_velocity")
_WRAPPED = 18  # characters of names of inputs on a line
_POINTS = 801  # number of points of a curve, from 0 to the largest value


# --- samples ---------------------------------------------------------------------------------------------------------


def exceedance(study: "Study", output: str = "run_out", ax: Any = None, rare: bool = False) -> Any:
    """Draw the probability that an output is at least so large, in its confidence band; return the axis.

    The median and the 95 % quantile are marked. The curve ends at the share of samples without a result, which exceed
    every value. With ``rare`` the axis is logarithmic; the linear panel beside it has the legend.
    """
    _check(study, output, OUTCOMES)
    quantity = OBSERVABLE[output]
    title = f"{quantity.label}, log scale" if rare else quantity.label
    ax = panel(ax, title, (quantity.label, quantity.unit), ("exceedance probability (–)",))
    ax.set_ylim(-0.02, 1.02)
    curve, moving = study.exceedance(output, _POINTS), study.moving
    if not curve.at.size:
        return empty(_nothing_to_draw(study), ax, "x")
    # Every sample that moves has a run-out, a velocity and a duration above 0.
    at = np.concatenate([[0.0], curve.at])
    values = np.column_stack([(moving.value, moving.low, moving.high), (curve.probability, curve.low, curve.high)])
    ax.fill_between(at, *values[1:], **AREAS["band"])
    ax.plot(at, values[0], **LINES["main"])
    ax.set_xlim(*_limits(at, values[0]))
    if rare:
        ax.set(yscale="log", ylim=(0.5 / study.n, 1.5))
    notes = _mark_quantiles(study, output, ax, rare)
    if not rare:
        add_note(ax, [_samples(study), f"{100 * study.confidence:g} % confidence at each value", *notes])
    return ax


def _limits(at: Any, probability: Any) -> Pair:
    """Return limits of an axis from 0, or from where the probability starts to decrease if that is far from 0.

    ``at`` are increasing values of an output, with their exceedance probabilities.
    """
    greatest = float(at[-1])
    certain = float(np.max(at, initial=0.0, where=probability == 1.0))
    width = greatest - certain
    right = greatest + 0.02 * width
    if certain > 0.4 * greatest:
        return certain - 0.05 * width, right
    return 0.0, right


def _mark_quantiles(study: "Study", output: str, ax: Any, rare: bool) -> Texts:
    """Mark the median and the 95 % quantile on the curve of an axis; return notes on quantiles beyond it.

    With ``rare`` the marks have no labels.
    """
    at, probability = ax.lines[0].get_data()
    beyond = []
    for role, p, words in (("peak", 0.5, "median"), ("end", 0.95, "exceeded by 5 %")):
        place = study.quantile(output, p).value
        if place == np.inf:
            beyond.append(f"{words}: {BEYOND}")
        elif place > 0.0:
            value = f"{words}: {formatted_amount(place, OUTCOMES[output].unit)}"
            add_mark(ax, place, np.interp(place, at, probability), role, "" if rare else value)
    return beyond


def _samples(study: "Study") -> str:
    """Return the number of samples of a curve, and the numbers of samples that it does not show, as text."""
    words = [f"{study.n} samples"]
    if study.without_result:
        words.append(f"\n{study.without_result} of them beyond every value")
    if invalid := study.design.n - study.n:
        words.append(f"\n{invalid} more are not valid scenes")
    return ", ".join(words)


def _nothing_to_draw(study: "Study") -> str:
    """Return the reason why a study has no exceedance curve."""
    if not study.n:
        return "all samples are invalid scenes"
    if study.without_result:
        return f"{study.without_result} of {study.n} samples move without a result,\nno other moves"
    return "nothing moves"


def indices(study: "Study", output: str = "run_out", ax: Any = None, named: bool = True) -> Any:
    """Draw sensitivity indices: the share of the variance of an output that each input explains; return the axis."""
    _check(study, output, (*OUTCOMES, "moves"))
    if output not in study.sensitivity:
        raise ValueError("indices: not computed for this ensemble; they need two uncertain numbers and base points")
    quantities = np.array([quantity_words(u) for u in study.design.inputs.values()])
    first, total = (np.array(kind) for kind in study.sensitivity[output])  # values, low and high ends: (inputs, 3)
    order = np.argsort(-total[:, 0], kind="stable")
    if output in OUTCOMES:
        name = OUTCOMES[output].label
    else:
        name = "whether it moves"
    ax = panel(ax, f"influence on {name}", size=(7.0, 1.6 + 0.6 * len(order)))
    ax.set_xlabel(f"share of the variance of {name} (–)", fontsize="small")
    name_rows(ax, [fill(words, _WRAPPED) for words in quantities[order].tolist()])
    if not np.all(np.isfinite([first[:, 0], total[:, 0]])):
        has_missing = output in OUTCOMES and study.without_result
        return empty("omitted: results are missing for some samples" if has_missing else "does not vary", ax, "x")
    _index_bars(ax, first[order].T, -0.19, "rests", "on its own (first-order)" * named)
    _index_bars(ax, total[order].T, 0.19, "kinetic", "with others (total)" * named)
    least = np.nanmin([first, total])
    ax.set_xlim(1.1 * least if least < -0.01 else 0.0, max(1.0, 1.05 * np.nanmax([first, total])))
    ax.axvline(0.0, color="0.25", lw=0.8)
    return ax


def _index_bars(ax: Any, estimates: Any, offset: float, style: str, words: str) -> None:
    """Draw a bar with its interval for each input.

    ``estimates`` are values, low and high ends, (3, inputs). Bars are moved by ``offset``, have a style of `AREAS`, and
    the words as label.
    """
    value, low, high = estimates
    at = np.arange(len(value)) + offset
    ax.barh(at, np.maximum(value, 0.0), height=0.36, **AREAS[style])
    error = np.nan_to_num([value - low, high - value])
    ax.errorbar(value, at, xerr=error, fmt="none", ecolor="black", elinewidth=1.2, capsize=3)
    if words:
        add_label(ax, words, (high[-1], at[-1]))


# --- grids and back-analyses -----------------------------------------------------------------------------------------


def response(study: "Study", output: str = "run_out", ax: Any = None) -> Any:
    """Draw an output over the first number of a grid; return the axis.

    For a second number there is a curve for each of its values, or a map for many values.
    """
    check_choice("response: output", output, OUTCOMES)
    levels = study.design.levels
    numbers = [*study.design.inputs.values()]
    check_grid([len(x) for x in levels])
    values = study.samples[output].reshape(len(levels[0]), -1)
    most = len(SERIES)
    if min(values.shape) > most:
        return _map(ax, levels, numbers, values, OBSERVABLE[output])
    if values.shape[1] > most:
        levels, numbers, values = levels[::-1], numbers[::-1], values.T
    quantity = OBSERVABLE[output]
    ax = panel(ax, quantity.label, (axis_words(numbers[0]),), (quantity.label, quantity.unit))
    for k, (column, (colour, dashes, marker)) in enumerate(zip(values.T, SERIES, strict=False)):
        ax.plot(levels[0], column, color=colour, ls=dashes, marker=marker, lw=1.8, ms=4)
        if len(levels) > 1:
            words = f"{quantity_words(numbers[1])} {formatted_number(levels[1][k])} {key_unit(numbers[1])}"
            add_label(ax, words.rstrip(), anchors_along(levels[0], column, 100), colour)
    ax.margins(0.08, 0.15)
    return ax


def _map(ax: Any, levels: Sequence[Any], numbers: Sequence[Key], values: Any, quantity: Quantity) -> Any:
    """Draw a map of an output over both numbers of a grid, darkest at its maximum, blank where results are missing.

    ``levels`` are the values of both numbers, and ``values`` those of the output, (first, second), in SI units.
    """
    from matplotlib.ticker import MaxNLocator

    ax = panel(ax, quantity.label, (axis_words(numbers[0]),), (axis_words(numbers[1]),))
    columns, rows = map(np.argsort, levels)
    across = np.asarray(levels[0])[columns]
    up = np.asarray(levels[1])[rows]
    ordered = values[np.ix_(columns, rows)].T
    cells = ax.pcolormesh(across, up, ordered, shading="nearest", cmap="viridis_r", rasterized=True)
    label_direction(ax.figure.colorbar(cells, ax=ax).ax.yaxis, quantity.label, quantity.unit)
    seen = output_unit(quantity.unit)[0] * ordered
    low = np.nanmin(seen)
    high = np.nanmax(seen)
    if low < high:
        ticks = MaxNLocator(5).tick_values(low, high)
        between = ticks[(low < ticks) & (ticks < high)]
        colours = np.where(between > (low + high) / 2, "white", "black")
        ax.clabel(ax.contour(across, up, seen, between, colors=colours, linewidths=0.8), fontsize="small")
    return ax


def explained(analysis: "BackAnalysis") -> Drawing:
    """Return a picture of computed and observed outcomes over each fitted number, near the first solution."""
    rows = len(analysis.observed)
    columns = len(analysis.units)
    return Drawing(partial(_draw_explained, analysis), (min(WIDTH, 2.0 + 4.5 * columns), 0.6 + 3.0 * rows))


def _draw_explained(analysis: "BackAnalysis", figure: Any) -> Any:
    """Draw the picture of `explained` on an empty figure and return the figure."""
    shape = len(analysis.observed), len(analysis.units)
    axes = figure.subplots(*shape, squeeze=False, sharex="col", sharey="row")
    for column, key in zip(axes.T, analysis.units, strict=True):
        _explained_by(analysis, key, column)
        column[-1].set_xlabel(axis_words(number_in(analysis.motion.plan.scene, key)))
    for ax, name in zip(axes[:, 0], analysis.observed, strict=True):
        label_direction(ax.yaxis, OBSERVABLE[name].label, OBSERVABLE[name].unit)
        title(ax, f"{OBSERVABLE[name].label}: computed and observed")
    return figure


def _explained_by(analysis: "BackAnalysis", key: str, axes: Sequence[Any]) -> None:
    """Draw outcomes over one fitted number, given by its key, on one axis per observed outcome."""
    scene = analysis.motion.plan.scene
    field = number_in(scene, key)
    solved = [s.values[key] for s in analysis.solutions]
    errors = analysis.solutions[0].standard_errors or {}
    error = float(np.nan_to_num(errors.get(key, 0.0), posinf=0.0))
    at = _around(field, solved, error)
    lanes = motions(scene, {field.name: field.to_si(at)})
    for ax, (name, observed) in zip(axes, analysis.observed.items(), strict=True):
        curve = observable(lanes, name)
        ax.plot(at, curve, **LINES["main"])
        add_label(ax, "computed", anchors_along(at, curve), LINES["main"]["color"])
        _draw_observed(ax, name, observed, analysis.intervals.get(name), at)
        reached = [observable(s.motion, name) for s in analysis.solutions]
        for value, outcome in zip(solved, reached, strict=True):
            add_mark(ax, value, outcome, "end", f"{formatted_number(value)} {key_unit(field)}")
        if error > 0.0:
            ax.errorbar(solved[0], reached[0], xerr=error, fmt="none", ecolor="black")
        ax.set_xlim(at[0], at[-1])
        ax.grid(alpha=0.3)


def _draw_observed(
    ax: Any, name: str, observed: tuple[float, float | None], interval: Interval | None, places: Any
) -> None:
    """Draw an observed value as a line with its standard error, or an interval, and its label.

    All are in SI units; ``places`` are values of the fitted number at which the label may be.
    """
    seen, sigma = observed
    words = "observed"
    if interval is not None and interval.limit is not None:
        words, interval = str(interval.times(output_unit(OBSERVABLE[name].unit)[0])), None
    band = interval
    if sigma and interval is None:
        band = Interval(seen - sigma, seen + sigma)
        words = "observed, with its standard error"
    if band is not None:
        ax.axhspan(band.low, band.high, **AREAS["band"])
    if interval is None:
        ax.axhline(seen, **LINES["total"])
    add_label(ax, words, anchors_along(places, seen))


def _around(field: Key, solved: Sequence[float], error: float) -> Any:
    """Return values of a number around its solutions, within its open bounds, in the unit of its key.

    ``solved`` are the solutions, and ``error`` is the standard error of the first.
    """
    margin = max(4 * error, 0.3 * max(map(abs, solved)), np.ptp(solved))
    first = max(min(solved) - margin, field.low)
    last = min(max(solved) + margin, field.high)
    return np.linspace(first, last, _POINTS // 2)[1:-1]


def check_grid(counts: Sequence[int]) -> None:
    """Raise ValueError unless a grid, given by the counts of values, has one or two numbers."""
    if not 1 <= len(counts) <= 2:
        raise ValueError(
            f"a picture of a grid shows one number or two, not {' x '.join(map(str, counts)) or 'samples'}; use --csv "
            "or --npz instead"
        )


def study_overview(study: "Study") -> Drawing:
    """Return the picture of a study: exceedance of run-out and peak velocity above the sensitivity indices.

    For a grid, run-out and peak velocity are drawn over its numbers.
    """
    if study.design.method == "grid":
        rows: list[Row] = [(3.8, [partial(response, study, output) for output in DRAWN])]
        words = f"{study.design.n} scenes on a grid"
    else:
        rows = [(3.0, [partial(exceedance, study, x), partial(exceedance, study, x, rare=True)]) for x in DRAWN]
        if study.n:
            words = f"{100 * study.moving.value:.3g} % of {study.n} samples move"
        else:
            words = ""
    if study.sensitivity:
        named = [partial(indices, study, output, named=output == DRAWN[0]) for output in DRAWN]
        rows.append((1.6 + 0.55 * len(study.design.inputs), named))
    return sheet(rows, heading(study.scene.name, words))


def _of_outcome(study: "Study", output: str, ax: Any = None) -> Any:
    """Draw an outcome over the numbers of a grid, or the probability that samples exceed it; return the axis."""
    return (response if study.design.method == "grid" else exceedance)(study, output, ax)


PANELS = {output: partial(_of_outcome, output=output) for output in OUTCOMES}  # panels of `Study.plot`


def _check(study: "Study", output: str, choice: Iterable[str]) -> None:
    """Raise ValueError if an output is not among the choices, or if the study is a grid."""
    check_choice("Study: output", output, choice)
    if study.design.method == "grid":
        raise ValueError("Study: probabilities need samples of uncertain numbers; this study is a grid")
