"""Conversion of texts and tables to HTML that is also well-formed XML."""

import base64
import hashlib
import html
from collections.abc import Iterable, Sequence

from slipcircle.base.kinds import TextPair
from slipcircle.base.text import clean


class Raw(str):
    """Text that is already HTML, and not escaped again."""

    __slots__ = ()


def escaped(text: str) -> str:
    """Return a text with HTML escaped and without control characters other than tabs and line ends."""
    return html.escape(clean(text, "\t\n\r"))


def tag(name: str, text: str) -> Raw:
    """Return a text as an HTML element with this name."""
    return Raw(f"<{name}>{text if isinstance(text, Raw) else escaped(text)}</{name}>")


def html_table(rows: Iterable[Sequence[str]], head: Sequence[str] = ()) -> Raw:
    """Return an HTML table of texts, with its rows in groups of at most ten."""
    top = f"<thead><tr>{''.join(tag('th', c) for c in head)}</tr></thead>" if head else ""
    lines = [f"<tr>{''.join(tag('td', c) for c in row)}</tr>" for row in rows]
    groups = ["\n".join(["<tbody>", *lines[k : k + 10], "</tbody>"]) for k in range(0, len(lines), 10)]
    return Raw(f"<table>{top}{''.join(groups)}</table>")


def html_terms(facts: Iterable[TextPair]) -> Raw:
    """Return names and values as the items of an HTML description list."""
    return Raw("".join(tag("div", Raw(tag("dt", name) + tag("dd", value))) for name, value in facts))


def document(title: str, parts: Iterable[str], style: str, script: str = "", compiles: bool = False) -> str:
    """Return a self-contained page whose security policy allows only its own style, script and embedded images.

    If it ``compiles``, the policy also allows WebAssembly contained in the page, but no other text as a program.
    """
    program = f"//<![CDATA[\n{script}//]]>"  # valid XML for any script
    policy = {
        "default-src": "'none'",
        "img-src": "data:",
        "style-src": _digest(style),
        "script-src": " ".join([_digest(program), *(["'wasm-unsafe-eval'"] * compiles)]) if script else "'none'",
        "base-uri": "'none'",
        "form-action": "'none'",
    }
    rules = "; ".join(" ".join(rule) for rule in policy.items())
    lines = [
        "<!DOCTYPE html>",
        '<html lang="en">',
        "<head>",
        '<meta charset="utf-8" />',
        f'<meta http-equiv="Content-Security-Policy" content="{rules}" />',
        '<meta name="viewport" content="width=device-width, initial-scale=1" />',
        tag("title", title),
        f"<style>{style}</style>",
        "</head>",
        "<body>",
        *parts,
        *([f"<script>{program}</script>"] if script else []),
        "</body>",
        "</html>",
    ]
    return "\n".join(lines) + "\n"


def _digest(text: str) -> str:
    """Return the digest by which a security policy allows a style or a script."""
    digest = hashlib.sha256(text.encode()).digest()
    return f"'sha256-{base64.b64encode(digest).decode()}'"
