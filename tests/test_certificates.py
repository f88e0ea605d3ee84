"""The checker of certificates: its exact functions, its analysis of rounding, what it proves and what it refuses."""

import json
import math
import pickle
import random
from collections.abc import Callable, Iterator
from copy import deepcopy
from functools import cache
from itertools import pairwise
from operator import add, mul, neg, sub, truediv
from typing import Any

import mpmath
import numpy as np
import pytest
from flint import arb, ctx

from derive.approximate import certificates, programs
from derive.approximate.programs import Variant, variants
from derive.check import certify, ends, losses, midpoints, patches, records, rounding, truth
from derive.check.proof import ProofError
from derive.check.records import Record, check_goals, digest, read_records, seal
from derive.check.truth import SEGMENTS, TOP
from derive.code.program import Op, Program, walk
from tests.support import oracle

RECORDS = read_records()
DEFINITIONS = {r["kernel"]: tuple(r["definition"]) for r in RECORDS}
BASES = [kernel for kernel, definition in DEFINITIONS.items() if len(definition) == 1]
ANGLES = (1e-3, 0.01, 0.2, 0.25, 0.6, 1.0, 1.4, 1.57, TOP - 2.0**-40, TOP - 2.0**-52, TOP)


def find(kernel: str, tier: str = "best", form: str = "fused") -> Record:
    """Return a certificate as it was written."""
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
            difference = abs(truth.enclosure(DEFINITIONS[kernel], arb(alpha)) / oracle.kernel(kernel, alpha) - 1)
            assert difference.upper() < arb(2) ** -110, alpha


@pytest.mark.parametrize("kernel", BASES)
def test_taylor_models_enclose_the_exact_functions(kernel: str) -> None:
    for segment in SEGMENTS:
        model = truth.kernel_model(DEFINITIONS[kernel][0], segment)
        for share in (0.0, 0.03, 0.37, 0.5, 0.81, 1.0):
            alpha = segment.lower + share * (segment.upper - segment.lower) or 1e-9
            with truth.working(300):
                found = model(arb(alpha) - segment.centre) * (1 if segment.lower else arb(alpha) ** 3)
                assert found.overlaps(truth.enclosure(DEFINITIONS[kernel], arb(alpha)))
                assert (found.rad() / found).upper() < arb(2) ** -60


def test_segments_cover_the_domain() -> None:
    assert SEGMENTS[0].lower == 0
    assert (SEGMENTS[-1].lower, SEGMENTS[-1].upper) == (TOP, TOP)
    assert SEGMENTS[-2].upper == math.nextafter(TOP, 0.0)  # nothing between it and TOP
    assert all(a.upper == b.lower for a, b in pairwise(SEGMENTS[:-1]))


# --- rounding ------------------------------------------------------------------------------------------------------


def random_program(rng: random.Random) -> list[list[Any]]:
    """Return random operations on alpha and constants, with compensated sums and products among them."""
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


REAL: dict[str, Callable[..., arb]] = {"add": add, "sub": sub, "mul": mul, "div": truediv, "neg": neg,
                                       "fma": lambda x, y, z: x * y + z}  # fmt: skip


def errors(operations: list[list[Any]], alpha: list[float]) -> Iterator[arb]:
    """Yield the exact rounding error of each operation."""
    ops = (Op(kind, tuple(args), float.fromhex(x) if kind == "const" else x) for kind, args, x in operations)
    program = Program("random", ("alpha",), tuple(ops), (len(operations) - 1,))
    values = np.broadcast_to(program.run(np.array(alpha)), len(alpha))  # it may be a constant

    def exact(op: Op, operands: list[arb]) -> arb:
        return arb(op.value) if isinstance(op.value, float) else REAL[op.kind](*operands)

    for x, value in zip(alpha, values.tolist(), strict=True):
        (ideal,) = walk(program, {"alpha": arb(x)}, exact)
        yield abs(arb(value) - ideal)


@pytest.mark.parametrize("window", [False, True])
def test_rounding_of_random_programs_stays_within_its_bound(window: bool) -> None:
    """Bounds contain the rounding errors, also in a window alpha**3 (1 + x) for all small powers of two."""
    rng, sharp = random.Random(5 + window), 0  # the bounds are not just huge
    for _ in range(300):
        operations = random_program(rng)
        if window:
            n = len(operations)
            operations += [["const", [], "0x1.8p+0"], ["add", [n - 1, n], None], ["mul", [0, 0], None]]
            operations += [["mul", [n + 2, n + 1], None], ["mul", [n + 3, 0], None]]
        record = {"operations": operations, "output": len(operations) - 1}
        if window:
            lower = rng.uniform(0.5, 1.0)
            upper = rng.uniform(lower, min(1.0, 1.1 * lower))
            tape = patches.scaled_tape(
                rounding.specialise(record, 0.0, patches.SMALL), 3, patches.SMALL, patches.UNDERFLOW
            )
        else:
            lower = rng.choice([rng.uniform(0.01, 1.5), 2.0 ** rng.uniform(-300, -5)])
            upper = lower * rng.choice([1.0, 1.0 + 2.0**-20, 1.03, 1.9])
            tape = rounding.specialise(record, lower, upper)
        with truth.working(rounding.ROUNDING_BITS):
            rest, last = rounding.rounding_sum(tape, truth.ball(lower, upper))
        scales = [2.0 ** -rng.randrange(7, 320) if window else 1.0 for _ in range(12)]
        alpha = [
            s * x for s, x in zip(scales, (lower, upper, *(rng.uniform(lower, upper) for _ in range(10))), strict=True)
        ]
        with ctx.workprec(30000 if window else 6000):
            worst = max(float(e / arb(s) ** 3) for e, s in zip(errors(operations, alpha), scales, strict=True))
        assert worst <= rest + last, operations
        sharp += worst > 0.1 * (rest + last) > 1e-300
    assert sharp > 100


@pytest.mark.parametrize(("name", "form"), [("polar_moment", "plain"), ("weight_moment_per_inertia", "fused")])
def test_no_input_is_worse_than_the_bound_at_that_input(name: str, form: str) -> None:
    record = find(name, "best", form)
    parts = list(patches.patches(record))
    rng = random.Random(7)
    alpha = [rng.uniform(patches.SMALL, TOP) for _ in range(150)]
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


def test_the_checker_proves_certificates() -> None:
    """Some of them; `python -m derive prove` proves all, and `python -m derive` what it writes.

    Of float32 the bound: hard inputs are looked for in parts below, and by `test_approximants` for one kernel.
    """
    for record in RECORDS[::25]:
        assert certify.prove(record) <= record["bound"]
    _, proved = certify.checked(find("resistance_factor", "1e-6"))
    assert proved


@pytest.mark.parametrize("r", RECORDS, ids=lambda r: f"{r['kernel']}-{r['tier']}-{r['form']}")
def test_bounds_reach_the_goals(r: Record) -> None:
    """Proved bounds are close to the worst known errors, which `test_observed_errors` computes.

    The checker compares bounds and goals. In float32 correct rounding is promised, which follows from the bound.
    """
    if r["tier"] == "float32":
        return
    assert 0.3 * r["bound"] < r.get("witness", {"error": r["bound"]})["error"] <= r["bound"]
    if (r["tier"], r["form"]) == ("best", "fused"):
        assert r["bound"] <= 1.25
        assert len(r["definition"]) > 1 or r["bound_to_quarter_pi"] <= 0.65


# --- what is refused -----------------------------------------------------------------------------------------------


def sealed(record: Record) -> Record:
    """Return the record with a new digest and seal, so that no other check refuses it first."""
    return seal(record | {"sha256": digest(record)})


def refused(record: Record) -> str:
    """Return the name of the check that refuses a record."""
    with pytest.raises(ProofError) as refusal:
        certify.prove(record)
    return refusal.value.check


def constants(record: Record) -> list[int]:
    return [i for i, (kind, _, _) in enumerate(record["operations"]) if kind == "const"]


def retouch(record: Record, index: int, change: Callable[[float], float]) -> Record:
    operation = record["operations"][index]
    operation[2] = change(float.fromhex(operation[2])).hex()
    return record


def test_the_digest_catches_another_constant_or_name() -> None:
    """The last bit of any constant, and whatever says which variant it is."""
    for index in constants(find("resistance_factor")):
        tampered = retouch(find("resistance_factor"), index, lambda c: math.nextafter(c, 9.0))
        assert refused(tampered) == "digest"
    other = find("polar_moment", "1e-6", "plain")
    for key in ("kernel", "definition", "tier", "form"):
        assert refused(find("resistance_factor") | {key: other[key]}) == "digest"


def test_the_seal_catches_another_claim() -> None:
    """A record whose claims were changed is refused, and proved anew when `derive` writes."""
    record = find("polar_moment", "1e-6", "plain")
    claims = dict.fromkeys(("bound", "bound_to_quarter_pi", "bound_underflow"), 2.0 * record["bound"])
    claims |= {"assumptions": ["none"], "witness": record["witness"] | {"error": 0.0}}
    for field, changed in claims.items():
        tampered = record | {field: changed}
        assert refused(tampered) == "seal", field
    (variant,) = (v for v in variants() if certificates.plain(v)["sha256"] == record["sha256"])
    assert certificates.records([variant], [record]) == [record]
    assert certificates.records([variant], [tampered]) == [record]


def test_a_bound_below_its_own_witness_is_refused() -> None:
    record = find("polar_moment", "1e-6", "plain")
    assert refused(sealed(record | {"bound": 0.9 * record["witness"]["error"]})) in ("bound", "witness")
    with pytest.raises(ProofError, match="witness") as refusal:
        check_goals(record | {"bound": 0.99 * record["witness"]["error"]})
    assert refusal.value.check == "witness"


def limit(r: Record) -> int:
    return next(i for i in constants(r) if float.fromhex(r["operations"][i][2]) in (2 / 3, 1.0))


def smallest(r: Record) -> int:
    """Return the highest coefficient."""
    return min(constants(r), key=lambda i: abs(float.fromhex(r["operations"][i][2])))


def low(r: Record) -> int:
    return next(i for i in constants(r) if float.fromhex(r["operations"][i][2]) == 2.0**-54 * 2 / 3)


def uncompensated(r: Record) -> Record:
    negative = {i for i, (kind, _, _) in enumerate(r["operations"]) if kind == "neg"}
    index = next(i for i, (kind, args, _) in enumerate(r["operations"]) if kind == "fma" and args[2] in negative)
    r["operations"][index] = ["const", [], "0x0.0p+0"]
    return r


def swapped(r: Record) -> Record:
    for operation in r["operations"]:
        if operation[0] == "select":
            condition, below, above = operation[1]
            operation[1] = [condition, above, below]
    return r


def shifted(r: Record) -> Record:
    (seam,) = {args[1] for kind, args, _ in r["operations"] if kind == "less"}
    return retouch(r, seam, lambda c: c - 0.25)


def above_zero(r: Record) -> Record:
    r["operations"] += [["const", [], (2.0**-1074).hex()], ["add", [r["output"], r["output"] + 1], None]]
    return r | {"output": len(r["operations"]) - 1}


def looped(r: Record) -> Record:
    r["operations"][1][1] = [3, 3]
    return r


FAULTS: list[tuple[Callable[[Record], Record], str, tuple[str, ...]]] = [
    (lambda r: retouch(r, limit(r), lambda c: c * (1 + 2.0**-51)), "bound", tuple(BASES)),
    (lambda r: retouch(r, smallest(r), lambda _: 0.0), "bound",
     tuple(f"resistance_factor {tier}" for tier in ("best", "1e-10", "1e-6"))),
    (lambda r: retouch(r, low(r), lambda _: 0.0), "bound",
     ("polar_moment", "moment_of_inertia", "weight_moment_amplitude")),
    (uncompensated, "bound", ("moment_of_inertia", "weight_moment_amplitude", "resistance_factor")),
    (swapped, "zero", ("polar_moment", "radial_weight_amplitude")),
    (swapped, "bound", ("dynamic_coefficient",)),
    (shifted, "bound", ("polar_moment", "moment_of_inertia")),
    (lambda r: r | {"bound": 0.9 * r["bound"]}, "bound", ("moment_of_inertia",)),
    (lambda r: r | {"bound_to_quarter_pi": 0.9 * r["bound_to_quarter_pi"]}, "bound", ("moment_of_inertia",)),
    # Its worst input lies below pi/4: a lower bound for the whole domain is false whatever is claimed there.
    (lambda r: r | {"bound": 0.95 * r["bound_to_quarter_pi"], "bound_underflow": math.inf}, "bound",
     ("resistance_factor best plain",)),
    (lambda r: r | {"bound_underflow": 0.9}, "underflow", ("moment_of_inertia",)),
    (lambda r: r | {"assumptions": []}, "assumptions", ("polar_moment best numpy",)),
    (above_zero, "zero", ("resistance_factor",)),
    (looped, "program", ("resistance_factor",)),
    (lambda r: r | {"tier": "1e-3"}, "program", ("resistance_factor",)),
]  # fmt: skip


@pytest.mark.parametrize(
    ("fault", "check", "which"), [(fault, check, which) for fault, check, of in FAULTS for which in of]
)
def test_a_false_certificate_is_refused(fault: Callable[[Record], Record], check: str, which: str) -> None:
    assert refused(sealed(fault(find(*which.split())))) == check


def test_a_refusal_passes_between_processes() -> None:
    """Whole, or a pool of processes breaks where it should say what was refused."""
    refusal = records.rejected("bound", RECORDS[0], 2.5, "at most 1")
    passed = pickle.loads(pickle.dumps(refusal))
    assert (type(passed), str(passed), passed.check) == (type(refusal), str(refusal), "bound")


# --- rounded correctly ---------------------------------------------------------------------------------------------


def hard_inputs(record: Record) -> tuple[float, ...]:
    """Return the significands that a certificate lists, with every exponent."""
    significands = [int(s, 16) * 2.0**-23 for s in record["hard"]]
    return tuple(x for s in significands for k in range(-51, 1) if (x := s * 2.0**k) < TOP)


@pytest.mark.parametrize("start", [2**23, 11 * 2**20, 13176794 - 2**11])
def test_no_input_near_a_midpoint_is_missed(start: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Against balls one by one: of results that are subnormal, where they pass a power of two, and next to pi/2."""
    monkeypatch.setattr(midpoints, "WIDTH", 2.0**-9)
    (statement,) = DEFINITIONS["radial_weight_amplitude"]
    h = 2.0**-23 if start > 13 * 10**6 else 2.0 ** (-68 if start == 2**23 else -30)
    with truth.working(truth.BITS):
        found = set(midpoints._near(statement, h, start, start + 2**11))
    with truth.working(400):
        for n in range(start, start + 2**11):
            exact = truth.enclosure([statement], arb(n * h))
            ulp = max(2.0 ** (math.frexp(float(exact))[1] - 24), 2.0**-149)
            ulps = exact / ulp
            away = float(abs(ulps - ulps.floor() - 0.5))
            assert n * h in found or away > 2.0**-9, n
    assert len(found) < 64  # where the search leaves an input undecided it finds it


@pytest.mark.parametrize("kernel", BASES)
def test_hard_inputs_are_rounded_correctly(kernel: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The checker accepts the hard inputs that certificates list; `python -m derive prove` searches for them again."""
    for record in (find(kernel, "float32", form) for form in ("fused", "plain")):
        monkeypatch.setattr(midpoints, "hard_inputs", cache(lambda _, record=record: hard_inputs(record)))
        midpoints.prove(record)
        assert midpoints.run(record, 0.7) == variant(record).program.run(np.array([0.7]))[0]


def higher(record: Record) -> Record:
    """Return the limit at 0 one unit higher, and no longer leaning to the side of the next term."""
    place = max(constants(record), key=lambda i: float.fromhex(record["operations"][i][2]) in (2 / 3, 1.0))
    return retouch(record, place, lambda c: math.nextafter(c, 9.0))


def upright(record: Record) -> Record:
    """Remove the lean of a program: midpoints stay, and are rounded to even."""
    place = min(constants(record), key=lambda i: abs(float.fromhex(record["operations"][i][2])))
    return retouch(record, place, lambda _: 0.0)


@pytest.mark.parametrize(
    ("fault", "check"),
    [(higher, "rounding"), (upright, "rounding"), (lambda r: r | {"hard": r["hard"][1:]}, "hard"),
     (lambda r: r | {"definition": ["r^4"]}, "hard")],
)  # fmt: skip
@pytest.mark.parametrize("kernel", ["moment_of_inertia", "polar_moment", "resistance_factor"])
def test_a_wrong_rounding_is_refused(
    kernel: str, fault: Callable[[Record], Record], check: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    record = find(kernel, "float32")
    found = (*hard_inputs(record), 0.4876)
    monkeypatch.setattr(midpoints, "hard_inputs", lambda _: found)
    with pytest.raises(ProofError) as refusal:
        midpoints.prove(fault(record))
    assert refusal.value.check == check


# --- both ends -----------------------------------------------------------------------------------------------------

ENDS = read_records(both_ends=True)
WAYS = ["cos psi", "-cos psi", "sin psi", "-sin psi", "tan psi"]


def of_ends(kernel: str = "radial_weight", tier: str = "best", form: str = "plain") -> Record:
    (found,) = [r for r in ENDS if (r["kernel"], r["tier"], r["form"]) == (kernel, tier, form)]
    return deepcopy(found)


@pytest.mark.parametrize("direction", WAYS)
def test_directions_are_what_they_say(direction: str) -> None:
    """Directions of either sign and after ten thousand turns are correct, by the operations that certificates list."""
    turned = ends.result(("r^1 cos u", direction), "best", "")
    part = Program("one", ("alpha",), (Op("input", (), "alpha"), Op("const", (), 1.0)), (1,))
    program = programs.inlined("direction", [turned], part)
    for middle in (*np.linspace(-9.1, 9, 61), -65000.3, 65000.3):
        one, two = float(middle - 0.25), float(middle + 0.25)
        with mpmath.workdps(40):
            wanted = getattr(mpmath, direction.strip("-")[:3])((3 * mpmath.pi - mpmath.mpf(one) - mpmath.mpf(two)) / 2)
        assert float(program.run(one, two)) == pytest.approx(
            float(-wanted if direction[0] == "-" else wanted), rel=2e-15
        )


def test_both_ends_have_their_certificates_and_the_checker_proves_them() -> None:
    wanted = {(v.kernel, v.tier, v.form) for v in programs.variants_of_ends()}
    assert {(r["kernel"], r["tier"], r["form"]) for r in ENDS} == wanted
    for record in ENDS:
        assert 0.98 * record["bound"] <= losses.prove(record, RECORDS) <= record["bound"]


@pytest.mark.parametrize("tier", ["1e-10", "1e-6"])
def test_a_part_at_its_goal_serves_both_ends(tier: str) -> None:
    """A part at its goal, such as a user's moment, does not stop the run for the error that the sine adds."""
    part = find("radial_weight_amplitude", tier, "plain") | {"bound": records.TIERS[tier].other}
    turned = losses.certificate("radial_weight", ("r^1 cos u", "cos psi"), tier, "plain", part)
    assert turned["bound"] > part["bound"]
    records.check_goals(turned)


def test_what_the_reduction_loses_is_bounded_by_what_is_left() -> None:
    """The nearest that n pi comes to a multiple of 2**-52, by another way: convergents would be as good."""
    with mpmath.workdps(60):
        for n in (2, 3, 355, 38025):
            scaled = mpmath.pi * n * 2**52
            left = float(abs(scaled - mpmath.nint(scaled)) / 2**52)
            assert float(losses.distance(n, 52)) == pytest.approx(left, rel=1e-9)
        assert abs(sum(map(mpmath.mpf, ends.PI)) - mpmath.pi) < mpmath.mpf(2) ** -164
    assert losses.reduction_loss() < 2.0**-58


def spoilt(record: Record, index: int, value: Any) -> Record:
    record["operations"][index] = value
    return sealed(record)


ENDS_FAULTS: list[tuple[Callable[[Record], Record], str]] = [
    (lambda r: spoilt(r, constants(r)[3], ["const", [], "0x1.0p+0"]), "program"),
    (lambda r: spoilt(r, 2, ["add", [1, 0], None]), "program"),
    (lambda r: sealed(r | {"definition": ["r^1 cos u", "sin psi"]}), "program"),
    (lambda r: r | {"form": "fused"}, "program"),
    (lambda r: r | {"bound": 0.97 * r["bound"]}, "bound"),
    (lambda r: r | {"bound": 1e-14}, "goal"),
    (lambda r: sealed(json.loads(json.dumps(r).replace(find("radial_weight_amplitude", form="plain")["sha256"], "0"))),
     "part"),
]  # fmt: skip


@pytest.mark.parametrize(("fault", "check"), ENDS_FAULTS)
def test_a_false_certificate_of_both_ends_is_refused(fault: Callable[[Record], Record], check: str) -> None:
    with pytest.raises(ProofError) as refusal:
        losses.prove(fault(of_ends()), RECORDS)
    assert refusal.value.check == check


@pytest.mark.parametrize(("where", "name", "wrong"), [
    (ends, "COTANGENT", (1.0, -1 / 3, 1 / 45, -2 / 945, -1 / 4725)), (ends, "COTANGENT", (1.0, -1 / 3)),
    (losses, "TERMS", {"best": 9}), (losses, "PASSES", 1), (losses, "PASSES", 2), (losses, "PI", ends.PI[:3]),
    (losses, "PI", (*ends.PI[:3], 8.6718101301237e-35)), (losses, "LIMIT", 2.0**20),
])  # fmt: skip
def test_a_bug_in_the_operations_costs_the_bound(where: Any, name: str, wrong: Any, monkeypatch: Any) -> None:
    """A sign in a series, one that is too short, too few passes, a part of pi, ends too far away."""
    for bound in (losses.reduction_loss, losses.sinc_loss, losses.cotangent_loss, losses.slope_gap):
        bound.cache_clear()
        monkeypatch.setattr(losses, bound.__name__, bound.__wrapped__)
    monkeypatch.setattr(where, name, wrong)
    with pytest.raises((ProofError, ArithmeticError)):
        losses.prove(of_ends(), RECORDS)
