"""Input errors and checks. Each mistake has one message with the field, its value and the allowed values."""

import math
import re
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from os import PathLike
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from slipcircle.base.arrays import INFINITY, array_of
from slipcircle.base.kinds import Rename, Shape, Texts, Values

Bounds = tuple[float, float, str]  # open lower and upper bound, and their description in words
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


def abridged(value: Any) -> str:
    """Return the representation of a value on one line, or its type and beginning if it is long."""
    if isinstance(value, int) and abs(value) >= 10**100:
        return f"an integer of {value.bit_length()} bits"
    words = repr(value).split()
    text = " ".join(words)
    if len(text) <= 80:
        return text
    kind = type(value).__name__
    return f"{kind} {text[:60]}..."


def mistakes(fields: Mapping[str, ArrayLike], bounds: Mapping[str, Bounds], one: Collection[str] = ()) -> Texts:
    """Return a message for each field that is not finite or not in its open bounds, or is in ``one`` and an array."""
    sentences: Texts = []
    for name, allowed in bounds.items():
        value: Any = fields[name]
        lower, upper, _ = allowed
        plausible = type(value) is float and lower < value < upper  # the usual case; arrays take twenty times as long
        if not plausible:
            sentences += map(Message, _number_mistakes(name, value, allowed, name in one))
    return sentences


def _number_mistakes(name: str, value: ArrayLike, bounds: Bounds, one: bool) -> Texts:
    """Return a message if a field violates its open bounds, or if it must be ``one`` number and is an array."""
    lower, upper, allowed = bounds
    array = array_of(value)
    if one and array.ndim > 0:
        return [f"{{{name}}} = {abridged(value)}: must be one number"]
    if array.dtype.kind not in "iuf":  # neither text that looks like a number, nor a truth value
        return [f"{{{name}}} = {abridged(value)}: must be {allowed}"]
    above = array > lower
    below = array < upper
    allowed_values = np.isfinite(array) & above & below
    outside = array[~allowed_values]
    if not outside.size:
        return []
    first = float(outside[0])
    least = min(lower, 0.0)
    sign_is_right = first > least and first != 0.0
    if sign_is_right and math.isfinite(first) and upper < INFINITY:
        least = 0.0 if lower == -5e-324 else lower
        allowed = f"{allowed}, between {least:g} and {upper:g}"
    return [f"{{{name}}} = {first:.10g}: must be {allowed}"]


_KINDS = {
    "text": "a text",
    "name": "a name or a number",
    "flag": "True or False",
    "number": "a number",
    "list": "a list of numbers",
    "series": "a function of time, such as Record(t, a), Record(a, dt=0.01), a Series or a Pulse",
}


def parameter_mistakes(path: str, values: Values, parameters: Sequence[Any]) -> Texts:
    """Return a message for each parameter that is missing, invalid or unknown; ``path`` names its effect or law."""
    if _are_plain(values, parameters):
        return []
    declared = {p.name: p for p in parameters if p.kind != "rotation"}
    missing = [p for name, p in declared.items() if not p.optional and name not in values]
    sentences = [f"{path}: {p.name!r} is missing: {p.help}" for p in missing]
    names = ", ".join(declared) or "none"
    sentences += [f"{path}: {name!r} is unknown; known are {names}" for name in values if name not in declared]
    for name, p in declared.items():
        if name in values:
            sentences += _value_mistakes(path, p, values[name])
    return sentences


def _are_plain(values: Values, parameters: Sequence[Any]) -> bool:
    """Return whether the values by name are one valid float per required parameter and nothing else, the usual case."""
    count = 0
    for p in parameters:
        if p.optional and p.name not in values:
            continue
        count += 1
        value = values.get(p.name)
        if p.kind != "number" or type(value) is not float or not p.lower < value < p.upper:
            return False
    return len(values) == count


_SIGNS = {-5e-324: ", at least 0", 0.0: ", positive"}  # by the lower bound


def _value_mistakes(path: str, p: Any, value: Any) -> Texts:
    """Return messages about the value of the declared parameter ``p``. Its effect or law is named ``path``."""
    has_bounds = p.key and p.kind in ("number", "list", "series", "fixed")
    if has_bounds and not callable(value):
        lower = min(p.lower, 0.0)
        sign = _SIGNS.get(lower, "")
        allowed = f"{p.help}{sign} ({p.unit})"
        bounds = {p.name: (p.lower, p.upper, allowed)}
        one = (p.name,) if p.kind == "fixed" else ()
        sentences = mistakes({p.name: value}, bounds, one)
        messages = map(Message.of, sentences)
        return [message.within(path) for message in messages]
    if _is_of_kind(p.kind, value):
        return []
    choices = p.kind.replace("|", ", ")
    allowed = _KINDS.get(p.kind, f"one of {choices}")
    name = f"{path}.{p.name}"
    sentence = f"{{{name}}} = {abridged(value)}: must be {allowed}: {p.help}"
    return [Message(sentence)]


def _is_of_kind(kind: str, value: Any) -> bool:
    """Return whether a value has the type that its parameter's kind requires."""
    match kind:
        case "number" | "list" | "fixed":
            return False
        case "series":
            return hasattr(type(value), "kinks")
        case "flag":
            return isinstance(value, bool)
        case "text" | "name":
            return isinstance(value, str | int | PathLike)
    return value in kind.split("|")


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
