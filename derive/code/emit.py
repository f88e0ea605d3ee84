"""NumPy source of a `Program`: plain operators and calls, so that arrays of other libraries may be passed."""

import re
import textwrap
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from derive.code.operations import HORNER, TEMPLATES
from derive.code.program import Program
from derive.code.text import WIDTH, Language, Part, Reader, statements
from derive.kinds import Coefficients, Names, TextMap, TextPair, Texts


@dataclass(frozen=True)
class Function:
    """Public function: its program, the texts of its docstring, and its tiers."""

    program: Program
    summary: str
    formula: str
    equation: str
    parameters: tuple[TextPair, ...]
    returns: str
    domain: str  # description
    accuracy: str
    given: Coefficients  # arguments of the example
    tiers: Mapping[str, Program]  # NumPy program of each tier


PYTHON = Language("python", "{name} = {text}", repr, several="{names} = {function}({arguments})")
# Imports of all generated modules; of the certified functions beyond these, and of their stub.
IMPORTS = "from __future__ import annotations\n\nfrom typing import Any\n\nimport numpy as np\n"
KERNEL_IMPORTS = """
from generated._compiled import Text, direct, kernel
from generated._evaluate import Array, horner, lost
"""
STUB_IMPORTS = """\
from __future__ import annotations

from typing import Any, TypeVar, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from generated._compiled import Text
from generated._evaluate import Out
"""
PROCESSOR = (TEMPLATES / "_processor.h").read_text(encoding="utf-8").strip()  # part of each C file


def filled(name: str, marks: TextMap | None = None) -> str:
    """Return the text of the template ``name`` with values in place of its marks.

    A mark for lines occupies its own line.
    """
    text = (TEMPLATES / name).read_text("utf-8")
    for mark, value in (marks or {}).items():
        line = "\n" * value.endswith("\n")
        text = text.replace(f"@{mark}@{line}", value)
    return text


class PythonText:
    """Private functions of a module. Each is read back after it is written, and may call earlier functions."""

    def __init__(self) -> None:
        self.reader = Reader({"Array": None, "Any": None, "np": np, "horner": HORNER})
        self.reader.scope["lost"] = partial(self.reader.builder.put, "lost")
        self.parts: list[Part] = []

    def body(self, program: Program, name: str = "", space: str = "np") -> str:
        """Return the function that computes a program, with one output or a tuple.

        ``space`` is the name of the module of array functions. If it is not ``np``, callers may pass another module.
        """
        name = f"_{name or program.name}"
        passed = () if space == "np" else (space,)
        lines, results = statements(program, replace(PYTHON, space=space, passed=passed), self.parts)
        parameters = [f"{x}: Array" for x in program.inputs]
        if space != "np":
            parameters.append(f"{space}: Any = np")
        returned = ", ".join(["Array"] * len(results))
        if len(results) > 1:
            returned = f"tuple[{returned}]"
        result = ", ".join(results)
        lines.append(f"return ({result})" if len(result) > WIDTH - 8 else f"return {result}")
        code = textwrap.indent("\n".join(lines), "    ")
        text = f"def {name}({', '.join(parameters)}) -> {returned}:\n{code}\n"
        self.reader.check(program, name, text)
        if len(lines) > 1:  # one expression is as short as a call
            self.parts.append(Part(name, program))
        return text


_OUT = ("out", "ndarray, optional", "Where the result goes.")
_WHERE = (
    "where",
    "array_like of bool, optional",
    "Lanes to compute; others keep what `out` holds (NaN without `out`).",
)
_ACCURACY = (
    "accuracy",
    "float, optional",
    "Relative error to meet: the cheapest tier that is proved to meet it, or a ValueError. By default the best tier.",
)


ARRAYS = (
    "Arrays: numbers, lists, NumPy, pint, xarray, pandas, Dask and JAX. Safe in threads. Compiled, an element of a "
    "large array takes about 1 ns. Unlike NumPy's ufuncs, arguments may be named and `out` is one array, not a tuple; "
    "dtype= and casting= are not supported."
)


def numpydoc(
    summary: str,
    formula: str,
    parameters: Iterable[tuple[str, str, str]],
    returns: TextPair,
    *notes: str,
    examples: Sequence[str] = (),
    width: int = 112,
) -> str:
    """Return the docstring of a function. Parameters have a name, a type and a description."""
    listed = [line for name, kind, words in parameters for line in (f"{name} : {kind}", f"    {words}")]
    lines = [
        f'"""{summary}',
        "",
        formula,
        "",
        "Parameters",
        "----------",
        *listed,
        "",
        "Returns",
        "-------",
        returns[0],
        f"    {returns[1]}",
        "",
        "Notes",
        "-----",
        *notes,
    ]
    if examples:
        lines += ["", "Examples", "--------", *examples]
    text = ""
    for line in (*lines, '"""'):
        indented = f"    {line}".rstrip()
        indent = indented[: len(indented) - len(indented.lstrip())]
        text += textwrap.fill(indented, width, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)
        text += "\n"
    return text


def example(p: Program, place: str, given: Sequence[float]) -> Names:
    """Return a call and its printed result, with few enough digits to be equal on every processor.

    ``place`` is the module of the function, and ``given`` its arguments.
    """
    first = "[0]" * (len(p.outputs) > 1)
    call = f"{p.name}({', '.join(map(str, given))}){first}"
    return (f">>> from {place} import {p.name}", f'>>> print(f"{{{call}:.6f}}")', f"{float(p.run(*given)):.6f}")


def function(f: Function, text: PythonText) -> str:
    """Return the source of a public function: the text of each tier, and its signature and docstring."""
    name = f.program.name
    inputs = f.program.inputs
    parameters = [(x, "array_like", words) for x, words in f.parameters]
    returns = f"{f.returns} Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32."
    doc = numpydoc(
        f.summary,
        f.formula,
        [*parameters, _OUT, _WHERE, _ACCURACY],
        ("ndarray or scalar", returns),
        f"Domain: {f.domain}; elsewhere NaN and NumPy's ``invalid`` flag, of NaN without.",
        f"Accuracy: {f.accuracy}",
        f"Source: {f.equation}.",
        ARRAYS,
        examples=example(f.program, "generated", f.given),
    )
    more = ", both_ends=True" if len(inputs) > 1 else ""
    bodies = {tier: identifier(name, "" if tier == "best" else tier) for tier in f.tiers}
    parts = [text.body(of, bodies[tier], "xp") for tier, of in f.tiers.items()]
    texts = "".join(f"{part}\n\n" for part in parts)
    rows = ", ".join(f'"{tier}": _{of}' for tier, of in bodies.items())
    names = ", ".join(inputs)
    return (
        f'{texts}TEXTS["{name}"] = {{{rows}}}\n_call_{name} = kernel("{name}", TEXTS["{name}"]{more})\n\n\n'
        f"@direct\ndef {name}({names}, out=None, *, where=True, accuracy=None):\n{doc}"
        f"    return _call_{name}({names}, out, where, accuracy)\n"
    )


def identifier(kernel: str, tier: str) -> str:
    """Return the name of a kernel's tier in source, ``polar_moment_1e_10`` for the tier 1e-10."""
    return f"{kernel}_{tier}".replace("-", "_").rstrip("_")


def functions_module(docstring: str, functions: Sequence[Function], parts: Sequence[Program]) -> str:
    """Return the module of the certified functions, preceded by the parts that they call."""
    text = PythonText()
    code = "# What NumPy runs, by kernel and tier.\nTEXTS: dict[str, dict[str, Text]] = {}\n"
    code += "".join("\n\n" + text.body(p, space="xp") for p in parts)
    code += "".join(f"\n\n{function(f, text)}" for f in functions)
    return _module(docstring, [f.program.name for f in functions], code, KERNEL_IMPORTS)


def stub(functions: Sequence[Function]) -> str:
    """Return the types of the certified functions as a stub file, so that `help` shows no line for a signature."""
    code = 'F = TypeVar("F", np.float64, np.float32, np.float16)\n__all__: list[str]\n'
    code += "TEXTS: dict[str, dict[str, Text]]\n"
    for f in functions:
        for kinds, out, where, result in _overloads(len(f.program.inputs)):
            typed = ", ".join(f"{x}: {kind}" for x, kind in zip(f.program.inputs, kinds, strict=True))
            code += (
                f"\n@overload\ndef {f.program.name}(\n    {typed},\n    out: {out} = None,\n    *,\n"
                f"    where: {where} = True,\n    accuracy: float | None = None,\n) -> {result}: ...\n"
            )
    return f"{STUB_IMPORTS}\n{code}"


def _overloads(count: int) -> Iterator[tuple[Texts, str, str, str]]:
    """Yield types of ``count`` arguments, `out`, `where` and result: for numbers, arrays and numbers, and otherwise."""
    yield ["float"] * count, "None", "bool", "np.float64"
    for k in range(count):
        before = ["float"] * k
        after = ["NDArray[F] | float"] * (count - k - 1)
        kinds = [*before, "NDArray[F]", *after]
        yield kinds, "None", "ArrayLike", "NDArray[F]"
    yield ["ArrayLike"] * count, "Out", "ArrayLike", "Any"


_GIVEN = {"theta_1": 5.0, "theta_2": 6.0, "alpha": 0.5}  # arguments at which the appendices are real


def raw_module(docstring: str, programs: Sequence[tuple[Program, str]], place: str) -> str:
    """Return a module of bare formulas, each a program with its source in the paper, without checks or warnings.

    ``place`` is the name of the module, from which the examples import.
    """
    documented = []
    for p, source in programs:
        lines = [
            f'"""Return {source}; float64 arrays, no domain check.',
            "\n    ".join(example(p, place, [_GIVEN[x] for x in p.inputs])) + '\n    """\n',
        ]
        documented.append((p, "    " + "\n\n    ".join(lines)))
    return plain_module(docstring, documented, before='@np.errstate(all="ignore")\n')


def plain_module(
    docstring: str, programs: Sequence[tuple[Program, str]], code: str = "", before: str = "", imports: str = ""
) -> str:
    """Return a module of functions for callers that respect the domain: arrays or floats, without checks.

    ``code`` precedes them, and each has the decorator ``before``.
    """
    text = PythonText()
    for p, doc in programs:
        public = re.sub(r"\b_(\w+\()", r"\1", text.body(p).replace("Array", "Any"))
        signature, body = public.split("\n", 1)
        code += f"\n\n{before}{signature}\n{doc}{body}"
    return _module(docstring, [p.name for p, _ in programs], code, imports)


def _module(docstring: str, names: Texts, code: str, imports: str) -> str:
    """Return the complete text of a module that exports these names, with ``imports`` beyond those of all modules.

    Coefficients that occur repeatedly become tables.
    """
    series = Counter(re.findall(r"horner\(\w+, (\([^()]+\))\)", code))
    data = ""
    for k, numbers in enumerate((x for x, n in series.items() if n > 1), 1):
        code = code.replace(numbers, f"SERIES_{k}")
        data += f"\nSERIES_{k} = {numbers}"
    listed = "".join(f'    "{n}",\n' for n in names)
    head = f'"""{docstring}"""\n\n{IMPORTS}{imports}\n__all__ = [\n{listed}]\n{data}'
    if data:
        head += "\n"
    if code.startswith("#"):
        head += "\n"
    return head + code


_ITEM = re.compile(r"""(?:'(?:[^'\\]|\\.)*'|"(?:[^"\\]|\\.)*"|[^'",]|,(?! ))+(?:, ?|$)""")


def wrapped(text: str) -> str:
    """Return the text with lines of at most 120 columns. Longer lines break after commas and in strings."""
    lines: Texts = []
    for line in text.split("\n"):
        lines += _wrap(line) if len(line) > 120 and '"""' not in line else [line]
    return "\n".join(lines)


def _wrap(line: str) -> Texts:
    """Return a line broken into lines of at most 120 columns, after commas and in strings, where it has such places."""
    indent = " " * (len(line) - len(line.lstrip()) + (8 if line.startswith("def") else 4))
    lines = []
    last = ""
    for item in _ITEM.findall(line):
        if last.strip() and len(last + item.rstrip()) > 120:
            lines.append(last.rstrip())
            last = indent
        last += item
        while len(last.rstrip()) > 120:  # adjacent strings are joined
            cut = last.rfind(" ", 0, 118) + 1
            if not _open_quote(last, cut):
                cut = max(last.rfind(sign, 0, 118) for sign in "*/") + 1
            quote = _open_quote(last, cut)
            if not last[:cut].strip(" '\""):
                break
            lines.append(last[:cut] + quote)
            last = indent + quote + last[cut:]
    return [*lines, last.rstrip()]


def _open_quote(line: str, place: int) -> str:
    """Return the quotation mark of the string that contains a place of a line, empty outside of strings."""
    return next((q for q in "'\"" if line.count(q, 0, place) % 2), "")
