"""Equation of motion in plain symbols and in LaTeX, term by term, from the declarations of effects and laws."""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from sympy import Add, Expr, Integer, Max, Symbol, cos, expand, latex, sin, symbols

from derive.declare.effects import (
    BY_PSI,
    DRIVING_MOMENT,
    DRIVING_MOMENT_SLOPE,
    EFFECTIVE,
    EFFECTS,
    J_R,
    J_THETA,
    LAMBDA,
    LAWS,
    MU,
    NORMAL_LOAD,
    NORMAL_LOAD_SLOPE,
    OMEGA,
    OMEGA_2,
    THETA,
    Effect,
)
from derive.declare.symbols import in_words
from derive.flow.fragments import CALLABLE
from derive.kinds import Values


class Term(NamedTuple):
    """Term of a quantity in the equation of motion, or its definition, in plain symbols and in LaTeX."""

    quantity: str
    formula: str
    latex: str


PHI, DIRECTION = symbols("phi s", real=True)
DRIVE, STRESS, PRESSURE, RESISTANCE = symbols("M sigma u T", real=True)
# Quantities of the equation: meaning and LaTeX.
QUANTITIES = {
    "M": ("moment that drives", "M"),
    "sigma": ("mean normal stress on the slip surface, over sigma_ref", r"\sigma"),
    "u": ("mean pore pressure on it, over sigma_ref", "u"),
    "mu": ("friction coefficient", r"\mu"),
    "T": ("moment that resists beside friction", "T"),
}
# For a slip surface in several soils: quantities of each soil i, and their replacements for numbers of the whole
# surface.
_FRICTION = Symbol("max(0, sum l_i mu_i (sigma_i - u_i))")
SOIL_QUANTITIES = {
    "M": QUANTITIES["M"],
    "sigma_i": ("mean normal stress on the slip surface in soil i, over sigma_ref", r"\sigma_i"),
    "u_i": ("mean pore pressure on it, over sigma_ref", "u_i"),
    "mu_i": ("friction coefficient of soil i", r"\mu_i"),
    "T": QUANTITIES["T"],
}
_SHARE, _SHARE_OF_WEIGHT = symbols("l_i n_i")
_OF_SOIL = {name: Symbol(by_soil) for name, by_soil in {
    "sigma": "sigma_i", "u": "u_i", "A": "A_i",
    "J_r": "J_ri", "J_r'": "J_ri'", "J_r0": "J_r0i", "J_r0'": "J_r0i'"}.items()}  # fmt: skip
_OF_SOIL["lambda"] = LAMBDA * _SHARE
_OF_SOIL["excess"] = Symbol("excess") * _SHARE_OF_WEIGHT / _SHARE
# Components of the weight in the balance, at any rotation and at the start.
COMPONENTS = {
    DRIVING_MOMENT: "J_theta",
    NORMAL_LOAD: "J_r",
    DRIVING_MOMENT_SLOPE: "J_theta'",
    NORMAL_LOAD_SLOPE: "J_r'",
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
    "sigma_ref": "reference stress (2.13), Pa",
}
SOIL_COEFFICIENTS = {
    "l_i": "share of the slip surface that is in soil i",
    "J_r0i": "weight above it along the radius (2.23), at the start",
    "J_r0i'": "derivative of J_ri by the dip, at the start",
    "A_i": "dynamic coefficient (2.24) of this weight",
    "c_i": "mean cohesion along it, over sigma_ref",
    "p_i": "mean water pressure on it, over sigma_ref",
    "n_i": "share of J_r0 that is J_r0i, before the mass moves",
}
_LATEX = {
    "J_theta": r"J_\theta", "J_theta'": r"J_\theta'", "J_r'": "J_r'", "J_theta0": r"J_{\theta 0}",
    "J_theta0'": r"J_{\theta 0}'", "J_r0": "J_{r0}", "J_r0'": "J_{r0}'", "phi": r"\varphi", "cohesion": "c",
    "pore_ratio": "r_u", "pore_pressure": "p", "water": "w", "drag": "d", "viscosity": "e", "excess": r"u_T",
    "max(0, sigma - u)": r"\max(0, \sigma - u)", "peak": r"\mu_p", "residual": r"\mu_r", "length": "L",
    "velocity": "V", "slip": "S", "speed": "v", "coefficient": r"\mu_0",
    "J_ri": "J_{r,i}", "J_ri'": "J_{r,i}'", "J_r0i": "J_{r0,i}", "J_r0i'": "J_{r0,i}'",
    "sum l_i c_i": r"\sum_i l_i c_i",
    _FRICTION.name: r"\max\left(0, \sum_i l_i \mu_i \left(\sigma_i - u_i\right)\right)",
}  # fmt: skip


def term(quantity: str, e: Expr, by_soil: bool = False) -> Term:
    """Return a term of a quantity from its expression ``e``, with the symbols of one of several soils on request."""
    slopes = {THETA * DRIVING_MOMENT_SLOPE: Symbol("J_theta'"), THETA * NORMAL_LOAD_SLOPE: Symbol("J_r'")}
    effective = Symbol("max(0, sigma - u)")
    shown = e.subs(slopes | {OMEGA_2: OMEGA**2, EFFECTIVE: effective})
    if by_soil:
        indexed = {x: _OF_SOIL[x.name] for x in shown.free_symbols if x.name in _OF_SOIL}
        shown = shown.subs({MU * effective: _FRICTION} | indexed)
        quantity = str(_OF_SOIL.get(quantity, quantity))
    names = {x: _LATEX[x.name] for x in shown.free_symbols if x.name in _LATEX}
    return Term(quantity, in_words(shown).replace("Min(", "min("), latex(shown, symbol_names=names))


def _balance(by_soil: bool = False) -> Term:
    """Return (3.11) with (2.20): the rate of the angular velocity in the time t sqrt(g/R); s is the sign of omega."""
    friction = _FRICTION if by_soil else MU * Max(0, STRESS - PRESSURE, evaluate=False)
    shown = term("Theta domega/dt", DRIVE - DIRECTION * (LAMBDA * friction + RESISTANCE))
    return shown._replace(formula=shown.formula.replace("Max(", "max("))


Terms = tuple[tuple[str, Expr], ...]  # quantities with expressions
GRAVITY: Terms = (("M", J_THETA), ("sigma", J_R / LAMBDA))
# Cohesion and water of soils.
SOILS: Terms = (("u_i", Symbol("p_i")), ("T", LAMBDA * Symbol("sum l_i c_i")))


def _position(rotates: bool) -> Terms:
    """Return the components of the weight by name after a rotation phi, or without ``rotates`` at the start.

    A component is q(psi_0 - phi) = q cos phi - q' sin phi.
    """
    start = {}
    for q, name in COMPONENTS.items():
        bare = name.rstrip("'")
        primes = name[len(bare) :]
        start[q] = Symbol(f"{bare}0{primes}")
    angle = PHI if rotates else Integer(0)
    turned = []
    for q, name in COMPONENTS.items():
        turned.append((name, start[q] * cos(angle) - BY_PSI[q].subs(start) * sin(angle)))
    return tuple(turned)


def _effect_terms(effect: Effect) -> Terms:
    """Return the terms of an effect, one by one, and the rates of its states."""
    adds = {
        "M": effect.driving_moment,
        "sigma": effect.stress + effect.normal_load / LAMBDA,
        "u": effect.pressure,
        "T": effect.resistance,
    }
    terms = []
    for q, e in adds.items():
        if e != 0:
            terms += [(q, x) for x in Add.make_args(expand(e))]
    terms += [(f"d{x}/dphi", effect.growth) for x in effect.states]
    return (*(_position(True) if effect.turns else ()), *terms)


def terms(by_soil: bool = False) -> dict[str, tuple[Term, ...]]:
    """Return the terms of gravity and of each effect; "frozen" is the position without rotation."""
    every = {"gravity": GRAVITY, "frozen": _position(False)}
    every |= {effect.name: _effect_terms(effect) for effect in EFFECTS}
    shown = {}
    for name, added in every.items():
        shown[name] = tuple(term(q, e, by_soil) for q, e in added)
    return shown | ({"soils": tuple(term(q, e) for q, e in SOILS)} if by_soil else {})


def laws() -> dict[str, tuple[Term, ...]]:
    """Return the friction coefficient of each law. For a table or a Python function only its argument is named."""
    shown: dict[str, tuple[Term, ...]] = {}
    for law in (*LAWS, CALLABLE):
        argument = "".join(law.depends_on)
        shown[law.name] = (Term("mu", f"mu({argument})", rf"\mu(\mathrm{{{argument}}})"),)
        if law.coefficient is not None:
            shown[law.name] = (term("mu", law.coefficient),)
    return shown


def equation_text() -> str:
    """Return the block of `generated/flow.py`."""
    typed = "dict[str, tuple[tuple[str, str, str], ...]]"
    return (
        "# The equation of motion: quantity, formula and LaTeX.\n"
        f"BALANCE = {tuple(_balance())!r}\n"
        f"# Its quantities: meaning and LaTeX.\n{_table('EQUATION_QUANTITIES', QUANTITIES)}"
        f"# Its numbers in every scene.\n{_table('COEFFICIENTS', COEFFICIENTS)}"
        "# Terms of gravity, of each effect and of each law.\n"
        f"{_table(f'TERMS: {typed}', _as_tuples(terms() | laws()))}"
        "# The same for several soils along the slip surface.\n"
        f"SOIL_BALANCE = {tuple(_balance(True))!r}\n{_table('SOIL_QUANTITIES', SOIL_QUANTITIES)}"
        f"{_table('SOIL_COEFFICIENTS', SOIL_COEFFICIENTS)}{_table(f'SOIL_TERMS: {typed}', _as_tuples(terms(True)))}"
        f"{_table('LATEX', _LATEX)}\n"
    )


def _as_tuples(terms: Mapping[str, Sequence[Term]]) -> dict[str, tuple[Any, ...]]:
    """Return terms by name as plain tuples."""
    return {name: tuple(map(tuple, added)) for name, added in terms.items()}


def _table(name: str, rows: Values) -> str:
    """Return the dictionary ``name`` as Python source with one row per line."""
    body = "".join(f"    {key!r}: {value!r},\n" for key, value in rows.items())
    return f"{name} = {{\n{body}}}\n"
