"""Proofs that linked programs are the equation of motion (3.11), which is derived from the balance laws.

A program is evaluated in symbols at an arbitrary moment of a phase, each operation on series by the function that it
means. All that the linker combines, omits, orders and numbers is therefore part of the proof.
"""

from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from typing import Any

from sympy import Add, Expr, Integer, Lt, Mul, Rational, Symbol, cos, expand, expand_trig, log, sin

from derive.algebra import dynamics
from derive.algebra.prove import prove_rational
from derive.algebra.remainders import Select, unfold
from derive.declare.effects import DEGREE, EFFECTS, K_H, K_V, LAWS, SLIP, SPEED, WATER, Effect, Law
from derive.flow.fragments import CALLABLE, INPUTS, degree
from derive.flow.link import lookup
from derive.flow.link.definitions import Recipe
from derive.flow.link.program import Program, build
from derive.flow.lowering import ONE, ZERO
from derive.flow.recurrences import CELLS, OPERATIONS, Operation

Cells = Mapping[str, Expr]


def positive(name: str) -> Symbol:
    """Return the symbol of a positive number."""
    return Symbol(name, positive=True)


# Moments and their slopes, over Theta*.
DRIVING, DRIVING_SLOPE, NORMAL, NORMAL_SLOPE, LAMBDA, POLAR = map(positive, INPUTS)
LIMIT = {"LIMIT": DRIVING / NORMAL}  # (3.21)
START = LIMIT | dict.fromkeys(("TIME", "SLIP", "ROTATION", "LIFTED"), ZERO)
LATER = LIMIT | {x: positive(x) for x in ("TIME", "SLIP", "ROTATION")}
# Where a phase begins; nothing presses on the slip surface of a mass that is lifted.
PHASES: dict[str, Cells] = {"at the start": START, "later": LATER | {"LIFTED": ZERO}, "lifted": LATER | {"LIFTED": ONE}}


def now(state: str) -> Symbol:
    """Return the symbol of a state at the moment, of which the cell has the value where the phase began."""
    return positive(f"now.{state}")


def since(parameter: str) -> Symbol:
    """Return the symbol of the increment of a function of time since the phase began."""
    return positive(f"{parameter}.since")


# --- the program -----------------------------------------------------------------------------------------------------


def rates(program: Program, known: Cells) -> dict[str, Expr]:
    """Return the rates of the states of a program at a moment, and its normal force if that varies during a phase."""
    cells = cells_of(program, known)
    values = registers_of(program, cells)
    found = {}
    for cell, _, rate in program.states:
        found[program.cells[cell]] = values[rate]
    normal = program.roles["normal"]
    if normal >= 0:
        found["normal"] = values[normal]
    return found


def cells_of(program: Program, known: Cells) -> list[Any]:
    """Return the values of all cells where a phase begins; a cell that is not known is a symbol."""
    cells: list[Any] = [known.get(name, positive(name)) for name in program.cells]
    for name, value in program.constants.items():
        cells[program.places[name]] = Rational(value)
    for kind, result, *operands in program.scalar:
        cells[result] = on_numbers(kind, *(cells[k] for k in operands))
    return cells


def registers_of(program: Program, cells: Sequence[Any]) -> list[Expr]:
    """Return the values of all registers at a moment."""
    values = [ZERO] * len(program.registers)
    for cell, register, _ in program.states:
        values[register] = now(program.cells[cell])
    for kind, *places in program.series:
        if kind == "lin":
            result, constant, terms = places
            products = [cells[cell] * values[register] for cell, register in terms]
            values[result] = Add(cells[constant] if constant >= 0 else ZERO, *products)
        elif kind == "ramp":
            result, table = places
            values[result] = since(program.tables[table].name)
        else:
            operate(OPERATIONS[kind], places, values, cells)
    return values


def operate(operation: Operation, places: Sequence[int], values: list[Expr], cells: Sequence[Any]) -> None:
    """Set the results of an operation on series, each by the function that it means."""
    names = (*operation.results, *operation.arguments, *operation.numbers)
    place = dict(zip(names, places, strict=True))
    known = {x: values[place[x]] for x in operation.arguments}
    known |= {x: cells[place[x]] for x in operation.numbers}
    for x, meaning in zip(operation.results, operation.means, strict=True):
        values[place[x]] = meaning.xreplace(known)


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
            return Select(*condition.args, x, y)
        case _:
            operation = CELLS[kind]
            return (operation.symbol or operation.meaning)(*operands)


def outcomes(e: Expr) -> Iterator[Expr]:
    """Yield an expression for either outcome of each undecided selection."""
    selections = e.atoms(Select)
    if not selections:
        yield e
        return
    innermost = min(selections, key=lambda x: (len(x.atoms(Select)), str(x)))
    for outcome in innermost.args[2:]:
        yield from outcomes(e.xreplace({innermost: outcome}))


# --- the equation ----------------------------------------------------------------------------------------------------


def piece(table: str, degree: int, argument: Expr) -> Expr:
    """Return the polynomial of a table's piece."""
    powers = range(1, degree + 1)
    terms = [positive(f"{table}.Q{k}") * argument**k for k in powers]
    return Add(positive(f"{table}.VALUE"), *terms)


def friction(law: Law, slip: Expr) -> Expr:
    """Return the friction coefficient of a law; of one in pieces, of the piece of the moment."""
    if law.coefficient is not None and not law.kinks:
        names = {Symbol(p.name, real=True): positive(f"{law.name}.{p.name}") for p in law.parameters}
        coefficient = law.coefficient.xreplace(names | {SLIP: slip, SPEED: now("omega")})
        return expand(coefficient, mul=False)
    (variable,) = law.depends_on
    if variable == "time":
        return positive(f"{law.name}.VALUE") + since(law.name)
    argument = now("x")
    if variable == "speed":
        argument = log(now("omega") / positive("omega"))
    return piece(law.name, degree(law), argument)


class Motion:
    """The equation of motion of a recipe with some laws at a moment, in absolute terms."""

    def __init__(self, recipe: Recipe, laws: Sequence[Law], known: Cells) -> None:
        self.recipe = recipe
        self.direction = known["DIRECTION"]
        self.phi = self.of("rotation", known["ROTATION"] + self.direction * now("x"))
        slip = known["SLIP"] + now("x")
        self.mu = (1 - known["LIFTED"]) * Mul(*(friction(law, slip) for law in laws))

    def of(self, effect: str, e: Expr) -> Expr:
        """Return a term of an effect, zero where the recipe lacks the effect."""
        return e if effect in self.recipe.effects else ZERO

    def parameter(self, name: str) -> Expr:
        """Return a parameter at the moment."""
        if name not in self.recipe.moving:
            return positive(name)
        if name == str(WATER):  # a function of the rotation
            return piece(name, DEGREE, now("x"))
        return positive(f"{name}.VALUE") + since(name)

    def turned(self, q: Expr, slope: Expr) -> Expr:
        """Return a component of the weight after the rotation, q(psi - phi), from q and dq/dpsi at the start."""
        return expand_trig(q * cos(self.phi) - slope * sin(self.phi))

    def gravity(self, q: Expr, slope: Expr) -> Expr:
        """Return a component of the weight under shaking, which tilts and scales gravity."""
        k_h, k_v = (self.of("shaking", self.parameter(str(x))) for x in (K_H, K_V))
        return (1 - k_v) * self.turned(q, slope) + k_h * self.turned(slope, -q)

    def uplift(self) -> Expr:
        """Return the resultant of the pore pressure."""
        ratio, pressure, level = map(self.parameter, ("pore_ratio", "pore_pressure", str(WATER)))
        water = ratio * self.turned(NORMAL, NORMAL_SLOPE) + LAMBDA * (pressure + level)
        heated = LAMBDA * now("excess")
        return self.of("pore_pressure", water) + self.of("thermal_pressurisation", heated)

    def resistance(self) -> Expr:
        """Return the moment that resists in addition to friction."""
        omega = now("omega")
        cohesion = self.of("cohesion", LAMBDA * positive("cohesion"))
        drag = self.of("drag", positive("drag") * omega**2)
        return cohesion + drag + self.of("viscosity", positive("viscosity") * omega)

    def rates(self) -> dict[str, Expr]:
        """Return the rates of the states by (3.11), and the normal force."""
        omega = now("omega")
        inertia = self.of("centripetal", POLAR)
        load = self.gravity(NORMAL, NORMAL_SLOPE) - self.uplift()
        terms = {
            dynamics.j_theta: self.direction * self.gravity(DRIVING, DRIVING_SLOPE) - self.resistance(),
            dynamics.j_r: load,
            dynamics.polar: inertia,
            dynamics.mu: self.mu,
            dynamics.omega_star: omega,
        }
        normal = load + inertia * omega**2
        return {
            "x": omega,
            "omega": dynamics.balance()["3.11"].xreplace(terms),
            "excess": positive("kappa") * self.mu * normal / LAMBDA * omega,
            "normal": normal,
        }


# --- proofs ----------------------------------------------------------------------------------------------------------


def cases(effects: Sequence[Effect], laws: Sequence[Law]) -> Iterator[tuple[Sequence[Effect], tuple[Law, ...]]]:
    """Yield effects with laws: each effect alone, all effects with each law, and laws of slip with laws of speed."""
    constant, *_ = laws
    yield from (((effect,), (constant,)) for effect in effects)
    yield from ((effects, (law,)) for law in laws)
    of_slip, of_speed = ([law for law in laws if law.depends_on == (x,)] for x in ("slip", "speed"))
    yield from (((), both) for both in product(of_slip, of_speed))


def prove(effects: Sequence[Effect] = EFFECTS, laws: Sequence[Law] = (*LAWS, CALLABLE)) -> list[str]:
    """Prove that programs of effects and laws are (3.11), in phases of each kind.

    The drive at the start is computed from the limit friction (3.21), later from the terms of the balance. With the
    first law both directions of travel are proved, and parameters that may change along the motion do.
    """
    parts = lookup(effects, laws)
    claims = []
    for some, of_friction in cases(effects, laws):
        first = of_friction == (laws[0],)
        parameters = [p for effect in some for p in effect.parameters if p.symbol]
        moving = tuple(str(p.symbol) for p in parameters if p.kind in ("series", "rotation"))
        names = tuple(effect.name for effect in some)
        recipe = Recipe(names, tuple(law.name for law in of_friction), moving * first)
        program = build(recipe, parts)
        for direction, phase in product((1, -1) if first else (-1,), PHASES):
            claims.append(f"(3.11), {', '.join(recipe.effects + recipe.laws)}, direction {direction}, {phase}")
            known = {**PHASES[phase], "DIRECTION": Integer(direction)}
            equation = Motion(recipe, of_friction, known).rates()
            for name, rate in rates(program, known).items():
                for difference in outcomes(rate - equation[name]):
                    prove_rational(unfold(difference), f"{claims[-1]}: d{name}/dt")
    return claims
