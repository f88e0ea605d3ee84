# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 3d6c1c0c35db8c3f3870af1229817f7ea44bf660955e363cef84307fa7364b58
"""Proved error bounds of the kernels, and the digest of the C source that they speak of."""

DIGEST = "e5a5ee5b12101596552fcc23321739bb4d433c59016452f6fee9699904d9af8f"

# kernel -> tier -> form of the program -> (relative error, error in ulp or None where it is not the measure).
# What is not here is sampled only.
BOUNDS: dict[str, dict[str, dict[str, tuple[float, float | None]]]] = {
}
