"""The method from whose factor of safety a motion starts, and the motion from another method's factor."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any, NamedTuple

from slipcircle.base.kinds import ValueDict
from slipcircle.base.text import measured
from slipcircle.core import Motion, Scene, solve
from slipcircle.workbench.stability.critical import SlopeScene
from slipcircle.workbench.stability.starting import OF_CLOSURE

_WHOSE = {"paper": "the paper's", "ordinary": "the ordinary method's", "bishop": "Bishop's"}


class Start(NamedTuple):
    """A method, the strength factor and the factor of safety that it gives, and the motion that starts from it.

    Under shaking the yield coefficient is in the place of the factor of safety. A motion without a result is None.
    """

    method: str
    strength_factor: float
    value: float
    motion: Motion | None

    def record(self) -> ValueDict:
        """Return the start for JSON."""
        run_out = self.motion.run_out if self.motion else None
        return {"method": self.method, "strength_factor": self.strength_factor, "run_out": run_out}


def method_of(scene: Scene[Any]) -> str:
    """Return the method from whose factor of safety the motion of a scene starts."""
    return scene.start if isinstance(scene, SlopeScene) else OF_CLOSURE


def starts(motion: Motion) -> tuple[Start, Start] | None:
    """Return the start of a single motion and the alternative; None where both are equal or none is chosen."""
    scene = motion.plan.scene
    if not isinstance(scene, SlopeScene) or not scene.starts_by_method:
        return None
    other = "bishop" if scene.start == OF_CLOSURE else OF_CLOSURE
    try:
        alternative = replace(scene, start=other)
    except ValueError:
        return None
    if alternative.strength_factor == scene.strength_factor:
        return None
    try:
        moved = solve(alternative)
    except ValueError:
        moved = None
    return _start(motion, scene), _start(moved, alternative)


def _start(motion: Motion | None, scene: SlopeScene) -> Start:
    """Return the start of a scene with its motion."""
    value = float("nan")
    if motion is not None:
        value = motion.yield_coefficient if "shaking" in scene.called else motion.factor_of_safety
    return Start(scene.start, float(scene.strength_factor), value, motion)


def start_words(motion: Motion, of_methods: tuple[Start, ...]) -> str:
    """Return the run-out from the factor of each of these methods, in words."""
    symbol = "k_y" if "shaking" in motion.plan.scene.called else "F"
    return "; ".join(_words(symbol, of_methods))


def _words(symbol: str, both: tuple[Start, ...]) -> Iterator[str]:
    """Yield the run-out from the factor of each method."""
    for method, _, value, motion in both:
        if motion is None:
            yield f"no result from {_WHOSE[method]} {symbol}"
            continue
        run_out = float(motion.run_out)
        moved = measured(run_out, "m", 3 if abs(run_out) >= 1.0 else 2) if motion.moves else "does not move"
        yield f"{moved} from {_WHOSE[method]} {symbol} = {value:.3f}"
