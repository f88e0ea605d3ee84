"""Flow programs: operations, fragments and what is joined of them, against the equation of motion as it stands."""

import random
from collections.abc import Iterator
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import arb, arb_series, ctx

from derive.check.proof import ProofError
from derive.declare import effects as declared
from derive.declare.effects import DEGREE, EFFECTS, SLIP, THETA, VALUE, Effect, Parameter
from derive.flow import fragments, operations
from generated import series
from slipcircle.core.flow.build import build_program
from slipcircle.core.flow.program import Program
from tests.campaigns import flow_oracle

CASES = random.Random(7).sample(list(flow_oracle.cases()), 60)


@pytest.fixture
def fresh() -> Iterator[None]:
    """No program of a test is left for another."""
    build_program.cache_clear()
    yield
    build_program.cache_clear()


# --- operations ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", operations.OPERATIONS)
def test_a_wrong_recurrence_is_no_theorem(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    right = operations.OPERATIONS[name]
    wrong = operations.Operation(**{**right.__dict__, "step": (right.step[0] * sp.Rational(9, 8), *right.step[1:])})
    monkeypatch.setattr(operations, "OPERATIONS", {name: right})
    assert operations.prove(3) == [f"{name}: {4 - 2 * len(right.numbers)} coefficients"]
    monkeypatch.setattr(operations, "OPERATIONS", {name: wrong})
    with pytest.raises(ProofError, match=name):
        operations.prove(3)


@pytest.mark.parametrize("name", operations.OPERATIONS)
def test_numpy_runs_the_table(name: str) -> None:
    """Series arithmetic in balls knows no recurrence."""
    rng, order, lanes = np.random.default_rng(3), 12, 5
    o = operations.OPERATIONS[name]
    first = len(o.results)
    r = np.zeros((first + len(o.arguments), order + 1, lanes))
    r[first:] = rng.uniform(-0.5, 0.5, r[first:].shape)
    if operations.Q in o.arguments:
        r[first] = r[first + 1] * np.arange(order + 1)[:, None]
    op = (name, *range(len(r)), *(0 for _ in o.numbers))
    for n in range(order + 1):
        series.series_ops((op,), r, np.full((1, lanes), 1.7), n)
    ctx.prec, ctx.cap = 200, order + 1
    for lane in range(lanes):
        a, b = (arb_series([arb(float(x)) for x in r[-1 - i, :, lane]]) for i in (1, 0))
        exact: dict[str, tuple[Any, ...]] = {
            "mul": (a * b,), "sqr": (b * b,), "tim": (arb_series([0, *b.derivative().coeffs()]),),
            "turn": (b.sin(), 1 - b.cos()), "exp": (b.exp(), b.exp() - 1), "rec": (1 / (1 + b), -b / (1 + b)),
            "powers": tuple(b**power for power in range(2, DEGREE + 1)),
            "log": ((1 + b).log(),), "pow": ((1 + b) ** arb(1.7), (1 + b) ** arb(1.7) - 1),
        }  # fmt: skip
        for i, wanted in enumerate(exact[name]):
            values = np.array([float(x) for x in wanted.coeffs()])
            size = np.maximum(np.abs(values), np.abs(values[1:]).max())
            assert np.all(np.abs(r[i, :, lane] - values) <= 64 * 2.0**-52 * size)


@pytest.mark.parametrize(
    ("name", "wanted"),
    [("turn", 5e-19), ("exp", np.expm1(1e-9)), ("rec", -1e-9 / (1 + 1e-9)), ("pow", np.expm1(0.5 * np.log1p(1e-9)))],
)
def test_increments_keep_their_digits(name: str, wanted: float) -> None:
    """Order 0 of 1 - cos, exp - 1, 1/(1 + z) - 1 and (1 + z)^0.5 - 1 at a small argument."""
    r = np.zeros((5, 1, 1))
    r[-1] = 1e-9
    o = operations.OPERATIONS[name]
    places = [0, 1, *([3] if operations.Q in o.arguments else []), 4]
    series.series_ops(((name, *places, *(0 for _ in o.numbers)),), r, np.full((1, 1), 0.5), 0)
    assert r[1, 0, 0] == pytest.approx(wanted, rel=1e-15)


# --- programs --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("case", CASES, ids=str)
def test_program_is_the_equation_of_motion(case: flow_oracle.Case) -> None:
    for seed in range(2):
        assert flow_oracle.difference(case, seed) < flow_oracle.BOUND


def test_a_program_holds_what_its_scene_calls_for_and_nothing_else() -> None:

    def names(p: Program) -> list[str]:
        return [op[0] for op in p.series]

    frozen = build_program((), ("constant",))
    assert names(frozen) == ["lin"]
    assert frozen.series[0][3] == ()
    assert frozen.roles["normal"] == frozen.roles["upright"] == -1
    turning = build_program(("rotation", "centripetal"), ("constant",))
    assert sorted(names(turning)) == ["lin"] * 3 + ["sqr", "tim", "turn"]
    water = build_program(("rotation", "pore_pressure"), ("constant",), absent=("pore_pressure", "pore_ratio", "water"))
    dry = build_program(("rotation",), ("constant",))
    assert (names(water), sorted(op[0] for op in water.scalar)) == (names(dry), sorted(op[0] for op in dry.scalar))
    one = build_program(("rotation", "shaking"), ("constant",), moving=("k_h",), absent=("k_v",))
    both = build_program(("rotation", "shaking"), ("constant",), moving=("k_h", "k_v"))
    assert (names(one).count("mul"), names(both).count("mul")) == (2, 4)


# --- declarations ----------------------------------------------------------------------------------------------------


def parameter(name: str) -> Parameter:
    return Parameter(name, "", 0.0, 1e3, "of a test", name, symbol=sp.Symbol(name, real=True), dimensionless=VALUE)


def test_a_parameter_knows_its_sign_in_a_mirror() -> None:
    signs = {e.name: {str(x) for x in fragments.odd(e)} for e in EFFECTS}
    assert {name: found for name, found in signs.items() if found} == {"shaking": {"k_h"}}
    k = sp.Symbol("k", real=True)
    lopsided = Effect("lopsided", "", (parameter("k"),), (), "both ways at once",
                      driving_moment=k * THETA * declared.DRIVING_MOMENT_SLOPE,
                      normal_load=k * declared.J_R)  # fmt: skip
    with pytest.raises(ValueError, match="lopsided: no signs of its parameters"):
        fragments.odd(lopsided)


def test_what_has_no_operation_is_refused() -> None:
    strange = Effect("strange", "", (parameter("k"),), (), "no recurrence", resistance=THETA * sp.besselj(0, SLIP))
    with pytest.raises(ValueError, match="no operation on series for besselj"):
        fragments.of_effect(strange)


@pytest.mark.parametrize("case", CASES[:12], ids=str)
def test_energy_is_kept(case: flow_oracle.Case) -> None:
    """The kinetic energy changes by the work less the dissipation, coefficient by coefficient."""
    program, r, _ = flow_oracle.at_a_point(case, 1, ("energy",))
    work, lost, omega = (r[program.registers.index(x)] for x in ("work", "dissipation", "omega"))
    for i in range(1, flow_oracle.ORDER):
        kinetic = sum((omega[k] * omega[i - k] for k in range(i + 1)), arb(0)) / 2
        assert abs(work[i] - lost[i] - kinetic) < arb(1e-60)
    assert abs(work[1]) > arb(1e-9)


@pytest.mark.parametrize("case", CASES[:30], ids=str)
def test_a_program_differentiates_itself(case: flow_oracle.Case) -> None:
    for seed in range(2):
        assert flow_oracle.tangent_difference(case, seed) < 1e-60


@pytest.mark.parametrize(
    ("effects", "law", "moving", "departed"),
    [
        ((), "exponential", (), None),
        (("cohesion", "drag"), "prescribed", (), None),
        (("rotation", "centripetal"), "constant", (), "ROTATION"),
        (("rotation", "shaking"), "constant", ("k_h",), "TIME"),
        (("thermal_pressurisation",), "constant", (), "TIME"),
    ],
)
def test_the_limit_friction_is_used_as_long_as_it_is_that_of_the_start(
    effects: tuple[str, ...], law: str, moving: tuple[str, ...], departed: str | None
) -> None:
    """Another value of it changes the drive until what it depends on has changed, and never after."""
    ctx.prec = 200
    program = build_program(effects, (law,), moving, (), ("energy",))
    start = dict.fromkeys(("DIRECTION", "driving_moment", "normal_load", "resistance_factor"), arb(1))
    start |= {x: arb(0.1) for x in program.cells if x.startswith(f"{law}.")}
    drive = program.roles["cell_drive"]
    for name in ("", "TIME", "ROTATION", "SLIP"):
        cells = start | ({name: arb(0.01)} if name else {})
        one, other = (flow_oracle.prologue(program, cells | {"LIMIT": arb(x)})[drive] for x in (0.5, 0.7))
        assert (abs(one - other) < arb(1e-30)) == (name == departed)


@pytest.mark.parametrize("law", ["exponential", "hyperbolic"])
@pytest.mark.parametrize(("peak", "residual"), [(0.6, 0.1), (0.1, 0.6), (1e9, 0.3), (0.3, 1e9), (0.1 + 2.0**-57, 0.1)])
def test_friction_where_a_phase_begins_keeps_its_digits(law: str, peak: float, residual: float) -> None:
    """The peak itself at no slip, and full accuracy at any: neither form of the law has it everywhere."""
    program = build_program((), (law,))
    slips = np.concatenate([[0.0], np.geomspace(1e-18, 40.0, 200)])
    c = np.zeros((len(program.cells), slips.size))
    law_numbers = {f"{law}.peak": peak, f"{law}.residual": residual, f"{law}.length": 0.7}
    cells: dict[str, Any] = law_numbers | {"DIRECTION": 1.0, "normal_load": 1.0, "SLIP": slips, **program.constants}
    for name, value in cells.items():
        c[program.cells.index(name)] = value
    series.scalar_ops(program.scalar, c)
    found = c[program.roles["cell_mu"]]
    assert found[0] == peak
    with mpmath.workdps(60):
        for slip, value in zip(slips.tolist(), found.tolist(), strict=True):
            s = mpmath.mpf(slip) / mpmath.mpf(0.7)
            share = mpmath.exp(-s) if law == "exponential" else 1 / (1 + s)
            exact = residual + (mpmath.mpf(peak) - residual) * share
            # What the slip's own rounding changes is no fault of the formula's.
            own = abs(exact - residual) * (s if law == "exponential" else 1) * 2.0**-51
            assert abs(value - exact) <= 4 * 2.0**-53 * exact + own
