"""A program as text that a reader follows: named values, polynomials by their coefficients, parts called by name.

What is written is read back: the text, run on operands that record what is done to them, must give the operations of
the program, and no others.
"""

import textwrap
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

from derive.check.proof import ProofError
from derive.code.operations import OPERATIONS
from derive.code.program import Builder, Program

WIDTH = 116  # of a statement, its indent included
INLINE = 72  # a value that is used once is written where it is used, up to this length


@dataclass(frozen=True)
class Language:
    """How Python or C writes a statement, a number and a polynomial."""

    templates: str  # the field of an `Operation`
    statement: str
    number: Callable[[float], str]
    polynomial: str  # of {x}, {degree} and {coefficients}
    space: str = ""


@dataclass(frozen=True)
class Part:
    """A program of one input that others contain, under the name by which they call it."""

    name: str
    program: Program


class _Text:
    """The statements of a program: ``lines``, and of each value its text and how tightly that binds."""

    def __init__(self, program: Program, language: Language, parts: Sequence[Part]) -> None:
        self.program, self.language = program, language
        self.text: dict[int, tuple[str, int]] = {}
        self.lines: list[str] = []
        self.counts: Counter[str] = Counter()
        ops, self.names = program.ops, _known(program)
        raw = Counter(i for op in ops for i in op.args)
        self.calls = {i: x for part in reversed(parts) for i in range(len(ops)) if (x := _call(program, i, part))}
        self.polynomials = {i: p for i in range(len(ops)) if (p := _polynomial(program, i, raw))}
        needed, uses = set(program.outputs), Counter(program.outputs)
        for i in range(len(ops) - 1, -1, -1):
            if i in needed:
                operands = ops[i].args
                if i in self.calls or i in self.polynomials:
                    operands = self.calls[i][1:] if i in self.calls else self.polynomials[i][:1]
                needed.update(operands)
                uses.update(operands)
        for i in sorted(needed):
            self.text[i] = self._expression(i)
            named = i in self.names or i in self.polynomials or len(self.text[i][0]) > INLINE
            if ops[i].kind not in ("input", "const") and (uses[i] > 1 or (named and i not in program.outputs)):
                self._name(i)

    def _expression(self, i: int) -> tuple[str, int]:
        op, language = self.program.ops[i], self.language
        if op.kind == "input":
            return str(op.value), 9
        if op.kind == "const":
            value = float(op.value)  # type: ignore[arg-type]
            return language.number(value), 3 if value < 0 else 9
        if i in self.calls:
            name, argument = self.calls[i]
            return f"{name}({self.text[argument][0]})", 9
        if i in self.polynomials:
            x, coefficients = self.polynomials[i]
            if not self.text[x][0].isidentifier():
                self._name(x)
            numbers = ", ".join(language.number(c) for c in coefficients)
            return language.polynomial.format(x=self.text[x][0], degree=len(coefficients) - 1, coefficients=numbers), 9
        operation = OPERATIONS[op.kind]
        template = getattr(operation, language.templates)
        if not template:
            raise ValueError(f"{op.kind} has no place in {language.templates}")

        def shown() -> str:
            operands = (self.text[a] for a in op.args)
            texts = [t if binds >= need else f"({t})" for (t, binds), need in zip(operands, operation.needs)]  # noqa: B905
            return str(template.format(*texts, space=language.space))

        while len(shown()) > WIDTH - 24:  # room for the name
            self._name(max(op.args, key=lambda a: len(self.text[a][0])))
        return shown(), operation.binds

    def _name(self, i: int) -> None:
        """Give a value a name, and a statement: polynomials are p1, p2, ..., and the rest t1, t2, ..."""
        text, name = self.text[i][0], self.names.get(i)
        if not name:
            letter = "p" if i in self.polynomials else "t"
            self.counts[letter] += 1
            name = f"{letter}{self.counts[letter]}"
        taken = {*self.program.inputs, *(t for t, _ in self.text.values())}
        name = next(n for n in (name, *(f"{name}_{k}" for k in range(2, 1000))) if n not in taken)
        line = self.language.statement.format(name=name, text=text)
        if len(line) > WIDTH:
            line = "\n".join(textwrap.wrap(line, WIDTH - 8, subsequent_indent="    ", break_long_words=False))
        self.lines.append(line)
        self.text[i] = (name, 9)


def _known(program: Program) -> dict[int, str]:
    """Names of values: those that the program comes with, and what a kernel of alpha is made of."""
    names = dict(program.names)
    for i, op in enumerate(program.ops):
        if i in program.names:
            continue
        kinds = [program.ops[a].kind for a in op.args]
        if kinds == ["const", "input"] and op.kind == "sub":
            names[i] = "b"  # pi/2 - alpha
        if op.kind == "mul" and op.args[0] == op.args[1] and (kinds[0] == "input" or op.args[0] in names):
            base, _, power = (names.get(op.args[0]) or f"{program.ops[op.args[0]].value}").partition("_")
            names[i] = f"{base}_{2 * int(power or 1)}" if power.isdigit() or not power else f"{base}_{power}_2"
    pieces = seam(program)
    return names | ({pieces[1]: "near", pieces[2]: "far"} if pieces else {})


def seam(program: Program) -> tuple[float, int, int] | None:
    """Where the result is a choice between two pieces: where they meet, and which values they are."""
    output = program.ops[program.outputs[0]]
    if output.kind != "select" or len(program.outputs) > 1:
        return None
    chosen, near, far = output.args
    less = program.ops[chosen]
    if less.kind != "less" or [program.ops[i].kind for i in less.args] != ["input", "const"]:
        return None
    return float(program.ops[less.args[1]].value), near, far  # type: ignore[arg-type]


def _polynomial(program: Program, i: int, uses: Counter[int]) -> tuple[int, list[float]] | None:
    """The argument and the coefficients, lowest first, where this is Horner's scheme with at least three."""
    ops, found, x, at = program.ops, [], None, i
    while ops[at].kind != "const":
        op = ops[at]
        if at != i and uses[at] > 1:
            return None
        if op.kind == "fma":
            inner, by, last = op.args
        elif op.kind == "add" and ops[op.args[0]].kind == "mul" and uses[op.args[0]] == 1:
            (inner, by), last = ops[op.args[0]].args, op.args[1]
        else:
            return None
        if ops[last].kind != "const" or ops[by].kind == "const" or x not in (None, by):
            return None
        x = by
        found.append(float(ops[last].value))  # type: ignore[arg-type]
        at = inner
    found.append(float(ops[at].value))  # type: ignore[arg-type]
    return (x, found) if x is not None and len(found) > 2 else None


def _call(program: Program, i: int, part: Part) -> tuple[str, int] | None:
    """The part's name and which value is its argument, if value i of the program is the part's output."""
    bound: dict[int, int] = {}  # which value of the program each value of the part is

    def same(i: int, k: int) -> bool:
        one, other = program.ops[i], part.program.ops[k]
        if k not in bound and other.kind != "input":
            if (one.kind, one.value, len(one.args)) != (other.kind, other.value, len(other.args)):
                return False
            if not all(map(same, one.args, other.args)):
                return False
        return bound.setdefault(k, i) == i

    if not same(i, part.program.outputs[0]):
        return None
    return part.name, next(bound[k] for k, op in enumerate(part.program.ops) if op.kind == "input")


def statements(program: Program, language: Language, parts: Sequence[Part] = ()) -> tuple[list[str], list[str]]:
    """The statements that compute a program, and the text of each output."""
    writer = _Text(program, language, parts)
    return writer.lines, [writer.text[i][0] for i in program.outputs]


@dataclass
class Reader:
    """Text that was written, run on operands that record; what is read once is there to be called."""

    scope: dict[str, Any]
    builder: Builder = field(default_factory=Builder)

    def check(self, program: Program, name: str, text: str) -> None:
        """Raise `ProofError` unless the text, a function of Python, does the program's operations and no others."""
        exec(text, self.scope)
        inputs = {x: self.builder.put("input", value=x) for x in program.inputs}
        given = self.scope[name](*inputs.values())
        done = [self.builder.value(x).place for x in (given if isinstance(given, tuple) else (given,))]
        if done != (wanted := [x.place for x in self.builder.inline(program, inputs)]):
            raise ProofError(f"{name}: text that was written", f"operations {done}", f"{wanted}, those of its program")
