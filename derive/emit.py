"""A `Program` becomes NumPy source: plain operators and calls, so that other array types pass through."""

import textwrap
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass

from derive.program import Op, Program, operations

_INFIX = {"add": ("+", 1), "sub": ("-", 1), "mul": ("*", 2), "div": ("/", 2), "less": ("<", 0)}
_CALL = {"min": "np.minimum", "max": "np.maximum", "select": "np.where"}
_LINE = 96  # an expression longer than this gets a name


@dataclass(frozen=True)
class Function:
    """What a public function needs besides its program: the words of its docstring and its domain."""

    program: Program
    summary: str
    formula: str
    equation: str
    parameters: tuple[tuple[str, str], ...]
    returns: str
    domain: str  # in words
    inside: str  # in Python, over the arguments and `eps` of their type
    safe: tuple[float, ...]  # a point inside, used in the place of arguments outside
    accuracy: str


def body(program: Program) -> str:
    """The private function that computes a program, one output or a tuple of them."""
    uses = Counter(i for op in program.ops for i in op.args) + Counter(program.outputs)
    text: dict[int, tuple[str, int]] = {}
    lines: list[str] = []
    for index, op in enumerate(program.ops):
        expression, rank = _expression(op, text)
        free = op.kind in ("input", "const")
        if free or (uses[index] == 1 and len(expression) < _LINE and index not in program.outputs):
            text[index] = (expression, rank)
        else:
            text[index] = (f"v{index}", 9)
            lines.append(f"v{index} = {expression}")
    results = ", ".join(text[i][0] for i in program.outputs)
    signature = ", ".join(f"{x}: Array" for x in program.inputs)
    returned = "Array" if len(program.outputs) == 1 else f"tuple[{', '.join(['Array'] * len(program.outputs))}]"
    code = "\n".join([*lines, f"return {results}"])
    return f"def _{program.name}({signature}) -> {returned}:\n{textwrap.indent(code, '    ')}\n"


def _expression(op: Op, text: dict[int, tuple[str, int]]) -> tuple[str, int]:
    """Source of one operation, and how tightly it binds."""
    if op.kind == "input":
        return str(op.value), 9
    if op.kind == "const":
        value = float(op.value)  # type: ignore[arg-type]
        if value != value:
            return "np.nan", 9
        return repr(value), 9 if value >= 0 else 3
    if op.kind == "neg":
        inner, rank = text[op.args[0]]
        return f"-{inner if rank > 2 else f'({inner})'}", 2
    if op.kind in _INFIX:
        sign, rank = _INFIX[op.kind]
        left, right = text[op.args[0]], text[op.args[1]]
        first = left[0] if left[1] >= rank else f"({left[0]})"
        second = right[0] if right[1] > rank else f"({right[0]})"
        return f"{first} {sign} {second}", rank
    if op.kind == "fma":
        raise ValueError("NumPy has no fused multiply-add: emit the plain program")
    name = _CALL.get(op.kind) or f"np.{op.value}"
    return f"{name}({', '.join(text[i][0] for i in op.args)})", 9


def function(f: Function) -> str:
    """A public function: signature, numpydoc docstring, and the call of its body."""
    p = f.program
    parameters = "".join(f"    {n} : array_like\n        {words}\n" for n, words in f.parameters)
    doc = f'''    """{f.summary}

    {f.formula}

    Parameters
    ----------
{parameters}    out : ndarray, optional
        Where the result goes.
    where : array_like of bool, optional
        Lanes to compute; others keep what `out` holds (NaN without `out`).

    Returns
    -------
    ndarray or scalar
        {f.returns} Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.

    Notes
    -----
    Domain: {f.domain}; elsewhere NaN and NumPy's ``invalid`` flag.
    Accuracy: {f.accuracy}
    Source: {f.equation}. Operations: {operations(p.operations())}.
    """
'''
    doc = "\n".join(_fill(line) for line in doc.splitlines()) + "\n"
    names = ", ".join(p.inputs)
    typed = ", ".join(f"{x}: ArrayLike" for x in p.inputs)
    safe = ", ".join(repr(x) for x in f.safe) + ("," if len(f.safe) == 1 else "")
    args = f"{names}," if len(p.inputs) == 1 else names
    return (
        f"{body(p)}\n\n"
        f"def {p.name}({typed}, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:\n{doc}"
        f"    return evaluate(_{p.name}, lambda eps, {names}: {f.inside}, ({safe}), ({args}), out, where)\n"
    )


def _fill(line: str) -> str:
    """Wrap a docstring line at the width of the page, keeping its indent."""
    if len(line) <= 112:
        return line
    indent = line[: len(line) - len(line.lstrip())]
    return textwrap.fill(line, 112, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)


def module(docstring: str, functions: Iterable[Function]) -> str:
    """A module of public functions."""
    functions = list(functions)
    names = ",\n    ".join(f'"{f.program.name}"' for f in functions)
    head = (
        f'"""{docstring}"""\n\nfrom typing import Any\n\n'
        "import numpy as np\nfrom numpy.typing import ArrayLike, NDArray\n\n"
        f"from generated._evaluate import Array, evaluate\n\n__all__ = [\n    {names},\n]\n"
    )
    return head + "".join(f"\n\n{function(f)}" for f in functions)


def raw_module(docstring: str, programs: Iterable[tuple[Program, str]]) -> str:
    """A module of bare formulas: no domain, no types, no care, and no warnings."""
    programs = list(programs)
    names = ",\n    ".join(f'"{p.name}"' for p, _ in programs)
    text = (
        f'"""{docstring}"""\n\nimport numpy as np\n\n'
        f"from generated._evaluate import Array\n\n__all__ = [\n    {names},\n]\n"
    )
    for p, source in programs:
        typed, names = ", ".join(f"{x}: Array" for x in p.inputs), ", ".join(p.inputs)
        text += (
            f"\n\n{body(p)}\n\ndef {p.name}({typed}) -> Array:\n"
            f'    """{source}, as printed: float64 arrays, no domain check.\n\n'
            f'    Operations: {operations(p.operations())}.\n    """\n'
            f'    with np.errstate(all="ignore"):\n        return _{p.name}({names})\n'
        )
    return text


def plain_module(docstring: str, programs: Iterable[tuple[Program, str]]) -> str:
    """A module of functions for callers that know the domain: arrays or floats in, no checks."""
    programs = sorted(programs, key=lambda p: p[0].name)
    names = ",\n    ".join(f'"{p.name}"' for p, _ in programs)
    text = f'"""{docstring}"""\n\nfrom typing import Any\n\nimport numpy as np\n\n__all__ = [\n    {names},\n]\n'
    for p, words in programs:
        code = body(p).replace("Array", "Any").replace(f"def _{p.name}", f"def {p.name}", 1)
        head, rest = code.split("\n", 1)
        text += (
            f'\n\n{head}\n    """{words.capitalize()}. Operations: {operations(p.operations()) or "none"}."""\n{rest}'
        )
    return text
