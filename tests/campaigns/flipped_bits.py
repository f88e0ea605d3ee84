"""Flip every bit of a stored block: it is read as it was written, or computed again.

Run `python -m tests.campaigns.flipped_bits`.
"""

import tempfile
from collections.abc import Iterable
from pathlib import Path

import numpy as np

from slipcircle.workbench.studies.engines import Folder

BLOCK = {"x": np.arange(3.0), "status": np.array([1, 2])}


def flip(folder: Path, bits: Iterable[int] | None = None) -> tuple[int, int]:
    """Return the numbers of flips, by default of every bit, after which a block was read and not read.

    Raises
    ------
    AssertionError
        If a block that was read is not the one that was written.
    """
    blocks = Folder(folder, {"a": "study"})
    blocks.save(0, BLOCK)
    (path,) = folder.glob("block-*")
    data = path.read_bytes()
    found = [0, 0]
    with open(path, "r+b", buffering=0) as file:
        for bit in range(8 * len(data)) if bits is None else bits:
            place = bit // 8 % len(data)
            file.seek(place)
            file.write(bytes([data[place] ^ 1 << bit % 8]))
            result = blocks.load(0)
            assert result is None or result.keys() == BLOCK.keys(), bit
            assert result is None or all(np.array_equal(result[name], BLOCK[name]) for name in BLOCK), bit
            found[result is None] += 1
            file.seek(place)
            file.write(data[place : place + 1])
    assert blocks.load(0) is not None
    return found[0], found[1]


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        unchanged, refused = flip(Path(folder))
    print(f"{unchanged} flips leave the block as it was, {refused} make it one that is computed again")
