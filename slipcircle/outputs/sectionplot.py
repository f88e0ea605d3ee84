"""The section as a picture, after Figure 1-1: arc, chord, mass, centre, and the forces on it."""

import math
from typing import Any

import numpy as np

from slipcircle.motion.motion import Motion
from slipcircle.outputs import slopeplot
from slipcircle.outputs.plotstyle import AREAS, FORCES, HALO, LINES, axis, finish, mark, number
from slipcircle.outputs.trace import Floats
from slipcircle.scene.section import Section

_ARROWS = (-0.6, -0.2, 0.2, 0.6)  # where on the arc reactions are drawn, over alpha
_SMALL = 0.12  # chord over view: below, the mass is a mark, without forces
_SEEN, _WIDE = 0.02, 0.1  # displacements over the chord: which is drawn as it is, and what a smaller one is drawn as


def section(motion: Motion, ax: Any = None) -> Any:
    """The section: the mass at the start, at the peak velocity and at the end, with the forces at the start.

    It is drawn turned by s/R (1.2), also where the geometry is frozen: there the forces stay those of the start; and
    by more where that could not be seen. The legend says so. Axes are metres from the centre K, x to the right, y up.
    """
    from matplotlib.patches import Polygon

    arc = motion.plan.scene.arc
    if isinstance(arc, Section):
        return slopeplot.slide(motion, arc, ax)
    ax = axis(ax, (7.0, 5.5))
    radius, first, second = (float(v) for v in (arc.radius, arc.theta_1, arc.theta_2))
    times, places = magnified(motion), slopeplot.places(motion, f"{number(motion.end.displacement)} m")
    turned = [times * rotation * arc.facing for _, rotation, _ in places]
    swept = np.linspace(first + min(turned), second + max(turned), 400)
    ax.plot(*_points(radius, swept), label="slip surface", color="0.45", lw=1.2)
    outlines = [_points(radius, np.linspace(first, second, 200) + rotation) for rotation in turned]
    shown = _view(ax, np.concatenate(outlines, axis=1))
    small = 2 * radius * math.sin((second - first) / 2) < _SMALL * shown
    for (role, _, words), outline in zip(places, outlines, strict=True):
        if small:
            x, y = outline.mean(axis=1)
            mark(ax, x, y, role, words)
        else:
            ax.add_patch(Polygon(outline.T, closed=True, label=words, zorder=2, **AREAS[role]))
    ax.plot(*_points(radius, np.array([first, second])), color="black", lw=1.4, zorder=3)
    _dimensions(ax, radius, first, second, small)
    notes = {
        # The paper turns the mass (1.2) and takes J_r and J_theta, practically constant to it, at the start.
        "frozen geometry: the mass turns by $s/R$,\nits forces stay those of the start":
            motion.moves and "rotation" not in motion.plan.effects,
        f"displacements drawn {number(times)} times as large": times > 1.0,
    }  # fmt: skip
    for note in (words for words, holds in notes.items() if holds):
        ax.plot([], [], ls="", label=note)
    if not small:
        _forces(ax, motion, radius, first, second, shown)
    finish(ax, "$x$ from the centre K (m)", "$y$ from the centre K (m)")
    return ax


def magnified(motion: Motion) -> float:
    """How many times as large displacements are drawn so that they are seen: 1, 2 or 5 times a power of ten."""
    arc = motion.plan.scene.arc
    moved = abs(float(motion.reach.rotation)) / (2 * math.sin(float(arc.half_angle))) if motion.moves else 0.0
    if isinstance(arc, Section) or moved >= _SEEN or moved == 0.0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(_WIDE / moved))
    return max(n * power for n in (1.0, 2.0, 5.0) if n * power <= _WIDE / moved)


def _points(radius: float, angles: Floats) -> Floats:
    return radius * np.array([np.cos(angles), np.sin(angles)])


def _view(ax: Any, outlines: Floats) -> float:
    """Set the limits; the centre is in view where it does not make the mass small. Returns the view's size."""
    low, high = outlines.min(axis=1), outlines.max(axis=1)
    with_centre = np.minimum(low, 0.0), np.maximum(high, 0.0)
    if max(with_centre[1] - with_centre[0]) < 6 * max(high - low):
        low, high = with_centre
    size = float(max(high - low))
    low, high = low - 0.14 * size, high + 0.14 * size
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    return size


def _write(ax: Any, words: str, at: Floats, away: Floats, **more: Any) -> None:
    """Words beside a point, a few points away from it in a direction."""
    from matplotlib.patheffects import withStroke

    unit = away / max(float(np.hypot(*away)), 1e-300)
    across = "left" if unit[0] > 0.4 else "right" if unit[0] < -0.4 else "center"
    up = "bottom" if unit[1] > 0.4 else "top" if unit[1] < -0.4 else "center"
    options: dict[str, Any] = {"ha": across, "va": up, "zorder": 6} | more
    ax.annotate(words, at, 6 * unit, textcoords="offset points",
                path_effects=[withStroke(linewidth=HALO, foreground="white")], **options)  # fmt: skip


def _dimensions(ax: Any, radius: float, first: float, second: float, small: bool) -> None:
    """Ends, centre, radius, chord and depth."""
    alpha, middle = (second - first) / 2, (first + second) / 2
    ends = _points(radius, np.array([first, second])).T
    for name, end in () if small else zip(("$P_1$", "$P_2$"), ends, strict=True):
        _write(ax, name, end, end)
    inward = -_points(1.0, np.array([middle]))[:, 0]
    chord, bottom = -radius * math.cos(alpha) * inward, -radius * inward
    depth = 2 * radius * math.sin(alpha / 2) ** 2
    words = f"chord {number(2 * radius * math.sin(alpha))} m, depth {number(depth)} m"
    ax.plot([chord[0], bottom[0]], [chord[1], bottom[1]], color="black", lw=1.0, marker="_", zorder=3)
    (x0, x1), (y0, y1) = ax.get_xlim(), ax.get_ylim()
    if x0 < 0.0 < x1 and y0 < 0.0 < y1:
        ax.plot(0.0, 0.0, "k+", ms=9, mew=1.5, zorder=5)
        (x1, y1), (x2, y2) = ends
        ax.plot([x1, 0.0, x2], [y1, 0.0, y2], zorder=1, label="radii $KP_1$, $KP_2$", **LINES["radius"])
        _write(ax, "K", np.zeros(2), inward, fontweight="bold")
    words += f"\n$R$ = {number(radius)} m, dip of the chord {number(math.degrees(1.5 * math.pi - middle))} deg"
    ax.plot([], [], color="black", lw=1.4, label=words)


def _forces(ax: Any, motion: Motion, radius: float, first: float, second: float, shown: float) -> None:
    """Weight at the mass's centre, and reactions on the arc: normal towards K, tangential against the motion."""
    arc = motion.plan.scene.arc
    alpha, middle = (second - first) / 2, (first + second) / 2
    length = min(0.16 * shown, 0.9 * radius * alpha)
    # The centroid of a circular segment; for a thin one 3 alpha^3/(...) -> 1, so its chord's middle will do.
    area = alpha - math.sin(alpha) * math.cos(alpha)
    out = 2 / 3 * math.sin(alpha) ** 3 / area if alpha > 1e-3 else 1.0
    centre = _points(radius * out, np.array([middle]))[:, 0]

    def draw(tip: Floats, tail: Floats, what: str, width: float) -> None:
        style = {"arrowstyle": "-|>", "shrinkA": 0, "shrinkB": 0, "mutation_scale": 11}
        ax.annotate("", tip, tail, arrowprops=style | {"color": FORCES[what], "lw": width}, zorder=5)

    tip = centre - [0.0, 1.25 * length]
    draw(tip, centre, "weight", 2.2)
    _write(ax, "$W$", tip, np.array([0.0, -1.0]))
    ax.set_ylim(bottom=min(ax.get_ylim()[0], tip[1] - 0.12 * shown))
    way = arc.facing * (motion.phases[0].direction if motion.phases else 1)
    reactions = {"normal": "normal reaction $dN$"}
    if float(motion.friction_at(0.0)) > 0.0 or "cohesion" in motion.plan.effects:
        reactions["tangential"] = "tangential reaction $dT$"
    for share in _ARROWS:
        at = _points(radius, np.array([middle + share * alpha]))[:, 0]
        outward = at / radius
        draw(at, at + 0.7 * length * outward, "normal", 1.6)
        if "tangential" in reactions:
            foot, along = at + 0.06 * length * outward, way * np.array([-outward[1], outward[0]])
            draw(foot - 0.55 * length * along, foot, "tangential", 1.6)
    for what, words in reactions.items():
        ax.plot([], [], color=FORCES[what], lw=1.6, marker=">", ms=5, label=words)


def animate(motion: Motion, figure: Any = None, frames: int = 60) -> Any:
    """The slide as a matplotlib.animation.FuncAnimation: the section, with the mass where it is at even times.

    An empty figure may be given, with a constrained layout; keep what is returned while it plays, or save it. Where the
    mass does not move there is one frame.
    """
    from matplotlib.animation import FuncAnimation
    from matplotlib.patches import Polygon

    ax = section(motion, None if figure is None else figure.add_subplot())
    arc = motion.plan.scene.arc
    if isinstance(arc, Section):
        centre, outline = np.asarray(arc.centre, dtype=np.float64), slopeplot.outline(arc, arc)
    else:
        radius, first, second = (float(v) for v in (arc.radius, arc.theta_1, arc.theta_2))
        centre, outline = np.zeros(2), _points(radius, np.linspace(first, second, 200)).T
    moving = ax.add_patch(Polygon(outline, closed=True, zorder=4, **AREAS["moving"]))
    times, larger = np.linspace(0.0, motion.duration, frames if motion.moves else 1), magnified(motion)
    states = motion.at(times)

    def draw(k: int) -> tuple[Any]:
        turn = float(states.rotation[k]) * float(arc.facing) * larger
        way = np.array([[math.cos(turn), math.sin(turn)], [-math.sin(turn), math.cos(turn)]])
        moving.set_xy(centre + (outline - centre) @ way)
        ax.figure.suptitle(f"{times[k]:.2f} s, {abs(float(states.velocity[k])):.2f} m/s", fontsize="medium")
        return (moving,)

    draw(0)
    return FuncAnimation(ax.figure, draw, len(times))
