"""The certified kernels' programs: an approximant of F(alpha)/alpha**3 near 0, and of F less a straight line near pi/2.

Near: F = x u W, with u + du = x**2 exact and W = c0 + u (c1 + u P2(u)), whose roundings of the two leading sums are
kept. Far, in b = fl(pi/2) - x (exact there): F = line(x) + correction(b), where the line is computed without rounding,
so that the small correction needs no care. fl(pi/2) is not pi/2: every correction is fitted as a function of b as
it is computed, pi/2 - fl(pi/2) folded in.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache

from flint import arb, ctx

from derive.fit import REDUCED, Function, Samples, exact, grid, horner, minimax, nearest, rounded, sample, value
from derive.program import Kind, Op, Program

HALF_PI = float.fromhex("0x1.921fb54442d18p+0")  # the double nearest to pi/2


@dataclass(frozen=True)
class Variant:
    """A kernel at one tier of accuracy and in one form: fused (multiply-adds), plain, or numpy (with its logarithm)."""

    kernel: str
    tier: str
    form: str
    program: Program


# --- straight-line code --------------------------------------------------------------------------------------------


@dataclass
class Code:
    """Operations as they are written; in a plain form a multiply-add is two of them."""

    form: str
    ops: list[Op] = field(default_factory=list)
    index: dict[Op, int] = field(default_factory=dict)

    @property
    def fused(self) -> bool:
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

    def fma(self, a: int, b: int, c: int) -> int:
        """a b + c, rounded once where fused."""
        if self.fused:
            return self.put("fma", a, b, c)
        product, last = self.mul(a, b), self.ops[c]
        return self.sub(product, last.args[0]) if last.kind == "neg" else self.add(product, c)

    def error(self, a: int, b: int, product: int) -> int:
        """a b - fl(a b), exactly."""
        return self.put("fma", a, b, self.put("neg", product))

    def horner(self, x: int, coefficients: Sequence[float]) -> int:
        result = self.const(coefficients[-1])
        for c in reversed(coefficients[:-1]):
            result = self.fma(result, x, self.const(c))
        return result

    def below(self, x: int, seam: float, near: int, far: int) -> int:
        return self.put("select", self.put("less", x, self.const(seam)), near, far)

    def program(self, name: str, output: int) -> Program:
        """The operations that the output needs."""
        alive = {output}
        for i in range(len(self.ops) - 1, -1, -1):
            if i in alive:
                alive |= set(self.ops[i].args)
        place = {i: new for new, i in enumerate(sorted(alive))}
        ops = tuple(Op(op.kind, tuple(place[j] for j in op.args), op.value)
                    for i, op in enumerate(self.ops) if i in alive)  # fmt: skip
        return Program(name, ("alpha",), ops, (place[output],))


# --- near ----------------------------------------------------------------------------------------------------------

LIMIT = dict.fromkeys(REDUCED, Fraction(2, 3)) | {"resistance_factor": Fraction(1)}


def reduced(name: str) -> Function:
    """F/alpha**3 as a function of alpha**2."""
    return lambda u: value(name, u.sqrt()) / (u * u.sqrt())


@cache
def near_fit(name: str, seam: float, degree: int) -> tuple[float, ...]:
    """c1, c2, ...: of (F/alpha**3 - its limit)/alpha**2 in alpha**2, least relative error of F."""
    with ctx.workprec(400):
        limit = exact(LIMIT[name])
        function = reduced(name)
        points = grid(arb(0), exact(seam) ** 2, degree)
        samples = sample(function, lambda u: 1 / function(u), points).without(limit)
    return tuple(rounded(samples, degree - 1, careful=3)[0])


@dataclass(frozen=True)
class Pair:
    """An unevaluated sum."""

    high: int
    low: int


def near(code: Code, x: int, name: str, seam: float, degree: int, captured: int) -> int:
    """x u W; of the sums that make W, the roundings of the last one (or the last two) are kept."""
    c = near_fit(name, seam, degree)
    limit = LIMIT[name]
    u = code.mul(x, x)
    if not code.fused:
        q = code.mul(code.horner(u, c), u)
        if limit == 1:
            return code.mul(code.fma(u, q, u), x)
        q = code.add(q, code.const(float(limit - Fraction(1, 2))))  # a rounded 2/3 would lean to one side
        return code.mul(code.fma(u, q, code.mul(u, code.const(0.5))), x)
    du = code.error(x, x, u)
    c0 = float(limit)
    c0_low = float(limit - Fraction(c0))
    p2 = code.horner(u, c[1:])
    c1 = code.const(c[0])
    p1 = code.fma(p2, u, c1)
    w = code.fma(p1, u, code.const(c0))
    low = code.fma(p1, u, code.sub(code.const(c0), w))
    if c0_low:
        low = code.add(low, code.const(c0_low))
    # d(u W)/du = W + u W', and u W' is nearly W - c0 + u (P1 - c1)
    slope = code.fma(code.const(2.0), w, code.const(-c0))
    if captured:
        turn = code.sub(c1, p1)
        low = code.fma(u, code.fma(p2, u, turn), low)
        slope = code.fma(code.put("neg", u), turn, slope)
    h = code.mul(u, w)
    h_low = code.fma(u, low, code.fma(du, slope, code.error(u, w, h)))
    return code.fma(x, h, code.mul(x, h_low))


def resistance_factor(form: str) -> Program:
    code = Code(form)
    x = code.put("input", value="alpha")
    return code.program("resistance_factor", near(code, x, "resistance_factor", HALF_PI, 8, 0))


# --- far -----------------------------------------------------------------------------------------------------------


def far_samples(name: str, rest: Callable[[arb, arb], arb], weight: Function, largest: float, degree: int) -> Samples:
    """What is left of F as a function of w = b**2, b = fl(pi/2) - alpha."""

    def function(w: arb) -> arb:
        b = w.sqrt()
        return rest(b, value(name, exact(HALF_PI) - b))

    def weighted(w: arb) -> arb:
        b = w.sqrt()
        return weight(b) / value(name, exact(HALF_PI) - b)

    with ctx.workprec(400):
        return sample(function, weighted, grid(arb(0), exact(largest) ** 2, degree + 2, 2))


def short(x: arb) -> float:
    """The nearest multiple of 2**-53: added to alpha >= pi/4 or its half, the sum is exact if it is at most 1."""
    return nearest((x * 2**53 + exact(0.5)).floor()) / 2**53


@cache
def moment_of_inertia_far(seam: float, degree: int) -> tuple[float, float, tuple[float, ...]]:
    """F = (alpha/2 + line) + (constant + b E(b**2))."""
    with ctx.workprec(400):
        at_end = value("moment_of_inertia", exact(HALF_PI)) - exact(HALF_PI) / 2
        line = -0.1171875  # keeps the correction small up to where F reaches 1/2; an eighth at most above
        constant = nearest(at_end - exact(line))
        samples = far_samples(
            "moment_of_inertia",
            lambda b, f: (f - (exact(HALF_PI) - b) / 2 - exact(line) - exact(constant)) / b,
            lambda b: b,
            HALF_PI - seam,
            degree,
        )
    return line, constant, tuple(rounded(samples, degree, careful=3)[0])


def moment_of_inertia(form: str) -> Program:
    code = Code(form)
    x = code.put("input", value="alpha")
    seam = 1.0
    line, constant, c = moment_of_inertia_far(seam, 9)
    b = code.sub(code.const(HALF_PI), x)
    base = code.add(code.mul(code.const(0.5), x), code.const(line))
    far = code.add(base, code.fma(b, code.horner(code.mul(b, b), c), code.const(constant)))
    return code.program("moment_of_inertia", code.below(x, seam, near(code, x, "moment_of_inertia", seam, 11, 1), far))


@cache
def weight_moment_far(seam: float, degree: int) -> tuple[float, float, float, tuple[float, ...]]:
    """F = (alpha/2 + line) + (constant + tilt b + b (1/2 - b) + b**4 E(b**2))."""
    with ctx.workprec(400):
        end = exact(HALF_PI)
        tilt = exact(nearest(2 * (end - arb.pi() / 2)))
        at_end = value("weight_moment_amplitude", end) - end / 2
        line = short(at_end)
        constant = nearest(at_end - exact(line))
        straight = (end / 2 + exact(line) + exact(constant)).mid()
        samples = far_samples(
            "weight_moment_amplitude",
            lambda b, f: (f - straight - tilt * b + b * b) / b**4,
            lambda b: b**4,
            HALF_PI - seam,
            degree,
        )
    return line, constant, nearest(tilt), tuple(rounded(samples, degree, careful=2)[0])


def weight_moment_amplitude(form: str) -> Program:
    code = Code(form)
    x = code.put("input", value="alpha")
    seam = 1.14
    line, constant, tilt, c = weight_moment_far(seam, 5)
    b = code.sub(code.const(HALF_PI), x)
    w = code.mul(b, b)
    base = code.add(code.mul(code.const(0.5), x), code.const(line))
    bend = code.fma(code.mul(w, w), code.horner(w, c), code.fma(b, code.const(tilt), code.const(constant)))
    far = code.add(base, code.fma(b, code.sub(code.const(0.5), b), bend))
    n = near(code, x, "weight_moment_amplitude", seam, 10, 1)
    return code.program("weight_moment_amplitude", code.below(x, seam, n, far))


# --- the logarithmic ends ------------------------------------------------------------------------------------------

LN2 = float.fromhex("0x1.62e42fefa39efp-1")


@cache
def logarithm_fit(degree: int) -> tuple[float, ...]:
    """P(z) = (2 artanh(q)/q - 2)/z, z = q**2, for q <= 1/5."""
    with ctx.workprec(400):
        points = grid(arb(0), 1 / arb(25), degree)
        samples = sample(lambda z: (2 * z.sqrt().atanh() / z.sqrt() - 2) / z, lambda z: z * z.sqrt(), points)
    return tuple(rounded(samples, degree, careful=1)[0])


def logarithm(code: Code, b: int, degree: int) -> int:
    """ln b of a b >= 0; at 0 something finite, which a factor 0 waits for.

    b = 2**exponent significand, s = significand - 1 (exact), q = s/(2 + s): ln(1 + s) = s - q (s - z P(z)), z = q**2,
    whose largest part is exact.
    """
    b = code.put("max", b, code.const(2.0**-60))
    if code.form == "numpy":
        return code.put("call", b, value="log")
    s = code.sub(code.put("call", b, value="significand"), code.const(1.0))
    q = code.put("div", s, code.add(s, code.const(2.0)))
    z = code.mul(q, q)
    bent = code.fma(z, code.horner(z, logarithm_fit(degree)), code.put("neg", s))
    head = code.fma(code.put("call", b, value="exponent"), code.const(LN2), s)
    return code.fma(q, bent, head)


def logarithmic(
    name: str, rest: Callable[[arb, arb], arb], power: int, seam: float, degrees: tuple[int, int], scale: float = 1.0
) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """R and Q of b**power (R(b**2) + Q(b**2) ln(scale b)), fitted together; with Q rounded, R again."""
    samples = far_samples(name, rest, lambda b: b**power, HALF_PI - seam, sum(degrees))
    with ctx.workprec(400):
        logs = [(exact(scale) * x.sqrt()).log() for x in samples.points]
        q = [nearest(c) for c in minimax(samples, degrees[0], logs=(logs, degrees[1]))[1]]
        shared = [horner([exact(c) for c in q], x) * l for x, l in zip(samples.points, logs, strict=True)]
        values = [(f - s).mid() for f, s in zip(samples.values, shared, strict=True)]
        left = Samples(samples.points, values, samples.weights)
    return tuple(rounded(left, degrees[0], careful=1)[0]), tuple(q)


@cache
def polar_moment_far(
    seam: float, degrees: tuple[int, int]
) -> tuple[float, float, tuple[float, ...], tuple[float, ...]]:
    """F = (alpha + line) + (constant + b**3 (R + Q ln b)), R and Q in b**2."""
    with ctx.workprec(400):
        end = exact(HALF_PI)
        at_end = value("polar_moment", end) - end
        line = short(at_end)
        constant = nearest(at_end - exact(line))
        straight = (end + exact(line) + exact(constant)).mid()
    return line, constant, *logarithmic("polar_moment", lambda b, f: (f - straight + b) / b**3, 3, seam, degrees)


def polar_moment(form: str) -> Program:
    code = Code(form)
    x = code.put("input", value="alpha")
    seam = 0.95
    line, constant, r, q = polar_moment_far(seam, (5, 5))
    b = code.sub(code.const(HALF_PI), x)
    w = code.mul(b, b)
    core = code.fma(code.horner(w, q), logarithm(code, b, 6), code.horner(w, r))
    far = code.add(code.add(x, code.const(line)), code.fma(code.mul(b, w), core, code.const(constant)))
    return code.program("polar_moment", code.below(x, seam, near(code, x, "polar_moment", seam, 13, 1), far))


BEND = 1.875


@cache
def radial_weight_far(seam: float, degrees: tuple[int, int]) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """F = (1 - b) + (b (1 - BEND b) + b**2 (R + Q ln 2 b)), R and Q in b**2: small parts where F is a half."""
    return logarithmic("radial_weight_amplitude", lambda b, f: (f - 1) / b**2 + BEND, 2, seam, degrees, 2.0)


def radial_weight_amplitude(form: str) -> Program:
    code = Code(form)
    x = code.put("input", value="alpha")
    seam = 1.03
    r, q = radial_weight_far(seam, (5, 5))
    b = code.sub(code.const(HALF_PI), x)
    w = code.mul(b, b)
    core = code.fma(code.horner(w, q), logarithm(code, code.mul(code.const(2.0), b), 6), code.horner(w, r))
    one = code.const(1.0)
    bend = code.fma(b, code.const(-BEND), one)
    far = code.add(code.sub(one, b), code.fma(b, bend, code.mul(w, core)))
    n = near(code, x, "radial_weight_amplitude", seam, 16, 1)
    return code.program("radial_weight_amplitude", code.below(x, seam, n, far))


# --- cheaper tiers -------------------------------------------------------------------------------------------------

# Degrees of numerator and denominator of F/alpha**3: a polynomial in alpha**2, or a rational in pi**2/4 - alpha**2.
DEGREES = {
    "1e-10": {"polar_moment": (7, 7), "moment_of_inertia": (9, 0), "radial_weight_amplitude": (10, 10),
              "weight_moment_amplitude": (8, 0), "resistance_factor": (5, 0)},
    "1e-6": {"polar_moment": (8, 0), "moment_of_inertia": (6, 0), "radial_weight_amplitude": (4, 5),
             "weight_moment_amplitude": (5, 0), "resistance_factor": (3, 0)},
    "float32": {"polar_moment": (7, 6), "moment_of_inertia": (8, 0), "radial_weight_amplitude": (9, 9),
                "weight_moment_amplitude": (7, 0), "resistance_factor": (5, 0)},
}  # fmt: skip
QUARTER = HALF_PI * HALF_PI


@cache
def cheap_fit(name: str, above: int, below: int) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Numerator and denominator."""
    function = reduced(name)
    with ctx.workprec(400):
        largest = (arb.pi() / 2) ** 2
        at: Function = (lambda w: largest - w) if below else (lambda u: u)
        points = grid(arb(0), largest, above + below, 2)
        samples = sample(lambda z: function(at(z)), lambda z: 1 / function(at(z)), points)
    over, under, _ = minimax(samples, above, below)
    return tuple(map(nearest, over)), tuple(map(nearest, under))


def cheap(name: str, tier: str, form: str) -> Program:
    """x u (numerator/denominator): one polynomial or one quotient of two over the whole domain."""
    above, below = DEGREES[tier][name]
    over, under = cheap_fit(name, above, below)
    code = Code(form)
    x = code.put("input", value="alpha")
    u = code.mul(x, x)
    if not below:
        return code.program(name, code.mul(code.mul(code.horner(u, over), u), x))
    w = code.sub(code.const(QUARTER), u)
    ratio = code.put("div", code.mul(code.horner(w, over), u), code.horner(w, under))
    return code.program(name, code.mul(ratio, x))


# --- all of them ---------------------------------------------------------------------------------------------------

BEST = (polar_moment, moment_of_inertia, radial_weight_amplitude, weight_moment_amplitude, resistance_factor)
FORMS = ("fused", "plain", "numpy")


def variants() -> tuple[Variant, ...]:
    """Every kernel in every tier and form; a form `numpy` only where it differs from `plain`."""
    found = []
    for make in BEST:
        made = {form: make(form) for form in FORMS}
        found += [Variant(p.name, "best", form, p) for form, p in made.items() if form != "numpy" or p != made["plain"]]
    for tier, names in DEGREES.items():
        found += [Variant(name, tier, form, cheap(name, tier, form)) for name in names for form in ("fused", "plain")]
    return tuple(found)
