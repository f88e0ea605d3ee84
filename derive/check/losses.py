"""Certificates of functions of both ends of an arc: bounds on the errors of the operations of `derive.check.ends`.

Part of the checker (`certify`): standard library and python-flint only.
"""

import math
from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from functools import cache, partial
from itertools import pairwise

from flint import arb, arb_series

from derive.check import truth
from derive.check.ends import LIMIT, PASSES, PI, TERMS, RecordedValue, cotangent, result, sinc
from derive.check.patches import ideal
from derive.check.proof import ProofError
from derive.check.records import Record, check_goals, digest, rejected, seal
from derive.check.rounding import ROUNDING_BITS, Tape, above, below, rounding_sum, specialise
from derive.check.truth import BITS, SEGMENTS, TOP, Definition, ball, working

HALF_ULP = 2.0**-53


def distance(n: int, bits: int) -> arb:
    """Return the distance of n pi from the nearest multiple of 2**-bits."""
    scaled = arb.pi() * n * arb(2) ** bits
    return abs(scaled - (scaled + arb(0.5)).floor()) / arb(2) ** bits


@cache
def least_distance(most: int) -> float:
    """Return a lower bound on the distance of n pi from the multiples of 2**-52, for n from 2 to ``most``."""
    with working(400):
        return min(below(distance(n, 52)) for n in range(2, most + 1))


@cache
def reduction_loss() -> float:
    """Return a bound on the relative error of b + low, for ends within LIMIT and at most pi (1 + 4 eps) apart.

    A pass over m terms whose absolute values add up to S leaves approximately the sum Sigma as the last term, and
    others whose absolute values add up to at most g S, with g = (m - 1) 2**-53. After it, S is at most Sigma + 2 g S.
    The ratio S/Sigma is bounded by how near the sum of the ends can come to n pi. For n = 0 the sum is a multiple of
    the smaller end's last place. For |n| >= 2 both ends are above 1, as they differ by at most pi, and their sum is a
    multiple of 2**-52. For |n| = 1 this is true for one end. If the other end is above 2**-54, it is a multiple of
    2**-106. Below 2**-54 it changes the distance by no more than itself.
    """
    most = math.ceil(2 * LIMIT / math.pi) + 2
    widest = max(Fraction(part).numerator.bit_length() for part in PI[:-1])
    if widest + most.bit_length() > 53:
        raise ArithmeticError("a part of pi times n is not exact")
    with working(400):
        missing = above(sum(map(arb, PI), -arb.pi()))
        nearest = least_distance(most)
        first = min(below(distance(1, 106)), below(distance(1, 52)) - 2.0**-54)
    last = PI[-1] * HALF_ULP  # n times the last part is rounded, where n is no power of two
    cases = (
        (2.0**55, 0.0),
        (10.0 / first, missing / first),
        ((4 * LIMIT + 8) / nearest, most * (missing + last) / nearest),
    )
    sums = len(PI) + 1
    g = sums * HALF_ULP * (1 + 2.0**-40)
    worst = 0.0
    for ratio, rest in cases:
        for _ in range(PASSES - 1):
            ratio = 1 + 2 * g * ratio
        lost = (sums - 1) * HALF_ULP * g * ratio
        worst = max(worst, lost + rest)
    return worst * (1 + 2.0**-30)


def traced(function: Callable[[RecordedValue], RecordedValue]) -> Tape:
    """Return the operations of a function of one number in [0, TOP], for the analysis of rounding."""
    start = RecordedValue([["input", [], "x"]])
    return specialise({"operations": start.operations, "output": function(start).place}, 0.0, TOP)


@cache
def sinc_loss(tier: str) -> float:
    """Return a bound on the relative error of sinc on [0, TOP], by truncation and by rounding box by box."""
    terms = TERMS[tier]
    tape = traced(partial(sinc, terms=terms))
    end = 1.571  # above pi/2
    series = end ** (2 * terms) / math.factorial(2 * terms + 1)  # the first omitted term
    with working(BITS):
        computed = ideal(tape, arb(0))
        taylor = arb_series([0, 1]).sin()
        for k in range(2 * terms):
            series += above(computed[k] - taylor[k + 1]) * end**k
    worst = 0.0
    with working(ROUNDING_BITS):
        for x in boxes(0.0, TOP):
            rest, last = rounding_sum(tape, x)
            worst = max(worst, above((rest + last + series) / x.sinc()))
    return worst


@cache
def cotangent_loss() -> float:
    """Return a bound on the error of x cot(x) on [0, TOP], including rounding."""
    tape = traced(cotangent)
    worst = 0.0
    with working(BITS):
        for x in boxes(0.0, TOP):
            computed, *_ = ideal(tape, x)
            worst = max(worst, above(computed - x.cos() / x.sinc()))
    return worst + 2.0**-40


@cache
def slope_gap(statement: str) -> float:
    """Return a bound on |alpha C'/C - 3 k(alpha)|, where a series computes k(x) = x cot(x)."""
    return exact_gap(statement) + 3 * cotangent_loss()


@cache
def exact_gap(statement: str) -> float:
    """Return a bound on |alpha C'/C - 3 alpha cot(alpha)|.

    The chord's end moves: C' = 2 sin(alpha) T_n for r^n cos u (`truth`). As alpha cos(alpha)^n <= T_n <= alpha, they
    are within 3 (cos(alpha)^-(n + 2) - 1) of each other, which serves on the first segment.
    """
    power = int(statement.split()[0].removeprefix("r^"))
    first, *others = SEGMENTS
    with working(BITS):
        worst = above(3 * (arb(first.upper).cos() ** -(power + 2) - 1))
        for segment in others:
            model = truth.kernel_model(statement, segment)
            for x in boxes(segment.lower, segment.upper):
                s, c = x.sin_cos()
                slope = 2 * s * truth.folded(power, x, s, c, truth.artanh_of_sine(x))
                steepness = x * slope / model(x - segment.centre)
                worst = max(worst, above(steepness - 3 * x * c / s))
    return worst


def boxes(lower: float, upper: float) -> Iterator[arb]:
    """Yield an interval in 64 parts."""
    width = (upper - lower) / 64
    for ends in pairwise([*(lower + k * width for k in range(64)), upper]):
        yield ball(*ends)


def relative(definition: Definition, tier: str, part: float) -> float:
    """Return a bound on the relative error, where ``part`` is the bound for C(alpha)."""
    *statements, direction = definition
    gaps = sum(map(slope_gap, statements))
    excess = (8 * HALF_ULP * LIMIT) ** 2  # of b beyond pi, where n is rounded: a half turn's sine is flat
    turned = HALF_ULP * (1 + cotangent_loss()) + reduction_loss() + excess
    sine = sinc_loss(tier) + turned
    products = 2
    if direction == "tan psi":
        sine *= 2
        products = 4
    total = part + sine + (gaps + products) * HALF_ULP
    return total * (1 + 2 * total) + 2.0**-80  # second orders of all losses, and roundings of first orders


def certificate(kernel: str, definition: Definition, tier: str, form: str, part: Record) -> Record:
    """Return the certificate of a function of both ends from the certificate of its function of alpha."""
    *statements, _ = definition
    if statements != part["definition"]:
        raise ProofError(f"{kernel}: definition of its part", part["definition"], statements)
    of_sinc = part["tier"]
    listed = result(definition, of_sinc, part["sha256"]).operations
    of_part = part["bound"]
    if of_sinc == "best":
        of_part *= 2.0**-52
    bound = relative(definition, of_sinc, of_part)
    if tier == "float32":
        bound = 0.5 + bound * 2.0**24
    record: Record = {
        "kernel": kernel,
        "definition": list(definition),
        "tier": tier,
        "form": form,
        "output": len(listed) - 1,
        "operations": listed,
        "assumptions": part["assumptions"],
        "bound": bound,
    }
    return seal(record | {"sha256": digest(record)})


def prove(record: Record, parts: Iterable[Record]) -> float:
    """Prove the claims of a record from proved certificates of functions of alpha, and return the proved bound.

    The record must contain the operations of `ends`.

    Raises
    ------
    ProofError
        With the name of a failed check: part, bound or program.
    """
    called = [value for kind, _, value in record["operations"] if kind == "call"]
    serving = [part for part in parts if [part["sha256"]] == called]
    if not serving:
        raise rejected("part", record, called, "one that is certified")
    proved = certificate(record["kernel"], record["definition"], record["tier"], record["form"], serving[0])
    bound = float(proved.pop("bound"))
    if not bound <= record["bound"]:
        raise rejected("bound", record, bound, f"at most {record['bound']}")
    check_goals(record)
    if record != seal(proved | {"bound": record["bound"]}):
        raise rejected("program", record, "other operations", "those of the checker")
    return bound
