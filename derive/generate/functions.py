"""Functions of `generated`, each with its program, its domain and the texts of its docstring."""

from collections.abc import Iterable, Sequence

import sympy as sp
from sympy import Expr, Rational, atanh, cos, sin

from derive.algebra.appendices import APPENDICES, parse
from derive.algebra.integrate import closed_forms, derive
from derive.approximate.programs import variants, variants_of_ends
from derive.check.ends import LIMIT
from derive.check.records import Record, of_both_ends, unit
from derive.code.emit import Function
from derive.code.program import Program, program
from derive.declare.quantities import MOMENTS, PRINTED, QUOTIENTS, RESISTANCE, Elementary, Moment, Quotient
from derive.declare.symbols import alpha
from derive.kinds import Coefficients, TextPair

PAPER = "the paper"
# Names and descriptions of arguments, their domain, and the arguments of the example.
Arguments = tuple[tuple[TextPair, ...], str, Coefficients]

# The domain includes alpha up to pi/2 (1 + 4 eps), for half discs given in degrees. The kernels clip alpha to pi/2.
_OF_ALPHA: Arguments = (
    (("alpha", "Half the opening angle of the arc, rad."),),
    "0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends",
    (0.5,),
)
_OF_ENDS: Arguments = (
    (
        ("theta_1", "Polar angle of the arc's first end, rad, from the positive x axis."),
        ("theta_2", "Polar angle of its other end, rad; theta_1 <= theta_2 <= theta_1 + pi."),
    ),
    f"0 <= (theta_2 - theta_1)/2 <= pi/2 (1 + 4 eps), both ends within {LIMIT:.0f} rad of 0",
    (4.0, 5.0),
)


def public_functions(proved: Sequence[Record]) -> list[Function]:
    """Return the base quantities, their quotients, and the functions of both ends, with their proved accuracy."""
    formulas = {name: str(form) for name, form in closed_forms().items()}
    for q in QUOTIENTS:
        formulas[q.name] = f"{q.numerator}(alpha)/{q.denominator}(alpha), finite at alpha = 0 where both vanish."
    quantities: tuple[Moment | Elementary | Quotient, ...] = (*MOMENTS, RESISTANCE, *QUOTIENTS)
    every = []
    for x in quantities:
        name, symbol = x.kernel if isinstance(x, Moment) else (x.name, x.symbol)
        every.append(_function(name, symbol, f"{x.help}, dimensionless", formulas[name], _source(x), proved))
    for m in MOMENTS:
        if m.amplitude:
            turned = f"{m.kernel[1]}(alpha) {derive(m).direction}"
            formula = f"{turned}, alpha = (theta_2 - theta_1)/2, psi = 3 pi/2 - (theta_1 + theta_2)/2."
            every.append(_function(m.name, m.symbol, f"{m.help}, dimensionless", formula, _source(m), proved))
    friction = "friction coefficient at limit equilibrium"
    formula = "J_theta/J_r = (C_theta/C_r) tan(psi); negative where gravity turns the mass clockwise."
    every.append(_function("limit_friction", "mu_eq", friction, formula, f"eq. (3.21) of {PAPER}", proved))
    return every


def _function(name: str, symbol: str, words: str, formula: str, source: str, proved: Sequence[Record]) -> Function:
    """Return a function of alpha or of both ends with its programs, its proved accuracy, and the texts on it."""
    tiers: dict[str, Program] = {}
    for form in ("plain", "numpy"):
        own = [v for v in (*variants(), *variants_of_ends()) if (v.kernel, v.form) == (name, form)]
        tiers |= {v.tier: v.program for v in own}
    best = tiers["best"]
    parameters, domain, given = _OF_ALPHA if len(best.inputs) == 1 else _OF_ENDS
    summary = f"Return {symbol}, the {words}."
    equation = f"{symbol} = {formula}"
    accuracy = _accuracy(name, proved)
    return Function(best, summary, equation, source, parameters, f"{symbol}.", domain, accuracy, given, tiers)


def _source(x: Moment | Elementary | Quotient) -> str:
    """Return the source of a quantity as text: its equation in the paper, or the declared source."""
    if isinstance(x, Moment) and not x.equation:
        return x.source or "a declaration of one's own"
    return f"eq. ({x.equation}) of {PAPER}"


def _accuracy(name: str, proved: Sequence[Record]) -> str:
    """Return the proved bounds of the kernel ``name`` in words, from the records of its certificates."""
    mine = [r for r in proved if r["kernel"] == name]
    bounds = {(str(r["tier"]), r["form"]): r["bound"] for r in mine}
    (unit_of_best,) = {unit(r) for r in mine if r["tier"] == "best"}
    fused = bounds["best", "fused"]
    plain = bounds["best", "plain"]
    in_numpy = bounds.get(("best", "numpy"), plain)
    cheap = "".join(
        f"; accuracy={tier}: {bound:.3g} relative"
        for (tier, form), bound in bounds.items()
        if form == "fused" and tier[0] == "1"
    )
    single = "; float32: this double rounded, with half an ulp of float32 more"
    for record in mine:
        if (record["tier"], record["form"]) == ("float32", "fused"):
            single = "; float32: " + ("correctly rounded" if "hard" in record else f"{record['bound']:.3g} ulp")
    return (
        f"proved, rounding included: {fused:.3g} {unit_of_best} compiled with FMA, {plain:.3g} without, "
        f"{in_numpy:.3g} in NumPy{cheap}{single} (certificates/{name}.json)."
    )


def comments(kernels: Iterable[Function], proved: Iterable[Record]) -> dict[tuple[str, str, str], str]:
    """Return the comment of each compiled program: formula, interval, proved bound and certificate."""
    by_name = {f.program.name: f for f in kernels}
    texts = {}
    for r in proved:
        kernel = r["kernel"]
        tier = r["tier"]
        form = r["form"]
        interval = "both ends" if of_both_ends(r) else "0 <= alpha <= pi/2"
        bound = f"{r['bound']:.3g} {unit(r)} (certificates/{kernel}.json)"
        if "hard" in r:
            bound += ", rounded correctly to float32"
        formula = by_name[kernel].formula.rstrip(".")
        texts[kernel, tier, form] = f"{formula}, {interval}, {tier}, {form}: proved within {bound}"
    return texts


def printed() -> list[tuple[Program, str]]:
    """Return the paper's forms as printed, and the one-line equivalents of its appendices, for comparison only."""
    ends = ("theta_1", "theta_2", "alpha")
    return [
        *((program(name, ("alpha",), form), source) for name, form, source in _printed_kernels()),
        *((program(f"appendix_{x.name}", ends, parse(x)), f"Appendix {x.name}, brackets repaired") for x in APPENDICES),
    ]


def _printed_kernels() -> list[tuple[str, Expr, str]]:
    """Return name, closed form and source of each function that the paper prints."""
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
