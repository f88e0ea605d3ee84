"""The slide that one can drag: a page that solves its scene in the browser as `solve` does, and needs nothing else."""

import json
import math
import re
import shutil
import subprocess
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from slipcircle import Motion, Scene, Section, Status, load, solve
from slipcircle.base.text import PRINTED
from slipcircle.derivatives import parameter_value, with_parameters
from slipcircle.workbench.common.units import SYSTEMS
from slipcircle.workbench.files.numbers import number_in
from slipcircle.workbench.files.shipped import shipped
from slipcircle.workbench.outputs.page import live
from slipcircle.workbench.outputs.page import section as livesection
from slipcircle.workbench.outputs.page.inputs import Slider
from slipcircle.workbench.outputs.page.model import default_sliders, unsolvable
from slipcircle.workbench.outputs.pictures.shapes import mass_of
from tests.support.layered import TURNING, profile

PROGRAMS = live.page_script()
SOLVED = ("vaiont", "vaiont-softening", "real-slope", "layered-slope", "vaiont-shaken", "weak-toe")
POSITIONS = 40
CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), "")
needs_browser = pytest.mark.skipif(not CHROMIUM, reason="needs a browser: Debian's package chromium")


@cache
def motion(name: str) -> Motion:
    return solve(load(name))


@cache
def sliders_of(name: str) -> list[Slider]:
    """Return the sliders of a scene's page, which of a layered scene take a second."""
    return default_sliders(load(name))


@cache
def page(name: str) -> str:
    return live.page(motion(name), sliders_of(name))


def tree(page: str) -> Any:
    """Return the page as XML, which it must be as well."""
    return ElementTree.fromstring(page.partition("\n")[2])


def data(page: str) -> Any:
    (text,) = (e.text for e in tree(page).iter("script") if e.get("type") == "application/json")
    return json.loads(text)


# --- in a browser ----------------------------------------------------------------------------------------------------


def browsed(page: str, folder: Path, width: int, state: str = "", until: str = 'class="slide solves"') -> str:
    """Return the text of a page's document in a browser window of some width, as soon as it is not empty.

    The engine is compiled beside the page's own clock, which may be over before.
    """
    path = folder / "page.html"
    path.write_text(page, "utf-8")
    quiet = "--no-sandbox --disable-gpu --disable-background-networking --disable-component-update --disable-sync"
    size, profile = f"--window-size={width},900", f"--user-data-dir={folder / 'profile'}"
    command = [CHROMIUM, "--headless", *quiet.split(), "--no-first-run", size, profile, "--dump-dom"]
    waits = "--virtual-time-budget=20000"
    document = ""
    for _ in range(5):
        asked = [*command, waits, f"{path.as_uri()}#{state}"]
        document = subprocess.run(asked, capture_output=True, text=True, check=True, timeout=60).stdout
        if until in document:
            break
    return document


def value(document: str, name: str) -> float:
    (number,) = re.findall(f'<data class="{name}" value="([^"]*)"', document)
    return float(number)


@needs_browser
def test_a_browser_solves_the_scene_of_the_address(tmp_path: Path) -> None:
    """The page draws the mass at the time of the address, with the given scene beside it, also on a phone."""
    document = browsed(page("vaiont"), tmp_path, 390, "t=17.3&friction.angle_deg=13.6")
    wanted = solve(with_parameters(load("vaiont"), {"friction": math.tan(math.radians(13.6))}))
    state, before = wanted.at(17.3), motion("vaiont").at(17.3)
    assert value(document, "time") == 17.3
    assert value(document, "velocity") == pytest.approx(state.velocity, rel=1e-4)  # between samples
    assert value(document, "displacement") == pytest.approx(state.displacement, rel=1e-4)
    for kind, at in (("mass", state), ("given", before)):
        ((angle, x, y),) = re.findall(rf'class="{kind}"[^>]*transform="rotate\((\S+) (\S+) (\S+)\)', document)
        assert float(angle) == pytest.approx(-math.degrees(at.rotation), rel=1e-4)
        assert [float(x), float(y)] == data(page("vaiont"))["shape"]["centre"]
    assert ">485.3 m in 37.74 s, comes to rest<" in document
    assert "485.3 m (observed 300 to 450)" in document
    assert "20.21 m/s (as observed)" in document


def asked(scene: Scene, sliders: list[Slider], positions: Any, folder: Path) -> list[Any]:
    """Return the results of the page's engine in a browser at places of its sliders."""
    script = f"""
    engine().then(async (exports) => {{
      const held = JSON.parse(document.querySelector('.slide script').textContent).model;
      const solver = solverOf(JSON.parse(new TextDecoder().decode(await unpacked(held))), exports), said = [];
      for (const places of {json.dumps(positions)}) {{
        const found = solver.motion(places, 5), {{ end, t, s, v, total, effective, work, dissipation }} = found;
        said.push([end.name, found.run_out, found.peak_velocity, found.duration, found.factor, found.error,
          t, s, v, total, effective, work, dissipation]);
      }}
      document.body.append('asked: ' + JSON.stringify(said) + ';');
    }});"""
    text = re.sub(r'<meta http-equiv="Content-Security-Policy".*?/>', "", live.page(solve(scene), sliders))
    document = browsed(text.replace("</body>", f"<script>{script}</script></body>"), folder, 1200, "", "asked: [[")
    (answers,) = re.findall(r"asked: (\[\[.*\]\]);", document)
    return list(json.loads(answers))


@needs_browser
@pytest.mark.parametrize("name", SOLVED)
def test_a_browser_solves_as_solve_does(name: str, tmp_path: Path) -> None:
    """Outcomes, states, stresses and energy agree at random positions of all sliders, within the stated errors."""
    scene = load(name)
    sliders = sliders_of(name)
    ends = np.array([slider.ends for slider in sliders])
    positions = np.random.default_rng(11).uniform(-1.0, 1.0, (POSITIONS, len(sliders)))
    positions[0] = 1.0
    moved = 0
    for place, answer in zip(positions, asked(scene, sliders, positions.tolist(), tmp_path), strict=True):
        values = ends.mean(axis=1) + place * (ends[:, 1] - ends[:, 0]) / 2
        of_names = zip((slider.number.name for slider in sliders), values.tolist(), strict=True)
        wanted = solve(with_parameters(scene, dict(of_names)))
        status, *outcomes, factor, error = answer[:6]
        assert status == wanted.status.name
        assert factor == pytest.approx(wanted.factor_of_safety, rel=1e-12)
        if not wanted.moves:
            continue
        moved += 1
        exact = [wanted.run_out, wanted.peak.velocity, wanted.duration]
        assert outcomes == pytest.approx(exact, rel=max(1e-12, 3 * wanted.error_estimate))
        assert error < 30 * wanted.error_estimate
        times, *columns = map(np.array, answer[6:])
        state, energy, stress = wanted.at(times), wanted.energy_at(times), wanted.effective_stress_at(times)
        of_states = [state.displacement, state.velocity, state.normal_stress / 1e3, stress / 1e3]
        for column, column_wanted in zip(columns, [*of_states, energy.work, energy.dissipation], strict=True):
            if column.shape:  # stresses of layers are means over all soils, which the page leaves out
                size = max(np.abs(column_wanted).max(), 1e-4)  # all samples may be at rest, up to rounding
                assert column == pytest.approx(column_wanted, abs=3e-11 * size)
    assert moved > POSITIONS / 4


@needs_browser
def test_where_the_mass_stays_swings_or_has_no_result_the_page_says_so_in_our_words(tmp_path: Path) -> None:
    """The page explains masses that stay, swing or have no result, at the ends of its sliders."""
    vaiont = load("vaiont")
    swings = browsed(page("vaiont"), tmp_path, 800, "friction.angle_deg=5")
    assert ">953 m in 38.44 s, swings back to 573.7 m<" in swings
    assert ">after 27.6 s, 782 m<" in swings
    assert 'class="curve  beyond"' in swings
    sliders = live.slider(vaiont, "friction.angle_deg", 5.0, 40.0)
    assert sliders[0].number.key == "friction.angle_deg"
    stays = browsed(live.page(motion("vaiont"), sliders), tmp_path, 800, "friction.angle_deg=30")
    assert f">{Status.STAYS.words}<" in stays
    frictionless = live.slider(vaiont, "friction.angle_deg", 1e-6, 40.0)[:1]
    ((status, run_out, *_),) = asked(vaiont, frictionless, [[-1.0]], tmp_path)
    free = solve(replace(vaiont, friction=math.tan(math.radians(1e-6))))  # a pendulum
    assert (status, run_out) == ("MOVING", pytest.approx(free.run_out, rel=1e-9))


@needs_browser
@pytest.mark.parametrize(
    ("damaged", "said"),
    [
        (lambda text: re.sub(r'<script type="text/plain".*?</script>', "", text), "cannot run the engine (WebAss"),
        (lambda text: text.replace('<script type="application/json">{', '<script type="application/json">}'),
         "This page is damaged, or the browser is too old for it"),
    ],
)  # fmt: skip
def test_without_the_engine_the_motion_as_given_is_played(damaged: Any, said: str, tmp_path: Path) -> None:
    document = browsed(damaged(page("vaiont")), tmp_path, 800, "t=10", said)
    assert said in document
    assert "677.3 m in 38.08 s, at rest" in document
    if "WebAss" in said:
        assert value(document, "velocity") == pytest.approx(motion("vaiont").at(10.0).velocity, rel=1e-4)


def test_the_first_sliders_change_the_run_out_most_and_residual_strength_is_among_them() -> None:
    scene = load("real-slope")
    sliders = sliders_of("real-slope")
    changes = []
    for slider in sliders:
        ends = [solve(with_parameters(scene, {slider.number.name: float(end)})).run_out for end in slider.ends]
        changes.append(np.ptp([*ends, motion("real-slope").run_out]))
    assert sorted(changes, reverse=True) == changes
    assert {"friction.peak_deg", "friction.residual_deg", "cohesion.cohesion_kPa"} <= {x.number.key for x in sliders}
    assert len(sliders_of("weak-toe")) >= 4
    first, *more = [slider.number.key for slider in sliders_of("layered-slope")]
    assert (first, len(more)) == ("soils.clay.friction.residual_deg", 3)  # quotients by the friction lost with slip
    assert "friction.peak_deg" in [slider.number.key for slider in sliders_of("shaken-slope")]


def test_a_page_in_us_units() -> None:
    """Series, sliders, scale and units of a page in feet, from the motion in metres."""
    token = PRINTED.set(SYSTEMS["US"])
    try:
        text = live.page(motion("real-slope"))
    finally:
        PRINTED.reset(token)
    held, slide = data(text), motion("real-slope")
    assert held["stored"]["s"][-1] == pytest.approx(float(slide.end.displacement) / 0.3048, rel=1e-6)
    assert max(held["stored"]["v"]) == pytest.approx(slide.peak.velocity / 0.3048, rel=1e-3)
    assert held["shape"]["turn"] == pytest.approx(data(page("real-slope"))["shape"]["turn"] * 0.3048)
    assert {name: unit for name, (unit, _) in held["units"].items()} == {"m": "ft", "m/s": "ft/s", "Pa": "psf"}
    cohesion = next(one for one in held["sliders"] if one["name"].startswith("cohesion"))
    assert cohesion["key"] == "cohesion.cohesion_psf"
    assert cohesion["value"] == pytest.approx(3e3 / 47.88026, rel=1e-6)
    assert {e.text.split()[-1] for e in tree(text).iter("text") if "unit" in e.get("class", "")} == {"ft"}


# --- what a page holds -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", shipped())
def test_a_page_is_small_and_plays_its_motion_as_it_is(name: str) -> None:
    """The motion that a browser without the engine plays, at its samples."""
    wanted, held = motion(name), data(page(name))
    assert len(page(name).encode()) < 130_000
    assert unsolvable(wanted) == ""
    assert held["sliders"]
    stored = held["stored"]
    states = wanted.at(np.array(stored["t"]))
    assert stored["v"] == pytest.approx(states.velocity, abs=2e-6 * wanted.peak.velocity)
    assert stored["s"] == pytest.approx(states.displacement, abs=2e-6 * wanted.run_out)
    assert held["first"]["headline"] == live.headline(wanted)


def test_the_programs_of_a_page_know_no_mechanics() -> None:
    """No functions but those of units and of drawing, and no constant of a law."""
    called = set(re.findall(r"Math\.(\w+)", PROGRAMS))
    assert called == {"PI", "tan", "abs", "max", "min", "round", "sign", "floor", "ceil", "log10"}
    assert PROGRAMS.count("Math.tan") == 1  # a friction angle is that of a coefficient
    assert not re.search(r"9\.8|gravity|Theta|lambda|friction|cohesion", PROGRAMS)


@pytest.mark.parametrize("name", ["valley-side", "real-slope"])
def test_the_mass_is_drawn_to_scale_where_it_turns_to(name: str) -> None:
    """Either facing: both ends of its slip surface, turned as the page turns them, are where the section has them."""
    m = motion(name)
    soil = m.plan.scene.arc
    assert isinstance(soil, Section)
    ends, frame = mass_of(soil, soil).on_circle(mass_of(soil, soil).ends), livesection.frame_around(m, 1.0)
    drawn = livesection.drawn_section(m, frame, 1.0, "x")
    turn = -math.radians(drawn.turn * m.run_out)  # of the drawing, whose y is downwards
    matrix = np.array([[math.cos(turn), -math.sin(turn)], [math.sin(turn), math.cos(turn)]])
    places = drawn.centre + (frame.points(ends) - drawn.centre) @ matrix
    turned = np.stack([soil.placed(end, float(m.end.rotation)) for end in ends])
    assert places == pytest.approx(frame.points(turned), abs=1e-6 * frame.height)
    assert places[int(soil.facing > 0)] == pytest.approx(frame.points(m.journey.toe), abs=1e-6 * frame.height)


def test_soils_are_drawn_in_the_ground_and_in_the_mass_with_their_names() -> None:
    section = profile("constant friction")
    root = tree(live.page(solve(Scene(section, effects=TURNING)), sliders=[]))
    bands = [e for e in root.iter("path") if e.get("class", "").startswith("band ")]
    assert len(bands) == 2 * len(section.layers)
    assert {soil.name for soil, _ in section.layers} <= {e.text for e in root.iter("text")}


def test_surcharges_are_arrows_onto_the_ground_with_their_values() -> None:
    section = replace(profile("constant friction"), surcharge=[(-8.0, -2.0, 10e3, 30e3)])
    m = solve(Scene(section, effects=TURNING))
    root = tree(live.page(m, sliders=[]))
    (line,) = (e.get("d") for e in root.iter("path") if e.get("class") == "surcharge")
    tail, *arrows = [
        np.array(re.findall(r"-?[\d.]+", part), dtype=float).reshape(-1, 2) for part in line.split("M")[1:]
    ]
    tips = np.array([arrow[1] for arrow in arrows])
    ground = livesection.frame_around(m, 1.0).points(np.array([[-8.0, 20.0], [-2.0, 20.0]]))  # level at 20 m there
    assert tips[[0, -1]] == pytest.approx(ground, abs=0.1)
    heights = tips[:, 1] - tail[:, 1]
    assert heights == pytest.approx(np.linspace(heights[-1] / 3, heights[-1], len(tips)), abs=0.1)
    anchors = {e.text: e.get("text-anchor") for e in root.iter("text") if e.get("data-line")}
    assert anchors.pop("10 to 30 kPa") == "middle"
    assert {*anchors.values()} == {"start"}  # names at the left edge end within the page
    assert "surcharges" in "".join(root.find(".//figcaption").itertext())


def test_free_water_is_filled_and_the_ground_of_an_arc_continues_beyond_its_toe() -> None:
    ground = [(-24, 20), (0, 20), (40, 0), (47, 0)]
    m = solve(Scene(Section(ground, (26.0, 34.0), 38.0, 19e3, ponds=[(36.0, 47.0, 2.0)]), 0.1, TURNING))
    (pond,) = (e.get("d") for e in tree(live.page(m, sliders=[])).iter("path") if e.get("class") == "pond")
    frame = livesection.frame_around(m, 1.0)
    corners = np.array(re.findall(r"-?[\d.]+", pond), dtype=float).reshape(-1, 2)
    wanted = frame.points(np.array([[36.0, 2.0], [40.0, 2.0], [47.0, 2.0], [47.0, 0.0], [40.0, 0.0], [36.0, 2.0]]))
    assert corners == pytest.approx(wanted, abs=0.1)
    (soil,) = (e.get("d") for e in tree(page("vaiont")).iter("path") if e.get("class") == "soil")
    frame, toe = livesection.frame_around(motion("vaiont"), 1.0), motion("vaiont").farthest
    arc = motion("vaiont").plan.scene.arc
    end = frame.points(float(arc.radius) * np.array([math.cos(x := float(arc.theta_2 + toe.rotation)), math.sin(x)]))
    corners = np.array(re.findall(r"-?[\d.]+", soil), dtype=float).reshape(-1, 2)
    assert np.interp(end[0], *corners[:-2].T) == pytest.approx(end[1], abs=0.5)  # the mass rests on the ground


@pytest.mark.parametrize(
    ("scene", "key", "said"),
    [
        ("layered-slope", "soils.clay.friction.residual_deg", "clay: residual friction angle (deg)"),
        ("layered-slope", "soils.sand.cohesion_kPa", "sand: cohesion (kPa)"),
        ("real-slope", "circle.radius_m", "radius (m)"),
    ],
)
def test_what_is_dragged_is_said_in_words(scene: str, key: str, said: str) -> None:
    found = load(scene)
    number = number_in(found, key)
    present = float(number.from_si(parameter_value(found, number.name)))
    one = Slider(number, 0.99 * present, 1.01 * present).described(found)
    assert f"{one['label']} ({one['unit']})" == said
    assert one["value"] == pytest.approx(present)


def test_a_notebook_shows_the_slide() -> None:
    (frame,) = ElementTree.fromstring(f"<div>{motion('vaiont')._repr_html_()}</div>").iter("iframe")
    assert str(frame.get("sandbox")).split()[0] == "allow-scripts"
    assert "677.3 m in 38.08 s, at rest" in str(frame.get("srcdoc"))


def test_a_command_writes_the_page(tmp_path: Path, said: Any) -> None:
    said("run vaiont --vary friction.angle_deg=9:20 --live", tmp_path / "slide.html")
    first = data((tmp_path / "slide.html").read_text("utf-8"))["sliders"][0]
    assert [first[name] for name in ("key", "low", "high", "value")] == ["friction.angle_deg", 9.0, 20.0, 10.0]


@needs_browser
def test_a_slider_of_the_geometry_states_its_error_and_keeps_it(tmp_path: Path) -> None:
    """Inputs that are no polynomials: a radius of a section, within what the page says."""
    scene = load("real-slope")
    sliders = live.slider(scene, "circle.radius_m", 29.0, 31.0)[:1]
    (stated,) = [data(live.page(motion("real-slope"), sliders))["input_error"]]
    assert stated < 1e-6
    places = np.linspace(-0.97, 0.93, 9)
    low, high = sliders[0].ends.tolist()
    for place, answer in zip(places, asked(scene, sliders, [[x] for x in places.tolist()], tmp_path), strict=True):
        wanted = solve(with_parameters(scene, {"radius": (low + high) / 2 + (high - low) / 2 * float(place)}))
        assert answer[1:4] == pytest.approx(
            [wanted.run_out, wanted.peak.velocity, wanted.duration], rel=max(100 * stated, 1e-12)
        )


# --- the command -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("vaiont --vary friction.angle_deg=8:12", "--vary: adds a slider to a page; give --live FILE as well"),
        ("vaiont vaiont-frozen --live {}", "--live: shows one scene"),
        ("vaiont --live {} --vary friction.angle=8:12", "friction.angle: is not a parameter of this scene"),
        ("vaiont --live {} --vary friction.angle_deg=8:x", "must be KEY=FROM:TO"),
        ("vaiont --live {} --vary friction.angle_deg=8:12:3", "must be KEY=FROM:TO"),
        ("vaiont --live {} --vary friction.angle_deg=-8:8", "friction"),
        ("vaiont --live {} --vary friction.angle_deg=5:8", "must contain the value of the scene, "),
        ("vaiont --live {} --vary friction.angle_deg=18:8", "the second value must be greater than the first"),
        ("vaiont --live {} --vary friction.angle_deg=8:8", "the second value must be greater than the first"),
        ("layered-slope --live {} --vary soils.clay.friction.residual_deg=6:18", "is not smooth enough between"),
        ("layered-slope --live {} --vary circle.radius_m=20:22", "is not smooth enough between"),
        ("vaiont --live {}/none/x", "there is no folder"),
    ],
)
def test_what_cannot_be_a_page_is_refused(words: str, told: str, tmp_path: Path, refused: Any) -> None:
    assert told in refused("run", words.format(tmp_path / "x.html"))
    assert not list(tmp_path.iterdir())
