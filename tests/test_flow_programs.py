"""Flow programs: operations, fragments and what is joined of them; `test_combinations` solves their motions."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import starmap
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp

from derive.algebra import prove
from derive.check.proof import ProofError
from derive.declare import effects as declared
from derive.declare.effects import EFFECTS, LAWS, SLIP, THETA, Effect, Parameter
from derive.flow import fragments, link, linked, recurrences
from derive.flow.link import definitions, linker, program, soils
from derive.flow.link.definitions import ONE, ZERO
from generated import series
from generated.flow import OnSeries
from slipcircle.base.kinds import Floats
from tests.support import combinations
from tests.support.lanes import Program, Recipe, build_program


@pytest.fixture
def fresh() -> Iterator[None]:
    """No program of a test is left for another."""
    build_program.cache_clear()
    yield
    build_program.cache_clear()


# --- operations ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", recurrences.OPERATIONS)
def test_a_wrong_recurrence_is_no_theorem(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    right = recurrences.OPERATIONS[name]
    wrong = recurrences.SeriesOperation(
        **{**right.__dict__, "step": (right.step[0] * sp.Rational(9, 8), *right.step[1:])}
    )
    monkeypatch.setattr(recurrences, "OPERATIONS", {name: right})
    assert recurrences.prove(3) == [f"{name}: 4 coefficients"]
    monkeypatch.setattr(recurrences, "OPERATIONS", {name: wrong})
    with pytest.raises(ProofError, match=name):
        recurrences.prove(3)


@pytest.mark.parametrize(
    ("name", "wanted"), [("turn", 5e-19), ("exp", np.expm1(1e-9)), ("rec", -1e-9 / (1 + 1e-9)), ("log", np.log1p(1e-9))]
)
def test_increments_keep_their_digits(name: str, wanted: float) -> None:
    """Order 0 of 1 - cos, exp - 1, 1/(1 + z) - 1 and log(1 + z) at a small argument."""
    r = np.zeros((5, 1, 1))
    r[-1] = 1e-9
    o = recurrences.OPERATIONS[name]
    arguments = (3, 4) if recurrences.Q in o.arguments else (4,)
    results = (0, 1)[-len(o.results) :]
    series.series_ops([OnSeries(name, results, arguments)], r, np.zeros((0, 1)), 0)
    assert r[1, 0, 0] == pytest.approx(wanted, rel=1e-15)


LINEAR = next(law for law in LAWS if law.name == "linear")
CENTRIPETAL = next(e for e in EFFECTS if e.name == "centripetal")
SOME = tuple(e for e in EFFECTS if e.name in ("rotation", "centripetal", "cohesion", "pore_pressure", "shaking"))


def test_a_wrong_sign_is_not_the_equation_of_motion() -> None:
    """Linked programs are proved to be (3.11), which is derived elsewhere from the balance laws."""
    assert len(linked.prove((CENTRIPETAL,), (LAWS[0], LINEAR))) == 42
    wrong = replace(CENTRIPETAL, stress=-CENTRIPETAL.stress)
    with pytest.raises(ProofError, match=r"\(3.11\), centripetal, constant, direction 1, at the start"):
        linked.prove((wrong,), LAWS[:1])


def flat_without_factors(self: Any, operation: Any, factor: str) -> Iterator[tuple[str, str]]:
    """Terms of inner sums, without the factors of these sums."""
    yield from ((cell, register) for cell, register in FLAT(self, operation, ONE) if factor)


def placed_without_pairs(operation: Any, places: Any) -> Any:
    """Return sums whose registers are sorted without their factors."""
    placed = PLACED(operation, places)
    return placed._replace(cells=(*placed.cells[:1], *placed.cells[:0:-1]))


def softening_without_term(known: Any, name: str, turns: bool) -> list[Any]:
    """Return a softening cohesion that resists nothing."""
    parts = OF_SOILS(known, name, turns)
    return [part._replace(adds={}) for part in parts] if name.startswith("softening_cohesion") else parts


def softening_by_friction(known: Any, name: str, turns: bool) -> list[Any]:
    """Return a softening cohesion that follows the law of friction."""
    if name != "linear#c":
        return OF_SOILS(known, name, turns)
    return [known["constant"]._replace(adds={"cohesion_law#c": known["constant"].adds["mu"]})]


NUMBERED = soils._numbered
OF_SOILS = soils.fragments_of
FLAT, PLACED, SIMPLIFIED = linker.Linker._flat, program._placed, linker._simplified
# Faults of the linker, each in the place of one of its functions.
FAULTS = {
    "factors of inner sums are lost": (linker.Linker, "_flat", flat_without_factors),
    "factors change places": (program, "_placed", placed_without_pairs),
    "a product with one is one": (
        linker,
        "_simplified",
        lambda kind, operands: ONE if kind == "mul" and ONE in operands else SIMPLIFIED(kind, operands),
    ),
    "the limit friction of the start is used later": (definitions, "_departed", lambda _: ("set", ZERO)),
    "a quantity has the first addend alone": (
        definitions,
        "_define_sum",
        lambda made, name, addends: made.cells.update({name: ("set", (*addends, ZERO)[0])}),
    ),
    "soils have the numbers of one": (
        soils,
        "_numbered",
        lambda known, name, number: NUMBERED(known, name, number.replace("1", "0")),
    ),
    "layers lose their pore pressure": (
        link,
        "fragments_of",
        lambda known, name, turns: [
            part._replace(adds=part.adds | {"lifting": part.adds["pressing"]}) if name == "layered_strength" else part
            for part in OF_SOILS(known, name, turns)
        ],
    ),
    "the term of a softening cohesion is lost": (link, "fragments_of", softening_without_term),
    "cohesion follows the law of friction": (link, "fragments_of", softening_by_friction),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_of_the_linker_is_not_the_equation_of_motion(fault: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(*FAULTS[fault])
    of_soils = fault.startswith(("soils", "layers"))
    cases = [
        (effects, laws)
        for effects, laws in linked.cases((CENTRIPETAL,) if of_soils else SOME, (LAWS[0], LINEAR))
        if of_soils == (declared.SECTION_EFFECTS[0] in effects or laws[0].name == "constant#0")
    ]
    with pytest.raises(ProofError, match=r"\(3.11\)"):
        list(starmap(linked.prove_case, reversed(cases)))


def test_a_law_with_fractional_powers_is_in_the_equation_of_motion() -> None:
    """Roots are taken apart in the proof, which still sees a wrong power."""
    length, peak, residual = sp.symbols("length peak residual", real=True)
    for power in (sp.Rational(1, 2), sp.Rational(3, 2)):
        law = replace(LINEAR, name="root", coefficient=residual + (peak - residual) / (1 + SLIP / length) ** power)
        assert len(linked.prove_case((CENTRIPETAL,), (law,))) == 6
    x = sp.Symbol("x", real=True)
    prove.prove_rational(
        x * sp.sqrt(1 + x / length) + length * sp.sqrt(1 + x / length) - length * (1 + x / length) ** power, ""
    )
    with pytest.raises(ProofError, match="wrong power"):
        prove.prove_rational(sp.sqrt(1 + x / length) - (1 + x / length) ** power, "wrong power")


def test_rational_functions_are_proved_with_their_denominators(monkeypatch: pytest.MonkeyPatch) -> None:
    """Identities are proved by polynomials alone, without the simplification that follows where they are not zero."""
    x, y = sp.symbols("x y", real=True)
    for wrong in (1 / (x - y) + 1 / (x + y), (x - y) / (x + y) - 1, sp.Integer(3)):
        with pytest.raises(ProofError, match="wrong"):
            prove.prove_rational(wrong, "wrong")
    monkeypatch.setattr(prove, "prove_zero", lambda *_: pytest.fail("not zero"))
    prove.prove_rational(1 / (x - y) - 1 / (x + y) - 2 * y / (x**2 - y**2) + x / 3 - 2 * x / 6, "")
    prove.prove_rational((x - y) / sp.exp(-2 * x - y) - (x - y) * sp.exp(y) * sp.exp(2 * x), "")
    for meaningless in (x / ((x + y) ** 2 - x**2 - 2 * x * y - y**2), sp.pi * x):
        with pytest.raises(ProofError, match="found"):
            prove.prove_rational(meaningless, "")


# --- programs --------------------------------------------------------------------------------------------------------


def cells_at(program: Program, given: Mapping[str, float]) -> Floats:
    """Return all cells where a phase begins."""
    cells = np.zeros((len(program.cells), 1))
    known = {**program.constants, **given}
    for name in known.keys() & program.places.keys():
        cells[program.places[name]] = known[name]
    series.scalar_ops(program.scalar, cells)
    return cells


def test_sums_add_terms_in_the_order_in_which_they_are_ready() -> None:
    """Terms are in the order of registers: last bits depend neither on names nor on the integrator."""
    for effects in combinations.ALL:
        sums = [op for op in build_program(Recipe(effects, ("exponential",)), ("energy",)).series if op.kind == "lin"]
        for op in sums:
            assert list(op.registers) == sorted(set(op.registers)), effects


def test_a_program_holds_what_its_scene_calls_for_and_nothing_else() -> None:

    def names(p: Program) -> list[str]:
        return [op[0] for op in p.series]

    frozen = build_program(Recipe((), ("constant",)))
    assert names(frozen) == ["lin"]
    assert frozen.series[0].registers == ()
    assert frozen.roles["normal"] == frozen.roles["upright"] == -1
    turning = build_program(Recipe(("rotation", "centripetal"), ("constant",)))
    assert sorted(names(turning)) == ["lin"] * 3 + ["sqr", "tim", "turn"]
    absent = tuple(str(x) for e in EFFECTS if e.name == "pore_pressure" for x in e.symbols)
    water = build_program(Recipe(("rotation", "pore_pressure"), ("constant",), absent=absent))
    dry = build_program(Recipe(("rotation",), ("constant",)))
    assert (names(water), sorted(op[0] for op in water.scalar)) == (names(dry), sorted(op[0] for op in dry.scalar))
    one = build_program(Recipe(("rotation", "shaking"), ("constant",), moving=("k_h",), absent=("k_v",)))
    both = build_program(Recipe(("rotation", "shaking"), ("constant",), moving=("k_h", "k_v")))
    assert (names(one).count("mul"), names(both).count("mul")) == (2, 4)


# --- declarations ----------------------------------------------------------------------------------------------------


def parameter(name: str) -> Parameter:
    return Parameter(name, "", "of a test", name, sp.Symbol(name, real=True))


def test_a_parameter_knows_its_sign_in_a_mirror() -> None:
    signs = {e.name: {str(x) for x in fragments.odd(e)} for e in EFFECTS}
    assert {name: found for name, found in signs.items() if found} == {
        "shaking": {"k_h"},
        "pore_pressure": {"standing_water"},
    }
    k = sp.Symbol("k", real=True)
    lopsided = Effect("lopsided", "both ways at once", (parameter("k"),),
                      driving_moment=k * THETA * declared.DRIVING_MOMENT_SLOPE,
                      normal_load=k * declared.J_R)  # fmt: skip
    with pytest.raises(ProofError, match="lopsided: signs of its parameters"):
        fragments.odd(lopsided)


def test_what_has_no_operation_is_refused() -> None:
    strange = Effect("strange", "no recurrence", (parameter("k"),), resistance=THETA * sp.besselj(0, SLIP))
    with pytest.raises(ProofError, match="strange: operation on series: found besselj"):
        fragments.effect_fragment(strange)


@pytest.mark.parametrize("law", ["exponential", "hyperbolic"])
@pytest.mark.parametrize(("peak", "residual"), [(0.6, 0.1), (0.1, 0.6), (1e9, 0.3), (0.3, 1e9), (0.1 + 2.0**-57, 0.1)])
def test_friction_where_a_phase_begins_keeps_its_digits(law: str, peak: float, residual: float) -> None:
    """The peak itself at no slip, and full accuracy at any: neither form of the law has it everywhere."""
    program = build_program(Recipe((), (law,)))
    law_numbers = {f"{law}.peak": peak, f"{law}.residual": residual, f"{law}.length": 0.7}
    for slip in (0.0, *np.geomspace(1e-18, 40.0, 200).tolist()):
        given = {**law_numbers, "DIRECTION": 1.0, "normal_load": 1.0, "SLIP": slip}
        friction = cells_at(program, given)[program.roles["cell_mu"], 0]
        with mpmath.workdps(60):
            lengths = mpmath.mpf(slip) / mpmath.mpf(0.7)
            share = mpmath.exp(-lengths) if law == "exponential" else 1 / (1 + lengths)
            exact = residual + (mpmath.mpf(peak) - residual) * share
            # What the slip's own rounding changes is no fault of the formula's.
            of_slip = abs(exact - residual) * (lengths if law == "exponential" else 1) * 2.0**-51
            assert abs(friction - exact) <= (4 * 2.0**-53 * exact + of_slip if slip else 0.0)


def test_the_limit_friction_of_a_frozen_slope_stays_that_of_the_start() -> None:
    """The limit friction stays the value of the start; the balance of a later moment would lose digits."""
    program = build_program(Recipe((), ("exponential",)))
    given = dict.fromkeys(("DIRECTION", "driving_moment", "normal_load", "resistance_factor", "TIME"), 1.0)
    given |= {f"exponential.{name}": 0.1 for name in ("peak", "residual", "length")}
    drives = [cells_at(program, given | {"LIMIT": x})[program.roles["cell_drive"], 0] for x in (0.5, 0.7)]
    assert drives == pytest.approx([0.4, 0.6], rel=1e-15)
