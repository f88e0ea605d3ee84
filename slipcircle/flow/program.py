"""A scene's flow program, joined of the fragments in `generated.flow` that its effects and friction law call for.

Joining is linking: names become indices, what is nothing (a frozen mass does not turn, a constant does not change)
is left out with all that it is a factor of, equal operations are done once, and sums of sums become one.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

from generated.flow import CELLS, FRAGMENTS, QUANTITIES

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

    ``constants`` are the values of cells that are the same in all lanes; ``states`` are (cell, register, register of
    the rate).
    """

    cells: tuple[str, ...]
    registers: tuple[str, ...]
    scalar: tuple[tuple[Any, ...], ...]
    series: tuple[tuple[Any, ...], ...]
    states: tuple[tuple[int, int, int], ...]
    tables: tuple[Table, ...]
    roles: Mapping[str, int]
    constants: Mapping[str, float]


@dataclass
class _Linker:
    """Definitions by name, and what has become of them."""

    cells: dict[str, tuple[str, ...]] = field(default_factory=dict)
    registers: dict[str, tuple[Any, ...]] = field(default_factory=dict)
    kept: set[str] = field(default_factory=set)  # registers that more than sums are made of
    known: dict[str, str] = field(default_factory=dict)  # canonical cell by name
    made: dict[str, str | None] = field(default_factory=dict)  # canonical register by name; None is nothing
    scalar: dict[tuple[str, ...], str] = field(default_factory=dict)
    series: dict[tuple[Any, ...], tuple[str, ...]] = field(default_factory=dict)

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
            op, *names = self.registers.get(name, ("sum", "", "", ()))
            if op in ("sum", "lin"):
                absent = not names[1] and all(self.cell(c) == ZERO or self.nothing(r) for c, r in names[2])
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
                results, arguments = names[: RESULTS.get(op, 1)], [*map(self.register, self.arguments(op, names))]
                numbers = [self.cell(names[-1])] if op == "pow" else names[1:] if op == "ramp" else []
                made = self.series.setdefault((op, *(numbers if op == "ramp" else [*arguments, *numbers])), tuple(results))
                self.made[name] = made[results.index(name)]
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
    for op, result, *arguments in fragment.scalar:
        link.cells[result] = (op, *arguments)
    for op in fragment.series:
        for result in op[1 : 1 + RESULTS.get(str(op[0]), 1)]:
            link.registers[result] = op
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
        What else to compute: ``mu``.

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
    _load(link, "balance", sums)
    for symbol in moving:
        link.cells[symbol] = ("set", f"{symbol}.VALUE")
        tables.append((symbol, "time", f"d{symbol}", 0))
    for name, kind, register, _ in tables:
        if kind == "time":
            link.registers[register] = ("ramp", register, name)
    link.cells |= dict.fromkeys(absent, ("set", ZERO))
    chosen = ("gravity", *effects, *laws)
    given = ["level", "polar", *(x for name in chosen for x in FRAGMENTS[name].inputs if x not in link.cells)]
    return _link(link, sums, chosen, given, tables, asked)


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
                link.cells[f"{quantity}{part}{i}"] = ("add", total, added[which])
                total = f"{quantity}{part}{i}"
            link.cells[f"{quantity}{part}"] = ("set", total)
        terms = tuple(term for added in sums.get(quantity, ()) for term in added[2])
        link.registers[f"d{quantity}"] = ("lin", f"d{quantity}", "", terms)
    rates = {"x": "omega", "omega": "net"} | {s: r for name in chosen for s, r in FRAGMENTS[name].states}
    further = [s for s in rates if s not in ("x", "omega")]
    table_cells = {f"{t}.{c}": None for t, _, _, d in tables for c in (*TABLE_CELLS, *(f"Q{i + 1}" for i in range(d)))}
    fixed = dict.fromkeys((*CELLS, *further, *given, *table_cells))
    link.known |= {x: x for x in fixed}
    link.made |= {x: x for x in rates}
    roots = [*rates.values(), *(a for _, _, a, _ in tables), *ROLES, *asked]
    link.kept.update(roots)
    for name, (op, *names) in link.registers.items():
        if op != "lin" and not link.nothing(name):
            link.kept.update(link.arguments(op, names))
    made = {x: link.register(x) for x in roots}
    still = {d[0] for op, d in link.series.items() if op[0] == "lin" and not op[2]}  # as where the phase began
    wanted = {role: None if made[role] in still and role != "net" else made[role] for role in (*ROLES, *asked)}
    kept = [made[x] for x in roots if x not in wanted]
    outputs = {role: link.cell(role) for role in OUTPUTS.values()}
    # What nothing needs is left out, from the last operation back.
    need = {r for r in (*wanted.values(), *kept) if r} | set(rates)
    series = []
    for op, made in reversed(link.series.items()):
        if need & set(made):
            series.append((op, made))
            need |= {r for _, r in op[2]} if op[0] == "lin" else set(op[1:])
    series.reverse()
    used = {c for op, _ in series for c in ((op[1], *(c for c, _ in op[2])) if op[0] == "lin" else op[1:])}
    used |= set(outputs.values())
    scalar = []
    for op, name in reversed(link.scalar.items()):
        if name in used:
            scalar.append((op[0], name, *op[1:]))
            used |= set(op[1:])
    scalar.reverse()
    registers = [*rates, *(x for _, made in series for x in made)]
    numbers = sorted({x for op in scalar for x in op[1:] if x.startswith("=")} | {x for x in used if x.startswith("=")})
    cells = [*dict.fromkeys((*fixed, *(op[1] for op in scalar), *numbers))]
    c, r = ({x: i for i, x in enumerate(names)} for names in (cells, registers))
    places = {name: i for i, (name, *_) in enumerate(tables)}

    def indexed(op: tuple[Any, ...], made: tuple[str, ...]) -> tuple[Any, ...]:
        kind, *names = op
        at = [r[x] for x in made]
        if kind == "lin":
            return (kind, *at, -1 if names[0] == ZERO else c[names[0]], tuple((c[a], r[b]) for a, b in names[1]))
        return (kind, *at, *((places[names[0]],) if kind == "ramp" else (r[x] if x in r else c[x] for x in names)))

    roles = {x: r[x] for x in ("x", "omega")} | {role: r[name] if name else -1 for role, name in wanted.items()}
    return Program(
        cells=tuple(cells),
        registers=tuple(registers),
        scalar=tuple((op, *(c[x] for x in names)) for op, *names in scalar),
        series=tuple(indexed(op, made) for op, made in series),
        states=tuple((c[s], r[s], r[str(link.made[rate])]) for s, rate in rates.items()),
        tables=tuple(Table(t, kind, r[str(link.made[a])], c[f"{t}.PIECE"], d) for t, kind, a, d in tables),
        roles=roles | {role: c[outputs[name]] for role, name in OUTPUTS.items()},
        constants={x: float(x[1:]) for x in numbers},
    )
