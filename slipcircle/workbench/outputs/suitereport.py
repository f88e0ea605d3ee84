"""Reports on suites of records: picture and key numbers first, then the tables of the command, inputs and method."""

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from slipcircle.base.text import printed, shown
from slipcircle.core import plan
from slipcircle.workbench.common.markup import Raw, terms
from slipcircle.workbench.outputs.pictures.files import picture
from slipcircle.workbench.outputs.provenance import uncertain_part
from slipcircle.workbench.outputs.report import figure, input_parts, slope_parts, study_page
from slipcircle.workbench.outputs.tables import Part
from slipcircle.workbench.studies.statistics import distribution, value_text
from slipcircle.workbench.studies.study import Study

_CAPTION = (
    "Displacement of each record in its polarities; at several scales displacement by scale with the band from 16 to "
    "84 % of the records, and the probability that it exceeds a threshold: points are shares of the motions, curves "
    "lognormal fragilities, both with intervals of 95 %; last, velocity and displacement over time under the record "
    "whose displacement is the median."
)


def suite_report(study: Study, tables: Iterable[Part], record: Any, file: bytes, command: str) -> str:
    """Return a report on a suite of records as HTML.

    ``record`` is the result for JSON, and ``file`` is the content of the scene file.
    """
    return study_page("Shaken slope", study, _contents(study, [*tables], file), record, file, command)


def _contents(study: Study, tables: Sequence[Part], file: bytes) -> Iterator[Part | Raw]:
    """Yield picture, key numbers, tables, inputs and method."""
    yield figure(f"Suite of {study.scene.name}", _CAPTION, picture("suite", study, "svg"))
    yield Raw(f'<dl class="facts">{terms(_key_numbers(study))}</dl>')
    yield from slope_parts(study.scene)
    yield from tables
    yield from input_parts(plan(study.scene, study.design.accuracy), file)
    sampling = study.design
    yield from uncertain_part(sampling)
    method = [
        ["records", str(len(study.suite))],
        ["motions", str(study.displacement.size)],
        ["samples of uncertain numbers", str(sampling.n)],
        ["seed", str(sampling.seed)],
        ["requested relative error of each solution", f"{sampling.accuracy:.0e}"],
    ]
    yield Part([], method, "Method and accuracy")


def _key_numbers(study: Study) -> Iterator[tuple[str, str]]:
    """Yield label and value of yield coefficient, displacements at own scale, moving share and block factor."""
    found = distribution(study.displacement, study.own_scale)
    factor, unit = printed("m")
    yield "yield coefficient", shown(study.yield_coefficient)
    for words, value in (("16 % of", found.p16), ("median", found.median), ("84 % of", found.p84)):
        yield f"{words} displacements", f"{value_text(factor * value)} {unit}"
    yield "that move", f"{100 * found.moving:.3g} %"
    yield "displacement of the arc over that of a block", shown(study.block_factor)
