"""The two appendices of the paper: mended, reduced to one line by cancelling, and compared with quadrature."""

import re
from dataclasses import replace
from functools import cache
from typing import Any

import mpmath as mp
import pytest
import sympy as sp

from derive.algebra.appendices import (
    APPENDICES,
    APPENDIX_I,
    Appendix,
    integrand,
    mended_text,
    parse,
    real_arithmetic_fails,
    repairs,
    simplify,
    unreadable,
)
from derive.algebra.integrate import quadrature
from derive.check.proof import ProofError
from derive.declare.symbols import alpha, r, theta, theta_1, theta_2, theta_m

each = pytest.mark.parametrize("appendix", APPENDICES, ids=lambda appendix: appendix.name)
fails_where = cache(real_arithmetic_fails)
DIGITS = 50


def arc(start: str, end: str) -> tuple[mp.mpf, mp.mpf]:
    """Degrees as theta_1 and alpha in radians, with digits to spare."""
    with mp.workdps(80):
        first, last = mp.radians(mp.mpf(start)), mp.radians(mp.mpf(end))
        return first, (last - first) / 2


PAPER = arc("215.2", "276.9")  # Table 2-1


def evaluate(form: sp.Expr, first: mp.mpf, half: mp.mpf) -> Any:
    """Return a form in the angles of the arc, as a complex number."""
    function = sp.lambdify((theta_1, theta_2, alpha, theta_m), form, "mpmath")
    with mp.workdps(DIGITS + 15):
        return mp.mpc(function(first, first + 2 * half, half, first + half))


# --- the reduction ---------------------------------------------------------------------------------------


@each
def test_the_proof_reduces_the_appendix_to_one_line(appendix: Appendix) -> None:
    proof = simplify(appendix)
    assert proof.expression.free_symbols == {alpha, theta_m}
    first, *_, last = proof.steps
    assert (first.expression, last.expression) == (parse(appendix), proof.expression)
    assert (first.operations, last.operations) == ({"I": 671, "II": 744}[appendix.name], 9)
    assert all(step.text and step.proof for step in proof.steps)


@each
@pytest.mark.parametrize(
    ("start", "end", "branch"),
    [
        ("215.2", "276.9", 0),  # the paper's section: both arguments outside [-1, 1], opposite signs
        ("285", "330", 0),  # dip below zero: both inside
        ("170", "260", -1),  # passes the level of the centre: both exceed 1
        ("190", "345", 0),  # deep arc
    ],
)
def test_print_one_line_and_quadrature_agree(appendix: Appendix, start: str, end: str, branch: int) -> None:
    """Compare the print, its one line and quadrature; arctanh outside [-1, 1] has the imaginary part +pi/2 or -pi/2.

    Both leave [-1, 1] together, and their product is -tan(theta_1/2) tan(theta_2/2): so the imaginary parts cancel,
    unless the arc passes the level of its centre, theta_1 < pi < theta_2, where mpmath's principal values leave -i pi.
    """
    at, proof = arc(start, end), simplify(appendix)
    printed, line = parse(appendix), proof.expression
    integral = quadrature(proof.integrand, *at, DIGITS + 10)
    factor = line.expand().coeff(sp.atanh(sp.sin(alpha)))
    with mp.workdps(DIGITS + 10):
        pair = sum(evaluate(x, *at) for x in printed.atoms(sp.atanh))
        assert int(mp.nint(pair.imag / mp.pi)) == branch
        expected = mp.mpc(integral, branch * mp.pi * evaluate(factor, *at).real)
        assert abs(evaluate(printed, *at) - expected) < abs(integral) * mp.mpf(10) ** -DIGITS
        assert abs(evaluate(line, *at) - integral) < abs(integral) * mp.mpf(10) ** -DIGITS


def test_the_integrand_is_found() -> None:
    """The integrand is found also with r^3, a sine and a cosine at once; the appendices have r and either alone."""
    sine, cosine = sp.sin(alpha), sp.cos(alpha)
    # Of r^3 cos(u) about the bisector, where sin(u) integrates to nothing.
    amplitude = (2 * sine - cosine**4 * (sine / cosine**2 + sp.atanh(sine))) / 4
    weight = 2 * sp.sin(theta) + sp.cos(theta)
    for at in (0.3, 1.2):
        assert abs(quadrature(r**3 * sp.cos(theta), -at, at, 15) - float(amplitude.subs(alpha, at))) < 1e-14
    assert sp.expand(integrand(amplitude * weight.subs(theta, theta_m)) - r**3 * weight) == 0


@pytest.mark.parametrize(
    "change",
    [lambda e: e + sp.sin(theta_m), lambda e: e * sp.cos(alpha), lambda e: e * sp.sin(theta_m), lambda e: e * alpha],
)
def test_what_is_no_such_integral_is_refused(change: Any) -> None:
    with pytest.raises(ProofError):
        integrand(change(simplify(APPENDIX_I).expression))


# --- the brackets ----------------------------------------------------------------------------------------


@each
def test_brackets_are_counted_by_one_rule(appendix: Appendix) -> None:
    """Independently: brackets of the mended text less those of the print, and nothing but brackets changed."""
    printed, mended = appendix.printed, mended_text(appendix)
    count = [sum(text.count(x) for x in "()") for text in (printed, mended)]
    places = repairs(appendix)
    assert (len(places), count[1] - count[0]) == {"I": (9, 14), "II": (10, 17)}[appendix.name]
    assert sum(x.brackets for x in places) == count[1] - count[0]
    assert all(x.brackets > 0 for x in places)
    assert re.sub("[()]", "", printed) == re.sub("[()]", "", mended)
    assert sum(unreadable(appendix, x) for x in places) == {"I": 4, "II": 3}[appendix.name]
    assert not repairs(replace(appendix, printed=mended))


@each
def test_every_repair_is_needed(appendix: Appendix) -> None:
    integral = quadrature(simplify(appendix).integrand, *PAPER, 15)
    for place in repairs(appendix):
        if unreadable(appendix, place):
            with pytest.raises(ValueError, match="without partner"):
                parse(appendix, (place,))
        else:  # can be read, but is not the integral
            assert abs(evaluate(parse(appendix, (place,)), *PAPER).real / integral - 1) > 1e-2


def test_unknown_notation_is_refused() -> None:
    with pytest.raises(ValueError, match="unknown notation"):
        parse(replace(APPENDIX_I, printed="1 + x?"))
    with pytest.raises(ValueError, match="without partner"):
        parse(replace(APPENDIX_I, printed="(1 + sa"))


# --- planted misprints -----------------------------------------------------------------------------------


@each
def test_flipped_signs_are_found(appendix: Appendix) -> None:
    text = appendix.printed
    signs = [match.start() + 1 for match in re.finditer(" [-+] ", text)]
    assert len(signs) > 30
    for place in signs[5::40]:
        flipped = text[:place] + {"+": "-", "-": "+"}[text[place]] + text[place + 1 :]
        with pytest.raises(ProofError):
            simplify(replace(appendix, printed=flipped))


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("2 ca^4 arctanh(", "3 ca^4 arctanh("),
        ("- sa ca^2 s1", ""),
        ("arctanh(M) c1^2 s2 -", "arctanh(M) c1^3 s2 -"),
        ("arctanh(M) s2", "arctanh({-c1 ca + s1 sa - ca}/{s1}) s2"),
    ],
)
def test_planted_misprints_are_found(old: str, new: str) -> None:
    text = APPENDIX_I.printed
    assert old in text
    with pytest.raises(ProofError):
        simplify(replace(APPENDIX_I, printed=text.replace(old, new, 1)))


@each
@pytest.mark.parametrize(
    ("start", "end", "fails"), [("215.2", "276.9", True), ("100", "140", True), ("285", "330", False)]
)
def test_real_arithmetic(appendix: Appendix, start: str, end: str, fails: bool) -> None:
    first, half = arc(start, end)
    assert bool(fails_where(appendix).subs(theta_m, float(first + half))) == fails
    arguments = [evaluate(atom.args[0], first, half) for atom in parse(appendix).atoms(sp.atanh)]
    assert [abs(x) > 1 for x in arguments] == [fails, fails]
