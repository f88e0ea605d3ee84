"""Certificates of `generated`: for each variant its operations, its proved bounds, and the worst known input.

The proof itself is the checker's (`derive.check.certify`), which reads the records made here as plain data.
"""

import json
from collections.abc import Iterable
from decimal import ROUND_CEILING, Context
from itertools import groupby
from operator import attrgetter, itemgetter

import numpy as np
from flint import arb, ctx

from derive.approximate.programs import Variant, variants_of_ends
from derive.check import certify, losses, midpoints, truth
from derive.check.records import TIERS, Record, assumptions, check_goals, digest, seal
from derive.code.operations import Floats
from derive.code.program import flat
from derive.kinds import Pair, TextDict, Texts
from derive.progress import parallel


def plain(variant: Variant) -> Record:
    """Return the certified content of a variant as plain data, with floats in hexadecimal and without bounds.

    An operation is its kind, the indices of its operands, and its value.
    """
    operations: list[list[object]] = []
    program = flat(variant.program)
    for op in program.ops:
        if op.kind in ("log", "exponent", "significand"):
            operations.append(["call", list(op.args), op.kind])
        else:
            value = op.value.hex() if isinstance(op.value, float) else op.value
            operations.append([op.kind, list(op.args), value])
    record: Record = {
        "kernel": variant.kernel,
        "definition": list(variant.definition),
        "tier": variant.tier,
        "form": variant.form,
        "output": program.outputs[0],
        "operations": operations,
    }
    return record | {"assumptions": assumptions(record), "sha256": digest(record)}


def round_up(x: float) -> float:
    """Return a number rounded up to three significant digits."""
    return float(Context(prec=3, rounding=ROUND_CEILING).create_decimal_from_float(x))


def certified(variant: Variant) -> Record:
    """Return the record of a variant with proved bounds within its goals, and with the worst known input."""
    record = plain(variant)
    boxes: list[Pair] = []
    for claim, patches in certify.by_claim(record).items():
        bound, worst_boxes = certify.halve(record, patches)
        record[claim] = round_up(bound)
        boxes += worst_boxes
    record["bound"] = max(record["bound"], record["bound_to_quarter_pi"])
    record["bound_underflow"] = round_up(certify.below_underflow(record, record["bound"]))
    check_goals(record)
    if variant.tier == "float32":
        record["hard"] = midpoints.hard(record)
    if variant.form != "numpy":  # whose logarithm is not the same everywhere
        alpha, error = worst(variant, boxes)
        record["witness"] = {"alpha": alpha.hex(), "error": round_up(error)}
    return seal(record)


README = [
    "Written by `python -m derive`; `python -m derive prove` proves every bound again, rounding included.",
    "A definition is the integral of r^n dr du, or r^n cos(u) dr du, over cos(alpha)/cos(u) <= r <= 1, |u| <= alpha;",
    "2 alpha f is (3.14) with the depth f = 1 - cos(alpha); of two statements the kernel is the quotient.",
    "Bounds on |computed - exact| for every double alpha in [0, pi/2], exact unrounded.",
    "Tiers best and float32: in ulp of the exact value, 1e-10 and 1e-6: relative.",
    "Tier float32 rounds this double once more: correctly for every float32 alpha. Hard are the significands (24 bits,",
    "hexadecimal) of inputs that have a midpoint of two float32 so near that the bound does not decide; each was run.",
    "bound_to_quarter_pi: up to pi/4 only. Both from alpha = 2**-320 on; bound_underflow: below, in ulp but at least",
    "2**-1074 (1e-10 and 1e-6: in units of bound times exact plus 2**-1074); 0 where nothing underflows.",
    "Of both ends, within 65536 rad: relative, best too, and 2**-1000 more; a call is of the part with that digest.",
    "The seal is the digest of all other fields: a record that was changed is proved anew.",
    "The witness is the worst input that a search from the worst boxes found, not a proof. Constants are hexadecimal.",
]


def errors(variant: Variant, alpha: Floats) -> list[float]:
    """Return the errors at inputs alpha, in the variant's unit (relative or ulp), from the unrounded value in balls."""
    computed = variant.program.run(alpha)
    measured = []
    with ctx.workprec(200):  # of which the closed forms lose less than 40 above 2**-12
        for x, y in zip(alpha.tolist(), computed.tolist(), strict=True):
            reference = truth.enclosure(variant.definition, arb(x))
            relative = TIERS[variant.tier].unit == "relative"
            unit = reference if relative else arb(certify.ulp(float(reference)))
            measured.append(float((abs(arb(y) - reference) / unit).mid()))
    return measured


def worst(variant: Variant, boxes: Iterable[Pair]) -> Pair:
    """Return the worst input found by a search from the worst boxes of the proof, and its error.

    A box is an interval (lower, upper) of alpha.

    Evenly spaced points in each box, then steps of ever fewer ulp around the worst one. Nothing in it is random.
    """

    def worst_of(points: Iterable[float]) -> Pair:
        alpha = np.unique(np.clip(np.array(list(points)), 2.0**-12, truth.TOP))
        return max(zip(errors(variant, alpha), alpha.tolist(), strict=True), key=itemgetter(0))

    count = 400 if variant.tier == "best" else 64  # rounding errors are irregular, errors of approximation are not
    points: list[float] = []
    for lower, upper in boxes:
        points += (lower + (upper - lower) * k / count for k in range(count + 1))
    error, alpha = worst_of(points)
    for exponent in range(30, -1, -2):
        step = 2.0**exponent * certify.ulp(alpha)
        nearby = worst_of(alpha + step * k for k in range(-20, 21))
        error, alpha = max((error, alpha), nearby, key=itemgetter(0))
    return alpha, error


def records(variants: Iterable[Variant], known: Iterable[Record]) -> list[Record]:
    """Return the record of every variant: the known one if its operations and seal are right, otherwise a new one."""
    proved = {record["sha256"]: record for record in known if record == seal(record)}
    by_digest = {plain(variant)["sha256"]: variant for variant in variants}
    new = (variant for digest, variant in by_digest.items() if digest not in proved)
    by_kernel = [list(group) for _, group in groupby(new, attrgetter("kernel"))]  # which share hard inputs
    for record in parallel(certified, by_kernel, "kernels certified"):
        proved[record["sha256"]] = record
    return [proved[digest] for digest in by_digest]


def of_ends(proved: Iterable[Record]) -> list[Record]:
    """Return the records of the functions of both ends, from the records ``proved`` of their functions of alpha."""
    parts = {record["sha256"]: record for record in proved}
    certified = []
    for v in variants_of_ends():
        assert v.part
        record = losses.certificate(v.kernel, v.definition, v.tier, v.form, parts[plain(v.part)["sha256"]])
        record = record | {"bound": round_up(record["bound"])}
        check_goals(record)
        certified.append(seal(record))
    return certified


def files(records: Iterable[Record]) -> TextDict:
    """Return the text of every certificate file by its name below `generated`, with one field or operation per line."""
    blocks: dict[str, Texts] = {}
    for record in records:
        rows = []
        for key, value in record.items():
            if key != "operations":
                rows.append(f'    "{key}": {json.dumps(value)}')
        operations = ",\n".join(f"      {json.dumps(op)}" for op in record["operations"])
        rows.append(f'    "operations": [\n{operations}\n    ]')
        block = ",\n".join(rows)
        blocks.setdefault(record["kernel"], []).append(f"  {{\n{block}\n  }}")
    texts = {}
    for kernel, of_kernel in blocks.items():
        certificates = ",\n".join(of_kernel)
        head = f' "kernel": {json.dumps(kernel)},\n "read me": {json.dumps(README)},\n'
        texts[f"certificates/{kernel}.json"] = f'{{\n{head} "certificates": [\n{certificates}\n ]\n}}\n'
    return texts
