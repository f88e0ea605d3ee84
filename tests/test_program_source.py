"""The text of programs: what is written is what the program does, in Python and in C, or nothing is written."""

import ast
import re
from dataclasses import replace

import numpy as np
import pytest

from derive.approximate.programs import variants
from derive.check.proof import ProofError
from derive.code import emit, operations, text
from derive.generate import emit_c


@pytest.mark.parametrize("kind", ["number", "sign", "order", "operation"])
def test_a_text_that_does_something_else_is_refused(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """One number's last bit, a sign, the order of two operands, or another operation."""
    wrong = {
        "number": (r"1\.5707963267948966", "1.5707963267948968"),
        "sign": (r"(\w+) \* alpha", r"-\1 * alpha"),
        "order": (r"([\d.]+) - alpha", r"alpha - \1"),
        "operation": (r" \* alpha", " + alpha"),
    }[kind]
    moment = next(v for v in variants() if (v.kernel, v.form) == ("polar_moment", "numpy"))
    emit.PythonText().body(moment.program)
    right = text.Reader.check

    def planted(self: text.Reader, program: object, name: str, written: str) -> None:
        changed, count = re.subn(*wrong, written)
        assert count
        right(self, program, name, changed)  # type: ignore[arg-type]

    monkeypatch.setattr(text.Reader, "check", planted)
    with pytest.raises(ProofError, match=r"text that was written: found .* wanted"):
        emit.PythonText().body(moment.program)


def test_a_helper_that_does_something_else_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """The function `horner` of the generated modules must perform the certified operations."""
    right = operations.HORNER
    monkeypatch.setattr(emit, "HORNER", lambda x, coefficients: right(x, coefficients[::-1]))
    moment = next(v for v in variants() if (v.kernel, v.form) == ("polar_moment", "numpy"))
    with pytest.raises(ProofError, match=r"text that was written: found .* wanted"):
        emit.PythonText().body(moment.program)


@pytest.mark.parametrize("form", emit_c.FORMS)
def test_c_that_does_something_else_is_refused(form: str, monkeypatch: pytest.MonkeyPatch) -> None:
    chosen = next(v for v in variants() if (v.kernel, v.form, v.tier) == ("radial_weight_amplitude", form, "best"))
    emit_c.CText(form).functions("kernel", chosen.program)
    monkeypatch.setattr(emit_c, "C", replace(emit_c.C, number=lambda x: float(np.nextafter(x, 2)).hex()))
    with pytest.raises(ProofError, match=r"text that was written: found .* wanted"):
        emit_c.CText(form).functions("kernel", chosen.program)


@pytest.mark.parametrize(
    ("value", "width"),
    [
        ("x" * 150, 160),
        (f"'{'x' * 150}'", 162),
        (f"'{'x' * 80}/{'y' * 80}'", 120),
        (f"'{'word ' * 40}'", 120),
        (f"{'x' * 90} * {'y' * 90}", 120),
        (f"f({'x' * 90}, {'y' * 90})", 120),
    ],
)
def test_a_long_line_is_broken_where_it_can_be(value: str, width: int) -> None:
    line = f"first = ({value})"
    lines = emit.wrapped(line).split("\n")
    assert ast.dump(ast.parse("\n".join(lines))) == ast.dump(ast.parse(line))
    assert max(map(len, lines)) <= width
