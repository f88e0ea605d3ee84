"""Readable text of a program: named values, polynomials by their coefficients, and calls of named parts.

The text is read back: executed on operands that record operations, it must reproduce the operations of the program and
no others.
"""

import textwrap
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

from derive.check.proof import ProofError
from derive.code.operations import OPERATIONS
from derive.code.program import Builder, Op, Program, flat, walk
from derive.kinds import Names, Texts, ValueDict

WIDTH = 116  # width of a statement, including its indent
INLINE = 72  # greatest length of a value that is written where it is used once


@dataclass(frozen=True)
class Language:
    """Notation of statements and numbers in Python or C."""

    templates: str  # the field of an `Operation`
    statement: str
    number: Callable[[float], str]
    space: str = ""
    passed: Names = ()  # further arguments of every call of a part
    several: str = ""  # call with several results: {names}, {function}, {arguments}, {places} of results


@dataclass(frozen=True)
class Part:
    """Program contained in others, and the name of its function. Its first output must need all inputs."""

    name: str
    program: Program


class Call(NamedTuple):
    """Call of a part: its name, and the indices of its arguments and results."""

    function: str
    arguments: tuple[int, ...]
    results: tuple[int, ...]


class _Text:
    """Statements of a program in ``lines``, and the text of each value with its precedence."""

    def __init__(self, program: Program, language: Language, parts: Sequence[Part]) -> None:
        self.program = program
        self.language = language
        self.text: dict[int, tuple[str, int]] = {}
        self.lines: Texts = []
        self.counts: Counter[str] = Counter()
        self.names = _known(program)
        self.calls = _calls(program, parts)
        uses = self._uses()
        for i in sorted(uses):
            if i in self.calls and len(self.calls[i].results) > 1:
                self._several(self.calls[i])
                continue
            self.text[i] = self._expression(i)
            if program.ops[i].kind in ("input", "const"):
                continue
            named = i in self.names or self._is_polynomial(i) or len(self.text[i][0]) > INLINE
            if uses[i] > 1 or (named and i not in program.outputs):
                self._name(i)

    def _uses(self) -> Counter[int]:
        """Return how often each needed value is written, by index, where calls are written as such."""
        ops = self.program.ops
        uses = Counter(self.program.outputs)
        called = set[Call]()
        for i in range(len(ops) - 1, -1, -1):
            if not uses[i]:
                continue
            if call := self.calls.get(i):
                uses.update(call.arguments * (call not in called))
                called.add(call)
            else:
                uses.update(ops[i].args)
        return uses

    def _expression(self, i: int) -> tuple[str, int]:
        """Return the text of a value and its precedence; ``i`` is its index in the program."""
        op = self.program.ops[i]
        if op.kind == "input":
            return str(op.value), 9
        if op.kind == "const":
            value = float(op.value)  # type: ignore[arg-type]
            return self.language.number(value), 3 if value < 0 else 9
        if i in self.calls:
            call = self.calls[i]
            return f"{call.function}({self._arguments(call)})", 9
        if self._is_polynomial(i):
            (x,) = op.args
            if not self.text[x][0].isidentifier():
                self._name(x)
        else:
            while len(self._operation(op)) > WIDTH - 24:  # room for the name
                self._name(max(op.args, key=lambda a: len(self.text[a][0])))
        return self._operation(op), OPERATIONS[op.kind].binds

    def _arguments(self, call: Call) -> str:
        """Return the arguments of a call as text."""
        return ", ".join([*(self.text[a][0] for a in call.arguments), *self.language.passed])

    def _several(self, call: Call) -> None:
        """Append the statement of a call with several results, which have names, at its first occurrence."""
        if call.results[0] in self.text:
            return
        names = []
        for i in call.results:
            names.append(self._new_name(i))
            self.text[i] = (names[-1], 9)
        parts = {"function": call.function, "arguments": self._arguments(call), "names": ", ".join(names)}
        self.lines.append(self.language.several.format(**parts, places=", ".join(f"&{x}" for x in names)))

    def _operation(self, op: Op) -> str:
        """Return an operation on the texts of its operands, with brackets where their precedence requires them."""
        operation = OPERATIONS[op.kind]
        coefficients = op.value if isinstance(op.value, tuple) else ()
        numbers = ", ".join(map(self.language.number, coefficients))
        template = getattr(operation, self.language.templates)
        if not template:
            raise ValueError(f"{op.kind} has no place in {self.language.templates}")
        operands = []
        for place, need in zip(op.args, operation.needs):  # noqa: B905 (three needs, fewer operands)
            text, binds = self.text[place]
            operands.append(text if binds >= need else f"({text})")
        degree = len(coefficients) - 1
        return str(template.format(*operands, space=self.language.space, degree=degree, coefficients=numbers))

    def _is_polynomial(self, i: int) -> bool:
        """Return whether value ``i`` is a polynomial, which has a name and whose argument has one."""
        return self.program.ops[i].kind.endswith("horner")

    def _new_name(self, i: int) -> str:
        """Return a new name for value ``i``: p1, p2, ... for polynomials and t1, t2, ... for other values."""
        name = self.names.get(i)
        if not name:
            letter = "p" if self._is_polynomial(i) else "t"
            self.counts[letter] += 1
            name = f"{letter}{self.counts[letter]}"
        taken = {text for text, _ in self.text.values()}.union(self.program.inputs)
        first = name
        k = 1
        while name in taken:
            k += 1
            name = f"{first}_{k}"
        return name

    def _name(self, i: int) -> None:
        """Give value ``i`` a name and a statement."""
        text = self.text[i][0]
        name = self._new_name(i)
        line = self.language.statement.format(name=name, text=text)
        if len(line) > WIDTH:
            lines = textwrap.wrap(line, WIDTH - 8, subsequent_indent="    ", break_long_words=False)
            line = "\n".join(lines)
        self.lines.append(line)
        self.text[i] = (name, 9)


def _known(program: Program) -> dict[int, str]:
    """Return the conventional names of values in a kernel of alpha, by the value's index."""
    ops = program.ops
    names: dict[int, str] = {}
    for i, op in enumerate(ops):
        if op.kind not in ("sub", "mul"):
            continue
        first, second = op.args
        if op.kind == "sub":
            if (ops[first].kind, ops[second].kind) == ("const", "input"):
                names[i] = "b"  # pi/2 - alpha
        elif first == second:
            if ops[first].kind == "input" and str(ops[first].value).isidentifier():
                names[i] = _squared(names.get(first, str(ops[first].value)))
            elif first in names:
                names[i] = _squared(names[first])
    if pieces := seam(program):
        _, near, far = pieces
        names |= {near: "near", far: "far"}
    return names


def _squared(name: str) -> str:
    """Return the name of a square: x_2 of x, x_4 of x_2."""
    base, _, power = name.partition("_")
    if not power:
        return f"{base}_2"
    if power.isdigit():
        return f"{base}_{2 * int(power)}"
    return f"{name}_2"


def seam(program: Program) -> tuple[float, int, int] | None:
    """Return the seam and the indices of both values if the result is a choice between two pieces, otherwise None."""
    output = program.ops[program.outputs[0]]
    if output.kind != "select" or len(program.outputs) > 1:
        return None
    chosen, near, far = output.args
    less = program.ops[chosen]
    if less.kind != "less" or [program.ops[i].kind for i in less.args] != ["input", "const"]:
        return None
    return float(program.ops[less.args[1]].value), near, far  # type: ignore[arg-type]


def _calls(program: Program, parts: Sequence[Part]) -> dict[int, Call]:
    """Return the calls of parts by the indices of their results. If several parts match, the first is used."""
    calls: dict[int, Call] = {}
    places = {op: i for i, op in enumerate(program.ops)}
    for i in range(len(program.ops)):
        for part in parts:
            if call := _call(program, places, i, part):
                calls |= dict.fromkeys(call.results, call)
                break
    return calls


def _call(program: Program, places: Mapping[Op, int], i: int, part: Part) -> Call | None:
    """Return the call of a part whose first result is value i of the program, or None if a result is not a value.

    ``places`` are the indices of the program's operations.
    """
    bound: dict[int, int] = {}  # which value of the program each value of the part is

    def same(i: int, k: int) -> bool:
        one = program.ops[i]
        other = part.program.ops[k]
        if k not in bound and other.kind != "input":
            if (one.kind, one.value) != (other.kind, other.value):
                return False
            if not all(map(same, one.args, other.args)):
                return False
        return bound.setdefault(k, i) == i

    if not same(i, part.program.outputs[0]):
        return None
    try:
        inputs = {str(op.value): bound[k] for k, op in enumerate(part.program.ops) if op.kind == "input"}
        results = walk(part.program, inputs, lambda op, args: places[replace(op, args=tuple(args))])
    except KeyError:
        return None
    return Call(part.name, tuple(inputs[x] for x in part.program.inputs), tuple(results))


def statements(program: Program, language: Language, parts: Sequence[Part] = ()) -> tuple[Texts, Texts]:
    """Return the statements that compute a program, and the text of each output.

    Values that one of ``parts`` computes are written as a call of its function.
    """
    writer = _Text(program, language, parts)
    return writer.lines, [writer.text[i][0] for i in program.outputs]


@dataclass
class Reader:
    """Executor of written text on operands that record operations. Functions that have been read can be called."""

    scope: ValueDict
    builder: Builder = field(default_factory=Builder)

    def check(self, program: Program, name: str, text: str) -> None:
        """Raise `ProofError` unless the Python function ``name`` in a text performs exactly these operations."""
        exec(text, self.scope)
        inputs = {x: self.builder.put("input", value=x) for x in program.inputs}
        results = self.scope[name](*inputs.values())
        if not isinstance(results, tuple):
            results = (results,)
        read = [self.builder.value(x).place for x in results]
        written = [x.place for x in self.builder.inline(flat(program), inputs)]
        if read != written:
            raise ProofError(f"{name}: text that was written", f"operations {read}", f"{written}, those of its program")
