"""Messages about values that are not numbers within their bounds."""

import math
from typing import Any

from generated.effects import Parameter
from slipcircle.base.arrays import INFINITY, array_of
from slipcircle.base.inputerror import Message
from slipcircle.base.kinds import Texts

_SIGNS = {-5e-324: ", at least 0", 0.0: ", positive"}  # by the lower bound


def number_mistakes(name: str, p: Parameter, value: Any) -> Texts:
    """Return a message if the value of a number violates its declaration ``p``. ``name`` is its name in the message."""
    array = array_of(value)
    if p.kind == "fixed" and not p.axes and array.ndim:
        return [Message(f"{{{name}}} = {abridged(value)}: must be one number")]
    sign = _SIGNS.get(min(p.lower, 0.0), "")
    allowed = p.allowed or f"{p.help}{sign} ({p.unit})"
    if array.dtype.kind not in "iuf":  # neither text that looks like a number, nor a truth value
        return [Message(f"{{{name}}} = {abridged(value)}: must be {allowed}")]
    outside = array[~p.allows(array)]
    if not outside.size:
        return []
    first = float(outside[0])
    least = min(p.lower, 0.0)
    sign_is_right = first > least and first != 0.0
    if sign_is_right and math.isfinite(first) and p.upper < INFINITY:
        least = 0.0 if p.lower == -5e-324 else p.lower
        allowed = f"{allowed}, between {least:g} and {p.upper:g}"
    return [Message(f"{{{name}}} = {first:.10g}: must be {allowed}")]


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
