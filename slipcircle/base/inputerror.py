"""Errors about invalid input, whose messages name arguments as in Python or by the keys of a file."""

import re
from collections.abc import Iterable
from typing import Any, Self

from slipcircle.base.kinds import Rename

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
