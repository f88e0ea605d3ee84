"""Free water above the ground: statics against plain slices, refusals, and what is printed of it."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

from slipcircle import LayeredSection, Scene, Section, Slope, Soil, Status, critical, solve
from slipcircle.__main__ import main
from slipcircle.base.kinds import Floats
from slipcircle.workbench.files.scenefile import critical_of_file
from slipcircle.workbench.outputs.page import section as livesection
from slipcircle.workbench.outputs.page.model import default_sliders
from slipcircle.workbench.stability.critical import at_circle
from tests.campaigns import combined

WATER = 9810.0
TURNING = ["rotation", "centripetal"]
DAM = [(-40.0, 0.0), (0.0, 0.0), (40.0, 16.0), (50.0, 16.0), (90.0, 0.0), (130.0, 0.0)]
Pond = tuple[float, float, float]


class Truth(NamedTuple):
    """A slope of one soil with its water, and factors by plain slices; ``reference`` is the level at the exit."""

    ground: list[tuple[float, float]]
    centre: tuple[float, float]
    radius: float
    ends: tuple[float, float]  # x of the arc's ends
    facing: float
    head: list[tuple[float, float]] | None = None  # pore pressure below this line, or
    ratio: float = 0.0
    ponds: tuple[Pond, ...] = ()
    reference: float = -math.inf
    cohesion: float = 8e3
    friction: float = 0.5
    unit_weight: float = 2e4

    def factors(self, count: int = 12_000) -> dict[str, float]:
        """Return factors by the definitions of the methods; pressures of free water are integrated edge by edge."""
        (x_c, y_c), r = self.centre, self.radius
        first, last = (math.asin((x - x_c) / r) for x in self.ends)
        step = (last - first) / count
        angle = first + step * (np.arange(count) + 0.5)
        x, y = x_c + r * np.sin(angle), y_c - r * np.cos(angle)
        dip, length, breadth = self.facing * -angle, r * step, r * step * np.cos(angle)
        top = np.interp(x, *np.transpose(self.ground))
        slope = (
            np.interp(x + 1e-6, *np.transpose(self.ground)) - np.interp(x - 1e-6, *np.transpose(self.ground))
        ) / 2e-6
        soil = self.unit_weight * (top - y)
        pore = self.ratio * soil
        if self.head:
            pore = pore + WATER * np.maximum(np.interp(x, *np.transpose(self.head)) - y, 0.0)
        water = sum((WATER * np.maximum(z - top, 0.0) * ((a < x) & (x < b)) for a, b, z in self.ponds), np.zeros(count))
        drive = self.facing * float(np.sum(-(x - x_c) * soil * breadth)) + self.facing * self.moment_of_ponds()
        # Below the reference level weights are those of buoyant soil; other free water is a load normal to the ground.
        buoyant = WATER * np.maximum(np.minimum(top, self.reference) - y, 0.0)
        excess = pore - WATER * np.maximum(self.reference - y, 0.0)
        load = water - WATER * np.maximum(self.reference - top, 0.0)
        x_load, y_load = load * slope * breadth, -load * breadth
        to_base = x_load * np.sin(angle) - y_load * np.cos(angle)
        normal = ((soil - buoyant) * breadth * np.cos(dip) + to_base) / length - excess
        ordinary = np.sum(self.cohesion + self.friction * normal) * length * r / drive
        # The paper: every point of the mass presses with its weight times the cosine of its direction (2.23).
        radial = (
            self.radial(x, y, top) * self.unit_weight
            - self.radial(x, y, np.maximum(y, np.minimum(top, self.reference))) * WATER
        )
        distance = np.hypot(x - x_c, top - y_c)
        of_load = (x_load * (x - x_c) + y_load * (top - y_c)) / distance
        friction = self.friction * (np.sum(radial * breadth + of_load) - np.sum(excess) * length)
        paper = (self.cohesion * length * count + max(friction, 0.0)) * r / drive
        factor = 1.0
        for _ in range(40):
            lever = np.cos(dip) + np.sin(dip) * self.friction / factor
            shear = (self.cohesion + self.friction * (soil + water - pore)) * breadth / lever
            factor = float(np.sum(shear) * r / drive)
        return {"paper": float(paper), "ordinary": float(ordinary), "bishop": factor}

    def radial(self, x: Floats, low: Floats, high: Floats) -> Floats:
        """Integral of the cosine of the direction from the centre over heights."""
        (x_c, y_c) = self.centre
        return np.hypot(x - x_c, low - y_c) - np.hypot(x - x_c, high - y_c)

    def moment_of_ponds(self) -> float:
        """Return the moment of the pressure on the ground, positive counterclockwise: -int p d(rho^2/2)."""
        (x_c, y_c), moment = self.centre, 0.0
        left, right = self.ends
        for a, b, z in self.ponds:
            inner = [p for p, _ in self.ground if max(a, left) < p < min(b, right)]
            places = np.unique(np.concatenate([np.linspace(u, v, 4001) for u, v in zip(
                [max(a, left), *inner], [*inner, min(b, right)], strict=True)]))  # fmt: skip
            heights = np.interp(places, *np.transpose(self.ground))
            square = (places - x_c) ** 2 + (heights - y_c) ** 2
            pressure = WATER * np.maximum(z - heights, 0.0)
            moment -= float(np.sum((pressure[1:] + pressure[:-1]) / 2 * np.diff(square) / 2))
        return moment

    def slope(self, **more: Any) -> Slope:
        return Slope(self.ground, self.cohesion, self.friction, self.unit_weight, **more)

    def section(self, **more: Any) -> Section:
        return Section(self.ground, self.centre, self.radius, self.unit_weight, **more)


def through(x: tuple[float, float], ground: Any, radius: float) -> tuple[tuple[float, float], float]:
    """Return the circle above two points of the ground."""
    p, q = (np.array([v, np.interp(v, *np.transpose(ground))]) for v in x)
    chord = q - p
    normal = np.array([-chord[1], chord[0]]) / np.hypot(*chord)
    centre = (p + q) / 2 + normal * math.sqrt(radius**2 - float(chord @ chord) / 4)
    return (float(centre[0]), float(centre[1])), radius


def of(ends: tuple[float, float], radius: float, facing: float, ground: Any = DAM, **more: Any) -> Truth:
    return Truth(ground, *through(ends, ground, radius), ends, facing, **more)


# Upstream at 12 m, downstream at 3 m: from the crest into the pond, from one pond to the other, and dry at the exit.
SEEPS = [(-40.0, 12.0), (30.0, 12.0), (82.5, 3.0), (130.0, 3.0)]
BOTH = ((-40.0, 30.0, 12.0), (82.5, 130.0, 3.0))
ARTESIAN = [(-40.0, 14.0), (130.0, 5.0)]
WAVES = [(-10.0, 12.0), (0.0, 12.0), (8.0, 6.0), (12.0, 9.0), (20.0, 5.0), (24.0, 8.0), (36.0, 0.0), (60.0, 0.0)]
LAKES = [(-10.0, 10.0), (4.0, 8.0), (11.0, 8.0), (14.0, 6.5), (22.5, 6.5), (34.5, 1.0), (60.0, 1.0)]
ON_WAVES = ((16 / 3, 32 / 3, 8.0), (17.0, 22.0, 6.5), (34.5, 60.0, 1.0))
CASES: dict[str, tuple[Truth, dict[str, Any]]] = {
    "into the lower pond": (of((42, 95), 45.0, 1.0, head=SEEPS, ponds=BOTH, reference=3.0), {"level": SEEPS}),
    "from pond to pond": (of((24, 97), 60.0, 1.0, head=SEEPS, ponds=BOTH, reference=3.0), {"level": SEEPS}),
    "into the upper pond": (of((-6, 46), 40.0, -1.0, head=SEEPS, ponds=BOTH, reference=12.0), {"level": SEEPS}),
    "dry at the exit": (of((26, 76), 45.0, 1.0, head=SEEPS, ponds=BOTH), {"level": SEEPS}),
    "r_u below ponds": (
        of((24, 97), 60.0, 1.0, ratio=0.2, ponds=BOTH, reference=3.0),
        {"pore_ratio": 0.2, "ponds": [(-40, 30, 12), (82, 130, 3)]},
    ),
    "artesian below ponds": (
        of((24, 97), 60.0, 1.0, head=ARTESIAN, ponds=BOTH, reference=3.0),
        {"level": ARTESIAN, "confined": True, "ponds": [(-40, 31, 12), (80, 130, 3)]},
    ),
    "three lakes": (of((-5, 45), 40.0, 1.0, WAVES, head=LAKES, ponds=ON_WAVES, reference=1.0), {"level": LAKES}),
    "out of a lake": (of((-5, 21.8), 17.0, 1.0, WAVES, head=LAKES, ponds=ON_WAVES, reference=6.5), {"level": LAKES}),
    "artesian": (
        of((42, 95), 45.0, 1.0, head=[(-40, 14), (130, 5)]),
        {"level": [(-40, 14), (130, 5)], "confined": True},
    ),
}


def mirrored(value: Any) -> Any:
    """Lines, ponds or numbers seen from behind."""
    if np.ndim(value) == 2 and np.shape(value)[1] == 2:
        return [(-x, y) for x, y in value[::-1]]
    if np.ndim(value) == 2:
        return [(-b, -a, z) for a, b, z in value]
    return value


def shifted(value: Any, by: float) -> Any:
    if np.ndim(value) == 2:
        return [(*(x + by for x in row[:-1]), row[-1]) for row in value]
    return value


@pytest.mark.parametrize("name", CASES)
def test_factors_are_those_of_plain_slices(name: str) -> None:
    """Factors on both sides of a dam, each with its level, also seen from behind and in map coordinates."""
    truth, water = CASES[name]
    expected = truth.factors()
    geometry = truth.section()
    assert at_circle(truth.slope(**water), geometry).factors_of_safety == pytest.approx(expected, rel=5e-6)
    x, y = truth.centre
    behind = Section(mirrored(truth.ground), (-x, y), truth.radius, 1.0)
    slope = Slope(mirrored(truth.ground), 8e3, 0.5, 2e4, **{key: mirrored(value) for key, value in water.items()})
    assert at_circle(slope, behind).factors_of_safety == pytest.approx(expected, rel=5e-6)
    for by in (5e5, 5e6):
        far = Section(shifted(truth.ground, by), (x + by, y), truth.radius, 1.0)
        slope = Slope(
            shifted(truth.ground, by), 8e3, 0.5, 2e4, **{key: shifted(value, by) for key, value in water.items()}
        )
        assert at_circle(slope, far).factors_of_safety == pytest.approx(expected, rel=5e-6)


# --- files -----------------------------------------------------------------------------------------------------------

SLOPE = """[ground]
points_m = [[0, 10], [20, 10], [40, 0], [80, 0]]
unit_weight_kN_m3 = 20
[friction]
angle_deg = 28
[cohesion]
cohesion_kPa = 10
[circle]
centre_m = [34, 22]
radius_m = 26
[water]
level_m = LEVEL
"""
PIEZOMETRIC = "[[0, 6], [20, 5], [40, 1.5], [80, 1.5]]\nconfined = true\n"
EARTH_DAM = """[ground]
points_m = [[-45.72, 69.1896], [0, 69.1896], [82.296, 96.6216], [97.536, 96.6216], [179.832, 69.1896],
            [225.552, 69.1896]]
[water]
level_m = [[-45.72, 92.0496], [84.582, 92.0496], [96.012, 83.82], [104.6988, 73.152], [179.832, 69.1896],
           [225.552, 69.1896]]
unit_weight_kN_m3 = 9.8023
[circle]
centre_m = [149.352, 152.4]
radius_m = 92.3544
[soils]
shell = { unit_weight_kN_m3 = 19.6359, friction = { angle_deg = 34 } }
core = { unit_weight_kN_m3 = 19.1647, cohesion_kPa = 4.788, friction = { angle_deg = 26 } }
clay = { unit_weight_kN_m3 = 19.3218, friction = { angle_deg = 24 } }
sand = { unit_weight_kN_m3 = 19.9501, friction = { angle_deg = 32 } }
[[layers]]
soil = "shell"
[[layers]]
soil = "core"
top_m = [[-45.72, 69.1896], [73.152, 69.1896], [85.344, 93.5736], [94.488, 93.5736], [106.68, 69.1896],
         [225.552, 69.1896]]
[[layers]]
soil = "clay"
top_m = 69.1896
[[layers]]
soil = "sand"
top_m = 60.0456
"""  # fmt: skip


def found(text: str, tmp_path: Path) -> Any:
    """Return the circle of a file and its warnings."""
    path = tmp_path / "slope.toml"
    path.write_text(text, "utf-8")
    return critical_of_file(path, None, lambda line: None)[2]


@pytest.mark.parametrize(
    ("text", "bishop", "ordinary"),
    [  # of an independent program of slices
        (EARTH_DAM, 1.563, 1.402),
        (SLOPE.replace("LEVEL", PIEZOMETRIC), 1.525, None),
        (SLOPE.replace("LEVEL", PIEZOMETRIC) + "[[pond]]\nfrom_m = 37\nto_m = 80\nlevel_m = 1.5\n", 1.690, None),
        (SLOPE.replace("LEVEL", "[[0, 6], [25, 5], [30, 5], [40, 0], [80, 0]]"), 1.545, None),
    ],
)
def test_free_water_lies_where_the_level_is_above_the_ground(
    text: str, bishop: float, ordinary: float | None, tmp_path: Path
) -> None:
    """Upstream of a dam alone; nowhere below an artesian level."""
    factors = found(text, tmp_path).factors_of_safety
    assert factors["bishop"] == pytest.approx(bishop, abs=5e-4)
    assert ordinary is None or factors["ordinary"] == pytest.approx(ordinary, abs=5e-4)


@pytest.mark.parametrize(
    ("level", "words"),
    [
        (
            "[[0, 6], [25, 5]]",
            r"water\.level_m: ends at x = 25, above the mass from x = 10\.9349 to 47\.8564; extend it",
        ),
        ("[[0, 6], [25, 5], [40, 5]]", r"water\.level_m: ends at x = 40, above the mass"),
        ("[[12, 5], [40, 0], [80, 0]]", r"water\.level_m: ends at x = 12, above the mass"),
        (
            PIEZOMETRIC.partition("confined")[0],
            r"level_m: varies by 0\.8\d* m .* level there, or water\.confined = true",
        ),
        (
            "[[0, 6], [80, 0]]\n[pond]\nlevel_m = 1",
            r"pond: \[pond\] is not a table any more: .*write \[\[pond\]\] with",
        ),
    ],
)
def test_a_level_of_which_something_would_be_guessed_is_refused(level: str, words: str, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=words):
        found(SLOPE.replace("LEVEL", level), tmp_path)


def test_ponds_are_printed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "dam.toml").write_text(EARTH_DAM, "utf-8")
    assert main(["search", str(tmp_path / "dam.toml")]) == 0
    ((line,),) = [[x for x in capsys.readouterr().out.splitlines() if "free water" in x]]
    assert line.split(maxsplit=2)[2] == "x = -45.72 to 68.58 m, level 92.0496 m"
    assert main(["search", str(tmp_path / "dam.toml"), "--json"]) == 0
    (record,) = json.loads(capsys.readouterr().out)
    assert record["free_water"] == [pytest.approx([-45.72, 68.58, 92.0496])]


# --- circles and coordinates ------------------------------------------------------------------------------------------

ACADS = "[ground]\npoints_m = [[0, 25], [30, 25], [50, 35], [90, 35]]\nunit_weight_kN_m3 = 20\nbase_m = BASE\n"
WEAK = "[friction]\nangle_deg = 19.6\n[cohesion]\ncohesion_kPa = 3\n[circle]\n"


@pytest.mark.parametrize("base", ["20", "24.5"])
def test_the_circle_that_search_prints_can_be_pasted(
    base: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """It cuts a sliver off the ground at the toe, or falls below the base that it touches, by rounding."""
    text = (ACADS + WEAK).replace("BASE", base)
    path = tmp_path / "slope.toml"
    path.write_text(text + "critical = 'bishop'\n", "utf-8")
    assert main(["search", str(path)]) == 0
    rows = dict(re.findall(r"^(.*?)  +(.*?) m$", capsys.readouterr().out, re.MULTILINE))
    pasted = f"centre_m = [{rows['centre']}]\nradius_m = {rows['radius']}\n"
    least = found(text + "critical = 'bishop'\n", tmp_path).factors_of_safety["bishop"]
    assert found(text + pasted, tmp_path).factors_of_safety["bishop"] == pytest.approx(least, rel=2e-3)
    ends = sorted(float(rows[name].partition(",")[0]) for name in ("entry", "exit"))
    found(text + pasted + f"between_m = {ends}\n", tmp_path)
    with pytest.raises(ValueError, match=r"circle.between_m = \[35, 52\]: does not contain the mass from x = "):
        found(text + pasted + "between_m = [35, 52]\n", tmp_path)


@pytest.mark.parametrize("by", [5e5, -5e6])
def test_a_search_in_map_coordinates_is_the_same(by: float) -> None:
    """1.1196: `utm-search` of an independent program; also seen from behind."""
    ground = [(0.0, 10.0), (15.0, 10.0), (35.0, 0.0), (60.0, 0.0)]
    given: dict[str, Any] = {"cohesion": 5e3, "friction": math.tan(math.radians(20)), "unit_weight": 2e4}
    circle = critical(Slope(shifted(ground, by), **given))
    assert circle.factors_of_safety["bishop"] == pytest.approx(1.1196, abs=5e-5)
    assert critical(Slope(mirrored(shifted(ground, by)), **given), depth=1.0).factors_of_safety == pytest.approx(
        circle.factors_of_safety, rel=1e-5
    )
    with pytest.raises(ValueError, match="below the size of the ground"):
        critical(Slope(shifted(ground, by), **given), depth=61.0)


# --- motions in standing water ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("layers", [{}, {"layers": [(Soil(2e4, 2e3, 0.2, name="soil"), None)]}])
def test_a_drowned_slide_is_the_buoyant_one_but_for_its_inertia(layers: Any) -> None:
    """Weight g' = g - g_w and inertia g scale E = omega^2 by g'/g everywhere, so that the run-out is the same."""
    peaks = []
    for weight, level in ((2e4, [(-40, 60), (130, 60)]), (2e4 - WATER, None)):
        if layers:
            soil = Soil(weight, 2e3, 0.2, name="soil")
            scene = Scene(LayeredSection(DAM, (82, 44), 44.0, level=level, layers=[(soil, None)]), effects=TURNING)
        else:
            effects: dict[str, Any] = {name: {} for name in TURNING} | {"cohesion": {"cohesion": 2e3}}
            scene = Scene(Section(DAM, (82, 44), 44.0, weight, level=level), 0.2, effects)
        motion = solve(scene)
        peaks.append(
            (motion.run_out, motion.peak.velocity * (1.0 if level is None else math.sqrt(weight / (weight - WATER))))
        )
    (run_out, velocity), (buoyant, of_buoyant) = peaks
    assert run_out == pytest.approx(buoyant, rel=1e-12)
    assert velocity == pytest.approx(of_buoyant, rel=1e-12)


def test_water_that_comes_to_cover_the_whole_mass_is_refused_or_a_status() -> None:
    """The crest sinks below one of two levels; an earlier end leaves both with a result."""
    ground = [(-60, 12.0), (0, 12.0), (40, 0.0), (120, 0.0)]
    levels = np.array([[(-60.0, y), (120.0, y)] for y in (11.5, 4.0)])
    high, both = (Section(ground, (22, 25), 29.0, 2e4, level=level) for level in (levels[0], levels))
    with pytest.raises(ValueError, match=r"level: standing water comes to cover the whole mass, .* earlier end_time"):
        solve(Scene(high, 0.15, TURNING))
    motion = solve(Scene(both, 0.15, TURNING))
    assert motion.status.tolist() == [Status.DROWNED, Status.RESTS]
    assert np.isnan(motion.run_out).tolist() == [True, False]
    assert motion.count() == {"RESTS": 1, "DROWNED": 1}
    lanes = solve(Scene(high, np.array([0.15, 0.33]), TURNING))
    assert lanes.status.tolist() == [Status.DROWNED, Status.STAYS]
    assert solve(Scene(high, 0.15, TURNING, end_time=0.5)).status == Status.MOVING


def test_a_motion_takes_free_water_of_one_level() -> None:
    for ends, words in (
        ((24, 97), r"y = 12 covers the mass, and free water at y = 3 its exit"),
        ((26, 76), "not its exit"),
    ):
        truth = of(ends, 60.0, 1.0)
        with pytest.raises(ValueError, match=words):
            Scene(truth.section(level=SEEPS), 0.3, TURNING)


def test_standing_water_is_told_of(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    weak = SLOPE.replace("angle_deg = 28", "angle_deg = 12").replace("LEVEL", "[[0, 6], [20, 5], [38, 1], [80, 1]]")
    (tmp_path / "pool.toml").write_text(weak + "[rotation]\n", "utf-8")
    assert main(["run", str(tmp_path / "pool.toml")]) == 0
    printed = capsys.readouterr()
    assert "whose drag and added mass are not included" in printed.err
    assert "below the water level" not in printed.err
    assert main(["run", str(tmp_path / "pool.toml"), "--verbose"]) == 0
    assert "x = 38 to 80 m, level 1 m" in capsys.readouterr().out


def test_pages_and_pictures_are_the_same_in_map_coordinates(tmp_path: Path) -> None:
    """Lines of the page's section, and the frame of the picture."""
    pool = next(x for x, _ in combined.motions(5, tmp_path) if x.count == 1 and x.level and x.level[-1][1] > 0.0)
    drawings, frames = [], []
    for pool.shift in (0.0, 5e6):
        motion = solve(combined.read(pool, tmp_path))
        section = livesection.drawn_section(motion, livesection.frame_around(motion, 1.0), 1.0, "pool")
        paths = re.findall(r'<path class="(?:soil|body|slip|water|circle)" d="([^"]*)"', str(section))
        drawings.append([float(number) for number in re.findall(r"-?\d+\.\d+", " ".join(paths))])
        axes = motion.plot("section")
        frames.append([*(np.array(axes.get_xlim()) - pool.shift), *axes.get_ylim()])
    near, far = drawings
    assert len(near) > 20
    assert far == pytest.approx(near, abs=0.02)
    assert frames[1] == pytest.approx(frames[0], abs=1e-3)


def test_the_total_stress_includes_the_weight_of_free_water() -> None:
    """Total less effective stress is the mean pore pressure: none below a pond on dry soil, else that of the level."""
    ground, circle = [(-24, 20), (0, 20), (40, 0), (60, 0)], ((26.0, 34.0), 38.0, 19e3)
    pond = solve(Scene(Section(ground, *circle, ponds=[(30.0, 60.0, 5.0)]), 0.1, ["rotation"]))
    times = np.linspace(0.0, float(pond.duration), 5)
    assert pond.at(times).normal_stress == pytest.approx(pond.effective_stress_at(times), rel=1e-9)
    assert pond.peak.normal_stress == pytest.approx(float(pond.effective_stress_at(pond.peak.time)), rel=1e-9)
    section = Section(ground, *circle, level=[(-24, 12), (0, 12), (30, 5), (60, 5)])
    slide = solve(Scene(section, 0.1, ["rotation"]))
    ends = np.array([section.entry, section.exit]) - [26.0, 34.0]
    first, last = sorted(np.arctan2(ends[:, 1], ends[:, 0]).tolist())
    angles = np.linspace(first, last, 200_001)
    heights = 34.0 + 38.0 * np.sin(angles)
    head = np.interp(26.0 + 38.0 * np.cos(angles), [-24, 0, 30, 60], [12, 12, 5, 5]) - heights
    mean = float(np.mean(np.maximum(head, 0.0))) * section.water_unit_weight
    assert float(slide.pore_pressure_at(0.0)) == pytest.approx(mean, rel=1e-4)
    together = solve(Scene(section, np.array([0.1, 0.12]), ["rotation"]))
    times = np.linspace(0.0, float(slide.duration), 4)
    assert together.at(times).normal_stress[0] == pytest.approx(slide.at(times).normal_stress, rel=1e-9)


def test_a_page_of_a_slope_with_free_water_starts_by_bishop() -> None:
    """Lanes have arcs of their own, as many as the sliders have positions."""
    slope = Slope([[-24, 20], [0, 20], [40, 0], [60, 0]], 2e3, 0.32, 19e3, level=[[-24, 14], [0, 12], [30, 5], [60, 5]])
    scene = critical(slope).scene(["rotation"])
    assert [one.number.name for one in default_sliders(scene)]


def test_a_pond_stands_at_an_exit_without_a_water_level() -> None:
    ground = [(-60.0, 20.0), (0.0, 20.0), (40.0, 0.0), (80.0, 0.0), (90.0, 5.0), (120.0, 5.0)]
    shores = 40.0 - 2.0 * 3.0, 80.0 + 2.0 * 3.0, 3.0  # y = 3 on slopes of 1 in 2
    section = Section(ground, (30, 45), 48.0, 19e3, ponds=[shores])
    assert section.standing_level == (3.0 - 45.0) / 48.0
    assert section.in_standing_water


@pytest.mark.parametrize("facing", [1.0, -1.0])
def test_a_pond_covers_an_exit_at_the_foot_of_a_quay(facing: float) -> None:
    """The exit and the shore have the same x, which the exit may miss by rounding."""
    ground = [(-60.0, 12.0), (-20.0, 12.0), (0.0, 5.0), (0.0, 0.0), (60.0, 0.0)]
    pond = [(0.0, 60.0, 4.0)]
    if facing < 0.0:
        ground, pond = mirrored(ground), mirrored(pond)
    section = Section(ground, (-2.0 * facing, 18.0), math.hypot(2.0, 18.0), 19e3, ponds=pond)
    assert section.standing_level == pytest.approx((4.0 - 18.0) / math.hypot(2.0, 18.0), rel=1e-15)
