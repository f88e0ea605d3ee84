"""The declared effects and laws, and the balance itself, lowered to the fragments that programs are joined of."""

from collections.abc import Sequence
from itertools import chain, combinations

import sympy as sp

from derive.algebra.remainders import Select
from derive.declare import effects as declared
from derive.declare.effects import BY_PSI, DEGREE, EFFECTS, FALL, LAMBDA, LAWS, LEVEL, MU, OMEGA, PRESS, SLIP, THETA
from derive.flow.lowering import Fragment, Increment, Lowering, cell, series, total

# What every scene gives, all over Theta*.
INPUTS = {
    "fall": "J_theta/Theta*, what gravity drives with at the start",
    "fall_slope": "its derivative by psi",
    "press": "J_r/Theta*, what gravity presses with at the start",
    "press_slope": "its derivative by psi",
    "level": "lambda/Theta*",
    "polar": "I_p*/Theta*",
}
# What effects add to, over Theta*: the moments that drive and resist, lambda sigma* that presses, lambda u* that lifts.
QUANTITIES = ("driving", "resisting", "pressing", "lifting")

DIRECTION, ROTATION, BEGAN, GRIP = (cell(x) for x in ("DIRECTION", "ROTATION", "SLIP", "grip"))
ONE, ZERO = sp.Integer(1), sp.Integer(0)
NORMAL, FRICTION = cell("normal"), cell("friction")
# In the rate of a state these count in full: there is no base to subtract.
TOTALS = {x: (ZERO, series(str(x))) for x in (NORMAL, FRICTION, MU)}
# A Python function of slip, which the runtime turns into pieces.
CALLABLE = declared.Law("callable", "1.14", (), ("slip",), "a function of the slip, in pieces", degree=DEGREE)


def seen(q: sp.Symbol) -> sp.Symbol:
    """A component of the weight where the phase begins, as it is seen in the direction of travel."""
    return cell(f"{q}_0")


def sign(q: sp.Symbol) -> sp.Expr:
    """What a component is multiplied by to be seen so: J_theta and the slope of J_r are odd in psi."""
    return DIRECTION if q in (FALL, declared.PRESS_SLOPE, declared.TURNING_SLOPE, declared.REMAINING_SLOPE) else ONE


def position() -> dict[sp.Symbol, tuple[sp.Expr, Increment]]:
    """The weight's components at the start of a phase and their increments; those of a frozen mass are nothing.

    q(psi - x) = q cos x - q' sin x, since q'' = -q by the declared derivatives: an increment of -q vers x - q' sin x.
    """
    slopes = {q: slope.subs({y: seen(y) for y in BY_PSI}) for q, slope in BY_PSI.items()}
    return {q: (seen(q), total((-slopes[q], series("sin(x)")), (-seen(q), series("vers(x)")))) for q in BY_PSI}


def scaled(e: sp.Expr) -> sp.Expr:
    """A moment over Theta*, in the functions of the position and the parameters alone."""
    over = {declared.J_THETA: THETA * FALL, declared.J_R: THETA * PRESS, LAMBDA: THETA * LEVEL}
    over |= {declared.A: declared.POLAR / LEVEL, declared.OMEGA_2: OMEGA**2}
    return sp.expand(sp.expand(sp.expand(e).subs(over)) / THETA)


def quantities(effect: declared.Effect) -> dict[str, sp.Expr]:
    """What an effect adds to the quantities of the balance."""
    return {
        "driving": scaled(effect.fall),
        "resisting": scaled(effect.resistance),
        "pressing": scaled(effect.press + LAMBDA * effect.stress),
        "lifting": scaled(LAMBDA * effect.pressure),
    }


def odd(effect: declared.Effect) -> set[sp.Symbol]:
    """The parameters that change sign in a mirror, in which the drive does and nothing else, or ValueError."""
    adds = quantities(effect)
    symbols = sorted({p.symbol for p in effect.parameters if p.symbol is not None}, key=str)
    for chosen in chain.from_iterable(combinations(symbols, n) for n in range(len(symbols) + 1)):
        mirror = {x: -x for x in (FALL, declared.PRESS_SLOPE, *chosen)}
        if all(sp.expand(e.xreplace(mirror) - (-e if q == "driving" else e)) == 0 for q, e in adds.items()):
            return set(chosen)
    raise ValueError(f"{effect.name}: no signs of its parameters make its terms the same in a mirror")


def moving(effect: declared.Effect | None = None) -> dict[sp.Symbol, tuple[sp.Expr, Increment]]:
    """What may change along a phase: base and increment by symbol."""
    speed = (ZERO, series("omega"))
    found = position() | {OMEGA: speed, declared.SPEED: speed, SLIP: (BEGAN, series("x"))}
    if effect is not None:
        signs = dict.fromkeys(odd(effect), DIRECTION)
        for p in effect.parameters:
            if p.symbol is not None and p.symbol not in BY_PSI:
                s = signs.get(p.symbol, ONE)
                found[p.symbol] = (s * p.symbol, series(f"d{p.symbol}", s) if p.kind == "series" else {})
            if p.kind == "rotation":
                found[p.symbol] = (p.symbol, powers(str(p.symbol), "x", DEGREE))
        found |= {x: (cell(f"{x}_0"), series(f"d{x}")) for x in effect.given}
    return found


def powers(table: str, argument: str, degree: int) -> Increment:
    """The increment of a table's piece, a polynomial of a register."""
    return {(argument,) * k: cell(f"{table}.Q{k}") for k in range(1, degree + 1)}


def of_effect(effect: declared.Effect) -> Fragment:
    """What an effect adds to the quantities of the balance, and the rates of its states."""
    if effect.turns:
        return rotation(effect)
    low = Lowering(effect.name, moving(effect))
    for x in effect.given:
        low.cells |= {f"{x}_less": -x, f"{x}_0": -cell(f"{x}_less")}  # the state's own cell moves on along the phase
        low.put("lin", f"d{x}", f"{x}_less", (("=1.0", str(x)),))
    low.moving = {**low.moving, **TOTALS}
    rate = sp.expand(effect.growth * OMEGA).subs(declared.EFFECTIVE, NORMAL / LEVEL).subs(MU * NORMAL, FRICTION)
    symbols = [p for p in effect.parameters if p.symbol is not None and p.kind != "rotation"]
    turned = [str(p.symbol) for p in effect.parameters if p.kind == "rotation"]
    return low.fragment(
        (f"({effect.equation}) {effect.help}", *declared.formulas(effect)),
        quantities(effect),
        inputs=[str(p.symbol) for p in symbols],
        optional=[str(p.symbol) for p in symbols if p.optional],
        states={str(x): rate for x in effect.given},
        tables=tuple((name, "rotation", "x", DEGREE) for name in turned),
    )


def of_law(law: declared.Law) -> Fragment:
    """Friction of a law: its base and its increment, from its formula or as the polynomial of a table's piece."""
    low, words = Lowering(law.name, moving()), [f"({law.equation}) {law.help}"]
    coefficient = law.coefficient if law.depends_on else cell("coefficient")
    if coefficient is not None and not law.kinks:
        own = {cell(p.name): cell(f"{law.name}.{p.name}") for p in law.parameters}
        words.append(f"mu = {sp.sstr(coefficient)}")
        return low.fragment(words, {"mu": coefficient.xreplace(own)}, [str(x) for x in own.values()])
    value, argument = cell(f"{law.name}.VALUE"), "x"
    if law.depends_on == ("time",):
        low.moving, argument = {value: (value, series(f"d{law.name}"))}, f"d{law.name}"
        return low.fragment(words, {"mu": value}, tables=((law.name, "time", argument, 0),))
    if law.depends_on == ("speed",):
        # The logarithm of the speed over that where the phase began. The first piece, below the table, is constant.
        argument, beyond, start = "log_speed", cell("beyond"), cell("start_speed")
        low.cells["beyond"] = Select(0, cell(f"{law.name}.PIECE"), 1, 0)
        low.cells["start_speed"] = Select(0, beyond, cell("omega"), 1)
        low.put("lin", "relative_speed", low.cell(-beyond), ((low.cell(beyond / start), "omega"),))
        low.put("log", argument, "relative_speed")
    low.moving = {value: (value, powers(law.name, argument, law.degree))}
    of = "x" if argument == "x" else "log(omega/omega_0)"
    words.append(f"mu = VALUE + Q1 y + Q2 y^2 + ..., y = {of}")
    return low.fragment(words, {"mu": value}, tables=((law.name, law.depends_on[0], argument, law.degree),))


def pieces(law: declared.Law) -> tuple[list[sp.Expr], list[list[sp.Expr]]]:
    """Where the pieces of a law with kinks begin, over its scale, and their polynomials in what is beyond.

    A piece takes the branch of each minimum or maximum that holds there, so that a constant piece is the number given.
    """
    s, y, scale = cell("s"), cell("y"), cell(law.scale)
    breaks = [ZERO, *(cell(kink) / scale for kink in law.kinks)]
    found = []
    for start, end in zip(breaks, [*breaks[1:], breaks[-1] + 1], strict=True):
        inside = (
            sp.sympify(law.coefficient)
            .subs(SLIP, s * scale)
            .replace(
                lambda e: isinstance(e, (sp.Min, sp.Max)),
                lambda e, at=(start + end) / 2: next(x for x in e.args if x.subs(s, at) == e.subs(s, at)),
            )
        )
        beyond = sp.Poly(sp.expand(inside.subs(s, start + y)), y).all_coeffs()[::-1]
        found.append([*beyond, *[ZERO] * (law.degree + 1 - len(beyond))])
    return breaks, found


def gravity() -> Fragment:
    """The weight, which drives and presses; of a frozen mass, where nothing else says how its components turn."""
    low = Lowering("gravity", {})
    low.cells |= {str(seen(q)): sign(q) * q for q in BY_PSI}
    low.moving = position()
    words = ["(3.11) driving = J_theta/Theta*, pressing = J_r/Theta*, in the direction of travel"]
    return low.fragment(words, {"driving": FALL, "pressing": PRESS})


def rotation(effect: declared.Effect) -> Fragment:
    """The turning of the weight: its components where the phase begins, and the series that they turn by."""
    low = Lowering(effect.name, {})
    for q, slope in BY_PSI.items():
        low.cells[str(seen(q))] = sign(q) * (q * sp.cos(ROTATION) - slope * sp.sin(ROTATION))
    low.turn(series("x"), ONE, ONE)
    low.put("lin", "upright", str(seen(PRESS)), low.sum(position()[PRESS][1]))
    words = [
        f"({effect.equation}) {effect.help}",
        *declared.formulas(effect),
        "q(psi - x) = q - q vers x - q' sin x, of J_theta, J_r and their slopes",
    ]
    return low.fragment(words, {})


def balance() -> Fragment:
    """The balance of momentum of its quantities, which are the sums of what the fragments add."""
    driving, resisting, pressing, lifting, mu = (cell(x) for x in (*QUANTITIES, "mu"))
    sums = {x: (cell(f"{x}_0"), series(f"d{x}")) for x in (driving, resisting, pressing, lifting, mu)}
    low = Lowering("balance", sums)
    low.cells["grip"] = 1 - cell("LIFTED")
    for name, e in (("normal", pressing - lifting), ("friction", GRIP * mu * NORMAL)):
        low.cells[f"{name}_0"], increment = low.split(e)
        low.register(increment, f"d{name}")
        low.put("lin", name, f"{name}_0", (("=1.0", f"d{name}"),))
        low.moving = {**low.moving, cell(name): (cell(f"{name}_0"), series(f"d{name}"))}
    for name in (*QUANTITIES, "mu"):
        low.put("lin", name, f"{name}_0", (("=1.0", f"d{name}"),))
    static, increment = low.split(driving - resisting - FRICTION)
    low.register(increment, "dnet")
    low.put("lin", "net", "drive", (("=1.0", "dnet"),))
    # As long as nothing that it depends on has departed from the start, what drives is made of what is left of the
    # limit friction. That of weight alone is given, and is known better than a quotient of sums.
    low.cells["limit_0"] = (cell("driving_0") - cell("resisting_0")) / cell("normal_0")
    driven, pressed = cell("driving_0") - cell(str(seen(FALL))), cell("normal_0") - cell(str(seen(PRESS)))
    low.cells["others"] = abs(driven) + abs(pressed) + cell("resisting_0")
    low.cells["limit"] = Select(0, cell("others"), cell("limit_0"), cell("LIMIT"))
    low.cells["gap"] = cell("limit") - cell("mu_0")
    given = cell("normal_0") * cell("gap")
    driven = Select(0, cell("driving_0") - cell("resisting_0"), 1, 0)
    low.cells["first"] = Select(0, cell("departed"), 0, GRIP * driven)
    low.cells["drive"] = Select(0, cell("first"), given, static)
    drives, resists, presses, lifts = (cell(f"{x}_size") for x in QUANTITIES)
    whole = drives + resists + GRIP * cell("mu_0") * (presses + lifts)
    low.cells["drive_scale"] = sp.Rational(1, 2**52) * Select(0, cell("first"), abs(cell("drive")), whole)
    words = [
        "(3.11) d omega*/dt* = net = driving - resisting - friction, friction = mu normal unless the mass is lifted",
        "normal = pressing - lifting; net = drive + dnet, where drive is net where the phase began, at no speed",
        "drive = normal (limit - mu) as at the start; drive_scale is the rounding of its terms",
    ]
    return low.fragment(words, {})


def energy() -> Fragment:
    """Work of what drives and loss to what resists, as states: only where they are asked for."""
    names = ("driving", "resisting", "friction", "brakes", "omega")
    driving, resisting, friction, brakes, omega = (cell(x) for x in names)
    low = Lowering("energy", {cell(x): (ZERO, series(x)) for x in names})  # in full
    low.register(low.split(resisting + friction)[1], "brakes")
    words = ["dwork/dt* = driving omega*, ddissipation/dt* = (resisting + friction) omega*, over Theta*"]
    return low.fragment(words, {}, states={"work": driving * omega, "dissipation": brakes * omega})


def fragments(effects: Sequence[declared.Effect] = EFFECTS, laws: Sequence[declared.Law] = LAWS) -> dict[str, Fragment]:
    """All fragments by name, of these effects and laws."""
    declared = {e.name: of_effect(e) for e in effects} | {law.name: of_law(law) for law in (*laws, CALLABLE)}
    laws_of = {cell(f"{x}_mu"): (cell(f"{x}_mu_0"), series(f"d{x}_mu")) for x in ("slip", "rate")}
    product = Lowering("product", laws_of).fragment(["mu = mu(slip) mu(speed)"], {"mu": sp.Mul(*laws_of)})
    return {"gravity": gravity()} | declared | {"product": product, "balance": balance(), "energy": energy()}
