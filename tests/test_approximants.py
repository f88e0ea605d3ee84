"""The fitted programs, run exactly, against quadrature of the raw definitions; what is proved is proved elsewhere."""

from dataclasses import replace
from fractions import Fraction
from functools import cache

import numpy as np
import oracle
import pytest
from flint import ctx
from numpy.typing import NDArray

from derive.approximate import search
from derive.approximate.programs import Variant, variants
from derive.approximate.shapes import HALF_PI, kernels, records
from derive.check.records import TIERS
from derive.code import operations
from derive.code.program import Op

Floats = NDArray[np.float64]

PLAIN = 5.0  # ulp
QUOTIENT = 1.25
FUSED = {"polar_moment": 0.9}  # others 1
THIN = ("polar_moment", "radial_weight_amplitude")  # 0.65 ulp up to pi/4
FLOAT32 = 0.505
SHAPES = {kernel.name: records()[kernel.definition].best for kernel in kernels()}
BASES = [name for name, shape in SHAPES.items() if len(shape) == 1]
TINY = np.array([5e-324, 1e-323, 1e-310, 1e-200, 1e-162, 1e-108, 1.1e-108, 1e-105, 1e-103, 1e-102])
every = pytest.mark.parametrize("v", variants(), ids=lambda v: f"{v.kernel}-{v.tier}-{v.form}")
BEST = [v for v in variants() if v.tier == "best"]
each_best = pytest.mark.parametrize("v", BEST, ids=lambda v: f"{v.kernel}-{v.form}")
each_base = pytest.mark.parametrize("v", [v for v in BEST if v.kernel in BASES], ids=lambda v: f"{v.kernel}-{v.form}")


def run(v: Variant, alpha: Floats) -> Floats:
    """Its values: rounded exactly, or, where it calls NumPy's logarithm, NumPy's."""
    return np.asarray(v.program.run(alpha))


def seams() -> list[float]:
    return sorted({part.seam for shape in SHAPES.values() for part in shape})


@cache
def angles() -> Floats:
    """All over the domain, and dense around the seams and at the end."""
    rng = np.random.default_rng(20241121)
    near_seams = [s + d for s in seams() for d in (-1e-9, -(2.0**-53), 0.0, 2.0**-52, 1e-9)]
    parts = (
        near_seams,
        rng.uniform(0, HALF_PI, 90),
        10 ** rng.uniform(-20, -1, 20),
        HALF_PI - 10 ** rng.uniform(-15, 0, 30),
        [HALF_PI, float(np.nextafter(HALF_PI, 0))],
    )
    found = np.unique(np.concatenate([np.asarray(p, dtype=np.float64) for p in parts]))
    return found[found <= HALF_PI]


def errors(v: Variant, alpha: Floats) -> Floats:
    """In ulp; of the tiers 1e-10 and 1e-6 relative."""
    kind = np.float32 if v.tier == "float32" else np.float64
    alpha = alpha.astype(kind).astype(np.float64)
    values = run(v, np.minimum(alpha, HALF_PI)).astype(kind)
    found = []
    for value, x in zip(values.tolist(), alpha.tolist(), strict=True):
        reference = oracle.kernel(v.kernel, x)
        if v.tier in ("1e-10", "1e-6"):
            with ctx.workprec(300):
                found.append(abs(float(oracle.exact(value) / reference - 1)))
        else:
            found.append(oracle.ulps(value, reference, kind=kind))
    return np.array(found)


def bound(v: Variant) -> float:
    if v.tier == "best":
        if v.kernel not in BASES and v.form == "fused":
            return QUOTIENT
        return FUSED.get(v.kernel, 1.0) if v.form == "fused" else PLAIN
    return FLOAT32 if v.tier == "float32" else float(v.tier)


def check(v: Variant) -> None:
    found = errors(v, angles())
    worst = int(np.argmax(found))
    assert found[worst] <= bound(v), f"{v.kernel}, {v.tier}, {v.form}: {found[worst]:.3g} at {angles()[worst]!r}"


@every
def test_accuracy(v: Variant) -> None:
    """Inside what the tier is to be proved for."""
    check(v)


@pytest.mark.parametrize("name", THIN)
def test_thin_arcs(name: str) -> None:
    """The functions with a logarithm hold 0.65 ulp up to pi/4."""
    (v,) = [v for v in variants() if (v.kernel, v.tier, v.form) == (name, "best", "fused")]
    assert errors(v, angles()[angles() <= np.pi / 4]).max() <= 0.65


@every
def test_start(v: Variant) -> None:
    """0 at 0, exactly, or the quotient's limit."""
    limit = {"dynamic_coefficient": 2 / 3}.get(v.kernel, 1.0) if v.kernel not in BASES else 0.0
    assert run(v, np.array([0.0]))[0] == limit


@each_base
def test_end(v: Variant) -> None:
    """At the double nearest to pi/2 the limit, rounded."""
    end = float(oracle.kernel(v.kernel, HALF_PI).mid().str(60, radius=False))
    assert run(v, np.array([HALF_PI]))[0] == end


@each_best
def test_tiny_angles_underflow_to_the_rounded_value(v: Variant) -> None:
    """To the nearest subnormal number or nearly so, as only the last product can underflow; no NaN, no infinity."""
    with np.errstate(over="raise", invalid="raise", divide="raise"):
        values = run(v, TINY)
    for value, x in zip(values.tolist(), TINY.tolist(), strict=True):
        assert oracle.ulps(value, oracle.kernel(v.kernel, x)) <= 0.6


@pytest.mark.parametrize("name", BASES)
def test_monotone_on_neighbouring_doubles(name: str) -> None:
    """Fused, a moment never falls from one double to the next: across its seam, and at the end, where C_r is flat."""
    (v,) = [v for v in variants() if (v.kernel, v.tier, v.form) == (name, "best", "fused")]
    for middle in (SHAPES[name][0].seam, 0.5, 1.4, 1.5707, HALF_PI):
        bits = np.float64(middle).view(np.int64) + np.arange(-2000, 2001)
        x = bits.view(np.float64)
        assert np.all(np.diff(run(v, x[x <= HALF_PI])) >= 0), f"{name} falls near {middle}"


@each_base
def test_no_fall_at_the_seam(v: Variant) -> None:
    """From the last double below it to the first one above."""
    seam = SHAPES[v.kernel][0].seam
    below, above = run(v, np.array([np.nextafter(seam, 0), seam]))
    assert above >= below


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


# --- planted bugs --------------------------------------------------------------------------------------------------


def _planted(v: Variant, old: Op, new: Op) -> Variant:
    ops = list(v.program.ops)
    ops[ops.index(old)] = new
    return replace(v, program=replace(v.program, ops=tuple(ops)))


def _inertia() -> Variant:
    return next(v for v in variants() if (v.kernel, v.tier, v.form) == ("moment_of_inertia", "best", "fused"))


def test_a_missing_low_part_is_seen() -> None:
    v, low = _inertia(), float(Fraction(2, 3) - Fraction(2 / 3))
    with pytest.raises(AssertionError, match="moment_of_inertia, best, fused"):
        check(_planted(v, Op("const", (), low), Op("const", (), 0.0)))


def test_a_coefficient_off_by_one_in_its_tenth_digit_is_seen() -> None:
    v = _inertia()
    (old,) = [op for op in v.program.ops if op.kind == "const" and round(float(op.value or 0), 12) == -0.4]
    with pytest.raises(AssertionError, match="moment_of_inertia, best, fused"):
        check(_planted(v, old, replace(old, value=float(old.value or 0) * (1 + 1e-10))))


def test_swapped_pieces_are_seen() -> None:
    v = _inertia()
    (old,) = [op for op in v.program.ops if op.kind == "select"]
    with pytest.raises(AssertionError, match="moment_of_inertia, best, fused"):
        check(_planted(v, old, replace(old, args=(old.args[0], old.args[2], old.args[1]))))


def test_a_seam_out_of_place_is_seen() -> None:
    """Both pieces end where they were fitted to."""
    v = _inertia()
    with pytest.raises(AssertionError, match="moment_of_inertia, best, fused"):
        check(_planted(v, Op("const", (), SHAPES[v.kernel][0].seam), Op("const", (), 0.8)))


# --- the search ----------------------------------------------------------------------------------------------------


FACTOR = next(kernel for kernel in kernels() if kernel.name == "resistance_factor")  # which takes least


def test_the_recorded_shape_is_what_the_search_finds() -> None:
    """Nothing in the search is random or timed."""
    assert search.search(FACTOR) == records()[FACTOR.definition]


@pytest.mark.parametrize(("more", "stays"), [(1, True), (6, False)])
def test_a_record_stays_unless_another_is_better_by_the_margin(
    more: int, stays: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A coefficient more is worth less than the margin, six are worth more; nothing found, it stays in any case."""
    right = records()[FACTOR.definition]
    (piece,) = right.best
    known = (replace(piece, count=piece.count + more),)
    monkeypatch.setitem(records(), FACTOR.definition, replace(right, best=known))
    assert (search.price(FACTOR, known) <= search.price(FACTOR, right.best) + search.MARGIN) == stays
    monkeypatch.setattr(search, "refined", lambda *_: right.best)
    assert search.best(FACTOR) == (known if stays else right.best)
    monkeypatch.setattr(search, "refined", lambda *_: None)
    assert search.best(FACTOR) == known
