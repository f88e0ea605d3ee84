"""Exact derivatives of the closed forms, each proved equal to what SymPy makes of the closed form itself.

Peak, run-out and duration follow from them by implicit differentiation (`slipcircle.sensitivity`). Nothing here
cancels where a motion is short or slow, an arc thin, or a brake weak or strong.
"""

from collections.abc import Callable
from functools import cache

import sympy as sp

from derive.algebra.dynamics import solution
from derive.algebra.phase import BRAKE, CONSTANT, DRIVE, ENERGIES, START, TILT, X
from derive.algebra.prove import prove_zero
from derive.algebra.remainders import Horner, Log1p, Primitive, Remainder, Select, sine_defect, sinhc, unfold
from derive.algebra.rules import prove_equal, stable
from derive.code.program import Program, program
from derive.declare import effects
from derive.declare.effects import ALPHA, EFFECTS, GRAVITY, ORDER, REFERENCE, THETA, VALUE, terms
from derive.declare.symbols import a, alpha, b, omega_0, t


class _Rest(Primitive):
    """What is left of remainders of exp(-x) without their first terms; for |x| < 1 only."""

    def lower(self) -> sp.Expr:
        terms = [self.coefficient(k) for k in range(18)]
        return Horner.of(terms, sp.Max(sp.Min(self.args[0], 1), -1))

    def coefficient(self, k: int) -> sp.Rational:
        """Of x**k."""
        raise NotImplementedError


class ExpMeanRest(_Rest):
    """(exp_mean(x) - 1/2 + x/3)/x**2."""

    def definition(self) -> sp.Expr:
        x = self.args[0]
        return (exp_mean(x) - sp.Rational(1, 2) + x / 3) / x**2

    def coefficient(self, k: int) -> sp.Rational:
        return sp.Integer(-1) ** k / (sp.factorial(k + 2) * (k + 4))


class ExpMixRest(_Rest):
    """(1/2 - 3 X2 + X1)/x**2, Xn = Remainder(exp, n, -x)."""

    def definition(self) -> sp.Expr:
        x = self.args[0]
        return (sp.Rational(1, 2) - 3 * Remainder(sp.exp, 2, -x) + Remainder(sp.exp, 1, -x)) / x**2

    def coefficient(self, k: int) -> sp.Rational:
        return sp.Integer(-1) ** k * (k + 1) / sp.factorial(k + 4)


def exp_mean(x: sp.Expr) -> sp.Expr:
    """(1 - (1 + x) exp(-x))/x**2: (1 - exp(-x))/x falls by this."""
    return Remainder(sp.exp, 1, -x, 1)


# --- energy in the phase plane ---------------------------------------------------------------------------------------

_LIFT_DEFECT = 2 * (X / 2) ** 3 * sine_defect(X / 2) * (X / 2 + sp.sin(X / 2))  # x**2/2 - (1 - cos x)
ENERGY_INPUTS = (X, START, DRIVE, TILT, CONSTANT, BRAKE)


@cache
def _integrals() -> tuple[sp.Expr, ...]:
    """Integrals of exp(-q (x - y)) times cos y, sin y, 1 - cos y from 0 to x, q = 2 brake."""
    q = 2 * BRAKE
    w, half = q * X, X / 2
    sine, defect, lift = sp.sin(X), X**3 * sine_defect(X), 2 * sp.sin(half) ** 2
    with_cos = sine + q * (w * Remainder(sp.exp, 1, -w) - lift)
    with_sin = lift + w**2 * Remainder(sp.exp, 2, -w) - q * defect
    with_lift = defect - q * _LIFT_DEFECT + w**2 * X * Remainder(sp.exp, 3, -w)
    return tuple(i / (1 + q**2) for i in (with_cos, with_sin, with_lift))


@cache
def energy_slopes() -> tuple[sp.Expr, ...]:
    """dE/d(start, drive, tilt, constant, brake) at x.

    E = start exp(-qx) + 2 (drive I_c - tilt I_s - constant I_1), q = 2 brake, with the integrals I of
    exp(-q (x - y)) times cos y, sin y, 1 - cos y from 0 to x; all relatively accurate as x -> 0 and for any q x.
    """
    q = 2 * BRAKE
    w, q2 = q * X, q**2
    defect, lift, over = X**3 * sine_defect(X), 2 * sp.sin(X / 2) ** 2, 1 / (1 + q2)
    hump, fifth = Remainder(sp.exp, 2, -w, 1), Remainder(sp.sin, 5, X)
    ratio, second, mean = Remainder(sp.exp, 1, -w), Remainder(sp.exp, 2, -w), exp_mean(w)
    with_cos, with_sin, with_lift = _integrals()
    # Their derivatives by q, all negative.
    of_cos = (q2 * lift - lift + 2 * q * defect - w**2 * (second + ratio) - (q * w) ** 2 * mean) * over**2
    of_sin = ((q2 - 1) * defect + 2 * q * _LIFT_DEFECT - w**2 * X * second - q * w**3 * hump) * over**2
    near = (q2 - 1) * _LIFT_DEFECT + 2 * q * X**5 * fifth - w**2 * (X**2 * ExpMeanRest(w) + w**2 * ExpMixRest(w))
    far = (1 - q2) * lift - 2 * q * defect - (X**2 + 2 * w**2) * mean + w**2 * (second + ratio)
    of_lift = Select(sp.Abs(w), 1, near, far) * over**2
    decay = sp.exp(-w)
    brake = 4 * (DRIVE * of_cos - TILT * of_sin - CONSTANT * of_lift) - 2 * X * decay * START
    return decay, 2 * with_cos, -2 * with_sin, -2 * with_lift, brake


def prove_energy_slopes() -> list[str]:
    """Prove each derivative of E, in both of its pieces, equal to that of the closed form."""
    exact = unfold(next(e.form for e in ENERGIES if e.name == "energy_braked"))
    claims = []
    for near in (True, False):
        for parameter, slope in zip(ENERGY_INPUTS[1:], energy_slopes(), strict=True):
            claim = f"dE/d{parameter}, {'near' if near else 'far'}"
            # Twice: a primitive's definition may hold another.
            piece = slope.replace(Select, lambda smaller, larger, yes, no, near=near: yes if near else no)
            difference = sp.together(unfold(piece) - sp.diff(exact, parameter))
            prove_zero(sp.expand(sp.fraction(difference.rewrite(sp.exp))[0]), claim)
            claims.append(claim)
    return claims


def energy_growth() -> tuple[sp.Expr, ...]:
    """x dI_c/dx - I_c, x dI_s/dx - 2 I_s, x dI_1/dx - 2 I_1, for |q x| < 1.

    A motion just below its limit is short, and E/x**2 hardly depends on how short: this is how much.
    """
    q = 2 * BRAKE
    w = q * X
    defect, lift = X**3 * sine_defect(X), 2 * sp.sin(X / 2) ** 2
    of_cos = (q * lift + X**3 * Remainder(sp.sin, 1, X, 1) - w * sp.sin(X) - q * w**2 * exp_mean(w)) / (1 + q**2)
    third = w**3 * Remainder(sp.exp, 3, -w)
    of_sin = (2 + w) * (_LIFT_DEFECT + third + q * defect) / (1 + q**2) - X * (X * w / 2 + defect)
    return of_cos, of_sin, X * lift - (2 + w) * _integrals()[2]


def prove_energy_growth() -> list[str]:
    """Prove them from the integrals."""
    claims = []
    for name, growth, integral, power in zip(
        ("I_c", "I_s", "I_1"), energy_growth(), _integrals(), (1, 2, 2), strict=True
    ):
        exact = unfold(integral)
        difference = sp.together(unfold(growth) - X * sp.diff(exact, X) + power * exact)
        claims.append(f"{name}: x dI/dx - {power} I")
        prove_zero(sp.expand(sp.fraction(difference.rewrite(sp.exp))[0]), claims[-1])
    return claims


# --- the frozen slide in time ----------------------------------------------------------------------------------------


_K, _KT, _Z, _NEAR, _T = sp.symbols("k kt z near t_near", real=True)
_Q, _TANH, _SECH = sp.symbols("q tanh_k sech_2", real=True)
_LONG, _TURNED = sp.symbols("t_far turned", real=True)
_RATIO, _SINE, _COSINE, _VERSINE = sp.symbols("G S C versine", real=True)


def frozen_slopes() -> tuple[dict[sp.Symbol, sp.Expr], dict[str, tuple[sp.Expr, ...]]]:
    """Derivatives of rotation and angular velocity at a time by a, b, omega_0; in two pieces, at z = a b t**2 = 1.

    Returns
    -------
    dict, dict
        Intermediate values in order; the six derivatives where z <= 1 ("near") and beyond ("far", where a, b > 0).

    Notes
    -----
    For omega_0 >= 0, b >= 0 and times up to the standstill: y = cosh(kt) + b omega_0 sinh(kt)/k is at least 1 there.
    """
    k = sp.Max(_K, sp.Float("1e-300"))
    let = {
        _K: sp.sqrt(sp.Abs(a)) * sp.sqrt(sp.Abs(b)),
        _KT: _K * sp.Min(t, 800 / k),
        _Z: sp.sign(a) * sp.sign(b) * _KT**2,
        _NEAR: sp.Max(sp.Min(_Z, 1), -(sp.pi**2)),
        _T: Select(1, _Z, sp.Integer(0), t),
        _VERSINE: sinhc(_NEAR / 4) ** 2 / 2,  # (C - 1)/z
        _SINE: _T * sinhc(_NEAR),
        _COSINE: 1 + _NEAR * _VERSINE,
        _RATIO: a * _VERSINE * _T**2 + omega_0 * _SINE,  # (y - 1)/b
        _Q: sp.exp(-2 * _KT),
        _TANH: (1 - _Q) / (1 + _Q) / Select(1, _Z, _K, sp.Integer(1)),
        _SECH: 4 * _Q / (1 + _Q) ** 2,
        _LONG: Select(1, _Z, t, sp.Integer(0)),  # also counts where exp(-kt) is 0
        _TURNED: (_K * _LONG + sp.log((1 + _Q) / 2) + Log1p(b * omega_0 * _TANH)) / Select(1, _Z, b, sp.Integer(1)),
    }
    return let, {"near": _near(), "far": _far()}


def _near() -> tuple[sp.Expr, ...]:
    y = 1 + b * _RATIO
    velocity = (omega_0 * _COSINE + a * _SINE) / y
    # C_a = b c, C_b = a c; S_a = b s, S_b = a s.
    c, s = _T * _SINE / 2, _T**3 * Remainder(sp.sinh, 1, sp.sqrt(_NEAR), 1) / 2
    ratio_a = c + omega_0 * b * s
    ratio_b = (a * _T**2) ** 2 * Remainder(sp.cosh, 2, sp.sqrt(_NEAR), 1) / 2 + omega_0 * a * s
    return (
        ratio_a / y,
        ratio_b / y + _RATIO**2 * Remainder(Log1p, 1, b * _RATIO, 1),
        _SINE / y,
        (omega_0 * b * c + _SINE + a * b * s - velocity * b * (c + b * omega_0 * s)) / y,
        (omega_0 * a * c + a**2 * s - velocity * (a * c + omega_0 * _SINE + b * omega_0 * a * s)) / y,
        1 / y**2,
    )


def _far() -> tuple[sp.Expr, ...]:
    """With T = tanh(kt)/k: omega = (omega_0 + a T)/(1 + b omega_0 T)."""
    a_, b_ = (Select(1, _Z, x, sp.Integer(1)) for x in (a, b))
    rest = _TANH - _LONG * _SECH
    fall = -rest / 2  # a dT/da = b dT/db
    y = 1 + b_ * omega_0 * _TANH
    velocity = (omega_0 + a_ * _TANH) / y
    return (
        _LONG * _TANH / 2 + omega_0 * fall / a_ / y,
        (a_ * _LONG * _TANH / 2 + omega_0 * (_TANH + fall) / y - _TURNED) / b_,
        _TANH / y,
        (_TANH + _LONG * _SECH + b_ * omega_0 * velocity * rest / a_) / 2 / y,
        ((a_ - b_ * omega_0 * velocity) * fall / b_ - velocity * omega_0 * _TANH) / y,
        _SECH / y**2,
    )


def prove_frozen_slopes() -> list[str]:
    """Prove the derivatives of the frozen motion equal to those of the paper's solution, in both pieces."""
    ways, (let, pieces) = solution(), frozen_slopes()
    k, later = sp.symbols("k t", positive=True)
    root = sp.sqrt(a * b)
    rotation, velocity, y = (ways[n].subs(k, root) for n in ("rotation", "angular_velocity", "y"))
    wanted = {
        (n, p): sp.diff(way, p) for n, way in (("rotation", rotation), ("omega", velocity)) for p in (a, b, omega_0)
    }
    values: dict[sp.Symbol, sp.Expr] = {_K: k, _KT: k * later, _Z: (k * later) ** 2, _NEAR: (k * later) ** 2,
                                        _T: later, _LONG: later}  # fmt: skip
    plain = _plain(values)
    for symbol, value in let.items():
        if symbol != _TURNED:
            values.setdefault(symbol, plain(value))
    claims = []

    def check(claim: str, zero: sp.Expr) -> None:
        zero = zero.subs({a: k**2 / b, t: later}).rewrite(sp.exp)
        prove_zero(sp.simplify(sp.expand_log(zero, force=True)), claim)
        claims.append(claim)

    turned = sp.exp(sp.expand(sp.cancel(b * plain(let[_TURNED]))))
    check("frozen, far: exp(b rotation) = y", turned - y)
    # By b with the rotation kept as one symbol, as exp(b rotation) = y.
    implicit = {("rotation", b): (sp.diff(y, b) / y - _TURNED) / b}
    for piece, slopes in pieces.items():
        exact = wanted if piece == "near" else wanted | implicit
        for slope, ((way, parameter), value) in zip(slopes, exact.items(), strict=True):
            check(f"frozen, {piece}: d{way}/d{parameter}", plain(slope) - value)
    return claims


def _plain(values: dict[sp.Symbol, sp.Expr]) -> Callable[[sp.Expr], sp.Expr]:
    """Guards and clips undone."""

    def plain(e: sp.Expr) -> sp.Expr:
        e = e.replace(Select, lambda smaller, larger, yes, no: yes)
        return unfold(e).subs(values)

    return plain


# --- the balance -----------------------------------------------------------------------------------------------------


def dot(name: str) -> sp.Symbol:
    """The derivative of this argument by a parameter of the scene."""
    return sp.Symbol(f"{name}_dot", real=True)


def _tangent(expression: sp.Expr, names: tuple[str, ...]) -> sp.Expr:
    """How an expression changes when these arguments do."""
    return sum((sp.diff(expression, x) * dot(n) for n in names if (x := sp.Symbol(n, real=True))), sp.Integer(0))


# What has a closed form: nothing but the position and the square of the speed counts.
STEADY = tuple(e for e in EFFECTS if not {"speed", "time", "history"} & set(e.depends_on))


def balance_tangent() -> Program:
    """Changes of drive, tilt, constant, brake and what presses; what an effect would bring is 0 without it."""
    whole = terms(STEADY)
    drive = effects.FALL - whole["resistance"].subs({effects.OMEGA: 0, effects.OMEGA_2: 0})
    pressing = sp.expand(effects.LEVEL * whole["effective_stress"])
    changing = (drive, whole["tilt"], whole["constant"], whole["brake"], pressing)
    names = tuple(n for n in ORDER if any(n == x.name for e in changing for x in e.free_symbols))
    outputs = [_tangent(e, ORDER) for e in changing]
    return program("balance_tangent", (*names, *(f"{n}_dot" for n in names)), *(sp.expand(e) for e in outputs))


POSITION = ("fall", "press", "fall_slope", "press_slope")
_WEIGHT, _RADIAL, _DIP = sp.symbols("weight radial dip", real=True)


def position_tangent() -> Program:
    """Changes of J_theta/Theta*, J_r/Theta* and their slopes by the dip, with the relative growth of the amplitudes."""
    fall, press = _WEIGHT * sp.sin(_DIP), _RADIAL * sp.cos(_DIP)
    values = (fall, press, sp.diff(fall, _DIP), sp.diff(press, _DIP))
    names = {v: sp.Symbol(n, real=True) for v, n in zip(values, POSITION, strict=True)}
    outputs = []
    for value in values:
        slope = sp.diff(value, _DIP)
        size, sign = (names[slope], 1) if slope in names else (names[-slope], -1)
        amplitude = _WEIGHT if value.has(_WEIGHT) else _RADIAL
        prove_zero(sp.diff(value, amplitude) * amplitude - value, "a weight is proportional to its amplitude")
        outputs.append(names[value] * sp.Symbol(f"{amplitude}_growth", real=True) + sign * size * dot("dip"))
    return program("position_tangent", (*POSITION, "weight_growth", "radial_growth", "dip_dot"), *outputs)


_SCALES = tuple(x.name for x in (VALUE, ALPHA, GRAVITY, REFERENCE, THETA))


def parameter_tangents() -> list[Program]:
    """Change of each effect's dimensionless parameter, by the value and by what it is made dimensionless with."""
    inputs = (*_SCALES, *(f"{n}_dot" for n in _SCALES))
    return [
        program(f"{p.symbol}_tangent", inputs, _tangent(p.dimensionless, _SCALES))
        for e in STEADY for p in e.parameters if p.symbol is not None
    ]  # fmt: skip


# --- the arc ---------------------------------------------------------------------------------------------------------

GROWTHS = ("weight_moment_amplitude", "radial_weight_amplitude", "polar_moment", "resistance_factor")


def arc_growth(closed: dict[str, sp.Expr]) -> tuple[sp.Expr, ...]:
    """Relative derivatives by alpha of C_theta, C_r, I_p*, lambda, all over Theta*, then of Theta* times alpha.

    From the reduced functions F/alpha**3, whose slopes are O(alpha) each: nothing cancels in thin arcs.
    """
    inertia = stable(closed["moment_of_inertia"]).reduced
    log_slope = sp.diff(inertia, alpha) / inertia
    found = [sp.diff(x, alpha) / x - log_slope for x in (stable(closed[n]).reduced for n in GROWTHS)]
    return (*found, 3 + alpha * log_slope)


def prove_arc_growth(closed: dict[str, sp.Expr]) -> list[str]:
    """Prove the slopes of the reduced functions equal to those of the closed forms over alpha**3, by name."""
    claims = []
    for name, form in closed.items():
        claim = f"{name}: slope of the reduced function"
        prove_equal(alpha**3 * sp.diff(stable(form).reduced, alpha), sp.diff(form, alpha) - 3 * form / alpha, claim)
        claims.append(claim)
    return claims


# --- text ------------------------------------------------------------------------------------------------------------


def programs(closed: dict[str, sp.Expr]) -> list[tuple[Program, str]]:
    """What `generated/sensitivity.py` holds, with a sentence for each."""
    let, pieces = frozen_slopes()
    frozen = [Select(1, _Z, far, near) for near, far in zip(pieces["near"], pieces["far"], strict=True)]
    names = tuple(x.name for x in ENERGY_INPUTS)
    return [
        (program("energy_slopes", names, *energy_slopes()), "dE/d(start, drive, tilt, constant, brake) at x"),
        (program("energy_growth", ("x", "brake"), *energy_growth()),
         "how the energy of a short motion changes with its length"),
        (program("frozen_slopes", ("a", "b", "omega_0", "t"), *frozen, let=let),
         "derivatives of rotation, then of angular velocity, at a time by a, b and omega_0"),
        (program("arc_growth", ("alpha",), *arc_growth(closed), let={alpha: sp.Min(alpha, sp.pi / 2)}),
         "relative slopes of C_theta, C_r, I_p*, lambda, all over Theta*, and of Theta* times alpha"),
        (balance_tangent(), "changes of drive, tilt, constant, brake and what presses, lambda sigma/Theta*"),
        (position_tangent(), "changes of J_theta, J_r over Theta* and of their slopes by the dip"),
        *((p, "change of a dimensionless parameter") for p in parameter_tangents()),
    ]  # fmt: skip
