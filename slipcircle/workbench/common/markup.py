"""Texts and tables as HTML that is also good XML."""

import html
import re
from collections.abc import Iterable, Sequence


class Raw(str):
    """Text that is HTML already."""

    __slots__ = ()


def escaped(text: str) -> str:
    """Text in which nothing is HTML, and which XML may hold."""
    return html.escape(re.sub(r"[^\t\n\r -\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]", "\ufffd", text))


def tag(name: str, text: str) -> Raw:
    """Text in an element."""
    return Raw(f"<{name}>{text if isinstance(text, Raw) else escaped(text)}</{name}>")


def table(rows: Iterable[Sequence[str]], head: Sequence[str] = ()) -> Raw:
    """A table of texts."""
    top = f"<thead><tr>{''.join(tag('th', c) for c in head)}</tr></thead>" if head else ""
    body = "\n".join(f"<tr>{''.join(tag('td', c) for c in row)}</tr>" for row in rows)
    return Raw(f"<table>{top}<tbody>\n{body}\n</tbody></table>")
