"""Flow programs: operations, fragments and what is joined of them, against the equation of motion as it stands."""

import random
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
import sympy as sp
from flint import arb, arb_series, ctx

from derive.check.proof import ProofError
from derive.declare import effects as declared
from derive.declare.effects import DEGREE, EFFECTS, LAMBDA, LAWS, MU, OMEGA, SLIP, THETA, VALUE, Effect, Law, Parameter
from derive.flow import emit, fragments, operations
from generated import flow, layout, series
from slipcircle.core.flow.build import build_program
from slipcircle.core.flow.link import RESULTS
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


def balls(values: Any) -> list[arb]:
    return [arb(float(x)) for x in values]


@pytest.mark.parametrize("name", operations.OPERATIONS)
def test_numpy_runs_the_table(name: str) -> None:
    """Series arithmetic in balls knows no recurrence."""
    rng, order, lanes = np.random.default_rng(3), 12, 5
    o = operations.OPERATIONS[name]
    r = np.zeros((len(o.results) + len(o.arguments), order + 1, lanes))
    c = np.full((1, lanes), 1.7)
    first = len(o.results)
    r[first:] = rng.uniform(-0.5, 0.5, r[first:].shape)
    if operations.Q in o.arguments:
        r[first] = r[first + 1] * np.arange(order + 1)[:, None]
    op = (name, *range(len(r)), *(0 for _ in o.numbers))
    for n in range(order + 1):
        series.series_ops((op,), r, c, n)
    ctx.prec, ctx.cap = 200, order + 1
    for lane in range(lanes):
        a, b = (arb_series(balls(r[-1 - i, :, lane]), prec=order + 1) for i in (1, 0))
        one = arb_series([arb(1)], prec=order + 1)
        exact: dict[str, tuple[Any, ...]] = {
            "mul": (a * b,), "sqr": (b * b,), "tim": (arb_series([arb(0), *b.derivative().coeffs()], prec=order + 1),),
            "turn": (b.sin(), one - b.cos()), "exp": (b.exp(), b.exp() - one), "rec": (one / (one + b), -b / (one + b)),
            "powers": tuple(b**power for power in range(2, DEGREE + 1)),
            "log": ((one + b).log(),), "pow": ((one + b) ** arb(1.7), (one + b) ** arb(1.7) - one),
        }  # fmt: skip
        for i, wanted in enumerate(exact[name]):
            values = np.array([float(x) for x in wanted.coeffs()])
            size = np.maximum(np.abs(values), np.abs(values[1:]).max())
            assert np.all(np.abs(r[i, :, lane] - values) <= 64 * 2.0**-52 * size)


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


# --- programs --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("case", CASES, ids=str)
def test_program_is_the_equation_of_motion(case: flow_oracle.Case) -> None:
    for seed in range(2):
        assert flow_oracle.difference(case, seed) < flow_oracle.BOUND


def changed(name: str, of: str, change: Callable[[tuple[Any, ...]], tuple[Any, ...]], result: str) -> flow.Fragment:
    """A fragment with one operation changed."""
    fragment = flow.FRAGMENTS[name]
    found = tuple(change(op) if op[1] == result else op for op in getattr(fragment, of))
    assert found != getattr(fragment, of)
    return fragment._replace(scalar=found) if of == "scalar" else fragment._replace(series=found)


@pytest.mark.parametrize(
    ("name", "of", "change", "result"),
    [
        ("rotation", "scalar", lambda op: ("add", *op[1:]), "normal_load_0"),
        ("rotation", "series", lambda op: ("sqr", "vers(x)", "x"), "sin(x)"),
        ("shaking", "scalar", lambda op: ("add", *op[1:]), "shaking.driving"),
        ("balance", "series", lambda op: (*op[:3], op[3][:-1]), "dfriction"),
        ("exponential", "series", lambda op: ("rec", op[1], op[2], op[4]), "exponential.exp2"),
        ("product", "series", lambda op: ("sqr", op[1], op[2]), "drate_mu*dslip_mu"),
    ],
)
def test_a_planted_fault_shows(
    name: str, of: str, change: Any, result: str, fresh: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(flow.FRAGMENTS, name, changed(name, of, change, result))
    case = ("rotation", "centripetal", "shaking"), ("exponential", "rate_weakening"), ("k_h",), ()
    assert not flow_oracle.difference(case, 0) < 1e-3


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


def test_reading_order_and_places(fresh: None) -> None:
    """Every operation comes after what it reads; no cell that lasts is written over; constants are named by value."""
    for case in CASES:
        p = build_program(*case)
        known = {*(register for _, register, _ in p.states)}
        for op, *names in p.series:
            results = names[: RESULTS.get(op, 1)]
            reads = [r for _, r in names[2]] if op == "lin" else [] if op == "ramp" else names[len(results) :]
            reads = reads[:-1] if op == "pow" else reads
            assert {*reads} <= known
            known |= {*results}
        lasting = next(k for k, name in enumerate(p.cells) if name.startswith(("=", "scratch")))
        written = [op[1] for op in p.scalar if op[1] < lasting]
        assert len(written) == len({*written})
        assert p.cells[: len(layout.CELLS)] == layout.CELLS
        assert {p.cells.index(x) for x in p.constants} == {*range(lasting, lasting + len(p.constants))}


# --- declarations ----------------------------------------------------------------------------------------------------


def parameter(name: str) -> Parameter:
    return Parameter(name, "", 0.0, 1e3, "of a test", name, symbol=sp.Symbol(name, real=True), dimensionless=VALUE)


FADING, SCALE, COLLAPSE, DILATION, WIDENING = (sp.Symbol(x, real=True) for x in ("fading", "scale", "collapse",
                                                                            "dilation", "widening"))  # fmt: skip
WIDTH = sp.Symbol("width", real=True)
NEW = (
    # Of slip: cohesion that is lost with the slip. Of speed: a resistance by a power of it.
    Effect("fading_cohesion", "", (parameter("fading"), parameter("scale")), ("slip",), "strength that slip destroys",
           resistance=LAMBDA * FADING * sp.exp(-SLIP / SCALE)),
    Effect("collapse", "", (parameter("collapse"),), ("speed",), "a resistance that saturates",
           resistance=THETA * COLLAPSE * OMEGA / (1 + OMEGA) ** sp.Rational(3, 2)),
    # With a state of its own: dilation opens pores, which lowers their pressure, as long as it goes on.
    Effect("dilatancy", "", (parameter("dilation"), parameter("widening")), ("history",), "shearing opens the pores",
           pressure=-DILATION * WIDTH, states=(WIDTH,), growth=WIDENING * (1 - WIDTH) * MU),
)  # fmt: skip
NEW_LAW = Law("stiffening", "", (parameter("first"), parameter("last")), ("slip",), "rises with a root of the slip",
              sp.Symbol("first", real=True) + sp.Symbol("last", real=True) * sp.root(1 + SLIP, 4))  # fmt: skip


def test_effects_of_slip_of_speed_and_with_a_state_by_declaration_alone(
    fresh: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One of each, and a law: from its declaration to a program that is its equation."""
    space: dict[str, Any] = {"__name__": "declared"}
    exec(emit.module((*EFFECTS, *NEW), (*LAWS, NEW_LAW)), space)
    for name, fragment in space["FRAGMENTS"].items():
        monkeypatch.setitem(flow.FRAGMENTS, name, fragment)
    order = 7
    ctx.prec, ctx.cap = 300, order + 1
    program = build_program(("rotation", *(e.name for e in NEW)), ("stiffening",))
    rng = random.Random(2)
    names = ("driving_moment", "driving_moment_slope", "normal_load", "normal_load_slope", "resistance_factor",
             "polar_moment", "fading", "scale", "collapse", "dilation", "widening",
             "stiffening.first", "stiffening.last", "width", "SLIP", "TIME", "ROTATION")  # fmt: skip
    p = {x: arb(rng.uniform(0.1, 0.9)) for x in names} | {"DIRECTION": arb(1)}
    c = flow_oracle.prologue(program, p)
    now = {"x": arb(0.2), "omega": arb(0.7), "width": arb(0.4)}
    for cell, _, _ in program.states:
        c[cell] = now[program.cells[cell]]
    r = flow_oracle.run(program, c, {}, order)
    x, w, width = start = [arb_series([v], prec=order + 1) for v in now.values()]
    one = arb_series([arb(1)], prec=order + 1)
    for _ in range(order + 1):
        turned = p["ROTATION"] + x
        fall = p["driving_moment"] * turned.cos() - p["driving_moment_slope"] * turned.sin()
        press = p["normal_load"] * turned.cos() - p["normal_load_slope"] * turned.sin()
        mu = p["stiffening.first"] + p["stiffening.last"] * ((one + p["SLIP"] + x).log() / 4).exp()
        normal = press + p["resistance_factor"] * p["dilation"] * width
        net = fall - mu * normal - p["resistance_factor"] * p["fading"] * (-(p["SLIP"] + x) / p["scale"]).exp()
        net = net - p["collapse"] * w / ((one + w) * (one + w).sqrt())
        grown = p["widening"] * (one - width) * mu * w
        x, w, width = (s + rate.integral() for s, rate in zip(start, (w, net, grown), strict=True))
    for name, wanted in (("x", x), ("omega", w), ("width", width)):
        found = r[program.registers.index(name)]
        assert all(abs(a - b) < arb(1e-60) for a, b in zip(found, wanted.coeffs(), strict=False))


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


def test_fragments_say_what_they_are() -> None:
    assert flow.FRAGMENTS.keys() >= {e.name for e in EFFECTS} | {law.name for law in LAWS} | {"balance", "gravity"}
    assert all(f.words for f in flow.FRAGMENTS.values())


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
    ("table", "op", "sign"), [(flow.SERIES_TANGENTS, "turn", "=-1.0"), (flow.CELL_TANGENTS, "mul", "add")]
)
def test_a_wrong_derivative_shows(
    table: dict[str, Any], op: str, sign: str, fresh: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    own, template = table[op]
    wrong = eval(repr(template).replace(sign, {"=-1.0": "=1.0", "add": "sub"}[sign]))
    assert wrong != template
    monkeypatch.setitem(table, op, (own, wrong))
    case = ("rotation", "centripetal", "shaking"), ("exponential", "rate_weakening"), ("k_h",), ()
    assert not flow_oracle.tangent_difference(case, 0) < 1e-3


@pytest.mark.parametrize(
    ("effects", "laws", "moving", "departed"),
    [
        ((), ("exponential",), (), None),
        (("cohesion", "drag"), ("prescribed",), (), None),
        (("rotation", "centripetal"), ("constant",), (), "ROTATION"),
        (("rotation", "shaking"), ("constant",), ("k_h",), "TIME"),
        (("thermal_pressurisation",), ("constant",), (), "TIME"),
        (("shaking",), ("constant",), (), None),
    ],
)
def test_the_limit_friction_is_used_as_long_as_it_is_that_of_the_start(
    effects: tuple[str, ...], laws: tuple[str, ...], moving: tuple[str, ...], departed: str | None
) -> None:
    """Another value of it changes the drive until what it depends on has changed, and never after."""
    ctx.prec = 200
    program = build_program(effects, laws, moving, (), ("energy",))
    start = {"DIRECTION": arb(1), **dict.fromkeys(("driving_moment", "normal_load", "resistance_factor"), arb(1))} | {
        x: arb(0.1) for x in program.cells if x.partition(".")[0] in laws
    }
    for name in (None, "TIME", "ROTATION", "SLIP"):
        cells = start | ({name: arb(0.01)} if name else {})
        one, other = (flow_oracle.prologue(program, cells | {"LIMIT": arb(x)}) for x in (0.5, 0.7))
        drive = program.roles["cell_drive"]
        same = abs(one[drive] - other[drive]) < arb(1e-30)
        assert same == (name is not None and name == departed)


@pytest.mark.parametrize("law", ["exponential", "hyperbolic"])
@pytest.mark.parametrize(("peak", "residual"), [(0.6, 0.1), (0.1, 0.6), (1e9, 0.3), (0.3, 1e9), (0.1 + 2.0**-57, 0.1)])
def test_friction_where_a_phase_begins_keeps_its_digits(law: str, peak: float, residual: float, fresh: None) -> None:
    """The peak itself at no slip, and full accuracy at any: neither form of the law has it everywhere."""
    program = build_program((), (law,))
    slips = np.concatenate([[0.0], np.geomspace(1e-18, 40.0, 200)])
    c = np.zeros((len(program.cells), slips.size))
    given = {f"{law}.peak": peak, f"{law}.residual": residual, f"{law}.length": 0.7, "DIRECTION": 1.0}
    given["normal_load"] = 1.0
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
