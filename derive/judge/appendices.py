"""The paper's two appendices, repaired and proved by SymPy to be one line each.

Appendix I prints the integral J_r (2.23) and Appendix II what it calls J_theta (3.13). The print cannot be
parsed as it stands: brackets of arctanh are misplaced. Here the print is kept as it is, every repair is a
record of its own, and what the repaired text truly integrates is found by proof:

* :func:`parse` reads the repaired text, :func:`simplify` proves its one-line form and its integrand,
* :func:`numeric_check` compares print, one line and quadrature in complex arithmetic,
* :func:`undo_each_repair` shows that no repair can be spared,
* :func:`real_arithmetic_fails` says for which arcs the print gives NaN in real arithmetic.
"""

import re
import time
from dataclasses import dataclass, field, replace
from functools import lru_cache
from itertools import pairwise
from typing import Any

import mpmath as mp
import sympy as sp

from derive.declare.symbols import alpha, r, theta, theta_1, theta_2, theta_m, u

# --- the print -------------------------------------------------------------------------------------------
# Every round bracket is the print's own, the wrong ones included. {a}/{b} is a fraction bar, a^n a raised n,
# and a blank between factors is a product. As in any one-line formula, a/b c means (a/b) c.

PRINTED_I = """
-{1}/{2} (-sin(theta_1) sin(alpha) cos(theta_2)^2 + cos(theta_1) cos(alpha) cos(theta_2)^2 + cos(theta_1) sin(alpha)
sin(theta_2) cos(theta_2) + sin(theta_1) cos(alpha) sin(theta_2) cos(theta_2) - sin(alpha) cos(alpha)^2 sin(theta_1)
- 2 cos(alpha)^3 cos(theta_1)^2 cos(theta_2) + sin(alpha) cos(alpha)^2 sin(theta_2) + 2 cos(alpha)^4
arctanh(cos(theta_1) cos(alpha) - cos(theta_1) cos(alpha) cos(theta_2) - sin(theta_1) sin(alpha) + sin(theta_1)
sin(alpha) cos(theta_2) - sin(theta_1) cos(alpha) sin(theta_2) - cos(theta_1) sin(alpha) sin(theta_2))/sin(theta_2))
sin(theta_2) + 2 cos(alpha)^4 arctanh({-cos(theta_1) cos(alpha) + sin(theta_1) sin(alpha)
+ cos(alpha)}/{sin(theta_1)}) sin(theta_2) - sin(alpha) sin(theta_2) cos(theta_1)^2 - 2 cos(alpha)^3 cos(theta_1)
sin(theta_2) sin(theta_1) - 2 sin(alpha) cos(alpha)^2 cos(theta_1)^2 sin(theta_2) + 2 cos(alpha)^2
arctanh(cos(theta_1) cos(alpha) - cos(theta_1) cos(alpha) cos(theta_2) - sin(theta_1) sin(alpha) + sin(theta_1)
sin(alpha) cos(theta_2) - sin(theta_1) cos(alpha) sin(theta_2) - cos(theta_1) sin(alpha) sin(theta_2))/sin(theta_2)
cos(theta_1)^2 sin(theta_2) - 2 sin(alpha) cos(alpha)^3 arctanh(cos(theta_1) cos(alpha) - cos(theta_1) cos(alpha)
cos(theta_2) - sin(theta_1) sin(alpha) + sin(theta_1) sin(alpha) cos(theta_2) - sin(theta_1) cos(alpha) sin(theta_2)
- cos(theta_1) sin(alpha) sin(theta_2))/sin(theta_2) cos(theta_2) - 2 sin(alpha) cos(alpha)^3 arctanh({-cos(theta_1)
cos(alpha) + sin(theta_1) sin(alpha) + cos(alpha)}/{sin(theta_1)}) cos(theta_2) + 2 cos(alpha)^2
arctanh({-cos(theta_1) cos(alpha) + sin(theta_1) sin(alpha) + cos(alpha)}/{sin(theta_1)}) cos(theta_1)^2
sin(theta_2) - 4 cos(alpha)^4 arctanh({-cos(theta_1) cos(alpha) + sin(theta_1) sin(alpha)
+ cos(alpha)}/{sin(theta_1)}) cos(theta_1)^2 sin(theta_2) - 4 cos(alpha)^4 arctanh(cos(theta_1) cos(alpha)
- cos(theta_1) cos(alpha) cos(theta_2) - sin(theta_1) sin(alpha) + sin(theta_1) sin(alpha) cos(theta_2)
- sin(theta_1) cos(alpha) sin(theta_2) - cos(theta_1) sin(alpha) sin(theta_2))/sin(theta_2) cos(theta_1)^2
sin(theta_2) + sin(alpha) cos(theta_1) sin(theta_1) cos(theta_2) + cos(alpha)^3 cos(theta_1) - cos(alpha)
cos(theta_2) + cos(alpha)^3 cos(theta_2) + 4 sin(alpha) cos(alpha)^3 arctanh(cos(theta_1) cos(alpha) - cos(theta_1)
cos(alpha) cos(theta_2) - sin(theta_1) sin(alpha) + sin(theta_1) sin(alpha) cos(theta_2) - sin(theta_1) cos(alpha)
sin(theta_2) - cos(theta_1) sin(alpha) sin(theta_2))/sin(theta_2) cos(theta_1) sin(theta_2) sin(theta_1) + 4
sin(alpha) cos(alpha)^3 arctanh({-cos(theta_1) cos(alpha) + sin(theta_1) sin(alpha) + cos(alpha)}/{sin(theta_1)})
cos(theta_1)^2 cos(theta_2) + 4 sin(alpha) cos(alpha)^3 arctanh(cos(theta_1) cos(alpha) - cos(theta_1) cos(alpha)
cos(theta_2) - sin(theta_1) sin(alpha) + sin(theta_1) sin(alpha) cos(theta_2) - sin(theta_1) cos(alpha) sin(theta_2)
- cos(theta_1) sin(alpha) sin(theta_2))/sin(theta_2) cos(theta_2) cos(theta_1)^2 + 2 sin(alpha) cos(theta_1)
cos(alpha)^2 sin(theta_1) cos(theta_2) - 2 sin(theta_1) cos(alpha)^2 arctanh({-cos(theta_1) cos(alpha)
+ sin(theta_1) sin(alpha) + cos(alpha)}/{sin(theta_1)}) cos(theta_1) cos(theta_2) + 4 sin(theta_1) cos(alpha)^4
arctanh({-cos(theta_1) cos(alpha) + sin(theta_1) sin(alpha) + cos(alpha)}/{sin(theta_1)}) cos(theta_1) cos(theta_2)
- 2 sin(theta_1) cos(alpha)^2 arctanh(cos(theta_1) cos(alpha) - cos(theta_1) cos(alpha) cos(theta_2) - sin(theta_1)
sin(alpha) + sin(theta_1) sin(alpha) cos(theta_2) - sin(theta_1) cos(alpha) sin(theta_2) - cos(theta_1) sin(alpha)
sin(theta_2))/sin(theta_2)) cos(theta_1) cos(theta_2) + 4 sin(theta_1) cos(alpha)^4 arctanh(cos(theta_1) cos(alpha)
- cos(theta_1) cos(alpha) cos(theta_2) - sin(theta_1) sin(alpha) + sin(theta_1) sin(alpha) cos(theta_2)
- sin(theta_1) cos(alpha) sin(theta_2) - cos(theta_1) sin(alpha) sin(theta_2))/sin(theta_2)) cos(theta_1)
cos(theta_2) + 4 sin(theta_1) sin(alpha) cos(alpha)^3 arctanh({-cos(theta_1) cos(alpha) + sin(theta_1) sin(alpha)
+ cos(alpha)}/{sin(theta_1)}) cos(theta_1) sin(theta_2)/(-cos(theta_1) cos(alpha) cos(theta_2) + sin(theta_1)
sin(alpha) cos(theta_2) - cos(theta_1) sin(alpha) sin(theta_2) - sin(theta_1) cos(alpha) sin(theta_2))
"""

PRINTED_II = """
-{1}/{2} (-cos(theta_1) sin(alpha) - sin(theta_1) cos(alpha) + 2 sin(alpha) cos(alpha)^2 cos(theta_1) sin(theta_1)
sin(theta_2) - 4 sin(alpha) arctanh(cos(theta_1) cos(alpha) - cos(theta_1) cos(alpha) cos(theta_2) - sin(theta_1)
sin(alpha) + sin(theta_1) sin(alpha) cos(theta_2) - sin(theta_1) cos(alpha) sin(theta_2) - cos(theta_1) sin(alpha)
sin(theta_2)/sin(theta_2)) cos(alpha)^3 cos(theta_1) sin(theta_1) cos(theta_2) + 4 sin(alpha) arctanh({-cos(theta_1)
cos(alpha) + sin(theta_1) sin(alpha) + cos(alpha)}/{sin(theta_1)}) cos(alpha)^3 sin(theta_2) cos(theta_1)^2 + 4
arctanh(cos(theta_1) cos(alpha) - cos(theta_1) cos(alpha) cos(theta_2) - sin(theta_1) sin(alpha) + sin(theta_1)
sin(alpha) cos(theta_2) - sin(theta_1) cos(alpha) sin(theta_2) - cos(theta_1) sin(alpha) sin(theta_2)/sin(theta_2))
cos(alpha)^4 cos(theta_1) sin(theta_1) sin(theta_2) + 4 sin(theta_1) arctanh({-cos(theta_1) cos(alpha)
+ sin(theta_1) sin(alpha) + cos(alpha)}/{sin(theta_1)}) cos(alpha)^4 cos(theta_1) sin(theta_2) - 2 sin(theta_1)
arctanh({-cos(theta_1) cos(alpha) + sin(theta_1) sin(alpha) + cos(alpha)}/{sin(theta_1)}) cos(alpha)^2 cos(theta_1)
sin(theta_2) + 4 sin(alpha) arctanh(cos(theta_1) cos(alpha) - cos(theta_1) cos(alpha) cos(theta_2) - sin(theta_1)
sin(alpha) + sin(theta_1) sin(alpha) cos(theta_2) - sin(theta_1) cos(alpha) sin(theta_2) - cos(theta_1) sin(alpha)
sin(theta_2)/sin(theta_2)) cos(alpha)^3 cos(theta_1)^2 sin(theta_2) - 4 sin(alpha) arctanh({-cos(theta_1) cos(alpha)
+ sin(theta_1) sin(alpha) + cos(alpha)}/{sin(theta_1)}) cos(alpha)^3 cos(theta_1) sin(theta_1) cos(theta_2) - 2
sin(theta_1) arctanh(cos(theta_1) cos(alpha) - cos(theta_1) cos(alpha) cos(theta_2) - sin(theta_1) sin(alpha)
+ sin(theta_1) sin(alpha) cos(theta_2) - sin(theta_1) cos(alpha) sin(theta_2) - cos(theta_1) sin(alpha)
sin(theta_2)/sin(theta_2)) cos(alpha)^2 cos(theta_1) sin(theta_2) + sin(alpha) cos(theta_1)^2 cos(theta_2)
+ sin(alpha) cos(theta_1) cos(theta_2)^2 + 2 arctanh(cos(theta_1) cos(alpha) - cos(theta_1) cos(alpha) cos(theta_2)
- sin(theta_1) sin(alpha) + sin(theta_1) sin(alpha) cos(theta_2) - sin(theta_1) cos(alpha) sin(theta_2)
- cos(theta_1) sin(alpha) sin(theta_2)/sin(theta_2)) cos(alpha)^2 cos(theta_2) - 2 arctanh(cos(theta_1) cos(alpha)
- cos(theta_1) cos(alpha) cos(theta_2) - sin(theta_1) sin(alpha) + sin(theta_1) sin(alpha) cos(theta_2)
- sin(theta_1) cos(alpha) sin(theta_2) - cos(theta_1) sin(alpha) sin(theta_2)/sin(theta_2)) cos(alpha)^4
cos(theta_2) - sin(alpha) cos(alpha)^2 cos(theta_2) + 2 arctanh({-cos(theta_1) cos(alpha) + sin(theta_1) sin(alpha)
+ cos(alpha)}/{sin(theta_1)}) cos(alpha)^2 cos(theta_2) - 2 arctanh({-cos(theta_1) cos(alpha) + sin(theta_1)
sin(alpha) + cos(alpha)}/{sin(theta_1)}) cos(alpha)^4 cos(theta_2) - sin(alpha) cos(theta_1) cos(alpha)^2 - 2
cos(alpha)^3 sin(theta_2) cos(theta_1)^2 + cos(alpha) sin(theta_1) cos(theta_2)^2 + sin(theta_2) cos(alpha)
+ cos(alpha)^3 sin(theta_2) - cos(alpha)^3 sin(theta_1) - sin(alpha) cos(theta_2) - cos(alpha) sin(theta_2)
cos(theta_1) cos(theta_2) + 2 sin(theta_1) cos(theta_1) cos(alpha)^3 cos(theta_2) - 2 sin(alpha)
arctanh({-cos(theta_1) cos(alpha) + sin(theta_1) sin(alpha) + cos(alpha)}/{sin(theta_1)}) cos(alpha)^3 sin(theta_2)
+ 4 arctanh(cos(theta_1) cos(alpha) - cos(theta_1) cos(alpha) cos(theta_2) - sin(theta_1) sin(alpha) + sin(theta_1)
sin(alpha) cos(theta_2) - sin(theta_1) cos(alpha) sin(theta_2) - cos(theta_1) sin(alpha) sin(theta_2)/sin(theta_2))
cos(alpha)^4 cos(theta_2) cos(theta_1)^2 - 2 sin(alpha) arctanh(cos(theta_1) cos(alpha) - cos(theta_1) cos(alpha)
cos(theta_2) - sin(theta_1) sin(alpha) + sin(theta_1) sin(alpha) cos(theta_2) - sin(theta_1) cos(alpha) sin(theta_2)
- cos(theta_1) sin(alpha) sin(theta_2))/sin(theta_2)) cos(alpha)^3 sin(theta_2) + 4 cos(alpha)^4
arctanh({-cos(theta_1) cos(alpha) + sin(theta_1) sin(alpha) + cos(alpha)}/{sin(theta_1)}) cos(theta_1)^2
cos(theta_2) + 2 sin(alpha) cos(theta_1)^2 cos(alpha)^2 cos(theta_2) - 2 cos(theta_2) arctanh({-cos(theta_1)
cos(alpha) + sin(theta_1) sin(alpha) + cos(alpha)}/{sin(theta_1)}) cos(alpha)^2 cos(theta_1)^2 - 2 cos(theta_2)
arctanh(cos(theta_1) cos(alpha) - cos(theta_1) cos(alpha) cos(theta_2) - sin(theta_1) sin(alpha) + sin(theta_1)
sin(alpha) cos(theta_2) - sin(theta_1) cos(alpha) sin(theta_2) - cos(theta_1) sin(alpha) sin(theta_2))/sin(theta_2))
cos(alpha)^2 cos(theta_1)^2 + sin(alpha) cos(theta_1) sin(theta_1) sin(theta_2) + sin(theta_1) sin(alpha)
sin(theta_2) cos(theta_2)/(-cos(theta_1) cos(alpha) cos(theta_2) + sin(theta_1) sin(alpha) cos(theta_2)
- cos(theta_1) sin(alpha) sin(theta_2) - sin(theta_1) cos(alpha) sin(theta_2))
"""


# --- the repairs -----------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Repair:
    """One change to the print: occurrence number `occurrence` of the `of` places that read `printed`.

    `kind` is "bracket" where the print cannot be parsed at all without it, and "reading" where the print can
    be parsed but then is not the integral.
    """

    appendix: str
    kind: str
    printed: str
    occurrence: int
    of: int
    repaired: str
    why: str


# The numerator of the second arctanh argument; the print repeats it 8 times in Appendix I, 9 times in II.
_N = (
    "cos(theta_1) cos(alpha) - cos(theta_1) cos(alpha) cos(theta_2) - sin(theta_1) sin(alpha)"
    " + sin(theta_1) sin(alpha) cos(theta_2) - sin(theta_1) cos(alpha) sin(theta_2)"
    " - cos(theta_1) sin(alpha) sin(theta_2)"
)
_OUTSIDE, _OPENED = f"arctanh({_N})/sin(theta_2)", f"arctanh(({_N})/sin(theta_2)"
_LAST_TERM, _WHOLE = f"arctanh({_N}/sin(theta_2))", f"arctanh(({_N})/sin(theta_2))"
_SPARE = "a closing bracket is left over behind sin(theta_2): the one that opens before the numerator is missing"
_END = "the division by cos(alpha), written out, is that of the whole bracket, which is never closed"

REPAIRS = (
    *(Repair("I", "bracket", _OUTSIDE, k, 8, _OPENED, _SPARE) for k in (1, 7, 8)),
    *(
        Repair("I", "reading", _OUTSIDE, k, 8, _WHOLE, "sin(theta_2) divides the argument, not the arctanh")
        for k in (2, 3, 4, 5, 6)
    ),
    Repair("I", "bracket", "sin(theta_2)/(-cos(theta_1)", 1, 1, "sin(theta_2))/(-cos(theta_1)", _END),
    *(
        Repair("II", "reading", _LAST_TERM, k, 7, _WHOLE, "sin(theta_2) divides all six terms, not the last only")
        for k in (1, 2, 3, 4, 5, 6, 7)
    ),
    *(Repair("II", "bracket", _OUTSIDE, k, 2, _OPENED, _SPARE) for k in (1, 2)),
    Repair("II", "bracket", "cos(theta_2)/(-cos(theta_1)", 1, 1, "cos(theta_2))/(-cos(theta_1)", _END),
)


@dataclass(frozen=True)
class Appendix:
    """A printed expression, its repairs, and the integrand (in r and theta) that the paper claims for it."""

    name: str
    equation: str
    claim: sp.Expr
    printed: str = field(repr=False)
    repairs: tuple[Repair, ...] = field(repr=False)


APPENDIX_I, APPENDIX_II = APPENDICES = tuple(
    Appendix(name, equation, claim, printed, tuple(repair for repair in REPAIRS if repair.appendix == name))
    for name, equation, claim, printed in (
        ("I", "2.23", r * -sp.sin(theta), PRINTED_I),
        ("II", "3.13", r**2 * -sp.cos(theta), PRINTED_II),
    )
)


def repaired_text(appendix: Appendix) -> str:
    """Return the print on one line with every repair applied exactly where it was declared.

    Raises
    ------
    ValueError
        If the print does not have the declared number of such places, or two repairs overlap.
    """
    text = " ".join(appendix.printed.split())
    edits = []
    for repair in appendix.repairs:
        places = [match.span() for match in re.finditer(re.escape(repair.printed), text)]
        if len(places) != repair.of or not 1 <= repair.occurrence <= repair.of:
            raise ValueError(f"Appendix {appendix.name} has {len(places)} places, not {repair.of}: {repair.printed}")
        edits.append((*places[repair.occurrence - 1], repair.repaired))
    edits.sort()
    if any(later[0] < earlier[1] for earlier, later in pairwise(edits)):
        raise ValueError(f"repairs of Appendix {appendix.name} overlap")
    for start, end, new in reversed(edits):
        text = text[:start] + new + text[end:]
    return text


# --- reading ---------------------------------------------------------------------------------------------

_FUNCTIONS = {"sin": sp.sin, "cos": sp.cos, "arctanh": sp.atanh}
_NAMES = {"theta_1": theta_1, "theta_2": theta_2, "alpha": alpha}
_CLOSING = {")": "(", "}": "{"}


def parse(appendix: Appendix) -> sp.Expr:
    """Return the repaired print as an expression in theta_1, theta_2 and alpha.

    Raises
    ------
    ValueError
        If a bracket has no partner, or a character is not of the notation.
    """
    text = repaired_text(appendix)
    tokens = re.findall(r"[a-z]+(?:_\d)?|\d+|[-+/^(){}]", text)
    if "".join(tokens) != text.replace(" ", ""):
        raise ValueError(f"Appendix {appendix.name}: unknown notation")
    open_brackets: list[str] = []
    source: list[str] = []
    before = "("
    for token in tokens:
        if token in "({":
            open_brackets.append(token)
        elif token in _CLOSING and (not open_brackets or open_brackets.pop() != _CLOSING[token]):
            raise ValueError(f"Appendix {appendix.name}: '{token}' without partner after {' '.join(source[-12:])}")
        # Two neighbours that are both operands are a product.
        if before not in _FUNCTIONS and before not in "+-/^({" and token not in "+-/^)}":
            source.append("*")
        source.append({"{": "(", "}": ")", "^": "**"}.get(token, token))
        before = token
    if open_brackets:
        raise ValueError(f"Appendix {appendix.name}: {len(open_brackets)} brackets are never closed")
    return sp.parse_expr(" ".join(source), local_dict=_FUNCTIONS | _NAMES)


# --- proof -----------------------------------------------------------------------------------------------


class ProofError(ArithmeticError):
    """A step of the proof does not hold."""


@dataclass(frozen=True)
class Step:
    """One step of a proof: what was done, and the operations of the expression after it."""

    text: str
    operations: int


@dataclass(frozen=True)
class Proof:
    """What an appendix truly is: `expression` in (alpha, theta_m), the double integral of `integrand`."""

    expression: sp.Expr
    integrand: sp.Expr
    operations_before: int
    operations_after: int
    steps: tuple[Step, ...]
    seconds: float = field(compare=False)


_A1, _A2, _A = sp.symbols("A_1 A_2 A", real=True)  # the two arctanh of the print, and artanh(sin(alpha))
_SINE, _COSINE, _ARTANH = sp.sin(alpha), sp.cos(alpha), sp.atanh(sp.sin(alpha))
_GENERATORS = (_SINE, _COSINE, sp.sin(theta_m), sp.cos(theta_m), _A1, _A2, _A)
# The lexicographic leading terms, sin(.)^2, have no factor in common: this is a Groebner basis, so remainders
# are canonical and a trigonometric polynomial vanishes if and only if its remainder does.
_PYTHAGORAS = [sp.sin(x) ** 2 + sp.cos(x) ** 2 - 1 for x in (alpha, theta_m)]
_ENDS = {
    f(end): sp.expand_trig(f(angle))
    for f in (sp.sin, sp.cos)
    for end, angle in ((theta_1, theta_m - alpha), (theta_2, theta_m + alpha))
}


def _canonical(expr: sp.Expr) -> sp.Expr:
    """Write a trigonometric polynomial in alpha and theta_m, reduced modulo sin^2 + cos^2 = 1."""
    return sp.reduced(expr.xreplace(_ENDS), _PYTHAGORAS, *_GENERATORS, order="lex")[1]


def _vanishes(expr: sp.Expr) -> bool:
    """Decide whether a rational function of sines, cosines and artanh(sin(alpha)) is zero."""
    return _canonical(sp.fraction(sp.together(sp.expand_trig(expr.xreplace({_ARTANH: _A}))))[0]) == 0


def _require(holds: bool, claim: str) -> None:
    if not holds:
        raise ProofError(f"not proved: {claim}")


def _arguments(expr: sp.Expr) -> list[tuple[sp.Expr, sp.Expr, sp.Expr]]:
    """Return (arctanh, numerator, denominator) of the print's two arctanh, the one over sin(theta_1) first."""
    found = {sp.fraction(atom.args[0])[1]: atom for atom in expr.atoms(sp.atanh)}
    _require(set(found) == {sp.sin(theta_1), sp.sin(theta_2)}, "one arctanh over sin(theta_1), one over sin(theta_2)")
    _require(len(expr.atoms(sp.atanh)) == 2, "only two different arctanh occur")
    return [(atom, *sp.fraction(atom.args[0])) for atom in (found[sp.sin(theta_1)], found[sp.sin(theta_2)])]


def integrates(expression: sp.Expr, integrand: sp.Expr) -> bool:
    """Decide whether `expression` is the integral of r^n w(theta) over the segment, 0 < alpha < pi/2.

    With u = theta - theta_m, g(u, alpha) the inner integral from r = cos(alpha)/cos(u) to 1 (2.18), and
    J(alpha) the integral of g over |u| < alpha: g vanishes at u = -alpha and alpha, hence J' is the integral of
    dg/dalpha = sin(alpha) cos(alpha)^n k(u), and (J'/(sin(alpha) cos(alpha)^n))' = k(alpha) + k(-alpha). With
    J = 0 and J'/(sin(alpha) cos(alpha)^n) = 0 at alpha = 0 this determines J. So differentiation decides, and
    no antiderivative has to be found or trusted.

    Parameters
    ----------
    expression : sympy.Expr
        Candidate in alpha and theta_m.
    integrand : sympy.Expr
        A power of r times a sine or cosine of theta.
    """
    weight = sp.sin(alpha) * sp.cos(alpha) ** sp.degree(integrand, r)
    inner = sp.integrate(integrand.xreplace({theta: u + theta_m}), (r, sp.cos(alpha) / sp.cos(u), 1))
    kernel = sp.cancel(inner.diff(alpha) / weight)
    ends = (alpha, -alpha)
    _require(all(inner.subs(u, end) == 0 for end in ends), "the chord meets the circle at u = -alpha and alpha")
    _require(not kernel.has(alpha), "d/dalpha of the inner integral is a product f(alpha) k(u)")
    slope = sp.cancel(expression.diff(alpha).subs(_SINE**2, 1 - _COSINE**2) / weight)
    return (
        _vanishes(slope.diff(alpha) - sum(kernel.subs(u, end) for end in ends))
        and expression.subs(alpha, 0) == 0
        and sp.limit(slope, alpha, 0) == 0
    )


@lru_cache
def simplify(appendix: Appendix) -> Proof:
    """Prove the one-line form of an appendix and find the integrand whose double integral it is.

    Nothing about the result is typed in. Up to the logarithm's branch the steps are identities: the sum of the
    two arctanh is artanh(sin(alpha)) + k i pi with an integer k, and k = 0 is the real integral; the `branch` of
    :func:`numeric_check` is this k.

    Raises
    ------
    ProofError
        If a step does not hold.
    """
    start = time.perf_counter()
    expr = parse(appendix)
    steps = [Step("read the repaired print", sp.count_ops(expr))]

    def note(text: str) -> None:
        steps.append(Step(text, sp.count_ops(expr)))

    (first, n1, d1), (second, n2, d2) = _arguments(expr)
    numerator, denominator = sp.fraction(sp.together(expr.xreplace({first: _A1, second: _A2})))
    numerator, denominator = _canonical(numerator), _canonical(denominator)
    expr = numerator / denominator
    note(
        "put theta_1 = theta_m - alpha and theta_2 = theta_m + alpha, name the two arctanh A_1 and A_2,"
        " and reduce modulo sin^2 + cos^2 = 1"
    )

    polynomial = sp.Poly(numerator, _A1, _A2)
    _require(polynomial.total_degree() == 1, "the numerator is linear in the two arctanh")
    coefficient, other = (polynomial.coeff_monomial(a) for a in (_A1, _A2))
    _require(sp.expand(coefficient - other) == 0, "both arctanh have the same coefficient")
    rest = polynomial.coeff_monomial(1)
    expr = (rest + coefficient * (_A1 + _A2)) / denominator
    note("both arctanh have the same coefficient: collect A_1 + A_2")

    _require(_canonical(n1 * d2 + n2 * d1 - _SINE * (d1 * d2 + n1 * n2)) == 0, "tanh(A_1 + A_2) = sin(alpha)")
    expr = (rest + coefficient * _ARTANH) / denominator
    note("their arguments satisfy (X_1 + X_2)/(1 + X_1 X_2) = sin(alpha): A_1 + A_2 = artanh(sin(alpha))")

    expr = sp.cancel(expr)
    _require(sp.fraction(expr)[1].is_number, f"the denominator {denominator} cancels")
    note(f"cancel the denominator {denominator}")
    expr = sp.factor(expr)
    note("factor")

    weights = (-sp.sin(theta), -sp.cos(theta))
    proved = [f for f in (r**n * w for n in (1, 2, 3) for w in weights) if integrates(expr, f)]
    _require(len(proved) == 1, "the result is the integral of r^n (-sin(theta)) or r^n (-cos(theta)), n = 1, 2, 3")
    note(f"differentiated twice by alpha it is the double integral of {proved[0]}")
    return Proof(expr, proved[0], steps[0].operations, steps[-1].operations, tuple(steps), time.perf_counter() - start)


# --- numbers ---------------------------------------------------------------------------------------------

_GUARD = 15  # digits carried beyond those asked for


@dataclass(frozen=True)
class NumericCheck:
    """Three values of one integral, and `relative_difference`, the worst of them against the quadrature.

    The print is complex: its imaginary part is `branch` times pi times the coefficient of artanh(sin(alpha)) in
    the one-line form, and what is left of it after that counts as a difference.
    """

    printed: Any
    one_line: Any
    quadrature: Any
    branch: int
    relative_difference: Any


def evaluate(appendix: Appendix, start: Any, end: Any, digits: int = 50) -> Any:
    """Return the repaired print for the arc from `start` to `end` (radians) as an mpmath complex number."""
    function = sp.lambdify((theta_1, theta_2, alpha), parse(appendix), "mpmath")
    with mp.workdps(digits + _GUARD):
        start, end = mp.mpf(start), mp.mpf(end)
        return mp.mpc(function(start, end, (end - start) / 2))


def quadrature(integrand: sp.Expr, start: Any, end: Any, digits: int = 50) -> Any:
    """Integrate `integrand` over r from cos(alpha)/cos(theta - theta_1 - alpha) to 1 and theta over the arc.

    In r the two-point Gauss rule is exact up to r^3; in theta mpmath's tanh-sinh rule is used.
    """
    function = sp.lambdify((r, theta), integrand, "mpmath")
    with mp.workdps(digits + _GUARD):
        start, end = mp.mpf(start), mp.mpf(end)
        half = (end - start) / 2

        def inner(angle: Any) -> Any:
            chord = mp.cos(half) / mp.cos(angle - start - half)
            middle, width = (1 + chord) / 2, (1 - chord) / 2
            return width * sum(function(middle + sign * width / mp.sqrt(3), angle) for sign in (-1, 1))

        return mp.quad(inner, [start, start + half, end])


def numeric_check(appendix: Appendix, start: Any, end: Any, digits: int = 50) -> NumericCheck:
    """Compare the repaired print, its one-line form and quadrature of the raw double integral.

    Each arctanh is real on [-1, 1] and has the imaginary part +pi/2 or -pi/2 outside, the opposite sign for the
    opposite argument; both arguments leave [-1, 1] together (see :func:`real_arithmetic_fails`). Their product is
    -tan(theta_1/2) tan(theta_2/2). So the imaginary parts cancel (`branch` 0), unless the arc passes the level of
    its centre, theta_1 < pi < theta_2: there both arguments exceed 1 and mpmath's principal values leave -i pi
    (`branch` -1), which has to be discarded from the print.

    Parameters
    ----------
    appendix : Appendix
        What to check; the proof of :func:`simplify` supplies the one-line form and the integrand.
    start, end : float or mpmath.mpf
        Polar angles theta_1 and theta_2 in radians, 0 < theta_2 - theta_1 < pi.
    digits : int
        Digits to which the three should agree.
    """
    proof = simplify(appendix)
    printed = evaluate(appendix, start, end, digits)
    integral = quadrature(proof.integrand, start, end, digits)
    line = sp.lambdify((alpha, theta_m), (proof.expression, proof.expression.expand().coeff(_ARTANH)), "mpmath")
    pair = sp.lambdify((theta_1, theta_2, alpha), [atom for atom, *_ in _arguments(parse(appendix))], "mpmath")
    with mp.workdps(digits + _GUARD):
        start, end = mp.mpf(start), mp.mpf(end)
        half = (end - start) / 2
        one_line, coefficient = line(half, (start + end) / 2)
        branch = int(mp.nint(mp.im(sum(pair(start, end, half))) / mp.pi))
        expected = mp.mpc(integral, branch * mp.pi * coefficient)
        worst = max(abs(printed - expected), abs(one_line - integral)) / abs(integral)
    return NumericCheck(printed, one_line, integral, branch, worst)


def undo_each_repair(appendix: Appendix, start: Any, end: Any, digits: int = 20) -> list[tuple[Repair, Any]]:
    """Leave out one repair at a time; return it with the relative error that follows, or None if parsing fails.

    Only real parts are compared, so that the error is not that of a logarithm's branch.
    """
    integral = quadrature(simplify(appendix).integrand, start, end, digits)
    outcome: list[tuple[Repair, Any]] = []
    for repair in appendix.repairs:
        others = tuple(other for other in appendix.repairs if other is not repair)
        try:
            value = evaluate(replace(appendix, repairs=others), start, end, digits)
        except ValueError:
            outcome.append((repair, None))
        else:
            outcome.append((repair, abs(value.real - integral) / abs(integral)))
    return outcome


def real_arithmetic_fails(appendix: Appendix) -> sp.Rel:
    """Prove for which arcs the arctanh arguments leave (-1, 1), so that real arithmetic gives NaN.

    D^2 - N^2 = 2 cos(alpha) cos(theta_m) (1 - cos(theta_i)) for both arguments N/D, D = sin(theta_i): with
    0 < alpha < pi/2 both fail together, and exactly where cos(theta_m) <= 0, that is for every dip psi =
    3 pi/2 - theta_m from 0 to pi. (At equality the arguments are -1 and 1, and the sum is inf - inf.)

    Raises
    ------
    ProofError
        If the identity does not hold.
    """
    for (_, numerator, denominator), end in zip(_arguments(parse(appendix)), (theta_1, theta_2), strict=True):
        margin = denominator**2 - numerator**2 - 2 * _COSINE * sp.cos(theta_m) * (1 - sp.cos(end))
        _require(_canonical(margin) == 0, f"1 - X^2 has the sign of cos(theta_m) at {end}")
    return sp.Le(sp.cos(theta_m), 0)
