"""Questions about numbers of unusual size, such as a unit weight that was probably meant in another unit.

One rule serves all parameters: `generated.effects` declares the usual range of each unit, and a value outside it is
questioned if another unit would bring it inside. The scene is solved nevertheless. The question appears in
`Motion.warnings`, and as a warning if the scene is created in Python.
"""

import math
import sys
import warnings
from collections.abc import Callable, Iterator

import numpy as np

from generated import effects as declared
from slipcircle.base.errors import UnusualInput
from slipcircle.core.scene.scene import Scene
from slipcircle.tree import leaves

_STRONG = 1e6  # Pa, g
_STRONGEST = 5.0


def questions(scene: Scene, written: Callable[[str, float], str] | None) -> Iterator[str]:
    """Yield a question for each number of a scene that was probably meant in another unit.

    ``written`` converts a name and a value in SI units to the number as the user wrote it. Without it, the question
    begins with name and value.
    """
    units = {leaf.path: leaf.number.unit for leaf in leaves(scene)}

    def in_si(name: str, value: float) -> str:
        unit = units.get(name, "")
        return f"{name} = {value:.6g} {unit}".rstrip()

    in_words = written or in_si
    for name, values in scene.numbers.items():
        unit = units.get(name, "")
        numbers = np.unique(values).tolist()
        for value in numbers:
            question = _question(name, value, unit)
            if question:
                yield f"{in_words(name, value)}: {question}"
                break
        start, _, last = name.rpartition(".")
        residual = scene.numbers.get(f"{start}.residual", -math.inf)
        is_weaker = np.any(np.asarray(values) < np.asarray(residual))
        if last == "peak" and is_weaker and _is_friction(name, unit):
            exchanged = "below the residual friction: the soil strengthens as it slips; were they exchanged?"
            yield f"{in_words(name, numbers[0])}: {exchanged}"


_MAKERS = ("slipcircle.core.scene.scene", "dataclasses", "copy", __name__)


def warn(scene: Scene) -> None:
    """Warn of unusual numbers where a user creates a scene.

    For scene files the questions are printed with the result.
    """
    level = 1
    frame = sys._getframe()
    while frame.f_back and frame.f_globals["__name__"] in _MAKERS:
        frame = frame.f_back
        level += 1
    if not frame.f_globals["__name__"].startswith("slipcircle."):
        for question in questions(scene, None):
            warnings.warn(question, UnusualInput, stacklevel=level)


def _is_friction(name: str, unit: str) -> bool:
    """Return whether a number is a friction coefficient, by its path and its unit, "" for a coefficient."""
    words = name.split(".")
    return "friction" in words and "rate" not in words and not unit


def _question(name: str, value: float, unit: str) -> str:
    """Return the question about a number, empty if the number is usual.

    ``name`` is its path in the scene, and ``value`` is in the SI ``unit``.
    """
    if name == "shaking.amplitude" and abs(value) > _STRONGEST:
        return f"no ground has shaken with more than {_STRONGEST:g} g; is that in m/s^2 or in %?"
    is_strength = name.startswith("surcharge.") or name.endswith("cohesion")
    if is_strength and unit == "Pa" and value > _STRONG:
        meant = value / 1e3
        return f"soils and loads have less; was {meant:g} Pa meant, {meant / 1e3:g} kPa?"
    if _is_friction(name, unit):
        return _of_friction(value)
    return _of_unit(value, unit)


def _of_unit(value: float, unit: str) -> str:
    """Return the question about a value outside the usual range of its SI unit, empty if it is usual."""
    if value == 0.0 or unit not in declared.USUAL:
        return ""
    least, most = declared.USUAL[unit]
    if least <= value <= most:
        return ""
    for other, size in declared.OTHER_UNITS[unit].items():
        if least <= value * size <= most:
            gravity = " under 9.81 m/s^2" if size == 9.81 else ""
            return f"is that in {other}? 1 {other} is {size:g} {unit}{gravity}"
    if 0.0 < value < declared.LEAST[unit]:
        return f"soils have at least {declared.LEAST[unit]:g} {unit}; in which unit was it meant?"
    return ""


def _of_friction(coefficient: float) -> str:
    """Return the question about an unusual friction coefficient tan(phi), empty if it is usual."""
    least = declared.USUAL_FRICTION[0]
    most = declared.QUESTIONED_FRICTION
    if coefficient >= 90.0:
        return f"soils have less than {most:g}; it is tan(phi)"
    if coefficient > most:
        of_angle = math.tan(math.radians(coefficient))
        return f"is that an angle? The coefficient of {coefficient:.6g} deg is {of_angle:.4g}"
    angle = math.degrees(math.atan(coefficient))
    if 0.0 < coefficient < least and angle > 0.05:
        meant = math.degrees(angle)
        return f"an angle of {angle:.3g} deg; was that meant in rad? {angle:.3g} rad are {meant:.3g} deg"
    return ""
