"""Restricted Python written in NumPy: numerics on arrays of all lanes, phases on the lanes of an index.

An ``if`` by lane selects the lanes where its condition is true from the index and from the values known for them.
"""

import ast
from collections.abc import Iterator

from derive.flow.restricted import RestrictedFunction, Text
from derive.flow.writer import TypedExpression, Writer, stored_in

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
FORMS = {
    "False": "False",
    "True": "True",
    # Entries.
    "at": ", i",
    "of_lane": "{x}[i]",
    "before": "{x}.before",
    "CODE": "ix.{x}",
    "CELL": "c[ix.{X}{at}]",
    "ROLE": "c[{s}.roles.{x}{at}]",
    "SERIES": "{s}.registers[{s}.roles.{x}]",
    "HAS": "({s}.roles.{x} >= 0)",
    "SHARED": "{s}.{x}",
    "SHARED.samples": "{s}.sample_count",
    "PART": "c[{of}.cells + ix.{X}{at}]",
    "TABLE": "{of}.{x}",
    "TABLE.series": "{s}.registers[{of}.register]",
    "NOW": "c[{of}.cell{at}]",
    "HAS_OWN_RADIUS": "({of}.register != {s}.roles.x)",
    "STATE.series": "{s}.registers[{of}.register]",
    "STATE.rate": "{s}.registers[{of}.rate]",
    "inverse": "(1.0 / ({x}))",
    "coefficients": "c[{of}.cells + ix.Q1 + ({x}){at}]",
    "element": "{of}[{x}{at}]",
    # Expressions.
    "broadcast.V": "{x}",
    "broadcast.I": "np.full(i.size, {x})",
    "broadcast.B": "np.full(i.size, {x})",
    "cast": "{x}",
    "not": "np.logical_not({a})",
    "not.N": "(not {a})",
    "and": "&",
    "and.N": "and",
    "or": "|",
    "or.N": "or",
    "choice": "({b} if {a} else {c})",
    # Functions.
    "LANES": "{s}",
    "LANE": "{s}, i",
    "where": "np.where",
    "abs": "np.abs",
    "minimum": "np.fmin",
    "minimum.V": "np.minimum",
    "minimum.N": "min",
    "minimum.K": "min",
    "maximum": "np.fmax",
    "maximum.V": "np.maximum",
    "maximum.N": "max",
    "maximum.K": "max",
    "any_lane": "np.any",
    "lanes_in": "np.count_nonzero",
    "sin": "np.sin",
    "cos": "np.cos",
    "log": "np.log",
    "expm1": "np.expm1",
    "log1p": "np.log1p",
    "sqrt": "np.sqrt",
    "number": "float",
    "number.F": "{a}",
    "new_series": "np.zeros((ix.STRIDE, {series}.shape[1]))",
    "numbers": "np.zeros(({s}.terms, i.size))",
    "tail": "{0}[1:]",
    # Statements.
    "skip": "if not np.any(here):\n    return",
    "end": "",
    "open": ":",
    "close": "",
    "up": "for {of} in range({x}, {to} + 1)",
    "up.0": "for {of} in range({to} + 1)",
    "down": "for {of} in range({x}, {to} - 1, -1)",
    "tables": "for {x} in {s}.tables",
    "states": "for {x} in {s}.states",
    "while": "while {x}",
    "if": "if {x}",
    "pair": "return {a}, {b}",
    **dict.fromkeys(("let_pair", "set_pair"), "{a}, {b} = {x}"),
    "masked": "np.where",
    "of_mask": "i = np.flatnonzero({x})\nif i.size",
}
OF_LANE = {"F", "I", "B", "A"}


class NumPy(Writer):
    """Writer of one function in NumPy; ``i`` is the index of its lanes, or of some of them."""

    forms = FORMS

    def __init__(self, text: Text, function: RestrictedFunction) -> None:
        super().__init__(text, function)
        self.ifs = 0

    def let(self, name: str, kind: str, value: TypedExpression, new: bool) -> str:
        """Return the statement that assigns a value to a name of this kind.

        It has an annotation if ``new`` and needed.
        """
        declared = f": {TYPES[kind]}" if new and value.kind in ("K", "N") and kind != "N" else ""
        held = value.text.startswith(("c[", f"{self.state}.registers[")) and value.kind == "V"
        held = held or value.text.partition("[")[0] in (x for x, k in self.kinds.items() if k == "A")
        return f"{name}{declared} = {value.text}{'.copy()' if held else ''}"

    def of_lane(self, test: TypedExpression, s: ast.If) -> Iterator[str]:
        """Yield the lines of the ``if`` statement ``s`` on ``test``, a truth value of one lane."""
        self.ifs += 1
        mark = self.ifs
        names = self._known_after(s)
        before = [f"{x}_{mark}" for x in names]
        known = ", ".join(names)
        kept = ", ".join(before)
        yield f"holds_{mark} = {test.text}"
        yield f"{kept} = {known}"
        yield f"{known}, = among(holds_{mark}, {kept})"
        yield from self.block("if i.size", s.body)
        yield f"{known} = {kept}"

    def repeat(self, test: TypedExpression, s: ast.While) -> Iterator[str]:
        """Yield the lines of the loop ``s``, which continues in the lanes where ``test`` is true."""
        if test.kind != "B":
            yield from super().repeat(test, s)
            return
        self.ifs += 1
        mark = self.ifs
        names = self._known_after(s)
        changed = stored_in(s)
        kept = [f"{x}_{mark}" for x in names]
        known = ", ".join([*names, f"place_{mark}"])
        yield f"{', '.join(kept)} = {', '.join(f'{x}.copy()' if x in changed else x for x in names)}"
        yield f"place_{mark} = np.arange(i.size)"
        body = self.block("while True", s.body)
        yield next(body)
        yield f"    {known} = among({test.text}, {known})"
        yield "    if not i.size:"
        yield "        break"
        yield from body
        for name in names:
            if name in changed:
                yield f"    {name}_{mark}[place_{mark}] = {name}"
        yield f"{', '.join(names)} = {', '.join(kept)}"

    def _known_after(self, s: ast.stmt) -> list[str]:
        """Return ``i``, the index of lanes, and the names of values by lane used in the statement ``s`` or later."""
        used = set()
        for x in ast.walk(self.function.node):
            if isinstance(x, ast.Name) and x.lineno >= s.lineno:
                used.add(x.id)
        return ["i", *(name for name, kind in self.kinds.items() if kind in OF_LANE and name in used)]

    def source(self) -> str:
        """Return the source of the function."""
        return ast.unparse(ast.parse("\n".join(self._lines())))

    def _lines(self) -> Iterator[str]:
        """Yield the lines of the function's source, before formatting."""
        f = self.function
        body = list(self.statements())
        parameters = []
        for name, kind in f.parameters.items():
            parameters.append(f"{name}: {TYPES[kind]}")
            if kind == "LANE":
                parameters.append("i: Index")
        yield f"def {f.name}({', '.join(parameters)}) -> {TYPES[f.returns]}:"
        words = f.words.split("\n\n")[0].replace("\n", " ")
        yield f'    """{words}"""'
        if f.of and any("c[" in line for line in body):
            yield f"    c = {self.state}.cells"
        for line in body:
            yield f"    {line}"


def numpy_functions(text: Text) -> str:
    """Return the NumPy source of all functions of the restricted text, preceded by its constants."""
    lines = [f"{x} = {value!r}" for x, value in text.constants.items() if x != "INFINITY"]
    lines.append("INFINITY = np.inf")
    return "\n\n\n".join(["\n".join(lines), *(NumPy(text, f).source() for f in text.functions.values())]) + "\n"
