"""Motions that start from the factor of safety of another method than the closure's."""

import copy
import pickle
from dataclasses import replace
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import slipcircle
from slipcircle import Arc, Scene, Status, load, solve
from slipcircle.derivatives import parameters, with_parameter_arrays, with_parameters
from slipcircle.workbench.stability.critical import SlopeScene
from tests.campaigns import combined
from tests.support.along_the_arc import of_scene
from tests.support.motions import from_method

# Lodalen 1954 (Sevaldson 1956): 17 m high, 1:2, c' = 10 kPa, phi' = 27 degrees.
LODALEN = """[ground]
points_m = [[0, 0], [20, 0], [54, 17], [90, 17]]
unit_weight_kN_m3 = 18.7
[circle]
critical = "bishop"
[friction]
angle_deg = 27
[cohesion]
cohesion_kPa = 10
[water]
level_m = [[0, 0], [20, 0], [40, 9], [54, 13], [90, 15]]
[rotation]
[centripetal]
"""


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda scene: pickle.loads(pickle.dumps(scene))])
def test_copies_are_started_anew_too(copied: Any) -> None:
    """Scenes of other processes, and of an explicit factor."""
    scene = load("valley-side")
    for one in (scene, replace(scene, strength_factor=1.1)):
        derived = [with_parameters(x, {"centre.x": 213.1, "level.3.y": 66.0}) for x in (one, copied(one))]
        assert derived[0].strength_factor == derived[1].strength_factor
    assert copied(scene).strength_factor == scene.strength_factor != derived[0].strength_factor == 1.1


SOFTENING = {"law": "exponential", "peak": 0.4, "residual": 0.2, "length": 1.0}


@pytest.fixture
def file(tmp_path: Path) -> Any:
    def written(text: str) -> Path:
        path = tmp_path / "scene.toml"
        path.write_text(text, "utf-8")
        return path

    return written


def close(one: Any, other: Any) -> None:
    assert one.strength_factor == pytest.approx(other.strength_factor, rel=1e-14)


@pytest.mark.parametrize("seed", [5, 6])
def test_motions_start_from_the_factor_of_a_method_as_plain_integration_does(seed: int, tmp_path: Path) -> None:
    """``python -m tests.campaigns.combined 200`` compares more motions.

    Also yield coefficients and further factors, and the slopes seen from behind and in map coordinates.
    """
    for drawn, motion in islice(combined.motions(seed, tmp_path), 2):
        assert combined.difference(drawn, motion) < combined.BOUND
        drawn.facing *= -1
        assert solve(combined.read(drawn, tmp_path)).run_out == pytest.approx(motion.run_out, rel=1e-10)
        drawn.shift = 5e6
        assert solve(combined.read(drawn, tmp_path)).run_out == pytest.approx(motion.run_out, rel=1e-6)
        slope = of_scene(motion.plan.scene)
        assert slope.factor(drawn.start, motion.yield_coefficient) == pytest.approx(1.0, rel=1e-12)
        if not drawn.shaken:
            assert motion.factor_of_safety == pytest.approx(slope.factor(drawn.start), rel=1e-12)
        further = motion.further_factors
        if further.at_rest_method:
            turned = slope.turned(motion.end.rotation)
            turned.slip = 2.0 * motion.run_out - motion.end.displacement  # also of one that turned back once
            at_rest = turned.factor(drawn.start)
            assert (further.at_rest, further.at_rest_method) == (pytest.approx(at_rest, rel=1e-9), drawn.start)
        softened = of_scene(motion.plan.scene)
        softened.slip = np.inf
        assert further.residual == pytest.approx(softened.factor(drawn.start), rel=1e-12)


def test_lodalen_runs_half_a_metre_by_bishop_and_four_by_the_paper(file: Any, said: Any) -> None:
    """Both run-outs and factors are those of the assessment that asked for the choice."""
    path = file(LODALEN)
    scene = load(path)
    assert solve(scene).run_out == pytest.approx(0.51, abs=0.005)
    by_paper = from_method(scene, "paper")
    assert by_paper.strength_factor == 1.0
    assert solve(by_paper).run_out == pytest.approx(3.98, abs=0.01)
    printed = " ".join(said("run", path).split())
    assert "factor of safety by Bishop's method 0.979" in printed
    assert "alternative start the paper's F = 0.841: 3.98 m" in printed
    assert (
        solve(load(file(LODALEN.replace('"bishop"', '"bishop"\nstart = "paper"')))).run_out == solve(by_paper).run_out
    )


@pytest.mark.parametrize(
    ("circle", "start"),
    [
        ('critical = "ordinary"', "ordinary"),
        ('critical = "paper"', "paper"),
        ('critical = "k_y"', "bishop"),
        ("centre_m = [31, 36]\nradius_m = 37.7", "bishop"),
        ('centre_m = [31, 36]\nradius_m = 37.7\nstart = "ordinary"', "ordinary"),
    ],
)
def test_the_start_is_by_the_method_of_the_search_unless_named(circle: str, start: str, file: Any) -> None:
    scene = load(file(LODALEN.replace('critical = "bishop"', circle)))
    assert isinstance(scene, SlopeScene)
    assert scene.start == start
    assert scene.stability is not None
    assert solve(scene).factor_of_safety == pytest.approx(scene.stability.factors_of_safety[start], rel=1e-9)


def test_every_strength_is_multiplied_and_no_other_resistance() -> None:
    """Friction of each law and cohesion, not drag and viscosity: as if they were entered so."""
    arc = Arc(60.0, 3.8, 5.0, 19e3)
    effects: Any = {"rotation": {}, "centripetal": {}, "drag": {"xi": 500.0}, "cohesion": {"cohesion": 4e3}}
    effects["viscosity"] = {"viscosity": 1e4, "thickness": 0.1}
    stronger = effects | {"cohesion": {"cohesion": 5e3}}
    linear = SOFTENING | {"law": "linear"}
    tabulated = {"law": "tabulated", "slip": [0.0, 1.0, 3.0], "coefficient": [0.3, 0.25, 0.2]}
    rate = {"law": "rate_weakening", "peak": 1.0, "residual": 0.8, "velocity": 0.1}
    laws: list[Any] = [
        0.2,
        SOFTENING,
        linear,
        tabulated,
        rate | {"peak": 0.3, "residual": 0.2},
        SOFTENING | {"rate": rate},
    ]
    laws.append(lambda slip: 0.2 + 0.1 * np.exp(-slip))
    for law in laws:
        scaled = Scene(arc, law, effects, initial_velocity=0.5, end_time=9.0, strength_factor=1.25)
        entered = Scene(arc, _times(law, 1.25), stronger, initial_velocity=0.5, end_time=9.0)
        one, other = solve(scaled), solve(entered)
        assert (one.run_out, one.duration) == pytest.approx((other.run_out, other.duration), rel=1e-12)
        assert one.friction == pytest.approx(other.friction / 1.25, rel=1e-12)
        assert one.limit_friction == pytest.approx(other.limit_friction / 1.25, rel=1e-12)
        half = 0.5
        assert one.friction_at(half) == pytest.approx(other.friction_at(half) / 1.25, rel=1e-9)
        assert one.holding_friction_at(half) == pytest.approx(other.holding_friction_at(half) / 1.25, rel=1e-9)


def _times(law: Any, factor: float) -> Any:
    """Return a law of friction with coefficients times a factor; a law of speed beside one of slip remains."""
    if callable(law):
        return lambda slip: factor * law(slip)
    if isinstance(law, float):
        return factor * law
    numbers = {name: np.multiply(law[name], factor) for name in ("peak", "residual", "coefficient") if name in law}
    return law | {name: value.tolist() for name, value in numbers.items()}


def test_it_is_computed_anew_for_samples_neighbours_and_trial_values() -> None:
    """The factor equals the factor of a scene with the same values, for arrays and for lanes of arrays."""
    scene: Any = load("real-slope")
    assert "strength_factor" not in parameters(scene)
    values = {"friction.peak": np.array([0.3, 0.4]), "unit_weight": np.array([18e3, 21e3])}
    lanes: Any = with_parameter_arrays(scene, values)[0]
    for k in range(2):
        alone = with_parameters(scene, {name: float(value[k]) for name, value in values.items()})
        assert lanes.strength_factor[k] == pytest.approx(alone.strength_factor, rel=1e-14)
        lane = solve(lanes)[k].plan.scene
        close(lane, alone)
        close(with_parameters(lane, {"friction.peak": 0.35}), with_parameters(alone, {"friction.peak": 0.35}))
    assert alone.strength_factor != scene.strength_factor
    explicit = with_parameters(replace(scene, strength_factor=1.5), {"friction.peak": 0.35})
    assert explicit.strength_factor == 1.5


WET = """[ground]
points_m = [[0, 12], [25, 12.5], [46, 19], [62, 29], [120, 34]]
[soils.silt]
unit_weight_kN_m3 = 18.5
saturated_unit_weight_kN_m3 = 20
cohesion_kPa = 4
friction = { law = "exponential", peak_deg = 20, residual_deg = 15, length_m = 0.3 }
[[layers]]
soil = "silt"
[water]
level_m = [[0, 11], [25, 12], [46, 18], [80, 27], [120, 30]]
[circle]
critical = "bishop"
"""


def test_lanes_that_differ_in_any_number_of_layered_ground_start_like_each_alone(file: Any) -> None:
    scene: Any = load(file(WET))
    assert len(scene.numbers) > 30
    for name, value in scene.numbers.items():
        values = float(value) * np.array([0.999, 1.001]) + 1e-4
        lanes: Any = with_parameter_arrays(scene, {name: values})[0]
        alone = [with_parameters(scene, {name: x}).strength_factor for x in values.tolist()]
        np.testing.assert_allclose(np.broadcast_to(lanes.strength_factor, 2), alone, rtol=1e-12, err_msg=name)


@pytest.mark.parametrize(
    ("text", "name", "values"),
    [("""[ground]
points_m = [[-80, 47], [0, 47], [28, 59], [110, 59]]
unit_weight_kN_m3 = 21
[circle]
through_m = [[-8, 47], [34, 59]]
depth_m = 8
[friction]
angle_deg = 11
[water]
level_m = [[-80, 49], [110, 49]]
""", "unit_weight", [20e3, 22e3]),
     ("""[ground]
points_m = [[0, 0], [40, 0], [55, 13], [55, 14], [130, 13]]
unit_weight_kN_m3 = 20
[circle]
through_m = [[38, 0], [58, 13.96]]
depth_m = 8
[friction]
angle_deg = 8
[cohesion]
cohesion_kPa = 5
""", "friction", [0.12, 0.14])],
    ids=["weight below standing water", "a circle that Bishop's method refuses"],
)  # fmt: skip
def test_lanes_are_like_scenes_alone(text: str, name: str, values: list[float], file: Any) -> None:
    scene: Any = load(file(text + "[rotation]\n[centripetal]\n"))
    lanes = solve(with_parameter_arrays(scene, {name: np.array(values)})[0], 1e-12)
    alone = [solve(with_parameters(scene, {name: value})).run_out for value in values]
    np.testing.assert_allclose(lanes.run_out, alone, rtol=1e-9)


LAWS = {
    "linear": "{ law = 'linear', peak_deg = 18, residual_deg = 16, length_m = 0.5 }",
    "exponential": "{ law = 'exponential', peak_deg = 18, residual_deg = 16, length_m = 0.5 }",
    "constant": "{ angle_deg = 16 }",
}


@pytest.mark.parametrize("law", LAWS)
def test_one_layer_moves_slowly_as_far_as_homogeneous_ground(law: str, file: Any) -> None:
    ground = "[ground]\npoints_m = [[0, 25], [30, 25], [50, 35], [90, 35]]\n"
    circle = "[circle]\ncentre_m = [29.5444662, 53.63564599]\nradius_m = 28.6355788\n[rotation]\n"
    soil = f"unit_weight_kN_m3 = 20\nfriction = {LAWS[law]}\n"
    layer = load(file(f"{ground}{circle}[soils.clay]\n{soil}[[layers]]\nsoil = 'clay'\n"))
    weight, friction = soil.splitlines()
    alone = load(file(f"{friction}\n{ground}{weight}\n{circle}"))
    assert solve(layer).slow_run_out == pytest.approx(solve(alone).slow_run_out, rel=1e-12)
    assert solve(layer).run_out == pytest.approx(solve(alone).run_out, rel=1e-12)


def test_without_friction_or_by_the_paper_it_is_exactly_one() -> None:
    scene = load("real-slope")
    still = with_parameters(scene, {"friction.peak": 0.0, "friction.residual": 0.0, "cohesion.cohesion": 25e3})
    assert still.strength_factor == 1.0
    assert Scene(scene.arc, 0.3).strength_factor == 1.0


def test_a_scene_of_a_search_in_python_is_that_of_its_file(file: Any) -> None:
    """Bit for bit, with laws of slip of both strengths, whose values at the start the statics use."""
    text = LODALEN.replace("[rotation]\n[centripetal]\n", "[rotation]\n").replace('"bishop"', '"{}"')
    for method in ("bishop", "paper", "k_y"):
        read: Any = load(file(text.format(method)))
        made: Any = read.stability.scene(["rotation"])
        close(made, read)
        assert solve(made).run_out == solve(read).run_out
    text = LODALEN.replace("angle_deg = 27", 'law = "linear"\npeak = 0.5\nresidual = 0.4\nlength_m = 2')
    text = text.replace("cohesion_kPa = 10", 'law = "exponential"\npeak_kPa = 10\nresidual_kPa = 4\nlength_m = 0.5')
    read = load(file(text))
    friction = {"law": "linear", "peak": 0.5, "residual": 0.4, "length": 2.0}
    cohesion = {"law": "exponential", "peak": 10e3, "residual": 4e3, "length": 0.5}
    slope = replace(read.stability.slope, friction=friction, cohesion=cohesion)
    found = slipcircle.critical(slope)
    motion = solve(found.scene(["rotation", "centripetal"]))
    assert motion.run_out == solve(read).run_out > 1.0
    at_start = slipcircle.critical(replace(slope, friction=0.5, cohesion=10e3))
    assert found.factors_of_safety == at_start.factors_of_safety == pytest.approx(motion.factors_of_safety, rel=1e-12)
    assert (
        found.factor_of_safety == found.factors_of_safety["bishop"] == pytest.approx(motion.factor_of_safety, rel=1e-12)
    )
    assert motion.to_dict()["factors_of_safety"] == motion.factors_of_safety
    assert motion.to_pandas()["factors_of_safety.bishop"].item() == motion.factors_of_safety["bishop"]


def test_a_surcharge_or_a_crack_on_one_soil_moves_with_it() -> None:
    """Loads move as on the same soil in a layer; water in a crack is refused."""
    ground, law = [[0, 0], [20, 0], [54, 17], [90, 17]], {"law": "linear", "peak": 0.35, "residual": 0.3, "length": 2.0}
    loads: Any = {"surcharge": [(60.0, 70.0, 2e4, 2e4)], "crack": 1.0}
    one = slipcircle.Slope(ground, 5e3, law, 19e3, **loads)
    layers = [(slipcircle.Soil(19e3, 5e3, law, name="soil"), None)]
    slopes = one, slipcircle.Slope(ground, layers=layers, **loads)
    motions = [solve(slipcircle.critical(slope).scene(["rotation"])) for slope in slopes]
    assert motions[0].run_out == motions[1].run_out > 0.0
    with pytest.raises(ValueError, match=r"crack_water = 0\.5: a crack opens and empties"):
        slipcircle.critical(replace(one, crack_water=0.5)).scene(["rotation"])


@pytest.mark.parametrize(
    ("strength", "words"),
    [
        ({"friction": {"law": "slow", "peak": 0.4}}, "friction.law = 'slow': must be one of constant"),
        ({"friction": SOFTENING | {"peak": 7.0}}, "friction = 7: must be a friction coefficient"),
        ({"cohesion": {"law": "linear", "peak": 1e4, "length": 1.0}}, "cohesion: 'residual' is missing"),
        ({"friction": float}, "friction = <class 'float'>: must be a number, a law or a function of slip"),
        ({"friction": 0.4, "cohesion": float}, "cohesion = <class 'float'>: must be a number, a law or a function"),
        ({"friction": {"law": "constant", "coefficient": 0.0}}, "cohesion and friction are both 0"),
    ],
)
def test_a_law_of_a_slope_that_no_soil_has_is_one_line(strength: Any, words: str) -> None:
    with pytest.raises(ValueError, match=words) as error:
        slipcircle.Slope([[0, 10], [10, 0]], unit_weight=19e3, **strength)
    assert "\n" not in str(error.value)


def test_under_shaking_the_factor_is_by_the_method_too() -> None:
    """The strength factor makes yield coefficients equal there, and the factor of the closure with it another one."""
    scene: Any = load("shaken-slope")
    factors = scene.stability.factors_of_safety
    motion = solve(scene)
    assert motion.factor_of_safety == pytest.approx(factors["bishop"], rel=1e-12)
    assert motion.factors_of_safety == pytest.approx(factors, rel=1e-12)
    assert abs(factors["paper"] * scene.strength_factor / factors["bishop"] - 1.0) > 1e-3


def test_a_start_without_a_result_is_a_sentence_or_a_status(file: Any) -> None:
    """Bishop's method refuses a circle whose toe rises steeply, under a pore pressure that leaves little strength."""
    dry = LODALEN[: LODALEN.index("[water]")] + "[rotation]\n[pore_pressure]\nratio = {}\n"
    steep = dry.replace('critical = "bishop"', "centre_m = [37, 18]\nradius_m = 28").replace("_kPa = 10", "_kPa = 1")
    scene = load(file(steep.format(0.2)))
    lanes, _ = with_parameter_arrays(scene, {"pore_pressure.ratio": np.array([0.2, 0.3, 0.9])})
    motion = solve(lanes)
    assert motion.status.tolist()[2] == Status.UNSTARTED
    assert np.isnan(motion.run_out).tolist() == [False, False, True]
    with pytest.raises(ValueError, match=r'circle.start: by bishop .* such as start = "ordinary" or "paper"'):
        load(file(steep.format(0.9)))
    uncertain = {"pore_pressure.ratio": {"distribution": "uniform", "low": 0.8, "high": 0.9}}
    study = slipcircle.ensemble(replace(scene, uncertain=uncertain), 2, rng=1, sensitivity=0)
    said = "not valid scenes and not counted: circle.start: by bishop this circle has no factor of safety"
    assert said in " ".join(study.warnings)


# --- further factors -------------------------------------------------------------------------------------------------


def test_factors_with_residual_strength_and_at_rest_are_those_of_the_turned_weight() -> None:
    """Factors of frictional masses are tan(phi) over the limit friction at the dip, before and after the slide."""
    for name in ("vaiont", "vaiont-softening"):
        scene: Any = load(name)
        motion = solve(scene)
        residual = np.tan(np.radians(10.0))
        ratio = scene.arc.dimensionless.limit_friction / np.tan(scene.arc.dip)
        at_rest = abs(ratio * np.tan(scene.arc.dip - motion.end.rotation))
        assert motion.further_factors.residual == pytest.approx(residual / scene.arc.dimensionless.limit_friction)
        assert motion.further_factors.at_rest == pytest.approx(residual / at_rest, rel=1e-9)
    slope: Any = load("real-slope")
    heat = {"pressurisation": 0.1e6, "heat_capacity": 2.4e6, "thickness": 0.1}
    heated = solve(replace(slope, effects=slope.effects | {"thermal_pressurisation": heat}, end_time=60.0))
    assert heated.further_factors.at_rest_method == ""
    linear = Scene(scene.arc, SOFTENING | {"law": "linear"}, ["rotation"], strength_factor=0.5)
    limit = scene.arc.dimensionless.limit_friction
    assert solve(linear).further_factors.residual == pytest.approx(0.1 / limit, rel=1e-12)


def test_cohesion_alone_means_no_friction(file: Any, refused: Any) -> None:
    text = LODALEN[: LODALEN.index("[water]")] + "[rotation]\n"
    text = text.replace("_kPa = 10", "_kPa = 40").replace('[circle]\ncritical = "bishop"', "base_m = -4\n[circle]\n"
                                                          'critical = "bishop"')  # fmt: skip
    alone = solve(load(file(text.replace("[friction]\nangle_deg = 27\n", ""))))
    assert alone.run_out == solve(load(file(text.replace("angle_deg = 27", "angle_deg = 0")))).run_out > 0.0
    neither = text.replace("[friction]\nangle_deg = 27\n[cohesion]\ncohesion_kPa = 40\n", "")
    assert "friction: is missing" in refused("run", file(neither))
