"""The exact interpreter: what a `Program` gives when each operation is rounded once to float64, on any machine."""

import numpy as np

from derive.code.arithmetic import Floats
from derive.code.operations import OPERATIONS
from derive.code.program import Op, Program, walk


def run(program: Program, alpha: Floats) -> Floats:
    """The program's only output at each of many inputs.

    Raises
    ------
    ValueError
        For an operation that is not rounded exactly everywhere, such as NumPy's logarithm.
    """
    alpha = np.ascontiguousarray(alpha, dtype=np.float64)

    def make(op: Op, operands: list[Floats]) -> Floats:
        if op.kind == "const":
            return np.full(alpha.shape, op.value, dtype=np.float64)
        if (meaning := OPERATIONS[op.kind].meaning) is None:
            raise ValueError(f"no exact meaning of {op.kind}")
        return np.asarray(meaning(*operands))

    with np.errstate(under="ignore"):
        (result,) = walk(program, dict.fromkeys(program.inputs, alpha), make)
    return result
