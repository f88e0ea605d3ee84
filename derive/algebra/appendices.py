"""The paper's two appendices, parsed as printed, corrected, and reduced to one line each by cancellation alone.

Appendix I prints the integral J_r (2.23), Appendix II the integral that it calls J_theta (3.13). Apart from two arctanh
they are rational functions of sines and cosines, which the normal form reduces. The integrand of the result is found by
differentiation. No result is typed in or selected from a list.

Missing brackets are counted by one rule. A *place* is a difference between the corrected and the printed text, with the
number of brackets added there. Brackets are never removed. A place is *unreadable* if the brackets do not match when
this place alone is left as printed.
"""

import re
from dataclasses import dataclass, field
from functools import cache
from typing import NamedTuple

import sympy as sp
from sympy import Expr, Le, Rel, atanh, cos, count_ops, default_sort_key, parse_expr, pi, sin, symbols

from derive.algebra.prove import refute, trig_normal
from derive.check.proof import ProofError
from derive.declare.symbols import alpha, r, theta, theta_1, theta_2, theta_m

# --- the print -------------------------------------------------------------------------------------------
# All round brackets are printed, including wrong ones. {a}/{b} is a fraction bar, a^n a raised n, and a blank between
# factors a product. As usual in a formula on one line, a/b c means (a/b) c. The functions of one angle are abbreviated,
# and so are the arguments of the arctanh: the six terms N, without brackets, and the fraction M.

SHORT = {
    "N": "c1 ca - c1 ca c2 - s1 sa + s1 sa c2 - s1 ca s2 - c1 sa s2",
    "M": "{-c1 ca + s1 sa + ca}/{s1}",
    **{f"{f[0]}{x[-1]}": f"{f}(theta_{x})" for x in "12" for f in ("sin", "cos")},
    "sa": "sin(alpha)",
    "ca": "cos(alpha)",
}

PRINTED_I = """
-{1}/{2} (-s1 sa c2^2 + c1 ca c2^2 + c1 sa s2 c2 + s1 ca s2 c2 - sa ca^2 s1 - 2 ca^3 c1^2 c2 + sa ca^2 s2 + 2 ca^4
arctanh(N)/s2) s2 + 2 ca^4 arctanh(M) s2 - sa s2 c1^2 - 2 ca^3 c1 s2 s1 - 2 sa ca^2 c1^2 s2 + 2 ca^2 arctanh(N)/s2
c1^2 s2 - 2 sa ca^3 arctanh(N)/s2 c2 - 2 sa ca^3 arctanh(M) c2 + 2 ca^2 arctanh(M) c1^2 s2 - 4 ca^4 arctanh(M) c1^2 s2
- 4 ca^4 arctanh(N)/s2 c1^2 s2 + sa c1 s1 c2 + ca^3 c1 - ca c2 + ca^3 c2 + 4 sa ca^3 arctanh(N)/s2 c1 s2 s1 + 4 sa
ca^3 arctanh(M) c1^2 c2 + 4 sa ca^3 arctanh(N)/s2 c2 c1^2 + 2 sa c1 ca^2 s1 c2 - 2 s1 ca^2 arctanh(M) c1 c2 + 4 s1
ca^4 arctanh(M) c1 c2 - 2 s1 ca^2 arctanh(N)/s2) c1 c2 + 4 s1 ca^4 arctanh(N)/s2) c1 c2 + 4 s1 sa ca^3 arctanh(M) c1
s2/(-c1 ca c2 + s1 sa c2 - c1 sa s2 - s1 ca s2)
"""

PRINTED_II = """
-{1}/{2} (-c1 sa - s1 ca + 2 sa ca^2 c1 s1 s2 - 4 sa arctanh(N/s2) ca^3 c1 s1 c2 + 4 sa arctanh(M) ca^3 s2 c1^2 + 4
arctanh(N/s2) ca^4 c1 s1 s2 + 4 s1 arctanh(M) ca^4 c1 s2 - 2 s1 arctanh(M) ca^2 c1 s2 + 4 sa arctanh(N/s2) ca^3 c1^2
s2 - 4 sa arctanh(M) ca^3 c1 s1 c2 - 2 s1 arctanh(N/s2) ca^2 c1 s2 + sa c1^2 c2 + sa c1 c2^2 + 2 arctanh(N/s2) ca^2 c2
- 2 arctanh(N/s2) ca^4 c2 - sa ca^2 c2 + 2 arctanh(M) ca^2 c2 - 2 arctanh(M) ca^4 c2 - sa c1 ca^2 - 2 ca^3 s2 c1^2 +
ca s1 c2^2 + s2 ca + ca^3 s2 - ca^3 s1 - sa c2 - ca s2 c1 c2 + 2 s1 c1 ca^3 c2 - 2 sa arctanh(M) ca^3 s2 + 4
arctanh(N/s2) ca^4 c2 c1^2 - 2 sa arctanh(N)/s2) ca^3 s2 + 4 ca^4 arctanh(M) c1^2 c2 + 2 sa c1^2 ca^2 c2 - 2 c2
arctanh(M) ca^2 c1^2 - 2 c2 arctanh(N)/s2) ca^2 c1^2 + sa c1 s1 s2 + s1 sa s2 c2/(-c1 ca c2 + s1 sa c2 - c1 sa s2 - s1
ca s2)
"""


@dataclass(frozen=True)
class Appendix:
    """Printed expression on one line."""

    name: str
    printed: str = field(repr=False)


APPENDIX_I, APPENDIX_II = APPENDICES = tuple(
    Appendix(name, " ".join(text.split())) for name, text in (("I", PRINTED_I), ("II", PRINTED_II))
)


# Printed text and its correction: sin(theta_2) divides all six terms, and arctanh applies to the quotient. The final
# denominator, cos(alpha) written out, divides the whole expression that begins with the first bracket.
MENDING = ((r"arctanh\(N\)?/s2\)?", "arctanh((N)/s2)"), (r"(?<!\))(?=/\(-c1 ca c2)", ")"))


class Repair(NamedTuple):
    """Correction of the printed text: its span on one line, the corrected text, and the number of added brackets."""

    start: int
    end: int
    mended: str
    brackets: int


def repairs(appendix: Appendix) -> tuple[Repair, ...]:
    """Return all places where the printed text must be corrected, in order."""
    places = []
    for pattern, mended in MENDING:
        for match in re.finditer(pattern, appendix.printed):
            printed = match.group()
            if printed != mended:
                places.append(Repair(*match.span(), mended, len(mended) - len(printed)))
    return tuple(sorted(places))


def mended_text(appendix: Appendix, leave: tuple[Repair, ...] = ()) -> str:
    """Return the printed text of an appendix, corrected except at the places in ``leave``."""
    text = appendix.printed
    for repair in reversed(repairs(appendix)):
        if repair not in leave:
            text = text[: repair.start] + repair.mended + text[repair.end :]
    return text


@cache
def parse(appendix: Appendix, leave: tuple[Repair, ...] = ()) -> Expr:
    """Return the corrected text as an expression in theta_1, theta_2 and alpha, or raise ValueError.

    The places in ``leave`` are not corrected.
    """
    text = mended_text(appendix, leave)
    if unknown := set(re.sub(r"arctanh|[a-zA-Z][12a]|[MN]", "", text)) - set("0123456789 +-/^(){}"):
        raise ValueError(f"Appendix {appendix.name}: unknown notation {unknown}")
    for short, full in SHORT.items():
        text = re.sub(rf"\b{short}\b", full, text)
    brackets = re.sub("[^(){}]", "", text)
    for _ in brackets:
        brackets = brackets.replace("()", "").replace("{}", "")
    if brackets:
        raise ValueError(f"Appendix {appendix.name}: brackets without partner: {brackets}")
    text = re.sub(r"(?<=[\w)}]) (?=[\w({])", "*", text)  # two adjacent operands are a product
    names = {"theta_1": theta_1, "theta_2": theta_2, "alpha": alpha, "arctanh": atanh}
    return parse_expr(text.translate(str.maketrans("{}", "()")).replace("^", "**"), local_dict=names)


def unreadable(appendix: Appendix, repair: Repair) -> bool:
    """Return whether brackets do not match if the place ``repair`` alone is left as printed."""
    try:
        parse(appendix, (repair,))
    except ValueError:
        return True
    return False


_A1, _A2 = symbols("A_1 A_2", real=True)  # the two arctanh of the printed text
_ENDS = {theta_1: theta_m - alpha, theta_2: theta_m + alpha}


def _require(holds: bool, claim: str) -> None:
    """Raise `ProofError` with the claim if it does not hold."""
    if not holds:
        raise ProofError(claim, holds, True)


class ReductionStep(NamedTuple):
    """Step of a reduction: description, proof, and resulting expression."""

    text: str
    proof: str
    expression: Expr

    @property
    def operations(self) -> int:
        """Number of operations of the expression."""
        return int(count_ops(self.expression))


class Proof(NamedTuple):
    """Reduction of an appendix to `expression` in (alpha, theta_m), the double integral of `integrand`."""

    expression: Expr
    integrand: Expr
    steps: tuple[ReductionStep, ...]


def integrand(expression: Expr) -> Expr:
    """Return the r^n w(theta) whose double integral over the segment is the expression in alpha and theta_m.

    Let g(u, alpha) be the integral of r^n w(theta_m + u) over r from cos(alpha)/cos(u) to 1 (2.18), and J the integral
    of g over |u| < alpha. As g vanishes at both ends, J'/(sin(alpha) cos(alpha)^n) is the integral of
    w(theta_m + u)/cos(u)^(n+1).
    Differentiated once more, K = J'/sin(alpha) obeys K' + n K tan(alpha) = [w(theta_m + alpha) + w(theta_m - alpha)]
    / cos(alpha), which is 2 w(theta_m) for w = p sin + q cos. Hence n = -K''/(K tan(alpha))', and half the left side is
    w. Together with J = K = 0 at alpha = 0 this determines J.
    """
    derivative = expression.diff(alpha) / sin(alpha)
    k = trig_normal(derivative)
    leaning = k * sin(alpha) / cos(alpha)
    ratio = -k.diff(alpha, 2) / leaning.diff(alpha)
    refute(sin(pi * ratio, evaluate=False), "it integrates a power of r")  # its normal form may take seconds
    n = trig_normal(ratio)
    _require(n.is_Integer, f"it integrates a power of r: n = {n}")
    w = trig_normal((k.diff(alpha) + n * leaning) / 2)
    _require(not w.has(alpha), f"the remaining factor depends on theta_m alone: {w}")
    _require(trig_normal(w.diff(theta_m, 2) + w) == 0, f"a sine and a cosine of theta: {w}")
    _require(expression.subs(alpha, 0) == k.subs(alpha, 0) == 0, "both vanish at alpha = 0")
    return r**n * w.subs(theta_m, theta)


@cache
def simplify(appendix: Appendix) -> Proof:
    """Return the reduction of an appendix to one line, step by step.

    Up to the branch of the logarithm the steps are identities. The sum of the two arctanh is the artanh of
    (X_1 + X_2)/(1 + X_1 X_2) plus k i pi with an integer k, and k = 0 is the real integral.
    """
    printed = parse(appendix)
    artanhs = sorted(printed.atoms(atanh), key=default_sort_key)
    _require(len(artanhs) == 2, f"two different arctanh occur, not {len(artanhs)}")
    form = printed.xreplace(dict(zip(artanhs, (_A1, _A2), strict=True))).subs(_ENDS)
    first, second = (x.args[0].subs(_ENDS) for x in artanhs)
    total = atanh(trig_normal((first + second) / (1 + first * second)))
    factor, other = (trig_normal(form.diff(x)) for x in (_A1, _A2))
    _require(factor == other and not factor.has(_A1, _A2), "both arctanh have the same factor")
    rest = sp.factor(trig_normal(form.xreplace({_A1: 0, _A2: 0})))
    line = sp.factor(factor * total + rest)
    of = integrand(line)
    return Proof(
        line,
        of,
        (
            ReductionStep("read the mended print", "every bracket has its partner", printed),
            ReductionStep(
                f"the two arctanh together are {total}", f"(X_1 + X_2)/(1 + X_1 X_2) cancels to {total.args[0]}", total
            ),
            ReductionStep(
                f"both have the factor {factor}", "the derivatives by both cancel to one form, free of both", factor
            ),
            ReductionStep(f"without them {rest} is left", "cancels to it", rest),
            ReductionStep("together, factored", "the form is linear in the two arctanh", line),
            ReductionStep(f"it is the double integral of {of}", "found by differentiating it twice by alpha", line),
        ),
    )


def real_arithmetic_fails(appendix: Appendix) -> Rel:
    """Return the proved condition under which the arctanh arguments leave (-1, 1), so that real arithmetic gives NaN.

    1 - X^2 equals 2 cos(alpha) cos(theta_m)/(1 + cos(theta_1)) for one argument X, and the same with theta_2 for the
    other. For 0 < alpha < pi/2 both therefore fail together if and only if cos(theta_m) <= 0, that is for every dip
    psi = 3 pi/2 - theta_m from 0 to pi. At equality the arguments are -1 and 1, and the sum is inf - inf.
    """
    arguments = [x.args[0].subs(_ENDS) for x in parse(appendix).atoms(atanh)]
    ratios = {trig_normal(2 * cos(alpha) * cos(theta_m) / (1 - x**2)) for x in arguments}
    _require(ratios == {trig_normal(1 + cos(end)) for end in _ENDS.values()}, "1 - X^2 has the sign of cos(theta_m)")
    return Le(cos(theta_m), 0)
