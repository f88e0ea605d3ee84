# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 7b2581505ab69cc617480f28536a3f67c395523c678545f310541bfa0186a8f4
"""Linker of programs of scenes from the fragments of their effects and laws."""

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import chain, product
from typing import Any, NamedTuple, Self

from generated.flow import INPUTS, QUANTITIES, Fragment, OnSeries
from generated.layout import CELLS, KINDS, ROLES, STRIDE, TABLE
from generated.series import SCALAR, SERIES

Names = tuple[str, ...]
OnCells = tuple[str, ...]  # kind of an operation on cells, and its arguments
ZERO, ONE = "=0.0", "=1.0"
OF_SOIL = "#"  # before the number of a soil, in the names of its laws, effects, cells and registers
OF_COHESION = "#c"  # before the number of a soil whose cohesion changes with slip
Lookup = Callable[[str, bool], Sequence[Fragment]]  # fragments of an effect or a law, and whether the mass turns


class Recipe(NamedTuple):
    """Input of the linker: effects and laws by name, as in `generated.effects`, and kinds of parameters.

    Attributes
    ----------
    effects : tuple of str
    laws : tuple of str
        The friction law, "callable", or the laws of soils, ``linear#0``, followed by the law of speed that multiplies
        it, and the laws of cohesion, ``linear#c``.
    moving : tuple of str
        Symbols of parameters that are functions of time, or of the rotation.
    absent : tuple of str
        Symbols of optional parameters that a scene omits; their terms are not included.
    """

    effects: Names
    laws: Names
    moving: Names = ()
    absent: Names = ()

    @property
    def of_friction(self) -> Names:
        """Laws without the laws of cohesion."""
        return tuple(law for law in self.laws if OF_COHESION not in law)


class DeclaredTable(NamedTuple):
    """Piecewise function: its name, its variable, the register of its argument, and the degree of its pieces."""

    name: str
    kind: str
    argument: str
    degree: int

    @property
    def coefficients(self) -> list[str]:
        """Cells of a piece's coefficients other than its value."""
        return [f"{self.name}.Q{k + 1}" for k in range(self.degree)]

    @property
    def cells(self) -> list[str]:
        """Cells of the table in order. Q1, the last of `TABLE`, is the first coefficient."""
        *before, _ = TABLE
        return [*(f"{self.name}.{cell}" for cell in before), *self.coefficients]


@dataclass
class Definitions:
    """Definitions by name. Cells are numbers at the beginning of a phase, registers series in time since then.

    Attributes
    ----------
    cells, series : dict
        Operations that compute each cell, and each register.
    inputs : list of str
        Cells that are set from a scene.
    states : dict of str
        Registers of the states, with the registers of their rates.
    tables : list of DeclaredTable
    addends : dict of list
        Addends of each quantity of the balance: base, size, and terms of the increment.
    """

    cells: dict[str, OnCells] = field(default_factory=dict)
    series: dict[str, OnSeries] = field(default_factory=dict)
    inputs: list[str] = field(default_factory=lambda: list(INPUTS))
    states: dict[str, str] = field(default_factory=lambda: {"x": "omega", "omega": "net"})
    tables: list[DeclaredTable] = field(default_factory=list)
    addends: dict[str, list[Any]] = field(default_factory=dict)

    @property
    def variables(self) -> Names:
        """Registers of states, and of the functions of time, which the integrator reads off tables."""
        return (*self.states, *(table.argument for table in self.tables if table.kind == "time"))

    @property
    def moving(self) -> list[str]:
        """Cells that change from phase to phase, of states and of the pieces of tables."""
        return [*self.states, *(cell for table in self.tables for cell in table.cells)]


def definitions_of(recipe: Recipe, fragments: Lookup, further: Names = ()) -> Definitions:
    """Return the definitions of a recipe's effects and laws, and of ``further`` fragments.

    ``fragments`` returns the fragments of a name; ``further`` are names, such as energy.
    """
    effects, _, moving, absent = recipe
    made = Definitions()
    slip_factor = _include_laws(made, recipe, fragments)
    for part in ("gravity", *effects, "balance", *further):
        for fragment in fragments(part, "rotation" in effects):
            _include(made, fragment, moving, slip_factor)
    follows_time = moving or "viscosity" in effects  # implicit steps are in time
    varies = follows_time or len(made.states) > 2
    alone = len(recipe.laws) == 1
    if alone and "per_speed" in made.cells and not varies:
        (of_pace,) = fragments("pace", False)
        _include(made, of_pace)
    _define_functions_of_time(made, moving)
    not_shaken = () if "shaking" in effects else ("k_h", "k_v")  # symbols in the terms of other effects
    made.cells |= dict.fromkeys((*absent, *not_shaken), ("set", ZERO))
    for quantity in dict.fromkeys((*QUANTITIES, "mu", *made.addends)):
        _define_quantity(made, quantity)
    if slip_factor == "mu":  # without a law of speed the coefficient itself depends on slip
        made.cells["slip_mu_0"] = ("set", "mu_0")
        made.series["dslip_mu"] = OnSeries("lin", ("dslip_mu",), ("dmu",), (ZERO, ONE))
    given = dict.fromkeys(made.inputs)
    made.inputs = [name for name in given if name not in made.cells]
    made.cells["departed"] = _departed(made)
    return made


def _include_laws(made: Definitions, recipe: Recipe, fragments: Lookup) -> str:
    """Include all laws, and return the name of the quantity to which laws of slip add.

    This quantity is the friction coefficient, or with a law of speed one of its two factors. It may be a sum over
    soils.
    """
    of_soils = [law for law in recipe.of_friction if OF_SOIL in law]
    shared = [law for law in recipe.of_friction if law not in of_soils]
    factors = ["mu"]
    if len(shared) > (0 if of_soils else 1):
        factors = ["slip_mu", "rate_mu"]
        _include(made, fragments("product", False)[0])
    if of_soils:
        _include(made, fragments("soils", False)[0])
    for law in recipe.laws:  # laws of soils and of cohesion add to separate quantities
        quantity = factors[-1] if law in shared[-1:] else factors[0]
        for fragment in fragments(law, False):
            tables = [name for name, *_ in fragment.tables]
            _include(made, fragment, tables, quantity)
    return factors[0]


def _include(made: Definitions, fragment: Fragment, moving: Collection[str] = (), friction: str = "mu") -> None:
    """Include a fragment's definitions in ``made``.

    ``moving`` are the tables that are functions, not single numbers, and ``friction`` is the quantity to which the
    fragment adds a friction coefficient.
    """
    for kind, result, *arguments in fragment.scalar:
        made.cells[result] = (kind, *arguments)
    for row in fragment.series:
        operation = OnSeries(*row)
        made.series |= dict.fromkeys(operation.results, operation)
    for quantity, added in fragment.adds.items():
        name = friction if quantity == "mu" else quantity
        made.addends.setdefault(name, []).append(added)
    made.inputs += fragment.inputs
    made.states.update(fragment.states)
    for declared in fragment.tables:
        table = DeclaredTable(*declared)
        if table.name in moving:
            made.tables.append(table)
        else:  # a number instead of a function, or absent
            made.inputs.append(table.name)
            made.cells |= dict.fromkeys(table.coefficients, ("set", ZERO))


def _define_functions_of_time(made: Definitions, moving: Names) -> None:
    """Define each parameter in ``moving``, which changes with time, by its initial value and its table."""
    known = [table.name for table in made.tables]
    for symbol in moving:
        made.cells[symbol] = ("set", f"{symbol}.VALUE")
        if symbol not in known:
            made.tables.append(DeclaredTable(symbol, "time", f"d{symbol}", 0))


def _define_quantity(made: Definitions, quantity: str) -> None:
    """Define a quantity q as sums over fragments: the cells ``q_0`` and ``q_size``, and the register ``dq``."""
    addends = made.addends.get(quantity, [])
    _define_sum(made, f"{quantity}_0", [base for base, _, _ in addends])
    _define_sum(made, f"{quantity}_size", [size for _, size, _ in addends])
    terms = [term for _, _, increment in addends for term in increment]
    factors = [factor for factor, _ in terms]
    registers = tuple(register for _, register in terms)
    name = f"d{quantity}"
    made.series[name] = OnSeries("lin", (name,), registers, (ZERO, *factors))


def _define_sum(made: Definitions, name: str, addends: list[str]) -> None:
    """Define the cell ``name`` as the sum of the cells ``addends``, added in order."""
    total = ZERO
    for k, addend in enumerate(addends):
        part = f"{name}.{k}"
        made.cells[part] = ("add", total, addend)
        total = part
    made.cells[name] = ("set", total)


def _departed(made: Definitions) -> OnCells:
    """Return the definition of a cell that is zero while the arguments of the limit friction have their initial values.

    The cell is the time, the slip or the rotation, whichever suffices.
    """
    taken = dict.fromkeys(("driving_0", "resisting_0", "normal_0"))
    pending = list(taken)
    while pending:
        _, *arguments = made.cells.get(pending.pop(), ("set",))
        pending += [name for name in arguments if name not in taken]
        taken |= dict.fromkeys(arguments)
    if not taken.keys().isdisjoint(made.moving):
        return ("set", "TIME")
    if "SLIP" in taken:
        return ("set", "SLIP")
    return ("abs", "ROTATION") if "ROTATION" in taken else ("set", ZERO)


EVENTS = ("normal", "upright")  # registers whose roots are lift-off, and an upright chord
# Cells that the integrator reads, by role: drive, size of its terms, normal force, components of the weight.
OUTPUT_CELLS = {
    "cell_drive": "drive",
    "cell_drive_scale": "drive_scale",
    "cell_normal0": "normal_0",
    "cell_driving_moment": "driving_moment_0",
    "cell_normal_load": "normal_load_0",
    "cell_normal_load_slope": "normal_load_slope_0",
    "cell_driving_moment_slope": "driving_moment_slope_0",
    "cell_driving": "driving_0",
    "cell_resisting": "resisting_0",
    "cell_mu": "mu_0",
    "cell_limit": "limit",
    "cell_pace": "pace",
}
# Sums of which phases have a closed form, with the roles of their constants, and registers by their names in roles.
CONSTANTS = {"net": "cell_drive", "normal": "cell_normal0", "upright": "cell_normal_load"}
FACTORS = {"sin(x)": "sine", "vers(x)": "vers", "omega*omega": "square"}


class Linked(NamedTuple):
    """Operations of a program in order, with their results, and the names of the required registers and cells."""

    scalar: list[tuple[OnCells, str]]
    series: list[OnSeries]
    registers: Mapping[str, str | None]  # required registers by name; None for an event that never happens
    outputs: Mapping[str, str]  # cells by role
    constants: list[str]


def link(definitions: Definitions, given: Iterable[str], asked: Names) -> Linked:
    """Return the operations that compute the integrator's input, and the registers ``asked``, from given cells."""
    arguments = [table.argument for table in definitions.tables]
    read = dict.fromkeys((*definitions.states, *definitions.states.values(), *EVENTS, *arguments, *asked))
    linker = Linker(definitions, given)
    linker.mark_shared(read)
    registers = {name: linker.register(name) for name in read}
    for name in registers:
        if name in EVENTS and name not in asked:
            registers[name] = linker.event(registers[name])
        elif registers[name] is None:  # the integrator reads it, although it is zero
            registers[name] = linker.zero(name)
    outputs = {role: linker.cell(name) for role, name in OUTPUT_CELLS.items() if name in definitions.cells}
    parts = linker.parts()
    if len(definitions.states) == 2 and len(parts) == len(definitions.tables):
        outputs |= linker.closed_form(registers, outputs, parts)
    pending = {*definitions.states, *registers.values(), *outputs.values()}
    scalar, series = linker.needed(pending)
    constants = sorted(name for name in pending if name and name.startswith("="))
    return Linked(scalar, series, registers, outputs, constants)


def squares_omega(operation: OnSeries) -> bool:
    """Return whether an operation squares omega. It precedes all others."""
    return operation.kind == "sqr" and operation.registers == ("omega",)


class Linker:
    """Collector of the operations that compute cells and registers.

    Attributes
    ----------
    scalar : dict
        Names of the results of operations on cells.
    series : dict
        Operations on series, by the same without results.
    """

    def __init__(self, definitions: Definitions, given: Iterable[str]) -> None:
        self.scalar: dict[OnCells, str] = {}
        self.series: dict[OnSeries, OnSeries] = {}
        self._definitions = definitions
        self._shared: set[str] = set()  # registers used by operations other than sums
        # Names under which cells and registers are computed; None for a register that is zero.
        self._cells = {name: name for name in given}
        self._registers: dict[str, str | None] = {name: name for name in definitions.variables}

    def needed(self, pending: set[str | None]) -> tuple[list[tuple[OnCells, str]], list[OnSeries]]:
        """Return the operations on which pending results depend, in order. Their operands become pending, too."""
        series = list[OnSeries]()
        for operation in reversed(self.series.values()):
            if not pending.isdisjoint(operation.results):
                series.insert(0, operation)
                pending.update(operation.registers, operation.cells)
        scalar = list[tuple[OnCells, str]]()
        for on_cells, result in reversed(self.scalar.items()):
            if result in pending:
                scalar.insert(0, (on_cells, result))
                pending.update(on_cells[1:])
        return scalar, series

    # --- cells -------------------------------------------------------------------------------------------------------

    def cell(self, name: str) -> str:
        """Return the name of the cell that contains the number ``name``, after adding operations that compute it."""
        if name.startswith("="):
            return name
        if name not in self._cells:
            kind, *arguments = self._definitions.cells[name]
            operands = [self.cell(argument) for argument in arguments]
            self._cells[name] = self._result(kind, operands, name)
        return self._cells[name]

    def _result(self, kind: str, operands: list[str], name: str = "") -> str:
        """Return the cell of an operation's result: an operand, an existing cell, or a new cell called ``name``."""
        known = _simplified(kind, operands)
        if known is not None:
            return known
        number = len(self.scalar)
        return self.scalar.setdefault((kind, *operands), name or f"cell{number}")

    # --- registers ---------------------------------------------------------------------------------------------------

    def _definition(self, name: str) -> OnSeries:
        """Return the definition of a register. Without a definition it is an empty sum."""
        return self._definitions.series.get(name, OnSeries("lin", (name,), (), (ZERO,)))

    def _computed(self, operation: OnSeries) -> Names:
        """Return the results of an operation on series, or of an equal one that exists."""
        return self.series.setdefault(operation._replace(results=()), operation).results

    def mark_shared(self, read: Iterable[str]) -> None:
        """Mark registers that are read, or used by operations other than sums. Sums among them are not flattened."""
        pending = list(read)
        self._shared.update(pending)
        seen = set(self._registers)
        while pending:
            name = pending.pop()
            if name in seen or self._is_zero(name):
                continue
            seen.add(name)
            operation = self._definition(name)
            pending += operation.registers
            if operation.kind != "lin":
                self._shared.update(operation.registers)

    def _is_zero(self, name: str) -> bool:
        """Return whether a register is identically zero, an operation on zero or a sum of zeros."""
        if name in self._registers:
            return self._registers[name] is None
        kind, _, registers, cells = self._definition(name)
        if kind == "lin":
            constant, *factors = cells
            terms = zip(factors, registers, strict=True)
            zero = all(self.cell(cell) == ZERO or self._is_zero(register) for cell, register in terms)
            zero = zero and self.cell(constant) == ZERO
        else:
            zero = any(map(self._is_zero, registers))
        if zero:
            self._registers[name] = None
        return zero

    def register(self, name: str) -> str | None:
        """Return the register for a name, computed if necessary, or None if it is zero."""
        if not self._is_zero(name) and name not in self._registers:
            operation = self._definition(name)
            if operation.kind == "lin":
                self._registers[name] = self._sum(name, operation)
            else:
                registers = tuple(str(self.register(operand)) for operand in operation.registers)
                results = self._computed(operation._replace(registers=registers))
                self._registers[name] = results[operation.results.index(name)]
        return self._registers[name]

    def event(self, register: str | None) -> str | None:
        """Return a register whose roots are events, or None if it is None or constant during a phase."""
        operation = self._made_by(str(register))
        return None if operation.kind == "lin" and not operation.registers else register

    def parts(self) -> dict[str, str]:
        """Return the registers that follow tables in sums with a closed form, with their names in roles.

        They are the register that a table of slip adds to friction, and the only function of time.
        """
        register = str(self.register("dmu"))
        cells = {*self._made_by(register).cells[1:]}
        tables = self._definitions.tables
        of_slip = [{*table.coefficients} for table in tables if table.kind == "slip"]
        of_time = [table.argument for table in tables if table.kind == "time"]
        losses = {register: "loss"} if cells in of_slip else {}
        return losses | (dict.fromkeys(of_time, "record") if len(of_time) == 1 else {})

    def closed_form(
        self, registers: Mapping[str, str | None], outputs: dict[str, str], parts: dict[str, str]
    ) -> dict[str, str]:
        """Return the factors of sin(x), 1 - cos(x) and omega^2 in net moment, normal force and dip by role, if any.

        The net moment may also contain exp(a x) - 1, 1/(1 + a x) - 1, or a register in ``parts``, called loss, and its
        products with these, or one called record and its products with sin(x) and 1 - cos(x). There are no factors if
        other registers or products occur in these sums, or no sine.
        """
        cells = dict[str, str]()
        names = FACTORS | parts
        for operation in self.series.values():
            if operation.kind in ("exp", "rec"):
                argument = self._made_by(operation.registers[-1])
                if argument.registers == ("x",) and not cells:
                    names[operation.results[1]] = "loss"
                    rate = argument.cells[1]
                    cells["cell_loss_rate"] = rate
                    if operation.kind == "rec":
                        cells = {"cell_loss_rate": self._result("neg", [rate]), "cell_per_pole": rate}
        for name, constant in CONSTANTS.items():
            factors = {role: ZERO for role in ROLES if role.startswith(f"cell_{name}")}
            for each, cell in self._products(str(registers[name]), names):
                role = "_".join(("cell", name, *sorted(names.get(x, x) for x in each)))
                factors[role] = self._result("add", [factors.get(role, ZERO), cell])
            start = factors.pop(f"cell_{name}", ZERO)
            if start != outputs[constant] or factors[f"cell_{name}_sine"] == ZERO or factors.keys() - {*ROLES}:
                return {}
            cells = factors | cells | outputs
        return cells

    def _made_by(self, register: str) -> OnSeries:
        """Return the operation that computes a register. The operation of a state has no operands."""
        operations = self.series.values()
        return next((made for made in operations if register in made.results), OnSeries("", (), ()))

    def _products(self, register: str, units: Mapping[str, str]) -> Iterator[tuple[Names, str]]:
        """Yield a register as a sum of products of other registers, each with the cell of its factor.

        Sums among ``units`` are not expanded.
        """
        operation = self._made_by(register)
        match operation.kind:
            case "lin" if register not in units:
                yield (), operation.cells[0]
                for operand, cell in zip(operation.registers, operation.cells[1:], strict=True):
                    for names, factor in self._products(operand, units):
                        yield names, self._result("mul", [cell, factor])
            case "mul":
                one, other = operation.registers
                for (a, x), (b, y) in product(self._products(one, units), self._products(other, units)):
                    yield a + b, self._result("mul", [x, y])
            case _:
                yield (register,), ONE

    def zero(self, name: str) -> str:
        """Return a register that contains zero; it is called ``name`` if there is none yet."""
        (zero,) = self._computed(OnSeries("lin", (name,), (), (ZERO,)))
        return str(zero)

    def _sum(self, name: str, operation: OnSeries) -> str:
        """Return the register of a sum, in which each register occurs once."""
        start = self.cell(operation.cells[0])
        factors: dict[str, str] = {}
        for cell, register in self._flat(operation, ONE):
            before = factors.get(register, ZERO)
            factors[register] = self._result("add", [before, cell])
        if start == ZERO and list(factors.values()) == [ONE]:
            (register,) = factors
            return register
        in_order = sorted(factors)  # sums with permuted terms are equal
        cells = (start, *(factors[register] for register in in_order))
        (result,) = self._computed(OnSeries("lin", (name,), tuple(in_order), cells))
        return str(result)

    def _flat(self, operation: OnSeries, factor: str) -> Iterator[tuple[str, str]]:
        """Yield the nonzero terms of a sum as pairs (factor, register), each times the cell ``factor``.

        A sum used only by sums is replaced by its terms.
        """
        for cell, register in zip(operation.cells[1:], operation.registers, strict=True):
            scaled = self._result("mul", [factor, self.cell(cell)])
            if scaled == ZERO or self._is_zero(register):
                continue
            inner = self._definition(register)
            kept = register in self._shared or register in self._registers
            if inner.kind == "lin" and inner.cells[0] == ZERO and not kept:  # a constant is not a term
                yield from self._flat(inner, scaled)
            else:
                yield scaled, str(self.register(register))


def _simplified(kind: str, operands: list[str]) -> str | None:
    """Return the cell that equals the result of an operation on these operands, or None if it must be computed."""
    first, last = operands[0], operands[-1]
    match kind:
        case "set":
            return first
        case "add" if ZERO in operands:
            return last if first == ZERO else first
        case "sub" if last == ZERO:
            return first
        case "mul" if ZERO in operands:
            return ZERO
        case "mul" if ONE in operands:
            return last if first == ONE else first
        case "sub" | "less" if first == last:
            return ZERO
        case "div" | "neg" | "abs" if first == ZERO:
            return ZERO
        case "div" if last == ONE:
            return first
        case "select" if first == ZERO:
            return last
        case "select" if operands[1] == last == ZERO:
            return ZERO
    return None


# Functions of slip whose series converge no farther in the rotation than in time, and other arguments of tables.
SHORT = {"exp", "rec", "log", "time", "speed"}


class Table(NamedTuple):
    """Piecewise function in a program.

    ``kind`` is its variable, ``register`` contains its argument (for functions of time its increment), ``cells`` is the
    first of its cells, and ``degree`` the degree of its pieces.
    """

    name: str
    kind: str
    register: int
    cells: int
    degree: int


@dataclass(frozen=True, eq=False)
class Program:
    """Operations on the cells and the registers of a lane by place, and the places that the integrator reads.

    The first ``given`` cells are set at the start of a lane, the following cells are computed at the beginning of a
    phase, and ``constants`` by name are the last. ``states`` are (cell, register, register of the rate). Between breaks
    in time d(omega)/dt depends on time alone if ``autonomous`` is 2, also on omega if it is 1, and on further registers
    if it is 0. Unless ``by_rotation`` is 0, forces depend on the rotation and on omega^2 only, and series may be in
    powers of the rotation, with E = omega^2 in place of omega. If it is 2, the first operation squares omega.
    """

    cells: Names
    given: int
    registers: Names
    scalar: tuple[tuple[Any, ...], ...]
    series: tuple[OnSeries, ...]
    states: tuple[tuple[int, int, int], ...]
    tables: tuple[Table, ...]
    roles: Mapping[str, int]
    autonomous: int
    by_rotation: int
    constants: Mapping[str, float]

    @cached_property
    def places(self) -> Mapping[str, int]:
        """Places of the cells by name."""
        return {name: k for k, name in enumerate(self.cells)}

    @cached_property
    def split(self) -> tuple[list[OnSeries], list[OnSeries]]:
        """Operations on which rates depend, and those that can wait until states are complete."""
        needed = {rate for _, _, rate in self.states} | {self.roles.get("square", -1)}
        rates = list[OnSeries]()
        others = list[OnSeries]()
        for operation in reversed(self.series):
            if needed.isdisjoint(operation.results):
                others.insert(0, operation)
            else:
                needed.update(operation.registers)
                rates.insert(0, operation)
        return rates, others


def build(recipe: Recipe, fragments: Lookup, outputs: Names = (), further: Names = ()) -> Program:
    """Return the program of a recipe and of ``further`` fragments, with roles for the registers ``outputs``."""
    definitions = definitions_of(recipe, fragments, further)
    given = tuple(dict.fromkeys((*CELLS, *definitions.inputs, *definitions.moving)))  # x and omega are in both
    linked = link(definitions, given, outputs)
    return _encoded(definitions, linked, given, outputs)


class _Places(NamedTuple):
    """Places of a program's cells and registers by name."""

    cells: dict[str, int]
    registers: dict[str, int]

    @classmethod
    def of(cls, definitions: Definitions, linked: Linked, given: Names) -> Self:
        """Return numbers for cells (given, computed, constant) and registers (of variables, computed)."""
        computed = [result for _, result in linked.scalar]
        made = chain.from_iterable(operation.results for operation in linked.series)
        every = [*given, *computed, *linked.constants], [*definitions.variables, *made]
        return cls(*({name: place for place, name in enumerate(names)} for names in every))


def _encoded(definitions: Definitions, linked: Linked, given: Names, outputs: Names) -> Program:
    """Return a program with places instead of names, with roles for the registers ``outputs``."""
    places = _Places.of(definitions, linked, given)
    cells = places.cells
    registers = places.registers
    read = {name: registers.get(str(register), -1) for name, register in linked.registers.items()}
    roles = {name: read[name] for name in ("x", "omega", "net", *EVENTS, *outputs)}
    roles |= _roles(linked, places)
    tables = []
    for table in definitions.tables:
        name, kind, argument, degree = table
        tables.append(Table(name, kind, read[argument], cells[table.cells[0]], degree))
    scalar = []
    for (kind, *arguments), result in linked.scalar:
        operands = [cells[argument] for argument in arguments]
        scalar.append((kind, cells[result], *operands))
    states = []
    for state, rate in definitions.states.items():
        states.append((cells[state], registers[state], read[rate]))
    autonomous, by_rotation = _variables(definitions, linked)
    return Program(
        cells=tuple(cells),
        given=len(given),
        registers=tuple(registers),
        scalar=tuple(scalar),
        series=_in_order(linked, places),
        states=tuple(states),
        tables=tuple(tables),
        roles=roles,
        autonomous=autonomous,
        by_rotation=by_rotation,
        constants={name: float(name[1:]) for name in linked.constants},
    )


def _roles(linked: Linked, places: _Places) -> dict[str, int]:
    """Return the places of cells that have roles, and of the square of omega."""
    roles = {}
    for role, name in linked.outputs.items():
        roles[role] = places.cells[name]
    for operation in linked.series:
        if squares_omega(operation):
            roles["square"] = places.registers[operation.results[0]]
    return roles


def _in_order(linked: Linked, places: _Places) -> tuple[OnSeries, ...]:
    """Return the operations on series with places. The square of omega precedes all others."""
    return tuple(_placed(operation, places) for operation in sorted(linked.series, key=squares_omega, reverse=True))


def _placed(operation: OnSeries, places: _Places) -> OnSeries:
    """Return an operation on series with places.

    The terms of a sum are in the order in which their registers become available, so that it waits only for the last.
    """
    results = tuple(places.registers[name] for name in operation.results)
    registers = tuple(places.registers[name] for name in operation.registers)
    cells = tuple(places.cells[name] for name in operation.cells)
    if operation.kind == "lin":
        constant, *factors = cells
        in_order = sorted(zip(registers, factors, strict=True))
        registers = tuple(register for register, _ in in_order)
        cells = (constant, *(factor for _, factor in in_order))
    return OnSeries(operation.kind, results, registers, cells)


def _variables(definitions: Definitions, linked: Linked) -> tuple[int, int]:
    """Return the codes of `Program.autonomous` and of `Program.by_rotation`."""
    others = [operation for operation in linked.series if not squares_omega(operation)]
    squared = len(linked.series) - len(others)
    taken = {register for operation in others for register in operation.registers}
    tables = {table.kind for table in definitions.tables}
    kinds = tables.union(operation.kind for operation in others)
    alone = len(definitions.states) == 2
    still = "omega" not in taken
    autonomous = (alone and "x" not in taken) * (1 + (still and not squared and tables <= {"time"}))
    by_rotation = (alone and "x" in taken and still and kinds.isdisjoint(SHORT)) * (1 + squared)
    return autonomous, by_rotation


# Quantity that a law of one soil supplies, by the effect that takes it.
LAW_OF_EFFECT = {"soil_friction": "soil_mu", "softening_cohesion": "cohesion_law"}


def fragments_of(known: Mapping[str, Fragment], name: str, turns: bool) -> list[Fragment]:
    """Return the fragments of an effect or a law, of one soil if its name contains a number.

    The fragments ``known`` are shared by all soils, and ``turns`` is whether the mass rotates.

    The effect ``soil_friction#0`` includes the weight of its soil.
    """
    shared_name, mark, soil = name.partition(OF_SOIL)
    if not mark:
        return [known[name]]
    number = mark + soil
    own = _numbered(known, shared_name, number)
    if shared_name not in LAW_OF_EFFECT:  # a law, of which the effect takes the coefficient
        quantity = LAW_OF_EFFECT["softening_cohesion" if number.startswith(OF_COHESION) else "soil_friction"]
        return [own._replace(adds={quantity + number: own.adds["mu"]})]
    if shared_name == "softening_cohesion":
        return [own]
    weights = ["gravity", "rotation"] if turns else ["gravity"]
    return [own, *(_numbered(known, weight, number)._replace(adds={}, series=()) for weight in weights)]


def _numbered(known: Mapping[str, Fragment], shared_name: str, number: str) -> Fragment:
    """Return the shared fragment of a name with the names of one soil: ``dsoil_mu#0`` for the number ``#0``."""
    of_one_soil = set(LAW_OF_EFFECT.values())
    for effect in LAW_OF_EFFECT:
        of_one_soil.update(known[effect].inputs, (table for table, *_ in known[effect].tables))
    fragment = known[shared_name]
    tables = {table for table, *_ in fragment.tables}
    numbered = tables | _results(fragment)

    def of_soil(item: Any) -> Any:
        if isinstance(item, tuple):
            return tuple(map(of_soil, item))
        if not isinstance(item, str):
            return item
        quantity = item.removesuffix("_0").removeprefix("d")
        if quantity in of_one_soil:
            return item.replace(quantity, quantity + number)
        prefix, dot, cell = item.partition(".")
        if dot and prefix in {*tables, shared_name}:
            return f"{prefix}{number}.{cell}"
        return item + number if item in numbered else item

    return fragment._replace(
        inputs=of_soil(fragment.inputs),
        scalar=of_soil(fragment.scalar),
        series=of_soil(fragment.series),
        adds={quantity: of_soil(added) for quantity, added in fragment.adds.items()},
        tables=of_soil(fragment.tables),
    )


def _results(fragment: Fragment) -> set[str]:
    """Return the names of the cells and registers that a fragment computes. A table of time supplies its argument."""
    results = {operation[1] for operation in fragment.scalar}
    for _, names, *_ in fragment.series:
        results.update(names)
    for _, kind, argument, _ in fragment.tables:
        if kind == "time":
            results.add(argument)
    return results


def integers_of(program: Program) -> list[int]:
    """Return the integers that describe a program to the C integrator.

    They are its sizes, roles, operations on cells, operations on series, states and tables, in this order.
    """
    series, later = ([*chain.from_iterable(map(encoded, operations))] for operations in program.split)
    scalar = list[int]()
    for kind, *names in program.scalar:
        scalar += [SCALAR[kind], *names]
    sizes = [
        len(program.cells),
        program.given,  # inputs; at the start a lane needs no other cells except constants
        len(program.registers),
        len(program.states),
        len(program.tables),
        len(scalar),
        len(series),
        len(later),
        int(program.autonomous),
        program.by_rotation,
    ]
    places = {name: program.roles.get(name, -1) for name in ROLES}
    roles = [place if name.startswith("cell_") else _begin(place) for name, place in places.items()]
    integers = [*sizes, *roles, *scalar, *series, *later]
    for cell, register, rate in program.states:
        integers += [cell, _begin(register), _begin(rate)]
    for table in program.tables:
        integers += [KINDS.index(table.kind), _begin(table.register), table.cells, table.degree]
    return integers


def _begin(register: int) -> int:
    """Return the index of the first coefficient of a register in the array of all coefficients, -1 without a register.

    ``register`` is its number in the program, negative if the program does not have it.
    """
    return -1 if register < 0 else register * STRIDE


def encoded(operation: OnSeries) -> list[Any]:
    """Return an operation on series as integers. A sum also contains the number of its terms."""
    kind, results, registers, cells = operation
    count = [len(registers)] if kind == "lin" else []
    return [SERIES[kind], *count, *map(_begin, (*results, *registers)), *cells]
