"""Search for shapes: seams, baselines and degrees, judged by the proved bound of their program.

Nothing in it is random and nothing is timed, so that it finds the same on every machine. What approximates badly or
must round badly is excluded by an estimate; of the rest the checker decides which is best.
"""

import math
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cache

import numpy as np
from flint import arb
from sympy import Expr, diff

from derive.approximate import certificates, shapes
from derive.approximate.minimax import minimax, value_at
from derive.approximate.programs import Variant, variant
from derive.approximate.shapes import HALF_PI, Far, Kernel, Pieces, Shape, end, recorded_shapes
from derive.check import certify, midpoints
from derive.check.patches import patches
from derive.check.proof import ProofError
from derive.check.records import TIERS, seal
from derive.declare.symbols import alpha
from derive.kinds import Pair
from derive.progress import parallel

SEAMS = [k / 100 for k in range(64, 124, 4)]
SLOPES = (0.0, 0.25, 0.5, 1.0, 2.0)
NEGLIGIBLE = 2.0**-58  # relative error of approximation to start from: a thirtieth of an ulp at most
ENOUGH = 2.0**-49  # the same of a tier that is rounded to float32
HALVINGS = 100
FROM, TO = 0.5, 1.5625  # where seam and baseline matter
DIVISION = 8  # cost of a division, in multiply-adds
OPERATION = 0.02  # price of a multiply-add, in ulp
STEPS = (-1, 1)  # to neighbouring shapes
TRIALS = 40  # most shapes evaluated for one quantity

Best = tuple[Pieces, ...]


def price(kernel: Kernel, shape: Best) -> float:
    """Return the price of a shape in ulp: the best fused tier's bound from FROM to TO, plus OPERATION per operation."""
    fused = variant(kernel, "best", "fused", shape)
    record = certificates.plain(fused)
    bound, _ = certify.halve(record, list(patches(record, FROM, TO)), halvings=HALVINGS)
    return bound + OPERATION * sum(fused.program.operations().values())


def kept(kernel: Kernel, tier: str, shape: Best | tuple[int, int]) -> list[Variant]:
    """Return the variants of a tier, plain and fused, in this shape, or nothing if a bound exceeds its goal.

    ``shape`` has the pieces of the best tier, or the degrees above and below of another tier.
    """
    forms = [variant(kernel, tier, form, shape) for form in ("plain", "fused")]  # plain arithmetic is faster to check
    try:
        for form in forms:
            record = certificates.plain(form)
            goal = TIERS[tier].goal(record)
            goals = {"bound": goal, "bound_to_quarter_pi": goal, "bound_underflow": math.inf}
            if tier == "float32":
                midpoints.hard(record | goals)  # fails sooner than the bound
            certify.prove(seal(record | goals))
    except ProofError:
        return []
    return forms


def rises(closed: Expr, seam: float) -> bool:
    """Return whether F increases at the seam by more than the errors of both pieces from one double to the next.

    ``seam`` is an angle alpha in rad.
    """
    step = math.ulp(math.nextafter(seam, 0.0))
    x = arb(seam)
    f = float(value_at(closed, x))
    return float(value_at(diff(closed, alpha), x)) * step > 1.4 * certify.ulp(f)


@cache
def baseline(closed: Expr, seam: float) -> Far:
    """Return the baseline beyond a seam with the smallest corrections, to which rounding errors are proportional."""
    values = []
    for k in range(25):
        x = seam + (HALF_PI - seam) * k / 24
        values.append((x, float(value_at(closed, arb(x)))))
    odd = end(closed).odd
    return min(_baselines(values, odd), key=lambda far: _correction(far, odd, values))


def _baselines(values: Sequence[Pair], odd: bool) -> Iterator[Far]:
    """Yield slopes, bends, and lines in steps of 1/128 for the remainder, and the line through the end.

    ``values`` are pairs (alpha, F), the last one at pi/2. There are no bends if the form is ``odd``.
    """
    end_value = values[-1][1]
    bends = [0.0] if odd else [k / 8 for k in range(25)]
    for slope in SLOPES:
        left = [128 * (f - slope * x) for x, f in values]
        lowest = math.floor(min(left))
        highest = math.ceil(max(left))
        lines = {k / 128 for k in range(lowest, highest + 1)}
        at_end = end_value - slope * HALF_PI
        lines.add(math.floor(at_end * 2**52) / 2**52)
        for line in sorted(lines):
            for bend in bends:
                yield Far(slope, line, bend, 1.0, 0)


def _correction(far: Far, odd: bool, values: Sequence[Pair]) -> float:
    """Return the greatest sum of the corrections to a baseline, relative to F, before and after its bend is removed.

    ``values`` are pairs (alpha, F). There is no bend if the form is ``odd``.
    """
    worst = 0.0
    for x, f in values:
        b = HALF_PI - x
        rest = f - (far.slope * x + far.line)
        bent = 0.0 if odd else b * (far.slope - far.bend * b)
        worst = max(worst, (abs(rest) + abs(rest - bent)) / f)
    return worst


def started(kernel: Kernel, seam: float) -> Best:
    """Return pieces for a seam (alpha in rad): the preferred baseline, and the least degrees that approximate."""
    pieces = []
    for closed in kernel.closed:
        far = None
        until = HALF_PI
        if end(closed).serves:
            far = _least_far(closed, seam)
            until = seam
        pieces.append(Pieces(until, _least_count(closed, until), far))
    return tuple(pieces)


def _least_count(closed: Expr, until: float) -> int:
    """Return the least number of coefficients that approximates a form on [0, until] within NEGLIGIBLE."""
    for count in range(7, 40):
        samples = shapes.near_samples(closed, until, count, shapes.limit(closed))
        _, _, error = minimax(samples, count - 1)
        if error < NEGLIGIBLE:
            break
    return count


def _least_far(closed: Expr, seam: float) -> Far:
    """Return the preferred baseline beyond a seam with the least degree within NEGLIGIBLE, or the greatest tried."""
    for degree in range(3, 13):
        far = replace(baseline(closed, seam), degree=degree)
        fit = shapes.far_fit(closed, far, seam)
        constant_error = math.ulp(fit.constant) / float(value_at(closed, arb(seam)))  # as the constant is rounded
        if fit.error < NEGLIGIBLE + constant_error:
            break
    return far


def falls(variant: Variant, seam: float) -> bool:
    """Return whether a base quantity decreases across the seam, in the fused form anywhere near it."""
    near = 1000 if variant.form == "fused" else 1
    bits = np.float64(seam).view(np.int64) + np.arange(-near, near)
    alpha = bits.view(np.float64)
    return bool(np.any(np.diff(variant.program.run(alpha[alpha <= HALF_PI])) < 0))


def neighbours(kernel: Kernel, shape: Best) -> Iterator[Best]:
    """Yield neighbouring shapes with other seams, and with other degrees and baselines of one part."""
    for step in STEPS:
        moved = []
        for part in shape:
            seam = round(part.seam + step / 100, 2)
            moved.append(replace(part, seam=seam) if part.far else part)
        yield tuple(moved)
    for k, (closed, part) in enumerate(zip(kernel.closed, shape, strict=True)):
        for move in _moves(closed, part):
            yield (*shape[:k], move, *shape[k + 1 :])


def _moves(closed: Expr, part: Pieces) -> Iterator[Pieces]:
    """Yield other numbers of coefficients of a part, and other baselines if the form has them."""
    about = end(closed)
    for step in STEPS:
        yield replace(part, count=part.count + step)
    far = part.far
    if far is None:
        return
    for step in STEPS:
        yield replace(part, far=replace(far, degree=far.degree + step))
    for step in (-4, -1, 1, 4):
        yield replace(part, far=replace(far, line=far.line + step / 128))
    if not about.odd:
        for step in STEPS:
            yield replace(part, far=replace(far, bend=far.bend + step / 8))
    if about.log:
        yield replace(part, far=replace(far, scale=3 - far.scale))


def best(kernel: Kernel) -> Best:
    """Return the pieces with the least bound and the fewest operations, or raise `ProofError` if none meets its goals.

    It tries the baseline that an estimate prefers at each seam, and then better neighbours of the best shapes.
    """
    judged: dict[Best, float] = {}

    def ranked(tried: Iterable[Best]) -> list[Best]:
        for shape in tried:
            if len(judged) == TRIALS:
                break
            if shape not in judged:
                judged[shape] = price(kernel, shape)
        return sorted(judged, key=lambda shape: (judged[shape], str(shape)))

    ranking = ranked(started(kernel, seam) for seam in _seams(kernel))
    explored: set[Best] = set()
    while left := [shape for shape in ranking[:2] if shape not in explored]:
        explored.add(left[0])
        ranking = ranked(neighbours(kernel, left[0]))
    chosen = _first_kept(kernel, ranking[:6])
    if chosen is None:
        tier = TIERS["best"]
        goal = tier.quotient if len(kernel.closed) > 1 else tier.fused
        raise ProofError(f"{kernel.name}: bound of tier best", "none of the shapes that were tried keeps it", goal)
    return chosen


def _seams(kernel: Kernel) -> list[float]:
    """Return the seams to try, angles alpha where a base quantity cannot decrease, or anywhere if there are none."""
    if not any(end(form).serves for form in kernel.closed):
        return SEAMS[:1]
    closed, *others = kernel.closed
    rising = SEAMS if others else [seam for seam in SEAMS if rises(closed, seam)]
    return (rising or SEAMS)[-9:]


def _first_kept(kernel: Kernel, ranking: Iterable[Best]) -> Best | None:
    """Return the first shape that meets its goals and does not decrease at its seam, else the first that meets them.

    The result is None if no shape of the ranking meets its goals.
    """
    spare = None
    for shape in ranking:
        forms = kept(kernel, "best", shape)
        if not forms:
            continue
        if len(kernel.closed) > 1 or not any(falls(form, shape[0].seam) for form in forms):
            return shape
        spare = spare or shape
    return spare


def degrees(kernel: Kernel, tier: str) -> tuple[str, int, int]:
    """Return the tier, and the degrees above and below of the cheapest polynomial or rational within its goal."""
    (closed,) = kernel.closed
    target = goal = TIERS[tier].fused
    tried = sorted(_degrees(), key=_cost)
    fit = shapes.cheap_fit
    if tier == "float32":
        target = ENOUGH
        singular = bool(end(closed).log)
        tried = [(n, n * singular) for n in range(4, 23)]
        fit = shapes.rounding_fit
    for above, below in tried:
        try:
            _, _, error = fit(closed, above, below)
        except ZeroDivisionError:  # the levelled system has no solution
            continue
        if error <= target and kept(kernel, tier, (above, below)):
            return tier, above, below
        if error < NEGLIGIBLE:  # higher degrees round the same inputs wrongly
            break
    raise ProofError(f"{kernel.name}: tier {tier}", "no degrees that keep it", f"{goal:g}")


def _degrees() -> Iterator[tuple[int, int]]:
    """Yield the degrees of numerators and denominators: polynomials, and quotients of equal or nearly equal degrees."""
    for total in range(2, 25):
        yield total, 0
        if total >= 6:
            below = total // 2
            yield total - below, below
            if total % 2:
                yield below, total - below


def _cost(degrees: tuple[int, int]) -> tuple[int, int]:
    """Return the number of operations including a division, and minus the denominator's degree, to order degrees."""
    above, below = degrees
    return above + below + (DIVISION if below else 0), -below


def search(kernel: Kernel) -> Shape:
    """Return the shape of a kernel, or raise `ProofError` if no shape meets the goals of the tiers.

    A quotient has the best tier alone.
    """
    cheap = []
    if len(kernel.closed) == 1:
        cheap = [degrees(kernel, tier) for tier in TIERS if tier not in ("best", "float32")]
        with suppress(ProofError):  # without such a tier the best one's results are rounded
            cheap.append(degrees(kernel, "float32"))
    return Shape(best(kernel), tuple(cheap))


def complete() -> str:
    """Search for the shapes of kernels without a record, record them for this run, and return their names."""
    missing = {k.definition: k for k in shapes.kernels() if k.definition not in recorded_shapes()}
    searched = parallel(search, [[x] for x in missing.values()], "shapes searched")
    recorded_shapes().update(zip(missing, searched, strict=True))
    return ", ".join(map(" / ".join, missing)) or "none"
