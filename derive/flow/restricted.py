"""Restricted Python, in which the integrators are written: its grammar, and the kinds of its values.

Functions have annotated parameters, and one statement after the other: assignments, ``for`` over `up` or `down`, over
tables or states, ``while``, ``if`` without ``else``, calls, and ``return`` at the end of a function or of an ``if``.
Statements outside this grammar are rejected with file and line.
"""

import ast
from dataclasses import dataclass, field
from math import factorial
from pathlib import Path
from typing import NoReturn

from derive.flow import layout
from derive.flow.integrator import TEXT, one_lane
from derive.kinds import TextMap, ValueDict, Values

FOLDER = Path(one_lane.__file__).parent

# Kinds of values. Vectors: V a number and M a truth value of each lane, S the coefficients of a series. All lanes: K a
# number, A an array of numbers, N an integer or a truth value, T a table, Q a state.
ANNOTATIONS = {x: x for x in "VMSTN"} | {"Lanes": "LANES"}
SIGNS = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.Div: "/",
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.Gt: ">",
    ast.GtE: ">=",
    ast.Eq: "==",
    ast.NotEq: "!=",
}
CODES: dict[str, tuple[str, Values]] = {x: (row.prefix, row.members) for x, row in layout.NUMBERED.items()} | {
    "Limit": ("", layout.LIMITS),
    "Share": ("", layout.SHARES),
}
# Entries of lanes, of tables and of states, by the kind of their owner: category and kind of each.
_OF_LANES = {
    **{x.lower(): ("CELL", "V") for x in (*layout.CELLS, *layout.WORKING)},
    **{x.removeprefix("cell_"): ("ROLE", "V") for x in layout.ROLES if x.startswith("cell_")},
    **{f"series.{x}": ("SERIES", "S") for x in layout.ROLES},
    **{f"has.{x.removeprefix('cell_')}": ("HAS", "N") for x in layout.ROLES},
    **dict.fromkeys(("samples", "logged", "timed", "autonomous", "by_rotation", "highest"), ("SHARED", "N")),
}
_OF_TABLE = {
    **{x.lower(): ("PART", "V") for x in layout.TABLE if x != "Q1"},
    **dict.fromkeys(("kind", "number", "degree", "terms", "pieces", "sine", "open"), ("TABLE", "N")),
    "series": ("TABLE", "S"),
    **dict.fromkeys(("places", "heights"), ("TABLE", "A")),
}
ENTRIES = {("LANES", x): entry for x, entry in _OF_LANES.items()}
ENTRIES |= {("T", before + x): entry for before in ("", "before.") for x, entry in _OF_TABLE.items()}
ENTRIES |= {
    ("Q", "is_rotation"): ("IS_ROTATION", "N"),
    ("Q", "is_speed"): ("IS_SPEED", "N"),
    ("Q", "now"): ("NOW", "V"),
    ("Q", "series"): ("STATE", "S"),
    ("Q", "rate"): ("STATE", "S"),
}
COMPARED = {"V": "M", "M": "M", "K": "N", "N": "N"}
# Kind of the result of each primitive, empty if it depends on the arguments.
PRIMITIVES = {
    **dict.fromkeys(("abs", "minimum", "maximum", "where", "sin", "cos", "log", "log1p", "expm1", "sqrt"), ""),
    "number": "K",
    **dict.fromkeys(("any_lane", "all_lanes", "lanes_in", "greatest", "least"), "N"),
    **dict.fromkeys(
        ("log2_of", "power_of_two", "breaks_at", "coefficients_at", "jumps_at", "last_quiet", "sample_time"), "V"
    ),
    **dict.fromkeys(("operate", "operate_later", "prologue", "note", "read_samples", "keep_sample"), "NONE"),
    "new_series": "S",
    "tail": "S",
    "none_of": "M",
}


# Constants that `one_lane` defines.
GIVEN = (
    "EPS",
    "INFINITY",
    "SINES",
    "COSINES",
    "ARCSINE",
    "LAST_OF_ARCSINE",
    "SHORTEST",
    "NODES",
    "SHARES",
    "LAST_SHARES",
    "NEXT_SHARES",
    *layout.RATIOS,
)


class GrammarError(Exception):
    """Text outside the restricted grammar, with its place."""


@dataclass(frozen=True)
class RestrictedFunction:
    """Function of the text."""

    name: str
    path: str
    node: ast.FunctionDef
    parameters: TextMap
    returns: str

    @property
    def of_lanes(self) -> bool:
        """Whether the first parameter is the lanes, not the case for functions of numbers alone."""
        return "LANES" in self.parameters.values()

    @property
    def words(self) -> str:
        """Docstring of the function."""
        return ast.get_docstring(self.node) or ""


@dataclass
class Text:
    """Functions of the text by name, in order, and its constants, numbers or tuples of numbers."""

    functions: dict[str, RestrictedFunction] = field(default_factory=dict)
    constants: ValueDict = field(default_factory=lambda: {x: getattr(one_lane, x) for x in GIVEN})

    def read(self, source: str, path: str) -> None:
        """Add the functions and constants of a module from its source text. ``path`` names it in error messages."""
        for node in ast.parse(source).body:
            match node:
                case ast.FunctionDef(args=ast.arguments(args=arguments), returns=returns):
                    parameters = {x.arg: annotation(x.annotation, path, node) for x in arguments}
                    result = annotation(returns, path, node)
                    self.functions[node.name] = RestrictedFunction(node.name, path, node, parameters, result)
                case ast.Assign(targets=[ast.Name(id=name)], value=value) if name not in self.constants:
                    self.constants[name] = eval(ast.unparse(value), {"factorial": factorial, **self.constants})
                case ast.Expr(value=ast.Constant()) | ast.ImportFrom():
                    pass
                case _:
                    refuse_node(path, node, "a module has imports, functions, and constants with one value each")

    def names_of(self, function: RestrictedFunction) -> set[str]:
        """Return the names of the functions of the text that a function calls."""
        called = {ast.unparse(x.func) for x in ast.walk(function.node) if isinstance(x, ast.Call)}
        return called & self.functions.keys()

    def iterates(self, name: str) -> bool:
        """Return whether the function called ``name``, or one that it calls, iterates until its lanes are finished."""
        function = self.functions[name]
        if any(isinstance(x, ast.While) and "any_lane" in ast.unparse(x.test) for x in ast.walk(function.node)):
            return True
        return any(self.iterates(x) for x in self.names_of(function) - {name})


def refuse_node(path: str, node: ast.AST, why: str) -> NoReturn:
    """Raise a `GrammarError` with the file, the line and the source of ``node``. ``why`` is the rule that it breaks."""
    raise GrammarError(f"{path}, line {getattr(node, 'lineno', 0)}: {why}: {ast.unparse(node).splitlines()[0]}")


def annotation(e: ast.expr | None, path: str, node: ast.AST) -> str:
    """Return the kind that the annotation ``e`` names, one of the values of `ANNOTATIONS`, or PAIR for two results.

    ``path`` and ``node``, the statement or function, give the place in an error message. Without annotation it is an
    error.
    """
    match e:
        case ast.Name(id=name) if name in ANNOTATIONS:
            return ANNOTATIONS[name]
        case ast.Constant(value=None):
            return "NONE"
        case ast.Subscript(value=ast.Name(id="tuple")):
            return "PAIR"
    refuse_node(path, node, "every parameter and result has one of the kinds " + ", ".join(ANNOTATIONS))


def integrator() -> Text:
    """Return the text of the integrator: the parsed functions and constants of `derive.flow.integrator`."""
    text = Text()
    for name in TEXT:
        path = FOLDER / f"{name}.py"
        text.read(path.read_text("utf-8"), f"derive/flow/integrator/{path.name}")
    return text
