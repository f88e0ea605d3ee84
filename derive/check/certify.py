"""Proof of the error bound of a straight-line float64 program on the whole domain, including rounding.

The checker reads plain data (`generated/certificates/*.json`) and uses only the standard library and python-flint, and
NumPy sums and products for correct rounding (`derive.check.midpoints`). It is independent of the generator: each
certificate states the definition of its kernel, which `derive.check.truth` reads. In each box of alpha,

    |computed - exact| <= |P - F| + sum_i sup |dP/dn_i| d_i + half an ulp,

where P is the program in real arithmetic (Taylor models) and n_i the rounding error of operation i with its bound d_i.
The derivatives are computed backwards through the program in ball arithmetic, over all alpha of the box and all errors
within their bounds (mean value theorem, so that no terms of higher order are neglected). Exact operations have no n_i.
An operation that computes the rounding error of another operation *is* that n_i, so that compensation is recognised.
"""

import heapq
import math
import time
from itertools import groupby
from operator import itemgetter
from typing import NamedTuple

from flint import arb

from derive.check import losses, midpoints, rounding
from derive.check.patches import QUARTER, UNDERFLOW, Patch, near_zero, patches
from derive.check.proof import ProofError
from derive.check.records import (
    TIERS,
    Record,
    assumptions,
    check_goals,
    digest,
    of_both_ends,
    read_records,
    rejected,
    seal,
    unit,
)
from derive.check.rounding import ROUNDING_BITS, TINY, UP, Unbounded, specialise
from derive.check.truth import working
from derive.kinds import Pair
from derive.progress import parallel

VANISHING = 2.0**-352  # below this alpha every kernel is less than 2**-1055
HALVINGS = 750  # most halvings of boxes for one claim


def ulp(x: float) -> float:
    """Return the unit in the last place of an exact value x > 0, the smaller unit at powers of two."""
    return math.ulp(math.nextafter(x, 0.0))


def in_units(tier: str, distance: float, last: float, smallest: float, least: float = 0.0) -> float:
    """Return the error on a box in the unit of its tier; ``least`` is the least ulp.

    |rounded - exact| is at most the distance before the last rounding plus half an ulp *of the exact value*, if that
    distance is at most one ulp. If the exact value lies below a power of two and the number to be rounded above it, the
    power of two is the nearest double.
    """
    if not smallest > 0 and not least > 0:
        return math.inf  # the box is too wide
    if TIERS[tier].unit == "relative":
        return (distance + last) / smallest * UP
    unit = max(ulp(smallest), least)
    if distance <= unit:
        return (distance / unit + 0.5) * UP
    return (distance + last) / unit * UP


def below_underflow(record: Record, whole: float) -> float:
    """Return a bound below UNDERFLOW, where s**-3 times the least number is not negligible.

    There is one window for each s down to VANISHING, where the absolute error is bounded.
    """
    tier = record["tier"]
    if len(record["definition"]) > 1:
        return 0.0  # quotients do not underflow
    near = near_zero(record)
    whole_interval = [(0.0, 1.0)]
    upper_half = [(i / 32, (i + 1) / 32) for i in range(16, 32)]

    def bound(s: float, boxes: list[Pair]) -> float:
        """Return the bound for alpha = s xi, with xi in these boxes."""
        window = near.window(s, s)
        least = TINY / s / s / s
        worst = 0.0
        for lower, upper in boxes:
            distance, last, smallest = window.error(lower, upper)
            if TIERS[tier].unit == "relative":
                worst = max(worst, (distance + last) / (whole * smallest + least) * UP)
            else:
                worst = max(worst, in_units(tier, distance, last, smallest, least))
        return worst

    s = VANISHING
    worst = bound(s, whole_interval)
    while s < UNDERFLOW:
        s *= 2
        worst = max(worst, bound(s, upper_half))
    return worst


def error(record: Record, part: Patch, lower: float, upper: float) -> float:
    """Return a bound on the error on one box in the unit of its tier, infinite if the box is too wide."""
    try:
        return in_units(record["tier"], *part.error(lower, upper))
    except Unbounded:
        return math.inf


def by_claim(record: Record) -> dict[str, list[Patch]]:
    """Return the patches of each claim, beyond pi/4 and up to it."""
    claims: dict[str, list[Patch]] = {"bound": [], "bound_to_quarter_pi": []}
    for part in patches(record):
        below = part.top or part.upper <= QUARTER
        claims["bound_to_quarter_pi" if below else "bound"].append(part)
    return claims


class Box(NamedTuple):
    """Box of a patch, ordered by its bound, the greatest first."""

    minus_bound: float
    number: int
    lower: float
    upper: float


def halve(record: Record, parts: list[Patch], wanted: float = 0.0) -> tuple[float, list[Pair]]:
    """Return the bound proved on these patches, and at most 16 boxes of alpha with the greatest bounds, in order.

    The box with the greatest bound is halved until the bound is at most ``wanted``, at most HALVINGS times.
    """

    def box(number: int, lower: float, upper: float) -> Box:
        return Box(-error(record, parts[number], lower, upper), number, lower, upper)

    boxes = [box(number, part.lower, part.upper) for number, part in enumerate(parts)]
    heapq.heapify(boxes)
    for _ in range(HALVINGS):
        minus_bound, number, lower, upper = boxes[0]
        middle = (lower + upper) / 2
        if -minus_bound <= wanted or not lower < middle < upper:
            break
        heapq.heapreplace(boxes, box(number, lower, middle))
        heapq.heappush(boxes, box(number, middle, upper))
    worst = []
    of_each_patch = {x.number: x for x in sorted(boxes, reverse=True)}
    for x in heapq.nsmallest(16, of_each_patch.values()):
        scale = 2.0**-10 if parts[x.number].top else 1.0  # a window represents every power of two
        worst.append((x.lower * scale, x.upper * scale))
    return -boxes[0].minus_bound, worst


def prove(record: Record) -> float:
    """Prove the claims of a record on the whole domain, and return the proved bound, at most the claimed one.

    ``bound`` is claimed above UNDERFLOW, ``bound_to_quarter_pi`` up to pi/4, and ``bound_underflow`` below UNDERFLOW.
    In the tiers best and float32 the unit is the ulp of the exact value, at least the format's least number. In the
    tiers 1e-10 and 1e-6 bounds are relative, and below UNDERFLOW in units of (bound times the exact value + 2**-1074).
    `derive.check.midpoints` proves that the double of tier float32 is rounded correctly.

    Raises
    ------
    ProofError
        With the name of a failed check: digest, seal, witness, assumptions, program, zero, bound, underflow or goal.
    """
    if record["sha256"] != digest(record):
        raise rejected("digest", record, digest(record), record["sha256"])
    if record != seal(record):
        raise rejected("seal", record, record.get("seal"), seal(record)["seal"])
    stated = record["assumptions"]
    if stated != assumptions(record):
        raise rejected("assumptions", record, stated, assumptions(record))
    try:
        _check_program(record)
        proved = 0.0
        for claim, parts in by_claim(record).items():
            claimed = min(record["bound"], record[claim])
            bound, boxes = halve(record, parts, claimed)
            if not bound <= claimed:
                raise rejected("bound", record, f"{bound:.4g}, alpha near {boxes[0][0]!r}", f"at most {claimed}")
            proved = max(proved, bound)
        claimed = record["bound_underflow"]
        underflow = 0.0 if claimed == math.inf else below_underflow(record, record["bound"])
        if not underflow <= claimed:
            raise rejected("underflow", record, f"{underflow:.4g}", f"at most {claimed}")
        check_goals(record)
        return proved
    except Unbounded as fault:
        raise rejected("bound", record, f"none, {fault}", record["bound"]) from fault
    except (ArithmeticError, LookupError, TypeError, ValueError) as fault:
        raise rejected("program", record, f"{type(fault).__name__}: {fault}", "operations with a meaning") from fault


def _check_program(record: Record) -> None:
    """Check that the tier is known, that operations use earlier results only, and that a base quantity is 0 at 0."""
    if record["tier"] not in TIERS:
        raise ValueError(f"no tier is called {record['tier']}")
    for i, (_, args, _) in enumerate(record["operations"]):
        if any(not 0 <= a < i for a in args):
            raise ValueError("an operation uses a later one")
    with working(ROUNDING_BITS):
        values, _ = rounding.forward(specialise(record, 0.0, 0.0), arb(0))
    if len(record["definition"]) == 1 and not values[-1] == 0:  # a quotient is nonzero at 0
        raise rejected("zero", record, f"{values[-1]} at alpha = 0", 0)


def checked(record: Record) -> tuple[str, bool]:
    """Return the outcome and the time of a record's proof as a line, and whether the record is accepted."""
    start = time.perf_counter()
    tier = record["tier"]
    name = f"{record['kernel']:<32} {tier:<8} {record['form']:<6}"
    try:
        if of_both_ends(record):
            proved = losses.prove(record, read_records())
        else:
            proved = prove(record)
            if "hard" in record:
                midpoints.prove(record)
    except ProofError as refusal:
        return f"{name} REJECTED: {refusal}", False
    seconds = time.perf_counter() - start
    near = f"{record['bound_to_quarter_pi']:.3g}" if "bound_to_quarter_pi" in record else "-"  # of both ends
    numbers = f"{proved:>9.4g} {record['bound']:>9.3g} {near:>9}"
    return f"{name} {numbers}  {unit(record):<14} {seconds:>7.2f}", True


def prove_all() -> bool:
    """Prove every certificate, print a table, and return whether all are accepted."""
    records = read_records() + read_records(both_ends=True)
    start = time.perf_counter()
    accepted = bool(records)
    print(f"{'kernel':<32} {'tier':<8} {'form':<6} {'proved':>9} {'claimed':>9} {'to pi/4':>9}  unit           seconds")
    by_kernel = [list(those) for _, those in groupby(records, itemgetter("kernel"))]
    for line, proved in parallel(checked, by_kernel, "kernels checked"):
        print(line, flush=True)
        accepted &= proved
    outcome = "all proved" if accepted else "NOT all proved"
    seconds = time.perf_counter() - start
    print(f"{len(records)} certificates, {outcome}, {seconds:.1f} s with 2 processes")
    return accepted
