"""Pictures of uncertain scenes: exceedance curves, sensitivity indices, and what a change of each number changes.

Every function draws one of `OUTCOMES` on a given matplotlib axis, or on one of its own, and returns it.
"""

from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from textwrap import shorten
from typing import TYPE_CHECKING, Any

import numpy as np

from slipcircle.workbench.common.quantities import OUTCOMES
from slipcircle.workbench.files.numbers import Number, by_name, number_in, uncertain_numbers
from slipcircle.workbench.outputs.plotstyle import AREAS, LINES, axis, empty, known, legend, lines, mark, number
from slipcircle.workbench.studies.motions import motions, scales
from slipcircle.workbench.studies.statistics import BEYOND

if TYPE_CHECKING:
    from slipcircle.core import Sensitivity
    from slipcircle.workbench.studies.backanalysis import BackAnalysis
    from slipcircle.workbench.studies.study import Study

DRAWN = ("reach", "peak_velocity")  # a hazard is how far and how fast it comes, not where it ends
_POINTS = 801  # of a curve, from 0 to the largest value
# Of a family of curves: colours that the colour-blind tell apart, dashes and markers that greys leave apart.
_STYLES = (
    ("#0072B2", "-", "o"),
    ("#D55E00", (0, (5, 2)), "s"),
    ("black", (0, (1, 1.2)), "^"),
    ("#009E73", (0, (6, 1.5, 1, 1.5)), "D"),
    ("#CC79A7", "-", "x"),
    ("#E69F00", (0, (3, 1)), "v"),
)
_SHARE = 0.01  # by which each number changes where the scene does not say how uncertain it is


# --- samples ---------------------------------------------------------------------------------------------------------


def exceedance(study: "Study", output: str = "reach", ax: Any = None, rare: bool = False) -> Any:
    """The probability that an output is at least so large, in its confidence band, with two quantiles marked.

    It ends at the share of the samples that slide to no known end, which exceed every value. On a logarithmic axis,
    where what is rare shows, it stands beside the linear one, which has the legend.
    """
    _check(study, output, OUTCOMES)
    ax = axis(ax)
    ax.set(xlabel=_label(output), ylabel="exceedance probability (–)", ylim=(-0.02, 1.02))
    ax.grid(alpha=0.3)
    curve, moving = study.exceedance(output, _POINTS), study.moving
    if not curve.at.size:
        return empty(_nothing_to_draw(study), ax, "x")
    # Whatever moves has a run-out, a velocity and a duration above 0.
    at = np.concatenate([[0.0], curve.at])
    value = np.concatenate([[moving.value], curve.probability])
    low = np.concatenate([[moving.low], curve.low])
    high = np.concatenate([[moving.high], curve.high])
    band = f"{100 * study.confidence:g} % confidence at each place"
    ax.fill_between(at, low, high, label=band, **AREAS["band"])
    ax.plot(at, value, label=_samples(study), **LINES["main"])
    _mark_quantiles(study, output, ax)
    ax.set_xlim(*_limits(at, value))
    if rare:
        ax.set(yscale="log", ylim=(0.5 / study.n, 1.5))
    else:
        legend(ax)
    return ax


def _limits(at: Any, probability: Any) -> tuple[float, float]:
    """Ends of an axis from 0, or from where the probability begins to fall if that is far from there."""
    greatest, certain = float(at[-1]), 0.0
    if probability[0] == 1.0:
        certain = float(at[np.flatnonzero(probability == 1.0)[-1]])
    width = greatest - certain
    left = certain - 0.05 * width if certain > 0.4 * greatest else 0.0
    return max(0.0, left), greatest + 0.02 * width


def _mark_quantiles(study: "Study", output: str, ax: Any) -> None:
    """Mark the median and the value that 5 % exceed, on the curve that the axis has."""
    at, probability = ax.lines[0].get_data()
    for role, p, words in (("peak", 0.5, "median"), ("end", 0.95, "exceeded by 5 %")):
        place = study.quantile(output, p).value
        if place == np.inf:
            ax.plot([], [], ls="", label=f"{words}: {BEYOND}")
        elif place > 0.0:
            label = f"{words}: {number(place)} {OUTCOMES[output].unit}"
            mark(ax, place, np.interp(place, at, probability), role, label)


def _samples(study: "Study") -> str:
    """How many samples a curve is of, and which it does not show."""
    words = [f"{study.n} samples"]
    if study.without_result:
        words.append(f"{study.without_result} of them beyond every value")
    if invalid := study.design.n - study.n:
        words.append(f"{invalid} more are no scene")
    return ", ".join(words)


def _nothing_to_draw(study: "Study") -> str:
    if not study.n:
        return "no sample is a scene"
    if study.without_result:
        return f"{study.without_result} of {study.n} samples move without a result,\nno other moves"
    return "nothing moves"


def indices(study: "Study", output: str = "reach", ax: Any = None, named: bool = True) -> Any:
    """The sensitivity indices of an output: what share of its variance each unknown explains, with confidence."""
    _check(study, output, (*OUTCOMES, "moves"))
    if output not in study.sensitivity:
        raise ValueError("indices: this ensemble has none: give it two uncertain numbers and base points at least")
    by_kind = study.sensitivity[output]
    keys = [u.key for u in study.design.inputs.values()]
    order = np.argsort([-total.value for total in by_kind.total], kind="stable")
    ax = axis(ax, (7.0, 1.6 + 0.6 * len(keys)))
    label = OUTCOMES[output].label if output in OUTCOMES else "whether it moves"
    ax.set(xlabel=f"share of the variance of {label} (–)")
    lines(ax, [keys[k] for k in order])
    first = np.array(by_kind.first)[order].T
    total = np.array(by_kind.total)[order].T
    if not np.all(np.isfinite([first[0], total[0]])):
        has_missing = output in OUTCOMES and study.without_result
        return empty("not given: some samples have no result" if has_missing else "does not vary", ax, "x")
    _index_bars(ax, first, -0.19, "on its own (first-order)", "rests")
    _index_bars(ax, total, 0.19, "together with others (total)", "kinetic")
    least, greatest = np.nanmin([first, total]), np.nanmax([first, total])
    left = min(0.0, 1.1 * least) if least < -0.01 else 0.0
    ax.set_xlim(left, max(1.0, 1.05 * greatest))
    ax.axvline(0.0, color="0.25", lw=0.8)
    if named:
        legend(ax, columns=1)  # names of keys may leave little room beside
    return ax


def _index_bars(ax: Any, estimates: Any, offset: float, label: str, style: str) -> None:
    """A bar of each input with its interval, from values, low and high ends."""
    value, low, high = estimates
    at = np.arange(len(value)) + offset
    ax.barh(at, np.maximum(value, 0.0), height=0.36, label=label, **AREAS[style])
    error = np.nan_to_num([value - low, high - value])
    ax.errorbar(value, at, xerr=error, fmt="none", ecolor="black", elinewidth=1.2, capsize=3)


# --- derivatives -----------------------------------------------------------------------------------------------------


def tornado(
    table: "Sensitivity",
    output: str = "run_out",
    changes: Mapping[str, float] | None = None,
    ax: Any = None,
    named: bool = True,
) -> Any:
    """How much an output changes, to first order, with a change of each number of a scene; the largest on top.

    ``changes`` is by how much each number changes, in the unit of its key in a scene file,
    ``{"friction.angle_deg": 2.0}``, and only these are drawn. By default the uncertain numbers of the scene change by
    one standard deviation; where it has none, all numbers by 1 %, ends of the arc by 1 % of its half angle and points
    of a section by 1 % of its depth. ``named`` is whether the axis has a legend.
    """
    known("tornado: output", output, table.outputs)
    steps, how = _steps(table, changes)
    bars = []
    for name, (key, step) in steps.items():
        value = float(key.from_si(table.at[name]))
        change = table.derivative(output, name) * key.slope(value) * step
        bars.append((change, f"{key.key} = {number(value)} ± {step:.3g}"))
    bars = sorted((bar for bar in bars if bar[0] or changes is not None), key=lambda bar: -abs(bar[0]))
    ax = axis(ax, (7.0, 1.6 + 0.4 * max(2, len(bars))))
    unit, at = table.outputs[output], table.at[output]
    ax.set(xlabel=f"change of {OUTCOMES[output].label} from {number(at)} {unit}{how} ({unit})")
    if not at or not bars:
        return empty("nothing changes it" if at else "does not move", ax, "x", "y")
    _two_sided_bars(ax, bars)
    if named:
        legend(ax)
    return ax


def _two_sided_bars(ax: Any, bars: Sequence[tuple[float, str]]) -> None:
    """A bar to both sides for each change and its text, the widest one first."""
    changes = np.array([change for change, _ in bars])
    lines(ax, [text for _, text in bars])
    places = np.arange(len(bars))
    ax.barh(places, changes, height=0.62, label="larger", **AREAS["kinetic"])
    ax.barh(places, -changes, height=0.62, label="smaller", **AREAS["rests"])
    widest = 1.08 * abs(changes[0])
    ax.set_xlim(-widest, widest)
    ax.axvline(0.0, color="0.25", lw=0.8)


def _steps(table: "Sensitivity", changes: Mapping[str, float] | None) -> tuple[dict[str, tuple[Number, float]], str]:
    """By how much numbers change, each in the unit of its key, all measured alike; and how, in words."""
    by_names, uncertain = by_name(table.scene), uncertain_numbers(table.scene)
    keys = {name: by_names[name] for name in table.parameters}
    if changes is not None:
        for changed in changes:
            known("tornado: changes", changed, [key.key for key in keys.values()])
        return {name: (key, changes[key.key]) for name, key in keys.items() if changes.get(key.key)}, ""
    if any(name in keys for name in uncertain):
        deviations = {name: (u.number, u.moments[1]) for name, u in uncertain.items() if name in keys}
        return deviations, ", by a standard deviation of each"
    steps = {}
    for name, key in keys.items():
        value = float(key.from_si(table.at[name]))
        slope = key.slope(value)
        (size,) = scales(table.scene, {name: value * slope}).tolist()
        steps[name] = key, _SHARE * size / slope
    return steps, f", by {100 * _SHARE:g} % of each"


def tornados(table: "Sensitivity", figure: Any) -> None:
    """A tornado of each output, one above the other, on an empty figure."""
    axes = figure.subplots(len(table.distinct), 1)
    for k, (output, ax) in enumerate(zip(table.distinct, axes, strict=True)):
        tornado(table, output, ax=ax, named=k == 0)


# --- grids and back-analyses -----------------------------------------------------------------------------------------


def response(study: "Study", output: str = "reach", ax: Any = None) -> Any:
    """An output over the first number of a grid; of a second one, a curve for each of its values."""
    known("response: output", output, OUTCOMES)
    levels, keys = study.design.levels, [u.key for u in study.design.inputs.values()]
    check_grid([len(x) for x in levels])
    ax = axis(ax)
    columns = study.samples[output].reshape(len(levels[0]), -1).T
    for column, (colour, dashes, marker) in zip(columns, _STYLES, strict=False):
        ax.plot(levels[0], column, color=colour, ls=dashes, marker=marker, lw=1.8, ms=4)
    if len(levels) == 2:
        legend(ax, handles=ax.lines, labels=[f"{keys[1]} = {number(x)}" for x in levels[1]])
    ax.set_ylabel(_label(output))
    ax.set_xlabel(keys[0], parse_math=False)
    ax.grid(alpha=0.3)
    return ax


def explained(analysis: "BackAnalysis", figure: Any) -> Any:
    """What was observed over each field, about the solutions, with the other fields as the first solution has them."""
    shape = len(analysis.observed), len(analysis.units)
    axes = figure.subplots(*shape, squeeze=False, sharex="col", sharey="row")
    for column, key in zip(axes.T, analysis.units, strict=True):
        _explained_by(analysis, key, column)
        column[-1].set_xlabel(key, parse_math=False)
    for ax, name in zip(axes[:, 0], analysis.observed, strict=True):
        ax.set_ylabel(_label(name))
    legend(axes[0, 0], columns=4)
    return figure


def _explained_by(analysis: "BackAnalysis", key: str, axes: Sequence[Any]) -> None:
    """The observations over one field, an axis each."""
    field = number_in(analysis.motion.plan.scene, key)
    solved = [s.values[key] for s in analysis.solutions]
    error = (analysis.solutions[0].standard_errors or {}).get(key, 0.0)
    error = error if np.isfinite(error) else 0.0
    at = _around(field, solved, error)
    curves = motions(analysis.motion.plan.scene, {field.name: field.to_si(at)}).outcomes
    for ax, (name, (seen, sigma)) in zip(axes, analysis.observed.items(), strict=True):
        ax.plot(at, curves[name], label="computed", **LINES["main"])
        ax.axhline(seen, label="observed", **LINES["total"])
        if sigma:
            ax.axhspan(seen - sigma, seen + sigma, label="its standard error", **AREAS["band"])
        reached = [OUTCOMES[name].read(s.motion) for s in analysis.solutions]
        mark(ax, solved, reached, "end", "solution")
        if error:
            ax.errorbar(solved[0], reached[0], xerr=error, fmt="none", ecolor="black")
        ax.set_xlim(at[0], at[-1])
        ax.grid(alpha=0.3)


def _around(field: Number, solved: Sequence[float], error: float) -> Any:
    """Values of a field about its solutions, within its bounds, which are open."""
    margin = max(4 * error, 0.3 * max(map(abs, solved)), np.ptp(solved))
    low = max(min(solved) - margin, field.low)
    high = min(max(solved) + margin, field.high)
    return np.linspace(low, high, _POINTS // 2)[1:-1]


def check_grid(counts: Sequence[int]) -> None:
    """Refuse a grid of so many values of each number that cannot be drawn."""
    if not 1 <= len(counts) <= 2 or (len(counts) == 2 and counts[1] > len(_STYLES)):
        raise ValueError(
            f"a picture of a grid shows one number, or two with at most {len(_STYLES)} values of the second, not "
            f"{' x '.join(map(str, counts)) or 'samples'}: give --csv or --npz"
        )


def overview(study: "Study", figure: Any) -> Any:
    """Exceedance of reach and of peak velocity, linear and logarithmic, and below what each unknown adds to them.

    Of a grid, reach and peak velocity over its numbers.
    """
    heights = _heights(study)
    grid = figure.add_gridspec(len(heights), 2, height_ratios=heights)
    for k, output in enumerate(DRAWN):
        if study.design.method == "grid":
            response(study, output, figure.add_subplot(grid[0, k]))
            continue
        exceedance(study, output, figure.add_subplot(grid[k, 0]))
        exceedance(study, output, figure.add_subplot(grid[k, 1]), rare=True)
        if study.sensitivity:
            indices(study, output, figure.add_subplot(grid[2, k]), named=k == 0)
    figure.suptitle(shorten(study.scene.name, 80), parse_math=False, fontweight="bold")
    return figure


def outcome(study: "Study", output: str, ax: Any = None) -> Any:
    """An outcome over the numbers of a grid, or the probability that samples exceed it."""
    return (response if study.design.method == "grid" else exceedance)(study, output, ax)


PANELS = {output: partial(outcome, output=output) for output in OUTCOMES}  # of `Study.plot`, besides the overview


def size(study: "Study") -> tuple[float, float]:
    """Inches of the overview."""
    return 14.0, sum(_heights(study)) + 0.4


def _heights(study: "Study") -> list[float]:
    if study.design.method == "grid":
        return [5.2]
    return [4.0, 4.0, *([1.6 + 0.55 * len(study.design.inputs)] if study.sensitivity else [])]


def _label(output: str) -> str:
    return f"{OUTCOMES[output].label} ({OUTCOMES[output].unit})"


def _check(study: "Study", output: str, choice: Iterable[str]) -> None:
    known("Study: output", output, choice)
    if study.design.method == "grid":
        raise ValueError("Study: values on a grid have no probability; draw samples of uncertain numbers")
