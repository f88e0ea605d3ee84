"""What a `Program` gives when each operation is rounded once to float64: the same on any machine, but for NumPy's calls
of a library, such as its logarithm."""

from typing import Any

import numpy as np

from derive.code.operations import OPERATIONS
from derive.code.program import Op, Program, walk


def run(program: Program, *args: Any) -> Any:
    """The program's only output at each of many inputs."""

    def make(op: Op, operands: list[Any]) -> Any:
        return np.float64(op.value) if op.kind == "const" else OPERATIONS[op.kind].meaning(*operands)

    with np.errstate(under="ignore"):
        (result,) = walk(program, dict(zip(program.inputs, map(np.float64, args), strict=True)), make)
    return result
