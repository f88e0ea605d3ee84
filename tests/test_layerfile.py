"""Layered ground from a scene file: what it says is what moves, numbers by soil, and what a wrong file is told."""

import json
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import slipcircle
from slipcircle.core import LayeredSection, Scene, Soil
from slipcircle.workbench.files.loaded import stability_of, warnings_of
from slipcircle.workbench.files.scenefile import critical_of_file
from slipcircle.workbench.files.variation import along_means
from slipcircle.workbench.stability.search import at_circle
from slipcircle.workbench.stability.stability import Slope
from slipcircle.workbench.studies.ensemble import grid

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


def test_a_file_is_the_section_that_it_describes(write: Write) -> None:
    """Defaults: cohesion grows from the top of the soil's layer, strength goes with the base."""
    tangent = {angle: float(np.tan(np.deg2rad(angle))) for angle in (20, 24, 28)}
    law = {"law": "exponential", "peak": tangent[24], "residual": tangent[20], "length": 0.8}
    sand = Soil(18e3, 0.0, tangent[28], name="sand")
    clay = Soil(19e3, 0.0, law, 20e3, pore_ratio=0.1, name="clay")
    soft = Soil(17e3, 25e3, 0.0, cohesion_gradient=1.5e3, name="soft clay")
    layers = [(sand, None), (clay, [(-60, 18.5), (10, 18.5), (20, 12)]), (soft, 2.0)]
    ground = [(-60, 20), (0, 20), (40, 0), (120, 0)]
    for strength, slip in {"base": "", "mass": '[slip]\nstrength = "mass"\n'}.items():
        section = LayeredSection(
            ground, (30, 45), 48.0, layers=layers, strength=strength, surcharge=[(-15, -5, 2e4, 4e4)]
        )
        expected = slipcircle.solve(Scene(section, effects=["rotation", "centripetal"]))
        motion = slipcircle.solve(slipcircle.load(write(SCENE, LOAD, slip)))
        assert motion.run_out == pytest.approx(expected.run_out, rel=1e-13)
        assert motion.factor_of_safety == pytest.approx(expected.factor_of_safety, rel=1e-13)
    stability = stability_of(slipcircle.load(write(SCENE, LOAD)))
    assert stability is not None
    assert stability.factor_of_safety["paper"] == pytest.approx(expected.factor_of_safety, rel=1e-9)


@pytest.mark.parametrize("name", ["layered-slope", "weak-toe"])
def test_layered_scenes_that_ship_slide(name: str, records: Any) -> None:
    (motion,), (alone,) = records("run", name), records("search", name)
    assert motion["stability"] == alone
    assert alone["factor_of_safety"]["bishop"] < 1.0
    assert motion["run_out"] > 1.0


def test_numbers_have_names_by_soil_in_every_study(write: Write) -> None:
    keys: dict[str, tuple[Any, Any]] = {
        "soils.clay.friction.peak_deg": (24, 23.0),
        "soils.soft clay.cohesion_kPa": (25, 24.0),
        "layers.3.top_m": (2, 2.5),  # below which the cohesion grows
        "surcharge.1.pressure_kPa": ("[20, 40]", "[30, 60]"),
        "tension_crack.depth_m": (1, 1.5),
    }
    scene = changed = SCENE + LOAD + "[tension_crack]\ndepth_m = 1\n"
    for key, (before, after) in keys.items():
        name = key.rpartition(".")[2]
        assert changed.count(f"{name} = {before}\n") == 1 or name == "peak_deg"
        changed = changed.replace(f"{name} = {before}", f"{name} = {after}")
    values = {key: [60.0 if "pressure" in key else float(after)] for key, (_, after) in keys.items()}
    study = grid(slipcircle.load(write(scene)), values)
    motion = slipcircle.solve(slipcircle.load(write(changed)))
    assert float(study.samples["run_out"][0]) == pytest.approx(motion.run_out, rel=1e-9)
    line = grid(slipcircle.load(write(SCENE)), {"layers.2.top_m": [17.5]})
    lowered = SCENE.replace("[[-60, 18.5], [10, 18.5], [20, 12]]", "[[-60, 17.5], [10, 17.5], [20, 11]]")
    expected = slipcircle.solve(slipcircle.load(write(lowered))).run_out
    assert float(line.samples["run_out"][0]) == pytest.approx(expected, rel=1e-9)


def test_a_law_of_speed_multiplies_the_friction_of_all_soils(write: Write) -> None:
    rate = '[slip.rate]\nlaw = "rate_weakening"\npeak = 1\nresidual = {}\nvelocity_m_s = 0.5\n'
    study = grid(slipcircle.load(write(SCENE, rate.format(0.9))), {"slip.rate.residual": [0.8, 1.0]})
    slower = slipcircle.solve(slipcircle.load(write(SCENE, rate.format(0.8))))
    without = slipcircle.solve(slipcircle.load(write(SCENE)))
    assert study.samples["run_out"] == pytest.approx([slower.run_out, without.run_out], rel=1e-9)


def test_each_soil_may_have_a_law_of_its_own(write: Write) -> None:
    """A sum of them in the plan, their numbers by soil in studies, and refused with the strength of the base."""
    table = 'friction = { law = "tabulated", slip_m = [0, 1, 3], angle_deg = [28, 25, 23] }'
    slip = '[slip]\nstrength = "{}"\n'
    scene = SCENE.replace("friction = { angle_deg = 28 }", table)
    study = grid(slipcircle.load(write(scene, slip.format("mass"))), {"soils.clay.friction.length_m": [0.4]})
    motion = slipcircle.solve(slipcircle.load(write(scene.replace("0.8 }", "0.4 }"), slip.format("mass"))))
    assert float(study.samples["run_out"][0]) == pytest.approx(motion.run_out, rel=1e-9)
    text = str(motion.plan.equation)
    assert "soil_mu_0 = mu(slip)" in text
    assert "soil_mu_1 = residual_1 + (peak_1 - residual_1) exp(-slip/length_1)" in text
    assert (
        r"soil_{\mu,1} &= \mu_{r,1} + \left(\mu_{p,1} - \mu_{r,1}\right) e^{- \frac{S}{L_{1}}}"
        in motion.plan.equation.latex
    )
    assert motion.plan.law == "tabulated, exponential, constant by soil"
    with pytest.raises(ValueError, match=r"with slip\.strength = 'mass' each may have a law of its own"):
        slipcircle.load(write(scene, slip.format("base")))


def test_uncertain_soils_slide_along_the_circle_of_the_means(write: Write) -> None:
    soil = "[soils.clay]\nunit_weight_kN_m3 = 19\nfriction = {{ angle_deg = 10 }}\ncohesion_kPa = {}\n"
    rest = '[[layers]]\nsoil = "clay"\n[circle]\ncritical = "ordinary"\n'
    drawn = write(GROUND, soil.format("{ distribution = 'lognormal', mean = 9, std = 4 }"), rest)
    scene = along_means(slipcircle.load(drawn))
    found = critical_of_file(write(GROUND, soil.format(9), rest), None, lambda line: None)[2]
    assert np.asarray(scene.arc.radius) == pytest.approx(found.radius, rel=1e-12)


@pytest.mark.parametrize(
    ("more", "reason"),
    [
        ("[pond]\nlevel_m = 3\n", "pond: is for factors of safety alone"),
        ("[tension_crack]\ndepth_m = 1\nwater_m = 1\n", "tension_crack.water_m: is for factors of safety alone"),
    ],
)
def test_what_motions_do_not_know_is_searched_and_not_run(write: Write, asked: Any, more: str, reason: str) -> None:
    path = write(SCENE, more)
    status, out, _ = asked("search", path, "--json")
    assert status == 0
    without = critical_of_file(write(SCENE), None, lambda line: None)[2].factor_of_safety["bishop"]
    assert json.loads(out)[0]["factor_of_safety"]["bishop"] != without
    status, _, error = asked("run", write(SCENE, more))
    assert status == 1
    assert reason in error


def test_a_shaken_motion_says_whose_loads_its_start_has(write: Write, said: Any) -> None:
    pulse = '[shaking]\npulse = "half-sine"\namplitude_g = 0.2\nduration_s = 1\n'
    words = "those of the motion, also for k_y"
    assert words in said("run", write(SCENE, LOAD, pulse))
    assert words not in said("run", write(SCENE, LOAD)) + said("run", write(SCENE, pulse))


def test_k_h_pushes_surcharges_where_it_is_asked_to(write: Write) -> None:
    """As it pushes a thin heavy layer of the same weight, which rises above the ground by 1 mm."""

    def factors(text: str) -> dict[str, float | None]:
        return critical_of_file(write(text), None, lambda line: None)[2].factor_of_safety

    load = "[[surcharge]]\nfrom_m = -60\nto_m = 0\npressure_kPa = 0.5\n"
    shaken = "[search]\nk_h = 0.2\n"
    dry = SCENE.replace("pore_pressure_ratio = 0.1\n", "")
    still = factors(dry + load + shaken)
    pushed = factors(dry + load + shaken + "k_h_on_surcharge = true\n")
    raised = dry.replace("[[-60, 20], [0, 20], [40, 0]", "[[-60, 20.001], [0, 20.001], [0, 20], [40, 0]")
    raised = raised.replace(
        '[[layers]]\nsoil = "sand"\n', '[[layers]]\nsoil = "slab"\n[[layers]]\nsoil = "sand"\ntop_m = 20\n'
    )
    slab = factors(raised + shaken + "[soils.slab]\nunit_weight_kN_m3 = 500\nfriction = { angle_deg = 28 }\n")
    for method, factor in pushed.items():
        alone = still[method]
        assert factor is not None
        assert alone is not None
        assert factor < alone
        assert slab[method] == pytest.approx(factor, abs=0.02 * (alone - factor))


def test_a_boundary_above_another_is_cut_off_and_said(write: Write, asked: Any) -> None:
    crossing = SCENE.replace("[[-60, 18.5], [10, 18.5], [20, 12]]", "[[-60, 18.5], [10, 18.5], [20, 1]]")
    path = write(crossing)
    words = "layers.3.top_m: rises above the top of layer 2, at x = 20; what is above is cut off"
    assert words in asked("search", path)[2]
    assert words in warnings_of(slipcircle.solve(slipcircle.load(path)))
    assert warnings_of(slipcircle.solve(slipcircle.load(write(SCENE)))) == ()


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
        'layers.2.soil = "clai": is no soil of this file; did you mean clay?',
        'slip.foreland = "gravel": is no soil of this file; known are sand, clay, peat',
        "soils.peat: is the soil of no layer",
        "layers.1.top_m: must be left out",
        "layers.2.top_m: is missing",
        "soils.clay.datum_m: is missing",
        "surcharge.1.to_m = 2: must lie to the right of from_m = 3",
    ):
        assert mistake in str(error.value)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("[soils.sand]", "[soils.sand]\ncohesoin_kPa = 3", r"cohesoin_kPa = 3: .*did you mean cohesion_kPa\?"),
        ("[[layers]]", "[[layer]]", "layer = .*: is unknown; did you mean layers"),
        (LAYERS, '[layers]\nsoil = "sand"\n', r"layers = .*: must be tables \[\[layers\]\]"),
        ("angle_deg = 28", "angle_deg = 95", "soils.sand.friction.angle_deg = 95: must be a number"),
        ('"exponential"', '"exponentail"', "soils.clay.friction.law = .*did you mean exponential"),
        ("residual_deg = 20, ", "", "soils.clay.friction: residual_deg or residual is missing"),
        ("top_m = 2\n", "top_m = [[0, 2]]\n", r"layers.3.top_m = \[\[0, 2\]\]: must be a height"),
        ("[20, 12]]", "[5, 12]]", r"layers.2.top_m\[2\]"),
        ("[rotation]", "[water]\nlevel_m = [[-60, 10], [120, 3]]", "level_m: stands 6.111 m above the ground.*pond"),
        ("[rotation]", "[tension_crack]\ndepth_m = 30", "tension_crack.depth_m = 30: is deeper than the mass"),
        ("[rotation]", '[slip]\nstrength = "mass"\nforeland = "sand"', "slip.foreland: cannot be combined"),
        ("[rotation]", "[slip]\nstrenght = 'mass'", "did you mean strength"),
        ("saturated_unit_weight_kN_m3 = 20", "saturated_unit_weight_kN_m3 = 20000", "is that in N/m3"),
    ],
)  # fmt: skip
def test_one_mistake_names_the_key_as_it_is_typed(write: Write, old: str, new: str, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        slipcircle.load(write(SCENE.replace(old, new)))


def test_one_soil_takes_cracks_loads_and_ponds_in_statics(write: Write, asked: Any) -> None:
    one_soil = f"{GROUND}unit_weight_kN_m3 = 19\n[friction]\nangle_deg = 20\n[cohesion]\ncohesion_kPa = 5\n{CIRCLE}"
    more = f"{LOAD}[tension_crack]\ndepth_m = 1\nwater_m = 0.5\n[pond]\nlevel_m = 3\n"
    found = critical_of_file(write(one_soil, more), None, lambda line: None)[2]
    soil = Soil(19e3, 5e3, float(np.tan(np.deg2rad(20))), name="soil")
    slope = Slope(found.slope.ground, layers=[(soil, None)], surcharge=found.slope.surcharge, pond=3.0, crack=1.0)
    slope = replace(slope, crack_water=0.5)
    section = LayeredSection(slope.ground, found.centre, found.radius, layers=slope.layers)
    assert found.factor_of_safety == pytest.approx(at_circle(slope, section).factor_of_safety, rel=1e-12)
    status, _, error = asked("run", write(one_soil, LOAD))
    assert status == 1
    assert re.search(r"surcharge: a motion takes it on layered ground alone.*\[soils.NAME\].*\[\[layers\]\]", error)
