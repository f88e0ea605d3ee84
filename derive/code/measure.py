"""The text just emitted, executed: for comparisons, not for certificates."""

import numpy as np

from derive.code import emit
from derive.code.program import Program


def run(program: Program, *args: np.ndarray) -> np.ndarray:
    """Execute the text emitted for a program."""
    space: dict[str, object] = {"np": np, "Array": np.ndarray, "horner": emit.HELPERS["horner"]}
    exec(emit.PythonText().body(program), space)
    with np.errstate(under="ignore"):
        return space[f"_{program.name}"](*args)  # type: ignore[operator]
