"""Restricted Python written in NumPy: numerics on arrays of all lanes, phases on the lanes of an index.

An ``if`` by lane takes the lanes in which it holds out of the index and out of what is known of them.
"""

import ast
import textwrap
from collections.abc import Iterator, Sequence

from derive.flow.restricted import Function, Text
from derive.flow.writer import Value, Writer

TYPES = {
    "V": "Floats",
    "M": "Mask",
    "S": "Floats",
    "F": "Floats",
    "I": "Index",
    "B": "Mask",
    "A": "Floats",
    "N": "int",
    "T": "Table",
    "NONE": "None",
    "PAIR": "tuple[Floats, Floats]",
    "LANES": "Lanes",
    "LANE": "Lanes",
}
CALLS = {
    "where": "np.where",
    "abs": "np.abs",
    "minimum": "np.minimum",
    "maximum": "np.maximum",
    "any_lane": "np.any",
    "sin": "np.sin",
    "cos": "np.cos",
    "log": "np.log",
    "hypot": "np.hypot",
    "isnan": "np.isnan",
}
OF_ONE_LANE = {"minimum": "np.fmin", "maximum": "np.fmax"}
OF_LANE = {"F", "I", "B", "A"}


class NumPy(Writer):
    """One function in NumPy; ``i`` are the lanes that it is about, or some of them."""

    boolean = ("False", "True")

    def __init__(self, text: Text, function: Function) -> None:
        super().__init__(text, function)
        self.ifs = 0

    def named(self, name: str, kind: str) -> str:
        return f"{name}[i]" if self.lane and kind in ("V", "M") else name

    def attribute(self, holder: str, name: str, kind: str) -> Value:
        at = ", i" if self.lane else ""
        match kind:
            case "CODE":
                return Value(f"ix.{name}", "N")
            case "CELL":
                return Value(f"c[ix.{name.upper()}{at}]", "")
            case "ROLE":
                return Value(f"c[{self.state}.roles.{name}{at}]", "")
            case "SERIES":
                return Value(f"{self.state}.registers[{self.state}.roles.{name}]", "")
            case "HAS":
                return Value(f"({self.state}.roles.{name} >= 0)", "")
            case "PART":
                return Value(f"c[{holder}.cells + ix.{name.upper()}{at}]", "")
        if kind == "OF_STATE" and name == "now":
            return Value(f"c[{holder}.cell{at}]", "")
        if name in ("series", "rate"):
            return Value(f"{self.state}.registers[{holder}.{'register' if name == 'series' else 'rate'}]", "")
        return Value(f"{holder}.{name}", "")

    def element(self, e: ast.Subscript) -> Value:
        index = self.value(e.slice).text
        at = ", i" if self.lane else ""
        match e.value:
            case ast.Attribute(value=ast.Name(id=holder), attr="inverse") if holder == self.state:
                return Value(f"(1.0 / {index})", "K")
            case ast.Attribute(value=ast.Name(id=holder), attr="coefficients") if self.kinds.get(holder) == "T":
                return Value(f"c[{holder}.cells + ix.Q1 + {index}{at}]", "F" if self.lane else "V")
        series = self.value(e.value)
        if series.kind == "S":
            return Value(f"{series.text}[{index}{at}]", "F" if self.lane else "V")
        return Value(f"{series.text}[{index}]", "F")

    def logic(self, sign: str, values: Sequence[Value], kind: str) -> str:
        texts = [v.text for v in values]
        if kind == "N":
            return f"(not {texts[0]})" if sign == "not" else f"({f' {sign} '.join(texts)})"
        if sign == "not":
            return f"np.logical_not({texts[0]})"
        return f"({(' & ' if sign == 'and' else ' | ').join(texts)})"

    def choice(self, chosen: Value, one: Value, other: Value) -> str:
        return f"({one.text} if {chosen.text} else {other.text})"

    def call(self, name: str, values: Sequence[Value], e: ast.Call) -> Value:
        kind = self.kind_of_call(name, values)
        texts = [v.text for v in values]
        if values and values[0].kind in ("LANES", "LANE"):
            of_lanes = name in self.all.functions and self.all.functions[name].of == "LANES"
            texts[0] += ", i" if self.lane and not of_lanes else ""
        if name in self.all.functions:
            return Value(f"{name}({', '.join(texts)})", kind)
        match name:
            case "minimum" | "maximum" if kind in ("N", "K"):
                return Value(f"{name[:3]}({', '.join(texts)})", kind)
            case "number":
                return Value(texts[0] if values[0].kind == "I" else f"float({texts[0]})", kind)
            case "new_series":
                series = next((x for x, k in self.function.parameters.items() if k == "S"), "")
                return Value(f"np.zeros_like({series or f'{self.state}.registers[0]'})", kind)
            case "numbers":
                return Value(f"np.zeros(({self.state}.terms, i.size))", kind)
            case "tail":
                return Value(f"{texts[0]}[1:]", kind)
        calls = CALLS | OF_ONE_LANE if self.lane else CALLS
        return Value(f"{calls.get(name, name)}({', '.join(texts)})", kind)

    # Statements.

    def run(self, call: Value) -> Iterator[str]:
        yield call.text

    def let(self, name: str, kind: str, value: Value, new: bool) -> Iterator[str]:
        declared = f": {TYPES[kind]}" if new and value.kind in ("K", "N") and kind != "N" else ""
        held = value.text.startswith(("c[", f"{self.state}.registers[")) and value.kind == "V"
        held = held or value.text.partition("[")[0] in (x for x, k in self.kinds.items() if k == "A")
        yield f"{name}{declared} = {value.text}{'.copy()' if held else ''}"

    def let_pair(self, a: str, b: str, pair: Value) -> Iterator[str]:
        yield f"{a}, {b} = {pair.text}"

    def store(self, target: ast.expr, place: Value, value: Value) -> Iterator[str]:
        masked = isinstance(target, ast.Attribute) and not self.lane and "here" in self.kinds
        yield f"{place.text} = np.where(here, {value.text}, {place.text})" if masked else f"{place.text} = {value.text}"

    def block(self, head: str, body: Sequence[ast.stmt]) -> Iterator[str]:
        yield f"{head}:"
        for line in self.body(body):
            yield f"    {line}"

    def count(self, name: str, way: str, first: str, last: str, body: Sequence[ast.stmt]) -> Iterator[str]:
        start = "" if first == "0" else f"{first}, "
        bounds = f"{start}{last} + 1" if way == "up" else f"{first}, {last} - 1, -1"
        yield from self.block(f"for {name} in range({bounds})", body)

    def loop_over(self, name: str, what: str, body: Sequence[ast.stmt]) -> Iterator[str]:
        yield from self.block(f"for {name} in {self.state}.{what}", body)

    def loop_while(self, test: Value, body: Sequence[ast.stmt]) -> Iterator[str]:
        yield from self.block(f"while {test.text}", body)

    def shared_if(self, test: str, body: Sequence[ast.stmt]) -> Iterator[str]:
        yield from self.block(f"if {test}", body)

    def lane_if(self, test: Value, s: ast.If, leaves: bool) -> Iterator[str]:
        if test.kind == "M":
            self.lane = True
            yield f"i = np.flatnonzero({test.text})"
            yield from self.block("if i.size", s.body)
            self.lane = False
            return
        self.ifs += 1
        mark = self.ifs
        names = self._known_after(s)
        before = [f"{x}_{mark}" for x in names]
        known = ", ".join(names)
        kept = ", ".join(before)
        body = s.body[:-1] if leaves else s.body
        yield f"holds_{mark} = {test.text}"
        yield f"{kept} = {known}"
        yield f"{known}, = among(holds_{mark}, {kept})"
        if body:
            yield from self.block("if i.size", body)
        if leaves:
            yield f"{known}, = among(np.logical_not(holds_{mark}), {kept})"
            yield "if not i.size:"
            yield "    return"
        else:
            yield f"{known} = {kept}"

    def _known_after(self, s: ast.stmt) -> list[str]:
        """The index, and what is known of its lanes and used from a statement on."""
        used = set()
        for x in ast.walk(self.function.node):
            if isinstance(x, ast.Name) and x.lineno >= s.lineno:
                used.add(x.id)
        names = ["i"]
        for name, kind in self.kinds.items():
            if kind in OF_LANE and name in used:
                names.append(name)
        return names

    def give(self, value: Value | tuple[Value, Value] | None) -> Iterator[str]:
        match value:
            case None:
                yield "return"
            case (one, other):
                yield f"return {one.text}, {other.text}"
            case Value():
                yield f"return {value.text}"

    def source(self) -> str:
        """The whole function."""
        return ast.unparse(ast.parse("\n".join(self._lines())))

    def _lines(self) -> Iterator[str]:
        f = self.function
        body = list(self.body(f.node.body))
        parameters = []
        for name, kind in f.parameters.items():
            parameters.append(f"{name}: {TYPES[kind]}")
            if kind == "LANE":
                parameters.append("i: Index")
        yield f"def {f.name}({', '.join(parameters)}) -> {TYPES[f.returns]}:"
        words = textwrap.wrap(f.words.split("\n\n")[0].replace("\n", " "), 110)
        yield '    """' + "\n    ".join(words) + '"""'
        if f.of and any("c[" in line for line in body):
            yield f"    c = {self.state}.cells"
        for line in body:
            yield f"    {line}"


def functions(text: Text) -> str:
    """All functions, and constants in front of them."""
    lines = [f"{x} = {value!r}" for x, value in text.constants.items() if x != "INFINITY"]
    lines.append("INFINITY = np.inf")
    functions = (NumPy(text, f).source() for f in text.functions.values())
    return "\n\n\n".join(["\n".join(lines), *functions]) + "\n"
