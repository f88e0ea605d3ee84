"""The equation of motion of one scene, in plain symbols and in LaTeX, with the numbers of its coefficients.

Its terms come from `generated.flow.TERMS`, which is derived from the declarations of effects and laws; its numbers are
those that the integrator takes. Where several soils lie along the slip surface, it is a sum over them (`SOIL_TERMS`).
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from generated.effects import EFFECTS, LAWS, Parameter
from generated.flow import (
    BALANCE,
    COEFFICIENTS,
    EQUATION_QUANTITIES,
    LATEX,
    SOIL_BALANCE,
    SOIL_COEFFICIENTS,
    SOIL_QUANTITIES,
    SOIL_TERMS,
    TERMS,
)
from slipcircle.base.kinds import Names, Parameters
from slipcircle.core.problem.plan import Plan
from slipcircle.core.problem.problem import Problem, problem_of
from slipcircle.core.scene.effects import rotates, soil_number, without_soil
from slipcircle.core.scene.friction import law_parts, law_paths
from slipcircle.core.scene.mass import Mass
from slipcircle.core.scene.scene import Scene

VARIABLES = {
    "phi": "rotation since the start, rad",
    "omega": "angular velocity times sqrt(R/g)",
    "s": "its sign",
    "slip": "path travelled, m",
    "speed": "in m/s",
    "time": "in s",
}


class EquationTerm(NamedTuple):
    """A term of the equation of motion, or a number in it.

    Attributes
    ----------
    symbol : str
        Of the quantity that the term belongs to ("M", "sigma", "u", "mu", "T", "J_theta", ...), or of the number.
    formula : str
        The term; of a number what it is.
    effect : str
        What asks for it: "gravity", an effect, a friction law, or "frozen" geometry.
    value : float, ndarray, tuple or None
        Of a number; of a number of each soil a tuple; None of a term, and of what changes with time or the rotation.
    unit : str
        SI; "" where dimensionless.
    latex : str
    """

    symbol: str
    formula: str
    effect: str
    value: Any = None
    unit: str = ""
    latex: str = ""


@dataclass(frozen=True)
class Equation:
    """The equation of motion of one scene, dimensionless: time over sqrt(R/g), stresses over the reference stress.

    Attributes
    ----------
    balance : EquationTerm
        The balance of momentum (3.11) with (2.20).
    sums : tuple of EquationTerm
        What its quantities are sums of (friction of two laws: a product).
    numbers : tuple of EquationTerm
        The coefficients.
    soils : tuple of str
        Names of the soils over which it sums; none where the ground is one soil.
    changing : tuple of str
        Symbols of those of their numbers that change with the rotation, and are given as they are at the start.
    """

    balance: EquationTerm
    sums: tuple[EquationTerm, ...]
    numbers: tuple[EquationTerm, ...]
    soils: Names = ()
    changing: Names = ()

    @property
    def terms(self) -> tuple[EquationTerm, ...]:
        """Sums, then numbers."""
        return self.sums + self.numbers

    def __str__(self) -> str:
        used = {"omega", "s"}
        for term in self.sums:
            used.update(_symbols(term.formula))
        meanings = {name: words for name, (words, _) in self._quantities.items()}
        meanings |= {name: words for name, words in VARIABLES.items() if name in used}
        last = [f"  {name:8} {words}" for name, words in meanings.items()]
        lines = [self._balance_in_words, *self._lines(), "with", *self._values(), "where", *last]
        return "\n".join(lines)

    @property
    def _balance_in_words(self) -> str:
        return f"{self.balance.symbol} = {self.balance.formula}"

    @property
    def _quantities(self) -> dict[str, tuple[str, str]]:
        return SOIL_QUANTITIES if self.soils else EQUATION_QUANTITIES

    def _lines(self) -> Iterator[str]:
        """A line for each term; a quantity to which nothing adds is 0."""
        last = ""
        zero = set(self._quantities)
        for term in self.sums:
            symbol = term.symbol
            start = f"{symbol} =" if symbol != last else "+"
            yield f"  {start:>14} {term.formula:42} {term.effect}"
            last = symbol
            zero.discard(symbol)
        for name in sorted(zero - {"mu_i"}):
            yield f"  {name:>12} = 0"

    def _values(self) -> Iterator[str]:
        """A line for each number, those of the soils last."""
        of_soils = list[tuple[str, str]]()
        for number in self.numbers:
            if isinstance(number.value, tuple):
                values = ", ".join(_shown(value, 4) for value in number.value)
                of_soils.append((f"{number.symbol} = {values}", number.formula))
            else:
                text = f"{number.symbol} = {_shown(number.value)} {number.unit}"
                yield f"  {text.rstrip():34} {number.formula}"
        if self.soils:
            soils = ", ".join(f"{k} {name}" for k, name in enumerate(self.soils, 1))
            yield f"and of the soils i = {soils}"
        width = max((34, *(len(text) for text, _ in of_soils)))
        for text, meaning in of_soils:
            yield f"  {text:{width}} {meaning}"
        if self.changing:
            symbols = ", ".join(self.changing)
            yield f"  at the start, as these change with the rotation: {symbols}"

    @property
    def latex(self) -> str:
        """The equation in LaTeX, aligned, without the numbers."""
        sums = {self.balance.symbol: [self.balance.latex]}
        for term in self.sums:
            addends = sums.setdefault(term.symbol, [])
            addends.append(term.latex)
        rows = list[str]()
        for symbol, addends in sums.items():
            left = _latex(symbol)
            right = " + ".join(addends)
            right = right.replace("+ - ", "- ")
            rows.append(f"{left} &= {right}")
        body = " \\\\\n".join(rows)
        return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {self.latex}$"

    def to_dict(self) -> dict[str, Any]:
        """For JSON: the balance, its terms and its numbers."""
        keys = ("symbol", "formula", "effect", "value", "unit")
        return {
            "balance": self._balance_in_words,
            "terms": [{key: getattr(term, key) for key in keys} for term in self.terms],
            "latex": self.latex,
            "soils": self.soils,
        }


def equation_of(plan: Plan) -> Equation:
    """The equation of motion of a plan's scene."""
    scene = plan.scene
    soils = _soils(scene) if "layered_strength" in plan.recipe.effects else ()
    every_number = [*_numbers(plan, problem_of(plan), soils)]
    absent = {number.symbol for number in every_number if isinstance(number.value, tuple) and not np.any(number.value)}
    of_effects = _terms_of_effects(plan, soils, absent)
    terms = _used(of_effects + _terms_of_friction(plan.recipe.laws, "i" if soils else ""))
    terms.sort(key=_place)
    left, right, latex = SOIL_BALANCE if soils else BALANCE
    balance = EquationTerm(left, right, "balance", latex=latex)
    symbols = {"sigma_ref", *_symbols(left), *_symbols(right)}
    for term in terms:
        symbols.update(_symbols(term.formula))
    numbers = tuple(number for number in every_number if number.symbol in symbols)
    changing = _changing(plan, numbers) if soils else ()
    return Equation(balance, tuple(terms), numbers, tuple(soil.name for soil in soils), changing)


def _soils(scene: Scene) -> tuple[Any, ...]:
    """The soils along the slip surface of a layered section."""
    arc: Any = scene.arc
    return tuple(arc.arc_strength.distinct_soils)


def _changing(plan: Plan, numbers: tuple[EquationTerm, ...]) -> Names:
    """Which numbers of the soils change as the mass turns: with strength of the base all that are sums along them."""
    arc: Any = plan.scene.arc
    if not rotates(plan.effects):
        return ()
    along = {*SOIL_COEFFICIENTS} - {"n_i"} if arc.strength == "base" else {"p_i"} if arc.level is not None else set()
    return tuple(number.symbol for number in numbers if number.symbol in along)


def _terms_of_effects(plan: Plan, soils: tuple[Any, ...], absent: set[str]) -> list[EquationTerm]:
    """What gravity and effects add, without those of absent parameters, and how the weight turns or does not."""
    names = ["gravity", *plan.effects]
    if not rotates(plan.effects):
        names.append("frozen")
    if soils:
        names.append("soils")
    table = SOIL_TERMS if soils else TERMS
    missing = absent.union(plan.recipe.absent)
    terms = list[EquationTerm]()
    for name in names:
        for quantity, formula, latex in table[name]:
            if missing.isdisjoint(_symbols(formula)):
                terms.append(EquationTerm(quantity, formula, name, latex=latex))
    return terms


def _indexed(term: EquationTerm, index: str) -> EquationTerm:
    """A term of one soil, whose symbols end on its number, ``peak_1``; of all soils on ``i``, with one length."""
    if not index:
        return term
    effect = without_soil(term.effect)
    law = LAWS.get(effect)
    names = ["mu", "mu_slip"]
    names += [p.name for p in law.parameters if p.kind == "number" and (index != "i" or not p.unit)] if law else []
    any_name = "|".join(names)
    symbol = re.sub(rf"^({any_name})$", rf"\1_{index}", term.symbol)
    if term.value is not None:  # of a number the formula is what it is, in words
        return term._replace(symbol=symbol, effect=effect)
    formula = re.sub(rf"\b({any_name})\b(?!\()", rf"\1_{index}", term.formula)
    latex = re.sub(r"\\mu_([pr0])", rf"\\mu_{{\1,{index}}}", term.latex)
    if index != "i":
        latex = re.sub(r"\b([LV])\b", rf"\1_{{{index}}}", latex)
    return term._replace(symbol=symbol, formula=formula, effect=effect, latex=latex)


def _terms_of_friction(laws: Names, index: str) -> list[EquationTerm]:
    """The friction coefficient of a law, or the product of a law of slip and one of speed; of soils with an index."""
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
    if rate_law in LAWS:
        names = "|".join(p.name for p in LAWS[rate_law].parameters)
        formula = re.sub(rf"\b({names})\b", r"rate_\1", rate.formula)
        rate = rate._replace(formula=formula)
    return [factor, *slip, rate]


def _term_of_law(symbol: str, law: str) -> EquationTerm:
    """A friction coefficient by a law."""
    (term,) = TERMS[without_soil(law)]
    _, formula, latex = term
    return EquationTerm(symbol, formula, law, latex=latex)


def _symbols(formula: str) -> list[str]:
    return re.findall(r"[A-Za-z_]\w*'?", formula)


def _used(terms: list[EquationTerm]) -> list[EquationTerm]:
    """Without components of the weight that no other term takes."""
    taken = set[str]()
    of_weight = set[str]()
    for term in terms:
        if term.symbol.startswith("J_"):
            of_weight.add(term.symbol)
        else:
            taken.update(_symbols(term.formula))
    unused = of_weight - taken
    return [term for term in terms if term.symbol not in unused]


def _place(term: EquationTerm) -> int:
    """Terms in the order of the quantities, then what they are made of."""
    order = [*EQUATION_QUANTITIES]
    if term.symbol.startswith(("mu_slip", "mu_rate")):
        return len(order)
    quantity, _, _ = term.symbol.partition("_")
    return order.index(quantity) if quantity in order else len(order) + 1


def _numbers(plan: Plan, problem: Problem, soils: tuple[Any, ...]) -> Iterator[EquationTerm]:
    """Every number that a formula may name, with its value."""
    scene = plan.scene
    of_arc = {symbol: _per_lane(value, scene) for symbol, value in _of_the_arc(scene.arc).items()}
    for symbol, value in of_arc.items():
        yield EquationTerm(symbol, COEFFICIENTS[symbol], "gravity", value)
    for symbol, values in _of_the_soils(scene, soils, of_arc).items():
        yield EquationTerm(symbol, SOIL_COEFFICIENTS[symbol], "soils", values)
    for effect in plan.effects:
        yield from _numbers_of_effect(effect, scene, problem)
    paths = law_paths(scene.friction)
    laws = law_parts(scene.friction)
    for k, (path, (name, parameters)) in enumerate(zip(paths, laws, strict=True), 1):
        law = LAWS.get(without_soil(name))
        if law is None:
            continue
        is_rate = path == "friction.rate"
        index = f"{k}" if soil_number(name) else "i" if soils and not is_rate else ""
        prefix = "rate_" if is_rate else ""
        for p in law.parameters:
            if p.kind == "number":
                value = parameters[p.name]
                if index == "i" and not p.unit:
                    value = tuple(soil.residual if p.name == "residual" else soil.peak for soil in soils)
                yield _indexed(EquationTerm(prefix + p.name, p.help, name, value, p.unit), index)


def _of_the_soils(scene: Scene, soils: tuple[Any, ...], of_arc: Parameters) -> dict[str, tuple[Any, ...]]:
    """The numbers in `SOIL_COEFFICIENTS`, each of every soil."""
    if not soils:
        return {}
    arc: Any = scene.arc
    theta = of_arc["Theta"]
    added = []
    for soil in soils:
        of_soil = arc.arc_strength.of_soil(soil)
        added.append({name: _per_lane(value, scene) for name, value in of_soil.items()})
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
    """The numbers of an effect, and what it gives as functions of time or the rotation."""
    for p in EFFECTS[effect].parameters:
        if p.symbol in problem.recipe.moving:
            argument = "the rotation" if p.kind == "rotation" else "time"
            meaning, _, _ = p.help.partition(",")
            yield EquationTerm(p.symbol, f"{meaning}, a function of {argument}", effect)
        elif p.symbol in problem.program.places:
            value = _per_lane(problem.start.get(p.symbol, 0.0), scene)
            yield EquationTerm(p.symbol, _definition(effect, p), effect, value)


def _definition(effect: str, p: Parameter) -> str:
    """How a number is made of the scene's, or what it is."""
    start = f"{p.symbol}* = "
    for formula in EFFECTS[effect].formulas:
        if formula.startswith(start):
            return formula.removeprefix(start)
    meaning, _, _ = p.help.partition(",")
    return meaning


def _of_the_arc(arc: Mass) -> Parameters:
    """The numbers in `COEFFICIENTS`, from what the integrator takes, whose coefficients are over Theta."""
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
    """A number of a single scene; an array of the scene's shape where it has one."""
    if not scene.shape:
        return float(np.ravel(value)[0])
    if np.ndim(value) == 1 and np.size(value) == np.prod(scene.shape):  # one a lane
        return np.reshape(value, scene.shape)
    return np.broadcast_to(value, scene.shape)


def _shown(value: Any, digits: int = 6) -> str:
    """A value to some digits; the range of an array."""
    if value is None:
        return "..."
    if np.ndim(value):
        least = np.min(value)
        greatest = np.max(value)
        return f"{least:.{digits}g} to {greatest:.{digits}g}"
    return f"{value:.{digits}g}"


def _latex(symbol: str) -> str:
    """The LaTeX of a quantity's symbol."""
    if symbol == BALANCE[0]:
        return r"\Theta\,\frac{d\omega}{dt}"
    quantities = EQUATION_QUANTITIES | SOIL_QUANTITIES
    if symbol in quantities:
        return quantities[symbol][1]
    if symbol.endswith("/dphi"):
        quantity = symbol.removeprefix("d").removesuffix("/dphi")
        return rf"\frac{{d {_latex(quantity)}}}{{d\varphi}}"
    if symbol in LATEX:
        return LATEX[symbol]
    name, underscore, index = symbol.partition("_")
    if name == "mu" and underscore:
        return rf"\mu_{{{index.replace('_', ',')}}}"
    return symbol
