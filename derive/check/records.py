"""Certificates as plain data: tiers and their goals, digests, and files."""

import hashlib
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from derive.check.proof import ProofError

Record = dict[str, Any]

FOLDER = Path(__file__).resolve().parent.parent.parent / "generated" / "certificates"
ENDS = 3e-15  # relative error of a function of both ends in its best tier
SINGLE_ENDS = 0.505  # error of a function of both ends in float32, in ulp
LOG_ULPS = 4  # assumed error of np.log


@dataclass(frozen=True)
class Tier:
    """Tier of accuracy: the unit of its bounds and its goals. Bounds of float32 are before the result is rounded."""

    unit: str
    fused: float
    other: float  # plain, and in NumPy
    quotient: float  # fused

    def goal(self, record: Record) -> float:
        """Return the greatest bound that a certificate may have."""
        if of_both_ends(record):  # the part may take all that its own goal allows
            return {"best": ENDS, "float32": SINGLE_ENDS}.get(record["tier"], 2 * self.other)
        if record["form"] != "fused":
            return self.other
        if len(record["definition"]) > 1:
            return self.quotient
        return self.fused


TIERS = {
    "best": Tier("ulp", 1.0, 5.0, 1.25),
    "1e-10": Tier("relative", 1e-10, 1e-10, 1e-10),
    "1e-6": Tier("relative", 1e-6, 1e-6, 1e-6),
    "float32": Tier("ulp", 128.0, 128.0, 128.0),
}


def rejected(check: str, record: Record, found: object, wanted: object) -> ProofError:
    """Return the error of a certificate that fails a check."""
    words = " ".join(str(record[key]) for key in ("tier", "form"))
    return ProofError(f"{record['kernel']}: {check} of tier {words}", found, wanted, check)


def check_goals(record: Record) -> None:
    """Raise `ProofError` if a bound exceeds the goal of its tier, or is below the error of the worst known input."""
    seen = record.get("witness", {}).get("error", 0.0)
    if not seen <= record["bound"]:
        raise rejected("witness", record, f"an error of {seen:.4g}", f"at most {record['bound']:.4g}")
    goal = TIERS[record["tier"]].goal(record)
    if not record["bound"] <= goal:
        raise rejected("goal", record, f"{record['bound']:.4g}", f"at most {goal:g}")


def digest(record: Record) -> str:
    """Return the sha256 of kernel, definition, tier, form, operations and output."""
    certified = [record[key] for key in ("kernel", "definition", "tier", "form", "operations", "output")]
    return hashlib.sha256(json.dumps(certified, separators=(",", ":")).encode()).hexdigest()


def seal(record: Record) -> Record:
    """Return a record with the sha256 of all its other fields, which reveals any change of a claim or a bound."""
    fields = {key: value for key, value in record.items() if key != "seal"}
    text = json.dumps(fields, sort_keys=True, separators=(",", ":"))
    return fields | {"seal": hashlib.sha256(text.encode()).hexdigest()}


def assumptions(record: Record) -> list[str]:
    """Return the assumptions of the proof, from the calls in the program."""
    called = any((kind, value) == ("call", "log") for kind, _, value in record["operations"])
    return [f"np.log within {LOG_ULPS} ulp"] * called


def of_both_ends(record: Record) -> bool:
    """Return whether a record certifies a function of both ends of an arc, such as C(alpha) cos(psi)."""
    return str(record["definition"][-1]).endswith("psi")


def unit(record: Record) -> str:
    """Return the unit of a record's bound. The best tier of functions of both ends is relative."""
    if of_both_ends(record):
        return "ulp of float32" if record["tier"] == "float32" else "relative"
    return TIERS[record["tier"]].unit


def promised(record: Record) -> tuple[float, str]:
    """Return the bound of the returned value and its unit, half an ulp where it is rounded correctly."""
    return (0.5, "ulp of float32") if "hard" in record else (record["bound"], unit(record))


def read_records(both_ends: bool = False) -> list[Record]:
    """Return the records of all certificate files, for functions of alpha or of both ends."""
    records: list[Record] = []
    for path in sorted(FOLDER.glob("*.json")):
        records += json.loads(path.read_text("utf-8"))["certificates"]
    return [record for record in records if of_both_ends(record) == both_ends]
