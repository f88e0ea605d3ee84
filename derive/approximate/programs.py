"""The certified kernels' programs: an approximant of F(alpha)/alpha**3 near 0, and of F less a straight line near pi/2.

Near: F = x u W, where u = x**2 and W = c0 + u (c1 + u (c2 + ...)). Fused, the rounding errors of u, of u W and of the
leading sums of W are kept, as many as the shape says. Far, in b = fl(pi/2) - x (exact there): F = line(x) +
correction(b), the line without rounding, so that the small correction needs no care. Every piece is computed for
every x, and one chosen.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache

import sympy as sp

from derive.approximate.shapes import (
    HALF_PI,
    Far,
    Kernel,
    Pieces,
    Shape,
    cheap_fit,
    end,
    far_fit,
    kernels,
    limit,
    logarithm_fit,
    near_fit,
    records,
)
from derive.code.program import Kind, Op, Program, without_dead


@dataclass(frozen=True)
class Variant:
    """A kernel at one tier of accuracy and in one form: fused (multiply-adds), plain, or numpy (with its logarithm)."""

    kernel: str
    definition: tuple[str, ...]
    tier: str
    form: str
    program: Program


@dataclass(frozen=True)
class Pair:
    """An unevaluated sum."""

    high: int
    low: int


# --- straight-line code --------------------------------------------------------------------------------------------


@dataclass
class Code:
    """Operations as they are written; in a plain form a multiply-add is two of them."""

    form: str
    ops: list[Op] = field(default_factory=list)
    index: dict[Op, int] = field(default_factory=dict)

    @property
    def fused(self) -> bool:
        """Whether multiply-adds are one operation."""
        return self.form == "fused"

    def put(self, kind: Kind, *args: int, value: str | float | None = None) -> int:
        """Append an operation, or find the equal one that is there."""
        key = Op(kind, args, value.hex() if isinstance(value, float) else value)
        if key not in self.index:
            self.index[key] = len(self.ops)
            self.ops.append(Op(kind, args, value))
        return self.index[key]

    def const(self, value: float) -> int:
        return self.put("const", value=value)

    def add(self, a: int, b: int) -> int:
        return self.put("add", a, b)

    def sub(self, a: int, b: int) -> int:
        return self.put("sub", a, b)

    def mul(self, a: int, b: int) -> int:
        return self.put("mul", a, b)

    def neg(self, a: int) -> int:
        return self.put("neg", a)

    def fma(self, a: int, b: int, c: int) -> int:
        """a b + c, rounded once where fused."""
        if self.fused:
            return self.put("fma", a, b, c)
        product, last = self.mul(a, b), self.ops[c]
        return self.sub(product, last.args[0]) if last.kind == "neg" else self.add(product, c)

    def horner(self, x: int, coefficients: Sequence[float]) -> int:
        """The polynomial with these coefficients, lowest first."""
        result = self.const(coefficients[-1])
        for c in reversed(coefficients[:-1]):
            result = self.fma(result, x, self.const(c))
        return result

    def halves(self, x: int, coefficients: Sequence[float]) -> int:
        """The same as its even and its odd part: for one product more half as many operations wait for each other."""
        y = self.mul(x, x)
        return self.fma(x, self.horner(y, coefficients[1::2]), self.horner(y, coefficients[::2]))

    def below(self, x: int, seam: float, near: int, far: int) -> int:
        """`near` where x < seam, else `far`."""
        return self.put("select", self.put("less", x, self.const(seam)), near, far)

    def program(self, name: str, output: int) -> Program:
        """The operations that the output needs."""
        return without_dead(Program(name, ("alpha",), tuple(self.ops), (output,)))


# --- pieces --------------------------------------------------------------------------------------------------------


def excess(code: Code, u: int, closed: sp.Expr, piece: Pieces) -> int:
    """Plain: q of W = 1 + q, F = x (u + u q) times the limit. A rounded 2/3 inside W would lean to one side."""
    return code.mul(code.horner(u, near_fit(closed, piece.seam, piece.count, Fraction(1))), u)


def to_limit(code: Code, closed: sp.Expr, w: int) -> int:
    """w times 1 or 2/3, rounded once."""
    return w if limit(closed) == 1 else code.put("div", w, code.const(float(1 / limit(closed))))


def near_sum(code: Code, u: int, closed: sp.Expr, piece: Pieces) -> tuple[Pair, int, int]:
    """Fused: W and what its roundings lost; d(u W)/du; and P1 = (W - c0)/u, which is nearly W'."""
    exact, kept = limit(closed), piece.kept
    c = (float(exact), *near_fit(closed, piece.seam, piece.count, exact))
    sums = [code.fma(u, code.halves(u, c[kept + 1 :]), code.const(c[kept]))]
    for coefficient in reversed(c[:kept]):
        sums.insert(0, code.fma(sums[0], u, code.const(coefficient)))
    turns, lost = [], []
    for k in range(kept):
        turns.append(code.sub(code.const(c[k]), sums[k]))
        lost.append(code.fma(sums[k + 1], u, turns[k]))
    c0_low = float(exact - Fraction(c[0]))
    lost[0] = code.add(lost[0], code.const(c0_low)) if c0_low else lost[0]
    low = lost[-1]
    for error in reversed(lost[:-1]):
        low = code.fma(u, low, error)
    slope = sums[0]
    if c0_low:  # u W' is nearly W - c0 + u (P1 - c1); left out where W stays close to 1
        slope = code.fma(code.neg(u), turns[1], code.fma(code.const(2.0), sums[0], code.const(-c[0])))
    return Pair(sums[0], low), slope, sums[1]


def near(code: Code, x: int, closed: sp.Expr, piece: Pieces) -> Pair:
    """F = x h + x h_low, h = u W."""
    u = code.mul(x, x)
    du = code.fma(x, x, code.neg(u))
    w, slope, _ = near_sum(code, u, closed, piece)
    h = code.mul(u, w.high)
    return Pair(h, code.fma(u, w.low, code.fma(du, slope, code.fma(u, w.high, code.neg(h)))))


def near_value(code: Code, x: int, closed: sp.Expr, piece: Pieces) -> int:
    """F; rounded, or underflowing, once at the end: a product with a power of x comes last."""
    if code.fused:
        h = near(code, x, closed, piece)
        return code.fma(x, h.high, code.mul(x, h.low))
    u = code.mul(x, x)
    return code.mul(to_limit(code, closed, code.fma(u, excess(code, u, closed, piece), u)), x)


def logarithm(code: Code, b: int) -> int:
    """ln b of a b >= 0; at 0 something finite, which a factor 0 waits for.

    b = 2**exponent significand, s = significand - 1 (exact), q = s/(2 + s): ln(1 + s) = s - q (s - z P(z)), z = q**2,
    whose largest part is exact.
    """
    b = code.put("max", b, code.const(2.0**-60))
    if code.form == "numpy":
        return code.put("call", b, value="log")
    ln2, coefficients = logarithm_fit(6)
    s = code.sub(code.put("call", b, value="significand"), code.const(1.0))
    q = code.put("div", s, code.add(s, code.const(2.0)))
    z = code.mul(q, q)
    bent = code.fma(z, code.horner(z, coefficients), code.neg(s))
    head = code.fma(code.put("call", b, value="exponent"), code.const(ln2), s)
    return code.fma(q, bent, head)


def far(code: Code, x: int, closed: sp.Expr, shape: Far, seam: float) -> Pair:
    """The piece near pi/2 as `FarFit` has it: the line, and what is added to it."""
    fit, about = far_fit(closed, shape, seam), end(closed)
    assert about is not None
    b = code.sub(code.const(HALF_PI), x)
    w = code.mul(b, b)
    core = code.horner(w, fit.r)
    if fit.q:
        q = code.horner(w, fit.q)
        for _ in range(fit.shift):
            q = code.mul(q, w)
        core = code.fma(q, logarithm(code, b if shape.scale == 1 else code.mul(code.const(shape.scale), b)), core)
    front = {1: b, 2: w}.get(fit.power) or (code.mul(b, w) if fit.power == 3 else code.mul(w, w))
    ahead = code.const(fit.constant) if fit.constant else None
    if fit.tilt:
        tilt = code.const(fit.tilt)
        ahead = code.mul(b, tilt) if ahead is None else code.fma(b, tilt, ahead)
    rest = code.mul(front, core) if ahead is None else code.fma(front, core, ahead)
    if not about.odd and (shape.bend or shape.slope):
        rest = code.fma(b, code.fma(b, code.const(-shape.bend), code.const(shape.slope)), rest)
    if not shape.slope:
        return Pair(code.const(shape.line), rest)
    line = x if shape.slope == 1 else code.mul(code.const(shape.slope), x)
    return Pair(code.add(line, code.const(shape.line)), rest)


# --- best tier -----------------------------------------------------------------------------------------------------


def best(kernel: Kernel, parts: Sequence[Pieces], form: str) -> Program:
    """The best tier: a base quantity, or a quotient whose parts have one seam, to the last place or nearly so."""
    code = Code(form)
    x = code.put("input", value="alpha")
    make = whole if len(parts) == 1 else fused_quotient if code.fused else plain_quotient
    return code.program(kernel.name, make(code, x, kernel.closed, parts))


def whole(code: Code, x: int, forms: Sequence[sp.Expr], parts: Sequence[Pieces]) -> int:
    """F near 0, and beyond the seam."""
    (closed,), (shape,) = forms, parts
    value = near_value(code, x, closed, shape)
    if shape.far is None:
        return value
    beyond = far(code, x, closed, shape.far, shape.seam)
    return code.below(x, shape.seam, value, code.add(beyond.high, beyond.low))


def fused_quotient(code: Code, x: int, forms: Sequence[sp.Expr], parts: Sequence[Pieces]) -> int:
    """F1/F2, near from W1/W2: one division, its rounding and its parts' taken back."""
    seam = min(part.seam for part in parts)
    over, under = (fused_part(code, x, closed, part, seam) for closed, part in zip(forms, parts, strict=True))
    inverse = code.put("div", code.const(1.0), under.high)
    q = code.mul(over.high, inverse)
    missed = code.add(code.fma(code.neg(q), under.high, over.high), over.low)
    return code.fma(code.fma(code.neg(q), under.low, missed), inverse, q)


def plain_quotient(code: Code, x: int, forms: Sequence[sp.Expr], parts: Sequence[Pieces]) -> int:
    """F1/F2, near from W1/W2 over their limits."""
    seam, found = min(part.seam for part in parts), []
    for closed, part in zip(forms, parts, strict=True):
        value = plain_part(code, x, closed, part, seam)
        same = limit(forms[0]) == limit(forms[1])
        found.append(value if same else code.below(x, seam, to_limit(code, closed, value), value))
    return code.put("div", *found)


def fused_part(code: Code, x: int, closed: sp.Expr, part: Pieces, seam: float) -> Pair:
    """W below the seam, F above it; what is lost in `low`."""
    u = code.mul(x, x)
    w, _, p1 = near_sum(code, u, closed, part)
    w = Pair(w.high, code.fma(code.fma(x, x, code.neg(u)), p1, w.low))
    if part.far:
        beyond = far(code, x, closed, part.far, seam)
        total = code.add(beyond.high, beyond.low)
        lost = code.sub(beyond.low, code.sub(total, beyond.high))
    else:
        h = near(code, x, closed, part)
        total = code.mul(x, h.high)
        lost = code.fma(x, h.low, code.fma(x, h.high, code.neg(total)))
    return Pair(code.below(x, seam, w.high, total), code.below(x, seam, w.low, lost))


def plain_part(code: Code, x: int, closed: sp.Expr, part: Pieces, seam: float) -> int:
    """W below the seam, but for its limit, F above it."""
    w = code.add(code.const(1.0), excess(code, code.mul(x, x), closed, part))
    if not part.far:
        return code.below(x, seam, w, near_value(code, x, closed, part))
    beyond = far(code, x, closed, part.far, seam)
    return code.below(x, seam, w, code.add(beyond.high, beyond.low))


# --- cheaper tiers -------------------------------------------------------------------------------------------------


def cheap(kernel: Kernel, degrees: Sequence[int], form: str) -> Program:
    """x u (numerator/denominator): one polynomial or one quotient of two over the whole domain."""
    over, under, _ = cheap_fit(*kernel.closed, *degrees)
    code = Code(form)
    x = code.put("input", value="alpha")
    u = code.mul(x, x)
    if len(under) == 1:
        return code.program(kernel.name, code.mul(code.mul(code.horner(u, over), u), x))
    w = code.sub(code.const(HALF_PI * HALF_PI), u)
    ratio = code.put("div", code.mul(code.horner(w, over), u), code.horner(w, under))
    return code.program(kernel.name, code.mul(ratio, x))


# --- all of them ---------------------------------------------------------------------------------------------------


@cache
def of(kernel: Kernel, shape: Shape) -> tuple[Variant, ...]:
    """A kernel in every tier and form; a form `numpy` only where it differs from `plain`."""

    def variant(tier: str, form: str, program: Program) -> Variant:
        return Variant(kernel.name, kernel.definition, tier, form, program)

    made = {form: best(kernel, shape.best, form) for form in ("fused", "plain", "numpy")}
    if made["numpy"] == made["plain"]:
        del made["numpy"]
    found = [variant("best", form, program) for form, program in made.items()]
    for tier, *degrees in shape.cheap:
        found += [variant(tier, form, cheap(kernel, degrees, form)) for form in ("fused", "plain")]
    return tuple(found)


def variants() -> tuple[Variant, ...]:
    """Every kernel in every tier and form, from the recorded shapes."""
    return tuple(v for kernel in kernels() for v in of(kernel, records()[kernel.definition]))
