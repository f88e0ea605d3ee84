"""The two appendices of the paper: repaired, proved to be one line, and compared with quadrature."""

import ast
import os
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import mpmath as mp
import pytest
import sympy as sp

from derive.declare.symbols import alpha, r, theta, theta_1, theta_2, theta_m
from derive.judge.appendices import (
    APPENDICES,
    APPENDIX_I,
    APPENDIX_II,
    REPAIRS,
    Appendix,
    ProofError,
    evaluate,
    integrates,
    numeric_check,
    parse,
    quadrature,
    real_arithmetic_fails,
    simplify,
    undo_each_repair,
)

ROOT = Path(__file__).parents[1]
each = pytest.mark.parametrize("appendix", APPENDICES, ids=lambda appendix: appendix.name)


def arc(start: str, end: str) -> tuple[mp.mpf, mp.mpf]:
    """Return degrees as radians, with digits to spare."""
    with mp.workdps(80):
        return mp.radians(mp.mpf(start)), mp.radians(mp.mpf(end))


PAPER = arc("215.2", "276.9")  # Table 2-1


@each
def test_proof(appendix: Appendix) -> None:
    proof = simplify(appendix)
    assert proof.expression.free_symbols == {alpha, theta_m}
    assert proof.operations_before > 600
    assert proof.operations_after < 10
    assert proof.steps[0].operations == proof.operations_before
    assert proof.steps[-1].operations == proof.operations_after
    assert all(step.text for step in proof.steps)
    assert proof.seconds < 5


def test_what_they_integrate() -> None:
    assert simplify(APPENDIX_I).integrand == APPENDIX_I.claim == r * -sp.sin(theta)  # (2.23) as claimed
    assert APPENDIX_II.claim == r**2 * -sp.cos(theta)  # (3.13) is claimed ...
    assert simplify(APPENDIX_II).integrand == r * -sp.cos(theta)  # ... but r is integrated, not r^2
    assert not integrates(simplify(APPENDIX_II).expression, APPENDIX_II.claim)


def test_table_4_1_shows_appendix_ii() -> None:
    # Table 4-1 prints J_theta = 0.0387, which is Appendix II and not the definition (3.13).
    assert mp.nstr(evaluate(APPENDIX_I, *PAPER).real, 3) == "0.087"
    assert mp.nstr(evaluate(APPENDIX_II, *PAPER).real, 3) == "0.0387"
    assert mp.nstr(quadrature(APPENDIX_II.claim, *PAPER), 3) == "0.0365"


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
    check = numeric_check(appendix, *arc(start, end))
    assert check.relative_difference < mp.mpf(10) ** -50
    assert check.branch == branch
    assert (abs(check.printed.imag) > mp.mpf(10) ** -50) == (branch != 0)


def test_quadrature_does_not_depend_on_the_proof() -> None:
    # C_theta (3.13) by an independent rule: adaptive in both directions, at double precision.
    start, end = (float(x) for x in PAPER)
    half = (end - start) / 2
    value = mp.quad(
        lambda angle: mp.quad(
            lambda radius: -(radius**2) * mp.cos(angle), [mp.cos(half) / mp.cos(angle - start - half), 1]
        ),
        [start, end],
    )
    assert abs(quadrature(APPENDIX_II.claim, *PAPER) - value) < 1e-14


@each
def test_every_repair_is_needed(appendix: Appendix) -> None:
    for repair, error in undo_each_repair(appendix, *PAPER):
        if repair.kind == "bracket":
            assert error is None, repair  # cannot be parsed
        else:
            assert error is not None, repair
            assert error > 1e-2, repair  # parsed, but not the integral


@each
def test_brackets_alone_do_not_give_the_integral(appendix: Appendix) -> None:
    literal = replace(appendix, repairs=tuple(repair for repair in appendix.repairs if repair.kind == "bracket"))
    integral = quadrature(simplify(appendix).integrand, *PAPER)
    assert abs(evaluate(literal, *PAPER).real / integral - 1) > 1e-2


def test_repairs_are_few_and_explained() -> None:
    count = {(name, kind): 0 for name in ("I", "II") for kind in ("bracket", "reading")}
    for repair in REPAIRS:
        count[repair.appendix, repair.kind] += 1
        assert repair.why
    assert count == {("I", "bracket"): 4, ("I", "reading"): 5, ("II", "bracket"): 3, ("II", "reading"): 7}


@each
def test_repairs_add_brackets_and_nothing_else(appendix: Appendix) -> None:
    for repair in appendix.repairs:
        assert re.sub("[()]", "", repair.printed) == re.sub("[()]", "", repair.repaired)


@each
def test_final_division_is_of_the_whole_bracket(appendix: Appendix) -> None:
    # Closing the bracket at the very end instead, so that only the last term is divided, can be parsed too.
    others = tuple(repair for repair in appendix.repairs if not repair.printed.endswith("/(-cos(theta_1)"))
    late = replace(appendix, printed=appendix.printed.rstrip() + ")", repairs=others)
    integral = quadrature(simplify(appendix).integrand, *PAPER)
    assert abs(evaluate(late, *PAPER).real / integral - 1) > 1e-2


def test_repair_must_apply_as_declared() -> None:
    wrong = replace(APPENDIX_I.repairs[0], of=9)
    with pytest.raises(ValueError, match="has 8 places, not 9"):
        parse(replace(APPENDIX_I, repairs=(wrong,)))
    with pytest.raises(ValueError, match="overlap"):
        parse(replace(APPENDIX_I, repairs=APPENDIX_I.repairs + APPENDIX_I.repairs[:1]))


@each
def test_flipped_signs_are_found(appendix: Appendix) -> None:
    text = " ".join(appendix.printed.split())
    # A sign inside the text of a repair would stop the repair; every other sign is left to the proof.
    guarded = {
        place
        for repair in appendix.repairs
        for match in re.finditer(re.escape(repair.printed), text)
        for place in range(*match.span())
    }
    signs = [match.start() + 1 for match in re.finditer(" [-+] ", text) if match.start() + 1 not in guarded]
    assert len(signs) > 40
    for place in signs[::3]:
        flipped = text[:place] + {"+": "-", "-": "+"}[text[place]] + text[place + 1 :]
        with pytest.raises(ProofError):
            simplify(replace(appendix, printed=flipped))


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("2 cos(alpha)^4 arctanh(", "3 cos(alpha)^4 arctanh("),
        ("- sin(alpha) cos(alpha)^2 sin(theta_1)", ""),
        ("+ cos(alpha)}/{sin(theta_1)}", "- cos(alpha)}/{sin(theta_1)}"),
    ],
)
def test_planted_misprints_are_found(old: str, new: str) -> None:
    text = " ".join(APPENDIX_I.printed.split())
    assert old in text
    with pytest.raises(ProofError):
        simplify(replace(APPENDIX_I, printed=text.replace(old, new, 1)))


@pytest.mark.parametrize("n", [1, 2, 3])
@pytest.mark.parametrize("weight", [-sp.sin(theta), -sp.cos(theta)])
def test_integrates_accepts_one_integrand_only(n: int, weight: sp.Expr) -> None:
    proof = simplify(APPENDIX_I)
    assert integrates(proof.expression, r**n * weight) == (r**n * weight == proof.integrand)
    assert not integrates(proof.expression + sp.sin(theta_m), r**n * weight)
    assert not integrates(2 * proof.expression, r**n * weight)


@each
@pytest.mark.parametrize(
    ("start", "end", "fails"), [("215.2", "276.9", True), ("100", "140", True), ("285", "330", False)]
)
def test_real_arithmetic(appendix: Appendix, start: str, end: str, fails: bool) -> None:
    start_, end_ = arc(start, end)
    assert bool(real_arithmetic_fails(appendix).subs(theta_m, float(start_ + end_) / 2)) == fails
    values = {theta_1: float(start_), theta_2: float(end_), alpha: float(end_ - start_) / 2}
    arguments = [atom.args[0].subs(values) for atom in parse(appendix).atoms(sp.atanh)]
    assert [bool(abs(x) > 1) for x in arguments] == [fails, fails]


def test_same_output_under_any_hash_seed() -> None:
    code = (
        "from derive.judge.appendices import *\n"
        "for a in APPENDICES:\n"
        "    p = simplify(a)\n"
        "    print(parse(a), p.expression, p.integrand, p.steps, real_arithmetic_fails(a), sep='\\n')\n"
    )
    outputs = [
        subprocess.run(
            [sys.executable, "-c", code],
            cwd=ROOT,
            env=os.environ | {"PYTHONHASHSEED": seed},
            capture_output=True,
            check=True,
            text=True,
        ).stdout
        for seed in ("1", "2")
    ]
    assert outputs[0] == outputs[1]
    assert "cos(alpha)**2*atanh(sin(alpha))" in outputs[0]


def test_imports() -> None:
    tree = ast.parse((ROOT / "derive" / "judge" / "appendices.py").read_text())
    modules = {node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    modules |= {name.name for node in ast.walk(tree) if isinstance(node, ast.Import) for name in node.names}
    outside = {module for module in modules if module and module.split(".")[0] not in sys.stdlib_module_names}
    assert outside == {"sympy", "mpmath", "derive.declare.symbols"}
