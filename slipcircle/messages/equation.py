"""Equation of motion of a scene, as text and in LaTeX, with the values of its coefficients.

The terms come from `generated.flow.TERMS`, which is derived from the declarations of effects and laws. The values are
the integrator's. With several soils along the slip surface the equation is a sum over soils (`SOIL_TERMS`).
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from generated.flow import BALANCE, EQUATION_QUANTITIES, LATEX, SOIL_BALANCE, SOIL_COEFFICIENTS, SOIL_QUANTITIES
from slipcircle.base.kinds import Names, ValueDict
from slipcircle.core.problem.plan import Plan
from slipcircle.core.problem.problem import problem_of
from slipcircle.core.scene.effects import rotates
from slipcircle.messages.terms import (
    EquationTerm,
    numbers_of,
    place,
    symbols_in,
    terms_of_cohesion,
    terms_of_effects,
    terms_of_friction,
    used,
)

VARIABLES = {
    "phi": "rotation since the start, rad",
    "omega": "angular velocity times sqrt(R/g)",
    "s": "its sign",
    "slip": "path travelled, m",
    "speed": "in m/s",
    "time": "in s",
    "excess": "pore pressure that heating adds, over sigma_ref",
    "mu_rate": "factor by which friction changes with the speed",
}


@dataclass(frozen=True)
class Equation:
    """Dimensionless equation of motion of a scene. Time is divided by sqrt(R/g), stress by the reference stress.

    Attributes
    ----------
    balance : EquationTerm
        The balance of momentum (3.11) with (2.20).
    sums : tuple of EquationTerm
        Terms of the quantities in the balance. With two friction laws the friction is their product.
    numbers : tuple of EquationTerm
        The coefficients.
    soils : tuple of str
        Names of the soils in the sum, empty for homogeneous ground.
    changing : tuple of str
        Symbols of soil coefficients that change with the rotation. Their values are those at the start.
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
        """Return the equation of motion with a legend of its symbols."""
        used = {"omega", "s"}
        for term in self.sums:
            used.update(symbols_in(term.formula))
        meanings = {name: words for name, (words, _) in self._quantities.items()}
        meanings |= {name: words for name, words in VARIABLES.items() if name in used}
        last = [f"  {name:8} {words}" for name, words in meanings.items()]
        return "\n".join([self._balance_in_words, *self._lines(), "with", *self._values(), "where", *last])

    @property
    def _balance_in_words(self) -> str:
        return f"{self.balance.symbol} = {self.balance.formula}"

    @property
    def _quantities(self) -> dict[str, tuple[str, str]]:
        """Meaning and LaTeX form of the quantities in the balance, by symbol."""
        if self.soils:
            return SOIL_QUANTITIES
        return EQUATION_QUANTITIES

    def _lines(self) -> Iterator[str]:
        """Yield a line of text for each term. A quantity without terms is 0."""
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
        """Yield a line of text for each number, with the numbers of the soils last."""
        of_soils = []
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
        """Equation in LaTeX, aligned, without numbers."""
        sums = {self.balance.symbol: [self.balance.latex]}
        for term in self.sums:
            sums.setdefault(term.symbol, []).append(term.latex)
        rows = []
        for symbol, addends in sums.items():
            right = " + ".join(addends).replace("+ - ", "- ")
            rows.append(f"{_latex(symbol)} &= {right}")
        body = " \\\\\n".join(rows)
        return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {self.latex}$"

    def to_dict(self) -> ValueDict:
        """Return the balance, its terms and numbers, the LaTeX form and the names of the soils for JSON."""
        keys = ("symbol", "formula", "effect", "value", "unit")
        return {
            "balance": self._balance_in_words,
            "terms": [{key: getattr(term, key) for key in keys} for term in self.terms],
            "latex": self.latex,
            "soils": self.soils,
        }


def equation_of(plan: Plan) -> Equation:
    """Return the equation of motion of a plan's scene, with the terms and numbers that occur in it."""
    arc: Any = plan.scene.arc
    soils = tuple(arc.arc_strength.distinct_soils) if "layered_strength" in plan.recipe.effects else ()
    every_number = [*numbers_of(plan, problem_of(plan), soils)]
    absent = {number.symbol for number in every_number if isinstance(number.value, tuple) and not np.any(number.value)}
    of_effects = terms_of_effects(plan, soils, absent)
    of_cohesion = [] if soils else terms_of_cohesion(plan.recipe.laws)
    of_laws = of_cohesion + terms_of_friction(plan.recipe.of_friction, "i" if soils else "")
    terms = used(of_effects + of_laws)
    terms.sort(key=place)
    left, right, latex = SOIL_BALANCE if soils else BALANCE
    balance = EquationTerm(left, right, "balance", latex=latex)
    symbols = {"sigma_ref", *symbols_in(left), *symbols_in(right)}
    for term in terms:
        symbols.update(symbols_in(term.formula))
    numbers = tuple(number for number in every_number if number.symbol in symbols)
    changing = _changing(plan, numbers) if soils else ()
    return Equation(balance, tuple(terms), numbers, tuple(soil.name for soil in soils), changing)


def _changing(plan: Plan, numbers: tuple[EquationTerm, ...]) -> Names:
    """Return the symbols of soil coefficients that change as the mass turns.

    ``numbers`` are the coefficients of the equation. With the strength of the base these are all sums along the
    surface.
    """
    arc: Any = plan.scene.arc
    if not rotates(plan.effects):
        return ()
    along = {*SOIL_COEFFICIENTS} - {"n_i"} if arc.strength == "base" else {"p_i"} if arc.level is not None else set()
    return tuple(number.symbol for number in numbers if number.symbol in along)


def _shown(value: Any, digits: int = 6) -> str:
    """Return a value rounded to significant digits, the range of an array, or "..." for None."""
    if value is None:
        return "..."
    ends = (f"{end:.{digits}g}" for end in (np.min(value), np.max(value)))
    return " to ".join(dict.fromkeys(ends))


def _latex(symbol: str) -> str:
    """Return the LaTeX form of the symbol of a quantity or a number, such as "J_theta0" or "mu_slip"."""
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
