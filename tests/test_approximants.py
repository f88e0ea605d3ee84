"""The fitted programs: which there are, their exact arithmetic, and the search. What they hold is proved and seen."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from derive.approximate import search
from derive.approximate.programs import variants
from derive.approximate.shapes import Kernel, kernels, records
from derive.check.records import TIERS
from derive.code import operations
from tests.support import oracle


def test_what_there_is() -> None:
    """Every kernel, tier and form once; no logarithm but in the numpy forms, no fused operation but in the fused."""
    found = variants()
    assert len({(v.kernel, v.tier, v.form) for v in found}) == len(found)
    assert {v.kernel for v in found if v.tier == "best"} == {*oracle.BASE, *oracle.QUOTIENTS}
    for tier in TIERS:
        for form in ("fused", "plain"):
            wanted = {*oracle.BASE, *(oracle.QUOTIENTS if tier == "best" else ())}
            assert {v.kernel for v in found if (v.tier, v.form) == (tier, form)} == wanted
    for v in found:
        assert any(op.kind == "log" for op in v.program.ops) == (v.form == "numpy")
        assert any(op.kind == "fma" for op in v.program.ops) == (v.form == "fused")
        assert v.program.operations()["div"] <= (3 if v.tier == "best" else 1)


def test_multiply_add_is_rounded_once() -> None:
    """Against fractions: where terms cancel, where they underflow, and the sign of zero."""
    rng = np.random.default_rng(5)
    a, b = rng.normal(size=2000) * 2.0 ** rng.integers(-30, 30, 2000), rng.normal(size=2000)
    c = -a * b * (1 + rng.integers(-3, 4, 2000) * 2.0 ** -rng.integers(0, 60, 2000))
    shrunk = 2.0 ** -rng.integers(0, 700, 2000)
    a, b, c = np.append(a, a * shrunk), np.append(b, b * shrunk), np.append(c, c * shrunk)
    expected = [float(Fraction(x) * Fraction(y) + Fraction(z)) for x, y, z in zip(*(v.tolist() for v in (a, b, c)))]  # noqa: B905
    np.testing.assert_array_equal(operations.fma(a, b, c), expected)
    zero = np.array([0.0, -0.0])
    np.testing.assert_array_equal(np.signbit(operations.fma(zero, np.ones(2), -zero)), [False, False])
    np.testing.assert_array_equal(np.signbit(operations.fma(zero, np.ones(2), zero)), [False, True])


def test_exponent_and_significand_are_exact() -> None:
    x = np.exp2(np.random.default_rng(6).uniform(-60, 3, 1000))
    np.testing.assert_array_equal(np.ldexp(operations.significand(x), operations.exponent(x).astype(int)), x)
    assert operations.significand(x).min() >= 0.75
    assert operations.significand(x).max() < 1.5


@pytest.fixture(scope="module")
def factor() -> Kernel:
    """The kernel whose search takes least."""
    return next(kernel for kernel in kernels() if kernel.name == "resistance_factor")


def test_the_recorded_shape_is_what_the_search_finds(factor: Kernel) -> None:
    """Nothing in the search is random or timed."""
    assert search.search(factor) == records()[factor.definition]


@pytest.mark.parametrize(("more", "stays"), [(1, True), (6, False)])
def test_a_record_stays_unless_another_is_better_by_the_margin(
    factor: Kernel, more: int, stays: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A coefficient more is worth less than the margin, six are worth more; nothing found, it stays in any case."""
    right = records()[factor.definition]
    (piece,) = right.best
    known = (replace(piece, count=piece.count + more),)
    monkeypatch.setitem(records(), factor.definition, replace(right, best=known))
    monkeypatch.setattr(search, "refined", lambda *_: right.best)
    assert search.best(factor) == (known if stays else right.best)
    monkeypatch.setattr(search, "refined", lambda *_: None)
    assert search.best(factor) == known
