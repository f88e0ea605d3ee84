"""Operations of a flow program: the meaning of each, and the recurrence of its Taylor coefficients.

Each operation is stated once. `prove` compares it with SymPy's series. The same statement yields the source of the
compiled interpreter and of the NumPy interpreter, and programs in any other arithmetic.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sympy import (
    Add,
    Derivative,
    Expr,
    Indexed,
    IndexedBase,
    Integer,
    Mul,
    Sum,
    Symbol,
    cos,
    exp,
    expand,
    factorial,
    log,
    sin,
    symbols,
)

from derive.algebra.prove import prove_zero
from derive.algebra.remainders import expm1, log1p, unfold
from derive.code import operations
from derive.declare.effects import DEGREE
from derive.kinds import Texts

CELLS = {name: o for name, o in operations.OPERATIONS.items() if o.vector}  # operations on numbers of lanes
n, k = symbols("n k", integer=True)
A, B, Q, X, Z, E, H, S, V, U, L = (IndexedBase(x) for x in "abqxzehsvul")


def _sum(a: IndexedBase, b: IndexedBase) -> Expr:
    """Return the sum of a[k] b[n - k] without its first and its last term.

    Steps add these two terms apart, since they contain coefficients of order n, which are the last to be computed.
    """
    return Sum(a[k] * b[n - k], (k, 1, n - 1))


@dataclass(frozen=True)
class SeriesOperation:
    """Operation on series: results and arguments, order 0 from order 0, and order n from the lower orders.

    ``start`` expresses order 0 of each result by order 0 of the arguments, without cancellation at 0, and ``step`` is
    coefficient n >= 1. ``definition`` states the results as functions of the arguments if they are not those of
    ``start``.
    """

    name: str
    results: tuple[IndexedBase, ...]
    arguments: tuple[IndexedBase, ...]
    start: tuple[Expr, ...]
    step: tuple[Expr, ...]
    definition: tuple[Expr, ...] = ()

    @property
    def means(self) -> tuple[Expr, ...]:
        """Results as functions of the arguments."""
        return self.definition or tuple(map(unfold, self.start))


D = IndexedBase("d")
M = IndexedBase("m")
POWERS = tuple(IndexedBase(f"p{power}") for power in range(2, DEGREE + 1))
_t = Symbol("t", real=True)  # the variable of the series: `tim` is t d/dt
OPERATIONS = {
    o.name: o
    for o in (
        SeriesOperation("mul", (D,), (A, B), (A * B,), (A[0] * B[n] + A[n] * B[0] + _sum(A, B),)),
        SeriesOperation("sqr", (D,), (A,), (A**2,), (2 * A[0] * A[n] + _sum(A, A),)),
        SeriesOperation(
            "powers",
            POWERS,
            (X,),
            tuple(X**power for power in range(2, DEGREE + 1)),
            tuple(X[0] * lower[n] + X[n] * lower[0] + _sum(X, lower) for lower in (X, *POWERS[:-1])),
        ),
        SeriesOperation("tim", (Q,), (A,), (Integer(0),), (n * A[n],), (_t * Derivative(A, _t),)),
        SeriesOperation(
            "turn",
            (S, V),
            (Q, X),
            (sin(X), 2 * sin(X / 2) ** 2),
            (X[n] * (1 - V[0]) - _sum(Q, V) / n, X[n] * S[0] + _sum(Q, S) / n),
            (sin(X), 1 - cos(X)),
        ),
        SeriesOperation("exp", (E, M), (Q, Z), (exp(Z), expm1(Z)), (Z[n] * E[0] + _sum(Q, E) / n, E[n])),
        SeriesOperation("rec", (H, M), (Z,), (1 / (1 + Z), -Z / (1 + Z)), (-H[0] * (Z[n] * H[0] + _sum(Z, H)), H[n])),
        SeriesOperation(
            "log",
            (U, L),
            (Q, Z),
            (Integer(0), log1p(Z)),
            ((Q[n] - _sum(U, Z)) / (1 + Z[0]), U[n] / n),
            (_t * Derivative(Z, _t) / (1 + Z), log(1 + Z)),
        ),
    )
}
SERIES = {name: code for code, name in enumerate(("lin", *OPERATIONS))}  # codes in the compiled integrator
SCALAR = {name: code for code, name in enumerate(CELLS)}


def prove(order: int = 6) -> Texts:
    """Prove each operation's coefficients equal to SymPy's series of its definition, and return the claims."""
    claims = []
    for o in OPERATIONS.values():
        coefficients = _coefficients(o, order)
        for i in range(order + 1):
            for result, start, step in zip(o.results, o.start, o.step, strict=True):
                of_order_0 = unfold(start.xreplace({x: coefficients[x][0] for x in o.arguments}))
                stated = at(step.subs(n, i).doit(), coefficients) if i else of_order_0
                prove_zero(expand(stated - coefficients[result][i]), f"{o.name}: coefficient {i}")
        claims.append(f"{o.name}: {order + 1} coefficients")
    return claims


def _coefficients(o: SeriesOperation, highest: int) -> dict[IndexedBase, tuple[Expr, ...]]:
    """Return Taylor coefficients of an operation's arguments, as symbols, and of its results, up to ``highest``."""
    coefficients = {x: symbols(f"{x}_:{highest + 1}", real=True) for x in o.arguments}
    if Z in o.arguments:  # 1 + z begins with a positive number
        coefficients[Z] = (Symbol("y", positive=True) - 1, *coefficients[Z][1:])
    if Q in o.arguments:  # coefficients of the other argument times their order
        coefficients[Q] = tuple(i * x for i, x in enumerate(coefficients[o.arguments[-1]]))
    series = {}
    for x, values in coefficients.items():
        series[x] = Add(*(value * _t**i for i, value in enumerate(values)))
    for result, means in zip(o.results, o.means, strict=True):
        derivatives = [means.xreplace(series).doit()]
        for _ in range(highest):
            derivatives.append(derivatives[-1].diff(_t))
        coefficients[result] = tuple(f.subs(_t, 0) / factorial(i) for i, f in enumerate(derivatives))
    return coefficients


def at(e: Expr, coefficients: Mapping[IndexedBase, Sequence[Any]]) -> Expr:
    """Return an expression with values in place of the coefficients of series, a[i]."""
    named = {}
    for x in e.atoms(Indexed):
        named[x] = coefficients[x.base][int(x.indices[0])]
    return e.xreplace(named)


def evaluate(
    operations: Iterable[Sequence[Any]],
    registers: Any,
    cell: Callable[[Any], Any],
    forms: Callable[[SeriesOperation], Sequence[Expr]],
) -> None:
    """Compute the results of operations on series, in order, in ``registers``, which contains values of the others.

    An operation consists of its kind, results, registers and cells. ``cell`` returns the number in a cell, and
    ``forms`` the results of a kind of operation as functions of its arguments.
    """
    for kind, results, arguments, cells in operations:
        values = [registers[x] for x in arguments]
        if kind == "lin":
            constant, *factors = map(cell, cells)
            registers[results[0]] = Add(constant, *map(Mul, factors, values))
            continue
        operation = OPERATIONS[kind]
        known = dict(zip(operation.arguments, values, strict=True))
        for result, form in zip(results, forms(operation), strict=True):
            registers[result] = form.xreplace(known)
