"""The checker of certificates: its exact functions, its analysis of rounding, what it proves and what it refuses."""

import ast
import math
import pickle
import random
import sys
from collections.abc import Callable
from copy import deepcopy
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import oracle
import pytest
from flint import arb, ctx

from derive.approximate import certificates
from derive.approximate.programs import Variant, variants
from derive.check import certify, proof, records, rounding, table, truth
from derive.check.proof import ProofError
from derive.check.records import Record, digest, read
from derive.check.truth import SEGMENTS, TOP
from derive.code import exact

RECORDS = read()
DEFINITIONS = {r["kernel"]: tuple(r["definition"]) for r in RECORDS}
BASES = [kernel for kernel, definition in DEFINITIONS.items() if len(definition) == 1]
ANGLES = (1e-3, 0.01, 0.2, 0.25, 0.6, 1.0, 1.4, 1.57, TOP - 2.0**-40, TOP - 2.0**-52, TOP)


def find(kernel: str, tier: str = "best", form: str = "fused") -> Record:
    """A certificate as it was written."""
    (found,) = [r for r in RECORDS if (r["kernel"], r["tier"], r["form"]) == (kernel, tier, form)]
    return deepcopy(found)


def variant(record: Record) -> Variant:
    (found,) = [
        v for v in variants() if (v.kernel, v.tier, v.form) == tuple(record[k] for k in ("kernel", "tier", "form"))
    ]
    return found


# --- the exact functions -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kernel", DEFINITIONS)
def test_exact_functions_are_the_integrals_of_the_definition(kernel: str) -> None:
    for alpha in ANGLES:
        with truth.working(200):
            difference = abs(truth.value(DEFINITIONS[kernel], arb(alpha)) / oracle.kernel(kernel, alpha) - 1)
            assert difference.upper() < arb(2) ** -110, alpha


@pytest.mark.parametrize("kernel", BASES)
def test_taylor_models_enclose_the_exact_functions(kernel: str) -> None:
    for segment in SEGMENTS:
        model = truth.kernel(DEFINITIONS[kernel][0], segment)
        for share in (0.0, 0.03, 0.37, 0.5, 0.81, 1.0):
            alpha = segment.lower + share * (segment.upper - segment.lower) or 1e-9
            with truth.working(300):
                found = model(arb(alpha) - segment.centre) * (1 if segment.lower else arb(alpha) ** 3)
                assert found.overlaps(truth.value(DEFINITIONS[kernel], arb(alpha)))
                assert (found.rad() / found).upper() < arb(2) ** -60


def test_segments_cover_the_domain() -> None:
    assert SEGMENTS[0].lower == 0
    assert (SEGMENTS[-1].lower, SEGMENTS[-1].upper) == (TOP, TOP)
    assert SEGMENTS[-2].upper == math.nextafter(TOP, 0.0)  # nothing between it and TOP
    assert all(a.upper == b.lower for a, b in pairwise(SEGMENTS[:-1]))


# --- rounding ------------------------------------------------------------------------------------------------------


def random_program(rng: random.Random) -> list[list[Any]]:
    """Some operations on alpha and constants, among them the patterns that compensate."""
    operations: list[list[Any]] = [["input", [], "alpha"]]

    def put(kind: str, *args: int, value: Any = None) -> int:
        operations.append([kind, list(args), value])
        return len(operations) - 1

    def any_of(n: int) -> list[int]:
        return [rng.randrange(len(operations)) for _ in range(n)]

    for _ in range(3):
        put("const", value=rng.choice([rng.uniform(-2, 2), 0.5, -0.25, 1.0, rng.uniform(1, 1.001)]).hex())
    for _ in range(rng.randrange(2, 14)):
        match rng.choice(["add", "sub", "mul", "mul", "fma", "fma", "neg", "product", "sum", "fast", "div"]):
            case "add" | "sub" | "mul" as kind:
                put(kind, *any_of(2))
            case "fma":
                put("fma", *any_of(3))
            case "neg":
                put("neg", *any_of(1))
            case "div":
                put("div", any_of(1)[0], put("add", put("mul", *any_of(1) * 2), put("const", value=(1.5).hex())))
            case "product":
                a, b = any_of(2)
                put("fma", b, a, put("neg", put("mul", a, b)))
            case "sum":
                a, b, c = any_of(3)
                put("fma", a, b, put("sub", c, put("fma", a, b, c)))
            case "fast":
                a, b = any_of(2)
                s = put("add", a, b)
                put("sub", b, put("sub", s, a))
    put("add", *any_of(2))
    return operations


def in_real_arithmetic(operations: list[list[Any]], alpha: float) -> arb:
    done: list[arb] = []
    for kind, args, value in operations:
        x = [done[a] for a in args]
        match kind:
            case "input":
                done.append(arb(alpha))
            case "const":
                done.append(arb(float.fromhex(value)))
            case "add" | "sub" | "mul" | "div" | "neg":
                call = {"add": "__add__", "sub": "__sub__", "mul": "__mul__", "div": "__truediv__", "neg": "__neg__"}
                done.append(getattr(x[0], call[kind])(*x[1:]))
            case "fma":
                done.append(x[0] * x[1] + x[2])
    return done[-1]


def rounded(operations: list[list[Any]], alpha: float) -> float:
    done: list[float] = []
    for kind, args, value in operations:
        x = [done[a] for a in args]
        match kind:
            case "input":
                done.append(alpha)
            case "const":
                done.append(float.fromhex(value))
            case "add":
                done.append(x[0] + x[1])
            case "sub":
                done.append(x[0] - x[1])
            case "mul":
                done.append(x[0] * x[1])
            case "div":
                done.append(x[0] / x[1])
            case "neg":
                done.append(-x[0])
            case "fma":
                done.append(float(Fraction(x[0]) * Fraction(x[1]) + Fraction(x[2])))
    return done[-1]


def test_rounding_of_random_programs_stays_within_its_bound() -> None:
    rng = random.Random(5)
    sharp = 0  # the bounds are not just huge
    for _ in range(400):
        operations = random_program(rng)
        lower = rng.choice([rng.uniform(0.01, 1.5), 2.0 ** rng.uniform(-300, -5)])
        upper = lower * rng.choice([1.0, 1.0 + 2.0**-20, 1.03, 1.9])
        record = {"operations": operations, "output": len(operations) - 1}
        tape = rounding.specialise(record, lower, upper)
        with truth.working(rounding.ROUNDING_BITS):
            rest, last = rounding.rounding_sum(tape, truth.ball(lower, upper))
        worst = 0.0
        for alpha in (lower, upper, *(rng.uniform(lower, upper) for _ in range(10))):
            with ctx.workprec(6000):
                ideal = in_real_arithmetic(operations, alpha)
                worst = max(worst, float(abs(arb(rounded(operations, alpha)) - ideal)))
        assert worst <= rest + last, operations
        sharp += worst > 0.1 * (rest + last) > 1e-300
    assert sharp > 100


def test_rounding_of_random_programs_stays_within_its_bound_in_a_window() -> None:
    """alpha**3 (1 + anything), for all small powers of two at once."""
    rng = random.Random(6)
    sharp = 0
    for _ in range(300):
        operations = random_program(rng)
        n = len(operations)
        operations += [["const", [], "0x1.8p+0"], ["add", [n - 1, n], None], ["mul", [0, 0], None]]
        operations += [["mul", [n + 2, n + 1], None], ["mul", [n + 3, 0], None]]
        record = {"operations": operations, "output": n + 4}
        tape = rounding.specialise(record, 0.0, certify.SMALL)
        tape = rounding.scaled(tape, 3, certify.SMALL, certify.UNDERFLOW)
        lower = rng.uniform(0.5, 1.0)
        upper = rng.uniform(lower, min(1.0, 1.1 * lower))
        with truth.working(rounding.ROUNDING_BITS):
            rest, last = rounding.rounding_sum(tape, truth.ball(lower, upper))
        worst = 0.0
        for scale in (2.0 ** -rng.randrange(7, 320) for _ in range(12)):
            alpha = scale * rng.uniform(lower, upper)
            with ctx.workprec(30000):
                ideal = in_real_arithmetic(operations, alpha)
                worst = max(worst, float(abs(arb(rounded(operations, alpha)) - ideal) / arb(scale) ** 3))
        assert worst <= rest + last, operations
        sharp += worst > 0.1 * (rest + last)
    assert sharp > 100


@pytest.mark.parametrize("lower", [2.0**-1074, 2.0**-600, 2.0**-345, 2.0**-330, 2.0**-322, 2.0**-100, 2.0**-8])
@pytest.mark.parametrize("kernel", BASES)
def test_windows_hold_where_products_underflow(kernel: str, lower: float) -> None:
    record = find(kernel)
    claim = "bound_to_quarter_pi" if lower >= certify.UNDERFLOW else "bound_underflow"
    points = [lower * (1 + k / 64) for k in range(64)] if lower > 2.0**-1074 else [lower, 7 * lower, 2.0**-1000]
    values = exact.run(variant(record).program, np.array(points)).tolist()
    for alpha, value in zip(points, values, strict=True):
        with ctx.workprec(8000):
            reference = truth.value(DEFINITIONS[kernel], arb(alpha))
            unit = arb(max(certify.ulp(float(reference), 53), 2.0**-1074))
            assert abs(arb(value) - reference) / unit <= arb(record[claim])


@pytest.mark.parametrize("name", ["polar_moment", "radial_weight_amplitude", "weight_moment_per_inertia"])
@pytest.mark.parametrize("form", ["fused", "plain"])
def test_no_input_is_worse_than_the_bound_at_that_input(name: str, form: str) -> None:
    record = find(name, "best", form)
    parts = list(certify.patches(record))
    rng = random.Random(7)
    alpha = [rng.uniform(certify.SMALL, TOP) for _ in range(150)]
    alpha += [TOP - 2.0 ** -rng.uniform(0, 52) for _ in range(50)] + [TOP]
    seen = certificates.errors(variant(record), np.array(alpha))
    for x, error in zip(alpha, seen, strict=True):
        here = [p for p in parts if not p.top and p.lower <= x <= p.upper]
        assert here
        assert all(error <= certify.error(record, p, x, x) for p in here), x.hex()


# --- what is proved ------------------------------------------------------------------------------------------------


def test_every_variant_has_its_certificate() -> None:
    wanted = {(v.kernel, v.tier, v.form): certificates.plain(v)["sha256"] for v in variants()}
    assert {(r["kernel"], r["tier"], r["form"]): r["sha256"] for r in RECORDS} == wanted


def test_the_checker_proves_all_certificates(capsys: pytest.CaptureFixture[str]) -> None:
    accepted = table.prove_all()
    assert accepted, capsys.readouterr().out


@pytest.mark.parametrize("r", RECORDS, ids=lambda r: f"{r['kernel']}-{r['tier']}-{r['form']}")
def test_bounds_reach_the_goals(r: Record) -> None:
    if r["tier"] == "float32":
        assert r["bound"] <= 0.505
    elif r["tier"] != "best":
        assert r["bound"] <= float(r["tier"])
    elif r["form"] != "fused":
        assert r["bound"] <= 5
    elif len(r["definition"]) > 1:
        assert r["bound"] <= 1.25
    else:
        assert r["bound"] <= (0.9 if r["kernel"] == "polar_moment" else 1.0)
        assert r["bound_to_quarter_pi"] <= 0.65


@pytest.mark.parametrize(
    "r", [r for r in RECORDS if "witness" in r], ids=lambda r: f"{r['kernel']}-{r['tier']}-{r['form']}"
)
def test_witnesses_are_seen_and_within_the_bound(r: Record) -> None:
    (seen,) = certificates.errors(variant(r), np.array([float.fromhex(r["witness"]["alpha"])]))
    assert certificates.round_up(seen) == r["witness"]["error"]
    assert 0.3 * r["bound"] < seen <= r["bound"]


def test_only_a_logarithm_is_assumed() -> None:
    for r in RECORDS:
        calls = {value for kind, _, value in r["operations"] if kind == "call"}
        assert calls <= {"exponent", "significand"} or r["form"] == "numpy"
        assert r["assumptions"] == (["np.log within 4 ulp"] if "log" in calls else [])


# --- what is refused -----------------------------------------------------------------------------------------------


def sealed(record: Record) -> Record:
    """With the digest of what it says now, so that no other check can lean on it."""
    return record | {"sha256": digest(record)}


def refused(record: Record) -> str:
    """The name of the check that refuses a record."""
    with pytest.raises(ProofError) as refusal:
        certify.prove(record)
    return refusal.value.check


def constants(record: Record) -> list[int]:
    return [i for i, (kind, _, _) in enumerate(record["operations"]) if kind == "const"]


def retouch(record: Record, index: int, change: Callable[[float], float]) -> Record:
    operation = record["operations"][index]
    operation[2] = change(float.fromhex(operation[2])).hex()
    return record


def by_size(record: Record) -> list[int]:
    """Indices of constants in the order of their size."""
    return sorted(constants(record), key=lambda i: abs(float.fromhex(record["operations"][i][2])))


def test_the_last_bit_of_any_constant_is_caught_by_the_digest() -> None:
    for index in constants(find("resistance_factor")):
        tampered = retouch(find("resistance_factor"), index, lambda c: math.nextafter(c, 9.0))
        assert refused(tampered) == "digest"


@pytest.mark.parametrize("key", ["kernel", "definition", "tier", "form"])
def test_a_certificate_is_not_another_variant_s(key: str) -> None:
    other = find("polar_moment", "1e-6", "plain")
    assert refused(find("resistance_factor") | {key: other[key]}) == "digest"


@pytest.mark.parametrize("kernel", BASES)
def test_a_wrong_leading_coefficient_breaks_the_bound(kernel: str) -> None:
    record = find(kernel)
    (limit,) = [i for i in constants(record) if float.fromhex(record["operations"][i][2]) in (2 / 3, 1.0)][:1]
    assert refused(sealed(retouch(record, limit, lambda c: c * (1 + 2.0**-51)))) == "bound"


@pytest.mark.parametrize("tier", ["best", "1e-10", "1e-6", "float32"])
def test_a_dropped_highest_coefficient_breaks_the_bound(tier: str) -> None:
    record = find("resistance_factor", tier)
    assert refused(sealed(retouch(record, by_size(record)[0], lambda _: 0.0))) == "bound"


@pytest.mark.parametrize("kernel", ["polar_moment", "moment_of_inertia", "weight_moment_amplitude"])
def test_a_missing_low_part_breaks_the_bound(kernel: str) -> None:
    record = find(kernel)
    low = [i for i in constants(record) if float.fromhex(record["operations"][i][2]) == 2.0**-54 * 2 / 3]
    assert refused(sealed(retouch(record, low[0], lambda _: 0.0))) == "bound"


@pytest.mark.parametrize("kernel", BASES)
def test_a_missing_compensation_breaks_the_bound(kernel: str) -> None:
    record = find(kernel)
    neg = {i for i, (kind, _, _) in enumerate(record["operations"]) if kind == "neg"}
    index = next(i for i, (kind, args, _) in enumerate(record["operations"]) if kind == "fma" and args[2] in neg)
    record["operations"][index] = ["const", [], "0x0.0p+0"]
    assert refused(sealed(record)) == "bound"


@pytest.mark.parametrize("kernel", ["polar_moment", "radial_weight_amplitude", "dynamic_coefficient"])
def test_swapped_branches_break_the_bound(kernel: str) -> None:
    record = find(kernel)
    for operation in record["operations"]:
        if operation[0] == "select":
            condition, below, above = operation[1]
            operation[1] = [condition, above, below]
    assert refused(sealed(record)) == ("zero" if kernel in BASES else "bound")


@pytest.mark.parametrize("kernel", ["polar_moment", "moment_of_inertia"])
def test_a_seam_out_of_place_breaks_the_bound(kernel: str) -> None:
    record = find(kernel)
    (seam,) = {args[1] for kind, args, _ in record["operations"] if kind == "less"}
    assert refused(sealed(retouch(record, seam, lambda c: c - 0.25))) == "bound"


@pytest.mark.parametrize("claim", ["bound", "bound_to_quarter_pi"])
def test_a_bound_that_is_not_reached_is_refused(claim: str) -> None:
    record = find("moment_of_inertia")
    assert refused(record | {claim: 0.9 * record[claim]}) == "bound"


def test_the_bound_is_claimed_up_to_a_quarter_pi_too() -> None:
    """Where the worst input lies below pi/4, a lower bound for the whole domain is false whatever is claimed there."""
    record = find("resistance_factor", form="plain")
    assert record["bound"] == record["bound_to_quarter_pi"]
    assert refused(record | {"bound": 0.95 * record["bound"], "bound_underflow": math.inf}) == "bound"


def test_a_false_bound_below_underflow_is_refused() -> None:
    assert refused(find("moment_of_inertia") | {"bound_underflow": 0.9}) == "underflow"


def test_an_assumption_must_be_named() -> None:
    assert refused(find("polar_moment", form="numpy") | {"assumptions": []}) == "assumptions"


def test_nothing_but_zero_at_zero() -> None:
    record = find("resistance_factor")
    record["operations"] += [["const", [], (2.0**-1074).hex()], ["add", [record["output"], record["output"] + 1], None]]
    assert refused(sealed(record | {"output": len(record["operations"]) - 1})) == "zero"


def test_a_refusal_passes_between_processes() -> None:
    """Whole, or a pool of processes breaks where it should say what was refused."""
    refusal = records.rejected("bound", RECORDS[0], 2.5, "at most 1")
    passed = pickle.loads(pickle.dumps(refusal))
    assert (type(passed), str(passed), passed.check) == (type(refusal), str(refusal), "bound")


def test_what_is_no_program_is_refused() -> None:
    record = find("resistance_factor")
    record["operations"][1][1] = [3, 3]
    assert refused(sealed(record)) == "program"
    assert refused(sealed(find("resistance_factor") | {"tier": "1e-3"})) == "program"


# --- independence --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("module", [certify, rounding, truth, proof, records, table])
def test_the_checker_knows_nothing_of_the_generator(module: Any) -> None:
    for node in ast.walk(ast.parse(Path(module.__file__).read_text("utf-8"))):
        if isinstance(node, ast.ImportFrom):
            names = {
                f"{node.module}.{a.name}" if node.module == "derive.check" else str(node.module) for a in node.names
            }
        elif isinstance(node, ast.Import):
            names = {a.name for a in node.names}
        else:
            continue
        own = {
            "derive.check.certify",
            "derive.check.rounding",
            "derive.check.truth",
            "derive.check.proof",
            "derive.check.records",
            "flint",
        }
        assert {n for n in names if n.partition(".")[0] not in sys.stdlib_module_names} <= own
