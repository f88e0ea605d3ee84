"""Real slopes: the mass between an arc and a ground of straight edges, and the balance of the slices above an arc.

Lengths are over R, from the centre of the circle, y up. The region is what an arc cuts off below a ground; it is
integrated one edge at a time, as the ring between the edge and the arc that is seen from the centre under the same
angle. An edge from P1 to P2 = P1 + e lies on a line at the distance p = P1 x e/d from the centre, d = |e|; t = P.e/d
is measured along it from the foot of the perpendicular, so that rho^2 = p^2 + t^2 and dtheta = p dt/rho^2.

Two forms of the same integral, of which the run time takes one by a stated rule (``REACH``):

closed
    Sector minus triangle. The sector is at most about 16 times the ring where d > (r1 + r2)/4, so nothing cancels.
rings
    Quadrature along the edge over g = 1 - rho^2, which is (1-s) g1 + s g2 + s (1-s) d^2, a sum of positive terms: no
    digit is lost however thin the mass. The only singularities are those of 1/rho, at the distance |(P1 + P2)/2| of the
    edge's middle in the complex plane. Where d <= (r1 + r2)/4 this is at least 3.87 half lengths of the edge, and
    Gauss' rule of ``NODES`` nodes leaves about (3.87 + sqrt(3.87^2 - 1))^(-2 NODES) < 1e-17 of the greatest value.
"""

import sympy as sp

from derive.algebra.integrate import antiderivative
from derive.algebra.prove import prove_zero
from derive.algebra.remainders import Remainder, unfold
from derive.declare.quantities import MOMENTS
from derive.declare.symbols import alpha, r, theta

REACH, NODES = sp.Rational(1, 4), 10
# What is integrated over r and theta: of the area, of the two inertias, and of the weights as vectors.
WEIGHTS = {
    "area": r,
    "polar": r**2,
    "inertia": r**3,
    "radial_x": r * sp.cos(theta),
    "radial_y": r * sp.sin(theta),
    "moment_x": r**2 * sp.cos(theta),
    "moment_y": r**2 * sp.sin(theta),
}
# The paper's moments among them, and what they become as the mass turns by phi: J cos(phi) - slope sin(phi).
MEANS = {
    "polar_moment": ("polar", 1),
    "moment_of_inertia": ("inertia", 1),
    "radial_weight": ("radial_y", -1),
    "weight_moment": ("moment_x", -1),
}
SLOPES = {"radial_weight": ("radial_x", 1), "weight_moment": ("moment_y", -1)}

X, Y, E_X, E_Y, ANGLE, G = sp.symbols("x y e_x e_y angle g", real=True)
_P, _T, _T1, _T2, _PHI = sp.symbols("p t t1 t2 phi", real=True)
_LOG = sp.Symbol("L", real=True)  # artanh(t2/r2) - artanh(t1/r1)
_TAU = sp.symbols("tau_x tau_y", real=True)


def _rho(t: sp.Expr) -> sp.Expr:
    return sp.sqrt(_P**2 + t**2)


def _split(weight: sp.Expr) -> tuple[int, sp.Expr]:
    """n and the direction of a weight r**(n - 1) direction(theta), whose integral over r from 0 is r**n/n direction."""
    n = int(sp.degree(weight, r)) + 1
    return n, weight / r ** (n - 1)


def triangles() -> dict[str, sp.Expr]:
    """Integrals over the triangle between the centre and an edge, in p, t1, t2, tau and L, by the weight's name.

    Inner integral, parameter t, term by term over t from t1 to t2; each whole is differentiated back.
    """
    # A point of the edge's line: (tau_y, -tau_x) points from the centre to the line, where p > 0.
    x, y = _P * _TAU[1] + _T * _TAU[0], -_P * _TAU[0] + _T * _TAU[1]
    found = {}
    for name, weight in WEIGHTS.items():
        n, direction = _split(weight)
        direction = direction.subs({sp.cos(theta): x / _rho(_T), sp.sin(theta): y / _rho(_T)})
        integrand = sp.expand(sp.simplify(_rho(_T) ** n / n * direction * _P / _rho(_T) ** 2))
        form = sp.Integer(0)
        for term in sp.Add.make_args(integrand):
            factor, rest = term.as_independent(_T)
            form += factor * _PRIMITIVES[sp.simplify(rest)] if rest != 1 else factor * (_T2 - _T1)
        at_2 = sp.diff(form, _T2) + sp.diff(form, _LOG) / _rho(_T2)  # dL/dt2 = 1/r2, proved in `prove`
        prove_zero(at_2 - integrand.subs(_T, _T2), f"{name}: the triangle's integral grows with t2 as it must")
        prove_zero(form.subs({_T2: _T1, _LOG: 0}), f"{name}: an edge without length has none")
        found[name] = form
    return found


# Integrals over t from t1 to t2 with their differences of near equals divided out: r2 - r1 and t2 r2 - t1 r1 are small
# for short edges. They are proved where they are used.
_D, _SUM = _T2 - _T1, _rho(_T1) + _rho(_T2)
_PRIMITIVES = {
    _rho(_T): _D / 4 * ((_T1 + _T2) ** 2 / _SUM + _SUM) + _P**2 * _LOG / 2,
    1 / _rho(_T): _LOG,
    _T / _rho(_T): _D * (_T1 + _T2) / _SUM,
    _T: _D * (_T1 + _T2) / 2,
    _T**2: _D * (_T1**2 + _T1 * _T2 + _T2**2) / 3,
}


def closed() -> tuple[sp.Expr, ...]:
    """Sector minus triangle for each of ``WEIGHTS``, in x, y, e_x, e_y and the angle from P1 to P2."""
    x2, y2, d = X + E_X, Y + E_Y, sp.sqrt(E_X**2 + E_Y**2)
    r1, r2 = sp.sqrt(X**2 + Y**2), sp.sqrt(x2**2 + y2**2)
    below_1 = 1 - sp.Rational(1, 2**53)  # a centre on the edge: p L = 0 for every finite L
    at = {
        _LOG: 2 * sp.atanh(sp.Min(d / (r1 + r2), below_1)),
        _rho(_T1): r1,
        _rho(_T2): r2,
        _P: (X * E_Y - Y * E_X) / d,
        _T1: (X * E_X + Y * E_Y) / d,
        _T2: (x2 * E_X + y2 * E_Y) / d,
        _TAU[0]: E_X / d,
        _TAU[1]: E_Y / d,
    }
    found = []
    for name, triangle in triangles().items():
        n, direction = _split(WEIGHTS[name])
        sector = antiderivative(direction, theta) / n
        if direction == 1:
            ring = sector.subs(theta, ANGLE)
        else:  # cosines and sines of the ends
            ends = [sector.subs({sp.cos(theta): a / b, sp.sin(theta): c / b}) for a, c, b in ((X, Y, r1), (x2, y2, r2))]
            ring = ends[1] - ends[0]
        found.append(ring - triangle.subs(_T2 - _T1, d).subs(at, simultaneous=True))
    return tuple(found)


def rings() -> tuple[sp.Expr, ...]:
    """(1 - rho^n)/n over rho^2, for n of area, polar, inertia; then over rho^3, for those of radial and moment; in g.

    Times P1 x e they are what a ring grows by along the edge, ds; the last two times the point itself.
    """
    rho = sp.sqrt(1 - G)
    area = G / 2
    polar = G * (1 + rho + rho**2) / (3 * (1 + rho))
    inertia = G * (1 + rho**2) / 4
    forms = (area / rho**2, polar / rho**2, inertia / rho**2, area / rho**3, polar / rho**3)
    for form, name in zip(forms, ("area", "polar", "inertia", "radial_x", "moment_x"), strict=True):
        n, direction = _split(WEIGHTS[name])
        wanted = (1 - r**n) / n / r ** (2 if direction == 1 else 3)
        prove_zero(form.subs(G, 1 - r**2).subs(sp.sqrt(r**2), r) - wanted, f"{name}: the ring over dtheta")
    return forms


# --- the slices ------------------------------------------------------------------------------------------------------
# At beta from straight below the centre, positive down-slope (right): the arc is at (sin, -cos), and the slice above it
# has the height h and the width cos dbeta. Stresses are over gamma R, so its weight is h cos dbeta.

SINE, COSINE, HEIGHT, PRESSURE, COHESION, MU, K_H, FACTOR = sp.symbols(
    "sine cosine height pressure cohesion mu k_h factor", real=True
)
DISTANCE, BETA, SLOPE = sp.symbols("distance beta slope", real=True)
_N, _S, _RHO, _Y = sp.symbols("N S rho y", real=True)
_CIRCLE = {SINE**2: 1 - COSINE**2}


def slices() -> dict[str, sp.Expr]:
    """Integrands over beta, from the balance of one slice, by name: `generated.slopes` says what each is.

    Of the ordinary method the forces between slices have no component along the radius, of Bishop's none along the
    vertical: (c + N' mu) = strength/lever. ``distance`` is that of the ground's point above the arc's from the centre.
    """
    weight = HEIGHT * COSINE
    force = sp.Matrix([K_H * weight, -weight])
    outward, along = sp.Matrix([SINE, -COSINE]), sp.Matrix([COSINE, SINE])
    balance = force - _N * outward - _S * along
    middle = sp.Matrix([SINE, -COSINE + HEIGHT / 2])
    moment = sp.expand(middle[0] * force[1] - middle[1] * force[0])
    radial = sp.solve(balance.dot(outward).expand().subs(_CIRCLE).expand(), _N)[0]
    strength = COHESION + (_N - PRESSURE) * MU
    vertical = sp.solve(balance[1].subs(_S, strength / FACTOR), _N)[0]
    lever = COSINE - SINE * MU / FACTOR
    bishop = (COHESION + MU * (HEIGHT - PRESSURE)) * COSINE
    prove_zero(strength.subs(_N, vertical) - bishop / lever, "Bishop's strength")
    normal = ((HEIGHT - PRESSURE) * COSINE + SINE * COHESION / FACTOR) / lever
    prove_zero(normal - (vertical - PRESSURE), "Bishop's effective normal stress")
    for name, found in (("Bishop", bishop / lever), ("ordinary", strength)):
        prove_zero(found.subs(MU, 0) - COHESION, f"without friction the strength is the cohesion: {name}")
    return {
        "drive": sp.factor(moment),
        "ordinary_normal": sp.factor(radial) - PRESSURE,
        "bishop_strength": bishop,
        "bishop_lever": lever,
        "bishop_normal": normal,
        # Of the weight along the radius, -y/rho and x/rho over a strip: their integrals over y, where drho = y/rho dy.
        "radial_weight": COSINE * _strip(-_Y / _RHO, -_RHO),
        "radial_tilt": COSINE * SINE * _strip(1 / _RHO, -sp.log(_RHO - _Y)),
    }


def _strip(integrand: sp.Expr, primitive: sp.Expr) -> sp.Expr:
    """The integral over y from the arc up to the ground, by a primitive in rho and y, which is proved."""
    prove_zero(sp.diff(primitive, _Y) + sp.diff(primitive, _RHO) * _Y / _RHO - integrand, f"{primitive} over a strip")
    ground = primitive.subs({_RHO: DISTANCE, _Y: HEIGHT - COSINE}, simultaneous=True)
    return sp.logcombine(ground - primitive.subs({_RHO: 1, _Y: -COSINE}, simultaneous=True), force=True)


def head() -> sp.Expr:
    """Integral of a line's height above the arc, from where it is a height, at a sine and a cosine, over an angle more.

    Each term is small where the angle or the height is, so that neither thin masses nor steep lines cancel.
    """
    bent, defect = 2 * sp.sin(ANGLE / 2) ** 2, -(ANGLE**3) * Remainder(sp.sin, 3, ANGLE)
    return HEIGHT * ANGLE + (SLOPE * COSINE - SINE) * bent - (SLOPE * SINE + COSINE) * defect


def prove() -> list[str]:
    """Prove what the forms above rest on; the claims."""
    ratio = (_T2 - _T1) / (_rho(_T1) + _rho(_T2))  # L is computed from it
    # The ring along the edge: 1 - rho^2 is a sum of positive terms inside the circle.
    s, g1, g2 = sp.symbols("s g1 g2", real=True)
    x, y = X + s * E_X, Y + s * E_Y
    parts = (1 - s) * g1 + s * g2 + s * (1 - s) * (E_X**2 + E_Y**2)
    ends = {g1: 1 - X**2 - Y**2, g2: 1 - (X + E_X) ** 2 - (Y + E_Y) ** 2}
    claims = {
        "L grows by dt/rho": sp.diff(2 * sp.atanh(ratio), _T2) - 1 / _rho(_T2),
        "dtheta = P1 x e ds/rho^2": sp.diff(sp.atan2(y, x), s) - (X * E_Y - Y * E_X) / (x**2 + y**2),
        "1 - rho^2 along an edge": parts.subs(ends) - (1 - x**2 - y**2),
    }
    for moment in MOMENTS:
        if moment.name in MEANS:
            name, sign = MEANS[moment.name]
            claims[f"{moment.symbol} is {'-' if sign < 0 else ''}{name}"] = moment.weight - sign * WEIGHTS[name]
        if moment.name in SLOPES:
            name, sign = SLOPES[moment.name]
            turned = sp.expand_trig(moment.weight.subs(theta, theta + _PHI))
            two = moment.weight * sp.cos(_PHI) - sign * WEIGHTS[name] * sp.sin(_PHI)
            claims[f"{moment.symbol} of the turned mass"] = turned - two
    claims |= _of_one_chord()
    for words, zero in claims.items():
        prove_zero(zero, words)
    return [*claims]


def _of_one_chord() -> dict[str, sp.Expr]:
    """That the slices of the mass under one straight chord give the paper's closed forms."""
    forms, middle = slices(), sp.Symbol("beta_m", real=True)
    height = (sp.cos(BETA - middle) - sp.cos(alpha)) / sp.cos(middle)
    chord = {SINE: sp.sin(BETA), COSINE: sp.cos(BETA), HEIGHT: height, K_H: 0, PRESSURE: 0}

    def whole(name: str) -> sp.Expr:
        u = sp.Symbol("u", real=True)
        primitive = antiderivative(sp.expand_trig(forms[name].subs(chord).subs(BETA, middle + u)), u)
        return primitive.subs(u, alpha) - primitive.subs(u, -alpha)

    # Fellenius' normal force of one chord, closed: the mean of h cos^2 over the arc.
    even = (sp.sin(alpha) - alpha * sp.cos(alpha)) + (
        (sp.sin(alpha) + sp.sin(3 * alpha) / 3) / 2 - sp.cos(alpha) * sp.sin(2 * alpha) / 2
    ) * sp.cos(2 * middle)
    low, unfolded = sp.Symbol("low", real=True), unfold(head())
    above = HEIGHT + SLOPE * (sp.sin(low + ANGLE) - sp.sin(low)) + sp.cos(low + ANGLE) - sp.cos(low)
    grown = sp.diff(unfolded.subs({SINE: sp.sin(low), COSINE: sp.cos(low)}), ANGLE)
    return {
        "the drive of slices is J_theta": whole("drive") + sp.Rational(2, 3) * sp.sin(alpha) ** 3 * sp.sin(middle),
        "the ordinary method's normal force in closed form": whole("ordinary_normal") * sp.cos(middle) - even,
        "height of a line above the arc": sp.expand_trig(grown - above),
        "no height over no angle": sp.limit(unfolded, ANGLE, 0),
    }
