"""The declared effects and laws, and the balance itself, lowered to fragments that a scene's program is joined of."""

from collections.abc import Iterator, Sequence
from itertools import chain, combinations

import sympy as sp

from derive.algebra.stable import Select
from derive.declare.effects import (
    _BY_PSI, A, EFFECTIVE, EFFECTS, FALL, FALL_SLOPE, J_R, J_THETA, LAMBDA, LAWS, LEVEL, MU, OMEGA, OMEGA_2,
    POLAR, PRESS, PRESS_SLOPE, SLIP, SPEED, THETA, Effect, Law,
)  # fmt: skip
from derive.flow.lowering import Fragment, Increment, Lowering, cell, series, total

# Cells that every program has, first and in this order, with what they hold.
CELLS = {
    "TIME": "t* at the start of the next step",
    "ROTATION": "rotation where the phase began, signed",
    "SLIP": "slip over the radius where the phase began",
    "DIRECTION": "of travel, 1 or -1; 0 at rest",
    "LIFTED": "1 where nothing presses on the slip surface, else 0",
    "STATUS": "what the lane is doing",
    "STEPS": "steps taken", "PHASES": "phases ended", "ORDER": "of its series", "FACTOR": "step over radius of convergence",
    "END_TIME": "t* at which it ends at the latest",
    "ONE_WAY": "1 where shaking may start it down-slope only", "FIRST_ONLY": "1 where the first standstill ends it",
    "LIMIT": "limit friction at the start", "LIMIT_LOW": "what rounding took from it",
    "PEAK_TIME": "t* of the greatest speed", "PEAK_ROTATION": "rotation then", "PEAK_OMEGA": "omega* then, signed",
    "PEAK_RATE": "d omega*/dt* then, signed", "REACH_TIME": "t* of the greatest rotation from the start",
    "REACH_ROTATION": "that rotation", "END_ROTATION": "rotation at the end", "END_OMEGA": "omega* then, signed",
    "END_RATE": "d omega*/dt* then, signed", "FIRST_STOP": "t* of the first standstill",
    "CLOSE": "least margin of a decision at rest, over its terms", "LIFT_TIME": "t* of the first lift-off",
    "PASSED": "what the phase began by passing", "REST_SINCE": "t* of the standstill that it rests from",
    "x": "rotation since the phase began, in the direction of travel", "omega": "its rate, omega*",
}  # fmt: skip
QUANTITIES = ("driving", "resisting", "pressing", "lifting")

DIRECTION, ROTATION, BEGAN, GRIP = (cell(x) for x in ("DIRECTION", "ROTATION", "SLIP", "grip"))
X, SPEED_NOW = series("x"), series("omega")
ONE, ZERO = sp.Integer(1), sp.Integer(0)
NORMAL, FRICTION = sp.symbols("normal friction", real=True)
_LIMIT, _LIMIT_LOW, _TIME, _LIFTED = (cell(x) for x in ("LIMIT", "LIMIT_LOW", "TIME", "LIFTED"))


def _seen(q: sp.Symbol) -> sp.Symbol:
    """A component of the weight where the phase begins, as it is seen in the direction of travel."""
    return cell(f"{q}_0")


def position() -> dict[sp.Symbol, tuple[sp.Expr, Increment]]:
    """The weight's components at the start of a phase and their increments; those of a frozen mass have none.

    q(psi - x) = q cos x - q' sin x, since q'' = -q by the declared derivatives: q - q vers x - q' sin x.
    """
    sine = {q: -slope.subs({y: _seen(y) for y in _BY_PSI}) for q, slope in _BY_PSI.items()}
    return {q: (_seen(q), total((sine[q], series("sin(x)")), (-_seen(q), series("vers(x)")))) for q in _BY_PSI}


def scaled(e: sp.Expr) -> sp.Expr:
    """A moment over Theta*, in the functions of the position and the parameters alone."""
    over = {J_THETA: THETA * FALL, J_R: THETA * PRESS, LAMBDA: THETA * LEVEL, A: POLAR / LEVEL, OMEGA_2: OMEGA**2}
    return sp.expand(sp.expand(sp.expand(e).subs(over)) / THETA)


def odd(effect: Effect) -> set[sp.Symbol]:
    """The parameters that change sign when the arc is seen in a mirror, which only the drive does, and the slope of J_r."""
    even = scaled(effect.press), scaled(LAMBDA * effect.stress), scaled(LAMBDA * effect.pressure), scaled(effect.resistance)
    fall = scaled(effect.fall)
    symbols = sorted({p.symbol for p in effect.parameters if p.symbol is not None}, key=str)
    for chosen in chain.from_iterable(combinations(symbols, n) for n in range(len(symbols) + 1)):
        mirror = {x: -x for x in (FALL, PRESS_SLOPE, *chosen)}
        if all(sp.expand(e.xreplace(mirror) - e) == 0 for e in even) and sp.expand(fall.xreplace(mirror) + fall) == 0:
            return set(chosen)
    raise ValueError(f"{effect.name}: no sign of its parameters makes its terms the same in a mirror")


def moving(effect: Effect | None = None) -> dict[sp.Symbol, tuple[sp.Expr, Increment]]:
    """What may change along a phase: base and increment by symbol."""
    found = position() | {OMEGA: (ZERO, SPEED_NOW), SPEED: (ZERO, SPEED_NOW), SLIP: (BEGAN, X)}
    if effect is not None:
        signs = dict.fromkeys(odd(effect), DIRECTION)
        for p in effect.parameters:
            if p.symbol is not None:
                sign = signs.get(p.symbol, ONE)
                found[p.symbol] = (sign * p.symbol, series(f"d{p.symbol}", sign) if p.kind == "series" else {})
        found |= {x: (cell(f"{x}_0"), series(f"d{x}")) for x in effect.given}
    return found


def of_effect(effect: Effect) -> Fragment:
    """What an effect adds to the quantities of the balance, and the rates of its states."""
    low = Lowering(effect.name, moving(effect))
    adds = {
        "driving": scaled(effect.fall), "resisting": scaled(effect.resistance),
        "pressing": scaled(effect.press + LAMBDA * effect.stress), "lifting": scaled(LAMBDA * effect.pressure),
    }  # fmt: skip
    symbols = [p for p in effect.parameters if p.symbol is not None]
    inputs, optional = [str(p.symbol) for p in symbols], [str(p.symbol) for p in symbols if p.optional]
    for x in effect.given:
        low.cells |= {f"{x}_less": -x, f"{x}_0": -cell(f"{x}_less")}  # the state's own cell moves on along the phase
        low.put("lin", f"d{x}", f"{x}_less", (("=1.0", str(x)),))
    low.moving = {**low.moving, **_TOTALS}
    rate = sp.expand(effect.growth * OMEGA).subs(EFFECTIVE, NORMAL / LEVEL).subs(MU * NORMAL, FRICTION)
    return low.fragment((), adds, inputs, optional, {str(x): rate for x in effect.given})


# Of the rate of a state, in full: no base to subtract.
_TOTALS = {x: (ZERO, series(str(x))) for x in (NORMAL, FRICTION, MU)}


# A Python function of slip, which the runtime turns into pieces.
CALLABLE = Law("callable", "1.14", (), ("slip",), "a function of slip", degree=7)


def of_law(law: Law) -> Fragment:
    """Friction of a law: its base and its increment, from its formula or as the polynomial of a table's piece."""
    low = Lowering(law.name, moving())
    if law.coefficient is not None and not law.kinks:
        own = {cell(p.name): cell(f"{law.name}.{p.name}") for p in law.parameters}
        return low.fragment((), {"mu": law.coefficient.xreplace(own)}, map(str, own.values()))
    value = cell(f"{law.name}.VALUE")
    if law.depends_on == ("time",):
        low.moving = {value: (value, series(f"d{law.name}"))}
        return low.fragment((), {"mu": value}, table=("time", f"d{law.name}", 0))
    argument = "x"
    if law.depends_on == ("speed",):
        # The logarithm of the speed over that where the phase began. The first piece, below the table, is constant.
        argument, beyond, start = "log_speed", cell("beyond"), cell("start_speed")
        low.cells["beyond"] = Select(0, cell(f"{law.name}.PIECE"), 1, 0)
        low.cells["start_speed"] = Select(0, beyond, cell("omega"), 1)
        low.put("lin", "relative_speed", low.cell(-beyond), ((low.cell(beyond / start), "omega"),))
        low.put("log", argument, "relative_speed")
    powers = {(argument,) * k: cell(f"{law.name}.Q{k}") for k in range(1, law.degree + 1)}
    low.moving = {value: (value, powers)}
    return low.fragment((), {"mu": value}, table=(law.depends_on[0], argument, law.degree))


def gravity() -> Fragment:
    """The weight, which drives and presses, of a frozen mass."""
    low = Lowering("gravity", {})
    low.cells |= {str(_seen(q)): _sign(q) * q for q in _BY_PSI}
    low.moving = position()
    return low.fragment((), {"driving": FALL, "pressing": PRESS}, map(str, _BY_PSI))


def rotation(effect: Effect) -> Fragment:
    """The turning of the weight: its components where the phase begins, and the series that they turn by."""
    low = Lowering(effect.name, {})
    low.cells |= {
        str(_seen(q)): _sign(q) * (q * sp.cos(ROTATION) - slope * sp.sin(ROTATION)) for q, slope in _BY_PSI.items()
    }
    low.turn(X, ONE, ONE)
    low.put("lin", "upright", "press_0", low.sum(position()[PRESS][1]))
    return low.fragment((), {})


def _sign(q: sp.Symbol) -> sp.Expr:
    """Of a component of the weight, seen in the direction of travel: J_theta and the slope of J_r are odd."""
    return DIRECTION if q in (FALL, PRESS_SLOPE) else ONE


def product() -> Fragment:
    """A law of slip times a law of speed."""
    parts = {cell(f"{x}_mu"): (cell(f"{x}_mu_0"), series(f"d{x}_mu")) for x in ("slip", "rate")}
    return Lowering("product", parts).fragment((), {"mu": sp.Mul(*parts)})


def balance() -> Fragment:
    """The balance of momentum of its quantities, which the fragments' sums are: (3.11), all over Theta*."""
    driving, resisting, pressing, lifting, mu = (cell(x) for x in (*QUANTITIES, "mu"))
    low = Lowering("balance", {x: (cell(f"{x}_0"), series(f"d{x}")) for x in (driving, resisting, pressing, lifting, mu)})
    low.cells["grip"] = 1 - _LIFTED
    # All that presses; the part that a friction coefficient multiplies; what is left of the drive.
    low.cells["normal_0"] = cell("pressing_0") - cell("lifting_0")
    low.register(low.split(pressing - lifting)[1], "dnormal")
    low.put("lin", "normal", "normal_0", (("=1.0", "dnormal"),))
    low.moving = {**low.moving, NORMAL: (cell("normal_0"), series("dnormal"))}
    low.cells["friction_0"], rubbed = low.split(GRIP * mu * NORMAL)
    low.register(rubbed, "dfriction")
    low.put("lin", "friction", "friction_0", (("=1.0", "dfriction"),))
    low.moving = {**low.moving, FRICTION: (cell("friction_0"), series("dfriction"))}
    base, increment = low.split(driving - resisting - FRICTION)
    low.register(increment, "dnet")
    low.put("lin", "net", "drive", (("=1.0", "dnet"),))
    # At the start the limit friction is given, in two numbers, and what drives is made of it.
    low.cells["gap"] = _LIMIT - cell("mu_0")
    given = cell("normal_0") * (cell("gap") + _LIMIT_LOW)
    first = Select(0, _TIME, 0, GRIP * Select(0, cell("driving_0") - cell("resisting_0"), 1, 0))
    low.cells |= {"first": first, "drive": Select(0, cell("first"), given, base)}
    sizes = [cell(f"{x}_size") for x in QUANTITIES]
    whole = sizes[0] + sizes[1] + GRIP * cell("mu_0") * (sizes[2] + sizes[3])
    low.cells["drive_scale"] = sp.Rational(1, 2**52) * Select(0, cell("first"), abs(cell("drive")), whole)
    low.put("lin", "mu", "mu_0", (("=1.0", "dmu"),))
    return low.fragment((), {})


def fragments(effects: Sequence[Effect] = EFFECTS, laws: Sequence[Law] = LAWS) -> Iterator[Fragment]:
    """All fragments, of these effects and laws."""
    yield gravity()
    yield from (rotation(e) if e.turns else of_effect(e) for e in effects)
    yield from (of_law(law) for law in (*laws, CALLABLE))
    yield product()
    yield balance()
