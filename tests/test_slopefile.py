"""A slope from its file to circle, factors and picture; and what a file with mistakes is told."""

import html
import json
import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import slipcircle
from slipcircle.derivatives import with_parameters
from slipcircle.workbench.files.loaded import stability_of
from slipcircle.workbench.files.scenefile import critical_of_file
from slipcircle.workbench.files.variation import varied_slope
from slipcircle.workbench.outputs.guide import COMPARED
from slipcircle.workbench.stability.critical import Critical
from slipcircle.workbench.stability.stability import METHODS
from tests.support.motions import from_method
from tests.support.outputs import columns

ACADS = """\
note = "Giam and Donald 1989"
[ground]
points_m = [[0, 25], [30, 25], [50, 35], [90, 35]]
unit_weight_kN_m3 = 20
base_m = 20
[friction]
angle_deg = 19.6
[cohesion]
cohesion_kPa = 3
"""
CIRCLE = "[circle]\ncentre_m = [29.5, 53.6]\nradius_m = 28.6\nbetween_m = [29, 60]\n"


Write = Callable[[str], str]


@pytest.fixture
def write(tmp_path: Path) -> Write:
    """Write a slope's file; returns its path."""

    def to_file(text: str) -> str:
        path = tmp_path / "my-slope.toml"
        path.write_text(text, "utf-8")
        return str(path)

    return to_file


def found_in(path: str) -> Critical:
    return critical_of_file(path, None, lambda line: None)[2]


def test_from_a_file_to_circle_and_picture(write: Write, tmp_path: Path, asked: Any, records: Any) -> None:
    path, picture = write(ACADS), tmp_path / "slope.png"
    _, out, err = asked("search", path, "--json --plot", picture)
    (record,) = json.loads(out)
    numbers = {
        "factor_of_safety",
        "factor_of_safety_method",
        "factors_of_safety",
        "circle",
        "entry",
        "exit",
        "tried",
        "refused",
    }
    assert record.keys() == numbers | {"format", "scene", "method", "facing", "warnings"}
    assert (record["scene"], record["method"], record["facing"]) == ("my-slope", "bishop", -1)
    assert record["factor_of_safety"] == found_in(path).factor_of_safety
    assert "my-slope: least factor" in err
    assert picture.read_bytes().startswith(b"\x89PNG")
    (record,) = records("search", path, "--method ordinary")
    assert record["factors_of_safety"]["ordinary"] == pytest.approx(0.9424, abs=5e-5)
    reaches = ACADS + "[search]\nexit_m = [40, 45]\n"
    record, other = records("search", write(ACADS), "real-slope")
    assert (record["warnings"], other["scene"]) == ([], "real-slope")
    (record,) = records("search", write(reaches))
    assert "the exit is at a limit of the search" in record["warnings"][0]
    (record,) = records("search", write(ACADS + CIRCLE))  # a circle that is given is not searched
    assert (record["tried"], record["refused"]) == (1, 0)
    assert record["circle"] == {"centre": [29.5, 53.6], "radius": 28.6}


SLIDE = """\
[friction]
law = "exponential"
peak_deg = 19.6
residual_deg = 10
length_m = 0.5
[rotation]
[circle]
"""
SCENE = ACADS.replace("[friction]\nangle_deg = 19.6\n", "") + SLIDE + 'critical = "bishop"\n'
FIXED = SCENE.replace('[circle]\ncritical = "bishop"\n', CIRCLE)


@pytest.mark.usefixtures("unseen")
def test_the_motion_has_the_factors_of_its_circle(write: Write, tmp_path: Path, said: Any, records: Any) -> None:
    path, page = write(SCENE), tmp_path / "slide.html"
    table = columns(said("run --verbose", path, "--report", page))
    assert table["factor of safety by Bishop's method"] == ["0.985"]
    assert table["factor of safety by the ordinary method"] == ["0.9502"]  # of Bishop's circle
    assert table["circle"] == ["least factor by bishop"]
    assert "circles evaluated, invalid" in page.read_text("utf-8")
    (motion,), (alone,) = records("run", path), records("search", path)
    assert alone == {"format": "slipcircle-json-1", "scene": "my-slope", "warnings": []} | motion["stability"]
    assert motion["factor_of_safety"] == pytest.approx(alone["factor_of_safety"], rel=1e-9)


def test_a_slide_along_an_arc_in_tension_is_told_of(write: Write, asked: Any) -> None:
    cut = SCENE.replace("points_m = [[0, 25], [30, 25], [50, 35], [90, 35]]", "height_m = 10\nangle_deg = 90")
    cut = cut.replace("base_m = 20", "base_m = -5").replace("cohesion_kPa = 3", "cohesion_kPa = 30")
    assert "of the arc is under negative effective normal stress" in asked("run", write(cut))[2]


def test_what_a_record_of_pore_pressure_holds_at_the_start_is_not_read_for_factors(
    write: Write, tmp_path: Path
) -> None:
    (tmp_path / "pore.csv").write_text("time,pressure\n0,3\n9,8\n")
    recorded = slipcircle.load(write(FIXED + "[pore_pressure]\nrecord = 'pore.csv'\nunits = 'kPa'\n"))
    assert stability_of(recorded) is None


SLOWER = "rate = { law = 'rate_weakening', peak = 0.5, residual = 0.1, velocity_m_s = 1 }\nangle_deg = 20\n"
RATIO = "ratio = [0.1, 0.3]\ntime_s = [0, 10]\n"


@pytest.mark.parametrize(
    ("soil", "water", "friction", "pressure", "pore_ratio"),
    [
        ("angle_deg = 20\n", "pressure_kPa = [5, 9]\ntime_s = [0, 8]\n", math.tan(math.radians(20)), 5e3, 0.0),
        (SLOWER, RATIO, 0.5 * math.tan(math.radians(20)), 0.0, 0.1),
        ("law = 'prescribed'\ntime_s = [0, 9]\nangle_deg = [20, 5]\n", RATIO, math.tan(math.radians(20)), 0.0, 0.1),
        ("law = 'tabulated'\nslip_m = [0, 9]\ncoefficient = [0.3, 0.1]\n", RATIO, 0.3, 0.0, 0.1),
        (
            "angle_deg = { distribution = 'uniform', low = 18, high = 24 }\n",
            RATIO,
            math.tan(math.radians(21)),
            0.0,
            0.1,
        ),
    ],
)
def test_the_strength_at_the_start_counts(
    write: Write, soil: str, water: str, friction: float, pressure: float, pore_ratio: float
) -> None:
    text = FIXED.replace(SLIDE[: SLIDE.index("[rotation]")], "[friction]\n" + soil) + "[pore_pressure]\n" + water
    scene, found = slipcircle.load(write(text)), found_in(write(text))
    given = stability_of(scene)
    assert given is not None
    for slope in (given.slope, found.slope):
        assert (slope.friction, slope.pressure, slope.pore_ratio) == pytest.approx((friction, pressure, pore_ratio))
    if not scene.uncertain:
        for start in ("paper", "ordinary", "bishop"):
            motion = slipcircle.solve(from_method(scene, start))
            assert motion.factor_of_safety == pytest.approx(given.factors_of_safety[start], rel=1e-9)


def test_the_command_refuses_what_it_cannot_read(write: Write, refused: Any, asked: Any) -> None:
    limits = "[search]\nexit_m = [30, 2]\ndepth_m = 2e5\n"
    for command, text in (("search", ACADS + limits), ("run", SCENE + limits)):
        mistakes = refused(command, write(text))
        assert "search.exit_m = [30, 2]: must be the least and the greatest x" in mistakes
        assert "search.depth_m = 200000.0:" in mistakes
    assert "ever thinner masses" in refused("search", write(ACADS.replace("cohesion_kPa = 3", "cohesion_kPa = 0")))
    assert "replace [arc] by [ground]" in refused("search vaiont")
    assert "takes one slope" in refused("search real-slope", write(ACADS), "--plot x.png")
    assert "no-such-slope.toml: there is no such file" in refused("search no-such-slope.toml")
    assert asked("search", write(ACADS), "--method janbu")[0] == 2


def test_what_a_file_says(write: Write) -> None:
    text = (
        "name = 'cut'\n[ground]\nheight_m = 10\nangle_deg = 45\nunit_weight_kN_m3 = 19\n"
        "gravity_m_s2 = 9.8\nwidth_m = 40\n"
        "[friction]\ncoefficient = 0.5\n[water]\nlevel_m = [[-60, 8], [-10, 6], [0, -1], [9, -1]]\n"
        "unit_weight_kN_m3 = 10\n"
        "[search]\nk_h = 0.1\nentry_m = [-30, -10]\ndepth_m = 1\n[rotation]\n[circle]\n"
    )  # fmt: skip
    path = write(text + "through_m = [[-14, 10], [0, 0]]\ndepth_m = 3\n")
    name, _, found, _ = critical_of_file(path, None, print)
    slope, section = found.slope, slipcircle.load(path).arc
    assert isinstance(section, slipcircle.Section)
    assert np.asarray(slope.ground)[1] == pytest.approx([-10.0, 10.0])
    assert (name, slope.cohesion, slope.friction, slope.unit_weight) == ("cut", 0.0, 0.5, 19e3)
    assert (slope.k_h, slope.water_unit_weight) == (0.1, 10e3)
    assert (section.gravity, section.width, section.facing, section.sagitta) == (9.8, 40.0, 1, pytest.approx(3.0))
    assert (
        np.asarray(section.level).tolist() == np.asarray(slope.level).tolist() == [[-60, 8], [-10, 6], [0, -1], [9, -1]]
    )
    assert found_in(write(text + "critical = 'paper'\n")).limits == {
        "entry": (-30.0, -10.0), "exit": None, "depth": 1.0
    }  # fmt: skip
    touching = found_in(write(ACADS + "[circle]\nthrough_m = [[30, 25], [55, 35]]\ntouching_m = 24\n"))
    assert touching.centre[1] - touching.radius == pytest.approx(24.0)
    assert found_in(write(ACADS + '[circle]\ncritical = "ordinary"\n')).method == "ordinary"


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("cohesion_kPa = 3", "cohesion_kPa = 300000", "at most 100000; was 300 kPa meant, which are 300000 Pa"),
        ("kN_m3 = 20", "kN_m3 = 19500", r"and below 100 \(kN/m3\): unit weight of the soil; was 19.5 kN/m3 meant"),
        ("points_m = [[0, 25], [30, 25], [50, 35], [90, 35]]", "height_m = 10\nangle_deg = 95", "and at most 90"),
        ("[30, 25]", "[30]", "a list of two points or more"),
        ("[[0, 25], [30, 25], [50, 35], [90, 35]]", "[[0, 25]]", "a list of two points or more"),
        ("base_m = 20", "base_m = 35", "ground.base_m = 35: must lie below the highest point of the ground"),
        ("cohesion_kPa = 3\n", "cohesion_kPa = 3\n[water]\nlevel_m = [[0, 26], [90, 20]]\n", "level_m: varies by"),
        ("= 20\nbase", "= { distribution = 'normal', mean = 20, std = 1 }\nbase", "must be a number"),
        ("[cohesion]", "[pore_pressure]\nrecord = 'x.csv'\n[cohesion]", "a pore pressure that is not a record"),
        ("cohesion_kPa = 3\n", "cohesion_kPa = 3\n[circle]\nthrough_m = [[30, 25], [40, 30], [55, 35]]\ndepth_m = 2\n",
         "circle.through_m: must be two points"),
        ("cohesion_kPa = 3\n",
         "cohesion_kPa = 3\n[pore_pressure]\nratio = 0.1\n[water]\nlevel_m = [[0, 20], [90, 20]]\n",
         "pore_pressure.ratio = 0.1: water.level_m gives the pore pressure, too"),
        ("base_m = 20", "base_m = 20\nheight_m = 3", "do not go together"),
        ("[cohesion]", "[circle]\ncritical = 'bishp'\n[cohesion]", "did you mean bishop"),
        ("[cohesion]", "[search]\nk_h = 9.81\n[cohesion]", "a share of g"),
        ("[cohesion]", "[water]\nlevels_m = [[0, 1]]\n[cohesion]", "did you mean level_m"),
    ],
)  # fmt: skip
def test_mistakes_are_told_with_their_fix(write: Write, old: str, new: str, words: str) -> None:
    assert old in ACADS
    with pytest.raises(ValueError, match=words) as raised:
        found_in(write(ACADS.replace(old, new)))
    assert "my-slope.toml: " in str(raised.value)


@pytest.mark.parametrize(
    ("key", "drawn", "old", "new"),
    [
        ("cohesion.cohesion_kPa", {"distribution": "lognormal", "mean": 3, "std": 2}, "", ""),  # its median is 2.5
        ("friction.peak_deg", {"distribution": "normal", "mean": 30, "std": 0.2}, "19.6", "30"),
        ("ground.points_m.2.y", {"distribution": "normal", "mean": 36, "std": 0.2}, "[50, 35]", "[50, 36]"),
    ],
)
def test_every_sample_slides_along_the_circle_of_the_means(
    write: Write, key: str, drawn: Any, old: str, new: str
) -> None:
    scene = replace(slipcircle.load(write(SCENE)), uncertain={key: drawn})
    study = slipcircle.ensemble(scene, 16, rng=1, sensitivity=0)
    assert stability_of(study.scene) == found_in(write(ACADS.replace(old, new)))
    assert any("the critical circle of the means (least factor by bishop)" in w for w in study.warnings)
    values = {n: float(u.to_si(study.samples[u.key][3])) for n, u in study.design.inputs.items()}
    alone = slipcircle.solve(with_parameters(replace(study.scene, uncertain={}), values))
    assert alone.run_out == pytest.approx(study.samples["run_out"][3], rel=1e-9)


def test_a_circle_that_is_given_stays(write: Write, asked: Any) -> None:
    drawn = {"friction.peak_deg": {"distribution": "normal", "mean": 30, "std": 0.2}}
    study = slipcircle.ensemble(replace(slipcircle.load(write(FIXED)), uncertain=drawn), 16, rng=1, sensitivity=0)
    assert isinstance(study.scene.arc, slipcircle.Section)
    assert np.array_equal(study.scene.arc.centre, [29.5, 53.6])
    assert not any("critical" in warning for warning in study.warnings)
    _, _, err = asked("sweep", write(SCENE), "--grid friction.peak_deg=18,19")
    assert "the critical circle of the scene as given" in err


def test_a_search_writes_the_scene_of_its_motion(write: Write, tmp_path: Path, said: Any, refused: Any) -> None:
    """The motion is the same bit for bit, other lines of the file remain, and faulty input writes nothing."""
    path, written = Path(write(SCENE)), tmp_path / "scene.toml"
    said("search", path, "--write", written)
    made, read = slipcircle.load(written), slipcircle.load(path)
    one, other = map(slipcircle.solve, (made, read))
    assert (one.run_out, one.duration, one.factor_of_safety) == (other.run_out, other.duration, other.factor_of_safety)
    assert {*path.read_text("utf-8").splitlines()} - {*written.read_text("utf-8").splitlines()} == {
        'critical = "bishop"'
    }
    bare = tmp_path / "bare.toml"
    text = ACADS + '[circle] # found\n\ncritical = "paper"\n# water\n\n[pore_pressure] # r_u\nratio = 0.1\n'
    said("search", write(text), "--write", bare)
    assert 'start = "paper"\n# water\n\n[pore_pressure] # r_u' in bare.read_text("utf-8")
    bared: Any = slipcircle.load(bare)
    in_python = slipcircle.solve(bared.stability.scene(["rotation", "centripetal"]))
    assert slipcircle.solve(bared).run_out == in_python.run_out > 0.0
    before = written.read_bytes()
    assert "is there already; give another name" in refused("search", path, "--write", written)
    assert written.read_bytes() == before
    new = tmp_path / "sub" / "new.toml"
    new.parent.mkdir()
    (tmp_path / "quake.csv").write_text("time_s,k_h_g\n0,0\n0.5,0.3\n1,0\n", "utf-8")
    for said_so, faulty in {
        "make it a table of its own": 'circle = { critical = "bishop" }\n' + ACADS,
        "water_m: is for factors of safety alone": SCENE + "[tension_crack]\ndepth_m = 1\nwater_m = 0.5\n",
        "quake.csv; write it beside it": SCENE + '[shaking]\nrecord = "quake.csv"\n',
    }.items():
        assert said_so in refused("search", write(faulty), "--write", new)
    assert "takes one slope" in refused("search", path, path, "--write", new)
    assert not [*new.parent.iterdir()]


def test_a_folder_knows_one_circle_from_another(write: Write, tmp_path: Path) -> None:
    drawn = {"friction.peak_deg": {"distribution": "normal", "mean": 15, "std": 2}}
    one = replace(slipcircle.load(write(FIXED)), uncertain=drawn)
    slipcircle.ensemble(one, 16, rng=1, folder=tmp_path)
    with pytest.raises(ValueError, match="another study: mass"):
        slipcircle.ensemble(replace(one, arc=replace(one.arc, radius=28.55)), 16, rng=1, folder=tmp_path)


def test_the_guide_says_by_how_much_the_methods_differ() -> None:
    stability = stability_of(slipcircle.load("real-slope"))
    assert stability is not None
    for found in (stability, slipcircle.critical(replace(stability.slope, pore_ratio=0.5))):
        paper, ordinary, bishop = (found.factors_of_safety[method] or math.nan for method in METHODS)
        assert f"{paper:.3f}, {ordinary:.3f} and {bishop:.3f}" in COMPARED
        assert f"by {100 * (1 - paper / bishop):.0f} %" in COMPARED


def test_the_limits_of_a_file_hold(write: Write, said: Any, records: Any) -> None:
    limits = "[search]\nentry_m = [60, 65]\nexit_m = [20, 24]\ndepth_m = 2\nk_h = 0.1\n"
    (record,) = records("search", write(ACADS + limits))
    assert 60 - 1e-6 <= record["entry"][0] <= 65
    assert 20 <= record["exit"][0] <= 24 + 1e-6
    assert record["factors_of_safety_without_k_h"]["bishop"] > record["factors_of_safety"]["bishop"]
    table = columns(said("run --verbose", write(SCENE + limits)))
    for words in ("", ", k_h = 0.1"):  # a motion starts from that without k_h
        assert f"factor of safety by Bishop's method{words}" in table


@pytest.mark.usefixtures("unseen")
def test_every_factor_of_safety_names_its_method(write: Write, said: Any, tmp_path: Path) -> None:
    """Table, live page and report show the factor of the start first, beside the run-out from the paper's factor."""
    between = FIXED.replace("cohesion_kPa = 3", "cohesion_kPa = 3.4") + "[search]\nk_h = 0.05\n"
    stability = stability_of(slipcircle.load(write(between)))
    assert stability is not None
    still, shaken = (
        [f"{(factors or {})[method]:.4g}" for method in ("paper", "bishop")]
        for factors in (stability.factors_of_safety_without_k_h, stability.factors_of_safety)
    )
    assert still[0] < "1" < still[1]  # so that the methods disagree
    page, report = tmp_path / "live.html", tmp_path / "report.html"
    out = said("run --verbose", write(between), "--live", page, "--report", report)
    paper, bishop = "factor of safety by the paper's method", "factor of safety by Bishop's method"
    run_out = slipcircle.solve(from_method(slipcircle.load(write(between)), "paper")).run_out
    rows = {bishop: [still[1]], "alternative start": [f"the paper's F = {float(still[0]):.3f}: {run_out:.3g} m"]}
    assert {**rows, paper: [still[0]]}.items() <= columns(out).items()
    assert rows.items() <= (brief := columns(said("run", write(between)))).items()
    assert paper not in brief
    assert {f"{paper}, k_h = 0.05": [shaken[0]], f"{bishop}, k_h = 0.05": [shaken[1]]}.items() <= columns(out).items()
    for file in (page, report):
        text = html.unescape(file.read_text("utf-8"))
        assert all(f"<dt>{label}</dt><dd>{cell}</dd>" in text for label, (cell,) in rows.items())
    assert '"factor_of_safety_method": "bishop"' in text


@pytest.mark.parametrize(("text", "command"), [(ACADS, "search"), (SCENE, "run")])
def test_a_circle_that_cuts_level_ground_alone_is_refused(write: Write, refused: Any, text: str, command: str) -> None:
    level = text.replace('[circle]\ncritical = "bishop"', "") + "[circle]\ncentre_m = [15, 45]\nradius_m = 22\n"
    error = refused(command, write(level))
    assert "circle.centre_m: nothing drives the mass from x = 5.83485 to 24.1652" in error


def test_factors_of_samples_are_those_of_a_search_of_each() -> None:
    """No circle of the means has a lesser factor."""
    uncertain = {
        "friction.peak_deg": {"distribution": "normal", "mean": 19.6, "std": 2.5},
        "cohesion.cohesion_kPa": {"distribution": "lognormal", "mean": 3, "std": 1},
    }
    scene = replace(slipcircle.load("real-slope"), uncertain=uncertain)
    study = slipcircle.ensemble(scene, 6, rng=1, sensitivity=0, search_each=True)
    stability = stability_of(study.scene)
    assert stability is not None
    factors = []
    for k in range(6):
        values = {n: float(u.to_si(study.samples[u.key][k])) for n, u in study.design.inputs.items()}
        searched = slipcircle.critical(varied_slope(with_parameters(study.scene, values), stability.slope))
        factors.append(searched.factors_of_safety["bishop"] or math.nan)
    assert study.failure["searched bishop"].value == np.mean(np.array(factors) < 1.0)
    once, each = (study.factor_quantile(method, 0.5).value for method in ("bishop", "searched bishop"))
    assert each == pytest.approx(sorted(factors)[2], rel=2e-3)
    assert each <= once * (1 + 2e-3)
    assert "with the circle searched for every sample" in study.warnings[1]
