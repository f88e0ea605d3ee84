"""One lane of the integrator's text as plain Python, on floats or on mpmath's numbers.

Programs are run by the definitions of their operations, of which generated text is written.
"""

import math
import operator
from collections.abc import Callable, Mapping, Sequence
from functools import cache, reduce
from types import SimpleNamespace
from typing import Any

import mpmath
from sympy import Expr, Indexed, Sum

from derive.flow import layout
from derive.flow.integrator import phases, rest
from derive.flow.recurrences import OPERATIONS
from generated import layout as ix
from tests.support.lanes import Problem

PLACES = {name.lower(): k for k, name in enumerate(ix.CELLS)}
PLACES |= {name.lower(): getattr(ix, name) for name in layout.WORKING}
PARTS = {name.lower(): k for k, name in enumerate(ix.TABLE)}


def function(name: str, x: Any) -> Any:
    return getattr(math if isinstance(x, float) else mpmath, name)(x)


CELLS: dict[str, Any] = {
    "add": operator.add, "sub": operator.sub, "mul": operator.mul, "div": operator.truediv, "neg": operator.neg,
    "abs": abs, "min": lambda a, b: a if a < b else b, "max": lambda a, b: b if a < b else a,
    "less": lambda a, b: 1.0 if a < b else 0.0, "select": lambda a, b, e: b if a > 0 else e,
}  # fmt: skip


@cache
def evaluated(e: Expr) -> Callable[[Mapping[str, Any]], Any]:
    """A SymPy expression as a function of what is known, in the arithmetic of those numbers."""
    parts, name = [evaluated(x) for x in e.args if isinstance(x, Expr)], str(e)
    if isinstance(e, Indexed):
        base, index = str(e.base), parts[-1]
        return lambda known: known[base][int(index(known))]
    if isinstance(e, Sum):
        ((k, first, last),) = e.limits
        term, low, high, counter = parts[0], evaluated(first), evaluated(last), str(k)
        return lambda known: sum(
            (term({**known, counter: x}) for x in range(int(low(known)), int(high(known)) + 1)), 0.0
        )
    if e.is_Symbol:
        return lambda known: known[name]
    if e.is_Rational:
        value = int(e) if e.is_Integer else e.p / e.q
        return lambda known: value
    if e.is_Add or e.is_Mul:
        joined = operator.add if e.is_Add else operator.mul
        return lambda known: reduce(joined, [part(known) for part in parts])
    if e.is_Pow:
        return lambda known: parts[0](known) ** parts[1](known)
    called = type(e).__name__.lower()
    return lambda known: function(called, parts[0](known))


def _bare(role: str) -> str:
    return role.removeprefix("cell_")


class Entries:
    """Attributes that are cells of a lane."""

    def __init__(self, cells: list[Any], places: Mapping[str, int], **others: Any) -> None:
        self.__dict__.update(others, cells=cells, places=places)

    def __getattr__(self, name: str) -> Any:
        return self.cells[self.places[name]]

    def __setattr__(self, name: str, value: Any) -> None:
        self.cells[self.places[name]] = value


class Lane(Entries):
    """A lane, as the text takes it."""

    def __init__(self, problem: Problem, column: int, number: Any = float) -> None:
        begun = problem.cells()
        program, highest = problem.program, int(begun[ix.ORDER].max())
        cells = [number(float(x)) for x in begun[:, column]] + [number(0.0)] * -ix.PENDING
        registers = [[number(0.0)] * (highest + 2) for _ in program.registers]
        roles = {_bare(name): place for name, place in program.roles.items()}
        places = PLACES | {_bare(x): program.roles[x] for x in ix.ROLES if x[:5] == "cell_" and x in program.roles}
        tables: list[Any] = []
        for k, (slot, data) in enumerate(zip(program.tables, problem.tables(), strict=True)):
            own = {name: slot.cells + part for name, part in PARTS.items()}
            tables.append(Entries(
                cells, own, number=k, before=tables[-1] if k else None, kind=ix.KINDS.index(slot.kind),
                degree=slot.degree, terms=data.coefficients.shape[1], pieces=len(data.breaks), sine=data.sine,
                open=data.open, series=registers[slot.register], breaks=[number(x) for x in data.breaks.tolist()],
                jumps=[number(x) for x in data.jumps.tolist()], coefficients=Window(cells, slot.cells + ix.Q1),
                polynomials=[[number(x) for x in row] for row in data.coefficients.tolist()]))  # fmt: skip
        names = ("x", "omega", "net", "normal", "upright")
        states = [Entries(cells, {"now": cell}, series=registers[r], rate=registers[rate],
                           has_own_radius=rate != program.roles["omega"])
                  for cell, r, rate in program.states]  # fmt: skip
        super().__init__(
            cells, places, program=program, registers=registers, states=states, tables=tables, notes=[], samples=0,
            series=SimpleNamespace(**{x: registers[roles[x]] for x in names if roles.get(x, -1) >= 0}),
            has=SimpleNamespace(**{x: roles.get(x, -1) >= 0 for x in map(_bare, ix.ROLES)}), highest=highest,
            timed=sum(t.kind == ix.OF_TIME for t in tables), autonomous=program.autonomous,
            inverse=[number(0.0), *(1 / number(float(k)) for k in range(1, highest + 2))])  # fmt: skip

    def prologue(self) -> None:
        for name, result, *arguments in self.program.scalar:
            values = [self.cells[k] for k in arguments]
            self.cells[result] = CELLS[name](*values) if name in CELLS else function(name, *values)

    def operate(self, n: int) -> None:
        r = self.registers
        for name, *names in self.program.series:
            if name == "lin":
                result, constant, terms = names
                start = self.cells[constant] if n == 0 and constant >= 0 else 0.0
                r[result][n] = sum((self.cells[c] * r[x][n] for c, x in terms), start)
            elif name != "ramp":
                self.apply(name, names, n)

    def apply(self, name: str, names: Sequence[int], n: int) -> None:
        o = OPERATIONS[name]
        places = dict(zip((*o.results, *o.arguments, *o.numbers), names, strict=True))
        known = {str(x): self.cells[k] if x in o.numbers else self.registers[k] for x, k in places.items()}
        for result, start, step in zip(o.results, o.start, o.step, strict=True):
            self.registers[places[result]][n] = evaluated(step if n else start)({**known, "n": n})


class Window:
    """Cells from one on."""

    def __init__(self, cells: list[Any], first: int) -> None:
        self.cells, self.first = cells, first

    def __setitem__(self, k: int, value: Any) -> None:
        self.cells[self.first + k] = value


def integrate(problem: Problem, column: int, number: Any = float) -> list[Any]:
    """How a lane ends: the cells that every lane has."""
    lane = Lane(problem, column, number)
    phases.start(lane)
    phases.begin_phases(lane)
    while lane.status <= ix.RESTING:
        rest.advance(lane, True)
    return lane.cells[: ix.OMEGA + 1]
