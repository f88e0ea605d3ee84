"""The live page of a slide: a self-contained page with sliders for time and case, also for reports and notebooks.

Layout, colours and program are in the folder `page`; this module supplies numbers and drawings.
"""

import json
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from string import Template
from typing import Any

import numpy as np

from slipcircle.base.text import shown
from slipcircle.core import ANSWERED, Arc, Motion, Scene
from slipcircle.derivatives import parameter_value, with_parameters
from slipcircle.words import standing
from slipcircle.workbench.common.markup import Raw, document, escaped, tag, terms
from slipcircle.workbench.common.quantities import OUTCOMES, end_words, summary
from slipcircle.workbench.files.loaded import warnings_of
from slipcircle.workbench.outputs.interpolant import BYTES, TOLERANCE, Interpolant, interpolant
from slipcircle.workbench.outputs.livesection import Section, axes, common_magnification, frame_around, section
from slipcircle.workbench.outputs.plotstyle import AREAS, LINES, SCENERY, SOILS, ending, pace, quantity_words
from slipcircle.workbench.studies import motions as study_motions
from slipcircle.workbench.studies.ensemble import varied_number

MOST_CASES = 61
_SIZE = 270_000  # bytes of a page besides its program and style
_OF_CASE = 800  # bytes of a case besides its points
_LEAST_POINTS = 100  # of a motion
_SHORTEST = 4.0  # seconds in which a slide is played, as in `live.js`
_LONGEST = 10.0
_PAGE = Path(__file__).with_name("page")
_SHELL = """
body { margin: 0 auto; max-width: 68rem; padding: 1rem; background: var(--paper); color-scheme: light dark; }
h1 { margin: 0; font: 600 .95rem/1.4 system-ui, sans-serif; color: var(--soft); }
"""


def text(name: str) -> str:
    """A file of the folder `page`."""
    return (_PAGE / name).read_text("utf-8")


def style() -> str:
    """The style of `fragment`, in the colours of pictures; `live.css` has those for a dark screen."""
    colours = {f"band-{k}": band for k, (band, _) in enumerate(SOILS)}
    colours |= {"soil": SCENERY["soil"]["color"], "mass": AREAS["moving"]["facecolor"]}
    colours |= {"way": LINES["main"]["color"], "speed": LINES["other"]["color"]}
    by_name = "".join(f"--{name}: {colour}; " for name, colour in colours.items())
    return f":root {{ {by_name}}}\n{text('live.css')}"


def script() -> str:
    """The program of `fragment`; a page needs it once, at its end."""
    return text("live.js")


def page(motions: Sequence[Motion], varied: str = "", labels: Sequence[str] = (), first: int = 0) -> str:
    """One motion, or one scene's motions with a number varied, as a page of its own.

    Parameters
    ----------
    motions : sequence of Motion
        Single motions; those without a result are shown at their start.
    varied, labels
        Name of the varied number, and its values.
    first : int
        The motion that is shown first.
    """
    scene = motions[first].plan.scene
    title = " \N{MIDDLE DOT} ".join(filter(None, [scene.name or "slide", scene.note]))
    slide = fragment(motions, "slide", varied, labels, first)
    return document(scene.name or "slide", [tag("h1", title), slide], _SHELL + style(), script())


def framed(motion: Motion) -> Raw:
    """The page of a motion in an isolated frame of another page, such as a notebook."""
    attributes = 'sandbox="allow-scripts" width="100%" height="760" style="border: 0" title="the slide"'
    return Raw(f'<iframe {attributes} srcdoc="{escaped(page([motion]))}"></iframe>')


def fragment(motions: Sequence[Motion], name: str, varied: str = "", labels: Sequence[str] = (), first: int = 0) -> Raw:
    """The slide as a part of a page, which needs `style` and `script`; the name is its identifier there."""
    frame, magnification = frame_around(motions), common_magnification(motions)
    arcs = {id(motion.plan.scene.arc): motion for motion in motions}  # one of cases that differ in other numbers
    shapes = [section(motion, frame, magnification, f"{name}-{k}") for k, motion in enumerate(arcs.values())]
    size_of_drawings = sum(len(shape.drawing) for shape in shapes)
    room = (_SIZE - size_of_drawings) // BYTES
    histories = _interpolants(motions, room)
    cases = [*map(_case, motions, histories, labels or [""] * len(motions))]
    for case, motion in zip(cases, motions, strict=True):
        case["shape"] = [*arcs].index(id(motion.plan.scene.arc))
    data = _data(shapes, cases, histories, first)
    left = float(motions[first].plan.scene.arc.facing) > 0.0
    texts = {
        "name": name,
        "height": f"{frame.height:.1f}",
        "sections": "".join(_groups(shapes, cases[first]["shape"])),
        "axes": axes(frame, names_left=left),
        "parameter": escaped(varied),
        "first": str(first),
        "last": str(len(motions) - 1),
        "caption": escaped(" ".join(_caption(motions, histories, magnification))),
        "data": _as_script_data(data),
    }
    template = Template(text("live.html"))
    return Raw(template.substitute(texts | _first_texts(cases[first], data["duration"])))


def _interpolants(motions: Sequence[Motion], points: int) -> list[Interpolant]:
    """Interpolants of all motions, with at most so many points in all; points that one does not need go to the next."""
    points -= len(motions) * _OF_CASE // BYTES
    histories: list[Interpolant] = []
    for motion in motions:
        missing = len(motions) - len(histories)
        histories.append(interpolant(motion, max(points // missing, _LEAST_POINTS)))
        points -= histories[-1].times.size
    return histories


def _data(
    shapes: Sequence[Section], cases: Sequence[dict[str, Any]], histories: Sequence[Interpolant], first: int
) -> dict[str, Any]:
    """Data for the script."""
    duration = max(float(history.times[-1]) for history in histories)
    return {
        "duration": duration,
        "pace": pace(duration, min(max(duration, _SHORTEST), _LONGEST)),
        "first": first,
        "velocity": _range(history.velocity for history in histories),
        "displacement": _range(history.displacement for history in histories),
        "shapes": [{"centre": shape.centre, "turn": shape.turn} for shape in shapes],
        "cases": cases,
    }


def _first_texts(case: Mapping[str, Any], duration: float) -> dict[str, str]:
    """Texts for the first case at its end, shown until the script runs."""
    return {
        "headline": escaped(case["headline"]),
        "label": escaped(f"section to scale: {case['headline']}"),
        "time": shown(duration),
        "duration": repr(duration),
        "state": escaped(case["end"]),
        "facts": terms(case["facts"]),
        "warnings": "".join(tag("li", warning) for warning in case["warnings"]),
    }


def varied_page(scene: Scene, key: str, values: Sequence[float]) -> str:
    """The page of a scene's motions at values of one of its numbers; the value nearest to the scene's is shown first.

    Parameters
    ----------
    key : str
        As a scene file has it, ``friction.residual_deg``.
    values : sequence of float
        In the key's unit.

    Raises
    ------
    ValueError
        For a key without a value in the scene, for invalid values, and for too many values.
    """
    number = varied_number(scene, key, values)
    if len(values) > MOST_CASES:
        raise ValueError(f"--vary {key}: {len(values)} values; a page shows at most {MOST_CASES}")
    levels = np.asarray(values, dtype=np.float64)
    in_si = number.to_si(levels)
    for value in in_si.tolist():
        with_parameters(scene, {number.name: value})  # raises an error for an invalid value
    lanes = study_motions.motions(scene, {number.name: in_si})
    cases = [lanes[lane] for lane in range(levels.size)]
    present = float(number.from_si(parameter_value(scene, number.name)))
    nearest = int(np.argmin(np.abs(levels - present)))
    unit = f" ({number.unit})" if number.unit else ""
    return page(cases, quantity_words(number) + unit, [shown(value) for value in values], nearest)


def headline(motion: Motion) -> str:
    """The outcome of a motion in a few words."""
    if motion.status not in ANSWERED:
        return f"no result: {motion.reason}"
    if not motion.moves:
        return standing(motion)
    run_out, duration = (OUTCOMES[name].text(motion) for name in ("run_out", "duration"))
    return f"{run_out} in {duration}, {ending(motion)}"


def _case(motion: Motion, history: Interpolant, label: str) -> dict[str, Any]:
    """Data of one case."""
    answered = motion.status in ANSWERED
    columns, units = history.encoded()
    is_motion = answered and motion.moves
    end = ending(motion) if is_motion else end_words(motion).get("comes to rest", "no result")
    return {
        "label": label,
        "headline": headline(motion),
        "end": end,
        "facts": [*summary(motion).items()] if answered else [],
        "warnings": warnings_of(motion) if answered else [],
        "columns": columns,
        "units": units,
    }


def _groups(shapes: Sequence[Section], seen: int) -> Iterator[str]:
    """The drawings of all sections, of which one is visible."""
    for number, shape in enumerate(shapes):
        display = "inline" if number == seen else "none"
        yield f'<g class="shape" display="{display}">{shape.drawing}</g>\n'


def _range(columns: Iterable[Any]) -> tuple[float, float]:
    """Limits of an axis with all values and zero."""
    values = np.concatenate([[0.0], *columns])
    low, high = float(values.min()), float(values.max())
    return (low, high) if high > low else (0.0, 1.0)


def _caption(motions: Sequence[Motion], histories: Sequence[Interpolant], magnification: float) -> Iterator[str]:
    """Sentences on what the drawing shows and on the error of interpolation."""
    yield "To scale. Dashed: the mass at the start; dotted: the circle continued, as the method assumes."
    if isinstance(motions[0].plan.scene.arc, Arc):
        yield "The chord stands in place of the ground; coordinates are from the centre of the circle."
    if any(len(getattr(motion.plan.scene.arc, "surcharge", ())) for motion in motions):
        yield "Arrows: surcharges, where they are at the start."
    if magnification > 1.0:
        yield f"Displacements are drawn {shown(magnification)} times as large."
    if any(motion.moves and "rotation" not in motion.plan.effects for motion in motions):
        yield "Frozen geometry: the mass is drawn turned, its forces stay those of the start."
    if not any(motion.moves for motion in motions):
        return
    if len(motions) > 1:
        yield "Grey curves: the other cases."
    error = max(TOLERANCE, *(history.error for history in histories))
    digit = 10.0 ** math.floor(math.log10(error))
    yield f"Interpolation error: at most {digit * math.ceil(error / digit):.0e} of the greatest values."


def _as_script_data(data: Mapping[str, Any]) -> str:
    """JSON in which nothing is HTML or XML."""
    text = json.dumps(data, separators=(",", ":"), allow_nan=False)
    return text.replace("&", "\\u0026").replace("<", "\\u003c").replace(">", "\\u003e")
