"""Claims of the paper as data: 67 numbered equations, 16 table entries, two appendices, sentences and figures.

The module does not state whether a claim is correct. A claim consists of the printed text, its transcription, and the
derivation of the form that it must equal from earlier parts of the paper. `verify` judges all claims. Transcriptions
use the notation of `mechanics.names`: ``body(f)`` is the integral of f over the moving mass in r and theta,
``body_star`` the same in r*. J_r and J_theta turn with the mass, and J_r0 and J_theta0 are their initial values. A
semicolon separates the parts of an equation.
"""

from collections.abc import Callable
from typing import Any

import mpmath as mp
from sympy import Eq, Symbol, cos, diff, expand, simplify, sin, solve, sqrt, symbols

from derive.algebra.appendices import APPENDIX_I, APPENDIX_II
from derive.algebra.dynamics import R, ell, g, mu, omega_star, polar, rate_star, rho, sigma_mean, solution, theta_star
from derive.declare.quantities import PRINTED
from derive.declare.symbols import alpha, omega_0, r, t, theta, theta_1, theta_2
from derive.judge import postulates
from derive.judge import section as s
from derive.judge.claims import DOMAINS, Cause, Claim
from derive.judge.mechanics import (
    ARC,
    AREA,
    DEPTH,
    GRAVITY,
    LEVER,
    STRESS_SUM,
    a_of,
    along_bisector,
    b_of,
    basis,
    body,
    chord,
    deepest,
    derived_form,
    dimensional,
    end_angle,
    expanded_in_time,
    lever,
    moment_of,
    momentum,
    motion,
    mu_of,
    omega,
    omega_dot,
    parse_forms,
    planar,
    radial,
    rate,
    reaction,
    scaled_body,
    sigma,
    sigma_n,
    tau_n,
    turn,
)
from derive.judge.section import (
    GIVEN,
    HALF,
    IMPLYING,
    both_results,
    change_by_rotation,
    depth,
    dynamic,
    factor,
    friction_degrees,
    implied,
    limit_friction,
    moment,
    moment_derivation,
    reached,
    reference,
    second_appendix,
    second_end,
)

_FULL = "evaluated at 2 alpha instead of alpha"
_FULL_A = Cause(f"(2.24) {_FULL}", "wrong", lambda: dynamic(2 * HALF))
_LIMIT_ANGLE = Cause(
    "follows from Appendix II: the dip of the chord", "wrong", lambda: friction_degrees(limit_friction(as_printed=True))
)
_ROTATIONS = "relative change {} at a rotation of 1 degree, {} at 2, {} at 5, {} at 9.02 (the paper's own after 30 s)"
_SUM = ("radial components added as scalars (2.1)",)
_MEAN = (*_SUM, "mean stress (2.9)")
_MOTION = (*_MEAN, "Coulomb friction, one coefficient (1.14)")
_SOLVED = ("J_r, J_theta and friction constant", "from rest (3.19)")
_ARC = (("alpha", *DOMAINS["alpha"]),)
_DIPS = ("complex arithmetic, for dips from 0 to pi",)
_EXAMPLE = (*_SOLVED, f"g = {s.GRAVITY} m/s^2")


def _number(id: str, claim: str, digits: str, value: Callable[[], Any], *causes: Cause, **rest: Any) -> Claim:
    """Return the claim of a printed number, the text ``digits``, with the function of its value and possible causes."""
    return Claim(id, claim, digits, definition=value, kind="number", causes=causes, **rest)


def _reached(id: str, claim: str, digits: str) -> Claim:
    """Return the claim of a number that `reached` computes; the last two characters of ``id`` are its name."""
    name = id[-2:]
    words = "follows from the wrong Theta*, A and J_theta"
    cause = Cause(words, "wrong", lambda: reached(name, as_printed=True))
    return _number(id, claim, digits, lambda: reached(name), cause, given=_EXAMPLE)


def _figure(id: str, claim: str, shows: str, values: Callable[[], list[mp.mpf]], remark: str) -> Claim:
    """Return the claim of a figure, which cannot be checked; ``shows`` is the format of the values."""
    return Claim(id, claim, "a curve", definition=values, shows=shows, remark=f"the picture is lost; {remark}")


def _over_angle(name: str) -> Callable[[], list[mp.mpf]]:
    """Return the function that computes a moment for half the opening angle and for all of it."""
    return lambda: [moment(name), moment(name, 2 * HALF)]


def _notation(words: str, old: str, new: str) -> tuple[Cause, ...]:
    """Return the cause of an imprecise form: the notation ``old``, which has to be ``new``."""
    return (Cause(f"notation: {words}", "imprecise", edit=(old, new)),)


_W = "body(-sin(theta)*r)"
_STRESS = "Integral(sigma(alpha), (alpha, 0, 2*alpha))"
_SLIP = "integration variable that is also a limit"
_ONCE = ("sigma(alpha), (alpha", "sigma(u), (u")
_DOMAIN = {name: Symbol(f"over_{name}") for name in "VS"}  # of integration

CLAIMS = (
    Claim("Sect. 1 initial", "range of the rigid rotation", "acceptable only for the initial phase",
          definition=lambda: [mp.degrees(x) for x in both_results("phi")],
          shows="rotation after 30 s: {} degrees with the paper's slips, {} corrected",
          remark="a limit without a number; the deformation of the mass is outside the model"),
    Claim("(1.1)", "opening angle", "2 alpha = theta_2 - theta_1 = const", "0",
          lambda: diff(end_angle(theta_2) - end_angle(theta_1), t), shows="d(theta_2 - theta_1)/dt = {}",
          unit="1/s",
          given=("rigid body",)),
    Claim("(1.2)", "angle of an end", "theta_i0 + int_0^t omega(t) dt", "theta_1 + Integral(omega_of(t), (t, 0, t))",
          lambda: end_angle(theta_1), causes=_notation(_SLIP, "(t), (t", "(s), (s"),
          given=("rigid body",)),
    Claim("(1.3)", "rotation, by its rate", "phi = int omega dt <=> omega = dphi/dt", "diff(phi, t)",
          lambda: dimensional()["omega"], shows="rate of the derived phi: {}",
          remark="up to the constant phi(0)",
          unit="1/s"),
    Claim("(1.4)", "position vector", "R_P = r e_r", "r; 0", lambda: basis(r * cos(theta), r * sin(theta)), unit="m"),
    Claim("(1.5)", "velocity is tangential", "v_P = v_theta e_theta", "0; r*omega", lambda: rate(1)),
    Claim("(1.6)", "acceleration", "a_P = a_r e_r + a_theta e_theta", "-r*omega**2; r*omega_dot", lambda: rate(2)),
    Claim("(1.7)", "velocity", "v_theta = r omega", "r*omega", lambda: rate(1)[1]),
    Claim("(1.8)", "radial acceleration", "a_r = -r omega^2", "-r*omega**2", lambda: rate(2)[0]),
    Claim("(1.9)", "tangential acceleration", "a_theta = r domega/dt", "r*omega_dot", lambda: rate(2)[1]),
    Claim("(1.10)", "weight of a point", "dW = dm g = rho dV g", "rho*dV*g", lambda: parse_forms("gamma*dV")[0],
          unit="N",
          given=("dry mass, gravity alone",)),
    Claim("(1.11)", "gravity in polar components", "-g sin(theta) e_r - g cos(theta) e_theta",
          "-g*sin(theta); -g*cos(theta)", lambda: GRAVITY),
    Claim("(1.12)", "normal reaction", "dN = -sigma_n dS e_r", "-sigma_n", lambda: reaction()[0],
          shows="over dS: {}",
          unit="Pa"),
    Claim("(1.13)", "tangential reaction", "dT = -tau_n dS e_theta", "-tau_n", lambda: reaction()[1],
          shows="over dS: {}",
          unit="Pa"),
    Claim("(1.14)", "Coulomb friction", "tau_n = mu sigma_n, mu = tan(phi)", "mu*sigma_n", lambda: tau_n,
          shows="(1.1) to (1.13) leave it open: {}"),
    Claim("(2.1)", "radial balance", "int dW_r + int dN_r = int a_r dm", "dW_r + dN_r - dm*a_r",
          lambda: along_bisector(symbols("dW_r dW_theta")) + along_bisector(symbols("dN_r dT_theta"))
          - Symbol("dm") * along_bisector(symbols("a_r a_theta")), shows="along the bisector: {}"),
    Claim("(2.2)", "its terms", "int_V rho g(-sin theta) dV + int_S (-sigma_n) dS = int_m rho(-r omega^2) dV",
          "-rho*g*sin(theta)*over_V; -sigma_n*over_S; -rho*r*omega**2*over_m",
          lambda: (rho * GRAVITY[0] * _DOMAIN["V"], reaction()[0] * _DOMAIN["S"], rho * rate(2)[0] * _DOMAIN["V"]),
          causes=_notation("its domain (m) is the volume (V)", "over_m", "over_V"),
          given=_SUM),
    Claim("(2.3)", "volume element", "dV = ell r dr dtheta", "ell*r", lambda: ell * AREA, shows="over dr dtheta: {}"),
    Claim("(2.4)", "surface element", "dS = ell R dtheta", "ell*R", lambda: ell * ARC, shows="over dtheta: {}"),
    Claim("(2.5)", "radial balance, integrated", "R int sigma_n = rho g int int(-sin theta) r dr dtheta"
          " + rho omega^2 int int r^2 dr dtheta", f"rho*g*{_W} + rho*omega**2*body(r**2)", radial,
          given=_SUM),
    Claim("(2.6)", "chord in polar coordinates", "R_1 = R cos(alpha)/cos(theta - theta_1 - alpha)",
          "R*cos(alpha)/cos(theta - theta_1 - alpha)", chord),
    Claim("(2.7)", "(2.5) over rho g", "R/(rho g) int_0^{2 alpha} sigma_n dalpha = W + omega^2/g I_p",
          f"R/(rho*g)*{_STRESS}; {_W} + omega**2/g*body(r**2)",
          lambda: (R / (rho * g) * STRESS_SUM, expand(radial() / (rho * g))), causes=_notation(_SLIP, *_ONCE),
          given=_SUM),
    Claim("(2.8)", "polar surface moment", "I_p = int int r^2 dr dtheta", "body(r**2)",
          lambda: expand(radial() / rho).coeff(omega, 2), remark="a first moment of area, despite its name"),
    Claim("(2.9)", "uniform stress, and its mean", "sigma_n = 1/(2 alpha) int_0^{2 alpha} sigma_n dalpha",
          f"sigma_mean; {_STRESS}/(2*alpha)", lambda: (sigma(theta), STRESS_SUM / (2 * alpha)),
          causes=_notation(_SLIP, *_ONCE)),
    Claim("(2.10)", "(2.7) with the mean", "R/(rho g) 2 alpha sigma_n = W + omega^2/g I_p",
          f"{_W} + omega**2/g*body(r**2)", lambda: expand(radial() / (rho * g)),
          given=_MEAN),
    Claim("(2.11)", "depth of the chord", "h = R (1 - cos(alpha)/cos(theta - theta_1 - alpha))",
          "R*(1 - cos(alpha)/cos(theta - theta_1 - alpha))", lambda: R - chord(),
          unit="m"),
    Claim("(2.12)", "largest depth", "f = R (1 - cos(alpha))", "R*(1 - cos(alpha))", deepest),
    Claim("(2.13)", "reference stress", "sigma_ref = rho g f", "rho*g*f", lambda: rho * g * R * LEVER / (2 * alpha),
          shows="what (3.14) needs: {}",
          unit="Pa"),
    Claim("(2.14)", "radius over R", "r* = r/R", "r/R", lambda: solve(Eq(r, R * theta), theta)[0],
          shows="what (2.16) needs: {}",
          unit="1"),
    Claim("(2.15)", "stress over sigma_ref", "sigma_n* = sigma_n/sigma_ref", "sigma_mean/sigma_ref",
          lambda: simplify(sigma_mean * derived_form("2.20") / derived_form("2.10")),
          shows="from (2.10), (2.20): {}",
          unit="1"),
    Claim("(2.16)", "polar moment, scaled", "I_p = R^3 I_p*", "R**3*body_star(r**2)", lambda: scaled_body(r**2)),
    Claim("(2.17)", "polar moment, dimensionless", "int int_{R_1*}^1 r*^2 dr* dtheta", "body_star(r**2)",
          lambda: scaled_body(r**2) / R**3),
    Claim("(2.18)", "chord over R", "R_1* = cos(alpha)/cos(theta - theta_1 - alpha)",
          "cos(alpha)/cos(theta - theta_1 - alpha)", lambda: chord() / R),
    Claim("(2.19)", "polar moment, closed form", "(2 alpha - sin(2 alpha)/2 - ln|tan(pi/4 + alpha/2)| cos(alpha)^3)/3",
          PRINTED["polar_moment"], lambda: moment_derivation("polar_moment").amplitude, weight=r**2),
    _figure("Fig. 2-1", "polar moment over alpha", "I_p* = {} here, {} at 2 alpha", _over_angle("polar_moment"),
            "its curve is (2.19)"),
    Claim("(2.20)", "mean normal stress", "sigma_st* + A omega*^2", "J_r/lam + A*omega_star**2",
          lambda: derived_form("2.20"),
          given=_MEAN),
    Claim("(2.21)", "angular velocity, scaled", "omega* = omega/sqrt(g/R)", "omega/sqrt(g/R)",
          lambda: omega * sqrt(R**2 * rho * polar / (2 * alpha * rho * g * DEPTH) / (polar / LEVER)),
          shows="what makes (2.10) into (2.20): {}"),
    Claim("(2.22)", "static stress", "J_r/(2 alpha (1 - cos(alpha)))", "J_r/(2*alpha*(1 - cos(alpha)))",
          lambda: derived_form("2.20").subs(omega_star, 0),
          given=_MEAN),
    Claim("(2.23)", "radial weight", "J_r = int int_{r_1*}^1 r*(-sin theta) dr* dtheta",
          "body_star(-r*sin(theta), r_1)", lambda: scaled_body(-sin(theta) * r) / R**2,
          causes=_notation("its limit r_1* is R_1* of (2.18)", "r_1", "chord")),
    Claim("(2.24)", "dynamic coefficient", "A = I_p*/(2 alpha (1 - cos(alpha)))", "I_p/(2*alpha*(1 - cos(alpha)))",
          lambda: derived_form("3.18") * theta_star / (mu * LEVER)),
    Claim("Fig. 2-2", "A is of order one", "A(alpha) = O(1)", "1/10; 10",
          lambda: [dynamic(x) for x in (mp.mpf("1e-5"), HALF, mp.pi / 2 - mp.mpf("1e-9"))], "range",
          shows="{} at alpha -> 0, {} here, {} at pi/2"),
    Claim("(2.25)", "static equilibrium", "sigma* = sigma_st*", "J_r/lam", lambda: derived_form("2.20"), given=_MEAN),
    Claim("Sect. 2 planar", "normal acceleration on a planar surface", "negligible, as for small omega", "O(omega**2)",
          planar, shows="acceleration normal to a plane: {}",
          causes=(Cause("true for another reason: on a plane it is zero at every velocity", "imprecise",
                        edit=("O(omega**2)", "0")),)),
    Claim("(2.26)", "stress, of the start", "sigma* = sigma_0* + A omega*^2", "J_r0/lam + A*omega_star**2",
          lambda: derived_form("2.20"),
          given=_MEAN),
    Claim("(2.27)", "static stress at the start", "J_r(theta_10, theta_20)/(2 alpha (1 - cos(alpha)))", "J_r0/lam",
          lambda: derived_form("2.20").subs({omega_star: 0, turn: 0}), shows="at phi = 0: {}",
          given=_MEAN),
    _number("Table 2-1 R", "radius, m", GIVEN["R"], shows="sigma_ref and gamma imply {}",
            value=lambda: implied("sigma_ref", lambda x: s.given("R") * x / reference())),
    _number("Table 2-1 gamma", "unit weight, kN/m^3", GIVEN["gamma"], shows="sigma_ref and R imply {}",
            value=lambda: implied("sigma_ref", lambda x: s.given("gamma") * x / reference())),
    _number("Table 2-1 theta_10", "first end, degrees", GIVEN["theta_10"], shows="2 alpha and theta_20 imply {}",
            value=lambda: implied("2alpha", lambda x: s.given("theta_20") - x)),
    _number("Table 2-1 theta_20", "second end, degrees", GIVEN["theta_20"], shows="2 alpha and J_r imply {}",
            value=lambda: implied("J_r", second_end)),
    _number("Table 2-1 2alpha", "opening angle, degrees", IMPLYING["2alpha"],
            lambda: s.given("theta_20") - s.given("theta_10")),
    _number("Table 2-1 I_p", "polar moment, km^3", "0.308",
            lambda: moment("polar_moment") * (s.given("R") / 1000) ** 3),
    _number("Table 2-1 sigma_ref", "reference stress, MPa", IMPLYING["sigma_ref"], reference),
    _number("Table 2-1 sigma_n0", "mean stress at rest, MPa", "2.413",
            lambda: reference() * moment("radial_weight") / factor(), given=_MEAN),
    _number("Table 2-1 A", "dynamic coefficient", "0.468", dynamic, _FULL_A),
    Claim("Fig. 2-3", "J_r within 10 % for small phi", "for small phi practically constant", "-1/10; 1/10",
          lambda: lambda phi: change_by_rotation("radial_weight", phi), "small", shows=_ROTATIONS),
    Claim("(3.1)", "moment of inertia", "Theta = ell rho int int r^3 dr dtheta", "ell*rho*body(r**3)",
          lambda: ell * rho * body(moment_of(r, rate(2)) * AREA / omega_dot),
          shows="what (3.2) needs: {}",
          unit="kg m^2"),
    Claim("(3.2)", "angular momentum", "Theta domega/dt = M", "ell*rho*body(r**3)*omega_dot",
          lambda: expand(ell * rho * body(moment_of(r, rate(2)) * AREA)), shows="its rate: {}"),
    Claim("(3.3)", "moments about K", "int r dW_theta - int R dT", "r*dW_theta; -R*dT",
          lambda: (moment_of(r, symbols("dW_r dW_theta")), moment_of(R, (-Symbol("dN"), -Symbol("dT")))),
          remark="dT is the magnitude; dN has no moment"),
    Claim("(3.4)", "moments, written out", "int r rho g(-cos theta) dV - R int mu sigma_n dS",
          "-r*rho*g*cos(theta); -R*mu*sigma_n",
          lambda: (moment_of(r, GRAVITY) * rho, moment_of(R, reaction()).subs(tau_n, mu * sigma_n)),
          given=_MOTION[-1:]),
    Claim("Sect. 3 only", "uniform stress is needed", "the only one compatible with a 1 d.o.f. model", "0; 0",
          lambda: [postulates.same_force()], "range", shows="{} above the mean in the middle, and the same force",
          causes=(Cause("with one coefficient, all distributions with the same mean give the same force, such as "
                        "radial columns", "wrong", postulates.same_force),)),
    Claim("(3.5)", "friction force", "mu(t) sigma_n ell R 2 alpha", "mu*sigma_mean*ell*R*2*alpha",
          lambda: (mu * ell * ARC * STRESS_SUM).subs(STRESS_SUM, 2 * alpha * sigma_mean),
          remark="for any distribution of the stress",
          given=_MOTION),
    Claim("(3.6)", "mean stress", "sigma_ref (sigma_st* + A omega*^2)", "sigma_ref*(J_r/lam + A*omega_star**2)",
          lambda: derived_form("2.10"),
          given=_MEAN),
    Claim("(3.7)", "moment of the weight", "ell rho g int int r^2(-cos theta) dr dtheta",
          "ell*rho*g*body(-r**2*cos(theta))", lambda: ell * rho * body(moment_of(r, GRAVITY) * AREA)),
    Claim("(3.8)", "angular momentum, written out", "int int r^3 domega/dt = g int int r^2(-cos theta)"
          " - R^2 g/gamma 2 alpha mu sigma_n",
          "R**4*Theta*g/R*rate_star; g*R**3*J_theta - R**2*g/gamma*2*alpha*mu*sigma_mean", momentum,
          given=_MOTION),
    Claim("(3.9)", "time factor", "t_c = sqrt(R/g)", "sqrt(R/g)", lambda: 1 / sqrt(g / R),
          shows="what (2.21) needs: {}",
          unit="s"),
    Claim("(3.10)", "angular acceleration", "domega/dt = g/R domega*/dt*", "g/R*rate_star",
          lambda: diff(rate_star * (t * sqrt(g / R)) * sqrt(g / R), t)),
    Claim("(3.11)", "equation of motion", "Theta* domega*/dt* = J_theta - lam (sigma_0* + A omega*^2) mu",
          "J_theta - lam*(J_r0/lam + A*omega_star**2)*mu", lambda: derived_form("3.11"),
          given=_MOTION),
    Claim("(3.12)", "moment of inertia, dimensionless", "int int_{R_1*}^1 r*^3 dr* dtheta", "body_star(r**3)",
          lambda: scaled_body(r**3) / R**4),
    Claim("(3.13)", "moment of the weight, dimensionless", "int int_{R_1*}^1 r*^2(-cos theta) dr* dtheta",
          "body_star(-r**2*cos(theta))", lambda: scaled_body(moment_of(r, GRAVITY) * AREA) / (g * R**3)),
    Claim("(3.14)", "lever of the resistance",
          "lam = 2 alpha sigma_ref/(gamma R) = 2 alpha f/R = 2 alpha (1 - cos(alpha))",
          "2*alpha*sigma_ref/(gamma*R); 2*alpha*f/R; 2*alpha*(1 - cos(alpha))", lambda: (lever(),) * 3,
          shows="coefficient of mu sigma*: {}"),
    Claim("(3.15)", "moment of inertia, closed form", "(alpha - sin(2 alpha) (1 + 2 cos(alpha)^2)/6)/2",
          PRINTED["moment_of_inertia"], lambda: moment_derivation("moment_of_inertia").amplitude, weight=r**3),
    _figure("Fig. 3-1", "moment of inertia over alpha", "Theta* = {} here, {} at 2 alpha",
            _over_angle("moment_of_inertia"), "its curve is (3.15)"),
    Claim("Fig. 3-2", "J_theta within 10 % for small phi", "for small phi practically constant", "-1/10; 1/10",
          lambda: lambda phi: change_by_rotation("weight_moment", phi), "small", shows=_ROTATIONS),
    Claim("(3.16)", "equation of motion, short", "domega*/dt* = a - b omega*^2", "a - b*omega_star**2",
          lambda: derived_form("3.16"),
          given=_MOTION),
    Claim("(3.17)", "drive", "a = (J_theta - J_r0 mu)/Theta*", "(J_theta0 - J_r0*mu)/Theta",
          lambda: expand(derived_form("3.17")),
          given=_MOTION),
    Claim("(3.18)", "brake", "b = lam A mu/Theta*", "lam*A*mu/Theta", lambda: derived_form("3.18"),
          shows="{}, lam A = I_p*",
          given=_MOTION),
    Claim("(3.19)", "starts from rest", "omega*(0) = 0", "0", lambda: solution()["angular_velocity"].subs(t, 0),
          shows="derived motion: omega*(0) = {}",
          unit="1"),
    Claim("(3.20)", "solution", "sqrt(a/b) tanh(sqrt(a b t*))", "sqrt(a/b)*tanh(sqrt(a*b*t))",
          lambda: motion("angular_velocity"),
          given=(*_MOTION, *_SOLVED[1:]),
          law=lambda e: [diff(e, t) - (a_of(t) - b_of(t) * e**2), e.subs(t, 0) - omega_0],
          causes=(Cause("t* belongs outside the root, as in (4.2)", "misprint",
                        edit=("sqrt(a*b*t)", "sqrt(a*b)*t")),)),
    Claim("(3.21)", "limit friction", "mu_eq = J_theta0/J_r0", "J_theta0/J_r0",
          lambda: derived_form("3.21").subs(turn, 0), remark="omega* = 0 for all times, not at one", given=_MOTION),
    Claim("Sect. 3 start", "motion starts below the limit friction", "as soon as mu < mu_eq",
          "J_r0*(J_theta0/J_r0 - mu)", lambda: (derived_form("3.17") * theta_star).subs(turn, 0),
          shows="Theta* domega*/dt* at rest: {}",
          remark="the drive at rest has the sign of mu_eq - mu, since J_r0 > 0", given=_MOTION),
    Claim("Sect. 3 density", "motion independent of density", "a, b without rho", "0; 0",
          lambda: tuple(diff(derived_form(x), rho) for x in ("3.17", "3.18")), shows="da/drho; db/drho = {}",
          given=("homogeneous, dry, without cohesion",)),
    _number("(4.1)", "limit friction, from the printed 0.0387/0.0870", "0.44", limit_friction,
            Cause("the division holds, but the printed J_theta is from Appendix II; unrounded", "wrong",
                   lambda: limit_friction(as_printed=True)), given=_MOTION),
    _number("Sect. 4 phi_eq", "limit friction angle, degrees", "24", lambda: friction_degrees(limit_friction()),
            _LIMIT_ANGLE, given=_MOTION),
    Claim("Sect. 4 phi_res", "residual friction angle, degrees", GIVEN["phi_res"],
          remark="measured in ring-shear tests (Fig. 4-1); nothing here determines it"),
    Claim("Sect. 4 reduction", "friction falls before the motion", "assumed, from 24 to 10 degrees", "mu",
          lambda: mu_of(t), given=_MOTION),
    _number("Sect. 4 g", "gravity, nowhere stated, m/s^2", s.GRAVITY, shows="c0 implies {}", given=_SOLVED,
            value=lambda: implied("c0", lambda x: (x / reached("c0", as_printed=True, gravity="1")) ** 2)),
    _number("Table 4-1 Theta*", "moment of inertia", "0.4376", lambda: moment("moment_of_inertia"),
            Cause(f"(3.15) {_FULL}", "wrong", lambda: moment("moment_of_inertia", 2 * HALF))),
    _number("Table 4-1 J_r", "radial weight", IMPLYING["J_r"], lambda: moment("radial_weight")),
    _number("Table 4-1 J_theta", "moment of the weight", "0.0387", lambda: moment("weight_moment"),
            Cause("from Appendix II, which integrates r (-cos theta)", "wrong", second_appendix)),
    _number("Table 4-1 lambda", "lever of the resistance", "0.1523", factor),
    _number("Table 4-1 sigma*_n0", "mean stress at rest", "0.5713", lambda: moment("radial_weight") / factor(),
            given=_MEAN),
    _number("Table 4-1 A", "dynamic coefficient", "0.468", dynamic, _FULL_A),
    _number("Table 4-1 phi_C,eq", "limit friction angle, degrees", "24", lambda: friction_degrees(limit_friction()),
            _LIMIT_ANGLE, given=_MOTION),
    Claim("(4.2)", "angular velocity", "omega = c0 tanh(c2 t)", "c0*tanh(c2*t)", lambda: dimensional()["omega"],
          given=_SOLVED),
    _reached("(4.2) c0", "largest angular velocity, 1/s", IMPLYING["c0"]),
    _reached("(4.2) c2", "rate of approach, 1/s", "0.00317"),
    _figure("Fig. 4-2", "angular velocity over time", "omega* after 30 s: {} with the paper's slips, {} corrected",
            lambda: both_results("omega*"), "its curve is (3.20), mended"),
    Claim("(4.3)", "rotation", "phi = c0/c2 ln(cosh(c2 t))", "c0/c2*log(cosh(c2*t))", lambda: dimensional()["phi"],
          given=_SOLVED),
    _figure("Fig. 4-3", "rotation over time", "phi after 30 s: {} rad with the paper's slips, {} corrected",
            lambda: both_results("phi"), "its curve is (4.3)"),
    Claim("(4.4)", "velocity", "c1 tanh(c2 t) = c1 (c2 t + O((c2 t)^2))", "c1*tanh(c2*t); c1*c2*t; O(t**2)",
          lambda: expanded_in_time(dimensional()["v"]), given=_SOLVED,
          causes=(Cause("true but not sharp: tanh is odd", "imprecise", edit=("O(t**2)", "O(t**3)")),)),
    _reached("(4.4) c1", "largest velocity, m/s", "165"),
    Claim("(4.5)", "displacement", "c1 ln cosh(c2 t) = c1 ((c2 t)^2/2 + O((c2 t)^4))",
          "c1*log(cosh(c2*t)); c1*(c2*t)**2/2; O(t**4)", lambda: expanded_in_time(dimensional()["s"]), given=_SOLVED,
          causes=(Cause("c1/c2 instead of c1: the result must be a length", "misprint",
                        edit=("c1*", "c1/c2*")),)),
    _figure("Fig. 4-4", "velocity and displacement over time",
            "after 30 s: {} and {} m/s, {} and {} m, with the paper's slips and corrected",
            lambda: [*both_results("v"), *both_results("s")], "its curves are (4.4), and (4.5) mended"),
    Claim("Sect. 4 large", "large velocity and displacement", "in the considered short time interval", "1; oo",
          lambda: [*(v / 5 for v in both_results("v")), *(x / depth() for x in both_results("s"))], "range",
          shows="after 30 s {} and {} times 5 m/s, {} and {} times the depth f, with the paper's slips and corrected",
          remark="5 m/s: where Cruden and Varnes' (1996) fastest class of landslides begins", given=_EXAMPLE),
    Claim("Appendix I", "antiderivative of (2.23)", "J_r(alpha) := ...", "-r*sin(theta)", kind="appendix",
          subject=APPENDIX_I, domain=_ARC, given=_DIPS),
    Claim("Appendix II", "antiderivative of (3.13)", "J(alpha) := ...", "-r**2*cos(theta)", kind="appendix",
          subject=APPENDIX_II, domain=_ARC, given=_DIPS),
)  # fmt: skip
