"""A slope from its file to circle, factors and picture; and what a file with mistakes is told."""

import json
import math
from pathlib import Path

import numpy as np
import pytest

import slipcircle
from slipcircle.__main__ import main
from slipcircle.files import slopefile
from slipcircle.outputs import searching

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


@pytest.fixture
def write(tmp_path: Path) -> "Write":
    return Write(tmp_path / "my-slope.toml")


class Write:
    """Write a slope's file; returns its path."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def __call__(self, text: str) -> str:
        self.path.write_text(text, "utf-8")
        return str(self.path)


def search(*argv: str) -> int:
    return main(["search", *argv])


def test_from_a_file_to_circle_and_picture(write: Write, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path, picture = write(ACADS), tmp_path / "slope.png"
    assert search(path, "--json", "--plot", str(picture)) == 0
    out, err = capsys.readouterr()
    (record,) = json.loads(out)
    assert record["factor_of_safety"]["bishop"] == pytest.approx(0.985, rel=1e-3)
    assert set(record["factor_of_safety"]) == {"paper", "ordinary", "bishop"}
    assert record["exit"] == pytest.approx([30, 25], abs=0.2)
    assert record["tried"] > record["refused"] > 0
    assert "my-slope: least factor" in err
    assert picture.read_bytes().startswith(b"\x89PNG")
    search(path, "--method", "ordinary")
    assert "0.9424" in capsys.readouterr().out


def test_a_circle_that_is_given_is_not_searched(write: Write, capsys: pytest.CaptureFixture[str]) -> None:
    search(write(ACADS + CIRCLE), "--json")
    (record,) = json.loads(capsys.readouterr().out)
    assert (record["tried"], record["refused"]) == (1, 0)
    assert record["circle"] == {"centre": [29.5, 53.6], "radius": 28.6}
    assert record["factor_of_safety"]["bishop"] == pytest.approx(0.98516, rel=1e-4)


def test_the_command_refuses_what_it_cannot_read(write: Write, capsys: pytest.CaptureFixture[str]) -> None:
    assert search(write(ACADS.replace("kN_m3 = 20", "kN_m3 = 19500"))) == 1
    assert "is that in N/m3" in capsys.readouterr().err
    assert search(write(ACADS.replace("cohesion_kPa = 3", "cohesion_kPa = 0"))) == 1
    assert "thinner skin" in capsys.readouterr().err
    assert search("no-such-slope.toml") == 1
    assert "no-such-slope.toml: there is no such file" in capsys.readouterr().err
    with pytest.raises(SystemExit, match="2"):
        search(write(ACADS), "--method", "janbu")


def test_from_python(write: Write) -> None:
    file = slopefile.read(write(ACADS))
    found = slipcircle.critical(file.slope)
    assert found == searching.found(file)
    ground = np.asarray(file.slope.ground)
    section = slipcircle.Section(ground, found.centre, found.radius, 20e3, between=found.between)
    assert section.exit == pytest.approx(found.exit)
    assert section.entry == pytest.approx(found.entry)


def test_what_a_file_says(write: Write) -> None:
    found = slopefile.read(write(
        "name = 'cut'\n[ground]\nheight_m = 10\nangle_deg = 45\nunit_weight_kN_m3 = 19\n"
        "gravity_m_s2 = 9.8\nwidth_m = 40\n"
        "[friction]\ncoefficient = 0.5\n[water]\nlevel_m = [[-60, 8], [-10, 6], [0, -1]]\nunit_weight_kN_m3 = 10\n"
        "[circle]\nthrough_m = [[-14, 10], [0, 0]]\ndepth_m = 3\n[search]\nk_h = 0.1\n"
        "entry_m = [-30, -10]\ndepth_m = 1\n"
    ))  # fmt: skip
    assert found.name == "cut"
    assert np.asarray(found.slope.ground)[1] == pytest.approx([-10.0, 10.0])
    assert (found.slope.cohesion, found.slope.friction, found.slope.unit_weight) == (0.0, 0.5, 19e3)
    assert (found.slope.k_h, found.slope.water_unit_weight) == (0.1, 10e3)
    assert found.limits == {"entry": (-30.0, -10.0), "depth": 1.0}
    assert found.section is not None
    assert (found.section.gravity, found.section.width, found.section.facing) == (9.8, 40.0, 1)
    assert found.section.sagitta == pytest.approx(3.0)
    assert float(np.max(found.section.mean_pressure(0.0))) > 0.0
    touching = slopefile.read(write(ACADS + "[circle]\nthrough_m = [[30, 25], [55, 35]]\ntouching_m = 24\n")).section
    assert touching is not None
    assert float(np.asarray(touching.centre)[1]) - float(np.asarray(touching.radius)) == pytest.approx(24.0)
    assert slopefile.read(write(ACADS.replace("angle_deg = 19.6", "coefficient = 0.3"))).slope.friction == 0.3
    assert slopefile.read(write(ACADS)).slope.friction == pytest.approx(math.tan(math.radians(19.6)))
    assert slopefile.read(write(ACADS + '[circle]\ncritical = "ordinary"\n')).method == "ordinary"


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("unit_weight_kN_m3 = 20", "unit_weight_kN_m3 = 19500", "is that in N/m3"),
        ("unit_weight_kN_m3 = 20", "", "unit_weight_kN_m3: is missing"),
        ("angle_deg = 19.6", "coefficient = 10", "say angle_deg"),
        ("angle_deg = 19.6", "angle_deg = 19.6\ncoefficient = 0.3", "do not go together"),
        ("angle_deg = 19.6", "angle = 19.6", "did you mean angle_deg"),
        ("[friction]\nangle_deg = 19.6", "", "friction: something is missing"),
        ("[cohesion]", "[cohesoin]", "did you mean cohesion"),
        ("cohesion_kPa = 3", "cohesion_kPa = 300000", "is that in Pa"),
        ("cohesion_kPa = 3", "cohesion_kPa = '3'", "must be a number"),
        ("points_m", "points", "did you mean points_m"),
        ("[30, 25], [50, 35]", "[50, 35], [30, 25]", "order them by x"),
        ("[30, 25]", "[30]", "a list of points"),
        ("base_m = 20", "base_m = 30", "ground.base_m = 30: must lie below the ground"),
        ("base_m = 20", "base_m = 20\nheight_m = 3", "do not go together"),
        ("cohesion_kPa = 3\n", "cohesion_kPa = 3\n[circle]\ncentre_m = [1]\nradius_m = 3\n", "two numbers"),
        ("cohesion_kPa = 3\n", "cohesion_kPa = 3\n[circle]\ncentre_m = [29, 90]\nradius_m = 3\n", "misses the ground"),
        ("cohesion_kPa = 3\n", "cohesion_kPa = 3\n[circle]\ncritical = 'bishp'\n", "did you mean bishop"),
        ("cohesion_kPa = 3\n", "cohesion_kPa = 3\n[search]\nk_h = 4\n", "a share of g"),
        ("cohesion_kPa = 3\n", "cohesion_kPa = 3\n[water]\nlevel_m = [[0, 26], [90, 26]]\n", "water.level_m: stands"),
        ("[ground]", "[ground", "is not TOML"),
    ],
)  # fmt: skip
def test_mistakes_are_told_with_their_fix(write: Write, old: str, new: str, words: str) -> None:
    assert old in ACADS
    with pytest.raises(ValueError, match=words) as raised:
        slopefile.read(write(ACADS.replace(old, new)))
    assert str(raised.value).startswith(str(write.path))


def test_all_mistakes_at_once(write: Write) -> None:
    text = ACADS.replace("= 20", "= 19500", 1).replace("19.6", "196").replace("[cohesion]", "[cohesoin]")
    with pytest.raises(ValueError, match="cohesoin") as raised:
        slopefile.read(write(text))
    assert len(str(raised.value).splitlines()) == 3
