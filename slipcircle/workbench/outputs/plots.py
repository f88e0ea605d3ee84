"""Pictures of motions. Every function draws on a given matplotlib axis, or on one of its own, and returns it.

Matplotlib is loaded when the first picture is drawn. Texts that depend on a motion stand in a legend above the axis,
where no curve can run into them.
"""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from textwrap import shorten
from typing import Any, NamedTuple

import numpy as np

from slipcircle.core import Motion, in_time
from slipcircle.workbench.common.quantities import HISTORY, OUTCOMES, Quantity, prefixed
from slipcircle.workbench.outputs.film import animate
from slipcircle.workbench.outputs.plotstyle import (
    AREAS,
    LINES,
    axis,
    empty,
    ending,
    known,
    legend,
    lines,
    mark,
    number,
    still,
    width,
    work,
)
from slipcircle.workbench.outputs.sectionplot import section
from slipcircle.workbench.outputs.trace import Floats, drawn
from slipcircle.workbench.studies.ladder import Rung

__all__ = ["HISTORIES", "animate", "history", "ladder", "overview", "phase_plane", "section", "shaking"]


class Curve(NamedTuple):
    """A column of `HISTORY` as a curve: its line, and its name in a legend."""

    column: str
    line: str = "main"
    label: str = ""


# What `history` draws: for each picture its symbol and its curves, of which the first is the quantity itself.
HISTORIES: Mapping[str, tuple[str, tuple[Curve, ...]]] = {
    "velocity": (" $v$", (Curve("velocity"),)),
    "displacement": (" $s$", (Curve("displacement"),)),
    "rotation": (" $\\phi$", (Curve("rotation"),)),
    "friction": (
        "",
        (Curve("friction", "main", "mobilised $\\mu$"), Curve("holding_friction", "other", "required for equilibrium")),
    ),
    "normal_stress": (
        "",
        (Curve("normal_stress", "main", "total $\\sigma_n$"), Curve("effective_stress", "other", "effective")),
    ),
}
_TALL = 3.0  # times the greatest mobilised friction, up to which that required for equilibrium is in view
OVERVIEW = ("velocity", "displacement", "friction", "normal_stress")


def history(motion: Motion, what: str = "velocity", ax: Any = None, brief: bool = False) -> Any:
    """One of `HISTORIES` over time, with the peak velocity, the reach of a mass that swings back, and the end marked.

    The friction is drawn with that required for equilibrium where the mass is. A brief one stands beside another, which
    explains the marks.
    """
    known("history: what", what, HISTORIES)
    ax, columns, quantity = axis(ax), drawn(motion), HISTORY[what]
    symbol, every = HISTORIES[what]
    times, values = columns["time"], columns[what]
    curves = [curve for curve in every if curve.column == what or _differs(columns[curve.column], values)]
    factor, unit = _unit(quantity, [columns[curve.column] for curve in curves])
    ax.set(xlabel="time $t$ (s)", ylabel=f"{quantity.label}{symbol} ({unit or '–'})")
    if not motion.moves:
        return still(motion, ax)
    for curve in curves:
        label = curve.label if len(curves) > 1 else None
        ax.plot(times, factor * columns[curve.column], label=label, **LINES[curve.line])
    ax.margins(y=0.08)
    is_level = np.ptp(values) <= 1e-9 * np.max(np.abs(values))
    if what == "friction" or is_level:
        _from_zero(ax, [factor * columns[curve.column] for curve in curves])
    _mark_times(ax, motion, (times, factor * values), unit, what == "displacement", brief)
    ax.grid(alpha=0.3)
    ax.set_xlim(0.0, motion.duration)
    legend(ax)
    if what == "displacement":
        _rotation_axis(ax, float(np.asarray(motion.plan.scene.arc.radius)))
    return ax


def _unit(quantity: Quantity, curves: Sequence[Floats]) -> tuple[float, str]:
    """A factor for curves of a quantity, and the unit that they then have."""
    return (math.degrees(1.0), "deg") if quantity.degrees else prefixed(np.concatenate(curves), quantity.unit)


def _mark_times(
    ax: Any, motion: Motion, curve: tuple[Floats, Floats], unit: str, with_reach: bool, brief: bool
) -> None:
    """Marks on a curve over time, each with its value, and unless it is a brief one with its name and its time."""
    for role, time, name in _marks(motion, with_reach):
        value = _read(time, *curve)
        label = f"{number(value)} {unit}".rstrip()
        if not brief or role == "reach":
            label = f"{name}: {label} at {number(time)} s"
        ax.axvline(time, **LINES["help"])
        mark(ax, time, value, role, label)


def _from_zero(ax: Any, curves: Sequence[Floats]) -> None:
    """Show curves above zero, the others up to `_TALL` times the greatest value of the first.

    Where next to nothing presses no friction is enough for equilibrium.
    """
    tops = [float(np.max(curve, initial=0.0, where=np.isfinite(curve))) for curve in curves]
    top = min(max(tops), _TALL * tops[0] or math.inf)
    ax.set_ylim(-0.08 * top, 1.16 * top or 1.0)


def _rotation_axis(ax: Any, radius: float) -> None:
    """The rotation on the right of an axis of displacements."""
    degrees = math.degrees(1.0 / radius)
    side = ax.secondary_yaxis(
        "right", functions=(lambda s: np.multiply(s, degrees), lambda phi: np.divide(phi, degrees))
    )
    side.set_ylabel("rotation $\\phi$ (deg)")


def histories(motion: Motion, axes: Iterable[Any]) -> None:
    """All of `OVERVIEW`, of which the first says what the marks are, and the lowest that time runs to the right."""
    for k, (what, ax) in enumerate(zip(OVERVIEW, axes, strict=True)):
        history(motion, what, ax, brief=k > 0)
        if motion.moves and not ax.get_subplotspec().is_last_row():
            ax.set_xlabel("")
            ax.tick_params(labelbottom=False)


def _marks(motion: Motion, with_reach: bool = False) -> list[tuple[str, float, str]]:
    """Mark, time and words of the peak velocity, of the reach of a mass that swings back, and of the end."""
    marks = [("peak", float(motion.peak.time), "peak velocity")]
    if with_reach and motion.swings_back:
        marks.append(("reach", float(motion.reach.time), "farthest"))
    return [*marks, ("end", motion.duration, ending(motion))]


def _read(time: float, times: Floats, values: Floats) -> float:
    """A column at one of its times; 0 for what rounding left of it."""
    value = float(np.interp(time, times, values))
    return 0.0 if abs(value) < 1e-9 * float(np.max(np.abs(values))) else value


def _differs(one: Floats, other: Floats) -> bool:
    """Whether there is a curve, and another one."""
    return bool(np.any(np.isfinite(one))) and not np.allclose(one, other, rtol=1e-9, atol=0.0, equal_nan=True)


def phase_plane(motion: Motion, ax: Any = None) -> Any:
    """Speed against displacement; behind it the energy, stacked: what is lost and what is kinetic make up the work.

    Of a mass that turns back, the path travelled stands for the displacement.
    """
    ax, columns = axis(ax), drawn(motion)
    steps = np.diff(columns["displacement"])
    turns_back = bool(np.any(steps < 0.0) and np.any(steps > 0.0))
    along = columns["path" if turns_back else "displacement"]
    ax.set_xlabel("path travelled, as it turns back (m)" if turns_back else "displacement $s$ (m)")
    unit = _energies(motion, ax, along)
    of_width, per = width(motion)
    ax.set_ylabel(f"energy {of_width} ({unit}{per})")
    if not motion.moves:
        return still(motion, ax)
    farthest = float(along[np.argmax(np.abs(along))])
    ax.set_xlim(0.0, farthest)  # to the left too the way is drawn from left to right
    right = ax.twinx()
    speed = np.abs(columns["velocity"])
    right.plot(along, speed, label="speed", **LINES["main"])
    for role, time, words in _marks(motion):
        place, height = (_read(time, columns["time"], column) for column in (along, speed))
        mark(right, place, height, role, f"{words}: {number(height)} m/s at {number(place)} m")
    right.set_ylabel("speed $|v|$ (m/s)")
    right.set_ylim(0.0, 1.05 * float(np.max(speed)))
    entries = [side.get_legend_handles_labels() for side in (ax, right)]
    handles, labels = (left + right for left, right in zip(*entries, strict=True))
    legend(ax, columns=3, handles=handles, labels=labels)
    return ax


def _energies(motion: Motion, ax: Any, along: Floats) -> str:
    """Dissipation and kinetic energy, stacked, below the work that both come from; their unit."""
    columns = drawn(motion)
    at_start = float(columns["kinetic_energy"][0])
    supplied = at_start + columns["work_of_gravity_and_shaking"]
    factor, unit = prefixed(np.concatenate([supplied, columns["dissipation"]]), "J")
    if motion.moves:
        dissipation = factor * columns["dissipation"]
        total = dissipation + factor * columns["kinetic_energy"]
        ax.fill_between(along, 0.0, dissipation, label="dissipation", **AREAS["dissipation"])
        ax.fill_between(along, dissipation, total, label="kinetic energy", **AREAS["kinetic"])
        words = work(motion) + (" and first kinetic energy" if at_start else "")
        ax.plot(along, factor * supplied, label=words, **LINES["total"])
        ax.set_ylim(0.0, 1.05 * float(np.max(total)))
    return unit


def shaking(motion: Motion, ax: Any = None) -> Any:
    """What shakes the scene, over gravity, until it rests, or all of it where it does not move.

    Beside it stands the yield coefficient at the start: a mass at rest starts when k_h passes it, k_v apart, as long as
    its position and its friction are those of the start.
    """
    ax = axis(ax, (7.0, 2.5))
    ax.set(xlabel="time $t$ (s)", ylabel="shaking over $g$ (–)")
    functions = {n: f for n, f in in_time(motion.plan.scene.called).items() if n.startswith("shaking.")}
    kinks = [np.asarray(function.kinks) for function in functions.values()]
    if not functions:
        return empty("not shaken", ax, "x", "y")
    if motion.moves:
        last, times = motion.duration, drawn(motion)["time"]
    else:
        last = float(np.max(np.concatenate(kinks)))
        times = np.unique(np.concatenate([np.linspace(0, last, 401), *kinks]))
    for way, label, line in (
        ("horizontal", "down-slope $k_h$", "main"),
        ("vertical", "vertical $k_v$, reduces the weight", "other"),
    ):
        if (function := functions.get(f"shaking.{way}")) is not None:
            ax.plot(times, function(times), label=label, **{**LINES[line], "lw": 1.2})
    yields = motion.yield_coefficient
    ax.axhline(yields, label=f"yields at the start: $k_y$ = {number(yields)}", **{**LINES["total"], "lw": 1.2})
    ax.set_xlim(0.0, last)
    ax.grid(alpha=0.3)
    legend(ax, columns=3)
    return ax


def ladder(rungs: Iterable[Rung], ax: Any = None) -> Any:
    """The run-out as the effects of a scene are added one by one, beside that of the whole scene."""
    ax, rungs = axis(ax, (9.0, 3.5)), list(rungs)
    lines(ax, [f"+ {r.added}" if r.added else "no effect" for r in rungs])
    unexplained = {"rests": "comes to rest", "moves on": "does not come to rest"}
    for place, r in enumerate(rungs):
        role = "rests" if r.arrested else "moves on"
        ax.barh(place, r.run_out, height=0.62, label=unexplained.pop(role, None), **AREAS[role])
    ax.axvline(rungs[-1].run_out, label=f"with all effects: {number(rungs[-1].run_out)} m", **LINES["help"])
    ax.set_xlabel("run-out along the arc (m)")
    side = ax.secondary_yaxis("right")
    side.set_yticks(range(len(rungs)), [_rung_words(r) for r in rungs])
    side.tick_params(length=0)
    legend(ax, columns=3)
    return ax


def _rung_words(rung: Rung) -> str:
    """How far, how fast and how long the mass of a rung moves."""
    if not rung.peak_velocity:
        return "does not move"
    end = "at rest after" if rung.arrested else "still moving at"
    return f"{number(rung.run_out)} m, peak {number(rung.peak_velocity)} m/s, {end} {number(rung.duration)} s"


def overview(motion: Motion, figure: Any) -> Any:
    """The section, the phase plane and the histories on an empty figure or subfigure of `size`, which it returns."""
    shaken = "shaking" in motion.plan.effects
    if motion.moves:
        left, right = figure.add_gridspec(1, 2, width_ratios=(1.15, 1.0))
        top, bottom = left.subgridspec(2, 1, height_ratios=(1.2, 1.0)).subplots()
        axes = right.subgridspec(len(OVERVIEW) + shaken, 1).subplots()
        phase_plane(motion, bottom)
        histories(motion, axes[: len(OVERVIEW)])
    else:
        heights = (3, 1)[: 1 + shaken]
        top, *axes = figure.subplots(len(heights), 1, height_ratios=heights, squeeze=False)[:, 0]
    section(motion, top)
    if shaken:
        shaking(motion, axes[-1])
    figure.suptitle(_title(motion), parse_math=False, fontweight="bold")
    return figure


def _title(motion: Motion) -> str:
    """A scene's name and what happened."""
    outcome = "does not move"
    if motion.moves:
        run_out, duration = (OUTCOMES[name].text(motion) for name in ("run_out", "duration"))
        outcome = f"{run_out} in {duration}, {ending(motion)}"
    return ": ".join(filter(None, (shorten(motion.plan.scene.name, 80), outcome)))


# What `Motion.plot` draws besides the overview.
PANELS: Mapping[str, Callable[..., Any]] = {
    "section": section,
    "energy": phase_plane,
    "shaking": shaking,
    **{what: partial(history, what=what) for what in HISTORIES},
}


def size(motion: Motion) -> tuple[float, float]:
    """Inches of the overview."""
    return 14.0, 12.0 if "shaking" in motion.plan.effects else 10.0
