"""The search for shapes: seams, baselines and degrees, judged by the bound that is proved of the program they make.

Nothing in it is random and nothing is timed, so that it finds the same on every machine. What approximates badly or
must round badly is left out by an estimate; of the rest the checker says which is best.
"""

import math
from collections.abc import Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from functools import cache, partial
from itertools import product

import numpy as np
import sympy as sp
from flint import arb

from derive.approximate import certificates, shapes
from derive.approximate.minimax import minimax
from derive.approximate.minimax import value as at
from derive.approximate.programs import Variant, variant
from derive.approximate.shapes import HALF_PI, Far, Kernel, Pieces, Shape, end, records
from derive.check import certify
from derive.check.proof import ProofError
from derive.check.records import TIERS
from derive.declare.symbols import alpha

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
    made = [variant(kernel, tier, form, shape) for form in ("fused", "plain")]
    try:
        for one in made:
            record = certificates.plain(one)
            goal = TIERS[tier].goal(record)
            certify.prove(record | {"bound": goal, "bound_to_quarter_pi": goal, "bound_underflow": math.inf})
    except ProofError:
        return []
    return made


def rises(closed: sp.Expr, seam: float) -> bool:
    """Whether F grows at the seam by more than both pieces' errors from one double to the next."""
    step, f = math.ulp(math.nextafter(seam, 0.0)), float(at(closed, arb(seam)))
    return float(at(sp.diff(closed, alpha), arb(seam))) * step > 1.4 * certify.ulp(f, 53)


@cache
def baseline(closed: sp.Expr, seam: float) -> Far:
    """The baseline whose operations leave the least, by an estimate of half an ulp each, over ulp(F)."""
    points = [seam + (HALF_PI - seam) * k / 24 for k in range(25)]
    values = [(x, float(at(closed, arb(x)))) for x in points]
    about, end_value = end(closed), values[-1][1]
    ulps = 3 if about.log else 1
    found = []
    for slope in SLOPES:
        left = [f - slope * x for x, f in values]
        lines = {math.floor((end_value - slope * HALF_PI) * 2**52) / 2**52}
        lines |= {k / 128 for k in range(math.floor(min(left) * 128), math.ceil(max(left) * 128) + 1)}
        for line, bend in product(sorted(lines), [0.0] if about.odd else [k / 8 for k in range(25)]):
            power, _ = shapes.powers(closed, Far(slope, line, bend, 1.0, 0))
            constant, worst = end_value - slope * HALF_PI - line, 0.0
            for x, f in values[:-1]:
                b, rest = HALF_PI - x, f - (slope * x + line)
                bent = 0.0 if about.odd else b * (slope - bend * b)
                core = (rest - bent - constant) / b**power
                error = 0.0 if abs(f - rest) <= slope * (1 if x < 1 else 2) or not slope else math.ulp(f - rest)
                error += math.ulp(constant) + math.ulp(rest)
                error += b**power * (ulps * math.ulp(core) + abs(core) / 2**52)
                error += 0.0 if about.odd else math.ulp(rest - bent) + b * math.ulp(slope - bend * b)
                worst = max(worst, error / certify.ulp(f, 53))
            found.append((worst, abs(bend - about.first), slope, line, bend))
    _, _, slope, line, bend = min(found)
    return Far(slope, line, bend, 1.0, 0)


def started(kernel: Kernel, seam: float) -> Best:
    """Pieces for a seam: the baseline that an estimate prefers, and the least degrees that approximate."""
    found = []
    for closed in kernel.closed:
        far, until = None, HALF_PI
        if end(closed).serves:
            until = seam
            for degree in range(3, 13):
                far = replace(baseline(closed, seam), degree=degree)
                fit = shapes.far_fit(closed, far, seam)
                lost = math.ulp(fit.constant) / float(at(closed, arb(seam)))  # as the constant is rounded
                if fit.error < NEGLIGIBLE + lost:
                    break
        samples = ((n, shapes.near_samples(closed, until, n, shapes.limit(closed))) for n in range(7, 40))
        found.append(Pieces(until, next(n for n, x in samples if minimax(x, n - 1)[2] < NEGLIGIBLE), KEPT, far))
    return tuple(found)


def falls(variant: Variant, seam: float) -> bool:
    """Whether a base quantity falls from the last double below the seam to the first above; fused, anywhere near."""
    near = 1000 if variant.form == "fused" else 1
    alpha = (np.float64(seam).view(np.int64) + np.arange(-near, near)).view(np.float64)
    return bool(np.any(np.diff(variant.program.run(alpha[alpha <= HALF_PI])) < 0))


def neighbours(kernel: Kernel, shape: Best) -> Iterator[Best]:
    """Shapes a step away: the seam, and of each part degrees and baseline."""
    for more in (-1, 1):
        yield tuple(replace(p, seam=round(p.seam + more / 100, 2)) if p.far else p for p in shape)
    for k, (closed, part) in enumerate(zip(kernel.closed, shape, strict=True)):
        moves = [replace(part, count=part.count + more) for more in (-1, 1)]
        moves += [replace(part, kept=part.kept + more) for more in (-1, 1) if 2 <= part.kept + more < part.count - 2]
        if far := part.far:
            about = end(closed)
            changed = [replace(far, degree=far.degree + more) for more in (-1, 1)]
            changed += [replace(far, line=far.line + more / 128) for more in (-4, -1, 1, 4)]
            changed += [] if about.odd else [replace(far, bend=far.bend + more / 8) for more in (-1, 1)]
            changed += [replace(far, scale=3 - far.scale)] if about.log else []
            moves += [replace(part, far=beyond) for beyond in changed]
        for move in moves:
            yield (*shape[:k], move, *shape[k + 1 :])


def refined(kernel: Kernel, trials: int) -> Best | None:
    """The pieces with the least bound and the fewest operations; None if none keeps its goals.

    For each seam the baseline that an estimate prefers, and from the best of these on whatever is better next to it. A
    base quantity has its seam where it cannot fall there, or, if none is found, where it may fall by an ulp.
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
    found = ranked(started(kernel, seam) for seam in seams)
    done: set[Best] = set()
    while left := [shape for shape in found[:2] if shape not in done]:
        done.add(left[0])
        found = ranked(neighbours(kernel, left[0]))
    spare = None
    for shape in found[:6]:
        if made := kept(kernel, "best", shape):
            if others or not any(falls(v, shape[0].seam) for v in made):
                return shape
            spare = spare or shape
    return spare


def best(kernel: Kernel, trials: int = TRIALS) -> Best:
    """The recorded pieces, unless those that are found are better by more than MARGIN.

    So a search that is repeated, or that judges few, changes nothing.
    """
    found, known = refined(kernel, trials), records().get(kernel.definition)
    if known and kept(kernel, "best", known.best):
        found = known.best if not found or price(kernel, known.best) <= price(kernel, found) + MARGIN else found
    if found is None:
        goal = TIERS["best"].quotient if len(kernel.closed) > 1 else TIERS["best"].fused
        raise ProofError(f"{kernel.name}: bound of tier best", "none of the shapes that were tried keeps it", goal)
    return found


def degrees(kernel: Kernel, tier: str) -> tuple[str, int, int]:
    """The cheapest polynomial or quotient of two that keeps what its tier promises."""
    (closed,) = kernel.closed
    goal = TIERS[tier].fused
    target = (goal - 0.5) * 2.0**-24 if goal > 0.5 else goal
    tried = [(above, 0) for above in range(2, 25)]
    tried += [(above, total - above) for total in range(6, 25) for above in ((total + 1) // 2, total // 2)]
    for above, below in sorted(set(tried), key=lambda x: (x[0] + x[1] + (DIVISION if x[1] else 0), -x[1])):
        try:
            if shapes.cheap_fit(closed, above, below)[2] > target:
                continue
        except ZeroDivisionError:  # the levelled system has no solution
            continue
        if kept(kernel, tier, (above, below)):
            return tier, above, below
    raise ProofError(f"{kernel.name}: tier {tier}", "no degrees that keep it", f"{goal:g}")


def search(kernel: Kernel, trials: int = TRIALS) -> Shape:
    """Find the shape of a kernel, or raise `ProofError` if none keeps what the tiers promise.

    A quotient has the best tier alone.
    """
    cheap = [degrees(kernel, tier) for tier in TIERS if tier != "best"] if len(kernel.closed) == 1 else []
    return Shape(best(kernel, trials), tuple(cheap))


def complete(anew: bool, trials: int) -> str:
    """Search for the shapes of all kernels, or of those without a record, and record them for this run; which ones."""
    wanted = {k.definition: k for k in shapes.kernels() if anew or k.definition not in records()}
    if wanted:
        with ProcessPoolExecutor(2) as pool:
            records().update(zip(wanted, pool.map(partial(search, trials=trials), wanted.values()), strict=True))
    return ", ".join(" / ".join(definition) for definition in wanted) or "none"
