"""Errors about input: all mistakes at once, each with the field, the value and what is allowed."""

import math
import re
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from os import PathLike
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

EPS = 2.0**-52  # distance of 1.0 from the next float
INFINITY = float("inf")
Bounds = tuple[float, float, str]  # lower, upper (both open), and the same in words
Fault = tuple[Any, Callable[[int], str]]  # which lanes have a mistake, and what to say of one


_ARGUMENT = re.compile(r"\{(~?)([a-z_][\w.]*)\}")


class Message(str):
    """A sentence about input with ``{name}`` for an argument, which may be replaced by its name elsewhere.

    For ``{~path.name}`` only the last part is shown, if the path is already given.
    """

    __slots__ = ("template",)
    template: str

    def __new__(cls, template: str) -> Self:
        message = super().__new__(cls, _worded(template, str))
        message.template = template
        return message

    def worded(self, name_of: Callable[[str], str]) -> str:
        """The sentence with other names of arguments, such as the keys of a file."""
        return _worded(self.template, name_of)

    def within(self, path: str) -> "Message":
        """The sentence about arguments of a table or an effect: the first is named by its path."""
        first = _ARGUMENT.sub(rf"{{\g<1>{path}.\g<2>}}", self.template, count=1)
        head, brace, rest = first.partition("}")
        return Message(head + brace + _ARGUMENT.sub(rf"{{~{path}.\g<2>}}", rest))

    @classmethod
    def of(cls, text: str) -> "Message":
        """A text as a message."""
        return text if isinstance(text, Message) else Message(text)


def _worded(template: str, name_of: Callable[[str], str]) -> str:
    """A template with the names of its arguments."""

    def name(match: re.Match[str]) -> str:
        short, path = match.groups()
        full = name_of(path)
        return full.rpartition(".")[2] if short else full

    return _ARGUMENT.sub(name, template)


class InputError(ValueError):
    """Invalid input, with one `Message` per mistake; the text of the error names arguments as in Python."""

    def __init__(self, what: str, messages: Iterable[str]) -> None:
        self.what = what
        self.messages = tuple(map(Message.of, messages))
        sentences = "; ".join(self.messages)
        super().__init__(f"{what}: {sentences}" if what else sentences)

    def __reduce__(self) -> tuple[Any, ...]:
        return InputError, (self.what, [m.template for m in self.messages])

    def worded(self, name_of: Callable[[str], str]) -> str:
        """The sentences with other names of arguments."""
        return "; ".join(m.worded(name_of) for m in self.messages)


def plain(value: Any) -> Any:
    """Numbers for computation: a float, ten times cheaper than an array of one, or an array."""
    if type(value) is float:
        return value
    return np.add(value, 0.0) if np.ndim(value) else float(value)


def choose(mask: Any, one: Any, other: Any) -> Any:
    """`numpy.where` that also takes plain numbers."""
    if isinstance(mask, np.ndarray):
        return np.where(mask, one, other)
    return one if mask else other


def two_sum(a: Any, b: Any) -> tuple[Any, Any]:
    """A sum and its rounding error (Knuth's TwoSum)."""
    total = a + b
    part = total - a
    error_of_a = a - (total - part)
    error_of_b = b - part
    return total, error_of_a + error_of_b


def shown(value: Any) -> str:
    """A value in one line; for a long one its type and beginning."""
    text = " ".join(repr(value).split())
    return text if len(text) <= 80 else f"{type(value).__name__} {text[:60]}..."


def mistakes(fields: Mapping[str, ArrayLike], bounds: Mapping[str, Bounds], one: Collection[str] = ()) -> list[str]:
    """A sentence for each field that is not a finite real number within its open bounds, or an array where one number
    is required."""
    sentences = list[str]()
    for name, (lower, upper, allowed) in bounds.items():
        value: Any = fields[name]
        plausible = type(value) is float and lower < value < upper  # most are; arrays take twenty times as long
        if not plausible:
            sentences += _number_mistakes(name, value, (lower, upper, allowed), name in one)
    return [Message(sentence) for sentence in sentences]


def _number_mistakes(name: str, value: ArrayLike, bounds: Bounds, one: bool) -> list[str]:
    """A sentence if a field is not what its bounds allow."""
    lower, upper, allowed = bounds
    try:
        array = np.asarray(value)
    except ValueError:  # a ragged list
        array = np.asarray(None)
    if one and array.ndim > 0:
        return [f"{{{name}}} = {shown(value)}: must be one number"]
    if array.dtype.kind not in "iuf":  # neither text that looks like a number, nor a truth value
        return [f"{{{name}}} = {shown(value)}: must be {allowed}"]
    within = np.isfinite(array) & (array > lower) & (array < upper)
    outside = ~within
    if not np.any(outside):
        return []
    first = float(array[outside].flat[0])
    odd_size = math.isfinite(first) and first > min(lower, 0.0) and first != 0.0  # not an odd sign
    if odd_size and upper < INFINITY:
        least = 0.0 if lower == -5e-324 else lower
        allowed = f"{allowed}, between {least:g} and {upper:g}"
    return [f"{{{name}}} = {first:.10g}: must be {allowed}"]


_KINDS = {
    "text": "a text",
    "flag": "True or False",
    "number": "a number",
    "list": "a list of numbers",
    "series": "a function of time, such as Record(t, a), Record(a, dt=0.01), a Series or a Pulse",
}


def parameter_mistakes(path: str, given: Mapping[str, Any], parameters: Iterable[Any]) -> list[str]:
    """A sentence for each declared parameter that is missing, invalid or out of bounds, and for unknown names."""
    known = {p.name: p for p in parameters if p.kind != "rotation"}
    sentences = list[str]()
    for name, p in known.items():
        if name not in given and not p.optional:
            sentences.append(f"{path}: {name!r} is missing: {p.help}")
    names = ", ".join(known) or "none"
    for name in given:
        if name not in known:
            sentences.append(f"{path}: {name!r} is unknown; known are {names}")
    for name, p in known.items():
        if name in given:
            sentences += _value_mistakes(path, p, given[name])
    return sentences


_SIGNS = {-5e-324: ", at least 0", 0.0: ", positive"}  # by the lower bound


def _value_mistakes(path: str, p: Any, value: Any) -> list[str]:
    """What is wrong with the value of a declared parameter."""
    if p.kind in ("number", "list", "series") and p.key and not callable(value):
        sign = _SIGNS.get(min(p.lower, 0.0), "")
        allowed = f"{p.help}{sign} ({p.unit})"
        bounds = {p.name: (p.lower, p.upper, allowed)}
        sentences = mistakes({p.name: value}, bounds)
        return [Message.of(sentence).within(path) for sentence in sentences]
    if _is_of_kind(p.kind, value):
        return []
    allowed = _KINDS.get(p.kind) or f"one of {p.kind.replace('|', ', ')}"
    return [Message(f"{{{path}.{p.name}}} = {shown(value)}: must be {allowed}: {p.help}")]


def _is_of_kind(kind: str, value: Any) -> bool:
    """Whether a value is what a parameter of this kind, which bounds say nothing about, may be."""
    match kind:
        case "number" | "list":
            return False
        case "series":
            return hasattr(value, "kinks")
        case "flag":
            return isinstance(value, bool)
        case "text":
            return isinstance(value, str | int | PathLike)
    return value in kind.split("|")


def shape_mistakes(fields: Mapping[str, ArrayLike]) -> list[str]:
    """A sentence if the fields' shapes do not broadcast."""
    shapes = {name: np.shape(value) for name, value in fields.items() if type(value) is not float}
    if not shapes:
        return []
    try:
        np.broadcast_shapes(*shapes.values())
    except ValueError:
        listed = ", ".join(f"{name} {shape}" for name, shape in shapes.items() if shape)
        return [f"shapes do not fit together: {listed}"]
    return []


def raise_all(what: str, sentences: Sequence[str]) -> None:
    """Raise one error that lists the mistakes, if there are any."""
    if sentences:
        raise InputError(what, sentences)


def complaint(faults: Iterable[Fault], shape: tuple[int, ...]) -> list[str]:
    """The sentence about the first case with a mistake."""
    for lanes, sentence in faults:
        bad = np.asarray(lanes)
        if not bad.any():
            continue
        first = int(bad.argmax())
        if bad.size == 1:
            return [Message(sentence(first))]
        index = np.unravel_index(first, shape)
        place = ", ".join(map(str, index))
        return [Message(f"lane [{place}]: {sentence(first)}")]
    return []
