"""Derivatives of the numbers and tables of a program by each number of a scene.

`slipcircle.core.problem.numbers` makes them dimensionless, here as complex numbers with derivatives in their imaginary
parts.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from generated.effects import EFFECTS
from slipcircle.base.kinds import Floats, Parameters
from slipcircle.core.problem.lanes import Lanes
from slipcircle.core.problem.numbers import Numbers
from slipcircle.core.program.program import Table
from slipcircle.core.scene.effects import symbols_of
from slipcircle.core.scene.friction import law_parts, law_paths, number_name
from slipcircle.core.scene.piecewise import Data, continuous
from slipcircle.derivatives.complex_step import derivative, with_parts
from slipcircle.derivatives.geometry_derivatives import Directions, arc_with_derivatives, relative_derivative
from slipcircle.derivatives.tangents import InputGrowth, TableGrowth
from slipcircle.layers.layers import LayeredSection
from slipcircle.layers.strength import OfRotation
from slipcircle.tables.forcing import factor
from slipcircle.tables.interpolation import in_pieces
from slipcircle.tables.series import Series


class InputDerivatives(Directions):
    """Derivatives of the numbers of a program by each parameter of the scene.

    Attributes
    ----------
    inputs : dict of ndarray
        By name of a cell.
    omega : ndarray
        Of omega* at the start.
    speed_growth, radius_growth : ndarray
        Relative derivatives of the units sqrt(R g) and R.
    growth : InputGrowth
        Of the unit of time, the end time and the tables.
    """

    def __init__(self, lanes: Lanes, names: Sequence[str]) -> None:
        super().__init__(names)
        self.lanes = lanes
        self.arc = arc_with_derivatives(lanes.arc, self)  # type: ignore[arg-type]
        numbers = self._numbers()
        terms: dict[str, Any] = {}
        if isinstance(lanes.arc, LayeredSection):
            terms = self._terms_of_soils()
        self.inputs = {name: self._derivative(value) for name, value in numbers.inputs.items()}
        for symbol, term in terms.items():
            if not isinstance(term, OfRotation):
                self.inputs[symbol] = self._derivative(term)
        tables = self._tables(numbers)
        functions = {symbol: term for symbol, term in terms.items() if isinstance(term, OfRotation)}
        if functions:
            tables |= self._functions_of_rotation(functions)
        self.speed_growth = self._growth(numbers.speed)
        self.radius_growth = self._growth(numbers.radius)
        unit_of_time = float(lanes.time_scale)
        end_dot = self.one("end_time") / unit_of_time
        self.growth = InputGrowth(self._growth(numbers.time_scale), end_dot, tables)
        velocity = self.stepped("initial_velocity", lanes.velocity)
        self.omega = derivative(velocity / numbers.speed)

    def _derivative(self, value: Any) -> Floats:
        """Derivatives by each parameter."""
        return derivative(value) + self.none

    def _growth(self, value: Any) -> Floats:
        """Relative derivatives by each parameter."""
        return relative_derivative(value) + self.none

    def _numbers(self) -> Numbers:
        """Complex numbers and tables of the effects and laws of the scene."""
        numbers = Numbers(self.arc)
        for effect, parameters in self.lanes.called.items():
            if effect in EFFECTS:
                stepped = self._stepped_parameters(effect, parameters)
                if isinstance(parameters.get("horizontal"), Series):
                    stepped = self._stepped_record(parameters)
                numbers.add_effect(effect, stepped)
        friction = self.lanes.friction
        of_soils = isinstance(self.lanes.arc, LayeredSection)
        if of_soils:
            friction = self.arc.friction  # of which the numbers are complex
        paths = law_paths(friction)
        for path, (law, parameters) in zip(paths, law_parts(friction), strict=True):
            if not of_soils:
                parameters = self._stepped_parameters(path, parameters)
            numbers.add_law(law, parameters)
        return numbers

    def _stepped_parameters(self, path: str, parameters: Parameters) -> Parameters:
        """The parameters of an effect or a law, with complex numbers for those of the scene's numbers."""
        stepped = dict(parameters)
        for name, value in parameters.items():
            number = number_name(path, name)
            if number in self.names:
                stepped[name] = self.stepped(number, value)
        return stepped

    def _stepped_record(self, shaking: Parameters) -> Parameters:
        """Shaking by a record. Its scale and its peak are both parameters: the peak is the scale times its maximum."""
        others = {name: value for name, value in shaking.items() if name != "peak"}
        greatest = shaking["horizontal"].greatest or 1.0
        by_peak = self.one("shaking.peak") / greatest
        scale = factor("shaking", shaking, "horizontal")
        stepped_scale = with_parts(scale, self.one("shaking.scale") + by_peak)
        return others | {"scale": stepped_scale}

    def _terms_of_soils(self) -> dict[str, Any]:
        """What the soils add to the balance, with derivatives, by symbols of the program."""
        called = {}
        for effect, parameters in self.lanes.called.items():
            if effect in EFFECTS:
                called[effect] = parameters
        complete = self.arc.effects_with_own(called, complete=True)
        terms = {}
        for effect, added in complete.items():
            if effect in EFFECTS:
                continue
            symbols = symbols_of(effect)
            for name, term in added.items():
                symbol = symbols[name]
                terms[symbol] = term
        return terms

    # --- tables ------------------------------------------------------------------------------------------------------

    def _tables(self, numbers: Numbers) -> dict[str, TableGrowth]:
        """Derivatives of the scales, factors and values of the program's tables."""
        growths = dict[str, TableGrowth]()
        for slot in self.lanes.problem.program.tables:
            factor = numbers.inputs.get(f"{slot.name}.SCALED_BY")
            if factor is None:
                continue  # a function of the rotation that the soils add
            scale = numbers.inputs.get(f"{slot.name}.SCALE", 1.0)
            data = numbers.tables.get(slot.name, continuous(np.zeros(1), np.zeros((1, 1))))
            growths[slot.name] = TableGrowth(self._growth(scale), self._growth(factor), self._by_parameter(slot, data))
        return growths

    def _by_parameter(self, slot: Table, data: Data) -> list[Data] | None:
        """Derivatives of a table's values by each parameter; None of a table that is no function of them."""
        if slot.kind == "rotation":
            return self._in_pieces_of(slot.name, self._pressures)
        if not np.iscomplexobj(data.coefficients):
            return None
        slopes = derivative(data.coefficients)
        return [data._replace(coefficients=slopes[..., k]) for k in range(len(self.names))]

    def _pressures(self, rotation: Floats) -> Floats:
        """Derivatives of a section's mean water pressure by each parameter, (parameters, M, 1) at rotations (M, 1)."""
        shape = (len(rotation), len(self.names))
        every_parameter = np.broadcast_to(rotation, shape)
        slopes = np.asarray(self.arc.pressure(every_parameter))
        return slopes.T[..., None]

    def _functions_of_rotation(self, functions: Mapping[str, OfRotation]) -> dict[str, TableGrowth]:
        """Derivatives of functions of the rotation, in the pieces of their tables."""
        strength = self.arc.arc_strength
        count = len(self.names)
        parts_of_functions = set[str]()
        for function in functions.values():
            parts_of_functions.update(function.coefficients)

        def values(rotation: Floats) -> Floats:
            shape = (len(rotation), count)
            every_lane = np.broadcast_to(rotation, shape)
            parts = strength.parts(every_lane, parts_of_functions)
            rows = []
            for function in functions.values():
                slopes = derivative(function.combined(parts))
                rows.append(slopes.T[..., None])
            return np.concatenate(rows)

        first_table = next(iter(functions))
        every = self._in_pieces_of(first_table, values)
        growths = dict[str, TableGrowth]()
        for k, name in enumerate(functions):
            first = k * count
            by_parameter = every[first : first + count]
            growths[name] = TableGrowth(self.none, self.none, by_parameter)
        return growths

    def _in_pieces_of(self, name: str, functions: Callable[[Floats], Floats]) -> list[Data]:
        """Functions of the rotation, (functions, M, 1) of (M, 1), as tables in the pieces of one that there is."""
        problem = self.lanes.problem
        names = [table.name for table in problem.program.tables]
        place = names.index(name)
        breaks = problem.tables[place].breaks
        coefficients = in_pieces(functions, breaks)
        tables = list[Data]()
        for of_function in np.moveaxis(coefficients, -1, 0):
            in_order = np.ascontiguousarray(of_function)
            tables.append(continuous(breaks, in_order))
        return tables
