"""Scripts for Gappa, and, where it is installed, what it proves of certificates."""

import re
import shutil
from copy import deepcopy
from fractions import Fraction
from subprocess import CompletedProcess
from typing import Any

import numpy as np
import pytest

from derive.__main__ import main
from derive.approximate.programs import variants
from derive.check import gappa
from derive.check.records import Record, read
from derive.check.truth import TOP

CHEAP = [record for record in read() if record["tier"] != "best"]
RECORD = next(r for r in CHEAP if (r["kernel"], r["tier"], r["form"]) == ("resistance_factor", "1e-6", "fused"))
installed = pytest.mark.skipif(shutil.which("gappa") is None, reason="needs Debian's package gappa")


def evaluated(script: str, alpha: float) -> tuple[float, Fraction]:
    """Both values that a script defines, by Python: lines with a rounding once, the others exactly."""
    values: dict[str, Fraction] = {}
    for name, rounds, text in re.findall(r"^([vr]\d+)( double)?= ?(.*);$", script.replace(" = ", "= "), re.MULTILINE):
        formula = text.replace("double(alpha)", f"Fraction({alpha!r})")
        formula = re.sub(r"-?0x[0-9a-f.]+p[+-]\d+", lambda m: f"Fraction(float.fromhex({m[0]!r}))", formula)
        exact = eval(formula, {"Fraction": Fraction}, values)
        values[name] = Fraction(float(exact)) if rounds else exact
    last = max(int(name[1:]) for name in values)
    return float(values[f"v{last}"]), values[f"r{last}"]


@pytest.mark.parametrize("record", CHEAP[::5], ids=lambda r: f"{r['kernel']}-{r['tier']}-{r['form']}")
def test_a_script_is_the_program_of_the_certificate(record: Record) -> None:
    key = tuple(record[name] for name in ("kernel", "tier", "form"))
    (program,) = [v.program for v in variants() if (v.kernel, v.tier, v.form) == key]
    script = gappa.script(record)
    for alpha in (1e-3, 0.3, 1.1, 1.5):
        computed, exact = evaluated(script, alpha)
        assert computed == program.run(np.array([alpha]))[0]
        assert 0 < abs(Fraction(computed) / exact - 1) < 1e-12
    assert f"{{ v0 in [1b-320, {TOP.hex()}]" in script


def test_what_it_prints_is_read(monkeypatch: pytest.MonkeyPatch, tmp_path: Any) -> None:
    printed = "Results:\n  e in [-7b-105 {-4.2e-16, -2^(-51.1)}, 9b-111 {4.1e-16, 2^(-51)}]\n"
    monkeypatch.setattr(gappa, "FOLDER", tmp_path)
    for text, bound in ((printed, 4.2e-16 * gappa.MARGIN), ("some enclosures were not satisfied", np.inf)):
        done = CompletedProcess([], 0, text, "")
        monkeypatch.setattr("subprocess.run", lambda *_, done=done, **__: done)
        assert gappa.asked(RECORD, "") == bound


def test_where_it_is_not_installed_a_sentence_says_so(monkeypatch: pytest.MonkeyPatch, capsys: Any) -> None:
    monkeypatch.setattr(shutil, "which", lambda _: None)
    assert main(["prove", "--gappa"]) == 0
    assert capsys.readouterr().out.startswith("skipped: gappa is not installed")


def test_pieces_and_logarithms_are_undecided() -> None:
    best = next(r for r in read() if (r["kernel"], r["tier"]) == ("polar_moment", "best"))
    line, proved = gappa.compared(best)
    assert not proved
    assert "undecided: no formula for" in line


@installed
def test_gappa_proves_what_the_tier_promises(monkeypatch: pytest.MonkeyPatch, tmp_path: Any) -> None:
    monkeypatch.setattr(gappa, "FOLDER", tmp_path)
    line, proved = gappa.compared(RECORD)
    assert proved, line
    assert float(line.split()[-2]) < 2.0**-51
    (script,) = tmp_path.iterdir()
    assert script.read_text("utf-8") == gappa.script(RECORD)


@installed
def test_gappa_does_not_prove_a_wrong_program(monkeypatch: pytest.MonkeyPatch, tmp_path: Any) -> None:
    """The first coefficient of lambda is 1e-6 too large: the bound that is proved is above the promise."""
    monkeypatch.setattr(gappa, "FOLDER", tmp_path)
    wrong = deepcopy(RECORD) | {"bound": 1.0}
    place = max(k for k, (kind, *_) in enumerate(wrong["operations"]) if kind == "const")
    first = float.fromhex(wrong["operations"][place][2])
    wrong["operations"][place][2] = (first * (1 + 1e-6)).hex()
    line, proved = gappa.compared(wrong)
    assert not proved
    assert line.endswith("undecided")
