"""Translation of restricted Python to another language: statements, expressions, kinds, and rejected constructs."""

import ast
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NoReturn

from derive.flow.restricted import (
    CODES,
    COMPARED,
    ENTRIES,
    PRIMITIVES,
    SIGNS,
    RestrictedFunction,
    Text,
    annotation,
    refuse_node,
)
from derive.kinds import TextMap


@dataclass
class TypedExpression:
    """Expression in the target language, and its kind."""

    text: str
    kind: str


class Writer:
    """Common part of the writers, which differ in their ``forms`` and in declarations.

    A form has a name, possibly followed by the name of its object, ``minimum.N``. `x` is the object, `X` the same in
    capitals, and `s` the state.
    """

    forms: TextMap

    def __init__(self, text: Text, function: RestrictedFunction) -> None:
        self.all = text
        self.function = function
        self.kinds = dict(function.parameters)
        self.state = next((x for x, kind in function.parameters.items() if kind == "LANES"), "")

    def say(self, what: str, name: str = "", **parts: str) -> str:
        """Return the form ``what.name``, or else ``what``, with ``name`` and the other parts in place of its marks."""
        form = self.forms.get(f"{what}.{name}") or self.forms[what]
        return form.format(x=name, X=name.upper(), s=self.state, **parts)

    def refuse(self, node: ast.AST, why: str) -> NoReturn:
        """Raise an error that names the file and the line of a construct outside the grammar."""
        refuse_node(self.function.path, node, why)

    def as_kind(self, value: TypedExpression, kind: str) -> str:
        """Return the text of a value where ``kind`` is expected. Numbers of all lanes are broadcast to V."""
        text = bare(value.text)
        if kind == "V" and value.kind in ("K", "N"):
            return self.say("broadcast", text)
        return text

    # Expressions.

    def value(self, e: ast.expr) -> TypedExpression:
        """Return the text of an expression, and its kind."""
        match e:
            case ast.Constant(value=bool(x)):
                return TypedExpression(self.forms[str(x)], "N")
            case ast.Constant(value=int(x) | float(x)):
                kind = "N" if isinstance(x, int) else "K"
                return TypedExpression(repr(x), kind)
            case ast.Name(id=name):
                return self._name(name, e)
            case ast.Attribute():
                return self._entry(e)
            case ast.Subscript():
                return self._element(e)
            case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]):
                return self._call(name, [self.value(x) for x in arguments], e)
            case ast.IfExp(test=test, body=a, orelse=b):
                chosen, *ends = map(self.value, (test, a, b))
                if chosen.kind != "N":
                    self.refuse(e, "a choice by lane is `where`")
                kind = joined(ends, "SVKN")
                one, other = (self.as_kind(x, kind) if kind == "V" else x.text for x in ends)
                return TypedExpression(self.say("choice", a=chosen.text, b=one, c=other), kind)
        return self._operation(e)

    def _operation(self, e: ast.expr) -> TypedExpression:
        """Return the text and the kind of an operation."""
        match e:
            case ast.BinOp(left=a, op=op, right=b) if type(op) in SIGNS:
                values = self.value(a), self.value(b)
                return TypedExpression(self._joined(SIGNS[type(op)], values), joined(values))
            case ast.UnaryOp(op=ast.USub(), operand=a):
                one = self.value(a)
                return TypedExpression(f"(-{one.text})", one.kind)
            case ast.UnaryOp(op=ast.Not(), operand=a):
                one = self.value(a)
                return TypedExpression(self.say("not", one.kind, a=one.text), one.kind)
            case ast.Compare(left=a, ops=[op], comparators=[b]) if type(op) in SIGNS:
                values = self.value(a), self.value(b)
                return TypedExpression(self._joined(SIGNS[type(op)], values), COMPARED[joined(values, "VMKN")])
            case ast.BoolOp(op=op, values=parts):
                several = [self.value(x) for x in parts]
                kind = joined(several, "MN")
                if kind == "M" and any(v.kind != "M" for v in several):
                    self.refuse(e, "a mask is joined with masks only")
                sign = self.say("and" if isinstance(op, ast.And) else "or", kind)
                return TypedExpression(self._joined(sign, several), kind)
        self.refuse(e, "this expression is not in the grammar of the integrator")

    def _joined(self, sign: str, values: Sequence[TypedExpression]) -> str:
        """Return values joined by a sign. An integer beside numbers of lanes becomes a number."""
        vector = any(v.kind == "V" for v in values)
        texts = []
        for v in values:
            texts.append(self.say("cast", v.text) if vector and v.kind == "N" else v.text)
        joint = f" {sign} ".join(texts)
        return f"({joint})"

    def _name(self, name: str, e: ast.expr) -> TypedExpression:
        """Return the text and the kind of a variable or constant. ``e`` is its place in error messages."""
        if kind := self.kinds.get(name):
            return TypedExpression(name, kind)
        if name not in self.all.constants:
            self.refuse(e, f"{name} has no value here")
        return TypedExpression(name, "N" if isinstance(self.all.constants[name], int) else "K")

    def _entry(self, e: ast.expr) -> TypedExpression:
        """Return a member of an enumeration, or an entry of lanes, of a table or of a state, by its kind."""
        holder, _, entry = ast.unparse(e).partition(".")
        prefix, members = CODES.get(holder, ("", {}))
        if entry in members:
            return TypedExpression(self.say("CODE", prefix + entry), "N")
        what, kind = ENTRIES.get((self.kinds.get(holder, ""), entry), ("", ""))
        if not what:
            self.refuse(e, f"lanes, tables and states have no entry {entry}")
        middle, _, name = entry.rpartition(".")
        of = self.say("before", holder) if middle == "before" else holder
        return TypedExpression(self.say(what, name, of=of), kind)

    def _element(self, e: ast.Subscript) -> TypedExpression:
        """Return the text and the kind of an element of a constant, a series or an array."""
        index = bare(self.value(e.slice).text)
        match e.value:
            case ast.Name(id=name) if name in self.all.constants:
                return TypedExpression(f"{name}[{index}]", "K")
            case ast.Attribute(value=ast.Name(id=holder), attr="inverse") if holder == self.state:
                return TypedExpression(self.say("inverse", index), "K")
            case ast.Attribute(value=ast.Name(id=holder), attr="coefficients") if self.kinds.get(holder) == "T":
                return TypedExpression(self.say("coefficients", index, of=holder), "V")
        series = self.value(e.value)
        if series.kind == "S":
            return TypedExpression(self.say("element", index, of=series.text), "V")
        return TypedExpression(f"{series.text}[{index}]", "K")

    def _call(self, name: str, values: Sequence[TypedExpression], e: ast.Call) -> TypedExpression:
        """Return the text and the kind of a call of a function or primitive. ``e`` is its place in error messages."""
        function = self.all.functions.get(name)
        if name not in PRIMITIVES and not function:
            self.refuse(e, f"there is no function {name}")
        kind = self._kind_of_call(name, values)
        cast = "V" if kind == "V" and not PRIMITIVES.get(name) else "NONE"
        expected = function.parameters.values() if function else [cast] * len(values)
        texts = [self.as_kind(v, k) for v, k in zip(values, expected, strict=True)]
        if values and values[0].kind == "LANES":
            texts[0] = self.say("LANES")
        form = name if function else self.forms.get(f"{name}.{kind}") or self.forms.get(name, name)
        if "{" not in form:
            return TypedExpression(f"{form}({', '.join(texts)})", kind)
        series = next((x for x, k in self.function.parameters.items() if k == "S"), f"{self.state}.registers[0]")
        operands = dict(zip("abc", (v.text for v in values), strict=False))
        return TypedExpression(form.format(*texts, s=self.state, series=series, **operands), kind)

    def _kind_of_call(self, name: str, values: Sequence[TypedExpression]) -> str:
        """Return the kind of the result of calling the function or primitive ``name`` with these values."""
        if name in self.all.functions:
            return self.all.functions[name].returns
        if name == "where":
            return "M" if values[1].kind == "M" else "V"
        return PRIMITIVES[name] or joined(values)

    # Statements.

    def statements(self) -> Iterator[str]:
        """Yield the lines of the function's body, which is skipped where its mask ``here`` is true in no lane."""
        f = self.function
        if f.returns == "NONE" and f.parameters.get("here") == "M":
            yield from self.forms["skip"].split("\n")
        yield from self.body(f.node.body)

    def body(self, statements: Sequence[ast.stmt]) -> Iterator[str]:
        """Yield the lines of a block of statements in the target language."""
        end = self.forms["end"]
        for s in statements:
            match s:
                case ast.Expr(value=ast.Constant(value=str())):
                    pass
                case ast.Expr(value=ast.Call() as e):
                    yield self.value(e).text + end
                case ast.Assign() | ast.AnnAssign():
                    yield from self._assign(s)
                case ast.For(iter=ast.Call(func=ast.Name(id="up" | "down" as way), args=[a, b])):
                    yield from self._count(way, self.value(a), self.value(b), s)
                case ast.For(target=ast.Name(id=name), iter=ast.Attribute(attr="tables" | "states" as what)):
                    self.kinds[name] = "T" if what == "tables" else "Q"
                    yield from self.block(self.say(what, name), s.body)
                case ast.While(test=test) | ast.If(test=test, orelse=[]):
                    yield from self._on_condition(self.value(test), s)
                case ast.Return(value=None):
                    yield f"return{end}"
                case ast.Return(value=ast.Tuple(elts=[a, b])):
                    yield self.say("pair", a=self.value(a).text, b=self.value(b).text)
                case ast.Return(value=ast.expr() as e):
                    yield f"return {self.as_kind(self.value(e), self.function.returns)}{end}"
                case _:
                    self.refuse(s, "this statement is not in the grammar of the integrator")

    def block(self, head: str, body: Sequence[ast.stmt]) -> Iterator[str]:
        """Yield ``head``, the indented lines of ``body``, and what closes it.

        Names assigned in the body are known only there.
        """
        known = dict(self.kinds)
        opened, closed = self.forms["open"], self.forms["close"]
        yield head + opened
        for line in self.body(body):
            yield f"    {line}"
        yield from closed
        self.kinds = {x: kind for x, kind in self.kinds.items() if x in known}

    def _assign(self, s: ast.stmt) -> Iterator[str]:
        """Yield the lines of an assignment."""
        match s:
            case ast.Assign(targets=[ast.Tuple(elts=[ast.Name(id=a), ast.Name(id=b)])], value=value):
                form = "set_pair" if a in self.kinds else "let_pair"
                yield from self.say(form, self.value(value).text, a=a, b=b).split("\n")
                self.kinds |= {a: "V", b: "V"}
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                yield from self._let(name, self.value(value), s)
            case ast.AnnAssign(target=ast.Name(id=name), annotation=kind, value=ast.expr() as value):
                yield from self._let(name, self.value(value), s, annotation(kind, self.function.path, s))
            case ast.Assign(targets=[ast.Attribute() | ast.Subscript() as target], value=value):
                place = self.value(target)
                new = self.value(value)
                masked = isinstance(target, ast.Attribute) and "here" in self.kinds
                stored = self.as_kind(new, place.kind)
                if masked:
                    stored = f"{self.forms['masked']}(here, {stored}, {place.text})"
                yield f"{place.text} = {stored}{self.forms['end']}"
            case _:
                self.refuse(s, "this assignment is not in the grammar of the integrator")

    def _let(self, name: str, value: TypedExpression, s: ast.stmt, kind: str = "") -> Iterator[str]:
        """Yield the line that assigns a value to a name.

        Without ``kind`` the name keeps its kind or has the value's.
        """
        new = name not in self.kinds
        if not kind:
            kind = self.kinds.get(name, value.kind)
        if kind == "K":
            self.refuse(s, f"{name} needs an annotation: is it a number of each lane or of all?")
        self.kinds[name] = kind
        yield self.let(name, kind, value, new)

    def _count(self, way: str, first: TypedExpression, last: TypedExpression, s: ast.For) -> Iterator[str]:
        """Yield the lines of a loop over integers from ``first`` to ``last``, both included. ``way`` is up or down."""
        if not {first.kind, last.kind} <= {"N"}:
            self.refuse(s, "a loop counts between integers that all lanes share")
        name = ast.unparse(s.target)
        self.kinds[name] = "N"
        yield from self.block(self.say(way, bare(first.text), of=name, to=bare(last.text)), s.body)

    def _on_condition(self, test: TypedExpression, s: ast.If | ast.While) -> Iterator[str]:
        """Yield the lines of an ``if`` or of a loop on a truth value that all lanes share."""
        if test.kind != "N":
            self.refuse(s, "lanes decide by `where`, `any_lane` or a mask `here`")
        what = "if" if isinstance(s, ast.If) else "while"
        yield from self.block(self.say(what, bare(test.text)), s.body)

    def let(self, name: str, kind: str, value: TypedExpression, new: bool) -> str:
        """Return the statement that assigns a value to a name of this kind. It declares the name if ``new``."""
        raise NotImplementedError


def joined(values: Sequence[TypedExpression], order: str = "VKN") -> str:
    """Return the kind of a combination of values: the first letter of ``order`` that is the kind of one of them."""
    return next(k for k in order if any(v.kind == k for v in values))


def bare(text: str) -> str:
    """Return a text without brackets around all of it."""
    depth = 0
    for k, x in enumerate(text):
        depth += (x == "(") - (x == ")")
        if not depth and k < len(text) - 1:
            return text
    return text[1:-1] if text.startswith("(") else text
