"""Flow programs: operations, fragments and what is joined of them, against the equation of motion as it stands."""

import random
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
import sympy as sp
from flint import arb, arb_series, ctx

from derive.check.proof import ProofError
from derive.declare import effects as declared
from derive.declare.effects import EFFECTS, LAWS, MU, OMEGA, SLIP, THETA, VALUE, Effect, Law, Parameter
from derive.flow import emit, fragments, operations
from generated import flow, series
from slipcircle.flow.program import Program, join


@pytest.fixture
def fresh() -> Iterator[None]:
    """No program of a test is left for another."""
    join.cache_clear()
    yield
    join.cache_clear()


@pytest.mark.parametrize("name", operations.OPERATIONS)
def test_a_wrong_recurrence_is_no_theorem(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    right = operations.OPERATIONS[name]
    wrong = operations.Operation(**{**right.__dict__, "step": (right.step[0] * sp.Rational(9, 8), *right.step[1:])})
    monkeypatch.setattr(operations, "OPERATIONS", {name: right})
    assert operations.prove(3) == [f"{name}: {4 - 2 * len(right.numbers)} coefficients"]
    monkeypatch.setattr(operations, "OPERATIONS", {name: wrong})
    with pytest.raises(ProofError, match=name):
        operations.prove(3)


def test_increments_keep_their_digits() -> None:
    """Order 0 of 1 - cos, exp - 1, 1/(1 + z) - 1 and log(1 + z) at a small argument."""
    r = np.zeros((5, 1, 1))
    r[-1] = z = 1e-9
    for name, wanted in (
        ("turn", z * z / 2),
        ("exp", np.expm1(z)),
        ("rec", -z / (1 + z)),
        ("pow", np.expm1(0.5 * np.log1p(z))),
    ):
        o = operations.OPERATIONS[name]
        at = [0, 1, *([3] if operations.Q in o.arguments else []), 4]
        series.series_ops(((name, *at, *(0 for _ in o.numbers)),), r, np.full((1, 1), 0.5), 0)
        assert r[1, 0, 0] == pytest.approx(wanted, rel=1e-15)


def test_a_program_holds_what_its_scene_calls_for_and_nothing_else() -> None:

    def names(p: Program) -> list[str]:
        return [op[0] for op in p.series]

    frozen = join((), ("constant",))
    assert names(frozen) == ["lin"]
    assert frozen.series[0][3] == ()
    assert frozen.roles["normal"] == frozen.roles["upright"] == -1
    turning = join(("rotation", "centripetal"), ("constant",))
    assert sorted(names(turning)) == ["lin"] * 3 + ["sqr", "tim", "turn"]
    water = join(("rotation", "pore_pressure"), ("constant",), absent=("pore_pressure", "pore_ratio"))
    dry = join(("rotation",), ("constant",))
    assert (names(water), sorted(op[0] for op in water.scalar)) == (names(dry), sorted(op[0] for op in dry.scalar))
    one = join(("rotation", "shaking"), ("constant",), moving=("k_h",), absent=("k_v",))
    both = join(("rotation", "shaking"), ("constant",), moving=("k_h", "k_v"))
    assert (names(one).count("mul"), names(both).count("mul")) == (2, 4)


def parameter(name: str) -> Parameter:
    return Parameter(name, "", 0.0, 1e3, "of a test", name, symbol=sp.Symbol(name, real=True), dimensionless=VALUE)


COLLAPSE, DILATION, WIDENING, WIDTH = (sp.Symbol(x, real=True) for x in ("collapse", "dilation", "widening", "width"))
NEW = (
    Effect("collapse", "", (parameter("collapse"),), ("speed",), "a resistance that saturates",
           resistance=THETA * COLLAPSE * OMEGA / (1 + OMEGA) ** sp.Rational(3, 2)),
    # With a state of its own: dilation opens pores, which lowers their pressure, as long as it goes on.
    Effect("dilatancy", "", (parameter("dilation"), parameter("widening")), ("history",), "shearing opens the pores",
           pressure=-DILATION * WIDTH, given=(WIDTH,), growth=WIDENING * (1 - WIDTH) * MU),
)  # fmt: skip
NEW_LAW = Law("stiffening", "", (parameter("first"), parameter("last")), ("slip",), "rises with a root of the slip",
              sp.Symbol("first", real=True) + sp.Symbol("last", real=True) * sp.root(1 + SLIP, 4))  # fmt: skip


def test_effects_of_speed_and_with_a_state_by_declaration_alone(fresh: None, monkeypatch: pytest.MonkeyPatch) -> None:
    """One of each, and a law: from its declaration to a program that is its equation."""
    space: dict[str, Any] = {"__name__": "declared"}
    exec(emit.module((*EFFECTS, *NEW), (*LAWS, NEW_LAW)), space)
    for name, fragment in space["FRAGMENTS"].items():
        monkeypatch.setitem(flow.FRAGMENTS, name, fragment)
    order = 7
    ctx.prec, ctx.cap = 120, order + 1
    program = join(("rotation", *(e.name for e in NEW)), ("stiffening",))
    rng = random.Random(2)
    names = ("fall", "fall_slope", "press", "press_slope", "level", "polar", "collapse", "dilation", "widening",
             "stiffening.first", "stiffening.last", "width", "SLIP", "TIME", "ROTATION")  # fmt: skip
    given = {x: rng.uniform(0.1, 0.9) for x in names} | {"DIRECTION": 1.0} | dict(program.constants)
    c = np.array([[given.get(x, 0.0)] for x in program.cells])
    series.scalar_ops(program.scalar, c)
    now, r = {"x": 0.2, "omega": 0.7, "width": 0.4}, np.zeros((len(program.registers), order + 1, 1))
    for cell, register, _ in program.states:
        r[register, 0] = now[program.cells[cell]]
    for n in range(order):
        series.series_ops(program.series, r, c, n)
        for _, register, rate in program.states:
            r[register, n + 1] = r[rate, n] / (n + 1)
    p = {name: arb(value) for name, value in given.items()}
    x, w, width = start = [arb_series([arb(v)], prec=order + 1) for v in now.values()]
    one = arb_series([arb(1)], prec=order + 1)
    for _ in range(order + 1):
        turned = p["ROTATION"] + x
        fall = p["fall"] * turned.cos() - p["fall_slope"] * turned.sin()
        press = p["press"] * turned.cos() - p["press_slope"] * turned.sin()
        mu = p["stiffening.first"] + p["stiffening.last"] * ((one + p["SLIP"] + x).log() / 4).exp()
        normal = press + p["level"] * p["dilation"] * width
        net = fall - mu * normal - p["collapse"] * w / ((one + w) * (one + w).sqrt())
        grown = p["widening"] * (one - width) * mu * w
        x, w, width = (s + rate.integral() for s, rate in zip(start, (w, net, grown), strict=True))
    for name, wanted in (("x", x), ("omega", w), ("width", width)):
        found = r[program.registers.index(name), :, 0]
        assert found == pytest.approx([float(v) for v in wanted.coeffs()][: order + 1], rel=1e-12, abs=1e-13), name


def test_a_parameter_knows_its_sign_in_a_mirror() -> None:
    signs = {e.name: {str(x) for x in fragments.odd(e)} for e in EFFECTS}
    assert {name: found for name, found in signs.items() if found} == {"shaking": {"k_h"}}
    k = sp.Symbol("k", real=True)
    lopsided = Effect("lopsided", "", (parameter("k"),), (), "both ways at once", fall=k * THETA * declared.FALL_SLOPE,
                      press=k * declared.J_R)  # fmt: skip
    with pytest.raises(ValueError, match="lopsided: no signs of its parameters"):
        fragments.odd(lopsided)


def test_what_has_no_operation_is_refused() -> None:
    strange = Effect("strange", "", (parameter("k"),), (), "no recurrence", resistance=THETA * sp.besselj(0, SLIP))
    with pytest.raises(ValueError, match="no operation on series for besselj"):
        fragments.of_effect(strange)


@pytest.mark.parametrize("law", ["exponential", "hyperbolic"])
@pytest.mark.parametrize(("peak", "residual"), [(0.6, 0.1), (0.1, 0.6), (1e9, 0.3), (0.3, 1e9), (0.1 + 2.0**-57, 0.1)])
def test_friction_where_a_phase_begins_keeps_its_digits(law: str, peak: float, residual: float, fresh: None) -> None:
    """The peak itself at no slip, and full accuracy at any: neither form of the law has it everywhere."""
    program = join((), (law,))
    slips = np.concatenate([[0.0], np.geomspace(1e-18, 40.0, 200)])
    c = np.zeros((len(program.cells), slips.size))
    given = {f"{law}.peak": peak, f"{law}.residual": residual, f"{law}.length": 0.7, "DIRECTION": 1.0, "press": 1.0}
    for name, value in {**given, **program.constants}.items():
        c[program.cells.index(name)] = value
    c[program.cells.index("SLIP")] = slips
    series.scalar_ops(program.scalar, c)
    found = c[program.roles["cell_mu"]]
    assert found[0] == peak
    ctx.prec = 200
    for slip, value in zip(slips, found, strict=True):
        s = arb(float(slip)) / arb(0.7)
        exact = arb(residual) + (arb(peak) - arb(residual)) * ((-s).exp() if law == "exponential" else 1 / (1 + s))
        # What the slip's own rounding changes is no fault of the formula's.
        own = float(abs(exact - arb(residual)) * (s if law == "exponential" else 1)) * 2.0**-51
        assert abs(float(arb(float(value)) - exact)) <= 4 * 2.0**-53 * float(exact) + own
