"""Reports on motions and studies for a reviewer: one HTML file, also good XML, that says how to repeat it.

It needs nothing else and holds no date, so that the same scene, package and machine write the same bytes.
"""

import base64
import hashlib
import json
import math
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import numpy as np

from generated.effects import EFFECTS, LAWS
from slipcircle.base.text import shown
from slipcircle.core import Motion, Plan, Status, law_names, plan
from slipcircle.workbench.common.markup import Raw, escaped, table, tag
from slipcircle.workbench.common.quantities import OUTCOMES, RESULTS, Quantity, plain, prefixed, record, results, words
from slipcircle.workbench.files.loaded import warnings_of
from slipcircle.workbench.files.numbers import uncertain_numbers
from slipcircle.workbench.outputs import pictures
from slipcircle.workbench.outputs.info import facts
from slipcircle.workbench.outputs.plotstyle import width, work
from slipcircle.workbench.outputs.provenance import inputs
from slipcircle.workbench.outputs.tables import Part, end_words, interval, motion_column
from slipcircle.workbench.outputs.trace import toe_words
from slipcircle.workbench.stability.stability import METHODS
from slipcircle.workbench.studies import export
from slipcircle.workbench.studies.statistics import BEYOND, BIN_ERROR, Estimate
from slipcircle.workbench.studies.study import Study

ASSUMED = (
    "The mass is rigid and turns about the centre of its slip circle, which goes on beyond the toe.",
    "Friction takes the mean of the normal stress over the arc, which sums radial components as scalars: (2.1), (2.9).",
    "Nothing holds it at its sides.",
)
TITLE = "Basic Geodynamics of Landslides: I. The Dynamic Slip Circle Method"
PAPER = f"Numbers in brackets are equations of the paper “{TITLE}”."
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

# --- pages -----------------------------------------------------------------------------------------------------------


def _page(title: str, parts: Iterable[Raw], files: Iterable[tuple[str, bytes | None]], command: str) -> str:
    """A page of parts, and how to write it again: the command, scenes' files by name, versions."""
    versions = [[f"scene file of {n}", f"sha256 {hashlib.sha256(f).hexdigest()}"] for n, f in files if f is not None]
    cells = [[key, Raw(f"<code>{escaped(value)}</code>")] for key, value in [*versions, *facts().items()]]
    said = (
        [tag("p", "This command, with the versions and files below, writes this report again:"), tag("pre", command)]
        if command
        else []
    )
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8" />\n'
        f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}" />\n'
        '<meta name="viewport" content="width=device-width" />\n'
        f"<title>{escaped(title)}</title>\n<style>{_STYLE}</style>\n</head>\n<body>\n"
        + "\n".join([tag("h1", title), *parts, tag("h2", "To repeat it"), *said, table(cells)])
        + "\n</body>\n</html>\n"
    )


def _chapter(
    plan: Plan, warnings: Iterable[str], parts: Iterable[Part | Raw], found: Any, unit: str, file: bytes | None
) -> Iterable[Raw]:
    """What is said of a scene: its note and warnings, the parts, the result as JSON and the scene's file."""
    if plan.scene.note:
        yield tag("p", plan.scene.note)
    for warning in warnings:
        yield Raw(f'<p class="warning">Warning: {escaped(warning)}</p>')
    for part in parts:
        if isinstance(part, Raw):
            yield part
            continue
        yield from [tag("h3", part.title)] if part.title else []
        yield table([[_estimate(c) if isinstance(c, Estimate) else c for c in row] for row in part.rows], part.head)
        yield from [tag("p", part.note)] if part.note else []
    texts = {f"All numbers, as JSON{unit}": json.dumps(plain(found), indent=2, allow_nan=False)}
    if file is not None:
        texts["The scene's file"] = file.decode("utf-8-sig")
    for summary, text in texts.items():  # open when asked for
        yield Raw(f"<details><summary>{escaped(summary)}</summary>{tag('pre', text)}</details>")


def _figure(name: str, caption: str, drawing: bytes) -> Raw:
    """A picture in the page, an SVG: its name for those who do not see it, and its caption."""
    image = base64.b64encode(drawing).decode()
    return Raw(
        f'<figure><img alt="{escaped(name)}" src="data:image/svg+xml;base64,{image}" />'
        f"<figcaption>{escaped(caption)}</figcaption></figure>"
    )


def _path(key: str) -> Raw:
    """Where a number stands in a scene."""
    return Raw(f'<code class="path">{escaped(key)}</code>')


def _number(value: float) -> str:
    """Six digits."""
    return shown(float(value), 6)


def _data(value: float, text: str) -> Raw:
    """A number in full in the attribute, and as it is seen in the text."""
    return Raw(f'<data value="{value!r}">{text}</data>' if math.isfinite(value) else text)


def _estimate(e: Estimate) -> Raw:
    value, _, ends = interval(e).partition(" ")
    return Raw(f"{_data(float(e.value), value)} {ends}".rstrip())


def _given(plan: Plan, file: bytes | None) -> Iterable[Part | Raw]:
    """What a scene was given: inputs with units and sources, effects used and left out, the friction law, what for."""
    found = inputs(plan.scene, None if file is None else file.decode("utf-8-sig"))
    yield Part(["input", "value", "unit", "what it is", "source"], [[_path(i.path), *i[1:]] for i in found], "Inputs")
    rows = [[n, "used" if n in plan.effects else "left out", e.help, e.equation] for n, e in EFFECTS.items()]
    yield Part(["effect", "", "what it does", "equation of the paper"], rows)
    laws = (f"{n}: {LAWS[n].help}" if n in LAWS else n for n in law_names(plan.scene.friction))
    yield Part([], [["friction law", " times ".join(laws)]])
    yield tag("h3", "Assumptions")
    frozen = () if "rotation" in plan.effects else ("The geometry is frozen: the weight does not turn with the mass.",)
    left = f"Left out: {', '.join(plan.left_out) or 'nothing'}."
    yield Raw("<ul>" + "".join(tag("li", said) for said in (*ASSUMED, *frozen, left, PAPER)) + "</ul>")


# --- motions ---------------------------------------------------------------------------------------------------------


def report(motions: Sequence[Motion], files: Sequence[bytes | None] = (), command: str = "") -> str:
    """A report on motions as HTML, of each its scene's file, where there is one, and the command that writes it."""
    files = files or [None] * len(motions)
    names = [m.plan.scene.name or f"scene {k + 1}" for k, m in enumerate(motions)]
    parts = []
    if len(motions) > 1:
        links = [Raw(f'<a href="#scene-{k + 1}">{escaped(name)}</a>') for k, name in enumerate(names)]
        ends = [end_words(m) for m in motions]
        rows = [
            [q.label, *(_value(q, m, end.get(q.label, "")) for m, end in zip(motions, ends, strict=True))]
            for q in RESULTS
        ]
        parts.append(table(rows, ["", *links]))
    for k, (m, file) in enumerate(zip(motions, files, strict=True)):
        told = _chapter(m.plan, warnings_of(m), _of_motion(m, file), record(m), " in SI units and radians", file)
        parts += [Raw(f'<section id="scene-{k + 1}">'), tag("h2", names[k]), *told, Raw("</section>")]
    return _page(f"Rotational slide: {', '.join(names)}", parts, zip(names, files, strict=True), command)


def _of_motion(motion: Motion, file: bytes | None) -> Iterable[Part | Raw]:
    plan = motion.plan
    if plan.scene.uncertain:
        keys = ", ".join(u.key for u in uncertain_numbers(plan.scene).values())
        yield tag("p", f"One motion, at the median of {keys}; slipcircle sweep draws what is uncertain.")
    known, told = {q.label: q for q in results(motion)}, motion_column(motion, verbose=True)
    ends = end_words(motion)
    rows = [
        [label, _value(known[label], motion, ends.get(label, "")) if label in known else text]
        for label, text in told.items()
    ]
    yield Part([], rows, "Key results")
    yield tag("h3", "Pictures")
    captions = {"section": "The section: the mass at the start, at its peak velocity and at the end."}
    if where := toe_words(motion):
        captions["section"] += f" Beyond the toe the method continues the circle; the toe ends {where}."
    if motion.moves:
        captions |= {
            "histories": "The motion over time. Where the mobilised friction is below the friction needed to stand "
            "still the mass tends to speed up, elsewhere to slow down.",
            "phase plane": "Speed against displacement, and the energy: what is dissipated and what is kinetic make "
            f"up the {work(motion)}.",
        }
    if "shaking" in plan.effects:
        captions["shaking"] = (
            "What shakes the scene, over gravity; at the start it would move as soon as k_h passes k_y."
        )
    for what, caption in captions.items():
        yield _figure(f"{what.capitalize()} of {plan.scene.name}", caption, pictures.picture(what, motion, "svg"))
    yield from _given(plan, file)
    error = motion.error_estimate
    yield Part(
        [],
        [
            ["program of", ", ".join(plan.fragments)],
            ["relative error asked for", _number(plan.accuracy)],
            ["relative error estimated, of peak, run-out and duration", _data(error, _number(error))],
            ["warnings", "; ".join(warnings_of(motion)) or "none"],
        ],
        "Method and accuracy",
    )
    labels = {
        "kinetic_start": "kinetic energy at the start",
        "work": work(motion),
        "dissipation": "dissipation, integrated beside the motion",
        "kinetic_end": "kinetic energy at the end",
        "residual": "residual: start + work - dissipation - end",
    }
    *energies, residual = (abs(float(getattr(motion.energy, name))) for name in labels)
    of_width, per = width(motion)
    rows = []
    for name, label in labels.items():
        energy = float(getattr(motion.energy, name))
        factor, unit = prefixed(energy, "J")
        rows.append([label, _data(energy, f"{_number(factor * energy)} {unit}{per}")])
    share = _number(residual / (max(energies) or 1.0))
    yield Part([], rows, f"Energy check, {of_width}", f"The residual is {share} of the largest of them.")


def _value(quantity: Quantity, found: Any, told: str = "") -> str:
    """A number of the result: in full in the attribute, with six digits in the text; else what is told of it."""
    value = quantity.read(found)
    if isinstance(value, bool) or np.ndim(value):
        return told or quantity.text(found)
    if told:
        return _data(float(value), escaped(told))
    seen, unit = quantity.seen(value)
    return _data(float(value), f"{_number(seen)} {unit}".rstrip())


# --- studies ---------------------------------------------------------------------------------------------------------


def parts(found: Study) -> Iterator[Part]:
    """What is said of a study of samples, on the screen and in its report, in this order."""
    heads = [q.heading for q in OUTCOMES.values()]
    failure = [[f"probability of F < 1, {METHODS[method][0]}", p] for method, p in found.failure.items()]
    invalid = found.design.n - found.n
    apart = f" of {found.design.n}, as {invalid} are no scene" if invalid else ""
    yield Part(
        [],
        [["probability of moving", found.moving], *failure],
        "Whether it moves",
        f"{found.n} samples{apart}; in brackets the interval of {100 * found.confidence:g} % confidence from their "
        "number",
    )
    yield Part(
        ["exceeded with probability", *heads],
        [[f"{1 - p:.2g}", *(found.quantile(n, p) for n in OUTCOMES)] for p in export.QUANTILES],
        "How far and how fast",
        "; ".join(_quantile_notes(found)),
    )
    rows = []
    for k, (what, estimated) in enumerate((("mean", found.mean), ("std", found.std))):
        rows.append([what, *map(estimated, OUTCOMES)])
        if found.linear:
            rows.append([f"linear {what}", *(shown(found.linear[n][k]) for n in OUTCOMES)])
    linear = f"no linear propagation: {found.no_linear}" if found.no_linear else "linear: derivatives at the means"
    yield Part(["", *heads], rows, "Mean and standard deviation", linear)
    if found.sensitivity:
        shares = [
            [words(output), of.key, first, total]
            for output, both in found.sensitivity.items()
            for of, first, total in zip(found.design.inputs.values(), *both, strict=True)
        ]
        yield Part(
            ["output", "input", "first-order index", "total index"],
            shares,
            "Which unknown matters",
            "shares of the variance: what each explains on its own, and with all that it does together with "
            f"others; from {found.design.base} base points",
        )
    yield Part(
        ["samples", "probability of moving", "median reach (m)", "95 % quantile (m)"],
        [[str(c.n), c.moving, c.median, c.upper] for c in found.convergence],
        "Convergence",
    )


def _quantile_notes(found: Study) -> Iterator[str]:
    if found.without_result:
        yield f"{BEYOND}: among the {found.without_result} samples that slide without a result, so beyond any value"
    if not found.samples:
        yield f"from bins of a relative width of {BIN_ERROR:.1e}, by which values may be off"


def study_report(found: Study, file: bytes | None = None, command: str = "") -> str:
    """A report on an ensemble of samples as HTML, as `report` is one; the command gets the seed where it has none."""
    name, planned = found.scene.name or "scene", plan(found.scene, found.design.accuracy)
    if command and "--seed" not in command:
        command += f" --seed {found.seed}"
    told = _chapter(planned, found.warnings, _of_study(found, planned, file), export.record(found), "", file)
    return _page(f"Uncertain slide: {name}", told, [(name, file)], command)


def _of_study(found: Study, planned: Plan, file: bytes | None) -> Iterable[Part | Raw]:
    study = found.design
    yield from parts(found)
    yield tag("h3", "Pictures")
    caption = "The probability that greatest displacement and peak velocity are at least so large"
    caption += "; below, which unknown matters." if found.sensitivity else "."
    yield _figure(f"Exceedance of {found.scene.name}", caption, pictures.picture("study", found, "svg"))
    yield from _given(planned, file)
    drawn = [(u.key, {k: v for k, v in u.record.items() if k != "key"}) for u in study.drawn.values()]
    yield Part(
        ["input", "distribution, independent of the others"],
        [[_path(key), ", ".join(f"{k} {v}" for k, v in of.items())] for key, of in drawn],
        "What is uncertain",
    )
    ends = {Status(s).words: int(count) for s, count in enumerate(found.counts) if count}
    yield Part(
        [],
        [
            ["samples", f"{study.n}, {study.method}"],
            ["seed", str(found.seed)],
            ["samples of a block", str(found.size)],
            ["samples by how they ended", ", ".join(f"{count} {ending}" for ending, count in ends.items())],
            ["relative error asked for, of each solution", _number(study.accuracy)],
            [
                "relative error of quantiles from bins",
                "none: samples were kept" if found.samples else _number(BIN_ERROR),
            ],
        ],
        "Method and accuracy",
    )
