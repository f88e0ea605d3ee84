"""Return the text of `generated/flow.py`: fragments of these effects and laws, and the equation of motion."""

import ast
import inspect
from pprint import pformat

from sympy import Tuple, sstr

from derive.code.emit import filled
from derive.declare.effects import LAWS, Law
from derive.flow import equation
from derive.flow.fragments import INPUTS, QUANTITIES, fragments, pieces
from derive.flow.link import definitions, integers, linker, program, soils
from derive.flow.lowering import Fragment, OnSeries

LINKER = (definitions, linker, program, soils, integers)


def flow_module() -> str:
    """Return the text of the module."""
    blocks = {
        "INPUTS": {name: repr(meaning) for name, meaning in INPUTS.items()},
        "PIECES": {law.name: _pieces(law) for law in LAWS if law.kinks},
        "FRAGMENTS": {name: pformat(f._asdict(), width=120, sort_dicts=False) for name, f in fragments().items()},
    }
    marks = {}
    for mark, rows in blocks.items():
        marks[mark] = "".join(f"    {x!r}: {row},\n" for x, row in rows.items())
    marks |= {
        "CLASSES": "\n\n".join(map(inspect.getsource, (OnSeries, Fragment))),
        "QUANTITIES": repr(QUANTITIES),
        "TERMS": equation.equation_text(),
    }
    return filled("_flow.py.in", marks)


def _pieces(law: Law) -> str:
    """Return the pieces of a law with a kink as Python source: the scale of the slip, breaks and polynomials.

    The scale is the name of the parameter at which the branch changes. Breaks are multiples of it, and the coefficients
    of a polynomial of the distance from its break, over the scale, are listed lowest first.
    """
    breaks, polynomials = pieces(law)
    rows = Tuple(*(Tuple(*polynomial) for polynomial in polynomials))
    names = ", ".join(sorted(map(str, rows.free_symbols)))
    starts = tuple(map(float, breaks))
    return f"({law.kinks[0].name!r}, {starts!r}, lambda {names}, **_: {sstr(rows)})"


def linker_module() -> str:
    """Return the module `generated.program`: the linker's modules, with the imports of the template."""
    parts = []
    for part in LINKER:  # each after its last ``from`` import
        source = inspect.getsource(part)
        *_, last = (x for x in ast.parse(source).body if isinstance(x, ast.ImportFrom))
        parts.append("\n".join(source.splitlines()[last.end_lineno :]).strip("\n"))
    return filled("_program.py.in", {"LINKER": "\n\n\n".join(parts)})
