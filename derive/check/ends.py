"""Functions of both ends of an arc: their operations around a certified function of alpha, and what these lose.

With alpha = (theta_2 - theta_1)/2 and psi = 3 pi/2 - theta_m, theta_m = (theta_1 + theta_2)/2, a certificate states
C(alpha) cos(psi), C(alpha) sin(psi) or C(alpha) tan(psi), C being one or two statements of `derive.check.truth`.

2 theta_m - n pi, n even for cos(psi) = -sin(theta_m) and odd for sin(psi) = -cos(theta_m), is the sum of both ends
and of n times four parts of pi, n times the first three being exact. It is had as b + low by passes of error-free
sums (Ogita, Rump and Oishi 2005), however little is left of it. To first order in low and in what alpha has lost,

    C(alpha) sin((b + low)/2) = C (b + low k(b/2) + b (lost/d) 3 k(alpha))/2 sinc(b/2),   k(x) = x cot(x),

d = 2 alpha: the slope of C is near that of alpha**3 k-fold, and the sines cancel nowhere. Errors are relative, of the
exact ends, plus 2**-1000 for what underflows. Standard library and python-flint only.
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, partialmethod, reduce
from itertools import pairwise
from operator import add
from typing import Any

from flint import arb

from derive.check import truth
from derive.check.patches import SMALL
from derive.check.proof import ProofError
from derive.check.records import Record, check_goals, digest, rejected
from derive.check.rounding import ROUNDING_BITS, rounding_sum, specialise
from derive.check.truth import SEGMENTS, TOP, Definition, ball, fraction, working

LIMIT = 2.0**16  # of an end, rad: ten thousand turns
PASSES = 3
ROUND = 1.5 * 2.0**52  # added and taken off, it rounds to an integer
TURN = 0.5 / math.pi
TERMS = {"best": 12, "1e-10": 8, "1e-6": 6}  # of sinc's Taylor series
COTANGENT = (1.0, -1 / 3, -1 / 45, -2 / 945, -1 / 4725)  # x cot(x) in x**2
HALF_ULP = 2.0**-53
WIDTH = 37  # bits of the parts of pi but the last


@cache
def parts_of_pi() -> tuple[tuple[float, ...], float]:
    """Three of `WIDTH` bits and a double, and what they miss of pi."""
    parts = []
    with working(400):
        rest = arb.pi()
        scale = arb(2) ** (WIDTH - 2)
        for _ in range(3):
            parts.append(float((rest * scale).floor() / scale))
            rest -= parts[-1]
            scale *= arb(2) ** WIDTH
        parts.append(float(fraction(rest.mid())))
        return tuple(parts), float(abs(rest - parts[-1]).upper())


# --- operations ------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Step:
    """A value on a list of operations, as certificates list them; arithmetic appends to it."""

    operations: list[list[Any]]
    place: int = 0

    def put(self, kind: str, *others: Any, value: str | None = None) -> "Step":
        """Append an operation on this and other steps or numbers, or find the equal one that is there."""
        places = [self.place]
        for x in others:
            places.append(x.place if isinstance(x, Step) else self._find(["const", [], float(x).hex()]))
        return Step(self.operations, self._find([kind, places, value]))

    def _find(self, operation: list[Any]) -> int:
        if operation not in self.operations:
            self.operations.append(operation)
        return self.operations.index(operation)

    __add__ = partialmethod(put, "add")
    __sub__ = partialmethod(put, "sub")
    __mul__ = partialmethod(put, "mul")
    __truediv__ = partialmethod(put, "div")

    def rounded(self) -> "Step":
        """The nearest integer."""
        return self + ROUND - ROUND

    def least(self, limit: float) -> "Step":
        """This or the limit."""
        return self.put("min", limit)


def two_sum(a: Step, b: Step) -> tuple[Step, Step]:
    """fl(a + b) and its rounding error."""
    return a + b, a.put("lost", b)


def horner(x: Step, coefficients: tuple[float, ...]) -> Step:
    """The polynomial with these coefficients, lowest first."""
    *others, second, last = coefficients
    result = x * last + second
    for c in reversed(others):
        result = result * x + c
    return result


def sinc(x: Step, terms: int) -> Step:
    """sin(x)/x."""
    taylor = ((-1) ** k / math.factorial(2 * k + 1) for k in range(terms))
    return horner(x * x, tuple(taylor))


def reduced(one: Step, two: Step, odd: bool) -> tuple[Step, Step, Step]:
    """b and low; sin(psi) if odd, else cos(psi), is sin((b + low)/2) times this sign, which is 1/2 or -1/2 here."""
    turns = (one + two) * TURN
    half = ((turns - 0.5) if odd else turns).rounded()
    n = half * 2.0
    if odd:
        n = n + 1.0
    parts, _ = parts_of_pi()
    terms = [one, two, *(n * -part for part in parts)]
    for _ in range(PASSES):
        for k in range(1, len(terms)):
            terms[k], terms[k - 1] = two_sum(terms[k - 1], terms[k])
    high = terms.pop()
    b, low = two_sum(high, reduce(add, terms))
    b = b.least(2 * TOP)
    b = b.put("max", -2 * TOP)
    quarter = half * 0.5
    parity = quarter - quarter.rounded()  # 0, or 1/2 or -1/2
    sign = parity * parity * (-4.0 if odd else 4.0) + (0.5 if odd else -0.5)
    return b, low, sign


def operations(definition: Definition, tier: str, part: str) -> list[list[Any]]:
    """The operations of a function of both ends; ``part`` is what they call for C(alpha)."""
    start = Step([["input", [], "theta_1"], ["input", [], "theta_2"]])
    one = start
    two = Step(start.operations, 1)
    d, lost = two_sum(two, one.put("neg"))
    alpha = (d * 0.5).least(TOP)
    amplitude = alpha.put("call", value=part)
    terms = TERMS[tier]
    *_, direction = definition
    values = []
    for odd in (True, False):
        b, low, sign = reduced(one, two, odd)
        x = b * 0.5
        carried = horner(x * x, COTANGENT) * low
        if direction != "tan psi":
            share = lost / d.put("max", 2.0**-1000)
            carried = carried + b * (horner(alpha * alpha, COTANGENT) * 3.0 * share)
        values.append((b + carried, sinc(x, terms), sign))
    if direction == "tan psi":
        (above, sine, sign), (below, cosine, other) = values
        result = above * (amplitude * sine / cosine) * (sign * other * 4.0) / below
    else:
        turned, sine, sign = values["cos psi" in direction]
        if direction[0] == "-":
            sign = sign * -1.0
        result = amplitude * sine * sign * turned
    return _live(result)


def _live(result: Step) -> list[list[Any]]:
    """The operations that the result needs, it last; both ends stay."""
    every = result.operations
    needed = {0, 1, result.place}
    for k in range(result.place, 1, -1):
        if k in needed:
            needed.update(every[k][1])
    place = {old: new for new, old in enumerate(sorted(needed))}
    return [[kind, [place[a] for a in args], value] for kind, args, value in (every[k] for k in place)]


# --- what they lose --------------------------------------------------------------------------------------------------


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
    parts, missing = parts_of_pi()
    if most >= 2 ** (53 - WIDTH):
        raise ArithmeticError("a part of pi times n is not exact")
    with working(400):
        nearest = min(float(distance(n, 52).lower()) for n in range(2, most + 1))
        first = min(float(distance(1, 106).lower()), float(distance(1, 52).lower()) - 2.0**-54)
    rounded = abs(parts[-1]) * HALF_ULP  # of n times the last part, where n is no power of two
    cases = ((2.0**55, 0.0), (10.0 / first, missing / first))
    cases += (((4 * LIMIT + 8) / nearest, most * (missing + rounded) / nearest),)
    g = (len(parts) + 1) * HALF_ULP * (1 + 2.0**-40)
    worst = 0.0
    for ratio, rest in cases:
        for _ in range(PASSES - 1):
            ratio = 1 + 2 * g * ratio
        worst = max(worst, len(parts) * HALF_ULP * g * ratio + rest)
    return worst * (1 + 2.0**-30)


@cache
def sinc_loss(tier: str) -> float:
    """A bound on the relative error of sinc on [0, TOP]: the first omitted term, and rounding box by box."""
    listed = [["input", [], "x"]]
    terms = TERMS[tier]
    output = sinc(Step(listed), terms).place
    record = {"operations": listed, "output": output}
    constants = 0.0
    for k in range(terms):
        exact = Fraction(1, math.factorial(2 * k + 1))
        constants += float(abs(exact - Fraction(float(exact)))) * (math.pi / 2) ** (2 * k)
    omitted = (math.pi / 2) ** (2 * terms) / math.factorial(2 * terms + 1)
    worst = 0.0
    for k in range(128):
        lower, upper = TOP * k / 128, TOP * (k + 1) / 128
        with working(ROUNDING_BITS):
            rest, last = rounding_sum(specialise(record, lower, upper), ball(lower, upper))
            series = rest + last + omitted + constants
            worst = max(worst, float((series / ball(lower, upper).sinc()).abs_upper()))
    return worst


@cache
def slope_gap(statement: str) -> float:
    """A bound on |alpha C'/C - 3 k(alpha)|, with k as it is computed.

    The chord's end moves: C' = 2 sin(alpha) T_n for r^n cos u (`truth`). Below SMALL, alpha cos(alpha)^n <= T_n <=
    alpha bounds both within 3 (cos(alpha)^-n - 1) of 3 x cot(x).
    """
    power = int(truth.WEIGHT.fullmatch(statement)[1])  # type: ignore[index]
    with working(truth.BITS):
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
    return worst + 3 * COTANGENT_LOSS


# 2 zeta(2 k) (x/pi)**(2 k), k = 5, 6, ..., is what the series of x cot(x) omits: quarters of each other at most.
COTANGENT_LOSS = 2 * 1.001 * 0.25 ** len(COTANGENT) / 0.75 + 2.0**-40


def relative(definition: Definition, tier: str, part: float) -> float:
    """A bound on the relative error, ``part`` being that of C(alpha)."""
    *statements, direction = definition
    gaps = sum(map(slope_gap, statements))
    excess = (8 * HALF_ULP * LIMIT) ** 2  # of b beyond pi, where n is rounded: a half turn's sine is flat
    turned = HALF_ULP * (1 + COTANGENT_LOSS) + reduction_loss() + excess
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
