"""Fragments of programs: the declared effects and laws, and the balance itself, lowered to operations."""

from collections.abc import Sequence
from functools import cache
from itertools import chain, combinations

from sympy import Expr, Max, Min, Mul, Poly, Rational, Symbol, cos, expand, sin, sympify

from derive.algebra.remainders import Select
from derive.check.proof import ProofError
from derive.declare.effects import (
    ALL_EFFECTS,
    BY_PSI,
    COHESION_LAW,
    DEGREE,
    DRIVING_MOMENT,
    EFFECTIVE,
    J_R,
    J_THETA,
    K_H,
    K_V,
    LAMBDA,
    LAWS,
    MU,
    NORMAL_LOAD,
    NORMAL_LOAD_SLOPE,
    OMEGA,
    OMEGA_2,
    POLAR_MOMENT,
    REMAINING_SLOPE,
    RESISTANCE_FACTOR,
    SLIP,
    SLIP_MU,
    SOIL_MU,
    SOIL_SLOPE,
    SPEED,
    THETA,
    TURNING_SLOPE,
    A,
    Effect,
    Law,
    Parameter,
)
from derive.declare.symbols import Forms
from derive.flow import pace
from derive.flow.lowering import ONE, ZERO, Fragment, Increment, Lowering, Split, cell, series, total, varying

# Inputs of every scene, over Theta*.
INPUTS = {
    "driving_moment": "J_theta/Theta* of the weight at the start",
    "driving_moment_slope": "its derivative by psi",
    "normal_load": "J_r/Theta* of the weight at the start",
    "normal_load_slope": "its derivative by psi",
    "resistance_factor": "lambda/Theta*",
    "polar_moment": "I_p*/Theta*",
}
# Quantities of the balance over Theta*: driving and resisting moment, lambda sigma* (pressing) and lambda u* (lifting).
QUANTITIES = ("driving", "resisting", "pressing", "lifting")
# The same for soils with separate friction laws, multiplied by mu.
SOIL_SUMS = {"pressing": "soil_pressing", "lifting": "soil_lifting"}

DIRECTION, ROTATION, BEGAN, GRIP = (cell(x) for x in ("DIRECTION", "ROTATION", "SLIP", "grip"))
NORMAL = cell("normal")
FRICTION = cell("friction")
# Quantities that occur in full in the rate of a state, without base.
TOTALS = {x: (ZERO, series(str(x))) for x in (NORMAL, FRICTION, MU)}
# A Python function of slip, which the runtime samples as pieces.
CALLABLE = Law("callable", "a function of the slip, in pieces", (Parameter("slip", "m", "", ""),), degree=DEGREE)


# Quantities that change sign in a mirror image, where the slope falls to the other side.
ODD = {DRIVING_MOMENT, NORMAL_LOAD_SLOPE, TURNING_SLOPE, REMAINING_SLOPE, SOIL_SLOPE, K_H}


def seen(q: Symbol) -> Symbol:
    """Return the cell of a component of the weight at the start of the phase, signed in the direction of travel."""
    return cell(f"{q}_0")


def sign(q: Symbol) -> Expr:
    """Return the factor of a component in a reversed direction of travel.

    J_theta and the slope of J_r are odd in psi.
    """
    return DIRECTION if q in ODD else ONE


def _position() -> dict[Symbol, Split]:
    """Return the weight's components at the start of a phase and their increments, zero for a frozen mass.

    q(psi - x) = q cos x - q' sin x, since q'' = -q by the declared derivatives: an increment of -q vers x - q' sin x.
    """
    at_start = {q: seen(q) for q in BY_PSI}
    sine = series("sin(x)")
    versine = series("vers(x)")
    components = {}
    for q, slope in BY_PSI.items():
        components[q] = (at_start[q], total((-slope.subs(at_start), sine), (-at_start[q], versine)))
    return components


def _scaled(e: Expr) -> Expr:
    """Return a moment divided by Theta*, in terms of the position and the parameters alone."""
    over_theta = {
        J_THETA: THETA * DRIVING_MOMENT,
        J_R: THETA * NORMAL_LOAD,
        LAMBDA: THETA * RESISTANCE_FACTOR,
        A: POLAR_MOMENT / RESISTANCE_FACTOR,
        OMEGA_2: OMEGA**2,
    }
    return expand(expand(expand(e).subs(over_theta)) / THETA)


def quantities(effect: Effect) -> Forms:
    """Return the terms of an effect in the balance.

    Terms of one soil are multiplied by mu, by which `soils` divides.
    """
    adds = {
        "driving": _scaled(effect.driving_moment),
        "resisting": _scaled(effect.resistance),
        "pressing": _scaled(effect.normal_load + LAMBDA * effect.stress),
        "lifting": _scaled(LAMBDA * effect.pressure),
        "mu": effect.friction,
    }
    if SOIL_MU not in effect.friction.free_symbols:
        return adds
    none = dict.fromkeys(SOIL_SUMS, ZERO)
    return adds | none | {y: expand(adds[x] * SLIP_MU) for x, y in SOIL_SUMS.items()}


def odd(effect: Effect) -> set[Symbol]:
    """Return the parameters that change sign in a mirror image, in which only the driving moment of all terms does.

    Raises
    ------
    ProofError
        If the terms of the effect are not symmetric for any choice of parameters.
    """
    symbols = effect.symbols.keys()
    free = sorted(symbols - ODD, key=str)
    for chosen in chain.from_iterable(combinations(free, n) for n in range(len(free) + 1)):
        mirror = {x: -x for x in ODD.union(chosen)}
        for quantity, e in quantities(effect).items():
            mirrored = -e if quantity == "driving" else e
            if expand(e.xreplace(mirror) - mirrored) != 0:
                break
        else:
            return symbols & ODD | {*chosen}
    raise ProofError(f"{effect.name}: signs of its parameters", "none", "some that make its terms the same in a mirror")


def moving(effect: Effect | None = None) -> dict[Symbol, Split]:
    """Return base and increment, by symbol, of what may change during a phase; without an effect, for a law."""
    speed = (ZERO, series("omega"))
    variables = _position()
    variables |= {OMEGA: speed, SPEED: speed, SLIP: (BEGAN, series("x"))}
    if effect is None:
        return variables
    for x in (SLIP_MU, SOIL_MU, COHESION_LAW):
        variables[x] = varying(str(x))
    variables |= {x: (sign(x) * x, series(f"d{x}", sign(x))) for x in (K_H, K_V)}
    odd_parameters = odd(effect)
    for x, p in effect.symbols.items():
        if x in BY_PSI:
            continue
        direction = DIRECTION if x in odd_parameters else ONE
        increment = series(f"d{x}", direction) if p.kind in ("series", "rotation") else {}
        variables[x] = (direction * x, increment)
    for x in effect.states:
        variables[x] = varying(str(x))
    return variables


def _piece(low: Lowering, table: str, argument: str, degree: int) -> Increment:
    """Return the increment of a table's piece, a polynomial of a register.

    At full degree ``low`` has all powers at once.
    """
    coefficients = [cell(f"{table}.Q{power}") for power in range(1, degree + 1)]
    if degree < DEGREE:
        return {(argument,) * power: c for power, c in enumerate(coefficients, 1)}
    higher = [f"{argument}^{power}" for power in range(2, degree + 1)]
    low.put("powers", higher, [argument])
    return {(name,): c for name, c in zip((argument, *higher), coefficients, strict=True)}


@cache
def effect_fragment(effect: Effect) -> Fragment:
    """Return the fragment of an effect: its terms in the balance, and the rates of its states."""
    if effect.turns:
        return _rotation(effect)
    low = Lowering(effect.name, moving(effect))
    functions = [str(x) for x, p in effect.symbols.items() if p.kind == "rotation"]
    for name in functions:
        low.register(_piece(low, name, "x", DEGREE), f"d{name}")
    for x in effect.states:
        low.cells[f"{x}_less"] = -x
        low.cells[f"{x}_0"] = -cell(f"{x}_less")  # the state's cell changes along the phase
        low.register(series(str(x)), f"d{x}", f"{x}_less")
    low.moving = {**low.moving, **TOTALS}
    rate = expand(effect.growth * OMEGA)
    rate = rate.subs(EFFECTIVE, NORMAL / RESISTANCE_FACTOR).subs(MU * NORMAL, FRICTION)
    return low.fragment(
        quantities(effect),
        inputs=[str(x) for x, p in effect.symbols.items() if p.kind != "rotation"],
        states={str(x): rate for x in effect.states},
        tables=tuple((name, "rotation", "x", DEGREE) for name in functions),
    )


@cache
def law_fragment(law: Law) -> Fragment:
    """Return the fragment of a law: base and increment of its coefficient, from its formula or a table's piece."""
    low = Lowering(law.name, moving())
    if law.coefficient is not None and not law.kinks:
        inputs = {cell(p.name): cell(f"{law.name}.{p.name}") for p in law.parameters}
        coefficient = law.coefficient.xreplace(inputs)
        low.cells |= pace.of_friction(coefficient)
        return low.fragment({"mu": coefficient}, [str(x) for x in inputs.values()])
    value = cell(f"{law.name}.VALUE")
    (variable,) = law.depends_on
    argument = {"time": f"d{law.name}", "speed": "log_speed"}.get(variable, "x")
    if variable == "time":
        low.moving = {value: (value, series(argument))}
    else:
        if variable == "speed":
            _log_speed(law, low)
        low.moving = {value: (value, _piece(low, law.name, argument, degree(law)))}
    return low.fragment({"mu": value}, tables=((law.name, variable, argument, degree(law)),))


def degree(law: Law) -> int:
    """Return the degree of the polynomials of a law's pieces."""
    if law.coefficient is None:
        return law.degree
    _, (first, *_) = pieces(law)
    return len(first) - 1


def _log_speed(law: Law, low: Lowering) -> None:
    """Define the logarithm of the speed over that at the start of the phase, constant in the law's first piece."""
    beyond = cell("beyond")
    start = cell("start_speed")
    low.cells["beyond"] = Select(0, cell(f"{law.name}.PIECE"), 1, 0)
    low.cells["start_speed"] = Select(0, beyond, cell("omega"), 1)
    low.register(series("omega", beyond / start), "relative_speed", low.cell(-beyond))
    low.operate("log", ["log_speed.times", "log_speed"], "relative_speed")


def pieces(law: Law) -> tuple[list[Expr], list[list[Expr]]]:
    """Return breaks of a law with a kink, over the slip at the kink, and the polynomials of its pieces."""
    breaks: list[Expr] = [ZERO, ONE]
    polynomials = [_polynomial(law, start) for start in breaks]
    most = max(map(len, polynomials))
    if most > DEGREE + 1:
        raise ProofError(f"{law.name}: degree of a piece", most - 1, f"at most {DEGREE}")
    return breaks, [p + [ZERO] * (most - len(p)) for p in polynomials]


def _polynomial(law: Law, start: Expr) -> list[Expr]:
    """Return the coefficients of a law's piece of length 1 in powers of the distance from its start, lowest first.

    The piece uses the valid branch of each minimum or maximum, so that a constant piece equals its parameter exactly.
    """
    y = cell("y")
    (kink,) = law.kinks
    piece = sympify(law.coefficient).subs(SLIP, kink * (start + y))
    branches = {}
    for e in piece.atoms(Min, Max):
        at_middle = {x.subs(y, Rational(1, 2)): x for x in e.args}
        branches[e] = at_middle[e.func(*at_middle)]
    piece = expand(piece.xreplace(branches))
    if not piece.is_polynomial(y):
        raise ProofError(f"{law.name}: piece between branches", piece, "a polynomial of the slip")
    return Poly(piece, y).all_coeffs()[::-1]


def _gravity() -> Fragment:
    """Return the fragment of driving moment and normal load of a frozen mass, whose components do not rotate."""
    low = Lowering("gravity", {})
    for q in BY_PSI:
        low.cells[str(seen(q))] = sign(q) * q
    low.moving = _position()
    return low.fragment({"driving": DRIVING_MOMENT, "pressing": NORMAL_LOAD})


def _rotation(effect: Effect) -> Fragment:
    """Return the fragment of the weight's rotation: its components at the start of the phase, and their series.

    J_theta, J_r and their slopes satisfy q(psi - x) = q - q vers x - q' sin x.
    """
    low = Lowering(effect.name, {})
    for q, slope in BY_PSI.items():
        low.cells[str(seen(q))] = sign(q) * (q * cos(ROTATION) - slope * sin(ROTATION))
    low.turn(series("x"), ONE, ONE)
    normal_load, increment = _position()[NORMAL_LOAD]
    low.register(increment, "upright", str(normal_load))
    return low.fragment()


def _balance() -> Fragment:
    """Return the fragment of the balance of momentum (3.11), whose quantities are sums over all fragments.

    d omega*/dt* = net = driving - resisting - friction, where friction = mu normal unless the mass is lifted, and
    normal = pressing - lifting. Also net = drive + dnet, where drive is the net moment at rest at the start of the
    phase.
    """
    names = (*QUANTITIES, "mu")
    driving, resisting, pressing, lifting, mu = (cell(x) for x in names)
    low = Lowering("balance", {cell(x): varying(x) for x in names})
    low.cells["grip"] = 1 - cell("LIFTED")
    for name, e in (("normal", pressing - lifting), ("friction", GRIP * mu * NORMAL)):
        base, increment = low.split(e)
        low.cells[f"{name}_0"] = base
        low.register(increment, f"d{name}")
        low.register(series(f"d{name}"), name, f"{name}_0")
        low.moving = {**low.moving, cell(name): varying(name)}
    for name in names:
        low.register(series(f"d{name}"), name, f"{name}_0")
    net, increment = low.split(driving - resisting - FRICTION)
    low.register(increment, "dnet")
    low.register(series("dnet"), "net", "drive")
    _drive(low, net)
    return low.fragment()


def _drive(low: Lowering, net: Expr) -> None:
    """Define the net moment at the start of a phase, and the rounding error of its terms.

    While its arguments have their initial values it is normal ((limit - mu) + rest of limit), without cancellation near
    the limit friction. The limit friction of weight alone is an input in two parts, which are more accurate than a
    quotient of sums. A friction equal to the first part, which is printed, holds the mass.
    """
    cells = low.cells
    driving, resisting, normal, mu = (cell(f"{x}_0") for x in ("driving", "resisting", "normal", "mu"))
    others, first, drive, limit = (cell(x) for x in ("others", "first", "drive", "limit"))
    margin = driving - resisting
    cells["limit_0"] = margin / normal
    other_driving = driving - cell(str(seen(DRIVING_MOMENT)))
    cells["others"] = abs(other_driving) + abs(normal - cell(str(seen(NORMAL_LOAD)))) + resisting
    cells["limit"] = Select(0, others, cell("limit_0"), cell("LIMIT"))
    cells["rounded_gap"] = limit - mu
    cells["known_rest"] = Select(0, others, 0, cell("LIMIT_REST"))
    cells["gap"] = cell("rounded_gap") + Select(0, abs(cell("rounded_gap")), cell("known_rest"), 0)
    cells["first"] = Select(0, cell("departed"), 0, GRIP * Select(0, margin, 1, 0))
    cells["drive"] = Select(0, first, normal * cell("gap"), net)
    drives, resists, presses, lifts = (cell(f"{x}_size") for x in QUANTITIES)
    size = Select(0, first, abs(drive), drives + resists + GRIP * mu * (presses + lifts))
    cells["drive_scale"] = Rational(1, 2**52) * size


def _energy() -> Fragment:
    """Return the fragment of work and dissipation over Theta*, which are states only if requested.

    dwork/dt* = driving omega*, ddissipation/dt* = (resisting + friction) omega*.
    """
    names = ("driving", "resisting", "friction", "brakes", "omega")
    driving, resisting, friction, brakes, omega = (cell(x) for x in names)
    low = Lowering("energy", {cell(x): (ZERO, series(x)) for x in names})  # in full
    _, increment = low.split(resisting + friction)
    low.register(increment, "brakes")
    return low.fragment(states={"work": driving * omega, "dissipation": brakes * omega})


def fragments(effects: Sequence[Effect] = ALL_EFFECTS, laws: Sequence[Law] = LAWS) -> dict[str, Fragment]:
    """Return all fragments of these effects and laws by name."""
    every = {"gravity": _gravity()}
    for effect in effects:
        every[effect.name] = effect_fragment(effect)
    for law in (*laws, CALLABLE):
        every[law.name] = law_fragment(law)
    factors = {cell(x): varying(x) for x in ("slip_mu", "rate_mu")}
    every["product"] = Lowering("product", factors).fragment({"mu": Mul(*factors)})
    soils = Lowering("soils", {cell(x): varying(x) for x in (*SOIL_SUMS.values(), "slip_mu")})
    every["soils"] = soils.fragment({x: cell(y) / SLIP_MU for x, y in SOIL_SUMS.items()})
    return every | {"balance": _balance(), "pace": pace.fragment(), "energy": _energy()}
