"""What a small change of its arguments makes of the result of each operation: a program that differentiates itself.

Derived from what the operations mean, by SymPy, and lowered to the same operations. A prime marks a tangent: of the
result d of an operation on cells a, b and e it is ``d'``, made of these and of ``a'``, ``b'`` and ``e'``.
"""

import sympy as sp

from derive.algebra.remainders import Select
from derive.flow.lowering import Lowering, cell, series
from derive.flow.operations import POWER, Operation

Template = tuple[tuple[object, ...], ...]


def of_cell(means: sp.Expr) -> Template:
    """The operations that make the tangent of what an operation on cells means."""

    def tangent(e: sp.Expr) -> sp.Expr:
        if isinstance(e, Select):  # of the branch that is taken
            return Select(*e.args[:2], tangent(e.args[2]), tangent(e.args[3]))
        return sum(sp.diff(e, x) * cell(f"{x}'") for x in sorted(e.free_symbols, key=str))

    low = Lowering("*", {})
    low.cells["d'"] = tangent(means)
    return low.scalar()


# What a derivative is made of, as registers, and the operation that makes one which is not there.
_s, _v, _x, _e, _z, _p, _l, _h = (cell(x) for x in "svxezplh")
_KNOWN = {
    sp.cos(_x): 1 - _v, sp.sin(_x): _s, sp.exp(_z): _e, (1 + _z) ** POWER: _p, sp.log(1 + _z): _l, 1 / (1 + _z): _h,
}  # fmt: skip
_HELPERS = {_l: ("log", "l", "z"), _h: ("rec", "h", "*.h_less_1", "z")}


def of_series(o: Operation) -> Template:
    """The operations that make the tangents of the results of one on series."""
    if o.name == "tim":  # linear in its argument
        return (("tim", "q'", "a'"),)
    symbols = {x: cell(str(x)) for x in (*o.results, *o.arguments)}
    tangents = {x: cell(f"{x}'") for x in (*o.arguments, *o.numbers)}
    registers = (*symbols.values(), *_HELPERS, *(tangents[x] for x in o.arguments))
    low = Lowering("*", {x: (sp.Integer(0), series(str(x))) for x in registers})
    for result, means in zip(o.results, o.means, strict=True):
        change = sp.Integer(0)
        for x, tangent in tangents.items():
            slope = sp.diff(means.xreplace(symbols), symbols.get(x, x))
            for function, register in _KNOWN.items():
                slope = slope.subs(function, register)
            for helper, operation in _HELPERS.items():
                if helper in slope.free_symbols - {*symbols.values()}:
                    low.put(*operation)
            change += slope * tangent
        low.put("lin", f"{result}'", "", low.sum(low.split(sp.expand(change))[1]))
    return tuple(low.series)
