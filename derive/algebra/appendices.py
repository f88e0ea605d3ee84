"""The paper's two appendices, read as printed, mended, and reduced to one line each by cancellation alone.

Appendix I prints the integral J_r (2.23) and Appendix II what it calls J_theta (3.13). With tan(alpha/2) and
tan(theta_m/2) for the angles everything but the two arctanh is a rational function, so that `sympy.cancel` finds what
is left of it; what the result integrates is found by differentiating it. No result is typed in, none is chosen from a
list.

Missing brackets are counted by one rule. A *place* is where the mended text differs from the print, and it counts the
brackets that were added there; none is ever taken away. A place is *unreadable* if a bracket is without its partner
as soon as this place alone is left as printed.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import lru_cache

import sympy as sp

from derive.check.proof import ProofError
from derive.declare.symbols import alpha, r, theta, theta_1, theta_2, theta_m

# --- the print -------------------------------------------------------------------------------------------
# Every round bracket is the print's own, the wrong ones included. {a}/{b} is a fraction bar, a^n a raised n, a blank
# between factors a product; as in any formula on one line, a/b c means (a/b) c. Abbreviated here, and nowhere else,
# are the functions of one angle and what the arctanh contain: the six terms N, without brackets, and the fraction M.

SHORT = {
    "N": "c1 ca - c1 ca c2 - s1 sa + s1 sa c2 - s1 ca s2 - c1 sa s2",
    "M": "{-c1 ca + s1 sa + ca}/{s1}",
    **{f"{f[0]}{x[-1]}": f"{f}(theta_{x})" for x in "12" for f in ("sin", "cos")},
    "sa": "sin(alpha)",
    "ca": "cos(alpha)",
}  # fmt: skip

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
    """A printed expression."""

    name: str
    printed: str = field(repr=False)

    @property
    def line(self) -> str:
        """The print on one line."""
        return " ".join(self.printed.split())


APPENDIX_I, APPENDIX_II = APPENDICES = (Appendix("I", PRINTED_I), Appendix("II", PRINTED_II))


# --- reading ---------------------------------------------------------------------------------------------

# What is printed, and what it must read: sin(theta_2) divides all six terms, and arctanh is of the quotient; the
# division by cos(alpha), written out, is of the whole bracket that opens the print.
MENDING = ((r"arctanh\(N\)?/s2\)?", "arctanh((N)/s2)"), (r"(?<!\))(?=/\(-c1 ca c2)", ")"))


@dataclass(frozen=True)
class Repair:
    """A place where the print is mended: its span, how it reads then, and how many brackets this adds."""

    start: int
    end: int
    mended: str
    brackets: int


def repairs(appendix: Appendix) -> tuple[Repair, ...]:
    """Every place where the print is not what it must read, in its order."""
    return tuple(sorted(
        (Repair(*found.span(), mended, len(mended) - len(found.group()))
         for pattern, mended in MENDING for found in re.finditer(pattern, appendix.line) if found.group() != mended),
        key=lambda x: x.start,
    ))  # fmt: skip


def mended_text(appendix: Appendix, leave: tuple[Repair, ...] = ()) -> str:
    """The print on one line, mended everywhere but at the places that are to be left."""
    text = appendix.line
    for repair in reversed(repairs(appendix)):
        if repair not in leave:
            text = text[: repair.start] + repair.mended + text[repair.end :]
    return text


def parse(appendix: Appendix, leave: tuple[Repair, ...] = ()) -> sp.Expr:
    """Read the mended print as an expression in theta_1, theta_2 and alpha.

    Raises
    ------
    ValueError
        If a bracket has no partner, or a character is not of the notation.
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
    text = re.sub(r"(?<=[\w)}]) (?=[\w({])", "*", text)  # two neighbours that are both operands are a product
    names = {"theta_1": theta_1, "theta_2": theta_2, "alpha": alpha, "arctanh": sp.atanh}
    return sp.parse_expr(text.translate(str.maketrans("{}", "()")).replace("^", "**"), local_dict=names)


def unreadable(appendix: Appendix, repair: Repair) -> bool:
    """Whether a bracket is without its partner if this one place is left as printed."""
    try:
        parse(appendix, (repair,))
    except ValueError:
        return True
    return False


# --- cancelling ------------------------------------------------------------------------------------------

_TAU, _SIGMA = sp.symbols("tau sigma", real=True)  # tan(alpha/2) and tan(theta_m/2)
_A1, _A2, _A = sp.symbols("A_1 A_2 A", real=True)  # the two arctanh of the print, and their sum
_HALVES = {alpha: _TAU, theta_m: _SIGMA}
_ENDS = {f(end): sp.expand_trig(f(angle)) for f in (sp.sin, sp.cos)
         for end, angle in ((theta_1, theta_m - alpha), (theta_2, theta_m + alpha))}  # fmt: skip
_TANGENTS = {sp.sin(x): 2 * y / (1 + y**2) for x, y in _HALVES.items()}
_TANGENTS |= {sp.cos(x): (1 - y**2) / (1 + y**2) for x, y in _HALVES.items()}


def rational(form: sp.Expr) -> sp.Expr:
    """A form as a quotient of polynomials in tan(alpha/2) and tan(theta_m/2), cancelled: zero only if it is 0."""
    return sp.cancel(form.xreplace(_ENDS).xreplace(_TANGENTS))


def angular(form: sp.Expr) -> sp.Expr:
    """The same, back in sines and cosines of alpha and theta_m, if it is a polynomial in them."""
    top, bottom = (sp.Poly(x, _TAU, _SIGMA) for x in sp.fraction(form))
    powers = [degree // 2 for degree in bottom.degree_list()]
    scale = sp.cancel(bottom.as_expr() / ((1 + _TAU**2) ** powers[0] * (1 + _SIGMA**2) ** powers[1]))
    _require(scale.is_number, f"a polynomial in sines and cosines: {scale} is left below")
    back = sp.Add(*(factor * sp.Mul(*map(_power, _HALVES, at, powers)) for at, factor in top.terms())) / scale
    return sp.factor(sp.expand(back))


def _power(x: sp.Symbol, i: int, n: int) -> sp.Expr:
    """tan(x/2)^i/(1 + tan(x/2)^2)^n, by sin(x/2) cos(x/2) = sin(x)/2 and their squares (1 -+ cos(x))/2."""
    return sp.sin(x) ** (i % 2) * (1 - sp.cos(x)) ** (i // 2) * (1 + sp.cos(x)) ** (n - (i + 1) // 2) / 2**n


def _require(holds: bool, claim: str) -> None:
    if not holds:
        raise ProofError(claim, holds, True)


@dataclass(frozen=True)
class Step:
    """One step: what was done, what proves it, and what the expression is then."""

    text: str
    proof: str
    expression: sp.Expr

    @property
    def operations(self) -> int:
        """Of the expression."""
        return int(sp.count_ops(self.expression))


@dataclass(frozen=True)
class Proof:
    """What an appendix truly is: `expression` in (alpha, theta_m), the double integral of `integrand`."""

    expression: sp.Expr
    integrand: sp.Expr
    steps: tuple[Step, ...]

    @property
    def operations(self) -> tuple[int, int]:
        """Of the print, and of the one line."""
        return self.steps[0].operations, self.steps[-1].operations


@lru_cache
def integrand(expression: sp.Expr) -> sp.Expr:
    """Find the r^n w(theta) whose double integral over the segment an expression in alpha and theta_m is.

    With g(u, alpha) the integral of r^n w(theta_m + u) over r from cos(alpha)/cos(u) to 1 (2.18), and J that of g over
    |u| < alpha: g vanishes at both ends; J'/(sin(alpha) cos(alpha)^n) is the integral of w(theta_m + u)/cos(u)^(n+1).
    Differentiated once more, K = J'/sin(alpha) obeys K' + n K tan(alpha) = [w(theta_m + alpha) + w(theta_m - alpha)]
    / cos(alpha), which is 2 w(theta_m) for a w = p sin + q cos. So n = -K''/(K tan(alpha))', found at one point and
    proved for all, and half the left side is w. Together with J = K = 0 at alpha = 0 this determines J.
    """

    def plain(form: sp.Expr) -> sp.Expr:
        return form.xreplace({sp.atanh(sp.sin(alpha)): _A}).xreplace(_TANGENTS)

    k = sp.cancel(expression.diff(alpha).subs(sp.sin(alpha) ** 2, 1 - sp.cos(alpha) ** 2) / sp.sin(alpha))
    leaning = k * sp.sin(alpha) / sp.cos(alpha)
    bent, leant = plain(k.diff(alpha, 2)), plain(leaning.diff(alpha))
    somewhere = {_TAU: sp.Rational(1, 3), _SIGMA: sp.Rational(1, 5), _A: sp.Rational(2, 7)}
    n = -bent.subs(somewhere) / leant.subs(somewhere)
    _require(n.is_Integer and sp.cancel(bent + n * leant) == 0, f"it integrates a power of r: n = {n}")
    w = sp.cancel(plain(k.diff(alpha) + n * leaning) / 2)
    _require(not w.has(_TAU, _A), f"what is left depends on theta_m alone: {w}")
    w = angular(w)
    _require(rational(w.diff(theta_m, 2) + w) == 0, f"a sine and a cosine of theta: {w}")
    _require(all(sp.cancel(plain(x)).subs({_TAU: 0, _A: 0}) == 0 for x in (expression, k)), "both vanish at alpha = 0")
    return r**n * w.subs(theta_m, theta)


def reduction(appendix: Appendix) -> Iterator[Step]:
    """Reduce an appendix to one line, a step at a time; the last two steps are this line.

    Up to the logarithm's branch the steps are identities: the sum of the two arctanh is artanh of what the sum of
    their arguments gives, plus k i pi with an integer k. k = 0 is the real integral.
    """
    form = parse(appendix)
    yield Step("read the mended print", "every bracket has its partner", form)
    found = sorted(form.atoms(sp.atanh), key=sp.default_sort_key)
    _require(len(found) == 2, f"two different arctanh occur, not {len(found)}")
    form = form.xreplace(dict(zip(found, (_A1, _A2), strict=True)))
    first, second = (x.args[0] for x in found)
    total = sp.atanh(angular(rational((first + second) / (1 + first * second))))
    yield Step(f"the two arctanh together are {total}", f"(X_1 + X_2)/(1 + X_1 X_2) cancels to {total.args[0]}", total)
    factors = [rational(form.diff(x)) for x in (_A1, _A2)]
    _require(factors[0] == factors[1] and not factors[0].has(_A1, _A2), "both arctanh have the same factor")
    factor = angular(factors[0])
    yield Step(f"both have the factor {factor}", "the derivatives by both cancel to one form, free of both", factor)
    rest = angular(rational(form.xreplace({_A1: 0, _A2: 0})))
    yield Step(f"without them {rest} is left", "cancels to it", rest)
    line = sp.factor(factor * total + rest)
    yield Step("together, factored", "the form is linear in the two arctanh", line)
    of = integrand(line)
    yield Step(f"it is the double integral of {of}", "found by differentiating it twice by alpha", line)


@lru_cache
def simplify(appendix: Appendix) -> Proof:
    """The whole of `reduction`, and what it finds."""
    steps = tuple(reduction(appendix))
    return Proof(steps[-1].expression, integrand(steps[-1].expression), steps)


def real_arithmetic_fails(appendix: Appendix) -> sp.Rel:
    """Prove for which arcs the arctanh arguments leave (-1, 1), so that real arithmetic gives NaN.

    1 - X^2 over cos(alpha) cos(theta_m) cancels to squares, 1 + tan(alpha/2)^2 and 1 + tan(theta_m/2)^2, for both
    arguments X: with 0 < alpha < pi/2 both fail together, and exactly where cos(theta_m) <= 0, that is for every dip
    psi = 3 pi/2 - theta_m from 0 to pi. (At equality the arguments are -1 and 1, and the sum is inf - inf.)
    """
    for arctanh in parse(appendix).atoms(sp.atanh):
        quotient = rational((1 - arctanh.args[0] ** 2) / (sp.cos(alpha) * sp.cos(theta_m)))
        scale, factors = sp.factor_list(sp.prod(sp.fraction(quotient)))
        positive = [f in (1 + _TAU**2, 1 + _SIGMA**2) or power % 2 == 0 for f, power in factors]
        _require(scale > 0 and all(positive), "1 - X^2 has the sign of cos(theta_m)")
    return sp.Le(sp.cos(theta_m), 0)
