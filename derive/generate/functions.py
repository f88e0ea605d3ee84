"""The functions of `generated`, each with its program, its domain and the words of its docstring."""

from collections.abc import Iterable, Mapping, Sequence

import sympy as sp
from sympy import Expr, Integer, Min, N, Rational, atanh, cos, diff, pi, sin

from derive.algebra import dynamics
from derive.algebra.appendices import APPENDICES, parse
from derive.algebra.integrate import PSI, Derivation, closed_forms, derive
from derive.algebra.prove import prove_zero
from derive.algebra.remainders import RoundingError
from derive.algebra.rules import prove_equal, stable
from derive.approximate.programs import variants
from derive.check.records import Record
from derive.code.emit import Function
from derive.code.program import Program, program
from derive.declare.quantities import MOMENTS, PRINTED, QUOTIENTS, RESISTANCE, Elementary, Moment, Quotient
from derive.declare.symbols import alpha, theta_1, theta_2, theta_m

HALF_PI = repr(float(N(pi / 2, 40)))
PAPER = "the paper"
ACCURACY = "at most 16 ulp (sampled only: no certificate)."

# alpha up to pi/2 (1 + 4 eps) is inside, for half discs given in degrees; the kernels clip it to pi/2.
_ALPHA_DOMAIN = "0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends"
_ALPHA_INSIDE = f"(alpha >= 0.0) & (alpha <= {HALF_PI} * (1.0 + 4.0 * eps))"
_ALPHA = ("alpha", "Half the opening angle of the arc, rad.")
_CLIP = {alpha: Min(alpha, pi / 2)}


def kernels(proved: Sequence[Record] = ()) -> list[Function]:
    """The base quantities, their quotients, and the two weights of (theta_1, theta_2); with what is proved of them."""
    closed = closed_forms()
    formulas = {name: str(form) for name, form in closed.items()}
    for q in QUOTIENTS:
        formulas[q.name] = f"{q.numerator}(alpha)/{q.denominator}(alpha), finite at alpha = 0 where both vanish."
    quantities: tuple[Moment | Elementary | Quotient, ...] = (*MOMENTS, RESISTANCE, *QUOTIENTS)
    every = []
    for x, (name, form) in zip(quantities, stable_forms(closed).items(), strict=True):
        # Programs of the fitted tiers, or of the stable form where nothing is fitted.
        symbol = x.kernel[1] if isinstance(x, Moment) else x.symbol
        tiers = _tiers(name)
        every.append(
            Function(
                tiers.get("best") or program(name, ("alpha",), form, let=_CLIP),
                f"{symbol}: {x.help}, dimensionless.",
                f"{symbol} = {formulas[name]}",
                _source(x),
                (_ALPHA,),
                f"{symbol}.",
                _ALPHA_DOMAIN,
                _ALPHA_INSIDE,
                (0.0,),
                _accuracy(name, [r for r in proved if r["kernel"] == name]),
                tiers,
            )
        )
    friction = _of_ends(
        "limit_friction",
        _LIMIT,
        "weight_moment_per_radial_weight",
        "mu_eq: friction coefficient at limit equilibrium.",
        "mu_eq = J_theta/J_r = (C_theta/C_r) tan(psi); negative where gravity turns the mass clockwise.",
        f"eq. (3.21) of {PAPER}",
        ACCURACY,
    )
    return [*every, *(_weight(derive(m)) for m in MOMENTS if m.amplitude), friction]


def _source(x: Moment | Elementary | Quotient) -> str:
    """Where a quantity is from."""
    if isinstance(x, Moment) and not x.equation:
        return x.source or "a declaration of one's own"
    return f"eq. ({x.equation}) of {PAPER}"


def _tiers(name: str) -> dict[str, Program]:
    """What NumPy runs at each tier of a fitted kernel."""
    return {v.tier: v.program for form in ("plain", "numpy") for v in variants() if (v.kernel, v.form) == (name, form)}


def _accuracy(name: str, proved: Sequence[Record]) -> str:
    """The proved bounds of a kernel, in words."""
    if not proved:
        return ACCURACY
    bounds: dict[tuple[str, str], float] = {(r["tier"], r["form"]): r["bound"] for r in proved}
    plain = bounds["best", "plain"]
    cheap = "".join(
        f"; accuracy={tier}: {bound:.3g} relative"
        for (tier, form), bound in bounds.items()
        if form == "fused" and tier[0] == "1"
    )
    if ("float32", "fused") in bounds:
        single = f"; float32: {bounds['float32', 'fused']:.3g} ulp"
    else:
        single = ""
    return (
        f"proved, rounding included: {bounds['best', 'fused']:.3g} ulp compiled with FMA, {plain:.3g} without, "
        f"{bounds.get(('best', 'numpy'), plain):.3g} in NumPy{cheap}{single} (certificates/{name}.json)."
    )


def comments(kernels: Iterable[Function], proved: Iterable[Record]) -> dict[tuple[str, str, str], str]:
    """The comment above each compiled program: formula, interval, proved bound and certificate."""
    known = {f.program.name: f for f in kernels}
    texts = {}
    for r in proved:
        kernel = r["kernel"]
        tier = r["tier"]
        form = r["form"]
        bound = f"{r['bound']:.3g} {'relative' if tier[0] == '1' else 'ulp'} (certificates/{kernel}.json)"
        formula = known[kernel].formula.rstrip(".")
        texts[kernel, tier, form] = f"{formula}, 0 <= alpha <= pi/2, {tier}, {form}: proved within {bound}"
    return texts


def stable_forms(closed: Mapping[str, Expr]) -> dict[str, Expr]:
    """Forms without cancellation, which the fits replace, of the base quantities and of their quotients."""
    forms = {name: stable(form) for name, form in closed.items()}
    ratios = {q.name: forms[q.numerator].reduced / forms[q.denominator].reduced for q in QUOTIENTS}
    return {name: form.form for name, form in forms.items()} | ratios


def stable_programs(closed: Mapping[str, Expr]) -> list[tuple[Program, str]]:
    forms = stable_forms(closed).items()
    return [(program(name, ("alpha",), form, let=_CLIP), "the stable form") for name, form in forms]


_ARC = (
    ("theta_1", "Polar angle of the arc's first end, rad, from the positive x axis."),
    ("theta_2", "Polar angle of its other end, rad; theta_1 <= theta_2 <= theta_1 + pi."),
)
_ARC_DOMAIN = "0 <= (theta_2 - theta_1)/2 <= pi/2 (1 + 4 eps)"
_ARC_INSIDE = (
    f"(theta_2 >= theta_1) & (0.5 * theta_2 - 0.5 * theta_1 <= {HALF_PI} * (1.0 + 4.0 * eps)) & np.isfinite(theta_1)"
)
# alpha and theta_m as difference and sum, with their rounding errors.
_DELTA, _EPSILON, _KERNEL = sp.symbols("delta epsilon kernel", real=True)
_ENDS = {
    alpha: Min((theta_2 - theta_1) / 2, pi / 2),
    _DELTA: RoundingError(theta_2, -theta_1) / 2,
    theta_m: (theta_1 + theta_2) / 2,
    _EPSILON: RoundingError(theta_1, theta_2) / 2,
}


def _turned(function: type[sp.Function]) -> Expr:
    """sin or cos of the exact theta_m, to first order in its rounding error."""
    return function(theta_m) + _EPSILON * diff(function(theta_m), theta_m)


# (C_theta/C_r) tan(psi); alpha's rounding error is neglected, as the quotient is O(1) with a slope of O(alpha).
_LIMIT = _KERNEL * _turned(cos) / _turned(sin)


def _direction(d: Derivation) -> Expr:
    """In theta_m."""
    return d.direction.subs(PSI, 3 * pi / 2 - theta_m)


def _carried(d: Derivation) -> Expr:
    """J_r or J_theta with the rounding errors of alpha and theta_m carried to first order."""
    sign, direction = _direction(d).as_coeff_Mul()
    return sign * (_KERNEL + _DELTA * stable(diff(d.amplitude, alpha)).form) * _turned(type(direction))


def prove_carried() -> list[str]:
    """Prove that these are of the exact angles, to first order in what the rounding of alpha and theta_m takes."""
    claims = []
    errors = {alpha: _DELTA, theta_m: _EPSILON}
    for angle, error in errors.items():
        claims.append(f"{angle}: the sum of which {error} is lost")
        rounded = _ENDS[angle].replace(Min, lambda *x: next(y for y in x if not y.is_number))
        prove_zero(rounded - _ENDS[error].replace(RoundingError, lambda x, y: x + y), claims[-1])
    forms = {"limit_friction": (_LIMIT, sp.Function("ratio")(alpha), cos(theta_m) / sin(theta_m))}
    for d in map(derive, MOMENTS):
        if d.moment.amplitude:
            forms[d.moment.name] = (_carried(d), d.amplitude, _direction(d))
    for name, (form, kernel, direction) in forms.items():
        claims.append(f"{name}: of the exact angles, to first order")
        carried = {x: error for x, error in errors.items() if form.has(error)}
        exact = (kernel * direction).subs({x: x + error for x, error in carried.items()})
        difference = form.subs(_KERNEL, kernel) - exact
        for zero in (difference, *(diff(difference, error) for error in carried.values())):
            prove_equal(zero.subs(dict.fromkeys(carried.values(), 0)), Integer(0), claims[-1])
    return claims


def _of_ends(name: str, form: Expr, kernel: str, summary: str, formula: str, source: str, accuracy: str) -> Function:
    """A function of both ends, by a form in the exact alpha and theta_m and in a kernel of the rounded alpha."""
    made = program(name, ("theta_1", "theta_2"), form, let=_ENDS | {_KERNEL: _tiers(kernel)["best"]})
    symbol = summary.partition(":")[0]
    return Function(made, summary, formula, source, _ARC, f"{symbol}.", _ARC_DOMAIN, _ARC_INSIDE, (4.0, 5.0), accuracy)


def _weight(d: Derivation) -> Function:
    """J_r or J_theta."""
    m = d.moment
    name, symbol = d.moment.kernel
    return _of_ends(
        m.name,
        _carried(d),
        name,
        f"{m.symbol}: {m.help}, dimensionless.",
        f"{m.symbol} = {symbol}(alpha) {d.direction}, alpha = (theta_2 - theta_1)/2, "
        "psi = 3 pi/2 - (theta_1 + theta_2)/2.",
        _source(m),
        f"the error of {name} in NumPy plus 2 ulp of the amplitude (sampled only: no certificate).",
    )


def motion() -> list[Function]:
    """The motion formulas of frozen geometry."""
    every = []
    for form in dynamics.FORMS:
        names = tuple(x.name for x in form.inputs)
        timed = "t" in names
        limits = {"t": ">= 0"} if timed else {"a": "< 0", "b": ">= 0", "omega_0": ">= 0"}
        domain = ", ".join(f"{x} {limit}" for x, limit in limits.items())
        conditions = []
        for x in names:
            finite = f"np.isfinite({x})"
            conditions.append(f"(({x} {limits[x]}.0) & {finite})" if x in limits else finite)
        every.append(
            Function(
                program(form.name, names, form.result, let=form.let),
                form.summary,
                form.formula,
                f"eq. ({form.equation}) of {PAPER}",
                tuple((x.name, dynamics.INPUTS[x]) for x in form.inputs),
                "Dimensionless.",
                f"{domain}, until the solution runs to infinity" if timed else domain,
                " & ".join(conditions),
                (1.0, 1.0, 0.0, 0.0) if timed else (-1.0, 1.0, 0.0),
                dynamics.ACCURACY,
            )
        )
    return every


def printed() -> list[tuple[Program, str]]:
    """The paper's forms as it prints them, and the one-line equals of its appendices, for comparison only."""
    ends = ("theta_1", "theta_2", "alpha")
    return [
        *((program(name, ("alpha",), form), source) for name, form, source in _printed_kernels()),
        *((program(f"appendix_{x.name}", ends, parse(x)), f"Appendix {x.name}, brackets repaired") for x in APPENDICES),
    ]


def _printed_kernels() -> list[tuple[str, Expr, str]]:
    c = cos(alpha)
    s = sin(alpha)
    moment, inertia = (sp.parse_expr(PRINTED[name], {"alpha": alpha}) for name in ("polar_moment", "moment_of_inertia"))
    resistance = RESISTANCE.form
    return [
        ("polar_moment", moment, "(2.19)"),
        ("moment_of_inertia", inertia, "(3.15)"),
        ("radial_weight_amplitude", s - c**2 * atanh(s), "Appendix I in one line"),
        ("weight_moment_amplitude", Rational(2, 3) * (s - s * c**2), "(3.13), integrated"),
        ("resistance_factor", resistance, "(3.14)"),
        ("dynamic_coefficient", moment / resistance, "(2.24) with (2.19)"),
    ]
