"""Pictures of uncertain scenes: exceedance curves, sensitivity indices, and what a change of each number changes.

Every function draws one of `OUTCOMES` on a given matplotlib axis, or on one of its own, and returns it.
"""

import re
from collections.abc import Iterable, Mapping, Sequence
from textwrap import shorten
from typing import TYPE_CHECKING, Any

import numpy as np

from slipcircle.workbench.common.quantities import OUTCOMES
from slipcircle.workbench.files.numbers import by_name, number_in
from slipcircle.workbench.outputs.plotstyle import AREAS, LINES, axis, empty, known, legend, lines, mark, number
from slipcircle.workbench.studies.motions import motions
from slipcircle.workbench.studies.statistics import BEYOND

if TYPE_CHECKING:
    from slipcircle.core.motion.derivatives import Sensitivity
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
_STEPS = {"deg": 1.0, "x": 0.1, "y": 0.1}  # of changes that a tornado draws, by the end of a key: degrees, m
_SHARE = 0.01  # of all others


def exceedance(found: "Study", output: str = "reach", ax: Any = None, rare: bool = False) -> Any:
    """The probability that an output is at least so large, in its confidence band, with two quantiles marked.

    It ends at the share of the samples that slide to no known end, which exceed every value. On a logarithmic axis,
    where what is rare shows, it stands beside the linear one, which has the legend.
    """
    _check(found, output, OUTCOMES)
    ax, unit = axis(ax), OUTCOMES[output].unit
    ax.set(xlabel=_label(output), ylabel="exceedance probability (–)", ylim=(-0.02, 1.02))
    ax.grid(alpha=0.3)
    curve, moving = found.exceedance(output, _POINTS), found.moving
    if not found.n:
        return empty("no sample is a scene", ax, "x")
    if not curve.at.size:
        sliding = f"{found.without_result} of {found.n} samples slide without a result,\nno other moves"
        return empty(sliding if found.without_result else "nothing moves", ax, "x")
    at = np.concatenate([[0.0], curve.at])  # whatever moves has a run-out, a velocity and a duration above 0
    value, low, high = (np.concatenate([[first], rest]) for first, rest in zip(moving, curve[1:], strict=True))
    ax.fill_between(at, low, high, label=f"{100 * found.confidence:g} % confidence at each place", **AREAS["band"])
    ax.plot(at, value, label=_samples(found), **LINES["main"])
    for role, p, words in (("peak", 0.5, "median"), ("end", 0.95, "exceeded by 5 %")):
        place = found.quantile(output, p).value
        if 0.0 < place < np.inf:
            mark(ax, place, np.interp(place, at, value), role, f"{words}: {number(place)} {unit}")
        elif place == np.inf:
            ax.plot([], [], ls="", label=f"{words}: {BEYOND}")
    top = float(at[-1])
    certain = float(at[np.flatnonzero(value == 1.0)[-1]]) if moving.value == 1.0 else 0.0
    left = max(0.0, certain - 0.05 * (top - certain)) if certain > 0.4 * top else 0.0
    ax.set_xlim(left, top + 0.02 * (top - certain))
    if rare:
        ax.set(yscale="log", ylim=(0.5 / found.n, 1.5))
    else:
        legend(ax)
    return ax


def _samples(found: "Study") -> str:
    """How many samples a curve is of, and which it does not show."""
    beyond, invalid = found.without_result, found.design.n - found.n
    words = [f"{found.n} samples", f"{beyond} of them beyond every value" * (beyond > 0)]
    return ", ".join(filter(None, [*words, f"{invalid} more are no scene" * (invalid > 0)]))


def indices(found: "Study", output: str = "reach", ax: Any = None, named: bool = True) -> Any:
    """The sensitivity indices of an output: what share of its variance each unknown explains, with confidence."""
    _check(found, output, (*OUTCOMES, "moves"))
    if output not in found.sensitivity:
        raise ValueError("indices: this ensemble has none: give it two uncertain numbers and base points at least")
    keys, of = [u.key for u in found.design.inputs.values()], found.sensitivity[output]
    order = np.argsort([-e.value for e in of.total], kind="stable").tolist()
    ax = axis(ax, (7.0, 1.6 + 0.6 * len(keys)))
    what = OUTCOMES[output].label if output in OUTCOMES else "whether it moves"
    ax.set(xlabel=f"share of the variance of {what} (–)")
    lines(ax, [keys[k] for k in order])
    shown = np.array([(*of.first[k], *of.total[k]) for k in order])
    if not np.all(np.isfinite(shown[:, [0, 3]])):
        return empty("does not vary", ax, "x")
    for place, words, style, (value, low, high) in (
        (-0.19, "on its own (first-order)", "rests", shown[:, :3].T),
        (0.19, "together with others (total)", "kinetic", shown[:, 3:].T),
    ):
        at = np.arange(len(keys)) + place
        ax.barh(at, np.maximum(value, 0.0), height=0.36, label=words, **AREAS[style])
        error = np.nan_to_num([value - low, high - value])
        ax.errorbar(value, at, xerr=error, fmt="none", ecolor="black", elinewidth=1.2, capsize=3)
    low, high = np.nanmin(shown), np.nanmax(shown)
    ax.set_xlim(min(0.0, 1.1 * low) if low < -0.01 else 0.0, max(1.0, 1.05 * high))
    ax.axvline(0.0, color="0.25", lw=0.8)
    if named:
        legend(ax, columns=1)  # names of keys may leave little room beside
    return ax


def tornado(
    table: "Sensitivity",
    output: str = "run_out",
    changes: Mapping[str, float] | None = None,
    ax: Any = None,
    named: bool = True,
) -> Any:
    """How much an output changes, to first order, with a change of each number of a scene; the largest on top.

    ``changes`` tells by how much each number changes, in the unit of its key in a scene file,
    ``{"friction.angle_deg": 2.0}``, and only these are drawn; by default each angle by 1 degree, each coordinate by
    0.1 m, all else by 1 %. ``named`` tells whether the axis has a legend.
    """
    known("tornado: output", output, table.outputs)
    known_keys = by_name(table.scene)
    for changed in changes or ():
        known("tornado: changes", changed, [known_keys[name].key for name in table.parameters])
    bars = []
    for name, by_si in zip(table.parameters, table.values[list(table.outputs).index(output)], strict=True):
        key = known_keys[name]
        value, whole = float(key.from_si(table.at[name])), _STEPS.get(re.split(r"[_.]", key.key)[-1])
        step = (whole or _SHARE * abs(value)) if changes is None else changes.get(key.key, 0.0)
        slope = float(by_si * key.slope(value))
        said = f"{number(value)} ± " + (f"{100 * _SHARE:g} %" if changes is None and not whole else f"{step:.3g}")
        if step and (slope or changes is not None):
            bars.append((slope * step, f"{key.key} = {said}"))
    ax = axis(ax, (7.0, 1.6 + 0.4 * max(2, len(bars))))
    unit, at = table.outputs[output], table.at[output]
    ax.set(xlabel=f"change of {OUTCOMES[output].label} from {number(at)} {unit} ({unit})")
    if not at or not bars:
        return empty("nothing changes it" if at else "does not move", ax, "x", "y")
    bars.sort(key=lambda bar: -abs(bar[0]))
    lines(ax, [words for _, words in bars])
    for sign, words, style in ((1.0, "larger", "kinetic"), (-1.0, "smaller", "rests")):
        ax.barh(range(len(bars)), [sign * x for x, _ in bars], height=0.62, label=words, **AREAS[style])
    widest = 1.08 * abs(bars[0][0])
    ax.set_xlim(-widest, widest)
    ax.axvline(0.0, color="0.25", lw=0.8)
    if named:
        legend(ax)
    return ax


def tornados(found: "Sensitivity", figure: Any) -> None:
    """A tornado of each output, one above the other, on an empty figure."""
    for k, (output, ax) in enumerate(zip(found.distinct, figure.subplots(len(found.distinct), 1), strict=True)):
        tornado(found, output, ax=ax, named=k == 0)


def response(found: "Study", output: str = "reach", ax: Any = None) -> Any:
    """An output over the first number of a grid; of a second one, a curve for each of its values."""
    known("response: output", output, OUTCOMES)
    levels, keys = found.design.levels, [u.key for u in found.design.inputs.values()]
    check_grid([len(x) for x in levels])
    ax = axis(ax)
    values = np.where(np.isnan(found.samples["peak_velocity"]), np.nan, found.samples[output])
    for column, (colour, dashes, marker) in zip(values.reshape(len(levels[0]), -1).T, _STYLES, strict=False):
        ax.plot(levels[0], column, color=colour, ls=dashes, marker=marker, lw=1.8, ms=4)
    if len(levels) == 2:
        legend(ax, handles=ax.lines, labels=[f"{keys[1]} = {number(x)}" for x in levels[1]])
    ax.set_ylabel(_label(output))
    ax.set_xlabel(keys[0], parse_math=False)
    ax.grid(alpha=0.3)
    return ax


def explained(found: "BackAnalysis", figure: Any) -> Any:
    """What was observed over each field, about the solutions, with the other fields as the first solution has them."""
    scene, best = found.motion.plan.scene, found.solutions[0]
    every = figure.subplots(len(found.observed), len(found.units), squeeze=False, sharex="col", sharey="row")
    for column, key in enumerate(found.units):
        number_of = number_in(scene, key)
        solved = [s.values[key] for s in found.solutions]
        error = (best.standard_errors or {}).get(key, 0.0)
        wide = max(4 * error if np.isfinite(error) else 0.0, 0.3 * max(map(abs, solved)), np.ptp(solved))
        low, high = max(min(solved) - wide, number_of.low), min(max(solved) + wide, number_of.high)
        at = np.linspace(low, high, _POINTS // 2)[1:-1]
        curves = motions(scene, {number_of.name: number_of.to_si(at)}).outcomes
        for ax, (name, (seen, sigma)) in zip(every[:, column], found.observed.items(), strict=True):
            ax.plot(at, curves[name], label="computed", **LINES["main"])
            ax.axhline(seen, label="observed", **LINES["total"])
            if sigma:
                ax.axhspan(seen - sigma, seen + sigma, label="its standard error", **AREAS["band"])
            reached = [OUTCOMES[name].read(s.motion) for s in found.solutions]
            mark(ax, solved, reached, "end", "solution")
            if error and np.isfinite(error):
                ax.errorbar(solved[0], reached[0], xerr=error, fmt="none", ecolor="black")
            ax.set_xlim(low, high)
            ax.grid(alpha=0.3)
            if column == 0:
                ax.set_ylabel(_label(name))
        every[-1, column].set_xlabel(key, parse_math=False)
    legend(every[0, 0], columns=4)
    return figure


def check_grid(counts: Sequence[int]) -> None:
    """Refuse a grid of so many values of each number that cannot be drawn."""
    if not 1 <= len(counts) <= 2 or (len(counts) == 2 and counts[1] > len(_STYLES)):
        raise ValueError(
            f"a picture of a grid shows one number, or two with at most {len(_STYLES)} values of the second, not "
            f"{' x '.join(map(str, counts)) or 'samples'}: give --csv or --npz"
        )


def overview(found: "Study", figure: Any) -> Any:
    """Exceedance of reach and of peak velocity, linear and logarithmic, and below what each unknown adds to them.

    Of a grid, reach and peak velocity over its numbers.
    """
    heights = _heights(found)
    grid = figure.add_gridspec(len(heights), 2, height_ratios=heights)
    for k, output in enumerate(DRAWN):
        if found.design.method == "grid":
            response(found, output, figure.add_subplot(grid[0, k]))
            continue
        exceedance(found, output, figure.add_subplot(grid[k, 0]))
        exceedance(found, output, figure.add_subplot(grid[k, 1]), rare=True)
        if found.sensitivity:
            indices(found, output, figure.add_subplot(grid[2, k]), named=k == 0)
    figure.suptitle(shorten(found.scene.name, 80), parse_math=False, fontweight="bold")
    return figure


def size(found: "Study") -> tuple[float, float]:
    """Inches of the overview."""
    return 14.0, sum(_heights(found)) + 0.4


def _heights(found: "Study") -> list[float]:
    if found.design.method == "grid":
        return [5.2]
    return [4.0, 4.0, *([1.6 + 0.55 * len(found.design.inputs)] if found.sensitivity else [])]


def _label(output: str) -> str:
    return f"{OUTCOMES[output].label} ({OUTCOMES[output].unit})"


def _check(found: "Study", output: str, choice: Iterable[str]) -> None:
    known("Study: output", output, choice)
    if found.design.method == "grid":
        raise ValueError("Study: values on a grid have no probability; draw samples of uncertain numbers")
