"""Input errors and checks. Each mistake has one message with the field, its value and the allowed values."""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from importlib import import_module
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from generated.effects import Parameter
from slipcircle.base.arrays import FLOATS
from slipcircle.base.kinds import Rename, Shape, Texts, Values

Fault = tuple[Any, Callable[[int], str]]  # mask of invalid lanes, and a function that describes a lane
_ARGUMENT = re.compile(r"\{(~?)([a-z_][\w.]*)\}")


class Message(str):
    """Sentence about input in which ``{name}`` marks an argument, so that a file reader can show its own key.

    For ``{~path.name}`` only the last part is shown, if the path is already given.
    """

    __slots__ = ("template",)
    template: str

    def __new__(cls, template: str) -> Self:
        """Create a message from a template with fields in braces."""
        text = _worded(template, str)
        message = super().__new__(cls, text)
        message.template = template
        return message

    def worded(self, name_of: Rename) -> str:
        """Return the sentence with each argument renamed by a function, for example to the key of a file."""
        return _worded(self.template, name_of)

    def within(self, path: str) -> "Message":
        """Return the sentence for arguments nested in ``path``. The first argument is shown with its full path."""
        by_path = rf"{{\g<1>{path}.\g<2>}}"
        by_last_part = rf"{{~{path}.\g<2>}}"
        template = _ARGUMENT.sub(by_path, self.template, count=1)
        head, brace, rest = template.partition("}")
        others = _ARGUMENT.sub(by_last_part, rest)
        return Message(head + brace + others)

    @classmethod
    def of(cls, text: str) -> "Message":
        """Return a text as a message."""
        if isinstance(text, Message):
            return text
        return Message(text)


def _worded(template: str, name_of: Rename) -> str:
    """Return a template with each argument in braces replaced by the name that a function returns for it."""

    def name(match: re.Match[str]) -> str:
        short, path = match.groups()
        full = name_of(path)
        _, _, last = full.rpartition(".")
        return last if short else full

    return _ARGUMENT.sub(name, template)


class InputError(ValueError):
    """Error about invalid input with one `Message` per mistake. Its text names arguments as in Python."""

    def __init__(self, what: str, messages: Iterable[str]) -> None:
        self.what = what
        self.messages = tuple(map(Message.of, messages))
        super().__init__(_lines(self.messages, what))

    def __reduce__(self) -> tuple[Any, ...]:
        """Return the constructor's arguments for pickle."""
        templates = [message.template for message in self.messages]
        return InputError, (self.what, templates)

    def worded(self, name_of: Rename, what: str = "") -> str:
        """Return the messages with arguments renamed by a function, one per line; ``what`` precedes each of them."""
        return _lines([message.worded(name_of) for message in self.messages], what)


def _lines(sentences: Iterable[str], what: str) -> str:
    """Return sentences as lines, each preceded by the name of the invalid object, ``what``, unless it is empty."""
    return "\n".join(f"{what}: {sentence}" if what else sentence for sentence in sentences)


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
            sentences += map(Message, number_mistakes(name, p, value))
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
        raise InputError(what, sentences)


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
        return [Message(message)]
    return []
