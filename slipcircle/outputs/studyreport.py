"""A report on uncertain scenes for a reviewer, like that on motions: one HTML file, which says how to repeat it."""

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from slipcircle.base.markup import Raw, tag
from slipcircle.motion.plan import Plan, plan
from slipcircle.motion.quantities import OUTCOMES, shown, words
from slipcircle.motion.states import Status
from slipcircle.outputs import pictures
from slipcircle.outputs.report import chapter, figure, given, number, page, path
from slipcircle.outputs.tables import Part
from slipcircle.studies import export
from slipcircle.studies.statistics import BIN_ERROR

if TYPE_CHECKING:
    from slipcircle.studies.study import Study


def parts(found: "Study") -> Iterator[Part]:
    """What is said of a study of samples, on the screen and in its report, in this order."""
    heads = [q.heading for q in OUTCOMES.values()]
    yield Part([], [["probability of moving", found.moving]], "Whether it moves", f"{found.n} samples; in brackets the "
               f"interval of {100 * found.confidence:g} % confidence from their number")  # fmt: skip
    yield Part(
        ["exceeded with probability", *heads],
        [[f"{1 - p:.2g}", *(found.quantile(n, p) for n in OUTCOMES)] for p in export.QUANTILES],
        "How far and how fast",
        "" if found.samples else f"from bins of a relative width of {BIN_ERROR:.1e}, by which values may be off",
    )  # fmt: skip
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
        yield Part(["output", "input", "first-order index", "total index"], shares, "Which unknown matters",
                   "shares of the variance: what each explains on its own, and with all that it does together with "
                   f"others; from {found.design.base} base points")  # fmt: skip
    yield Part(["samples", "probability of moving", "median reach (m)", "95 % quantile (m)"],
               [[str(c.n), c.moving, c.median, c.upper] for c in found.convergence], "Convergence")  # fmt: skip


def study_report(found: "Study", file: bytes | None = None, command: str = "") -> str:
    """A report on an ensemble of samples as HTML, as `report` is one; the command gets the seed where it has none.

    Raises
    ------
    ImportError
        Without matplotlib.
    """
    name, planned = found.scene.name or "scene", plan(found.scene, found.design.accuracy)
    if command and "--seed" not in command:
        command += f" --seed {found.seed}"
    told = chapter(planned, found.warnings, _told(found, planned, file), export.record(found), "", file)
    return page(f"Uncertain slide: {name}", told, [(name, file)], command)


def _told(found: "Study", planned: Plan, file: bytes | None) -> Iterable[Part | Raw]:
    study = found.design
    yield from parts(found)
    yield tag("h3", "Pictures")
    caption = "The probability that greatest displacement and peak velocity are at least so large"
    caption += "; below, which unknown matters." if found.sensitivity else "."
    yield figure(f"Exceedance of {found.scene.name}", caption, pictures.picture("study", found, "svg"))
    yield from given(planned, file)
    drawn = [(u.key, {k: v for k, v in u.record.items() if k != "key"}) for u in study.drawn.values()]
    yield Part(["input", "distribution, independent of the others"],
               [[path(key), ", ".join(f"{k} {v}" for k, v in of.items())] for key, of in drawn],
               "What is uncertain")  # fmt: skip
    ends = {words(Status(s).name): int(count) for s, count in enumerate(found.counts) if count}
    yield Part([], [
        ["samples", f"{study.n}, {study.method}"],
        ["seed", str(found.seed)],
        ["samples of a block", str(found.size)],
        ["samples by how they ended", ", ".join(f"{count} {ending}" for ending, count in ends.items())],
        ["relative error asked for, of each solution", number(study.accuracy)],
        ["relative error of quantiles from bins", "none: samples were kept" if found.samples else number(BIN_ERROR)],
    ], "Method and accuracy")  # fmt: skip
