"""Checks of declarations before the derivation, with one-line faults: names, symbols, units, domains and sources."""

import builtins
import keyword
import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import fields
from functools import cache
from types import UnionType
from typing import Any, NoReturn, get_args, get_origin

import numpy as np
from sympy import Expr, Function, I, Max, Min, Symbol, diff, nan, oo, sqrt, srepr, tanh, zoo

from derive.check.proof import ProofError
from derive.code import emit
from derive.declare import domain
from derive.declare.effects import (
    BY_PSI,
    COHESION_LAW,
    DEGREE,
    GRAVITY,
    K_H,
    K_V,
    OMEGA,
    OMEGA_2,
    RADIUS,
    SECTION_EFFECTS,
    SLIP,
    SLIP_MU,
    SOIL_MU,
    VALUE,
    Effect,
    Law,
    Parameter,
)
from derive.declare.limits import LIMITS
from derive.declare.quantities import QUOTIENTS, Moment
from derive.declare.units import Units, dimension, of_unit, shown
from derive.flow import fragments
from derive.flow.lowering import KNOWN
from derive.flow.recurrences import OPERATIONS
from derive.kinds import TextMap, Texts
from derive.progress import say

Declaration = Effect | Law | Moment
# Equations of the paper, and its figure of friction laws.
PAPER = re.compile(r"1\.([1-9]|1[0-4])|2\.([1-9]|1\d|2[0-7])|3\.([1-9]|1\d|2[01])|4\.[1-5]|Fig\. 4-1")
# Names in use: other tables and keys of scene files; functions of the package; modules of `generated`, and other names
# in the text of a kernel; keys of a law other than its parameters, and other names in formulas of these.
TABLES = (
    "accuracy arc circle end_time_s format friction ground initial_velocity_m_s layers name note observed output pond "
    "search report slip soils surcharge tension_crack water"
)
FUNCTIONS = "backanalyse critical ensemble grid load parameters plan read_suite solve synthetic_records"
MODULES = "definitions effects flow generated integrator kernels layout printed program series slopes tiers"
ARGUMENTS = "resistance_factor limit_friction alpha theta_1 theta_2 out where accuracy"
KEYS = "law rate soils function value scales half_angle gravity radius density reference_stress cover strength_factor"
# Arguments of laws without formula.
TABLES_OF = [[(*x, "list"), ("coefficient", "", "list")] for x in (("slip", "m"), ("speed", "m/s"), ("time", "s"))]
UNITS_OF_LAWS = ("", "m", "m/s", "s")
NUMBERS = ("number", "series", "rotation")
KINDS = (*NUMBERS, "list", "text", "name", "flag", "fixed")
# Functions of series, beside powers and minima; tanh consists of exponentials.
OF_SERIES = {tanh, *(type(f) for o in OPERATIONS.values() for e in o.means for f in e.atoms(Function))}
NEVER_NEGATIVE = ("resistance", "mu")
FARTHEST = 1e6  # slip and speed, relative to the scales of the law
STEEPEST = 10.0  # coefficient


def _units(by_name: TextMap) -> dict[Symbol, Expr]:
    """Return dimensions by symbol, from units by names; blanks separate the names."""
    return {Symbol(name, real=True): of_unit(unit) for names, unit in by_name.items() for name in names.split()}


# Units of symbols in the formulas of laws, in conversions of parameters to dimensionless numbers, and in the balance.
# All are dimensionless in the balance except slip, speed, and parameters that are converted like them.
NUMBER = of_unit("")
MOTION = _units({"slip": "m", "speed": "m/s"})
SCALES = _units({"half_angle cover Theta strength_factor": "", "radius": "m", "gravity": "m/s^2"})
SCALES |= _units({"density": "kg/m^3", "reference_stress": "Pa"})
LIKE_MOTION = {VALUE / RADIUS: of_unit("m"), VALUE / sqrt(GRAVITY * RADIUS): of_unit("m/s")}
OF_WEIGHT = "Theta J_r J_theta lambda A driving_moment driving_moment_slope normal_load normal_load_slope"
BALANCE = MOTION | _units({OF_WEIGHT: "", "omega omega_2 k_h k_v": ""})
OF_SECTIONS = dict.fromkeys((*BY_PSI, SLIP_MU, SOIL_MU, COHESION_LAW), NUMBER)
OF_GROWTH = _units({"mu effective_stress": ""})


def _place(e: Declaration, what: str) -> str:
    """Return the place of a fault: the declaration and its field."""
    return f"{type(e).__name__}({e.name!r}), {what}"


def refuse(e: Declaration, what: str, found: object, allowed: str) -> NoReturn:
    """Raise `ProofError` with the place ``what`` in a declaration, the value found and the values allowed."""
    raise ProofError(_place(e, what), found, allowed)


def check(every: Sequence[Declaration]) -> None:
    """Check types of fields, sources, and that names, symbols and weights are unique; raise `ProofError`."""
    balance = fragments.fragments((), ())
    for e in every:
        _check_fields(e, e)
    in_text = re.findall(r"\w+", " ".join((FUNCTIONS, MODULES, ARGUMENTS, emit.KERNEL_IMPORTS, emit.STUB_IMPORTS)))
    in_scenes = {*balance, "frozen", *TABLES.split()}
    in_modules = {*in_text, *dir(builtins), *dir(np), *(q.name for q in QUOTIENTS)}
    symbols = set(map(str, {*SCALES, *BALANCE, *OF_GROWTH, VALUE} - {K_H, K_V}))
    symbols.update(re.findall(r"\w+", repr(balance)))
    weights: dict[Expr, str] = {}
    for e in every:
        if e.equation and not PAPER.fullmatch(e.equation):
            refuse(e, "equation", repr(e.equation), "an equation of the paper, 1.1 to 4.5, or source= instead")
        if e.equation and e.source:
            refuse(e, "equation", f"{e.equation!r} beside source={e.source!r}", "equation or source")
        _check_name(e, "name", e.name, in_modules if isinstance(e, Moment) else in_scenes)
        if isinstance(e, Effect):
            _check_symbols(e, symbols)
        if isinstance(e, Moment):
            if e.amplitude:
                _check_name(e, "name", e.kernel[0], in_modules)
            _ = e.definition
            if weights.setdefault(e.weight, e.name) != e.name:
                refuse(e, "weight", f"{e.weight}, as of {weights[e.weight]}", "another weight")


@cache
def check_alone(e: Law | Effect) -> None:
    """Check the formulas of a law or an effect: functions, symbols, units, domains, degrees; raise `ProofError`."""
    unused = _check_law(e) if isinstance(e, Law) else _check_effect(e)
    if unused:
        refuse(e, "parameters", f"{', '.join(unused)} in no formula", "a use of each")


def _check_fields(e: Declaration, of: Declaration | Parameter, where: str = "") -> None:
    """Check that each field, including those of parameters, has its type, and that no text is blank.

    The fields are those of ``of``, the declaration ``e`` itself or one of its parameters, which ``where`` names in an
    error.
    """
    for f in fields(of):
        value = getattr(of, f.name)
        blank = isinstance(value, str) and not value.strip() and (value or f.name in ("help", "symbol"))
        if blank or not _fits(value, f.type):
            kind = f.type.__name__ if isinstance(f.type, type) else str(f.type)
            allowed = "a description" if blank else re.sub(r"[a-z.]+\.(?=[A-Z])", "", kind)
            refuse(e, where + f.name, f"{value!r:.60}", allowed)
    for p in getattr(of, "parameters", ()):
        _check_fields(e, p, f"parameter {p.name!r}, ")


def _fits(value: object, kind: Any) -> bool:
    """Return whether a value has the type ``kind``, the annotation of a field. Expressions are checked later."""
    if get_origin(kind) is UnionType:
        return any(_fits(value, x) for x in get_args(kind))
    if get_origin(kind) is not tuple:
        return kind is Expr or isinstance(value, int | float if kind is float else kind)
    first, *others = get_args(kind)
    kinds = [first, *others]
    if others == [...] and isinstance(value, tuple):
        kinds = [first] * len(value)
    return isinstance(value, tuple) and len(value) == len(kinds) and all(map(_fits, value, kinds))


def _check_name(e: Declaration, what: str, name: str, taken: set[str]) -> None:
    """Check that a name is valid in Python and in scene files, and not in ``taken``, to which it is added.

    ``what`` names the field of the declaration in an error.
    """
    if not re.fullmatch("[a-z][a-z0-9_]*", name):
        refuse(e, what, repr(name), "small letters, digits and _, a letter first")
    if keyword.iskeyword(name) or name in taken:
        use = "a keyword of Python" if keyword.iskeyword(name) else "a name in use"
        refuse(e, what, f"{name!r}, {use}", "another name")
    taken.add(name)


def _check_symbols(effect: Effect, taken: set[str]) -> None:
    """Check that a symbol denotes one number of a program, of a single effect and not of the balance.

    ``taken`` are the names in use, to which those of the effect are added.
    """
    for x in (*effect.symbols, *effect.states):
        name = str(x)
        names = {name, f"{name}_0", f"d{name}"}
        if x != Symbol(name, real=True) or not name.isidentifier():
            refuse(effect, "symbols", srepr(x), "sp.Symbol('name', real=True)")
        if x not in BY_PSI and names & taken:
            refuse(effect, "symbols", x, "each for one quantity of one effect")
        taken |= names


def _check_parameters(e: Law | Effect, units: Collection[str]) -> dict[Symbol, Parameter]:
    """Check names, kinds, bounds, units and keys, and return parameters by the symbols of their names.

    ``units`` are the allowed ones.
    """
    taken = {*KEYS.split()}
    in_formula: Sequence[str] = NUMBERS
    if isinstance(e, Law):
        in_formula = KINDS if e.coefficient is None else ("number",)
    for p in e.parameters:
        what = f"parameter {p.name!r}"
        _check_name(e, what, p.name, taken)
        if p.kind not in KINDS and not re.fullmatch(r"[\w-]+(\|[\w-]+)+", p.kind):
            refuse(e, f"{what}, kind", repr(p.kind), f"{', '.join(KINDS)} or this|that")
        if p.kind not in in_formula and (p.symbol or isinstance(e, Law)):
            refuse(e, f"{what}, kind", repr(p.kind), f"a kind with a formula: {', '.join(in_formula)}")
        if p.unit not in units:
            refuse(e, f"{what}, unit", repr(p.unit), f"a unit of {', '.join(map(repr, units))}")
        if not p.lower < p.upper:
            refuse(e, f"{what}, bounds", f"{p.lower} and {p.upper}", "a lower bound below an upper bound")
        if allowed := _fault_of_key(p, taken):
            refuse(e, f"{what}, key", repr(p.key), allowed)
        taken |= {p.key}
    return {Symbol(p.name, real=True): p for p in e.parameters}


def _fault_of_key(p: Parameter, taken: set[str]) -> str:
    """Return the allowed keys if a parameter's key for scene files is wrong or in ``taken``, else an empty text."""
    if not p.key:
        return "" if p.optional else "a key for scene files, as it is not optional"
    if p.kind == "rotation":
        return "none, as the section provides the value"
    if not p.key.isidentifier() or not p.per_unit:
        return f"letters, digits and _, at the end the unit {p.unit!r} with k, M or nothing before it"
    return "another key, as this key is in use" if p.key in taken - {p.name} else ""


def _check_formula(e: Declaration, what: str, formula: Expr, units: Units) -> set[Symbol]:
    """Check the functions and symbols of a formula that must be dimensionless, and return its symbols.

    ``what`` names the formula in an error, and ``units`` are the dimensions of the symbols allowed in it.
    """
    if not isinstance(formula, Expr) or formula.has(I, nan, oo, zoo):
        refuse(e, what, repr(formula), "an expression of SymPy in real numbers")
    for function in sorted(formula.atoms(Function), key=str):
        if type(function) not in OF_SERIES:
            refuse(e, what, function, KNOWN)
    found = dimension(formula, units, _place(e, what))
    if found != 1:
        refuse(e, what, f"{formula}, in {shown(found)}", "a number without a dimension")
    return formula.free_symbols


def _check_law(law: Law) -> Texts:
    """Check a law and return the names of its unused parameters."""
    by_symbol = _check_parameters(law, UNITS_OF_LAWS)
    formula = law.coefficient
    if formula is None:
        if [(p.name, p.unit, p.kind) for p in law.parameters] not in TABLES_OF:
            refuse(law, "coefficient", "none", "a formula, or two lists: slip, speed or time, and coefficient")
        if not 0 <= law.degree <= DEGREE:
            refuse(law, "degree", law.degree, f"0 to {DEGREE}")
        return []
    if law.degree:
        refuse(law, "degree", law.degree, "none, as it follows from the formula")
    used = _check_formula(law, "coefficient", formula, MOTION | _units({p.name: p.unit for p in law.parameters}))
    if MOTION.keys() <= used:
        refuse(law, "coefficient", "slip and speed", "slip or speed: in a scene two laws multiply each other")
    _check_kinks(law, formula, by_symbol)
    fault, undecided = domain.fault(formula, _box(law, by_symbol))
    if fault:
        refuse(law, "coefficient", fault, "numbers that are not negative")
    if undecided:
        fault = f"not shown to be finite and not negative next to {undecided}"
        say(f"{_place(law, 'coefficient')}: {fault}; narrow the bounds of its parameters")
    fragments.law_fragment(law)
    if law.kinks:
        fragments.pieces(law)
    return [p.name for x, p in by_symbol.items() if x not in used]


def _check_kinks(law: Law, formula: Expr, by_symbol: Mapping[Symbol, Parameter]) -> None:
    """Check that minima and maxima are of polynomials of the slip and change branch at one parameter."""
    for function in sorted(formula.atoms(Min, Max), key=str):
        if [x.is_polynomial(SLIP) for x in function.args] != [True, True]:
            refuse(law, "coefficient", function, "min and max of two polynomials of the slip")
    for kink in law.kinks:
        if kink not in by_symbol:
            refuse(law, "coefficient", f"a branch that changes at a slip of {kink}", "at a parameter")
    if len(law.kinks) > 1:
        places = " and ".join(map(str, law.kinks))
        refuse(law, "coefficient", f"branches that change at {places}", "one slip: the order of two varies")


def _box(law: Law, by_symbol: Mapping[Symbol, Parameter]) -> dict[Symbol, domain.Ends]:
    """Return the ranges of a law's symbols within plausible numbers, where the first parameter of a unit is 1."""
    box = {x: (0.0, FARTHEST) for x in MOTION if str(x) in law.depends_on}
    first = {p.unit: p for p in reversed(law.parameters)}
    for x, p in by_symbol.items():
        box[x] = _range(p)
        if p.unit and p.lower >= 0.0:
            box[x] = (1.0, 1.0) if first[p.unit] is p else (0.01, 100.0)
    return box


def _range(p: Parameter) -> domain.Ends:
    """Return the plausible range of a parameter, (least, greatest), within its bounds."""
    least = 0.01 if p.lower == 0.0 else max(p.lower, -STEEPEST) + 1e-300  # above an open bound; 0 may be included
    return least, max(least, min(p.upper, STEEPEST))


def _check_effect(effect: Effect) -> Texts:
    """Check an effect and return the names of its unused parameters."""
    by_symbol = _check_parameters(effect, LIMITS)
    strange = {*effect.any_of} - {p.name for p in effect.parameters}
    if strange:
        refuse(effect, "any_of", strange, "names of its parameters")
    scales = SCALES | _units({p.name: p.unit for p in effect.parameters})
    used = set[Symbol]()
    for p in effect.symbols.values():
        what = f"parameter {p.name!r}, dimensionless"
        found = _check_formula(effect, what, p.dimensionless, scales | {VALUE: of_unit(p.unit)})
        if VALUE not in found:
            refuse(effect, what, p.dimensionless, "a formula of the value")
        used |= found
    used |= _check_terms(effect)
    if effect not in SECTION_EFFECTS:
        _check_values(effect, by_symbol)
    if not (used or effect.turns):
        refuse(effect, "terms", "none", "a term of the balance")
    fragments.effect_fragment(effect)
    # A parameter without symbol may describe how a function of time or rotation is made.
    of_functions = not {"series", "rotation"}.isdisjoint(p.kind for p in effect.parameters)
    return [p.name for x, p in by_symbol.items() if (p.symbol or not of_functions) and (p.symbol or x) not in used]


def _check_terms(effect: Effect) -> set[Symbol]:
    """Check the symbols in the terms of an effect, and return them."""
    units = BALANCE | dict.fromkeys(effect.states, NUMBER)
    units |= {x: LIKE_MOTION.get(p.dimensionless, NUMBER) for x, p in effect.symbols.items()}
    if effect in SECTION_EFFECTS:
        units |= OF_SECTIONS
    used = set[Symbol]()
    for quantity, term in effect.terms.items():
        used |= _check_formula(effect, quantity, term, units)
    if not used >= {*effect.states} or bool(effect.states) != (effect.growth != 0):
        refuse(effect, "states", effect.states, "symbols that its terms contain, and their growth")
    return used | _check_formula(effect, "growth", effect.growth, units | OF_GROWTH)


def _check_values(effect: Effect, by_symbol: Mapping[Symbol, Parameter]) -> None:
    """Check that resistance and friction are nowhere negative, that no term has a pole, and that states are bounded.

    ``by_symbol`` are the parameters by the symbols of their names.
    """
    box = {x: _range(p) for x, p in by_symbol.items()}
    formulas = dict(effect.terms)
    for x, p in effect.symbols.items():
        value = Symbol(p.name, real=True)
        box[x] = box[value]
        formulas[f"parameter {p.name!r}, dimensionless"] = p.dimensionless.subs(VALUE, value)
    box |= dict.fromkeys((*SCALES, *BALANCE), (0.01, STEEPEST))
    box |= dict.fromkeys((*MOTION, OMEGA, OMEGA_2, *OF_GROWTH, *effect.states), (0.0, STEEPEST))
    for what, e in formulas.items():
        fault, _ = domain.fault(e if what in NEVER_NEGATIVE else e**2 + 1, box)
        if fault:
            refuse(effect, what, fault, "finite numbers, of resistance and friction none below 0")
    for state in effect.states:
        fault, _ = domain.fault(-diff(effect.growth, state), box)
        if fault:
            refuse(effect, "growth", f"{effect.growth}, which rises with {state}", "a bounded state")
