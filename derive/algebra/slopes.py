"""Real slopes: the mass between an arc and a ground of straight edges, and the balance of slices above an arc.

Lengths are divided by R, the origin is the centre of the circle, and y points upwards. The region between ground and
arc is integrated one edge at a time, as the ring between the edge and the arc that subtends the same angle at the
centre. An edge from P1 to P2 = P1 + e lies on a line at the distance p = P1 x e/d from the centre, with d = |e|.
t = P.e/d is measured along it from the foot of the perpendicular, so that rho^2 = p^2 + t^2 and dtheta = p dt/rho^2.

The runtime selects one of two forms of the same integral by a stated rule (``REACH``):

closed
    Sector minus triangle. For d > (r1 + r2)/4 the sector is at most about 16 times the ring, so that little cancels.
rings
    Quadrature along the edge over g = 1 - rho^2 = (1-s) g1 + s g2 + s (1-s) d^2, a sum of positive terms, so that no
    digit is lost however thin the mass. The only singularities, of 1/rho, are at the distance |(P1 + P2)/2| from the
    middle of the edge in the complex plane. For d <= (r1 + r2)/4 this distance is at least 3.87 half lengths of the
    edge, and the error of Gauss' rule with ``NODES`` nodes is about (3.87 + sqrt(3.87^2 - 1))^(-2 NODES) < 1e-17 of the
    greatest value.
"""

import sympy as sp
from sympy import (
    Add,
    Expr,
    Matrix,
    Min,
    Rational,
    Symbol,
    atan2,
    atanh,
    cos,
    degree,
    diff,
    expand,
    expand_trig,
    fraction,
    limit,
    log,
    logcombine,
    simplify,
    sin,
    solve,
    sqrt,
    symbols,
)

from derive.algebra.integrate import antiderivative
from derive.algebra.prove import prove_zero
from derive.algebra.remainders import SineRest, unfold
from derive.declare.symbols import Forms, alpha, r, theta

REACH = Rational(1, 4)
NODES = 10
# Integrands over r and theta: area, both moments of inertia, and the weights as vectors.
WEIGHTS = {
    "area": r,
    "polar": r**2,
    "inertia": r**3,
    "radial_x": r * cos(theta),
    "radial_y": r * sin(theta),
    "moment_x": r**2 * cos(theta),
    "moment_y": r**2 * sin(theta),
}

X, Y, E_X, E_Y, ANGLE, G = symbols("x y e_x e_y angle g", real=True)
_P, _T, _T1, _T2 = symbols("p t t1 t2", real=True)
_LOG = Symbol("L", real=True)  # artanh(t2/r2) - artanh(t1/r1)
_TAU = symbols("tau_x tau_y", real=True)


def _rho(t: Expr) -> Expr:
    """Return the distance from the centre of a point of an edge's line, at t from the foot of the perpendicular."""
    return sqrt(_P**2 + t**2)


def _split(weight: Expr) -> tuple[int, Expr]:
    """Return n and direction of a weight r**(n - 1) direction(theta), whose radial integral is r**n/n direction."""
    n = int(degree(weight, r)) + 1
    return n, weight / r ** (n - 1)


def triangles() -> Forms:
    """Return integrals over the triangle between the centre and an edge, in p, t1, t2, tau and L, by the weight's name.

    The inner integral is integrated term by term over t from t1 to t2, and each sum is differentiated to prove it.
    """
    # A point of the edge's line: (tau_y, -tau_x) points from the centre to the line, where p > 0.
    rho = _rho(_T)
    x = _P * _TAU[1] + _T * _TAU[0]
    y = -_P * _TAU[0] + _T * _TAU[1]
    integrals = {}
    for name, weight in WEIGHTS.items():
        n, direction = _split(weight)
        direction = direction.subs({cos(theta): x / rho, sin(theta): y / rho})
        over_theta = rho**n / n * direction
        integrand = expand(simplify(over_theta * _P / rho**2))
        form = Add(*map(_along_edge, Add.make_args(integrand)))
        at_2 = diff(form, _T2) + diff(form, _LOG) / _rho(_T2)  # dL/dt2 = 1/r2, proved in `prove`
        prove_zero(at_2 - integrand.subs(_T, _T2), f"{name}: the triangle's integral grows with t2 as it must")
        prove_zero(form.subs({_T2: _T1, _LOG: 0}), f"{name}: an edge without length has none")
        integrals[name] = form
    return integrals


def _along_edge(term: Expr) -> Expr:
    """Return the integral of one term of an integrand over t from t1 to t2, the ends of an edge."""
    factor, rest = term.as_independent(_T)
    if rest == 1:
        return factor * (_T2 - _T1)
    return factor * _PRIMITIVES[simplify(rest)]


# Integrals over t from t1 to t2 without differences of nearly equal numbers, since r2 - r1 and t2 r2 - t1 r1 are small
# for short edges. `triangles` proves them.
_D = _T2 - _T1
_TOTAL = _T1 + _T2
_SUM = _rho(_T1) + _rho(_T2)
_PRIMITIVES = {
    _rho(_T): _D / 4 * (_TOTAL**2 / _SUM + _SUM) + _P**2 * _LOG / 2,
    1 / _rho(_T): _LOG,
    _T / _rho(_T): _D * _TOTAL / _SUM,
    _T: _D * _TOTAL / 2,
    _T**2: _D * (_T1**2 + _T1 * _T2 + _T2**2) / 3,
}


def closed() -> tuple[Expr, ...]:
    """Return sector minus triangle for each of ``WEIGHTS``, in x, y, e_x, e_y and the angle from P1 to P2."""
    x2 = X + E_X
    y2 = Y + E_Y
    d = sqrt(E_X**2 + E_Y**2)
    r1 = sqrt(X**2 + Y**2)
    r2 = sqrt(x2**2 + y2**2)
    below_1 = 1 - Rational(1, 2**53)  # for a centre on the edge p L = 0 for every finite L
    of_edge = {
        _LOG: 2 * atanh(Min(d / (r1 + r2), below_1)),
        _rho(_T1): r1,
        _rho(_T2): r2,
        _P: (X * E_Y - Y * E_X) / d,
        _T1: (X * E_X + Y * E_Y) / d,
        _T2: (x2 * E_X + y2 * E_Y) / d,
        _TAU[0]: E_X / d,
        _TAU[1]: E_Y / d,
    }
    at_1 = {cos(theta): X / r1, sin(theta): Y / r1}
    at_2 = {cos(theta): x2 / r2, sin(theta): y2 / r2}
    rings = []
    for name, triangle in triangles().items():
        n, direction = _split(WEIGHTS[name])
        primitive = antiderivative(direction, theta) / n
        if direction == 1:
            sector = primitive.subs(theta, ANGLE)
        else:
            sector = primitive.subs(at_2) - primitive.subs(at_1)
        below = triangle.subs(_T2 - _T1, d).subs(of_edge, simultaneous=True)
        rings.append(sector - below)
    return tuple(rings)


def rings() -> tuple[Expr, ...]:
    """Return (1 - rho^n)/n over rho^2 for area, polar and inertia, and over rho^3 for radial and moment, in g.

    Multiplied by P1 x e they are the growth of a ring along the edge, ds. The last two are also multiplied by the
    point.
    """
    forms = []
    for name in ("area", "polar", "inertia", "radial_x", "moment_x"):
        n, direction = _split(WEIGHTS[name])
        # In lowest terms of r, where nothing cancels near the arc; 1 - r^2 is g.
        top, bottom = fraction(sp.factor((1 - r**n) / n / (1 - r**2)))
        power = 2 if direction == 1 else 3
        forms.append((G * top / expand(bottom) / r**power).subs(r, sqrt(1 - G)))
    return tuple(forms)


# --- the slices ------------------------------------------------------------------------------------------------------
# beta is measured from straight below the centre, positive down-slope (right). The arc is at (sin, -cos), and the slice
# above it has the height h and the width cos dbeta. Stresses are divided by gamma R, so that its weight is h cos dbeta.

SINE, COSINE, HEIGHT, PRESSURE, COHESION, MU, K_H, FACTOR = symbols(
    "sine cosine height pressure cohesion mu k_h factor", real=True
)
DISTANCE, BETA, SLOPE = symbols("distance beta slope", real=True)
_N, _S, _RHO, _Y = symbols("N S rho y", real=True)
_CIRCLE = {SINE**2: 1 - COSINE**2}


def slices() -> Forms:
    """Return integrands over beta from the balance of one slice, by name. `generated.slopes` describes each.

    N and S are the normal and shear force over dbeta: force = N outward + S along. In the ordinary method the forces
    between slices have no component along the radius, in Bishop's method no vertical component.
    """
    weight = HEIGHT * COSINE
    force = Matrix([K_H * weight, -weight])
    outward = Matrix([SINE, -COSINE])
    along = Matrix([COSINE, SINE])
    balance = force - _N * outward - _S * along
    x = SINE
    y = -COSINE + HEIGHT / 2
    moment = expand(x * force[1] - y * force[0])
    radial = expand(balance.dot(outward))
    radial = expand(radial.subs(_CIRCLE))
    normal = solve(radial, _N)[0]
    strength = COHESION + (_N - PRESSURE) * MU
    # Radial component of the weight, -y/rho and x/rho over a strip, integrated over y, where drho = y/rho dy.
    strip = _strip(-_Y / _RHO, -_RHO)
    tilted_strip = _strip(1 / _RHO, -log(_RHO - _Y))
    return {
        "drive": sp.factor(moment),
        "ordinary_normal": sp.factor(normal) - PRESSURE,
        **_bishop(balance, strength),
        "radial_weight": COSINE * strip,
        "radial_tilt": COSINE * SINE * tilted_strip,
    }


def _bishop(balance: Matrix, strength: Expr) -> Forms:
    """Return Bishop's strength times lever, lever m_alpha, and effective normal stress by name, from the balance."""
    vertical = solve(balance[1].subs(_S, strength / FACTOR), _N)[0]
    lever = COSINE - SINE * MU / FACTOR
    mobilised = (COHESION + MU * (HEIGHT - PRESSURE)) * COSINE
    normal = ((HEIGHT - PRESSURE) * COSINE + SINE * COHESION / FACTOR) / lever
    prove_zero(strength.subs(_N, vertical) - mobilised / lever, "Bishop's strength")
    prove_zero(normal - (vertical - PRESSURE), "Bishop's effective normal stress")
    return {"bishop_strength": mobilised, "bishop_lever": lever, "bishop_normal": normal}


def _strip(integrand: Expr, primitive: Expr) -> Expr:
    """Return the integral over y from the arc to the ground in a strip, after proving its primitive."""
    prove_zero(diff(primitive, _Y) + diff(primitive, _RHO) * _Y / _RHO - integrand, f"{primitive} over a strip")
    at_ground = primitive.subs({_RHO: DISTANCE, _Y: HEIGHT - COSINE}, simultaneous=True)
    at_arc = primitive.subs({_RHO: 1, _Y: -COSINE}, simultaneous=True)
    return logcombine(at_ground - at_arc, force=True)


def head() -> Expr:
    """Return the integral of a line's height above the arc over an angle, from height, sine and cosine at the start.

    Each term is small where the angle or the height is small, so that neither thin masses nor steep lines cancel.
    """
    bent = 2 * sin(ANGLE / 2) ** 2
    defect = -(ANGLE**3) * SineRest(ANGLE)
    turned = SLOPE * COSINE - SINE
    along = SLOPE * SINE + COSINE
    return HEIGHT * ANGLE + turned * bent - along * defect


def prove() -> list[str]:
    """Prove the basis of the forms above, and return the claims."""
    claims = _of_edges() | _of_one_chord() | _of_heads()
    for claim, zero in claims.items():
        prove_zero(zero, claim)
    return [*claims]


def _of_edges() -> Forms:
    """Return claims about L and dtheta along an edge, and about 1 - rho^2 as a sum of positive terms."""
    ratio = (_T2 - _T1) / (_rho(_T1) + _rho(_T2))  # L is computed from it
    s, g1, g2 = symbols("s g1 g2", real=True)
    x = X + s * E_X
    y = Y + s * E_Y
    squared_length = E_X**2 + E_Y**2
    depth = (1 - s) * g1 + s * g2 + s * (1 - s) * squared_length
    second = 1 - (X + E_X) ** 2 - (Y + E_Y) ** 2
    ends = {g1: 1 - X**2 - Y**2, g2: second}
    return {
        "L grows by dt/rho": diff(2 * atanh(ratio), _T2) - 1 / _rho(_T2),
        "dtheta = P1 x e ds/rho^2": diff(atan2(y, x), s) - (X * E_Y - Y * E_X) / (x**2 + y**2),
        "1 - rho^2 along an edge": depth.subs(ends) - (1 - x**2 - y**2),
    }


def _of_one_chord() -> Forms:
    """Return the claim that the drive of slices under one straight chord is J_theta in closed form (3.13)."""
    middle, u = symbols("beta_m u", real=True)
    height = (cos(BETA - middle) - cos(alpha)) / cos(middle)
    chord = {SINE: sin(BETA), COSINE: cos(BETA), HEIGHT: height, K_H: 0}
    primitive = antiderivative(expand_trig(slices()["drive"].subs(chord).subs(BETA, middle + u)), u, "1.55")
    over_arc = primitive.subs(u, alpha) - primitive.subs(u, -alpha)
    return {"the drive of slices is J_theta": over_arc + Rational(2, 3) * sin(alpha) ** 3 * sin(middle)}


def _of_heads() -> Forms:
    """Return claims that `head` is the integral of a line's height above the arc."""
    low = Symbol("low", real=True)
    integral = unfold(head())
    high = low + ANGLE
    above = HEIGHT + SLOPE * (sin(high) - sin(low)) + cos(high) - cos(low)
    slope = diff(integral.subs({SINE: sin(low), COSINE: cos(low)}), ANGLE)
    return {
        "height of a line above the arc": expand_trig(slope - above),
        "no height over no angle": limit(integral, ANGLE, 0),
    }
