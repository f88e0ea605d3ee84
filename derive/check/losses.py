"""Certificates of functions of both ends of an arc: bounds on what the operations of `derive.check.ends` lose.

Part of the checker (`certify`): standard library and python-flint only.
"""

import math
from collections.abc import Callable, Iterable
from fractions import Fraction
from functools import cache, partial
from itertools import pairwise

from flint import arb

from derive.check import truth
from derive.check.ends import LIMIT, PASSES, PI, TERMS, Step, agree, cotangent, operations, sinc
from derive.check.patches import SMALL, ideal
from derive.check.proof import ProofError
from derive.check.records import Record, check_goals, digest, rejected
from derive.check.rounding import ROUNDING_BITS, rounding_sum, specialise
from derive.check.truth import BITS, SEGMENTS, TOP, Definition, ball, working

HALF_ULP = 2.0**-53


def distance(n: int, bits: int) -> arb:
    """Of n pi from the nearest multiple of 2**-bits."""
    scaled = arb.pi() * n * arb(2) ** bits
    return abs(scaled - (scaled + arb(0.5)).floor()) / arb(2) ** bits


@cache
def reduction_loss() -> float:
    """A bound on the relative error of b + low, for both ends within LIMIT and at most pi (1 + 4 eps) apart.

    Of m terms whose sizes add up to S a pass leaves the sum Sigma as the last one, nearly, and others that add up to
    at most g S, g = (m - 1) 2**-53: after it, S is at most Sigma + 2 g S. The ratio S/Sigma is bounded by how near the
    ends' sum can come to n pi. For n = 0 it is a multiple of the smaller end's last place. From |n| = 2 on, with less
    than 1 between them, both ends are above 1, and their sum is a multiple of 2**-52. For |n| = 1 that holds of one;
    of the other too down to 2**-106 if it is above 2**-54, and below it changes the distance by no more than itself.
    """
    most = math.ceil(2 * LIMIT / math.pi) + 2
    bits = max(Fraction(part).numerator.bit_length() for part in PI[:-1])
    if bits + most.bit_length() > 53:
        raise ArithmeticError("a part of pi times n is not exact")
    with working(400):
        missing = float(abs(sum(PI, -arb.pi())).upper())
        nearest = min(float(distance(n, 52).lower()) for n in range(2, most + 1))
        first = min(float(distance(1, 106).lower()), float(distance(1, 52).lower()) - 2.0**-54)
    rounded = PI[-1] * HALF_ULP  # of n times the last part, where n is no power of two
    cases = (
        (2.0**55, 0.0),
        (10.0 / first, missing / first),
        ((4 * LIMIT + 8) / nearest, most * (missing + rounded) / nearest),
    )
    g = (len(PI) + 1) * HALF_ULP * (1 + 2.0**-40)
    worst = 0.0
    for ratio, rest in cases:
        for _ in range(PASSES - 1):
            ratio = 1 + 2 * g * ratio
        worst = max(worst, len(PI) * HALF_ULP * g * ratio + rest)
    return worst * (1 + 2.0**-30)


def traced(function: Callable[[Step], Step]) -> Record:
    """The operations of a function of one number, and which is the result."""
    start = Step([["input", [], "x"]])
    output = function(start).place
    return {"operations": start.operations, "output": output}


@cache
def sinc_loss(tier: str) -> float:
    """A bound on the relative error of sinc on [0, TOP]: of its series, and of rounding box by box."""
    terms = TERMS[tier]
    record = traced(partial(sinc, terms=terms))
    series = (math.pi / 2) ** (2 * terms) / math.factorial(2 * terms + 1)  # the first omitted term
    with working(BITS):
        computed = ideal(specialise(record, 0.0, TOP), arb(0))
        for k in range(2 * terms):
            exact = arb((-1) ** (k // 2) * (k % 2 == 0)) / math.factorial(k + 1)
            series += float(abs(computed[k] - exact).upper()) * (math.pi / 2) ** k
    worst = 0.0
    for k in range(128):
        lower = TOP * k / 128
        upper = TOP * (k + 1) / 128
        with working(ROUNDING_BITS):
            x = ball(lower, upper)
            rest, last = rounding_sum(specialise(record, lower, upper), x)
            relative = (rest + last + series) / x.sinc()
            worst = max(worst, float(relative.abs_upper()))
    return worst


@cache
def cotangent_loss() -> float:
    """A bound on the error of x cot(x) on [0, TOP], that of rounding in it."""
    tape = specialise(traced(cotangent), 0.0, TOP)
    worst = 0.0
    with working(BITS):
        for k in range(512):
            x = ball(TOP * k / 512, TOP * (k + 1) / 512)
            difference = ideal(tape, x)[0] - x.cos() / x.sinc()
            worst = max(worst, float(difference.abs_upper()))
    return worst + 2.0**-40


@cache
def slope_gap(statement: str) -> float:
    """A bound on |alpha C'/C - 3 k(alpha)|.

    The chord's end moves: C' = 2 sin(alpha) T_n for r^n cos u (`truth`). Below SMALL, alpha cos(alpha)^n <= T_n <=
    alpha bounds both within 3 (cos(alpha)^-(n + 2) - 1) of each other.
    """
    power = int(truth.WEIGHT.fullmatch(statement)[1])  # type: ignore[index]
    with working(BITS):
        worst = float((3 * (arb(SMALL).cos() ** -(power + 2) - 1)).upper())
        for segment in SEGMENTS:
            model = truth.kernel(statement, segment)
            start = max(segment.lower, SMALL)
            ratio = segment.upper / start
            points = [start * ratio ** (k / 128) for k in range(128)]
            for lower, upper in pairwise([*points, segment.upper]):
                x = ball(lower, upper)
                s, c = x.sin_cos()
                h = -((arb.pi() / 2 - x) / 2).tan().log()
                amplitude = model(x - segment.centre) * (1 if segment.lower else x**3)
                slope = 2 * x * s * truth.folded(power, x, s, c, h) / amplitude
                worst = max(worst, float(abs(slope - 3 * x * c / s).upper()))
    return worst + 3 * cotangent_loss()


def relative(definition: Definition, tier: str, part: float) -> float:
    """A bound on the relative error, ``part`` being that of C(alpha)."""
    *statements, direction = definition
    gaps = sum(map(slope_gap, statements))
    excess = (8 * HALF_ULP * LIMIT) ** 2  # of b beyond pi, where n is rounded: a half turn's sine is flat
    turned = HALF_ULP * (1 + cotangent_loss()) + reduction_loss() + excess
    sine = sinc_loss(tier)
    products = 2
    errors = [part, turned, sine, gaps * HALF_ULP]
    if direction == "tan psi":
        errors += [turned, sine]
        products = 4
    errors += [HALF_ULP] * products
    total = sum(errors)
    return total * (1 + 2 * total) + 2.0**-80  # second orders of what is lost, and roundings of first ones


def _label(part: Record) -> str:
    """What a call of it says."""
    return " ".join(str(part[key]) for key in ("kernel", "tier", "form", "sha256"))


def certificate(kernel: str, definition: Definition, tier: str, form: str, part: Record) -> Record:
    """The certificate of a function of both ends, from that of its function of alpha."""
    if list(definition[:-1]) != part["definition"]:
        raise ProofError(f"{kernel}: definition of the part", part["definition"], definition[:-1])
    single = tier == "float32"
    of_sinc = part["tier"]
    listed = operations(definition, of_sinc, _label(part))
    agree(definition, listed, of_sinc)
    unit = 2.0**-52 if part["tier"] == "best" else 1.0
    bound = relative(definition, of_sinc, part["bound"] * unit)
    record: Record = {
        "kernel": kernel,
        "definition": list(definition),
        "tier": tier,
        "form": form,
        "output": len(listed) - 1,
        "operations": listed,
        "assumptions": part["assumptions"],
        "bound": 0.5 + bound * 2.0**24 if single else bound,
    }
    return record | {"sha256": digest(record)}


def prove(record: Record, parts: Iterable[Record]) -> float:
    """Prove what a record claims, given proved certificates of functions of alpha; the bound that was proved.

    Its operations must be those of this module. Raises `ProofError` with the name of a check: part, or what differs.
    """
    called = [value for kind, _, value in record["operations"] if kind == "call"]
    part = next((p for p in parts if [_label(p)] == called), None)
    if part is None:
        raise rejected("part", record, called, "one that is certified")
    proved = certificate(record["kernel"], record["definition"], record["tier"], record["form"], part)
    for key, value in proved.items():
        if key != "bound" and record[key] != value:
            raise rejected(key, record, record[key], value)
    if not proved["bound"] <= record["bound"]:
        raise rejected("bound", record, proved["bound"], f"at most {record['bound']}")
    check_goals(record)
    return float(proved["bound"])
