"""Proofs that linked programs are the equation of motion (3.11), which is derived from the balance laws.

A program is evaluated symbolically at an arbitrary moment of a phase, each operation on series by its meaning. The
proof therefore includes everything that the linker combines, omits, orders and numbers.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import chain, cycle, product
from operator import attrgetter
from typing import Any

from sympy import Add, Expr, Integer, Lt, Rational, Symbol, cos, expand, expand_trig, log, sin

from derive.algebra import dynamics
from derive.algebra.prove import prove_rational
from derive.algebra.remainders import Select, unfold
from derive.declare import effects as symbols
from derive.declare.effects import (
    BY_PSI,
    COHESION_LAW,
    DEGREE,
    DRIVING_MOMENT,
    EFFECTIVE,
    EFFECTS,
    J_R,
    J_THETA,
    K_H,
    K_V,
    LAWS,
    MU,
    NORMAL_LOAD,
    OMEGA,
    OMEGA_2,
    SECTION_EFFECTS,
    SLIP,
    SLIP_MU,
    SOIL_MU,
    SPEED,
    THETA,
    Effect,
    Law,
)
from derive.declare.symbols import Forms
from derive.flow.fragments import CALLABLE, degree
from derive.flow.link import lookup
from derive.flow.link.definitions import OF_COHESION, OF_SOIL, Recipe
from derive.flow.link.program import Program, build
from derive.flow.lowering import ONE, ZERO, without_tanh
from derive.flow.recurrences import CELLS, evaluate
from derive.kinds import Texts

Cells = Mapping[str, Expr]


def positive(name: str) -> Symbol:
    """Return the symbol of a positive number."""
    return Symbol(name, positive=True)


# Divided by Theta*, as all moments in this module.
LAMBDA, POLAR = positive("resistance_factor"), positive("polar_moment")
LIMIT = {"LIMIT": positive("driving_moment") / positive("normal_load"), "LIMIT_REST": ZERO}  # (3.21)
START = LIMIT | dict.fromkeys(("TIME", "SLIP", "ROTATION", "LIFTED"), ZERO)
LATER = LIMIT | {x: positive(x) for x in ("TIME", "SLIP", "ROTATION")}
# Cells at the start of a phase.
PHASES: dict[str, Cells] = {"at the start": START, "later": LATER | {"LIFTED": ZERO}, "lifted": LATER | {"LIFTED": ONE}}


def now(state: str) -> Symbol:
    """Return the symbol of a state at the current moment. Its cell contains the value at the start of the phase."""
    return positive(f"now.{state}")


def since(parameter: str) -> Symbol:
    """Return the symbol of the increment of a function of time since the phase began."""
    return positive(f"{parameter}.since")


# --- the program -----------------------------------------------------------------------------------------------------


def rates(program: Program, known: Cells) -> Forms:
    """Return the rates of the states of a program at a moment, and its normal force if that varies during a phase.

    ``known`` are cells at the start of the phase by name.
    """
    cells = cells_of(program, known)
    values = registers_of(program, cells)
    found = {}
    pace = ZERO
    if "cell_pace" in program.roles:
        pace = cells[program.roles["cell_pace"]]
    for cell, _, rate in program.states:
        found[program.cells[cell]] = values[rate] / (1 + pace * now("omega"))
    normal = program.roles["normal"]
    if normal >= 0:
        found["normal"] = values[normal]
    return found


def cells_of(program: Program, known: Cells) -> list[Any]:
    """Return the values of all cells at the start of a phase. A cell that is not in ``known`` is a symbol."""
    cells: list[Any] = [known.get(name, positive(name)) for name in program.cells]
    for name, value in program.constants.items():
        cells[program.places[name]] = Rational(value)
    for kind, result, *operands in program.scalar:
        numbers = (cells[k] for k in operands)
        cells[result] = on_numbers(kind, *numbers)
    return cells


def registers_of(program: Program, cells: Sequence[Any]) -> list[Expr]:
    """Return the values of all registers at a moment of a phase with these cells."""
    values = [ZERO] * len(program.registers)
    for cell, register, _ in program.states:
        values[register] = now(program.cells[cell])
    for table in program.tables:
        if table.kind == "time":
            values[table.register] = since(table.name)
    evaluate(program.series, values, cells.__getitem__, attrgetter("means"))
    return values


def on_numbers(kind: str, *operands: Any) -> Any:
    """Return the result of an operation on cells; a selection whose condition is undecided is a `Select`.

    Sums of magnitudes that are not identically zero are taken as positive.
    """
    match kind, operands:
        case "less", (x, y):
            return True if (y - x).is_nonnegative and y != x else Lt(x, y)
        case "select", (condition, x, y):
            if condition in (True, False):
                return x if condition else y
            return x if x == y else Select(*condition.args, x, y)
        case _:
            operation = CELLS[kind]
            meaning = operation.symbol or operation.meaning
            return meaning(*operands)


def outcomes(e: Expr) -> Iterator[Expr]:
    """Yield an expression once for each outcome of its undecided selections, without these."""
    selections = e.atoms(Select)
    if not selections:
        yield e
        return
    innermost = min(selections, key=lambda x: (len(x.atoms(Select)), str(x)))
    for outcome in innermost.args[2:]:
        yield from outcomes(e.xreplace({innermost: outcome}))


# --- the equation ----------------------------------------------------------------------------------------------------


def piece(table: str, degree: int, argument: Expr) -> Expr:
    """Return the polynomial of a table's piece at an argument, with symbols as coefficients."""
    terms = [positive(f"{table}.VALUE")]
    for k in range(1, degree + 1):
        coefficient = positive(f"{table}.Q{k}")
        terms.append(coefficient * argument**k)
    return Add(*terms)


def friction(law: Law, slip: Expr) -> Expr:
    """Return the friction coefficient of a law after a slip over the radius, for a table the current polynomial."""
    if law.coefficient is not None and not law.kinks:
        names = {Symbol(p.name, real=True): positive(f"{law.name}.{p.name}") for p in law.parameters}
        coefficient = without_tanh(law.coefficient).xreplace(names | {SLIP: slip, SPEED: now("omega")})
        return expand(coefficient, mul=False)
    (variable,) = law.depends_on
    if variable == "time":
        return positive(f"{law.name}.VALUE") + since(law.name)
    argument = now("x")
    if variable == "speed":
        argument = log(now("omega") / positive("omega"))
    return piece(law.name, degree(law), argument)


def numbered(symbol: Symbol, number: str) -> Symbol:
    """Return the symbol of a quantity of one soil, to whose name its number is appended: ``soil_mu#0``."""
    return Symbol(f"{symbol}{number}", real=True)


def soil_of(law: Law) -> str:
    """Return the number of the soil of a law with its mark, empty for a law of the whole surface."""
    return "".join(law.name.partition(OF_SOIL)[1:])


def effect_of(law: Law) -> Effect:
    """Return the effect of the law of a soil, on friction or on cohesion, with the symbols of this soil."""
    number = soil_of(law)
    symbol = COHESION_LAW if number.startswith(OF_COHESION) else SOIL_MU
    (shared,) = (effect for effect in SECTION_EFFECTS if any(e.has(symbol) for e in effect.terms.values()))
    names = {x: numbered(x, number) for x in (*shared.symbols, symbol)}
    terms = {x: getattr(shared, x).xreplace(names) for x in ("normal_load", "pressure", "resistance", "friction")}
    parameters = tuple(replace(p, symbol=names[x]) for x, p in shared.symbols.items())
    return replace(shared, name=shared.name + number, parameters=parameters, **terms)


def parameter_values(effects: Sequence[Effect], moving: Sequence[str]) -> dict[Symbol, Expr]:
    """Return the parameters of effects at a moment by symbol. Those named in ``moving`` change along the motion."""
    values: dict[Symbol, Expr] = {K_H: ZERO, K_V: ZERO}
    for x, p in chain.from_iterable(effect.symbols.items() for effect in effects):
        name = str(x)
        if name not in moving:
            values[x] = positive(name)
        elif p.kind == "rotation":
            values[x] = piece(name, DEGREE, now("x"))
        else:
            values[x] = positive(f"{name}.VALUE") + since(name)
    return values | {x: now(str(x)) for effect in effects for x in effect.states}


def components(laws: Sequence[Law], phi: Expr) -> dict[Symbol, Expr]:
    """Return the components of the weight by symbol after a rotation phi, also of each soil with a law."""
    values = {}
    for number in ("", *map(soil_of, laws)):
        names = {x: numbered(x, number) for x in BY_PSI}
        at_start = {x: positive(str(named)) for x, named in names.items()}
        for q, slope in BY_PSI.items():
            turned = q * cos(phi) - slope * sin(phi)
            values[names[q]] = expand_trig(turned.xreplace(at_start))
    return values


def symbols_at(
    effects: Sequence[Effect], laws: Sequence[Law], moving: Sequence[str], known: Cells
) -> dict[Symbol, Expr]:
    """Return the values of all symbols in declared terms at a moment, except normal stress.

    ``moving`` are names of parameters that change, and ``known`` the cells at the start of the phase.

    mu is the sum of the laws of soils, or else the law of slip, multiplied by the law of speed if there is one.
    """
    phi = ZERO
    if any(effect.turns for effect in effects):
        phi = known["ROTATION"] + known["DIRECTION"] * now("x")
    values = parameter_values(effects, moving) | components(laws, phi)
    values |= {J_THETA: values[DRIVING_MOMENT], J_R: values[NORMAL_LOAD], symbols.LAMBDA: LAMBDA, THETA: ONE}
    omega = now("omega")
    slip = known["SLIP"] + now("x")
    shared = []
    for law in laws:
        if soil_of(law):
            symbol = COHESION_LAW if OF_COHESION in law.name else SOIL_MU
            values[numbered(symbol, soil_of(law))] = friction(law, slip)
        else:
            shared.append(friction(law, slip))
    of_soils = Add(*(effect.friction for effect in effects)).xreplace(values)
    *of_slip, of_speed = shared if len(shared) > (of_soils == 0) else (*shared, ONE)
    values[SLIP_MU] = Add(of_soils, *of_slip)
    values[MU] = values[SLIP_MU] * of_speed
    return values | {OMEGA: omega, SPEED: omega, OMEGA_2: omega**2, SLIP: slip}


def derived_rates(effects: Sequence[Effect], laws: Sequence[Law], moving: Sequence[str], known: Cells) -> Forms:
    """Return the rates of the states by (3.11) with the declared terms of effects, and the normal force, over Theta*.

    Rotation and centripetal stress follow from the balance laws.
    """
    values = symbols_at(effects, laws, moving, known)
    others = [effect for effect in effects if effect.name != "centripetal"]
    polar = POLAR if len(others) < len(effects) else ZERO

    def total(quantity: str) -> Expr:
        terms = (effect.terms[quantity] for effect in others)
        return Add(*terms).xreplace(values)

    load = values[J_R] + total("J_r") + LAMBDA * (total("sigma") - total("u"))
    mobilised = values[MU] * (1 - known["LIFTED"])
    terms = {
        dynamics.j_theta: known["DIRECTION"] * (values[J_THETA] + total("J_theta")) - total("resistance"),
        dynamics.j_r: load,
        dynamics.polar: polar,
        dynamics.mu: mobilised,
        dynamics.omega_star: values[OMEGA],
    }
    normal = load + polar * values[OMEGA_2]
    balance = dynamics.balance()["3.11"]
    rates = {"x": values[OMEGA], "omega": balance.xreplace(terms), "normal": normal}
    stress = normal / LAMBDA
    for effect in effects:
        growth = effect.growth.subs(MU * EFFECTIVE, mobilised * stress)
        by_rotation = growth.xreplace(values | {EFFECTIVE: stress})
        rates |= {str(x): by_rotation * values[OMEGA] for x in effect.states}
    return rates


# --- proofs ----------------------------------------------------------------------------------------------------------


def cases(effects: Sequence[Effect], laws: Sequence[Law]) -> Iterator[tuple[Sequence[Effect], tuple[Law, ...]]]:
    """Yield effects with laws: each effect and all of them, each law on a mass that turns, products of laws, soils.

    Each effect on the normal force occurs with the strength of layers and with the laws of two soils, one of them in
    pieces. The cohesion of a mass that turns follows each law of slip.
    """
    constant, *_ = laws
    yield from ((some, (constant,)) for some in (*((effect,) for effect in effects), effects))
    turning = [effect for effect in effects if not effect.parameters]
    yield from ((turning, (law,)) for law in laws)
    of_slip, of_speed = ([law for law in laws if law.depends_on == (x,)] for x in ("slip", "speed"))
    yield from (((), both) for both in zip(of_slip, cycle(of_speed), strict=False))
    layered, *_ = SECTION_EFFECTS
    in_pieces = next(law for law in of_slip if law.kinks)
    soils = tuple(replace(law, name=f"{law.name}{OF_SOIL}{k}") for k, law in enumerate((constant, in_pieces)))
    for effect in effects:
        if effect in turning or effect.normal_load != 0:
            yield (effect, layered), (constant,)
            yield (effect,), soils
    yield from ((turning, (constant, replace(law, name=law.name + OF_COHESION))) for law in of_slip)


def prove(effects: Sequence[Effect] = EFFECTS, laws: Sequence[Law] = (*LAWS, CALLABLE)) -> Texts:
    """Prove that programs of effects and laws are (3.11); return the claims."""
    return [claim for case in cases(effects, laws) for claim in prove_case(*case)]


def prove_case(effects: Sequence[Effect], laws: Sequence[Law]) -> Texts:
    """Prove that the program of these effects and laws is (3.11), in both directions of travel and in all phases.

    The drive at the start is computed from the limit friction (3.21), later from the terms of the balance. All
    parameters that may change along the motion do.
    """
    claims = []
    effects = (*effects, *(effect_of(law) for law in laws if soil_of(law)))
    declared = [p for effect in effects for p in effect.parameters if p.symbol]
    moving = tuple(str(p.symbol) for p in declared if p.kind in ("series", "rotation"))
    recipe = Recipe(tuple(effect.name for effect in effects), tuple(law.name for law in laws), moving)
    shared = [replace(law, name=law.name.removesuffix(soil_of(law))) for law in laws]
    program = build(recipe, lookup((*SECTION_EFFECTS, *effects), shared))
    for direction, phase in product((1, -1), PHASES):
        claims.append(f"(3.11), {', '.join(recipe.effects + recipe.laws)}, direction {direction}, {phase}")
        known = {**PHASES[phase], "DIRECTION": Integer(direction)}
        equation = derived_rates(effects, laws, recipe.moving, known)
        for name, rate in rates(program, known).items():
            claim = f"{claims[-1]}: d{name}/dt"
            for difference in outcomes(rate - equation[name]):
                prove_rational(unfold(difference), claim)
    return claims
