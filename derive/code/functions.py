"""What `generated` holds: its functions, each with its program, its domain and the words of its docstring."""

import re
from collections import Counter
from collections.abc import Iterable, Mapping

import sympy as sp

from derive.algebra import dynamics
from derive.algebra.integrate import Derivation
from derive.algebra.phase import CONSTANT, ENERGIES, WATER
from derive.algebra.stable import QUOTIENT_FORMS, REDUCED, SLOPES, RoundingError
from derive.approximate.approximants import variants
from derive.check.rounding import Record
from derive.code.emit import Function
from derive.code.program import Program, operations, program
from derive.declare.effects import EFFECTS, LAWS, ORDER, PRESS, VALUE, Effect, Law, Parameter, formulas, specialised
from derive.declare.quantities import MOMENTS, QUOTIENTS, RESISTANCE
from derive.declare.symbols import a, alpha, b, t, theta_1, theta_2, theta_m
from derive.judge.appendices import APPENDICES, parse

HALF_PI = repr(float(sp.N(sp.pi / 2, 40)))
PAPER = "the paper"
ACCURACY = "at most 16 ulp (sampled only: no certificate)."

# alpha up to pi/2 (1 + 4 eps) is inside, for half discs given in degrees; the kernels clip it to pi/2.
_ALPHA_DOMAIN = "0 <= alpha <= pi/2 (1 + 4 eps), with the limits at both ends"
_ALPHA_INSIDE = f"(alpha >= 0.0) & (alpha <= {HALF_PI} * (1.0 + 4.0 * eps))"
_ALPHA = ("alpha", "Half the opening angle of the arc, rad.")
_CLIP = {alpha: sp.Min(alpha, sp.pi / 2)}


def closed_amplitudes(derivations: list[Derivation]) -> dict[str, sp.Expr]:
    """Closed forms of the base quantities in alpha, by name."""
    forms = {d.moment.amplitude[0] if d.moment.amplitude else d.moment.name: d.amplitude for d in derivations}
    return forms | {RESISTANCE[0]: 2 * alpha * (1 - sp.cos(alpha))}


def kernels(derivations: list[Derivation], proved: Iterable[Record] = ()) -> list[Function]:
    """The base quantities, their quotients, and the two weights of (theta_1, theta_2); with what is proved of them."""
    bounds: dict[str, dict[tuple[str, str], float]] = {}
    for r in proved:
        bounds.setdefault(r["kernel"], {})[r["tier"], r["form"]] = r["bound"]
    closed = closed_amplitudes(derivations)
    declared = {(m.amplitude or (m.name, m.symbol))[0]: ((m.amplitude or (m.name, m.symbol))[1], m.equation, m.help)
                for m in MOMENTS} | {RESISTANCE[0]: RESISTANCE[1:]}  # fmt: skip
    found = []
    for name, form in closed.items():
        symbol, equation, words = declared[name]
        found.append(_of_alpha(name, f"{symbol}: {words}", f"{symbol} = {form}", equation, bounds.get(name)))
    for q in QUOTIENTS:
        formula = f"{q.symbol} = {q.numerator}(alpha)/{q.denominator}(alpha), finite at alpha = 0 where both vanish."
        found.append(_of_alpha(q.name, f"{q.symbol}: {q.help}", formula, q.equation, bounds.get(q.name)))
    return found + [_weight(d) for d in derivations if d.moment.amplitude] + [_limit_friction()]


def _tiers(name: str) -> dict[str, Program]:
    """What NumPy runs at each tier of a fitted kernel."""
    return {v.tier: v.program for form in ("plain", "numpy") for v in variants() if (v.kernel, v.form) == (name, form)}


def _of_alpha(
    name: str, words: str, formula: str, equation: str, bounds: Mapping[tuple[str, str], float] | None
) -> Function:
    """A kernel of alpha: in its fitted tiers, or in its stable form where nothing is fitted (yet)."""
    tiers = _tiers(name)
    whole = tiers.get("best") or program(name, ("alpha",), alpha**3 * REDUCED[name], let=_CLIP)
    return Function(whole, f"{words}, dimensionless.", formula, f"eq. ({equation}) of {PAPER}", (_ALPHA,),
                    f"{words.partition(':')[0]}.", _ALPHA_DOMAIN, _ALPHA_INSIDE, (0.0,), _accuracy(name, bounds),
                    tiers)  # fmt: skip


def _accuracy(name: str, bounds: Mapping[tuple[str, str], float] | None) -> str:
    """What is proved of a kernel, in words."""
    if not bounds:
        return ACCURACY
    plain = bounds["best", "plain"]
    cheap = "".join(
        f"; accuracy={tier}: {bound:.3g} relative"
        for (tier, form), bound in bounds.items()
        if form == "fused" and tier[0] == "1"
    )
    single = f"; float32: {bounds['float32', 'fused']:.3g} ulp" if ("float32", "fused") in bounds else ""
    return (
        f"proved, rounding included: {bounds['best', 'fused']:.3g} ulp compiled with FMA, {plain:.3g} without, "
        f"{bounds.get(('best', 'numpy'), plain):.3g} in NumPy{cheap}{single} (certificates/{name}.json)."
    )


def stable_forms() -> list[tuple[Program, str]]:
    """Forms without cancellation, which the fits replace: each kernel's is proved equal to its closed form."""
    forms = {name: alpha**3 * form for name, form in REDUCED.items()} | QUOTIENT_FORMS
    return [(program(name, ("alpha",), form, let=_CLIP), "the stable form") for name, form in forms.items()]


_ARC = (
    ("theta_1", "Polar angle of the arc's first end, rad, from the positive x axis."),
    ("theta_2", "Polar angle of its other end, rad; theta_1 <= theta_2 <= theta_1 + pi."),
)
_ARC_DOMAIN = "0 <= (theta_2 - theta_1)/2 <= pi/2 (1 + 4 eps)"
_ARC_INSIDE = (
    f"(theta_2 >= theta_1) & (0.5 * theta_2 - 0.5 * theta_1 <= {HALF_PI} * (1.0 + 4.0 * eps)) & np.isfinite(theta_1)"
)
# alpha and theta_m as difference and sum, with what their rounding lost.
_DELTA, _EPSILON, _KERNEL = sp.symbols("delta epsilon kernel", real=True)
_ENDS = {
    alpha: sp.Min((theta_2 - theta_1) / 2, sp.pi / 2),
    _DELTA: RoundingError(theta_2, -theta_1) / 2,
    theta_m: (theta_1 + theta_2) / 2,
    _EPSILON: RoundingError(theta_1, theta_2) / 2,
}


def _turned(function: type[sp.Function]) -> sp.Expr:
    """sin or cos of the exact theta_m, to first order in what its rounding lost."""
    return function(theta_m) + _EPSILON * sp.diff(function(theta_m), theta_m)


def _limit_friction() -> Function:
    """J_theta/J_r = (C_theta/C_r) tan(psi), from reduced functions."""
    let = _ENDS | {_KERNEL: _tiers("weight_moment_per_radial_weight")["best"]}
    return Function(
        program("limit_friction", ("theta_1", "theta_2"), _KERNEL * _turned(sp.cos) / _turned(sp.sin), let=let),
        "mu_eq: friction coefficient at limit equilibrium.",
        "mu_eq = J_theta/J_r = (C_theta/C_r) tan(psi); negative where gravity turns the mass clockwise.",
        f"eq. (3.21) of {PAPER}", _ARC, "mu_eq.", _ARC_DOMAIN, _ARC_INSIDE, (4.0, 5.0), ACCURACY,
    )  # fmt: skip


def _weight(d: Derivation) -> Function:
    """J_r or J_theta: alpha and theta_m as sum and difference, each with its rounding error carried to first order."""
    assert d.moment.amplitude
    name, symbol = d.moment.amplitude
    # cos(psi) = -sin(theta_m) and sin(psi) = -cos(theta_m), as psi = 3 pi/2 - theta_m.
    direction = _turned(sp.sin if d.moment.weight.has(sp.sin) else sp.cos)
    amplitude = _KERNEL + _DELTA * SLOPES[name]
    let = _ENDS | {_KERNEL: _tiers(name)["best"]}
    return Function(
        program(d.moment.name, ("theta_1", "theta_2"), -amplitude * direction, let=let),
        f"{d.moment.symbol}: {d.moment.help}, dimensionless.",
        f"{d.moment.symbol} = {symbol}(alpha) {d.direction}, alpha = (theta_2 - theta_1)/2, "
        "psi = 3 pi/2 - (theta_1 + theta_2)/2.",
        f"eq. ({d.moment.equation}) of {PAPER}", _ARC, f"{d.moment.symbol}.", _ARC_DOMAIN, _ARC_INSIDE, (4.0, 5.0),
        f"the error of {name} in NumPy plus 2 ulp of the amplitude (sampled only: no certificate).",
    )  # fmt: skip


_WORDS = {
    "a": ("Drive, (J_theta - mu J_r)/Theta* (3.17).", "np.isfinite(a)", 1.0),
    "b": ("Brake, mu I_p*/Theta* (3.18).", "np.isfinite(b)", 1.0),
    "omega_0": ("Initial angular velocity over sqrt(g/R).", "np.isfinite(omega_0)", 0.0),
    "t": ("Time over sqrt(R/g), not negative.", "(t >= 0.0) & np.isfinite(t)", 0.0),
}
_BRAKED = {"a": "(a < 0.0) & np.isfinite(a)", "b": "(b >= 0.0) & np.isfinite(b)",
           "omega_0": "(omega_0 >= 0.0) & np.isfinite(omega_0)"}  # fmt: skip
_MOTION_ACCURACY = "at most 8 ulp times (1 + condition number) (sampled only: no certificate)."


def motion() -> list[Function]:
    """The motion formulas of frozen geometry."""
    found = []
    for form in dynamics.FORMS:
        names = tuple(x.name for x in form.inputs)
        braked = "arrest" in form.name
        inside = [_BRAKED[n] if braked else _WORDS[n][1] for n in names]
        safe = tuple(-1.0 if braked and n == "a" else _WORDS[n][2] for n in names)
        domain = "t >= 0" + (", until the solution runs to infinity" if "b" in names else "")
        if braked:
            domain = "a < 0, b >= 0, omega_0 >= 0" if "b" in names else "a < 0, omega_0 >= 0"
        found.append(_plain(program(form.name, names, form.result, let=form.let), form.summary, FORMULAS[form.name],
                            form.equation, domain, inside, safe, _MOTION_ACCURACY))  # fmt: skip
    return found


def _plain(p: Program, summary: str, formula: str, equation: str, domain: str, inside: list[str],
           safe: tuple[float, ...], accuracy: str) -> Function:  # fmt: skip
    parameters = tuple((n, _WORDS[n][0]) for n in p.inputs)
    return Function(p, summary, formula, f"eq. ({equation}) of {PAPER}", parameters, "Dimensionless.", domain,
                    " & ".join(f"({x})" if "&" in x else x for x in inside), safe, accuracy)  # fmt: skip


FORMULAS = {
    "frozen_angular_velocity": "omega = omega_0 + a t",
    "frozen_rotation": "phi = omega_0 t + a t**2/2",
    "frozen_angular_acceleration": "d(omega)/dt = a",
    "frozen_arrest_time": "t = omega_0/(-a)",
    "frozen_arrest_rotation": "phi = omega_0**2/(-2 a)",
    "frozen_centripetal_angular_velocity": "omega = (omega_0 + a T)/(1 + b omega_0 T), T = tanh(k t)/k, k = sqrt(a b)",
    "frozen_centripetal_rotation": "phi = ln(cosh(k t) + b omega_0 sinh(k t)/k)/b, k = sqrt(a b)",
    "frozen_centripetal_angular_acceleration": "(a - b omega_0**2)/y**2 with y = exp(b phi)",
    "frozen_centripetal_arrest_time": "t = arctan(omega_0 sqrt(b/(-a)))/sqrt(-a b)",
    "frozen_centripetal_arrest_rotation": "phi = ln(1 + b omega_0**2/(-a))/(2 b)",
}


def printed() -> list[tuple[Program, str]]:
    """The paper's forms as it prints them, and the one-line equals of its appendices, for comparison only."""
    c, s = sp.cos(alpha), sp.sin(alpha)
    half = sp.Rational(1, 2)
    moment = (2 * alpha - half * sp.sin(2 * alpha) - sp.log(sp.Abs(sp.tan(sp.pi / 4 + alpha / 2))) * c**3) / 3
    factor = 2 * alpha * (1 - c)
    with sp.evaluate(False):
        velocity = sp.sqrt(a / b) * sp.tanh(sp.sqrt(a * b) * t)
        rotation = sp.log(sp.cosh(sp.sqrt(a * b) * t)) / b
    one = ("alpha",)
    return [
        (program("polar_moment", one, moment), "(2.19)"),
        (program("moment_of_inertia", one, half * (alpha - sp.sin(2 * alpha) * (1 + 2 * c**2) / 6)), "(3.15)"),
        (program("radial_weight_amplitude", one, s - c**2 * sp.atanh(s)), "Appendix I in one line"),
        (program("weight_moment_amplitude", one, sp.Rational(2, 3) * (s - s * c**2)), "(3.13), integrated"),
        (program("resistance_factor", one, factor), "(3.14)"),
        (program("dynamic_coefficient", one, moment / factor), "(2.24) with (2.19)"),
        *((program(f"appendix_{x.name}", ("theta_1", "theta_2", "alpha"), parse(x)),
           f"Appendix {x.name}, brackets repaired") for x in APPENDICES),
        (program("angular_velocity", ("a", "b", "t"), velocity), "(3.20), misprint mended, from rest"),
        (program("rotation", ("a", "b", "t"), rotation), "(4.3), from rest"),
    ]  # fmt: skip


def balance() -> tuple[list[tuple[Program, str]], dict[tuple[str, ...], dict[str, str]]]:
    """The specialised functions with their formulas, and for each combination of effects which it needs."""
    variants, table = specialised()
    found = [_specialised(v.name, v.expression, v.what, ORDER) for v in variants.values()]
    for law in LAWS:
        if law.coefficient is not None:
            order = ("slip", "more", "speed", *(p.name for p in law.parameters))
            found.append(_specialised(f"friction_{law.name}", law.coefficient, f"friction: {law.help}", order))
        if law.drop is not None:
            found.append(_specialised(f"drop_{law.name}", law.drop, "its fall over `more` slip, from `slip`", order))
    known = {v.name for v in variants.values()}
    for chosen, served in table.items():
        if "rotation" not in chosen or {"damping", "fall", "pressurisation"} & set(served):
            continue  # E obeys no linear equation in the rotation, or not alone
        absent = {} if "constant" in served else {CONSTANT: 0}
        absent |= {} if variants[served["normal"]].expression.subs(PRESS, 0) else {WATER: 0}
        for energy in ENERGIES:
            if energy.braked != ("brake" in served):
                continue
            gone = [
                n
                for n, x in (("constant", CONSTANT), ("water", WATER))
                if x in absent or x not in energy.form.free_symbols
            ]
            name = "_".join((energy.name, *(n for n in ("constant", "water") if n not in gone)))
            served["energy_softening" if "softening" in energy.name else "energy"] = name
            if name not in known:
                known.add(name)
                found.append(_specialised(name, energy.form.subs(absent), energy.help, ENERGY_ORDER))
    return found + [_state("frozen", "frozen_state"), _state("frozen_centripetal", "frozen_braked_state")], table


def _state(prefix: str, name: str) -> tuple[Program, str]:
    """Rotation, angular velocity and acceleration of a frozen slide in one: they share most of their parts."""
    forms = [f for f in dynamics.FORMS if f.name in [f"{prefix}_{n}" for n in STATE]]
    forms.sort(key=lambda f: STATE.index(f.name.removeprefix(f"{prefix}_")))
    let = {symbol: value for f in forms for symbol, value in f.let.items()}
    names = tuple(x.name for x in forms[0].inputs)
    return program(name, names, *(f.result for f in forms), let=let), "rotation, velocity and acceleration at a time"


STATE = ("rotation", "angular_velocity", "angular_acceleration")
ENERGY_ORDER = ("x", "start", "drive", "tilt", "constant", "brake", "drop", "decay", "press", "press_rise", "water")


def _specialised(name: str, expression: sp.Expr, words: str, order: tuple[str, ...]) -> tuple[Program, str]:
    known = (*order, "limit_friction")
    names = tuple(sorted((x.name for x in expression.free_symbols), key=known.index))
    return program(name, names, expression), words


def effects_module() -> str:
    """The runtime half of the effects: plain data, and which functions serve which combination."""
    programs, table = balance()
    by_name = {p.name: p for p, _ in programs}
    arguments = [f"    {n!r}: {p.inputs!r}," for n, p in sorted(by_name.items())]
    return _EFFECTS_HEAD + "\n".join([
        "LAWS = {", *(f"    {law.name!r}: {_effect(law, 'Law')}," for law in LAWS), "}", "",
        "EFFECTS = {", *(f"    {e.name!r}: {_effect(e, 'Effect')}," for e in EFFECTS), "}", "",
        "# Arguments of the functions in `generated.balance`.",
        "ARGUMENTS: dict[str, tuple[str, ...]] = {", *arguments, "}", "",
        "# Functions of each combination of effects, and the operations of one evaluation of all of them.",
        "COMBINATIONS = {", *(f"    {c!r}: {_combination(f, by_name)}," for c, f in table.items()), "}", "",
    ])  # fmt: skip


def _combination(served: dict[str, str], programs: dict[str, Program]) -> str:
    counted = [programs[n] for what, n in served.items() if what != "energy_softening"]
    total: Counter[str] = sum((p.operations() for p in counted), start=Counter())
    return f"Combination({served!r}, {sum(total.values())}, {operations(total)!r})"


def _effect(e: Effect | Law, kind: str) -> str:
    parameters = "".join(f"\n        {_parameter(p)}," for p in e.parameters)
    parameters += "\n    " if parameters else ""
    more = f"{e.turns!r}, {e.any_of!r}, {formulas(e)!r}" if isinstance(e, Effect) else f"{e.scale!r}, {e.kinks!r}"
    return f"{kind}({e.name!r}, {e.equation!r}, ({parameters}), {e.depends_on!r}, {e.help!r}, {more})"


def _parameter(p: Parameter) -> str:
    """A parameter as data; its conversion to a dimensionless value is a lambda over the arc's scales."""
    symbol = p.symbol.name if p.symbol is not None else ""
    convert = sp.pycode(p.dimensionless, fully_qualified_modules=False)
    for name in sorted((x.name for x in p.dimensionless.free_symbols if x != VALUE), key=len):
        convert = re.sub(rf"\b{name}\b", f"scales[{name!r}]", convert)
    words = f"{p.name!r}, {p.unit!r}, {_bound(p.lower)}, {_bound(p.upper)}, {p.help!r}, {p.key!r}, {p.per_unit!r}"
    return f"Parameter({words}, {symbol!r}, lambda value, scales: {convert}, {p.optional!r}, {p.kind!r})"


def _bound(value: float) -> str:
    return {float("inf"): "INFINITY", float("-inf"): "-INFINITY"}.get(value, repr(value))


_EFFECTS_HEAD = '''"""Effects and friction laws that a scene may ask for, and the functions that serve them."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from numpy import sqrt

INFINITY = float("inf")


@dataclass(frozen=True, slots=True)
class Parameter:
    """What an effect or a law needs: SI unit, open bounds, and how a scene file and the balance write it."""

    name: str
    unit: str
    lower: float
    upper: float
    help: str
    key: str
    per_unit: float
    symbol: str
    dimensionless: Callable[[float, Mapping[str, float]], float]
    optional: bool
    kind: str = "number"


@dataclass(frozen=True, slots=True)
class Law:
    """A friction law: equation, parameters, what it depends on, help; its length scale, and the slips of its kinks."""

    name: str
    equation: str
    parameters: tuple[Parameter, ...]
    depends_on: tuple[str, ...]
    help: str
    scale: str
    kinks: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Effect:
    """A term of the equation of motion: equation, parameters, what it depends on, help, whether the mass turns.

    At least one parameter of ``any_of`` is needed. ``formulas`` say what it adds to the balance.
    """

    name: str
    equation: str
    parameters: tuple[Parameter, ...]
    depends_on: tuple[str, ...]
    help: str
    turns: bool
    any_of: tuple[str, ...] = ()
    formulas: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Combination:
    """Functions in `generated.balance` of a combination of effects, by what they give, and their operations."""

    functions: Mapping[str, str]
    count: int
    operations: str


'''
