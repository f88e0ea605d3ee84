"""A report for a reviewer: one HTML file that needs nothing else, and says how to repeat it.

It holds no date, so that the same scene, package and machine write the same bytes.
"""

import json
import math
from collections.abc import Iterable, Sequence
from typing import Any

from generated.effects import EFFECTS, LAWS
from slipcircle.motion.motion import Motion
from slipcircle.motion.plan import Plan
from slipcircle.outputs import pictures
from slipcircle.outputs.htmlpage import Raw, escaped, figure, folded, number, page, repeat, table, tag
from slipcircle.outputs.plotstyle import ending, scaled, work
from slipcircle.outputs.provenance import inputs
from slipcircle.outputs.tables import motion_record
from slipcircle.scene.friction import law_names

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
    parts = [tag("h1", title)]
    if len(motions) > 1:
        records = [motion_record(m) for m in motions]
        links = [Raw(f'<a href="#scene-{k + 1}">{escaped(name)}</a>') for k, name in enumerate(names)]
        rows = [[label, *(_value(r, path, unit, per) for r in records)] for label, path, unit, per in RESULTS]
        parts.append(table(rows, ["", *links]))
    for k, (motion, file) in enumerate(zip(motions, files, strict=True)):
        parts += [Raw(f'<section id="scene-{k + 1}">'), tag("h2", names[k]), *_scene(motion, file), Raw("</section>")]
    parts += [tag("h2", "To repeat it"), *repeat(zip(names, files, strict=True), command)]
    return page(title, parts)


def _scene(motion: Motion, file: bytes | None) -> Iterable[Raw]:
    plan, record = motion.plan, motion_record(motion)
    if plan.scene.note:
        yield tag("p", plan.scene.note)
    if plan.scene.uncertain:
        keys = ", ".join(u.key for u in plan.scene.uncertain.values())
        yield tag("p", f"One motion, at the median of {keys}; slipcircle sweep draws what is uncertain.")
    for warning in motion.warnings:
        yield Raw(f'<p class="warning">Warning: {escaped(warning)}</p>')
    yield tag("h3", "Key results")
    moves = "yes" if motion.moves else "no"
    states = [["moves", moves], ["comes to rest", "yes" if motion.arrested else f"no ({ending(motion)})"]]
    yield table([*states, *([label, _value(record, path, unit, per)] for label, path, unit, per in RESULTS)])
    yield tag("h3", "Pictures")
    for name, caption, draw in pictures.of(motion):
        yield figure(f"{name} of {plan.scene.name}", caption, draw)
    text = None if file is None else file.decode("utf-8-sig")
    yield from given(plan, text)
    yield tag("h3", "Method and accuracy")
    yield table([
        ["method", plan.method],
        ["specialised functions", ", ".join(plan.functions)],
        ["relative error asked for", number(plan.accuracy)],
        ["relative error estimated, of peak, run-out and duration", _value(record, ("error_estimate",), "", 1.0)],
        ["warnings", "; ".join(motion.warnings) or "none"],
    ])  # fmt: skip
    yield tag("h3", "Energy check")
    energy = record["energy"]
    parts = (
        ("kinetic energy at the start", "kinetic_start"), (work(motion), "work"),
        ("dissipation, by a quadrature of its own", "dissipation"), ("kinetic energy at the end", "kinetic_end"),
        ("residual: start + work - dissipation - end", "residual"),
    )  # fmt: skip
    yield table([[label, _value(record, ("energy", key), "J", 1.0)] for label, key in parts])
    largest = max(abs(energy[k]) for k in ("kinetic_start", "work", "dissipation", "kinetic_end"))
    share = abs(energy["residual"]) / largest if largest else 0.0
    yield tag("p", f"The residual is {number(share)} of the largest of them.")
    yield folded("All numbers, as JSON in SI units and radians", json.dumps(record, indent=2, allow_nan=False))
    if text is not None:
        yield folded("The scene's file", text)


def given(plan: Plan, text: str | None) -> Iterable[Raw]:
    """What a scene was given: inputs with units and sources, effects used and left out, the friction law."""
    yield tag("h3", "Inputs")
    yield table([[Raw(f'<code class="path">{escaped(i.path)}</code>'), *i[1:]] for i in inputs(plan.scene, text)],
                ["input", "value", "unit", "what it is", "source"])  # fmt: skip
    yield tag("h3", "Effects")
    rows = [[name, use, EFFECTS[name].help, f"({EFFECTS[name].equation})"]
            for use, names in (("used", plan.effects), ("left out", plan.left_out)) for name in names]  # fmt: skip
    yield table(rows, ["effect", "", "what it does", "equation of the paper"])
    laws = (
        ": ".join(filter(None, (name, LAWS[name].help if name in LAWS else "")))
        for name in law_names(plan.scene.friction)
    )
    yield table([["friction law", " times ".join(laws)]])


def _value(record: Any, path: Sequence[str], unit: str, per: float) -> str:
    """A number of the record, as it is in the attribute and rounded in the text."""
    for key in path:
        record = record[key]
    if record is None:
        return "infinite"
    factor, unit = scaled(record / per, unit)
    shown = f"{number(factor * record / per)} {unit}".rstrip()
    return Raw(f'<data value="{record!r}">{shown}</data>')
