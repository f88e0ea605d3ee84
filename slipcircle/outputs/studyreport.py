"""A report on uncertain scenes for a reviewer, like that on motions: one HTML file, which says how to repeat it."""

import json
from collections.abc import Iterable, Mapping
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from slipcircle.base.markup import Raw, escaped, table, tag
from slipcircle.motion.motion import Status
from slipcircle.motion.plan import plan
from slipcircle.motion.quantities import OUTCOMES, plain, shown, words
from slipcircle.outputs import pictures
from slipcircle.outputs.htmlpage import figure, folded, number, page, repeat
from slipcircle.outputs.report import given
from slipcircle.outputs.studyplots import DRAWN
from slipcircle.studies import written
from slipcircle.studies.statistics import BIN_ERROR, Estimate

if TYPE_CHECKING:
    from slipcircle.studies.study import Study

QUANTILES = (0.05, 0.5, 0.95, 0.99)


def study_report(found: "Study", file: bytes | None = None, command: str = "") -> str:
    """A report on an ensemble as HTML.

    Parameters
    ----------
    found : Study
        Of samples, not a grid.
    file : bytes, optional
        Its scene's file, where there is one.
    command : str, optional
        The command that writes this report; the seed is added where it has none.

    Raises
    ------
    ImportError
        Without matplotlib.
    """
    name = found.scene.name or "scene"
    title = f"Uncertain slide: {name}"
    if command and "--seed" not in command:
        command += f" --seed {found.seed}"
    return page(title, [tag("h1", title), *_study(found, file), tag("h2", "To repeat it"),
                        *repeat([(name, file)], command)])  # fmt: skip


def _study(found: "Study", file: bytes | None) -> Iterable[Raw]:
    study, inputs = found.design, [u.key for u in found.design.inputs.values()]
    if found.scene.note:
        yield tag("p", found.scene.note)
    for warning in found.warnings:
        yield Raw(f'<p class="warning">Warning: {escaped(warning)}</p>')
    yield tag("h3", "Key results")
    percent = f"{100 * found.confidence:g} %"
    yield tag("p", f"{found.n} samples; in brackets the interval of {percent} confidence that comes from their number.")
    heads = [f"{q.label} ({q.unit})" for q in OUTCOMES.values()]
    yield table([["probability of moving", _shown(found.moving)]])
    yield table([[f"exceeded with probability {1 - p:.2g}", *(_shown(found.quantile(n, p)) for n in OUTCOMES)]
                 for p in QUANTILES], ["", *heads])  # fmt: skip
    yield tag("h3", "Pictures")
    caption = "The probability that greatest displacement and peak velocity are at least so large"
    caption += "; below, which unknown matters." if found.sensitivity else "."
    yield figure(f"Exceedance of {found.scene.name}", caption, partial(pictures.study, found))
    if found.sensitivity:
        yield tag("h3", "Which unknown matters")
        yield tag("p", "Shares of the variance: what each explains on its own, and with all that it does together with "
                       f"others; from {study.base} base points.")  # fmt: skip
        for output in DRAWN:
            rows = [[key, *map(_shown, both)] for key, *both in zip(inputs, *found.sensitivity[output], strict=True)]
            yield table(rows, [OUTCOMES[output].label, "first-order index", "total index"])
    text = None if file is None else file.decode("utf-8-sig")
    yield from given(plan(found.scene, study.accuracy), text)
    yield tag("h3", "What is uncertain")
    yield table([[Raw(f'<code class="path">{escaped(u.key)}</code>'), _said(u.record)] for u in study.drawn.values()],
                ["input", "distribution, independent of the others"])  # fmt: skip
    yield tag("h3", "Method and accuracy")
    ends = {words(Status(s).name): int(count) for s, count in enumerate(found.counts) if count}
    yield table([
        ["samples", f"{study.n}, {study.method}"],
        ["seed", str(found.seed)],
        ["samples of a block", str(found.size)],
        ["samples by how they ended", ", ".join(f"{count} {ending}" for ending, count in ends.items())],
        ["relative error asked for, of each solution", number(study.accuracy)],
        ["relative error of quantiles from bins", "none: samples were kept" if found.samples else number(BIN_ERROR)],
    ])  # fmt: skip
    yield folded("All numbers, as JSON", json.dumps(plain(written.record(found)), indent=2, allow_nan=False))
    if text is not None:
        yield folded("The scene's file", text)


def _shown(e: Estimate) -> Raw:
    """A value in full in the attribute, rounded in the text, with its interval."""
    if np.isnan(e.value):
        return Raw("-")
    low, high = ("?" if np.isnan(x) else shown(x) for x in (e.low, e.high))
    return Raw(f'<data value="{float(e.value)!r}">{shown(e.value)}</data> [{low}, {high}]')


def _said(record: Mapping[str, object]) -> str:
    """A distribution in words."""
    return ", ".join(f"{k} {v}" for k, v in record.items() if k != "key")
