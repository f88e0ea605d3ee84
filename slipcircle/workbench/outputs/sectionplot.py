"""The section as a picture to scale, after Figure 1-1: ground, slip circle, mass, water, and the forces on an arc."""

import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from slipcircle.core import Arc, Motion, Section
from slipcircle.workbench.files.loaded import stability_of
from slipcircle.workbench.outputs.plotstyle import AREAS, FORCES, HALO, LINES, axis, ending, finish, mark, number
from slipcircle.workbench.outputs.trace import Floats, toe_words
from slipcircle.workbench.stability.search import Critical
from slipcircle.workbench.stability.stability import METHODS

_ARROWS = (-0.6, -0.2, 0.2, 0.6)  # where on the arc reactions are drawn, over alpha
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
        inside = np.hypot(*(self.ground - self.centre).T) < (1 - 1e-9) * self.radius
        between = self.ground[(x >= arc[0, 0]) & (x <= arc[-1, 0]) & inside]
        points = np.concatenate([arc, between[::-1]]) - self.centre
        cos, sin = math.cos(turn), math.sin(turn)
        return self.centre + points @ [[cos, sin], [-sin, cos]]


class Pose(NamedTuple):
    """The mass at one of the moments that a section shows."""

    role: str  # of `AREAS` and `MARKS`
    rotation: float
    words: str


def mass_of(circle: Any, soil: Any) -> Mass:
    """The mass of an arc, a section, or a critical circle in its slope; of an arc the chord stands for the ground."""
    if isinstance(circle, Arc):
        ends = np.array([circle.theta_1, circle.theta_2])
        chord = float(circle.radius) * np.stack([np.cos(ends), np.sin(ends)], axis=-1)
        return Mass(chord, np.zeros(2), float(circle.radius), ends)
    centre_x, centre_y = circle.centre
    from_below = [math.atan2(x - centre_x, centre_y - y) for x, y in (circle.entry, circle.exit)]
    ends = np.sort(np.add(1.5 * math.pi, from_below))  # counted from straight below, so that they do not jump
    ground = np.asarray(soil.ground, dtype=np.float64)
    return Mass(ground, np.array([centre_x, centre_y], float), float(circle.radius), ends)


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
    low, high = np.min(outlines, axis=(0, 1)), np.max(outlines, axis=(0, 1))
    if is_arc and forces:
        low, high = np.minimum(low, mass.centre), np.maximum(high, mass.centre)
    size, chord = float(max(high - low)), float(np.hypot(*np.diff(mass.on_circle(mass.ends), axis=0)[0]))
    small = chord < _SMALL * size
    _draw_poses(ax, poses, outlines, small)
    farthest = max(turns, key=abs)
    if farthest:
        _continuation(ax, motion, mass, farthest)
    margin = _MARGIN * size
    _scenery(ax, mass, soil, low - margin, high + margin)
    for note in _notes(motion, magnification):
        ax.plot([], [], ls="", label=note)
    if is_arc and forces:
        _radii(ax, mass, small)
        if not small:
            _forces(ax, motion, mass, size)
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


def _scenery(ax: Any, mass: Mass, soil: Any, low: Any, high: Any) -> None:
    """The circle, and the chord of an arc or a ground with its soil, water and firm layer, between two corners."""
    ax.plot(*mass.arc.T, zorder=4, label="slip circle", **LINES["main"])
    ground = None
    if isinstance(soil, Arc):
        chord = 2 * mass.radius * math.sin(float(soil.half_angle))
        dip = math.degrees(1.5 * math.pi - mass.ends.mean())
        sizes = f"{number(chord)} m, depth {number(float(soil.depth))} m, dip {number(dip)} deg"
        ground = f"chord, which stands for the ground:\n{sizes}"
    else:
        low = _ground_and_water(ax, mass, soil, low, high)
    ax.plot(*mass.ground.T, color="black", lw=1.4, zorder=3, label=ground)
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))


def _ground_and_water(ax: Any, mass: Mass, soil: Any, low: Any, high: Any) -> Any:
    """Soil, water level and firm layer, named where they are; the lower corner, below the firm layer."""
    left = low[0] + 0.015 * (high[0] - low[0])
    if soil.base is not None:
        low = np.minimum(low, [np.inf, soil.base - 0.08 * float(np.max(high - low))])
        ax.axhline(soil.base, color="0.3", lw=2.5, zorder=3)
        _name(ax, "firm layer", (left, soil.base), (0, -4), "0.2", va="top")
    ax.fill_between(*mass.ground.T, low[1], color="#EFE6D2", lw=0, zorder=1)
    if soil.level is not None:
        level = np.asarray(soil.level, dtype=np.float64)
        x = np.concatenate([[min(low[0], level[0, 0])], level[:, 0], [max(high[0], level[-1, 0])]])
        y = np.concatenate([level[:1, 1], level[:, 1], level[-1:, 1]])
        ax.plot(x, y, color="#56B4E9", lw=1.6, zorder=3)
        _name(ax, "water level", (left, np.interp(left, x, y)), (0, -9), "#0072B2", va="top")
    return low


def _name(ax: Any, words: str, at: Any, offset: Any, colour: str, **more: Any) -> None:
    """Words beside what they name, in its colour."""
    from matplotlib.patheffects import withStroke

    ax.annotate(
        words,
        at,
        offset,
        textcoords="offset points",
        color=colour,
        fontsize="small",
        zorder=6,
        path_effects=[withStroke(linewidth=HALO, foreground="white")],
        **more,
    )


# --- centre, radii and forces of an arc ------------------------------------------------------------------------------


def _beside(ax: Any, words: str, at: Any, away: Any, **more: Any) -> None:
    """Words beside a point, in a direction from it."""
    offset = 12 * np.divide(away, np.hypot(*away))
    _name(ax, words, at, offset, "black", ha="center", va="center", **more)


def _radii(ax: Any, mass: Mass, small: bool) -> None:
    """The centre and the radii to both ends, by their names, and the depth."""
    one, two = mass.on_circle(mass.ends)
    bottom = mass.on_circle(mass.ends.mean())
    depth = np.stack([(one + two) / 2, bottom])
    ax.plot(*depth.T, color="black", lw=1.0, marker="_", zorder=3)
    if not small:
        _beside(ax, "$P_1$", one, one)
        _beside(ax, "$P_2$", two, two)
    ax.plot(*np.stack([one, np.zeros(2), two]).T, zorder=1, label="radii $KP_1$, $KP_2$", **LINES["radius"])
    ax.plot(0.0, 0.0, "k+", ms=9, mew=1.5, zorder=5)
    _beside(ax, "K", (0.0, 0.0), -bottom, fontweight="bold")


def _forces(ax: Any, motion: Motion, mass: Mass, size: float) -> None:
    """Weight at the mass's centre, and reactions on the arc: normal towards K, tangential against the motion."""
    middle, alpha = float(mass.ends.mean()), float(np.ptp(mass.ends)) / 2
    length = min(0.16 * size, 0.9 * mass.radius * alpha)
    centroid = mass.on_circle(middle) * _centroid_radius(alpha)
    tip = centroid - [0.0, 1.25 * length]
    _arrow(ax, centroid, tip, "weight", 2.2)
    _beside(ax, "$W$", tip, (0.0, -1.0))
    ax.set_ylim(bottom=min(ax.get_ylim()[0], tip[1] - 0.12 * size))
    resisted = float(motion.friction_at(0.0)) > 0.0 or "cohesion" in motion.plan.effects
    way = motion.plan.scene.arc.facing * (motion.phases[0].direction if motion.phases else 1)
    for at in mass.on_circle(middle + alpha * np.array(_ARROWS)):
        outward = at / mass.radius
        along = way * np.array([-outward[1], outward[0]])
        _arrow(ax, at + 0.7 * length * outward, at, "normal", 1.6)
        if resisted:
            foot = at + 0.06 * length * outward
            _arrow(ax, foot, foot - 0.55 * length * along, "tangential", 1.6)
    for name, symbol in (("normal", "dN"), ("tangential", "dT"))[: 1 + resisted]:
        ax.plot([], [], color=FORCES[name], lw=1.6, marker=">", ms=5, label=f"{name} reaction ${symbol}$")


def _centroid_radius(alpha: float) -> float:
    """A circular segment's centroid from the centre, over R: 2/3 sin^3 alpha/(alpha - sin alpha cos alpha)."""
    area = alpha - math.sin(alpha) * math.cos(alpha)
    return 2 / 3 * math.sin(alpha) ** 3 / area if alpha > 1e-3 else 1.0


def _arrow(ax: Any, tail: Any, tip: Any, force: str, width: float) -> None:
    """A force as an arrow."""
    style = {"arrowstyle": "-|>", "shrinkA": 0, "shrinkB": 0, "mutation_scale": 11}
    ax.annotate("", tip, tail, arrowprops=style | {"color": FORCES[force], "lw": width}, zorder=5)


# --- the slide itself, and the search for its circle -----------------------------------------------------------------


class Film(NamedTuple):
    """A section with a moving mass: what moves in it, a function that draws a frame by its number, and their times."""

    figure: Any
    moving: tuple[Any, ...]
    draw: Callable[[int], tuple[Any, ...]]
    times: Floats


def film(motion: Motion, figure: Any, frames: int, seconds: float) -> Film:
    """The section with the mass where it is at even times, which are shown in so many seconds; at rest one frame."""
    from matplotlib.patches import Polygon

    ax, soil = section(motion, None if figure is None else figure.add_subplot()), motion.plan.scene.arc
    mass, turn_per_rotation = mass_of(soil, soil), magnified(motion) * float(soil.facing)
    body = ax.add_patch(Polygon(mass.outline(), closed=True, zorder=4, **AREAS["moving"]))
    times = np.linspace(0.0, motion.duration, frames if motion.moves else 1)
    states = motion.at(times)
    pace = f", shown {motion.duration / seconds:.2g} times as fast" if motion.moves else ""
    title = ax.figure.suptitle(" ", fontsize="medium")

    def draw(frame: int) -> tuple[Any, ...]:
        body.set_xy(mass.outline(turn_per_rotation * float(states.rotation[frame])))
        title.set_text(f"{times[frame]:.2f} s, {abs(float(states.velocity[frame])):.2f} m/s{pace}")
        return body, title

    draw(0)
    return Film(ax.figure, (body, title), draw, times)


def animate(motion: Motion, figure: Any = None, frames: int = 60, seconds: float = 5.0) -> Any:
    """The slide as a matplotlib.animation.FuncAnimation: the section, with the mass where it is at even times.

    An empty figure may be given, with a constrained layout; keep what is returned while it plays, or save it. Where the
    mass does not move there is one frame.
    """
    from matplotlib.animation import FuncAnimation

    slide = film(motion, figure, frames, seconds)
    return FuncAnimation(slide.figure, slide.draw, len(slide.times), interval=1e3 * seconds / frames)


def critical_circle(critical: Critical, figure: Any) -> Any:
    """The section with the circle, and the least factor that any circle about each centre has, on an empty figure."""
    from matplotlib.patches import Polygon
    from matplotlib.patheffects import withStroke

    ax, mass = figure.add_subplot(), mass_of(critical, critical.slope)
    outline, ground = mass.outline(), mass.ground
    low, high = outline.min(axis=0), np.maximum(outline.max(axis=0), mass.centre)
    reach = max(float(np.ptp(outline[:, 0])), 1.2 * float(np.ptp(ground[:, 1]))) * np.array([0.8, 0.4])
    low, high = np.maximum(low - reach, [ground[0, 0], -np.inf]), np.minimum(high + reach, [ground[-1, 0], np.inf])
    ax.add_patch(Polygon(outline, closed=True, label="mass", zorder=2, **AREAS["start"]))
    _scenery(ax, mass, critical.slope, low, high)
    seen = np.all((mass.centre >= low) & (mass.centre <= high))
    words = f"centre; $R$ = {number(mass.radius)} m\n{_factors(critical)}".rstrip()
    (cross,) = ax.plot(*(mass.centre if seen else ([], [])), "k+", ms=9, mew=1.5, zorder=5, ls="", label=words)
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
    valley = centres[values <= (1.0 + _VALLEY) * least]
    (left, bottom), (right, top) = np.transpose([ax.get_xlim(), ax.get_ylim()])
    left, right = min(left, valley[:, 0].min()), max(right, valley[:, 0].max())
    top = min(max(top, valley[:, 1].max()), bottom + _TALL * (right - left))
    outside = np.any((centres < (left, bottom)) | (centres > (right, top)), axis=1)
    most = min(float(values[outside].min(initial=np.inf)), 1.5 * least)
    drawn = ~outside & (values < most)
    cell = (right - left) / _CELLS  # of which the frame leaves room around the outermost
    left, right, top = left - cell, right + cell, top + cell
    ax.set(xlim=(left, right), ylim=(bottom, top))
    cells = ax.hexbin(
        *centres[drawn].T,
        values[drawn],
        gridsize=_CELLS,
        reduce_C_function=np.min,
        extent=(left, right, bottom, top),
        vmin=least,
        vmax=most,
        cmap="viridis",
        lw=0.1,
        zorder=0,
    )
    method = METHODS[critical.method][0]
    words = f"least factor of safety of the circles about each centre, up to {most:.3g}, by {method}"
    ax.figure.colorbar(cells, ax=ax, location="bottom", shrink=0.8, aspect=40, label=words, format="%.2f")
