"""The specialised functions: absent effects are gone from the code, and nothing else changes; the energies' proofs.

The energies' references solve their linear equation, E' = 2 (drive - brake E), by the method of undetermined
coefficients with hundreds of digits, so that cancellation does not matter; quadrature confirms these at 30 digits.
"""

import ast
import inspect
import itertools
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path

import mpmath
import numpy as np
import pytest
import sympy as sp
from mpmath import mpf

from derive.algebra import phase
from derive.check.proof import ProofError
from derive.code import functions
from derive.code.program import Program
from generated import balance
from generated.effects import ARGUMENTS, COMBINATIONS, EFFECTS, LAWS

EPS = 2.0**-52
FULL = tuple(EFFECTS)
# What stands for an effect in the functions, and is zero where it is absent.
SYMBOLS = {
    "rotation": ("fall_slope", "press_slope"),
    "centripetal": ("polar",),
    "pore_pressure": ("pore_ratio", "pore_pressure"),
    "cohesion": ("cohesion",),
    "drag": ("drag",),
    "viscosity": ("viscosity",),
    "shaking": ("k_h", "k_v"),
    "thermal_pressurisation": ("excess", "kappa"),
}
# With these E alone obeys no linear equation in the rotation, so that it has no closed form.
NOT_ALONE = {"viscosity", "shaking", "thermal_pressurisation"}
WHATS = (
    "normal",
    "limit_friction",
    "drive",
    "fall",
    "brake",
    "damping",
    "tilt",
    "constant",
    "resistance",
    "effective_stress",
    "normal_stress",
    "pressurisation",
)


def function(name: str) -> Callable[..., float]:
    found: Callable[..., float] = getattr(balance, name)
    return found


def gone_with(chosen: tuple[str, ...]) -> set[str]:
    """Symbols of the effects that are absent; shaking needs the slopes as turning does."""
    absent = {s for e in FULL if e not in chosen for s in SYMBOLS[e]}
    return absent - set(SYMBOLS["rotation"]) if "shaking" in chosen else absent


def pairs() -> Iterator[tuple[tuple[str, ...], tuple[str, ...]]]:
    """Each combination with each that has exactly one effect more."""
    for chosen in COMBINATIONS:
        for extra in set(FULL) - set(chosen):
            yield chosen, tuple(e for e in FULL if e in chosen or e == extra)


# --- absent effects are gone ---------------------------------------------------------------------------------------


def test_all_combinations_are_there() -> None:
    every = {c for n in range(len(FULL) + 1) for c in itertools.combinations(FULL, n)}
    assert set(COMBINATIONS) == every
    assert len(every) == 256
    assert set(SYMBOLS) == set(EFFECTS)
    for chosen, found in COMBINATIONS.items():
        assert all(name in ARGUMENTS for name in found.functions.values())
        assert ("tilt" in found.functions) == ("rotation" in chosen)
        assert ("brake" in found.functions) == bool({"centripetal", "drag"} & set(chosen))
        wet = {"pore_pressure", "cohesion", "thermal_pressurisation"}
        assert ("constant" in found.functions) == bool(wet & set(chosen))
        assert ("damping" in found.functions) == ("viscosity" in chosen)
        assert ("fall" in found.functions) == ("shaking" in chosen)
        assert ("pressurisation" in found.functions) == ("thermal_pressurisation" in chosen)
        assert ("energy" in found.functions) == ("rotation" in chosen and not NOT_ALONE & set(chosen))


def test_removing_an_effect_never_adds_operations() -> None:
    programs: dict[str, Program] = {p.name: p for p, _ in functions.balance()[0]}
    counts = {name: p.operations().total() for name, p in programs.items()}
    for less, more in pairs():
        one, two = COMBINATIONS[less].functions, COMBINATIONS[more].functions
        if ("energy" in one) == ("energy" in two):
            assert COMBINATIONS[less].count <= COMBINATIONS[more].count, (less, more)
        gone = {"energy_softening"}  # where there is a brake, softening has no closed form
        for what in set(one) - gone - ({"energy"} if NOT_ALONE & set(more) else set()):
            assert what in two, (less, more, what)
            assert counts[one[what]] <= counts[two[what]], (less, more, what)
    for name, p in programs.items():
        assert ARGUMENTS[name] == p.inputs


def names_in(name: str) -> set[str]:
    """All names in a function's code, docstring left out."""
    tree = ast.parse(inspect.getsource(function(name)))
    return {n.id for n in ast.walk(tree) if isinstance(n, ast.Name)} | {
        n.arg for n in ast.walk(tree) if isinstance(n, ast.arg)
    }


@pytest.mark.parametrize("chosen", COMBINATIONS, ids="+".join)
def test_absent_effects_are_not_in_the_code(chosen: tuple[str, ...]) -> None:
    served = COMBINATIONS[chosen].functions
    absent = gone_with(chosen)
    for what, name in served.items():
        assert not names_in(name) & absent, (what, name)
        assert set(ARGUMENTS[name]) <= names_in(name)
        constants = [
            n.value for n in ast.walk(ast.parse(inspect.getsource(function(name)))) if isinstance(n, ast.Constant)
        ]
        assert 0.0 not in [c for c in constants if isinstance(c, float)], f"{name} multiplies by zero"
    if "rotation" not in chosen:
        assert not {"energy", "energy_softening"} & set(served)
    for name in (n for what, n in served.items() if what.startswith("energy")):
        assert ("brake" in names_in(name)) == ("brake" in served)
        assert ("constant" in names_in(name)) == ("constant" in served)
        assert ("water" in names_in(name)) == ("pore_pressure" in chosen and "softening" in name)


@pytest.mark.parametrize("chosen", COMBINATIONS, ids="+".join)
def test_equal_to_the_full_balance_with_the_absent_parameters_at_zero(chosen: tuple[str, ...]) -> None:
    rng = np.random.default_rng(5)
    served, full = COMBINATIONS[chosen].functions, COMBINATIONS[FULL].functions
    still = COMBINATIONS[tuple(e for e in FULL if e not in NOT_ALONE)].functions
    known = sorted({a for n in (*full.values(), still["energy"]) for a in ARGUMENTS[n]} - {"x"})
    values: dict[str, np.ndarray] = {a: rng.uniform(0.1, 2.0, 500) for a in known}
    values["k_v"] = rng.uniform(-0.4, 0.05, 500)  # what presses stays away from zero
    values["pore_ratio"], values["x"] = rng.uniform(0.0, 0.9, 500), rng.uniform(0.0, 3.0, 500)
    neutral = values | {s: np.zeros(500) for s in gone_with(chosen)}
    for what in WHATS:
        if (what == "tilt" and "rotation" not in chosen) or (what == "fall" and "shaking" not in chosen):
            continue  # no such thing, or no other than what is given
        expected = function(full[what])(*[neutral[a] for a in ARGUMENTS[full[what]]])
        if what not in served:
            assert not np.any(expected), what
            continue
        found = function(served[what])(*[values[a] for a in ARGUMENTS[served[what]]])
        # Sums may be ordered otherwise: the terms are all of order one.
        scale = np.abs(np.asarray(expected)) + (4.0 if what != "limit_friction" else np.abs(full_terms(neutral)))
        assert np.all(np.abs(found - expected) <= 8 * EPS * scale), what
    if "energy" in served:
        gone = {a: np.zeros(500) for a in ("brake", "constant") if a not in served}
        expected = function(still["energy"])(*[{**values, **gone}[a] for a in ARGUMENTS[still["energy"]]])
        found = function(served["energy"])(*[values[a] for a in ARGUMENTS[served["energy"]]])
        np.testing.assert_allclose(found, expected, rtol=0, atol=300 * EPS)


def full_terms(values: Mapping[str, np.ndarray]) -> np.ndarray:
    """Sizes of the limit friction's terms, over its denominator."""
    water = values["level"] * (values["pore_pressure"] + values["excess"])
    pressed = values["press"] * (1 + np.abs(values["k_v"])) + values["k_h"] * values["press_slope"] + water
    below = (1 - values["k_v"] - values["pore_ratio"]) * values["press"] + values["k_h"] * values["press_slope"] - water
    above = values["press"] * values["static_limit"] * (1 + np.abs(values["k_v"]))
    above += values["k_h"] * values["fall_slope"] + values["level"] * values["cohesion"]
    return np.asarray(above / np.abs(below) * (1 + pressed / np.abs(below)))


def test_softening_variants_agree_where_they_meet() -> None:
    rng = np.random.default_rng(6)
    widest = "energy_softening_constant_water"
    values = {a: rng.uniform(0.1, 2.0, 500) for a in ARGUMENTS[widest]}
    zero = np.zeros(500)
    for name, gone in (
        ("energy_softening_constant", {"water": zero}),
        ("energy_softening", {"water": zero, "constant": zero}),
        ("energy_constant", {"drop": zero}),
        ("energy", {"drop": zero, "constant": zero}),
    ):
        expected = function(widest)(*[{**values, **gone}[a] for a in ARGUMENTS[widest]])
        found = function(name)(*[values[a] for a in ARGUMENTS[name]])
        np.testing.assert_allclose(found, expected, rtol=0, atol=100 * EPS)


def test_the_file_stays_readable() -> None:
    for module in (balance, inspect.getmodule(COMBINATIONS[()].__class__)):
        assert module is not None
        assert len(Path(str(module.__file__)).read_text("utf-8").splitlines()) < 2000


# --- proofs --------------------------------------------------------------------------------------------------------


def test_the_energies_are_proved() -> None:
    assert len(phase.prove_energies()) == 2 * len(phase.ENERGIES)


@pytest.mark.parametrize("index", range(len(phase.ENERGIES)), ids=lambda k: phase.ENERGIES[k].name)
def test_a_wrong_energy_is_not_proved(index: int, monkeypatch: pytest.MonkeyPatch) -> None:
    right = phase.ENERGIES[index]
    for wrong in (
        right.form.subs(phase.TILT, -phase.TILT),
        right.form + sp.Rational(1, 10**9) * phase.X**2,
        right.form.subs(phase.CONSTANT, 2 * phase.CONSTANT),
    ):
        monkeypatch.setattr(phase, "ENERGIES", (replace(right, form=wrong),))
        with pytest.raises(ProofError, match=right.name):
            phase.prove_energies()


# --- friction laws -------------------------------------------------------------------------------------------------

COEFFICIENTS: dict[str, Callable[[mpf, mpf, mpf, mpf], mpf]] = {
    "exponential": lambda s, peak, rest, length: rest + (peak - rest) * mpmath.exp(-s / length),
    "linear": lambda s, peak, rest, length: peak + (rest - peak) * min(s / length, mpf(1)),
    "hyperbolic": lambda s, peak, rest, length: rest + (peak - rest) / (1 + s / length),
}


@pytest.mark.parametrize("name", COEFFICIENTS)
def test_friction_and_its_fall(name: str) -> None:
    """Against the definition at 60 digits: the fall over a slip however small has full relative accuracy."""
    assert name in LAWS
    rng = np.random.default_rng(9)
    for _ in range(400):
        length, peak, rest = 10 ** rng.uniform(-12, 12), rng.uniform(0.0, 1.5), rng.uniform(0.0, 1.5)
        slip = rng.choice([0.0, length * 10 ** rng.uniform(-9, 1)])
        more = length * 10 ** rng.uniform(-15, 4)
        with mpmath.workdps(80):
            exact = [mpf(float(v)) for v in (slip, peak, rest, length)]
            mu = COEFFICIENTS[name](*exact)
            fall = mu - COEFFICIENTS[name](exact[0] + mpf(more), *exact[1:])
            found = mpf(float(function(f"friction_{name}")(slip, peak, rest, length)))
            dropped = mpf(float(function(f"drop_{name}")(slip, more, peak, rest, length)))
            assert abs(found - mu) <= 4 * EPS * (peak + rest)
            if name == "linear":  # its kink takes a difference, of a length
                assert abs(dropped - fall) <= 4 * EPS * abs(peak - rest) * min(1.0, (slip + more) / length) + 1e-320
            else:
                assert abs(dropped - fall) <= 16 * EPS * abs(fall) * (1 + slip / length) + 1e-300


# --- energies ------------------------------------------------------------------------------------------------------

ENERGY_NAMES = [n for n in ARGUMENTS if n.startswith("energy")]


def parts(values: Mapping[str, float]) -> list[mpf]:
    """The terms of E, each the solution of the linear equation with one term on its right-hand side."""
    v = {k: mpf(a) for k, a in values.items()}
    x, q, p = v["x"], 2 * v.get("brake", mpf(0)), v.get("decay", mpf(1))
    digits = 60 + int(4 * sum(abs(mpmath.log10(abs(a))) for a in (x, q or 1, p)))
    with mpmath.workdps(digits):
        left = mpmath.exp(-q * x)
        level = (1 - left) / q if q else x
        cos = (q * mpmath.cos(x) + mpmath.sin(x) - q * left) / (1 + q * q)
        sin = (q * mpmath.sin(x) - mpmath.cos(x) + left) / (1 + q * q)
        found = [v["start"] * left, 2 * v["drive"] * cos, -2 * v["tilt"] * sin]
        found.append(2 * v.get("constant", mpf(0)) * (cos - level))
        if "drop" in v:
            gone = mpmath.exp(-p * x)
            with_cos = mpmath.sin(x) - (p + gone * (mpmath.sin(x) - p * mpmath.cos(x))) / (1 + p * p)
            with_sin = 1 - mpmath.cos(x) - (1 - gone * (mpmath.cos(x) + p * mpmath.sin(x))) / (1 + p * p)
            found.append(2 * v["drop"] * v["press"] * with_cos)
            found.append(2 * v["drop"] * v["press_rise"] * with_sin)
            found.append(-2 * v["drop"] * v.get("water", mpf(0)) * (x - (1 - gone) / p))
        return found


def sizes(v: Mapping[str, float]) -> float:
    """What the terms amount to without cancellation: K and the turning of the press as the drive's turning does."""
    x, q = v["x"], 2 * v.get("brake", 0.0)
    reach = min(x, 1 / q) if q > 0.0 else x * np.exp(-q * x)
    turned = abs(v["drive"]) + x * (abs(v["tilt"]) + abs(v.get("constant", 0.0)))
    found = v["start"] * np.exp(-q * x) + 2 * reach * turned
    if "drop" in v:
        pressed = abs(v["press"]) + abs(v["press_rise"]) + abs(v.get("water", 0.0))
        found += 2 * v["drop"] * min(1.0, v["decay"] * x) * x * pressed
    return float(found)


def drawn(name: str, rng: np.random.Generator) -> dict[str, float]:
    values = {a: float(rng.normal()) for a in ARGUMENTS[name]}
    values["x"] = float(min(np.pi, 10 ** rng.uniform(-12, 0.5)) if rng.random() < 0.8 else rng.uniform(0, np.pi))
    values["start"] = float(abs(values["start"]) * rng.choice([0.0, 1.0]))
    if "brake" in values:
        values["brake"] = float(10 ** rng.uniform(-12, 6) if rng.random() < 0.8 else -rng.uniform(0, 20))
    if "drop" in values:
        values["drop"], values["decay"] = abs(values["drop"]), float(10 ** rng.uniform(-9, 15))
    for term in ("drive", "tilt", "constant", "press_rise", "water"):
        if term in values and rng.random() < 0.3:
            values[term] *= 10 ** rng.uniform(-15, 0)
    return values


@pytest.mark.parametrize("name", ENERGY_NAMES)
def test_energies_are_accurate(name: str) -> None:
    """16 ulp of the sum of the terms' sizes: at E = 0 no more can be asked for, and the end needs no more."""
    rng, worst = np.random.default_rng(11), 0.0
    for _ in range(1200):
        values = drawn(name, rng)
        found = float(function(name)(*[np.float64(values[a]) for a in ARGUMENTS[name]]))
        error = abs(mpf(found) - mpmath.fsum(parts(values))) / mpf(sizes(values))
        assert error <= 16 * EPS, (float(error / EPS), values)
        worst = max(worst, float(error / EPS))
    assert worst > 0.1  # it was a test


@pytest.mark.parametrize(("name", "term"), [
    ("energy", "drive"), ("energy", "tilt"), ("energy_constant", "constant"),
    ("energy_softening_constant_water", "water"),
])  # fmt: skip
def test_single_terms_are_relatively_accurate(name: str, term: str) -> None:
    """Alone, at any x: no digit of a term is lost."""
    rng = np.random.default_rng(12)
    for _ in range(300):
        values = drawn(name, rng)
        values = {a: v if a in (term, "x", "drop", "decay") else 0.0 for a, v in values.items()}
        found = float(function(name)(*[np.float64(values[a]) for a in ARGUMENTS[name]]))
        exact = mpmath.fsum(parts(values))
        assert abs(mpf(found) - exact) <= 16 * EPS * abs(exact), values


@pytest.mark.parametrize("name", ENERGY_NAMES)
def test_the_reference_is_what_quadrature_gives(name: str) -> None:
    """E = start exp(-q x) + int exp(-q (x - y)) right(y) dy at 30 digits, on panels fine enough for exp."""
    rng = np.random.default_rng(13)
    for _ in range(6):
        values = drawn(name, rng)
        with mpmath.workdps(45):
            v = {k: mpf(a) for k, a in values.items()}
            x, q, p = v["x"], 2 * v.get("brake", mpf(0)), v.get("decay", mpf(0))

            def right(y: mpf, v: Mapping[str, mpf] = v, x: mpf = x, q: mpf = q, p: mpf = p) -> mpf:
                constant = v.get("constant", mpf(0))
                drive = v["drive"] * mpmath.cos(y) - v["tilt"] * mpmath.sin(y) - 2 * constant * mpmath.sin(y / 2) ** 2
                if p:
                    pressed = v["press"] * mpmath.cos(y) + v["press_rise"] * mpmath.sin(y) - v.get("water", mpf(0))
                    drive -= v["drop"] * mpmath.expm1(-p * y) * pressed
                return 2 * drive * mpmath.exp(-q * (x - y))

            near = [2**k / p for k in range(-1, 60)] if p else []
            far = [x - 2**k / abs(q) for k in range(-1, 60)] if q else []
            panels = sorted({mpf(0), x, *(y for y in (*near, *far) if 0 < y < x)})
            integral = mpmath.quad(right, panels)
            exact = mpmath.fsum(parts(values))
            assert abs(v["start"] * mpmath.exp(-q * x) + integral - exact) <= mpf(10) ** -28 * mpf(sizes(values)), (
                values
            )
