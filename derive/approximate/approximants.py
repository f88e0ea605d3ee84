"""The certified kernels' programs: an approximant of F(alpha)/alpha**3 near 0, and of F less a straight line near pi/2.

Near: F = x u W, where u = x**2 and W = c0 + u (c1 + u P2(u)). Fused, the rounding errors of u, of u W and of the two
leading sums of W are kept. Far, in b = fl(pi/2) - x (exact there): F = line(x) + correction(b), the line without
rounding, so that the small correction needs no care. Every piece is computed for every x, and one chosen.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from derive.approximate.fit import (
    HALF_PI,
    LIMIT,
    cheap_fit,
    inertia_fit,
    logarithm_fit,
    near_fit,
    polar_fit,
    radial_fit,
    weight_even_fit,
    weight_fit,
)
from derive.code.program import Kind, Op, Program, without_dead
from derive.declare.quantities import QUOTIENTS


@dataclass(frozen=True)
class Variant:
    """A kernel at one tier of accuracy and in one form: fused (multiply-adds), plain, or numpy (with its logarithm)."""

    kernel: str
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


def excess(code: Code, u: int, name: str, seam: float, degree: int) -> int:
    """Plain: q of W = 1 + q, F = x (u + u q) times the limit. A rounded 2/3 inside W would lean to one side."""
    return code.mul(code.horner(u, near_fit(name, seam, degree, Fraction(1))), u)


def to_limit(code: Code, name: str, w: int) -> int:
    """w times 1 or 2/3, rounded once."""
    return w if LIMIT[name] == 1 else code.put("div", w, code.const(float(1 / LIMIT[name])))


def near_sum(code: Code, u: int, name: str, seam: float, degree: int) -> tuple[Pair, int, int]:
    """Fused: W and what its roundings lost; d(u W)/du; and P1 = (W - c0)/u, which is nearly W'."""
    c = near_fit(name, seam, degree, LIMIT[name])
    c0 = float(LIMIT[name])
    c0_low = float(LIMIT[name] - Fraction(c0))
    p2 = code.fma(u, code.halves(u, c[2:]), code.const(c[1]))
    p1 = code.fma(p2, u, code.const(c[0]))
    w = code.fma(p1, u, code.const(c0))
    low = code.fma(p1, u, code.sub(code.const(c0), w))
    turn = code.sub(code.const(c[0]), p1)
    low = code.fma(u, code.fma(p2, u, turn), code.add(low, code.const(c0_low)) if c0_low else low)
    slope = w
    if c0_low:  # u W' is nearly W - c0 + u (P1 - c1); left out where W stays close to 1
        slope = code.fma(code.neg(u), turn, code.fma(code.const(2.0), w, code.const(-c0)))
    return Pair(w, low), slope, p1


def near(code: Code, x: int, name: str, seam: float, degree: int) -> Pair:
    """F = x h + x h_low, h = u W."""
    u = code.mul(x, x)
    du = code.fma(x, x, code.neg(u))
    w, slope, _ = near_sum(code, u, name, seam, degree)
    h = code.mul(u, w.high)
    return Pair(h, code.fma(u, w.low, code.fma(du, slope, code.fma(u, w.high, code.neg(h)))))


def near_value(code: Code, x: int, name: str, seam: float, degree: int) -> int:
    """F; rounded, or underflowing, once at the end: a product with a power of x comes last."""
    if code.fused:
        h = near(code, x, name, seam, degree)
        return code.fma(x, h.high, code.mul(x, h.low))
    u = code.mul(x, x)
    return code.mul(to_limit(code, name, code.fma(u, excess(code, u, name, seam, degree), u)), x)


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


def polar_far(code: Code, x: int, seam: float, degree: int) -> Pair:
    """(alpha + line) + (constant + b**3 (R + Q ln b)), R and Q in b**2."""
    line, constant, r, q = polar_fit(seam, degree)
    b = code.sub(code.const(HALF_PI), x)
    w = code.mul(b, b)
    core = code.fma(code.horner(w, q), logarithm(code, b), code.horner(w, r))
    return Pair(code.add(x, code.const(line)), code.fma(code.mul(b, w), core, code.const(constant)))


def radial_far(code: Code, x: int, seam: float, degree: int) -> Pair:
    """(1 - b) + (b (1 - bend b) + b**2 (R + Q ln 2 b)), R and Q in b**2."""
    bend, r, q = radial_fit(seam, degree)
    one, b = code.const(1.0), code.sub(code.const(HALF_PI), x)
    w = code.mul(b, b)
    core = code.fma(code.horner(w, q), logarithm(code, code.mul(code.const(2.0), b)), code.horner(w, r))
    return Pair(code.sub(one, b), code.fma(b, code.fma(b, code.const(-bend), one), code.mul(w, core)))


def inertia_far(code: Code, x: int, seam: float, degree: int) -> Pair:
    """(alpha/2 + line) + (constant + b E(b**2))."""
    line, constant, e = inertia_fit(seam, degree)
    b = code.sub(code.const(HALF_PI), x)
    odd = code.fma(b, code.horner(code.mul(b, b), e), code.const(constant))
    return Pair(code.add(code.mul(code.const(0.5), x), code.const(line)), odd)


def weight_far(code: Code, x: int, seam: float, degree: int) -> Pair:
    """(alpha/2 + line) + (constant + tilt b + b (1/2 - b) + b**4 E(b**2)); plain simply c0 + b**2 E(b**2)."""
    b = code.sub(code.const(HALF_PI), x)
    w = code.mul(b, b)
    if not code.fused:
        c0, *others = weight_even_fit(seam, degree + 2)
        return Pair(code.const(c0), code.mul(w, code.horner(w, others)))
    line, constant, tilt, e = weight_fit(seam, degree)
    bend = code.fma(code.mul(w, w), code.horner(w, e), code.fma(b, code.const(tilt), code.const(constant)))
    bend = code.fma(b, code.sub(code.const(0.5), b), bend)
    return Pair(code.add(code.mul(code.const(0.5), x), code.const(line)), bend)


FAR = {
    "polar_moment": polar_far,
    "moment_of_inertia": inertia_far,
    "radial_weight_amplitude": radial_far,
    "weight_moment_amplitude": weight_far,
}

# --- best tier -----------------------------------------------------------------------------------------------------

# Seam, coefficients near, degree far. Where a seam lies, its doubles are so far apart that F grows by more than both
# pieces' errors from one to the next.
SHAPES = {
    "polar_moment": (0.93, 12, 5),
    "moment_of_inertia": (1.0, 11, 9),
    "radial_weight_amplitude": (1.02, 15, 5),
    "weight_moment_amplitude": (1.14, 10, 6),
    "resistance_factor": (HALF_PI, 8, 0),
}


def best(name: str, form: str) -> Program:
    """A base quantity, to the last place or nearly so."""
    code = Code(form)
    x = code.put("input", value="alpha")
    seam, degree, far_degree = SHAPES[name]
    value = near_value(code, x, name, seam, degree)
    if far_degree:
        far = FAR[name](code, x, seam, far_degree)
        value = code.below(x, seam, value, code.add(far.high, far.low))
    return code.program(name, value)


# Seam of both parts; numerator's and denominator's coefficients near and degrees far.
QUOTIENT_SHAPES = {
    "dynamic_coefficient": (0.93, (12, 5), (8, 0)),
    "weight_moment_per_inertia": (1.0, (10, 6), (11, 9)),
    "radial_weight_per_inertia": (1.03, (16, 5), (12, 9)),
    "polar_moment_per_inertia": (1.0, (14, 5), (11, 9)),
    "weight_moment_per_radial_weight": (1.03, (10, 6), (16, 5)),
}


def quotient(name: str, form: str) -> Program:
    """F1/F2, near from W1/W2: one division, and fused its rounding and its parts' taken back."""
    (parts,) = [(q.numerator, q.denominator) for q in QUOTIENTS if q.name == name]
    seam, *degrees = QUOTIENT_SHAPES[name]
    code = Code(form)
    x = code.put("input", value="alpha")
    if not code.fused:
        top, bottom = (plain_part(code, x, f, seam, *d) for f, d in zip(parts, degrees, strict=True))
        if LIMIT[parts[0]] != LIMIT[parts[1]]:
            top = code.below(x, seam, to_limit(code, parts[0], top), top)
        return code.program(name, code.put("div", top, bottom))
    over, under = (part(code, x, f, seam, *d) for f, d in zip(parts, degrees, strict=True))
    inverse = code.put("div", code.const(1.0), under.high)
    q = code.mul(over.high, inverse)
    missed = code.add(code.fma(code.neg(q), under.high, over.high), over.low)
    return code.program(name, code.fma(code.fma(code.neg(q), under.low, missed), inverse, q))


def part(code: Code, x: int, name: str, seam: float, degree: int, far_degree: int) -> Pair:
    """W below the seam, F above it; what is lost in `low`."""
    end = seam if far_degree else HALF_PI
    u = code.mul(x, x)
    w, _, p1 = near_sum(code, u, name, end, degree)
    w = Pair(w.high, code.fma(code.fma(x, x, code.neg(u)), p1, w.low))
    if far_degree:
        far = FAR[name](code, x, seam, far_degree)
        total = code.add(far.high, far.low)
        lost = code.sub(far.low, code.sub(total, far.high))
    else:
        h = near(code, x, name, end, degree)
        total = code.mul(x, h.high)
        lost = code.fma(x, h.low, code.fma(x, h.high, code.neg(total)))
    return Pair(code.below(x, seam, w.high, total), code.below(x, seam, w.low, lost))


def plain_part(code: Code, x: int, name: str, seam: float, degree: int, far_degree: int) -> int:
    """W below the seam, but for its limit, F above it."""
    w = code.add(code.const(1.0), excess(code, code.mul(x, x), name, seam if far_degree else HALF_PI, degree))
    if not far_degree:
        return code.below(x, seam, w, near_value(code, x, name, HALF_PI, degree))
    far = FAR[name](code, x, seam, far_degree)
    return code.below(x, seam, w, code.add(far.high, far.low))


# --- cheaper tiers -------------------------------------------------------------------------------------------------

# Degrees of numerator and denominator of F/alpha**3: a polynomial in alpha**2, or a rational in pi**2/4 - alpha**2.
DEGREES = {
    "1e-10": {
        "polar_moment": (7, 7),
        "moment_of_inertia": (9, 0),
        "radial_weight_amplitude": (10, 10),
        "weight_moment_amplitude": (8, 0),
        "resistance_factor": (5, 0),
    },
    "1e-6": {
        "polar_moment": (8, 0),
        "moment_of_inertia": (6, 0),
        "radial_weight_amplitude": (4, 5),
        "weight_moment_amplitude": (5, 0),
        "resistance_factor": (3, 0),
    },
    "float32": {
        "polar_moment": (7, 6),
        "moment_of_inertia": (8, 0),
        "radial_weight_amplitude": (9, 9),
        "weight_moment_amplitude": (7, 0),
        "resistance_factor": (5, 0),
    },
}


def cheap(name: str, tier: str, form: str) -> Program:
    """x u (numerator/denominator): one polynomial or one quotient of two over the whole domain."""
    above, below = DEGREES[tier][name]
    over, under = cheap_fit(name, above, below)
    code = Code(form)
    x = code.put("input", value="alpha")
    u = code.mul(x, x)
    if not below:
        return code.program(name, code.mul(code.mul(code.horner(u, over), u), x))
    w = code.sub(code.const(HALF_PI * HALF_PI), u)
    ratio = code.put("div", code.mul(code.horner(w, over), u), code.horner(w, under))
    return code.program(name, code.mul(ratio, x))


# --- all of them ---------------------------------------------------------------------------------------------------


def variants() -> tuple[Variant, ...]:
    """Every kernel in every tier and form; a form `numpy` only where it differs from `plain`."""
    found = []
    for names, make in ((SHAPES, best), (QUOTIENT_SHAPES, quotient)):
        for name in names:
            made = {form: make(name, form) for form in ("fused", "plain", "numpy")}
            if made["numpy"] == made["plain"]:
                del made["numpy"]
            found += [Variant(name, "best", form, p) for form, p in made.items()]
    for tier, kernels in DEGREES.items():
        found += [Variant(name, tier, form, cheap(name, tier, form)) for name in kernels for form in ("fused", "plain")]
    return tuple(found)
