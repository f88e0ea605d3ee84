"""Layered sections: weights and strength along the arc against their definitions, motions against other solvers."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from slipcircle import Scene, Section, solve
from slipcircle.base.series import Series
from slipcircle.core import LayeredSection, Soil, stretches
from slipcircle.core.flow import compiled
from slipcircle.core.flow.layered import RotationTables
from slipcircle.core.scene.coordinates import changed_fields, replace_unchecked
from slipcircle.core.scene.parameters import with_parameter_arrays, with_parameters
from slipcircle.workbench.stability.search import at_circle
from slipcircle.workbench.stability.stability import Slope, factors_of_safety
from tests.campaigns.layered_benchmarks import CASES, solved
from tests.campaigns.layered_benchmarks import differences as differences_of
from tests.campaigns.layered_sections import (
    AlongTheArc,
    differences,
    random_motions,
    random_section,
    strength_by_quadrature,
)
from tests.support.layered import GROUND, LEVEL, PROFILES, TOPS, TURNING, profile, tangent

# Factor of safety, peak velocity, its time, run-out and duration, by DOP853 in time with rtol = 2e-13, of a program
# that shares nothing with this one; peak and run-out at the base also by integrating omega^2 over phi.
MOTIONS = {
    ("one soil in four layers, under water", "base"): (0.596759692, 3.383403121, 3.2576491, 14.307542564, 6.646433899),
    ("one soil in four layers, under water", "mass"): (0.596759692, 3.383403121, 3.2576491, 14.307542564, 6.646433899),
    ("constant friction", "base"): (0.825856281, 1.426745748, 3.1488264, 5.778618682, 6.367348012),
    ("constant friction", "mass"): (0.825856281, 1.482511601, 3.2754324, 6.242993876, 6.615546788),
    ("softening", "base"): (0.913425561, 1.915602114, 4.2903403, 8.397668319, 7.563534201),
    ("softening", "mass"): (0.913425561, 2.025732503, 4.4431712, 9.189842726, 7.823357243),
}


def test_moments_and_stretches_are_those_of_the_definitions() -> None:
    """By quadrature along the arc; 200 sections by ``python -m tests.campaigns.layered_sections``."""
    rng = np.random.default_rng(7)
    for _ in range(5):
        assert max(differences(random_section(rng))) < 1e-12


@pytest.mark.parametrize("strength", ["base", "mass"])
def test_strength_after_a_rotation_is_its_integral_along_the_arc(strength: str) -> None:
    """With water, pore pressure ratios, cohesion that grows with depth, surcharges and saturated weights."""
    rng = np.random.default_rng(8)
    for _ in range(4):
        section = random_section(rng, everything=True, strength=strength)
        computed, expected = strength_by_quadrature(section, rng.uniform(-0.3, 0.6), rng.uniform())
        np.testing.assert_allclose(computed, expected, rtol=0, atol=1e-9)


@pytest.mark.parametrize(("name", "strength"), MOTIONS)
def test_motions_are_those_of_another_integrator(name: str, strength: str) -> None:
    motion = solve(Scene(profile(name, strength), effects=TURNING))
    computed = (motion.factor_of_safety, motion.peak.velocity, motion.peak.time, motion.run_out, motion.duration)
    digits = [2e-9, 2e-9, 3e-8, 2e-9, 2e-9]  # the time of the peak is given to 7 decimals
    for value, expected, tolerance in zip(computed, MOTIONS[name, strength], digits, strict=True):
        assert value == pytest.approx(expected, rel=tolerance)


@pytest.mark.parametrize("name", PROFILES)
def test_stretches_sum_up_to_the_motion(name: str) -> None:
    """Stress, pressure and strength along the arc to those on which it starts; weights to the whole; soils by place."""
    section = profile(name)
    motion, rows = solve(Scene(section, effects=TURNING)), stretches(section)
    length = np.array([row.length for row in rows])

    def mean(quantity: str) -> float:
        return float(np.average([getattr(row, quantity) for row in rows], weights=length))

    assert sum(length) == pytest.approx(48.0 * (rows[-1].end - rows[0].start))
    assert sum(row.weight_share for row in rows) == pytest.approx(1.0)
    assert mean("normal_stress") == pytest.approx(float(motion.at(0.0).normal_stress), rel=1e-12)
    assert mean("pore_pressure") == pytest.approx(float(np.asarray(section.mean_pressure())), rel=1e-12, abs=1e-9)
    weight_moment = section.mean_unit_weight * section.area * abs(section.centroid[0] - 30.0)
    factor = 48.0 * sum(length) * mean("strength") / weight_moment
    assert motion.factor_of_safety == pytest.approx(factor, rel=1e-12)
    assert [row.soil.name[-1] for row in rows] == list("01232")
    for row in rows:
        height = 45.0 - 48.0 * np.cos((row.start + row.end) / 2)
        assert row.soil is section.layers[sum(height < top for top in TOPS[1:])][0]


def test_the_normal_stress_of_a_moving_layered_mass_is_that_on_which_its_mean_friction_acts() -> None:
    section = profile("constant friction")
    motion = solve(Scene(section, effects=TURNING))
    state = motion.at(3.0)
    omega_2 = state.angular_velocity**2 * 48.0 / 9.81
    friction, _, _ = AlongTheArc(section, 6).resistance(state.rotation, omega_2)
    length = 48.0 * 2 * float(section.half_angle)
    assert state.normal_stress * motion.friction * length == pytest.approx(friction, rel=1e-9)


def test_random_layered_motions_are_within_their_error_estimates() -> None:
    """To 1e-12, one with the base and one with the mass; 60 by ``python -m tests.campaigns.layered_sections``."""
    for *errors, estimate in random_motions(np.random.default_rng(0), 2):
        assert max(errors) < min(1e-12, estimate)


RICH = [
    Soil(18e3, 3e3, {"law": "exponential", "peak": 0.57, "residual": 0.45, "length": 0.8}, name="a"),
    Soil(19e3, 2e3, {"law": "exponential", "peak": 0.36, "residual": 0.26, "length": 0.8}, pore_ratio=0.1, name="b"),
    Soil(17e3, 1e3, {"law": "exponential", "peak": 0.16, "residual": 0.1, "length": 0.8}, 18.5e3, 300.0, 1.5, name="c"),
    Soil(21e3, 0.0, 0.42, name="d"),
]  # fmt: skip
RICH_TOPS = (None, 18.5, [(-20, 4), (20, 2.5), (60, 1)], -1.0)
# Numbers, and steps of their differences; half of them with the base, half with the mass.
NUMBERS = {
    "layers.3.top": 2e-3, "layers.4.top": 2e-3, "level.1.y": 2e-3, "ground.2.x": 5e-3, "centre.y": 5e-3, "radius": 5e-3,
    "soils.a.friction.length": 1e-3, "soils.b.pore_ratio": 1e-3, "soils.c.friction.residual": 1e-3,
    "soils.c.cohesion_gradient": 1.0, "soils.c.saturated_unit_weight": 10.0, "soils.d.friction": 1e-3,
    "soils.d.cohesion": 10.0, "gravity": 1e-2,
}  # fmt: skip


@pytest.mark.parametrize(("strength", "half"), [("base", slice(0, None, 2)), ("mass", slice(1, None, 2))])
def test_derivatives_of_layered_motions_are_those_of_other_motions(strength: str, half: slice) -> None:
    section = LayeredSection(
        GROUND, (30, 45), 48.0, layers=list(zip(RICH, RICH_TOPS, strict=True)), strength=strength,
        level=[(-60, 12), (0, 9), (40, -1.4), (120, -1.8)], surcharge=[(-3.0, 4.0, 2e4, 3e4)],
    )  # fmt: skip
    check_derivatives(section, dict(list(NUMBERS.items())[half]))


@pytest.mark.parametrize(("way", "numbers"), [
    (1, {"crack": 5e-3, "centre.y": 5e-3, "ground.0.y": 5e-3, "ground.1.y": 5e-3, "surcharge.1.pressure": 20.0}),
    (-1, {"crack": 5e-3, "radius": 5e-3, "ground.2.y": 5e-3, "layers.2.top": 2e-3, "soils.d.cohesion_gradient": 1.0}),
])  # fmt: skip
def test_derivatives_of_cracked_and_loaded_motions_are_those_of_other_motions(way: int, numbers: Any) -> None:
    """The crack in sloping ground; a load with two pressures; cohesion that grows below a varied top."""
    steep = [(-60, 22), (-2, 20), (40, 0), (120, 0)]
    ground = [(way * x, y) for x, y in steep][::way]
    left, right = sorted([-3.0 * way, 4.0 * way])
    soils = [*RICH[:2], Soil(21e3, 1e3, 0.36, cohesion_gradient=200.0, name="d")]
    section = LayeredSection(
        ground, (30 * way, 45), 48.0, layers=list(zip(soils, (None, 12.0, 3.0), strict=True)), crack=4.0,
        surcharge=[(left, right, 2.5e4 - 5e3 * way, 2.5e4 + 5e3 * way)],
    )  # fmt: skip
    check_derivatives(section, numbers | {"layers.3.top": 2e-3})


def check_derivatives(section: LayeredSection, steps: Mapping[str, float]) -> None:
    """By central differences of fourth order; of a number that is 0, of one side."""
    scene = Scene(section, effects=TURNING)
    sensitivity = solve(scene).sensitivity()
    for name, step in steps.items():
        value = sensitivity.at[name]
        weights = {1: 8.0, -1: -8.0, 2: -1.0, -2: 1.0} if value else {0: -25.0, 1: 48.0, 2: -36.0, 3: 16.0, 4: -3.0}
        expected = np.zeros(3)
        for steps_away, weight in weights.items():
            motion = solve(with_parameters(scene, {name: value + steps_away * step}))
            expected += weight / (12.0 * step) * np.array([motion.peak.velocity, motion.run_out, motion.duration])
        computed = [sensitivity.derivative(output, name) for output in ("peak_velocity", "run_out", "duration")]
        np.testing.assert_allclose(computed, expected, rtol=2e-6, atol=2e-7 * np.abs(expected).max(), err_msg=name)


def of_each_soil(**given: Any) -> LayeredSection:
    """The slope of `MOTIONS` with a friction law of its own for each soil."""
    laws: list[Any] = [
        {"law": "linear", "peak": 0.57, "residual": 0.45, "length": 0.3},
        {"law": "tabulated", "slip": [0.0, 0.5, 2.0, 6.0], "coefficient": [0.36, 0.32, 0.23, 0.21]},
        {"law": "rate_weakening", "peak": 0.16, "residual": 0.1, "velocity": 2.0},
        {"law": "hyperbolic", "peak": 0.44, "residual": 0.36, "length": 1.0},
    ]
    soils = [Soil(w, c, law, name=n) for w, c, law, n in zip(UNIT_WEIGHTS, COHESIONS, laws, "abcd", strict=True)]
    layers = list(zip(soils, TOPS, strict=True))
    return LayeredSection(GROUND, (30, 45), 48.0, layers=layers, strength="mass", **given)


UNIT_WEIGHTS = (18e3, 19e3, 17e3, 21e3)
COHESIONS = (3e3, 2e3, 1e3, 0.0)
BELOW_GROUND = [(-60, 12), (0, 9), (40, -1.4), (120, -1.8)]
SLOWER = {"law": "rate_weakening", "peak": 1.0, "residual": 0.8, "velocity": 0.5}


def shaken(k_h: float, k_v: float) -> dict[str, Any]:
    """Steady shaking of a turning mass."""
    both = {"horizontal": k_h, "vertical": k_v}
    held = {name: Series(np.array([0.0, 100.0]), np.full(2, k)) for name, k in both.items()}
    return {name: {} for name in TURNING} | {"shaking": held}


LOAD = {"surcharge": [(-3.0, 2.0, 2e4, 4e4)], "rate": SLOWER}
ALL_AT_ONCE = {
    "softening, the base": (profile("softening", "base", **LOAD), shaken(0.05, 0.02), (4.26345513922, 18.5701151669)),
    "softening, the mass": (profile("softening", "mass", **LOAD), shaken(0.05, 0.02), (4.41560123103, 19.3144981725)),
    "a law of each soil": (of_each_soil(**LOAD), TURNING, (3.42716319536, 15.4005871165)),
    "a law of each soil, under water": (
        of_each_soil(level=BELOW_GROUND), shaken(0.03, 0.02), (4.17568402086, 18.183057204)
    ),
}  # fmt: skip


@pytest.mark.parametrize("which", ALL_AT_ONCE)
def test_soils_that_soften_each_under_loads_and_shaking_with_a_factor_of_speed(which: str) -> None:
    """Peak velocity and run-out by DOP853 of the definition along the arc; energy is kept; as without a compiler."""
    section, effects, expected = ALL_AT_ONCE[which]
    motion = solve(Scene(section, effects=effects, end_time=60.0))
    assert (motion.peak.velocity, motion.run_out) == pytest.approx(expected, rel=1e-9)
    assert motion.energy_error_estimate < 1e-11
    assert motion.error_estimate < 1e-11
    with compiled.numpy_only():
        assert solve(motion.plan.scene).run_out == pytest.approx(motion.run_out, rel=1e-11)


def test_equal_laws_of_soils_are_one_law() -> None:
    """As they stick and slip again: a law that differs in its last digit is not taken for the same."""
    softening = profile("softening", "mass")
    strong = [replace(soil, cohesion=float(np.asarray(soil.cohesion)) + 2e4) for soil in softening.soils]
    different = {**strong[3].friction, "length": 0.8 * (1.0 + 4e-16)}
    effects: dict[str, Any] = {name: {} for name in TURNING}
    effects["shaking"] = {"pulse": "sine", "amplitude": 0.3, "duration": 9.0, "cycles": 7}
    one, each = (
        solve(Scene(replace(softening, layers=list(zip(soils, TOPS, strict=True))), effects=effects))
        for soils in (strong, [*strong[:3], replace(strong[3], friction=different)])
    )
    assert len(each.phases) == len(one.phases) == 7
    for name in ("factor_of_safety", "limit_friction", "run_out", "duration"):
        assert getattr(each, name) == pytest.approx(getattr(one, name), rel=1e-13)


@pytest.mark.parametrize(
    ("strength", "law"),
    [
        ("base", 0.27),
        ("mass", 0.27),
        ("mass", {"law": "rate_tabulated", "speed": [0.01, 0.1, 1.0, 3.0], "coefficient": [0.27, 0.24, 0.2, 0.19]}),
        ("mass", {"law": "prescribed", "time": [0.0, 2.0, 4.0], "coefficient": [0.27, 0.2, 0.24]}),
        ("mass", {"law": "tabulated", "slip": [0.0, 0.5, 2.0, 6.0], "coefficient": [0.27, 0.25, 0.2, 0.19]}),
        ("mass", {"law": "rate_weakening", "peak": 0.27, "residual": 0.2, "velocity": 0.5}),
    ],
)
def test_one_law_in_soils_of_many_names_is_the_homogeneous_section(strength: str, law: Any) -> None:
    soils = [Soil(19e3, 4e3, law, name=name) for name in "abcd"]
    tops = (None, 17.0, [(-60, 15), (20, 4), (120, -3)], -1.0)
    layers = list(zip(soils, tops, strict=True))
    layered = LayeredSection(GROUND, (30, 45), 48.0, layers=layers, strength=strength, level=BELOW_GROUND)
    section = Section(GROUND, (30, 45), 48.0, 19e3, level=BELOW_GROUND)
    frozen: dict[str, Any] = {}
    for effects, end in ((dict.fromkeys(TURNING, frozen), None), (frozen, 3.0)):
        one = solve(Scene(section, law, effects | {"cohesion": {"cohesion": 4e3}}, end_time=end))
        many = solve(Scene(layered, effects=effects, end_time=end))
        for name in ("factor_of_safety", "limit_friction", "run_out", "duration"):
            assert getattr(many, name) == pytest.approx(getattr(one, name), rel=1e-12)


@pytest.mark.parametrize("strength", ["base", "mass"])
def test_motions_beyond_their_tables_have_longer_ones(strength: str, monkeypatch: pytest.MonkeyPatch) -> None:
    section = profile("softening", strength)
    scenes = [Scene(section, effects=TURNING), Scene(with_radii(section, [48.0, 47.5]), effects=TURNING)]
    complete = [solve(scene) for scene in scenes]
    monkeypatch.setattr(RotationTables, "likely_reach", lambda tables, friction: 0.01)
    for scene, expected in zip(scenes, complete, strict=True):
        motion = solve(scene)
        for name in ("run_out", "duration", "error_estimate"):
            assert getattr(motion, name) == pytest.approx(getattr(expected, name), rel=1e-12, abs=1e-13)


def with_radii(section: LayeredSection, radii: list[float]) -> LayeredSection:
    """Lanes that differ in their circles."""
    return replace_unchecked(section, changed_fields(section, {"radius": np.array(radii)}))


def test_derivatives_by_numbers_of_laws_of_soils_are_those_of_other_motions() -> None:
    """Of each soil's own law, and of constant friction among laws of slip."""
    section = of_each_soil(level=BELOW_GROUND)
    *others, (soil, top) = section.layers
    constant = replace(section, layers=[*others, (replace(soil, friction=0.42), top)])
    steps = {"soils.a.friction.length": 1e-3, "soils.c.friction.velocity": 2e-3, "soils.d.friction.peak": 1e-3,
             "soils.b.unit_weight": 10.0, "radius": 5e-3}  # fmt: skip
    check_derivatives(section, steps)
    check_derivatives(constant, {"soils.d.friction": 1e-3})


def test_laws_of_soils_that_a_motion_does_not_allow() -> None:
    sliding = {"law": "linear", "peak": 0.4, "residual": 0.0, "length": 1.0}
    soils = [Soil(19e3, 0.0, law, name=name) for law, name in ((sliding, "a"), ({**sliding, "length": 2.0}, "b"))]
    layers = list(zip(soils, (None, 2.0), strict=True))
    with pytest.raises(ValueError, match="has slipped less than the sole; with strength = 'mass' each may have"):
        LayeredSection(GROUND, (30, 45), 48.0, layers=layers)
    with pytest.raises(ValueError, match="one of them must keep some friction"):
        LayeredSection(GROUND, (30, 45), 48.0, layers=layers, strength="mass")


def test_where_a_boundary_touches_the_arc_there_is_no_derivative() -> None:
    soils = profile("constant friction").soils
    section = LayeredSection(GROUND, (30, 45), 48.0, layers=[(soils[0], None), (soils[1], 6.0), (soils[2], -3.0)])
    with pytest.raises(ValueError, match=r"layers\.3\.top: touches the slip circle without crossing it"):
        solve(Scene(section, effects=TURNING)).sensitivity()
    at_brow = 20.0 - (45.0 - np.sqrt(48.0**2 - 30.0**2))  # from the brow at (0, 20) down to the arc
    cracked = LayeredSection(GROUND, (30, 45), 48.0, layers=[(soils[2], None)], crack=at_brow)
    with pytest.raises(ValueError, match="crack: is at a vertex of the ground"):
        solve(Scene(cracked, effects=TURNING)).sensitivity()


CRACKED = LayeredSection(
    GROUND, (30, 45), 48.0, layers=[(RICH[0], None), (Soil(21e3, 1e3, 0.36, cohesion_gradient=200.0, name="d"), 3.0)],
    crack=2.0, surcharge=[(-3.0, 4.0, 2e4, 3e4)],
)  # fmt: skip
SOIL_NUMBERS = {"soils.soil 2.friction.peak": tangent([9.0, 8.0, 10.0]), "soils.soil 1.unit_weight": [19e3, 18e3, 2e4]}
LANES: dict[str, tuple[LayeredSection, dict[str, Any], float]] = {
    "soils, the base": (profile("softening", "base"), SOIL_NUMBERS, 1e-10),
    "soils, the mass": (profile("softening", "mass"), SOIL_NUMBERS, 1e-10),
    "laws of soils": (of_each_soil(level=BELOW_GROUND), {"soils.a.friction.length": [0.3, 0.302]}, 1e-11),
    "circles and boundaries": (
        profile("constant friction"), {"radius": [48.0, 47.5], "layers.3.top": [2.0, 2.4]}, 1e-9
    ),
    "cracks, loads and heights where cohesion begins to grow": (
        CRACKED, {"crack": [2.0, 2.5], "surcharge.1.pressure": [3e4, 5e4], "layers.2.top": [3.0, 5.0]}, 1e-9
    ),
}  # fmt: skip


@pytest.mark.parametrize("which", LANES)
def test_lanes_are_the_scenes_that_they_stand_for(which: str) -> None:
    section, values, close = LANES[which]
    scene = Scene(section, effects=TURNING)
    lanes, invalid = with_parameter_arrays(scene, {name: np.array(value) for name, value in values.items()})
    assert not invalid.any()
    motions, factors = solve(lanes, accuracy=1e-13), factors_of_safety(lanes)
    for k in range(len(motions)):
        one = with_parameters(scene, {name: float(value[k]) for name, value in values.items()})
        assert motions.run_out[k] == pytest.approx(solve(one).run_out, rel=close)
        for method, factor in factors_of_safety(one).items():
            assert factors[method][k] == pytest.approx(factor, rel=1e-9)


def test_the_pressure_of_a_surcharge_is_that_of_its_greater_end() -> None:
    changed = with_parameters(Scene(CRACKED, effects=TURNING), {"surcharge.1.pressure": 6e4})
    expected = replace(CRACKED, surcharge=[(-3.0, 4.0, 4e4, 6e4)])
    assert solve(changed).run_out == pytest.approx(solve(Scene(expected, effects=TURNING)).run_out, rel=1e-12)


def test_a_foreland_decides_how_far_a_mass_gets() -> None:
    exit_soil = profile("constant friction").soils[2]

    def run_out(friction: Any) -> float:
        foreland = Soil(18e3, 0.0, friction, name="foreland")
        return solve(Scene(profile("constant friction", foreland=foreland), effects=TURNING)).run_out

    as_exit = solve(Scene(profile("constant friction"), effects=TURNING)).run_out
    assert run_out(tangent(5.0)) > as_exit > run_out(tangent(15.0)) > run_out(tangent(30.0))
    assert run_out(exit_soil.friction) == pytest.approx(as_exit, rel=1e-12)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"layers": []}, "layers: must be pairs of a Soil and its top"),
        ({"layers": [(Soil(19e3), 3.0)]}, "layers\\[0\\]: top = 3.0: must be None"),
        ({"layers": [(Soil(19e3), None), (Soil(19e3, name="b"), None)]}, "layers\\[1\\]: top is missing"),
        ({"strength": "both"}, "strength = 'both': must be 'base' or 'mass'"),
        ({"foreland": Soil(19e3, name="f"), "strength": "mass"}, "foreland: cannot be combined"),
        ({"surcharge": [(3.0, 1.0, 0.0, 0.0)]}, "surcharge\\[0\\]"),
        ({"radius": 44.0, "centre": (30, 12)}, "above the centre's height|lies below the ground"),
    ],
)
def test_mistakes_are_named(changes: dict[str, Any], message: str) -> None:
    given: dict[str, Any] = {
        "centre": (30, 45),
        "radius": 48.0,
        "layers": [(Soil(19e3, name="a"), None), (Soil(18e3, name="b"), 2.0)],
    }
    with pytest.raises(ValueError, match=message):
        LayeredSection(GROUND, **given | changes)


def test_what_soils_say_is_not_said_twice() -> None:
    section = profile("constant friction")
    with pytest.raises(ValueError, match=r"friction = 0\.3: is given by the soils"):
        Scene(section, 0.3, TURNING)
    with pytest.raises(ValueError, match=r"effects\.cohesion: is given by the soils"):
        Scene(section, effects={"cohesion": {"cohesion": 3e3}})
    with pytest.raises(ValueError, match="'layered_strength' is unknown"):
        Scene(Section(GROUND, (30, 45), 48.0, 19e3), 0.3, {"layered_strength": {}})


@pytest.mark.parametrize("way", [1, -1])
def test_a_cracked_section_begins_at_a_scarp(way: int) -> None:
    """As where the ground beyond the crack is dug away; under water, its slope to the right or to the left."""
    ground, level = ([(way * x, y) for x, y in line][::way] for line in (GROUND, LEVEL))
    soils = profile("constant friction").layers
    centre = (30 * way, 45)
    cracked = LayeredSection(ground, centre, 48.0, level=level, layers=soils, crack=3.0)
    (x, y), scene = cracked.entry, Scene(cracked, effects=TURNING)
    assert np.interp(x, *np.transpose(ground)) - y == pytest.approx(3.0, rel=1e-12)
    dug = [(-60 * way, y - 3), (x, y - 3), (x, y + 3), *[p for p in ground[::way] if way * p[0] > way * x]]
    tops = (None, *([(-199.0, top), (199.0, top)] for top in TOPS[1:]))
    layers = [(soil, top) for (soil, _), top in zip(soils, tops, strict=True)]
    scarp = LayeredSection(dug[::way], centre, 48.0, level=level, layers=layers)
    computed, expected = solve(scene), solve(Scene(scarp, effects=TURNING))
    for name in ("factor_of_safety", "run_out", "duration"):
        assert getattr(computed, name) == pytest.approx(getattr(expected, name), rel=1e-11)
    statics = at_circle(Slope(ground, layers=soils, level=level, crack=3.0), Section(ground, centre, 48.0, 1.0))
    by_method = factors_of_safety(scene)
    for method, factor in statics.factor_of_safety.items():
        assert by_method[method] == pytest.approx(factor, rel=1e-9)
    with pytest.raises(ValueError, match="crack = 40: is deeper than the mass"):
        LayeredSection(ground, centre, 48.0, layers=soils, crack=40.0)


def test_numbers_of_soils_of_an_odd_size_are_questioned() -> None:
    layers = [(Soil(19.0, 5e3, 0.3, name="light"), None), (Soil(19e3, 5e3, 30.0, name="rough"), 2.0)]
    said = solve(Scene(LayeredSection(GROUND, (30, 45), 48.0, layers=layers))).warnings
    assert any("soils.light.unit_weight = 19 N/m^3: is that in kN/m^3?" in warning for warning in said)
    assert any("soils.rough.friction = 30: is that an angle?" in warning for warning in said)


# --- layered slopes --------------------------------------------------------------------------------------------------

GIVEN = [case for case in CASES if "circle" in case]
# All by python -m tests.campaigns.layered_benchmarks; these have kinks where circles touch boundaries.
SEARCHED = ["ACADS 1c", "ACADS 3a circles only", "Greco 4 circles", "Low 1989 #24 phi=0"]


@pytest.mark.parametrize("case", GIVEN, ids=lambda case: case["name"])
def test_factors_of_published_circles(case: dict[str, Any]) -> None:
    """Beside values that are given to four decimals."""
    for name, difference in differences_of(case, solved(case)).items():
        assert abs(difference) < 6e-5 / case[name] + 2e-5


@pytest.mark.parametrize("case", [case for case in CASES if case["name"] in SEARCHED], ids=lambda case: case["name"])
def test_least_factors_of_published_slopes(case: dict[str, Any]) -> None:
    assert abs(differences_of(case, solved(case))["bishop"]) < 1e-3


def test_a_drowned_slope_is_the_buoyant_one_in_all_methods() -> None:
    """Archimedes: with water level far above, weights less that of water and no water."""
    drowned = Slope(GROUND, 5e3, 0.4, 20e3, pond=40.0)
    buoyant = Slope(GROUND, 5e3, 0.4, 20e3 - 9810.0)
    section = Section(GROUND, (30, 45), 48.0, 1.0)
    for method, factor in at_circle(buoyant, section).factor_of_safety.items():
        assert at_circle(drowned, section).factor_of_safety[method] == pytest.approx(factor, rel=1e-13)


def test_strips_are_the_definition() -> None:
    """The factor that a motion starts from, by the paper's method with strips, is the one of statics."""
    section = profile("constant friction")
    slope = Slope(GROUND, layers=section.layers)
    statics = at_circle(slope, Section(GROUND, (30, 45), 48.0, 1.0)).factor_of_safety["paper"]
    assert solve(Scene(section, effects=TURNING)).factor_of_safety == pytest.approx(statics, rel=1e-10)
    assert factors_of_safety(Scene(section))["paper"] == pytest.approx(statics, rel=1e-12)
