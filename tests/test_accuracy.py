"""Accuracy is what the user gets: 400 random scenes against their motion to 20 and 30 digits, and the estimated error.

300 are of position and speed, 100 of time, rates and heat. `python -m tests.campaigns.references 1000` draws others.
"""

import hashlib
import json
import math
from dataclasses import replace
from functools import partial
from inspect import unwrap
from typing import Any
from unittest.mock import Mock

import numpy as np
import pytest

import slipcircle
from generated import layout as ix
from slipcircle import Arc, Scene, load, solve
from slipcircle.core.integrator import compiled
from slipcircle.workbench.files.shipped import shipped
from tests.campaigns import estimates
from tests.support import references, section_references, taylor, vaiont
from tests.support.accuracy import DATA, MANY, NUMBERS, ROWS, TIMED, error, near_limit, scene, solved, true_error
from tests.support.lanes import Problem, backend, needs_binary, work


@pytest.mark.parametrize("group", references.STEADY | references.TIMED)
def test_accuracy_is_what_the_user_gets(group: str) -> None:
    """Decisions are those of the references, and the estimate is at or above the true error."""
    for k in (k for k in (*NUMBERS, *TIMED) if ROWS[k]["group"] == group):
        agrees(k, solved(k))


@needs_binary
def test_numpy_is_as_accurate() -> None:
    """Some of each group; `test_flow_compiled` holds that both are the same."""
    for k in (*range(0, 300, 40), *range(300, 400, 20)):
        with backend("NumPy"):
            agrees(k, slipcircle.solve(scene(ROWS[k])))


def agrees(number: int, motion: Any) -> None:
    reference = ROWS[number]["reference"]
    decisions = (motion.moves, motion.arrested, bool(motion.lift_off))
    assert decisions == (reference["moves"], reference["arrested"], bool(reference["lift_off"])), f"scene {number}"
    assert motion.error_estimate >= max(true_error(motion, reference)), f"scene {number}"


# Steps of all scenes of a group together, and the operations on series in them.
WORK = {
    "frozen": (186, 441), "constant": (264, 1477), "exponential": (266, 3001), "linear": (113, 910),
    "hyperbolic": (227, 2267), "tabulated": (1312, 13174), "viscous": (50, 237), "pulse": (294, 2676),
    "series": (313, 3192), "rate": (122, 1025), "rate table": (488, 6729), "prescribed": (65, 448),
    "product": (164, 2359), "heated": (108, 1404), "water": (53, 308), "all": (501, 11335),
    "sections": (293, 3528), "that ship": (305, 3893),
}  # fmt: skip


@needs_binary
@pytest.mark.parametrize("group", WORK)
def test_motions_take_the_work_that_they_took(group: str) -> None:
    """Work grows by a fiftieth at most, and does not fall by more, which would be a different step."""
    if group == "that ship":
        motions = [solve(load(name)) for name in shipped()]
    elif group == "sections":
        rows = json.loads(section_references.FILE.read_text("utf-8"))
        motions = [solve(section_references.scene(row["scene"])) for row in rows]
    else:
        motions = [solved(k) for k, row in enumerate(ROWS) if row["group"] == group]
    assert np.sum([work(motion) for motion in motions], axis=0) == pytest.approx(WORK[group], rel=0.02)


@pytest.fixture
def implicit(monkeypatch: pytest.MonkeyPatch) -> None:
    """Solve by implicit steps from the first step on, with the same program."""
    begun = Problem.cells

    def spent(problem: Problem, *which: Any) -> Any:
        cells = begun(problem, *which)
        cells[ix.STEPS] = ix.MOST_STEPS  # of what explicit steps a lane may take
        return cells

    monkeypatch.setattr(Problem, "cells", spent)


def test_implicit_steps_tell_the_same(implicit: None) -> None:
    for k in range(5, 400, 40):
        agrees(k, slipcircle.solve(scene(ROWS[k])))


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


@needs_binary
def test_estimates_of_ensembles_are_upper_bounds() -> None:
    """A sample of ``python -m tests.campaigns.estimates``.

    From rest an order more may add nothing (158, 401), and where records break off the steps not two either (313, 328).
    """
    cases = [case for number in (*range(0, 400, 80), 158, 313, 328, 401) for case in estimates.stored(number)]
    cases += [case for number in range(4) for case in estimates.compared(number, 2)]
    assert not [case for case in cases if case.estimate < case.error]
    ratios = [case.estimate / max(case.error, estimates.ROUNDING) for case in cases if case.estimate > 0.0]
    assert np.median(ratios) <= estimates.MOST


def test_true_errors_are_rounding() -> None:
    # of what is not next to its limit: far below any accuracy that may be asked for
    plain = np.array([error(k) for k in NUMBERS if not near_limit(k) and ROWS[k]["reference"]["phases"] < MANY])
    assert np.median(plain, axis=0).max() < 2e-15
    assert plain.max() < 1e-11


@pytest.mark.parametrize("accuracy", [1e-4, 1e-11, 1e-12])
def test_other_accuracies(accuracy: float) -> None:
    few = [*(NUMBERS[::7] if accuracy != 1e-11 else []), *(TIMED[::6] if accuracy != 1e-12 else [])]
    for k in few:
        motion = slipcircle.solve(scene(ROWS[k]), accuracy)
        assert motion.error_estimate >= max(true_error(motion, ROWS[k]["reference"])), f"scene {k}"
        assert motion.error_estimate <= accuracy or (motion.warnings and k in NUMBERS), f"scene {k}"


@pytest.mark.parametrize(("near", "ratio"), [(0.0, 0.0), (1e-15, 0.1), (-1e-15, 0.1)])
def test_a_decision_that_rounding_makes_is_not_silent(near: float, ratio: float) -> None:
    arc = Arc(100.0, np.radians(190.0), np.radians(280.0), 2e4)
    effects: dict[str, Any] = {"rotation": {}, "pore_pressure": {"ratio": ratio}}
    limit = slipcircle.solve(Scene(arc, 1.0, effects)).limit_friction
    motion = slipcircle.solve(Scene(arc, limit * (1.0 + near), effects))
    assert motion.error_estimate > 0.01
    assert any("ill-conditioned" in w for w in motion.warnings)


def test_six_references_are_derived_again() -> None:
    """Six references are reproduced to their last digits."""
    rng = np.random.default_rng(int.from_bytes(hashlib.sha256(DATA).digest()[:8]))
    few = [k for k in NUMBERS if ROWS[k]["reference"]["phases"] < MANY // 5]
    for k in [*rng.choice(few, 4, False).tolist(), *rng.choice([*TIMED], 2, False).tolist()]:
        digits = references.digits(ROWS[k]["group"])
        again = unwrap(taylor.solve)(ROWS[k]["scene"], ROWS[k]["shares"], digits)
        assert references.agree(again, ROWS[k]["reference"], digits), f"scene {k}"


def both(length: float = 3.0, **changes: Any) -> list[Any]:
    """Motions of Vaiont's mass by a law of its name, and by the same as a function."""
    named: dict[str, Any] = {"law": "exponential", "peak": 0.37, "residual": 0.17, "length": length}
    free: Any = partial(falling, length=length)
    return [solve(replace(load("vaiont"), friction=friction, **changes), 1e-13) for friction in (named, free)]


def falling(slip: Any, length: float = 3.0) -> Any:
    return 0.17 + 0.2 * np.exp(-slip / length)


@pytest.mark.parametrize("length", [1e-9, 1e-6, 1e-2, 1.0, 1e4, 1e12])
def test_a_callable_with_any_length_at_its_start_is_seen(length: float) -> None:
    """Panels know nothing of a callable's scale; what falls within a hair of the start must not pass unseen."""
    named, free = both(length)
    assert dict(free.outcomes) == pytest.approx(dict(named.outcomes), rel=1e-12)


@pytest.mark.parametrize("radius", [vaiont.RADIUS, np.array([500.0, 1500.0, 6000.0])])
def test_a_callable_is_known_wherever_the_mass_is(radius: Any) -> None:
    """Friction beyond the first table, which ends at R/256, is the function's, on the way and at once."""
    named, free = both(arc=replace(vaiont.ARC, radius=radius))
    times = np.linspace(0.0, 25.0, 6)
    assert free.peak.normal_stress == pytest.approx(named.peak.normal_stress, rel=1e-12)
    assert free.friction_at(times) == pytest.approx(falling(free.path_at(times)), rel=1e-12)
    assert free.run_out == pytest.approx(named.run_out, rel=1e-11)
    assert free.holding_friction_at(times) == pytest.approx(named.holding_friction_at(times), rel=1e-11)


def test_a_callable_of_a_creeping_mass_goes_on(implicit: None) -> None:
    """Implicit steps pass the end of a table, too."""
    slow = {"viscosity": {"viscosity": 1e9, "thickness": 0.5}}
    named, free = both(effects={**load("vaiont").called, **slow}, end_time=1e5)
    assert free.run_out > 4 * vaiont.RADIUS / 256
    assert free.run_out == pytest.approx(named.run_out, rel=1e-12)
    assert free.friction_at(1e5) == pytest.approx(falling(free.run_out), rel=1e-12)


def test_a_callable_that_changes_too_sharply_is_refused() -> None:
    """Within 2^-40 of how far it was asked, nothing is told apart: the sentence names the place."""
    with pytest.raises(ValueError, match=r"^friction: the function changes too sharply near 0 to be followed"):
        solve(replace(load("vaiont"), friction=lambda slip: 0.18 + 0.23 * np.exp(-slip / 1e-12)))


@pytest.mark.parametrize("name", ["vaiont", "layered-slope"])
def test_an_end_time_next_to_the_duration_is_no_error(name: str) -> None:
    """Some of the runs that estimate the error rest before it, others do not; at half of it all still move."""
    shipped_scene = load(name)
    motion = solve(shipped_scene)
    for end_time in (motion.duration, math.nextafter(motion.duration, 0.0), motion.duration / 2):
        ended = solve(replace(shipped_scene, end_time=end_time))
        assert ended.error_estimate < 10 * motion.error_estimate
    times: Any = np.array([motion.duration, 2 * motion.duration])
    lanes = solve(replace(shipped_scene, end_time=times))
    assert np.all(np.less(lanes.error_estimate, lanes.plan.accuracy))


@needs_binary
@pytest.mark.parametrize("name", ["vaiont", "vaiont-softening", "vaiont-rate"])
def test_one_call_solves_a_scene_and_its_neighbours(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compiled, "integrate", None)
    calls = Mock(wraps=compiled.integrate_runs)
    monkeypatch.setattr(compiled, "integrate_runs", calls)
    assert solve(load(name)).error_estimate < 1e-12
    assert calls.call_count == 1
