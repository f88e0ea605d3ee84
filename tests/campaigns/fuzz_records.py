"""Damaged record files of every format: cut anywhere, with random bytes, lines or numbers in them, or nothing else.

``python -m tests.campaigns.fuzz_records 20000 --seed 1`` reads so many. Each is a record of finite numbers at
increasing times or is refused in one line, within two seconds; any other is shown.
"""

import sys
import tempfile
import time
import traceback
from collections.abc import Iterable
from pathlib import Path
from random import Random
from typing import Any

import numpy as np

from slipcircle import read_suite
from slipcircle.workbench.records.records import read_record
from tests.campaigns import options
from tests.support.recordfiles import FILES, NORTH, TIME, read_pore_pressure, rows

SECONDS = 2.0
TABLES = (
    "time (s),acc (g)\n" + rows(TIME, NORTH),
    "t;NS (gal);UD (gal)\n" + rows(TIME, NORTH, NORTH, separator=";"),
    rows(TIME, NORTH, separator=" "),
    "60 0.02\n" + rows(NORTH),
    "time,u (kPa)\n" + rows(TIME, NORTH**2),
)
BASES = [text.encode() for text in (*TABLES, *(text for text, _ in FILES.values()))]
ODD = (b"nan", b"-inf", b"1e999", b"1_0", b"\xd9\xa1", b"1,5", b"3.0%", b"9" * 400, b"-", b"", b"\0", b"\xff\xfe",
       b"1d400", b"\n", b"\r", b";", b"\t", b"{step}", b"NPTS", b"(m/s2)", b"2020-01-01T00:00:00", b"#", b'"',
       b"00000000", b"-1")  # fmt: skip
OPTIONS: tuple[dict[str, Any], ...] = (
    {},
    {},
    {"step": 0.02, "units": "g"},
    {"columns": "wrapped", "step": 0.02},
    {"columns": "time,acceleration"},
    {"vertical": "*UD*"},
    {"strict": True},
)


def damaged(rng: Random) -> bytes:
    """Return a file of some format with a few kinds of damage, or random bytes."""
    data = rng.choice(BASES)
    for _ in range(rng.randint(1, 3)):
        start, end = sorted(rng.randint(0, len(data)) for _ in range(2))
        near = min(end, start + rng.choice((1, 8, 80)))
        kind = rng.randrange(7)
        if kind == 0:
            data = data[:end]
        elif kind == 1:
            data = data[:start] + rng.randbytes(near - start) + data[near:]
        elif kind == 2:
            data = data[:start] + rng.choice(ODD) + data[near:]
        elif kind == 3:
            data = data[:start] + data[near:]
        elif kind == 4:
            lines = data.split(b"\n")
            k = rng.randrange(len(lines))
            data = b"\n".join(lines[:k] + lines[k : k + 1] * rng.randint(0, 3) + lines[k + 1 :])
        elif kind == 5:
            fields = data.split(b" ")
            fields[rng.randrange(len(fields))] = rng.choice(ODD)
            data = b" ".join(fields)
        elif rng.random() < 0.2:
            data = rng.choice((rng.randbytes(near), data.decode().encode("utf-16") if data.isascii() else data))
    return data


def fault(path: Path, rng: Random) -> str:
    """Return the fault in the answer for a file, or an empty text."""
    start = time.process_time()
    options = rng.choice(OPTIONS)
    try:
        way = rng.randrange(8)
        if way == 0:
            series = [*read_pore_pressure(path, units=None).values()]
        elif way == 1:
            series = [read_record(path, holds="ground", column=rng.choice((None, 1, 2, "UD")))]
        else:
            series = [entry.record() for entry in read_suite([path], **options)]
        for one in series:
            if not (np.all(np.isfinite(one.values)) and np.all(np.diff(one.time) > 0.0) and one.time.size > 1):
                return "a record with numbers that are not finite, or times that do not increase"
    except ValueError as error:
        lines = 0 if options.get("strict") else str(error).count("\n")
        if lines:
            return f"{lines + 1} lines in a message: {str(error)[:200]!r}"
    except Exception:
        return traceback.format_exc()
    taken = time.process_time() - start
    return f"took {taken:.1f} s" if taken > SECONDS else ""


def faults(numbers: Iterable[int], seed: int, folder: Path) -> list[str]:
    """Return the faults of files by number, each with its number; the files of faults remain in the folder."""
    found = []
    for number in numbers:
        rng = Random(f"{seed} {number}")
        path = folder / f"{number}.txt"
        path.write_bytes(damaged(rng))
        if said := fault(path, rng):
            found.append(f"{path}: {said}")
        else:
            path.unlink()
    return found


if __name__ == "__main__":
    given = options(__doc__, 20_000)
    wrong = faults(range(given.count), given.seed, Path(tempfile.mkdtemp()))
    print(*wrong, f"{given.count} files, {len(wrong)} faults", sep="\n")
    sys.exit(bool(wrong))
