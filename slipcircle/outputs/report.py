"""A report for a reviewer: one HTML file that needs nothing else, and says how to repeat it.

It holds no date, so that the same scene, package and machine write the same bytes.
"""

import base64
import hashlib
import html
import json
import math
import re
from collections.abc import Callable, Iterable, Sequence
from typing import Any

from generated.effects import EFFECTS, LAWS
from slipcircle.info import facts
from slipcircle.motion import Motion
from slipcircle.outputs import pictures
from slipcircle.outputs.plotstyle import ending, scaled, work
from slipcircle.outputs.provenance import inputs
from slipcircle.outputs.tables import motion_record

_STYLE = """
body { font: 15px/1.5 sans-serif; color: #111; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1, h2, h3 { line-height: 1.2; } h2 { margin-top: 2.5rem; border-top: 2px solid #111; padding-top: 1rem; }
table { border-collapse: collapse; margin: 0.6rem 0; } caption { text-align: left; font-style: italic; }
th, td { text-align: left; vertical-align: top; padding: 0.15rem 1.2rem 0.15rem 0; border-bottom: 1px solid #ccc; }
pre { background: #f4f4f4; padding: 0.7rem; white-space: pre-wrap; overflow-wrap: anywhere; }
td { overflow-wrap: anywhere; } td:first-child { overflow-wrap: normal; } .path { white-space: nowrap; }
figure { margin: 1rem 0; break-inside: avoid; } img { max-width: 100%; height: auto; }
.warning { border-left: 5px solid #D55E00; padding-left: 0.8rem; }
@media print { body { margin: 0; max-width: none; font-size: 10pt; } section + section { break-before: page; } }
"""
# Nothing is fetched, whatever a scene's texts may hold.
_POLICY = "default-src 'none'; img-src data:; style-src 'unsafe-inline'"

# Key results: what they are called, where the record of `run --json` has them, the unit shown and SI units in it.
RESULTS: tuple[tuple[str, tuple[str, ...], str, float], ...] = (
    ("duration", ("duration",), "s", 1.0),
    ("run-out along the arc", ("run_out",), "m", 1.0),
    ("rotation at the end", ("end", "rotation"), "deg", math.pi / 180),
    ("velocity at the end", ("end", "velocity"), "m/s", 1.0),
    ("peak velocity", ("peak", "velocity"), "m/s", 1.0),
    ("time of the peak velocity", ("peak", "time"), "s", 1.0),
    ("displacement at the peak velocity", ("peak", "displacement"), "m", 1.0),
    ("mean normal stress at the peak velocity", ("peak", "normal_stress"), "Pa", 1.0),
    ("mean normal stress at the end", ("end", "normal_stress"), "Pa", 1.0),
    ("factor of safety at the start", ("factor_of_safety",), "", 1.0),
    ("limit friction at the start", ("limit_friction",), "", 1.0),
    ("yield coefficient k_y at the start", ("yield_coefficient",), "", 1.0),
)


class Raw(str):
    """Text that is HTML already."""

    __slots__ = ()


def report(motions: Sequence[Motion], files: Sequence[bytes | None] = (), command: str = "") -> str:
    """A report on motions as HTML.

    Parameters
    ----------
    motions : sequence of Motion
    files : sequence of bytes or None, optional
        For each of them its scene's file, where there is one.
    command : str, optional
        The command that writes this report.

    Raises
    ------
    ImportError
        Without matplotlib.
    """
    files = files or [None] * len(motions)
    names = [m.plan.scene.name or f"scene {k + 1}" for k, m in enumerate(motions)]
    title = f"Rotational slide: {', '.join(names)}"
    parts = [_tag("h1", title)]
    if len(motions) > 1:
        records = [motion_record(m) for m in motions]
        links = [Raw(f'<a href="#scene-{k + 1}">{_text(name)}</a>') for k, name in enumerate(names)]
        rows = [[label, *(_value(r, path, unit, per) for r in records)] for label, path, unit, per in RESULTS]
        parts.append(_table(rows, ["", *links]))
    for k, (motion, file) in enumerate(zip(motions, files, strict=True)):
        parts += [Raw(f'<section id="scene-{k + 1}">'), _tag("h2", names[k]), *_scene(motion, file), Raw("</section>")]
    parts += [_tag("h2", "To repeat it"), *_repeat(files, names, command)]
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8" />\n'
        f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}" />\n'
        '<meta name="viewport" content="width=device-width" />\n'
        f"<title>{_text(title)}</title>\n<style>{_STYLE}</style>\n</head>\n<body>\n"
        + "\n".join(parts)
        + "\n</body>\n</html>\n"
    )


def _scene(motion: Motion, file: bytes | None) -> Iterable[Raw]:
    plan, record = motion.plan, motion_record(motion)
    if plan.scene.note:
        yield _tag("p", plan.scene.note)
    for warning in motion.warnings:
        yield Raw(f'<p class="warning">Warning: {_text(warning)}</p>')
    yield _tag("h3", "Key results")
    moves = "yes" if motion.moves else "no"
    states = [["moves", moves], ["comes to rest", "yes" if motion.arrested else f"no ({ending(motion)})"]]
    yield _table([*states, *([label, _value(record, path, unit, per)] for label, path, unit, per in RESULTS)])
    yield _tag("h3", "Pictures")
    for name, caption, draw in pictures.of(motion):
        yield _figure(f"{name} of {plan.scene.name}", caption, draw)
    yield _tag("h3", "Inputs")
    text = None if file is None else file.decode("utf-8-sig")
    yield _table([[Raw(f'<code class="path">{_text(i.path)}</code>'), *i[1:]] for i in inputs(plan.scene, text)],
                 ["input", "value", "unit", "what it is", "source"])  # fmt: skip
    yield _tag("h3", "Effects")
    rows = [[name, "used", EFFECTS[name].help, f"({EFFECTS[name].equation})"] for name in plan.effects]
    rows += [[name, "left out", EFFECTS[name].help, f"({EFFECTS[name].equation})"] for name in plan.left_out]
    yield _table(rows, ["effect", "", "what it does", "equation of the paper"])
    yield _tag("h3", "Method and accuracy")
    law = "; ".join(f"{name}: {LAWS[name].help}" if name in LAWS else name for name in plan.law.split(" times "))
    yield _table([
        ["friction law", law],
        ["method", plan.method],
        ["specialised functions", ", ".join(plan.functions)],
        ["relative error asked for", _number(plan.accuracy)],
        ["relative error estimated, of peak, run-out and duration", _value(record, ("error_estimate",), "", 1.0)],
        ["warnings", "; ".join(motion.warnings) or "none"],
    ])  # fmt: skip
    yield _tag("h3", "Energy check")
    energy = record["energy"]
    parts = (
        ("kinetic energy at the start", "kinetic_start"), (work(motion), "work"),
        ("dissipation, by a quadrature of its own", "dissipation"), ("kinetic energy at the end", "kinetic_end"),
        ("residual: start + work - dissipation - end", "residual"),
    )  # fmt: skip
    yield _table([[label, _value(record, ("energy", key), "J", 1.0)] for label, key in parts])
    largest = max(abs(energy[k]) for k in ("kinetic_start", "work", "dissipation", "kinetic_end"))
    share = abs(energy["residual"]) / largest if largest else 0.0
    yield _tag("p", f"The residual is {_number(share)} of the largest of them.")
    yield _folded("All numbers, as JSON in SI units and radians", json.dumps(record, indent=2))
    if text is not None:
        yield _folded("The scene's file", text)


def _repeat(files: Sequence[bytes | None], names: Sequence[str], command: str) -> Iterable[Raw]:
    if command:
        yield _tag("p", "This command, with the versions and files below, writes this report again:")
        yield _pre(command)
    yield _table(
        [[f"scene file of {n}", Raw(f"<code>sha256 {hashlib.sha256(f).hexdigest()}</code>")]
         for n, f in zip(names, files, strict=True) if f is not None]
        + [[key, Raw(f"<code>{_text(value)}</code>")] for key, value in facts().items()]
    )  # fmt: skip


def _figure(name: str, caption: str, draw: Callable[[Any], Any]) -> Raw:
    image = base64.b64encode(draw("svg")).decode()
    return Raw(
        f'<figure><img alt="{_text(name)}" src="data:image/svg+xml;base64,{image}" />'
        f"<figcaption>{_text(caption)}</figcaption></figure>"
    )


def _value(record: Any, path: Sequence[str], unit: str, per: float) -> str:
    """A number of the record, as it is in the attribute and rounded in the text."""
    for key in path:
        record = record[key]
    if record is None:
        return "infinite"
    factor, unit = scaled(record / per, unit)
    shown = f"{_number(factor * record / per)} {unit}".rstrip()
    return Raw(f'<data value="{record!r}">{shown}</data>')


def _number(value: float) -> str:
    return f"{float(value):.6g}"


def _text(text: str) -> str:
    """Text in which nothing is HTML, and which XML may hold."""
    return html.escape(re.sub(r"[^\t\n\r -\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]", "\ufffd", text))


def _cell(cell: str) -> str:
    return cell if isinstance(cell, Raw) else _text(cell)


def _tag(name: str, text: str) -> Raw:
    return Raw(f"<{name}>{_text(text)}</{name}>")


def _pre(text: str) -> Raw:
    return Raw(f"<pre>{_text(text)}</pre>")


def _folded(summary: str, text: str) -> Raw:
    return Raw(f"<details><summary>{_text(summary)}</summary>{_pre(text)}</details>")


def _table(rows: Iterable[Sequence[str]], head: Sequence[str] = ()) -> Raw:
    top = "<thead><tr>" + "".join(f"<th>{_cell(c)}</th>" for c in head) + "</tr></thead>" if head else ""
    body = ("<tr>" + "".join(f"<td>{_cell(c)}</td>" for c in row) + "</tr>" for row in rows)
    return Raw(f"<table>{top}<tbody>\n" + "\n".join(body) + "\n</tbody></table>")
