"""The exact interpreter: what a `Program` gives when each operation is rounded once to float64, on any machine."""

import numpy as np

from derive.code.arithmetic import Floats
from derive.code.operations import OPERATIONS
from derive.code.program import Program


def run(program: Program, alpha: Floats) -> Floats:
    """The program's only output at each of many inputs.

    Raises
    ------
    ValueError
        For an operation that is not rounded exactly everywhere, such as NumPy's logarithm.
    """
    alpha = np.ascontiguousarray(alpha, dtype=np.float64)
    values: list[Floats] = []
    with np.errstate(under="ignore"):
        for op in program.ops:
            if op.kind == "input":
                values.append(alpha)
            elif op.kind == "const":
                values.append(np.full(alpha.shape, float(op.value or 0.0)))
            else:
                meaning = OPERATIONS[op.name].meaning
                if meaning is None:
                    raise ValueError(f"no exact meaning of {op.name}")
                values.append(meaning(*(values[i] for i in op.args)))
    return values[program.outputs[0]]
