# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 92cc874dcfb57e12969556981a03b12359284cf4516aa40dc9a9f596dca267f9
"""Proved error bounds of the kernels, and the digest of the C source that they speak of."""

DIGEST = "aae2a083edbcae9ff941526ffa831343bccf463ace4fd836fc6abf8cf432d23e"

# kernel -> tier -> form of the program -> (relative error, error in ulp where that is the measure).
# What is not here is sampled only.
BOUNDS: dict[str, dict[str, dict[str, tuple[float, float | None]]]] = {
}
