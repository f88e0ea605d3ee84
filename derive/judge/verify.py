"""Judgement of every claim of `derive.judge.paper` by its derivation from the definitions.

A verdict is computed, never declared, by the rules of `claims.VERDICTS`. A form holds if its difference from the
derived form is proved to vanish on its domain. A cause is shown, not asserted: either it gives the printed digits, or
one small edit turns the printed form into one that passes the same proof. A form that holds only if a postulate is put
into the derived one is an assumption, wherever this happens. `judge` is a function of the claim alone.
"""

import re
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from itertools import combinations, product, takewhile
from typing import Any, NamedTuple

import mpmath as mp
import sympy as sp
from sympy import (
    Abs,
    Derivative,
    Expr,
    Integral,
    Mul,
    Order,
    Rational,
    Symbol,
    Tuple,
    atanh,
    diff,
    exp,
    log,
    oo,
    pi,
    sin,
    sympify,
    tan,
)
from sympy.core.function import AppliedUndef

from derive.algebra.appendices import Appendix, parse, real_arithmetic_fails, repairs, simplify, unreadable
from derive.algebra.dynamics import R
from derive.algebra.integrate import quadrature
from derive.algebra.prove import prove_zero, refute
from derive.check.proof import ProofError
from derive.declare.quantities import CHORD
from derive.declare.symbols import alpha, in_words, theta, theta_m
from derive.declare.units import dimension, of_unit
from derive.judge import mechanics as m
from derive.judge import section as s
from derive.judge.claims import DOMAINS, UNITS, VERDICTS, Cause, Claim
from derive.judge.paper import CLAIMS
from derive.judge.postulates import POSTULATES, Postulate, exhibit
from derive.kinds import TextPair, Texts
from derive.progress import track

_DIGITS = 30
_TINY = mp.mpf(10) ** -20
Domain = tuple[tuple[str, Any, Any], ...]


class Row(NamedTuple):
    """Claim of the paper with its verdict."""

    id: str
    claim: str
    printed: str
    computed: str
    verdict: str
    cause: str
    assumes: str


# How (2.19) writes artanh(sin alpha): of a number that is positive for every |alpha| < pi/2, and both vanish at 0.
_LOG = log(Abs(tan(pi / 4 + alpha / 2)))
_ARTANH = atanh(sin(alpha))


def limits(domain: Domain) -> dict[str, tuple[Any, Any]]:
    """Return the domain of each symbol, from `DOMAINS` and the claim."""
    return DOMAINS | {name: (low, high) for name, low, high in domain}


@cache
def vanishes(form: Expr, domain: Domain = ()) -> bool:
    """Return whether a form is zero on its symbols' domains, for each sign of them: refuted at a point or proved."""
    form = sympify(form).as_dummy()
    if form.has(Order):
        return False
    parts = form.atoms(Integral, Derivative, AppliedUndef)  # unevaluated, each counts as one symbol
    form = form.xreplace({x: Symbol(f"_{x}", real=True) for x in parts})
    signs = [dict(choice) for choice in product(*_choices(form, domain))]
    try:
        for choice in signs:
            refute(form.subs(choice), "a printed form")
    except ProofError:
        return False
    if form.has(_LOG):
        slope = diff(_LOG.replace(Abs, lambda x: x) - _ARTANH, alpha)
        prove_zero(sp.simplify(slope.rewrite(exp)), "log tan(pi/4 + alpha/2) = artanh(sin alpha)")
        form = form.subs(_LOG, _ARTANH)
    for choice in signs:
        prove_zero(form.subs(choice), "a printed form")
    return True


def _choices(form: Expr, domain: Domain) -> Iterator[list[tuple[Symbol, Any]]]:
    """Yield for each symbol its single value, or a positive symbol with each sign in its domain, as substitutions."""
    for x in sorted(form.free_symbols, key=lambda x: x.name):
        low, high = limits(domain).get(x.name, (0, oo))
        size = Symbol(x.name, positive=True)
        signed = ((size, high > 0), (-size, low < 0))
        yield [(x, low)] if low == high else [(x, value) for value, exists in signed if exists]


def _has_unit(form: Expr, unit: str) -> bool:
    """Return whether a form has the dimension of a unit, such as "m/s^2"; 0 has every dimension."""
    form = form.replace(Integral, lambda f, *limits: f * Mul(*(x for x, *_ in limits)))  # as its integrand dx
    units = {x: of_unit(UNITS.get(x.name, "")) for x in form.free_symbols}
    return form == 0 or dimension(form, units, "a printed form") == of_unit(unit)


def _integrates(form: Expr, weight: Expr, domain: Domain) -> bool:
    """Return whether a form in alpha is the double integral of a weight, by quadrature at points of its domain."""
    low, high = limits(domain)["alpha"]
    points = [s.section_value(low + Rational(k, 11) * (high - low)) for k in (1, 6, 10)]
    return all(abs(s.section_value(form, x) - quadrature(weight, -x, x, 15)) < 1e-13 for x in points)


def _form_holds(claim: Claim, forms: str, postulates: Sequence[Postulate]) -> bool:
    """Return whether transcribed forms equal the derived forms after the postulates are put into these."""
    printed = m.parse_forms(forms)
    replaced = [pair for x in postulates for pair in x.put]
    if len(printed) != len(claim.derived):
        return False
    for form in printed:
        for integral in form.atoms(Integral):
            if any(x in Tuple(*ends).free_symbols for x, *ends in integral.limits):
                return False  # nor is a variable in its own limits
    for form, right in zip(printed, claim.derived, strict=True):
        right = right.subs(replaced)
        if form != right and not vanishes(form - right, claim.domain):
            return False
    if claim.unit and not _has_unit(printed[0], claim.unit):
        return False
    if claim.weight is not None and not _integrates(printed[0], claim.weight, claim.domain):
        return False
    return all(vanishes(x.subs(replaced), claim.domain) for x in claim.law(printed[0]))


Judgement = tuple[str, str, str]  # computed, verdict, cause
UNEXPLAINED = ("wrong", "cause not found")


def judge(claim: Claim) -> Row:
    """Return the judgement of one claim, a function of the claim alone."""
    kinds = {"number": _number, "range": _range, "small": _small, "appendix": _appendix}
    with mp.workdps(_DIGITS):
        computed, verdict, cause = kinds.get(claim.kind, _form)(claim)
        assert verdict in VERDICTS, verdict
        return Row(claim.id, claim.claim, claim.printed, computed, verdict, cause, "; ".join(_assumed(claim)))


def _assumed(claim: Claim) -> Texts:
    """Return the assumptions of a claim in words: domains of its symbols, and given relations."""
    symbols = {name for name, *_ in claim.domain}
    if claim.kind == "form" and claim.expression:
        for form in (*m.parse_forms(claim.expression), *claim.derived):
            symbols |= {x.name for x in form.free_symbols}
    assumed = []
    for x, (low, high) in limits(claim.domain).items():
        if x not in symbols:
            continue
        if low == high:
            assumed.append(f"{x} = {low}")
        elif high == oo:
            assumed.append(f"{x} > {low}")
        else:
            assumed.append(f"{low} < {x} < {high}")
    return [*assumed, *claim.given]


def _number(claim: Claim) -> Judgement:
    """Return the verdict on a printed number compared with a value, or with the range that other numbers imply."""
    least, *more = claim.derived
    computed = claim.shows.format(" to ".join(map(_digits, claim.derived)))
    printed, low, high = s.printed_as(claim.printed)
    if not more and abs(least - printed) < abs(printed) * _TINY:
        return computed, "holds", claim.remark
    if least < high and low <= claim.derived[-1]:
        cut = not more and least - printed >= printed - low
        return computed, "holds to the printed digits", "cut off, not rounded" if cut else claim.remark
    return computed, *_explained(claim, lambda value: low <= value < high)


def _small(claim: Claim) -> Judgement:
    """Return the verdict on a statement "for small rotations", for which the paper gives no limit.

    It holds if the change stays within the bounds up to the rotation that the paper itself reaches.
    """
    (change,) = claim.derived
    low, high = m.parse_forms(claim.expression)
    largest = s.reached("phi", as_printed=True)
    *first, last = (change(x) for x in (*map(mp.radians, (1, 2, 5)), largest))
    computed = claim.shows.format(*(mp.nstr(x, 4) for x in (*first, last)))
    if low <= last <= high:
        return computed, "holds", claim.remark
    limit = low if last < low else high
    threshold = mp.findroot(lambda phi: change(phi) - limit, (0, largest), solver="anderson")
    holds_to, reaches = (mp.nstr(mp.degrees(phi), 3) for phi in (threshold, largest))
    cause = f"no range is stated; true up to {holds_to} degrees, but the paper reaches {reaches}"
    return computed, "imprecise", cause


def _range(claim: Claim) -> Judgement:
    """Return the verdict on a statement of size: every value lies between two bounds."""
    low, high = m.parse_forms(claim.expression)
    computed = claim.shows.format(*map(_digits, claim.derived))
    if all(low <= x <= high for x in claim.derived):
        return computed, "holds", claim.remark
    return computed, *_explained(claim, lambda value: min(abs(value - x) for x in claim.derived) < _TINY)


def _explained(claim: Claim, fits: Callable[[mp.mpf], bool]) -> TextPair:
    """Return verdict and words of the first cause whose value ``fits``, or that the cause was not found."""
    for cause in claim.causes:
        if cause.value:
            value = cause.value()
            if fits(value):
                return cause.verdict, f"{cause.words}: {_digits(value)}"
    return UNEXPLAINED


def _form(claim: Claim) -> Judgement:
    """Return the verdict on a printed form compared with the derived form.

    A cause is an edit of the print that makes it hold, a postulate something that has to be put into the derived form
    before it does: the least number of these is sought. Without a transcription there is nothing to compare.
    """
    if not claim.expression:
        computed = claim.shows.format(*map(_digits, claim.derived)) if claim.derived else "-"
        return computed, "not machine-checkable", claim.remark
    computed = claim.shows.format("; ".join(dict.fromkeys(map(words, claim.derived))))
    edits = (None, *(x for x in claim.causes if x.edit[0] in claim.expression))
    for postulates, cause in product(_candidates(claim), edits):
        if _form_holds(claim, claim.expression.replace(*cause.edit) if cause else claim.expression, postulates):
            return computed, *_form_verdict(claim, postulates, cause)
    return computed, *UNEXPLAINED


def _candidates(claim: Claim) -> Iterator[tuple[Postulate, ...]]:
    """Yield combinations of postulates that change the derived form of a claim or its law, the smallest first."""
    forms = (*claim.derived, *claim.law(claim.derived[0]))
    relevant = [p for p in POSTULATES if any(x.subs(p.put) != x for x in forms)]
    for count in range(len(relevant) + 1):
        yield from combinations(relevant, count)


def _form_verdict(claim: Claim, postulates: Sequence[Postulate], cause: Cause | None) -> TextPair:
    """Return verdict and words of a form that is correct under postulates, after the cause's edit if there is one."""
    remark = cause.words if cause else claim.remark
    if cause and (cause.verdict != "imprecise" or not postulates):
        return cause.verdict, "; given ".join([remark, *(x.words for x in postulates)])
    if postulates:
        return "assumption", "; ".join(filter(None, (*map(_instead, postulates), remark)))
    return "definition" if _names(claim) else "holds", remark


def _names(claim: Claim) -> bool:
    """Return whether a claim with a unit introduces a new quantity, which no earlier claim contains."""
    name = re.compile(rf"(?<!\w){re.escape(claim.printed.partition(' = ')[0])}(?![\w*])")
    earlier = takewhile(lambda x: x.id != claim.id, CLAIMS)
    return bool(claim.unit) and not any(name.search(x.printed) for x in earlier)


def _appendix(claim: Claim) -> Judgement:
    """Return the verdict on a printed antiderivative from its proved integrand."""
    appendix = claim.subject
    assert appendix is not None
    try:
        proof = simplify(appendix)
    except (ProofError, ValueError) as error:
        return "nothing: it is no such integral", "wrong", f"cause not found ({error})"
    before, *_, after = (step.operations for step in proof.steps)
    computed = f"integral of {words(proof.integrand)}: {words(proof.expression)}; {before} operations -> {after}"
    brackets = _brackets(appendix)
    (claimed,) = m.parse_forms(claim.expression)
    remarks = [brackets] if brackets else []
    if real_arithmetic_fails(appendix).subs(theta_m, float(s.FIRST_END + s.HALF)):
        remarks.append("NaN in real arithmetic here")
    if not vanishes(proof.integrand - claimed):
        number = _digits(s.section_value(proof.expression))
        remarks.insert(0, f"integrates {words(proof.integrand)}, not {words(claimed)}: {number} here")
        return computed, "wrong", "; ".join(remarks)
    if brackets:
        return computed, "misprint", "; ".join(remarks)
    return computed, "holds", claim.remark


def _brackets(appendix: Appendix) -> str:
    """Return a remark on missing brackets by the rule of `derive.algebra.appendices`, empty if none matters."""
    places = repairs(appendix)
    lost = sum(unreadable(appendix, x) for x in places)
    if not places or (not lost and vanishes(parse(appendix, places) - parse(appendix))):
        return ""
    missing = sum(x.brackets for x in places)
    return f"{missing} brackets missing at {len(places)} places, {lost} of them unreadable"


def _digits(value: Any) -> str:
    """Return a number as text with seven significant digits."""
    return str(mp.nstr(mp.mpf(value), 7, strip_zeros=False, min_fixed=-5, max_fixed=9))


def _instead(postulate: Postulate) -> str:
    """Return a postulate, a state that violates it, and the size of the effect."""
    size, printed = (f"{mp.nstr(100 * share, 4)} %" for share in (exhibit(postulate), postulate.printed_size()))
    effect = postulate.effect.format(size, printed=printed)
    return f"{postulate.words}; instead, {postulate.alternative}: {effect}"


def words(form: Expr) -> str:
    """Return a form as readable text."""
    text = in_words(form.replace(Integral, _integral)).replace("~", "")
    return text.replace("rate*", "domega*/dt*").replace("_of(", "(")


def _integral(f: Expr, *limits: Tuple) -> Symbol:
    """Return an integral of f over limits (x, low, high) as a symbol whose name is its text.

    The ~ in the name sorts it last in a product.
    """
    lower = {R * CHORD: "R_1", CHORD: "R_1_star"}
    signs = ""
    for x, low, high in reversed(limits):
        signs += "int " if x == theta else f"int_{lower.get(low, low)}^{{{high}}} "
    differentials = " ".join(f"d{x}" for x, *_ in limits)
    return Symbol(f"~{signs}{f} {differentials}")


_judge_once = cache(judge)


def judged(claims: Sequence[Claim] = CLAIMS) -> list[Row]:
    """Judge claims, by default the whole paper, and return their rows in the same order."""
    return [_judge_once(claim) for claim in track(claims, "claims judged", len(claims))]
