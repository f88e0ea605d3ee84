"""A report for a reviewer: one HTML file that needs nothing else, and says how to repeat it.

It holds no date, so that the same scene, package and machine write the same bytes.
"""

import json
from collections.abc import Iterable, Sequence
from typing import Any

from generated.effects import EFFECTS, LAWS
from slipcircle.base.markup import Raw, escaped, table, tag
from slipcircle.motion.motion import Motion
from slipcircle.motion.plan import Plan
from slipcircle.motion.quantities import RESULTS, Quantity, record, results
from slipcircle.outputs import pictures
from slipcircle.outputs.htmlpage import data, figure, folded, number, page, repeat
from slipcircle.outputs.plotstyle import ending, work
from slipcircle.outputs.provenance import inputs
from slipcircle.outputs.tables import stability_column
from slipcircle.scene.friction import law_names

ASSUMED = (
    "The mass is rigid and turns about the centre of its slip circle, which goes on beyond the toe.",
    "Friction takes the mean of the normal stress over the arc, which sums radial components as scalars: (2.1), (2.9).",
    "Nothing holds it at its sides.",
)
TITLE = "Basic Geodynamics of Landslides: I. The Dynamic Slip Circle Method"
PAPER = f"Numbers in brackets are equations of the paper “{TITLE}”."


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
        links = [Raw(f'<a href="#scene-{k + 1}">{escaped(name)}</a>') for k, name in enumerate(names)]
        parts.append(table([[q.label, *(_value(q, m) for m in motions)] for q in RESULTS], ["", *links]))
    for k, (motion, file) in enumerate(zip(motions, files, strict=True)):
        parts += [Raw(f'<section id="scene-{k + 1}">'), tag("h2", names[k]), *_scene(motion, file), Raw("</section>")]
    parts += [tag("h2", "To repeat it"), *repeat(zip(names, files, strict=True), command)]
    return page(title, parts)


def _scene(motion: Motion, file: bytes | None) -> Iterable[Raw]:
    plan, found = motion.plan, record(motion)
    if plan.scene.note:
        yield tag("p", plan.scene.note)
    if plan.scene.uncertain:
        keys = ", ".join(u.key for u in plan.scene.uncertain.values())
        yield tag("p", f"One motion, at the median of {keys}; slipcircle sweep draws what is uncertain.")
    for warning in motion.warnings:
        yield Raw(f'<p class="warning">Warning: {escaped(warning)}</p>')
    yield tag("h3", "Key results")
    stability = stability_column(plan.scene.stability) if plan.scene.stability else {}
    yield table([*([q.label, _value(q, motion)] for q in results(motion)), *map(list, stability.items())])
    if not motion.arrested:
        yield tag("p", f"It does not come to rest: what is said of the end is said of the {ending(motion)}.")
    yield tag("h3", "Pictures")
    for name, caption, draw in pictures.of(motion):
        yield figure(f"{name} of {plan.scene.name}", caption, draw)
    text = None if file is None else file.decode("utf-8-sig")
    yield from given(plan, text)
    yield tag("h3", "Method and accuracy")
    yield table([
        ["method", plan.method],
        ["program of", ", ".join(plan.fragments)],
        ["relative error asked for", number(plan.accuracy)],
        ["relative error estimated, of peak, run-out and duration", data(motion.error_estimate)],
        ["warnings", "; ".join(motion.warnings) or "none"],
    ])  # fmt: skip
    yield tag("h3", "Energy check")
    energies = {n: float(x) for n, x in vars(motion.energy).items()} | {"residual": float(motion.energy.residual)}
    labels = {"kinetic_start": "kinetic energy at the start", "work": work(motion),
              "dissipation": "dissipation, integrated beside the motion", "kinetic_end": "kinetic energy at the end",
              "residual": "residual: start + work - dissipation - end"}  # fmt: skip
    yield table([[label, _value(Quantity(name, "J", label, name), motion.energy)] for name, label in labels.items()])
    largest = max(abs(x) for name, x in energies.items() if name != "residual")
    yield tag("p", f"The residual is {number(abs(energies['residual']) / (largest or 1.0))} of the largest of them.")
    yield folded("All numbers, as JSON in SI units and radians", json.dumps(found, indent=2, allow_nan=False))
    if text is not None:
        yield folded("The scene's file", text)


def given(plan: Plan, text: str | None) -> Iterable[Raw]:
    """What a scene was given: inputs with units and sources, effects used and left out, the friction law, what for."""
    yield tag("h3", "Inputs")
    yield table([[Raw(f'<code class="path">{escaped(i.path)}</code>'), *i[1:]] for i in inputs(plan.scene, text)],
                ["input", "value", "unit", "what it is", "source"])  # fmt: skip
    rows = [[n, "used" if n in plan.effects else "left out", e.help, e.equation] for n, e in EFFECTS.items()]
    yield table(rows, ["effect", "", "what it does", "equation of the paper"])
    laws = (
        ": ".join(filter(None, (name, LAWS[name].help if name in LAWS else "")))
        for name in law_names(plan.scene.friction)
    )
    yield table([["friction law", " times ".join(laws)]])
    yield tag("h3", "Assumptions")
    frozen = () if "rotation" in plan.effects else ("The geometry is frozen: the weight does not turn with the mass.",)
    left = f"Left out: {', '.join(plan.left_out) or 'nothing'}."
    yield Raw("<ul>" + "".join(tag("li", said) for said in (*ASSUMED, *frozen, left, PAPER)) + "</ul>")


def _value(quantity: Quantity, found: Any) -> Raw:
    """A number of the result: in full in the attribute, with six digits in the text."""
    value = quantity.read(found)
    return Raw("yes" if value else "no") if isinstance(value, bool) else data(float(value), *quantity.seen(value))
