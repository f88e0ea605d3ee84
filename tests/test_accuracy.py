"""Accuracy is what the user gets: 400 random scenes against their motion to 20 and 30 digits, and the estimated error.

300 are of position and speed, 100 of time, rates and heat. `python -m tests.campaigns.references --fresh 1000` takes
new ones.
"""

import hashlib
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import slipcircle
from generated import layout as ix
from slipcircle import Arc, Scene, load, solve
from slipcircle.core.flow.problem import Problem
from tests.support import references, taylor, vaiont
from tests.support.accuracy import DATA, MANY, NUMBERS, ROWS, TIMED, error, near_limit, off, scene, solved, true_error


def test_the_file_holds_400_scenes_of_every_kind() -> None:
    assert [row["group"] for row in ROWS] == [group for group, _ in references.names()]
    assert sum(near_limit(k) for k in range(300)) >= 20
    motions = [row["reference"] for row in ROWS]
    assert {(m["moves"], m["arrested"]) for m in motions} == {(True, True), (True, False), (False, True)}
    assert sum(m["phases"] > 1 for m in motions[:300]) > 50
    assert sum(m["phases"] > 1 for m in motions[300:]) > 10
    assert all(bool(solved(k).lift_off) == motions[k]["lifted"] for k in (*NUMBERS, *TIMED))
    assert sum(m["lifted"] for m in motions) >= references.LIFTED


def met(group: str) -> None:
    """Decisions are those of the references, and the estimate is at or above the true error."""
    for k in (k for k in (*NUMBERS, *TIMED) if ROWS[k]["group"] == group):
        motion, reference = solved(k), ROWS[k]["reference"]
        assert (motion.moves, motion.arrested) == (reference["moves"], reference["arrested"]), f"scene {k}"
        assert motion.error_estimate >= max(error(k)), f"scene {k}: {motion.error_estimate:.1e} < {error(k)}"


@pytest.mark.parametrize("group", references.STEADY)
def test_estimate_is_at_least_the_true_error(group: str) -> None:
    met(group)


@pytest.mark.parametrize("group", references.TIMED)
def test_accuracy_is_what_the_user_gets(group: str) -> None:
    met(group)


@pytest.fixture
def implicit(monkeypatch: pytest.MonkeyPatch) -> None:
    """What stiff lanes get is got from the first step on: another method on the same program."""
    begun = Problem.initial_cells

    def spent(problem: Problem) -> Any:
        cells = begun(problem)
        cells[ix.STEPS] = ix.MOST_STEPS  # of what explicit steps a lane may take
        return cells

    monkeypatch.setattr(Problem, "initial_cells", spent)


@pytest.mark.parametrize("part", range(2))
def test_implicit_steps_tell_the_same(part: int, implicit: None) -> None:
    """Of every twentieth scene."""
    for k in range(5 + part, 400, 40):
        motion, reference = slipcircle.solve(scene(ROWS[k])), ROWS[k]["reference"]
        assert (motion.moves, motion.arrested) == (reference["moves"], reference["arrested"]), f"scene {k}"
        assert bool(motion.lift_off) == reference["lifted"], f"scene {k}"
        assert motion.error_estimate >= max(true_error(motion, reference)), f"scene {k}"


def test_estimate_is_at_most_the_accuracy_unless_a_warning_says_so() -> None:
    for k in (*NUMBERS, *TIMED):
        motion = solved(k)
        warned = any("ill-conditioned" in w for w in motion.warnings)
        assert warned == (motion.error_estimate > motion.plan.accuracy), f"scene {k}"
        many = ROWS[k]["reference"]["phases"] > MANY
        assert not warned or (k in NUMBERS and (near_limit(k) or many)), f"scene {k}"


def test_estimate_is_not_much_above_the_true_error() -> None:
    ratios = [solved(k).error_estimate / max(*error(k), 1e-17) for k in NUMBERS if ROWS[k]["reference"]["moves"]]
    assert np.median(ratios) < 100


def test_true_errors_are_rounding() -> None:
    # of what is not next to its limit: far below any accuracy that may be asked for
    plain = np.array([error(k) for k in NUMBERS if not near_limit(k) and ROWS[k]["reference"]["phases"] < MANY])
    assert np.median(plain, axis=0).max() < 2e-15
    assert plain.max() < 1e-11


def test_energy_balances_at_all_times() -> None:
    for k in TIMED:
        motion = solved(k)
        energy = motion.energy_at(np.array([*ROWS[k]["reference"]["times"], motion.duration]))
        assert np.max(np.abs(energy.residual)) <= 1e-9 * max(np.max(np.abs(energy.work)), np.max(energy.dissipation)), k


@pytest.mark.parametrize("accuracy", [1e-4, 1e-11, 1e-12])
def test_other_accuracies(accuracy: float) -> None:
    few = [*(NUMBERS[::7] if accuracy != 1e-11 else []), *(TIMED[::6] if accuracy != 1e-12 else [])]
    for k in few:
        motion = slipcircle.solve(scene(ROWS[k]), accuracy)
        assert motion.error_estimate >= max(true_error(motion, ROWS[k]["reference"])), f"scene {k}"
        assert motion.error_estimate <= accuracy or (motion.warnings and k in NUMBERS), f"scene {k}"


def test_steps_converge() -> None:
    """The errors of lanes fall with the accuracy that is asked for, in proportion or faster, until rounding."""

    def missed(number: int, accuracy: float) -> float:
        given, reference = scene(ROWS[number]), ROWS[number]["reference"]
        lanes = solve(replace(given, initial_velocity=np.full(2, given.initial_velocity)), accuracy)
        found = lanes.run_out[0], lanes.peak.velocity[0]
        wanted = reference["run_out"], reference["peak_velocity"]
        return max(off(x, y, y) for x, y in zip(found, wanted, strict=True))

    rows = [300 + k for k in (0, 11, 40, 58, 66, 91)]
    errors = np.array([[missed(k, a) for a in (1e-4, 1e-6, 1e-8, 1e-10)] for k in rows])
    geometric = np.exp(np.mean(np.log(np.maximum(errors, 1e-16)), axis=0))
    assert np.all(geometric[1:] < 0.1 * geometric[:-1])


@pytest.mark.parametrize("near", [0.0, 1e-15, -1e-15])
def test_a_decision_that_rounding_makes_is_not_silent(near: float) -> None:
    arc = Arc(100.0, np.radians(190.0), np.radians(280.0), 2e4)
    limit = slipcircle.solve(Scene(arc, 1.0, {"rotation": {}})).limit_friction
    motion = slipcircle.solve(Scene(arc, limit * (1.0 + near), {"rotation": {}}))
    assert motion.error_estimate > 0.01
    assert any("ill-conditioned" in w for w in motion.warnings)


def again(row: dict[str, Any]) -> bool:
    """Whether a row's motion is found again, to its last digits."""
    known = references.digits(row["group"])
    return references.agree(taylor.solve(row["scene"], row["shares"], known), row["reference"], known)


def test_fifteen_references_are_derived_again() -> None:
    seed = int.from_bytes(hashlib.sha256(DATA).digest()[:8])
    few = [k for k, row in enumerate(ROWS) if row["reference"]["phases"] < MANY // 5]
    rng = np.random.default_rng(seed)
    for k in [*rng.choice([k for k in few if k in NUMBERS], 10, False), *rng.choice([*TIMED], 5, False)]:
        assert again(ROWS[int(k)]), f"scene {k} of seed {seed}"


@pytest.mark.parametrize("length", [1e-9, 1e-6, 1e-2, 1.0, 1e4, 1e12])
def test_a_callable_with_any_length_at_its_start_is_seen(length: float) -> None:
    """Panels know nothing of a callable's scale; what falls within a hair of the start must not pass unseen."""
    named = replace(load("vaiont"), friction={"law": "exponential", "peak": 0.41, "residual": 0.18,
                                                    "length": length})  # fmt: skip
    free = replace(named, friction=lambda slip: 0.18 + 0.23 * np.exp(-slip / length))
    one, other = solve(named), solve(free)
    for a, b in ((one.run_out, other.run_out), (one.peak.velocity, other.peak.velocity),
                 (one.duration, other.duration)):  # fmt: skip
        assert abs(a / b - 1.0) <= 1e-12


NAMED: dict[str, Any] = {"law": "exponential", "peak": 0.37, "residual": 0.17, "length": 3.0}


def falling(slip: Any) -> Any:
    """The law `NAMED` as a function."""
    return 0.17 + 0.2 * np.exp(-slip / 3.0)


@pytest.mark.parametrize("radius", [vaiont.RADIUS, np.array([500.0, 1500.0, 6000.0])])
def test_a_callable_is_known_wherever_the_mass_is(radius: Any) -> None:
    """Its first table ends at R/256; friction beyond is that of the function, on the way and at once."""
    scene: Scene[Any] = load("vaiont")
    scene = replace(scene, arc=replace(scene.arc, radius=radius))
    one, other = solve(replace(scene, friction=falling)), solve(replace(scene, friction=NAMED))
    times = np.linspace(0.0, 25.0, 6)
    assert one.peak.normal_stress == pytest.approx(other.peak.normal_stress, rel=1e-12)
    assert one.friction_at(times) == pytest.approx(falling(one.path_at(times)), rel=1e-12)
    assert one.run_out == pytest.approx(other.run_out, rel=1e-11)
    assert one.holding_friction_at(times) == pytest.approx(other.holding_friction_at(times), rel=1e-11)


def test_a_callable_of_a_creeping_mass_goes_on(implicit: None) -> None:
    """Also where implicit steps pass the end of its table."""
    scene: Scene[Any] = load("vaiont")
    slow = {"viscosity": {"viscosity": 1e9, "thickness": 0.5}}
    scene = replace(scene, effects={**scene.called, **slow}, end_time=1e5)
    one, other = solve(replace(scene, friction=falling)), solve(replace(scene, friction=NAMED))
    assert one.run_out > 4 * float(np.max(scene.arc.radius)) / 256
    assert one.run_out == pytest.approx(other.run_out, rel=1e-12)
    assert one.friction_at(1e5) == pytest.approx(falling(one.run_out), rel=1e-12)


def test_a_callable_that_changes_too_sharply_is_refused() -> None:
    """Within 2^-40 of how far it was asked, nothing is told apart: the sentence names the place."""
    with pytest.raises(ValueError, match=r"^friction: the function changes too sharply near 0 to be followed"):
        solve(replace(load("vaiont"), friction=lambda slip: 0.18 + 0.23 * np.exp(-slip / 1e-12)))


@pytest.mark.parametrize("accuracy", [0.9, 0.2, 1e-3])
def test_lanes_take_any_accuracy(accuracy: float) -> None:
    vaiont: Any = load("vaiont")
    scene = replace(vaiont, friction=np.linspace(0.15, 0.3, 9))
    found, best = solve(scene, accuracy), solve(scene, 1e-15)
    for name, value in best.outcomes.items():
        assert np.all(np.abs(found.outcomes[name] / value - 1.0) <= np.minimum(accuracy, found.error_estimate))
