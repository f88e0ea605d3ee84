"""Faults of declarations, in one line each, before anything is derived: names, symbols, units, domains and sources."""

import builtins
import keyword
import re
from collections.abc import Callable, Collection, Mapping, Sequence

import numpy as np
import sympy as sp

from derive.build import FOLDER
from derive.check.proof import ProofError
from derive.declare import effects as declared
from derive.declare import quantities
from derive.declare.domain import Box, outside
from derive.declare.effects import Effect, Law, Parameter
from derive.declare.quantities import Moment
from derive.declare.units import ONE, dimension, of_unit, shown
from derive.flow import fragments

Declaration = Effect | Law | Moment
NAME = re.compile("[a-z][a-z0-9_]*")
# Of the paper: how many numbered equations its chapters have, and its figure of laws of friction.
EQUATIONS = {"1": 14, "2": 27, "3": 21, "4": 5}
FIGURE = "Fig. 4-1"
# Other tables and keys of scene files; keys of a law beside its parameters; the package's other functions.
TABLES = {"accuracy", "arc", "circle", "end_time_s", "friction", "ground", "initial_velocity_m_s", "layers", "name",
          "note", "pond", "search", "slip", "soils", "surcharge", "tension_crack", "water"}  # fmt: skip
KEYS = {"law", "rate", "soils", "function"}
FUNCTIONS = {"backanalyse", "critical", "ensemble", "grid", "load", "parameters", "plan", "read_suite", "solve",
             "synthetic_records"}  # fmt: skip
OF_KERNELS = {"alpha", "theta_1", "theta_2", "out", "where", "accuracy", "horner", "evaluate", "kernel", "generated"}
KINDS = ("number", "list", "series", "rotation", "text", "flag")
# Dimensions of the symbols in formulas: of laws, of what makes a parameter dimensionless, and of the balance. In the
# balance all are numbers, but slip, speed and the parameters that are made so by R and g as they are.
UNITS_OF_LAWS = ("", "m", "m/s", "s")
OF_LAWS = {declared.SLIP: of_unit("m"), declared.SPEED: of_unit("m/s")}
SCALES = {
    **dict.fromkeys((declared.ALPHA, declared.COVER, declared.THETA), ONE),
    declared.GRAVITY: of_unit("m/s^2"),
    declared.RADIUS: of_unit("m"),
    declared.DENSITY: of_unit("kg/m^3"),
    declared.REFERENCE: of_unit("Pa"),
}
NATURAL = {
    declared.VALUE / declared.RADIUS: of_unit("m"),
    declared.VALUE / sp.sqrt(declared.GRAVITY * declared.RADIUS): of_unit("m/s"),
}
OF_TERMS = {
    *(declared.THETA, declared.J_R, declared.J_THETA, declared.LAMBDA, declared.A, declared.OMEGA, declared.OMEGA_2),
    *(declared.DRIVING_MOMENT, declared.DRIVING_MOMENT_SLOPE, declared.NORMAL_LOAD, declared.NORMAL_LOAD_SLOPE),
    *(declared.K_H, declared.K_V, *OF_LAWS),
}
OF_SECTIONS = {*declared.BY_PSI, declared.SLIP_MU, declared.SOIL_MU}
OF_GROWTH = {declared.MU, declared.EFFECTIVE, declared.OMEGA}
FARTHEST = 1e6  # slip and speed, over the law's own
STEEPEST = 10.0  # coefficient


def check() -> int:
    """Raise `ProofError` at the first fault; how many declarations there are."""
    laws, effects, moments = declared.LAWS, declared.ALL_EFFECTS, quantities.MOMENTS
    own = fragments.fragments((), ()).keys() | {"frozen"}
    _names([*laws, *effects], own | TABLES)
    functions = {quantities.RESISTANCE.name, "limit_friction", *(q.name for q in quantities.QUOTIENTS)}
    functions |= {m.kernel[0] for m in moments if m.amplitude}
    modules = {path.stem for path in FOLDER.glob("*.py")}
    _names(moments, {*dir(builtins), *dir(np), *FUNCTIONS, *OF_KERNELS, *functions, *modules})
    for e in (*laws, *effects, *moments):
        _check_source(e)
    for law in laws:
        _check_law(law)
    for effect in effects:
        _check_effect(effect)
    _check_cells(effects)
    for moment in moments:
        _ = moment.definition
    return len(laws) + len(effects) + len(moments)


def _claim(of: Declaration, what: str) -> str:
    return f"{type(of).__name__}({of.name!r}), {what}"


def _names(entries: Sequence[Declaration], taken: Collection[str]) -> None:
    """Names are new, and may stand in Python, in scene files and in what is generated."""
    seen = set[str]()
    for e in entries:
        _check_name(_claim(e, "name"), e.name, taken)
        if e.name in seen:
            raise ProofError(_claim(e, "name"), "a declaration of this name before it", "a name of its own")
        seen.add(e.name)


def _check_name(claim: str, name: str, taken: Collection[str]) -> None:
    if not isinstance(name, str) or not NAME.fullmatch(name):
        raise ProofError(claim, repr(name), "small letters, digits and _, a letter first")
    if keyword.iskeyword(name):
        raise ProofError(claim, "a keyword of Python", "another name")
    if name in taken:
        raise ProofError(claim, "a name that something else has", "another name")


def _check_source(e: Declaration) -> None:
    """Help, and where it is from: an equation of the paper, or a source of one's own, or neither."""
    if not e.help.strip():
        raise ProofError(_claim(e, "help"), repr(e.help), "a line on what it is")
    chapter, _, number = e.equation.partition(".")
    known = number.isdecimal() and 1 <= int(number) <= EQUATIONS.get(chapter, 0)
    if e.equation and not known and e.equation != FIGURE:
        raise ProofError(_claim(e, "equation"), repr(e.equation), "an equation of the paper, or source= in its place")
    if e.equation and e.source:
        raise ProofError(_claim(e, "source"), repr(e.source), f"none beside equation {e.equation} of the paper")


def _check_parameters(e: Law | Effect, units: Collection[str]) -> None:
    """Names, kinds, bounds, units and keys."""
    for attribute in ("name", "key"):
        listed = [getattr(p, attribute) for p in e.parameters if getattr(p, attribute)]
        if twice := {x for x in listed if listed.count(x) > 1}:
            raise ProofError(_claim(e, f"parameter {attribute}"), f"{min(twice)!r} twice", "each once")
    taken = KEYS | {x.name for x in SCALES} | {"value", "scales"}
    for p in e.parameters:
        claim = _claim(e, f"parameter {p.name!r}")
        _check_name(claim, p.name, taken)
        if p.kind not in KINDS and "|" not in p.kind:
            raise ProofError(f"{claim}, kind", repr(p.kind), f"{', '.join(KINDS)} or this|that")
        if p.unit not in units:
            raise ProofError(f"{claim}, unit", repr(p.unit), f"one of {', '.join(map(repr, units))}")
        if not p.lower < p.upper:
            raise ProofError(f"{claim}, bounds", f"{p.lower} and {p.upper}", "a lower one below an upper one")
        if p.key and not p.key.endswith(tuple(p.keys)):
            raise ProofError(f"{claim}, key", repr(p.key), f"what ends in {' or '.join(p.keys)}")
        if p.key and not re.fullmatch("[A-Za-z][A-Za-z0-9_]*", p.key):
            raise ProofError(f"{claim}, key", repr(p.key), "letters, digits and _, a letter first")


def _check_symbols(claim: str, e: sp.Expr, known: Collection[sp.Symbol]) -> set[sp.Symbol]:
    """The symbols of a formula, all of them known."""
    if not isinstance(e, sp.Expr):
        raise ProofError(claim, repr(e), "an expression of SymPy")
    if unknown := e.free_symbols - set(known):
        first = min(unknown, key=str)
        wanted = "of " + ", ".join(sorted(map(str, known)))
        if str(first) in map(str, known):
            wanted = f"sp.Symbol({str(first)!r}, real=True)"
        raise ProofError(claim, f"the symbol {first}, which is not declared", wanted)
    return set(e.free_symbols)


def _check_law(law: Law) -> None:
    _check_parameters(law, UNITS_OF_LAWS)
    claim = _claim(law, "coefficient")
    if law.coefficient is None:
        kinds = [p.kind for p in law.parameters]
        if kinds != ["list"] * 2 or law.parameters[0].name not in ("slip", "speed", "time"):
            raise ProofError(claim, "none", "a formula, or two lists: of slip, speed or time, and of coefficients")
        return
    of = {sp.Symbol(p.name, real=True): p for p in law.parameters}
    used = _check_symbols(claim, law.coefficient, {*OF_LAWS, *of})
    _check_used(law, [p.name for x, p in of.items() if x not in used])
    if set(OF_LAWS) <= used:
        raise ProofError(claim, "slip and speed", "one of them: a law of speed multiplies one of slip in a scene")
    units = OF_LAWS | {x: of_unit(p.unit) for x, p in of.items()}
    _check_number(claim, law.coefficient, units)
    if strange := [x for x in law.kinks if x not in of]:
        raise ProofError(claim, f"a branch that changes at slip = {strange[0]}", "at slips that are parameters")
    _check_operations(claim, lambda: fragments.of_law(law))
    _check_domain(law, used, of)


def _check_used(e: Law | Effect, unused: Sequence[str]) -> None:
    if unused:
        claim = _claim(e, f"parameter {unused[0]!r}")
        raise ProofError(claim, "no formula that uses it", "a use, or no such parameter")


def _check_number(claim: str, e: sp.Expr, units: Mapping[sp.Symbol, sp.Expr]) -> None:
    if (found := dimension(e, units, claim)) != 1:
        raise ProofError(claim, f"{e}, in {shown(found)}", "a number without a dimension")


def _check_operations(claim: str, lower: Callable[[], object]) -> None:
    """Each function has an operation on series."""
    try:
        lower()
    except (ValueError, sp.PolynomialError) as error:
        known = "sums, products, powers, exp, log, sin and cos, and min and max of straight lines"
        raise ProofError(claim, error, known) from None


def _check_domain(law: Law, used: set[sp.Symbol], of: Mapping[sp.Symbol, Parameter]) -> None:
    """No pole, and neither negative nor complex numbers, at slips and speeds from 0 over those of the law."""
    box: Box = dict.fromkeys(used & set(OF_LAWS), (0.0, FARTHEST))
    scaled = set[str]()
    for x, p in of.items():
        low, high = (0.0 if p.lower > -1e-300 else max(p.lower, -STEEPEST)), min(p.upper, STEEPEST)
        if p.unit and p.lower >= 0.0:  # the first of a unit is 1
            low, high = (0.01, 100.0) if p.unit in scaled else (1.0, 1.0)
            scaled.add(p.unit)
        box[x] = (low, high)
    of_numbers = [x for x, p in of.items() if not p.unit]
    if place := outside(sp.collect(sp.expand(law.coefficient), of_numbers), box):
        raise ProofError(_claim(law, "coefficient"), place, "a number that is not negative on the whole domain")


def _check_effect(effect: Effect) -> None:
    _check_parameters(effect, declared.LIMITS)
    symbols = {p.symbol: p for p in effect.parameters if p.symbol is not None}
    by_name = {sp.Symbol(p.name, real=True): of_unit(p.unit) for p in effect.parameters}
    in_scales = set[sp.Symbol]()
    for p in symbols.values():
        claim = _claim(effect, f"parameter {p.name!r}, dimensionless")
        units = by_name | SCALES | {declared.VALUE: of_unit(p.unit)}
        in_scales |= _check_symbols(claim, p.dimensionless, units)
        _check_number(claim, p.dimensionless, units)
    of_terms = OF_TERMS | set(effect.states) | set(symbols)
    if effect in declared.SECTION_EFFECTS:
        of_terms |= OF_SECTIONS
    units = dict.fromkeys(of_terms | OF_GROWTH, ONE) | OF_LAWS
    units |= {x: NATURAL.get(p.dimensionless, ONE) for x, p in symbols.items()}
    used = set[sp.Symbol]()
    for quantity, term in (effect.terms | {"growth": effect.growth}).items():
        claim = _claim(effect, quantity)
        known = of_terms | OF_GROWTH if quantity == "growth" else of_terms
        used |= _check_symbols(claim, term, known)
        _check_number(claim, term, units)
    if not (used or effect.turns):
        raise ProofError(_claim(effect, "terms"), "none", "at least one term of the balance")
    _check_used(effect, [p.name for x, p in symbols.items() if x not in used])
    if not any(p.kind == "series" for p in effect.parameters):  # others say how such a function is made
        _check_used(effect, [p.name for x, p in zip(by_name, effect.parameters, strict=True)
                             if p.symbol is None and x not in in_scales])  # fmt: skip
    if strange := set(effect.any_of) - {p.name for p in effect.parameters}:
        raise ProofError(_claim(effect, "any_of"), min(strange), "names of its parameters")
    _check_operations(_claim(effect, "terms"), lambda: fragments.of_effect(effect))


def _check_cells(effects: Sequence[Effect]) -> None:
    """A symbol stands for one number of a program: of one effect, and of nothing in the balance."""
    taken = set[str]()
    for fragment in fragments.fragments((), ()).values():
        rows = (*fragment.scalar, *fragment.series)
        taken |= {name for row in rows for name in row if isinstance(name, str)}
    for effect in effects:
        for p in effect.parameters:
            if p.symbol is None or p.symbol in declared.BY_PSI:
                continue
            names = {str(p.symbol), f"{p.symbol}_0", f"d{p.symbol}"}
            if names & taken:
                raise ProofError(_claim(effect, f"symbol of {p.name!r}"), p.symbol, "one that no other quantity has")
            taken |= names
