"""The text of `generated/flow.py`: fragments, and the tangents of operations, as data."""

import inspect
from collections.abc import Sequence

from sympy import Expr, Float, cos, diff, exp, expand, log, sin, sstr

from derive.algebra.remainders import Select
from derive.declare.effects import ALL_EFFECTS, LAWS, Effect, Law
from derive.flow import equation
from derive.flow.fragments import INPUTS, QUANTITIES, fragments, pieces
from derive.flow.lowering import ZERO, Fragment, Lowering, cell, series
from derive.flow.operations import OPERATIONS, POWER, POWERS, SCALARS, Operation

_HEAD = '''"""The balance of momentum, as fragments of flow programs: what each effect and each law adds, as operations.

In dimensionless numbers, time t sqrt(g/R), angular velocity omega sqrt(R/g), stresses over sigma_ref:

{equation}

Fragments are joined to a scene's program by the names of what they make and take. ``..._0`` is a number where the phase
began and ``d...`` the series of its increment since; ``=1.0`` is a constant.
"""

from collections.abc import Callable
from typing import Any, NamedTuple


{fragment}

# The names of an operation's results and arguments, and the operations that make the tangents of its results: a prime
# marks a tangent, other names are for what is made on the way.
Tangents = tuple[tuple[str, ...], tuple[tuple[object, ...], ...]]

'''


def module(effects: Sequence[Effect] = ALL_EFFECTS, laws: Sequence[Law] = LAWS) -> str:
    """The module's text."""
    inputs = {name: repr(meaning) for name, meaning in INPUTS.items()}
    kinked = {law.name: _pieces(law) for law in laws if law.kinks}
    cells = {name: repr((("d", "a", "b", "e"), of_cell(means))) for name, (means, _, _) in SCALARS.items()}
    registers = {}
    for name, o in OPERATIONS.items():
        names = tuple(map(str, (*o.results, *o.arguments, *o.numbers)))
        registers[name] = repr((names, of_series(o)))
    parts = {name: _fragment(f) for name, f in fragments(effects, laws).items()}
    blocks = (
        ("Numbers that every scene gives", "INPUTS", inputs),
        (
            "Laws of slip in pieces: their scale, where pieces begin over it, and their polynomials in what is beyond",
            "PIECES: dict[str, tuple[str, tuple[float, ...], Callable[..., Any]]]",
            kinked,
        ),
        ("Operations that make the tangent of a cell", "CELL_TANGENTS: dict[str, Tangents]", cells),
        ("Operations that make the tangents of a register", "SERIES_TANGENTS: dict[str, Tangents]", registers),
        ("Parts of programs", "FRAGMENTS: dict[str, Fragment]", parts),
    )
    text = _HEAD.format(fragment=inspect.getsource(Fragment), equation=equation.in_plain_text())
    for comment, name, rows in blocks:
        lines = "".join(f"    {x!r}: {row},\n" for x, row in rows.items())
        text += f"# {comment}.\n{name} = {{\n{lines}}}\n\n"
    return text + f"QUANTITIES = {QUANTITIES!r}  # what fragments add to\n\n{equation.text()}"


def _pieces(law: Law) -> str:
    """Scale, breaks and polynomials of a law as Python."""
    breaks, polynomials = pieces(law)
    names: set[str] = set()
    rows = []
    for polynomial in polynomials:
        coefficients = []
        for c in polynomial:
            names.update(str(x) for x in c.free_symbols)
            coefficients.append(sstr(Float(c) if c.is_Number else c))
        rows.append(f"({', '.join(coefficients)})")
    starts = tuple(map(float, breaks))
    return f"({law.scale!r}, {starts!r}, lambda {', '.join(sorted(names))}, **_: ({', '.join(rows)}))"


def _fragment(f: Fragment) -> str:
    lines = []
    for name, value in f._asdict().items():
        if name in ("words", "scalar", "series") and value:
            rows = "".join(f"            {x!r},\n" for x in value)
            lines.append(f"        {name}=(\n{rows}        ),\n")
        elif name == "adds" and value:
            rows = "".join(f"            {x!r}: {added!r},\n" for x, added in value.items())
            lines.append(f"        {name}={{\n{rows}        }},\n")
        else:
            lines.append(f"        {name}={value!r},\n")
    return f"Fragment(\n{''.join(lines)}    )"


# What a small change of its arguments makes of the result of each operation, so that a program differentiates itself:
# derived from what the operations mean, and lowered to the same operations. A prime marks a tangent: of the result d of
# an operation on cells a, b and e it is ``d'``, made of these and of ``a'``, ``b'`` and ``e'``.
Template = tuple[tuple[object, ...], ...]


def of_cell(means: Expr) -> Template:
    """Operations that compute the tangent of the result of an operation on cells."""

    def tangent(e: Expr) -> Expr:
        if isinstance(e, Select):  # of the branch that is taken
            return Select(*e.args[:2], tangent(e.args[2]), tangent(e.args[3]))
        return sum(diff(e, x) * cell(f"{x}'") for x in sorted(e.free_symbols, key=str))

    low = Lowering("*", {})
    low.cells["d'"] = tangent(means)
    return low.scalar()


# What a derivative is made of, as registers, and the operation that makes one which is not there.
_s, _v, _x, _e, _z, _p, _l, _h = (cell(x) for x in "svxezplh")
_POWERS = {_x**power: cell(str(result)) for power, result in reversed([*enumerate(POWERS, 2)])}  # highest first
_KNOWN = {
    cos(_x): 1 - _v,
    sin(_x): _s,
    exp(_z): _e,
    (1 + _z) ** POWER: _p,
    log(1 + _z): _l,
    1 / (1 + _z): _h,
    **_POWERS,
}
_HELPERS = {_l: ("log", "l", "z"), _h: ("rec", "h", "*.h_less_1", "z")}


def of_series(o: Operation) -> Template:
    """Operations that compute the tangents of the results of an operation on series."""
    if o.name == "tim":  # linear in its argument
        return (("tim", "q'", "a'"),)
    symbols = {x: cell(str(x)) for x in (*o.results, *o.arguments)}
    tangents = {x: cell(f"{x}'") for x in (*o.arguments, *o.numbers)}
    registers = (*symbols.values(), *_HELPERS, *(tangents[x] for x in o.arguments))
    low = Lowering("*", {x: (ZERO, series(str(x))) for x in registers})
    for result, means in zip(o.results, o.means, strict=True):
        function = means.xreplace(symbols)
        change = ZERO
        for x, tangent in tangents.items():
            slope = diff(function, symbols.get(x, x))
            for known, register in _KNOWN.items():
                slope = slope.subs(known, register)
            for helper, operation in _HELPERS.items():
                if helper in slope.free_symbols.difference(symbols.values()):
                    low.put(*operation)
            change += slope * tangent
        _, increment = low.split(expand(change))
        low.put("lin", f"{result}'", "", low.sum(increment))
    return tuple(low.series)
