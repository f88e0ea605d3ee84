"""What writes restricted Python in another language: statements and expressions, their kinds, and what is refused."""

import ast
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from derive.flow.restricted import (
    CELLS,
    CELLS_BY_ROLE,
    CODES,
    COMPARED,
    OF_LANES,
    OF_ONE_LANE,
    OF_TABLE,
    PARTS,
    PRIMITIVES,
    REGISTERS,
    SIGNS,
    Function,
    Text,
    annotation,
    refuse,
)


@dataclass
class Value:
    """An expression in the language that is written, and its kind."""

    text: str
    kind: str


class Writer:
    """What the two languages share: statements and expressions, their kinds, and what is refused.

    ``lane`` says that what is written is about one lane: a function of a `Lane`, or the body of an ``if`` on a mask.
    """

    boolean = ("", "")  # how false and true are written

    def __init__(self, text: Text, function: Function) -> None:
        self.all = text
        self.function = function
        self.lane = function.of == "LANE"
        self.kinds = dict(function.parameters)
        self.state = next((x for x, kind in function.parameters.items() if kind in ("LANES", "LANE")), "")

    # What a language says in its own way.

    def named(self, name: str, kind: str) -> str:
        raise NotImplementedError

    def attribute(self, holder: str, name: str, kind: str) -> Value:
        raise NotImplementedError

    def element(self, e: ast.Subscript) -> Value:
        raise NotImplementedError

    def logic(self, sign: str, values: Sequence[Value], kind: str) -> str:
        raise NotImplementedError

    def call(self, name: str, values: Sequence[Value], e: ast.Call) -> Value:
        raise NotImplementedError

    def choice(self, chosen: Value, one: Value, other: Value) -> str:
        raise NotImplementedError

    def binary(self, one: Value, sign: str, other: Value) -> str:
        return f"({one.text} {sign} {other.text})"

    def refuse(self, node: ast.AST, why: str) -> None:
        refuse(self.function.path, node, why)

    # Expressions.

    def value(self, e: ast.expr) -> Value:
        """The text of an expression, and its kind."""
        match e:
            case ast.Constant(value=bool(x)):
                return Value(self.boolean[x], "N")
            case ast.Constant(value=int(x) | float(x)):
                return Value(repr(x), "N" if isinstance(x, int) else "K")
            case ast.Name(id=name):
                return self._name(name, e)
            case ast.Attribute(value=ast.Name(id=holder), attr=name):
                return self._attribute(holder, name, e)
            case ast.Attribute(value=ast.Attribute(value=ast.Name(id=holder), attr=middle), attr=name):
                return self._attribute(f"{holder}.{middle}", name, e)
            case ast.Subscript():
                return self.element(e)
            case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]):
                return self._call(name, arguments, e)
            case ast.IfExp(test=test, body=a, orelse=b):
                chosen, one, other = self.value(test), self.value(a), self.value(b)
                if chosen.kind != "N":
                    self.refuse(e, "a choice by lane is `where`")
                return Value(self.choice(chosen, one, other), joined((one, other), "SVFIKN"))
        return self._operation(e)

    def _operation(self, e: ast.expr) -> Value:
        """The same of signs and of choices."""
        match e:
            case ast.BinOp(left=a, op=op, right=b) if type(op) in SIGNS:
                one, other = self.value(a), self.value(b)
                return Value(self.binary(one, SIGNS[type(op)], other), joined((one, other)))
            case ast.UnaryOp(op=ast.USub(), operand=a):
                one = self.value(a)
                return Value(f"(-{one.text})", one.kind)
            case ast.UnaryOp(op=ast.Not(), operand=a):
                one = self.value(a)
                return Value(self.logic("not", [one], one.kind), one.kind)
            case ast.Compare(left=a, ops=[op], comparators=[b]) if type(op) in SIGNS:
                one, other = self.value(a), self.value(b)
                kind = joined((one, other), "VMFIBKN")
                return Value(self.binary(one, SIGNS[type(op)], other), COMPARED[kind])
            case ast.BoolOp(op=op, values=parts):
                values = [self.value(x) for x in parts]
                kind = joined(values, "MBN")
                has_others = any(v.kind != "M" for v in values)
                if kind == "M" and has_others:
                    self.refuse(e, "a mask is joined with masks only")
                return Value(self.logic("and" if isinstance(op, ast.And) else "or", values, kind), kind)
        self.refuse(e, "this expression is not in the grammar of the integrator")
        raise AssertionError

    def _name(self, name: str, e: ast.expr) -> Value:
        if name in self.kinds:
            kind = self.kinds[name]
            return Value(self.named(name, kind), OF_ONE_LANE.get(kind, kind) if self.lane else kind)
        if name not in self.all.constants:
            self.refuse(e, f"{name} has no value here")
        return Value(name, "K")

    def _attribute(self, holder: str, name: str, e: ast.expr) -> Value:
        """A member of an enumeration, or an entry of lanes, of a table or of a state, by its kind."""
        if holder in CODES and name in CODES[holder][1]:
            return self.attribute(holder, CODES[holder][0] + name, "CODE")
        first, _, middle = holder.partition(".")
        entries = {"T": self._of_table, "Q": self._of_state}.get(self.kinds.get(first, ""), self._of_lanes)
        what, kind = entries(first, middle, name)
        if not what:
            self.refuse(e, f"lanes, tables and states have no entry {name}")
        holder = first if what in ("SERIES", "HAS") else holder
        number = OF_ONE_LANE.get(kind, kind) if self.lane else kind
        return Value(self.attribute(holder, name, what).text, number)

    def _of_lanes(self, first: str, middle: str, name: str) -> tuple[str, str]:
        """What an entry of lanes is, and its kind."""
        if first != self.state:
            return "", ""
        if name in REGISTERS and middle:
            return {"series": ("SERIES", "S"), "has": ("HAS", "N")}.get(middle, ("", ""))
        if middle:
            return "", ""
        if name in CELLS:
            return "CELL", "V"
        if name in CELLS_BY_ROLE:
            return "ROLE", "V"
        return ("SHARED", "N") if name in OF_LANES else ("", "")

    def _of_table(self, first: str, middle: str, name: str) -> tuple[str, str]:
        """What an entry of a table, or of the one before it, is, and its kind."""
        if middle not in ("", "before"):
            return "", ""
        if name in PARTS:
            return "PART", "V"
        if name in OF_TABLE:
            return "OF_TABLE", "N"
        return ("OF_TABLE", "S") if name == "series" else ("", "")

    def _of_state(self, first: str, middle: str, name: str) -> tuple[str, str]:
        """What an entry of a state is, and its kind."""
        return ("OF_STATE", {"now": "V", "series": "S", "rate": "S"}.get(name, "")) if not middle else ("", "")

    def _call(self, name: str, arguments: Sequence[ast.expr], e: ast.Call) -> Value:
        if name not in PRIMITIVES and name not in self.all.functions:
            self.refuse(e, f"there is no function {name}")
        return self.call(name, [self.value(x) for x in arguments], e)

    def kind_of_call(self, name: str, values: Sequence[Value]) -> str:
        """The kind of what a call gives."""
        if name in self.all.functions:
            kind = self.all.functions[name].returns
        elif name == "where":
            kind = joined(values[1:], "VMFIBKN")
            if values[0].kind == "M":
                return "M" if values[1].kind == "M" else "V"
            return "B" if values[1].kind == "B" else kind if kind in ("F", "I") else "F" if kind == "K" else "I"
        elif name == "number":
            kind = "F" if values[0].kind == "I" else "K"
        else:
            kind = PRIMITIVES[name] or joined(values)
        return OF_ONE_LANE.get(kind, kind) if self.lane else kind

    # Statements.

    def body(self, statements: Sequence[ast.stmt]) -> Iterator[str]:
        """The lines of a block."""
        for s in statements:
            match s:
                case ast.Expr(value=ast.Constant(value=str())):
                    pass
                case ast.Expr(value=ast.Call() as e):
                    yield from self.run(self.value(e))
                case ast.Assign() | ast.AnnAssign():
                    yield from self._assign(s)
                case ast.For(iter=ast.Call(func=ast.Name(id="up" | "down" as way), args=[a, b])):
                    yield from self._count(way, self.value(a), self.value(b), s)
                case ast.For(target=ast.Name(id=name), iter=ast.Attribute(attr="tables" | "states" as what)):
                    self.kinds[name] = "T" if what == "tables" else "Q"
                    yield from self.loop_over(name, what, s.body)
                case ast.While(test=test):
                    yield from self.loop_while(self.value(test), s.body)
                case ast.If(orelse=[]):
                    yield from self._if(s)
                case ast.Return(value=None):
                    yield from self.give(None)
                case ast.Return(value=ast.Tuple(elts=[a, b])):
                    yield from self.give((self.value(a), self.value(b)))
                case ast.Return(value=ast.expr() as e):
                    yield from self.give(self.value(e))
                case _:
                    self.refuse(s, "this statement is not in the grammar of the integrator")

    def _assign(self, s: ast.stmt) -> Iterator[str]:
        match s:
            case ast.Assign(targets=[ast.Tuple(elts=[ast.Name(id=a), ast.Name(id=b)])], value=value):
                pair = self.value(value)
                self.kinds |= {a: "V", b: "V"}
                yield from self.let_pair(a, b, pair)
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                yield from self._let(name, self.value(value), s)
            case ast.AnnAssign(target=ast.Name(id=name), annotation=kind, value=ast.expr() as value):
                yield from self._let(name, self.value(value), s, annotation(kind, self.function.path, s))
            case ast.Assign(targets=[ast.Attribute() | ast.Subscript() as target], value=value):
                yield from self.store(target, self.value(target), self.value(value))
            case _:
                self.refuse(s, "this assignment is not in the grammar of the integrator")

    def _let(self, name: str, value: Value, s: ast.stmt, kind: str = "") -> Iterator[str]:
        new = name not in self.kinds
        if not kind:
            kind = self.kinds.get(name, value.kind)
        if kind == "K":
            self.refuse(s, f"{name} needs an annotation: is it a number of each lane or of all?")
        self.kinds[name] = kind
        yield from self.let(name, kind, value, new)

    def _count(self, way: str, first: Value, last: Value, s: ast.For) -> Iterator[str]:
        if not {first.kind, last.kind} <= {"N"}:
            self.refuse(s, "a loop counts between integers that all lanes share")
        name = ast.unparse(s.target)
        self.kinds[name] = "N"
        yield from self.count(name, way, first.text, last.text, s.body)

    def _if(self, s: ast.If) -> Iterator[str]:
        if isinstance(s.test, ast.BoolOp) and isinstance(s.test.op, ast.And):
            first, *others = s.test.values
            shared = self.value(first)
            rest = others[0] if len(others) == 1 else ast.BoolOp(ast.And(), others)
            if shared.kind == "N" and self.value(rest).kind != "N":  # the first is the same for all lanes
                inner = ast.If(rest, s.body, [])
                ast.copy_location(inner, s)
                ast.fix_missing_locations(inner)
                yield from self.shared_if(shared.text, [inner])
                return
        test = self.value(s.test)
        if test.kind not in ("N", "M", "B"):
            self.refuse(s, "an `if` is on a truth value")
        if test.kind == "N":
            yield from self.shared_if(test.text, s.body)
            return
        outside = set(self.kinds)
        assigned = {x.id for x in ast.walk(s) if isinstance(x, ast.Name) and isinstance(x.ctx, ast.Store)}
        if outside & assigned:
            names = ", ".join(sorted(outside & assigned))
            self.refuse(s, f"an `if` by lane changes {names}, which is known outside: use `where`")
        last = s.body[-1]
        leaves = isinstance(last, ast.Return)
        if isinstance(last, ast.Return) and (test.kind == "M" or last.value):
            self.refuse(s, "only one lane returns early, and without a value")
        yield from self.lane_if(test, s, leaves)
        for name in assigned:
            self.kinds.pop(name, None)

    # What a language says in its own way, a line for a line.

    def run(self, call: Value) -> Iterator[str]:
        raise NotImplementedError

    def let(self, name: str, kind: str, value: Value, new: bool) -> Iterator[str]:
        raise NotImplementedError

    def let_pair(self, a: str, b: str, pair: Value) -> Iterator[str]:
        raise NotImplementedError

    def store(self, target: ast.expr, place: Value, value: Value) -> Iterator[str]:
        raise NotImplementedError

    def count(self, name: str, way: str, first: str, last: str, body: Sequence[ast.stmt]) -> Iterator[str]:
        raise NotImplementedError

    def loop_over(self, name: str, what: str, body: Sequence[ast.stmt]) -> Iterator[str]:
        raise NotImplementedError

    def loop_while(self, test: Value, body: Sequence[ast.stmt]) -> Iterator[str]:
        raise NotImplementedError

    def shared_if(self, test: str, body: Sequence[ast.stmt]) -> Iterator[str]:
        raise NotImplementedError

    def lane_if(self, test: Value, s: ast.If, leaves: bool) -> Iterator[str]:
        raise NotImplementedError

    def give(self, value: Value | tuple[Value, Value] | None) -> Iterator[str]:
        raise NotImplementedError


def joined(values: Sequence[Value], order: str = "VFIKN") -> str:
    """The kind of what values make: the first of an order that one of them has."""
    return next(k for k in order if any(v.kind == k for v in values))
