"""The planner and the ladder: what they choose, what they print, and that they keep to what the scene calls for."""

import re
from collections.abc import Callable
from dataclasses import replace
from itertools import combinations, pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp
from sympy.parsing.sympy_parser import convert_xor, implicit_multiplication, parse_expr, standard_transformations

from generated import layout as ix
from generated.effects import ALL_EFFECTS, EFFECTS, LAWS
from generated.flow import FRAGMENTS, SOIL_TERMS, TERMS
from slipcircle import Scene, load, plan, solve
from slipcircle.base.kinds import Floats
from slipcircle.layers import LayeredSection, Soil, stretches
from slipcircle.messages.equation import Equation
from slipcircle.tables import Series
from slipcircle.workbench.cost.ladder import effect_ladder
from slipcircle.workbench.files.shipped import shipped

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
    ("planned", "method", "why"),
    [
        (scene(STILL[1:]), "Taylor series in time", ""),
        (scene(STILL), "closed form from rest, otherwise Taylor series in the rotation", "rotation turns the mass"),
        (
            scene(("rotation",), SOFTENING | {"law": "linear"}),
            "Taylor series in the rotation",
            "rotation turns the mass; friction depends on slip",
        ),
        (scene(("rotation",), RATE), "Taylor series in tau", "rotation turns the mass; friction depends on the speed"),
        (
            scene(("rotation", "viscosity", "shaking"), SOFTENING | {"rate": RATE}),
            "Taylor series in time",
            "rotation turns the mass; viscosity depends on the speed; shaking depends on time; "
            "friction depends on slip; friction depends on the speed",
        ),
        (Scene(ARC, 0.2, WET), "Taylor series in time", "pore_pressure depends on time"),
        (scene(("rotation", "shaking")), "Taylor series in time", "rotation turns the mass; shaking depends on time"),
    ],
)
def test_a_plan_says_how_it_is_solved_and_what_its_motion_depends_on(planned: Scene, method: str, why: str) -> None:
    said, _, way = plan(planned).method.partition("; ")
    assert (said, plan(planned).why) == (f"{method}, events as their roots", why)
    assert way in ("straight-line", "interpreted")  # as the integrator is compiled or not


def test_a_plan_depends_on_what_is_called_for_never_on_values() -> None:
    assert plan(scene((), SOFTENING | {"rate": RATE})).law == "exponential times rate_weakening"
    for effects in (e for count in range(len(EFFECTS) + 1) for e in combinations(EFFECTS, count)):
        one, other = plan(scene(effects, 0.2)), plan(scene(effects, 0.4, initial_velocity=3.0))
        assert (one.fragments, one.recipe, one.why) == (other.fragments, other.recipe, other.why)
        assert one.effects == effects
        assert set(one.left_out) == set(EFFECTS) - set(effects)


def test_accuracy_counts_in_ensembles_alone() -> None:
    """A single scene is solved to rounding, with the same digits and the same order."""

    def order(scene: Scene[Any], accuracy: float) -> float:
        (terms,) = {*solve(scene, accuracy).problem.cells()[ix.ORDER].tolist()}
        return float(terms)

    alone: Scene[Any] = load("vaiont-softening")
    several = replace(alone, friction=SOFTENING | {"peak": np.array([0.4, 0.41])})
    accuracies = (1e-3, 1e-6, 1e-9)
    assert len({solve(alone, accuracy).run_out for accuracy in accuracies}) == 1
    assert len({order(alone, accuracy) for accuracy in accuracies}) == 1
    orders = [order(several, accuracy) for accuracy in accuracies]
    assert orders == sorted({*orders})
    assert orders[-1] < order(alone, 1e-3)


@pytest.mark.parametrize("name", ["vaiont", "wet-slope", "valley-side"])
def test_the_ladder_climbs_to_the_fullest_scene(name: str) -> None:
    full = solve(load(name))
    rungs = effect_ladder(full.plan.scene)
    assert set(rungs[-1].effects) == set(full.plan.effects)
    assert not rungs[0].effects
    for before, after in pairwise(rungs):
        assert set(after.effects) - set(before.effects) == {after.added}
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
    """The decisive effect comes first, effects of a few percent last."""
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
    assert all(
        word in text for word in (*plan(load("vaiont")).effects, "Taylor series in the rotation", "not included")
    )
    (found,) = records("plan --ladder vaiont")
    assert [r["added"] for r in found["ladder"]] == ["", "rotation", "centripetal"]
    assert asked("plan")[0] == 2


@pytest.mark.parametrize("effects", [("rotation",), ("rotation", "pore_pressure")])
def test_the_error_to_expect_grows_next_to_the_limit(effects: tuple[str, ...]) -> None:
    """Except for weight alone, whose limit friction is known to more digits than a double has."""
    limit = solve(scene(effects, 0.5)).limit_friction
    far, near = (solve(scene(effects, limit * (1 - gap))).error_estimate for gap in (0.5, 1e-9))
    assert far < 1e-12
    assert near > 1e-7 if "pore_pressure" in effects else near < 1e-12
    assert solve(scene(effects, limit)).error_estimate == 1.0


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


def as_function(equation: Equation, formula: str) -> Callable[[dict[str, float]], float]:
    """Return a printed formula as a function of its variables and of the numbers listed below it."""
    sums: dict[str, str] = dict.fromkeys(["M", "sigma", "u", "T", "u_1", "u_2", "u_3"], "0")
    for term in equation.sums:
        sums[term.symbol] = f"{sums[term.symbol]} + ({term.formula})" if term.symbol in sums else term.formula
    rules = (*standard_transformations, implicit_multiplication, convert_xor)

    def parsed(formula: str) -> sp.Expr:
        """Names get an underscore, as `lambda` is a word of Python's; primes too."""
        names = r"\b(?!(?:cos|sin|exp|min|max)\b)([A-Za-z_]\w*)('?)"
        text = re.sub(names, lambda name: name[1] + ("_prime_" if name[2] else "_"), formula)
        e = parse_expr(text, {"min": sp.Min, "max": sp.Max}, rules)
        return e.subs({x: parsed(sums[printed(x)]) for x in e.free_symbols if printed(x) in sums})

    def printed(symbol: sp.Symbol) -> str:
        return str(symbol)[:-1].replace("_prime", "'")

    e = parsed(formula)
    symbols = sorted(e.free_symbols, key=str)
    function = sp.lambdify(symbols, e)
    return lambda values: float(function(*(values[printed(x)] for x in symbols)))


def by_soil(equation: Equation) -> Equation:
    """Return an equation that sums over soils i, written out: ``l_i`` becomes ``l_1``, ``l_2``, ..."""

    def of_soil(text: str, k: int) -> str:
        return re.sub(r"\b(?!d?phi\b)(\w*)i\b", rf"\g<1>{k}", text)

    def summed(match: re.Match[str]) -> str:
        return "(" + " + ".join(of_soil(match[1], k) for k in soils) + ")"

    soils = range(1, len(equation.soils) + 1)
    balance, *sums = (
        term._replace(formula=re.sub(r"sum (l_i mu_i \(.*?\)|l_i c_i)", summed, term.formula))
        for term in (equation.balance, *equation.sums)
    )
    of_soils, numbers = [], []
    for term in sums:
        each = soils if of_soil(term.symbol, 0) != term.symbol else [0]
        of_soils += [term._replace(symbol=of_soil(term.symbol, k), formula=of_soil(term.formula, k)) for k in each]
    for number in equation.numbers:
        values = number.value if isinstance(number.value, tuple) else (number.value,)
        numbers += [number._replace(symbol=of_soil(number.symbol, k), value=v) for k, v in enumerate(values, 1)]
    return replace(equation, balance=balance, sums=tuple(of_soils), numbers=tuple(numbers), soils=())


@pytest.mark.parametrize("name", EQUATIONS)
def test_the_printed_equation_gives_the_acceleration_of_the_motion(name: str) -> None:
    friction, effects = EQUATIONS[name]
    check_equation(Scene(ARC, friction, effects, initial_velocity=3.0, end_time=8.0), (0.3, 3.1, 6.0))


def check_equation(scene: Scene[Any], times: tuple[float, ...]) -> None:
    """Assert that the printed equation gives the acceleration, and a different one if a number changes by 1 %."""
    motion, equation = solve(scene), by_soil(plan(scene).equation)
    net_moment = as_function(equation, equation.balance.formula)
    numbers = {number.symbol: number.value for number in equation.numbers}
    scale = float(np.asarray(scene.arc.time_scale))
    assert {term.effect for term in equation.sums} >= {*scene.effects}
    for time in times:
        state = motion.at(time)
        omega = state.angular_velocity * scale
        k_h, k_v = (float(np.interp(time, TIMES, k.values)) for k in (SHAKEN, LIFTED))
        known = {"phi": state.rotation, "omega": omega, "s": np.sign(omega), "speed": abs(state.velocity),
                 "slip": motion.path_at(time), "time": time, "k_h": k_h, "k_v": k_v}  # fmt: skip
        expected = state.acceleration * scale**2 / float(np.asarray(scene.arc.radius))
        values = numbers | known
        assert net_moment(values) / values["Theta"] == pytest.approx(expected, rel=1e-9, abs=1e-12)
        # Later a law has left its peak behind; lambda cancels where weight alone presses.
        same = {"lambda", "sigma_ref"}
        for name in (n for n in numbers if numbers[n] and 0.0 < time < 1.0 and n not in same):
            wrong = values | {name: 1.01 * values[name]}
            assert net_moment(wrong) / wrong["Theta"] != pytest.approx(expected, rel=1e-8), name


GROUND = ((-60, 20), (0, 20), (40, 0), (120, 0))
SOILS = [
    Soil(19e3, 4e3, SOFTENING | {"peak": 0.3}, pore_ratio=0.1, name="till"),
    Soil(18e3, 1e3, SOFTENING | {"peak": 0.25, "residual": 0.15}, name="silt"),
    Soil(20e3, 9e3, 0.1, cohesion_gradient=500.0, name="clay"),
]
OTHER_LAW = replace(SOILS[1], friction={"law": "linear", "peak": 0.3, "residual": 0.1, "length": 3.0})
IN_PIECES = {"law": "rate_weakening", "peak": 1.0, "residual": 0.7, "velocity": 0.5}


def layered(soils: list[Soil], **more: Any) -> LayeredSection:
    tops = (None, 12.0, 1.0)
    return LayeredSection(GROUND, (30, 45), 48.0, layers=list(zip(soils, tops, strict=True)), **more)


LAYERED = {
    "mass": (layered(SOILS, strength="mass"), (0.0, 0.3, 2.1)),
    "rate": (layered(SOILS, strength="mass", rate=IN_PIECES), (0.3, 2.1)),
    "own laws": (layered([SOILS[0], OTHER_LAW, SOILS[2]], strength="mass"), (0.3, 2.1)),
    "base": (layered(SOILS, level=((-60, 10), (0, 9), (40, 0), (120, 0))), (0.0,)),  # later its numbers are others
}


@pytest.mark.parametrize("name", LAYERED)
def test_the_printed_sum_over_soils_gives_the_acceleration_of_the_motion(name: str) -> None:
    section, times = LAYERED[name]
    effects = {"rotation": {}, "centripetal": {}, "shaking": {"horizontal": SHAKEN, "vertical": LIFTED}}
    check_equation(Scene(section, effects=effects, initial_velocity=1.0, end_time=2.5), times)


def test_the_printed_sum_over_soils_gives_the_motion_of_a_heated_mass() -> None:
    heat = {"pressurisation": 1e5, "heat_capacity": 2.7e6, "thickness": 0.1}
    section = layered([SOILS[0], OTHER_LAW, SOILS[2]], strength="mass", rate=IN_PIECES)
    scene = Scene(section, effects={"rotation": {}, "centripetal": {}, "thermal_pressurisation": heat}, end_time=3.0)
    equation = by_soil(plan(scene).equation)
    net_moment = as_function(equation, equation.balance.formula)
    (growth,) = (as_function(equation, term.formula) for term in equation.sums if term.symbol == "dexcess/dphi")
    numbers = {number.symbol: number.value for number in equation.numbers}
    scale = float(np.asarray(section.time_scale))

    def rates(time: float, state: Floats) -> list[float]:
        phi, omega, excess = state
        speed = 48.0 * omega / scale
        known = {"phi": phi, "omega": omega, "s": 1.0, "speed": speed, "slip": 48.0 * phi, "excess": excess}
        values = numbers | known
        return [omega, net_moment(values) / values["Theta"], growth(values) * omega]

    path = solve_ivp(rates, (0.0, 3.0 / scale), [0.0, 0.0, 0.0], method="DOP853", rtol=1e-12, atol=1e-15)
    rotation, _, excess = path.y[:, -1]
    assert excess > 0.01
    assert rotation == pytest.approx(solve(scene).at(3.0).rotation, rel=1e-9)


SHIPPED = [name for name in shipped() if isinstance(load(name).arc, LayeredSection)]


@pytest.mark.parametrize(
    "scene", [*map(load, SHIPPED), *(Scene(section, effects=["rotation"]) for section, _ in LAYERED.values())]
)
def test_the_printed_numbers_of_soils_are_the_means_along_their_stretches(scene: Scene[Any]) -> None:
    equation = plan(scene).equation
    value = {number.symbol: number.value for number in equation.numbers}
    arc: Any = scene.arc
    rows = stretches(arc)
    length = sum(row.length for row in rows)
    for k, name in enumerate(equation.soils):
        of_soil = [row for row in rows if row.soil.name == name]
        share = sum(row.length for row in of_soil) / length
        assert value["l_i"][k] == pytest.approx(share, rel=1e-12)
        if not of_soil:
            continue
        pressure = value["p_i"][k] if "p_i" in value else 0.0
        cohesion = value["c_i"][k] if "c_i" in value else 0.0
        normal = value["J_r0i"][k] / (share * value["lambda"])
        strength = cohesion + of_soil[0].soil.peak * (normal - pressure)
        for attribute, mean in {"normal_stress": normal, "pore_pressure": pressure, "strength": strength}.items():
            expected = sum(row.length * getattr(row, attribute) for row in of_soil) / (share * length)
            assert mean * value["sigma_ref"] == pytest.approx(expected, rel=1e-11, abs=1e-6)


@pytest.mark.parametrize("name", SHIPPED)
@pytest.mark.usefixtures("unseen")
def test_what_is_said_of_layered_scenes_has_no_name_of_the_program(name: str, said: Any, tmp_path: Path) -> None:
    """The plan's equation names each soil once, and one reason names the strength of the soils."""
    scene: Any = load(name)
    chosen = plan(scene)
    own = [effect for effect in ALL_EFFECTS if effect not in EFFECTS]
    tables = (table for effect in own for table, *_ in FRAGMENTS[effect].tables)
    internal = {*own, *tables, *(x for effect in own for x in FRAGMENTS[effect].inputs), "slip_mu", "soil_mu"}
    report = tmp_path / "report.html"
    text = said("plan", name)
    everything = text + said("plan --json", name) + said(f"run --verbose --report {report}", name) + report.read_text()
    assert not internal.intersection(re.findall(r"\w+", everything))
    _, _, equation = text.partition("domega/dt")
    names = chosen.equation.soils
    assert {*names} == {soil.name for soil, _ in scene.arc.layers}
    assert [equation.count(f" {name}") for name in names] == [1] * len(names)
    assert chosen.why.count("the strength of the soils depends on the rotation") == 1


def test_every_effect_and_law_has_its_term_in_text_and_latex() -> None:
    assert {*TERMS} == {*EFFECTS, *LAWS, "gravity", "frozen", "callable"}
    assert {*SOIL_TERMS} == {*EFFECTS, "gravity", "frozen", "soils"}
    added = [term for terms in (TERMS, SOIL_TERMS) for added in terms.values() for term in added]
    assert all(formula and latex for _, formula, latex in added)
    equation = plan(load("vaiont-heated")).equation
    assert "u_T" in equation._repr_latex_()
    assert "dexcess/dphi" in str(equation)
    assert [term.symbol for term in equation.numbers if term.effect == "thermal_pressurisation"] == ["kappa"]
    several = Scene(ARC, np.array([0.1, 0.2]), ["rotation"])
    assert "coefficient = 0.1 to 0.2" in str(plan(several).equation)
