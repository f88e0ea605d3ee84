"""The compiled kernels: bits of exact arithmetic, NumPy's manners, and the accuracy that is asked for."""

import inspect
import math
import pickle
import tracemalloc
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from derive.approximate.programs import Variant, variants, variants_of_ends
from derive.code.text import seam
from generated import _compiled, kernels, tiers
from tests.support.kernels import COMPILED, FITTED, LEVELS, needs_binary

Floats = NDArray[np.float64]

HALF_PI = np.pi / 2
PROVED = [
    (name, tier, form) for name, tiers_of in tiers.BOUNDS.items() for tier, forms in tiers_of.items() for form in forms
]
COMPILED_KEYS = [key for key in PROVED if key[2] != "numpy"]
each_variant = pytest.mark.parametrize("key", [key for key in COMPILED_KEYS if key[0] in FITTED], ids="-".join)
of_both_ends = pytest.mark.parametrize("key", [key for key in COMPILED_KEYS if key[0] not in FITTED], ids="-".join)
each_level = pytest.mark.parametrize("level", list(LEVELS))


# --- bit for bit ---------------------------------------------------------------------------------------------------


@cache
def fitted() -> dict[tuple[str, str, str], Variant]:
    """Return every program by its kernel, tier and form."""
    return {(v.kernel, v.tier, v.form): v for v in (*variants(), *variants_of_ends())}


@cache
def points() -> Floats:
    """2,500 half angles: uniform in value and in bit patterns, dense at both ends, at pi/2 and at 0 exactly."""
    rng = np.random.default_rng(20240901)
    patterns = rng.integers(1, np.float64(HALF_PI).view(np.int64), 400).view(np.float64)
    parts = (
        [0.0, 5e-324, 1e-310, HALF_PI, np.nextafter(HALF_PI, 0), np.nextafter(HALF_PI, 2), np.pi / 4, 1.0],
        rng.uniform(0, HALF_PI, 1300), patterns,
        10 ** rng.uniform(-12, 0, 400), HALF_PI - 10 ** rng.uniform(-16, 0, 392),
    )  # fmt: skip
    found = np.concatenate([np.asarray(p) for p in parts])
    assert found.size == 2500
    return found


def bits(x: NDArray[Any]) -> NDArray[Any]:
    return x.view(f"u{x.itemsize}")


@needs_binary
@each_variant
def test_the_same_bits_as_exact_arithmetic(key: tuple[str, str, str]) -> None:
    """Results have the bits of exact arithmetic on 2,500 points, at every level that runs the program."""
    variant = fitted()[key]
    single = variant.tier == "float32"
    alpha = points().astype(np.float32) if single else points()
    with np.errstate(all="ignore"):
        expected = variant.program.run(np.minimum(alpha.astype(float), HALF_PI)).astype(alpha.dtype)
    order = np.argsort(alpha)  # whole blocks below a seam, and above
    pieces = seam(variant.program)
    around = np.repeat(np.nextafter(pieces[0], [0, pieces[0], 9]) if pieces else [], 128)
    at_seam = variant.program.run(around)
    for form, loops in (LEVELS[x] for x in COMPILED):
        if form == variant.form:
            loop = loops["best" if single else variant.tier][variant.kernel]
            np.testing.assert_array_equal(bits(loop(alpha)), bits(expected))
            np.testing.assert_array_equal(bits(loop(alpha[order])), bits(expected[order]))
            np.testing.assert_array_equal(bits(loop(around)), bits(at_seam))


@needs_binary
@of_both_ends
def test_the_same_bits_of_both_ends(key: tuple[str, str, str]) -> None:
    """Results have the same bits at every level, also with one end for all arcs, and by NumPy's plain program."""
    variant = fitted()[key]
    single = variant.tier == "float32"
    kind = np.float32 if single else np.float64
    rng = np.random.default_rng(20241124)
    one = np.concatenate([rng.uniform(-7, 7, 3000), rng.uniform(-6e4, 6e4, 500), -(10 ** rng.uniform(-9, 0, 500))])
    two = one + rng.uniform(0, 3.14, one.size)
    two[3500:] = np.pi + one[3500:]
    one, two = one.astype(kind), two.astype(kind)
    with np.errstate(all="ignore"):
        expected = variant.program.run(one.astype(float), two.astype(float)).astype(kind)
        spread = variant.program.run(np.full(40, 4.0), np.linspace(4, 7, 40).astype(kind).astype(float)).astype(kind)
    for form, loops in (LEVELS[x] for x in COMPILED):
        if form == variant.form:
            loop = loops["best" if single else variant.tier][variant.kernel]
            np.testing.assert_array_equal(bits(loop(one, two)), bits(expected))
            np.testing.assert_array_equal(bits(loop(kind(4.0), np.linspace(4, 7, 40).astype(kind))), bits(spread))
    if variant.form == "plain" and (variant.kernel, variant.tier, "numpy") not in fitted():
        text = kernels.TEXTS[variant.kernel][variant.tier]
        np.testing.assert_array_equal(bits(text(one.astype(float), two.astype(float)).astype(kind)), bits(expected))


# --- NumPy's manners -----------------------------------------------------------------------------------------------


def kernel(name: str, level: str) -> Callable[..., Any]:
    """Return a kernel as the public function calls it, at one level."""
    return _compiled.kernel(name, kernels.TEXTS[name], level)


def everywhere(dtype: type[np.floating[Any]], size: int = 20000) -> NDArray[Any]:
    """Random half angles inside the domain, a few outside; more than two blocks."""
    alpha = np.random.default_rng(5).uniform(0, HALF_PI, size).astype(dtype)
    alpha[[3, 8191, 8192, size - 1]] = [-1.0, np.nan, 2.0, np.inf]
    return alpha


@each_level
@pytest.mark.parametrize("name", FITTED)
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_every_memory_layout_gives_the_same_numbers(name: str, level: str, dtype: type[np.floating[Any]]) -> None:
    """Strides of every kind, other byte orders, unaligned, in place, overlapping, `out`, `where`: the same numbers."""
    function, alpha = kernel(name, level), everywhere(dtype)
    equal, size = np.testing.assert_array_equal, alpha.size
    with np.errstate(all="raise", invalid="ignore"):
        expected = function(alpha.copy())
        assert expected.dtype == dtype
        equal(np.isnan(expected), ~((alpha >= 0) & (alpha <= 1.6)))
        equal([function(x) for x in alpha[:100]], expected[:100])  # one by one: the same bits
        same: list[Callable[[NDArray[Any]], NDArray[Any]]] = [
            lambda x: x[::-1], lambda x: x[-5:5:-3], lambda x: x.reshape(100, 200).T,
            lambda x: np.broadcast_to(x[:7], (3, 7)), lambda x: x.astype(dtype().dtype.newbyteorder()),
            lambda x: np.frombuffer(b"x" + x.tobytes(), dtype=dtype, offset=1),
        ]  # fmt: skip
        for arranged in same:
            equal(function(arranged(alpha)), arranged(expected))
        # The input lies so many elements ahead of the output; the last is its own output, reversed.
        for ahead in (0, 1, 3, -1, -3):
            memory = np.zeros(size + 3, dtype)
            given, out = memory[max(ahead, 0) :][:size], memory[max(-ahead, 0) :][:size]
            given[:] = alpha
            assert function(given, out=out) is out
            equal(out, expected)
        memory = alpha.copy()
        equal(function(memory, out=memory[::-1]), expected)
        wanted, out = np.arange(size) % 3 == 0, np.full(2 * size, 7, dtype)
        function(alpha, out[::2], where=wanted)
        equal(out[::2], np.where(wanted, expected, dtype(7)))
        function(alpha, out=out[::2])
        equal(out[::2], expected)
        assert np.all(out[1::2] == 7)
        other = np.empty(size, np.float32 if dtype is np.float64 else np.float64)
        equal(function(alpha, out=other), expected.astype(other.dtype))


@each_level
@pytest.mark.parametrize("name", FITTED)
def test_no_flag_but_invalid(name: str, level: str) -> None:
    """None inside, however small; outside `invalid` and no other, in whole vectors and blocks too."""
    function, end = kernel(name, level), HALF_PI * (1 + 4 * 2.0**-52)
    assert function(end) == function(np.full(200, end))[-1] == function(HALF_PI)
    for alpha in (points(), points().astype(np.float32), points()[::2]):
        with np.errstate(all="raise"):
            function(alpha)
    for bad in (-5e-324, -1e308, float(np.nextafter(end, 9)), np.inf):
        with np.errstate(all="raise", invalid="ignore"):
            assert np.isnan(function(np.full(33, bad))).all()
        for given in (np.array([bad, 0.5])[::-1], np.array([bad] * 9000)):
            with np.errstate(invalid="raise"), pytest.raises(FloatingPointError, match="invalid"):
                function(given)


@each_level
def test_blocks_and_threads(level: str) -> None:
    """NumPy's intermediate values fit in the cache, whatever the size; threads get in nobody's way."""
    alpha = np.random.default_rng(6).uniform(0, HALF_PI, 400_000)
    function = kernel("radial_weight_amplitude", level)
    expected = function(alpha)
    tracemalloc.start()
    function(alpha)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < alpha.nbytes + 2_000_000
    with ThreadPoolExecutor(4) as pool:
        for value in pool.map(function, [alpha] * 8):
            np.testing.assert_array_equal(value, expected)


# --- accuracy ------------------------------------------------------------------------------------------------------


BOUNDS: dict[str, dict[str, tuple[float, float | None]]] = {
    "1e-6": {"fused": (2e-7, None), "plain": (3e-7, None)},
    "1e-10": {"fused": (4e-11, None), "plain": (5e-11, None), "numpy": (6e-11, None)},
    "best": {"fused": (2e-16, 0.9), "plain": (7e-16, 3.1), "numpy": (8e-16, 3.6)},
    "float32": {"fused": (6.1e-8, 0.51), "plain": (6.1e-8, 0.51)},
}


@pytest.fixture
def proved(monkeypatch: pytest.MonkeyPatch) -> None:
    """Invented bounds, which tell the tiers and forms apart."""
    bounds = {n: {t: of for t, of in BOUNDS.items() if t in kernels.TEXTS[n]} for n in FITTED}
    monkeypatch.setattr(_compiled, "BOUNDS", bounds)


@each_level
@pytest.mark.usefixtures("proved")
@pytest.mark.parametrize("name", FITTED)
def test_accuracy_takes_the_cheapest_tier_that_is_proved(name: str, level: str) -> None:
    """The cheapest tier is selected by the proof of the program that would run; a ValueError if none suffices."""
    form, loops = LEVELS[level]
    function, alpha = kernel(name, level), points()
    known = {
        t: BOUNDS[t].get(form, BOUNDS[t]["plain"])[0] for t in ("1e-6", "1e-10", "best") if t in kernels.TEXTS[name]
    }
    for accuracy in (1.0, 1e-6, 2.5e-7, 4.5e-11, 1e-12, 7.5e-16, 5e-16, 1e-16, *known.values()):
        met = [t for t, bound in known.items() if bound <= accuracy]
        if not met:
            with pytest.raises(ValueError, match="cannot promise"):
                function(alpha, accuracy=accuracy)
            continue
        expected = loops[met[0]][name](alpha) if loops else kernels.TEXTS[name][met[0]](np.minimum(alpha, HALF_PI))
        np.testing.assert_array_equal(function(alpha, accuracy=accuracy), expected)
        assert function(float(alpha[9]), accuracy=accuracy) == expected[9]
    np.testing.assert_array_equal(function(alpha), function(alpha, accuracy=known["best"]))


@each_level
@pytest.mark.usefixtures("proved")
def test_accuracy_that_cannot_be(level: str) -> None:
    """Nonsense, more than the format holds, and functions that are sampled only."""
    function = kernel("polar_moment", level)
    for wrong in (0, 0.0, -1e-6, float("nan")):
        with pytest.raises(ValueError, match="relative error above 0"):
            function(0.5, accuracy=wrong)
    with pytest.raises(TypeError):
        function(0.5, accuracy="high")
    with pytest.raises(ValueError, match="cannot promise"):
        function(0.5, accuracy=1e-17)
    assert function(np.float32(0.5), accuracy=1e-6) == function(np.float32(0.5))
    with pytest.raises(ValueError, match=r"cannot promise.*6\.1e-08"):
        function(np.float32(0.5), accuracy=1e-8)
    with pytest.raises(ValueError, match="nothing is proved"):
        function(np.float16(0.5), accuracy=1e-3)
    with pytest.raises(ValueError, match="nothing is proved"):
        _compiled.kernel("unknown", {"best": lambda x: x}, level)(0.5, accuracy=1.0)


@pytest.mark.parametrize("name", kernels.__all__)
def test_calls_with_floats_have_the_bits_of_arrays(name: str) -> None:
    """Protect the calls that do not run Python's interpreter, at both ends of the domain, outside and for NaN."""
    function = getattr(kernels, name)
    ends = name in ("radial_weight", "weight_moment", "limit_friction")
    halves = [0.0, 5e-324, 1e-9, 0.3, 1.1, 1.5, math.pi / 2, np.nextafter(math.pi / 2, 2.0), -1e-300, 2.0, math.nan]
    cases = [(4.0, 4.0 + 2.0 * x) for x in halves] if ends else [(x,) for x in halves]
    for case in cases:
        with np.errstate(all="ignore"):
            values = [function(*case), function(*map(np.float64, case))]
            expected = function(*(np.array([x]) for x in case))
        assert np.array_equal(values, np.repeat(expected, 2), equal_nan=True), case
        assert {type(x) for x in values} == {np.float64}
    with np.errstate(invalid="raise"), pytest.raises(FloatingPointError, match=name):
        function(*((5.0, 4.0) if ends else (-1.0,)))
    assert pickle.loads(pickle.dumps(function)) is function
    assert [*inspect.signature(function).parameters][-3:] == ["out", "where", "accuracy"]
