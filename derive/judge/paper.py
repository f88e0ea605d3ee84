"""What the paper claims, as data: 67 numbered equations, 16 table entries, two appendices and some of its sentences.

Nothing here says whether a claim holds. A claim has the printed text, its transcription, and how what it must equal
follows from what precedes it in the paper; `verify` walks the list and judges. Transcriptions are read in the
notation of `evidence.Context.names`: ``body(f)`` is the integral of f over the moving mass in r and theta,
``body_star`` the same in r*; a semicolon separates the parts of an equation.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import mpmath as mp
import sympy as sp

from derive.algebra.dynamics import R, ell, g, mu, omega_star, polar, rate_star, rho, sigma_mean, theta_star
from derive.algebra.integrate import PSI
from derive.declare.symbols import a, alpha, b, r, t, theta, theta_1, theta_2
from derive.judge.appendices import APPENDIX_I, APPENDIX_II, Appendix

if TYPE_CHECKING:
    from derive.judge.evidence import Context

VERDICTS = ("holds", "holds to the printed digits", "imprecise", "misprint", "wrong", "assumption",
            "not machine-checkable")  # fmt: skip

# The section: Table 2-1 in m, kN/m^3 and degrees, and the residual friction angle of section 4.
SECTION = {"R": "1492.6", "gamma": "20", "theta_10": "215.2", "theta_20": "276.9", "phi_res": "10"}
GRAVITY = "9.81"
TABLES = {"sigma_ref": "4.223", "2alpha": "61.7", "J_r": "0.0870"}  # printed numbers that imply others
SPAN = "30"  # seconds, the time that section 4 shows

DIMENSIONS = {
    "R": "L", "r": "L", "ell": "L", "g": "L/T**2", "rho": "M/L**3", "dV": "L**3", "omega": "1/T", "t": "T",
    "sigma_mean": "M/(L*T**2)", "c0": "1/T", "c1": "L/T", "c2": "1/T",
}  # fmt: skip


@dataclass(frozen=True)
class Cause:
    """Why a claim may fail, and the verdict this leads to if it is shown.

    For a number ``value`` is what the paper must have evaluated: it has to give the printed digits. For a form
    ``edit`` is a replacement in the transcription: afterwards the form has to hold.
    """

    words: str
    verdict: Literal["imprecise", "misprint", "wrong"]
    value: "Callable[[Context], mp.mpf] | None" = None
    edit: tuple[str, str] = ("", "")


@dataclass(frozen=True)
class Claim:
    """One claim of the paper.

    ``expression`` transcribes ``printed``; ``definition`` derives what it must equal; ``dimension`` and ``law`` are
    what else it has to satisfy. ``size`` is for what the paper postulates: the relative effect of the postulate.
    """

    id: str
    claim: str
    printed: str
    expression: str = ""
    definition: "Callable[[Context], Any]" = lambda c: ()
    kind: Literal["form", "number", "range", "appendix", "outside"] = "form"
    causes: tuple[Cause, ...] = ()
    shows: str = "{}"  # how the derived value is written
    note: str = ""  # remark if it holds
    dimension: str = ""
    law: Callable[[sp.Expr], Iterable[sp.Expr]] | None = None
    size: "Callable[[Context], mp.mpf] | None" = None
    subject: Appendix | None = None


def _implied(by: str, inverse: Callable[[mp.mpf], mp.mpf]) -> list[mp.mpf]:
    """What a printed number implies for another, up to one unit of its last place."""
    unit = mp.mpf(10) ** -len(by.partition(".")[2])
    return sorted(inverse(mp.mpf(by) + k * unit) for k in (-1, 1))


def _second_end(c: "Context", j_r: mp.mpf) -> mp.mpf:
    """theta_20 in degrees of an arc of this opening and this J_r."""
    return 270 - mp.degrees(mp.acos(j_r / c.moment("radial_weight", psi=mp.mpf(0))) - c.alpha)


_FULL = "evaluated at the full angle 2 alpha, not at alpha"
_SECOND = "J_theta from Appendix II, which integrates r(-cos theta)"
_FOLLOWS = "follows from Theta* and A at 2 alpha, J_theta of Appendix II"
_FULL_A = (Cause(f"(2.24) {_FULL}", "wrong", value=lambda c: c.dynamic(2 * c.alpha)),)
_LIMIT = (Cause("follows: Appendix II over Appendix I is tan(dip of the chord)", "wrong",
                value=lambda c: c.second_appendix / c.moment("radial_weight")),)  # fmt: skip
_LIMIT_ANGLE = (Cause("follows: with Appendix II it is the dip of the chord", "wrong",
                      value=lambda c: mp.degrees(mp.atan(c.second_appendix / c.moment("radial_weight")))),)  # fmt: skip


def _motion(name: str) -> tuple[Cause, ...]:
    return (Cause(_FOLLOWS, "wrong", value=lambda c: c.coefficients(as_printed=True)[name]),)


def _notation(words: str, old: str, new: str) -> tuple[Cause, ...]:
    return (Cause(f"notation: {words}", "imprecise", edit=(old, new)),)


def _reached(name: str) -> "Callable[[Context], mp.mpf]":
    return lambda c: c.coefficients()[name]


def _end(start: sp.Symbol) -> sp.Expr:
    """Polar angle of an end (1.2), with an integration variable of its own."""
    return start + sp.Integral(sp.Function("omega")(r), (r, 0, t))


_W = "body(-sin(theta)*r)"
_SIGMA_N, _TAU_N = sp.symbols("sigma_n tau_n")
_F, _LAMBDA = R * (1 - sp.cos(alpha)), 2 * alpha * (1 - sp.cos(alpha))
_SUM, _SLIP = "Integral(sigma(alpha), (alpha, 0, 2*alpha))", "integration variable that is also a limit"
_ONCE = ("sigma(alpha), (alpha", "sigma(u), (u")

CLAIMS = (
    Claim("(1.1)", "opening angle is constant", "2 alpha = theta_2 - theta_1 = const", "0",
          lambda c: sp.diff(_end(theta_2) - _end(theta_1), t), shows="d(theta_2 - theta_1)/dt = {}"),
    Claim("(1.2)", "angle of an end", "theta_i0 + int_0^t omega(t) dt", "theta_1 + Integral(omega_of(t), (t, 0, t))",
          lambda c: _end(theta_1), causes=_notation(_SLIP, "(t), (t", "(s), (s"),
          law=lambda e: [sp.diff(e, t) - sp.Function("omega")(t)]),
    Claim("(1.3)", "rotation and its rate", "omega = dphi/dt <=> phi = int omega dt", "diff(phi, t)",
          lambda c: c.way["omega"], shows="rate of the derived phi: {}", note="up to the constant phi(0)"),
    Claim("(1.4)", "position vector", "R_P = r e_r", "r; 0", lambda c: c.basis(r * sp.cos(theta), r * sp.sin(theta))),
    Claim("(1.5)", "velocity is tangential", "v_P = v_theta e_theta", "0; r*omega", lambda c: c.rate(1)),
    Claim("(1.6)", "acceleration", "a_P = a_r e_r + a_theta e_theta", "-r*omega**2; r*omega_dot", lambda c: c.rate(2)),
    Claim("(1.7)", "velocity", "v_theta = r omega", "r*omega", lambda c: c.rate(1)[1], dimension="L/T"),
    Claim("(1.8)", "radial acceleration", "a_r = -r omega^2", "-r*omega**2", lambda c: c.rate(2)[0],
          dimension="L/T**2"),
    Claim("(1.9)", "tangential acceleration", "a_theta = r domega/dt", "r*omega_dot", lambda c: c.rate(2)[1]),
    Claim("(1.10)", "weight of a point", "dW = dm g = rho dV g", "rho*dV*g", lambda c: c.read("gamma*dV")[0],
          dimension="M*L/T**2"),
    Claim("(1.11)", "gravity in polar components", "-g sin(theta) e_r - g cos(theta) e_theta",
          "-g*sin(theta); -g*cos(theta)", lambda c: c.gravity()),
    Claim("(1.12)", "normal reaction", "dN = -sigma_n dS e_r", "-sigma_n", lambda c: c.reaction()[0],
          shows="over dS: {}"),
    Claim("(1.13)", "tangential reaction", "dT = -tau_n dS e_theta", "-tau_n", lambda c: c.reaction()[1],
          shows="over dS: {}", note="while omega > 0"),
    Claim("(1.14)", "Coulomb friction", "tau_n = mu sigma_n, mu = tan(phi)", size=lambda c: c.sensitivity,
          shows="1 % more mu changes the drive a by {} at phi_res", note="a law of the material, postulated"),
    Claim("(2.1)", "radial balance", "int dW_r + int dN_r = int a_r dm", size=lambda c: c.vector_balance,
          shows="vector balance along the bisector: stress at rest larger by {}",
          note="closure: components of different directions added as scalars"),
    Claim("(2.2)", "its terms", "int rho g(-sin theta) dV + int(-sigma_n) dS = int rho(-r omega^2) dV",
          "-rho*g*sin(theta); -sigma_n; -rho*r*omega**2",
          lambda c: (rho * c.gravity()[0], c.reaction()[0], rho * c.rate(2)[0]),
          note="its domain (m) is the volume (V)"),
    Claim("(2.3)", "volume element", "dV = ell r dr dtheta", "ell*r", lambda c: ell * c.area,
          shows="over dr dtheta: {}"),
    Claim("(2.4)", "surface element", "dS = ell R dtheta", "ell*R", lambda c: ell * c.arc, shows="over dtheta: {}"),
    Claim("(2.5)", "radial balance, integrated", "R int sigma_n = rho g int int(-sin theta) r dr dtheta"
          " + rho omega^2 int int r^2 dr dtheta", f"rho*g*{_W} + rho*omega**2*body(r**2)", lambda c: c.radial),
    Claim("(2.6)", "chord in polar coordinates", "R_1 = R cos(alpha)/cos(theta - theta_1 - alpha)",
          "R*cos(alpha)/cos(theta - theta_1 - alpha)", lambda c: c.chord, dimension="L"),
    Claim("(2.7)", "(2.5) over rho g", "R/(rho g) int_0^{2 alpha} sigma_n dalpha = W + omega^2/g I_p",
          f"R/(rho*g)*{_SUM}; {_W} + omega**2/g*body(r**2)",
          lambda c: (R / (rho * g) * c.stress_sum, sp.expand(c.radial / (rho * g))), causes=_notation(_SLIP, *_ONCE)),
    Claim("(2.8)", "polar surface moment", "I_p = int int r^2 dr dtheta", "body(r**2)",
          lambda c: sp.expand(c.radial / rho).coeff(c.names["omega"], 2),
          note="a first moment of area, despite its name"),
    Claim("(2.9)", "mean of a uniform stress", "1/(2 alpha) int_0^{2 alpha} sigma_n dalpha", f"{_SUM}/(2*alpha)",
          lambda c: c.stress_sum / (2 * alpha), causes=_notation(_SLIP, *_ONCE), size=lambda c: c.peak,
          shows="if radial columns stood alone: 0 at the ends, up to {} above the mean inside",
          note="closure: the distribution is undetermined"),
    Claim("(2.10)", "(2.7) with the mean", "R/(rho g) 2 alpha sigma_n = W + omega^2/g I_p",
          f"{_W} + omega**2/g*body(r**2)", lambda c: sp.expand(c.radial / (rho * g))),
    Claim("(2.11)", "depth of the chord", "h = R (1 - cos(alpha)/cos(theta - theta_1 - alpha))",
          "R*(1 - cos(alpha)/cos(theta - theta_1 - alpha))", lambda c: R - c.chord, dimension="L"),
    Claim("(2.12)", "largest depth", "f = R (1 - cos(alpha))", "R*(1 - cos(alpha))", lambda c: c.deepest),
    Claim("(2.13)", "reference stress", "sigma_ref = rho g f", "rho*g*f", lambda c: rho * g * R * _LAMBDA / (2 * alpha),
          shows="what (3.14) needs: {}", dimension="M/(L*T**2)"),
    Claim("(2.14)", "radius over R", "r* = r/R", "r/R", lambda c: sp.solve(sp.Eq(r, R * theta), theta)[0],
          dimension="1"),
    Claim("(2.15)", "stress over sigma_ref", "sigma_n/sigma_ref", "sigma_mean/sigma_ref",
          lambda c: sp.simplify(sigma_mean * c.step("2.20") / c.mean), shows="from (2.10), (2.20): {}", dimension="1"),
    Claim("(2.16)", "polar moment, scaled", "I_p = R^3 I_p*", "R**3*body_star(r**2)", lambda c: c.scaled(r**2)),
    Claim("(2.17)", "polar moment, dimensionless", "int int_{R_1*}^1 r*^2 dr* dtheta", "body_star(r**2)",
          lambda c: c.scaled(r**2) / R**3),
    Claim("(2.18)", "chord over R", "R_1* = cos(alpha)/cos(theta - theta_1 - alpha)",
          "cos(alpha)/cos(theta - theta_1 - alpha)", lambda c: c.chord / R),
    Claim("(2.19)", "polar moment, closed form", "(2 alpha - sin(2 alpha)/2 - ln|tan(pi/4 + alpha/2)| cos(alpha)^3)/3",
          "(2*alpha - sin(2*alpha)/2 - log(Abs(tan(pi/4 + alpha/2)))*cos(alpha)**3)/3",
          lambda c: c.derivations["polar_moment"].amplitude),
    Claim("(2.20)", "mean normal stress", "sigma_st* + A omega*^2", "J_r/lam + A*omega_star**2",
          lambda c: c.step("2.20")),
    Claim("(2.21)", "angular velocity, scaled", "omega* = omega/sqrt(g/R)", "omega/sqrt(g/R)",
          lambda c: c.names["omega"] * sp.sqrt(R**2 * rho * polar / (2 * alpha * rho * g * _F) / (polar / _LAMBDA)),
          shows="what makes (2.10) into (2.20): {}", dimension="1"),
    Claim("(2.22)", "static stress", "J_r/(2 alpha (1 - cos(alpha)))", "J_r/(2*alpha*(1 - cos(alpha)))",
          lambda c: c.step("2.20").subs(omega_star, 0)),
    Claim("(2.23)", "radial weight", "J_r = int int_{r_1*}^1 r*(-sin theta) dr* dtheta",
          "body_star(-r*sin(theta), r_1)", lambda c: c.scaled(-sp.sin(theta) * r) / R**2,
          causes=_notation("its limit r_1* is R_1* of (2.18)", "r_1", "chord")),
    Claim("(2.24)", "dynamic coefficient", "A = I_p*/(2 alpha (1 - cos(alpha)))", "I_p/(2*alpha*(1 - cos(alpha)))",
          lambda c: c.step("3.18") * theta_star / (mu * _LAMBDA)),
    Claim("Fig. 2-2", "A is of order one", "A(alpha) = O(1)", "1/10; 10",
          lambda c: [c.dynamic(x) for x in (mp.mpf("1e-5"), c.alpha, mp.pi / 2 - mp.mpf("1e-9"))], "range",
          shows="{} at alpha -> 0, {} here, {} at pi/2"),
    Claim("(2.25)", "centripetal stress neglected", "sigma* = sigma_st*", "J_r/lam",
          lambda c: c.step("2.20").subs(omega_star, 0), size=lambda c: c.centripetal,
          shows="neglects {} of the static stress after 30 s of (3.20)", note="for slow rotation"),
    Claim("(2.26)", "J_r frozen", "sigma* = sigma_0* + A omega*^2", "J_r/lam + A*omega_star**2",
          lambda c: c.step("2.20"),
          size=lambda c: c.turned("radial_weight"), shows="J_r changes by {} over the paper's rotation in 30 s",
          note="J_r turns with the mass"),
    Claim("(2.27)", "static stress at the start", "J_r(theta_10, theta_20)/(2 alpha (1 - cos(alpha)))", "J_r0/lam",
          lambda c: c.derivations["radial_weight"].closed.subs(PSI, PSI - t).subs(t, 0) / _LAMBDA,
          shows="at phi = 0: {}"),
    Claim("Table 2-1 R", "radius, m", SECTION["R"], kind="number", shows="sigma_ref and gamma imply {}",
          definition=lambda c: _implied(TABLES["sigma_ref"], lambda s: s * 1000 / mp.mpf(SECTION["gamma"]) / c.depth)),
    Claim("Table 2-1 gamma", "unit weight, kN/m^3", SECTION["gamma"], kind="number", shows="sigma_ref and R imply {}",
          definition=lambda c: _implied(TABLES["sigma_ref"], lambda s: s * 1000 / c.radius / c.depth)),
    Claim("Table 2-1 theta_10", "first end, degrees", SECTION["theta_10"], kind="number",
          shows="2 alpha and theta_20 imply {}",
          definition=lambda c: _implied(TABLES["2alpha"], lambda x: c.degrees("theta_20") - x)),
    Claim("Table 2-1 theta_20", "second end, degrees", SECTION["theta_20"], kind="number",
          shows="2 alpha and J_r imply {}", definition=lambda c: _implied(TABLES["J_r"], lambda x: _second_end(c, x))),
    Claim("Table 2-1 2alpha", "opening angle, degrees", TABLES["2alpha"], kind="number",
          definition=lambda c: c.degrees("theta_20") - c.degrees("theta_10")),
    Claim("Table 2-1 I_p", "polar moment, km^3", "0.308", kind="number",
          definition=lambda c: c.moment("polar_moment") * (c.radius / 1000) ** 3),
    Claim("Table 2-1 sigma_ref", "reference stress, MPa", TABLES["sigma_ref"], kind="number",
          definition=lambda c: c.reference),
    Claim("Table 2-1 sigma_n0", "mean stress at rest, MPa", "2.413", kind="number",
          definition=lambda c: c.reference * c.moment("radial_weight") / c.factor()),
    Claim("Table 2-1 A", "dynamic coefficient", "0.468", kind="number", definition=lambda c: c.dynamic(),
          causes=_FULL_A),
    Claim("Fig. 2-3", "J_r within 10 %", "practically constant", "-1/10; 1/10", lambda c: [c.turned("radial_weight")],
          "range", shows="changes by {} of it over the paper's rotation in 30 s"),
    Claim("(3.1)", "moment of inertia", "Theta = ell rho int int r^3 dr dtheta", "ell*rho*body(r**3)",
          lambda c: ell * rho * c.body(r**2 * c.area)),
    Claim("(3.2)", "angular momentum", "Theta domega/dt = M", "ell*rho*body(r**3)*omega_dot",
          lambda c: sp.expand(ell * rho * c.body(c.moment_of(r, c.rate(2)) * c.area)), shows="its rate: {}"),
    Claim("(3.3)", "moments about K", "int r dW_theta - int R dT", "r*dW_theta; -R*dT",
          lambda c: (c.moment_of(r, sp.symbols("dW_r dW_theta")), c.moment_of(R, (-sp.Symbol("dN"), -sp.Symbol("dT")))),
          note="dT is the magnitude; dN has no moment"),
    Claim("(3.4)", "moments, written out", "int r rho g(-cos theta) dV - R int mu sigma_n dS",
          "-r*rho*g*cos(theta); -R*mu*sigma_n",
          lambda c: (c.moment_of(r, c.gravity()) * rho, c.moment_of(R, c.reaction()).subs(_TAU_N, mu * _SIGMA_N))),
    Claim("(3.5)", "friction force", "mu(t) sigma_n ell R 2 alpha", "mu*sigma_mean*ell*R*2*alpha",
          lambda c: sp.integrate(mu * sigma_mean * ell * c.arc, (theta, theta_1, theta_1 + 2 * alpha)),
          size=lambda c: c.uneven,
          shows="{} if mu falls linearly by 20 % along the arc and columns stand alone",
          note="uniform mu; any distribution of the stress then does, so uniform stress is not needed"),
    Claim("(3.6)", "mean stress", "sigma_ref (sigma_st* + A omega*^2)", "sigma_ref*(J_r/lam + A*omega_star**2)",
          lambda c: c.mean, dimension="M/(L*T**2)"),
    Claim("(3.7)", "moment of the weight", "ell rho g int int r^2(-cos theta) dr dtheta",
          "ell*rho*g*body(-r**2*cos(theta))", lambda c: ell * rho * c.body(c.moment_of(r, c.gravity()) * c.area)),
    Claim("(3.8)", "angular momentum, written out", "int int r^3 domega/dt = g int int r^2(-cos theta)"
          " - R^2 g/gamma 2 alpha mu sigma_n",
          "R**4*Theta*g/R*rate_star; g*R**3*J_theta - R**2*g/gamma*2*alpha*mu*sigma_mean",
          lambda c: tuple(sp.expand(x / (ell * rho)) for x in (c.steps["3.8"].left, c.steps["3.8"].right))),
    Claim("(3.9)", "time factor", "t_c = sqrt(R/g)", "sqrt(R/g)", lambda c: 1 / sp.sqrt(g / R), dimension="T"),
    Claim("(3.10)", "angular acceleration", "domega/dt = g/R domega*/dt*", "g/R*rate_star",
          lambda c: sp.diff(rate_star * (t * sp.sqrt(g / R)) * sp.sqrt(g / R), t)),
    Claim("(3.11)", "equation of motion", "Theta* domega*/dt* = J_theta - lam (sigma_0* + A omega*^2) mu",
          "J_theta - lam*(J_r/lam + A*omega_star**2)*mu", lambda c: sp.simplify(c.step("3.11")),
          note="with J_r frozen (2.26)"),
    Claim("(3.12)", "moment of inertia, dimensionless", "int int_{R_1*}^1 r*^3 dr* dtheta", "body_star(r**3)",
          lambda c: c.scaled(r**3) / R**4),
    Claim("(3.13)", "moment of the weight, dimensionless", "int int_{R_1*}^1 r*^2(-cos theta) dr* dtheta",
          "body_star(-r**2*cos(theta))", lambda c: c.scaled(c.moment_of(r, c.gravity()) * c.area) / (g * R**3)),
    Claim("(3.14)", "lever of the resistance",
          "lam = 2 alpha sigma_ref/(gamma R) = 2 alpha f/R = 2 alpha (1 - cos(alpha))",
          "2*alpha*sigma_ref/(gamma*R); 2*alpha*f/R; 2*alpha*(1 - cos(alpha))", lambda c: (c.lever,) * 3,
          shows="coefficient of mu sigma*: {}"),
    Claim("(3.15)", "moment of inertia, closed form", "(alpha - sin(2 alpha) (1 + 2 cos(alpha)^2)/6)/2",
          "(alpha - sin(2*alpha)*(1 + 2*cos(alpha)**2)/6)/2", lambda c: c.derivations["moment_of_inertia"].amplitude),
    Claim("Fig. 3-2", "J_theta within 10 %", "practically constant", "-1/10; 1/10",
          lambda c: [c.turned("weight_moment")], "range", shows="changes by {} of it over the paper's rotation in 30 s",
          causes=(Cause("J_theta falls like sin(psi), and psi by the rotation", "wrong", value=lambda c: c.falling),)),
    Claim("(3.16)", "equation of motion, short", "domega*/dt* = a - b omega*^2", "a - b*omega_star**2",
          lambda c: c.step("3.16")),
    Claim("(3.17)", "drive", "a = (J_theta - J_r0 mu)/Theta*", "(J_theta - J_r*mu)/Theta",
          lambda c: sp.expand(c.step("3.17")), note="J_theta frozen as well"),
    Claim("(3.18)", "brake", "b = lam A mu/Theta*", "lam*A*mu/Theta", lambda c: c.step("3.18"),
          shows="{}, lam A = I_p*"),
    Claim("(3.19)", "starts from rest", "omega*(0) = 0", "0", lambda c: c.ways["angular_velocity"].subs(t, 0),
          shows="derived motion: omega*(0) = {}"),
    Claim("(3.20)", "solution", "sqrt(a/b) tanh(sqrt(a b t*))", "sqrt(a/b)*tanh(sqrt(a*b*t))",
          lambda c: c.ways["angular_velocity"], shows="{}, for constant mu",
          law=lambda e: [sp.diff(e, t) - (a - b * e**2), e.subs(t, 0)],
          causes=(Cause("t* belongs outside the root (print or scan)", "misprint",
                        edit=("sqrt(a*b*t)", "sqrt(a*b)*t")),)),
    Claim("(3.21)", "limit friction", "mu_eq = J_theta0/J_r0", "J_theta/J_r", lambda c: c.step("3.21"),
          note="omega* = 0 for all times, not at one"),
    Claim("Sect. 3 density", "motion independent of density", "a, b without rho", "0; 0",
          lambda c: tuple(sp.diff(c.step(x), rho) for x in ("3.17", "3.18")), shows="da/drho; db/drho = {}"),
    Claim("(4.1)", "limit friction", "0.44", kind="number", causes=_LIMIT,
          definition=lambda c: c.limit_friction),
    Claim("Sect. 4 phi_eq", "limit friction angle, degrees", "24", kind="number",
          definition=lambda c: mp.degrees(mp.atan(c.limit_friction)),
          causes=_LIMIT_ANGLE),
    Claim("Sect. 4 phi_res", "residual friction angle, degrees", SECTION["phi_res"], kind="outside",
          note="measured in ring-shear tests; nothing here determines it"),
    Claim("Table 4-1 Theta*", "moment of inertia", "0.4376", kind="number",
          definition=lambda c: c.moment("moment_of_inertia"),
          causes=(Cause(f"(3.15) {_FULL}", "wrong", value=lambda c: c.moment("moment_of_inertia", 2 * c.alpha)),)),
    Claim("Table 4-1 J_r", "radial weight", TABLES["J_r"], kind="number",
          definition=lambda c: c.moment("radial_weight")),
    Claim("Table 4-1 J_theta", "moment of the weight", "0.0387", kind="number",
          definition=lambda c: c.moment("weight_moment"),
          causes=(Cause(_SECOND, "wrong", value=lambda c: c.second_appendix),)),
    Claim("Table 4-1 lambda", "lever of the resistance", "0.1523", kind="number", definition=lambda c: c.factor()),
    Claim("Table 4-1 sigma*_n0", "mean stress at rest", "0.5713", kind="number",
          definition=lambda c: c.moment("radial_weight") / c.factor()),
    Claim("Table 4-1 A", "dynamic coefficient", "0.468", kind="number", definition=lambda c: c.dynamic(),
          causes=_FULL_A),
    Claim("Table 4-1 phi_C,eq", "limit friction angle, degrees", "24", kind="number",
          definition=lambda c: mp.degrees(mp.atan(c.limit_friction)),
          causes=_LIMIT_ANGLE),
    Claim("(4.2)", "angular velocity", "omega = c0 tanh(c2 t)", "c0*tanh(c2*t)", lambda c: c.way["omega"],
          dimension="1/T"),
    *(Claim(f"{where} {name}", words, digits, kind="number", definition=_reached(name), causes=_motion(name))
      for where, name, words, digits in (("(4.2)", "c0", "largest angular velocity, 1/s", "0.1104"),
                                         ("(4.2)", "c2", "rate of approach, 1/s", "0.00317"))),
    Claim("(4.3)", "rotation", "phi = c0/c2 ln(cosh(c2 t))", "c0/c2*log(cosh(c2*t))", lambda c: c.way["phi"],
          dimension="1"),
    Claim("(4.4)", "velocity", "c1 tanh(c2 t) = c1 (c2 t + O((c2 t)^2))", "c1*tanh(c2*t); c1*c2*t; O(t**2)",
          lambda c: c.series(c.way["v"]), dimension="L/T",
          causes=(Cause("true but not sharp: tanh is odd", "imprecise", edit=("O(t**2)", "O(t**3)")),)),
    Claim("(4.4) c1", "largest velocity, m/s", "165", kind="number", definition=_reached("c1"), causes=_motion("c1")),
    Claim("(4.5)", "displacement", "c1 ln cosh(c2 t) = c1 ((c2 t)^2/2 + O((c2 t)^4))",
          "c1*log(cosh(c2*t)); c1*(c2*t)**2/2; O(t**4)", lambda c: c.series(c.way["s"]), dimension="L",
          causes=(Cause("c1/c2, not c1: it has to be a length, and its rate the velocity", "misprint",
                        edit=("c1*", "c1/c2*")),)),
    Claim("Appendix I", "antiderivative of (2.23)", "J_r(alpha) := ...", "-r*sin(theta)", kind="appendix",
          subject=APPENDIX_I),
    Claim("Appendix II", "antiderivative of (3.13)", "J(alpha) := ...", "-r**2*cos(theta)", kind="appendix",
          subject=APPENDIX_II),
)  # fmt: skip
