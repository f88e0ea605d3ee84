"""Pages of reports: one HTML file that needs nothing else, also good XML. They hold no date."""

import base64
import hashlib
import math
from collections.abc import Callable, Iterable
from typing import Any

from slipcircle.base.markup import Raw, escaped, table, tag
from slipcircle.motion.quantities import shown
from slipcircle.outputs.info import facts

_STYLE = """
body { font: 15px/1.5 sans-serif; color: #111; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1, h2, h3 { line-height: 1.2; } h2 { margin-top: 2.5rem; border-top: 2px solid #111; padding-top: 1rem; }
table { border-collapse: collapse; margin: 0.6rem 0; } caption { text-align: left; font-style: italic; }
th, td { text-align: left; vertical-align: top; padding: 0.15rem 1.2rem 0.15rem 0; border-bottom: 1px solid #ccc; }
pre { background: #f4f4f4; padding: 0.7rem; white-space: pre-wrap; overflow-wrap: anywhere; }
td { overflow-wrap: break-word; } td code { overflow-wrap: anywhere; } .path { white-space: nowrap; }
figure { margin: 1rem 0; break-inside: avoid; } img { max-width: 100%; height: auto; }
.warning { border-left: 5px solid #D55E00; padding-left: 0.8rem; }
@media print { body { margin: 0; max-width: none; font-size: 10pt; } section + section { break-before: page; } }
"""
# Nothing is fetched, whatever a scene's texts may hold.
_POLICY = "default-src 'none'; img-src data:; style-src 'unsafe-inline'"


def page(title: str, parts: Iterable[str]) -> str:
    """A page of parts that are HTML."""
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8" />\n'
        f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}" />\n'
        '<meta name="viewport" content="width=device-width" />\n'
        f"<title>{escaped(title)}</title>\n<style>{_STYLE}</style>\n</head>\n<body>\n"
        + "\n".join(parts)
        + "\n</body>\n</html>\n"
    )


def repeat(files: Iterable[tuple[str, bytes | None]], command: str) -> Iterable[Raw]:
    """How to write the page again: the command, scenes' files by name, versions."""
    if command:
        yield tag("p", "This command, with the versions and files below, writes this report again:")
        yield pre(command)
    yield table(
        [[f"scene file of {n}", Raw(f"<code>sha256 {hashlib.sha256(f).hexdigest()}</code>")]
         for n, f in files if f is not None]
        + [[key, Raw(f"<code>{escaped(value)}</code>")] for key, value in facts().items()]
    )  # fmt: skip


def figure(name: str, caption: str, draw: Callable[[Any], Any]) -> Raw:
    """A picture in the page: its name for those who do not see it, its caption, and what makes bytes of a kind."""
    image = base64.b64encode(draw("svg")).decode()
    return Raw(
        f'<figure><img alt="{escaped(name)}" src="data:image/svg+xml;base64,{image}" />'
        f"<figcaption>{escaped(caption)}</figcaption></figure>"
    )


def number(value: float) -> str:
    """Six digits."""
    return shown(float(value), 6)


def data(value: float, seen: float | None = None, unit: str = "") -> Raw:
    """A number in full in the attribute, and as it is seen in the text."""
    text = f"{number(value if seen is None else seen)} {unit}".rstrip()
    return Raw(f'<data value="{value!r}">{text}</data>' if math.isfinite(value) else text)


def pre(text: str) -> Raw:
    """Text as it is."""
    return Raw(f"<pre>{escaped(text)}</pre>")


def folded(summary: str, text: str) -> Raw:
    """Text that opens when asked for."""
    return Raw(f"<details><summary>{escaped(summary)}</summary>{pre(text)}</details>")
