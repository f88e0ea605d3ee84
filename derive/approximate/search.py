"""The search for shapes: seams, baselines and degrees, judged by the bound that is proved of the program they make.

Nothing in it is random and nothing is timed, so that it finds the same on every machine. What approximates badly or
must round badly is left out by an estimate; of the rest the checker says which is best.
"""

import math
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from functools import cache, partial
from itertools import product

import numpy as np
from flint import arb
from sympy import Expr, diff

from derive.approximate import certificates, shapes
from derive.approximate.minimax import minimax
from derive.approximate.minimax import value as at
from derive.approximate.programs import Variant, variant
from derive.approximate.shapes import HALF_PI, Far, Kernel, Pieces, Shape, end, records
from derive.check import certify
from derive.check.proof import ProofError
from derive.check.records import TIERS
from derive.declare.symbols import alpha
from derive.progress import track

SEAMS = [k / 100 for k in range(64, 124, 4)]
SLOPES = (0.0, 0.25, 0.5, 1.0, 2.0)
NEGLIGIBLE = 2.0**-58  # relative error of approximation to start from: a thirtieth of an ulp at most
HALVINGS = 100
FROM, TO = 0.5, 1.5625  # where seam and baseline matter
DIVISION = 8  # what a division costs, in multiply-adds
OPERATION = 0.02  # what a multiply-add is worth, in ulp
MARGIN = 0.05  # by how much less a shape's price has to be to take the place of the recorded one, in ulp
KEPT = 3  # leading sums near 0 whose roundings are kept, to start from
TRIALS = 40  # shapes judged at most, for one quantity

Best = tuple[Pieces, ...]


def price(kernel: Kernel, shape: Best) -> float:
    """Of the best tier, fused: the bound that is proved between FROM and TO, and what its operations are worth."""
    fused = variant(kernel, "best", "fused", shape)
    record = certificates.plain(fused)
    proved, _ = certify.halve(record, list(certify.patches(record, FROM, TO)), halvings=HALVINGS)
    return proved + OPERATION * sum(fused.program.operations().values())


def kept(kernel: Kernel, tier: str, shape: Best | tuple[int, int]) -> list[Variant]:
    """A tier's fused and plain form in this shape; none if a bound cannot be proved to be within what it promises."""
    forms = [variant(kernel, tier, form, shape) for form in ("fused", "plain")]
    try:
        for form in forms:
            record = certificates.plain(form)
            goal = TIERS[tier].goal(record)
            certify.prove(record | {"bound": goal, "bound_to_quarter_pi": goal, "bound_underflow": math.inf})
    except ProofError:
        return []
    return forms


def rises(closed: Expr, seam: float) -> bool:
    """Whether F grows at the seam by more than both pieces' errors from one double to the next."""
    step = math.ulp(math.nextafter(seam, 0.0))
    f = float(at(closed, arb(seam)))
    slope = float(at(diff(closed, alpha), arb(seam)))
    return slope * step > 1.4 * certify.ulp(f, 53)


@cache
def baseline(closed: Expr, seam: float) -> Far:
    """The baseline whose operations leave the least error, by an estimate of half an ulp each, over ulp(F)."""
    points = [seam + (HALF_PI - seam) * k / 24 for k in range(25)]
    values = [(x, float(at(closed, arb(x)))) for x in points]
    end_value = values[-1][1]
    about = end(closed)
    bends = [0.0] if about.odd else [k / 8 for k in range(25)]
    candidates = []
    for slope in SLOPES:
        left = [f - slope * x for x, f in values]
        lines = {math.floor((end_value - slope * HALF_PI) * 2**52) / 2**52}
        lines |= {k / 128 for k in range(math.floor(min(left) * 128), math.ceil(max(left) * 128) + 1)}
        candidates += [Far(slope, line, bend, 1.0, 0) for line, bend in product(sorted(lines), bends)]

    def rank(far: Far) -> tuple[float, ...]:
        error = _baseline_error(closed, far, values)
        return error, abs(far.bend - about.first), far.slope, far.line, far.bend

    return min(candidates, key=rank)


def _baseline_error(closed: Expr, far: Far, values: Sequence[tuple[float, float]]) -> float:
    """Rounding errors of a baseline's operations, in ulp(F) at the worst of some points; the last one is pi/2.

    F = straight + (constant + bent + b**power core), each sum and product rounded once.
    """
    about = end(closed)
    power, _ = shapes.powers(closed, far)
    core_ulps = 3 if about.log else 1
    constant = values[-1][1] - far.slope * HALF_PI - far.line
    worst = 0.0
    for x, f in values[:-1]:
        b = HALF_PI - x
        rest = f - (far.slope * x + far.line)
        bent = 0.0 if about.odd else b * (far.slope - far.bend * b)
        core = (rest - bent - constant) / b**power
        exact_sum = abs(f - rest) <= far.slope * (1 if x < 1 else 2)  # its terms are multiples of 2**-52
        error = 0.0 if exact_sum or not far.slope else math.ulp(f - rest)
        error += math.ulp(constant) + math.ulp(rest)
        error += b**power * (core_ulps * math.ulp(core) + abs(core) / 2**52)
        if not about.odd:
            error += math.ulp(rest - bent) + b * math.ulp(far.slope - far.bend * b)
        worst = max(worst, error / certify.ulp(f, 53))
    return worst


def started(kernel: Kernel, seam: float) -> Best:
    """Pieces for a seam: the baseline that an estimate prefers, and the least degrees that approximate."""
    pieces = []
    for closed in kernel.closed:
        serves = end(closed).serves
        until = seam if serves else HALF_PI
        far = _least_far(closed, seam) if serves else None
        samples = ((n, shapes.near_samples(closed, until, n, shapes.limit(closed))) for n in range(7, 40))
        count = next(n for n, x in samples if minimax(x, n - 1)[2] < NEGLIGIBLE)
        pieces.append(Pieces(until, count, KEPT, far))
    return tuple(pieces)


def _least_far(closed: Expr, seam: float) -> Far:
    """The preferred baseline with the least degree that approximates, or the greatest tried."""
    for degree in range(3, 13):
        far = replace(baseline(closed, seam), degree=degree)
        fit = shapes.far_fit(closed, far, seam)
        constant_error = math.ulp(fit.constant) / float(at(closed, arb(seam)))  # as the constant is rounded
        if fit.error < NEGLIGIBLE + constant_error:
            break
    return far


def falls(variant: Variant, seam: float) -> bool:
    """Whether a base quantity falls from the last double below the seam to the first above; fused, anywhere near."""
    near = 1000 if variant.form == "fused" else 1
    alpha = (np.float64(seam).view(np.int64) + np.arange(-near, near)).view(np.float64)
    return bool(np.any(np.diff(variant.program.run(alpha[alpha <= HALF_PI])) < 0))


def neighbours(kernel: Kernel, shape: Best) -> Iterator[Best]:
    """Shapes a step away: the seam, and of each part degrees and baseline."""
    for step in (-1, 1):
        yield tuple(replace(p, seam=round(p.seam + step / 100, 2)) if p.far else p for p in shape)
    for k, (closed, part) in enumerate(zip(kernel.closed, shape, strict=True)):
        moves = [replace(part, count=part.count + step) for step in (-1, 1)]
        moves += [replace(part, kept=part.kept + step) for step in (-1, 1) if 2 <= part.kept + step < part.count - 2]
        if part.far:
            moves += [replace(part, far=far) for far in _neighbours_of_far(closed, part.far)]
        for move in moves:
            yield (*shape[:k], move, *shape[k + 1 :])


def _neighbours_of_far(closed: Expr, far: Far) -> Iterator[Far]:
    """Other degrees, lines, bends and scales, where the form has them."""
    about = end(closed)
    for step in (-1, 1):
        yield replace(far, degree=far.degree + step)
    for step in (-4, -1, 1, 4):
        yield replace(far, line=far.line + step / 128)
    if not about.odd:
        for step in (-1, 1):
            yield replace(far, bend=far.bend + step / 8)
    if about.log:
        yield replace(far, scale=3 - far.scale)


def refined(kernel: Kernel, trials: int) -> Best | None:
    """The pieces with the least bound and the fewest operations; None if none keeps its goals.

    For each seam the baseline that an estimate prefers, and from the best of these on whatever is better next to it. A
    base quantity has its seam where it cannot fall there, or, if there is none, where it may fall by an ulp.
    """
    closed, *others = kernel.closed
    judged: dict[Best, float] = {}

    def ranked(tried: Iterable[Best]) -> list[Best]:
        for shape in tried:
            if shape not in judged and len(judged) < trials:
                judged[shape] = price(kernel, shape)
        return sorted(judged, key=lambda shape: (judged[shape], str(shape)))

    seams = [seam for seam in SEAMS if others or rises(closed, seam)] or SEAMS
    seams = seams[-9:] if any(end(form).serves for form in kernel.closed) else SEAMS[:1]
    ranking = ranked(started(kernel, seam) for seam in seams)
    explored: set[Best] = set()
    while left := [shape for shape in ranking[:2] if shape not in explored]:
        explored.add(left[0])
        ranking = ranked(neighbours(kernel, left[0]))
    spare = None
    for shape in ranking[:6]:
        if forms := kept(kernel, "best", shape):
            if others or not any(falls(form, shape[0].seam) for form in forms):
                return shape
            spare = spare or shape
    return spare


def best(kernel: Kernel, trials: int = TRIALS) -> Best:
    """The recorded pieces, unless the search's are better by more than MARGIN.

    So a search that is repeated, or that judges few, changes nothing.
    """
    chosen = refined(kernel, trials)
    known = records().get(kernel.definition)
    if known and kept(kernel, "best", known.best):
        recorded = known.best
        if chosen is None or price(kernel, recorded) <= price(kernel, chosen) + MARGIN:
            return recorded
    if chosen is None:
        goal = TIERS["best"].quotient if len(kernel.closed) > 1 else TIERS["best"].fused
        raise ProofError(f"{kernel.name}: bound of tier best", "none of the shapes that were tried keeps it", goal)
    return chosen


def degrees(kernel: Kernel, tier: str) -> tuple[str, int, int]:
    """The cheapest polynomial or quotient of two that keeps what its tier promises."""
    (closed,) = kernel.closed
    goal = TIERS[tier].fused
    target = (goal - 0.5) * 2.0**-24 if goal > 0.5 else goal
    polynomials = [(above, 0) for above in range(2, 25)]
    quotients = [(above, total - above) for total in range(6, 25) for above in ((total + 1) // 2, total // 2)]

    def cost(x: tuple[int, int]) -> tuple[int, int]:
        above, below = x
        return above + below + (DIVISION if below else 0), -below

    for above, below in sorted({*polynomials, *quotients}, key=cost):
        try:
            _, _, error = shapes.cheap_fit(closed, above, below)
        except ZeroDivisionError:  # the levelled system has no solution
            continue
        if error <= target and kept(kernel, tier, (above, below)):
            return tier, above, below
    raise ProofError(f"{kernel.name}: tier {tier}", "no degrees that keep it", f"{goal:g}")


def search(kernel: Kernel, trials: int = TRIALS) -> Shape:
    """Find the shape of a kernel, or raise `ProofError` if none keeps what the tiers promise.

    A quotient has the best tier alone.
    """
    cheap = []
    if len(kernel.closed) == 1:
        cheap = [degrees(kernel, tier) for tier in TIERS if tier != "best"]
    return Shape(best(kernel, trials), tuple(cheap))


def complete(anew: bool, trials: int) -> str:
    """Search for the shapes of all kernels, or of those without a record, and record them for this run; which ones."""
    missing = {k.definition: k for k in shapes.kernels() if anew or k.definition not in records()}
    if missing:
        with ProcessPoolExecutor(2) as pool:
            searched = pool.map(partial(search, trials=trials), missing.values())
            records().update(zip(missing, track(searched, "shapes searched", len(missing)), strict=True))
    return ", ".join(" / ".join(definition) for definition in missing) or "none"
