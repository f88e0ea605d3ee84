"""Numbers of an unusual size are questioned: a soil's weight, strength or friction that was meant in another unit.

One rule for all parameters, by what `generated.effects` declares for their unit: a value outside what soils have, which
another unit would bring inside. Such a scene is solved all the same; `Motion.warnings` asks.
"""

import math
from collections.abc import Iterator

import numpy as np

from generated import effects as declared
from slipcircle.core.scene.parameters import parameters
from slipcircle.core.scene.scene import Scene


def questions(scene: Scene) -> Iterator[str]:
    """A sentence for each number of a scene that was probably meant in another unit."""
    known = parameters(scene)
    for name, values in scene.numbers.items():
        unit = known[name].unit if name in known else ""
        for value in np.unique(np.asarray(values, dtype=np.float64)):
            if "friction" in name.split(".") and not unit and "rate" not in name.split("."):
                question = _of_friction(float(value))
            else:
                question = _of_unit(float(value), unit)
            if question:
                yield f"{name} = {value:.6g}{f' {unit}' if unit else ''}: {question}"
                break


def _of_unit(value: float, unit: str) -> str:
    least, most = declared.USUAL.get(unit, (-math.inf, math.inf))
    if value == 0.0 or least <= value <= most:
        return ""
    for other, size in declared.OTHER_UNITS[unit].items():
        if least <= value * size <= most:
            return f"is that in {other}? 1 {other} is {size:g} {unit}" + (" under 9.81 m/s^2" if size == 9.81 else "")
    return ""


def _of_friction(coefficient: float) -> str:
    if coefficient > declared.USUAL_FRICTION[1]:
        return (
            f"is that an angle? The coefficient of {coefficient:.6g} deg is {math.tan(math.radians(coefficient)):.4g}"
        )
    angle = math.degrees(math.atan(coefficient))
    if 0.0 < coefficient < declared.USUAL_FRICTION[0] and angle > 0.05:
        return f"an angle of {angle:.3g} deg; was that meant in rad? {angle:.3g} rad are {math.degrees(angle):.3g} deg"
    return ""
