"""Section as a picture to scale, after Figure 1-1: ground, slip circle, mass and water."""

import math
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.core import Arc, Motion
from slipcircle.ground import Section
from slipcircle.layers import LayeredSection
from slipcircle.messages import OUTSIDE, range_words, swings_back
from slipcircle.workbench.common.starting import start_words, starts
from slipcircle.workbench.common.trace import toe_words
from slipcircle.workbench.files.loaded import stability_of
from slipcircle.workbench.outputs.pictures.layerplot import draw_stretches
from slipcircle.workbench.outputs.pictures.plotstyle import (
    AREAS,
    LINES,
    SCENERY,
    SOILS,
    add_label,
    area,
    ending,
    formatted_amount,
    formatted_number,
    panel,
    to_scale,
)
from slipcircle.workbench.outputs.pictures.scenery import scenery_lines
from slipcircle.workbench.outputs.pictures.shapes import ON_ARC, MassShape, View, mass_of
from slipcircle.workbench.stability.critical import Critical
from slipcircle.workbench.stability.stability import METHODS

_SEEN = 0.02  # least displacement over chord that is drawn to scale
_WIDE = 0.1  # magnified displacement over chord
_MARGIN = 0.1  # relative to the size of the view
_BELOW = 0.08  # space below the firm layer, relative to the size of a view
_BLUE = LINES["main"]["color"]
_NAMES = {"water": _BLUE, "pond": _BLUE}  # colours of names that differ from the others


class Pose(NamedTuple):
    """Position of the mass that a section shows: role in `AREAS`, rotation in rad as drawn, and label."""

    role: str
    turn: float
    words: str


# --- the section of a motion -----------------------------------------------------------------------------------------


def section(motion: Motion, ax: Any = None) -> Any:
    """Draw the section to scale with the mass at the start, at the peak velocity and at the run-out.

    The mass is drawn turned by s/R (1.2), also where the geometry is frozen. The displacement of an arc is magnified if
    it would be invisible, with a note. Axes are in metres, for an arc from the centre K; x to the right, y up.

    Parameters
    ----------
    motion : Motion
    ax : matplotlib axis, optional

    Returns
    -------
    matplotlib axis
    """
    ax = panel(ax, "section", notes=_notes(motion), size=(8.0, 5.0))
    stage = set_stage(motion, ax)
    soil = motion.plan.scene.arc
    turns = [pose.turn for pose in stage.poses]
    farthest = max(turns, key=abs)
    if farthest:  # the circle beyond the toe, as the method assumes
        points = stage.mass.on_circle(stage.mass.ends[int(farthest > 0.0)] + np.linspace(0.0, farthest, 60))
        ax.plot(*points.T, **{**LINES["help"], "zorder": 4})
        add_label(ax, "toe assumed to follow the circle", points[20:50:5], LINES["help"]["color"])
    rightwards = (farthest or float(soil.facing)) > 0.0
    for pose in stage.poses:
        outline = stage.mass.outline(pose.turn)
        area(ax, outline, pose.role, label=pose.role)
        rear, front = tips = outline[[0, ON_ARC - 1]][:: 1 if rightwards else -1]
        anchors = {"start": rear, "end": front}.get(pose.role, tips)
        add_label(ax, pose.words, anchors, AREAS[pose.role]["edgecolor"])
    if isinstance(soil, LayeredSection):
        draw_stretches(ax, stage.mass, soil, turns[1:2])
    name_circle(ax, stage.mass, soil)
    stage.view.show(ax)
    return ax


def slope(soil: Any, ax: Any = None) -> Any:
    """Draw an arc or a section to scale, with its circle and the mass at the start; return the axis."""
    mass = mass_of(soil)
    outline = mass.outline()
    ax = panel(ax, "section")
    view = surroundings(ax, mass, soil, [outline])
    area(ax, outline, "start")
    name_circle(ax, mass, soil)
    view.show(ax)
    return ax


class Stage(NamedTuple):
    """Scenery of the section of a motion: its mass, the positions of the mass, and the view."""

    mass: MassShape
    poses: Sequence[Pose]
    view: View


def set_stage(motion: Motion, ax: Any) -> Stage:
    """Draw slope and circle of a motion to scale, with room for all positions of the mass."""
    soil = motion.plan.scene.arc
    mass = mass_of(soil)
    poses = [*_poses(motion)]
    return Stage(mass, poses, surroundings(ax, mass, soil, [mass.outline(pose.turn) for pose in poses]))


def surroundings(ax: Any, mass: MassShape, soil: Any, outlines: Sequence[Floats]) -> View:
    """Draw slope and circle to scale, with room for the given outlines of the mass, (n, 2); return the view.

    ``soil`` is the arc, the section or the slope.
    """
    view = View.around(*outlines)
    margin = _MARGIN * view.size
    view = scenery(ax, mass, soil, view.grown(margin, margin))
    if isinstance(soil, Arc):
        origin = " from the centre K"
    else:
        origin = ""
    view.show(ax)
    to_scale(ax, origin)
    return view


def _poses(motion: Motion) -> Iterator[Pose]:
    """Yield the mass at the start, at the run-out, and at its peak velocity if that is in between."""
    yield Pose("start", 0.0, "start")
    if not motion.moves:
        return
    peak, farthest = motion.peak, motion.farthest
    scale = magnified(motion) * float(motion.plan.scene.arc.facing)
    words, time = ("farthest", farthest.time) if swings_back(motion) else (ending(motion), motion.settling_time)
    has_toe = isinstance(motion.plan.scene.arc, Section)
    if has_toe:
        toe = f",\ntoe {formatted_amount(motion.journey.run_out, 'm')} further"
    else:
        toe = ""
    yield Pose("end", scale * float(farthest.rotation), f"{words} {_after(farthest, time)}{toe}")
    if peak.rotation not in (0.0, farthest.rotation):
        words = f"peak velocity {formatted_amount(abs(float(peak.velocity)), 'm/s')} {_after(peak, peak.time)}"
        yield Pose("peak", scale * float(peak.rotation), words)


def _after(state: Any, time: float) -> str:
    """Return time and displacement of a state as text."""
    return f"\nafter {formatted_number(time)} s and {formatted_amount(state.displacement, 'm')}"


def _notes(motion: Motion) -> Iterator[str]:
    """Yield notes: factors of safety, toe and range of validity, frozen geometry, magnified displacements."""
    if factors := factors_in_words(stability_of(motion.plan.scene)):
        yield factors
    if both := starts(motion):
        yield start_words(motion, both)
    toe = toe_words(motion)
    outside = f"{OUTSIDE} {range_words(motion)}"
    if toe or motion.outside_range:
        yield "; ".join([f"toe {toe}"] * bool(toe) + [outside] * bool(motion.outside_range))
    # The paper turns the mass (1.2) but evaluates J_r and J_theta, which it finds practically constant, at the start.
    if motion.moves and "rotation" not in motion.plan.effects:
        yield "frozen geometry: the mass turns by $s/R$, its forces remain as at the start"
    if (magnification := magnified(motion)) > 1.0:
        yield f"displacements drawn {formatted_number(magnification)} times as large"


def magnified(motion: Motion) -> float:
    """Return the magnification that makes displacements visible: 1, 2 or 5 times a power of ten."""
    arc = motion.plan.scene.arc
    if not isinstance(arc, Arc) or not motion.moves:
        return 1.0
    chord = 2 * math.sin(float(arc.half_angle))  # over the radius
    moved = abs(float(motion.farthest.rotation)) / chord
    if moved >= _SEEN or moved == 0.0:
        return 1.0
    most = _WIDE / moved
    power = 10.0 ** math.floor(math.log10(most))
    return max(n * power for n in (1.0, 2.0, 5.0) if n * power <= most)


def factors_in_words(critical: Critical | None) -> str:
    """Return the factors of safety with the names of their methods as text; empty without any."""
    if critical:
        factors = critical.factors_of_safety
    else:
        factors = {}
    texts = [f"{value:.3f} by {METHODS[method][0]}" for method, value in factors.items() if value is not None]
    if texts:
        return f"factor of safety {', '.join(texts)}"
    return ""


# --- ground, water and circle ----------------------------------------------------------------------------------------


def scenery(ax: Any, mass: MassShape, soil: Any, view: View) -> View:
    """Draw the circle and the surroundings of the mass; return the view, extended down to the firm layer.

    ``soil`` is the arc, the section or the slope.
    """
    ax.plot(*mass.arc.T, zorder=4, **LINES["main"])
    base = getattr(soil, "base", None)
    bottom = view.bottom - view.size  # the axis may show more than the view
    if base is not None:
        bottom = base
        view = view._replace(bottom=min(view.bottom, base - _BELOW * view.size))
    for line in scenery_lines(mass, soil, view):
        colour = _NAMES.get(line.role, "0.2")
        style = SCENERY[line.role]
        if line.role == "soil":
            if line.soil is not None:
                band, colour = SOILS[line.soil % len(SOILS)]
                ax.plot(*line.points.T, **SCENERY["boundary"])
                style = {**style, "color": band}
            ax.fill_between(*line.points.T, bottom, **style)
        elif line.lower is not None:
            ax.fill_between(*line.points.T, line.lower, **style)
        else:
            ax.plot(*line.points.T, **style)
        if line.name:
            add_label(ax, line.name, line.places, colour, inside=line.role == "soil")
    return view


def name_circle(ax: Any, mass: MassShape, soil: Any) -> None:
    """Label the circle of a mass with its radius, and the chord of an arc with length, dip and depth.

    ``soil`` is the arc, the section or the slope.
    """
    words = f"slip circle, $R$ = {formatted_amount(mass.radius, 'm')}"
    if isinstance(soil, LayeredSection):
        colour = "0.25"
    else:
        colour = LINES["main"]["color"]
    add_label(ax, words, mass.arc[ON_ARC // 4 : -ON_ARC // 4 : 6], colour)
    if not isinstance(soil, Arc):
        return
    chord = 2 * mass.radius * math.sin(float(soil.half_angle))
    dip = math.degrees(1.5 * math.pi - mass.ends.mean())
    depth = formatted_amount(float(soil.depth), "m")
    words = f"chord {formatted_amount(chord, 'm')}, dip {formatted_number(dip)} deg, depth {depth}"
    left, right = mass.ground
    add_label(ax, words, left + np.linspace(0.2, 0.8, 7)[:, None] * (right - left))
