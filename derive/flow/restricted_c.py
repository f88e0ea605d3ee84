"""Restricted Python written as C: vectors of lanes in numerics, lane by lane in phases."""

import ast
import textwrap
from collections.abc import Iterator, Sequence

from derive.flow.restricted import Function, Text
from derive.flow.writer import Value, Writer

TYPES = {
    "V": "V",
    "M": "M",
    "S": "V *",
    "F": "double",
    "I": "int64_t",
    "B": "int",
    "A": "double *",
    "N": "int",
    "T": "int",
    "NONE": "void",
    "PAIR": "Pair",
}
VECTOR = {"where": "pick", "abs": "magnitude", "minimum": "minimum", "maximum": "maximum"}
SCALAR = {"abs": "fabs", "minimum": "fmin", "maximum": "fmax"}
REDUCED = {"greatest": "greatest", "least": "least", "all_lanes": "all_lanes", "any_lane": "bits"}


class C(Writer):
    """One function as C."""

    boolean = ("0", "1")

    def named(self, name: str, kind: str) -> str:
        return f"{name}[lane]" if self.lane and kind in ("V", "M") else name

    def attribute(self, holder: str, name: str, kind: str) -> Value:
        at = "[lane]" if self.lane else ""
        table, _, before = holder.partition(".")
        index = f"{table} - 1" if before else table
        match kind:
            case "CODE":
                return Value(name, "N")
            case "CELL":
                return Value(f"c[{name.upper()}]{at}", "")
            case "ROLE":
                return Value(f"c[job->role->{name}]{at}", "")
            case "SERIES":
                return Value(f"(b->r + job->role->{name})", "")
            case "HAS":
                return Value(f"(job->role->{name} >= 0)", "")
            case "SHARED":
                return Value({"samples": "(job->samples > 0)", "highest": "job->order"}.get(name, f"job->{name}"), "")
            case "PART":
                return Value(f"c[job->table[{index}].cell + {name.upper()}]{at}", "")
            case "OF_STATE":
                if name == "now":
                    return Value(f"c[{holder}->cell]{at}", "")
                return Value(f"(b->r + {holder}->{name})", "")
        if name == "number":
            return Value(index, "")
        if name == "series":
            return Value(f"(b->r + job->table[{index}].reg)", "")
        if name == "pieces":
            return Value(f"(int)job->data[{index}].pieces", "")
        return Value(f"job->{'table' if name in ('kind', 'degree') else 'data'}[{index}].{name}", "")

    def element(self, e: ast.Subscript) -> Value:
        index = bare(self.value(e.slice).text)
        at = "[lane]" if self.lane else ""
        match e.value:
            case ast.Attribute(value=ast.Name(id=holder), attr="inverse") if holder == self.state:
                return Value(f"b->inverse[{index}]", "K")
            case ast.Attribute(value=ast.Name(id=holder), attr="coefficients") if self.kinds.get(holder) == "T":
                return Value(f"c[job->table[{holder}].cell + Q1 + {index}]{at}", "F" if self.lane else "V")
        series = self.value(e.value)
        if series.kind == "S":
            return Value(f"{series.text}[{index}]{at}", "F" if self.lane else "V")
        return Value(f"{series.text}[{index}]", "F")

    def as_kind(self, value: Value, kind: str) -> str:
        """The text where a value of some kind is expected."""
        if kind == "V" and value.kind in ("K", "N"):
            return f"broadcast({bare(value.text)})"
        return bare(value.text)

    def binary(self, one: Value, sign: str, other: Value) -> str:
        vector = "V" in (one.kind, other.kind)
        a, b = (f"(double){x.text}" if vector and x.kind == "N" else x.text for x in (one, other))
        return f"({a} {sign} {b})"

    def logic(self, sign: str, values: Sequence[Value], kind: str) -> str:
        if kind == "M":
            signs = {"and": " & ", "or": " | ", "not": "~"}
        else:
            signs = {"and": " && ", "or": " || ", "not": "!"}
        if sign == "not":
            return f"{signs[sign]}{values[0].text}"
        return f"({signs[sign].join(v.text for v in values)})"

    def choice(self, chosen: Value, one: Value, other: Value) -> str:
        if "V" in (one.kind, other.kind):
            return f"({chosen.text} ? {self.as_kind(one, 'V')} : {self.as_kind(other, 'V')})"
        return f"({chosen.text} ? {one.text} : {other.text})"

    def call(self, name: str, values: Sequence[Value], e: ast.Call) -> Value:
        kind = self.kind_of_call(name, values)
        if name in self.all.functions:
            return Value(self._call_of_text(self.all.functions[name], values), kind)
        if name in VECTOR and any(v.kind in ("V", "M") for v in values):
            expected = ["M", kind, kind] if name == "where" else [kind] * len(values)
            return Value(f"{VECTOR[name]}({', '.join(map(self.as_kind, values, expected))})", kind)
        return Value(self._primitive(name, values, kind), kind)

    def _primitive(self, name: str, values: Sequence[Value], kind: str) -> str:
        one, *others = values or [Value("", "")]
        texts = [bare(v.text) for v in values]
        if name in ("minimum", "maximum") and kind in ("N", "I"):
            less = "<" if name == "minimum" else ">"
            return f"({one.text} {less} {others[0].text} ? {one.text} : {others[0].text})"
        match name:
            case "where":
                return self.choice(one, *others)
            case "number" | "integer":
                return f"({'double' if name == 'number' else 'int64_t'}){one.text}"
            case "none_of":
                return "(M){0}"
            case "tail":
                return f"({texts[0]} + 1)"
            case "prologue":
                return f"IN(prologue)(job->scalar, job->scalar_end, c, {texts[1]})"
        if one.kind in ("LANE", "LANES"):
            texts[0] = "b, lane" if self.lane else "b"
        return f"{SCALAR.get(name, REDUCED.get(name, name))}({', '.join(texts)})"

    def _call_of_text(self, f: Function, values: Sequence[Value]) -> str:
        texts = []
        for value, kind in zip(values, f.parameters.values(), strict=True):
            if kind in ("LANES", "LANE"):
                texts.append("b, lane" if kind == "LANE" else "b")
            else:
                texts.append(self.as_kind(value, kind))
        return f"{f.name}({', '.join(texts)})"

    # Statements.

    def run(self, call: Value) -> Iterator[str]:
        yield f"{call.text};"

    def let(self, name: str, kind: str, value: Value, new: bool) -> Iterator[str]:
        if value.text in ("new_series()", "numbers()"):
            yield f"V {name}[HIGHEST + 2];" if kind == "S" else f"double {name}[HIGHEST + 2];"
            return
        declared = f"{TYPES[kind]} ".replace("* ", "*") if new else ""
        yield f"{declared}{name} = {self.as_kind(value, kind)};"

    def let_pair(self, a: str, b: str, pair: Value) -> Iterator[str]:
        yield f"const Pair {a}_{b} = {pair.text};"
        yield f"V {a} = {a}_{b}.one, {b} = {a}_{b}.other;"

    def store(self, target: ast.expr, place: Value, value: Value) -> Iterator[str]:
        text = self.as_kind(value, place.kind)
        masked = isinstance(target, ast.Attribute) and not self.lane and "here" in self.kinds
        yield f"{place.text} = pick(here, {text}, {place.text});" if masked else f"{place.text} = {text};"

    def block(self, head: str, body: Sequence[ast.stmt]) -> Iterator[str]:
        known = dict(self.kinds)
        yield f"{head} {{"
        for line in self.body(body):
            yield f"    {line}"
        yield "}"
        self.kinds = {x: kind for x, kind in self.kinds.items() if x in known}

    def count(self, name: str, way: str, first: str, last: str, body: Sequence[ast.stmt]) -> Iterator[str]:
        sign, change = ("<=", "++") if way == "up" else (">=", "--")
        yield from self.block(f"for (int {name} = {bare(first)}; {name} {sign} {bare(last)}; {name}{change})", body)

    def loop_over(self, name: str, what: str, body: Sequence[ast.stmt]) -> Iterator[str]:
        head = f"for (int {name} = 0; {name} < job->tables; {name}++)"
        if what == "states":
            head = f"for (const State *{name} = job->state; {name} < job->state + job->states; {name}++)"
        yield from self.block(head, body)

    def loop_while(self, test: Value, body: Sequence[ast.stmt]) -> Iterator[str]:
        yield from self.block(f"while ({bare(test.text)})", body)

    def shared_if(self, test: str, body: Sequence[ast.stmt]) -> Iterator[str]:
        yield from self.block(f"if ({bare(test)})", body)

    def lane_if(self, test: Value, s: ast.If, leaves: bool) -> Iterator[str]:
        if test.kind == "B":
            yield from self.block(f"if ({bare(test.text)})", s.body)
            return
        self.lane = True
        yield from self.block(f"EACH(lane, bits({bare(test.text)}))", s.body)
        self.lane = False

    def give(self, value: Value | tuple[Value, Value] | None) -> Iterator[str]:
        match value:
            case None:
                yield "return;"
            case (one, other):
                yield f"return (Pair){{{one.text}, {other.text}}};"
            case Value():
                yield f"return {self.as_kind(value, self.function.returns)};"

    def lines(self) -> Iterator[str]:
        """The whole function."""
        f = self.function
        body = list(self.body(f.node.body))
        first = {"LANES": ["Batch *b"], "LANE": ["Batch *b, unsigned lane"], "": []}[f.of]
        others = {x: TYPES[kind] for x, kind in f.parameters.items() if kind in TYPES}
        rest = [f"{kind} {x}".replace("* ", "*") for x, kind in others.items()]
        inline = "static" if f.of == "LANE" or self.all.iterates(f.name) else "INLINE"
        words = textwrap.wrap(" ".join(f.words.split()), 112)
        yield "/* " + "\n * ".join(words) + " */"
        yield f"{inline} {TYPES[f.returns]} {f.name}({', '.join([*first, *rest])})"
        yield "{"
        text = "\n".join(body)
        if f.of:
            if "job->" in text:
                yield "    const Job *const job = b->job;"
            if "c[" in text or ", c, " in text:
                yield "    V *const c = b->c;"
        for line in body:
            yield f"    {line}"
        yield "}"
        yield ""


def bare(text: str) -> str:
    """Without brackets around all of it."""
    depth = 0
    for k, x in enumerate(text):
        depth += (x == "(") - (x == ")")
        if not depth and k < len(text) - 1:
            return text
    return text[1:-1] if text.startswith("(") else text


def functions(text: Text) -> str:
    """All functions, and constants in front of them."""
    lines = []
    for x, value in text.constants.items():
        if x not in ("EPS", "INFINITY"):
            lines.append(f"#define {x} {value.hex() if isinstance(value, float) else value}")
    lines.append("")
    for f in text.functions.values():
        lines += C(text, f).lines()
    return "\n".join(lines)
