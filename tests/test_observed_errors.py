"""Seen <= proved on 10,000 inputs (`python -m tests.campaigns.seen` takes a million), bugs that it sees, landmarks."""

from collections.abc import Callable
from functools import cache
from itertools import chain
from typing import Any

import numpy as np
import pytest

from derive.approximate import certificates, shapes
from derive.check.truth import TOP
from generated import _compiled, kernels
from tests.campaigns import float32, seen
from tests.campaigns.float32 import LAST_SINGLE
from tests.campaigns.seen import BASES, KERNELS, Inputs, Reference, Run, Seen
from tests.support import oracle

each_kernel = pytest.mark.parametrize("kernel", KERNELS)
each_base = pytest.mark.parametrize("kernel", BASES)
each_level = pytest.mark.parametrize("level", _compiled.LEVELS)


@cache
def given() -> Inputs:
    return seen.inputs(10_000)


@cache
def reference() -> Reference:
    return seen.reference(given().alpha)


def some(run: Run) -> Seen:
    """Return the errors that the inputs show."""
    return seen.measure(run, reference(), given().even, climbs=3)


def find(kernel: str, tier: str = "best", form: str = "plain") -> Run:
    """Return a certified program at the first level that runs it."""
    return next(r for r in seen.runs(kernel) if (r.record["tier"], r.record["form"]) == (tier, form))


@each_kernel
def test_no_more_is_seen_than_is_proved_and_nothing_leans(kernel: str) -> None:
    """Errors of every tier and form at every level are within their bounds, without NaN, warning or bias."""
    for run in seen.runs(kernel):
        found = some(run)
        assert not found.faults, "\n".join(found.faults)
        if "witness" in run.record and "hard" not in run.record:
            assert certificates.round_up(found.worst["bound"][0]) >= run.record["witness"]["error"]


def test_every_certificate_is_run() -> None:
    ran = {(r.record["tier"], r.record["form"], k) for k in KERNELS for r in seen.runs(k)}
    assert ran == {(r["tier"], r["form"], r["kernel"]) for r in seen.records()}  # of every variant: test_certificates


# --- planted bugs ----------------------------------------------------------------------------------------------------


# --- landmarks -------------------------------------------------------------------------------------------------------


def at_level(kernel: str, level: str) -> Callable[..., Any]:
    return _compiled.kernel(kernel, kernels.TEXTS[kernel], level)


@each_level
@each_base
def test_the_limit_at_a_right_angle(kernel: str, level: str) -> None:
    """The limit is the value at float64's pi/2, rounded; also for the numbers above pi/2 in the domain."""
    function, limit = at_level(kernel, level), float(oracle.kernel(kernel, TOP))
    for kind in (np.float64, np.float32):
        alpha = [kind(TOP)]
        while float(further := np.nextafter(alpha[-1], kind(2))) <= TOP * (1 + 4 * float(np.finfo(kind).eps)):
            alpha.append(further)
        assert len(alpha) >= 3
        np.testing.assert_array_equal(function(np.array(alpha)), kind(limit))
        assert [function(x) for x in alpha] == [kind(limit)] * len(alpha)


@each_level
@each_base
def test_monotone_across_the_seam(kernel: str, level: str) -> None:
    """Never down from one double to the next where pieces meet; fused nowhere; and up over larger steps."""
    function, (derived,) = at_level(kernel, level), (x for x in shapes.kernels() if x.name == kernel)
    seam = shapes.stated_shape(derived).best[0].seam
    below, above = function(np.array([np.nextafter(seam, 0), min(seam, TOP)]))
    assert below <= above
    steps = seam + np.arange(-500, 501) * 2.0**-48
    assert np.all(np.diff(function(steps[steps <= TOP])) > 0)
    if _compiled.LEVELS[level][0] == "fused":
        for middle in (seam, 0.5, 1.4, 1.5707, TOP):  # at the end C_r is flat
            next_ones = (np.float64(middle).view(np.int64) + np.arange(-5000, 5001)).view(np.float64)
            assert np.all(np.diff(function(next_ones[next_ones <= TOP])) >= 0), middle


@each_base
def test_float32_is_rounded_correctly(kernel: str) -> None:
    """The last million inputs and a sample are rounded correctly; `tests.campaigns.float32` tests all inputs."""
    rng = np.random.default_rng(32)
    sample = np.sort(rng.integers(0, LAST_SINGLE, 2**18, endpoint=True)).astype(np.uint32).view(np.float32)
    last = float32.inputs(LAST_SINGLE - 2**20)
    assert not float32.faults(kernel, chain([sample], last), *_compiled.LEVELS)


@each_base
def test_float32_is_rounded_correctly_where_that_is_hard(kernel: str) -> None:
    """Listed significands are rounded correctly with every exponent, also to subnormal results."""
    listed = {s for r in seen.records() if r["kernel"] == kernel for s in r.get("hard", ())}
    assert len(listed) > 16
    powers = 2.0 ** np.arange(-51.0, 1.0)
    x = np.outer([int(s, 16) * 2.0**-23 for s in sorted(listed)], powers).ravel()
    hard = x[x <= TOP].astype(np.float32)
    right = np.array([float32.decided(kernel, alpha) for alpha in hard.tolist()])
    for level in _compiled.LEVELS:
        np.testing.assert_array_equal(at_level(kernel, level)(hard), right)
