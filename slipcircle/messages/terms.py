"""Terms of the equation of motion of a scene, and the numbers in them."""

import re
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from generated.effects import COHESION_LAWS, EFFECTS, LAWS, Parameter
from generated.flow import COEFFICIENTS, EQUATION_QUANTITIES, SOIL_COEFFICIENTS, SOIL_TERMS, TERMS
from generated.program import OF_COHESION
from slipcircle.base.kinds import Names, Parameters, Texts
from slipcircle.core.problem.plan import Plan
from slipcircle.core.problem.problem import Problem
from slipcircle.core.scene.effects import rotates, soil_number, without_soil
from slipcircle.core.scene.friction import law_parts
from slipcircle.core.scene.mass import Mass
from slipcircle.core.scene.scene import Scene


class EquationTerm(NamedTuple):
    """Term of the equation of motion, or number in it.

    Attributes
    ----------
    symbol : str
        Symbol of the quantity that contains the term ("M", "sigma", "u", "mu", "T", "J_theta", ...), or of the number.
    formula : str
        Formula of the term, or meaning of the number.
    effect : str
        Origin of the term: "gravity", an effect, a friction law, or "frozen" geometry.
    value : float, ndarray, tuple or None
        Value of a number, or a tuple with one value per soil. None for terms and for functions of time or rotation.
    unit : str
        SI unit, "" if dimensionless.
    latex : str
    """

    symbol: str
    formula: str
    effect: str
    value: Any = None
    unit: str = ""
    latex: str = ""


def terms_of_effects(plan: Plan, soils: tuple[Any, ...], absent: set[str]) -> list[EquationTerm]:
    """Return the terms of gravity and effects, without terms of absent parameters, and the rotation of the weight.

    ``soils`` are the soils along the slip surface, empty for homogeneous ground, and ``absent`` are symbols of
    coefficients whose terms are omitted.
    """
    names = ["gravity", *plan.effects]
    if not rotates(plan.effects):
        names.append("frozen")
    if soils:
        names.append("soils")
    table = SOIL_TERMS if soils else TERMS
    missing = absent.union(plan.recipe.absent)
    terms = []
    for name in names:
        for quantity, formula, latex in table[name]:
            if missing.isdisjoint(symbols_in(formula)):
                terms.append(EquationTerm(quantity, formula, name, latex=latex))
    return terms


def _indexed(term: EquationTerm, index: str) -> EquationTerm:
    """Return a term with the index of a soil in its symbols, such as ``peak_1``, or ``i`` for a sum over soils.

    An empty index changes nothing.
    """
    if not index:
        return term
    effect = without_soil(term.effect)
    law = LAWS.get(effect)
    names = ["mu", "mu_slip"]
    names += [p.name for p in law.parameters if p.kind == "number" and (index != "i" or not p.unit)] if law else []
    any_name = "|".join(names)
    symbol = re.sub(rf"^({any_name})$", rf"\1_{index}", term.symbol)
    if term.value is not None:  # the formula of a number is its meaning in words
        return term._replace(symbol=symbol, effect=effect)
    formula = re.sub(rf"\b({any_name})\b(?!\()", rf"\1_{index}", term.formula)
    latex = re.sub(r"\\mu_([pr0])", rf"\\mu_{{\1,{index}}}", term.latex)
    if index != "i":
        latex = re.sub(r"\b([LV])\b", rf"\1_{{{index}}}", latex)
    return term._replace(symbol=symbol, formula=formula, effect=effect, latex=latex)


def terms_of_friction(laws: Names, index: str) -> list[EquationTerm]:
    """Return the terms of the friction coefficient, a law of slip or the product of laws of slip and speed.

    ``laws`` are their names, and ``index`` is "i" for a sum over soils and otherwise empty.
    """
    of_soils = [law for law in laws if soil_number(law)]
    shared = laws[len(of_soils) :]
    with_rate = len(shared) > (not of_soils)
    name = "mu_slip" if with_rate else "mu"
    slip = [_indexed(_term_of_law(name, law), f"{k}") for k, law in enumerate(of_soils, 1)]
    if not of_soils:
        slip = [_indexed(_term_of_law(name, shared[0]), index)]
    if not with_rate:
        return slip
    factor = _indexed(EquationTerm("mu", "mu_slip mu_rate", "friction", latex=r"\mu_{slip} \mu_{rate}"), index)
    rate_law = shared[-1]
    rate = _term_of_law("mu_rate", rate_law)
    names = "|".join(p.name for p in LAWS[rate_law].parameters)
    return [factor, *slip, rate._replace(formula=re.sub(rf"\b({names})\b", r"rate_\1", rate.formula))]


def terms_of_cohesion(laws: Names) -> list[EquationTerm]:
    """Return the moment of a cohesion that changes with slip, and its law.

    ``laws`` are the names of all laws of the scene.
    """
    names = [law for law in laws if law.endswith(OF_COHESION)]
    moment = EquationTerm("T", "lambda cohesion/sigma_ref", "cohesion", latex=r"\lambda \frac{c}{\sigma_{ref}}")
    terms = []
    for name in names:
        law = _term_of_law("cohesion", name)
        formula = re.sub(r"\b(peak|residual|length)\b", r"cohesion_\1", law.formula).replace("mu(", "cohesion(")
        latex = law.latex.replace(r"\mu", "c").replace("L", "L_c")
        terms += [moment, law._replace(formula=formula, effect=without_soil(name), latex=latex)]
    return terms


def _term_of_law(symbol: str, law: str) -> EquationTerm:
    """Return the equation of a coefficient, by its symbol, according to a law, by its name."""
    (term,) = TERMS[without_soil(law)]
    _, formula, latex = term
    return EquationTerm(symbol, formula, law, latex=latex)


def symbols_in(formula: str) -> Texts:
    """Return the symbols in a formula, with repetitions, in their order."""
    return re.findall(r"[A-Za-z_]\w*'?", formula)


def used(terms: list[EquationTerm]) -> list[EquationTerm]:
    """Return the terms without components of the weight (symbols J_...) that no other term contains."""
    taken = set()
    of_weight = set()
    for term in terms:
        if term.symbol.startswith("J_"):
            of_weight.add(term.symbol)
        else:
            taken.update(symbols_in(term.formula))
    unused = of_weight - taken
    return [term for term in terms if term.symbol not in unused]


def place(term: EquationTerm) -> int:
    """Return the position of a term in the equation, a sort key.

    Quantities of the balance precede factors of friction and other symbols.
    """
    order = [*EQUATION_QUANTITIES]
    if term.symbol.startswith(("mu_slip", "mu_rate")):
        return len(order)
    quantity, _, _ = term.symbol.partition("_")
    if quantity in order:
        return order.index(quantity)
    return len(order) + 1


def numbers_of(plan: Plan, problem: Problem, soils: tuple[Any, ...]) -> Iterator[EquationTerm]:
    """Yield every number that may occur in a formula, with its value.

    ``soils`` are the soils along the slip surface, empty for homogeneous ground.
    """
    scene = plan.scene
    of_arc = {symbol: _per_lane(value, scene) for symbol, value in _of_the_arc(scene.arc).items()}
    for symbol, value in of_arc.items():
        yield EquationTerm(symbol, COEFFICIENTS[symbol], "gravity", value)
    for symbol, values in _of_the_soils(scene, soils, of_arc).items():
        yield EquationTerm(symbol, SOIL_COEFFICIENTS[symbol], "soils", values)
    for effect in plan.effects:
        yield from _numbers_of_effect(effect, scene, problem)
    yield from _numbers_of_cohesion(scene)
    laws = law_parts(scene.friction)
    has_rate = isinstance(scene.friction, Mapping) and "rate" in scene.friction
    for k, (name, parameters) in enumerate(laws, 1):
        law = LAWS.get(without_soil(name))
        if law is None:
            continue
        is_rate = has_rate and k == len(laws)
        index = f"{k}" if soil_number(name) else "i" if soils and not is_rate else ""
        prefix = "rate_" if is_rate else ""
        for p in law.parameters:
            if p.kind == "number":
                value = parameters[p.name]
                if index == "i" and not p.unit:
                    value = tuple(soil.residual if p.name == "residual" else soil.peak for soil in soils)
                yield _indexed(EquationTerm(prefix + p.name, p.help, name, value, p.unit), index)


def _numbers_of_cohesion(scene: Scene) -> Iterator[EquationTerm]:
    """Yield the numbers in the law of a cohesion that changes with slip, with symbols such as "cohesion_peak"."""
    for name, parameters in scene.laws.items():
        if not name.endswith(OF_COHESION):
            continue
        law = without_soil(name)
        declared = COHESION_LAWS[law].parameters if law in COHESION_LAWS else ()
        for p in declared:
            if p.kind == "number":
                yield EquationTerm(f"cohesion_{p.name}", p.help, law, parameters[p.name], p.unit)


def _of_the_soils(scene: Scene, soils: tuple[Any, ...], of_arc: Parameters) -> dict[str, tuple[Any, ...]]:
    """Return the numbers in `SOIL_COEFFICIENTS` by symbol, each with one value per soil.

    ``of_arc`` contains the numbers of `_of_the_arc`.
    """
    if not soils:
        return {}
    arc: Any = scene.arc
    theta = of_arc["Theta"]
    by_soil = map(arc.arc_strength.of_soil, soils)
    added = [{name: _per_lane(value, scene) for name, value in of_soil.items()} for of_soil in by_soil]
    whole = sum(of_soil["angle"] for of_soil in added)
    rows = []
    for of_soil in added:
        share = of_soil["angle"] / whole
        resistance = of_arc["lambda"] * np.where(share > 0.0, share, np.inf)
        load = theta * of_soil["normal"]
        row = {"l_i": share, "J_r0i": load, "J_r0i'": theta * of_soil["normal_slope"], "n_i": load / of_arc["J_r0"]}
        for symbol, name in {"A_i": "inertia", "c_i": "cohesion", "p_i": "lift"}.items():
            row[symbol] = theta * of_soil[name] / resistance
        rows.append(row)
    return {symbol: tuple(row[symbol] for row in rows) for symbol in SOIL_COEFFICIENTS}


def _numbers_of_effect(effect: str, scene: Scene, problem: Problem) -> Iterator[EquationTerm]:
    """Yield the numbers of an effect, by its name, and its functions of time or rotation."""
    for p in EFFECTS[effect].parameters:
        if p.symbol in problem.recipe.moving:
            argument = "the rotation" if p.kind == "rotation" else "time"
            meaning, _, _ = p.help.partition(",")
            yield EquationTerm(p.symbol, f"{meaning}, a function of {argument}", effect)
        elif p.symbol in problem.program.places:
            value = _per_lane(problem.start.get(p.symbol, 0.0), scene)
            yield EquationTerm(p.symbol, _definition(effect, p), effect, value)


def _definition(effect: str, p: Parameter) -> str:
    """Return the formula of an effect's parameter ``p`` in terms of the scene, or its meaning in words."""
    start = f"{p.symbol}* = "
    for formula in EFFECTS[effect].formulas:
        if formula.startswith(start):
            return formula.removeprefix(start)
    meaning, _, _ = p.help.partition(",")
    return meaning


def _of_the_arc(arc: Mass) -> Parameters:
    """Return the numbers in `COEFFICIENTS` by symbol.

    All are dimensionless except for the reference stress in Pa. The integrator stores them divided by Theta.
    """
    coefficients = arc.moment_coefficients
    theta = arc.dimensionless.moment_of_inertia
    return {
        "Theta": theta,
        "lambda": coefficients.resistance_factor * theta,
        "A": coefficients.polar_moment / coefficients.resistance_factor,
        "J_theta0": coefficients.driving_moment * theta,
        "J_r0": coefficients.normal_load * theta,
        "J_theta0'": coefficients.driving_moment_slope * theta,
        "J_r0'": coefficients.normal_load_slope * theta,
        "sigma_ref": arc.reference_stress,
    }


def _per_lane(value: Any, scene: Scene) -> Any:
    """Return a float for a single scene, and otherwise an array of the scene's shape.

    ``value`` is a number or an array over lanes (cases of an ensemble).
    """
    if not scene.shape:
        return float(np.ravel(value)[0])
    if np.ndim(value) == 1 and np.size(value) == np.prod(scene.shape):  # one a lane
        return np.reshape(value, scene.shape)
    return np.broadcast_to(value, scene.shape)
