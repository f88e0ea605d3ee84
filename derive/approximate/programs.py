"""Programs of the certified kernels: approximants of F(alpha)/alpha**3 near 0, and of F minus a line near pi/2.

Near: F = x u W, where u = x**2 and W = c0 + u (c1 + u (c2 + ...)). Fused, the rounding errors of u, of u W and of the
two leading sums of W are kept. Far, in b = fl(pi/2) - x (exact there): F = line(x) +
correction(b), the line without rounding, so that the small correction needs no care. Every piece is computed for
every x, and one chosen.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from typing import Any, NamedTuple

from sympy import Expr

from derive.algebra.integrate import derive
from derive.approximate import shapes
from derive.approximate.shapes import HALF_PI, Far, Kernel, Pieces, Shape, limit
from derive.check import ends
from derive.code.program import Builder, Program, Value, without_dead
from derive.declare.quantities import LIMIT_FRICTION, MOMENTS
from derive.kinds import Names


@dataclass(frozen=True)
class Variant:
    """Kernel at one tier of accuracy and in one form: fused (multiply-adds), plain, or numpy (with its logarithm)."""

    kernel: str
    definition: Names
    tier: str
    form: str
    program: Program
    part: "Variant | None" = None  # of a function of both ends its function of alpha


class Pair(NamedTuple):
    """Unevaluated sum of two numbers."""

    high: Value
    low: Value

    @property
    def total(self) -> Value:
        """Rounded sum of both numbers."""
        return self.high + self.low


class Code(Builder):
    """Operations on alpha as they are written. In the plain form a multiply-add consists of two operations."""

    def __init__(self, form: str, argument: str = "alpha") -> None:
        super().__init__()
        self.form = form
        self.fused = form == "fused"
        self.argument = argument
        self.x = self.put("input", value=argument)

    @property
    def u(self) -> Value:
        """Square of the argument."""
        return self.x * self.x

    def fma(self, a: Any, b: Any, c: Any) -> Value:
        """Return a b + c for values and numbers, rounded once in the fused form."""
        if self.fused:
            return self.put("fma", a, b, c)
        a, b, c = map(self.value, (a, b, c))
        product = a * b
        last = self.ops[c.place]
        if last.kind == "neg":
            return product - Value(self, last.args[0])
        return product + c

    def horner(self, x: Value, coefficients: Sequence[float]) -> Value:
        """Return the polynomial in x with these coefficients, lowest first."""
        return self.put("fused_horner" if self.fused else "horner", x, value=tuple(coefficients))

    def below(self, seam: float, near: Value, far: Value) -> Value:
        """Return `near` where alpha < seam, and otherwise `far`."""
        return self.put("select", self.x < seam, near, far)

    def program(self, name: str, output: Value) -> Program:
        """Return the program of this name with only the operations that the output needs."""
        return without_dead(Program(name, (self.argument,), tuple(self.ops), (output.place,)))


def excess(code: Code, closed: Expr, piece: Pieces) -> Value:
    """Return q of W = 1 + q in the plain form, where the form F is x (u + u q) times its limit."""
    u = code.u
    return code.horner(u, shapes.near_fit(closed, piece.seam, piece.count, Fraction(1))) * u


def to_limit(closed: Expr, w: Value) -> Value:
    """Return w times the limit of F/alpha**3, which is 1 or 2/3, rounded once."""
    if limit(closed) == 1:
        return w
    return w / float(1 / limit(closed))


def near_sum(code: Code, closed: Expr, piece: Pieces) -> tuple[Pair, Value, Value]:
    """Return, in the fused form, W with its rounding error, d(u W)/du, and P1 = (W - c0)/u, which approximates W'.

    The rounding error of a sum S_k = c_k + u S_(k+1) is fma(S_(k+1), u, c_k - S_k).
    """
    fma = code.fma
    u = code.u
    exact = limit(closed)
    c0 = float(exact)
    c1, *others = shapes.near_fit(closed, piece.seam, piece.count, exact)
    p2 = _even_and_odd(code, u, others)
    p1 = fma(p2, u, c1)
    w = fma(p1, u, c0)
    w_lost = fma(p1, u, c0 - w)
    turned = c1 - p1
    p1_lost = fma(p2, u, turned)
    c0_low = float(exact - Fraction(c0))
    if not c0_low:
        return Pair(w, fma(u, p1_lost, w_lost)), w, p1
    low = fma(u, p1_lost, w_lost + c0_low)
    slope = fma(-u, turned, fma(2.0, w, -c0))  # u W' is nearly W - c0 + u (P1 - c1); w serves where W is close to 1
    return Pair(w, low), slope, p1


def _even_and_odd(code: Code, u: Value, c: Sequence[float]) -> Value:
    """Return the polynomial in u by the even and odd parts of the terms after its constant term.

    For one product more, half as many operations wait for each other.
    """
    u_2 = u * u
    odd = code.horner(u_2, c[2::2])
    return code.fma(u, code.fma(u, odd, code.horner(u_2, c[1::2])), c[0])


def near(code: Code, closed: Expr, piece: Pieces) -> Pair:
    """Return F = x (high + low) near 0, high = u W; low has the rounding errors, also that of u = fl(x^2)."""
    fma = code.fma
    u = code.u
    u_lost = fma(code.x, code.x, -u)
    w, slope, _ = near_sum(code, closed, piece)
    h = u * w.high
    h_lost = fma(u, w.high, -h)
    return Pair(h, fma(u, w.low, fma(u_lost, slope, h_lost)))


def near_value(code: Code, closed: Expr, piece: Pieces) -> Value:
    """Return F, rounded or underflowing once at the end, since a product with a power of x is last."""
    x = code.x
    if code.fused:
        h = near(code, closed, piece)
        return code.fma(x, h.high, x * h.low)
    u = code.u
    w = code.fma(u, excess(code, closed, piece), u)
    return to_limit(closed, w) * x


def logarithm(code: Code, b: Value) -> Value:
    """Return ln b for b >= 0, and a finite value at 0, where it is multiplied by 0.

    b = 2**exponent significand, s = significand - 1 (exact), q = s/(2 + s): ln(1 + s) = s - q (s - z P(z)), z = q**2,
    whose largest part is exact.
    """
    b = code.put("max", b, 2.0**-60)
    if code.form == "numpy":
        return code.put("log", b)
    ln2, coefficients = shapes.logarithm_fit()
    s = code.put("significand", b) - 1.0
    q = s / (s + 2.0)
    z = q * q
    bent = code.fma(z, code.horner(z, coefficients), -s)
    exponent = code.put("exponent", b)
    return code.fma(q, bent, code.fma(exponent, ln2, s))


def far(code: Code, closed: Expr, shape: Far, seam: float) -> Pair:
    """Return the piece near pi/2 as in `FarFit`: the line, and the terms added to it."""
    fma = code.fma
    fit = shapes.far_fit(closed, shape, seam)
    b = HALF_PI - code.x
    b_2 = b * b
    core = code.horner(b_2, fit.r)
    if shape.shift is not None:
        q = code.horner(b_2, fit.q)
        for _ in range(shape.shift):
            q = q * b_2
        scaled = b if shape.scale == 1 else shape.scale * b
        core = fma(q, logarithm(code, scaled), core)
    front = b if shape.odd else b_2
    if shape.power > 2:
        front = front * b_2
    ahead = code.value(fit.constant) if fit.constant else None  # constant + tilt b
    if fit.tilt:
        tilt = code.value(fit.tilt)
        ahead = b * tilt if ahead is None else fma(b, tilt, ahead)
    rest = front * core if ahead is None else fma(front, core, ahead)
    if not shape.odd and (shape.bend or shape.slope):
        rest = fma(b, fma(b, -shape.bend, shape.slope), rest)
    if not shape.slope:
        return Pair(code.value(shape.line), rest)
    return Pair((code.x if shape.slope == 1 else shape.slope * code.x) + shape.line, rest)


def fused_quotient(code: Code, forms: Sequence[Expr], parts: Sequence[Pieces]) -> Value:
    """Return F1/F2, near 0 from W1/W2: one division, corrected for rounding errors of itself and its parts."""
    fma = code.fma
    seam = min(part.seam for part in parts)
    over, under = (fused_part(code, closed, part, seam) for closed, part in zip(forms, parts, strict=True))
    inverse = 1.0 / under.high
    q = over.high * inverse
    residual = fma(-q, under.high, over.high) + over.low
    residual = fma(-q, under.low, residual)
    return fma(residual, inverse, q)


def plain_quotient(code: Code, forms: Sequence[Expr], parts: Sequence[Pieces]) -> Value:
    """Return F1/F2 in the plain form, near 0 from W1/W2 over their limits."""
    seam = min(part.seam for part in parts)
    same_limit = limit(forms[0]) == limit(forms[1])
    values = []
    for closed, part in zip(forms, parts, strict=True):
        # W below the seam, but for its limit, F above it.
        w = code.value(1.0) + excess(code, closed, part)
        if part.far:
            beyond = far(code, closed, part.far, seam).total
        else:
            beyond = near_value(code, closed, part)
        value = code.below(seam, w, beyond)
        if not same_limit:
            value = code.below(seam, to_limit(closed, value), value)
        values.append(value)
    return values[0] / values[1]


def fused_part(code: Code, closed: Expr, part: Pieces, seam: float) -> Pair:
    """Return W below the seam and F above it, with the rounding error in `low`."""
    fma = code.fma
    x = code.x
    u = code.u
    w, _, p1 = near_sum(code, closed, part)
    w_low = fma(fma(x, x, -u), p1, w.low)
    if part.far:
        beyond = far(code, closed, part.far, seam)
        total = beyond.total
        lost = beyond.low - (total - beyond.high)
    else:
        h = near(code, closed, part)
        total = x * h.high
        lost = fma(x, h.low, fma(x, h.high, -total))
    return Pair(code.below(seam, w.high, total), code.below(seam, w_low, lost))


def cheap(code: Code, closed: Expr, above: int, below: int) -> Value:
    """Return x u (numerator/denominator): one polynomial or one quotient of two on the whole domain."""
    over, under = shapes.cheap_fit(closed, above, below)
    u = code.u
    if not below:
        return code.horner(u, over) * u * code.x
    w = HALF_PI * HALF_PI - u
    return code.horner(w, over) * u / code.horner(w, under) * code.x


def rounding(code: Code, closed: Expr, above: int, below: int) -> Value:
    """Return F = alpha u W for float32, with W from a fit q of (W - W(0))/u of degrees ``above`` over ``below``.

    Near 0, where u q is lost in W(0) + u q, the value is a little less than the leading term of F. Of some inputs
    that term is a midpoint of two float32 (of 375 it is 18 125**3, which has 25 bits).
    """
    over, under = shapes.rounding_fit(closed, above, below)
    u = code.u
    cube = u * code.x
    z = (HALF_PI - code.x) * (code.x + HALF_PI)  # small errors where z is small
    first = 1.0 if below else float(limit(closed))
    lean = 0.51 * math.ulp(math.nextafter(first, 0.0))  # a little more than half an ulp
    if not below:
        return cube * (code.horner(u, (-lean, *over)) + first)
    q = code.horner(z, over) / code.horner(z, under)
    return cube * (code.fma(q, u, -lean) + first) * float(limit(closed))


def variant(kernel: Kernel, tier: str, form: str, shape: Sequence[Any]) -> Variant:
    """Return a kernel at one tier in one form, the best tier from its pieces and another tier from its degrees."""
    code = Code(form)
    closed, *others = kernel.closed
    if tier != "best":
        value = (rounding if tier == "float32" else cheap)(code, closed, *shape)
    elif others:  # of parts that have one seam, to the last place or nearly so
        value = (fused_quotient if code.fused else plain_quotient)(code, kernel.closed, shape)
    else:
        (piece,) = shape
        value = near_value(code, closed, piece)
        if piece.far:
            beyond = far(code, closed, piece.far, piece.seam).total
            value = code.below(piece.seam, value, beyond)
    return Variant(kernel.name, kernel.definition, tier, form, code.program(kernel.name, value))


@cache
def of(kernel: Kernel, shape: Shape) -> tuple[Variant, ...]:
    """Return a kernel in every tier and form, with the form `numpy` only if it differs from `plain`."""
    fused = variant(kernel, "best", "fused", shape.best)
    plain = variant(kernel, "best", "plain", shape.best)
    numpy = variant(kernel, "best", "numpy", shape.best)
    every = [fused, plain]
    if numpy.program != plain.program:
        every.append(numpy)
    for tier, *degrees in shape.cheap:
        every += [variant(kernel, tier, form, degrees) for form in ("fused", "plain")]
    return tuple(every)


def variants() -> tuple[Variant, ...]:
    """Return every kernel in every tier and form, from the stated shapes."""
    every: list[Variant] = []
    for kernel in shapes.kernels():
        every += of(kernel, shapes.stated_shape(kernel))
    return tuple(every)


# --- both ends -------------------------------------------------------------------------------------------------------


def functions_of_ends() -> Iterator[tuple[str, str, Names]]:
    """Yield the moments that turn with the bisector, and the limit friction: name, kernel and definition."""
    for moment in MOMENTS:
        if not moment.amplitude:
            continue
        kernel, _ = moment.kernel
        yield moment.name, kernel, (*moment.definition, str(derive(moment).direction).replace("(", " ").rstrip(")"))
    ratio = next(kernel for kernel in shapes.kernels() if kernel.name == LIMIT_FRICTION)
    yield "limit_friction", ratio.name, (*ratio.definition, "tan psi")


def inlined(name: str, steps: Sequence[ends.RecordedValue], part: Program | None = None) -> Program:
    """Return the program of both ends whose outputs are these steps, which may call ``part``, a program of alpha."""
    code = Builder()
    values: list[Value] = []
    for kind, args, value in steps[0].operations:
        operands = [values[k] for k in args]
        if kind == "call":
            assert part
            values += code.inline(part, {"alpha": operands[0]})
        elif kind == "const":
            values.append(code.value(float.fromhex(value)))
        else:
            values.append(code.put(kind, *operands, value=value))
    outputs = tuple(values[step.place].place for step in steps)
    return without_dead(Program(name, ("theta_1", "theta_2"), tuple(code.ops), outputs))


@cache
def parts_of_ends() -> tuple[Program, ...]:
    """Return the common parts of functions of both ends: reductions of cos(psi) and sin(psi), and alpha's rounding."""
    of_cosine = ends.reduced(*ends.both(), odd=False)
    of_sine = ends.reduced(*ends.both(), odd=True)
    return inlined("cos_psi", of_cosine), inlined("sin_psi", of_sine), inlined("share", ends.share(*ends.both()))


@cache
def variants_of_ends() -> tuple[Variant, ...]:
    """Return every function of both ends in every tier with a sine; float32 uses the next better tier."""
    every = []
    for name, kernel, definition in functions_of_ends():
        for part in variants():
            if part.kernel != kernel or part.tier not in ends.TERMS:
                continue
            program = inlined(name, [ends.result(definition, part.tier, "")], part.program)
            every.append(Variant(name, definition, part.tier, part.form, program, part))
            if part.tier == "1e-10":
                every.append(replace(every[-1], tier="float32"))
    return tuple(every)
