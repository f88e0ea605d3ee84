"""`python -m derive prove`: every certificate proved again, from the files alone."""

import time
from concurrent.futures import ProcessPoolExecutor

from derive.check.certify import prove
from derive.check.proof import ProofError
from derive.check.records import TIERS, Record, read


def judge(record: Record) -> tuple[Record, float | ProofError, float]:
    """A record, what came of its proof, and the seconds that it took."""
    start = time.perf_counter()
    try:
        result: float | ProofError = prove(record)
    except ProofError as refusal:
        result = refusal
    return record, result, time.perf_counter() - start


def prove_all(processes: int = 2) -> bool:
    """Prove every certificate and print a table; true if none is rejected."""
    records = read()
    start, accepted = time.perf_counter(), bool(records)
    print(f"{'kernel':<32} {'tier':<8} {'form':<6} {'proved':>9} {'claimed':>9} {'to pi/4':>9}  unit           seconds")
    with ProcessPoolExecutor(processes) as pool:
        for record, result, seconds in pool.map(judge, records):
            name = f"{record['kernel']:<32} {record['tier']:<8} {record['form']:<6}"
            if isinstance(result, ProofError):
                accepted = False
                print(f"{name} REJECTED: {result}")
            else:
                claimed_too = f"{record['bound']:>9.3g} {record['bound_to_quarter_pi']:>9.3g}"
                print(f"{name} {result:>9.4g} {claimed_too}  {TIERS[record['tier']].unit:<14} {seconds:>7.2f}")
    print(f"{len(records)} certificates, {'all proved' if accepted else 'NOT all proved'}, ", end="")
    print(f"{time.perf_counter() - start:.1f} s with {processes} processes")
    return accepted
