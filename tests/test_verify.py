"""The judge of the paper: complete, reaching every known verdict, and moved by the claim and nothing else."""

import json
import os
import re
import subprocess
import sys
from collections import Counter
from dataclasses import replace
from pathlib import Path

import mpmath as mp
import pytest

from derive.judge.appendices import repaired_text
from derive.judge.evidence import context
from derive.judge.paper import CLAIMS, VERDICTS, Claim
from derive.judge.verify import KEYS, Row, judge, report, rows

ROOT = Path(__file__).parents[1]
BY_ID = {claim.id: claim for claim in CLAIMS}
HOLDS = {"holds", "holds to the printed digits"}

# Claims that fail: verdict, what is computed, and the cause, as patterns.
FAILING = {
    "(1.2)": ("imprecise", "", "variable that is also a limit"),
    "(1.14)": ("assumption", "drive", "postulated"),
    "(2.1)": ("assumption", r"8\.248", "scalars"),
    "(2.7)": ("imprecise", "", "variable that is also a limit"),
    "(2.9)": ("assumption", r"50\.8", "undetermined"),
    "(2.23)": ("imprecise", "", "R_1"),
    "(2.25)": ("assumption", r"30\.99", "slow"),
    "(2.26)": ("assumption", r"5\.725", "J_r"),
    "Table 2-1 A": ("wrong", r"^0\.60855", r"2 alpha.*0\.46776"),
    "(3.5)": ("assumption", r"-0\.505", "uniform mu"),
    "Fig. 3-2": ("wrong", r"-0\.3651", "sin"),
    "(3.20)": ("misprint", r"tanh\(t sqrt\(a b\)\)", "root"),
    "(4.1)": ("wrong", r"^0\.419214", r"Appendix II.*0\.44418"),
    "Sect. 4 phi_eq": ("wrong", r"^22\.744", r"dip of the chord: 23\.95"),
    "Sect. 4 phi_res": ("not machine-checkable", "-", "measured"),
    "Table 4-1 Theta*": ("wrong", r"^0\.0876854", r"2 alpha.*0\.43759"),
    "Table 4-1 J_theta": ("wrong", r"^0\.0364917", r"Appendix II.*0\.038665"),
    "Table 4-1 A": ("wrong", r"^0\.60855", r"2 alpha.*0\.46776"),
    "Table 4-1 phi_C,eq": ("wrong", r"^22\.744", r"dip of the chord: 23\.95"),
    "(4.2) c0": ("wrong", r"^0\.092192", r"0\.11042"),
    "(4.2) c2": ("wrong", r"^0\.017189", r"0\.003171"),
    "(4.4)": ("imprecise", r"O\(t\^3\)", "odd"),
    "(4.4) c1": ("wrong", r"^137\.606", r"164\.82"),
    "(4.5)": ("misprint", r"c1 log\(cosh\(c2 t\)\)/c2", "length"),
    "Appendix I": ("misprint", "671 operations -> 9", "brackets"),
    "Appendix II": ("wrong", "744 operations -> 9", r"integrates -r cos\(theta\), not -r\^2 cos\(theta\): 0\.038665"),
}


@pytest.fixture(scope="module")
def judged() -> dict[str, Row]:
    return {row.id: row for row in rows()}


def altered(name: str, printed: str | None = None, expression: str | None = None) -> Row:
    claim = BY_ID[name]
    return judge(replace(claim, printed=printed or claim.printed, expression=expression or claim.expression))


# --- completeness ----------------------------------------------------------------------------------------


def test_every_equation_entry_and_appendix_is_there() -> None:
    numbered = [f"({s}.{k})" for s, last in ((1, 14), (2, 27), (3, 21), (4, 5)) for k in range(1, last + 1)]
    assert len(numbered) == 67
    assert [c.id for c in CLAIMS if re.fullmatch(r"\(\d\.\d+\)", c.id)] == numbered  # in the paper's order, each once
    entries = [c.id for c in CLAIMS if c.id.startswith("Table ")]
    assert Counter(x[:9] for x in entries) == {"Table 2-1": 9, "Table 4-1": 7}
    assert [c.id for c in CLAIMS if c.id.startswith("App")] == ["Appendix I", "Appendix II"]
    assert len(BY_ID) == len(CLAIMS)


def test_every_verdict_is_reached_and_no_other(judged: dict[str, Row]) -> None:
    assert {row.verdict for row in judged.values()} == set(VERDICTS)
    assert {row.id for row in judged.values() if row.verdict not in HOLDS} == set(FAILING)


@pytest.mark.parametrize("name", FAILING)
def test_what_fails_and_why(judged: dict[str, Row], name: str) -> None:
    verdict, computed, cause = FAILING[name]
    assert judged[name].verdict == verdict
    assert re.search(computed, judged[name].computed)
    assert re.search(cause, judged[name].cause)


@pytest.mark.parametrize(
    "name",
    ["2-1 R", "2-1 gamma", "2-1 theta_10", "2-1 theta_20", "2-1 I_p", "2-1 sigma_ref", "2-1 sigma_n0", "4-1 J_r",
     "4-1 lambda", "4-1 sigma*_n0"],
)  # fmt: skip
def test_entries_that_hold(judged: dict[str, Row], name: str) -> None:
    assert judged[f"Table {name}"].verdict == "holds to the printed digits"


# --- mutability ------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "digits"),
    [("Table 4-1 Theta*", "0.0877"), ("Table 4-1 Theta*", "0.08769"), ("Table 4-1 J_theta", "0.0365"),
     ("Table 2-1 A", "0.6086"), ("Table 4-1 A", "0.609"), ("(4.1)", "0.42"), ("Table 4-1 phi_C,eq", "22.7"),
     ("(4.2) c0", "0.0922"), ("(4.2) c2", "0.0172"), ("(4.4) c1", "138")],
)  # fmt: skip
def test_the_right_number_holds(name: str, digits: str) -> None:
    assert altered(name, digits).verdict == "holds to the printed digits"


@pytest.mark.parametrize(
    ("name", "digits"),
    [("Table 4-1 lambda", "0.1525"), ("Table 4-1 lambda", "0.1522"), ("Table 2-1 I_p", "0.310"),
     ("Table 2-1 I_p", "0.3080"), ("Table 2-1 sigma_ref", "4.225"), ("Table 4-1 J_r", "0.0872")],
)  # fmt: skip
def test_a_number_off_by_a_unit_is_wrong(name: str, digits: str) -> None:
    row = altered(name, digits)
    assert (row.verdict, row.cause) == ("wrong", "cause not found")


@pytest.mark.parametrize("claim", [c for c in CLAIMS if c.kind == "number"], ids=lambda c: c.id)
def test_every_number_can_be_wrong(claim: Claim) -> None:
    row = judge(replace(claim, printed=str(float(claim.printed) * 1.5)))
    assert (row.verdict, row.cause) == ("wrong", "cause not found")


@pytest.mark.parametrize(
    ("name", "form"),
    [("(1.2)", "theta_1 + Integral(omega_of(u), (u, 0, t))"), ("(2.23)", "body_star(-r*sin(theta))"),
     ("(3.20)", "sqrt(a/b)*tanh(sqrt(a*b)*t)"), ("(4.4)", "c1*tanh(c2*t); c1*c2*t; O(t**3)"),
     ("(4.5)", "c1/c2*log(cosh(c2*t)); c1/c2*(c2*t)**2/2; O(t**4)"),
     ("(3.15)", "alpha/2 - sin(2*alpha)/6 - sin(4*alpha)/24"),
     ("(2.19)", "(2*alpha - sin(alpha)*cos(alpha) - cos(alpha)**3*atanh(sin(alpha)))/3")],
)  # fmt: skip
def test_the_right_form_holds(name: str, form: str) -> None:
    assert altered(name, "mended", form).verdict == "holds"


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [("(1.8)", "-r", "r"), ("(1.11)", "-g*sin", "g*sin"), ("(2.3)", "ell*r", "ell*r**2"),
     ("(2.6)", "alpha)/", "2*alpha)/"),
     ("(2.12)", "1 - ", "1 + "), ("(2.19)", "- log", "+ log"), ("(2.20)", "omega_star**2", "omega_star"),
     ("(2.26)", "A*", "2*A*"), ("(3.2)", "r**3", "r**2"), ("(3.8)", "2*alpha", "alpha"), ("(3.9)", "R/g", "g/R"),
     ("(3.11)", "*mu", "/mu"), ("(3.13)", "r**2", "r"), ("(3.14)", "2*alpha*f", "alpha*f"),
     ("(3.15)", "1 + 2", "1 - 2"),
     ("(3.17)", "- J_r", "+ J_r"), ("(3.18)", "lam*", ""), ("(3.20)", "a/b", "b/a"),
     ("(3.21)", "J_theta/J_r", "J_r/J_theta"),
     ("(4.2)", "c2*t", "t"), ("(4.3)", "c0/c2", "c0"), ("(4.4)", "t**2", "t**4"), ("(4.5)", "c1*", "c1**2*"),
     ("(4.5)", "t**4", "t**6")],
)  # fmt: skip
def test_a_wrong_form_is_wrong(name: str, old: str, new: str) -> None:
    assert old in BY_ID[name].expression
    row = altered(name, "spoilt", BY_ID[name].expression.replace(old, new, 1))
    assert (row.verdict, row.cause) == ("wrong", "cause not found")


@pytest.mark.parametrize("claim", [c for c in CLAIMS if c.kind == "form" and c.expression], ids=lambda c: c.id)
def test_every_form_can_be_wrong(claim: Claim) -> None:
    head, *rest = claim.expression.split(";")
    row = judge(replace(claim, expression=";".join([f"1 + {head}", *rest])))
    assert (row.verdict, row.cause) == ("wrong", "cause not found")


def test_appendix_against_what_it_integrates() -> None:
    assert altered("Appendix II", expression="-r*cos(theta)").verdict == "misprint"  # its brackets are still missing
    assert altered("Appendix I", expression="-r**2*sin(theta)").verdict == "wrong"


@pytest.mark.parametrize(("name", "expression"), [("Appendix I", "-r*sin(theta)"), ("Appendix II", "-r*cos(theta)")])
def test_mended_appendix_holds(name: str, expression: str) -> None:
    subject = BY_ID[name].subject
    assert subject is not None
    mended = replace(subject, printed=repaired_text(subject), repairs=())
    assert judge(replace(BY_ID[name], expression=expression, subject=mended)).verdict == "holds"
    spoilt = replace(mended, printed=mended.printed.replace("2 cos(alpha)^3", "3 cos(alpha)^3", 1))
    assert judge(replace(BY_ID[name], expression=expression, subject=spoilt)).verdict == "wrong"


def test_ranges_move() -> None:
    assert altered("Fig. 3-2", expression="-1/2; 1/2").verdict == "holds"
    assert altered("Fig. 2-3", expression="-1/100; 1/100").verdict == "wrong"
    assert altered("Fig. 2-2", expression="1/2; 10").verdict == "wrong"


def test_a_postulate_without_effect_is_no_assumption() -> None:
    assert judge(replace(BY_ID["(2.26)"], size=lambda c: mp.mpf(0))).verdict == "holds"


def test_a_claim_without_anything_to_check_does_not_hold() -> None:
    assert judge(Claim("x", "x", "x")).verdict == "not machine-checkable"


# --- evidence --------------------------------------------------------------------------------------------


def test_vector_balance_by_adding_up_forces() -> None:
    # Horizontal and vertical components of a uniform pressure and of the weight, over R and rho g R^2 ell.
    c = context()
    start, middle, end = c.theta_1, c.theta_1 + c.alpha, c.theta_1 + 2 * c.alpha
    push = [mp.quad(lambda x, f=f: -f(x), [start, middle, end]) for f in (mp.cos, mp.sin)]
    area = mp.quad(lambda x: (1 - (mp.cos(c.alpha) / mp.cos(x - middle)) ** 2) / 2, [start, middle, end])
    along = mp.matrix([mp.cos(middle), mp.sin(middle)])
    pressure = area * along[1] / (push[0] * along[0] + push[1] * along[1])
    scalar = c.moment("radial_weight") / (2 * c.alpha)
    assert abs(pressure / scalar - 1 - c.vector_balance) < 1e-12


def test_friction_force_does_not_ask_for_uniform_stress() -> None:
    c = context()
    assert abs(mp.quad(c.column, [-c.alpha, 0, c.alpha]) / (2 * c.alpha) - 1) < 1e-12


# --- reports ---------------------------------------------------------------------------------------------


def command(*options: str, seed: str = "0") -> str:
    done = subprocess.run(
        [sys.executable, "-m", "derive", "verify", *options],
        cwd=ROOT,
        env=os.environ | {"PYTHONHASHSEED": seed},
        capture_output=True,
        check=True,
        text=True,
    )
    return done.stdout


def test_json_is_valid_and_the_same_under_any_hash_seed() -> None:
    first, second = (command("--json", seed=seed) for seed in ("1", "2"))
    assert first == second
    found = json.loads(first)
    assert len(found) == len(CLAIMS)
    for entry, claim in zip(found, CLAIMS, strict=True):
        assert tuple(entry) == KEYS == ("id", "claim", "printed", "computed", "verdict", "cause")
        assert all(isinstance(x, str) for x in entry.values())
        assert (entry["id"], entry["printed"]) == (claim.id, claim.printed)
        assert entry["computed"]
    printed = {entry["id"]: entry["printed"] for entry in found}
    assert printed["Table 4-1 J_r"] == "0.0870"


def test_numbers_have_six_digits_or_more(judged: dict[str, Row]) -> None:
    for claim in CLAIMS:
        if claim.kind == "number":
            digits = [x.replace(".", "").lstrip("0") for x in re.findall(r"\d+\.\d+", judged[claim.id].computed)]
            assert digits, claim.id
            assert all(len(x) >= 6 for x in digits), claim.id


def test_table_fits_a_terminal() -> None:
    lines = report("table").splitlines()
    assert max(map(len, lines)) <= 100
    total = " ".join(lines)
    assert f"{len(CLAIMS)} claims: " in total
    assert all(verdict in total for verdict in VERDICTS)


def test_markdown_is_a_page(judged: dict[str, Row]) -> None:
    page = report("markdown")
    assert page.startswith("# ")
    first, everything = page.split("## All claims")
    rows_of = [[x for x in part.splitlines() if x.startswith("| ")] for part in (first, everything)]
    assert [len(x) - 2 for x in rows_of] == [len(FAILING), len(CLAIMS)]
    assert all(len(re.findall(r"(?<!\\)\|", line)) == 7 for part in rows_of for line in part)


def test_unknown_form_is_an_error() -> None:
    with pytest.raises(KeyError):
        report("prose")
