"""The fitted programs: which there are, their exact arithmetic, and the search. What they hold is proved and seen."""

from fractions import Fraction

import numpy as np
import pytest

from derive.approximate import search
from derive.approximate.programs import variants
from derive.approximate.shapes import Kernel, kernels, recorded_shapes
from derive.check import midpoints
from derive.check.proof import ProofError
from derive.check.records import Record
from derive.code import operations


def test_no_logarithm_but_in_numpy_s_forms_and_no_fused_operation_but_in_fused_ones() -> None:
    for v in variants():
        assert any(op.kind == "log" for op in v.program.ops) == (v.form == "numpy")
        assert any(op.kind == "fma" for op in v.program.ops) == (v.form == "fused")
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


@pytest.fixture(scope="module")
def factor() -> Kernel:
    """Return the kernel whose search takes least."""
    return next(kernel for kernel in kernels() if kernel.name == "resistance_factor")


def test_degrees_that_round_wrongly_are_not_kept(factor: Kernel, monkeypatch: pytest.MonkeyPatch) -> None:
    """Though their bound is within the goal."""
    ((_, above, below),) = [row for row in recorded_shapes()[factor.definition].cheap if row[0] == "float32"]

    def rounds_wrongly(record: Record) -> list[str]:
        raise ProofError("float32: rounding", "one side", "the other")

    for hard, kept in ((lambda record: [], 2), (rounds_wrongly, 0)):
        monkeypatch.setattr(midpoints, "hard", hard)
        assert len(search.kept(factor, "float32", (above, below))) == kept


def test_the_recorded_shape_is_what_the_search_finds(factor: Kernel, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing in the search is random or timed. That its float32 form rounds correctly is a certificate."""
    rounded = list[Record]()
    monkeypatch.setattr(midpoints, "hard", rounded.append)
    assert search.search(factor) == recorded_shapes()[factor.definition]
    assert [(record["tier"], record["form"]) for record in rounded] == [("float32", "plain"), ("float32", "fused")]
