"""The equation of motion in plain symbols and in LaTeX, term by term, from the declarations of effects and laws."""

from collections.abc import Sequence
from typing import NamedTuple

import sympy as sp
from sympy import Expr, Max, Symbol, cos, sin

from derive.declare import effects as declared
from derive.declare.effects import ALL_EFFECTS, BY_PSI, EFFECTS, LAMBDA, LAWS, MU, OMEGA, OMEGA_2, THETA
from derive.declare.symbols import in_words


class Term(NamedTuple):
    """A term of a quantity in the equation of motion, or its definition, in plain symbols and in LaTeX.

    ``symbols`` are those of the formula.
    """

    quantity: str
    formula: str
    latex: str
    symbols: tuple[str, ...]


PHI, DIRECTION = sp.symbols("phi s", real=True)
DRIVE, STRESS, PRESSURE, RESISTANCE = sp.symbols("M sigma u T", real=True)
# Quantities of the equation: what they are, and their LaTeX.
QUANTITIES = {
    "M": ("moment that drives", "M"),
    "sigma": ("mean normal stress on the slip surface", r"\sigma"),
    "u": ("mean pore pressure on it", "u"),
    "mu": ("friction coefficient", r"\mu"),
    "T": ("moment that resists beside friction", "T"),
}
# Components of the weight in the balance, at any rotation and at the start.
COMPONENTS = {
    declared.DRIVING_MOMENT: "J_theta",
    declared.NORMAL_LOAD: "J_r",
    declared.DRIVING_MOMENT_SLOPE: "J_theta'",
    declared.NORMAL_LOAD_SLOPE: "J_r'",
}
# Numbers of the equation in every scene.
COEFFICIENTS = {
    "Theta": "moment of inertia (3.12)",
    "lambda": "resistance factor (3.14)",
    "A": "dynamic coefficient (2.24)",
    "J_theta0": "moment of the weight at the start (3.13)",
    "J_r0": "weight along the radius at the start (2.23)",
    "J_theta0'": "derivative of J_theta by the dip, at the start",
    "J_r0'": "derivative of J_r by the dip, at the start",
}
_LATEX = {
    "J_theta": r"J_\theta", "J_theta'": r"J_\theta'", "J_r'": "J_r'", "J_theta0": r"J_{\theta 0}",
    "J_theta0'": r"J_{\theta 0}'", "J_r0": "J_{r0}", "J_r0'": "J_{r0}'", "phi": r"\varphi", "cohesion": "c",
    "pore_ratio": "r_u", "pore_pressure": "p", "water": "w", "drag": "d", "viscosity": "e", "excess": r"u_T",
    "max(0, sigma - u)": r"\max(0, \sigma - u)", "peak": r"\mu_p", "residual": r"\mu_r", "length": "L",
    "velocity": "V", "slip": "S", "speed": "v", "coefficient": r"\mu_0",
}  # fmt: skip


def term(quantity: str, e: Expr) -> Term:
    """A term from its expression."""
    slopes = {
        THETA * declared.DRIVING_MOMENT_SLOPE: Symbol("J_theta'"),
        THETA * declared.NORMAL_LOAD_SLOPE: Symbol("J_r'"),
    }
    effective = Symbol("max(0, sigma - u)")
    shown = e.subs(slopes | {OMEGA_2: OMEGA**2, declared.EFFECTIVE: effective})
    names = {x: _LATEX[x.name] for x in shown.free_symbols if x.name in _LATEX}
    symbols = tuple(sorted(x.name for x in shown.free_symbols))
    return Term(quantity, in_words(shown).replace("Min(", "min("), sp.latex(shown, symbol_names=names), symbols)


def balance() -> Term:
    """(3.11) with (2.20): the rate of the angular velocity, where s is the sign of omega, in the time t sqrt(g/R)."""
    normal = Max(0, STRESS - PRESSURE, evaluate=False)
    shown = DRIVE - DIRECTION * (LAMBDA * MU * normal + RESISTANCE)
    formula = in_words(shown).replace("Max(", "max(")
    return Term("Theta domega/dt", formula, sp.latex(shown), tuple(sorted(x.name for x in shown.free_symbols)))


def gravity() -> tuple[Term, ...]:
    """Terms of the weight alone."""
    return term("M", declared.J_THETA), term("sigma", declared.J_R / LAMBDA)


def position(rotates: bool) -> tuple[Term, ...]:
    """The components of the weight after a rotation, q(psi_0 - phi) = q cos phi - q' sin phi, or the initial ones."""
    start = {q: Symbol(f"{name.rstrip(chr(39))}0{chr(39) * name.count(chr(39))}") for q, name in COMPONENTS.items()}
    angle = PHI if rotates else sp.Integer(0)
    return tuple(
        term(name, start[q] * cos(angle) - BY_PSI[q].subs(start) * sin(angle)) for q, name in COMPONENTS.items()
    )


def of_effect(effect: declared.Effect) -> tuple[Term, ...]:
    """Terms that an effect adds to each quantity, one by one, and the rates of its states."""
    adds = {
        "M": effect.driving_moment,
        "sigma": effect.stress + effect.normal_load / LAMBDA,
        "u": effect.pressure,
        "T": effect.resistance,
        "mu": effect.friction,
    }
    terms = [term(q, x) for q, e in adds.items() if e != 0 for x in sp.Add.make_args(sp.expand(e))]
    terms += [term(f"d{x}/dphi", effect.growth) for x in effect.states]
    return (*(position(True) if effect.turns else ()), *terms)


def of_law(law: declared.Law) -> tuple[Term, ...]:
    """The friction coefficient of a law; for a table or a Python function, its arguments."""
    if law.coefficient is not None or not law.depends_on:
        return (term("mu", sp.sympify(law.coefficient or Symbol("coefficient"))),)
    argument = law.depends_on[0]
    return (Term("mu", f"mu({argument})", rf"\mu(\mathrm{{{argument}}})", (argument,)),)


def terms(
    effects: Sequence[declared.Effect] = ALL_EFFECTS, laws: Sequence[declared.Law] = LAWS
) -> dict[str, tuple[Term, ...]]:
    """All terms, by the effect or law to which they belong; "frozen" is the position without rotation."""
    every = {"gravity": gravity(), "frozen": position(False)}
    every |= {effect.name: of_effect(effect) for effect in effects}
    every |= {law.name: of_law(law) for law in laws}
    return every | {"callable": (Term("mu", "mu(slip)", r"\mu(\mathrm{slip})", ("slip",)),)}


def in_plain_text() -> str:
    """The balance and what each effect adds to it, as lines."""
    equation, lines = balance(), []
    lines.append(f"    {equation.quantity} = {equation.formula},  s = sgn(omega)")
    for name, added in {"gravity": gravity(), **{e.name: of_effect(e) for e in EFFECTS}}.items():
        for row in added:
            sign = "+=" if row.quantity in QUANTITIES else "="
            lines.append(f"    {row.quantity:12} {sign:2} {row.formula:40} {name}".rstrip())
    return "\n".join(lines)


def text() -> str:
    """The block of `generated/flow.py`."""
    rows = "".join(f"    {name!r}: {(*map(tuple, added),)!r},\n" for name, added in terms().items())
    quantities = "".join(f"    {name!r}: {words!r},\n" for name, words in QUANTITIES.items())
    numbers = "".join(f"    {name!r}: {words!r},\n" for name, words in COEFFICIENTS.items())
    return (
        "# The equation of motion: quantity, formula, LaTeX, and the symbols of the formula.\n"
        f"BALANCE = {tuple(balance())!r}\n"
        "# Its quantities: what they are, and their LaTeX.\n"
        f"EQUATION_QUANTITIES = {{\n{quantities}}}\n"
        "# Its numbers that every scene has.\n"
        f"COEFFICIENTS = {{\n{numbers}}}\n"
        "# What gravity, each effect and each law add to it.\n"
        f"TERMS: dict[str, tuple[tuple[str, str, str, tuple[str, ...]], ...]] = {{\n{rows}}}\n"
        "LATEX = {\n" + "".join(f"    {name!r}: {latex!r},\n" for name, latex in _LATEX.items()) + "}\n\n"
    )
