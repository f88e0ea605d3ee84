"""Layered sections: motions against their definition along the arc and other solvers; factors of published slopes."""

from dataclasses import replace
from itertools import product
from typing import Any

import numpy as np
import pytest

from slipcircle import Scene, Section, load, solve
from slipcircle.derivatives.parameters import with_parameter_arrays
from slipcircle.layers import LayeredSection, Soil, soils_under, stretches
from slipcircle.layers.strength import Needs
from slipcircle.tables import Series
from slipcircle.workbench.outputs.json_records import foreland_words
from slipcircle.workbench.outputs.tables import plan_part, stretches_part
from slipcircle.workbench.stability.critical import at_circle
from slipcircle.workbench.stability.stability import Slope
from tests.campaigns.layered_benchmarks import CASES, differences, solved
from tests.support.along_the_arc import AlongTheArc, random_section
from tests.support.lanes import RotationTables, backend
from tests.support.layered import BELOW_GROUND, CRACKED, GROUND, RICH, TURNING, of_each_soil, profile, sloping

FORELAND = Soil(18e3, 2e3, 0.4, None, 500.0, 8.0, name="foreland")


@pytest.mark.parametrize(("strength", "foreland"), [("base", None), ("base", FORELAND), ("mass", None)])
def test_a_layered_mass_accelerates_as_its_weight_and_strength_along_the_arc_say(strength: str, foreland: Any) -> None:
    """Water, pore pressure ratios, growing cohesion, surcharges and saturated weights act up- and down-slope."""
    rng = np.random.default_rng(2)
    for velocity in [0.0, -5.0] * 3:
        section = random_section(rng, 0.25, strength=strength, foreland=foreland, crack=rng.choice([0.0, 2.0]))
        scene = Scene(section, effects=TURNING, initial_velocity=velocity, end_time=20.0)
        motion, arc = solve(scene), AlongTheArc(section, section)
        assert motion.energy_error_estimate < 1e-14
        for time in motion.duration * np.linspace(0.01, 0.99, 15 * motion.moves):
            state = motion.at(time)
            stress, pressure = arc.means(state)
            assert state.acceleration == pytest.approx(arc.acceleration(state), rel=0, abs=1e-13)
            assert state.normal_stress == pytest.approx(stress, rel=1e-13)
            assert motion.pore_pressure_at(time) == pytest.approx(pressure, rel=1e-12, abs=1e-12 * stress)


def shaken(k_h: float, k_v: float) -> dict[str, Any]:
    """Steady shaking of a turning mass."""
    horizontal, vertical = (Series(np.array([0.0, 100.0]), np.full(2, k)) for k in (k_h, k_v))
    return {"rotation": {}, "centripetal": {}, "shaking": {"horizontal": horizontal, "vertical": vertical}}


SLOWER = {"law": "rate_weakening", "peak": 1.0, "residual": 0.8, "velocity": 0.5}
LOAD: dict[str, Any] = {"surcharge": [(-3.0, 2.0, 2e4, 4e4)], "rate": SLOWER}
ONE_SOIL = "one soil in four layers, under water"


@pytest.mark.parametrize(
    ("section", "effects", "velocity", "run_out"),
    [
        (profile(ONE_SOIL, "base"), TURNING, 3.383403121, 14.307542564),
        (profile(ONE_SOIL, "mass"), TURNING, 3.383403121, 14.307542564),
        (profile("softening", "base"), TURNING, 1.915602114, 8.397668319),
        (profile("softening", "mass"), TURNING, 2.025732503, 9.189842726),
        (profile("softening", "base", **LOAD), shaken(0.05, 0.02), 4.26345513922, 18.5701151669),
        (profile("softening", "mass", **LOAD), shaken(0.05, 0.02), 4.41560123103, 19.3144981725),
        (of_each_soil(**LOAD), TURNING, 3.42716319536, 15.4005871165),
        (of_each_soil(level=BELOW_GROUND), shaken(0.03, 0.02), 4.17568402086, 18.183057204),
    ],
)
def test_motions_of_softening_soils_are_those_of_another_integrator(
    section: LayeredSection, effects: Any, velocity: float, run_out: float
) -> None:
    """DOP853 of the definition along the arc, rtol = 2e-13; energy is kept; as without a compiler."""
    motion = solve(Scene(section, effects=effects, end_time=60.0))
    assert (motion.peak.velocity, motion.run_out) == pytest.approx((velocity, run_out), rel=1e-9)
    assert max(motion.energy_error_estimate, motion.error_estimate) < 1e-11
    with backend("NumPy"):
        assert solve(motion.plan.scene).run_out == pytest.approx(motion.run_out, rel=1e-11)


@pytest.mark.parametrize("cohesion", [0.0, 5e4])
def test_pore_pressure_that_travels_with_the_soils_lifts_the_mass_where_it_is_the_stress(cohesion: float) -> None:
    """Pore pressure ratios with the strength of the mass: a number, while the stress falls as the mass turns."""
    numbers = zip((18e3, 19e3, 17e3, 21e3), (0.9, 0.95, 0.85, 0.9), "abcd", strict=True)
    soils = [Soil(weight, cohesion, 0.3, pore_ratio=ratio, name=name) for weight, ratio, name in numbers]
    section = sloping(soils, strength="mass")
    motion = solve(Scene(section, effects=TURNING, initial_velocity=12.0, end_time=20.0))
    arc = AlongTheArc(section, section)
    assert motion.lift_off
    for time in motion.lift_off:
        stress, pressure = arc.means(motion.at(time))
        assert stress == pytest.approx(pressure, rel=1e-13)
    stress, pressure = arc.means(motion.at(0.9 * motion.lift_off[0]))
    assert stress > pressure


def test_circles_with_other_unit_weights_are_weighed_anew() -> None:
    """A section with other soils reuses the geometry, but no sums of weights."""
    scene = Scene(replace(sloping(RICH), radius=np.array([48.0, 47.5])), effects=TURNING)
    before = solve(scene).run_out
    heavier, _ = with_parameter_arrays(scene, {"soils.b.unit_weight": np.array([25e3, 25e3])})
    soils = [replace(soil, unit_weight=25e3) if soil.name == "b" else soil for soil in RICH]
    anew = Scene(replace(sloping(soils), radius=np.array([48.0, 47.5])), effects=TURNING)
    assert solve(heavier).run_out == pytest.approx(solve(anew).run_out, rel=1e-12)
    assert np.all(np.abs(solve(anew).run_out - before) > 1e-3)


def test_each_circle_of_many_has_its_own_weights() -> None:
    """Circles lie in several parts of a profile; those at the ends of parts move as they do alone."""
    one = Scene(sloping(RICH), effects=TURNING)
    numbers = {"radius": np.linspace(46.0, 48.0, 205), "soils.a.unit_weight": np.linspace(18e3, 22e3, 205)}
    run_out = solve(with_parameter_arrays(one, numbers)[0]).run_out
    for k in (0, 99, 100, 199, 204):
        alone, _ = with_parameter_arrays(one, {name: values[k : k + 1] for name, values in numbers.items()})
        assert run_out[k] == pytest.approx(solve(alone).run_out[0], rel=1e-9)


def test_stretches_carry_the_means_along_the_arc() -> None:
    rng = np.random.default_rng(1)
    for section in (random_section(rng), random_section(rng), profile(ONE_SOIL)):
        arc = AlongTheArc(section, section)
        columns = arc.columns()
        above = (columns.soil + columns.load) * np.cos(columns.b) * columns.length
        pressure = columns.pressure * columns.length
        strength = columns.cohesion * columns.length + columns.friction * (above[0] - pressure)
        rows = stretches(section)
        assert {row.soil for row in rows} <= {*section.soils}
        for row in rows:
            here = (row.start < columns.b) & (columns.b < row.end)
            sums = [(values * here).sum() for values in (columns.length, above[0], pressure, strength, above[6])]
            assert np.all(columns.friction[here] == row.soil.friction)
            computed = np.array([1.0, row.normal_stress, row.pore_pressure, row.strength]) * row.length / arc.radius
            assert [*computed, row.weight_share * above[6].sum()] == pytest.approx(sums, rel=1e-11)


@pytest.mark.parametrize("strength", ["base", "mass"])
def test_soils_under_a_turned_mass_are_those_at_its_arc(strength: str) -> None:
    """Soils stay in space with the base, or turn with the mass."""
    section, rotation = profile("constant friction", strength), 0.2
    soils, ends = soils_under(section, rotation)
    (first,), (last,) = section._span
    assert ends[[0, -1]] == pytest.approx([first + rotation, last + rotation], abs=1e-14)
    at = (ends[1:] + ends[:-1]) / 2 - (rotation if strength == "mass" else 0.0)
    x, y = 30.0 + 48.0 * np.sin(at), 45.0 - 48.0 * np.cos(at)
    tops = [np.interp(x, *np.transpose(GROUND)), *(np.full(x.size, top) for _, top in section.layers[1:])]
    layers = np.count_nonzero(np.minimum.accumulate(tops) > y, axis=0) - 1
    inside = at < last
    assert np.array(soils)[inside].tolist() == layers[inside].tolist()
    assert len(set(soils)) > 2


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
    """Turning, frozen, and as it sticks and slips again."""
    tops = (None, 17.0, [(-60, 15), (20, 4), (120, -3)], -1.0)
    layered = sloping([Soil(19e3, 4e3, law, name=name) for name in "abcd"], tops, strength=strength, level=BELOW_GROUND)
    section = Section(GROUND, (30, 45), 48.0, 19e3, level=BELOW_GROUND)
    sine = {"pulse": "sine", "amplitude": 0.3, "duration": 9.0, "cycles": 7}
    turning: dict[str, Any] = {"rotation": {}, "centripetal": {}}
    for effects, end in ((turning, None), ({}, 3.0), (turning | {"shaking": sine}, 12.0)):
        one = solve(Scene(section, law, effects | {"cohesion": {"cohesion": 4e3}}, end_time=end))
        many = solve(Scene(layered, effects=effects, end_time=end))
        for name in ("factor_of_safety", "limit_friction", "run_out", "duration"):
            assert getattr(many, name) == pytest.approx(getattr(one, name), rel=1e-12)
        assert len(many.phases) == len(one.phases)


@pytest.mark.parametrize("strength", ["base", "mass"])
def test_motions_beyond_their_tables_have_longer_ones(strength: str, monkeypatch: pytest.MonkeyPatch) -> None:
    one = Scene(profile("softening", strength), effects=TURNING)
    scenes = one, with_parameter_arrays(one, {"radius": np.array([48.0, 47.5])})[0]
    expected = [solve(scene).run_out for scene in scenes]
    monkeypatch.setattr(RotationTables, "likely_reach", lambda tables, friction: 0.01)
    for scene, run_out in zip(scenes, expected, strict=True):
        assert solve(scene).run_out == pytest.approx(run_out, rel=1e-12)


@pytest.mark.parametrize(
    ("soils", "tops", "crack", "name"),
    [
        ([0, 1, 2], (None, 6.0, -3.0), 0.0, "layers.3.top"),  # touches the arc without crossing it
        ([2], (None,), 20.0 - (45.0 - np.sqrt(48.0**2 - 30.0**2)), "crack"),  # from the brow at (0, 20) down to the arc
    ],
)
def test_where_a_boundary_touches_the_arc_there_is_no_derivative(soils: Any, tops: Any, crack: Any, name: str) -> None:
    """The derivative has the root of a step there, or another mass is cut off; a warning says that it is absent."""
    constant = [profile("constant friction").soils[k] for k in soils]
    found = solve(Scene(sloping(constant, tops, crack=crack), effects=TURNING)).sensitivity()
    assert found.kind("run_out", name) == "unresolved"
    assert np.isnan(found.derivative("run_out", name))
    assert any(warning.startswith(f"{name}: ") for warning in found.warnings)


SLIDING = [Soil(19e3, 0.0, {"law": "linear", "peak": 0.4, "residual": 0.0, "length": length}, name=str(length))
           for length in (1.0, 2.0)]  # fmt: skip


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"layers": []}, "layers: must be pairs of a Soil and its top"),
        ({"layers": [(Soil(19e3), 3.0)]}, r"layers\[0\]: top = 3.0: must be None"),
        ({"layers": [(Soil(19e3), None), (Soil(19e3, name="b"), None)]}, r"layers\[1\]: top is missing"),
        ({"layers": list(zip(SLIDING, (None, 2.0), strict=True))}, "with strength = 'mass' each may have"),
        ({"layers": list(zip(SLIDING, (None, 2.0), strict=True)), "strength": "mass"}, "must keep some friction"),
        ({"strength": "both"}, "strength = 'both': must be 'base' or 'mass'"),
        ({"foreland": Soil(19e3, name="f"), "strength": "mass"}, "foreland: cannot be combined"),
        ({"surcharge": [(3.0, 1.0, 0.0, 0.0)]}, r"surcharge\[0\]"),
        ({"crack": 40.0}, "crack = 40: is deeper than the mass"),
        ({"radius": 44.0, "centre": (30, 12)}, "above the centre's height|lies below the ground"),
    ],
)
def test_mistakes_are_named(changes: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        replace(sloping([RICH[0], RICH[3]], (None, 2.0)), **changes)


@pytest.mark.parametrize(
    ("section", "friction", "effects", "words"),
    [
        (CRACKED, 0.3, {}, r"friction = 0\.3: is given by the soils"),
        (CRACKED, None, {"cohesion": {"cohesion": 3e3}}, r"effects\.cohesion: is given by the soils"),
        (Section(GROUND, (30, 45), 48.0, 19e3), 0.3, {"layered_strength": {}}, "'layered_strength' is unknown"),
    ],
)
def test_what_soils_say_is_not_said_twice(section: Any, friction: Any, effects: Any, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        Scene(section, friction, effects)


def test_numbers_of_soils_of_an_odd_size_are_questioned() -> None:
    soils = [Soil(19.0, 5e3, 0.3, name="light"), Soil(19e3, 5e3, 30.0, name="rough")]
    warnings = " ".join(solve(Scene(sloping(soils, (None, 2.0)))).warnings)
    assert "soils.light.unit_weight = 19 N/m^3: is that in kN/m^3?" in warnings
    assert "soils.rough.friction = 30: is that an angle?" in warnings


def test_soils_that_soften_alike_have_one_law() -> None:
    """Terms beyond one law are rounding alone if residuals are the same share of their peaks."""
    rng = np.random.default_rng(4)
    for lost, off in product(10 ** rng.uniform(-3, -0.1, 60), (0.0, 1e-11)):
        soils = []
        for name, peak in zip("abcd", rng.uniform(0.05, 0.8, 4), strict=True):
            residual = peak * (1.0 - lost * (1.0 + off * (name == "a")))
            soils.append(
                Soil(18e3, 1e3, {"law": "linear", "peak": peak, "residual": residual, "length": 1.0}, name=name)
            )
        terms = sloping(soils).arc_strength.terms(Needs(rotates=True))
        assert ("remaining_normal" in terms) == (off > 0.0)


# --- layered slopes --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("case", [case for case in CASES if "circle" in case], ids=lambda case: case["name"])
def test_factors_of_published_circles(case: dict[str, Any]) -> None:
    """Factors agree with published values of four decimals."""
    for name, difference in differences(case, solved(case)).items():
        assert abs(difference) < 6e-5 / case[name] + 2e-5


# These have kinks where circles touch boundaries.
@pytest.mark.parametrize(
    "name",
    ["ACADS 1b crack full of water", "ACADS 1c", "ACADS 3a circles only", "Greco 4 circles", "Low 1989 #24 phi=0"],
)
def test_least_factors_of_published_slopes(name: str) -> None:
    """Least factors agree; all slopes by ``python -m tests.campaigns.layered_benchmarks``."""
    (case,) = (case for case in CASES if case["name"] == name)
    assert abs(differences(case, solved(case))["bishop"]) < 1e-3


def test_a_drowned_slope_is_the_buoyant_one_in_all_methods() -> None:
    """Archimedes: with water level far above, weights less that of water and no water."""
    section = Section(GROUND, (30, 45), 48.0, 1.0)
    drowned, buoyant = (
        Slope(GROUND, 5e3, 0.4, 20e3, level=[(-60, 40), (120, 40)]),
        Slope(GROUND, 5e3, 0.4, 20e3 - 9810.0),
    )
    factors, expected = (at_circle(slope, section).factors_of_safety for slope in (drowned, buoyant))
    assert factors == pytest.approx(expected, rel=1e-13)


@pytest.mark.parametrize("facing", [1.0, -1.0])
def test_cohesion_of_the_exit_goes_on_beyond_it_alone(facing: float) -> None:
    """A foreland with the constant cohesion at the exit is the same scene, also after the mass has left its arc."""
    ends = [(facing * 100.0 * np.sin(t), -100.0 * np.cos(t)) for t in (-0.95, -0.45)]
    beyond = [(ends[0][0] - 40.0 * facing, ends[0][1]), *ends, (ends[1][0] + facing, -140.0), (300.0 * facing, -150.0)]
    ground = beyond[:: int(facing)]
    clay = Soil(20e3, 0.0, 0.15, cohesion_gradient=700.0, datum=-80.0, name="clay")
    foreland = Soil(20e3, 700.0 * (-80.0 - ends[1][1]), 0.15, name="foreland")
    grown, constant = (
        solve(Scene(LayeredSection(ground, (0, 0), 100.0, layers=[(clay, None)], foreland=soil), effects=["rotation"]))
        for soil in (None, foreland)
    )
    assert grown.run_out > 60.0
    assert grown.run_out == pytest.approx(constant.run_out, rel=1e-11)


# --- what is said of layered ground ----------------------------------------------------------------------------------


def test_a_state_has_one_normal_stress_whoever_asks() -> None:
    """The plain mean along the arc, whatever has slipped: at the end, the peak, the farthest point, of each lane."""
    one = load("layered-slope")
    values = np.multiply(one.numbers["soils.clay.cohesion"], [1.0, 0.9])
    motion, many = solve(one), solve(with_parameter_arrays(one, {"soils.clay.cohesion": values})[0])
    arc = AlongTheArc(motion.plan.scene.arc, motion.plan.scene.arc)
    for role in ("end", "peak", "farthest"):
        state = getattr(motion, role)
        stress, _ = arc.means(state)
        assert state.normal_stress == pytest.approx(stress, rel=1e-12)
        assert state.normal_stress == pytest.approx(motion.at(state.time).normal_stress, rel=1e-13)
        assert getattr(many, role).normal_stress[0] == pytest.approx(stress, rel=1e-8)
    stresses = motion.at(0.0).normal_stress, motion.plan.scene.arc.static_normal_stress
    assert stresses == pytest.approx([arc.means(motion.at(0.0))[0]] * 2, rel=1e-12)


def test_plans_and_tables_say_what_layered_scenes_do() -> None:
    """Cohesion and pore pressure act by the soils; one reason for one effect; the foreland; the gap of this circle."""
    motion = solve(load("layered-slope"))
    chosen = motion.plan
    assert {"cohesion", "pore_pressure"}.isdisjoint(chosen.left_out)
    assert len({*chosen.why.split("; ")}) == len(chosen.why.split("; "))
    rows = {row[0]: row[1] for row in plan_part(chosen).rows}
    assert not {"a step's operations", "expected cost"} & {*rows}
    assert rows["foreland"] == "the strength of clay, the lowest of the soils that meet there"
    layered = stretches_part(motion)
    assert layered is not None
    assert "strength of clay" in layered.note
    assert foreland_words(replace(chosen.scene.arc, foreland=FORELAND)) == "the strength of foreland, as given"
    assert foreland_words(replace(chosen.scene.arc, strength="mass")) == foreland_words(load("vaiont").arc) == ""
