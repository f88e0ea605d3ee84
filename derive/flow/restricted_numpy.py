"""Restricted Python written in NumPy, on arrays of all lanes."""

import ast
from collections.abc import Iterator

from derive.flow.restricted import Text
from derive.flow.writer import TypedExpression, Writer

TYPES = {
    "V": "Floats",
    "M": "Mask",
    "S": "Floats",
    "N": "int",
    "T": "Table",
    "NONE": "None",
    "PAIR": "tuple[Floats, Floats]",
    "LANES": "Lanes",
}
FORMS = {
    "False": "False",
    "True": "True",
    # Entries.
    "before": "{x}.before",
    "CODE": "ix.{x}",
    "CELL": "c[ix.{X}]",
    "ROLE": "c[{s}.roles.{x}]",
    "SERIES": "{s}.registers[{s}.roles.{x}]",
    "HAS": "({s}.roles.{x} >= 0)",
    "SHARED": "{s}.{x}",
    "SHARED.samples": "{s}.sample_count",
    "PART": "c[{of}.cells + ix.{X}]",
    "TABLE": "{of}.{x}",
    "TABLE.series": "{s}.registers[{of}.register]",
    "NOW": "c[{of}.cell]",
    "IS_ROTATION": "({of}.register == {s}.roles.x)",
    "IS_SPEED": "({of}.register == {s}.roles.omega)",
    "STATE.series": "{s}.registers[{of}.register]",
    "STATE.rate": "{s}.registers[{of}.rate]",
    "inverse": "(1.0 / ({x}))",
    "coefficients": "c[{of}.cells + ix.Q1 + ({x})]",
    "element": "{of}[{x}]",
    # Expressions.
    "broadcast": "{x}",
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
    "where": "np.where",
    "abs": "np.abs",
    "minimum": "np.minimum",
    "minimum.N": "min",
    "maximum": "np.maximum",
    "maximum.N": "max",
    "any_lane": "np.any",
    "lanes_in": "np.count_nonzero",
    "sin": "np.sin",
    "cos": "np.cos",
    "log": "np.log",
    "expm1": "np.expm1",
    "log1p": "np.log1p",
    "sqrt": "np.sqrt",
    "number": "float",
    "new_series": "np.zeros((ix.STRIDE, {series}.shape[1]))",
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
}


class NumPy(Writer):
    """Writer of one function in NumPy."""

    forms = FORMS

    def let(self, name: str, kind: str, value: TypedExpression, new: bool) -> str:
        """Return the statement that assigns a value to a name of this kind.

        It has an annotation if ``new`` and needed.
        """
        declared = f": {TYPES[kind]}" if new and value.kind in ("K", "N") and kind != "N" else ""
        held = value.text.startswith(("c[", f"{self.state}.registers[")) and value.kind == "V"
        return f"{name}{declared} = {value.text}{'.copy()' if held else ''}"

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
        yield f"def {f.name}({', '.join(parameters)}) -> {TYPES[f.returns]}:"
        words = f.words.split("\n\n")[0].replace("\n", " ")
        yield f'    """{words}"""'
        if f.of_lanes and any("c[" in line for line in body):
            yield f"    c = {self.state}.cells"
        for line in body:
            yield f"    {line}"


def numpy_functions(text: Text) -> str:
    """Return the NumPy source of all functions of the restricted text, preceded by its constants."""
    lines = [f"{x} = {value!r}" for x, value in text.constants.items() if x != "INFINITY"]
    lines.append("INFINITY = np.inf")
    return "\n\n\n".join(["\n".join(lines), *(NumPy(text, f).source() for f in text.functions.values())]) + "\n"
