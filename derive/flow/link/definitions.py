"""Definitions of cells and registers by name, from fragments of effects and laws, and the sums of the balance.

Fragments share these names: ``q_0`` is quantity q of the balance at the beginning of a phase, ``q_size`` the size of
its terms, ``dq`` its increment since the beginning, ``t.VALUE`` a cell of table t, and ``=1.0`` a constant.
"""

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from derive.flow.fragments import INPUTS, QUANTITIES
from derive.flow.layout import TABLE
from derive.flow.lowering import Fragment, OnSeries

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
