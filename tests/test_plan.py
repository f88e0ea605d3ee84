"""The planner and the ladder: what they choose, what they print, and that they keep to what the scene calls for."""

import re
from dataclasses import replace
from itertools import combinations, pairwise
from typing import Any

import numpy as np
import pytest
import sympy as sp
from sympy.parsing.sympy_parser import convert_xor, implicit_multiplication, parse_expr, standard_transformations

from generated import layout as ix
from generated.effects import ALL_EFFECTS, EFFECTS, LAWS
from generated.flow import TERMS
from slipcircle import Scene, load, plan, solve
from slipcircle.tables import Series
from slipcircle.words.choice import FLOW, STEPS, flops
from slipcircle.words.equation import Equation
from slipcircle.workbench.studies.ladder import ladder
from tests.support.lanes import walked

ARC = load("vaiont").arc
SOFTENING = {"law": "exponential", "peak": 0.4, "residual": 0.2, "length": 2.0}
PARAMETERS = {
    "pore_pressure": {"ratio": 0.2}, "cohesion": {"cohesion": 5e4}, "drag": {"xi": 500.0},
    "viscosity": {"viscosity": 1e4, "thickness": 0.5},
    "shaking": {"pulse": "half-sine", "amplitude": 0.2, "duration": 1.0},
    "thermal_pressurisation": {"pressurisation": 1e4, "heat_capacity": 2.7e6, "thickness": 0.1},
}  # fmt: skip
STILL = ("rotation", "centripetal", "pore_pressure", "cohesion", "drag")
RATE = {"law": "rate_weakening", "peak": 0.4, "residual": 0.1, "velocity": 0.5}


def scene(effects: tuple[str, ...], friction: object = 0.2, **more: object) -> Scene:
    called = {e: PARAMETERS.get(e, {}) for e in effects}
    return Scene(ARC, friction, called, **more)  # type: ignore[arg-type]


WET = {"pore_pressure": {"pressure": Series(np.array([0.0, 1.0]), np.array([0.0, 1e5]))}}


@pytest.mark.parametrize(
    ("planned", "why"),
    [
        (scene(STILL[1:]), ""),
        (scene(STILL), "rotation turns the mass"),
        (
            scene(("rotation", "viscosity", "shaking"), SOFTENING | {"rate": RATE}),
            "rotation turns the mass; viscosity depends on the speed; shaking depends on time; "
            "friction depends on slip; friction depends on the speed",
        ),
        (Scene(ARC, 0.2, WET), "pore_pressure depends on time"),
    ],
)
def test_a_plan_says_what_its_motion_depends_on(planned: Scene, why: str) -> None:
    assert (plan(planned).method, plan(planned).why) == (FLOW, why)


def test_a_plan_depends_on_what_is_called_for_never_on_values() -> None:
    assert plan(scene((), SOFTENING | {"rate": RATE})).law == "exponential times rate_weakening"
    for effects in (e for count in range(len(EFFECTS) + 1) for e in combinations(EFFECTS, count)):
        one, other = plan(scene(effects, 0.2)), plan(scene(effects, 0.4, initial_velocity=3.0))
        assert (one.fragments, one.operations, one.cost) == (other.fragments, other.operations, other.cost)
        assert one.effects == effects
        assert set(one.left_out) == set(EFFECTS) - set(effects)


def test_accuracy_counts_in_ensembles_alone() -> None:
    """A single scene is solved to rounding: same digits, same operations; what is planned is what is solved."""
    alone: Scene[Any] = load("vaiont-softening")
    several = replace(alone, friction=SOFTENING | {"peak": np.array([0.4, 0.41])})
    accuracies = (1e-3, 1e-6, 1e-9)
    assert len({solve(alone, accuracy).run_out for accuracy in accuracies}) == 1
    assert len({plan(alone, accuracy).cost for accuracy in accuracies}) == 1
    costs = [plan(several, accuracy).cost for accuracy in accuracies]
    assert costs == sorted(set(costs))
    assert costs[-1] < plan(alone, 1e-3).cost
    for scene, accuracy in ((alone, 1e-3), (several, 1e-3), (several, 1e-12)):
        motion = solve(scene, accuracy)
        (terms,) = {*walked(motion).cells()[ix.ORDER].tolist()}
        program = walked(motion).program
        assert motion.plan.cost == STEPS * flops(program, int(terms))


@pytest.mark.parametrize("name", ["vaiont", "wet-slope", "valley-side"])
def test_the_ladder_climbs_to_the_fullest_scene(name: str) -> None:
    full = solve(load(name))
    rungs = ladder(full.plan.scene)
    assert set(rungs[-1].effects) == set(full.plan.effects)
    assert not rungs[0].effects
    for before, after in pairwise(rungs):
        assert set(after.effects) - set(before.effects) == {after.added}
        assert after.cost >= before.cost
    last = rungs[-1]
    assert (last.run_out, last.peak_velocity, last.duration) == (full.run_out, full.peak.velocity, full.duration)
    assert last.difference == 0.0


LADDERS = {  # the effects as they are added, and whether each rung rests
    "vaiont": ("rotation centripetal", "moving yes yes"),
    "newmark-pulse": ("shaking", "move yes"),
    "vaiont-rate": ("rotation centripetal", "moving yes yes"),
    "vaiont-heated": ("rotation thermal_pressurisation centripetal", "moving yes moving moving"),
}


@pytest.mark.parametrize("name", LADDERS)
def test_ladders_on_the_command_line(name: str, said: Any) -> None:
    """What decides comes first, what adds a few percent last."""
    lines = said("plan --ladder", name).splitlines()
    assert max(map(len, lines)) <= 100
    shown = [x.split() for x in lines if "+ " in x or "none" in x]
    assert (" ".join(x[1] for x in shown[1:]), " ".join(x[-3] for x in shown)) == LADDERS[name]
    differs = [float(x[-2]) for x in shown]
    assert differs[-1] == 0.0
    assert differs[0] > 5.0
    assert differs[-2] < 5.0 or len(differs) == 2


def test_on_the_command_line(said: Any, records: Any, asked: Any) -> None:
    text = said("plan vaiont")
    assert all(word in text for word in (*plan(load("vaiont")).fragments, FLOW, "not included"))
    (found,) = records("plan --ladder vaiont")
    assert [r["added"] for r in found["ladder"]] == ["", "rotation", "centripetal"]
    assert len(records("plan --all")) == 2 ** len(EFFECTS)
    assert asked("plan")[0] == 2


def test_the_error_to_expect_grows_next_to_the_limit() -> None:
    limit = solve(scene(("rotation",), 0.5)).limit_friction
    far, near = (solve(scene(("rotation",), limit * (1 - gap))).error_estimate for gap in (0.5, 1e-9))
    assert far < 1e-12
    assert near > 1e-7
    assert solve(scene(("rotation",), limit)).error_estimate == 1.0


# --- the equation of motion ------------------------------------------------------------------------------------------

TIMES = np.array([0.0, 1.0, 30.0])
SHAKEN, LIFTED = (Series(TIMES, np.array(k), False) for k in ([0.02, 0.05, -0.03], [0.01, -0.02, 0.02]))
EQUATIONS: dict[str, tuple[Any, dict[str, Any]]] = {
    "frozen": (0.2, {}),
    "rotation": (0.2, {"rotation": {}, "centripetal": {}}),
    "water": (0.2, {"rotation": {}, "pore_pressure": {"ratio": 0.1, "pressure": 2e4}, "cohesion": {"cohesion": 1e4}}),
    "brakes": (0.2, {"centripetal": {}, "drag": {"xi": 500.0}, "viscosity": {"viscosity": 2e3, "thickness": 0.5}}),
    "shaking": (0.2, {"rotation": {}, "shaking": {"horizontal": SHAKEN, "vertical": LIFTED}}),
    "softening": ({"law": "exponential", "peak": 0.3, "residual": 0.1, "length": 2.0}, {"rotation": {}}),
    "linear": ({"law": "linear", "peak": 0.3, "residual": 0.1, "length": 2.0}, {"rotation": {}}),
    "hyperbolic": ({"law": "hyperbolic", "peak": 0.3, "residual": 0.1, "length": 2.0}, {"centripetal": {}}),
    "two laws": (
        {"law": "exponential", "peak": 0.3, "residual": 0.1, "length": 2.0}
        | {"rate": {"law": "rate_weakening", "peak": 1.0, "residual": 0.5, "velocity": 3.0}},
        {"rotation": {}, "centripetal": {}, "pore_pressure": {"ratio": 0.1}},
    ),
}  # fmt: skip


def evaluated(equation: Equation, known: dict[str, float]) -> float:
    """The rate of omega by the terms as they are printed and the numbers that stand below them."""
    sums: dict[str, str] = dict.fromkeys(["M", "sigma", "u", "T"], "0")
    for term in equation.sums:
        joined = " * " if term.formula == "mu_slip mu_rate" else " + "
        sums[term.symbol] = f"{sums[term.symbol]}{joined}({term.formula})" if term.symbol in sums else term.formula
    numbers = known | {number.symbol: number.value for number in equation.numbers if number.value is not None}
    rules = (*standard_transformations, implicit_multiplication, convert_xor)

    def parsed(formula: str) -> sp.Expr:
        """Names get an underscore, as `lambda` is a word of Python's; primes too."""
        names = r"\b(?!(?:cos|sin|exp|min|max)\b)([A-Za-z_]\w*)('?)"
        text = re.sub(names, lambda name: name[1] + ("_prime_" if name[2] else "_"), formula)
        e = parse_expr(text, {"min": sp.Min, "max": sp.Max}, rules)
        printed = {symbol: str(symbol)[:-1].replace("_prime", "'") for symbol in e.free_symbols}
        return e.subs({s: parsed(sums[name]) if name in sums else numbers[name] for s, name in printed.items()})

    return float(parsed(equation.balance.formula) / numbers["Theta"])


@pytest.mark.parametrize("name", EQUATIONS)
def test_the_printed_equation_gives_the_acceleration_of_the_motion(name: str) -> None:
    """And another one where any printed number is off by a hundredth."""
    friction, effects = EQUATIONS[name]
    scene = Scene(ARC, friction, effects, initial_velocity=3.0, end_time=8.0)
    motion, equation = solve(scene), plan(scene).equation
    scale = float(np.asarray(ARC.time_scale))
    assert {term.effect for term in equation.sums} >= {*effects}
    for time in (0.3, 3.1, 6.0):
        state = motion.at(time)
        omega = state.angular_velocity * scale
        k_h, k_v = (float(np.interp(time, TIMES, k.values)) for k in (SHAKEN, LIFTED))
        known = {"phi": state.rotation, "omega": omega, "s": np.sign(omega), "speed": abs(state.velocity),
                 "slip": motion.path_at(time), "time": time, "k_h": k_h, "k_v": k_v}  # fmt: skip
        expected = state.acceleration * scale**2 / float(np.asarray(ARC.radius))
        assert evaluated(equation, known) == pytest.approx(expected, rel=1e-9, abs=1e-12)
        # Later a law has left its peak behind; lambda cancels where weight alone presses.
        for number in (n for n in equation.numbers if n.value and time < 1.0 and n.symbol != "lambda"):
            wrong = [n._replace(value=1.01 * n.value) if n is number else n for n in equation.numbers]
            planted = evaluated(replace(equation, numbers=tuple(wrong)), known)
            assert planted != pytest.approx(expected, rel=1e-8), number.symbol


def test_every_effect_and_law_has_its_term_in_text_and_latex() -> None:
    assert {*TERMS} == {*ALL_EFFECTS, *LAWS, "gravity", "frozen", "callable"}
    assert all(formula and latex for added in TERMS.values() for _, formula, latex, _ in added)
    equation = plan(load("vaiont-heated")).equation
    assert "u_T" in equation._repr_latex_()
    assert "dexcess/dphi" in str(equation)
    assert [term.symbol for term in equation.numbers if term.effect == "thermal_pressurisation"] == ["kappa"]
    several = Scene(ARC, np.array([0.1, 0.2]), ["rotation"])
    assert "coefficient = 0.1 to 0.2" in str(plan(several).equation)
