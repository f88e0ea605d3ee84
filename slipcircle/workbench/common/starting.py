"""Start of a motion from the factor of safety of a method, and the alternative start by another method."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any, NamedTuple

from slipcircle.base.kinds import ValueDict
from slipcircle.base.text import amount_text
from slipcircle.core import Motion, Scene, solve
from slipcircle.workbench.stability.critical import SlopeScene
from slipcircle.workbench.stability.starting import OF_CLOSURE

_WHOSE = {"paper": "the paper's", "ordinary": "the ordinary method's", "bishop": "Bishop's"}


class Start(NamedTuple):
    """Start of a motion by a method: strength factor, factor of safety, and the motion from there.

    Under shaking, ``value`` is the yield coefficient instead of the factor of safety. The motion is None if it has no
    result.
    """

    method: str
    strength_factor: float
    value: float
    motion: Motion | None

    def record(self) -> ValueDict:
        """Return method, strength factor and run-out in m as values of JSON."""
        run_out = self.motion.run_out if self.motion else None
        return {"method": self.method, "strength_factor": self.strength_factor, "run_out": run_out}


def method_of(scene: Scene[Any]) -> str:
    """Return the name of the method whose factor of safety starts the motion of a scene."""
    return scene.start if isinstance(scene, SlopeScene) else OF_CLOSURE


def starts(motion: Motion) -> tuple[Start, Start] | None:
    """Return the start of a single motion and the alternative; None if both are equal or no method is chosen."""
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
    """Return the start of a scene, and the motion from there, which is None if it has no result."""
    value = float("nan")
    if motion is not None:
        value = motion.yield_coefficient if "shaking" in scene.called else motion.factor_of_safety
    return Start(scene.start, float(scene.strength_factor), value, motion)


def start_words(motion: Motion, of_methods: tuple[Start, ...]) -> str:
    """Return in words the run-out from the factor of safety of each start; ``motion`` is that of the scene."""
    return "; ".join(_words("k_y" if "shaking" in motion.plan.scene.called else "F", of_methods))


def _words(symbol: str, both: tuple[Start, ...]) -> Iterator[str]:
    """Yield in words the run-out of each start; ``symbol`` is "F" or, under shaking, "k_y"."""
    for method, _, value, motion in both:
        if motion is None:
            yield f"{_WHOSE[method]} {symbol}: no result"
            continue
        run_out = float(motion.run_out)
        moved = amount_text(run_out, "m", 3 if abs(run_out) >= 1.0 else 2) if motion.moves else "does not move"
        yield f"{_WHOSE[method]} {symbol} = {value:.3f}: {moved}"
