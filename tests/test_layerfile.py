"""Layered ground from a scene file: what it says is what moves, numbers by soil, and what a wrong file is told."""

import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import slipcircle
from slipcircle.core import Scene
from slipcircle.layers import LayeredSection, Soil
from slipcircle.workbench.files.loaded import warnings_of
from slipcircle.workbench.files.scenefile import critical_of_file
from slipcircle.workbench.files.shipped import find
from slipcircle.workbench.stability.critical import at_circle
from slipcircle.workbench.stability.stability import Slope
from slipcircle.workbench.studies.ensemble import grid
from tests.support.motions import from_method

Write = Callable[..., str]

GROUND = "[ground]\npoints_m = [[-60, 20], [0, 20], [40, 0], [120, 0]]\n"
SOILS = """\
[soils.sand]
unit_weight_kN_m3 = 18
friction = { angle_deg = 28 }
[soils."soft clay"]
unit_weight_kN_m3 = 17
cohesion_kPa = 25
cohesion_per_m_kPa = 1.5
[soils.clay]
unit_weight_kN_m3 = 19
saturated_unit_weight_kN_m3 = 20
friction = { law = "exponential", peak_deg = 24, residual_deg = 20, length_m = 0.8 }
pore_pressure_ratio = 0.1
"""
LAYERS = """\
[[layers]]
soil = "sand"
[[layers]]
soil = "clay"
top_m = [[-60, 18.5], [10, 18.5], [20, 12]]
[[layers]]
soil = "soft clay"
top_m = 2
"""
CIRCLE = "[circle]\ncentre_m = [30, 45]\nradius_m = 48\n"
LOAD = "[[surcharge]]\nfrom_m = -15\nto_m = -5\npressure_kPa = [20, 40]\n"
SCENE = f"{GROUND}{SOILS}{LAYERS}{CIRCLE}[rotation]\n[centripetal]\n"


@pytest.fixture
def write(tmp_path: Path) -> Write:
    """Write a file of parts; returns its path."""

    def to_file(*parts: str) -> str:
        path = tmp_path / "layers.toml"
        path.write_text("".join(parts), "utf-8")
        return str(path)

    return to_file


def factors(path: str) -> dict[str, float]:
    """Factors of safety of a file's circle by method."""
    found = critical_of_file(path, None, lambda line: None)[2].factors_of_safety
    return {method: factor or math.nan for method, factor in found.items()}


STATICS = """[[pond]]
from_m = 30
to_m = 120
level_m = 3
[tension_crack]
depth_m = 1
water_m = 0.5
[search]
k_h = 0.1
k_h_on_surcharge = true
"""


@pytest.mark.parametrize(("strength", "slip"), [("base", ""), ("mass", '[slip]\nstrength = "mass"\n')])
def test_a_file_is_the_section_that_it_describes(write: Write, strength: str, slip: str) -> None:
    """Defaults: cohesion grows from the top of the soil's layer, strength goes with the base."""
    peak, residual, sand_friction = np.tan(np.deg2rad([24, 20, 28])).tolist()
    law = {"law": "exponential", "peak": peak, "residual": residual, "length": 0.8}
    soils = (
        Soil(18e3, 0.0, sand_friction, name="sand"),
        Soil(19e3, 0.0, law, 20e3, pore_ratio=0.1, name="clay"),
        Soil(17e3, 25e3, 0.0, cohesion_gradient=1.5e3, name="soft clay"),
    )
    layers = list(zip(soils, (None, [(-60, 18.5), (10, 18.5), (20, 12)], 2.0), strict=True))
    ground, surcharge = [(-60, 20), (0, 20), (40, 0), (120, 0)], [(-15, -5, 2e4, 4e4)]
    section = LayeredSection(ground, (30, 45), 48.0, strength=strength, surcharge=surcharge, layers=layers)
    read = from_method(slipcircle.load(write(SCENE, LOAD, slip)), "paper")
    expected, motion = map(slipcircle.solve, (Scene(section, effects=["rotation", "centripetal"]), read))
    for name in ("run_out", "factor_of_safety"):
        assert getattr(motion, name) == pytest.approx(getattr(expected, name), rel=1e-13)
    slope = Slope(ground, layers=layers, surcharge=surcharge, ponds=[(30, 120, 3)], crack=1.0, crack_water=0.5, k_h=0.1,
                  k_h_on_surcharge=True)  # fmt: skip
    assert factors(write(SCENE, LOAD, slip, STATICS)) == pytest.approx(at_circle(slope, section).factors_of_safety)


RATE = '[slip.rate]\nlaw = "rate_weakening"\npeak = 1\nresidual = 0.9\nvelocity_m_s = 0.5\n'
NUMBERED = SCENE + LOAD + "[tension_crack]\ndepth_m = 1\n" + RATE
LOWERED = ("[[-60, 18.5], [10, 18.5], [20, 12]]", "[[-60, 17.5], [10, 17.5], [20, 11]]")


@pytest.mark.parametrize(
    ("key", "value", "changed"),
    [
        ("soils.clay.friction.peak_deg", 23.0, ("peak_deg = 24", "peak_deg = 23")),
        ("soils.soft clay.cohesion_kPa", 24.0, ("cohesion_kPa = 25", "cohesion_kPa = 24")),
        ("layers.3.top_m", 2.5, ("top_m = 2\n", "top_m = 2.5\n")),  # below which the cohesion grows
        ("surcharge.1.pressure_kPa", 60.0, ("[20, 40]", "[30, 60]")),
        ("tension_crack.depth_m", 1.5, ("depth_m = 1\n", "depth_m = 1.5\n")),
        ("layers.2.top_m", 17.5, LOWERED),
        ("slip.rate.residual", 0.8, ("residual = 0.9", "residual = 0.8")),
    ],
)
def test_numbers_have_names_by_soil_in_every_study(
    write: Write, key: str, value: float, changed: tuple[str, str]
) -> None:
    scene = NUMBERED if "layers.2" not in key else SCENE
    study = grid(slipcircle.load(write(scene)), {key: [value]})
    assert scene.count(changed[0]) == 1
    motion = slipcircle.solve(slipcircle.load(write(scene.replace(*changed))))
    assert float(study.samples["run_out"][0]) == pytest.approx(motion.run_out, rel=1e-9)


def test_each_soil_may_have_a_law_of_its_own(write: Write) -> None:
    """A sum of them in the plan; refused with the strength of the base."""
    table = 'friction = { law = "tabulated", slip_m = [0, 1, 3], angle_deg = [28, 25, 23] }'
    slip = '[slip]\nstrength = "{}"\n'
    scene = SCENE.replace("friction = { angle_deg = 28 }", table)
    plan = slipcircle.solve(slipcircle.load(write(scene, slip.format("mass")))).plan
    assert "mu_1 = mu(slip)" in str(plan.equation)
    assert "mu_2 = residual_2 + (peak_2 - residual_2) exp(-slip/length_2)" in str(plan.equation)
    latex = r"\mu_{2} &= \mu_{r,2} + \left(\mu_{p,2} - \mu_{r,2}\right) e^{- \frac{S}{L_{2}}}"
    assert latex in plan.equation.latex
    assert plan.law == "tabulated, exponential, constant by soil"
    with pytest.raises(ValueError, match=r"with slip\.strength = 'mass' each may have a law of its own"):
        slipcircle.load(write(scene, slip.format("base")))


def test_what_motions_do_not_know_is_searched_and_not_run(write: Write, refused: Any) -> None:
    assert "tension_crack.water_m: is for factors of safety alone" in refused("run", write(SCENE, STATICS))


def test_a_shaken_motion_says_whose_loads_its_start_has(write: Write, said: Any) -> None:
    pulse = '[shaking]\npulse = "half-sine"\namplitude_g = 0.2\nduration_s = 1\n'
    words = "as in the motion, also for k_y"
    assert words in said("run --verbose", write(SCENE, LOAD, pulse))
    assert words not in said("run --verbose", write(SCENE, LOAD)) + said("run --verbose", write(SCENE, pulse))


def test_a_boundary_above_another_is_cut_off_and_said(write: Write, asked: Any) -> None:
    crossing = SCENE.replace("[[-60, 18.5], [10, 18.5], [20, 12]]", "[[-60, 18.5], [10, 18.5], [20, 1]]")
    path = write(crossing)
    words = "layers.3.top_m: rises above the top of layer 2, at x = 20; the part above is cut off"
    assert words in asked("search", path)[2]
    assert words in warnings_of(slipcircle.solve(slipcircle.load(path)))
    others = warnings_of(slipcircle.solve(slipcircle.load(write(SCENE))))
    assert [warning.partition(" after ")[0] for warning in others] == ["outside the range of the method"]


BAD = """\
[ground]
points_m = [[-60, 20], [0, 20], [40, 0], [120, 0]]
unit_weight_kN_m3 = 19
[soils.sand]
unit_weight_kN_m3 = 18
friction = { angle_deg = 28 }
[soils.clay]
unit_weight_kN_m3 = 19
cohesion_per_m_kPa = 2
[soils.peat]
unit_weight_kN_m3 = 11
[[layers]]
soil = "sand"
top_m = 20
[[layers]]
soil = "clai"
[[layers]]
soil = "clay"
top_m = [[-60, 2], [120, 1]]
[[surcharge]]
from_m = 3
to_m = 2
pressure_kPa = 10
[slip]
foreland = "gravel"
[friction]
angle_deg = 20
[cohesion]
cohesion_kPa = 2
[pore_pressure]
ratio = 0.1
[circle]
centre_m = [30, 45]
radius_m = 48
"""


def test_every_mistake_between_tables_is_listed(write: Write) -> None:
    with pytest.raises(ValueError, match="friction") as error:
        slipcircle.load(write(BAD))
    for mistake in (
        "friction: is given by the soils beside [[layers]]: [soils.NAME.friction]; leave it out",
        "cohesion: is given by the soils",
        "pore_pressure: is given by the soils",
        "ground.unit_weight_kN_m3: is given by the soils",
        'layers.2.soil = "clai": is not a soil of this file; did you mean clay?',
        'slip.foreland = "gravel": is not a soil of this file; known are sand, clay, peat',
        "soils.peat: is not used by any layer",
        "layers.1.top_m: must be left out",
        "layers.2.top_m: is missing",
        "surcharge.1.to_m = 2: must lie to the right of from_m = 3",
    ):
        assert mistake in str(error.value)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("[soils.sand]", "[soils.sand]\ncohesoin_kPa = 3", r"cohesoin_kPa = 3: .*did you mean cohesion_kPa\?"),
        (GROUND, "ground = 23.9\n", r"ground = 23\.9: must be a table \[ground\]"),
        ("[[layers]]", "[[layer]]", "layer = .*: is unknown; did you mean layers"),
        (LAYERS, '[layers]\nsoil = "sand"\n', r"layers = .*: must be tables \[\[layers\]\]"),
        ("angle_deg = 28", "angle_deg = 95", "soils.sand.friction.angle_deg = 95: must be a number"),
        ('"exponential"', '"exponentail"', "soils.clay.friction.law = .*did you mean exponential"),
        ("residual_deg = 20, ", "", "soils.clay.friction: residual_deg or residual is missing"),
        ("top_m = 2\n", "top_m = [[0, 2]]\n", r"layers.3.top_m = \[\[0, 2\]\]: must be a height"),
        ("[20, 12]]", "[5, 12]]", r"layers.2.top_m\[2\]"),
        ("[rotation]", "[water]\nlevel_m = [[-60, 10], [120, 3]]", "level_m: varies by 3.627 m.*water.confined = true"),
        ("[rotation]", "[tension_crack]\ndepth_m = 30", "tension_crack.depth_m = 30: is deeper than the mass"),
        ("[rotation]", '[slip]\nstrength = "mass"\nforeland = "sand"', "slip.foreland: cannot be combined"),
        ("[rotation]", "[slip]\nstrenght = 'mass'", "did you mean strength"),
        ("saturated_unit_weight_kN_m3 = 20", "saturated_unit_weight_kN_m3 = 20000", "at most 1000; was 20 kN/m3 meant"),
    ],
)  # fmt: skip
def test_one_mistake_names_the_key_as_it_is_typed(write: Write, old: str, new: str, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        slipcircle.load(write(SCENE.replace(old, new)))


def test_one_soil_takes_cracks_loads_and_ponds_in_statics(write: Write, refused: Any) -> None:
    one_soil = f"{GROUND}unit_weight_kN_m3 = 19\n[friction]\nangle_deg = 20\n[cohesion]\ncohesion_kPa = 5\n{CIRCLE}"
    more = f"{LOAD}[tension_crack]\ndepth_m = 1\nwater_m = 0.5\n[[pond]]\nfrom_m = 30\nto_m = 120\nlevel_m = 3\n"
    layered = f"{GROUND}[soils.soil]\nunit_weight_kN_m3 = 19\nfriction = {{ angle_deg = 20 }}\ncohesion_kPa = 5\n"
    layered += f'[[layers]]\nsoil = "soil"\n{CIRCLE}'
    assert factors(write(one_soil, more)) == pytest.approx(factors(write(layered, more)), rel=1e-12)
    error = refused("run", write(one_soil, LOAD))
    assert re.search(r"surcharge: a motion uses it on layered ground only.*\[soils.NAME\].*\[\[layers\]\]", error)


@pytest.mark.parametrize(
    ("name", "old", "new", "words"),
    [
        ("shaken-slope", "amplitude_g = 0.4", "amplitude_g = 35", "no ground has shaken with more than 5 g"),
        ("shaken-slope", "peak_deg = 30", "peak_deg = 20", "friction.peak_deg = 20 deg: below the residual friction"),
        (
            "layered-slope",
            "angle_deg = 30",
            "angle_deg = 0.52",
            "soils.sand.friction.angle_deg = 0.52 deg: an angle of",
        ),
        ("layered-slope", "[rotation]", f"{LOAD.replace('[20, 40]', '20000')}[rotation]", "pressure_kPa = 20000 kPa: "),
        (
            "shaken-slope",
            "cohesion_kPa = 3",
            "cohesion_kPa = 3000",
            "cohesion_kPa = 3000 kPa: soils and loads have less; was 3000 Pa",
        ),
    ],
)
def test_odd_numbers_are_questioned(tmp_path: Path, name: str, old: str, new: str, words: str, asked: Any) -> None:
    """Unusual numbers are reported with the keys and units of the file."""
    path = tmp_path / "scene.toml"
    path.write_text(find(name).read_text("utf-8").replace(old, new), "utf-8")
    assert words in asked("run", path)[2]


def test_a_load_that_acts_on_nothing_is_told(tmp_path: Path, asked: Any) -> None:
    """Outside the ground (0 to 90 m), across its end, beyond the arc, and on the mass."""
    path = tmp_path / "scene.toml"
    loads = [(150, 160), (85, 95), (70, 75), (40, 75)]
    tables = "".join(f"\n[[surcharge]]\nfrom_m = {x}\nto_m = {y}\npressure_kPa = 20\n" for x, y in loads)
    path.write_text(find("layered-slope").read_text("utf-8") + tables, "utf-8")
    for command in ("run", "search"):
        lines = re.findall(r"surcharge\.(\d): (?:lies|its part) beside the (\w+)", asked(command, path)[2])
        assert lines == [("1", "ground"), ("2", "ground"), ("2", "mass"), ("3", "mass")]
