"""The equation of motion of one scene, in plain symbols and in LaTeX, with the numbers of its coefficients.

Its terms come from `generated.flow.TERMS`, which is derived from the declarations of effects and laws; its numbers are
those that the integrator takes.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from generated.effects import ALL_EFFECTS, LAWS, Parameter
from generated.flow import BALANCE, COEFFICIENTS, EQUATION_QUANTITIES, LATEX, TERMS
from slipcircle.base.kinds import Names, Parameters
from slipcircle.core.problem.plan import Plan
from slipcircle.core.problem.problem import Problem, problem_of
from slipcircle.core.scene.effects import OF_SOIL, rotates, soil_number, without_soil
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
    value : float, ndarray or None
        Of a number; None of a term, and of what changes with time or the rotation.
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
    """

    balance: EquationTerm
    sums: tuple[EquationTerm, ...]
    numbers: tuple[EquationTerm, ...]

    @property
    def terms(self) -> tuple[EquationTerm, ...]:
        """Sums, then numbers."""
        return self.sums + self.numbers

    def __str__(self) -> str:
        used = {"omega", "s"}
        for term in self.sums:
            used.update(_symbols(term.formula))
        variables = [f"{name}: {words}" for name, words in VARIABLES.items() if name in used]
        last = "  " + "; ".join(variables)
        lines = [self._balance_in_words, *self._lines(), "with", *self._values(), last]
        return "\n".join(lines)

    @property
    def _balance_in_words(self) -> str:
        return f"{self.balance.symbol} = {self.balance.formula}"

    def _lines(self) -> Iterator[str]:
        """A line for each term; a quantity to which nothing adds is 0."""
        last = ""
        zero = set(EQUATION_QUANTITIES)
        for term in self.sums:
            symbol = term.symbol
            start = f"{symbol} =" if symbol != last else "+"
            yield f"  {start:>14} {term.formula:42} {term.effect}"
            last = symbol
            zero.discard(symbol)
        for name in sorted(zero):
            yield f"  {name:>12} = 0"

    def _values(self) -> Iterator[str]:
        """A line for each number."""
        for number in self.numbers:
            value = _shown(number.value)
            text = f"{number.symbol} = {value} {number.unit}"
            yield f"  {text.rstrip():34} {number.formula}"

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
        }


def equation_of(plan: Plan) -> Equation:
    """The equation of motion of a plan's scene."""
    recipe = plan.recipe
    of_effects = _terms_of_effects(recipe.effects, recipe.absent)
    of_friction = _terms_of_friction(recipe.laws)
    terms = _used(of_effects + of_friction)
    terms.sort(key=_place)
    left, right, latex, _ = BALANCE
    balance = EquationTerm(left, right, "balance", latex=latex)
    symbols = {*_symbols(left), *_symbols(right)}
    for term in terms:
        symbols.update(_symbols(term.formula))
    every_number = _numbers(plan.scene, problem_of(plan))
    numbers = [number for number in every_number if number.symbol in symbols]
    return Equation(balance, tuple(terms), tuple(numbers))


def _terms_of_effects(effects: Names, absent: Names) -> list[EquationTerm]:
    """What gravity and effects add, without those of absent parameters, and how the weight turns or does not."""
    terms = list[EquationTerm]()
    is_frozen = not rotates(effects)
    names = ("gravity", *effects, "frozen") if is_frozen else ("gravity", *effects)
    for name in names:
        number = soil_number(name)
        missing = {*absent} - {f"soil_turning{number}"}
        for quantity, formula, latex, symbols in TERMS[without_soil(name)]:
            of_soil = {symbol + number for symbol in symbols}
            if missing.isdisjoint(symbols) and missing.isdisjoint(of_soil):
                term = EquationTerm(quantity, formula, name, latex=latex)
                terms.append(_numbered(term, number))
        if number and not is_frozen:
            latex = r"- soil_{slope} \sin\varphi"
            turning = EquationTerm("soil_turning", "-soil_slope sin(phi)", name, latex=latex)
            terms.append(_numbered(turning, number))
    return terms


def _numbered(term: EquationTerm, number: str) -> EquationTerm:
    """A term of one soil, whose symbols end on its number: ``soil_mu_0``, ``peak_0``."""
    if not number:
        return term
    index = number.replace(OF_SOIL, "_")
    names = [r"soil_\w+"]
    law = LAWS.get(without_soil(term.effect))
    if law is not None:
        names += [p.name for p in law.parameters if p.kind == "number"]
    of_soil = "|".join(names)
    symbol = re.sub(rf"^({of_soil})$", rf"\1{index}", term.symbol)
    if term.value is not None:  # of a number the formula is what it is, in words
        return term._replace(symbol=symbol)
    formula = re.sub(rf"\b({of_soil})\b", rf"\1{index}", term.formula)
    number = index[1:]
    latex = re.sub(r"soil_\{(.+?)\}", rf"soil_{{\1,{number}}}", term.latex)
    latex = re.sub(r"\\mu_([pr0])", rf"\\mu_{{\1,{number}}}", latex)
    latex = re.sub(r"\b([LV])\b", rf"\1_{{{number}}}", latex)
    return term._replace(symbol=symbol, formula=formula, latex=latex)


def _terms_of_friction(laws: Names) -> list[EquationTerm]:
    """The friction coefficient of a law, or the product of a law of slip and one of speed."""
    terms = list[EquationTerm]()
    for law in laws:
        number = soil_number(law)
        if number:
            term = _term_of_law("soil_mu", law)
            terms.append(_numbered(term, number))
    shared = laws[len(terms) :]
    if terms and not shared:
        return terms
    if len(shared) == 1 and not terms:
        (law,) = shared
        return [_term_of_law("mu", law)]
    product = EquationTerm("mu", "mu_slip mu_rate", "friction", latex=r"\mu_{slip} \mu_{rate}")
    terms.append(product)
    rate_law = shared[-1]
    if len(shared) == 2:
        term = _term_of_law("mu_slip", shared[0])
        terms.append(term)
    term = _term_of_law("mu_rate", rate_law)
    if rate_law in LAWS:
        names = "|".join(p.name for p in LAWS[rate_law].parameters)
        formula = re.sub(rf"\b({names})\b", r"rate_\1", term.formula)
        term = term._replace(formula=formula)
    terms.append(term)
    return terms


def _term_of_law(symbol: str, law: str) -> EquationTerm:
    """A friction coefficient by a law."""
    (term,) = TERMS[without_soil(law)]
    _, formula, latex, _ = term
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
    order = [*EQUATION_QUANTITIES, "mu_slip", "mu_rate"]
    if term.symbol in order:
        return order.index(term.symbol)
    return len(order)


def _numbers(scene: Scene, problem: Problem) -> Iterator[EquationTerm]:
    """Every number that a formula may name, with its value."""
    for symbol, value in _of_the_arc(scene.arc).items():
        meaning = COEFFICIENTS[symbol]
        yield EquationTerm(symbol, meaning, "gravity", _per_lane(value, scene))
    for effect in problem.recipe.effects:
        number = soil_number(effect)
        for term in _numbers_of_effect(effect, scene, problem):
            yield _numbered(term, number)
    paths = law_paths(scene.friction)
    laws = law_parts(scene.friction)
    for path, (name, parameters) in zip(paths, laws, strict=True):
        law = LAWS.get(without_soil(name))
        if law is None:
            continue
        number = soil_number(name)
        prefix = "rate_" if path == "friction.rate" else ""
        for p in law.parameters:
            if p.kind == "number":
                symbol = prefix + p.name
                term = EquationTerm(symbol, p.help, name, parameters[p.name], p.unit)
                yield _numbered(term, number)


def _numbers_of_effect(effect: str, scene: Scene, problem: Problem) -> Iterator[EquationTerm]:
    """The numbers of an effect, and what it gives as functions of time or the rotation."""
    number = soil_number(effect)
    for p in ALL_EFFECTS[without_soil(effect)].parameters:
        symbol = p.symbol and p.symbol + number
        if symbol in problem.recipe.moving:
            argument = "the rotation" if p.kind == "rotation" else "time"
            meaning, _, _ = p.help.partition(",")
            yield EquationTerm(p.symbol, f"{meaning}, a function of {argument}", effect)
        elif symbol in problem.program.places:
            value = _per_lane(problem.start.get(symbol, 0.0), scene)
            yield EquationTerm(p.symbol, _definition(effect, p), effect, value)


def _definition(effect: str, p: Parameter) -> str:
    """How a number is made of the scene's, or what it is."""
    start = f"{p.symbol}* = "
    for formula in ALL_EFFECTS[without_soil(effect)].formulas:
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
    }


def _per_lane(value: Any, scene: Scene) -> Any:
    """A number of a single scene; an array of the scene's shape where it has one."""
    if not scene.shape:
        return float(np.ravel(value)[0])
    if np.ndim(value) == 1 and np.size(value) == np.prod(scene.shape):  # one a lane
        return np.reshape(value, scene.shape)
    return np.broadcast_to(value, scene.shape)


def _shown(value: Any) -> str:
    """A value to six digits; the range of an array."""
    if value is None:
        return "..."
    if np.ndim(value):
        least = np.min(value)
        greatest = np.max(value)
        return f"{least:.6g} to {greatest:.6g}"
    return f"{value:.6g}"


def _latex(symbol: str) -> str:
    """The LaTeX of a quantity's symbol."""
    if symbol == BALANCE[0]:
        return r"\Theta\,\frac{d\omega}{dt}"
    if symbol in EQUATION_QUANTITIES:
        return EQUATION_QUANTITIES[symbol][1]
    if symbol.startswith("soil_"):
        _, name, number = symbol.split("_")
        words = r"\mu" if name == "mu" else LATEX.get(name, name)
        return rf"soil_{{{words},{number}}}"
    if symbol.endswith("/dphi"):
        quantity = symbol.removeprefix("d").removesuffix("/dphi")
        return rf"\frac{{d {_latex(quantity)}}}{{d\varphi}}"
    if symbol in LATEX:
        return LATEX[symbol]
    name, underscore, index = symbol.partition("_")
    if name == "mu" and underscore:
        return rf"\mu_{{{index}}}"
    return symbol
