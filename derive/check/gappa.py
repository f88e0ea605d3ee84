"""Independent bounds on rounding by Gappa (Daumas and Melquiond 2010).

A script requests the relative distance between a program's value and the same operations in real arithmetic, for every
double from 2**-320 to pi/2. The checker (`certify`) bounds the distance of the latter from the exact function. Gappa
supports sums and products, but not the pieces, logarithms and compensated sums of the best tiers.
"""

import re
import shutil
import subprocess
from dataclasses import replace
from math import inf
from pathlib import Path

from derive.check import certify
from derive.check.patches import patches
from derive.check.records import TIERS, Record, read
from derive.check.truth import TOP
from derive.progress import parallel

FOLDER = Path("build") / "gappa"
CUTS = 64  # parts of the domain, cubically denser towards pi/2, where rational functions lose most
HALVINGS = 200
FORMULAS = {"add": "{} + {}", "sub": "{} - {}", "mul": "{} * {}", "div": "{} / {}", "neg": "-{}", "fma": "{} * {} + {}"}
END = re.compile(r"\{(-?[\d.]+(?:e-?\d+)?), ")  # end of an interval, to six digits
MARGIN = 1.001  # for these digits, and as the errors are relative to the program's value, not the exact one


def script(record: Record) -> str:
    """Return the script for Gappa, or raise ValueError if the program has an operation without a formula."""
    lines = ["@double = float<ieee_64, ne>;"]
    for place, (kind, args, value) in enumerate(record["operations"]):
        if kind in FORMULAS:
            rounded, real = (FORMULAS[kind].format(*(f"{name}{a}" for a in args)) for name in "vr")
            lines += [f"v{place} double= {rounded};", f"r{place} = {real};"]
        elif kind in ("input", "const"):
            given = "double(alpha)" if kind == "input" else value
            lines += [f"v{place} = {given};", f"r{place} = v{place};"]
        else:
            raise ValueError(f"no formula for {kind}")
    last = record["output"]
    error = f"(v{last} - r{last}) / r{last}"
    shares = (1 - (k / CUTS) ** 3 for k in range(CUTS - 1, 0, -1))
    cuts = ", ".join(str(TOP * share) for share in shares)
    lines += [f"{{ v0 in [1b-320, {TOP.hex()}] -> {error} in ? }}", f"{error} $ v0 in ({cuts});"]
    return "\n".join(lines) + "\n"


def asked(record: Record, text: str) -> float:
    """Return Gappa's bound on the relative rounding error, infinity without a bound.

    The script is written to FOLDER.
    """
    FOLDER.mkdir(parents=True, exist_ok=True)
    name = "-".join([record["kernel"], record["tier"], record["form"]])
    (FOLDER / f"{name}.g").write_text(text, encoding="utf-8")
    done = subprocess.run(["gappa"], input=text, capture_output=True, text=True, check=False)
    ends = END.findall(done.stdout + done.stderr)
    return max((abs(float(end)) * MARGIN for end in ends), default=inf)


def approximation(record: Record) -> float:
    """Return the checker's bound of a program without rounding, in the unit of its tier."""
    parts = []
    for part in patches(record):
        exact = tuple(node._replace(rounds=False, floor=0.0) for node in part.tape)
        parts.append(replace(part, tape=exact))
    bound, _ = certify.halve(record, parts, halvings=HALVINGS)
    return min(bound, float(record["bound"]))


def compared(record: Record) -> tuple[str, bool]:
    """Return a row of the table, and whether Gappa proves the goal of the tier."""
    tier = record["tier"]
    name = f"{record['kernel']:<32} {tier:<8} {record['form']:<6} {record['bound']:>9.4g}"
    try:
        rounding = asked(record, script(record))
    except ValueError as missing:
        return f"{name} {'-':>9} {'-':>9}  undecided: {missing}", False
    in_ulp = TIERS[tier].unit == "ulp"
    total = approximation(record) + rounding * (2.0**53 if in_ulp else 1)  # ulps in the exact value, at most
    proved = total <= TIERS[tier].goal(record)
    return f"{name} {total:>9.4g} {rounding:>9.2g}  {'proved' if proved else 'undecided'}", proved


def compare() -> bool:
    """Print the table, and return whether Gappa proves all tiers but the best, or is not installed."""
    if shutil.which("gappa") is None:
        print("skipped: gappa is not installed; on Debian and Ubuntu type: sudo apt install gappa")
        return True
    records = read()
    print(f"{'kernel':<32} {'tier':<8} {'form':<6} {'ours':>9} {'by Gappa':>9} {'rounding':>9}")
    proved = []
    rows = parallel(compared, [[x] for x in records], "certificates compared")
    for record, (line, is_proved) in zip(records, rows, strict=True):
        print(line, flush=True)
        proved += [is_proved] * (record["tier"] != "best")
    print(f"{sum(proved)} of {len(proved)} proved beside tier best; below 2**-320 and for two angles nothing is asked")
    return all(proved)
