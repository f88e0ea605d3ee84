"""A `Program` becomes NumPy source: plain operators and calls, so that another library's arrays may pass through."""

import textwrap
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from derive.code.program import Op, Program, operations

_INFIX = {"add": ("+", 1), "sub": ("-", 1), "mul": ("*", 2), "div": ("/", 2), "less": ("<", 0)}
_CALL = {"min": "minimum", "max": "maximum", "select": "where"}
_ACCURACY = """    accuracy : float, optional
        Relative error to meet: the cheapest tier that is proved to meet it, or a ValueError. By default the best tier.
"""
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
    tiers: Mapping[str, Program] = field(default_factory=dict)  # a kernel of alpha: what NumPy runs at each tier


def body(program: Program, name: str = "", space: str = "np") -> str:
    """The private function that computes a program, one output or a tuple of them.

    ``space`` is the name of the module of array functions; if it is not NumPy's own, callers may pass another.
    """
    uses = Counter(i for op in program.ops for i in op.args) + Counter(program.outputs)
    text: dict[int, tuple[str, int]] = {}
    lines: list[str] = []
    for index, op in enumerate(program.ops):
        expression, rank = _expression(op, text, space)
        free = op.kind in ("input", "const")
        if free or (uses[index] == 1 and len(expression) < _LINE and index not in program.outputs):
            text[index] = (expression, rank)
        else:
            text[index] = (f"v{index}", 9)
            lines.append(f"v{index} = {expression}")
    results = ", ".join(text[i][0] for i in program.outputs)
    signature = ", ".join(f"{x}: Array" for x in program.inputs) + (f", {space}: Any = np" if space != "np" else "")
    returned = "Array" if len(program.outputs) == 1 else f"tuple[{', '.join(['Array'] * len(program.outputs))}]"
    code = "\n".join([*lines, f"return {results}"])
    return f"def _{name or program.name}({signature}) -> {returned}:\n{textwrap.indent(code, '    ')}\n"


def _expression(op: Op, text: dict[int, tuple[str, int]], space: str) -> tuple[str, int]:
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
    if op.kind == "fma" or op.value in ("exponent", "significand"):
        raise ValueError(f"NumPy has no {op.value or op.kind}: emit the plain program, or NumPy's own")
    name = _CALL.get(op.kind) or op.value
    return f"{space}.{name}({', '.join(text[i][0] for i in op.args)})", 9


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
{_ACCURACY if f.tiers else ""}
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
    if f.tiers:
        return _kernel(f, doc)
    names = ", ".join(p.inputs)
    typed = ", ".join(f"{x}: ArrayLike" for x in p.inputs)
    safe = ", ".join(repr(x) for x in f.safe) + ("," if len(f.safe) == 1 else "")
    args = f"{names}," if len(p.inputs) == 1 else names
    return (
        f"{body(p)}\n\n"
        f"def {p.name}({typed}, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True) -> Any:\n{doc}"
        f"    return evaluate(_{p.name}, lambda eps, {names}: {f.inside}, ({safe}), ({args}), out, where)\n"
    )


def _kernel(f: Function, doc: str) -> str:
    """A kernel of alpha: the text of each tier, and a function that leaves the choice to `generated._compiled`."""
    name = f.program.name
    bodies = {tier: identifier(name, "" if tier == "best" else tier) for tier in f.tiers}
    texts = "".join(f"{body(p, bodies[tier], 'xp')}\n\n" for tier, p in f.tiers.items())
    listed = ", ".join(f'"{tier}": _{of}' for tier, of in bodies.items())
    return (
        f'{texts}TEXTS["{name}"] = {{{listed}}}\n_call_{name} = kernel("{name}", TEXTS["{name}"])\n\n\n'
        f"def {name}(\n    alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, "
        f"where: ArrayLike = True, accuracy: float | None = None\n) -> Any:\n{doc}"
        f"    return _call_{name}(alpha, out, where, accuracy)\n"
    )


def identifier(kernel: str, tier: str) -> str:
    """Name of a kernel's tier in source: ``polar_moment_1e_10``."""
    return f"{kernel}_{tier}".replace("-", "_").rstrip("_")


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
    imports, texts = "from generated._evaluate import Array, evaluate\n", ""
    if any(f.tiers for f in functions):
        imports = f"from generated._compiled import Text, kernel\n{imports}"
        texts = "\n# What NumPy runs, by kernel and tier.\nTEXTS: dict[str, dict[str, Text]] = {}\n"
    head = (
        f'"""{docstring}"""\n\nfrom typing import Any\n\n'
        "import numpy as np\nfrom numpy.typing import ArrayLike, NDArray\n\n"
        f"{imports}\n__all__ = [\n    {names},\n]\n{texts}"
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
            f'    """{source}: float64 arrays, no domain check.\n\n'
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
