"""Restricted Python written as C: vectors of lanes."""

import textwrap
from collections.abc import Iterator

from derive.flow.restricted import Text
from derive.flow.writer import TypedExpression, Writer

SHORT = 12  # statements of functions that are always inlined; compilers decide about longer ones, for smaller wheels
TYPES = {"V": "V", "M": "M", "S": "V *", "N": "int", "T": "int", "NONE": "void", "PAIR": "Pair"}
FORMS = {
    "False": "0",
    "True": "1",
    # Entries.
    "before": "{x} - 1",
    "CODE": "{x}",
    "CELL": "c[{X}]",
    "ROLE": "c[job->role->{x}]",
    "SERIES": "(b->r + job->role->{x})",
    "HAS": "(job->role->{x} >= 0)",
    "HAS.net_sine": "HAS_CLOSED_FORM(job->role)",
    "HAS.loss_rate": "SOFTENS(job->role)",
    "SHARED": "job->{x}",
    "SHARED.logged": "(job->notes_room > 0)",
    "SHARED.highest": "job->order",
    "PART": "c[job->table[{of}].cell + {X}]",
    "TABLE": "job->data[{of}].{x}",
    "TABLE.number": "{of}",
    "TABLE.series": "(b->r + job->table[{of}].reg)",
    "TABLE.pieces": "(int)job->data[{of}].pieces",
    "TABLE.places": "job->data[{of}].breaks",
    "TABLE.heights": "job->data[{of}].coefficients",
    "TABLE.kind": "job->table[{of}].kind",
    "TABLE.degree": "job->table[{of}].degree",
    "NOW": "c[{of}->cell]",
    "IS_ROTATION": "({of}->series == job->role->x)",
    "IS_SPEED": "({of}->series == job->role->omega)",
    "STATE": "(b->r + {of}->{x})",
    "inverse": "b->inverse[{x}]",
    "coefficients": "c[job->table[{of}].cell + Q1 + {x}]",
    "element": "{of}[{x}]",
    # Expressions.
    "broadcast": "broadcast({x})",
    "cast": "(double){x}",
    "not": "!{a}",
    "not.M": "~{a}",
    "and": "&&",
    "and.M": "&",
    "or": "||",
    "or.M": "|",
    "choice": "({a} ? {b} : {c})",
    # Functions.
    "LANES": "b",
    "where": "pick",
    "abs": "magnitude",
    **{x: f"{x}_of" for x in ("sin", "cos", "log", "log1p", "expm1", "sqrt")},
    "minimum.N": "({a} < {b} ? {a} : {b})",
    "maximum.N": "({a} > {b} ? {a} : {b})",
    "any_lane": "bits",
    "lanes_in": "__builtin_popcount(bits({a}))",
    "number": "(double){a}",
    "none_of": "(M){{0}}",
    "tail": "({0} + 1)",
    # Statements.
    "skip": "if (!bits(here)) return;",
    "end": ";",
    "open": " {",
    "close": "}",
    "up": "for (int {of} = {x}; {of} <= {to}; {of}++)",
    "down": "for (int {of} = {x}; {of} >= {to}; {of}--)",
    "tables": "for (int {x} = 0; {x} < job->tables; {x}++)",
    "states": "for (const State *{x} = job->state; {x} < job->state + job->states; {x}++)",
    "while": "while ({x})",
    "if": "if ({x})",
    "pair": "return (Pair){{{a}, {b}}};",
    "let_pair": "const Pair {a}_{b} = {x};\nV {a} = {a}_{b}.one, {b} = {a}_{b}.other;",
    "set_pair": "const Pair {a}_{b} = {x};\n{a} = {a}_{b}.one, {b} = {a}_{b}.other;",
    "masked": "pick",
}


class C(Writer):
    """Writer of one function as C."""

    forms = FORMS

    def let(self, name: str, kind: str, value: TypedExpression, new: bool) -> str:
        """Return the statement that assigns a value to a name of this kind. It declares the name if ``new``."""
        if value.text == "new_series()":
            return f"V {name}[STRIDE];"
        declared = f"{TYPES[kind]} ".replace("* ", "*") if new else ""
        return f"{declared}{name} = {self.as_kind(value, kind)};"

    def lines(self) -> Iterator[str]:
        """Yield the lines of the function."""
        f = self.function
        body = list(self.statements())
        first = ["Batch *b"] if f.of_lanes else []
        others = {x: TYPES[kind] for x, kind in f.parameters.items() if kind in TYPES}
        rest = [f"{kind} {x}".replace("* ", "*") for x, kind in others.items()]
        inline = "INLINE" if len(body) <= SHORT and not self.all.iterates(f.name) else "static"
        words = textwrap.wrap(" ".join(f.words.split()), 112)
        yield "/* " + "\n * ".join(words) + " */"
        yield f"{inline} {TYPES[f.returns]} {f.name}({', '.join([*first, *rest])})"
        yield "{"
        text = "\n".join(body)
        if f.of_lanes:
            if "job->" in text:
                yield "    const Job *const job = b->job;"
            if "c[" in text or ", c, " in text:
                yield "    V *const c = b->c;"
        for line in body:
            yield f"    {line}"
        yield "}"
        yield ""


def c_functions(text: Text) -> str:
    """Return the C source of all functions of the restricted text, preceded by its constants."""
    lines = []
    for x, value in text.constants.items():
        if isinstance(value, tuple):
            lines.append(f"static const double {x}[] = {{{', '.join(map(repr, value))}}};")
        elif x not in ("EPS", "INFINITY"):
            lines.append(f"#define {x} {value.hex() if isinstance(value, float) else value}")
    lines.append("")
    for f in text.functions.values():
        lines += C(text, f).lines()
    return "\n".join(lines)
