"""Pictures of motions. Every function draws on the given matplotlib axis, or on a new axis, and returns the axis.

Matplotlib is loaded when the first picture is drawn. Labels are beside their curves, in the same colour.
"""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from slipcircle.base.kinds import ArrayPair, Floats, TextMap, TextPair
from slipcircle.base.text import output_unit
from slipcircle.core import Motion
from slipcircle.layers import LayeredSection
from slipcircle.messages import standing, swings_back
from slipcircle.tables import in_time
from slipcircle.workbench.common.quantities import HISTORY, Quantity, prefixed
from slipcircle.workbench.common.trace import columns_of_picture
from slipcircle.workbench.outputs.pictures.comparison import ladder
from slipcircle.workbench.outputs.pictures.film import slide_animation
from slipcircle.workbench.outputs.pictures.layerplot import stress_along
from slipcircle.workbench.outputs.pictures.plotstyle import (
    AREAS,
    LINES,
    add_label,
    add_mark,
    anchors_along,
    check_choice,
    curve,
    empty,
    ending,
    formatted_amount,
    formatted_number,
    label_direction,
    outcome_words,
    panel,
    still,
    width,
    work,
)
from slipcircle.workbench.outputs.pictures.sectionplot import section
from slipcircle.workbench.outputs.pictures.sheets import Drawing, heading, sheet

__all__ = ["HISTORIES", "history", "ladder", "motion_overview", "phase_plane", "section", "shaking", "slide_animation"]

# Symbols of the quantities that `history` draws.
HISTORIES: TextMap = {
    "velocity": " $v$",
    "displacement": " $s$",
    "rotation": " $\\phi$",
    **dict.fromkeys(("friction", "strength", "normal_stress"), ""),
}
# Label of a quantity beside a second quantity, with the name and the label of the latter.
_COMPARED: Mapping[str, tuple[str, str, str]] = {
    "friction": ("mobilised $\\mu$", "holding_friction", "required for equilibrium"),
    "strength": ("mobilised", "required_strength", "required for equilibrium"),
    "normal_stress": ("total $\\sigma_n$", "effective_stress", "effective"),
}
_TALL = 3.0  # greatest required friction in view, over the greatest mobilised friction
_SECTION = 3.9  # height of the section, inches
_PANEL = 2.3  # height of a row of panels, inches


def history(motion: Motion, what: str = "velocity", ax: Any = None, brief: bool = False) -> Any:
    """Draw a quantity of `HISTORIES` over time, with the peak velocity and the end; return the axis.

    A displacement is also marked at the run-out of a mass that swings back. The friction is drawn with the friction
    required for equilibrium at the same position. In a ``brief`` panel the marks are not named, as the panel beside it
    names them.
    """
    check_choice("history: what", what, HISTORIES)
    columns = columns_of_picture(motion)
    quantity = HISTORY[what]
    times = columns["time"]
    name, second, name_of_second = _COMPARED.get(what, ("", what, ""))
    curves = {"main": columns[what]}
    if _differs(columns[second], columns[what]):
        curves["other"] = columns[second]
    factor, unit = _unit(quantity, [*curves.values()])
    curves = {line: factor * values for line, values in curves.items()}
    words = f"{quantity.label}{HISTORIES[what]} ({unit or '–'})"
    ax = panel(ax, quantity.label, ("time $t$ (s)",), (words,))
    if not motion.moves:
        return still(motion, ax)
    for line, values in curves.items():
        curve(ax, motion, times, values, **LINES[line])
    _limit(ax, motion, what in ("friction", "strength"), [*curves.values()])
    _mark_times(ax, motion, (times, curves["main"]), unit, what == "displacement", brief)
    if what == "displacement":
        _rotation_axis(ax, motion)
    for line, words in zip(curves, (name, name_of_second) * (len(curves) > 1), strict=False):
        add_label(ax, words, _in_view(ax, times, curves[line]), LINES[line]["color"])
    return ax


def _unit(quantity: Quantity, curves: Sequence[Floats]) -> tuple[float, str]:
    """Return the factor from SI units to the unit of drawn curves of a quantity, and the name of the unit.

    ``curves`` are the values in SI units, whose size determines the unit.
    """
    if quantity.degrees:
        return (math.degrees(1.0), "deg")
    return prefixed(np.concatenate(curves), quantity.unit)


def _limit(ax: Any, motion: Motion, from_zero: bool, curves: Sequence[Floats]) -> None:
    """Set the limits: the whole duration, room for labels, and zero for friction and constant quantities.

    Curves after the first are shown up to `_TALL` times the greatest value of the first, as the friction required for
    equilibrium grows without bound when the normal stress vanishes.
    """
    values = curves[0]
    ax.margins(y=0.16)
    if from_zero or np.ptp(values) <= 1e-9 * np.max(np.abs(values)):
        greatest, *tops = (float(np.max(curve, initial=0.0, where=np.isfinite(curve))) for curve in curves)
        top = min(max(greatest, *tops, 0.0), _TALL * greatest or math.inf)
        ax.set_ylim(-0.08 * top, 1.16 * top or 1.0)
    ax.set_xlim(0.0, motion.settling_time)


def _mark_times(ax: Any, motion: Motion, curve: ArrayPair, unit: str, with_run_out: bool, brief: bool) -> None:
    """Mark times on a curve with their values, and unless ``brief`` with their names and times.

    ``curve`` has times in s and values in the drawn unit; ``with_run_out`` also marks the run-out of a mass that swings
    back.
    """
    for role, time, name in _marks(motion, with_run_out):
        value = _read(time, *curve)
        words = f"{formatted_number(value)} {unit}".rstrip()
        if not brief or role == "farthest":
            if value:
                words = f"{name}: {words}\nat {formatted_number(time)} s"
            else:
                words = f"{name}\nafter {formatted_number(time)} s"
        ax.axvline(time, **LINES["help"])
        add_mark(ax, time, value, role, words)


def _in_view(ax: Any, times: Floats, values: Floats) -> Floats:
    """Return points of a curve in view, (points, 2), for its label, away from both ends of the time axis.

    Times are in s, and values in the drawn unit.
    """
    left, right = ax.get_xlim()
    low, high = ax.get_ylim()
    margin = 0.1 * (right - left)
    inside = (left + margin < times) & (times < right - margin) & (low < values) & (values < high)
    if np.any(inside):
        shown = inside
    else:
        shown = slice(None)
    return anchors_along(times[shown], values[shown])


def _rotation_axis(ax: Any, motion: Motion) -> None:
    """Add an axis of rotations in deg to the right of displacements."""
    radius, _ = output_unit("m")
    degrees = math.degrees(1.0 / (radius * float(np.asarray(motion.plan.scene.arc.radius))))
    functions = partial(np.multiply, degrees), partial(np.multiply, 1.0 / degrees)
    ax.secondary_yaxis("right", functions=functions).set_ylabel("rotation $\\phi$ (deg)")


def _marks(motion: Motion, with_run_out: bool = False) -> Iterator[tuple[str, float, str]]:
    """Yield role in `MARKS`, time in s and label of the peak velocity, perhaps of the run-out, and of the end.

    With ``with_run_out`` the run-out follows if the mass swings back.
    """
    yield "peak", float(motion.peak.time), "peak velocity"
    if with_run_out and swings_back(motion):
        yield "farthest", float(motion.farthest.time), "farthest"
    yield "end", motion.settling_time, ending(motion)


def _read(time: float, times: Floats, values: Floats) -> float:
    """Return the value at a time of a column of values at ``times``; exactly 0 where only rounding error is left."""
    value = float(np.interp(time, times, values))
    if abs(value) < 1e-9 * float(np.max(np.abs(values))):
        return 0.0
    return value


def _differs(one: Floats, other: Floats) -> bool:
    """Return whether curve ``one`` has finite values and differs from curve ``other`` by more than rounding."""
    return bool(np.any(np.isfinite(one))) and not np.allclose(one, other, rtol=1e-9, atol=0.0, equal_nan=True)


def phase_plane(motion: Motion, ax: Any = None) -> Any:
    """Draw speed against displacement, and behind it the stacked energies; return the axis.

    Dissipation and kinetic energy make up the work. If the mass turns back, the path travelled replaces the
    displacement.
    """
    columns = columns_of_picture(motion)
    steps = np.diff(columns["displacement"])
    turns_back = bool(np.any(steps < 0.0) and np.any(steps > 0.0))
    along = columns["path" if turns_back else "displacement"]
    if turns_back:
        across = "path travelled, as it turns back"
    else:
        across = "displacement $s$"
    ax = panel(ax, "speed and energy", (across, "m"))
    _energies(motion, ax, along)
    if not motion.moves:
        return still(motion, ax)
    farthest = float(along[np.argmax(np.abs(along))])
    ax.set_xlim(0.0, farthest)  # a motion to the left, too, is drawn from left to right
    right = ax.twinx()
    speed = np.abs(columns["velocity"])
    curve(right, motion, along, speed, **LINES["main"])
    label_direction(right.yaxis, "speed $|v|$", "m/s")
    right.yaxis.label.set_color(LINES["main"]["color"])
    right.set_ylim(0.0, 1.2 * float(np.max(speed)))
    for role, time, words in _marks(motion):
        place = _read(time, columns["time"], along)
        height = _read(time, columns["time"], speed)
        measured = f"{words}:\n{formatted_amount(height, 'm/s')} at {formatted_amount(place, 'm')}"
        add_mark(right, place, height, role, measured if height else "")
    onwards = along * math.copysign(1.0, farthest)
    add_label(right, "speed", _in_view(right, onwards, speed), LINES["main"]["color"])
    return ax


def _energies(motion: Motion, ax: Any, along: Floats) -> None:
    """Draw dissipation and kinetic energy, stacked, and the work that supplies them; label the axis.

    ``along`` is the displacement or the path at the times of `columns_of_picture`, m.
    """
    columns = columns_of_picture(motion)
    at_start = float(columns["kinetic_energy"][0])
    supplied = at_start + columns["work_of_gravity_and_shaking"]
    factor, unit = prefixed(np.concatenate([supplied, columns["dissipation"]]), "J")
    of_width, per, of_one = width(motion)
    factor *= of_one
    ax.set_ylabel(f"energy {of_width}\n({unit}{per})")
    if not motion.moves:
        return
    supplied = factor * supplied
    dissipation = factor * columns["dissipation"]
    kinetic = factor * columns["kinetic_energy"]
    total = dissipation + kinetic
    ax.fill_between(along, 0.0, dissipation, **AREAS["dissipation"])
    ax.fill_between(along, dissipation, total, **AREAS["kinetic"])
    ax.plot(along, supplied, **LINES["total"])
    ax.set_ylim(0.0, 1.2 * float(np.max(total)))
    words = work(motion) + (" and first kinetic energy" if at_start else "")
    later = slice(len(along) // 4, None)
    add_label(ax, words, anchors_along(along[later], supplied[later]), LINES["total"]["color"])
    add_label(ax, "dissipation", anchors_along(along[later], dissipation[later] / 2), "0.25", inside=True)
    thickest = int(np.argmax(kinetic))
    middle = dissipation[thickest] + kinetic[thickest] / 2
    add_label(ax, "kinetic energy", (along[thickest], middle), "0.25")


def shaking(motion: Motion, ax: Any = None) -> Any:
    """Draw the ground acceleration over gravity until the mass rests; return the axis.

    The whole record is drawn if the mass does not move. The yield coefficient at the start is drawn as well: without
    k_v, a mass at rest starts when k_h exceeds it, as long as its position and its friction are as at the start.
    """
    ax = panel(ax, "ground acceleration", ("time $t$ (s)",), ("shaking over $g$ (–)",), size=(7.0, 2.5))
    called = in_time(motion.plan.scene.called)
    functions = {line: called[name] for name, line in _SHAKING.items() if name in called}
    if not functions:
        return empty("not shaken", ax, "x", "y")
    if motion.moves:
        last = motion.settling_time
        times = columns_of_picture(motion)["time"]
    else:
        kinks = np.concatenate([np.asarray(function.kinks) for function in functions.values()])
        last = float(np.max(kinks))
        times = np.union1d(np.linspace(0, last, 401), kinks)
    for (line, words), function in functions.items():
        ax.plot(times, function(times), **{**LINES[line], "lw": 1.2})
        add_label(ax, words, anchors_along(times, function(times), 40), LINES[line]["color"])
    yields = motion.yield_coefficient
    ax.axhline(yields, **{**LINES["total"], "lw": 1.2})
    ax.set_xlim(0.0, last)
    ax.margins(y=0.25)
    side = ax.secondary_yaxis("right")
    side.set_yticks([yields], [f"yields at\nthe start:\n$k_y$ = {formatted_number(yields)}"], fontsize="small")
    return ax


_SHAKING: Mapping[str, TextPair] = {  # style and label of each component
    "shaking.horizontal": ("main", "down-slope $k_h$"),
    "shaking.vertical": ("other", "vertical $k_v$, reduces the weight"),
}


def motion_overview(motion: Motion) -> Drawing:
    """Return the picture of a motion: the section, and the other panels in pairs below it."""
    arc = motion.plan.scene.arc
    panels: list[Callable[..., Any]] = []
    if motion.moves:
        panels = [*_histories(motion), partial(phase_plane, motion)]
    panels += [partial(shaking, motion)] * ("shaking" in motion.plan.effects)
    panels += [partial(stress_along, motion)] * isinstance(arc, LayeredSection)
    pairs = [(_PANEL, panels[k : k + 2]) for k in range(0, len(panels), 2)]
    words = heading(motion.plan.scene.name, outcome_words(motion) if motion.moves else standing(motion))
    return sheet([(_SECTION, [partial(section, motion)]), *pairs], words)


def histories(motion: Motion) -> Drawing:
    """Return the picture of velocity, displacement, resistance and stress over time."""
    panels = _histories(motion)
    return sheet([(_PANEL, panels[:2]), (_PANEL, panels[2:])])


def _histories(motion: Motion) -> list[Callable[..., Any]]:
    """Return functions that draw histories; the first names the marks.

    Friction alone is a coefficient; with cohesion or several soils the strength is drawn, as a stress.
    """
    has_strength = "cohesion" in motion.plan.effects or isinstance(motion.plan.scene.arc, LayeredSection)
    names = ("velocity", "displacement", "strength" if has_strength else "friction", "normal_stress")
    return [partial(history, motion, what, brief=what != "velocity") for what in names]


# Single panels of `Motion.plot`.
PANELS: Mapping[str, Callable[..., Any]] = {
    "section": section,
    "energy": phase_plane,
    "shaking": shaking,
    "stress_along_arc": stress_along,
    **{what: partial(history, what=what) for what in HISTORIES},
}
