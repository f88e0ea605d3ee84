# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 52a20944649cfe4c3f70f829bdfa3813947593c99122f752b55ed39e14061485
"""Proved error bounds of the kernels, and the digest of the C source that they speak of."""

DIGEST = "e5a5ee5b12101596552fcc23321739bb4d433c59016452f6fee9699904d9af8f"

# kernel -> tier -> form of the program -> (relative error, error in ulp where that is the measure).
# What is not here is sampled only.
BOUNDS: dict[str, dict[str, dict[str, tuple[float, float | None]]]] = {
}
