"""Live page of a slide: a self-contained HTML page that solves its scene again when its sliders are moved.

Layout, colours and programs are in the folder `page`, the integrator is `generated/flow.wasm.txt`. This module supplies
numbers, drawings, and the solved motion, which a browser without WebAssembly plays.
"""

import base64
import gzip
import json
from collections.abc import Iterator, Sequence
from importlib import resources
from string import Template

import numpy as np

from slipcircle.base.kinds import ValueDict, Values
from slipcircle.base.text import drawn_unit, number_text, output_unit
from slipcircle.core import ANSWERED, Arc, Motion, Scene
from slipcircle.derivatives import with_parameters
from slipcircle.messages import standing
from slipcircle.workbench.common.markup import Raw, document, escaped, html_terms, tag
from slipcircle.workbench.common.quantities import OBSERVABLE
from slipcircle.workbench.common.summary import end_words, key_results
from slipcircle.workbench.files.loaded import warnings_of
from slipcircle.workbench.outputs.page.inputs import Slider
from slipcircle.workbench.outputs.page.model import (
    MOST_COEFFICIENTS,
    default_sliders,
    interpolates,
    page_model,
    unsolvable,
)
from slipcircle.workbench.outputs.page.section import DrawnSection, drawn_section, frame_around, section_ticks
from slipcircle.workbench.outputs.pictures.plotstyle import AREAS, LINES, SCENERY, SOILS, ending, outcome_words, pace
from slipcircle.workbench.outputs.pictures.sectionplot import magnified
from slipcircle.workbench.studies.ensemble import varied_number

_SAMPLES = 241  # number of samples of the solved motion
_DIGITS = 8
INTERPOLATED = 1e-6  # allowed error of inputs for a requested slider; the page shows the error
_SHORTEST = 4.0  # seconds of the animation, as in `live.js`
_LONGEST = 10.0
_PAGE = resources.files("slipcircle.workbench.outputs") / "page"
_SHELL = """
body { margin: 0 auto; max-width: 68rem; padding: 1rem; background: var(--paper); color-scheme: light dark; }
h1 { margin: 0; font: 600 .95rem/1.4 system-ui, sans-serif; color: var(--soft); }
"""


def page_file(name: str) -> str:
    """Return the text of a file in the folder `page`."""
    return (_PAGE / name).read_text("utf-8")


def style() -> str:
    """Return the CSS of `fragment` in the colours of pictures; `live.css` has the colours for a dark screen."""
    colours = {f"band-{k}": band for k, (band, _) in enumerate(SOILS)}
    colours |= {"soil": SCENERY["soil"]["color"], "mass": AREAS["moving"]["facecolor"]}
    colours |= {"way": LINES["main"]["color"], "speed": LINES["other"]["color"]}
    by_name = "".join(f"--{name}: {colour}; " for name, colour in colours.items())
    return f":root {{ {by_name}}}\n{page_file('live.css')}"


def page_script() -> str:
    """Return the JavaScript of `fragment` without comments. A page needs it once, at its end."""
    lines = [line.strip() for name in ("engine.js", "live.js") for line in page_file(name).splitlines()]
    return "\n".join(line for line in lines if line and not line.startswith("//"))


def engine_element() -> Raw:
    """Return the compressed integrator for a browser as an HTML element. A page needs it once."""
    _, packed = (resources.files("generated") / "flow.wasm.txt").read_text("utf-8").split()
    return Raw(f'<script type="text/plain" id="slide-engine">{packed}</script>')


def page(motion: Motion, sliders: Sequence[Slider] | None = None) -> str:
    """Return a single motion as a complete HTML page, which solves its scene for other values of the sliders.

    Parameters
    ----------
    motion : Motion
        A motion without a result is shown at its start.
    sliders : sequence of Slider, optional
        By default for the numbers of strength and load, and for the shape of an arc.
    """
    scene = motion.plan.scene
    title = " \N{MIDDLE DOT} ".join(filter(None, [scene.name or "slide", scene.note]))
    parts = [tag("h1", title), fragment(motion, "slide", sliders), engine_element()]
    return document(scene.name or "slide", parts, _SHELL + style(), page_script(), compiles=True)


def framed(motion: Motion) -> Raw:
    """Return the page of a motion in an isolated frame of another page, such as a notebook."""
    size = 'width="100%" height="1560"'  # height of the whole page where charts are in pairs
    attributes = f'sandbox="allow-scripts allow-downloads" {size} style="border: 0" title="the slide"'
    return Raw(f'<iframe {attributes} srcdoc="{escaped(page(motion))}"></iframe>')


def fragment(motion: Motion, name: str, sliders: Sequence[Slider] | None = None) -> Raw:
    """Return the slide as part of a page with `style`, `engine_element` and `page_script`; ``name`` identifies it."""
    scene = motion.plan.scene
    magnification = magnified(motion)
    frame = frame_around(motion, magnification)
    drawn = drawn_section(motion, frame, magnification, name)
    why_not = unsolvable(motion)
    first = _first(motion)
    texts = {
        "name": name,
        "height": f"{frame.height:.1f}",
        "section": drawn.drawing,
        "axes": section_ticks(frame, names_left=float(scene.arc.facing) > 0.0),
        "headline": escaped(first["headline"]),
        "label": escaped(f"section to scale: {first['headline']}"),
        "time": number_text(_duration(motion)),
        "duration": repr(_duration(motion)),
        "state": escaped(first["end"]),
        "facts": html_terms(first["facts"]),
        "warnings": "".join(tag("li", warning) for warning in first["warnings"]),
        "length": output_unit("m")[1],
        "velocity": output_unit("m/s")[1],
        "caption": escaped(" ".join(_caption(motion, magnification, why_not))),
        "data": _as_script_data(_data(motion, drawn, sliders, why_not) | {"first": first}),
    }
    return Raw(Template(page_file("live.html")).substitute(texts))


def _data(motion: Motion, drawn: DrawnSection, sliders: Sequence[Slider] | None, why_not: str) -> ValueDict:
    """Return the data of the script: the solved motion, the observations, and the inputs of the engine.

    ``sliders`` is None for the default ones; ``why_not`` is the reason why the page cannot solve the scene, or empty.
    """
    scene = motion.plan.scene
    duration = _duration(motion)
    length, _ = output_unit("m")
    observed = {name: np.multiply(output_unit(OBSERVABLE[name].unit)[0], seen) for name, seen in scene.observed.items()}
    data: ValueDict = {
        "units": {unit: drawn_unit(unit)[::-1] for unit in ("m", "m/s", "Pa")},
        "shape": {"centre": drawn.centre, "turn": drawn.turn / length},
        "stored": _stored(motion),
        "pace": pace(duration, min(max(duration, _SHORTEST), _LONGEST)),
        "observed": {name: seen.tolist() for name, seen in observed.items()},
        "sliders": [],
        "model": None,
        "range": [float(rotation) for rotation in scene.arc.rotation_range],
    }
    if not why_not:
        chosen = default_sliders(scene) if sliders is None else sliders
        model = page_model(scene, chosen)
        data |= {"sliders": [one.described(scene) for one in chosen], "input_error": model.pop("input_error")}
        data["model"] = _packed(model)
    return data


def slider(scene: Scene, key: str, low: float, high: float) -> list[Slider]:
    """Return the sliders of a scene's page, first a slider for a key, from ``low`` to ``high`` in the key's unit.

    The default sliders follow if the page can have them as well.

    Raises
    ------
    ValueError
        If the scene has no value for the key or none between the two values, if these are not valid, or if the inputs
        cannot be interpolated.
    """
    number = varied_number(scene, key, [low, high])
    asked = f"--vary {key}={low:g}:{high:g}"
    if not low < high:
        raise ValueError(f"{asked}: the second value must be greater than the first")
    varied = Slider(number, low, high)
    for value in varied.ends.tolist():
        with_parameters(scene, {number.name: value})  # raises an error for an invalid value
    if not interpolates(scene, [varied], INTERPOLATED):
        raise ValueError(
            f"--vary {key}: the initial state is not smooth enough between these values to be interpolated "
            f"to {INTERPOLATED:.0e}; narrow the range"
        )
    value = varied.present(scene)
    if not low <= value <= high:
        raise ValueError(f"{asked}: must contain the value of the scene, {value:.6g}")
    others = [other for other in default_sliders(scene) if other.number.name != number.name]
    if interpolates(scene, [varied, *others], INTERPOLATED, MOST_COEFFICIENTS):
        return [varied, *others]
    return [varied]


def headline(motion: Motion) -> str:
    """Return the outcome of a motion in a few words."""
    if motion.status not in ANSWERED:
        return f"no result: {motion.reason}"
    if not motion.moves:
        return standing(motion)
    return outcome_words(motion, 4)


def _is_motion(motion: Motion) -> bool:
    """Return whether a motion has a result and moves."""
    return motion.status in ANSWERED and bool(motion.moves)


def _duration(motion: Motion) -> float:
    """Return the duration of the animation in s: settling time or duration, the shorter one; 0 without motion."""
    if _is_motion(motion):
        return float(np.fmin(motion.duration, motion.settling_time))
    return 0.0


def _stored(motion: Motion) -> ValueDict:
    """Return times in s, displacements and velocities of the solved motion, in units of output, as JSON data.

    The times are equidistant; numbers are rounded for the screen.
    """
    times = np.linspace(0.0, _duration(motion), _SAMPLES if _is_motion(motion) else 1)
    columns = {"t": times, "s": np.zeros(times.size), "v": np.zeros(times.size)}
    if _is_motion(motion):
        states = motion.at(times)
        columns |= {"s": output_unit("m")[0] * states.displacement, "v": output_unit("m/s")[0] * states.velocity}
    rounded = {name: [float(f"{x:.{_DIGITS}g}") for x in column.tolist()] for name, column in columns.items()}
    left = _is_motion(motion) and motion.range_end
    return rounded | {"duration": _duration(motion), "left": left and float(left.time)}


def _first(motion: Motion) -> ValueDict:
    """Return headline, end, key results and warnings of the solved motion."""
    answered = motion.status in ANSWERED
    end = ending(motion) if _is_motion(motion) else end_words(motion).get("comes to rest", "no result")
    return {
        "headline": headline(motion),
        "end": end,
        "facts": [*key_results(motion).items()] if answered else [],
        "warnings": warnings_of(motion) if answered else [],
    }


def _caption(motion: Motion, magnification: float, why_not: str) -> Iterator[str]:
    """Yield the sentences of the caption.

    Displacements are drawn ``magnification`` times as large; ``why_not`` is the result of `unsolvable`.
    """
    arc = motion.plan.scene.arc
    yield "To scale. Dashed: the mass at the start; dotted: the circle continued, as the method assumes."
    if isinstance(arc, Arc):
        yield "The chord replaces the ground, which follows the circle beyond the toe; coordinates are from its centre."
    if len(getattr(arc, "surcharge", ())):
        yield "Arrows: surcharges, where they are at the start."
    if magnification > 1.0:
        yield f"Displacements are drawn {number_text(magnification)} times as large."
    if motion.moves and "rotation" not in motion.plan.effects:
        yield "Frozen geometry: the mass is drawn turned, its forces remain as at the start."
    if why_not:
        yield f"The page plays the motion as it was solved, and does not solve: {why_not}."
    else:
        yield "Grey, dashed: the scene as given. This page itself solves the scene with the values of the sliders."


def _compact(data: Values) -> str:
    """Return data as JSON without blanks."""
    return json.dumps(data, separators=(",", ":"), allow_nan=False)


def _packed(data: Values) -> str:
    """Return data as compressed JSON in base64, which the script unpacks."""
    return base64.b64encode(gzip.compress(_compact(data).encode(), mtime=0)).decode()


def _as_script_data(data: Values) -> str:
    """Return data as JSON with escaped ``&``, ``<`` and ``>``, which is safe inside HTML and XML."""
    text = _compact(data)
    for character in "&<>":
        text = text.replace(character, f"\\u{ord(character):04x}")
    return text
