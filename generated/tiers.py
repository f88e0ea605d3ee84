# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: dab96deb8f3b6fd3b7fc95df8417f83a778079fd4098f425bd8c51593d3ecff9
"""Proved error bounds of the kernels, and the digest of the C source that they speak of."""

DIGEST = "5f61077f48d532a4d2e070d10bf00cbd090a0a871e36bc5852dfc4bb054d4c65"

# kernel -> tier -> form of the program -> (relative error, error in ulp where that is the measure).
# What is not here is sampled only.
BOUNDS: dict[str, dict[str, dict[str, tuple[float, float | None]]]] = {
}
