"""Reports on motions and studies for a reviewer: HTML files with instructions to reproduce them.

A report is self-contained and also well-formed XML. Apart from its date, which SOURCE_DATE_EPOCH sets, the same scene,
package and machine write the same bytes.
"""

import base64
import hashlib
import os
import time
import tomllib
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from generated.effects import EFFECTS, LAWS
from slipcircle.base.kinds import TextDict, TextPair
from slipcircle.base.progress import tracked
from slipcircle.base.text import number_text, output_unit
from slipcircle.core import Motion, Plan, Scene, Status, law_parts, plan
from slipcircle.layers import LayeredSection
from slipcircle.workbench.common.markup import Raw, document, escaped, html_table, html_terms, tag
from slipcircle.workbench.common.quantities import json_text, prefixed
from slipcircle.workbench.common.summary import key_results
from slipcircle.workbench.common.trace import toe_words
from slipcircle.workbench.files.loaded import stability_of, warnings_of
from slipcircle.workbench.files.numbers import uncertain_numbers
from slipcircle.workbench.outputs.info import facts
from slipcircle.workbench.outputs.json_records import record
from slipcircle.workbench.outputs.page import live
from slipcircle.workbench.outputs.pictures.files import picture
from slipcircle.workbench.outputs.pictures.plotstyle import width, work
from slipcircle.workbench.outputs.provenance import scene_inputs, uncertain_part
from slipcircle.workbench.outputs.studytables import study_tables
from slipcircle.workbench.outputs.tables import (
    ResultTable,
    beside,
    cell_text,
    in_unit,
    motion_groups,
    stability_columns,
    stretches_part,
)
from slipcircle.workbench.studies.statistics import distribution, value_text
from slipcircle.workbench.studies.study import Study

ASSUMED = (
    "The mass is rigid and turns about the centre of its slip circle, which continues beyond the toe.",
    "Friction takes the mean of the normal stress over the arc, which sums radial components as scalars: (2.1), (2.9).",
    "Resistance at its sides is neglected.",
)
TITLE = "Basic Geodynamics of Landslides: I. The Dynamic Slip Circle Method"
PAPER = f"Numbers in brackets are equations of the paper “{TITLE}”."

# --- pages -----------------------------------------------------------------------------------------------------------


def report_page(
    title: str, parts: Iterable[Raw], files: Iterable[tuple[str, bytes]], command: str, script: str = ""
) -> str:
    """Return a page of parts under its title, with instructions to reproduce it; ``script`` is its JavaScript, if any.

    The instructions are the command, digests of the scene files, and installed versions. ``files`` are the scene files
    as pairs of name and content.
    """
    files = [*files]
    title, facts_of_report = _heading(title, [content for _, content in files])
    sources = {f"scene file of {name}": f"sha256 {hashlib.sha256(content).hexdigest()}" for name, content in files}
    versions = [[key, Raw(f"<code>{escaped(value)}</code>")] for key, value in (sources | facts()).items()]
    body = [tag("h1", title), facts_of_report, *parts, tag("h2", "To repeat it")]
    body.append(tag("p", "This command, with the versions and files below, writes this report again:"))
    body += [tag("pre", command), _scrolling(versions)]
    body += [live.engine_element()] * bool(script)
    return document(title, body, live.style() + live.page_file("report.css"), script, compiles=bool(script))


def _heading(title: str, files: Iterable[bytes]) -> tuple[str, Raw]:
    """Return the title, and the date with the contents of the first [report] table in the scene files (their bytes)."""
    reports = (tomllib.loads(content.decode("utf-8-sig")).get("report") for content in files)
    try:
        now = float(os.environ.get("SOURCE_DATE_EPOCH") or time.time())
        date = time.strftime("%Y-%m-%d", time.gmtime(now))
    except (ValueError, OverflowError, OSError) as error:
        raise ValueError("SOURCE_DATE_EPOCH: must be a time in seconds since 1970") from error
    heading = {"title": title, "date": date} | (next(filter(None, reports), None) or {})
    return heading.pop("title"), Raw(f'<dl class="facts">{html_terms(heading.items())}</dl>')


def chapter(
    plan: Plan, warnings: Iterable[str], parts: Iterable[ResultTable | Raw], record: Any, unit: str, file: bytes
) -> Iterable[Raw]:
    """Yield note and warnings of a scene, its parts, its result as JSON, and its file.

    ``record`` is the result, ``unit`` describes its units, and ``file`` is the content of the scene file.
    """
    if plan.scene.note:
        yield tag("p", plan.scene.note)
    for warning in warnings:
        yield Raw(f'<p class="warning">Warning: {escaped(warning)}</p>')
    for part in parts:
        if isinstance(part, Raw):
            yield part
            continue
        if part.title:
            yield tag("h3", part.title)
        rows = [[cell if isinstance(cell, Raw) else cell_text(cell) for cell in row] for row in part.rows]
        yield _scrolling(rows, part.head)
        if part.note:
            yield tag("p", part.note)
    texts = {f"All numbers, as JSON{unit}": json_text(record), "The scene's file": file.decode("utf-8-sig")}
    for heading, text in texts.items():  # collapsed sections
        yield Raw(f"<details><summary>{escaped(heading)}</summary>{tag('pre', text)}</details>")


def _scrolling(rows: Iterable[Sequence[str]], head: Sequence[str] = ()) -> Raw:
    """Return an HTML table that scrolls on a narrow screen, also by keyboard, from rows of texts."""
    return Raw(f'<div class="scroll" tabindex="0">{html_table(rows, head)}</div>')


def figure(name: str, caption: str, drawing: bytes) -> Raw:
    """Return an SVG as a figure of the page, with its name for screen readers and its caption."""
    image = base64.b64encode(drawing).decode()
    return Raw(
        f'<figure><div class="picture"><img alt="{escaped(name)}" src="data:image/svg+xml;base64,{image}" /></div>'
        f"<figcaption>{escaped(caption)}</figcaption></figure>"
    )


def _number(value: float) -> str:
    """Return a number with six digits as text."""
    return number_text(float(value), 6)


def slope_parts(scene: Scene, with_tables: bool = True) -> Iterator[ResultTable | Raw]:
    """Yield the section with its circle, and tables of factors of safety and of the circle if they are known."""
    name, critical = scene.name, stability_of(scene)
    if critical is None:
        yield figure(f"Slope of {name}", "The section with its slip circle.", picture("slope", scene.arc, "svg"))
        return
    caption = "The section with its slip circle, the centre and the factors of safety."
    yield figure(f"Slope of {name}", caption, picture("search", (name, critical), "svg"))
    titles = ("Factors of safety", "Slip circle") if with_tables else ()
    for title, column in zip(titles, stability_columns(critical), strict=False):
        yield ResultTable([], [*column.items()], title)


def input_parts(plan: Plan, file: bytes) -> Iterable[ResultTable | Raw]:
    """Yield inputs with units and sources, effects, friction law, equation of motion, and assumptions.

    ``file`` is the content of the scene file.
    """
    inputs = []
    for path, *cells in scene_inputs(plan.scene, file.decode("utf-8-sig")):
        inputs.append([Raw(f'<code class="path">{escaped(path)}</code>'), *cells])
    yield ResultTable(["input", "value", "unit", "what it is", "source"], inputs, "Inputs")
    effects = []
    for name, effect in EFFECTS.items():
        use = "used" if name in plan.effects else "not included" if name in plan.left_out else "by the soils"
        effects.append([name, use, effect.help, effect.source])
    yield ResultTable(["effect", "", "what it does", "source"], effects)
    laws = [f"{name}: {LAWS[name].help}" if name in LAWS else name for name, _ in law_parts(plan.scene.friction)]
    yield ResultTable([], [["friction law", " times ".join(laws)]])
    yield tag("h3", "Equation of motion")
    yield tag("pre", str(plan.equation))
    yield tag("h3", "Assumptions")
    is_frozen = "rotation" not in plan.effects
    sentences = [*ASSUMED, *["The geometry is frozen: the weight does not turn with the mass."] * is_frozen]
    sentences += [f"Not included: {', '.join(plan.left_out) or 'nothing'}.", PAPER]
    yield Raw(f"<ul>{''.join(tag('li', sentence) for sentence in sentences)}</ul>")


# --- motions ---------------------------------------------------------------------------------------------------------


def report(motions: Sequence[Motion], files: Sequence[bytes], command: str) -> str:
    """Return a report on motions as HTML, with the contents of their scene files and the command that writes it."""
    names = [motion.plan.scene.name or f"scene {number}" for number, motion in enumerate(motions, 1)]
    body: list[Raw] = []
    if several := len(motions) > 1:
        links = [Raw(f'<a href="#scene-{number}">{escaped(name)}</a>') for number, name in enumerate(names, 1)]
        body.append(_scrolling(beside([*map(key_results, motions)]), ["", *links]))
    for number, (motion, name, file) in enumerate(zip(motions, names, files, strict=True), 1):
        about = [live.fragment(motion, f"slide-{number}"), *_of_motion(motion, file)]
        body.append(Raw(f'<section id="scene-{number}">'))
        body += [tag("h2", name)] * several
        body += chapter(motion.plan, (), about, record(motion), " in SI units and radians", file)
        body.append(Raw("</section>"))
    return report_page(", ".join(names), body, zip(names, files, strict=True), command, live.page_script())


def _of_motion(motion: Motion, file: bytes) -> Iterable[ResultTable | Raw]:
    """Yield the chapter of a motion below its slide: pictures, all results, inputs, accuracy and energy.

    ``file`` is the content of its scene file.
    """
    plan = motion.plan
    if plan.scene.uncertain:
        keys = ", ".join(u.key for u in uncertain_numbers(plan.scene).values())
        yield tag("p", f"One motion, at the median of {keys}; slipcircle sweep samples the uncertain inputs.")
    yield tag("h3", "Pictures")
    for what, caption in tracked(_captions(motion).items(), "pictures drawn"):
        yield figure(f"{what.capitalize()} of {plan.scene.name}", caption, picture(what, motion, "svg"))
    if stability_of(plan.scene):
        yield from slope_parts(plan.scene, with_tables=False)
    for title, rows in motion_groups(motion).items():
        yield ResultTable([], [*rows.items()], title or "Results")
    if layered := stretches_part(motion):
        yield layered._replace(title="Soils along the slip surface")
    yield from input_parts(plan, file)
    method = [
        ["requested relative error", _number(plan.accuracy)],
        ["relative error estimated, of peak, run-out and duration", _number(motion.error_estimate)],
        ["warnings", "; ".join(warnings_of(motion)) or "none"],
    ]
    yield ResultTable([], method, "Method and accuracy")
    yield _energy(motion)


def _captions(motion: Motion) -> TextDict:
    """Return the captions of the pictures of a motion, by kind of picture."""
    captions = {"section": "The section: the mass at the start, at its peak velocity and at the run-out."}
    if height := toe_words(motion):
        captions["section"] += f" Beyond the toe the method continues the circle; the toe ends {height}."
    if motion.moves:
        captions["histories"] = (
            "The motion over time. The mass tends to speed up where less strength is mobilised than required for "
            "equilibrium, elsewhere to slow down."
        )
        captions["phase plane"] = (
            f"Speed against displacement, and the energy: dissipation and kinetic energy make up the {work(motion)}."
        )
    if "shaking" in motion.plan.effects:
        captions["shaking"] = (
            "Ground acceleration over gravity; at the start the mass would move as soon as k_h passes k_y."
        )
    if isinstance(motion.plan.scene.arc, LayeredSection):
        captions["stress along the arc"] = (
            "Total normal stress along the slip surface at the start: each strip carries the weight straight above it."
        )
    return captions


def _energy(motion: Motion) -> ResultTable:
    """Return the energy balance with its residual as a table."""
    labels = {
        "kinetic_start": "kinetic energy at the start",
        "work": work(motion),
        "dissipation": "dissipation, integrated beside the motion",
        "kinetic_end": "kinetic energy at the end",
        "residual": "residual: start + work - dissipation - end",
    }
    of_width, per, of_one = width(motion)
    rows = []
    energies = []
    for name, words in labels.items():
        energies.append(float(getattr(motion.energy, name)))
        factor, unit = prefixed(energies[-1], "J")
        rows.append([words, f"{_number(of_one * factor * energies[-1])} {unit}{per}"])
    *others, residual = map(abs, energies)
    note = f"The residual is {_number(residual / (max(others) or 1.0))} of the largest of them."
    return ResultTable([], rows, f"Energy check, {of_width}", note)


# --- studies ---------------------------------------------------------------------------------------------------------

_CAPTION_OF_SUITE = (
    "Displacement of each record in its polarities; at several scales displacement by scale with the band from 16 to "
    "84 % of the records, and the probability that it exceeds a threshold: points are shares of the motions, curves "
    "lognormal fragilities, both with intervals of 95 %; last, velocity and displacement over time under the record "
    "whose displacement is the median."
)


def study_report(
    study: Study, file: bytes, command: str, tables: Iterable[ResultTable | str] | None = None, record: Any = None
) -> str:
    """Return a report on samples or on a suite of records as HTML. The seed is added to the command if it is missing.

    Parameters
    ----------
    study : Study
    file : bytes
        Content of the scene file.
    command : str
        Command that writes the report.
    tables, record : iterable of ResultTable and object, optional
        Tables, and the result for JSON; by default those of samples.
    """
    name = study.scene.name or "scene"
    if "--seed" not in command:
        command += f" --seed {study.design.seed}"
    contents = _of_study(study, study_tables(study) if tables is None else tables, file)
    chosen = plan(study.scene, study.design.accuracy)
    of_study = chapter(chosen, study.warnings, contents, record or study.to_dict(), "", file)
    title = "Uncertain slide" if study.design.records is None else "Shaken slope"
    return report_page(f"{title}: {name}", of_study, [(name, file)], command)


def _of_study(study: Study, tables: Iterable[ResultTable | str], file: bytes) -> Iterable[ResultTable | Raw]:
    """Yield the chapter of a study: picture, tables, inputs with their distributions, method and accuracy."""
    design = study.design
    ends = [f"{count} {Status(status).words}" for status, count in enumerate(study.counts) if count]
    method = [
        ["samples", f"{design.n}, {design.method}"],
        ["seed", str(study.seed)],
        ["samples of a block", str(study.size)],
        ["samples by how they ended", ", ".join(ends)],
        ["requested relative error of each solution", _number(design.accuracy)],
    ]
    if design.records is None:
        caption = "Exceedance probability of run-out and peak velocity"
        caption += "; below, sensitivity indices." if study.sensitivity else "."
        yield figure(f"Exceedance of {study.scene.name}", caption, picture("study", study, "svg"))
    else:
        yield figure(f"Suite of {study.scene.name}", _CAPTION_OF_SUITE, picture("suite", study, "svg"))
        yield Raw(f'<dl class="facts">{html_terms(_key_numbers(study))}</dl>')
        method = [["records", str(len(study.suite))], ["motions", str(study.displacement.size)], *method]
    yield from slope_parts(study.scene)
    yield from (part for part in tables if isinstance(part, ResultTable))
    yield from input_parts(plan(study.scene, design.accuracy), file)
    yield from uncertain_part(design)
    yield ResultTable([], method, "Method and accuracy")


def _key_numbers(study: Study) -> Iterator[TextPair]:
    """Yield label and value of yield coefficient, displacements at own scale, moving share and block factor."""
    at_scale = distribution(study.displacement, study.own_scale)
    yield "yield coefficient", number_text(study.yield_coefficient)
    for words, value in (("16 % of", at_scale.p16), ("median", at_scale.median), ("84 % of", at_scale.p84)):
        yield f"{words} displacements", f"{value_text(in_unit(value, 'm'))} {output_unit('m')[1]}"
    yield "that move", f"{100 * at_scale.moving:.3g} %"
    yield "displacement of the arc over that of a block", number_text(study.block_factor)
