"""Pictures of motions. Every function draws on a given matplotlib axis, or on one of its own, and returns it.

Matplotlib is loaded when the first picture is drawn. Texts that depend on a motion stand in a legend above the axis,
where no curve can run into them.
"""

import math
from collections.abc import Iterable, Mapping
from textwrap import shorten
from typing import Any

import numpy as np

from slipcircle.core import Motion, in_time
from slipcircle.workbench.common.quantities import HISTORY, prefixed
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
from slipcircle.workbench.outputs.sectionplot import animate, section
from slipcircle.workbench.outputs.trace import Floats, drawn
from slipcircle.workbench.studies.ladder import Rung

__all__ = ["HISTORIES", "animate", "history", "ladder", "overview", "phase_plane", "section", "shaking"]

# What `history` draws: for each picture its symbol, and columns of `HISTORY` with their line and name.
HISTORIES: Mapping[str, tuple[str, tuple[tuple[str, str, str], ...]]] = {
    "velocity": (" $v$", (("velocity", "main", ""),)),
    "displacement": (" $s$", (("displacement", "main", ""),)),
    "rotation": (" $\\phi$", (("rotation", "main", ""),)),
    "friction": (
        "",
        (("friction", "main", "mobilised $\\mu$"), ("holding_friction", "other", "needed to stand still")),
    ),
    "normal_stress": ("", (("normal_stress", "main", "total $\\sigma_n$"), ("effective_stress", "other", "effective"))),
}
_TALL = 3.0  # the friction needed to stand still is seen up to so many times the greatest mobilised one
OVERVIEW = ("velocity", "displacement", "friction", "normal_stress")


def history(motion: Motion, what: str = "velocity", ax: Any = None, brief: bool = False) -> Any:
    """One of `HISTORIES` over time, with the peak velocity, the reach of a mass that swings back, and the end marked.

    Besides the friction stands the one at which the mass would stand still where it is. A brief one stands beside
    another, which says what the marks are and when.
    """
    known("history: what", what, HISTORIES)
    ax = axis(ax)
    symbol, curves = HISTORIES[what]
    quantity, columns = HISTORY[what], drawn(motion)
    first = columns[what]
    curves = tuple(c for c in curves if c[0] == what or _differs(columns[c[0]], first))
    factor, unit = prefixed(np.concatenate([columns[c] for c, _, _ in curves]), quantity.unit)
    if quantity.degrees:
        factor, unit = math.degrees(1.0), "deg"
    ax.set(xlabel="time $t$ (s)", ylabel=f"{quantity.label}{symbol} ({unit or '–'})")
    if not motion.moves:
        return still(motion, ax)
    for column, line, name in curves:
        ax.plot(columns["time"], factor * columns[column], label=name if len(curves) > 1 else None, **LINES[line])
    for role, time, words in _marks(motion, what == "displacement"):
        value = factor * _read(time, columns["time"], first)
        seen = f"{number(value)} {unit}".rstrip()
        ax.axvline(time, **LINES["help"])
        mark(ax, time, value, role, seen if brief and role != "reach" else f"{words}: {seen} at {number(time)} s")
    ax.grid(alpha=0.3)
    ax.margins(y=0.08)
    ax.set_xlim(0.0, motion.duration)
    if what == "friction" or np.ptp(first) <= 1e-9 * np.max(np.abs(first)):  # also a level line stands above zero
        tops = [factor * float(np.max(columns[c], initial=0.0, where=np.isfinite(columns[c]))) for c, _, _ in curves]
        top = min(max(tops), _TALL * tops[0] or math.inf)  # where next to nothing presses, no friction is enough
        ax.set_ylim(-0.08 * top, 1.16 * top or 1.0)
    legend(ax)
    if what == "displacement":
        turn = math.degrees(1.0 / float(np.asarray(motion.plan.scene.arc.radius)))
        side = ax.secondary_yaxis("right", functions=(lambda s: np.multiply(s, turn), lambda x: np.divide(x, turn)))
        side.set_ylabel("rotation $\\phi$ (deg)")
    return ax


def histories(motion: Motion, axes: Iterable[Any]) -> None:
    """All of `OVERVIEW`, of which the first says what the marks are, and the lowest that time runs to the right."""
    for k, (what, ax) in enumerate(zip(OVERVIEW, axes, strict=True)):
        history(motion, what, ax, brief=k > 0)
        if motion.moves and not ax.get_subplotspec().is_last_row():
            ax.set_xlabel("")
            ax.tick_params(labelbottom=False)


def _marks(motion: Motion, places: bool = False) -> list[tuple[str, float, str]]:
    """Mark, time and words of the peak velocity, of the reach where places are drawn, and of the end."""
    farthest = [("reach", float(motion.reach.time), "farthest")] if places and motion.swings_back else []
    return [("peak", float(motion.peak.time), "peak velocity"), *farthest, ("end", motion.duration, ending(motion))]


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
    ax = axis(ax)
    columns = drawn(motion)
    ways = np.diff(columns["displacement"])
    back = bool(np.any(ways < 0.0) and np.any(ways > 0.0))
    along = columns["path"] if back else columns["displacement"]
    first = float(columns["kinetic_energy"][0])
    given = first + columns["work_of_gravity_and_shaking"]
    factor, unit = prefixed(np.concatenate([given, columns["dissipation"]]), "J")
    way = "path travelled, as it turns back" if back else "displacement $s$"
    of_width, per = width(motion)
    ax.set(xlabel=f"{way} (m)", ylabel=f"energy {of_width} ({unit}{per})")
    if not motion.moves:
        return still(motion, ax)
    lost, kinetic = factor * columns["dissipation"], factor * columns["kinetic_energy"]
    ax.fill_between(along, 0.0, lost, label="dissipation", **AREAS["dissipation"])
    ax.fill_between(along, lost, lost + kinetic, label="kinetic energy", **AREAS["kinetic"])
    name = work(motion) + (" and first kinetic energy" if first else "")
    ax.plot(along, factor * given, label=name, **LINES["total"])
    ax.set_xlim(0.0, float(along[np.argmax(np.abs(along))]))  # to the left too the way is drawn from left to right
    ax.set_ylim(0.0, 1.05 * float(np.max(lost + kinetic)))
    right = ax.twinx()
    speed = np.abs(columns["velocity"])
    right.plot(along, speed, label="speed", **LINES["main"])
    for role, time, words in _marks(motion):
        place, height = (_read(time, columns["time"], c) for c in (along, speed))
        mark(right, place, height, role, f"{words}: {number(height)} m/s at {number(place)} m")
    right.set_ylabel("speed $|v|$ (m/s)")
    right.set_ylim(0.0, 1.05 * float(np.max(speed)))
    handles, labels = (a + b for a, b in zip(*(x.get_legend_handles_labels() for x in (ax, right)), strict=True))
    legend(ax, columns=3, handles=handles, labels=labels)
    return ax


def shaking(motion: Motion, ax: Any = None) -> Any:
    """What shakes the scene, over gravity, until it rests, or all of it where it does not move.

    Beside it stands the yield coefficient at the start: a mass at rest starts when k_h passes it, k_v apart, as long as
    its position and its friction are those of the start.
    """
    ax = axis(ax, (7.0, 2.5))
    ax.set(xlabel="time $t$ (s)", ylabel="shaking over $g$ (–)")
    given = in_time(motion.plan.scene.called)
    knots = [np.asarray(function.kinks) for name, function in given.items() if name.startswith("shaking.")]
    if not knots:
        return empty("not shaken", ax, "x", "y")
    last = motion.duration if motion.moves else float(np.max(np.concatenate(knots)))
    at = drawn(motion)["time"] if motion.moves else np.unique(np.concatenate([np.linspace(0, last, 401), *knots]))
    for way, label, line in (("horizontal", "down-slope $k_h$", "main"), ("vertical", "lightening $k_v$", "other")):
        if (function := given.get(f"shaking.{way}")) is not None:
            ax.plot(at, function(at), label=label, **{**LINES[line], "lw": 1.2})
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
    name = shorten(motion.plan.scene.name, 80)
    shaken = "shaking" in motion.plan.effects
    if motion.moves:
        left, right = figure.add_gridspec(1, 2, width_ratios=(1.15, 1.0))
        top, bottom = left.subgridspec(2, 1).subplots()
        axes = right.subgridspec(len(OVERVIEW) + shaken, 1).subplots()
        phase_plane(motion, bottom)
        histories(motion, axes[: len(OVERVIEW)])
    else:
        name = ": ".join(filter(None, (name, "does not move")))
        top, *axes = figure.subplots(1 + shaken, 1, height_ratios=(3, 1)[: 1 + shaken], squeeze=False)[:, 0]
    section(motion, top)
    if shaken:
        shaking(motion, axes[-1])
    figure.suptitle(name, parse_math=False, fontweight="bold")
    return figure


def size(motion: Motion) -> tuple[float, float]:
    """Inches of the overview."""
    return 14.0, 12.0 if "shaking" in motion.plan.effects else 10.0
