"""The first pass of `build_program`: definitions, tables, inputs and states of a scene's effects and friction law.

Names that fragments share: ``q_0`` is quantity q of the balance where a phase begins, ``q_size`` the size of its terms,
``dq`` its increment since; ``t.VALUE`` is a cell of table t.
"""

from typing import Any, NamedTuple

from generated.flow import INPUTS, QUANTITIES
from generated.layout import TABLE
from slipcircle.base.kinds import Names
from slipcircle.core.program.fragments import fragment_of
from slipcircle.core.program.link import ONE, ZERO, Linker
from slipcircle.core.scene.effects import OF_SOIL, soil_number


class TableDeclaration(NamedTuple):
    """A piecewise function: its name, what it is of, the register of its argument, and the degree of its pieces."""

    name: str
    kind: str
    argument: str
    degree: int

    @property
    def coefficients(self) -> list[str]:
        """The cells of a piece's coefficients beyond its value."""
        powers = range(1, self.degree + 1)
        return [f"{self.name}.Q{k}" for k in powers]

    @property
    def cells(self) -> list[str]:
        """All its cells, in order; Q1, the last of `TABLE`, is the first coefficient."""
        before = [f"{self.name}.{cell}" for cell in TABLE[:-1]]
        return before + self.coefficients


class Declarations:
    """The definitions of a program, and what the fragments in `generated.flow` declare.

    Attributes
    ----------
    extra : tuple of str
        Registers that are computed in addition to those that the integrator reads.
    link : Linker
        The definitions of cells and registers.
    inputs : list of str
        Names of the numbers that a scene provides.
    tables : list of TableDeclaration
    states : dict of str
        Register of the rate of each state.
    factors : list of str
        Quantities whose product is the friction coefficient.
    """

    def __init__(self, extra: Names) -> None:
        self.extra = extra
        self.link = Linker()
        self.inputs: list[str] = []
        self.tables: list[TableDeclaration] = []
        self.sums: dict[str, list[Any]] = {}  # addends of each quantity: base, size, terms of its increment

    def declare_effects(self, effects: Names, moving: Names, absent: Names) -> None:
        """Take the definitions of gravity and of effects, for each soil also those of its rotating weight."""
        self._take("gravity")
        for effect in effects:
            self._take(effect, self.factors[0])
            for declared in fragment_of(effect).tables:
                table = TableDeclaration(*declared)
                self._effect_table(table, moving, absent)
            number = soil_number(effect)
            if not number:
                continue
            weight = fragment_of(f"gravity{number}")
            self.link.define_cells(weight.scalar)
            if "rotation" in effects:
                turning = fragment_of(f"rotation{number}")
                self.link.define_cells(turning.scalar)

    def _effect_table(self, table: TableDeclaration, moving: Names, absent: Names) -> None:
        """Declare an effect's table if the parameter is a function; otherwise it is a constant, or absent and zero."""
        if table.name in moving:
            self.tables.append(table)
            return
        for name in table.coefficients:
            self.link.cell_definitions[name] = ("set", ZERO)
        if table.name not in absent:
            self.inputs.append(table.name)

    def declare_laws(self, laws: Names) -> None:
        """Take the definitions of the friction law, or of two whose coefficients are factors of friction.

        The first factor may be a sum over soils.
        """
        of_soils = [law for law in laws if OF_SOIL in law]
        shared = [law for law in laws if law not in of_soils]
        laws_of_slip = 0 if of_soils else 1  # among the shared ones
        has_rate = len(shared) > laws_of_slip
        self.factors = ["slip_mu", "rate_mu"] if has_rate else ["mu"]
        for law in of_soils:
            number = soil_number(law)
            self._take_law(law, f"soil_mu{number}")
        last_factors = self.factors[-len(shared) :]
        for law, factor in zip(shared, last_factors, strict=False):
            self._take_law(law, factor)
        if of_soils:
            self._take("soils")
        if has_rate:
            self._take("product")

    def _take_law(self, law: str, coefficient: str) -> None:
        """Take a law's definitions, which add to a friction coefficient, and its tables."""
        self._take(law, coefficient)
        for declared in fragment_of(law).tables:
            table = TableDeclaration(*declared)
            self.tables.append(table)

    def declare_functions_of_time(self, moving: Names) -> None:
        """Define parameters that change with time: the value where the phase begins plus an increment, a ramp."""
        known = {table.name for table in self.tables}
        link = self.link
        for symbol in moving:
            link.cell_definitions[symbol] = ("set", f"{symbol}.VALUE")
            if symbol not in known:
                of_time = TableDeclaration(symbol, "time", f"d{symbol}", 0)
                self.tables.append(of_time)
        for table in self.tables:
            increment = table.argument
            if table.kind == "time":
                link.series_definitions[increment] = ("ramp", increment, table.name)

    def declare_balance(self, effects: Names, laws: Names, extra: Names, absent: Names) -> None:
        """Take the balance of momentum, sum the terms of its quantities, and collect the inputs and states."""
        for name in ("balance", *extra):
            self._take(name)
        link = self.link
        not_shaken = () if "shaking" in effects else ("k_h", "k_v")
        for symbol in (*absent, *not_shaken):
            link.cell_definitions[symbol] = ("set", ZERO)
        quantities = (*QUANTITIES, "mu", *self.sums)
        for quantity in dict.fromkeys(quantities):
            self._sum(quantity)
        if self.factors == ["mu"]:  # without a law of speed the factor that depends on slip is the coefficient
            link.cell_definitions["slip_mu_0"] = ("set", "mu_0")
            terms = ((ONE, "dmu"),)
            link.series_definitions["dslip_mu"] = ("lin", "dslip_mu", "", terms)
        fragments = ("gravity", *effects, *laws, *extra)
        self._collect_inputs(fragments)

    def _collect_inputs(self, names: Names) -> None:
        """Collect the numbers that a scene provides, and the states with their rates."""
        defined = self.link.cell_definitions
        self.inputs = [*INPUTS, *self.inputs]
        self.states = {"x": "omega", "omega": "net"}
        for name in names:
            fragment = fragment_of(name)
            for symbol in fragment.inputs:
                if symbol not in defined:
                    self.inputs.append(symbol)
            self.states.update(fragment.states)

    def _take(self, name: str, friction: str = "mu") -> None:
        """Take a fragment's definitions; ``friction`` is the quantity to which it adds a friction coefficient.

        That is ``mu``, the coefficient of one soil, or one of two factors.
        """
        fragment = fragment_of(name)
        self.link.define_cells(fragment.scalar)
        self.link.define_series(fragment.series)
        for quantity, added in fragment.adds.items():
            if quantity == "mu":
                quantity = friction
            addends = self.sums.setdefault(quantity, [])
            addends.append(added)

    def _sum(self, quantity: str) -> None:
        """Define a quantity of the balance: initial value, size of its terms, and increment."""
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
        """Define a cell as the sum of others, added in their order."""
        definitions = self.link.cell_definitions
        total = ZERO
        for k, addend in enumerate(addends):
            part = f"{name}.{k}"
            definitions[part] = ("add", total, addend)
            total = part
        definitions[name] = ("set", total)
