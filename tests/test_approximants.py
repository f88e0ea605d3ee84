"""The fitted programs: which there are, their exact arithmetic, and their shapes. What they hold is proved and seen."""

from fractions import Fraction
from itertools import product

import numpy as np
import pytest

from derive.approximate.programs import variants
from derive.approximate.shapes import Kernel, stated_shape
from derive.check.proof import ProofError
from derive.code import operations
from derive.declare.quantities import HIGHEST, TURNS, Moment
from derive.declare.symbols import r, theta


def test_no_logarithm_but_in_numpy_s_forms_and_no_fused_operation_but_in_fused_ones() -> None:
    for v in variants():
        assert any(op.kind == "log" for op in v.program.ops) == (v.form == "numpy")
        assert any(op.kind in ("fma", "fused_horner") for op in v.program.ops) == (v.form == "fused")
        assert v.program.operations()["div"] <= (3 if v.tier == "best" else 1)


def test_multiply_add_is_rounded_once() -> None:
    """Against fractions: where terms cancel, where they underflow, and the sign of zero."""
    rng = np.random.default_rng(5)
    a, b = rng.normal(size=(2, 4000)) * 2.0 ** rng.integers(-530, 30, (2, 4000))
    c = -a * b * (1 + rng.integers(-3, 4, 4000) * 2.0 ** -rng.integers(0, 60, 4000))
    exact = [Fraction(x) * Fraction(y) + Fraction(z) for x, y, z in np.stack([a, b, c], axis=1).tolist()]
    np.testing.assert_array_equal(operations.fma(a, b, c), list(map(float, exact)))
    zero = np.array([0.0, -0.0])
    for added, negative in ((-zero, [False, False]), (zero, [False, True])):
        np.testing.assert_array_equal(np.signbit(operations.fma(zero, np.ones(2), added)), negative)


def test_exponent_and_significand_are_exact() -> None:
    x = np.exp2(np.random.default_rng(6).uniform(-60, 3, 1000))
    np.testing.assert_array_equal(np.ldexp(operations.significand(x), operations.exponent(x).astype(int)), x)
    assert operations.significand(x).min() >= 0.75
    assert operations.significand(x).max() < 1.5


def test_every_weight_that_may_be_declared_has_a_shape() -> None:
    """Certificates prove the bounds of declared moments, and `python -m tests.campaigns.all_weights` proves all."""
    for n, turn in product(range(1, HIGHEST + 1), TURNS):
        amplitude = ("amplitude", "A") if turn.has(theta) else None
        moment = Moment("moment", "M", r**n * turn, "a moment", amplitude)
        shape = stated_shape(Kernel(moment.name, (), moment.definition))
        assert len(shape.best) == 1
        assert [tier for tier, *_ in shape.cheap][:2] == ["1e-10", "1e-6"]


def test_a_quotient_without_a_shape_is_refused_in_a_line() -> None:
    with pytest.raises(ProofError, match=r"^new: shape of r\^3 / r\^2: found none, wanted a line in shapes\.json$"):
        stated_shape(Kernel("new", (), ("r^3", "r^2")))
