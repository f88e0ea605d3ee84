"""A `Program` becomes NumPy source: plain operators and calls, so that another library's arrays may pass through."""

import re
import runpy
import textwrap
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from derive.code.program import Program, operations
from derive.code.text import WIDTH, Language, Part, Reader, statements


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


PYTHON = Language(
    "python", "{name} = {text}", lambda x: "np.nan" if x != x else repr(x), "horner({x}, ({coefficients}))"
)
TEMPLATES = Path(__file__).resolve().parent / "templates"
HELPERS = runpy.run_path(str(TEMPLATES / "_evaluate.py"))


class PythonText:
    """The private functions of a module, as they are written; each is read back, and may call those before it."""

    def __init__(self) -> None:
        self.reader = Reader({"Array": None, "Any": None, "np": np, "horner": HELPERS["horner"]})
        self.parts: list[Part] = []

    def body(self, program: Program, name: str = "", space: str = "np") -> str:
        """The function that computes a program, one output or a tuple of them.

        ``space`` is the name of the module of array functions; if it is not NumPy's own, callers may pass another.
        """
        name = f"_{name or program.name}"
        lines, results = statements(program, replace(PYTHON, space=space), self.parts)
        signature = ", ".join([*(f"{x}: Array" for x in program.inputs), *[f"{space}: Any = np"] * (space != "np")])
        returned, result = ", ".join(["Array"] * len(results)), ", ".join(results)
        returned = returned if len(results) == 1 else f"tuple[{returned}]"
        code = "\n".join([*lines, f"return ({result})" if len(result) > WIDTH - 8 else f"return {result}"])
        text = f"def {name}({signature}) -> {returned}:\n{textwrap.indent(code, '    ')}\n"
        self.reader.check(program, name, text)
        if len(program.inputs) == len(program.outputs) == 1 and len(program.ops) > 9:
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


def numpydoc(
    summary: str,
    formula: str,
    parameters: Iterable[tuple[str, str, str]],
    returns: tuple[str, str],
    *notes: str,
    width: int = 112,
) -> str:
    """The docstring of a function; parameters are named, typed and described."""
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
        '"""',
    ]
    return "".join(f"{_fill(f'    {line}'.rstrip(), width)}\n" for line in lines)


def function(f: Function, text: PythonText) -> str:
    """A public function: signature, numpydoc docstring, and the call of its body."""
    p = f.program
    doc = numpydoc(
        f.summary,
        f.formula,
        [*((n, "array_like", words) for n, words in f.parameters), _OUT, _WHERE, *[_ACCURACY] * bool(f.tiers)],
        (
            "ndarray or scalar",
            f"{f.returns} Broadcast shape of the arguments; scalars in, scalar out; float32 stays float32.",
        ),
        f"Domain: {f.domain}; elsewhere NaN and NumPy's ``invalid`` flag.",
        f"Accuracy: {f.accuracy}",
        f"Source: {f.equation}. Operations: {operations(p.operations())}.",
    )
    if f.tiers:  # a kernel of alpha: the text of each tier, and a function that leaves the choice to `_compiled`
        bodies = {tier: identifier(p.name, "" if tier == "best" else tier) for tier in f.tiers}
        texts = "".join(f"{text.body(of, bodies[tier], 'xp')}\n\n" for tier, of in f.tiers.items())
        listed = ", ".join(f'"{tier}": _{of}' for tier, of in bodies.items())
        return (
            f'{texts}TEXTS["{p.name}"] = {{{listed}}}\n_call_{p.name} = kernel("{p.name}", TEXTS["{p.name}"])\n\n\n'
            f"def {p.name}(\n    alpha: ArrayLike, /, out: NDArray[Any] | None = None, *, "
            f"where: ArrayLike = True, accuracy: float | None = None\n) -> Any:\n{doc}"
            f"    return _call_{p.name}(alpha, out, where, accuracy)\n"
        )
    names = ", ".join(p.inputs)
    typed, args = ", ".join(f"{x}: ArrayLike" for x in p.inputs), names + "," * (len(p.inputs) == 1)
    inside = f.inside.replace(") & ", ")\n            & ")
    return (
        f"{text.body(p)}\n\n"
        f"def {p.name}(\n    {typed}, /, out: NDArray[Any] | None = None, *, where: ArrayLike = True\n) -> Any:\n{doc}"
        f"    return evaluate(\n        _{p.name},\n        lambda eps, {names}: (\n            {inside}\n        ),\n"
        f"        {f.safe!r},\n        ({args}),\n        out,\n        where,\n    )\n"
    )


def identifier(kernel: str, tier: str) -> str:
    """Name of a kernel's tier in source: ``polar_moment_1e_10``."""
    return f"{kernel}_{tier}".replace("-", "_").rstrip("_")


def _fill(line: str, width: int = 112) -> str:
    """Wrap a docstring line, keeping its indent."""
    indent = line[: len(line) - len(line.lstrip())]
    return textwrap.fill(line, width, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)


def module(docstring: str, functions: Sequence[Function]) -> str:
    """A module of public functions."""
    text = PythonText()
    tables = "# What NumPy runs, by kernel and tier.\nTEXTS: dict[str, dict[str, Text]] = {}\n"
    code = "".join(f"\n\n{function(f, text)}" for f in functions)
    return _module(docstring, [f.program.name for f in functions], (tables if "TEXTS[" in code else "") + code)


def raw_module(docstring: str, programs: Sequence[tuple[Program, str]]) -> str:
    """A module of bare formulas: no domain, no types, no care, and no warnings."""
    text, code = PythonText(), ""
    for p, source in programs:
        typed, names = ", ".join(f"{x}: Array" for x in p.inputs), ", ".join(p.inputs)
        code += (
            f"\n\n{text.body(p)}\n\ndef {p.name}({typed}) -> Array:\n"
            f'    """{source}: float64 arrays, no domain check.\n\n'
            f'    Operations: {operations(p.operations())}.\n    """\n'
            f'    with np.errstate(all="ignore"):\n        return _{p.name}({names})\n'
        )
    return _module(docstring, [p.name for p, _ in programs], code)


def plain_module(docstring: str, programs: Sequence[tuple[Program, str]], code: str = "") -> str:
    """A module of functions for callers that know the domain: arrays or floats in, no checks; each with its docstring.

    ``code`` is what stands before them.
    """
    for p, doc in programs:
        signature, body = PythonText().body(p).replace("Array", "Any").replace("def _", "def ", 1).split("\n", 1)
        code += f"\n\n{signature}\n{doc}{body}"
    return _module(docstring, [p.name for p, _ in programs], code)


def described(programs: Iterable[tuple[Program, str]]) -> list[tuple[Program, str]]:
    """Programs by name, each with a docstring of one sentence and what it costs."""
    sentences = ((p, f"{sentence(words)} Operations: {operations(p.operations()) or 'none'}.") for p, words in programs)
    return [(p, _fill(f'    """{words}"""') + "\n") for p, words in sorted(sentences, key=lambda x: x[0].name)]


# What a generated module may need, in this order.
_IMPORTS = (
    "from typing import Any",
    "",
    "import numpy as np",
    "from numpy.typing import ArrayLike, NDArray",
    "",
    "from generated._compiled import Text, kernel",
    "from generated._evaluate import Array, evaluate, horner",
)


def _module(docstring: str, names: list[str], code: str) -> str:
    """The whole text, with imports of what it uses, and tables of the coefficients that it uses more than once."""
    series, data = Counter(re.findall(r"horner\(\w+, (\([^()]+\))\)", code)), ""
    for k, numbers in enumerate((x for x, n in series.items() if n > 1), 1):
        code = code.replace(numbers, f"SERIES_{k}")
        data += f"\nSERIES_{k} = {numbers}"
    used = set(re.findall(r"\w+", re.sub(r'"(?:"".*?""|[^"\n]*)"', "", code, flags=re.DOTALL)))
    imports = []
    for line in _IMPORTS:
        start, _, wanted = line.rpartition("import ")
        found = [x for x in wanted.split(", ") if x.split()[-1:] == ["np"] or x in used]
        imports += [f"{start}import {', '.join(found)}"] if found else [] if line else [""]
    lines = re.sub(r"\n{3,}", "\n\n", "\n".join(imports).strip())
    listed = "".join(f'    "{n}",\n' for n in names)
    head = f'"""{docstring}"""\n\n{lines}\n\n__all__ = [\n{listed}]\n{data}' + "\n" * bool(data)
    return head + ("\n" if code[0] == "#" else "") + code


def sentence(words: str) -> str:
    """With a capital and a full stop; a symbol stays as it is."""
    first = words.split(maxsplit=1)[0].strip(":,")
    return f"{words[0].upper() if first.isalpha() and first.islower() else words[0]}{words[1:]}."


_ITEM = re.compile(r"""(?:'(?:[^'\\]|\\.)*'|"(?:[^"\\]|\\.)*"|[^'",]|,(?! ))+(?:, ?|$)""")


def wrapped(text: str) -> str:
    """The text with lines of at most 120 columns: longer ones, calls and data, break after commas and in strings."""
    return "\n".join(
        "\n".join(_wrap(line)) if len(line) > 120 and '"""' not in line else line for line in text.split("\n")
    )


def _wrap(line: str) -> list[str]:
    indent = " " * (len(line) - len(line.lstrip()) + (8 if line.startswith("def") else 4))
    lines, last = [], ""
    for item in _ITEM.findall(line):
        if last.strip() and len(last + item.rstrip()) > 120:
            lines.append(last.rstrip())
            last = indent
        last += item
        while len(last.rstrip()) > 120:  # two strings beside each other are one
            cut = last.rfind(" ", 0, 118) + 1
            quote = next((q for q in "'\"" if last.count(q, 0, cut) % 2), "")
            cut = cut if quote else max(last.rfind(sign, 0, 118) for sign in "*/") + 1
            lines.append(last[:cut] + quote)
            last = indent + quote + last[cut:]
    return [*lines, last.rstrip()]
