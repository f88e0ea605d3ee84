"""What follows from the paper's definitions: the evidence that `derive.judge.verify` holds against its claims.

Nothing here knows what the paper prints, except where a method says so: `second_appendix`, and `coefficients` with
the slips that explain the printed numbers.
"""

from functools import cache, cached_property
from typing import Any

import mpmath as mp
import sympy as sp

from derive.algebra import dynamics
from derive.algebra.integrate import PSI, Derivation, derive, quadrature
from derive.check.proof import ProofError
from derive.declare import symbols
from derive.declare.quantities import CHORD, MOMENTS
from derive.declare.symbols import alpha, omega_0, r, t, theta, theta_1, theta_2, theta_m
from derive.judge.appendices import APPENDIX_II
from derive.judge.appendices import simplify as simplify_appendix
from derive.judge.paper import GRAVITY, SECTION, SPAN

_RATE = sp.symbols("c0 c1 c2", positive=True)
_RATES = sp.symbols("omega omega_dot", real=True)


class Context:
    """What the definitions give, derived once and only when asked for; the words in which `judge.paper` speaks."""

    # --- mechanics ---------------------------------------------------------------------------------------

    @staticmethod
    def basis(x: sp.Expr, y: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Components along e_r and e_theta of a Cartesian vector."""
        c, s = sp.cos(theta), sp.sin(theta)
        return sp.simplify(x * c + y * s), sp.simplify(y * c - x * s)

    def rate(self, order: int) -> tuple[sp.Expr, sp.Expr]:
        """Polar components of the derivative of the position r e_r by time, with d(theta)/dt = omega (1.2)."""
        moving = sp.Function("theta")(t)
        place = (r * sp.cos(moving), r * sp.sin(moving))
        omega, omega_dot = _RATES
        known = ((moving.diff(t, 2), omega_dot), (moving.diff(t), omega), (moving, theta))
        return self.basis(*(x.diff(t, order).subs(known) for x in place))

    def gravity(self) -> tuple[sp.Expr, sp.Expr]:
        """Components of (0, -g)."""
        return self.basis(sp.Integer(0), -dynamics.g)

    @staticmethod
    def moment_of(radius: sp.Expr, force: tuple[sp.Expr, sp.Expr]) -> sp.Expr:
        """The moment about K of a force in polar components: its radial part has no lever."""
        place, push = (sp.Matrix([x, y, 0]) for x, y in ((radius, 0), force))
        return place.cross(push)[2]

    def reaction(self) -> tuple[sp.Expr, sp.Expr]:
        """Polar components of the traction on the arc: pressure against the outward normal, shear against velocity."""
        arc = sp.Matrix([sp.cos(theta), sp.sin(theta)])
        tangent = arc.diff(theta)
        normal, sigma, tau = sp.Matrix([tangent[1], -tangent[0]]), sp.Symbol("sigma_n"), sp.Symbol("tau_n")
        return self.basis(*(-sigma * normal - tau * tangent))

    @property
    def area(self) -> sp.Expr:
        """Area over dr dtheta: the Jacobian of the polar coordinates."""
        place = sp.Matrix([r * sp.cos(theta), r * sp.sin(theta)])
        return sp.simplify(place.jacobian([r, theta]).det())

    @property
    def arc(self) -> sp.Expr:
        """Length over dtheta on the circle."""
        x, y = (dynamics.R * f(theta).diff(theta) for f in (sp.cos, sp.sin))
        return sp.sqrt(sp.simplify(x**2 + y**2))

    @property
    def stress_sum(self) -> sp.Expr:
        """The stress added up along the arc, over the angle from its first end."""
        return sp.Integral(sp.Function("sigma")(symbols.u), (symbols.u, 0, 2 * alpha))

    @cached_property
    def chord(self) -> sp.Expr:
        """Where the ray at theta meets the line through both ends of the arc, from collinearity."""
        ends = [dynamics.R * sp.Matrix([sp.cos(x), sp.sin(x)]) for x in (theta_1, theta_1 + 2 * alpha)]
        ray = r * sp.Matrix([sp.cos(theta), sp.sin(theta)])
        return sp.solve(sp.Matrix.hstack(ray - ends[0], ends[1] - ends[0]).det(), r)[0]

    @cached_property
    def deepest(self) -> sp.Expr:
        """The largest R - R_1: the one stationary point, in u = theta - theta_m, and a maximum."""
        u = symbols.u
        depth = dynamics.R * (1 - sp.cos(alpha) / sp.cos(u))
        (place,) = (x for x in sp.solve(sp.numer(sp.together(depth.diff(u))), u) if depth.diff(u, 2).subs(u, x) != 0
                    and (depth.diff(u, 2).subs(u, x) / sp.cos(alpha)).is_negative)  # fmt: skip
        return depth.subs(u, place)

    # --- integrals over the mass -------------------------------------------------------------------------

    @staticmethod
    def _integral(f: sp.Expr, low: sp.Expr, high: sp.Expr) -> sp.Expr:
        parts = (term.as_independent(r, theta) for term in sp.Add.make_args(sp.expand(f)))
        return sp.Add(*(c * sp.Integral(rest, (r, low, high), (theta, theta_1, theta_2)) for c, rest in parts))

    def body(self, f: sp.Expr) -> sp.Expr:
        """The double integral from the chord to the arc, constants outside."""
        return self._integral(f, dynamics.R * CHORD, dynamics.R)

    def body_star(self, f: sp.Expr, low: sp.Expr = CHORD) -> sp.Expr:
        """The same in r* = r/R."""
        return self._integral(f, low, sp.Integer(1))

    def scaled(self, f: sp.Expr) -> sp.Expr:
        """`body` after the substitution r = R r*."""
        return self.body_star(f.subs(r, dynamics.R * r) * dynamics.R)

    @cached_property
    def radial(self) -> sp.Expr:
        """R times the integral of sigma_n over the angle: (2.1) with (1.8), (1.11), (1.12), (2.3), (2.4), over ell."""
        weight, inertia = dynamics.rho * self.gravity()[0], dynamics.rho * self.rate(2)[0]
        pressure = self.reaction()[0].coeff(sp.Symbol("sigma_n"))
        return sp.expand((self.body(inertia * self.area) - self.body(weight * self.area)) / pressure)

    @cached_property
    def steps(self) -> dict[str, dynamics.Step]:
        """The derived equations of motion."""
        return dynamics.balance()

    def step(self, equation: str) -> sp.Expr:
        """Right-hand side of one of them, with (2.20) and (2.24) put in."""
        d, lever = dynamics, 2 * alpha * (1 - sp.cos(alpha))
        stress = self.steps["2.20"].right
        form = self.steps[equation].right.subs(sp.Symbol("sigma_star"), stress).subs(sp.Symbol("A"), d.polar / d.lam)
        return form.subs(d.lam, lever)

    @cached_property
    def mean(self) -> sp.Expr:
        """Mean normal stress, by (2.10), in dimensionless integrals."""
        d = dynamics
        omega = d.omega_star * sp.sqrt(d.g / d.R)
        return d.rho * (d.g * d.R**2 * d.j_r + omega**2 * d.R**3 * d.polar) / (2 * alpha * d.R)

    @property
    def lever(self) -> sp.Expr:
        """What mu sigma* is multiplied by, in (3.8) over ell rho g R^3."""
        d = dynamics
        resistance = -sp.expand(self.steps["3.8"].right).coeff(d.sigma_mean) / (d.ell * d.rho * d.g * d.R**3)
        return sp.simplify(resistance / d.mu * d.rho * d.g * d.R * (1 - sp.cos(alpha)))

    @cached_property
    def ways(self) -> dict[str, sp.Expr]:
        """The derived motion from rest, in a, b, t."""
        root = sp.sqrt(symbols.a * symbols.b)
        return {name: sp.simplify(way.subs(omega_0, 0)).subs(sp.Symbol("k", positive=True), root)
                for name, way in dynamics.solution().items()}  # fmt: skip

    @cached_property
    def way(self) -> dict[str, sp.Expr]:
        """The same in dimensions (2.21), (3.9), with c2 = sqrt(a b g/R), c0 = sqrt(a/b g/R) and c1 = R c0."""
        c0, c1, c2 = _RATE
        clock, a, b = sp.sqrt(dynamics.g / dynamics.R), symbols.a, symbols.b
        at = {t: t * clock, a: c0 * c2 / clock**2, b: c2 / c0}
        omega, phi = (self.ways[x].subs(at, simultaneous=True) for x in ("angular_velocity", "rotation"))
        omega, phi = (sp.simplify(x.subs(symbols.t, t)) for x in (clock * omega, phi))
        return {"omega": omega, "phi": phi, "v": (dynamics.R * omega).subs(c0, c1 / dynamics.R),
                "s": (dynamics.R * phi).subs(c0, c1 / dynamics.R)}  # fmt: skip

    @staticmethod
    def series(way: sp.Expr) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
        """A motion, the first term of its expansion in time, and the order of the second."""
        terms = sp.Add.make_args(sp.series(way, t, 0, 6).removeO())
        first, second = sorted(terms, key=lambda x: sp.degree(x, t))[:2]
        return way, first, sp.O(t ** sp.degree(second, t))

    @cached_property
    def names(self) -> dict[str, Any]:
        """The notation of the transcribed forms."""
        d = dynamics
        names: dict[str, Any] = {x: getattr(symbols, x) for x in ("alpha", "theta", "r", "u", "t", "a", "b")}
        names |= {x.name: x for x in (d.R, d.g, d.rho, d.ell, d.mu, d.j_r, d.j_theta, d.polar, d.omega_star,
                                      d.rate_star, d.sigma_mean, *_RATE, *_RATES)}  # fmt: skip
        gamma, f, lever = d.rho * d.g, d.R * (1 - sp.cos(alpha)), 2 * alpha * (1 - sp.cos(alpha))
        names |= {"theta_1": theta_1, "theta_2": theta_2, "Theta": d.theta_star, "lam": lever, "A": d.polar / lever}
        names |= {"gamma": gamma, "f": f, "sigma_ref": gamma * f, "phi": self.way["phi"]}
        names |= {"J_r0": self.derivations["radial_weight"].closed, "sigma": sp.Function("sigma")}
        names |= {"chord": CHORD, "body": self.body, "body_star": self.body_star}
        return names | {"omega_of": sp.Function("omega")}

    def read(self, forms: str) -> tuple[sp.Expr, ...]:
        """Transcribed forms, separated by semicolons."""
        return tuple(sp.parse_expr(x.strip(), local_dict=self.names) for x in forms.split(";"))

    # --- numbers -----------------------------------------------------------------------------------------

    @cached_property
    def derivations(self) -> dict[str, Derivation]:
        """Each moment's derivation; at the section its closed form equals quadrature of the raw definition."""
        found = {m.name: derive(m) for m in MOMENTS}
        for name, d in found.items():
            raw = quadrature(d.moment.weight, self.theta_1, self.alpha, 20)
            if abs(raw - self.value(d.closed)) > 1e-18:
                raise ProofError(f"{name}: closed form at the section", self.value(d.closed), raw)
        return found

    @property
    def theta_1(self) -> mp.mpf:
        """Polar angle of the section's first end."""
        return mp.radians(mp.mpf(SECTION["theta_10"]))

    @property
    def alpha(self) -> mp.mpf:
        """Half the opening angle of the section."""
        return (mp.radians(mp.mpf(SECTION["theta_20"])) - self.theta_1) / 2

    @staticmethod
    def degrees(name: str) -> mp.mpf:
        """An angle of the section in degrees."""
        return mp.mpf(SECTION[name])

    @property
    def depth(self) -> mp.mpf:
        """f/R (2.12)."""
        return self.value(self.deepest / dynamics.R)

    @property
    def psi(self) -> mp.mpf:
        """Dip of the section's chord."""
        return 3 * mp.pi / 2 - self.theta_1 - self.alpha

    @property
    def radius(self) -> mp.mpf:
        """R of the section."""
        return mp.mpf(SECTION["R"])

    def value(self, form: sp.Expr, angle: Any = None, psi: Any = None) -> mp.mpf:
        """A closed form at the section, or at another half angle or dip."""
        angle, psi = (self.alpha if angle is None else angle), (self.psi if psi is None else psi)
        return sp.lambdify((alpha, PSI, theta_m), form, "mpmath")(angle, psi, 3 * mp.pi / 2 - psi)

    def moment(self, name: str, angle: Any = None, psi: Any = None) -> mp.mpf:
        """One of `quantities.MOMENTS`."""
        return self.value(self.derivations[name].closed, angle, psi)

    def dynamic(self, angle: Any = None) -> mp.mpf:
        """A (2.24)."""
        return self.moment("polar_moment", angle) / self.factor(angle)

    def factor(self, angle: Any = None) -> mp.mpf:
        """lambda (3.14)."""
        return self.value(2 * alpha * self.deepest / dynamics.R, angle)

    @property
    def reference(self) -> mp.mpf:
        """sigma_ref (2.13), MPa."""
        return mp.mpf(SECTION["gamma"]) / 1000 * self.radius * self.factor() / (2 * self.alpha)

    @property
    def second_appendix(self) -> mp.mpf:
        """What Appendix II integrates, at the section."""
        return self.value(simplify_appendix(APPENDIX_II).expression)

    def coefficients(self, as_printed: bool = False, span: str = SPAN) -> dict[str, mp.mpf]:
        """c0, c1, c2 of (4.2), (4.4) and what is reached after a time; with the paper's slips, if asked for."""
        wide = 2 * self.alpha if as_printed else self.alpha
        drive = self.second_appendix if as_printed else self.moment("weight_moment")
        inertia, friction = self.moment("moment_of_inertia", wide), mp.tan(mp.radians(mp.mpf(SECTION["phi_res"])))
        a = (drive - self.moment("radial_weight") * friction) / inertia
        b = self.factor() * self.dynamic(wide) * friction / inertia
        clock = mp.sqrt(mp.mpf(GRAVITY) / self.radius)
        found = {"c0": mp.sqrt(a / b) * clock, "c1": mp.sqrt(a / b) * clock * self.radius, "c2": mp.sqrt(a * b) * clock}
        phase = found["c2"] * mp.mpf(span)
        return found | {"phi": found["c0"] / found["c2"] * mp.log(mp.cosh(phase)),
                        "omega*": found["c0"] * mp.tanh(phase) / clock}  # fmt: skip

    # --- what the paper's postulates cost, relative -----------------------------------------------------

    @property
    def limit_friction(self) -> mp.mpf:
        """mu_eq (3.21)."""
        return self.moment("weight_moment") / self.moment("radial_weight")

    @property
    def sensitivity(self) -> mp.mpf:
        """Change of the drive (3.17) if the residual friction is 1 % larger."""
        friction = mp.tan(mp.radians(mp.mpf(SECTION["phi_res"])))
        return -friction / (self.limit_friction - friction) / 100

    @property
    def vector_balance(self) -> mp.mpf:
        """Mean stress at rest by the balance of forces along the bisector over that of the scalar sum (2.1), less 1.

        Uniform stress pushes with 2 R sin(alpha) sigma, the shear is odd in u, the weight is that of the segment.
        """
        area = self.alpha - mp.sin(2 * self.alpha) / 2
        scalar = self.moment("radial_weight", psi=mp.mpf(0)) / (2 * self.alpha)
        return area / (2 * mp.sin(self.alpha)) / scalar - 1

    @property
    def centripetal(self) -> mp.mpf:
        """Centripetal over static stress at the end of the time span."""
        return self.dynamic() * self.coefficients()["omega*"] ** 2 * self.factor() / self.moment("radial_weight")

    def turned(self, name: str) -> mp.mpf:
        """Change of a moment over the rotation that the paper's own numbers reach in its time span."""
        return self.moment(name, psi=self.psi - self.coefficients(as_printed=True)["phi"]) / self.moment(name) - 1

    @property
    def falling(self) -> mp.mpf:
        """Change of sin(psi) over the same rotation."""
        return mp.sin(self.psi - self.coefficients(as_printed=True)["phi"]) / mp.sin(self.psi) - 1

    def column(self, u: Any) -> mp.mpf:
        """Normal stress over its mean if each radial column stood alone, at u = theta - theta_m."""
        weight = mp.cos(self.psi - u) * (1 - (mp.cos(self.alpha) / mp.cos(u)) ** 2) / 2
        return weight * 2 * self.alpha / self.moment("radial_weight")

    @property
    def peak(self) -> mp.mpf:
        """By how much the largest stress of such columns exceeds the mean."""
        return self.column(mp.findroot(lambda u: mp.diff(self.column, u), mp.mpf("0.01"))) - 1

    @property
    def uneven(self) -> mp.mpf:
        """Change of the friction force under such columns if mu falls from +10 to -10 % between the ends."""
        moment = mp.quad(lambda u: -u * self.column(u), [-self.alpha, 0, self.alpha])
        return moment / (10 * self.alpha) / (2 * self.alpha)


@cache
def context() -> Context:
    """The one context; nothing in it depends on a claim."""
    return Context()
