"""`python -m derive prove`: every certificate proved again, from the files alone."""

import time
from concurrent.futures import ProcessPoolExecutor

from derive.check.certify import prove
from derive.check.proof import ProofError
from derive.check.records import TIERS, Record, read

PROCESSES = 2


def judge(record: Record) -> tuple[str, bool]:
    """What came of a record's proof, in how many seconds, as a line; whether it is accepted."""
    start, name = time.perf_counter(), f"{record['kernel']:<32} {record['tier']:<8} {record['form']:<6}"
    try:
        bounds = prove(record), record["bound"], record["bound_to_quarter_pi"]
    except ProofError as refusal:
        return f"{name} REJECTED: {refusal}", False
    numbers = "{:>9.4g} {:>9.3g} {:>9.3g}".format(*bounds)
    return f"{name} {numbers}  {TIERS[record['tier']].unit:<14} {time.perf_counter() - start:>7.2f}", True


def prove_all() -> bool:
    """Prove every certificate and print a table; true if none is rejected."""
    records = read()
    start, accepted = time.perf_counter(), bool(records)
    print(f"{'kernel':<32} {'tier':<8} {'form':<6} {'proved':>9} {'claimed':>9} {'to pi/4':>9}  unit           seconds")
    with ProcessPoolExecutor(PROCESSES) as pool:
        for line, proved in pool.map(judge, records):
            print(line)
            accepted &= proved
    words = f"{len(records)} certificates, {'all proved' if accepted else 'NOT all proved'}"
    print(f"{words}, {time.perf_counter() - start:.1f} s with {PROCESSES} processes")
    return accepted
