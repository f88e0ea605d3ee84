"""Animation of a slide: the section with the mass at equidistant times."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.base.text import output_unit
from slipcircle.core import Motion
from slipcircle.workbench.outputs.pictures.plotstyle import area, formatted_number, pace, panel
from slipcircle.workbench.outputs.pictures.sectionplot import magnified, set_stage

_FRAMES = 60


class Film(NamedTuple):
    """Section with a moving mass: artists that move, a function that draws a frame, and times of the frames in s."""

    figure: Any
    moving: tuple[Any, ...]
    draw: Callable[[int], tuple[Any, ...]]
    times: Floats
    seconds: float  # playing time


def film(motion: Motion, figure: Any, frames: int, seconds: float) -> Film:
    """Return an animated section that plays a motion in ``seconds``, with one frame if the mass does not move.

    ``figure`` is empty or None for a new one; ``frames`` is the number of frames.
    """
    ax = panel(None if figure is None else figure.add_subplot(), "")
    mass = set_stage(motion, ax).mass
    magnification = magnified(motion)
    area(ax, mass.outline(), "start")
    body = area(ax, mass.outline(), "moving", zorder=4)
    times = np.linspace(0.0, motion.settling_time, frames if motion.moves else 1)
    states = motion.at(times)
    turns = magnification * float(motion.plan.scene.arc.facing) * states.rotation
    (far, length), (fast, velocity) = output_unit("m"), output_unit("m/s")
    if motion.moves:
        words = f"; {pace(motion.settling_time, seconds)}"
    else:
        words = ""
    if magnification > 1.0:
        words += f", displacements {formatted_number(magnification)} times as large"
    title = ax.figure.suptitle(" ", fontsize="medium")

    def draw(frame: int) -> tuple[Any, ...]:
        body.set_xy(mass.outline(float(turns[frame])))
        displacement = far * states.displacement[frame]
        speed = fast * abs(states.velocity[frame])
        title.set_text(f"{times[frame]:.2f} s: {displacement:.2f} {length}, {speed:.2f} {velocity}{words}")
        return body, title

    draw(0)
    return Film(ax.figure, (body, title), draw, times, seconds)


def slide_animation(motion: Motion, seconds: float = 5.0, figure: Any = None) -> Any:
    """Return the slide as a `matplotlib.animation.FuncAnimation` that plays for ``seconds``.

    The section shows the mass at equidistant times, with a single frame if it does not move. A given figure has to be
    empty, with a constrained layout. Keep a reference to the animation while it plays, or save it.
    """
    from matplotlib.animation import FuncAnimation

    slide = film(motion, figure, _FRAMES, seconds)
    return FuncAnimation(slide.figure, slide.draw, len(slide.times), interval=1e3 * seconds / _FRAMES)
