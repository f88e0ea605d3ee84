"""Cohesion that changes with slip, of one soil and of layers, beside definitions and plain integrations."""

from dataclasses import replace
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from slipcircle import Arc, LayeredSection, Scene, Section, Soil, backanalyse, plan, solve
from slipcircle.derivatives import with_parameter_arrays
from slipcircle.workbench.stability.stability import factors_of_safety
from tests.campaigns import combined
from tests.support.along_the_arc import of_scene, under_chord

TURNING: dict[str, Any] = {"rotation": {}, "centripetal": {}}
CIRCLE: Any = {"ground": [(-40, 0), (0, 0), (20, 10), (60, 10)], "centre": (2.0, 18.0), "radius": 20.0}
LAW: dict[str, Any] = {"law": "exponential", "peak": 14e3, "residual": 4e3, "length": 0.4}
TABLE = {"law": "tabulated", "slip": [0.0, 0.2, 0.4, 1.0, 3.0], "cohesion": [14e3, 9e3, 6e3, 5e3, 4e3]}


@pytest.mark.parametrize("name", ["exponential", "linear", "hyperbolic", "function"])
def test_an_arc_runs_as_far_as_a_plain_integration_says(name: str) -> None:
    """Motions without friction and with rising cohesion are included."""
    rng = np.random.default_rng(58)
    moved = 0
    while moved < 2:
        radius = rng.uniform(10.0, 60.0)
        middle, alpha = rng.uniform(4.2, 4.5), rng.uniform(0.3, 0.8)
        arc = Arc(radius, middle - alpha, middle + alpha, rng.uniform(15e3, 22e3))
        mu = float(rng.choice([0.0, 0.05]))
        peak, residual = rng.uniform(0.002, 0.02, 2) * arc.unit_weight * radius
        law: Any = {"law": name, "peak": peak, "residual": residual, "length": rng.uniform(0.1, 2.0)}
        if name == "function":
            law = lambda slip, p=peak, r=residual: r + (p - r) / (1.0 + np.square(slip))  # noqa: E731
        effect = {"cohesion": law} if callable(law) else law
        motion = solve(Scene(arc, mu, TURNING | {"cohesion": effect}))
        if motion.run_out > 0.0:
            moved += 1
            section = replace(motion.plan.scene, arc=under_chord(arc))
            assert motion.run_out == pytest.approx(of_scene(section).motion().distance, rel=1e-8)
            assert abs(motion.energy_error_estimate) < 1e-13


@pytest.mark.parametrize("strength", ["base", "mass"])
def test_layers_accelerate_as_their_strength_at_this_slip_says(strength: str, tmp_path: Path) -> None:
    """Laws of friction and of cohesion and growth with depth, with the base and with the mass, along the way."""
    layers = (
        motion for drawn, motion in combined.motions(3, tmp_path) if drawn.count > 1 if drawn.strength == strength
    )
    for motion in islice(layers, 2):
        scene: Any = motion.plan.scene
        for share in (0.05, 0.2, 0.5, 0.9):
            state = motion.at(share * motion.farthest.time)
            expected = of_scene(scene).acceleration(state, scene.strength_factor)
            assert state.acceleration == pytest.approx(expected, rel=1e-9, abs=1e-10)


@pytest.mark.parametrize("end", [3.0, 3.0 + 1e-6])
def test_laws_that_break_at_the_same_slip_all_pass_their_breaks(end: float) -> None:
    """Two tables of friction, and friction and cohesion that fall over one length, whatever the rounding."""
    table = {"law": "tabulated", "slip": [0.0, 0.2, 0.4, 1.0, 3.0], "coefficient": [0.3, 0.2, 0.15, 0.12, 0.1]}
    other = table | {"slip": [0.0, 0.2, 0.4, 1.0, end]}
    alone = solve(Scene(Section(unit_weight=19e3, **CIRCLE), table, TURNING))
    soils = [Soil(19e3, 0.0, law, name=name) for law, name in ((table, "a"), (other, "b"))]
    section = LayeredSection(layers=[(soils[0], None), (soils[1], 2.0)], strength="mass", **CIRCLE)
    assert solve(Scene(section, None, TURNING)).run_out == pytest.approx(alone.run_out, rel=1e-11 + (end - 3.0))
    linear = {"law": "linear", "length": 0.4}
    soil = Soil(19e3, linear | {"peak": 12e3, "residual": 4e3}, linear | {"peak": 0.08, "residual": 0.05}, name="a")
    section = LayeredSection(layers=[(soil, None)], **CIRCLE)
    assert solve(Scene(section, None, TURNING)).run_out == pytest.approx(
        of_scene(Scene(section)).motion().distance, rel=1e-8
    )


def test_the_share_of_cohesion_that_slip_has_left() -> None:
    """The law at the slip of the whole way over its peak, and 1 without cohesion."""
    section = Section(unit_weight=19e3, **CIRCLE)
    for cohesion, mu in ({"cohesion": LAW}, 0.05), ({}, 0.15):
        motion = solve(Scene(section, mu, TURNING | cohesion))
        history = motion._history
        share = history.forces.kept_cohesion(history._states(np.array([0.0, motion.settling_time])))
        slip = 2.0 * motion.run_out - motion.end.displacement  # it turns back once at most
        left = LAW["residual"] + (LAW["peak"] - LAW["residual"]) * np.exp(-slip / LAW["length"])
        assert motion.run_out > 0.0
        assert share == pytest.approx([1.0, left / LAW["peak"] if cohesion else 1.0], rel=1e-12)


def test_a_constant_law_is_a_number() -> None:
    section = Section(unit_weight=19e3, **CIRCLE)
    number, law = ({"cohesion": 8e3}, {"law": "constant", "cohesion": 8e3})
    one, other = (solve(Scene(section, 0.05, TURNING | {"cohesion": given})) for given in (number, law))
    assert one.run_out == other.run_out
    assert plan(one.plan.scene).recipe == plan(other.plan.scene).recipe


def test_arrays_derivatives_and_fits_know_the_numbers_of_the_law() -> None:
    section = Section(unit_weight=19e3, **CIRCLE)
    scene = Scene(section, 0.05, TURNING | {"cohesion": LAW})
    step = np.array([3900.0, 4000.0, 4100.0])
    lanes = solve(Scene(section, 0.05, TURNING | {"cohesion": LAW | {"residual": step}}))
    singly = [solve(Scene(section, 0.05, TURNING | {"cohesion": LAW | {"residual": float(x)}})).run_out for x in step]
    np.testing.assert_allclose(lanes.run_out, singly, rtol=1e-9)
    slope = solve(scene).sensitivity().derivative("run_out", "cohesion.residual")
    assert slope == pytest.approx((singly[2] - singly[0]) / 200.0, rel=1e-2)
    found = backanalyse(scene, run_out=singly[0], field="cohesion.residual_kPa")
    assert found.value == pytest.approx(3.9, rel=1e-6)


MISTAKES: dict[str, tuple[Any, str]] = {
    "law": ({"law": "linnear", "peak": 1e4, "residual": 1e3, "length": 1.0}, "effects.cohesion.law = 'linnear'"),
    "missing": ({"law": "linear", "peak": 1e4, "length": 1.0}, "'residual' is missing"),
    "speed": ({"law": "rate_weakening", "peak": 1e4}, "must be one of constant, exponential, linear, hyperbolic"),
    "table": ({"law": "tabulated", "slip": [0.0, 1.0], "cohesion": [1e3]}, "two lists of equal length"),
}


@pytest.mark.parametrize("kind", MISTAKES)
def test_mistakes_in_a_law_of_cohesion_are_named(kind: str) -> None:
    given, words = MISTAKES[kind]
    with pytest.raises(ValueError, match=words):
        Scene(Arc(20.0, 3.7, 5.2, 19e3), 0.1, {"cohesion": given})


def test_layers_on_the_base_share_the_law_and_length_of_cohesion() -> None:
    soils = [Soil(19e3, LAW | {"length": length}, name=name) for length, name in ((0.4, "a"), (0.5, "b"))]
    layers = [(soils[0], None), (soils[1], 2.0)]
    with pytest.raises(ValueError, match="the cohesion of soils along an arc follows one law of slip with one length"):
        LayeredSection(layers=layers, **CIRCLE)
    assert solve(Scene(LayeredSection(layers=layers, strength="mass", **CIRCLE), None, TURNING)).moves


@pytest.mark.parametrize("law", [LAW, {"cohesion": lambda slip: 4e3 + 10e3 * np.exp(-slip / 0.4)}])
def test_a_factor_of_strength_multiplies_the_law_of_cohesion(law: Any) -> None:
    section = Section(unit_weight=19e3, **CIRCLE)
    weaker = {**LAW, "peak": 0.9 * 14e3, "residual": 0.9 * 4e3}
    known = solve(Scene(section, 0.045, TURNING | {"cohesion": weaker}))
    motion = solve(Scene(section, 0.05, TURNING | {"cohesion": law}, strength_factor=0.9))
    assert motion.run_out == pytest.approx(known.run_out, rel=1e-11)
    soil = Soil(19e3, law.get("cohesion", law), 0.05, name="clay")
    layered = LayeredSection(layers=[(soil, None)], strength="mass", **CIRCLE)
    motion = solve(Scene(layered, None, TURNING, strength_factor=0.9))
    assert motion.run_out == pytest.approx(known.run_out, rel=1e-11)


# --- growth with depth -----------------------------------------------------------------------------------------------

GROWING: list[dict[str, Any]] = [
    {"cohesion": {"cohesion": 3e3, "gradient": 700.0}},
    {"cohesion": {"cohesion": 3e3, "gradient": 700.0, "datum": 4.0}},
    {"cohesion": LAW | {"peak": 5e3, "gradient": 700.0}},
]


@pytest.mark.parametrize("effects", GROWING)
def test_cohesion_of_one_soil_grows_as_that_of_one_layer(effects: dict[str, Any]) -> None:
    """Cohesion grows below the ground or a height, with or without a law, in motion, statics, lanes and derivatives."""
    section = Section(unit_weight=19e3, **CIRCLE)
    law = dict(effects["cohesion"])
    growth = {"cohesion_gradient": law.pop("gradient"), "datum": law.pop("datum", None)}
    soil = Soil(19e3, law if "law" in law else law["cohesion"], 0.05, name="soil", **growth)
    layered = Scene(LayeredSection(layers=[(soil, None)], **CIRCLE), None, TURNING)
    scene = Scene(section, 0.05, TURNING | effects)
    one, other = solve(scene), solve(layered)
    assert one.run_out == pytest.approx(other.run_out, rel=1e-12)
    assert one.factor_of_safety == pytest.approx(float(factors_of_safety(scene)["paper"]), rel=1e-9)
    assert factors_of_safety(scene)["bishop"] == pytest.approx(factors_of_safety(layered)["bishop"], rel=1e-13)
    steps = np.array([600.0, 700.0, 800.0])
    lanes = solve(with_parameter_arrays(scene, {"cohesion.gradient": steps})[0])
    assert lanes.run_out[1] == pytest.approx(one.run_out, rel=1e-8)
    slope = one.sensitivity().derivative("run_out", "cohesion.gradient")
    assert slope == pytest.approx((lanes.run_out[2] - lanes.run_out[0]) / 200.0, rel=2e-2)


def test_a_height_is_a_flat_line_and_the_ground_its_own_line() -> None:
    """Datums of layers: a height, the same as a line, and that of the soil; a line along the ground is the ground."""
    sand, clay = Soil(19e3, 0.0, 0.3, name="sand"), Soil(19e3, 3e3, 0.04, cohesion_gradient=700.0, name="clay")
    named = Soil(19e3, 3e3, 0.04, cohesion_gradient=700.0, datum=5.0, name="clay")
    tops: list[Any] = [5.0, [(-40.0, 5.0), (60.0, 5.0)]]
    made = [[(sand, None), (clay, tops[0])], [(sand, None), (clay, tops[1])], [(sand, None), (named, 5.0)]]
    made += [[(clay, None)], [(sand, None), (clay, CIRCLE["ground"])]]
    found = [solve(Scene(LayeredSection(layers=layers, **CIRCLE), None, TURNING)).run_out for layers in made]
    assert found[1:3] == pytest.approx([found[0]] * 2, rel=1e-12)
    assert found[4] == pytest.approx(found[3], rel=1e-12)


def test_growth_without_a_ground_or_a_peak_is_refused() -> None:
    section = Section(unit_weight=19e3, **CIRCLE)
    arc = Arc(60.0, 3.8, 5.0, 19e3)
    peakless = LAW | {"peak": 0.0, "gradient": 700.0}
    for mass, cohesion, words in (
        (arc, GROWING[0]["cohesion"], "gradient: needs a ground"),
        (section, peakless, "peak = 0: must be positive"),
        (section, {"cohesion": 3e3, "gradient": 700.0, "datum": [4.0, 5.0]}, "datum = .*: must be one number"),
        (section, {"cohesion": 3e3, "gradient": -1.0}, "gradient = -1: must be growth"),
    ):
        with pytest.raises(ValueError, match=words):
            Scene(mass, 0.05, TURNING | {"cohesion": cohesion})
    foreland = Soil(19e3, 3e3, 0.1, cohesion_gradient=700.0, name="beyond")
    with pytest.raises(ValueError, match=r"soils.beyond.datum: is missing"):
        LayeredSection(layers=[(Soil(19e3, name="soil"), None)], foreland=foreland, **CIRCLE)
