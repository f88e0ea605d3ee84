"""Numbers of an unusual size are questioned: a soil's weight, strength or friction that was meant in another unit.

One rule for all parameters, by what `generated.effects` declares for their unit: a value outside what soils have, which
another unit would bring inside. Such a scene is solved all the same; `Motion.warnings` asks.
"""

import math
from collections.abc import Callable, Iterator

import numpy as np

from generated import effects as declared
from slipcircle.core.scene.scene import Scene
from slipcircle.derivatives.parameters import possible_parameters

_STRONG, _STRONGEST = 1e6, 5.0  # Pa, g


def questions(scene: Scene, written: Callable[[str, float], str] | None = None) -> Iterator[str]:
    """A sentence for each number of a scene that was probably meant in another unit.

    It begins with the number as its user wrote it: from a name and a value in SI units, by default just these.
    """
    known = possible_parameters(scene)

    def in_si(name: str, value: float) -> str:
        unit = known[name].unit if name in known else ""
        return f"{name} = {value:.6g} {unit}".rstrip()

    in_words = written or in_si
    for name, values in scene.numbers.items():
        unit = known[name].unit if name in known else ""
        words = name.split(".")
        is_friction = "friction" in words and "rate" not in words and not unit
        is_load = words[0] == "surcharge" or words[-1] == "cohesion"
        numbers = np.asarray(values, dtype=np.float64)
        for value in np.unique(numbers).tolist():
            question = _of_friction(value) if is_friction else _of_unit(value, unit)
            if name == "shaking.amplitude" and abs(value) > _STRONGEST:
                question = f"no ground has shaken with more than {_STRONGEST:g} g; is that in m/s^2 or in %?"
            if unit == "Pa" and is_load and value > _STRONG:
                meant = value / 1e3
                question = f"soils and loads have less; was {meant:g} Pa meant, {meant / 1e3:g} kPa?"
            if question:
                yield f"{in_words(name, value)}: {question}"
                break
        start, _, last = name.rpartition(".")
        residual = scene.numbers.get(f"{start}.residual")
        if last == "peak" and is_friction and residual is not None and np.any(numbers < np.asarray(residual)):
            exchanged = "below the residual friction, so that the soil strengthens as it slips; were they exchanged?"
            lowest = float(np.min(numbers))
            yield f"{in_words(name, lowest)}: {exchanged}"


def _of_unit(value: float, unit: str) -> str:
    if value == 0.0 or unit not in declared.USUAL:
        return ""
    least, most = declared.USUAL[unit]
    if least <= value <= most:
        return ""
    for other, size in declared.OTHER_UNITS[unit].items():
        if least <= value * size <= most:
            gravity = " under 9.81 m/s^2" if size == 9.81 else ""
            return f"is that in {other}? 1 {other} is {size:g} {unit}{gravity}"
    return ""


def _of_friction(coefficient: float) -> str:
    least, most = declared.USUAL_FRICTION
    if coefficient > most:
        of_angle = math.tan(math.radians(coefficient))
        return f"is that an angle? The coefficient of {coefficient:.6g} deg is {of_angle:.4g}"
    angle = math.degrees(math.atan(coefficient))
    if 0.0 < coefficient < least and angle > 0.05:
        meant = math.degrees(angle)
        return f"an angle of {angle:.3g} deg; was that meant in rad? {angle:.3g} rad are {meant:.3g} deg"
    return ""
