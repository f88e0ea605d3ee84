"""The judge: every claim of `derive.judge.paper` against what follows from the definitions.

A verdict is computed, never declared. A form holds if its difference from the derived form is proved to vanish, a
number if its printed digits come out. A cause is shown, not asserted: either it reproduces the printed digits, or
one small edit turns the printed form into one that passes the same proof. `judge` is a function of the claim alone.
"""

import json
import re
import textwrap
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, replace
from decimal import Decimal
from functools import cache
from typing import Any

import mpmath as mp
import sympy as sp
from sympy.core.function import AppliedUndef

from derive.algebra.dynamics import R
from derive.algebra.prove import prove_zero
from derive.declare.quantities import CHORD
from derive.declare.symbols import theta, theta_m
from derive.judge.appendices import ProofError as AppendixError
from derive.judge.appendices import parse, real_arithmetic_fails
from derive.judge.appendices import simplify as simplify_appendix
from derive.judge.evidence import context
from derive.judge.paper import CLAIMS, DIMENSIONS, VERDICTS, Claim

KEYS = ("id", "claim", "printed", "computed", "verdict", "cause")
_DIGITS = 30


@dataclass(frozen=True)
class Row:
    """A judged claim."""

    id: str
    claim: str
    printed: str
    computed: str
    verdict: str
    cause: str


# --- proof -----------------------------------------------------------------------------------------------


def _join(form: sp.Expr) -> sp.Expr:
    """Write log tan(pi/4 + y/2) as artanh(sin y), where the two have one derivative and both vanish at y = 0."""
    for log in sorted(form.atoms(sp.log), key=sp.default_sort_key):
        inside = log.args[0].replace(sp.Abs, lambda x: x)  # positive for every |y| < pi/2
        if isinstance(inside, sp.tan):
            y = sp.Dummy("y", positive=True)
            was, now = sp.log(sp.tan(sp.pi / 4 + y / 2)), sp.atanh(sp.sin(y))
            prove_zero(sp.simplify(sp.diff(was - now, y).rewrite(sp.exp)), "log tan(pi/4 + y/2) = artanh(sin y)")
            form = form.subs(log, now.subs(y, sp.expand(2 * inside.args[0] - sp.pi / 2)))
    return form


@cache
def vanishes(form: sp.Expr) -> bool:
    """Decide whether a form is zero: refuted at a point with many digits, or else proved.

    Raises
    ------
    ProofError
        If neither succeeds.
    """
    form = sp.sympify(form).as_dummy()
    for kind in (sp.Integral, sp.Derivative, AppliedUndef):  # what is not evaluated counts as one symbol
        atoms = sorted(form.atoms(kind), key=sp.default_sort_key)
        form = form.xreplace({x: sp.Symbol(f"_{x}", positive=True) for x in atoms})
    free = sorted(form.free_symbols, key=lambda x: x.name)
    form = form.subs({x: sp.Symbol(x.name, positive=True) for x in free})
    free = sorted(form.free_symbols, key=lambda x: x.name)
    point = {x: sp.Rational(3 + k * 7 % 11, 17 + k) for k, x in enumerate(free)}
    if abs(sp.N(form.subs(point), _DIGITS)) > sp.Float(10) ** -(_DIGITS - 10):
        return False
    prove_zero(_join(form), "a printed form")
    return True


def _equal(printed: sp.Expr, derived: sp.Expr) -> bool:
    if printed.has(sp.Order) or derived.has(sp.Order):
        return bool(printed == derived)
    return vanishes(printed - derived)


def _captured(form: sp.Expr) -> bool:
    """Whether an integration variable also stands in its own limits."""
    return any(limit[0] in sp.Tuple(*limit[1:]).free_symbols for x in form.atoms(sp.Integral) for limit in x.limits)


def _homogeneous(form: sp.Expr, dimension: str) -> bool:
    """Whether a form has the dimension: scale every unit, and see by what the form is multiplied."""
    units = {x: sp.Symbol(f"unit_{x}", positive=True) for x in "MLT"}
    scale = {sp.Symbol(k): sp.parse_expr(v, local_dict=units) for k, v in DIMENSIONS.items()}
    by_name = {x: x * scale[sp.Symbol(x.name)] for x in form.free_symbols if sp.Symbol(x.name) in scale}
    return vanishes(form.subs(by_name, simultaneous=True) - sp.parse_expr(dimension, local_dict=units) * form)


def _form_holds(claim: Claim, forms: str, derived: tuple[sp.Expr, ...]) -> bool:
    c = context()
    printed = c.read(forms)
    return (
        len(printed) == len(derived)
        and not any(map(_captured, printed))
        and all(map(_equal, printed, derived))
        and (not claim.dimension or _homogeneous(printed[0], claim.dimension))
        and (claim.law is None or all(map(vanishes, claim.law(printed[0]))))
    )


# --- judging ---------------------------------------------------------------------------------------------


def judge(claim: Claim) -> Row:
    """Judge one claim, a function of the claim alone.

    Parameters
    ----------
    claim : Claim
        From `derive.judge.paper.CLAIMS`, or changed by `dataclasses.replace`.
    """
    with mp.workdps(_DIGITS):
        kind = {"number": _number, "range": _range, "form": _form, "appendix": _appendix, "outside": _outside}
        computed, verdict, cause = kind[claim.kind](claim)
        if claim.size is not None and verdict in ("holds", "imprecise"):
            # What the paper postulates costs something, or else it is no assumption.
            size = claim.size(context())
            if mp.mpf(size) != 0:
                verdict = "assumption"
            cause = "; ".join(dict.fromkeys(filter(None, (claim.note, cause))))
            computed = claim.shows.format(f"{_digits(100 * size)} %")
    assert verdict in VERDICTS, verdict
    return Row(claim.id, claim.claim, claim.printed, computed, verdict, cause)


Judgement = tuple[str, str, str]


def _number(claim: Claim) -> Judgement:
    """A printed number against one value, or against the interval that other printed numbers leave for it."""
    found = claim.definition(context())
    values = [found] if isinstance(found, mp.mpf) else sorted(found)
    computed = claim.shows.format(" to ".join(map(_digits, values)))
    printed, unit = _printed(claim.printed)
    off = max(values[0] - printed, printed - values[-1])
    if abs(off) < abs(printed) * mp.mpf(10) ** -20:
        return computed, "holds", claim.note
    if off < (unit if len(values) == 1 else 0):
        return computed, "holds to the printed digits", claim.note
    for cause in claim.causes:
        value = cause.value(context()) if cause.value else mp.inf
        if abs(value - printed) <= unit / 2:
            return computed, cause.verdict, f"{cause.words}: {_digits(value)}"
    return computed, "wrong", "cause not found"


def _range(claim: Claim) -> Judgement:
    """A statement of size: every value between two bounds."""
    values = claim.definition(context())
    low, high = (mp.mpf(x.p) / x.q for x in context().read(claim.expression))
    computed = claim.shows.format(*map(_digits, values))
    if all(low <= x <= high for x in values):
        return computed, "holds", claim.note
    for cause in claim.causes:
        value = cause.value(context()) if cause.value else mp.inf
        if any(abs(value - x) < mp.mpf(10) ** -20 for x in values):
            return computed, cause.verdict, cause.words
    return computed, "wrong", "cause not found"


def _form(claim: Claim) -> Judgement:
    """A printed form against the derived one; a cause is an edit of the print that makes it hold."""
    if not claim.expression:  # a postulate of which only the size can be computed
        return "-", "holds" if claim.size else "not machine-checkable", claim.note
    derived = claim.definition(context())
    derived = derived if isinstance(derived, tuple) else (derived,)
    computed = claim.shows.format("; ".join(dict.fromkeys(map(words, derived))))
    if _form_holds(claim, claim.expression, derived):
        return computed, "holds", claim.note
    for cause in claim.causes:
        old, new = cause.edit
        if old and old in claim.expression and _form_holds(claim, claim.expression.replace(old, new), derived):
            return computed, cause.verdict, cause.words
    return computed, "wrong", "cause not found"


def _appendix(claim: Claim) -> Judgement:
    """What a printed antiderivative integrates, found by proof, against what the paper claims it integrates."""
    assert claim.subject is not None
    try:
        proof = simplify_appendix(claim.subject)
    except (AppendixError, ValueError) as error:
        return "nothing: it is no such integral", "wrong", f"cause not found ({error})"
    computed = (f"integral of {words(proof.integrand)}: {words(proof.expression)}; "
                f"{proof.operations_before} operations -> {proof.operations_after}")  # fmt: skip
    (claimed,) = context().read(claim.expression)
    if not _equal(proof.integrand, claimed):
        number = _digits(context().value(proof.expression))
        return computed, "wrong", f"integrates {words(proof.integrand)}, not {words(claimed)}: {number} here"
    at = float(context().theta_1 + context().alpha)
    real = "; NaN in real arithmetic here" if real_arithmetic_fails(claim.subject).subs(theta_m, at) else ""
    bare = replace(claim.subject, repairs=())
    try:
        holds = not claim.subject.repairs or vanishes(parse(bare) - parse(claim.subject))
    except ValueError as error:
        reason = str(error).partition(": ")[2].partition(" after ")[0]
        return computed, "misprint", f"{len(claim.subject.repairs)} brackets missing: {reason}{real}"
    return computed, *(("holds", claim.note) if holds else ("misprint", f"brackets of arctanh misplaced{real}"))


def _outside(claim: Claim) -> Judgement:
    """Nothing to compute; the claim's note says why."""
    return "-", "not machine-checkable", claim.note


# --- words -----------------------------------------------------------------------------------------------


def _printed(digits: str) -> tuple[mp.mpf, mp.mpf]:
    """A printed number and the unit of its last place."""
    return mp.mpf(digits), mp.mpf(10) ** Decimal(digits).as_tuple().exponent


def _digits(value: Any) -> str:
    """Seven significant digits."""
    return str(mp.nstr(mp.mpf(value), 7, strip_zeros=False, min_fixed=-5, max_fixed=9))


def words(form: sp.Expr) -> str:
    """A form as one reads it."""
    text = str(sp.sstr(form.replace(sp.Integral, _integral))).replace("~", "").replace("**", "^").replace("*", " ")
    return text.replace("rate_star", "domega*/dt*").replace("_star", "*")


def _integral(f: sp.Expr, *limits: sp.Tuple) -> sp.Symbol:
    lower = {R * CHORD: "R_1", CHORD: "R_1_star"}
    signs = ("int " if x == theta else f"int_{lower.get(low, low)}^{{{high}}} " for x, low, high in reversed(limits))
    return sp.Symbol(f"~{''.join(signs)}{f} " + " ".join(f"d{x}" for x, *_ in limits))  # ~ comes last in a product


@cache
def rows() -> tuple[Row, ...]:
    """Every claim judged, in the paper's order."""
    return tuple(map(judge, CLAIMS))


def counts(judged: Iterable[Row]) -> str:
    """One line: how many of each verdict."""
    number = Counter(row.verdict for row in judged)
    return f"{sum(number.values())} claims: " + ", ".join(f"{number[v]} {v}" for v in VERDICTS if number[v])


def report(form: str = "table") -> str:
    """Judge the paper and return the text.

    Parameters
    ----------
    form : {"table", "json", "markdown"}
        For a terminal of 100 columns, for a program, or for a colleague.
    """
    judged = list(rows())
    return {"table": _table, "json": _json, "markdown": _markdown}[form](judged)


def _json(judged: list[Row]) -> str:
    return json.dumps([{k: getattr(row, k) for k in KEYS} for row in judged], indent=2, ensure_ascii=True)


def _failing(judged: list[Row]) -> list[Row]:
    return [row for row in judged if not row.verdict.startswith("holds")]


def _soft(text: str, width: int) -> str:
    """Let words that are too long for a column break behind a bracket or a stroke."""
    return re.sub(rf"\S{{{width + 1},}}", lambda x: re.sub(r"(?<=[)}/])(?=[a-z{])", " ", x.group()), text)


def _table(judged: list[Row]) -> str:
    widths = (11, 15, 18, 19, 11, 16)  # 90, and two blanks between columns
    lines: list[str] = []

    def put(cells: Iterable[str]) -> None:
        wrapped = [textwrap.wrap(_soft(x, w), w) or [""] for x, w in zip(cells, widths, strict=True)]
        for k in range(max(map(len, wrapped))):
            line = "  ".join((x[k] if k < len(x) else "").ljust(w) for x, w in zip(wrapped, widths, strict=True))
            lines.append(line.rstrip())

    put(("where", "claim", "printed", "definitions give", "verdict", "cause"))
    lines.append("-" * 100)
    for row in judged:
        put([getattr(row, k) for k in KEYS])
    lines += ["-" * 100, *textwrap.wrap(counts(judged), 100), "", "What does not simply hold:"]
    for row in _failing(judged):
        gives = f" ({row.computed})" if 1 < len(row.computed) < 90 else ""
        lines += textwrap.wrap(f"{row.id}: {row.verdict}{gives}: {row.cause}", 100, subsequent_indent="    ")
    return "\n".join(lines)


def _markdown(judged: list[Row]) -> str:
    def table(chosen: list[Row]) -> list[str]:
        cells = [[str(getattr(row, k)).replace("|", "\\|").replace("*", "\\*") for k in KEYS] for row in chosen]
        head = ["where", "claim", "printed", "definitions give", "verdict", "cause"]
        return ["| " + " | ".join(x) + " |" for x in (head, ["---"] * len(KEYS), *cells)]

    return "\n".join(["# The slip-circle paper, judged against its own definitions", "",
                      "Every verdict below was computed: forms by proof, numbers from the definitions. A cause is",
                      "shown: it gives the printed digits, or one edit of the printed form makes it hold.", "",
                      "## Summary", "",
                      counts(judged) + ".", "",
                      "## What does not simply hold", "", *table(_failing(judged)), "", "## All claims", "",
                      *table(judged)])  # fmt: skip
