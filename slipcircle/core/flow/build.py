"""From the fragments of a scene's effects and friction law to its flow program, in five passes.

1. `declare` collects the definitions of the fragments in `generated.flow`, and sums what they add to the balance.
2. `resolve` follows from what the integrator reads back to what it takes; what is zero is not computed.
3. `select` keeps the operations that are needed, in order.
4. `allocate` gives each cell its place.
5. `encode` writes the operations with places instead of names.

Names that fragments share: ``q_0`` is quantity q of the balance where a phase begins, ``q_size`` the size of its terms,
``dq`` its increment since; ``t.VALUE`` is a cell of table t.
"""

from collections.abc import Iterable
from functools import lru_cache
from typing import Any, NamedTuple

from generated.flow import FRAGMENTS, INPUTS, QUANTITIES
from generated.layout import CELLS, TABLE
from slipcircle.core.flow.fragments import fragment_of
from slipcircle.core.flow.link import ONE, PRIME, ZERO, Linker, Operation, named_in, needed, places_of, tangent
from slipcircle.core.flow.program import OUTPUT_CELLS, READ_REGISTERS, Program, Table, Tangent
from slipcircle.core.scene.friction import OF_SOIL, soil_number


class TableDeclaration(NamedTuple):
    """A piecewise function: its name, what it is of, the register of its argument, and the degree of its pieces."""

    name: str
    kind: str
    argument: str
    degree: int

    @property
    def coefficients(self) -> list[str]:
        """The cells of a piece's coefficients beyond its value."""
        return [f"{self.name}.Q{k}" for k in range(1, self.degree + 1)]

    @property
    def cells(self) -> list[str]:
        """All its cells, in order; Q1, the last of `TABLE`, is the first coefficient."""
        return [f"{self.name}.{cell}" for cell in TABLE[:-1]] + self.coefficients

    @property
    def varied(self) -> list[str]:
        """The cells whose tangents a program carries."""
        return [f"{self.name}.VALUE", *self.coefficients]


@lru_cache(maxsize=256)
def build_program(
    effects: tuple[str, ...],
    laws: tuple[str, ...],
    moving: tuple[str, ...] = (),
    absent: tuple[str, ...] = (),
    outputs: tuple[str, ...] = (),
    directions: int = 0,
) -> Program:
    """The program of a scene.

    Parameters
    ----------
    effects : tuple of str
        Names, as in `generated.effects.EFFECTS`.
    laws : tuple of str
        The friction law, as in `generated.effects.LAWS` or "callable", or the laws of soils, ``linear#0``; then the law
        of speed that multiplies it, if any.
    moving : tuple of str
        Symbols of parameters that are functions of time, or of the rotation.
    absent : tuple of str
        Symbols of optional parameters that are not given, and not included.
    outputs : tuple of str
        What else to compute: registers, such as ``mu``, ``pressing`` or ``friction``, and "energy", which stands for
        the states ``work`` and ``dissipation``.
    directions : int
        Number of derivatives that the program carries along: `Program.tangents`.

    Returns
    -------
    Program
    """
    fragments = tuple(name for name in outputs if name in FRAGMENTS)
    registers = tuple(name for name in outputs if name not in FRAGMENTS)
    builder = _Builder(registers, directions)
    builder.declare_laws(laws)
    builder.declare_effects(effects, moving, absent)
    builder.declare_functions_of_time(moving)
    builder.declare_balance(effects, laws, fragments, absent)
    builder.resolve()
    builder.select()
    builder.allocate()
    return builder.encode()


class _Builder:
    """A program on its way through the passes; each adds what the next ones take.

    Attributes
    ----------
    link : Linker
    inputs, tables, states : what the fragments declare: names of numbers that a scene gives, tables, and states with
        the registers of their rates, tangents included.
    varied, read : names of the cells and registers whose tangents the program carries.
    registers : the registers that serve what is read, by name; None where that is zero or does not change.
    outputs : the cells that serve `OUTPUT_CELLS`, by name.
    scalar, series : the operations that are needed, with their results.
    place : where each cell is.
    """

    def __init__(self, extra: tuple[str, ...], directions: int) -> None:
        self.extra, self.directions = extra, range(directions)
        self.link = Linker()
        self.inputs: list[str] = []
        self.tables: list[TableDeclaration] = []
        self.sums: dict[str, list[Any]] = {}  # what fragments add to each quantity: base, size, terms of its increment

    # --- 1. definitions ----------------------------------------------------------------------------------------------

    def declare_effects(self, effects: tuple[str, ...], moving: tuple[str, ...], absent: tuple[str, ...]) -> None:
        """Take the definitions of gravity and of effects, of a soil with those of what turns with the mass."""
        self._take("gravity")
        for effect in effects:
            self._take(effect, self.factors[0])
            for declared in fragment_of(effect).tables:
                self._effect_table(TableDeclaration(*declared), moving, absent)
            if number := soil_number(effect):
                for turned in ("gravity", *(e for e in effects if e == "rotation")):
                    self.link.define_cells(fragment_of(turned + number).scalar)

    def _effect_table(self, table: TableDeclaration, moving: tuple[str, ...], absent: tuple[str, ...]) -> None:
        """An effect's table where the scene gives a function; else a number that does not change, or none."""
        if table.name in moving:
            self.tables.append(table)
            return
        for name in table.coefficients:
            self.link.cell_definitions[name] = ("set", ZERO)
        if table.name not in absent:
            self.inputs.append(table.name)

    def declare_laws(self, laws: tuple[str, ...]) -> None:
        """Take the definitions of the friction law, or of two whose coefficients are factors of friction.

        The first factor may be a sum over soils.
        """
        of_soils = [law for law in laws if OF_SOIL in law]
        others = [law for law in laws if law not in of_soils]
        has_rate = len(others) > (0 if of_soils else 1)
        self.factors = ["slip_mu", "rate_mu"] if has_rate else ["mu"]
        quantities = [f"soil_mu{soil_number(law)}" for law in of_soils] + self.factors[-len(others) :]
        for law, quantity in zip((*of_soils, *others), quantities, strict=False):
            self._take(law, quantity)
            self.tables += [TableDeclaration(*declared) for declared in fragment_of(law).tables]
        if of_soils:
            self._take("soils")
        if has_rate:
            self._take("product")

    def declare_functions_of_time(self, moving: tuple[str, ...]) -> None:
        """Parameters that change with time: a value where the phase begins, and the increment since, a ramp."""
        known = {table.name for table in self.tables}
        for symbol in moving:
            self.link.cell_definitions[symbol] = ("set", f"{symbol}.VALUE")
            if symbol not in known:
                self.tables.append(TableDeclaration(symbol, "time", f"d{symbol}", 0))
        for table in self.tables:
            if table.kind == "time":
                self.link.series_definitions[table.argument] = ("ramp", table.argument, table.name)

    def declare_balance(
        self, effects: tuple[str, ...], laws: tuple[str, ...], extra: tuple[str, ...], absent: tuple[str, ...]
    ) -> None:
        """Take the balance, sum what fragments add to its quantities, and list what a scene has to give."""
        for name in ("balance", *extra):
            self._take(name)
        link = self.link
        not_shaken = () if "shaking" in effects else ("k_h", "k_v")
        for symbol in (*absent, *not_shaken):
            link.cell_definitions[symbol] = ("set", ZERO)
        for quantity in dict.fromkeys((*QUANTITIES, "mu", *self.sums)):
            self._sum(quantity)
        if self.factors == ["mu"]:  # what multiplies a law of speed is the whole of it
            link.cell_definitions["slip_mu_0"] = ("set", "mu_0")
            link.series_definitions["dslip_mu"] = ("lin", "dslip_mu", "", ((ONE, "dmu"),))
        self._collect_inputs(("gravity", *effects, *laws, *extra))

    def _collect_inputs(self, names: tuple[str, ...]) -> None:
        """The numbers that a scene has to give, and the states with their rates."""
        defined = self.link.cell_definitions
        self.inputs = [*INPUTS, *self.inputs]
        self.rates = {"x": "omega", "omega": "net"}
        for name in names:
            fragment = fragment_of(name)
            self.inputs += [symbol for symbol in fragment.inputs if symbol not in defined]
            self.rates.update(fragment.states)
        self.states = dict(self.rates)
        for j in self.directions:
            for state, rate in self.rates.items():
                self.states[tangent(state, j)] = tangent(rate, j)

    def _take(self, name: str, friction: str = "mu") -> None:
        """Take a fragment's definitions; the friction coefficient of a law may be a soil's, or one of two factors."""
        fragment = fragment_of(name)
        self.link.define_cells(fragment.scalar)
        self.link.define_series(fragment.series)
        for quantity, added in fragment.adds.items():
            summed = friction if quantity == "mu" else quantity
            self.sums.setdefault(summed, []).append(added)

    def _sum(self, quantity: str) -> None:
        """A quantity of the balance: its base, the size of its terms, and its increment."""
        bases = list[str]()
        sizes = list[str]()
        increment = list[Any]()
        for base, size, terms in self.sums.get(quantity, []):
            bases.append(base)
            sizes.append(size)
            increment += terms
        self._define_sum(f"{quantity}_0", bases)
        self._define_sum(f"{quantity}_size", sizes)
        register = f"d{quantity}"
        self.link.series_definitions[register] = ("lin", register, "", tuple(increment))

    def _define_sum(self, name: str, addends: list[str]) -> None:
        """A cell that is a sum of others."""
        definitions = self.link.cell_definitions
        total = ZERO
        for k, addend in enumerate(addends):
            part = f"{name}.{k}"
            definitions[part] = ("add", total, addend)
            total = part
        definitions[name] = ("set", total)

    # --- 2. what is read, back to what it takes ----------------------------------------------------------------------

    def resolve(self) -> None:
        """The registers and cells that serve what the integrator reads."""
        self._fix_cells()
        link = self.link
        self.read = [*self.rates, *self.rates.values(), *READ_REGISTERS]
        self.read += [table.argument for table in self.tables]
        roots = dict.fromkeys([*self.read, *self.extra, *self._in_directions(self.read)])
        link.mark_shared(roots)
        self.registers = {name: link.register(name) for name in roots}
        self._drop_constants()
        for name in (*self.states.values(), *self.extra):
            if self.registers[name] is None:
                self.registers[name] = link.zero_register(name)
        names = [*OUTPUT_CELLS.values(), *self._in_directions(["drive"])]
        self.outputs = {name: link.cell(name) for name in names}

    def _fix_cells(self) -> None:
        """The cells that a lane begins with, in their order, and what follows from them alone."""
        link, table_cells = self.link, list[str]()
        self.varied = [*self.rates, "ROTATION", "SLIP", *self.inputs]
        for table in self.tables:
            table_cells += table.cells
            self.varied += table.varied
        tangents = self._in_directions(self.varied)
        self.fixed = list(dict.fromkeys((*CELLS, *self.rates, *self.inputs, *table_cells, *tangents)))
        for name in self.fixed:
            link.cells[name] = name
        for name in self.states:
            link.registers[name] = name
        for j in self.directions:
            link.cell_definitions[tangent("LIMIT", j)] = ("set", tangent("limit_0", j))
        link.cell_definitions["departed"] = self._departed({*self.states, *table_cells})

    def _in_directions(self, names: Iterable[str]) -> list[str]:
        """The tangents of names, direction by direction."""
        names = list(names)
        return [tangent(name, j) for j in self.directions for name in names]

    def _departed(self, moving: set[str]) -> Operation:
        """What is zero as long as the limit friction is that of the start: whatever it depends on has not changed."""
        origins = self.link.origins(("driving_0", "resisting_0", "normal_0"))
        if origins & moving:
            return ("set", "TIME")
        if "SLIP" in origins:
            return ("set", "SLIP")
        return ("abs", "ROTATION") if "ROTATION" in origins else ("set", ZERO)

    def _drop_constants(self) -> None:
        """What presses or tips the mass is no event where it stays as it was where the phase began."""
        constant = set[str]()
        for (kind, *taken), results in self.link.series.items():
            if kind == "lin" and not taken[-1]:
                constant.update(results)
        for name in READ_REGISTERS[1:]:
            if self.registers[name] in constant and name not in self.extra:
                self.registers[name] = None

    # --- 3. the operations that are needed ---------------------------------------------------------------------------

    def select(self) -> None:
        """Those on series that serve what is read, and those on cells that serve them."""
        read = {register for register in self.registers.values() if register}
        self.series = needed(self.link.series.items(), read | {*self.states})
        self.lasting = {*self.outputs.values()}
        for operation, _ in self.series:
            self.lasting |= named_in(operation)
        scalar = [(operation, (result,)) for operation, result in self.link.scalar.items()]
        self.scalar = needed(scalar, self.lasting)

    # --- 4. places ---------------------------------------------------------------------------------------------------

    def allocate(self) -> None:
        """A place for each cell: those that last, constants, and scratch that is used again when it is free."""
        made = [result for _, (result,) in self.scalar if result in self.lasting]
        used = self.lasting.union(*(operation[1:] for operation, _ in self.scalar))
        self.constants = sorted(name for name in used if name.startswith("="))
        self.held = [*self.fixed, *made]
        kept = [*self.held, *self.constants]
        self.place = places_of(self.scalar, kept)
        scratch = range(max(self.place.values()) + 1 - len(kept))
        self.cells = (*kept, *(f"scratch{k}" for k in scratch))

    # --- 5. names to places ------------------------------------------------------------------------------------------

    def encode(self) -> Program:
        """The program, in places of cells and registers."""
        made = [register for _, results in self.series for register in results]
        names = (*self.states, *made)
        self.at = {name: k for k, name in enumerate(names)}
        self.operand = self.place | self.at
        return Program(
            cells=self.cells,
            given=len(self.fixed),
            lasting=len(self.held),
            registers=names,
            scalar=tuple(self._encoded_scalar(operation, result) for operation, (result,) in self.scalar),
            series=tuple(self._encoded(operation, results) for operation, results in self.series),
            states=tuple((self.place[s], self.at[s], self._register(rate)) for s, rate in self.states.items()),
            tables=tuple(map(self._table, self.tables)),
            roles=self._roles(),
            constants={name: float(name[1:]) for name in self.constants},
            tangents=tuple(map(self._tangent, self.directions)),
        )

    def _table(self, table: TableDeclaration) -> Table:
        """A table with the places of its argument and of its first cell."""
        first_cell = self.place[f"{table.name}.PIECE"]
        return Table(table.name, table.kind, self._register(table.argument), first_cell, table.degree)

    def _roles(self) -> dict[str, int]:
        """The places of the registers and cells that the integrator reads."""
        roles = {name: self._register(name) for name in ("x", "omega", *READ_REGISTERS, *self.extra)}
        for role, name in OUTPUT_CELLS.items():
            roles[role] = self.place[self.outputs[name]]
        return roles

    def _encoded_scalar(self, operation: Operation, result: str) -> tuple[Any, ...]:
        """An operation on cells: its result, then its arguments."""
        kind, *taken = operation
        return (kind, self.place[result], *(self.place[name] for name in taken))

    def _register(self, name: str) -> int:
        """The place of the register that serves a name; -1 where there is none."""
        return self.at.get(str(self.registers.get(name, name)), -1)

    def _encoded(self, operation: Operation, results: tuple[str, ...]) -> tuple[Any, ...]:
        """An operation on series: its results first, then registers, cells or a table."""
        kind, *taken = operation
        made = [self.at[register] for register in results]
        if kind == "lin":
            constant, terms = taken
            start = -1 if constant == ZERO else self.place[constant]
            encoded_terms = tuple((self.place[cell], self.at[register]) for cell, register in terms)
            return (kind, *made, start, encoded_terms)
        if kind == "ramp":
            argument = taken[0].partition(PRIME)[0]
            arguments = [table.argument for table in self.tables]
            return (kind, *made, arguments.index(argument))
        return (kind, *made, *(self.operand[name] for name in taken))

    def _tangent(self, direction: int) -> Tangent:
        """Where the tangents of what varies and of what is read are."""
        place = self.place
        drive = self.outputs["drive"]
        drive_dot = self.outputs[tangent("drive", direction)]
        cells = {place[name]: place[tangent(name, direction)] for name in self.varied}
        cells[place[drive]] = place[drive_dot]
        registers = dict[int, int]()
        for name in self.read:
            register = self._register(name)
            derivative = self._register(tangent(name, direction))
            if register >= 0 and derivative >= 0:
                registers[register] = derivative
        return Tangent(cells, registers)
