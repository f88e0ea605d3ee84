"""Checks of input. Each mistake has one message with the field, its value and the allowed values."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from generated.effects import Parameter
from slipcircle.base.arrays import FLOATS
from slipcircle.base.kinds import Shape, Texts, Values

Fault = tuple[Any, Callable[[int], str]]  # mask of invalid lanes, and a function that describes a lane


class UnusualInput(UserWarning):
    """Warning about a number that was probably meant in another unit."""


def mistakes(given: Values, declared: Mapping[str, Parameter]) -> Texts:
    """Return a message for each number that is not finite, not within its open bounds, or not a single number.

    ``declared`` are the declarations of the numbers by name. Numbers of kind "fixed" must not be arrays.
    """
    sentences: Texts = []
    for name, p in declared.items():
        value = given[name]
        plausible = type(value) in FLOATS and p.lower < value < p.upper  # usual; arrays take twenty times as long
        if not plausible:
            number_mistakes = import_module("slipcircle.base.bounds").number_mistakes
            sentences += number_mistakes(name, p, value)
    return sentences


def one_number(lower: float, upper: float, allowed: str) -> Parameter:
    """Return the declaration of a single number with open bounds and the allowed values in words."""
    return Parameter("", "", lower, upper, allowed=allowed, kind="fixed")


def shape_mistakes(fields: Mapping[str, ArrayLike]) -> Texts:
    """Return a message, as a list of at most one element, if the shapes of the fields do not broadcast."""
    shapes = {}
    for name, value in fields.items():
        shape = () if type(value) is float else np.shape(value)
        if shape:
            shapes[name] = shape
    if not shapes:
        return []
    try:
        np.broadcast_shapes(*shapes.values())
    except ValueError:
        listed = [f"{name} {shape}" for name, shape in shapes.items()]
        return [f"shapes do not fit together: {', '.join(listed)}"]
    return []


def raise_all(what: str, sentences: Sequence[str]) -> None:
    """Raise one `InputError` with all messages, if there are any. The invalid object is named ``what``."""
    if sentences:
        raise import_module("slipcircle.base.inputerror").InputError(what, sentences)


def complaint(faults: Iterable[Fault], shape: Shape) -> Texts:
    """Return the message about the first invalid lane, as a list of at most one element; ``shape`` is the lanes'."""
    for lanes, sentence in faults:
        bad = np.asarray(lanes)
        if not bad.any():
            continue
        first = int(bad.argmax())
        message = sentence(first)
        if bad.size > 1:
            index = np.unravel_index(first, shape)
            place = ", ".join(map(str, index))
            message = f"lane [{place}]: {message}"
        return [import_module("slipcircle.base.inputerror").Message(message)]
    return []
