"""The slide that one can drag: it shows the numbers of `Motion.at`, to scale, and needs nothing else."""

import base64
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

from slipcircle import Motion, Scene, Section, Series, load, solve
from slipcircle.derivatives import parameter_value
from slipcircle.workbench.files.numbers import number_in
from slipcircle.workbench.outputs import live, livesection
from slipcircle.workbench.outputs.interpolant import hermite, interpolant
from slipcircle.workbench.outputs.shapes import mass_of
from tests.support.layered import TURNING, profile

KEY, VALUES = "friction.residual_deg", np.linspace(8.0, 18.0, 21)
SHOWN = 1e-5  # of the greatest value: how far what the page shows may be off


@cache
def motion(name: str) -> Motion:
    return solve(load(name))


def recorded() -> Scene:
    """Vaiont under 2,000 samples of noise, by which it slips and sticks many times."""
    time = np.linspace(0.0, 19.99, 2000)
    noise = np.convolve(np.random.default_rng(1).normal(size=time.size), np.ones(8) / 8, "same")
    shaking = {"horizontal": Series(time, 0.8 * noise * np.exp(-(((time - 10.0) / 6.0) ** 2)))}
    return Scene(load("vaiont").arc, 0.45, {"rotation": {}, "shaking": shaking}, end_time=20.0, name="record")


@cache
def varied() -> str:
    return live.varied_page(load("vaiont-softening"), KEY, VALUES.tolist())


def tree(page: str) -> Any:
    """The page as XML, which it must be as well."""
    return ElementTree.fromstring(page.partition("\n")[2])


def data(page: str) -> Any:
    (text,) = (e.text for e in tree(page).iter("script") if e.get("type") == "application/json")
    return json.loads(text)


# --- in a browser ----------------------------------------------------------------------------------------------------


def browsed(page: str, folder: Path, width: int, state: str = "") -> str:
    """What a browser makes of a page in a window of some width: the text of its document."""
    browser = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if browser is None:
        pytest.skip("there is no Chromium here to show the page")
    path = folder / "page.html"
    path.write_text(page, "utf-8")
    quiet = "--no-sandbox --disable-gpu --disable-background-networking --disable-component-update --disable-sync"
    size, profile = f"--window-size={width},900", f"--user-data-dir={folder / 'profile'}"
    command = [browser, "--headless", *quiet.split(), "--no-first-run", size, profile, "--dump-dom"]
    done = subprocess.run(
        [*command, f"{path.as_uri()}#{state}"], capture_output=True, text=True, check=True, timeout=60
    )
    return done.stdout


def value(document: str, name: str) -> float:
    (number,) = re.findall(f'<data class="{name}" value="([^"]*)"', document)
    return float(number)


def test_a_browser_shows_the_numbers_of_the_motion_at_the_address(tmp_path: Path) -> None:
    """On a phone, the page as it is; the mass is drawn where it is at that time."""
    document, wanted = browsed(varied(), tmp_path, 390, "t=17.3&v=4"), motion("vaiont-softening")
    state = wanted.at(17.3)
    assert value(document, "time") == 17.3
    assert value(document, "velocity") == pytest.approx(state.velocity, abs=SHOWN * wanted.peak.velocity)
    ((angle, x, y),) = re.findall(r'class="mass" transform="rotate\((\S+) (\S+) (\S+)\)', document)
    assert float(angle) == pytest.approx(-math.degrees(state.rotation), abs=1e-3)
    assert [float(x), float(y)] == data(varied())["shapes"][0]["centre"]
    assert 'class="curve" d="M' in document
    assert f">{live.headline(wanted)}<" in document


def test_a_browser_shows_every_case_at_every_time(tmp_path: Path) -> None:
    """On a wide screen; a script that the page's policy would refuse asks for them."""
    times = [0.0, 0.7, 5.0, 16.6, 31.0, 39.9]
    ask = f"""
    const said = [], shown = (name) => Number(document.querySelector('.' + name).value);
    for (let v = 0; v < {VALUES.size}; v += 5) for (const t of {times}) {{
      history.replaceState(null, '', `#t=${{t}}&v=${{v}}`);
      dispatchEvent(new Event('hashchange'));
      said.push([v, t, shown('velocity'), shown('displacement')]);
    }}
    document.body.append('asked: ' + JSON.stringify(said) + ';');"""
    page = re.sub(r'<meta http-equiv="Content-Security-Policy".*?/>', "", varied())
    document = browsed(page.replace("</body>", f"<script>{ask}</script></body>"), tmp_path, 1200)
    (answers,) = re.findall(r"asked: (\[\[.*\]\]);", document)
    scene = load("vaiont-softening")
    for case, time, velocity, displacement in json.loads(answers):
        assert isinstance(scene.friction, dict)
        wanted = solve(replace(scene, friction=scene.friction | {"residual": math.tan(math.radians(VALUES[case]))}))
        state = wanted.at(time)
        assert velocity == pytest.approx(state.velocity, abs=SHOWN * wanted.peak.velocity)
        assert displacement == pytest.approx(state.displacement, abs=SHOWN * wanted.run_out)


# --- what a page holds -----------------------------------------------------------------------------------------------


def test_many_cases_of_a_record_share_the_room_of_a_page_which_says_their_error() -> None:
    """Noise of 2,000 samples: fifteen cases need more points than there is room for; the greatest error is stated."""
    angles = np.linspace(22.0, 26.0, 15)
    page = live.varied_page(recorded(), "friction.angle_deg", angles.tolist())
    assert 200_000 < len(page.encode()) < 300_000
    (stated,) = re.findall("Interpolation error: at most (.*?) of the greatest values", page)
    errors = [error_between_points(case, angle) for case, angle in zip(data(page)["cases"], angles, strict=True)]
    assert 1e-6 < float(stated) / 5 < max(errors) < 1.5 * float(stated)


def error_between_points(case: Any, angle: float) -> float:
    """Of the velocity that a page interpolates, as a share of the greatest, at random times."""
    t, v, a = decoded(case["columns"], case["units"])
    times = np.sort(np.random.default_rng(5).uniform(0.0, t[-1], 1000))
    wanted = solve(replace(recorded(), friction=math.tan(math.radians(angle))))
    return float(np.abs(hermite(t, v, a, times) - wanted.at(times).velocity).max() / wanted.peak.velocity)


def decoded(columns: list[str], units: list[float]) -> list[Any]:
    kinds = ("<i4", "<i4", "<i2")
    integers = [np.frombuffer(base64.b64decode(column), kind) for column, kind in zip(columns, kinds, strict=True)]
    return [unit * column for unit, column in zip(units, integers, strict=True)]


@pytest.mark.parametrize("name", ["vaiont-rate", "vaiont-shaken", "newmark-pulse", "valley-side", "record"])
def test_cubics_between_the_points_of_a_page_are_the_motion(name: str) -> None:
    wanted = motion(name) if name != "record" else solve(recorded())
    points = interpolant(wanted, 9000)
    times = np.sort(np.random.default_rng(3).uniform(0.0, wanted.duration, 400))
    t, v, a = decoded(*points.encoded())
    assert len(t) < (3000 if name == "record" else 400)
    state, peak, reach = wanted.at(times), wanted.peak.velocity, wanted.reach.displacement
    np.testing.assert_allclose(hermite(t, v, a, times), state.velocity, rtol=0.0, atol=SHOWN * peak)
    displacement = hermite(t, points.displacement, v, times)
    np.testing.assert_allclose(displacement, state.displacement, rtol=0.0, atol=SHOWN * reach)


@pytest.mark.parametrize("name", ["valley-side", "real-slope"])
def test_the_mass_is_drawn_to_scale_where_it_turns_to(name: str) -> None:
    """Either facing: both ends of its slip surface, turned as the page turns them, are where the section has them."""
    m = motion(name)
    soil = m.plan.scene.arc
    assert isinstance(soil, Section)
    ends, frame = mass_of(soil, soil).on_circle(mass_of(soil, soil).ends), livesection.frame_around([m])
    drawn = livesection.section(m, frame, 1.0, "x")
    turn = -math.radians(drawn.turn * m.run_out)  # of the drawing, whose y is downwards
    matrix = np.array([[math.cos(turn), -math.sin(turn)], [math.sin(turn), math.cos(turn)]])
    places = drawn.centre + (frame.points(ends) - drawn.centre) @ matrix
    turned = np.stack([soil.placed(end, float(m.end.rotation)) for end in ends])
    assert places == pytest.approx(frame.points(turned), abs=1e-6 * frame.height)
    assert places[int(soil.facing > 0)] == pytest.approx(frame.points(m.journey.toe), abs=1e-6 * frame.height)


def test_masses_that_stay_are_cut_off_or_have_no_result_have_a_page() -> None:
    vaiont = load("vaiont")
    still, cut = replace(vaiont, friction=0.9), replace(vaiont, end_time=10.0)
    for scene, words, duration in ((still, "does not move", 0.0), (cut, "still moving", 10.0)):
        page = live.page([solve(scene)])
        assert words in data(page)["cases"][0]["headline"]
        assert words in "".join(tree(page).itertext())
        assert data(page)["duration"] == duration
    over = replace(vaiont, friction=0.0, initial_velocity=1.0)
    cases = data(live.varied_page(over, "initial_velocity_m_s", [0.0, -400.0]))["cases"]
    assert ["no result" in case["headline"] for case in cases] == [False, True]


def test_soils_are_drawn_in_the_ground_and_in_the_mass_with_their_names() -> None:
    section = profile("constant friction")
    root = tree(live.page([solve(Scene(section, effects=TURNING))]))
    bands = [e for e in root.iter("path") if e.get("class", "").startswith("band ")]
    assert len(bands) == 2 * len(section.layers)
    assert {soil.name for soil, _ in section.layers} <= {e.text for e in root.iter("text")}


def test_surcharges_are_arrows_onto_the_ground_with_their_values() -> None:
    section = replace(profile("constant friction"), surcharge=[(-8.0, -2.0, 10e3, 30e3)])
    m = solve(Scene(section, effects=TURNING))
    root = tree(live.page([m]))
    (line,) = (e.get("d") for e in root.iter("path") if e.get("class") == "surcharge")
    tail, *arrows = [
        np.array(re.findall(r"-?[\d.]+", part), dtype=float).reshape(-1, 2) for part in line.split("M")[1:]
    ]
    tips = np.array([arrow[1] for arrow in arrows])
    ground = livesection.frame_around([m]).points(np.array([[-8.0, 20.0], [-2.0, 20.0]]))  # level at 20 m there
    assert tips[[0, -1]] == pytest.approx(ground, abs=0.1)
    heights = tips[:, 1] - tail[:, 1]
    assert heights == pytest.approx(np.linspace(heights[-1] / 3, heights[-1], len(tips)), abs=0.1)
    assert "10 to 30 kPa" in {e.text for e in root.iter("text")}
    assert "surcharges" in "".join(tree(live.page([m])).find(".//figcaption").itertext())


@pytest.mark.parametrize(
    ("scene", "key", "said"),
    [
        ("layered-slope", "soils.clay.friction.residual_deg", "clay: residual friction angle (deg)"),
        ("layered-slope", "soils.sand.cohesion_kPa", "sand: cohesion (kPa)"),
        ("real-slope", "circle.radius_m", "radius (m)"),
    ],
)
def test_what_is_varied_is_said_in_words(scene: str, key: str, said: str) -> None:
    found = load(scene)
    number = number_in(found, key)
    present = float(number.from_si(parameter_value(found, number.name)))
    labels = [e.text for e in tree(live.varied_page(found, key, [present])).iter("label") if e.get("class") == "which"]
    assert labels == [f"{said}: "]


def test_a_notebook_shows_the_slide() -> None:
    (frame,) = ElementTree.fromstring(f"<div>{motion('vaiont')._repr_html_()}</div>").iter("iframe")
    assert frame.get("sandbox") == "allow-scripts"
    assert "677.3 m in 38.08 s, at rest" in str(frame.get("srcdoc"))


def test_a_command_writes_the_page(tmp_path: Path, said: Any) -> None:
    said("run vaiont --vary friction.angle_deg=8:12:3 --live", tmp_path / "slide.html")
    found = data((tmp_path / "slide.html").read_text("utf-8"))
    assert [case["label"] for case in found["cases"]] == ["8", "10", "12"]
    assert found["first"] == 1


# --- the command -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("vaiont --vary friction.angle_deg=8:12:3", "--vary: is the second slider of a page; give --live FILE as well"),
        ("vaiont vaiont-frozen --live {}", "--live: shows one scene"),
        ("vaiont --live {} --vary friction.angle_deg=8:12:99", "99 values; a page shows at most 61"),
        ("vaiont --live {} --vary friction.angle=8:12:3", "friction.angle: is no number of a scene"),
        ("vaiont --live {} --vary friction.angle_deg=8:x", "must be KEY=FROM:TO:COUNT"),
        ("vaiont --live {} --vary friction.angle_deg=-8,8", "friction"),
        ("vaiont --live {}/none/x", "there is no folder"),
    ],
)
def test_what_cannot_be_a_page_is_refused(words: str, told: str, tmp_path: Path, refused: Any) -> None:
    assert told in refused("run", words.format(tmp_path / "x.html"))
    assert not list(tmp_path.iterdir())
