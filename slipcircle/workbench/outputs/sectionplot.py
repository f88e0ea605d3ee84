"""The section as a picture to scale, after Figure 1-1: ground, slip circle, mass, water, and the forces on an arc."""

import math
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from slipcircle.core import Arc, Motion, Section
from slipcircle.workbench.files.loaded import stability_of
from slipcircle.workbench.outputs.forces import draw_forces
from slipcircle.workbench.outputs.plotstyle import (
    AREAS,
    HALO,
    LINES,
    SCENERY,
    axis,
    beside,
    ending,
    finish,
    mark,
    name_beside,
    number,
)
from slipcircle.workbench.outputs.trace import Floats, toe_words
from slipcircle.workbench.stability.search import Critical
from slipcircle.workbench.stability.stability import METHODS

_SMALL = 0.12  # chord over view: below, the mass is a mark, without forces
_SEEN, _WIDE = 0.02, 0.1  # displacements over the chord: which is drawn as it is, and what a smaller one is drawn as
_MARGIN = 0.1  # of the view
_CELLS = 30  # of the map of factors, across
_VALLEY, _TALL = 0.05, 1.4  # share above the least factor that a map holds, and its height over its width, at most
_ON_ARC = 200  # points of an outline


class Mass(NamedTuple):
    """A slip circle and the mass on it as they are drawn, m and rad."""

    ground: Floats  # of an arc its chord
    centre: Floats
    radius: float
    ends: Any  # polar angles of both ends of its arc, increasing

    def on_circle(self, angles: Any) -> Floats:
        """Points of the circle at polar angles."""
        return self.centre + self.radius * np.stack([np.cos(angles), np.sin(angles)], axis=-1)

    @property
    def arc(self) -> Floats:
        """Points along its arc, left to right."""
        return self.on_circle(np.linspace(self.ends[0], self.ends[1], _ON_ARC))

    def outline(self, turn: float = 0.0) -> Floats:
        """Points along the arc, left to right, and back along the ground; turned counterclockwise."""
        arc, x = self.arc, self.ground[:, 0]
        left, right = arc[0, 0], arc[-1, 0]
        from_centre = np.hypot(*(self.ground - self.centre).T)
        over_arc = (x >= left) & (x <= right) & (from_centre < (1 - 1e-9) * self.radius)
        points = np.concatenate([arc, self.ground[over_arc][::-1]]) - self.centre
        cos, sin = math.cos(turn), math.sin(turn)
        rotation = [[cos, sin], [-sin, cos]]
        return self.centre + points @ rotation


class View(NamedTuple):
    """What of the section is in view, m."""

    left: float
    bottom: float
    right: float
    top: float

    @classmethod
    def around(cls, *points: Any) -> "View":
        """The smallest view that holds points, (..., 2)."""
        every = np.concatenate([np.reshape(some, (-1, 2)) for some in points])
        return cls(*every.min(axis=0), *every.max(axis=0))

    @property
    def size(self) -> float:
        """The greater of width and height."""
        return max(self.right - self.left, self.top - self.bottom)

    def grown(self, across: float, up: float) -> "View":
        """With margins."""
        return View(self.left - across, self.bottom - up, self.right + across, self.top + up)

    def holds(self, points: Any) -> Any:
        """Which points, (..., 2), are in view."""
        x, y = np.moveaxis(points, -1, 0)
        return (self.left <= x) & (x <= self.right) & (self.bottom <= y) & (y <= self.top)

    def show(self, ax: Any) -> None:
        """Set an axis to it."""
        ax.set(xlim=(self.left, self.right), ylim=(self.bottom, self.top))


class Pose(NamedTuple):
    """The mass at one of the moments that a section shows."""

    role: str  # of `AREAS` and `MARKS`
    rotation: float
    words: str


def mass_of(circle: Any, soil: Any) -> Mass:
    """The mass of an arc, a section, or a critical circle in its slope; of an arc the chord stands for the ground."""
    radius = float(circle.radius)
    if isinstance(circle, Arc):
        ends = np.array([circle.theta_1, circle.theta_2])
        chord = radius * np.stack([np.cos(ends), np.sin(ends)], axis=-1)
        return Mass(chord, np.zeros(2), radius, ends)
    centre = np.asarray(circle.centre, dtype=np.float64)
    across, up = np.transpose(np.stack([circle.entry, circle.exit]) - centre)
    from_below = np.arctan2(across, -up)  # counted from straight below, angles do not jump
    ground = np.asarray(soil.ground, dtype=np.float64)
    return Mass(ground, centre, radius, np.sort(1.5 * math.pi + from_below))


# --- the section of a motion -----------------------------------------------------------------------------------------


def section(motion: Motion, ax: Any = None, forces: bool = False) -> Any:
    """The section to scale: the mass at the start, at the peak velocity and at the end.

    The mass is drawn turned by s/R (1.2), also where the geometry is frozen; of an arc by more where that could not be
    seen. The legend says so, and that the circle goes on beyond the toe. Axes are metres, of an arc from the centre K,
    x to the right, y up.

    Parameters
    ----------
    motion : Motion
    ax : matplotlib axis, optional
    forces : bool
        Whether the centre, the radii and the forces at the start are drawn as well; of an arc only.
    """
    ax, soil = axis(ax, (7.0, 5.5)), motion.plan.scene.arc
    mass, magnification, is_arc = mass_of(soil, soil), magnified(motion), isinstance(soil, Arc)
    poses = _poses(motion)
    turns = [magnification * pose.rotation * float(soil.facing) for pose in poses]
    outlines = [mass.outline(turn) for turn in turns]
    with_forces = is_arc and forces
    view = View.around(*outlines, *([mass.centre] if with_forces else []))
    chord = float(np.hypot(*np.diff(mass.on_circle(mass.ends), axis=0)[0]))
    small = chord < _SMALL * view.size
    _draw_poses(ax, poses, outlines, small)
    farthest = max(turns, key=abs)
    if farthest:
        _continuation(ax, motion, mass, farthest)
    margin = _MARGIN * view.size
    _scenery(ax, mass, soil, view.grown(margin, margin))
    for note in _notes(motion, magnification):
        ax.plot([], [], ls="", label=note)
    if with_forces:
        _radii(ax, mass, small)
        if not small:
            draw_forces(ax, motion, mass, view.size)
    origin = " from the centre K" if is_arc else ""
    finish(ax, f"$x${origin} (m)", f"$y${origin} (m)")
    return ax


def _poses(motion: Motion) -> list[Pose]:
    """The mass at the start, at the end, and at its peak velocity where that is elsewhere."""
    poses = [Pose("start", 0.0, "start")]
    if motion.moves:
        peak, end = motion.peak, motion.end
        toe = f",\ntoe {number(motion.journey.run_out)} m further" if isinstance(motion.plan.scene.arc, Section) else ""
        poses.append(Pose("end", float(end.rotation), f"{ending(motion)} {_after(end)}{toe}"))
        if peak.rotation not in (0.0, end.rotation):
            poses.append(Pose("peak", float(peak.rotation), f"peak velocity {_after(peak)}"))
    return poses


def _after(state: Any) -> str:
    """When and how far on its way a mass is, in the words of a legend."""
    return f"after {number(state.time)} s and {number(state.displacement)} m"


def _draw_poses(ax: Any, poses: Sequence[Pose], outlines: Sequence[Floats], small: bool) -> None:
    """The outline of the mass in each pose, or a mark where it is too small to be seen."""
    from matplotlib.patches import Polygon

    for pose, outline in zip(poses, outlines, strict=True):
        if small:
            x, y = outline.mean(axis=0)
            mark(ax, x, y, pose.role, pose.words)
        else:
            ax.add_patch(Polygon(outline, closed=True, label=pose.words, zorder=2, **AREAS[pose.role]))


def _continuation(ax: Any, motion: Motion, mass: Mass, turn: float) -> None:
    """The circle beyond the end of the arc towards which the mass turns, which the method assumes."""
    beyond = mass.ends[int(turn > 0.0)] + np.linspace(0.0, turn, 60)
    height = toe_words(motion)
    outcome = f"which ends {height}" if height else "as the method assumes"
    ax.plot(
        *mass.on_circle(beyond).T, zorder=4, label=f"the circle continued beyond the toe,\n{outcome}", **LINES["help"]
    )


def _notes(motion: Motion, magnification: float) -> Iterator[str]:
    """What a legend says without a line of its own: radius, factors of safety, and what is not drawn as it is."""
    yield f"radius $R$ = {number(float(np.asarray(motion.plan.scene.arc.radius)))} m"
    if factors := _factors(stability_of(motion.plan.scene)):
        yield factors
    # The paper turns the mass (1.2) and takes J_r and J_theta, practically constant to it, at the start.
    if motion.moves and "rotation" not in motion.plan.effects:
        yield "frozen geometry: the mass turns by $s/R$,\nits forces stay those of the start"
    if magnification > 1.0:
        yield f"displacements drawn {number(magnification)} times as large"


def magnified(motion: Motion) -> float:
    """How many times as large displacements are drawn so that they are seen: 1, 2 or 5 times a power of ten."""
    arc = motion.plan.scene.arc
    moved = abs(float(motion.reach.rotation)) / (2 * math.sin(float(arc.half_angle))) if motion.moves else 0.0
    if not isinstance(arc, Arc) or moved >= _SEEN or moved == 0.0:
        return 1.0
    most = _WIDE / moved
    power = 10.0 ** math.floor(math.log10(most))
    return max(n * power for n in (1.0, 2.0, 5.0) if n * power <= most)


def _factors(critical: Critical | None) -> str:
    """Factors of safety by their methods, in the words of a legend."""
    if critical is None:
        return ""
    known = [f"{method} {value:.3f}" for method, value in critical.factor_of_safety.items() if value is not None]
    lines = filter(None, [", ".join(known[:1]), ", ".join(known[1:])])
    return "factor of safety: " + ",\n".join(lines) if known else ""


# --- ground, water and circle ----------------------------------------------------------------------------------------


def _scenery(ax: Any, mass: Mass, soil: Any, view: View) -> None:
    """The circle, and the chord of an arc or a ground with its soil, water and firm layer."""
    ax.plot(*mass.arc.T, zorder=4, label="slip circle", **LINES["main"])
    if isinstance(soil, Arc):
        chord = number(2 * mass.radius * math.sin(float(soil.half_angle)))
        depth = number(float(soil.depth))
        dip = number(math.degrees(1.5 * math.pi - mass.ends.mean()))
        words = f"chord in place of the ground:\n{chord} m, depth {depth} m, dip {dip} deg"
        ax.plot(*mass.ground.T, label=words, **SCENERY["ground"])
    else:
        view = _firm_layer(ax, soil, view)
        ax.fill_between(*mass.ground.T, view.bottom, **SCENERY["soil"])
        _water_level(ax, soil, view)
        ax.plot(*mass.ground.T, **SCENERY["ground"])
    view.show(ax)


def _firm_layer(ax: Any, soil: Any, view: View) -> View:
    """The firm layer, where there is one, by its name; the view down to below it."""
    if soil.base is None:
        return view
    ax.axhline(soil.base, **SCENERY["firm layer"])
    name_beside(ax, "firm layer", (view.left, soil.base), (5, -4), "0.2", va="top")
    below = soil.base - 0.08 * view.size
    return view._replace(bottom=min(view.bottom, below))


def _water_level(ax: Any, soil: Any, view: View) -> None:
    """The water level, where there is one, by its name; level beyond its ends."""
    if soil.level is None:
        return
    level = np.asarray(soil.level, dtype=np.float64)
    first, last = level[0], level[-1]
    left, right = [min(view.left, first[0]), first[1]], [max(view.right, last[0]), last[1]]
    x, y = np.concatenate([[left], level, [right]]).T
    ax.plot(x, y, **SCENERY["water"])
    name_beside(ax, "water level", (view.left, np.interp(view.left, x, y)), (5, -9), "#0072B2", va="top")


# --- centre, radii and forces of an arc ------------------------------------------------------------------------------


def _radii(ax: Any, mass: Mass, small: bool) -> None:
    """The centre and the radii to both ends, by their names, and the depth."""
    one, two = mass.on_circle(mass.ends)
    bottom = mass.on_circle(mass.ends.mean())
    depth = np.stack([(one + two) / 2, bottom])
    ax.plot(*depth.T, **SCENERY["depth"])
    if not small:
        beside(ax, "$P_1$", one, one)
        beside(ax, "$P_2$", two, two)
    radii = np.stack([one, mass.centre, two])
    ax.plot(*radii.T, zorder=1, label="radii $KP_1$, $KP_2$", **LINES["radius"])
    ax.plot(*mass.centre, **SCENERY["centre"])
    beside(ax, "K", mass.centre, -bottom, fontweight="bold")


def critical_circle(critical: Critical, figure: Any) -> Any:
    """The section with the circle, and the least factor that any circle about each centre has, on an empty figure."""
    from matplotlib.patches import Polygon
    from matplotlib.patheffects import withStroke

    ax, mass = figure.add_subplot(), mass_of(critical, critical.slope)
    outline, ground = mass.outline(), mass.ground
    ax.add_patch(Polygon(outline, closed=True, label="mass", zorder=2, **AREAS["start"]))
    width, height = np.ptp(outline[:, 0]), np.ptp(ground[:, 1])
    reach = max(float(width), 1.2 * float(height))
    view = View.around(outline, mass.centre).grown(0.8 * reach, 0.4 * reach)
    first, last = ground[[0, -1], 0]
    view = view._replace(left=max(view.left, first), right=min(view.right, last))
    _scenery(ax, mass, critical.slope, view)
    words = f"centre; $R$ = {number(mass.radius)} m\n{_factors(critical)}".rstrip()
    (cross,) = ax.plot(*(mass.centre if view.holds(mass.centre) else ([], [])), label=words, **SCENERY["centre"])
    cross.set_path_effects([withStroke(linewidth=HALO + 1.0, foreground="white")])  # it may lie on a dark map
    finish(ax, "$x$ (m)", "$y$ (m)")
    _map(critical, ax)
    return figure


def _map(critical: Critical, ax: Any) -> None:
    """The least factor of the circles about the centres in each cell, darkest where it is least.

    The frame grows until it holds every centre of a factor up to `_VALLEY` above the least, as far as it is not more
    than `_TALL` times as high as wide; what is shown ends at the least factor of a centre outside of the frame.
    """
    known = np.isfinite(critical.values)
    centres, values = critical.centres[known], critical.values[known]
    if values.size <= 10:
        return
    least = float(values.min())
    (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
    valley = centres[values <= (1.0 + _VALLEY) * least]
    view = View.around(valley, (left, bottom), (right, top))._replace(bottom=bottom)
    highest = bottom + _TALL * (view.right - view.left)
    view = view._replace(top=min(view.top, highest))
    inside = view.holds(centres)
    most = min(float(values[~inside].min(initial=np.inf)), 1.5 * least)
    drawn = inside & (values < most)
    cell = (view.right - view.left) / _CELLS
    view = view.grown(cell, cell)._replace(bottom=bottom)  # so that the outermost cells are whole
    view.show(ax)
    cells = ax.hexbin(
        *centres[drawn].T,
        values[drawn],
        gridsize=_CELLS,
        reduce_C_function=np.min,
        extent=(view.left, view.right, view.bottom, view.top),
        vmin=least,
        vmax=most,
        cmap="viridis",
        lw=0.1,
        zorder=0,
    )
    method = METHODS[critical.method][0]
    words = f"least factor of safety of the circles about each centre, up to {most:.3g}, by {method}"
    ax.figure.colorbar(cells, ax=ax, location="bottom", shrink=0.8, aspect=40, label=words, format="%.2f")
