"""Pictures of studies: exceedance curves, sensitivity indices, grids, and back-analyses.

Every function of a single outcome draws on the given matplotlib axis, or on a new axis, and returns the axis.
"""

from collections.abc import Iterable, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from slipcircle.base.kinds import Pair
from slipcircle.base.text import printed
from slipcircle.workbench.common.quantities import OBSERVABLE, OUTCOMES, Interval, observable
from slipcircle.workbench.files.keys import Key
from slipcircle.workbench.files.numbers import number_in
from slipcircle.workbench.outputs.pictures.plotstyle import (
    AREAS,
    LINES,
    SERIES,
    WIDTH,
    amount,
    axis,
    axis_words,
    empty,
    known,
    label,
    lines,
    mark,
    measure,
    note,
    number,
    points_of,
    quantity_words,
    title,
    unit_of,
)
from slipcircle.workbench.outputs.pictures.sheets import Drawing, Row, heading, sheet
from slipcircle.workbench.studies.motions import motions
from slipcircle.workbench.studies.statistics import BEYOND

if TYPE_CHECKING:
    from slipcircle.workbench.studies.backanalysis import BackAnalysis
    from slipcircle.workbench.studies.study import Study

DRAWN = ("run_out", "peak_velocity")
_POINTS = 801  # number of points of a curve, from 0 to the largest value


# --- samples ---------------------------------------------------------------------------------------------------------


def exceedance(study: "Study", output: str = "run_out", ax: Any = None, rare: bool = False) -> Any:
    """Draw the probability that an output is at least so large, in its confidence band; return the axis.

    The median and the 95 % quantile are marked. The curve ends at the share of samples without a result, which exceed
    every value. With ``rare`` the axis is logarithmic; the linear panel beside it has the legend.
    """
    _check(study, output, OUTCOMES)
    ax = axis(ax)
    ax.set(ylabel="exceedance probability (–)", ylim=(-0.02, 1.02))
    measure(ax.xaxis, OBSERVABLE[output].label, OBSERVABLE[output].unit)
    title(ax, f"{OUTCOMES[output].label}{', logarithmic' * rare}")
    ax.grid(alpha=0.3)
    curve, moving = study.exceedance(output, _POINTS), study.moving
    if not curve.at.size:
        return empty(_nothing_to_draw(study), ax, "x")
    # Every sample that moves has a run-out, a velocity and a duration above 0.
    at = np.concatenate([[0.0], curve.at])
    value = np.concatenate([[moving.value], curve.probability])
    low = np.concatenate([[moving.low], curve.low])
    high = np.concatenate([[moving.high], curve.high])
    ax.fill_between(at, low, high, **AREAS["band"])
    ax.plot(at, value, **LINES["main"])
    ax.set_xlim(*_limits(at, value))
    if rare:
        ax.set(yscale="log", ylim=(0.5 / study.n, 1.5))
    beyond = _mark_quantiles(study, output, ax, not rare)
    if not rare:
        note(ax, [_samples(study), f"{100 * study.confidence:g} % confidence at each place", *beyond])
    return ax


def _limits(at: Any, probability: Any) -> Pair:
    """Return limits of an axis from 0, or from where the probability starts to decrease if that is far from 0."""
    greatest, certain = float(at[-1]), 0.0
    if probability[0] == 1.0:
        certain = float(at[np.flatnonzero(probability == 1.0)[-1]])
    width = greatest - certain
    left = certain - 0.05 * width if certain > 0.4 * greatest else 0.0
    return max(0.0, left), greatest + 0.02 * width


def _mark_quantiles(study: "Study", output: str, ax: Any, named: bool) -> list[str]:
    """Mark the median and the 95 % quantile on the curve of the axis; return notes on quantiles beyond it."""
    at, probability = ax.lines[0].get_data()
    beyond = []
    for role, p, words in (("peak", 0.5, "median"), ("end", 0.95, "exceeded by 5 %")):
        place = study.quantile(output, p).value
        if place == np.inf:
            beyond.append(f"{words}: {BEYOND}")
        elif place > 0.0:
            value = f"{words}: {amount(place, OUTCOMES[output].unit)}"
            mark(ax, place, np.interp(place, at, probability), role, value if named else "")
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
    by_kind = study.sensitivity[output]
    keys = [quantity_words(u) for u in study.design.inputs.values()]
    totals = np.array([total.value for total in by_kind.total])
    order = np.argsort(-totals, kind="stable")
    ax = axis(ax, (7.0, 1.6 + 0.6 * len(keys)))
    name = OUTCOMES[output].label if output in OUTCOMES else "whether it moves"
    ax.set_xlabel(f"share of the variance of {name} (–)", fontsize="small")
    title(ax, f"influence on {name}")
    lines(ax, [keys[k] for k in order])
    first = np.array(by_kind.first)[order].T
    total = np.array(by_kind.total)[order].T
    if not np.all(np.isfinite([first[0], total[0]])):
        has_missing = output in OUTCOMES and study.without_result
        return empty("omitted: results are missing for some samples" if has_missing else "does not vary", ax, "x")
    _draw_indices(ax, first, total, named)
    return ax


def _draw_indices(ax: Any, first: Any, total: Any, named: bool) -> None:
    """Draw two bars for each input, from values, low and high ends, (3, inputs), with labels at the lowest bars."""
    kinds = ((first, -0.19, "rests", "on its own (first-order)"), (total, 0.19, "kinetic", "with others (total)"))
    for estimates, offset, style, words in kinds:
        _index_bars(ax, estimates, offset, style)
        if named:
            value, _, high = estimates
            lowest_bar = len(value) - 1 + offset
            label(ax, words, (high[-1], lowest_bar))
    least = np.nanmin([first, total])
    greatest = np.nanmax([first, total])
    left = min(0.0, 1.1 * least) if least < -0.01 else 0.0
    ax.set_xlim(left, max(1.0, 1.05 * greatest))
    ax.axvline(0.0, color="0.25", lw=0.8)


def _index_bars(ax: Any, estimates: Any, offset: float, style: str) -> None:
    """Draw a bar with its interval for each input, from values, low and high ends, (3, inputs)."""
    value, low, high = estimates
    at = np.arange(len(value)) + offset
    ax.barh(at, np.maximum(value, 0.0), height=0.36, **AREAS[style])
    error = np.nan_to_num([value - low, high - value])
    ax.errorbar(value, at, xerr=error, fmt="none", ecolor="black", elinewidth=1.2, capsize=3)


# --- grids and back-analyses -----------------------------------------------------------------------------------------


def response(study: "Study", output: str = "run_out", ax: Any = None) -> Any:
    """Draw an output over the first number of a grid; return the axis.

    For a second number there is a curve for each of its values, or a map for many values.
    """
    known("response: output", output, OUTCOMES)
    levels = study.design.levels
    numbers = [*study.design.inputs.values()]
    check_grid([len(x) for x in levels])
    ax = axis(ax)
    title(ax, OUTCOMES[output].label)
    values = study.samples[output].reshape(len(levels[0]), -1)
    first_count, second_count = values.shape
    most = len(SERIES)
    if first_count > most and second_count > most:
        return _map(ax, levels, numbers, values, output)
    if second_count > most:
        levels = levels[::-1]
        numbers = numbers[::-1]
        values = values.T
    _curves(ax, levels, numbers, values)
    ax.set(xlabel=axis_words(numbers[0]))
    measure(ax.yaxis, OBSERVABLE[output].label, OBSERVABLE[output].unit)
    ax.margins(0.08, 0.15)
    ax.grid(alpha=0.3)
    return ax


def _curves(ax: Any, levels: Sequence[Any], numbers: Sequence[Key], values: Any) -> None:
    """Draw values over the first number of a grid, as a labelled curve for each value of the second."""
    across = levels[0]
    for k, (column, style) in enumerate(zip(values.T, SERIES, strict=False)):
        colour, dashes, marker = style
        ax.plot(across, column, color=colour, ls=dashes, marker=marker, lw=1.8, ms=4)
        if len(levels) < 2:
            continue
        second = numbers[1]
        level = number(levels[1][k])
        words = f"{quantity_words(second)} {level} {unit_of(second)}"
        label(ax, words.rstrip(), points_of(across, column, 100), colour)


def _map(ax: Any, levels: Sequence[Any], numbers: Sequence[Key], values: Any, output: str) -> Any:
    """Draw a map of an output over both numbers of a grid, darkest at its maximum, blank where results are missing."""
    from matplotlib.ticker import MaxNLocator

    first, second = map(np.asarray, levels)
    columns = np.argsort(first)
    rows = np.argsort(second)
    across = first[columns]
    up = second[rows]
    ordered = values[np.ix_(columns, rows)].T
    cells = ax.pcolormesh(across, up, ordered, shading="nearest", cmap="viridis_r", rasterized=True)
    bar = ax.figure.colorbar(cells, ax=ax)
    measure(bar.ax.yaxis, OBSERVABLE[output].label, OBSERVABLE[output].unit)
    factor, _ = printed(OUTCOMES[output].unit)
    low = factor * np.nanmin(ordered)
    high = factor * np.nanmax(ordered)
    if low < high:
        ticks = MaxNLocator(5).tick_values(low, high)
        between = ticks[(low < ticks) & (ticks < high)]
        on_dark = between > (low + high) / 2
        colours = np.where(on_dark, "white", "black")
        contours = ax.contour(across, up, factor * ordered, between, colors=colours, linewidths=0.8)
        ax.clabel(contours, fontsize="small")
    ax.set(xlabel=axis_words(numbers[0]), ylabel=axis_words(numbers[1]))
    return ax


def explained(analysis: "BackAnalysis") -> Drawing:
    """Return a picture of computed and observed outcomes over each fitted number, near the first solution."""
    rows, columns = len(analysis.observed), len(analysis.units)
    return Drawing(partial(_draw_explained, analysis), (min(WIDTH, 2.0 + 4.5 * columns), 0.6 + 3.0 * rows))


def _draw_explained(analysis: "BackAnalysis", figure: Any) -> Any:
    shape = len(analysis.observed), len(analysis.units)
    axes = figure.subplots(*shape, squeeze=False, sharex="col", sharey="row")
    for column, key in zip(axes.T, analysis.units, strict=True):
        _explained_by(analysis, key, column)
        column[-1].set_xlabel(axis_words(number_in(analysis.motion.plan.scene, key)))
    for ax, name in zip(axes[:, 0], analysis.observed, strict=True):
        measure(ax.yaxis, OBSERVABLE[name].label, OBSERVABLE[name].unit)
        title(ax, f"{OBSERVABLE[name].label}: computed and observed")
    return figure


def _explained_by(analysis: "BackAnalysis", key: str, axes: Sequence[Any]) -> None:
    """Draw outcomes over one fitted number, on one axis per outcome."""
    scene = analysis.motion.plan.scene
    field = number_in(scene, key)
    solved = [s.values[key] for s in analysis.solutions]
    errors = analysis.solutions[0].standard_errors or {}
    error = errors.get(key, 0.0)
    if not np.isfinite(error):
        error = 0.0
    at = _around(field, solved, error)
    lanes = motions(scene, {field.name: field.to_si(at)})
    for ax, (name, observed) in zip(axes, analysis.observed.items(), strict=True):
        curve = observable(lanes, name)
        ax.plot(at, curve, **LINES["main"])
        label(ax, "computed", points_of(at, curve), LINES["main"]["color"])
        _draw_observed(ax, name, observed, analysis.intervals.get(name), at)
        reached = [observable(s.motion, name) for s in analysis.solutions]
        for value, outcome in zip(solved, reached, strict=True):
            words = f"{number(value)} {unit_of(field)}"
            mark(ax, value, outcome, "end", words)
        if error > 0.0:
            ax.errorbar(solved[0], reached[0], xerr=error, fmt="none", ecolor="black")
        ax.set_xlim(at[0], at[-1])
        ax.grid(alpha=0.3)


def _draw_observed(
    ax: Any, name: str, observed: tuple[float, float | None], interval: Interval | None, places: Any
) -> None:
    """Draw an observed value as a line with its standard error, or an interval, and its label."""
    seen, sigma = observed
    words = "observed"
    if interval is not None and interval.limit is not None:
        words, interval = str(interval.times(printed(OBSERVABLE[name].unit)[0])), None
    band = interval
    if sigma and interval is None:
        band = Interval(seen - sigma, seen + sigma)
        words = "observed, with its standard error"
    if band is not None:
        ax.axhspan(band.low, band.high, **AREAS["band"])
    if interval is None:
        ax.axhline(seen, **LINES["total"])
    label(ax, words, points_of(places, seen))


def _around(field: Key, solved: Sequence[float], error: float) -> Any:
    """Return values of a number around its solutions, within its open bounds."""
    largest = max(map(abs, solved))
    margin = max(4 * error, 0.3 * largest, np.ptp(solved))
    low = max(min(solved) - margin, field.low)
    high = min(max(solved) + margin, field.high)
    points = np.linspace(low, high, _POINTS // 2)
    return points[1:-1]


def check_grid(counts: Sequence[int]) -> None:
    """Raise ValueError unless a grid, given by the counts of values, has one or two numbers."""
    if not 1 <= len(counts) <= 2:
        raise ValueError(
            f"a picture of a grid shows one number or two, not {' x '.join(map(str, counts)) or 'samples'}; use --csv "
            "or --npz instead"
        )


def overview(study: "Study") -> Drawing:
    """Return the picture of a study: exceedance of run-out and peak velocity above the sensitivity indices.

    For a grid, run-out and peak velocity are drawn over its numbers.
    """
    if study.design.method == "grid":
        rows: list[Row] = [(3.8, [partial(response, study, output) for output in DRAWN])]
    else:
        rows = [(3.0, [partial(exceedance, study, x), partial(exceedance, study, x, rare=True)]) for x in DRAWN]
    if study.sensitivity:
        named = [partial(indices, study, output, named=output == DRAWN[0]) for output in DRAWN]
        rows.append((1.6 + 0.55 * len(study.design.inputs), named))
    return sheet(rows, _title(study))


def _title(study: "Study") -> str:
    """Return the name of the scene, and the share of samples that move."""
    outcome = f"{100 * study.moving.value:.3g} % of {study.n} samples move" if study.n else ""
    if study.design.method == "grid":
        outcome = f"{study.design.n} scenes on a grid"
    return heading(study.scene.name, outcome)


def outcome(study: "Study", output: str, ax: Any = None) -> Any:
    """Draw an outcome over the numbers of a grid, or the probability that samples exceed it; return the axis."""
    return (response if study.design.method == "grid" else exceedance)(study, output, ax)


PANELS = {output: partial(outcome, output=output) for output in OUTCOMES}  # panels of `Study.plot`


def _check(study: "Study", output: str, choice: Iterable[str]) -> None:
    known("Study: output", output, choice)
    if study.design.method == "grid":
        raise ValueError("Study: probabilities need samples of uncertain numbers; this study is a grid")
