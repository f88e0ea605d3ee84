"""A scene's flow program, joined of the fragments in `generated.flow` that its effects and friction law call for.

Joining is linking: names become indices, what is nothing (a frozen mass does not turn, a constant does not change)
is left out with all that it is a factor of, equal operations are done once, and sums of sums become one.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

from generated.flow import CELLS, FRAGMENTS, INPUTS, QUANTITIES

TABLE_CELLS = ("PIECE", "VALUE", "INC", "UPPER", "LOWER", "SCALE", "FACTOR")  # then Q1 to Q of the degree
ZERO, ONE, MINUS = "=0.0", "=1.0", "=-1.0"


@dataclass(frozen=True)
class Table:
    """A piecewise function as a program knows it: what of, the register of its argument (or, of time, of its
    increment), the first of its cells, and the degree of its pieces.
    """

    name: str
    kind: str
    register: int
    cells: int
    degree: int


@dataclass(frozen=True, eq=False)
class Program:
    """Cells and registers by name, operations on cells and on series by their indices, and who plays which role.

    The first ``lasting`` cells hold a lane; beyond are ``constants``, by name, and what a prologue needs while it runs.
    ``states`` are (cell, register, register of the rate).
    """

    cells: tuple[str, ...]
    lasting: int
    registers: tuple[str, ...]
    scalar: tuple[tuple[Any, ...], ...]
    series: tuple[tuple[Any, ...], ...]
    states: tuple[tuple[int, int, int], ...]
    tables: tuple[Table, ...]
    roles: Mapping[str, int]
    constants: Mapping[str, float]


Operation = tuple[Any, ...]  # its name and its arguments


@dataclass
class _Linker:
    """Definitions by name, and what has become of them."""

    cells: dict[str, tuple[str, ...]] = field(default_factory=dict)
    registers: dict[str, Operation] = field(default_factory=dict)
    kept: set[str] = field(default_factory=set)  # registers that more than sums are made of
    known: dict[str, str] = field(default_factory=dict)  # canonical cell by name
    made: dict[str, str | None] = field(default_factory=dict)  # canonical register by name; None is nothing
    scalar: dict[Operation, str] = field(default_factory=dict)
    series: dict[Operation, tuple[str, ...]] = field(default_factory=dict)

    def cell(self, name: str) -> str:
        """The cell that a name stands for, computed if need be."""
        if name.startswith("="):
            return name
        if name not in self.known:
            op, *arguments = self.cells[name]
            self.known[name] = self.compute(op, *map(self.cell, arguments), name=name)
        return self.known[name]

    def compute(self, op: str, *a: str, name: str = "") -> str:
        """An operation on cells, or what is known to come of it."""
        match op, a:
            case ("set", (x,)) | ("add", (x, "=0.0")) | ("add", ("=0.0", x)) | ("sub", (x, "=0.0")):
                return x
            case ("mul", (x, "=1.0")) | ("mul", ("=1.0", x)) | ("div", (x, "=1.0")):
                return x
            case ("mul", ("=0.0", _)) | ("mul", (_, "=0.0")) | ("div", ("=0.0", _)) | ("neg" | "abs", ("=0.0",)):
                return ZERO
            case ("sub", ("=0.0", x)) | ("mul", (x, "=-1.0")) | ("mul", ("=-1.0", x)):
                return self.compute("neg", x, name=name)
            case ("neg", ("=1.0",)):
                return MINUS
        return self.scalar.setdefault((op, *a), name or f"cell{len(self.scalar)}")

    def nothing(self, name: str) -> bool:
        """Whether a register is nothing: undefined, or a product with or a sum of nothing."""
        if name not in self.made:
            op, *names = self.registers.get(name, ("lin", "", "", ()))
            if op == "lin":
                absent = (not names[1] or self.cell(names[1]) == ZERO) and all(
                    self.cell(c) == ZERO or self.nothing(r) for c, r in names[2]
                )
            else:
                absent = op != "ramp" and any(map(self.nothing, self.arguments(op, names)))
            if not absent:
                return False
            self.made[name] = None
        return self.made[name] is None

    @staticmethod
    def arguments(op: str, names: list[Any]) -> list[str]:
        """The registers among the names of an operation that are no results."""
        return list(names[RESULTS.get(op, 1) : -1 if op == "pow" else None])

    def register(self, name: str) -> str | None:
        """The register that a name stands for, made if need be; None where it is nothing."""
        if not self.nothing(name) and name not in self.made:
            op, *names = self.registers[name]
            if op == "lin":
                self.made[name] = self.sum(name, self.cell(names[1]) if names[1] else ZERO, names[2])
            else:
                results, rest = names[: RESULTS.get(op, 1)], names[RESULTS.get(op, 1) :]
                if op != "ramp":
                    rest = [
                        *map(self.register, self.arguments(op, names)),
                        *([self.cell(rest[-1])] if op == "pow" else []),
                    ]
                self.made[name] = self.series.setdefault((op, *rest), tuple(results))[results.index(name)]
        return self.made[name]

    def terms(self, terms: Iterable[tuple[str, str]], factor: str = ONE) -> Iterator[tuple[str, str]]:
        """A sum's cells and registers, those of sums that only sums are made of in their place."""
        for c, r in terms:
            cell = self.compute("mul", factor, self.cell(c))
            if cell != ZERO and not self.nothing(r):
                op, *names = self.registers.get(r, ("state",))
                if op == "lin" and not names[1] and r not in self.kept:
                    yield from self.terms(names[2], cell)
                else:
                    yield cell, str(self.register(r))

    def sum(self, name: str, constant: str, terms: Iterable[tuple[str, str]]) -> str:
        """A sum of cells times registers, each register once."""
        factors: dict[str, str] = {}
        for cell, register in self.terms(terms):
            factors[register] = self.compute("add", factors.get(register, ZERO), cell)
        if constant == ZERO and [*factors.values()] == [ONE]:
            return next(iter(factors))
        return self.series.setdefault(("lin", constant, tuple(sorted((c, r) for r, c in factors.items()))), (name,))[0]


# Cells that the walk reads, by role: what drives and the size of its terms, what presses, and the weight's components.
OUTPUTS = {"cell_drive": "drive", "cell_drive_scale": "drive_scale", "cell_normal0": "normal_0", "cell_f0": "fall_0",
           "cell_p0": "press_0", "cell_ps0": "press_slope_0", "cell_driving": "driving_0",
           "cell_resisting": "resisting_0", "cell_mu": "mu_0"}  # fmt: skip
ROLES = ("net", "normal", "upright")  # registers that the walk reads
RESULTS = {"turn": 2, "exp": 2, "rec": 2, "pow": 2}


def _load(link: _Linker, name: str, sums: dict[str, list[Any]], friction: str = "mu") -> None:
    """Take a fragment's definitions; the quantity of a law may be one of two friction coefficients."""
    fragment = FRAGMENTS[name]
    link.cells |= {result: (op, *arguments) for op, result, *arguments in fragment.scalar}
    for op, *names in fragment.series:
        link.registers |= {str(result): (op, *names) for result in names[: RESULTS.get(str(op), 1)]}
    for quantity, added in fragment.adds.items():
        sums.setdefault(friction if quantity == "mu" else quantity, []).append(added)


@lru_cache(maxsize=256)
def join(
    effects: tuple[str, ...],
    laws: tuple[str, ...],
    moving: tuple[str, ...] = (),
    absent: tuple[str, ...] = (),
    asked: tuple[str, ...] = (),
) -> Program:
    """The program of a scene.

    Parameters
    ----------
    effects : tuple of str
        Names, as in `generated.effects.EFFECTS`.
    laws : tuple of str
        The friction law, as in `generated.effects.LAWS` or "callable", and the law of speed that multiplies it, if any.
    moving : tuple of str
        Symbols of parameters that are functions of time.
    absent : tuple of str
        Symbols of optional parameters that are not given, and left out.
    asked : tuple of str
        What else to compute: registers, such as ``mu``, ``pressing`` or ``friction``, and "energy", which stands for
        the states ``work`` and ``dissipation``.

    Returns
    -------
    Program
    """
    link, sums, tables = _Linker(), dict[str, list[Any]](), list[tuple[str, str, str, int]]()
    for name in ("gravity", *effects):
        _load(link, name, sums)
    for slot, name in enumerate(laws):
        _load(link, name, sums, "mu" if len(laws) == 1 else ("slip_mu", "rate_mu")[slot])
        if table := FRAGMENTS[name].table:
            tables.append((name, *table))
    if len(laws) > 1:
        _load(link, "product", sums)
    for name in ("balance", *(x for x in asked if x in FRAGMENTS)):
        _load(link, name, sums)
    for symbol in moving:
        link.cells[symbol] = ("set", f"{symbol}.VALUE")
        tables.append((symbol, "time", f"d{symbol}", 0))
    for name, kind, register, _ in tables:
        if kind == "time":
            link.registers[register] = ("ramp", register, name)
    link.cells |= dict.fromkeys(absent, ("set", ZERO))
    chosen = ("gravity", *effects, *laws, *(x for x in asked if x in FRAGMENTS))
    given = [*INPUTS, *(x for name in chosen for x in FRAGMENTS[name].inputs if x not in link.cells)]
    return _link(link, sums, chosen, given, tables, tuple(x for x in asked if x not in FRAGMENTS))


def _link(
    link: _Linker,
    sums: dict[str, list[Any]],
    chosen: Iterable[str],
    given: Iterable[str],
    tables: list[tuple[str, str, str, int]],
    asked: tuple[str, ...],
) -> Program:
    """Names to indices: from what is wanted back to what it takes."""
    for quantity in (*QUANTITIES, "mu", *(("slip_mu", "rate_mu") if "slip_mu" in sums else ())):
        for part, which in (("_0", 0), ("_size", 1)):
            total = ZERO
            for i, added in enumerate(sums.get(quantity, ())):
                link.cells[f"{quantity}{part}.{i}"] = ("add", total, added[which])
                total = f"{quantity}{part}.{i}"
            link.cells[f"{quantity}{part}"] = ("set", total)
        terms = tuple(term for added in sums.get(quantity, ()) for term in added[2])
        link.registers[f"d{quantity}"] = ("lin", f"d{quantity}", "", terms)
    rates = {"x": "omega", "omega": "net"} | {s: r for name in chosen for s, r in FRAGMENTS[name].states}
    table_cells = [f"{t}.{x}" for t, _, _, d in tables for x in (*TABLE_CELLS, *(f"Q{i + 1}" for i in range(d)))]
    fixed = [*dict.fromkeys((*CELLS, *rates, *given, *table_cells))]
    link.known |= {x: x for x in fixed}
    link.made |= {x: x for x in rates}
    roots = [*rates.values(), *(a for _, _, a, _ in tables), *ROLES, *asked]
    link.kept.update(roots)
    for name, (op, *names) in link.registers.items():
        if op != "lin" and not link.nothing(name):
            link.kept.update(link.arguments(op, names))
    made = {x: link.register(x) for x in roots}
    still = {d[0] for op, d in link.series.items() if op[0] == "lin" and not op[2]}  # as where the phase began
    made |= {x: None for x in ROLES[1:] if made[x] in still and x not in asked}
    made |= {x: link.series.setdefault(("lin", ZERO, ()), (x,))[0] for x in asked if made[x] is None}
    outputs = {role: link.cell(name) for role, name in OUTPUTS.items()}
    series = _needed(link.series.items(), {x for x in made.values() if x} | {*rates})
    lasting = {x for op, _ in series for x in ((op[1], *(c for c, _ in op[2])) if op[0] == "lin" else op[1:])}
    lasting |= {*outputs.values()}
    scalar = _needed(((op, (d,)) for op, d in link.scalar.items()), lasting)
    held = [*fixed, *(d for _, (d,) in scalar if d in lasting)]
    numbers = sorted({x for op, _ in scalar for x in op[1:] if x[0] == "="} | {x for x in lasting if x[0] == "="})
    place = _scratch(scalar, [*held, *numbers])
    cells = [*held, *numbers, *(f"scratch{i}" for i in range(max(place.values()) + 1 - len(held) - len(numbers)))]
    registers = [*rates, *(x for _, results in series for x in results)]
    at = {x: i for i, x in enumerate(registers)}
    order = {name: i for i, (name, *_) in enumerate(tables)}

    def indexed(op: Operation, results: tuple[str, ...]) -> tuple[Any, ...]:
        kind, *names = op
        made = [at[x] for x in results]
        if kind == "lin":
            terms = tuple((place[c], at[r]) for c, r in names[1])
            return (kind, *made, -1 if names[0] == ZERO else place[names[0]], terms)
        return (kind, *made, *(order[x] if kind == "ramp" else at[x] if x in at else place[x] for x in names))

    roles = {x: at[x] for x in ("x", "omega")} | {x: at.get(str(made[x]), -1) for x in (*ROLES, *asked)}
    return Program(
        cells=tuple(cells),
        lasting=len(held),
        registers=tuple(registers),
        scalar=tuple((op[0], place[d], *(place[x] for x in op[1:])) for op, (d,) in scalar),
        series=tuple(indexed(op, results) for op, results in series),
        states=tuple((place[s], at[s], at[str(made[rate])]) for s, rate in rates.items()),
        tables=tuple(Table(t, kind, at[str(made[a])], place[f"{t}.PIECE"], d) for t, kind, a, d in tables),
        roles=roles | {role: place[name] for role, name in outputs.items()},
        constants={x: float(x[1:]) for x in numbers},
    )


def _needed(operations: Iterable[tuple[Operation, tuple[str, ...]]], wanted: set[str]) -> list[Any]:
    """The operations that something needs, in order."""
    found, need = [], set(wanted)
    for op, results in reversed([*operations]):
        if need & {*results}:
            found.append((op, results))
            need |= {r for _, r in op[2]} if op[0] == "lin" else {*op[1:]}
    return found[::-1]


def _scratch(operations: list[Any], cells: list[str]) -> dict[str, int]:
    """Where each cell is: those that are listed in their place, the others share what is free."""
    place = {x: i for i, x in enumerate(cells)}
    last = {x: i for i, (op, _) in enumerate(operations) for x in op[1:]}
    free: list[int] = []
    more = len(cells)
    for i, (op, (d,)) in enumerate(operations):
        free += sorted({place[x] for x in op[1:] if last[x] == i and place[x] >= len(cells)}, reverse=True)
        if d not in place:
            place[d] = free.pop() if free else more
            more = max(more, place[d] + 1)
    return place
