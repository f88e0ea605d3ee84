"""Checks of declarations before the derivation, with one-line faults: names, symbols, units, domains and sources."""

import builtins
import keyword
import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import fields
from types import UnionType
from typing import Any, get_args, get_origin

import numpy as np
import sympy as sp

from derive.check.proof import ProofError
from derive.code import emit
from derive.declare import domain, quantities
from derive.declare import effects as declared
from derive.declare.effects import GRAVITY, RADIUS, SLIP, VALUE, Effect, Law, Parameter
from derive.declare.limits import LIMITS
from derive.declare.quantities import Moment
from derive.declare.units import Units, dimension, of_unit, shown
from derive.flow import fragments
from derive.flow.lowering import KNOWN
from derive.flow.recurrences import OPERATIONS
from derive.progress import say

Declaration = Effect | Law | Moment
# Equations of the paper, and its figure of laws of friction.
PAPER = re.compile(r"1\.([1-9]|1[0-4])|2\.([1-9]|1\d|2[0-7])|3\.([1-9]|1\d|2[01])|4\.[1-5]|Fig\. 4-1")
# Other tables and keys of scene files; functions of the package; modules of `generated`, and what else the text of a
# kernel names; keys of a law beside its parameters, and what else the text of these names.
TABLES = (
    "accuracy arc circle end_time_s format friction ground initial_velocity_m_s layers name note observed output pond "
    "search report slip soils surcharge tension_crack water"
)
FUNCTIONS = "backanalyse critical ensemble grid load parameters plan read_suite solve synthetic_records"
MODULES = "definitions effects flow generated kernels layout printed program series slopes tiers integrator"
ARGUMENTS = "resistance_factor limit_friction alpha theta_1 theta_2 out where accuracy"
KEYS = "law rate soils function value scales half_angle gravity radius density reference_stress cover strength_factor"
# Arguments of laws without formula.
TABLES_OF = (("slip", "m", "list"), ("speed", "m/s", "list"), ("time", "s", "list"))
UNITS_OF_LAWS = ("", "m", "m/s", "s")
NUMBERS = ("number", "series", "rotation")
KINDS = (*NUMBERS, "list", "text", "name", "flag", "fixed")
# Functions of series, beside powers and minima.
OF_SERIES: set[type] = {sp.tanh}  # made of exponentials
for _operation in OPERATIONS.values():
    for _meaning in _operation.means:
        OF_SERIES |= set(map(type, _meaning.atoms(sp.Function)))
NEVER_NEGATIVE = ("resistance", "mu")
FARTHEST = 1e6  # slip and speed, over the law's own
STEEPEST = 10.0  # coefficient


def _units(by_name: Mapping[str, str]) -> dict[sp.Symbol, sp.Expr]:
    return {sp.Symbol(name, real=True): of_unit(unit) for names, unit in by_name.items() for name in names.split()}


# Units of symbols in the formulas of laws, in those that make a parameter a number, and in the balance, where all are
# numbers but slip, speed, and what is made a number as these are.
NUMBER = of_unit("")
MOTION = _units({"slip": "m", "speed": "m/s"})
SCALES = _units(
    {
        "half_angle cover Theta strength_factor": "",
        "radius": "m",
        "gravity": "m/s^2",
        "density": "kg/m^3",
        "reference_stress": "Pa",
    }
)
LIKE_MOTION = {VALUE / RADIUS: of_unit("m"), VALUE / sp.sqrt(GRAVITY * RADIUS): of_unit("m/s")}
OF_WEIGHT = "Theta J_r J_theta lambda A driving_moment driving_moment_slope normal_load normal_load_slope"
BALANCE = MOTION | _units({OF_WEIGHT: "", "omega omega_2 k_h k_v": ""})
OF_SECTIONS = dict.fromkeys((*declared.BY_PSI, declared.SLIP_MU, declared.SOIL_MU, declared.COHESION_LAW), NUMBER)
OF_GROWTH = _units({"mu effective_stress": ""})


def check() -> int:
    """Check all declarations and return their number; the first fault is a `ProofError`."""
    laws = declared.LAWS
    effects = declared.ALL_EFFECTS
    moments = quantities.MOMENTS
    balance = fragments.fragments((), ())
    of_project = " ".join((FUNCTIONS, MODULES, ARGUMENTS))
    imported = re.findall(r"\w+", " ".join(emit.IMPORTS))
    words = {*of_project.split(), *imported, *dir(builtins), *dir(np)}
    for e in (*laws, *effects, *moments):
        _check_fields(e, e)
    _check_names((*laws, *effects), {*balance, "frozen", *TABLES.split()})
    _check_names(moments, words | {q.name for q in quantities.QUOTIENTS})
    symbols = {*SCALES, *BALANCE, *OF_GROWTH, VALUE} - {declared.K_H, declared.K_V}
    own = set(map(str, symbols))
    of_balance = re.findall(r"\w+", repr(balance))
    _check_cells(effects, own.union(of_balance))
    for law in laws:
        _check_law(law)
    for effect in effects:
        _check_effect(effect)
    by_weight: dict[sp.Expr, str] = {}
    for moment in moments:
        _ = moment.definition
        first = by_weight.setdefault(moment.weight, moment.name)
        if first != moment.name:
            raise ProofError(_claim(moment, "weight"), f"{moment.weight}, as of {first}", "another weight")
    return len((*laws, *effects, *moments))


def _claim(e: Declaration, what: str) -> str:
    return f"{type(e).__name__}({e.name!r}), {what}"


def _check_fields(e: Declaration, of: Declaration | Parameter, where: str = "") -> None:
    """Check that each field, including those of parameters, has its type, and that no text is blank."""
    for f in fields(of):
        value = getattr(of, f.name)
        blank = isinstance(value, str) and not value.strip() and (value or f.name in ("help", "symbol"))
        if blank or not _fits(value, f.type):
            kind = f.type.__name__ if isinstance(f.type, type) else str(f.type)
            wanted = re.sub(r"[a-z.]+\.(?=[A-Z])", "", kind)
            if blank:
                wanted = "words on what it is"
            raise ProofError(_claim(e, where + f.name), f"{value!r:.60}", wanted)
    for p in getattr(of, "parameters", ()):
        _check_fields(e, p, f"parameter {p.name!r}, ")


def _fits(value: object, kind: Any) -> bool:
    """Return whether a value has the type of a field. Expressions are checked later."""
    if get_origin(kind) is UnionType:
        return any(_fits(value, x) for x in get_args(kind))
    if get_origin(kind) is not tuple:
        return kind is sp.Expr or isinstance(value, int | float if kind is float else kind)
    if not isinstance(value, tuple):
        return False
    kinds = [*get_args(kind)]
    if kinds[1:] == [...]:
        kinds = kinds[:1] * len(value)
    return len(value) == len(kinds) and all(map(_fits, value, kinds))


def _check_names(entries: Sequence[Declaration], taken: set[str]) -> None:
    """Check that names are new and valid in Python and scene files, and that a source exists."""
    for e in entries:
        names = [e.name]
        if isinstance(e, Moment) and e.amplitude:
            names.append(e.kernel[0])
        for name in names:
            _check_name(_claim(e, "name"), name, taken)
            taken = taken | {name}
        if not e.equation:
            continue
        claim = _claim(e, "equation")
        if not PAPER.fullmatch(e.equation):
            raise ProofError(claim, repr(e.equation), "one of the paper, 1.1 to 4.5, or source= in its place")
        if e.source:
            raise ProofError(claim, f"{e.equation!r} beside source={e.source!r}", "one of them")


def _check_name(claim: str, name: str, taken: Collection[str]) -> None:
    if not re.fullmatch("[a-z][a-z0-9_]*", name):
        raise ProofError(claim, repr(name), "small letters, digits and _, a letter first")
    if keyword.iskeyword(name):
        raise ProofError(claim, f"{name!r}, a keyword of Python", "another name")
    if name in taken:
        raise ProofError(claim, f"{name!r}, what something else is called", "another name")


def _check_parameters(e: Law | Effect, units: Collection[str]) -> None:
    """Check names, kinds, bounds, units and keys."""
    taken = {*KEYS.split()}
    formula: tuple[str, ...] = NUMBERS
    if isinstance(e, Law):
        formula = KINDS if e.coefficient is None else ("number",)
    for p in e.parameters:
        claim = _claim(e, f"parameter {p.name!r}")
        _check_name(claim, p.name, taken)
        if p.kind not in KINDS and not re.fullmatch(r"[\w-]+(\|[\w-]+)+", p.kind):
            raise ProofError(f"{claim}, kind", repr(p.kind), f"{', '.join(KINDS)} or this|that")
        if p.kind not in formula and (p.symbol or isinstance(e, Law)):
            raise ProofError(f"{claim}, kind", repr(p.kind), f"one of {', '.join(formula)}, as it stands in a formula")
        if p.unit not in units:
            raise ProofError(f"{claim}, unit", repr(p.unit), f"one of {', '.join(map(repr, units))}")
        if not p.lower < p.upper:
            raise ProofError(f"{claim}, bounds", f"{p.lower} and {p.upper}", "a lower one below an upper one")
        _check_key(claim, p, taken)
        taken |= {p.name, p.key}


def _check_key(claim: str, p: Parameter, taken: Collection[str]) -> None:
    if not p.key:
        if not p.optional:
            raise ProofError(f"{claim}, key", "''", "a key for scene files, as it is not optional")
        return
    if p.kind == "rotation":
        raise ProofError(f"{claim}, key", repr(p.key), "none, as the section gives it")
    if not p.key.isidentifier() or not p.per_unit:
        allowed = f"letters, digits and _, at the end the unit {p.unit!r} with k, M or nothing before it"
        raise ProofError(f"{claim}, key", repr(p.key), allowed)
    if p.key in taken:
        raise ProofError(f"{claim}, key", f"{p.key!r}, what something else is called", "another key")


def _check_formula(claim: str, e: sp.Expr, units: Units) -> set[sp.Symbol]:
    """Check the functions and symbols of a formula that must be dimensionless, and return its symbols."""
    if not isinstance(e, sp.Expr) or e.has(sp.I, sp.nan, sp.oo, sp.zoo):
        raise ProofError(claim, repr(e), "an expression of SymPy in real numbers")
    for function in sorted(e.atoms(sp.Function), key=str):
        if type(function) not in OF_SERIES:
            raise ProofError(claim, function, KNOWN)
    found = dimension(e, units, claim)
    if found != 1:
        raise ProofError(claim, f"{e}, in {shown(found)}", "a number without a dimension")
    return e.free_symbols


def _check_used(e: Declaration, unused: Sequence[str]) -> None:
    if unused:
        raise ProofError(_claim(e, "parameters"), f"{', '.join(unused)} in no formula", "a use of each")


def _check_law(law: Law) -> None:
    _check_parameters(law, UNITS_OF_LAWS)
    claim = _claim(law, "coefficient")
    if law.coefficient is None:
        listed = [(p.name, p.unit, p.kind) for p in law.parameters]
        allowed = [[x, ("coefficient", "", "list")] for x in TABLES_OF]
        if listed not in allowed:
            raise ProofError(claim, "none", "a formula, or two lists: slip, speed or time, and coefficient")
        if not 0 <= law.degree <= declared.DEGREE:
            raise ProofError(_claim(law, "degree"), law.degree, f"0 to {declared.DEGREE}")
        return
    if law.degree:
        raise ProofError(_claim(law, "degree"), law.degree, "none, as it follows from the formula")
    by_symbol = _by_symbol(law)
    units = _units({p.name: p.unit for p in law.parameters})
    used = _check_formula(claim, law.coefficient, MOTION | units)
    unused = [p.name for x, p in by_symbol.items() if x not in used]
    _check_used(law, unused)
    if MOTION.keys() <= used:
        raise ProofError(claim, "slip and speed", "one: in a scene a law of speed multiplies one of slip")
    _check_branches(claim, law.coefficient)
    for kink in law.kinks:
        if kink not in by_symbol:
            raise ProofError(claim, f"a branch that changes at a slip of {kink}", "at a parameter")
    if len(law.kinks) > 1:
        places = " and ".join(map(str, law.kinks))
        raise ProofError(claim, f"branches that change at {places}", "one slip: the order of two varies among scenes")
    place, undecided = domain.fault(law.coefficient, _box(law))
    if place:
        raise ProofError(claim, place, "numbers that are not negative")
    if undecided:
        say(
            f"{claim}: not shown to be finite and not negative next to {undecided}; narrow the bounds of its parameters"
        )
    fragments.of_law(law)
    if law.kinks:
        fragments.pieces(law)


def _check_branches(claim: str, formula: sp.Expr) -> None:
    """Check that minima and maxima have two arguments, polynomials of the slip."""
    for function in sorted(formula.atoms(sp.Min, sp.Max), key=str):
        are_polynomials = [x.is_polynomial(SLIP) for x in function.args]
        if are_polynomials != [True, True]:
            raise ProofError(claim, function, "min and max of two polynomials of the slip")


def _by_symbol(e: Law | Effect) -> dict[sp.Symbol, Parameter]:
    """Return parameters by the symbols of their names."""
    return {sp.Symbol(p.name, real=True): p for p in e.parameters}


def _box(law: Law) -> dict[sp.Symbol, tuple[float, float]]:
    """Return the domain of a law within plausible numbers, where the first parameter of a unit is 1."""
    box = {x: (0.0, FARTHEST) for x in MOTION if str(x) in law.depends_on}
    first = {p.unit: p for p in reversed(law.parameters)}
    for x, p in _by_symbol(law).items():
        box[x] = _range(p)
        if p.unit and p.lower >= 0.0:
            box[x] = (1.0, 1.0) if first[p.unit] is p else (0.01, 100.0)
    return box


def _range(p: Parameter) -> tuple[float, float]:
    """Return the plausible range of a parameter."""
    least = max(p.lower, -STEEPEST) + 1e-300  # above an open bound; 0 may be included
    if p.lower == 0.0:
        least = 0.01
    most = min(p.upper, STEEPEST)
    return least, max(least, most)


def _check_effect(effect: Effect) -> None:
    _check_parameters(effect, LIMITS)
    strange = {*effect.any_of} - {p.name for p in effect.parameters}
    if strange:
        raise ProofError(_claim(effect, "any_of"), strange, "names of its parameters")
    values = _units({p.name: p.unit for p in effect.parameters})
    used = set[sp.Symbol]()
    for p in effect.symbols.values():
        claim = _claim(effect, f"parameter {p.name!r}, dimensionless")
        units = values | SCALES | {VALUE: of_unit(p.unit)}
        found = _check_formula(claim, p.dimensionless, units)
        if VALUE not in found:
            raise ProofError(claim, p.dimensionless, "a formula of the value")
        used |= found
    used |= _check_terms(effect)
    _check_values(effect)
    if not (used or effect.turns):
        raise ProofError(_claim(effect, "terms"), "none", "what it adds to the balance")
    of_functions = {"series", "rotation"} & {
        p.kind for p in effect.parameters
    }  # its other parameters say how it is made
    unused = []
    for x, p in _by_symbol(effect).items():
        makes_function = p.symbol is None and of_functions
        if not makes_function and (p.symbol or x) not in used:
            unused.append(p.name)
    _check_used(effect, unused)
    fragments.of_effect(effect)


def _check_terms(effect: Effect) -> set[sp.Symbol]:
    """Check the symbols in the terms of an effect."""
    units = BALANCE | dict.fromkeys(effect.states, NUMBER)
    for x, p in effect.symbols.items():
        units[x] = LIKE_MOTION.get(p.dimensionless, NUMBER)
    if effect in declared.SECTION_EFFECTS:
        units |= OF_SECTIONS
    used = set[sp.Symbol]()
    for quantity, term in effect.terms.items():
        used |= _check_formula(_claim(effect, quantity), term, units)
    if not used >= {*effect.states} or bool(effect.states) != (effect.growth != 0):
        raise ProofError(_claim(effect, "states"), effect.states, "some that stand in its terms, and their growth")
    return used | _check_formula(_claim(effect, "growth"), effect.growth, units | OF_GROWTH)


def _check_values(effect: Effect) -> None:
    """Check that resistance and friction are nowhere negative, that no term has a pole, and that states are bounded."""
    if effect in declared.SECTION_EFFECTS:
        return
    box = dict.fromkeys((*SCALES, *BALANCE), (0.01, STEEPEST))
    for x, p in _by_symbol(effect).items():
        box[x] = _range(p)
    box |= dict.fromkeys((*MOTION, declared.OMEGA, declared.OMEGA_2, *effect.states), (0.0, STEEPEST))
    formulas = dict(effect.terms)
    for x, p in effect.symbols.items():
        value = sp.Symbol(p.name, real=True)
        box[x] = box[value]
        formulas[f"parameter {p.name!r}, dimensionless"] = p.dimensionless.subs(VALUE, value)
    for what, e in formulas.items():
        of_sign = e if what in NEVER_NEGATIVE else e**2 + 1
        symbols = sorted(e.free_symbols, key=str)
        place, _ = domain.fault(of_sign, {x: box[x] for x in symbols})
        if place:
            raise ProofError(_claim(effect, what), place, "finite numbers, of resistance and friction none below 0")
    for state in effect.states:
        feedback = -sp.diff(effect.growth, state)
        of_growth = {x: box.get(x, (0.0, STEEPEST)) for x in sorted(feedback.free_symbols, key=str)}
        place, _ = domain.fault(feedback, of_growth)
        if place:
            raise ProofError(_claim(effect, "growth"), f"{effect.growth}, which rises with {state}", "a bounded state")


def _check_cells(effects: Sequence[Effect], taken: set[str]) -> None:
    """Check that a symbol denotes one number of a program, of a single effect and not of the balance."""
    for effect in effects:
        for x in (*effect.symbols, *effect.states):
            name = str(x)
            names = {name, f"{name}_0", f"d{name}"}
            right = sp.Symbol(name, real=True)
            if x != right or not name.isidentifier():
                raise ProofError(_claim(effect, "symbols"), sp.srepr(x), "sp.Symbol('name', real=True)")
            if x not in declared.BY_PSI and names & taken:
                raise ProofError(_claim(effect, "symbols"), x, "each for one quantity of one effect")
            taken |= names
