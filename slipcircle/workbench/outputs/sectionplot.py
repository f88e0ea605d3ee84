"""The section as a picture to scale, after Figure 1-1: ground, slip circle, mass, water, and the forces on an arc."""

import math
from typing import Any, NamedTuple

import numpy as np

from slipcircle.core import Arc, Motion, State
from slipcircle.workbench.files.loaded import stability_of
from slipcircle.workbench.outputs.plotstyle import AREAS, FORCES, HALO, LINES, axis, ending, finish, mark, number
from slipcircle.workbench.outputs.trace import Floats, toe_words
from slipcircle.workbench.stability.search import Critical
from slipcircle.workbench.stability.stability import METHODS

_ARROWS = (-0.6, -0.2, 0.2, 0.6)  # where on the arc reactions are drawn, over alpha
_SMALL = 0.12  # chord over view: below, the mass is a mark, without forces
_SEEN, _WIDE = 0.02, 0.1  # displacements over the chord: which is drawn as it is, and what a smaller one is drawn as
_MARGIN = 0.16  # of the view
_CELLS = 30  # of the map of factors, across
_SHARE, _TALL = 0.05, 1.4  # of the least factor, above which its map may end; height of the map over its width, at most
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
        arc = self.arc
        x, within = self.ground[:, 0], np.hypot(*(self.ground - self.centre).T) < (1 - 1e-9) * self.radius
        inner = self.ground[(x >= arc[0, 0]) & (x <= arc[-1, 0]) & within]
        cos, sin = math.cos(turn), math.sin(turn)
        return self.centre + (np.concatenate([arc, inner[::-1]]) - self.centre) @ [[cos, sin], [-sin, cos]]


def mass_of(circle: Any, soil: Any) -> Mass:
    """The mass of an arc, a section, or a critical circle in its slope; of an arc the chord stands for the ground."""
    if isinstance(circle, Arc):
        found = Mass(np.empty((0, 2)), np.zeros(2), float(circle.radius), np.array([circle.theta_1, circle.theta_2]))
        return found._replace(ground=found.on_circle(found.ends))
    (cx, cy), ends = circle.centre, (circle.entry, circle.exit)
    angles = np.sort([1.5 * math.pi + math.atan2(x - cx, cy - y) for x, y in ends])  # from straight below, no jump
    return Mass(np.asarray(soil.ground, dtype=np.float64), np.array([cx, cy], float), float(circle.radius), angles)


def section(motion: Motion, ax: Any = None) -> Any:
    """The section: the mass at the start, at the peak velocity and at the end; of an arc with the forces at the start.

    It is drawn turned by s/R (1.2), also where the geometry is frozen: there the forces stay those of the start; of an
    arc by more where that could not be seen. The legend says so, and that the circle goes on beyond the toe. Axes are
    metres, of an arc from the centre K, x to the right, y up.
    """
    from matplotlib.patches import Polygon

    ax, soil = axis(ax, (7.0, 5.5)), motion.plan.scene.arc
    mass, times, is_arc = mass_of(soil, soil), magnified(motion), isinstance(soil, Arc)
    places = _places(motion)
    turns = [times * rotation * float(soil.facing) for _, rotation, _ in places]
    outlines = [mass.outline(turn) for turn in turns]
    low, high = np.min(outlines, axis=(0, 1)), np.max(outlines, axis=(0, 1))
    with_centre = np.minimum(low, mass.centre), np.maximum(high, mass.centre)
    if is_arc and max(with_centre[1] - with_centre[0]) < 6 * max(high - low):
        low, high = with_centre
    size, chord = float(max(high - low)), mass.on_circle(mass.ends)
    small = float(np.hypot(*(chord[1] - chord[0]))) < _SMALL * size
    for (role, _, words), outline in zip(places, outlines, strict=True):
        if small:
            x, y = outline.mean(axis=0)
            mark(ax, x, y, role, words)
        else:
            ax.add_patch(Polygon(outline, closed=True, label=words, zorder=2, **AREAS[role]))
    turn = max(turns, key=abs)
    if turn:
        beyond = mass.ends[int(turn > 0.0)] + np.linspace(0.0, turn, 60)
        hangs = toe_words(motion)
        words = "the circle continued beyond the toe,\n" + (f"which ends {hangs}" if hangs else "as the method assumes")
        ax.plot(*mass.on_circle(beyond).T, zorder=4, label=words, **LINES["help"])
    factors = _factors(stability_of(motion.plan.scene))
    _scenery(
        ax, mass, soil, f"centre; $R$ = {number(mass.radius)} m{factors}", low - _MARGIN * size, high + _MARGIN * size
    )
    notes = {
        # The paper turns the mass (1.2) and takes J_r and J_theta, practically constant to it, at the start.
        "frozen geometry: the mass turns by $s/R$,\nits forces stay those of the start": motion.moves
        and "rotation" not in motion.plan.effects,
        f"displacements drawn {number(times)} times as large": times > 1.0,
    }
    for note in (words for words, holds in notes.items() if holds):
        ax.plot([], [], ls="", label=note)
    if is_arc:
        _radii(ax, mass, small)
        if not small:
            _forces(ax, motion, mass, size)
    from_where = " from the centre K" if is_arc else ""
    finish(ax, f"$x${from_where} (m)", f"$y${from_where} (m)")
    return ax


def magnified(motion: Motion) -> float:
    """How many times as large displacements are drawn so that they are seen: 1, 2 or 5 times a power of ten."""
    arc = motion.plan.scene.arc
    moved = abs(float(motion.reach.rotation)) / (2 * math.sin(float(arc.half_angle))) if motion.moves else 0.0
    if not isinstance(arc, Arc) or moved >= _SEEN or moved == 0.0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(_WIDE / moved))
    return max(n * power for n in (1.0, 2.0, 5.0) if n * power <= _WIDE / moved)


def _places(motion: Motion) -> list[tuple[str, float, str]]:
    """Where the mass is shown, at the start, the end and its peak velocity: role, rotation, and words of a legend."""
    found = [("start", 0.0, "start")]
    if motion.moves:
        peak, end = motion.peak, motion.end
        toe = f",\ntoe {number(motion.journey.run_out)} m further" if hasattr(motion, "journey") else ""
        found.append(("end", float(end.rotation), f"{ending(motion)} {_after(end)}{toe}"))
        if peak.rotation not in (0.0, end.rotation):
            found.append(("peak", float(peak.rotation), f"peak velocity {_after(peak)}"))
    return found


def _after(state: State) -> str:
    """When and how far on its way a mass is, in the words of a legend."""
    return f"after {number(state.time)} s and {number(state.displacement)} m"


def _factors(found: Critical | None) -> str:
    """Factors of safety, in the words of a legend."""
    by_method = found.factor_of_safety if found else {}
    known = [f"{method} {v:.3f}" for method, v in by_method.items() if v is not None]
    return "\nfactor of safety: " + ",\n".join(filter(None, [known[0], ", ".join(known[1:])])) if known else ""


def _scenery(ax: Any, mass: Mass, soil: Any, words: str, low: Any, high: Any) -> None:
    """Circle and centre, and the chord of an arc or a ground with soil, water and firm layer, between two corners."""
    from matplotlib.patheffects import withStroke

    ax.plot(*mass.arc.T, zorder=4, label="slip circle", **LINES["main"])
    ground = "ground"
    if isinstance(soil, Arc):
        depth, chord = number(float(soil.depth)), number(2 * mass.radius * math.sin(float(soil.half_angle)))
        dip = number(math.degrees(1.5 * math.pi - mass.ends.mean()))
        ground = f"chord, which stands for the ground:\n{chord} m, depth {depth} m, dip {dip} deg"
    else:
        if soil.base is not None:
            low = np.minimum(low, [np.inf, soil.base - 0.05 * float(np.max(high - low))])
            ax.axhline(soil.base, color="0.3", lw=2.5, zorder=3, label="firm layer")
        ax.fill_between(*mass.ground.T, low[1], color="#EFE6D2", lw=0, zorder=1)
        if soil.level is not None:
            level = np.asarray(soil.level, dtype=np.float64)
            x = np.concatenate([[min(low[0], level[0, 0])], level[:, 0], [max(high[0], level[-1, 0])]])
            ax.plot(x, level[[0, *range(len(level)), -1], 1], color="#56B4E9", lw=1.6, zorder=3, label="water level")
    ax.plot(*mass.ground.T, color="black", lw=1.4, zorder=3, label=ground)
    seen = np.all((mass.centre >= low) & (mass.centre <= high))
    (cross,) = ax.plot(*(mass.centre if seen else ([], [])), "k+", ms=9, mew=1.5, zorder=5, ls="", label=words)
    cross.set_path_effects([withStroke(linewidth=HALO + 1.0, foreground="white")])  # it may lie on a dark map
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))


# --- what an arc has beside ------------------------------------------------------------------------------------------


def _write(ax: Any, words: str, at: Any, away: Any, **more: Any) -> None:
    """Words beside a point, in a direction from it."""
    from matplotlib.patheffects import withStroke

    ax.annotate(
        words,
        at,
        12 * np.divide(away, np.hypot(*away)),
        textcoords="offset points",
        ha="center",
        va="center",
        zorder=6,
        path_effects=[withStroke(linewidth=HALO, foreground="white")],
        **more,
    )


def _radii(ax: Any, mass: Mass, small: bool) -> None:
    """The names of ends and centre, with the radii where it is in view, and the depth."""
    one, two = mass.on_circle(mass.ends)
    bottom = mass.on_circle(mass.ends.mean())
    ax.plot(*zip((one + two) / 2, bottom, strict=True), color="black", lw=1.0, marker="_", zorder=3)
    for name, end in () if small else (("$P_1$", one), ("$P_2$", two)):
        _write(ax, name, end, end)
    if ax.viewLim.contains(0.0, 0.0):
        radii = np.stack([one, np.zeros(2), two])
        ax.plot(*radii.T, zorder=1, label="radii $KP_1$, $KP_2$", **LINES["radius"])
        _write(ax, "K", (0.0, 0.0), -bottom, fontweight="bold")


def _forces(ax: Any, motion: Motion, mass: Mass, size: float) -> None:
    """Weight at the mass's centre, and reactions on the arc: normal towards K, tangential against the motion."""
    middle, alpha = float(mass.ends.mean()), float(np.ptp(mass.ends)) / 2
    length = min(0.16 * size, 0.9 * mass.radius * alpha)
    # The centroid of a circular segment; for a thin one 3 alpha^3/(...) -> 1, so its chord's middle will do.
    area = alpha - math.sin(alpha) * math.cos(alpha)
    centre = mass.on_circle(middle) * (2 / 3 * math.sin(alpha) ** 3 / area if alpha > 1e-3 else 1.0)

    def draw(tip: Floats, tail: Floats, what: str, width: float) -> None:
        style = {"arrowstyle": "-|>", "shrinkA": 0, "shrinkB": 0, "mutation_scale": 11}
        ax.annotate("", tip, tail, arrowprops=style | {"color": FORCES[what], "lw": width}, zorder=5)

    tip = centre - [0.0, 1.25 * length]
    draw(tip, centre, "weight", 2.2)
    _write(ax, "$W$", tip, (0.0, -1.0))
    ax.set_ylim(bottom=min(ax.get_ylim()[0], tip[1] - 0.12 * size))
    way = motion.plan.scene.arc.facing * (motion.phases[0].direction if motion.phases else 1)
    reactions = {"normal": "normal reaction $dN$"}
    if float(motion.friction_at(0.0)) > 0.0 or "cohesion" in motion.plan.effects:
        reactions["tangential"] = "tangential reaction $dT$"
    for at in mass.on_circle(middle + alpha * np.array(_ARROWS)):
        outward = at / mass.radius
        draw(at, at + 0.7 * length * outward, "normal", 1.6)
        if "tangential" in reactions:
            foot, along = at + 0.06 * length * outward, way * np.array([-outward[1], outward[0]])
            draw(foot - 0.55 * length * along, foot, "tangential", 1.6)
    for what, words in reactions.items():
        ax.plot([], [], color=FORCES[what], lw=1.6, marker=">", ms=5, label=words)


# --- the slide itself, and the search for its circle -----------------------------------------------------------------


def animate(motion: Motion, figure: Any = None, frames: int = 60) -> Any:
    """The slide as a matplotlib.animation.FuncAnimation: the section, with the mass where it is at even times.

    An empty figure may be given, with a constrained layout; keep what is returned while it plays, or save it. Where the
    mass does not move there is one frame.
    """
    from matplotlib.animation import FuncAnimation
    from matplotlib.patches import Polygon

    ax, soil = section(motion, None if figure is None else figure.add_subplot()), motion.plan.scene.arc
    mass, larger = mass_of(soil, soil), magnified(motion) * float(soil.facing)
    moving = ax.add_patch(Polygon(mass.outline(), closed=True, zorder=4, **AREAS["moving"]))
    times = np.linspace(0.0, motion.duration, frames if motion.moves else 1)
    states = motion.at(times)

    def draw(k: int) -> tuple[Any]:
        moving.set_xy(mass.outline(larger * float(states.rotation[k])))
        ax.figure.suptitle(f"{times[k]:.2f} s, {abs(float(states.velocity[k])):.2f} m/s", fontsize="medium")
        return (moving,)

    draw(0)
    return FuncAnimation(ax.figure, draw, len(times))


def critical_circle(found: Critical, figure: Any) -> Any:
    """The section with the circle, and the least factor that any circle about each centre has, on an empty figure."""
    from matplotlib.patches import Polygon

    ax, mass = figure.add_subplot(), mass_of(found, found.slope)
    outline, ground = mass.outline(), mass.ground
    low, high = outline.min(axis=0), np.maximum(outline.max(axis=0), mass.centre)
    reach = max(float(np.ptp(outline[:, 0])), 1.2 * float(np.ptp(ground[:, 1]))) * np.array([0.8, 0.4])
    low, high = np.maximum(low - reach, [ground[0, 0], -np.inf]), np.minimum(high + reach, [ground[-1, 0], np.inf])
    ax.add_patch(Polygon(outline, closed=True, label="mass", zorder=2, **AREAS["start"]))
    _scenery(ax, mass, found.slope, f"centre; $R$ = {number(mass.radius)} m{_factors(found)}", low, high)
    finish(ax, "$x$ (m)", "$y$ (m)")
    _map(found, ax)
    return figure


def _map(found: Critical, ax: Any) -> None:
    """The least factor of the circles about the centres in each cell, darkest where it is least.

    The frame grows until it holds every centre of a factor up to `_SHARE` above the least, as far as it is not more
    than `_TALL` times as high as wide; what is shown ends at the least factor of a centre outside of the frame.
    """
    known = np.isfinite(found.values)
    centres, values = found.centres[known], found.values[known]
    if values.size <= 10:
        return
    least = float(values.min())
    valley = centres[values <= (1.0 + _SHARE) * least]
    (left, bottom), (right, top) = np.transpose([ax.get_xlim(), ax.get_ylim()])
    left, right = min(left, valley[:, 0].min()), max(right, valley[:, 0].max())
    top = min(max(top, valley[:, 1].max()), bottom + _TALL * (right - left))
    ax.set(xlim=(left, right), ylim=(bottom, top))
    outside = np.any((centres < (left, bottom)) | (centres > (right, top)), axis=1)
    most = min(float(values[outside].min(initial=np.inf)), 1.5 * least)
    drawn = ~outside & (values < most)
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
    words = f"least factor of safety of the circles about each centre, up to {most:.3g}, by {METHODS[found.method][0]}"
    ax.figure.colorbar(cells, ax=ax, location="bottom", shrink=0.8, aspect=40, label=words, format="%.2f")
